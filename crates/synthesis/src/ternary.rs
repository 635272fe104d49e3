//! Polynomials whose coefficients are −1, 0 and 1, all coefficients in two words.
//!
//! A ratio of a gearbox of simple sets is a quotient of two polynomials in the ring-to-sun ratios `k₁ … kₙ`.
//! Each polynomial is of at most the first degree in each `kᵢ`. The coefficients are signed counts of
//! spanning trees. Each count is at most one, so they are −1, 0 or 1. Bit `S` of a word represents the
//! product of the `kᵢ` whose bit is in `S`.
//!
//! Coefficients are added and multiplied modulo 3, all `2ⁿ` at once by a few operations on whole words. Where
//! the result is known to be −1, 0 or 1, this is exact, whatever the terms between were.

use std::ops::{BitAnd, BitOr, BitXor, Not};

/// A word with a bit for each product of ring-to-sun ratios.
pub trait Word:
    Copy
    + Default
    + Eq
    + std::hash::Hash
    + BitAnd<Output = Self>
    + BitOr<Output = Self>
    + BitXor<Output = Self>
    + Not<Output = Self>
    + Into<u64>
{
    /// The word with one bit.
    fn bit(place: usize) -> Self;
}

macro_rules! word {
    ($($word:ty)*) => {$(
        impl Word for $word {
            fn bit(place: usize) -> Self {
                1 << place
            }
        }
    )*};
}
word!(u8 u16 u32 u64);

/// Coefficients −1, 0 and 1, one for each bit of `W`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
pub struct Ternary<W> {
    /// Bits of the coefficients 1.
    pub plus: W,
    /// Bits of the coefficients −1.
    pub minus: W,
}

impl<W: Word> Ternary<W> {
    /// The sum, modulo 3.
    #[inline]
    #[must_use]
    pub fn sum(self, other: Self) -> Self {
        let mixed = (self.plus | other.minus) ^ (self.minus | other.plus);
        Self { plus: (self.minus | other.minus) ^ mixed, minus: (self.plus | other.plus) ^ mixed }
    }

    /// The difference, modulo 3.
    #[inline]
    #[must_use]
    pub fn difference(self, other: Self) -> Self {
        self.sum(other.negated())
    }

    /// The products of the coefficients, place by place.
    #[inline]
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        Self {
            plus: (self.plus & other.plus) | (self.minus & other.minus),
            minus: (self.plus & other.minus) | (self.minus & other.plus),
        }
    }

    /// Polynomial with every sign changed.
    #[inline]
    #[must_use]
    pub fn negated(self) -> Self {
        Self { plus: self.minus, minus: self.plus }
    }

    /// Whether all coefficients are 0.
    #[must_use]
    pub fn is_zero(self) -> bool {
        self.plus | self.minus == W::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(number: i32) -> Ternary<u8> {
        Ternary { plus: u8::from(number == 1), minus: u8::from(number == -1) }
    }

    #[test]
    fn sums_and_products_are_those_modulo_three() {
        for one in -1..=1 {
            for other in -1..=1 {
                let modulo = |number: i32| of((number + 4).rem_euclid(3) - 1);
                assert_eq!(of(one).sum(of(other)), modulo(one + other), "{one} + {other}");
                assert_eq!(of(one).difference(of(other)), modulo(one - other), "{one} − {other}");
                assert_eq!(of(one).times(of(other)), modulo(one * other), "{one} · {other}");
            }
        }
    }
}

//! Sets with equal ring-to-sun ratios.
//!
//! # Formula
//! Where the `k` of `m` sets are one number `t`, a polynomial of the first degree in each `k` is of degree
//! `m` in `t`. Its mean over all exchanges of these sets, the *polar form*
//!
//! ```text
//! P̄(k_1 … k_m) = 1/m! · Σ_π P(k_π1 … k_πm)         P̄(t … t) = P(t … t)
//! ```
//!
//! has the same values there and is of the first degree in each `k` as well. So over a range of `t`, the same
//! for each of these sets, its extremes are at the corners. With `j` of the `m` at the upper end they are the
//! coefficients of `P(t … t)` by Bernstein, whose hull holds all its values. All statements on boxes and
//! corners hold with the polar forms in place of the polynomials, in boxes whose sets with equal `k` have one
//! range.

use crate::class::MOST_SETS;
use crate::parts::{Grid, Parts};
use crate::ratio::{Polynomial, Ratio};
use crate::ternary::{Ternary, Word};
use std::collections::BTreeMap;

/// Sets of one kind whose `k` are equal.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Equal(usize);

impl FromIterator<usize> for Equal {
    /// The sets at these places.
    fn from_iter<I: IntoIterator<Item = usize>>(places: I) -> Self {
        Self(places.into_iter().fold(0, |all, place| all | 1 << place))
    }
}

impl Equal {
    /// No sets: each `k` is free.
    pub const NONE: Self = Self(0);

    /// Choices of `count` sets of one kind, if the last `double_planets` of all sets are double-planet sets.
    /// A `count` of 0 or 1 requires no equal sets.
    #[must_use]
    pub fn choices(count: usize, sets: usize, double_planets: usize) -> Vec<Self> {
        if count <= 1 {
            return vec![Self::NONE];
        }
        let simple = (1usize << (sets - double_planets)) - 1;
        (1usize..1 << sets)
            .filter(|chosen| chosen.count_ones() as usize == count)
            .filter(|chosen| chosen & simple == 0 || chosen & !simple == 0)
            .map(Self)
            .collect()
    }

    /// The places of the sets.
    pub fn sets(self) -> impl Iterator<Item = usize> {
        (0..usize::BITS as usize).filter(move |place| self.contains(*place))
    }

    /// Whether the set at a place is one of them.
    #[must_use]
    pub const fn contains(self, place: usize) -> bool {
        self.0 >> place & 1 == 1
    }

    /// The ratios `k_i/k_1` of each of them but the first to the first, which are 1.
    #[must_use]
    pub fn ratios(self) -> Vec<Ratio> {
        let of = |set: usize| Polynomial { plus: 1 << (1 << set), minus: 0 };
        let others = self.sets().filter(|set| self.follows(*set));
        others.map(|set| Ratio { numerator: of(set), denominator: of(self.first_of(set)) }).collect()
    }

    /// The first of them for each of them; any other set for itself.
    pub(crate) const fn first_of(self, place: usize) -> usize {
        if self.contains(place) { self.0.trailing_zeros() as usize } else { place }
    }

    /// Whether the set is one of them, but not the first.
    pub(crate) const fn follows(self, place: usize) -> bool {
        self.first_of(place) != place
    }

    /// Gives a set a value, and with it those that are equal to it.
    pub(crate) fn put<T: Copy>(self, values: &mut [T], place: usize, value: T) {
        values[place] = value;
        if self.contains(place) {
            self.sets().for_each(|set| values[set] = value);
        }
    }

    /// Gives all of them the value of the first.
    pub(crate) fn spread<T: Copy>(self, values: &mut [T]) {
        if self != Self::NONE {
            let first = self.0.trailing_zeros() as usize;
            self.put(values, first, values[first]);
        }
    }

    /// Adds up the slopes of all these sets at the first of them: slopes along the common `k`.
    pub(crate) fn gather(self, slopes: &mut [f64]) {
        for set in self.sets().filter(|set| self.follows(*set)) {
            slopes[self.first_of(set)] += slopes[set];
            slopes[set] = 0.0;
        }
    }

    /// Turns the coefficients of a polynomial into those of its polar form.
    pub(crate) fn polar(self, coefficients: &mut [f64]) {
        if self == Self::NONE {
            return;
        }
        let means: Vec<f64> = (0..coefficients.len())
            .map(|product| {
                let alike = (0..coefficients.len()).filter(|other| self.are_exchanged(product, *other));
                alike.clone().map(|other| coefficients[other]).sum::<f64>() / alike.count() as f64
            })
            .collect();
        coefficients.copy_from_slice(&means);
    }

    /// Whether two ratios are one wherever these `k` are equal: `P₁·Q₂ − P₂·Q₁` has no term left once equal
    /// `k` are one.
    pub(crate) fn makes_equal(self, one: Ratio, other: Ratio) -> bool {
        let mut terms: BTreeMap<[u32; MOST_SETS], i32> = BTreeMap::new();
        let mut add = |above: Polynomial, below: Polynomial, sign: i32| {
            let coefficients =
                |of: Polynomial| (0..64).map(move |product| (product, i32::from(of.coefficient(product))));
            for (one, first) in coefficients(above).filter(|(_, factor)| *factor != 0) {
                for (other, second) in coefficients(below).filter(|(_, factor)| *factor != 0) {
                    let mut powers = [0; MOST_SETS];
                    for set in 0..MOST_SETS {
                        powers[self.first_of(set)] += (one >> set & 1) as u32 + (other >> set & 1) as u32;
                    }
                    *terms.entry(powers).or_default() += sign * first * second;
                }
            }
        };
        add(one.numerator, other.denominator, 1);
        add(other.numerator, one.denominator, -1);
        terms.values().all(|factor| *factor == 0)
    }

    /// Whether an exchange of these sets turns a product of `k` into another.
    const fn are_exchanged(self, one: usize, other: usize) -> bool {
        one & !self.0 == other & !self.0 && (one & self.0).count_ones() == (other & self.0).count_ones()
    }

    /// Whether a polynomial is 0 wherever these `k` are equal.
    pub(crate) fn vanishes<W: Word>(self, polynomial: Ternary<W>) -> bool {
        let (plus, minus): (u64, u64) = (polynomial.plus.into(), polynomial.minus.into());
        let products = || (0..u64::BITS as usize).filter(|product| (plus | minus) >> product & 1 == 1);
        products().all(|product| {
            let alike = products().filter(|other| self.are_exchanged(product, *other));
            alike.map(|other| (plus >> other & 1) as i32 - (minus >> other & 1) as i32).sum::<i32>() == 0
        })
    }

    /// The parts of a range that hold points with these `k` equal: those where all these sets, whose ranges
    /// are the same, have the same part of it. A point between two parts is in one of them.
    pub(crate) fn parts(self, grid: &Grid) -> Parts {
        let strides = grid.strides();
        let cut = |part: usize, set: usize| part / strides[set].0 % strides[set].1;
        let holds = |part: &usize| self.sets().all(|set| cut(*part, set) == cut(*part, self.first_of(set)));
        (0..grid.count()).filter(holds).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parts::{coefficients, corner_values};

    #[test]
    fn choices_are_of_one_kind() {
        assert_eq!(Equal::choices(1, 3, 0), [Equal::NONE]);
        let of = |places: &[usize]| places.iter().copied().collect::<Equal>();
        assert_eq!(Equal::choices(2, 3, 0), [of(&[0, 1]), of(&[0, 2]), of(&[1, 2])]);
        assert_eq!(Equal::choices(2, 4, 2), [of(&[0, 1]), of(&[2, 3])]);
        assert!(Equal::choices(2, 2, 1).is_empty());
    }

    #[test]
    fn polar_forms_have_the_same_values_and_bound_them_at_corners() {
        // 1 + k₁ − k₁·k₂ + k₂·k₃ − k₁·k₂·k₃ + k₄·k₁.
        let polynomial = Polynomial { plus: 0b10_0100_0011, minus: 0b1000_1000 };
        for equal in [&[0, 1][..], &[0, 2], &[0, 1, 2], &[0, 1, 2, 3]] {
            let equal: Equal = equal.iter().copied().collect();
            let plain = coefficients(polynomial, 4);
            let mut polar = plain.clone();
            equal.polar(&mut polar);
            let mut values = Vec::new();
            let cuboid: Vec<[f64; 2]> =
                (0..4).map(|set| if equal.contains(set) { [1.5, 2.5] } else { [2.0, 3.0] }).collect();
            corner_values(&polar, &cuboid, &mut values);
            let hull = values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], value| {
                [least.min(*value), most.max(*value)]
            });
            for step in 0..=20 {
                let part = f64::from(step) / 20.0;
                let k: Vec<f64> = cuboid.iter().map(|[least, most]| least + part * (most - least)).collect();
                let term = |product: usize| {
                    (0..4).filter(|set| product >> set & 1 == 1).map(|set| k[set]).product::<f64>()
                };
                let value: f64 =
                    polar.iter().enumerate().map(|(product, factor)| factor * term(product)).sum();
                assert!((value - polynomial.value(&k)).abs() < 1e-12);
                assert!((hull[0] - 1e-12..=hull[1] + 1e-12).contains(&value));
            }
        }
    }

    #[test]
    fn ratios_that_become_one_are_known() {
        let ratio = |above: (u64, u64), below: (u64, u64)| Ratio {
            numerator: Polynomial { plus: above.0, minus: above.1 },
            denominator: Polynomial { plus: below.0, minus: below.1 },
        };
        // (1 + k₁)/k₂, (1 + k₂)/k₁ and (k₁ + k₁·k₂)/(k₁·k₂).
        let (one, other) = (ratio((0b11, 0), (0b100, 0)), ratio((0b101, 0), (0b10, 0)));
        let third = ratio((0b1010, 0), (0b1000, 0));
        let first_two: Equal = [0, 1].into_iter().collect();
        assert!(first_two.makes_equal(one, other) && !Equal::NONE.makes_equal(one, other));
        assert!(
            Equal::NONE.makes_equal(third, ratio((0b101, 0), (0b100, 0)))
                && first_two.makes_equal(one, third)
        );
        assert!(!first_two.makes_equal(one, ratio((0b11, 0), (0b1, 0))));
    }

    #[test]
    fn what_is_0_where_k_are_equal_is_known() {
        let first_two: Equal = [0, 1].into_iter().collect();
        // (k₁ − k₂)·(1 + k₃), and 1 − k₁·k₃.
        let difference = Polynomial { plus: 0b10_0010, minus: 0b100_0100 };
        assert!(first_two.vanishes(difference) && !Equal::NONE.vanishes(difference));
        assert!(!first_two.vanishes(Polynomial { plus: 1, minus: 0b10_0000 }));
        // k₁ − k₃ + k₁·k₂ − k₁·k₃ is no product, yet 0 where all are equal.
        let mixed = Polynomial { plus: 0b1010, minus: 0b11_0000 };
        assert!([0, 1, 2].into_iter().collect::<Equal>().vanishes(mixed) && !first_two.vanishes(mixed));
    }
}

//! Tooth counts.

use crate::Error;
use std::fmt;
use std::num::NonZeroU32;

/// Number of teeth of a gear, at least 1.
///
/// Internal gears have positive counts too: what is internal is said by
/// [`GearKind`](crate::geometry::GearKind), not by a sign. How many teeth a gear *should* have is for
/// [`crate::synthesis`]; the type only keeps a zero out of every denominator.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ToothCount(NonZeroU32);

impl ToothCount {
    /// A tooth count.
    ///
    /// # Errors
    /// [`Error::NoTeeth`] for 0.
    pub fn new(count: u32) -> Result<Self, Error> {
        NonZeroU32::new(count).map(Self).ok_or(Error::NoTeeth)
    }

    /// The count as an integer.
    #[must_use]
    pub const fn get(self) -> u32 {
        self.0.get()
    }

    /// Greatest common factor with the teeth of a mate. Where it is 1, every tooth meets every tooth of the
    /// mate (a hunting tooth); the same two teeth meet again after `z_mate/factor` turns.
    ///
    /// ```
    /// use epicyclic_gears::ToothCount;
    /// # fn main() -> Result<(), epicyclic_gears::Error> {
    /// assert_eq!(ToothCount::new(18)?.common_factor(ToothCount::new(36)?), 18);
    /// assert_eq!(ToothCount::new(24)?.common_factor(ToothCount::new(95)?), 1);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn common_factor(self, mate: Self) -> u32 {
        gcd(self.get().into(), mate.get().into()) as u32
    }

    /// The count as a factor.
    #[must_use]
    pub fn as_f64(self) -> f64 {
        f64::from(self.get())
    }
}

/// Greatest common divisor.
#[must_use]
pub fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

impl TryFrom<u32> for ToothCount {
    type Error = Error;

    fn try_from(count: u32) -> Result<Self, Error> {
        Self::new(count)
    }
}

impl fmt::Display for ToothCount {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_is_refused() {
        assert_eq!(ToothCount::new(0), Err(Error::NoTeeth));
        assert_eq!(ToothCount::new(12).unwrap().get(), 12);
    }
}

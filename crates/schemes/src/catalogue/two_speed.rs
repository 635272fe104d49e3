//! Schemes I, II, III: one set, one brake, direct drive.
//!
//! | scheme | `a₁ b₁ H₁` | `i` | `η` |
//! |---|---|---|---|
//! | I | D T₁ B | `1 + k₁` | `(1 + k₁·η₀)/(1 + k₁)` |
//! | II | T₁ D B | `(1 + k₁)/k₁` | `(k₁ + η₀)/(1 + k₁)` |
//! | III | D B T₁ | `−k₁` | `η₀` |
//!
//! They are lines of [`table`](super::table). The other three ways to use a set are these with D and B
//! exchanged; they speed up.
//!
//! # Source
//! multispeed-gearboxes (2.26)–(2.31).

use super::range::{RingToSunRange, limits};
use super::simple_set::{self, fraction, ratio_range};
use super::table::{ClosedForm, Line, TWO_SPEED};
use super::{Role, with_role};
use crate::Error;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::simple_set::{Mode, RingToSunRatio};
use std::fmt;
use std::str::FromStr;

/// A two-speed scheme.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum TwoSpeed {
    /// Sun drives, carrier is driven, ring braked.
    I,
    /// Ring drives, carrier is driven, sun braked.
    II,
    /// Sun drives, ring is driven, carrier braked.
    III,
}

impl TwoSpeed {
    /// Two-speed schemes of the catalogue, in the source's order.
    pub const ALL: [Self; 3] = [Self::I, Self::II, Self::III];

    fn line(self) -> &'static Line {
        &TWO_SPEED[self as usize]
    }

    /// The scheme whose set 1 has its members `[a, b, H]` at these links.
    #[must_use]
    pub fn of_set(set: [Role; 3]) -> Option<Self> {
        Self::ALL.into_iter().find(|scheme| scheme.set() == set)
    }

    /// Name as in the source.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.line().name
    }

    /// Links of `a₁`, `b₁`, `H₁`.
    #[must_use]
    pub fn set(self) -> [Role; 3] {
        self.line().sets[0]
    }

    /// Driving and driven member of the set.
    #[must_use]
    pub fn mode(self) -> Mode {
        let set = self.set();
        with_role(set, Role::D)
            .zip(with_role(set, Role::B))
            .and_then(|(input, output)| Mode::new(input, output).ok())
            .unwrap_or_else(|| unreachable!("D and B are different members of each, by test"))
    }

    /// Ratio as a formula in `k1`.
    #[must_use]
    pub fn ratio_formula(self) -> ClosedForm {
        self.line().ratio
    }

    /// Efficiency as a formula in `k1` and `eta0`.
    #[must_use]
    pub fn efficiency_formula(self) -> ClosedForm {
        self.line().efficiency
    }

    /// Ratio `i = ω_D/ω_B` with T₁ braked.
    #[must_use]
    pub fn ratio(self, k: RingToSunRatio) -> f64 {
        self.line().ratio.value(k.get(), f64::NAN, f64::NAN)
    }

    /// Sign of the ratio, whatever `k`.
    pub(crate) fn sign(self) -> f64 {
        fraction(self.mode(), 2.0)[0].signum()
    }

    /// Efficiency with T₁ braked, the set losing `1 − η₀` of its rolling power.
    #[must_use]
    pub fn efficiency(self, k: RingToSunRatio, eta0: MeshEfficiency) -> f64 {
        self.line().efficiency.value(k.get(), f64::NAN, eta0.get())
    }

    /// Ring-to-sun ratio for a ratio: `k = i − 1`, `1/(i − 1)`, `−i`.
    ///
    /// # Errors
    /// [`Error::RatioOutOfReach`] outside `i > 2` (I), `1 < i < 2` (II), `i < −1` (III), where a
    /// simple set would need `k ≤ 1`.
    pub fn ring_to_sun_ratio(self, ratio: f64) -> Result<RingToSunRatio, Error> {
        simple_set::ring_to_sun_ratio(self.mode(), ratio).map_err(|_| {
            let [low, high] = limits(|k| fraction(self.mode(), k));
            Error::RatioOutOfReach { scheme: format!("scheme {self}"), ratio, low, high }
        })
    }

    /// Ratios at the lower and at the upper end of a range of `k`.
    #[must_use]
    pub fn ratio_range(self, range: RingToSunRange) -> [f64; 2] {
        ratio_range(self.mode(), range)
    }
}

impl fmt::Display for TwoSpeed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for TwoSpeed {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self, Error> {
        Self::ALL.into_iter().find(|scheme| super::is_name(scheme.name(), name)).ok_or_else(|| {
            Error::UnknownScheme { name: name.into(), known: Self::ALL.map(Self::name).to_vec() }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn k(value: f64) -> RingToSunRatio {
        RingToSunRatio::new(value).unwrap()
    }

    #[test]
    fn the_conveyor_of_section_3_3() {
        let eta0 = MeshEfficiency::new(0.97).unwrap();
        assert!((TwoSpeed::I.ring_to_sun_ratio(3.94).unwrap().get() - 2.94).abs() < 1e-12);
        assert!((TwoSpeed::I.efficiency(k(2.94), eta0) - 0.977_614).abs() < 1e-6);
        assert!((TwoSpeed::III.ring_to_sun_ratio(-3.94).unwrap().get() - 3.94).abs() < 1e-12);
        assert_eq!(TwoSpeed::I.set(), [Role::D, Role::T1, Role::B]);
        assert_eq!(TwoSpeed::II.set(), [Role::T1, Role::D, Role::B]);
        assert_eq!(TwoSpeed::III.set(), [Role::D, Role::B, Role::T1]);
    }

    #[test]
    fn what_needs_a_ring_no_larger_than_the_sun_is_refused() {
        for (scheme, ratio) in [(TwoSpeed::I, 2.0), (TwoSpeed::II, 2.0), (TwoSpeed::III, 2.56)] {
            let refused = scheme.ring_to_sun_ratio(ratio);
            assert!(matches!(refused, Err(Error::RatioOutOfReach { .. })), "{scheme} {ratio}");
        }
        assert!("IV".parse::<TwoSpeed>().is_err());
        assert_eq!("III".parse(), Ok(TwoSpeed::III));
    }

    proptest! {
        #[test]
        fn closed_forms_equal_the_solver(value in 1.3..10.0, eta in 0.9..=1.0_f64) {
            let eta0 = MeshEfficiency::new(eta).unwrap();
            for scheme in TwoSpeed::ALL {
                let gearbox = scheme.gearbox(k(value), eta0).unwrap();
                let gear = gearbox.analyze("1").unwrap();
                let ratio = scheme.ratio(k(value));
                prop_assert!((gear.ratio().unwrap() - ratio).abs() <= 1e-12 * ratio.abs());
                prop_assert!((gear.efficiency().unwrap() - scheme.efficiency(k(value), eta0)).abs() < 1e-12);
                prop_assert!((scheme.ring_to_sun_ratio(ratio).unwrap().get() - value).abs() < 1e-12 * value * value);
                prop_assert_eq!(gearbox.analyze("direct").unwrap().ratio(), Some(1.0));
            }
        }
    }
}

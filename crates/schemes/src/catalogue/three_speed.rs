//! Schemes I-1…III-3: a second set that ties T₁ to D or to B when T₂ is braked.
//!
//! | scheme | `a₁ b₁ H₁` | `a₂ b₂ H₂` | `i₂` |
//! |---|---|---|---|
//! | I-1 | D T₁ B | D T₂ T₁ | `(k₁+1)(k₂+1)/(k₁+k₂+1)` |
//! | I-2 | D T₁ B | T₂ D T₁ | `(k₁+1)(k₂+1)/(k₂(k₁+1)+1)` |
//! | I-3 | D T₁ B | B T₁ T₂ | `(k₂(k₁+1)+k₁)/k₂` |
//! | I-4 | D T₁ B | T₁ B T₂ | `k₁(k₂+1)+1` |
//! | II-1 | T₁ D B | D T₂ T₁ | `(k₁+1)(k₂+1)/(k₁(k₂+1)+1)` |
//! | II-2 | T₁ D B | T₂ D T₁ | `(k₁+1)(k₂+1)/((k₁+1)(k₂+1)−1)` |
//! | II-3 | T₁ D B | T₁ B T₂ | `(k₁+k₂+1)/k₁` |
//! | II-4 | T₁ D B | B T₁ T₂ | `(k₂(k₁+1)+1)/(k₁k₂)` |
//! | III-1 | D B T₁ | D T₁ T₂ | `−k₁k₂/(k₁+k₂+1)` |
//! | III-2 | D B T₁ | T₁ B T₂ | `−(k₁(k₂+1)+k₂)` |
//! | III-3 | D B T₁ | B T₁ T₂ | `−(k₁(k₂+1)+1)/k₂` |
//!
//! They are lines of [`table`](super::table), which also says where they depart from the print.
//!
//! # Source
//! multispeed-gearboxes (2.39)–(2.61).

use super::table::{ClosedForm, Line, THREE_SPEED};
use super::{Role, TwoSpeed};
use crate::Error;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::simple_set::RingToSunRatio;
use std::fmt;
use std::str::FromStr;

/// A three-speed scheme of the source.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[allow(missing_docs, reason = "the table of the module says which is which")]
pub enum ThreeSpeed {
    I1,
    I2,
    I3,
    I4,
    II1,
    II2,
    II3,
    II4,
    III1,
    III2,
    III3,
}

impl ThreeSpeed {
    /// Three-speed schemes of the catalogue, eleven in the source's order.
    pub const ALL: [Self; 11] = [
        Self::I1,
        Self::I2,
        Self::I3,
        Self::I4,
        Self::II1,
        Self::II2,
        Self::II3,
        Self::II4,
        Self::III1,
        Self::III2,
        Self::III3,
    ];

    fn line(self) -> &'static Line {
        &THREE_SPEED[self as usize]
    }

    /// Name as in the source.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.line().name
    }

    /// Scheme of gear 1, in which set 1 works alone.
    #[must_use]
    pub fn first_stage(self) -> TwoSpeed {
        TwoSpeed::of_set(self.sets()[0])
            .unwrap_or_else(|| unreachable!("set 1 of each is I, II or III, by test"))
    }

    /// Links of `a b H` of sets 1 and 2.
    #[must_use]
    pub fn sets(self) -> [[Role; 3]; 2] {
        [self.line().sets[0], self.line().sets[1]]
    }

    /// Ratio of gear 2 as a formula in `k1` and `k2`.
    #[must_use]
    pub fn ratio_formula(self) -> ClosedForm {
        self.line().ratio
    }

    /// Efficiency of gear 2 as a formula in `k1`, `k2` and `eta0`.
    #[must_use]
    pub fn efficiency_formula(self) -> ClosedForm {
        self.line().efficiency
    }

    /// Ratio `i₂ = ω_D/ω_B` with T₂ braked.
    #[must_use]
    pub fn ratio(self, k1: RingToSunRatio, k2: RingToSunRatio) -> f64 {
        self.line().ratio.value(k1.get(), k2.get(), f64::NAN)
    }

    /// Efficiency with T₂ braked, each set losing `1 − η₀` of its rolling power.
    #[must_use]
    pub fn efficiency(self, k1: RingToSunRatio, k2: RingToSunRatio, eta0: MeshEfficiency) -> f64 {
        self.line().efficiency.value(k1.get(), k2.get(), eta0.get())
    }
}

impl fmt::Display for ThreeSpeed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for ThreeSpeed {
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
    use crate::catalogue::RingToSunRange;
    use proptest::prelude::*;

    fn k(value: f64) -> RingToSunRatio {
        RingToSunRatio::new(value).unwrap()
    }

    #[test]
    fn the_excavator_wheel_of_section_3_3() {
        let k2 = ThreeSpeed::II3.second_ring_to_sun_ratio(k(2.15), 2.56).unwrap();
        assert!((k2.get() - 2.354).abs() < 1e-12);
        let k2 = ThreeSpeed::III1.second_ring_to_sun_ratio(k(2.56), -1.465).unwrap();
        assert!((k2.get() - 1.465 * 3.56 / 1.095).abs() < 1e-12);
    }

    #[test]
    fn a_ratio_out_of_reach_says_what_is_in_reach() {
        // With k₁ = 1.56 scheme I-1 gives (k₁+1)·2/(k₁+2) to k₁+1: 1.465 is not among them.
        let refused = ThreeSpeed::I1.second_ring_to_sun_ratio(k(1.56), 1.4);
        let Err(Error::RatioOutOfReach { low, high, .. }) = refused else { panic!("{refused:?}") };
        assert!((low - 2.56 * 2.0 / 3.56).abs() < 1e-12 && (high - 2.56).abs() < 1e-12);
        assert!(ThreeSpeed::III1.second_ring_to_sun_ratio(k(2.0), f64::NAN).is_err());
    }

    proptest! {
        #[test]
        fn closed_forms_equal_the_solver(a in 1.3..10.0, b in 1.3..10.0, eta in 0.9..=1.0_f64) {
            let (k1, k2, eta0) = (k(a), k(b), MeshEfficiency::new(eta).unwrap());
            for scheme in ThreeSpeed::ALL {
                let gearbox = scheme.gearbox(k1, k2, eta0).unwrap();
                let gear = gearbox.analyze("2").unwrap();
                let ratio = scheme.ratio(k1, k2);
                prop_assert!((gear.ratio().unwrap() - ratio).abs() <= 1e-12 * ratio.abs(), "{}", scheme);
                let efficiency = scheme.efficiency(k1, k2, eta0);
                prop_assert!((gear.efficiency().unwrap() - efficiency).abs() < 1e-12, "{}", scheme);
                let first = gearbox.analyze("1").unwrap();
                let stage = scheme.first_stage();
                prop_assert!((first.ratio().unwrap() - stage.ratio(k1)).abs() <= 1e-12 * stage.ratio(k1).abs());
                prop_assert!((first.efficiency().unwrap() - stage.efficiency(k1, eta0)).abs() < 1e-12);
                prop_assert_eq!(gearbox.analyze("direct").unwrap().ratio(), Some(1.0));
            }
        }

        #[test]
        fn a_ratio_gives_its_ring_to_sun_ratio_back(a in 1.3..10.0, b in 1.3..10.0) {
            for scheme in ThreeSpeed::ALL {
                let found = scheme.second_ring_to_sun_ratio(k(a), scheme.ratio(k(a), k(b))).unwrap();
                prop_assert!((found.get() - b).abs() < 1e-10 * b, "{} {}", scheme, found.get());
            }
        }

        #[test]
        fn ranges_hold_every_ratio(a in 1.7..7.0, b in 1.7..7.0) {
            for scheme in ThreeSpeed::ALL {
                let [least, greatest] = scheme.ratio_range(RingToSunRange::USED);
                let ratio = scheme.ratio(k(a), k(b));
                prop_assert!(least - 1e-12 <= ratio && ratio <= greatest + 1e-12);
            }
        }
    }
}

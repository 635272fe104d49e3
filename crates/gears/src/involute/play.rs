//! Backlash of a mesh from tooth-thickness allowances and the centre-distance tolerance.
//!
//! A gear whose teeth are thinner by `E_sn`
//! equals one that was generated with the smaller shift `x_E` and kept its tips:
//!
//! ```text
//! x_E  = x + E_sn/(2·tan α_n)                                   E_sn below 0: thinner
//! j_wt = p_wt − s_w1 − s_w2                                     at the working circles
//! j_bn = j_wt·cos α_wt·cos β_b                                  grows by −(E_sn1 + E_sn2)·cos α_n
//! φ_1  = j_wt/r_w1                                              rotation of gear 1, its mate at rest
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `E_sns`, `E_sni` | upper, lower allowance of the normal tooth thickness, reference circle | modules |
//! | `A_as`, `A_ai` | upper and lower deviation of the centre distance | modules |
//! | `j_wt`, `j_bn` | circumferential backlash at the working circles, normal backlash | modules |
//! | `φ` | angle of rotation that the backlash allows | rad |
//!
//! Left out: play of bearings, pins, shafts and carrier, unequal planets.
//!
//! # Source
//! ISO 21771:2007 for names and signs; derived from the involute.

use super::gear::InvoluteGear;
use super::pair::Pair;
use crate::{Error, Quantity};

/// A pair of limits of a deviation from the nominal value, in modules; both 0 by default.
///
/// Of a tooth thickness the allowances `E_sni` and `E_sns`, below 0 of thinner teeth; of a centre distance
/// `A_ai` and `A_as`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Deviation {
    /// Lower limit.
    pub lower: f64,
    /// Upper limit.
    pub upper: f64,
}

impl Deviation {
    /// Refuses limits that are no numbers or in the wrong order.
    ///
    /// # Errors
    /// [`Error::Deviation`].
    pub fn check(&self, quantity: Quantity) -> Result<(), Error> {
        let &Self { lower, upper } = self;
        if lower.is_finite() && upper.is_finite() && lower <= upper {
            return Ok(());
        }
        Err(Error::Deviation { quantity, lower, upper })
    }
}

/// The play of a mesh; lengths in modules.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Play {
    /// Circumferential backlash at the working circles, `j_wt`; below 0 the flanks press into each other.
    pub circumferential: f64,
    /// Normal backlash `j_bn`: the shortest distance of the flanks.
    pub normal: f64,
    /// Angles by which each gear turns while its mate rests, rad.
    pub rotation_rad: [f64; 2],
}

impl InvoluteGear {
    /// The gear with teeth thinner by an allowance `E_sn` below 0, its tips where they were.
    ///
    /// Its span, its measure over balls and its root circle are those of the thinner teeth.
    ///
    /// # Errors
    /// [`Error::ShiftOutOfRange`] where it has no teeth left.
    pub fn with_thickness_allowance(self, allowance: f64) -> Result<Self, Error> {
        let less = allowance / (2.0 * self.tan_normal_angle());
        self.altered(self.shift() + less, self.tip_alteration() - less).checked()
    }
}

impl Pair {
    /// The play of the gears as they are.
    #[must_use]
    pub fn play(&self) -> Play {
        let circumferential = self.backlash();
        let base_helix = self.gears()[0].profile().base_helix_rad();
        Play {
            circumferential,
            normal: circumferential * libm::cos(self.working_angle_rad()) * libm::cos(base_helix),
            rotation_rad: self.working_diameters().map(|diameter| 2.0 * circumferential / diameter),
        }
    }

    /// Least and greatest play with allowances of both gears and a tolerance of the centre distance.
    ///
    /// # Errors
    /// Those of [`Deviation::check`]; [`Error::ShiftOutOfRange`], [`Error::NotAbove`] for allowances and
    /// deviations that leave no mesh.
    pub fn plays(&self, thickness: [Deviation; 2], centre_distance: Deviation) -> Result<[Play; 2], Error> {
        centre_distance.check(Quantity::CentreDistanceDeviation)?;
        for deviation in &thickness {
            deviation.check(Quantity::ThicknessAllowance)?;
        }
        // A ring further out comes nearer to its pinion.
        let Deviation { lower, upper } = centre_distance;
        let [near, far] = if self.is_internal() { [upper, lower] } else { [lower, upper] };
        let [upper, lower] = [thickness.map(|it| it.upper), thickness.map(|it| it.lower)];
        Ok([self.deviating(upper, near)?.play(), self.deviating(lower, far)?.play()])
    }

    /// The mesh of gears with thickness allowances at a centre distance that is off by so much, all in
    /// modules.
    ///
    /// # Errors
    /// [`Error::ShiftOutOfRange`], [`Error::NotAbove`] for allowances and deviations that leave no mesh.
    pub fn deviating(&self, allowances: [f64; 2], centre_distance: f64) -> Result<Self, Error> {
        let [first, second] = self.gears();
        Self::at_centre_distance(
            first.with_thickness_allowance(allowances[0])?,
            second.with_thickness_allowance(allowances[1])?,
            self.centre_distance() + centre_distance,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ToothCount;
    use crate::involute::Profile;
    use crate::involute::closing::Closing;
    use epicyclic_units::Physical;
    use proptest::prelude::*;
    use uom::si::f64::Angle;

    fn set(counts: [u32; 3]) -> crate::involute::PlanetSet {
        Closing::default().close(counts.map(|count| ToothCount::new(count).unwrap())).unwrap().set
    }

    #[test]
    fn limits_in_the_wrong_order_are_refused() {
        let pair = *set([18, 36, 93]).sun_mesh();
        let wrong = Deviation { lower: -0.01, upper: -0.02 };
        let error = pair.plays([wrong; 2], Deviation::default()).unwrap_err();
        assert_eq!(
            error.to_string(),
            "tooth thickness allowance from -0.01 to -0.02 modules: two finite numbers are needed, the smaller first"
        );
        let far = Deviation { lower: f64::NAN, upper: 0.0 };
        let error = pair.plays(Default::default(), far).unwrap_err();
        assert_eq!(error.name(), "deviation");
    }

    #[test]
    fn thinner_teeth_have_smaller_measures_and_the_same_tips() {
        let planet = *set([18, 36, 93]).gears()[1];
        let thinner = planet.with_thickness_allowance(-0.01).unwrap();
        let normal = thinner.span(5) - planet.span(5);
        assert!((normal + 0.01 * libm::cos(20_f64.to_radians())).abs() < 1e-12);
        assert!((thinner.tip_diameter() - planet.tip_diameter()).abs() < 1e-12);
        let thickness = thinner.thickness_at(36.0) - planet.thickness_at(36.0);
        assert!((thickness + 0.01).abs() < 1e-12);
    }

    proptest! {
        #[test]
        fn normal_backlash_grows_by_the_allowances_along_the_normal(
            sun in 17..50_u32, planet in 17..50_u32, offset in -2..=3_i32, helix in 0.0..25.0_f64,
            allowances in [-0.05..0.0_f64, -0.05..0.0_f64],
        ) {
            let profile = Profile { helix_angle: Angle::from_degrees(helix), ..Profile::default() };
            let ring = (sun + 2 * planet).checked_add_signed(offset).unwrap();
            let teeth = [sun, planet, ring].map(|count| ToothCount::new(count).unwrap());
            let closed = Closing { profiles: profile.into(), ..Closing::default() }.close(teeth);
            prop_assume!(closed.is_ok());
            let set = closed.unwrap().set;
            for pair in [set.sun_mesh(), set.ring_mesh()] {
                let one = |value: f64| Deviation { lower: value - 0.01, upper: value };
                let [least, greatest] = pair.plays(allowances.map(one), Deviation::default()).unwrap();
                let normal = -(allowances[0] + allowances[1]) * libm::cos(20_f64.to_radians());
                prop_assert!((least.normal - normal).abs() < 1e-10);
                prop_assert!((greatest.normal - normal - 0.02 * libm::cos(20_f64.to_radians())).abs() < 1e-10);
            }
        }
    }
}

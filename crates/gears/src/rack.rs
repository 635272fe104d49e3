//! The basic rack: the one description of a tooth that all checks take.
//!
//! Diameters, undercut, the gap between planets and the direction of the tooth force follow from the same
//! three numbers. No other file of the crate has a pressure angle or an addendum of its own.

use crate::checks::{acute_angle, not_negative};
use crate::{Error, Quantity, ToothCount};
use epicyclic_units::Physical;
use uom::si::f64::Angle;

/// Proportions of the standard basic rack tooth profile, in modules.
///
/// | symbol | field | meaning | unit | default |
/// |---|---|---|---|---|
/// | `h_a*` (`h_aP/m`) | `addendum` | addendum coefficient | 1 | 1 |
/// | `c*` (`c_P/m`) | `clearance` | bottom clearance coefficient | 1 | 0.25 |
/// | `α` (`α_P`) | `pressure_angle` | pressure angle | ° | 20 |
///
/// # Source
/// Names as in ISO 53 and ISO 21771. The defaults are profile A of ISO 53, and those of GOST 13755;
/// excavator-dynamics (section 4) takes `c*` = 0.2.
///
/// ```
/// use epicyclic_gears::rack::BasicRack;
///
/// let older = BasicRack { clearance: 0.2, ..BasicRack::default() };
/// assert_eq!(older.addendum, 1.0);
/// assert_eq!(older.least_teeth_without_undercut(), 17);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BasicRack {
    /// Addendum coefficient `h_a*`.
    pub addendum: f64,
    /// Bottom clearance coefficient `c*`.
    pub clearance: f64,
    /// Pressure angle `α`.
    pub pressure_angle: Angle,
}

impl Default for BasicRack {
    fn default() -> Self {
        Self { addendum: 1.0, clearance: 0.25, pressure_angle: Angle::from_degrees(20.0) }
    }
}

impl BasicRack {
    /// Refuses proportions that no rack has.
    ///
    /// # Errors
    /// [`Error::Negative`] for `h_a*` or `c*`, [`Error::OutOfRange`] unless 0 < α < 90°.
    pub fn check(&self) -> Result<(), Error> {
        not_negative(Quantity::AddendumCoefficient, self.addendum, "modules")?;
        not_negative(Quantity::ClearanceCoefficient, self.clearance, "modules")?;
        acute_angle(Quantity::PressureAngle, self.pressure_angle)?;
        Ok(())
    }

    /// Teeth at which a rack just reaches the base circle's tangent point: below them it cuts into the
    /// involute.
    ///
    /// ```text
    /// z_min = 2·h_a*/sin²α
    /// ```
    ///
    /// The formula is for external teeth without profile shift. The rack that cuts them has straight flanks
    /// to `h_a*` below its pitch line, where the tooth it cuts has its form dedendum (`h_FfP` of ISO 21771).
    /// The rounding below lies within the clearance `c*` and cuts no involute. 31.9, 17.1 and 11.2 teeth at
    /// 14.5°, 20° and 25° with `h_a*` = 1.
    ///
    /// # Source
    /// ISO 21771, limit of undercut at `x` = 0.
    #[must_use]
    pub fn undercut_limit(&self) -> f64 {
        2.0 * self.addendum / libm::sin(self.pressure_angle.si()).powi(2)
    }

    /// The least whole number of teeth that counts as not undercut: [`undercut_limit`](Self::undercut_limit)
    /// to the nearest whole number, a half upwards.
    ///
    /// Exactly it would be the next *higher* one. Practice takes 17 teeth at 20°, where the limit is 17.1.
    /// The nearest whole number does the same at every angle: the gear lacks at most half a tooth, and the
    /// rack then reaches at most `sin²α/4` modules too deep, 0.03 modules at 20°. At 14.5°, 20° and 25° it
    /// gives 32, 17 and 11.
    #[must_use]
    pub fn least_teeth_without_undercut(&self) -> u32 {
        // A float cast to an integer saturates, so an absurd coefficient gives u32::MAX teeth.
        self.undercut_limit().round() as u32
    }

    /// Whether the rack undercuts an external gear with this number of teeth and no profile shift, by
    /// [`least_teeth_without_undercut`](Self::least_teeth_without_undercut).
    #[must_use]
    pub fn undercuts(&self, teeth: ToothCount) -> bool {
        teeth.get() < self.least_teeth_without_undercut()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn rack(addendum: f64, alpha_deg: f64) -> BasicRack {
        BasicRack { addendum, pressure_angle: Angle::from_degrees(alpha_deg), ..BasicRack::default() }
    }

    #[test]
    fn each_pressure_angle_has_its_least_tooth_count() {
        // 2/sin²α by a table of sines: sin 14.5° = 0.25038, sin 20° = 0.34202, sin 25° = 0.42262.
        for (alpha, limit, least) in [(14.5, 31.903, 32), (20.0, 17.097, 17), (25.0, 11.198, 11)] {
            let rack = rack(1.0, alpha);
            assert!((rack.undercut_limit() - limit).abs() < 1e-3, "{alpha}: {}", rack.undercut_limit());
            assert_eq!(rack.least_teeth_without_undercut(), least);
        }
        assert_eq!(rack(0.8, 20.0).least_teeth_without_undercut(), 14);
        assert_eq!(rack(0.0, 20.0).least_teeth_without_undercut(), 0);
        assert_eq!(rack(1e308, 20.0).least_teeth_without_undercut(), u32::MAX);
    }

    #[test]
    fn undercut_begins_below_17_teeth_at_20_degrees() {
        let teeth = |count| ToothCount::new(count).unwrap();
        let usual = BasicRack::default();
        assert!(usual.undercuts(teeth(16)) && !usual.undercuts(teeth(17)));
    }

    #[test]
    fn proportions_of_no_rack_are_refused() {
        assert_eq!(BasicRack::default().check(), Ok(()));
        assert!(matches!(
            rack(-1.0, 20.0).check(),
            Err(Error::Negative { quantity: Quantity::AddendumCoefficient, .. })
        ));
        let bad = BasicRack { clearance: f64::NAN, ..BasicRack::default() };
        assert!(matches!(bad.check(), Err(Error::Negative { quantity: Quantity::ClearanceCoefficient, .. })));
        for alpha in [0.0, 90.0, -20.0, f64::NAN] {
            assert!(matches!(
                rack(1.0, alpha).check(),
                Err(Error::OutOfRange { quantity: Quantity::PressureAngle, .. })
            ));
        }
    }

    proptest! {
        /// Geometry of the cut: the rack's tip line is `r − h_a*·m` from the axis, the tangent point of the
        /// line of action `r·cos²α`. Undercut begins where the tip line is nearer to the axis.
        #[test]
        fn the_limit_is_where_the_tip_line_meets_the_tangent_point(
            addendum in 0.3..1.5_f64, alpha_deg in 10.0..35.0_f64,
        ) {
            let rack = rack(addendum, alpha_deg);
            let pitch_radius = rack.undercut_limit() / 2.0;
            let tangent_point = pitch_radius * libm::cos(alpha_deg.to_radians()).powi(2);
            prop_assert!((pitch_radius - addendum - tangent_point).abs() < 1e-12 * pitch_radius);
            // Rounding admits at most sin²α/4 modules too deep.
            let least = f64::from(rack.least_teeth_without_undercut());
            let depth = addendum - least / 2.0 * libm::sin(alpha_deg.to_radians()).powi(2);
            prop_assert!(depth <= libm::sin(alpha_deg.to_radians()).powi(2) / 4.0 + 1e-12, "{depth}");
        }
    }
}

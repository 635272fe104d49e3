//! The form of the teeth: the engineer's choice, and the numbers of satellite and cutter that follow.
//!
//! In modules, `p = π` the pitch, `r = Z_s/2` the satellite's pitch radius, `r_b = r·cos α` its base radius:
//!
//! | symbol | meaning | value |
//! |---|---|---|
//! | `w` | the satellite's tooth on its pitch circle | `π/2 + 2·x·tan α − q·j` |
//! | `e` | a wheel's space on its centrode, the cutter's tooth | `π/2 + 2·x·tan α + (1 − q)·j` |
//! | | the satellite's tip and root circle | `r + h_a + x`, `r − (h_a + c − x)` |
//! | | the cutter's tip circle | `r + h_a + c + x` |
//! | | the wheels' addendum, from the centrode | `h_a − x` |
//!
//! A point of an involute has the roll angle `t = tan α_y`; half the tooth there spans
//! `w/(2r) + inv α − (t − atan t)`.

use crate::quantity::{Quantity, WheelKind};
use epicyclic_units::Physical;
use uom::si::f64::Angle;

use crate::Error;
use crate::ranges::{finite_angle, ranging};
use epicyclic_numerics::roots::bracketed;
use std::f64::consts::{FRAC_PI_2, PI};

/// Part of a tooth in the middle of the stator's crests.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Crest {
    /// The middle of a space.
    #[default]
    Space,
    /// The middle of a tooth.
    Tooth,
}

/// The form of the teeth; lengths in modules.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToothForm {
    /// Pressure angle `α` of the satellite on its pitch circle; from 10° to 40°.
    pub pressure_angle: Angle,
    /// Addendum `h_a*`, above 0 and at most 2.
    pub addendum: f64,
    /// Clearance `c*` of the tips over the roots, from 0 to 1.
    pub clearance: f64,
    /// Profile shift `x` of the satellite, within `±h_a*`; the wheels have `−x`, so that the pitch curves
    /// still roll.
    pub shift: f64,
    /// Backlash `j*` of a satellite in either wheel along the pitch curves, from 0 to 0.5; `j·cos α` along
    /// the normal.
    pub backlash: f64,
    /// The part `q` of the backlash by which the satellite's teeth are thinner, from 0 to 1; the wheels' have
    /// the rest.
    pub satellite_share: f64,
    /// Radius `ρ*` of the rounded tips of the cutter of the wheels and of the satellite's rack, from 0 to 1.
    pub fillet: f64,
    /// Part of a tooth in the middle of the stator's crests.
    pub crest: Crest,
}

impl ToothForm {
    /// The standard 20° full-depth form: `h_a* = 1`, `c* = 0.25`, `ρ* = 0.15`, no shift.
    ///
    /// A satellite of fewer than 17 teeth is undercut by it.
    #[must_use]
    pub fn full_depth() -> Self {
        Self {
            pressure_angle: Angle::from_degrees(20.0),
            addendum: 1.0,
            clearance: 0.25,
            shift: 0.0,
            fillet: 0.15,
            ..Self::default()
        }
    }

    /// All independent faults of the numbers, whichever motor has the teeth: values outside the ranges of
    /// their fields.
    #[must_use]
    pub fn faults(&self) -> Vec<Error> {
        let of = |quantity, value, low, high| ranging(quantity, value, [low, high], "modules");
        let alpha = finite_angle(Quantity::PressureAngle, self.pressure_angle)
            .and_then(|_| ranging(Quantity::PressureAngle, self.pressure_angle.degrees(), [10.0, 40.0], "°"));
        let addendum = of(Quantity::Addendum, self.addendum, 1e-3, 2.0);
        // A thousandth of a module at least remains above the pitch curves.
        let shift = match &addendum {
            Ok(addendum) => of(Quantity::ProfileShift, self.shift, 1e-3 - addendum, addendum - 1e-3),
            // The range follows from the addendum.
            Err(_) => Ok(self.shift),
        };
        let checked = [
            alpha,
            addendum,
            of(Quantity::Clearance, self.clearance, 0.0, 1.0),
            shift,
            of(Quantity::Backlash, self.backlash, 0.0, 0.5),
            ranging(Quantity::BacklashShare, self.satellite_share, [0.0, 1.0], ""),
            of(Quantity::Fillet, self.fillet, 0.0, 1.0),
        ];
        checked.into_iter().filter_map(Result::err).collect()
    }
}

/// Involute function of a roll angle, `inv α_y = t − atan t` with `t = tan α_y`.
pub(super) fn involute(t: f64) -> f64 {
    t - libm::atan(t)
}

/// The satellite and the cutters in modules.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Teeth {
    pub(crate) sin: f64,
    pub(crate) cos: f64,
    pub(crate) tan: f64,
    /// Pitch and base radius of satellite and cutter.
    pub(crate) r: f64,
    pub(crate) base: f64,
    /// Half the satellite's tooth on its pitch circle, `w/2`, and its tip and root radius.
    pub(crate) half_tooth: f64,
    pub(crate) tip: f64,
    pub(super) root: f64,
    /// Half the cutter's tooth on the pitch circle, `e/2`, and its addendum.
    pub(crate) half_space: f64,
    pub(super) cutter_addendum: f64,
    /// Centre of the cutter's rounded tip: radius, and angle from the middle of the tooth.
    pub(super) round_radius: f64,
    pub(super) round_angle: f64,
    /// Roll at which the cutter's flank ends at the rounding, from the pitch point, negative
    /// ([`super::cut`]).
    pub(super) cutter_roll: f64,
    /// The wheels' addendum.
    pub(super) wheel_addendum: f64,
    /// Centre of the rack's rounded tip: half its distance from the mirrored one, and depth under the pitch
    /// line.
    pub(super) rack_half: f64,
    pub(super) rack_depth: f64,
    /// Roll at which the rack's flank ends at the rounding.
    pub(super) rack_roll: f64,
    pub(super) fillet: f64,
    pub(super) backlash: f64,
}

impl Teeth {
    pub(super) fn new(form: ToothForm, satellite_teeth: u32) -> Result<Self, Error> {
        if let Some(fault) = form.faults().into_iter().next() {
            return Err(fault);
        }
        let ToothForm { addendum, clearance, shift: x, backlash, satellite_share: share, fillet, .. } = form;
        let (sin, cos) = libm::sincos(form.pressure_angle.si());
        let tan = sin / cos;
        let r = 0.5 * f64::from(satellite_teeth);
        let thickness = FRAC_PI_2 + 2.0 * x * tan;
        let tooth =
            ranging(Quantity::SatelliteTooth, thickness - share * backlash, [1e-3, PI - 1e-3], "modules")?;
        let space = thickness + (1.0 - share) * backlash;
        ranging(Quantity::WheelTooth, PI - space, [1e-3, PI], "modules")?;
        let dedendum = ranging(Quantity::SatelliteDedendum, addendum + clearance - x, [0.0, r], "modules")?;
        let mut teeth = Self {
            sin,
            cos,
            tan,
            r,
            base: r * cos,
            half_tooth: 0.5 * tooth,
            tip: r + addendum + x,
            root: r - dedendum,
            half_space: 0.5 * space,
            cutter_addendum: addendum + clearance + x,
            round_radius: r,
            round_angle: 0.0,
            cutter_roll: 0.0,
            wheel_addendum: addendum - x,
            rack_half: 0.0,
            rack_depth: dedendum - fillet,
            rack_roll: 0.0,
            fillet,
            backlash,
        };
        teeth.check_tip(WheelKind::Satellite, teeth.half_tooth, addendum, x)?;
        teeth.check_tip(WheelKind::WheelCutter, teeth.half_space, addendum + clearance, x)?;

        let sharp = teeth;
        let half = |fillet: f64| sharp.round_angle_of(fillet);
        if !(fillet < teeth.cutter_addendum && half(fillet) >= 0.0) {
            let most = if half(teeth.cutter_addendum) >= 0.0 {
                teeth.cutter_addendum
            } else {
                bracketed(0.0, teeth.cutter_addendum, half)
            };
            return Err(Error::FilletTooLarge { tool: WheelKind::WheelCutter, fillet, most });
        }
        teeth.round_radius = r + teeth.cutter_addendum - fillet;
        teeth.round_angle = half(fillet);
        let roll = teeth.roll_angle(teeth.round_radius) + fillet / teeth.base;
        teeth.cutter_roll = -r * (roll - tan);

        let rack_half = |fillet: f64| 0.5 * (PI - tooth) - (dedendum - fillet) * tan - fillet / cos;
        if !(fillet < dedendum && rack_half(fillet) >= 0.0) {
            // Linear, and falling since 1/cos α > tan α.
            let most = (0.5 * (PI - tooth) - dedendum * tan) / (1.0 / cos - tan);
            return if most < 0.0 {
                let most = 0.5 * (PI - tooth) / tan + x;
                Err(Error::PointedTip {
                    wheel: WheelKind::SatelliteRack,
                    addendum: addendum + clearance,
                    most,
                })
            } else {
                Err(Error::FilletTooLarge {
                    tool: WheelKind::SatelliteRack,
                    fillet,
                    most: most.min(dedendum),
                })
            };
        }
        teeth.rack_half = rack_half(fillet);
        teeth.rack_roll = -(teeth.rack_depth + fillet * sin) / (sin * cos);
        Ok(teeth)
    }

    /// Roll angle `t = tan α_y` of the involute at a radius, which is at least the base radius.
    pub(super) fn roll_angle(&self, radius: f64) -> f64 {
        let ratio = radius / self.base;
        (ratio * ratio - 1.0).max(0.0).sqrt()
    }

    /// Half a tooth's angle at a roll angle, from half its arc on the pitch circle.
    pub(super) fn half_angle(&self, half_arc: f64, t: f64) -> f64 {
        half_arc / self.r + involute(self.tan) - involute(t)
    }

    /// Angle of the centre of the cutter's rounded tip: on the involute that lies `ρ` inside the flank.
    fn round_angle_of(&self, fillet: f64) -> f64 {
        let t = self.roll_angle(self.r + self.cutter_addendum - fillet);
        self.half_angle(self.half_space, t) - fillet / self.base
    }

    /// Refuses an addendum at which the involutes of a tooth meet.
    fn check_tip(&self, wheel: WheelKind, half_arc: f64, addendum: f64, x: f64) -> Result<(), Error> {
        let half = |addendum: f64| self.half_angle(half_arc, self.roll_angle(self.r + addendum + x));
        if half(addendum) > 0.0 {
            return Ok(());
        }
        // On the pitch circle, at −x, a tooth has its thickness.
        Err(Error::PointedTip { wheel, addendum, most: bracketed(-x, addendum, half) })
    }

    /// Roll of the satellite's tip from the pitch point, negative.
    pub(super) fn tip_roll(&self) -> f64 {
        -self.r * (self.roll_angle(self.tip) - self.tan)
    }

    /// Half the angle of the satellite's tip.
    pub(super) fn tip_angle(&self) -> f64 {
        self.half_angle(self.half_tooth, self.roll_angle(self.tip))
    }
}

impl Default for ToothForm {
    /// 25°, `h_a* = 0.85`, `c* = 0.25`, `x = 0.2`, `j* = 0.04` on the satellite alone, `ρ* = 0.1`, a space in
    /// the crest; why, see [`crate::profile`].
    fn default() -> Self {
        Self {
            pressure_angle: Angle::from_degrees(25.0),
            addendum: 0.85,
            clearance: 0.25,
            shift: 0.2,
            backlash: 0.04,
            satellite_share: 1.0,
            fillet: 0.1,
            crest: Crest::Space,
        }
    }
}

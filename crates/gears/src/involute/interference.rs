//! Interference of an internal pair: whether it turns without tooth contact outside the mesh, and whether it
//! can be assembled.
//!
//! Tips of an internal gear and of a gear with only a few teeth less meet outside the line of action. Three
//! kinds are distinguished:
//!
//! - *Involute interference*: the ring's tip reaches below the base circle of the pinion, or into its fillet.
//! - *Trochoidal interference*: the tips meet after they have left the mesh.
//! - *Trimming*: the gears cannot be put together, or the ring be cut, by moving them radially.
//!
//! With `α_a` the transverse pressure angle at a tip and `a` the centre distance, 1 the external gear and 2
//! the ring:
//!
//! ```text
//! trochoidal   θ_1·z_1/z_2 + inv α_wt − inv α_a2 ≥ θ_2
//!              cos(θ_1 − inv α_a1 + inv α_wt) = (r_a2² − r_a1² − a²)/(2·a·r_a1)
//!              cos θ_2 = (a² + r_a2² − r_a1²)/(2·a·r_a2)
//! trimming     θ_1 + inv α_a1 − inv α_wt ≥ (z_2/z_1)·(θ_2 + inv α_a2 − inv α_wt)
//!              sin²θ_1 = (1 − (cos α_a1/cos α_a2)²)/(1 − (z_1/z_2)²)
//!              sin²θ_2 = ((cos α_a2/cos α_a1)² − 1)/((z_2/z_1)² − 1)
//! ```
//!
//! # Source
//! The conditions as in SDP/SI D785, section 5 (after the usual theory of internal gears).

use super::function::involute;
use super::pair::Pair;
use super::tips::Tips;

/// Clearances of an internal pair against interference; each is 0 or more where nothing meets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interference {
    /// Radius of curvature of the lowest point of the pinion's flank that the ring's tip meets, modules.
    /// Below 0 the point would be beyond the base circle, where the involute ends.
    pub base: f64,
    /// Radius `base` less the radius of curvature at which the involute of the pinion ends and its fillet
    /// begins, modules.
    pub fillet: f64,
    /// Angle of the ring, rad, by which the tips miss each other outside the mesh. It is −∞ where the tip
    /// circle of the pinion encloses that of the ring, +∞ where the tip circles do not meet.
    pub trochoidal: f64,
    /// Angle of the pinion, rad, by which the tips miss each other when the pinion is moved radially. It is
    /// −∞ where the ring's tips reach within its base circle, +∞ where they never meet.
    pub trimming: f64,
}

impl Interference {
    /// Whether the pair turns.
    #[must_use]
    pub fn is_free(&self) -> bool {
        self.base >= 0.0 && self.fillet >= 0.0 && self.trochoidal >= 0.0
    }

    /// Whether the pair turns and can also be assembled radially.
    #[must_use]
    pub fn can_be_put_together_radially(&self) -> bool {
        self.is_free() && self.trimming >= 0.0
    }
}

impl Pair {
    /// Clearances of an internal pair against interference; `None` for an external pair.
    #[must_use]
    pub fn interference(&self) -> Option<Interference> {
        if !self.is_internal() {
            return None;
        }
        let [pinion, ring] = self.gears();
        let a = self.centre_distance();
        let tips = Tips {
            tips: [pinion, ring].map(|gear| gear.tip_diameter() / 2.0),
            bases: [pinion, ring].map(|gear| gear.base_diameter() / 2.0),
            distance: a,
            inv_w: involute(self.working_angle_rad()),
        };
        let start = ring.curvature_radius(ring.tip_diameter()) - a * libm::sin(self.working_angle_rad());

        Some(Interference {
            base: start,
            fillet: start - pinion.curvature_radius(pinion.form_diameter()),
            trochoidal: tips.trochoidal(),
            trimming: tips.trimming(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ToothCount;
    use crate::gear_kind::GearKind;
    use crate::involute::{InvoluteGear, Profile};
    use proptest::prelude::*;
    use std::f64::consts::{PI, TAU};

    fn gear(kind: GearKind, teeth: u32, shift: f64) -> Option<InvoluteGear> {
        InvoluteGear::new(kind, ToothCount::new(teeth).unwrap(), Profile::default(), shift).ok()
    }

    /// Greatest depth of tip corners of one gear inside teeth of the other at any angle, rad of the other
    /// gear: by coordinates, step by step.
    fn deepest(pair: &Pair) -> f64 {
        let [pinion, ring] = pair.gears();
        let a = pair.centre_distance();
        let [z1, z2] = [pinion, ring].map(|gear| gear.teeth().as_f64());
        // Half the angle of a tooth at a radius.
        let half = |gear: &InvoluteGear, radius: f64| gear.thickness_at(2.0 * radius) / (2.0 * radius);
        let inside = |gear: &InvoluteGear, radius: f64, from_tooth: f64| {
            let pitch = TAU / gear.teeth().as_f64();
            half(gear, radius) - (from_tooth - (from_tooth / pitch).round() * pitch).abs()
        };
        let mut deepest = f64::NEG_INFINITY;
        let steps = 600;
        for step in 0..steps {
            // The pinion has a tooth, the ring a space on the line of centres at the angle 0.
            let turn1 = TAU / z1 * f64::from(step) / f64::from(steps);
            let turn2 = turn1 * z1 / z2;
            let [r1, r2] = [pinion, ring].map(|gear| gear.tip_diameter() / 2.0);
            for tooth in 0..ring.teeth().get() {
                for side in [-1.0, 1.0] {
                    let angle = turn2 + (TAU * f64::from(tooth) + PI) / z2 + side * half(ring, r2);
                    let (x, y) = (r2 * libm::cos(angle) - a, r2 * libm::sin(angle));
                    let radius = libm::hypot(x, y);
                    if radius < r1 && radius > pinion.base_diameter() / 2.0 {
                        deepest = deepest.max(inside(pinion, radius, libm::atan2(y, x) - turn1));
                    }
                }
            }
            for tooth in 0..pinion.teeth().get() {
                for side in [-1.0, 1.0] {
                    let angle = turn1 + TAU * f64::from(tooth) / z1 + side * half(pinion, r1);
                    let (x, y) = (r1 * libm::cos(angle) + a, r1 * libm::sin(angle));
                    let radius = libm::hypot(x, y);
                    if radius > r2 {
                        deepest = deepest.max(inside(ring, radius, libm::atan2(y, x) - turn2 - PI / z2));
                    }
                }
            }
        }
        deepest
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(150))]
        #[test]
        fn tips_stepped_through_meet_where_the_condition_says(
            pinion in 22..60_u32, more in 3..25_u32, x1 in -0.2..0.6_f64, x2 in -0.6..0.2_f64,
        ) {
            let gears = gear(GearKind::External, pinion, x1).zip(gear(GearKind::Internal, pinion + more, x2));
            prop_assume!(gears.is_some());
            let (first, second) = gears.unwrap();
            let pair = Pair::without_backlash(first, second);
            prop_assume!(pair.is_ok());
            let pair = pair.unwrap();
            let found = pair.interference().unwrap();
            // The condition holds for rings with involute tips; grazing contact falls between the steps.
            prop_assume!(second.tip_diameter() > second.base_diameter());
            prop_assume!(found.trochoidal.abs() > 2e-3 && pair.tip_clearances().iter().all(|gap| *gap > 0.0));
            // Below the base circle the pinion has no involute to be stepped through.
            prop_assume!(found.base > 0.05);
            let depth = deepest(&pair);
            prop_assert_eq!(depth > 1e-4, found.trochoidal < 0.0, "{:?}, {}", found, depth);
        }
    }
}

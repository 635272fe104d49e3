//! The exact outline of a tooth in the transverse plane: involute flank and the fillet that a hob or a shaper
//! leaves.
//!
//! A point is given by its radius and its angle from the centre line of the tooth; the other flank is its
//! mirror image. Lengths in modules, angles in rad.
//!
//! # Involute
//! ```text
//! ψ(r) = s_yt/(2·r)
//! ```
//!
//! Fillets are in [`tool`](super::tool) by their kind: by a hob, a shaper or a form tool.
//!
//! # Undercut
//! If the tool reaches below the tangent point of the base circle, the fillet cuts into the foot of the
//! involute. It crosses the involute further out, where the outline continues on it. Otherwise both have a
//! common tangent where the flank of the tool ends.
//!
//! Left out: chamfers, the feed of the tool.

pub use super::fillet::Point;
use super::fillet::{Fillet, HALVINGS};
use super::gear::InvoluteGear;
use crate::Error;
use epicyclic_numerics::roots::bisected;
use std::f64::consts::PI;

/// Half of a tooth, from the middle of the space at the root to the corner of the tip.
///
/// ```
/// use epicyclic_gears::involute::curve::ToothCurve;
/// use epicyclic_gears::involute::{InvoluteGear, Profile};
/// use epicyclic_gears::{ToothCount, geometry::GearKind};
/// # fn main() -> Result<(), epicyclic_gears::Error> {
/// let gear =
///     |teeth, x| InvoluteGear::new(GearKind::External, ToothCount::new(teeth)?, Profile::default(), x);
/// // Without shift a rack undercuts 12 teeth; with x = 0.3 it does not.
/// assert!(ToothCurve::new(gear(12, 0.0)?)?.is_undercut());
/// assert!(!ToothCurve::new(gear(12, 0.3)?)?.is_undercut());
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToothCurve {
    gear: InvoluteGear,
    fillet: Fillet,
    /// The parameter of the fillet where the involute takes over.
    joint: f64,
    undercut: bool,
}

impl ToothCurve {
    /// The tooth of a gear as its tool leaves it.
    ///
    /// # Errors
    /// [`Error::Uncut`] where the tool does not cut the gear.
    pub fn new(gear: InvoluteGear) -> Result<Self, Error> {
        let cut = gear.cut();
        let fillet = cut.fillet(gear.flank(), gear.profile(), gear.shift(), gear.tool());
        let Some(fillet) = fillet else {
            return Err(Error::Uncut { teeth: gear.teeth().get(), kind: gear.kind(), fault: cut.fault });
        };
        let (joint, undercut) = fillet.joint(cut.reach);
        Ok(Self { gear, fillet, joint, undercut })
    }

    /// The gear.
    #[must_use]
    pub const fn gear(&self) -> &InvoluteGear {
        &self.gear
    }

    /// Parameter of the fillet where the involute takes over.
    pub(super) const fn joint(&self) -> f64 {
        self.joint
    }

    /// Whether the fillet takes a part of the involute away.
    #[must_use]
    pub const fn is_undercut(&self) -> bool {
        self.undercut
    }

    /// Root radius: where the crest of the tool passes.
    #[must_use]
    pub fn root_radius(&self) -> f64 {
        self.fillet(0.0).radius
    }

    /// Radius where the involute takes over from the fillet.
    #[must_use]
    pub fn joint_radius(&self) -> f64 {
        self.fillet(self.joint).radius
    }

    /// Tip radius.
    #[must_use]
    pub fn tip_radius(&self) -> f64 {
        self.gear.tip_diameter() / 2.0
    }

    /// A point of the flank: its involute at a radius, as far as the tool would cut it.
    #[must_use]
    pub fn involute(&self, radius: f64) -> Point {
        Point { radius, angle: self.involute_angle(radius) }
    }

    fn involute_angle(&self, radius: f64) -> f64 {
        self.gear.flank().half_angle(self.gear.shift(), radius)
    }

    /// A point of the fillet, as the tool would cut it without the flank: 0 at the root, 1 where the corner
    /// of the tool ends.
    #[must_use]
    pub fn fillet(&self, t: f64) -> Point {
        self.fillet.at(t)
    }

    /// Half the angle of the tooth at a radius between root and tip; within the root it is the whole pitch,
    /// beyond the tip nothing.
    #[must_use]
    pub fn half_angle(&self, radius: f64) -> f64 {
        let sign = self.gear.sign();
        let height = |of: f64| sign * of;
        if height(radius) <= height(self.root_radius()) {
            return PI / self.gear.teeth().as_f64();
        }
        if height(radius) > height(self.tip_radius()) {
            return 0.0;
        }
        if height(radius) >= height(self.joint_radius()) {
            return self.involute_angle(radius);
        }
        let is_below = |t: f64| height(self.fillet(t).radius) < height(radius);
        let [low, high] = bisected([0.0, self.joint], HALVINGS, is_below);
        self.fillet(f64::midpoint(low, high)).angle
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ToothCount;
    use crate::gear_kind::GearKind;
    use crate::involute::Pair;
    use crate::involute::Profile;
    use crate::involute::check::Rule;
    use crate::involute::closing::Closing;
    use crate::involute::fillet::Cutter;
    use crate::involute::set::Limits;
    use crate::involute::tool::{Shaper, Tool};
    use epicyclic_units::Physical;
    use proptest::prelude::*;
    use std::f64::consts::{PI, TAU};
    use uom::si::f64::Angle;

    fn count(teeth: u32) -> ToothCount {
        ToothCount::new(teeth).unwrap()
    }

    fn gear(kind: GearKind, teeth: u32, shift: f64, helix_deg: f64) -> Option<InvoluteGear> {
        let profile = Profile { helix_angle: Angle::from_degrees(helix_deg), ..Profile::default() };
        InvoluteGear::new(kind, count(teeth), profile, shift).ok()
    }

    fn shaper(teeth: u32, tip_radius: f64) -> Shaper {
        Shaper { teeth: count(teeth), shift: 0.0, addendum: Some(1.25), tip_radius }
    }

    fn by_shaper(gear: InvoluteGear, shaper: Shaper) -> Result<ToothCurve, Error> {
        ToothCurve::new(gear.with_tool(Tool::Shaper(shaper))?)
    }

    #[test]
    fn tools_that_cannot_cut_are_refused() {
        let ring = gear(GearKind::Internal, 60, 0.0, 0.0).unwrap();
        assert_eq!(ring.with_tool(Tool::Rack).unwrap_err().name(), "wrong-gear-kind");
        assert_eq!(by_shaper(ring, shaper(30, -0.1)).unwrap_err().name(), "negative");
        let far = Shaper { shift: 1.5, ..shaper(30, 0.2) };
        assert_eq!(by_shaper(ring, far).unwrap_err().name(), "out-of-range");
        for (shaper, words) in [
            (
                shaper(60, 0.2),
                "internal gear of 60 teeth: a shaper of 60 teeth does not fit into a ring of 60",
            ),
            (shaper(30, 0.9), "with an addendum of 1.2500 modules have room for corners of 0.39"),
            (
                Shaper { addendum: Some(3.0), ..shaper(30, 0.2) },
                "with an addendum of 3.0000 modules and corners of 0.2 has pointed teeth",
            ),
        ] {
            let error = by_shaper(ring, shaper).unwrap_err();
            assert!(error.name() == "uncut" && error.to_string().contains(words), "{error}");
        }
        let error = ToothCurve::new(ring.with_tool(Tool::Form { fillet: 2.0 }).unwrap()).unwrap_err();
        assert!(error.to_string().contains("fillets of 2 modules have no room"), "{error}");
    }

    /// A shaper with very many teeth is a rack.
    #[test]
    fn a_large_shaper_cuts_as_a_rack_does() {
        for helix in [0.0, 20.0] {
            let sun = gear(GearKind::External, 20, 0.2, helix).unwrap();
            // The corner of a rack is round in the normal section: sharp ones are alike.
            let sharp = Profile { fillet: 0.0, ..*sun.profile() };
            let sun = InvoluteGear::new(GearKind::External, count(20), sharp, 0.2).unwrap();
            let by_rack = ToothCurve::new(sun).unwrap();
            let by_shaper = by_shaper(sun, shaper(2_000_000, 0.0)).unwrap();
            for t in [0.2, 0.5, 0.75, 1.0] {
                let radius = by_rack.fillet(t).radius;
                let angles = [by_rack, by_shaper].map(|curve| curve.half_angle(radius + 1e-9));
                assert!((angles[0] - angles[1]).abs() < 1e-5, "{helix} {t}: {angles:?}");
            }
        }
        let sun = gear(GearKind::External, 20, 0.2, 0.0).unwrap();
        let [one, other] =
            [ToothCurve::new(sun), by_shaper(sun, shaper(2_000_000, 0.38))].map(Result::unwrap);
        for t in [0.2, 0.6, 1.0] {
            let radius = one.fillet(t).radius + 1e-9;
            assert!((one.half_angle(radius) - other.half_angle(radius)).abs() < 1e-5, "{t}");
        }
    }

    proptest! {
        #[test]
        fn a_fillet_goes_over_into_the_involute_at_the_form_circle(
            teeth in 8..90_u32, shift in -0.3..0.8_f64, helix in 0.0..30.0_f64,
        ) {
            let Some(gear) = gear(GearKind::External, teeth, shift, helix) else { return Ok(()) };
            let curve = ToothCurve::new(gear).unwrap();
            prop_assert!((curve.root_radius() - gear.root_diameter() / 2.0).abs() < 1e-12 * gear.root_diameter());
            let joint = curve.fillet(curve.joint);
            prop_assert!((joint.angle - curve.involute(joint.radius).angle).abs() < 1e-8);
            let least = gear.least_shift_without_undercut().unwrap();
            if shift > least + 1e-3 {
                prop_assert!(!curve.is_undercut());
                prop_assert!((2.0 * joint.radius - gear.form_diameter()).abs() < 1e-9 * gear.form_diameter());
            } else if shift < least - 0.02 {
                // Seen on the curve alone.
                prop_assert!(curve.is_undercut() && 2.0 * joint.radius > gear.base_diameter());
            }
        }

        #[test]
        fn a_tooth_is_as_thick_as_its_formula_says(
            teeth in 20..90_u32, shift in -0.1..0.8_f64, ring in any::<bool>(), place in 0.0..1.0_f64,
        ) {
            let kind = if ring { GearKind::Internal } else { GearKind::External };
            let Some(gear) = gear(kind, teeth + 30, shift, 0.0) else { return Ok(()) };
            let Ok(curve) = by_shaper(gear, shaper(25, 0.2)) else { return Ok(()) };
            let radius = curve.joint_radius() + place * (curve.tip_radius() - curve.joint_radius());
            // Across from flank to flank by coordinates, as an arc.
            let [x, y] = curve.involute(radius).coordinates();
            let thickness = 2.0 * radius * libm::atan(y / x);
            prop_assert!((thickness - gear.thickness_at(2.0 * radius)).abs() < 1e-10 * radius);
            let tool = InvoluteGear::new(GearKind::External, count(25), Profile::default(), 0.0).unwrap();
            let a = Pair::without_backlash(tool, gear).unwrap().centre_distance();
            let root = if ring { a + 13.75 } else { a - 13.75 };
            prop_assert!((curve.root_radius() - root).abs() < 1e-10 * root);
        }

        /// Envelope by steps: no point of the tool is ever inside the tooth that it has cut.
        #[test]
        fn the_shaper_never_enters_the_tooth_that_it_leaves(
            teeth in 45..110_u32, cutter in 18..30_u32, shift in -0.3..0.5_f64, radius in 0.1..0.3_f64, ring in any::<bool>(),
        ) {
            let kind = if ring { GearKind::Internal } else { GearKind::External };
            let Some(gear) = gear(kind, teeth, shift, 0.0) else { return Ok(()) };
            let Ok(curve) = by_shaper(gear, shaper(cutter, radius)) else { return Ok(()) };
            let cut = curve.gear().cut();
            let Cutter { centre, normal, radius: corner, distance, ratio, .. } = cut.shaped.unwrap().cutter(curve.gear().flank());
            let mut nearest = f64::INFINITY;
            for step in -200..=200 {
                let turned = f64::from(step) / 200.0 * 0.6;
                for part in 0..=20 {
                    let delta = centre.angle + (normal - centre.angle) * f64::from(part) / 20.0;
                    let x = centre.radius * libm::cos(centre.angle + turned) + corner * libm::cos(delta + turned);
                    let y = centre.radius * libm::sin(centre.angle + turned) + corner * libm::sin(delta + turned);
                    let (from_axis, angle) = if ring {
                        (libm::hypot(x - distance, y), libm::atan2(y, x - distance) - ratio * turned)
                    } else {
                        (libm::hypot(distance - x, y), libm::atan2(y, distance - x) - ratio * turned)
                    };
                    let height = if ring { curve.root_radius() - from_axis } else { from_axis - curve.root_radius() };
                    if height > 1e-6 && (gear.sign() * (curve.joint_radius() - from_axis)) > 0.0 {
                        // Angle from the middle of the space to its edge.
                        let edge = PI / gear.teeth().as_f64() - curve.half_angle(from_axis);
                        nearest = nearest.min((edge - angle) * from_axis);
                    }
                }
            }
            prop_assert!(nearest > -1e-6, "{nearest}");
            prop_assert!(nearest < 5e-3, "{nearest}");
        }
    }

    /// Contact by the curves alone: the normal of each sampled point, by differences, through the pitch
    /// point.
    fn contact_ratio_by_curves(pair: &Pair, curves: [&ToothCurve; 2]) -> f64 {
        let [first, second] = curves;
        let pitch_point = pair.working_diameters()[0] / 2.0;
        let centre = if pair.is_internal() {
            pitch_point - pair.working_diameters()[1] / 2.0
        } else {
            pitch_point + pair.working_diameters()[1] / 2.0
        };
        let outwards = second.gear().sign();
        let gear = first.gear();
        let [low, high] =
            [first.joint_radius(), first.tip_radius()].map(|radius| gear.curvature_radius(2.0 * radius));
        let steps = 4_000;
        let mut turns = (f64::INFINITY, f64::NEG_INFINITY);
        for step in 1..steps {
            let length = low + (high - low) * f64::from(step) / f64::from(steps);
            let at =
                |length: f64| first.involute(libm::hypot(gear.base_diameter() / 2.0, length)).coordinates();
            let small = 1e-6;
            let [before, here, after] = [at(length - small), at(length), at(length + small)];
            let tangent = [after[0] - before[0], after[1] - before[1]];
            let length = libm::hypot(tangent[0], tangent[1]);
            let normal = [-tangent[1] / length, tangent[0] / length];
            // Distance of the normal from the axis; turned until it passes through the pitch point.
            let arm = here[0] * normal[1] - here[1] * normal[0];
            let direction = libm::asin((arm / pitch_point).clamp(-1.0, 1.0));
            let turned = direction - libm::atan2(normal[1], normal[0]);
            let (sin, cos) = libm::sincos(turned);
            let [x, y] = [here[0] * cos - here[1] * sin, here[0] * sin + here[1] * cos];
            let from_mate = libm::hypot(x - centre, y);
            let is_met = outwards * (from_mate - second.joint_radius()) >= 0.0
                && outwards * (second.tip_radius() - from_mate) >= 0.0;
            if is_met {
                turns = (turns.0.min(turned), turns.1.max(turned));
            }
        }
        ((turns.1 - turns.0) * first.gear().teeth().as_f64() / TAU).max(0.0)
    }

    /// Greatest depth of a point of one outline inside a tooth of the other, as an arc in modules; below 0 it
    /// is the smallest distance.
    fn overlap(pair: &Pair, curves: [&ToothCurve; 2]) -> f64 {
        let [first, second] = curves;
        let [z1, z2] = curves.map(|curve| curve.gear().teeth().as_f64());
        let sign = second.gear().sign();
        let a = pair.centre_distance();
        let halves = curves.map(|curve| curve.half(1e-3).unwrap());
        let inside = |curve: &ToothCurve, radius: f64, angle: f64| {
            let pitch = TAU / curve.gear().teeth().as_f64();
            let from_tooth = (angle - (angle / pitch).round() * pitch).abs();
            (curve.half_angle(radius) - from_tooth) * radius
        };
        let near =
            |curve: &ToothCurve, radius: f64| curve.gear().sign() * (curve.tip_radius() - radius) > 0.0;
        let mut deepest = f64::NEG_INFINITY;
        let steps = 24;
        for step in 0..steps {
            let turn1 = TAU / z1 * f64::from(step) / f64::from(steps);
            // A tooth of the first faces a space of the second at the angle 0: the second lies beyond, or is
            // a ring about it.
            let turn2 = if sign > 0.0 { PI / z2 - turn1 * z1 / z2 } else { PI / z2 + turn1 * z1 / z2 };
            for tooth in -3..=3 {
                for side in [-1.0, 1.0] {
                    for point in &halves[0] {
                        let angle = turn1 + f64::from(tooth) * TAU / z1 + side * point.angle;
                        let (x, y) = (point.radius * libm::cos(angle), point.radius * libm::sin(angle));
                        let (x, y) = if sign > 0.0 { (a - x, y) } else { (x + a, y) };
                        let radius = libm::hypot(x, y);
                        if near(second, radius) {
                            let turned = if sign > 0.0 {
                                libm::atan2(y, x) + turn2
                            } else {
                                libm::atan2(y, x) - turn2
                            };
                            deepest = deepest.max(inside(second, radius, turned));
                        }
                    }
                    for point in &halves[1] {
                        let angle = turn2 + f64::from(tooth) * TAU / z2 + side * point.angle;
                        let (x, y) = (point.radius * libm::cos(angle), point.radius * libm::sin(angle));
                        let (x, y) = if sign > 0.0 { (a - x, -y) } else { (x - a, y) };
                        let radius = libm::hypot(x, y);
                        if near(first, radius) {
                            deepest = deepest.max(inside(first, radius, libm::atan2(y, x) - turn1));
                        }
                    }
                }
            }
        }
        deepest
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]
        #[test]
        fn drawn_curves_meet_without_overlap_and_with_the_contact_ratio(
            sun in 14..40_u32, planet in 16..50_u32, offset in -3..=3_i32, helix in prop_oneof![Just(0.0), 0.0..25.0_f64],
        ) {
            let profile = Profile { helix_angle: Angle::from_degrees(helix), ..Profile::default() };
            let Some(ring) = (sun + 2 * planet).checked_add_signed(offset) else { return Ok(()) };
            let closing = Closing { profiles: profile.into(), ..Closing::default() };
            let Ok(choice) = closing.close([count(sun), count(planet), count(ring)]) else { return Ok(()) };
            let set = choice.set;
            let [sun, planet, ring] = set.gears();
            let [sun, planet] = [sun, planet].map(|gear| ToothCurve::new(*gear).unwrap());
            let Ok(ring) = by_shaper(*ring, shaper((ring.teeth().get() - planet.gear().teeth().get()).min(30), 0.1)) else {
                return Ok(());
            };
            for (pair, curves) in [(set.sun_mesh(), [&sun, &planet]), (set.ring_mesh(), [&planet, &ring])] {
                let by_curves = contact_ratio_by_curves(pair, curves);
                // A shaper may leave a ring less involute than the rack that the formulas take; then tips
                // reach into its fillets.
                let reach = pair.mate(curves[0].gear().curvature_radius(2.0 * curves[0].tip_radius()));
                if pair.is_internal() && reach > curves[1].gear().curvature_radius(2.0 * curves[1].joint_radius()) {
                    prop_assert!(by_curves <= pair.transverse_contact_ratio() + 1e-3);
                    continue;
                }
                prop_assert!((by_curves - pair.transverse_contact_ratio()).abs() < 1e-3, "{by_curves} {}", pair.transverse_contact_ratio());
                let deepest = overlap(pair, curves);
                // Without backlash flanks touch; numbers of steps see them within some thousandths.
                prop_assert!(deepest < 1e-6, "{deepest}");
                prop_assert!(deepest > -0.02, "{deepest}");
            }
        }
    }

    /// Two gears closer than their shifts allow, and a ring whose tips reach into the fillets of its pinion:
    /// the curves overlap.
    #[test]
    fn faults_are_seen_on_the_curves() {
        let set = Closing::default().close([count(21), count(43), count(107)]).unwrap().set;
        let [_, planet, ring] = set.gears();
        let long = ring.with_tip_alteration(0.15).unwrap();
        let pair = Pair::at_centre_distance(*planet, long, set.centre_distance()).unwrap();
        let found =
            crate::involute::PlanetSet::new([*set.gears()[0], *planet, long], 3, set.centre_distance())
                .unwrap();
        let faults = found.faults(&Limits::default());
        assert!(faults.iter().any(|fault| fault.rule == Rule::Fillet), "{faults:?}");
        let curves = [ToothCurve::new(*planet).unwrap(), by_shaper(long, shaper(30, 0.1)).unwrap()];
        let deepest = overlap(&pair, [&curves[0], &curves[1]]);
        assert!(deepest > 1e-4, "{deepest}");
    }
}

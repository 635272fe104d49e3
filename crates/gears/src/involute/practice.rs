//! Rules of practice for gears and meshes: values for the judge.
//!
//! | rule | value |
//! |---|---|
//! | shift of a gear | `x`; [`SunShift`](Rule::SunShift) and the others by its role |
//! | [`SpecificSliding`](Rule::SpecificSliding) | greatest `∣ζ∣` of both gears, at tip and root |
//! | [`ExternalAngle`](Rule::ExternalAngle), [`InternalAngle`](Rule::InternalAngle) | `α_wt` in °, against bounds that move with `α_t` |
//! | [`ShiftSum`](Rule::ShiftSum) | `x_1 + x_2` of an external mesh |
//! | [`SpurContact`](Rule::SpurContact) | `ε_α` of spur gears |
//! | [`RootClearance`](Rule::RootClearance) | clearance between tips and roots of the mate, in modules |
//! | [`FaceLoad`](Rule::FaceLoad) | `K_Hβ` against `1 + 0.4·(b/d_1)²`, by [`width_diameters`] |
//! | [`HelicalContact`](Rule::HelicalContact) | `ε_α + ε_β` of helical gears |
//! | [`NeighbourGap`](Rule::NeighbourGap) | gap between the tips of neighbouring planets, in modules and in mm |

use super::gear::InvoluteGear;
use super::pair::Pair;
use crate::gear_kind::GearKind;
use crate::life::Rolling;
use crate::mesh::TipCircle;
use epicyclic_judge::{Limits, Rule, Severity, Verdict};
use std::f64::consts::TAU;

/// Teeth by which a ring exceeds its planet at most where shifts beyond 1 are usual.
const CLOSE_TEETH: u32 = 6;

/// Pressure angle for which the usual working angles are stated, in degrees.
const USUAL_ANGLE_DEG: f64 = 20.0;

/// Rule for the shift of a gear: of a planet, of another gear of a planetary set, or of a pair.
#[must_use]
pub const fn shift_rule(gear: &InvoluteGear, is_planet: bool, is_of_pair: bool) -> Rule {
    match (is_of_pair, is_planet, gear.kind()) {
        (true, ..) => Rule::GearShift,
        (_, true, _) => Rule::PlanetShift,
        (.., GearKind::Internal) => Rule::RingShift,
        (.., GearKind::External) => Rule::SunShift,
    }
}

/// Judges the shift of a gear, and its tips where they are case-hardened; `meshes` are those of the gear.
///
/// An internal mesh of nearly equal gears closes only with large shifts: they are no error then.
#[must_use]
pub fn of_gear<'p>(
    limits: &Limits,
    rule: Rule,
    gear: &InvoluteGear,
    mut meshes: impl Iterator<Item = &'p Pair>,
    is_hardened: bool,
) -> Vec<Verdict> {
    let shift = limits.judge(rule, gear.shift());
    let is_close = meshes.any(|pair| {
        let [one, other] = pair.gears().map(|gear| gear.teeth().get());
        pair.is_internal() && other.abs_diff(one) <= CLOSE_TEETH
    });
    let shift = if is_close { shift.no_worse_than(Severity::Warning) } else { shift };
    let tips = is_hardened.then(|| limits.judge(Rule::HardenedTips, gear.tip_thickness()));
    [shift].into_iter().chain(tips).collect()
}

/// Judges a mesh; each verdict with the gear it is of, or of both.
#[must_use]
pub fn of_mesh(limits: &Limits, pair: &Pair) -> Vec<(Option<usize>, Verdict)> {
    let [one, other] = pair.gears();
    let sliding = pair.specific_sliding().into_iter().flatten().map(f64::abs).fold(0.0, f64::max);
    let moved = one.profile().transverse_angle_rad().to_degrees() - USUAL_ANGLE_DEG;
    let angle = if pair.is_internal() { Rule::InternalAngle } else { Rule::ExternalAngle };
    let mut all = vec![
        (None, limits.judge(Rule::SpecificSliding, sliding)),
        (None, limits.judge_by(angle, angle.bounds().moved(moved), pair.working_angle_rad().to_degrees())),
    ];
    if !pair.is_internal() {
        all.push((None, limits.judge(Rule::ShiftSum, one.shift() + other.shift())));
    }
    if !one.profile().is_helical() {
        all.push((None, limits.judge(Rule::SpurContact, pair.transverse_contact_ratio())));
    }
    let clearances = pair.tip_clearances().into_iter().enumerate();
    all.extend(clearances.map(|(gear, value)| (Some(gear), limits.judge(Rule::RootClearance, value))));
    all
}

/// Reference diameter in modules of the smaller gear of each mesh whose face width is judged by it; `None` of
/// internal meshes whose smaller gear has an external mesh too, which is judged in place of them.
#[must_use]
pub fn width_diameters<G: PartialEq>(meshes: &[([G; 2], &Pair)]) -> Vec<Option<f64>> {
    let has_external =
        |gear: &G| meshes.iter().any(|(gears, pair)| !pair.is_internal() && gears.contains(gear));
    let diameter = |(gears, pair): &([G; 2], &Pair)| {
        let [one, other] = pair.gears().map(|gear| gear.reference_diameter());
        let smaller = &gears[usize::from(other < one)];
        (!pair.is_internal() || !has_external(smaller)).then(|| one.min(other))
    };
    meshes.iter().map(diameter).collect()
}

/// Least face load factor `K_Hβ = 1 + 0.4·(b/d)²` where it is not calculated, by the width ratio `b/d` of the
/// mesh.
#[must_use]
pub fn least_face_load(width_ratio: f64) -> f64 {
    1.0 + 0.4 * width_ratio * width_ratio
}

/// Judges a face load factor `K_Hβ` that is given, by the width ratio of the mesh.
#[must_use]
pub fn of_face_load(limits: &Limits, width_ratio: f64, given: f64) -> Verdict {
    limits.judge_least(Rule::FaceLoad, least_face_load(width_ratio), given)
}

/// Judges the total contact ratio of helical gears; the face width is in modules.
#[must_use]
pub fn of_total_contact(limits: &Limits, pair: &Pair, face_width: f64) -> Option<Verdict> {
    let total = || pair.transverse_contact_ratio() + pair.overlap_ratio(face_width);
    let is_helical = pair.gears()[0].profile().is_helical();
    is_helical.then(|| limits.judge(Rule::HelicalContact, total()))
}

/// Judges the gap between the tips of neighbouring planets at an angle from one to the next; the radius of
/// their centres is in modules. Without a module only the gap in modules is judged.
#[must_use]
pub fn of_gap(
    limits: &Limits,
    planet: &InvoluteGear,
    centre_radius: f64,
    angle_rad: f64,
    module_m: Option<f64>,
) -> Vec<Verdict> {
    let circle = TipCircle { centre_radius, tip_radius: planet.tip_diameter() / 2.0 };
    let gap = circle.gap(circle, angle_rad);
    let length = module_m.map(|module| limits.judge(Rule::NeighbourGapLength, 1e3 * gap * module));
    [limits.judge(Rule::NeighbourGap, gap)].into_iter().chain(length).collect()
}

/// Judges the pitch-line speed of a mesh, in m/s.
#[must_use]
pub fn of_speed(limits: &Limits, pair: &Pair, speed_m_s: f64) -> Verdict {
    let is_helical = pair.gears()[0].profile().is_helical();
    limits.judge(if is_helical { Rule::HelicalSpeed } else { Rule::SpurSpeed }, speed_m_s)
}

/// Acceleration of gravity, m/s².
const GRAVITY: f64 = 9.806_65;

/// Acceleration of planets about the axis, in g.
#[must_use]
pub fn orbit_acceleration(radius_m: f64, carrier_rad_s: f64) -> f64 {
    radius_m * carrier_rad_s * carrier_rad_s / GRAVITY
}

/// Speed of a bearing times its mean diameter, in mm/min: revolutions a minute times mm.
#[must_use]
pub fn pin_speed(speed_rad_s: f64, mean_diameter_m: f64) -> f64 {
    speed_rad_s * 60.0 / TAU * 1e3 * mean_diameter_m
}

/// Rule for the speed of a bearing on its pin; `None` of plain bearings, whose film grows with it.
#[must_use]
pub const fn pin_speed_rule(rolling: Rolling) -> Option<Rule> {
    match rolling {
        Rolling::Balls | Rolling::Rollers | Rolling::Needles => Some(Rule::PinSpeed),
        Rolling::FullComplement => Some(Rule::FullPinSpeed),
        Rolling::Plain => None,
    }
}

/// Rule for the acceleration of the planets about the axis; `None` of plain bearings, which have no rolling
/// elements.
#[must_use]
pub const fn orbit_rule(rolling: Rolling) -> Option<Rule> {
    match rolling {
        Rolling::Balls | Rolling::Rollers | Rolling::FullComplement => Some(Rule::OrbitAcceleration),
        Rolling::Needles => Some(Rule::NeedleAcceleration),
        Rolling::Plain => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ToothCount;
    use crate::involute::Profile;

    fn gear(kind: GearKind, teeth: u32, shift: f64) -> InvoluteGear {
        InvoluteGear::new(kind, ToothCount::new(teeth).unwrap(), Profile::default(), shift).unwrap()
    }

    /// Gears without shift hold but for the sliding of a small pinion; a ring of −1.3 is refused.
    #[test]
    fn gears_are_judged_as_an_engineer_would() {
        let limits = Limits::default();
        let pair = |one, other| Pair::without_backlash(one, other).unwrap();
        let plain = pair(gear(GearKind::External, 30, 0.0), gear(GearKind::External, 40, 0.0));
        assert!(of_mesh(&limits, &plain).iter().all(|(_, one)| one.severity < Some(Severity::Warning)));
        let pinion = pair(gear(GearKind::External, 18, 0.0), gear(GearKind::External, 90, 0.0));
        let worst = of_mesh(&limits, &pinion).into_iter().max_by_key(|(_, one)| one.severity).unwrap();
        assert_eq!((worst.1.rule, worst.1.severity), (Rule::SpecificSliding, Some(Severity::Warning)));
        let ring = gear(GearKind::Internal, 90, -1.3);
        let rule = shift_rule(&ring, false, false);
        let worst = |meshes: &[Pair]| of_gear(&limits, rule, &ring, meshes.iter(), false)[0].severity;
        assert_eq!(worst(&[]), Some(Severity::Error));
        let close = pair(gear(GearKind::External, 86, 1.2), ring);
        assert_eq!(worst(&[close]), Some(Severity::Warning));
    }

    /// The width counts over the sun, and over the pinion of a ring that no external mesh has.
    #[test]
    fn each_pinion_has_a_width() {
        let [sun, planet, ring] = [
            gear(GearKind::External, 20, 0.0),
            gear(GearKind::External, 30, 0.0),
            gear(GearKind::Internal, 80, 0.0),
        ];
        let [outer, inner] =
            [(sun, planet), (planet, ring)].map(|(one, other)| Pair::without_backlash(one, other).unwrap());
        let both = width_diameters(&[(["sun", "planet"], &outer), (["planet", "ring"], &inner)]);
        assert_eq!(both, [Some(20.0), None]);
        assert_eq!(width_diameters(&[(["planet", "ring"], &inner)]), [Some(30.0)]);
        let stepped = width_diameters(&[(["sun", "large"], &outer), (["small", "ring"], &inner)]);
        assert_eq!(stepped, [Some(20.0), Some(30.0)]);
    }
}

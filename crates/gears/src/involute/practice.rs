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

use super::gear::InvoluteGear;
use super::pair::Pair;
use crate::gear_kind::GearKind;
use epicyclic_judge::{Limits, Rule, Severity, Verdict};

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

/// Judges the shift of a gear; `meshes` are those of the gear.
///
/// An internal mesh of nearly equal gears closes only with large shifts: they are no error then.
#[must_use]
pub fn of_shift<'p>(
    limits: &Limits,
    rule: Rule,
    gear: &InvoluteGear,
    mut meshes: impl Iterator<Item = &'p Pair>,
) -> Verdict {
    let verdict = limits.judge(rule, gear.shift());
    let is_close = meshes.any(|pair| {
        let [one, other] = pair.gears().map(|gear| gear.teeth().get());
        pair.is_internal() && other.abs_diff(one) <= CLOSE_TEETH
    });
    if is_close { verdict.no_worse_than(Severity::Warning) } else { verdict }
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
        assert_eq!(of_shift(&limits, rule, &ring, [].iter()).severity, Some(Severity::Error));
        let close = pair(gear(GearKind::External, 86, 1.2), ring);
        assert_eq!(of_shift(&limits, rule, &ring, [close].iter()).severity, Some(Severity::Warning));
    }
}

//! Tests of the bending at the roots.

use super::*;
use crate::MotorNumbers;
use crate::flanks::forces::tests::{mm, motor, mpa};
use crate::flanks::sealing::tests::any_profile;
use crate::flanks::slow;
use crate::flanks::stress::tests::steel;
use crate::profile::ToothForm;
use crate::profile::{Loading, Tooth};
use epicyclic_units::Physical;
use proptest::prelude::*;

/// Bending stress of a force of 1 on a width of 1, and the thickness of the section.
fn bending(tooth: &Tooth, (at, force): Loading) -> (f64, f64) {
    let mut worst = (0.0, 0.0);
    for section in tooth.sections.iter().filter(|section| section.x < at[0]) {
        // Above where the line of action crosses the middle line the moment has the other sign.
        let moment = ((at[0] - section.x) * force[1] - (at[1] - section.y) * force[0]) * force[1].signum();
        let stress = 6.0 * moment / (section.thickness * section.thickness);
        if stress > worst.0 {
            worst = (stress, section.thickness);
        }
    }
    worst
}

/// The worst of the satellites by a crest, or by a trough, on a wheel and on the satellite, the plain way:
/// each tooth drawn, each stress for itself along the arc, by golden sections and division by each thickness.
fn plain_bent(profile: &Profile, side: Side, path: LoadedPath, crest: bool) -> Option<[f64; 2]> {
    let motor = profile.motor();
    let (alpha, r) = (pressure_angle(profile.form().pressure_angle).unwrap(), motor.shape.satellite_radius());
    let (own, teeth) = (profile.satellite_tooth(POINTS), profile.wheel_teeth_one_by_one(side, POINTS));
    let sigma = Motor::push(crest, 1.0);
    let stretches: Vec<Stretch> = profile.stretches(side, sigma, crest);
    // Along the arc from corner to corner of the load.
    let corners: Vec<f64> = motor.corners(crest).iter().map(|contact| contact.get(arc(side))).collect();
    let (mut pieces, mut flanks) = (vec![], vec![]);
    for stretch in stretches.iter().filter(|stretch| stretch.on(path)[0] < stretch.on(path)[1]) {
        let [from, to] = stretch.on(path);
        let mut ends = vec![from];
        ends.extend(corners.iter().filter(|&&corner| corner > from && corner < to));
        ends.push(to);
        for pair in ends.windows(2) {
            pieces.push([pair[0], pair[1]]);
            flanks.push(stretch);
        }
    }
    if flanks.is_empty() {
        return None;
    }
    let number = |s: f64| flank_number(r, alpha, &motor.shape.at(arc(side), s), sigma).unwrap_or(f64::NAN);
    let on_wheel = |piece: usize, s: f64| {
        let flank = flanks[piece];
        let (index, lobe) = profile.tooth_of(side, flank.sign, flank.pitch);
        let tooth = &teeth[index];
        bending(tooth, profile.wheel_loading(side, tooth, flank.sign, flank.pitch - lobe, s - lobe)).0
    };
    let on_satellite = |piece: usize, s: f64| {
        let flank = flanks[piece];
        bending(&own, profile.satellite_loading(flank.sign * (s - flank.pitch) * profile.teeth().cos)).0
    };
    let wheel = slow::greatest_of(&pieces, 0.0, |piece, s| number(s) * on_wheel(piece, s)).2;
    Some([wheel, slow::greatest_of(&pieces, 0.0, |piece, s| number(s) * on_satellite(piece, s)).2])
}

fn limits() -> MaterialLimits {
    MaterialLimits { contact: mpa(1500.0), root: mpa(400.0), modulus: steel(206.0) }
}

fn profile(module: f64) -> Profile {
    let numbers = MotorNumbers::new(5, 3, 55, 10).unwrap();
    let motor = Motor::of_two_arcs(numbers, mm(module), mm(40.0 * module)).unwrap();
    Profile::new(&motor, ToothForm::default()).unwrap()
}

#[test]
fn more_points_change_the_stress_by_less_than_a_thousandth() {
    for numbers in [(5, 3, 55, 10), (6, 4, 66, 10)] {
        let profile = Profile::new(&motor(numbers, 1.0, 40.0), ToothForm::default()).unwrap();
        for path in [LoadedPath::Whole, LoadedPath::SingleContact] {
            let (coarse, fine) =
                (profile.bent(path, POINTS).unwrap(), profile.bent(path, 40 * POINTS).unwrap());
            assert_eq!(coarse.len(), 3);
            for ((wheel, coarse), (_, fine)) in coarse.into_iter().zip(fine) {
                assert!((coarse.stress / fine.stress - 1.0).abs() < 1e-3, "{wheel:?} {coarse:?} {fine:?}");
            }
        }
    }
}

/// The section of ISO 6336-3, where the fillet's tangent is at 30° to the middle line, with the load in the
/// same place: from points of the outline, and the lever to where the line of action crosses the middle line.
#[test]
fn the_satellites_stress_is_near_that_of_the_thirty_degree_tangent() {
    let profile = profile(1.0);
    let outline: Vec<[f64; 2]> = (0..=4000).map(|i| profile.satellite.on(4, f64::from(i) / 4000.0)).collect();
    let tangent = outline.windows(2).find(|ends| {
        let (dx, dy) = (ends[0][0] - ends[1][0], ends[1][1] - ends[0][1]);
        dy >= dx * libm::tan(30.0_f64.to_radians())
    });
    let [x, y] = tangent.unwrap()[0];
    let tooth = profile.satellite_tooth(400);
    for e in [-1.8, -1.0, 0.0] {
        let (at, force) = profile.satellite_loading(e);
        let crossing = at[0] - at[1] * force[0] / force[1];
        let thirty = 6.0 * (crossing - x) * force[1].abs() / (4.0 * y * y);
        let (lewis, _) = bending(&tooth, (at, force));
        // Lewis seeks the greatest: never less, and more by some per cent.
        assert!(lewis >= thirty * (1.0 - 1e-6) && lewis < 1.1 * thirty, "{e} {lewis} {thirty}");
    }
}

/// A tooth with straight sides, a wedge cut at its base: the moment over the section's modulus by hand.
#[test]
fn the_place_of_a_load_is_a_point_of_the_drawn_flank() {
    let profile = profile(1.0);
    for side in Side::BOTH {
        let teeth = profile.wheel_teeth(side, 200);
        for sigma in [1.0, -1.0] {
            for stretch in profile.stretches(side, sigma, sigma > 0.0) {
                let (index, lobe) = profile.tooth_of(side, stretch.sign, stretch.pitch);
                let s = 0.5 * (stretch.whole[0] + stretch.whole[1]);
                let (at, force) =
                    profile.wheel_loading(side, &teeth[index], stretch.sign, stretch.pitch - lobe, s - lobe);
                let near = teeth[index]
                    .sections
                    .iter()
                    .min_by(|a, b| (a.x - at[0]).abs().total_cmp(&(b.x - at[0]).abs()))
                    .unwrap();
                let half = (at[1] - near.y).abs();
                assert!((half - 0.5 * near.thickness).abs() < 0.02, "{side:?} {half} {near:?}");
                // The force presses into the tooth and towards its root, and is a unit vector.
                assert!((libm::hypot(force[0], force[1]) - 1.0).abs() < 1e-12);
                assert!(force[1] * (at[1] - near.y) < 0.0, "{side:?} {force:?} {at:?}");
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10))]

    #[test]
    fn the_stresses_are_those_of_the_plain_way(profile in any_profile(), alone in any::<bool>()) {
        let path = if alone { LoadedPath::SingleContact } else { LoadedPath::Whole };
        let fast = profile.bent(path, POINTS);
        prop_assume!(fast.is_ok());
        let mut slow = [None::<f64>; 3];
        for (i, side) in Side::BOTH.into_iter().enumerate() {
            for plain in [true, false].into_iter().filter_map(|crest| plain_bent(&profile, side, path, crest)) {
                for (slot, value) in [i, 2].into_iter().zip(plain) {
                    slow[slot] = Some(slow[slot].map_or(value, |before| before.max(value)));
                }
            }
        }
        let slow: Vec<f64> = slow.into_iter().flatten().collect();
        let fast = fast.unwrap();
        prop_assert_eq!(fast.len(), slow.len());
        for ((wheel, fast), slow) in fast.into_iter().zip(slow) {
            // The worst section goes from one point of the outline to the next: between such bumps, a tenth
            // of the thousandth that the points leave at most, either way may settle on the lower one.
            prop_assert!((fast.stress - slow).abs() <= 1e-4 * slow, "{wheel:?} {fast:?} {slow}");
        }
    }

    #[test]
    fn mirrored_teeth_are_those_drawn(profile in any_profile(), part in 0.0..0.3_f64) {
        for side in Side::BOTH {
            let (fast, slow) = (profile.wheel_teeth(side, POINTS), profile.wheel_teeth_one_by_one(side, POINTS));
            prop_assert_eq!(fast.len(), slow.len());
            for (fast, slow) in fast.into_iter().zip(slow) {
                // On the flank, a little above a section: one right at the load may count by rounding.
                let at = slow.sections[(part * slow.sections.len() as f64) as usize].x + 1e-6;
                let load = ([at, 0.3], [-0.3, 0.9]);
                let (one, other) = (fast.bending(load), bending(&slow, load).0);
                prop_assert!((one - other).abs() <= 1e-8 * other, "{side:?} {one} {other}");
                prop_assert!(fast.apart(&slow) < 1e-9, "{side:?} {}", fast.apart(&slow));
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn what_a_shape_allows_depends_on_neither_module_nor_width(module in 0.3..20.0, width in 1.0..200.0) {
        let (one, other) = (profile(1.0), profile(module));
        let [a, b] = [&one, &other].map(|profile| profile.allowed_pressure(LoadedPath::Whole, &limits()).unwrap());
        prop_assert!(((a.by_contact / b.by_contact).value - 1.0).abs() < 1e-9);
        prop_assert!(((a.by_root / b.by_root).value - 1.0).abs() < 1e-9);
        prop_assert_eq!(a.governing, b.governing);
        // By the forces on this width, the sections of this module, and Hertz with this width: the limits are
        // just met.
        let motor = other.motor();
        for allowed in [b.by_contact, b.by_root] {
            let stresses = other.root_stresses(LoadedPath::Whole, allowed).unwrap();
            let greatest = stresses.iter().map(|stress| stress.stress.mpa()).fold(0.0, f64::max);
            let hertz = other.contact_stresses(allowed, limits().modulus).unwrap();
            let pressure = hertz.iter().filter_map(|stress| stress.on_path).map(|peak| peak.pressure.mpa()).fold(0.0, f64::max);
            if allowed == b.by_root {
                prop_assert!((greatest - 400.0).abs() < 1e-6);
            } else {
                prop_assert!((pressure - 1500.0).abs() < 1e-6);
            }
        }
        // N, and with it 6·N·arm/(b·s²), by the width itself.
        let stress = other.root_stresses(LoadedPath::Whole, mpa(20.0)).unwrap()[2];
        let inside = stress.rotation * (1.0 - 1e-12);
        let contact = motor.shape.at(crate::contact::By::Phase, inside.si());
        let n = motor.flank_forces(other.form().pressure_angle, inside, mm(width), mpa(20.0)).unwrap()[0].force.value;
        let (unit, _) = bending(&other.satellite_tooth(POINTS), other.satellite_loading((stress.offset / motor.module()).value));
        let by_width = n * unit / (mm(width) * motor.module()).value;
        prop_assert!((by_width / stress.stress.value - 1.0).abs() < 1e-6, "{by_width} {:?} {contact:?}", stress.stress);
    }
}

#[test]
fn either_limit_governs_and_each_counts() {
    let profile = profile(1.0);
    let allowed = |contact, root| {
        let limits = MaterialLimits { contact: mpa(contact), root: mpa(root), ..limits() };
        profile.allowed_pressure(LoadedPath::SingleContact, &limits)
    };
    assert_eq!(allowed(1500.0, 400.0).unwrap().governing, Governing::Contact);
    let weak = allowed(1500.0, 40.0).unwrap();
    assert!(matches!(weak.governing, Governing::Root(_)) && weak.pressure == weak.by_root);
    // Unshared load alone allows more than the whole path.
    let whole = profile.allowed_pressure(LoadedPath::Whole, &limits()).unwrap();
    let single = allowed(1500.0, 400.0).unwrap();
    assert!(single.by_contact > whole.by_contact && single.by_root > whole.by_root);
    assert!(matches!(allowed(0.0, 400.0), Err(Error::NotPositive { quantity: Quantity::ContactLimit, .. })));
    assert!(matches!(allowed(1500.0, -1.0), Err(Error::NotPositive { quantity: Quantity::RootLimit, .. })));
    assert!(profile.root_stresses(LoadedPath::Whole, mpa(0.0)).is_err());
}

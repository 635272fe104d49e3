//! Tests of the third contact.

use super::*;
use crate::centrode::tests::any_motor;
use crate::flanks::forces::tests::{alpha, mm, motor, mpa};
use crate::flanks::kernel::direction;
use crate::flanks::sealing::tests::any_profile;
use crate::flanks::slow;
use crate::profile::Side;
use crate::profile::ToothForm;
use epicyclic_units::Physical;
use proptest::prelude::*;
use uom::si::f64::Angle;

#[test]
fn the_forces_of_the_derivation_are_met() {
    let motor = motor((6, 4, 66, 10), 1.0, 40.0);
    let held = motor
        .third_contact(alpha(), Angle::from_si(0.0), mm(-0.8), mm(0.9), mm(1.0), mpa(1.0))
        .unwrap()
        .unwrap();
    for (force, expected) in [(held.stator, 5.8806), (held.rotor, 7.3164), (held.back, 2.2098)] {
        assert!((force.si() - expected).abs() < 5e-5, "{held:?}");
    }
    assert_eq!((held.back_wheel, held.push), (Mesh::Rotor, Push::Forward));
    // With the offsets exchanged the stator's back flank holds it.
    let other = motor
        .third_contact(alpha(), Angle::from_si(0.0), mm(0.9), mm(-0.8), mm(1.0), mpa(1.0))
        .unwrap()
        .unwrap();
    assert_eq!(other.back_wheel, Mesh::Stator);
    assert!((other.back - held.back).si().abs() < 1e-12 && (other.stator - held.rotor).si().abs() < 1e-12);
    // Between ±π/N about the crest and the trough a satellite is idle.
    let idle = Angle::from_si(std::f64::consts::PI * (1.0 / 6.0 + 1.0 / 4.0) / 2.0);
    assert!(motor.third_contact(alpha(), idle, mm(0.0), mm(0.0), mm(1.0), mpa(1.0)).unwrap().is_none());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn three_flanks_and_the_pressure_leave_a_satellite_at_rest(
        motor in any_motor(), phase in -9.0..9.0, e3 in -1.2..1.2, e1 in -1.2..1.2, alpha_deg in 10.0..40.0, reversed in any::<bool>(),
    ) {
        let drop = if reversed { mpa(-1.0) } else { mpa(1.0) };
        let alpha = Angle::from_degrees(alpha_deg);
        let ask = |e3: f64, e1: f64| motor.third_contact(alpha, Angle::from_si(phase), motor.length(e3), motor.length(e1), mm(1e-3), drop);
        prop_assume!(ask(e3, e1).is_ok());
        let Some(held) = ask(e3, e1).unwrap() else { return Ok(()) };
        prop_assert!(held.back.si() >= 0.0);
        // In the stator's frame: forces in lines of action through the pitch points, turned from the tangents
        // by α.
        let place = motor.place_at(phase);
        let sigma = if held.push == Push::Forward { 1.0 } else { -1.0 };
        let line = |at: [f64; 2], outer: bool, sigma: f64| {
            let (x, y) = (place.centre[0] - at[0], place.centre[1] - at[1]);
            let r = libm::hypot(x, y);
            // From the pitch point towards the centre, turned by 90° − α towards where the flank pushes.
            let by = sigma * (std::f64::consts::FRAC_PI_2 - alpha.si()) * if outer { 1.0 } else { -1.0 };
            super::super::kernel::turned([x / r, y / r], by)
        };
        let (u3, u1) = (line(place.on_stator, true, sigma), line(place.on_rotor, false, sigma));
        let k3 = [place.on_stator[0] + e3 * u3[0], place.on_stator[1] + e3 * u3[1]];
        let k1 = [place.on_rotor[0] + e1 * u1[0], place.on_rotor[1] + e1 * u1[1]];
        let back = match held.back_wheel {
            Mesh::Stator => (place.on_stator, line(place.on_stator, true, -sigma)),
            Mesh::Rotor => (place.on_rotor, line(place.on_rotor, false, -sigma)),
        };
        let pressure = [-sigma * (k3[1] - k1[1]), sigma * (k3[0] - k1[0])];
        let middle = [0.5 * (k3[0] + k1[0]), 0.5 * (k3[1] + k1[1])];
        let scale = (held.stator + held.rotor + held.back).si();
        let loads = [
            (place.on_stator, u3, held.stator.si()),
            (place.on_rotor, u1, held.rotor.si()),
            (back.0, back.1, held.back.si()),
            (middle, pressure, 1.0),
        ];
        let (mut sum, mut moment) = ([0.0; 2], 0.0);
        for ([x, y], [fx, fy], force) in loads {
            sum = [sum[0] + force * fx, sum[1] + force * fy];
            moment += force * ((x - place.centre[0]) * fy - (y - place.centre[1]) * fx);
        }
        prop_assert!(libm::hypot(sum[0], sum[1]) < 1e-9 * scale && moment.abs() < 1e-8 * scale, "{sum:?} {moment} {held:?}");
    }

    #[test]
    fn at_the_pitch_points_no_third_flank_is_needed(motor in any_motor(), phase in -9.0..9.0) {
        let ask = motor.third_contact(alpha(), Angle::from_si(phase), mm(0.0), mm(0.0), mm(1.0), mpa(1.0));
        let forces = motor.flank_forces(alpha(), Angle::from_si(phase), mm(1.0), mpa(1.0));
        // Of a motor that holds all its satellites.
        prop_assume!(ask.is_ok() && forces.is_ok());
        let forces = forces.unwrap();
        if let Some(held) = ask.unwrap() {
            let two = forces[0].force.si();
            prop_assert!(held.back.si().abs() < 1e-9 * two, "{held:?}");
            prop_assert!((held.stator.si() - two).abs() < 1e-9 * two);
            prop_assert!((held.rotor.si() - two).abs() < 1e-9 * two);
        }
    }
}

#[test]
fn no_force_of_a_revolution_exceeds_its_bound() {
    for (numbers, rule) in
        [((6, 4, 66, 10), SealingContact::Nearest), ((5, 3, 55, 10), SealingContact::NearestInMesh)]
    {
        let motor = motor(numbers, 1.0, 40.0);
        let profile = Profile::new(&motor, ToothForm::default()).unwrap();
        let bounds = profile.third_contact_bounds(rule, mm(1.0), mpa(1.0)).unwrap();
        let (stator_back, rotor_back) = (bounds.stator_back.unwrap(), bounds.rotor_back.unwrap());
        let limits = [bounds.stator.force, bounds.rotor.force, stator_back.force, rotor_back.force];
        let mut seen = [Force::default(); 4];
        for i in 0..6000 {
            let rotation = Angle::from_si(motor.chamber_phase() * f64::from(i) / 6000.0);
            for held in
                profile.third_contacts(rule, rotation, mm(1.0), mpa(1.0)).unwrap().into_iter().flatten()
            {
                let slot = if held.back_wheel == Mesh::Stator { 2 } else { 3 };
                for (slot, force) in [(0, held.stator), (1, held.rotor), (slot, held.back)] {
                    seen[slot] = seen[slot].max(force);
                }
            }
        }
        for (seen, limit) in seen.into_iter().zip(limits) {
            assert!(seen <= limit * (1.0 + 1e-12) && seen > limit * 0.995, "{seen:?} {limit:?}");
        }
        // Reversed, everything is the mirror image.
        let reversed = profile.third_contact_bounds(rule, mm(1.0), mpa(-1.0)).unwrap();
        assert!((reversed.stator.force - bounds.stator.force).si().abs() < 1e-9);
        assert_ne!(reversed.stator.push, bounds.stator.push);
    }
}

/// Moment of such a force of 1 about the satellite's centre, over `r·cos α`.
fn moment(side: Side, sigma: f64) -> f64 {
    match side {
        Side::Stator => -sigma,
        Side::Rotor => sigma,
    }
}

/// `N₃`, `N₁`, and the force of the rotor's back flank, or with the sign changed of the stator's, over
/// `Δp·b·m`.
fn held(r: f64, alpha: f64, contact: &Contact, sigma: f64, [e3, e1]: [f64; 2]) -> Option<([f64; 3], Side)> {
    let mu = contact.mu;
    let (sin, cos) = libm::sincos(mu);
    let front = Side::BOTH.map(|side| direction(side, sigma, alpha, mu));
    let k3 = [r * cos + e3 * front[0][0], e3 * front[0][1]];
    let k1 = [-r * cos + e1 * front[1][0], e1 * front[1][1]];
    let chord = [k3[0] - k1[0], k3[1] - k1[1]];
    let force = [-sigma * chord[1], sigma * chord[0]];
    let arm = [0.5 * (k3[0] + k1[0]), 0.5 * (k3[1] + k1[1]) - r * sin];
    let turning = (arm[0] * force[1] - arm[1] * force[0]) / (r * libm::cos(alpha));
    let solved = |side: Side| {
        let back = direction(side, -sigma, alpha, mu);
        let columns = [
            [front[0][0], front[0][1], moment(Side::Stator, sigma)],
            [front[1][0], front[1][1], moment(Side::Rotor, sigma)],
            [back[0], back[1], moment(side, -sigma)],
        ];
        cramer(columns, [-force[0], -force[1], -turning])
    };
    let by_rotor = solved(Side::Rotor)?;
    if by_rotor[2] >= 0.0 {
        Some((by_rotor, Side::Rotor))
    } else {
        Some((solved(Side::Stator)?, Side::Stator))
    }
}

/// The solution of three equations by their columns.
fn cramer(columns: [[f64; 3]; 3], right: [f64; 3]) -> Option<[f64; 3]> {
    let determinant = |[a, b, c]: [[f64; 3]; 3]| {
        a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1])
            + c[0] * (a[1] * b[2] - a[2] * b[1])
    };
    let whole = determinant(columns);
    if whole.abs() < crate::tolerance::SINGULAR {
        return None;
    }
    Some([0, 1, 2].map(|i| {
        let mut replaced = columns;
        replaced[i] = right;
        determinant(replaced) / whole
    }))
}

/// The four greatest forces of the satellites by a crest, or by a trough, the plain way: each for itself,
/// over phases, by Cramer's rule.
fn plain_bounds(profile: &Profile, rule: SealingContact, alpha: f64, crest: bool) -> [f64; 4] {
    let (motor, sigma) = (profile.motor(), Motor::push(crest, 1.0));
    let r = motor.shape.satellite_radius();
    let rows = Rows::new(profile, sigma, rule);
    let forces = |seals: &[Seal; 2], phase: f64| {
        let contact = motor.shape.at(By::Phase, phase);
        let ([stator, rotor, back], side) = held(r, alpha, &contact, sigma, rows.offsets(seals, &contact))
            .unwrap_or(([f64::NAN; 3], Side::Rotor));
        match side {
            Side::Stator => [stator, rotor, back, -back],
            Side::Rotor => [stator, rotor, -back, back],
        }
    };
    let (mut pieces, mut seals) = (Vec::new(), Vec::new());
    for pair in rows.pieces(motor, By::Phase, motor.loaded(crest)).windows(2) {
        let sealing = rows.at(&motor.shape.at(By::Phase, 0.5 * (pair[0] + pair[1])));
        let back = |phase: f64| forces(&sealing, phase)[3];
        let change = (back(pair[0]) * back(pair[1]) < 0.0).then(|| bracketed(pair[0], pair[1], back));
        for ends in [pair[0]].into_iter().chain(change).chain([pair[1]]).collect::<Vec<_>>().windows(2) {
            pieces.push([ends[0], ends[1]]);
            seals.push(sealing);
        }
    }
    [0, 1, 2, 3].map(|i| slow::greatest_of(&pieces, 0.0, |piece, phase| forces(&seals[piece], phase)[i]).2)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn the_closed_form_is_cramers(
        motor in any_motor(), phase in -9.0..9.0, e3 in -1.2..1.2, e1 in -1.2..1.2, alpha in 0.2..0.7_f64, forward in any::<bool>(),
    ) {
        let (r, sigma) = (motor.shape.satellite_radius(), if forward { 1.0 } else { -1.0 });
        let contact = motor.shape.at(By::Phase, phase);
        prop_assume!(libm::cos(alpha + sigma * contact.mu) > 0.01);
        let (slow, side) = held(r, alpha, &contact, sigma, [e3, e1]).unwrap();
        let fast = Inclined::new(alpha).held(r, &contact, sigma, [e3, e1]).unwrap();
        let back = if side == Side::Stator { -slow[2] } else { slow[2] };
        let scale = slow[0].abs() + slow[1].abs() + r;
        for (fast, slow) in fast.into_iter().zip([slow[0], slow[1], back]) {
            prop_assert!((fast - slow).abs() < 1e-11 * scale, "{fast} {slow}");
        }
    }

    #[test]
    fn the_bounds_are_those_of_the_plain_way(profile in any_profile(), in_mesh in any::<bool>()) {
        let rule = if in_mesh { SealingContact::NearestInMesh } else { SealingContact::Nearest };
        let fast = profile.third_contact_bounds(rule, profile.motor().length(1.0), mpa(1.0));
        prop_assume!(fast.is_ok());
        let fast = fast.unwrap();
        let alpha = profile.form().pressure_angle.si();
        let [by_crest, by_trough] = [true, false].map(|crest| plain_bounds(&profile, rule, alpha, crest));
        let module = profile.motor().length(1.0);
        let load = Load::new(profile.form().pressure_angle, module, mpa(1.0)).unwrap();
        let found = [Some(fast.stator), Some(fast.rotor), fast.stator_back, fast.rotor_back];
        for (i, found) in found.into_iter().enumerate() {
            let slow = load.force(profile.motor(), by_crest[i].max(by_trough[i])).si();
            match found {
                Some(found) => {
                    let fast = found.force.si();
                    prop_assert!((fast - slow).abs() <= 1e-9 * fast, "{i} {fast} {slow}");
                }
                None => prop_assert!(slow <= 0.0),
            }
        }
    }
}

//! Kinds, energies and sensitivities of modes.

use crate::common::{body, degrees, groups, hz, lin_parker, n_m};
use epicyclic_vibration::{
    Axis, BodyId, Error, Freedom, Group, InertiaKind, Kind, Model, PlanetarySet, SetParts, SpringId, Support,
};
use proptest::prelude::*;

fn model() -> (PlanetarySet, Model, SetParts, Vec<Group>) {
    let set = lin_parker(4);
    let (model, parts) = set.planar().unwrap();
    let groups = model.groups(&parts.central()).unwrap();
    (set, model, parts, groups)
}

#[test]
fn shares_of_energy_add_up_to_one() {
    let (_, model, _, groups) = model();
    for group in &groups {
        let energy = model.modal_energy(group).unwrap();
        let kinetic: f64 = energy.kinetic.iter().map(|share| share.translation + share.rotation).sum();
        let strain: f64 = energy.strain.iter().map(|share| share.share).sum();
        assert!((kinetic - 1.0).abs() < 1e-12, "{kinetic}");
        let whole = if group.is_zero() { 0.0 } else { 1.0 };
        assert!((strain - whole).abs() < 1e-9, "{strain} at {} Hz", hz(group.frequency));
    }
}

/// Only planets move in a planet mode, and the supports carry nothing; in a rotational mode no radial support
/// has energy.
#[test]
fn energy_is_where_the_kind_of_the_mode_says() {
    let (_, model, parts, groups) = model();
    for group in &groups {
        let energy = model.modal_energy(group).unwrap();
        let central = parts
            .central()
            .map(|body| energy.kinetic[energy.kinetic.iter().position(|k| k.body == body).unwrap()]);
        let [translation, rotation] = [
            central.iter().map(|share| share.translation).sum::<f64>(),
            central.iter().map(|share| share.rotation).sum::<f64>(),
        ];
        let supports: f64 = energy
            .strain
            .iter()
            .filter(|share| model.spring_name(share.spring).unwrap().starts_with("support along"))
            .map(|share| share.share)
            .sum();
        match group.kind {
            Kind::Rotational => assert!(translation < 1e-18 && rotation > 1e-3 && supports < 1e-18),
            Kind::Translational => assert!(rotation < 1e-18 && translation > 1e-3 && supports > 1e-6),
            _ => assert!(rotation + translation + supports < 1e-18),
        }
    }
}

/// Frequencies of a group after all stiffnesses of `springs` grew by `1 + by`, or inertias of bodies.
fn changed(set: &PlanetarySet, change: impl Fn(&mut PlanetarySet, f64), by: f64) -> Vec<f64> {
    let mut set = set.clone();
    change(&mut set, 1.0 + by);
    let (model, _) = set.planar().unwrap();
    model.modes().unwrap().modes.iter().map(|mode| hz(mode.frequency)).collect()
}

fn compare(
    change: impl Fn(&mut PlanetarySet, f64) + Copy,
    sensitivity: impl Fn(&Model, &SetParts, &Group) -> Vec<f64>,
) {
    let (set, model, parts, groups) = model();
    let step = 1e-4;
    let [up, down] = [step, -step].map(|by| changed(&set, change, by));
    let mut first = 0;
    for group in &groups {
        let found = sensitivity(&model, &parts, group);
        assert_eq!(found.len(), group.multiplicity());
        if group.is_zero() {
            assert!(found.iter().all(|value| *value == 0.0));
        } else {
            // Where the change splits a double frequency, the lower one of a decrease belongs to the higher
            // of an increase.
            let last = first + group.multiplicity() - 1;
            for (index, found) in found.iter().enumerate() {
                let slope = (up[first + index] - down[last - index]) / (2.0 * step * hz(group.frequency));
                assert!((slope - found).abs() < 1e-6, "{slope} for {found} at {} Hz", hz(group.frequency));
            }
        }
        first += group.multiplicity();
    }
}

#[test]
fn sensitivities_to_stiffness_are_the_slopes_of_the_frequencies() {
    compare(
        |set, by| set.planets.iter_mut().for_each(|planet| planet.sun_mesh *= by),
        |model, parts, group| model.stiffness_sensitivity(group, &parts.sun_meshes).unwrap(),
    );
    compare(
        |set, by| set.planets[1].ring_mesh *= by,
        |model, parts, group| model.stiffness_sensitivity(group, &parts.ring_meshes[1..2]).unwrap(),
    );
    compare(
        |set, by| set.planets[2].bearing *= by,
        |model, parts, group| model.stiffness_sensitivity(group, &parts.bearings[2]).unwrap(),
    );
    compare(
        |set, by| set.ring.support.tangential *= by,
        |model, parts, group| model.stiffness_sensitivity(group, &parts.supports[1][2..]).unwrap(),
    );
}

#[test]
fn sensitivities_to_inertia_are_the_slopes_of_the_frequencies() {
    compare(
        |set, by| set.carrier.body.inertia *= by,
        |model, parts, group| {
            model.inertia_sensitivity(group, &[parts.carrier], InertiaKind::Rotary).unwrap()
        },
    );
    compare(
        |set, by| set.sun.body.mass *= by,
        |model, parts, group| model.inertia_sensitivity(group, &[parts.sun], InertiaKind::Mass).unwrap(),
    );
    compare(
        |set, by| set.planets[0].body.mass *= by,
        |model, parts, group| {
            model.inertia_sensitivity(group, &parts.planets[..1], InertiaKind::Mass).unwrap()
        },
    );
}

/// A rotating and a translating disc of one frequency are one subspace, and any of its bases mixes both.
#[test]
fn a_frequency_that_kinds_share_by_chance_is_split_into_them() {
    let mut model = Model::new();
    let disc = model.body("disc", &body(2.0, 3.0, 0.1), Freedom::Planar).unwrap();
    let idler = model.body("idler", &body(1.0, 1.0, 0.1), Freedom::Rotation).unwrap();
    model.support(disc, Support { radial: n_m(2e6), tangential: n_m(3e6) }).unwrap();
    model.support(idler, Support { radial: n_m(0.0), tangential: n_m(1e6) }).unwrap();
    let modes = model.modes().unwrap();
    assert_eq!(modes.equal.len(), 1);
    let groups = model.groups(&[disc]).unwrap();
    let found: Vec<_> = groups.iter().map(|group| (group.kind, group.multiplicity())).collect();
    assert_eq!(found, [(Kind::Rotational, 1), (Kind::Translational, 2), (Kind::Planet, 1)]);
    for group in &groups {
        assert!((group.omega.value - 1000.0).abs() < 1e-9);
        let energy = model.modal_energy(group).unwrap();
        let own = match group.kind {
            Kind::Rotational => energy.kinetic[0].rotation,
            Kind::Translational => energy.kinetic[0].translation,
            _ => energy.kinetic[1].rotation,
        };
        assert!((own - 1.0).abs() < 1e-12, "{own}");
    }
}

#[test]
fn a_direction_that_rotates_and_translates_is_mixed() {
    let mut model = Model::new();
    let disc = model.body("disc", &body(2.0, 3.0, 0.1), Freedom::Planar).unwrap();
    model.support(disc, Support { radial: n_m(2e6), tangential: n_m(4e6) }).unwrap();
    model.spring("strut", n_m(1e6), &[(disc, Axis::X, 1.0), (disc, Axis::Rotation, 1.0)]).unwrap();
    let kinds: Vec<_> = model.groups(&[disc]).unwrap().iter().map(|group| group.kind).collect();
    assert_eq!(kinds.iter().filter(|kind| **kind == Kind::Mixed).count(), 2);
    assert_eq!(kinds.iter().filter(|kind| **kind == Kind::Translational).count(), 1);
}

#[test]
fn faults_of_input_are_named() {
    let fault = |change: fn(&mut PlanetarySet)| {
        let mut set = lin_parker(3);
        change(&mut set);
        let error = set.planar().unwrap_err();
        (error.name(), error.to_string())
    };
    let (name, text) = fault(|set| set.planets[1].body.mass *= -1.0);
    assert_eq!(
        (name, text.as_str()),
        ("not-positive", "mass of planet 2 is -0.66 kg; it must be finite and above 0")
    );
    let (name, text) = fault(|set| set.sun.support.radial *= f64::NAN);
    assert_eq!(name, "negative");
    assert!(text.starts_with("stiffness of support along x of sun is NaN N/m"), "{text}");
    assert_eq!(fault(|set| set.planets.clear()).0, "too-few");
    assert_eq!(fault(|set| set.planets[2].angle = degrees(480.0)).0, "out-of-range");
    let (name, text) = fault(|set| set.planets[2].angle = degrees(-240.0));
    assert_eq!(name, "same-angle");
    assert!(text.starts_with("planets 2 and 3"), "{text}");
    assert_eq!(fault(|set| set.ring_pressure_angle = degrees(95.0)).0, "out-of-range");
    assert_eq!(fault(|set| set.planets[0].ring_mesh *= 0.0).0, "not-positive");

    assert_eq!(Model::new().modes().unwrap_err(), Error::NothingMoves);
    let (_, small, ..) = model();
    let mut other = Model::new();
    let disc = other.body("disc", &body(1.0, 1.0, 0.1), Freedom::Planar).unwrap();
    let foreign: Vec<BodyId> = small.bodies().skip(5).collect();
    assert_eq!(other.groups(&foreign).unwrap_err().name(), "no-such-body");
    assert_eq!(
        other.spring("x", n_m(1.0), &[(foreign[0], Axis::X, 1.0)]).unwrap_err().name(),
        "no-such-body"
    );
    assert_eq!(other.spring("x", n_m(1.0), &[(disc, Axis::X, f64::NAN)]).unwrap_err().name(), "out-of-range");
    let group = &groups(&lin_parker(3))[1];
    assert_eq!(other.modal_energy(group).unwrap_err().name(), "count");
    let springs: Vec<SpringId> = small.springs().collect();
    assert_eq!(
        other.elongation(springs[0], &other.modes().unwrap().modes[0].shape).unwrap_err().name(),
        "no-such-spring"
    );
}

fn sets() -> impl Strategy<Value = PlanetarySet> {
    let exponent = 6.0_f64..10.0;
    let masses = proptest::collection::vec(-1.0_f64..1.0, 8);
    (2_usize..7, masses, proptest::collection::vec(exponent, 8), 5.0_f64..35.0, 5.0_f64..35.0, 0.0_f64..0.8)
        .prop_map(|(count, masses, springs, alpha_s, alpha_r, uneven)| {
            let mut set = lin_parker(count);
            let mass = |index: usize| libm::pow(10_f64, masses[index]);
            let spring = |index: usize| n_m(libm::pow(10_f64, springs[index]));
            set.sun.body = body(mass(0), mass(1), 0.04);
            set.ring.body = body(mass(2), mass(3), 0.15);
            set.carrier.body = body(mass(4), mass(5), 0.1);
            set.sun.support.radial = spring(0);
            set.ring.support = Support { radial: spring(1), tangential: spring(2) };
            set.carrier.support.radial = spring(3);
            for (index, planet) in set.planets.iter_mut().enumerate() {
                planet.body = body(mass(6), mass(7), 0.05);
                planet.bearing = spring(4);
                planet.sun_mesh = spring(5) * (1.0 + 0.1 * uneven * index as f64);
                planet.ring_mesh = spring(6);
                planet.angle += degrees(10.0 * uneven * libm::sin(index as f64));
            }
            set.sun_pressure_angle = degrees(alpha_s);
            set.ring_pressure_angle = degrees(alpha_r);
            set
        })
}

proptest! {
    #[test]
    fn modes_are_orthogonal_and_their_rayleigh_quotients_are_the_frequencies(set in sets()) {
        let (model, _) = set.planar().unwrap();
        let (k, m) = (model.stiffness_matrix_n_per_m(), model.mass_matrix_diagonal_kg());
        let modes = model.modes().unwrap().modes;
        let largest = modes.last().unwrap().omega.value.powi(2);
        let q: Vec<Vec<f64>> = modes.iter().map(|mode| flat(&model, mode)).collect();
        for (a, one) in q.iter().enumerate() {
            let forces: Vec<f64> = k.iter().map(|row| row.iter().zip(one).map(|(k, q)| k * q).sum()).collect();
            for (b, other) in q.iter().enumerate() {
                let product: f64 = m.iter().zip(one).zip(other).map(|((m, a), b)| m * a * b).sum();
                prop_assert!((product - f64::from(u8::from(a == b))).abs() < 1e-12, "{product}");
                let strain: f64 = forces.iter().zip(other).map(|(f, q)| f * q).sum();
                let expected = if a == b { modes[a].omega.value.powi(2) } else { 0.0 };
                prop_assert!((strain - expected).abs() < 1e-12 * largest, "{strain}, {expected}, {largest}");
            }
            prop_assert!(modes[a].residual < 1e-13);
        }
    }

    /// No motion has a Rayleigh quotient outside the frequencies, and the trace is their sum.
    #[test]
    fn rayleigh_quotients_lie_between_the_extreme_frequencies(set in sets(), seed in proptest::collection::vec(-1.0_f64..1.0, 30)) {
        let (model, _) = set.planar().unwrap();
        let (k, m) = (model.stiffness_matrix_n_per_m(), model.mass_matrix_diagonal_kg());
        let modes = model.modes().unwrap().modes;
        let q: Vec<f64> = (0..model.size()).map(|place| seed[place]).collect();
        let kinetic: f64 = m.iter().zip(&q).map(|(m, q)| m * q * q).sum();
        let strain: f64 = k.iter().zip(&q).map(|(row, a)| row.iter().zip(&q).map(|(k, b)| a * k * b).sum::<f64>()).sum();
        let largest = modes.last().unwrap().omega.value.powi(2);
        prop_assert!(strain / kinetic <= largest * (1.0 + 1e-12) && strain >= -1e-12 * largest * kinetic);
        let trace: f64 = k.iter().enumerate().map(|(place, row)| row[place] / m[place]).sum();
        let sum: f64 = modes.iter().map(|mode| mode.omega.value.powi(2)).sum();
        prop_assert!((trace / sum - 1.0).abs() < 1e-11);
    }

    #[test]
    fn other_numbers_of_the_planets_change_nothing(set in sets(), by in 1_usize..6) {
        let mut other = set.clone();
        let count = other.planets.len();
        other.planets.rotate_left(by % count);
        other.planets.swap(0, count - 1);
        let [one, other] = [set, other].map(|set| groups(&set));
        prop_assert_eq!(one.len(), other.len());
        let largest = one.last().unwrap().omega.value.powi(2);
        for (a, b) in one.iter().zip(&other) {
            prop_assert_eq!((a.kind, a.multiplicity()), (b.kind, b.multiplicity()));
            prop_assert!((a.omega.value.powi(2) - b.omega.value.powi(2)).abs() < 1e-13 * largest);
        }
    }
}

/// Coordinates of a mode in the order of the matrices; every body of these sets is planar.
fn flat(model: &Model, mode: &epicyclic_vibration::Mode) -> Vec<f64> {
    model.bodies().flat_map(|body| mode.shape.of(body).unwrap()).collect()
}

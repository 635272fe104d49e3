//! Several sets on common links: one set alone, rigid meshes, freedoms.

use crate::common::{body, degrees, hz, lin_parker, n_m};
use epicyclic_vibration::train::{Link, Placed, Shaft, torsional};
use epicyclic_vibration::{Central, Error, Freedom, Planet, PlanetarySet, Support};
use uom::si::f64::{MomentOfInertia, Torque};
use uom::si::moment_of_inertia::kilogram_square_meter;
use uom::si::torque::newton_meter;

fn inertia(value: f64) -> MomentOfInertia {
    MomentOfInertia::new::<kilogram_square_meter>(value)
}

fn links(held: &[bool]) -> Vec<Link> {
    held.iter()
        .enumerate()
        .map(|(index, held)| Link {
            name: format!("link {index}"),
            inertia: inertia(0.0),
            support: Torque::default(),
            held: *held,
        })
        .collect()
}

fn placed(name: &str, set: &PlanetarySet, links: [usize; 3]) -> Placed {
    Placed { name: format!("{name} "), set: set.gear_set(), links: links.to_vec() }
}

/// Zeros, then the other frequencies, Hz.
fn frequencies(links: &[Link], sets: &[Placed], shafts: &[Shaft]) -> (usize, Vec<f64>) {
    let (model, _) = torsional(links, sets, shafts).unwrap();
    let all: Vec<f64> = model.modes().unwrap().modes.iter().map(|mode| hz(mode.frequency)).collect();
    let zeros = all.iter().filter(|frequency| **frequency == 0.0).count();
    (zeros, all[zeros..].to_vec())
}

/// Teeth 20, 40, 100 with a radius of the planets' circle of 0.09 m; inertias in kg·m², of planets as `I/r²`
/// in kg.
fn geared(stiffness: f64) -> PlanetarySet {
    let cos = libm::cos(20_f64.to_radians());
    let of = |kg_m2: f64, radius: f64| body(1.0, kg_m2 / (radius * radius), radius);
    let [sun, planet, ring] = [0.03, 0.06, 0.15].map(|radius| radius * cos);
    let planet = Planet {
        body: of(3e-4, planet),
        angle: degrees(0.0),
        bearing: n_m(1.0),
        sun_mesh: n_m(stiffness),
        ring_mesh: n_m(stiffness),
    };
    PlanetarySet {
        sun: Central::new(of(2e-4, sun), Support::default()),
        ring: Central::new(of(0.05, ring), Support::default()),
        carrier: Central::new(of(0.02, 0.09), Support::default()),
        planets: planet.equally_spaced(3),
        sun_pressure_angle: degrees(20.0),
        ring_pressure_angle: degrees(20.0),
    }
}

#[test]
fn one_set_on_its_own_links_is_its_torsional_model() {
    let mut set = lin_parker(4);
    set.ring.support.tangential = n_m(0.0);
    for held in [[false; 3], [false, true, false], [true, false, false], [false, false, true]] {
        let mut alone = set.clone();
        for (central, held) in [&mut alone.sun, &mut alone.ring, &mut alone.carrier].into_iter().zip(held) {
            central.freedom = if held { Freedom::Held } else { Freedom::Planar };
        }
        let wanted: Vec<f64> = alone
            .torsional()
            .unwrap()
            .0
            .modes()
            .unwrap()
            .modes
            .iter()
            .map(|mode| hz(mode.frequency))
            .collect();
        let (zeros, found) = frequencies(&links(&held), &[placed("P", &set, [0, 1, 2])], &[]);
        assert_eq!(zeros + found.len(), wanted.len());
        for (found, wanted) in found.iter().zip(&wanted[zeros..]) {
            assert!((found / wanted - 1.0).abs() < 1e-10, "{held:?}: {found}, {wanted}");
        }
    }
}

/// Rigid meshes make the lowest frequency that of two inertias on a shaft, `ω² = k·(1/J_1 + 1/J_2)`. Each is
/// the inertia of a set with a held ring by its energy: at the carrier of the first and at the sun of the
/// second. The error falls as the compliance of the meshes.
#[test]
fn rigid_sets_on_a_shaft_swing_as_two_inertias() {
    // Speeds over the carrier's by Willis: sun 1 + 100/20, planet 1 − (6 − 1)·20/40.
    let at_carrier: f64 = 0.02 + 3.0 * 0.09 * 0.09 + 6.0 * 6.0 * 2e-4 + 3.0 * 1.5 * 1.5 * 3e-4;
    let stiffness: f64 = 4e4;
    let wanted = (stiffness * (1.0 / at_carrier + 36.0 / at_carrier)).sqrt() / std::f64::consts::TAU;
    let error = |meshes: f64| {
        let set = geared(meshes);
        let shaft = Shaft {
            name: "shaft".to_owned(),
            links: [1, 2],
            stiffness: Torque::new::<newton_meter>(stiffness),
        };
        let links = links(&[false, false, false, false, true]);
        let sets = [placed("first", &set, [0, 4, 1]), placed("second", &set, [2, 4, 3])];
        let (zeros, found) = frequencies(&links, &sets, &[shaft]);
        assert_eq!(zeros, 1);
        (found[0] / wanted - 1.0).abs()
    };
    let [soft, stiff] = [1e12, 1e13].map(error);
    assert!(soft < 1e-3 && (libm::log10(soft / stiff) - 1.0).abs() < 0.05, "{soft} {stiff}");
}

#[test]
fn as_many_modes_have_no_frequency_as_the_train_keeps_freedoms() {
    let set = geared(1e9);
    // Simpson: one sun, the ring of the first set on the carrier of the second.
    let sets = [placed("1", &set, [0, 1, 2]), placed("2", &set, [0, 3, 1])];
    for (held, freedoms) in [
        ([false, false, false, false], 2),
        ([false, false, true, false], 1),
        ([false, false, false, true], 1),
        ([false, false, true, true], 0),
        ([true, false, true, false], 0),
    ] {
        let (zeros, found) = frequencies(&links(&held), &sets, &[]);
        assert_eq!(zeros, freedoms, "{held:?}");
        assert_eq!(zeros + found.len(), held.iter().filter(|held| !**held).count() + 6);
    }
}

#[test]
fn an_inertia_on_a_link_counts_as_one_of_its_member() {
    let (mut heavy, set) = (geared(1e9), geared(1e9));
    heavy.sun.body.inertia += inertia(0.01);
    let held = [false, true, false];
    let mut with = links(&held);
    with[0].inertia = inertia(0.01);
    let found = frequencies(&with, &[placed("P", &set, [0, 1, 2])], &[]);
    assert_eq!(found, frequencies(&links(&held), &[placed("P", &heavy, [0, 1, 2])], &[]));
}

#[test]
fn links_without_inertia_and_places_of_no_link_are_refused() {
    let set = geared(1e9);
    let fault = torsional(&links(&[false; 4]), &[placed("P", &set, [0, 1, 2])], &[]).unwrap_err();
    assert!(matches!(&fault, Error::NotPositive { field, .. } if field == "inertia of link 3"), "{fault}");
    let fault = torsional(&links(&[false; 3]), &[placed("P", &set, [0, 1, 3])], &[]).unwrap_err();
    assert_eq!(fault, Error::NoSuchBody { index: 3, count: 3 });
    let shaft = Shaft { name: "s".to_owned(), links: [0, 1], stiffness: Torque::new::<newton_meter>(-1.0) };
    let fault = torsional(&links(&[false; 3]), &[placed("P", &set, [0, 1, 2])], &[shaft]).unwrap_err();
    assert_eq!(fault.name(), "negative");
}

/// A support that becomes rigid holds the link.
#[test]
fn a_link_on_a_stiff_support_is_held() {
    let set = geared(1e8);
    let of = |held: bool, stiffness: f64| {
        let mut links = links(&[false, held, false]);
        links[1].support = Torque::new::<newton_meter>(stiffness);
        frequencies(&links, &[placed("P", &set, [0, 1, 2])], &[])
    };
    let (held, stiff) = (of(true, 0.0), of(false, 1e14));
    assert_eq!((held.0, stiff.0, stiff.1.len()), (1, 1, held.1.len() + 1));
    for (held, stiff) in held.1.iter().zip(&stiff.1) {
        assert!((held / stiff - 1.0).abs() < 1e-6, "{held} {stiff}");
    }
}

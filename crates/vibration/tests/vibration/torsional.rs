//! Torsional models: closed forms, and the planar model whose supports become rigid.

use crate::common::{body, degrees, groups, hz, lin_parker, n_m, of_kind};
use epicyclic_vibration::kahraman::HeldRing;
use epicyclic_vibration::{
    Body, Central, Error, Freedom, Kind, Model, Planet, PlanetarySet, Support, newtons_per_meter,
};
use proptest::prelude::*;
use uom::si::f64::{Length, Mass, MomentOfInertia, Torque};
use uom::si::length::{meter, millimeter};
use uom::si::mass::kilogram;
use uom::si::moment_of_inertia::kilogram_square_meter;
use uom::si::torque::newton_meter;

fn kg(value: f64) -> Mass {
    Mass::new::<kilogram>(value)
}

fn held_ring([sun, planet, carrier]: [f64; 3], [k_s, k_r]: [f64; 2], planets: usize) -> HeldRing {
    let [sun_mesh, ring_mesh] = [k_s, k_r].map(n_m);
    HeldRing { sun: kg(sun), planet: kg(planet), carrier: kg(carrier), sun_mesh, ring_mesh, planets }
}

/// Set with the closed form [`held_ring`]; a planet weighs `mass`.
fn set(
    [sun, planet, carrier]: [f64; 3],
    [k_s, k_r]: [f64; 2],
    planets: usize,
    mass: f64,
    alpha_deg: f64,
) -> PlanetarySet {
    let cos = libm::cos(alpha_deg.to_radians());
    let free = Support::default();
    let planet = Planet {
        body: body(mass, planet, 0.03),
        angle: degrees(0.0),
        bearing: n_m(1.0),
        sun_mesh: n_m(k_s),
        ring_mesh: n_m(k_r),
    };
    PlanetarySet {
        sun: Central::new(body(1.0, sun, 0.02), free),
        ring: Central::new(body(1.0, 1.0, 0.08), free).held(),
        carrier: Central::new(body(1.0, carrier * cos * cos - planets as f64 * mass, 0.05), free),
        planets: planet.equally_spaced(planets),
        sun_pressure_angle: degrees(alpha_deg),
        ring_pressure_angle: degrees(alpha_deg),
    }
}

#[test]
fn nothing_without_mass_stiffness_or_planets() {
    let fault = |masses, springs, planets| held_ring(masses, springs, planets).frequencies().unwrap_err();
    assert!(matches!(fault([2.0, 3.0, 4.0], [7.0, 11.0], 0), Error::TooFew { count: 0, least: 1, .. }));
    let fault = fault([2.0, 3.0, f64::NAN], [7.0, 11.0], 3);
    assert_eq!(fault.name(), "not-positive");
    assert!(fault.to_string().starts_with("I/r² of the carrier is NaN kg"), "{fault}");
}

proptest! {
    #[test]
    fn the_torsional_model_has_kahramans_frequencies(
        masses in [0.1_f64..10.0, 0.1..10.0, 0.1..10.0],
        springs in [1e7_f64..1e9, 1e7..1e9],
        planets in 1_usize..8,
        alpha in 0.0_f64..30.0,
    ) {
        let expected = held_ring(masses, springs, planets).frequencies().unwrap();
        let cos2 = libm::cos(alpha.to_radians()).powi(2);
        let set = set(masses, springs, planets, 0.5 * masses[2] * cos2 / planets as f64, alpha);
        let (model, parts) = set.torsional().unwrap();
        prop_assert_eq!(model.size(), planets + 2);
        let mut wanted: Vec<f64> = expected.rotational.map(hz).to_vec();
        wanted.extend(vec![hz(expected.planet); expected.planet_multiplicity]);
        wanted.push(0.0);
        wanted.sort_by(f64::total_cmp);
        let modes = model.modes().unwrap();
        for (mode, wanted) in modes.modes.iter().zip(wanted) {
            prop_assert!((hz(mode.frequency) - wanted).abs() <= 1e-9 * wanted, "{:?}, {wanted}", mode.frequency);
        }
        let planet_modes: usize = of_kind(&model.groups(&parts.central()).unwrap(), Kind::Planet).iter().map(|m| m.1).sum();
        prop_assert_eq!(planet_modes, planets - 1);
    }
}

/// The error falls with the compliance of supports and bearings: as `1/S`.
#[test]
fn rigid_supports_and_bearings_make_the_planar_model_torsional() {
    let mut set = lin_parker(4);
    set.ring_pressure_angle = degrees(20.0);
    let torsional = of_kind(&groups_of(set.torsional().unwrap()), Kind::Rotational);
    assert_eq!(torsional.len(), 4);
    let worst = |stiffness: f64| {
        let mut set = set.clone();
        for central in [&mut set.sun, &mut set.ring, &mut set.carrier] {
            central.support.radial = n_m(stiffness);
        }
        for planet in &mut set.planets {
            planet.bearing = n_m(stiffness);
        }
        let planar = of_kind(&groups(&set), Kind::Rotational);
        let pairs = planar.iter().zip(&torsional).skip(1);
        pairs.map(|(planar, torsional)| (planar.0 / torsional.0 - 1.0).abs()).fold(0.0, f64::max)
    };
    let errors = [1e12, 1e13, 1e14].map(worst);
    assert!(errors[0] < 1e-3 && errors[2] < 1e-5, "{errors:?}");
    for pair in errors.windows(2) {
        let order = libm::log10(pair[0] / pair[1]);
        assert!((order - 1.0).abs() < 0.02, "{errors:?}");
    }
}

fn groups_of((model, parts): (Model, epicyclic_vibration::SetParts)) -> Vec<epicyclic_vibration::Group> {
    model.groups(&parts.central()).unwrap()
}

/// Equal inertias on equal shafts, both ends free: `ω_j = 2·√(k/I)·sin(j·π/(2·n))`. The radii of the bodies
/// do not matter.
#[test]
fn a_chain_of_shafts_has_the_frequencies_of_its_closed_form() {
    let (count, inertia, stiffness) = (7_usize, 0.3, 2e4);
    let mut model = Model::new();
    let bodies: Vec<_> = (0..count)
        .map(|index| {
            let body = Body {
                mass: kg(5.0),
                inertia: MomentOfInertia::new::<kilogram_square_meter>(inertia),
                radius: Length::new::<millimeter>(40.0 + 13.0 * index as f64),
            };
            model.body(&format!("disc {index}"), &body, Freedom::Rotation).unwrap()
        })
        .collect();
    for pair in bodies.windows(2) {
        let torsional = Torque::new::<newton_meter>(stiffness);
        assert_eq!(model.shaft("shaft", [pair[0], pair[1]], torsional, n_m(0.0)).unwrap().len(), 1);
    }
    for (index, mode) in model.modes().unwrap().modes.iter().enumerate() {
        let angle = index as f64 * std::f64::consts::PI / (2.0 * count as f64);
        let omega = 2.0 * (stiffness / inertia).sqrt() * libm::sin(angle);
        assert!((mode.omega.value - omega).abs() <= 1e-12 * omega, "{}, {omega}", mode.omega.value);
    }
}

#[test]
fn a_torsional_stiffness_is_one_along_the_radius() {
    let tangential = Support::tangential_of(Torque::new::<newton_meter>(500.0), Length::new::<meter>(0.1));
    assert!((tangential / newtons_per_meter(5e4)).value - 1.0 < 1e-15);
}

//! Planets in random sets of every form: forces on their bearings against vectors at the pitch points,
//! assembly against every position of the teeth, clearance against coordinates.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::involute::check::Severity;
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::simple_set::Mode;
use epicyclic_gears::synthesis::{Bounds, ToothNumbers};
use epicyclic_train::compound::{CentralKind, CompoundSpec};
use epicyclic_train::planet_bearings::{Lack, MeshSize, PlanetBearing, SetSize};
use epicyclic_train::planet_set::{GearOf, MeshKind};
use epicyclic_train::set::{MeshLoss, SetKind, SetSpec};
use epicyclic_train::{Gearbox, PlanetSet};
use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use std::f64::consts::{PI, TAU};
use std::ops::ControlFlow;
use uom::si::f64::{Length, Torque};
use uom::si::{force::newton, length::millimeter, torque::newton_meter};

const ALPHA_RAD: f64 = PI / 9.0;

/// A gearbox of one set; its links are `c0`, `c1`… and `H`.
fn alone(set: CompoundSpec) -> Gearbox {
    let links: Vec<String> = set.centrals.iter().map(|central| central.link.clone()).collect();
    Gearbox::builder("one set")
        .links(links)
        .links(["H"])
        .compound_set(set)
        .input("c0")
        .output("H")
        .build()
        .unwrap()
}

/// Parts of a set: central gears with the planet gear they mesh with, planets, meshes of planets.
struct Parts<'a> {
    centrals: &'a [(CentralKind, u32, &'a str)],
    planets: &'a [(&'a str, &'a [u32])],
    meshes: &'a [[&'a str; 2]],
}

fn set_of(parts: &Parts<'_>, planets: u32) -> CompoundSpec {
    let eta = MeshEfficiency::new(0.98).unwrap();
    let mut set = CompoundSpec::new("P", "H").planet_count(planets);
    for (name, teeth) in parts.planets {
        set = set.planet(name, teeth);
    }
    for (place, (kind, teeth, _)) in parts.centrals.iter().enumerate() {
        set = set.central(*kind, &format!("c{place}"), f64::from(*teeth));
    }
    for (place, (_, _, planet)) in parts.centrals.iter().enumerate() {
        set = set.mesh(&format!("c{place}"), planet, eta);
    }
    for [one, other] in parts.meshes {
        set = set.mesh(one, other, eta);
    }
    set
}

/// Number of forms that [`form`] has.
const FORMS: usize = 9;

/// A set of one of the forms, with these teeth on suns, planets and above them on rings.
fn form(
    kind: usize,
    [s1, s2]: [u32; 2],
    [p, q, r]: [u32; 3],
    [b1, b2]: [u32; 2],
    planets: u32,
) -> CompoundSpec {
    use CentralKind::{Ring, Sun};
    let ring = |over: u32, planet: u32| planet + over;
    let (one, two, stepped): (&[u32], &[u32], &[u32]) = (&[p], &[q], &[p, r]);
    let parts = |centrals: &[(CentralKind, u32, &str)], bodies: &[(&str, &[u32])], meshes: &[[&str; 2]]| {
        set_of(&Parts { centrals, planets: bodies, meshes }, planets)
    };
    match kind {
        0 => parts(&[(Sun, s1, "p"), (Ring, ring(b1, p), "p")], &[("p", one)], &[]),
        1 => parts(&[(Sun, s1, "p"), (Ring, ring(b1, q), "q")], &[("p", one), ("q", two)], &[["p", "q"]]),
        // Ravigneaux with three and with four central gears.
        2 => parts(
            &[(Sun, s1, "p"), (Sun, s2, "q"), (Ring, ring(b1, q), "q")],
            &[("p", one), ("q", two)],
            &[["p", "q"]],
        ),
        3 => parts(
            &[(Sun, s1, "p"), (Ring, ring(b2, p), "p"), (Sun, s2, "q"), (Ring, ring(b1, q), "q")],
            &[("p", one), ("q", two)],
            &[["p", "q"]],
        ),
        // Wolfrom.
        4 => parts(
            &[(Sun, s1, "p.1"), (Ring, ring(b1, p), "p.1"), (Ring, ring(b2, r), "p.2")],
            &[("p", stepped)],
            &[],
        ),
        // A stepped long planet in mesh with a short one.
        5 => parts(
            &[(Sun, s1, "q"), (Sun, s2, "p.1"), (Ring, ring(b1, r), "p.2")],
            &[("p", stepped), ("q", two)],
            &[["p.1", "q"]],
        ),
        // A stepped planet beside an idler on the same sun, not in mesh with it.
        6 => parts(
            &[(Sun, s1, "p.1"), (Ring, ring(b1, r), "p.2"), (Ring, ring(b2, q), "q")],
            &[("p", stepped), ("q", two)],
            &[["c0", "q"]],
        ),
        // From ring to ring through planets in mesh.
        7 => parts(
            &[(Ring, ring(b1, p), "p"), (Ring, ring(b2, q), "q")],
            &[("p", one), ("q", two)],
            &[["p", "q"]],
        ),
        _ => parts(&[(Sun, s1, "p.1"), (Sun, s2, "p.2")], &[("p", stepped)], &[]),
    }
}

fn n_m(torques: &[f64]) -> Vec<Torque> {
    torques.iter().copied().map(Torque::new::<newton_meter>).collect()
}

/// Torques on the members without losses, from any but one: `Σ g·T = 0`, `Σ T = 0`.
fn torques(set: &PlanetSet, some: &[f64]) -> Vec<f64> {
    let centrals = set.centrals().len();
    let mut torques = some[..centrals - 1].to_vec();
    let last = centrals - 1;
    torques.push(-(0..last).map(|central| set.ratio_between(central, last) * torques[central]).sum::<f64>());
    torques.push(-torques.iter().sum::<f64>());
    torques
}

fn planet(gear: GearOf) -> Option<usize> {
    match gear {
        GearOf::Planet(planet, _) => Some(planet),
        GearOf::Central(_) => None,
    }
}

/// Centre of each planet in metres, from the radii alone: the first at angle 0, one in mesh with it at the
/// distance that its module and teeth ask.
fn centres(set: &PlanetSet, bearings: &[PlanetBearing], module_m: f64, behind: bool) -> Vec<[f64; 2]> {
    let radii: Vec<f64> = bearings.iter().map(|bearing| bearing.radius.unwrap().value).collect();
    let mut centres: Vec<[f64; 2]> = radii.iter().map(|radius| [*radius, 0.0]).collect();
    for mesh in set.meshes() {
        let [Some(_), Some(_)] = mesh.gears.map(planet) else { continue };
        let [z1, z2] = mesh.gears.map(|gear| set.teeth(gear).unwrap().as_f64());
        let distance = module_m * (z1 + z2) / 2.0;
        // Where the circles about both centres cut each other.
        let x = (radii[0].powi(2) + radii[1].powi(2) - distance.powi(2)) / (2.0 * radii[0]);
        let y = (radii[1].powi(2) - x * x).max(0.0).sqrt();
        centres[1] = [x, if behind { -y } else { y }];
    }
    centres
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn plus(a: [f64; 2], b: [f64; 2], times: f64) -> [f64; 2] {
    [a[0] + times * b[0], a[1] + times * b[1]]
}

/// A planet that a mesh presses, with the directions of a force of 1 and of what pushes the gears apart.
type Press = (usize, [f64; 2], [f64; 2]);

/// Force on each planet as a vector, of forces at the pitch points that balance every central gear and every
/// planet about its own axis; and what of the balances is left.
fn forces(set: &PlanetSet, centres: &[[f64; 2]], torques: &[f64], planets: f64) -> (Vec<[f64; 2]>, f64) {
    let centrals = set.centrals().len();
    let mut balance = DMatrix::zeros(centrals + centres.len(), set.meshes().len());
    let mut presses: Vec<Vec<Press>> = vec![];
    for (place, mesh) in set.meshes().iter().enumerate() {
        let z = |gear| set.teeth(gear).unwrap().as_f64();
        let turned = |along: [f64; 2]| [-along[1], along[0]];
        presses.push(match mesh.gears.map(planet) {
            [Some(one), Some(other)] => {
                let [z1, z2] = mesh.gears.map(z);
                let apart = plus(centres[other], centres[one], -1.0);
                let distance = libm::hypot(apart[0], apart[1]);
                let along = apart.map(|part| part / distance);
                balance[(centrals + one, place)] = distance * z1 / (z1 + z2);
                balance[(centrals + other, place)] = distance * z2 / (z1 + z2);
                let across = turned(along);
                vec![(one, across, along.map(|part| -part)), (other, across.map(|part| -part), along)]
            }
            [one, other] => {
                let planet = one.or(other).unwrap();
                let [central, gear] =
                    if one.is_some() { [1, 0] } else { [0, 1] }.map(|place: usize| mesh.gears[place]);
                let GearOf::Central(member) = central else { panic!("{central:?}") };
                let (z_c, z_p) = (z(central), z(gear));
                let radius = libm::hypot(centres[planet][0], centres[planet][1]);
                let outwards = centres[planet].map(|part| part / radius);
                let (sign, of) = match mesh.kind {
                    MeshKind::Internal => (1.0, radius / (z_c - z_p)),
                    _ => (-1.0, radius / (z_c + z_p)),
                };
                balance[(member, place)] = planets * of * z_c;
                balance[(centrals + planet, place)] = sign * of * z_p;
                vec![(planet, turned(outwards), outwards.map(|part| -sign * part))]
            }
        });
    }
    let mut right = DVector::zeros(centrals + centres.len());
    right.rows_mut(0, centrals).copy_from_slice(&torques[..centrals]);
    // One force fewer than balances, and these depend on each other: least squares leaves nothing.
    let found = (balance.transpose() * &balance).lu().solve(&(balance.transpose() * &right)).unwrap();
    let residual = (&balance * &found - &right).amax();
    let mut sum = vec![[0.0; 2]; centres.len()];
    for (presses, force) in presses.into_iter().zip(found.iter()) {
        for (planet, across, away) in presses {
            sum[planet] = plus(sum[planet], across, *force);
            sum[planet] = plus(sum[planet], away, force.abs() * libm::tan(ALPHA_RAD));
        }
    }
    (sum, residual)
}

/// Form, teeth of suns, planets and rings beyond their planets, number of planets.
type Drawn = (usize, [u32; 2], [u32; 3], [u32; 2], u32);

/// Teeth of suns, planets and rings beyond their planets, and the number of planets.
fn teeth() -> impl Strategy<Value = Drawn> {
    let (suns, planets, rings) =
        (prop::array::uniform2(12..50_u32), prop::array::uniform3(12..40_u32), 8..70_u32);
    (0..FORMS, suns, planets, prop::array::uniform2(rings), 1..6_u32)
}

/// Drawn sets with few teeth.
fn small() -> impl Strategy<Value = Drawn> {
    let (suns, planets) = (prop::array::uniform2(2..9_u32), prop::array::uniform3(1..5_u32));
    (0..FORMS, suns, planets, prop::array::uniform2(1..9_u32), 1..7_u32)
}

fn of((kind, suns, planets, rings, count): Drawn) -> Gearbox {
    alone(form(kind, suns, planets, rings, count))
}

/// The numbers that assemble instead, where this one does not.
fn assembly(gearbox: &Gearbox) -> Option<(Option<u32>, Option<u32>)> {
    let all = gearbox.set_checks(&BasicRack::default(), |_| vec![]).checks;
    let miss = all.into_iter().find(|check| check.rule == "assembly")?.miss?;
    // "…; 3 would do", "…; 3 or 8 would do"
    let numbers = miss.split_once("; ").and_then(|(_, rest)| rest.strip_suffix(" would do"));
    let mut numbers = numbers.unwrap_or_default().split(" or ").filter_map(|number| number.parse().ok());
    Some((numbers.next(), numbers.next()))
}

/// Every central gear is drawn with the gear of reference and the planets between them. The gear of reference
/// is the first unless a mesh gives another.
#[test]
fn sets_of_every_form_are_drawn_as_kinds_of_three_members() {
    use epicyclic_train::set::SetKind::{DoublePlanet, Simple, SteppedRings, SteppedSunRing, SteppedSuns};
    // Rings of planets 18, 16 and 17: 40 or 44 teeth more.
    let expected: [&[_]; FORMS] = [
        &[(Simple, [0, 1], -58.0 / 20.0)],
        &[(DoublePlanet, [0, 1], 56.0 / 20.0)],
        &[(Simple, [1, 2], -56.0 / 24.0), (DoublePlanet, [0, 2], 56.0 / 20.0)],
        &[
            (Simple, [0, 1], -62.0 / 20.0),
            (DoublePlanet, [2, 1], 62.0 / 24.0),
            (SteppedRings, [1, 3], -56.0 / 62.0),
        ],
        &[(Simple, [0, 1], -58.0 / 20.0), (SteppedSunRing, [0, 2], -(18.0 / 20.0) * (61.0 / 17.0))],
        &[
            (SteppedSunRing, [1, 2], -(18.0 / 24.0) * (57.0 / 17.0)),
            (DoublePlanet, [0, 2], (18.0 / 20.0) * (57.0 / 17.0)),
        ],
        &[(SteppedSunRing, [0, 1], -(18.0 / 20.0) * (57.0 / 17.0)), (Simple, [0, 2], -60.0 / 20.0)],
        &[(SteppedRings, [0, 1], -60.0 / 58.0)],
        &[(SteppedSuns, [0, 1], (18.0 / 20.0) * (24.0 / 17.0))],
    ];
    for (kind, expected) in expected.into_iter().enumerate() {
        let gearbox = alone(form(kind, [20, 24], [18, 16, 17], [40, 44], 3));
        let drawn = gearbox.drawn_sets();
        let carrier = gearbox.sets()[0].centrals().len();
        assert_eq!(drawn.len(), expected.len());
        for (set, &(kind, [first, second], ratio)) in drawn.iter().zip(expected) {
            assert_eq!((set.kind, set.members), (kind, [first, second, carrier]));
            assert!((set.basic_ratio(&gearbox) - ratio).abs() < 1e-12, "{set:?}");
        }
    }
}

/// The teeth of a planet with one gear cancel between its meshes: without them all but its own speed is
/// known.
#[test]
fn a_planet_without_teeth_has_no_speed_of_its_own() {
    let set = |first: &[u32], second: &[u32]| {
        let eta = MeshEfficiency::new(0.98).unwrap();
        let set = CompoundSpec::new("P", "H").planet("p", first).planet("q", second);
        let set = set.sun("c0", 20).sun("c1", 24).ring("c2", 60).mesh("c0", "p", eta).mesh("c1", "q", eta);
        alone(set.mesh("c2", "q", eta).mesh("p", "q", eta))
    };
    let known = [-20.0 / 18.0, 20.0 / 16.0];
    for (first, second) in [(&[18][..], &[16][..]), (&[], &[16]), (&[18], &[]), (&[], &[])] {
        let gearbox = set(first, second);
        let set = &gearbox.sets()[0];
        for (planet, teeth) in [first, second].into_iter().enumerate() {
            let factor = set.planet_factor(planet);
            assert_eq!(factor.is_some(), !teeth.is_empty(), "{first:?} {second:?}");
            assert!(factor.is_none_or(|factor| (factor - known[planet]).abs() < 1e-15), "{factor:?}");
        }
        for (other, ratio) in [(1, 24.0 / 20.0), (2, 60.0 / 20.0)] {
            let found = set.ratio_between(0, other);
            assert!((found.abs() - ratio).abs() < 1e-14 && (found > 0.0) == (other == 2), "{other} {found}");
        }
    }
}

/// Efficiency between the first two central gears: sun, planets and ring, whatever else is in mesh; for a set
/// in short form the set's own.
#[test]
fn the_efficiency_of_a_set_is_that_of_the_meshes_between_its_first_gears() {
    let eta = |value: f64| MeshEfficiency::new(value).unwrap();
    let set = CompoundSpec::new("P", "H").planet("p", &[18]).planet("q", &[16]);
    let set = set.sun("c0", 20).ring("c1", 56).sun("c2", 24);
    let set = set.mesh("c0", "p", eta(0.99)).mesh("p", "q", eta(0.98));
    let gearbox = alone(set.mesh("q", "c1", eta(0.97)).mesh("q", "c2", eta(0.5)));
    assert!((gearbox.sets()[0].efficiency() - 0.99 * 0.98 * 0.97).abs() < 1e-15);
    let short = SetSpec::simple("P", ["c0", "c1", "H"], 3.0).with_loss(MeshLoss::Set(eta(0.96)));
    let builder = Gearbox::builder("short").links(["c0", "c1", "H"]).set(short).input("c0").output("H");
    assert_eq!(builder.build().unwrap().sets()[0].efficiency(), 0.96);
}

/// `Σ N·F_t·R = |T_H|`: a planet's shaft takes part of the torque about the main axis.
#[test]
fn planets_with_a_shaft_carry_the_torque_of_the_carrier_together() {
    let eta = MeshEfficiency::new(0.98).unwrap();
    let set = CompoundSpec::new("P", "H").planet("p", &[18]).planet("q", &[16]).planet_count(3);
    let set = set.sun("c0", 20).ring("c1", 56).planet_shaft("c2", "q");
    let set = set.mesh("c0", "p", eta).mesh("p", "q", eta).mesh("q", "c1", eta);
    let gearbox = alone(set);
    let size = SetSize { module: Some(Length::new::<millimeter>(2.0)), ..SetSize::default() };
    let bearings = gearbox.planet_bearings(0, &size).unwrap().unwrap();
    for [sun, ring, shaft] in [[100.0, -40.0, 0.0], [100.0, -40.0, 250.0], [-30.0, 0.0, 80.0]] {
        let carrier: f64 = -(sun + ring + shaft);
        let carried: f64 = bearings
            .iter()
            .map(|bearing| {
                let forces = bearing.forces(Some(&n_m(&[sun, ring, shaft, carrier])), None).unwrap();
                let radius_m = bearing.radius.unwrap().get::<millimeter>() / 1000.0;
                3.0 * forces.tangential.unwrap().get::<newton>() * radius_m
            })
            .sum();
        assert!((carried - carrier.abs()).abs() < 1e-9, "{carried} {carrier}");
    }
}

/// The properties below prove little where one answer is rare: how often each is met, over a fixed stream.
#[test]
fn random_sets_of_every_form_meet_both_answers() {
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &[11; 32]);
    let mut runner = TestRunner::new_with_rng(Config::default(), rng);
    let (mut fits, mut fits_not) = ([0; FORMS], [0; FORMS]);
    let (mut stands, mut stands_not) = ([0; FORMS], [0; FORMS]);
    for _ in 0..5000 {
        let drawn = small().new_tree(&mut runner).unwrap().current();
        if drawn.4 > 1 {
            let counter = if assembly(&of(drawn)).is_none() { &mut fits } else { &mut fits_not };
            counter[drawn.0] += 1;
        }
        let drawn = teeth().new_tree(&mut runner).unwrap().current();
        let found = of(drawn).set_checks(&BasicRack::default(), |_| vec![]).checks;
        let is_none = found.iter().any(|check| check.rule == "planet-triangle");
        let counter = if is_none { &mut stands_not } else { &mut stands };
        counter[drawn.0] += 1;
    }
    println!("assemble {fits:?}, not {fits_not:?}; planets stand {stands:?}, not {stands_not:?}");
    assert!(fits.iter().chain(&fits_not).chain(&stands).all(|count| *count >= 20));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, max_global_rejects: 3000, failure_persistence: None, ..ProptestConfig::default() })]

    /// Without losses the forces are those of the vectors, and all planets together carry the carrier's
    /// torque; with any torques they carry it still.
    #[test]
    fn forces_on_planets_are_the_sum_of_vectors(
        (kind, suns, planets, rings, count) in teeth(),
        some in prop::collection::vec(-500.0..500.0_f64, 3),
        loss in 0.9..1.1_f64,
        is_behind in any::<bool>(),
    ) {
        let gearbox = alone(form(kind, suns, planets, rings, count));
        let set = &gearbox.sets()[0];
        let meshes = vec![MeshSize { is_behind, ..MeshSize::default() }; set.meshes().len()];
        let module = Some(Length::new::<millimeter>(2.0));
        let bearings = gearbox.planet_bearings(0, &SetSize { module, meshes, ..SetSize::default() }).unwrap().unwrap();
        // Nothing but places of planets in mesh may be missing.
        let is_whole = bearings.iter().all(|bearing| bearing.lacks == [Lack::Mass]);
        let has_none = |bearing: &PlanetBearing| matches!(bearing.lacks[0], Lack::Triangle { .. });
        prop_assert!(is_whole || bearings.iter().all(has_none));
        prop_assume!(is_whole);
        let mut torques = torques(set, &some);
        let largest = torques.iter().fold(1.0_f64, |most, torque| most.max(torque.abs()));
        let centres = centres(set, &bearings, 2e-3, is_behind);
        let (vectors, residual) = forces(set, &centres, &torques, f64::from(count));
        prop_assert!(residual < 1e-9 * largest, "{}", residual);
        let carrier = *torques.last().unwrap();
        let sense = if carrier > 1e-9 * largest { -1.0 } else { 1.0 };
        let scale = largest / 1e-3;
        for (bearing, (centre, vector)) in bearings.iter().zip(centres.iter().zip(&vectors)) {
            let found = bearing.forces(Some(&n_m(&torques)), None).unwrap();
            let radius = bearing.radius.unwrap().value;
            let radial = (centre[0] * vector[0] + centre[1] * vector[1]) / radius;
            prop_assert!((found.radial.unwrap().get::<newton>() - radial).abs() < 1e-9 * scale);
            let tangential = sense * cross(*centre, *vector) / radius;
            prop_assert!((found.tangential.unwrap().get::<newton>() - tangential).abs() < 1e-9 * scale);
        }
        // Losses: a torque off by some per cent, the carrier's still against all others.
        torques[0] *= loss;
        let last = torques.len() - 1;
        torques[last] = -torques[..last].iter().sum::<f64>();
        let moment = |bearing: &PlanetBearing| {
            let force = bearing.forces(Some(&n_m(&torques)), None).unwrap().tangential.unwrap();
            force.get::<newton>() * bearing.radius.unwrap().value * f64::from(count)
        };
        let sum: f64 = bearings.iter().map(moment).sum();
        prop_assert!((sum - torques[last].abs()).abs() < 1e-9 * largest, "{} {}", sum, torques[last]);
    }

    /// The number of planets is warned of if no position of the teeth allows a second planet, and only then.
    #[test]
    fn planets_assemble_where_some_position_of_the_teeth_lets_them(small in small()) {
        let gearbox = of(small);
        prop_assert_eq!(assembly(&gearbox).is_none(), assembles(&gearbox.sets()[0], i64::from(small.4)));
        // And so do the numbers that are named instead.
        if let Some((fewer, more)) = assembly(&gearbox) {
            for other in fewer.into_iter().chain(more) {
                prop_assert!(assembly(&of((small.0, small.1, small.2, small.3, other))).is_none());
            }
        }
    }

    /// Identical neighbours clear where their tip circles do, by coordinates.
    #[test]
    fn simple_sets_clear_as_their_coordinates_do(
        sun in 6..60_u32, planet in 6..60_u32, count in 1..12_u32, addendum in 0.5..1.5_f64,
    ) {
        let set = form(0, [sun, 1], [planet, 1, 1], [sun + planet, 1], count);
        let form = BasicRack { addendum, ..BasicRack::default() };
        let found = alone(set).set_checks(&form, |_| vec![]).checks;
        let radius = f64::from(sun + planet) / 2.0;
        let at = |place: u32| {
            let (sin, cos) = libm::sincos(TAU * f64::from(place) / f64::from(count));
            [radius * cos, radius * sin]
        };
        let gap = |other: u32| {
            let apart = plus(at(other), at(0), -1.0);
            libm::hypot(apart[0], apart[1]) - f64::from(planet) - 2.0 * addendum
        };
        let overlap = (1..count).map(gap).fold(f64::INFINITY, f64::min);
        prop_assume!(overlap.abs() > 1e-6);
        let gaps = found.iter().filter(|check| check.rule == "planet-gap");
        let warned = gaps.filter(|check| check.miss.is_some()).map(|check| check.value).reduce(f64::min);
        prop_assert_eq!(warned.is_some(), overlap < 0.0);
        prop_assert!(warned.is_none_or(|warned| (warned - overlap).abs() < 1e-9));
    }
}

/// Errors of the teeth of a set, but of tips in the fillets of a ring, which a larger shaper avoids.
fn errors(set: SetSpec, rack: &BasicRack) -> Vec<String> {
    let gearbox = Gearbox::builder("offered").links(["sun", "arm"]).set(set).input("sun").output("arm");
    let checks = gearbox.gear("only", [""; 0]).build().unwrap().set_checks(rack, |_| vec![]).checks;
    let missed = checks
        .into_iter()
        .filter(|check| check.severity == Severity::Error && check.rule != "fillet-interference");
    missed.filter_map(|check| Some(format!("{}: {}", check.rule, check.miss?))).collect()
}

proptest! {
    #![proptest_config(Config::with_cases(24))]

    /// Tooth numbers offered by the searches can be cut and turned, also with few teeth.
    #[test]
    fn tooth_numbers_offered_have_no_errors(
        sun in 5..30_u32, planet in 4..16_u32, ring in 16..70_u32, ratio in 2.5..7.0_f64, addendum in prop_oneof![Just(1.0), 0.7..1.2_f64],
    ) {
        let rack = BasicRack { addendum, ..BasicRack::default() };
        let bounds = Bounds {
            sun: sun..=sun + 6, planet: planet..=planet + 12, ring: ring..=ring + 20, planets: 2..=5, ring_to_sun_ratio: 1.2..=9.0, rack, ..Bounds::default()
        };
        let members = ["sun", "ground", "arm"];
        let go = |_| ControlFlow::Continue(());
        let simple = |of: &ToothNumbers| {
            SetSpec::teeth("1", SetKind::Simple, members, of.sun.get(), of.ring.get()).unwrap().planet_teeth(of.planet, None).planet_count(of.planets)
        };
        for of in bounds.first_for_ratio(ratio, Mode::SUN_TO_CARRIER, 0.2, 200, go).map(|found| found.first).unwrap_or_default() {
            prop_assert_eq!(errors(simple(&of.teeth), &rack), Vec::<String>::new(), "{}", of.teeth);
        }
        for of in bounds.tooth_numbers().unwrap().iter().take(200) {
            let mut left_out = None;
            // A search takes a shaper that exists, an analysis one made for the ring: so it may leave out
            // more.
            if bounds.can_turn(of, &mut left_out).unwrap() {
                prop_assert_eq!(errors(simple(of), &rack), Vec::<String>::new(), "{}", of);
            }
        }
        let (double, _) = bounds.double_planet_choices().unwrap();
        let of_ratio = bounds.double_planets_for_ratio(1.0 - ratio, Mode::SUN_TO_CARRIER, 0.2, 200, go);
        let of_ratio = of_ratio.map(|found| found.first).unwrap_or_default().into_iter().map(|of| of.teeth);
        for of in double.into_iter().take(200).chain(of_ratio) {
            let set = SetSpec::teeth("1", SetKind::DoublePlanet, members, of.sun.get(), of.ring.get()).unwrap();
            let set = set.planet_teeth(of.inner, Some(of.outer)).planet_count(of.pairs);
            prop_assert_eq!(errors(set, &rack), Vec::<String>::new(), "{}", of);
        }
    }
}

/// Whether identical planets fit in the next place, by trying every position: a gear turned by a fraction of
/// a turn has a tooth or a gap at its contact, and these must be as they are in the first place.
fn assembles(set: &PlanetSet, count: i64) -> bool {
    let z = |gear: GearOf| i64::from(set.teeth(gear).unwrap().get());
    // Angles are whole parts of one turn of this many.
    let parts = set
        .planets()
        .iter()
        .flat_map(|planet| planet.gears.iter().flatten())
        .fold(count, |parts, teeth| parts * i64::from(teeth.get()));
    // Where a gear's teeth stand at the contact, in parts of one tooth: planets stand one place on,
    // `parts/count`, turned by `turns`; central gears stand still.
    let phase = |gear: GearOf, turns: &[i64]| match gear {
        GearOf::Central(_) => z(gear) * (parts / count),
        // It looks one place on too.
        GearOf::Planet(planet, _) => z(gear) * (parts / count - turns[planet]),
    };
    let fits = |turns: &[i64]| {
        set.meshes().iter().all(|mesh| {
            let [one, other] = mesh.gears.map(|gear| phase(gear, turns));
            let sum = if mesh.kind == MeshKind::Internal { one - other } else { one + other };
            sum.rem_euclid(parts) == 0
        })
    };
    match set.planets().len() {
        1 => (0..parts).any(|turn| fits(&[turn])),
        _ => {
            // The second is tried only where the first fits its central gears.
            let meshes_of_first = |turns: &[i64]| {
                set.meshes().iter().all(|mesh| {
                    let is_of_second = mesh.gears.iter().any(|gear| matches!(gear, GearOf::Planet(1, _)));
                    let [one, other] = mesh.gears.map(|gear| phase(gear, turns));
                    let sum = if mesh.kind == MeshKind::Internal { one - other } else { one + other };
                    is_of_second || sum.rem_euclid(parts) == 0
                })
            };
            (0..parts)
                .filter(|&first| meshes_of_first(&[first, 0]))
                .any(|first| (0..parts).any(|second| fits(&[first, second])))
        }
    }
}

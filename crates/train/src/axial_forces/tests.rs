//! Axial forces against force vectors at the pitch points.

use super::{AxialLoad, Body};
use crate::compound::CompoundSpec;
use crate::planet_places::planet_of;
use crate::planet_set::GearOf;
use crate::set::{SetKind, SetSpec};
use crate::toothed::{ToothShape, ToothedSet};
use crate::{Gearbox, PlanetSet};
use epicyclic_gears::ToothCount;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::rack::BasicRack;
use epicyclic_units::Physical;
use proptest::prelude::*;
use uom::si::f64::Angle;

fn shape(degrees: &[f64]) -> ToothShape {
    let helix_angles = degrees.iter().map(|degrees| Angle::from_degrees(*degrees)).collect();
    ToothShape { helix_angles, ..ToothShape::default() }
}

fn short(kind: SetKind, teeth: [u32; 2], planets: &[u32], degrees: &[f64]) -> PlanetSet {
    let count = |place: usize| planets.get(place).map(|teeth| ToothCount::new(*teeth).unwrap());
    let mut set = SetSpec::teeth("P", kind, ["a", "b", "h"], teeth[0], teeth[1]).unwrap();
    if let Some(first) = count(0) {
        set = set.planet_teeth(first, count(1)).planet_count(3);
    }
    set.tooth_shape = shape(degrees);
    let links = if kind.is_pair() { vec!["a", "b"] } else { vec!["a", "b", "h"] };
    if kind.is_pair() {
        set.members[2] = crate::GROUND.to_owned();
        let gearbox = Gearbox::builder("one").links(links).set(set).input("a").output("b");
        return gearbox.gear("1", [""; 0]).build().unwrap().sets()[0].clone();
    }
    let gearbox = Gearbox::builder("one").links(links).set(set).brake("B", "b");
    gearbox.input("a").output("h").gear("1", ["B"]).build().unwrap().sets()[0].clone()
}

fn ravigneaux(degrees: f64) -> PlanetSet {
    let eta = MeshEfficiency::IDEAL;
    let set = CompoundSpec::new("R", "h").sun("s", 30).sun("l", 36).ring("r", 72).planet("short", &[18]);
    let set = set.planet("long", &[18]).mesh("s", "short", eta).mesh("short", "long", eta);
    let mut set = set.mesh("l", "long", eta).mesh("long", "r", eta).planet_count(3);
    set.tooth_shape = shape(&[degrees; 4]);
    let gearbox = Gearbox::builder("four").links(["s", "l", "r", "h"]).compound_set(set).brake("B", "h");
    gearbox.input("s").output("r").gear("1", ["B"]).build().unwrap().sets()[0].clone()
}

fn loads(set: &PlanetSet, toothed: &ToothedSet, torques: &[f64]) -> Vec<AxialLoad> {
    set.axial_forces(toothed, &[], &set.mesh_loads(torques).unwrap()).unwrap()
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Sums of the force and the moment about its centre of each planet, and of the force on each central gear by
/// one group of planets, in the frame of the main axis; from forces that lie across the teeth of each gear.
fn by_vectors(set: &PlanetSet, toothed: &ToothedSet, torques: &[f64]) -> Vec<(Body, [f64; 3], [f64; 3])> {
    let angles = set.angles_between(toothed, &[]).unwrap();
    let centre = |gear: GearOf| match planet_of(gear) {
        Some(planet) => {
            let (sin, cos) = libm::sincos(angles[planet].1.si());
            let radius = toothed.radii[planet].unwrap();
            [radius * cos, radius * sin, 0.0]
        }
        // The second axis of a pair.
        None if set.is_pair() && gear == GearOf::Central(1) => {
            let made = &toothed.meshes[0];
            let distance = made.module * made.pair.centre_distance();
            [if made.pair.is_internal() { -distance } else { distance }, 0.0, 0.0]
        }
        None => [0.0; 3],
    };
    let (order, hands) = (set.gears(), set.hands());
    let mut all: Vec<(Body, [f64; 3], [f64; 3])> = vec![];
    for (made, load) in toothed.meshes.iter().zip(set.mesh_loads(torques).unwrap()) {
        let radii = made.pair.working_diameters().map(|diameter| made.module * diameter / 2.0);
        let [one, other] = made.gears.map(centre);
        // The pitch point divides the line of centres, of an internal mesh outside.
        let way = [0, 1, 2].map(|axis: usize| other[axis] - one[axis]);
        let length = libm::hypot(way[0], way[1]);
        let sign = if made.pair.is_internal() { -1.0 } else { 1.0 };
        let point = [0, 1, 2].map(|axis: usize| one[axis] + sign * radii[0] * way[axis] / length);
        let forces = [0, 1].map(|end: usize| {
            let from = centre(made.gears[end]);
            let arm = [0, 1, 2].map(|axis: usize| point[axis] - from[axis]);
            assert!((libm::hypot(arm[0], arm[1]) / radii[end] - 1.0).abs() < 1e-9);
            let round = cross([0.0, 0.0, 1.0], arm).map(|part| part / radii[end]);
            let gear = made.pair.gears()[end];
            let hand = hands[order.iter().position(|one| *one == made.gears[end]).unwrap()];
            // tan β_w = π·d_w/lead
            let slope = hand * libm::tan(gear.profile().helix_angle.si()) * radii[end] * 2.0
                / (made.module * gear.reference_diameter());
            let tooth = [round[0] * slope, round[1] * slope, 1.0];
            let tangential = load.torques[end] / radii[end];
            let flat = round.map(|part| part * tangential);
            let along = -(0..3).map(|axis| flat[axis] * tooth[axis]).sum::<f64>();
            ([flat[0], flat[1], along], arm)
        });
        let size = forces[0].0.iter().map(|part| part.abs()).sum::<f64>();
        for axis in 0..3 {
            // What one gear feels the other feels reversed: hands and torques fit.
            assert!((forces[0].0[axis] + forces[1].0[axis]).abs() <= 1e-9 * size, "{} {forces:?}", set.id());
        }
        for (gear, (force, arm)) in made.gears.into_iter().zip(forces) {
            let body = match gear {
                GearOf::Central(central) => Body::Central(central),
                GearOf::Planet(planet, _) => Body::Planet(planet),
            };
            let moment = cross(arm, force);
            match all.iter_mut().find(|one| one.0 == body) {
                Some(own) => (0..3).for_each(|axis| {
                    own.1[axis] += force[axis];
                    own.2[axis] += moment[axis];
                }),
                None => all.push((body, force, moment)),
            }
        }
    }
    all
}

fn check(set: &PlanetSet, torques: &[f64]) {
    let toothed = set.toothed(&BasicRack::default(), &[]).unwrap();
    let angles = set.angles_between(&toothed, &[]).unwrap();
    let told = loads(set, &toothed, torques);
    let size = told.iter().flat_map(|one| &one.meshes).map(|one| one.1.abs()).fold(1e-9, f64::max);
    let lever = toothed.meshes.iter().map(|mesh| mesh.module * mesh.pair.centre_distance()).sum::<f64>();
    for (body, force, moment) in by_vectors(set, &toothed, torques) {
        let own = told.iter().find(|one| one.body == body).unwrap();
        match body {
            Body::Planet(planet) => {
                assert!((own.force - force[2]).abs() < 1e-9 * size, "{own:?} {force:?}");
                // No torque about the pin is left.
                assert!(moment[2].abs() < 1e-7 * size * lever, "{moment:?}");
                let (sin, cos) = libm::sincos(angles[planet].1.si());
                let turned = [moment[0] * cos + moment[1] * sin, moment[1] * cos - moment[0] * sin];
                for (own_part, part) in own.moment.iter().zip(turned) {
                    assert!((own_part - part).abs() < 1e-9 * size * lever, "{own:?}");
                }
            }
            Body::Central(_) if set.is_pair() => {
                assert!((own.force - force[2]).abs() < 1e-9 * size);
                for (own_part, part) in own.moment.iter().zip(moment) {
                    assert!((own_part - part).abs() < 1e-9 * size * lever, "{own:?}");
                }
            }
            Body::Central(_) => {
                let planets = f64::from(set.planet_count().unwrap());
                assert!((own.force - planets * force[2]).abs() < 1e-9 * size * planets);
            }
        }
    }
    // Nothing pushes the set as a whole.
    let planets = f64::from(set.planet_count().unwrap_or(1));
    let each = |one: &AxialLoad| if matches!(one.body, Body::Planet(_)) { planets } else { 1.0 };
    let sum: f64 = told.iter().map(|one| each(one) * one.force).sum();
    assert!(sum.abs() < 1e-9 * planets * size, "{sum} {told:?}");
}

proptest! {
    #[test]
    fn axial_forces_are_those_of_force_vectors_across_the_teeth(
        first in -30.0..30.0_f64, second in -30.0..30.0_f64, torque in -1e3..1e3_f64, share in -2.0..2.0_f64,
    ) {
        prop_assume!(first.abs() > 0.1 && second.abs() > 0.1 && torque.abs() > 1.0);
        let two = [first, second];
        let all = [
            short(SetKind::Simple, [20, 76], &[28], &[first; 2]),
            short(SetKind::SteppedSunRing, [20, 80], &[40, 20], &two),
            short(SetKind::SteppedRings, [100, 96], &[34, 30], &two),
            short(SetKind::SteppedSuns, [40, 44], &[30, 26], &two),
            short(SetKind::DoublePlanet, [30, 72], &[15, 18], &[first; 3]),
            short(SetKind::MeshingSuns, [30, 24], &[15, 18], &[first; 3]),
            short(SetKind::ExternalPair, [20, 41], &[], &[first]),
            short(SetKind::InternalPair, [20, 61], &[], &[first]),
        ];
        for set in all {
            check(&set, &[torque, -torque * set.ratio_between(0, 1)]);
        }
        let set = ravigneaux(first);
        let ratio = |central: usize| set.ratio_between(central, 0);
        check(&set, &[torque, torque * share, -torque * (1.0 + share * ratio(1)) / ratio(2)]);
    }
}

/// Stepped planets by hand: with equal leads and one hand nothing is left on the pin, with opposite hands the
/// thrusts add up.
#[test]
fn thrusts_of_a_stepped_planet_cancel_with_equal_leads_of_one_hand() {
    // Leads are equal where tan β/r is: sin β over the product of module and teeth.
    let plain = short(SetKind::SteppedSunRing, [20, 80], &[40, 20], &[10.0, 10.0]);
    let radii = |set: &PlanetSet| {
        let toothed = set.toothed(&BasicRack::default(), &[]).unwrap();
        let reference = |mesh: usize, end: usize| {
            let made = &toothed.meshes[mesh];
            made.module * made.pair.gears()[end].reference_diameter() / 2.0
        };
        ([reference(0, 1), reference(1, 0)], toothed)
    };
    let (mut second, mut left) = (10.0_f64, 1.0);
    // The module of the second step follows from its helix angle, so the angle is found in rounds.
    for _ in 0..60 {
        let set = short(SetKind::SteppedSunRing, [20, 80], &[40, 20], &[10.0, second]);
        let ([one, other], toothed) = radii(&set);
        second = libm::atan(libm::tan(10_f64.to_radians()) * other / one).to_degrees();
        left = loads(&set, &toothed, &[100.0, 400.0 * 2.0])[2].force;
    }
    let (_, toothed) = radii(&plain);
    let alike = loads(&plain, &toothed, &[100.0, 800.0]);
    assert!(left.abs() < 1e-9 * alike[2].meshes[0].1.abs(), "{left} {alike:?}");
    let sizes = |one: &AxialLoad| one.meshes.iter().map(|mesh| mesh.1.abs()).sum::<f64>();
    assert!(alike[2].force.abs() < sizes(&alike[2]));
    let against = short(SetKind::SteppedSunRing, [20, 80], &[40, 20], &[10.0, -10.0]);
    let (_, toothed) = radii(&against);
    let against = loads(&against, &toothed, &[100.0, 800.0]);
    assert!((against[2].force.abs() / sizes(&against[2]) - 1.0).abs() < 1e-12);
}

/// A right-handed gear that drives is pushed the way a right-handed screw would move backwards: with the
/// thumb of the right hand, its fingers along the rotation.
#[test]
fn a_right_handed_driver_is_pushed_along_its_rotation() {
    let set = short(SetKind::ExternalPair, [20, 40], &[], &[12.0]);
    let toothed = set.toothed(&BasicRack::default(), &[]).unwrap();
    // 10 N·m from outside drive gear 1 in the positive direction; 20 N·m on gear 2 hold it.
    let told = loads(&set, &toothed, &[10.0, 20.0]);
    assert_eq!(set.hands(), [1.0, -1.0]);
    assert!(told[0].force > 0.0 && (told[0].force + told[1].force).abs() < 1e-9 * told[0].force);
    let opposite = short(SetKind::ExternalPair, [20, 40], &[], &[-12.0]);
    assert!(loads(&opposite, &toothed, &[10.0, 20.0])[0].force < 0.0);
}

#[test]
fn meshes_of_one_gear_have_one_sign() {
    let set = short(SetKind::Simple, [20, 76], &[28], &[10.0, -10.0]);
    let error = set.toothed(&BasicRack::default(), &[]).unwrap_err().to_string();
    assert_eq!(error, "helix angles 10° and -10° differ; gears in mesh on parallel axes share one");
}

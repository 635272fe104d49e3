//! Losses by mesh, back-driving, self-locking, sign patterns.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use crate::common;

use common::machines::{ravigneaux_builder, ravigneaux_set};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::teeth::ToothCount;
use epicyclic_train::compound::{CentralKind, CompoundSpec};
use epicyclic_train::set::{MeshLoss, SetKind, SetSpec};
use epicyclic_train::{Direction, Gearbox, GearboxBuilder, InputLoad, State, Warning};
use uom::si::angular_velocity::radian_per_second;
use uom::si::f64::{AngularVelocity, Torque};
use uom::si::torque::newton_meter;

fn eta(value: f64) -> MeshEfficiency {
    MeshEfficiency::new(value).unwrap()
}

fn meshes_of(first: f64, between: f64, second: f64) -> MeshLoss {
    MeshLoss::Meshes { first: eta(first), between: eta(between), second: eta(second) }
}

/// Second gear of a Ravigneaux set, gear by gear: small sun drives, large sun held.
///
/// Seen from the carrier, power enters at the small sun, passes the short planets into the long
/// ones, and leaves these at the large sun and at the ring.
#[test]
fn a_shared_mesh_loses_on_its_net_force() {
    let (sun, short_long, large, ring) = (0.985, 0.98, 0.99, 0.995);
    let gearbox = ravigneaux_set([sun, short_long, large, ring]).build().unwrap();
    let found = gearbox.analyze("2").unwrap();
    let i_double = 72.0 / 30.0; // and i₀ = −2 between the large sun and the ring

    // By hand. Speeds with ω_Ss = 1, ω_Sl = 0: from both Willis equations.
    // ω_Ss − ω_C = 2.4·(ω_R − ω_C), −ω_C = −2·(ω_R − ω_C).
    let rolling = 1.0 / (i_double + 2.0); // ω_R − ω_C
    let (carrier, out) = (2.0 * rolling, 3.0 * rolling);
    assert!((found.ratio().unwrap() - 1.0 / out).abs() < 1e-14);
    // The large sun rests, so relative to the carrier it turns at −ω_C, and the torque that holds it
    // there follows from the balance of the carrier, which is loose: T_C = 0.
    // Long planet, as torque on the ring's radius: in 2.4·η·T, out to the ring and to the large sun.
    let driven = i_double * sun * short_long; // what the small sun's torque 1 brings to the long planet
    // Large sun: torque x, its rolling power −x·ω_C; x > 0 gives power to the sun side from planets.
    let solve = |large_factor: f64, ring_factor: f64| {
        // T_R = −ring·(driven − 2·large·x);  1 + x + T_R = 0.
        (ring_factor * driven - 1.0) / (1.0 + 2.0 * ring_factor * large_factor)
    };
    let x = solve(1.0 / large, ring); // x·(0 − ω_C) < 0: power leaves at the large sun
    assert!(x > 0.0);
    let output_torque = -1.0 - x;
    let efficiency = -output_torque * out;
    assert!(
        (found.efficiency().unwrap() - efficiency).abs() < 1e-13,
        "{:?} {efficiency}",
        found.efficiency()
    );
    assert!((efficiency - 0.97744).abs() < 5e-6);
    let case = found.driving().unwrap();
    assert!((case.members[0].as_ref().unwrap()[1] - x).abs() < 1e-13);
    assert!((found.kreines().unwrap().efficiency - efficiency).abs() < 1e-13);
    // Nothing joins the carrier in this gear: no torque on it, no power through it.
    assert!(case.power.links[gearbox.link("C").unwrap().index()].unwrap() < 1e-14);
    assert_eq!(case.power.circulating, 0.0);
    // Every mesh once: small sun to short, short to long, and from the long planets to large sun and ring.
    let meshes = case.meshes(&gearbox, 0).unwrap();
    let enters = 1.0 - carrier;
    assert!((meshes[0].enters - enters).abs() < 1e-13 && (meshes[0].leaves - enters * sun).abs() < 1e-13);
    assert!((meshes[1].leaves - enters * sun * short_long).abs() < 1e-13);
    assert!((meshes[2].leaves - x * carrier).abs() < 1e-13);
    let passes = meshes[1].leaves - meshes[2].enters;
    assert!((meshes[3].enters - passes).abs() < 1e-13 && (meshes[3].leaves - passes * ring).abs() < 1e-13);
    let equal = ravigneaux_set([0.98; 4]).build().unwrap();
    assert!((equal.analyze("2").unwrap().efficiency().unwrap() - 0.96792).abs() < 5e-6);

    // As two sets, each loses in the ring mesh on its own part: the parts oppose each other, so
    // that way counts the loss of more power than the mesh carries.
    let losses = [meshes_of(sun, short_long, ring), meshes_of(large, 1.0, ring)];
    let apart = ravigneaux_builder(losses).build().unwrap();
    assert!(apart.analyze("2").unwrap().efficiency().unwrap() < efficiency);
    // The remark that says so needs the teeth of the ring.
    assert!(matches!(apart.warnings(), [Warning::SharedPlanets { member: CentralKind::Ring, .. }]));
}

#[test]
fn a_shared_mesh_without_loss_is_none() {
    let losses = [meshes_of(0.98, 0.99, 1.0), meshes_of(0.97, 1.0, 1.0)];
    let shared = ravigneaux_set([0.98, 0.99, 0.97, 1.0]).build().unwrap();
    let apart = ravigneaux_builder(losses).build().unwrap();
    for gear in shared.gears() {
        let [a, b] =
            [&shared, &apart].map(|gearbox| gearbox.analyze(gear.name()).unwrap().efficiency().unwrap());
        assert!((a - b).abs() < 1e-14, "{}", gear.name());
    }
}

/// A set nearly idle beside two loaded ones: their losses reverse its power, and the signs that
/// Kreines' rule takes from the ideal ratio would let it gain power.
#[test]
fn losses_can_reverse_a_set_that_is_nearly_idle() {
    let set = |id: &str, kind, members, sun, ring, e| {
        SetSpec::teeth(id, kind, members, sun, ring).unwrap().with_loss(MeshLoss::Set(eta(e)))
    };
    let gearbox = Gearbox::builder("nearly idle")
        .links(["in", "x", "y", "out"])
        .set(set("1", SetKind::Simple, ["in", "y", "x"], 30, 71, 0.9136))
        .set(set("2", SetKind::MeshingSuns, ["out", "y", "x"], 34, 76, 0.9899))
        .set(set("3", SetKind::DoublePlanet, ["in", "y", "ground"], 48, 101, 0.9711))
        .input("in")
        .output("out")
        .gear("1", [""; 0])
        .build()
        .unwrap();
    let found = gearbox.analyze("1").unwrap();
    let kreines = found.kreines().unwrap();
    assert_eq!(kreines.exponents, [[1], [-1], [1]]);
    assert_eq!(found.driving().unwrap().signs, [1, -1, -1]);
    assert_eq!(kreines.reversed, ["3"]);
    // Only one pattern is self-consistent, and it is not the printed one.
    assert_eq!(found.patterns().len(), 1);
    let efficiency = found.efficiency().unwrap();
    assert!((kreines.efficiency - efficiency).abs() > 5e-4);
    assert!((kreines.efficiency_loaded.unwrap() - efficiency).abs() < 1e-13);
    for set in found.driving().unwrap().power.sets.iter().flatten() {
        assert!(set.loss > 0.0);
    }
}

/// One set of `i₀` near 1 between carrier and sun, ring at rest.
fn slow_set(i0: f64, eta0: f64, input: &str, output: &str) -> Gearbox {
    Gearbox::builder("near one")
        .links(["sun", "ring", "carrier"])
        .set(
            SetSpec::new("1", SetKind::SteppedRings, ["sun", "ring", "carrier"], i0)
                .with_loss(MeshLoss::Set(eta(eta0))),
        )
        .ground("ring")
        .input(input)
        .output(output)
        .gear("1", [""; 0])
        .build()
        .unwrap()
}

#[test]
fn a_set_near_one_drives_one_way_only() {
    // Carrier to sun at i₀ = 0.99: T_H = (î₀ − 1)·T_a with power from sun to ring, î₀ = i₀·η₀.
    let gearbox = slow_set(0.99, 0.97, "carrier", "sun");
    let found = gearbox.analyze("1").unwrap();
    let driving = 0.01 / (1.0 - 0.99 * 0.97);
    assert!((found.efficiency().unwrap() - driving).abs() < 1e-13);
    // Back: î₀ = i₀/η₀, (î₀ − 1) has changed its sign.
    let back = (1.0 - 0.99 / 0.97) / 0.01;
    assert!((found.back_driving_efficiency().unwrap() - back).abs() < 1e-11);
    assert_eq!(found.is_self_locking(), Some(true));
    let gearbox = slow_set(0.5, 0.97, "carrier", "sun");
    let free = gearbox.analyze("1").unwrap();
    assert_eq!(free.is_self_locking(), Some(false));
}

#[test]
fn back_driving_loads_scale_to_the_input() {
    let gearbox = slow_set(0.5, 0.97, "carrier", "sun");
    let found = gearbox.analyze("1").unwrap();
    let rad = AngularVelocity::new::<radian_per_second>(10.0);
    let load = InputLoad::Torque(Torque::new::<newton_meter>(-7.0));
    let work = found.at(rad, load).unwrap();
    assert_eq!(work.direction, Direction::BackDrive);
    assert!((work.input.get::<newton_meter>() - -7.0).abs() < 1e-12);
    let entering = work.entering.get::<uom::si::power::watt>();
    assert!((70.0 / entering - found.back_driving_efficiency().unwrap()).abs() < 1e-13);
    assert!((work.loss.get::<uom::si::power::watt>() - (entering - 70.0)).abs() < 1e-10);
    let gearbox = slow_set(0.99, 0.97, "carrier", "sun");
    let locked = gearbox.analyze("1").unwrap();
    assert!(locked.at(rad, load).is_err());
}

#[test]
fn a_self_locking_gear_has_a_second_pattern() {
    // Sun to carrier at i₀ = 0.99: T_H = (î₀ − 1)·T_a. With power from ring to sun (the ideal sign)
    // î₀ = 0.99/0.97 and the output torque turns; the other sign contradicts itself.
    let gearbox = slow_set(0.99, 0.97, "sun", "carrier");
    let found = gearbox.analyze("1").unwrap();
    assert!(found.efficiency().unwrap() < 0.0);
    // No torque at the input moves it, and the state says so; its speeds still follow.
    assert_eq!(*found.state(), State::SelfLocking { links: vec!["sun".into()], both_ways: false });
    assert_eq!(*found.kinematic_state(), State::Driven);
    let rad = AngularVelocity::new::<radian_per_second>(10.0);
    assert!(found.at(rad, InputLoad::Torque(Torque::new::<newton_meter>(7.0))).is_err());
    assert_eq!(found.patterns().len(), 1);
    assert!(found.patterns()[0].chosen);
    // Carrier to sun at 0.99 with the carrier's torque given: both signs are self-consistent when
    // the carrier's factor î₀ − 1 changes sign between them.
    let gearbox = slow_set(0.99, 0.97, "carrier", "sun");
    let found = gearbox.analyze("1").unwrap();
    let efficiencies: Vec<f64> = found.patterns().iter().map(|p| p.efficiency).collect();
    assert_eq!(efficiencies.len(), 2, "{efficiencies:?}");
    assert!((efficiencies[0] - 0.01 / (1.0 - 0.99 * 0.97)).abs() < 1e-13);
    assert!((efficiencies[1] - 0.01 / (1.0 - 0.99 / 0.97)).abs() < 1e-13);
}

/// Steps 34 and 30, rings 100 held and 96 driven: 51 to 1.
#[test]
fn a_wolfrom_drive_loses_in_three_meshes_not_in_four() {
    let each = eta(0.99);
    let terminals =
        |builder: GearboxBuilder| builder.input("S").output("out").gear("only", [""; 0]).build().unwrap();
    let links = || Gearbox::builder("Wolfrom").links(["S", "arm", "out"]);
    let whole = CompoundSpec::new("W", "arm")
        .sun("S", 32)
        .ring("ground", 100)
        .ring("out", 96)
        .planet("p", &[34, 30])
        .mesh("S", "p.1", each)
        .mesh("p.1", "ground", each)
        .mesh("p.2", "out", each);
    let gearbox = terminals(links().compound_set(whole));
    let found = gearbox.analyze("only").unwrap();
    assert_eq!(found.exact_ratio().unwrap().to_string(), "51");
    assert!((found.efficiency().unwrap() - 0.803).abs() < 5e-4, "{:?}", found.efficiency());
    assert_eq!(*found.state(), State::Driven);

    let teeth = |z| ToothCount::new(z).unwrap();
    // As two sets, the sun's mesh is loaded twice, one way by each.
    let apart = links()
        .set(SetSpec::teeth("1", SetKind::Simple, ["S", "ground", "arm"], 32, 100).unwrap())
        .set(
            SetSpec::teeth("2", SetKind::SteppedSunRing, ["S", "out", "arm"], 32, 96)
                .unwrap()
                .planet_teeth(teeth(34), Some(teeth(30))),
        )
        .map_sets(|set| set.with_loss(meshes_of(0.99, 1.0, 0.99)));
    let found = terminals(apart);
    let found = found.analyze("only").unwrap();
    assert!((found.ratio().unwrap() - 51.0).abs() < 1e-10);
    assert!((found.efficiency().unwrap() - 0.680).abs() < 5e-4, "{:?}", found.efficiency());
}

/// Low gear of a two-speed Ravigneaux set: the 28-tooth sun drives long planets, these short ones, these the
/// held sun of 23 teeth; the ring on the short planets idles, the carrier drives.
#[test]
fn an_idle_ring_neither_loses_nor_circulates() {
    let each = eta(0.99);
    let set = CompoundSpec::new("PG", "out")
        .sun("in", 28)
        .sun("low", 23)
        .ring("rev", 79)
        .planet("long", &[18])
        .planet("short", &[28])
        .mesh("in", "long", each)
        .mesh("long", "short", each)
        .mesh("short", "low", each)
        .mesh("short", "rev", each);
    let gears = |builder: GearboxBuilder| {
        builder
            .brake("B", "low")
            .brake("R", "rev")
            .input("in")
            .output("out")
            .gear("L", ["B"])
            .gear("R", ["R"])
    };
    let links = || Gearbox::builder("Powerglide").links(["in", "low", "rev", "out"]);
    let gearbox = gears(links().compound_set(set)).build().unwrap();
    let low = gearbox.analyze("L").unwrap();
    assert_eq!(low.exact_ratio().unwrap().to_string(), "51/28");
    let by_hand = (1.0 + 0.99_f64.powi(3) * 23.0 / 28.0) / (1.0 + 23.0 / 28.0);
    assert!((low.efficiency().unwrap() - by_hand).abs() < 1e-14 && (by_hand - 0.9866).abs() < 5e-5);
    let case = low.driving().unwrap();
    assert_eq!(case.power.circulating, 0.0);
    assert_eq!(case.meshes(&gearbox, 0).unwrap()[3].enters, 0.0);
    let reverse = gearbox.analyze("R").unwrap();
    assert_eq!(reverse.exact_ratio().unwrap().to_string(), "-51/28");
    // Ring held, 79/28 − 1 out for 1 in: (0.99³·79/28 − 1)/(79/28 − 1).
    let by_hand = (0.99_f64.powi(3) * 79.0 / 28.0 - 1.0) / (79.0 / 28.0 - 1.0);
    assert!((reverse.efficiency().unwrap() - by_hand).abs() < 1e-14);

    // As two sets, the ring's mesh is loaded from both sides.
    let apart = links()
        .set(
            SetSpec::teeth("1", SetKind::DoublePlanet, ["in", "rev", "out"], 28, 79)
                .unwrap()
                .with_loss(meshes_of(0.99, 0.99, 0.99)),
        )
        .set(
            SetSpec::teeth("2", SetKind::Simple, ["low", "rev", "out"], 23, 79)
                .unwrap()
                .with_loss(meshes_of(0.99, 1.0, 0.99)),
        );
    let apart = gears(apart).build().unwrap();
    let apart = apart.analyze("L").unwrap();
    assert!((apart.efficiency().unwrap() - 0.9779).abs() < 5e-5);
    let circulating = apart.driving().unwrap().power.circulating;
    // The first set gives at the ring what enters and what the carrier brings back, less its loss.
    let (carrier, ring) = (28.0 / 51.0, 28.0 / 51.0 * (1.0 + 23.0 / 79.0));
    let each = 0.99_f64.powi(3);
    let by_hand = each * 79.0 / 28.0 * ring + (1.0 - each) * (1.0 - carrier) - 1.0;
    assert!((circulating - by_hand).abs() < 1e-12, "{circulating} {by_hand}");
}

/// Two sets of i₀ near 1 face to face: from either end one of them is driven from its sun.
#[test]
fn a_gear_can_lock_itself_from_both_ends() {
    let set = |id: &str, sun: &str| {
        SetSpec::new(id, SetKind::SteppedRings, [sun, "ground", "x"], 0.99)
            .with_loss(MeshLoss::Set(eta(0.97)))
    };
    let gearbox = Gearbox::builder("face to face")
        .links(["a", "x", "b"])
        .set(set("1", "a"))
        .set(set("2", "b"))
        .input("a")
        .output("b")
        .gear("g", [""; 0])
        .build()
        .unwrap();
    let found = gearbox.analyze("g").unwrap();
    assert_eq!(*found.state(), State::SelfLocking { links: vec!["a".into()], both_ways: true });
    assert!(found.state().has_ratio() && found.ratio() == Some(1.0));
    assert!(found.efficiency().is_none_or(|eta| eta <= 0.0));
    assert!(found.back_driving_efficiency().is_none_or(|eta| eta <= 0.0));
    let rad = AngularVelocity::new::<radian_per_second>(10.0);
    for torque in [7.0, -7.0] {
        assert!(found.at(rad, InputLoad::Torque(Torque::new::<newton_meter>(torque))).is_err());
    }
    // Only forwards: the output can still drive the input.
    let gearbox = slow_set(0.99, 0.97, "sun", "carrier");
    let found = gearbox.analyze("1").unwrap();
    assert_eq!(*found.state(), State::SelfLocking { links: vec!["sun".into()], both_ways: false });
    let back = found.at(rad, InputLoad::Torque(Torque::new::<newton_meter>(-7.0))).unwrap();
    assert_eq!(back.direction, Direction::BackDrive);
    // Only backwards: driven, as a hoist is.
    let gearbox = slow_set(0.99, 0.97, "carrier", "sun");
    let found = gearbox.analyze("1").unwrap();
    assert_eq!((found.state(), found.is_self_locking()), (&State::Driven, Some(true)));
}

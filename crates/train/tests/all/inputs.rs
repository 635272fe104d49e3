//! Gears with several inputs: power splits, sums, what is refused.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use crate::common;

use common::oracle::{BoxPlan, Dice};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_train::inputs::MultiState;
use epicyclic_train::set::{MeshLoss, SetKind, SetSpec};
use epicyclic_train::{Error, Gearbox, InputsFault, LinkId, State};
use uom::si::angular_velocity::radian_per_second;
use uom::si::f64::{AngularVelocity, Power, Torque};
use uom::si::power::watt;
use uom::si::torque::newton_meter;

fn rad_s(value: f64) -> AngularVelocity {
    AngularVelocity::new::<radian_per_second>(value)
}

fn n_m(value: f64) -> Torque {
    Torque::new::<newton_meter>(value)
}

fn speed(state: &MultiState, link: LinkId) -> f64 {
    state.speeds[link.index()].unwrap().get::<radian_per_second>()
}

fn watts(power: Power) -> f64 {
    power.get::<watt>()
}

/// Engine on the carrier, generator on the sun, wheels on the ring; the motor on the ring by a set with its
/// carrier held.
fn power_split(eta: f64) -> Gearbox {
    let loss = MeshLoss::Set(MeshEfficiency::new(eta).unwrap());
    Gearbox::builder("power split")
        .links(["engine", "mg1", "mg2", "ring", "loose"])
        .set(
            SetSpec::teeth("PSD", SetKind::Simple, ["mg1", "ring", "engine"], 30, 78)
                .unwrap()
                .with_loss(loss),
        )
        .set(
            SetSpec::teeth("MSR", SetKind::Simple, ["mg2", "ring", "ground"], 22, 58)
                .unwrap()
                .with_loss(loss),
        )
        .brake("hold", "mg1")
        .brake("park", "ring")
        .clutch("lock", "engine", "mg1")
        .input("engine")
        .output("ring")
        .gear("split", [""; 0])
        .gear("held", ["hold"])
        .gear("parked", ["park"])
        .build()
        .unwrap()
}

fn at(
    gearbox: &Gearbox,
    gear: &str,
    speeds: &[(&str, f64)],
    torques: &[(&str, f64)],
) -> Result<MultiState, Error> {
    let link = |name: &str| gearbox.link(name).unwrap();
    let speeds: Vec<_> = speeds.iter().map(|&(name, value)| (link(name), rad_s(value))).collect();
    let torques: Vec<_> = torques.iter().map(|&(name, value)| (link(name), n_m(value))).collect();
    gearbox.with_inputs(gearbox.gear(gear).unwrap(), &speeds, &torques)
}

/// With the speeds of engine and ring given, the generator is an open end, and takes what the ring's torque
/// leaves.
#[test]
fn an_open_end_takes_the_torque_that_is_left() {
    let gearbox = power_split(0.97);
    let by_end =
        at(&gearbox, "split", &[("engine", 150.0), ("ring", 200.0)], &[("ring", -60.0), ("mg2", 5.0)]);
    let generator = speed(by_end.as_ref().unwrap(), gearbox.link("mg1").unwrap());
    let named =
        at(&gearbox, "split", &[("engine", 150.0), ("mg1", generator)], &[("ring", -60.0), ("mg2", 5.0)]);
    let torques = |state: Result<MultiState, Error>| -> Vec<f64> {
        let terminals = state.unwrap().load.unwrap().terminals;
        let mut all: Vec<f64> = terminals.iter().map(|end| end.torque.get::<newton_meter>()).collect();
        all.sort_by(f64::total_cmp);
        all
    };
    let (by_end, named) = (torques(by_end), torques(named));
    assert_eq!(by_end.len(), 4);
    for (one, other) in by_end.iter().zip(&named) {
        assert!((one - other).abs() < 1e-9, "{by_end:?} {named:?}");
    }
    // Two open ends share what is left in ways that one torque does not settle.
    let open = at(&gearbox, "split", &[("engine", 150.0), ("ring", 200.0)], &[("ring", -60.0)]);
    assert!(matches!(open, Err(Error::Inputs(InputsFault::Torques { .. }))));
}

#[test]
fn a_power_split_divides_torque_by_its_teeth() {
    let gearbox = power_split(1.0);
    let link = |name: &str| gearbox.link(name).unwrap();
    let state =
        at(&gearbox, "split", &[("engine", 200.0), ("mg1", 300.0)], &[("engine", 108.0), ("mg2", 22.0)])
            .unwrap();
    assert_eq!(state.freedoms, 2);
    // 30·ω_s + 78·ω_r = 108·ω_H; ω_mg2 = −(58/22)·ω_r.
    let ring = (108.0 * 200.0 - 30.0 * 300.0) / 78.0;
    assert!((speed(&state, link("ring")) - ring).abs() < 1e-10);
    assert!((speed(&state, link("mg2")) + 58.0 / 22.0 * ring).abs() < 1e-10);
    assert_eq!(state.speeds[link("loose").index()], None);
    let load = state.load.unwrap();
    let names: Vec<&str> = load.terminals.iter().map(|one| gearbox.link_name(one.link)).collect();
    assert_eq!(names, ["engine", "ring", "mg1", "mg2"]);
    let torque: Vec<f64> = load.terminals.iter().map(|one| one.torque.get::<newton_meter>()).collect();
    // The engine's 108 hold −30 at the sun; the ring takes 78 less what the motor adds, −58.
    for (own, expected) in torque.iter().zip([108.0, -78.0 + 58.0, -30.0, 22.0]) {
        assert!((own - expected).abs() < 1e-10, "{torque:?}");
    }
    assert!(watts(load.loss).abs() < 1e-9);
    let sum: f64 = load.terminals.iter().map(|one| watts(one.power)).sum();
    assert!(sum.abs() < 1e-9);
}

#[test]
fn losses_and_powers_balance_whatever_the_speeds() {
    let gearbox = power_split(0.96);
    for mg1 in [-800.0, -200.0, 0.0, 150.0, 200.0, 900.0] {
        for motor in [-40.0, 0.0, 15.0] {
            let speeds = [("engine", 200.0), ("mg1", mg1)];
            let found = at(&gearbox, "split", &speeds, &[("engine", 100.0), ("mg2", motor)]);
            let load = found.unwrap().load.unwrap();
            let enters: f64 = load.terminals.iter().map(|one| watts(one.power)).sum();
            let most = load.terminals.iter().fold(1.0, |most: f64, one| most.max(watts(one.power).abs()));
            assert!((enters - watts(load.loss)).abs() < 1e-11 * most);
            assert!(watts(load.loss) >= -1e-11 * most, "{mg1} {motor}: {:?}", load.loss);
            // By hand: the sun's rolling power T_s·(ω_s − ω_H) loses 4 % of what enters.
            let sun = load.members[0][0];
            let rolling = sun * (mg1 - 200.0);
            let ring_torque = load.members[0][1];
            let ratio = if rolling > 0.0 { 0.96 } else { 1.0 / 0.96 };
            if mg1 != 200.0 {
                assert!((ring_torque - 78.0 / 30.0 * ratio * sun).abs() < 1e-9, "{mg1} {motor}");
            }
            // Twice the speeds and torques, four times the power.
            let twice = [("engine", 400.0), ("mg1", 2.0 * mg1)];
            let doubled = at(&gearbox, "split", &twice, &[("engine", 200.0), ("mg2", 2.0 * motor)]).unwrap();
            let again = doubled.load.unwrap();
            assert!((watts(again.loss) - 4.0 * watts(load.loss)).abs() < 1e-11 * most);
            assert_eq!(load.efficiency.is_some(), again.efficiency.is_some());
        }
    }
}

#[test]
fn too_few_too_many_and_dependent_values_are_named() {
    let gearbox = power_split(0.97);
    let fault = |gear: &str, speeds: &[(&str, f64)], torques: &[(&str, f64)]| {
        at(&gearbox, gear, speeds, torques).unwrap_err().to_string()
    };
    assert_eq!(
        fault("split", &[("engine", 200.0)], &[]),
        "the gear keeps 2 freedoms and the speeds given are 1: add that of one of mg1, mg2, ring"
    );
    assert_eq!(
        fault("split", &[("ring", 20.0), ("mg2", 30.0)], &[]),
        "the speed of `mg2` is given, but it follows from the others: leave it out"
    );
    assert_eq!(
        fault("split", &[("engine", 1.0), ("mg1", 2.0), ("ring", 3.0)], &[]),
        "the speed of `ring` is given, but it follows from the others: leave it out"
    );
    assert_eq!(fault("parked", &[("ring", 20.0)], &[]), "`ring` is held to the housing in this gear");
    let speeds = [("engine", 200.0), ("mg1", 100.0)];
    assert_eq!(
        fault("split", &speeds, &[("engine", 1.0), ("ring", 1.0), ("mg1", 1.0)]),
        "1 of the torques at engine, ring, mg1 must be given: 3 are given"
    );
    let found = at(&gearbox, "split", &speeds, &[("engine", 1.0), ("mg2", 5.0), ("mg1", 3.0)]).unwrap_err();
    assert!(matches!(found, Error::Inputs(InputsFault::Torques { given: 3, needed: 2, .. })), "{found}");
    for wrong in [f64::NAN, f64::INFINITY] {
        assert!(at(&gearbox, "split", &[("engine", wrong), ("mg1", 1.0)], &[]).is_err());
        assert!(at(&gearbox, "split", &speeds, &[("engine", wrong)]).is_err());
    }
}

#[test]
fn twin_sets_share_a_torque_that_nothing_settles() {
    let set = |id: &str| SetSpec::simple(id, ["a", "b", "H"], 3.0);
    let gearbox = Gearbox::builder("twins")
        .links(["a", "b", "H"])
        .set(set("1"))
        .set(set("2"))
        .input("a")
        .output("H")
        .gear("split", [""; 0])
        .build()
        .unwrap();
    let speeds = [("a", 10.0), ("b", 20.0)];
    assert!(at(&gearbox, "split", &speeds, &[]).is_ok());
    let refused = at(&gearbox, "split", &speeds, &[("a", 1.0)]).unwrap_err();
    assert_eq!(refused.to_string(), "sets 1, 2 share a torque that nothing settles");
}

/// A clutch makes engine and ring one piece: the torque that enters leaves at the ring.
#[test]
fn power_passes_straight_through_a_clutch() {
    let gearbox = Gearbox::builder("direct")
        .links(["a", "b", "H"])
        .set(SetSpec::simple("1", ["a", "b", "H"], 3.0))
        .clutch("aH", "a", "H")
        .input("a")
        .output("H")
        .gear("direct", ["aH"])
        .build()
        .unwrap();
    let load = at(&gearbox, "direct", &[("a", 10.0)], &[("a", 5.0)]).unwrap().load.unwrap();
    assert_eq!(load.terminals.len(), 2);
    assert!((load.terminals[1].torque.get::<newton_meter>() + 5.0).abs() < 1e-14);
    assert!((load.shift_elements[0].unwrap().get::<newton_meter>() + 5.0).abs() < 1e-14);
}

#[test]
fn a_second_input_at_rest_is_a_brake() {
    let gearbox = power_split(0.96);
    let held = gearbox.analyze("held").unwrap();
    for turn in [1.0, -1.0] {
        let state =
            at(&gearbox, "split", &[("engine", 150.0 * turn), ("mg1", 0.0)], &[("engine", 80.0 * turn)])
                .unwrap();
        for (link, speed) in held.speeds().iter().enumerate() {
            let own = state.speeds[link].map(|speed| speed.get::<radian_per_second>());
            assert_eq!(own.is_some(), speed.is_some());
            assert!((own.unwrap_or(0.0) - 150.0 * turn * speed.unwrap_or(0.0)).abs() < 1e-10);
        }
        let load = state.load.unwrap();
        let case = held.driving().unwrap();
        assert!((load.efficiency.unwrap() - case.efficiency).abs() < 1e-13);
        assert!((load.terminals[1].torque.get::<newton_meter>() - 80.0 * turn * case.output).abs() < 1e-10);
        assert!(
            (load.terminals[2].torque.get::<newton_meter>() - 80.0 * turn * case.shift_elements[0].unwrap())
                .abs()
                < 1e-10
        );
    }
}

/// Random gearboxes, driven: one speed and one torque say what the analysis says; one freed and given again
/// too.
#[test]
fn one_input_agrees_with_the_analysis() {
    let mut dice = Dice(0x0dd);
    let (mut driven, mut braked) = (0, 0);
    for _ in 0..10_000 {
        let plan = BoxPlan::random(4, 40, &mut dice);
        let Ok(gearbox) = plan.build(None) else { continue };
        let gear = gearbox.gear("g").unwrap();
        let found = gearbox.analyze_gear(gear).unwrap();
        let Some(case) = found.driving().filter(|_| *found.kinematic_state() == State::Driven) else {
            continue;
        };
        let power = case.power.largest;
        if power > 1e4 || found.ratio().unwrap().abs() > 1e3 || found.ratio().unwrap().abs() < 1e-3 {
            continue;
        }
        let input = gearbox.input();
        let state = gearbox.with_inputs(gear, &[(input, rad_s(2.0))], &[(input, n_m(3.0))]).unwrap();
        let load = state.load.as_ref().unwrap();
        let torque = case.members.iter().flatten().flatten().fold(power, |most, t| most.max(t.abs()));
        for (own, expected) in load.members.iter().zip(&case.members) {
            // A set that is locked beside the power path has no torque that follows.
            for (own, expected) in own.iter().zip(expected.iter().flatten()) {
                assert!((own - 3.0 * expected).abs() < 1e-9 * torque);
            }
        }
        assert!((watts(load.loss) - 6.0 * (1.0 - case.efficiency)).abs() < 1e-9 * power);
        assert!((load.power.circulating - 6.0 * case.power.circulating).abs() < 1e-9 * power);
        for (own, expected) in load.shift_elements.iter().zip(&case.shift_elements) {
            assert_eq!(own.is_some(), expected.is_some());
            let Some((own, expected)) = own.zip(*expected) else { continue };
            assert!((own.get::<newton_meter>() - 3.0 * expected).abs() < 1e-9 * torque);
        }
        driven += 1;

        // Let a brake go and give its link's speed as 0 instead.
        let brake = gear.engaged().iter().copied().find(|&place| gearbox.shift_elements()[place].is_brake());
        let Some(brake) = brake else { continue };
        let ids: Vec<&str> = gear
            .engaged()
            .iter()
            .filter(|place| **place != brake)
            .map(|&place| gearbox.shift_elements()[place].id())
            .collect();
        let name = |link: LinkId| gearbox.link_name(link).to_owned();
        let open = gearbox.gear_of(&ids, &name(input), &name(gearbox.output())).unwrap();
        let held = gearbox.shift_elements()[brake].links()[0];
        let freed = gearbox.analyze_gear(&open).unwrap();
        if held == gearbox.output() || !matches!(freed.state(), State::Underdetermined { missing: 1, .. }) {
            continue;
        }
        let speeds = [(input, rad_s(2.0)), (held, rad_s(0.0))];
        let state = gearbox.with_inputs(&open, &speeds, &[(input, n_m(3.0))]).unwrap();
        let load = state.load.as_ref().unwrap();
        assert!((watts(load.loss) - 6.0 * (1.0 - case.efficiency)).abs() < 1e-9 * power);
        let own = load.terminals.iter().find(|one| one.link == held);
        if let Some((own, expected)) = own.zip(case.shift_elements[brake]) {
            let expected = 3.0 * expected;
            assert!((own.torque.get::<newton_meter>() - expected).abs() < 1e-9 * torque);
        }
        braked += 1;
    }
    assert!(driven > 2500 && braked > 40, "{driven} {braked}");
}

//! Dog clutches: impacts that keep momentum and lose energy.
#![allow(clippy::unwrap_used, reason = "helpers of tests, with fixed data")]

use crate::common;

use common::{
    at, close, constant, end_speed, joules, kg_m2, masses_t, omega, s, speed, start, table, train_t,
};
use epicyclic_motion::{Change, Error, Mechanism, Model, State};
use epicyclic_train::GROUND;
use epicyclic_train::set::MeshLoss;
use uom::si::f64::Torque;
use uom::si::moment_of_inertia::kilogram_square_meter;
use uom::si::torque::newton_meter;

const J: [f64; 2] = [2.0, 5.0];

fn pair() -> Model {
    Model::new(Mechanism::shafts(&[("a", kg_m2(J[0])), ("b", kg_m2(J[1]))]).unwrap())
}

#[test]
fn two_bodies_keep_their_momentum_and_lose_the_energy_of_their_slip() {
    let mut model = pair();
    model.dog_clutch("dog", ["a", "b"], &[(s(1.0), true), (s(2.0), false)], None).unwrap();
    model.torque("motor", "a", constant(14.0)).unwrap();
    let run = model.run(&start(&[("a", 50.0), ("b", 10.0)]), s(3.0), None).unwrap();
    let [meshed, opened] = run.events.as_slice() else { panic!("{:?}", run.events) };
    assert_eq!((at(meshed), at(opened)), (1.0, 2.0));
    let common = (J[0] * 57.0 + J[1] * 10.0) / (J[0] + J[1]);
    close(speed(&run, &meshed.after, "a"), common, 1e-12);
    close(speed(&run, &meshed.after, "b"), common, 1e-12);
    let slip: f64 = 57.0 - 10.0;
    close(joules(run.audit.impacts), 0.5 * J[0] * J[1] / (J[0] + J[1]) * slip * slip, 1e-12);
    close(-common::torque_of(&meshed.after, 0), 14.0 * 5.0 / 7.0, 1e-12);
    close(end_speed(&run, "b"), common + 2.0, 1e-12);
    close(end_speed(&run, "a"), common + 2.0 + 7.0, 1e-12);
    assert_eq!(opened.changes, [Change::Element { name: "dog".into(), from: State::Stuck, to: State::Open }]);
    assert!(run.audit.residual().abs() < 1e-12);
}

#[test]
fn a_dog_clutch_waits_until_it_is_slow_enough() {
    let mut model = pair();
    model.torque("motor", "b", constant(10.0)).unwrap();
    model.dog_clutch("dog", ["a", "b"], &[(s(0.0), true)], Some(omega(4.0))).unwrap();
    let run = model.run(&start(&[("a", 50.0), ("b", 10.0)]), s(30.0), None).unwrap();
    let [meshed] = run.events.as_slice() else { panic!("{:?}", run.events) };
    close(at(meshed), (40.0 - 4.0) / 2.0, 1e-11);
    close(joules(run.audit.impacts), 0.5 * 10.0 / 7.0 * 16.0, 1e-10);
    // At no slip at all it engages where the slip turns.
    let mut model = pair();
    model.torque("motor", "b", constant(10.0)).unwrap();
    model.dog_clutch("dog", ["a", "b"], &[(s(0.0), true)], Some(omega(0.0))).unwrap();
    let run = model.run(&start(&[("a", 50.0), ("b", 10.0)]), s(30.0), None).unwrap();
    close(at(&run.events[0]), 20.0, 1e-11);
    assert!(joules(run.audit.impacts).abs() < 1e-9);
    close(end_speed(&run, "a"), 50.0 + 100.0 / 7.0, 1e-11);
}

/// Willis by hand: sun, ring and carrier of train T with planets, from the energies of all bodies.
#[test]
fn the_ring_of_a_set_that_is_caught_throws_its_momentum_on_sun_and_carrier() {
    let mut model = Model::new(Mechanism::of(&train_t(MeshLoss::IDEAL), &[], &masses_t(true)).unwrap());
    model.shift_dog_clutch("hold", &[(s(0.5), true)], None).unwrap();
    let run = model.run(&start(&[("sun", 100.0), ("ring", -20.0)]), s(1.0), None).unwrap();
    let carrier = (20.0 * 100.0 - 70.0 * 20.0) / 90.0;
    // With the impulse Λ on the ring alone, that of the virtual motion with the ring at rest is kept:
    // Σ J·ω·ω', ω' = (4.5, 0, 1), planet −1·2.5·… relative to the carrier.
    let planet = |sun: f64, carrier: f64| carrier - (sun - carrier) * 20.0 / 25.0;
    let momentum = |sun: f64, ring: f64, carrier: f64| {
        let orbital = 0.5 + 3.0 * 0.3 * 0.045 * 0.045;
        let virtual_planet = planet(4.5, 1.0);
        0.01 * sun * 4.5
            + 0.05 * ring * 0.0
            + orbital * carrier
            + 3.0 * 1e-4 * planet(sun, carrier) * virtual_planet
    };
    let end = end_speed(&run, "carrier");
    close(end_speed(&run, "sun"), 4.5 * end, 1e-12);
    assert!(end_speed(&run, "ring").abs() < 1e-12);
    close(momentum(4.5 * end, 0.0, end), momentum(100.0, -20.0, carrier), 1e-12);
    let felt = common::held_t().equivalent_inertia("carrier").unwrap().get::<kilogram_square_meter>();
    close(joules(run.audit.after), 0.5 * felt * end * end, 1e-12);
    close(joules(run.audit.impacts), joules(run.audit.before) - joules(run.audit.after), 1e-12);
    assert!(joules(run.audit.impacts) > 0.0);
}

#[test]
fn a_one_way_clutch_takes_part_where_it_would_slip_backwards() {
    let bodies = [("a", kg_m2(2.0)), ("b", kg_m2(5.0)), ("c", kg_m2(1.0))];
    let mut model = Model::new(Mechanism::shafts(&bodies).unwrap());
    // b never turns slower than c.
    model.one_way_clutch("free-wheel", ["b", "c"]).unwrap();
    model.dog_clutch("dog", ["a", "b"], &[(s(0.1), true)], None).unwrap();
    // a slows b below c, which goes with them.
    let run = model.run(&start(&[("a", 0.0), ("b", 14.0), ("c", 13.0)]), s(0.2), None).unwrap();
    for link in ["a", "b", "c"] {
        close(end_speed(&run, link), (5.0 * 14.0 + 13.0) / 8.0, 1e-12);
    }
    // a speeds b up, and the free-wheel overruns.
    let run = model.run(&start(&[("a", 28.0), ("b", 14.0), ("c", 14.0)]), s(0.2), None).unwrap();
    close(end_speed(&run, "b"), (2.0 * 28.0 + 5.0 * 14.0) / 7.0, 1e-12);
    close(end_speed(&run, "c"), 14.0, 1e-12);
    assert_eq!(run.end().states[0], State::Forward);
    assert!(run.audit.residual().abs() < 1e-12);
}

#[test]
fn friction_has_no_part_in_an_impact_and_slips_after_it() {
    let bodies = [("a", kg_m2(2.0)), ("b", kg_m2(5.0)), ("c", kg_m2(1.0))];
    let mut model = Model::new(Mechanism::shafts(&bodies).unwrap());
    model.friction("clutch", ["b", "c"], table(&[(0.0, 10.0), (1.0, 10.0)]), 1.0).unwrap();
    model.dog_clutch("dog", ["a", "b"], &[(s(0.1), true)], None).unwrap();
    model.threshold("half", "b", omega(12.0)).unwrap();
    let run = model.run(&start(&[("a", 0.0), ("b", 14.0), ("c", 14.0)]), s(2.0), None).unwrap();
    let meshed = &run.events[0];
    assert_eq!(meshed.changes.len(), 3, "{:?}", meshed.changes);
    close(speed(&run, &meshed.after, "b"), 10.0, 1e-12);
    close(speed(&run, &meshed.after, "c"), 14.0, 1e-12);
    assert_eq!(meshed.after.states, [State::Backward, State::Stuck]);
    // The slip of 4 rad/s ends at 10·(1/7 + 1).
    close(at(&run.events[1]) - 0.1, 4.0 / (10.0 / 7.0 + 10.0), 1e-10);
    close(end_speed(&run, "a"), 84.0 / 8.0, 1e-12);
    assert!(run.audit.residual().abs() < 1e-12);
}

#[test]
fn a_brake_of_dogs_holds_any_torque_beside_a_stuck_clutch() {
    let mut model = pair();
    model.dog_clutch("dog", ["a", GROUND], &[(s(0.0), true)], None).unwrap();
    model.friction("brake", ["a", GROUND], table(&[(0.0, 5.0)]), 1.0).unwrap();
    model.torque("motor", "a", constant(1e4)).unwrap();
    let run = model.run(&start(&[("a", 0.0), ("b", 1.0)]), s(1.0), None).unwrap();
    assert!(run.events.is_empty());
    let held: f64 = run.end().elements.iter().map(Torque::get::<newton_meter>).sum();
    close(held, -1e4, 1e-12);
    assert!(!run.end().is_split_unique && run.end().elements[1].get::<newton_meter>().abs() <= 5.0 + 1e-9);
}

#[test]
fn what_is_no_dog_clutch_is_refused() {
    let mut model = pair();
    let times = [(s(1.0), true), (s(1.0), false)];
    assert!(matches!(model.dog_clutch("d", ["a", "b"], &times, None), Err(Error::Order { place: 2, .. })));
    assert!(matches!(model.dog_clutch("d", ["a", "b"], &[], None), Err(Error::NoPoints { .. })));
    let now = [(s(0.0), true)];
    assert!(matches!(model.dog_clutch("d", ["a", "b"], &now, Some(omega(-1.0))), Err(Error::Value { .. })));
    assert!(matches!(model.shift_dog_clutch("d", &now, None), Err(Error::Unknown { .. })));
    model.dog_clutch("d", ["a", "b"], &now, None).unwrap();
    let found = model.run(&start(&[("a", 1.0), ("b", 0.0)]), s(1.0), None);
    assert!(matches!(found, Err(Error::InitialDog { .. })));
    assert!(model.run(&start(&[("a", 1.0), ("b", 1.0)]), s(1.0), None).is_ok());
}

//! Friction over slip speed, constant power and torque converters against closed forms.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests, with fixed data")]

use crate::common;

use common::{
    at, close, constant, end_speed, joules, kg_m2, level, n_m, omega, s, start, table, torque_of, two_shafts,
};
use epicyclic_motion::{Change, Converter, Error, Mechanism, Model, Start, State, TorqueLaw};
use epicyclic_train::GROUND;
use uom::si::f64::Power;
use uom::si::power::watt;
use uom::si::torque::newton_meter;

const J: [f64; 2] = [0.4, 1.6];

fn reduced() -> f64 {
    J[0] * J[1] / (J[0] + J[1])
}

#[test]
fn friction_that_is_linear_in_slip_lets_it_decay_exponentially() {
    let mut model = two_shafts(J, 80.0);
    // 1 up to 20 rad/s, then rising to 3 at 120 rad/s.
    model.friction_over_slip("clutch", &[(omega(20.0), 1.0), (omega(120.0), 3.0)]).unwrap();
    let run = model.run(&start(&[("a", 120.0), ("b", 0.0)]), s(1.0), None).unwrap();
    // ds/dt = −80/J·(0.6 + s/50) down to 20, then −80/J.
    let rate = 80.0 / reduced();
    let bent = 50.0 / rate * libm::log((0.6 + 2.4) / (0.6 + 0.4_f64));
    let [closed] = run.events.as_slice() else { panic!("{:?}", run.events) };
    close(at(closed), bent + 20.0 / rate, 1e-10);
    close(joules(run.heat("clutch").unwrap()), 0.5 * reduced() * 120.0 * 120.0, 1e-10);
    close(end_speed(&run, "b"), 24.0, 1e-10);
    assert!(run.audit.residual().abs() < 1e-11);
}

#[test]
fn friction_that_falls_with_slip_runs_away_until_its_table_is_level() {
    // A brake drags at a turning drum; torque above static friction tears it loose from rest.
    let mut model = Model::new(Mechanism::shafts(&[("drum", kg_m2(0.5))]).unwrap());
    model.torque("motor", "drum", TorqueLaw::over_time(table(&[(0.0, 0.0), (2.0, 40.0)]))).unwrap();
    model.friction("brake", ["drum", GROUND], level(10.0), 1.0).unwrap();
    model.friction_over_slip("brake", &[(omega(0.0), 2.0), (omega(4.0), 0.5)]).unwrap();
    let run = model.run(&Start::at_rest(), s(2.0), None).unwrap();
    let [torn] = run.events.as_slice() else { panic!("{:?}", run.events) };
    // 20 N·m hold until 20·t = 20.
    close(at(torn), 1.0, 1e-10);
    // J·ω̇ = 20·τ + 10·k·ω up to 4 rad/s, k = 1.5/4, from τ = 0 at rest; then J·ω̇ = 15 + 20·τ.
    let k = 10.0 * 0.375 / 0.5;
    let bent = |tau: f64| 40.0 / (k * k) * (libm::exp(k * tau) - 1.0 - k * tau);
    let (mut from, mut to) = (0.0, 1.0);
    for _ in 0..200 {
        let middle = 0.5 * (from + to);
        if bent(middle) < 4.0 { from = middle } else { to = middle }
    }
    let rest = 4.0 + 30.0 * (1.0 - from) + 20.0 * (1.0 - from * from);
    close(end_speed(&run, "drum"), rest, 1e-9);
    assert!(run.audit.residual().abs() < 1e-10);
}

#[test]
fn what_sticks_holds_by_the_friction_at_no_slip() {
    let mut model = two_shafts(J, 80.0);
    model.friction_over_slip("clutch", &[(omega(0.0), 0.5), (omega(10.0), 1.0)]).unwrap();
    model.torque("motor", "a", TorqueLaw::over_time(table(&[(0.0, 0.0), (1.0, 100.0)]))).unwrap();
    let run = model.run(&Start::at_rest(), s(1.0), None).unwrap();
    // Locked: the clutch passes on 4/5 of the torque; it holds 40 N·m.
    close(at(&run.events[0]), 0.5, 1e-10);
    close(torque_of(&run.events[0].after, 0).abs(), 40.0, 1e-9);
}

#[test]
fn what_is_no_friction_over_slip_is_refused() {
    let mut model = two_shafts(J, 80.0);
    assert!(matches!(model.friction_over_slip("none", &[(omega(0.0), 1.0)]), Err(Error::Unknown { .. })));
    assert!(matches!(model.friction_over_slip("clutch", &[]), Err(Error::NoPoints { .. })));
    let back = [(omega(1.0), 1.0), (omega(1.0), 0.9)];
    assert!(matches!(model.friction_over_slip("clutch", &back), Err(Error::Order { place: 2, .. })));
    assert!(matches!(model.friction_over_slip("clutch", &[(omega(0.0), -1.0)]), Err(Error::Value { .. })));
    assert!(matches!(model.friction_over_slip("clutch", &[(omega(-1.0), 1.0)]), Err(Error::Value { .. })));
}

#[test]
fn constant_power_above_the_base_speed() {
    let mut model = Model::new(Mechanism::shafts(&[("rotor", kg_m2(0.5))]).unwrap());
    let motor = TorqueLaw::constant_power(Power::new::<watt>(6000.0), n_m(100.0)).unwrap();
    model.torque("motor", "rotor", motor).unwrap();
    let run = model.run(&start(&[("rotor", -20.0)]), s(2.0), None).unwrap();
    let base = 60.0;
    let rest = 2.0 - (base + 20.0) * 0.5 / 100.0;
    close(end_speed(&run, "rotor"), (base * base + 2.0 * 6000.0 * rest / 0.5_f64).sqrt(), 1e-10);
    assert!(run.audit.residual().abs() < 1e-10);
    assert_eq!(run.transitions, 1);
}

#[test]
fn an_engine_follows_its_throttle_between_its_curves() {
    let mut model = Model::new(Mechanism::shafts(&[("crank", kg_m2(0.5))]).unwrap());
    // Full: 80 N·m less 0.2 a rad/s from 100 rad/s on; closed: −10 N·m, and −20 from 150 rad/s on.
    let full = [(omega(100.0), n_m(80.0)), (omega(300.0), n_m(40.0))];
    let closed = [(omega(149.0), n_m(-10.0)), (omega(150.0), n_m(-20.0))];
    let throttle = [(s(0.0), 0.0), (s(0.5), 1.0), (s(0.5), 1.0), (s(1.5), 1.0), (s(1.5), 0.0)];
    model.torque("engine", "crank", TorqueLaw::map(&closed, &full, &throttle).unwrap()).unwrap();
    let run = model.run(&start(&[("crank", 30.0)]), s(2.0), Some(s(0.5))).unwrap();
    let found = |place: usize| common::speed(&run, &run.samples[place], "crank");
    // J·ω̇ = −10 + 180·t.
    close(found(1), 30.0 + 2.0 * (-5.0 + 90.0 * 0.25), 1e-11);
    // 80 N·m up to 100 rad/s, then ω̇ = 2·(100 − 0.2·ω).
    let bent = (100.0 - found(1)) / 160.0;
    close(found(2), 500.0 - 400.0 * libm::exp(-0.4 * (0.5 - bent)), 1e-11);
    close(found(3), 500.0 - 400.0 * libm::exp(-0.4 * (1.0 - bent)), 1e-11);
    // −20 N·m down to 150 rad/s, which it does not reach in half a second.
    assert!(found(3) > 170.0);
    close(found(4), found(3) - 20.0, 1e-11);
    assert!(run.audit.residual().abs() < 1e-10);
}

fn characteristic() -> Converter {
    Converter::new(&[[0.0, 2.0, 1.5e-3], [0.6, 1.3, 1.6e-3], [0.86, 1.0, 1.2e-3], [1.0, 1.0, 0.0]]).unwrap()
}

fn converter(engine: f64, load: f64) -> Model {
    let mechanism = Mechanism::shafts(&[("impeller", kg_m2(0.2)), ("turbine", kg_m2(1.5))]).unwrap();
    let mut model = Model::new(mechanism);
    model.torque("engine", "impeller", constant(engine)).unwrap();
    model.resistance("load", "turbine", n_m(load)).unwrap();
    model.converter("converter", ["impeller", "turbine"], characteristic()).unwrap();
    model
}

#[test]
fn a_stalled_converter_lets_its_impeller_run_up_as_a_hyperbolic_tangent() {
    let run = converter(120.0, 1e4).run(&Start::at_rest(), s(0.4), None).unwrap();
    let (capacity, j, torque): (f64, f64, f64) = (1.5e-3, 0.2, 120.0);
    let due = (torque / capacity).sqrt() * libm::tanh(0.4 * (torque * capacity).sqrt() / j);
    close(end_speed(&run, "impeller"), due, 1e-10);
    assert_eq!(end_speed(&run, "turbine"), 0.0);
    let taken = capacity * due * due;
    close(run.end().converters[0][0].get::<newton_meter>(), -taken, 1e-9);
    close(run.end().converters[0][1].get::<newton_meter>(), 2.0 * taken, 1e-9);
    let heat = torque * j / capacity * libm::log(libm::cosh(0.4 * (torque * capacity).sqrt() / j))
        - 0.5 * j * due * due;
    close(joules(run.audit.converters[0]), heat, 1e-9);
    assert!(run.audit.residual().abs() < 1e-10);
}

#[test]
fn a_converter_settles_where_its_torque_ratio_is_that_of_the_loads() {
    let run = converter(120.0, 180.0).run(&Start::at_rest(), s(120.0), None).unwrap();
    // μ = 1.5 between 0 and 0.6; λ(ν)·ω² = 120.
    let ratio = 0.6 * (2.0 - 1.5) / 0.7;
    let capacity = 1.5e-3 + 0.1e-3 * ratio / 0.6;
    let impeller = (120.0_f64 / capacity).sqrt();
    close(end_speed(&run, "impeller"), impeller, 1e-9);
    close(end_speed(&run, "turbine"), ratio * impeller, 1e-9);
    assert!(run.audit.residual().abs() < 1e-9, "{}", run.audit.residual());
}

/// A fourth-order method with a fixed step, for a converter alone.
fn reference(engine: f64, drag: f64, end: f64, steps: usize) -> [f64; 3] {
    let table =
        [[0.0, 2.0, 1.5e-3], [0.6, 1.3, 1.6e-3], [0.86, 1.0, 1.2e-3], [1.0, 1.0, 0.0], [9.0, 1.0, 0.0]];
    let rates = |y: [f64; 3]| {
        let ratio = if y[0] > 0.0 { y[1] / y[0] } else { 0.0 };
        let pair = table.windows(2).find(|pair| ratio <= pair[1][0]).unwrap();
        let part = (ratio - pair[0][0]) / (pair[1][0] - pair[0][0]);
        let [mu, lambda] = [1, 2].map(|one| pair[0][one] + part * (pair[1][one] - pair[0][one]));
        let taken = lambda * y[0] * y[0];
        [(engine - taken) / 0.2, (mu * taken - drag * y[1]) / 1.5, taken * (y[0] - mu * y[1])]
    };
    let mut y = [0.0; 3];
    let h = end / steps as f64;
    let ahead = |y: [f64; 3], k: [f64; 3], h: f64| [0, 1, 2].map(|one| y[one] + h * k[one]);
    for _ in 0..steps {
        let first = rates(y);
        let second = rates(ahead(y, first, 0.5 * h));
        let third = rates(ahead(y, second, 0.5 * h));
        let fourth = rates(ahead(y, third, h));
        for one in 0..3 {
            y[one] += h / 6.0 * (first[one] + 2.0 * second[one] + 2.0 * third[one] + fourth[one]);
        }
    }
    y
}

#[test]
fn a_start_through_all_segments_of_a_converter_is_that_of_a_fine_fixed_step() {
    let mechanism = Mechanism::shafts(&[("impeller", kg_m2(0.2)), ("turbine", kg_m2(1.5))]).unwrap();
    let mut model = Model::new(mechanism);
    model.torque("engine", "impeller", constant(120.0)).unwrap();
    model.torque("drag", "turbine", TorqueLaw::viscous(n_m(0.4), omega(1.0)).unwrap()).unwrap();
    model.converter("converter", ["impeller", "turbine"], characteristic()).unwrap();
    let run = model.run(&Start::at_rest(), s(8.0), None).unwrap();
    let due = reference(120.0, 0.4, 8.0, 400_000);
    close(end_speed(&run, "impeller"), due[0], 1e-8);
    close(end_speed(&run, "turbine"), due[1], 1e-8);
    close(joules(run.audit.converters[0]), due[2], 1e-8);
    assert!(end_speed(&run, "turbine") / end_speed(&run, "impeller") > 0.86);
    assert!(run.audit.residual().abs() < 1e-9, "{}", run.audit.residual());
}

#[test]
fn a_lock_up_clutch_beside_the_converter_takes_its_slip_and_the_energies_balance() {
    let mut model = converter(120.0, 90.0);
    model.friction("lock-up", ["impeller", "turbine"], table(&[(2.0, 0.0), (2.5, 200.0)]), 1.0).unwrap();
    let run = model.run(&Start::at_rest(), s(4.0), None).unwrap();
    assert_eq!(run.end().states[1], State::Stuck);
    close(end_speed(&run, "impeller"), end_speed(&run, "turbine"), 1e-12);
    // Without slip the converter carries nothing, and what is left accelerates both.
    let [closed] = [run.events.last().unwrap()];
    let [first, second] = [closed, closed].map(|event| event.after.speeds[1]);
    assert_eq!(first, second);
    let grown = end_speed(&run, "impeller") - common::speed(&run, &closed.after, "impeller");
    close(grown, (120.0 - 90.0) / 1.7 * (4.0 - at(closed)), 1e-9);
    assert!(run.audit.residual().abs() < 1e-9, "{}", run.audit.residual());
}

#[test]
fn what_is_no_converter_is_refused() {
    assert!(matches!(Converter::new(&[]), Err(Error::NoPoints { .. })));
    let level = [[0.5, 1.0, 1e-3], [0.5, 1.0, 0.0]];
    assert!(matches!(Converter::new(&level), Err(Error::Order { place: 2, .. })));
    // It would give power beyond its last point; at a point; between two.
    assert!(matches!(Converter::new(&[[0.0, 2.0, 1e-3], [0.9, 1.0, 1e-3]]), Err(Error::Value { .. })));
    let strong = [[0.0, 2.0, 1e-3], [0.8, 1.5, 1e-3], [1.0, 1.0, 0.0]];
    assert!(matches!(Converter::new(&strong), Err(Error::Value { .. })));
    let between = [[0.0, 4.0, 1e-3], [0.8, 1.0, 1e-3], [1.0, 1.0, 0.0]];
    assert!(matches!(Converter::new(&between), Err(Error::Value { .. })));
    // A turbine that drives.
    let driven = [[0.0, 2.0, 1e-3], [1.0, 1.0, 0.0], [1.5, 1.0, -1e-3]];
    assert!(Converter::new(&driven).is_ok());
}

#[test]
fn a_threshold_at_rest_is_not_passed_by_what_comes_to_rest_there() {
    let mut model = Model::new(Mechanism::shafts(&[("a", kg_m2(0.7))]).unwrap());
    model.resistance("drag", "a", n_m(3.0)).unwrap();
    model.threshold("stop", "a", omega(0.0)).unwrap();
    let points = [(omega(0.0), n_m(1.0)), (omega(10.0), n_m(0.3))];
    model.torque("motor", "a", TorqueLaw::over_speed(&points).unwrap()).unwrap();
    let run = model.run(&start(&[("a", 7.0)]), s(50.0), None).unwrap();
    let [stopped] = run.events.as_slice() else { panic!("{:?}", run.events) };
    assert!(matches!(stopped.changes.as_slice(), [Change::Element { to: State::Stuck, .. }]));
}

#[test]
fn a_slip_that_hardly_reaches_zero_is_stopped_there() {
    // J·ω̇ = T(t) − C with T on a ramp: ω falls to −depth at the time `turn`, if it could slip on, and rises
    // again.
    let (j, ramp, capacity) = (0.5, 40.0, 3.0);
    for case in 0..240 {
        let turn = 0.3 + 0.6 * f64::from(case) / 240.0;
        for depth in [1e-6, 1e-4, 1e-2] {
            let mut model = Model::new(Mechanism::shafts(&[("a", kg_m2(j))]).unwrap());
            let at = |t: f64| capacity + ramp * (t - turn);
            model
                .torque("motor", "a", TorqueLaw::over_time(table(&[(0.0, at(0.0)), (1.0, at(1.0))])))
                .unwrap();
            model.friction("brake", ["a", GROUND], level(capacity), 1.0).unwrap();
            let begin = 0.5 * ramp / j * turn * turn - depth;
            let run = model.run(&start(&[("a", begin)]), s(1.0), None).unwrap();
            let first = run.events.first().unwrap_or_else(|| panic!("{turn} {depth}"));
            assert_eq!(first.after.states, [State::Stuck], "{turn} {depth}");
            close(common::at(first), turn - (2.0 * depth * j / ramp).sqrt(), 1e-9);
            // And one that does not reach it is not stopped.
            let run = model.run(&start(&[("a", begin + 2.0 * depth)]), s(1.0), None).unwrap();
            assert!(run.events.is_empty(), "{turn} {depth}");
        }
    }
}

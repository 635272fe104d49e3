//! Problems with exact answers.

use crate::common;

use common::{
    acceleration, angle, at, close, constant, end_speed, eta, held_t, joules, kg_m2, masses_t, n_m, omega,
    power_shift, s, speed, start, table, torque_of, train_t, two_shafts,
};
use epicyclic_dynamics::gearbox::Masses;
use epicyclic_motion::{Change, Course, Error, Mechanism, Model, Start, State, TorqueLaw};
use epicyclic_train::Gearbox;
use epicyclic_train::set::{MeshLoss, SetKind, SetSpec};
use std::f64::consts::{FRAC_PI_2, PI};
use uom::si::moment_of_inertia::kilogram_square_meter;
use uom::si::torque::newton_meter;

#[test]
fn v1_train_t_with_its_ring_held() {
    let mechanism = held_t();
    close(
        mechanism.equivalent_inertia("sun").unwrap().get::<kilogram_square_meter>(),
        0.034_829_358_024_69,
        1e-12,
    );
    let mut model = Model::new(mechanism);
    model.torque("motor", "sun", constant(12.0)).unwrap();
    model.torque("load", "carrier", constant(-30.0)).unwrap();
    close(acceleration(&model.at_start(&Start::at_rest()).unwrap(), 1), 153.127_523_3, 1e-9);
    let run = model.run(&Start::at_rest(), s(0.8), None).unwrap();
    close(end_speed(&run, "sun"), 122.502_018_7, 1e-9);
    close(joules(run.audit.after), 261.337_639_8, 1e-9);
    assert!(run.audit.residual().abs() < 1e-12);
}

#[test]
fn v2_the_free_set() {
    let mechanism = Mechanism::of(&train_t(MeshLoss::IDEAL), &[], &masses_t(true)).unwrap();
    assert_eq!(mechanism.freedoms(), 2);
    let mut model = Model::new(mechanism);
    for (link, torque) in [("sun", 10.0), ("carrier", -5.0), ("ring", -3.0)] {
        model.torque(link, link, constant(torque)).unwrap();
    }
    let found = model.at_start(&Start::at_rest()).unwrap();
    // Links: housing, sun, ring, carrier.
    for (link, due) in [(1, 773.427_739_112), (3, 9.706_750_730_34), (2, -208.499_245_95)] {
        close(acceleration(&found, link), due, 1e-11);
    }
}

#[test]
fn v3_a_kloss_motor_runs_up() {
    let motor = || TorqueLaw::kloss(n_m(60.0), 0.2, omega(50.0 * PI)).unwrap();
    let mut model = Model::new(Mechanism::shafts(&[("rotor", kg_m2(0.034_829_358_024_691_36))]).unwrap());
    model.torque("motor", "rotor", motor()).unwrap();
    model.torque("load", "rotor", constant(-12.0)).unwrap();
    model.threshold("up", "rotor", omega(0.95 * 50.0 * PI)).unwrap();
    let run = model.run(&Start::at_rest(), s(5.0), None).unwrap();
    let [up] = run.events.as_slice() else { panic!("{:?}", run.events) };
    assert_eq!(up.changes, [Change::Threshold { name: "up".into(), is_rising: true }]);
    close(at(up), 0.224_153_177_648, 1e-11);
    close(1.0 - end_speed(&run, "rotor") / (50.0 * PI), 0.020_204_102_9, 1e-8);
    let short = model.run(&Start::at_rest(), s(at(up)), None).unwrap();
    close(joules(short.audit.inner_losses[0]), 698.709_098_436, 1e-11);
}

#[test]
fn v4_a_torque_linear_in_speed() {
    let mut model = Model::new(held_t());
    model.torque("motor", "sun", TorqueLaw::linear(n_m(40.0), omega(157.0)).unwrap()).unwrap();
    model.torque("load", "sun", constant(-8.0)).unwrap();
    let run = model.run(&Start::at_rest(), s(0.3), None).unwrap();
    close(end_speed(&run, "sun"), 111.606_407_711, 1e-11);
    // ω = (32/c)·(1 − e^(−c·t/J)), c = 40/157.
    let (c, j): (f64, f64) = (40.0 / 157.0, 0.034_829_358_024_691_36);
    close(end_speed(&run, "sun"), 32.0 / c * (1.0 - libm::exp(-c * 0.3 / j)), 1e-11);
}

#[test]
fn v5_a_clutch_of_constant_capacity() {
    let mut model = two_shafts([2.0, 5.0], 100.0);
    let run = model.run(&start(&[("a", 150.0), ("b", 10.0)]), s(3.0), None).unwrap();
    close(at(&run.events[0]), 2.0, 1e-13);
    close(joules(run.heat("clutch").unwrap()), 14_000.0, 1e-12);
    close(end_speed(&run, "a"), 50.0, 1e-13);
    model.torque("motor", "a", constant(20.0)).unwrap();
    model.torque("load", "b", constant(-15.0)).unwrap();
    let run = model.run(&start(&[("a", 150.0), ("b", 10.0)]), s(3.0), None).unwrap();
    let [closed] = run.events.as_slice() else { panic!("{:?}", run.events) };
    close(at(closed), 2.456_140_350_877_193, 1e-12);
    close(joules(run.heat("clutch").unwrap()), 17_192.982_456_1, 1e-11);
    close(speed(&run, &closed.after, "a"), 51.754_385_964_9, 1e-11);
    close(-torque_of(&closed.after, 0), 130.0 / 7.0, 1e-12);
    assert!(run.audit.residual().abs() < 1e-13);
}

#[test]
fn v7_mesh_losses_by_the_sign_of_the_rolling_power() {
    let gearbox = train_t(MeshLoss::Set(eta(0.95)));
    for (torque, load, speed, due) in
        [(12.0, 30.0, 1.0, 141.875_112_471), (-5.0, -60.0, 1.0, 231.580_895_964)]
    {
        let masses = Masses { planets: vec![], ..masses_t(false) };
        let mut model = Model::new(Mechanism::of(&gearbox, &["hold"], &masses).unwrap());
        model.torque("motor", "sun", constant(torque)).unwrap();
        model.torque("load", "carrier", constant(-load)).unwrap();
        close(acceleration(&model.at_start(&start(&[("sun", speed)])).unwrap(), 1), due, 1e-11);
        let run = model.run(&start(&[("sun", speed)]), s(0.5), None).unwrap();
        assert!(run.audit.residual().abs() < 1e-12);
        assert!(joules(run.audit.mesh_losses[0]) > 0.0);
    }
}

#[test]
fn a_set_that_mesh_friction_holds_tells_the_torques_on_its_members() {
    let gearbox = train_t(MeshLoss::Set(eta(0.9)));
    let with = |load: f64| {
        let mut model = Model::new(Mechanism::of(&gearbox, &["hold"], &masses_t(false)).unwrap());
        model.torque("motor", "sun", constant(10.0)).unwrap();
        model.torque("load", "carrier", constant(-load)).unwrap();
        model.run(&Start::at_rest(), s(0.1), None).unwrap()
    };
    // Driving it can 10·(1 + 3.5·0.9) = 41.5; driven back 10·(1 + 3.5/0.9) = 48.9 would be needed.
    for load in [42.0, 45.0, 48.0] {
        let run = with(load);
        assert_eq!(end_speed(&run, "sun"), 0.0);
        for (found, due) in run.end().sets[0].iter().zip([10.0, load - 10.0, -load]) {
            close(found.get::<newton_meter>(), due, 1e-12);
        }
    }
    assert!(end_speed(&with(41.0), "sun") > 0.0 && end_speed(&with(49.0), "sun") < 0.0);
}

#[test]
fn p1_two_shafts_and_a_clutch() {
    let run = two_shafts([0.4, 1.6], 80.0).run(&start(&[("a", 120.0), ("b", 0.0)]), s(1.0), None).unwrap();
    close(at(&run.events[0]), 0.48, 1e-13);
    close(joules(run.heat("clutch").unwrap()), 2304.0, 1e-12);
    close(end_speed(&run, "b"), 24.0, 1e-13);
}

#[test]
fn p2_a_power_shift_of_one_set() {
    let hand_over = 46.0 / 215.0;
    let mut model = power_shift(150.0, 300.0);
    let clutch = table(&[(0.0, 0.0), (hand_over, 500.0 * hand_over), (hand_over, 160.0)]);
    model.shift_element("clutch", clutch, 1.0).unwrap();
    let begin = start(&[("sun", 200.0), ("ring", 0.0)]);
    let first = model.at_start(&begin).unwrap();
    close(acceleration(&first, 1), 45.918_367_35, 1e-9);
    close(first.sets[0][0].get::<newton_meter>(), 140.816_326_5, 1e-9);
    close(torque_of(&first, 0), 281.632_653_1, 1e-9);
    let run = model.run(&begin, s(1.0), None).unwrap();
    assert_eq!(run.events.len(), 2, "{:?}", run.events);
    let [released, closed] = run.events.as_slice() else { panic!("{:?}", run.events) };
    close(at(released), 0.213_953_488_4, 1e-9);
    close(speed(&run, &released.after, "sun"), 199.314_577_101_8, 1e-12);
    close(speed(&run, &released.after, "carrier"), 66.438_192_367_3, 1e-12);
    close(acceleration(&released.after, 1), -450.0, 1e-10);
    close(acceleration(&released.after, 3), -7.5, 1e-10);
    close(at(closed) - at(released), 0.300_285_615_2, 1e-9);
    close(speed(&run, &closed.after, "sun"), 64.186_050_253_1, 1e-11);
    close(acceleration(&closed.after, 1), -18.292_682_926_8, 1e-10);
    close(-torque_of(&closed.after, 1), 102.439_024_390_2, 1e-10);
    // Until then it slips with all that it can carry.
    close(-torque_of(&closed.before, 1), 160.0, 1e-10);
    close(joules(run.heat("clutch").unwrap()), 2_303.621_196_1 + 4_788.104_032_6, 1e-10);
    assert!(run.audit.residual().abs() < 1e-12);
}

#[test]
fn p2_the_torque_phase_ends_where_the_brake_is_free() {
    let mut model = power_shift(150.0, 300.0);
    model.shift_element("clutch", table(&[(0.0, 0.0), (1.0, 500.0)]), 1.0).unwrap();
    let run = model.run(&start(&[("sun", 200.0), ("ring", 0.0)]), s(1.0), None).unwrap();
    let released = &run.events[0];
    close(at(released), 46.0 / 215.0, 1e-10);
    close(-torque_of(&released.after, 1), 106.976_744_186, 1e-10);
}

#[test]
fn p3_a_start_under_a_viscous_load() {
    // i 6 with ρ = 5; carrier inertia J_c = .34987·36 felt at the sun, the sun without inertia of its own.
    let gearbox = Gearbox::builder("P3")
        .links(["sun", "carrier"])
        .set(SetSpec::simple("set", ["sun", "ground", "carrier"], 5.0))
        .input("sun")
        .output("carrier")
        .build()
        .unwrap();
    let masses = Masses { links: common::links(&[("carrier", 0.34987 * 36.0)]), ..Masses::default() };
    let mut model = Model::new(Mechanism::of(&gearbox, &[], &masses).unwrap());
    model.torque("motor", "sun", constant(21.47)).unwrap();
    model.torque("load", "carrier", TorqueLaw::viscous(n_m(4.0), omega(1.0)).unwrap()).unwrap();
    model.threshold("95 %", "sun", omega(0.95 * 193.23)).unwrap();
    let run = model.run(&Start::at_rest(), s(3.3276), None).unwrap();
    close(end_speed(&run, "sun"), 126.067_992_6, 1e-9);
    let run = model.run(&Start::at_rest(), s(60.0), None).unwrap();
    close(at(&run.events[0]), 9.433_051_655, 1e-9);
    close(end_speed(&run, "sun"), 193.23 * (1.0 - libm::exp(-60.0_f64 / 3.14883)), 1e-9);
}

#[test]
fn p5_losses_that_leave_the_motion_open_are_refused() {
    let gearbox = Gearbox::builder("P5")
        .links(["a", "c"])
        .set(
            SetSpec::new("set", SetKind::SteppedSuns, ["a", "ground", "c"], 0.96)
                .with_loss(MeshLoss::Set(eta(0.9))),
        )
        .input("a")
        .output("c")
        .build();
    let Ok(gearbox) = gearbox else { panic!("{gearbox:?}") };
    let with = |carrier: f64| {
        let masses = Masses { links: common::links(&[("a", 0.4), ("c", carrier)]), ..Masses::default() };
        let mut model = Model::new(Mechanism::of(&gearbox, &[], &masses).unwrap());
        model.torque("motor", "a", constant(1.0)).unwrap();
        // The relative speed ω_a − ω_c = −i₀/(1 − i₀)·… of a turning backwards.
        model.at_start(&start(&[("a", -1.0)]))
    };
    let Err(Error::NotUnique { sets, least, greatest }) = with(0.001) else { panic!("it is not unique") };
    assert_eq!(sets, ["set"]);
    // 1/J_a + (1 − i₀)²/J_c without losses.
    let ideal = 1.0 / 0.4 + 0.04 * 0.04 / 0.001;
    close(least * ideal, -1.0 / 6.0, 1e-10);
    close(greatest * ideal, 7.94, 1e-12);
    assert!(with(0.001_066_66).is_err() && with(0.001_066_67).is_ok());
}

#[test]
fn coupled_clutches_of_the_modelica_library() {
    let shafts = ["1", "2", "3", "4"].map(|name| (name, kg_m2(1.0)));
    let mut model = Model::new(Mechanism::shafts(&shafts).unwrap());
    let sine = Course::harmonic(n_m(0.0), n_m(10.0), omega(10.0 * PI), angle(0.0)).unwrap();
    model.torque("drive", "1", TorqueLaw::over_time(sine)).unwrap();
    let first = Course::harmonic(n_m(0.0), n_m(10.0), omega(0.4 * PI), angle(FRAC_PI_2)).unwrap();
    model.friction("c1", ["1", "2"], first, 1.1).unwrap();
    for (name, links, from) in [("c2", ["2", "3"], 0.4), ("c3", ["3", "4"], 0.9)] {
        let step = table(&[(from, 0.0), (from, 10.0)]);
        model.friction(name, links, step, 1.1).unwrap();
    }
    let begin = start(&[("1", 10.0), ("2", 0.0), ("3", 0.0), ("4", 0.0)]);
    let run = model.run(&begin, s(1.2), None).unwrap();
    let stuck = |name: &str| {
        let is = |change: &Change| matches!(change, Change::Element { name: one, to: State::Stuck, .. } if one == name);
        run.events.iter().find(|event| event.changes.iter().any(is)).unwrap()
    };
    close(at(stuck("c2")), 0.709_621_474_694, 1e-11);
    close(at(stuck("c1")), 0.791_662_359_156, 1e-11);
    close(speed(&run, &stuck("c1").after, "1"), 3.336_952_432_6, 1e-9);
    let breaks = run.events.iter().find(|event| {
        let is = |change: &Change| matches!(change, Change::Element { name, from: State::Stuck, .. } if name == "c1");
        event.changes.iter().any(is)
    });
    close(at(breaks.unwrap()), 0.831_108_506_138, 1e-11);
    assert!(run.audit.residual().abs() < 1e-10, "{}", run.audit.residual());
    let early = model.run(&begin, s(0.4), None).unwrap();
    close(end_speed(&early, "1"), 6.166_326_070_7, 1e-10);
}

//! Problems with exact answers, beyond those that are cases in `spec-cases/motion-problems`.

use crate::common;

use common::{
    acceleration, at, close, constant, end_speed, eta, joules, masses_t, n_m, omega, power_shift, s, speed,
    start, table, torque_of, train_t,
};
use epicyclic_dynamics::gearbox::Masses;
use epicyclic_motion::{Error, Mechanism, Model, Start, TorqueLaw};
use epicyclic_train::Gearbox;
use epicyclic_train::set::{MeshLoss, SetKind, SetSpec};
use uom::si::torque::newton_meter;

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

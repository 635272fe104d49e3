//! Elastic shafts against closed forms.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests, with fixed data")]

use crate::common;

use common::{
    at, close, constant, end_speed, held_t, joules, kg_m2, level, masses_t, n_m, omega, s, speed, start,
    train_t,
};
use epicyclic_motion::{Change, Contact, Course, Error, Mechanism, Model, Run, Shaft, Start, TorqueLaw};
use epicyclic_train::GROUND;
use epicyclic_train::set::MeshLoss;
use std::f64::consts::PI;
use uom::si::angle::radian;
use uom::si::f64::{Angle, MomentOfInertia};
use uom::si::moment_of_inertia::kilogram_square_meter;
use uom::si::torque::newton_meter;

const J: [f64; 2] = [0.3, 1.2];

fn rad(value: f64) -> Angle {
    Angle::new::<radian>(value)
}

fn shaft(stiffness: f64, damping: f64, backlash: f64) -> Shaft {
    let damped = Shaft::new(n_m(stiffness), rad(1.0)).unwrap().damping(n_m(damping), omega(1.0)).unwrap();
    damped.backlash(rad(backlash)).unwrap()
}

/// Two inertias and a shaft.
fn pair(one: Shaft) -> Model {
    let mut model = Model::new(Mechanism::shafts(&[("a", kg_m2(J[0])), ("b", kg_m2(J[1]))]).unwrap());
    model.shaft("shaft", ["a", "b"], one).unwrap();
    model
}

fn reduced() -> f64 {
    J[0] * J[1] / (J[0] + J[1])
}

fn twist(run: &Run) -> f64 {
    run.end().twists[0].get::<radian>()
}

#[test]
fn two_inertias_swing_freely_without_damping() {
    let run = pair(shaft(500.0, 0.0, 0.0))
        .run(&start(&[("a", 20.0), ("b", 10.0)]).twisted(&[("shaft", rad(0.05))]), s(2.0), None)
        .unwrap();
    let w = (500.0 / reduced()).sqrt();
    let (phi, rate) = (
        0.05 * libm::cos(2.0 * w) + 10.0 / w * libm::sin(2.0 * w),
        -0.05 * w * libm::sin(2.0 * w) + 10.0 * libm::cos(2.0 * w),
    );
    close(twist(&run), phi, 1e-9);
    let mean = (J[0] * 20.0 + J[1] * 10.0) / (J[0] + J[1]);
    close(end_speed(&run, "a"), mean + J[1] / (J[0] + J[1]) * rate, 1e-9);
    close(end_speed(&run, "b"), mean - J[0] / (J[0] + J[1]) * rate, 1e-9);
    close(run.end().shafts[0].get::<newton_meter>(), 500.0 * phi, 1e-9);
    close(joules(run.audit.elastic_after), 250.0 * phi * phi, 1e-9);
    assert!(run.audit.residual().abs() < 1e-9, "{}", run.audit.residual());
}

#[test]
fn two_inertias_swing_out_with_damping() {
    let (c, d, phi_0) = (500.0, 3.0, 0.05);
    let run = pair(shaft(c, d, 0.0))
        .run(&Start::at_rest().twisted(&[("shaft", rad(phi_0))]), s(0.15), None)
        .unwrap();
    let decay = d / (2.0 * reduced());
    let w = (c / reduced() - decay * decay).sqrt();
    let t: f64 = 0.15;
    let phi = phi_0 * libm::exp(-decay * t) * (libm::cos(w * t) + decay / w * libm::sin(w * t));
    let rate = -phi_0 * libm::exp(-decay * t) * (w + decay * decay / w) * libm::sin(w * t);
    close(twist(&run), phi, 1e-9);
    close(end_speed(&run, "a"), J[1] / (J[0] + J[1]) * rate, 1e-9);
    let spent = 0.5 * c * phi_0 * phi_0 - 0.5 * c * phi * phi - 0.5 * reduced() * rate * rate;
    close(joules(run.audit.damping[0]), spent, 1e-9);
    assert!(run.audit.residual().abs() < 1e-10);
}

#[test]
fn a_swinging_torque_forces_two_inertias() {
    let (c, d, t_0, forced, end) = (500.0, 3.0, 40.0, 30.0, 1.3_f64);
    let mut model = pair(shaft(c, d, 0.0));
    let sine = Course::harmonic(n_m(0.0), n_m(t_0), omega(forced), rad(0.0)).unwrap();
    model.torque("motor", "a", TorqueLaw::over_time(sine)).unwrap();
    let run = model.run(&Start::at_rest(), s(end), None).unwrap();
    // φ̈ + 2δ·φ̇ + ω²·φ = f·sin Ωt: the swing that stays, and one that dies and begins from rest with it.
    let (decay, f) = (d / (2.0 * reduced()), t_0 / J[0]);
    let natural = c / reduced();
    let (p, q) = (natural - forced * forced, 2.0 * decay * forced);
    let (sine, cosine) = (f * p / (p * p + q * q), -f * q / (p * p + q * q));
    let w = (natural - decay * decay).sqrt();
    let a = -cosine;
    let b = (-sine * forced + decay * a) / w;
    let fading = libm::exp(-decay * end);
    let phi = sine * libm::sin(forced * end)
        + cosine * libm::cos(forced * end)
        + fading * (a * libm::cos(w * end) + b * libm::sin(w * end));
    close(twist(&run), phi, 1e-9);
    let mean = t_0 / (forced * (J[0] + J[1])) * (1.0 - libm::cos(forced * end));
    let found = (J[0] * end_speed(&run, "a") + J[1] * end_speed(&run, "b")) / (J[0] + J[1]);
    close(found, mean, 1e-9);
    assert!(run.audit.residual().abs() < 1e-9);
}

/// Events with the contact that each begins.
fn contacts(run: &Run) -> Vec<(f64, Contact)> {
    run.events
        .iter()
        .map(|event| match event.changes.as_slice() {
            [Change::Shaft { to, .. }] => (at(event), *to),
            other => panic!("{other:?}"),
        })
        .collect()
}

#[test]
fn play_without_damping_is_crossed_at_times_in_closed_form() {
    let (c, j, v) = (2000.0, 0.02, 4.0);
    let run = pair(shaft(c, 0.0, j)).run(&start(&[("a", v), ("b", 0.0)]), s(0.2), None).unwrap();
    // From the middle to a flank, half a swing on it, across, half a swing, and so on.
    let swing = PI * (reduced() / c).sqrt();
    let mut due = vec![];
    let mut t = 0.5 * j / v;
    let mut side = Contact::Forward;
    while t < 0.2 {
        due.push((t, side));
        t += swing;
        if t < 0.2 {
            due.push((t, Contact::Free));
        }
        t += j / v;
        side = if side == Contact::Forward { Contact::Backward } else { Contact::Forward };
    }
    let found = contacts(&run);
    assert_eq!(found.len(), due.len());
    assert!(due.len() > 10);
    for (found, due) in found.iter().zip(&due) {
        assert_eq!(found.1, due.1);
        close(found.0, due.0, 1e-10);
    }
    assert!(run.audit.residual().abs() < 1e-10, "{}", run.audit.residual());
}

#[test]
fn damped_flanks_part_before_they_are_relaxed_and_do_not_pull() {
    let (c, d, j) = (2000.0, 6.0, 0.02_f64);
    let run = pair(shaft(c, d, j)).run(&start(&[("a", 4.0), ("b", 0.0)]), s(0.25), Some(s(1e-4))).unwrap();
    let (decay, natural) = (d / (2.0 * reduced()), c / reduced());
    let w = (natural - decay * decay).sqrt();
    let (mut t, mut v, mut side) = (0.5 * j / 4.0, 4.0, Contact::Forward);
    let mut due = vec![];
    for _ in 0..4 {
        due.push((t, side));
        // δ = v/w·e^(−δt)·sin wt, and c·δ + d·δ̇ = 0.
        let angle = PI + libm::atan(-d * w / (c - d * decay));
        let fading = libm::exp(-decay * angle / w);
        let left = v / w * fading * libm::sin(angle);
        v = -(v * fading * (libm::cos(angle) - decay / w * libm::sin(angle)));
        assert!(left > 0.0);
        close(left, d / c * v, 1e-9);
        t += angle / w;
        due.push((t, Contact::Free));
        t += (j + left) / v;
        side = if side == Contact::Forward { Contact::Backward } else { Contact::Forward };
    }
    for (found, due) in contacts(&run).iter().zip(&due) {
        assert_eq!(found.1, due.1);
        close(found.0, due.0, 1e-9);
    }
    for sample in &run.samples {
        let torque = sample.shafts[0].get::<newton_meter>();
        let twist = sample.twists[0].get::<radian>();
        assert!(torque * twist >= 0.0, "{torque} {twist}");
        assert!(torque == 0.0 || twist.abs() >= 0.5 * j);
    }
    assert!(run.audit.residual().abs() < 1e-9, "{}", run.audit.residual());
    assert!(joules(run.audit.damping[0]) > 0.0);
}

#[test]
fn a_load_rests_on_one_flank_in_the_end() {
    let mut model = pair(shaft(2000.0, 30.0, 0.02));
    model.torque("motor", "a", constant(10.0)).unwrap();
    model.torque("load", "b", constant(-2.0)).unwrap();
    let run = model.run(&Start::at_rest(), s(3.0), None).unwrap();
    let due = 10.0 - J[0] * 8.0 / (J[0] + J[1]);
    close(run.end().shafts[0].get::<newton_meter>(), due, 1e-8);
    close(twist(&run), 0.01 + due / 2000.0, 1e-9);
    assert_eq!(run.end().contacts, [Contact::Forward]);
    assert!(run.audit.residual().abs() < 1e-9);
}

#[test]
fn a_stiffer_shaft_is_nearer_to_a_rigid_one_as_the_root_of_its_stiffness() {
    let with = |stiffness: Option<f64>| {
        let mechanism = held_t().with_body("vehicle", kg_m2(3.0)).unwrap();
        let mut model = Model::new(mechanism);
        model.torque("motor", "sun", constant(12.0)).unwrap();
        match stiffness {
            Some(stiffness) => model.shaft("shaft", ["carrier", "vehicle"], shaft(stiffness, 0.0, 0.0)),
            None => model.friction("weld", ["carrier", "vehicle"], level(1e6), 1.0),
        }
        .unwrap();
        model.run(&start(&[("sun", 0.0), ("vehicle", 0.0)]), s(0.5), Some(s(1e-3))).unwrap()
    };
    let rigid = with(None);
    let off = |run: &Run| {
        let pairs = run.samples.iter().zip(&rigid.samples);
        pairs.fold(0.0_f64, |most, (one, due)| {
            most.max((speed(run, one, "vehicle") - speed(&rigid, due, "vehicle")).abs())
        })
    };
    let (soft, stiff) = (with(Some(1e4)), with(Some(1e6)));
    // Swings of φ̇ of size ΔT/(J·ω_0) around the common motion.
    let ratio = off(&soft) / off(&stiff);
    assert!((9.0..11.0).contains(&ratio), "{ratio}");
    // J_c + 1/(1/i²·…): the frequency of the reduced inertia of the gearbox at its carrier against that of
    // the vehicle.
    let felt = held_t().equivalent_inertia("carrier").unwrap();
    let j = felt.get::<kilogram_square_meter>();
    let w = (1e4 * (1.0 / j + 1.0 / 3.0)).sqrt();
    close(off(&soft), 12.0 * 4.5 / (j + 3.0) / w, 1e-3);
}

#[test]
fn a_shaft_between_two_free_links_of_a_set_swings_at_its_frequency() {
    let mechanism = Mechanism::of(&train_t(MeshLoss::IDEAL), &[], &masses_t(true)).unwrap();
    let row: Vec<f64> = mechanism
        .speed_factors("sun")
        .unwrap()
        .iter()
        .zip(mechanism.speed_factors("ring").unwrap())
        .map(|(one, other)| one - other)
        .collect();
    let m: Vec<Vec<f64>> = mechanism
        .mass_matrix()
        .iter()
        .map(|row| row.iter().map(MomentOfInertia::get::<kilogram_square_meter>).collect())
        .collect();
    // D·M⁻¹·Dᵀ of two coordinates.
    let determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    let mobility = (row[0] * row[0] * m[1][1] - 2.0 * row[0] * row[1] * m[0][1] + row[1] * row[1] * m[0][0])
        / determinant;
    let mut model = Model::new(mechanism);
    model.shaft("spring", ["sun", "ring"], shaft(80.0, 0.0, 0.0)).unwrap();
    let run = model.run(&Start::at_rest().twisted(&[("spring", rad(0.3))]), s(0.4), None).unwrap();
    close(twist(&run), 0.3 * libm::cos((80.0 * mobility).sqrt() * 0.4), 1e-9);
}

#[test]
fn a_clutch_drives_a_vehicle_through_its_shaft_and_keeps_the_energies() {
    let mechanism =
        Mechanism::of(&train_t(MeshLoss::Set(common::eta(0.97))), &["hold"], &masses_t(true)).unwrap();
    let mechanism =
        mechanism.with_body("engine", kg_m2(0.2)).unwrap().with_body("vehicle", kg_m2(20.0)).unwrap();
    let mut model = Model::new(mechanism);
    model.torque("motor", "engine", TorqueLaw::linear(n_m(80.0), omega(400.0)).unwrap()).unwrap();
    model.friction("clutch", ["engine", "sun"], common::table(&[(0.1, 0.0), (0.6, 90.0)]), 1.2).unwrap();
    model.shaft("drive", ["carrier", "vehicle"], shaft(900.0, 4.0, 0.05)).unwrap();
    model.resistance("rolling", "vehicle", n_m(15.0)).unwrap();
    let run = model
        .run(&start(&[("engine", 150.0), ("sun", 0.0), ("vehicle", 0.0)]), s(3.0), Some(s(0.01)))
        .unwrap();
    assert!(run.audit.residual().abs() < 1e-9, "{}", run.audit.residual());
    assert!(run.events.len() >= 3, "{:?}", run.events);
    assert!(end_speed(&run, "vehicle") > 5.0);
}

#[test]
fn a_body_that_is_held_to_a_link_is_felt_as_if_it_were_of_it() {
    let plain = {
        let mut masses = masses_t(true);
        masses.links[1].1 += kg_m2(2.0);
        let mut model =
            Model::new(Mechanism::of(&train_t(MeshLoss::Set(common::eta(0.97))), &[], &masses).unwrap());
        model.torque("motor", "sun", constant(12.0)).unwrap();
        model.torque("load", "carrier", constant(-30.0)).unwrap();
        model.run(&start(&[("sun", 50.0), ("ring", 5.0)]), s(0.5), None).unwrap()
    };
    let mechanism = Mechanism::of(&train_t(MeshLoss::Set(common::eta(0.97))), &[], &masses_t(true)).unwrap();
    let mut model = Model::new(mechanism.with_body("flywheel", kg_m2(2.0)).unwrap());
    model.torque("motor", "sun", constant(12.0)).unwrap();
    model.torque("load", "carrier", constant(-30.0)).unwrap();
    model.friction("weld", ["flywheel", "carrier"], level(1e5), 1.0).unwrap();
    let carrier = (20.0 * 50.0 + 70.0 * 5.0) / 90.0;
    let run =
        model.run(&start(&[("sun", 50.0), ("ring", 5.0), ("flywheel", carrier)]), s(0.5), None).unwrap();
    for link in ["sun", "ring", "carrier"] {
        close(end_speed(&run, link), end_speed(&plain, link), 1e-10);
    }
    close(joules(run.audit.mesh_losses[0]), joules(plain.audit.mesh_losses[0]), 1e-9);
}

#[test]
fn what_is_no_shaft_is_refused() {
    assert!(matches!(Shaft::new(n_m(0.0), rad(1.0)), Err(Error::Value { .. })));
    assert!(matches!(Shaft::new(n_m(1.0), rad(-1.0)), Err(Error::Value { .. })));
    let one = Shaft::new(n_m(1.0), rad(1.0)).unwrap();
    assert!(matches!(one.damping(n_m(-1.0), omega(1.0)), Err(Error::Value { .. })));
    assert!(matches!(one.backlash(rad(f64::NAN)), Err(Error::Value { .. })));
    let mut model = pair(one);
    assert!(matches!(model.shaft("shaft", ["a", "b"], one), Err(Error::Duplicate { .. })));
    assert!(matches!(model.shaft("other", ["a", "a"], one), Err(Error::OnePiece { .. })));
    assert!(matches!(model.shaft("other", ["a", "c"], one), Err(Error::Unknown { .. })));
    assert!(model.shaft("housing", ["a", GROUND], one).is_ok());
    let begin = Start::at_rest().twisted(&[("none", rad(0.1))]);
    assert!(matches!(model.run(&begin, s(1.0), None), Err(Error::Unknown { what: "shaft", .. })));
    let body = Mechanism::shafts(&[("a", kg_m2(1.0))]).unwrap();
    assert!(matches!(body.clone().with_body("a", kg_m2(1.0)), Err(Error::Duplicate { .. })));
    assert!(matches!(body.with_body("b", kg_m2(0.0)), Err(Error::NoInertia { .. })));
}

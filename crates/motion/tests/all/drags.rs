//! Drags against closed forms: how they slow down, stick and let go, and what each loses.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common;

use common::{
    at, close, constant, end_speed, joules, kg_m2, level, n_m, omega, power_shift, s, speed, start, table,
    two_shafts,
};
use epicyclic_motion::{Change, Error, Mechanism, Model, Run, Start, State, TorqueLaw};
use epicyclic_train::GROUND;
use epicyclic_train::drag::{Beyond, DragCurve};
use uom::si::torque::newton_meter;

fn curve(points: &[(f64, f64)], beyond: Beyond) -> DragCurve {
    let points: Vec<_> = points.iter().map(|&(speed, torque)| (omega(speed), n_m(torque))).collect();
    DragCurve::new(&points, beyond).unwrap()
}

fn beyond(points: &[(f64, f64)]) -> DragCurve {
    curve(points, Beyond::Constant)
}

/// A wheel of 2 kg·m² on the housing.
fn wheel() -> Model {
    Model::new(Mechanism::shafts(&[("wheel", kg_m2(2.0))]).unwrap())
}

fn drag_of(run: &Run, place: usize) -> f64 {
    run.end().drags[place].get::<newton_meter>()
}

#[test]
fn a_viscous_drag_slows_down_exponentially_from_either_side() {
    let mut model = wheel();
    model.drag("oil", ["wheel", GROUND], &curve(&[(0.0, 0.0), (100.0, 50.0)], Beyond::Refused)).unwrap();
    for first in [80.0, -80.0] {
        let run = model.run(&start(&[("wheel", first)]), s(9.0), Some(s(0.25))).unwrap();
        assert!(run.events.is_empty());
        for (place, sample) in run.samples.iter().enumerate() {
            // ω = ω_0·exp(−c·t/J), c = 0.5 N·m·s.
            close(speed(&run, sample, "wheel"), first * libm::exp(-0.25 * 0.25 * place as f64), 1e-9);
        }
        close(joules(run.audit.drags[0]), 6400.0 * (1.0 - libm::exp(-4.5)), 1e-10);
        close(drag_of(&run, 0), -0.5 * first * libm::exp(-2.25), 1e-9);
        assert!(run.audit.residual().abs() < 1e-11);
    }
}

#[test]
fn a_constant_drag_slows_down_linearly_and_then_holds() {
    let mut model = wheel();
    model.drag("seal", ["wheel", GROUND], &beyond(&[(0.0, 4.0)])).unwrap();
    // What pulls at 3 N·m does not move it again; 5 N·m would.
    model.torque("pull", "wheel", TorqueLaw::over_time(table(&[(20.0, 0.0), (23.0, 3.0)]))).unwrap();
    for first in [30.0, -30.0_f64] {
        let run = model.run(&start(&[("wheel", first)]), s(30.0), None).unwrap();
        let [stop] = run.events.as_slice() else { panic!("{:?}", run.events) };
        close(at(stop), 15.0, 1e-12);
        let from = if first > 0.0 { State::Forward } else { State::Backward };
        assert_eq!(stop.changes, [Change::Drag { name: "seal".into(), from, to: State::Stuck }]);
        close(joules(run.audit.drags[0]), 900.0, 1e-12);
        assert_eq!(end_speed(&run, "wheel"), 0.0);
        close(drag_of(&run, 0), -3.0, 1e-12);
        assert!(run.elements.is_empty() && run.end().states.is_empty() && run.audit.heat.is_empty());
    }
    model.torque("more", "wheel", TorqueLaw::over_time(table(&[(25.0, 0.0), (35.0, 5.0)]))).unwrap();
    let run = model.run(&start(&[("wheel", 30.0)]), s(28.0), None).unwrap();
    // 3 + 0.5·(t − 25) = 4; then the rest, 0.25·τ²/J.
    close(at(&run.events[1]), 27.0, 1e-11);
    close(end_speed(&run, "wheel"), 0.25 / 2.0, 1e-9);
    assert!(run.audit.residual().abs() < 1e-11);
}

/// `ω = (ω_0 + M_0/c)·exp(−c·t/J) − M_0/c` in each segment.
#[test]
fn dry_and_viscous_parts_with_a_point_between_are_two_exponentials() {
    let mut model = wheel();
    model.drag("bearing", ["wheel", GROUND], &beyond(&[(0.0, 1.0), (20.0, 3.0), (60.0, 15.0)])).unwrap();
    let run = model.run(&start(&[("wheel", 50.0)]), s(40.0), None).unwrap();
    // From 50 to 20 rad/s M = −3 + 0.3·ω, below M = 1 + 0.1·ω.
    let first = 2.0 / 0.3 * libm::log((50.0 - 10.0) / (20.0 - 10.0));
    let second = 2.0 / 0.1 * libm::log((20.0 + 10.0) / 10.0);
    let [stop] = run.events.as_slice() else { panic!("{:?}", run.events) };
    close(at(stop), first + second, 1e-10);
    close(joules(run.audit.drags[0]), 2500.0, 1e-11);
    // Level beyond the last point.
    let fast = model.run(&start(&[("wheel", 90.0)]), s(4.0), None).unwrap();
    close(end_speed(&fast, "wheel"), 10.0 + 50.0 * libm::exp(0.0), 1e-10);
}

#[test]
fn two_drags_of_one_link_stick_together_and_share() {
    let mut model = wheel();
    model.drag("seal", ["wheel", GROUND], &beyond(&[(0.0, 3.0)])).unwrap();
    model.drag("bearing", [GROUND, "wheel"], &beyond(&[(0.0, 1.0), (10.0, 2.0)])).unwrap();
    model.torque("pull", "wheel", constant(2.0)).unwrap();
    let held = model.run(&Start::at_rest(), s(1.0), None).unwrap();
    assert!(held.end().is_split_unique && held.events.is_empty());
    close(drag_of(&held, 0), -1.5, 1e-12);
    close(drag_of(&held, 1), 0.5, 1e-12);
    let run = model.run(&start(&[("wheel", 8.0)]), s(20.0), None).unwrap();
    assert_eq!(run.events[0].changes.len(), 2);
    // J·ω̇ = 2 − 4 − 0.1·ω.
    close(at(&run.events[0]), 20.0 * libm::log((8.0 + 20.0) / 20.0), 1e-11);
    let [seal, bearing] = [0, 1].map(|place| joules(run.audit.drags[place]));
    // The seal loses 3 N·m times the angle.
    close(seal + bearing, joules(run.audit.work[0]) + 64.0, 1e-11);
    close(seal, 1.5 * joules(run.audit.work[0]), 1e-11);
    let turned =
        |change: &Change, way| matches!(change, Change::Drag { from, to: State::Stuck, .. } if *from == way);
    assert!(
        turned(&run.events[0].changes[0], State::Forward)
            && turned(&run.events[0].changes[1], State::Backward)
    );
}

#[test]
fn the_drag_of_a_clutch_acts_beside_its_friction_until_it_holds() {
    let mut model = two_shafts([2.0, 5.0], 0.0);
    model.drag("clutch", ["b", "a"], &beyond(&[(0.0, 10.0)])).unwrap();
    // Open: the drag alone brings both to one speed, and keeps it there.
    let run = model.run(&start(&[("a", 150.0), ("b", 10.0)]), s(30.0), None).unwrap();
    close(at(&run.events[0]), 20.0, 1e-12);
    assert_eq!(
        run.events[0].changes,
        [Change::Drag { name: "clutch".into(), from: State::Backward, to: State::Stuck }]
    );
    assert_eq!(run.end().states, [State::Open]);
    close(joules(run.audit.drags[0]), 14_000.0, 1e-12);
    assert_eq!(joules(run.audit.heat[0]), 0.0);
    // Both share as their torques, and one event tells the lock.
    let mut model = two_shafts([2.0, 5.0], 90.0);
    model.drag("clutch", ["a", "b"], &beyond(&[(0.0, 10.0)])).unwrap();
    let run = model.run(&start(&[("a", 150.0), ("b", 10.0)]), s(3.0), None).unwrap();
    let [closed] = run.events.as_slice() else { panic!("{:?}", run.events) };
    close(at(closed), 2.0, 1e-12);
    assert_eq!(closed.changes.len(), 1);
    close(joules(run.audit.heat[0]), 12_600.0, 1e-12);
    close(joules(run.audit.drags[0]), 1400.0, 1e-12);
    close(common::torque_of(&run.events[0].before, 0), -90.0, 1e-12);
    assert!(run.end().is_split_unique);
}

/// Holding, the element carries what it can, and the drag what is more.
#[test]
fn what_holds_with_a_drag_lets_go_at_both_together() {
    let mut model = two_shafts([2.0, 5.0], 90.0);
    model.drag("clutch", ["a", "b"], &beyond(&[(0.0, 10.0)])).unwrap();
    model.torque("motor", "a", TorqueLaw::over_time(table(&[(0.0, 0.0), (10.0, 200.0)]))).unwrap();
    let run = model.run(&Start::at_rest(), s(8.0), Some(s(0.01))).unwrap();
    // 5/7 of the motor's torque goes through: 100 N·m at 140.
    close(at(&run.events[0]), 7.0, 1e-11);
    for sample in &run.samples {
        let t = sample.time.get::<uom::si::time::second>();
        let through = (20.0 * t * 5.0 / 7.0).min(100.0);
        let own = -sample.elements[0].get::<newton_meter>();
        assert!((own - through.min(90.0)).abs() < 1e-9, "{t}: {own}");
        let dragged = -sample.drags[0].get::<newton_meter>();
        assert!((dragged - (through - 90.0).max(0.0)).abs() < 1e-9, "{t}: {dragged}");
    }
}

/// An overrunning clutch with a drag turns its shaft along; against its direction it lets go only beyond the
/// drag.
#[test]
fn a_one_way_clutch_holds_back_what_it_drags() {
    let mechanism = || Mechanism::shafts(&[("a", kg_m2(2.0)), ("b", kg_m2(6.0))]).unwrap();
    let mut model = Model::new(mechanism());
    model.one_way_clutch("free wheel", ["a", "b"]).unwrap();
    model.drag("free wheel", ["a", "b"], &beyond(&[(0.0, 3.0)])).unwrap();
    model.torque("motor", "a", TorqueLaw::over_time(table(&[(0.0, 0.0), (10.0, 10.0)]))).unwrap();
    let run = model.run(&Start::at_rest(), s(6.0), None).unwrap();
    // 6/8 of the motor's torque goes through: 3 N·m at 4.
    close(at(&run.events[0]), 4.0, 1e-11);
    close(end_speed(&run, "b"), 1.0 + 3.0 * 2.0 / 6.0, 1e-9);
    assert!(run.audit.residual().abs() < 1e-11 && run.end().is_split_unique);
    // Without the drag at once.
    let mut bare = Model::new(mechanism());
    bare.one_way_clutch("free wheel", ["a", "b"]).unwrap();
    bare.torque("motor", "a", constant(1.0)).unwrap();
    assert_eq!(end_speed(&bare.run(&Start::at_rest(), s(6.0), None).unwrap(), "b"), 0.0);
}

#[test]
fn an_engaged_dog_clutch_has_no_drag() {
    let mechanism = Mechanism::shafts(&[("a", kg_m2(2.0)), ("b", kg_m2(6.0))]).unwrap();
    let mut model = Model::new(mechanism);
    model.dog_clutch("dogs", ["a", "b"], &[(s(1.0), true), (s(2.0), false)], None).unwrap();
    model.drag("dogs", ["a", "b"], &beyond(&[(0.0, 3.0)])).unwrap();
    model.torque("motor", "a", constant(8.0)).unwrap();
    let run = model.run(&start(&[("a", 20.0), ("b", 0.0)]), s(3.0), Some(s(0.125))).unwrap();
    // Open the slip grows by 2.5 − 0.5 in a second; engaged there is none, and nothing is lost but by the
    // impact.
    for sample in &run.samples {
        let t = sample.time.get::<uom::si::time::second>();
        let torque = sample.drags[0].get::<newton_meter>();
        let due = if t > 1.0 && t <= 2.0 { 0.0 } else { -3.0 };
        assert!((torque - due).abs() < 1e-12 && sample.is_split_unique, "{t}: {torque}");
    }
    // ∫ 3·(20 + 2·t) dt over the first second, ∫ 3·2·τ dτ over the last.
    close(joules(run.audit.drags[0]), 3.0 * 21.0 + 3.0, 1e-11);
    assert!(run.audit.residual().abs() < 1e-12);
}

#[test]
fn a_speed_that_a_curve_does_not_tell_is_refused_when_it_comes() {
    let mut model = wheel();
    model.drag("oil", ["wheel", GROUND], &curve(&[(0.0, 0.0), (10.0, 1.0)], Beyond::Refused)).unwrap();
    model.torque("motor", "wheel", constant(5.0)).unwrap();
    let refused = model.run(&Start::at_rest(), s(90.0), None).unwrap_err();
    let Error::DragSpeed { drag, slip_rad_s, time_s, .. } = &refused else { panic!("{refused}") };
    assert_eq!(drag, "oil");
    close(*slip_rad_s, 10.0, 1e-9);
    // J·ω̇ = 5 − 0.1·ω.
    close(*time_s, 20.0 * libm::log(50.0 / 40.0), 1e-9);
    assert!(refused.to_string().contains("its curve is from 0 to 10 rad/s"), "{refused}");
    assert!(matches!(
        model.run(&start(&[("wheel", -11.0)]), s(1.0), None),
        Err(Error::DragSpeed { time_s: 0.0, .. })
    ));
    // A curve that begins above 0 tells nothing of what begins to turn; of what rests it does not need to.
    let mut model = wheel();
    model.drag("oil", ["wheel", GROUND], &curve(&[(5.0, 1.0), (10.0, 1.0)], Beyond::Refused)).unwrap();
    assert!(model.run(&Start::at_rest(), s(1.0), None).is_ok());
    model.torque("motor", "wheel", constant(5.0)).unwrap();
    assert!(matches!(model.run(&Start::at_rest(), s(1.0), None), Err(Error::DragSpeed { .. })));
    let found = model.run(&start(&[("wheel", 6.0)]), s(1.0), None).unwrap();
    close(end_speed(&found, "wheel"), 8.0, 1e-12);
}

/// The shift P2 with drags on its sun, and of its open clutch: nothing but the balance of each body is asked.
#[test]
fn drags_are_added_before_and_after_elements_alike() {
    let mut one = power_shift(150.0, 300.0);
    let mut other = power_shift(150.0, 300.0);
    let seal = beyond(&[(0.0, 2.0), (100.0, 3.0)]);
    other.drag("seal", ["sun", GROUND], &seal).unwrap();
    for model in [&mut one, &mut other] {
        model.shift_element("clutch", table(&[(0.0, 0.0), (0.4, 200.0)]), 1.0).unwrap();
        model.shift_drag("clutch", &beyond(&[(0.0, 1.0)])).unwrap();
    }
    one.drag("seal", ["sun", GROUND], &seal).unwrap();
    one.friction("parking", ["carrier", GROUND], level(0.0), 1.0).unwrap();
    let begin = start(&[("sun", 200.0), ("ring", 0.0)]);
    let [one, other] = [one, other].map(|model| model.run(&begin, s(1.0), None).unwrap());
    assert_eq!((&one.drags[0], &one.drags[1]), (&other.drags[1], &other.drags[0]));
    close(end_speed(&one, "sun"), end_speed(&other, "sun"), 1e-12);
    close(joules(one.audit.drags[0]), joules(other.audit.drags[1]), 1e-10);
    close(joules(one.audit.drags[1]), joules(other.audit.drags[0]), 1e-10);
    assert_eq!(
        (&one.elements[..], &other.elements[..]),
        (&["brake", "clutch", "parking"].map(String::from)[..], &["brake", "clutch"].map(String::from)[..])
    );
    assert!(one.audit.residual().abs() < 1e-11 && other.audit.residual().abs() < 1e-11);
    let unknown = power_shift(1.0, 1.0).shift_drag("lock", &beyond(&[(0.0, 1.0)]));
    assert!(matches!(unknown, Err(Error::Unknown { .. })));
}

//! Motions that do not follow are refused, and events that accumulate are named.
#![allow(clippy::unwrap_used, reason = "helpers of tests, with fixed data")]

use crate::common;

use common::{close, constant, end_speed, eta, kg_m2, level, links, n_m, s, start};
use epicyclic_dynamics::gearbox::Masses;
use epicyclic_motion::{Error, Mechanism, Model, Run, Shaft};
use epicyclic_train::set::{MeshLoss, SetKind, SetSpec};
use epicyclic_train::{GROUND, Gearbox};
use uom::si::angle::radian;
use uom::si::f64::Angle;

/// Two equal sets side by side from one sun to two carriers, and a clutch between these that never slips.
fn side_by_side(loss: MeshLoss) -> Result<Run, Error> {
    let set = |id, carrier| SetSpec::new(id, SetKind::Simple, ["sun", GROUND, carrier], 3.0).with_loss(loss);
    let gearbox = Gearbox::builder("side by side")
        .links(["sun", "left", "right"])
        .set(set("one", "left"))
        .set(set("two", "right"))
        .clutch("clutch", "left", "right")
        .input("sun")
        .output("left")
        .build()
        .unwrap();
    let masses = Masses { links: links(&[("sun", 0.1), ("left", 1.0), ("right", 2.0)]), ..Masses::default() };
    let mut model = Model::new(Mechanism::of(&gearbox, &[], &masses).unwrap());
    model.torque("motor", "sun", constant(10.0)).unwrap();
    model.shift_element("clutch", level(50.0), 1.0).unwrap();
    model.run(&start(&[("sun", 40.0)]), s(1.0), None)
}

#[test]
fn a_clutch_that_shares_torque_over_rolling_sets_with_losses_is_refused() {
    let run = side_by_side(MeshLoss::IDEAL).unwrap();
    close(end_speed(&run, "sun"), 40.0 + 10.0 / (0.1 + 3.0 / 16.0), 1e-12);
    assert!(!run.end().is_split_unique);
    let (elements, links, set) = match side_by_side(MeshLoss::Set(eta(0.97))) {
        Err(Error::OpenSplit { elements, links, set, time_s: 0.0 }) => (elements, links, set),
        other => panic!("the split of torque is open: {:?}", other.map(|run| run.events)),
    };
    assert_eq!(elements, ["clutch"]);
    assert_eq!(links, ["left", "right"]);
    assert!(set == "one" || set == "two");
}

#[test]
fn two_clutches_that_make_a_block_may_share_as_nothing_rolls_in_it() {
    let gearbox = common::train_t(MeshLoss::Set(eta(0.97)));
    let mut model = Model::new(Mechanism::of(&gearbox, &[], &common::masses_t(false)).unwrap());
    for (name, between) in [("one", ["sun", "ring"]), ("two", ["sun", "carrier"])] {
        model.friction(name, between, level(500.0), 1.0).unwrap();
    }
    model.torque("motor", "sun", constant(12.0)).unwrap();
    let run = model.run(&start(&[("sun", 3.0), ("ring", 3.0)]), s(1.0), None).unwrap();
    close(end_speed(&run, "sun"), 3.0 + 12.0 / 0.56, 1e-12);
    assert!(!run.end().is_split_unique);
}

#[test]
fn events_that_accumulate_are_named() {
    // Flanks as stiff as no steel, with a play of a nanoradian: 10¹¹ contacts a second.
    let mut model = Model::new(Mechanism::shafts(&[("a", kg_m2(1.0)), ("b", kg_m2(1.0))]).unwrap());
    let rad = Angle::new::<radian>;
    let shaft = Shaft::new(n_m(1e23), rad(1.0)).unwrap().backlash(rad(1e-9)).unwrap();
    model.shaft("flanks", ["a", "b"], shaft).unwrap();
    let Err(Error::Accumulating { time_s, events, within_s, parts, links }) =
        model.run(&start(&[("a", 200.0), ("b", 0.0)]), s(1.0), None)
    else {
        panic!("the contacts are too many")
    };
    assert_eq!(parts, ["flanks"]);
    assert_eq!(links, ["a", "b"]);
    assert_eq!(events, 64);
    assert!(within_s < 1e-9 && time_s < 1e-8, "{within_s} {time_s}");
}

//! Drag torques beside mesh losses: balance of energy, and the same without them as by the ways that know
//! none.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use crate::common;

use common::oracle::{BoxPlan, Dice};
use epicyclic_train::drag::{Beyond, Drag, DragCurve, Load};
use epicyclic_train::error::DragFault;
use epicyclic_train::{Analysis, Error, Gearbox, InputLoad, LinkId, State};
use uom::si::angular_velocity::radian_per_second;
use uom::si::f64::{AngularVelocity, Power, Torque};
use uom::si::power::watt;
use uom::si::torque::newton_meter;

fn omega(value: f64) -> AngularVelocity {
    AngularVelocity::new::<radian_per_second>(value)
}

fn n_m(value: f64) -> Torque {
    Torque::new::<newton_meter>(value)
}

fn watts(power: Power) -> f64 {
    power.get::<watt>()
}

fn constant(torque: f64) -> DragCurve {
    DragCurve::new(&[(omega(0.0), n_m(torque))], Beyond::Constant).unwrap()
}

/// Random driven gears with the number of the round.
fn driven(rounds: usize, mut test: impl FnMut(usize, &mut Dice, &Gearbox, &Analysis<'_>)) {
    let mut dice = Dice(0xd7a6);
    for round in 0..rounds {
        let plan = BoxPlan::random(4, 40, &mut dice);
        let Ok(gearbox) = plan.build(None) else { continue };
        let found = gearbox.analyze("g").unwrap();
        if *found.state() == State::Driven && gearbox.input() != gearbox.output() {
            test(round, &mut dice, &gearbox, &found);
        }
    }
}

#[test]
fn without_drags_it_is_the_operating_point() {
    let mut compared = 0;
    driven(3000, |round, dice, _, found| {
        let torque = n_m(if dice.chance(50) { 80.0 } else { -80.0 });
        let Ok(point) = found.at(omega(150.0), InputLoad::Torque(torque)) else { return };
        let same = found.with_drags(omega(150.0), Load::Input(torque), &[]).unwrap();
        let scale = watts(same.largest).max(1.0);
        let near = |one: Power, other: Power| (watts(one) - watts(other)).abs() < 1e-8 * scale;
        assert!(near(point.output * same.output_speed, same.output * same.output_speed), "{round}");
        assert!(near(point.loss, same.mesh_loss()), "{round}: {:?} {:?}", point.loss, same.mesh_loss());
        compared += 1;
    });
    assert!(compared > 200, "{compared}");
}

#[test]
fn energy_balances_with_any_drags() {
    let (mut balanced, mut turned) = (0, 0);
    driven(4000, |round, dice, gearbox, found| {
        let links: Vec<LinkId> = gearbox.link_ids().filter(|link| found.speed(*link).is_some()).collect();
        let mut drags = vec![];
        for place in 0..dice.below(4) {
            let pair = [links[dice.below(links.len())], links[dice.below(links.len())]];
            let curve = constant(f64::from(dice.between(1, 40)) / 10.0);
            drags.push(Drag { name: place.to_string(), links: pair, curve, shift_element: None });
        }
        let given = if dice.chance(70) { 90.0 } else { -90.0 };
        let all = match found.with_drags(omega(-120.0), Load::Input(n_m(given)), &drags) {
            Ok(all) => all,
            Err(Error::Inputs(_) | Error::NotDriven { .. }) => return,
            Err(error) => panic!("{round}: {error}"),
        };
        let largest = watts(all.largest);
        assert!(
            watts(all.imbalance()).abs() <= 1e-9 * largest,
            "{round}: {:?} of {largest}",
            all.imbalance()
        );
        assert!(watts(all.drag_loss()) >= 0.0 && watts(all.mesh_loss()) >= -1e-9 * largest, "{round}");
        assert!(
            all.efficiency().is_none_or(|efficiency| (0.0..=1.0 + 1e-9).contains(&efficiency)),
            "{round}"
        );
        balanced += 1;
        // From the output the same input follows, where power keeps its way through the meshes.
        if all.efficiency().is_some_and(|efficiency| efficiency > 0.3)
            && let Ok(back) = found.with_drags(omega(-120.0), Load::Output(all.output), &drags)
        {
            let off = (watts(back.input_power()) - watts(all.input_power())).abs();
            assert!(off < 1e-7 * largest.max(watts(back.largest)), "{round}: {all:?} {back:?}");
            turned += 1;
        }
    });
    assert!(balanced > 300 && turned > 200, "{balanced} {turned}");
}

/// Speeds below a curve, above it, and of links that float.
#[test]
fn what_a_curve_does_not_say_is_refused() {
    let gearbox = Gearbox::builder("I")
        .links(["D", "B", "T", "loose"])
        .set(epicyclic_train::set::SetSpec::simple("1", ["D", "T", "B"], 3.0))
        .brake("K", "T")
        .input("D")
        .output("B")
        .gear("slow", ["K"])
        .build()
        .unwrap();
    let slow = gearbox.analyze("slow").unwrap();
    let points = [(omega(10.0), n_m(1.0)), (omega(100.0), n_m(2.0))];
    let work = |pair: [&str; 2], beyond, speed| {
        let drag = gearbox.drag("d", pair, DragCurve::new(&points, beyond).unwrap()).unwrap();
        slow.with_drags(omega(speed), Load::Input(n_m(50.0)), &[drag])
    };
    for speed in [5.0, -5.0, 101.0, -101.0] {
        let refused = work(["D", "ground"], Beyond::Refused, speed);
        assert!(matches!(refused, Err(Error::Drag { fault: DragFault::Outside { .. }, .. })), "{refused:?}");
    }
    for (speed, torque) in [(5.0, 1.0), (-55.0, 1.5), (100.0, 2.0), (101.0, 2.0)] {
        let found = work(["D", "ground"], Beyond::Constant, speed).unwrap().drags[0];
        assert!((found.torque - n_m(torque)).abs() < n_m(1e-12) && found.slip == omega(speed));
    }
    // The held link and the housing turn alike: no drag, in or out of the curve.
    assert_eq!(work(["T", "ground"], Beyond::Refused, 50.0).unwrap().drags[0].torque, n_m(0.0));
    let adrift = work(["loose", "ground"], Beyond::Refused, 50.0);
    assert!(matches!(adrift, Err(Error::Drag { fault: DragFault::Adrift { .. }, .. })));
    assert!(gearbox.drag("d", ["D", "D"], constant(1.0)).is_err());
    assert!(gearbox.drag("d", ["D", "E"], constant(1.0)).is_err());
    assert!(gearbox.drag_of_shift_element("L", constant(1.0)).is_err());
    // An engaged brake has no drag.
    let of_brake = gearbox.drag_of_shift_element("K", constant(1.0)).unwrap();
    let engaged = slow.with_drags(omega(50.0), Load::Input(n_m(50.0)), &[of_brake]).unwrap();
    assert_eq!(watts(engaged.drag_loss()), 0.0);
}

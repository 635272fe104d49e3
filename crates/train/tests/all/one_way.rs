//! One-way clutches: holding on drive, overrunning on coast, idling beside a brake.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_train::one_way::{Duty, OneWay};
use epicyclic_train::set::{MeshLoss, SetKind, SetSpec};
use epicyclic_train::{Gearbox, GearboxBuilder, InputLoad, State};
use uom::si::angular_velocity::revolution_per_minute;
use uom::si::f64::{AngularVelocity, Torque};
use uom::si::torque::newton_meter;

/// A Simpson set: the sprag keeps the second carrier from turning backwards, beside the brake for low and
/// reverse.
fn simpson() -> GearboxBuilder {
    let set = |id: &str, members| {
        let loss = MeshLoss::Set(MeshEfficiency::new(0.97).unwrap());
        SetSpec::teeth(id, SetKind::Simple, members, 26, 54).unwrap().with_loss(loss)
    };
    Gearbox::builder("Simpson")
        .links(["in", "RA", "S", "CB", "out"])
        .set(set("PA", ["S", "RA", "out"]))
        .set(set("PB", ["S", "out", "CB"]))
        .clutch("FWD", "in", "RA")
        .clutch("DIR", "in", "S")
        .brake("INT", "S")
        .brake("LR", "CB")
        .one_way_clutch("SPRAG", "CB", "ground")
        .input("in")
        .output("out")
        .gear("D1", ["FWD", "SPRAG"])
        .gear("L1", ["FWD", "LR"])
        .gear("L1 both", ["FWD", "LR", "SPRAG"])
        .gear("2", ["FWD", "INT"])
        .gear("3", ["FWD", "DIR"])
        .gear("R", ["DIR", "LR"])
        .gear("R on the sprag", ["DIR", "SPRAG"])
        .gear("N", ["FWD"])
}

fn duty(gearbox: &Gearbox, gear: &str) -> OneWay {
    let found = gearbox.analyze(gear).unwrap();
    let all = found.one_way_clutches();
    assert_eq!(all.len(), 1);
    assert_eq!(gearbox.shift_elements()[all[0].shift_element].id(), "SPRAG");
    all[0]
}

#[test]
fn a_sprag_holds_first_gear_on_drive_and_lets_go_on_coast() {
    let gearbox = simpson().build().unwrap();
    let first = gearbox.analyze("D1").unwrap();
    assert_eq!(*first.state(), State::Driven);
    let low = gearbox.analyze("L1").unwrap();
    assert_eq!(first.ratio(), low.ratio());
    assert_eq!(first.efficiency(), low.efficiency());
    let own = duty(&gearbox, "D1");
    assert!(own.is_relied_on);
    assert_eq!((own.drive, own.coast), (Duty::Holds, Duty::Overruns));
    assert_eq!(first.has_engine_braking(), Some(false));
    // What it holds is what the brake would: the housing's part, i − 1 without losses.
    let shift_element = own.shift_element;
    let ideal = first.ideal().unwrap();
    assert!((ideal.shift_elements[shift_element].unwrap() - (first.ratio().unwrap() - 1.0)).abs() < 1e-12);
    // The other gears do not count on it, and it runs free in them.
    for gear in ["2", "3"] {
        let own = duty(&gearbox, gear);
        assert!(!own.is_relied_on);
        assert_eq!((own.drive, own.coast), (Duty::Overruns, Duty::Overruns), "{gear}");
        assert_eq!(gearbox.analyze(gear).unwrap().has_engine_braking(), None);
    }
}

#[test]
fn a_brake_beside_it_brakes_the_engine() {
    let gearbox = simpson().build().unwrap();
    let own = duty(&gearbox, "L1");
    assert!(!own.is_relied_on);
    assert_eq!((own.drive, own.coast), (Duty::Idles, Duty::Idles));
    // Both engaged: how they share the torque is open, ratio and efficiency are not.
    let both = gearbox.analyze("L1 both").unwrap();
    assert!(
        matches!(both.state(), State::TorquesIndeterminate { shift_elements, .. } if shift_elements == &["LR", "SPRAG"])
    );
    assert_eq!(both.efficiency(), gearbox.analyze("L1").unwrap().efficiency());
    let own = duty(&gearbox, "L1 both");
    assert_eq!((own.drive, own.coast), (Duty::Unknown, Duty::Unknown));
}

#[test]
fn contradictions_are_told() {
    let gearbox = simpson().build().unwrap();
    // In reverse the carrier is pushed forwards: the sprag would let go on drive and hold on coast.
    let own = duty(&gearbox, "R on the sprag");
    assert_eq!((own.drive, own.coast), (Duty::WouldOverrun, Duty::Holds));
    assert!(own.drive.is_contradiction());
    // A gear in which the freed sprag would have to turn backwards: first gear's carrier as a free output of
    // the sun.
    let turned = simpson().one_way_clutch("BACK", "ground", "CB").build().unwrap();
    let found = turned.analyze("2").unwrap();
    let back = found.one_way_clutches()[1];
    assert_eq!((back.drive, back.coast), (Duty::WouldHold, Duty::WouldHold));
    assert!(back.drive.is_contradiction());
    assert_eq!(turned.shift_elements()[back.shift_element].links()[1], turned.link("CB").unwrap());
    // Neutral settles nothing.
    let own = duty(&gearbox, "N");
    assert_eq!((own.drive, own.coast), (Duty::Unknown, Duty::Unknown));
}

/// A one-way clutch carries no torque below 0: at a braking input it lets go, and so it does where the input
/// is turned backwards.
#[test]
fn an_operating_point_that_reverses_its_torque_releases_it() {
    let gearbox = simpson().build().unwrap();
    let at = |gear: &str, rpm: f64, torque: f64| {
        let found = gearbox.analyze(gear).unwrap();
        let speed = AngularVelocity::new::<revolution_per_minute>(rpm);
        let operation = found.at(speed, InputLoad::Torque(Torque::new::<newton_meter>(torque))).unwrap();
        let released = found.released(&operation);
        let sprag = gearbox.shift_elements().iter().position(|one| one.id() == "SPRAG").unwrap();
        assert!(released.iter().all(|place| *place == sprag));
        let is_negative = operation.shift_elements[sprag].is_some_and(|torque| torque.value < -1e-9);
        assert_eq!(!released.is_empty(), is_negative, "{gear} {rpm} {torque}");
        !released.is_empty()
    };
    // Forwards it holds on drive alone; backwards it holds where the output drives.
    assert_eq!([at("D1", 1000.0, 100.0), at("D1", 1000.0, -100.0)], [false, true]);
    assert_eq!([at("D1", -1000.0, -100.0), at("D1", -1000.0, 100.0)], [true, false]);
    assert!(!at("D1", 1000.0, 0.0));
    // Beside the brake nothing relies on it.
    assert!(!at("L1", 1000.0, -100.0));
    // The gear that contradicts itself on drive holds on coast.
    assert_eq!([at("R on the sprag", 1000.0, 100.0), at("R on the sprag", 1000.0, -100.0)], [true, false]);
}

//! Quantities in SI units, and mechanisms that several tests have.
#![allow(dead_code, reason = "each test takes what it needs")]
#![allow(clippy::unwrap_used, reason = "the benchmark takes it, too, and fixed data are right")]

use epicyclic_dynamics::gearbox::{Masses, PlanetMass, PlanetMasses};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_motion::{Course, Event, Mechanism, Model, Run, Sample, Start, TorqueLaw};
use epicyclic_train::set::{MeshLoss, SetKind, SetSpec};
use epicyclic_train::{GROUND, Gearbox};
use uom::si::angle::radian;
use uom::si::angular_acceleration::radian_per_second_squared;
use uom::si::angular_velocity::radian_per_second;
use uom::si::energy::joule;
use uom::si::f64::{Angle, AngularVelocity, Energy, Length, Mass, MomentOfInertia, Time, Torque};
use uom::si::length::meter;
use uom::si::mass::kilogram;
use uom::si::moment_of_inertia::kilogram_square_meter;
use uom::si::time::second;
use uom::si::torque::newton_meter;

pub(crate) fn n_m(value: f64) -> Torque {
    Torque::new::<newton_meter>(value)
}

pub(crate) fn s(value: f64) -> Time {
    Time::new::<second>(value)
}

pub(crate) fn omega(value: f64) -> AngularVelocity {
    AngularVelocity::new::<radian_per_second>(value)
}

pub(crate) fn kg_m2(value: f64) -> MomentOfInertia {
    MomentOfInertia::new::<kilogram_square_meter>(value)
}

pub(crate) fn angle(value: f64) -> Angle {
    Angle::new::<radian>(value)
}

pub(crate) fn joules(value: Energy) -> f64 {
    value.get::<joule>()
}

pub(crate) fn close(found: f64, due: f64, relative: f64) {
    assert!(
        (found - due).abs() <= relative * due.abs(),
        "found {found:.13e}, due {due:.13e}: off by {:.2e}",
        (found - due).abs() / due.abs()
    );
}

/// Speed of a link in a sample.
pub(crate) fn speed(run: &Run, sample: &Sample, link: &str) -> f64 {
    sample.speeds[run.link(link).unwrap()].get::<radian_per_second>()
}

pub(crate) fn end_speed(run: &Run, link: &str) -> f64 {
    speed(run, run.end(), link)
}

pub(crate) fn acceleration(sample: &Sample, link: usize) -> f64 {
    sample.accelerations[link].get::<radian_per_second_squared>()
}

pub(crate) fn torque_of(sample: &Sample, element: usize) -> f64 {
    sample.elements[element].get::<newton_meter>()
}

pub(crate) fn at(event: &Event) -> f64 {
    event.after.time.get::<second>()
}

pub(crate) fn constant(value: f64) -> TorqueLaw {
    TorqueLaw::constant(n_m(value)).unwrap()
}

pub(crate) fn level(value: f64) -> Course {
    Course::constant(n_m(value)).unwrap()
}

pub(crate) fn table(points: &[(f64, f64)]) -> Course {
    let points: Vec<_> = points.iter().map(|&(time, torque)| (s(time), n_m(torque))).collect();
    Course::table(&points).unwrap()
}

pub(crate) fn links(named: &[(&str, f64)]) -> Vec<(String, MomentOfInertia)> {
    named.iter().map(|&(name, inertia)| (name.to_owned(), kg_m2(inertia))).collect()
}

/// Train T: z 20/25/70, N = 3, carrier radius 45 mm.
pub(crate) fn train_t(loss: MeshLoss) -> Gearbox {
    let set = SetSpec::teeth("T", SetKind::Simple, ["sun", "ring", "carrier"], 20, 70).unwrap();
    Gearbox::builder("T")
        .links(["sun", "ring", "carrier"])
        .set(
            set.planet_teeth(25.try_into().unwrap(), None)
                .planet_count(3.try_into().unwrap())
                .with_loss(loss),
        )
        .brake("hold", "ring")
        .input("sun")
        .output("carrier")
        .build()
        .unwrap()
}

/// Masses of train T, its planets with or without theirs.
pub(crate) fn masses_t(with_planets: bool) -> Masses {
    let planet = PlanetMass {
        mass: Mass::new::<kilogram>(0.3),
        inertia: kg_m2(1e-4),
        radius: Length::new::<meter>(0.045),
    };
    let planets = vec![("T".to_owned(), PlanetMasses { count: 3, each: vec![planet] })];
    Masses {
        links: links(&[("sun", 0.01), ("carrier", 0.5), ("ring", 0.05)]),
        planets: if with_planets { planets } else { vec![] },
    }
}

/// Train T with its ring held.
pub(crate) fn held_t() -> Mechanism {
    Mechanism::of(&train_t(MeshLoss::IDEAL), &["hold"], &masses_t(true)).unwrap()
}

/// The power shift P2: a one-way clutch or a brake as given by `brake`, and the clutch open.
pub(crate) fn power_shift(engine: f64, load: f64) -> Model {
    let gearbox = Gearbox::builder("P2")
        .links(["sun", "ring", "carrier"])
        .set(SetSpec::simple("set", ["sun", "ring", "carrier"], 2.0))
        .one_way_clutch("brake", "ring", GROUND)
        .clutch("clutch", "sun", "ring")
        .input("sun")
        .output("carrier")
        .build()
        .unwrap();
    let masses = Masses { links: links(&[("sun", 0.2), ("carrier", 8.0)]), ..Masses::default() };
    let mut model = Model::new(Mechanism::of(&gearbox, &[], &masses).unwrap());
    model.torque("engine", "sun", constant(engine)).unwrap();
    model.torque("load", "carrier", constant(-load)).unwrap();
    model
}

/// Two shafts and a clutch of constant capacity.
pub(crate) fn two_shafts(j: [f64; 2], capacity: f64) -> Model {
    let mechanism =
        Mechanism::shafts(&[("a", kg_m2(j[0])), ("b", kg_m2(j[1]))]).expect("two shafts and a clutch");
    let mut model = Model::new(mechanism);
    model.friction("clutch", ["a", "b"], level(capacity), 1.0).expect("two shafts and a clutch");
    model
}

pub(crate) fn eta(value: f64) -> MeshEfficiency {
    MeshEfficiency::new(value).unwrap()
}

pub(crate) fn start(speeds: &[(&str, f64)]) -> Start {
    let speeds: Vec<_> = speeds.iter().map(|&(link, speed)| (link, omega(speed))).collect();
    Start::speeds(&speeds)
}

/// The 8HP with losses and planets, all shift elements open.
pub(crate) fn eight_speeds() -> Mechanism {
    let set = |id, members, [sun, ring, planet]: [u32; 3]| {
        SetSpec::teeth(id, SetKind::Simple, members, sun, ring)
            .unwrap()
            .planet_teeth(planet.try_into().unwrap(), None)
            .with_loss(MeshLoss::Set(eta(0.98)))
    };
    let gearbox = Gearbox::builder("8HP")
        .links(["in", "S1S2", "R1", "C1R4", "R2S3", "R3S4", "C3", "out"])
        .set(set("P1", ["S1S2", "R1", "C1R4"], [48, 96, 24]))
        .set(set("P2", ["S1S2", "R2S3", "in"], [48, 96, 24]))
        .set(set("P3", ["R2S3", "R3S4", "C3"], [60, 96, 18]))
        .set(set("P4", ["R3S4", "C1R4", "out"], [28, 104, 38]))
        .brake("A", "S1S2")
        .brake("B", "R1")
        .clutch("C", "in", "R3S4")
        .clutch("D", "C3", "out")
        .clutch("E", "R2S3", "R3S4")
        .input("in")
        .output("out")
        .build()
        .unwrap();
    let planet = |radius: f64| PlanetMass {
        mass: Mass::new::<kilogram>(0.15),
        inertia: kg_m2(4e-5),
        radius: Length::new::<meter>(radius),
    };
    let planets = [("P1", 0.05), ("P2", 0.05), ("P3", 0.055), ("P4", 0.046)]
        .map(|(set, radius)| (set.to_owned(), PlanetMasses { count: 4, each: vec![planet(radius)] }));
    let small = ["S1S2", "R1", "C1R4", "R2S3", "R3S4", "C3"].map(|link| (link, 0.01));
    let masses = Masses {
        links: links(&[&small[..], &[("in", 0.2), ("out", 6.0)]].concat()),
        planets: planets.into(),
    };
    Mechanism::of(&gearbox, &[], &masses).unwrap()
}

/// Ten seconds of driving with the 8HP: from rest through gears 1 to 4 against drag and a rolling resistance.
pub(crate) fn drive_cycle() -> Model {
    let mut model = Model::new(eight_speeds());
    model.torque("engine", "in", TorqueLaw::linear(n_m(300.0), omega(700.0)).unwrap()).unwrap();
    model.torque("drag", "out", TorqueLaw::quadratic(n_m(200.0), omega(150.0)).unwrap()).unwrap();
    model.resistance("rolling", "out", n_m(60.0)).unwrap();
    let full = 900.0;
    let on = |t: f64| table(&[(t, 0.0), (t + 0.4, full)]);
    let off = |t: f64| table(&[(t, full), (t + 0.2, 0.0)]);
    model.shift_element("A", off(4.5), 1.1).unwrap();
    model.shift_element("B", level(full), 1.1).unwrap();
    let c = [(2.0, full), (2.2, 0.0), (4.5, 0.0), (4.9, full), (7.0, full), (7.2, 0.0)];
    model.shift_element("C", table(&c), 1.1).unwrap();
    model.shift_element("D", on(7.0), 1.1).unwrap();
    model.shift_element("E", on(2.0), 1.1).unwrap();
    model
}

//! Elements that hold the same links together: one motion, whichever of them carries how much.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests, with data made to fit")]

use crate::common;

use common::{angle, constant, end_speed, eta, joules, kg_m2, level, links, n_m, omega, s, start, table};
use epicyclic_dynamics::gearbox::Masses;
use epicyclic_motion::{Error, Mechanism, Model, Run, Shaft, TorqueLaw};
use epicyclic_train::set::{MeshLoss, SetSpec};
use epicyclic_train::{GROUND, Gearbox};

/// First gear of an automatic: the low brake beside the one-way clutch holds the ring, and a half-shaft ends at the vehicle.
/// The driver lifts after a second, and the engine brakes.
#[derive(Debug, Clone, Copy)]
struct FirstGear {
    capacity: f64,
    stiffness: f64,
    damping: f64,
    vehicle: f64,
}

impl FirstGear {
    fn run(&self) -> Result<Run, Error> {
        let set = SetSpec::simple("s0", ["sun", "ring", "car"], 2.5).with_loss(MeshLoss::Set(eta(0.97)));
        let gearbox = Gearbox::builder("first gear")
            .links(["sun", "ring", "car"])
            .set(set)
            .one_way_clutch("F", "ring", GROUND)
            .brake("LR", "ring")
            .input("sun")
            .output("car")
            .build()
            .unwrap();
        let masses =
            Masses { links: links(&[("sun", 0.2), ("ring", 0.02), ("car", 0.1)]), ..Masses::default() };
        let mechanism = Mechanism::of(&gearbox, &[], &masses).unwrap();
        let mut model = Model::new(mechanism.with_body("vehicle", kg_m2(self.vehicle)).unwrap());
        let engine = table(&[(0.0, 100.0), (1.0, 100.0), (1.2, -60.0), (3.0, -60.0)]);
        model.torque("engine", "sun", TorqueLaw::over_time(engine)).unwrap();
        model.torque("drag", "vehicle", constant(-50.0)).unwrap();
        model.shift_element("LR", level(self.capacity), 1.0).unwrap();
        let shaft = Shaft::new(n_m(self.stiffness), angle(1.0)).unwrap();
        let shaft = shaft.damping(n_m(self.damping), omega(1.0)).unwrap();
        model.shaft("half shaft", ["car", "vehicle"], shaft).unwrap();
        let begin = start(&[("sun", 35.0), ("car", 10.0), ("vehicle", 10.0)]);
        model.run(&begin, s(3.0), None)
    }
}

#[test]
fn a_brake_beside_a_one_way_clutch_behind_a_shaft_lets_go_when_the_driver_lifts() {
    let mut failed = vec![];
    for capacity in [20.0, 60.0, 150.0] {
        for stiffness in [2e3, 8e3, 2e4] {
            for damping in [5.0, 20.0] {
                for vehicle in [40.0, 120.0] {
                    let one = FirstGear { capacity, stiffness, damping, vehicle };
                    let began = std::time::Instant::now();
                    match one.run() {
                        Ok(run) => println!(
                            "{one:?}: {} events {} steps {:e} {:?} {}",
                            run.events.len(),
                            run.steps,
                            run.audit.residual(),
                            began.elapsed(),
                            end_speed(&run, "ring")
                        ),
                        Err(error) => {
                            println!("{one:?}: {error}");
                            failed.push(error)
                        }
                    }
                }
            }
        }
    }
    assert!(failed.is_empty(), "{}", failed.len());
}

//! Two shafts and a clutch: when it closes.

use epicyclic_motion::{Course, Mechanism, Model, Start};
use uom::si::angular_velocity::radian_per_second;
use uom::si::f64::{AngularVelocity, MomentOfInertia, Time, Torque};
use uom::si::moment_of_inertia::kilogram_square_meter;
use uom::si::{time::second, torque::newton_meter};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (inertia, s) = (MomentOfInertia::new::<kilogram_square_meter>, Time::new::<second>);
    let mut model = Model::new(Mechanism::shafts(&[("a", inertia(0.4)), ("b", inertia(1.6))])?);
    let capacity = Torque::new::<newton_meter>(80.0);
    model.friction("clutch", ["a", "b"], Course::table(&[(s(0.0), capacity), (s(9.0), capacity)])?, 1.0)?;
    let omega = AngularVelocity::new::<radian_per_second>;
    let run = model.run(&Start::speeds(&[("a", omega(120.0)), ("b", omega(0.0))]), s(1.0), None)?;
    println!("{:.3} s", run.events[0].after.time.get::<second>());
    Ok(())
}

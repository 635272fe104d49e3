//! Starting time of a drive under half its load.

use epicyclic_dynamics::drive::{DriveSpec, design};
use uom::si::angular_velocity::revolution_per_minute;
use uom::si::f64::{AngularVelocity, Length, Power};
use uom::si::{length::millimeter, power::kilowatt};

fn main() -> Result<(), epicyclic_dynamics::Error> {
    let mm = Length::new::<millimeter>;
    let speed = AngularVelocity::new::<revolution_per_minute>(1950.0);
    let spec = DriveSpec::new(Power::new::<kilowatt>(106.5), speed, 6.0, mm(8.0), mm(60.0));
    let full_load = design(&spec)?.torques.carrier;
    let half_load = design(&DriveSpec { load: Some(full_load / 2.0), ..spec })?;
    println!("{:?}", half_load.with_losses.start);
    Ok(())
}

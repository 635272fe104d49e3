//! Safeties of a spur pair of 18 and 36 teeth, module 4 mm, case-hardened.

use epicyclic_gears::involute::{InvoluteGear, Pair, Profile};
use epicyclic_gears::{ToothCount, geometry::GearKind::External};
use epicyclic_strength::mesh::{Gear, Load, Mesh, Method};
use epicyclic_strength::rating::rate;
use epicyclic_strength::{Error, factor::Given, material};
use uom::si::f64::{AngularVelocity, KinematicViscosity, Length, Time, Torque};
use uom::si::{angular_velocity as omega, kinematic_viscosity as nu, length, time, torque};

fn main() -> Result<(), Error> {
    let gear = |teeth| InvoluteGear::new(External, ToothCount::new(teeth)?, Profile::default(), 0.3);
    let pair = Pair::without_backlash(gear(18)?, gear(36)?)?;
    let steel = material::listed("18CrNiMo7-6").expect("it is in the table").material;
    let [flank, root] = [4.0, 16.0].map(Length::new::<length::micrometer>);
    let [module, face_width] = [4.0, 60.0].map(Length::new::<length::millimeter>);
    let viscosity = KinematicViscosity::new::<nu::square_millimeter_per_second>(220.0);
    let mesh = Mesh { pair, module, face_width, gears: [Gear::solid(steel, flank, root); 2], viscosity };
    let torque = Torque::new::<torque::newton_meter>(500.0);
    let speed = AngularVelocity::new::<omega::revolution_per_minute>(1450.0);
    let load = Load { torque, speed, life: Time::new::<time::hour>(20e3), contacts: [1.0, 1.0] };
    let given = Given::load_factors([1.25, 1.0, 1.1, 1.2, 1.0]);
    let rating = rate(&mesh, &load, &Method { given, ..Method::default() })?;
    for gear in rating.gears {
        println!("S_H = {:.3}, S_F = {:.3}", gear.contact?.safety, gear.root?.safety);
    }
    Ok(())
}

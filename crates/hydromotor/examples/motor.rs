//! A motor of five arches and three lobes: its displacement over width, and its ripple at the pitch points.

use epicyclic_hydromotor::closure::Family;
use epicyclic_hydromotor::{Motor, MotorNumbers};
use uom::si::{area::square_millimeter, f64::Length, length::millimeter};

fn main() -> Result<(), epicyclic_hydromotor::Error> {
    let module = Length::new::<millimeter>(2.0);
    let numbers = MotorNumbers::new(5, 3, 55, 10)?;
    let arcs = Family::new(numbers, module)?.at_part(0.5)?;
    let motor = Motor::of_two_arcs(numbers, module, arcs.trough_distance())?;
    let displacement = motor.displacement_per_width().get::<square_millimeter>();
    println!("{displacement:.1} mm², ripple {:.2} % at the pitch points", 100.0 * motor.ripple().delta);
    Ok(())
}

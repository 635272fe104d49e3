//! Quantities as engineers write them, and a slip of the pen.

use epicyclic_units::{Physical, Quantity};
use uom::si::f64::{Power, Torque};

fn main() -> Result<(), epicyclic_units::QuantityError> {
    let power: Quantity<Power> = "106.5 kW".parse()?;
    println!("{power} is {} W", power.0.si());
    println!("{}", Quantity(Torque::from_si(521.8)));
    let wrong = "106,5 kW".parse::<Quantity<Power>>();
    println!("{}", wrong.err().map_or_else(String::new, |error| error.to_string()));
    Ok(())
}

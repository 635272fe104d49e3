//! The parameter of scheme I for the ratio of a conveyor.

use epicyclic_schemes::catalogue::TwoSpeed;

fn main() -> Result<(), epicyclic_schemes::Error> {
    println!("scheme I, i = 3.94: k = {}", TwoSpeed::I.ring_to_sun_ratio(3.94)?.get());
    Ok(())
}

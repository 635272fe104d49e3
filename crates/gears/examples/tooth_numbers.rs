//! The three best sets of tooth numbers for a ratio of 6.

use epicyclic_gears::simple_set::{Member, Mode};
use epicyclic_gears::synthesis::Bounds;

fn main() -> Result<(), epicyclic_gears::Error> {
    let sun_to_carrier = Mode::new(Member::Sun, Member::Carrier)?;
    for found in Bounds::default().for_ratio(6.0, sun_to_carrier, 0.01)?.iter().take(3) {
        let teeth = found.teeth;
        println!("{} {} {}: {}", teeth.sun, teeth.planet, teeth.ring, found.exact_ratio);
    }
    Ok(())
}

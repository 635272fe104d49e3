//! The scheme for the two speeds of a conveyor.

use epicyclic_schemes::RatioSeries;
use epicyclic_schemes::catalogue::Scheme;
use epicyclic_selection::{Requirements, Space, select};
use uom::si::{f64::Velocity, velocity::meter_per_second};

fn main() -> Result<(), epicyclic_selection::Error> {
    let speeds = [0.8, 3.15].map(Velocity::new::<meter_per_second>);
    let found = select(&Requirements::new(RatioSeries::of_speeds(&speeds, 1)?), &Space::Catalogue)?;
    let best = &found.accepted[found.best[0]];
    println!("{:?} with k = {:?}", best.mechanism.scheme().map(Scheme::name), best.k);
    Ok(())
}

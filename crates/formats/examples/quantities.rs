//! A file with quantities, and a mistake in one.

use epicyclic_formats::Document;
use epicyclic_units::{Number, Quantity};
use serde::Deserialize;
use uom::si::f64::Power;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Drive {
    ratio: Number,
    power: Quantity<Power>,
}

fn main() -> Result<(), epicyclic_formats::Error> {
    let drive: Drive = Document::parse_one("drive.yaml", b"ratio: 3.94\npower: 75kW\n")?.read()?;
    println!("{} at {}", drive.power, drive.ratio.get());
    let wrong = Document::parse_one("drive.yaml", b"ratio: 3,94\npower: 75kW\n")?.read::<Drive>();
    println!("{}", wrong.err().map_or_else(String::new, |error| error.to_string()));
    Ok(())
}

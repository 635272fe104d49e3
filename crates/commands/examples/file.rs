//! Prints the gears of a gearbox file.

use epicyclic_commands::shared::gearbox::{Choice, one};
use epicyclic_formats::Document;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let name = std::env::args().nth(1).unwrap_or_else(|| "examples/scheme-ii-3.yaml".to_owned());
    let document = Document::parse_one(&name, &std::fs::read(&name)?)?;
    let subject = one(&document, &Choice::default())?;
    for gear in subject.train.gears() {
        let name = gear.name();
        let result = subject.train.analyze(name)?;
        println!("{name}: i = {:.4?}, efficiency {:.4?}", result.ratio(), result.efficiency());
    }
    Ok(())
}

//! Whether a gearbox of two sets can be built without a link across another.

use epicyclic_layout::{Options, Verdict, draw};
use epicyclic_train::Gearbox;
use epicyclic_train::set::SetSpec;

fn main() -> Result<(), epicyclic_train::Error> {
    let gearbox = Gearbox::builder("shut in")
        .links(["D", "B", "T1", "T2"])
        .set(SetSpec::simple("1", ["D", "B", "T1"], 2.5))
        .set(SetSpec::simple("2", ["D", "B", "T2"], 2.5))
        .brake("K1", "T1")
        .brake("K2", "T2")
        .input("D")
        .output("B")
        .build()?;
    match draw(&gearbox, Options::default()) {
        Verdict::Drawable(layout) => println!("can be drawn, {} crossings", layout.crossings().len()),
        Verdict::SelfCrossing(witness) => println!("{}", witness.describe(&gearbox)),
    }
    Ok(())
}

//! The gears of a gearbox of two sets, with their ratios and efficiencies.

use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_train::Gearbox;
use epicyclic_train::set::{MeshLoss, SetSpec};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let loss = MeshLoss::Set(MeshEfficiency::new(0.97)?);
    let gearbox = Gearbox::builder("II-3")
        .links(["D", "B", "T1", "T2"])
        .set(SetSpec::simple("1", ["T1", "D", "B"], 2.15).with_loss(loss))
        .set(SetSpec::simple("2", ["T1", "B", "T2"], 2.354).with_loss(loss))
        .brake("K1", "T1")
        .brake("K2", "T2")
        .input("D")
        .output("B")
        .gear("1", ["K1"])
        .gear("2", ["K2"])
        .build()?;
    for name in ["1", "2"] {
        let gear = gearbox.analyze(name)?;
        println!("{name}: i = {:.4?}, efficiency {:.4?}", gear.ratio(), gear.efficiency());
    }
    Ok(())
}

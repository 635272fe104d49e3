//! Every gearbox of two sets that has the ratios of a four-speed automatic.

use epicyclic_synthesis::gearbox::element_name;
use epicyclic_synthesis::parts::Bounds;
use epicyclic_synthesis::run::{Share, search};
use epicyclic_synthesis::wish::Wish;
use epicyclic_synthesis::{Class, Kind};
use std::ops::ControlFlow;

fn main() -> Result<(), epicyclic_synthesis::Error> {
    let within = |ratio: f64| Bounds { least: ratio - 0.01 * ratio.abs(), most: ratio + 0.01 * ratio.abs() };
    let gears = [3.059, 1.625, 1.0, 0.696, -2.294].map(within).into();
    let wish = Wish::new(gears, 5, vec![1.4..=4.5; 2]);
    let class = Class::new(Kind::AllSparse, 2, 5)?;
    let answer = search(class, &wish, Share::WHOLE, &|_| ControlFlow::Continue(()))?;
    for found in &answer.found {
        let names: Vec<String> = found.solution.elements.iter().map(|pairs| element_name(pairs[0])).collect();
        println!("{}  with {}", found.structure, names.join(", "));
    }
    Ok(())
}

//! A search in two shares, written as Parquet, read and merged.

use epicyclic_synthesis::asked::asked;
use epicyclic_synthesis::parts::Bounds;
use epicyclic_synthesis::run::go_on;
use epicyclic_synthesis::wish::Wish;
use epicyclic_synthesis::work::{Share, Work};
use epicyclic_synthesis::{Class, Kind};
use epicyclic_tables::{merge::merge, part::Part};
use std::ops::ControlFlow;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let gears = [2.56, 1.465].map(|ratio| Bounds { least: 0.999 * ratio, most: 1.001 * ratio });
    let wish = Wish::new(gears.into(), 2, vec![1.4..=4.5; 2]);
    let class = Class::new(Kind::Core, 2, 4)?;
    let mut parts = Vec::new();
    for number in 0..2 {
        let share = Share { number, of: 2 };
        let work = go_on(class, &wish, share, Work::default(), &|_| ControlFlow::Continue(()))?;
        let part = Part { version: "1".into(), share, searches: vec![(asked(class, &wish), work)] };
        let bytes = part.to_parquet()?;
        parts.push((format!("part {share}"), Part::from_parquet(bytes)?));
    }
    for answer in merge(&parts, "1", &[asked(class, &wish)])? {
        println!("{} structures, {} gearboxes", answer.class_size, answer.found.len());
    }
    Ok(())
}

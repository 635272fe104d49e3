//! A curve over an axis, as SVG.

use epicyclic_drawing::svg;
use epicyclic_pictures::plot::{Curve, Plot};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let ratio = (15..=50).map(|tenths| f64::from(tenths) / 10.0).map(|k| [k, 1.0 + k]).collect();
    let plot = Plot::new("Ratio of a simple set", "k", "i").with(Curve::new("sun to carrier", ratio));
    println!("{}", svg::write(&plot.scene()?)?);
    Ok(())
}

//! Tooth numbers for a ratio, as JSON.

use epicyclic_commands::answer::to_json;
use epicyclic_commands::teeth::answer as teeth;
use epicyclic_gears::simple_set::{Member, Mode};
use epicyclic_gears::synthesis::Bounds;

fn main() -> Result<(), epicyclic_commands::error::Error> {
    let mode = Mode::new(Member::Sun, Member::Carrier)?;
    let wanted =
        teeth::Wanted { ratio: 6.0, mode, tolerance: 0.01, bounds: Bounds::default(), most: 1, checked: 1 };
    println!("{}", to_json(&teeth::answer(&wanted, |_| std::ops::ControlFlow::Continue(()))?)?);
    Ok(())
}

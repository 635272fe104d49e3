//! Tooth numbers for a ratio, as a table.

use epicyclic_commands::table::report::AsReport;
use epicyclic_commands::teeth::answer as teeth;
use epicyclic_gears::simple_set::{Member, Mode};
use epicyclic_gears::synthesis::Bounds;

fn main() -> Result<(), epicyclic_commands::error::Error> {
    let mode = Mode::new(Member::Sun, Member::Carrier)?;
    let wanted =
        teeth::Wanted { ratio: 6.0, mode, tolerance: 0.01, bounds: Bounds::default(), most: 3, checked: 1 };
    println!("{}", teeth::answer(&wanted, |_| std::ops::ControlFlow::Continue(()))?.report().table(80));
    Ok(())
}

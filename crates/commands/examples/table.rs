//! Tooth numbers for a ratio, as a table.

use epicyclic_commands::table::report::AsReport;
use epicyclic_commands::teeth::request::Request;
use epicyclic_units::Number;
use std::ops::ControlFlow;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let request = Request { limit: Some(3), ..Request::new(Number::new(6.0)?) };
    let found = request.answer(|_| ControlFlow::Continue(()))?;
    println!("{}", found.report().table(80));
    Ok(())
}

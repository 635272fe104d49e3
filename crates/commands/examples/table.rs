//! Tooth numbers for a ratio, as a table.

use epicyclic_commands::table::report::AsReport;
use epicyclic_commands::teeth::Request;
use epicyclic_commands::words::request;
use std::ops::ControlFlow;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let request = Request { limit: Some(3), ..request(["--ratio", "6"])? };
    let found = request.answer(|_| ControlFlow::Continue(()))?;
    println!("{}", found.report().table(80));
    Ok(())
}

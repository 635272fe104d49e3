//! Tooth numbers for a ratio, as JSON.

use epicyclic_commands::answer::to_json;
use epicyclic_commands::teeth::Request;
use epicyclic_commands::words::request;
use std::ops::ControlFlow;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let request = Request { limit: Some(1), ..request(["--ratio", "6"])? };
    let found = request.answer(|_| ControlFlow::Continue(()))?;
    println!("{}", to_json(&found)?);
    Ok(())
}

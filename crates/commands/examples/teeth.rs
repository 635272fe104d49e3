//! Tooth numbers for a ratio, as JSON.

use epicyclic_commands::answer::to_json;
use epicyclic_commands::teeth::request::Request;
use epicyclic_units::Number;
use std::ops::ControlFlow;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let request = Request { limit: Some(1), ..Request::new(Number::new(6.0)?) };
    let found = request.answer(|_| ControlFlow::Continue(()))?;
    println!("{}", to_json(&found)?);
    Ok(())
}

//! Answers of a hydromotor file, at rest and as the motor turns.

use crate::documents;
use crate::reply::{Failure, json, object, refused, text};
use epicyclic_commands::motor::answer as motor;
use epicyclic_commands::motor::answer::{Designed, of_file};
use epicyclic_commands::table::report::AsReport as _;

fn designed(file: &str) -> Result<Designed, Failure> {
    Ok(of_file(&*documents::of("motor.yaml", file)?).map_err(refused)?.1)
}

/// The answer, what the motor is chosen by, and its tables.
pub(crate) fn look(file: &str) -> Result<String, Failure> {
    let answer = motor::answer(&designed(file)?).map_err(refused)?;
    let key = epicyclic_commands::motor::table::key(&answer);
    let key = serde_json::to_string(&key).unwrap_or_default();
    Ok(object(&[("motor", json(&answer)?), ("key", key), ("tables", text(&answer.report().html()))]))
}

/// The motor as it turns.
pub(crate) fn moving(file: &str, frames: u32) -> Result<String, Failure> {
    json(&motor::moving(&designed(file)?, frames).map_err(refused)?)
}

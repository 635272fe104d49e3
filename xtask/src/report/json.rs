//! Outcomes for programs.

use crate::cases::run::Outcome;
use serde::Serialize;

#[derive(Serialize)]
struct Report<'a> {
    holds: bool,
    sources: &'a [Outcome],
}

/// One JSON object: `holds`, and per source every figure, place and fault.
///
/// # Errors
/// None in practice: the outcome holds nothing that JSON lacks.
pub fn render(outcomes: &[Outcome]) -> Result<String, String> {
    let report = Report { holds: outcomes.iter().all(Outcome::holds), sources: outcomes };
    let mut text = serde_json::to_string_pretty(&report).map_err(|error| error.to_string())?;
    text.push('\n');
    Ok(text)
}

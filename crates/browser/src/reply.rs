//! Replies to the app: JSON of answers, or of the error.

use epicyclic_commands::answer::Answer;
use epicyclic_commands::answer::to_json;
use epicyclic_commands::error::Error;
use epicyclic_commands::failure::WRONG;
use epicyclic_commands::refused::Refused;

/// Error returned instead of an answer.
pub(crate) type Failure = Box<Refused>;

/// The reply, or the refusal as the program writes it.
pub(crate) fn told(reply: Result<String, Failure>) -> String {
    reply.unwrap_or_else(|refused| to_json(&*refused).unwrap_or_default())
}

/// JSON of an answer.
pub(crate) fn json<A: Answer>(answer: &A) -> Result<String, Failure> {
    to_json(answer).map_err(refused)
}

/// A JSON object of parts that are JSON.
pub(crate) fn object(parts: &[(&str, String)]) -> String {
    let parts: Vec<String> = parts.iter().map(|(key, value)| format!("{}:{value}", text(key))).collect();
    format!("{{{}}}", parts.join(","))
}

/// A text in JSON.
pub(crate) fn text(text: &str) -> String {
    serde_json::to_string(text).unwrap_or_default()
}

/// A refusal of the answers.
#[allow(clippy::needless_pass_by_value)] // `map_err` hands it over.
pub(crate) fn refused(error: Error) -> Failure {
    Box::new(Refused::of_answer(&error, WRONG))
}

/// A refusal in words of its own.
pub(crate) fn refuse(name: &'static str, message: impl Into<String>) -> Failure {
    Box::new(Refused::new(name, message.into(), WRONG))
}

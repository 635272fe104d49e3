//! Interface between the app in a browser and the libraries.
//!
//! | module | answers |
//! |---|---|
//! | `documents` | the parsed file of the last question |
//! | `gearbox` | answers, tables and pictures of a gearbox file and a gear |
//! | `layouts` | layouts of schemes, computed once for each structure |
//! | `motor` | a hydromotor, at rest and as it turns |
//! | `reply` | the reply: JSON of answers, or the error |
//!
//! Questions and replies are texts in JSON. The answers within are those of the program, key by key.

mod documents;
mod gearbox;
mod layouts;
mod motor;
mod reply;

use epicyclic_commands::answer::schema;
use reply::object;
use wasm_bindgen::prelude::wasm_bindgen;

/// A gearbox as its file, a gear and an input make it.
#[wasm_bindgen]
#[must_use]
pub fn look(file: &str, question: &str) -> String {
    reply::told(gearbox::look(file, question))
}

/// The sets of a gearbox from the front, in a gear or at rest.
#[wasm_bindgen]
#[must_use]
pub fn front(file: &str, question: &str) -> String {
    reply::told(gearbox::front(file, question))
}

/// Answers of `look` with other numbers at places that it has named, and the text of the changed file.
#[wasm_bindgen]
#[must_use]
pub fn adjusted(file: &str, question: &str, changes: &str) -> String {
    reply::told(gearbox::adjusted(file, question, changes))
}

/// The file of a scheme of the catalogue with these `k`.
#[wasm_bindgen]
#[must_use]
pub fn scheme(name: &str, k1: f64, k2: f64) -> String {
    reply::told(gearbox::scheme(name, k1, k2))
}

/// A hydromotor as its file describes it.
#[wasm_bindgen]
#[must_use]
pub fn motor(file: &str) -> String {
    reply::told(motor::look(file))
}

/// Hydromotor of a file as it turns: `frames` pictures over one lobe of its rotor.
#[wasm_bindgen]
#[must_use]
pub fn moving(file: &str, frames: u32) -> String {
    reply::told(motor::moving(file, frames))
}

/// JSON Schemas of the answers, by name: the types of the app are made from them.
#[wasm_bindgen]
#[must_use]
pub fn schemas() -> String {
    use epicyclic_commands as of;
    let all = [
        ("analyze", schema::<of::analyze::answer::overview::Overview>()),
        ("analyze-gear", schema::<of::analyze::answer::gear::OneGear>()),
        ("analyze-inputs", schema::<of::analyze::answer::inputs::Inputs>()),
        ("transmissions", schema::<of::shared::transmissions::answer::Transmissions>()),
        ("adjust", schema::<of::adjust::Adjustable>()),
        ("front", schema::<of::front::Front>()),
        ("motor", schema::<of::motor::answer::Motor>()),
        ("motor-moving", schema::<of::motor::answer::Moving>()),
        ("select", schema::<of::select::answer::Select>()),
        ("schemes", schema::<of::schemes::answer::Schemes>()),
        ("error", schema::<of::refused::Refused>()),
    ];
    let parts: Vec<_> =
        all.iter().map(|(name, schema)| (*name, serde_json::to_string(schema).unwrap_or_default())).collect();
    object(&parts)
}

//! Request of a search, as text: two searches have the same request if the texts are equal, and then they
//! find the same.
//!
//! Numbers are written with enough digits to distinguish them from every other, so that equal texts are equal
//! numbers, bit by bit.

use crate::class::Class;
use crate::rules::Rules;
use crate::wish::Wish;

/// Request of a search: names and values.
pub type Asked = Vec<(String, String)>;

/// Returns the request of a search through a class for a wish.
#[must_use]
pub fn asked(class: Class, wish: &Wish) -> Asked {
    // Field by field, so that a new one is not forgotten.
    let Wish { gears, elements, k, double_planets, equal_k, side_by_side, rules } = wish;
    let Rules { brakes, clutches, shifts, direct } = rules;
    let gears = gears.iter().map(|gear| format!("{}..{}", gear.least, gear.most));
    let ranges = k.iter().map(|range| format!("{}..{}", range.start(), range.end()));
    let text = |parts: &mut dyn Iterator<Item = String>| parts.collect::<Vec<_>>().join(", ");
    [
        ("class", class.to_string()),
        ("gears", text(&mut gears.into_iter())),
        ("shift elements", elements.to_string()),
        ("k", text(&mut ranges.into_iter())),
        ("double-planet sets", double_planets.to_string()),
        ("equal k", equal_k.to_string()),
        ("gears side by side", format!("{side_by_side:?}")),
        ("brakes", format!("{brakes:?}")),
        ("clutches", format!("{clutches:?}")),
        ("shifts", format!("{shifts:?}")),
        ("direct gear", direct.to_string()),
    ]
    .map(|(name, value)| (name.to_owned(), value))
    .into()
}

//! The index of a source: its numbered equations, tables and worked figures, and whether a case
//! covers each.

use schemars::JsonSchema;
use serde::Deserialize;

/// Name of the index file in a source's folder.
pub const FILE: &str = "index.yaml";

/// The index of a source.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Index {
    /// Name of the source, equal to that of its folder.
    pub source: String,
    /// Title of the source.
    pub title: String,
    /// Places that cases can cite.
    pub places: Vec<Place>,
}

/// A place in a source.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Place {
    /// Name of the place, as cases cite it: `(3)`, `table 2.2`, `§3.3`. No commas.
    pub place: String,
    /// Content of the place.
    pub what: String,
    /// Whether the content is a restored reading, which the document as received does not print.
    #[serde(default)]
    pub reconstructed: bool,
    /// Reason why no case covers the place.
    #[serde(default)]
    pub excused: Option<String>,
}

impl Index {
    /// Whether a place has a restored reading instead of a print.
    #[must_use]
    pub fn restores(&self, place: &str) -> bool {
        self.places.iter().any(|known| known.place == place && known.reconstructed)
    }
}

/// The places that a citation names.
pub fn places(cite: &str) -> impl Iterator<Item = &str> {
    cite.split(',').map(str::trim)
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_citation_lists_places_by_commas() {
        assert!(super::places("§3.3, table 3.1").eq(["§3.3", "table 3.1"]));
    }
}

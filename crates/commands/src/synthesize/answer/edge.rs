//! Ends of a range that a value reaches.

use crate::tolerance::AT_EDGE;
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::RangeInclusive;

/// Ends of a range.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Edge {
    /// Lower end.
    Lower,
    /// Upper end.
    Upper,
}

impl Edge {
    /// End of a range at which a value lies; `None` inside.
    pub(super) fn of(value: f64, range: &RangeInclusive<f64>) -> Option<Self> {
        let near = |end: f64| (value - end).abs() <= AT_EDGE * end;
        let ends = [(*range.start(), Self::Lower), (*range.end(), Self::Upper)];
        ends.into_iter().find(|(end, _)| near(*end)).map(|(_, edge)| edge)
    }
}

//! How much a miss weighs.

/// Severity of a check that does not hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "Severity"))]
pub enum Severity {
    /// Remark that is worth knowing.
    Remark,
    /// Warning: an engineer would return the design or justify the value.
    Warning,
    /// Error: the gears cannot be cut, assembled or turned, or do not meet what is required.
    Error,
}

impl Severity {
    /// The severities, the mildest first.
    pub const ALL: [Self; 3] = [Self::Remark, Self::Warning, Self::Error];
}

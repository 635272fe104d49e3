//! Kinds of structures that a class contains.

/// Kind of structures that a class contains.
///
/// Structures of both kinds are *sparse*: any `m` sets touch at least `m + 2` links, the housing among them.
/// This leaves out sets that are locked, two sets on the same three links, and sets that are locked to the
/// housing. In both kinds every link but the input and the output is on a member: a link between two shift
/// elements alone would put them in series.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema, clap::ValueEnum))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "ClassName"))]
pub enum Kind {
    /// No member on the housing, input and output on members, all sets joined.
    Core,
    /// Members may be on the housing, and shift elements alone may reach input or output.
    AllSparse,
}

impl Kind {
    /// Name of the kind: `core` or `all sparse`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Core => "core",
            Self::AllSparse => "all sparse",
        }
    }
}

//! A link of a gearbox, and the name of the housing.

/// Name of the housing wherever a link is named.
pub const GROUND: &str = "ground";

/// A link of one gearbox: members that turn as one piece.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LinkId(pub(crate) usize);

impl LinkId {
    /// The housing, at rest.
    pub const GROUND: Self = Self(0);

    /// Place of the link in tables of results: 0 is the housing, the others follow in the order in
    /// which they were named.
    #[must_use]
    pub fn index(self) -> usize {
        self.0
    }
}

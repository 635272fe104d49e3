//! External and internal gears.

use std::fmt;

/// Side of the pitch circle on which the teeth are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum GearKind {
    /// Teeth point away from the axis: sun, planet.
    External,
    /// Teeth point to the axis: ring.
    Internal,
}

impl fmt::Display for GearKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::External => "external",
            Self::Internal => "internal",
        })
    }
}

//! Parts of a drive by name.

use std::fmt;

/// A shaft of the drive.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Shaft {
    /// The sun's.
    Sun,
    /// A planet's pin.
    Planet,
    /// The carrier's.
    Carrier,
}

impl fmt::Display for Shaft {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Sun => "sun's shaft",
            Self::Planet => "planet's pin",
            Self::Carrier => "carrier's shaft",
        })
    }
}

/// A gear of the drive with a bore.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BoredGear {
    /// The sun.
    Sun,
    /// A planet.
    Planet,
}

impl fmt::Display for BoredGear {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Sun => "sun",
            Self::Planet => "planet",
        })
    }
}

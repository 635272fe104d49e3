//! Sites of faults in the description of a gearbox: an entry by its index, and the part of it that is wrong.

use crate::error::{Error, Terminal};

/// A fault of a description with its site.
#[derive(Debug, Clone, PartialEq)]
pub struct Located {
    /// The fault.
    pub error: Error,
    /// Site of the fault.
    pub site: Site,
}

/// Entry of a [`GearboxBuilder`](crate::GearboxBuilder). Indices count the entries of one kind from 0 in the
/// order in which they were added.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Site {
    /// The gearbox as a whole.
    Gearbox,
    /// A terminal of the gearbox.
    Terminal(Terminal),
    /// A link.
    Link(usize),
    /// A set.
    Set(usize, SetPart),
    /// A shift element, and which of its two links.
    ShiftElement(usize, Option<usize>),
    /// A permanent connection, and which of its two links.
    Connection(usize, Option<usize>),
    /// A gear.
    Gear(usize, GearPart),
}

/// Part of the description of a set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SetPart {
    /// The set as a whole.
    Whole,
    /// Basic ratio, or the tooth numbers that give it.
    BasicRatio,
    /// Number of planets.
    PlanetCount,
    /// Spacing of the planets.
    Spacing,
    /// The carrier.
    Carrier,
    /// A central gear or planet shaft.
    Central(usize),
    /// A planet.
    Planet(usize),
    /// A gear of a planet: indices of the planet and of its gear.
    PlanetGear(usize, usize),
    /// A mesh.
    Mesh(usize),
    /// A gear of a mesh: index of the mesh, and 0 or 1.
    MeshGear(usize, usize),
}

/// Part of the description of a gear.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GearPart {
    /// The gear as a whole.
    Whole,
    /// An engaged shift element.
    Engaged(usize),
    /// A terminal of the gear.
    Terminal(Terminal),
}

/// Faults of one set.
pub(crate) type SetFaults = Vec<(SetPart, Error)>;

impl Site {
    /// Fault of this site.
    pub(crate) fn has(self, error: Error) -> Located {
        Located { error, site: self }
    }
}

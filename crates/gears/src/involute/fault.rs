//! Faults of a profile shift that gives no gear, and of a tool that cuts none.

use std::fmt;

/// Reason why a shift gives no gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ShiftFault {
    /// The shift or tip alteration is not a finite number.
    NotFinite,
    /// A root or tip circle of radius 0 or less.
    NoCircle,
    /// Tips at or below the roots.
    NoTooth,
    /// The flanks meet before the tip circle.
    Pointed {
        /// Normal thickness at the tip circle, modules: 0 or less.
        tip_thickness: f64,
    },
}

/// Reason why a tool does not cut a gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ToolFault {
    /// A shaper with as many teeth as the ring, or more.
    TooManyTeeth {
        /// Teeth of the shaper.
        cutter: u32,
        /// Teeth of the ring.
        ring: u32,
    },
    /// Shifts of cutter and gear for which there is no working angle.
    NoMesh {
        /// Sum of the shifts.
        sum: f64,
    },
    /// A shaper whose tips have no room for their corners, or are pointed.
    Corners {
        /// Radius of the corners.
        radius: f64,
        /// The largest that there is room for; below 0 of a cutter whose flanks meet below its tips.
        most: f64,
        /// Addendum of the shaper.
        addendum: f64,
    },
    /// A form tool whose fillets have no room between the flanks.
    Fillets {
        /// Radius of the fillets.
        radius: f64,
    },
}

impl fmt::Display for ToolFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooManyTeeth { cutter, ring } => {
                write!(
                    f,
                    "a shaper of {cutter} teeth does not fit into a ring of {ring}; a shaper with fewer teeth is needed"
                )
            }
            Self::NoMesh { sum } => {
                write!(
                    f,
                    "the shaper does not mesh with the gear: their shifts sum to {sum:.4}; another shift is needed"
                )
            }
            Self::Corners { radius, most, addendum } if *most < 0.0 => write!(
                f,
                "a shaper with an addendum of {addendum:.4} modules and corners of {radius} has pointed teeth; a lower addendum is needed"
            ),
            Self::Corners { radius, most, addendum } => write!(
                f,
                "the tips of a shaper with an addendum of {addendum:.4} modules have room for corners of {most:.3} modules at most, not of {radius}"
            ),
            Self::Fillets { radius } => {
                write!(f, "fillets of {radius} modules have no room at the root; smaller ones are needed")
            }
        }
    }
}

//! Why a profile shift gives no gear, and why gears with shifts make no set.

use crate::quantity::SimpleGear;
use std::fmt;

/// Why a shift gives no gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ShiftFault {
    /// It is no number.
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

/// A mesh of a simple set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SetMesh {
    /// Of sun and planets.
    SunPlanet,
    /// Of planets and ring.
    PlanetRing,
}

impl fmt::Display for SetMesh {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::SunPlanet => "sun–planet",
            Self::PlanetRing => "planet–ring",
        })
    }
}

/// Why the gears of a set do not run together; lengths in modules.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum SetFault {
    /// The rack cuts into the involute.
    Undercut {
        /// The gear.
        gear: SimpleGear,
        /// Its profile shift.
        shift: f64,
        /// The least without undercut.
        least: f64,
    },
    /// A tip is too thin, along the normal.
    TipThickness {
        /// The gear.
        gear: SimpleGear,
        /// Its thickness.
        thickness: f64,
        /// The least allowed.
        least: f64,
    },
    /// Too little contact.
    ContactRatio {
        /// The mesh.
        mesh: SetMesh,
        /// Its transverse contact ratio.
        ratio: f64,
        /// The least allowed.
        least: f64,
    },
    /// A tip is too near to the root of its mate.
    TipClearance {
        /// The gear whose tip it is.
        gear: SimpleGear,
        /// The mesh.
        mesh: SetMesh,
        /// The clearance; below 0 it bites into the root.
        clearance: f64,
        /// The least allowed.
        least: f64,
    },
    /// The teeth are thicker than the pitch at this centre distance.
    Pressed {
        /// The mesh.
        mesh: SetMesh,
        /// Backlash at the working circles, below 0.
        backlash: f64,
    },
    /// A tip reaches below the base circle of its mate, where there is no involute.
    Involute {
        /// The gear whose tip it is.
        gear: SimpleGear,
        /// The mesh.
        mesh: SetMesh,
        /// Radius of curvature of the mate's flank there, below 0.
        radius: f64,
    },
    /// A tip reaches into the fillet of its mate.
    Fillet {
        /// The gear whose tip it is.
        gear: SimpleGear,
        /// The mesh.
        mesh: SetMesh,
        /// By how much the radius of curvature of the mate's flank there is less than where its involute ends.
        by: f64,
    },
    /// The tips of planet and ring meet outside the mesh.
    Trochoidal {
        /// Angle of the ring by which they overlap, rad.
        by_rad: f64,
    },
    /// The planets cannot be put into the ring radially.
    Trimming {
        /// Angle of the planet by which tips overlap, rad; infinite where the ring's tips reach within its base circle.
        by_rad: f64,
    },
    /// Neighbouring planets touch, or nearly.
    Planets {
        /// Number of planets.
        planets: u32,
        /// Gap between their tip circles.
        gap: f64,
        /// The least allowed.
        least: f64,
    },
}

impl fmt::Display for SetFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Undercut { gear, shift, least } => {
                write!(f, "the rack undercuts the {gear}: x = {shift:.4}, at least {least:.4} needed")
            }
            Self::TipThickness { gear, thickness, least } => {
                write!(f, "the tips of the {gear} are {thickness:.3} modules thick, at least {least} needed")
            }
            Self::ContactRatio { mesh, ratio, least } => {
                write!(f, "contact ratio of the {mesh} mesh {ratio:.3}, at least {least} needed")
            }
            Self::TipClearance { gear, mesh, clearance, least } => write!(
                f,
                "the tips of the {gear} clear the roots of the {mesh} mesh by {clearance:.3} modules, at least {least} needed"
            ),
            Self::Pressed { mesh, backlash } => write!(
                f,
                "the flanks of the {mesh} mesh press into each other: backlash {backlash:.4} modules, at least 0 needed"
            ),
            Self::Involute { gear, mesh, radius } => write!(
                f,
                "the tips of the {gear} reach below the base circle of the mate in the {mesh} mesh: radius of curvature {radius:.3} \
                 modules, at least 0 needed"
            ),
            Self::Fillet { gear, mesh, by } => write!(
                f,
                "the tips of the {gear} reach into the fillets of the mate in the {mesh} mesh, by {by:.3} modules of radius of \
                 curvature, at most 0 allowed"
            ),
            Self::Trochoidal { by_rad } => {
                write!(
                    f,
                    "the tips of planet and ring overlap outside the mesh by {:.3}° of the ring",
                    by_rad.to_degrees()
                )
            }
            Self::Trimming { by_rad } => {
                write!(
                    f,
                    "the planets do not enter the ring radially: tips overlap by {:.3}° of the planet",
                    by_rad.to_degrees()
                )
            }
            Self::Planets { planets, gap, least } => write!(
                f,
                "the tip circles of neighbours among {planets} planets are {gap:.3} modules apart, more than {least} needed"
            ),
        }
    }
}

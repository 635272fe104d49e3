//! What does not fit in the teeth of a set, and how it is said.

use crate::planet_angles::Misplaced;
use crate::units::in_degrees;
use epicyclic_gears::involute::fault::SetFault;
use std::fmt;
use uom::si::f64::Angle;

/// A gear with its teeth, by name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NamedGear {
    /// What it is called: `sun`, `planet long.2`.
    pub name: String,
    /// Its teeth.
    pub teeth: u32,
}

/// What profile shifts of both meshes of a planet make up at the most, in modules: sums of `x` from about −0.5 to 1.5.
const MOST_SHIFT: f64 = 2.0;

/// Something about the teeth of a set that does not fit without profile shift, or needs a choice.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum ToothWarning {
    /// A simple set without planet teeth, whose sun and ring leave its planets none that are whole.
    HalfTooth {
        /// The set.
        set: String,
        /// Teeth of the sun, `z_a`.
        sun: u32,
        /// Teeth of the ring, `z_b`.
        ring: u32,
    },
    /// A ring with no more teeth than the planet in it.
    RingTooSmall {
        /// The set.
        set: String,
        /// The ring.
        ring: NamedGear,
        /// The planet's gear.
        planet: NamedGear,
    },
    /// A ring with so few teeth more than the planet in it that their tips meet after they have left the mesh.
    TipsMeet {
        /// The set.
        set: String,
        /// The ring.
        ring: NamedGear,
        /// The planet's gear.
        planet: NamedGear,
        /// The fewest teeth of a ring whose tips are free; `None` where none near it are.
        least: Option<u32>,
    },
    /// Two central gears that ask one gear of a planet for different radii.
    UnequalCentreDistances {
        /// The set.
        set: String,
        /// The planet's gear.
        planet: NamedGear,
        /// The central gears.
        centrals: [NamedGear; 2],
        /// Centre distance to each, `R/m`, in modules.
        distances: [f64; 2],
    },
    /// Two planets in mesh that cannot stand at their radii.
    NoTriangle {
        /// The set.
        set: String,
        /// The planets.
        planets: [String; 2],
        /// Radii of their centres, in modules of their mesh.
        radii: [f64; 2],
        /// Distance of their centres, in modules.
        distance: f64,
    },
    /// Planets that overlap their neighbours.
    PlanetsOverlap {
        /// The set.
        set: String,
        /// The gears that overlap: of one kind of planet, or of two.
        gears: [String; 2],
        /// How many of each there are.
        planets: u32,
        /// By how much the tip circles overlap, in modules; 0 where they touch.
        overlap: f64,
        /// The largest number of each that clears at equal angles; `None` where not even two do, and of planets at other angles.
        most: Option<u32>,
        /// Whether they are at equal angles.
        is_equal: bool,
    },
    /// Planets at equal angles that cannot be assembled.
    Assembly {
        /// The set.
        set: String,
        /// How many of each there are.
        planets: u32,
        /// What their number must divide, `G`.
        slots: u64,
        /// The next smaller number that assembles, from 2 on.
        fewer: Option<u32>,
        /// The next larger number that assembles and clears.
        more: Option<u32>,
    },
    /// A planet at a given angle at which it cannot be put in.
    Misplaced {
        /// The set.
        set: String,
        /// The planet and the angle.
        at: Misplaced,
    },
    /// External gears with so few teeth that a rack undercuts them.
    Undercut {
        /// The set.
        set: String,
        /// The gears.
        gears: Vec<NamedGear>,
        /// The fewest teeth that are not undercut.
        least: u32,
    },
    /// A set with profile shift whose gears do not run together.
    ShiftFault {
        /// The set.
        set: String,
        /// What is wrong.
        fault: SetFault,
    },
    /// Shifts that leave a set no teeth or no mesh.
    ShiftsRefused {
        /// The set.
        set: String,
        /// What is wrong.
        error: epicyclic_gears::Error,
    },
    /// Two gears not in mesh whose tip circles overlap: they cannot lie in one plane.
    DifferentPlanes {
        /// The set.
        set: String,
        /// The gears.
        gears: [String; 2],
    },
}

impl ToothWarning {
    /// The set it is about.
    #[must_use]
    pub fn set(&self) -> &str {
        match self {
            Self::HalfTooth { set, .. }
            | Self::RingTooSmall { set, .. }
            | Self::TipsMeet { set, .. }
            | Self::UnequalCentreDistances { set, .. }
            | Self::NoTriangle { set, .. }
            | Self::PlanetsOverlap { set, .. }
            | Self::Assembly { set, .. }
            | Self::Misplaced { set, .. }
            | Self::Undercut { set, .. }
            | Self::ShiftFault { set, .. }
            | Self::ShiftsRefused { set, .. }
            | Self::DifferentPlanes { set, .. } => set,
        }
    }

    /// Whether it only tells how the gears must be arranged: usual in some sets, and no fault.
    #[must_use]
    pub fn is_note(&self) -> bool {
        matches!(self, Self::DifferentPlanes { .. })
    }
}

impl fmt::Display for NamedGear {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({})", self.name, teeth(self.teeth))
    }
}

/// An angle as messages show it, to a ten-thousandth of a degree.
fn rounded_degrees(angle: Angle) -> f64 {
    const TEN_THOUSANDTHS: f64 = 1e4;
    (in_degrees(angle) * TEN_THOUSANDTHS).round() / TEN_THOUSANDTHS
}

fn teeth(count: u32) -> String {
    if count == 1 { "1 tooth".to_owned() } else { format!("{count} teeth") }
}

impl fmt::Display for ToothWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "set `{}`: ", self.set())?;
        match self {
            Self::HalfTooth { sun, ring, .. } => write!(
                f,
                "{sun} and {ring} teeth of sun and ring leave the planets (z_b − z_a)/2 = {} teeth: a whole number \
                 needs shifted profiles",
                (f64::from(*ring) - f64::from(*sun)) / 2.0
            ),
            Self::RingTooSmall { ring, planet, .. } => {
                write!(f, "{ring} is not larger than the {planet} in it")
            }
            Self::TipsMeet { ring, planet, least, .. } => {
                write!(f, "tips of {planet} and {ring} meet outside the mesh without profile shift")?;
                match least {
                    Some(least) => write!(f, "; from {least} teeth of the ring on they are free"),
                    None => Ok(()),
                }
            }
            Self::UnequalCentreDistances { planet, centrals: [one, other], distances, .. } => {
                write!(
                    f,
                    "{planet} is {} modules from the axis by the {one} and {} by the {other}: ",
                    distances[0], distances[1]
                )?;
                let apart = (distances[0] - distances[1]).abs();
                if apart <= MOST_SHIFT {
                    f.write_str("equal centre distances need shifted profiles")
                } else {
                    write!(f, "no profile shift makes up {apart} modules; take other teeth")
                }
            }
            Self::NoTriangle { planets: [one, other], radii, distance, .. } => write!(
                f,
                "{one} and {other} cannot mesh: their centres, {:.4} and {:.4} modules from the axis, cannot stand \
                 {:.4} modules apart",
                radii[0], radii[1], distance
            ),
            Self::PlanetsOverlap { gears: [one, other], planets, overlap, most, is_equal, .. } => {
                match one == other {
                    true => write!(
                        f,
                        "{planets} planets do not clear each other: tip circles of neighbours ({one})"
                    )?,
                    false => write!(
                        f,
                        "{planets} planets of each kind do not clear: tip circles of {one} and the next {other}"
                    )?,
                }
                if *overlap > 0.0 {
                    write!(f, " overlap by {overlap:.3} modules; ")?;
                } else {
                    f.write_str(" touch; ")?;
                }
                match most {
                    Some(most) => write!(f, "at most {most} clear"),
                    None if *is_equal => f.write_str("not even 2 clear"),
                    None => f.write_str("give the planets larger angles from each other"),
                }
            }
            Self::ShiftFault { fault, .. } => fault.fmt(f),
            Self::ShiftsRefused { error, .. } => error.fmt(f),
            Self::Assembly { planets, slots, fewer, more, .. } => {
                write!(
                    f,
                    "{planets} planets cannot be assembled at equal angles: their number must divide {slots}"
                )?;
                match (fewer, more) {
                    (Some(fewer), Some(more)) => write!(f, "; {fewer} or {more} would do"),
                    (Some(one), None) | (None, Some(one)) => write!(f, "; {one} would do"),
                    (None, None) => Ok(()),
                }
            }
            Self::Misplaced { at: Misplaced { planet, angle, nearest, positions }, .. } => {
                let [angle, nearest] = [angle, nearest].map(|angle| rounded_degrees(*angle));
                write!(
                    f,
                    "planet {planet} cannot be assembled at {angle} deg from the first: its teeth fit at multiples of 360/{positions} deg, \
                     the nearest {nearest} deg"
                )
            }
            Self::Undercut { gears, least, .. } => {
                let gears: Vec<String> = gears.iter().map(NamedGear::to_string).collect();
                write!(f, "undercut without profile shift, below {}: {}", teeth(*least), gears.join(", "))
            }
            Self::DifferentPlanes { gears: [one, other], .. } => {
                write!(f, "{one} and {other} must lie in different planes: their tip circles overlap")
            }
        }
    }
}

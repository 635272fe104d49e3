//! Misfits in the teeth of a set, and their wording.

use crate::planet_angles::Misplaced;
use epicyclic_gears::involute::check::Severity;
use epicyclic_units::Physical;
use std::fmt;
use uom::si::f64::Angle;

/// A gear with its teeth, by name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct NamedGear {
    /// Name of the gear: `sun`, `planet long.2`.
    pub(super) name: String,
    /// Number of teeth.
    pub(super) teeth: u32,
}

/// Largest difference of centre distances that profile shifts of both meshes of a planet can make up, in
/// modules: sums of `x` from about −0.5 to 1.5.
const MOST_SHIFT: f64 = 2.0;

/// Something about the teeth of a set that does not fit without profile shift, or needs a choice.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum ToothWarning {
    /// A simple set without planet teeth, whose sun and ring leave its planets none that are whole.
    HalfTooth {
        /// Teeth of the sun, `z_a`.
        sun: u32,
        /// Teeth of the ring, `z_b`.
        ring: u32,
    },
    /// A ring with no more teeth than the planet in it.
    RingTooSmall {
        /// The ring.
        ring: NamedGear,
        /// The planet's gear.
        planet: NamedGear,
    },
    /// Two central gears that ask one gear of a planet for different radii.
    UnequalCentreDistances {
        /// The planet's gear.
        planet: NamedGear,
        /// The central gears.
        centrals: [NamedGear; 2],
        /// Centre distance to each, `R/m`, in modules.
        distances: [f64; 2],
    },
    /// Two planets in mesh that do not fit at their radii.
    NoTriangle {
        /// The planets.
        planets: [String; 2],
        /// Radii of their centres, in modules of their mesh.
        radii: [f64; 2],
        /// Distance of their centres, in modules.
        distance: f64,
    },
    /// Planets that overlap their neighbours.
    PlanetsOverlap {
        /// The gears that overlap: of one kind of planet, or of two.
        gears: [String; 2],
        /// Number of planets of each kind.
        planets: u32,
        /// Overlap of the tip circles, in modules; 0 if they touch.
        overlap: f64,
        /// The largest number of each that clears at equal angles; `None` where not even two do, and of
        /// planets at other angles.
        most: Option<u32>,
        /// Whether they are at equal angles.
        is_equal: bool,
    },
    /// Planets at equal angles that cannot be assembled.
    Assembly {
        /// Number of planets of each kind.
        planets: u32,
        /// Number of assembly positions `G`, which the number of planets must divide.
        slots: u64,
        /// The next smaller number that assembles, from 2 on.
        fewer: Option<u32>,
        /// The next larger number that assembles and clears.
        more: Option<u32>,
    },
    /// A planet at a given angle at which it cannot be put in.
    Misplaced {
        /// The planet and the angle.
        at: Misplaced,
    },
    /// Shifts that leave a set no teeth or no mesh.
    ShiftsRefused {
        /// Error from the shifts.
        error: epicyclic_gears::Error,
    },
    /// Steps of one planet whose meshes require different radii with their modules.
    StepsApart {
        /// The central gears in mesh with them.
        centrals: [NamedGear; 2],
        /// Centre distance to each, in modules of the first.
        distances: [f64; 2],
    },
    /// Steps of one planet that lie on one centre distance with one module of the second mesh alone.
    StepModule {
        /// The second step.
        step: String,
        /// The central gears in mesh with the steps.
        centrals: [NamedGear; 2],
        /// Module of the second mesh over that of the first.
        ratio: f64,
        /// Whether that of the first is stated.
        is_stated: bool,
    },
    /// A step of a planet that reaches across the main axis.
    AcrossAxis {
        /// The gear.
        gear: String,
        /// Distance across the axis, in modules.
        by: f64,
    },
    /// Two gears not in mesh whose tip circles overlap: they cannot lie in one plane.
    DifferentPlanes {
        /// The gears.
        gears: [String; 2],
        /// Gap of the tip circles, 0 or below, in modules of the first gear.
        gap: f64,
    },
}

impl ToothWarning {
    /// Severity of the warning. Gears that only must be arranged side by side, and steps whose modules are
    /// not stated, are a remark.
    pub(super) const fn severity(&self) -> Severity {
        match self {
            Self::DifferentPlanes { .. } | Self::StepModule { is_stated: false, .. } => Severity::Remark,
            Self::StepModule { .. } | Self::HalfTooth { .. } => Severity::Warning,
            // Profile shift makes up a small difference of centre distances; for more only other teeth help.
            Self::UnequalCentreDistances { distances: [one, other], .. }
            | Self::StepsApart { distances: [one, other], .. } => {
                if (*one - *other).abs() <= MOST_SHIFT {
                    Severity::Warning
                } else {
                    Severity::Error
                }
            }
            _ => Severity::Error,
        }
    }

    /// Name of the rule, value, limit, their unit, and the remedy.
    pub(super) fn figures(&self) -> (&'static str, f64, f64, &'static str, &'static str) {
        let apart = |[one, other]: &[f64; 2]| (one - other).abs();
        match self {
            Self::HalfTooth { sun, ring, .. } => {
                let planet = (f64::from(*ring) - f64::from(*sun)) / 2.0;
                ("whole-planet", planet, planet.floor(), "teeth", "state `planet_teeth` and `profile_shifts`")
            }
            Self::RingTooSmall { ring, planet, .. } => {
                let limit = f64::from(planet.teeth) + 1.0;
                ("ring-larger", f64::from(ring.teeth), limit, "teeth", "give the ring more teeth")
            }
            Self::UnequalCentreDistances { distances, .. } => (
                "centre-distance",
                apart(distances),
                0.0,
                "modules",
                "state `profile_shifts`, or take other teeth",
            ),
            Self::StepsApart { distances, .. } => {
                ("step-centre-distance", apart(distances), 0.0, "modules", "take other teeth or modules")
            }
            Self::StepModule { ratio, .. } => {
                ("step-module", *ratio, 1.0, "", "take other teeth, or this module in the second mesh")
            }
            Self::AcrossAxis { by, .. } => ("across-axis", *by, 0.0, "modules", "give the step fewer teeth"),
            Self::NoTriangle { distance, radii, .. } => (
                "planet-triangle",
                *distance,
                radii[0] + radii[1],
                "modules",
                "take other teeth of the planets",
            ),
            Self::PlanetsOverlap { overlap, .. } => {
                // The value is the gap, the negative overlap, so that it must be at least its limit.
                ("planet-gap", -overlap, 0.0, "modules", "take fewer planets")
            }
            Self::Assembly { planets, slots, .. } => {
                let left = (*slots % u64::from(*planets)) as f64;
                ("assembly", left, 0.0, "positions", "take another number of planets, or unequal angles")
            }
            Self::Misplaced { at } => {
                let apart = (at.angle - at.nearest).degrees().abs();
                ("planet-angle", apart, 0.0, "deg", "state an assembly position, or `spacing: least_unequal`")
            }
            Self::ShiftsRefused { .. } => {
                ("teeth", 0.0, 1.0, "", "change `profile_shifts` or `tip_alterations`")
            }
            Self::DifferentPlanes { gap, .. } => {
                ("planes", *gap, 0.0, "modules", "lay the gears beside each other")
            }
        }
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
    (angle.degrees() * TEN_THOUSANDTHS).round() / TEN_THOUSANDTHS
}

fn teeth(count: u32) -> String {
    if count == 1 { "1 tooth".to_owned() } else { format!("{count} teeth") }
}

/// The warning, without the name of its set.
impl fmt::Display for ToothWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
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
            Self::StepsApart { centrals: [one, other], distances, .. } => {
                let apart = (distances[0] - distances[1]).abs();
                write!(
                    f,
                    "the steps of a planet are {:.4} modules from the axis by the {one} and {:.4} by the {other}: ",
                    distances[0], distances[1]
                )?;
                if apart <= MOST_SHIFT {
                    f.write_str("equal centre distances need shifted profiles")
                } else {
                    write!(f, "no profile shift makes up {apart:.4} modules; take other teeth or modules")
                }
            }
            Self::StepModule { step, centrals: [one, other], ratio, .. } => write!(
                f,
                "the steps of a planet share a centre distance only where the mesh of {step} and {other} has {ratio:.4} times the module of the mesh with the {one}"
            ),
            Self::AcrossAxis { gear, by, .. } => {
                write!(f, "the tips of {gear} reach {by:.3} modules across the main axis")
            }
            Self::Misplaced { at: Misplaced { planet, angle, nearest, positions }, .. } => {
                let [angle, nearest] = [angle, nearest].map(|angle| rounded_degrees(*angle));
                write!(
                    f,
                    "planet {planet} cannot be assembled at {angle} deg from the first: its teeth fit at multiples of 360/{positions} deg, \
                     the nearest {nearest} deg"
                )
            }
            Self::DifferentPlanes { gears: [one, other], .. } => {
                write!(f, "{one} and {other} must lie in different planes: their tip circles overlap")
            }
        }
    }
}

//! A check of the teeth of a set: what must hold, its value, its limit, how grave a miss is, and what helps.

use crate::quantity::SimpleGear;
use crate::tolerance::{GAP, PRESSED, TOUCH};
use std::fmt;

/// A mesh of a simple set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "MeshName"))]
pub enum SetMesh {
    /// Mesh of sun and planets.
    SunPlanet,
    /// Mesh of planets and ring.
    PlanetRing,
}

impl SetMesh {
    /// Both meshes, in the order of the calculation.
    pub const BOTH: [Self; 2] = [Self::SunPlanet, Self::PlanetRing];

    /// Gears of the mesh, the first one first.
    #[must_use]
    pub const fn gears(self) -> [SimpleGear; 2] {
        match self {
            Self::SunPlanet => [SimpleGear::Sun, SimpleGear::Planet],
            Self::PlanetRing => [SimpleGear::Planet, SimpleGear::Ring],
        }
    }
}

impl fmt::Display for SetMesh {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::SunPlanet => "sun–planet",
            Self::PlanetRing => "planet–ring",
        })
    }
}

pub use epicyclic_judge::Severity;

/// Rule that a check applies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Rule {
    /// Whether the tool cuts the gear at all: 1 where it does.
    Tool,
    /// The profile shift is at least the least one without undercut.
    Undercut,
    /// Normal thickness of a tip, modules.
    TipThickness,
    /// The shaper leaves the tips of its work: radius of curvature between tip and the end of its involute,
    /// modules.
    ToolTips,
    /// Tips of shaper and ring miss each other outside their mesh: angle of the ring, rad.
    ToolTrochoidal,
    /// Tips of shaper and ring miss each other when the shaper is fed radially: angle of the shaper, rad.
    ToolFeed,
    /// Transverse contact ratio of a mesh.
    ContactRatio,
    /// Clearance between a tip and the root circle of its mate, modules.
    TipClearance,
    /// Backlash at the working circles, modules.
    Backlash,
    /// A tip stays outside the base circle of its mate: radius of curvature of the mate's flank, modules.
    #[strum(serialize = "involute-interference")]
    Involute,
    /// A tip stays out of the fillet of its mate: radius of curvature between the tip and the end of the
    /// mate's involute, modules.
    #[strum(serialize = "fillet-interference")]
    Fillet,
    /// Tips of planet and ring miss each other outside the mesh: angle of the ring, rad.
    #[strum(serialize = "trochoidal-interference")]
    Trochoidal,
    /// The planets enter the ring radially: angle of the planet, rad.
    RadialAssembly,
    /// Gap between the tip circles of neighbouring planets, modules.
    PlanetGap,
}

impl Rule {
    /// Name in output for programs.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// Severity of a failed check.
    #[must_use]
    pub const fn severity(self) -> Severity {
        match self {
            Self::RadialAssembly => Severity::Remark,
            Self::Undercut => Severity::Warning,
            _ => Severity::Error,
        }
    }

    /// Unit of value and limit, as a number with it is written; empty of a plain number.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Tool | Self::Undercut | Self::ContactRatio => "",
            Self::ToolTrochoidal | Self::ToolFeed | Self::Trochoidal | Self::RadialAssembly => "rad",
            _ => "modules",
        }
    }

    /// Remedy for a failed check, in words.
    #[must_use]
    pub const fn remedy(self) -> &'static str {
        match self {
            Self::Tool => "state another tool",
            Self::Undercut => "raise the profile shift, or take more teeth",
            Self::TipThickness => "lower the profile shift, or shorten the tips",
            Self::ToolTips => "shorten the tips, or state a shaper with more teeth or a form tool",
            Self::ToolTrochoidal | Self::ToolFeed => "state a shaper with fewer teeth or a form tool",
            Self::ContactRatio => "take more teeth, or other profile shifts",
            Self::TipClearance => "shorten the tips",
            Self::Backlash => "lower the profile shifts, or raise the centre distance",
            Self::Involute | Self::Fillet => "shorten the tips, or change the profile shifts",
            Self::Trochoidal => "shorten the tips, or give the ring more teeth",
            Self::RadialAssembly => "put the planets in along the axis",
            Self::PlanetGap => "take fewer planets, or shorten their tips",
        }
    }

    /// Amount by which a value may fall short through rounding.
    const fn slack(self) -> f64 {
        match self {
            Self::Backlash => PRESSED,
            _ => TOUCH,
        }
    }
}

/// Part of a set to which a check applies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Place {
    /// A gear.
    Gear(SimpleGear),
    /// A mesh.
    Mesh(SetMesh),
    /// The tips of a gear in a mesh.
    Tips(SimpleGear, SetMesh),
    /// Neighbouring planets of a set, by their number.
    Planets(u32),
}

/// A check: `value` must be at least `limit`, a gap between planets also above 0.
/// Of a simple set it names its gears by their kind; others have places `P` of their own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Check<P = Place> {
    /// The rule.
    pub rule: Rule,
    /// The part checked.
    pub place: P,
    /// The value.
    pub value: f64,
    /// The limit.
    pub limit: f64,
}

impl<P> Check<P> {
    /// Gives the part of the check another name.
    #[must_use]
    pub fn at<Q>(&self, place: Q) -> Check<Q> {
        let Self { rule, value, limit, .. } = *self;
        Check { rule, place, value, limit }
    }

    /// Whether the check passes.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.holds_within(1.0)
    }

    /// Whether the check passes with twice its allowance for rounding, as do gears that a search chose at a limit
    /// and a file states.
    #[must_use]
    pub fn nearly_holds(&self) -> bool {
        self.holds_within(2.0)
    }

    /// Whether the check passes with so many times its allowance for rounding.
    fn holds_within(&self, allowances: f64) -> bool {
        match self.rule {
            Rule::PlanetGap => is_clear_within(self.value, self.limit, allowances),
            rule => self.value >= self.limit - allowances * rule.slack(),
        }
    }
}

/// Whether a gap between planets is that of a limit, or more; tip circles that touch would rub.
#[must_use]
pub fn is_clear(gap: f64, limit: f64) -> bool {
    is_clear_within(gap, limit, 1.0)
}

fn is_clear_within(gap: f64, limit: f64, allowances: f64) -> bool {
    gap > 0.0 && gap >= limit - allowances * GAP
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Gear(gear) => write!(f, "the {gear}"),
            Self::Mesh(mesh) => write!(f, "the {mesh} mesh"),
            Self::Tips(gear, mesh) => write!(f, "the tips of the {gear}, {mesh} mesh,"),
            Self::Planets(planets) => write!(f, "{planets} planets"),
        }
    }
}

/// A miss in words, with its figures.
impl<P: fmt::Display> fmt::Display for Check<P> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { rule, place, value, limit } = self;
        match rule {
            Rule::Tool => write!(f, "the tool does not cut {place}"),
            Rule::Undercut => write!(f, "{place} is undercut: x = {value:.4}, at least {limit:.4} needed"),
            Rule::TipThickness => {
                write!(f, "the tips of {place} are {value:.3} modules thick, at least {limit} needed")
            }
            Rule::ToolTips => write!(
                f,
                "the shaper cuts away the tips of {place}, by {:.3} modules of radius of curvature, at most 0 allowed",
                -value
            ),
            // An infinite angle has no figure: one tip circle encloses the other, which is said in words.
            Rule::ToolTrochoidal if value.is_infinite() => {
                write!(
                    f,
                    "the tip circle of the shaper encloses that of {place}, and cuts all its teeth away"
                )
            }
            Rule::ToolTrochoidal => {
                write!(
                    f,
                    "the tips of the shaper cut into {place} outside the mesh, by {:.3}° of the ring",
                    -value.to_degrees()
                )
            }
            Rule::ToolFeed if value.is_infinite() => {
                write!(f, "the tips of {place} reach within its base circle, so that a shaper trims them")
            }
            Rule::ToolFeed => write!(
                f,
                "a shaper that is fed radially trims the tips of {place}, by {:.3}° of the shaper",
                -value.to_degrees()
            ),
            Rule::ContactRatio => write!(f, "contact ratio of {place} {value:.3}, at least {limit} needed"),
            Rule::TipClearance => {
                write!(
                    f,
                    "{place} clear the roots of the mate by {value:.3} modules, at least {limit} needed"
                )
            }
            Rule::Backlash => write!(
                f,
                "the flanks of {place} press into each other: backlash {value:.4} modules, at least {limit} needed"
            ),
            Rule::Involute => write!(
                f,
                "{place} reach below the base circle of the mate: radius of curvature {value:.3} modules, at least {limit} needed"
            ),
            Rule::Fillet => write!(
                f,
                "{place} reach into the fillets of the mate, by {:.3} modules of radius of curvature, at most 0 allowed",
                -value
            ),
            Rule::Trochoidal if value.is_infinite() => {
                write!(
                    f,
                    "in {place} the tip circle of the inner gear encloses that of the ring, so that teeth always meet"
                )
            }
            Rule::Trochoidal => write!(
                f,
                "in {place} tips overlap after they have left the line of action, by {:.3}° of the ring",
                -value.to_degrees()
            ),
            Rule::RadialAssembly if value.is_infinite() => {
                write!(f, "the planets do not enter the ring radially: its tips reach within its base circle")
            }
            Rule::RadialAssembly => write!(
                f,
                "the planets do not enter the ring radially: tips overlap by {:.3}° of the planet",
                -value.to_degrees()
            ),
            Rule::PlanetGap => write!(
                f,
                "the tip circles of neighbours among {place} are {value:.3} modules apart, {} {limit} needed",
                if *limit > 0.0 { "at least" } else { "more than" }
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A gap that is rounded to just below its limit has it; planets that touch never clear each other.
    #[test]
    fn a_gap_is_clear_at_its_limit_but_not_at_0() {
        assert!(is_clear(0.5, 0.5) && is_clear(0.5 - 1e-15, 0.5) && is_clear(1e-9, 0.0));
        assert!(!is_clear(0.499, 0.5) && !is_clear(0.0, 0.0) && !is_clear(-1e-15, 0.0));
    }
}

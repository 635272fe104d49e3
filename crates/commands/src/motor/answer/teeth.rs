//! The teeth of a motor: their limits, and how near they come over a revolution.

use super::Verdict;
use crate::answer::Warning;
use crate::error::Error;
use crate::shared::number::{maybe_si, plain, si};
use epicyclic_hydromotor::centrode;
use epicyclic_hydromotor::profile::clearance::Nearest;
use epicyclic_hydromotor::profile::limits::{self, Bound};
use epicyclic_hydromotor::profile::{Part, Profile};
use epicyclic_units::Physical as _;
use epicyclic_units::format;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::Length;

/// Rotations of half a period at which clearances are looked for, besides the refined one.
const STEPS: u32 = 180;

/// A wheel of a motor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Wheel {
    /// The ring with arches.
    Stator,
    /// The sun with lobes.
    Rotor,
    /// The round wheels between them.
    Satellite,
}

impl Wheel {
    pub(crate) const fn of(wheel: centrode::Wheel) -> Self {
        match wheel {
            centrode::Wheel::Stator => Self::Stator,
            centrode::Wheel::Rotor => Self::Rotor,
            centrode::Wheel::Satellite => Self::Satellite,
        }
    }

    /// In words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Stator => "stator",
            Self::Rotor => "rotor",
            Self::Satellite => "satellite",
        }
    }
}

/// A limit of the teeth, at the place where value and bound are nearest or the bound is most exceeded.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ToothLimit {
    /// Whose teeth.
    pub wheel: Wheel,
    /// Which limit.
    pub limit: LimitKind,
    /// The value.
    pub value_m: f64,
    /// On which side of its bound it must lie.
    pub side: Side,
    /// The bound.
    pub bound_m: f64,
    /// Whether it does.
    pub verdict: Verdict,
    /// Arc length of that place from the crest of the wheel; null where it is the same everywhere.
    pub at_arc_m: Option<f64>,
}

/// What is limited.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LimitKind {
    /// The cutter's tip removes a part of the flank.
    Undercut,
    /// The flank has a cusp before the tip.
    TipCusp,
    /// The wheel's tip reaches below the satellite's involute.
    SatelliteRoot,
    /// The satellite's tip reaches below the wheel's flank.
    WheelRoot,
    /// Thickness of the tip.
    TipThickness,
    /// Length of the path of contact: a new pair of flanks meets before the last one parts.
    ContactPath,
    /// The root's parallel of the centrode has cusps.
    RootCurve,
    /// The tip's parallel of the centrode has cusps.
    TipCurve,
    /// Tip circles of neighbouring satellites.
    Neighbours,
    /// The rotor's crest passes the stator's trough.
    Wheels,
}

impl LimitKind {
    const fn of(kind: limits::LimitKind) -> Self {
        match kind {
            limits::LimitKind::Undercut => Self::Undercut,
            limits::LimitKind::TipCusp => Self::TipCusp,
            limits::LimitKind::SatelliteRoot => Self::SatelliteRoot,
            limits::LimitKind::WheelRoot => Self::WheelRoot,
            limits::LimitKind::TipThickness => Self::TipThickness,
            limits::LimitKind::ContactPath => Self::ContactPath,
            limits::LimitKind::RootCurve => Self::RootCurve,
            limits::LimitKind::TipCurve => Self::TipCurve,
            limits::LimitKind::Neighbours => Self::Neighbours,
            limits::LimitKind::Wheels => Self::Wheels,
        }
    }

    /// In words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Undercut => "undercut: path to its start",
            Self::TipCusp => "cusp at the tip: path to it",
            Self::SatelliteRoot => "reach into the satellite: path",
            Self::WheelRoot => "reach of the satellite: path",
            Self::TipThickness => "thickness of the thinnest tip",
            Self::ContactPath => "shortest path of contact",
            Self::RootCurve => "root curve without cusps",
            Self::TipCurve => "tip curve without cusps",
            Self::Neighbours => "satellites' centres, distance",
            Self::Wheels => "stator above the rotor",
        }
    }

    /// As a name: that of its warning.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Undercut => "undercut",
            Self::TipCusp => "tip-cusp",
            Self::SatelliteRoot => "satellite-root",
            Self::WheelRoot => "wheel-root",
            Self::TipThickness => "tip-thickness",
            Self::ContactPath => "contact-path",
            Self::RootCurve => "root-curve",
            Self::TipCurve => "tip-curve",
            Self::Neighbours => "neighbours",
            Self::Wheels => "wheels",
        }
    }
}

/// On which side of its bound a value must lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// At it or above.
    AtLeast,
    /// At it or below.
    AtMost,
}

impl Side {
    /// In words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::AtLeast => "at least",
            Self::AtMost => "at most",
        }
    }
}

/// How near two parts come over a revolution.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Clearance {
    /// What comes near.
    pub between: Between,
    /// The least distance; negative where they overlap.
    pub clearance_m: f64,
    /// The same over the module.
    pub clearance_in_modules: f64,
    /// Part of the wheel's tooth where it is.
    pub part: Option<ToothPart>,
    /// Rotation of the rotor at which it is; null for flanks in mesh, which are equally near all along, and
    /// where it is the same at every angle.
    pub rotation_rad: Option<f64>,
    /// Where it is, of satellites and a wheel; null for flanks in mesh.
    pub x_m: Option<f64>,
    /// Where it is.
    pub y_m: Option<f64>,
}

/// What comes near each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Between {
    /// Satellites and the stator.
    Stator,
    /// Satellites and the rotor.
    Rotor,
    /// Tips of neighbouring satellites.
    Neighbours,
    /// Tips of rotor and stator.
    Wheels,
}

impl Between {
    /// In words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Stator => "satellites and stator",
            Self::Rotor => "satellites and rotor",
            Self::Neighbours => "tips of neighbouring satellites",
            Self::Wheels => "tips of rotor and stator",
        }
    }
}

/// A part of a tooth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ToothPart {
    /// The land at the tip.
    Tip,
    /// What meshes.
    Flank,
    /// The curve from the flank to the root.
    Fillet,
    /// The bottom of a space.
    Root,
}

impl ToothPart {
    const fn of(part: Part) -> Self {
        match part {
            Part::Tip => Self::Tip,
            Part::Flank => Self::Flank,
            Part::Fillet => Self::Fillet,
            Part::Root => Self::Root,
        }
    }
}

pub(crate) fn limits(profile: &Profile, warnings: &mut Vec<Warning>) -> Vec<ToothLimit> {
    let mut found = vec![];
    for limit in profile.limits() {
        let (kind, wheel) = (LimitKind::of(limit.kind), Wheel::of(limit.wheel));
        let side = match limit.sense {
            Bound::AtLeast => Side::AtLeast,
            Bound::AtMost => Side::AtMost,
        };
        if !limit.holds() {
            let [value, bound] = [limit.value, limit.bound].map(|length| format::quantity(length, 4));
            let message = format!(
                "teeth of the {}: {}: {value}, allowed {} {bound}",
                wheel.words(),
                kind.words(),
                side.words()
            );
            warnings.push(Warning { name: kind.name(), message });
        }
        found.push(ToothLimit {
            wheel,
            limit: kind,
            value_m: si(limit.value),
            side,
            bound_m: si(limit.bound),
            verdict: Verdict::of(limit.holds(), limit.margin(), limit.bound),
            at_arc_m: maybe_si(limit.at),
        });
    }
    found
}

pub(crate) fn clearances(profile: &Profile, warnings: &mut Vec<Warning>) -> Result<Vec<Clearance>, Error> {
    let found = profile.clearances(STEPS)?;
    let module = profile.motor().module();
    let bare = |between, clearance: Length| Clearance {
        between,
        clearance_m: si(clearance),
        clearance_in_modules: plain((clearance / module).si()),
        part: None,
        rotation_rad: None,
        x_m: None,
        y_m: None,
    };
    let of_wheel = |between, nearest: &Nearest| {
        // Flanks in mesh are equally near all along: where rounding finds them nearest says nothing.
        let in_mesh = nearest.part == Part::Flank && nearest.clearance >= Length::default();
        let told = |value: f64| (!in_mesh).then_some(value);
        Clearance {
            part: Some(ToothPart::of(nearest.part)),
            rotation_rad: told(si(nearest.rotation)),
            x_m: told(si(nearest.at.x)),
            y_m: told(si(nearest.at.y)),
            ..bare(between, nearest.clearance)
        }
    };
    let (distance, rotation) = found.neighbours;
    let all = vec![
        of_wheel(Between::Stator, &found.stator),
        of_wheel(Between::Rotor, &found.rotor),
        Clearance { rotation_rad: Some(si(rotation)), ..bare(Between::Neighbours, distance) },
        bare(Between::Wheels, found.wheels),
    ];
    for (clearance, length) in
        all.iter().zip([found.stator.clearance, found.rotor.clearance, distance, found.wheels])
    {
        if length < Length::default() {
            let overlap = format::quantity(-length, 4);
            let message = format!("{}: they overlap by {overlap}", clearance.between.words());
            warnings.push(Warning { name: "overlap", message });
        }
    }
    Ok(all)
}

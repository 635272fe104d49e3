//! Teeth of a motor: their limits, and their clearances over a revolution.

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

/// Rotations of half a period at which clearances are computed, besides the refined minimum.
const STEPS: u32 = 180;

/// Wheels of a motor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Wheel {
    /// Ring with arches.
    Stator,
    /// Sun with lobes.
    Rotor,
    /// Round gears between stator and rotor.
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

    /// Name of the wheel in words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Stator => "stator",
            Self::Rotor => "rotor",
            Self::Satellite => "satellite",
        }
    }
}

/// Limit of the teeth, at the place of the least margin or the largest excess.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ToothLimit {
    /// Wheel whose teeth are limited.
    pub wheel: Wheel,
    /// Kind of the limit.
    pub limit: LimitKind,
    /// Value in m.
    pub value_m: f64,
    /// Side of the bound on which the value must lie.
    pub side: Side,
    /// Bound in m.
    pub bound_m: f64,
    /// Result of the comparison.
    pub verdict: Verdict,
    /// Arc length of the place from the crest of the wheel, in m; null if the value is equal everywhere.
    pub at_arc_m: Option<f64>,
}

/// Kinds of limits of the teeth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[serde(rename_all = "snake_case")]
pub enum LimitKind {
    /// Undercut: the cutter's tip removes a part of the flank.
    Undercut,
    /// Cusp of the flank before the tip.
    TipCusp,
    /// Interference: the wheel's tip reaches below the satellite's involute.
    SatelliteRoot,
    /// Interference: the satellite's tip reaches below the wheel's flank.
    WheelRoot,
    /// Thickness of the tip.
    TipThickness,
    /// Length of the path of contact: a new pair of flanks meets before the previous one separates.
    ContactPath,
    /// Cusps of the root curve, a parallel of the centrode.
    RootCurve,
    /// Cusps of the tip curve, a parallel of the centrode.
    TipCurve,
    /// Distance between the tip circles of neighbouring satellites.
    Neighbours,
    /// Distance by which the rotor's crest passes the stator's trough.
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

    /// Name of the limit in words.
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

    /// Name of the limit, which is also that of its warning.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.into()
    }
}

/// Sides of a bound on which a value must lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// Equal to the bound or above.
    AtLeast,
    /// Equal to the bound or below.
    AtMost,
}

impl Side {
    /// Side in words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::AtLeast => "at least",
            Self::AtMost => "at most",
        }
    }
}

/// Least distance between two parts over a revolution.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Clearance {
    /// Parts whose distance is measured.
    pub between: Between,
    /// Least distance in m; negative if the parts overlap.
    pub clearance_m: f64,
    /// Least distance over the module.
    pub clearance_in_modules: f64,
    /// Part of the wheel's tooth at the least distance; null if none exists.
    pub part: Option<ToothPart>,
    /// Rotor angle of the least distance, in rad. Null for flanks in mesh, which are equally close
    /// everywhere, and if the distance is equal at every angle.
    pub rotation_rad: Option<f64>,
    /// Coordinate x of the least distance in m, for satellites and a wheel; null for flanks in mesh.
    pub x_m: Option<f64>,
    /// Coordinate y of the least distance in m, for satellites and a wheel; null for flanks in mesh.
    pub y_m: Option<f64>,
}

/// Pairs of parts whose distance is measured.
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
    /// Name of the pair in words.
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

/// Parts of a tooth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ToothPart {
    /// Land at the tip.
    Tip,
    /// Flank, the part in mesh.
    Flank,
    /// Curve from the flank to the root.
    Fillet,
    /// Bottom of a tooth space.
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
        // Flanks in mesh are equally close everywhere; the place of the minimum would be set by rounding.
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

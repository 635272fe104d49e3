//! Teeth of a motor: their limits, and their clearances over a revolution.

use super::Verdict;
use crate::error::Error;
use crate::shared::number::{maybe_si, plain, si};
use epicyclic_hydromotor::centrode::Wheel;
use epicyclic_hydromotor::profile::clearance::Nearest;
use epicyclic_hydromotor::profile::limits::{Bound, Limit, LimitKind};
use epicyclic_hydromotor::profile::{Part, Profile};
use epicyclic_units::Physical as _;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::Length;

/// Rotations of half a period at which clearances are computed, besides the refined minimum.
const STEPS: u32 = 180;

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
    pub side: Bound,
    /// Bound in m.
    pub bound_m: f64,
    /// Result of the comparison.
    pub verdict: Verdict,
    /// Arc length of the place from the crest of the wheel, in m; null if the value is equal everywhere.
    pub at_arc_m: Option<f64>,
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
    pub part: Option<Part>,
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

pub(crate) fn limits(profile: &Profile) -> Vec<ToothLimit> {
    let record = |limit: &Limit| ToothLimit {
        wheel: limit.wheel,
        limit: limit.kind,
        value_m: si(limit.value),
        side: limit.sense,
        bound_m: si(limit.bound),
        verdict: Verdict::of(limit.holds(), limit.margin(), limit.bound),
        at_arc_m: maybe_si(limit.at),
    };
    profile.limits().iter().map(record).collect()
}

pub(crate) fn clearances(profile: &Profile) -> Result<Vec<Clearance>, Error> {
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
            part: Some(nearest.part),
            rotation_rad: told(si(nearest.rotation)),
            x_m: told(si(nearest.at.x)),
            y_m: told(si(nearest.at.y)),
            ..bare(between, nearest.clearance)
        }
    };
    let (distance, rotation) = found.neighbours;
    Ok(vec![
        of_wheel(Between::Stator, &found.stator),
        of_wheel(Between::Rotor, &found.rotor),
        Clearance { rotation_rad: Some(si(rotation)), ..bare(Between::Neighbours, distance) },
        bare(Between::Wheels, found.wheels),
    ])
}

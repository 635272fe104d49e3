//! The tooth numbers of a drive and their conditions.

use super::part::{BoredGear, Computed};
use super::result::{GearSetGeometry, TeethDesign};
use super::spec::{GearSetSpec, TeethSpec};
use super::warning::Warning;
use super::{MODE, USUAL_RATIO, finite};
use crate::Error;
use crate::planetary::GearSet;
use crate::tolerance::GAP;
use epicyclic_gears::geometry::{GearKind, ToothedGear, centre_distance};
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::simple_set::exact_ratio;
use epicyclic_gears::spacing::PlanetSpacing;
use epicyclic_gears::synthesis::{Bounds, Near, Placement, ToothNumbers};
use epicyclic_units::Physical;
use std::cmp::Reverse;

/// The gear set: its speeds, its tooth numbers with their conditions, its geometry.
pub(super) struct Geared {
    pub(super) set: GearSet,
    pub(super) teeth: TeethDesign,
    pub(super) geometry: GearSetGeometry,
}

/// Target ratio and its tolerance.
#[derive(Clone, Copy)]
pub(super) struct Wanted {
    pub(super) ratio: f64,
    /// Permissible relative error of the ratio.
    pub(super) tolerance: f64,
}

pub(super) fn geared(
    wanted: Wanted,
    teeth: &TeethSpec,
    gear_set: &GearSetSpec,
    warnings: &mut Vec<Warning>,
) -> Result<Geared, Error> {
    let numbers = tooth_numbers(wanted, teeth, gear_set.rack)?;
    let geometry = geometry(gear_set, numbers)?;
    let teeth = conditions(wanted, teeth, &geometry, numbers, warnings)?;
    Ok(Geared { set: GearSet::new(numbers)?, teeth, geometry })
}

/// The tooth numbers given, or the best within the bounds.
fn tooth_numbers(wanted: Wanted, teeth: &TeethSpec, rack: BasicRack) -> Result<ToothNumbers, Error> {
    match teeth {
        TeethSpec::Given { teeth, .. } => Ok(*teeth),
        TeethSpec::Within(bounds) => {
            let bounds = Bounds { rack, ..bounds.clone() };
            // Order: error, then most planets, smallest ring, smallest sun. Only one set is held at a time.
            let key = |near: &Near| (Reverse(near.teeth.planets), near.teeth.ring, near.teeth.sun);
            let mut best: Option<Near> = None;
            bounds.each_for_ratio(
                wanted.ratio,
                MODE,
                wanted.tolerance,
                |_| std::ops::ControlFlow::Continue(()),
                |near| {
                    let nearer = |best: &Near| {
                        let by_error = near.ratio_error.abs().total_cmp(&best.ratio_error.abs());
                        by_error.then_with(|| key(&near).cmp(&key(best))).is_lt()
                    };
                    if best.as_ref().is_none_or(nearer) {
                        best = Some(near);
                    }
                },
            )?;
            let nothing = epicyclic_gears::Error::NoToothNumbers {
                wanted: wanted.ratio,
                mode: MODE,
                tolerance: wanted.tolerance,
                nearest: None,
                left_out: None,
                fewer_planets: None,
            };
            Ok(best.ok_or(nothing)?.teeth)
        }
    }
}

fn geometry(wanted: &GearSetSpec, teeth: ToothNumbers) -> Result<GearSetGeometry, Error> {
    let GearSetSpec { module, rack, face_width, .. } = *wanted;
    let sun = ToothedGear::new(GearKind::External, module, teeth.sun, rack)?;
    let planet = ToothedGear::new(GearKind::External, module, teeth.planet, rack)?;
    let ring = ToothedGear::new(GearKind::Internal, module, teeth.ring, rack)?;
    finite(Computed::RingRoot, ring.root_diameter().si())?;
    Ok(GearSetGeometry { sun, planet, ring, centre_distance: centre_distance(&sun, &planet)?, face_width })
}

/// Conditions on the tooth numbers and how well they are met.
fn conditions(
    wanted: Wanted,
    spec: &TeethSpec,
    gear_set: &GearSetGeometry,
    teeth: ToothNumbers,
    warnings: &mut Vec<Warning>,
) -> Result<TeethDesign, Error> {
    let (rack, module) = (gear_set.planet.rack(), gear_set.planet.module());
    let (placement, least_gap) = match spec {
        TeethSpec::Given { placement, tip_gap, .. } => (*placement, *tip_gap),
        TeethSpec::Within(bounds) => (bounds.placement, bounds.tip_gap),
    };
    let ratio = teeth.basic_ratio().ratio(MODE)?;
    let spacing = PlanetSpacing::least_unequal(teeth.sun, teeth.ring, teeth.planets);
    let planet = teeth.planet_circle(&rack);
    let found = TeethDesign {
        numbers: teeth,
        ratio,
        exact_ratio: exact_ratio(teeth.sun, teeth.ring, MODE),
        ratio_error: ratio / wanted.ratio - 1.0,
        clearance_limit: planet.number_limit(0.0),
        most_planets: planet.most(0.0),
        tip_gap: module * planet.gap_to_alike(spacing.half_gap_sine()),
        spacing,
    };
    finite(Computed::RatioError, found.ratio_error)?;
    let Wanted { ratio: wanted, tolerance } = wanted;
    if found.ratio_error.abs() > tolerance + 4.0 * f64::EPSILON {
        warnings.push(Warning::RatioDeparts { wanted, ratio, tolerance });
    }
    if !USUAL_RATIO.contains(&ratio) {
        warnings.push(Warning::RatioOutsideUsualRange { ratio });
    }
    for (gear, count) in [(BoredGear::Sun, teeth.sun), (BoredGear::Planet, teeth.planet)] {
        if rack.undercuts(count) {
            let at_least = rack.least_teeth_without_undercut();
            warnings.push(Warning::Undercut { gear, teeth: count.get(), at_least });
        }
    }
    if found.tip_gap.si() <= 0.0 {
        warnings.push(Warning::NoPlanetClearance {
            planets: teeth.planets,
            gap_mm: found.tip_gap.mm(),
            most_planets: found.most_planets,
        });
    }
    let least_gap_mm = least_gap * module.mm();
    let gap_mm = found.tip_gap.mm();
    if gap_mm > 0.0 && gap_mm < least_gap_mm * (1.0 - GAP) {
        warnings.push(Warning::TipGapBelowWanted { gap_mm, wanted_mm: least_gap_mm });
    }
    if !found.spacing.is_equal() && placement == Placement::Equal {
        warnings.push(Warning::UnequalSpacing {
            planets: teeth.planets,
            slots: found.spacing.slots(),
            deviation_deg: found.spacing.greatest_deviation().degrees(),
        });
    }
    Ok(found)
}

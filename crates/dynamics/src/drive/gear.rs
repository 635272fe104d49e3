//! The tooth set of a drive and its conditions.

use super::part::Wheel;
use super::result::{Gear, Wheels};
use super::spec::{DriveSpec, TeethSpec};
use super::warning::Warning;
use super::{USUAL_RATIO, finite, mode};
use crate::Error;
use crate::tolerance::GAP;
use crate::units::{degrees, length, meters, millimeters, radians};
use epicyclic_gears::row::exact_ratio;
use epicyclic_gears::spacing::PlanetSpacing;
use epicyclic_gears::synthesis::{
    Bounds, MOST_PLANETS, MOST_TEETH, Near, Placement, ToothSet, neighbour_limit,
};
use std::cmp::Reverse;

/// The tooth set given, or the best within the bounds.
pub(super) fn tooth_set(spec: &DriveSpec) -> Result<ToothSet, Error> {
    match &spec.teeth {
        TeethSpec::Given { teeth, tip_gap, .. } => {
            check(*teeth, *tip_gap)?;
            Ok(*teeth)
        }
        TeethSpec::Within(bounds) => {
            let bounds = Bounds { rack: spec.wheels.rack, ..bounds.clone() };
            // By error, then most planets, smallest ring, smallest sun. One is held at a time.
            let key = |near: &Near| (Reverse(near.teeth.planets), near.teeth.ring, near.teeth.sun);
            let mut best: Option<Near> = None;
            bounds.each_for_ratio(
                spec.ratio,
                mode()?,
                spec.ratio_tolerance,
                |_| {},
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
            let nothing = epicyclic_gears::Error::NoToothSet {
                wanted: spec.ratio,
                mode: mode()?,
                tolerance: spec.ratio_tolerance,
                nearest: None,
            };
            Ok(best.ok_or(nothing)?.teeth)
        }
    }
}

fn check(teeth: ToothSet, tip_gap: f64) -> Result<(), Error> {
    let (sun, planet, ring) = (teeth.sun.get(), teeth.planet.get(), teeth.ring.get());
    for (wheel, teeth) in [("sun", sun), ("planet", planet), ("ring", ring)] {
        if teeth > MOST_TEETH {
            let (from, to) = (teeth, teeth);
            return Err(epicyclic_gears::Error::ToothRange { wheel, from, to, most: MOST_TEETH }.into());
        }
    }
    if !(2..=MOST_PLANETS).contains(&teeth.planets) {
        let (from, to) = (teeth.planets, teeth.planets);
        return Err(epicyclic_gears::Error::PlanetNumber { from, to, most: MOST_PLANETS }.into());
    }
    if !(tip_gap >= 0.0 && tip_gap.is_finite()) {
        let (quantity, value, unit) = ("tip gap", tip_gap, "modules");
        return Err(epicyclic_gears::Error::Negative { quantity, value, unit }.into());
    }
    if ring == sun + 2 * planet { Ok(()) } else { Err(Error::NotCoaxial { sun, planet, ring }) }
}

/// How well the tooth set meets its conditions.
pub(super) fn conditions(
    spec: &DriveSpec,
    teeth: ToothSet,
    wheels: &Wheels,
    warnings: &mut Vec<Warning>,
) -> Result<Gear, Error> {
    let rack = spec.wheels.rack;
    let (placement, least_gap) = match &spec.teeth {
        TeethSpec::Given { placement, tip_gap, .. } => (*placement, *tip_gap),
        TeethSpec::Within(bounds) => (bounds.placement, bounds.tip_gap),
    };
    let ratio = teeth.stationary_ratio().ratio(mode()?)?;
    let spacing = PlanetSpacing::least_unequal(teeth.sun, teeth.ring, teeth.planets);
    let chord = 2.0 * meters(wheels.centre_distance) * (radians(spacing.smallest_gap()) / 2.0).sin();
    let gear = Gear {
        teeth,
        ratio,
        exact_ratio: exact_ratio(teeth.sun, teeth.ring, mode()?),
        ratio_error: ratio / spec.ratio - 1.0,
        neighbour_limit: neighbour_limit(teeth.sun, teeth.planet, &rack),
        most_planets: Bounds { rack, ..Bounds::default() }.most_planets(teeth.sun, teeth.planet),
        tip_gap: length(chord - meters(wheels.planet.tip_diameter())),
        spacing,
    };
    finite("error of the ratio", gear.ratio_error)?;
    if gear.ratio_error.abs() > spec.ratio_tolerance + 4.0 * f64::EPSILON {
        warnings.push(Warning::RatioDeparts { wanted: spec.ratio, ratio, tolerance: spec.ratio_tolerance });
    }
    if !USUAL_RATIO.contains(&ratio) {
        warnings.push(Warning::RatioOutsideUsualRange { ratio });
    }
    for (wheel, count) in [(Wheel::Sun, teeth.sun), (Wheel::Planet, teeth.planet)] {
        if rack.undercuts(count) {
            let at_least = rack.least_teeth_without_undercut();
            warnings.push(Warning::Undercut { wheel, teeth: count.get(), at_least });
        }
    }
    if meters(gear.tip_gap) <= 0.0 {
        warnings.push(Warning::NeighbourGap {
            planets: teeth.planets,
            gap_mm: millimeters(gear.tip_gap),
            most_planets: gear.most_planets,
        });
    }
    let least_gap_mm = least_gap * millimeters(spec.wheels.module);
    let gap_mm = millimeters(gear.tip_gap);
    if gap_mm > 0.0 && gap_mm < least_gap_mm * (1.0 - GAP) {
        warnings.push(Warning::TipGapBelowWanted { gap_mm, wanted_mm: least_gap_mm });
    }
    if !gear.spacing.is_equal() && placement == Placement::Equal {
        warnings.push(Warning::UnequalSpacing {
            planets: teeth.planets,
            slots: gear.spacing.slots(),
            deviation_deg: degrees(gear.spacing.greatest_deviation()),
        });
    }
    Ok(gear)
}

//! Gearboxes of fewer sets that miss the wanted ratios narrowly.

use super::{ClassName, Kept, Synthesis, Wanted, solve};
use crate::error::Error;
use epicyclic_synthesis::rank::Objective;
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::ControlFlow;

/// How much wider the tolerance is than the one wanted.
const WIDER: f64 = 5.0;

/// The widest tolerance that is tried.
const WIDEST: f64 = 0.1;

/// Classes are searched again up to this many structures times sets of shift elements in all: a second's
/// work.
const MOST_SPACE: f64 = 1e6;

/// A gearbox of fewer sets than have the ratios within their tolerances.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct NearMiss {
    /// Of which structures it is.
    pub class: ClassName,
    /// Its planet sets.
    pub sets: usize,
    /// Its shift elements.
    pub shift_elements: usize,
    /// The tolerance within which it has all ratios: its greatest deviation, as a share.
    pub greatest_deviation: f64,
}

/// Gearboxes of a class that are looked at, the nearest ones.
const NEAREST: usize = 100;

/// The smallest class of fewer sets than those found that has the ratios within a wider tolerance: five times
/// the wanted one, at most 10 %. Of that class, among the hundred gearboxes nearest to the ratios, the
/// gearbox of use with the least deviation.
///
/// Classes that take longer than a second to search again are left out, and none is told where `goes_on`,
/// which is asked now and then, breaks.
///
/// # Errors
/// As [`solve`], but for classes that there are not.
pub fn near_miss(
    wanted: &Wanted,
    answer: &Synthesis,
    goes_on: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<Option<NearMiss>, Error> {
    let fewer = match answer.solutions.first() {
        Some(found) => found.sets.len().saturating_sub(1),
        None => *wanted.sets.end(),
    };
    let space = |most: usize| -> f64 {
        answer.searched.iter().filter(|class| class.sets <= most).map(|class| class.space).sum()
    };
    let first = *wanted.sets.start();
    let Some(most) = (first..=fewer).rev().find(|most| space(*most) <= MOST_SPACE) else { return Ok(None) };
    let wider = Wanted {
        sets: first..=most,
        tolerance: (WIDER * wanted.tolerance).min(WIDEST).max(wanted.tolerance),
        order: vec![Objective::Deviation],
        most: NEAREST,
        all_gearboxes: true,
        also: None,
        teeth: None,
        explain: None,
        usable: None,
        ..wanted.clone()
    };
    let (found, kept) = match solve(&wider, &|_, _| goes_on()) {
        // So few sets have no such numbers of links or elements.
        Err(Error::Synthesis(_)) => return Ok(None),
        Ok((found, _)) if !found.complete => return Ok(None),
        found => found?,
    };
    // What is of no use is no hint either.
    let is_of_use =
        |kept: &Kept| wanted.usable.is_none_or(|usable| usable.fault(&kept.judged, &kept.rating).is_none());
    let mut of_use = found.solutions.iter().zip(&kept).filter(|(_, kept)| is_of_use(kept));
    let first = of_use.find(|(one, _)| one.missing_gears.is_empty()).map(|(one, _)| one);
    Ok(first.map(|one| NearMiss {
        class: found.searched.last().map_or(ClassName::Core, |class| class.class),
        sets: one.sets.len(),
        shift_elements: one.shift_elements.len(),
        greatest_deviation: one.greatest_deviation,
    }))
}

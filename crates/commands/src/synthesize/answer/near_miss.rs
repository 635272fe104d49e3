//! Gearboxes of fewer sets that narrowly miss the required ratios.

use super::{Kept, Synthesis, Wanted, solve};
use crate::error::Error;
use epicyclic_synthesis::Kind;
use epicyclic_synthesis::rank::Objective;
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::ControlFlow;

/// Factor by which the tolerance is widened.
const WIDER: f64 = 5.0;

/// Widest tolerance that is tried.
const WIDEST: f64 = 0.1;

/// Limit of structures times sets of shift elements for the repeated search, about a second of work.
const MOST_SPACE: f64 = 1e6;

/// Gearbox of fewer sets than those with the ratios within their tolerances.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct NearMiss {
    /// Class of the structure.
    pub class: Kind,
    /// Number of planetary sets.
    pub sets: usize,
    /// Number of shift elements.
    pub shift_elements: usize,
    /// Largest relative deviation of a ratio, which is the tolerance needed for all ratios.
    pub greatest_deviation: f64,
}

/// Number of closest gearboxes of a class that are evaluated.
const NEAREST: usize = 100;

/// Finds the smallest class of fewer sets that has the ratios within a wider tolerance: five times the
/// required one, at most 10 %. Among the hundred gearboxes of that class closest to the ratios, the usable
/// one with the least deviation is returned.
///
/// Classes that take longer than a second to search again are left out. The closure `goes_on` is called now
/// and then; if it returns a break, no gearbox is returned.
/// which is asked now and then, breaks.
///
/// Errors of [`solve`], except those about classes that do not exist.
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
        // So few sets do not allow these numbers of links or elements.
        Err(Error::Synthesis(_)) => return Ok(None),
        Ok((found, _)) if !found.complete => return Ok(None),
        found => found?,
    };
    // A gearbox that is not usable is not a useful hint.
    let is_of_use =
        |kept: &Kept| wanted.usable.is_none_or(|usable| usable.fault(&kept.judged, &kept.rating).is_none());
    let mut of_use = found.solutions.iter().zip(&kept).filter(|(_, kept)| is_of_use(kept));
    let first = of_use.find(|(one, _)| one.missing_gears.is_empty()).map(|(one, _)| one);
    Ok(first.map(|one| NearMiss {
        class: found.searched.last().map_or(Kind::Core, |class| class.class),
        sets: one.sets.len(),
        shift_elements: one.shift_elements.len(),
        greatest_deviation: one.greatest_deviation,
    }))
}

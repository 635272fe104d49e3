//! Tooth numbers of sets with profile shift: all that close, sun by sun on all threads.
//!
//! The ring deviates from `z_s + 2·z_p` by an offset, and some shifts leave no fault
//! ([`involute::search`](epicyclic_gears::involute::search)). Undercut, tip thickness, contact ratio,
//! interference and the clearance between planets are decided by the geometry of the shifted gears. A closing
//! may miss a range of shifts shorter than 1/64 of those without undercut
//! ([`Family::choose`](epicyclic_gears::involute::family::Family::choose)); nothing else is left out.
//!
//! Ratios, torques and losses depend on `k` alone as without shifts, since the efficiency of a set is given.
//! Planets turn by `r = z_p/z_s`. The size is that at the working circles, which follow from `k` and `r` by
//! the natural centre distance. Levels of `k` and `r` therefore lose nothing. The shifts themselves are no
//! objective; the aim picks them for each set that is reported.

use super::MOST_TOOTH_SETS;
use crate::Error;
use epicyclic_gears::ToothCount;
use epicyclic_gears::involute::left_out::LeftOut;
use epicyclic_gears::involute::plain;
use epicyclic_gears::involute::search::ProfileShift;
use epicyclic_gears::synthesis::{Bounds, ToothNumbers};
use epicyclic_numerics::threads::map;
use std::ops::ControlFlow;

/// Number of suns that are closed between two reports of progress.
const SUNS: usize = 16;

/// Number of sets whose teeth are checked between two reports of progress.
const SETS: usize = 1024;

/// Tooth numbers within the bounds whose gears can be cut and turned together, with or without profile
/// shift; without it also the number of the others.
///
/// # Errors
/// Those of [`Bounds`] and [`shifted`]; [`Error::TooManyToothSets`], before anything is made.
pub(super) fn all(
    bounds: &Bounds,
    shift: Option<&ProfileShift>,
    mut done: impl FnMut(f64) -> ControlFlow<()>,
) -> Result<(Vec<ToothNumbers>, Option<Box<LeftOut>>), Error> {
    if let Some(shift) = shift {
        return Ok((shifted(bounds, shift, done)?, None));
    }
    let counted = bounds.count()?;
    if counted > MOST_TOOTH_SETS {
        return Err(Error::TooManyToothSets { tooth_sets: counted, most: MOST_TOOTH_SETS });
    }
    that_turn(bounds, &bounds.tooth_numbers()?, &mut done)
}

/// Sets without profile shift whose gears can be cut and turned together, and the number of the others.
pub(super) fn that_turn(
    bounds: &Bounds,
    sets: &[ToothNumbers],
    mut done: impl FnMut(f64) -> ControlFlow<()>,
) -> Result<(Vec<ToothNumbers>, Option<Box<LeftOut>>), Error> {
    let (mut turn, mut left_out) = (vec![], None);
    for (place, some) in sets.chunks(SETS).enumerate() {
        // The same gears come with several numbers of planets, one after another.
        let with_gears: Vec<&[ToothNumbers]> =
            some.chunk_by(|one, other| gears(one) == gears(other)).collect();
        let misses = map(&with_gears, |alike| plain::miss(gears(&alike[0]), &bounds.rack));
        for (alike, miss) in with_gears.iter().zip(misses) {
            match miss? {
                None => turn.extend_from_slice(alike),
                Some(check) => {
                    alike.iter().for_each(|set| LeftOut::add(&mut left_out, || set.to_string(), &check));
                }
            }
        }
        if done(((place + 1) * SETS).min(sets.len()) as f64 / sets.len() as f64).is_break() {
            return Err(Error::Cancelled);
        }
    }
    Ok((turn, left_out))
}

const fn gears(set: &ToothNumbers) -> [ToothCount; 3] {
    [set.sun, set.planet, set.ring]
}

/// Sets within the bounds, ascending by sun. `done` receives the completed share of the bounds, from 0 to 1;
/// a break ends the search.
///
/// # Errors
/// Those of [`ShiftedSearch::check`](epicyclic_gears::involute::search::ShiftedSearch::check);
/// [`Error::TooManyToothSets`] by the number of sets to be checked, before any is checked.
pub(super) fn shifted(
    bounds: &Bounds,
    shift: &ProfileShift,
    mut done: impl FnMut(f64) -> ControlFlow<()>,
) -> Result<Vec<ToothNumbers>, Error> {
    let search = shift.within(bounds);
    let space = search.space()?;
    if space > MOST_TOOTH_SETS {
        return Err(Error::TooManyToothSets { tooth_sets: space, most: MOST_TOOTH_SETS });
    }
    let suns: Vec<ToothCount> =
        bounds.sun.clone().map(ToothCount::new).collect::<Result<_, epicyclic_gears::Error>>()?;
    let mut found = vec![];
    for (place, some) in suns.chunks(SUNS).enumerate() {
        for of_sun in map(some, |sun| search.of_sun(*sun, |_, _| true)) {
            found.extend(of_sun?);
        }
        if done(((place + 1) * SUNS).min(suns.len()) as f64 / suns.len() as f64).is_break() {
            return Err(Error::Cancelled);
        }
    }
    Ok(found)
}

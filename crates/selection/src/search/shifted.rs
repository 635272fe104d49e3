//! Tooth numbers of sets with profile shift: all that close, sun by sun on all threads.

use super::MOST_TOOTH_SETS;
use crate::Error;
use crate::threads::map;
use epicyclic_gears::ToothCount;
use epicyclic_gears::involute::search::ProfileShift;
use epicyclic_gears::synthesis::{Bounds, ToothNumbers};

/// Suns that are closed before it is told how far the search is.
const SUNS: usize = 16;

/// All within the bounds, ascending by sun; `done` is told, from 0 to 1, how much of the bounds has been gone through.
///
/// # Errors
/// Those of [`ShiftedSearch::check`](epicyclic_gears::involute::search::ShiftedSearch::check); [`Error::TooManyToothSets`] by what would be
/// gone through, before anything is.
pub(super) fn shifted(
    bounds: &Bounds,
    shift: &ProfileShift,
    mut done: impl FnMut(f64),
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
        done(((place + 1) * SUNS).min(suns.len()) as f64 / suns.len() as f64);
    }
    Ok(found)
}

//! Checks of numbers and tooth counts before a gearbox is built, and the faults of both together.

use super::DescriptionError;
use crate::Path;
use crate::faults::{At, Faults};
use epicyclic_gears::teeth::ToothCount;
use epicyclic_train::set::SetSpec;
use epicyclic_train::{Error, Gearbox, Located, Site};

/// Link of refused entries. A refused entry keeps its number and name, so that others may refer to it; a
/// fault of this link only follows from that refusal.
pub(super) const NO_LINK: &str = "\u{ffff}";

/// A set in place of one that was refused, with this number of planets.
pub(super) fn refused(set: &str, planet_count: Option<u32>) -> SetSpec {
    SetSpec { planet_count, ..SetSpec::simple(set, [NO_LINK; 3], 2.0) }
}

/// The gearbox, or the faults of its record and those that the solver finds.
pub(super) fn built(
    mut faults: Faults,
    gearbox: Result<Gearbox, Vec<Located>>,
    at: impl Fn(Site) -> At,
) -> Result<Gearbox, Faults> {
    let found = match gearbox {
        Ok(gearbox) => return faults.or(gearbox),
        Err(found) => found,
    };
    let is_sound = faults.is_empty();
    let follows = |error: &Error| matches!(error, Error::Unknown { name, .. } if name == NO_LINK);
    for Located { error, site } in found.into_iter().filter(|fault| is_sound || !follows(&fault.error)) {
        faults.push(at(site), error);
    }
    Err(faults)
}

/// Tooth counts of a key.
pub(super) fn counts(
    set: &str,
    key: &'static str,
    teeth: &[u32],
    faults: &mut Faults,
) -> Option<Vec<ToothCount>> {
    let count = |(place, count): (usize, &u32)| {
        let count = ToothCount::new(*count).map_err(|source| DescriptionError::of_set(set, source));
        faults.keep(Path::root().key(key).index(place), count)
    };
    let counts: Vec<_> = teeth.iter().enumerate().map(count).collect();
    counts.into_iter().collect()
}

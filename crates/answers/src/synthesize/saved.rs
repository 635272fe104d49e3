//! A solution as a file that `analyze`, `draw` and `report` read.

use super::Kept;
use crate::Error;
use crate::number::short;
use crate::saved::names;
use crate::teeth::shifted::SetShifts;
use epicyclic_formats::gearbox::{NotWritable, written};
use epicyclic_synthesis::teeth::{Design, SetTeeth};
use epicyclic_train::set::{Gearing, SetSpec};
use epicyclic_train::{GearSpec, Gearbox};

/// The gearbox of a solution under this name, its gears named by their places among the wanted forward gears in falling order, `1`,
/// `2` …, reverse `R`, several `R1`, `R2` …; with tooth numbers in place of the ring-to-sun ratios where some are given.
///
/// # Errors
/// Those of the solver for tooth numbers that no set can have; none are known for those of a search.
pub fn gearbox(kept: &Kept, name: &str, teeth: Option<&Design>) -> Result<Gearbox, Error> {
    let mut names = names(&kept.judged.ratios).into_iter();
    let mut sets = teeth.map(|design| design.sets.iter());
    let mut shifts = shifts(kept, teeth)?.into_iter();
    let with_teeth = |set: SetSpec| match sets.as_mut().and_then(Iterator::next) {
        None => match set.gearing {
            Gearing::BasicRatio(k) => SetSpec { gearing: Gearing::BasicRatio(short(k)), ..set },
            Gearing::Teeth(..) => set,
        },
        Some(of) => {
            let set = of.put_into(set);
            match shifts.next().flatten() {
                None => set,
                Some(shifts) => shifts.put_into(set),
            }
        }
    };
    let gearbox = kept.judged.gearbox.to_builder().named(name);
    Ok(gearbox
        .map_sets(with_teeth)
        .map_gears(|gear| GearSpec {
            name: names.next().unwrap_or_default(),
            input: None,
            output: None,
            ..gear
        })
        .build()?)
}

/// The profile shifts of the sets of a design; none of double-planet sets, and of no set where none were wanted.
///
/// # Errors
/// None of sets of a search.
pub(super) fn shifts(kept: &Kept, teeth: Option<&Design>) -> Result<Vec<Option<SetShifts>>, Error> {
    let of = |set: &SetTeeth| match (set, &kept.shift) {
        (SetTeeth::Simple(teeth), Some(shift)) => SetShifts::of(shift, teeth).map(Some),
        _ => Ok(None),
    };
    teeth.iter().flat_map(|design| &design.sets).map(of).collect()
}

/// The file of a solution, below these lines of comment.
///
/// # Errors
/// None are known: every set of a solution has a short form.
pub fn file(gearbox: &Gearbox, comment: &[String]) -> Result<String, NotWritable> {
    written(gearbox, comment)
}

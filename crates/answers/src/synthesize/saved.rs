//! A solution as a file that `analyze`, `draw` and `report` read.

use super::Kept;
use crate::number::short;
use crate::saved::names;
use epicyclic_formats::gearbox::{NotWritable, written};
use epicyclic_synthesis::teeth::Design;
use epicyclic_train::set::{Gearing, SetSpec};
use epicyclic_train::{Error, GearSpec, Gearbox};

/// The gearbox of a solution under this name, its gears named by their places among the wanted forward gears in falling order, `1`,
/// `2` …, reverse `R`, several `R1`, `R2` …; with tooth numbers in place of the ring-to-sun ratios where some are given.
///
/// # Errors
/// Those of the solver for tooth numbers that no set can have; none are known for those of a search.
pub fn gearbox(kept: &Kept, name: &str, teeth: Option<&Design>) -> Result<Gearbox, Error> {
    let mut names = names(&kept.judged.ratios).into_iter();
    let mut sets = teeth.map(|design| design.sets.iter());
    let with_teeth = |set: SetSpec| match sets.as_mut().and_then(Iterator::next) {
        None => match set.gearing {
            Gearing::BasicRatio(k) => SetSpec { gearing: Gearing::BasicRatio(short(k)), ..set },
            Gearing::Teeth(..) => set,
        },
        Some(of) => of.put_into(set),
    };
    kept.judged
        .gearbox
        .to_builder()
        .named(name)
        .map_sets(with_teeth)
        .map_gears(|gear| GearSpec {
            name: names.next().unwrap_or_default(),
            input: None,
            output: None,
            ..gear
        })
        .build()
}

/// The file of a solution, below these lines of comment.
///
/// # Errors
/// None are known: every set of a solution has a short form.
pub fn file(gearbox: &Gearbox, comment: &[String]) -> Result<String, NotWritable> {
    written(gearbox, comment)
}

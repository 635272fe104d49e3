//! Solution as a file that `analyze`, `draw` and `report` read.

use super::Kept;
use crate::error::Error;
use crate::shared::number::short;
use crate::shared::saved::names;
use crate::teeth::answer::shifted::SetShifts;
use epicyclic_formats::gearbox::{NotWritable, written};
use epicyclic_synthesis::teeth::{Design, SetTeeth};
use epicyclic_train::planet_set::Description;
use epicyclic_train::set::{Gearing, SetSpec};
use epicyclic_train::{GearSpec, Gearbox};

/// Gearbox of a solution under this name. Its forward gears are named `1`, `2` … by decreasing required
/// ratios, its reverse gear `R`, several `R1`, `R2` …. Tooth numbers, if given, replace the ring-to-sun
/// ratios.
///
/// # Errors
/// Errors of the solver for impossible tooth numbers; none are known for those of a search.
pub fn gearbox(kept: &Kept, name: &str, teeth: Option<&Design>) -> Result<Gearbox, Error> {
    let mut names = names(&kept.judged.ratios).into_iter();
    let shifts = shifts(kept, teeth)?;
    let sharing = &kept.judged.sharing;
    // Each set of the gearbox stands for the first of the structure's sets that it combines.
    let is_first = |place: &usize| sharing.compound_of(*place).is_none_or(|of| of.sets[0] == *place);
    let mut places = (0..kept.found.structure.sets().len()).filter(is_first);
    let with_teeth = |set: Description| {
        let place = places.next().unwrap_or_default();
        match (set, teeth) {
            (Description::Short(set), None) => match set.gearing {
                Gearing::BasicRatio(k) => SetSpec { gearing: Gearing::BasicRatio(short(k)), ..set }.into(),
                Gearing::Teeth(..) => set.into(),
            },
            (Description::Short(set), Some(design)) => {
                let set = design.sets[place].put_into(set);
                match &shifts[place] {
                    None => set.into(),
                    Some(shifts) => shifts.put_into(set).into(),
                }
            }
            (Description::Compound(mut set), None) => {
                set.centrals.iter_mut().for_each(|central| central.teeth = short(central.teeth));
                set.into()
            }
            (Description::Compound(set), Some(design)) => match sharing.compound_of(place) {
                Some(compound) => compound.put_into(set, &design.sets).into(),
                None => set.into(),
            },
        }
    };
    let gearbox = kept.judged.gearbox.to_builder().named(name);
    Ok(gearbox
        .map_descriptions(with_teeth)
        .map_gears(|gear| GearSpec {
            name: names.next().unwrap_or_default(),
            input: None,
            output: None,
            ..gear
        })
        .build()?)
}

/// Profile shifts of the sets of a design; `None` for double-planet sets, and for all sets if no shifts were
/// requested.
///
/// # Errors
/// No error is known for sets of a search.
pub(super) fn shifts(kept: &Kept, teeth: Option<&Design>) -> Result<Vec<Option<SetShifts>>, Error> {
    let of = |set: &SetTeeth| match (set, &kept.shift) {
        (SetTeeth::Simple(teeth), Some(shift)) => SetShifts::of(shift, teeth).map(Some),
        _ => Ok(None),
    };
    teeth.iter().flat_map(|design| &design.sets).map(of).collect()
}

/// Gearbox file of a solution, below these lines of comment.
///
/// # Errors
/// No error is known, because central gears of a solution have the names of their links.
pub fn file(gearbox: &Gearbox, comment: &[String]) -> Result<String, NotWritable> {
    written(gearbox, comment)
}

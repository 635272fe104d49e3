//! Wheels that two pairs on fixed axes may share: an idler between them is bent both ways, but each pair is
//! rated alone.

use super::rated_set::RatedSet;
use crate::analyze::answer::analysis;
use crate::answer::Warning;
use crate::error::Error;
use crate::shared::gearbox::Gearbox;
use crate::tolerance::ROUNDED;
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::{LinkId, PlanetSet};

/// Symbol of the mean stress factor, in the factors of a gear.
const MEAN_STRESS: &str = "Y_M";

/// Warns of gears of two rated pairs that may be one wheel through which power passes.
pub(super) fn warnings(
    subject: &Gearbox,
    file: &GearboxFile,
    rated: &[RatedSet<'_>],
) -> Result<Vec<Warning>, Error> {
    let sets = subject.train.sets();
    let pairs: Vec<usize> = (0..sets.len())
        .filter(|place| sets[*place].is_pair() && rated.iter().any(|one| one.id == sets[*place].id()))
        .collect();
    if pairs.len() < 2 {
        return Ok(vec![]);
    }
    let torques = member_torques(subject)?;
    let mut all = vec![];
    for (index, &first) in pairs.iter().enumerate() {
        for &second in &pairs[index + 1..] {
            for (one, other) in alike(subject, &sets[first], &sets[second]) {
                // Torques of the two meshes against each other load opposite flanks.
                let passes = torques.iter().any(|of_sets| {
                    let of = |set: usize, gear: usize| of_sets[set].as_ref().map(|torques| torques[gear]);
                    of(first, one).zip(of(second, other)).is_some_and(|(one, other)| {
                        one.abs() > ROUNDED && other.abs() > ROUNDED && one * other < 0.0
                    })
                });
                let gears = [(&sets[first], one), (&sets[second], other)];
                if passes && !gears.iter().all(|(set, gear)| states_mean_stress(file, set, *gear)) {
                    all.push(warning(subject, file, gears));
                }
            }
        }
    }
    Ok(all)
}

/// Torques of the members of each set in each gear, over that of the input.
fn member_torques(subject: &Gearbox) -> Result<Vec<Vec<Option<Vec<f64>>>>, Error> {
    let of_gear = |name: &str| {
        let analysis = analysis(&subject.train, name)?;
        Ok(analysis.ideal().map(|case| case.members.clone()))
    };
    let all: Result<Vec<_>, Error> = subject.train.gears().iter().map(|gear| of_gear(gear.name())).collect();
    Ok(all?.into_iter().flatten().collect())
}

/// Gears of two pairs on one link that turns, alike in all that the file states of a wheel's teeth.
fn alike(subject: &Gearbox, first: &PlanetSet, second: &PlanetSet) -> Vec<(usize, usize)> {
    let is_alike = |&(one, other): &(usize, usize)| {
        let gears = [(first, one), (second, other)];
        let [link, its] = gears.map(|(set, gear)| set.members()[gear]);
        let [teeth, of_other] = gears.map(|(set, gear)| set.teeth(GearOf::Central(gear)));
        let [kind, its_kind] = gears.map(|(set, gear)| set.gear_kind(GearOf::Central(gear)));
        let [module, its_module] = [first, second].map(|set| subject.modules(set).first().copied().flatten());
        let same_module = module.zip(its_module).is_none_or(|(one, other)| one == other);
        link == its
            && link != LinkId::GROUND
            && teeth.is_some()
            && teeth == of_other
            && kind == its_kind
            && same_module
    };
    [(0, 0), (0, 1), (1, 0), (1, 1)].into_iter().filter(is_alike).collect()
}

/// Whether the file gives the mean stress factor of a gear of a pair.
fn states_mean_stress(file: &GearboxFile, set: &PlanetSet, gear: usize) -> bool {
    let Some(data) = file.set_data(set) else { return false };
    let factors = data.strength.map(|strength| &strength.gear_factors);
    let own = factors.and_then(|factors| factors.get(&data.gears.names[gear]));
    own.is_some_and(|own| own.contains_key(MEAN_STRESS))
}

fn warning(subject: &Gearbox, file: &GearboxFile, gears: [(&PlanetSet, usize); 2]) -> Warning {
    let name = |(set, gear): (&PlanetSet, usize)| {
        file.set_data(set).map_or_else(String::new, |data| data.gears.names[gear].clone())
    };
    let [one, other] = gears.map(name);
    let [first, second] = gears.map(|(set, _)| set.id());
    let link = subject.train.link_name(gears[0].0.members()[gears[0].1]);
    Warning {
        name: "idler",
        message: format!(
            "{one} of set `{first}` and {other} of set `{second}` have the same teeth on link {link}, and power passes from one to the other: if they are one wheel, its teeth are bent both ways, which the rating of each pair alone leaves out; write `gear_factors: {{ {one}: {{ {MEAN_STRESS}: 0.7 }} }}` and `gear_factors: {{ {other}: {{ {MEAN_STRESS}: 0.7 }} }}` under their `strength`, or 1 of two wheels"
        ),
    }
}

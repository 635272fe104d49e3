//! The toothed gears of a simple set as a file has them.

use crate::gearbox::Subject;
use crate::strength::place::refused;
use epicyclic_formats::gearbox::{GearboxFile, SetEntry};
use epicyclic_formats::{Number, Path};
use epicyclic_gears::Error;
use epicyclic_gears::involute::{InvoluteGear, PlanetSet, Profile};
use epicyclic_train as train;
use epicyclic_train::set::{SetKind, SetSpec};

/// Sun, planets and ring of a set at a place of the file, in mesh, the ring with the fillet of the rack that stands for its shaper; `None` where the file
/// does not say enough of them.
///
/// # Errors
/// [`Error::Document`](crate::Error::Document) at the shifts or the fillet.
pub(crate) fn gears(
    subject: &Subject<'_>,
    path: &Path,
    spec: &SetSpec,
    entry: &SetEntry,
) -> Result<Option<PlanetSet>, crate::Error> {
    let at = |keys: &'static [&str]| move |error: Error| refused(subject.document, path, keys, &error);
    let set = spec.toothed_set(&subject.rack).transpose().map_err(at(&["profile_shifts"]))?;
    let Some(set) = set else { return Ok(None) };
    let shaper = entry.strength.as_ref().and_then(|strength| strength.shaper.as_ref());
    match shaper.and_then(|shaper| shaper.fillet) {
        None => Ok(Some(set)),
        Some(fillet) => with_ring_fillet(&set, Number::get(fillet))
            .map(Some)
            .map_err(at(&["strength", "shaper", "fillet"])),
    }
}

fn with_ring_fillet(set: &PlanetSet, fillet: f64) -> Result<PlanetSet, Error> {
    let [sun, planet, ring] = set.gears();
    let profile = Profile { fillet, ..*ring.profile() };
    let ring = InvoluteGear::new(ring.kind(), ring.teeth(), profile, ring.shift())?
        .with_tip_alteration(ring.tip_alteration())?;
    PlanetSet::new([*sun, *planet, ring], set.planets(), set.centre_distance())
}

/// A simple set of a file: where it stands, its entry, its short description.
pub(crate) type SimpleSet<'g> = (Path, &'g SetEntry, &'g SetSpec);

/// The sets of a gearbox in their order, each with its entry in the file where it is simple.
pub(crate) fn simple_sets<'g>(
    subject: &'g Subject<'_>,
    file: &'g GearboxFile,
) -> impl Iterator<Item = (&'g train::PlanetSet, Option<SimpleSet<'g>>)> {
    subject.gearbox.sets().iter().map(|set| {
        let index = file.sets.iter().position(|entry| entry.id == set.id());
        let spec = set.short().filter(|spec| spec.kind == SetKind::Simple);
        let simple = index
            .zip(spec)
            .map(|(index, spec)| (Path::root().key("sets").index(index), &file.sets[index], spec));
        (set, simple)
    })
}

/// The keys that are not known.
pub(crate) fn lacking(known: &[(&str, bool)]) -> Vec<String> {
    known.iter().filter(|(_, is_known)| !is_known).map(|(key, _)| (*key).to_owned()).collect()
}

/// Which keys a set lacks that say its teeth.
pub(crate) const fn missing_teeth(entry: &SetEntry) -> &'static str {
    if entry.teeth.is_none() {
        "teeth"
    } else if entry.planet_teeth.is_none() {
        "planet_teeth"
    } else {
        "profile_shifts"
    }
}

//! Toothed gears of the sets of a file, in mesh.

use crate::shared::fault::refused;
use crate::shared::gearbox::Gearbox;
use epicyclic_formats::Path;
use epicyclic_formats::gearbox::{GearboxFile, SetData, SetEntry};
use epicyclic_gears::involute::PlanetSet;
use epicyclic_train as train;
use epicyclic_train::in_mesh::{InMesh, Unplaced};
use epicyclic_train::set::{SetKind, SetSpec};
use epicyclic_train::toothed::{ToothedSet, Untoothed};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;

/// Number of planets drawn if the file does not give it and so many have room.
pub(crate) const SHOWN: u32 = 3;

/// A set that is drawn without teeth or not at all.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct WithoutTeeth {
    /// Name of the set.
    pub set: String,
    /// Reason why its teeth are not drawn.
    pub why: String,
}

impl WithoutTeeth {
    pub(crate) fn new(set: &train::PlanetSet, why: &Unplaced) -> Self {
        Self { set: set.id().to_owned(), why: why.to_string() }
    }
}

/// The gears of a set as they are drawn in mesh; lengths in metres if the file states a module of the set,
/// otherwise in modules of its first mesh.
///
/// # Errors
/// [`Unplaced`].
pub(crate) fn in_mesh(subject: &Gearbox, set: &train::PlanetSet) -> Result<InMesh, Unplaced> {
    set.in_mesh(&set.toothed(&subject.rack, subject.modules(set))?, SHOWN)
}

/// Sun, planets and ring of a set at a place of the file, in mesh, as their tools leave them; `None` where
/// the file does not say enough of them.
///
/// # Errors
/// [`Error::Document`](crate::error::Error::Document) at the shifts.
pub(crate) fn gears(
    subject: &Gearbox,
    path: &Path,
    spec: &SetSpec,
) -> Result<Option<PlanetSet>, crate::error::Error> {
    spec.toothed_set(&subject.rack)
        .transpose()
        .map_err(|error| refused(&subject.document, path, &["profile_shifts"], &error))
}

/// The gears of a set of a file in mesh; the key of what is missing, or `None` of bevel gears.
///
/// # Errors
/// [`Error::Document`](crate::error::Error::Document) at the shifts.
pub(crate) fn toothed(
    subject: &Gearbox,
    data: &SetData<'_>,
    set: &train::PlanetSet,
) -> Result<Result<ToothedSet, Option<&'static str>>, crate::error::Error> {
    let modules: Vec<Option<f64>> = data.modules.iter().map(|module| module.map(Physical::si)).collect();
    Ok(match set.toothed(&subject.rack, &modules) {
        Ok(toothed) => Ok(toothed),
        Err(Untoothed::Teeth) => Err(Some("teeth")),
        Err(Untoothed::PlanetTeeth) => {
            Err(Some(if set.short().is_some() { "planet_teeth" } else { "planet_gears" }))
        }
        Err(Untoothed::Shifts) => Err(Some("profile_shifts")),
        Err(Untoothed::Bevel) => Err(None),
        Err(Untoothed::Refused(error)) => {
            return Err(refused(&subject.document, &data.path, &["profile_shifts"], &error));
        }
    })
}

/// A simple set of a file: its place, its entry, its short description.
pub(crate) type SimpleSet<'g> = (Path, &'g SetEntry, &'g SetSpec);

/// The sets of a gearbox in their order, each with its entry in the file where it is simple.
pub(crate) fn simple_sets<'g>(
    subject: &'g Gearbox,
    file: &'g GearboxFile,
) -> impl Iterator<Item = (&'g train::PlanetSet, Option<SimpleSet<'g>>)> {
    subject.train.sets().iter().map(|set| {
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

/// Key of the tooth data that a set lacks.
pub(crate) const fn missing_teeth(entry: &SetEntry) -> &'static str {
    if entry.teeth.is_none() {
        "teeth"
    } else if entry.planet_teeth.is_none() {
        "planet_teeth"
    } else {
        "profile_shifts"
    }
}

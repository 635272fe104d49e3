//! Toothed gears of the sets of a file, in mesh.

use crate::shared::fault::refused;
use crate::shared::gearbox::Gearbox;
use epicyclic_formats::Path;
use epicyclic_formats::gearbox::{GearboxFile, SetData, keys_of};
use epicyclic_train as train;
use epicyclic_train::in_mesh::{InMesh, Unplaced};
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

/// A planet whose centre is drawn at an assumed radius, since it meshes with other planets alone.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct AssumedRadius {
    /// Name of the set.
    pub set: String,
    /// Name of the planet.
    pub planet: String,
    /// Radius of its centre, in m; null if the file states no module.
    pub radius_m: Option<f64>,
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
    let mut toothed = set.toothed(&subject.rack, subject.modules(set))?;
    // Lengths of a file and of gears have one unit only if a module is stated.
    if toothed.radii.contains(&None)
        && subject.modules(set).iter().any(Option::is_some)
        && let Ok(file) = subject.document.read::<GearboxFile>()
        && let Some(data) = file.set_data(set)
    {
        for (radius, planet) in toothed.radii.iter_mut().zip(&data.planets) {
            *radius = radius.or(planet.carrier_radius.map(Physical::si));
        }
    }
    set.in_mesh(&toothed, subject.is_behind(set), SHOWN)
}

/// Error of teeth, at the key of the set that may hold its cause.
fn at_key(subject: &Gearbox, set: &Path, error: &epicyclic_gears::Error) -> crate::error::Error {
    let keys = keys_of(error).iter().find(|key| subject.document.has(&set.clone().key(**key)));
    refused(&subject.document, set, keys.map_or(&[], std::slice::from_ref), error)
}

/// The gears of a set of a file in mesh; the key of what is missing, or `None` of bevel gears.
///
/// # Errors
/// [`Error::Document`](crate::error::Error::Document) at the key that may hold the cause.
pub(crate) fn toothed(
    subject: &Gearbox,
    data: &SetData<'_>,
    set: &train::PlanetSet,
) -> Result<Result<ToothedSet, Option<&'static str>>, crate::error::Error> {
    let modules: Vec<Option<f64>> = data.modules.iter().map(|module| module.map(Physical::si)).collect();
    Ok(match set.toothed(&subject.rack, &modules) {
        Ok(toothed) => Ok(toothed),
        Err(Untoothed::Teeth | Untoothed::NoSet) => Err(Some("teeth")),
        Err(Untoothed::PlanetTeeth) => {
            Err(Some(if set.short().is_some() { "planet_teeth" } else { "planet_gears" }))
        }
        Err(Untoothed::Shifts) => Err(Some("profile_shifts")),
        Err(Untoothed::Bevel) => Err(None),
        Err(Untoothed::Refused(error)) => return Err(at_key(subject, &data.path, &error)),
    })
}

/// The keys that are not known.
pub(crate) fn lacking(known: &[(&str, bool)]) -> Vec<String> {
    known.iter().filter(|(_, is_known)| !is_known).map(|(key, _)| (*key).to_owned()).collect()
}

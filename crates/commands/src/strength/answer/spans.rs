//! Values of planet bearings that must be above 0.

use crate::error::Error;
use crate::shared::fault::{Named, refused};
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_formats::{Document, Path};
use epicyclic_units::Physical;

/// Refuses distances between the bearings of a planet that are not above 0, also where nothing is rated with
/// them.
///
/// # Errors
/// [`Error::Document`] with the place.
pub(super) fn check_spans(document: &Document, file: &GearboxFile) -> Result<(), Error> {
    let of_sets = file
        .sets
        .iter()
        .enumerate()
        .map(|(place, set)| (Path::root().key("sets").index(place), set.bearing_span));
    let of_planets = file.compound_sets.iter().enumerate().flat_map(|(place, set)| {
        let sizes = Path::root().key("compound_sets").index(place).key("planet_sizes");
        set.planet_sizes.iter().map(move |(name, size)| (sizes.clone().key(name), size.bearing_span))
    });
    for (path, span) in of_sets.chain(of_planets) {
        span.map_or(Ok(()), |span| above_0(document, span.0, &path, "bearing_span"))?;
    }
    Ok(())
}

/// Refuses a value of a key that is not above 0.
pub(super) fn above_0(
    document: &Document,
    value: impl Physical,
    path: &Path,
    key: &str,
) -> Result<(), Error> {
    if value.si() > 0.0 {
        return Ok(());
    }
    let why = Named("not-positive", format!("{key} must be above 0"));
    Err(refused(document, path, &[key], &why))
}

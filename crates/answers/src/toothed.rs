//! The toothed gears of a simple set as a file has them.

use epicyclic_formats::Number;
use epicyclic_formats::gearbox::SetEntry;
use epicyclic_gears::Error;
use epicyclic_gears::involute::{InvoluteGear, PlanetSet, Profile};
use epicyclic_gears::rack::BasicRack;
use epicyclic_train::set::SetSpec;

/// What keeps a set from its teeth.
#[derive(Debug)]
pub(crate) enum Fault {
    /// Its teeth and shifts.
    Teeth(Error),
    /// The fillet of the rack that stands for the shaper of its ring.
    Fillet(Error),
}

/// Sun, planets and ring in mesh, the ring with the fillet of the rack that stands for its shaper; `None` where the file does not say enough of them.
pub(crate) fn gears(spec: &SetSpec, entry: &SetEntry, rack: &BasicRack) -> Result<Option<PlanetSet>, Fault> {
    let Some(set) = spec.toothed_set(rack).transpose().map_err(Fault::Teeth)? else { return Ok(None) };
    let shaper = entry.strength.as_ref().and_then(|strength| strength.shaper.as_ref());
    match shaper.and_then(|shaper| shaper.fillet) {
        None => Ok(Some(set)),
        Some(fillet) => with_ring_fillet(&set, Number::get(fillet)).map(Some).map_err(Fault::Fillet),
    }
}

fn with_ring_fillet(set: &PlanetSet, fillet: f64) -> Result<PlanetSet, Error> {
    let [sun, planet, ring] = set.gears();
    let profile = Profile { fillet, ..*ring.profile() };
    let ring = InvoluteGear::new(ring.kind(), ring.teeth(), profile, ring.shift())?
        .with_tip_alteration(ring.tip_alteration())?;
    PlanetSet::new([*sun, *planet, ring], set.planets(), set.centre_distance())
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

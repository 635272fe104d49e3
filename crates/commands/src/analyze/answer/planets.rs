//! Planets over all gears: their largest speeds and the largest forces on their bearings.

use super::Worked;
use super::elements::largest;
use super::planet_bearings::PlanetBearing;
use super::records::planet_name;
use epicyclic_train::{Gearbox, PlanetSet};
use schemars::JsonSchema;
use serde::Serialize;

/// Planets of one kind over all gears.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct OverGears {
    /// The set.
    pub set: String,
    /// The planet: its name, or its number in the set.
    pub planet: String,
    /// Its largest speed relative to the carrier; of equal ones the first. `null` where it never turns there
    /// or no speed follows.
    pub largest_speed: Option<LargestSpeed>,
    /// The largest force on its bearing; of equal ones the first. `null` where none follows.
    pub largest_force: Option<LargestForce>,
}

/// The largest speed of a planet relative to its carrier.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LargestSpeed {
    /// In which gear.
    pub gear: String,
    /// Speed relative to the carrier, over the input's speed.
    pub relative_speed_of_input: f64,
    /// Speed relative to the carrier.
    pub relative_speed_rad_s: Option<f64>,
}

/// The largest force on a planet bearing: by all forces together where they follow, else by the tangential
/// one at the load, else by that at 1 N·m on the input.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LargestForce {
    /// In which gear.
    pub gear: String,
    /// Meshes and mass together.
    pub force_n: Option<f64>,
    /// Tangential force at the load.
    pub tangential_force_n: Option<f64>,
    /// Tangential force in N at 1 N·m on the input.
    pub tangential_force_n_per_input_n_m: Option<f64>,
}

impl LargestForce {
    /// Of the same planet's bearing in several gears.
    fn of(bearings: &[&PlanetBearing]) -> Option<Self> {
        let measures: [fn(&PlanetBearing) -> Option<f64>; 3] = [
            |bearing| bearing.force_n,
            |bearing| bearing.tangential_force_n,
            |bearing| bearing.tangential_force_n_per_input_n_m,
        ];
        let by = |measure: fn(&PlanetBearing) -> Option<f64>| {
            largest(bearings.iter().filter_map(|bearing| Some((measure(bearing)?, *bearing))))
        };
        let (_, found) = measures.into_iter().find_map(by)?;
        Some(Self {
            gear: found.gear.clone(),
            force_n: found.force_n,
            tangential_force_n: found.tangential_force_n,
            tangential_force_n_per_input_n_m: found.tangential_force_n_per_input_n_m,
        })
    }
}

impl OverGears {
    /// All planets of a gearbox; `bearings` are those of all its gears.
    pub(super) fn all(gearbox: &Gearbox, worked: &[Worked<'_>], bearings: &[PlanetBearing]) -> Vec<Self> {
        let of_set = |(place, set): (usize, &PlanetSet)| -> Vec<Self> {
            let of_planet = |planet: usize| {
                let speeds = worked.iter().filter_map(|worked| {
                    let motion = worked.analysis.sets().get(place)?;
                    Some((motion.planets.get(planet).copied().flatten()?.relative, worked))
                });
                let name = planet_name(set, planet);
                let own: Vec<&PlanetBearing> = bearings
                    .iter()
                    .filter(|bearing| bearing.set == set.id() && bearing.planet == name)
                    .collect();
                let speed = largest(speeds).map(|(relative, worked)| LargestSpeed {
                    gear: worked.analysis.gear().name().to_owned(),
                    relative_speed_of_input: relative,
                    relative_speed_rad_s: worked.speed_rad_s(Some(relative)),
                });
                Self {
                    set: set.id().to_owned(),
                    planet: name,
                    largest_speed: speed,
                    largest_force: LargestForce::of(&own),
                }
            };
            (0..set.planets().len()).map(of_planet).collect()
        };
        gearbox.sets().iter().enumerate().flat_map(of_set).collect()
    }
}

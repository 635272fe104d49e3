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
    /// Name of the set.
    pub set: String,
    /// Name of the planet, or its number in the set.
    pub planet: String,
    /// Largest speed relative to the carrier, the first of equal ones; null if the planet never turns there
    /// or no speed is known.
    pub largest_speed: Option<LargestSpeed>,
    /// Largest force on the bearing of the planet, the first of equal ones; null if no force can be computed.
    pub largest_force: Option<LargestForce>,
}

/// Largest planet speed relative to its carrier, over all gears.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LargestSpeed {
    /// Gear in which the speed occurs.
    pub gear: String,
    /// Planet speed relative to the carrier, relative to the input speed.
    pub relative_speed_of_input: f64,
    /// Planet speed relative to the carrier in rad/s; null if no input speed is given.
    pub relative_speed_rad_s: Option<f64>,
}

/// Largest force on a planet bearing over all gears. Gears are compared by the resultant force if known, else
/// by the tangential force at the load, else at an input torque of 1 N·m.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LargestForce {
    /// Gear in which the force occurs.
    pub gear: String,
    /// Resultant of mesh forces and centrifugal force, in N; null if unknown.
    pub force_n: Option<f64>,
    /// Tangential force at the given load, in N; null without a load.
    pub tangential_force_n: Option<f64>,
    /// Tangential force in N at an input torque of 1 N·m; null if unknown.
    pub tangential_force_n_per_input_n_m: Option<f64>,
}

impl LargestForce {
    /// Largest force on the bearing of one planet over several gears.
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
    /// Lists the planets of a gearbox; `bearings` holds the bearings of all gears.
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

//! Sizes of the sets of a gearbox, with what holds them: the summary on the first sheet of a report.

use crate::analyze::answer::records::planet_name;
use crate::error::Error;
use crate::shared::gearbox::Gearbox;
use crate::shared::toothed::toothed;
use crate::strength::answer::Strength;
use crate::strength::answer::materials::material;
use crate::strength::answer::records::{BearingOverDuty, Governing};
use epicyclic_formats::gearbox::{GearboxFile, SetData};
use epicyclic_gears::geometry::GearKind;
use epicyclic_strength::rating::Place;
use epicyclic_strength::sizing::structure;
use epicyclic_train::PlanetSet;
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::toothed::ToothedSet;
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::FRAC_PI_4;

/// Sizes of a set. Lists have each value once, in the order of the gears.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SetSizes {
    /// Name of the set.
    pub set: String,
    /// Tooth numbers of the gears.
    pub teeth: Vec<f64>,
    /// Number of planets; null if the file does not give it.
    pub planets: Option<u32>,
    /// Modules in m.
    pub modules_m: Vec<f64>,
    /// Face widths in m; empty if the file does not give that of every gear.
    pub face_widths_m: Vec<f64>,
    /// Outside diameter of the largest ring with its rim in m, or of the circle that tips of planets reach to where
    /// that is larger; null without a ring, or without its rim.
    pub ring_diameter_m: Option<f64>,
    /// Mass of the gears in kg; null if a face width, the number of planets or the rim of a ring is missing.
    pub mass_kg: Option<f64>,
    /// Mass of carrier and housing, by a rule, in kg; null where the rim of the ring is not given, or with several
    /// face widths.
    pub structure_kg: Option<f64>,
    /// Bearings of the planets; empty without load ratings.
    pub bearings: Vec<SizedBearing>,
    /// Least safety of the flanks; null if none is rated.
    pub flank: Option<Governing>,
    /// Least safety of the roots; null if none is rated.
    pub root: Option<Governing>,
}

/// Bearing of a planet.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SizedBearing {
    /// Name of the planet, or its number in the set.
    pub planet: String,
    /// Kind of the bearing: balls, rollers, needles, `full_complement`, plain.
    pub rolling: &'static str,
    /// Basic dynamic load rating in N; of a plain bearing the load that it may bear.
    pub load_rating_n: f64,
    /// Life over the duty in s, the modified one if it is known; null without a duty.
    pub life_s: Option<f64>,
}

/// Sizes of the sets whose module the file gives.
///
/// # Errors
/// [`Error::Document`] for invalid data in the file, with the place.
pub(super) fn answer(subject: &Gearbox, strength: &[Strength]) -> Result<Vec<SetSizes>, Error> {
    if subject.document.value().get("transmissions").is_some() {
        return Ok(vec![]);
    }
    let file: GearboxFile = subject.document.read()?;
    let mut all = vec![];
    for set in subject.train.sets() {
        let Some(data) = file.set_data(set).filter(|data| data.modules.iter().any(Option::is_some)) else {
            continue;
        };
        if let Ok(toothed) = toothed(subject, &data, set)? {
            let density = |place| density(subject, &file, &data, place);
            let densities = (0..data.of.len()).map(density).collect::<Result<Vec<f64>, Error>>()?;
            all.push(SetSizes::of((set, &data, &toothed), &densities, strength));
        }
    }
    Ok(all)
}

/// Density of a gear in kg/m³: that of the gearbox if it is stated, else that of its material.
fn density(subject: &Gearbox, file: &GearboxFile, data: &SetData<'_>, place: usize) -> Result<f64, Error> {
    let name = data.strength.and_then(|strength| data.of_gears(&strength.materials)[place]);
    Ok(match name.filter(|_| file.density.is_none()) {
        Some(name) => material(subject, file, &data.path, name)?.density.si(),
        None => file.gear_density().si(),
    })
}

impl SetSizes {
    fn of(
        (set, data, toothed): (&PlanetSet, &SetData<'_>, &ToothedSet),
        densities: &[f64],
        strength: &[Strength],
    ) -> Self {
        let planets = if set.is_pair() { Some(1) } else { set.planet_count() };
        let widths: Option<Vec<f64>> = data.face_widths.iter().map(|width| width.map(Physical::si)).collect();
        let widths = widths.unwrap_or_default();
        let gears: Vec<SizedGear> =
            (0..data.of.len()).filter_map(|place| SizedGear::of((data, toothed), place)).collect();
        let of_gear = |((gear, width), density): ((&SizedGear, &f64), &f64)| {
            Some(gear.count(planets?) * gear.area()? * width * density)
        };
        let masses = gears.iter().zip(&widths).zip(densities).map(of_gear);
        let mass_kg = masses.sum::<Option<f64>>().filter(|_| !widths.is_empty());
        let swept = |(place, of): (usize, &GearOf)| match of {
            GearOf::Planet(planet, _) => {
                Some(2.0 * toothed.radii[*planet]? + gears.get(place)?.tip_diameter_m)
            }
            GearOf::Central(_) => None,
        };
        let reach = || data.of.iter().enumerate().filter_map(swept).fold(0.0, f64::max);
        let ring_diameter_m = gears.iter().filter_map(|gear| gear.ring_diameter_m).reduce(f64::max);
        let ring_diameter_m = ring_diameter_m.map(|ring| ring.max(reach()));
        let face_widths_m = each_once(widths.iter().copied());
        // Without a ring the housing is around the largest gear.
        let has_ring = gears.iter().any(|gear| gear.is_ring);
        let tips = gears.iter().map(|gear| gear.tip_diameter_m).reduce(f64::max);
        let outside = if has_ring { ring_diameter_m } else { tips };
        let structure_kg = match (outside, &face_widths_m[..]) {
            (Some(outside), [width]) => Some(structure(outside, *width)),
            _ => None,
        };
        let least = |place: Place| {
            let own = strength.iter().flat_map(Strength::safeties);
            let own = own.filter(|one| one.set == set.id() && one.place == place);
            own.min_by(|one, other| one.safety.total_cmp(&other.safety))
        };
        let bearing = |(place, planet): (usize, &epicyclic_formats::gearbox::PlanetData)| {
            let name = planet_name(set, place);
            let over_duty = strength.iter().flat_map(|one| &one.bearings);
            let own = over_duty.filter(|one| one.set == set.id() && one.planet == name);
            let (rating, rolling) = planet.bearing?;
            Some(SizedBearing {
                rolling: rolling.name(),
                load_rating_n: rating.si(),
                life_s: own.filter_map(BearingOverDuty::life_s).reduce(f64::min),
                planet: name,
            })
        };
        Self {
            set: set.id().to_owned(),
            teeth: data.of.iter().filter_map(|gear| set.teeth_or_coaxial(*gear)).collect(),
            planets: set.planet_count(),
            modules_m: each_once(toothed.meshes.iter().map(|mesh| mesh.module)),
            face_widths_m,
            ring_diameter_m,
            mass_kg,
            structure_kg,
            bearings: data.planets.iter().enumerate().filter_map(bearing).collect(),
            flank: least(Place::Flank),
            root: least(Place::Root),
        }
    }
}

/// Gear with what its mass needs.
struct SizedGear {
    is_planet: bool,
    is_ring: bool,
    /// Area within the outline of the teeth in m², of external gears less the bore.
    outline_m2: f64,
    /// Outside diameter of a ring in m, if its rim is stated.
    ring_diameter_m: Option<f64>,
    tip_diameter_m: f64,
}

impl SizedGear {
    fn of((data, toothed): (&SetData<'_>, &ToothedSet), place: usize) -> Option<Self> {
        let of = data.of[place];
        let gear = toothed.gear(of)?;
        let module = toothed.meshes.iter().find(|mesh| mesh.gears.contains(&of))?.module;
        let is_ring = gear.kind() == GearKind::Internal;
        // Rims of planets lie inside the outline, and their bores are known.
        let strength = data.strength.filter(|_| is_ring);
        let rim = strength.and_then(|of| of.rims.get(&data.gears.names[place]).copied().or(of.ring_rim));
        let bore = data.bores[place].map_or(0.0, Physical::si);
        Some(Self {
            is_planet: matches!(of, GearOf::Planet(..)),
            is_ring,
            outline_m2: gear.filled_area() * module.powi(2) - FRAC_PI_4 * bore.powi(2),
            ring_diameter_m: rim.map(|rim| gear.root_diameter() * module + 2.0 * rim.0.si()),
            tip_diameter_m: gear.tip_diameter() * module,
        })
    }

    fn count(&self, planets: u32) -> f64 {
        if self.is_planet { f64::from(planets) } else { 1.0 }
    }

    /// Area of the material in m²; `None` of a ring without a stated rim.
    fn area(&self) -> Option<f64> {
        if self.is_ring {
            return self.ring_diameter_m.map(|outside| FRAC_PI_4 * outside.powi(2) - self.outline_m2);
        }
        Some(self.outline_m2)
    }
}

/// Values without repetitions, in their order.
fn each_once(values: impl Iterator<Item = f64>) -> Vec<f64> {
    values.fold(vec![], |mut all, value| {
        if !all.contains(&value) {
            all.push(value);
        }
        all
    })
}

//! Planetary sets: tooth numbers, ratios, planets, and whether these fit.

use super::records::Kind;
use crate::shared::gearbox::Gearbox;
use crate::shared::records::Fraction;
use epicyclic_train::PlanetSet;
use epicyclic_train::compound::CentralKind;
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::tooth_checks::PlanetFit;
use schemars::JsonSchema;
use serde::Serialize;

/// Planetary set as its file describes it, for all gears.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SetFacts {
    /// Name of the set.
    pub set: String,
    /// Kind of the set.
    pub kind: Kind,
    /// Gears of the set with their tooth numbers, central gears first.
    pub gears: Vec<TeethOf>,
    /// Basic ratio i₀ of a set with two central gears: with the carrier fixed, speed of the first over that
    /// of the second. Otherwise null.
    pub basic_ratio: Option<f64>,
    /// Exact basic ratio as a fraction; null unless the tooth numbers are known.
    pub exact_ratio: Option<Fraction>,
    /// Efficiency with the carrier fixed; null for more than two central gears.
    pub efficiency: Option<f64>,
    /// Number of planets of each kind; null if the file does not give it.
    pub planets: Option<u32>,
    /// Whether the planets can be assembled at their angles, which are equal unless the file gives others.
    pub assembly: Fit,
    /// Whether the tip circles of neighbouring planets clear each other, with the given profile shifts.
    pub clearance: Fit,
}

/// Gear of a set with its tooth number.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TeethOf {
    /// Name of the gear: `sun`, `ring`, `planet`; followed by its own name if the set has several of a kind.
    pub gear: String,
    /// Tooth number; null if unknown. For the planet of a simple set it follows from equal centre distances,
    /// and may then end in one half.
    pub teeth: Option<f64>,
}

/// Results of a check whether parts fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Fit {
    /// Fits.
    Yes,
    /// Does not fit.
    No,
    /// Not checked: the number of planets is not given.
    PlanetsNotGiven,
    /// Not checked: tooth numbers are not given.
    TeethNotGiven,
    /// Not checked: the positions of the planets do not follow from their tooth numbers, as for bevel gears
    /// and planets with a shaft of their own.
    NotChecked,
    /// Gears on fixed axes, without planets.
    NoPlanets,
}

impl SetFacts {
    /// Lists the sets of a gearbox in their order.
    pub(super) fn all(subject: &Gearbox) -> Vec<Self> {
        subject.train.sets().iter().map(|set| Self::of(set, subject)).collect()
    }

    fn of(set: &PlanetSet, subject: &Gearbox) -> Self {
        let PlanetFit { assembles, clears } = set.planet_fit(&subject.rack);
        // With more than two central gears no single number describes the set.
        let has_two = set.short().is_some();
        let gears = gears_of(set);
        let lacks_teeth = gears.iter().any(|gear| gear.teeth.is_none());
        let fit = |found: Option<bool>| match found {
            Some(true) => Fit::Yes,
            Some(false) => Fit::No,
            None if set.is_pair() => Fit::NoPlanets,
            None if set.planet_count().is_none() => Fit::PlanetsNotGiven,
            None if lacks_teeth => Fit::TeethNotGiven,
            None => Fit::NotChecked,
        };
        Self {
            set: set.id().to_owned(),
            kind: Kind::of(set),
            basic_ratio: has_two.then(|| set.basic_ratio().get()),
            exact_ratio: set.exact_ratio().filter(|_| has_two).map(Fraction::of),
            efficiency: has_two.then(|| set.efficiency()),
            planets: set.planet_count(),
            assembly: fit(assembles),
            clearance: fit(clears),
            gears,
        }
    }
}

fn gears_of(set: &PlanetSet) -> Vec<TeethOf> {
    let is_gear = |central: &usize| set.centrals()[*central].kind != CentralKind::PlanetShaft;
    let centrals = (0..set.centrals().len()).filter(is_gear).map(GearOf::Central);
    let planets = set.planets().iter().enumerate();
    let planets =
        planets.flat_map(|(planet, one)| (0..one.gears.len()).map(move |gear| GearOf::Planet(planet, gear)));
    let all = centrals.chain(planets);
    all.map(|gear| TeethOf { gear: set.gear_name(gear), teeth: set.teeth_or_coaxial(gear) }).collect()
}

//! What the planet sets are: teeth, ratios, planets, and whether these fit.

use super::records::Kind;
use crate::shared::gearbox::Subject;
use crate::shared::records::Fraction;
use epicyclic_train::PlanetSet;
use epicyclic_train::compound::CentralKind;
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::tooth_checks::PlanetFit;
use schemars::JsonSchema;
use serde::Serialize;

/// A planet set as its file describes it, the same in all gears.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SetFacts {
    /// Its name.
    pub set: String,
    /// How it is made.
    pub kind: Kind,
    /// Its gears with their teeth, central gears first.
    pub gears: Vec<TeethOf>,
    /// Basic ratio i₀ of a set with two central gears: with the carrier fixed, speed of the first over that
    /// of the second.
    pub basic_ratio: Option<f64>,
    /// The same, exactly, where the teeth are known.
    pub exact_ratio: Option<Fraction>,
    /// Efficiency with the carrier fixed, of a set with two central gears.
    pub efficiency: Option<f64>,
    /// How many planets of each kind there are; `null` where the file does not say it.
    pub planets: Option<u32>,
    /// Whether the planets can be assembled at their angles, which are equal unless the file states others.
    pub assembly: Fit,
    /// Whether the tip circles of neighbours clear each other, with the profile shifts that are stated.
    pub clearance: Fit,
}

/// A gear of a set.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TeethOf {
    /// What it is called: `sun`, `ring`, `planet`, with its name where a set has several of a kind.
    pub gear: String,
    /// Its teeth; `null` where they are not known. The planet of a simple set has those that equal centre
    /// distances leave it, if need be with half a tooth.
    pub teeth: Option<f64>,
}

/// Whether something fits, or why that is not known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Fit {
    /// It does.
    Yes,
    /// It does not.
    No,
    /// Not checked: the number of planets is not given.
    PlanetsNotGiven,
    /// Not checked: teeth are not given.
    TeethNotGiven,
    /// Not checked: where the planets stand does not follow from their teeth, as of bevel gears and planets
    /// with a shaft of their own.
    NotChecked,
    /// Gears on fixed axes: there are no planets.
    NoPlanets,
}

impl SetFacts {
    /// The sets of a gearbox in their order.
    pub(super) fn all(subject: &Subject<'_>) -> Vec<Self> {
        subject.gearbox.sets().iter().map(|set| Self::of(set, subject)).collect()
    }

    fn of(set: &PlanetSet, subject: &Subject<'_>) -> Self {
        let PlanetFit { assembles, clears } = set.planet_fit(&subject.rack);
        // Of a set with more than two central gears no one number says it.
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

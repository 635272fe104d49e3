//! Tooth numbers of a solution.

use super::gear::WantedGear;
use super::{Kept, saved};
use crate::error::Error;
use crate::shared::profile_shift::WantedShifts;
use crate::shared::records::Fraction;
use crate::shared::tooth_checks::answer::TeethLeftOut;
use crate::teeth::answer::shifted::{RequiredShifts, SetShifts};
use epicyclic_gears::ToothCount;
use epicyclic_gears::involute::search::ProfileShift;
use epicyclic_gears::synthesis::Bounds as ToothBounds;
use epicyclic_synthesis::Structure;
use epicyclic_synthesis::judge::planet_speed;
use epicyclic_synthesis::parts::Bounds;
use epicyclic_synthesis::teeth::{Aim, Alike, Choice, Design, Gears, SetTeeth, Sets, designs};
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::RangeInclusive;

/// Requirements of the tooth numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct TeethWanted {
    /// Limits of tooth numbers and numbers of planets. For a double-planet set they apply to each of its two
    /// planets and to the number of pairs. The `k` are those of the search.
    pub bounds: ToothBounds,
    /// Profile shifts of the simple sets; `None` for sets without. Double-planet sets have no profile shift.
    pub shifts: Option<WantedShifts>,
    /// Minimum number of equal sets.
    pub alike: Alike,
    /// Objective for the choice of tooth numbers.
    pub aim: Aim,
    /// Maximum number of choices listed for each solution.
    pub most: usize,
}

/// Tooth numbers within the tolerances of a solution.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Teeth {
    /// Number of choices of tooth numbers. Choices that differ only in the numbers of planets, or in the
    /// planets of double-planet sets, count as one.
    pub found: u64,
    /// Whether all choices were counted; the count stops at a large limit.
    pub complete: bool,
    /// Requirements of the profile shifts; absent for sets without profile shift.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub profile_shift: Option<RequiredShifts>,
    /// Best choices, the best first.
    pub choices: Vec<TeethOfSets>,
}

/// Tooth numbers of all sets.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TeethOfSets {
    /// Tooth numbers of each set.
    pub sets: Vec<TeethOfSet>,
    /// Exact ratio of each gear as a fraction.
    pub ratios: Vec<Fraction>,
    /// Largest relative deviation of a ratio from the required one; 0 if only ranges are required.
    pub greatest_deviation: f64,
    /// Greatest planet speed relative to its carrier in a gear with these tooth numbers, relative to the
    /// input speed.
    pub greatest_planet_speed: f64,
}

/// Tooth numbers of a set.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TeethOfSet {
    /// Tooth number of the sun.
    pub sun: u32,
    /// Tooth number of a planet; for a double-planet set that of the planet in mesh with the sun.
    pub planet: u32,
    /// Tooth number of the planet in mesh with the ring of a double-planet set; absent for a simple set.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outer_planet: Option<u32>,
    /// Tooth number of the ring.
    pub ring: u32,
    /// Maximum number of planets, for a double-planet set of pairs, that can be assembled equally spaced and
    /// clear each other.
    pub planets: u32,
    /// Profile shifts of the set; absent for a set without.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shifts: Option<SetShifts>,
}

impl TeethWanted {
    /// Profile shift of the simple sets that gives equal centre distances; `None` for sets without.
    pub(super) fn shift(&self) -> Option<ProfileShift> {
        Some(self.shifts.as_ref()?.within(&self.bounds))
    }
}

/// Tooth numbers from which sets can choose.
pub(super) struct Choices {
    simple: Choice,
    double_planet: Option<Choice>,
}

impl Choices {
    /// Choices for the requirements; for double-planet sets with `k` in this range, if such sets are
    /// searched.
    pub(super) fn wanted(teeth: &TeethWanted, k_double: Option<RangeInclusive<f64>>) -> Result<Self, Error> {
        let of_double_planets = |k| {
            let bounds = ToothBounds { ring_to_sun_ratio: k, ..teeth.bounds.clone() };
            Choice::of_double_planets(&bounds)
        };
        let double_planet = k_double.map(of_double_planets).transpose()?;
        let simple = match teeth.shift() {
            Some(shift) => Choice::shifted(&teeth.bounds, &shift)?,
            None => Choice::within(&teeth.bounds)?,
        };
        Ok(Self { simple, double_planet })
    }

    /// Pairs of sun and ring left out because a tooth check fails.
    pub(super) fn left_out(&self) -> Vec<TeethLeftOut> {
        let all = [Some(&self.simple), self.double_planet.as_ref()];
        all.into_iter().flatten().filter_map(Choice::left_out).map(TeethLeftOut::of).collect()
    }

    /// Choices for each set of a structure.
    fn of(&self, structure: &Structure) -> Vec<&Choice> {
        let of = |place: usize| match &self.double_planet {
            Some(choice) if structure.is_double_planet(place) => choice,
            _ => &self.simple,
        };
        (0..structure.sets().len()).map(of).collect()
    }
}

impl Teeth {
    /// Tooth numbers of a solution, with these ranges of `k` for each set (`k′` for a double-planet set).
    /// Neighbouring free gears are given by their places among the gears. Returns the best choices in the
    /// form of the search as well.
    ///
    /// # Errors
    /// [`Contradiction`](epicyclic_synthesis::Error::Contradiction) if the solver's fraction of a ratio
    /// differs from that of the search; otherwise errors of the solver. None are known for tooth numbers of a
    /// search.
    pub(super) fn of(
        kept: &Kept,
        gears: &[WantedGear],
        side_by_side: &[Vec<usize>],
        k: &[RangeInclusive<f64>],
        choices: &Choices,
        teeth: &TeethWanted,
        ended: &dyn Fn() -> bool,
    ) -> Result<(Self, Vec<Design>), Error> {
        let structure = &kept.found.structure;
        let solution = &kept.found.solution;
        let mut ratios: Vec<_> = solution.gears.iter().map(|gear| gear.ratio).collect();
        let mut bounds: Vec<_> = gears.iter().map(WantedGear::bounds).collect();
        // Equal k must also be equal exactly as ratios of tooth numbers.
        ratios.extend(solution.equal.ratios());
        bounds.resize(ratios.len(), Bounds { least: 1.0, most: 1.0 });
        let choices = choices.of(structure);
        let wanted = Gears { bounds: &bounds, side_by_side };
        let compounds = &kept.judged.sharing.compounds;
        let sets = Sets { choices: &choices, compounds, bounds: Some(&teeth.bounds) };
        let mut all = designs(&ratios, wanted, k, sets, (teeth.alike, teeth.aim, teeth.most), ended);
        all.first.iter_mut().for_each(|design| design.ratios.truncate(gears.len()));
        let told = all.first.iter().map(|design| TeethOfSets::of(kept, design, gears));
        let choices = told.collect::<Result<_, _>>()?;
        let profile_shift = teeth.shifts.as_ref().map(RequiredShifts::of);
        Ok((Self { found: all.count, complete: all.complete, profile_shift, choices }, all.first))
    }
}

impl TeethOfSets {
    fn of(kept: &Kept, design: &Design, wanted: &[WantedGear]) -> Result<Self, Error> {
        let deviation = |(ratio, wanted): (&epicyclic_gears::simple_set::Fraction, &WantedGear)| {
            let wanted = wanted.wanted_ratio?;
            Some((*ratio.numer() as f64 / *ratio.denom() as f64 / wanted - 1.0).abs())
        };
        let gearbox = saved::gearbox(kept, "", Some(design))?;
        let mut greatest_planet_speed: f64 = 0.0;
        for (gear, ratio) in gearbox.gears().iter().zip(&design.ratios) {
            let analysis = gearbox.analyze_gear(gear)?;
            let by_solver = analysis.exact_ratio();
            if by_solver.as_ref() != Some(ratio) {
                let structure = kept.found.structure.to_string();
                let why =
                    format!("gear {} is {ratio} by its teeth, {by_solver:?} by the solver", gear.name());
                return Err(epicyclic_synthesis::Error::Contradiction { structure, why }.into());
            }
            greatest_planet_speed = greatest_planet_speed.max(planet_speed(&analysis));
        }
        Ok(Self {
            sets: design.sets.iter().zip(saved::shifts(kept, Some(design))?).map(TeethOfSet::of).collect(),
            ratios: design.ratios.iter().map(|ratio| Fraction::of(*ratio)).collect(),
            greatest_deviation: design.ratios.iter().zip(wanted).filter_map(deviation).fold(0.0, f64::max),
            greatest_planet_speed,
        })
    }
}

impl TeethOfSet {
    fn of((set, shifts): (&SetTeeth, Option<SetShifts>)) -> Self {
        let (planet, outer_planet, planets) = match set {
            SetTeeth::Simple(of) => (of.planet, None, of.planets),
            SetTeeth::DoublePlanet(of) => (of.inner, Some(of.outer.get()), of.pairs),
        };
        let [sun, planet, ring] = [set.sun(), planet, set.ring()].map(ToothCount::get);
        Self { sun, planet, outer_planet, ring, planets, shifts }
    }
}

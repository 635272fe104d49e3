//! Records of the steps of a design.

use crate::select::answer::Select;
use crate::select::answer::candidate::Candidate;
use crate::select::answer::required::{Brakes, Objective, RatioSigns, Required};
use crate::select::answer::teeth;
use crate::shared::catalogue::KRange;
use crate::size::answer::Size;
use crate::size::answer::records::{Governing, SizedSet};
use epicyclic_selection::Mechanism;
use schemars::JsonSchema;
use serde::Serialize;

/// A key of what no speed tells.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct BasisKey {
    /// The key; those of a set begin with `strength.`.
    pub key: String,
    /// Its value as the file has it, in one line.
    pub value: String,
}

/// What a scheme is held against.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Criteria {
    /// Ratios of the braked gears that are wanted.
    pub ratios: Vec<f64>,
    /// How far a ratio may be off, as a share of it.
    pub tolerance: f64,
    /// Which brake gives which ratio.
    pub brakes: Brakes,
    /// Which signs the ratios may have.
    pub signs: RatioSigns,
    /// Which objective decides first, and which next.
    pub order: Vec<Objective>,
    /// Ring-to-sun ratios allowed.
    pub k: KRange,
    /// Ring-to-sun ratios preferred.
    pub preferred_k: KRange,
    /// Efficiency of each set with its carrier fixed.
    pub set_efficiency: f64,
    /// Least efficiency of a gear.
    pub least_efficiency: f64,
    /// Greatest speed of a link over the input's; `null` without limit.
    pub greatest_link_speed_of_input: Option<f64>,
    /// Greatest speed of a planet relative to its carrier over the input's; `null` without limit.
    pub greatest_planet_speed_of_input: Option<f64>,
    /// Greatest slip of the open direct-drive clutch over the input's speed; `null` without limit.
    pub greatest_clutch_slip_of_input: Option<f64>,
    /// Greatest circulating power over what enters; `null` without limit.
    pub greatest_circulating_of_entering: Option<f64>,
    /// Whether the output must turn one way in all gears.
    pub same_direction: bool,
    /// Whether the scheme must be drawable.
    pub drawable: bool,
}

impl Criteria {
    fn of(required: &Required) -> Self {
        let of = required.clone();
        Self {
            ratios: of.ratios,
            tolerance: of.tolerance,
            brakes: of.brakes,
            signs: of.signs,
            order: of.order,
            k: of.k,
            preferred_k: of.preferred_k,
            set_efficiency: of.set_efficiency,
            least_efficiency: of.least_efficiency,
            greatest_link_speed_of_input: of.greatest_link_speed_of_input,
            greatest_planet_speed_of_input: of.greatest_planet_speed_of_input,
            greatest_clutch_slip_of_input: of.greatest_clutch_slip_of_input,
            greatest_circulating_of_entering: of.greatest_circulating_of_entering,
            same_direction: of.same_direction,
            drawable: of.drawable,
        }
    }
}

/// The scheme.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SchemeStep {
    /// Whether it was asked for; otherwise it is the best of the order.
    pub asked_for: bool,
    /// The one taken: the source's name, or that of the structure; `null` where none meets the criteria.
    pub taken: Option<String>,
    /// What the criteria are.
    pub criteria: Criteria,
    /// How many were compared.
    pub compared: usize,
    /// How many of them meet the criteria.
    pub accepted: usize,
    /// The objective by which it is ahead of others; `null` where there are none, or all are equal.
    pub decided_by: Option<Objective>,
    /// Ring-to-sun ratios of its sets that give the ratios exactly.
    pub k: Vec<f64>,
    /// Those that come before it and have no tooth numbers with sizes that hold.
    pub passed_over: Vec<String>,
    /// The next one that meets the criteria; `null` where there is none.
    pub next: Option<String>,
}

impl SchemeStep {
    /// Of all candidates: the mechanism taken, and those before it that have no sizes.
    pub(super) fn of(
        selection: &Select,
        taken: Option<Mechanism>,
        passed_over: &[Mechanism],
        asked_for: bool,
    ) -> Self {
        let name = |one: &Candidate| one.scheme.unwrap_or(&one.structure).to_owned();
        let accepted = || selection.candidates.iter().filter(|one| one.accepted);
        let of = |mechanism: &Mechanism| {
            let structure = mechanism.to_string();
            accepted().find(|one| one.structure == structure)
        };
        let first = taken.as_ref().and_then(of);
        let passed_over: Vec<String> = passed_over.iter().filter_map(of).map(name).collect();
        let taken = first.map(name);
        let is_left = |name: &String| Some(name) != taken.as_ref() && !passed_over.contains(name);
        Self {
            asked_for,
            criteria: Criteria::of(&selection.required),
            compared: selection.accepted + selection.rejected,
            accepted: selection.accepted,
            decided_by: selection.decided_by,
            k: first.iter().flat_map(|first| &first.sets).map(|set| set.k).collect(),
            next: accepted().map(name).find(is_left),
            taken,
            passed_over,
        }
    }
}

/// The tooth numbers.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TeethStep {
    /// Largest deviation of the designs compared by mass: a part of the tolerance, or all of it.
    pub tolerance: f64,
    /// Pairs of tooth numbers, or tooth numbers of one set, within it that meet the criteria.
    pub accepted: u64,
    /// Of how many the sizes were sought.
    pub tried: usize,
    /// The one taken; `null` where there is none, or not so many.
    pub taken: Option<TeethTaken>,
    /// The next best of those tried; `null` where there is none.
    pub next: Option<TeethTaken>,
}

/// Tooth numbers of all sets.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TeethTaken {
    /// The number of the design, from 1: the least class of deviation first, then the smallest ring at one
    /// load of the teeth.
    pub number: usize,
    /// Mass of its gears; `null` where a set has no size.
    pub mass_kg: Option<f64>,
    /// Teeth of sun, planet and ring of each set.
    pub sets: Vec<[u32; 3]>,
    /// Ratios of the braked gears.
    pub ratios: Vec<f64>,
}

impl TeethTaken {
    /// Of a design without sizes, by its number.
    pub(super) fn of(design: &teeth::Design, number: usize) -> Self {
        Self {
            number,
            mass_kg: None,
            sets: design.tooth_numbers.iter().map(|set| [set.sun, set.planet, set.ring]).collect(),
            ratios: design.candidate.gears.iter().map(|gear| gear.ratio).collect(),
        }
    }
}

/// The sizes.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SizesStep {
    /// Designs of all sets together.
    pub designs: u64,
    /// Mass of the best designs of all sets; `null` where one has none.
    pub mass_kg: Option<f64>,
    /// The sets, with the safeties of their teeth over the duty.
    pub sets: Vec<SizedSet>,
    /// The set whose requirement is met least, and this requirement; `null` where a set has no size.
    pub governing: Option<GoverningSet>,
}

/// The requirement that a gearbox meets least.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GoverningSet {
    /// The set.
    pub set: String,
    /// What governs it.
    pub requirement: Governing,
}

impl SizesStep {
    pub(super) fn of(size: Size) -> Self {
        let best: Option<Vec<GoverningSet>> = size
            .sets
            .iter()
            .map(|set| {
                let requirement = set.found.first()?.governing;
                Some(GoverningSet { set: set.set.clone(), requirement })
            })
            .collect();
        let ratio = |one: &GoverningSet| one.requirement.value / one.requirement.required;
        let governing =
            best.and_then(|all| all.into_iter().min_by(|one, other| ratio(one).total_cmp(&ratio(other))));
        Self { designs: size.designs, mass_kg: size.mass_kg, sets: size.sets, governing }
    }
}

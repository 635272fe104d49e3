//! Records of the steps of a design.

use crate::select::answer::Select;
use crate::select::answer::candidate::Candidate;
use crate::select::answer::required::{Objective, Required};
use crate::select::answer::teeth;
use crate::shared::catalogue::KRange;
use crate::shared::judgement::answer::Judgement;
use crate::size::answer::Size;
use crate::size::answer::records::{Governing, SizedSet};
use epicyclic_selection::Mechanism;
use epicyclic_selection::{Orders, Signs};
use schemars::JsonSchema;
use serde::Serialize;

/// Criteria for schemes.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Criteria {
    /// Required ratios of the braked gears.
    pub ratios: Vec<f64>,
    /// Allowed relative deviation of a ratio.
    pub tolerance: f64,
    /// Assignment of brakes to ratios.
    pub brakes: Orders,
    /// Allowed signs of the ratios.
    pub signs: Signs,
    /// Objectives in the order in which they decide.
    pub order: Vec<Objective>,
    /// Allowed range of ring-to-sun ratios.
    pub k: KRange,
    /// Preferred range of ring-to-sun ratios.
    pub preferred_k: KRange,
    /// Efficiency of each set with its carrier fixed.
    pub set_efficiency: f64,
    /// Minimum efficiency of a gear.
    pub least_efficiency: f64,
    /// Maximum speed of a link relative to the input speed; null without limit.
    pub greatest_link_speed_of_input: Option<f64>,
    /// Maximum planet speed relative to the carrier, relative to the input speed; null without limit.
    pub greatest_planet_speed_of_input: Option<f64>,
    /// Maximum slip of the open direct-drive clutch relative to the input speed; null without limit.
    pub greatest_clutch_slip_of_input: Option<f64>,
    /// Maximum circulating power relative to the entering power; null without limit.
    pub greatest_circulating_of_entering: Option<f64>,
    /// Whether the output must turn in the same direction in all gears.
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

/// Choice of the scheme.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SchemeStep {
    /// Whether the scheme was asked for; otherwise it is the best by the order of objectives.
    pub asked_for: bool,
    /// Chosen scheme: its name in the source, or that of its structure. Null if none meets the criteria.
    pub taken: Option<String>,
    /// Criteria for the schemes.
    pub criteria: Criteria,
    /// Number of schemes compared.
    pub compared: usize,
    /// Number of schemes that meet the criteria.
    pub accepted: usize,
    /// Objective by which the best scheme is ahead; null if there is only one, or all are equal.
    pub decided_by: Option<Objective>,
    /// Ring-to-sun ratios of the sets that give the required ratios exactly.
    pub k: Vec<f64>,
    /// Better schemes that were passed over, because none of their tooth numbers has sufficient sizes.
    pub passed_over: Vec<String>,
    /// Next best scheme that meets the criteria; null if none exists.
    pub next: Option<String>,
}

impl SchemeStep {
    /// Step from all candidates, the chosen mechanism, and the better ones without sizes.
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

/// Choice of the tooth numbers.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TeethStep {
    /// Largest relative deviation of the designs compared by mass: a part of the tolerance, or all of it.
    pub tolerance: f64,
    /// Number of tooth designs (pairs of sets, or single sets) within this deviation that meet the criteria.
    pub accepted: u64,
    /// Number of tooth designs for which sizes were searched.
    pub tried: usize,
    /// Chosen tooth design; null if none exists, or fewer than the number asked for.
    pub taken: Option<TeethTaken>,
    /// Next best of the designs with searched sizes; null if none exists.
    pub next: Option<TeethTaken>,
}

/// Tooth numbers of all sets.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TeethTaken {
    /// Number of the design, from 1: ordered by class of deviation, then by the smallest ring at equal tooth
    /// load.
    pub number: usize,
    /// Mass of the gears in kg; null if a set has no size.
    pub mass_kg: Option<f64>,
    /// Tooth numbers of sun, planet and ring of each set.
    pub sets: Vec<[u32; 3]>,
    /// Ratios of the braked gears.
    pub ratios: Vec<f64>,
}

impl TeethTaken {
    /// Tooth numbers of a design without sizes, with its number.
    pub(super) fn of(design: &teeth::Design, number: usize) -> Self {
        Self {
            number,
            mass_kg: None,
            sets: design.tooth_numbers.iter().map(|set| [set.sun, set.planet, set.ring]).collect(),
            ratios: design.candidate.gears.iter().map(|gear| gear.ratio).collect(),
        }
    }
}

/// Choice of the sizes.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SizesStep {
    /// Number of size designs of all sets together.
    pub designs: u64,
    /// Mass of the best designs of all sets, in kg; null if a set has none.
    pub mass_kg: Option<f64>,
    /// Mass of the best designs with carriers and housing, by a rule, in kg; null if a set has none.
    pub with_structure_kg: Option<f64>,
    /// Sets with the safeties of their teeth over the duty.
    pub sets: Vec<SizedSet>,
    /// Set with the least reserve of torque over a requirement, and this requirement; null if a set has no
    /// size.
    pub governing: Option<GoverningSet>,
    /// Judgement of the gearbox with these sizes by rules of practice.
    pub judgement: Judgement,
}

/// Requirement with the least margin in the gearbox.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GoverningSet {
    /// Name of the set.
    pub set: String,
    /// Governing requirement.
    pub requirement: Governing,
}

impl SizesStep {
    pub(super) fn of(size: Size) -> Self {
        // One set without a size leaves the governing requirement unknown, so `collect` yields `None`.
        let best: Option<Vec<GoverningSet>> = size
            .sets
            .iter()
            .map(|set| {
                let requirement = set.found.first()?.governing.clone();
                Some(GoverningSet { set: set.set.clone(), requirement })
            })
            .collect();
        // Safeties of flanks, of roots and loads of bearings compare by the torque that they leave.
        let reserve = |one: &GoverningSet| one.requirement.reserve();
        let governing =
            best.and_then(|all| all.into_iter().min_by(|one, other| reserve(one).total_cmp(&reserve(other))));
        let Size { designs, mass_kg, whole_kg: with_structure_kg, sets, judgement, .. } = size;
        Self { designs, mass_kg, with_structure_kg, sets, governing, judgement }
    }
}

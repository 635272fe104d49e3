//! Records of the steps of a design.

use crate::select::answer::Select;
use crate::select::answer::candidate::Candidate;
use crate::select::answer::required::Required;
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
    /// Whether the scheme was asked for; otherwise it is that of the best gearbox.
    pub asked_for: bool,
    /// Chosen scheme: its name in the source, or that of its structure. Null if none meets the criteria.
    pub taken: Option<String>,
    /// Criteria for the schemes.
    pub criteria: Criteria,
    /// Number of schemes compared.
    pub compared: usize,
    /// Number of schemes that meet the criteria.
    pub accepted: usize,
    /// Ring-to-sun ratios of the sets that give the required ratios exactly.
    pub k: Vec<f64>,
    /// The best gearboxes of other schemes, in order, as far as a short search finds them.
    pub others: Vec<OtherScheme>,
}

/// Best gearbox of a scheme that was not taken.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct OtherScheme {
    /// Name of the scheme in the source, or that of its structure.
    pub scheme: String,
    /// Tooth numbers of the gearbox.
    pub teeth: TeethTaken,
}

impl SchemeStep {
    /// Step from all candidates and the chosen mechanism; without one, the best by usual objectives shows how
    /// far the search came.
    pub(super) fn of(
        selection: &Select,
        taken: Option<Mechanism>,
        others: Vec<OtherScheme>,
        asked_for: bool,
    ) -> Self {
        let name = |one: &Candidate| one.scheme.unwrap_or(&one.structure).to_owned();
        let mut accepted = selection.candidates.iter().filter(|one| one.accepted);
        let first = match taken.map(|mechanism| mechanism.to_string()) {
            Some(structure) => accepted.find(|one| one.structure == structure),
            None => accepted.next(),
        };
        Self {
            asked_for,
            criteria: Criteria::of(&selection.required),
            compared: selection.accepted + selection.rejected,
            accepted: selection.accepted,
            k: first.iter().flat_map(|first| &first.sets).map(|set| set.k).collect(),
            taken: first.map(name),
            others,
        }
    }
}

/// Choice of the tooth numbers.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TeethStep {
    /// Largest relative deviation of the designs compared by mass: a part of the tolerance, or all of it.
    pub tolerance: f64,
    /// Number of tooth designs (pairs of sets, or single sets) of all schemes within this deviation.
    pub compared: u64,
    /// Number of sets that were sized; bounds below their mass exclude the others.
    pub sized: u64,
    /// Whether every better design within this deviation is excluded; false if the search ended early.
    pub complete: bool,
    /// Chosen tooth design; null if none exists.
    pub taken: Option<TeethTaken>,
    /// Next best design; null without another design that holds.
    pub next: Option<TeethTaken>,
}

/// Tooth numbers of all sets.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TeethTaken {
    /// Number of the design, from 1: the fewest sets beyond usual practice first, then the lightest.
    pub number: usize,
    /// Mass in kg that decides: of gears, carriers and housing by a rule, or of the gears; null if a set has
    /// no size.
    pub mass_kg: Option<f64>,
    /// Rules of usual practice that sets and gearbox miss; null if a set has no size.
    pub rules_missed: Option<u32>,
    /// Tooth numbers of sun, planet and ring of each set.
    pub sets: Vec<[u32; 3]>,
    /// Ratios of the braked gears.
    pub ratios: Vec<f64>,
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
        let Size { designs, mass_kg, with_structure_kg, sets, judgement, .. } = size;
        Self { designs, mass_kg, with_structure_kg, sets, governing, judgement }
    }
}

//! All gearboxes that have a list of ratios.
//!
//! | module | is |
//! |---|---|
//! | [`explain`] | a given gearbox beside the search |
//! | [`page`] | what a page of a search draws |
//! | [`rating`] | what a solution is worth by the solver |
//! | [`teeth`] | tooth numbers of a solution |
//! | [`saved`] | a solution as a file |
//! | `scheme` | which scheme of the document a solution is |

pub mod explain;
pub mod page;
pub mod rating;
pub mod saved;
mod scheme;
pub mod teeth;

use crate::{Answer, Error};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_schemes::catalogue::Scheme;
use epicyclic_synthesis::gearbox::element_name;
use epicyclic_synthesis::judge::{Judged, judge_all};
use epicyclic_synthesis::motion::elements;
use epicyclic_synthesis::parts::Bounds;
use epicyclic_synthesis::rank::{self, front};
use epicyclic_synthesis::run::{Found, Progress, Share, search};
use epicyclic_synthesis::structure::link_name;
use epicyclic_synthesis::teeth::{Choice, Design};
use epicyclic_synthesis::wish::Wish;
use epicyclic_synthesis::{Class, Kind};
use epicyclic_train::Gearbox;
use explain::Explanation;
use rating::{Objective, Rating};
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::{ControlFlow, RangeInclusive};
use teeth::{Teeth, TeethWanted};

/// The most solutions that are told: each is judged by the solver.
pub const MOST_SOLUTIONS: usize = 10_000;

/// What is wanted.
#[derive(Debug, Clone, PartialEq)]
pub struct Wanted {
    /// The ratio of each gear; negative for reverse.
    pub ratios: Vec<f64>,
    /// How far each may be off, as a share of it.
    pub tolerance: f64,
    /// Which structures are searched.
    pub kind: Kind,
    /// How many planet sets; those given are tried from the fewest up, until a number has solutions.
    pub sets: RangeInclusive<usize>,
    /// How many shift elements, tried alike.
    pub elements: RangeInclusive<usize>,
    /// How many shift elements a gear engages.
    pub engaged: RangeInclusive<usize>,
    /// The range of the ring-to-sun ratios.
    pub k: RangeInclusive<f64>,
    /// Efficiency of a set's meshes.
    pub efficiency: MeshEfficiency,
    /// How many solutions are told at most.
    pub most: usize,
    /// Which objectives decide first which solution is the best; the others follow.
    pub order: Vec<rank::Objective>,
    /// The objectives of the Pareto front.
    pub objectives: Vec<rank::Objective>,
    /// Tooth numbers, if any are wanted.
    pub teeth: Option<TeethWanted>,
    /// A gearbox to be placed beside the search.
    pub explain: Option<Gearbox>,
}

/// All gearboxes of some planet sets, brakes and clutches that have a list of ratios.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Synthesis {
    /// The ratios wanted, input speed over output speed.
    pub wanted_ratios: Vec<f64>,
    /// How far each may be off, as a share of it.
    pub tolerance: f64,
    /// The range of the ring-to-sun ratios k of every set.
    pub k_range: [f64; 2],
    /// What was searched, in this order.
    pub searched: Vec<Searched>,
    /// Whether every structure of these classes was searched.
    pub complete: bool,
    /// How many solutions there are.
    pub found: usize,
    /// How many of them are told here.
    pub shown: usize,
    /// The objectives by which they are ordered, the first decides first.
    pub order: Vec<Objective>,
    /// The objectives of the Pareto front.
    pub objectives: Vec<Objective>,
    /// How many of the solutions found no other dominates.
    pub non_dominated: usize,
    /// The objective by which the first is ahead of others; `null` where there are no others, or all are equal.
    pub decided_by: Option<Objective>,
    /// A given gearbox beside the search; `null` where none was given.
    pub explanation: Option<Explanation>,
    /// These, the best first.
    pub solutions: Vec<Solution>,
}

/// A class of structures that was searched.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Searched {
    /// Which structures the class has.
    pub class: ClassName,
    /// How many planet sets.
    pub sets: usize,
    /// How many moving links.
    pub links: usize,
    /// How many shift elements.
    pub shift_elements: usize,
    /// How many of them a gear engages.
    pub engaged: usize,
    /// Structures in the class, each once.
    pub structures: usize,
    /// Structures times sets of shift elements, as pairs of links: the space that was searched.
    pub space: f64,
    /// Structures that were searched; the others were left when the search was ended.
    pub structures_searched: u64,
    /// Structures in which each gear is in reach of some shift elements.
    pub structures_in_reach: u64,
    /// Sets of shift elements that have all gears.
    pub solutions: usize,
    /// Sets that have all gears, but some k moves none of them: a simpler gearbox does the same.
    pub reducible: u64,
    /// Sets for which neither a solution was found nor its absence proved.
    pub undecided: u64,
}

/// Which structures a class has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ClassName {
    /// No member on the housing, input and output on members, all sets joined.
    Core,
    /// Members may be on the housing, and shift elements alone may reach input or output.
    AllSparse,
}

/// A gearbox that has the wanted ratios.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Solution {
    /// The scheme of the document that it is; `null` where it is none.
    pub scheme: Option<&'static str>,
    /// Links of sun, ring and carrier of each set: 0 the housing, 1 the input, 2 the output, letters the others.
    pub structure: String,
    /// The sets.
    pub sets: Vec<Set>,
    /// The shift elements.
    pub shift_elements: Vec<ShiftElement>,
    /// The gears, in the order of the wish.
    pub gears: Vec<Gear>,
    /// The greatest deviation of a ratio from the one wanted, as a share of it.
    pub greatest_deviation: f64,
    /// How many shifts between neighbouring forward gears exchange more than one shift element.
    pub multiple_shifts: usize,
    /// The least efficiency of a gear.
    pub least_efficiency: f64,
    /// What it is worth.
    pub rating: Rating,
    /// Tooth numbers; `null` where none were asked for.
    pub teeth: Option<Teeth>,
}

/// A planet set of a solution.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Set {
    /// Link of the sun.
    pub sun: char,
    /// Link of the ring.
    pub ring: char,
    /// Link of the carrier.
    pub carrier: char,
    /// Ring-to-sun ratio with which the greatest deviation is least.
    pub k: f64,
    /// The range of k that keeps all tolerances, the other sets' k moving along.
    pub k_range: [f64; 2],
}

/// A brake or clutch of a solution.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ShiftElement {
    /// Its name: a brake's link, or the two links of a clutch.
    pub name: String,
    /// Whether it holds a link on the housing.
    pub is_brake: bool,
    /// Other elements that lock the same and may take its place.
    pub instead: Vec<String>,
}

/// A gear of a solution.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Gear {
    /// The ratio wanted.
    pub wanted_ratio: f64,
    /// The ratio at the sets' k, by the solver.
    pub ratio: f64,
    /// How far it is from the one wanted, as a share of it.
    pub deviation: f64,
    /// The ratio as a formula in the sets' k.
    pub formula: String,
    /// The shift elements that it engages.
    pub engaged: Vec<String>,
    /// The efficiency with the given efficiency of the sets; none where the losses hold the gear.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub efficiency: Option<f64>,
}

impl Answer for Synthesis {
    const NAME: &'static str = "synthesize";
}

/// A solution that is told, as the search has it.
#[derive(Debug, Clone, PartialEq)]
pub struct Kept {
    /// Its structure, shift elements and ratios.
    pub found: Found,
    /// Its best ring-to-sun ratios and its gearbox.
    pub judged: Judged,
    /// What it is worth.
    pub rating: rank::Rating,
    /// The best tooth numbers, where any were asked for.
    pub teeth: Vec<Design>,
}

/// All gearboxes that have the wanted ratios.
///
/// # Errors
/// As [`solve`].
pub fn answer(
    wanted: &Wanted,
    progress: &(dyn Fn(&Searching, Progress) -> ControlFlow<()> + Sync),
) -> Result<Synthesis, Error> {
    solve(wanted, progress).map(|(answer, _)| answer)
}

/// The same, with the solutions that are told as the search has them. Before each class is searched `progress` is told of it; a
/// break ends the search, and what was found is kept.
///
/// # Errors
/// [`Error::Synthesis`] where no class can have the ratios, and for limits of teeth that nothing can keep.
pub fn solve(
    wanted: &Wanted,
    progress: &(dyn Fn(&Searching, Progress) -> ControlFlow<()> + Sync),
) -> Result<(Synthesis, Vec<Kept>), Error> {
    let choice = wanted.teeth.as_ref().map(|teeth| Choice::within(&teeth.bounds)).transpose()?;
    let order = rank::Objective::order(&wanted.order);
    let gears: Vec<Bounds> = wanted.ratios.iter().map(|ratio| around(*ratio, wanted.tolerance)).collect();
    let mut answer = Synthesis {
        wanted_ratios: wanted.ratios.clone(),
        tolerance: wanted.tolerance,
        k_range: [*wanted.k.start(), *wanted.k.end()],
        searched: Vec::new(),
        complete: true,
        found: 0,
        shown: 0,
        order: order.iter().map(|objective| Objective::of(*objective)).collect(),
        objectives: wanted.objectives.iter().map(|objective| Objective::of(*objective)).collect(),
        non_dominated: 0,
        decided_by: None,
        explanation: None,
        solutions: Vec::new(),
    };
    let mut refused = None;
    let mut kept: Vec<Kept> = Vec::new();
    'classes: for sets in wanted.sets.clone() {
        for shift_elements in wanted.elements.clone() {
            for engaged in wanted.engaged.clone() {
                let wish = Wish::new(gears.clone(), shift_elements, vec![wanted.k.clone(); sets]);
                let class = match Class::new(wanted.kind, sets, sets + engaged + 1)
                    .and_then(|class| wish.check(class).map(|()| class))
                {
                    Ok(class) => class,
                    Err(error) => {
                        refused.get_or_insert(error);
                        continue;
                    }
                };
                let searching = Searching { class, shift_elements };
                let found = search(class, &wish, Share::WHOLE, &|at| progress(&searching, at))?;
                answer.complete &= found.complete;
                answer.searched.push(Searched {
                    class: ClassName::of(class.kind()),
                    sets,
                    links: class.links(),
                    shift_elements,
                    engaged,
                    structures: found.class_size,
                    space: searching.space(found.class_size),
                    structures_searched: found.tally.structures,
                    structures_in_reach: found.tally.in_reach,
                    solutions: found.found.len(),
                    reducible: found.tally.reducible,
                    undecided: found.tally.undecided,
                });
                let judgements = judge_all(&found.found, &wish, wanted.efficiency)?;
                for (found, judged) in found.found.into_iter().zip(judgements) {
                    let rating = rank::Rating::of(&judged)?;
                    kept.push(Kept { found, judged, rating, teeth: Vec::new() });
                }
                if !found.complete {
                    break 'classes;
                }
            }
            if !kept.is_empty() {
                break 'classes;
            }
        }
    }
    if let (true, Some(error)) = (answer.searched.is_empty(), refused) {
        return Err(error.into());
    }
    kept.sort_by(|one, other| one.rating.compare(&other.rating, &order));
    let ratings: Vec<&rank::Rating> = kept.iter().map(|kept| &kept.rating).collect();
    let on_front = front(&ratings, &wanted.objectives);
    let behind = |place: usize| ratings[place].decides(ratings[0], &order);
    let first_of = |objectives: &mut dyn Iterator<Item = rank::Objective>| {
        objectives.min_by_key(|objective| order.iter().position(|other| other == objective))
    };
    answer.found = kept.len();
    answer.non_dominated = on_front.len();
    answer.decided_by = first_of(&mut (1..kept.len()).filter_map(behind)).map(Objective::of);
    answer.shown = kept.len().min(wanted.most).min(MOST_SOLUTIONS);
    answer.solutions = (0..answer.shown)
        .map(|place| {
            let Kept { found, judged, rating, .. } = &kept[place];
            let rating = Rating::of(rating, judged, on_front.binary_search(&place).is_ok(), behind(place));
            Solution::of(found, judged, &wanted.ratios, rating)
        })
        .collect();
    if let Some(gearbox) = &wanted.explain {
        answer.explanation = Some(explain::explain(gearbox, wanted, &answer, &kept)?);
    }
    kept.truncate(answer.shown);
    if let (Some(teeth), Some(choice)) = (&wanted.teeth, &choice) {
        for (solution, kept) in answer.solutions.iter_mut().zip(&mut kept) {
            let k = vec![wanted.k.clone(); solution.sets.len()];
            let (told, best) = Teeth::of(&kept.found, &gears, &wanted.ratios, &k, choice, teeth);
            (solution.teeth, kept.teeth) = (Some(told), best);
        }
    }
    Ok((answer, kept))
}

/// A class that is being searched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Searching {
    /// The class.
    pub class: Class,
    /// How many shift elements.
    pub shift_elements: usize,
}

impl Searching {
    /// Structures times sets of shift elements.
    fn space(&self, structures: usize) -> f64 {
        let pairs = elements(self.class.links()).len();
        (0..self.shift_elements).fold(structures as f64, |all, place| {
            all * pairs.saturating_sub(place) as f64 / (place + 1) as f64
        })
    }
}

fn around(ratio: f64, tolerance: f64) -> Bounds {
    Bounds { least: ratio - tolerance * ratio.abs(), most: ratio + tolerance * ratio.abs() }
}

impl ClassName {
    fn of(kind: Kind) -> Self {
        match kind {
            Kind::Core => Self::Core,
            Kind::AllSparse => Self::AllSparse,
        }
    }
}

impl Solution {
    fn of(found: &Found, judged: &Judged, wanted: &[f64], rating: Rating) -> Self {
        let solution = &found.solution;
        let sets = found.structure.sets().iter().zip(&judged.refined.k).zip(&judged.refined.ranges);
        let sets = sets.map(|((members, k), range)| {
            let [sun, ring, carrier] = members.map(link_name);
            Set { sun, ring, carrier, k: *k, k_range: *range }
        });
        let names: Vec<String> = solution.elements.iter().map(|pairs| element_name(pairs[0])).collect();
        let shift_elements = solution.elements.iter().zip(&names).map(|(pairs, name)| ShiftElement {
            name: name.clone(),
            is_brake: pairs[0][0] == 0,
            instead: pairs[1..].iter().map(|pair| element_name(*pair)).collect(),
        });
        let gears: Vec<Gear> = (0..wanted.len())
            .map(|gear| Gear {
                wanted_ratio: wanted[gear],
                ratio: judged.ratios[gear],
                deviation: judged.ratios[gear] / wanted[gear] - 1.0,
                formula: solution.gears[gear].ratio.to_string(),
                engaged: judged.engaged[gear].iter().map(|element| names[*element].clone()).collect(),
                efficiency: judged.efficiencies[gear],
            })
            .collect();
        Self {
            scheme: scheme::of(found).map(Scheme::name),
            structure: found.structure.to_string(),
            sets: sets.collect(),
            shift_elements: shift_elements.collect(),
            greatest_deviation: gears.iter().map(|gear| gear.deviation.abs()).fold(0.0, f64::max),
            gears,
            multiple_shifts: judged.multiple_shifts,
            least_efficiency: judged.least_efficiency(),
            rating,
            teeth: None,
        }
    }
}

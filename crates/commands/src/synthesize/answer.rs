//! All gearboxes that have a list of ratios.
//!
//! | module | is |
//! |---|---|
//! | [`families`] | gearboxes with equal formulas |
//! | [`explain`] | a given gearbox beside the search |
//! | [`page`] | what a page of a search draws |
//! | [`rating`] | what a solution is worth by the solver |
//! | [`teeth`] | tooth numbers of a solution |
//! | [`saved`] | a solution as a file |
//! | [`shared_planets`] | sets that share planets |

pub mod explain;
pub mod families;
pub mod near_miss;
pub mod page;
pub mod rating;
pub mod saved;
mod scheme;
pub mod shared_planets;
pub mod teeth;

mod drawn;
mod gear;
mod keep;
mod kept;
mod left_out;
mod means;
mod tried;
mod usable;
mod wanted;

pub use gear::WantedGear;
pub use kept::Kept;
pub use left_out::{LeftOut, Reason};
pub use means::Means;
pub use tried::{Searching, Tried, tried};
pub use usable::LimitsOfUse;
pub use wanted::{MOST_OPTIONAL, Wanted};

use crate::answer::Answer;
use crate::error::Error;
use crate::shared::tooth_checks::answer::TeethLeftOut;
use crate::tolerance::AT_EDGE;
use epicyclic_numerics::values::largest_absolute;
use epicyclic_schemes::catalogue::Scheme;
use epicyclic_synthesis::gearbox::{element_name, own_names, real_k};
use epicyclic_synthesis::motion::Element;
use epicyclic_synthesis::rank::{self, front};
use epicyclic_synthesis::run::{self, Found, Progress, Share, search};
use epicyclic_synthesis::structure::link_name;
use epicyclic_synthesis::wish::Wish;
use epicyclic_synthesis::{Kind, Structure};
use epicyclic_train::formula::subscript;
use explain::Explanation;
use families::{Family, families};
use keep::keep;
use left_out::LeftOuts;
use near_miss::NearMiss;
use rating::{Objective, Rating};
use schemars::JsonSchema;
use serde::Serialize;
use shared_planets::SharedPlanets;
use std::collections::BTreeSet;
use std::ops::{ControlFlow, RangeInclusive};
use teeth::{Choices, Teeth};

/// The most solutions that are told: each is judged by the solver.
pub const MOST_SOLUTIONS: usize = 10_000;

/// All gearboxes of some planet sets, brakes and clutches that have a list of ratios.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Synthesis {
    /// The gears wanted.
    pub wanted: Vec<WantedGear>,
    /// How far each ratio may be off that has no tolerance of its own, as a share of it.
    pub tolerance: f64,
    /// The range of the ring-to-sun ratios k of every simple set.
    pub k_range: [f64; 2],
    /// That of every double-planet set; none where no such sets are searched.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub k_range_of_double_planets: Option<[f64; 2]>,
    /// How many sets of one kind have equal k at least; none where nothing is asked.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub equal_k: Option<usize>,
    /// What was searched, in this order.
    pub searched: Vec<Searched>,
    /// Pairs of sun and ring that are left out since a check of their teeth does not hold, of simple and of
    /// double-planet sets.
    pub teeth_left_out: Vec<TeethLeftOut>,
    /// Sets of shift elements that have all gears, and what left them out.
    pub left_out: Vec<LeftOut>,
    /// What a gearbox of use keeps; `null` where the search ended at the first class with gearboxes, whatever
    /// they are worth.
    pub limits_of_use: Option<LimitsOfUse>,
    /// Gearboxes that are not told, since larger classes have some of use: by the limit that they miss first.
    pub left_behind: Vec<LeftOut>,
    /// How many of those found miss no limit of use.
    pub of_use: usize,
    /// Shares of time of the wanted gears, which weigh the mean efficiency; `null` where none are given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shares: Option<Vec<f64>>,
    /// Whether every structure of these classes was searched.
    pub complete: bool,
    /// How many solutions there are.
    pub found: usize,
    /// Families of solutions with equal formulas, up to an exchange of sets of one kind, the best first.
    pub families: Vec<Family>,
    /// Whether the solutions told are the best of each family alone, or all.
    pub listed: Listed,
    /// How many of them are told here.
    pub shown: usize,
    /// The objectives by which they are ordered, the first decides first.
    pub order: Vec<Objective>,
    /// The objectives of the Pareto front.
    pub objectives: Vec<Objective>,
    /// How many of the solutions found no other dominates; of those with as many gears as the first.
    pub non_dominated: usize,
    /// The objective that sets the first ahead; `null` where it is alone or all are equal.
    pub decided_by: Option<Objective>,
    /// A given gearbox beside the search; `null` where none was given.
    pub explanation: Option<Explanation>,
    /// A gearbox of fewer sets that misses the ratios narrowly; `null` where none is known.
    pub near_miss: Option<NearMiss>,
    /// These, the best first.
    pub solutions: Vec<Solution>,
}

/// Which solutions are told.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Listed {
    /// The best of each family.
    BestOfFamilies,
    /// All.
    AllGearboxes,
}

/// A class of structures that was searched.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Searched {
    /// Which structures the class has.
    pub class: ClassName,
    /// How many planet sets.
    pub sets: usize,
    /// How many of them are double-planet sets.
    pub double_planets: usize,
    /// How many moving links.
    pub links: usize,
    /// How many shift elements.
    pub shift_elements: usize,
    /// How many of them a gear engages.
    pub engaged: usize,
    /// How many gears were asked for: without some of those that may be missing.
    pub gears: usize,
    /// Structures in the class, each once.
    pub structures: usize,
    /// Space searched: structures × choices of double-planet sets × sets of shift elements.
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
    /// Its number among all solutions found, from 1, the best first.
    pub number: usize,
    /// The number of its family.
    pub family: usize,
    /// How many gearboxes its family has.
    pub gearboxes_of_family: usize,
    /// The scheme of the document that it is; `null` where it is none.
    pub scheme: Option<&'static str>,
    /// Links of sun, ring and carrier of each set: 0 the housing, 1 the input, 2 the output, letters the
    /// others; a double-planet set has a star.
    pub structure: String,
    /// The sets.
    pub sets: Vec<Set>,
    /// The shift elements.
    pub shift_elements: Vec<ShiftElement>,
    /// The gears, in the order of the wish.
    pub gears: Vec<Gear>,
    /// Numbers in the wish, from 1, of the gears that it has not.
    pub missing_gears: Vec<usize>,
    /// The greatest deviation of a ratio from the one wanted, as a share of it; 0 where all are ranges.
    pub greatest_deviation: f64,
    /// How many shifts between neighbouring forward gears exchange more than one shift element.
    pub multiple_shifts: usize,
    /// The least efficiency of a forward gear; of a gearbox without one, of a gear.
    pub forward_efficiency: f64,
    /// The mean efficiency of the forward gears by their shares of time; none where no shares are given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mean_efficiency: Option<f64>,
    /// The least efficiency of a reverse gear; `null` where there is none.
    pub reverse_efficiency: Option<f64>,
    /// The limit of use that it misses first; `null` where it misses none.
    pub beyond_limit: Option<Reason>,
    /// Sets with a carrier and a sun or ring in common: those that share planets are rated as the compound
    /// set that they are.
    pub shared_planets: Vec<SharedPlanets>,
    /// The greatest slip of an open shift element in a gear, over the input's speed.
    pub greatest_slip: f64,
    /// The greatest speed of a link in a gear, over the input's.
    pub greatest_link_speed: f64,
    /// The greatest speed of a planet relative to its carrier in a gear, over the input's; of the planets of
    /// a double-planet set, which depends on their teeth, what they exceed in any case:
    /// `2·|ω_sun − ω_carrier|/(k − 1)`.
    pub greatest_planet_speed: f64,
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
    /// Whether it is a double-planet set: two planets in mesh between sun and ring.
    pub is_double_planet: bool,
    /// Ring-to-sun ratio with which the greatest deviation is least.
    pub k: f64,
    /// The range of k that keeps all tolerances, the other sets' k moving along.
    pub k_range: [f64; 2],
    /// Whether k was asked to be equal to that of others, which have this mark as well.
    pub has_equal_k: bool,
    /// The end of the range searched at which k is, if it is at one: a wider range may have better solutions.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at_edge: Option<Edge>,
}

/// An end of a range.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Edge {
    /// The lower.
    Lower,
    /// The upper.
    Upper,
}

/// A brake or clutch of a solution.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ShiftElement {
    /// Its name: `B1`, `B2` … of a brake, `C1`, `C2` … of a clutch.
    pub name: String,
    /// What it joins: a brake's link to the housing, or the two links of a clutch.
    pub joins: String,
    /// Whether it holds a link on the housing.
    pub is_brake: bool,
    /// Other elements that lock the same and may take its place.
    pub instead: Vec<String>,
}

/// A gear of a solution.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Gear {
    /// The ratio wanted; none where any within bounds will do.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wanted_ratio: Option<f64>,
    /// The ratio at the sets' k, by the solver.
    pub ratio: f64,
    /// How far it is from the one wanted, as a share of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deviation: Option<f64>,
    /// The ratio as a formula in the sets' k; of a double-planet set in k′ = k − 1.
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

/// The same, with the solutions that are told as the search has them. Before each class is searched
/// `progress` is told of it; a break ends the search, and what was found is kept.
///
/// # Errors
/// [`Error::Synthesis`] where no class can have the ratios, and for limits of teeth that nothing can keep.
pub fn solve(
    wanted: &Wanted,
    progress: &(dyn Fn(&Searching, Progress) -> ControlFlow<()> + Sync),
) -> Result<(Synthesis, Vec<Kept>), Error> {
    solve_by(wanted, &mut |searching: &Searching, wish: &Wish| {
        wanted.limits.check(&wish.gears)?;
        Ok(search(searching.class, wish, Share::WHOLE, &|at| progress(searching, at))?)
    })
}

/// The same where each class is searched by other means.
///
/// # Errors
/// As [`solve`], and those of the search.
pub fn solve_by<E: From<Error>>(
    wanted: &Wanted,
    means: &mut dyn Means<E>,
) -> Result<(Synthesis, Vec<Kept>), E> {
    let k_double = (*wanted.double_planets.end() > 0).then(|| wanted.k_double.clone());
    let choices = wanted.teeth.as_ref().map(|teeth| Choices::wanted(teeth, k_double)).transpose()?;
    let order = rank::Objective::order(&wanted.order);
    let gears = wanted.gears().map_err(Error::from)?;
    let mut answer = Synthesis {
        wanted: gears.clone(),
        tolerance: wanted.tolerance,
        teeth_left_out: choices.as_ref().map(Choices::left_out).unwrap_or_default(),
        k_range: [*wanted.k.start(), *wanted.k.end()],
        k_range_of_double_planets: (*wanted.double_planets.end() > 0)
            .then(|| [*wanted.k_double.start(), *wanted.k_double.end()]),
        equal_k: (wanted.equal_k > 1).then_some(wanted.equal_k),
        searched: Vec::new(),
        left_out: Vec::new(),
        limits_of_use: wanted.usable.map(LimitsOfUse::of),
        left_behind: Vec::new(),
        of_use: 0,
        shares: wanted.shares.clone(),
        complete: true,
        found: 0,
        families: Vec::new(),
        listed: if wanted.all_gearboxes { Listed::AllGearboxes } else { Listed::BestOfFamilies },
        shown: 0,
        order: order.iter().map(|objective| Objective::of(*objective)).collect(),
        objectives: wanted.objectives.iter().map(|objective| Objective::of(*objective)).collect(),
        non_dominated: 0,
        decided_by: None,
        explanation: None,
        near_miss: None,
        solutions: Vec::new(),
    };
    let mut left_out = LeftOuts::default();
    let mut kept: Vec<Kept> = Vec::new();
    let mut before: Option<Searching> = None;
    // How many of those kept are of smaller classes without any of use.
    let mut behind = 0;
    let mut known = BTreeSet::new();
    for Tried { searching, wish, selection } in tried(wanted)? {
        let size = |of: &Searching| (of.class.sets(), of.shift_elements);
        // All that engage another number of as many elements are searched, too.
        if let Some(before) = before.filter(|before| size(before) != size(&searching))
            && !kept.is_empty()
        {
            if kept.iter().any(|one| one.fault.is_none()) {
                break;
            }
            if behind < kept.len() {
                behind = kept.len();
                means.going_on(&before, &usable::faults(&kept));
            }
        }
        before = Some(searching);
        let Some(mut answered) = means.search(&searching, &wish)? else { break };
        // What has more gears is not told again with fewer.
        answered.found.retain(|found| known.insert(identity(found)));
        answer.complete &= answered.complete;
        answer.searched.push(Searched::of(&searching, selection.len(), &answered));
        left_out.add(Reason::Direct, answered.tally.without_direct);
        left_out.add(Reason::Shifts, answered.tally.without_single_shifts);
        let of = answered.found.len();
        let judged = |done| means.judged(done, of);
        let rated = || means.rated();
        kept.extend(keep(answered.found, &wish, wanted, &selection, &mut left_out, &judged, &rated)?);
        if left_out.has(Reason::Unjudged) {
            answer.complete = false;
        }
        if !answer.complete {
            break;
        }
        if kept.is_empty() && !left_out.are_none() {
            means.nothing_kept(&searching, &left_out.told());
        }
    }
    answer.left_out = left_out.told();
    if kept[behind..].iter().any(|one| one.fault.is_none()) {
        answer.left_behind = usable::faults(&kept[..behind]);
        kept.drain(..behind);
    }
    answer.of_use = kept.iter().filter(|one| one.fault.is_none()).count();
    kept.sort_by(|one, other| {
        let missing = other.selection.len().cmp(&one.selection.len());
        missing.then_with(|| one.rating.compare(&other.rating, &order))
    });
    (1..).zip(&mut kept).for_each(|(number, kept)| kept.number = number);
    let (families, of_each) = families(&kept);
    // Worth compares what has as many gears.
    let alike = kept.iter().filter(|one| one.selection.len() == kept[0].selection.len()).count();
    let ratings: Vec<&rank::Rating> = kept[..alike].iter().map(|kept| &kept.rating).collect();
    let on_front = front(&ratings, &wanted.objectives);
    let behind = |place: usize| ratings.get(place)?.decides(ratings[0], &order);
    let first_of = |objectives: &mut dyn Iterator<Item = rank::Objective>| {
        objectives.min_by_key(|objective| order.iter().position(|other| other == objective))
    };
    answer.found = kept.len();
    answer.non_dominated = on_front.len();
    answer.decided_by = first_of(&mut (1..kept.len()).filter_map(behind)).map(Objective::of);
    let told = told(&families, kept.len(), wanted);
    answer.shown = told.len();
    answer.solutions = told
        .iter()
        .map(|place| {
            let Kept { judged, rating, .. } = &kept[*place];
            let rating = Rating::of(rating, judged, on_front.binary_search(place).is_ok(), behind(*place));
            Solution::of(&kept[*place], wanted, &gears, rating, &families[of_each[*place]])
        })
        .collect();
    answer.families = families;
    if let Some(gearbox) = &wanted.explain {
        let mut explanation = explain::explain(gearbox, wanted, &answer, &kept)?;
        explanation.family = explanation.number.map(|number| of_each[number - 1] + 1);
        answer.explanation = Some(explanation);
    }
    kept.retain(|kept| told.binary_search(&(kept.number - 1)).is_ok());
    if let (Some(teeth), Some(choices)) = (&wanted.teeth, &choices) {
        for (solution, kept) in answer.solutions.iter_mut().zip(&mut kept) {
            let side_by_side = wanted.side_by_side(&kept.selection, &gears);
            let gears: Vec<WantedGear> = kept.selection.iter().map(|gear| gears[*gear]).collect();
            kept.shift = teeth.shift();
            let k = wanted.ranges(solution.sets.len(), kept.found.structure.double_planets());
            let (told, best) = Teeth::of(kept, &gears, &side_by_side, &k, choices, teeth, &|| means.ended())?;
            answer.complete &= !means.ended();
            (solution.teeth, kept.teeth) = (Some(told), best);
        }
    }
    Ok((answer, kept))
}

/// The places of the solutions that are told, in rising order.
fn told(families: &[Family], found: usize, wanted: &Wanted) -> Vec<usize> {
    let most = wanted.most.min(MOST_SOLUTIONS);
    let mut told: Vec<usize> = if wanted.all_gearboxes {
        (0..found).take(most).collect()
    } else {
        families.iter().map(|family| family.best - 1).take(most).collect()
    };
    told.extend(wanted.also.and_then(|number| number.checked_sub(1)).filter(|place| *place < found));
    told.sort_unstable();
    told.dedup();
    told
}

/// What makes two solutions the same gearbox: structure and elements.
fn identity(found: &Found) -> (Structure, Vec<Vec<Element>>) {
    let mut elements = found.solution.elements.clone();
    elements.iter_mut().for_each(|pairs| pairs.sort_unstable());
    (found.structure.clone(), elements)
}

impl Searched {
    fn of(searching: &Searching, gears: usize, answered: &run::Answer) -> Self {
        let class = searching.class;
        Self {
            class: ClassName::of(class.kind()),
            sets: class.sets(),
            double_planets: searching.double_planets,
            links: class.links(),
            shift_elements: searching.shift_elements,
            engaged: class.engaged(),
            gears,
            structures: answered.class_size,
            space: searching.space(answered.class_size as f64),
            structures_searched: answered.tally.structures,
            structures_in_reach: answered.tally.in_reach,
            solutions: answered.found.len(),
            reducible: answered.tally.reducible,
            undecided: answered.tally.undecided,
        }
    }
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
    fn of(kept: &Kept, wanted: &Wanted, wished: &[WantedGear], rating: Rating, family: &Family) -> Self {
        let Kept { found, judged, selection, .. } = kept;
        let solution = &found.solution;
        let sets = judged.refined.k.iter().zip(&judged.refined.ranges).enumerate();
        let sets = sets.map(|(place, (k, range))| {
            let [sun, ring, carrier] = found.structure.members(place).map(link_name);
            let is_double_planet = found.structure.is_double_planet(place);
            let real = |k: f64| real_k(&found.structure, place, k);
            let at_edge = Edge::of(real(*k), wanted.k_of(is_double_planet));
            let has_equal_k = solution.equal.contains(place);
            let (k, k_range) = (real(*k), range.map(real));
            Set { sun, ring, carrier, is_double_planet, k, k_range, has_equal_k, at_edge }
        });
        let chosen: Vec<Element> = solution.elements.iter().map(|pairs| pairs[0]).collect();
        let names = own_names(&chosen);
        let shift_elements = solution.elements.iter().zip(&names).map(|(pairs, name)| ShiftElement {
            name: name.clone(),
            joins: element_name(pairs[0]),
            is_brake: pairs[0][0] == 0,
            instead: pairs[1..].iter().map(|pair| element_name(*pair)).collect(),
        });
        let gears: Vec<Gear> = selection
            .iter()
            .enumerate()
            .map(|(gear, place)| Gear {
                wanted_ratio: wished[*place].wanted_ratio,
                ratio: judged.ratios[gear],
                deviation: wished[*place].wanted_ratio.map(|ratio| judged.ratios[gear] / ratio - 1.0),
                formula: solution.gears[gear].ratio.text(&|set| symbol(&found.structure, set)),
                engaged: judged.engaged[gear].iter().map(|element| names[*element].clone()).collect(),
                efficiency: judged.efficiencies[gear],
            })
            .collect();
        Self {
            number: kept.number,
            family: family.number,
            gearboxes_of_family: family.gearboxes,
            scheme: scheme::of(found).map(Scheme::name),
            structure: found.structure.to_string(),
            sets: sets.collect(),
            shift_elements: shift_elements.collect(),
            greatest_deviation: largest_absolute(gears.iter().filter_map(|gear| gear.deviation)),
            gears,
            missing_gears: (0..wished.len())
                .filter(|gear| !selection.contains(gear))
                .map(|gear| gear + 1)
                .collect(),
            multiple_shifts: judged.multiple_shifts,
            forward_efficiency: judged.forward_efficiency(),
            mean_efficiency: wanted.shares.as_ref().and_then(|shares| {
                judged.mean_efficiency(&selection.iter().map(|gear| shares[*gear]).collect::<Vec<_>>())
            }),
            reverse_efficiency: judged.reverse_efficiency(),
            beyond_limit: kept.fault.map(Reason::of_fault),
            shared_planets: SharedPlanets::all(&found.structure, &judged.sharing),
            greatest_slip: judged.slip,
            greatest_link_speed: judged.link_speed,
            greatest_planet_speed: judged.planet_speed,
            rating,
            teeth: None,
        }
    }
}

/// The symbol of a set in formulas: `k₁`, of a double-planet set `k₁′`.
fn symbol(structure: &Structure, set: usize) -> String {
    let prime = if structure.is_double_planet(set) { "′" } else { "" };
    format!("{}{prime}", subscript('k', set + 1))
}

impl Edge {
    /// The end of a range at which a value is.
    fn of(value: f64, range: &RangeInclusive<f64>) -> Option<Self> {
        let near = |end: f64| (value - end).abs() <= AT_EDGE * end;
        let ends = [(*range.start(), Self::Lower), (*range.end(), Self::Upper)];
        ends.into_iter().find(|(end, _)| near(*end)).map(|(_, edge)| edge)
    }
}

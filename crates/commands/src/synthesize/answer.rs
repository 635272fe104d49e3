//! Synthesis of all gearboxes that have a list of ratios.
//!
//! | module | is |
//! |---|---|
//! | [`families`] | gearboxes with equal formulas |
//! | [`explain`] | comparison of a given gearbox with the search |
//! | [`page`] | drawings for the page of a search |
//! | [`rating`] | rating of a solution by the solver |
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
mod edge;
mod gear;
mod keep;
mod kept;
mod left_out;
mod means;
mod tried;
mod usable;
mod wanted;

pub use edge::Edge;
pub use gear::WantedGear;
pub use kept::Kept;
pub use left_out::{LeftOut, Reason};
pub use means::Means;
pub use tried::{Searching, Tried, tried};
pub use usable::LimitsOfUse;
pub use wanted::{MOST_OPTIONAL, Wanted};

use crate::answer::Answer;
use crate::error::Error;
use crate::shared::judgement::answer::Judgement;
use crate::shared::judgement::whole::FoundRatio;
use crate::shared::tooth_checks::answer::TeethLeftOut;
use epicyclic_numerics::values::largest_absolute;
use epicyclic_schemes::catalogue::Scheme;
use epicyclic_synthesis::gearbox::{element_name, own_names, real_k};
use epicyclic_synthesis::motion::Element;
use epicyclic_synthesis::rank::{self, Objective, front};
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
use rating::Rating;
use schemars::JsonSchema;
use serde::Serialize;
use shared_planets::SharedPlanets;
use std::collections::BTreeSet;
use std::ops::ControlFlow;
use teeth::{Choices, Teeth};

/// Maximum number of solutions listed, because the solver evaluates each.
pub const MOST_SOLUTIONS: usize = 10_000;

/// Gearboxes of planetary sets, brakes and clutches that have a list of ratios.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Synthesis {
    /// Required gears.
    pub wanted: Vec<WantedGear>,
    /// Allowed relative deviation of a ratio without a tolerance of its own.
    pub tolerance: f64,
    /// Range of the ring-to-sun ratios k of every simple set.
    pub k_range: [f64; 2],
    /// Range of the ring-to-sun ratios k of every double-planet set; absent if none are searched.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub k_range_of_double_planets: Option<[f64; 2]>,
    /// Minimum number of sets of one kind with equal k; absent if not required.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub equal_k: Option<usize>,
    /// Classes that were searched, in this order.
    pub searched: Vec<Searched>,
    /// Pairs of sun and ring of simple and double-planet sets left out because a tooth check fails.
    pub teeth_left_out: Vec<TeethLeftOut>,
    /// Combinations of shift elements that have all gears but were left out, by reason.
    pub left_out: Vec<LeftOut>,
    /// Limits of a usable gearbox; null if the search ended at the first class with gearboxes, usable or not.
    pub limits_of_use: Option<LimitsOfUse>,
    /// Gearboxes not listed because larger classes have usable ones, by the first limit that they exceed.
    pub left_behind: Vec<LeftOut>,
    /// Number of solutions within all limits of a usable gearbox.
    pub of_use: usize,
    /// Parts of the time in the required gears, for the weighted mean efficiency; absent if none are given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shares: Option<Vec<f64>>,
    /// Whether all structures of these classes were searched.
    pub complete: bool,
    /// Number of solutions found.
    pub found: usize,
    /// Families of solutions with equal formulas, up to an exchange of sets of one kind, the best first.
    pub families: Vec<Family>,
    /// Whether only the best solution of each family is listed, or all solutions.
    pub listed: Listed,
    /// Number of solutions listed.
    pub shown: usize,
    /// Objectives by which the solutions are ordered; the first decides first.
    pub order: Vec<Objective>,
    /// Objectives of the Pareto front.
    pub objectives: Vec<Objective>,
    /// Number of non-dominated solutions, among those with as many gears as the first.
    pub non_dominated: usize,
    /// Objective by which the first solution is ahead; null if it is alone or all are equal.
    pub decided_by: Option<Objective>,
    /// Comparison of a given gearbox with the search; null if none was given.
    pub explanation: Option<Explanation>,
    /// Gearbox of fewer sets that narrowly misses the ratios; null if none is known.
    pub near_miss: Option<NearMiss>,
    /// Listed solutions, the best first.
    pub solutions: Vec<Solution>,
    /// Judgement of the first solution by rules of practice, with its best tooth numbers if requested.
    pub judgement: Judgement,
}

/// Selections of solutions for the list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Listed {
    /// Best solution of each family.
    BestOfFamilies,
    /// Complete list of the solutions.
    AllGearboxes,
}

/// Class of structures that was searched.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Searched {
    /// Name of the class.
    pub class: Kind,
    /// Number of planetary sets.
    pub sets: usize,
    /// Number of double-planet sets among them.
    pub double_planets: usize,
    /// Number of moving links.
    pub links: usize,
    /// Number of shift elements.
    pub shift_elements: usize,
    /// Number of shift elements that a gear engages.
    pub engaged: usize,
    /// Number of gears searched for, without the optional ones that were left out.
    pub gears: usize,
    /// Number of structures in the class, each counted once.
    pub structures: usize,
    /// Size of the search space: structures × choices of double-planet sets × sets of shift elements.
    pub space: f64,
    /// Number of structures that were searched; fewer than all if the search was stopped.
    pub structures_searched: u64,
    /// Number of structures in which some shift elements can reach each gear.
    pub structures_in_reach: u64,
    /// Number of sets of shift elements that have all gears.
    pub solutions: usize,
    /// Number of sets that have all gears, but with a k that has no effect on them: a simpler gearbox does
    /// the same.
    pub reducible: u64,
    /// Number of sets for which neither a solution was found nor its absence proved.
    pub undecided: u64,
}

/// Gearbox that has the required ratios.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Solution {
    /// Number of the solution among all solutions found, from 1, the best first.
    pub number: usize,
    /// Number of the solution's family.
    pub family: usize,
    /// Number of gearboxes in the family.
    pub gearboxes_of_family: usize,
    /// Equal scheme of the document; null if none exists.
    pub scheme: Option<&'static str>,
    /// Links of sun, ring and carrier of each set: 0 the housing, 1 the input, 2 the output, letters the
    /// others. A star marks a double-planet set.
    pub structure: String,
    /// Planetary sets of the solution.
    pub sets: Vec<Set>,
    /// Shift elements of the solution.
    pub shift_elements: Vec<ShiftElement>,
    /// Gears in the order in which they were required.
    pub gears: Vec<Gear>,
    /// Numbers, from 1, of the required gears that the solution does not have.
    pub missing_gears: Vec<usize>,
    /// Largest relative deviation of a ratio from the required one; 0 if only ranges are required.
    pub greatest_deviation: f64,
    /// Number of shifts between neighbouring forward gears that exchange more than one shift element.
    pub multiple_shifts: usize,
    /// Least efficiency of a forward gear; without forward gears, of any gear.
    pub forward_efficiency: f64,
    /// Mean efficiency of the forward gears, weighted by their parts of the time; absent if none are given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mean_efficiency: Option<f64>,
    /// Least efficiency of a reverse gear; null if none exists.
    pub reverse_efficiency: Option<f64>,
    /// First limit of a usable gearbox that the solution exceeds; null if it exceeds none.
    pub beyond_limit: Option<Reason>,
    /// Sets with a common carrier and a common sun or ring. Those that share planets are rated as one
    /// compound set.
    pub shared_planets: Vec<SharedPlanets>,
    /// Greatest slip of an open shift element in a gear, relative to the input speed.
    pub greatest_slip: f64,
    /// Greatest speed of a link in a gear, relative to the input speed.
    pub greatest_link_speed: f64,
    /// Greatest planet speed relative to its carrier, relative to the input speed; for double-planet sets a
    /// lower bound for any tooth numbers, `2·|ω_sun − ω_carrier|/(k − 1)`.
    pub greatest_planet_speed: f64,
    /// Values of the objectives.
    pub rating: Rating,
    /// Tooth numbers; null if none were requested.
    pub teeth: Option<Teeth>,
}

/// Planetary set of a solution.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Set {
    /// Link of the sun.
    pub sun: char,
    /// Link of the ring.
    pub ring: char,
    /// Link of the carrier.
    pub carrier: char,
    /// Whether the set is a double-planet set, with two planets in mesh between sun and ring.
    pub is_double_planet: bool,
    /// Ring-to-sun ratio for which the largest deviation is least.
    pub k: f64,
    /// Range of k within all tolerances, while the k of the other sets is adjusted.
    pub k_range: [f64; 2],
    /// Whether k is required to be equal to that of other sets, which have this mark as well.
    pub has_equal_k: bool,
    /// End of the search range that k reaches; absent if none. A wider range may then have better solutions.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at_edge: Option<Edge>,
}

/// Brake or clutch of a solution.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ShiftElement {
    /// Name of the shift element: `B1`, `B2` … for brakes, `C1`, `C2` … for clutches.
    pub name: String,
    /// Joined links: for a brake its link and the housing, for a clutch its two links.
    pub joins: String,
    /// Whether the shift element is a brake, which holds a link on the housing.
    pub is_brake: bool,
    /// Equivalent elements, which lock the same links and may replace it.
    pub instead: Vec<String>,
}

/// Gear of a solution.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Gear {
    /// Required ratio; absent if any ratio within bounds is accepted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wanted_ratio: Option<f64>,
    /// Ratio with the k of the sets, as computed by the solver.
    pub ratio: f64,
    /// Relative deviation from the required ratio; absent if any ratio within bounds is accepted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deviation: Option<f64>,
    /// Formula of the ratio in the k of the sets; for a double-planet set in k′ = k − 1.
    pub formula: String,
    /// Names of the engaged shift elements.
    pub engaged: Vec<String>,
    /// Efficiency with the given efficiency of the sets; absent if the losses hold the gear.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub efficiency: Option<f64>,
}

impl Answer for Synthesis {
    const NAME: &'static str = "synthesize";
}

/// Searches for all gearboxes that have the required ratios.
///
/// # Errors
/// Errors of [`solve`].
pub fn answer(
    wanted: &Wanted,
    progress: &(dyn Fn(&Searching, Progress) -> ControlFlow<()> + Sync),
) -> Result<Synthesis, Error> {
    solve(wanted, progress).map(|(answer, _)| answer)
}

/// Searches for gearboxes, and also returns the listed solutions in the form of the search. Before each class
/// `progress` is called; it may end the search, which keeps the results up to then.
///
/// # Errors
/// [`Error::Synthesis`] if no class can have the ratios, and for impossible limits of teeth.
pub fn solve(
    wanted: &Wanted,
    progress: &(dyn Fn(&Searching, Progress) -> ControlFlow<()> + Sync),
) -> Result<(Synthesis, Vec<Kept>), Error> {
    solve_by(wanted, &mut |searching: &Searching, wish: &Wish| {
        wanted.limits.check(&wish.gears)?;
        Ok(search(searching.class, wish, Share::WHOLE, &|at| progress(searching, at))?)
    })
}

/// Searches each class with the given backend; otherwise equal to [`solve`].
///
/// # Errors
/// Errors of [`solve`], and those of the search.
pub fn solve_by<E: From<Error>>(
    wanted: &Wanted,
    means: &mut dyn Means<E>,
) -> Result<(Synthesis, Vec<Kept>), E> {
    let k_double = (*wanted.double_planets.end() > 0).then(|| wanted.k_double.clone());
    let choices = wanted.teeth.as_ref().map(|teeth| Choices::wanted(teeth, k_double)).transpose()?;
    let order = Objective::order(&wanted.order);
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
        order: order.clone(),
        objectives: wanted.objectives.clone(),
        non_dominated: 0,
        decided_by: None,
        explanation: None,
        near_miss: None,
        solutions: Vec::new(),
        judgement: Judgement::default(),
    };
    let mut left_out = LeftOuts::default();
    let mut kept: Vec<Kept> = Vec::new();
    let mut before: Option<Searching> = None;
    // Number of kept solutions from smaller classes without a usable one.
    let mut behind = 0;
    let mut known = BTreeSet::new();
    for Tried { searching, wish, selection } in tried(wanted)? {
        let size = |of: &Searching| (of.class.sets(), of.shift_elements);
        // Other numbers of engaged elements are searched too, for an equal number of sets and elements.
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
        // A gearbox found with more gears is not listed again with fewer.
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
    // The objectives can only be compared between solutions with equally many gears.
    let alike = kept.iter().filter(|one| one.selection.len() == kept[0].selection.len()).count();
    let ratings: Vec<&rank::Rating> = kept[..alike].iter().map(|kept| &kept.rating).collect();
    let on_front = front(&ratings, &wanted.objectives);
    let behind = |place: usize| ratings.get(place)?.decides(ratings[0], &order);
    let first_of = |objectives: &mut dyn Iterator<Item = Objective>| {
        objectives.min_by_key(|objective| order.iter().position(|other| other == objective))
    };
    answer.found = kept.len();
    answer.non_dominated = on_front.len();
    answer.decided_by = first_of(&mut (1..kept.len()).filter_map(behind));
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
    if let Some(first) = kept.first() {
        answer.judgement = judged(first, &answer.wanted)?;
    }
    Ok((answer, kept))
}

/// Judgement of a solution, with the ratios for which one is asked.
fn judged(kept: &Kept, wanted: &[WantedGear]) -> Result<Judgement, Error> {
    let gearbox = saved::gearbox(kept, &format!("Gearbox {}", kept.number), kept.teeth.first())?;
    let mut ratios = vec![];
    for (gear, place) in gearbox.gears().iter().zip(&kept.selection) {
        let WantedGear { wanted_ratio, least_ratio, greatest_ratio, .. } = wanted[*place];
        let found = gearbox.analyze_gear(gear)?.ratio();
        if let (Some(wanted), Some(found)) = (wanted_ratio, found) {
            let tolerance = (greatest_ratio - least_ratio).abs() / 2.0 / wanted.abs();
            ratios.push(FoundRatio { gear: gear.name().to_owned(), wanted, tolerance, found });
        }
    }
    Ok(Judgement::of_found(&gearbox, &[], &ratios))
}

/// Places of the solutions to be listed, in increasing order.
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

/// Key by which two solutions are the same gearbox: structure and elements.
fn identity(found: &Found) -> (Structure, Vec<Vec<Element>>) {
    let mut elements = found.solution.elements.clone();
    elements.iter_mut().for_each(|pairs| pairs.sort_unstable());
    (found.structure.clone(), elements)
}

impl Searched {
    fn of(searching: &Searching, gears: usize, answered: &run::Answer) -> Self {
        let class = searching.class;
        Self {
            class: class.kind(),
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

/// Symbol of a set in formulas: `k₁`, for a double-planet set `k₁′`.
fn symbol(structure: &Structure, set: usize) -> String {
    let prime = if structure.is_double_planet(set) { "′" } else { "" };
    format!("{}{prime}", subscript('k', set + 1))
}

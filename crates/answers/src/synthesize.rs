//! All gearboxes that have a list of ratios.

use crate::{Answer, Error};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_synthesis::gearbox::element_name;
use epicyclic_synthesis::judge::{Judged, judge};
use epicyclic_synthesis::motion::elements;
use epicyclic_synthesis::parts::Bounds;
use epicyclic_synthesis::run::{self, Found, Progress, Share, search};
use epicyclic_synthesis::structure::link_name;
use epicyclic_synthesis::wish::Wish;
use epicyclic_synthesis::{Class, Kind};
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::{ControlFlow, RangeInclusive};

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
    /// These: those with the fewest multiple shifts first, of equal ones those with the higher least efficiency.
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

/// All gearboxes that have the wanted ratios. Before each class is searched `progress` is told of it; a break ends the search,
/// and what was found is kept.
///
/// # Errors
/// [`Error::Synthesis`] where no class can have the ratios.
pub fn answer(
    wanted: &Wanted,
    progress: &(dyn Fn(&Searching, Progress) -> ControlFlow<()> + Sync),
) -> Result<Synthesis, Error> {
    answer_by(wanted, &mut |searching, wish| {
        Ok(search(searching.class, wish, Share::WHOLE, &|at| progress(searching, at))?)
    })
}

/// The same where each class is searched by other means.
///
/// # Errors
/// As [`answer`], and those of the search.
pub fn answer_by<E: From<Error>>(
    wanted: &Wanted,
    search: &mut dyn FnMut(&Searching, &Wish) -> Result<run::Answer, E>,
) -> Result<Synthesis, E> {
    let mut answer = Synthesis {
        wanted_ratios: wanted.ratios.clone(),
        tolerance: wanted.tolerance,
        k_range: [*wanted.k.start(), *wanted.k.end()],
        searched: Vec::new(),
        complete: true,
        found: 0,
        shown: 0,
        solutions: Vec::new(),
    };
    let mut judged: Vec<(Found, Judged)> = Vec::new();
    let mut before = None;
    for (searching, wish) in tried(wanted)? {
        let Searching { class, shift_elements } = searching;
        // All that engage another number of as many elements are searched, too.
        if before.is_some_and(|before| before != (class.sets(), shift_elements)) && !judged.is_empty() {
            break;
        }
        before = Some((class.sets(), shift_elements));
        let found = search(&searching, &wish)?;
        answer.complete &= found.complete;
        answer.searched.push(Searched {
            class: ClassName::of(class.kind()),
            sets: class.sets(),
            links: class.links(),
            shift_elements,
            engaged: class.engaged(),
            structures: found.class_size,
            space: searching.space(found.class_size as f64),
            structures_searched: found.tally.structures,
            structures_in_reach: found.tally.in_reach,
            solutions: found.found.len(),
            reducible: found.tally.reducible,
            undecided: found.tally.undecided,
        });
        for solution in found.found {
            let judgement = judge(&solution, &wish, wanted.efficiency).map_err(Error::from)?;
            judged.push((solution, judgement));
        }
        if !found.complete {
            break;
        }
    }
    judged.sort_by(|(_, one), (_, other)| {
        let efficiency = other.least_efficiency().total_cmp(&one.least_efficiency());
        one.multiple_shifts.cmp(&other.multiple_shifts).then(efficiency)
    });
    answer.found = judged.len();
    answer.shown = judged.len().min(wanted.most).min(MOST_SOLUTIONS);
    answer.solutions = judged[..answer.shown]
        .iter()
        .map(|(found, judged)| Solution::of(found, judged, &wanted.ratios))
        .collect();
    Ok(answer)
}

/// The classes that may be searched, in their order, and what is wished in each. Those that cannot have the ratios are left out.
///
/// # Errors
/// [`Error::Synthesis`] where there is none.
pub fn tried(wanted: &Wanted) -> Result<Vec<(Searching, Wish)>, Error> {
    let gears: Vec<Bounds> = wanted.ratios.iter().map(|ratio| around(*ratio, wanted.tolerance)).collect();
    let (mut tried, mut refused) = (Vec::new(), None);
    for sets in wanted.sets.clone() {
        for shift_elements in wanted.elements.clone() {
            for engaged in wanted.engaged.clone() {
                let wish = Wish::new(gears.clone(), shift_elements, vec![wanted.k.clone(); sets]);
                let class = Class::new(wanted.kind, sets, sets + engaged + 1);
                match class.and_then(|class| wish.check(class).map(|()| class)) {
                    Ok(class) => tried.push((Searching { class, shift_elements }, wish)),
                    Err(error) => {
                        refused.get_or_insert(error);
                    }
                }
            }
        }
    }
    match refused {
        Some(error) if tried.is_empty() => Err(error.into()),
        _ => Ok(tried),
    }
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
    /// Structures, so many, times sets of shift elements.
    #[must_use]
    pub fn space(&self, structures: f64) -> f64 {
        let pairs = elements(self.class.links()).len();
        (0..self.shift_elements)
            .fold(structures, |all, place| all * pairs.saturating_sub(place) as f64 / (place + 1) as f64)
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
    fn of(found: &Found, judged: &Judged, wanted: &[f64]) -> Self {
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
            structure: found.structure.to_string(),
            sets: sets.collect(),
            shift_elements: shift_elements.collect(),
            greatest_deviation: gears.iter().map(|gear| gear.deviation.abs()).fold(0.0, f64::max),
            gears,
            multiple_shifts: judged.multiple_shifts,
            least_efficiency: judged.least_efficiency(),
        }
    }
}

//! A given gearbox beside a search: which wanted ratio it misses, and as which number it is found, or why it is not.
//!
//! The gearbox is taken to a structure of the search: links joined for ever are one, and a double-planet set is, for its speeds, a
//! simple set with ring and carrier exchanged and `k′ = k − 1`. It is found where a solution has its structure and, up to the
//! structure's automorphisms, its shift elements; of those that lock the same each stands for the others.

use super::{Kept, Synthesis, Wanted, WantedGear};
use crate::Error;
use epicyclic_synthesis::Kind;
use epicyclic_synthesis::gearbox::element_name;
use epicyclic_synthesis::motion::{Element, Motion};
use epicyclic_synthesis::ratio::Ratio;
use epicyclic_synthesis::structure::{HOUSING, INPUT, Link, Members, OUTPUT, Structure};
use epicyclic_train::set::SetKind;
use epicyclic_train::{Analysis, Gearbox, LinkId};
use schemars::JsonSchema;
use serde::Serialize;

/// A given gearbox beside a search.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Explanation {
    /// The name of the gearbox.
    pub gearbox: String,
    /// Its structure as the search names it; `null` where it is none.
    pub structure: Option<String>,
    /// Its shift elements as the search names them: a brake's link, or the two links of a clutch.
    pub shift_elements: Vec<String>,
    /// Each wanted ratio beside the nearest of the gearbox.
    pub gears: Vec<NearestGear>,
    /// Whether the gearbox has all wanted ratios at its own ring-to-sun ratios.
    pub has_all_ratios: bool,
    /// Its number among the solutions found, also of those that are not told; `null` where it is not found.
    pub number: Option<usize>,
    /// Why it is not found; empty where it is.
    pub reasons: Vec<Reason>,
}

/// A wanted ratio and the nearest of a gearbox.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct NearestGear {
    /// What is wanted of it.
    pub wanted: WantedGear,
    /// The nearest ratio of any choice of shift elements; `null` where none drives the output.
    pub ratio: Option<f64>,
    /// How far it is from the ratio wanted, as a share of it, or from the nearer bound where any ratio within bounds will do.
    pub deviation: Option<f64>,
    /// Whether it is within the bounds.
    pub within: bool,
    /// The shift elements engaged, by the names of the gearbox.
    pub engaged: Vec<String>,
}

/// Why a gearbox is not among the solutions of a search.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Reason {
    /// A set is neither simple nor a double-planet set.
    SetKind {
        /// The set.
        set: String,
    },
    /// The sets make no structure of a class.
    NoStructure {
        /// What is wrong.
        why: String,
    },
    /// A member on the housing: class `core` has none.
    MemberOnHousing,
    /// The input or the output is on no member: class `core` needs both.
    TerminalOnNoMember,
    /// The sets are not all joined: class `core` needs it.
    SetsNotJoined,
    /// So many planet sets were not searched.
    Sets {
        /// How many it has.
        count: usize,
    },
    /// So many shift elements were not searched.
    ShiftElements {
        /// How many it has, those that lock the same counted once.
        count: usize,
    },
    /// Gears that engage so many shift elements were not searched.
    Engaged {
        /// How many a gear engages.
        count: usize,
    },
    /// The search tries fewer sets and shift elements first, and ended where some had solutions.
    EndedBefore,
    /// A brake on the input or the output.
    BrakeOnTerminal {
        /// The shift element.
        shift_element: String,
    },
    /// A `k` beyond the range.
    KOutOfRange {
        /// The set.
        set: String,
        /// Its `k`, of a double-planet set `k′ = k − 1`.
        k: f64,
    },
    /// The `k` of a set moves no wanted ratio: a simpler gearbox does the same.
    Reducible {
        /// The set.
        set: String,
    },
    /// It misses wanted ratios, and no other ring-to-sun ratios in the range give them.
    MissesRatios,
    /// A further wish may leave it out: brakes, clutches, shifts, steps, slips, speeds, drawability.
    FurtherWishes,
    /// The search counts it as undecided.
    Undecided,
}

/// A gearbox as the search has it.
struct Subject {
    structure: Structure,
    elements: Vec<Element>,
    /// For each shift element of the gearbox its place in `elements`; none where it joins a link with itself.
    places: Vec<Option<usize>>,
    /// For each set of the structure its name and its `k`.
    sets: Vec<(String, f64)>,
}

/// Places a gearbox beside a search: its answer, and all solutions in the order of their numbers.
///
/// # Errors
/// Those of the solver for more than 16 shift elements.
pub(super) fn explain(
    gearbox: &Gearbox,
    wanted: &Wanted,
    answer: &Synthesis,
    kept: &[Kept],
) -> Result<Explanation, Error> {
    let all = gearbox.combinations(0..=gearbox.shift_elements().len())?;
    let gears: Vec<NearestGear> = answer.wanted.iter().map(|wanted| NearestGear::of(*wanted, &all)).collect();
    let has_all_ratios = gears.iter().all(|gear| gear.within || gear.wanted.may_be_missing);
    let mut explanation = Explanation {
        gearbox: gearbox.name().to_owned(),
        structure: None,
        shift_elements: vec![],
        gears,
        has_all_ratios,
        number: None,
        reasons: vec![],
    };
    let subject = match Subject::of(gearbox) {
        Ok(subject) => subject,
        Err(reason) => {
            explanation.reasons.push(reason);
            return Ok(explanation);
        }
    };
    explanation.structure = Some(subject.structure.to_string());
    explanation.shift_elements = subject.elements.iter().map(|element| element_name(*element)).collect();
    explanation.number = kept.iter().position(|kept| subject.is(kept)).map(|place| place + 1);
    if explanation.number.is_none() {
        explanation.reasons = subject.reasons(wanted, answer, &explanation, gearbox);
    }
    Ok(explanation)
}

impl NearestGear {
    fn of(wanted: WantedGear, all: &[Analysis<'_>]) -> Self {
        let deviations = all.iter().filter_map(|analysis| {
            let ratio = analysis.ratio().filter(|ratio| ratio.is_finite())?;
            let aim = wanted.wanted_ratio.unwrap_or(ratio.clamp(wanted.least_ratio, wanted.greatest_ratio));
            Some((analysis, ratio, ratio / aim - 1.0))
        });
        let nearest = deviations.min_by(|one, other| one.2.abs().total_cmp(&other.2.abs()));
        let engaged = |analysis: &Analysis<'_>| {
            let gearbox = analysis.gearbox();
            let name = |place: &usize| gearbox.shift_elements()[*place].id().to_owned();
            analysis.gear().engaged().iter().map(name).collect()
        };
        Self {
            wanted,
            ratio: nearest.map(|(_, ratio, _)| ratio),
            deviation: nearest.map(|(.., deviation)| deviation),
            within: nearest.is_some_and(|(_, ratio, _)| wanted.holds(ratio)),
            engaged: nearest.map_or_else(Vec::new, |(analysis, ..)| engaged(analysis)),
        }
    }
}

/// The link of each link of a gearbox, those joined for ever as one; the other links by their first occurrence.
fn links(gearbox: &Gearbox) -> Result<Vec<Link>, Reason> {
    let count = gearbox.links().len();
    let mut group: Vec<usize> = (0..count).collect();
    for [one, other] in gearbox.permanent() {
        let (from, to) = (group[one.index()], group[other.index()]);
        group.iter_mut().filter(|link| **link == from).for_each(|link| *link = to);
    }
    let mut names: Vec<Option<Link>> = vec![None; count];
    let mut give = |link: LinkId, name: Link| {
        let known = &mut names[group[link.index()]];
        match known {
            Some(_) => Err(Reason::NoStructure {
                why: "two of the housing, the input and the output are one link".to_owned(),
            }),
            None => {
                *known = Some(name);
                Ok(())
            }
        }
    };
    give(LinkId::GROUND, HOUSING)?;
    give(gearbox.input(), INPUT)?;
    give(gearbox.output(), OUTPUT)?;
    let mut next = OUTPUT + 1;
    for link in 0..count {
        let name = &mut names[group[link]];
        if name.is_none() {
            *name = Some(next);
            next = next.saturating_add(1);
        }
    }
    Ok(group.iter().map(|of| names[*of].unwrap_or(HOUSING)).collect())
}

impl Subject {
    fn of(gearbox: &Gearbox) -> Result<Self, Reason> {
        let links = links(gearbox)?;
        let link = |id: LinkId| links[id.index()];
        let mut given: Vec<(Members, String, f64)> = Vec::new();
        for set in gearbox.sets() {
            let [sun, ring, carrier] = match set.members() {
                [sun, ring, carrier] => [*sun, *ring, *carrier].map(link),
                _ => return Err(Reason::SetKind { set: set.id().to_owned() }),
            };
            let k = set.basic_ratio().get().abs();
            given.push(match set.kind() {
                Some(SetKind::Simple) => ([sun, ring, carrier], set.id().to_owned(), k),
                Some(SetKind::DoublePlanet) => ([sun, carrier, ring], set.id().to_owned(), k - 1.0),
                _ => return Err(Reason::SetKind { set: set.id().to_owned() }),
            });
        }
        let members: Vec<Members> = given.iter().map(|(members, ..)| *members).collect();
        let count = links.iter().copied().max().map_or(0, usize::from);
        let (structure, order) = Structure::canonical(&members, count)
            .map_err(|error| Reason::NoStructure { why: error.to_string() })?;
        // Where each link stands in the canonical word; input and output keep their names.
        let mut names: Vec<Link> =
            (0..=structure.links()).map(|link| Link::try_from(link).unwrap_or(0)).collect();
        for (set, place) in structure.sets().iter().zip(&order) {
            for (canonical, given) in set.iter().zip(members[*place]) {
                names[usize::from(given)] = *canonical;
            }
        }
        let (mut elements, mut places): (Vec<Element>, Vec<Option<usize>>) = (Vec::new(), Vec::new());
        for element in gearbox.shift_elements() {
            let mut pair = element.links().map(|id| names[usize::from(link(id))]);
            pair.sort_unstable();
            if pair == [HOUSING, INPUT] || pair == [HOUSING, OUTPUT] {
                return Err(Reason::BrakeOnTerminal { shift_element: element.id().to_owned() });
            }
            let known = elements.iter().position(|known| *known == pair);
            places.push((pair[0] != pair[1]).then(|| known.unwrap_or(elements.len())));
            if pair[0] != pair[1] && known.is_none() {
                elements.push(pair);
            }
        }
        let sets = order.iter().map(|place| (given[*place].1.clone(), given[*place].2)).collect();
        Ok(Self { structure, elements, places, sets })
    }

    /// Whether a solution is this gearbox, by some automorphism.
    fn is(&self, kept: &Kept) -> bool {
        let (structure, solution) = (&kept.found.structure, &kept.found.solution);
        let covered = |names: &[Link]| {
            let mut places: Vec<Option<usize>> = self
                .elements
                .iter()
                .map(|element| {
                    let mut pair = element.map(|link| names[usize::from(link)]);
                    pair.sort_unstable();
                    solution.elements.iter().position(|pairs| pairs.contains(&pair))
                })
                .collect();
            places.sort_unstable();
            places.dedup();
            places.len() == solution.elements.len() && places.iter().all(Option::is_some)
        };
        *structure == self.structure
            && structure.automorphisms().iter().any(|order| covered(&structure.renaming(order)))
    }

    fn reasons(
        &self,
        wanted: &Wanted,
        answer: &Synthesis,
        explanation: &Explanation,
        gearbox: &Gearbox,
    ) -> Vec<Reason> {
        let mut reasons = Vec::new();
        let (sets, engaged) = (self.structure.sets().len(), self.structure.freedom() - 1);
        let members = self.structure.sets();
        if wanted.kind == Kind::Core {
            let on_member = |link: Link| members.iter().flatten().any(|member| *member == link);
            if on_member(HOUSING) {
                reasons.push(Reason::MemberOnHousing);
            }
            if !on_member(INPUT) || !on_member(OUTPUT) {
                reasons.push(Reason::TerminalOnNoMember);
            }
            if !are_joined(members) {
                reasons.push(Reason::SetsNotJoined);
            }
        }
        if !wanted.sets.contains(&sets) {
            reasons.push(Reason::Sets { count: sets });
        }
        let count = self.elements_that_differ();
        if !wanted.elements.contains(&count) {
            reasons.push(Reason::ShiftElements { count });
        }
        if !wanted.engaged.contains(&engaged) {
            reasons.push(Reason::Engaged { count: engaged });
        }
        for (set, k) in &self.sets {
            if !wanted.k.contains(k) {
                reasons.push(Reason::KOutOfRange { set: set.clone(), k: *k });
            }
        }
        let was_searched = answer
            .searched
            .iter()
            .any(|class| class.sets == sets && class.shift_elements == count && class.engaged == engaged);
        if reasons.is_empty() && was_searched && wanted.has_further_wishes() {
            reasons.push(Reason::FurtherWishes);
        }
        if reasons.is_empty() && !was_searched {
            reasons.push(Reason::EndedBefore);
        }
        if explanation.has_all_ratios {
            reasons.extend(self.unmoved(explanation, gearbox));
        } else {
            reasons.push(Reason::MissesRatios);
        }
        if reasons.is_empty() {
            reasons.push(if answer.complete { Reason::Undecided } else { Reason::EndedBefore });
        }
        reasons
    }

    /// Shift elements, those that lock the same counted once.
    fn elements_that_differ(&self) -> usize {
        let mut motion = Motion::<u64>::new(self.structure.freedom());
        motion.take(&self.structure, &self.elements);
        let count = self.elements.len();
        (0..count).filter(|one| !(0..*one).any(|other| motion.tie_the_same(*one, other))).count()
    }

    /// Sets whose `k` moves none of the wanted ratios.
    fn unmoved(&self, explanation: &Explanation, gearbox: &Gearbox) -> Vec<Reason> {
        let engaged = self.structure.freedom() - 1;
        let mut motion = Motion::<u64>::new(self.structure.freedom());
        motion.take(&self.structure, &self.elements);
        let mut moved = 0;
        for gear in &explanation.gears {
            let places: Vec<usize> = gear
                .engaged
                .iter()
                .filter_map(|name| {
                    let element = gearbox.shift_elements().iter().position(|element| element.id() == name)?;
                    self.places[element]
                })
                .collect();
            if places.len() != engaged {
                return vec![];
            }
            if let Some(ratio) = Ratio::of(motion.gear(&places)) {
                moved |= ratio.variables();
            }
        }
        let sets = self.sets.iter().enumerate().filter(|(place, _)| moved >> place & 1 == 0);
        sets.map(|(_, (set, _))| Reason::Reducible { set: set.clone() }).collect()
    }
}

/// Whether all sets are joined by links but the housing.
fn are_joined(sets: &[Members]) -> bool {
    let mut reached = vec![false; sets.len()];
    let mut todo = vec![0];
    while let Some(set) = todo.pop() {
        if !std::mem::replace(&mut reached[set], true) {
            let share =
                |other: &usize| sets[*other].iter().any(|link| *link != HOUSING && sets[set].contains(link));
            todo.extend((0..sets.len()).filter(share));
        }
    }
    reached.iter().all(|reached| *reached)
}

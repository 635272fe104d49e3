//! Comparison of a given gearbox with a search: the ratio that it misses, and its number among the solutions
//! or the reason why it is not found. A compound set is replaced by the sets that share its planets.
//!
//! The gearbox is converted to a structure of the search, with permanently connected links as one. If
//! double-planet sets are searched, those of the gearbox are kept. A search of simple sets alone replaces
//! each by a simple set with equal speeds: ring and carrier are exchanged and `k′ = k − 1`.
//!
//! The gearbox is found if a solution has its structure and, up to the structure's automorphisms, its shift
//! elements. Elements that lock the same links are equivalent.

use super::{Kept, Synthesis, Wanted, WantedGear};
use crate::error::Error;
use epicyclic_synthesis::Kind;
use epicyclic_synthesis::gearbox::element_name;
use epicyclic_synthesis::motion::{Element, Motion};
use epicyclic_synthesis::ratio::Ratio;
use epicyclic_synthesis::structure::{HOUSING, INPUT, Link, Members, OUTPUT, Structure};
use epicyclic_train::set::SetKind;
use epicyclic_train::{Analysis, Gearbox, LinkId};
use schemars::JsonSchema;
use serde::Serialize;

/// Comparison of a given gearbox with a search.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Explanation {
    /// The name of the gearbox.
    pub gearbox: String,
    /// Structure of the gearbox in the notation of the search; null if none exists.
    pub structure: Option<String>,
    /// Shift elements in the notation of the search: the link of a brake, or the two links of a clutch.
    pub shift_elements: Vec<String>,
    /// Required ratios with the closest ones of the gearbox.
    pub gears: Vec<NearestGear>,
    /// Whether the gearbox has all required ratios with its own ring-to-sun ratios.
    pub has_all_ratios: bool,
    /// Number among all solutions found, listed or not; null if the gearbox is not found.
    pub number: Option<usize>,
    /// Number of the family; null if the gearbox is not found.
    pub family: Option<usize>,
    /// Reasons why the gearbox is not found; empty if it is found.
    pub reasons: Vec<Reason>,
}

/// Required ratio with the closest one of a gearbox.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct NearestGear {
    /// Required gear.
    pub wanted: WantedGear,
    /// Closest ratio of any combination of shift elements; null if none drives the output.
    pub ratio: Option<f64>,
    /// Relative deviation from the required ratio, or from the closer bound if any ratio within bounds is
    /// accepted; null without a ratio.
    pub deviation: Option<f64>,
    /// Whether the ratio is within the bounds.
    pub within: bool,
    /// Names of the engaged shift elements in the gearbox.
    pub engaged: Vec<String>,
}

/// Reason why a gearbox is not among the solutions of a search.
#[derive(Debug, Clone, PartialEq, Default, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Reason {
    /// Kind of the reason.
    pub obstacle: Obstacle,
    /// Set concerned; null if the reason concerns none.
    pub set: Option<String>,
    /// Value of `k` of this set; for a double-planet set in a search of simple sets `k′ = k − 1`. Null except
    /// for `k_out_of_range` and `k_of_double_planet_out_of_range`.
    pub k: Option<f64>,
    /// Number of parts that was not searched, or number of equal k that was required; null for other reasons.
    pub count: Option<usize>,
    /// Shift element concerned; null if the reason concerns none.
    pub shift_element: Option<String>,
}

/// Reasons that exclude a gearbox from a search.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Obstacle {
    /// A set is neither simple nor a double-planet set.
    SetKind,
    /// Two of the housing, the input and the output are one link.
    TerminalsJoined,
    /// The sets form no structure: a set has a link twice, a link is on no member, or sets share so many
    /// links that they lock or repeat each other.
    NoStructure,
    /// A brake on the input or the output.
    BrakeOnTerminal,
    /// A member on the housing: class `core` has none.
    MemberOnHousing,
    /// The input or the output is on no member: class `core` needs both.
    TerminalOnNoMember,
    /// The sets are not all joined: class `core` requires this.
    SetsNotJoined,
    /// Number of planetary sets that was not searched.
    Sets,
    /// Number of shift elements that was not searched; equivalent elements count once.
    ShiftElements,
    /// Number of engaged shift elements that was not searched.
    Engaged,
    /// The search ended before this number of sets and shift elements.
    EndedBefore,
    /// Number of double-planet sets that was not searched.
    DoublePlanets,
    /// A `k` of a simple set beyond the range.
    KOutOfRange,
    /// A `k` of a double-planet set beyond its range.
    KOfDoublePlanetOutOfRange,
    /// The `k` of a set has no effect on any required ratio: a simpler gearbox does the same.
    Reducible,
    /// No required gear engages a shift element: a gearbox without it does the same.
    UnusedElement,
    /// With the required number of sets with equal k the gearbox does not have the ratios.
    EqualK,
    /// The gearbox misses required ratios, and no other ring-to-sun ratios in the range give them.
    MissesRatios,
    /// The gearbox breaks another rule of the search, or counts as undecided.
    #[default]
    Other,
}

impl Reason {
    fn new(obstacle: Obstacle) -> Self {
        Self { obstacle, ..Self::default() }
    }

    fn of_set(obstacle: Obstacle, set: &str) -> Self {
        Self { set: Some(set.to_owned()), ..Self::new(obstacle) }
    }

    fn of_count(obstacle: Obstacle, count: usize) -> Self {
        Self { count: Some(count), ..Self::new(obstacle) }
    }
}

/// Gearbox in the notation of the search.
struct Subject {
    structure: Structure,
    elements: Vec<Element>,
    /// Index in `elements` for each shift element of the gearbox; `None` if it joins a link with itself.
    places: Vec<Option<usize>>,
    /// Name and `k` of each set of the structure; for a double-planet set the real `k`.
    sets: Vec<(String, f64)>,
}

/// Compares a gearbox with a search; `kept` holds all solutions in the order of their numbers.
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
    let gears: Vec<NearestGear> = wanted.gears()?.iter().map(|gear| NearestGear::of(*gear, &all)).collect();
    let has_all_ratios = gears.iter().all(|gear| gear.within || gear.wanted.may_be_missing);
    let mut explanation = Explanation {
        gearbox: gearbox.name().to_owned(),
        structure: None,
        shift_elements: vec![],
        gears,
        has_all_ratios,
        number: None,
        family: None,
        reasons: vec![],
    };
    let subject = match Subject::of(gearbox, wanted) {
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
        explanation.reasons = subject.reasons(wanted, answer, &explanation, gearbox, &all);
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

/// Link of the structure for each link of a gearbox, with permanently connected links as one. Links other
/// than the terminals are named by their first occurrence.
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
            Some(_) => Err(Reason::new(Obstacle::TerminalsJoined)),
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
    fn of(gearbox: &Gearbox, wanted: &Wanted) -> Result<Self, Reason> {
        let links = links(gearbox)?;
        let link = |id: LinkId| links[id.index()];
        // In a search of simple sets alone a double-planet set is replaced by a simple one.
        let as_simple = *wanted.double_planets.end() == 0;
        let mut given: Vec<(Members, bool, String, f64)> = Vec::new();
        // A compound set is replaced by the sets that share its planets.
        for drawn in gearbox.drawn_sets() {
            let set = &gearbox.sets()[drawn.set];
            let [sun, ring, carrier] = drawn.links.map(link);
            let k = drawn.basic_ratio(gearbox).abs();
            let (members, double, k) = match drawn.kind {
                SetKind::Simple => ([sun, ring, carrier], false, k),
                SetKind::DoublePlanet if as_simple => ([sun, carrier, ring], false, k - 1.0),
                SetKind::DoublePlanet => ([sun, ring, carrier], true, k),
                _ => return Err(Reason::of_set(Obstacle::SetKind, set.id())),
            };
            given.push((members, double, set.id().to_owned(), k));
        }
        let members: Vec<(Members, bool)> =
            given.iter().map(|(members, double, ..)| (*members, *double)).collect();
        let count = links.iter().copied().max().map_or(0, usize::from);
        let (structure, order) =
            Structure::with_kinds(&members, count).map_err(|_| Reason::new(Obstacle::NoStructure))?;
        // Place of each link in the canonical word; input and output keep their names.
        let mut names: Vec<Link> =
            (0..=structure.links()).map(|link| Link::try_from(link).unwrap_or(0)).collect();
        for (set, place) in order.iter().enumerate() {
            for (canonical, given) in structure.members(set).into_iter().zip(members[*place].0) {
                names[usize::from(given)] = canonical;
            }
        }
        let (mut elements, mut places): (Vec<Element>, Vec<Option<usize>>) = (Vec::new(), Vec::new());
        for element in gearbox.shift_elements() {
            let mut pair = element.links().map(|id| names[usize::from(link(id))]);
            pair.sort_unstable();
            if pair == [HOUSING, INPUT] || pair == [HOUSING, OUTPUT] {
                let shift_element = Some(element.id().to_owned());
                return Err(Reason { shift_element, ..Reason::new(Obstacle::BrakeOnTerminal) });
            }
            let known = elements.iter().position(|known| *known == pair);
            places.push((pair[0] != pair[1]).then(|| known.unwrap_or(elements.len())));
            if pair[0] != pair[1] && known.is_none() {
                elements.push(pair);
            }
        }
        let sets = order.iter().map(|place| (given[*place].2.clone(), given[*place].3)).collect();
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
        all: &[Analysis<'_>],
    ) -> Vec<Reason> {
        let mut reasons = Vec::new();
        let (sets, engaged) = (self.structure.sets().len(), self.structure.freedom() - 1);
        let members = self.structure.sets();
        if wanted.kind == Kind::Core {
            let on_member = |link: Link| members.iter().flatten().any(|member| *member == link);
            if on_member(HOUSING) {
                reasons.push(Reason::new(Obstacle::MemberOnHousing));
            }
            if !on_member(INPUT) || !on_member(OUTPUT) {
                reasons.push(Reason::new(Obstacle::TerminalOnNoMember));
            }
            if !are_joined(members) {
                reasons.push(Reason::new(Obstacle::SetsNotJoined));
            }
        }
        if !wanted.sets.contains(&sets) {
            reasons.push(Reason::of_count(Obstacle::Sets, sets));
        }
        let count = self.elements_that_differ();
        if !wanted.elements.contains(&count) {
            reasons.push(Reason::of_count(Obstacle::ShiftElements, count));
        }
        if !wanted.engaged.contains(&engaged) {
            reasons.push(Reason::of_count(Obstacle::Engaged, engaged));
        }
        let double_planets = self.structure.double_planets();
        if !wanted.double_planets.contains(&double_planets) {
            reasons.push(Reason::of_count(Obstacle::DoublePlanets, double_planets));
        }
        for (place, (set, k)) in self.sets.iter().enumerate() {
            let is_double_planet = self.structure.is_double_planet(place);
            let obstacle =
                if is_double_planet { Obstacle::KOfDoublePlanetOutOfRange } else { Obstacle::KOutOfRange };
            if !wanted.k_of(is_double_planet).contains(k) {
                reasons.push(Reason { k: Some(*k), ..Reason::of_set(obstacle, set) });
            }
        }
        let was_searched = answer.searched.iter().any(|class| {
            class.sets == sets
                && class.double_planets == double_planets
                && class.shift_elements == count
                && class.engaged == engaged
        });
        if reasons.is_empty() && !was_searched {
            reasons.push(Reason::new(Obstacle::EndedBefore));
        }
        if explanation.has_all_ratios {
            reasons.extend(self.unmoved(explanation, gearbox));
            reasons.extend(unused(explanation, gearbox, all));
            if reasons.is_empty() && was_searched && answer.complete && wanted.equal_k > 1 {
                reasons.push(Reason::of_count(Obstacle::EqualK, wanted.equal_k));
            }
        } else if was_searched && answer.complete {
            reasons.push(Reason::new(Obstacle::MissesRatios));
        }
        if reasons.is_empty() {
            reasons.push(Reason::new(if answer.complete { Obstacle::Other } else { Obstacle::EndedBefore }));
        }
        reasons
    }

    /// Number of shift elements; equivalent elements count once.
    fn elements_that_differ(&self) -> usize {
        let mut motion = Motion::<u64>::new(self.structure.freedom());
        motion.take(&self.structure, &self.elements);
        let count = self.elements.len();
        (0..count).filter(|one| !(0..*one).any(|other| motion.tie_the_same(*one, other))).count()
    }

    /// Reasons for sets whose `k` has no effect on any required ratio.
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
        sets.map(|(_, (set, _))| Reason::of_set(Obstacle::Reducible, set)).collect()
    }
}

/// Reasons for shift elements that no required gear needs, because other combinations give it a ratio within
/// its bounds.
fn unused(explanation: &Explanation, gearbox: &Gearbox, all: &[Analysis<'_>]) -> Vec<Reason> {
    let is_unused = |place: usize| {
        let without = |analysis: &&Analysis<'_>| !analysis.gear().engaged().contains(&place);
        explanation.gears.iter().all(|gear| {
            all.iter()
                .filter(without)
                .any(|analysis| analysis.ratio().is_some_and(|ratio| gear.wanted.holds(ratio)))
        })
    };
    let names = gearbox.shift_elements().iter().map(epicyclic_train::ShiftElement::id);
    let names = names.enumerate().filter(|(place, _)| is_unused(*place)).map(|(_, name)| name);
    let reason = |name: &str| {
        let shift_element = Some(name.to_owned());
        Reason { shift_element, ..Reason::new(Obstacle::UnusedElement) }
    };
    names.map(reason).collect()
}

/// Whether links other than the housing join all sets.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shared::gearbox::{Choice, one};
    use crate::synthesize::answer::{Searching, solve, solve_by};
    use epicyclic_formats::Document;
    use epicyclic_formats::WantedRatio;
    use epicyclic_formats::wanted_ratio::Wanted as Ratio;
    use epicyclic_gears::efficiency::MeshEfficiency;
    use epicyclic_synthesis::limits::Limits;
    use epicyclic_synthesis::rules::Rules;
    use epicyclic_synthesis::run::{self, Found};
    use epicyclic_synthesis::search::Search;
    use epicyclic_synthesis::tally::Tally;
    use epicyclic_synthesis::wish::Wish;
    use epicyclic_train::set::SetSpec;
    use std::ops::{ControlFlow, RangeInclusive};

    fn gears(ratios: &[f64]) -> Vec<WantedRatio> {
        let gear = |ratio: &f64| WantedRatio {
            wanted: Ratio::Around { ratio: *ratio, within: None },
            optional: false,
        };
        ratios.iter().map(gear).collect()
    }

    fn wanted(ratios: &[f64], kind: Kind, elements: usize, engaged: usize, explain: Gearbox) -> Wanted {
        Wanted {
            gears: gears(ratios),
            links: 0..=usize::MAX,
            open: 0..=usize::MAX,
            double_planets: 0..=0,
            k_double: 1.6..=4.5,
            equal_k: 1,
            rules: Rules::default(),
            limits: Limits::default(),
            drawable: false,
            shares: None,
            usable: None,
            tolerance: 0.01,
            kind,
            sets: 2..=2,
            elements: elements..=elements,
            engaged: engaged..=engaged,
            k: 1.4..=4.5,
            efficiency: MeshEfficiency::new(0.97).unwrap(),
            most: 1,
            all_gearboxes: false,
            also: None,
            order: vec![],
            objectives: vec![],
            teeth: None,
            explain: Some(explain),
        }
    }

    fn explained(wanted: &Wanted) -> Explanation {
        let (answer, _) = solve(wanted, &|_, _| ControlFlow::Continue(())).unwrap();
        answer.explanation.unwrap()
    }

    fn obstacles(wanted: &Wanted) -> Vec<Obstacle> {
        explained(wanted).reasons.iter().map(|reason| reason.obstacle).collect()
    }

    /// 4L60-E with other names of links, its sets in reverse order, a brake on a permanently connected link,
    /// and an equivalent element for `1-x`.
    fn four_speed() -> Gearbox {
        Gearbox::builder("4L60-E")
            .links(["turbine", "shaft", "P", "Q", "tied", "S"])
            .set(SetSpec::simple("rear", ["S", "shaft", "Q"], 2.294))
            .set(SetSpec::simple("front", ["turbine", "P", "shaft"], 2.059))
            .tie("tied", "S")
            .brake("2-4", "tied")
            .brake("low", "Q")
            .clutch("reverse", "S", "turbine")
            .clutch("3-4", "turbine", "Q")
            .clutch("forward", "P", "Q")
            .input("turbine")
            .output("shaft")
            .build()
            .unwrap()
    }

    const LIST: [f64; 5] = [3.059, 1.625, 1.0, 0.696, -2.294];

    #[test]
    fn a_gearbox_is_found_by_any_names_and_order() {
        let found = explained(&wanted(&LIST, Kind::AllSparse, 5, 2, four_speed()));
        assert!(found.has_all_ratios && found.reasons.is_empty(), "{found:?}");
        assert_eq!(found.structure.as_deref(), Some("1-a-2 b-2-c"));
        assert!(found.number.is_some_and(|number| (1..=14).contains(&number)));
        assert_eq!(found.gears[0].engaged, ["low", "forward"]);
    }

    #[test]
    fn what_keeps_a_gearbox_out_is_told() {
        let list = |kind, elements, engaged| wanted(&LIST, kind, elements, engaged, four_speed());
        assert_eq!(obstacles(&list(Kind::AllSparse, 4, 2)), [Obstacle::ShiftElements]);
        let narrow = Wanted { k: 2.1..=4.5, ..list(Kind::AllSparse, 5, 2) };
        assert_eq!(obstacles(&narrow), [Obstacle::KOutOfRange]);
        let sets = Wanted {
            sets: 1..=1,
            elements: 2..=2,
            engaged: 1..=1,
            gears: gears(&[3.059]),
            ..list(Kind::Core, 2, 1)
        };
        let all = obstacles(&sets);
        assert!(all.contains(&Obstacle::Sets) && all.contains(&Obstacle::Engaged), "{all:?}");
        let other = Wanted { gears: gears(&[2.8, 1.5, 1.0, 0.696, -2.294]), ..list(Kind::AllSparse, 5, 2) };
        let found = explained(&other);
        assert!(!found.has_all_ratios && !found.gears[0].within && !found.gears[1].within);
        assert!(found.gears[2..].iter().all(|gear| gear.within));
        assert_eq!(found.reasons, [Reason::new(Obstacle::MissesRatios)]);
        let fewer = Wanted { gears: gears(&[3.059, 1.625, 0.696, 1.0]), ..list(Kind::AllSparse, 5, 2) };
        let (answer, _) =
            solve(
                &Wanted { explain: None, ..list(Kind::AllSparse, 5, 2) },
                &|_, _| ControlFlow::Continue(()),
            )
            .unwrap();
        let told = explain(&four_speed(), &fewer, &answer, &[]).unwrap().reasons;
        let reverse = Some("reverse".to_owned());
        assert_eq!(told, [Reason { shift_element: reverse, ..Reason::new(Obstacle::UnusedElement) }]);
        // Only the second set's k affects these ratios.
        let gearbox = Gearbox::builder("three speeds")
            .links(["in", "P", "out", "S", "Q"])
            .set(SetSpec::simple("idle", ["in", "P", "out"], 2.0))
            .set(SetSpec::simple("2", ["S", "out", "Q"], 2.294))
            .brake("b", "S")
            .brake("c", "Q")
            .clutch("1-b", "S", "in")
            .clutch("1-c", "Q", "in")
            .input("in")
            .output("out")
            .build()
            .unwrap();
        let three = vec![1.0, -2.294, 0.6964];
        let reducible =
            Wanted { gears: gears(&three), tolerance: 1e-4, ..wanted(&[], Kind::AllSparse, 4, 2, gearbox) };
        // A search for its own ratios would find thousands; a search that finds none covers the same class.
        let none = Wanted { gears: gears(&[100.0, 200.0, -300.0]), explain: None, ..reducible.clone() };
        let (answer, _) = solve(&none, &|_, _| ControlFlow::Continue(())).unwrap();
        assert_eq!(answer.found, 0);
        let gearbox = reducible.explain.clone().unwrap();
        let told = explain(&gearbox, &reducible, &answer, &[]).unwrap().reasons;
        assert_eq!(told, [Reason::of_set(Obstacle::Reducible, "idle")]);
        let braked = four_speed().to_builder().brake("park", "shaft").build().unwrap();
        let found = explained(&wanted(&LIST, Kind::AllSparse, 5, 2, braked));
        assert_eq!(found.reasons[0].shift_element.as_deref(), Some("park"));
        let held = Gearbox::builder("a sun held")
            .links(["in", "out", "P", "Q"])
            .set(SetSpec::simple("1", ["ground", "in", "P"], 2.0))
            .set(SetSpec::simple("2", ["P", "Q", "out"], 2.0))
            .brake("b", "Q")
            .clutch("c", "Q", "in")
            .input("in")
            .output("out")
            .build()
            .unwrap();
        let told = obstacles(&Wanted {
            gears: gears(&[4.5]),
            elements: 1..=2,
            engaged: 1..=1,
            ..wanted(&[], Kind::Core, 2, 1, held)
        });
        assert!(told.contains(&Obstacle::MemberOnHousing), "{told:?}");
    }

    /// 6HP with other names of links and its double-planet set not at the end.
    fn six_hp() -> Gearbox {
        Gearbox::builder("6HP")
            .links(["turbine", "shaft", "C1", "S2", "S3", "H"])
            .set(SetSpec::new("rear", SetKind::DoublePlanet, ["S3", "shaft", "H"], 85.0 / 31.0))
            .set(SetSpec::simple("front", ["ground", "turbine", "C1"], 71.0 / 37.0))
            .set(SetSpec::simple("middle", ["S2", "shaft", "H"], 85.0 / 38.0))
            .clutch("A", "C1", "S3")
            .clutch("B", "C1", "S2")
            .clutch("E", "turbine", "H")
            .brake("C", "S2")
            .brake("D", "H")
            .input("turbine")
            .output("shaft")
            .build()
            .unwrap()
    }

    const SIX_HP: [f64; 7] = [4.171, 2.340, 1.521, 1.143, 0.867, 0.691, -3.403];

    /// Search in the structures of its sets alone, which is faster than that of the class.
    fn of_six_hp(double_planets: RangeInclusive<usize>) -> Wanted {
        let six = wanted(&SIX_HP, Kind::AllSparse, 5, 2, six_hp());
        Wanted { sets: 3..=3, double_planets, ..six }
    }

    fn searched_alone(wanted: &Wanted) -> (Synthesis, Vec<Kept>) {
        let simple: Structure = "0-1-c x-2-h y-h-2".parse().unwrap();
        solve_by(wanted, &mut |searching: &Searching, wish: &Wish| -> Result<run::Answer, Error> {
            let mut search = Search::<u8>::new(wish.clone(), searching.class.links());
            let mut found = Vec::new();
            for structure in simple.with_double_planets(searching.double_planets) {
                let solutions = search.structure(&structure).into_iter();
                found.extend(solutions.map(|solution| Found { structure: structure.clone(), solution }));
            }
            Ok(run::Answer { found, class_size: 1, complete: true, tally: Tally::default() })
        })
        .unwrap()
    }

    #[test]
    fn a_6hp_is_found_with_its_double_planet_set_and_as_simple_sets() {
        for (double_planets, structure) in
            [(1..=1, "0-1-a b-2-c d-2-c*"), (0..=1, "0-1-a b-2-c d-2-c*"), (0..=0, "0-1-a b-2-c d-c-2")]
        {
            let (answer, kept) = searched_alone(&of_six_hp(double_planets));
            let found = answer.explanation.unwrap();
            assert!(found.has_all_ratios && found.reasons.is_empty(), "{found:?}");
            assert_eq!(found.structure.as_deref(), Some(structure));
            let number = found.number.unwrap();
            assert_eq!(kept[number - 1].found.structure.to_string(), structure);
            assert_eq!(found.shift_elements, ["a-d", "a-b", "1-c", "b", "c"]);
        }
    }

    /// The 6HP is also found with its Ravigneaux set as one compound set, from its file.
    #[test]
    fn a_6hp_is_found_by_its_compound_set() {
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/lepelletier.yaml");
        let document = Document::parse_one("lepelletier.yaml", &std::fs::read(file).unwrap()).unwrap();
        let gearbox = one(&document, &Choice::default()).unwrap().train;
        let all = Wanted { explain: Some(gearbox), most: 100, all_gearboxes: true, ..of_six_hp(1..=1) };
        let (answer, _) = searched_alone(&all);
        let found = answer.explanation.unwrap();
        assert!(found.has_all_ratios && found.reasons.is_empty(), "{found:?}");
        assert_eq!(found.structure.as_deref(), Some("0-1-a b-2-c d-2-c*"));
        let solution = answer.solutions.iter().find(|one| Some(one.number) == found.number);
        assert_eq!(solution.map(|one| one.shared_planets[0].sets.clone()), Some(vec![2, 3]));
    }

    #[test]
    fn what_keeps_a_gearbox_with_a_double_planet_set_out_is_told() {
        let reasons = |wanted: &Wanted| searched_alone(wanted).0.explanation.unwrap().reasons;
        let two = of_six_hp(2..=2);
        assert_eq!(reasons(&two), [Reason::of_count(Obstacle::DoublePlanets, 1)]);
        let narrow = Wanted { k_double: 2.0..=2.5, ..of_six_hp(1..=1) };
        let real = Some(85.0 / 31.0);
        let rear = Reason { k: real, ..Reason::of_set(Obstacle::KOfDoublePlanetOutOfRange, "rear") };
        assert_eq!(reasons(&narrow), [rear]);
        // As simple sets the range --k applies to it.
        let narrow = Wanted { k: 1.85..=4.5, ..of_six_hp(0..=0) };
        let exchanged =
            Reason { k: Some(85.0 / 31.0 - 1.0), ..Reason::of_set(Obstacle::KOutOfRange, "rear") };
        assert_eq!(reasons(&narrow), [exchanged]);
        let none = wanted(&LIST, Kind::AllSparse, 5, 2, four_speed());
        let none = Wanted { double_planets: 1..=1, ..none };
        assert_eq!(obstacles(&none), [Obstacle::DoublePlanets]);
    }

    #[test]
    fn a_gearbox_whose_k_cannot_be_equal_is_told_so() {
        let equal = Wanted { equal_k: 2, ..wanted(&LIST, Kind::AllSparse, 5, 2, four_speed()) };
        assert_eq!(explained(&equal).reasons, [Reason::of_count(Obstacle::EqualK, 2)]);
    }

    #[test]
    fn a_set_of_another_form_is_no_part_of_a_search() {
        let stepped = SetSpec::new("1", SetKind::SteppedSuns, ["in", "out", "arm"], 2.0);
        let gearbox = Gearbox::builder("steps").links(["in", "out", "arm"]).set(stepped).brake("b", "arm");
        let gearbox = gearbox.input("in").output("out").build().unwrap();
        assert_eq!(obstacles(&wanted(&LIST, Kind::AllSparse, 5, 2, gearbox)), [Obstacle::SetKind]);
    }
}

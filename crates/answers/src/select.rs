//! The choice of a gearbox for two or three speeds: every mechanism measured, judged and compared.
//!
//! | module | is |
//! |---|---|
//! | [`candidate`] | a mechanism with its figures, and what the criteria say of it |
//! | [`required`] | what is wanted, as a record |
//! | [`duty`] | speed and load of the input |
//! | [`page`] | what a page of it draws |
//! | [`saved`] | a design as a gearbox |
//! | [`teeth`] | the choice over all tooth numbers of both sets |

pub mod candidate;
pub mod duty;
pub mod page;
pub mod required;
pub mod saved;
pub mod teeth;

use crate::catalogue::SetLinks;
use crate::tolerance::OBJECTIVE;
use crate::{Answer, Error};
use candidate::{Candidate, Criterion, Ranked};
use duty::Duty;
use epicyclic_schemes::catalogue::Scheme;
use epicyclic_selection::drawing::drawable_direct_clutches;
use epicyclic_selection::{self as selection, Mechanism, Order, Requirements, Selection, Space, select_with};
use required::{Objective, Required};
use saved::Saved;
use schemars::JsonSchema;
use serde::Serialize;

/// What is wanted.
#[derive(Debug, Clone, PartialEq)]
pub struct Wanted {
    /// Ratios, tolerance and limits.
    pub requirements: Requirements,
    /// Which objective decides first, and which next.
    pub order: Order,
    /// The mechanisms to choose among.
    pub space: Space,
    /// How many of the accepted candidates are told, and how many of the rejected.
    pub most: usize,
    /// Speed and load of the input.
    pub duty: Duty,
}

/// Gearboxes for two or three speeds: the candidates that meet every required criterion, the best first, then the rejected.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Select {
    /// What is wanted.
    pub required: Required,
    /// How many candidates meet every required criterion.
    pub accepted: usize,
    /// How many do not.
    pub rejected: usize,
    /// The objective by which the first candidate is ahead of others; `null` where there are no others, or all are equal.
    pub decided_by: Option<Objective>,
    /// The candidates told: accepted, the best first, then rejected.
    pub candidates: Vec<Candidate>,
    /// Mechanisms that no ring-to-sun ratios give the ratios.
    pub unreachable: Vec<Unreachable>,
    /// What the first candidate leaves to object to, and how many candidates do not.
    pub remedies: Vec<Remedy>,
    /// Where nothing is accepted: how many of all structures are; `null` where something is, or those were the mechanisms.
    pub accepted_of_all_structures: Option<usize>,
    /// Where nothing is accepted: criteria that alone keep a candidate out, with the limit that would let the nearest pass.
    pub relaxations: Vec<Relaxation>,
}

/// A required criterion that alone keeps candidates out, where nothing is accepted.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Relaxation {
    /// Which criterion.
    pub criterion: Criterion,
    /// The limit that would let the nearest of them pass, of `k` on the side where it lies; `null` of a yes or no.
    pub limit: Option<f64>,
    /// How many candidates nothing else keeps out.
    pub candidates: usize,
    /// The nearest one by the number of its candidate.
    pub nearest: u32,
}

/// A criterion that is not required and that the first candidate does not meet, and what requiring it would leave.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Remedy {
    /// Which criterion.
    pub criterion: Criterion,
    /// How many candidates meet it, and all that is required, among the same mechanisms.
    pub accepted: usize,
    /// How many of all structures do; `null` where those were the mechanisms, or some of the same mechanisms do.
    pub accepted_of_all_structures: Option<usize>,
}

/// A mechanism that cannot give the ratios wanted of its gears.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Unreachable {
    /// The source's name of the scheme; `null` where it has none.
    pub scheme: Option<&'static str>,
    /// Name of the structure, by the links of sun, ring and carrier of each set.
    pub structure: String,
    /// Links of the members of its sets.
    pub sets: Vec<SetLinks>,
    /// Ratios wanted of gears 1 and 2.
    pub wanted_ratios: Vec<f64>,
    /// Ring-to-sun ratios that these would need, one of them not above 1; `null` where one would be infinite.
    pub needed_k: Option<Vec<f64>>,
}

impl Answer for Select {
    const NAME: &'static str = "select";
}

impl Unreachable {
    fn of(one: &selection::Unreachable) -> Self {
        Self {
            scheme: one.mechanism.scheme().map(Scheme::name),
            structure: one.mechanism.to_string(),
            sets: one.mechanism.sets().into_iter().map(SetLinks::of).collect(),
            wanted_ratios: one.wanted.clone(),
            needed_k: one.needed.clone(),
        }
    }
}

/// Every mechanism for every assignment of the ratios.
///
/// # Errors
/// [`Error::Selection`] of requirements that cannot be, [`Error::Duty`].
pub fn answer(wanted: &Wanted) -> Result<Select, Error> {
    solve(wanted, None).map(|(answer, _)| answer)
}

/// The same, with the candidate of a number, from 1, as a gearbox; none where there is no such number.
///
/// # Errors
/// As [`answer`].
pub fn solve(wanted: &Wanted, saved: Option<usize>) -> Result<(Select, Option<Saved>), Error> {
    solved(wanted, saved).map(|(answer, saved, _)| (answer, saved))
}

/// The same with the mechanism of the first candidate, if one is accepted.
///
/// # Errors
/// As [`answer`].
pub fn with_mechanism(wanted: &Wanted) -> Result<(Select, Option<Mechanism>), Error> {
    solved(wanted, None).map(|(answer, _, mechanism)| (answer, mechanism))
}

fn solved(
    wanted: &Wanted,
    saved: Option<usize>,
) -> Result<(Select, Option<Saved>, Option<Mechanism>), Error> {
    let Wanted { requirements, order, space, most, duty } = wanted;
    duty.torque()?;
    let found = select_with(requirements, space, *order, Some(&drawable_direct_clutches))?;
    let ranked = ranked(&found);
    let (accepted, rejected) = (found.accepted.len(), found.rejected.len());
    let first = ranked.first().filter(|_| accepted > 0).map(|first| first.candidate);
    let best = first.map(|first| &first.objectives);
    let remedies = first.map_or_else(|| Ok(vec![]), |first| remedies(first, &found, wanted))?;
    let told = (0..accepted.min(*most)).chain(accepted..accepted + rejected.min(*most));
    let candidates = told
        .map(|place| {
            let ranked = &ranked[place];
            let behind = best
                .filter(|_| place < accepted)
                .and_then(|best| decisive(*order, best, &ranked.candidate.objectives));
            Candidate::of(ranked, behind, requirements, duty)
        })
        .collect::<Result<_, Error>>()?;
    let decided_by = best.and_then(|best| {
        let others = &ranked[1..accepted];
        let decides = |objective: &selection::Objective| {
            others.iter().any(|one| differs(*objective, best, &one.candidate.objectives))
        };
        order.objectives().into_iter().find(decides).map(Objective::of)
    });
    let saved = saved
        .and_then(|no| ranked.get(no.checked_sub(1)?))
        .map(|one| Saved::of(one.candidate, requirements, &[], vec![]))
        .transpose()?;
    let answer = Select {
        required: Required::of(requirements, *order, duty)?,
        accepted,
        rejected,
        decided_by,
        candidates,
        unreachable: found.unreachable.iter().map(Unreachable::of).collect(),
        remedies,
        accepted_of_all_structures: if accepted == 0 { of_all_structures(wanted)? } else { None },
        relaxations: if accepted == 0 { relaxations(&ranked, requirements) } else { vec![] },
    };
    Ok((answer, saved, first.map(|first| first.mechanism)))
}

/// How many of all structures are accepted; nothing where those are searched anyway.
fn of_all_structures(wanted: &Wanted) -> Result<Option<usize>, Error> {
    if matches!(wanted.space, Space::All) {
        return Ok(None);
    }
    let all = select_with(&wanted.requirements, &Space::All, wanted.order, Some(&drawable_direct_clutches))?;
    Ok(Some(all.accepted.len()))
}

/// What alone keeps each of the rejected out, the nearest of each criterion.
fn relaxations(rejected: &[Ranked<'_>], requirements: &Requirements) -> Vec<Relaxation> {
    let mut found: Vec<(f64, Relaxation)> = vec![];
    for one in rejected {
        let mut unmet = one.candidate.verdicts.iter().filter(|verdict| verdict.required && !verdict.met);
        let (Some(only), None) = (unmet.next(), unmet.next()) else { continue };
        let Some((limit, distance)) = limit_that_admits(one.candidate, only, requirements) else { continue };
        let criterion = Criterion::of(only.criterion);
        let of_it = Relaxation { criterion, limit, candidates: 1, nearest: one.no };
        match found.iter_mut().find(|(_, other)| other.criterion == criterion) {
            None => found.push((distance, of_it)),
            Some((nearest, other)) => {
                let candidates = other.candidates + 1;
                if distance < *nearest {
                    (*nearest, *other) = (distance, of_it);
                }
                other.candidates = candidates;
            }
        }
    }
    found.into_iter().map(|(_, one)| one).collect()
}

/// The limit of a criterion that would admit a candidate, and how far it is from the one there is; nothing where none would.
fn limit_that_admits(
    one: &selection::Candidate,
    verdict: &selection::Verdict,
    requirements: &Requirements,
) -> Option<(Option<f64>, f64)> {
    use selection::Criterion as C;
    match verdict.criterion {
        C::SameDirection | C::Drawable => Some((None, 0.0)),
        C::RingToSun => {
            let [least, greatest] = verdict.limits;
            let (low, high) = (one.k.iter().any(|k| *k < least), one.k.iter().any(|k| *k > greatest));
            let k = verdict.value;
            // Planets in such a set would run into each other.
            let collide = (k + 1.0)
                * libm::sin(std::f64::consts::PI / f64::from(requirements.rating.planets))
                <= k - 1.0;
            (k > 1.0 && low != high && !collide)
                .then(|| (Some(k), libm::log(k / if low { least } else { greatest }).abs()))
        }
        _ => {
            let limit = verdict.limits[usize::from(verdict.value > verdict.limits[1])];
            // A gear that is self-locking has the efficiency 0: no limit admits it.
            let admits = verdict.value.is_finite() && verdict.value > 0.0;
            admits.then(|| (Some(verdict.value), (verdict.value - limit).abs()))
        }
    }
}

/// What the first candidate leaves to object to, and how many candidates there are that do not.
fn remedies(first: &selection::Candidate, found: &Selection, wanted: &Wanted) -> Result<Vec<Remedy>, Error> {
    let mut remedies = vec![];
    for verdict in first.objections() {
        let mut requirements = wanted.requirements.clone();
        match verdict.criterion {
            selection::Criterion::SameDirection => requirements.limits.same_direction = true,
            selection::Criterion::Circulation => requirements.limits.circulation = verdict.limits[1],
            _ => continue,
        }
        // Every candidate was judged by the criterion already.
        let meets = |one: &&selection::Candidate| {
            one.verdicts.iter().any(|other| other.criterion == verdict.criterion && other.met)
        };
        let accepted = found.accepted.iter().filter(meets).count();
        let accepted_of_all_structures = if accepted == 0 && !matches!(wanted.space, Space::All) {
            let all = select_with(&requirements, &Space::All, wanted.order, Some(&drawable_direct_clutches))?;
            Some(all.accepted.len())
        } else {
            None
        };
        remedies.push(Remedy {
            criterion: Criterion::of(verdict.criterion),
            accepted,
            accepted_of_all_structures,
        });
    }
    Ok(remedies)
}

/// The accepted, the best first, then the rejected.
fn ranked(found: &Selection) -> Vec<Ranked<'_>> {
    let on_front = |place: usize| found.front.iter().any(|entry| entry.members.contains(&place));
    let best = found.best.iter().map(|&place| (&found.accepted[place], on_front(place)));
    let all = best.chain(found.rejected.iter().map(|candidate| (candidate, false)));
    (1..).zip(all).map(|(no, (candidate, non_dominated))| Ranked { no, candidate, non_dominated }).collect()
}

/// The first objective in the order in which a design differs from the best.
fn decisive(order: Order, best: &selection::Objectives, other: &selection::Objectives) -> Option<Objective> {
    let differs = |objective: &selection::Objective| differs(*objective, best, other);
    order.objectives().into_iter().find(differs).map(Objective::of)
}

fn differs(
    objective: selection::Objective,
    one: &selection::Objectives,
    other: &selection::Objectives,
) -> bool {
    let value = |of: &selection::Objectives| match objective {
        selection::Objective::Efficiency => of.efficiency,
        selection::Objective::Speed => of.speed,
        selection::Objective::RingToSun => of.ring_to_sun,
        selection::Objective::RatioError => of.ratio_error,
        selection::Objective::Size => of.size,
        selection::Objective::Circulation => of.circulation.unwrap_or(0.0),
    };
    (value(one) - value(other)).abs() > OBJECTIVE
}

#[cfg(test)]
mod tests {
    use super::*;
    use epicyclic_schemes::RatioSeries;

    fn wanted(ratios: &[f64], most: usize) -> Wanted {
        Wanted {
            requirements: Requirements::new(RatioSeries::of_braked_gears(ratios).unwrap()),
            order: Order::default(),
            space: Space::Catalogue,
            most,
            duty: Duty::default(),
        }
    }

    #[test]
    fn the_conveyor_gets_scheme_one() {
        let found = answer(&wanted(&[3.9375], usize::MAX)).unwrap();
        let best = &found.candidates[0];
        assert_eq!((best.scheme, best.accepted, best.behind_by), (Some("I"), true, None));
        assert!(best.operation.is_empty());
        assert_eq!(found.candidates.len(), found.accepted + found.rejected);
        assert!(found.candidates[1..found.accepted].iter().all(|one| one.behind_by.is_some()));
    }

    #[test]
    fn as_many_are_told_as_are_wanted() {
        let found = answer(&wanted(&[3.0, 5.0], 1)).unwrap();
        assert!(found.accepted > 1);
        assert_eq!(found.candidates.len(), 1 + found.rejected.min(1));
    }
}

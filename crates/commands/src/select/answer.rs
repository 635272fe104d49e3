//! Choice of a gearbox for two or three speeds: every mechanism is computed, judged and compared.
//!
//! | module | is |
//! |---|---|
//! | [`candidate`] | a mechanism with its figures, and what the criteria say of it |
//! | [`required`] | what is wanted, as a record |
//! | [`duty`] | speed and load of the input |
//! | [`page`] | what a page of it draws |
//! | [`reached`] | speeds asked for and reached |
//! | [`saved`] | a design as a gearbox |
//! | [`teeth`] | the choice over all tooth numbers of both sets |

pub mod candidate;
pub mod duty;
pub mod page;
pub mod reached;
pub mod required;
pub mod saved;
pub mod teeth;

use crate::answer::Answer;
use crate::error::Error;
use crate::shared::catalogue::SetLinks;
use crate::shared::judgement::answer::Judgement;
use crate::tolerance::OBJECTIVE;
use candidate::{Candidate, Criterion, Ranked};
use duty::Duty;
use epicyclic_schemes::catalogue::Scheme;
use epicyclic_selection::drawing::drawable_direct_clutches;
use epicyclic_selection::{self as selection, Mechanism, Order, Requirements, Selection, Space, select_with};
use reached::{Asked, ReachedSpeed};
use required::{Objective, Required};
use saved::Saved;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::Velocity;

/// Requirements for the choice of a gearbox.
#[derive(Debug, Clone, PartialEq)]
pub struct Wanted {
    /// Ratios, tolerance and limits.
    pub requirements: Requirements,
    /// Objectives in the order in which they decide.
    pub order: Order,
    /// Mechanisms to choose among.
    pub space: Space,
    /// Speeds of the machine, the slowest first, if they determine the ratios.
    pub speeds: Vec<Velocity>,
    /// Maximum number of accepted, and of rejected candidates that are listed.
    pub most: usize,
    /// Number of the candidate that is shown in full and saved, from 1.
    pub nth: usize,
    /// Speed and load of the input.
    pub duty: Duty,
}

/// Gearboxes for two or three speeds: the candidates that meet every required criterion, the best first, then
/// the rejected.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Select {
    /// Number of the candidate that tables show in full; null if none exists with that number, or none is
    /// accepted and none was asked for.
    pub shown_in_full: Option<u32>,
    /// Speeds of that candidate, required and reached, the slowest first; empty without such a candidate.
    pub speeds: Vec<ReachedSpeed>,
    /// Judgement of the candidate shown in full, by rules of practice; without checks if no candidate is.
    pub judgement: Judgement,
    /// Requirements as a record.
    pub required: Required,
    /// Number of candidates that meet every required criterion.
    pub accepted: usize,
    /// Number of candidates that fail a required criterion.
    pub rejected: usize,
    /// Objective by which the first candidate is ahead of others; null if there are no others, or all are
    /// equal.
    pub decided_by: Option<Objective>,
    /// Listed candidates: accepted, the best first, then rejected.
    pub candidates: Vec<Candidate>,
    /// Mechanisms that reach the ratios with no ring-to-sun ratios.
    pub unreachable: Vec<Unreachable>,
    /// Criteria that the first candidate does not meet, with the number of candidates that do.
    pub remedies: Vec<Remedy>,
    /// Number of accepted candidates among all structures, if none is accepted. Null if one is accepted, or
    /// if all structures were searched anyway.
    pub accepted_of_all_structures: Option<usize>,
    /// Criteria to relax if no candidate is accepted: alone, or the fewest together, they reject a candidate.
    /// Limits are those that would accept the closest one.
    pub relaxations: Vec<Relaxation>,
}

/// Required criterion that alone, or with the fewest others, rejects candidates, if none is accepted.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Relaxation {
    /// Name of the criterion.
    pub criterion: Criterion,
    /// Limit that would accept the closest candidate; for `k` on the side where it lies. Null for a criterion
    /// without a value.
    pub limit: Option<f64>,
    /// Criteria that reject the same candidates as well; empty if one criterion alone rejects them.
    pub with: Vec<RelaxedCriterion>,
    /// Number of candidates rejected by nothing else.
    pub candidates: usize,
    /// Number of the closest candidate.
    pub nearest: u32,
}

/// Criterion with the limit that would accept a candidate.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct RelaxedCriterion {
    /// Name of the criterion.
    pub criterion: Criterion,
    /// Limit that would accept the candidate; null for a criterion without a value.
    pub limit: Option<f64>,
}

/// Criterion that is not required and that the first candidate does not meet, and the effect of requiring it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Remedy {
    /// Name of the criterion.
    pub criterion: Criterion,
    /// Number of candidates among the same mechanisms that meet the criterion and all required ones.
    pub accepted: usize,
    /// Number of such candidates among all structures; null if all structures were searched anyway, or some
    /// of the same mechanisms meet it.
    pub accepted_of_all_structures: Option<usize>,
}

/// Mechanism that cannot give the required ratios.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Unreachable {
    /// Name of the scheme in the source; null if it has none.
    pub scheme: Option<&'static str>,
    /// Name of the structure, by the links of sun, ring and carrier of each set.
    pub structure: String,
    /// Links of the members of the sets.
    pub sets: Vec<SetLinks>,
    /// Required ratios of gears 1 and 2.
    pub wanted_ratios: Vec<f64>,
    /// Ring-to-sun ratios that the required ratios would need, one of them not above 1; null if one would be
    /// infinite.
    pub needed_k: Option<Vec<f64>>,
}

impl Answer for Select {
    const NAME: &'static str = "select";
}

impl Select {
    /// Candidate that tables show in full.
    #[must_use]
    pub fn in_full(&self) -> Option<&Candidate> {
        self.candidates.iter().find(|one| Some(one.no) == self.shown_in_full)
    }
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

/// Computes every mechanism for every assignment of the ratios.
///
/// # Errors
/// [`Error::Selection`] for impossible requirements; [`Error::Duty`].
pub fn answer(wanted: &Wanted) -> Result<Select, Error> {
    solved(wanted, false).map(|(answer, ..)| answer)
}

/// Returns the answer and, if `is_saved`, the candidate shown in full as a gearbox.
///
/// # Errors
/// Errors of [`answer`].
pub fn solve(wanted: &Wanted, is_saved: bool) -> Result<(Select, Option<Saved>), Error> {
    solved(wanted, is_saved).map(|(answer, saved, _)| (answer, saved))
}

/// Returns the answer with the mechanisms of the accepted candidates, the best first, each once.
///
/// # Errors
/// Errors of [`answer`].
pub fn with_mechanisms(wanted: &Wanted) -> Result<(Select, Vec<Mechanism>), Error> {
    solved(wanted, false).map(|(answer, _, mechanisms)| (answer, mechanisms))
}

fn solved(wanted: &Wanted, is_saved: bool) -> Result<(Select, Option<Saved>, Vec<Mechanism>), Error> {
    let Wanted { requirements, order, space, speeds, most, nth, duty } = wanted;
    duty.torque()?;
    let found = select_with(requirements, space, *order, Some(&drawable_direct_clutches))?;
    let ranked = ranked(&found);
    let (accepted, rejected) = (found.accepted.len(), found.rejected.len());
    let first = ranked.first().filter(|_| accepted > 0).map(|first| first.candidate);
    let remedies = first.map_or_else(|| Ok(vec![]), |first| remedies(first, &found, wanted))?;
    // A rejected candidate is shown only if it was asked for.
    let in_full = nth.checked_sub(1).filter(|place| *place < ranked.len() && (accepted > 0 || *place > 0));
    let is_told = |place: &usize| {
        let of_its_kind = if *place < accepted { *place } else { *place - accepted };
        of_its_kind < *most || in_full == Some(*place)
    };
    let told = (0..ranked.len()).filter(is_told);
    let measured = |one: &selection::Candidate| (one.mixes_directions(), one.objectives);
    let behind = |place: usize| decisive(*order, &measured(first?), &measured(ranked[place].candidate));
    let candidates: Vec<Candidate> = told
        .map(|place| {
            let behind = if place < accepted { behind(place) } else { None };
            Candidate::of(&ranked[place], behind, requirements, duty)
        })
        .collect::<Result<_, Error>>()?;
    let by = |objective| (1..accepted).any(|place| behind(place) == Some(objective));
    let decided_by = std::iter::once(Objective::Direction)
        .chain(order.objectives().into_iter().map(Objective::of))
        .find(|objective| by(*objective));
    let mut mechanisms: Vec<Mechanism> = vec![];
    for one in &ranked[..accepted] {
        if !mechanisms.contains(&one.candidate.mechanism) {
            mechanisms.push(one.candidate.mechanism);
        }
    }
    let of_file = |place: usize| Saved::of(ranked[place].candidate, requirements, &[], vec![]);
    let found_in_full = in_full.map(of_file).transpose()?;
    let judgement = match in_full.zip(found_in_full.as_ref()) {
        Some((place, saved)) => saved.judged(ranked[place].candidate, requirements),
        None => Judgement::default(),
    };
    let saved = found_in_full.filter(|_| is_saved);
    let asked = Asked { speeds, ratios: requirements.series.braked(), input: duty.input_speed };
    let shown_in_full = in_full.map(|place| ranked[place].no);
    let shown = candidates.iter().find(|one| Some(one.no) == shown_in_full);
    let answer = Select {
        shown_in_full,
        speeds: shown.map(|shown| asked.reached_by(&shown.gears)).unwrap_or_default(),
        judgement,
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
    Ok((answer, saved, mechanisms))
}

/// Number of accepted candidates among all structures; `None` if those are searched anyway.
fn of_all_structures(wanted: &Wanted) -> Result<Option<usize>, Error> {
    if matches!(wanted.space, Space::All) {
        return Ok(None);
    }
    let all = select_with(&wanted.requirements, &Space::All, wanted.order, Some(&drawable_direct_clutches))?;
    Ok(Some(all.accepted.len()))
}

/// Criteria that reject candidates, the fewest together, with the closest candidate of each combination.
fn relaxations(rejected: &[Ranked<'_>], requirements: &Requirements) -> Vec<Relaxation> {
    let mut found: Vec<(f64, Relaxation)> = vec![];
    for one in rejected {
        let unmet = one.candidate.verdicts.iter().filter(|verdict| verdict.required && !verdict.met);
        let limits = unmet.map(|verdict| {
            let (limit, distance) = limit_that_admits(one.candidate, verdict, requirements)?;
            Some((RelaxedCriterion { criterion: Criterion::of(verdict.criterion), limit }, distance))
        });
        let Some(limits) = limits.collect::<Option<Vec<(RelaxedCriterion, f64)>>>() else { continue };
        let distance = limits.iter().map(|(_, distance)| distance).sum();
        let mut limits = limits.into_iter().map(|(limit, _)| limit);
        let Some(RelaxedCriterion { criterion, limit }) = limits.next() else { continue };
        let of_it = Relaxation { criterion, limit, with: limits.collect(), candidates: 1, nearest: one.no };
        match found.iter_mut().find(|(_, other)| other.criteria().eq(of_it.criteria())) {
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
    let fewest = found.iter().map(|(_, one)| one.with.len()).min();
    found.into_iter().map(|(_, one)| one).filter(|one| Some(one.with.len()) == fewest).collect()
}

impl Relaxation {
    /// Names of the criteria to relax.
    fn criteria(&self) -> impl Iterator<Item = Criterion> + '_ {
        std::iter::once(self.criterion).chain(self.with.iter().map(|with| with.criterion))
    }

    /// Criteria to relax with their limits.
    pub fn limits(&self) -> impl Iterator<Item = RelaxedCriterion> + '_ {
        let first = RelaxedCriterion { criterion: self.criterion, limit: self.limit };
        std::iter::once(first).chain(self.with.iter().copied())
    }
}

/// Limit of a criterion that would accept a candidate, with its relative distance from the present limit;
/// `None` if no limit would.
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
            // Planets in such a set would collide.
            let collide = (k + 1.0)
                * libm::sin(std::f64::consts::PI / f64::from(requirements.rating.planets))
                <= k - 1.0;
            (k > 1.0 && low != high && !collide)
                .then(|| (Some(k), libm::log(k / if low { least } else { greatest }).abs()))
        }
        _ => {
            let limit = verdict.limits[usize::from(verdict.value > verdict.limits[1])];
            // A self-locking gear has the efficiency 0, which no limit accepts.
            let admits = verdict.value.is_finite() && verdict.value > 0.0;
            // Relative distances can be summed over several criteria.
            admits.then(|| (Some(verdict.value), (verdict.value - limit).abs() / (1.0 + limit.abs())))
        }
    }
}

/// Criteria that the first candidate does not meet, with the number of candidates that do.
fn remedies(first: &selection::Candidate, found: &Selection, wanted: &Wanted) -> Result<Vec<Remedy>, Error> {
    let mut remedies = vec![];
    for verdict in first.objections() {
        let mut requirements = wanted.requirements.clone();
        match verdict.criterion {
            selection::Criterion::SameDirection => requirements.limits.same_direction = true,
            selection::Criterion::Circulation => requirements.limits.circulation = verdict.limits[1],
            _ => continue,
        }
        // Each candidate has already been judged by the criterion.
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

/// Accepted candidates, the best first, then the rejected.
fn ranked(found: &Selection) -> Vec<Ranked<'_>> {
    let on_front = |place: usize| found.front.iter().any(|entry| entry.members.contains(&place));
    let best = found.best.iter().map(|&place| (&found.accepted[place], on_front(place)));
    let all = best.chain(found.rejected.iter().map(|candidate| (candidate, false)));
    (1..).zip(all).map(|(no, (candidate, non_dominated))| Ranked { no, candidate, non_dominated }).collect()
}

/// First objective in the order in which a design differs from the best; the direction of rotation counts
/// before all. Each item says whether the design mixes directions, and its objectives.
fn decisive(
    order: Order,
    (best_mixes, best): &(bool, selection::Objectives),
    (mixes, other): &(bool, selection::Objectives),
) -> Option<Objective> {
    if best_mixes != mixes {
        return Some(Objective::Direction);
    }
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
            speeds: vec![],
            most,
            nth: 1,
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

//! One stage with planets of two gears: stepped planets, or a Wolfrom set.
//!
//! Every set of tooth numbers within the bounds and the tolerance is found. The most promising by their
//! [estimated volume](epicyclic_strength::arranged) are sized with face widths and centre distances far apart. The
//! best of these are sized in full. The torque on the input is that with which a set's own losses leave the output
//! the torque ordered.

use super::arranged_file::making;
use super::stage_kind::StageKind;
use super::stages_file::efficiencies;
use super::stages_wanted::WantedStages;
use super::trains::{Listed, TrainOfStages, TrainsOf, by_cost};
use crate::error::Error;
use crate::shared::gearbox::{Choice, one};
use crate::size::answer as size;
use crate::size::options::{Effort, Request as SizeRequest};
use epicyclic_gears::Error as GearError;
use epicyclic_gears::arrangement::{Arrangement, ArrangementBounds, ArrangementMode};
use epicyclic_gears::synthesis::{Bounds, MOST_PLANETS};
use epicyclic_judge::Rule;
use epicyclic_numerics::threads::map;
use epicyclic_strength::arranged::estimated_volume;
use epicyclic_strength::sizing::{Objective, priced};
use std::collections::BTreeMap;
use std::ops::ControlFlow;

/// Sets that are sized coarsely at most.
pub(crate) const MOST_TRIED: usize = 240;

/// Of these the best, which are sized in full.
pub(crate) const MOST_SIZED: usize = 12;

/// Sets that are sized before the search gives up where none of them holds.
const MOST_HOPELESS: usize = 12;

/// Sets that are sized between two questions whether to go on.
const AT_A_TIME: usize = 4;

/// Arrangement of the gears of a kind, and the mode with the sun as the fast member, driven or driving; `None` of
/// simple sets.
fn arrangement(kind: StageKind, wanted: &WantedStages) -> Option<(Arrangement, ArrangementMode)> {
    let (arrangement, letters) = match (kind, wanted.turns_back, wanted.steps_up) {
        (StageKind::Simple, ..) => return None,
        (StageKind::Stepped, false, false) => (Arrangement::Stepped, "aH^b"),
        (StageKind::Stepped, false, true) => (Arrangement::Stepped, "Ha^b"),
        (StageKind::Stepped, true, false) => (Arrangement::Stepped, "ab^H"),
        (StageKind::Stepped, true, true) => (Arrangement::Stepped, "ba^H"),
        (StageKind::Wolfrom, _, false) => (Arrangement::Wolfrom, "ae^b"),
        (StageKind::Wolfrom, _, true) => (Arrangement::Wolfrom, "ea^b"),
    };
    Some((arrangement, arrangement.mode(letters)?))
}

/// Set of teeth with its ratio.
struct Candidate {
    teeth: Vec<u32>,
    ratio: f64,
}

/// Lists the best sets within a tolerance.
pub(super) fn listed(
    wanted: &WantedStages,
    (tolerance, most): (f64, usize),
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<Listed, Error> {
    let (found, mut all) = candidates(wanted, tolerance, goes_on)?;
    let (sets, mut tried) = (all.len(), all.len());
    if sets > MOST_SIZED {
        let coarse = &all[..sets.min(MOST_TRIED)];
        let mut promising: Sized;
        (tried, promising) = sized_all(wanted, coarse, Effort::Coarse, goes_on)?;
        promising.sort_by(|one, other| by_cost(one.0.cost(), other.0.cost()));
        // Where none holds so, one may hold with other widths: then the first by volume are sized in full.
        if promising.is_empty() {
            all.truncate(AT_A_TIME);
        } else {
            let candidate = |(train, _): (TrainOfStages, f64)| {
                train.teeth.into_iter().next().map(|teeth| Candidate { teeth, ratio: train.ratio })
            };
            all = promising.into_iter().filter_map(candidate).collect();
            all.truncate(MOST_SIZED);
        }
    }
    let (_, sized) = sized_all(wanted, &all, Effort::Found, goes_on)?;
    let is_long = |length: &f64| wanted.limits.length_m.is_some_and(|most| *length > most);
    let shortest = sized.iter().map(|(_, length)| *length).filter(is_long).reduce(f64::min);
    let within = sized.into_iter().filter(|(_, length)| !is_long(length));
    let mut trains: Vec<TrainOfStages> = within.map(|(train, _)| train).collect();
    trains.sort_by(|one, other| by_cost(one.cost(), other.cost()));
    trains.truncate(most);
    let mut trains = trains.into_iter();
    let of_stage = TrainsOf {
        stages: 1,
        has_pair: false,
        kind: wanted.kind(),
        reachable: None,
        compared: found,
        sized: tried as u64,
        complete: sets <= MOST_SIZED,
        best: trains.next(),
        next: trains.next(),
        taken: false,
    };
    let shortest = shortest.filter(|_| of_stage.best.is_none());
    Ok(Listed { sets, trains: vec![of_stage], prices: vec![0.0], shortest, ended_early: vec![] })
}

/// Sets with their lengths in m.
type Sized = Vec<(TrainOfStages, f64)>;

/// Sizes sets, with how many were tried: all, or the first where none of these holds.
fn sized_all(
    wanted: &WantedStages,
    all: &[Candidate],
    effort: Effort,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<(usize, Sized), Error> {
    let size = SizeRequest { effort, most: 1, ..wanted.size.clone() };
    let (mut tried, mut found) = (0, vec![]);
    for some in all.chunks(AT_A_TIME) {
        if goes_on().is_break() {
            return Err(epicyclic_strength::Error::Cancelled.into());
        }
        // Where the most promising do not hold, trying all the others takes long and finds none.
        if found.is_empty() && tried >= MOST_HOPELESS {
            break;
        }
        tried += some.len();
        for one in map(some, |candidate| sized(wanted, candidate, &size)) {
            found.extend(one?);
        }
    }
    Ok((tried, found))
}

/// Number of sets of tooth numbers with their numbers of planets, and each set of tooth numbers once, the least
/// estimated volume first.
fn candidates(
    wanted: &WantedStages,
    tolerance: f64,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<(u64, Vec<Candidate>), Error> {
    let Some((arrangement, mode)) = arrangement(wanted.kind(), wanted) else { return Ok((0, vec![])) };
    let (teeth, planets) = (&wanted.teeth, wanted.size.planet_counts());
    let bounds = Bounds {
        sun: wanted.arranged_suns.clone(),
        planet: teeth.planets.clone(),
        ring: teeth.rings.clone(),
        planets: (*planets.start()).max(2)..=(*planets.end()).clamp(2, MOST_PLANETS),
        ..Bounds::default()
    };
    let bounds = ArrangementBounds {
        offsets: teeth.ring_offsets.clone(),
        aim: wanted.size.aim,
        ..ArrangementBounds::of(arrangement, &bounds)
    };
    let found = match bounds.for_ratio(wanted.asked(), mode, tolerance, usize::MAX, |_| goes_on()) {
        Ok(found) => found,
        Err(GearError::NoArrangement { .. }) => return Ok((0, vec![])),
        Err(error) => return Err(error.into()),
    };
    // Least volume of all numbers of planets, and the ratio, by the teeth.
    let mut all: BTreeMap<&[u32], (f64, f64)> = BTreeMap::new();
    for one in &found.first {
        let has_divisors = || one.teeth.common_divisors().iter().any(|divisor| *divisor > 1);
        if one.teeth.has_one_step() || teeth.is_hunting && has_divisors() {
            continue;
        }
        let Some(volume) = estimated_volume(&one.teeth) else { continue };
        let known = all.entry(one.teeth.teeth()).or_insert((volume, one.ratio));
        known.0 = known.0.min(volume);
    }
    let mut all: Vec<(&[u32], (f64, f64))> = all.into_iter().collect();
    all.sort_by(|(_, one), (_, other)| one.0.total_cmp(&other.0));
    let all = all.into_iter().map(|(teeth, (_, ratio))| Candidate { teeth: teeth.to_vec(), ratio });
    Ok((found.found, all.collect()))
}

/// Sizes a set, with its length in m; `None` if no size holds, or if the losses hold the set.
fn sized(
    wanted: &WantedStages,
    candidate: &Candidate,
    size: &SizeRequest,
) -> Result<Option<(TrainOfStages, f64)>, Error> {
    let stages = vec![candidate.teeth.clone()];
    let [Some(efficiency), _] = efficiencies(wanted, &stages)? else { return Ok(None) };
    let torque = wanted.input_torque(candidate.ratio, Some(efficiency));
    let document = making(wanted, &candidate.teeth, torque)?;
    let subject = one(&document, &Choice::default())?;
    let size = match size::answer(&subject, size, &|| ControlFlow::Continue(())) {
        Ok(size) => size,
        // At no modules have the meshes of a planet one radius.
        Err(Error::NothingToSize { .. }) => return Ok(None),
        Err(error) => return Err(error),
    };
    let Some(best) = size.sets.first().and_then(|set| set.found.first()) else { return Ok(None) };
    let is_whole = wanted.size.objective() == Objective::Whole;
    let mass_kg = if is_whole { best.with_structure_kg() } else { best.mass_kg };
    // Simple sets lose little; here the losses are a rule like the others.
    let loses = !subject.limits.judge(Rule::StageEfficiency, efficiency).holds();
    let rules_missed = best.rules_missed + u32::from(loses && !wanted.size.beyond_practice);
    let [unusual, price_kg] = priced(rules_missed, mass_kg);
    let train = TrainOfStages {
        ratios: vec![candidate.ratio],
        ratio: candidate.ratio,
        teeth: stages,
        unusual_stages: unusual as u32,
        rules_missed,
        mass_kg,
        price_kg,
    };
    Ok(Some((train, best.length_m)))
}

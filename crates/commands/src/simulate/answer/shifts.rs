//! What each shift does: its phases, and the torque of the output.

use super::parts::{Built, Ramps};
use epicyclic_motion::{Run, Sample, State};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;

/// A shift.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ShiftResult {
    /// When it begins.
    pub at_s: f64,
    /// The gear before.
    pub from: String,
    /// The gear after.
    pub to: String,
    /// What it releases.
    pub released: Vec<String>,
    /// What it applies.
    pub applied: Vec<String>,
    /// When everything that it applies holds for good; `null` where it does not.
    pub locked_s: Option<f64>,
    /// From its beginning to the lock.
    pub shift_time_s: Option<f64>,
    /// From when an applied element carries to when a released one, or a one-way clutch, lets go; `null`
    /// where that comes first.
    pub torque_phase_s: Option<f64>,
    /// From when a released element, or a one-way clutch, lets go to the lock.
    pub inertia_phase_s: Option<f64>,
    /// Torque of sets and shift elements on the output before it.
    pub output_torque_before_n_m: f64,
    /// The least of it up to the lock, in the direction of that before.
    pub output_torque_least_n_m: f64,
    /// The greatest of it up to the lock, in the direction of that before.
    pub output_torque_greatest_n_m: f64,
    /// What is missing of the torque before at the least one, over that before: 0.3 of a hole of 30 %.
    pub torque_hole: Option<f64>,
    /// What the greatest is more than the torque before, over that before.
    pub torque_surge: Option<f64>,
    /// Heat of all elements from its beginning to the lock.
    pub heat_j: f64,
}

pub(super) fn results(built: &Built, run: &Run, instants: &[&Sample]) -> Vec<ShiftResult> {
    let duration = run.end().time.si();
    let of = |(place, shift): (usize, &Ramps)| {
        let end = built.shifts.get(place + 1).map_or(duration, |next| next.at).min(duration);
        (shift.at < duration).then(|| result(built, run, instants, shift, end))
    };
    built.shifts.iter().enumerate().filter_map(of).collect()
}

fn result(built: &Built, run: &Run, instants: &[&Sample], shift: &Ramps, end: f64) -> ShiftResult {
    let places = |ids: &[String]| -> Vec<usize> { ids.iter().filter_map(|id| run.element(id)).collect() };
    let (released, applied) = (places(&shift.released), places(&shift.applied));
    let one_way = built.elements.iter().filter(|one| one.kind == super::parts::ElementKind::OneWayClutch);
    let lets_go: Vec<usize> =
        released.iter().copied().chain(one_way.filter_map(|one| run.element(&one.id))).collect();
    let within: Vec<&Sample> =
        instants.iter().copied().filter(|one| one.time.si() >= shift.at && one.time.si() <= end).collect();
    let before = instants.iter().rev().find(|one| one.time.si() <= shift.at).copied();

    let holds = |sample: &Sample| applied.iter().all(|&place| sample.states[place] == State::Stuck);
    // The first of the last run of instants in which all hold.
    let unlocked = within.iter().rposition(|sample| !holds(sample));
    let locked = match unlocked {
        None => within.first(),
        Some(place) => within.get(place + 1),
    };
    let locked = locked.map(|sample| sample.time.si());
    let carries = within
        .iter()
        .find(|sample| applied.iter().any(|&place| sample.states[place] != State::Open))
        .map(|sample| sample.time.si());
    let gone = within.windows(2).find(|pair| {
        let goes =
            |&&place: &&usize| pair[0].states[place] == State::Stuck && pair[1].states[place] != State::Stuck;
        lets_go.iter().any(|place| goes(&place))
    });
    let gone = gone.map(|pair| pair[1].time.si());

    let until = locked.unwrap_or(end);
    let output = |sample: &Sample| built.output.torque(sample);
    let torque_before = before.map_or(0.0, output);
    let direction = if torque_before < 0.0 { -1.0 } else { 1.0 };
    let along = within.iter().filter(|one| one.time.si() <= until).map(|sample| direction * output(sample));
    let (least, greatest) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, greatest), torque| {
        (least.min(torque), greatest.max(torque))
    });
    let size = torque_before.abs();
    let heat = |sample: &Sample| sample.heats.iter().map(|one| one.si()).sum::<f64>();
    let last = within.iter().rev().find(|one| one.time.si() <= until).copied();
    ShiftResult {
        at_s: shift.at,
        from: shift.from.clone(),
        to: shift.to.clone(),
        released: shift.released.clone(),
        applied: shift.applied.clone(),
        locked_s: locked,
        shift_time_s: locked.map(|locked| locked - shift.at),
        torque_phase_s: carries.zip(gone).and_then(|(from, to)| (to >= from).then_some(to - from)),
        inertia_phase_s: gone.zip(locked).and_then(|(from, to)| (to >= from).then_some(to - from)),
        output_torque_before_n_m: torque_before,
        output_torque_least_n_m: direction * least,
        output_torque_greatest_n_m: direction * greatest,
        torque_hole: (size > 0.0).then(|| 1.0 - least / size),
        torque_surge: (size > 0.0).then(|| greatest / size - 1.0),
        heat_j: last.map_or(0.0, heat) - before.map_or(0.0, heat),
    }
}

//! Results of the shifts: their phases, output torque and heat.

use super::parts::{Built, Ramps};
use epicyclic_motion::{Run, Sample, State};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;

/// Result of a shift.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ShiftResult {
    /// Time at which the shift begins, in s.
    pub at_s: f64,
    /// Name of the gear before the shift.
    pub from: String,
    /// Name of the gear after the shift.
    pub to: String,
    /// Names of the released elements.
    pub released: Vec<String>,
    /// Names of the applied elements.
    pub applied: Vec<String>,
    /// Time in s at which all applied elements hold for good; null if they do not.
    pub locked_s: Option<f64>,
    /// Duration of the shift in s, from its beginning to the lock; null without a lock.
    pub shift_time_s: Option<f64>,
    /// Torque phase in s, from the time at which an applied element carries torque until a released one, or a
    /// one-way clutch, lets go. Null if that occurs first.
    pub torque_phase_s: Option<f64>,
    /// Inertia phase in s, from the time at which a released element, or a one-way clutch, lets go until the
    /// lock; null without either.
    pub inertia_phase_s: Option<f64>,
    /// Torque of sets and shift elements on the output before the shift, in N·m.
    pub output_torque_before_n_m: f64,
    /// Least output torque up to the lock in N·m, in the direction of that before the shift.
    pub output_torque_least_n_m: f64,
    /// Greatest output torque up to the lock in N·m, in the direction of that before the shift.
    pub output_torque_greatest_n_m: f64,
    /// Torque hole: drop to the least output torque over the output torque before, 0.3 for a hole of 30 %.
    /// Null if that is 0.
    pub torque_hole: Option<f64>,
    /// Torque surge: rise to the greatest output torque over the output torque before; null if that is 0.
    pub torque_surge: Option<f64>,
    /// Heat of all elements from the beginning of the shift to the lock, in J.
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
    // The lock is the first of the last run of instants at which all elements hold.
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

//! Heat, powers, temperature and slip of each element.

use super::parts::{Built, Element, ElementKind};
use epicyclic_motion::{Run, Sample, State};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;

/// Loads and temperatures of a shift element or resistance.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ElementResult {
    /// Name of the element.
    pub id: String,
    /// Kind of the element.
    pub kind: ElementKind,
    /// Names of the two links, the housing as `ground`.
    pub links: [String; 2],
    /// State of the element at the end.
    pub at_end: super::State,
    /// Time in s during which the element slips and carries; for a one-way clutch, during which it overruns.
    pub slip_time_s: f64,
    /// Heat from start to end in J, without the losses of drags.
    pub heat_j: f64,
    /// Greatest friction power in W.
    pub peak_power_w: f64,
    /// Greatest torque in N·m, holding or slipping, without drags.
    pub peak_torque_n_m: f64,
    /// Heat per friction area in J/m²; null if no area is given.
    pub heat_per_area_j_m2: Option<f64>,
    /// Greatest power per friction area in W/m²; null if no area is given.
    pub peak_power_per_area_w_m2: Option<f64>,
    /// Greatest temperature above the oil in K; null if no heat capacity is given.
    pub peak_temperature_rise_k: Option<f64>,
    /// Temperature above the oil at the end in K; null if no heat capacity is given.
    pub end_temperature_rise_k: Option<f64>,
}

/// Samples, and the states immediately before and after events, in order of time.
pub(super) fn instants(run: &Run) -> Vec<&Sample> {
    let mut all: Vec<&Sample> =
        run.samples.iter().chain(run.events.iter().flat_map(|event| [&event.before, &event.after])).collect();
    // Instants of equal time keep their order (stable sort): sample, before, after.
    all.sort_by(|one, other| one.time.si().total_cmp(&other.time.si()));
    all
}

/// Slip `ω_1 − ω_2` of an element in rad/s.
pub(super) fn slip(run: &Run, element: &Element, sample: &Sample) -> f64 {
    let [first, second] =
        element.links.each_ref().map(|link| run.link(link).map_or(0.0, |place| sample.speeds[place].si()));
    first - second
}

pub(super) fn results(built: &Built, run: &Run, instants: &[&Sample]) -> Vec<ElementResult> {
    let result = |(place, id): (usize, &String)| {
        let element = built.elements.iter().find(|one| one.id == *id)?;
        Some(of(element, place, run, instants))
    };
    run.elements.iter().enumerate().filter_map(result).collect()
}

fn of(element: &Element, place: usize, run: &Run, instants: &[&Sample]) -> ElementResult {
    let most =
        |of: &dyn Fn(&Sample) -> f64| instants.iter().map(|sample| of(sample).abs()).fold(0.0, f64::max);
    let power = most(&|sample| match sample.states[place] {
        State::Forward | State::Backward => sample.elements[place].si() * slip(run, element, sample),
        State::Open | State::Stuck => 0.0,
    });
    let rises = temperature_rises(element, place, instants);
    let heat = run.audit.heat[place].si();
    let slips = |sample: &Sample| matches!(sample.states[place], State::Forward | State::Backward);
    // States change only at events.
    let ends = instants.iter().skip(1).map(|next| next.time.si());
    let slip_time = instants.iter().zip(ends).filter(|(sample, _)| slips(sample));
    ElementResult {
        id: element.id.clone(),
        kind: element.kind,
        links: element.links.clone(),
        at_end: super::State::of(run.end().states[place]),
        slip_time_s: slip_time.map(|(sample, end)| end - sample.time.si()).sum(),
        heat_j: heat,
        peak_power_w: power,
        peak_torque_n_m: most(&|sample| sample.elements[place].si()),
        heat_per_area_j_m2: element.friction_area_m2.map(|area| heat / area),
        peak_power_per_area_w_m2: element.friction_area_m2.map(|area| power / area),
        peak_temperature_rise_k: rises.as_ref().map(|rises| rises.iter().copied().fold(0.0, f64::max)),
        end_temperature_rise_k: rises.as_ref().and_then(|rises| rises.last().copied()),
    }
}

/// Temperature above the oil at each instant, from the heat between two instants; empty without a heat
/// capacity.
pub(super) fn temperature_rises(element: &Element, place: usize, instants: &[&Sample]) -> Option<Vec<f64>> {
    let capacity = element.heat_capacity_j_per_k?;
    let conductance = element.conductance_w_per_k;
    let mut rise = 0.0;
    let mut rises = vec![rise];
    for pair in instants.windows(2) {
        let heat = pair[1].heats[place].si() - pair[0].heats[place].si();
        let time = pair[1].time.si() - pair[0].time.si();
        rise = if conductance > 0.0 && time > 0.0 {
            let left = -conductance * time / capacity;
            // The function expm1 keeps its digits for short times.
            rise * libm::exp(left) - heat / (time * conductance) * libm::expm1(left)
        } else {
            rise + heat / capacity
        };
        rises.push(rise);
    }
    Some(rises)
}

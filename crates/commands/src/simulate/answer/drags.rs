//! Drags of the gearbox: their place in the model, and their losses.

#[cfg(test)]
mod tests;

pub use super::parts::DragKind;
use super::parts::{Drag, Scenario};
use crate::error::Error;
use epicyclic_formats::Problem;
use epicyclic_motion::{self as motion, Model, Run, Sample};
use epicyclic_train::error::DragFault;
use epicyclic_units::{Physical, Quantity};
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::{AngularVelocity, Time};

/// Losses of a drag.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct DragResult {
    /// Name of the drag; for a brake or clutch that of the element.
    pub id: String,
    /// Kind of the drag.
    pub kind: DragKind,
    /// Names of the two links, the housing as `ground`.
    pub links: [String; 2],
    /// Slip at the end in rad/s: speed of the first link minus speed of the second.
    pub end_slip_rad_s: f64,
    /// Torque on the first link at the end, in N·m.
    pub end_torque_n_m: f64,
    /// Greatest absolute torque in N·m.
    pub peak_torque_n_m: f64,
    /// Greatest power lost, in W.
    pub peak_power_w: f64,
    /// Energy lost from start to end, in J.
    pub loss_j: f64,
}

/// Drag over time.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct DragSamples {
    /// Name of the drag; for a brake or clutch that of the element.
    pub id: String,
    /// Slips in rad/s: speed of the first link minus speed of the second.
    pub slips_rad_s: Vec<f64>,
    /// Torques on the first link in N·m.
    pub torques_n_m: Vec<f64>,
    /// Energy lost since the start, in J.
    pub losses_j: Vec<f64>,
}

impl Scenario<'_> {
    /// Adds the drags of the gearbox to the model, except those between links that are one piece. Returns the
    /// added drags in their order in the model.
    pub(super) fn add_drags(&self, model: &mut Model) -> Result<Vec<Drag>, Error> {
        let gearbox = &self.subject.train;
        let mut all = vec![];
        if self.file.drags == Some(false) {
            return Ok(all);
        }
        for (place, one) in self.subject.drags.iter().enumerate() {
            let links = one.links.map(|link| gearbox.link_name(link).to_owned());
            let [first, second] = links.each_ref().map(String::as_str);
            if model.mechanism().is_one_piece(first, second).unwrap_or(false) {
                continue;
            }
            let added = model.drag(&one.name, [first, second], &one.curve);
            added.map_err(|why| self.of_run(why))?;
            let kind = if one.shift_element.is_some() { DragKind::OpenElement } else { DragKind::Drag };
            all.push(Drag { id: one.name.clone(), kind, links, place });
        }
        Ok(all)
    }

    /// Error for a speed outside the curve of a drag, with the place of the curve in the file.
    pub(super) fn of_drag(&self, drags: &[Drag], why: motion::Error) -> Error {
        let motion::Error::DragSpeed { place, slip_rad_s, from_rad_s, to_rad_s, time_s, .. } = why else {
            return self.of_run(why);
        };
        let speed = AngularVelocity::from_si;
        let Some(drag) = drags.get(place) else { return self.of_run(why) };
        let fault = DragFault::Outside { slip: speed(slip_rad_s), speeds: [from_rad_s, to_rad_s].map(speed) };
        let path = self.subject.drag_path(drag.place, &fault);
        let told = epicyclic_train::Error::Drag { drag: drag.id.clone(), fault };
        let message = format!("at {}: {told}", Quantity(Time::from_si(time_s)));
        let at = self.subject.document.error(&path, Problem::refused(why.name(), message));
        Error::Placed { at: Box::new(at), why: Box::new(why.into()) }
    }
}

/// Slip `ω_1 − ω_2` of a drag in rad/s.
pub(super) fn slip(run: &Run, drag: &Drag, sample: &Sample) -> f64 {
    let [first, second] =
        drag.links.each_ref().map(|link| run.link(link).map_or(0.0, |place| sample.speeds[place].si()));
    first - second
}

pub(super) fn results(drags: &[Drag], run: &Run, instants: &[&Sample]) -> Vec<DragResult> {
    let of = |(place, drag): (usize, &Drag)| {
        let most =
            |of: &dyn Fn(&Sample) -> f64| instants.iter().map(|sample| of(sample).abs()).fold(0.0, f64::max);
        let torque = |sample: &Sample| sample.drags[place].si();
        DragResult {
            id: drag.id.clone(),
            kind: drag.kind,
            links: drag.links.clone(),
            end_slip_rad_s: slip(run, drag, run.end()),
            end_torque_n_m: torque(run.end()),
            peak_torque_n_m: most(&torque),
            peak_power_w: most(&|sample| torque(sample) * slip(run, drag, sample)),
            loss_j: run.audit.drags[place].si(),
        }
    };
    drags.iter().enumerate().map(of).collect()
}

pub(super) fn samples(drags: &[Drag], run: &Run, samples: &[&Sample]) -> Vec<DragSamples> {
    let list = |of: &dyn Fn(&Sample) -> f64| samples.iter().map(|sample| of(sample)).collect();
    let of = |(place, drag): (usize, &Drag)| DragSamples {
        id: drag.id.clone(),
        slips_rad_s: list(&|sample| slip(run, drag, sample)),
        torques_n_m: list(&|sample| sample.drags[place].si()),
        losses_j: list(&|sample| sample.drag_losses[place].si()),
    };
    drags.iter().enumerate().map(of).collect()
}

//! Drags that the gearbox states: into the model, and what they lose.

#[cfg(test)]
mod tests;

pub use super::parts::DragKind;
use super::parts::{Drag, Scenario};
use crate::error::Error;
use epicyclic_formats::Problem;
use epicyclic_formats::gearbox::{DescriptionError, located};
use epicyclic_motion::{self as motion, Model, Run, Sample};
use epicyclic_train::error::DragFault;
use epicyclic_units::{Physical, Quantity};
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::{AngularVelocity, Time};

/// What a drag loses.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct DragResult {
    /// Its name; that of a brake or clutch is the element's.
    pub id: String,
    /// What drags.
    pub kind: DragKind,
    /// Its links, the housing as `ground`.
    pub links: [String; 2],
    /// Speed of its first link less that of its second at the end.
    pub end_slip_rad_s: f64,
    /// Torque on its first link at the end.
    pub end_torque_n_m: f64,
    /// Greatest torque, in size.
    pub peak_torque_n_m: f64,
    /// Greatest power that it takes.
    pub peak_power_w: f64,
    /// What it loses from start to end.
    pub loss_j: f64,
}

/// A drag over time.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct DragSamples {
    /// Its name.
    pub id: String,
    /// Speed of its first link less that of its second.
    pub slips_rad_s: Vec<f64>,
    /// Torque on its first link.
    pub torques_n_m: Vec<f64>,
    /// What it lost from the start on.
    pub losses_j: Vec<f64>,
}

impl Scenario<'_> {
    /// Gives the model the drags of the gearbox, but for those whose links are one piece; which they are, in
    /// its order.
    pub(super) fn add_drags(&self, model: &mut Model) -> Result<Vec<Drag>, Error> {
        let gearbox = &self.subject.gearbox;
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

    /// The refusal of a speed of which the curve of a drag tells nothing, at the curve in its file.
    pub(super) fn of_drag(&self, drags: &[Drag], why: motion::Error) -> Error {
        let motion::Error::DragSpeed { place, slip_rad_s, from_rad_s, to_rad_s, time_s, .. } = why else {
            return self.of_run(why);
        };
        let speed = AngularVelocity::from_si;
        let Some(found) = drags.get(place).map(|drag| &self.subject.drags[drag.place]) else {
            return self.of_run(why);
        };
        let fault = DragFault::Outside { slip: speed(slip_rad_s), speeds: [from_rad_s, to_rad_s].map(speed) };
        let of_gearbox = epicyclic_train::Error::Drag { drag: found.name.clone(), fault };
        let document = self.subject.document;
        let told = DescriptionError::Gearbox(of_gearbox);
        let path = located(document, &self.subject.base, &told).at().path.clone();
        let message = format!("at {}: {told}", Quantity(Time::from_si(time_s)));
        let at = document.error(&path, Problem::refused(why.name(), message));
        Error::Placed { at: Box::new(at), why: Box::new(why.into()) }
    }
}

/// `ω_1 − ω_2` of a drag.
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

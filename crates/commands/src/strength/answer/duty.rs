//! Steps of a duty, and the rating of a set over them.

use super::load::SetLoad;
use super::partly::Partly;
use super::place::Fault;
use super::rated_set::RatedSet;
use super::records::{NotRated, OverDuty, Reason};
use crate::analyze::answer::{Input, Worked};
use crate::error::Error;
use crate::shared::fault::{Named, refused};
use crate::shared::gearbox::Gearbox;
use epicyclic_formats::Path;
use epicyclic_formats::gearbox::DutyEntry;
use epicyclic_strength::mesh::Load;
use epicyclic_strength::rating::rate;
use epicyclic_strength::spectrum::{Step, check_shares, rate_duty};
use epicyclic_train::InputLoad;
use epicyclic_units::Physical;
use uom::si::f64::{Time, Torque};

/// Step of the duty from the file, with its gear at that load; `None` if the step has no load.
pub(crate) struct WorkedStep<'g>(pub(crate) &'g DutyEntry, pub(crate) Option<Worked<'g>>);

impl<'g> WorkedStep<'g> {
    /// The gear at the speed of a step that comes a few times in the life: its share of the time is 0. `None` for
    /// steps with a load and for those at rest.
    pub(crate) fn turning(&self, subject: &'g Gearbox) -> Option<Worked<'g>> {
        let Self(entry, None) = self else { return None };
        if entry.share.0.si() != 0.0 || entry.speed.0.si() == 0.0 {
            return None;
        }
        // Speeds are the same under every torque.
        let load = Some(InputLoad::Torque(Torque::from_si(1.0)));
        Worked::new(&subject.train, &entry.gear, Input { speed: Some(entry.speed.0), load }).ok()
    }
}

/// Computes the steps of a duty.
///
/// # Errors
/// [`Error::Document`] for shares that do not add up to the whole time, for gears that do not exist or
/// cannot carry the load, and for torques at standstill.
pub(crate) fn steps<'g>(subject: &'g Gearbox, duty: &'g [DutyEntry]) -> Result<Vec<WorkedStep<'g>>, Error> {
    let root = Path::root();
    check_shares(duty.iter().map(|step| step.share.0.si()))
        .map_err(|error| refused(&subject.document, &root, &["duty"], &error))?;
    let step = |(place, step): (usize, &'g DutyEntry)| {
        Ok(WorkedStep(step, worked(subject, step, &root.clone().key("duty").index(place))?))
    };
    duty.iter().enumerate().map(step).collect()
}

fn worked<'g>(subject: &'g Gearbox, step: &DutyEntry, path: &Path) -> Result<Option<Worked<'g>>, Error> {
    let input = Input { speed: Some(step.speed.0), load: Some(InputLoad::Torque(step.torque.0)) };
    let idle = step.share.0.si() == 0.0 || step.torque.0.si() == 0.0;
    if !idle && step.speed.0.si() == 0.0 {
        let message = "speed 0 with a torque: a torque at standstill is a static load without cycles; write a speed other than 0, or `torque: 0 N·m` here and the torque as an `overload`";
        return Err(refused(&subject.document, path, &["speed"], &Named("no-cycles", message)));
    }
    // A gear that does not exist is refused even in a step without load.
    let input = if idle { Input::default() } else { input };
    let worked = Worked::new(&subject.train, &step.gear, input).map_err(|error| {
        let key = if matches!(error, Error::NoGear { .. }) { "gear" } else { "torque" };
        refused(&subject.document, path, &[key], &error)
    })?;
    if idle {
        return Ok(None);
    }
    if worked.operation.is_none() {
        let message = format!("gear `{}` carries no such load from its input to its output", step.gear);
        return Err(refused(&subject.document, path, &["gear"], &Named("carries-no-load", message)));
    }
    Ok(Some(worked))
}

/// Rates the meshes of a set over the duty.
pub(super) fn rated(
    subject: &Gearbox,
    set: &RatedSet<'_>,
    duty: &[WorkedStep<'_>],
    life: Time,
    with_factors: bool,
) -> Result<Partly<OverDuty>, Fault> {
    let fault = |error: epicyclic_strength::Error| Fault::of(&subject.document, set.id, &set.path, &error);
    let mut of_steps: Vec<Vec<Load>> = vec![];
    for WorkedStep(entry, worked) in duty {
        let load = match worked.as_ref().map(|worked| SetLoad::of(set.place, worked, Some(entry.speed.0))) {
            Some(Err(Reason::NoTorquesFollow)) => {
                return Err(Fault::Row(NotRated::new(set.id, Reason::NoTorquesFollow).into()));
            }
            None | Some(Err(_)) => SetLoad::idle(set),
            Some(Ok(load)) => load,
        };
        of_steps.push(load.meshes(set, life));
    }
    let idle = SetLoad::idle(set).meshes(set, life);
    Partly::of_meshes(set, |place, mesh| {
        let step = |(WorkedStep(entry, _), loads): (&WorkedStep<'_>, &Vec<Load>)| {
            let Load { torque, speed, .. } = loads[place];
            Step { share: entry.share.0.si(), torque, speed }
        };
        let steps: Vec<Step> = duty.iter().zip(&of_steps).map(step).collect();
        let rating =
            rate_duty(&mesh.mesh, &steps, life, idle[place].contacts, &mesh.method).map_err(fault)?;
        let loaded = of_steps.iter().map(|loads| &loads[place]);
        let loaded = loaded.filter(|load| with_factors && load.torque.si() != 0.0);
        let of_steps: Vec<_> = loaded
            .map(|load| rate(&mesh.mesh, load, &mesh.method))
            .collect::<Result<_, _>>()
            .map_err(fault)?;
        let parts = rating
            .gears
            .each_ref()
            .map(|gear| (gear.contact.as_ref().err().cloned(), gear.root.as_ref().err().cloned()));
        let both = OverDuty::both(set.id, (&mesh.name, &mesh.materials), &rating, &of_steps);
        Ok((both.into(), NotRated::parts(set.id, &mesh.name, parts)))
    })
}

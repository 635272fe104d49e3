//! Rating of a set against the overloads of a file.

use super::load::{SetLoad, torque};
use super::partly::Partly;
use super::place::Fault;
use super::rated_set::RatedSet;
use super::records::{NotRated, Overloaded, Reason, Required};
use crate::analyze::answer::{Input, Worked};
use crate::answer::Warning;
use crate::error::Error;
use crate::shared::fault::{Fault as Refusal, Named, refused};
use crate::shared::gearbox::Gearbox;
use epicyclic_formats::Path;
use epicyclic_formats::gearbox::{GearboxFile, OverloadEntry};
use epicyclic_strength::factor::Side;
use epicyclic_strength::rating::overload;
use epicyclic_strength::sizing::SetOverload;
use epicyclic_train::InputLoad;
use epicyclic_units::Physical;
use epicyclic_units::format::trimmed;
use std::collections::BTreeSet;
use uom::si::f64::Time;

/// Overload from the file, with the required safeties and its gear at that load.
pub(crate) struct Peak<'g> {
    entry: &'g OverloadEntry,
    pub(crate) required: Required,
    pub(crate) worked: Worked<'g>,
}

impl Peak<'_> {
    /// Name of the selected gear.
    pub(super) fn gear(&self) -> &str {
        &self.entry.gear
    }

    /// Overload as the load of a set; `None` if its torques cannot be computed.
    pub(crate) fn felt(&self, set: usize) -> Option<SetOverload> {
        let Required { flank, root } = self.required;
        let sun_torque = torque(set, &self.worked)?;
        Some(SetOverload { sun_torque, required_contact: flank, required_root: root })
    }
}

/// Reads the overloads of a file, or of one gear if it is named.
///
/// # Errors
/// [`Error::Document`] for gears that do not exist or cannot carry the load, torques of 0, and required
/// safeties that are not above 0.
pub(crate) fn peaks<'g>(
    subject: &'g Gearbox,
    all: &'g [OverloadEntry],
    gear: Option<&str>,
) -> Result<Vec<Peak<'g>>, Error> {
    let peak = |(place, entry): (usize, &'g OverloadEntry)| {
        let path = Path::root().key("overload").index(place);
        let no = |key: &str, why: &dyn Refusal| refused(&subject.document, &path, &[key], why);
        let required = Required::of(entry.required.as_ref());
        required.check().map_err(|error| no("required", &error))?;
        if entry.torque.0.si() == 0.0 {
            return Err(no("torque", &Named("no-torque", "an overload needs a torque other than 0")));
        }
        let input = Input { speed: None, load: Some(InputLoad::Torque(entry.torque.0)) };
        let worked = Worked::new(&subject.train, &entry.gear, input).map_err(|error| {
            let key = if matches!(error, Error::NoGear { .. }) { "gear" } else { "torque" };
            no(key, &error)
        })?;
        if worked.operation.is_none() {
            let message = format!("gear `{}` carries no such load from its input to its output", entry.gear);
            return Err(no("gear", &Named("carries-no-load", message)));
        }
        Ok(Peak { entry, required, worked })
    };
    let all = all.iter().enumerate().map(peak).collect::<Result<Vec<_>, _>>()?;
    Ok(all.into_iter().filter(|peak| gear.is_none_or(|gear| peak.entry.gear == gear)).collect())
}

/// Warnings of gears whose greatest overload is below a torque of their duty.
pub(crate) fn below_duty(file: &GearboxFile) -> Vec<Warning> {
    let greatest = |torques: &mut dyn Iterator<Item = f64>| torques.map(f64::abs).fold(0.0, f64::max);
    let gears: BTreeSet<&str> = file.overload.iter().map(|entry| entry.gear.as_str()).collect();
    let of_gear = |gear: &str| {
        let overloads = file.overload.iter().filter(|entry| entry.gear == gear);
        let steps = file.duty.iter().filter(|step| step.gear == gear && step.share.0.si() > 0.0);
        let overload = greatest(&mut overloads.map(|entry| entry.torque.0.si()));
        let duty = greatest(&mut steps.map(|step| step.torque.0.si()));
        let message = || {
            let [overload, duty] = [overload, duty].map(|torque| trimmed(torque, 6));
            format!(
                "gear {gear}: the overload of {overload} N·m is below the {duty} N·m of the duty; it is the greatest torque of the life: write {duty} N·m or more"
            )
        };
        (overload < duty).then(|| Warning { name: "overload-below-duty", message: message() })
    };
    gears.into_iter().filter_map(of_gear).collect()
}

/// Rates the meshes of a set against an overload. A set that does not roll carries its torque too.
pub(super) fn rated(
    subject: &Gearbox,
    set: &RatedSet<'_>,
    peak: &Peak<'_>,
    life: Time,
) -> Result<Partly<Overloaded>, Fault> {
    let fault = |error: epicyclic_strength::Error| Fault::of(&subject.document, set.id, &set.path, &error);
    let load = SetLoad::of(set.place, &peak.worked, None);
    let load = load.map_err(|reason| Fault::Row(NotRated::new(set.id, reason).into()))?;
    let loads = load.meshes(set, life);
    Partly::of_meshes(set, |place, mesh| {
        let torque = loads[place].torque;
        if torque.si() == 0.0 {
            return Err(Fault::Row(NotRated::new(set.id, Reason::NoTorque).into()));
        }
        let rating = overload(&mesh.mesh, torque, &mesh.method).map_err(fault)?;
        let parts = rating
            .gears
            .each_ref()
            .map(|gear| (gear.contact.as_ref().err().cloned(), gear.root.as_ref().err().cloned()));
        let both = Side::BOTH.map(|side| Overloaded {
            gear: peak.entry.gear.clone(),
            torque_n_m: peak.entry.torque.0.si(),
            set: set.id.to_owned(),
            mesh: mesh.name.clone(),
            toothed_gear: mesh.name.gears[side as usize].clone(),
            flank_safety: rating.gears[side as usize].contact.as_ref().ok().copied(),
            root_safety: rating.gears[side as usize].root.as_ref().ok().copied(),
            required: peak.required,
        });
        Ok((both.into(), NotRated::parts(set.id, &mesh.name, parts)))
    })
}

//! Loads of the sets of a gearbox in its gears, for a search among many gearboxes.

use super::making::Load;
use super::masses::of_torques;
use crate::analyze::answer::{Input, Worked};
use crate::error::Error;
use crate::shared::application::Application;
use crate::strength::answer::load::felt;
use epicyclic_gears::ToothCount;
use epicyclic_strength::lightest::LoadedSet;
use epicyclic_strength::sizing::{SetOverload, SetStep, SetTeeth};
use epicyclic_train::{Gearbox, InputLoad};

/// Simple sets of a gearbox with their teeth and loads, and the mass in kg of the parts that follows from torques.
/// The gears have their shares of the time. `overload` has the static safeties that are required.
///
/// # Errors
/// [`Error::NothingToSize`] where torques do not follow.
pub(super) fn sets(
    gearbox: &Gearbox,
    teeth: &[[ToothCount; 3]],
    gears: &[(&str, f64)],
    (load, application): (Load<'_>, Option<Application>),
    overload: Option<&SetOverload>,
) -> Result<(Vec<LoadedSet>, f64), Error> {
    let no_torques = || Error::NothingToSize { sets: vec![] };
    let empty = |teeth: &[ToothCount; 3]| {
        let teeth = SetTeeth::Simple(*teeth);
        LoadedSet { teeth, duty: vec![], overloads: vec![] }
    };
    let mut all: Vec<LoadedSet> = teeth.iter().map(empty).collect();
    let of_input = Some(InputLoad::Torque(load.torque));
    let worked = |gear| Worked::new(gearbox, gear, Input { speed: Some(load.speed), load: of_input });
    let worked = gears.iter().map(|(gear, _)| worked(gear)).collect::<Result<Vec<_>, Error>>()?;
    for ((_, share), worked) in gears.iter().zip(&worked) {
        for (place, set) in all.iter_mut().enumerate() {
            let (torque, [sun, carrier]) = felt(place, worked, load.speed).ok_or_else(no_torques)?;
            let step = |[part, of_torque, of_speed]: &[f64; 3]| SetStep {
                share: share * part,
                sun_torque: torque * *of_torque,
                sun_speed: sun * *of_speed,
                carrier_speed: carrier * *of_speed,
            };
            set.duty.extend(load.spectrum.iter().map(step));
            let overload = load.overload.zip(overload);
            set.overloads.extend(
                overload.map(|(factor, required)| SetOverload { sun_torque: torque * factor, ..*required }),
            );
        }
    }
    let steps = load.spectrum.iter().filter(|[share, ..]| *share > 0.0);
    let greatest = steps.map(|[_, torque, _]| *torque).fold(0.0, f64::max);
    let worked: Vec<_> = worked.iter().map(|gear| (greatest, gear)).collect();
    let others = of_torques(gearbox, &worked, (application, load.overload));
    Ok((all, others.into_iter().flatten().sum()))
}

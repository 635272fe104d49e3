//! Loads of the sets of a gearbox in its gears, for a search among many gearboxes.

use super::making::Load;
use crate::analyze::answer::{Input, Worked};
use crate::error::Error;
use crate::strength::answer::load::felt;
use epicyclic_gears::ToothCount;
use epicyclic_strength::lightest::LoadedSet;
use epicyclic_strength::sizing::{SetOverload, SetStep, SetTeeth};
use epicyclic_train::{Gearbox, InputLoad};

/// The simple sets of a gearbox with these teeth and their loads, by gears with their shares of the time.
/// `overload` has the static safeties that are required.
///
/// # Errors
/// [`Error::NothingToSize`] where torques do not follow.
pub(super) fn sets(
    gearbox: &Gearbox,
    teeth: &[[ToothCount; 3]],
    gears: &[(&str, f64)],
    load: Load<'_>,
    overload: Option<&SetOverload>,
) -> Result<Vec<LoadedSet>, Error> {
    let no_torques = || Error::NothingToSize { sets: vec![] };
    let empty = |teeth: &[ToothCount; 3]| {
        let teeth = SetTeeth::Simple(*teeth);
        LoadedSet { teeth, duty: vec![], overloads: vec![] }
    };
    let mut all: Vec<LoadedSet> = teeth.iter().map(empty).collect();
    for (gear, share) in gears {
        let of_input = Some(InputLoad::Torque(load.torque));
        let worked = Worked::new(gearbox, gear, Input { speed: Some(load.speed), load: of_input })?;
        for (place, set) in all.iter_mut().enumerate() {
            let (torque, [sun, carrier]) = felt(place, &worked, load.speed).ok_or_else(no_torques)?;
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
    Ok(all)
}

//! Mass of a whole gearbox: gears, carriers and housing, slow shaft, flanges, brakes and clutches.

use super::making::MAKING;
use super::records::SizesStep;
use crate::analyze::answer::Worked;
use crate::error::Error;
use crate::shared::application::Application;
use crate::shared::gearbox::{Choice, one};
use crate::strength::answer::duty::steps;
use epicyclic_formats::Document;
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_strength::masses::{servo_flanges, shift_element};
use epicyclic_strength::series::slow_shaft;
use epicyclic_train::Gearbox as Train;
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::{Length, Torque};

/// Masses of the parts of a gearbox, all but the gears by rules.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Masses {
    /// Mass of the gears in kg.
    pub gears_kg: f64,
    /// Mass of carriers and housing in kg.
    pub structure_kg: f64,
    /// Mass of the slow shaft with its bearings and seals in kg; null where it is part of the machine.
    pub slow_shaft_kg: Option<f64>,
    /// Mass of flanges, motor adapter and output bearings of a servo gearbox in kg; null of others.
    pub flanges_kg: Option<f64>,
    /// Mass of brakes and clutches in kg; null without any.
    pub shift_elements_kg: Option<f64>,
    /// Sum of these in kg.
    pub whole_kg: f64,
}

impl Masses {
    /// Whether sets, shafts and housing are all that makes the length: flanges, brakes and clutches have none here.
    pub(crate) const fn are_of_sets(&self) -> bool {
        self.flanges_kg.is_none() && self.shift_elements_kg.is_none()
    }

    /// Masses of a gearbox by its file with sizes; `None` if a set has no size.
    ///
    /// # Errors
    /// Those of the reader.
    pub(super) fn of(
        file: &str,
        sizes: &SizesStep,
        (application, overload): (Option<Application>, Option<f64>),
    ) -> Result<Option<Self>, Error> {
        let (Some(gears_kg), Some(sets_kg)) = (sizes.mass_kg, sizes.with_structure_kg) else {
            return Ok(None);
        };
        let document = Document::parse_one(MAKING, file.as_bytes())?;
        let subject = one(&document, &Choice::default())?;
        let file: GearboxFile = document.read()?;
        let steps = steps(&subject, &file.duty)?;
        let rings = sizes.sets.iter().filter_map(|set| set.found.first()?.ring_diameter_m);
        let flanges_kg = rings
            .reduce(f64::max)
            .filter(|_| application.is_some_and(Application::has_flanges))
            .map(|ring| servo_flanges(Length::from_si(ring)).si());
        let worked = steps.iter().filter_map(|step| Some((1.0, step.1.as_ref()?)));
        let [slow_shaft_kg, shift_elements_kg] =
            of_torques(&subject.train, &worked.collect::<Vec<_>>(), (application, overload));
        let others = [slow_shaft_kg, flanges_kg, shift_elements_kg];
        Ok(Some(Self {
            gears_kg,
            structure_kg: sets_kg - gears_kg,
            slow_shaft_kg,
            flanges_kg,
            shift_elements_kg,
            whole_kg: sets_kg + others.into_iter().flatten().sum::<f64>(),
        }))
    }
}

/// Masses of the parts that follow from torques, in kg: of the slow shaft, `None` where it is part of the machine;
/// of brakes and clutches, `None` without any. The gears are with factors on their torques.
pub(super) fn of_torques(
    train: &Train,
    gears: &[(f64, &Worked<'_>)],
    (application, overload): (Option<Application>, Option<f64>),
) -> [Option<f64>; 2] {
    let greatest = |of: &dyn Fn(&Worked<'_>) -> Option<f64>| {
        let all = gears.iter().filter_map(|(factor, gear)| of(gear).map(|torque| factor * torque));
        Torque::from_si(all.fold(0.0, f64::max))
    };
    // The slower of input and output, without losses.
    let of_slow_shaft = |gear: &Worked<'_>| {
        let ratio = gear.analysis.ratio()?.abs().max(1.0);
        Some(gear.operation.as_ref()?.input.si().abs() * ratio)
    };
    let has_slow_shaft = application.is_none_or(Application::has_slow_shaft);
    let slow_shaft_kg = has_slow_shaft.then(|| slow_shaft(greatest(&of_slow_shaft), overload).si());
    let peak = overload.unwrap_or(1.0).max(1.0);
    let discs = Application::torque_of_discs(application);
    let of_element = |place: usize| {
        let carried = |gear: &Worked<'_>| {
            let torque = gear.operation.as_ref()?.shift_elements[place]?;
            Some(torque.si().abs())
        };
        shift_element(peak * greatest(&carried), discs).si()
    };
    let elements = train.shift_elements().len();
    [slow_shaft_kg, (elements > 0).then(|| (0..elements).map(of_element).sum())]
}

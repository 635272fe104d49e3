//! Mass of a whole gearbox: gears, carriers and housing, slow shaft, flanges, brakes and clutches.

use super::making::MAKING;
use super::records::SizesStep;
use crate::error::Error;
use crate::shared::application::Application;
use crate::shared::gearbox::{Choice, Gearbox, one};
use crate::strength::answer::duty::{WorkedStep, steps};
use epicyclic_formats::Document;
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_strength::masses::{servo_flanges, shift_element};
use epicyclic_strength::series::slow_shaft;
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
        let torque = |torque: f64| Torque::from_si(torque);
        let has_slow_shaft = application.is_none_or(Application::has_slow_shaft);
        let shaft = slow_shaft(torque(greatest(&steps, of_slow_shaft)), overload);
        let slow_shaft_kg = Some(shaft.si()).filter(|_| has_slow_shaft);
        let rings = sizes.sets.iter().filter_map(|set| set.found.first()?.ring_diameter_m);
        let flanges_kg = rings
            .reduce(f64::max)
            .filter(|_| application.is_some_and(Application::has_flanges))
            .map(|ring| servo_flanges(Length::from_si(ring)).si());
        let peak = overload.unwrap_or(1.0).max(1.0);
        let discs = Application::torque_of_discs(application);
        let of_element = |place: usize| {
            let carried = |step: &WorkedStep<'_>| {
                let operation = step.1.as_ref()?.operation.as_ref()?;
                operation.shift_elements[place].map(|torque| torque.si().abs())
            };
            shift_element(torque(peak * greatest(&steps, carried)), discs).si()
        };
        let elements = elements(&subject);
        let shift_elements_kg = (elements > 0).then(|| (0..elements).map(of_element).sum());
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

/// Number of brakes and clutches.
fn elements(subject: &Gearbox) -> usize {
    subject.train.shift_elements().len()
}

/// Greatest value of all steps; 0 if none has any.
fn greatest(steps: &[WorkedStep<'_>], of: impl Fn(&WorkedStep<'_>) -> Option<f64>) -> f64 {
    steps.iter().filter_map(of).fold(0.0, f64::max)
}

/// Torque without losses of the slower of input and output, in N·m.
fn of_slow_shaft(step: &WorkedStep<'_>) -> Option<f64> {
    let ratio = step.1.as_ref()?.analysis.ratio()?;
    Some(step.0.torque.0.si().abs() * ratio.abs().max(1.0))
}

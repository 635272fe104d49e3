//! Flanks under load in a search: their limits, their figures, and a bound that needs no teeth.

use epicyclic_units::Physical;
use uom::si::f64::Pressure;

use super::super::objective::of_flow;
use super::shape::Shape;
use super::{FormSearch, Objective};
use crate::Error;
use crate::contact::{By, Conjugate};
use crate::flanks::{AllowedPressure, LoadedPath, MaterialLimits, SealingContact};
use crate::motor::Motor;
use crate::profile::{Profile, ToothForm};
use crate::quantity::Quantity;
use crate::ranges::{self, positive_pressure};
use crate::reason::Reason;
use std::f64::consts::PI;

/// Inputs for the flanks under load, and their limits.
#[derive(Debug, Clone, PartialEq)]
pub struct FlankOrder {
    /// Allowed stresses of the materials, from which the allowed pressure is calculated, and the effective
    /// modulus.
    pub materials: MaterialLimits,
    /// Rule that chooses the sealing contact of two in mesh.
    pub sealing: SealingContact,
    /// The part of the path on which stresses are taken.
    pub path: LoadedPath,
    /// Greatest ripple at the flanks.
    pub ripple: Option<f64>,
    /// Least torque over the mean, satellites sealing at the flanks.
    pub least_torque: Option<f64>,
    /// Greatest pressure of Hertz at the pressure drop wanted.
    pub contact_stress: Option<Pressure>,
    /// Greatest bending stress at a root at the pressure drop wanted.
    pub root_stress: Option<Pressure>,
    /// Least pressure drop that the materials must allow.
    pub allowed_pressure: Option<Pressure>,
}

impl FlankOrder {
    /// Order with these materials, the nearest contacts as seals, stresses on the whole path, and no limits.
    #[must_use]
    pub fn of(materials: MaterialLimits) -> Self {
        Self {
            materials,
            sealing: SealingContact::default(),
            path: LoadedPath::default(),
            ripple: None,
            least_torque: None,
            contact_stress: None,
            root_stress: None,
            allowed_pressure: None,
        }
    }

    pub(super) fn checked(&self, pressure_drop: Option<Pressure>) -> Result<(), Error> {
        ranges::stress_limit(Quantity::ContactLimit, self.materials.contact)?;
        ranges::stress_limit(Quantity::RootLimit, self.materials.root)?;
        positive_pressure(Quantity::ContactModulus, self.materials.modulus)?;
        of_flow(self.ripple, self.least_torque)?;
        for (quantity, stress) in
            [(Quantity::ContactStress, self.contact_stress), (Quantity::RootStress, self.root_stress)]
        {
            if let Some(stress) = stress {
                positive_pressure(quantity, stress)?;
                if pressure_drop.is_none() {
                    return Err(Error::NoPressureDrop { quantity });
                }
            }
        }
        self.allowed_pressure
            .map_or(Ok(()), |allowed| positive_pressure(Quantity::AllowedPressure, allowed).map(|_| ()))
    }
}

/// Figures of a design's flanks under load; of rigid teeth, for comparison, not for proof of strength.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlankFigures {
    /// Ripple of flow and torque, satellites sealing at the flanks.
    pub ripple: f64,
    /// Least torque over the mean, likewise.
    pub least_over_mean: f64,
    /// Greatest pressure of Hertz at the pressure drop wanted; none without one.
    pub contact_stress: Option<Pressure>,
    /// Greatest bending stress at a root at the pressure drop wanted; none without one.
    pub root_stress: Option<Pressure>,
    /// The pressure drop that the materials allow.
    pub allowed: AllowedPressure,
}

impl FlankFigures {
    /// Figures of a motor with a form, or the reason why it has none or is refused.
    pub(super) fn of(
        order: &FlankOrder,
        pressure_drop: Option<Pressure>,
        motor: &Motor,
        form: ToothForm,
    ) -> Result<Self, Reason> {
        let profile = Profile::new(motor, form).map_err(|_| Reason::NoTeeth)?;
        let allowed = profile.allowed_pressure(order.path, &order.materials);
        let allowed = allowed.map_err(|_| Reason::CannotHold)?;
        let materials = &order.materials;
        // p_H rises with the root of the pressure drop, bending with it.
        let contact_stress =
            pressure_drop.map(|drop| materials.contact * (drop / allowed.by_contact).value.sqrt());
        let root_stress = pressure_drop.map(|drop| materials.root * (drop / allowed.by_root).value);
        // A value that is not a number keeps no limit.
        let keeps = |value: Option<Pressure>, most: Option<Pressure>| {
            value.zip(most).is_none_or(|(value, most)| value <= most)
        };
        if !keeps(contact_stress, order.contact_stress) {
            return Err(Reason::ContactStress);
        }
        if !keeps(root_stress, order.root_stress) {
            return Err(Reason::RootStress);
        }
        if !order.allowed_pressure.is_none_or(|least| allowed.pressure >= least) {
            return Err(Reason::AllowedPressure);
        }
        let ripple = profile.flank_ripple(order.sealing);
        let figures = Self {
            ripple: ripple.at_flanks.delta,
            least_over_mean: ripple.least_over_mean,
            contact_stress,
            root_stress,
            allowed,
        };
        if !order.ripple.is_none_or(|most| figures.ripple <= most) {
            return Err(Reason::FlankRipple);
        }
        if !order.least_torque.is_none_or(|least| figures.least_over_mean >= least) {
            return Err(Reason::LeastTorque);
        }
        Ok(figures)
    }

    /// The figure that an objective goes by, as a logarithm, the greater the better; none of those of other
    /// kinds.
    pub(super) fn value(&self, objective: Objective) -> Option<f64> {
        let log = |value: f64| if value > 0.0 { libm::log(value) } else { f64::NEG_INFINITY };
        Some(match objective {
            Objective::FlankRipple => -log(self.ripple),
            Objective::LeastTorque => log(self.least_over_mean),
            // The drop Δp does not matter: p_H² and σ_F are inverse to the pressures that they allow.
            Objective::ContactStress => 0.5 * log(self.allowed.by_contact.si()),
            Objective::RootStress => log(self.allowed.by_root.si()),
            Objective::AllowedPressure => log(self.allowed.pressure.si()),
            _ => return None,
        })
    }
}

/// Bound of the pressures of Hertz at crest and trough, with contacts at the pitch points: the load there is
/// `Δp·b·r/cos α`.
pub(super) struct PitchBound {
    /// The greatest `1 + r·κ`.
    bent: f64,
}

impl PitchBound {
    pub(super) fn of(motor: &Motor) -> Self {
        let r = motor.shape.satellite_radius();
        let (crest, trough) = (motor.shape.at(By::Phase, 0.0), *motor.shape.trough());
        let bulges = [crest.kappa1, -crest.kappa3, trough.kappa1, -trough.kappa3];
        Self { bent: 1.0 + r * bulges.into_iter().fold(f64::NEG_INFINITY, f64::max) }
    }

    /// The pressure drop that the contacts allow at most, Pa.
    fn by_contact(&self, materials: &MaterialLimits, form: ToothForm) -> f64 {
        let (limit, modulus) = (materials.contact.si(), materials.modulus.si());
        let severity = 2.0 / libm::sin(2.0 * form.pressure_angle.si()) * self.bent / PI;
        limit * limit / (modulus * severity)
    }

    /// Reason why a form is refused whatever its teeth.
    pub(super) fn refusal(
        &self,
        order: &FlankOrder,
        pressure_drop: Option<Pressure>,
        form: ToothForm,
    ) -> Option<Reason> {
        let allowed = self.by_contact(&order.materials, form);
        let least = order.allowed_pressure.map_or(0.0, Physical::si);
        if let (Some(most), Some(drop)) = (order.contact_stress, pressure_drop) {
            let at_pitch = order.materials.contact.si() * (drop.si() / allowed).sqrt();
            if at_pitch > most.si() * (1.0 + crate::tolerance::SLACK) {
                return Some(Reason::ContactStress);
            }
        }
        (allowed * (1.0 + crate::tolerance::SLACK) < least).then_some(Reason::AllowedPressure)
    }

    /// The most that an objective can be, as [`FlankFigures::value`]: without a bound infinite.
    pub(super) fn value(&self, objective: Objective, order: &FlankOrder, form: ToothForm) -> f64 {
        let allowed = libm::log(self.by_contact(&order.materials, form));
        match objective {
            Objective::ContactStress => 0.5 * allowed,
            Objective::AllowedPressure => allowed,
            _ => f64::INFINITY,
        }
    }
}

impl FormSearch {
    /// Whether an objective or a limit needs the figures of the flanks of every design.
    pub(super) fn needs_flanks(&self) -> bool {
        let by_limit = self.flanks.as_ref().is_some_and(|order| {
            order.ripple.is_some()
                || order.least_torque.is_some()
                || order.contact_stress.is_some()
                || order.root_stress.is_some()
                || order.allowed_pressure.is_some()
        });
        by_limit || self.objectives.iter().any(|objective| objective.is_of_flanks())
    }

    /// Objectives of a motor in a form at best, its flanks not known.
    pub(super) fn bound(
        &self,
        value: super::cover::Value,
        bound: &PitchBound,
        form: ToothForm,
    ) -> super::cover::Value {
        let mut value = value;
        if let Some(order) = &self.flanks {
            for &objective in self.objectives.iter().filter(|objective| objective.is_of_flanks()) {
                value[objective as usize] = bound.value(objective, order, form);
            }
        }
        value
    }

    /// Figures of a motor's flanks in a form, if requested.
    pub(super) fn figures(&self, shape: &Shape, form: ToothForm) -> Option<Result<FlankFigures, Reason>> {
        let order = self.flanks.as_ref()?;
        Some(FlankFigures::of(order, self.requirements.pressure_drop, &shape.motor(), form))
    }
}

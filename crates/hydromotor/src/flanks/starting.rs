//! The torque at the start: the rest at the worst angle after the friction of the flanks, with the contacts
//! in their actual places.
//!
//! A motor at rest has its contacts at one place each, not in the mean over a pitch. With the contacts that
//! seal at `e₃` and `e₁` ([`crate::flanks::sealing`]) the torque is `Δp·b·Σ σ·f′`. Per radian of the rotor a
//! satellite turns by `ρ₁/c` against the stator and by `ρ₃/c` against the rotor. So the friction is:
//!
//! ```text
//! M_loss = μ_f·Σ N·(|e₃|·ρ₁ + |e₁|·ρ₃)/c        M_start = min over the angle of  Δp·b·Σ σ·f′ − M_loss
//! ```
//!
//! The sum is over the satellites that part the pressures, `c = ρ₃ − ρ₁`. With `|e| = p_b/4`, the mean over a
//! base pitch, it is the loss of a running motor ([`crate::friction`]).
//!
//! Both are smooth between changeovers of chambers, passages of junctions, changes of the sealing contacts
//! and passages of the pitch points, all at known phases. On each such piece the least is an end, taken from
//! within, or is refined to where it is flat.
//!
//! # Left out
//! The share of load of two pairs in mesh and the third contact: `N` is that of contacts at the pitch points;
//! the change of `N` by friction, of second order in `μ_f`; friction of bearings, seals and faces.

use epicyclic_units::Physical;
use uom::si::f64::{Angle, Length, Pressure, Torque};

use super::forces::Load;
use super::kernel::{flank_number, greatest_of};
use super::sealing::{Flow, Piece, SealingContact, sealed};
use crate::Error;
use crate::contact::Conjugate;
use crate::friction::FrictionRange;
use crate::profile::Profile;
use crate::quantity::Quantity;
use crate::ranges::positive_pressure;

/// The least torque over a revolution at the start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StartingTorque {
    /// Torque without friction.
    pub frictionless: Torque,
    /// Torque with the greatest and with the least friction: the least and the best load that the motor
    /// starts at any angle.
    pub range: [Torque; 2],
    /// The rotation at which the greatest friction leaves least, within the first period.
    pub rotation: Angle,
}

/// `M/(Δp·b·m²)` without friction, and its loss by a coefficient of friction of 1.
fn torques(piece: &Piece<'_>, r: f64, alpha: f64, rotation: f64) -> [f64; 2] {
    let (mut whole, mut lost) = (0.0, 0.0);
    for (contact, sigma, [e3, e1]) in piece.contacts(rotation) {
        whole += sigma * sealed(&contact, [e3, e1]);
        let arm = (e3.abs() * contact.rho1 + e1.abs() * contact.rho3) / (contact.rho3 - contact.rho1);
        // That flanks hold every satellite is checked before.
        lost += flank_number(r, alpha, &contact, sigma).unwrap_or(f64::NAN) * arm;
    }
    [piece.times * whole, piece.times * lost]
}

impl Profile {
    /// The least torque over a revolution at the start, against the friction of the flanks alone, for a
    /// pressure that drives the rotor counter-clockwise; the other way it is the same.
    ///
    /// | symbol | argument | meaning | unit |
    /// |---|---|---|---|
    /// | | `rule` | which of two contacts in mesh seals and slides | |
    /// | `b` | `width` | width of the wheels | m |
    /// | `Δp` | `pressure_drop` | high less low pressure, above 0 | Pa |
    /// | `μ_f` | `friction` | coefficient of friction of the flanks | 1 |
    ///
    /// # Errors
    /// [`Error::NotPositive`] for width and pressure drop, [`Error::CannotHold`] where the flanks hold no
    /// satellite.
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::flanks::SealingContact;
    /// use epicyclic_hydromotor::friction::FrictionRange;
    /// use epicyclic_hydromotor::profile::{Profile, ToothForm};
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::{f64::{Length, Pressure}, length::millimeter, pressure::megapascal};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(6, 4, 66, 10)?, mm(1.0), mm(40.0))?;
    /// let profile = Profile::new(&motor, ToothForm::default())?;
    /// let (drop, friction) = (Pressure::new::<megapascal>(20.0), FrictionRange::new(0.05, 0.1)?);
    /// let start = profile.starting_torque(SealingContact::Nearest, mm(30.0), drop, friction)?;
    /// assert!(start.range[0] < start.range[1] && start.range[1] < start.frictionless);
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn starting_torque(
        &self,
        rule: SealingContact,
        width: Length,
        pressure_drop: Pressure,
        friction: FrictionRange,
    ) -> Result<StartingTorque, Error> {
        let drop = positive_pressure(Quantity::PressureDrop, pressure_drop)?.si();
        let motor = self.motor();
        let pressure_angle = self.form().pressure_angle;
        let load = Load::new(pressure_angle, width, pressure_drop)?;
        motor.greatest_flank_forces(pressure_angle, width, pressure_drop)?;
        let r = motor.shape.satellite_radius();
        let pieces = Flow::new(self, rule).pieces_of_arms();
        let ranges: Vec<[f64; 2]> = pieces.iter().map(|(range, _)| *range).collect();
        let [low, high] = friction.ends();
        let [none, least, most] = greatest_of(&ranges, 0.0, |piece, rotation| {
            let [whole, lost] = torques(&pieces[piece].1, r, load.alpha, rotation);
            [0.0, low, high].map(|friction| friction * lost - whole)
        });
        let unit = drop * crate::machine::width(width)?.si() * motor.module().si().powi(2);
        let torque = |number: f64| Torque::from_si(-number * unit);
        Ok(StartingTorque {
            frictionless: torque(none.value),
            range: [torque(most.value), torque(least.value)],
            rotation: Angle::from_si(most.place),
        })
    }
}

#[cfg(test)]
mod tests;

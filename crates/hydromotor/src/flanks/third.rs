//! The third contact, which holds a satellite whose contacts are off the pitch points.
//!
//! The pressures act on the chord `K₁K₃` between the contacts: a force `Δp·b·|K₁K₃|` at right angles to it,
//! through its middle. Both flank forces stay in their lines of action, through the pitch points. These cross
//! on the chord's perpendicular bisector only if the contacts are at the pitch points. Otherwise the two
//! leave a moment, and the satellite turns in its backlash until a back flank holds it:
//!
//! ```text
//! N₃·u₃ + N₁·u₁ + N_b·u_b + F = 0        r·cos α·σ·(−N₃ + N₁ ± N_b) + (moment of F about the centre) = 0
//! ```
//!
//! with `−N_b` for the rotor's back flank, `+N_b` for the stator's. The two back flanks are mirror images in
//! the satellite's bisector of the pitch points, and so are the front ones. About the point where the front
//! lines of action cross, the moments of the back flanks are opposite. So exactly one of them can hold the
//! satellite: the one with `N_b ≥ 0`. It changes within a pitch. Let `B` be `N_b` for the rotor's flank and
//! `−N_b` for the stator's, and `T` the moment of `F` over `r·cos α`:
//!
//! ```text
//! B = (sin(α + σ·μ)·σ·T − F_x)/(2·sin α·cos μ)    N₁ − N₃ = B − σ·T
//! N₁ + N₃ = (σ·F_y + cos(α − σ·μ)·|B|)/cos(α + σ·μ)
//! ```
//!
//! These are bounds for rigid teeth with one pair in each mesh: the pair that seals. The tooth space between
//! the front and the back contact is assumed to be on the side of the seal.

use epicyclic_units::Physical;
use uom::si::f64::{Angle, Force, Length, Pressure};

use super::forces::{Load, Push};
use super::kernel::{flank_number, greatest_of};
use super::sealing::{Rows, Seal, SealingContact};
use super::stress::Mesh;
use crate::Error;
use crate::contact::{By, Conjugate, Contact};
use crate::motor::Motor;
use crate::profile::Profile;
use crate::quantity::Quantity;
use crate::ranges::{finite_angle, finite_modules};
use epicyclic_numerics::roots::bracketed;

/// Forces that hold a satellite with three contacts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThirdContact {
    /// Direction in which the satellite is pushed.
    pub push: Push,
    /// `N₃`, the force of the stator's flank.
    pub stator: Force,
    /// `N₁`, the force of the rotor's flank.
    pub rotor: Force,
    /// The wheel whose back flank holds it.
    pub back_wheel: Mesh,
    /// `N_b`, the force of that flank.
    pub back: Force,
}

/// A force of the third contact where it is greatest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForceBound {
    /// The force.
    pub force: Force,
    /// Direction in which the satellite is pushed.
    pub push: Push,
    /// Rotation of the rotor at which satellite 0 has it.
    pub rotation: Angle,
}

/// Bounds of the forces over a revolution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThirdContactBounds {
    /// Greatest force on the stator's flanks.
    pub stator: ForceBound,
    /// Greatest force on the rotor's flanks.
    pub rotor: ForceBound,
    /// Greatest force on the stator's back flanks; `None` if they never hold a satellite.
    pub stator_back: Option<ForceBound>,
    /// Greatest force on the rotor's back flanks; `None` if they never hold a satellite.
    pub rotor_back: Option<ForceBound>,
}

/// Sine and cosine of a pressure angle.
#[derive(Debug, Clone, Copy)]
struct Inclined {
    sin: f64,
    cos: f64,
}

impl Inclined {
    fn new(alpha: f64) -> Self {
        let (sin, cos) = libm::sincos(alpha);
        Self { sin, cos }
    }

    /// `N₃`, `N₁`, and the force of the rotor's back flank, or with the sign changed of the stator's, over
    /// `Δp·b·m`; `None` if the equations have no solution.
    fn held(self, r: f64, contact: &Contact, sigma: f64, [e3, e1]: [f64; 2]) -> Option<[f64; 3]> {
        let (mu_sin, mu_cos) = libm::sincos(contact.mu);
        // α + σ·μ, and of α − σ·μ the cosine.
        let sin = self.sin * mu_cos + sigma * self.cos * mu_sin;
        let cos = self.cos * mu_cos - sigma * self.sin * mu_sin;
        let cos_back = self.cos * mu_cos + sigma * self.sin * mu_sin;
        let across = 2.0 * self.sin * mu_cos;
        if (2.0 * cos * across).abs() < crate::tolerance::SINGULAR {
            return None;
        }
        let chord = [2.0 * r * mu_cos - sin * (e3 + e1), sigma * cos * (e1 - e3)];
        let force = [-sigma * chord[1], sigma * chord[0]];
        let arm = [0.5 * sin * (e1 - e3), -0.5 * sigma * cos * (e3 + e1) - r * mu_sin];
        let turning = sigma * (arm[0] * force[1] - arm[1] * force[0]) / (r * self.cos);
        let back = (sin * turning - force[0]) / across;
        let difference = back - turning;
        let sum = (sigma * force[1] + cos_back * back.abs()) / cos;
        Some([0.5 * (sum - difference), 0.5 * (sum + difference), back])
    }
}

impl Motor {
    /// Forces that hold a satellite with contacts at `e₃` and `e₁` along the lines of action from the pitch
    /// points, positive towards its base circle. `rotation` counts from the place of the satellite between
    /// two crests. `None` while the satellite is idle.
    ///
    /// # Errors
    /// Errors of [`flank_forces`](Self::flank_forces).
    #[allow(clippy::too_many_arguments)] // the load, the place, and the two offsets
    pub fn third_contact(
        &self,
        pressure_angle: Angle,
        rotation: Angle,
        stator_offset: Length,
        rotor_offset: Length,
        width: Length,
        pressure_drop: Pressure,
    ) -> Result<Option<ThirdContact>, Error> {
        let load = Load::new(pressure_angle, width, pressure_drop)?;
        let phase = finite_angle(Quantity::Rotation, rotation)?;
        let e3 = finite_modules(Quantity::StatorOffset, stator_offset, self.module())?;
        let e1 = finite_modules(Quantity::RotorOffset, rotor_offset, self.module())?;
        let Some(sigma) = self.pushed(phase, load.sign()) else { return Ok(None) };
        let contact = self.shape.at(By::Phase, phase);
        self.third(&load, &contact, sigma, [e3, e1]).map(Some)
    }

    fn third(
        &self,
        load: &Load,
        contact: &Contact,
        sigma: f64,
        offsets: [f64; 2],
    ) -> Result<ThirdContact, Error> {
        let r = self.shape.satellite_radius();
        // Where two flanks do not hold it a third does no better.
        flank_number(r, load.alpha, contact, sigma)?;
        let held = Inclined::new(load.alpha).held(r, contact, sigma, offsets);
        let [stator, rotor, back] = held.unwrap_or([f64::INFINITY; 3]);
        Ok(ThirdContact {
            push: Push::of(sigma),
            stator: load.force(self, stator),
            rotor: load.force(self, rotor),
            back_wheel: if back < 0.0 { Mesh::Stator } else { Mesh::Rotor },
            back: load.force(self, back.abs()),
        })
    }
}

impl Profile {
    /// Forces that hold each satellite after a rotation, with contacts where its flanks seal; `None` for an
    /// idle one.
    ///
    /// # Errors
    /// Errors of [`Motor::flank_forces`].
    pub fn third_contacts(
        &self,
        rule: SealingContact,
        rotation: Angle,
        width: Length,
        pressure_drop: Pressure,
    ) -> Result<Vec<Option<ThirdContact>>, Error> {
        let load = Load::new(self.form().pressure_angle, width, pressure_drop)?;
        let rotation = finite_angle(Quantity::Rotation, rotation)?;
        let motor = self.motor();
        let rows = [1.0, -1.0].map(|sigma| Rows::new(self, sigma, rule));
        let of = |j: u32| {
            let phase = motor.phase(rotation, j);
            let Some(sigma) = motor.pushed(phase, load.sign()) else { return Ok(None) };
            let contact = motor.shape.at(By::Phase, phase);
            let rows = &rows[usize::from(sigma < 0.0)];
            motor.third(&load, &contact, sigma, rows.offsets(&rows.at(&contact), &contact)).map(Some)
        };
        (0..motor.numbers().satellites()).map(of).collect()
    }

    /// Bounds of the forces with a third contact over a revolution.
    ///
    /// Smooth pieces of the loaded phases lie between changes of the sealing contacts, junctions and changes
    /// of the back flank. Each is evaluated with its own contacts up to both ends.
    ///
    /// # Errors
    /// Errors of [`Motor::flank_forces`].
    pub fn third_contact_bounds(
        &self,
        rule: SealingContact,
        width: Length,
        pressure_drop: Pressure,
    ) -> Result<ThirdContactBounds, Error> {
        let load = Load::new(self.form().pressure_angle, width, pressure_drop)?;
        let motor = self.motor();
        motor.greatest_flank_forces(self.form().pressure_angle, width, pressure_drop)?;
        let (r, by) = (motor.shape.satellite_radius(), motor.shape.explicit());
        let inclined = Inclined::new(load.alpha);
        // Stator, rotor, the stator's and the rotor's back flank.
        let mut best = [(f64::NEG_INFINITY, 1.0, 0.0); 4];
        for crest in [true, false] {
            let sigma = Motor::push(crest, load.sign());
            let rows = Rows::new(self, sigma, rule);
            let forces = |seals: &[Seal; 2], place: f64| {
                let contact = motor.shape.at(by, place);
                let held = inclined.held(r, &contact, sigma, rows.offsets(seals, &contact));
                let [stator, rotor, back] = held.unwrap_or([f64::NAN; 3]);
                [stator, rotor, -back, back]
            };
            let range = motor.loaded(crest);
            let (mut pieces, mut seals) = (Vec::new(), Vec::new());
            for pair in rows.pieces(motor, by, range).windows(2) {
                let sealing = rows.at(&motor.shape.at(by, 0.5 * (pair[0] + pair[1])));
                let back = |place: f64| forces(&sealing, place)[3];
                if back(pair[0]) * back(pair[1]) < 0.0 {
                    let change = bracketed(pair[0], pair[1], back);
                    pieces.extend([[pair[0], change], [change, pair[1]]]);
                    seals.extend([sealing, sealing]);
                } else {
                    pieces.push([pair[0], pair[1]]);
                    seals.push(sealing);
                }
            }
            let tops = greatest_of(&pieces, 0.0, |piece, place| forces(&seals[piece], place));
            for (best, top) in best.iter_mut().zip(tops) {
                if top.value > best.0 {
                    let phase = motor.shape.at(by, top.place).phase;
                    *best = (top.value, sigma, phase.clamp(range[0], range[1]));
                }
            }
        }
        let [stator, rotor, stator_back, rotor_back] = best.map(|(number, sigma, place)| ForceBound {
            force: load.force(motor, number),
            push: Push::of(sigma),
            rotation: Angle::from_si(place),
        });
        let positive = |bound: ForceBound| (bound.force > Force::default()).then_some(bound);
        Ok(ThirdContactBounds {
            stator,
            rotor,
            stator_back: positive(stator_back),
            rotor_back: positive(rotor_back),
        })
    }
}

#[cfg(test)]
mod tests;

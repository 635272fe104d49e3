//! Friction: sliding of the flanks in the mean over the teeth, drag of the end gaps.
//!
//! # Flanks
//! A pair of flanks at the distance `|e|` from the pitch point, along the line of action, slides at that
//! distance times the relative speed of its wheels. Rolling about `P` on the resting stator, a satellite
//! turns by `ρ₁/c` per radian of the rotor, `c = ρ₃ − ρ₁`; against the rotor by `ρ₁/c + 1 = ρ₃/c`. A pair is
//! relieved by the next after a base pitch `p_b = π·m·cos α`. With contacts on either side of the pitch point
//! alike, the mean of `|e|` is therefore `p_b/4`. By the work of the friction `μ_f·N` on both flanks
//!
//! ```text
//! M_loss = μ_f·(p_b/4)·Σ N·(ρ₁ + ρ₃)/c        over the satellites that part the pressures
//! ```
//!
//! with the flank forces `N` of [`crate::flanks::forces`]. The loss at an angle, with the contacts in their
//! actual places, is in [`crate::flanks::starting`]. As `N` grows with `Δp·b·m` like the torque, the part
//! lost depends on shape and `μ_f` alone.
//!
//! # End gaps
//! The oil in a gap `h` between a face and its plate is sheared by `v/h` (Couette); pressure flow adds the
//! same on both walls and takes no power from the rotor. A satellite moves as if it turned about `P`, where
//! `∫ v² dA = (ω·ρ₁/c)²·(3/2)·π·r⁴`, the rotor about its axis:
//!
//! ```text
//! satellites  M = 3·π·η·r⁴·ω/h·Σ (ρ₁/c)²        rotor  M = 2·η·ω·I/h,  I = ∫ ρ² dA over its face
//! ```
//!
//! | symbol | argument | meaning | unit |
//! |---|---|---|---|
//! | `μ_f` | `friction` | coefficient of friction of the flanks, an input, as a range | 1 |
//! | `α` | `pressure_angle` | pressure angle of the teeth | rad |
//! | `b` | `width` | width of the wheels | m |
//! | `Δp` | `pressure_drop` | high less low pressure, above 0 | Pa |
//! | `η` | `viscosity` | dynamic viscosity | Pa·s |
//!
//! # Left out
//! Friction of bearings and shaft seals, of faces that touch, at third contacts; the change of `N` by
//! friction itself, of second order in `μ_f`; churning.

use epicyclic_units::Physical;
use uom::si::f64::{Angle, AngularVelocity, DynamicViscosity, Length, Pressure, Torque};

use crate::Error;
use crate::contact::{By, Conjugate, Contact};
use crate::leakage::EndGaps;
use crate::motor::Motor;
use crate::quantity::Quantity;
use crate::ranges::{self, finite_angle, positive_pressure, ranging};
use epicyclic_numerics::quadrature::quadrature;
use std::f64::consts::{PI, TAU};

/// The greatest coefficient of friction that is taken.
const MOST_FRICTION: f64 = 1.0;

/// Panels of the eight-point rule on a smooth piece.
const PANELS: u32 = 4;

/// A coefficient of friction that is known within a range; an input. Results are ranges, too.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionRange {
    low: f64,
    high: f64,
}

impl FrictionRange {
    /// Range from the least to the greatest coefficient; both may be equal.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless `0 ≤ low ≤ high ≤ 1`.
    pub fn new(low: f64, high: f64) -> Result<Self, Error> {
        let low = ranging(Quantity::FrictionCoefficient, low, [0.0, MOST_FRICTION], "")?;
        let high = ranging(Quantity::FrictionCoefficient, high, [low, MOST_FRICTION], "")?;
        Ok(Self { low, high })
    }

    /// Ends of the range: least and greatest.
    #[must_use]
    pub fn ends(self) -> [f64; 2] {
        [self.low, self.high]
    }
}

/// Drag of the end gaps, the mean over a revolution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GapDrag {
    /// Drag of all satellites, referred to the rotor.
    pub satellites: Torque,
    /// Drag of the rotor.
    pub rotor: Torque,
}

impl Motor {
    /// The friction torque of the flanks over `μ_f`, after a rotation.
    fn loss_over_friction(
        &self,
        pressure_angle: Angle,
        rotation: f64,
        width: Length,
        drop: Pressure,
    ) -> Result<f64, Error> {
        let forces = self.flank_forces(pressure_angle, Angle::from_si(rotation), width, drop)?;
        let arm = self.mean_sliding_arm(pressure_angle);
        let of_satellite = |force: &crate::flanks::FlankForce| {
            let contact = self.shape.at(By::Phase, self.phase(rotation, force.index));
            force.force.si() * sliding(&contact)
        };
        Ok(arm * forces.iter().map(of_satellite).sum::<f64>())
    }

    /// `p_b/4` in metres.
    fn mean_sliding_arm(&self, pressure_angle: Angle) -> f64 {
        0.25 * PI * self.module().si() * libm::cos(pressure_angle.si())
    }

    /// The friction torque of the flanks after a rotation, for the least and the greatest coefficient.
    ///
    /// # Errors
    /// As [`Motor::flank_forces`]; [`Error::NotPositive`] for the pressure drop.
    pub fn friction_torque(
        &self,
        pressure_angle: Angle,
        rotation: Angle,
        width: Length,
        pressure_drop: Pressure,
        friction: FrictionRange,
    ) -> Result<[Torque; 2], Error> {
        positive_pressure(Quantity::PressureDrop, pressure_drop)?;
        let rotation = finite_angle(Quantity::Rotation, rotation)?;
        let over = self.loss_over_friction(pressure_angle, rotation, width, pressure_drop)?;
        Ok(friction.ends().map(|friction| Torque::from_si(friction * over)))
    }

    /// The mean friction torque of the flanks over a revolution, for the least and the greatest coefficient.
    ///
    /// # Errors
    /// As [`Motor::friction_torque`].
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::friction::FrictionRange;
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::f64::{Angle, Length, Pressure};
    /// use uom::si::{angle::degree, length::millimeter, pressure::megapascal};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(6, 4, 66, 10)?, mm(1.0), mm(40.0))?;
    /// let (alpha, drop) = (Angle::new::<degree>(25.0), Pressure::new::<megapascal>(20.0));
    /// let [_, loss] = motor.mean_friction_torque(alpha, mm(30.0), drop, FrictionRange::new(0.05, 0.1)?)?;
    /// let part = loss / motor.theoretical_torque(mm(30.0), drop)?;
    /// assert!((part.value - 0.0469).abs() < 5e-5);
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn mean_friction_torque(
        &self,
        pressure_angle: Angle,
        width: Length,
        pressure_drop: Pressure,
        friction: FrictionRange,
    ) -> Result<[Torque; 2], Error> {
        positive_pressure(Quantity::PressureDrop, pressure_drop)?;
        // Every satellite goes through the same: two loaded ranges of 2π/N in a cycle.
        self.flank_forces(pressure_angle, Angle::from_si(0.0), width, pressure_drop)?;
        let numbers = self.numbers();
        let half = PI / f64::from(numbers.stator_lobes());
        let arm = self.mean_sliding_arm(pressure_angle);
        // A failure within a cycle shows up in the sum.
        let mut failed = None;
        let kink = self.shape.kink();
        let mut sum = 0.0;
        for middle in [0.0, self.shape.trough().phase] {
            let mut ends = vec![middle - half, middle, middle + half];
            for place in
                kink.into_iter().flat_map(|kink| [kink, -kink, 2.0 * self.shape.trough().phase - kink])
            {
                if (place - middle).abs() < half {
                    ends.push(place);
                }
            }
            ends.sort_by(f64::total_cmp);
            for pair in ends.windows(2) {
                let failed = std::cell::RefCell::new(&mut failed);
                sum += quadrature(pair[0], pair[1], PANELS, |phase| {
                    match self.flank_forces(pressure_angle, Angle::from_si(phase), width, pressure_drop) {
                        Ok(forces) => forces[0].force.si() * sliding(&self.shape.at(By::Phase, phase)),
                        Err(error) => {
                            **failed.borrow_mut() = Some(error);
                            f64::NAN
                        }
                    }
                });
            }
        }
        if let Some(error) = failed {
            return Err(error);
        }
        let per_turn = f64::from(numbers.stator_lobes() * numbers.rotor_lobes()) / TAU;
        Ok(friction.ends().map(|friction| Torque::from_si(friction * arm * per_turn * sum)))
    }

    /// The drag of the end gaps at a speed, the mean over a revolution; of a gap of 0, the ideal face that
    /// neither leaks nor drags, none.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for the viscosity, [`Error::OutOfRange`] for gaps and a speed below 0 and a
    /// bore that is not within the rotor.
    pub fn gap_drag(
        &self,
        gaps: EndGaps,
        viscosity: DynamicViscosity,
        bore_radius: Length,
        speed: AngularVelocity,
    ) -> Result<GapDrag, Error> {
        let satellite_gap = ranges::gap(Quantity::SatelliteGap, gaps.satellite)?;
        let rotor_gap = ranges::gap(Quantity::RotorGap, gaps.rotor)?;
        let over_gap = |value: f64, gap: f64| if gap > 0.0 { value / gap } else { 0.0 };
        let viscosity = ranges::viscosity(viscosity)?;
        let speed = ranging(Quantity::Speed, speed.si(), [0.0, f64::INFINITY], "rad/s")?;
        let inner = 0.5 * self.envelope().rotor_inner.mm();
        ranging(Quantity::BoreRadius, bore_radius.mm(), [0.0, inner], "mm")?;
        let module = self.module().si();
        let r = self.satellite_radius().si();
        let trough = self.shape.trough();
        let kinks = self.shape.kink();
        let over = |by: By, f: &dyn Fn(&Contact) -> f64| -> f64 {
            let mut ends = vec![0.0];
            ends.extend(kinks.map(|phase| self.shape.within(By::Phase, phase).get(by)));
            ends.push(trough.get(by));
            ends.windows(2)
                .map(|pair| quadrature(pair[0], pair[1], PANELS, |at| f(&self.shape.within(by, at))))
                .sum()
        };
        // The mean over the phase of a half-lobe is that over a revolution.
        let turned = over(By::Phase, &|contact| (contact.rho1 / (contact.rho3 - contact.rho1)).powi(2));
        let count = f64::from(self.numbers().satellites());
        let of_satellites =
            over_gap(3.0 * PI * viscosity * r.powi(4) * count * turned / trough.phase * speed, satellite_gap);
        let face = 2.0
            * f64::from(self.numbers().rotor_lobes())
            * over(By::RotorAngle, &|contact| 0.25 * contact.rho1.powi(4))
            * module.powi(4)
            - 0.5 * PI * bore_radius.si().powi(4);
        let of_rotor = over_gap(2.0 * viscosity * face * speed, rotor_gap);
        Ok(GapDrag { satellites: Torque::from_si(of_satellites), rotor: Torque::from_si(of_rotor) })
    }
}

/// `(ρ₁ + ρ₃)/c`: how far both pairs of a satellite turn against each other a radian of the rotor.
fn sliding(contact: &Contact) -> f64 {
    (contact.rho1 + contact.rho3) / (contact.rho3 - contact.rho1)
}

#[cfg(test)]
mod tests;

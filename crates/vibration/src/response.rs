//! Forced vibration: the response of a model to displacements in its springs, such as the transmission errors of meshes.
//!
//! A spring `j` whose natural length changes by `e_j(t)` has the force `k_j·(δ_j − e_j)`, so
//!
//! ```text
//! M·q̈ + C·q̇ + K·q = Σ b_j·k_j·e_j,     e_j = a_j·cos(ω·t + φ_j)
//! ```
//!
//! Damping is modal: with the modes `Φ`, mass-normalised, `C = M·Φ·diag(2·ζ·ω_r)·Φᵀ·M`, so that each mode has the damping ratio `ζ`; zero
//! modes have none. In steady state `q = Re(q̂·exp(i·ω·t))` and
//!
//! ```text
//! q̂ = Σ φ_r·(φ_rᵀ·F̂)/(ω_r² − ω² + 2·i·ζ·ω_r·ω),     F̂ = Σ b_j·k_j·a_j·exp(i·φ_j)
//! ```
//!
//! Linear: flanks are taken to stay in contact, which holds while the dynamic forces are below the mean ones.
//!
//! # Source
//! A. Kahraman, Load sharing characteristics of planetary transmissions, Mechanism and Machine Theory 29 (1994) 1151–1165, for the excitation; modal
//! superposition by any textbook of vibration.

use crate::model::{Model, Shape, SpringId};
use crate::modes::Modes;
use crate::units::{force, meters, rad_per_s, radians, within};
use crate::{Error, tolerance};
use nalgebra::Complex;
use uom::si::f64::{Angle, AngularVelocity, Force, Length};

/// A displacement in a spring that oscillates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Displacement {
    /// The spring.
    pub spring: SpringId,
    /// Amplitude `a`.
    pub amplitude: Length,
    /// Phase `φ`.
    pub phase: Angle,
}

/// A motion in steady state.
#[derive(Debug, Clone, PartialEq)]
pub struct Response {
    /// `q(t) = cosine·cos(ω·t) + sine·sin(ω·t)`, m.
    pub cosine: Shape,
    /// See [`Self::cosine`].
    pub sine: Shape,
    /// Amplitude of the force in each spring, in the order of [`Model::springs`].
    pub forces: Vec<Force>,
}

impl Model {
    /// The response to displacements in springs at a circular frequency, with a damping ratio of every mode, by superposition of the modes of this model.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a frequency that is not above 0 or a damping ratio outside 0 to 1, or neither damping nor distance from a mode;
    /// [`Error::NoSuchSpring`]; [`Error::Count`] for modes of another model.
    pub fn response(
        &self,
        modes: &Modes,
        displacements: &[Displacement],
        omega: AngularVelocity,
        damping_ratio: f64,
    ) -> Result<Response, Error> {
        let (lowest, omega_rad_s) = (f64::MIN_POSITIVE, rad_per_s(omega));
        let omega_rad_s = within(|| "frequency".into(), omega_rad_s, [lowest, f64::MAX], "rad/s")?;
        let zeta = within(|| "damping ratio".into(), damping_ratio, [0.0, 1.0], "")?;
        let mut drive = vec![Complex::new(0.0, 0.0); self.size()];
        let mut errors = vec![Complex::new(0.0, 0.0); self.springs.len()];
        for displacement in displacements {
            let spring = self.spring_at(displacement.spring)?;
            let limits = [f64::MIN, f64::MAX];
            let amplitude = within(|| "amplitude".into(), meters(displacement.amplitude), limits, "m")?;
            let phase = within(|| "phase".into(), radians(displacement.phase), limits, "rad")?;
            let error = Complex::from_polar(amplitude, phase);
            errors[displacement.spring.0] += error;
            for (place, factor) in &spring.elongation {
                drive[*place] += error * (spring.stiffness_n_per_m * factor);
            }
        }
        let mut q = vec![Complex::new(0.0, 0.0); self.size()];
        for mode in &modes.modes {
            let shape = self.coordinates_of(&mode.shape)?;
            let work: Complex<f64> = shape.iter().zip(&drive).map(|(part, force)| force * *part).sum();
            let omega_r = mode.omega2.sqrt();
            let denominator =
                Complex::new(mode.omega2 - omega_rad_s * omega_rad_s, 2.0 * zeta * omega_r * omega_rad_s);
            if denominator.norm() <= tolerance::RESONANT * omega_rad_s * omega_rad_s {
                let [low, high] = [f64::MIN_POSITIVE, 1.0];
                return Err(Error::OutOfRange {
                    field: "damping ratio at resonance".into(),
                    value: zeta,
                    low,
                    high,
                    unit: "",
                });
            }
            let factor = work / denominator;
            for (sum, part) in q.iter_mut().zip(&shape) {
                *sum += factor * *part;
            }
        }
        let forces = self.springs.iter().zip(&errors).map(|(spring, error)| {
            let bent: Complex<f64> =
                spring.elongation.iter().map(|(place, factor)| q[*place] * *factor).sum();
            force(spring.stiffness_n_per_m * (bent - error).norm())
        });
        Ok(Response {
            cosine: self.shape(|place| q[place].re),
            sine: self.shape(|place| -q[place].im),
            forces: forces.collect(),
        })
    }
}

//! Forced vibration: the response of a model to displacements in its springs, such as the transmission errors
//! of meshes.
//!
//! A spring `j` whose natural length changes by `e_j(t)` has the force `k_j·(δ_j − e_j)`, so:
//!
//! ```text
//! M·q̈ + C·q̇ + K·q = Σ b_j·k_j·e_j,     e_j = a_j·cos(ω·t + φ_j)
//! ```
//!
//! Damping is modal. With the mass-normalised modes `Φ` it is `C = M·Φ·diag(2·ζ·ω_r)·Φᵀ·M`, so that each mode
//! has the damping ratio `ζ`; zero modes have none. In steady state `q = Re(q̂·exp(i·ω·t))` and:
//!
//! ```text
//! q̂ = Σ φ_r·(φ_rᵀ·F̂)/(ω_r² − ω² + 2·i·ζ·ω_r·ω),     F̂ = Σ b_j·k_j·a_j·exp(i·φ_j)
//! ```
//!
//! While the axes turn with the carrier at `Ω` the matrices are those of that speed
//! ([`gyroscopic`](crate::gyroscopic)):
//!
//! ```text
//! M·q̈ + (C + Ω·G)·q̇ + (K − Ω²·K_Ω)·q = Σ b_j·k_j·e_j
//! ```
//!
//! The damping is that of the modes at rest. `G` couples the modes, so that with `q = Φ·y` a system of as
//! many equations is solved for each frequency:
//!
//! ```text
//! (Φᵀ·(K − Ω²·K_Ω)·Φ − ω² + i·ω·diag(2·ζ·ω_r) + i·ω·Ω·Φᵀ·G·Φ)·ŷ = Φᵀ·F̂
//! ```
//!
//! The model is linear: flanks are assumed to stay in contact, which holds while the dynamic forces are below
//! the mean ones.
//!
//! # Source
//! A. Kahraman, Load sharing characteristics of planetary transmissions, Mechanism and Machine Theory 29
//! (1994) 1151–1165, for the excitation; modal superposition by any textbook of vibration.

use crate::checks::within;
use crate::gyroscopic::Centripetal;
use crate::model::{Model, Shape, SpringId};
use crate::modes::Modes;
use crate::{Error, tolerance};
use epicyclic_units::Physical;
use nalgebra::{Complex, DMatrix, DVector};
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
    /// The response to displacements in springs at a circular frequency, with a damping ratio of every mode,
    /// by superposition of the modes of this model.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a frequency that is not above 0 or a damping ratio outside 0 to 1, or
    /// neither damping nor distance from a mode; [`Error::NoSuchSpring`]; [`Error::Count`] for modes of
    /// another model.
    pub fn response(
        &self,
        modes: &Modes,
        displacements: &[Displacement],
        omega: AngularVelocity,
        damping_ratio: f64,
    ) -> Result<Response, Error> {
        let driven = Driven::of(self, displacements, omega, damping_ratio)?;
        let (omega_rad_s, zeta) = (driven.omega_rad_s, driven.zeta);
        let mut q = vec![Complex::new(0.0, 0.0); self.size()];
        for mode in &modes.modes {
            let shape = self.coordinates_of(&mode.shape)?;
            let work: Complex<f64> = shape.iter().zip(&driven.drive).map(|(part, force)| force * *part).sum();
            let omega_r = mode.omega2.sqrt();
            let denominator =
                Complex::new(mode.omega2 - omega_rad_s * omega_rad_s, 2.0 * zeta * omega_r * omega_rad_s);
            if libm::hypot(denominator.re, denominator.im) <= tolerance::RESONANT * omega_rad_s * omega_rad_s
            {
                return Err(at_resonance(zeta));
            }
            let factor = work / denominator;
            for (sum, part) in q.iter_mut().zip(&shape) {
                *sum += factor * *part;
            }
        }
        Ok(driven.response(self, &q))
    }

    /// The response as [`Self::response`], in axes that turn with the carrier at a speed: with the gyroscopic
    /// effect and the centripetal stiffness of that speed. The modes are those at rest; they say the damping.
    ///
    /// # Errors
    /// As [`Self::response`], and [`Error::OutOfRange`] for a speed that is not finite,
    /// [`Error::AboveCritical`] where a planet's bearing cannot hold it, [`Error::Unbalanced`].
    pub fn turning_response(
        &self,
        modes: &Modes,
        displacements: &[Displacement],
        omega: AngularVelocity,
        damping_ratio: f64,
        frame_speed: AngularVelocity,
        centripetal: Centripetal,
    ) -> Result<Response, Error> {
        let driven = Driven::of(self, displacements, omega, damping_ratio)?;
        let (omega_rad_s, zeta, size) = (driven.omega_rad_s, driven.zeta, self.size());
        let limits = [f64::MIN, f64::MAX];
        let speed = within(|| "speed of the frame".into(), frame_speed.si(), limits, "rad/s")?;
        let stiffness = self.turning_stiffness(speed, centripetal)?;
        let mut basis = DMatrix::zeros(size, modes.modes.len());
        for (index, mode) in modes.modes.iter().enumerate() {
            basis.set_column(index, &DVector::from_vec(self.coordinates_of(&mode.shape)?));
        }
        let of_modes = |matrix: DMatrix<f64>| basis.tr_mul(&(matrix * &basis));
        let (stiffness, gyroscopic) = (of_modes(stiffness), of_modes(self.gyroscopic_kg()));
        let mut system = stiffness
            .zip_map(&gyroscopic, |stiff, turning| Complex::new(stiff, omega_rad_s * speed * turning));
        for (index, mode) in modes.modes.iter().enumerate() {
            let damping = 2.0 * zeta * mode.omega2.sqrt() * omega_rad_s;
            system[(index, index)] += Complex::new(-omega_rad_s * omega_rad_s, damping);
        }
        let basis = basis.map(|part| Complex::new(part, 0.0));
        let work = basis.tr_mul(&DVector::from_column_slice(&driven.drive));
        let most = work.norm() / (tolerance::RESONANT * omega_rad_s * omega_rad_s);
        let y = system.lu().solve(&work).filter(|y| y.norm() <= most).ok_or_else(|| at_resonance(zeta))?;
        let q = basis * y;
        Ok(driven.response(self, q.as_slice()))
    }
}

/// Forces and displacements that drive a model.
struct Driven {
    omega_rad_s: f64,
    zeta: f64,
    /// Forces at the coordinates, N.
    drive: Vec<Complex<f64>>,
    /// Displacements of all springs, m.
    errors: Vec<Complex<f64>>,
}

impl Driven {
    fn of(
        model: &Model,
        displacements: &[Displacement],
        omega: AngularVelocity,
        damping_ratio: f64,
    ) -> Result<Self, Error> {
        let (lowest, omega_rad_s) = (f64::MIN_POSITIVE, omega.si());
        let omega_rad_s = within(|| "frequency".into(), omega_rad_s, [lowest, f64::MAX], "rad/s")?;
        let zeta = within(|| "damping ratio".into(), damping_ratio, [0.0, 1.0], "")?;
        let mut drive = vec![Complex::new(0.0, 0.0); model.size()];
        let mut errors = vec![Complex::new(0.0, 0.0); model.springs.len()];
        for displacement in displacements {
            let spring = model.spring_at(displacement.spring)?;
            let limits = [f64::MIN, f64::MAX];
            let amplitude = within(|| "amplitude".into(), displacement.amplitude.si(), limits, "m")?;
            let phase = within(|| "phase".into(), displacement.phase.si(), limits, "rad")?;
            let error = Complex::new(amplitude * libm::cos(phase), amplitude * libm::sin(phase));
            errors[displacement.spring.0] += error;
            for (place, factor) in &spring.elongation {
                drive[*place] += error * (spring.stiffness_n_per_m * factor);
            }
        }
        Ok(Self { omega_rad_s, zeta, drive, errors })
    }

    /// The motion `q` with the forces of the springs in it.
    fn response(&self, model: &Model, q: &[Complex<f64>]) -> Response {
        let forces = model.springs.iter().zip(&self.errors).map(|(spring, error)| {
            let bent: Complex<f64> =
                spring.elongation.iter().map(|(place, factor)| q[*place] * *factor).sum();
            let stretched = bent - error;
            Force::from_si(spring.stiffness_n_per_m * libm::hypot(stretched.re, stretched.im))
        });
        Response {
            cosine: model.shape(|place| q[place].re),
            sine: model.shape(|place| -q[place].im),
            forces: forces.collect(),
        }
    }
}

/// Neither damping nor distance from a mode.
fn at_resonance(zeta: f64) -> Error {
    let [low, high] = [f64::MIN_POSITIVE, 1.0];
    Error::OutOfRange { field: "damping ratio at resonance".into(), value: zeta, low, high, unit: "" }
}

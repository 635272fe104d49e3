//! Modes while the carrier turns.
//!
//! In axes that turn with the carrier at `Ω` the absolute acceleration of a body has further parts. In
//! addition to `ẍ` and `ÿ` these are `−2·Ω·ẏ − Ω²·x` and `2·Ω·ẋ − Ω²·y`, so:
//!
//! ```text
//! M·q̈ + Ω·G·q̇ + (K − Ω²·K_Ω)·q = 0,     G = m·[0 −2; 2 0],     K_Ω = m·[1 0; 0 1]     in x, y of each body
//! ```
//!
//! Supports have equal stiffness in all directions, so they are the same in these axes. Rotations have no
//! such terms.
//!
//! A planet's bearing of stiffness `k_b` holds the planet on the circle `r = r_c/(1 − m_n·Ω²/k_b)` by the
//! force `m_n·Ω²·r`, which turns with the carrier. As the carrier rotates by `u_c/r_c`, the pin moves inwards
//! by `½·u_c²/r_c` against that force, so `K − Ω²·K_Ω` has also:
//!
//! ```text
//! Σ m_n·Ω²/(1 − m_n·Ω²/k_b)     at u_c
//! ```
//!
//! With this term a rotation of carrier and planets together (`η = u_c·r/r_c`) costs no energy, as must be.
//! The source leaves it out; then a set that is free to rotate has a negative stiffness and diverges at any
//! speed ([`Centripetal::AsPublished`]). Left out: the part of that force that meshes carry, and stiffness
//! from the mean torque. The forces on a carrier must balance, so that it turns about its centre.
//!
//! Let `A = M^-½·(K − Ω²·K_Ω)·M^-½ = Q·Λ·Qᵀ`, with modal velocities `v` and `s = Λ^½·Qᵀ·M^½·q`. The equations
//! of motion are then:
//!
//! ```text
//! ṡ = Λ^½·v,     v̇ = −Λ^½·s − Ω·Γ·v,     Γ = Qᵀ·M^-½·G·M^-½·Q
//! ```
//!
//! They have the form `ż = S·z` with `S` skew-symmetric, and `−i·S` is Hermitian: its eigenvalues are the
//! frequencies `±ω`, real without rounding. This needs `Λ ≥ 0`, speeds below the first critical one; there
//! every motion is stable.
//!
//! Frequencies are those in axes on the carrier. From the housing, motions that translate centres are seen at
//! `ω ± Ω`.
//!
//! # Source
//! J. Lin, R. G. Parker, Analytical characterization of the unique properties of planetary gear free
//! vibration, Journal of Vibration and Acoustics 121 (1999) 316–321, equations of motion.

use crate::checks::within;
use crate::classify::kind_of;
use crate::model::{Axis, BodyId, Inertia, Model, Orbiting, Shape};
use crate::modes::{Kind, frequency};
use crate::{Error, kernel, tolerance};
use epicyclic_units::Physical;
use nalgebra::{Complex, DMatrix};
use uom::si::f64::{AngularVelocity, Frequency};

/// Choice of the centripetal terms of a turning frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Centripetal {
    /// Terms with the stiffness of planet bearings that carry the centripetal force.
    #[default]
    WithBearingLoad,
    /// Terms without that stiffness, as in the source.
    AsPublished,
}

/// A mode in a turning frame: bodies move on ellipses.
#[derive(Debug, Clone, PartialEq)]
pub struct WhirlMode {
    /// Natural frequency in the turning frame, 0 of a zero mode.
    pub frequency: Frequency,
    /// Natural circular frequency in the turning frame.
    pub omega: AngularVelocity,
    /// Kind of motion of the central members; of equal frequencies, the kind of all their modes.
    pub kind: Kind,
    /// `q(t) = cosine·cos(ω·t) + sine·sin(ω·t)`; of a zero mode the displacement that stays.
    pub cosine: Shape,
    /// See [`Self::cosine`].
    pub sine: Shape,
}

impl Model {
    /// Calculates the modes in a frame that turns at a speed, in ascending order of frequency. The central
    /// members determine the kinds.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a speed that is not finite, [`Error::AboveCritical`], [`Error::Unbalanced`],
    /// [`Error::NoSuchBody`], and the errors of [`Model::modes`].
    pub fn whirl_modes(
        &self,
        frame_speed: AngularVelocity,
        centripetal: Centripetal,
        central: &[BodyId],
    ) -> Result<Vec<WhirlMode>, Error> {
        for body in central {
            self.inertia(*body)?;
        }
        let limits = [f64::MIN, f64::MAX];
        let speed_rad_s = within(|| "speed of the frame".into(), frame_speed.si(), limits, "rad/s")?;
        let size = self.size();
        if size == 0 {
            return Err(Error::NothingMoves);
        }
        let roots: Vec<f64> = self.masses_kg().into_iter().map(f64::sqrt).collect();
        let stiffness = self.turning_stiffness(speed_rad_s, centripetal)?;
        kernel::symmetric("stiffness", &stiffness)?;
        let scaled = DMatrix::from_fn(size, size, |row, column| {
            stiffness[(row, column)] / (roots[row] * roots[column])
        });
        let (mut lambda, basis) = kernel::hermitian(scaled)?;
        let largest = lambda.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        if lambda[0] < -tolerance::ZERO_MODE * largest {
            return Err(Error::AboveCritical { speed_rad_s, remaining: lambda[0] / largest });
        }
        let rigid = lambda.iter().filter(|value| **value <= tolerance::ZERO_MODE * largest).count();
        lambda.drain(..rigid);
        let gyroscopic = basis.tr_mul(&(self.scaled_gyroscopic() * &basis)) * speed_rad_s;
        let (omegas, velocities) = skew_modes(&lambda, rigid, &gyroscopic)?;
        let velocities = basis.map(|part| Complex::new(part, 0.0)) * velocities;
        let kinds = self.kinds(&omegas, &velocities, central);
        let modes = omegas.iter().zip(kinds).enumerate().map(|(index, (&omega, kind))| {
            let velocity = |place: usize| velocities[(place, index)] / roots[place];
            // q = v/(i·ω): the real part of q·exp(i·ω·t).
            let q = |place| {
                if omega > 0.0 { velocity(place) / Complex::new(0.0, omega) } else { velocity(place) }
            };
            WhirlMode {
                frequency: frequency(omega),
                omega: AngularVelocity::from_si(omega),
                kind,
                cosine: self.shape(|place| q(place).re),
                sine: self.shape(|place| -q(place).im),
            }
        });
        Ok(modes.collect())
    }

    /// `K − Ω²·K_Ω` with the load of the bearings, N/m.
    pub(crate) fn turning_stiffness(
        &self,
        speed_rad_s: f64,
        centripetal: Centripetal,
    ) -> Result<DMatrix<f64>, Error> {
        let mut stiffness = self.stiffness_n_per_m();
        let square = speed_rad_s * speed_rad_s;
        for body in &self.bodies {
            let [x, y, u] = body.coordinates;
            for place in [x, y].into_iter().flatten() {
                stiffness[(place, place)] -= square * body.masses_kg[0];
            }
            let (Some(place), Centripetal::WithBearingLoad) = (u, centripetal) else { continue };
            let loads = body.orbiting.iter().map(|planet| load_over_radius(planet, speed_rad_s));
            let loads = loads.collect::<Result<Vec<f64>, Error>>()?;
            let along = |part: fn(f64) -> f64| -> f64 {
                loads.iter().zip(&body.orbiting).map(|(load, planet)| load * part(planet.angle_rad)).sum()
            };
            let sum: f64 = loads.iter().sum();
            let at_rotation: f64 = loads
                .iter()
                .zip(&body.orbiting)
                .map(|(load, planet)| load * planet.lever * planet.lever)
                .sum();
            let resultant = libm::hypot(along(libm::cos), along(libm::sin));
            if resultant > tolerance::BALANCE * sum {
                return Err(Error::Unbalanced { carrier: body.name.clone(), resultant: resultant / sum });
            }
            stiffness[(place, place)] += at_rotation;
        }
        Ok(stiffness)
    }

    /// `M^-½·G·M^-½`.
    fn scaled_gyroscopic(&self) -> DMatrix<f64> {
        self.gyroscopic(|_| 2.0)
    }

    /// `G`, kg.
    pub(crate) fn gyroscopic_kg(&self) -> DMatrix<f64> {
        self.gyroscopic(|body| 2.0 * body.masses_kg[0])
    }

    /// Coupling matrix of a speed along `y` to `x`, and the other way round.
    fn gyroscopic(&self, part: impl Fn(&Inertia) -> f64) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(self.size, self.size);
        for body in &self.bodies {
            if let [Some(x), Some(y), _] = body.coordinates {
                matrix[(x, y)] = -part(body);
                matrix[(y, x)] = part(body);
            }
        }
        matrix
    }

    /// Kinds from mass-weighted velocities as columns.
    fn kinds(&self, omegas: &[f64], velocities: &DMatrix<Complex<f64>>, central: &[BodyId]) -> Vec<Kind> {
        let squares: Vec<f64> = omegas.iter().map(|omega| omega * omega).collect();
        let mut kinds = Vec::with_capacity(omegas.len());
        for range in kernel::groups(&squares) {
            let columns = velocities.columns_range(range.clone());
            let whole = columns.norm_squared();
            let share = |axes: &[Axis]| {
                let bodies = central.iter().map(|body| &self.bodies[body.0]);
                let places =
                    bodies.flat_map(|body| axes.iter().filter_map(|axis| body.coordinates[*axis as usize]));
                places.map(|place| columns.row(place).norm_squared()).sum::<f64>() / whole
            };
            kinds.extend(range.map(|_| kind_of(share(&[Axis::X, Axis::Y]), share(&[Axis::Rotation]))));
        }
        kinds
    }
}

/// The force on a planet's bearing over the radius of the carrier, `m·Ω²/(1 − m·Ω²/k_b)`, N/m.
fn load_over_radius(planet: &Orbiting, speed_rad_s: f64) -> Result<f64, Error> {
    let centripetal = planet.mass_kg * speed_rad_s * speed_rad_s;
    let remaining = 1.0 - centripetal / planet.bearing_n_per_m;
    if remaining > 0.0 {
        Ok(centripetal / remaining)
    } else {
        Err(Error::AboveCritical { speed_rad_s, remaining })
    }
}

/// Frequencies, ascending, and modal velocities of `S = [0 Λ^½; −Λ^½ −Γ]`, whose first `rigid` eigenvalues
/// are left out of `lambda`.
///
/// Each frequency above 0 is an eigenvalue of `−i·S` of either sign; what the positive ones lack of the size
/// are zero modes. These have the directions of `Λ = 0`, in which the system stays where it is put.
fn skew_modes(
    lambda: &[f64],
    rigid: usize,
    gyroscopic: &DMatrix<f64>,
) -> Result<(Vec<f64>, DMatrix<Complex<f64>>), Error> {
    let (strained, size) = (lambda.len(), gyroscopic.nrows());
    let mut matrix = DMatrix::<Complex<f64>>::zeros(strained + size, strained + size);
    for (index, value) in lambda.iter().enumerate() {
        let (row, column, root) = (index, strained + rigid + index, value.sqrt());
        matrix[(row, column)] = Complex::new(0.0, -root);
        matrix[(column, row)] = Complex::new(0.0, root);
    }
    for row in 0..size {
        for column in 0..size {
            // The mean of both triangles is skew without rounding.
            let part = 0.5 * (gyroscopic[(row, column)] - gyroscopic[(column, row)]);
            matrix[(strained + row, strained + column)] = Complex::new(0.0, part);
        }
    }
    let (values, vectors) = kernel::hermitian(matrix)?;
    let largest = values.last().copied().unwrap_or(0.0).abs();
    let least = tolerance::ZERO_MODE.sqrt() * largest;
    let count = values.iter().filter(|value| **value > least).count();
    let (zeros, first) = (size - count, values.len() - count);
    let omegas = (0..size).map(|index| if index < zeros { 0.0 } else { values[first + index - zeros] });
    let mut velocities = DMatrix::zeros(size, size);
    for index in 0..zeros {
        velocities[(index, index)] = Complex::new(1.0, 0.0);
    }
    velocities.columns_range_mut(zeros..).copy_from(&vectors.view((strained, first), (size, count)));
    Ok((omegas.collect(), velocities))
}

//! Modal energy of each body and spring, and the sensitivity of a frequency to a change of stiffness or mass.
//!
//! A mass-normalised mode `φ` of `ω` has a mean kinetic energy `T = Σ m_i·φ_i²` and a mean strain energy
//! `V = Σ k_j·δ_j²/ω²`. In these units both are of size 1. Over a subspace of `d` modes the shares are means
//! over any basis, which do not depend on it.
//!
//! From `φᵀ·(K − ω²·M)·φ = 0`, as `φ` is stationary:
//!
//! ```text
//! ∂ω²/∂k_j = δ_j²,   ∂ω²/∂m_i = −ω²·φ_i²     so     (k/ω)·∂ω/∂k = ½·V_j,   (m/ω)·∂ω/∂m = −½·T_i
//! ```
//!
//! A change splits a frequency of `d` modes; the derivatives of its parts are the eigenvalues of the same
//! form over the subspace, `½·Σ k_j·δ_j(φ_a)·δ_j(φ_b)/ω²`.

use crate::model::{Axis, BodyId, Model, SpringId};
use crate::modes::Group;
use crate::{Error, kernel};
use nalgebra::DMatrix;

/// Shares of a body in the kinetic energy of a group of modes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KineticShare {
    /// The body.
    pub body: BodyId,
    /// Share of the body's translation.
    pub translation: f64,
    /// Share of the body's rotation.
    pub rotation: f64,
}

/// Share of a spring in the strain energy of a group of modes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StrainShare {
    /// The spring.
    pub spring: SpringId,
    /// Share of the spring.
    pub share: f64,
}

/// Distribution of the energy of a group of modes.
#[derive(Debug, Clone, PartialEq)]
pub struct ModalEnergy {
    /// Shares of the bodies in the kinetic energy; they add up to 1.
    pub kinetic: Vec<KineticShare>,
    /// Shares of the springs in the strain energy; they add up to 1. For zero modes, which deform no spring,
    /// all are 0.
    pub strain: Vec<StrainShare>,
}

impl ModalEnergy {
    /// Share of a body in the kinetic energy, by its translation and rotation together.
    #[must_use]
    pub fn kinetic_of(&self, body: BodyId) -> f64 {
        let own = self.kinetic.iter().filter(|share| share.body == body);
        own.map(|share| share.translation + share.rotation).sum()
    }

    /// Share of some springs in the strain energy.
    #[must_use]
    pub fn strain_of(&self, springs: &[SpringId]) -> f64 {
        let own = self.strain.iter().filter(|share| springs.contains(&share.spring));
        own.map(|share| share.share).sum()
    }
}

/// Kind of inertia of a body that changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum InertiaKind {
    /// Mass of the body.
    Mass,
    /// Moment of inertia of the body.
    Rotary,
}

impl Model {
    /// Modal energy of each body and spring.
    ///
    /// # Errors
    /// [`Error::Count`] for a group of another model.
    pub fn modal_energy(&self, group: &Group) -> Result<ModalEnergy, Error> {
        let q = self.basis(group)?;
        let count = q.len() as f64;
        let kinetic = self.bodies.iter().enumerate().map(|(index, body)| {
            let of = |axis: Axis| {
                let Some(place) = body.coordinates[axis as usize] else { return 0.0 };
                body.masses_kg[axis as usize] * q.iter().map(|q| q[place] * q[place]).sum::<f64>() / count
            };
            KineticShare {
                body: BodyId(index),
                translation: of(Axis::X) + of(Axis::Y),
                rotation: of(Axis::Rotation),
            }
        });
        let strain = self.springs().map(|spring| {
            let share =
                if group.is_zero() { 0.0 } else { self.strain_form(group, &q, &[spring])?.trace() / count };
            Ok(StrainShare { spring, share })
        });
        Ok(ModalEnergy { kinetic: kinetic.collect(), strain: strain.collect::<Result<_, Error>>()? })
    }

    /// Relative change of a frequency over that of the stiffness of these springs together, `(k/ω)·∂ω/∂k`:
    /// one value for each mode of the group, ascending. 0 for zero modes, which stay zero modes.
    ///
    /// # Errors
    /// [`Error::NoSuchSpring`]; [`Error::Count`] for a group of another model.
    pub fn stiffness_sensitivity(&self, group: &Group, springs: &[SpringId]) -> Result<Vec<f64>, Error> {
        let q = self.basis(group)?;
        let form = self.strain_form(group, &q, springs)?;
        Ok(kernel::hermitian(form * 0.5)?.0)
    }

    /// Relative change of a frequency over that of the mass or inertia of these bodies together,
    /// `(m/ω)·∂ω/∂m`: one value for each mode of the group, ascending. 0 for zero modes, which stay zero
    /// modes.
    ///
    /// # Errors
    /// [`Error::NoSuchBody`]; [`Error::Count`] for a group of another model.
    pub fn inertia_sensitivity(
        &self,
        group: &Group,
        bodies: &[BodyId],
        kind: InertiaKind,
    ) -> Result<Vec<f64>, Error> {
        let q = self.basis(group)?;
        if group.is_zero() {
            return Ok(vec![0.0; q.len()]);
        }
        let axes: &[Axis] = match kind {
            InertiaKind::Mass => &[Axis::X, Axis::Y],
            InertiaKind::Rotary => &[Axis::Rotation],
        };
        let mut rows = Vec::new();
        for &body in bodies {
            let inertia = self.inertia(body)?;
            for &axis in axes {
                let Some(place) = inertia.coordinates[axis as usize] else { continue };
                let row = q.iter().map(|q| q[place]).collect();
                rows.push((-0.5 * inertia.masses_kg[axis as usize], row));
            }
        }
        Ok(kernel::hermitian(kernel::gram(q.len(), rows.into_iter()))?.0)
    }

    /// Coordinates of the group's shapes.
    fn basis(&self, group: &Group) -> Result<Vec<Vec<f64>>, Error> {
        group.shapes.iter().map(|shape| self.coordinates_of(shape)).collect()
    }

    /// `Σ k_j·δ_j(φ_a)·δ_j(φ_b)/ω²`; 0 for zero modes.
    fn strain_form(
        &self,
        group: &Group,
        q: &[Vec<f64>],
        springs: &[SpringId],
    ) -> Result<DMatrix<f64>, Error> {
        let mut rows = Vec::with_capacity(springs.len());
        for &spring in springs {
            let spring = self.spring_at(spring)?;
            let row = q
                .iter()
                .map(|q| spring.elongation.iter().map(|(place, factor)| factor * q[*place]).sum())
                .collect();
            let weight = if group.is_zero() { 0.0 } else { spring.stiffness_n_per_m / group.omega2 };
            rows.push((weight, row));
        }
        Ok(kernel::gram(q.len(), rows.into_iter()))
    }
}

//! The kind of a mode, decided on the subspace of its frequency.
//!
//! Let `φ_1 … φ_d` be mass-normalised modes of one frequency. In a motion `Σ c_a·φ_a` the central members'
//! kinetic energy of translation and that of rotation are quadratic forms of `c`, with the matrices:
//!
//! ```text
//! T_ab = Σ m·(x_a·x_b + y_a·y_b),     R_ab = Σ (I/r²)·u_a·u_b        over the central members
//! ```
//!
//! Both are invariant to the choice of the basis. `R` gives the directions in which central members rotate,
//! `T` those in which they translate, and the directions that neither has leave them at rest. In a cyclically
//! symmetric set no direction has both. A frequency that modes of two kinds share by chance is split into
//! them; where a direction has both, the set is not symmetric, and the whole group is [`Kind::Mixed`].

use crate::model::{Axis, BodyId, Model, Shape};
use crate::modes::{Group, Kind, Mode, Modes};
use crate::{Error, kernel, tolerance};
use nalgebra::{DMatrix, DVector};

impl Model {
    /// Modes in groups by frequency and by what these central members do, in ascending order of frequency.
    ///
    /// Decided on the subspace of each frequency. Where modes of several kinds have one frequency, the
    /// subspace is split.
    ///
    /// # Errors
    /// As [`Self::modes`], and [`Error::NoSuchBody`].
    pub fn groups(&self, central: &[BodyId]) -> Result<Vec<Group>, Error> {
        self.group(&self.modes()?, central)
    }

    /// Groups modes of this model, as [`Self::groups`] does.
    ///
    /// # Errors
    /// [`Error::NoSuchBody`]; [`Error::Count`] for modes of another model.
    pub fn group(&self, modes: &Modes, central: &[BodyId]) -> Result<Vec<Group>, Error> {
        for body in central {
            self.inertia(*body)?;
        }
        let mut groups = Vec::with_capacity(modes.equal.len());
        for range in &modes.equal {
            groups.extend(split(self, &modes.modes[range.clone()], central)?);
        }
        Ok(groups)
    }
}

/// Modes of equal frequency by kind.
pub(crate) fn split(model: &Model, modes: &[Mode], central: &[BodyId]) -> Result<Vec<Group>, Error> {
    let whole = |kind| {
        let mean = modes.iter().map(|mode| mode.omega2).sum::<f64>() / modes.len() as f64;
        vec![Group::new(kind, mean, modes.iter().map(|mode| mode.shape.clone()).collect())]
    };
    let translation = form(model, modes, central, &[Axis::X, Axis::Y])?;
    let rotation = form(model, modes, central, &[Axis::Rotation])?;
    if modes.len() == 1 {
        return Ok(whole(kind_of(translation[(0, 0)], rotation[(0, 0)])));
    }
    let (rotating, others) = directions(rotation)?;
    if (rotating.transpose() * &translation * &rotating).trace() > tolerance::KIND {
        return Ok(whole(Kind::Mixed));
    }
    let (translating, resting) = directions(others.transpose() * &translation * &others)?;
    let parts = [
        (Kind::Rotational, rotating),
        (Kind::Translational, &others * translating),
        (Kind::Planet, &others * resting),
    ];
    if let Some((kind, _)) = parts.iter().find(|(_, basis)| basis.ncols() == modes.len()) {
        return Ok(whole(*kind));
    }
    let parts = parts.iter().filter(|(_, basis)| basis.ncols() > 0);
    Ok(parts.map(|(kind, basis)| turned(*kind, modes, basis)).collect())
}

/// The kind of a single mode from the central members' kinetic energy, over the mode's.
pub(crate) fn kind_of(translation: f64, rotation: f64) -> Kind {
    match (translation > tolerance::KIND, rotation > tolerance::KIND) {
        (false, true) => Kind::Rotational,
        (true, false) => Kind::Translational,
        (false, false) => Kind::Planet,
        (true, true) => Kind::Mixed,
    }
}

/// Twice the central members' kinetic energy along some axes as a quadratic form.
fn form(model: &Model, modes: &[Mode], central: &[BodyId], axes: &[Axis]) -> Result<DMatrix<f64>, Error> {
    let mut rows = Vec::with_capacity(central.len() * axes.len());
    for &body in central {
        let inertia = model.inertia(body)?;
        for &axis in axes {
            let mut row = Vec::with_capacity(modes.len());
            for mode in modes {
                let [count, needed] = [mode.shape.bodies.len(), model.bodies.len()];
                let shape = mode.shape.of(body).filter(|_| count == needed);
                row.push(
                    shape.ok_or(Error::Count { of: "displacements of bodies", count, needed })?
                        [axis as usize],
                );
            }
            rows.push((inertia.masses_kg[axis as usize], row));
        }
    }
    Ok(kernel::gram(modes.len(), rows.into_iter()))
}

/// Orthonormal directions in which a form has energy, and those in which it has none.
fn directions(form: DMatrix<f64>) -> Result<(DMatrix<f64>, DMatrix<f64>), Error> {
    if form.is_empty() {
        return Ok((form.clone(), form));
    }
    let (values, vectors) = kernel::hermitian(form)?;
    let resting = values.iter().filter(|value| **value <= tolerance::KIND).count();
    Ok((vectors.columns_range(resting..).into_owned(), vectors.columns_range(..resting).into_owned()))
}

/// The modes in another basis.
fn turned(kind: Kind, modes: &[Mode], basis: &DMatrix<f64>) -> Group {
    let shapes = basis.column_iter().map(|direction| {
        let mut bodies = vec![[0.0; 3]; modes[0].shape.bodies.len()];
        for (mode, factor) in modes.iter().zip(direction.iter()) {
            for (sum, part) in bodies.iter_mut().zip(&mode.shape.bodies) {
                for (sum, part) in sum.iter_mut().zip(part) {
                    *sum += factor * part;
                }
            }
        }
        Shape { bodies }
    });
    let omega2 = DVector::from_iterator(modes.len(), modes.iter().map(|mode| mode.omega2));
    let weights = basis.map(|part| part * part).tr_mul(&omega2);
    Group::new(kind, weights.mean(), shapes.collect())
}

//! Natural frequencies and modes of a model, in groups of equal frequency.

use crate::model::{Model, Shape};
use crate::{Error, kernel};
use epicyclic_units::Physical;
use std::ops::Range;
use uom::si::f64::{AngularVelocity, Frequency};

/// A mode: a motion in which every body oscillates with one frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// Natural frequency, 0 of a zero mode.
    pub frequency: Frequency,
    /// Natural circular frequency `ω`.
    pub omega: AngularVelocity,
    /// Mass-normalised shape, `φᵀ·M·φ = 1`. Of equal frequencies any basis of their modes is as good: only
    /// the group means something.
    pub shape: Shape,
    /// `|L⁻¹·(K − ω²·M)·φ|/ω²_max` with `M = L·Lᵀ`: how far the mode is from being one.
    pub residual: f64,
    pub(crate) omega2: f64,
}

/// Modes of a model in ascending order of frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct Modes {
    /// The modes, as many as the model has free coordinates.
    pub modes: Vec<Mode>,
    /// Ranges of modes of equal frequency: within 1e-9 of `ω²`, or 1e-13 of the largest `ω²`.
    pub equal: Vec<Range<usize>>,
}

/// Kind of a mode by the motion of the central members.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "ModeKind"))]
pub enum Kind {
    /// Central members rotate and do not translate.
    Rotational,
    /// Central members translate and do not rotate.
    Translational,
    /// Central members are at rest.
    Planet,
    /// Central members rotate and translate: the set is not cyclically symmetric.
    Mixed,
}

/// Modes of one kind and one frequency: a subspace, spanned by its shapes.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// Kind of motion of the central members.
    pub kind: Kind,
    /// Natural frequency, 0 of zero modes.
    pub frequency: Frequency,
    /// Natural circular frequency `ω`.
    pub omega: AngularVelocity,
    /// A mass-normalised basis; as many shapes as the multiplicity.
    pub shapes: Vec<Shape>,
    pub(crate) omega2: f64,
}

impl Group {
    /// Number of modes with this frequency and kind.
    #[must_use]
    pub fn multiplicity(&self) -> usize {
        self.shapes.len()
    }

    /// Whether the modes move the model without deforming a spring.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.omega2 == 0.0
    }

    pub(crate) fn new(kind: Kind, omega2: f64, shapes: Vec<Shape>) -> Self {
        let omega = omega2.sqrt();
        Self { kind, frequency: frequency(omega), omega: AngularVelocity::from_si(omega), shapes, omega2 }
    }
}

impl Model {
    /// Natural frequencies and modes.
    ///
    /// # Errors
    /// [`Error::NothingMoves`] without a free coordinate, [`Error::NotSymmetric`] where numbers overflow,
    /// [`Error::NotConverged`].
    pub fn modes(&self) -> Result<Modes, Error> {
        let mass = nalgebra::DMatrix::from_diagonal(&self.masses_kg().into());
        let eigen = kernel::solve(&self.stiffness_n_per_m(), &mass)?;
        let equal = kernel::groups(&eigen.omega2);
        let modes =
            eigen.omega2.iter().zip(eigen.residuals).enumerate().map(|(index, (&omega2, residual))| {
                let omega = omega2.sqrt();
                let shape = self.shape(|place| eigen.vectors[(place, index)]);
                Mode {
                    frequency: frequency(omega),
                    omega: AngularVelocity::from_si(omega),
                    shape,
                    residual,
                    omega2,
                }
            });
        Ok(Modes { modes: modes.collect(), equal })
    }
}

/// The frequency of a circular frequency, Hz for rad/s.
pub(crate) fn frequency(omega_rad_s: f64) -> Frequency {
    Frequency::from_si(omega_rad_s / std::f64::consts::TAU)
}

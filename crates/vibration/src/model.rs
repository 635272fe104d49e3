//! A vibrating system: bodies that move in a plane, and springs between them.
//!
//! A body has up to three coordinates: the displacement `x`, `y` of its centre and `u = r·θ`, its rotation
//! times a radius of the body. A spring `j` is a stiffness `k_j` and an elongation that is linear in the
//! coordinates, `δ_j = b_jᵀ·q`. Then
//!
//! ```text
//! T = ½·q̇ᵀ·M·q̇,   M = diag(m, m, I/r²),      V = ½·Σ k_j·δ_j²,   K = Σ k_j·b_j·b_jᵀ
//! ```
//!
//! so `K` is symmetric and positive semidefinite whatever the springs are. All bodies are rigid; gaps,
//! friction and the change of stiffness over time are left out.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `x`, `y` | displacements of the centre in the plane of rotation, right-handed | m |
//! | `u` | `r·θ`, positive with `θ` from `x` to `y` | m |
//! | `m`, `I`, `r` | mass, inertia about the centre, radius of the rotation coordinate | kg, kg·m², m |
//! | `k`, `δ` | stiffness, elongation | N/m, m |

use crate::checks::{not_negative, positive};
use crate::{Error, Stiffness, TorsionalStiffness};
use epicyclic_units::Physical;
use nalgebra::DMatrix;
use uom::si::f64::{Length, Mass, MomentOfInertia};

/// A rigid body: mass, inertia, and the radius that makes its rotation a length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    /// Mass.
    pub mass: Mass,
    /// Inertia about its centre.
    pub inertia: MomentOfInertia,
    /// Radius `r` of the coordinate `u = r·θ`.
    pub radius: Length,
}

impl Body {
    /// A body from `I/r²`, as sources of vibration give inertias.
    #[must_use]
    pub fn with_rotary_mass(mass: Mass, rotary_mass: Mass, radius: Length) -> Self {
        let r = radius.si();
        Self { mass, inertia: MomentOfInertia::from_si(rotary_mass.si() * r * r), radius }
    }
}

/// Freedom of motion of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Freedom {
    /// The body moves in the plane and rotates.
    #[default]
    Planar,
    /// The body rotates about its centre, which is at rest.
    Rotation,
    /// The body moves in the plane and does not rotate.
    Translation,
    /// The body is held.
    Held,
}

/// A coordinate of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Axis {
    /// Displacement `x`.
    X,
    /// Displacement `y`.
    Y,
    /// Rotation as `u = r·θ`.
    Rotation,
}

/// Number of a body in its model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct BodyId(pub(crate) usize);

/// Number of a spring in its model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct SpringId(pub(crate) usize);

/// A part of an elongation: of this body along this axis, with this factor.
pub type Term = (BodyId, Axis, f64);

/// Displacements `[x, y, u]` of each body, in the order in which the bodies were added; 0 where a coordinate
/// is held.
///
/// Of a mode they are mass-normalised (unit kg^-½), of a response in m.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Shape {
    pub(crate) bodies: Vec<[f64; 3]>,
}

impl Shape {
    /// Displacements `[x, y, u]` of a body; none of a body of another model.
    #[must_use]
    pub fn of(&self, body: BodyId) -> Option<[f64; 3]> {
        self.bodies.get(body.0).copied()
    }
}

#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Inertia {
    pub(crate) name: String,
    /// Masses of `x`, `y`, `u`, kg.
    pub(crate) masses_kg: [f64; 3],
    pub(crate) radius_m: f64,
    /// Places of the coordinates in `q`; none where held.
    pub(crate) coordinates: [Option<usize>; 3],
    /// Planets that the body carries on its radius.
    pub(crate) orbiting: Vec<Orbiting>,
}

/// A planet on its carrier.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Orbiting {
    pub(crate) mass_kg: f64,
    pub(crate) bearing_n_per_m: f64,
    pub(crate) angle_rad: f64,
    /// Displacement of the pin over the carrier's coordinate `u`: the radius of the pin over that of the
    /// coordinate.
    pub(crate) lever: f64,
}

#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Spring {
    pub(crate) name: String,
    pub(crate) stiffness_n_per_m: f64,
    /// Places in `q` with their factors.
    pub(crate) elongation: Vec<(usize, f64)>,
}

/// Bodies and springs. Sets of gears add theirs to it ([`PlanetarySet`](crate::PlanetarySet)), shafts join
/// bodies.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Model {
    pub(crate) bodies: Vec<Inertia>,
    pub(crate) springs: Vec<Spring>,
    pub(crate) size: usize,
}

impl Model {
    /// A model of nothing.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a body.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for a radius that is not above 0, and for such a mass or inertia of a
    /// coordinate that is free.
    pub fn body(&mut self, name: &str, body: &Body, freedom: Freedom) -> Result<BodyId, Error> {
        let free = match freedom {
            Freedom::Planar => [true; 3],
            Freedom::Rotation => [false, false, true],
            Freedom::Translation => [true, true, false],
            Freedom::Held => [false; 3],
        };
        let radius = positive(|| format!("radius of {name}"), body.radius.si(), "m")?;
        let mut mass = body.mass.si();
        if free[0] {
            mass = positive(|| format!("mass of {name}"), mass, "kg")?;
        }
        let mut rotary = body.inertia.si() / (radius * radius);
        if free[2] {
            positive(|| format!("inertia of {name}"), body.inertia.si(), "kg·m²")?;
            rotary = positive(|| format!("I/r² of {name}"), rotary, "kg")?;
        }
        let coordinates = free.map(|free| {
            free.then(|| {
                self.size += 1;
                self.size - 1
            })
        });
        let name = name.to_owned();
        let masses_kg = [mass, mass, rotary];
        self.bodies.push(Inertia { name, masses_kg, radius_m: radius, coordinates, orbiting: Vec::new() });
        Ok(BodyId(self.bodies.len() - 1))
    }

    /// Adds a spring with the elongation `δ = Σ factor·coordinate`. Parts of held coordinates are 0.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for the stiffness, [`Error::OutOfRange`] for a factor that is not finite,
    /// [`Error::NoSuchBody`].
    pub fn spring(
        &mut self,
        name: &str,
        stiffness: Stiffness,
        elongation: &[Term],
    ) -> Result<SpringId, Error> {
        let stiffness_n_per_m = positive(|| format!("stiffness of {name}"), stiffness.si(), "N/m")?;
        let mut terms: Vec<(usize, f64)> = Vec::with_capacity(elongation.len());
        for &(body, axis, factor) in elongation {
            if !factor.is_finite() {
                let [low, high] = [f64::MIN, f64::MAX];
                let field = format!("elongation of {name}");
                return Err(Error::OutOfRange { field, value: factor, low, high, unit: "m/m" });
            }
            let Some(place) = self.inertia(body)?.coordinates[axis as usize] else { continue };
            // One coordinate may occur twice, when two members of a set are the same body.
            match terms.iter_mut().find(|term| term.0 == place) {
                Some(term) => term.1 += factor,
                None => terms.push((place, factor)),
            }
        }
        self.springs.push(Spring { name: name.to_owned(), stiffness_n_per_m, elongation: terms });
        Ok(SpringId(self.springs.len() - 1))
    }

    /// Joins a body to the ground along `x` and `y` and against rotation; a stiffness of 0 adds no spring.
    ///
    /// # Errors
    /// [`Error::Negative`], [`Error::NoSuchBody`].
    pub fn support(&mut self, body: BodyId, support: Support) -> Result<Vec<SpringId>, Error> {
        let name = self.inertia(body)?.name.clone();
        let mut springs = Vec::new();
        let parts = [
            (Axis::X, support.radial, "support along x"),
            (Axis::Y, support.radial, "support along y"),
            (Axis::Rotation, support.tangential, "torsional support"),
        ];
        for (axis, stiffness, of) in parts {
            let name = format!("{of} of {name}");
            if not_negative(|| format!("stiffness of {name}"), stiffness.si(), "N/m")? > 0.0 {
                springs.push(self.spring(&name, stiffness, &[(body, axis, 1.0)])?);
            }
        }
        Ok(springs)
    }

    /// Joins two bodies by a shaft: torsionally, `δ = u_1 − u_2·r_1/r_2` with the stiffness `k_t/r_1²`, and
    /// laterally in `x` and `y`. A stiffness of 0 adds no spring.
    ///
    /// A shaft without mass; lateral springs join centres, tilting is left out.
    ///
    /// # Errors
    /// [`Error::Negative`], [`Error::NoSuchBody`].
    pub fn shaft(
        &mut self,
        name: &str,
        [first, second]: [BodyId; 2],
        torsional: TorsionalStiffness,
        lateral: Stiffness,
    ) -> Result<Vec<SpringId>, Error> {
        let [r_1, r_2] = [self.inertia(first)?.radius_m, self.inertia(second)?.radius_m];
        let torsional = not_negative(|| format!("torsional stiffness of {name}"), torsional.si(), "N·m/rad")?;
        let bending = not_negative(|| format!("lateral stiffness of {name}"), lateral.si(), "N/m")?;
        let mut springs = Vec::new();
        if torsional > 0.0 {
            let terms = [(first, Axis::Rotation, 1.0), (second, Axis::Rotation, -r_1 / r_2)];
            // The coordinate is a length, u = r·θ, so the torsional stiffness is one over r_1².
            let stiffness = crate::newtons_per_meter(torsional / (r_1 * r_1));
            springs.push(self.spring(&format!("torsion of {name}"), stiffness, &terms)?);
        }
        if bending > 0.0 {
            for (axis, letter) in [(Axis::X, 'x'), (Axis::Y, 'y')] {
                let terms = [(first, axis, 1.0), (second, axis, -1.0)];
                springs.push(self.spring(&format!("bending of {name} along {letter}"), lateral, &terms)?);
            }
        }
        Ok(springs)
    }

    /// Number of free coordinates.
    #[must_use]
    pub fn size(&self) -> usize {
        self.size
    }

    /// Every body, in the order in which they were added.
    pub fn bodies(&self) -> impl Iterator<Item = BodyId> + use<> {
        (0..self.bodies.len()).map(BodyId)
    }

    /// Every spring, in the order in which they were added.
    pub fn springs(&self) -> impl Iterator<Item = SpringId> + use<> {
        (0..self.springs.len()).map(SpringId)
    }

    /// Name of a body; none of a body of another model.
    #[must_use]
    pub fn body_name(&self, body: BodyId) -> Option<&str> {
        self.bodies.get(body.0).map(|body| body.name.as_str())
    }

    /// Radius of the coordinate `u` of a body; none of a body of another model.
    #[must_use]
    pub fn body_radius(&self, body: BodyId) -> Option<Length> {
        self.bodies.get(body.0).map(|body| Length::from_si(body.radius_m))
    }

    /// Name of a spring; none of a spring of another model.
    #[must_use]
    pub fn spring_name(&self, spring: SpringId) -> Option<&str> {
        self.springs.get(spring.0).map(|spring| spring.name.as_str())
    }

    /// Elongation of a spring by a shape, in the shape's unit.
    ///
    /// # Errors
    /// [`Error::NoSuchSpring`]; [`Error::Count`] for a shape of another model.
    pub fn elongation(&self, spring: SpringId, shape: &Shape) -> Result<f64, Error> {
        let q = self.coordinates_of(shape)?;
        Ok(self.spring_at(spring)?.elongation.iter().map(|(place, factor)| factor * q[*place]).sum())
    }

    pub(crate) fn inertia(&self, body: BodyId) -> Result<&Inertia, Error> {
        self.bodies.get(body.0).ok_or(Error::NoSuchBody { index: body.0, count: self.bodies.len() })
    }

    pub(crate) fn spring_at(&self, spring: SpringId) -> Result<&Spring, Error> {
        let count = self.springs.len();
        self.springs.get(spring.0).ok_or(Error::NoSuchSpring { index: spring.0, count })
    }

    /// The coordinates `q` of a shape.
    pub(crate) fn coordinates_of(&self, shape: &Shape) -> Result<Vec<f64>, Error> {
        if shape.bodies.len() != self.bodies.len() {
            let [count, needed] = [shape.bodies.len(), self.bodies.len()];
            return Err(Error::Count { of: "displacements of bodies", count, needed });
        }
        let mut q = vec![0.0; self.size];
        for (body, values) in self.bodies.iter().zip(&shape.bodies) {
            for (place, value) in body.coordinates.iter().zip(values) {
                if let Some(place) = place {
                    q[*place] = *value;
                }
            }
        }
        Ok(q)
    }

    /// The shape of coordinates `q`.
    pub(crate) fn shape(&self, q: impl Fn(usize) -> f64) -> Shape {
        let bodies = self.bodies.iter().map(|body| body.coordinates.map(|place| place.map_or(0.0, &q)));
        Shape { bodies: bodies.collect() }
    }

    /// The diagonal of `M`, kg, in the order of [`Self::stiffness_matrix_n_per_m`]; `M` has nothing beside
    /// it.
    #[must_use]
    pub fn mass_matrix_diagonal_kg(&self) -> Vec<f64> {
        self.masses_kg()
    }

    /// Masses of the coordinates, kg: the diagonal of `M`.
    pub(crate) fn masses_kg(&self) -> Vec<f64> {
        let mut masses = vec![0.0; self.size];
        for body in &self.bodies {
            for (place, mass) in body.coordinates.iter().zip(body.masses_kg) {
                if let Some(place) = place {
                    masses[*place] = mass;
                }
            }
        }
        masses
    }

    /// `K`, N/m, by rows: coordinates in the order of bodies, `x`, `y`, `u` of each, without held ones.
    #[must_use]
    pub fn stiffness_matrix_n_per_m(&self) -> Vec<Vec<f64>> {
        let matrix = self.stiffness_n_per_m();
        matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
    }

    /// `K`, N/m.
    pub(crate) fn stiffness_n_per_m(&self) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(self.size, self.size);
        for spring in &self.springs {
            for &(row, of_row) in &spring.elongation {
                for &(column, of_column) in &spring.elongation {
                    matrix[(row, column)] += spring.stiffness_n_per_m * (of_row * of_column);
                }
            }
        }
        matrix
    }
}

/// Springs between a central member and the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Support {
    /// Stiffness along `x` and along `y`.
    pub radial: Stiffness,
    /// Stiffness against `u`: the torsional stiffness over `r²` ([`Support::tangential_of`]).
    pub tangential: Stiffness,
}

impl Default for Support {
    fn default() -> Self {
        Self { radial: crate::newtons_per_meter(0.0), tangential: crate::newtons_per_meter(0.0) }
    }
}

impl Support {
    /// `k_t/r²`: a torsional stiffness as one along `u = r·θ`.
    #[must_use]
    pub fn tangential_of(torsional: TorsionalStiffness, radius: Length) -> Stiffness {
        crate::newtons_per_meter(torsional.si() / (radius.si() * radius.si()))
    }
}

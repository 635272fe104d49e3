//! A simple planetary set as bodies and springs: planar (Lin, Parker) and torsional (Kahraman).
//!
//! # Planar model
//!
//! Sun, ring, carrier and planets have `x`, `y`, `u` each, in axes that turn with the carrier. `ψ_n` is the
//! angle of planet `n`. `u` is the rotation times the base radius of a gear, and for the carrier the rotation
//! times the radius `r_c` of the planets' circle. Flanks stay in contact, a mesh is one spring along its line
//! of action. The unit vectors of the lines of action are:
//!
//! ```text
//! t_s = (−sin(ψ_n − α_s), cos(ψ_n − α_s)),     t_r = (−sin(ψ_n + α_r), cos(ψ_n + α_r))
//! ```
//!
//! Let `d` be the displacement `(x, y)` of a body. The elongations are (compression of a mesh is positive):
//!
//! ```text
//! sun–planet        δ_s = t_s·(d_s − d_n) + u_s + u_n
//! ring–planet       δ_r = t_r·(d_r − d_n) + u_r − u_n
//! bearing, radial   δ_x = e_r·(d_c − d_n)                 e_r = (cos ψ_n, sin ψ_n)
//! bearing, tang.    δ_y = e_t·(d_c − d_n) + u_c           e_t = (−sin ψ_n, cos ψ_n)
//! ```
//!
//! Resolved along `e_r` and `e_t` of each planet these are the equations of the source. The other flanks give
//! the same frequencies, as a mirror image. Left out: the change of mesh stiffness over time, friction, gaps,
//! bearings of planets that resist rotation, stiffness from the mean load.
//!
//! # Torsional model
//!
//! The centres of sun, ring and carrier are at rest and planets are rigid on the carrier: `d_n = u_c·e_t`.
//! Then:
//!
//! ```text
//! δ_s = u_s + u_n − u_c·cos α_s,     δ_r = u_r − u_n − u_c·cos α_r
//! ```
//!
//! The carrier has the rotary mass `I_c/r_c² + Σ m_n`. The torsional model is the limit of the planar one as
//! bearings and supports become rigid.
//!
//! # Source
//! J. Lin, R. G. Parker, Analytical characterization of the unique properties of planetary gear free
//! vibration, Journal of Vibration and Acoustics 121 (1999) 316–321. A. Kahraman, Natural modes of planetary
//! gear trains, Journal of Sound and Vibration 173 (1994) 125–130.

use crate::checks::{positive, within};
use crate::model::{Axis, Body, BodyId, Freedom, Model, Orbiting, SpringId, Support};
use crate::{Error, Stiffness, tolerance};
use epicyclic_units::Physical;
use std::f64::consts::{FRAC_PI_2, TAU};
use uom::si::f64::{Angle, MomentOfInertia};

/// Sun, ring or carrier.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Central {
    /// Mass and inertia of the member; the radius is the base radius of a gear, and for the carrier that of
    /// the planets' circle.
    pub body: Body,
    /// Springs of the member to the ground.
    pub support: Support,
    /// Freedom of the member. A torsional model takes [`Freedom::Planar`] as [`Freedom::Rotation`], and
    /// [`Freedom::Translation`] as held.
    pub freedom: Freedom,
}

impl Central {
    /// A member that moves in the plane on a support.
    #[must_use]
    pub fn new(body: Body, support: Support) -> Self {
        Self { body, support, freedom: Freedom::Planar }
    }

    /// Returns the member held: it neither moves nor rotates.
    #[must_use]
    pub fn held(self) -> Self {
        Self { freedom: Freedom::Held, ..self }
    }
}

/// A planet with its springs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Planet {
    /// Mass and inertia of the planet; the radius is the base radius.
    pub body: Body,
    /// Angle `ψ` of the planet on the carrier.
    pub angle: Angle,
    /// Radial stiffness of its bearing on the carrier.
    pub bearing: Stiffness,
    /// Stiffness of the sun's mesh, along the line of action.
    pub sun_mesh: Stiffness,
    /// Stiffness of the ring's mesh, along the line of action.
    pub ring_mesh: Stiffness,
}

impl Planet {
    /// Returns `count` planets equal to this one, equally spaced; their angles are between 0 and 2π.
    #[must_use]
    pub fn equally_spaced(self, count: usize) -> Vec<Self> {
        let [first, step] = [self.angle.si(), TAU / count as f64];
        (0..count)
            .map(|n| Self { angle: Angle::from_si((first + step * n as f64).rem_euclid(TAU)), ..self })
            .collect()
    }
}

/// A simple planetary set.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanetarySet {
    /// The sun.
    pub sun: Central,
    /// The ring.
    pub ring: Central,
    /// The carrier.
    pub carrier: Central,
    /// The planets.
    pub planets: Vec<Planet>,
    /// Transverse working pressure angle `α_s` of the sun's meshes.
    pub sun_pressure_angle: Angle,
    /// Transverse working pressure angle `α_r` of the ring's meshes.
    pub ring_pressure_angle: Angle,
}

/// Places of the bodies and springs of a set in its model.
#[derive(Debug, Clone, PartialEq)]
pub struct SetParts {
    /// The sun.
    pub sun: BodyId,
    /// The ring.
    pub ring: BodyId,
    /// The carrier.
    pub carrier: BodyId,
    /// The planets, in their order.
    pub planets: Vec<BodyId>,
    /// Meshes of the sun with each planet.
    pub sun_meshes: Vec<SpringId>,
    /// Meshes of the ring with each planet.
    pub ring_meshes: Vec<SpringId>,
    /// Radial and tangential spring of each planet's bearing; none in a torsional model.
    pub bearings: Vec<[SpringId; 2]>,
    /// Springs between sun, ring and carrier and the ground.
    pub supports: [Vec<SpringId>; 3],
}

impl SetParts {
    /// Sun, ring and carrier.
    #[must_use]
    pub fn central(&self) -> [BodyId; 3] {
        [self.sun, self.ring, self.carrier]
    }
}

impl PlanetarySet {
    /// The planar model of this set alone.
    ///
    /// # Errors
    /// As [`Self::add_planar`].
    pub fn planar(&self) -> Result<(Model, SetParts), Error> {
        let mut model = Model::new();
        let parts = self.add_planar(&mut model, "")?;
        Ok((model, parts))
    }

    /// The torsional model of this set alone.
    ///
    /// # Errors
    /// As [`Self::add_planar`].
    pub fn torsional(&self) -> Result<(Model, SetParts), Error> {
        let mut model = Model::new();
        let parts = self.add_torsional(&mut model, "")?;
        Ok((model, parts))
    }

    /// Adds the set to a model, planar. The names of bodies and springs begin with `prefix`.
    ///
    /// Sets of one model share its axes. Where their carriers turn at different speeds, this holds for their
    /// rotational modes, and for others where no lateral spring joins the sets.
    ///
    /// # Errors
    /// [`Error::TooFew`] without planets, [`Error::SameAngle`]; [`Error::OutOfRange`] for a pressure angle
    /// outside 0 to 90°; [`Error::NotPositive`] for a mass, inertia, radius or the stiffness of a mesh or
    /// planet bearing; [`Error::Negative`] for a support.
    pub fn add_planar(&self, model: &mut Model, prefix: &str) -> Result<SetParts, Error> {
        let mut parts = self.bodies(model, prefix, false)?;
        let [alpha_s, alpha_r] = self.pressure_angles()?;
        for (index, planet) in self.planets.iter().enumerate() {
            let (p, number, psi) = (parts.planets[index], index + 1, planet.angle.si());
            let line = |angle: f64| [-libm::sin(angle), libm::cos(angle)];
            let between = |one: BodyId, [x, y]: [f64; 2]| {
                [(one, Axis::X, x), (one, Axis::Y, y), (p, Axis::X, -x), (p, Axis::Y, -y)]
            };
            let mut spring = |name: String, stiffness, one: BodyId, direction, rotations: &[_]| {
                let mut terms = between(one, direction).to_vec();
                terms.extend_from_slice(rotations);
                model.spring(&name, stiffness, &terms)
            };
            let (sun, ring, carrier) = (parts.sun, parts.ring, parts.carrier);
            let u = Axis::Rotation;
            parts.sun_meshes.push(spring(
                format!("{prefix}mesh of sun and planet {number}"),
                planet.sun_mesh,
                sun,
                line(psi - alpha_s),
                &[(sun, u, 1.0), (p, u, 1.0)],
            )?);
            parts.ring_meshes.push(spring(
                format!("{prefix}mesh of ring and planet {number}"),
                planet.ring_mesh,
                ring,
                line(psi + alpha_r),
                &[(ring, u, 1.0), (p, u, -1.0)],
            )?);
            let name = format!("{prefix}bearing of planet {number}");
            let radial = [libm::cos(psi), libm::sin(psi)];
            let radial = spring(format!("{name}, radial"), planet.bearing, carrier, radial, &[])?;
            let turned = [(carrier, u, 1.0)];
            let tangential =
                spring(format!("{name}, tangential"), planet.bearing, carrier, line(psi), &turned)?;
            parts.bearings.push([radial, tangential]);
            model.bodies[carrier.0].orbiting.push(Orbiting {
                mass_kg: planet.body.mass.si(),
                bearing_n_per_m: planet.bearing.si(),
                angle_rad: psi,
                lever: 1.0,
            });
        }
        Ok(parts)
    }

    /// Adds the set to a model, torsional.
    ///
    /// # Errors
    /// As [`Self::add_planar`].
    pub fn add_torsional(&self, model: &mut Model, prefix: &str) -> Result<SetParts, Error> {
        let mut parts = self.bodies(model, prefix, true)?;
        let [alpha_s, alpha_r] = self.pressure_angles()?;
        let u = Axis::Rotation;
        for (index, planet) in self.planets.iter().enumerate() {
            let (p, number, carrier) = (parts.planets[index], index + 1, parts.carrier);
            let terms = [(parts.sun, u, 1.0), (p, u, 1.0), (carrier, u, -libm::cos(alpha_s))];
            let name = format!("{prefix}mesh of sun and planet {number}");
            parts.sun_meshes.push(model.spring(&name, planet.sun_mesh, &terms)?);
            let terms = [(parts.ring, u, 1.0), (p, u, -1.0), (carrier, u, -libm::cos(alpha_r))];
            let name = format!("{prefix}mesh of ring and planet {number}");
            parts.ring_meshes.push(model.spring(&name, planet.ring_mesh, &terms)?);
        }
        Ok(parts)
    }

    /// Adds the bodies and the supports.
    fn bodies(&self, model: &mut Model, prefix: &str, torsional: bool) -> Result<SetParts, Error> {
        self.check_planets()?;
        let freedom = |given| match given {
            Freedom::Planar if torsional => Freedom::Rotation,
            Freedom::Translation if torsional => Freedom::Held,
            other => other,
        };
        let mut add = |name: &str, central: &Central| {
            let name = format!("{prefix}{name}");
            let body = model.body(&name, &central.body, freedom(central.freedom))?;
            let support = if torsional {
                Support { radial: Support::default().radial, ..central.support }
            } else {
                central.support
            };
            // A held coordinate has no use for a spring.
            let springs = match freedom(central.freedom) {
                Freedom::Held => Vec::new(),
                Freedom::Rotation => {
                    model.support(body, Support { radial: Support::default().radial, ..support })?
                }
                Freedom::Translation => {
                    model.support(body, Support { tangential: Support::default().tangential, ..support })?
                }
                Freedom::Planar => model.support(body, support)?,
            };
            Ok((body, springs))
        };
        let (sun, of_sun) = add("sun", &self.sun)?;
        let (ring, of_ring) = add("ring", &self.ring)?;
        let mut carrier = self.carrier;
        if torsional {
            let r_c = carrier.body.radius.si();
            let planets: f64 = self.planets.iter().map(|planet| planet.body.mass.si()).sum();
            if freedom(carrier.freedom) == Freedom::Rotation {
                positive(|| format!("inertia of {prefix}carrier"), carrier.body.inertia.si(), "kg·m²")?;
            }
            carrier.body.inertia += MomentOfInertia::from_si(planets * r_c * r_c);
        }
        let (carrier, of_carrier) = add("carrier", &carrier)?;
        let mut planets = Vec::with_capacity(self.planets.len());
        for (index, planet) in self.planets.iter().enumerate() {
            let name = format!("{prefix}planet {}", index + 1);
            planets.push(model.body(&name, &planet.body, freedom(Freedom::Planar))?);
        }
        Ok(SetParts {
            sun,
            ring,
            carrier,
            planets,
            sun_meshes: Vec::new(),
            ring_meshes: Vec::new(),
            bearings: Vec::new(),
            supports: [of_sun, of_ring, of_carrier],
        })
    }

    pub(crate) fn check_planets(&self) -> Result<(), Error> {
        if self.planets.is_empty() {
            return Err(Error::TooFew { of: "planets", count: 0, least: 1 });
        }
        for (index, planet) in self.planets.iter().enumerate() {
            let psi = planet.angle.si();
            within(|| format!("angle of planet {}", index + 1), psi, [-TAU, TAU], "rad")?;
            for (other, before) in self.planets[..index].iter().enumerate() {
                let apart = (psi - before.angle.si()).rem_euclid(TAU);
                if apart.min(TAU - apart) < tolerance::SAME_ANGLE {
                    return Err(Error::SameAngle { first: other + 1, second: index + 1 });
                }
            }
        }
        Ok(())
    }

    pub(crate) fn pressure_angles(&self) -> Result<[f64; 2], Error> {
        let checked = |name: &str, angle: Angle| {
            let field = || format!("pressure angle of the {name}'s meshes");
            within(field, angle.si(), [0.0, FRAC_PI_2], "rad")
        };
        Ok([checked("sun", self.sun_pressure_angle)?, checked("ring", self.ring_pressure_angle)?])
    }
}

//! A simple planetary set in the form of the literature: planar (Lin, Parker) and torsional (Kahraman).
//!
//! It is a [`GearSet`] of a sun, a ring, a carrier and planets with two meshes each, with the flanks that
//! carry at a positive torque on the sun. `u` is the rotation times the base radius of a gear, and for the
//! carrier the rotation times the radius `r_c` of the planets' circle. The elongations of the [general
//! model](crate::gear_set) are then those of the sources:
//!
//! ```text
//! sun–planet        δ_s = t_s·(d_s − d_n) + u_s + u_n      t_s = (−sin(ψ_n − α_s), cos(ψ_n − α_s))
//! ring–planet       δ_r = t_r·(d_r − d_n) + u_r − u_n      t_r = (−sin(ψ_n + α_r), cos(ψ_n + α_r))
//! torsional         δ_s = u_s + u_n − u_c·cos α_s,         δ_r = u_r − u_n − u_c·cos α_r
//! ```
//!
//! # Source
//! J. Lin, R. G. Parker, Analytical characterization of the unique properties of planetary gear free
//! vibration, Journal of Vibration and Acoustics 121 (1999) 316–321. A. Kahraman, Natural modes of planetary
//! gear trains, Journal of Sound and Vibration 173 (1994) 125–130.

use crate::gear_set::{BodyOf, Central, Gear, GearMesh, GearSet, GearSetParts, Member, PlanetBody};
use crate::model::{Body, BodyId, Model, SpringId};
use crate::{Error, Stiffness};
use epicyclic_units::Physical;
use std::f64::consts::TAU;
use uom::si::f64::Angle;

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

/// Places of the bodies and springs of a simple set in its model.
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

    fn of(parts: GearSetParts) -> Self {
        let [sun, ring, carrier] = [0, 1, 2].map(|member| parts.members[member]);
        let (sun_meshes, ring_meshes) = parts.meshes.split_at(parts.planets.len());
        let (sun_meshes, ring_meshes) = (sun_meshes.to_vec(), ring_meshes.to_vec());
        let supports = [0, 1, 2].map(|member| parts.supports[member].clone());
        let GearSetParts { planets, bearings, .. } = parts;
        Self { sun, ring, carrier, planets, sun_meshes, ring_meshes, bearings, supports }
    }
}

impl PlanetarySet {
    /// The planar model of this set alone.
    ///
    /// # Errors
    /// As [`GearSet::planar`].
    pub fn planar(&self) -> Result<(Model, SetParts), Error> {
        let (model, parts) = self.gear_set().planar()?;
        Ok((model, SetParts::of(parts)))
    }

    /// The torsional model of this set alone.
    ///
    /// # Errors
    /// As [`GearSet::planar`].
    pub fn torsional(&self) -> Result<(Model, SetParts), Error> {
        let (model, parts) = self.gear_set().torsional()?;
        Ok((model, SetParts::of(parts)))
    }

    /// The set in the general form: members sun, ring, carrier; meshes of the sun, then of the ring.
    #[must_use]
    pub fn gear_set(&self) -> GearSet {
        let members = [("sun", self.sun), ("ring", self.ring), ("carrier", self.carrier)];
        let members = members.map(|(name, central)| Member { name: name.to_owned(), central });
        let planets = self.planets.iter().zip(1..).map(|(planet, number)| PlanetBody {
            name: format!("planet {number}"),
            body: planet.body,
            distance: self.carrier.body.radius,
            angle: planet.angle,
            bearing: planet.bearing,
        });
        let mesh = |member: usize, place: usize, stiffness, pressure_angle| {
            let gear = |of, body: Body, is_internal| Gear { of, base_radius: body.radius, is_internal };
            let central = [&self.sun, &self.ring][member].body;
            let planet = gear(BodyOf::Planet(place), self.planets[place].body, false);
            let gears = [gear(BodyOf::Member(member), central, member == 1), planet];
            GearMesh { gears, stiffness, pressure_angle, is_forward: true }
        };
        let own = || self.planets.iter().enumerate();
        let of_sun = own().map(|(at, planet)| mesh(0, at, planet.sun_mesh, self.sun_pressure_angle));
        let of_ring = own().map(|(at, planet)| mesh(1, at, planet.ring_mesh, self.ring_pressure_angle));
        GearSet {
            members: members.to_vec(),
            carrier: Some(2),
            planets: planets.collect(),
            meshes: of_sun.chain(of_ring).collect(),
        }
    }
}

//! Axial forces of helical teeth on the gears of a set of any kind, and the moments that tilt its planets.
//!
//! ```text
//! F_a = −h·F_φ·tan β        F_φ = τ/r        Σ F_a over the meshes of a body        M = Σ r⃗_w × F_a·z⃗
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `F_a` | axial force of one mesh on a gear, along the main axis `z⃗` | N |
//! | `F_φ` | tangential force on the gear at its reference cylinder, in its positive direction of rotation | N |
//! | `τ` | torque of one mesh on the gear about the gear's own axis ([`mesh_loads`](crate::mesh_loads)) | N·m |
//! | `r`, `r⃗_w` | reference radius; way from the gear's centre to the working pitch point | m |
//! | `h` | hand of the gear: 1 right, −1 left | 1 |
//! | `β` | size of the helix angle at the reference cylinder | ° |
//! | `M` | moment that tilts a planet, about an axis across its pin | N·m |
//!
//! A positive force points in the direction about which the positive rotation is that of a right-handed
//! screw.
//!
//! # Hands
//! Gears in mesh outside each other have opposite hands, a ring and its planet have the same. So one hand
//! decides those of all gears that mesh with each other. With a positive helix angle the planet's gear is
//! right-handed; in a mesh of two planets it is that of the planet described first, in a pair on fixed axes
//! gear 1. A negative angle reverses the hands. Where meshes share a gear, the first of them decides, and
//! their angles have one sign. Each gear of a stepped planet has a hand of its own.
//!
//! The two meshes of a planet between two central gears push it in opposite directions, whatever the hands,
//! if it has one gear. On a stepped planet they do if both gears have one hand, and cancel if
//! `tan β_1/r_1 = tan β_2/r_2`, that is with equal leads; with opposite hands they add up.
//!
//! # Moments
//! The meshes lie at different directions about a planet, so that their moments are added as vectors. On a
//! central gear the moments of equally spaced planets cancel.
//!
//! # Left out
//! Losses; the couple of the radial and tangential forces of a stepped planet, whose gears lie in two planes:
//! [`PlanetSet::step_couple`].

use crate::planet_places::planet_of;
use crate::planet_set::{GearOf, MeshKind, PlanetSet};
use crate::toothed::ToothedSet;
use crate::{compound::CentralKind, mesh_loads::MeshLoad};
use epicyclic_units::Physical;
use uom::si::f64::Torque;

/// A body with helical teeth: a central gear, or one planet with all its gears.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Body {
    /// A central gear, by its place in [`PlanetSet::centrals`].
    Central(usize),
    /// A planet, by its place in [`PlanetSet::planets`].
    Planet(usize),
}

/// Axial load of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct AxialLoad {
    /// The body.
    pub body: Body,
    /// Axial force of one mesh of each kind on the body, with the place of the mesh, N.
    pub meshes: Vec<(usize, f64)>,
    /// Sum of the axial forces over all meshes of the body, N.
    pub force: f64,
    /// Moment that tilts a planet or a gear of a pair, N·m: about the direction from the main axis to its
    /// centre, and about its direction of motion in a positive rotation of the carrier. Of a pair the first
    /// direction is that from gear 1 to the pitch point. 0 of central gears.
    pub moment: [f64; 2],
}

impl PlanetSet {
    /// Hand of each gear of a helical set, in the order of [`gears`](Self::gears): 1 right, −1 left.
    #[must_use]
    pub fn hands(&self) -> Vec<f64> {
        let order = self.gears();
        let mut hands: Vec<Option<f64>> = vec![None; order.len()];
        let place = |gear: GearOf| order.iter().position(|one| *one == gear);
        for first in 0..self.meshes().len() {
            let gears = self.gears_of_mesh(first);
            let [Some(one), Some(other)] = gears.map(place) else { continue };
            if hands[one].is_none() && hands[other].is_none() {
                let is_planets = planet_of(gears[0]).is_none() && planet_of(gears[1]).is_some();
                let sign = if self.tooth_shape().signed_helix_angle(first).si() < 0.0 { -1.0 } else { 1.0 };
                hands[if is_planets { other } else { one }] = Some(sign);
            }
            // Meshes make a tree, in which each round reaches further gears.
            for _ in 0..self.meshes().len() {
                for mesh in 0..self.meshes().len() {
                    let [Some(one), Some(other)] = self.gears_of_mesh(mesh).map(place) else { continue };
                    let sign = if self.meshes()[mesh].kind == MeshKind::Internal { 1.0 } else { -1.0 };
                    hands[one] = hands[one].or(hands[other].map(|hand| sign * hand));
                    hands[other] = hands[other].or(hands[one].map(|hand| sign * hand));
                }
            }
        }
        hands.into_iter().map(|hand| hand.unwrap_or(1.0)).collect()
    }

    /// Axial loads of the bodies of a set, central gears first, at these loads of its meshes in N·m.
    /// `toothed` has modules in metres; `is_behind` as in [`angles_between`](Self::angles_between). `None` of
    /// spur teeth, and where two planets in mesh do not reach each other.
    #[must_use]
    pub fn axial_forces(
        &self,
        toothed: &ToothedSet,
        is_behind: &[bool],
        loads: &[MeshLoad],
    ) -> Option<Vec<AxialLoad>> {
        if !self.tooth_shape().is_helical() {
            return None;
        }
        let angles = self.angles_between(toothed, is_behind)?;
        let (order, hands) = (self.gears(), self.hands());
        let is_gear = |central: &usize| self.centrals()[*central].kind != CentralKind::PlanetShaft;
        let centrals = (0..self.centrals().len()).filter(is_gear).map(Body::Central);
        let planets = (0..self.planets().len()).map(Body::Planet);
        let none = |body| AxialLoad { body, meshes: vec![], force: 0.0, moment: [0.0; 2] };
        let mut all: Vec<AxialLoad> = centrals.chain(planets).map(none).collect();
        for (mesh, (made, load)) in toothed.meshes.iter().zip(loads).enumerate() {
            for (end, gear) in made.gears.into_iter().enumerate() {
                let body = match gear {
                    GearOf::Central(central) => Body::Central(central),
                    GearOf::Planet(planet, _) => Body::Planet(planet),
                };
                let hand = hands[order.iter().position(|one| *one == gear)?];
                let of_gear = made.pair.gears()[end];
                let tangential = load.torques[end] / (made.module * of_gear.reference_diameter() / 2.0);
                let force = -hand * tangential * libm::tan(of_gear.profile().helix_angle.si());
                let radius = made.module * made.pair.working_diameters()[end] / 2.0;
                let [out, along] = self.pitch_point(toothed, &angles, mesh, end)?;
                let own = all.iter_mut().find(|one| one.body == body)?;
                own.meshes.push((mesh, force));
                own.force += force * load.contacts[end];
                if self.is_pair() || matches!(body, Body::Planet(_)) {
                    own.moment[0] += radius * along * force;
                    own.moment[1] -= radius * out * force;
                }
            }
        }
        Some(all)
    }

    /// Axial load of a planet at these torques on the members of its set; `None` as of
    /// [`axial_forces`](Self::axial_forces), and where the loads of its meshes do not follow.
    #[must_use]
    pub fn planet_axial_load(
        &self,
        planet: usize,
        (toothed, is_behind): (&ToothedSet, &[bool]),
        torques: &[Torque],
    ) -> Option<AxialLoad> {
        let loads = self.mesh_loads(&torques.iter().map(|torque| torque.si()).collect::<Vec<_>>())?;
        let all = self.axial_forces(toothed, is_behind, &loads)?;
        all.into_iter().find(|one| one.body == Body::Planet(planet))
    }

    /// Direction from the centre of a gear to the pitch point of a mesh: outwards and along the positive
    /// rotation.
    pub(crate) fn pitch_point(
        &self,
        toothed: &ToothedSet,
        angles: &[(usize, uom::si::f64::Angle)],
        mesh: usize,
        end: usize,
    ) -> Option<[f64; 2]> {
        let made = &toothed.meshes[mesh];
        let is_internal = made.pair.is_internal();
        let [own, other] = [made.gears[end], made.gears[1 - end]].map(planet_of);
        let Some((own, other)) = own.zip(other) else {
            // A sun is inside the orbit, a ring outside.
            let is_inwards = own.is_some() && !is_internal || self.is_pair() && end == 1 && !is_internal;
            return Some([if is_inwards { -1.0 } else { 1.0 }, 0.0]);
        };
        let (radius, to) = (toothed.radii[own]?, toothed.radii[other]?);
        let (sin, cos) = libm::sincos((angles[other].1 - angles[own].1).si());
        let (out, along) = (to * cos - radius, to * sin);
        let distance = libm::hypot(out, along);
        Some([out / distance, along / distance])
    }
}

#[cfg(test)]
mod tests;

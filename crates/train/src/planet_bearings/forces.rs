//! The bearing of a planet: its meshes, and the forces of torques and speed on it.

use super::flows::{Flows, Part};
use crate::planet_places::planet_of;
use crate::planet_set::GearOf;
use crate::tolerance::NO_TORQUE;
use crate::{LinkId, LoadCase, Operation};
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::life::{self, Rolling};
use epicyclic_gears::planet_bearing::{self, Push};
use epicyclic_gears::{Error, Quantity};
use epicyclic_numerics::values::largest_absolute;
use epicyclic_units::Physical;
use uom::si::f64::{Angle, AngularVelocity, Force, Length, Mass, Time, Torque};

/// Missing data for a force, or the reason why none follows.
#[derive(Debug, Clone, PartialEq)]
pub enum Lack {
    /// The number of planets.
    Planets,
    /// The radius of their centres.
    Radius,
    /// One radius is given for planets that differ, and not taken.
    CommonRadius,
    /// Teeth, for the pitch radii.
    Teeth,
    /// The radius of the centre of a planet in mesh with this one.
    OtherRadius {
        /// The other planet, by its place in [`PlanetSet::planets`](crate::PlanetSet::planets).
        other: usize,
    },
    /// Module or teeth of the mesh with another planet.
    Distance {
        /// The other planet, by its place in [`PlanetSet::planets`](crate::PlanetSet::planets).
        other: usize,
    },
    /// Two planets in mesh that do not fit at their radii.
    Triangle {
        /// The other planet, by its place in [`PlanetSet::planets`](crate::PlanetSet::planets).
        other: usize,
        /// Radius of this planet's centre and of the other's.
        radii: [Length; 2],
        /// Distance of the centres by module and teeth.
        distance: Length,
    },
    /// The mass of a planet.
    Mass,
    /// Bevel planets are left out.
    Bevel,
}

/// A mesh of a planet.
#[derive(Debug, Clone, PartialEq)]
pub struct Contact {
    /// Place of the mesh in [`PlanetSet::meshes`](crate::PlanetSet::meshes).
    pub mesh: usize,
    /// The gear on the other side.
    pub with: GearOf,
    /// Kind of that gear: a sun or planet is external, a ring internal.
    pub gear_kind: GearKind,
    /// Pitch radius: of a central gear its own, of a mesh with another planet that of this planet's gear.
    pub pitch_radius: Option<Length>,
    /// Working pressure angle, if not that of the set.
    pub pressure_angle: Option<Angle>,
    /// Towards another planet: unit vector outwards and along the positive direction of rotation.
    pub direction: Option<[f64; 2]>,
    /// Part of the torques on the central gears that the mesh transmits.
    pub(super) part: Option<Part>,
}

/// The bearing of a planet on its planet pin, as far as it is known.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanetBearing {
    /// Place of its set in [`Gearbox::sets`](crate::Gearbox::sets).
    pub set: usize,
    /// Place of the planet in [`PlanetSet::planets`](crate::PlanetSet::planets).
    pub planet: usize,
    /// Name of the planet: `planet` if the set has only one, else `planet long` or `planet 2`.
    pub name: String,
    /// Number of these planets, which share the load equally.
    pub planets: Option<u32>,
    /// Radius `R` of their centres.
    pub radius: Option<Length>,
    /// Meshes of the planet.
    pub contacts: Vec<Contact>,
    /// Mass of one planet.
    pub mass: Option<Mass>,
    /// Basic dynamic load rating of its bearings together, and the kind of their rolling elements.
    pub load_rating: Option<(Force, Rolling)>,
    /// Working pressure angle.
    pub pressure_angle: Angle,
    /// Missing data.
    pub lacks: Vec<Lack>,
    pub(super) carrier: LinkId,
    /// Members that turn with it.
    pub(super) shafts: Vec<usize>,
    pub(super) members: usize,
    pub(super) is_only: bool,
    pub(super) flows: Flows,
    /// Part of the loss that the first of its two meshes has, where it has two, both with central gears.
    pub(super) loss_share: Option<f64>,
}

/// Forces on the bearing of each planet, as far as they follow.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BearingForces {
    /// Tangential, of the meshes: positive in the direction in which all planets together push the carrier.
    pub tangential: Option<Force>,
    /// Radial, of the meshes, outwards positive.
    pub radial: Option<Force>,
    /// Centrifugal.
    pub centrifugal: Option<Force>,
    /// Resultant of the tangential, radial and centrifugal force; `None` unless each is known.
    pub total: Option<Force>,
}

/// Direction in which the planets push a carrier against this torque from outside.
fn push_direction(centrals_n_m: &[f64], carrier: Torque) -> f64 {
    if carrier.si() > NO_TORQUE * largest_absolute(centrals_n_m) { -1.0 } else { 1.0 }
}

impl Contact {
    /// Whether it is a mesh with a planet through which the torque is not known.
    pub(super) fn is_weightless(&self) -> bool {
        planet_of(self.with).is_some() && self.part.is_none()
    }

    /// Torque of the mesh for these torques on the central gears: about the main axis, if with a central
    /// gear; `τ_q·N`, if with another planet.
    pub(super) fn weighed(&self, flows: &Flows, torques_n_m: &[f64]) -> Option<f64> {
        Some(flows.torque(self.part.as_ref()?, torques_n_m))
    }

    /// Force of another planet on this one, outwards and along the positive direction, N; and its moment
    /// about the main axis, N·m.
    pub(super) fn of_planet(
        &self,
        flows: &Flows,
        torques_n_m: &[f64],
        count: f64,
        tan_alpha: f64,
        radius_m: f64,
    ) -> Option<([f64; 2], f64)> {
        let [out, along] = self.direction?;
        let about_own_n_m = self.weighed(flows, torques_n_m)? / count;
        let across_n = about_own_n_m / self.pitch_radius?.si();
        let apart_n = across_n.abs() * tan_alpha;
        let outwards_n = -across_n * along - apart_n * out;
        let along_n = across_n * out - apart_n * along;
        Some(([outwards_n, along_n], radius_m * along_n + about_own_n_m))
    }
}

impl PlanetBearing {
    /// Whether the set has no other planet: then its pins alone hand the carrier its torque.
    #[must_use]
    pub const fn is_only(&self) -> bool {
        self.is_only
    }

    /// The forces at this operating point.
    ///
    /// # Errors
    /// Those of [`forces`](Self::forces); [`Error::OutOfRange`] for an operating point of another gearbox.
    pub fn at(&self, operation: &Operation) -> Result<BearingForces, Error> {
        let torques = operation.members.get(self.set).and_then(Option::as_deref);
        self.forces(torques, operation.speeds.get(self.carrier.index()).copied().flatten())
    }

    /// The forces of the meshes at 1 N·m on the input.
    ///
    /// # Errors
    /// Those of [`forces`](Self::forces); [`Error::OutOfRange`] for a load case of another gearbox.
    pub fn of_unit_input(&self, case: &LoadCase) -> Result<BearingForces, Error> {
        let of_input = |torques: &Vec<f64>| {
            torques.iter().map(|of| Torque::from_si(of / case.input)).collect::<Vec<_>>()
        };
        let torques = case.members.get(self.set).and_then(Option::as_ref).map(of_input);
        self.forces(torques.as_deref(), None)
    }

    /// The forces of these torques on the members of the set, in the order of
    /// [`PlanetSet::members`](crate::PlanetSet::members), at this speed of the carrier.
    ///
    /// # Errors
    /// Those of [`epicyclic_gears::planet_bearing`]; [`Error::OutOfRange`] for a number of torques other than
    /// that of the members.
    pub fn forces(
        &self,
        torques: Option<&[Torque]>,
        carrier_speed: Option<AngularVelocity>,
    ) -> Result<BearingForces, Error> {
        let mut forces = BearingForces::default();
        let Some(radius) = self.radius else { return Ok(forces) };
        if let Some(given) = torques.map(<[Torque]>::len).filter(|given| *given != self.members) {
            let (value, due) = (given as f64, self.members as f64);
            let quantity = Quantity::MemberTorques;
            return Err(Error::OutOfRange { quantity, value, low: due, high: due, unit: "" });
        }
        if let (Some(planets), Some([centrals @ .., carrier])) = (self.planets, torques) {
            let of_centrals: Vec<f64> = centrals.iter().map(|torque| torque.si()).collect();
            let between = self.between(&of_centrals, planets, radius);
            let push = |contact: &Contact| {
                if planet_of(contact.with).is_some() {
                    return None;
                }
                let torque = contact.weighed(&self.flows, &of_centrals).map(Torque::from_si);
                let known = contact.pitch_radius.zip(torque);
                Some(known.map(|(pitch_radius, torque)| Push {
                    kind: contact.gear_kind,
                    pitch_radius,
                    torque,
                }))
            };
            let pushes: Option<Vec<Push>> = self.contacts.iter().filter_map(push).collect();
            // Its own limits.
            let of_carrier = planet_bearing::tangential_force(*carrier, planets, radius)?;
            if let (Some(pushes), Some([outwards_n, _])) = (pushes, between) {
                let of_centrals = match (self.loss_share, pushes.as_slice()) {
                    (Some(share), [first, second]) => {
                        let pair = [*first, *second];
                        let meshes = planet_bearing::two_mesh_forces(&pair, share, planets, radius)?;
                        let angle =
                            |mesh: usize| self.contacts[mesh].pressure_angle.unwrap_or(self.pressure_angle);
                        let meshes = [0, 1].map(|mesh| (pair[mesh].kind, meshes[mesh], angle(mesh)));
                        planet_bearing::radial_force_of(&meshes)?
                    }
                    _ => planet_bearing::radial_force(&pushes, planets, self.pressure_angle)?,
                };
                forces.radial = Some(of_centrals + Force::from_si(outwards_n));
            }
            forces.tangential = if self.is_only {
                Some(of_carrier)
            } else {
                between.map(|[_, moment_n_m]| {
                    let gears = self.contacts.iter().filter(|contact| planet_of(contact.with).is_none());
                    let of_gears: f64 =
                        gears.filter_map(|gear| gear.weighed(&self.flows, &of_centrals)).sum();
                    let own = of_gears + self.shafts.iter().map(|&shaft| of_centrals[shaft]).sum::<f64>();
                    let along_n = (own / f64::from(planets) + moment_n_m) / radius.si();
                    Force::from_si(push_direction(&of_centrals, *carrier) * along_n)
                })
            };
        }
        forces.centrifugal = match (self.mass, carrier_speed) {
            (_, Some(speed)) if speed.si() == 0.0 => Some(Force::default()),
            (Some(mass), Some(speed)) => Some(planet_bearing::centrifugal_force(mass, radius, speed)?),
            _ => None,
        };
        forces.total = forces.tangential.zip(forces.radial.zip(forces.centrifugal)).map(
            |(tangential, (radial, centrifugal))| planet_bearing::resultant(tangential, radial + centrifugal),
        );
        Ok(forces)
    }

    /// Direction of a positive tangential force at these torques on the members of the set: 1 along the
    /// positive rotation of the carrier, −1 against it.
    #[must_use]
    pub fn push_direction(torques: &[Torque]) -> f64 {
        let Some((carrier, centrals)) = torques.split_last() else { return 1.0 };
        push_direction(&centrals.iter().map(|torque| torque.si()).collect::<Vec<_>>(), *carrier)
    }

    /// Forces of other planets in mesh on this one: force outwards, N, and moment about the main axis, N·m.
    fn between(&self, torques_n_m: &[f64], planets: u32, radius: Length) -> Option<[f64; 2]> {
        let (count, tan_alpha) = (f64::from(planets), libm::tan(self.pressure_angle.si()));
        let meshing = self.contacts.iter().filter(|contact| planet_of(contact.with).is_some());
        meshing.into_iter().try_fold([0.0, 0.0], |[out, about], contact| {
            let ([outwards_n, _], moment_n_m) =
                contact.of_planet(&self.flows, torques_n_m, count, tan_alpha, radius.si())?;
            Some([out + outwards_n, about + moment_n_m])
        })
    }

    /// Whether the places of planets in mesh are missing, and said to be.
    pub(super) fn lacks_of_pair(&self) -> bool {
        let of_pair = |lack: &Lack| {
            matches!(lack, Lack::OtherRadius { .. } | Lack::Distance { .. } | Lack::Triangle { .. })
        };
        self.lacks.iter().any(of_pair)
    }

    /// Basic rating life of the bearings under this force, at this speed of the planet relative to the
    /// carrier.
    ///
    /// # Errors
    /// Those of [`basic_rating_life`](life::basic_rating_life).
    pub fn life(&self, force: Force, planet_on_carrier: AngularVelocity) -> Result<Option<Time>, Error> {
        let Some((load_rating, rolling)) = self.load_rating else { return Ok(None) };
        life::basic_rating_life(rolling, load_rating, force, planet_on_carrier)
    }
}

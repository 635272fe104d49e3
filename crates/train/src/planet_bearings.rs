//! Forces on the bearings of every planet of a set in a gear, and the size of the set that they need.
//!
//! # Geometry
//! A planet's centre is at the radius `R` from the main axis. Without profile shift
//!
//! ```text
//! planet and sun     R = m·(z_c + z_p)/2    r_c = R·z_c/(z_c + z_p)
//! planet and ring    R = m·(z_c − z_p)/2    r_c = R·z_c/(z_c − z_p)
//! planets p, q       a = m·(z_p + z_q)/2    r_p = a·z_p/(z_p + z_q)
//!                    cos ψ = (R_p² + R_q² − a²)/(2·R_p·R_q)
//! simple set         R = m·(z_a + z_b)/4    r_a = 2·R/(1 + k)          r_b = k·r_a
//!                    where the teeth of the planets are not known
//! ```
//!
//! A given radius takes precedence over that of module and teeth, because shifted profiles move the planets.
//! If several meshes of one planet give different radii, one with a module of its own takes precedence, then
//! the first. The pitch radii of the others follow from the common `R`, as in a stepped planet with two
//! modules.
//!
//! Two planets in mesh are apart by the angle `ψ` about the main axis, which affects the forces. The one
//! described later is ahead in the positive direction of rotation, unless [`MeshSize::is_behind`] is set.
//!
//! # Forces
//! Planets of a kind, `N` in number, share the load equally. Each has the forces
//!
//! ```text
//! central gear c      moment T_c/N about the main axis    radial force ±F_c·tan α    + sun, − ring
//! planet shaft w      moment T_w/N
//! planet q            F_q = τ_q/r_p at the pitch point, across the line of centres    |F_q|·tan α apart
//! F_t = Σ moments/R   F_r = Σ radial parts    F_c = M·R·ω_H²    F = √(F_t² + (F_r + F_c)²)
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `T_c`, `T_H` | torque on a central gear or planet shaft, and on the carrier, from outside | N·m |
//! | `τ_q` | torque on the planet about its own axis through its mesh with planet `q` | N·m |
//! | `R`, `a`, `r_c`, `r_p` | radius of the centres, distance of two centres, pitch radii | mm |
//! | `m`, `α` | module, working pressure angle | mm, deg |
//! | `M` | mass of a planet | kg |
//! | `ω_H` | speed of the carrier | rad/s |
//! | `F_t` | tangential force, along the orbit | N |
//! | `F_r`, `F_c` | radial force of the meshes, centrifugal force, both positive outwards | N |
//!
//! `F_t` is positive in the direction in which all planets together push the carrier, against `T_H`; if `T_H`
//! is 0, along the positive direction of rotation. Hence `F_t = |T_H|/(N·R)` for a set with one planet. In
//! every set `Σ N·F_t·R = |T_H|` over its planets, with losses or without.
//!
//! # Losses
//! The torques of a gear with losses do not balance about a planet's own axis. The model takes the loss of a
//! mesh from the torque and leaves the force at the pitch point. So the mesh forces `T_c/(N·r_c)` and the
//! carrier's torque differ by the loss. If a planet has two central gears in mesh and nothing else, it passes
//! on the torque that it receives. Its mesh forces `F_c` are then those of
//! [`two_mesh_forces`](epicyclic_gears::planet_bearing::two_mesh_forces), which add to `F_t`; elsewhere
//! `F_c = |T_c|/(N·r_c)`.
//!
//! The *moments about the main axis* balance exactly, so they are used here: the bearings then transmit the
//! carrier's torque.
//!
//! The force between two planets follows from the power through their mesh. The powers of the central gears
//! on both sides are `g·T`, with `g` the speeds relative to the carrier, and each mesh on the way passes on
//! its part `η`. `τ_q·g_p·N` is the mean of the powers that enter and leave the mesh. So a planet without
//! load has no force. The rule needs no motion: if the powers add to zero, the set turns as a block or loses
//! nothing, and no mesh has a loss. A central gear in mesh with planets of two kinds shares its torque among
//! them by the same rule.
//!
//! # Left out
//! - Bevel planets ([`Lack::Bevel`]).
//! - The couple of the two planes of a stepped planet, which loads two bearings unequally:
//!   [`PlanetSet::step_couple`].
//! - Forces of the pins of a planet shaft (K-H-V) on their disc beyond a pure couple.
//! - Weight, helix angle, unequal load sharing.
//! - The working pressure angle of meshes whose shifts are not given.

pub(crate) mod flows;
mod forces;
mod size;

pub use forces::{BearingForces, Contact, Lack, PlanetBearing};
pub use size::{MeshSize, PlanetSize, SetSize};

use crate::Gearbox;
use crate::compound::CentralKind;
use crate::planet_places::{
    Given, NoPair, Places, central_mesh, pitch_over_centre_distance, places, planet_mesh, planet_of,
};
use crate::planet_set::{GearOf, Mesh, MeshKind, PlanetSet};
use crate::set::{Gearing, SetKind, SetSpec};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::geometry::{GearKind, ToothedGear};
use epicyclic_gears::mass::{self, GearBody};
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::{Error, ToothCount};
use epicyclic_units::Physical;
use flows::{Flows, Part};
use uom::si::f64::{Angle, Length, Mass};

impl Gearbox {
    /// The planet bearings of a set, in the order of [`PlanetSet::planets`]; `None` of a pair on fixed axes,
    /// which has none, and of a set that does not exist.
    ///
    /// ```
    /// use epicyclic_train::{Gearbox, InputLoad, planet_bearings::SetSize, set::{SetKind, SetSpec}};
    /// use uom::si::angular_velocity::radian_per_second;
    /// use uom::si::f64::{AngularVelocity, Length, Torque};
    /// use uom::si::{force::newton, length::millimeter, torque::newton_meter};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let gearbox = Gearbox::builder("one set")
    ///     .links(["sun", "arm"])
    ///     .set(SetSpec::teeth("P", SetKind::Simple, ["sun", "ground", "arm"], 20, 60)?.planet_count(3))
    ///     .input("sun")
    ///     .output("arm")
    ///     .gear("only", [""; 0])
    ///     .build()?;
    /// let load = InputLoad::Torque(Torque::new::<newton_meter>(100.0));
    /// let work = gearbox.analyze("only")?.at(AngularVelocity::new::<radian_per_second>(150.0), load)?;
    /// let size = SetSize { module: Some(Length::new::<millimeter>(3.0)), ..SetSize::default() };
    /// let bearings = gearbox.planet_bearings(0, &size).unwrap()?;
    /// // 400 N·m on the carrier at 60 mm, over three planets.
    /// let tangential = bearings[0].at(&work)?.tangential.unwrap();
    /// assert!((tangential.get::<newton>() - 20_000.0 / 9.0).abs() < 1e-9);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`Error::NotPositive`] and the like for an invalid size, [`Error::OutOfRange`] for sizes of more
    /// planets, gears or meshes than the set has.
    #[must_use]
    pub fn planet_bearings(&self, set: usize, size: &SetSize) -> Option<Result<Vec<PlanetBearing>, Error>> {
        let own = self.sets.get(set).filter(|own| !own.is_pair())?;
        Some(own.bearings(set, size))
    }
}

impl PlanetSet {
    /// The planet bearings of the set, whose index in its gearbox is `place`, as
    /// [`Gearbox::planet_bearings`]; of a pair none.
    ///
    /// # Errors
    /// Those of [`Gearbox::planet_bearings`].
    pub fn bearings(&self, place: usize, size: &SetSize) -> Result<Vec<PlanetBearing>, Error> {
        size.check(self)?;
        let is_bevel =
            self.meshes().iter().any(|mesh| matches!(mesh.kind, MeshKind::BevelLeft | MeshKind::BevelRight));
        let places = places(self, &self.given(size));
        (0..self.planets().len())
            .map(|planet| {
                let own = size.planets.get(planet);
                let mut bearing = PlanetBearing {
                    set: place,
                    planet,
                    name: self.planet_name(planet),
                    planets: self.planet_count(),
                    radius: None,
                    contacts: vec![],
                    mass: None,
                    load_rating: own.and_then(|own| own.bearing).or(size.bearing),
                    pressure_angle: size.pressure_angle,
                    lacks: vec![],
                    carrier: self.carrier(),
                    shafts: self.shafts_of(planet),
                    members: self.members().len(),
                    is_only: self.planets().len() == 1,
                    flows: self.flows(),
                    loss_share: self.loss_share(planet),
                };
                if is_bevel {
                    bearing.lacks.push(Lack::Bevel);
                    return Ok(bearing);
                }
                let radius = places.radii[planet];
                bearing.radius = radius.map(Length::from_si);
                bearing.mass = self.planet_mass(planet, size, &places)?;
                if bearing.planets.is_none() {
                    bearing.lacks.push(Lack::Planets);
                }
                if !bearing.is_only
                    && size.carrier_radius.is_some()
                    && own.is_none_or(|own| own.carrier_radius.is_none())
                {
                    bearing.lacks.push(Lack::CommonRadius);
                }
                if radius.is_none() {
                    bearing.lacks.push(Lack::Radius);
                }
                for mesh in 0..self.meshes().len() {
                    let own = size.meshes.get(mesh).and_then(|own| own.pressure_angle);
                    let contact = self.contact(planet, mesh, own, &places, &mut bearing.lacks);
                    bearing.contacts.extend(contact);
                }
                let open = |contact: &Contact| contact.pitch_radius.is_none() || contact.is_weightless();
                if radius.is_some()
                    && !bearing.contacts.iter().all(|contact| !open(contact))
                    && !bearing.lacks_of_pair()
                {
                    bearing.lacks.push(Lack::Teeth);
                }
                if bearing.mass.is_none() {
                    bearing.lacks.push(Lack::Mass);
                }
                Ok(bearing)
            })
            .collect()
    }

    /// Name of a planet as its gears have it, without the gear.
    #[must_use]
    pub fn planet_name(&self, planet: usize) -> String {
        match (self.planets()[planet].name.as_str(), self.planets().len()) {
            (_, 1) => "planet".to_owned(),
            ("", _) => format!("planet {}", planet + 1),
            (name, _) => format!("planet {name}"),
        }
    }

    /// Shafts that turn with a planet.
    fn shafts_of(&self, planet: usize) -> Vec<usize> {
        let body = self.centrals().len() + planet;
        let is_shaft = |central: &usize| {
            let central = self.centrals()[*central];
            central.kind == CentralKind::PlanetShaft && central.body == body
        };
        (0..self.centrals().len()).filter(is_shaft).collect()
    }

    /// Share of the meshes in the loss of a planet that only passes on power between two central gears.
    fn loss_share(&self, planet: usize) -> Option<f64> {
        let own = |mesh: &&Mesh| mesh.gears.iter().any(|gear| planet_of(*gear) == Some(planet));
        let meshes: Vec<&Mesh> = self.meshes().iter().filter(own).collect();
        let [first, second] = meshes.as_slice() else { return None };
        let with_central = |mesh: &Mesh| mesh.gears.iter().any(|gear| planet_of(*gear).is_none());
        let is_idler = with_central(first) && with_central(second) && self.planets().len() == 1;
        (is_idler && self.shafts_of(planet).is_empty())
            .then(|| MeshEfficiency::share_of_loss(first.efficiency, second.efficiency))
    }

    /// Modules, radii and order of the planets as given, in metres.
    fn given(&self, size: &SetSize) -> Given {
        let mut given = Given::nothing(self);
        given.module = size.module.map(Physical::si);
        for (mesh, own) in size.meshes.iter().enumerate() {
            given.modules[mesh] = own.module.map(Physical::si);
            given.is_behind[mesh] = own.is_behind;
            given.distances[mesh] = own.centre_distance.or(given.distances[mesh]);
        }
        for (planet, own) in size.planets.iter().enumerate() {
            given.radii[planet] = own.carrier_radius.map(Physical::si);
        }
        if let [only] = given.radii.as_mut_slice() {
            *only = only.or(size.carrier_radius.map(Physical::si));
        }
        given
    }

    /// A mesh as this planet feels it, with a working pressure angle of its own; `None` where it is not one
    /// of its own.
    fn contact(
        &self,
        planet: usize,
        mesh: usize,
        pressure_angle: Option<Angle>,
        places: &Places,
        lacks: &mut Vec<Lack>,
    ) -> Option<Contact> {
        if let Some((central, gear)) = central_mesh(self, mesh) {
            if planet_of(gear) != Some(planet) {
                return None;
            }
            let gear_kind = match self.meshes()[mesh].kind {
                MeshKind::Internal => GearKind::Internal,
                _ => GearKind::External,
            };
            let by_k = || {
                self.kind().filter(|kind| *kind == SetKind::Simple)?;
                let k = -self.basic_ratio().get();
                let sun = 2.0 / (1.0 + k);
                Some(if gear_kind == GearKind::Internal { sun * k } else { sun })
            };
            let in_radii = pitch_over_centre_distance(self, mesh).or_else(by_k);
            let pitch_radius =
                places.radii[planet].zip(in_radii).map(|(radius, of)| Length::from_si(radius * of));
            let with = GearOf::Central(central);
            let part = Some(self.torque_from(central, mesh));
            return Some(Contact {
                mesh,
                with,
                gear_kind,
                pitch_radius,
                pressure_angle,
                direction: None,
                part,
            });
        }
        let gears = planet_mesh(self, mesh)?;
        let own = gears.iter().position(|gear| planet_of(*gear) == Some(planet))?;
        let with = gears[1 - own];
        let other = planet_of(with)?;
        let mut contact = Contact {
            mesh,
            with,
            gear_kind: GearKind::External,
            pitch_radius: None,
            pressure_angle: None,
            direction: None,
            part: self.torque_between(planet, mesh),
        };
        match places.pairs[mesh] {
            Ok(pair) => {
                contact.pitch_radius = Some(Length::from_si(pair.pitch_radii[own]));
                let angle_rad = if own == 0 { pair.angle_rad } else { -pair.angle_rad };
                let towards = |radius: f64, other: f64| {
                    let (sin, cos) = libm::sincos(angle_rad);
                    [(other * cos - radius) / pair.distance, other * sin / pair.distance]
                };
                contact.direction =
                    places.radii[planet].zip(places.radii[other]).map(|(own, other)| towards(own, other));
            }
            Err(NoPair::Radius(missing)) if missing == other => {
                lacks.push(Lack::OtherRadius { other });
            }
            Err(NoPair::Distance) => lacks.push(Lack::Distance { other }),
            Err(NoPair::Triangle { mut radii, distance }) => {
                if own == 1 {
                    radii.swap(0, 1);
                }
                lacks.push(Lack::Triangle {
                    other,
                    radii: radii.map(Length::from_si),
                    distance: Length::from_si(distance),
                });
            }
            // The planet's own radius is missing, and said to be.
            Err(NoPair::Radius(_) | NoPair::OtherMesh) => {}
        }
        Some(contact)
    }

    /// Path of the set's power through its meshes.
    pub(crate) fn flows(&self) -> Flows {
        let body = |gear: GearOf| match gear {
            GearOf::Central(central) => self.centrals()[central].body,
            GearOf::Planet(planet, _) => self.centrals().len() + planet,
        };
        Flows {
            speeds: (0..self.centrals().len()).map(|central| self.ratio_between(central, 0)).collect(),
            bodies: self.centrals().iter().map(|central| central.body).collect(),
            meshes: self.meshes().iter().map(|mesh| (mesh.gears.map(body), mesh.efficiency.get())).collect(),
        }
    }

    /// `τ_q·N`: torque on all planets of a kind about their own axes through a mesh with other planets.
    fn torque_between(&self, planet: usize, mesh: usize) -> Option<Part> {
        let g_planet = self.planet_factor(planet)?;
        let is_near = planet_of(self.meshes()[mesh].gears[0]) == Some(planet);
        let sign = if is_near { -1.0 } else { 1.0 };
        Some(Part::Between { mesh, factor: sign / g_planet })
    }

    /// Part of a central gear's torque that goes through one of its meshes.
    fn torque_from(&self, central: usize, mesh: usize) -> Part {
        let gear = GearOf::Central(central);
        let meshes = (0..self.meshes().len()).filter(|&one| self.meshes()[one].gears.contains(&gear));
        let sign = |one: usize| if self.meshes()[one].gears[0] == gear { 1.0 } else { -1.0 };
        let all: Vec<(usize, f64)> = meshes.map(|one| (one, sign(one))).collect();
        if all.len() == 1 { Part::Whole(central) } else { Part::Shared { central, mesh, all } }
    }

    fn planet_mass(&self, planet: usize, size: &SetSize, places: &Places) -> Result<Option<Mass>, Error> {
        let own = size.planets.get(planet);
        if let Some(mass) = own.and_then(|own| own.mass).or(size.planet_mass) {
            return Ok(Some(mass));
        }
        let bore = own.and_then(|own| own.bore).or(size.planet_bore).unwrap_or(Length::from_si(0.0));
        let gears = &self.planets()[planet].gears;
        let width = |gear: usize| {
            let of_gear = own.and_then(|own| own.face_widths.get(gear).copied().flatten());
            of_gear.or(size.face_width.filter(|_| gears.len() == 1))
        };
        if let Some(spec) = self.short().filter(|spec| spec.kind == SetKind::Simple) {
            let Some(width) = width(0) else { return Ok(None) };
            let module = size.meshes.iter().find_map(|mesh| mesh.module).or(size.module);
            if let (Some(module), Some(teeth)) = (module, spec.coaxial_planet()) {
                // The transverse module has less addendum than the normal one.
                let usual = BasicRack::default();
                let cos = libm::cos(spec.tooth_shape.helix_angle(0).si());
                let rack =
                    BasicRack { addendum: usual.addendum * cos, clearance: usual.clearance * cos, ..usual };
                let gear = ToothedGear::new(GearKind::External, module, teeth, rack)?;
                let body = GearBody::external(&gear, width, bore, size.density)?;
                return Ok(Some(body.total().mass));
            }
            let Some(radius) = places.radii[planet] else { return Ok(None) };
            let k = -self.basic_ratio().get();
            let pitch_diameter = Length::from_si(radius * (2.0 * (k - 1.0) / (k + 1.0)));
            return mass::ring(pitch_diameter, bore, width, size.density).map(|disc| Some(disc.mass));
        }
        let mut mass = Mass::default();
        for (gear, teeth) in gears.iter().enumerate() {
            let has = |mesh: &usize| self.meshes()[*mesh].gears.contains(&GearOf::Planet(planet, gear));
            let module = (0..self.meshes().len()).filter(has).find_map(|mesh| places.modules[mesh]);
            let (Some(module), Some(teeth), Some(width)) = (module, teeth, width(gear)) else {
                return Ok(None);
            };
            let gear = ToothedGear::external(Length::from_si(module), *teeth)?;
            mass += GearBody::external(&gear, width, bore, size.density)?.total().mass;
        }
        Ok(Some(mass))
    }
}

impl SetSpec {
    /// The planet's teeth, given or by equal centre distances.
    fn coaxial_planet(&self) -> Option<ToothCount> {
        let Gearing::Teeth(sun, ring) = self.gearing else { return None };
        let between = ring.get().saturating_sub(sun.get());
        self.planet.or_else(|| ToothCount::new(between / 2).ok().filter(|_| between.is_multiple_of(2)))
    }
}

#[cfg(test)]
mod tests;

//! Forces on the bearings of every planet of a set in a gear: what is known of the set's size, and what follows.
//!
//! # Geometry
//! A planet's centre stands at the radius `R` from the main axis. Without profile shift
//!
//! ```text
//! planet and sun     R = m·(z_c + z_p)/2    r_c = R·z_c/(z_c + z_p)
//! planet and ring    R = m·(z_c − z_p)/2    r_c = R·z_c/(z_c − z_p)
//! planets p, q       a = m·(z_p + z_q)/2    r_p = a·z_p/(z_p + z_q)    cos ψ = (R_p² + R_q² − a²)/(2·R_p·R_q)
//! simple set         R = m·(z_a + z_b)/4    r_a = 2·R/(1 + k)          r_b = k·r_a
//! ```
//!
//! A radius that is given goes before that of module and teeth: shifted profiles move the planets. Of several meshes
//! of one planet that say different radii, one with a module of its own goes first, then the first; the pitch radii
//! of the others follow from the common `R`, as in a stepped planet with two modules. Two planets in mesh stand apart
//! by the angle `ψ` about the main axis, the one described later ahead in the positive direction of rotation, unless
//! [`MeshSize::is_behind`] says otherwise: the forces depend on it.
//!
//! # Forces
//! Of `N` planets that carry alike, each feels
//!
//! ```text
//! central gear c      moment T_c/N about the main axis    radial force ±F_c·tan α             + sun, − ring
//! planet shaft w      moment T_w/N
//! planet q            F_q = τ_q/r_p at the pitch point, across the line of centres            |F_q|·tan α apart
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
//! `F_t` is positive in the direction in which all planets together push the carrier, against `T_H`; where `T_H` is
//! nothing, along the positive direction of rotation. So of a set with one planet `F_t = |T_H|/(N·R)`, and in every
//! set `Σ N·F_t·R = |T_H|` over its planets, with losses or without.
//!
//! # Losses
//! The torques of a gear with losses do not balance about a planet's own axis: the model takes the loss of a mesh
//! from the torque and leaves the force at the pitch point, so mesh forces `T_c/(N·r_c)` and the carrier's torque
//! differ by the loss. A planet between two central gears and nothing else hands on what it takes, and its mesh forces
//! `F_c` are those of [`two_mesh_forces`](epicyclic_gears::planet_bearing::two_mesh_forces), which add to `F_t`; elsewhere
//! `F_c = |T_c|/(N·r_c)`. Here the *moments about the main axis* are taken, which balance exactly, so that the bearings
//! hand the carrier what the torques say. The force between two planets follows from the torques of the central gears
//! on both sides of that mesh, `τ_q·g_p·N = ½·(Σ g·T beyond − Σ g·T on this side)`, with `g` the speeds relative to
//! the carrier: without losses both halves are one number; with them it is right within half the set's loss. It needs
//! no motion, so it also holds in a set that turns as a block. A central gear in mesh with planets of two kinds shares
//! its torque among them likewise.
//!
//! # Left out
//! Bevel planets ([`Lack::Bevel`]); the couple of the two planes of a stepped planet, which loads two bearings
//! unequally; what the pins of a planet shaft (K-H-V) press on their disc beyond a pure couple; weight, helix angle,
//! unequal load sharing; the difference between nominal and working pressure angle of shifted profiles.

use crate::compound::CentralKind;
use crate::planet_places::{
    Given, NoPair, Places, central_mesh, pitch_over_centre_distance, places, planet_mesh, planet_of,
};
use crate::planet_set::{GearOf, Mesh, MeshKind, PlanetSet};
use crate::set::{Gearing, SetKind, SetSpec};
use crate::tolerance::NO_TORQUE;
use crate::units::{
    degrees, force, in_metres, kg_per_m3, kilograms, metres, n_m, rad_per_s, radians, torque,
};
use crate::{Gearbox, LinkId, LoadCase, Operation};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::geometry::{GearKind, ToothedGear};
use epicyclic_gears::life::{self, Rolling};
use epicyclic_gears::mass::{self, GearBody};
use epicyclic_gears::planet_bearing::{self, Push};
use epicyclic_gears::{Error, Quantity, ToothCount};
use uom::si::f64::{Angle, AngularVelocity, Force, Length, Mass, MassDensity, Time, Torque};

/// What is known of the size of a set. What is said of all planets or meshes stands for each that says nothing
/// itself.
#[derive(Debug, Clone, PartialEq)]
pub struct SetSize {
    /// Module `m` of the meshes.
    pub module: Option<Length>,
    /// Radius `R` of the planets' centres, of a set with one planet; goes before that of module and teeth. Where
    /// planets differ, each has its own: [`PlanetSize::carrier_radius`].
    pub carrier_radius: Option<Length>,
    /// Face width of a planet with one gear.
    pub face_width: Option<Length>,
    /// Bore of a planet; a solid planet where it is left out.
    pub planet_bore: Option<Length>,
    /// Mass of a planet with what turns about its planet pin; goes before that of its shape.
    pub planet_mass: Option<Mass>,
    /// Basic dynamic load rating of the bearings of one planet together, and what rolls in them.
    pub bearing: Option<(Force, Rolling)>,
    /// Density of the planets.
    pub density: MassDensity,
    /// Working pressure angle `α`.
    pub pressure_angle: Angle,
    /// What single planets have of their own, in the order of [`PlanetSet::planets`]; those at the end may be left
    /// out.
    pub planets: Vec<PlanetSize>,
    /// What single meshes have of their own, in the order of [`PlanetSet::meshes`]; those at the end may be left out.
    pub meshes: Vec<MeshSize>,
}

/// What is known of one planet.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PlanetSize {
    /// Radius `R` of its centre; goes before that of module and teeth.
    pub carrier_radius: Option<Length>,
    /// Face width of each of its gears, in the order of [`Planet::gears`](crate::planet_set::Planet::gears).
    pub face_widths: Vec<Option<Length>>,
    /// Its bore.
    pub bore: Option<Length>,
    /// Its mass with what turns about its planet pin.
    pub mass: Option<Mass>,
    /// Basic dynamic load rating of its bearings together, and what rolls in them.
    pub bearing: Option<(Force, Rolling)>,
}

/// What is known of one mesh.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MeshSize {
    /// Its module, which the other meshes of its two gears have too.
    pub module: Option<Length>,
    /// Of a mesh of two planets: the one described later stands behind the other, not ahead in the positive direction
    /// of rotation.
    pub is_behind: bool,
}

impl Default for SetSize {
    /// Nothing but steel of 7850 kg/m³ and 20°.
    fn default() -> Self {
        Self {
            module: None,
            carrier_radius: None,
            face_width: None,
            planet_bore: None,
            planet_mass: None,
            bearing: None,
            density: kg_per_m3(7850.0),
            pressure_angle: degrees(20.0),
            planets: vec![],
            meshes: vec![],
        }
    }
}

/// What is missing for a force, or why none follows.
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
        /// The other planet, by its place in [`PlanetSet::planets`].
        other: usize,
    },
    /// Module or teeth of the mesh with another planet.
    Distance {
        /// The other planet, by its place in [`PlanetSet::planets`].
        other: usize,
    },
    /// Two planets in mesh that cannot stand at their radii.
    Triangle {
        /// The other planet, by its place in [`PlanetSet::planets`].
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
    /// Its place in [`PlanetSet::meshes`].
    pub mesh: usize,
    /// The gear on the other side.
    pub with: GearOf,
    /// Kind of that gear: a sun or planet is external, a ring internal.
    pub gear_kind: GearKind,
    /// Pitch radius: of a central gear its own, of a mesh with another planet that of this planet's gear.
    pub pitch_radius: Option<Length>,
    /// Towards another planet: unit vector outwards and along the positive direction of rotation.
    pub direction: Option<[f64; 2]>,
    /// For a torque of 1 on each central gear: what of it this mesh brings about the main axis, of a central gear;
    /// `τ_q·N`, of another planet.
    weights: Option<Vec<f64>>,
}

/// The bearing of a planet on its planet pin, as far as it is known.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanetBearing {
    /// Place of its set in [`Gearbox::sets`].
    pub set: usize,
    /// Its place in [`PlanetSet::planets`].
    pub planet: usize,
    /// Its name: `planet` where the set has only one, else `planet long` or `planet 2`.
    pub name: String,
    /// How many of it share the load, all alike.
    pub planets: Option<u32>,
    /// Radius `R` of their centres.
    pub radius: Option<Length>,
    /// Its meshes.
    pub contacts: Vec<Contact>,
    /// Mass of one planet.
    pub mass: Option<Mass>,
    /// Basic dynamic load rating of its bearings together, and what rolls in them.
    pub load_rating: Option<(Force, Rolling)>,
    /// Working pressure angle.
    pub pressure_angle: Angle,
    /// What is missing.
    pub lacks: Vec<Lack>,
    carrier: LinkId,
    /// Members that turn with it.
    shafts: Vec<usize>,
    members: usize,
    is_only: bool,
    /// Part of the loss that the first of its two meshes has, where it has two, both with central gears.
    loss_share: Option<f64>,
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
    /// All together; `None` unless each is known.
    pub total: Option<Force>,
}

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
    /// [`Error::NotPositive`] and the like for an invalid size, [`Error::OutOfRange`] for sizes of more planets,
    /// gears or meshes than the set has.
    #[must_use]
    pub fn planet_bearings(&self, set: usize, size: &SetSize) -> Option<Result<Vec<PlanetBearing>, Error>> {
        let own = self.sets.get(set).filter(|own| !own.is_pair())?;
        Some(own.planet_bearings(set, size))
    }
}

impl PlanetSet {
    fn planet_bearings(&self, place: usize, size: &SetSize) -> Result<Vec<PlanetBearing>, Error> {
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
                    loss_share: self.loss_share(planet),
                };
                if is_bevel {
                    bearing.lacks.push(Lack::Bevel);
                    return Ok(bearing);
                }
                let radius = places.radii[planet];
                bearing.radius = radius.map(metres);
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
                    let contact = self.contact(planet, mesh, &places, &mut bearing.lacks);
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
    pub(crate) fn planet_name(&self, planet: usize) -> String {
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

    /// How the loss of a planet that only hands on power between two central gears is shared by its meshes.
    fn loss_share(&self, planet: usize) -> Option<f64> {
        let own = |mesh: &&Mesh| mesh.gears.iter().any(|gear| planet_of(*gear) == Some(planet));
        let meshes: Vec<&Mesh> = self.meshes().iter().filter(own).collect();
        let [first, second] = meshes.as_slice() else { return None };
        let with_central = |mesh: &Mesh| mesh.gears.iter().any(|gear| planet_of(*gear).is_none());
        let is_idler = with_central(first) && with_central(second) && self.planets().len() == 1;
        (is_idler && self.shafts_of(planet).is_empty())
            .then(|| MeshEfficiency::share_of_loss(first.efficiency, second.efficiency))
    }

    /// What is given of the places, in metres.
    fn given(&self, size: &SetSize) -> Given {
        let mut given = Given::nothing(self);
        given.module = size.module.map(in_metres);
        for (mesh, own) in size.meshes.iter().enumerate() {
            given.modules[mesh] = own.module.map(in_metres);
            given.is_behind[mesh] = own.is_behind;
        }
        for (planet, own) in size.planets.iter().enumerate() {
            given.radii[planet] = own.carrier_radius.map(in_metres);
        }
        if let [only] = given.radii.as_mut_slice() {
            *only = only.or(size.carrier_radius.map(in_metres));
        }
        given
    }

    /// A mesh as this planet feels it; `None` where it is not one of its own.
    fn contact(&self, planet: usize, mesh: usize, places: &Places, lacks: &mut Vec<Lack>) -> Option<Contact> {
        if let Some((central, gear)) = central_mesh(self, mesh) {
            if planet_of(gear) != Some(planet) {
                return None;
            }
            let gear_kind = match self.meshes()[mesh].kind {
                MeshKind::Internal => GearKind::Internal,
                _ => GearKind::External,
            };
            let in_radii = match self.kind() {
                Some(SetKind::Simple) => {
                    let k = -self.basic_ratio().get();
                    let sun = 2.0 / (1.0 + k);
                    Some(if gear_kind == GearKind::Internal { sun * k } else { sun })
                }
                _ => pitch_over_centre_distance(self, mesh),
            };
            let pitch_radius = places.radii[planet].zip(in_radii).map(|(radius, of)| metres(radius * of));
            let with = GearOf::Central(central);
            let weights = Some(self.torque_from(central, mesh));
            return Some(Contact { mesh, with, gear_kind, pitch_radius, direction: None, weights });
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
            direction: None,
            weights: self.torque_between(planet, mesh),
        };
        match places.pairs[mesh] {
            Ok(pair) => {
                contact.pitch_radius = Some(metres(pair.pitch_radii[own]));
                let angle_rad = if own == 0 { pair.angle_rad } else { -pair.angle_rad };
                let towards = |radius: f64, other: f64| {
                    let (sin, cos) = angle_rad.sin_cos();
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
                lacks.push(Lack::Triangle { other, radii: radii.map(metres), distance: metres(distance) });
            }
            // The planet's own radius is missing, and said to be.
            Err(NoPair::Radius(_) | NoPair::OtherMesh) => {}
        }
        Some(contact)
    }

    /// Power that a mesh carries from its first gear's side, over a speed relative to the carrier of 1 of the first
    /// central gear, for a torque of 1 on each central gear: the mean of what both sides say.
    fn through(&self, mesh: usize) -> Vec<f64> {
        let weight = |central: usize| {
            let is_beyond =
                self.tree.place(central).is_some_and(|place| self.tree.behind[mesh].contains(&place));
            self.ratio_between(central, 0) * if is_beyond { -0.5 } else { 0.5 }
        };
        (0..self.centrals().len()).map(weight).collect()
    }

    /// `τ_q·N`: torque on all planets of a kind about their own axes through a mesh with other planets, for a torque of
    /// 1 on each central gear.
    fn torque_between(&self, planet: usize, mesh: usize) -> Option<Vec<f64>> {
        let g_planet = self.planet_factor(planet)?;
        let is_near = planet_of(self.meshes()[mesh].gears[0]) == Some(planet);
        let sign = if is_near { -1.0 } else { 1.0 };
        Some(self.through(mesh).iter().map(|weight| sign * weight / g_planet).collect())
    }

    /// Part of a central gear's torque that goes through one of its meshes, for a torque of 1 on each central gear. All
    /// parts make up the torque; what losses leave open is shared alike.
    fn torque_from(&self, central: usize, mesh: usize) -> Vec<f64> {
        let gear = GearOf::Central(central);
        let meshes: Vec<usize> =
            (0..self.meshes().len()).filter(|&one| self.meshes()[one].gears.contains(&gear)).collect();
        let own = |member: usize| if member == central { 1.0 } else { 0.0 };
        if meshes.len() == 1 {
            return (0..self.centrals().len()).map(own).collect();
        }
        let part = |mesh: usize, member: usize| {
            let sign = if self.meshes()[mesh].gears[0] == gear { 1.0 } else { -1.0 };
            sign * self.through(mesh)[member] / self.ratio_between(central, 0)
        };
        let weight = |member: usize| {
            let all: f64 = meshes.iter().map(|&one| part(one, member)).sum();
            part(mesh, member) + (own(member) - all) / meshes.len() as f64
        };
        (0..self.centrals().len()).map(weight).collect()
    }

    fn planet_mass(&self, planet: usize, size: &SetSize, places: &Places) -> Result<Option<Mass>, Error> {
        let own = size.planets.get(planet);
        if let Some(mass) = own.and_then(|own| own.mass).or(size.planet_mass) {
            return Ok(Some(mass));
        }
        let bore = own.and_then(|own| own.bore).or(size.planet_bore).unwrap_or(metres(0.0));
        let gears = &self.planets()[planet].gears;
        let width = |gear: usize| {
            let of_gear = own.and_then(|own| own.face_widths.get(gear).copied().flatten());
            of_gear.or(size.face_width.filter(|_| gears.len() == 1))
        };
        if let Some(spec) = self.short().filter(|spec| spec.kind == SetKind::Simple) {
            let Some(width) = width(0) else { return Ok(None) };
            let module = size.meshes.iter().find_map(|mesh| mesh.module).or(size.module);
            if let (Some(module), Some(teeth)) = (module, spec.coaxial_planet()) {
                let body =
                    GearBody::external(&ToothedGear::external(module, teeth)?, width, bore, size.density)?;
                return Ok(Some(body.total().mass));
            }
            let Some(radius) = places.radii[planet] else { return Ok(None) };
            let k = -self.basic_ratio().get();
            let pitch_diameter = metres(radius * (2.0 * (k - 1.0) / (k + 1.0)));
            return mass::ring(pitch_diameter, bore, width, size.density).map(|disc| Some(disc.mass));
        }
        let mut mass = Mass::default();
        for (gear, teeth) in gears.iter().enumerate() {
            let has = |mesh: &usize| self.meshes()[*mesh].gears.contains(&GearOf::Planet(planet, gear));
            let module = (0..self.meshes().len()).filter(has).find_map(|mesh| places.modules[mesh]);
            let (Some(module), Some(teeth), Some(width)) = (module, teeth, width(gear)) else {
                return Ok(None);
            };
            let gear = ToothedGear::external(metres(module), *teeth)?;
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

impl SetSize {
    fn check(&self, set: &PlanetSet) -> Result<(), Error> {
        let most = |quantity, given: usize, most: usize| {
            if given <= most {
                return Ok(());
            }
            Err(Error::OutOfRange { quantity, value: given as f64, low: 0.0, high: most as f64, unit: "" })
        };
        most(Quantity::SizedPlanets, self.planets.len(), set.planets().len())?;
        most(Quantity::SizedMeshes, self.meshes.len(), set.meshes().len())?;
        let mut lengths = vec![
            (Quantity::Module, self.module),
            (Quantity::CarrierRadius, self.carrier_radius),
            (Quantity::FaceWidth, self.face_width),
            (Quantity::PlanetBore, self.planet_bore),
        ];
        lengths.extend(self.meshes.iter().map(|mesh| (Quantity::Module, mesh.module)));
        for (own, planet) in self.planets.iter().zip(set.planets()) {
            most(Quantity::SizedFaceWidths, own.face_widths.len(), planet.gears.len())?;
            lengths.push((Quantity::CarrierRadius, own.carrier_radius));
            lengths.push((Quantity::PlanetBore, own.bore));
            lengths.extend(own.face_widths.iter().map(|width| (Quantity::FaceWidth, *width)));
        }
        for (quantity, length) in lengths {
            if let Some(value_m) = length.map(in_metres)
                && !(value_m > 0.0 && value_m.is_finite())
            {
                return Err(Error::NotPositive { quantity, value: value_m * 1e3, unit: "mm" });
            }
        }
        for mass in self.planets.iter().map(|own| own.mass).chain([self.planet_mass]).flatten() {
            let value = kilograms(mass);
            if !(value > 0.0 && value.is_finite()) {
                return Err(Error::NotPositive { quantity: Quantity::PlanetMass, value, unit: "kg" });
            }
        }
        for (load_rating, _) in self.planets.iter().map(|own| own.bearing).chain([self.bearing]).flatten() {
            // The load rating's own limits.
            life::basic_rating_life(Rolling::Balls, load_rating, load_rating, AngularVelocity::default())?;
        }
        // The angle's own limits.
        planet_bearing::radial_force(&[], 1, self.pressure_angle)?;
        Ok(())
    }
}

impl Contact {
    /// Whether it is a mesh with a planet through which the torque is not known.
    fn is_weightless(&self) -> bool {
        planet_of(self.with).is_some() && self.weights.is_none()
    }

    /// Its torque for these on the central gears.
    fn weighed(&self, torques_n_m: &[f64]) -> Option<f64> {
        Some(self.weights.as_ref()?.iter().zip(torques_n_m).map(|(weight, torque)| weight * torque).sum())
    }

    /// Force of another planet on this one, outwards and along the positive direction, N; and its moment about the
    /// main axis, N·m.
    fn of_planet(
        &self,
        torques_n_m: &[f64],
        count: f64,
        tan_alpha: f64,
        radius_m: f64,
    ) -> Option<([f64; 2], f64)> {
        let [out, along] = self.direction?;
        let about_own_n_m = self.weighed(torques_n_m)? / count;
        let across_n = about_own_n_m / in_metres(self.pitch_radius?);
        let apart_n = across_n.abs() * tan_alpha;
        let outwards_n = -across_n * along - apart_n * out;
        let along_n = across_n * out - apart_n * along;
        Some(([outwards_n, along_n], radius_m * along_n + about_own_n_m))
    }
}

impl PlanetBearing {
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
        let of_input =
            |torques: &Vec<f64>| torques.iter().map(|of| torque(of / case.input)).collect::<Vec<_>>();
        let torques = case.members.get(self.set).and_then(Option::as_ref).map(of_input);
        self.forces(torques.as_deref(), None)
    }

    /// The forces of these torques on the members of the set, in the order of [`PlanetSet::members`], at this speed of
    /// the carrier.
    ///
    /// # Errors
    /// Those of [`epicyclic_gears::planet_bearing`]; [`Error::OutOfRange`] for a number of torques other than that of the
    /// members.
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
            let of_centrals: Vec<f64> = centrals.iter().map(|torque| n_m(*torque)).collect();
            let between = self.between(&of_centrals, planets, radius);
            let push = |contact: &Contact| {
                if planet_of(contact.with).is_some() {
                    return None;
                }
                let torque = contact.weighed(&of_centrals).map(torque);
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
                        let meshes = [0, 1].map(|mesh| (pair[mesh].kind, meshes[mesh]));
                        planet_bearing::radial_force_of(&meshes, self.pressure_angle)?
                    }
                    _ => planet_bearing::radial_force(&pushes, planets, self.pressure_angle)?,
                };
                forces.radial = Some(of_centrals + force(outwards_n));
            }
            forces.tangential = if self.is_only {
                Some(of_carrier)
            } else {
                between.map(|[_, moment_n_m]| {
                    let gears = self.contacts.iter().filter(|contact| planet_of(contact.with).is_none());
                    let of_gears: f64 = gears.filter_map(|gear| gear.weighed(&of_centrals)).sum();
                    let own = of_gears + self.shafts.iter().map(|&shaft| of_centrals[shaft]).sum::<f64>();
                    let largest = of_centrals.iter().fold(0.0_f64, |most, torque| most.max(torque.abs()));
                    let is_against = n_m(*carrier) > NO_TORQUE * largest;
                    let along_n = (own / f64::from(planets) + moment_n_m) / in_metres(radius);
                    force(if is_against { -along_n } else { along_n })
                })
            };
        }
        forces.centrifugal = match (self.mass, carrier_speed) {
            (_, Some(speed)) if rad_per_s(speed) == 0.0 => Some(Force::default()),
            (Some(mass), Some(speed)) => Some(planet_bearing::centrifugal_force(mass, radius, speed)?),
            _ => None,
        };
        forces.total = forces.tangential.zip(forces.radial.zip(forces.centrifugal)).map(
            |(tangential, (radial, centrifugal))| planet_bearing::resultant(tangential, radial + centrifugal),
        );
        Ok(forces)
    }

    /// What other planets in mesh do to it: force outwards, N, and moment about the main axis, N·m.
    fn between(&self, torques_n_m: &[f64], planets: u32, radius: Length) -> Option<[f64; 2]> {
        let (count, tan_alpha) = (f64::from(planets), radians(self.pressure_angle).tan());
        let meshing = self.contacts.iter().filter(|contact| planet_of(contact.with).is_some());
        meshing.into_iter().try_fold([0.0, 0.0], |[out, about], contact| {
            let ([outwards_n, _], moment_n_m) =
                contact.of_planet(torques_n_m, count, tan_alpha, in_metres(radius))?;
            Some([out + outwards_n, about + moment_n_m])
        })
    }

    /// Whether the places of planets in mesh are missing, and said to be.
    fn lacks_of_pair(&self) -> bool {
        let of_pair = |lack: &Lack| {
            matches!(lack, Lack::OtherRadius { .. } | Lack::Distance { .. } | Lack::Triangle { .. })
        };
        self.lacks.iter().any(of_pair)
    }

    /// Basic rating life of the bearings under this force, at this speed of the planet relative to the carrier.
    ///
    /// # Errors
    /// Those of [`basic_rating_life`](life::basic_rating_life).
    pub fn life(&self, force: Force, planet_on_carrier: AngularVelocity) -> Result<Option<Time>, Error> {
        let Some((load_rating, rolling)) = self.load_rating else { return Ok(None) };
        life::basic_rating_life(rolling, load_rating, force, planet_on_carrier)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::set::{MeshLoss, SetSpec};
    use crate::units::{angular_velocity, torque};
    use uom::si::{force::newton, length::millimeter, mass::kilogram};

    fn mm(value: f64) -> Length {
        Length::new::<millimeter>(value)
    }

    fn gearbox(set: SetSpec) -> Gearbox {
        Gearbox::builder("one set")
            .links(["a", "b", "H"])
            .set(set)
            .brake("K", "b")
            .input("a")
            .output("H")
            .gear("1", ["K"])
            .build()
            .unwrap()
    }

    fn only(gearbox: &Gearbox, size: &SetSize) -> PlanetBearing {
        let mut bearings = gearbox.planet_bearings(0, size).unwrap().unwrap();
        assert_eq!(bearings.len(), 1);
        bearings.remove(0)
    }

    fn teeth(count: u32) -> ToothCount {
        ToothCount::new(count).unwrap()
    }

    /// Sun 20, planet 20, ring 60, module 3 mm: r_w = 60 mm, r_a = 30 mm, r_b = 90 mm; 100 N·m on the sun.
    #[test]
    fn a_simple_set_by_hand() {
        let set = SetSpec::teeth("P", SetKind::Simple, ["a", "b", "H"], 20, 60).unwrap().planet_count(3);
        let gearbox = gearbox(set);
        let size = SetSize {
            module: Some(mm(3.0)),
            planet_mass: Some(Mass::new::<kilogram>(0.5)),
            ..SetSize::default()
        };
        let bearing = only(&gearbox, &size);
        assert_eq!(bearing.lacks, []);
        assert!((in_metres(bearing.radius.unwrap()) - 0.06).abs() < 1e-15);
        let forces =
            bearing.forces(Some(&[100.0, 300.0, -400.0].map(torque)), Some(angular_velocity(100.0))).unwrap();
        let newtons = |force: Option<Force>| force.unwrap().get::<newton>();
        // 400/(3·0.06) = 2·100/(3·0.03); 0.5·0.06·100².
        assert!((newtons(forces.tangential) - 20_000.0 / 9.0).abs() < 1e-9);
        assert!(newtons(forces.radial).abs() < 1e-9);
        assert!((newtons(forces.centrifugal) - 300.0).abs() < 1e-9);
        assert!((newtons(forces.total) - (20_000.0_f64 / 9.0).hypot(300.0)).abs() < 1e-9);
    }

    #[test]
    fn without_a_size_the_lacks_are_named() {
        let gearbox = gearbox(SetSpec::simple("P", ["a", "b", "H"], 3.0));
        let bearing = only(&gearbox, &SetSize::default());
        assert_eq!(bearing.lacks, [Lack::Planets, Lack::Radius, Lack::Mass]);
        assert_eq!(bearing.forces(Some(&[torque(1.0); 3]), None).unwrap(), BearingForces::default());
        let refused =
            gearbox.planet_bearings(0, &SetSize { module: Some(mm(-1.0)), ..SetSize::default() }).unwrap();
        assert_eq!(refused.unwrap_err().to_string(), "module is -1 mm; it must be finite and above 0");
        let double = SetSpec::teeth("P", SetKind::DoublePlanet, ["a", "b", "H"], 20, 60).unwrap();
        let gearbox = self::gearbox(double);
        let size = SetSize { carrier_radius: Some(mm(50.0)), ..SetSize::default() };
        let bearings = gearbox.planet_bearings(0, &size).unwrap().unwrap();
        let radius_of_other = Lack::OtherRadius { other: 0 };
        let first = [Lack::Planets, Lack::CommonRadius, Lack::Radius, Lack::Mass];
        assert_eq!(bearings[0].lacks, first);
        // The planets' teeth are missing, so no size helps but the radii; then the distance is missing.
        let own = |radius| PlanetSize { carrier_radius: Some(mm(radius)), ..PlanetSize::default() };
        let size = SetSize { planets: vec![PlanetSize::default(), own(60.0)], ..SetSize::default() };
        let bearings = gearbox.planet_bearings(0, &size).unwrap().unwrap();
        assert_eq!(bearings[0].lacks, [Lack::Planets, Lack::Radius, Lack::Mass]);
        assert_eq!(bearings[1].lacks, [Lack::Planets, radius_of_other, Lack::Mass]);
        let size = SetSize { planets: vec![own(50.0), own(60.0)], ..SetSize::default() };
        let bearings = gearbox.planet_bearings(0, &size).unwrap().unwrap();
        let distance = Lack::Distance { other: 1 };
        assert_eq!(bearings[0].lacks, [Lack::Planets, distance, Lack::Mass]);
        let bevel = SetSpec::teeth("P", SetKind::Bevel, ["a", "b", "H"], 20, 60).unwrap();
        assert_eq!(only(&self::gearbox(bevel), &SetSize::default()).lacks, [Lack::Bevel]);
    }

    #[test]
    fn teeth_and_ratio_give_the_same_planet() {
        let by_k = gearbox(SetSpec::simple("P", ["a", "b", "H"], 3.0).planet_count(3));
        let by_teeth =
            gearbox(SetSpec::teeth("P", SetKind::Simple, ["a", "b", "H"], 20, 60).unwrap().planet_count(3));
        let width = Some(mm(30.0));
        let size = SetSize { carrier_radius: Some(mm(60.0)), face_width: width, ..SetSize::default() };
        let one = only(&by_k, &size);
        let size = SetSize { module: Some(mm(3.0)), face_width: width, ..SetSize::default() };
        let other = only(&by_teeth, &size);
        assert_eq!(one.contacts, other.contacts);
        // A disc of the pitch diameter against a body to the root and half a tooth zone: within an eighth.
        let ratio = (one.mass.unwrap() / other.mass.unwrap()).value;
        assert!((ratio - 1.0).abs() < 0.125, "{ratio}");
    }

    /// The tangential force is that of the meshes too: F_1·r_1 and F_2·r_2 make up T_H, for each kind.
    #[test]
    fn stepped_planets_turn_about_the_axis_as_the_meshes_push_them() {
        for (kind, [z1, z2], [g, f]) in [
            (SetKind::SteppedSunRing, [20, 80], [40, 20]),
            (SetKind::SteppedSuns, [20, 30], [40, 30]),
            (SetKind::SteppedRings, [100, 90], [40, 30]),
        ] {
            let set = SetSpec::teeth("P", kind, ["a", "b", "H"], z1, z2).unwrap();
            let set = set.planet_teeth(teeth(g), Some(teeth(f))).planet_count(4);
            let gearbox = gearbox(set);
            let ideal = gearbox.analyze("1").unwrap().ideal().unwrap().members[0].clone().unwrap();
            let size = SetSize { module: Some(mm(2.0)), ..SetSize::default() };
            let bearing = only(&gearbox, &size);
            assert_eq!(bearing.lacks, [Lack::Mass], "{kind}");
            let [r1, r2] = [0, 1].map(|mesh: usize| bearing.contacts[mesh].pitch_radius.unwrap());
            let radius = in_metres(bearing.radius.unwrap());
            // No moment about the planet's own axis: the forces stand as the inverse steps.
            let (f1, f2) = (ideal[0] / (4.0 * in_metres(r1)), ideal[1] / (4.0 * in_metres(r2)));
            let torques: Vec<Torque> = ideal.iter().copied().map(torque).collect();
            let force = bearing.forces(Some(&torques), None).unwrap().tangential.unwrap();
            assert!((force.get::<newton>() - (f1 + f2).abs()).abs() < 1e-9 * f1.abs(), "{kind}");
            assert!((f1 + f2 + ideal[2] / (4.0 * radius)).abs() < 1e-9 * f1.abs(), "{kind}");
        }
    }

    #[test]
    fn losses_leave_a_little_of_the_radial_forces() {
        let eta = MeshEfficiency::new(0.97).unwrap();
        let set = SetSpec::simple("P", ["a", "b", "H"], 3.0).with_loss(MeshLoss::Set(eta)).planet_count(3);
        let gearbox = gearbox(set);
        let members = gearbox.analyze("1").unwrap().driving().unwrap().members[0].clone().unwrap();
        let size = SetSize { carrier_radius: Some(mm(60.0)), ..SetSize::default() };
        let bearing = only(&gearbox, &size);
        let torques: Vec<Torque> = members.into_iter().map(torque).collect();
        let forces = bearing.forces(Some(&torques), None).unwrap();
        let share = forces.radial.unwrap() / forces.tangential.unwrap();
        // F_a − F_b = 0.03·F_a of F_a + F_b.
        assert!((share.value - 20_f64.to_radians().tan() * 0.03 / 1.97).abs() < 1e-3, "{}", share.value);
    }

    /// Sun 20, planets 20 and 20, ring 60, module 2 mm: all centres 40 mm apart and 40 mm from the axis, ψ = 60°.
    fn double() -> (SetSpec, SetSize) {
        let set = SetSpec::teeth("P", SetKind::DoublePlanet, ["a", "b", "H"], 20, 60).unwrap();
        let size = SetSize { module: Some(mm(2.0)), ..SetSize::default() };
        (set.planet_teeth(teeth(20), Some(teeth(20))).planet_count(3), size)
    }

    #[test]
    fn a_double_planet_by_hand() {
        let (set, size) = double();
        let gearbox = gearbox(set);
        let bearings = gearbox.planet_bearings(0, &size).unwrap().unwrap();
        assert_eq!([&*bearings[0].name, &*bearings[1].name], ["planet 1", "planet 2"]);
        // i₀ = 3: 100 N·m on the sun, −300 on the ring, 200 on the carrier.
        let torques = [100.0, -300.0, 200.0].map(torque);
        // Every mesh carries F = 100/(3·0.02) N.
        let f = 100.0 / 0.06;
        let (sin, cos) = 60_f64.to_radians().sin_cos();
        let s = f * 20_f64.to_radians().tan();
        // Planet 1 in (outwards, along): the sun (s, f); planet 2 in the direction u = (−cos, sin) with f across,
        // (−sin, −cos), and s against u. The carrier's torque is positive, so its direction is −1.
        let expected = [
            [s - f * sin + s * cos, -(f - f * cos - s * sin)],
            [-s + f * sin + s * cos, -(-f - f * cos + s * sin)],
        ];
        for (bearing, [radial, tangential]) in bearings.iter().zip(expected) {
            assert_eq!(bearing.lacks, [Lack::Mass]);
            let forces = bearing.forces(Some(&torques), None).unwrap();
            assert!((forces.radial.unwrap().get::<newton>() - radial).abs() < 1e-9);
            assert!((forces.tangential.unwrap().get::<newton>() - tangential).abs() < 1e-9);
        }
        // The other way round the along parts of the separating forces change sides.
        let meshes = vec![MeshSize::default(), MeshSize { is_behind: true, ..MeshSize::default() }];
        let bearings = gearbox.planet_bearings(0, &SetSize { meshes, ..size }).unwrap().unwrap();
        let forces = bearings[0].forces(Some(&torques), None).unwrap();
        assert!((forces.radial.unwrap().get::<newton>() - (s + f * sin + s * cos)).abs() < 1e-9);
        assert!((forces.tangential.unwrap().get::<newton>() + (f - f * cos + s * sin)).abs() < 1e-9);
    }

    #[test]
    fn planets_that_cannot_stand_so_far_apart_are_named() {
        let (set, size) = double();
        let gearbox = gearbox(set);
        let own = PlanetSize { carrier_radius: Some(mm(81.0)), ..PlanetSize::default() };
        let bearings = gearbox.planet_bearings(0, &SetSize { planets: vec![own], ..size }).unwrap().unwrap();
        let Lack::Triangle { other: 1, radii, distance } = bearings[0].lacks[0] else {
            unreachable!("{:?}", bearings[0].lacks)
        };
        let in_mm = [radii[0], radii[1], distance].map(|length| (1e3 * in_metres(length)).round());
        assert_eq!(in_mm, [81.0, 40.0, 40.0]);
        let torques = [100.0, -300.0, 200.0].map(torque);
        let forces = bearings[1].forces(Some(&torques), Some(angular_velocity(0.0))).unwrap();
        assert_eq!((forces.tangential, forces.radial, forces.total), (None, None, None));
        assert_eq!(forces.centrifugal, Some(Force::default()));
        let refused = bearings[1].forces(Some(&torques[..2]), None).unwrap_err();
        assert!(matches!(refused, Error::OutOfRange { quantity: Quantity::MemberTorques, .. }));
    }

    #[test]
    fn masses_follow_from_the_shape_of_every_planet_with_one_width() {
        let (set, size) = double();
        let size = SetSize { face_width: Some(mm(20.0)), planet_bore: Some(mm(10.0)), ..size };
        let body = |module_mm: f64| {
            let gear = ToothedGear::external(mm(module_mm), teeth(20)).unwrap();
            GearBody::external(&gear, mm(20.0), mm(10.0), size.density).unwrap().total().mass
        };
        let bearings = gearbox(set).planet_bearings(0, &size).unwrap().unwrap();
        assert!(bearings.iter().all(|bearing| bearing.mass == Some(body(2.0)) && bearing.lacks.is_empty()));
        // Of a stepped planet each step has its width and module: here 2 mm and 2·60/40 mm.
        let set = SetSpec::teeth("P", SetKind::SteppedSuns, ["a", "b", "H"], 40, 20).unwrap();
        let set = set.planet_teeth(teeth(20), Some(teeth(20))).planet_count(3);
        let gearbox = gearbox(set);
        assert_eq!(only(&gearbox, &size).lacks, [Lack::Mass]);
        let own = PlanetSize { face_widths: vec![Some(mm(20.0)); 2], ..PlanetSize::default() };
        let meshes = vec![MeshSize { module: Some(mm(2.0)), is_behind: false }];
        let stepped = SetSize { module: None, planets: vec![own], meshes, ..size.clone() };
        let mass = only(&gearbox, &stepped).mass.unwrap();
        assert!(((mass / (body(2.0) + body(3.0))).value - 1.0).abs() < 1e-12);
    }

    /// Power through each mesh from torques alone, against that of the power flow: a Ravigneaux set in its second gear.
    #[test]
    fn torques_say_what_the_power_flow_says_of_each_mesh() {
        let eta = MeshEfficiency::new(0.98).unwrap();
        let set = crate::compound::CompoundSpec::new("R", "H")
            .sun("a", 30)
            .sun("c", 36)
            .ring("b", 72)
            .planet("short", &[15])
            .planet("long", &[18])
            .mesh("a", "short", eta)
            .mesh("short", "long", eta)
            .mesh("c", "long", eta)
            .mesh("long", "b", eta);
        let gearbox = Gearbox::builder("second")
            .links(["a", "b", "c", "H"])
            .compound_set(set)
            .brake("K", "c")
            .input("a")
            .output("b")
            .gear("2", ["K"])
            .build()
            .unwrap();
        let found = gearbox.analyze("2").unwrap();
        let set = &gearbox.sets()[0];
        let first = found.sets()[0].relative.unwrap();
        for case in [found.ideal().unwrap(), found.driving().unwrap()] {
            let power = case.power.sets[0].as_ref().unwrap();
            for (mesh, flow) in case.meshes(&gearbox, 0).unwrap().iter().enumerate() {
                let torques = case.members[0].as_ref().unwrap();
                let through: f64 =
                    set.through(mesh).iter().zip(torques).map(|(weight, torque)| weight * torque).sum();
                let middle = f64::from(flow.sense) * (flow.enters + flow.leaves) / 2.0;
                assert!((through * first - middle).abs() <= power.loss / 2.0 + 1e-12, "{mesh}");
            }
        }
    }
}

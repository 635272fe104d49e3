//! Keys of a gearbox file for the vibration of its sets: bodies, bearings, supports, stiffness of meshes.

use super::per_gear::MESHES;
use super::{DescriptionError, Gears, PerGear};
use crate::Path;
use crate::faults::Faults;
use epicyclic_gears::geometry::GearKind;
use epicyclic_train::set::SetKind;
use epicyclic_units::Quantity;
use epicyclic_units::TorsionalStiffness;
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use uom::si::f64::{Angle, AngularVelocity, Length, Mass, MomentOfInertia, Ratio, SurfaceTension};

/// A stiffness, N/m.
pub type Stiffness = SurfaceTension;

/// Data for the vibration of the whole gearbox besides its sets, and its excitation.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VibrationOfGearbox {
    /// Inertias of links beside the members of sets: of motors, machines, couplings.
    #[serde(default)]
    pub link_inertias: BTreeMap<String, Quantity<MomentOfInertia>>,
    /// Ties that are springs.
    #[serde(default)]
    pub shafts: Vec<ShaftEntry>,
    /// Least and greatest speed of the input, for resonances and forces. An option gives others.
    #[serde(default)]
    pub speeds: Option<[Quantity<AngularVelocity>; 2]>,
    /// Number of harmonics of the meshes. Default 3.
    #[serde(default)]
    pub harmonics: Option<u32>,
    /// Amplitudes of the transmission error of the meshes, the first harmonic first.
    #[serde(default)]
    pub transmission_error: Vec<Quantity<Length>>,
    /// Transmission error of the ring's meshes, if it differs.
    #[serde(default)]
    pub ring_transmission_error: Vec<Quantity<Length>>,
    /// Damping ratio of every mode, for the forces that transmission errors make.
    #[serde(default)]
    pub damping: Option<Quantity<Ratio>>,
}

/// A tie that is a shaft.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShaftEntry {
    /// Name of the shaft.
    pub id: String,
    /// The two links, which `ties` join.
    pub between: [String; 2],
    /// Torsional stiffness.
    pub stiffness: Quantity<TorsionalStiffness>,
    /// Lateral stiffness between the centres of the two links, for their motion in the plane. Default:
    /// none.
    #[serde(default)]
    pub lateral_stiffness: Option<Quantity<Stiffness>>,
}

/// Data for the vibration of a set besides its teeth, modules, face widths and planets.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VibrationEntry {
    /// The sun of a set whose gear is called so.
    #[serde(default)]
    pub sun: SunEntry,
    /// The ring of a set whose gear is called so.
    #[serde(default)]
    pub ring: RingEntry,
    /// The carrier without planets.
    #[serde(default)]
    pub carrier: CarrierEntry,
    /// A planet of a set with one kind of planets; its mass is `planet_mass` of the set, or that of its
    /// shape.
    #[serde(default)]
    pub planet: PlanetEntry,
    /// The bodies of any set but the carrier: central gears by their names as gears, planets by the names of
    /// planets.
    #[serde(default)]
    pub bodies: BTreeMap<String, BodyEntry>,
    /// Radial stiffness of the bearings of one planet together. Needed by a set with planets.
    #[serde(default)]
    pub planet_bearing: Option<Quantity<Stiffness>>,
    /// Read as `planet_angles` of the set, where files before version 2 have them; a file gives one of the
    /// two.
    #[serde(default)]
    pub planet_angles: Option<Vec<Quantity<Angle>>>,
    /// Stiffness of each mesh along the line of action: in the order from sun to ring, or by the names of its
    /// gears, `sun-planet`. Default: `c_γα·b` by ISO 6336.
    #[serde(default)]
    pub mesh_stiffness: Option<PerGear<Quantity<Stiffness>>>,
    /// Transverse working pressure angle of each mesh, given as its stiffness. Default: those of the teeth.
    #[serde(default)]
    pub pressure_angles: Option<PerGear<Quantity<Angle>>>,
    /// Base radius of each gear. Default: those of the teeth.
    #[serde(default)]
    pub base_radii: Option<PerGear<Quantity<Length>>>,
}

/// Data for the vibration of a compound set.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompoundVibrationEntry {
    /// The carrier without planets.
    #[serde(default)]
    pub carrier: CarrierEntry,
    /// The other bodies: central gears and planets by their names.
    #[serde(default)]
    pub bodies: BTreeMap<String, BodyEntry>,
    /// Radial stiffness of the bearings of one planet together.
    #[serde(default)]
    pub planet_bearing: Option<Quantity<Stiffness>>,
    /// Stiffness of meshes along the line of action, by the names of their gears: `small_sun-short`. Default:
    /// `c_γα·b` by ISO 6336.
    #[serde(default)]
    pub mesh_stiffness: Option<PerGear<Quantity<Stiffness>>>,
    /// Transverse working pressure angles of meshes, by the names of their gears. Default: those of the
    /// teeth.
    #[serde(default)]
    pub pressure_angles: Option<PerGear<Quantity<Angle>>>,
    /// Base radii of gears. Default: those of the teeth.
    #[serde(default)]
    pub base_radii: Option<PerGear<Quantity<Length>>>,
}

impl From<CompoundVibrationEntry> for VibrationEntry {
    fn from(entry: CompoundVibrationEntry) -> Self {
        let CompoundVibrationEntry {
            carrier,
            bodies,
            planet_bearing,
            mesh_stiffness,
            pressure_angles,
            base_radii,
        } = entry;
        Self {
            carrier,
            bodies,
            planet_bearing,
            mesh_stiffness,
            pressure_angles,
            base_radii,
            ..Self::default()
        }
    }
}

/// Bodies and meshes of a set, by the names that keys know.
#[derive(Debug, Clone, PartialEq)]
pub struct Vibrating {
    /// Central gears and planets; a stepped planet is one body.
    pub bodies: Gears,
    /// Meshes: the names of both gears, joined by a hyphen.
    pub meshes: Gears,
    /// Names of the bodies that are planets.
    pub planets: Vec<String>,
}

impl Vibrating {
    /// Bodies and meshes of a kind of set.
    #[must_use]
    pub fn of_kind(kind: SetKind) -> Self {
        let gears = Gears::of_kind(kind);
        let meshes = Gears::meshes_of_kind(kind).into_iter().map(|pair| pair.join("-")).collect();
        let (mut names, mut kinds) = (gears.names, gears.kinds);
        if kind.is_stepped() {
            // The two steps of the planet are one body.
            names.splice(1..3, ["planet".to_owned()]);
            kinds.remove(1);
        }
        let planets = names[1..names.len() - 1].to_vec();
        let bodies = Gears { names, kinds, has_order: true, of: "bodies" };
        let meshes = Gears { names: meshes, kinds: vec![], has_order: true, of: MESHES };
        Self { bodies, meshes, planets }
    }
}

impl VibrationEntry {
    /// A body beside the carrier, by its name.
    #[must_use]
    pub fn body(&self, name: &str) -> BodyEntry {
        match name {
            "sun" if self.sun != SunEntry::default() => self.sun.clone().into(),
            "ring" if self.ring != RingEntry::default() => self.ring.clone().into(),
            "planet" if self.planet != PlanetEntry::default() => self.planet.clone().into(),
            _ => self.bodies.get(name).cloned().unwrap_or_default(),
        }
    }

    /// Keys of the entry at which a body is described.
    #[must_use]
    pub fn keys_of<'n>(&self, name: &'n str) -> Vec<&'n str> {
        match name {
            "sun" | "ring" | "planet" if !self.bodies.contains_key(name) => vec!["vibration", name],
            "carrier" => vec!["vibration", name],
            _ => vec!["vibration", "bodies", name],
        }
    }

    /// Finds names of gears, meshes and bodies that the set has not, and bodies described twice.
    pub(super) fn check(&self, set: &str, gears: &Gears, vibrating: &Vibrating, faults: &mut Faults) {
        let at = |key: &str| Path::root().key("vibration").key(key);
        let Vibrating { bodies, meshes, planets } = vibrating;
        if let Some(radii) = &self.base_radii {
            gears.check(set, (at("base_radii"), "base_radii"), radii, faults);
        }
        if let Some(stiffness) = &self.mesh_stiffness {
            meshes.check(set, (at("mesh_stiffness"), "mesh_stiffness"), stiffness, faults);
        }
        if let Some(angles) = &self.pressure_angles {
            meshes.check(set, (at("pressure_angles"), "pressure_angles"), angles, faults);
        }
        for name in self.bodies.keys().filter(|name| !bodies.names.contains(name)) {
            faults.push(at("bodies").key(name), bodies.unknown(set, "bodies", name));
        }
        let own = [
            ("sun", self.sun != SunEntry::default()),
            ("ring", self.ring != RingEntry::default()),
            ("planet", self.planet != PlanetEntry::default()),
        ];
        for (name, _) in own.into_iter().filter(|one| one.1) {
            if !bodies.names.iter().any(|body| body == name) {
                faults.push(at(name), bodies.unknown(set, "vibration", name));
            } else if self.bodies.contains_key(name) {
                let twice = DescriptionError::Twice { set: set.to_owned(), first: name, second: "bodies" };
                faults.push(at("bodies").key(name), twice);
            }
        }
        for (name, kind) in bodies.names.iter().zip(&bodies.kinds) {
            let Some(body) = self.bodies.get(name) else { continue };
            let is_planet = planets.contains(name);
            let is_ring = *kind == Some(GearKind::Internal);
            let own = [
                ("bore", body.bore.is_some(), !is_planet && !is_ring, "external central gears"),
                ("outside_diameter", body.outside_diameter.is_some(), is_ring, "rings"),
                ("support", body.support.is_some(), !is_planet, "central gears"),
                ("tangential_support", body.tangential_support.is_some(), !is_planet, "central gears"),
                ("bearing", body.bearing.is_some(), is_planet, "planets"),
            ];
            for (key, _, _, of) in own.into_iter().filter(|(_, is_given, applies, _)| *is_given && !applies) {
                let (set, body) = (set.to_owned(), name.clone());
                let at = at("bodies").key(name).key(key);
                faults.push(at, DescriptionError::BodyKey { set, body, key, of });
            }
        }
        // Gears on fixed axes have neither planets nor a carrier of their own.
        let is_pair = planets.is_empty();
        let none = [
            ("carrier", self.carrier != CarrierEntry::default()),
            ("planet_bearing", self.planet_bearing.is_some()),
        ];
        for (key, _) in none.into_iter().filter(|one| is_pair && one.1) {
            faults.push(at(key), bodies.unknown(set, "vibration", key));
        }
    }
}

/// A central gear or planet as a body.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BodyEntry {
    /// Mass. Default: that of the shape; of a planet that which the set gives.
    #[serde(default)]
    pub mass: Option<Quantity<Mass>>,
    /// Inertia with all that turns with the body. Default: that of the shape.
    #[serde(default)]
    pub inertia: Option<Quantity<MomentOfInertia>>,
    /// In place of the inertia: `I/r_b²`, of a stepped planet with the base radius of its first gear.
    #[serde(default)]
    pub rotary_mass: Option<Quantity<Mass>>,
    /// Of external central gears, for the shape: diameter of the bore. Default: solid.
    #[serde(default)]
    pub bore: Option<Quantity<Length>>,
    /// Of rings, for the shape: outside diameter.
    #[serde(default)]
    pub outside_diameter: Option<Quantity<Length>>,
    /// Of central gears: radial stiffness of the bearings; 0 of a floating gear. Default: rigid.
    #[serde(default)]
    pub support: Option<Quantity<Stiffness>>,
    /// Of central gears: stiffness of what holds them against rotation in gears in which their links are
    /// held, torsional stiffness over `r_b²`. Default: rigid.
    #[serde(default)]
    pub tangential_support: Option<Quantity<Stiffness>>,
    /// Of planets: radial stiffness of the bearings of one, where it is not `planet_bearing`.
    #[serde(default)]
    pub bearing: Option<Quantity<Stiffness>>,
}

impl From<SunEntry> for BodyEntry {
    fn from(sun: SunEntry) -> Self {
        let SunEntry { mass, inertia, rotary_mass, bore, support, tangential_support } = sun;
        Self { mass, inertia, rotary_mass, bore, support, tangential_support, ..Self::default() }
    }
}

impl From<RingEntry> for BodyEntry {
    fn from(ring: RingEntry) -> Self {
        let RingEntry { mass, inertia, rotary_mass, outside_diameter, support, tangential_support } = ring;
        Self { mass, inertia, rotary_mass, outside_diameter, support, tangential_support, ..Self::default() }
    }
}

impl From<CarrierEntry> for BodyEntry {
    fn from(carrier: CarrierEntry) -> Self {
        let CarrierEntry { mass, inertia, rotary_mass, support, tangential_support } = carrier;
        Self { mass, inertia, rotary_mass, support, tangential_support, ..Self::default() }
    }
}

impl From<PlanetEntry> for BodyEntry {
    fn from(PlanetEntry { inertia, rotary_mass }: PlanetEntry) -> Self {
        Self { inertia, rotary_mass, ..Self::default() }
    }
}

/// The sun as a body.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SunEntry {
    /// Mass. Default: that of the shape.
    #[serde(default)]
    pub mass: Option<Quantity<Mass>>,
    /// Inertia with all that turns with the body. Default: that of the shape.
    #[serde(default)]
    pub inertia: Option<Quantity<MomentOfInertia>>,
    /// In place of the inertia: the inertia over the square of the base radius, `I/r_b²`.
    #[serde(default)]
    pub rotary_mass: Option<Quantity<Mass>>,
    /// Diameter of its bore, for its shape. Default: solid.
    #[serde(default)]
    pub bore: Option<Quantity<Length>>,
    /// Radial stiffness of its bearings; 0 of a floating sun. Default: rigid.
    #[serde(default)]
    pub support: Option<Quantity<Stiffness>>,
    /// Stiffness of what holds it against rotation in gears in which its link is held: torsional stiffness
    /// over `r_b²`. Default: rigid.
    #[serde(default)]
    pub tangential_support: Option<Quantity<Stiffness>>,
}

/// The ring as a body.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RingEntry {
    /// Mass. Default: that of the shape.
    #[serde(default)]
    pub mass: Option<Quantity<Mass>>,
    /// Inertia with all that turns with the body. Default: that of the shape.
    #[serde(default)]
    pub inertia: Option<Quantity<MomentOfInertia>>,
    /// In place of the inertia: `I/r_b²`.
    #[serde(default)]
    pub rotary_mass: Option<Quantity<Mass>>,
    /// Outside diameter, for the shape.
    #[serde(default)]
    pub outside_diameter: Option<Quantity<Length>>,
    /// Radial stiffness of its bearings or fixing; 0 of a floating ring. Default: rigid.
    #[serde(default)]
    pub support: Option<Quantity<Stiffness>>,
    /// Stiffness of what holds it against rotation in gears in which its link is held: torsional stiffness
    /// over `r_b²`. Default: rigid.
    #[serde(default)]
    pub tangential_support: Option<Quantity<Stiffness>>,
}

/// The carrier as a body, without planets.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CarrierEntry {
    /// Mass.
    #[serde(default)]
    pub mass: Option<Quantity<Mass>>,
    /// Inertia with all that turns with the body.
    #[serde(default)]
    pub inertia: Option<Quantity<MomentOfInertia>>,
    /// In place of the inertia: the inertia over the square of the radius of the planets' circle.
    #[serde(default)]
    pub rotary_mass: Option<Quantity<Mass>>,
    /// Radial stiffness of its bearings; 0 of a floating carrier. Default: rigid.
    #[serde(default)]
    pub support: Option<Quantity<Stiffness>>,
    /// Stiffness of what holds it against rotation in gears in which its link is held, over the square of
    /// that radius. Default: rigid.
    #[serde(default)]
    pub tangential_support: Option<Quantity<Stiffness>>,
}

/// A planet as a body.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlanetEntry {
    /// Inertia. Default: that of the shape.
    #[serde(default)]
    pub inertia: Option<Quantity<MomentOfInertia>>,
    /// In place of the inertia: `I/r_b²`.
    #[serde(default)]
    pub rotary_mass: Option<Quantity<Mass>>,
}

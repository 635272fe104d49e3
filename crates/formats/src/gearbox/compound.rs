//! Compound sets in files, and remarks.

use super::checks::NO_LINK;
use super::per_gear::MESHES;
use super::place::{keys_of_part, of_set};
use super::shape::{Shape, Stated, missing, one_module};
use super::{
    CompoundVibrationEntry, DataSheetEntry, DescriptionError, FloatingEntry, Gears, PerGear, RollingEntry,
    StrengthEntry, ToolEntry, Vibrating, VibrationEntry, spaced,
};
use crate::Path;
use crate::drive::Spacing;
use crate::faults::{At, Faults};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::sliding::mesh_efficiency;
use epicyclic_gears::rack::BasicRack;
use epicyclic_train::compound::{CentralKind, CentralSpec, CompoundSpec, MeshSpec, PlanetSpec};
use epicyclic_train::planet_bearings::{MeshSize, PlanetSize, SetSize};
use epicyclic_train::planet_set::Planet;
use epicyclic_train::{PlanetSet, SetPart};
use epicyclic_units::{Module, Number, Physical, Quantity};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use std::borrow::Cow;
use std::collections::BTreeMap;
use uom::si::f64::{Angle, Force, Length, Mass, Ratio};

/// A set gear by gear: any central gears, any planets, any tree of meshes.
///
/// Central gears are named as their links; in a list of transmissions as members, which nodes join. A
/// planet's gear is named as the planet, or `planet.1`, `planet.2`… where it has several.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(bound = "P: PlanetSized + JsonSchema", transform = without_unread::<P>)]
pub struct CompoundEntry<P = PlanetSizeEntry> {
    /// Name of the set.
    pub id: String,
    /// Link of the carrier.
    pub carrier: String,
    /// Suns: link and teeth.
    #[serde(default)]
    pub suns: BTreeMap<String, f64>,
    /// Rings: link and teeth.
    #[serde(default)]
    pub rings: BTreeMap<String, f64>,
    /// Bevel gears on the left of their planets: link and teeth.
    #[serde(default)]
    pub bevels_left: BTreeMap<String, f64>,
    /// Bevel gears on the right.
    #[serde(default)]
    pub bevels_right: BTreeMap<String, f64>,
    /// Teeth are not known: the numbers of suns, rings and bevel gears are proportional to them, and planets
    /// have none.
    #[serde(default)]
    pub proportional: bool,
    /// Links that turn as fast as a planet about its own axis (K-H-V, cycloidal drives): link and planet.
    #[serde(default)]
    pub planet_shafts: BTreeMap<String, String>,
    /// Planets: name, and the teeth of each of its gears; an empty list of a planet with one gear whose teeth
    /// are not known, which changes no ratio of the others.
    pub planet_gears: BTreeMap<String, Vec<u32>>,
    /// The meshes: a tree over all gears.
    pub meshes: Vec<MeshEntry>,
    /// How many of each planet stand around the axis. Default: as many as `planet_angles`.
    #[serde(default)]
    pub planets: Option<u32>,
    /// Spacing of the planets. Default `equal`.
    #[serde(default)]
    pub spacing: Option<Spacing>,
    /// Angle on the carrier of each planet of one kind, in place of `spacing`. Only differences of angles
    /// matter.
    #[serde(default)]
    pub planet_angles: Option<Vec<Quantity<Angle>>>,
    /// Module of its meshes, of helical teeth the normal one.
    #[serde(default, deserialize_with = "crate::module::optional")]
    #[schemars(with = "Option<Quantity<Module>>")]
    pub module: Option<Quantity<Length>>,
    /// Helix angle of its teeth at the reference cylinders; above 0 the planet of the first mesh is
    /// right-handed, below 0 left-handed. Default 0 deg, spur teeth.
    #[serde(default)]
    pub helix_angle: Option<Quantity<Angle>>,
    /// Profile shift coefficients by gear, 0 unless given; one above 0 moves the tips of a ring inwards.
    #[serde(default)]
    pub profile_shifts: Option<PerGear<Number>>,
    /// With `profile_shifts`: how far the tips of gears are moved, in modules; below 0 the teeth are shorter.
    /// Default: external gears as they come, rings shortened to stay out of the fillets of the planets.
    #[serde(default)]
    pub tip_alterations: Option<PerGear<Number>>,
    /// Tools that cut its gears, by gear.
    #[serde(default)]
    pub tools: BTreeMap<String, ToolEntry>,
    /// Face width of its gears, for the strength of teeth.
    #[serde(default)]
    pub face_width: Option<Quantity<Length>>,
    /// Face widths of single gears, which go before `face_width`.
    #[serde(default)]
    pub face_widths: Option<PerGear<Quantity<Length>>>,
    /// For the strength of its teeth: materials, roughness, tools, given factors.
    #[serde(default)]
    pub strength: Option<StrengthEntry>,
    /// For its data sheet: measuring balls, allowances.
    #[serde(default)]
    pub data_sheet: Option<DataSheetEntry>,
    /// For its vibration: bodies, bearings, supports, stiffness of meshes.
    #[serde(default)]
    pub vibration: Option<CompoundVibrationEntry>,
    /// Member that floats, for the load sharing of its planets. Default: a floating member is assumed.
    #[serde(default)]
    pub floating: Option<FloatingEntry>,
    /// Sizes of single planets, by their names.
    #[serde(default)]
    pub planet_sizes: BTreeMap<String, P>,
    /// Remark, of any form.
    #[serde(default)]
    pub note: Option<Note>,
}

/// A mesh of a compound set.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeshEntry {
    /// The two gears.
    pub gears: [String; 2],
    /// Efficiency of the mesh, 0.99 or 99 %; 1 unless given.
    #[serde(default)]
    pub efficiency: Option<Quantity<Ratio>>,
    /// Mean coefficient of friction of the mesh, in place of its efficiency: of a set with teeth.
    #[serde(default)]
    pub friction: Option<Number>,
    /// Module of the mesh, if not that of the set.
    #[serde(default, deserialize_with = "crate::module::optional")]
    #[schemars(with = "Option<Quantity<Module>>")]
    pub module: Option<Quantity<Length>>,
    /// Helix angle of the mesh, if not that of the set; one with the hand of its planet's gear. Meshes that
    /// share a gear have one sign.
    #[serde(default)]
    pub helix_angle: Option<Quantity<Angle>>,
    /// Centre distance of the mesh, from which an open profile shift of its gears follows: `profile_shifts`
    /// state that of the other. Needs a module.
    #[serde(default)]
    pub centre_distance: Option<Quantity<Length>>,
    /// Of two planets in mesh: the second by name stands behind the first, not ahead of it in the positive
    /// direction of rotation. The forces on their bearings depend on it.
    #[serde(default)]
    pub behind: bool,
}

/// The size of a planet of a compound set, for the forces on its bearing, and what its bearing bears over the
/// duty.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlanetSizeEntry {
    /// Radius of its centre; goes before that of module and teeth.
    #[serde(default)]
    pub carrier_radius: Option<Quantity<Length>>,
    /// Face width of each of its gears, for its mass.
    #[serde(default)]
    pub face_widths: Vec<Quantity<Length>>,
    /// Bore of the planet. Default: solid.
    #[serde(default)]
    pub bore: Option<Quantity<Length>>,
    /// Mass of the planet with all that turns about its pin; used instead of the mass of its shape.
    #[serde(default)]
    pub mass: Option<Quantity<Mass>>,
    /// Basic dynamic load rating of its bearings together, for their life.
    #[serde(default)]
    pub load_rating: Option<Quantity<Force>>,
    /// Rolling elements of these bearings. Default balls.
    #[serde(default)]
    pub bearing_rolling: RollingEntry,
    /// Static load rating of these bearings together, for their safety at rest.
    #[serde(default)]
    pub static_load_rating: Option<Quantity<Force>>,
    /// Fatigue load limit of these bearings together, for their modified life.
    #[serde(default)]
    pub fatigue_limit: Option<Quantity<Force>>,
    /// Mean diameter of these bearings, (d + D)/2, for their modified life.
    #[serde(default)]
    pub bearing_diameter: Option<Quantity<Length>>,
    /// Distance of the middles of the rows of these bearings, for their life under the moment of helical
    /// teeth.
    #[serde(default)]
    pub bearing_span: Option<Quantity<Length>>,
    /// Mesh load factor `K_γ` of its meshes, for the load of its bearings over the duty. Default: by the
    /// number of planets, a floating member assumed.
    #[serde(default)]
    pub load_sharing: Option<Number>,
}

/// The size of a planet of a compound set in a list of transmissions, for the forces on its bearing.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ListedPlanetEntry {
    /// Radius of its centre; goes before that of module and teeth.
    #[serde(default)]
    pub carrier_radius: Option<Quantity<Length>>,
    /// Face width of each of its gears, for its mass.
    #[serde(default)]
    pub face_widths: Vec<Quantity<Length>>,
    /// Bore of the planet. Default: solid.
    #[serde(default)]
    pub bore: Option<Quantity<Length>>,
    /// Mass of the planet with all that turns about its pin; used instead of the mass of its shape.
    #[serde(default)]
    pub mass: Option<Quantity<Mass>>,
    /// Basic dynamic load rating of its bearings together, for their life.
    #[serde(default)]
    pub load_rating: Option<Quantity<Force>>,
    /// Rolling elements of these bearings. Default balls.
    #[serde(default)]
    pub bearing_rolling: RollingEntry,
}

/// Keys of a compound set that gearbox files alone read.
const OF_GEARBOXES: [&str; 10] = [
    "helix_angle",
    "profile_shifts",
    "tip_alterations",
    "tools",
    "face_width",
    "face_widths",
    "strength",
    "data_sheet",
    "vibration",
    "floating",
];

/// Leaves the keys that gearbox files alone read out of the schema of lists of transmissions.
fn without_unread<P: PlanetSized>(schema: &mut Schema) {
    let properties = schema.get_mut("properties").and_then(|value| value.as_object_mut());
    if let Some(properties) = properties.filter(|_| !P::IS_OF_GEARBOX) {
        properties.retain(|key, _| !OF_GEARBOXES.contains(&key.as_str()));
    }
}

/// Entry that states the size of a planet.
pub trait PlanetSized {
    /// Whether it is of a gearbox file, not of a list of transmissions.
    const IS_OF_GEARBOX: bool;

    /// The size.
    fn size(&self) -> PlanetSize;
}

impl PlanetSized for PlanetSizeEntry {
    const IS_OF_GEARBOX: bool = true;

    fn size(&self) -> PlanetSize {
        PlanetSize {
            carrier_radius: self.carrier_radius.map(|radius| radius.0),
            face_widths: self.face_widths.iter().map(|width| Some(width.0)).collect(),
            bore: self.bore.map(|bore| bore.0),
            mass: self.mass.map(|mass| mass.0),
            bearing: self.load_rating.map(|rating| (rating.0, self.bearing_rolling.into())),
        }
    }
}

impl PlanetSized for ListedPlanetEntry {
    const IS_OF_GEARBOX: bool = false;

    fn size(&self) -> PlanetSize {
        let Self { carrier_radius, face_widths, bore, mass, load_rating, bearing_rolling } = self.clone();
        let entry = PlanetSizeEntry {
            carrier_radius,
            face_widths,
            bore,
            mass,
            load_rating,
            bearing_rolling,
            static_load_rating: None,
            fatigue_limit: None,
            bearing_diameter: None,
            bearing_span: None,
            load_sharing: None,
        };
        entry.size()
    }
}

/// A remark of any form: a text, a list, keys with values. Nothing reads it.
#[derive(Debug, Clone, PartialEq)]
pub struct Note;

impl<'de> Deserialize<'de> for Note {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        serde::de::IgnoredAny::deserialize(deserializer).map(|_| Self)
    }
}

impl JsonSchema for Note {
    fn schema_name() -> Cow<'static, str> {
        "Note".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "description": "A remark of any form; nothing reads it." })
    }
}

/// Path of a part of a set; of the sets so many have two central gears, and the others are these.
pub(super) fn at_set<P: PlanetSized>(
    simple: usize,
    compound: &[CompoundEntry<P>],
    set: usize,
    part: SetPart,
) -> At {
    let compound = set.checked_sub(simple).and_then(|set| compound.get(set));
    let at = compound.map_or_else(|| keys_of_part(part).into(), |compound| compound.at(part));
    at.below(&of_set(simple, set))
}

impl<P: PlanetSized> CompoundEntry<P> {
    /// The set, with the link of each member by `link`.
    pub(super) fn spec<'a>(
        &'a self,
        link: impl Fn(&'a str) -> Option<&'a str>,
        rack: Option<&BasicRack>,
        friction: Option<Number>,
        faults: &mut Faults,
    ) -> CompoundSpec {
        let mut node = |member: &'a String, at: Path| {
            let lacks = || DescriptionError::MemberInNoLink { set: self.id.clone(), member: member.clone() };
            faults.keep(at, link(member).ok_or_else(lacks)).unwrap_or(NO_LINK).to_owned()
        };
        let carrier = node(&self.carrier, Path::root().key("carrier"));
        let central = |(key, kind, name, teeth): (&str, _, &'a String, _)| {
            let link = node(name, Path::root().key(key).key(name));
            let planet = self.planet_shafts.get(name).filter(|_| kind == CentralKind::PlanetShaft).cloned();
            CentralSpec { name: name.clone(), link, kind, teeth, planet }
        };
        let centrals = self.centrals().map(central).collect();
        let mut meshes = vec![];
        for (place, mesh) in self.meshes.iter().enumerate() {
            let eta =
                mesh.efficiency.map_or(Ok(MeshEfficiency::IDEAL), |eta| MeshEfficiency::new(eta.0.value));
            let eta = eta.map_err(|source| DescriptionError::of_set(&self.id, source));
            let at = Path::root().key("meshes").index(place).key("efficiency");
            let efficiency = faults.keep(at, eta).unwrap_or(MeshEfficiency::IDEAL);
            meshes.push(MeshSpec { between: mesh.gears.clone(), efficiency });
        }
        for name in self.planet_sizes.keys().filter(|name| !self.planet_gears.contains_key(*name)) {
            let unknown = DescriptionError::NoSuchPlanet { set: self.id.clone(), planet: name.clone() };
            faults.push(Path::root().key("planet_sizes").key(name), unknown);
        }
        let planet =
            |(name, teeth): (&String, &Vec<u32>)| PlanetSpec { name: name.clone(), teeth: teeth.clone() };
        let spacing = spaced(&self.id, self.spacing, [self.planet_angles.as_deref(), None], faults);
        let gears = self.gears();
        let helix_angle = |(place, mesh): (usize, &MeshEntry)| {
            let at = Path::root();
            match (mesh.helix_angle, self.helix_angle) {
                (Some(own), _) => (own.0, at.key("meshes").index(place).key("helix_angle")),
                (None, of_set) => {
                    (of_set.map_or_else(Angle::default, |angle| angle.0), at.key("helix_angle"))
                }
            }
        };
        let shape = Shape {
            set: &self.id,
            gears: &gears,
            profile_shifts: self.profile_shifts.as_ref(),
            tip_alterations: self.tip_alterations.as_ref(),
            face_widths: self.face_widths.as_ref(),
            tools: &self.tools,
            strength: self.strength.as_ref(),
            data_sheet: self.data_sheet.as_ref(),
            helix_angles: self.meshes.iter().enumerate().map(helix_angle).collect(),
            is_known: !self.proportional
                && self.bevels_left.is_empty()
                && self.bevels_right.is_empty()
                && self.planet_gears.values().all(|teeth| !teeth.is_empty()),
            teeth: self.teeth(),
            closing: self.closing(),
        };
        let stated = self.meshes.iter().enumerate().filter_map(|(place, mesh)| {
            let at = match mesh.module {
                Some(_) => Path::root().key("meshes").index(place).key("module"),
                None => Path::root().key("module"),
            };
            Some(Stated { gears: &mesh.gears, module: mesh.module.or(self.module)?.0, at })
        });
        let (tooth_shape, is_sound) = faults.sound(|faults| {
            self.check_distances(faults);
            one_module(&self.id, &stated.collect::<Vec<_>>(), faults);
            shape.tooth_shape(rack, faults)
        });
        if let Some(vibration) = &self.vibration {
            let vibration = VibrationEntry::from(vibration.clone());
            vibration.check(&self.id, &gears, &self.vibrating(), faults);
        }
        let spec = CompoundSpec {
            id: self.id.clone(),
            tooth_shape,
            carrier,
            centrals,
            planets: self.planet_gears.iter().map(planet).collect(),
            meshes,
            planet_count: self.planets,
            spacing: Default::default(),
            proportional: self.proportional,
        };
        let mut spec = spec.spaced(spacing);
        self.add_friction(&mut spec, rack.filter(|_| is_sound), friction, faults);
        spec
    }

    /// Efficiencies of the meshes that state friction, or have that of the gearbox.
    fn add_friction(
        &self,
        spec: &mut CompoundSpec,
        rack: Option<&BasicRack>,
        of_gearbox: Option<Number>,
        faults: &mut Faults,
    ) {
        let own = |mesh: &MeshEntry| mesh.friction.or(of_gearbox.filter(|_| mesh.efficiency.is_none()));
        let mut is_asked = false;
        for (place, mesh) in self.meshes.iter().enumerate() {
            is_asked |= own(mesh).is_some();
            if mesh.friction.is_some() && mesh.efficiency.is_some() {
                let (set, first, second) = (self.id.clone(), "efficiency", "friction");
                let at = Path::root().key("meshes").index(place).key("friction");
                faults.push(at, DescriptionError::Twice { set, first, second });
            }
        }
        // Without a rack, as of teeth with a fault, friction would only repeat it.
        let Some(rack) = rack.filter(|_| is_asked) else { return };
        let toothed = match spec.toothed(rack, &self.stated_modules()) {
            Ok(toothed) => toothed,
            Err(why) => {
                let place = self.meshes.iter().position(|mesh| mesh.friction.is_some());
                if let (Some(place), Some(missing)) = (place, missing(&why)) {
                    let at = Path::root().key("meshes").index(place).key("friction");
                    faults.push(at, DescriptionError::Friction { set: self.id.clone(), missing });
                }
                return;
            }
        };
        let meshes = self.meshes.iter().zip(&mut spec.meshes).zip(&toothed.meshes).enumerate();
        for (place, ((entry, mesh), toothed)) in meshes {
            let Some(friction) = own(entry) else { continue };
            let eta = mesh_efficiency(&toothed.pair, friction.get());
            let eta = eta.map_err(|source| DescriptionError::of_set(&self.id, source));
            let at = Path::root().key("meshes").index(place).first_of(&["friction", "gears"]);
            // Friction of the gearbox that these teeth cannot have is told in a warning.
            mesh.efficiency = match (entry.friction, eta) {
                (None, eta) => eta.unwrap_or(MeshEfficiency::IDEAL),
                (Some(_), eta) => faults.keep(at, eta).unwrap_or(MeshEfficiency::IDEAL),
            };
        }
    }

    /// Whether each mesh states its efficiency or friction.
    pub(super) fn states_losses(&self) -> bool {
        self.meshes.iter().all(|mesh| mesh.efficiency.is_some() || mesh.friction.is_some())
    }

    /// Module of each mesh in m, as far as it is stated.
    pub(super) fn stated_modules(&self) -> Vec<Option<f64>> {
        self.meshes.iter().map(|mesh| mesh.module.or(self.module).map(|module| module.0.si())).collect()
    }

    /// Path of a part of the set.
    fn at(&self, part: SetPart) -> At {
        let root = Path::root();
        let planet = |planet: usize| {
            let name = self.planet_gears.keys().nth(planet);
            root.clone().key("planet_gears").key(name.cloned().unwrap_or_default())
        };
        match part {
            SetPart::Central(central) => match self.centrals().nth(central) {
                Some((key, _, name, _)) => root.key(key).key(name),
                None => root,
            },
            SetPart::Planet(of) => planet(of),
            SetPart::PlanetGear(of, gear) => planet(of).index(gear),
            SetPart::Mesh(mesh) => root.key("meshes").index(mesh),
            SetPart::MeshGear(mesh, gear) => root.key("meshes").index(mesh).key("gears").index(gear),
            other => return keys_of_part(other).into(),
        }
        .into()
    }

    /// Size of the set, as far as the entry states it; the rest as usual.
    pub(super) fn size(&self, set: &PlanetSet, usual: &SetSize) -> SetSize {
        let planet =
            |planet: &Planet| self.planet_sizes.get(&planet.name).map_or_else(PlanetSize::default, P::size);
        let mesh = |mesh: &MeshEntry| MeshSize {
            module: mesh.module.map(|module| module.0),
            is_behind: mesh.behind,
            ..MeshSize::default()
        };
        SetSize {
            module: self.module.map(|module| module.0),
            planets: set.planets().iter().map(planet).collect(),
            meshes: self.meshes.iter().map(mesh).collect(),
            ..*usual
        }
    }

    /// Keys given that gearbox files alone read, with their paths.
    pub(super) fn keys_of_gearboxes(&self) -> impl Iterator<Item = (Path, &'static str)> {
        let is_given = [
            self.helix_angle.is_some(),
            self.profile_shifts.is_some(),
            self.tip_alterations.is_some(),
            !self.tools.is_empty(),
            self.face_width.is_some(),
            self.face_widths.is_some(),
            self.strength.is_some(),
            self.data_sheet.is_some(),
            self.vibration.is_some(),
            self.floating.is_some(),
        ];
        let of_set = OF_GEARBOXES.into_iter().zip(is_given).filter(|one| one.1);
        let of_meshes = self.meshes.iter().enumerate().flat_map(|(place, mesh)| {
            let given = [
                ("friction", mesh.friction.is_some()),
                ("helix_angle", mesh.helix_angle.is_some()),
                ("centre_distance", mesh.centre_distance.is_some()),
            ];
            let at = Path::root().key("meshes").index(place);
            given.into_iter().filter(|one| one.1).map(move |(key, _)| (at.clone().key(key), key))
        });
        of_set.map(|(key, _)| (Path::root().key(key), key)).chain(of_meshes)
    }

    /// Gears of the set: the central ones, then those of the planets.
    pub(super) fn gears(&self) -> Gears {
        let central = |(_, kind, name, _): (&str, CentralKind, &String, f64)| {
            let kind = match kind {
                CentralKind::Sun => Some(GearKind::External),
                CentralKind::Ring => Some(GearKind::Internal),
                CentralKind::BevelLeft | CentralKind::BevelRight => None,
                CentralKind::PlanetShaft => return None,
            };
            Some((name.clone(), kind))
        };
        let planet = |(name, teeth): (&String, &Vec<u32>)| {
            let steps = 1..=teeth.len().max(1);
            let is_only = steps.end() == &1;
            let name = name.clone();
            steps.map(move |step| {
                let name = if is_only { name.clone() } else { format!("{name}.{step}") };
                (name, Some(GearKind::External))
            })
        };
        let planets = self.planet_gears.iter().flat_map(planet);
        let (names, kinds) = self.centrals().filter_map(central).chain(planets).unzip();
        Gears { names, kinds, has_order: false, of: "gears" }
    }

    /// Bodies and meshes of the set.
    pub(super) fn vibrating(&self) -> Vibrating {
        let Gears { mut names, mut kinds, .. } = self.gears();
        let centrals = self.centrals().filter(|one| one.1 != CentralKind::PlanetShaft).count();
        names.truncate(centrals);
        kinds.truncate(centrals);
        names.extend(self.planet_gears.keys().cloned());
        kinds.resize(names.len(), Some(GearKind::External));
        let meshes = self.meshes.iter().map(|mesh| mesh.gears.join("-")).collect();
        Vibrating {
            bodies: Gears { names, kinds, has_order: false, of: "bodies" },
            meshes: Gears { names: meshes, kinds: vec![], has_order: false, of: MESHES },
            planets: self.planet_gears.keys().cloned().collect(),
        }
    }

    /// Key, kind, name and teeth of its central gears and planet shafts.
    pub(super) fn centrals(&self) -> impl Iterator<Item = (&'static str, CentralKind, &String, f64)> + Clone {
        let gears = [
            ("suns", CentralKind::Sun, &self.suns),
            ("rings", CentralKind::Ring, &self.rings),
            ("bevels_left", CentralKind::BevelLeft, &self.bevels_left),
            ("bevels_right", CentralKind::BevelRight, &self.bevels_right),
        ];
        let gears = gears
            .into_iter()
            .flat_map(|(key, kind, gears)| gears.iter().map(move |(name, teeth)| (key, kind, name, *teeth)));
        let shaft = |name| ("planet_shafts", CentralKind::PlanetShaft, name, 0.0);
        gears.chain(self.planet_shafts.keys().map(shaft))
    }

    /// Names of its members, the carrier last.
    pub(super) fn members(&self) -> impl Iterator<Item = &String> + Clone {
        self.centrals().map(|(_, _, name, _)| name).chain([&self.carrier])
    }
}

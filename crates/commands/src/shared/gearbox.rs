//! The gearbox of a file, in whichever of the two formats it is written.

use crate::error::Error;
use epicyclic_formats::gearbox::gear_place;
use epicyclic_formats::gearbox::{GearEntry, GearboxFile, PublishedGear, Transmission, TransmissionsFile};
use epicyclic_formats::{Document, Faults, FileKind, Path, Problem};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::rack::BasicRack;
use epicyclic_judge::Limits;
use epicyclic_train::drag::Drag;
use epicyclic_train::error::DragFault;
use epicyclic_train::planet_bearings::PlanetBearing;
use epicyclic_train::planet_set::Description;
use epicyclic_train::set::MeshLoss;
use epicyclic_train::tooth_checks::SetChecks;
use epicyclic_train::toothed::Untoothed;
use epicyclic_train::{self as train, PlanetSet};
use epicyclic_units::Quantity;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;
use uom::si::f64::{AngularVelocity, Length, Torque};

/// Choice of a gearbox in a file, and assumptions about it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Choice {
    /// One transmission of a list: its name, or a part that no other name has.
    pub transmission: Option<String>,
    /// Efficiency with the carrier fixed of each set for which the file states no losses. Of a compound set
    /// each mesh takes its square root.
    pub efficiency: Option<MeshEfficiency>,
}

/// Content of a file.
#[derive(Debug)]
pub enum Content {
    /// The gearbox meant.
    One(Box<Gearbox>),
    /// A list of transmissions without a choice of one.
    Several(Vec<Transmission>),
}

/// A gearbox as a file describes it: its gear train, and what else the file says of it.
#[derive(Debug)]
pub struct Gearbox {
    /// Its gear train: sets, links, shift elements and gears.
    pub train: train::Gearbox,
    /// Publication with the data of the gearbox.
    pub source: Option<String>,
    /// Published data of the gears.
    pub published: Vec<PublishedGear>,
    /// The planet bearings of the sets that have any.
    pub planet_bearings: Vec<PlanetBearing>,
    /// The basic rack that its teeth are checked by.
    pub rack: BasicRack,
    /// The file.
    pub document: Document,
    /// The gearbox's place in it.
    pub base: Path,
    /// The limits to judge by: the usual ones, and those that the file states in their place.
    pub limits: Limits,
    /// Drag torques that the file states.
    pub drags: Vec<Drag>,
    /// Paths of the curves of these drags.
    drag_paths: Vec<Path>,
    inputs: Vec<(String, GearInputs)>,
    /// Modules that the file states of the meshes of each set, m.
    modules: Vec<Vec<Option<f64>>>,
    /// For each mesh of each set, whether of two planets in mesh the one described later is behind.
    is_behind: Vec<Vec<bool>>,
    /// Sets to which the friction of the gearbox is not applied, with what their teeth lack for it.
    pub(crate) without_friction: Vec<(String, Untoothed)>,
    /// Stated radii of planets that are not those of the teeth.
    pub(crate) other_radii: Vec<(String, Length, Length)>,
    /// Where it comes from.
    pub origin: Origin,
    /// Whether its tooth numbers or ring-to-sun ratios are known; a scheme by its name alone has any.
    pub is_sized: bool,
}

/// Origins of a gearbox or motor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Origin {
    /// Scheme of the catalogue.
    Catalogue,
    /// Structure of two sets by its name.
    Structure,
    /// Gearbox of a file.
    GearboxFile,
    /// Hydromotor of a file.
    MotorFile,
}

/// Speeds and torques of several links, as a file states them of a gear.
#[derive(Debug, Clone)]
pub struct GearInputs {
    /// Speeds by link.
    pub speeds: BTreeMap<String, Quantity<AngularVelocity>>,
    /// Torques by link.
    pub torques: BTreeMap<String, Quantity<Torque>>,
}

impl Gearbox {
    /// The one gearbox of a file in YAML; messages call the file by this name.
    ///
    /// ```
    /// use epicyclic_commands::shared::gearbox::Gearbox;
    ///
    /// let text = "{ gearbox: one set, input: a, output: h, gears: [{ name: only }],
    ///     sets: [{ id: P, sun: a, ring: ground, carrier: h, teeth: [20, 80] }] }";
    /// let gearbox = Gearbox::parse("one-set.yaml", text.as_bytes())?;
    /// assert_eq!(gearbox.train.analyze("only")?.ratio(), Some(5.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// Faults of the text with their places, and those of [`one`].
    pub fn parse(file_name: &str, yaml: &[u8]) -> Result<Self, Error> {
        one(&Document::parse_one(file_name, yaml)?, &Choice::default())
    }

    /// Refuses a set that there is not.
    ///
    /// # Errors
    /// [`Error::NoSet`].
    pub(crate) fn check_set(&self, name: Option<&str>) -> Result<(), Error> {
        let ids = || self.train.sets().iter().map(PlanetSet::id);
        match name.filter(|name| ids().all(|id| id != *name)) {
            Some(name) => {
                Err(Error::NoSet { name: name.to_owned(), sets: ids().map(str::to_owned).collect() })
            }
            None => Ok(()),
        }
    }

    /// Path in the file of what is wrong with a drag at work, by its index in [`drags`](Self::drags).
    pub(crate) fn drag_path(&self, drag: usize, fault: &DragFault) -> Path {
        let Some(curve) = self.drag_paths.get(drag) else { return self.base.clone() };
        let path = self.base.segments().iter().chain(curve.segments()).cloned().collect::<Path>();
        if let DragFault::Outside { .. } = fault { path.key("speeds") } else { path }
    }

    /// The checks of the teeth of all sets.
    #[must_use]
    pub fn tooth_checks(&self) -> SetChecks {
        self.train.set_checks(&self.rack, |set| self.modules(set).to_vec())
    }

    /// Modules that the file states of the meshes of a set, in m.
    pub(crate) fn modules(&self, set: &PlanetSet) -> &[Option<f64>] {
        self.of_set(&self.modules, set)
    }

    /// For each mesh of a set, whether of two planets in mesh the one described later is behind.
    pub(crate) fn is_behind(&self, set: &PlanetSet) -> &[bool] {
        self.of_set(&self.is_behind, set)
    }

    fn of_set<'v, T>(&self, values: &'v [Vec<T>], set: &PlanetSet) -> &'v [T] {
        let place = self.train.sets().iter().position(|other| other.id() == set.id());
        place.and_then(|place| values.get(place)).map_or(&[], Vec::as_slice)
    }

    /// Published data of a gear.
    #[must_use]
    pub fn published(&self, gear: &str) -> Option<&PublishedGear> {
        self.published.iter().find(|published| published.name == gear)
    }

    /// Speeds and torques of several links that the file states in a gear.
    #[must_use]
    pub fn inputs(&self, gear: &str) -> Option<&GearInputs> {
        self.inputs.iter().find(|(name, _)| name == gear).map(|(_, inputs)| inputs)
    }

    /// Whether the file states speeds of several links in this gear.
    #[must_use]
    pub fn has_inputs(&self, gear: &str) -> bool {
        self.inputs(gear).is_some_and(|inputs| !inputs.speeds.is_empty())
    }

    /// Whether any set loses power.
    #[must_use]
    pub fn has_losses(&self) -> bool {
        self.train.sets().iter().any(PlanetSet::has_losses)
    }
}

/// Reads the only gearbox of a file, or the chosen one of a list.
///
/// # Errors
/// Those of [`read`], and [`Error::SeveralTransmissions`] where none is named.
pub fn one(document: &Document, choice: &Choice) -> Result<Gearbox, Error> {
    match read(document, choice)? {
        Content::One(subject) => Ok(*subject),
        Content::Several(transmissions) => Err(Error::SeveralTransmissions { names: names(&transmissions) }),
    }
}

/// The gearbox of a file for a command that reads one, of what a list of transmissions states nothing of.
///
/// # Errors
/// Those of [`one`], and [`Error::Document`] for a list of transmissions.
pub(crate) fn alone(document: &Document, command: &str, lacks: &str) -> Result<Gearbox, Error> {
    if document.value().get("transmissions").is_some() {
        let message = format!("{command} reads one gearbox; a list of transmissions states {lacks}");
        let place = Path::root().key("transmissions");
        return Err(document.error(&place, Problem::refused("several-transmissions", message)).into());
    }
    one(document, &Choice::default())
}

/// The gearbox of a file, or the transmissions that there are to choose from.
///
/// # Errors
/// - [`Error::Document`] for a description that is no gearbox, with its place in the file.
/// - [`Error::OneGearbox`], [`Error::NoTransmission`], [`Error::AmbiguousTransmission`] for the name of a
///   transmission.
pub fn read(document: &Document, choice: &Choice) -> Result<Content, Error> {
    let has = |key: &str| document.value().get(key).is_some();
    if has("transmissions") {
        let transmissions = document.read::<TransmissionsFile>()?.transmissions;
        return match chosen(choice, document, &transmissions)? {
            Some(index) => {
                transmission(document, &transmissions[index], index, choice.efficiency).map(Content::One)
            }
            None => Ok(Content::Several(transmissions)),
        };
    }
    document.must_be(FileKind::Gearbox)?;
    if !has("gearbox") && document.value().is_mapping() {
        let message = "this is no gearbox: one has the key gearbox, a list of published ones transmissions";
        let problem = Problem::refused("no-gearbox", message);
        return Err(document.error(&Path::root(), problem).into());
    }
    if choice.transmission.is_some() {
        return Err(Error::OneGearbox);
    }
    if has("shared_ring_meshes") {
        let message = "sets that share planets are one: describe them as an entry of compound_sets";
        let place = Path::root().key("shared_ring_meshes");
        return Err(document.error(&place, Problem::refused("renamed-key", message)).into());
    }
    gearbox(document, Path::root(), choice.efficiency).map(Content::One)
}

/// Reads a gearbox at a place of a file.
pub(crate) fn gearbox(
    document: &Document,
    base: Path,
    efficiency: Option<MeshEfficiency>,
) -> Result<Box<Gearbox>, Error> {
    let file: GearboxFile = document.read_at(&base)?;
    let at = |faults: Faults| faults.placed(document, &base);
    let gearbox = with_losses(file.gearbox().map_err(at)?, efficiency)?;
    let rack = file.rack()?;
    let (planet_bearings, drags) = match (file.planet_bearings(&gearbox), file.drags(&gearbox)) {
        (Ok(planet_bearings), Ok(drags)) => (planet_bearings, drags),
        (Err(faults), drags) => return Err(at(faults.and(drags.err())).into()),
        (_, Err(faults)) => return Err(at(faults).into()),
    };
    let (source, published) = (None, vec![]);
    let of_gear = |gear: &GearEntry| {
        let inputs = GearInputs { speeds: gear.speeds.clone(), torques: gear.torques.clone() };
        (gear.name.clone(), inputs)
    };
    let inputs = with_speeds(file.gears.iter().map(of_gear).collect(), document, &base)?;
    let modules = gearbox.sets().iter().map(|set| file.stated_modules(set)).collect();
    let is_behind = |set: &PlanetSet| file.set_data(set).map(|data| data.is_behind).unwrap_or_default();
    let is_behind = gearbox.sets().iter().map(is_behind).collect();
    // An assumed efficiency takes the place of what friction does not give.
    let other_radii = file.other_radii(&gearbox);
    let without_friction = if efficiency.is_some() { vec![] } else { file.without_friction(&gearbox) };
    Ok(Box::new(Gearbox {
        train: gearbox,
        source,
        published,
        planet_bearings,
        rack,
        document: document.clone(),
        base,
        limits: file.limits(),
        drags,
        drag_paths: file.drag_paths(),
        inputs,
        modules,
        is_behind,
        without_friction,
        other_radii,
        origin: Origin::GearboxFile,
        is_sized: true,
    }))
}

fn transmission(
    document: &Document,
    transmission: &Transmission,
    index: usize,
    efficiency: Option<MeshEfficiency>,
) -> Result<Box<Gearbox>, Error> {
    let base = Path::root().key("transmissions").index(index);
    let at = |faults: Faults| faults.placed(document, &base);
    let gearbox = with_losses(transmission.gearbox().map_err(at)?, efficiency)?;
    let (source, published) = (transmission.source.clone(), transmission.gears.clone());
    let planet_bearings = transmission.planet_bearings(&gearbox).map_err(at)?;
    let of_gear = |gear: &PublishedGear| {
        let inputs = GearInputs { speeds: gear.speeds.clone(), torques: gear.torques.clone() };
        (gear.name.clone(), inputs)
    };
    let inputs = with_speeds(transmission.gears.iter().map(of_gear).collect(), document, &base)?;
    let (rack, drags, modules, is_behind) = (BasicRack::default(), vec![], vec![], vec![]);
    Ok(Box::new(Gearbox {
        train: gearbox,
        source,
        published,
        planet_bearings,
        rack,
        document: document.clone(),
        base,
        limits: Limits::default(),
        drags,
        drag_paths: vec![],
        inputs,
        modules,
        is_behind,
        without_friction: vec![],
        other_radii: vec![],
        origin: Origin::GearboxFile,
        is_sized: true,
    }))
}

/// Refuses torques of a gear without speeds: nothing would take them.
fn with_speeds(
    inputs: Vec<(String, GearInputs)>,
    document: &Document,
    base: &Path,
) -> Result<Vec<(String, GearInputs)>, Error> {
    let lacks = |(_, inputs): &&(String, GearInputs)| inputs.speeds.is_empty() && !inputs.torques.is_empty();
    let Some((gear, GearInputs { torques, .. })) = inputs.iter().find(lacks) else { return Ok(inputs) };
    let link = torques.keys().next().map_or("", String::as_str);
    let message = format!(
        "gear `{gear}`: torques stand beside speeds of the gear; write also speeds: {{ {link}: 100 rpm }}, 0 rpm at rest"
    );
    let place = gear_place(document, base, gear, "torques");
    Err(document.error(&place, Problem::refused("torques-without-speeds", message)).into())
}

fn names<'t>(transmissions: impl IntoIterator<Item = &'t Transmission>) -> Vec<String> {
    transmissions.into_iter().map(|transmission| transmission.name.clone()).collect()
}

/// Index of the chosen transmission; `None` if the list has several and no name is given.
fn chosen(
    choice: &Choice,
    document: &Document,
    transmissions: &[Transmission],
) -> Result<Option<usize>, Error> {
    let Some(name) = &choice.transmission else {
        return match transmissions {
            [] => {
                let problem = Problem::refused("no-transmission", "there is no transmission here");
                Err(document.error(&Path::root().key("transmissions"), problem).into())
            }
            [_] => Ok(Some(0)),
            _ => Ok(None),
        };
    };
    if let Some(exact) = transmissions.iter().position(|transmission| transmission.name == *name) {
        return Ok(Some(exact));
    }
    let part = name.to_lowercase();
    let has_part = |transmission: &Transmission| transmission.name.to_lowercase().contains(&part);
    let like: Vec<usize> =
        (0..transmissions.len()).filter(|&place| has_part(&transmissions[place])).collect();
    match like[..] {
        [only] => Ok(Some(only)),
        [] => Err(Error::NoTransmission { name: name.clone(), names: names(transmissions) }),
        _ => {
            let names = names(like.iter().map(|&place| &transmissions[place]));
            Err(Error::AmbiguousTransmission { name: name.clone(), names })
        }
    }
}

/// Returns the gearbox with this efficiency for each set without stated losses.
fn with_losses(gearbox: train::Gearbox, efficiency: Option<MeshEfficiency>) -> Result<train::Gearbox, Error> {
    let Some(eta) = efficiency else { return Ok(gearbox) };
    // A set with a sun and a ring has two meshes.
    let each = MeshEfficiency::new(eta.get().sqrt()).unwrap_or(eta);
    let lossless: Vec<String> =
        gearbox.sets().iter().filter(|set| !set.has_losses()).map(|set| set.id().to_owned()).collect();
    let change = |description: Description| match description {
        description if !lossless.iter().any(|id| id == description.id()) => description,
        Description::Short(spec) => spec.with_loss(MeshLoss::Set(eta)).into(),
        Description::Compound(spec) => spec.with_mesh_efficiency(each).into(),
    };
    Ok(gearbox.to_builder().map_descriptions(change).build()?)
}

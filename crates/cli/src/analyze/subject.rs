//! The gearbox of a file, whichever of the two formats it is in.

use super::Choice;
use crate::failure::Failure;
use epicyclic_formats::gearbox::{
    DescriptionError, GearEntry, GearboxFile, PublishedGear, Transmission, TransmissionsFile, located,
};
use epicyclic_formats::{Document, Path, Problem, Quantity};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::rack::BasicRack;
use epicyclic_train::planet_bearings::PlanetBearing;
use epicyclic_train::planet_set::Description;
use epicyclic_train::set::MeshLoss;
use epicyclic_train::{Gearbox, PlanetSet};
use epicyclic_views::figure::{Figure, text};
use epicyclic_views::report::{Column, Part, Records, Report, View};
use std::collections::BTreeMap;
use uom::si::f64::{AngularVelocity, Ratio, Torque};

/// What a file holds.
pub(super) enum Content {
    One(Box<Subject>),
    /// Transmissions of which none was chosen.
    Several(Vec<Transmission>),
}

/// A gearbox, and what is published of it.
pub(crate) struct Subject {
    pub(crate) gearbox: Gearbox,
    /// Where its data stand.
    pub(crate) source: Option<String>,
    pub(super) published: Vec<PublishedGear>,
    /// The planets of the sets that have any.
    pub(super) planet_bearings: Vec<PlanetBearing>,
    /// What their teeth are checked by.
    pub(super) rack: BasicRack,
    /// Its place in the file.
    pub(crate) base: Path,
    /// Speeds and torques that the file states of gears.
    pub(super) inputs: Vec<(String, GearInputs)>,
}

/// Speeds and torques of several links, as a file states them of a gear.
#[derive(Debug, Clone)]
pub(super) struct GearInputs {
    pub(super) speeds: BTreeMap<String, Quantity<AngularVelocity>>,
    pub(super) torques: BTreeMap<String, Quantity<Torque>>,
}

impl Subject {
    /// What is published of a gear.
    pub(super) fn published(&self, gear: &str) -> Option<&PublishedGear> {
        self.published.iter().find(|published| published.name == gear)
    }

    /// What the file states of several links in a gear.
    pub(super) fn inputs(&self, gear: &str) -> Option<&GearInputs> {
        self.inputs.iter().find(|(name, _)| name == gear).map(|(_, inputs)| inputs)
    }

    /// Whether any set loses power.
    pub(super) fn has_losses(&self) -> bool {
        self.gearbox.sets().iter().any(PlanetSet::has_losses)
    }
}

/// The gearbox of the file, chosen among its transmissions; where `only_one` is wanted, several are refused.
pub(super) fn read(args: &Choice, document: &Document, only_one: bool) -> Result<Content, Failure> {
    let efficiency = args.efficiency.map(efficiency).transpose()?;
    let has = |key: &str| document.value().get(key).is_some();
    if has("transmissions") {
        let transmissions = document.read::<TransmissionsFile>()?.transmissions;
        return match chosen(args, only_one, document, &transmissions)? {
            Some(index) => transmission(document, &transmissions, index, efficiency).map(Content::One),
            None => Ok(Content::Several(transmissions)),
        };
    }
    if !has("gearbox") && document.value().is_mapping() {
        let message = "this is no gearbox: one has the key gearbox, a list of published ones transmissions";
        let problem = Problem::Refused { message: message.to_owned() };
        return Err(document.error(&Path::root(), problem).into());
    }
    if args.transmission.is_some() {
        return Err(Failure::Option {
            option: "--transmission",
            message: "the file holds one gearbox; leave the option out".to_owned(),
        });
    }
    if has("shared_ring_meshes") {
        let message =
            "sets that share planets are one: describe them as an entry of compound_sets".to_owned();
        let place = Path::root().key("shared_ring_meshes");
        return Err(document.error(&place, Problem::Refused { message }).into());
    }
    let file: GearboxFile = document.read()?;
    let at = |error: DescriptionError| located(document, &Path::root(), &error);
    let gearbox = file.gearbox().map_err(at)?;
    let gearbox = match efficiency {
        Some(eta) => with_losses(&gearbox, eta)?,
        None => gearbox,
    };
    let rack = file.rack().map_err(|error| {
        let key = if matches!(error, epicyclic_gears::Error::OutOfRange { .. }) {
            "pressure_angle"
        } else {
            "addendum"
        };
        let problem = Problem::Refused { message: error.to_string() };
        Failure::from(document.error(&Path::root().key(key), problem))
    })?;
    let planet_bearings = file.planet_bearings(&gearbox).map_err(at)?;
    let of_gear = |gear: &GearEntry| {
        let inputs = GearInputs { speeds: gear.speeds.clone(), torques: gear.torques.clone() };
        (gear.name.clone(), inputs)
    };
    let inputs = file.gears.iter().map(of_gear).collect();
    let (source, published, base) = (None, vec![], Path::root());
    Ok(Content::One(Box::new(Subject { gearbox, source, published, planet_bearings, rack, base, inputs })))
}

/// The efficiency of a set that `--efficiency` gives.
pub(crate) fn efficiency(eta: Quantity<Ratio>) -> Result<MeshEfficiency, Failure> {
    MeshEfficiency::new(eta.0.value)
        .map_err(|error| Failure::Option { option: "--efficiency", message: error.to_string() })
}

/// The names to choose from, each on a line of its own.
pub(super) fn names(transmissions: &[Transmission]) -> String {
    transmissions.iter().map(|transmission| format!("\n  {}", transmission.name)).collect()
}

/// The place of the transmission meant; `None` where there are several and none is named.
fn chosen(
    args: &Choice,
    only_one: bool,
    document: &Document,
    transmissions: &[Transmission],
) -> Result<Option<usize>, Failure> {
    let refuse = |message| Err(Failure::Option { option: "--transmission", message });
    let names = |which: &[usize]| {
        which.iter().map(|&place| format!("\n  {}", transmissions[place].name)).collect::<String>()
    };
    let all: Vec<usize> = (0..transmissions.len()).collect();
    let Some(name) = &args.transmission else {
        return match all[..] {
            [] => {
                let problem = Problem::Refused { message: "there is no transmission here".to_owned() };
                Err(document.error(&Path::root().key("transmissions"), problem).into())
            }
            [only] => Ok(Some(only)),
            _ if only_one => refuse(format!("the file has {}; name one of{}", all.len(), names(&all))),
            _ => Ok(None),
        };
    };
    if let Some(exact) = transmissions.iter().position(|transmission| transmission.name == *name) {
        return Ok(Some(exact));
    }
    let part = name.to_lowercase();
    let like: Vec<usize> = all
        .iter()
        .copied()
        .filter(|&place| transmissions[place].name.to_lowercase().contains(&part))
        .collect();
    match like[..] {
        [only] => Ok(Some(only)),
        [] => refuse(format!("no name in the file has `{name}` in it; there are{}", names(&all))),
        _ => refuse(format!("`{name}` stands in several names; write more of one of{}", names(&like))),
    }
}

fn transmission(
    document: &Document,
    transmissions: &[Transmission],
    index: usize,
    efficiency: Option<MeshEfficiency>,
) -> Result<Box<Subject>, Failure> {
    let transmission = &transmissions[index];
    let base = Path::root().key("transmissions").index(index);
    let gearbox = transmission.gearbox().map_err(|error| located(document, &base, &error))?;
    let gearbox = match efficiency {
        Some(eta) => with_losses(&gearbox, eta)?,
        None => gearbox,
    };
    let (source, published) = (transmission.source.clone(), transmission.gears.clone());
    let planet_bearings =
        transmission.planet_bearings(&gearbox).map_err(|error| located(document, &base, &error))?;
    let of_gear = |gear: &PublishedGear| {
        let inputs = GearInputs { speeds: gear.speeds.clone(), torques: gear.torques.clone() };
        (gear.name.clone(), inputs)
    };
    let inputs = transmission.gears.iter().map(of_gear).collect();
    let rack = BasicRack::default();
    Ok(Box::new(Subject { gearbox, source, published, planet_bearings, rack, base, inputs }))
}

/// The same gearbox with this efficiency of each set for which none is stated.
fn with_losses(gearbox: &Gearbox, eta: MeshEfficiency) -> Result<Gearbox, Failure> {
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

/// What there is to choose from.
pub(super) fn list(transmissions: &[Transmission]) -> Report {
    let count = |count: usize| Figure::Count(u32::try_from(count).unwrap_or(u32::MAX));
    let records = Records {
        name: "transmissions",
        columns: vec![
            Column::words("name", ""),
            Column::number("sets", "sets"),
            Column::number("shift_elements", "shift elements"),
            Column::number("gears", "gears"),
        ],
        rows: transmissions
            .iter()
            .map(|one| {
                vec![
                    text(&one.name),
                    count(one.rows.len() + one.compound_sets.len()),
                    count(one.elements.len() + one.one_way.len()),
                    count(one.gears.len()),
                ]
            })
            .collect(),
        views: vec![View::new("Transmissions", &["name", "sets", "shift_elements", "gears"])],
        is_answer: true,
    };
    let hint = "--transmission chooses one, by its name or a part of it.\n".to_owned();
    Report { title: None, parts: vec![Part::Records(records), Part::Words(hint)], warnings: None }
}

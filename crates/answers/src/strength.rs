//! The strength of teeth by ISO 6336: of a gearbox at an operating point in each gear, or over the duty of its file.
//!
//! | module | is |
//! |---|---|
//! | [`records`] | meshes, gears and what is not rated |
//! | `prepared` | the meshes of a file's sets |
//! | `place` | where in the file a fault is |
//!
//! Torques are those without losses, so both meshes of a set have the same tangential force; speeds are relative to the carrier.

pub(crate) mod place;
pub(crate) mod prepared;
pub mod records;

use crate::analyze::{Input, OperatingPoint, Worked};
use crate::gearbox::{Choice, Subject, one};
use crate::tolerance::ROUNDED;
use crate::{Answer, Error, Warning};
use epicyclic_formats::gearbox::{DutyEntry, GearboxFile};
use epicyclic_formats::{Document, Path, Physical};
use epicyclic_strength::factor::Edition;
use epicyclic_strength::mesh::Load;
use epicyclic_strength::planets::loads;
use epicyclic_strength::rating::rate;
use epicyclic_strength::spectrum::{Step, check_shares, rate_duty};
use epicyclic_train::{Gear, InputLoad};
use place::{Fault, located, refused};
use prepared::RatedSet;
use records::{Governing, MeshAtPoint, MeshName, NotRated, OverDuty, Rated, Reason, Required};
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::{AngularVelocity, Time, Torque};

/// What is asked.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Wanted {
    /// One gear of the operating point; all without.
    pub gear: Option<String>,
    /// Speed and load of the input; without a load the duty of the file.
    pub input: Input,
    /// Whether the factors of each mesh are told.
    pub with_factors: bool,
}

/// Stresses, limits and safeties of the teeth of simple sets by ISO 6336, method B.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Strength {
    /// Name of the gearbox.
    pub gearbox: String,
    /// Edition of the standard.
    pub edition: String,
    /// Speed and load of the input; `null` over a duty.
    pub operating_point: Option<OperatingPoint>,
    /// Required life.
    pub life_s: f64,
    /// Viscosity of the oil at 40 °C.
    pub oil_viscosity_m2_s: f64,
    /// Required safeties.
    pub required: Required,
    /// The safety that is least over what is required of it.
    pub governing: Governing,
    /// Each gear of each mesh at the operating point; empty over a duty.
    pub at_point: Vec<Rated>,
    /// Each gear of each mesh over the duty; empty at an operating point.
    pub over_duty: Vec<OverDuty>,
    /// Sets that are not rated.
    pub not_rated: Vec<NotRated>,
    /// What the reader should know.
    pub warnings: Vec<Warning>,
}

impl Answer for Strength {
    const NAME: &'static str = "strength";
}

/// The gearbox of a file whose strength is asked.
///
/// # Errors
/// Those of [`one`], and [`Error::Document`] for a list of transmissions.
pub fn subject(document: &Document) -> Result<Subject<'_>, Error> {
    if document.value().get("transmissions").is_some() {
        let message =
            "strength reads one gearbox; a list of transmissions states no modules, materials or loads";
        return Err(refused(document, &Path::root(), &["transmissions"], message));
    }
    one(document, &Choice::default())
}

/// The strength of a gearbox from a file.
///
/// # Errors
/// - [`Error::NoLoad`] without a load and without a duty, [`Error::LoadWithoutSpeed`], [`Error::OfOnePoint`] for a gear or factors of a duty.
/// - [`Error::Document`] for what the file says wrong, with its place; [`Error::NothingRated`] where no set can be rated.
/// - [`Error::NoGear`], [`Error::Load`].
pub fn answer(subject: &Subject<'_>, wanted: &Wanted) -> Result<Strength, Error> {
    let file: GearboxFile = subject.document.read()?;
    let (prepared, mut not_rated) = prepared::sets(subject, &file)?;
    let missing = |key: &str, why: &str| {
        refused(subject.document, &Path::root(), &[], &format!("`{key}` is missing: {why}"))
    };
    let life = file.life.ok_or_else(|| missing("life", "the required life, such as 20000 h"))?.0;
    let oil = file.oil.as_ref().ok_or_else(|| missing("oil", "write oil: { viscosity: 220 mm²/s }"))?;
    let required = Required::of(&file);
    required.check().map_err(|error| located(subject.document, &Path::root(), &error))?;
    let (mut at_point, mut over_duty) = (vec![], vec![]);
    if wanted.input.load.is_some() {
        let speed = wanted.input.speed.ok_or(Error::LoadWithoutSpeed)?;
        let names: Vec<&str> = match &wanted.gear {
            Some(name) => vec![name],
            None => subject.gearbox.gears().iter().map(Gear::name).collect(),
        };
        for name in names {
            let worked = Worked::new(&subject.gearbox, name, wanted.input)?;
            for set in &prepared {
                match set_load(set, &worked, speed) {
                    Ok((torque, speed)) => match at_load(subject, set, torque, speed, life) {
                        Ok(meshes) => {
                            let both =
                                meshes.iter().flat_map(|mesh| mesh.both(name, set.id, wanted.with_factors));
                            at_point.extend(both);
                        }
                        Err(Fault::Row(row)) => row.of_gear(name).join(&mut not_rated),
                        Err(Fault::Refused(error)) => return Err(*error),
                    },
                    Err(reason) => NotRated::new(set.id, reason).of_gear(name).join(&mut not_rated),
                }
            }
        }
    } else {
        if file.duty.is_empty() {
            return Err(Error::NoLoad);
        }
        if wanted.gear.is_some() || wanted.with_factors || wanted.input.speed.is_some() {
            return Err(Error::OfOnePoint);
        }
        let root = Path::root();
        check_shares(file.duty.iter().map(|step| step.share.0.si()))
            .map_err(|error| refused(subject.document, &root, &["duty"], &error.to_string()))?;
        let worked: Vec<Option<Worked<'_>>> = file
            .duty
            .iter()
            .enumerate()
            .map(|(place, step)| duty_step(subject, step, &root.clone().key("duty").index(place)))
            .collect::<Result<_, _>>()?;
        for set in &prepared {
            match duty_of(subject, set, &file.duty, &worked, life) {
                Ok(rated) => over_duty.extend(rated),
                Err(Fault::Row(row)) => row.join(&mut not_rated),
                Err(Fault::Refused(error)) => return Err(*error),
            }
        }
    }
    let governing = Governing::of(&at_point, &over_duty, required);
    let governing = governing
        .ok_or_else(|| Error::NothingRated { sets: not_rated.iter().map(NotRated::told).collect() })?;
    let warnings = records::below(&at_point, &over_duty, required);
    Ok(Strength {
        gearbox: subject.gearbox.name().to_owned(),
        edition: Edition::default().to_string(),
        operating_point: wanted.input.load.map(|_| OperatingPoint::of(wanted.input)),
        life_s: life.si(),
        oil_viscosity_m2_s: oil.viscosity.0.si(),
        required,
        governing,
        at_point,
        over_duty,
        not_rated,
        warnings,
    })
}

/// Torque on the sun without losses, its speed relative to the carrier, and the carrier's speed; 0 where only their rounding is left.
pub(crate) fn felt(
    place: usize,
    worked: &Worked<'_>,
    speed: AngularVelocity,
) -> Option<(Torque, [AngularVelocity; 2])> {
    let analysis = &worked.analysis;
    let (operation, case) = worked.operation.as_ref().zip(analysis.ideal())?;
    let members = case.members[place].as_ref()?;
    let motion = &analysis.sets()[place];
    // Balances and differences of speeds leave their rounding.
    let [torque, turning] = [members[0] / case.input, motion.relative?]
        .map(|share| if share.abs() < ROUNDED { 0.0 } else { share });
    Some((operation.input * torque, [speed * turning, speed * motion.carrier().unwrap_or(0.0)]))
}

/// Torque on the sun without losses and its speed relative to the carrier.
fn set_load(
    set: &RatedSet<'_>,
    worked: &Worked<'_>,
    speed: AngularVelocity,
) -> Result<(Torque, AngularVelocity), Reason> {
    let (torque, [turning, _]) = felt(set.place, worked, speed).ok_or(Reason::NoTorquesFollow)?;
    if torque.si() == 0.0 {
        Err(Reason::NoTorque)
    } else if turning.si() == 0.0 {
        Err(Reason::NoRolling)
    } else {
        Ok((torque, turning))
    }
}

fn both_loads(
    set: &RatedSet<'_>,
    torque: Torque,
    speed: AngularVelocity,
    life: Time,
) -> Result<[Load; 2], epicyclic_strength::Error> {
    loads(torque, speed, set.planets, set.teeth, life)
}

/// Both meshes of a set at a load.
fn at_load(
    subject: &Subject<'_>,
    set: &RatedSet<'_>,
    torque: Torque,
    speed: AngularVelocity,
    life: Time,
) -> Result<Vec<MeshAtPoint>, Fault> {
    let fault = |error: epicyclic_strength::Error| Fault::of(subject.document, set.id, &set.path, &error);
    let loads = both_loads(set, torque, speed, life).map_err(fault)?;
    let mesh = |(place, name): (usize, MeshName)| {
        let rating = rate(&set.meshes[place], &loads[place], &set.methods[place]).map_err(fault)?;
        let materials = [set.materials[place].clone(), set.materials[place + 1].clone()];
        Ok(MeshAtPoint { name, materials, load: loads[place], rating: Box::new(rating) })
    };
    MeshName::BOTH.into_iter().enumerate().map(|(place, name)| mesh((place, name))).collect()
}

/// A step of the duty; `None` where it does nothing.
pub(crate) fn duty_step<'g>(
    subject: &'g Subject<'_>,
    step: &DutyEntry,
    path: &Path,
) -> Result<Option<Worked<'g>>, Error> {
    let input = Input { speed: Some(step.speed.0), load: Some(InputLoad::Torque(step.torque.0)) };
    let idle = step.share.0.si() == 0.0 || step.torque.0.si() == 0.0 || step.speed.0.si() == 0.0;
    // A gear that does not exist is refused however little it does.
    let input = if idle { Input::default() } else { input };
    let worked = Worked::new(&subject.gearbox, &step.gear, input).map_err(|error| {
        let key = if matches!(error, Error::NoGear { .. }) { "gear" } else { "torque" };
        refused(subject.document, path, &[key], &error.to_string())
    })?;
    if idle {
        return Ok(None);
    }
    if worked.operation.is_none() {
        let message = format!("gear `{}` carries no such load from its input to its output", step.gear);
        return Err(refused(subject.document, path, &["gear"], &message));
    }
    Ok(Some(worked))
}

/// Both meshes of a set over the duty.
fn duty_of(
    subject: &Subject<'_>,
    set: &RatedSet<'_>,
    duty: &[DutyEntry],
    worked: &[Option<Worked<'_>>],
    life: Time,
) -> Result<Vec<OverDuty>, Fault> {
    let fault = |error: epicyclic_strength::Error| Fault::of(subject.document, set.id, &set.path, &error);
    let mut steps: [Vec<Step>; 2] = [vec![], vec![]];
    for (entry, worked) in duty.iter().zip(worked) {
        let idle = (Torque::from_si(0.0), AngularVelocity::from_si(0.0));
        let (torque, speed) = match worked {
            None => idle,
            Some(worked) => match set_load(set, worked, entry.speed.0) {
                Err(Reason::NoTorquesFollow) => {
                    return Err(Fault::Row(NotRated::new(set.id, Reason::NoTorquesFollow)));
                }
                Err(_) => idle,
                Ok(load) => load,
            },
        };
        let loads = both_loads(set, torque, speed, life).map_err(fault)?;
        for (steps, load) in steps.iter_mut().zip(loads) {
            steps.push(Step { share: entry.share.0.si(), torque: load.torque, speed: load.speed });
        }
    }
    let contacts =
        both_loads(set, Torque::from_si(0.0), AngularVelocity::from_si(0.0), life).map_err(fault)?;
    let mut all = vec![];
    for (place, name) in MeshName::BOTH.into_iter().enumerate() {
        let rating =
            rate_duty(&set.meshes[place], &steps[place], life, contacts[place].contacts, &set.methods[place])
                .map_err(fault)?;
        all.extend(OverDuty::both(set.id, name, &rating));
    }
    Ok(all)
}

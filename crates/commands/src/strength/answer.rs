//! Strength of teeth by ISO 6336: of a gearbox at an operating point in each gear, or over the duty of its
//! file, and against its overloads.
//!
//! | module | is |
//! |---|---|
//! | [`records`] | meshes and gears |
//! | `names` | meshes, gears, flanks and roots by name |
//! | `materials` | materials of a file |
//! | `missing` | keys that a file lacks, with usual values to paste |
//! | `not_rated` | what is not rated, and why |
//! | `sharing` | how planets share the load |
//! | `rated_set` | the meshes of a file's sets |
//! | `prepared` | simple sets of a file without their size |
//! | [`factors`] | factors by their symbols, each once |
//! | `idlers` | wheels that two pairs may share |
//! | `axial` | axial forces of helical teeth |
//! | `load` | the load of a set in a gear |
//! | `duty` | the steps of a duty, and a set over them |
//! | `overload` | a set against an overload |
//! | `bearings` | planet bearings over a duty |
//! | `partly` | results of the meshes of a set |
//! | `place` | where in the file a fault is |
//!
//! Torques are those without losses, speeds are relative to the carrier. Each mesh is rated alone with the
//! load that the solver finds of it; over a duty the damage of several meshes on one flank of a gear is
//! added.

mod axial;
mod axial_on_planets;
mod bearing_records;
pub(crate) mod bearings;
pub(crate) mod duty;
pub mod factors;
mod idlers;
pub(crate) mod load;
pub(crate) mod materials;
pub(crate) mod missing;
pub(crate) mod names;
mod not_rated;
pub mod on_shafts;
pub(crate) mod overload;
mod partly;
pub(crate) mod place;
pub(crate) mod prepared;
pub(crate) mod rated_set;
pub mod records;
mod sharing;
mod spans;
mod together;

use crate::analyze::answer::pins;
use crate::analyze::answer::warnings::tilting;
use crate::analyze::answer::{OperatingPoint, Worked};
use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::basis::Basis;
use crate::shared::gearbox::Gearbox;
use crate::shared::judgement::answer::Judgement;
use crate::shared::load::Load;
use crate::shared::toothed::lacking;
use crate::strength::options::Request;
use duty::WorkedStep;
use epicyclic_formats::Path;
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_strength::factor::Edition;
use epicyclic_strength::load::Floating;
use epicyclic_strength::rating::rate;
use epicyclic_train::{Gear, PlanetSet};
use epicyclic_units::Physical;
use load::{SetLoad, SharedFlanks};
use missing::{MissingKeys, Purpose};
use partly::Partly;
use place::{Fault, located};
use rated_set::RatedSet;
use records::{
    Against, AxialForce, BearingOverDuty, DutyStep, Governing, LoadSharing, MeshAtPoint, NotRated, OverDuty,
    Overloaded, Rated, Reason, Required, Safeties, all_safeties,
};
use schemars::JsonSchema;
use serde::Serialize;
use spans::above_0;
pub use together::SharedFlank;
use uom::si::f64::{KinematicViscosity, Time};

/// Stresses, limits and safeties of the teeth of a gearbox by ISO 6336, method B.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Strength {
    /// Name of the gearbox.
    pub gearbox: String,
    /// Edition of the standard.
    pub edition: String,
    /// Speed and load of the input; null over a duty.
    pub operating_point: Option<OperatingPoint>,
    /// Required life in s.
    pub life_s: f64,
    /// Viscosity of the oil at 40 °C, in m²/s.
    pub oil_viscosity_m2_s: f64,
    /// Required safeties.
    pub required: Required,
    /// Steps of the duty; empty at an operating point.
    pub duty: Vec<DutyStep>,
    /// Safety with the least margin over the required one; null if no teeth are rated, as when only planet
    /// bearings are.
    pub governing: Option<Governing>,
    /// Results for each gear of each mesh at the operating point; empty over a duty.
    pub at_point: Vec<Rated>,
    /// Results for each gear of each mesh over the duty; empty at an operating point.
    pub over_duty: Vec<OverDuty>,
    /// Flanks of gears that several meshes load over the duty, with their damage together; empty at an
    /// operating point.
    pub shared_flanks: Vec<SharedFlank>,
    /// Results for each gear of each mesh against the overloads of the file; at an operating point in one
    /// gear those of this gear only.
    pub overload: Vec<Overloaded>,
    /// Planet bearings with a load rating over the duty; empty at an operating point.
    pub bearings: Vec<BearingOverDuty>,
    /// Load sharing between planets, for sets for which the file gives no `K_γ`.
    pub load_sharing: Vec<LoadSharing>,
    /// Axial forces of sets with helical teeth, at the operating point or in each loaded step of the duty.
    pub axial_forces: Vec<AxialForce>,
    /// Sets that are not rated.
    pub not_rated: Vec<NotRated>,
    /// Judgement of the gearbox by rules of practice, at this load.
    pub judgement: Judgement,
    /// Warnings about the strength.
    pub warnings: Vec<Warning>,
}

impl Strength {
    /// Safeties of flank and root of each rated gear against each load.
    pub(crate) fn safeties(&self) -> impl Iterator<Item = Governing> {
        all_safeties(&self.at_point, &self.over_duty, &self.overload, self.required)
    }

    /// Whether any set is rated at the operating point, or over the duty; if neither is asked for, against an
    /// overload.
    #[must_use]
    pub fn is_rated(&self) -> bool {
        if self.operating_point.is_some() || !self.duty.is_empty() {
            let at_point = |one: &Rated| one.flank_safety.is_some() || one.root_safety.is_some();
            let over_duty = |one: &OverDuty| one.flank.is_some() || one.root.is_some();
            return self.at_point.iter().any(at_point) || self.over_duty.iter().any(over_duty);
        }
        self.overload.iter().any(|one| one.flank_safety.is_some() || one.root_safety.is_some())
    }
}

impl Answer for Strength {
    const NAME: &'static str = "strength";
}

/// Computes the strength of a gearbox from a file.
///
/// # Errors
/// - [`Error::MissingKeys`] for keys that the file lacks, [`Error::LoadWithoutSpeed`],
///   [`Error::OfOnePoint`] for a gear or speed of a duty.
/// - [`Error::Document`] for invalid data in the file, with the place; [`Error::NothingRated`] if neither
///   teeth nor planet bearings can be rated.
/// - [`Error::NoGear`], [`Error::Load`].
pub(crate) fn answer(subject: &Gearbox, request: &Request) -> Result<Strength, Error> {
    let strength = rated(subject, request, true)?;
    // A duty may load no rated teeth, but still wear planet bearings of compound sets.
    let is_borne = strength.bearings.iter().any(|bearing| bearing.greatest_force_n.is_some());
    if !strength.is_rated() && !is_borne {
        let missing = missing(subject, &subject.document.read()?, request)?;
        return Err(match missing.have_values() {
            true => missing.refused(),
            false => Error::NothingRated { sets: strength.not_rated.iter().map(NotRated::told).collect() },
        });
    }
    Ok(strength)
}

/// Keys that a file lacks for the strength at a load, or over its duty.
fn missing<'d>(
    subject: &'d Gearbox,
    file: &GearboxFile,
    request: &Request,
) -> Result<MissingKeys<'d>, Error> {
    let purpose = if request.load.input().load.is_some() { Purpose::AtPoint } else { Purpose::OverDuty };
    MissingKeys::of(subject, file, &Basis::default(), purpose)
}

/// What is missing for the strength over the duty of a file.
pub(crate) struct Lacking {
    /// Keys of the gearbox.
    pub(crate) keys: Vec<String>,
    /// Sets with keys of their own, and with those of the gearbox that only teeth need.
    pub(crate) not_rated: Vec<NotRated>,
}

/// Strength over the duty of a file, with the factors, or what is missing for it.
///
/// # Errors
/// Errors of [`answer`] except [`Error::NothingRated`].
pub(crate) fn over_duty(subject: &Gearbox, file: &GearboxFile) -> Result<Result<Strength, Lacking>, Error> {
    let known = [
        ("duty", !file.duty.is_empty() || !file.overload.is_empty()),
        ("life", file.life.is_some()),
        ("oil", file.oil.is_some()),
    ];
    let keys = lacking(&known);
    if !keys.is_empty() {
        let (_, not_rated) = rated_set::sets(subject, file)?;
        return Ok(Err(Lacking { keys, not_rated }));
    }
    let request = Request { gear: None, factors: true, load: Load::default() };
    rated(subject, &request, true).map(Ok)
}

/// Whether a file has oil, life and the `strength` of a set.
fn is_stated(file: &GearboxFile) -> bool {
    let has_strength = file.sets.iter().any(|set| set.strength.is_some())
        || file.compound_sets.iter().any(|set| set.strength.is_some());
    file.oil.is_some() && file.life.is_some() && has_strength
}

/// Warnings of gears that the duty of a file loads on both flanks, while their roots are rated as bent one
/// way; empty if the file has no duty, or lacks oil, life or the `strength` of a set.
///
/// # Errors
/// [`Error::Document`] for invalid data in the file, with the place.
pub(crate) fn reversed_bending(subject: &Gearbox) -> Result<Vec<Warning>, Error> {
    of_each_set(subject, &|_, set, steps| together::reversed(set, steps))
}

/// Warnings of sets whose planets keep an axial force over the duty, which no life of their bearings contains;
/// none without data for the strength.
///
/// # Errors
/// Those of the file.
pub(crate) fn axial_force(subject: &Gearbox) -> Result<Vec<Warning>, Error> {
    of_each_set(subject, &|_, set, steps| axial_on_planets::warning(subject, set, steps))
}

/// Warnings that the steps of planets tilt them over the duty.
///
/// # Errors
/// Those of the reader.
pub(crate) fn step_couple(subject: &Gearbox) -> Result<Vec<Warning>, Error> {
    of_each_set(subject, &|file, set, steps| axial_on_planets::couple(subject, file, set, steps))
}

/// A warning about a set of a file at the steps of its duty.
type OfSet<'w> = dyn Fn(&GearboxFile, &RatedSet<'_>, &[WorkedStep<'_>]) -> Option<Warning> + 'w;

/// A warning about the duty of each set with data for its strength.
fn of_each_set(subject: &Gearbox, warning: &OfSet<'_>) -> Result<Vec<Warning>, Error> {
    if subject.document.value().get("transmissions").is_some() {
        return Ok(vec![]);
    }
    let file: GearboxFile = subject.document.read()?;
    if file.duty.is_empty() || !is_stated(&file) {
        return Ok(vec![]);
    }
    let (sets, _) = rated_set::sets(subject, &file)?;
    let steps = duty::steps(subject, &file.duty)?;
    Ok(sets.iter().filter_map(|set| warning(&file, set, &steps)).collect())
}

/// Strength of a gearbox for a report, with the factors: at an operating point with load and speed, then over
/// the duty of the file. Empty if the file lacks oil, life or the `strength` of a set.
///
/// # Errors
/// Errors of [`answer`] except [`Error::NothingRated`].
pub(crate) fn chapters(subject: &Gearbox, load: Load) -> Result<Vec<Strength>, Error> {
    if subject.document.value().get("transmissions").is_some() {
        return Ok(vec![]);
    }
    let file: GearboxFile = subject.document.read()?;
    if !is_stated(&file) {
        return Ok(vec![]);
    }
    let input = load.input();
    let at_point = Some(load).filter(|_| input.load.is_some() && input.speed.is_some());
    let is_due = !file.duty.is_empty() || at_point.is_none() && !file.overload.is_empty();
    let in_life = Some(Load::default()).filter(|_| is_due);
    let chapter = |(place, load)| {
        // The overloads appear once, in the first chapter.
        rated(subject, &Request { gear: None, factors: true, load }, place == 0)
    };
    at_point.into_iter().chain(in_life).enumerate().map(chapter).collect()
}

/// Results of the calculation of a file.
#[derive(Default)]
struct Found {
    safeties: Safeties,
    axial: Vec<AxialForce>,
    shared: SharedFlanks,
    not_rated: Vec<NotRated>,
}

impl Found {
    /// Adds the results of a set, or the reason why it has none.
    fn take<T>(
        &mut self,
        rated: Result<Partly<T>, Fault>,
        to: fn(&mut Safeties) -> &mut Vec<T>,
        row: impl Fn(NotRated) -> NotRated,
    ) -> Result<(), Error> {
        match rated {
            Ok(Partly { rated, not_rated }) => {
                to(&mut self.safeties).extend(rated);
                for one in not_rated {
                    row(one).join(&mut self.not_rated);
                }
            }
            Err(Fault::Row(missing)) => row(*missing).join(&mut self.not_rated),
            Err(Fault::Refused(error)) => return Err(*error),
        }
        Ok(())
    }
}

/// Data of the file for the whole gearbox.
pub(crate) struct Asked {
    /// Required life.
    pub(crate) life: Time,
    /// Viscosity of the oil at 40 °C.
    pub(crate) viscosity: KinematicViscosity,
    /// Viscosity of the oil in the planets' bearings.
    pub(crate) working_viscosity: Option<KinematicViscosity>,
    /// Required safeties.
    pub(crate) required: Required,
}

impl Asked {
    /// Reads the data from the file.
    ///
    /// # Errors
    /// [`Error::MissingKeys`] for missing keys of the gearbox, [`Error::Document`] for required safeties that
    /// are not above 0.
    pub(crate) fn of(file: &GearboxFile, missing: &MissingKeys<'_>) -> Result<Self, Error> {
        let (Some(life), Some(oil), false) = (file.life, &file.oil, missing.are_of_gearbox()) else {
            return Err(missing.refused());
        };
        let required = Required::of(file.required.as_ref());
        required.check().map_err(|error| located(missing.document, &Path::root(), &error))?;
        let working_viscosity = oil.working_viscosity.map(|viscosity| viscosity.0);
        if let Some(viscosity) = working_viscosity {
            above_0(missing.document, viscosity, &Path::root().key("oil"), "working_viscosity")?;
        }
        Ok(Self { life: life.0, viscosity: oil.viscosity.0, working_viscosity, required })
    }
}

fn rated(subject: &Gearbox, request: &Request, with_overloads: bool) -> Result<Strength, Error> {
    let (gear, input) = (request.gear.as_deref(), request.load.input());
    let file: GearboxFile = subject.document.read()?;
    let (sets, not_rated) = rated_set::sets(subject, &file)?;
    let Asked { life, viscosity, required, .. } = Asked::of(&file, &missing(subject, &file, request)?)?;
    let mut found = Found { not_rated, ..Found::default() };
    let (mut bearings, mut shared_flanks) = (vec![], vec![]);
    let is_at_point = input.load.is_some();
    if is_at_point {
        at_point(subject, &sets, request, life, &mut found)?;
    } else {
        if gear.is_some() || input.speed.is_some() {
            return Err(Error::OfOnePoint);
        }
    }
    let is_over_duty = !is_at_point && !file.duty.is_empty();
    let steps = if is_over_duty { duty::steps(subject, &file.duty)? } else { vec![] };
    let peaks = overload::peaks(subject, &file.overload, gear)?;
    if is_over_duty {
        bearings = bearings::rated(subject, &file, &steps, &peaks)?;
        for set in &sets {
            for (number, WorkedStep(entry, worked)) in (1..).zip(&steps) {
                let load = worked.as_ref().map(|worked| SetLoad::of(set.place, worked, Some(entry.speed.0)));
                if let Some(Ok(load)) = load {
                    found.axial.extend(axial::of(subject, set, &entry.gear, Some(number), &load));
                }
            }
            shared_flanks.extend(together::of_set(set, &steps, life));
        }
        for set in &sets {
            let rated = duty::rated(subject, set, &steps, life, request.factors);
            found.take(rated, |all| &mut all.over_duty, |row| row.against(Against::Duty))?;
        }
    }
    if with_overloads {
        for peak in &peaks {
            for set in &sets {
                let rated = overload::rated(subject, set, peak, life);
                let row = |row: NotRated| row.against(Against::Overload).of_gear(peak.gear());
                found.take(rated, |all| &mut all.overload, row)?;
            }
        }
    }
    let Found { safeties, axial, shared, not_rated } = found;
    let governing = safeties.governing(required);
    let load_sharing = sharing(subject, &file, &sets, &bearings);
    let uneven = load_sharing.iter().filter_map(LoadSharing::warning);
    let short_lived = bearings.iter().filter_map(|bearing| bearing.warning(life));
    let is_left_out = |set: &&RatedSet<'_>| {
        let data = file.set_data(set.set);
        let has_spans = data.is_some_and(|data| data.has_bearing_spans());
        set.is_helical() && !set.set.is_pair() && !has_spans
    };
    let helical = sets.iter().filter(is_left_out);
    let helical: Vec<&str> = helical.map(|set| set.id).collect();
    let turning: Vec<&Worked<'_>> = steps.iter().filter_map(|step| step.1.as_ref()).collect();
    let idlers = idlers::warnings(subject, &file, &sets)?;
    let reversed = sets.iter().filter_map(|set| together::reversed(set, &steps));
    let axial_force = sets.iter().filter_map(|set| axial_on_planets::warning(subject, set, &steps));
    let couples = sets.iter().filter_map(|set| axial_on_planets::couple(subject, &file, set, &steps));
    let warnings = safeties
        .below(required)
        .into_iter()
        .chain(short_lived)
        .chain(uneven)
        .chain(idlers)
        .chain(reversed)
        .chain(pins::warning(subject, &turning, &[]))
        .chain(shared.warnings())
        .chain(shared_flanks.iter().filter_map(|shared| shared.warning(required)))
        .chain(tilting(&helical))
        .chain(axial_force)
        .chain(couples)
        .chain(overload::below_duty(&file))
        .collect();
    let duty = if is_at_point { vec![] } else { file.duty.iter().map(DutyStep::of).collect() };
    let Safeties { at_point, over_duty, overload } = safeties;
    Ok(Strength {
        gearbox: subject.train.name().to_owned(),
        edition: Edition::default().to_string(),
        operating_point: input.load.map(|_| OperatingPoint::of(input)),
        life_s: life.si(),
        oil_viscosity_m2_s: viscosity.si(),
        required,
        duty,
        governing,
        at_point,
        over_duty,
        shared_flanks,
        overload,
        bearings,
        load_sharing,
        axial_forces: axial,
        not_rated,
        judgement: Judgement::default(),
        warnings,
    })
}

/// Load sharing between planets, for rated sets and sets with rated bearings for which the file gives no
/// `K_γ`.
fn sharing(
    subject: &Gearbox,
    file: &GearboxFile,
    rated: &[RatedSet<'_>],
    bearings: &[BearingOverDuty],
) -> Vec<LoadSharing> {
    let of_set = |set: &PlanetSet| {
        let is_asked = rated.iter().any(|one| one.id == set.id() && !one.has_load_sharing())
            || bearings.iter().any(|one| one.set == set.id() && !one.load_sharing_is_given);
        let floating = file.set_data(set).and_then(|data| data.floating);
        let floating = floating.map_or(Floating::Assumed, materials::floating);
        set.planet_count()
            .filter(|planets| is_asked && *planets > 1 && !set.is_pair())
            .and_then(|planets| LoadSharing::of(set.id(), planets, floating))
    };
    subject.train.sets().iter().filter_map(of_set).collect()
}

/// Rates all sets in the requested gears.
fn at_point(
    subject: &Gearbox,
    sets: &[RatedSet<'_>],
    request: &Request,
    life: Time,
    found: &mut Found,
) -> Result<(), Error> {
    let input = request.load.input();
    let speed = input.speed.filter(|speed| speed.si() != 0.0).ok_or(Error::LoadWithoutSpeed)?;
    let names: Vec<&str> = match &request.gear {
        Some(name) => vec![name],
        None => subject.train.gears().iter().map(Gear::name).collect(),
    };
    for name in names {
        let worked = Worked::new(&subject.train, name, input)?;
        for set in sets {
            let load = SetLoad::of(set.place, &worked, Some(speed));
            let load = load.map_err(|reason| Fault::Row(NotRated::new(set.id, reason).into()));
            if let Ok(load) = &load {
                found.axial.extend(axial::of(subject, set, name, None, load));
                found.shared.add(set, name, load);
            }
            let meshes = load.and_then(|load| at_load(subject, set, &load, life));
            let rated = meshes.map(|Partly { rated, mut not_rated }| {
                let both = |mesh: &MeshAtPoint| mesh.both(name, set.id, request.factors);
                not_rated.extend(rated.iter().flat_map(|mesh| mesh.not_rated(set.id)));
                Partly { rated: rated.iter().flat_map(both).collect(), not_rated }
            });
            let row = |row: NotRated| row.against(Against::OperatingPoint).of_gear(name);
            found.take(rated, |all| &mut all.at_point, row)?;
        }
    }
    Ok(())
}

/// Rates the meshes of a set at a load.
fn at_load(
    subject: &Gearbox,
    set: &RatedSet<'_>,
    load: &SetLoad,
    life: Time,
) -> Result<Partly<MeshAtPoint>, Fault> {
    let fault = |error: epicyclic_strength::Error| Fault::of(&subject.document, set.id, &set.path, &error);
    let loads = load.meshes(set, life);
    Partly::of_meshes(set, |place, mesh| {
        let load = loads[place];
        if load.torque.si() == 0.0 {
            return Err(Fault::Row(NotRated::new(set.id, Reason::NoTorque).into()));
        }
        let rating = rate(&mesh.mesh, &load, &mesh.method).map_err(fault)?;
        let (name, materials) = (mesh.name.clone(), mesh.materials.clone());
        let tan_helix_angle = libm::tan(mesh.mesh.pair.gears()[0].profile().helix_angle.si());
        let rating = Box::new(rating);
        Ok((vec![MeshAtPoint { name, materials, load, tan_helix_angle, rating }], vec![]))
    })
}

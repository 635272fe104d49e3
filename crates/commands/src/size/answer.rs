//! Sizes of a gearbox's sets for the duty and the overloads of its file: modules, face widths, planets,
//! centre distances, bearings.
//!
//! Each set is sized independently. Why this loses no better design is explained at
//! [`epicyclic_strength::sizing`]. Values that the file gives for a set are kept.

mod layouts;
pub mod records;
mod saved;

use crate::analyze::answer::warnings::tilting;
use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::application::Application;
use crate::shared::basis::{Basis, BasisKey};
use crate::shared::fault::{Named, refused};
use crate::shared::gearbox::{Choice, Gearbox, one};
use crate::shared::judgement::answer::Judgement;
use crate::shared::tooth_checks::answer::ToothChecks;
use crate::size::options::{Effort, Request};
use crate::strength::answer::duty::{WorkedStep, steps};
use crate::strength::answer::load::felt;
use crate::strength::answer::missing::{MissingKeys, Purpose};
use crate::strength::answer::overload::{Peak, below_duty, peaks};
use crate::strength::answer::place::Fault;
use crate::strength::answer::prepared::{SetToSize, sets_to_size};
use crate::strength::answer::records::{NotRated, Reason, Required};
use crate::strength::answer::{Asked, axial_force, reversed_bending, step_couple};
use crate::tolerance::SAME;
use epicyclic_formats::Document;
use epicyclic_formats::gearbox::{GearboxFile, PlanetData};
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::family::Aim;
use epicyclic_judge::Limits;
use epicyclic_strength as strength;
use epicyclic_strength::factor::Edition;
use epicyclic_strength::sizing::Objective;
use epicyclic_strength::sizing::bearing::{Bearing, listed_plain, plain};
use epicyclic_strength::sizing::{
    Body, HeldShifts, Pin, SetOverload, SetStep, SetTeeth, SizedGear, SizedMesh, SizedPlanet, Sizing, Space,
    Task, search, size,
};
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::set::SetKind;
use epicyclic_units::Physical;
use epicyclic_units::format::trimmed;
use layouts::{Families, Making};
use records::{HeldKey, NotSized, SizedDesign, SizedSet, Sought};
pub use saved::saved;
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::ControlFlow;
use std::sync::Arc;
use uom::si::f64::{AngularVelocity, Length, Torque};

/// Sizes of a gearbox's sets with sufficient strength over the duty and the least mass or ring.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Size {
    /// Name of the gearbox.
    pub gearbox: String,
    /// Values assumed for what the file lacks, by key; empty without an application.
    pub basis: Vec<BasisKey>,
    /// Edition of the standard.
    pub edition: String,
    /// Required life of teeth and bearings, in s.
    pub life_s: f64,
    /// Viscosity of the oil at 40 °C, in m²/s.
    pub oil_viscosity_m2_s: f64,
    /// Required safeties.
    pub required: Required,
    /// Quantity that is minimized.
    pub minimise: Objective,
    /// Aim of the profile shifts.
    pub aim: Aim,
    /// Search space of each set, except for values that the file gives.
    pub sought: Sought,
    /// Number of designs of all sets together.
    pub designs: u64,
    /// Mass of the best designs of all sets, in kg; null if a set has none.
    pub mass_kg: Option<f64>,
    /// Mass of the best designs with carriers and housing, by a rule, in kg; null if a set has none.
    pub with_structure_kg: Option<f64>,
    /// Sets with their best designs.
    pub sets: Vec<SizedSet>,
    /// Sets that are not sized.
    pub not_sized: Vec<NotSized>,
    /// Judgement of the gearbox with the best sizes by rules of practice.
    pub judgement: Judgement,
    /// Warnings about the sizes.
    pub warnings: Vec<Warning>,
}

impl Answer for Size {
    const NAME: &'static str = "size";
}

/// Sizes the sets of a gearbox from a file. The closure `goes_on` is called now and then, and may end the
/// calculation.
///
/// # Errors
/// - [`Error::Sizing`] and [`Error::Gear`] for an empty space and impossible limits.
/// - [`Error::MissingKeys`] for keys that the file lacks.
/// - [`Error::Document`] for invalid data in the file, with the place.
/// - [`Error::NothingToSize`] if no set can be sized.
pub(crate) fn answer(
    subject: &Gearbox,
    request: &Request,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<Size, Error> {
    request.check()?;
    let assumed = request.completed(subject)?;
    let (subject, basis) = match &assumed {
        Some((completed, basis)) => (completed, basis.clone()),
        None => (subject, vec![]),
    };
    let file: GearboxFile = subject.document.read()?;
    let (to_size, others) = sets_to_size(subject, &file)?;
    let mut not_sized: Vec<NotSized> = others.into_iter().map(NotSized::of).collect();
    let missing = MissingKeys::of(subject, &file, &Basis::default(), Purpose::Sizes)?;
    let asked = Asked::of(&file, &missing)?;
    let steps = steps(subject, &file.duty)?;
    let peaks = peaks(subject, &file.overload, None)?;
    let is_left_out = |set: &&SetToSize<'_>| {
        let is_of_planet = |(kind, planet): (usize, &PlanetData)| {
            planet.bearing.is_some() && planet.bearing_span.is_none() && has_helix(set, kind)
        };
        set.data.planets.iter().enumerate().any(is_of_planet)
    };
    // The rows of a bearing of which the file states load ratings alone are not known.
    let spanless: Vec<&str> = to_size.iter().filter(is_left_out).map(|set| set.set.id()).collect();
    // The assembly angles of planets do not depend on sizes, so impossible angles are refused before the
    // search.
    let angles = subject.tooth_checks().checks.into_iter().filter(|check| check.rule == "planet-angle");
    for (set, why) in angles.filter_map(|check| Some((check.set, check.miss?))) {
        if let Some(set) = to_size.iter().find(|of| of.set.id() == set) {
            let why = Named("planet-angle", why);
            return Err(refused(&subject.document, &set.data.path, &["planet_angles"], &why));
        }
    }
    let (mut sets, mut no_size) = (vec![], vec![]);
    for set in &to_size {
        let id = set.set.id();
        let space = request.space();
        let families = Families::of(set);
        let (task, held) = task(set, &families, &asked, request, (&space, &subject.limits));
        let simple = || simple(set, (&task, &space), (&steps, &peaks), subject, request);
        // Pairs may state their centre distance.
        let found = match (!set.set.is_pair()).then(simple).flatten() {
            Some(Ok(sizing)) => size(&sizing, request.most.max(1), goes_on),
            Some(Err(reason)) => {
                not_sized.push(NotSized::of(NotRated::new(id, reason)));
                continue;
            }
            None => {
                let making = Making {
                    set,
                    families: &families,
                    rack: &subject.rack,
                    space: &space,
                    request,
                    steps: &steps,
                    peaks: &peaks,
                };
                match making.layouts(&task, goes_on) {
                    Ok(Ok((layouts, tried))) => search(&task, &layouts, tried, request.most.max(1), goes_on),
                    Ok(Err(reason)) => {
                        not_sized.push(NotSized::of(NotRated::new(id, reason)));
                        continue;
                    }
                    Err(Error::Sizing(error)) => Err(error),
                    Err(error) => return Err(error),
                }
            }
        };
        match found {
            Ok(found) => {
                let sized = SizedSet::of((set, &families), held, &found, request.most);
                no_size.extend(sized.warning(&found));
                sets.push(sized);
            }
            Err(
                error @ (strength::Error::Cancelled
                | strength::Error::NothingToSearch { .. }
                | strength::Error::OneBearingRow
                | strength::Error::SpaceTooLarge { .. }),
            ) => return Err(error.into()),
            Err(error) => match Fault::of(&subject.document, id, &set.data.path, &error) {
                Fault::Row(row) => not_sized.push(NotSized::of(*row)),
                Fault::Refused(error) => return Err(*error),
            },
        }
    }
    if sets.is_empty() && missing.have_values() {
        return Err(missing.refused());
    }
    if sets.is_empty() {
        return Err(Error::NothingToSize { sets: not_sized.iter().map(NotSized::told).collect() });
    }
    let sized = Document::parse_one(SIZED, saved::written(&subject.document, &sets)?.as_bytes())?;
    let has_size = |of: &str| sets.iter().any(|set| set.set == of && !set.found.is_empty());
    let sized = one(&sized, &Choice::default())?;
    let tooth_checks = ToothChecks::of(sized.tooth_checks(), has_size);
    // Sets without a size would be judged by what the file lacks of them.
    let judgement = if sets.iter().all(|set| !set.found.is_empty()) {
        Judgement::of(&sized, None, None, None)
    } else {
        Judgement::default()
    };
    let bearings = request.space().bearings;
    let unfitted = to_size.iter().filter_map(|set| unfitted(set, &bearings));
    let weak = below_duty(&file);
    let warnings = no_size.into_iter().chain(tilting(&spanless)).chain(weak).chain(unfitted);
    let judged = judgement.warnings(&[]);
    let reversed =
        reversed_bending(&sized)?.into_iter().chain(axial_force(&sized)?).chain(step_couple(&sized)?);
    let warnings = warnings.chain(tooth_checks.warnings()).chain(judged).chain(reversed).collect();
    Ok(Size {
        gearbox: subject.train.name().to_owned(),
        basis,
        edition: Edition::default().to_string(),
        life_s: asked.life.si(),
        oil_viscosity_m2_s: asked.viscosity.si(),
        required: asked.required,
        minimise: request.objective(),
        aim: request.aim,
        sought: Sought::of(request, &subject.limits),
        designs: sets.iter().map(|set| set.designs).sum(),
        mass_kg: sets.iter().map(|set| Some(set.found.first()?.mass_kg)).sum(),
        with_structure_kg: sets.iter().map(|set| set.found.first().map(SizedDesign::with_structure_kg)).sum(),
        sets,
        not_sized,
        judgement,
        warnings,
    })
}

impl Request {
    /// The gearbox with what is usual of the application, and these values; `None` if nothing is assumed.
    ///
    /// # Errors
    /// Those of the reader.
    pub(crate) fn completed(&self, subject: &Gearbox) -> Result<Option<(Gearbox, Vec<BasisKey>)>, Error> {
        let Some(basis) = self.application.map(Application::basis) else { return Ok(None) };
        MissingKeys::of(subject, &subject.document.read()?, &basis, Purpose::Sizes)?.assumed(&basis)
    }
}

/// The first set of a gearbox, simple or a pair, as a search that makes the layouts itself sees it.
///
/// # Errors
/// As of [`answer`]; [`Error::NothingToSize`] if it has no such set with all data.
pub(crate) fn sizing_of(subject: &Gearbox, request: &Request) -> Result<Sizing, Error> {
    request.check()?;
    let file: GearboxFile = subject.document.read()?;
    let (to_size, others) = sets_to_size(subject, &file)?;
    let missing = MissingKeys::of(subject, &file, &Basis::default(), Purpose::Sizes)?;
    let asked = Asked::of(&file, &missing)?;
    let steps = steps(subject, &file.duty)?;
    let peaks = peaks(subject, &file.overload, None)?;
    let space = request.space();
    let sized = to_size.first().and_then(|set| {
        let (task, _) = task(set, &Families::of(set), &asked, request, (&space, &subject.limits));
        let sizing = simple(set, (&task, &space), (&steps, &peaks), subject, request)?.ok()?;
        // Bounds of many sets would only find that nothing holds.
        Some(task.planets.iter().try_for_each(SizedPlanet::check_rows).map(|()| sizing))
    });
    let sized = sized.transpose()?;
    let sets = || others.into_iter().map(|other| NotSized::of(other).told()).collect();
    sized.ok_or_else(|| Error::NothingToSize { sets: sets() })
}

/// Name of the resized gearbox in error messages.
const SIZED: &str = "the gearbox with its sizes";

/// Loads of a simple set over the duty, and its overloads; `None` if its torques cannot be computed.
fn loads_of(
    set: &SetToSize<'_>,
    (steps, peaks): (&[WorkedStep<'_>], &[Peak<'_>]),
    subject: &Gearbox,
) -> Option<(Vec<SetStep>, Vec<SetOverload>)> {
    let still = AngularVelocity::from_si(0.0);
    let step = |step: &WorkedStep<'_>| {
        let WorkedStep(entry, worked) = step;
        let (sun_torque, [sun_speed, carrier_speed]) = match worked {
            None => {
                let turning = step.turning(subject);
                let felt = turning.and_then(|worked| felt(set.place, &worked, entry.speed.0));
                (Torque::from_si(0.0), felt.map_or([still; 2], |(_, speeds)| speeds))
            }
            Some(worked) => felt(set.place, worked, entry.speed.0)?,
        };
        Some(SetStep { share: entry.share.0.si(), sun_torque, sun_speed, carrier_speed })
    };
    let overloads = peaks.iter().map(|peak| peak.felt(set.place)).collect::<Option<_>>()?;
    Some((steps.iter().map(step).collect::<Option<_>>()?, overloads))
}

/// A simple set or a pair with its space, whose layouts the search makes itself; `None` of other sets.
fn simple(
    set: &SetToSize<'_>,
    (task, space): (&Task, &Space),
    (steps, peaks): (&[WorkedStep<'_>], &[Peak<'_>]),
    subject: &Gearbox,
    request: &Request,
) -> Option<Result<Sizing, Reason>> {
    let spec = set.set.short()?;
    let (teeth, gears, methods) = match (spec.kind, &set.teeth[..], &set.gears[..], &set.methods[..]) {
        (SetKind::Simple, [sun, planet, ring], [of_sun, of_planet, of_ring], [outer, inner]) => {
            (SetTeeth::Simple([*sun, *planet, *ring]), [*of_sun, *of_planet, *of_ring], [*outer, *inner])
        }
        (SetKind::ExternalPair, [first, second], [of_first, of_second], [mesh]) => {
            (SetTeeth::Pair([*first, *second]), [*of_first, *of_second, *of_second], [*mesh; 2])
        }
        _ => return None,
    };
    let Some((duty, overloads)) = loads_of(set, (steps, peaks), subject) else {
        return Some(Err(Reason::NoTorquesFollow));
    };
    let planet = task.planets.first();
    let counts = || set.set.planet_count().map_or_else(|| space.planets.clone(), |planets| vec![planets]);
    Some(Ok(Sizing {
        teeth,
        profiles: spec.profiles(&subject.rack),
        aim: request.aim,
        held_shifts: spec.tooth_shape.shifts.as_ref().map(|shifts| HeldShifts {
            profile: three(&shifts.profile),
            tips: shifts.tips.as_deref().map(three),
        }),
        limits: request.limits(),
        gears,
        methods,
        viscosity: task.viscosity,
        working_viscosity: task.working_viscosity,
        duty,
        overloads,
        life: task.life,
        required_contact: task.required_contact,
        required_root: task.required_root,
        planet_rim: task.planet_rim,
        ring_rim: task.ring_rim,
        planet_bore: planet.and_then(|planet| planet.bore),
        planet_mass: planet.and_then(|planet| planet.mass),
        widens_face_load: task.widens_face_load,
        planet_pin: planet.map(|planet| planet.pin).unwrap_or_default(),
        least_planet_angle: set.set.least_planet_angle(),
        objective: task.objective,
        practice: task.practice.clone(),
        space: Space {
            modules: set.data.modules[0].map_or_else(|| space.modules.clone(), |module| vec![module]),
            face_widths: task.face_widths[0].clone(),
            planets: if teeth.is_pair() { vec![1] } else { counts() },
            largest_ring: space.largest_ring.filter(|_| !teeth.is_pair()),
            bearings: planet.map_or_else(|| [].into(), |planet| Arc::clone(&planet.bearings)),
            ..space.clone()
        },
    }))
}

/// Task of a set, and the keys of the file that it keeps.
fn task(
    set: &SetToSize<'_>,
    families: &Families,
    asked: &Asked,
    request: &Request,
    (space, limits): (&Space, &Limits),
) -> (Task, Vec<HeldKey>) {
    let data = &set.data;
    let [planet_rim, ring_rim] = request.rims(limits);
    let is_stated = |keys: &[Option<Length>]| keys.iter().any(Option::is_some);
    let rim_of = |planets: bool| {
        let own = data.of.iter().zip(&set.gears);
        let is_ring = |gear: &GearOf| set.set.gear_kind(*gear) == Some(GearKind::Internal);
        let counts = |gear: &GearOf| if planets { matches!(gear, GearOf::Planet(..)) } else { is_ring(gear) };
        own.into_iter().any(|(gear, of)| counts(gear) && of.rim.is_some())
    };
    let held = [
        (HeldKey::Module, is_stated(&data.modules)),
        (HeldKey::FaceWidth, is_stated(&data.face_widths)),
        (HeldKey::Planets, set.set.planet_count().is_some()),
        (HeldKey::ProfileShifts, set.set.tooth_shape().shifts.is_some()),
        (HeldKey::LoadRating, data.planets.iter().any(|planet| planet.bearing.is_some())),
        (HeldKey::PlanetBore, data.planets.iter().any(|planet| planet.bore.is_some())),
        (HeldKey::PlanetRim, rim_of(true)),
        (HeldKey::RingRim, rim_of(false)),
    ];
    let body = |gear: &GearOf| match gear {
        GearOf::Central(_) => Body::Central,
        GearOf::Planet(planet, _) => Body::Planet(*planet),
    };
    let gear = |(place, gear): (usize, &GearOf)| SizedGear {
        gear: set.gears[place],
        body: body(gear),
        family: families.of[place],
    };
    let widths = |family: usize| {
        let own = data.face_widths.iter().zip(&families.of).filter(|(_, of)| **of == family);
        let stated = own.filter_map(|(width, _)| *width);
        let least = stated.reduce(|one, other| if one < other { one } else { other });
        let mut all = least.map_or_else(|| space.face_widths.clone(), |width| vec![width]);
        all.sort_by(|one, other| one.si().total_cmp(&other.si()));
        all.dedup();
        all
    };
    let planet = |(kind, planet): (usize, &PlanetData)| SizedPlanet {
        is_tilted: set.set.is_stepped(kind) || has_helix(set, kind),
        bearings: match (planet.bearing, planet.bore) {
            (Some((load_rating, rolling)), bore) => Arc::from([Bearing {
                designation: String::new(),
                rolling,
                bore: Length::default(),
                outside_diameter: bore.unwrap_or_default(),
                width: Length::default(),
                rows: 0,
                load_rating,
                static_load_rating: planet.static_load_rating,
            }]),
            (None, Some(bore)) if planet.is_on_plain_bearings() => [plain(bore)].into(),
            (None, Some(bore)) => fitting(&space.bearings, bore).into(),
            (None, None) if planet.is_on_plain_bearings() && request.bearing_type.is_none() => {
                listed_plain().into()
            }
            (None, None) => Arc::clone(&space.bearings),
        },
        bore: planet.bore,
        mass: planet.mass,
        sharing: planet.load_sharing,
        pin: Pin {
            rolling: planet.rolling.into(),
            mean_diameter: planet.bearing_diameter,
            span: planet.bearing_span,
        },
    };
    let task = Task {
        gears: data.of.iter().enumerate().map(gear).collect(),
        meshes: families
            .ends
            .iter()
            .zip(&set.methods)
            .map(|(ends, method)| SizedMesh { gears: *ends, method: *method })
            .collect(),
        planets: data.planets.iter().enumerate().map(planet).collect(),
        // Sets with two central gears have keys for one bearing.
        has_one_bearing: set.set.short().is_some(),
        face_widths: (0..families.count).map(widths).collect(),
        width_ratio: space.width_ratio,
        largest_ring: space.largest_ring,
        length_price: space.length_price,
        viscosity: set.viscosity,
        working_viscosity: asked.working_viscosity,
        life: asked.life,
        required_contact: asked.required.flank,
        required_root: asked.required.root,
        planet_rim,
        ring_rim,
        objective: request.objective(),
        least_planet_angle: set.set.least_planet_angle(),
        has_stated_shifts: set.set.tooth_shape().shifts.is_some(),
        widens_face_load: request.widens_face_load,
        asks_nearest: request.effort == Effort::Full,
        practice: request.practice(limits),
    };
    (task, held.into_iter().filter(|(_, is_held)| *is_held).map(|(key, _)| key).collect())
}

/// Whether planets of a kind have helical teeth, whose axial forces tilt them.
fn has_helix(set: &SetToSize<'_>, kind: usize) -> bool {
    let is_own = |gear: &GearOf| matches!(gear, GearOf::Planet(own, _) if *own == kind);
    let mut meshes =
        (0..set.set.meshes().len()).filter(|mesh| set.set.gears_of_mesh(*mesh).iter().any(is_own));
    meshes.any(|mesh| set.set.tooth_shape().helix_angle(mesh).si() != 0.0)
}

/// Bearings with this outside diameter.
fn fitting(bearings: &[Bearing], bore: Length) -> Vec<Bearing> {
    let fits = |one: &&Bearing| (one.outside_diameter / bore).si() - 1.0;
    bearings.iter().filter(|one| fits(one).abs() <= SAME).cloned().collect()
}

/// Warning of planets that get no bearing since none has the stated bore as its outside diameter.
fn unfitted(set: &SetToSize<'_>, bearings: &[Bearing]) -> Option<Warning> {
    let is_open = |planet: &PlanetData| planet.bearing.is_none() && !planet.is_on_plain_bearings();
    let stated = set.data.planets.iter().enumerate().filter(|(_, planet)| is_open(planet));
    let mut bores = stated.filter_map(|(place, planet)| Some((place, planet.bore?)));
    let (place, bore) =
        bores.find(|(_, bore)| !bearings.is_empty() && fitting(bearings, *bore).is_empty())?;
    let planet = match set.set.planets() {
        [_] => "planets".to_owned(),
        several => several[place].name.clone(),
    };
    Some(Warning {
        name: "no-bearing",
        message: format!(
            "set {}: the {planet} keep their bore of {} mm without a bearing, since none of the list has this outside diameter; state `load_rating`, leave the bore out, or give other bearings",
            set.set.id(),
            trimmed(bore.mm(), 6)
        ),
    })
}

/// Values of sun, planets and ring.
fn three(values: &[f64]) -> [f64; 3] {
    [0, 1, 2].map(|gear: usize| values.get(gear).copied().unwrap_or_default())
}

//! Sizes of a gearbox's simple sets for the duty and the overloads of its file: module, face width, planets,
//! centre distance, bearing.
//!
//! Each set is sized independently. Why this loses no better design is explained at
//! [`epicyclic_strength::sizing`]. Values that the file gives for a set are kept.

pub mod records;
mod saved;

use crate::analyze::answer::warnings::tilting;
use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::fault::{Named, refused};
use crate::shared::gearbox::{Choice, Gearbox, one};
use crate::shared::tooth_checks::answer::ToothChecks;
use crate::size::options::Request;
use crate::strength::answer::Asked;
use crate::strength::answer::duty::{WorkedStep, steps};
use crate::strength::answer::load::felt;
use crate::strength::answer::overload::peaks;
use crate::strength::answer::place::Fault;
use crate::strength::answer::prepared::{SetToSize, sets_to_size};
use crate::strength::answer::records::{NotRated, Reason, Required};
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_formats::{Document, Path};
use epicyclic_gears::involute::family::Aim;
use epicyclic_strength as strength;
use epicyclic_strength::factor::Edition;
use epicyclic_strength::sizing::Objective;
use epicyclic_strength::sizing::bearing::Bearing;
use epicyclic_strength::sizing::{HeldShifts, SetOverload, SetStep, Sizing, size};
use epicyclic_units::Physical;
use records::{HeldKey, NotSized, SizedSet, Sought};
pub use saved::saved;
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::ControlFlow;
use uom::si::f64::{AngularVelocity, Length, Time, Torque};

/// Sizes of a gearbox's simple sets with sufficient strength over the duty and the least mass or ring.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Size {
    /// Name of the gearbox.
    pub gearbox: String,
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
    /// Sets with their best designs.
    pub sets: Vec<SizedSet>,
    /// Sets that are not sized.
    pub not_sized: Vec<NotSized>,
    /// Tooth checks of the sets with their best sizes.
    pub tooth_checks: ToothChecks,
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
/// - [`Error::NoLoad`] without a duty; [`Error::Document`] for invalid data in the file, with the place.
/// - [`Error::NothingToSize`] if no set can be sized.
pub(crate) fn answer(
    subject: &Gearbox,
    request: &Request,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<Size, Error> {
    request.check()?;
    let file: GearboxFile = subject.document.read()?;
    let (to_size, others) = sets_to_size(subject, &file)?;
    let mut not_sized: Vec<NotSized> = others.into_iter().map(NotSized::of).collect();
    let Asked { life, viscosity, required } = Asked::of(&subject.document, &file)?;
    if file.duty.is_empty() {
        let message =
            "`duty` is missing: sizes follow from a duty: gear, share, torque and speed of each step";
        return Err(refused(&subject.document, &Path::root(), &[], &Named("missing-key", message)));
    }
    let steps = steps(subject, &file.duty)?;
    let peaks = peaks(subject, &file.overload, None)?;
    let helical = to_size.iter().filter(|set| set.profiles.shared().is_helical());
    let helical: Vec<&str> = helical.map(|set| set.id).collect();
    // The assembly angles of planets do not depend on sizes, so impossible angles are refused before the
    // search.
    let angles = subject.tooth_checks().checks.into_iter().filter(|check| check.rule == "planet-angle");
    for (set, why) in angles.filter_map(|check| Some((check.set, check.miss?))) {
        if let Some(set) = to_size.iter().find(|of| of.id == set) {
            let why = Named("planet-angle", why);
            return Err(refused(&subject.document, &set.path, &["planet_angles"], &why));
        }
    }
    let mut sets = vec![];
    for set in &to_size {
        let overloads = peaks.iter().map(|peak| peak.felt(set.place)).collect::<Option<Vec<_>>>();
        let Some(load) = duty_of(set, &steps).zip(overloads) else {
            not_sized.push(NotSized::of(NotRated::new(set.id, Reason::NoTorquesFollow)));
            continue;
        };
        let (task, held) = task(set, load, life, required, request);
        match size(&task, request.most.max(1), goes_on) {
            Ok(found) => sets.push(SizedSet::of(set, held, &found, request.most)),
            Err(
                error @ (strength::Error::Cancelled
                | strength::Error::NothingToSearch { .. }
                | strength::Error::SpaceTooLarge { .. }),
            ) => return Err(error.into()),
            Err(error) => match Fault::of(&subject.document, set.id, &set.path, &error) {
                Fault::Row(row) => not_sized.push(NotSized::of(*row)),
                Fault::Refused(error) => return Err(*error),
            },
        }
    }
    if sets.is_empty() {
        return Err(Error::NothingToSize { sets: not_sized.iter().map(NotSized::told).collect() });
    }
    let sized = Document::parse_one(SIZED, saved::written(&subject.document, &sets)?.as_bytes())?;
    let has_size = |of: &str| sets.iter().any(|set| set.set == of && !set.found.is_empty());
    let tooth_checks = ToothChecks::of(one(&sized, &Choice::default())?.tooth_checks(), has_size);
    let warnings = sets.iter().filter_map(SizedSet::warning).chain(tilting(&helical));
    let warnings = warnings.chain(tooth_checks.warnings()).collect();
    Ok(Size {
        gearbox: subject.train.name().to_owned(),
        edition: Edition::default().to_string(),
        life_s: life.si(),
        oil_viscosity_m2_s: viscosity.si(),
        required,
        minimise: request.minimise,
        aim: request.aim,
        sought: Sought::of(request),
        designs: sets.iter().map(|set| set.designs).sum(),
        mass_kg: sets.iter().map(|set| Some(set.found.first()?.mass_kg)).sum(),
        sets,
        not_sized,
        tooth_checks,
        warnings,
    })
}

/// Name of the resized gearbox in error messages.
const SIZED: &str = "the gearbox with its sizes";

/// Duty as loads of a set; `None` if its torques cannot be computed.
fn duty_of(set: &SetToSize<'_>, steps: &[WorkedStep<'_>]) -> Option<Vec<SetStep>> {
    let still = AngularVelocity::from_si(0.0);
    let step = |WorkedStep(entry, worked): &WorkedStep<'_>| {
        let (sun_torque, [sun_speed, carrier_speed]) = match worked {
            None => (Torque::from_si(0.0), [still; 2]),
            Some(worked) => felt(set.place, worked, entry.speed.0)?,
        };
        Some(SetStep { share: entry.share.0.si(), sun_torque, sun_speed, carrier_speed })
    };
    steps.iter().map(step).collect()
}

/// Sizing task of a set, and the keys of the file that it keeps.
fn task(
    set: &SetToSize<'_>,
    (duty, overloads): (Vec<SetStep>, Vec<SetOverload>),
    life: Time,
    required: Required,
    request: &Request,
) -> (Sizing, Vec<HeldKey>) {
    let mut space = request.space();
    let mut held = vec![];
    let entry = set.entry;
    if let Some(module) = entry.module {
        space.modules = vec![module.0];
        held.push(HeldKey::Module);
    }
    if let Some(width) = entry.face_width {
        space.face_widths = vec![width.0];
        held.push(HeldKey::FaceWidth);
    }
    if let Some(planets) = set.planets {
        space.planets = vec![planets];
        held.push(HeldKey::Planets);
    }
    if set.shifts.is_some() {
        held.push(HeldKey::ProfileShifts);
    }
    let bore = entry.planet_bore.map(|bore| bore.0);
    if let Some(rating) = entry.load_rating {
        space.bearings = vec![Bearing {
            designation: String::new(),
            rolling: entry.bearing_rolling.into(),
            bore: Length::from_si(0.0),
            outside_diameter: bore.unwrap_or(Length::from_si(0.0)),
            width: Length::from_si(0.0),
            load_rating: rating.0,
            static_load_rating: None,
        }];
        held.push(HeldKey::LoadRating);
    } else if bore.is_some() {
        space.bearings.clear();
    }
    if bore.is_some() {
        held.push(HeldKey::PlanetBore);
    }
    let strength = entry.strength.as_ref();
    let [least_planet_rim, held_ring_rim] =
        [strength.and_then(|of| of.planet_rim.as_ref()), strength.and_then(|of| of.ring_rim.as_ref())]
            .map(|rim| rim.map(|rim| rim.0));
    if least_planet_rim.is_some() {
        held.push(HeldKey::PlanetRim);
    }
    if held_ring_rim.is_some() {
        held.push(HeldKey::RingRim);
    }
    let task = Sizing {
        teeth: set.teeth,
        profiles: set.profiles,
        aim: request.aim,
        held_shifts: set.shifts.as_ref().map(|shifts| HeldShifts {
            profile: three(&shifts.profile),
            tips: shifts.tips.as_deref().map(three),
        }),
        limits: request.limits(),
        gears: set.gears,
        methods: set.methods,
        viscosity: set.viscosity,
        duty,
        overloads,
        life,
        required_contact: required.flank,
        required_root: required.root,
        planet_rim: request.planet_rim.get(),
        least_planet_rim,
        ring_rim: request.ring_rim.get(),
        held_ring_rim,
        planet_bore: bore,
        least_planet_angle: set.least_planet_angle,
        objective: request.minimise,
        space,
    };
    (task, held)
}

/// Values of sun, planets and ring.
fn three(values: &[f64]) -> [f64; 3] {
    [0, 1, 2].map(|gear: usize| values.get(gear).copied().unwrap_or_default())
}

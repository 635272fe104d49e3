//! The size of a gearbox's simple sets over the duty and against the overloads of its file: module, face
//! width, planets, centre distance, bearing.
//!
//! Each set is sized by itself; why nothing better is lost is told at [`epicyclic_strength::sizing`]. What
//! the file gives of a set is held.

pub mod records;
mod saved;

use crate::analyze::answer::warnings::tilting;
use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::fault::Named;
use crate::shared::gearbox::{Choice, Subject, alone, one};
use crate::shared::tooth_checks::answer::ToothChecks;
use crate::strength::answer::Asked;
use crate::strength::answer::duty::{WorkedStep, steps};
use crate::strength::answer::load::felt;
use crate::strength::answer::overload::peaks;
use crate::strength::answer::place::{Fault, refused};
use crate::strength::answer::prepared::{SetToSize, sets_to_size};
use crate::strength::answer::records::{NotRated, Reason, Required};
use crate::teeth::answer::shifted::ShiftAim;
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_formats::{Document, Path};
use epicyclic_gears::involute::set::Limits;
use epicyclic_gears::mesh::USUAL_PLANET_GAP;
use epicyclic_strength::factor::Edition;
pub use epicyclic_strength::sizing::bearing::Bearing;
use epicyclic_strength::sizing::bearing::parse;
pub use epicyclic_strength::sizing::bearing::{listed, listed_rollers};
use epicyclic_strength::sizing::{
    HeldShifts, STANDARD_MODULES_MM, SetOverload, SetStep, Sizing, Space, size,
};
use epicyclic_strength::{self as strength, Quantity};
use epicyclic_units::Physical;
use records::{HeldKey, Minimise, NotSized, SizedSet, Sought};
pub use saved::saved;
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::{ControlFlow, RangeInclusive};
use uom::si::f64::{AngularVelocity, Length, Time, Torque};

/// How far centre distances may be from the natural one, in modules.
const REACH: f64 = 1.0;

/// The greatest module of the standard series that is taken unless others are wanted, mm.
const GREATEST_MODULE_MM: f64 = 20.0;

/// What is sought.
#[derive(Debug, Clone, PartialEq)]
pub struct Wanted {
    /// Modules.
    pub modules: Vec<Length>,
    /// Face widths.
    pub face_widths: Vec<Length>,
    /// Numbers of planets.
    pub planets: RangeInclusive<u32>,
    /// Step of the centre distances.
    pub centre_distance_step: Length,
    /// The greatest face width over the sun's reference diameter.
    pub width_ratio: Option<f64>,
    /// What picks the shifts.
    pub aim: ShiftAim,
    /// Least normal thickness of the tips, modules.
    pub tip_thickness: f64,
    /// Least rim of the planets between root circle and bearing, modules.
    pub planet_rim: f64,
    /// Rim of the ring outside its root circle, modules.
    pub ring_rim: f64,
    /// Bearings of the planets; none where they are no matter.
    pub bearings: Vec<Bearing>,
    /// Bearings side by side in a planet, at most: 1 or 2.
    pub bearing_rows: u32,
    /// What is minimised.
    pub minimise: Minimise,
    /// How many designs of each set are told.
    pub most: usize,
}

impl Default for Wanted {
    /// Modules of series I of ISO 54 up to 20 mm, face widths of 10 to 80 mm in steps of 5, 3 to 6 planets,
    /// centre distances in steps of 0.5 mm, the bearings of the table, single and in pairs, the least mass.
    fn default() -> Self {
        let mm = Length::from_mm;
        Self {
            modules: STANDARD_MODULES_MM.into_iter().filter(|m| *m <= GREATEST_MODULE_MM).map(mm).collect(),
            face_widths: (2..=16).map(|fives| mm(5.0 * f64::from(fives))).collect(),
            planets: 3..=6,
            centre_distance_step: mm(0.5),
            width_ratio: None,
            aim: ShiftAim::BalancedSliding,
            tip_thickness: 0.2,
            planet_rim: 3.0,
            ring_rim: 3.5,
            bearings: listed().to_vec(),
            bearing_rows: 2,
            minimise: Minimise::Mass,
            most: 3,
        }
    }
}

impl Wanted {
    fn space(&self) -> Space {
        Space {
            modules: self.modules.clone(),
            face_widths: self.face_widths.clone(),
            planets: self.planets.clone().collect(),
            centre_distance_step: self.centre_distance_step,
            reach: REACH,
            width_ratio: self.width_ratio,
            bearings: {
                let pairs = self.bearings.iter().filter(|_| self.bearing_rows > 1).map(Bearing::pair);
                self.bearings.iter().cloned().chain(pairs).collect()
            },
        }
    }

    fn limits(&self) -> Limits {
        Limits { tip_thickness: self.tip_thickness, planet_gap: USUAL_PLANET_GAP, ..Limits::default() }
    }

    /// Refuses what is no space, whatever the file holds.
    fn check(&self) -> Result<(), Error> {
        self.space().check()?;
        for (quantity, value) in
            [(Quantity::LeastRim, self.planet_rim), (Quantity::RingRimInModules, self.ring_rim)]
        {
            if !(value.is_finite() && value >= 0.0) {
                return Err(strength::Error::Negative { quantity, value, unit: "modules" }.into());
            }
        }
        Ok(self.limits().check()?)
    }
}

/// The bearings of a table of one's own.
///
/// # Errors
/// [`Error::Sizing`], with line and column.
pub fn bearings(table: &str) -> Result<Vec<Bearing>, Error> {
    Ok(parse(table)?)
}

/// The sizes of a gearbox's simple sets that hold over the duty with the least mass or ring.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Size {
    /// Name of the gearbox.
    pub gearbox: String,
    /// Edition of the standard.
    pub edition: String,
    /// Required life of teeth and bearings.
    pub life_s: f64,
    /// Viscosity of the oil at 40 °C.
    pub oil_viscosity_m2_s: f64,
    /// Required safeties.
    pub required: Required,
    /// What is minimised.
    pub minimise: Minimise,
    /// What picks the shifts.
    pub aim: ShiftAim,
    /// The space of each set, as far as its file does not hold it.
    pub sought: Sought,
    /// Designs of all sets together.
    pub designs: u64,
    /// Mass of the best designs of all sets; `null` where one has none.
    pub mass_kg: Option<f64>,
    /// The sets.
    pub sets: Vec<SizedSet>,
    /// Sets that are not sized.
    pub not_sized: Vec<NotSized>,
    /// The checks of the teeth of the sets with their best sizes.
    pub tooth_checks: ToothChecks,
    /// What the reader should know.
    pub warnings: Vec<Warning>,
}

impl Answer for Size {
    const NAME: &'static str = "size";
}

/// The gearbox of a file whose sizes are sought.
///
/// # Errors
/// [`Error::Document`] for a description that is no gearbox, and for a list of transmissions.
pub fn subject(document: &Document) -> Result<Subject<'_>, Error> {
    alone(document, "size", "no teeth, materials or loads")
}

/// The sizes of the sets of a gearbox from a file, unless `goes_on`, which is asked now and then, breaks.
///
/// # Errors
/// - [`Error::Sizing`] and [`Error::Gear`] for a space of nothing, and for limits that are none.
/// - [`Error::NoLoad`] without a duty; [`Error::Document`] for what the file says wrong, with its place.
/// - [`Error::NothingToSize`] where no set can be sized.
pub fn answer(
    subject: &Subject<'_>,
    wanted: &Wanted,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<Size, Error> {
    wanted.check()?;
    let file: GearboxFile = subject.document.read()?;
    let (to_size, others) = sets_to_size(subject, &file)?;
    let mut not_sized: Vec<NotSized> = others.into_iter().map(NotSized::of).collect();
    let Asked { life, viscosity, required } = Asked::of(subject.document, &file)?;
    if file.duty.is_empty() {
        let message =
            "`duty` is missing: sizes follow from a duty: gear, share, torque and speed of each step";
        return Err(refused(subject.document, &Path::root(), &[], &Named("missing-key", message)));
    }
    let steps = steps(subject, &file.duty)?;
    let peaks = peaks(subject, &file.overload, None)?;
    let helical = to_size.iter().filter(|set| set.profiles.shared().is_helical());
    let helical: Vec<&str> = helical.map(|set| set.id).collect();
    // Sizes do not change where planets assemble.
    let angles = subject.tooth_checks().checks.into_iter().filter(|check| check.rule == "planet-angle");
    for (set, why) in angles.filter_map(|check| Some((check.set, check.miss?))) {
        if let Some(set) = to_size.iter().find(|of| of.id == set) {
            let why = Named("planet-angle", why);
            return Err(refused(subject.document, &set.path, &["planet_angles"], &why));
        }
    }
    let mut sets = vec![];
    for set in &to_size {
        let overloads = peaks.iter().map(|peak| peak.felt(set.place)).collect::<Option<Vec<_>>>();
        let Some(load) = duty_of(set, &steps).zip(overloads) else {
            not_sized.push(NotSized::of(NotRated::new(set.id, Reason::NoTorquesFollow)));
            continue;
        };
        let (task, held) = task(set, load, life, required, wanted);
        match size(&task, wanted.most.max(1), goes_on) {
            Ok(found) => sets.push(SizedSet::of(set, held, &found, wanted.most)),
            Err(
                error @ (strength::Error::Cancelled
                | strength::Error::NothingToSearch { .. }
                | strength::Error::SpaceTooLarge { .. }),
            ) => return Err(error.into()),
            Err(error) => match Fault::of(subject.document, set.id, &set.path, &error) {
                Fault::Row(row) => not_sized.push(NotSized::of(row)),
                Fault::Refused(error) => return Err(*error),
            },
        }
    }
    if sets.is_empty() {
        return Err(Error::NothingToSize { sets: not_sized.iter().map(NotSized::told).collect() });
    }
    let sized = Document::parse_one(SIZED, saved::written(subject.document, &sets)?.as_bytes())?;
    let has_size = |of: &str| sets.iter().any(|set| set.set == of && !set.found.is_empty());
    let tooth_checks = ToothChecks::of(one(&sized, &Choice::default())?.tooth_checks(), has_size);
    let warnings = sets.iter().filter_map(SizedSet::warning).chain(tilting(&helical));
    let warnings = warnings.chain(tooth_checks.warnings()).collect();
    Ok(Size {
        gearbox: subject.gearbox.name().to_owned(),
        edition: Edition::default().to_string(),
        life_s: life.si(),
        oil_viscosity_m2_s: viscosity.si(),
        required,
        minimise: wanted.minimise,
        aim: wanted.aim,
        sought: Sought::of(wanted),
        designs: sets.iter().map(|set| set.designs).sum(),
        mass_kg: sets.iter().map(|set| Some(set.found.first()?.mass_kg)).sum(),
        sets,
        not_sized,
        tooth_checks,
        warnings,
    })
}

/// Name of the file with the sizes in messages.
const SIZED: &str = "the gearbox with its sizes";

/// The duty as a set feels it; `None` where no torques follow.
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

/// What is sought of a set, and what the file holds of it.
fn task(
    set: &SetToSize<'_>,
    (duty, overloads): (Vec<SetStep>, Vec<SetOverload>),
    life: Time,
    required: Required,
    wanted: &Wanted,
) -> (Sizing, Vec<HeldKey>) {
    let mut space = wanted.space();
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
        aim: wanted.aim.into(),
        held_shifts: set.shifts.map(|shifts| HeldShifts { profile: shifts.profile, tips: shifts.tips }),
        limits: wanted.limits(),
        gears: set.gears,
        methods: set.methods,
        viscosity: set.viscosity,
        duty,
        overloads,
        life,
        required_contact: required.flank,
        required_root: required.root,
        planet_rim: wanted.planet_rim,
        least_planet_rim,
        ring_rim: wanted.ring_rim,
        held_ring_rim,
        planet_bore: bore,
        least_planet_angle: set.least_planet_angle,
        objective: wanted.minimise.into(),
        space,
    };
    (task, held)
}

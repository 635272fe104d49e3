//! A gearbox from speeds and power to sizes that hold: its scheme, its tooth numbers, its sizes with their strength.
//!
//! | module | is |
//! |---|---|
//! | [`basis`] | materials, factors, oil and life that no speed tells |
//! | [`records`] | the steps, each with what it chose and what came next |
//!
//! Each step takes the best of the one before it, so that a person can follow it and choose otherwise: all steps together are not
//! searched. Another scheme, or other tooth numbers, may give a lighter gearbox.

pub mod basis;
pub mod records;

use crate::gearbox::{Choice, one};
use crate::select::saved::Saved;
use crate::select::teeth::{self, Searches, SizeLimits, Watch};
use crate::size::Size;
use crate::size::records::Minimise;
use crate::teeth::shifted::WantedShifts;
use crate::{Answer, Error, Warning, select, size};
use basis::Basis;
use epicyclic_formats::quantity::format::trimmed;
use epicyclic_formats::yaml::{Mapping, Value, to_string};
use epicyclic_formats::{Document, Physical};
use epicyclic_gears::synthesis::Bounds;
use epicyclic_selection::{Mechanism, Objective, Order, Space};
use epicyclic_train::Gear;
use records::{BasisKey, SchemeStep, SizesStep, TeethStep};
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::{ControlFlow, RangeInclusive};
use uom::si::f64::{AngularVelocity, Torque};

/// What is wanted.
#[derive(Debug, Clone)]
pub struct Wanted {
    /// Ratios, criteria, order, mechanisms and load; speed and load of the input are needed.
    pub selection: select::Wanted,
    /// One mechanism in place of the best; it must meet the criteria all the same.
    pub mechanism: Option<Mechanism>,
    /// Bounds of tooth numbers and of planets.
    pub bounds: Bounds,
    /// Offsets of the rings of sets with profile shift, in place of sets that need none. The sizes pick the shifts anew at their centre
    /// distances, by the same aim and tip thickness.
    pub ring_offsets: Option<RangeInclusive<i32>>,
    /// Which design of the tooth search.
    pub teeth: Teeth,
    /// Shares of the time of the gears, the slowest first, then reverse gears; equal where there are none.
    pub shares: Vec<f64>,
    /// The greatest torque of the life over that of the load, in every gear.
    pub overload: Option<f64>,
    /// Materials, factors, oil, life.
    pub basis: Basis,
    /// The space of sizes.
    pub size: size::Wanted,
}

/// Which design of the tooth search is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Teeth {
    /// That of a number, from 1.
    Number(usize),
    /// Of so many, the first of them in the order of the search, the one with the least mass or ring once it has sizes.
    BestOf(usize),
}

/// A gearbox from speeds and power to sizes that hold. A step that finds nothing is the last.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Design {
    /// What no speed tells, key by key.
    pub basis: Vec<BasisKey>,
    /// The scheme.
    pub scheme: SchemeStep,
    /// The tooth numbers; `null` where no scheme meets the criteria.
    pub teeth: Option<TeethStep>,
    /// The sizes and their strength over the duty; `null` where there are no tooth numbers.
    pub sizes: Option<SizesStep>,
    /// The gearbox with its sizes as a file; `null` where a set has none.
    pub file: Option<String>,
    /// What the reader should know.
    pub warnings: Vec<Warning>,
}

impl Answer for Design {
    const NAME: &'static str = "design";
}

/// The order of the tooth search: the smallest ring at one load of the teeth, then the most exact ratio.
///
/// # Panics
/// Never: the objectives differ.
#[must_use]
pub fn order_of_teeth() -> Order {
    Order::new(&[Objective::Size, Objective::RatioError]).expect("two objectives that differ")
}

/// The design; `watch` is told how far the search for tooth numbers is, and may end it, and the sizing after it.
///
/// # Errors
/// - [`Error::NoLoad`] without load, [`Error::LoadWithoutSpeed`] without speed of the input.
/// - [`Error::Shares`] for shares that are not one of each gear; those of [`select::answer`], [`teeth::search`] and [`size::answer`],
///   which speak of the file `basis` or of the gearbox in the making.
pub fn answer(wanted: &Wanted, watch: &Watch) -> Result<Design, Error> {
    let duty = &wanted.selection.duty;
    let torque = duty.torque()?.ok_or(Error::NoLoad)?;
    let speed = duty.input_speed.ok_or(Error::LoadWithoutSpeed)?;
    let space = match wanted.mechanism {
        Some(mechanism) => Space::Mechanisms(vec![mechanism]),
        None => wanted.selection.space.clone(),
    };
    let (selected, best) = select::with_mechanism(&select::Wanted { space, ..wanted.selection.clone() })?;
    let mut design = Design {
        basis: wanted.basis.told(),
        scheme: SchemeStep::of(&selected, wanted.mechanism.is_some()),
        teeth: None,
        sizes: None,
        file: None,
        warnings: vec![],
    };
    let Some(mechanism) = best else { return Ok(design) };
    let of_teeth = teeth::Wanted {
        requirements: wanted.selection.requirements.clone(),
        order: order_of_teeth(),
        space: Space::Mechanisms(vec![mechanism]),
        bounds: wanted.bounds.clone(),
        shifts: wanted.ring_offsets.clone().map(|offsets| WantedShifts {
            offsets,
            aim: wanted.size.aim,
            tip_thickness: wanted.size.tip_thickness,
        }),
        limits: SizeLimits::default(),
        most: match wanted.teeth {
            Teeth::Number(number) => number + 1,
            Teeth::BestOf(tries) => tries,
        },
        duty: *duty,
    };
    let found = teeth::search(&of_teeth, watch)?;
    let numbers = match wanted.teeth {
        Teeth::Number(number) => number..=number,
        Teeth::BestOf(_) => 1..=found.shown(),
    };
    let mut tried: Vec<Tried> = vec![];
    for number in numbers {
        tried.extend(Tried::of(&found, number, wanted, torque, speed, &|| {
            watch(teeth::At { share: 1.0, searched: None })
        })?);
    }
    tried.sort_by(|one, other| one.objective().total_cmp(&other.objective()));
    design.teeth = Some(TeethStep::of(&found, &tried)?);
    let Some(best) = tried.into_iter().next() else { return Ok(design) };
    if best.is_whole() {
        let document = Document::parse_one(MAKING, best.file.as_bytes())?;
        design.file = Some(size::saved(&document, &best.size)?);
    }
    design.warnings.clone_from(&best.size.warnings);
    design.sizes = Some(SizesStep::of(best.size));
    Ok(design)
}

/// Digits of torque and speed in the file.
const DIGITS: usize = 12;

/// A design of the tooth search with its sizes.
#[derive(Debug)]
pub(crate) struct Tried {
    /// Its number.
    pub(crate) number: usize,
    /// The gearbox without sizes.
    file: String,
    /// Its sizes.
    size: Size,
}

impl Tried {
    /// The design of a number with its sizes; none where there is no such number.
    fn of(
        found: &Searches<'_>,
        number: usize,
        wanted: &Wanted,
        torque: Torque,
        speed: AngularVelocity,
        goes_on: &dyn Fn() -> ControlFlow<()>,
    ) -> Result<Option<Self>, Error> {
        let Some(saved) = found.saved(number)? else { return Ok(None) };
        let file = loaded(&saved, wanted, torque, speed)?;
        let document = Document::parse_one(MAKING, file.as_bytes())?;
        let size = size::answer(&one(&document, &Choice::default())?, &wanted.size, goes_on)?;
        Ok(Some(Self { number, file, size }))
    }

    /// Whether every set has a size.
    fn is_whole(&self) -> bool {
        self.size.not_sized.is_empty() && self.size.mass_kg.is_some()
    }

    /// Mass of its gears, if every set has a size.
    pub(crate) fn mass_kg(&self) -> Option<f64> {
        self.size.mass_kg.filter(|_| self.is_whole())
    }

    /// What is minimised; infinite where a set has no size.
    fn objective(&self) -> f64 {
        let rings = self.size.sets.iter().filter_map(|set| Some(set.found.first()?.ring_diameter_m));
        let objective = match self.size.minimise {
            Minimise::Mass => self.size.mass_kg,
            Minimise::Ring => rings.reduce(f64::max),
        };
        objective.filter(|_| self.is_whole()).unwrap_or(f64::INFINITY)
    }
}

/// What a fault calls the gearbox in the making.
const MAKING: &str = "the gearbox in the making";

/// The gearbox with what its strength asks for and its duty, as a file. The number of planets and the profile shifts are left to the sizes.
fn loaded(saved: &Saved, wanted: &Wanted, torque: Torque, speed: AngularVelocity) -> Result<String, Error> {
    let text = saved.file(&[]).map_err(|error| Error::Json(error.to_string()))?;
    let document = Document::parse_one(MAKING, text.as_bytes())?;
    let mut file = document.value().clone();
    let strength = &wanted.basis.strength;
    let sets = file.get_mut("sets").and_then(Value::as_sequence_mut).into_iter().flatten();
    for set in sets.filter_map(Value::as_mapping_mut) {
        for key in ["planets", "profile_shifts", "tip_alterations"] {
            set.remove(key);
        }
        set.insert("strength".into(), strength.clone());
    }
    let gears: Vec<&str> = saved.gearbox.gears().iter().map(Gear::name).collect();
    let shares = match &wanted.shares[..] {
        [] => vec![1.0 / gears.len() as f64; gears.len()],
        shares if shares.len() == gears.len() => shares.to_vec(),
        shares => {
            let gears = gears.iter().map(|&gear| gear.to_owned()).collect();
            return Err(Error::Shares { given: shares.len(), gears });
        }
    };
    // Beyond these digits is the rounding of their units.
    let written = |value: f64, unit: &str| Value::from(format!("{} {unit}", trimmed(value, DIGITS)));
    let greatest = wanted.overload.map(|factor| written(factor * torque.si(), "N·m"));
    let [torque, speed] = [written(torque.si(), "N·m"), written(crate::units::rpm(speed), "rpm")];
    let step = |(gear, share): (&str, f64)| {
        let mut step = Mapping::new();
        step.insert("gear".into(), gear.into());
        step.insert("share".into(), share.into());
        step.insert("torque".into(), torque.clone());
        step.insert("speed".into(), speed.clone());
        Value::Mapping(step)
    };
    let duty: Vec<Value> = gears.iter().copied().zip(shares).map(step).collect();
    let against = |torque: &Value| {
        let overload = |gear: &&str| {
            let keys = [("gear", Value::from(*gear)), ("torque", torque.clone())];
            Value::Mapping(keys.into_iter().map(|(key, value)| (Value::from(key), value)).collect())
        };
        gears.iter().map(overload).collect()
    };
    if let Some(file) = file.as_mapping_mut() {
        for (key, value) in &wanted.basis.keys {
            file.insert(key.as_str().into(), value.clone());
        }
        file.insert("duty".into(), Value::Sequence(duty));
        if let Some(torque) = &greatest {
            file.insert("overload".into(), Value::Sequence(against(torque)));
        }
        file.insert("gearbox".into(), saved.scheme.as_str().into());
    }
    to_string(&file).map_err(|error| Error::Json(error.to_string()))
}

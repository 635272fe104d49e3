//! Design of a gearbox from speeds and power: its scheme, tooth numbers and sizes with sufficient strength.
//!
//! - [`basis`]: assumed materials, factors, oil and life
//! - [`records`]: steps, each with its choice and the next best
//! - [`ways_out`]: limits to relax if no gearbox is found, each with the gearbox that is then found
//!
//! Each step keeps only the best result of the previous step, so that a person can follow it and choose
//! otherwise; combinations are not searched. If no tooth numbers of a scheme have sizes, the next scheme is
//! taken. Another scheme, or other tooth numbers, may give a lighter gearbox.

mod attempt;
pub mod basis;
pub mod records;
pub mod ways_out;

use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::select::answer as select;
use crate::select::answer::reached::ReachedSpeed;
use crate::select::answer::teeth::Watch;
use crate::size::answer as size;
use attempt::Attempt;
use basis::Basis;
use epicyclic_gears::synthesis::Bounds;
use epicyclic_selection::{Mechanism, Objective, Order, Space};
use records::{BasisKey, SchemeStep, SizesStep, TeethStep};
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::RangeInclusive;
use ways_out::WayOut;

/// What is wanted.
#[derive(Debug, Clone)]
pub struct Wanted {
    /// Ratios, criteria, order, mechanisms and load; speed and load of the input are needed.
    pub selection: select::Wanted,
    /// One mechanism in place of the best; it must meet the criteria all the same.
    pub mechanism: Option<Mechanism>,
    /// Bounds of tooth numbers and of planets.
    pub bounds: Bounds,
    /// Offsets of the rings of sets with profile shift, in place of sets that need none. The sizes pick the
    /// shifts anew at their centre distances, by the same aim and tip thickness.
    pub ring_offsets: Option<RangeInclusive<i32>>,
    /// How many of the tooth designs of each class of deviation get sizes, the smallest rings first.
    pub tries: usize,
    /// The tooth design with this number, from 1, in place of the lightest.
    pub tooth_design: Option<usize>,
    /// Shares of the time of the gears, the slowest first, then reverse gears; equal where there are none.
    pub shares: Vec<f64>,
    /// The greatest torque of the life over that of the load, in every gear.
    pub overload: Option<f64>,
    /// Materials, factors, oil, life.
    pub basis: Basis,
    /// The space of sizes.
    pub size: size::Wanted,
}

/// A gearbox from speeds and power to sizes that hold. A step that finds nothing is the last.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Design {
    /// Speeds of the gears, asked for and reached, the slowest first; empty where there are no tooth numbers.
    pub speeds: Vec<ReachedSpeed>,
    /// Assumed values, key by key.
    pub basis: Vec<BasisKey>,
    /// The scheme.
    pub scheme: SchemeStep,
    /// The tooth numbers; `null` where no scheme meets the criteria.
    pub teeth: Option<TeethStep>,
    /// The sizes and their strength over the duty; `null` where there are no tooth numbers.
    pub sizes: Option<SizesStep>,
    /// The gearbox with its sizes as a file; `null` where a set has none.
    pub file: Option<String>,
    /// Where there is no file: limits that would have to give, each with the gearbox found behind it; `null`
    /// where there is a file, or the tooth design was chosen by its number.
    pub ways_out: Option<Vec<WayOut>>,
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

/// The design; `watch` is told how far the searches for tooth numbers are, and may end them, and the sizing
/// after them. Where no gearbox is left, the search is repeated with each limit relaxed that stands in the
/// way.
///
/// # Errors
/// - [`Error::NoLoad`] without load, [`Error::LoadWithoutSpeed`] without speed of the input.
/// - [`Error::NoSuchDesign`] for a number of a tooth design that there is not.
/// - [`Error::Shares`] for shares that are not one of each gear; those of [`select::answer`],
///   [`select::teeth::search`] and [`size::answer`], which speak of the file `basis` or of the gearbox in the
///   making.
pub fn answer(wanted: &Wanted, watch: &Watch) -> Result<Design, Error> {
    let (mut design, relaxations) = attempted(wanted, watch)?;
    if design.file.is_none() && wanted.tooth_design.is_none() {
        design.ways_out = Some(ways_out::of(wanted, &design, &relaxations, watch)?);
    }
    Ok(design)
}

/// The design without ways out, and criteria that alone keep schemes out where none is accepted.
fn attempted(wanted: &Wanted, watch: &Watch) -> Result<(Design, Vec<select::Relaxation>), Error> {
    let space = match wanted.mechanism {
        Some(mechanism) => Space::Mechanisms(vec![mechanism]),
        None => wanted.selection.space.clone(),
    };
    let all = select::Wanted { space, most: usize::MAX, ..wanted.selection.clone() };
    all.duty.torque()?.ok_or(Error::NoLoad)?;
    let (selected, mechanisms) = select::with_mechanisms(&all)?;
    let mut attempts: Vec<(Mechanism, Attempt)> = vec![];
    for mechanism in mechanisms {
        attempts.push((mechanism, Attempt::of(wanted, mechanism, watch)?));
        let is_last = attempts.last().is_some_and(|(_, attempt)| attempt.file.is_some());
        // A number is one of the best scheme's list.
        if is_last || wanted.tooth_design.is_some() {
            break;
        }
    }
    // Where none has sizes the best scheme tells what it lacks.
    let taken = attempts.iter().position(|(_, attempt)| attempt.file.is_some()).unwrap_or(0);
    let passed_over: Vec<Mechanism> = attempts.drain(..taken).map(|(mechanism, _)| mechanism).collect();
    let taken = attempts.into_iter().next();
    let mut design = Design {
        speeds: vec![],
        basis: wanted.basis.told(),
        scheme: SchemeStep::of(
            &selected,
            taken.as_ref().map(|(mechanism, _)| *mechanism),
            &passed_over,
            wanted.mechanism.is_some(),
        ),
        teeth: None,
        sizes: None,
        file: None,
        ways_out: None,
        warnings: vec![],
    };
    if let Some((_, Attempt { teeth, sizes, file, speeds, warnings })) = taken {
        let reversed: Vec<&str> =
            speeds.iter().filter(|speed| speed.reversed).map(|speed| speed.gear.name()).collect();
        design.warnings = warnings;
        if !reversed.is_empty() {
            let message = format!(
                "the output turns against the direction asked for in gear {}",
                reversed.join(" and ")
            );
            design.warnings.insert(0, Warning { name: "output-reversed", message });
        }
        (design.teeth, design.sizes, design.file, design.speeds) = (Some(teeth), sizes, file, speeds);
    }
    Ok((design, selected.relaxations))
}

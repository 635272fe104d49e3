//! Design of a gearbox from speeds and power: its scheme, tooth numbers and sizes with sufficient strength.
//!
//! - [`backlash`]: allowances of the teeth for the play of the output.
//! - [`limits`]: limits of the whole gearbox.
//! - [`masses`]: the whole and its parts.
//! - [`records`]: steps, each with its choice and the next best.
//! - [`stages`]: stages in series for one ratio, or one with planets of two gears; [`trains`]: what was compared.
//! - [`transmission`], [`transmission_records`]: a list of gears.
//! - [`ways_out`], [`stages_ways_out`]: limits to relax if no gearbox is found, each with the gearbox that is
//!   then found.
//!
//! Scheme, tooth numbers and sizes are chosen together by [`lightest`](epicyclic_strength::lightest), among
//! all schemes that meet the criteria and all their tooth numbers.

pub(crate) mod arranged;
mod arranged_file;
mod assumed;
mod attempt;
pub(crate) mod axes;
pub mod backlash;
mod front;
mod larger;
pub mod limits;
mod loaded;
mod making;
pub mod masses;
pub mod records;
pub mod stage_kind;
pub mod stages;
mod stages_file;
mod stages_search;
pub mod stages_wanted;
pub mod stages_ways_out;
pub mod trains;
pub mod transmission;
pub mod transmission_records;
pub mod ways_out;

use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::select::answer as select;
use crate::select::answer::reached::ReachedSpeed;
use crate::select::answer::teeth::Watch;
use crate::shared::basis::{Basis, BasisKey};
use crate::size::options::Request as SizeRequest;
use assumed::{AssumedLoad, assumed};
use attempt::Attempt;
use epicyclic_gears::synthesis::Bounds;
use epicyclic_selection::{Mechanism, Space};
use larger::Compared;
use limits::OrderLimits;
use masses::Masses;
use records::{SchemeStep, SizesStep, TeethStep};
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::RangeInclusive;
use ways_out::WayOut;

/// Requirements of a design.
#[derive(Debug, Clone)]
pub struct Wanted {
    /// Ratios, criteria, order, mechanisms and load; speed and load of the input are required.
    pub selection: select::Wanted,
    /// Mechanism to use instead of the best; it must also meet the criteria.
    pub mechanism: Option<Mechanism>,
    /// Bounds of tooth numbers and numbers of planets.
    pub bounds: Bounds,
    /// Ring offsets of sets with profile shift; `None` for sets without profile shift. The sizing chooses the
    /// shifts again at its centre distances, with the same aim and tip thickness.
    pub ring_offsets: Option<RangeInclusive<i32>>,
    /// Number of the design to use, from 1; `None` for the best.
    pub tooth_design: Option<usize>,
    /// Parts of the time in the gears, the slowest first, then reverse gears; empty for equal parts.
    pub shares: Vec<f64>,
    /// Greatest torque during the life over the nominal torque, in every gear.
    pub overload: Option<f64>,
    /// Steps of the duty in each gear: share of its time, torque and speed over these.
    pub spectrum: Vec<[f64; 3]>,
    /// Limits of the whole gearbox.
    pub limits: OrderLimits,
    /// Whether gearboxes with smaller rings are asked for.
    pub is_front_asked: bool,
    /// Materials, factors, oil and life.
    pub basis: Basis,
    /// Search space of sizes.
    pub size: SizeRequest,
}

/// Design of a gearbox from speeds and power, with sufficient strength.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Design {
    /// Speeds in the gears, required and reached, the slowest first; empty without tooth numbers.
    pub speeds: Vec<ReachedSpeed>,
    /// Assumed values by key.
    pub basis: Vec<BasisKey>,
    /// Assumptions that are no keys of the file.
    pub assumed: Vec<BasisKey>,
    /// Limits of the whole gearbox, and what exceeds them.
    pub limits: OrderLimits,
    /// Masses of the whole and of its parts; null without a file.
    pub masses: Option<Masses>,
    /// Choice of the scheme.
    pub scheme: SchemeStep,
    /// Choice of the tooth numbers; null if no scheme meets the criteria.
    pub teeth: Option<TeethStep>,
    /// Choice of the sizes, with their strength over the duty; null without tooth numbers.
    pub sizes: Option<SizesStep>,
    /// Gearbox file with sizes; null if a set has none.
    pub file: Option<String>,
    /// Limits to relax if no gearbox is found, each with the gearbox that is then found. Null if there is a
    /// file, or if the tooth design was given by its number.
    pub ways_out: Option<Vec<WayOut>>,
    /// Gearboxes with smaller and smaller rings, each the best that its limit of the rings leaves; null if not asked
    /// for, or without a gearbox.
    pub front: Option<Vec<WayOut>>,
    /// Warnings about the design.
    pub warnings: Vec<Warning>,
}

impl Answer for Design {
    const NAME: &'static str = "design";
}

/// Designs a gearbox. The closures of `watch` are called now and then, and may end the search. If no gearbox
/// is found, the search is repeated with each obstructing limit relaxed.
///
/// # Errors
/// - [`Error::NoLoad`] without load, [`Error::LoadWithoutSpeed`] without speed of the input.
/// - [`Error::NoSuchDesign`] for a number of a tooth design that does not exist.
/// - [`Error::Shares`] unless there is one share per gear; errors of [`select::answer`] and
///   [`size::Request::answer`](SizeRequest::answer), which refer to the file `basis` or to the unfinished
///   gearbox.
pub fn answer(wanted: &Wanted, watch: &Watch) -> Result<Design, Error> {
    let Attempted { mut design, relaxations, size } = attempted(wanted, watch)?;
    if design.file.is_none() && wanted.tooth_design.is_none() {
        design.ways_out = Some(ways_out::of(wanted, &design, &relaxations, watch)?);
    }
    if design.file.is_some() && wanted.is_front_asked {
        let wanted = Wanted { size, ..wanted.clone() };
        design.front = Some(ways_out::smaller_rings(&wanted, &design, watch)?);
    }
    Ok(design)
}

/// Design without ways out and front.
struct Attempted {
    design: Design,
    /// Criteria that alone reject schemes, if no scheme is accepted.
    relaxations: Vec<select::Relaxation>,
    /// Space of the sizes that it is taken from.
    size: SizeRequest,
}

/// Designs a gearbox without ways out and front, with larger sizes than usual where they pay.
fn attempted(wanted: &Wanted, watch: &Watch) -> Result<Attempted, Error> {
    // A number counts the designs that the best is one of.
    let with = |size: SizeRequest, tooth_design| {
        let own = Wanted { tooth_design, size: size.clone(), ..wanted.clone() };
        let (design, relaxations) = attempted_with(&own, watch)?;
        Ok::<_, Error>(Attempted { design, relaxations, size })
    };
    let compared = |of: &Design| {
        let taken = of.teeth.as_ref().and_then(|teeth| teeth.taken.as_ref());
        Compared::new(taken.and_then(|taken| taken.rules_missed), of.masses, &of.warnings)
    };
    let mut best = with(wanted.size.clone(), None)?;
    let usual = compared(&best.design);
    let is_open = best.design.teeth.is_some() && usual.is_open();
    if let Some(size) = wanted.size.larger().filter(|_| is_open) {
        let mut larger = with(size, None)?;
        if usual.gives_way_to(compared(&larger.design)) {
            let is_found = larger.design.file.is_some();
            larger.design.limits = larger.design.limits.with(best.design.limits, is_found);
            best = larger;
        }
    }
    match wanted.tooth_design {
        None => Ok(best),
        number => with(best.size, number),
    }
}

/// Designs a gearbox with the sizes of the order; if no scheme is accepted, also returns the criteria that alone
/// reject schemes.
fn attempted_with(wanted: &Wanted, watch: &Watch) -> Result<(Design, Vec<select::Relaxation>), Error> {
    let space = match wanted.mechanism {
        Some(mechanism) => Space::Mechanisms(vec![mechanism]),
        None => wanted.selection.space.clone(),
    };
    let all = select::Wanted { space, most: usize::MAX, ..wanted.selection.clone() };
    all.duty.torque()?.ok_or(Error::NoLoad)?;
    let (selected, mechanisms) = select::with_mechanisms(&all)?;
    let attempt = if mechanisms.is_empty() { None } else { Some(Attempt::of(wanted, &mechanisms, watch)?) };
    let others = attempt.as_ref().map(|attempt| attempt.others.clone()).unwrap_or_default();
    let taken = attempt.as_ref().and_then(|attempt| attempt.mechanism);
    let load = AssumedLoad {
        spectrum: &wanted.spectrum,
        gears: selected.required.ratios.len() + 1,
        shares: &wanted.shares,
        overload: wanted.overload,
    };
    let mut design = Design {
        speeds: vec![],
        basis: wanted.basis.told(),
        assumed: assumed(&wanted.basis, &wanted.size, &load)?,
        limits: wanted.limits,
        masses: None,
        scheme: SchemeStep::of(&selected, taken, others, wanted.mechanism.is_some()),
        teeth: None,
        sizes: None,
        file: None,
        ways_out: None,
        front: None,
        warnings: vec![],
    };
    if let Some(Attempt { teeth, sizes, file, speeds, warnings, .. }) = attempt {
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
        if let Some((file, sizes)) = file.as_ref().zip(sizes.as_ref()) {
            design.masses = Masses::of(file, sizes, (wanted.size.application, wanted.overload))?;
        }
        (design.teeth, design.sizes, design.file, design.speeds) = (Some(teeth), sizes, file, speeds);
        if let Some(sizes) = design.sizes.as_ref().filter(|_| design.file.is_some())
            && !design.limits.allow(design.masses.as_ref(), sizes)
        {
            (design.file, design.masses) = (None, None);
        }
        design.warnings.extend(design.limits.warning());
    }
    Ok((design, selected.relaxations))
}

//! Shifts between gears: the elements released and applied, and the speeds of the input and the shift
//! elements.
//!
//! During a shift the output keeps its speed, because the machine is much heavier than the motor. A shift
//! from ratio `i_a` to `i_b` takes the input from `ω` to `ω·i_b/i_a`. Each shift element goes from its slip
//! in the first gear to its slip in the second. All speeds are relative to the input speed before the shift.
//! Shifts are listed towards the smaller ratio; the reverse shift releases what is applied here, and applies
//! what is released.

use super::progression::{Ordered, ordered};
use super::warnings;
use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::gearbox::Gearbox;
use crate::shared::judgement::answer::Judgement;
use epicyclic_train::{self as train, Analysis};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::AngularVelocity;

/// Maximum number of gears for a list of shifts, because the number of pairs grows with its square.
pub const MOST_GEARS: usize = 64;

/// Shifts between the gears of a gearbox.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Shifts {
    /// Name of the gearbox.
    pub gearbox: String,
    /// Input speed before each shift in rad/s; null if not given.
    pub input_speed_rad_s: Option<f64>,
    /// Shifts between gears of different ratios with the same input, output and direction of the output. The
    /// list includes shifts that skip gears.
    pub shifts: Vec<Shift>,
    /// Judgement of the gearbox by rules of practice; empty in a report.
    pub judgement: Judgement,
    /// Warnings about the gearbox.
    pub warnings: Vec<Warning>,
}

impl Answer for Shifts {
    const NAME: &'static str = "analyze-shifts";
}

/// Number of shift elements that change over at once.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Transition {
    /// At most one element is released and one applied.
    Single,
    /// Two elements are released or two applied.
    Double,
    /// More than two elements are released or applied.
    Multiple,
}

/// Shift between two gears.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Shift {
    /// Name of the gear before the shift.
    pub from: String,
    /// Name of the gear after the shift.
    pub to: String,
    /// Number of ratios that the shift skips: 0 between neighbours.
    pub skipped_ratios: usize,
    /// Shift elements that are released, without one-way clutches.
    pub released: Vec<String>,
    /// Shift elements that are applied, without one-way clutches.
    pub applied: Vec<String>,
    /// One-way clutches on which only the first gear relies: they release without actuation.
    pub one_way_released: Vec<String>,
    /// One-way clutches on which only the second gear relies: they engage without actuation.
    pub one_way_applied: Vec<String>,
    /// Number of elements that change over at once, one-way clutches included.
    pub transition: Transition,
    /// Input speed after the shift over input speed before, at constant output speed.
    pub input_speed_after_of_before: f64,
    /// Input speed before the shift in rad/s; null if not given.
    pub input_speed_before_rad_s: Option<f64>,
    /// Input speed after the shift in rad/s; null if not given.
    pub input_speed_after_rad_s: Option<f64>,
    /// Shift elements with their slips before and after the shift.
    pub shift_elements: Vec<ElementInShift>,
}

/// Shift element in a shift.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ElementInShift {
    /// Name of the shift element.
    pub shift_element: String,
    /// Slip before the shift, relative to the input speed before the shift; null if unknown.
    pub slip_before_of_input: Option<f64>,
    /// Slip after the shift, relative to the input speed before the shift; null if unknown.
    pub slip_after_of_input: Option<f64>,
    /// Slip after minus slip before the shift, relative to the input speed before the shift; null if unknown.
    pub slip_change_of_input: Option<f64>,
    /// Slip before the shift in rad/s; null if unknown or no input speed is given.
    pub slip_before_rad_s: Option<f64>,
    /// Slip after the shift in rad/s; null if unknown or no input speed is given.
    pub slip_after_rad_s: Option<f64>,
}

/// Lists all shifts, at the given input speed before each of them.
///
/// # Errors
/// [`Error::ManyGears`] for a gearbox of more than [`MOST_GEARS`] gears; [`Error::Gearbox`] for a gear that
/// cannot be analysed.
pub fn answer(subject: &Gearbox, speed: Option<AngularVelocity>) -> Result<Shifts, Error> {
    let gearbox = &subject.train;
    let count = gearbox.gears().len();
    if count > MOST_GEARS {
        return Err(Error::ManyGears { gears: count, most: MOST_GEARS });
    }
    let gears =
        gearbox.gears().iter().map(|gear| gearbox.analyze_gear(gear)).collect::<Result<Vec<_>, _>>()?;
    let gears: Vec<&Analysis<'_>> = gears.iter().collect();
    Ok(Shifts {
        gearbox: gearbox.name().to_owned(),
        input_speed_rad_s: speed.map(Physical::si),
        shifts: between(gearbox, &gears, &ordered(&gears), speed, usize::MAX),
        judgement: Judgement::default(),
        warnings: warnings::of_gearbox(subject),
    })
}

/// Shifts that skip at most this number of ratios.
pub(super) fn between(
    gearbox: &train::Gearbox,
    gears: &[&Analysis<'_>],
    ordered: &[Ordered],
    speed: Option<AngularVelocity>,
    most_skipped: usize,
) -> Vec<Shift> {
    let mut all = vec![];
    for Ordered { ranks, .. } in ordered {
        for skipped in 0..(ranks.len() - 1).min(most_skipped.saturating_add(1)) {
            for (from, to) in ranks.iter().zip(&ranks[skipped + 1..]) {
                for (from, to) in from.iter().flat_map(|from| to.iter().map(move |to| (*from, *to))) {
                    all.extend(Shift::of(gearbox, [gears[from], gears[to]], skipped, speed));
                }
            }
        }
    }
    all
}

impl Shift {
    /// Shift between two gears; `None` if one of them has no ratio.
    fn of(
        gearbox: &train::Gearbox,
        [from, to]: [&Analysis<'_>; 2],
        skipped_ratios: usize,
        speed: Option<AngularVelocity>,
    ) -> Option<Self> {
        let after = to.ratio()? / from.ratio()?;
        let left = |one: &Analysis<'_>, other: &Analysis<'_>, one_way: bool| -> Vec<String> {
            let gone = one.gear().engaged().iter().filter(|place| !other.gear().engaged().contains(place));
            let elements = gone.map(|place| &gearbox.shift_elements()[*place]);
            elements
                .filter(|element| element.is_one_way() == one_way)
                .map(|element| element.id().to_owned())
                .collect()
        };
        let (released, applied) = (left(from, to, false), left(to, from, false));
        let (one_way_released, one_way_applied) = (left(from, to, true), left(to, from, true));
        let transition =
            match (released.len() + one_way_released.len()).max(applied.len() + one_way_applied.len()) {
                0 | 1 => Transition::Single,
                2 => Transition::Double,
                _ => Transition::Multiple,
            };
        let at = |of_input: Option<f64>| speed.zip(of_input).map(|(speed, of)| (speed * of).si());
        let element = |place: usize| {
            let before = from.slips()[place];
            let after_shift = to.slips()[place].map(|slip| slip * after);
            ElementInShift {
                shift_element: gearbox.shift_elements()[place].id().to_owned(),
                slip_before_of_input: before,
                slip_after_of_input: after_shift,
                slip_change_of_input: before.zip(after_shift).map(|(before, after)| after - before),
                slip_before_rad_s: at(before),
                slip_after_rad_s: at(after_shift),
            }
        };
        Some(Self {
            from: from.gear().name().to_owned(),
            to: to.gear().name().to_owned(),
            skipped_ratios,
            released,
            applied,
            one_way_released,
            one_way_applied,
            transition,
            input_speed_after_of_before: after,
            input_speed_before_rad_s: at(Some(1.0)),
            input_speed_after_rad_s: at(Some(after)),
            shift_elements: (0..gearbox.shift_elements().len()).map(element).collect(),
        })
    }
}

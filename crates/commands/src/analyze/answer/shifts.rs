//! Shifts from gear to gear: what is released and applied, and what the input and the shift elements do.
//!
//! While a gearbox shifts, its output keeps its speed: the machine is heavier than the motor. A shift from
//! ratio `i_a` to `i_b` then takes the input from `ω` to `ω·i_b/i_a`, and each shift element from its slip in
//! the first gear to that in the second. All are told over the input's speed before the shift. Shifts are
//! told towards the smaller ratio; the way back releases what is applied here, and applies what is released.

use super::progression::{Ordered, ordered};
use super::warnings;
use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::gearbox::Subject;
use epicyclic_train::{Analysis, Gearbox};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::AngularVelocity;

/// Shifts are told of so many gears at most: the pairs grow with the square of their number.
pub const MOST_GEARS: usize = 64;

/// All shifts of a gearbox.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Shifts {
    /// Name of the gearbox.
    pub gearbox: String,
    /// The input's speed before each shift, if it was given.
    pub input_speed_rad_s: Option<f64>,
    /// The shifts between gears of different ratios that have input and output in common and turn the output
    /// in the same direction: those between neighbours, and those that pass gears over.
    pub shifts: Vec<Shift>,
    /// What the reader should know.
    pub warnings: Vec<Warning>,
}

impl Answer for Shifts {
    const NAME: &'static str = "analyze-shifts";
}

/// How many shift elements change over at once.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Transition {
    /// At most one is released and one applied.
    Single,
    /// Two are released or applied.
    Double,
    /// More than two are.
    Multiple,
}

/// A shift between two gears.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Shift {
    /// The gear before.
    pub from: String,
    /// The gear after.
    pub to: String,
    /// How many ratios it passes over: 0 between neighbours.
    pub skipped_ratios: usize,
    /// Shift elements that are released, one-way clutches apart.
    pub released: Vec<String>,
    /// Shift elements that are applied, one-way clutches apart.
    pub applied: Vec<String>,
    /// One-way clutches that the first gear relies on and the second does not: they let go by themselves.
    pub one_way_released: Vec<String>,
    /// One-way clutches that the second gear relies on and the first does not: they take over by themselves.
    pub one_way_applied: Vec<String>,
    /// How many change over at once, one-way clutches among them.
    pub transition: Transition,
    /// Speed of the input after the shift over that before, at the same speed of the output.
    pub input_speed_after_of_before: f64,
    /// Speed of the input before.
    pub input_speed_before_rad_s: Option<f64>,
    /// Speed of the input after.
    pub input_speed_after_rad_s: Option<f64>,
    /// The shift elements.
    pub shift_elements: Vec<ElementInShift>,
}

/// A shift element in a shift; slips are over the input's speed before.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ElementInShift {
    /// Its name.
    pub shift_element: String,
    /// Slip before.
    pub slip_before_of_input: Option<f64>,
    /// Slip after.
    pub slip_after_of_input: Option<f64>,
    /// Slip after less slip before.
    pub slip_change_of_input: Option<f64>,
    /// Slip before.
    pub slip_before_rad_s: Option<f64>,
    /// Slip after.
    pub slip_after_rad_s: Option<f64>,
}

/// All shifts, with the input's speed before each of them.
///
/// # Errors
/// [`Error::ManyGears`] for a gearbox of more than [`MOST_GEARS`] gears; [`Error::Gearbox`] for a gear that
/// cannot be analysed.
pub fn answer(subject: &Subject<'_>, speed: Option<AngularVelocity>) -> Result<Shifts, Error> {
    let gearbox = &subject.gearbox;
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
        warnings: warnings::of_gearbox(subject),
    })
}

/// The shifts that pass over at most so many ratios.
pub(super) fn between(
    gearbox: &Gearbox,
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
    /// `None` where a gear has no ratio.
    fn of(
        gearbox: &Gearbox,
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

//! Comparison of gearboxes: the figures of each, and their differences from the first.
//!
//! | module | is |
//! |---|---|
//! | [`page`] | what a page of it draws |
//! | [`rows`] | which gears of the gearboxes stand beside each other |
//!
//! Speeds are given relative to the input speed, torques relative to the input torque, powers relative to the
//! entering power. Efficiencies are those when driven from the input. All figures come from the
//! [overviews](crate::analyze::answer::overview) of the gearboxes.

pub mod page;
pub mod rows;

use crate::analyze::answer::elements::{OverGears, ShiftElement};
use crate::analyze::answer::overview::{self, Overview};
use crate::analyze::answer::records::ShiftElementKind;
use crate::analyze::answer::shifts::Transition;
use crate::analyze::answer::{Input, OperatingPoint};
use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::gearbox::Gearbox;
use crate::shared::judgement::answer::Judgement;
use crate::shared::number::plain;
use crate::tolerance::ROUNDED;
use epicyclic_train::{self as train, PlanetSet};
pub use rows::GearsBy;
use schemars::JsonSchema;
use serde::Serialize;

/// Comparison of gearboxes.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Comparison {
    /// Gearboxes compared; differences are taken from the first.
    pub gearboxes: Vec<Compared>,
    /// Property by which gears of the gearboxes are paired.
    pub gears_by: GearsBy,
    /// Speed and load of the input that were asked for, equal for all gearboxes.
    pub operating_point: OperatingPoint,
    /// Figures of the gearboxes as a whole.
    pub figures: Vec<ComparedFigure>,
    /// Figures of the gears.
    pub gears: Vec<ComparedGear>,
    /// Warnings about the comparison.
    pub warnings: Vec<Warning>,
}

/// Gearbox in a comparison.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Compared {
    /// Name of the gearbox.
    pub gearbox: String,
    /// Origin of the gearbox: a file, standard input, or the name of a scheme or structure.
    pub from: String,
    /// Shift elements of the gearbox.
    pub shift_elements: Vec<ComparedElement>,
    /// Judgement of the gearbox by rules of practice.
    pub judgement: Judgement,
}

/// Shift element with its largest torque and slip over all gears.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ComparedElement {
    /// Name, kind and links of the shift element.
    #[serde(flatten)]
    pub element: ShiftElement,
    /// Largest torque with losses over all gears, relative to the input torque; null if none exists.
    pub torque_of_input: Option<f64>,
    /// Gear in which the largest torque occurs; null if none exists.
    pub torque_gear: Option<String>,
    /// Largest slip over all gears, relative to the input speed; null if none exists.
    pub slip_of_input: Option<f64>,
    /// Gear in which the largest slip occurs; null if none exists.
    pub slip_gear: Option<String>,
    /// Largest torque at the operating point, in N·m; null without a load.
    pub torque_n_m: Option<f64>,
    /// Largest slip at the operating point, in rad/s; null if no input speed is given.
    pub slip_rad_s: Option<f64>,
}

impl ComparedElement {
    fn of(one: OverGears) -> Self {
        let (torque, slip) = (one.largest_torque, one.largest_slip);
        Self {
            element: one.element,
            torque_n_m: torque.as_ref().and_then(|torque| torque.torque_n_m),
            slip_rad_s: slip.as_ref().and_then(|slip| slip.slip_rad_s),
            torque_of_input: torque.as_ref().map(|torque| torque.torque_of_input),
            torque_gear: torque.map(|torque| torque.gear),
            slip_of_input: slip.as_ref().map(|slip| slip.slip_of_input),
            slip_gear: slip.map(|slip| slip.gear),
        }
    }
}

/// Corresponding gears of the gearboxes, with their figures.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ComparedGear {
    /// Name of the gear in each gearbox; null for a gearbox without a corresponding gear.
    pub gears: Vec<Option<String>>,
    /// Figures of the gears.
    pub figures: Vec<GearFigure>,
}

/// Figure of corresponding gears.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearFigure {
    /// Name of the figure.
    pub figure: FigureName,
    /// Value for the gear of each gearbox; null if none exists.
    pub values: Vec<Option<f64>>,
    /// Differences between the values.
    #[serde(flatten)]
    pub differs: Differs,
}

/// Difference of values from that of the first gearbox.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Differs {
    /// Largest difference from the first gearbox's value; null if all are equal or the first has none.
    pub difference: Option<f64>,
    /// Largest difference divided by the first gearbox's value; null if all are equal or the first has none.
    pub relative_difference: Option<f64>,
}

impl Differs {
    fn of(values: &[Option<f64>]) -> Self {
        let first = values.first().copied().flatten();
        let difference = first.and_then(|first| {
            let differences = values.iter().flatten().map(|other| other - first);
            let largest = differences.reduce(|most, one| if one.abs() > most.abs() { one } else { most })?;
            Some(largest).filter(|largest| largest.abs() > ROUNDED * first.abs().max(1.0))
        });
        let relative = difference.zip(first.filter(|first| *first != 0.0));
        Self { difference, relative_difference: relative.map(|(difference, first)| difference / first) }
    }
}

/// Figure of each gearbox as a whole.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ComparedFigure {
    /// Name of the figure.
    pub figure: FigureName,
    /// Value for each gearbox; null if none exists.
    pub values: Vec<Option<Value>>,
    /// Differences between the values.
    #[serde(flatten)]
    pub differs: Differs,
}

/// Value with the place where it occurs.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Value {
    /// The value.
    pub value: f64,
    /// Gear in which a largest or smallest value occurs; for a step, the gear to which it leads. Otherwise
    /// null.
    pub gear: Option<String>,
    /// Shift element or set in which a largest value occurs; otherwise null.
    pub part: Option<String>,
}

/// Figures of gearboxes and of gears.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FigureName {
    /// Planet sets.
    Sets,
    /// Central gears, planet shafts and carriers of all sets.
    Members,
    /// Links that can turn.
    Links,
    /// Brakes, one-way clutches apart.
    Brakes,
    /// Clutches, one-way clutches apart.
    Clutches,
    /// One-way clutches, to the housing or between links.
    OneWayClutches,
    /// Gears.
    Gears,
    /// Spread of the progression with the most ratios.
    Spread,
    /// Largest ratio step between neighbours.
    LargestStep,
    /// Smallest ratio step between neighbours.
    SmallestStep,
    /// Shifts between neighbours at which at most one shift element is released and one applied.
    SingleTransitions,
    /// Shifts between neighbours at which two shift elements are released or two applied.
    DoubleTransitions,
    /// Shifts between neighbours at which more than two shift elements are released or applied.
    MultipleTransitions,
    /// Lowest efficiency of a gear.
    LowestEfficiency,
    /// Largest circulating power of a gear relative to the entering power; none for gears that turn as a
    /// block.
    LargestCirculatingPower,
    /// Largest speed of a link relative to the input speed.
    LargestLinkSpeed,
    /// Largest planet speed relative to the carrier, relative to the input speed.
    LargestPlanetSpeed,
    /// Largest torque of a brake relative to the input torque.
    LargestBrakeTorque,
    /// Largest torque of a clutch relative to the input torque.
    LargestClutchTorque,
    /// Largest slip of a brake relative to the input speed.
    LargestBrakeSlip,
    /// Largest slip of a clutch relative to the input speed.
    LargestClutchSlip,
    /// Ratio of a gear, input speed over output speed.
    Ratio,
    /// Ratio step to a gear from its neighbour of larger ratio.
    Step,
    /// Efficiency of a gear when driven from the input.
    Efficiency,
    /// Circulating power in a gear relative to the entering power.
    CirculatingPower,
    /// Largest speed of a link in a gear, relative to the input speed.
    LinkSpeed,
    /// Largest planet speed in a gear relative to the carrier, relative to the input speed.
    PlanetSpeed,
    /// Output speed in a gear at the operating point, in rad/s.
    OutputSpeedRadS,
    /// Torque on the output in a gear at the operating point, in N·m.
    OutputTorqueNM,
    /// Power lost in a gear at the operating point, in W.
    LossW,
}

impl Answer for Comparison {
    const NAME: &'static str = "compare";
}

/// Gearbox to be compared, with its origin.
#[derive(Debug)]
pub struct Candidate<'s> {
    /// The gearbox.
    pub subject: &'s Gearbox,
    /// Origin: a file, standard input, or the name of a scheme or structure.
    pub from: String,
}

/// Compares gearboxes, at one speed and load of the input if these are given.
///
/// # Errors
/// [`Error::ManyGears`] for a gearbox of more than [`rows::MOST_GEARS`] gears; those of [`overview::answer`].
pub(crate) fn answer(candidates: &[Candidate<'_>], input: Input) -> Result<Comparison, Error> {
    let overviews = candidates
        .iter()
        .map(|candidate| overview::answer(candidate.subject, input, None))
        .collect::<Result<Vec<Overview>, Error>>()?;
    let (gears_by, rows) = rows::of(&overviews)?;
    let boxes: Vec<(&train::Gearbox, &Overview)> =
        candidates.iter().map(|candidate| &candidate.subject.train).zip(&overviews).collect();
    let figures = WHOLE
        .iter()
        .map(|(figure, of)| {
            ComparedFigure::of(*figure, boxes.iter().map(|(gearbox, overview)| of(gearbox, overview)))
        })
        .collect();
    let gears = rows.iter().map(|row| ComparedGear::of(row, &overviews)).collect();
    let judged: Vec<Judgement> =
        candidates.iter().map(|candidate| Judgement::of(candidate.subject, None, None, None)).collect();
    let mut warnings = warnings(&overviews);
    for (judgement, overview) in judged.iter().zip(&overviews) {
        let of = |one: Warning| Warning { message: format!("{}: {}", overview.gearbox, one.message), ..one };
        warnings.extend(judgement.warnings(&[]).map(of));
    }
    Ok(Comparison {
        gears_by,
        operating_point: OperatingPoint::of(input),
        figures,
        gears,
        warnings,
        gearboxes: candidates
            .iter()
            .zip(overviews)
            .zip(judged)
            .map(|((candidate, overview), judgement)| Compared {
                gearbox: overview.gearbox,
                from: candidate.from.clone(),
                shift_elements: overview.shift_elements.into_iter().map(ComparedElement::of).collect(),
                judgement,
            })
            .collect(),
    })
}

/// Warning if only some of the gearboxes have losses.
fn warnings(overviews: &[Overview]) -> Vec<Warning> {
    let without: Vec<&str> =
        overviews.iter().filter(|one| !one.has_losses).map(|one| one.gearbox.as_str()).collect();
    if without.is_empty() || without.len() == overviews.len() {
        return vec![];
    }
    let message = format!(
        "efficiencies and torques do not compare: no losses are stated of {}; --efficiency 0.97 gives each set without \
         losses some",
        without.join(", ")
    );
    vec![Warning { name: "losses", message }]
}

type OfWhole = fn(&train::Gearbox, &Overview) -> Option<Value>;

/// The figures of a gearbox as a whole, in their order.
const WHOLE: &[(FigureName, OfWhole)] = &[
    (FigureName::Sets, |gearbox, _| count(gearbox.sets().len())),
    (FigureName::Members, |gearbox, _| {
        count(gearbox.sets().iter().map(|set| PlanetSet::members(set).len()).sum())
    }),
    (FigureName::Links, |gearbox, _| count(gearbox.links().len() - 1)),
    (FigureName::Brakes, |_, overview| count(elements(overview, &[ShiftElementKind::Brake]).count())),
    (FigureName::Clutches, |_, overview| count(elements(overview, &[ShiftElementKind::Clutch]).count())),
    (FigureName::OneWayClutches, |_, overview| {
        count(elements(overview, &[ShiftElementKind::OneWayBrake, ShiftElementKind::OneWayClutch]).count())
    }),
    (FigureName::Gears, |_, overview| count(overview.gears.len())),
    (FigureName::Spread, |_, overview| {
        // If several progressions have the most ratios, the first one is used.
        let mut longest = None::<&crate::analyze::answer::progression::Progression>;
        for one in &overview.progressions {
            if longest.is_none_or(|most| one.ratios > most.ratios) {
                longest = Some(one);
            }
        }
        Some(Value { value: longest?.spread, gear: None, part: None })
    }),
    (FigureName::LargestStep, |_, overview| extreme(steps(overview), f64::gt)),
    (FigureName::SmallestStep, |_, overview| extreme(steps(overview), f64::lt)),
    (FigureName::SingleTransitions, |_, overview| transitions(overview, Transition::Single)),
    (FigureName::DoubleTransitions, |_, overview| transitions(overview, Transition::Double)),
    (FigureName::MultipleTransitions, |_, overview| transitions(overview, Transition::Multiple)),
    (FigureName::LowestEfficiency, |_, overview| {
        extreme(gears(overview, |gear| gear.facts.efficiency), f64::lt)
    }),
    (FigureName::LargestCirculatingPower, |_, overview| extreme(gears(overview, circulating), f64::gt)),
    (FigureName::LargestLinkSpeed, |_, overview| {
        extreme(gears(overview, |gear| gear.largest_speed_of_input), f64::gt)
    }),
    (FigureName::LargestPlanetSpeed, |_, overview| {
        let of_planets = overview.planets.iter().filter_map(|planet| {
            let speed = planet.largest_speed.as_ref()?;
            let value = speed.relative_speed_of_input.abs();
            Some(Value { value, gear: Some(speed.gear.clone()), part: Some(planet.set.clone()) })
        });
        extreme(of_planets, f64::gt)
    }),
    (FigureName::LargestBrakeTorque, |_, overview| torque(overview, ShiftElementKind::Brake)),
    (FigureName::LargestClutchTorque, |_, overview| torque(overview, ShiftElementKind::Clutch)),
    (FigureName::LargestBrakeSlip, |_, overview| slip(overview, ShiftElementKind::Brake)),
    (FigureName::LargestClutchSlip, |_, overview| slip(overview, ShiftElementKind::Clutch)),
];

fn count(count: usize) -> Option<Value> {
    Some(Value { value: count as f64, gear: None, part: None })
}

fn elements<'o>(overview: &'o Overview, kinds: &[ShiftElementKind]) -> impl Iterator<Item = &'o OverGears> {
    let kinds = kinds.to_vec();
    overview.shift_elements.iter().filter(move |one| kinds.contains(&one.element.kind))
}

/// Finds the greatest or least value, the first of equal ones.
fn extreme(values: impl IntoIterator<Item = Value>, is_more: fn(&f64, &f64) -> bool) -> Option<Value> {
    values.into_iter().reduce(|most, one| if is_more(&one.value, &most.value) { one } else { most })
}

fn gears(overview: &Overview, of: fn(&overview::Gear) -> Option<f64>) -> impl Iterator<Item = Value> {
    overview.gears.iter().filter_map(move |gear| {
        Some(Value { value: of(gear)?, gear: Some(gear.facts.gear.clone()), part: None })
    })
}

/// Circulating power; `None` for a gearbox that turns as a block, where no mesh transmits power.
fn circulating(gear: &overview::Gear) -> Option<f64> {
    let rolls = gear.largest_planet_speed_of_input.is_none_or(|speed| speed > ROUNDED);
    gear.circulating_of_entering.filter(|_| rolls)
}

/// Steps between neighbouring gears, in whatever order the file lists them.
fn steps(overview: &Overview) -> impl Iterator<Item = Value> {
    overview.shifts.iter().map(|shift| Value {
        value: shift.input_speed_after_of_before.recip(),
        gear: Some(shift.to.clone()),
        part: None,
    })
}

fn transitions(overview: &Overview, transition: Transition) -> Option<Value> {
    count(overview.shifts.iter().filter(|shift| shift.transition == transition).count())
}

fn torque(overview: &Overview, kind: ShiftElementKind) -> Option<Value> {
    let of = |one: &OverGears| {
        let torque = one.largest_torque.as_ref()?;
        let value = torque.torque_of_input.abs();
        Some(Value { value, gear: Some(torque.gear.clone()), part: Some(one.element.shift_element.clone()) })
    };
    extreme(elements(overview, &[kind]).filter_map(of), f64::gt)
}

fn slip(overview: &Overview, kind: ShiftElementKind) -> Option<Value> {
    let of = |one: &OverGears| {
        let slip = one.largest_slip.as_ref()?;
        let value = slip.slip_of_input.abs();
        Some(Value { value, gear: Some(slip.gear.clone()), part: Some(one.element.shift_element.clone()) })
    };
    extreme(elements(overview, &[kind]).filter_map(of), f64::gt)
}

type OfGear = fn(&Overview, &overview::Gear) -> Option<f64>;

/// Step to a gear from its neighbour of larger ratio, in whatever order the file lists them.
fn step_to(overview: &Overview, gear: &overview::Gear) -> Option<f64> {
    let shift = overview.shifts.iter().find(|shift| shift.to == gear.facts.gear)?;
    Some(shift.input_speed_after_of_before.recip())
}

/// Figures of a gear in their order.
const OF_GEAR: &[(FigureName, OfGear)] = &[
    (FigureName::Ratio, |_, gear| gear.facts.ratio),
    (FigureName::Step, step_to),
    (FigureName::Efficiency, |_, gear| gear.facts.efficiency),
    (FigureName::CirculatingPower, |_, gear| gear.circulating_of_entering),
    (FigureName::LinkSpeed, |_, gear| gear.largest_speed_of_input),
    (FigureName::PlanetSpeed, |_, gear| gear.largest_planet_speed_of_input),
    (FigureName::OutputSpeedRadS, |_, gear| gear.output_speed_rad_s),
    (FigureName::OutputTorqueNM, |_, gear| gear.output_torque_n_m),
    (FigureName::LossW, loss),
];

/// Power loss: the sum of the powers that enter at input and output.
fn loss(overview: &Overview, gear: &overview::Gear) -> Option<f64> {
    let at = &overview.operating_point;
    let speed = at.speed_rad_s?;
    let input = at.power_w.or(at.torque_n_m.map(|torque| torque * speed))?;
    Some(plain(input + gear.output_torque_n_m? * gear.output_speed_rad_s?))
}

impl ComparedGear {
    fn of(row: &[Option<usize>], overviews: &[Overview]) -> Self {
        let gears = || {
            let all = row.iter().zip(overviews);
            all.map(|(place, overview)| place.map(|place| (overview, &overview.gears[place])))
        };
        let figure = |(figure, of): &(FigureName, OfGear)| {
            let values: Vec<Option<f64>> = gears()
                .map(|gear| {
                    let (overview, gear) = gear?;
                    of(overview, gear)
                })
                .collect();
            GearFigure { figure: *figure, differs: Differs::of(&values), values }
        };
        Self {
            gears: gears().map(|gear| gear.map(|(_, gear)| gear.facts.gear.clone())).collect(),
            figures: OF_GEAR.iter().map(figure).collect(),
        }
    }
}

impl ComparedFigure {
    fn of(figure: FigureName, values: impl Iterator<Item = Option<Value>>) -> Self {
        // A value of zero occurs nowhere in particular, so it gets no place.
        let placed = |of: Value| {
            if of.value.abs() > ROUNDED { of } else { Value { gear: None, part: None, ..of } }
        };
        let values: Vec<Option<Value>> = values.map(|of| of.map(placed)).collect();
        let alone: Vec<Option<f64>> = values.iter().map(|of| of.as_ref().map(|of| of.value)).collect();
        Self { figure, values, differs: Differs::of(&alone) }
    }
}

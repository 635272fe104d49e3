//! All gears of a gearbox side by side.

use super::elements::{self, InGear};
use super::planet_bearings::{self, PlanetBearing};
use super::progression::{self, Deviation, Progression};
use super::records::{GearFacts, OneWayClutch, one_way_clutches};
use super::sets::SetFacts;
use super::shifts::{self, MOST_GEARS, Shift};
use super::{Input, OperatingPoint, Worked, pins, planets, warnings};
use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::gearbox::Subject;
use crate::shared::tooth_checks::answer::ToothChecks;
use epicyclic_train::{Analysis, Gearbox};
use epicyclic_units::Physical as _;
use schemars::JsonSchema;
use serde::Serialize;

/// A gearbox gear by gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Overview {
    /// Its name.
    pub gearbox: String,
    /// Where its data stand in print.
    pub source: Option<String>,
    /// Whether any of its sets loses power.
    pub has_losses: bool,
    /// Its planet sets: teeth, ratios, and whether their planets fit.
    pub sets: Vec<SetFacts>,
    /// Speed and load of the input that were asked for.
    pub operating_point: OperatingPoint,
    /// Its gears. Their `engaged` is the engagement table.
    pub gears: Vec<Gear>,
    /// Its gears by input, output and direction of rotation: spread, and ideal progressions.
    pub progressions: Vec<Progression>,
    /// Its shift elements, the columns of the engagement table, with their largest torque and slip.
    pub shift_elements: Vec<elements::OverGears>,
    /// The shifts between neighbouring gears, towards the smaller ratio.
    pub shifts: Vec<Shift>,
    /// What the one-way clutches do in each gear.
    pub one_way_clutches: Vec<OneWayClutch>,
    /// The planets with their largest speeds and forces.
    pub planets: Vec<planets::OverGears>,
    /// The planet bearings in each gear, where the size of any set is known.
    pub planet_bearings: Vec<PlanetBearing>,
    /// The checks of the teeth of its sets.
    pub tooth_checks: ToothChecks,
    /// What the reader should know.
    pub warnings: Vec<Warning>,
}

/// A gear, beside the others.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Gear {
    /// What it engages, its state, ratio and efficiencies.
    #[serde(flatten)]
    pub facts: GearFacts,
    /// Ratio step: the next larger ratio of the progression over this one; none of the largest. The order of
    /// the file does not matter.
    pub step: Option<f64>,
    /// The ratio over that of the geometric progression between the first and the last gear of its
    /// progression, less 1; `null` where there are no other gears between these.
    pub geometric_deviation: Option<f64>,
    /// The ratio over that of the progressive progression between the same, less 1.
    pub progressive_deviation: Option<f64>,
    /// Circulating power over what enters.
    pub circulating_of_entering: Option<f64>,
    /// Largest speed of a link over the input's.
    pub largest_speed_of_input: Option<f64>,
    /// Largest speed of a planet relative to its carrier, over the input's speed.
    pub largest_planet_speed_of_input: Option<f64>,
    /// Slip and torque of the shift elements.
    pub shift_elements: Vec<InGear>,
    /// Speed of the output at the operating point.
    pub output_speed_rad_s: Option<f64>,
    /// Torque on the output at the operating point.
    pub output_torque_n_m: Option<f64>,
}

impl Answer for Overview {
    const NAME: &'static str = "analyze";
}

/// All gears with the input as asked; `progression_factor` is that of the progressive progression, by default
/// the one that fits best.
///
/// # Errors
/// [`Error::Load`] for a load that a gear cannot take, [`Error::ProgressionFactor`] for a factor that leaves
/// no progression, [`Error::Gearbox`] for speeds and loads that are no numbers.
pub fn answer(
    subject: &Subject<'_>,
    input: Input,
    progression_factor: Option<f64>,
) -> Result<Overview, Error> {
    let gearbox = &subject.gearbox;
    let worked = gearbox
        .gears()
        .iter()
        .map(|gear| Worked::new(gearbox, gear.name(), input))
        .collect::<Result<Vec<Worked<'_>>, Error>>()?;
    let analyses: Vec<&Analysis<'_>> = worked.iter().map(|worked| &worked.analysis).collect();
    let ordered = progression::ordered(&analyses);
    let (progressions, deviations) = progression::of(&analyses, &ordered, progression_factor)?;
    let mut all = warnings::of_gearbox(subject);
    all.extend(warnings::drags(subject));
    all.extend(warnings::tilted(subject));
    all.extend(pins::warning(subject, &worked.iter().collect::<Vec<_>>()));
    all.extend(warnings::not_driven(subject, &analyses));
    all.extend(warnings::contradictions(gearbox, &analyses));
    all.extend(warnings::released(gearbox, &worked.iter().collect::<Vec<_>>()));
    all.extend(warnings::self_locking(&analyses));
    let shifts = if worked.len() > MOST_GEARS {
        let message = format!("shifts are told of at most {MOST_GEARS} gears; these are {}", worked.len());
        all.push(Warning { name: "shifts", message });
        vec![]
    } else {
        shifts::between(gearbox, &analyses, &ordered, input.speed, 0)
    };
    let steps = progression::steps(&analyses, &ordered);
    let gears: Vec<Gear> = (0..worked.len())
        .map(|place| Gear::of(subject, &worked[place], steps[place], deviations[place]))
        .collect();
    let duties: Vec<(&str, &[InGear])> =
        gears.iter().map(|gear| (gear.facts.gear.as_str(), &gear.shift_elements[..])).collect();
    let bearings = planet_bearings::of_gears(subject, &worked)?;
    Ok(Overview {
        gearbox: gearbox.name().to_owned(),
        source: subject.source.clone(),
        has_losses: subject.has_losses(),
        sets: SetFacts::all(subject),
        operating_point: OperatingPoint::of(input),
        progressions,
        shift_elements: elements::OverGears::all(gearbox, &duties),
        shifts,
        one_way_clutches: analyses.iter().flat_map(|gear| one_way_clutches(gearbox, gear)).collect(),
        planets: planets::OverGears::all(gearbox, &worked, &bearings),
        planet_bearings: bearings,
        tooth_checks: ToothChecks::of(subject.tooth_checks(), |_| true),
        warnings: all,
        gears,
    })
}

impl Gear {
    fn of(subject: &Subject<'_>, worked: &Worked<'_>, step: Option<f64>, deviation: Deviation) -> Self {
        let analysis = &worked.analysis;
        let output_speed = analysis.speed(analysis.gear().output());
        Self {
            facts: GearFacts::of(subject, analysis),
            step,
            geometric_deviation: deviation.geometric,
            progressive_deviation: deviation.progressive,
            circulating_of_entering: analysis.driving().map(|case| case.power.circulating),
            largest_speed_of_input: largest_speed(&subject.gearbox, analysis),
            largest_planet_speed_of_input: largest_planet_speed(analysis),
            shift_elements: InGear::all(&subject.gearbox, worked),
            output_speed_rad_s: worked.speed_rad_s(output_speed),
            output_torque_n_m: worked.operation.as_ref().map(|operation| operation.output.si()),
        }
    }
}

fn largest_speed(gearbox: &Gearbox, analysis: &Analysis<'_>) -> Option<f64> {
    (1..gearbox.links().len()).filter_map(|link| analysis.speeds()[link]).map(f64::abs).reduce(f64::max)
}

fn largest_planet_speed(analysis: &Analysis<'_>) -> Option<f64> {
    let planets = analysis.sets().iter().flat_map(|set| set.planets.iter().flatten());
    planets.map(|planet| planet.relative.abs()).reduce(f64::max)
}

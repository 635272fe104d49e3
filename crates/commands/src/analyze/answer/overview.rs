//! Overview of all gears of a gearbox.

use super::elements::{self, InGear};
use super::planet_bearings::{self, PlanetBearing};
use super::progression::{self, Deviation, Progression};
use super::records::{GearFacts, OneWayClutch, one_way_clutches};
use super::sets::SetFacts;
use super::shifts::{self, MOST_GEARS, Shift};
use super::{Input, OperatingPoint, Worked, pins, planets, warnings};
use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::gearbox::Gearbox;
use crate::shared::judgement::answer::Judgement;
use crate::shared::tooth_checks::answer::ToothChecks;
use crate::strength::answer::reversed_bending;
use epicyclic_train::{self as train, Analysis};
use epicyclic_units::Physical as _;
use schemars::JsonSchema;
use serde::Serialize;

/// Overview of a gearbox, gear by gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Overview {
    /// Name of the gearbox.
    pub gearbox: String,
    /// Publication with the data of the gearbox; null if none is named.
    pub source: Option<String>,
    /// Whether any set of the gearbox loses power.
    pub has_losses: bool,
    /// Planetary sets with tooth numbers and ratios, and whether their planets fit.
    pub sets: Vec<SetFacts>,
    /// Speed and load of the input that were asked for.
    pub operating_point: OperatingPoint,
    /// Gears of the gearbox. The `engaged` lists form the engagement table.
    pub gears: Vec<Gear>,
    /// Spread and ideal progressions of the gears, grouped by input, output and direction of rotation.
    pub progressions: Vec<Progression>,
    /// Shift elements (columns of the engagement table), each with its largest torque and slip.
    pub shift_elements: Vec<elements::OverGears>,
    /// Shifts between neighbouring gears, towards the smaller ratio.
    pub shifts: Vec<Shift>,
    /// Behaviour of the one-way clutches in each gear.
    pub one_way_clutches: Vec<OneWayClutch>,
    /// Planets with their largest speeds and forces.
    pub planets: Vec<planets::OverGears>,
    /// Forces on the planet bearings in each gear; empty unless the size of a set is known.
    pub planet_bearings: Vec<PlanetBearing>,
    /// Tooth checks of the sets.
    pub tooth_checks: ToothChecks,
    /// Judgement of the gearbox by rules of practice; empty in a comparison.
    pub judgement: Judgement,
    /// Warnings about the gearbox and its gears.
    pub warnings: Vec<Warning>,
}

/// Gear in an overview.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Gear {
    /// Engaged elements, state, ratio and efficiencies of the gear.
    #[serde(flatten)]
    pub facts: GearFacts,
    /// Ratio step: the next larger ratio of the progression over this one, whatever the order in the file.
    /// Null for the largest ratio.
    pub step: Option<f64>,
    /// Relative deviation of the ratio from the geometric progression between the first and last gear of its
    /// progression. Null if there are no gears between them.
    pub geometric_deviation: Option<f64>,
    /// Relative deviation of the ratio from the progressive progression between the first and last gear of
    /// its progression; null if none exists.
    pub progressive_deviation: Option<f64>,
    /// Circulating power relative to the entering power; null if it cannot be computed.
    pub circulating_of_entering: Option<f64>,
    /// Largest speed of a link relative to the input speed; null if unknown.
    pub largest_speed_of_input: Option<f64>,
    /// Largest planet speed relative to its carrier, relative to the input speed; null if unknown.
    pub largest_planet_speed_of_input: Option<f64>,
    /// Slip and torque of the shift elements in this gear.
    pub shift_elements: Vec<InGear>,
    /// Output speed at the operating point, in rad/s; null if unknown or no input speed is given.
    pub output_speed_rad_s: Option<f64>,
    /// Torque on the output at the operating point, in N·m; null without a load or if it cannot be computed.
    pub output_torque_n_m: Option<f64>,
}

impl Answer for Overview {
    const NAME: &'static str = "analyze";
}

/// Analyzes all gears at the given speed and load of the input. `progression_factor` is φ_2 of the
/// progressive progression; by default the best fit.
///
/// # Errors
/// [`Error::Load`] for a load that a gear cannot carry; [`Error::ProgressionFactor`] for a factor without a
/// progression; [`Error::Gearbox`] for speeds and loads that are not finite.
pub fn answer(subject: &Gearbox, input: Input, progression_factor: Option<f64>) -> Result<Overview, Error> {
    let gearbox = &subject.train;
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
    all.extend(warnings::tilted(subject, input.load.is_some()));
    all.extend(warnings::stepped(subject, input.load.is_some()));
    all.extend(pins::warning(subject, &worked.iter().collect::<Vec<_>>(), &[]));
    all.extend(warnings::not_driven(subject, &analyses));
    all.extend(warnings::contradictions(gearbox, &analyses));
    all.extend(warnings::released(gearbox, &worked.iter().collect::<Vec<_>>()));
    all.extend(warnings::self_locking(&analyses));
    // Faults of the data for the strength are refused by the commands that calculate it.
    all.extend(reversed_bending(subject).unwrap_or_default());
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
        judgement: Judgement::default(),
        warnings: all,
        gears,
    })
}

impl Gear {
    fn of(subject: &Gearbox, worked: &Worked<'_>, step: Option<f64>, deviation: Deviation) -> Self {
        let analysis = &worked.analysis;
        let output_speed = analysis.speed(analysis.gear().output());
        Self {
            facts: GearFacts::of(subject, analysis),
            step,
            geometric_deviation: deviation.geometric,
            progressive_deviation: deviation.progressive,
            circulating_of_entering: analysis.driving().map(|case| case.power.circulating),
            largest_speed_of_input: largest_speed(&subject.train, analysis),
            largest_planet_speed_of_input: largest_planet_speed(analysis),
            shift_elements: InGear::all(&subject.train, worked),
            output_speed_rad_s: worked.speed_rad_s(output_speed),
            output_torque_n_m: worked.operation.as_ref().map(|operation| operation.output.si()),
        }
    }
}

fn largest_speed(gearbox: &train::Gearbox, analysis: &Analysis<'_>) -> Option<f64> {
    (1..gearbox.links().len()).filter_map(|link| analysis.speeds()[link]).map(f64::abs).reduce(f64::max)
}

fn largest_planet_speed(analysis: &Analysis<'_>) -> Option<f64> {
    let planets = analysis.sets().iter().flat_map(|set| set.planets.iter().flatten());
    planets.map(|planet| planet.relative.abs()).reduce(f64::max)
}

//! All gears of a gearbox side by side.

use super::planet_bearings::{self, PlanetBearing};
use super::records::{GearFacts, OneWayClutch, ShiftElementKind, links_of, one_way_clutches};
use super::{Input, OperatingPoint, Worked, warnings};
use crate::gearbox::Subject;
use crate::{Answer, Error, Warning};
use epicyclic_formats::Physical as _;
use epicyclic_train::{self as train, Analysis, Gearbox};
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
    /// Speed and load of the input that were asked for.
    pub operating_point: OperatingPoint,
    /// Its gears. Their `engaged` is the engagement table.
    pub gears: Vec<Gear>,
    /// Its shift elements, the columns of the engagement table.
    pub shift_elements: Vec<ShiftElement>,
    /// What the one-way clutches do in each gear.
    pub one_way_clutches: Vec<OneWayClutch>,
    /// The planet bearings in each gear, where the size of any set is known.
    pub planet_bearings: Vec<PlanetBearing>,
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
    /// Ratio step: the ratio of the gear before over this one's, between the same links in the same direction.
    pub step: Option<f64>,
    /// Circulating power over what enters.
    pub circulating_of_entering: Option<f64>,
    /// Largest speed of a link over the input's.
    pub largest_speed_of_input: Option<f64>,
    /// Largest speed of a planet relative to its carrier, over the input's speed.
    pub largest_planet_speed_of_input: Option<f64>,
    /// Speed of the output at the operating point.
    pub output_speed_rad_s: Option<f64>,
    /// Torque on the output at the operating point.
    pub output_torque_n_m: Option<f64>,
}

/// A shift element.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ShiftElement {
    /// Its name.
    pub shift_element: String,
    /// What it is.
    pub kind: ShiftElementKind,
    /// The two links that it joins; `ground` is the housing.
    pub links: [String; 2],
}

impl ShiftElement {
    /// Those of a gearbox.
    pub(crate) fn all(gearbox: &Gearbox) -> Vec<Self> {
        let one = |element: &train::ShiftElement| Self {
            shift_element: element.id().to_owned(),
            kind: ShiftElementKind::of(element),
            links: links_of(gearbox, element),
        };
        gearbox.shift_elements().iter().map(one).collect()
    }
}

impl Answer for Overview {
    const NAME: &'static str = "analyze";
}

/// All gears with the input as asked.
///
/// # Errors
/// [`Error::Load`] for a load that a gear cannot take, [`Error::Gearbox`] for speeds and loads that are no numbers.
pub fn answer(subject: &Subject<'_>, input: Input) -> Result<Overview, Error> {
    let gearbox = &subject.gearbox;
    let worked = gearbox
        .gears()
        .iter()
        .map(|gear| Worked::new(gearbox, gear.name(), input))
        .collect::<Result<Vec<Worked<'_>>, Error>>()?;
    let gears = || worked.iter().map(|worked| &worked.analysis);
    let analyses: Vec<&Analysis<'_>> = gears().collect();
    let mut all = warnings::of_gearbox(subject);
    all.extend(warnings::fast_planets_of(gearbox, &analyses));
    all.extend(warnings::contradictions(gearbox, &analyses));
    all.extend(warnings::released(gearbox, &worked.iter().collect::<Vec<_>>()));
    all.extend(warnings::self_locking(&analyses));
    Ok(Overview {
        gearbox: gearbox.name().to_owned(),
        source: subject.source.clone(),
        has_losses: subject.has_losses(),
        operating_point: OperatingPoint::of(input),
        gears: (0..worked.len()).map(|place| Gear::of(subject, &worked, place)).collect(),
        shift_elements: ShiftElement::all(gearbox),
        one_way_clutches: gears().flat_map(|gear| one_way_clutches(gearbox, gear)).collect(),
        planet_bearings: planet_bearings::of_gears(subject, &worked)?,
        warnings: all,
    })
}

impl Gear {
    fn of(subject: &Subject<'_>, all: &[Worked<'_>], place: usize) -> Self {
        let worked = &all[place];
        let analysis = &worked.analysis;
        let before = place.checked_sub(1).map(|before| &all[before].analysis);
        let output_speed = analysis.speed(analysis.gear().output());
        Self {
            facts: GearFacts::of(subject, analysis),
            step: before.and_then(|before| step(before, analysis)),
            circulating_of_entering: analysis.driving().map(|case| case.power.circulating),
            largest_speed_of_input: largest_speed(&subject.gearbox, analysis),
            largest_planet_speed_of_input: largest_planet_speed(analysis),
            output_speed_rad_s: worked.speed_rad_s(output_speed),
            output_torque_n_m: worked.operation.as_ref().map(|operation| operation.output.si()),
        }
    }
}

/// Ratio of the gear before over this one's, between the same links and in the same direction.
fn step(before: &Analysis<'_>, this: &Analysis<'_>) -> Option<f64> {
    let (one, other) = (before.ratio()?, this.ratio()?);
    let between = |analysis: &Analysis<'_>| [analysis.gear().input(), analysis.gear().output()];
    (one * other > 0.0 && between(before) == between(this)).then(|| one / other)
}

fn largest_speed(gearbox: &Gearbox, analysis: &Analysis<'_>) -> Option<f64> {
    (1..gearbox.links().len()).filter_map(|link| analysis.speeds()[link]).map(f64::abs).reduce(f64::max)
}

fn largest_planet_speed(analysis: &Analysis<'_>) -> Option<f64> {
    let planets = analysis.sets().iter().flat_map(|set| set.planets.iter().flatten());
    planets.map(|planet| planet.relative.abs()).reduce(f64::max)
}

//! Chapters of a gearbox: all gears, each gear in full, and the effect of another `k`.

use super::sizes::{self, SetSizes};
use crate::analyze::answer::gear::OneGear;
use crate::analyze::answer::overview::Overview;
use crate::analyze::answer::shifts::{self, Shifts};
use crate::analyze::answer::{analysis, gear, moving, overview};
use crate::error::Error;
use crate::losses::answer::{self as losses, LossChapter};
use crate::shared::drawability::answer::Conflict;
use crate::shared::exciting::Exciting;
use crate::shared::gearbox::Gearbox;
use crate::shared::judgement::answer::Judgement;
use crate::shared::load::Load;
use crate::shared::number::plain;
use crate::sheet::answer::{self as sheet, DataSheets};
use crate::strength::answer::on_shafts::AskedDuty;
use crate::strength::answer::{self as strength, Strength};
use crate::vibrate::answer::{self as vibration, Vibration};
use epicyclic_layout::{self as layout, Layout, Verdict};
use epicyclic_train::set::{Gearing, SetKind, SetSpec};
use epicyclic_train::{self as train, Analysis, PlanetSet};
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::ControlFlow;

/// Maximum and minimum number of places in a range of `k`.
const PLACES: [u32; 2] = [60, 12];
/// Limit of gear analyses for all ranges of `k` together. Beyond it, places are fewer, so that a page takes
/// only seconds.
const ANALYSES: usize = 6000;
/// Usual range of `k` for a set with one sun, one ring and one kind of planet.
const USUAL_K: [f64; 2] = [1.5, 4.5];
/// Extension of the range beyond a set's own `k` at the end of the usual range: a factor on `k − 1` below, on
/// `k` above.
const BEYOND_K: [f64; 2] = [0.6, 1.3];
/// Range of `k` for other sets, relative to their own.
const OVER_OWN_K: [f64; 2] = [0.6, 1.6];

/// Gearbox with the analysis of all gears, each gear in full, and the effect of another `k`.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearboxReport {
    /// Names of the planetary sets.
    pub sets: Vec<String>,
    /// Duty of the file on input and output; null without one.
    pub duty: Option<AskedDuty>,
    /// Overview of all gears.
    pub overview: Overview,
    /// Full analysis of each gear, in the order of the gears.
    pub gears: Vec<OneGear>,
    /// Shifts between gears; null if the gearbox has too many gears for a list of shifts.
    pub shifts: Option<Shifts>,
    /// Sizes of the sets, with their bearings and least safeties; empty if the file states no module.
    pub sizes: Vec<SetSizes>,
    /// Strength of the teeth at the operating point with load and speed, then over the duty of the file.
    /// Empty if the file lacks oil, life or the `strength` of a set.
    pub strength: Vec<Strength>,
    /// Losses by their sources at the operating point; null without speed and load, or if nothing loses
    /// power.
    pub losses: Option<LossChapter>,
    /// Data sheets of the gears; null if the file has enough data for no set.
    pub sheets: Option<DataSheets>,
    /// Natural frequencies, modes and their excitation; null if the file has no `vibration` of any set.
    pub vibration: Option<Vibration>,
    /// Reason why the scheme cannot be drawn; null for a drawable gearbox.
    pub conflict: Option<Conflict>,
    /// Effect of the `k` of one set with the others unchanged. Sets with more than two central gears, which
    /// have no single `k`, and pairs on fixed axes are left out.
    pub over_k: Vec<OverK>,
}

/// Gears of a gearbox over the `k` of one set.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct OverK {
    /// Name of the set.
    pub set: String,
    /// Value of `k` in the gearbox: the absolute value of the basic ratio.
    pub own_k: f64,
    /// Whether the set loses power.
    pub has_losses: bool,
    /// Values of `k` in increasing order, with that of the gearbox among them.
    pub k: Vec<f64>,
    /// Results for each gear at each `k`.
    pub gears: Vec<GearOverK>,
}

/// Gear over the `k` of one set; null where a value cannot be computed.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearOverK {
    /// Name of the gear.
    pub gear: String,
    /// Ratio at each `k`, input speed over output speed.
    pub ratios: Vec<Option<f64>>,
    /// Efficiency at each `k` when driven from the input; null also if the mesh losses hold the gear.
    pub efficiencies: Vec<Option<f64>>,
    /// Speed of the set's fastest planet relative to its carrier at each `k`, relative to the input speed.
    pub planet_speeds_of_input: Vec<Option<f64>>,
}

/// Results that a page draws.
#[derive(Debug)]
pub struct Shown<'g> {
    /// The gearbox.
    pub gearbox: &'g train::Gearbox,
    /// Analyses of the gears.
    pub gears: Vec<Analysis<'g>>,
    /// Layout of the gearbox; `None` if it is not drawable.
    pub layout: Option<Box<Layout>>,
}

/// Computes the chapters of a gearbox, and the results for their pictures. The closure `goes_on` is called
/// now and then, and may end the calculation.
///
/// # Errors
/// Errors of the chapters, with the place of invalid data in the file.
pub(crate) fn answer<'g>(
    subject: &'g Gearbox,
    load: Load,
    exciting: &Exciting,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<(GearboxReport, Shown<'g>), Error> {
    let (gearbox, input) = (&subject.train, load.input());
    let names = || gearbox.gears().iter().map(epicyclic_train::Gear::name);
    let (layout, conflict) = match layout::draw(gearbox, layout::Options::default()) {
        Verdict::Drawable(layout) => (Some(layout), None),
        Verdict::SelfCrossing(witness) => (None, Some(Conflict::of(gearbox, &witness))),
    };
    let strength = judged(subject, strength::chapters(subject, load)?);
    let report = GearboxReport {
        sets: gearbox.sets().iter().map(|set| set.id().to_owned()).collect(),
        duty: AskedDuty::of(subject)?,
        overview: Overview {
            judgement: Judgement::of(subject, None, None, None),
            ..overview::answer(subject, input, None)?
        },
        gears: names().map(|gear| gear::answer(subject, gear, input)).collect::<Result<_, Error>>()?,
        shifts: match shifts::answer(subject, input.speed) {
            // A page without the shifts is better than no page.
            Err(Error::ManyGears { .. }) => None,
            shifts => Some(shifts?),
        },
        sizes: sizes::answer(subject, &strength)?,
        strength,
        losses: losses::chapter(subject, input)?,
        sheets: sheet::chapter(subject)?,
        vibration: vibration::chapter(subject, exciting, goes_on)?,
        conflict,
        over_k: over_k(gearbox),
    };
    let gears = names().map(|gear| analysis(gearbox, gear)).collect::<Result<_, Error>>()?;
    Ok((report, Shown { gearbox, gears, layout }))
}

/// Strength with the judgement at each load.
fn judged(subject: &Gearbox, chapters: Vec<Strength>) -> Vec<Strength> {
    let judged =
        |one: Strength| Strength { judgement: Judgement::of(subject, None, Some(&one), None), ..one };
    chapters.into_iter().map(judged).collect()
}

fn over_k(gearbox: &train::Gearbox) -> Vec<OverK> {
    let of_set = |(place, set): (usize, &PlanetSet)| {
        // Only a set with two central gears has a `k`; a pair on fixed axes has no carrier that turns.
        let kind = set.kind().filter(|_| !set.is_pair())?;
        let own_k = set.basic_ratio().get().abs();
        let k = with_own(values(gearbox, range(kind, own_k)), own_k);
        let others: Vec<Option<train::Gearbox>> = k.iter().map(|k| with_k(gearbox, place, *k)).collect();
        let gears = gearbox.gears().iter().map(|gear| GearOverK::of(&others, gear.name(), place)).collect();
        Some(OverK { set: set.id().to_owned(), own_k, has_losses: set.has_losses(), k, gears })
    };
    gearbox.sets().iter().enumerate().filter_map(of_set).collect()
}

impl GearOverK {
    fn of(gearboxes: &[Option<train::Gearbox>], gear: &str, set: usize) -> Self {
        let mut over = Self {
            gear: gear.to_owned(),
            ratios: vec![],
            efficiencies: vec![],
            planet_speeds_of_input: vec![],
        };
        for gearbox in gearboxes {
            let analysis = gearbox.as_ref().and_then(|gearbox| gearbox.analyze(gear).ok());
            let analysis = analysis.as_ref();
            over.ratios.push(analysis.and_then(Analysis::ratio).map(plain));
            over.efficiencies.push(moving(analysis.and_then(Analysis::efficiency)));
            let fastest = analysis.and_then(|analysis| {
                let planets = analysis.sets().get(set)?.planets.iter().flatten();
                planets.map(|planet| planet.relative.abs()).reduce(f64::max)
            });
            over.planet_speeds_of_input.push(fastest);
        }
        over
    }
}

/// Range of `k` for the curves: the usual range for a set with sun and ring, and some values on either side
/// of its own.
fn range(kind: SetKind, k: f64) -> [f64; 2] {
    match kind {
        SetKind::Simple => {
            [(1.0 + BEYOND_K[0] * (k - 1.0)).min(USUAL_K[0]), (BEYOND_K[1] * k).max(USUAL_K[1])]
        }
        _ => OVER_OWN_K.map(|part| part * k),
    }
}

fn values(gearbox: &train::Gearbox, [low, high]: [f64; 2]) -> Vec<f64> {
    let [most, fewest] = PLACES;
    let each = ANALYSES / (gearbox.sets().len() * gearbox.gears().len()).max(1);
    let places = u32::try_from(each).unwrap_or(most).clamp(fewest, most);
    (0..=places).map(|i| low + (high - low) * f64::from(i) / f64::from(places)).collect()
}

/// Inserts the set's own `k`, so that each curve contains the gearbox itself.
fn with_own(mut values: Vec<f64>, own: f64) -> Vec<f64> {
    let place = values.partition_point(|value| *value < own);
    if values.get(place) != Some(&own) {
        values.insert(place, own);
    }
    values
}

/// Gearbox with another `k` of one set; `None` if that gives no valid set.
fn with_k(gearbox: &train::Gearbox, set: usize, k: f64) -> Option<train::Gearbox> {
    let id = gearbox.sets()[set].id();
    let change = |spec: SetSpec| {
        if spec.id == id {
            // Tooth numbers of the planets belong to the original `k`, so they are dropped.
            SetSpec { gearing: Gearing::BasicRatio(k), planet: None, second_planet: None, ..spec }
        } else {
            spec
        }
    };
    gearbox.to_builder().map_sets(change).build().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_places_reach_beyond_the_sets_own_k_and_hold_it() {
        for own in [1.2, 1.5, 2.15, 4.5, 5.0, 12.0] {
            let [low, high] = range(SetKind::Simple, own);
            assert!(1.0 < low && low < own && own < high, "{own}: {low} to {high}");
            let places = with_own(vec![low, own - 0.01, high], own);
            assert!(places.contains(&own) && places.is_sorted() && places.len() == 4);
            assert_eq!(with_own(places.clone(), own), places);
        }
        let [low, high] = range(SetKind::DoublePlanet, 2.0);
        assert!(low < 2.0 && 2.0 < high);
    }
}

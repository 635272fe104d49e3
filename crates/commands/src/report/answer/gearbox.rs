//! The chapters of a gearbox: all gears, each gear in full, and what another `k` would change.

use crate::analyze::answer::gear::OneGear;
use crate::analyze::answer::overview::Overview;
use crate::analyze::answer::shifts::{self, Shifts};
use crate::analyze::answer::{Input, analysis, gear, moving, overview};
use crate::error::Error;
use crate::losses::answer::{self as losses, LossChapter};
use crate::shared::drawability::answer::Conflict;
use crate::shared::gearbox::Subject;
use crate::shared::number::plain;
use crate::sheet::answer::{self as sheet, DataSheets};
use crate::strength::answer::{self as strength, Strength};
use crate::vibrate::answer::{self as vibration, Vibration, Wanted};
use epicyclic_layout::{self as layout, Layout, Verdict};
use epicyclic_train::set::{Gearing, SetKind, SetSpec};
use epicyclic_train::{Analysis, Gearbox, PlanetSet};
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::ControlFlow;

/// Places in a range of `k`, at most and at least.
const PLACES: [u32; 2] = [60, 12];
/// Analyses of gears for all ranges of `k` together: beyond it the places are fewer, so that a page takes
/// seconds.
const ANALYSES: usize = 6000;
/// The `k` usual for a set with one sun, one ring and one kind of planet.
const USUAL_K: [f64; 2] = [1.5, 4.5];
/// How far the range goes beyond the set's own `k` where that is at the end of the usual ones: over `k − 1`
/// below, over `k` above.
const BEYOND_K: [f64; 2] = [0.6, 1.3];
/// The range of `k` of other sets over their own.
const OVER_OWN_K: [f64; 2] = [0.6, 1.6];

/// A gearbox: all gears, each gear in full, and what another `k` would change.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearboxReport {
    /// Names of its planet sets.
    pub sets: Vec<String>,
    /// All gears.
    pub overview: Overview,
    /// Each gear in full, in their order.
    pub gears: Vec<OneGear>,
    /// All shifts; `null` of a gearbox with more gears than they are told of.
    pub shifts: Option<Shifts>,
    /// The strength of its teeth at the operating point with load and speed, then over the duty of its file;
    /// empty where the file does not state oil, life and the `strength` of a set.
    pub strength: Vec<Strength>,
    /// Its losses by their sources at the operating point; `null` without speed and load, and where nothing
    /// loses power.
    pub losses: Option<LossChapter>,
    /// Data sheets of its gears; `null` where the file says enough of no set.
    pub sheets: Option<DataSheets>,
    /// Natural frequencies, modes and what excites them; `null` where the file has no `vibration` of any set.
    pub vibration: Option<Vibration>,
    /// Why its scheme cannot be drawn; `null` of a drawable gearbox.
    pub conflict: Option<Conflict>,
    /// What changes with the `k` of one set while the others stay as they are. Sets with more than two
    /// central gears, which have no one `k`, and pairs on fixed axes are left out.
    pub over_k: Vec<OverK>,
}

/// The gears of a gearbox over the `k` of one set.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct OverK {
    /// The set.
    pub set: String,
    /// Its own `k`: the magnitude of its basic ratio.
    pub own_k: f64,
    /// Whether it loses power.
    pub has_losses: bool,
    /// Values of its `k`, its own among them, from the least.
    pub k: Vec<f64>,
    /// What each gear does at each `k`.
    pub gears: Vec<GearOverK>,
}

/// A gear over the `k` of one set; `null` where nothing follows.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearOverK {
    /// The gear.
    pub gear: String,
    /// Ratio at each `k`, input speed over output speed.
    pub ratios: Vec<Option<f64>>,
    /// Efficiency at each `k`, driven from the input; `null` where the mesh losses hold the gear too.
    pub efficiencies: Vec<Option<f64>>,
    /// Speed of the set's fastest planet relative to its carrier at each `k`.
    pub planet_speeds_of_input: Vec<Option<f64>>,
}

/// The results that a page draws.
#[derive(Debug)]
pub struct Shown<'g> {
    /// The gearbox.
    pub gearbox: &'g Gearbox,
    /// Its gears.
    pub gears: Vec<Analysis<'g>>,
    /// Its layout, if it is drawable.
    pub layout: Option<Box<Layout>>,
}

/// The chapters of a gearbox with the input as asked, and the results that their pictures show, unless
/// `goes_on`, which is asked now and then, breaks.
///
/// # Errors
/// Those of [`overview::answer`], [`gear::answer`], [`strength::chapters`], [`losses::chapter`],
/// [`sheet::chapter`] and [`vibration::chapter`].
pub fn answer<'g>(
    subject: &'g Subject<'_>,
    input: Input,
    wanted: &Wanted,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<(GearboxReport, Shown<'g>), Error> {
    let gearbox = &subject.gearbox;
    let names = || gearbox.gears().iter().map(epicyclic_train::Gear::name);
    let (layout, conflict) = match layout::draw(gearbox, layout::Options::default()) {
        Verdict::Drawable(layout) => (Some(layout), None),
        Verdict::SelfCrossing(witness) => (None, Some(Conflict::of(gearbox, &witness))),
    };
    let report = GearboxReport {
        sets: gearbox.sets().iter().map(|set| set.id().to_owned()).collect(),
        overview: overview::answer(subject, input, None)?,
        gears: names().map(|gear| gear::answer(subject, gear, input)).collect::<Result<_, Error>>()?,
        shifts: match shifts::answer(subject, input.speed) {
            Err(Error::ManyGears { .. }) => None,
            shifts => Some(shifts?),
        },
        strength: strength::chapters(subject, input)?,
        losses: losses::chapter(subject, input)?,
        sheets: sheet::chapter(subject)?,
        vibration: vibration::chapter(subject, wanted, goes_on)?,
        conflict,
        over_k: over_k(gearbox),
    };
    let gears = names().map(|gear| analysis(gearbox, gear)).collect::<Result<_, Error>>()?;
    Ok((report, Shown { gearbox, gears, layout }))
}

fn over_k(gearbox: &Gearbox) -> Vec<OverK> {
    let of_set = |(place, set): (usize, &PlanetSet)| {
        let kind = set.kind().filter(|_| !set.is_pair())?;
        let own_k = set.basic_ratio().get().abs();
        let k = with_own(values(gearbox, range(kind, own_k)), own_k);
        let others: Vec<Option<Gearbox>> = k.iter().map(|k| with_k(gearbox, place, *k)).collect();
        let gears = gearbox.gears().iter().map(|gear| GearOverK::of(&others, gear.name(), place)).collect();
        Some(OverK { set: set.id().to_owned(), own_k, has_losses: set.has_losses(), k, gears })
    };
    gearbox.sets().iter().enumerate().filter_map(of_set).collect()
}

impl GearOverK {
    fn of(gearboxes: &[Option<Gearbox>], gear: &str, set: usize) -> Self {
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

/// The `k` to look at: those usual for a set with sun and ring, and some on either side of its own.
fn range(kind: SetKind, k: f64) -> [f64; 2] {
    match kind {
        SetKind::Simple => {
            [(1.0 + BEYOND_K[0] * (k - 1.0)).min(USUAL_K[0]), (BEYOND_K[1] * k).max(USUAL_K[1])]
        }
        _ => OVER_OWN_K.map(|part| part * k),
    }
}

fn values(gearbox: &Gearbox, [low, high]: [f64; 2]) -> Vec<f64> {
    let [most, fewest] = PLACES;
    let each = ANALYSES / (gearbox.sets().len() * gearbox.gears().len()).max(1);
    let places = u32::try_from(each).unwrap_or(most).clamp(fewest, most);
    (0..=places).map(|i| low + (high - low) * f64::from(i) / f64::from(places)).collect()
}

/// The same places with the set's own `k` among them, so that each curve has the gearbox itself.
fn with_own(mut values: Vec<f64>, own: f64) -> Vec<f64> {
    let place = values.partition_point(|value| *value < own);
    if values.get(place) != Some(&own) {
        values.insert(place, own);
    }
    values
}

/// The gearbox with another `k` of one set; `None` where that is no set.
fn with_k(gearbox: &Gearbox, set: usize, k: f64) -> Option<Gearbox> {
    let id = gearbox.sets()[set].id();
    let change = |spec: SetSpec| {
        if spec.id == id {
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

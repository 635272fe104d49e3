//! One stage with planets of two gears: stepped planets, or a Wolfrom set.
//!
//! Every set of tooth numbers within the bounds and the tolerance is found. The most promising by their
//! [estimated volume](epicyclic_strength::arranged) are sized with face widths and centre distances far apart, the
//! best of these in full, each for the torque that its own losses leave.

use super::making::{Load, MAKING, mapping, with_duty};
use super::stages::{Listed, TrainOfStages, TrainsOf};
use super::stages_file::{GEAR, efficiencies, written};
use super::stages_wanted::WantedStages;
use crate::error::Error;
use crate::shared::gearbox::{Choice, one};
use crate::size::answer as size;
use crate::size::options::{Effort, Request as SizeRequest};
use crate::strength::answer::missing::{MissingKeys, Purpose};
use epicyclic_formats::Document;
use epicyclic_formats::yaml::Value;
use epicyclic_gears::Error as GearError;
use epicyclic_gears::arrangement::{ArrangedTeeth, Arrangement, ArrangementBounds, ArrangementMode};
use epicyclic_gears::synthesis::{Bounds, MOST_PLANETS};
use epicyclic_judge::Rule;
use epicyclic_numerics::threads::map;
use epicyclic_strength::arranged::estimated_volume;
use epicyclic_strength::sizing::{Objective, priced};
use schemars::JsonSchema;
use serde::Serialize;
use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use uom::si::f64::Torque;

/// Sets that are sized coarsely at most.
pub(crate) const MOST_TRIED: usize = 240;

/// Of these the best, which are sized in full.
pub(crate) const MOST_SIZED: usize = 12;

/// Sets that are sized before the search gives up where none of them holds.
const MOST_HOPELESS: usize = 24;

/// Sets that are sized between two questions whether to go on.
const AT_A_TIME: usize = 4;

/// Kind of a stage.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema, clap::ValueEnum)]
#[serde(rename_all = "snake_case")]
pub enum StageKind {
    /// Simple sets: sun, planets, ring
    Simple,
    /// One set with stepped planets: one step with the sun, the other with the ring
    Stepped,
    /// One Wolfrom set: sun and resting ring with one step of the planets, the output ring with the other
    Wolfrom,
}

impl StageKind {
    /// Every kind.
    pub(crate) const ALL: [Self; 3] = [Self::Simple, Self::Stepped, Self::Wolfrom];

    /// Kind of a stage by its gears.
    pub(crate) const fn of(teeth: &[u32]) -> Self {
        match teeth.len() {
            4 => Self::Stepped,
            5 => Self::Wolfrom,
            _ => Self::Simple,
        }
    }

    /// Arrangement of the gears; `None` of simple sets.
    const fn arrangement(self) -> Option<Arrangement> {
        match self {
            Self::Simple => None,
            Self::Stepped => Some(Arrangement::Stepped),
            Self::Wolfrom => Some(Arrangement::Wolfrom),
        }
    }

    /// The mode with the sun as the fast member, driven or driving.
    fn mode(self, wanted: &WantedStages) -> Option<ArrangementMode> {
        let letters = match (self, wanted.turns_back, wanted.steps_up) {
            (Self::Stepped, false, false) => "aH^b",
            (Self::Stepped, false, true) => "Ha^b",
            (Self::Stepped, true, false) => "ab^H",
            (Self::Stepped, true, true) => "ba^H",
            (_, _, false) => "ae^b",
            (_, _, true) => "ea^b",
        };
        self.arrangement()?.mode(letters)
    }
}

/// Set of teeth with its ratio and its estimated volume.
struct Candidate {
    teeth: Vec<u32>,
    ratio: f64,
    volume: f64,
}

impl Candidate {
    fn of(train: &TrainOfStages) -> Self {
        let teeth = train.teeth.first().cloned().unwrap_or_default();
        Self { teeth, ratio: train.ratio, volume: 0.0 }
    }
}

/// Lists the best sets within a tolerance.
pub(super) fn listed(
    wanted: &WantedStages,
    (tolerance, most): (f64, usize),
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<Listed, Error> {
    let (found, all) = candidates(wanted, tolerance, goes_on)?;
    let coarse = &all[..all.len().min(MOST_TRIED)];
    let (tried, mut promising) = sized_all(wanted, coarse, Effort::Coarse, goes_on)?;
    promising.sort_by(|one, other| one.0.cost(&other.0));
    promising.truncate(MOST_SIZED);
    let best: Vec<Candidate> = promising.into_iter().map(|(train, _)| Candidate::of(&train)).collect();
    let (_, sized) = sized_all(wanted, &best, Effort::Found, goes_on)?;
    let is_long = |length: &f64| wanted.limits.length_m.is_some_and(|most| *length > most);
    let shortest = sized.iter().map(|(_, length)| *length).filter(is_long).reduce(f64::min);
    let within = sized.into_iter().filter(|(_, length)| !is_long(length));
    let mut trains: Vec<TrainOfStages> = within.map(|(train, _)| train).collect();
    trains.sort_by(TrainOfStages::cost);
    trains.truncate(most);
    let mut trains = trains.into_iter();
    let of_stage = TrainsOf {
        stages: 1,
        has_pair: false,
        kind: wanted.kind(),
        reachable: None,
        compared: found,
        sized: tried as u64,
        complete: tried == all.len() && tried <= MOST_SIZED,
        best: trains.next(),
        next: trains.next(),
        taken: false,
    };
    let shortest = shortest.filter(|_| of_stage.best.is_none());
    Ok(Listed { sets: all.len(), trains: vec![of_stage], prices: vec![0.0], shortest, ended_early: vec![] })
}

impl TrainOfStages {
    /// The order of trains: first those with fewer stages beyond usual practice.
    fn cost(&self, other: &Self) -> Ordering {
        self.unusual_stages.cmp(&other.unusual_stages).then(self.price_kg.total_cmp(&other.price_kg))
    }
}

/// Sets with their lengths in m.
type Sized = Vec<(TrainOfStages, f64)>;

/// Sizes sets, with how many were tried: all, or the first where none of these holds.
fn sized_all(
    wanted: &WantedStages,
    all: &[Candidate],
    effort: Effort,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<(usize, Sized), Error> {
    let size = SizeRequest { effort, most: 1, ..wanted.size.clone() };
    let (mut tried, mut found) = (0, vec![]);
    for some in all.chunks(AT_A_TIME) {
        if goes_on().is_break() {
            return Err(epicyclic_strength::Error::Cancelled.into());
        }
        // Where the most promising do not hold, trying all the others takes long and finds none.
        if found.is_empty() && tried >= MOST_HOPELESS {
            break;
        }
        tried += some.len();
        for one in map(some, |candidate| sized(wanted, candidate, &size)) {
            found.extend(one?);
        }
    }
    Ok((tried, found))
}

/// Number of sets of tooth numbers with their numbers of planets, and each set of tooth numbers once, the least
/// estimated volume first.
fn candidates(
    wanted: &WantedStages,
    tolerance: f64,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<(u64, Vec<Candidate>), Error> {
    let kind = wanted.kind();
    let Some((arrangement, mode)) = kind.arrangement().zip(kind.mode(wanted)) else { return Ok((0, vec![])) };
    let (teeth, planets) = (&wanted.teeth, wanted.size.planet_counts());
    let bounds = Bounds {
        sun: wanted.arranged_suns.clone(),
        planet: teeth.planets.clone(),
        ring: teeth.rings.clone(),
        planets: (*planets.start()).max(2)..=(*planets.end()).clamp(2, MOST_PLANETS),
        ..Bounds::default()
    };
    let bounds = ArrangementBounds {
        offsets: teeth.ring_offsets.clone(),
        aim: wanted.size.aim,
        ..ArrangementBounds::of(arrangement, &bounds)
    };
    let found = match bounds.for_ratio(wanted.asked(), mode, tolerance, usize::MAX, |_| goes_on()) {
        Ok(found) => found,
        Err(GearError::NoArrangement { .. }) => return Ok((0, vec![])),
        Err(error) => return Err(error.into()),
    };
    let mut all: BTreeMap<Vec<u32>, Candidate> = BTreeMap::new();
    for one in &found.first {
        let divides = |divisors: Vec<u32>| divisors.iter().any(|divisor| *divisor > 1);
        if one.teeth.has_one_step() || teeth.is_hunting && divides(one.teeth.common_divisors()) {
            continue;
        }
        let Some(volume) = estimated_volume(&one.teeth) else { continue };
        let own = |of: &ArrangedTeeth| Candidate { teeth: of.teeth().to_vec(), ratio: one.ratio, volume };
        let known = all.entry(one.teeth.teeth().to_vec()).or_insert_with(|| own(&one.teeth));
        known.volume = known.volume.min(volume);
    }
    let mut all: Vec<Candidate> = all.into_values().collect();
    all.sort_by(|one, other| one.volume.total_cmp(&other.volume));
    Ok((found.found, all))
}

/// Sizes a set; `None` if nothing holds, or if its losses hold it. The length is beside it, in m.
fn sized(
    wanted: &WantedStages,
    candidate: &Candidate,
    size: &SizeRequest,
) -> Result<Option<(TrainOfStages, f64)>, Error> {
    let stages = vec![candidate.teeth.clone()];
    let [Some(efficiency), _] = efficiencies(wanted, &stages)? else { return Ok(None) };
    let torque = wanted.input_torque(candidate.ratio, Some(efficiency));
    let document = making(wanted, &candidate.teeth, torque)?;
    let subject = one(&document, &Choice::default())?;
    let size = size::answer(&subject, size, &|| ControlFlow::Continue(()))?;
    let Some(best) = size.sets.first().and_then(|set| set.found.first()) else { return Ok(None) };
    let is_whole = wanted.size.objective() == Objective::Whole;
    let mass_kg = if is_whole { best.with_structure_kg() } else { best.mass_kg };
    // Simple sets lose little; here the losses are a rule like the others.
    let loses = !subject.limits.judge(Rule::StageEfficiency, efficiency).holds();
    let rules_missed = best.rules_missed + u32::from(loses && !wanted.size.beyond_practice);
    let [unusual, price_kg] = priced(rules_missed, mass_kg);
    let train = TrainOfStages {
        ratios: vec![candidate.ratio],
        ratio: candidate.ratio,
        teeth: stages,
        unusual_stages: unusual as u32,
        rules_missed,
        mass_kg,
        price_kg,
    };
    Ok(Some((train, best.length_m)))
}

/// The gearbox in the making with materials, factors and duty, and this torque on the input.
pub(super) fn making(wanted: &WantedStages, teeth: &[u32], torque: Torque) -> Result<Document, Error> {
    let making = text(wanted, teeth, torque)?;
    let document = Document::parse_one(MAKING, making.as_bytes())?;
    let subject = one(&document, &Choice::default())?;
    let missing = MissingKeys::of(&subject, &document.read()?, &wanted.basis, Purpose::Sizes)?;
    let completed = missing.assumed(&wanted.basis)?;
    Ok(completed.map_or(document, |(gearbox, _)| gearbox.document))
}

/// File of a set without sizes and strength, with a torque on the input.
pub(super) fn text(wanted: &WantedStages, teeth: &[u32], torque: Torque) -> Result<String, Error> {
    let [fast, slow] = if wanted.steps_up { ["output", "input"] } else { ["input", "output"] };
    let number = |place: usize| Value::from(teeth[place]);
    let gears = |of: [&str; 2]| Value::Sequence(of.map(Value::from).to_vec());
    let mesh = |of: [&str; 2], efficiency: f64| {
        mapping(vec![("gears", gears(of)), ("efficiency", efficiency.into())])
    };
    let [outer, inner] = wanted.efficiencies_of_meshes();
    let of_sun = mesh([fast, "planet.1"], outer);
    let is_wolfrom = StageKind::of(teeth) == StageKind::Wolfrom;
    let (carrier, rings, steps, meshes) = if is_wolfrom {
        (
            "carrier",
            mapping(vec![("ground", number(2)), (slow, number(4))]),
            [1, 3],
            vec![of_sun, mesh(["planet.1", "ground"], inner), mesh(["planet.2", slow], inner)],
        )
    } else {
        let [carrier, ring] = if wanted.turns_back { ["ground", slow] } else { [slow, "ground"] };
        let rings = mapping(vec![(ring, number(3))]);
        (carrier, rings, [1, 2], vec![of_sun, mesh(["planet.2", ring], inner)])
    };
    let steps = Value::Sequence(steps.map(number).to_vec());
    let set = mapping(vec![
        ("id", "stage 1".into()),
        ("carrier", carrier.into()),
        ("suns", mapping(vec![(fast, number(0))])),
        ("rings", rings),
        ("planet_gears", mapping(vec![("planet", steps)])),
        ("meshes", Value::Sequence(meshes)),
    ]);
    let name = if is_wolfrom { "Wolfrom set" } else { "set with stepped planets" };
    let sets = ("compound_sets", Value::Sequence(vec![set]));
    let load = Load { torque, speed: wanted.speed, overload: wanted.overload, spectrum: &wanted.spectrum };
    written(name, sets, |file| with_duty(file, &wanted.basis, &[(GEAR, 1.0)], load))
}

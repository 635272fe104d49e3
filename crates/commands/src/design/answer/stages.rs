//! Stages in series for one ratio: splits, tooth numbers and sizes chosen together.

use super::assumed::{AssumedLoad, assumed};
use super::attempt::CLASSES;
use super::making::{BEARINGS_DECIDE, Load, MAKING, mapping, warnings, with_load};
use super::masses::Masses;
use super::records::SizesStep;
use super::ways_out::WayOutOfStages;
use crate::analyze::answer::{analysis, moving};
use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::application::FULL_LOAD;
use crate::shared::basis::{Basis, BasisKey};
use crate::shared::gearbox::{Choice, one};
use crate::size::answer::{self as size, sizing_of};
use crate::size::options::Request as SizeRequest;
use crate::tolerance::ROUNDED;
use epicyclic_formats::Document;
use epicyclic_formats::yaml::{Value, to_string};
use epicyclic_gears::ToothCount;
use epicyclic_strength::series::{
    Found, InputStep, KnownSets, Order, STAGE_PRICE, Teeth, Train, Trains, search,
};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::{ControlFlow, RangeInclusive};
use uom::si::f64::{AngularVelocity, Torque};

/// Mass with rollers in the bores over that with bearings of the tables, up to which they are taken.
const BEARINGS_PAY: f64 = 0.8;

/// Stages that are tried at most.
pub(crate) const MOST_STAGES: u32 = 4;

/// Order for stages in series.
#[derive(Debug, Clone)]
pub struct WantedStages {
    /// Speed of the fast shaft over that of the slow one, by amount.
    pub ratio: f64,
    /// Whether the output is the fast shaft.
    pub steps_up: bool,
    /// Whether the rings turn with the slow shaft and its carrier is held, so that the output turns against the
    /// input; the rings are held otherwise.
    pub rings_turn: bool,
    /// Allowed relative deviation of the ratio.
    pub tolerance: f64,
    /// Numbers of stages.
    pub stages: RangeInclusive<usize>,
    /// Tooth numbers of the sets.
    pub teeth: Teeth,
    /// Speed of the input.
    pub speed: AngularVelocity,
    /// Whether input and output turn backward.
    pub is_backward: bool,
    /// Whether trains with smaller rings are asked for.
    pub is_front_asked: bool,
    /// Whether the request itself asks for gears without common divisors.
    pub is_hunting_asked: bool,
    /// Torque on the input; where the output's is asked for, this one over the ratio.
    pub torque: Torque,
    /// Whether the torque of the output is asked for, so that the input gives the losses as well.
    pub is_of_output: bool,
    /// Greatest torque during the life over the nominal torque.
    pub overload: Option<f64>,
    /// Efficiency of each set with its carrier fixed, which the file states.
    pub efficiency: f64,
    /// Materials, factors, oil and life.
    pub basis: Basis,
    /// Search space of sizes.
    pub size: SizeRequest,
}

/// Stages in series for one ratio, with sufficient strength.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Stages {
    /// Required ratio, input speed over output speed; below 0 the rings turn with the slow shaft, and its
    /// carrier is held.
    pub asked_ratio: f64,
    /// Allowed relative deviation of the ratio.
    pub tolerance: f64,
    /// Relative deviation within which trains were compared: a part of the tolerance, or all of it.
    pub searched_tolerance: f64,
    /// Reached ratio; null if no train holds.
    pub ratio: Option<f64>,
    /// Speed of the input in rad/s.
    pub input_speed_rad_s: f64,
    /// Required speed of the output in rad/s.
    pub asked_output_speed_rad_s: f64,
    /// Reached speed of the output in rad/s; null if no train holds.
    pub output_speed_rad_s: Option<f64>,
    /// Required torque on the output in N·m; null where the load of the input is given.
    pub asked_output_torque_n_m: Option<f64>,
    /// Torque on the output, with the losses of the meshes, in N·m; null if no train holds.
    pub output_torque_n_m: Option<f64>,
    /// Torque on the input in N·m; null if no train holds and that of the output is given.
    pub input_torque_n_m: Option<f64>,
    /// Power into the input in W; null if no train holds and the torque of the output is given.
    pub input_power_w: Option<f64>,
    /// Efficiency of the meshes of all stages; null if no train holds.
    pub efficiency: Option<f64>,
    /// Efficiency of the meshes when the output drives; null if no train holds, or if the losses hold it.
    pub back_driving_efficiency: Option<f64>,
    /// Sets of tooth numbers that stages were chosen from.
    pub sets: usize,
    /// Tooth numbers allowed.
    pub teeth: TeethRanges,
    /// Best trains of each number of stages.
    pub trains: Vec<TrainsOf>,
    /// Assumed values by key.
    pub basis: Vec<BasisKey>,
    /// Assumptions that are no keys of the file.
    pub assumed: Vec<BasisKey>,
    /// Masses of the whole and of its parts; null if no train holds.
    pub masses: Option<Masses>,
    /// Sizes of the train taken, with their strength over the duty; null if no train holds.
    pub sizes: Option<SizesStep>,
    /// Gearbox file with sizes; null if no train holds.
    pub file: Option<String>,
    /// Limits to relax if no train holds, each with the train that is then found. Null if there is a file.
    pub ways_out: Option<Vec<WayOutOfStages>>,
    /// Trains with smaller and smaller rings, each the best that its limit of the rings leaves; null if not asked
    /// for, or without a train.
    pub front: Option<Vec<WayOutOfStages>>,
    /// Warnings about the gearbox.
    pub warnings: Vec<Warning>,
}

/// Least and greatest tooth numbers allowed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TeethRanges {
    /// Tooth numbers of the suns.
    pub sun: [u32; 2],
    /// Tooth numbers of the planets.
    pub planet: [u32; 2],
    /// Tooth numbers of the rings.
    pub ring: [u32; 2],
}

/// Trains of one number of stages.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TrainsOf {
    /// Number of stages.
    pub stages: usize,
    /// Least and greatest ratio of so many stages with the tooth numbers allowed, the nearer to 1 first; null
    /// if these leave no set.
    pub reachable: Option<[f64; 2]>,
    /// Trains of tooth numbers within the tolerance.
    pub compared: u64,
    /// Stages that were sized.
    pub sized: u64,
    /// Whether every better train is excluded; false if the search ended early.
    pub complete: bool,
    /// Best train; null if none holds.
    pub best: Option<TrainOfStages>,
    /// Next best train; null if there is none.
    pub next: Option<TrainOfStages>,
    /// Whether the best train is taken.
    pub taken: bool,
}

/// Stages in series.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TrainOfStages {
    /// Tooth numbers of sun, planet and ring of each stage, from the input on.
    pub teeth: Vec<[u32; 3]>,
    /// Ratio of each stage with its ring held.
    pub ratios: Vec<f64>,
    /// Ratio of the train.
    pub ratio: f64,
    /// Stages that usual practice warns of.
    pub unusual_stages: u32,
    /// Rules of usual practice that the stages miss.
    pub rules_missed: u32,
    /// Mass in kg that decides: of gears, carriers and housing by a rule, or of the gears.
    pub mass_kg: f64,
    /// This mass with a quarter more for each rule missed, in kg.
    pub price_kg: f64,
}

impl Answer for Stages {
    const NAME: &'static str = "design-stages";
}

impl WantedStages {
    /// Input over output, from the quotient of fast and slow.
    fn of_input(&self, quotient: f64) -> f64 {
        if self.steps_up { 1.0 / quotient } else { quotient }
    }

    /// Input speed over output speed, from the quotient of fast and slow by amount.
    fn over_output(&self, quotient: f64) -> f64 {
        let amount = self.of_input(quotient);
        if self.rings_turn { -amount } else { amount }
    }

    /// Quotient of fast and slow by amount, from the product of the stages' ratios.
    fn quotient(&self, product: f64) -> f64 {
        if self.rings_turn { product - 1.0 } else { product }
    }

    /// Product of the stages' ratios, from the quotient of fast and slow by amount.
    fn product(&self, quotient: f64) -> f64 {
        if self.rings_turn { quotient + 1.0 } else { quotient }
    }

    /// The duty of the fast shaft, by the largest torque that a train of at most these stages within a
    /// tolerance has there.
    fn fast(&self, tolerance: f64, stages: usize) -> InputStep {
        let torque = match self.is_of_output {
            true => self.torque / self.least_efficiency(tolerance, stages),
            false => self.torque,
        };
        let (torque, speed) = match self.steps_up {
            true => (torque / (self.ratio * (1.0 - tolerance)), self.speed * self.ratio),
            false if self.is_of_output => (torque / (1.0 - tolerance), self.speed),
            false => (torque, self.speed),
        };
        InputStep { share: 1.0, torque, speed }
    }

    /// Least efficiency of trains of a number of stages within a tolerance: that of equal stages with the
    /// greatest ratio, since the logarithm of the efficiency of a stage is convex over that of its ratio.
    fn least_efficiency(&self, tolerance: f64, stages: usize) -> f64 {
        let stages = stages as f64;
        let product = self.product(self.ratio * (1.0 + tolerance));
        let k = libm::pow(product, 1.0 / stages) - 1.0;
        // Torque of the slow shaft, or of the rings that turn with it, over that of the fast one.
        let with = |efficiency: f64| self.quotient(libm::pow(1.0 + k * efficiency, stages));
        match self.steps_up {
            true => with(1.0) / with(1.0 / self.efficiency),
            false => with(self.efficiency) / with(1.0),
        }
    }

    /// Torque on the input of a train with this ratio of input over output and this efficiency.
    fn input_torque(&self, ratio: f64, efficiency: Option<f64>) -> Torque {
        match (self.is_of_output, efficiency) {
            (true, Some(efficiency)) => self.torque * self.over_output(self.ratio) / (ratio * efficiency),
            (true, None) => self.torque * self.over_output(self.ratio) / ratio,
            (false, _) => self.torque,
        }
    }
}

impl TrainOfStages {
    /// The search goes from the fast shaft on.
    fn of(wanted: &WantedStages, train: &Train) -> Self {
        let mut stages = train.stages.clone();
        if wanted.steps_up {
            stages.reverse();
        }
        let ratio = |[sun, _, ring]: &[ToothCount; 3]| wanted.of_input(1.0 + ring.as_f64() / sun.as_f64());
        Self {
            teeth: stages.iter().map(|teeth| teeth.map(ToothCount::get)).collect(),
            ratios: stages.iter().map(ratio).collect(),
            ratio: wanted.over_output(wanted.quotient(train.ratio)),
            unusual_stages: train.unusual_stages,
            rules_missed: train.rules_missed,
            mass_kg: train.mass_kg,
            price_kg: train.price_kg,
        }
    }
}

impl TrainsOf {
    fn of(wanted: &WantedStages, trains: &Trains) -> Self {
        let mut found = trains.found.iter().map(|train| TrainOfStages::of(wanted, train));
        let of_one = wanted.teeth.ratios();
        let of_all = |end: f64| wanted.quotient(libm::pow(end, trains.stages as f64));
        let reachable = of_one.map(|ends| ends.map(|end| wanted.over_output(of_all(end))));
        Self {
            stages: trains.stages,
            reachable,
            compared: trains.trains,
            sized: trains.sized,
            complete: trains.is_complete,
            best: found.next(),
            next: found.next(),
            taken: false,
        }
    }
}

/// Designs stages in series without ways out and front; `most` trains of each number of stages are listed.
/// `known` is of orders that differ in limits of ratio, stages and rings alone: with the bearings of the
/// order, and with larger ones, which are taken where none of them holds or where they save a fifth of the
/// mass. These sizes come back if they are taken.
pub(super) fn attempted(
    wanted: &WantedStages,
    most: usize,
    [known, of_larger]: &mut [KnownSets; 2],
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<(Stages, Option<SizeRequest>), Error> {
    let stages = attempted_with(wanted, most, known, goes_on)?;
    // Bearings of a table that are just large enough may make a gearbox several times heavier.
    let is_decided = stages.warnings.iter().any(|warning| warning.name == BEARINGS_DECIDE);
    let is_open = stages.file.is_none() || is_decided;
    let Some(size) = wanted.size.larger().filter(|_| is_open) else { return Ok((stages, None)) };
    let with_larger = WantedStages { size: size.clone(), ..wanted.clone() };
    let other = attempted_with(&with_larger, most, of_larger, goes_on)?;
    let whole = |of: &Stages| of.masses.map_or(f64::INFINITY, |masses| masses.whole_kg);
    let taken = |of: &Stages| of.trains.iter().find(|trains| trains.taken)?.best.clone();
    let missed = |of: &Stages| taken(of).map_or(u32::MAX, |train| train.rules_missed);
    let is_better = missed(&other) <= missed(&stages) && whole(&other) < BEARINGS_PAY * whole(&stages);
    if stages.file.is_none() || is_better {
        return Ok((other, Some(size)));
    }
    Ok((stages, None))
}

/// Designs stages in series with the sizes of the order and no larger ones.
pub(super) fn attempted_with(
    wanted: &WantedStages,
    most: usize,
    known: &mut KnownSets,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<Stages, Error> {
    // As for several speeds, accuracy is not traded for mass beyond a tenth of the tolerance, but for usual
    // practice.
    let (mut within, mut found) = (0.0, None);
    for part in CLASSES {
        let tolerance = part * wanted.tolerance;
        // Trains of a wider class have to keep to usual practice in more stages.
        if let Some(before) = found.as_ref().and_then(unusual)
            && unusual(&searched(wanted, (tolerance, Some(before - 1)), 1, (&mut *known, goes_on))?).is_none()
        {
            continue;
        }
        let of_class = searched(wanted, (tolerance, None), most, (&mut *known, goes_on))?;
        let is_usual = unusual(&of_class) == Some(0);
        (within, found) = (tolerance, Some(of_class));
        if wanted.tolerance == 0.0 || is_usual {
            break;
        }
    }
    let found = found.expect("there are classes");
    let mut trains: Vec<TrainsOf> = found.all.iter().map(|trains| TrainsOf::of(wanted, trains)).collect();
    let cost = |of: &TrainsOf| {
        let best = of.best.as_ref()?;
        Some((best.unusual_stages, best.price_kg * STAGE_PRICE.powi(of.stages as i32)))
    };
    let taken = (0..trains.len()).filter(|place| cost(&trains[*place]).is_some()).min_by(|one, other| {
        let [one, other] = [one, other].map(|place| cost(&trains[*place]).unwrap_or_default());
        one.0.cmp(&other.0).then(one.1.total_cmp(&other.1))
    });
    if let Some(place) = taken {
        trains[place].taken = true;
    }
    let train = taken.and_then(|place| trains[place].best.clone());
    let (mut sizes, mut file, mut all_warnings) = (None, None, vec![]);
    let (mut efficiency, mut back_driving_efficiency, mut masses) = (None, None, None);
    let mut torque = Some(wanted.torque).filter(|_| !wanted.is_of_output);
    if let Some(train) = &train {
        [efficiency, back_driving_efficiency] = efficiencies(wanted, train)?;
        let of_input = wanted.input_torque(train.ratio, efficiency);
        torque = Some(of_input);
        let making = text(wanted, &train.teeth, of_input)?;
        let document = Document::parse_one(MAKING, making.as_bytes())?;
        let size = size::answer(&one(&document, &Choice::default())?, &wanted.size, goes_on)?;
        let saved = size::saved(&document, &size)?;
        all_warnings = warnings(&size, Some(&saved), &wanted.size)?;
        let step = SizesStep::of(size);
        masses = Masses::of(&saved, &step, (wanted.size.application, wanted.overload))?;
        file = Some(saved);
        sizes = Some(step);
    }
    let of_set = BasisKey { key: "efficiency".to_owned(), value: wanted.efficiency.to_string() };
    let load = AssumedLoad { spectrum: &FULL_LOAD, gears: 1, shares: &[], overload: wanted.overload };
    let ratio = train.as_ref().map(|train| train.ratio);
    let speed = if wanted.is_backward { -wanted.speed.si() } else { wanted.speed.si() };
    let ends = |range: &RangeInclusive<u32>| [*range.start(), *range.end()];
    let teeth = &wanted.teeth;
    Ok(Stages {
        asked_ratio: wanted.over_output(wanted.ratio),
        tolerance: wanted.tolerance,
        searched_tolerance: within,
        ratio,
        input_speed_rad_s: speed,
        asked_output_speed_rad_s: speed / wanted.over_output(wanted.ratio),
        output_speed_rad_s: ratio.map(|ratio| speed / ratio),
        asked_output_torque_n_m: wanted
            .is_of_output
            .then(|| wanted.torque.si() * wanted.over_output(wanted.ratio).abs()),
        output_torque_n_m: ratio
            .zip(torque)
            .map(|(ratio, of)| of.si() * ratio.abs() * efficiency.unwrap_or(1.0)),
        input_torque_n_m: torque.map(Physical::si),
        input_power_w: torque.map(|of| (of * wanted.speed).si()),
        efficiency,
        back_driving_efficiency,
        sets: found.sets,
        teeth: TeethRanges { sun: ends(&teeth.suns), planet: ends(&teeth.planets), ring: ends(&teeth.rings) },
        masses,
        trains,
        basis: wanted.basis.told().into_iter().chain([of_set]).collect(),
        assumed: assumed(&wanted.basis, &wanted.size, &load)?,
        sizes,
        file,
        ways_out: None,
        front: None,
        warnings: all_warnings,
    })
}

/// Stages beyond usual practice of the best train; `None` without a train.
fn unusual(found: &Found) -> Option<u32> {
    found.all.iter().filter_map(|trains| trains.found.first()).map(|train| train.unusual_stages).min()
}

/// Efficiencies of the meshes of a train, driven from the input and from the output; `None` if their losses
/// hold it.
fn efficiencies(wanted: &WantedStages, train: &TrainOfStages) -> Result<[Option<f64>; 2], Error> {
    let making = text(wanted, &train.teeth, wanted.torque)?;
    let document = Document::parse_one(MAKING, making.as_bytes())?;
    let subject = one(&document, &Choice::default())?;
    let analysis = analysis(&subject.train, GEAR)?;
    Ok([analysis.efficiency(), analysis.back_driving_efficiency()].map(moving))
}

/// Searches the best trains of each number of stages within a tolerance, with so many stages beyond usual
/// practice at most.
fn searched(
    wanted: &WantedStages,
    (tolerance, most_unusual): (f64, Option<u32>),
    most: usize,
    (known, goes_on): (&mut KnownSets, &dyn Fn() -> ControlFlow<()>),
) -> Result<Found, Error> {
    let order = |stages| Ok::<_, Error>(Order { most_unusual, ..order(wanted, tolerance, stages)? });
    if !wanted.is_of_output {
        return Ok(search(&order(wanted.stages.clone())?, most, known, goes_on)?);
    }
    // More stages lose more, so each number of them has its own torque on the input.
    let mut found = Found { sets: 0, all: vec![] };
    for stages in wanted.stages.clone() {
        let of_number = search(&order(stages..=stages)?, most, known, goes_on)?;
        found.sets = found.sets.max(of_number.sets);
        found.all.extend(of_number.all);
    }
    Ok(found)
}

/// The order as the search takes it.
fn order(wanted: &WantedStages, tolerance: f64, stages: RangeInclusive<usize>) -> Result<Order, Error> {
    let fast = wanted.fast(tolerance, *stages.end());
    // Materials, factors and tools are read from a file, as those of the gearbox will be.
    let making = text(wanted, &[[24, 30, 84]], wanted.torque)?;
    let document = Document::parse_one(MAKING, making.as_bytes())?;
    let mut of_stage = sizing_of(&one(&document, &Choice::default())?, &wanted.size)?;
    for overload in &mut of_stage.overloads {
        overload.sun_torque = fast.torque * wanted.overload.unwrap_or(1.0);
    }
    // Products of ratios are rounded.
    let [less, more] = [1.0 - tolerance - ROUNDED, 1.0 + tolerance + ROUNDED];
    Ok(Order {
        stages,
        ratio: wanted.product(wanted.ratio * less)..=wanted.product(wanted.ratio * more),
        rings_turn: wanted.rings_turn,
        teeth: wanted.teeth.clone(),
        most_unusual: None,
        duty: vec![fast],
        of_stage,
    })
}

/// File of stages without sizes, with a torque on the input.
fn text(wanted: &WantedStages, teeth: &[[u32; 3]], torque: Torque) -> Result<String, Error> {
    let shaft = |place: usize| match place {
        0 => "input".to_owned(),
        _ if place == teeth.len() => "output".to_owned(),
        _ => format!("shaft {place}"),
    };
    let slow = if wanted.steps_up { "input" } else { "output" };
    let set = |(place, [sun, planet, ring]): (usize, &[u32; 3])| {
        let [of_sun, of_carrier] = if wanted.steps_up { [place + 1, place] } else { [place, place + 1] };
        let [mut of_ring, mut of_carrier] = ["ground".to_owned(), shaft(of_carrier)];
        if wanted.rings_turn {
            of_ring = slow.to_owned();
            if of_carrier == of_ring {
                of_carrier = "ground".to_owned();
            }
        }
        mapping(vec![
            ("id", format!("stage {}", place + 1).into()),
            ("sun", shaft(of_sun).into()),
            ("ring", of_ring.into()),
            ("carrier", of_carrier.into()),
            ("teeth", Value::Sequence(vec![(*sun).into(), (*ring).into()])),
            ("planet_teeth", Value::Sequence(vec![(*planet).into()])),
            ("efficiency", wanted.efficiency.into()),
        ])
    };
    let count = if teeth.len() == 1 { "1 stage".to_owned() } else { format!("{} stages", teeth.len()) };
    let mut file = mapping(vec![
        ("gearbox", count.into()),
        ("input", "input".into()),
        ("output", "output".into()),
        ("sets", Value::Sequence(teeth.iter().enumerate().map(set).collect())),
        ("gears", Value::Sequence(vec![mapping(vec![("name", GEAR.into())])])),
    ]);
    let load = Load { torque, speed: wanted.speed, overload: wanted.overload, spectrum: &FULL_LOAD };
    with_load(&mut file, &wanted.basis, &[(GEAR, 1.0)], load);
    to_string(&file).map_err(|error| Error::Json(error.to_string()))
}

/// Name of the only gear.
const GEAR: &str = "only";

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::request;
    use std::iter;

    fn wanted(steps_up: bool) -> WantedStages {
        WantedStages {
            ratio: 20.0,
            is_backward: false,
            is_hunting_asked: false,
            is_front_asked: false,
            steps_up,
            rings_turn: false,
            tolerance: 0.03,
            stages: 1..=3,
            teeth: Teeth {
                suns: 17..=30,
                planets: 17..=80,
                rings: 50..=160,
                ring_offsets: 0..=0,
                ring_to_sun_ratio: 1.2..=12.0,
                is_hunting: false,
            },
            speed: AngularVelocity::from_si(100.0),
            torque: Torque::from_si(45.0),
            is_of_output: true,
            overload: None,
            efficiency: 0.9,
            basis: Basis::default(),
            size: request(iter::empty::<&str>()).unwrap(),
        }
    }

    /// No split of a ratio loses more than equal stages.
    #[test]
    fn the_least_efficiency_is_below_that_of_every_split() {
        for (steps_up, rings_turn) in [(false, false), (true, false), (false, true), (true, true)] {
            let wanted = WantedStages { rings_turn, ..wanted(steps_up) };
            let product = wanted.product(20.0);
            let of = |ratios: &[f64]| {
                let with = |efficiency: f64| {
                    let all = ratios.iter().map(|ratio| 1.0 + (ratio - 1.0) * efficiency).product::<f64>();
                    if rings_turn { all - 1.0 } else { all }
                };
                if steps_up { with(1.0) / with(1.0 / 0.9) } else { with(0.9) / with(1.0) }
            };
            for first in [1.5, 2.5, 3.0, 4.0, 4.472, 5.0, 8.0, 12.0] {
                assert!(wanted.least_efficiency(0.0, 2) <= of(&[first, product / first]) + 1e-12, "{first}");
                for second in [1.5, 2.0, 2.7144, 3.0] {
                    let third = product / (first * second);
                    let is_reduction = third >= 1.0;
                    assert!(
                        !is_reduction
                            || wanted.least_efficiency(0.0, 3) <= of(&[first, second, third]) + 1e-12,
                        "{first} {second}"
                    );
                }
            }
            assert!(wanted.least_efficiency(0.03, 2) < wanted.least_efficiency(0.0, 2));
        }
    }
}

//! Trains of stages, with what was compared.

use super::axes;
use super::stage_kind::StageKind;
use super::stages_wanted::WantedStages;
use epicyclic_strength::series::{STAGE_PRICE, Train, Trains};
use epicyclic_strength::sizing::SetTeeth;
use schemars::JsonSchema;
use serde::Serialize;
use std::cmp::Ordering;

/// Trains of one number of stages.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TrainsOf {
    /// Number of stages.
    pub stages: usize,
    /// Whether the fast stage is a pair of external gears on parallel axes.
    pub has_pair: bool,
    /// Kind of the stages.
    pub kind: StageKind,
    /// Least and greatest ratio of so many stages with the tooth numbers allowed, the nearer to 1 first; null
    /// if these leave no set, and of sets with planets of two gears.
    pub reachable: Option<[f64; 2]>,
    /// Trains of tooth numbers within the tolerance.
    pub compared: u64,
    /// Stages that were sized.
    pub sized: u64,
    /// Whether every better train is excluded; false if the search ended early.
    pub complete: bool,
    /// Best train; null if none holds.
    pub best: Option<TrainOfStages>,
    /// Next best train; null without a second one.
    pub next: Option<TrainOfStages>,
    /// Whether the best train is taken.
    pub taken: bool,
}

/// Stages in series.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TrainOfStages {
    /// Tooth numbers of each stage, from the input on: of sun, planet and ring; of both gears of a pair, the
    /// faster first; of sun, both steps and ring; of a Wolfrom set of sun, first step, its ring, second step, its
    /// ring.
    pub teeth: Vec<Vec<u32>>,
    /// Ratio of each stage with its ring held; of a pair by amount; that of the train of a set with planets of two
    /// gears.
    pub ratios: Vec<f64>,
    /// Ratio of the train.
    pub ratio: f64,
    /// Stages that usual practice warns of.
    pub unusual_stages: u32,
    /// Rules of usual practice that the stages miss.
    pub rules_missed: u32,
    /// Mass in kg that decides: of gears, carriers and housing by a rule, or of the gears.
    pub mass_kg: f64,
    /// Mass that decides with a quarter more for each rule missed, in kg.
    pub price_kg: f64,
}

/// The best trains within a part of the tolerance.
pub(super) struct Listed {
    /// Sets of tooth numbers that stages were chosen from.
    pub(super) sets: usize,
    pub(super) trains: Vec<TrainsOf>,
    /// Price of the length at which the trains of each number of stages were found.
    pub(super) prices: Vec<f64>,
    /// Length of the shortest train above the limit, in m.
    pub(super) shortest: Option<f64>,
    /// Numbers of stages whose search ended early.
    pub(super) ended_early: Vec<usize>,
}

impl TrainOfStages {
    /// Stages beyond usual practice, and the price.
    pub(super) const fn cost(&self) -> (u32, f64) {
        (self.unusual_stages, self.price_kg)
    }

    /// The search goes from the fast shaft on.
    pub(super) fn of(wanted: &WantedStages, train: &Train) -> Self {
        let mut stages = train.stages.clone();
        if wanted.steps_up {
            stages.reverse();
        }
        let teeth = |stage: &SetTeeth| stage.gears().iter().map(|teeth| teeth.get()).collect();
        Self {
            teeth: stages.iter().map(teeth).collect(),
            ratios: stages.iter().map(|stage| wanted.of_input(stage.ratio())).collect(),
            ratio: wanted.over_output(wanted.quotient(train.ratio)),
            unusual_stages: train.unusual_stages,
            rules_missed: train.rules_missed,
            mass_kg: train.mass_kg,
            price_kg: train.price_kg,
        }
    }
}

impl TrainsOf {
    pub(super) fn of(wanted: &WantedStages, trains: &Trains) -> Self {
        let mut found = trains.found.iter().map(|train| TrainOfStages::of(wanted, train));
        let has_pair = wanted.has_pair();
        let of_pair = if has_pair { axes::ratios() } else { [1.0; 2] };
        let sets = trains.stages - usize::from(has_pair);
        let of_one = if sets == 0 { Some([1.0; 2]) } else { wanted.teeth.ratios() };
        let of_all = |end: usize, of_set: f64| of_pair[end] * libm::pow(of_set, sets as f64);
        let of_train = |end, of_set| wanted.over_output(wanted.quotient(of_all(end, of_set)));
        let reachable = of_one.map(|[least, most]| [of_train(0, least), of_train(1, most)]);
        Self {
            stages: trains.stages,
            has_pair,
            kind: StageKind::Simple,
            reachable,
            compared: trains.trains,
            sized: trains.sized,
            complete: trains.is_complete,
            best: found.next(),
            next: found.next(),
            taken: false,
        }
    }

    /// Stages beyond usual practice of the best train, and its price with that of its stages.
    pub(super) fn cost(&self) -> Option<(u32, f64)> {
        let (unusual, price) = self.best.as_ref()?.cost();
        Some((unusual, price * STAGE_PRICE.powi(self.stages as i32)))
    }
}

/// The order of costs: first fewer stages beyond usual practice, then the lower price.
pub(super) fn by_cost(one: (u32, f64), other: (u32, f64)) -> Ordering {
    one.0.cmp(&other.0).then(one.1.total_cmp(&other.1))
}

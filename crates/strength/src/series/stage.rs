//! A stage of a train: its loads behind the stages before it.

use super::{InputStep, Order};
use crate::Error;
use crate::bounded::{Cost, Geometries, Load, Sets, TriedSet};
use crate::sizing::{SetOverload, SetStep, SetTeeth};
use std::ops::ControlFlow;

/// Quotient of the ends of the ranges into which products of ratios are put.
pub(super) const RANGE: f64 = 1.03;

/// Ends of the bands of products for which flanks are tried: the greatest over the least.
const BAND: f64 = 2.0;

/// Ratios before a stage, and of the train.
#[derive(Debug, Clone, Copy)]
pub(super) enum Behind {
    /// Any product of ratios in a range, in any train that is allowed.
    Any([f64; 2]),
    /// One product of ratios in a train of one ratio.
    One { before: f64, ratio: f64 },
}

/// The order as its stages see it.
pub(super) struct Stages<'a> {
    pub(super) order: &'a Order,
    sets: Sets<'a>,
    pairs: Option<Sets<'a>>,
    /// Least products of the ratios before a stage of each band for which flanks are tried, ascending.
    bands: Vec<f64>,
}

impl<'a> Stages<'a> {
    pub(super) fn new(order: &'a Order) -> Self {
        let most = *order.ratio.end();
        let bands = std::iter::successors(Some(1.0), |product| Some(product * BAND).filter(|of| *of < most));
        let pairs = order.first_pair.as_ref().map(|pair| Sets::new(&pair.of_pair));
        Self { order, sets: Sets::new(&order.of_stage), pairs, bands: bands.collect() }
    }

    /// Materials, requirements and space of a set, or of a pair.
    fn sets(&self, teeth: SetTeeth) -> &Sets<'a> {
        self.pairs.as_ref().filter(|_| teeth.is_pair()).unwrap_or(&self.sets)
    }

    /// Least and greatest ratio of a train, where the product up to and with a stage lies in a range.
    fn ratios(&self, [least, most]: [f64; 2]) -> [f64; 2] {
        let [first, last] = [*self.order.ratio.start(), *self.order.ratio.end()];
        // Only the last stage knows it. One stage more at least doubles the product.
        if most >= first { [least.max(first), most.min(last)] } else { [first, last] }
    }

    /// Loads of a set with the least torque, the greatest speed and the fewest turns of all that it may be
    /// behind.
    fn loads(&self, teeth: SetTeeth, behind: Behind) -> (Vec<SetStep>, Vec<SetOverload>) {
        let ratio = teeth.ratio();
        let ([least, most], of_trains) = match behind {
            Behind::Any(before) => (before, self.ratios(before.map(|before| before * ratio))),
            Behind::One { before, ratio } => ([before; 2], [ratio; 2]),
        };
        // Rings that turn are held as seen from them; the held carrier then turns as the output against them.
        let output = match self.order.rings_turn {
            true => of_trains.map(|product| 1.0 / (product - 1.0)),
            false => [0.0; 2],
        };
        let [fast, slow] = [(1.0 + output[0]) / least, (1.0 + output[1]) / most];
        let carrier = if teeth.is_pair() { 0.0 } else { 1.0 / ratio };
        let step = |step: &InputStep| SetStep {
            share: step.share * (slow / fast),
            sun_torque: step.torque * least,
            sun_speed: step.speed * (fast * (1.0 - carrier)),
            carrier_speed: step.speed * (slow * carrier - output[0]).max(0.0),
        };
        let overload = |one: &SetOverload| SetOverload { sun_torque: one.sun_torque * least, ..*one };
        let of_set = self.sets(teeth).of_set;
        (self.order.duty.iter().map(step).collect(), of_set.overloads.iter().map(overload).collect())
    }

    /// Tries a set; `None` if its teeth have no room for one another, whatever the size.
    pub(super) fn stage(&self, teeth: SetTeeth) -> Result<Option<TriedSet>, Error> {
        let of_band = |least: &f64| self.loads(teeth, Behind::Any([*least, least * BAND * RANGE])).0;
        let duties = match teeth {
            SetTeeth::Simple(_) => self.bands.iter().map(of_band).collect(),
            SetTeeth::Pair(_) => vec![self.loads(teeth, Behind::Any([1.0; 2])).0],
        };
        self.sets(teeth).tried(teeth, duties)
    }

    /// Load of a stage.
    fn load(&self, stage: &TriedSet, behind: Behind) -> Load {
        let (Behind::Any([least, _]) | Behind::One { before: least, .. }) = behind;
        // A set that is known of narrower ratios may lack the last band, which its neighbour overlaps.
        let bands = &self.bands[..stage.duties().min(self.bands.len())];
        let duty = bands.partition_point(|of| *of <= least).saturating_sub(1);
        let (steps, _) = self.loads(stage.teeth, behind);
        Load { duty, ..self.sets(stage.teeth).load(stage.teeth, &steps) }
    }

    /// The bound below the cost of a stage where the product of the ratios before it lies in a range; `None`
    /// if nothing can hold.
    pub(super) fn bound(&self, stage: &TriedSet, before: [f64; 2]) -> Option<Cost> {
        self.sets(stage.teeth).bound(stage, self.load(stage, Behind::Any(before)))
    }

    /// Sizes a stage; behind any of a range for the least torque and the fewest turns, which bounds the cost;
    /// `None` if nothing holds.
    pub(super) fn size(
        &self,
        stage: &TriedSet,
        behind: Behind,
        known: &mut Geometries,
        goes_on: &dyn Fn() -> ControlFlow<()>,
    ) -> Result<Option<Cost>, Error> {
        let load = self.load(stage, behind);
        let is_least = matches!(behind, Behind::Any(_));
        let loads = self.loads(stage.teeth, behind);
        self.sets(stage.teeth).size(stage, (load, is_least), loads, known, goes_on)
    }
}

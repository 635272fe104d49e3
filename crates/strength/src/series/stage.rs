//! A stage of a train: its loads behind the stages before it.

use super::{InputStep, Order};
use crate::Error;
use crate::bounded::{Cost, Geometries, Load, Sets, TriedSet};
use crate::sizing::{SetOverload, SetStep};
use epicyclic_gears::ToothCount;
use epicyclic_units::Physical;
use std::ops::ControlFlow;

/// Quotient of neighbouring speeds for which flanks are tried.
const BETWEEN_SPEEDS: f64 = 4.0;

/// The order as its stages see it.
pub(super) struct Stages<'a> {
    pub(super) order: &'a Order,
    sets: Sets<'a>,
    /// Greatest torque of the duty, N·m.
    torque: f64,
    /// Products of the ratios before a stage for which flanks are tried, ascending.
    products: Vec<f64>,
}

impl<'a> Stages<'a> {
    pub(super) fn new(order: &'a Order) -> Self {
        let most = *order.ratio.end();
        let speeds = std::iter::successors(Some(1.0), |product| {
            Some(product * BETWEEN_SPEEDS).filter(|_| *product < most)
        });
        Self {
            order,
            sets: Sets::new(&order.of_stage),
            torque: order.duty.iter().map(|step| step.torque.si().abs()).fold(0.0, f64::max),
            products: speeds.collect(),
        }
    }

    /// Speeds of the input and of the held carrier, relative to the rings, over the speed of the input, where
    /// the product of all ratios may be this one.
    fn seen_from_rings(&self, product: f64) -> [f64; 2] {
        if !self.order.rings_turn {
            return [1.0, 0.0];
        }
        // Only the last stage knows the product. For the others both speeds are the least of all products, off by
        // less than the tolerance times the speed of the output.
        let allowed = &self.order.ratio;
        let products = match allowed.contains(&product) {
            true => [product; 2],
            false => [*allowed.end(), *allowed.start()],
        };
        let [input, held] = products.map(|product| 1.0 / (product - 1.0));
        [1.0 + input, held]
    }

    /// Loads of a set with the least torque and the least speed of a range of products of ratios before it.
    fn loads(&self, ratio: f64, [least, most]: [f64; 2]) -> (Vec<SetStep>, Vec<SetOverload>) {
        let [input, held] = self.seen_from_rings(most * ratio);
        let step = |step: &InputStep| SetStep {
            share: step.share,
            sun_torque: step.torque * least,
            sun_speed: step.speed * (input / most * (1.0 - 1.0 / ratio)),
            carrier_speed: step.speed * (input / (most * ratio) - held).max(0.0),
        };
        let overload = |one: &SetOverload| SetOverload { sun_torque: one.sun_torque * least, ..*one };
        let of_stage = &self.order.of_stage;
        (self.order.duty.iter().map(step).collect(), of_stage.overloads.iter().map(overload).collect())
    }

    /// Tries a set; `None` if its teeth have no room for one another, whatever the size.
    pub(super) fn stage(&self, teeth: [ToothCount; 3]) -> Result<Option<TriedSet>, Error> {
        let ratio = 1.0 + teeth[2].as_f64() / teeth[0].as_f64();
        let duties: Vec<Vec<SetStep>> =
            self.products.iter().map(|product| self.loads(ratio, [*product; 2]).0).collect();
        // A torque in the middle of those that the stage may have.
        let middling = self.torque * libm::sqrt(self.order.ratio.end() / ratio).max(1.0);
        self.sets.tried(teeth, &duties, middling)
    }

    /// Load of a stage where the product of the ratios before it lies in a range.
    fn load(&self, stage: &TriedSet, before: [f64; 2]) -> Load {
        let [_, most] = before;
        // Fewer cycles bear more.
        let duty = self.products.partition_point(|product| *product < most).min(self.products.len() - 1);
        let (steps, _) = self.loads(stage.ratio, before);
        Load { duty, ..self.sets.load(stage.teeth, &steps) }
    }

    /// The bound below the cost of a stage where the product of the ratios before it lies in a range; `None`
    /// if nothing can hold.
    pub(super) fn bound(&self, stage: &TriedSet, before: [f64; 2]) -> Option<Cost> {
        self.sets.bound(stage, self.load(stage, before))
    }

    /// Sizes a stage behind a product of ratios; of a range for the least torque and the fewest turns, which
    /// bounds the cost; `None` if nothing holds.
    pub(super) fn size(
        &self,
        stage: &TriedSet,
        before: [f64; 2],
        known: &mut Geometries,
        goes_on: &dyn Fn() -> ControlFlow<()>,
    ) -> Result<Option<Cost>, Error> {
        let load = self.load(stage, before);
        let is_least = before[0] < before[1];
        self.sets.size(stage, (load, is_least), self.loads(stage.ratio, before), known, goes_on)
    }
}

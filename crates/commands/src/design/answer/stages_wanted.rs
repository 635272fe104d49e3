//! Order for stages in series: ratio and load of both shafts, whatever the train.

use super::axes::{self, Axes};
use super::limits::OrderLimits;
use super::stage_kind::StageKind;
use crate::shared::basis::Basis;
use crate::size::options::Request as SizeRequest;
use epicyclic_strength::series::{InputStep, Teeth};
use std::ops::RangeInclusive;
use uom::si::f64::{Angle, AngularVelocity, Torque};

/// Order for stages in series.
#[derive(Debug, Clone)]
pub struct WantedStages {
    /// Speed of the fast shaft over that of the slow one, by amount.
    pub ratio: f64,
    /// Whether the output is the fast shaft.
    pub steps_up: bool,
    /// Whether the output is to turn against the input.
    pub turns_back: bool,
    /// Allowed relative deviation of the ratio.
    pub tolerance: f64,
    /// Axes of both shafts.
    pub axes: Axes,
    /// Kinds of stages to choose from, at least one.
    pub kinds: Vec<StageKind>,
    /// Numbers of stages.
    pub stages: RangeInclusive<usize>,
    /// Tooth numbers of the sets.
    pub teeth: Teeth,
    /// Teeth of the suns of sets with planets of two gears.
    pub arranged_suns: RangeInclusive<u32>,
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
    /// Steps of the duty: share of the time, torque and speed over these.
    pub spectrum: Vec<[f64; 3]>,
    /// Greatest backlash of the output.
    pub backlash: Option<Angle>,
    /// Limits of the whole gearbox.
    pub limits: OrderLimits,
    /// Efficiency of each set with its carrier fixed, which the file states; of a set with planets of two gears
    /// that of one external and one internal mesh together.
    pub efficiency: f64,
    /// Materials, factors, oil and life.
    pub basis: Basis,
    /// Search space of sizes.
    pub size: SizeRequest,
}

impl WantedStages {
    /// Whether the rings turn with the slow shaft and its carrier is held, so that the output turns against the
    /// input; the rings are held otherwise.
    pub(super) fn rings_turn(&self) -> bool {
        self.turns_back && !self.has_pair()
    }

    /// The kind of stages that is searched.
    pub(super) fn kind(&self) -> StageKind {
        self.kinds.first().copied().unwrap_or(StageKind::Simple)
    }

    /// Efficiencies of an external and of an internal mesh.
    pub(super) fn efficiencies_of_meshes(&self) -> [f64; 2] {
        let outer = axes::efficiency_of_pair(self.efficiency);
        [outer, self.efficiency / outer]
    }

    /// Whether the fast stage is a pair.
    pub(super) fn has_pair(&self) -> bool {
        self.axes == Axes::Parallel
    }

    /// Input over output, from the quotient of fast and slow.
    pub(super) fn of_input(&self, quotient: f64) -> f64 {
        if self.steps_up { 1.0 / quotient } else { quotient }
    }

    /// Input speed over output speed, from the quotient of fast and slow by amount.
    pub(super) fn over_output(&self, quotient: f64) -> f64 {
        let amount = self.of_input(quotient);
        if self.rings_turn() || self.has_pair() { -amount } else { amount }
    }

    /// The ratio asked for, input speed over output speed.
    pub(super) fn asked(&self) -> f64 {
        let amount = self.of_input(self.ratio);
        if self.turns_back { -amount } else { amount }
    }

    /// Quotient of fast and slow by amount, from the product of the stages' ratios.
    pub(super) fn quotient(&self, product: f64) -> f64 {
        if self.rings_turn() { product - 1.0 } else { product }
    }

    /// Product of the stages' ratios, from the quotient of fast and slow by amount.
    pub(super) fn product(&self, quotient: f64) -> f64 {
        if self.rings_turn() { quotient + 1.0 } else { quotient }
    }

    /// The duty of the fast shaft, by the largest torque that a train of at most these stages within a
    /// tolerance has there.
    pub(super) fn fast(&self, tolerance: f64, stages: usize) -> InputStep {
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

    /// Least efficiency of trains of a number of stages, one of them a pair or none, within a tolerance: that of
    /// equal stages with the greatest ratio. The logarithm of a stage's efficiency is convex over that of its
    /// ratio. Behind a pair it is that of the pair with the least ratio.
    fn least_efficiency(&self, tolerance: f64, stages: usize) -> f64 {
        let product = self.product(self.ratio * (1.0 + tolerance));
        if self.has_pair() {
            let ratio = product / axes::ratios()[0];
            let behind = Self { ratio, axes: Axes::Coaxial, turns_back: false, ..self.clone() };
            let of_sets = if stages > 1 { behind.least_efficiency(0.0, stages - 1) } else { 1.0 };
            return axes::efficiency_of_pair(self.efficiency) * of_sets;
        }
        let stages = stages as f64;
        let k = libm::pow(product, 1.0 / stages) - 1.0;
        // Torque of the slow shaft, or of the rings that turn with it, over that of the fast one.
        let with = |efficiency: f64| self.quotient(libm::pow(1.0 + k * efficiency, stages));
        match self.steps_up {
            true => with(1.0) / with(1.0 / self.efficiency),
            false => with(self.efficiency) / with(1.0),
        }
    }

    /// Torque on the input of a train with this ratio of input over output and this efficiency.
    pub(super) fn input_torque(&self, ratio: f64, efficiency: Option<f64>) -> Torque {
        match (self.is_of_output, efficiency) {
            (true, Some(efficiency)) => self.torque * self.asked().abs() / (ratio.abs() * efficiency),
            (true, None) => self.torque * self.asked().abs() / ratio.abs(),
            (false, _) => self.torque,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::request;
    use epicyclic_units::Physical;
    use std::iter;

    fn wanted(steps_up: bool) -> WantedStages {
        WantedStages {
            ratio: 20.0,
            is_backward: false,
            is_hunting_asked: false,
            is_front_asked: false,
            steps_up,
            turns_back: false,
            axes: Axes::Coaxial,
            kinds: vec![StageKind::Simple],
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
            arranged_suns: 17..=60,
            speed: AngularVelocity::from_si(100.0),
            torque: Torque::from_si(45.0),
            is_of_output: true,
            overload: None,
            spectrum: vec![[1.0; 3]],
            backlash: None,
            limits: OrderLimits::default(),
            efficiency: 0.9,
            basis: Basis::default(),
            size: request(iter::empty::<&str>()).unwrap(),
        }
    }

    /// No split of a ratio loses more than equal stages.
    #[test]
    fn the_least_efficiency_is_below_that_of_every_split() {
        for (steps_up, rings_turn) in [(false, false), (true, false), (false, true), (true, true)] {
            let wanted = WantedStages { turns_back: rings_turn, ..wanted(steps_up) };
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

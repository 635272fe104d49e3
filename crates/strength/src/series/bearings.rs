//! The narrowest bearing that fits into a planet and lives long enough.

use super::{InputStep, Order};
use crate::tolerance::RIM;
use epicyclic_gears::life::Rolling;
use epicyclic_units::Physical;
use std::f64::consts::TAU;

/// Bearings with one kind of rolling elements.
#[derive(Debug)]
struct OfKind {
    /// `p`
    exponent: f64,
    /// `(Σ share·turns·(T/T_max)^p)^(1/p)` of the input over the life, turns in millions.
    wear: f64,
    /// By outside diameter, ascending: load ratings, ascending, each with the width of the narrowest bearing
    /// up to this diameter that has at least this rating.
    by_diameter: Vec<(f64, Vec<[f64; 2]>)>,
}

/// The bearings of the space as planets ask for them.
#[derive(Debug)]
pub(super) struct Bearings {
    kinds: [OfKind; 4],
    /// Whether planets need no bearing.
    is_none: bool,
}

impl Bearings {
    pub(super) fn new(order: &Order) -> Self {
        let torque = |step: &InputStep| step.torque.si().abs();
        let greatest = order.duty.iter().map(torque).fold(0.0, f64::max);
        let all = &order.of_stage.space.bearings;
        let kind = |rolling: Rolling| {
            let exponent = rolling.exponent();
            let turns = |step: &InputStep| {
                let millions = step.speed.si().abs() / TAU * order.of_stage.life.si() / 1e6;
                step.share * millions * libm::pow(torque(step) / greatest, exponent)
            };
            let sum: f64 = order.duty.iter().map(turns).sum();
            let mut own: Vec<_> = all.iter().filter(|bearing| bearing.rolling == rolling).collect();
            own.sort_by(|one, other| one.outside_diameter.si().total_cmp(&other.outside_diameter.si()));
            let (mut by_diameter, mut known) = (vec![], vec![]);
            for bearing in own {
                known.push([bearing.load_rating.si(), bearing.width.si()]);
                known.sort_by(|one: &[f64; 2], other| one[0].total_cmp(&other[0]));
                let mut least = f64::INFINITY;
                for [_, width] in known.iter_mut().rev() {
                    least = least.min(*width);
                    *width = least;
                }
                by_diameter.push((bearing.outside_diameter.si(), known.clone()));
            }
            OfKind { exponent, wear: libm::pow(sum, 1.0 / exponent), by_diameter }
        };
        Self { kinds: Rolling::ALL.map(kind), is_none: all.is_empty() }
    }

    /// `turns^(1/p)` of each kind of bearings, for the turns of a planet over those of the input.
    pub(super) fn wear(&self, turns: f64) -> [f64; 4] {
        std::array::from_fn(|kind| libm::pow(turns, 1.0 / self.kinds[kind].exponent))
    }

    /// Width of the narrowest bearing that fits into a bore and lives long enough; `None` if no bearing does.
    /// The force is that at the greatest torque.
    pub(super) fn width(&self, bore: f64, force: f64, wear: [f64; 4]) -> Option<f64> {
        if self.is_none {
            return Some(0.0);
        }
        let of_kind = |(kind, wear): (&OfKind, f64)| {
            let fitting = kind.by_diameter.partition_point(|(diameter, _)| *diameter <= bore * (1.0 + RIM));
            let (_, ratings) = kind.by_diameter.get(fitting.checked_sub(1)?)?;
            let needed = force * kind.wear * wear;
            ratings.get(ratings.partition_point(|[rating, _]| *rating < needed)).map(|[_, width]| *width)
        };
        self.kinds.iter().zip(wear).filter_map(of_kind).reduce(f64::min)
    }
}

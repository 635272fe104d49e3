//! The narrowest bearing that fits into a planet and lives long enough.

use crate::plain_bearing::USUAL_PRESSURE;
use crate::sizing::bearing::Bearing;
use crate::sizing::task::eligible;
use crate::tolerance::RIM;
use epicyclic_gears::life::Rolling;
use epicyclic_units::Physical;

/// Bearings with one kind of rolling elements.
#[derive(Debug)]
struct OfKind {
    /// `p`
    exponent: f64,
    /// By outside diameter, ascending: load ratings, ascending, each with the width of the narrowest bearing
    /// up to this diameter that has at least this rating.
    by_diameter: Vec<(f64, Vec<[f64; 2]>)>,
}

/// The bearings of the space as planets ask for them.
#[derive(Debug)]
pub(super) struct Bearings {
    kinds: [OfKind; 4],
    /// Diameters of plain bearings, ascending.
    plain: Vec<f64>,
    /// Whether planets need no bearing.
    is_none: bool,
}

impl Bearings {
    pub(super) fn new(all: &[Bearing], is_tilted: bool) -> Self {
        let kind = |rolling: Rolling| {
            let mut own: Vec<_> =
                eligible(all, is_tilted).filter(|bearing| bearing.rolling == rolling).collect();
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
            OfKind { exponent: rolling.exponent().unwrap_or(f64::INFINITY), by_diameter }
        };
        let plain = all.iter().filter(|bearing| bearing.rolling == Rolling::Plain);
        let mut plain: Vec<f64> = plain.map(|bearing| bearing.outside_diameter.si()).collect();
        plain.sort_by(f64::total_cmp);
        Self { kinds: Rolling::ALL.map(kind), plain, is_none: all.is_empty() }
    }

    /// `(Σ turns·(F/F_max)^p)^(1/p)` of each kind of bearings over steps of a life, turns in millions, and
    /// the force over the greatest.
    pub(super) fn wear(&self, steps: &(impl Iterator<Item = (f64, f64)> + Clone)) -> [f64; 4] {
        self.kinds.each_ref().map(|kind| {
            let sum: f64 = steps.clone().map(|(turns, force)| turns * libm::pow(force, kind.exponent)).sum();
            libm::pow(sum, 1.0 / kind.exponent)
        })
    }

    /// Width of the narrowest bearing that fits into a bore and lives long enough; `None` if no bearing does.
    /// The force is the greatest one.
    pub(super) fn width(&self, bore: f64, force: f64, wear: [f64; 4]) -> Option<f64> {
        if self.is_none {
            return Some(0.0);
        }
        let of_kind = |(kind, wear): (&OfKind, f64)| {
            let fitting = kind.by_diameter.partition_point(|(diameter, _)| *diameter <= bore * (1.0 + RIM));
            let (_, ratings) = kind.by_diameter.get(fitting.checked_sub(1)?)?;
            let needed = force * wear;
            ratings.get(ratings.partition_point(|[rating, _]| *rating < needed)).map(|[_, width]| *width)
        };
        self.kinds.iter().zip(wear).filter_map(of_kind).reduce(f64::min)
    }

    /// Width of the plain bearing that fits into a bore and bears a force; `None` if none is among the bearings.
    pub(super) fn plain_width(&self, bore: f64, force: f64) -> Option<f64> {
        let fitting = self.plain.partition_point(|diameter| *diameter <= bore * (1.0 + RIM));
        fitting.checked_sub(1).map(|place| force / (USUAL_PRESSURE * self.plain[place]))
    }
}

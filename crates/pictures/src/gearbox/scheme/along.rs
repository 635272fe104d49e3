//! Places along the axis in millimetres.

use super::{ALONG_MM, LEAST_ALONG_MM, signs};
use epicyclic_layout::Layout;
use epicyclic_train::Gearbox;

/// Shares of the distance between two columns with signs, where columns are drawn closest: between two
/// columns where carriers fork around planets, between a forked column and a line, between another sign and a
/// line, and between two lines.
const FORKED: f64 = 8.5 / LEAST_ALONG_MM;
const FORKED_MIXED: f64 = 0.75;
const MIXED: f64 = 0.6;
const LINES: f64 = 0.4;

/// Positions of the columns of a layout.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Along {
    /// The first column.
    from: f64,
    /// Position of each column, mm.
    places: Vec<f64>,
}

impl Along {
    /// The columns of a layout, `along_mm` apart. Where that is less than [`ALONG_MM`], columns without set
    /// or shift element need less than the others.
    pub(super) fn of(gearbox: &Gearbox, layout: &Layout, along_mm: f64) -> Self {
        let (from, to) = (layout.axis.from.x, layout.axis.to.x);
        let marks = layout.sets.iter().map(|stack| stack.x);
        let marks = marks.chain(layout.brakes.iter().map(|mark| mark.link_end.x));
        let marks = marks.chain(layout.clutches.iter().map(|mark| mark.lower.1.x));
        let marks: Vec<f64> = marks.chain(layout.take_offs.iter().map(|end| end.at.x)).collect();
        let has_sign = |x: f64| marks.contains(&x);
        // 0 where columns are closest, 1 at their usual distance.
        let ease = ((along_mm - LEAST_ALONG_MM) / (ALONG_MM - LEAST_ALONG_MM)).clamp(0.0, 1.0);
        let part = |least: f64| least + (1.0 - least) * ease;
        let forks = |x: f64| {
            let is_cut = |set: usize| signs::is_cut(gearbox.drawn_sets()[set].kind);
            layout.sets.iter().any(|stack| stack.x == x && is_cut(stack.set))
        };
        let mut places = vec![along_mm * from];
        let mut x = from;
        while x < to {
            let share = match [x, x + 1.0].map(has_sign) {
                [true, true] if forks(x) && forks(x + 1.0) => part(FORKED),
                [true, true] => 1.0,
                [false, false] => part(LINES),
                _ if forks(x) || forks(x + 1.0) => part(FORKED_MIXED),
                _ => part(MIXED),
            };
            places.push(places[places.len() - 1] + share * along_mm);
            x += 1.0;
        }
        Self { from, places }
    }

    /// Millimetres of a place of the layout.
    pub(super) fn mm(&self, x: f64) -> f64 {
        let (column, part) = ((x - self.from).floor(), (x - self.from).fract());
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // columns of a layout
        let at = |column: f64| self.places[(column.max(0.0) as usize).min(self.places.len() - 1)];
        at(column) + part * (at(column + 1.0) - at(column))
    }

    /// Position in the layout at a distance in millimetres.
    pub(super) fn x(&self, mm: f64) -> f64 {
        let column = self.places.partition_point(|place| *place <= mm).clamp(1, self.places.len().max(2) - 1);
        let [low, high] = [self.places[column - 1], self.places[column]];
        self.from + (column - 1) as f64 + (mm - low) / (high - low)
    }
}

//! Obstacles for labels, sorted by the cells of a grid: a place for a label meets a few of them, a picture
//! has hundreds.

use epicyclic_drawing::Bounds;
use std::cell::Cell;
use std::ops::RangeInclusive;

/// Side of a cell, about the height of a label.
const CELL_MM: f64 = 5.0;
/// Cells along a side at most, a metre.
const MOST_CELLS: f64 = 200.0;

/// Obstacle that a label may not cover.
#[derive(Debug, Clone, Copy)]
pub(super) struct Obstacle {
    /// The box of a label or a fill, or one around a line of its width.
    pub(super) around: Bounds,
    /// The line's place among the lines.
    pub(super) line: Option<usize>,
}

/// Obstacles of a picture. Parts outside the grid belong to the cells at its edge.
pub(super) struct Obstacles {
    all: Vec<Obstacle>,
    area: Bounds,
    columns: usize,
    rows: usize,
    /// Places of the obstacles that reach into each cell, row by row.
    cells: Vec<Vec<usize>>,
    /// The obstacle that was met last: it often blocks the next place as well.
    last: Cell<usize>,
}

impl Obstacles {
    /// No obstacles, with cells over an area.
    pub(super) fn over(area: Bounds) -> Self {
        // NaN would give 0.
        let count = |length: f64| ((length / CELL_MM).ceil().clamp(1.0, MOST_CELLS) as usize).max(1);
        let (columns, rows) = (count(area.right - area.left), count(area.top - area.bottom));
        Self { all: vec![], area, columns, rows, cells: vec![vec![]; columns * rows], last: Cell::new(0) }
    }

    pub(super) fn push(&mut self, obstacle: Obstacle) {
        let (columns, rows) = self.reach(obstacle.around);
        for row in rows {
            for cell in &mut self.cells[row * self.columns..][columns.clone()] {
                cell.push(self.all.len());
            }
        }
        self.all.push(obstacle);
    }

    /// Whether any obstacle that may reach into a box meets it.
    pub(super) fn any(&self, of: Bounds, meets: impl Fn(&Obstacle) -> bool) -> bool {
        if self.all.get(self.last.get()).is_some_and(&meets) {
            return true;
        }
        let (columns, mut rows) = self.reach(of);
        rows.any(|row| {
            let mut near = self.cells[row * self.columns..][columns.clone()].iter().flatten();
            match near.find(|place| meets(&self.all[**place])) {
                Some(place) => {
                    self.last.set(*place);
                    true
                }
                None => false,
            }
        })
    }

    /// Columns and rows of the cells that a box reaches into.
    fn reach(&self, of: Bounds) -> (RangeInclusive<usize>, RangeInclusive<usize>) {
        // The conversion gives 0 for negative values and for NaN.
        let cell = |length: f64, count: usize| ((length / CELL_MM) as usize).min(count - 1);
        let column = |x: f64| cell(x - self.area.left, self.columns);
        let row = |y: f64| cell(y - self.area.bottom, self.rows);
        (column(of.left)..=column(of.right), row(of.bottom)..=row(of.top))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn any_box() -> impl Strategy<Value = Bounds> {
        let side = || (-60.0..160.0_f64, 0.0..90.0_f64);
        (side(), side()).prop_map(|((left, width), (bottom, height))| Bounds {
            left,
            right: left + width,
            bottom,
            top: bottom + height,
        })
    }

    proptest! {
        /// Inside the grid and outside: the same as one by one.
        #[test]
        fn cells_miss_nothing(
            boxes in prop::collection::vec(any_box(), 0..20), asked in prop::collection::vec(any_box(), 1..20),
        ) {
            let mut obstacles = Obstacles::over(Bounds { left: 0.0, right: 97.0, bottom: -10.0, top: 50.0 });
            for &around in &boxes {
                obstacles.push(Obstacle { around, line: None });
            }
            for of in asked {
                let found = obstacles.any(of, |one| one.around.overlaps(of));
                prop_assert_eq!(found, boxes.iter().any(|one| one.overlaps(of)));
            }
        }
    }
}

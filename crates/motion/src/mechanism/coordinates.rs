//! Choice of the coordinates among the node speeds; the other speeds follow from them.

use super::{Mechanism, sets::Asked};
use crate::Error;
use crate::tolerance::RANK;
use epicyclic_numerics::linear::Matrix;
use epicyclic_numerics::values::largest_absolute;
use epicyclic_train::Gearbox;

impl Mechanism {
    /// Eliminates node speeds with the largest pivot of all that is left; the nodes left over are the
    /// coordinates.
    pub(super) fn find_coordinates(&mut self, asked: &[Asked], gearbox: &Gearbox) -> Result<(), Error> {
        let nodes = self.nodes;
        let mut rows: Vec<Vec<f64>> = asked.iter().map(|one| one.row.clone()).collect();
        let mut pivots: Vec<(usize, usize)> = vec![];
        for _ in 0..rows.len() {
            let open = |row: &usize| pivots.iter().all(|(used, _)| used != row);
            let mut best: Option<(f64, usize, usize)> = None;
            for row in (0..rows.len()).filter(open) {
                for (column, entry) in rows[row].iter().enumerate() {
                    if best.is_none_or(|(size, ..)| entry.abs() > size) {
                        best = Some((entry.abs(), row, column));
                    }
                }
            }
            let Some((size, row, column)) = best else { break };
            if size <= RANK * largest_absolute(&asked[row].row).max(1.0) {
                let set = gearbox.sets()[asked[row].set].id().to_owned();
                return Err(Error::Overdetermined { set });
            }
            let pivot = rows[row][column];
            rows[row].iter_mut().for_each(|entry| *entry /= pivot);
            let done = rows[row].clone();
            for (other, entries) in rows.iter_mut().enumerate() {
                let factor = entries[column];
                if other != row && factor != 0.0 {
                    entries.iter_mut().zip(&done).for_each(|(entry, known)| *entry -= factor * known);
                    entries[column] = 0.0;
                }
            }
            pivots.push((row, column));
        }
        self.coordinates =
            (0..nodes).filter(|node| pivots.iter().all(|(_, column)| column != node)).collect();
        self.speeds = Matrix::zeros(nodes, self.coordinates.len());
        for (place, &node) in self.coordinates.iter().enumerate() {
            self.speeds.row_mut(node)[place] = 1.0;
            for &(row, column) in &pivots {
                self.speeds.row_mut(column)[place] = -rows[row][node];
            }
        }
        Ok(())
    }
}

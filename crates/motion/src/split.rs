//! Split of a torque among elements that hold the same.
//!
//! Elements whose slips depend on each other (two brakes on one link, three clutches that make one block)
//! leave the motion unique and the split of torque open. The split chosen is the one that uses the most used
//! element least:
//!
//! ```text
//! minimize τ = max |λ_e|/C_e      over y     λ = λ_0 + N·y       λ_e ≥ −M_0 of one-way clutches
//! ```
//!
//! So the elements hold as long as any split holds: they slip when τ would exceed 1. Friction elements
//! between the same links share in proportion to their capacities. A one-way or dog clutch counts with the
//! largest torque or capacity present. Since there are only a few, the corners of this linear programme are
//! tried all. Splits that have no element in common are found separately: otherwise the most used element of
//! one would leave the others open.

use crate::tolerance::{PIVOT, RANK, TORQUE};
use epicyclic_numerics::linear::{Matrix, Triangles};
use epicyclic_numerics::values::{dot, largest_absolute};

/// Torque of an element as `λ_0 + n·y`.
pub(crate) struct Share {
    pub(crate) base: f64,
    pub(crate) factors: Vec<f64>,
    /// Static capacity of the element; `None` for a one-way or dog clutch.
    pub(crate) capacity: Option<f64>,
    /// Least torque of a one-way clutch: that of drags between the same links, which hold against it.
    pub(crate) least: Option<f64>,
}

impl Share {
    fn at(&self, y: &[f64]) -> f64 {
        self.base + dot(&self.factors, y)
    }
}

/// `y` of the split; `None` where none keeps the one-way clutches from pushing.
pub(crate) fn even(shares: &[Share], count: usize) -> Option<Vec<f64>> {
    let most = largest_absolute(shares.iter().map(|share| share.base));
    let largest = shares.iter().filter_map(|share| share.capacity).fold(most, f64::max);
    let mut found = vec![0.0; count];
    if largest == 0.0 {
        return Some(found);
    }
    let is_of = |share: &Share, place: usize| share.factors[place].abs() > RANK;
    let mut left: Vec<usize> = (0..count).collect();
    while let Some(first) = left.pop() {
        let mut group = vec![first];
        while let Some(next) = left.iter().position(|&place| {
            shares.iter().any(|share| is_of(share, place) && group.iter().any(|&one| is_of(share, one)))
        }) {
            group.push(left.swap_remove(next));
        }
        group.sort_unstable();
        let with = shares.iter().filter(|share| group.iter().any(|&place| is_of(share, place)));
        let of_group = with.map(|share| Share {
            factors: group.iter().map(|&place| share.factors[place]).collect(),
            ..*share
        });
        let of_group: Vec<Share> = of_group.collect();
        let split = even_of_group(&of_group, group.len(), largest)?;
        group.iter().zip(split).for_each(|(&place, torque)| found[place] = torque);
    }
    Some(found)
}

/// Split among elements that are all joined by the splits.
fn even_of_group(shares: &[Share], count: usize, largest: f64) -> Option<Vec<f64>> {
    // A one-way or dog clutch counts as if it had the largest capacity; one of none as if it had next to
    // none.
    let scale = |share: &Share| share.capacity.unwrap_or(largest).max(TORQUE * largest);
    // Rows a·(y, τ) ≤ b.
    let mut rows: Vec<(Vec<f64>, f64)> = vec![];
    for share in shares {
        let by = scale(share);
        for sign in [1.0, -1.0] {
            let row = share.factors.iter().map(|factor| sign * factor / by).chain([-1.0]).collect();
            rows.push((row, -sign * share.base / by));
        }
        if let Some(least) = share.least {
            rows.push((
                share.factors.iter().map(|factor| -factor / by).chain([0.0]).collect(),
                (share.base - least) / by,
            ));
        }
    }
    let mut best: Option<(f64, Vec<f64>)> = None;
    let mut chosen: Vec<usize> = (0..=count).collect();
    while chosen.last().is_some_and(|&last| last < rows.len()) {
        let mut system = Matrix::zeros(count + 1, count + 1);
        for (place, &row) in chosen.iter().enumerate() {
            system.row_mut(place).copy_from_slice(&rows[row].0);
        }
        let right: Vec<f64> = chosen.iter().map(|&row| rows[row].1).collect();
        if let Some(corner) = Triangles::new(system, PIVOT).map(|triangles| triangles.solution(&right)) {
            let is_allowed =
                |(row, limit): &(Vec<f64>, f64)| dot(row, &corner) <= limit + TORQUE * (1.0 + limit.abs());
            let tau = corner[count];
            if rows.iter().all(is_allowed) && best.as_ref().is_none_or(|(least, _)| tau < *least) {
                best = Some((tau, corner));
            }
        }
        next(&mut chosen, rows.len());
    }
    best.map(|(_, mut corner)| {
        corner.truncate(count);
        corner
    })
}

/// The next choice of so many out of `total`, in order; the last place runs over at the end.
fn next(chosen: &mut [usize], total: usize) {
    let count = chosen.len();
    let movable = (0..count).rev().find(|&place| chosen[place] < total - count + place);
    match movable {
        Some(place) => {
            chosen[place] += 1;
            for after in place + 1..count {
                chosen[after] = chosen[after - 1] + 1;
            }
        }
        None => {
            if let Some(last) = chosen.last_mut() {
                *last = total;
            }
        }
    }
}

/// Torques of all elements at the split.
pub(crate) fn torques(shares: &[Share], y: &[f64]) -> Vec<f64> {
    shares.iter().map(|share| share.at(y)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn share(base: f64, factors: &[f64], capacity: Option<f64>) -> Share {
        Share { base, factors: factors.to_vec(), capacity, least: capacity.is_none().then_some(0.0) }
    }

    #[test]
    fn two_brakes_of_one_link_share_as_their_capacities() {
        let shares = [share(100.0, &[-1.0], Some(100.0)), share(0.0, &[1.0], Some(1.0))];
        let found = torques(&shares, &even(&shares, 1).unwrap());
        assert!((found[0] - 1e4 / 101.0).abs() < 1e-9 && (found[1] - 100.0 / 101.0).abs() < 1e-9);
    }

    /// A brake that carries what it cannot leaves the split of the others as it is.
    #[test]
    fn splits_without_a_common_element_are_apart() {
        let shares = [
            share(50.0, &[0.0, 0.0], Some(0.0)),
            share(12.0, &[-1.0, 1e-17], Some(30.0)),
            share(20.0, &[0.0, -1.0], Some(10.0)),
            share(0.0, &[1.0, 0.0], Some(10.0)),
            share(0.0, &[0.0, 1.0], Some(30.0)),
        ];
        let found = torques(&shares, &even(&shares, 2).unwrap());
        let due = [50.0, 9.0, 5.0, 3.0, 15.0];
        assert!(found.iter().zip(due).all(|(one, due)| (one - due).abs() < 1e-9), "{found:?}");
    }

    #[test]
    fn a_one_way_clutch_never_pushes() {
        // The brake would have to give −5 to the one-way clutch for an even split.
        let shares = [share(5.0, &[1.0], Some(10.0)), share(0.0, &[1.0], None)];
        let found = torques(&shares, &even(&shares, 1).unwrap());
        assert!((found[0] - 5.0).abs() < 1e-9 && found[1].abs() < 1e-9, "{found:?}");
    }

    #[test]
    fn three_elements_with_two_open_splits() {
        let shares = [
            share(90.0, &[-1.0, -1.0], Some(30.0)),
            share(0.0, &[1.0, 0.0], Some(60.0)),
            share(0.0, &[0.0, 1.0], Some(10.0)),
        ];
        let found = torques(&shares, &even(&shares, 2).unwrap());
        let due = [27.0, 54.0, 9.0];
        assert!(found.iter().zip(due).all(|(one, due)| (one - due).abs() < 1e-9), "{found:?}");
    }
}

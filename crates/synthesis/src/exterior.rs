//! Products of vectors that change sign when two factors change places, for determinants grown row by row.
//!
//! A product of `m` vectors of a space of `F` dimensions has a coordinate for each `m` of the `F` axes: the
//! minor of the rows there. Coordinates are in the order of the axes' bits.

use crate::ternary::{Ternary, Word};

/// Rules for the products of a space.
#[derive(Debug, Clone)]
pub struct Space {
    /// Axes of each coordinate as bits, by degree.
    axes: Vec<Vec<u32>>,
    /// Growth of each coordinate, by degree from 1: coordinate of the degree below, axis, and whether the
    /// sign changes.
    growth: Vec<Vec<Vec<(usize, usize, bool)>>>,
    /// Pairs of axes, each with the coordinate of degree `F − 2` with the other axes, and whether the sign
    /// changes.
    pairs: Vec<(usize, usize, usize, bool)>,
}

impl Space {
    /// Space of this number of dimensions, at least 2.
    #[must_use]
    pub fn new(dimensions: usize) -> Self {
        let axes: Vec<Vec<u32>> = (0..=dimensions)
            .map(|degree| {
                (0..1u32 << dimensions).filter(|axes| axes.count_ones() as usize == degree).collect()
            })
            .collect();
        let place = |wanted: u32| axes[wanted.count_ones() as usize].iter().position(|axes| *axes == wanted);
        let growth = (1..=dimensions)
            .map(|degree| {
                axes[degree]
                    .iter()
                    .map(|all| {
                        (0..dimensions)
                            .filter(|axis| all >> axis & 1 == 1)
                            .filter_map(|axis| {
                                // The new row is the last; it moves before the rows of higher axes.
                                let higher = (all >> (axis + 1)).count_ones();
                                Some((place(all & !(1 << axis))?, axis, higher % 2 == 1))
                            })
                            .collect()
                    })
                    .collect()
            })
            .collect();
        let whole = (1u32 << dimensions) - 1;
        let mut pairs = Vec::new();
        for first in 0..dimensions {
            for second in first + 1..dimensions {
                let others = whole & !(1 << first) & !(1 << second);
                // The pair stands last: it passes every other axis that is higher.
                let passed = (others >> (first + 1)).count_ones() + (others >> (second + 1)).count_ones();
                if let Some(place) = place(others) {
                    pairs.push((place, first, second, passed % 2 == 1));
                }
            }
        }
        Self { axes, growth, pairs }
    }

    /// Number of coordinates of a product of this number of vectors.
    #[must_use]
    pub fn coordinates(&self, degree: usize) -> usize {
        self.axes[degree].len()
    }

    /// The pairs of axes of a product of two vectors, each with the coordinate of a product of `F − 2`
    /// vectors that it completes and whether the sign changes.
    pub(crate) fn pairs(&self) -> &[(usize, usize, usize, bool)] {
        &self.pairs
    }

    /// Writes the product of `product`, of degree `degree − 1`, with `vector` into `result`.
    pub(crate) fn multiply<W: Word>(
        &self,
        degree: usize,
        product: &[Ternary<W>],
        vector: &[Ternary<W>],
        result: &mut [Ternary<W>],
    ) {
        for (coordinate, terms) in result.iter_mut().zip(&self.growth[degree - 1]) {
            *coordinate = Ternary::default();
            for (place, axis, change) in terms {
                let term = product[*place].times(vector[*axis]);
                *coordinate = if *change { coordinate.difference(term) } else { coordinate.sum(term) };
            }
        }
    }

    /// The product of two vectors at a pair of axes.
    pub(crate) fn minor<W: Word>(
        one: &[Ternary<W>],
        other: &[Ternary<W>],
        first: usize,
        second: usize,
    ) -> Ternary<W> {
        one[first].times(other[second]).difference(one[second].times(other[first]))
    }
}

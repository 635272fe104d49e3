//! Exchanges of ring-to-sun ratios that have the same range.

use crate::parts::{Grid, Parts};
use crate::ratio::{Polynomial, Ratio};
use crate::structure::for_each_order;

/// The most sets whose permutations are all tried: of more there are too many to try for each function.
const MOST_SETS: usize = 4;

/// An exchange of the `k`.
#[derive(Debug, Clone)]
pub(crate) struct Exchange {
    /// Image of each product of `k`.
    products: Vec<usize>,
    is_identity: bool,
}

/// An exchange of the `k`, and of the parts of their range with them.
#[derive(Debug, Clone)]
pub(crate) struct Permutation {
    exchange: Exchange,
    /// Previous place of each part of the range.
    before: Vec<usize>,
}

/// Exchanges that keep the ranges, the identity first.
pub(crate) fn permutations(grid: &Grid) -> Vec<Permutation> {
    let whole = grid.whole();
    let sets = whole.len();
    let mut found = vec![Permutation::new(&(0..sets).collect::<Vec<_>>(), grid)];
    if sets <= MOST_SETS {
        for_each_order(sets, &mut |order| {
            let keeps = order.iter().enumerate().all(|(place, set)| whole[place] == whole[*set]);
            if keeps && !order.is_sorted() {
                found.push(Permutation::new(order, grid));
            }
        });
    }
    found
}

impl Exchange {
    /// Exchange in which `k_j` becomes `k_order[j]`.
    pub(crate) fn new(order: &[usize]) -> Self {
        let product = |product: usize| {
            let sets = order.iter().enumerate().filter(|(set, _)| product >> set & 1 == 1);
            sets.fold(0, |image, (_, to)| image | 1 << to)
        };
        Self { products: (0..1 << order.len()).map(product).collect(), is_identity: order.is_sorted() }
    }

    /// A polynomial after the exchange.
    fn polynomial(&self, polynomial: Polynomial) -> Polynomial {
        let moved = |word: u64| {
            let (mut left, mut image) = (word, 0);
            while left != 0 {
                image |= 1 << self.products[left.trailing_zeros() as usize];
                left &= left - 1;
            }
            image
        };
        Polynomial { plus: moved(polynomial.plus), minus: moved(polynomial.minus) }
    }

    /// A ratio after the exchange.
    pub(crate) fn ratio(&self, ratio: Ratio) -> Ratio {
        if self.is_identity {
            return ratio;
        }
        let (numerator, denominator) = (self.polynomial(ratio.numerator), self.polynomial(ratio.denominator));
        let all = denominator.plus | denominator.minus;
        if denominator.minus & all & all.wrapping_neg() == 0 {
            Ratio { numerator, denominator }
        } else {
            // The first coefficient of the denominator is 1.
            Ratio { numerator: numerator.negated(), denominator: denominator.negated() }
        }
    }
}

impl Permutation {
    /// Permutation in which `k_j` becomes `k_order[j]`.
    fn new(order: &[usize], grid: &Grid) -> Self {
        let strides = grid.strides();
        let part = |part: usize| -> usize {
            let cut = |set: usize| part / strides[set].0 % strides[set].1;
            order.iter().enumerate().map(|(set, to)| cut(set) * strides[*to].0).sum()
        };
        let mut before = vec![0; grid.count()];
        for from in 0..grid.count() {
            before[part(from)] = from;
        }
        Self { exchange: Exchange::new(order), before }
    }

    /// A ratio after the exchange.
    pub(crate) fn ratio(&self, ratio: Ratio) -> Ratio {
        self.exchange.ratio(ratio)
    }

    /// The parts that become these.
    pub(crate) fn parts_before(&self, after: Parts) -> Parts {
        if self.exchange.is_identity { after } else { after.iter().map(|part| self.before[part]).collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parts::Bounds;
    use crate::ternary::Ternary;

    #[test]
    fn parts_move_with_the_ratio() {
        let gears = [Bounds { least: 1.9, most: 2.1 }, Bounds { least: -0.8, most: -0.7 }];
        // (1 + k₁ + k₁·k₂)/(k₃ − k₁), and (k₂ + k₃·k₄)/(1 − k₁).
        let ratios = [(0b1011, 0, 0b1_0000, 0b10), (0b1_0000_0000_0100, 0, 1, 0b10)].map(
            |(plus, minus, below, below_minus)| {
                Ratio::new(Ternary { plus, minus }, Ternary { plus: below, minus: below_minus }).unwrap()
            },
        );
        let same = Grid::new(&[1.4..=4.5, 1.4..=4.5, 1.4..=4.5, 1.4..=4.5]);
        let mixed = Grid::new(&[1.4..=4.5, 1.5..=4.0, 1.4..=4.5, 1.5..=4.0]);
        for (grid, count) in [(same, 24), (mixed, 4)] {
            let all = permutations(&grid);
            assert_eq!(all.len(), count);
            for permutation in &all {
                for ratio in ratios {
                    let after = grid.reach(permutation.ratio(ratio), &gears);
                    let before: Vec<Parts> =
                        after.iter().map(|parts| permutation.parts_before(*parts)).collect();
                    assert_eq!(before, grid.reach(ratio, &gears));
                    let again = permutation.ratio(ratio);
                    assert_eq!(Ratio::new(again.numerator, again.denominator), Some(again));
                }
            }
        }
    }
}

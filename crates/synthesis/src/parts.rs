//! Division of the range of the ring-to-sun ratios into parts, and the parts that hold a wanted ratio.
//!
//! The range of each `k` is cut into equal ratios, at most 256 parts altogether. A set of parts is four
//! words.
//!
//! # Why nothing is lost
//! `P − g·Q` is of the first degree in each `k`, so its extremes over a part are at its corners. Suppose
//! `P − g·Q` has the same sign at all corners for the lower and the upper bound `g` of a gear. The ratio
//! `P/Q` is then outside these bounds in the whole part, even if `Q` changes its sign:
//! `(P − g₁·Q)·(P − g₂·Q) > 0`. If `Q` keeps its sign, this means that the extremes of `P/Q` are at corners.

use crate::ratio::{Polynomial, Ratio};
use crate::tolerance::WIDENING;
use std::ops::RangeInclusive;

/// A set of parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Parts([u64; 4]);

impl Parts {
    /// Every part there may be.
    pub(crate) const ALL: Self = Self([u64::MAX; 4]);

    /// The parts of both.
    #[inline]
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self(std::array::from_fn(|word| self.0[word] & other.0[word]))
    }

    /// The parts of either.
    #[inline]
    #[must_use]
    pub fn or(self, other: Self) -> Self {
        Self(std::array::from_fn(|word| self.0[word] | other.0[word]))
    }

    /// The parts of one of both alone.
    #[inline]
    #[must_use]
    pub fn xor(self, other: Self) -> Self {
        Self(std::array::from_fn(|word| self.0[word] ^ other.0[word]))
    }

    /// The parts that the other has not.
    #[inline]
    #[must_use]
    pub fn without(self, other: Self) -> Self {
        Self(std::array::from_fn(|word| self.0[word] & !other.0[word]))
    }

    /// Whether a part is among them.
    #[inline]
    #[must_use]
    pub fn contains(self, part: usize) -> bool {
        self.0[part / 64] >> (part % 64) & 1 == 1
    }

    /// Whether the set is empty.
    #[inline]
    #[must_use]
    pub fn is_empty(self) -> bool {
        self.0 == [0; 4]
    }

    /// Number of parts in the set.
    #[must_use]
    pub fn count(self) -> u32 {
        self.0.iter().map(|word| word.count_ones()).sum()
    }

    /// The numbers of the parts.
    pub fn iter(self) -> impl Iterator<Item = usize> {
        self.0.into_iter().enumerate().flat_map(|(place, word)| places(word).map(move |bit| 64 * place + bit))
    }

    fn insert(&mut self, part: usize) {
        self.0[part / 64] |= 1 << (part % 64);
    }

    /// Set of the first `count` parts.
    #[must_use]
    pub fn first(count: usize) -> Self {
        (0..count).collect()
    }
}

/// The places of the bits of a word.
pub(crate) fn places(word: u64) -> impl Iterator<Item = usize> {
    let mut left = word;
    std::iter::from_fn(move || {
        let place = left.trailing_zeros() as usize;
        (left != 0).then(|| {
            left &= left - 1;
            place
        })
    })
}

impl FromIterator<usize> for Parts {
    fn from_iter<I: IntoIterator<Item = usize>>(numbers: I) -> Self {
        let mut parts = Self::default();
        numbers.into_iter().for_each(|part| parts.insert(part));
        parts
    }
}

/// The bounds of a gear's ratio, of one sign.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// The lower.
    pub least: f64,
    /// The upper.
    pub most: f64,
}

impl Bounds {
    /// Widened by a part of 10⁹.
    pub(crate) fn widened(self) -> Self {
        self.widened_by(WIDENING)
    }

    /// Widened by a part of each.
    pub(crate) fn widened_by(self, part: f64) -> Self {
        Self { least: self.least - part * self.least.abs(), most: self.most + part * self.most.abs() }
    }

    /// Whether a box may hold a point with a ratio within the bounds, by the values of its `P` and `Q` at the
    /// corners.
    #[inline]
    pub(crate) fn is_reached(self, above: &[f64], below: &[f64]) -> bool {
        let (mut larger, mut smaller) = (true, true);
        for (above, below) in above.iter().zip(below) {
            let (least, most) = (above - self.least * below, above - self.most * below);
            larger &= least > 0.0 && most > 0.0;
            smaller &= least < 0.0 && most < 0.0;
        }
        !larger && !smaller
    }

    /// Deviation of a ratio from the middle, over half the width; without width infinite or not a number.
    pub(crate) fn deviation(self, ratio: f64) -> f64 {
        (ratio - 0.5 * (self.most + self.least)) / (0.5 * (self.most - self.least))
    }

    /// Whether a ratio is within.
    #[must_use]
    pub fn contain(self, ratio: f64) -> bool {
        (self.least..=self.most).contains(&ratio)
    }
}

/// A box of ring-to-sun ratios: lower and upper bound of each.
pub type Cuboid = Vec<[f64; 2]>;

/// The parts of a range.
#[derive(Debug, Clone)]
pub struct Grid {
    /// The bounds of the parts of each `k`.
    edges: Vec<Vec<f64>>,
    /// Place of the lowest corner of each part among all corners.
    lowest: Vec<usize>,
}

impl Grid {
    /// The parts of these ranges.
    #[must_use]
    pub fn new(ranges: &[RangeInclusive<f64>]) -> Self {
        let cuts = [1, 64, 16, 6, 4, 3, 2][ranges.len()];
        let edges = ranges
            .iter()
            .map(|range| {
                let (least, most) = (*range.start(), *range.end());
                (0..=cuts)
                    .map(|cut| {
                        if cut == cuts {
                            most
                        } else {
                            least * libm::pow(most / least, f64::from(cut) / f64::from(cuts))
                        }
                    })
                    .collect()
            })
            .collect();
        let mut grid = Self { edges, lowest: Vec::new() };
        grid.lowest = (0..grid.count()).map(|part| grid.lowest_corner(part)).collect();
        grid
    }

    fn lowest_corner(&self, mut part: usize) -> usize {
        let (mut place, mut stride) = (0, 1);
        for edges in &self.edges {
            place += part % (edges.len() - 1) * stride;
            part /= edges.len() - 1;
            stride *= edges.len();
        }
        place
    }

    /// Number of parts.
    #[must_use]
    pub fn count(&self) -> usize {
        self.edges.iter().map(|edges| edges.len() - 1).product()
    }

    /// Stride of each `k`, by which the number of a part grows, and the number of its parts.
    pub(crate) fn strides(&self) -> Vec<(usize, usize)> {
        let mut stride = 1;
        let of = |edges: &Vec<f64>| {
            let cuts = edges.len() - 1;
            stride *= cuts;
            (stride / cuts, cuts)
        };
        self.edges.iter().map(of).collect()
    }

    /// The part of this number; the first `k` changes fastest.
    #[must_use]
    pub fn part(&self, mut number: usize) -> Cuboid {
        let mut bounds = Cuboid::new();
        for edges in &self.edges {
            let cuts = edges.len() - 1;
            let cut = number % cuts;
            bounds.push([edges[cut], edges[cut + 1]]);
            number /= cuts;
        }
        bounds
    }

    /// The whole range.
    #[must_use]
    pub fn whole(&self) -> Cuboid {
        self.edges.iter().map(|edges| [edges[0], edges[edges.len() - 1]]).collect()
    }

    /// Values of a polynomial at all corners of the parts.
    fn corners(&self, polynomial: Polynomial) -> Vec<f64> {
        let sets = self.edges.len();
        let mut values: Vec<f64> =
            (0..1 << sets).map(|product| f64::from(polynomial.coefficient(product))).collect();
        // The last `k` first: its coefficients are the upper half.
        let mut upper = 1;
        for edges in self.edges.iter().rev() {
            let lower = values.len() / upper / 2;
            let mut next = vec![0.0; lower * edges.len() * upper];
            // For each of the `upper` corners already made: the coefficients without this `k`, then those
            // with it.
            for (corner, halves) in values.chunks_exact(2 * lower).enumerate() {
                let (constant, slope) = halves.split_at(lower);
                for (cut, k) in edges.iter().enumerate() {
                    let place = (corner * edges.len() + cut) * lower;
                    for ((value, constant), slope) in
                        next[place..place + lower].iter_mut().zip(constant).zip(slope)
                    {
                        *value = constant + slope * k;
                    }
                }
            }
            upper *= edges.len();
            values = next;
        }
        values
    }

    /// Parts in which the ratio may be within the bounds of each gear.
    #[must_use]
    pub fn reach(&self, ratio: Ratio, gears: &[Bounds]) -> Vec<Parts> {
        let sets = self.edges.len();
        let polynomials = [ratio.numerator, ratio.denominator];
        let mut ends = [Vec::new(), Vec::new()];
        for (values, polynomial) in ends.iter_mut().zip(polynomials) {
            corner_values(&coefficients(polynomial, sets), &self.whole(), values);
        }
        let gears: Vec<Bounds> = gears.iter().map(|gear| gear.widened()).collect();
        if !gears.iter().any(|gear| gear.is_reached(&ends[0], &ends[1])) {
            return vec![Parts::default(); gears.len()];
        }
        let [above, below] = polynomials.map(|polynomial| self.corners(polynomial));
        let mut least: Vec<f64> = above.iter().zip(&below).map(|(above, below)| above / below).collect();
        let mut most = least.clone();
        let mut signs: Vec<u8> =
            below.iter().map(|below| u8::from(*below > 0.0) | u8::from(*below < 0.0) << 1).collect();
        self.join(&mut least, |one, other| if one < other { one } else { other });
        self.join(&mut most, |one, other| if one > other { one } else { other });
        self.join(&mut signs, |one, other| one & other);
        let mut reach = vec![Parts::default(); gears.len()];
        for (part, corner) in self.lowest.iter().enumerate() {
            if signs[*corner] == 0 {
                // The output is at rest somewhere in the part, so the ratio has no extremes at the corners.
                for (values, polynomial) in ends.iter_mut().zip(polynomials) {
                    corner_values(&coefficients(polynomial, sets), &self.part(part), values);
                }
                for (reach, gear) in reach.iter_mut().zip(&gears) {
                    if gear.is_reached(&ends[0], &ends[1]) {
                        reach.insert(part);
                    }
                }
            } else {
                let (least, most) = (least[*corner], most[*corner]);
                for (reach, gear) in reach.iter_mut().zip(&gears) {
                    if least <= gear.most && gear.least <= most {
                        reach.insert(part);
                    }
                }
            }
        }
        reach
    }

    /// Joins the values of all corners of a part at its lowest.
    fn join<T: Copy>(&self, values: &mut [T], join: impl Fn(T, T) -> T) {
        let mut stride = 1;
        for edges in &self.edges {
            for place in 0..values.len().saturating_sub(stride) {
                values[place] = join(values[place], values[place + stride]);
            }
            stride *= edges.len();
        }
    }
}

/// Values of a polynomial, given by its coefficients, at the corners of a box; bit `j` of a corner is the
/// upper bound of `k_j`.
pub(crate) fn corner_values(coefficients: &[f64], cuboid: &[[f64; 2]], values: &mut Vec<f64>) {
    values.clear();
    values.extend_from_slice(coefficients);
    // With a number of corners that is known beforehand the loops need no counters.
    if let (Ok(values), [one, two, three, four]) = (<&mut [f64; 16]>::try_from(values.as_mut_slice()), cuboid)
    {
        bounds_of::<1>(values, one);
        bounds_of::<2>(values, two);
        bounds_of::<4>(values, three);
        bounds_of::<8>(values, four);
        return;
    }
    for (set, [least, most]) in cuboid.iter().enumerate() {
        for block in values.chunks_exact_mut(2 << set) {
            at_bounds(block, 1 << set, *least, *most);
        }
    }
}

/// Puts the bounds of one of four `k` in its place.
#[inline]
fn bounds_of<const STEP: usize>(values: &mut [f64; 16], [least, most]: &[f64; 2]) {
    for block in values.chunks_exact_mut(2 * STEP) {
        at_bounds(block, STEP, *least, *most);
    }
}

#[inline]
fn at_bounds(block: &mut [f64], step: usize, least: f64, most: f64) {
    let (constant, slope) = block.split_at_mut(step);
    for (constant, slope) in constant.iter_mut().zip(slope) {
        (*constant, *slope) = (*constant + *slope * least, *constant + *slope * most);
    }
}

/// Coefficients of a polynomial in this number of `k`.
pub(crate) fn coefficients(polynomial: Polynomial, sets: usize) -> Vec<f64> {
    (0..1 << sets).map(|product| f64::from(polynomial.coefficient(product))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ternary::Ternary;

    fn ratio(plus: u64, minus: u64, below_plus: u64, below_minus: u64) -> Ratio {
        Ratio::new(Ternary { plus, minus }, Ternary { plus: below_plus, minus: below_minus }).unwrap()
    }

    #[test]
    fn a_part_out_of_reach_holds_no_point_within_the_bounds() {
        // (1 + k₁ + k₁·k₂)/(k₂ − k₁): its denominator changes sign in the range.
        let ratio = ratio(0b1011, 0, 0b0100, 0b0010);
        let grid = Grid::new(&[1.4..=4.5, 1.4..=4.5]);
        let gears = [
            Bounds { least: 4.9, most: 5.1 },
            Bounds { least: -7.1, most: -6.9 },
            Bounds { least: 0.2, most: 0.3 },
        ];
        let reach = grid.reach(ratio, &gears);
        assert!(reach[2].is_empty(), "the ratio is never that small");
        for number in 0..grid.count() {
            let part = grid.part(number);
            for step in 0..400 {
                let k = [0, 1].map(|set| {
                    let place = if set == 0 { step % 20 } else { step / 20 };
                    part[set][0] + (part[set][1] - part[set][0]) * f64::from(place) / 19.0
                });
                for (gear, reach) in gears.iter().zip(&reach) {
                    let within = reach.and(Parts::first(number + 1)).iter().any(|part| part == number);
                    assert!(
                        within || !gear.contain(ratio.value(&k)),
                        "part {number}, {k:?}: {}",
                        ratio.value(&k)
                    );
                }
            }
        }
        assert!(reach[0].count() > 0 && reach[0].count() < 256);
    }

    #[test]
    fn corners_are_values_at_the_bounds() {
        let polynomial = ratio(0b1011, 0, 0b0100, 0b0010).numerator;
        let cuboid = [[1.5, 2.0], [3.0, 4.0]];
        let mut values = Vec::new();
        corner_values(&coefficients(polynomial, 2), &cuboid, &mut values);
        for (corner, value) in values.iter().enumerate() {
            let k = [cuboid[0][corner & 1], cuboid[1][corner >> 1]];
            assert!((value - polynomial.value(&k)).abs() < 1e-12);
        }
    }
}

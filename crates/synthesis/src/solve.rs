//! Solver that decides whether a set of elements has all wanted gears at common ring-to-sun ratios.
//!
//! # Method
//! The state is a box of `k` and the functions that its elements can engage. A function gives a gear only if
//! the box reaches the gear's bounds ([`parts`](crate::parts)). If a gear has one function left, the box
//! shrinks to what this function allows. Each inequality `P − g·Q ≥ 0` is of the first degree in each `k`, so
//! along an edge of the box it begins or ends at one point. The hull of these points over all parallel edges
//! holds every solution. If several functions are left, each is tried. When all gears have theirs, a point is
//! searched for from the middle of the box; if none is found, the box is halved.
//!
//! If some `k` have to be equal, boxes have one range for them, and polynomials their [polar
//! forms](crate::equal). If gears with overlapping bounds have to fall, a box is given up in which the
//! highest ratio of the one is not above the lowest of the next.
//!
//! # Complete
//! A box is given up when it provably has no solution. A box that shrinks below 10⁻⁷ of its `k` with neither
//! a solution nor a proof is *undecided*, and counted.
//!
//! Bounds of round numbers may leave one common point, or a line of points, at which several gears are at
//! their bounds: `k₂·k₃` up to 3.78 with `k₂ ≥ 2.7` and `k₃ ≥ 1.4`. No rounded point keeps such bounds to the
//! last digit, so a point may exceed them by 10⁻⁸ of them. Otherwise all of the line would be halved to the
//! smallest boxes.

use crate::class::MOST_SETS;
use crate::equal::Equal;
use crate::parts::{Bounds, coefficients, corner_values};
use crate::ratio::Ratio;
use crate::tolerance::{ACCEPTED, DAMPING, SMALLEST, WIDENING};
use crate::watch::Watch;
use epicyclic_numerics::linear::{Matrix, solution};

/// The relative width below which functions are tried one by one. In wider boxes most gears reach several
/// functions, and their combinations are more than the boxes: with 0.1 a search for ten gears took a tenth of
/// the time that it took with no bound, with 0.005 thirty times as long as with 0.1.
const NARROW: f64 = 0.1;

/// The most Gauss-Newton steps towards a point, of each kind.
const STEPS: usize = 6;

/// The greatest deviation, by half the width of the bounds, from which steps towards the bounds are taken.
const NEAR_BOUNDS: f64 = 1.1;

/// Largest remaining part of the sum of a box's logarithmic widths for which shrinking is repeated.
const WORTH_MORE: f64 = 0.8;

/// A function that some of the elements engage.
#[derive(Debug, Clone)]
pub struct Function {
    /// Formula of the ratio.
    pub ratio: Ratio,
    /// Coefficients of `P` and `Q`.
    pub(crate) coefficients: [Vec<f64>; 2],
}

impl Function {
    /// Function with its coefficients for this number of sets.
    #[must_use]
    pub fn new(ratio: Ratio, sets: usize) -> Self {
        Self::with_equal(ratio, sets, Equal::NONE)
    }

    /// Function with the coefficients of the polar forms, for sets with equal `k`.
    #[must_use]
    pub fn with_equal(ratio: Ratio, sets: usize, equal: Equal) -> Self {
        let polar = |polynomial| {
            let mut coefficients = coefficients(polynomial, sets);
            equal.polar(&mut coefficients);
            coefficients
        };
        Self { ratio, coefficients: [ratio.numerator, ratio.denominator].map(polar) }
    }
}

/// Result of a search in a box.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// A point with all gears.
    Found {
        /// The ring-to-sun ratios.
        k: Vec<f64>,
        /// Function of each gear.
        functions: Vec<usize>,
    },
    /// Proof that no point exists.
    None,
    /// No point was found, and some boxes were too small to go on.
    Undecided,
}

/// A search over boxes for functions and gears.
pub struct Solver<'a> {
    functions: &'a [&'a Function],
    gears: Vec<Bounds>,
    /// The bounds widened by rounding.
    widened: Vec<Bounds>,
    /// The bounds for a point that is found.
    accepted: Vec<Bounds>,
    /// Test whether functions together are an answer.
    accept: &'a mut dyn FnMut(&[usize]) -> bool,
    /// Sets with equal `k`: their ranges stay one.
    equal: Equal,
    /// Pairs of gears, the first with the higher ratio.
    falling: &'a [[usize; 2]],
    /// Whether the search is to end.
    watch: Option<&'a Watch<'a>>,
    values: [Vec<f64>; 2],
    sets: usize,
    undecided: bool,
    /// Lists of functions, and of the gears that they reach, used again.
    room: Vec<Left>,
    masks: Vec<u32>,
}

/// Functions that a box leaves, each with the gears that it may have, as bits.
type Left = Vec<(usize, u32)>;

/// A box with room for the most sets.
type Range = [[f64; 2]; MOST_SETS];

impl<'a> Solver<'a> {
    /// A search for a point where each gear is within its bounds by a function of its own, and `accept` takes
    /// the functions.
    pub fn new(
        functions: &'a [&'a Function],
        gears: &[Bounds],
        accept: &'a mut dyn FnMut(&[usize]) -> bool,
    ) -> Self {
        let widened = gears.iter().map(|gear| gear.widened()).collect();
        Self {
            functions,
            gears: gears.to_vec(),
            widened,
            accepted: gears.iter().map(|gear| gear.widened_by(ACCEPTED)).collect(),
            accept,
            equal: Equal::NONE,
            falling: &[],
            watch: None,
            values: [Vec::new(), Vec::new()],
            sets: 0,
            undecided: false,
            room: Vec::new(),
            masks: Vec::new(),
        }
    }

    /// Returns the solver for points with some equal `k`. The functions must be [made with
    /// them](Function::with_equal), and boxes must have one range for them.
    #[must_use]
    pub const fn with_equal(mut self, equal: Equal) -> Self {
        self.equal = equal;
        self
    }

    /// Returns the solver for points at which the first gear of each pair has the higher ratio.
    #[must_use]
    pub(crate) const fn with_falling(mut self, falling: &'a [[usize; 2]]) -> Self {
        self.falling = falling;
        self
    }

    /// Returns the solver with a watch: if the watch ends it, the box counts as undecided.
    #[must_use]
    pub(crate) const fn with_watch(mut self, watch: &'a Watch<'a>) -> Self {
        self.watch = Some(watch);
        self
    }

    /// Searches a box.
    pub fn search(&mut self, cuboid: &[[f64; 2]]) -> Outcome {
        let every = (1u32 << self.gears.len()) - 1;
        self.start(cuboid, std::iter::repeat_n(every, self.functions.len()), false)
    }

    /// Searches a box in which the functions can reach these gears alone, as bits.
    pub(crate) fn search_among(&mut self, cuboid: &[[f64; 2]], gears: impl Iterator<Item = u32>) -> Outcome {
        self.start(cuboid, gears, true)
    }

    fn start(&mut self, cuboid: &[[f64; 2]], gears: impl Iterator<Item = u32>, known: bool) -> Outcome {
        self.undecided = false;
        self.sets = cuboid.len();
        let mut range = [[1.0; 2]; MOST_SETS];
        range[..self.sets].copy_from_slice(cuboid);
        let mut left = self.room.pop().unwrap_or_default();
        left.clear();
        left.extend(gears.enumerate().filter(|(_, gears)| *gears != 0));
        let found = self.settle(&mut left).and_then(|()| self.go(range, &mut left, known));
        self.room.push(left);
        match found {
            Some((k, functions)) => Outcome::Found { k, functions },
            None if self.undecided => Outcome::Undecided,
            None => Outcome::None,
        }
    }

    /// Searches a box; `known` where the gears of its functions are those that they reach in it.
    fn go(&mut self, mut range: Range, left: &mut Left, mut known: bool) -> Option<(Vec<f64>, Vec<usize>)> {
        let sets = self.sets;
        loop {
            if self.watch.is_some_and(Watch::is_over) {
                self.undecided = true;
                return None;
            }
            let cuboid = &mut range[..sets];
            if !known {
                self.reduce(cuboid, left)?;
            }
            known = false;
            let before = spread(cuboid);
            for (function, gears) in left.iter() {
                if gears.count_ones() == 1 && left.iter().filter(|(_, other)| other & gears != 0).count() == 1
                {
                    self.shrink(cuboid, *function, gears.trailing_zeros() as usize)?;
                }
            }
            let after = spread(cuboid);
            if after < before && libm::log(after) < WORTH_MORE * libm::log(before) {
                continue;
            }
            let (widest, width) = widest(cuboid)?;
            let open = self.most_settled(left);
            if let Some(gear) = open.filter(|_| width < NARROW) {
                let mut chosen = self.room.pop().unwrap_or_default();
                let having = left.iter().filter(|(_, gears)| gears >> gear & 1 == 1);
                let found = having.clone().find_map(|(function, _)| {
                    chosen.clear();
                    chosen.extend(left.iter().map(|(other, gears)| {
                        (*other, if other == function { 1 << gear } else { gears & !(1 << gear) })
                    }));
                    self.go(range, &mut chosen, false)
                });
                self.room.push(chosen);
                return found;
            }
            if open.is_none() {
                let functions: Vec<usize> = (0..self.gears.len())
                    .filter_map(|gear| left.iter().find(|(_, gears)| gears >> gear & 1 == 1))
                    .map(|(function, _)| *function)
                    .collect();
                if !self.may_fall(cuboid, &functions) || !(self.accept)(&functions) {
                    return None;
                }
                if let Some(k) = self.point(cuboid, &functions) {
                    return Some((k, functions));
                }
                if width < SMALLEST {
                    self.undecided = true;
                    return None;
                }
            }
            let [least, most] = range[widest];
            let middle = (least * most).sqrt();
            let mut lower = range;
            self.equal.put(&mut lower, widest, [least, middle]);
            let mut of_lower = self.room.pop().unwrap_or_default();
            of_lower.clone_from(left);
            let found = self.go(lower, &mut of_lower, false);
            self.room.push(of_lower);
            if found.is_some() {
                return found;
            }
            self.equal.put(&mut range, widest, [middle, most]);
        }
    }

    /// Gear with the fewest functions among those with several.
    fn most_settled(&self, left: &[(usize, u32)]) -> Option<usize> {
        let counts =
            (0..self.gears.len()).map(|gear| left.iter().filter(|(_, gears)| gears >> gear & 1 == 1).count());
        counts
            .enumerate()
            .filter(|(_, count)| *count > 1)
            .min_by_key(|(_, count)| *count)
            .map(|(gear, _)| gear)
    }

    /// Takes from functions the gears that they do not reach in a box; `None` if the gears cannot each have
    /// their own.
    fn reduce(&mut self, cuboid: &[[f64; 2]], left: &mut Left) -> Option<()> {
        let gears = self.gears.len();
        // Gears that one function reaches, at most.
        let (mut once, mut twice) = (0u32, 0u32);
        for (_, mask) in left.iter() {
            twice |= once & mask;
            once |= mask;
        }
        // A function that a gear has alone ends the box if it does not reach it, so these come first.
        for alone in [true, false] {
            for (function, mask) in left.iter_mut().filter(|(_, mask)| (mask & !twice != 0) == alone) {
                let reached = self.reached(cuboid, *function, *mask);
                if (*mask & !reached) & !twice != 0 {
                    return None;
                }
                *mask = reached;
            }
        }
        left.retain(|(_, mask)| *mask != 0);
        if left.len() < gears {
            return None;
        }
        self.settle(left)
    }

    /// Takes from functions the gears that are another's alone; `None` if the gears cannot each have their
    /// own.
    fn settle(&mut self, left: &mut Left) -> Option<()> {
        let gears = self.gears.len();
        // Gears of one function, and of several.
        let mut settled = 0u32;
        loop {
            let (mut once, mut twice) = (0u32, 0u32);
            for (_, mask) in left.iter() {
                twice |= once & mask;
                once |= mask;
            }
            if once.count_ones() as usize != gears {
                return None;
            }
            let alone = once & !twice & !settled;
            if alone == 0 {
                break;
            }
            settled |= alone;
            for (_, mask) in left.iter_mut().filter(|(_, mask)| mask & alone != 0) {
                // A function with two gears of its own alone has too many.
                let own = *mask & alone;
                if own.count_ones() > 1 {
                    return None;
                }
                *mask = own;
            }
        }
        self.masks.clear();
        self.masks.extend(left.iter().map(|(_, mask)| *mask));
        can_match(&self.masks, gears).then_some(())
    }

    /// Gears, among the given ones, whose bounds a function may reach in a box.
    fn reached(&mut self, cuboid: &[[f64; 2]], function: usize, gears: u32) -> u32 {
        self.evaluate(cuboid, function);
        let [above, below] = &self.values;
        let ([positive, negative], [least, most]) =
            match (above.as_slice().try_into(), below.as_slice().try_into()) {
                (Ok(above), Ok(below)) => extremes::<16>(above, below),
                _ => extremes_of(above.iter().zip(below)),
            };
        let bounds = self.widened.iter().enumerate().filter(|(gear, _)| gears >> gear & 1 == 1);
        let reached = bounds.filter(|(_, bounds)| {
            if positive || negative {
                least <= bounds.most && bounds.least <= most
            } else {
                bounds.is_reached(above, below)
            }
        });
        reached.fold(0, |all, (gear, _)| all | 1 << gear)
    }

    fn evaluate(&mut self, cuboid: &[[f64; 2]], function: usize) {
        let [above, below] = &mut self.values;
        corner_values(&self.functions[function].coefficients[0], cuboid, above);
        corner_values(&self.functions[function].coefficients[1], cuboid, below);
    }

    /// Whether each pair of gears may be in falling order anywhere in a box. It may not if the highest ratio
    /// of the one is not above the lowest of the other.
    fn may_fall(&mut self, cuboid: &[[f64; 2]], functions: &[usize]) -> bool {
        self.falling.iter().all(|[higher, lower]| {
            let most = self.extremes(cuboid, functions[*higher]).map(|[_, most]| most);
            let least = self.extremes(cuboid, functions[*lower]).map(|[least, _]| least);
            most.zip(least).is_none_or(|(most, least)| most > least)
        })
    }

    /// The least and the greatest ratio of a function in a box, unless its output may be at rest in it.
    fn extremes(&mut self, cuboid: &[[f64; 2]], function: usize) -> Option<[f64; 2]> {
        self.evaluate(cuboid, function);
        let [above, below] = &self.values;
        let keeps_sign = below.iter().all(|value| *value > 0.0) || below.iter().all(|value| *value < 0.0);
        let ratios = above.iter().zip(below).map(|(above, below)| above / below);
        keeps_sign.then(|| {
            ratios.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], ratio| {
                [least.min(ratio), most.max(ratio)]
            })
        })
    }

    /// Shrinks the box to the hull of the points that a function may have within a gear's bounds; `None` if
    /// no such point exists.
    fn shrink(&mut self, cuboid: &mut [[f64; 2]], function: usize, gear: usize) -> Option<()> {
        let gear = self.widened[gear];
        self.evaluate(cuboid, function);
        let below = &self.values[1];
        let sign = if below.iter().all(|value| *value > 0.0) {
            1.0
        } else if below.iter().all(|value| *value < 0.0) {
            -1.0
        } else {
            return Some(());
        };
        let equal = self.equal;
        for set in (0..cuboid.len()).filter(|set| !equal.follows(*set)) {
            for (bound, side) in [(gear.least, sign), (gear.most, -sign)] {
                let [above, below] = &self.values;
                let value = |corner: usize| side * (above[corner] - bound * below[corner]);
                // Where along the edges, from 0 to 1, the inequality holds.
                let (mut first, mut last) = (f64::INFINITY, f64::NEG_INFINITY);
                for corner in (0..above.len()).filter(|corner| corner >> set & 1 == 0) {
                    let (begin, end) = (value(corner), value(corner | 1 << set));
                    match (begin >= 0.0, end >= 0.0) {
                        (true, true) => (first, last) = (0.0, 1.0),
                        (true, false) => (first, last) = (0.0, last.max(begin / (begin - end))),
                        (false, true) => (first, last) = (first.min(begin / (begin - end)), 1.0),
                        (false, false) => {}
                    }
                    if first <= 0.0 && last >= 1.0 {
                        break;
                    }
                }
                if first > last {
                    return None;
                }
                let [least, most] = cuboid[set];
                let lower = (least + first * (most - least)) * (1.0 - WIDENING);
                let upper = (least + last * (most - least)) * (1.0 + WIDENING);
                if lower > least + 0.01 * (most - least) || upper < most - 0.01 * (most - least) {
                    equal.put(cuboid, set, [lower.max(least), upper.min(most)]);
                    // The values at the corners were those of the box before.
                    self.evaluate(cuboid, function);
                }
            }
        }
        Some(())
    }

    /// Point of the box at which each gear is within its accepted bounds, if a few Gauss-Newton steps from
    /// the middle lead to one. They go first towards the middles of all bounds, and from near the bounds
    /// towards those that are missed.
    fn point(&self, cuboid: &[[f64; 2]], functions: &[usize]) -> Option<Vec<f64>> {
        let mut k: Vec<f64> = cuboid.iter().map(|[least, most]| 0.5 * (least + most)).collect();
        for to_bounds in [false, true] {
            for _ in 0..STEPS {
                let ratios: Vec<f64> =
                    functions.iter().map(|function| self.functions[*function].ratio.value(&k)).collect();
                let within = ratios.iter().zip(&self.accepted).all(|(ratio, gear)| gear.contain(*ratio));
                if within && self.falling.iter().all(|[higher, lower]| ratios[*higher] > ratios[*lower]) {
                    return Some(k);
                }
                let misses: Vec<f64> =
                    ratios.iter().zip(&self.gears).map(|(ratio, gear)| gear.deviation(*ratio)).collect();
                if to_bounds && misses.iter().any(|miss| miss.abs() > NEAR_BOUNDS) {
                    return None;
                }
                let step = self.step(&k, functions, &misses, to_bounds)?;
                for ((k, step), [least, most]) in k.iter_mut().zip(step).zip(cuboid) {
                    *k = (*k + step).clamp(*least, *most);
                }
                self.equal.spread(&mut k);
            }
        }
        None
    }

    /// Least-squares step for the deviations, each over half the width of its bounds; with `to_bounds` only
    /// for the parts beyond the bounds.
    fn step(&self, k: &[f64], functions: &[usize], deviations: &[f64], to_bounds: bool) -> Option<Vec<f64>> {
        let sets = k.len();
        let mut normal = Matrix::zeros(sets, sets + 1);
        for ((function, deviation), gear) in functions.iter().zip(deviations).zip(&self.gears) {
            let to_go = if to_bounds { deviation - deviation.clamp(-1.0, 1.0) } else { *deviation };
            if to_bounds && to_go == 0.0 {
                continue;
            }
            let half = 0.5 * (gear.most - gear.least);
            let mut slopes: Vec<f64> = (0..sets).map(|set| self.slope(*function, k, set) / half).collect();
            self.equal.gather(&mut slopes);
            for (set, slope) in slopes.iter().enumerate() {
                let row = normal.row_mut(set);
                for (entry, other) in row.iter_mut().zip(&slopes) {
                    *entry += slope * other;
                }
                row[sets] -= slope * to_go;
            }
        }
        // A little damping: a `k` that moves nothing stays.
        for set in 0..sets {
            let entry = &mut normal.row_mut(set)[set];
            *entry = *entry * (1.0 + DAMPING) + DAMPING;
        }
        solution(normal, 0.0).filter(|step| step.iter().all(|value| value.is_finite()))
    }

    /// The slope of a ratio along one `k`, by the quotient rule on its two polynomials.
    fn slope(&self, function: usize, k: &[f64], set: usize) -> f64 {
        let ratio = self.functions[function].ratio;
        // Of the first degree in `k_set`: the difference over a step of 1 is the slope.
        let mut next = k.to_vec();
        next[set] += 1.0;
        let (above, below) = (ratio.numerator.value(k), ratio.denominator.value(k));
        let (up, down) = (ratio.numerator.value(&next) - above, ratio.denominator.value(&next) - below);
        (up * below - above * down) / (below * below)
    }
}

/// [`extremes_of`] with a number of corners that is known beforehand, so that several are worked out at a
/// time.
fn extremes<const CORNERS: usize>(above: &[f64; CORNERS], below: &[f64; CORNERS]) -> ([bool; 2], [f64; 2]) {
    extremes_of(above.iter().zip(below))
}

/// Whether all denominators are positive, whether all are negative, and the least and the greatest quotient.
#[inline]
fn extremes_of<'a>(corners: impl Iterator<Item = (&'a f64, &'a f64)>) -> ([bool; 2], [f64; 2]) {
    let (mut positive, mut negative) = (true, true);
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    for (above, below) in corners {
        positive &= *below > 0.0;
        negative &= *below < 0.0;
        let ratio = above / below;
        least = if ratio < least { ratio } else { least };
        most = if ratio > most { ratio } else { most };
    }
    ([positive, negative], [least, most])
}

/// The product of the upper bounds of a box over the lower.
fn spread(cuboid: &[[f64; 2]]) -> f64 {
    cuboid.iter().map(|[least, most]| most / least).product()
}

/// The `k` whose bounds differ most, and by which part of the lower.
fn widest(cuboid: &[[f64; 2]]) -> Option<(usize, f64)> {
    let widths = cuboid.iter().map(|[least, most]| most / least - 1.0).enumerate();
    widths.max_by(|one, other| one.1.total_cmp(&other.1))
}

/// Whether each gear can have a function of its own, by the gears that each function reaches (augmenting
/// paths).
pub(crate) fn can_match(reaches: &[u32], gears: usize) -> bool {
    /// Whether a function can get a gear, with functions that have one already moving to others.
    fn augment(function: usize, reaches: &[u32], owners: &mut [usize; 32], visited: &mut u32) -> bool {
        loop {
            let open = reaches[function] & !*visited;
            if open == 0 {
                return false;
            }
            let gear = open.trailing_zeros() as usize;
            *visited |= 1 << gear;
            if owners[gear] == usize::MAX || augment(owners[gear], reaches, owners, visited) {
                owners[gear] = function;
                return true;
            }
        }
    }
    let mut owners = [usize::MAX; 32];
    let mut missing = gears;
    for function in 0..reaches.len() {
        if missing == 0 || missing > reaches.len() - function {
            break;
        }
        missing -= usize::from(augment(function, reaches, &mut owners, &mut 0));
    }
    missing == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gears_match_functions_only_if_enough_reach_them() {
        assert!(can_match(&[0b011, 0b001, 0b100], 3));
        assert!(!can_match(&[0b011, 0b011, 0b011], 3));
        assert!(
            !can_match(&[0b001, 0b001, 0b110], 3),
            "two functions for the first gear, one for the others"
        );
    }
}

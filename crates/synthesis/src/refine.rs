//! The best ring-to-sun ratios of a solution, and the range that each may have.
//!
//! *Best* is where the greatest deviation of a gear, by the half of its bounds' width, is least. The range of a `k` ends at the
//! outermost points with all gears within their bounds. Both are proved for the gears' functions as found: a better point, or one
//! farther out, there is not (`region`).

use crate::parts::{Bounds, Cuboid};
use crate::ratio::Ratio;
use crate::region::Region;
use crate::tolerance::NEAR;

/// The best point of a solution, and its ranges.
#[derive(Debug, Clone, PartialEq)]
pub struct Refined {
    /// The ring-to-sun ratios with the least greatest deviation.
    pub k: Vec<f64>,
    /// The greatest deviation there, as a part of the bounds' half width: 0 in the middle of all bounds, 1 at one.
    pub deviation: f64,
    /// The range of each `k` in which points with all gears are found, the others moving along; outermost to 10⁻⁶.
    pub ranges: Vec<[f64; 2]>,
}

/// Refines a point that has all gears by these ratios.
#[must_use]
pub fn refine(ratios: &[Ratio], gears: &[Bounds], range_of_k: &Cuboid, point: &[f64]) -> Refined {
    let sets = range_of_k.len();
    let mut region = Region::new(ratios, gears, sets);
    let cover = region.cover(range_of_k);
    let best = region.least_deviation(&cover, point, NEAR);
    let mut end =
        |set: usize, upper: bool| region.outermost_k(&cover, set, upper, &best.k, NEAR * best.k[set]);
    let ranges = (0..sets).map(|set| [end(set, false), end(set, true)]).collect();
    Refined { deviation: best.value, k: best.k, ranges }
}

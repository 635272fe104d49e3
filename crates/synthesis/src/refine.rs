//! The best ring-to-sun ratios of a solution, and the range that each may have.
//!
//! The *best* point has the least greatest deviation of a gear, over half its bounds' width. If the others
//! leave a choice, the next greatest deviation is least, and so on. The range of a `k` ends at the outermost
//! points with all gears within their bounds. Both are proved for the gears' functions as found: no better
//! point, and none farther out, exists, up to 10⁻⁶. If the points with the least deviation, or the outermost,
//! fill whole surfaces, the proof would take long. The tolerance is then doubled after every 1024 ranges
//! (`region`).

use crate::equal::Equal;
use crate::parts::{Bounds, Cuboid};
use crate::ratio::Ratio;
use crate::region::Region;
use crate::tolerance::NEAR;

/// The best point of a solution, and its ranges.
#[derive(Debug, Clone, PartialEq)]
pub struct Refined {
    /// The ring-to-sun ratios with the least greatest deviation.
    pub k: Vec<f64>,
    /// The greatest deviation there, as a part of the bounds' half width: 0 in the middle of all bounds, 1 at
    /// one.
    pub deviation: f64,
    /// The range of each `k` in which points with all gears are found, the others moving along; outermost to
    /// 10⁻⁶ as a rule.
    pub ranges: Vec<[f64; 2]>,
}

/// Refines a point that has all gears by these ratios. Of some gears, by their places, any ratio within the
/// bounds is as good. Where some `k` are equal in it, they stay so.
#[must_use]
pub fn refine(
    ratios: &[Ratio],
    gears: &[Bounds],
    free: &[usize],
    range_of_k: &Cuboid,
    point: &[f64],
    equal: Equal,
) -> Refined {
    let sets = range_of_k.len();
    let mut region = Region::new(ratios, gears, free, sets, equal);
    let cover = region.cover(range_of_k);
    let least = region.least_deviation(&cover, point, NEAR);
    let k = region.least_of_others(range_of_k, &least);
    let mut end = |set: usize, upper: bool| region.outermost_k(&cover, set, upper, &k, NEAR * k[set]);
    let ranges = (0..sets).map(|set| [end(set, false), end(set, true)]).collect();
    Refined { deviation: region.deviation(&k), k, ranges }
}

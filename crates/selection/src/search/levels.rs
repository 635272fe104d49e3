//! Tooth sets by their row parameter: all that objectives can tell apart.
//!
//! Ratios, speeds, torques and losses of a gearbox depend on its tooth sets through `k = z_b/z_a` alone,
//! and the size on `k` and the number of planets. So the sets of one `k` are one *level*; within it only
//! the share `γ/N` of the most loaded planet tells sets apart, and a set whose share is not the least
//! makes a design no better than one of the least. Of the 8016 sets of the default bounds 2696 `k` are
//! distinct.

use crate::demand::Limits;
use crate::objectives::parameter_distance;
use crate::size::{Rating, cube_of_parameter};
use epicyclic_gears::synthesis::ToothNumbers;

/// Tooth sets of one row parameter.
#[derive(Debug, Clone)]
pub(crate) struct Level {
    pub(crate) k: f64,
    /// First and end of its sets among all.
    pub(crate) sets: [u32; 2],
    /// `2/(k − 1)`: speed of the planet over that of the sun, both relative to the carrier.
    pub(crate) planet: f64,
    /// Distance of `ln k` from the preferred range.
    pub(crate) distance: f64,
    /// `k³·(1 + 1/r)/min(1, r)`.
    pub(crate) cube: f64,
    /// The least `γ/N` of its sets.
    pub(crate) share: f64,
}

/// All levels within the limits, ascending by `k`, and the tooth sets by level.
pub(crate) fn levels(
    mut sets: Vec<ToothNumbers>,
    limits: &Limits,
    rating: &Rating,
) -> (Vec<Level>, Vec<ToothNumbers>) {
    sets.retain(|set| limits.parameter.contains(&set.ring_to_sun_ratio()));
    // By k as a fraction: exact, and without a thought of rounding.
    let cross = |one: &ToothNumbers, other: &ToothNumbers| {
        let product = |a: &ToothNumbers, b: &ToothNumbers| u64::from(a.ring.get()) * u64::from(b.sun.get());
        product(one, other).cmp(&product(other, one))
    };
    sets.sort_by(|one, other| cross(one, other).then(one.cmp(other)));
    let mut found: Vec<Level> = vec![];
    let mut from = 0_u32;
    for alike in sets.chunk_by(|one, other| cross(one, other).is_eq()) {
        let k = alike[0].ring_to_sun_ratio();
        let to = from + alike.len() as u32;
        found.push(Level {
            k,
            sets: [from, to],
            planet: 2.0 / (k - 1.0),
            distance: parameter_distance(k, *limits.preferred.start(), *limits.preferred.end()),
            cube: cube_of_parameter(k),
            share: alike.iter().map(|set| rating.share(set.planets)).fold(f64::INFINITY, f64::min),
        });
        from = to;
    }
    (found, sets)
}

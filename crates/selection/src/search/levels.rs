//! Tooth numbers by their ring-to-sun ratio: all that objectives can tell apart.
//!
//! Ratios, speeds, torques and losses of a gearbox depend on its tooth numbers through `k = z_b/z_a` alone,
//! and the size on `k` and the number of planets. So the tooth numbers of one `k` are one *level*; within it only
//! the share `K_γ/N` of the most loaded planet tells them apart, and those whose share is not the least
//! make a design no better than those of the least. Of the 8016 combinations within the default bounds 2696 `k` are
//! distinct.

use crate::objectives::ring_to_sun_distance;
use crate::requirements::Limits;
use crate::size::{Rating, cube_of_ring_to_sun_ratio};
use epicyclic_gears::synthesis::ToothNumbers;

/// Tooth numbers of one ring-to-sun ratio.
#[derive(Debug, Clone)]
pub(crate) struct Level {
    pub(crate) k: f64,
    /// First and end of its tooth numbers among all.
    pub(crate) tooth_sets: [u32; 2],
    /// `2/(k − 1)`: speed of the planet over that of the sun, both relative to the carrier.
    pub(crate) planet: f64,
    /// Distance of `ln k` from the preferred range.
    pub(crate) distance: f64,
    /// `k³·(1 + 1/r)/min(1, r)`.
    pub(crate) cube: f64,
    /// The least `K_γ/N` of its tooth numbers.
    pub(crate) share: f64,
}

/// All levels within the limits, ascending by `k`, and the tooth numbers by level.
pub(crate) fn levels(
    mut tooth_sets: Vec<ToothNumbers>,
    limits: &Limits,
    rating: &Rating,
) -> (Vec<Level>, Vec<ToothNumbers>) {
    tooth_sets.retain(|teeth| limits.ring_to_sun.contains(&teeth.ring_to_sun_ratio()));
    // By k as a fraction: exact, and without a thought of rounding.
    let cross = |one: &ToothNumbers, other: &ToothNumbers| {
        let product = |a: &ToothNumbers, b: &ToothNumbers| u64::from(a.ring.get()) * u64::from(b.sun.get());
        product(one, other).cmp(&product(other, one))
    };
    tooth_sets.sort_by(|one, other| cross(one, other).then(one.cmp(other)));
    let mut found: Vec<Level> = vec![];
    let mut from = 0_u32;
    for alike in tooth_sets.chunk_by(|one, other| cross(one, other).is_eq()) {
        let k = alike[0].ring_to_sun_ratio();
        let to = from + alike.len() as u32;
        found.push(Level {
            k,
            tooth_sets: [from, to],
            planet: 2.0 / (k - 1.0),
            distance: ring_to_sun_distance(k, *limits.preferred.start(), *limits.preferred.end()),
            cube: cube_of_ring_to_sun_ratio(k),
            share: alike.iter().map(|teeth| rating.share(teeth.planets)).fold(f64::INFINITY, f64::min),
        });
        from = to;
    }
    (found, tooth_sets)
}

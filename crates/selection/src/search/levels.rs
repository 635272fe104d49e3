//! Tooth numbers by their ring-to-sun ratio: all that objectives can tell apart.
//!
//! Ratios, speeds, torques and losses of a gearbox depend on its tooth numbers through `k = z_b/z_a` alone,
//! and the size on `k` and the number of planets. So the tooth numbers of one `k` are one *level*; within it only
//! the share `K_γ/N` of the most loaded planet tells them apart, and those whose share is not the least
//! make a design no better than those of the least. Of the 8016 combinations within the default bounds 2696 `k` are
//! distinct.

use crate::requirements::Limits;
use crate::size::{Rating, cube_of_ring_to_sun_ratio};
use epicyclic_gears::synthesis::ToothNumbers;
use std::ops::RangeInclusive;

/// Tooth numbers of one ring-to-sun ratio.
#[derive(Debug, Clone)]
pub(crate) struct Level {
    pub(crate) k: f64,
    /// First and end of its tooth numbers among all.
    pub(crate) tooth_sets: [u32; 2],
    /// Teeth of sun and ring of its first tooth numbers: `k` as a fraction.
    pub(crate) teeth: [f64; 2],
    /// How far `k` is from the preferred range: as a fraction, times a limit of that range or 1.
    pub(crate) distance: Distance,
    /// `k³·(1 + 1/r)/min(1, r)`.
    pub(crate) cube: f64,
    /// The least `K_γ/N` of its tooth numbers.
    pub(crate) share: f64,
}

/// `k_low/k` below a range, `k/k_high` above, 1 within: `e` to the power of the distance of `ln k` from it. As a fraction of
/// teeth and a factor: fractions of teeth multiply without rounding, so equal products of two levels are equal to the bit.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Distance {
    fraction: [f64; 2],
    factor: f64,
}

impl Distance {
    fn new([sun, ring]: [f64; 2], preferred: &RangeInclusive<f64>) -> Self {
        let (k, low, high) = (ring / sun, *preferred.start(), *preferred.end());
        if k < low {
            Self { fraction: [sun, ring], factor: low }
        } else if k > high {
            Self { fraction: [ring, sun], factor: 1.0 / high }
        } else {
            Self { fraction: [1.0, 1.0], factor: 1.0 }
        }
    }

    /// `e` to the power of the distance.
    pub(crate) fn value(self) -> f64 {
        self.fraction[0] / self.fraction[1] * self.factor
    }

    /// `e` to the power of the sum of two distances.
    #[inline]
    pub(crate) fn times(self, other: Self) -> f64 {
        let [of, over] = [0, 1].map(|place| self.fraction[place] * other.fraction[place]);
        of / over * (self.factor * other.factor)
    }
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
        let teeth = [alike[0].sun, alike[0].ring].map(|teeth| f64::from(teeth.get()));
        let to = from + alike.len() as u32;
        found.push(Level {
            k,
            tooth_sets: [from, to],
            teeth,
            distance: Distance::new(teeth, &limits.preferred),
            cube: cube_of_ring_to_sun_ratio(k),
            share: alike.iter().map(|teeth| rating.share(teeth.planets)).fold(f64::INFINITY, f64::min),
        });
        from = to;
    }
    (found, tooth_sets)
}

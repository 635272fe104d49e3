//! Tooth numbers by their ring-to-sun and planet-to-sun ratios, on which alone the objectives depend.
//!
//! Ratios, speeds of links, torques and losses of a gearbox depend on its tooth numbers through `k = z_b/z_a`
//! alone. Speeds of planets and the size also depend on `r = z_g/z_a`, and the size on the number of planets.
//! The tooth numbers of one `k` and one `r` are therefore one *level*. Within it they differ only in the
//! share `K_γ/N` of the most loaded planet, and those with a larger share than the least make a design no
//! better. Without profile shift `r = (k − 1)/2`. The 8016 combinations within the default bounds have 2696
//! distinct `k`. With offsets of the ring one `k` may have several `r`.

use crate::Error;
use crate::requirements::Limits;
use crate::size::{Rating, cube_of_ratios, working_over_reference};
use epicyclic_gears::ToothCount;
use epicyclic_gears::involute::search::ProfileShift;
use epicyclic_gears::synthesis::ToothNumbers;
use std::ops::RangeInclusive;

/// Tooth numbers of one ring-to-sun ratio and one planet-to-sun ratio.
#[derive(Debug, Clone)]
pub(crate) struct Level {
    pub(crate) k: f64,
    /// First and end of its tooth numbers among all.
    pub(crate) tooth_sets: [u32; 2],
    /// Teeth of sun and ring of its first tooth numbers: `k` as a fraction.
    pub(crate) teeth: [f64; 2],
    /// Teeth of their planet: `r` as a fraction over the sun's.
    pub(crate) planet: f64,
    /// `r`, the planet's teeth over the sun's.
    pub(crate) planet_to_sun: f64,
    /// Working over reference diameters of sun and planets, `w`.
    pub(crate) working: f64,
    /// Distance of `k` from the preferred range: as a fraction, times a limit of that range or 1.
    pub(crate) distance: Distance,
    /// `k³·(1 + 1/r)/(w²·min(1, r))`.
    pub(crate) cube: f64,
    /// The least `K_γ/N` of its tooth numbers.
    pub(crate) share: f64,
}

/// `k_low/k` below a range, `k/k_high` above, 1 within: `e` to the power of the distance of `ln k` from it.
/// As a fraction of teeth and a factor: fractions of teeth multiply without rounding, so equal products of
/// two levels are equal to the bit.
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

/// Levels within the limits, ascending by `k`, then by `r`, and the tooth numbers by level.
pub(crate) fn levels(
    mut tooth_sets: Vec<ToothNumbers>,
    limits: &Limits,
    rating: &Rating,
    shift: Option<&ProfileShift>,
) -> Result<(Vec<Level>, Vec<ToothNumbers>), Error> {
    tooth_sets.retain(|teeth| limits.ring_to_sun.contains(&teeth.ring_to_sun_ratio()));
    // Fractions compare k and r exactly, without rounding.
    let cross = |one: &ToothNumbers, other: &ToothNumbers| {
        let of = |gear: fn(&ToothNumbers) -> ToothCount| {
            let product =
                |a: &ToothNumbers, b: &ToothNumbers| u64::from(gear(a).get()) * u64::from(b.sun.get());
            product(one, other).cmp(&product(other, one))
        };
        of(|teeth| teeth.ring).then_with(|| of(|teeth| teeth.planet))
    };
    tooth_sets.sort_by(|one, other| cross(one, other).then(one.cmp(other)));
    let mut found: Vec<Level> = vec![];
    let mut from = 0_u32;
    for alike in tooth_sets.chunk_by(|one, other| cross(one, other).is_eq()) {
        let (k, planet_to_sun) = (alike[0].ring_to_sun_ratio(), alike[0].planet_to_sun_ratio());
        let working = working_over_reference(&alike[0], shift)?;
        let teeth = [alike[0].sun, alike[0].ring].map(|teeth| f64::from(teeth.get()));
        let to = from + alike.len() as u32;
        found.push(Level {
            k,
            tooth_sets: [from, to],
            teeth,
            planet: f64::from(alike[0].planet.get()),
            planet_to_sun,
            working,
            distance: Distance::new(teeth, &limits.preferred),
            cube: cube_of_ratios(k, planet_to_sun, working),
            share: alike.iter().map(|teeth| rating.share(teeth.planets)).fold(f64::INFINITY, f64::min),
        });
        from = to;
    }
    Ok((found, tooth_sets))
}

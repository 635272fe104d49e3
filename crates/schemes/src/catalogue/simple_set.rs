//! A single simple set: its six ratios over a range of k, and the four relations of its speeds.
//!
//! # Source
//! multispeed-gearboxes, tables 2.2 and 2.3, (2.22)–(2.25).

use super::RingToSunRange;
use epicyclic_gears::simple_set::{BasicRatio, Member, Mode, RingToSunRatio};

/// Ratio of a simple set in a mode as a fraction `[n, d]` of terms linear in `k`.
///
/// ```text
/// ab^H −k/1     aH^b (1+k)/1     bH^a (1+k)/k     ba^H −1/k     Ha^b 1/(1+k)     Hb^a k/(1+k)
/// ```
#[must_use]
pub(crate) fn fraction(mode: Mode, k: f64) -> [f64; 2] {
    let weight = |member: Member| match member {
        Member::Sun => 1.0,
        Member::Ring => k,
        Member::Carrier => -(1.0 + k),
    };
    // With the third member at rest, w_in·ω_in + w_out·ω_out = 0.
    let (n, d) = (-weight(mode.output()), weight(mode.input()));
    if d < 0.0 { [-n, -d] } else { [n, d] }
}

/// Ratio of a set in a mode at both ends of a range of `k`, the lower end first: a row of table 2.2.
///
/// Each of the six is monotonous in `k`, so these are its extremes.
///
/// ```
/// use epicyclic_gears::simple_set::{Member, Mode};
/// use epicyclic_schemes::catalogue::{RingToSunRange, simple_set::ratio_range};
/// # fn main() -> Result<(), epicyclic_gears::Error> {
/// let [from, to] = ratio_range(Mode::new(Member::Ring, Member::Carrier)?, RingToSunRange::USED);
/// assert!((from - 2.7 / 1.7).abs() < 1e-15 && (to - 8.0 / 7.0).abs() < 1e-15); // printed 1.58 – 1.4
/// # Ok(())
/// # }
/// ```
#[must_use]
pub fn ratio_range(mode: Mode, range: RingToSunRange) -> [f64; 2] {
    range.ends().map(|k| {
        let [n, d] = fraction(mode, k);
        n / d
    })
}

/// Ring-to-sun ratio of the simple set with ratio `i = ω_in/ω_out` in a mode.
///
/// # Errors
/// [`epicyclic_gears::Error::Ratio`] or [`epicyclic_gears::Error::RingToSunRatio`] where no simple set
/// has it.
pub fn ring_to_sun_ratio(mode: Mode, ratio: f64) -> Result<RingToSunRatio, epicyclic_gears::Error> {
    RingToSunRatio::new(-BasicRatio::with_ratio(ratio, mode)?.get())
}

/// Factors of `ω_a`, `ω_b`, `ω_H`, `ω_g` in the four relations between the speeds of a simple set, each
/// of three links: table 2.3. Each relation is `Σ factor·ω = 0`, and its factors sum to 0.
///
/// ```text
/// ω_a + k·ω_b − (k + 1)·ω_H = 0             2·ω_a − (k + 1)·ω_H + (k − 1)·ω_g = 0
/// ω_a − k·ω_b + (k − 1)·ω_g = 0             2·k·ω_b − (k + 1)·ω_H − (k − 1)·ω_g = 0
/// ```
///
/// Speeds in any one unit. In the order of the table: without g, without H, without b, without a.
#[must_use]
pub fn speed_relations(k: RingToSunRatio) -> [[f64; 4]; 4] {
    let k = k.get();
    [
        [1.0, k, -(k + 1.0), 0.0],
        [1.0, -k, 0.0, k - 1.0],
        [2.0, 0.0, -(k + 1.0), k - 1.0],
        [0.0, 2.0 * k, -(k + 1.0), -(k - 1.0)],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_fractions_are_the_ratios_of_the_set(k in 1.01..20.0_f64) {
            let set = BasicRatio::from(RingToSunRatio::new(k).unwrap());
            for mode in Mode::ALL {
                let [n, d] = fraction(mode, k);
                let ratio = set.ratio(mode).unwrap();
                prop_assert!(d > 0.0 && (n / d - ratio).abs() <= 1e-14 * ratio.abs());
                prop_assert!((ring_to_sun_ratio(mode, ratio).unwrap().get() - k).abs() < 1e-12 * k * k);
            }
        }

        #[test]
        fn the_relations_hold_for_rolling_speeds_and_for_a_block(
            k in 1.01..20.0_f64, carrier in -5.0..5.0, sun in -5.0..5.0,
        ) {
            let ring_to_sun = RingToSunRatio::new(k).unwrap();
            let ring = ((k + 1.0) * carrier - sun) / k;
            let planet = carrier - (sun - carrier) / ring_to_sun.planet_to_sun();
            let speeds = [sun, ring, carrier, planet];
            for relation in speed_relations(ring_to_sun) {
                let parts = relation.iter().zip(speeds).map(|(factor, speed)| factor * speed);
                let scale = parts.clone().map(f64::abs).fold(1.0, f64::max);
                prop_assert!(parts.sum::<f64>().abs() < 1e-13 * scale);
                prop_assert!(relation.iter().sum::<f64>().abs() < 1e-14 * k.max(1.0) * 4.0);
            }
        }
    }
}

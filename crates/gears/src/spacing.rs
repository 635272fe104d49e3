//! Positions of planets that cannot be spaced equally.
//!
//! Between a sun and a ring that both mesh with it, a planet fits at `z_a + z_b` angles per turn and nowhere
//! between. When the planet moves on by one of these slots, the teeth of sun and ring turn together by whole
//! teeth. Equal spacing therefore needs `(z_a + z_b)/N` to be an integer. If it is not, the planets take the
//! slots nearest to equal spacing.
//!
//! # Source
//! excavator-dynamics, condition of assembly.

use crate::teeth::{ToothCount, gcd};
use epicyclic_units::Physical;
use std::f64::consts::TAU;
use uom::si::f64::Angle;

/// Slots that the planets of a set occupy.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PlanetSpacing {
    /// Number of slots; the sum of two counts of 32 bits has 33.
    slots: u64,
    planets: u32,
}

impl PlanetSpacing {
    /// The spacing of `planets` planets that departs least from an equal one.
    ///
    /// ```text
    /// p_j = ⌊j·(z_a + z_b)/N⌋,  j = 0 … N − 1
    /// ```
    ///
    /// Apart from a rotation of the whole set this is the only spacing with the smallest greatest deviation.
    /// The values `p_j − j·(z_a + z_b)/N` fall into `q = N/gcd(N, z_a + z_b)` classes modulo 1 that lie `1/q`
    /// apart. They therefore spread over at least `(q − 1)/q` slots, and this spacing spreads them over
    /// exactly that.
    ///
    /// The result is valid for any counts of teeth and planets; with more planets than slots several share
    /// one.
    #[must_use]
    pub fn least_unequal(sun: ToothCount, ring: ToothCount, planets: u32) -> Self {
        Self { slots: u64::from(sun.get()) + u64::from(ring.get()), planets }
    }

    /// Spacing of pairs of planets that departs least from an equal one; the planets of a pair mesh with each
    /// other, one with the sun and one with the ring. Such a pair fits at `z_b − z_a` angles per turn
    /// ([`double_planet`](crate::double_planet#assembly)). `None` where the ring has no more teeth than the
    /// sun.
    #[must_use]
    pub fn of_pairs(sun: ToothCount, ring: ToothCount, pairs: u32) -> Option<Self> {
        let slots = u64::from(ring.get().checked_sub(sun.get())?);
        (slots > 0).then_some(Self { slots, planets: pairs })
    }

    /// Least unequal spacing on a given number of angles per turn at which a planet fits.
    #[must_use]
    pub fn of_positions(positions: u64, planets: u32) -> Self {
        Self { slots: positions, planets }
    }

    /// Number of angles at which a planet, or a pair of planets, fits: `z_a + z_b`, of pairs `z_b − z_a`.
    #[must_use]
    pub fn slots(&self) -> u64 {
        self.slots
    }

    /// Slots occupied, ascending from 0.
    #[must_use]
    pub fn occupied(&self) -> impl DoubleEndedIterator<Item = u64> + use<> {
        let (slots, planets) = (u128::from(self.slots), self.planets);
        // At most `slots`, which fits.
        (0..planets).map(move |j| (u128::from(j) * slots / u128::from(planets)) as u64)
    }

    /// Angles of the planets, ascending from 0.
    #[must_use]
    pub fn angles(&self) -> Vec<Angle> {
        let slot = TAU / self.slots as f64;
        self.occupied().map(|p| Angle::from_si(p as f64 * slot)).collect()
    }

    /// Whether all gaps are equal.
    #[must_use]
    pub fn is_equal(&self) -> bool {
        self.slots.is_multiple_of(self.count())
    }

    /// The smallest angle between adjacent planets, `2π·⌊G/N⌋/G` with `G` [`slots`](Self::slots).
    #[must_use]
    pub fn smallest_gap(&self) -> Angle {
        let gap = self.slots / self.count();
        Angle::from_si(TAU * gap as f64 / self.slots as f64)
    }

    /// Sine of half the smallest angle between adjacent planets.
    #[must_use]
    pub fn half_gap_sine(&self) -> f64 {
        libm::sin(self.smallest_gap().si() / 2.0)
    }

    /// The greatest deviation of a planet from equal spacing, the equally spaced pattern turned to
    /// where that is least: `π·(1 − 1/q)/G`, `q = N/gcd(N, G)` with `G` [`slots`](Self::slots).
    #[must_use]
    pub fn greatest_deviation(&self) -> Angle {
        let classes = self.count() / gcd(self.count(), self.slots);
        let spread = 1.0 - 1.0 / classes as f64;
        Angle::from_si(TAU * spread / 2.0 / self.slots as f64)
    }

    /// Static imbalance: distance of the planets' common centre of mass from the axis over the
    /// radius of their centres. 0 for equal spacing.
    #[must_use]
    pub fn imbalance(&self) -> f64 {
        imbalance(&self.angles())
    }

    /// Planets, at least one, so that nothing is divided by none.
    fn count(&self) -> u64 {
        u64::from(self.planets.max(1))
    }
}

/// Static imbalance of planets at these angles, as [`PlanetSpacing::imbalance`]; 0 without planets.
#[must_use]
pub fn imbalance(angles: &[Angle]) -> f64 {
    let (x, y) = angles.iter().fold((0.0, 0.0), |(x, y), angle| {
        let (sin, cos) = libm::sincos(angle.si());
        (x + cos, y + sin)
    });
    libm::hypot(x, y) / angles.len().max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spacing(sun: u32, ring: u32, planets: u32) -> PlanetSpacing {
        PlanetSpacing::least_unequal(ToothCount::new(sun).unwrap(), ToothCount::new(ring).unwrap(), planets)
    }

    #[test]
    fn the_excavator_sits_evenly() {
        let even = spacing(20, 100, 4);
        assert!(even.is_equal());
        let degrees: Vec<f64> = even.angles().iter().map(|a| a.degrees().round()).collect();
        assert_eq!(degrees, [0.0, 90.0, 180.0, 270.0]);
        assert!(even.imbalance() < 1e-15);
        assert_eq!(even.greatest_deviation().si(), 0.0);
    }

    #[test]
    fn two_slots_too_many_leave_four_planets_balanced_in_pairs() {
        let uneven = spacing(18, 84, 4);
        assert_eq!(uneven.occupied().collect::<Vec<_>>(), [0, 25, 51, 76]);
        assert!(!uneven.is_equal());
        assert!(uneven.imbalance() < 1e-15);
    }

    #[test]
    fn the_greatest_tooth_counts_and_planets_have_a_spacing() {
        let most = u32::MAX;
        let wide = spacing(most, most, 4);
        assert_eq!(wide.slots(), 2 * u64::from(most));
        // 2·(2³² − 1) is twice an odd number: every other planet is half a slot off.
        assert_eq!(wide.occupied().collect::<Vec<_>>(), [0, 2_147_483_647, 4_294_967_295, 6_442_450_942]);
        assert!(!wide.is_equal() && wide.greatest_deviation().si() > 0.0);
        let crowded = spacing(most, most, most);
        assert!(crowded.is_equal());
        assert_eq!(crowded.occupied().next_back(), Some(2 * u64::from(most - 1)));
        assert!((crowded.smallest_gap().si() - TAU / f64::from(most)).abs() < 1e-24);
        assert_eq!(spacing(1, 1, 0).angles().len(), 0);
    }

    /// Every placement of the planets on the slots, by brute force.
    #[test]
    fn no_placement_departs_less_from_equal_spacing() {
        for slots in 6..=15_u32 {
            for planets in 2..=5_u32 {
                let mut least = f64::INFINITY;
                for mask in 0_u32..1 << slots {
                    if mask.count_ones() == planets && mask & 1 == 1 {
                        let places = (0..slots).filter(|p| mask >> p & 1 == 1);
                        let departures = places
                            .enumerate()
                            .map(|(j, p)| f64::from(p) - j as f64 * f64::from(slots) / f64::from(planets));
                        let (low, high) = departures
                            .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), d| (l.min(d), h.max(d)));
                        least = least.min((high - low) / 2.0);
                    }
                }
                let found = spacing(1, slots - 1, planets).greatest_deviation().si();
                let expected = least * TAU / f64::from(slots);
                assert!((found - expected).abs() < 1e-12, "{planets} planets on {slots} slots");
            }
        }
    }
}

//! Standing of a structure in the document: listed or not, and why.
//!
//! The document builds three speeds by a rule: set 1 alone works in gear 1 as scheme I, II or III, and set 2
//! ties T₁ to D or to B. That makes 3·2·6 = 36 structures ([`connection`](crate::connection)). It lists
//! eleven of them and gives no reason for leaving out the other 25. Standing of all 111 structures:
//!
//! | standing | how many | why |
//! |---|---|---|
//! | [`Listed`](Standing::Listed) | 11 | |
//! | [`Unlisted`](Standing::Unlisted) | 25 | by its rule; 10 are fit ([*missed*](Standing::is_missed)) |
//! | [`Reversed`](Standing::Reversed) | 36 | one of the 36 with D and B exchanged: speeds up in gear 1 |
//! | [`OutsideRule`](Standing::OutsideRule) | 39 | set 2 ties T₁ to neither D nor B as the rule has it |
//!
//! No two of the 36 are equal as structures. The eleven are those that split the power, without circulation,
//! and whose gear 2 can slow down. A structure is fit for the purpose if some `k₁`, `k₂` within the range
//! give gears that both slow, in the same direction of rotation. Possible uses of gear 2 of the 25 ([`Use`]):
//!
//! | use | how many, k from 1.7 to 7 | of these splitting the power |
//! |---|---|---|
//! | [`Slows`](Use::Slows) | 6 | 0 |
//! | [`SlowsAtSome`](Use::SlowsAtSome) | 4 | 0 |
//! | [`OnlySpeedsUp`](Use::OnlySpeedsUp) | 6 | 5 |
//! | [`Reverses`](Use::Reverses) | 7 | 0 |
//! | [`ChangesSign`](Use::ChangesSign) | 2 | 0 |
//!
//! # Source
//! multispeed-gearboxes, section 2.4.

use crate::catalogue::{Reach, RingToSunRange, ThreeSpeed};
use crate::connection::Connection;
use crate::pair::{coefficients, fraction};
use crate::structures::{Family, Structure};
use std::ops::RangeInclusive;

/// Values of the ratios of a structure's gears while both ring-to-sun ratios run over a range.
///
/// Numerator and denominator are bilinear. Over a rectangle both therefore take their extremes, and show
/// every change of sign, at the corners. Between zeros and poles the ratio is monotonous in each `k`, so it
/// takes its extremes at corners too.
#[must_use]
pub fn reach(structure: Structure, range: &RangeInclusive<f64>) -> [Reach; 2] {
    let [one, two] = structure.sets();
    [0, 1].map(|gear| {
        let of = |k1: f64, k2: f64| fraction(&coefficients(one, k1), &coefficients(two, k2), gear);
        Reach::of(of, [*range.start(), *range.end()])
    })
}

/// Standing of a structure in the document, with the ring-to-sun ratios within a range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Standing {
    /// One of the eleven of the source: power splits, and gear 2 can slow down.
    Listed(ThreeSpeed),
    /// Structure by the rule of the source that is not listed.
    Unlisted {
        /// Possible use of gear 2.
        usage: Use,
        /// Whether gear 2 splits the power between the sets; otherwise power circulates at every `k`.
        splits_power: bool,
        /// Values of the ratio of gear 1.
        first: Reach,
        /// Values of the ratio of gear 2.
        second: Reach,
    },
    /// Structure by the rule once D and B are exchanged; without exchange gear 1 speeds up.
    Reversed {
        /// The structure that slows in gear 1.
        of: Structure,
    },
    /// Structure outside the rule: no set has both T₁ and T₂ and one of D, B beside a set of D, B, T₁.
    OutsideRule {
        /// Division of the work between the sets.
        family: Family,
    },
}

/// Possible use of gear 2 of a structure besides gear 1, over a range of ring-to-sun ratios.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Use {
    /// The ratio has the sign of `i₁` at every k and can slow down.
    Slows,
    /// The ratio changes its sign within the range, and slows down with the sign of `i₁` at some k.
    SlowsAtSome,
    /// The ratio has the sign of `i₁` but `|i₂| < 1` throughout: a mix of slowing and speeding, which the
    /// source calls unfavourable.
    OnlySpeedsUp,
    /// The ratio has the other sign than `i₁`: a reverse gear, with `|i₂| > 1` in part of the range or not.
    Reverses,
    /// The ratio changes its sign within the range, and with the sign of `i₁` never slows down.
    ChangesSign,
}

impl Use {
    /// Use of a gear 2 with these values beside a gear 1 whose ratio has this sign.
    fn of(second: Reach, sign: f64) -> Self {
        match (second.sign(), second.slows_with_sign_of(sign)) {
            (None, true) => Self::SlowsAtSome,
            (None, false) => Self::ChangesSign,
            (Some(own), _) if own != sign => Self::Reverses,
            (Some(_), true) => Self::Slows,
            (Some(_), false) => Self::OnlySpeedsUp,
        }
    }
}

impl Standing {
    /// Standing of a structure with the ring-to-sun ratios within a range.
    ///
    /// ```
    /// use epicyclic_schemes::{standing::Standing, structures::{Role::*, Structure}};
    /// let structure = Structure::new([[D, T1, B], [T2, B, T1]]).unwrap();
    /// assert!(Standing::of(structure, &(1.3..=10.0)).is_missed());
    /// ```
    #[must_use]
    pub fn of(structure: Structure, range: &RangeInclusive<f64>) -> Self {
        if let Some(scheme) = structure.scheme() {
            return Self::Listed(scheme);
        }
        let family = structure.family();
        if matches!(family, Family::Parallel | Family::Serial) {
            return Self::OutsideRule { family };
        }
        let Some(connection) = Connection::of_structure(structure) else {
            return Self::Reversed { of: structure.reversal() };
        };
        let [first, second] = reach(structure, range);
        let usage = Use::of(second, connection.first_stage().sign());
        Self::Unlisted { usage, splits_power: connection.splits_power(), first, second }
    }

    /// Whether the source passes over a structure that is built by its rule and fit for its purpose.
    #[must_use]
    pub fn is_missed(self) -> bool {
        matches!(self, Self::Unlisted { usage: Use::Slows | Use::SlowsAtSome, .. })
    }
}

impl Connection {
    /// Standing of the connection in the source, with the ring-to-sun ratios within a range.
    #[must_use]
    pub fn standing(self, range: RingToSunRange) -> Standing {
        Standing::of(self.structure(), &(range.low()..=range.high()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const RANGE: RangeInclusive<f64> = 1.3..=10.0;

    fn named(is: impl Fn(&Standing) -> bool) -> Vec<String> {
        let of = |structure: &Structure| is(&Standing::of(*structure, &RANGE));
        Structure::all().into_iter().filter(of).map(|structure| structure.to_string()).collect()
    }

    #[test]
    fn every_structure_has_its_reason() {
        assert_eq!(named(|s| matches!(s, Standing::Listed(_))).len(), 11);
        assert_eq!(named(|s| matches!(s, Standing::Unlisted { .. }) && !s.is_missed()).len(), 15);
        assert_eq!(named(|s| matches!(s, Standing::Reversed { .. })).len(), 36);
        assert_eq!(named(|s| matches!(s, Standing::OutsideRule { .. })).len(), 39);
        assert_eq!(
            named(|s| s.is_missed()),
            [
                "D.B.T1+B.T2.T1",
                "D.B.T1+T2.B.T1",
                "D.T1.B+B.T2.T1",
                "D.T1.B+T2.B.T1",
                "T1.D.B+B.T2.T1",
                "T1.D.B+T2.B.T1",
                "D.B.T1+D.T2.T1",
                "D.T1.B+D.T1.T2",
                "T1.D.B+D.T1.T2",
                "T1.D.B+T1.D.T2",
            ]
        );
    }

    #[test]
    fn uses_are_those_of_the_table() {
        let count = |usage: Use, splits: bool| {
            let is = |structure: &Structure| {
                matches!(Standing::of(*structure, &(1.7..=7.0)),
                    Standing::Unlisted { usage: found, splits_power, .. } if found == usage && splits_power == splits)
            };
            Structure::all().into_iter().filter(is).count()
        };
        let of = |usage| [count(usage, false), count(usage, true)];
        assert_eq!(of(Use::Slows), [6, 0]);
        assert_eq!(of(Use::SlowsAtSome), [4, 0]);
        assert_eq!(of(Use::OnlySpeedsUp), [1, 5]);
        assert_eq!(of(Use::Reverses), [7, 0]);
        assert_eq!(of(Use::ChangesSign), [2, 0]);
    }

    #[test]
    fn five_of_the_missed_slow_in_the_same_direction_whatever_their_ring_to_sun_ratios() {
        let always = |standing: &Standing| match standing {
            Standing::Unlisted {
                first: Reach::Between { least: first, .. },
                second: Reach::Between { least: second, .. },
                ..
            } => *first > 1.0 && *second > 1.0,
            _ => false,
        };
        assert_eq!(named(always).len(), 5);
    }

    #[test]
    fn the_reversed_are_the_36_of_the_rule() {
        let of: std::collections::BTreeSet<Structure> = Structure::all()
            .into_iter()
            .filter_map(|structure| match Standing::of(structure, &RANGE) {
                Standing::Reversed { of } => Some(of),
                _ => None,
            })
            .collect();
        assert_eq!(of.len(), 36);
        assert_eq!(of, Connection::all().into_iter().map(Connection::structure).collect());
        // Set 1 alone: without exchange its ratio lies within ±1, exchanged outside.
        for structure in of {
            assert!(reach(structure, &RANGE)[0].slows() && !reach(structure.reversal(), &RANGE)[0].slows());
        }
    }

    proptest! {
        #[test]
        fn reach_holds_every_ratio(a in 1.3..10.0, b in 1.3..10.0) {
            for structure in Structure::all() {
                let sets = structure.sets();
                let ratios = crate::pair::ratios(&coefficients(sets[0], a), &coefficients(sets[1], b));
                for (ratio, reach) in ratios.into_iter().zip(reach(structure, &RANGE)) {
                    let slack = 1e-9 * (1.0 + ratio.abs());
                    prop_assert!(reach.meets(ratio, ratio, slack), "{structure} {ratio} {reach:?}");
                }
            }
        }
    }
}

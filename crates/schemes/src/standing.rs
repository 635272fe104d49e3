//! Why the document has a structure, or has it not.
//!
//! The document builds three speeds by a rule: set 1 alone works in gear 1 as scheme I, II or III, and
//! set 2 ties T₁ to D or to B. That makes 3·2·6 = 36 structures, of which it lists eleven and gives no
//! reason for leaving out the other 25. Of all 111
//!
//! | standing | how many | why |
//! |---|---|---|
//! | [`Listed`](Standing::Listed) | 11 | |
//! | [`OutOfReach`](Standing::OutOfReach) | 15 | gear 2 turns against gear 1, or speeds up, for every k |
//! | [`Missed`](Standing::Missed) | 10 | built by its rule, and fit for its purpose |
//! | [`Reversed`](Standing::Reversed) | 36 | one of the 36 with D and B exchanged: speeds up in gear 1 |
//! | [`OutsideRule`](Standing::OutsideRule) | 39 | set 2 ties T₁ to neither D nor B as the rule has it |
//!
//! No two of the 36 are equal as structures. What distinguishes the eleven is that they split the power and that none of it
//! circulates: [`connection`](crate::connection). In the ten missed some power circulates. Fit for its purpose means: some
//! `k₁`, `k₂` within the range give gears that both slow, in the same direction of rotation. Of the ten missed five do so
//! for every `k₁`, `k₂` with no sign change: see the test below.
//!
//! # Source
//! multispeed-gearboxes, section 2.4.

use crate::pair::{coefficients, fraction};
use crate::structures::{Family, Structure};
use std::fmt;
use std::ops::RangeInclusive;

/// What the ratio of a gear does while both ring-to-sun ratios run over a range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RatioReach {
    /// Every value between these.
    Between {
        /// The least.
        least: f64,
        /// The greatest.
        greatest: f64,
    },
    /// It changes its sign through 0; these are its extremes.
    ThroughZero {
        /// The least.
        least: f64,
        /// The greatest.
        greatest: f64,
    },
    /// It changes its sign through ±∞: every value *outside* these.
    ThroughInfinity {
        /// The greatest below the gap.
        below: f64,
        /// The least above the gap.
        above: f64,
    },
}

/// What the ratios of a structure's gears do while both ring-to-sun ratios run over a range.
///
/// Numerator and denominator are bilinear, so over a rectangle both take their extremes, and show
/// every change of sign, at the corners; and between zeros and poles the ratio is monotonous in each
/// `k`, so it takes its extremes at corners too.
#[must_use]
pub fn reach(structure: Structure, range: &RangeInclusive<f64>) -> [RatioReach; 2] {
    let ends = [*range.start(), *range.end()];
    [0, 1].map(|gear| {
        let corner = |place: usize| {
            let sets = structure.sets();
            let c = [0, 1].map(|set| coefficients(sets[set], ends[place >> set & 1]));
            fraction(&c[0], &c[1], gear)
        };
        let corners = [0, 1, 2, 3].map(corner);
        let values = corners.map(|[n, d]| n / d);
        let changes = |part: usize| {
            corners.iter().any(|corner| corner[part] >= 0.0)
                && corners.iter().any(|corner| corner[part] <= 0.0)
        };
        let least = |values: &mut dyn Iterator<Item = f64>| values.fold(f64::INFINITY, f64::min);
        let greatest = |values: &mut dyn Iterator<Item = f64>| values.fold(f64::NEG_INFINITY, f64::max);
        if changes(1) {
            RatioReach::ThroughInfinity {
                below: greatest(&mut values.into_iter().filter(|i| *i < 0.0)),
                above: least(&mut values.into_iter().filter(|i| *i > 0.0)),
            }
        } else {
            let (least, greatest) = (least(&mut values.into_iter()), greatest(&mut values.into_iter()));
            if changes(0) {
                RatioReach::ThroughZero { least, greatest }
            } else {
                RatioReach::Between { least, greatest }
            }
        }
    })
}

/// Why the document has a structure, or has it not.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Standing {
    /// One of its eleven.
    Listed(&'static str),
    /// By its rule, but gear 2 never slows in the direction of gear 1.
    OutOfReach {
        /// What gear 2 gives instead.
        second: RatioReach,
    },
    /// By its rule and fit for its purpose, yet not listed.
    Missed {
        /// What gear 1 gives.
        first: RatioReach,
        /// What gear 2 gives.
        second: RatioReach,
    },
    /// By its rule once D and B change places; as it stands gear 1 speeds up.
    Reversed {
        /// The structure that slows in gear 1.
        of: Structure,
    },
    /// Not by its rule: no set has both T₁ and T₂ and one of D, B beside a set of D, B, T₁.
    OutsideRule {
        /// How the sets share the work instead.
        family: Family,
    },
}

impl Standing {
    /// Of a structure, the ring-to-sun ratios within a range.
    ///
    /// ```
    /// use epicyclic_schemes::{standing::Standing, structures::{Role::*, Structure}};
    /// let structure = Structure::new([[D, T1, B], [T2, B, T1]]).unwrap();
    /// assert!(matches!(Standing::of(structure, &(1.3..=10.0)), Standing::Missed { .. }));
    /// ```
    #[must_use]
    pub fn of(structure: Structure, range: &RangeInclusive<f64>) -> Self {
        if let Some(name) = structure.scheme() {
            return Self::Listed(name);
        }
        let family = structure.family();
        if matches!(family, Family::Parallel | Family::Serial) {
            return Self::OutsideRule { family };
        }
        let [first, second] = reach(structure, range);
        let (RatioReach::Between { least, greatest }
        | RatioReach::ThroughZero { least, greatest }
        | RatioReach::ThroughInfinity { below: least, above: greatest }) = first;
        // Set 1 alone: its ratio is one of the six of a set, which lie all within ±1 or all outside.
        if least.abs().max(greatest.abs()) < 1.0 {
            return Self::Reversed { of: structure.reversal() };
        }
        let forward = least > 0.0;
        let slows = match second {
            RatioReach::ThroughInfinity { .. } => true,
            RatioReach::Between { least, greatest } | RatioReach::ThroughZero { least, greatest } => {
                if forward {
                    greatest > 1.0
                } else {
                    least < -1.0
                }
            }
        };
        if slows { Self::Missed { first, second } } else { Self::OutOfReach { second } }
    }
}

impl fmt::Display for Standing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Listed(name) => write!(f, "scheme {name}"),
            Self::OutOfReach { second } => write!(f, "out of reach: gear 2 gives {second}"),
            Self::Missed { first, second } => {
                write!(f, "missed by the document: gear 1 gives {first}, gear 2 {second}")
            }
            Self::Reversed { of } => write!(f, "equal to {of} with D and B exchanged"),
            Self::OutsideRule { family: Family::Parallel } => {
                f.write_str("outside the document's rule: set 2 ties T2, not T1, to D and B, and works alone")
            }
            Self::OutsideRule { .. } => {
                f.write_str("outside the document's rule: no set has both D and B, the sets work in series")
            }
        }
    }
}

impl fmt::Display for RatioReach {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Between { least, greatest } => write!(f, "{least:.3} to {greatest:.3}"),
            Self::ThroughZero { least, greatest } => write!(f, "{least:.3} to {greatest:.3}, 0 included"),
            Self::ThroughInfinity { below, above } => write!(f, "below {below:.3} and above {above:.3}"),
        }
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
        assert_eq!(named(|s| matches!(s, Standing::OutOfReach { .. })).len(), 15);
        assert_eq!(named(|s| matches!(s, Standing::Reversed { .. })).len(), 36);
        assert_eq!(named(|s| matches!(s, Standing::OutsideRule { .. })).len(), 39);
        assert_eq!(
            named(|s| matches!(s, Standing::Missed { .. })),
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
    fn five_of_the_missed_slow_in_the_same_direction_whatever_their_ring_to_sun_ratios() {
        let always = |standing: &Standing| match standing {
            Standing::Missed {
                first: RatioReach::Between { least: first, .. },
                second: RatioReach::Between { least: second, .. },
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
        assert!(
            of.iter().all(|structure| !matches!(Standing::of(*structure, &RANGE), Standing::Reversed { .. }))
        );
    }

    proptest! {
        #[test]
        fn reach_holds_every_ratio(a in 1.3..10.0, b in 1.3..10.0) {
            for structure in Structure::all() {
                let sets = structure.sets();
                let ratios = crate::pair::ratios(&coefficients(sets[0], a), &coefficients(sets[1], b));
                for (ratio, reach) in ratios.into_iter().zip(reach(structure, &RANGE)) {
                    let slack = 1e-9 * (1.0 + ratio.abs());
                    let within = match reach {
                        RatioReach::Between { least, greatest } | RatioReach::ThroughZero { least, greatest } => {
                            least - slack <= ratio && ratio <= greatest + slack
                        }
                        RatioReach::ThroughInfinity { below, above } => ratio <= below + slack || ratio >= above - slack,
                    };
                    prop_assert!(within, "{structure} {ratio} {reach:?}");
                }
            }
        }
    }
}

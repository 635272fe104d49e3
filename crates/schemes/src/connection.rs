//! Ways to connect the second set: the 36 ways in which set 2 can tie T₁ to D or to B, and why the source has
//! 11.
//!
//! Gear 1 brakes T₁ and set 1 alone gives `i₁`. Gear 2 frees T₁, brakes T₂ and lets set 2 tie T₁ to one of
//! the shafts at the ratio `i_c`. Every state of set 1 obeys `ω_D = i₁·ω_B + (1 − i₁)·ω_T1`, hence
//!
//! ```text
//! onto B:  i₂   = i₁   + (1 − i₁)·i_c      i_c = ω_T1/ω_B = (i₁ − i₂)/(i₁ − 1)             (2.37)
//! onto D:  1/i₂ = 1/i₁ + (1 − 1/i₁)·i_c    i_c = ω_T1/ω_D = (i₁ − i₂)/(i₂·(i₁ − 1))        (2.38)
//! ```
//!
//! # How many there are
//! Set 1 is used as I, II or III; set 2 ties onto D or onto B. T₁, the shaft and T₂ take the three members of
//! set 2 in 3! = 6 ways, one for each ratio of table 2.2. That is 3·2·6 = 36. No two are the same gearbox:
//! set 1 is the set that holds both D and B, and T₁ is its other member, so sets and brakes cannot be
//! exchanged.
//!
//! # Which of them are the eleven
//! Let `s` be the share of the input power that passes set 1 at the shaft of the loop. For connections onto B
//! `s = i₁/i₂`, where set 1 gives the power `T_B1·ω_B`. For connections onto D `s = i₂/i₁`, where set 1 takes
//! `T_D1·ω_D`. The rest, `1 − s`, passes set 2. Power splits between two parallel branches while `0 < s < 1`.
//! For `s > 1` or `s < 0` one branch carries power back, and [`circulating_power`] gives the amount that
//! circulates.
//!
//! - For `0 < s < 1`, onto B needs `(i₁ − 1)·i_c/i₁ < 0` and onto D `(i₁ − 1)·i_c > 0`. The sign of each of
//!   the six ratios is fixed, so this does not depend on k: 16 of the 36 never circulate power, 20 always do
//!   (or, where the ratio changes its sign, on both sides of the change).
//! - Five of the 16 only speed up, `|i₂| < 1` at every k: I and II onto D with `i_c = 1 + k₂` or
//!   `(1 + k₂)/k₂`, III onto D with `i_c = −k₂`.
//! - **The other eleven are the source's I-1…III-3**: those that split the power and can slow down.
//!
//! The source states neither condition; it says that eleven schemes exist for any pair of ratios. That does
//! not follow from its rule. Six of the 20 that circulate power keep the sign of `i₁` for all k and can slow
//! down, five of them at every k. They lose little while the circulating power is small
//! ([`Use::Slows`](crate::standing::Use::Slows)). Four of those whose ratio changes its sign do so for some
//! k. The others only reverse or speed up.
//!
//! # Source
//! multispeed-gearboxes (2.36)–(2.38), section 2.4.

use crate::Error;
use crate::catalogue::range::limits;
use crate::catalogue::simple_set::{fraction, ring_to_sun_ratio};
use crate::catalogue::{Reach, RingToSunRange, Role, ThreeSpeed, TwoSpeed, with_role};
use crate::pair::{self, coefficients};
use crate::quantity::ConnectionPart;
use crate::structures::{Structure, three_speed_gearbox};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::simple_set::{Member, Mode, RingToSunRatio};
use epicyclic_train::Gearbox;
use std::fmt;

/// The shaft that set 2 ties T₁ to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Shaft {
    /// `D`, the driving one.
    Driving,
    /// `B`, the driven one.
    Driven,
}

impl Shaft {
    /// Shafts of a gearbox: driving and driven.
    pub const ALL: [Self; 2] = [Self::Driving, Self::Driven];

    /// The link of this shaft.
    #[must_use]
    pub const fn role(self) -> Role {
        match self {
            Self::Driving => Role::D,
            Self::Driven => Role::B,
        }
    }
}

/// Superposition in a differential with two members connected: the speed of C over that of the shaft I to
/// which A and Б are tied.
///
/// ```text
/// i_CI = i_CI^A + i_CI^Б = i_CA^Б·i_AI + i_CБ^A·i_БI
/// ```
///
/// | symbol | argument | meaning |
/// |---|---|---|
/// | `i_CA^Б` | `from_a` | ratio from C to A with Б at rest; `i_CБ^A = 1 − i_CA^Б` |
/// | `i_AI`, `i_БI` | `a_tie`, `b_tie` | ratios of the gears that tie A and Б to I |
///
/// # Source
/// multispeed-gearboxes (2.36), the base of (2.37) and (2.38).
#[must_use]
pub fn superposed_ratio(from_a: f64, a_tie: f64, b_tie: f64) -> f64 {
    from_a * a_tie + (1.0 - from_a) * b_tie
}

/// Ratio of gear 2 from that of gear 1 and the connection ratio: (2.37) and (2.38).
///
/// # Errors
/// [`Error::ConnectionRatio`] for `i₁` of 0 or 1 and what is not finite; for an `i_c` that brings the
/// output to rest.
pub fn second_ratio(shaft: Shaft, first: f64, connection: f64) -> Result<f64, Error> {
    let first = stage_one(first)?;
    let second = match shaft {
        Shaft::Driven => superposed_ratio(first, 1.0, connection),
        Shaft::Driving => 1.0 / superposed_ratio(1.0 / first, 1.0, connection),
    };
    if second.is_finite() { Ok(second) } else { Err(refused(ConnectionPart::Connection, connection)) }
}

/// The connection ratio `i_c` that a pair of ratios needs: (2.37) and (2.38).
///
/// ```
/// use epicyclic_schemes::connection::{Shaft, connection_ratio, second_ratio};
/// # fn main() -> Result<(), epicyclic_schemes::Error> {
/// let connection = connection_ratio(Shaft::Driven, 1.465, 2.56)?;
/// assert!((connection - -2.354_838_71).abs() < 1e-8); // −k₂ of II-3
/// assert!((second_ratio(Shaft::Driven, 1.465, connection)? - 2.56).abs() < 1e-12);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// [`Error::ConnectionRatio`] for `i₁` of 0 or 1, `i₂` of 0, and what is not finite.
pub fn connection_ratio(shaft: Shaft, first: f64, second: f64) -> Result<f64, Error> {
    let first = stage_one(first)?;
    if second == 0.0 || !second.is_finite() {
        return Err(refused(ConnectionPart::SecondGear, second));
    }
    let onto_b = (first - second) / (first - 1.0);
    Ok(match shaft {
        Shaft::Driven => onto_b,
        Shaft::Driving => onto_b / second,
    })
}

fn stage_one(ratio: f64) -> Result<f64, Error> {
    if ratio.is_finite() && ratio != 0.0 && ratio != 1.0 {
        Ok(ratio)
    } else {
        Err(refused(ConnectionPart::FirstGear, ratio))
    }
}

fn refused(what: ConnectionPart, ratio: f64) -> Error {
    Error::ConnectionRatio { what, ratio }
}

/// Circulating power in the loop of gear 2, as a part of the input power, without losses.
///
/// ```text
/// s = i₁/i₂ (onto B)    s = i₂/i₁ (onto D)      circulating = max(0, s − 1, −s)
/// ```
#[must_use]
pub fn circulating_power(shaft: Shaft, first: f64, second: f64) -> f64 {
    let share = match shaft {
        Shaft::Driven => first / second,
        Shaft::Driving => second / first,
    };
    (share - 1.0).max(-share).max(0.0)
}

/// One of the 36 ways to connect the second set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Connection {
    first: TwoSpeed,
    shaft: Shaft,
    mode: Mode,
}

impl Connection {
    /// Connections: 36, by scheme of set 1, by shaft, by ratio of table 2.2.
    #[must_use]
    pub fn all() -> Vec<Self> {
        let mut all = Vec::with_capacity(36);
        for first in TwoSpeed::ALL {
            for shaft in Shaft::ALL {
                all.extend(Mode::ALL.map(|mode| Self { first, shaft, mode }));
            }
        }
        all
    }

    /// The connection that a structure is; `None` of one that is not built by the rule.
    #[must_use]
    pub fn of_structure(structure: Structure) -> Option<Self> {
        let [first, second] = structure.sets();
        let first = TwoSpeed::of_set(first)?;
        let shafts = Shaft::ALL.map(|shaft| (shaft, second.contains(&shaft.role())));
        let shaft = match shafts {
            [(shaft, true), (_, false)] | [(_, false), (shaft, true)] => shaft,
            _ => return None,
        };
        let mode = Mode::new(with_role(second, Role::T1)?, with_role(second, shaft.role())?).ok()?;
        Some(Self { first, shaft, mode })
    }

    /// The structure that it is; set 1 has D and B, so the labels of its links stay.
    #[must_use]
    pub fn structure(self) -> Structure {
        Structure::new(self.sets()).unwrap_or_else(|| unreachable!("the 36 are structures, by test"))
    }

    /// Scheme of set 1.
    #[must_use]
    pub fn first_stage(self) -> TwoSpeed {
        self.first
    }

    /// The shaft that T₁ is tied to.
    #[must_use]
    pub fn shaft(self) -> Shaft {
        self.shaft
    }

    /// The ratio of table 2.2 that `i_c` is: T₁ "drives" set 2, the shaft is "driven", T₂ rests.
    #[must_use]
    pub fn mode(self) -> Mode {
        self.mode
    }

    /// Links of `a b H` of sets 1 and 2.
    #[must_use]
    pub fn sets(self) -> [[Role; 3]; 2] {
        let second = Member::ALL.map(|member| match member {
            _ if member == self.mode.input() => Role::T1,
            _ if member == self.mode.output() => self.shaft.role(),
            _ => Role::T2,
        });
        [self.first.set(), second]
    }

    /// Ratio `i₂` as a fraction whose parts are linear in each of `k₁`, `k₂`.
    fn fraction(self, k1: f64, k2: f64) -> [f64; 2] {
        let [first, second] = self.sets();
        pair::fraction(&coefficients(first, k1), &coefficients(second, k2), 1)
    }

    /// Ratio `i₂ = ω_D/ω_B` with T₂ braked; infinite where the output rests, 0 where the input is blocked.
    #[must_use]
    pub fn ratio(self, k1: RingToSunRatio, k2: RingToSunRatio) -> f64 {
        let [n, d] = self.fraction(k1.get(), k2.get());
        n / d
    }

    /// Values of the ratio while both ring-to-sun ratios run over a range.
    #[must_use]
    pub fn reach(self, range: RingToSunRange) -> Reach {
        Reach::of(|k1, k2| self.fraction(k1, k2), range.ends())
    }

    /// Ring-to-sun ratio of set 2 for a ratio of gear 2, that of set 1 being known.
    ///
    /// # Errors
    /// [`Error::RatioOutOfReach`] with the ratios at `k₂ → 1` and `k₂ → ∞`.
    pub fn second_ring_to_sun_ratio(self, k1: RingToSunRatio, ratio: f64) -> Result<RingToSunRatio, Error> {
        let needed = connection_ratio(self.shaft, self.first.ratio(k1), ratio).ok();
        needed.and_then(|needed| ring_to_sun_ratio(self.mode, needed).ok()).ok_or_else(|| {
            let [low, high] = limits(|k2| self.fraction(k1.get(), k2));
            Error::RatioOutOfReach { scheme: format!("gear 2 of {self}"), ratio, low, high }
        })
    }

    /// The source's scheme that it is.
    #[must_use]
    pub fn listed(self) -> Option<ThreeSpeed> {
        self.structure().scheme()
    }

    /// Whether power never circulates: `0 < s < 1`, which depends on signs alone.
    #[must_use]
    pub fn splits_power(self) -> bool {
        // i₁ > 1 of I and II, i₁ < 0 of III.
        let reverses = self.first.sign() < 0.0;
        let negative = fraction(self.mode, 2.0)[0] < 0.0;
        match self.shaft {
            Shaft::Driven => negative,
            Shaft::Driving => negative == reverses,
        }
    }

    /// The connection as a gearbox with gears `1`, `2` and `direct`.
    ///
    /// # Errors
    /// None of ring-to-sun ratios: what the solver would refuse is refused before.
    pub fn gearbox(
        self,
        k1: RingToSunRatio,
        k2: RingToSunRatio,
        eta0: MeshEfficiency,
    ) -> Result<Gearbox, Error> {
        three_speed_gearbox(&self.to_string(), self.sets(), [k1, k2], eta0)
    }
}

impl fmt::Display for Connection {
    /// `I onto B by ba^H`: set 1, shaft, ratio of set 2 from T₁ to the shaft.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} onto {} by {}", self.first, self.shaft.role(), self.mode)
    }
}

impl ThreeSpeed {
    /// Connection of set 2: see [this module](self).
    #[must_use]
    pub fn connection(self) -> Connection {
        Connection::of_structure(self.structure())
            .unwrap_or_else(|| unreachable!("the eleven are among the 36, by test"))
    }

    /// Ring-to-sun ratio of set 2 for a ratio of gear 2, that of set 1 being known.
    ///
    /// The connection ratio follows from (2.37) or (2.38), and `k₂` from it as from any ratio of table 2.2.
    /// Examples: for II-3 `k₂ = i₂·k₁ − k₁ − 1`, for III-1 `k₂ = −i₂(k₁ + 1)/(k₁ + i₂)`.
    ///
    /// # Errors
    /// [`Error::RatioOutOfReach`] with what `k₂ > 1` gives at this `k₁`.
    pub fn second_ring_to_sun_ratio(self, k1: RingToSunRatio, ratio: f64) -> Result<RingToSunRatio, Error> {
        self.connection().second_ring_to_sun_ratio(k1, ratio).map_err(|error| match error {
            Error::RatioOutOfReach { ratio, low, high, .. } => {
                Error::RatioOutOfReach { scheme: format!("gear 2 of {self}"), ratio, low, high }
            }
            other => other,
        })
    }

    /// Least and greatest ratio of gear 2 while both ring-to-sun ratios run over a range.
    #[must_use]
    pub fn ratio_range(self, range: RingToSunRange) -> [f64; 2] {
        match self.connection().reach(range) {
            Reach::Between { least, greatest } => [least, greatest],
            Reach::ThroughZero { .. } | Reach::ThroughInfinity { .. } => {
                unreachable!("numerators and denominators of the eleven keep their sign for k above 1")
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::standing::{Standing, Use};
    use proptest::prelude::*;

    fn k(value: f64) -> RingToSunRatio {
        RingToSunRatio::new(value).unwrap()
    }

    fn counted(range: RingToSunRange, wanted: impl Fn(Standing) -> bool) -> usize {
        Connection::all().into_iter().filter(|connection| wanted(connection.standing(range))).count()
    }

    #[test]
    fn thirty_six_are_eleven_five_and_twenty() {
        let only_speeds_up =
            |s| matches!(s, Standing::Unlisted { usage: Use::OnlySpeedsUp, splits_power: true, .. });
        for range in [RingToSunRange::USED, RingToSunRange::RECOMMENDED] {
            assert_eq!(Connection::all().len(), 36);
            assert_eq!(counted(range, |s| matches!(s, Standing::Listed(_))), 11);
            assert_eq!(counted(range, only_speeds_up), 5);
            assert_eq!(counted(range, |s| matches!(s, Standing::Unlisted { splits_power: false, .. })), 20);
            assert_eq!(counted(range, |s| matches!(s, Standing::Unlisted { .. })), 25);
        }
    }

    #[test]
    fn a_connection_and_its_structure_are_one() {
        for connection in Connection::all() {
            assert_eq!(connection.structure().sets(), connection.sets());
            assert_eq!(Connection::of_structure(connection.structure()), Some(connection));
            assert_eq!(Connection::of_structure(connection.structure().reversal()), None);
        }
        let of_the_rule = Structure::all().into_iter().filter_map(Connection::of_structure);
        assert_eq!(of_the_rule.count(), 36);
        for scheme in ThreeSpeed::ALL {
            assert_eq!(scheme.connection().listed(), Some(scheme));
            assert_eq!(scheme.connection().first_stage(), scheme.first_stage());
        }
    }

    #[test]
    fn the_eleven_are_those_that_split_power_and_can_slow_down() {
        for connection in Connection::all() {
            let slows = connection.reach(RingToSunRange::USED).slows();
            assert_eq!(connection.listed().is_some(), connection.splits_power() && slows, "{connection}");
        }
    }

    #[test]
    fn four_of_those_that_change_sign_serve_for_some_ring_to_sun_ratios() {
        let corners = RingToSunRange::USED.ends();
        let serves = |connection: &Connection| {
            let some = |k1: f64, k2: f64| {
                let (ratio, first) = (connection.ratio(k(k1), k(k2)), connection.first_stage().ratio(k(k1)));
                ratio * first > 0.0 && ratio.abs() > 1.0
            };
            corners.iter().any(|k1| corners.iter().any(|k2| some(*k1, k2 * 1.01)))
        };
        let all = Connection::all();
        let changing = |connection: &&Connection| connection.reach(RingToSunRange::USED).sign().is_none();
        let of_them: Vec<_> = all.iter().filter(changing).collect();
        assert_eq!(of_them.len(), 6);
        for connection in of_them {
            let usage = match connection.standing(RingToSunRange::USED) {
                Standing::Unlisted { usage, .. } => usage,
                other => panic!("{connection}: {other:?}"),
            };
            let expected = if serves(connection) { Use::SlowsAtSome } else { Use::ChangesSign };
            assert_eq!(usage, expected, "{connection}");
        }
        assert_eq!(all.iter().filter(changing).filter(|connection| serves(connection)).count(), 4);
    }

    #[test]
    fn no_two_are_the_same_gearbox() {
        // Set 1 has D and B, set 2 has not: sets can only stay, and so can the brakes.
        let all = Connection::all();
        for (place, one) in all.iter().enumerate() {
            let [first, second] = one.sets();
            assert!(first.contains(&Role::D) && first.contains(&Role::B) && first.contains(&Role::T1));
            assert!(second.contains(&Role::T2) && second.contains(&Role::T1));
            assert!(all[..place].iter().all(|other| other.sets() != one.sets()));
        }
    }

    #[test]
    fn one_the_source_misses_serves_its_own_excavator() {
        // i₁ = 2.56 by I with k₁ = 1.56, i₂ = 1.465 by tying H₂ = T₁ to b₂ = B.
        let structure = Structure::new([[Role::D, Role::T1, Role::B], [Role::T2, Role::B, Role::T1]]);
        let missed = structure.and_then(Connection::of_structure).unwrap();
        assert!(missed.standing(RingToSunRange::RECOMMENDED).is_missed());
        let (k1, eta0) = (k(1.56), MeshEfficiency::new(0.97).unwrap());
        let k2 = missed.second_ring_to_sun_ratio(k1, 1.465).unwrap();
        assert!((k2.get() - (1.56 / 0.465 - 1.0)).abs() < 1e-12);
        let gearbox = missed.gearbox(k1, k2, eta0).unwrap();
        for (gear, ratio) in [("1", 2.56), ("2", 1.465)] {
            let found = gearbox.analyze(gear).unwrap();
            assert!((found.ratio().unwrap() - ratio).abs() < 1e-12);
            assert!(found.efficiency().unwrap() > 0.98);
        }
    }

    #[test]
    fn a_pair_of_ratios_has_at_most_one_connection_of_each_scheme_and_shaft() {
        // The six ratios of a set do not overlap for k above 1.3.
        let ranges =
            Mode::ALL.map(|m| crate::catalogue::simple_set::ratio_range(m, RingToSunRange::RECOMMENDED));
        for (place, one) in ranges.iter().enumerate() {
            let [low, high] = [one[0].min(one[1]), one[0].max(one[1])];
            for other in &ranges[..place] {
                assert!(other[0].max(other[1]) < low || other[0].min(other[1]) > high);
            }
        }
    }

    #[test]
    fn ratios_that_connect_nothing_are_refused() {
        assert!(connection_ratio(Shaft::Driven, 1.0, 2.0).is_err());
        assert!(connection_ratio(Shaft::Driving, 2.0, 0.0).is_err());
        assert!(second_ratio(Shaft::Driving, 2.0, -1.0).is_err());
        assert!(second_ratio(Shaft::Driven, f64::NAN, 1.0).is_err());
    }

    proptest! {
        #[test]
        fn connections_equal_the_solver(a in 1.3..10.0, b in 1.3..10.0) {
            for connection in Connection::all() {
                let ratio = connection.ratio(k(a), k(b));
                if !(1e-3..1e3).contains(&ratio.abs()) {
                    continue; // too near the output's or the input's rest to compare to the last digits
                }
                let gearbox = connection.gearbox(k(a), k(b), MeshEfficiency::IDEAL).unwrap();
                let gear = gearbox.analyze("2").unwrap();
                let scale = 1e-12 * ratio.abs() * (1.0 + 1.0 / ratio.abs() + ratio.abs());
                prop_assert!((gear.ratio().unwrap() - ratio).abs() < scale, "{}", connection);
                let first = connection.first_stage().ratio(k(a));
                let around = circulating_power(connection.shaft(), first, ratio);
                let found = gear.ideal().unwrap().power.circulating;
                prop_assert!((found - around).abs() < 1e-9 * (1.0 + around), "{} {} {}", connection, found, around);
                prop_assert_eq!(connection.splits_power(), around == 0.0);
                let needed = crate::catalogue::simple_set::ratio_range(
                    connection.mode(), RingToSunRange::new(b, b).unwrap())[0];
                let second = second_ratio(connection.shaft(), first, needed).unwrap();
                prop_assert!((second - ratio).abs() < 1e-9 * ratio.abs() * (1.0 + ratio.abs() + 1.0 / ratio.abs()));
            }
        }

        #[test]
        fn superposition_is_the_set_itself(value in 1.3..10.0_f64, sun in -3.0..3.0_f64, ring in -3.0..3.0_f64) {
            // C = H, A = a, Б = b tied to I (ω_I = 1) at these ratios.
            let carrier = superposed_ratio(1.0 / (1.0 + value), sun, ring);
            prop_assert!((carrier * (1.0 + value) - sun - value * ring).abs() < 1e-12 * 40.0);
        }
    }
}

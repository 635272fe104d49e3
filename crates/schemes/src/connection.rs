//! The ways to connect the second set: all 36 ways in which set 2 can tie T₁ to D or to B, and why the source has 11.
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
//! Set 1 is used as I, II or III; set 2 ties onto D or onto B; T₁, the shaft and T₂ take the three members of
//! set 2 in 3! = 6 ways, one for each ratio of table 2.2. That is 3·2·6 = 36, and no two are the same gearbox:
//! set 1 is the set that holds both D and B, T₁ is the other member of it, so sets and brakes cannot be
//! exchanged.
//!
//! # Which of them are the eleven
//! Let `s` be the share of the input power that passes set 1 at the shaft of the loop: `s = i₁/i₂` of connections
//! onto B, where set 1 gives the power `T_B1·ω_B`; `s = i₂/i₁` of connections onto D, where set 1 takes
//! `T_D1·ω_D`. The rest, `1 − s`, passes set 2. Power splits between two parallel branches while `0 < s < 1`;
//! for `s > 1` or `s < 0` one branch carries power back, and [`circulating_power`] gives the amount that circulates.
//!
//! - For `0 < s < 1`, onto B needs `(i₁ − 1)·i_c/i₁ < 0` and onto D `(i₁ − 1)·i_c > 0`. The sign of each of the
//!   six ratios is fixed, so this does not depend on k: 16 of the 36 never circulate power, 20 always do
//!   (or, where the ratio changes its sign, on both sides of the change).
//! - Five of the 16 only speed up, `|i₂| < 1` at every k: I and II onto D with `i_c = 1 + k₂` or
//!   `(1 + k₂)/k₂`, III onto D with `i_c = −k₂`.
//! - **The other eleven are the source's I-1…III-3**: those that split the power and can slow down.
//!
//! The source states neither condition; it says that eleven schemes exist for any pair of ratios. That does not
//! follow from its rule. Of the 20 that circulate power six keep the sign of `i₁` for all k and can slow down
//! (five of them do at every k), and lose little while the circulating power is small ([`Use::Slows`]); four of those whose ratio
//! changes its sign do so for some k; the others only reverse or speed up.
//!
//! # Source
//! multispeed-gearboxes (2.36)–(2.38), section 2.4.

use crate::DesignError;
use crate::catalogue::simple_set::{fraction, ring_to_sun_ratio};
use crate::catalogue::{Reach, RingToSunRange, Role, ThreeSpeed, TwoSpeed, gearbox};
use crate::quantity::ConnectionPart;
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
    /// Both.
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

/// Superposition in a differential with two members connected: the speed of C over that of the shaft I to which A and Б
/// are tied.
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
/// [`DesignError::ConnectionRatio`] for `i₁` of 0 or 1 and what is not finite; for an `i_c` that brings the
/// output to rest.
pub fn second_ratio(shaft: Shaft, first: f64, connection: f64) -> Result<f64, DesignError> {
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
/// # fn main() -> Result<(), epicyclic_schemes::DesignError> {
/// let connection = connection_ratio(Shaft::Driven, 1.465, 2.56)?;
/// assert!((connection - -2.354_838_71).abs() < 1e-8); // −k₂ of II-3
/// assert!((second_ratio(Shaft::Driven, 1.465, connection)? - 2.56).abs() < 1e-12);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// [`DesignError::ConnectionRatio`] for `i₁` of 0 or 1, `i₂` of 0, and what is not finite.
pub fn connection_ratio(shaft: Shaft, first: f64, second: f64) -> Result<f64, DesignError> {
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

fn stage_one(ratio: f64) -> Result<f64, DesignError> {
    if ratio.is_finite() && ratio != 0.0 && ratio != 1.0 {
        Ok(ratio)
    } else {
        Err(refused(ConnectionPart::FirstGear, ratio))
    }
}

fn refused(what: ConnectionPart, ratio: f64) -> DesignError {
    DesignError::ConnectionRatio { what, ratio }
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

/// What becomes of a connection over a range of ring-to-sun ratios.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Standing {
    /// The source has it: power splits, and it can slow down.
    Listed(ThreeSpeed),
    /// Power splits, but `|i₂| < 1` at every k, while `i₁` slows down: the source calls slowing mixed with
    /// speeding unfavourable.
    OnlySpeedsUp,
    /// Power circulates at every k; the source passes it over without saying so.
    Circulates(Use),
}

/// What a connection that circulates power could be used for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Use {
    /// Its ratio has the sign of `i₁` at every k and can slow down: *missed by the source*.
    Slows,
    /// Its ratio has the sign of `i₁` but `|i₂| < 1` throughout.
    OnlySpeedsUp,
    /// Its ratio has the other sign than `i₁`: a reverse gear, with `|i₂| > 1` in part of the range or not.
    Reverses,
    /// Its ratio changes sign within the range: whether it drives forward, backward or not at all depends on k.
    ChangesSign,
}

impl Connection {
    /// All 36: by scheme of set 1, by shaft, by ratio of table 2.2.
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

    /// The connection whose set 2 has its members `[a, b, H]` at these links.
    pub(crate) fn of_set(first: TwoSpeed, shaft: Shaft, set: [Role; 3]) -> Self {
        let is = |connection: &Self| {
            connection.first == first && connection.shaft == shaft && connection.sets()[1] == set
        };
        Self::all().into_iter().find(is).unwrap_or_else(|| unreachable!("sets of T1, T2 and the shaft"))
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
        let [n1, d1] = self.first.fraction(k1);
        let [nc, dc] = fraction(self.mode, k2);
        match self.shaft {
            Shaft::Driven => [n1 * dc + (d1 - n1) * nc, d1 * dc],
            Shaft::Driving => [n1 * dc, d1 * dc + (n1 - d1) * nc],
        }
    }

    /// Ratio `i₂ = ω_D/ω_B` with T₂ braked; infinite where the output rests, 0 where the input is blocked.
    #[must_use]
    pub fn ratio(self, k1: RingToSunRatio, k2: RingToSunRatio) -> f64 {
        let [n, d] = self.fraction(k1.get(), k2.get());
        n / d
    }

    /// What the ratio does while both ring-to-sun ratios run over a range.
    #[must_use]
    pub fn reach(self, range: RingToSunRange) -> Reach {
        Reach::of(|k1, k2| self.fraction(k1, k2), range)
    }

    /// Ring-to-sun ratio of set 2 for a ratio of gear 2, that of set 1 being known.
    ///
    /// # Errors
    /// [`DesignError::RatioOutOfReach`] with the ratios at `k₂ → 1` and `k₂ → ∞`.
    pub fn second_ring_to_sun_ratio(
        self,
        k1: RingToSunRatio,
        ratio: f64,
    ) -> Result<RingToSunRatio, DesignError> {
        let needed = connection_ratio(self.shaft, self.first.ratio(k1), ratio).ok();
        needed.and_then(|needed| ring_to_sun_ratio(self.mode, needed).ok()).ok_or_else(|| {
            let at = |k2: f64| {
                let [n, d] = self.fraction(k1.get(), k2);
                n / d
            };
            // The fraction's parts are linear in k₂: its limit is the ratio of their slopes.
            let [from, to] = [self.fraction(k1.get(), 1.0), self.fraction(k1.get(), 2.0)];
            let limit = (to[0] - from[0]) / (to[1] - from[1]);
            let (low, high) = (at(1.0).min(limit), at(1.0).max(limit));
            DesignError::RatioOutOfReach { scheme: format!("gear 2 of {self}"), ratio, low, high }
        })
    }

    /// The source's scheme that it is.
    #[must_use]
    pub fn listed(self) -> Option<ThreeSpeed> {
        ThreeSpeed::ALL.into_iter().find(|scheme| scheme.sets() == self.sets())
    }

    /// Whether power never circulates: `0 < s < 1`, which depends on signs alone.
    #[must_use]
    pub fn splits_power(self) -> bool {
        // i₁ > 1 of I and II, i₁ < 0 of III.
        let reverses = self.first == TwoSpeed::III;
        let negative = fraction(self.mode, 2.0)[0] < 0.0;
        match self.shaft {
            Shaft::Driven => negative,
            Shaft::Driving => negative == reverses,
        }
    }

    /// What becomes of it over a range of ring-to-sun ratios.
    #[must_use]
    pub fn standing(self, range: RingToSunRange) -> Standing {
        if let Some(scheme) = self.listed() {
            return Standing::Listed(scheme);
        }
        let reach = self.reach(range);
        let sign = if self.first == TwoSpeed::III { -1.0 } else { 1.0 };
        match reach {
            _ if self.splits_power() => Standing::OnlySpeedsUp,
            Reach::ThroughZero | Reach::ThroughInfinity => Standing::Circulates(Use::ChangesSign),
            _ if !reach.has_sign_of(sign) => Standing::Circulates(Use::Reverses),
            _ if reach.slows() => Standing::Circulates(Use::Slows),
            _ => Standing::Circulates(Use::OnlySpeedsUp),
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
    ) -> Result<Gearbox, DesignError> {
        let [first, second] = self.sets();
        Ok(gearbox(&self.to_string(), &[(first, k1), (second, k2)], eta0)?)
    }
}

impl fmt::Display for Connection {
    /// `I onto B by ba^H`: set 1, shaft, ratio of set 2 from T₁ to the shaft.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} onto {} by {}", self.first, self.shaft.role(), self.mode)
    }
}

impl fmt::Display for Standing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Listed(scheme) => write!(f, "scheme {scheme}"),
            Self::OnlySpeedsUp => f.write_str("not listed: only speeds up"),
            Self::Circulates(usage) => {
                f.write_str("not listed: power circulates; ")?;
                f.write_str(match usage {
                    Use::Slows => "slows down with the sign of stage 1",
                    Use::OnlySpeedsUp => "only speeds up",
                    Use::Reverses => "reverses stage 1",
                    Use::ChangesSign => "changes its sign within the range",
                })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn k(value: f64) -> RingToSunRatio {
        RingToSunRatio::new(value).unwrap()
    }

    fn counted(range: RingToSunRange, wanted: impl Fn(Standing) -> bool) -> usize {
        Connection::all().into_iter().filter(|connection| wanted(connection.standing(range))).count()
    }

    #[test]
    fn thirty_six_are_eleven_five_and_twenty() {
        for range in [RingToSunRange::USED, RingToSunRange::RECOMMENDED] {
            assert_eq!(Connection::all().len(), 36);
            assert_eq!(counted(range, |s| matches!(s, Standing::Listed(_))), 11);
            assert_eq!(counted(range, |s| s == Standing::OnlySpeedsUp), 5);
            assert_eq!(counted(range, |s| matches!(s, Standing::Circulates(_))), 20);
        }
        let used = RingToSunRange::USED;
        let of = |usage| counted(used, |s| s == Standing::Circulates(usage));
        assert_eq!(of(Use::Slows), 6);
        let all = of(Use::OnlySpeedsUp) + of(Use::Reverses) + of(Use::ChangesSign);
        assert_eq!(all, 14);
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
        let changing = Standing::Circulates(Use::ChangesSign);
        let all = Connection::all();
        let of_them: Vec<_> = all.iter().filter(|c| c.standing(RingToSunRange::USED) == changing).collect();
        assert_eq!(of_them.len(), 6);
        assert_eq!(of_them.into_iter().filter(|connection| serves(connection)).count(), 4);
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
        let missed = Connection::of_set(TwoSpeed::I, Shaft::Driven, [Role::T2, Role::B, Role::T1]);
        assert_eq!(missed.standing(RingToSunRange::RECOMMENDED), Standing::Circulates(Use::Slows));
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

//! Profile shifts with which sun, planets and ring of given teeth share a centre distance, and the choice
//! among them by an aim.
//!
//! At a centre distance the sum of the shifts in each mesh is fixed, so that one of the three shifts is free:
//!
//! ```text
//! x_s + x_p = S_1 = (z_s + z_p)·(inv α_w1 − inv α_t)/(2·tan α_n)
//! cos α_w1 = (z_s + z_p)·cos α_t/(2·a·cos β)
//! x_p + x_r = S_2 = (z_p + z_r)·(inv α_w2 − inv α_t)/(2·tan α_n)      z_r and a below 0 in this line
//! x_p = S_1 − x_s,    x_r = S_2 − S_1 + x_s
//! ```
//!
//! This holds whether or not `z_r = z_s + 2·z_p`.
//!
//! # Tips
//! The tips of sun and planets are shortened by `k = a − a_d − S_1` for the clearance of the basic rack. The
//! free shift does not change this value. A tip that would still reach into the fillet of a mate is shortened
//! further, to where the involute of the mate ends. With fillets by a rack of `h_FfP* = h_aP*` this is always
//! necessary for the tips of a ring without shift. It does not reduce the contact ratio.
//!
//! # Centre distance
//! [`natural_centre_distance`] is the one at which the meshes depart least from the clearance of the basic
//! rack. Two values are 0 or more and convex in `a`: the alteration `−k` of the sun–planet mesh and the
//! additional clearance `|a_d| − a − S_2` of the planet–ring mesh. Their sum is minimized. Their derivatives
//! are `sin α_w1/sin α_t − 1` and `sin α_w2/sin α_t − 1`, so the minimum is where
//!
//! ```text
//! sin α_w1 + sin α_w2 = 2·sin α_t
//! ```
//!
//! Without an offset of the ring it is `(z_s + z_p)/(2·cos β)`; both values are then 0.
//!
//! # Aims
//! [`Aim`] picks the free shift. If the set that it picks has a fault, the nearest set without faults is
//! taken instead, and [`Choice::limited_by`] names the fault.
//!
//! # Source
//! Derived from the formulas of the [module](super). The course example 21/43/108 and the stages of the NREL
//! and DTU wind gearboxes are members of their families to the printed digits.

use super::check::{Check, Place, Rule};
use super::fault::ShiftFault;
use super::gear::InvoluteGear;
use super::pair::Pair;
use super::profile::{Profile, Profiles};
use super::set::{Limits, PlanetSet};
use crate::gear_kind::GearKind;
use crate::quantity::SimpleGear;
use crate::tolerance::TOUCH;
use crate::{Error, Quantity, ToothCount};
use epicyclic_numerics::roots::{bisected, bracketed};
use epicyclic_units::Physical;
use std::ops::RangeInclusive;

/// Aim by which the free shift is picked.
///
/// With balanced sliding tips are shortened for clearance and fillets alone. With the least tip alteration
/// tips of all gears are shortened as little as clearance, tip thickness and the fillets of their mates
/// allow, by the sum of the three. The search starts at the best of 64 equal steps of the range. Among shifts
/// with equal sums the one with balanced sliding is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema, clap::ValueEnum))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "ShiftAim"))]
pub enum Aim {
    /// Equal specific sliding at the roots of sun and planets.
    #[default]
    #[cfg_attr(feature = "names", value(name = "sliding"))]
    BalancedSliding,
    /// Least tip alteration.
    #[cfg_attr(feature = "names", value(name = "tip-alteration"))]
    LeastTipAlteration,
}

/// Sun, planets and ring of given teeth at a centre distance: all shifts without backlash. Lengths in
/// modules.
///
/// ```
/// use epicyclic_gears::ToothCount;
/// use epicyclic_gears::involute::Profile;
/// use epicyclic_gears::involute::family::{Aim, Family};
/// use epicyclic_gears::involute::set::Limits;
/// # fn main() -> Result<(), epicyclic_gears::Error> {
/// let teeth = [ToothCount::new(18)?, ToothCount::new(36)?, ToothCount::new(93)?];
/// let family = Family::new(teeth, 3, Profile::default(), 584.0 / 21.0)?;
/// let [sun_planet, planet_ring] = family.sums();
/// assert!((sun_planet - 0.8929).abs() < 5e-5 && (planet_ring - 0.6210).abs() < 5e-5);
/// let balanced = family.choose(Aim::BalancedSliding, &Limits::default())?;
/// let [[_, sun_root], [_, planet_root]] = balanced.set.sun_mesh().specific_sliding();
/// assert!((sun_root - planet_root).abs() < 1e-9);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Family {
    gears: [InvoluteGear; 3],
    planets: u32,
    centre_distance: f64,
    sums: [f64; 2],
    tip_alteration: f64,
}

/// The set that an aim picked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Choice {
    /// The set, free of faults.
    pub set: PlanetSet,
    /// The check that keeps the aim from being met in full; `None` where it is met.
    pub limited_by: Option<Check>,
}

/// Parts into which the range of shifts is cut where the set that meets an aim has a fault. A stretch without
/// faults that is shorter than a part may be missed.
pub(super) const PARTS: u32 = 64;

/// Halvings of a stretch: below the rounding of its ends.
const HALVINGS: u32 = 52;

impl Family {
    /// The family of sun, planet and ring at a centre distance.
    ///
    /// # Errors
    /// [`Error::NotAbove`] or [`Error::OutOfRange`] for a centre distance out of reach of a mesh; those of
    /// [`Profile::check`] and [`Pair::at_centre_distance`]; [`Error::TooFew`] for no planets.
    pub fn new(
        teeth: [ToothCount; 3],
        planets: u32,
        profiles: impl Into<Profiles>,
        centre_distance: f64,
    ) -> Result<Self, Error> {
        let profiles = profiles.into();
        let kinds = [GearKind::External, GearKind::External, GearKind::Internal];
        let gear = |place: usize| InvoluteGear::searched(kinds[place], teeth[place], profiles.0[place]);
        let gears = [gear(0)?, gear(1)?, gear(2)?];
        // Names what is wrong with the planets and the centre distance.
        let set = PlanetSet::new(gears, planets, centre_distance)?;
        let sums = [
            Pair::shift_sum(&gears[0], &gears[1], centre_distance)?,
            Pair::shift_sum(&gears[1], &gears[2], centre_distance)?,
        ];
        let tip_alteration = centre_distance - set.sun_mesh().reference_centre_distance() - sums[0];
        Ok(Self { gears, planets, centre_distance, sums, tip_alteration })
    }

    /// Sums of the shifts, `S_1` of sun and planet, `S_2` of planet and ring.
    #[must_use]
    pub const fn sums(&self) -> [f64; 2] {
        self.sums
    }

    /// Tip alteration `k` of sun and planets for clearance in their mesh, 0 or less.
    #[must_use]
    pub const fn tip_alteration(&self) -> f64 {
        self.tip_alteration
    }

    /// Shifts of sun, planets and ring from that of the sun.
    #[must_use]
    pub fn shifts(&self, sun_shift: f64) -> [f64; 3] {
        let [outer, inner] = self.sums;
        [sun_shift, outer - sun_shift, inner - outer + sun_shift]
    }

    /// The set with a shift of the sun, its tips shortened for clearance and fillets.
    ///
    /// # Errors
    /// [`Error::ShiftOutOfRange`] where a gear has no teeth left.
    pub fn at(&self, sun_shift: f64) -> Result<PlanetSet, Error> {
        Ok(self.cleared(sun_shift)?)
    }

    /// Set by [`at`](Self::at); its error also names the gear that has no teeth left.
    fn cleared(&self, sun_shift: f64) -> Result<PlanetSet, Refused> {
        self.with_tips(sun_shift, self.clear_tips(sun_shift))
    }

    fn with_tips(&self, sun_shift: f64, tips: [f64; 3]) -> Result<PlanetSet, Refused> {
        let shifts = self.shifts(sun_shift);
        let gear = |place: usize, gear| {
            let altered = self.gears[place].altered(shifts[place], tips[place]).checked();
            altered.map_err(|error| Refused { gear: Some(gear), error })
        };
        let gears = [gear(0, SimpleGear::Sun)?, gear(1, SimpleGear::Planet)?, gear(2, SimpleGear::Ring)?];
        PlanetSet::new(gears, self.planets, self.centre_distance)
            .map_err(|error| Refused { gear: None, error })
    }

    /// Shifts of the sun with which neither sun nor planets are undercut; an empty range if there are no such
    /// shifts.
    #[must_use]
    pub fn without_undercut(&self) -> RangeInclusive<f64> {
        let [sun, planet, _] = &self.gears;
        let least = |gear: &InvoluteGear| gear.least_shift_without_undercut().unwrap_or(f64::NEG_INFINITY);
        least(sun)..=self.sums[0] - least(planet)
    }

    /// The set that an aim picks among those without faults.
    ///
    /// # Errors
    /// [`Error::NoShifts`], with the fault of the set that the aim would pick, where none is without;
    /// [`Error::ShiftOutOfRange`] where that set has a gear without teeth; [`Error::Negative`] for limits
    /// below 0. A stretch of faultless shifts shorter than 1/64 of those without undercut may be missed.
    pub fn choose(&self, aim: Aim, limits: &Limits) -> Result<Choice, Error> {
        match aim {
            Aim::BalancedSliding => self.balanced_by(limits, imbalance_of_sliding),
            Aim::LeastTipAlteration => self.least_altered(limits),
        }
    }

    /// The set without faults at which a measure that rises with the shift of the sun is 0, or as near to it
    /// as the limits allow: balanced sliding, or, with a measure from outside, balanced safety.
    ///
    /// # Errors
    /// As [`choose`](Self::choose).
    pub fn balanced_by(
        &self,
        limits: &Limits,
        imbalance: impl Fn(&PlanetSet) -> f64,
    ) -> Result<Choice, Error> {
        limits.check()?;
        let range = self.searched();
        let at = |shift| self.cleared(shift);
        self.nearest(zero(&range, &at, imbalance), &range, limits, at)
    }

    /// Range of shifts without undercut; if it is empty, the middle shift, which undercuts sun and planets
    /// alike.
    pub(super) fn searched(&self) -> RangeInclusive<f64> {
        let range = self.without_undercut();
        if range.is_empty() {
            let middle = range.start().midpoint(*range.end());
            return middle..=middle;
        }
        range
    }

    fn least_altered(&self, limits: &Limits) -> Result<Choice, Error> {
        limits.check()?;
        let range = self.searched();
        let at = |shift| self.with_tips(shift, self.needed_tips(shift, limits));
        let total = |shift: f64| {
            let set = at(shift).ok().filter(|set| set.faults(limits).is_empty())?;
            Some(-set.gears().map(InvoluteGear::tip_alteration).iter().sum::<f64>())
        };
        let step = (range.end() - range.start()) / f64::from(PARTS);
        let shift = |part: u32| range.start() + f64::from(part) * step;
        let best = (0..=PARTS)
            .filter_map(|part| total(shift(part)).map(|sum| (part, sum)))
            .min_by(|one, other| one.1.total_cmp(&other.1));
        let balanced = zero(&range, &at, imbalance_of_sliding);
        let Some((part, least)) = best else { return self.nearest(balanced, &range, limits, at) };
        if total(balanced).is_some_and(|sum| sum <= least + TOUCH) {
            return self.nearest(balanced, &range, limits, at);
        }
        // Thirds close in on a least sum beside the best part. That the sum has no second valley between two
        // parts is not proved; what is found is never worse than the best part.
        let sum = |shift: f64| total(shift).unwrap_or(f64::INFINITY);
        let (mut low, mut high) = (shift(part.saturating_sub(1)), shift((part + 1).min(PARTS)));
        for _ in 0..HALVINGS {
            let [one, other] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
            if sum(one) <= sum(other) { high = other } else { low = one }
        }
        let found = low.midpoint(high);
        let found = if sum(found) < least { found } else { shift(part) };
        self.nearest(found, &range, limits, at)
    }

    /// The tip alterations that clearance and the fillets of the mates need.
    fn clear_tips(&self, sun_shift: f64) -> [f64; 3] {
        let shifts = self.shifts(sun_shift);
        let clear = [self.tip_alteration, self.tip_alteration, 0.0];
        let gears: [InvoluteGear; 3] =
            std::array::from_fn(|place| self.gears[place].altered(shifts[place], clear[place]));
        let Ok(set) = PlanetSet::new(gears, self.planets, self.centre_distance) else { return clear };
        let [sun, planet, ring] = set.gears();
        let end = |gear: &InvoluteGear| gear.cut().end;
        // The greatest radius of curvature of each tip, of the ring the least.
        let by_fillets = [
            set.sun_mesh().of_mate(end(planet)),
            set.sun_mesh().mate(end(sun)).min(set.ring_mesh().of_mate(end(ring))),
            set.ring_mesh().mate(end(planet)),
        ];
        std::array::from_fn(|place| gears[place].shortened_to(by_fillets[place]))
    }

    /// The tip alterations that clearance, fillets and the least tip thickness need, for thickness at most
    /// one module.
    fn needed_tips(&self, sun_shift: f64, limits: &Limits) -> [f64; 3] {
        let shifts = self.shifts(sun_shift);
        let clear = self.clear_tips(sun_shift);
        std::array::from_fn(|place| {
            let thickness = |tip: f64| self.gears[place].altered(shifts[place], tip).tip_thickness();
            let is_thick = |tip: f64| thickness(tip) >= limits.tip_thickness;
            let long = clear[place];
            if is_thick(long) { long } else { bisected([long - 1.0, long], HALVINGS, is_thick)[0] }
        })
    }

    /// The set without faults nearest to a shift.
    fn nearest(
        &self,
        wanted: f64,
        range: &RangeInclusive<f64>,
        limits: &Limits,
        at: impl Fn(f64) -> Result<PlanetSet, Refused>,
    ) -> Result<Choice, Error> {
        let checked = |shift: f64| {
            let set = at(shift).map_err(|refused| refused.fault(limits))?;
            set.faults(limits).first().map_or(Ok(set), |fault| Err(Ok(*fault)))
        };
        let found = nearest(wanted, range, checked, Result::is_ok);
        let found =
            found.map(|(set, limited_by)| Choice { set, limited_by: limited_by.and_then(Result::ok) });
        found.map_err(|first| {
            let [sun, planet, ring] = self.gears.map(|gear| gear.teeth().get());
            let centre_distance = self.centre_distance;
            first.map_or_else(
                |error| error,
                |fault| Error::NoShifts { sun, planet, ring, centre_distance, fault },
            )
        })
    }
}

/// Candidate without faults nearest to a shift within a range, and the fault that keeps it from the shift:
/// the last that is named. If all have faults, that of the wanted shift.
pub(super) fn nearest<T, F: Clone>(
    wanted: f64,
    range: &RangeInclusive<f64>,
    checked: impl Fn(f64) -> Result<T, F>,
    is_named: impl Fn(&F) -> bool,
) -> Result<(T, Option<F>), F> {
    let first = match checked(wanted) {
        Ok(found) => return Ok((found, None)),
        Err(first) => first,
    };
    let step = (range.end() - range.start()) / f64::from(PARTS);
    if step <= 0.0 {
        return Err(first);
    }
    let sides = |part: u32| [-1.0, 1.0].map(|side| (wanted + side * f64::from(part) * step, side * step));
    for (shift, step) in (1..=PARTS).flat_map(sides) {
        if !(range.start() - TOUCH..=range.end() + TOUCH).contains(&shift) {
            continue;
        }
        let Ok(mut found) = checked(shift) else { continue };
        // Between it and the last with a fault lies the end of the faultless.
        let mut limited_by = first.clone();
        bisected([shift, shift - step], HALVINGS, |shift| match checked(shift) {
            Ok(nearer) => {
                found = nearer;
                true
            }
            Err(fault) => {
                if is_named(&fault) {
                    limited_by = fault;
                }
                false
            }
        });
        return Ok((found, Some(limited_by)));
    }
    Err(first)
}

/// A set in which one gear has no teeth left.
struct Refused {
    gear: Option<SimpleGear>,
    error: Error,
}

impl From<Refused> for Error {
    fn from(refused: Refused) -> Self {
        refused.error
    }
}

impl Refused {
    /// Fault of the set, if teeth are pointed.
    fn fault(self, limits: &Limits) -> Result<Check, Error> {
        match (self.gear, self.error) {
            (Some(gear), Error::ShiftOutOfRange { fault: ShiftFault::Pointed { tip_thickness }, .. }) => {
                Ok(Check {
                    rule: Rule::TipThickness,
                    place: Place::Gear(gear),
                    value: tip_thickness,
                    limit: limits.tip_thickness,
                })
            }
            (_, error) => Err(error),
        }
    }
}

/// Shift at which a measure that rises with the shift is 0 within a range, or the end of the range nearest to
/// it.
fn zero(
    range: &RangeInclusive<f64>,
    at: &impl Fn(f64) -> Result<PlanetSet, Refused>,
    measure: impl Fn(&PlanetSet) -> f64,
) -> f64 {
    rising_to_zero(range, |shift| match at(shift) {
        Ok(set) => measure(&set),
        // A sun without teeth has too large a shift; a planet has when the sun's is too small.
        Err(refused) if refused.gear == Some(SimpleGear::Sun) => 1.0,
        Err(_) => -1.0,
    })
}

/// Shift in a range at which a measure that rises with it is 0, or the end of the range nearest to it.
pub(super) fn rising_to_zero(range: &RangeInclusive<f64>, measure: impl Fn(f64) -> f64) -> f64 {
    let [low, high] = [*range.start(), *range.end()];
    let at_low = measure(low);
    if at_low > 0.0 {
        return low;
    }
    let at_high = measure(high);
    if at_high <= 0.0 {
        return high;
    }
    // A measure is the geometry of a whole set: the ends have theirs already.
    bracketed(low, high, |shift| match shift {
        _ if shift == low => at_low,
        _ if shift == high => at_high,
        _ => measure(shift),
    })
}

/// 0 where the specific sliding at the roots of sun and planet is equal, rising with the shift of the sun.
///
/// ```text
/// ζ_s = 1 − ρ_p(A)/(u·ρ_s(A)),  ζ_p = 1 − u·ρ_s(E)/ρ_p(E),  u = z_p/z_s:    u²·ρ_s(A)·ρ_s(E) − ρ_p(A)·ρ_p(E)
/// ```
///
/// As products, so that it stays finite at the base circles.
fn imbalance_of_sliding(set: &PlanetSet) -> f64 {
    sliding_imbalance(set.sun_mesh())
}

/// Imbalance of sliding of any external pair, rising with the shift of its first gear.
pub(super) fn sliding_imbalance(pair: &Pair) -> f64 {
    let [sun, planet] = pair.gears();
    let ratio = planet.teeth().as_f64() / sun.teeth().as_f64();
    let [from, to] = pair.contact();
    ratio * ratio * from * to - pair.mate(from) * pair.mate(to)
}

/// The centre distance at which the meshes of a set depart least from the clearance of the basic rack
/// ([module](self)), in modules.
///
/// Let `C_1 = (z_s + z_p)·cos α_t/(2·cos β)`, `C_2 = (z_r − z_p)·cos α_t/(2·cos β)`, `P = C_1² + C_2²`,
/// `D = C_1² − C_2²` and `s = 2·sin α_t`. The condition `sin α_w1 + sin α_w2 = s` then has one solution:
///
/// ```text
/// a² = (s²·P + √(s⁴·P² + s²·(4 − s²)·D²))/(s²·(4 − s²))
/// ```
///
/// # Errors
/// Those of [`Profile::check`]; [`Error::InternalNotLarger`]; [`Error::OutOfRange`], for the teeth of the
/// ring, where the offset is so large that no centre distance fulfils it.
pub fn natural_centre_distance(teeth: [ToothCount; 3], profile: Profile) -> Result<f64, Error> {
    profile.check()?;
    let [sun, planet, ring] = teeth.map(ToothCount::as_f64);
    if ring <= planet {
        return Err(Error::InternalNotLarger { internal: teeth[2].get(), external: teeth[1].get() });
    }
    let alpha = profile.transverse_angle_rad();
    let scale = libm::cos(alpha) / (2.0 * libm::cos(profile.helix_angle.si()));
    let [one, other] = [(sun + planet) * scale, (ring - planet) * scale].map(|base| base * base);
    let (sum, difference) = (one + other, one - other);
    let s2 = 4.0 * libm::sin(alpha).powi(2);
    let square = (s2 * sum + (s2 * s2 * sum * sum + s2 * (4.0 - s2) * difference * difference).sqrt())
        / (s2 * (4.0 - s2));
    // One working angle would be below 0 beyond: there the greater base distance alone has the sum of sines.
    let ratio = 1.0 - s2;
    if one.min(other) < ratio * one.max(other) {
        let reach = |share: f64| planet + (sun + planet) * share;
        let (low, high) = (reach(ratio.max(0.0).sqrt()), reach(1.0 / ratio.max(0.0).sqrt()));
        return Err(Error::OutOfRange {
            quantity: Quantity::RingTeeth,
            value: ring,
            low,
            high,
            unit: "teeth",
        });
    }
    Ok(square.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use uom::si::f64::Angle;

    fn teeth(counts: [u32; 3]) -> [ToothCount; 3] {
        counts.map(|count| ToothCount::new(count).unwrap())
    }

    fn wind() -> Family {
        Family::new(teeth([18, 36, 93]), 3, Profile::default(), 584.0 / 21.0).unwrap()
    }

    #[test]
    fn undercut_bounds_the_shifts_on_both_sides() {
        let family = Family::new(teeth([14, 14, 43]), 3, Profile::default(), 14.4).unwrap();
        let range = family.without_undercut();
        for (shift, gear) in [(*range.start(), SimpleGear::Sun), (*range.end(), SimpleGear::Planet)] {
            let undercut = |shift: f64| {
                let faults = family.at(shift).unwrap().faults(&Limits::default());
                faults.iter().any(|fault| fault.rule == Rule::Undercut && fault.place == Place::Gear(gear))
            };
            let out = if gear == SimpleGear::Sun { -1e-6 } else { 1e-6 };
            assert!(!undercut(shift) && undercut(shift + out), "{gear}");
        }
    }

    #[test]
    fn an_aim_out_of_reach_names_the_fault_between() {
        let family = wind();
        let balanced = family.choose(Aim::BalancedSliding, &Limits::default()).unwrap();
        assert_eq!(balanced.limited_by, None);
        let [_, planet, _] = balanced.set.gears();
        // Thicker tips of the sun than balanced sliding leaves ask for less shift.
        let [sun, ..] = balanced.set.gears();
        let limits = Limits { tip_thickness: sun.tip_thickness() + 0.02, ..Limits::default() };
        let limited = family.choose(Aim::BalancedSliding, &limits).unwrap();
        let Some(Check { rule: Rule::TipThickness, place: Place::Gear(SimpleGear::Sun), .. }) =
            limited.limited_by
        else {
            panic!("{:?}", limited.limited_by)
        };
        let [thicker, other, _] = limited.set.gears();
        assert!((thicker.tip_thickness() - limits.tip_thickness).abs() < 1e-6);
        assert!(thicker.shift() < sun.shift() && other.shift() > planet.shift());
        // Tips that may be shortened leave no need for a large departure from balanced sliding.
        let shortened = family.choose(Aim::LeastTipAlteration, &limits).unwrap();
        assert!(shortened.set.faults(&limits).is_empty());
    }

    #[test]
    fn tips_are_shortened_no_more_than_needed() {
        let limits = Limits { tip_thickness: 0.62, ..Limits::default() };
        let family = wind();
        let least = family.choose(Aim::LeastTipAlteration, &limits).unwrap().set;
        let total = |set: &PlanetSet| set.gears().map(InvoluteGear::tip_alteration).iter().sum::<f64>();
        let range = family.without_undercut();
        for part in 0..=500 {
            let shift = range.start() + (range.end() - range.start()) * f64::from(part) / 500.0;
            let tips = family.needed_tips(shift, &limits);
            let Ok(set) = family.with_tips(shift, tips) else { continue };
            if set.faults(&limits).is_empty() {
                assert!(total(&set) <= total(&least) + 1e-9, "{shift}");
            }
        }
        // If clearance alone shortens the tips, the sum is 2·k, and the ring is unaltered.
        let loose = family.choose(Aim::LeastTipAlteration, &Limits::default()).unwrap().set;
        assert!((total(&loose) - 2.0 * family.tip_alteration()).abs() < 1e-12);
    }

    #[test]
    fn sets_that_no_shift_closes_are_refused_with_the_reason() {
        let refused = |counts, planets, a, limits: Limits| {
            Family::new(teeth(counts), planets, Profile::default(), a)
                .and_then(|family| family.choose(Aim::BalancedSliding, &limits))
                .unwrap_err()
        };
        // Seven planets of 36 teeth about a sun of 18 touch.
        let error = refused([18, 36, 93], 7, 584.0 / 21.0, Limits::default());
        let Error::NoShifts { fault: Check { place: Place::Planets(7), value: gap, .. }, .. } = error else {
            panic!("{error}")
        };
        assert!(gap < 0.0);
        assert!(
            error
                .to_string()
                .starts_with("18/36/93 at a centre distance of 27.8095 modules: no profile shifts"),
            "{error}"
        );
        // A centre distance within the base circles.
        assert_eq!(refused([18, 36, 93], 3, 24.0, Limits::default()).name(), "not-above");
        // Nine teeth cannot be freed of undercut at so small a centre distance.
        let error = refused([9, 12, 33], 3, 10.5, Limits::default());
        assert!(
            matches!(error, Error::NoShifts { fault: Check { rule: Rule::Undercut, .. }, .. }),
            "{error}"
        );
        let limits = Limits { contact_ratio: f64::NAN, ..Limits::default() };
        assert_eq!(refused([18, 36, 93], 3, 27.8, limits).name(), "negative");
        let error = natural_centre_distance(teeth([18, 36, 140]), Profile::default()).unwrap_err();
        assert!(error.to_string().contains("teeth of the ring is 140 teeth"), "{error}");
    }

    fn shifted() -> impl Strategy<Value = (Family, Profile)> {
        (14..60_u32, 14..60_u32, -3..=3_i32, 0.0..25.0_f64, -0.4..0.6_f64).prop_filter_map(
            "a centre distance out of reach",
            |(sun, planet, offset, helix, more)| {
                let profile = Profile { helix_angle: Angle::from_degrees(helix), ..Profile::default() };
                let counts = teeth([sun, planet, (sun + 2 * planet).checked_add_signed(offset)?]);
                let a = natural_centre_distance(counts, profile).ok()? + more;
                Some((Family::new(counts, 3, profile, a).ok()?, profile))
            },
        )
    }

    proptest! {
        #[test]
        fn every_member_fills_its_pitches_on_the_centre_distance((family, _) in shifted(), shift in -0.3..0.9_f64) {
            if let Ok(set) = family.at(shift) {
                let scale = set.gears()[2].tip_diameter();
                for pair in [set.sun_mesh(), set.ring_mesh()] {
                    prop_assert!(pair.backlash().abs() < 1e-11 * scale);
                    prop_assert!((pair.centre_distance() - set.centre_distance()).abs() < 1e-11 * scale);
                }
                // Tips of sun and planet keep the clearance, those of ring and planet at least as much.
                let [outer, inner] = [set.sun_mesh(), set.ring_mesh()].map(Pair::tip_clearances);
                prop_assert!(outer.iter().all(|gap| *gap > 0.25 - 1e-9));
                // A shaper of one addendum leaves a shifted ring a little shallower than its basic rack
                // would.
                let ring = set.gears()[2];
                let nominal = ring.reference_diameter() / 2.0 + 1.25 - ring.shift();
                prop_assert!(inner[0] + nominal - ring.root_diameter() / 2.0 > 0.25 - 1e-9 && inner[1] > 0.25 - 1e-9);
            }
        }

        #[test]
        fn a_choice_has_no_fault_and_meets_its_aim_or_says_what_limits_it((family, _) in shifted()) {
            let limits = Limits::default();
            for aim in [Aim::BalancedSliding, Aim::LeastTipAlteration] {
                let Ok(choice) = family.choose(aim, &limits) else { continue };
                prop_assert_eq!(choice.set.faults(&limits), vec![]);
                if aim == Aim::BalancedSliding && choice.limited_by.is_none() {
                    let [[_, sun], [_, planet]] = choice.set.sun_mesh().specific_sliding();
                    let range = family.without_undercut();
                    let shift = choice.set.gears()[0].shift();
                    let at_end = (shift - range.start()).min(range.end() - shift) < 1e-6;
                    prop_assert!(at_end || (sun - planet).abs() < 1e-6 * sun.abs(), "{sun} {planet}");
                }
            }
        }

        #[test]
        fn the_natural_centre_distance_departs_least_from_the_clearance(
            sun in 14..60_u32, planet in 14..60_u32, offset in -3..=3_i32, helix in 0.0..25.0_f64,
        ) {
            let profile = Profile { helix_angle: Angle::from_degrees(helix), ..Profile::default() };
            let counts = teeth([sun, planet, (sun + 2 * planet).checked_add_signed(offset).unwrap()]);
            let a = natural_centre_distance(counts, profile).unwrap();
            let gears = [
                InvoluteGear::new(GearKind::External, counts[0], profile, 0.0).unwrap(),
                InvoluteGear::new(GearKind::External, counts[1], profile, 0.0).unwrap(),
                InvoluteGear::new(GearKind::Internal, counts[2], profile, 0.0).unwrap(),
            ];
            let departure = |a: f64| {
                let [outer, inner] = [[gears[0], gears[1]], [gears[1], gears[2]]].map(|[one, other]| {
                    let pair = Pair::at_centre_distance(one, other, a).ok()?;
                    Some((pair.reference_centre_distance(), Pair::shift_sum(&one, &other, a).ok()?))
                });
                let ((outer, one), (inner, other)) = (outer?, inner?);
                Some((outer + one - a) + (inner - a - other))
            };
            let least = departure(a).unwrap();
            prop_assert!(least > -1e-10);
            for off in [-0.3, -0.1, -0.01, 0.01, 0.1, 0.3] {
                prop_assert!(departure(a + off).is_none_or(|more| more > least - 1e-10), "{off}");
            }
            if offset == 0 {
                prop_assert!((a - gears[0].reference_diameter() / 2.0 - gears[1].reference_diameter() / 2.0).abs() < 1e-10);
            }
        }
    }
}

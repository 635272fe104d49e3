//! Rotors by a cosine law with a second harmonic: for given numbers one family, over its amplitude `ε₂`.
//!
//! ```text
//! ρ₁ = c·(1 + ε₁·cos nθ₁ + ε₂·cos 2nθ₁)
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `c` | mean radius of the rotor's centrode | m |
//! | `ε₁` | relative amplitude | 1 |
//! | `ε₂` | relative amplitude of the second harmonic; above 0 crests are sharper, troughs flatter | 1 |
//!
//! The length of a half-lobe and the closure of the stator fix `c` and `ε₁` as for the cosine law
//! ([`crate::cosine`]). `ε₂` is free, and at 0 the motor is that of the cosine law. The curvature jumps
//! nowhere, unlike that of two arcs where they meet.
//!
//! # The range of `ε₂`
//! Three limits end it:
//!
//! - the stator gets cusps, `ds₃/ds₁ = 0` ([`HarmonicLimit::StatorCusp`]), at the trough for small `ε₂`,
//!   between trough and crest for large;
//! - `ε₁ = 4·ε₂`: the rotor's trough is flat, beyond it is a hill between two troughs
//!   ([`HarmonicLimit::FlatTrough`]), since `dρ₁/dθ₁ = −c·n·sin nθ₁·(ε₁ + 4·ε₂·cos nθ₁)`;
//! - `ε₁ = −4·ε₂`: the rotor's crest is flat likewise ([`HarmonicLimit::FlatCrest`]).
//!
//! The range is found by the part `t = 4·ε₂/ε₁`, from −1 to 1. At each `t` the span of the half-lobes falls
//! with `ε₁`, up to the `ε₁` at which the stator gets cusps. A motor closes there if they span too little at
//! this `ε₁`. The missing span rises with `t` to one peak, where the cusp leaves the trough, and falls
//! beyond, so that the range is one interval. That only one peak exists is not proved: the tests scan every
//! seventh set of numbers.
//!
//! # Source
//! Not in rotary-hydromotor. The conjugation is that of [`crate::closure`] with the wheels changed.

use epicyclic_units::Physical;
use uom::si::f64::{Angle, Length};

use crate::Error;
use crate::cosine::{Cosine, Law, Numbers};
use crate::machine;
use crate::modules::length;
use crate::numbers::MotorNumbers;
use crate::quantity::Quantity;
use epicyclic_numerics::extremes::golden;
use epicyclic_numerics::roots::bracketed;

/// The law of a rotor with a second harmonic, or without.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HarmonicLaw {
    /// `c`.
    pub mean_radius: Length,
    /// `ε₁`.
    pub amplitude: f64,
    /// `ε₂`.
    pub second_amplitude: f64,
    /// The least `ds₃/ds₁` along the half-lobe: above 0 the stator is smooth, at 0 it has a cusp, below a
    /// loop.
    pub least_stretch: f64,
}

impl HarmonicLaw {
    pub(crate) fn of(law: &Law, module: Length) -> Self {
        Self {
            mean_radius: length(law.c, module),
            amplitude: law.amplitude,
            second_amplitude: law.second,
            least_stretch: law.least_stretch(),
        }
    }
}

/// The law that fulfils both closures with an amplitude `ε₂`, whether or not the stator then has cusps.
///
/// Only laws whose [`least_stretch`](HarmonicLaw::least_stretch) is above 0 are motors:
/// [`crate::Motor::of_second_harmonic`].
///
/// # Errors
/// [`Error::NotPositive`] for the module, [`Error::NotFinite`] for `ε₂`. If radii would not fall from crest
/// to trough, [`Error::OutsideHarmonic`], or [`Error::NoSecondHarmonicRotor`] if no range exists at all.
///
/// # Example
/// ```
/// use epicyclic_hydromotor::{MotorNumbers, second_harmonic};
/// use uom::si::{f64::Length, length::millimeter};
///
/// // The cosine law would need an amplitude at which the stator has cusps; a second harmonic of 1.5 % helps.
/// let (numbers, module) = (MotorNumbers::new(6, 4, 66, 10)?, Length::new::<millimeter>(1.0));
/// let [cosine, second] = [0.0, 0.015].map(|second| second_harmonic::closure(numbers, module, second));
/// assert!(cosine?.least_stretch < 0.0 && second?.least_stretch > 0.3);
/// # Ok::<(), epicyclic_hydromotor::Error>(())
/// ```
pub fn closure(numbers: MotorNumbers, module: Length, second_amplitude: f64) -> Result<HarmonicLaw, Error> {
    let module = machine::module(module)?;
    let second = finite(second_amplitude)?;
    match Numbers::of(numbers).at_second(second) {
        Some(law) => Ok(HarmonicLaw::of(&law, module)),
        None => Err(outside(numbers, second)),
    }
}

/// Limit that ends the range of `ε₂`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HarmonicLimit {
    /// The stator gets cusps.
    StatorCusp,
    /// The rotor's crest becomes flat, `ε₁ = −4·ε₂`.
    FlatCrest,
    /// The rotor's trough becomes flat, `ε₁ = 4·ε₂`.
    FlatTrough,
}

/// An end of the range, not a motor itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HarmonicEnd {
    /// Limit that ends the range.
    pub limit: HarmonicLimit,
    /// `ε₁` there.
    pub amplitude: f64,
    /// `ε₂` there.
    pub second_amplitude: f64,
}

/// The range of `ε₂` of given numbers: with every `ε₂` between its ends a motor closes without cusps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HarmonicRange {
    /// The end with the lesser `ε₂`.
    pub lower: HarmonicEnd,
    /// The end with the greater `ε₂`.
    pub upper: HarmonicEnd,
}

/// The range of `ε₂` in which motors close without cusps.
///
/// # Errors
/// [`Error::NoSecondHarmonicRotor`] if no such range exists.
///
/// # Example
/// ```
/// use epicyclic_hydromotor::MotorNumbers;
/// use epicyclic_hydromotor::second_harmonic::{self, HarmonicLimit};
///
/// let range = second_harmonic::range(MotorNumbers::new(6, 4, 66, 10)?)?;
/// assert_eq!(range.lower.limit, HarmonicLimit::StatorCusp);
/// assert!(range.lower.second_amplitude > 0.0 && range.upper.second_amplitude > 0.025);
/// # Ok::<(), epicyclic_hydromotor::Error>(())
/// ```
pub fn range(numbers: MotorNumbers) -> Result<HarmonicRange, Error> {
    let kernel = Numbers::of(numbers);
    let ends = part_ends(&kernel)
        .map_err(|left| Error::NoSecondHarmonicRotor { excess_deg: Angle::from_si(left).degrees() })?;
    let end = |part: f64, flat: HarmonicLimit| {
        let is_flat = part.abs() >= 1.0;
        // At a cusp the law is that of the cusp; at a flat end that of the closure.
        let amplitude = match kernel.at_part(part) {
            Some(law) => law.amplitude,
            None => kernel.cusp(part).0,
        };
        HarmonicEnd {
            limit: if is_flat { flat } else { HarmonicLimit::StatorCusp },
            amplitude,
            second_amplitude: 0.25 * part * amplitude,
        }
    };
    Ok(HarmonicRange {
        lower: end(ends[0], HarmonicLimit::FlatCrest),
        upper: end(ends[1], HarmonicLimit::FlatTrough),
    })
}

/// Places of `t` at which the peak is looked for.
const PLACES: u32 = 16;

/// Ends of the range as parts `t = 4·ε₂/ε₁`. Without a range the error is the angle that the half-lobes span
/// too much at the peak.
pub(crate) fn part_ends(kernel: &Numbers) -> Result<[f64; 2], f64> {
    let margin = |part: f64| kernel.cusp(part).1;
    let place = |i: u32| -1.0 + 2.0 * f64::from(i) / f64::from(PLACES);
    let (mut peak, mut i) = ((0.0, f64::NEG_INFINITY), 0);
    for k in 0..=PLACES {
        let here = margin(place(k));
        if here > peak.1 {
            (peak, i) = ((place(k), here), k);
        }
    }
    if peak.1 <= 0.0 {
        // By golden section, as far as to anything above 0.
        let (low, high) = (place(i.saturating_sub(1)), place((i + 1).min(PLACES)));
        let best = std::cell::Cell::new(peak);
        golden(low, high, 32, |part| {
            if best.get().1 <= 0.0 {
                let here = margin(part);
                if here > best.get().1 {
                    best.set((part, here));
                }
                return -here;
            }
            0.0
        });
        peak = best.get();
    }
    if peak.1 <= 0.0 {
        return Err(-peak.1);
    }
    let end =
        |side: f64| if margin(side) > 0.0 { side } else { bracketed(peak.0, side, |part| -margin(part)) };
    Ok([end(-1.0), end(1.0)])
}

/// The half-lobe of a motor.
pub(crate) fn lobe(numbers: MotorNumbers, second_amplitude: f64) -> Result<Cosine, Error> {
    let second = finite(second_amplitude)?;
    if second == 0.0
        && let Ok(lobe) = Cosine::new(numbers)
    {
        return Ok(lobe);
    }
    match Numbers::of(numbers).at_second(second).filter(|law| law.least_stretch() > 0.0) {
        Some(law) => Ok(Cosine::of_law(law)),
        None => Err(outside(numbers, second)),
    }
}

/// Laws of a search: at this number of parts `t` of the range, evenly from end to end, the first and the last
/// slightly within.
pub(crate) fn laws(numbers: MotorNumbers, places: u32, within: f64) -> Vec<Law> {
    let kernel = Numbers::of(numbers);
    let Ok([from, to]) = part_ends(&kernel) else { return Vec::new() };
    let share = |i: u32| (f64::from(i) / f64::from(places - 1)).clamp(within, 1.0 - within);
    (0..places).filter_map(|i| kernel.at_part(from + (to - from) * share(i))).collect()
}

fn outside(numbers: MotorNumbers, second: f64) -> Error {
    match range(numbers) {
        Ok(range) => Error::OutsideHarmonic {
            second,
            low: range.lower.second_amplitude,
            high: range.upper.second_amplitude,
        },
        Err(error) => error,
    }
}

fn finite(second: f64) -> Result<f64, Error> {
    if second.is_finite() {
        Ok(second)
    } else {
        Err(Error::NotFinite { quantity: Quantity::SecondAmplitude, value: second, unit: "" })
    }
}

#[cfg(test)]
#[path = "second_harmonic_tests.rs"]
mod tests;

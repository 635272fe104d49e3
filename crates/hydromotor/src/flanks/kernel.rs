//! Shared parts of the flanks' modules: directions of the forces, loaded phases, greatest values on smooth
//! pieces.
//!
//! # Places
//! Ranges are sampled in the quantity in which the shape is explicit ([`Shape::explicit`]), so that a contact
//! there costs no search, and one contact serves all its uses. The ends are computed once.

use crate::Error;
use crate::contact::{By, Conjugate, Contact};
use crate::motor::{Motor, Shape};
use crate::profile::Side;
use crate::quantity::Quantity;
use crate::ranges::finite_angle;
use crate::tolerance::WITHIN;
use epicyclic_numerics::extremes::{Bracket, summit};
use epicyclic_numerics::roots::bracketed;
use epicyclic_units::Physical;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use uom::si::f64::Angle;

/// Pieces of a smooth stretch in the search for its extremes.
const PIECES: usize = 16;

/// A pressure angle of a tooth form, in radians.
pub(super) fn pressure_angle(value: Angle) -> Result<f64, Error> {
    let alpha = finite_angle(Quantity::PressureAngle, value)?;
    let value = value.degrees();
    if (10.0..=40.0).contains(&value) {
        return Ok(alpha);
    }
    Err(Error::OutOfRange { quantity: Quantity::PressureAngle, value, low: 10.0, high: 40.0, unit: "°" })
}

/// Unit vector, in the frame of the ray, of the force of a flank on a satellite that is pushed by `sigma`; of
/// the back flank for the opposite sign.
pub(super) fn direction(side: Side, sigma: f64, alpha: f64, mu: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(alpha + sigma * mu);
    let out = match side {
        Side::Stator => -1.0,
        Side::Rotor => 1.0,
    };
    [out * sin, -sigma * cos]
}

/// `N/(Δp·b·m)` on either flank with contacts at the pitch points.
pub(super) fn flank_number(r: f64, alpha: f64, contact: &Contact, sigma: f64) -> Result<f64, Error> {
    let mu = contact.mu;
    let carrying = libm::cos(alpha + sigma * mu);
    if carrying <= WITHIN {
        let most_deg = Angle::from_si(FRAC_PI_2 - alpha).degrees();
        return Err(Error::CannotHold { slope_deg: Angle::from_si(sigma * mu).degrees(), most_deg });
    }
    Ok(r * libm::cos(mu) / carrying)
}

/// A vector turned.
pub(super) fn turned([x, y]: [f64; 2], by: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(by);
    [x * cos - y * sin, x * sin + y * cos]
}

impl Motor {
    /// Phases between which a satellite by a crest, or by a trough, parts high from low pressure: `±π/N`
    /// about it.
    pub(super) fn loaded(&self, crest: bool) -> [f64; 2] {
        let half = PI / f64::from(self.numbers().stator_lobes());
        let middle = if crest { 0.0 } else { self.shape.trough().phase };
        [middle - half, middle + half]
    }

    /// The sign of the force on a satellite by a crest, or by a trough, for a pressure drop of this sign.
    pub(super) fn push(crest: bool, pressure_drop: f64) -> f64 {
        let forward = if crest { 1.0 } else { -1.0 };
        if pressure_drop < 0.0 { -forward } else { forward }
    }

    /// The sign of the force on a satellite at a phase for a pressure drop of this sign; none while it is
    /// idle.
    pub(super) fn pushed(&self, phase: f64, pressure_drop: f64) -> Option<f64> {
        let end = self.shape.trough().phase;
        let half = PI / f64::from(self.numbers().stator_lobes());
        let rest = self.beside_crest(phase);
        if rest < half {
            Some(Self::push(true, pressure_drop))
        } else {
            (end - rest < half).then(|| Self::push(false, pressure_drop))
        }
    }

    /// Places within a range of phases where the motion has a kink, and both its ends, in order.
    pub(super) fn smooth_ends(&self, range: [f64; 2], more: impl IntoIterator<Item = f64>) -> Vec<f64> {
        self.smooth_ends_by(By::Phase, range, more)
    }

    /// Places of kinks and ends within a range of another quantity, in order.
    pub(super) fn smooth_ends_by(
        &self,
        by: By,
        [from, to]: [f64; 2],
        more: impl IntoIterator<Item = f64>,
    ) -> Vec<f64> {
        let period = 2.0 * self.shape.trough().get(by);
        let kink = self.shape.kink_contact().map(|contact| contact.get(by));
        let kinks = kink.into_iter().flat_map(|kink| [kink, -kink]);
        let kinks = kinks.flat_map(|kink| windings(kink, period, [from, to]));
        let mut ends: Vec<f64> = kinks.chain(more).filter(|&place| place > from && place < to).collect();
        ends.extend([from, to]);
        ends.sort_by(f64::total_cmp);
        // Two that rounding parts are one.
        ends.dedup_by(|late, early| *late - *early < WITHIN * (to - from));
        ends
    }

    /// Distance of a phase from that of the nearest crest.
    fn beside_crest(&self, phase: f64) -> f64 {
        let cycle = 2.0 * self.shape.trough().phase;
        (phase - (phase / cycle).round() * cycle).abs()
    }

    /// Whether the curvature jumps at a phase.
    pub(super) fn is_kink(&self, phase: f64) -> bool {
        let cycle = 2.0 * self.shape.trough().phase;
        let is_at = |kink: &Contact| (self.beside_crest(phase) - kink.phase).abs() < WITHIN * cycle;
        self.shape.kink_contact().is_some_and(is_at)
    }

    /// The period of everything that depends on the pressures of ideal ports: `2π/lcm(N, n)`.
    pub(crate) fn period(&self) -> f64 {
        let numbers = self.numbers();
        TAU * f64::from(numbers.common_divisor()) / f64::from(numbers.stator_lobes() * numbers.rotor_lobes())
    }

    /// The phases of steepest slope `μ` on a half-lobe, to the last bits: where the stator's curvature passes
    /// that of the circle about the axis that touches the same ray, `κ₃ = cos μ/ρ₃`, or `dμ/dθ₁ = 0`.
    ///
    /// On two arcs there are none but the ends and the junction: on arc 1 `κ₃ < 0`, and on arc 2 it would be
    /// where `cos x = −a/R₂`, 90° from the crest as seen from the axis.
    pub(super) fn steepest(&self) -> Vec<f64> {
        const PLACES: u32 = 64;
        let trough = self.shape.trough();
        let Shape::Cosine(cosine) = &self.shape else { return self.smooth_ends([0.0, trough.phase], []) };
        let (law, end) = (cosine.law(), trough.theta1);
        let place = |i: u32| end * f64::from(i) / f64::from(PLACES);
        let mut places = vec![0.0, trough.phase];
        let mut before = law.slope_rate(0.0);
        for i in 1..=PLACES {
            let here = law.slope_rate(place(i));
            if before * here < 0.0 {
                let theta1 = bracketed(place(i - 1), place(i), |theta| law.slope_rate(theta));
                places.push(self.shape.within(By::RotorAngle, theta1).phase);
            }
            before = here;
        }
        places
    }
}

/// The greatest value of a function that is smooth on some pieces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Top {
    pub(super) piece: usize,
    pub(super) place: f64,
    pub(super) value: f64,
}

/// Finds the greatest values of several functions at once, each smooth on some pieces.
///
/// `f` receives the index of the piece, so that it keeps to one branch there up to both ends. A function that
/// jumps instead is evaluated a `hair` of the piece within. Each piece is sampled, all functions in the same
/// places. For each function a sample that no neighbour exceeds is refined if it may reach the best of all.
/// It may if its value, plus twice its rise above the lower neighbour, exceeds the best.
pub(super) fn greatest_of<const N: usize>(
    pieces: &[[f64; 2]],
    hair: f64,
    f: impl Fn(usize, f64) -> [f64; N],
) -> [Top; N] {
    let mut best = [Top { piece: 0, place: f64::NAN, value: f64::NEG_INFINITY }; N];
    let mut tops: [Vec<(f64, usize, Bracket)>; N] = std::array::from_fn(|_| Vec::new());
    for (piece, &[from, to]) in pieces.iter().enumerate() {
        let hair = hair * (to - from);
        let (from, to) = (from + hair, to - hair);
        let place = |i: usize| from + (to - from) * i as f64 / PIECES as f64;
        let values: [[f64; N]; PIECES + 1] = std::array::from_fn(|i| f(piece, place(i)));
        for (k, tops) in tops.iter_mut().enumerate() {
            for i in 0..=PIECES {
                let around = [i.saturating_sub(1), i, (i + 1).min(PIECES)];
                let [before, value, after] = around.map(|i| values[i][k]);
                // NaN is neither above nor below a number.
                if value.is_nan() || value < before || value < after {
                    continue;
                }
                if value > best[k].value {
                    best[k] = Top { piece, place: place(i), value };
                }
                let rise = (value - before).max(value - after).max(0.0);
                tops.push((value + 2.0 * rise, piece, around.map(|i| (place(i), values[i][k]))));
            }
        }
    }
    for (k, best) in best.iter_mut().enumerate() {
        for &(reach, piece, bracket) in &tops[k] {
            if reach > best.value {
                let (place, value) = summit(bracket, |place| f(piece, place)[k]);
                if value > best.value {
                    *best = Top { piece, place, value };
                }
            }
        }
    }
    best
}

/// Values `place + k·period` within a range, for whole numbers `k`.
pub(super) fn windings(place: f64, period: f64, [from, to]: [f64; 2]) -> impl Iterator<Item = f64> {
    let first = place + period * ((from - place) / period).ceil();
    let count = ((to - first) / period).floor();
    (0..=count.max(-1.0) as i64).map(move |k| first + period * k as f64).filter(move |&x| x <= to)
}

/// The arc length of a wheel.
pub(super) fn arc(side: Side) -> By {
    match side {
        Side::Stator => By::StatorArc,
        Side::Rotor => By::RotorArc,
    }
}

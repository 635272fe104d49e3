//! What the flanks' modules share: directions of the forces, loaded phases, greatest values on smooth pieces.

use crate::Error;
use crate::contact::{By, Conjugate, Contact};
use crate::motor::Motor;
use crate::profile::Side;
use crate::quantity::Quantity;
use crate::roots::{bracketed, golden};
use crate::tolerance::{BESIDE_JUMP, WITHIN};
use crate::units::{degrees, finite_angle, in_degrees};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use uom::si::f64::Angle;

/// Pieces in which a smooth stretch is looked at for its extremes.
const PIECES: u32 = 8;

/// Steps of a golden section: a hundred-thousandth of the bracket is left, and of a flat value its square.
const STEPS: u32 = 24;

/// A pressure angle of a tooth form, in radians.
pub(super) fn pressure_angle(value: Angle) -> Result<f64, Error> {
    let alpha = finite_angle(Quantity::PressureAngle, value)?;
    let value = in_degrees(value);
    if (10.0..=40.0).contains(&value) {
        return Ok(alpha);
    }
    Err(Error::OutOfRange { quantity: Quantity::PressureAngle, value, low: 10.0, high: 40.0, unit: "°" })
}

/// Unit vector, in the frame of the ray, of the force of a flank on a satellite that is pushed by `sigma`; of the back flank for
/// the opposite sign.
pub(super) fn direction(side: Side, sigma: f64, alpha: f64, mu: f64) -> [f64; 2] {
    let (sin, cos) = (alpha + sigma * mu).sin_cos();
    let out = match side {
        Side::Stator => -1.0,
        Side::Rotor => 1.0,
    };
    [out * sin, -sigma * cos]
}

/// Moment of such a force of 1 about the satellite's centre, over `r·cos α`.
pub(super) fn moment(side: Side, sigma: f64) -> f64 {
    match side {
        Side::Stator => -sigma,
        Side::Rotor => sigma,
    }
}

/// `N/(Δp·b·m)` on either flank with contacts at the pitch points.
pub(super) fn flank_number(r: f64, alpha: f64, contact: &Contact, sigma: f64) -> Result<f64, Error> {
    let mu = contact.mu;
    let carrying = (alpha + sigma * mu).cos();
    if carrying <= WITHIN {
        let most_deg = degrees(FRAC_PI_2 - alpha);
        return Err(Error::CannotHold { slope_deg: degrees(sigma * mu), most_deg });
    }
    Ok(r * mu.cos() / carrying)
}

/// A vector turned.
pub(super) fn turned([x, y]: [f64; 2], by: f64) -> [f64; 2] {
    let (sin, cos) = by.sin_cos();
    [x * cos - y * sin, x * sin + y * cos]
}

impl Motor {
    /// Phases between which a satellite by a crest, or by a trough, parts high from low pressure: `±π/N` about it.
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

    /// The sign of the force on a satellite at a phase for a pressure drop of this sign; none while it is idle.
    pub(super) fn pushed(&self, phase: f64, pressure_drop: f64) -> Option<f64> {
        let end = self.shape.trough().phase;
        let half = PI / f64::from(self.numbers().stator_lobes());
        let rest = (phase - 2.0 * (phase / (2.0 * end)).round() * end).abs();
        if rest < half {
            Some(Self::push(true, pressure_drop))
        } else {
            (end - rest < half).then(|| Self::push(false, pressure_drop))
        }
    }

    /// Places within a range of phases where the motion has a kink, and both its ends, in order.
    pub(super) fn smooth_ends(&self, [from, to]: [f64; 2], more: impl IntoIterator<Item = f64>) -> Vec<f64> {
        let period = 2.0 * self.shape.trough().phase;
        let kinks = self.shape.kink().into_iter().flat_map(|kink| [kink, -kink]);
        let kinks = kinks.flat_map(|kink| windings(kink, period, [from, to]));
        let mut ends: Vec<f64> = kinks.chain(more).filter(|&place| place > from && place < to).collect();
        ends.extend([from, to]);
        ends.sort_by(f64::total_cmp);
        // Two that rounding parts are one.
        ends.dedup_by(|late, early| *late - *early < WITHIN * (to - from));
        ends
    }

    /// The period of everything that depends on the pressures of ideal ports: `2π/lcm(N, n)`.
    pub(super) fn period(&self) -> f64 {
        let numbers = self.numbers();
        TAU * f64::from(numbers.common_divisor()) / f64::from(numbers.stator_lobes() * numbers.rotor_lobes())
    }

    /// The phases of steepest slope `μ` on a half-lobe, to the last bits: where the stator's curvature passes that of the circle
    /// about the axis that touches the same ray, `κ₃ = cos μ/ρ₃`.
    pub(super) fn steepest(&self) -> Vec<f64> {
        const PLACES: u32 = 64;
        let rise = |phase: f64| {
            let Contact { mu, rho3, kappa3, .. } = self.shape.within(By::Phase, phase);
            mu.cos() / rho3 - kappa3
        };
        let end = self.shape.trough().phase;
        let ends = self.smooth_ends([0.0, end], []);
        let mut places = ends.clone();
        for pair in ends.windows(2) {
            let hair = BESIDE_JUMP * (pair[1] - pair[0]);
            let (from, to) = (pair[0] + hair, pair[1] - hair);
            let place = |i: u32| from + (to - from) * f64::from(i) / f64::from(PLACES);
            let mut before = rise(from);
            for i in 1..=PLACES {
                let here = rise(place(i));
                if before * here < 0.0 {
                    places.push(bracketed(place(i - 1), place(i), rise));
                }
                before = here;
            }
        }
        places
    }
}

/// The greatest value of a function that is smooth between neighbouring `ends`, and its place: [`greatest_of`].
pub(super) fn greatest_on(ends: &[f64], hair: f64, f: impl Fn(usize, f64) -> f64) -> (f64, f64) {
    let pieces: Vec<[f64; 2]> = ends.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    let (_, place, value) = greatest_of(&pieces, hair, f);
    (place, value)
}

/// The greatest value of a function that is smooth on some pieces: the piece, the place, and the value.
///
/// `f` is told the index of the piece, so that it keeps to one branch there up to both ends; one that does not, but jumps, is taken a
/// `hair` of the piece within. Each piece is sampled; those are refined, by golden section about their best sample, that reach the best of all if
/// they rise from there by as much as they have come from its neighbours.
pub(super) fn greatest_of(
    pieces: &[[f64; 2]],
    hair: f64,
    f: impl Fn(usize, f64) -> f64,
) -> (usize, f64, f64) {
    let mut best = (0, f64::NAN, f64::NEG_INFINITY);
    let mut tops = Vec::with_capacity(pieces.len());
    for (piece, &[from, to]) in pieces.iter().enumerate() {
        let hair = hair * (to - from);
        let (from, to) = (from + hair, to - hair);
        let place = |i: u32| from + (to - from) * f64::from(i) / f64::from(PIECES);
        let mut values = [0.0; PIECES as usize + 1];
        let mut top = 0;
        for (i, value) in values.iter_mut().enumerate() {
            *value = f(piece, place(i as u32));
        }
        for (i, &value) in values.iter().enumerate() {
            if value > values[top] || values[top].is_nan() {
                top = i;
            }
        }
        let around = &values[top.saturating_sub(1)..=(top + 1).min(PIECES as usize)];
        let rise = around.iter().map(|value| values[top] - value).fold(0.0, f64::max);
        if values[top] > best.2 {
            best = (piece, place(top as u32), values[top]);
        }
        let i = top as u32;
        tops.push((values[top] + rise, [place(i.saturating_sub(1)), place((i + 1).min(PIECES))]));
    }
    for (piece, (reach, [low, high])) in tops.into_iter().enumerate() {
        if reach > best.2 {
            let (at, least) = golden(low, high, STEPS, |x| -f(piece, x));
            if -least > best.2 {
                best = (piece, at, -least);
            }
        }
    }
    best
}

/// All `place + k·period` within a range, whole numbers `k`.
pub(super) fn windings(place: f64, period: f64, [from, to]: [f64; 2]) -> impl Iterator<Item = f64> {
    let first = place + period * ((from - place) / period).ceil();
    let count = ((to - first) / period).floor();
    (0..=count.max(-1.0) as i64).map(move |k| first + period * k as f64).filter(move |&x| x <= to)
}

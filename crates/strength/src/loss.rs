//! Losses of a mesh by sliding of the teeth, by Ohlendorf's closed form as calculations print it.
//!
//! The formula holds where the pitch point lies between one pair in contact, `0 ≤ ε_1, ε_2 ≤ 1`. In a ring
//! the pitch point often lies outside the path of contact, and the closed form then gives too high a loss.
//! The losses of gearboxes are calculated from the integral behind it,
//! [`sliding`](epicyclic_gears::involute::sliding). The closed form is for the comparison with print.
//!
//! ```text
//! P_V = P·H_V·μ_m
//! H_V = π·|u + 1|/(z_1·|u|·cos β_b)·(1 − ε_α + ε_1² + ε_2²)       u = z_2/z_1, below 0 with an internal gear
//! ```
//!
//! | symbol | argument | meaning | unit |
//! |---|---|---|---|
//! | `P` | `power` | rolling power of the mesh: `T·ω` relative to the carrier | W |
//! | `μ_m` | `friction` | mean coefficient of friction, given: no formula for it could be tested | 1 |
//! | `ε_1`, `ε_2` | | parts of `ε_α` from the pitch point to the tips of the first, second gear | 1 |
//!
//! `ε_1` or `ε_2` is below 0 where the pitch point lies outside the path of contact.
//!
//! # Source
//! `H_V` after Ohlendorf. Tested against the FZG gear type C (0.1986) and the NREL reference wind gearbox
//! (0.149).

use crate::checks::not_negative;
use crate::{Error, Quantity};
use epicyclic_gears::involute::Pair;
use epicyclic_units::Physical;
use std::f64::consts::PI;
use uom::si::f64::Power;

/// `H_V` by the closed form.
#[must_use]
pub fn ohlendorf_loss_factor(pair: &Pair) -> f64 {
    let [first, second] = pair.gears();
    let (z1, z2) = (first.teeth().as_f64(), second.teeth().as_f64());
    let sign = if pair.is_internal() { -1.0 } else { 1.0 };
    let [from, to] = pair.contact();
    let pitch_point = pair.working_diameters()[0] / 2.0 * libm::sin(pair.working_angle_rad());
    let [one, two] = [to - pitch_point, pitch_point - from].map(|part| part / pair.base_pitch());
    let form = (z2 + sign * z1) / (z1 * z2);
    let beta_b = first.profile().base_helix_rad();
    PI * form / libm::cos(beta_b) * (1.0 - (one + two) + one * one + two * two)
}

/// `P_V` by the closed form.
///
/// # Errors
/// [`Error::Negative`] for a friction or power below 0 or not finite.
pub fn power_loss(pair: &Pair, power: Power, friction: f64) -> Result<Power, Error> {
    let power_w = not_negative(Quantity::Power, power.si(), "W")?;
    Ok(Power::from_si(
        power_w * ohlendorf_loss_factor(pair) * not_negative(Quantity::Friction, friction, "")?,
    ))
}

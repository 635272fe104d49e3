//! Objectives of sets of teeth to twice a double's digits, and the point of a grid where they belong.

use super::double::Double;
use crate::objectives::{on_grid, on_relative_grid};
use crate::tolerance::{GRID_STEP, RELATIVE_STEP, TIE};
use epicyclic_schemes::structures::SetRoles;

/// Coefficients of a set with losses by role, times the teeth of its sun, and times `η₀` where it divides.
/// `exponent` is the direction of its rolling power, 1 from sun to ring.
pub(super) fn coefficients(set: SetRoles, teeth: [f64; 2], exponent: i8, eta0: f64) -> [Double; 4] {
    let eta0 = Double::from(eta0);
    let [sun, ring] = teeth.map(Double::from);
    let [sun, ring] = match exponent {
        1 => [sun, ring * eta0],
        -1 => [sun * eta0, ring],
        _ => [sun, ring],
    };
    let mut found = [Double::from(0.0); 4];
    for (role, value) in set.into_iter().zip([sun, ring, -(sun + ring)]) {
        found[role.index()] = value;
    }
    found
}

/// Cube of the relative ring diameter of a set of these teeth of sun and ring, and of the planet, one planet
/// carrying all: `k³·(1 + 1/r)/(w²·min(1, r))` times the torque on the sun.
pub(super) fn cube([sun, ring]: [f64; 2], planet: f64, working: f64, torque: Double) -> Double {
    let (one, w) = (Double::from(1.0), Double::from(working));
    let [k, r] = [ring, planet].map(|teeth| Double::from(teeth) / Double::from(sun));
    k * k * k * (one + one / r) / r.min(one) / (w * w) * torque
}

/// Distance of two numbers of 40 bits near a value.
#[inline]
pub(super) fn relative_step(value: f64) -> f64 {
    f64::from_bits(value.to_bits() & f64::INFINITY.to_bits()) * RELATIVE_STEP
}

/// An efficiency as a cost, on the grid.
pub(super) fn efficiency_cost(efficiency: Double) -> f64 {
    nearest(-efficiency, on_grid(-efficiency.high), GRID_STEP)
}

/// The cube of a size as a cost, on its grid.
pub(super) fn size_cost(cube: Double) -> f64 {
    nearest(cube, on_relative_grid(cube.high), relative_step(cube.high))
}

/// The point of a grid nearest to a value, from a point next to it; the upper of two equally near.
fn nearest(value: Double, point: f64, step: f64) -> f64 {
    let off = ((value - Double::from(point)) / Double::from(step)).high;
    let half = 0.5 - TIE;
    if off >= half {
        point + step
    } else if off < -0.5 - TIE {
        point - step
    } else {
        point
    }
}

//! The involute function `inv α = tan α − α` and its inverse.

use crate::tolerance::SAME;
use std::f64::consts::FRAC_PI_2;

/// Steps after which Newton's method has ended for every number: it takes four or five.
const MOST_STEPS: u32 = 60;

/// `inv α = tan α − α`, of an angle in rad.
///
/// ```
/// use epicyclic_gears::involute::function::involute;
/// // A printed table: inv 20° = 0.014904.
/// assert!((involute(20.0_f64.to_radians()) - 0.014_904).abs() < 5e-7);
/// ```
#[must_use]
pub fn involute(angle_rad: f64) -> f64 {
    libm::tan(angle_rad) - angle_rad
}

/// The angle in 0…90°, rad, whose involute function has this value; `None` below 0 and for what is not
/// finite.
///
/// Newton's method on `tan α − α − v`, which is convex: from a start above the root it falls to it and never
/// passes it. The start `tan α₀ = (3·v)^(1/3) + v` is above it for every `v`, since `tan³α/3 ≥ inv α` for no
/// angle and `tan α ≥ inv α` for all.
#[must_use]
pub fn angle_of_involute(value: f64) -> Option<f64> {
    if !(value.is_finite() && value >= 0.0) {
        return None;
    }
    // In t = tan α: t − atan t = v, with the derivative t²/(1 + t²).
    let mut t = libm::cbrt(3.0 * value) + value;
    for _ in 0..MOST_STEPS {
        if t == 0.0 {
            return Some(0.0);
        }
        let next = t - (t - libm::atan(t) - value) * (1.0 + t * t) / (t * t);
        let is_done = (next - t).abs() <= SAME * t;
        t = next;
        if is_done {
            break;
        }
    }
    Some(libm::atan(t).min(FRAC_PI_2))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn nothing_has_an_involute_below_0() {
        for value in [-1e-9, f64::NAN, f64::INFINITY] {
            assert_eq!(angle_of_involute(value), None);
        }
        assert_eq!(angle_of_involute(0.0), Some(0.0));
    }

    proptest! {
        #[test]
        fn the_inverse_returns(degrees in 0.5..85.0_f64) {
            let angle = degrees.to_radians();
            let back = angle_of_involute(involute(angle)).unwrap();
            // The function loses the digits of tan α and α that are alike: α³/3 of α is left.
            prop_assert!((back - angle).abs() < 1e-14 / (angle * angle).min(1.0), "{degrees}");
        }

        #[test]
        fn it_rises(one in 0.0..50.0_f64, other in 0.0..50.0_f64) {
            let angle = |value| angle_of_involute(value).unwrap();
            prop_assert_eq!(one < other, angle(one) < angle(other));
        }
    }
}

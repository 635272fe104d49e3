//! The plain way to the greatest values, one function at a time by golden sections, against which the tests
//! hold the fast one.

use crate::contact::{By, Conjugate, Contact};
use crate::motor::Motor;
use crate::tolerance::BESIDE_JUMP;
use epicyclic_numerics::extremes::golden;
use epicyclic_numerics::roots::bracketed;

/// Samples of a piece: peaks of extreme motors rise within a fiftieth of it.
const PIECES: u32 = 128;

/// A hundred-thousandth of the bracket is left, and of a flat value its square.
const STEPS: u32 = 24;

/// The greatest value of a function that is smooth on some pieces: the piece, the place, and the value. Every
/// sample that its neighbours do not exceed is a summit to look at.
pub(super) fn greatest_of(
    pieces: &[[f64; 2]],
    hair: f64,
    f: impl Fn(usize, f64) -> f64,
) -> (usize, f64, f64) {
    let mut best = (0, f64::NAN, f64::NEG_INFINITY);
    for (piece, &[from, to]) in pieces.iter().enumerate() {
        let hair = hair * (to - from);
        let (from, to) = (from + hair, to - hair);
        let place = |i: u32| from + (to - from) * f64::from(i) / f64::from(PIECES);
        let values: Vec<f64> = (0..=PIECES).map(|i| f(piece, place(i))).collect();
        for i in 0..=PIECES {
            let (low, high) = (i.saturating_sub(1), (i + 1).min(PIECES));
            let [value, before, after] = [i, low, high].map(|i| values[i as usize]);
            if value > best.2 {
                best = (piece, place(i), value);
            }
            if value.is_nan() || value < before || value < after {
                continue;
            }
            let (at, least) = golden(place(low), place(high), STEPS, |x| -f(piece, x));
            if -least > best.2 {
                best = (piece, at, -least);
            }
        }
    }
    best
}

/// The phases of steepest slope on a half-lobe by roots of `cos μ/ρ₃ − κ₃` among many places.
pub(super) fn steepest_of(motor: &Motor) -> Vec<f64> {
    const PLACES: u32 = 64;
    let rise = |phase: f64| {
        let Contact { mu, rho3, kappa3, .. } = motor.shape.within(By::Phase, phase);
        libm::cos(mu) / rho3 - kappa3
    };
    let end = motor.shape.trough().phase;
    let ends = motor.smooth_ends([0.0, end], []);
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

mod tests {
    use super::*;
    use crate::centrode::tests::any_motor;
    use crate::flanks::kernel;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn the_steepest_slope_is_that_of_the_plain_way(motor in any_motor()) {
            let steepest = |places: Vec<f64>| {
                places.into_iter().map(|phase| -motor.shape.within(By::Phase, phase).mu).fold(0.0, f64::max)
            };
            let (fast, slow) = (steepest(motor.steepest()), steepest(steepest_of(&motor)));
            prop_assert!((fast - slow).abs() <= 1e-12 * slow, "{fast} {slow}");
        }

        /// Greatest values of polynomials with a few extremes, those at ends included.
        #[test]
        fn the_greatest_values_are_those_of_golden_sections(
            coefficients in prop::array::uniform2(prop::array::uniform4(-1.0..1.0_f64)), cut in 0.1..0.9,
        ) {
            let value = |[a, b, c, d]: [f64; 4], x: f64| 2.0 + a * x + b * x * x + c * libm::sin(3.0 * x) + d * libm::cos(2.0 * x);
            let pieces = [[-1.0, cut], [cut, 1.0]];
            let tops = kernel::greatest_of(&pieces, 0.0, |_, x| coefficients.map(|of| value(of, x)));
            for (top, of) in tops.into_iter().zip(coefficients) {
                let (_, place, slow) = greatest_of(&pieces, 0.0, |_, x| value(of, x));
                prop_assert!((top.value - slow).abs() <= 1e-9 * slow, "{top:?} {place} {slow}");
            }
        }
    }
}

//! Roots of functions of one variable: where they change their sign, where a property ends, where
//! they have a value.
//!
//! ```
//! use epicyclic_numerics::roots::{bisected, bracketed};
//! assert!((bracketed(0.0, 2.0, |x| x * x - 2.0) - 2.0_f64.sqrt()).abs() < 1e-15);
//! let [low, high] = bisected([0.0, 2.0], 30, |x| x * x < 2.0);
//! assert!(low * low < 2.0 && high * high >= 2.0 && high - low < 2e-9);
//! ```

/// The root of a function that changes its sign between `low` and `high`, to the last bits (Brent).
///
/// Of a jump through 0 the root is the place of the jump. A value that is no number counts as
/// positive, so that a search keeps to where the function is one. A smooth function takes about a
/// dozen evaluations.
#[must_use]
pub fn bracketed(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let value = |x: f64| {
        let y = f(x);
        if y.is_nan() { f64::MAX } else { y.clamp(-f64::MAX, f64::MAX) }
    };
    let (mut f_low, mut f_high) = (value(low), value(high));
    if f_low == 0.0 {
        return low;
    }
    // `high` is the better end, `low` the one across the root, `before` the last but one.
    if f_low.abs() < f_high.abs() {
        (low, high, f_low, f_high) = (high, low, f_high, f_low);
    }
    let (mut before, mut f_before) = (low, f_low);
    let (mut step_before, mut bisected) = (0.0, true);
    for _ in 0..200 {
        let reach = 2.0 * f64::EPSILON * high.abs();
        if f_high == 0.0 || (high - low).abs() <= reach {
            break;
        }
        let mut next = if f_low != f_before && f_high != f_before {
            // Inverse quadratic interpolation.
            low * f_high * f_before / ((f_low - f_high) * (f_low - f_before))
                + high * f_low * f_before / ((f_high - f_low) * (f_high - f_before))
                + before * f_low * f_high / ((f_before - f_low) * (f_before - f_high))
        } else {
            high - f_high * (high - low) / (f_high - f_low)
        };
        let bound = 0.75 * low + 0.25 * high;
        let inside = (next > bound.min(high)) && (next < bound.max(high));
        let last = if bisected { (high - before).abs() } else { step_before };
        bisected = !inside || (next - high).abs() >= last / 2.0 || last < reach;
        if bisected {
            next = 0.5 * low + 0.5 * high;
        }
        let f_next = value(next);
        step_before = (before - high).abs();
        (before, f_before) = (high, f_high);
        if (f_low < 0.0) == (f_next < 0.0) {
            (low, f_low) = (next, f_next);
        } else {
            (high, f_high) = (next, f_next);
        }
        if f_low.abs() < f_high.abs() {
            (low, high, f_low, f_high) = (high, low, f_high, f_low);
        }
    }
    high
}

/// Ends of the interval in which a property ends, after `halvings` halvings: the first has the property,
/// the second has not.
///
/// The property is not evaluated at the given ends, and the first end may be the greater.
#[inline]
pub fn bisected(ends: [f64; 2], halvings: u32, has: impl FnMut(f64) -> bool) -> [f64; 2] {
    bisected_while(ends, |made, _| made < halvings, has)
}

/// [`bisected`] as long as it is to go on, by the number of halvings made and the ends.
#[inline]
pub fn bisected_while(
    [mut first, mut second]: [f64; 2],
    goes_on: impl Fn(u32, [f64; 2]) -> bool,
    mut has: impl FnMut(f64) -> bool,
) -> [f64; 2] {
    let mut made = 0;
    while goes_on(made, [first, second]) {
        let middle = f64::midpoint(first, second);
        if has(middle) {
            first = middle;
        } else {
            second = middle;
        }
        made += 1;
    }
    [first, second]
}

/// The argument between 0 and `end` at which a growing function has a value: Newton's method kept
/// within a bracket.
///
/// ```text
/// x ← x − (f(x) − value)/f′(x)
/// ```
///
/// `f` returns value and slope; the last step is below rounding of `end`.
#[must_use]
pub fn inverse(value: f64, end: f64, start: f64, f: impl Fn(f64) -> (f64, f64)) -> f64 {
    let (mut low, mut high) = (0.0, end);
    let mut x = start.clamp(low, high);
    let mut last = f64::INFINITY;
    for _ in 0..100 {
        let (y, slope) = f(x);
        let error = y - value;
        if error == 0.0 {
            return x;
        }
        if error < 0.0 {
            low = x;
        } else {
            high = x;
        }
        let mut next = x - error / slope;
        // Halve where Newton leaves the bracket or is slow.
        if !(next >= low && next <= high) || error.abs() > 0.5 * last {
            next = 0.5 * (low + high);
        }
        last = error.abs();
        if (next - x).abs() <= 2.0 * f64::EPSILON * end {
            return next;
        }
        x = next;
    }
    x
}

/// [`inverse`] of a function that returns value, slope and second derivative: Halley's method kept
/// within a bracket.
///
/// ```text
/// x ← x − n/(1 − n·f″(x)/(2·f′(x)))      n = (f(x) − value)/f′(x)
/// ```
#[must_use]
pub fn smooth_inverse(value: f64, end: f64, start: f64, f: impl Fn(f64) -> [f64; 3]) -> f64 {
    let (mut low, mut high) = (0.0, end);
    let mut x = start.clamp(low, high);
    let mut last = f64::INFINITY;
    for _ in 0..100 {
        let [y, slope, bend] = f(x);
        let error = y - value;
        if error == 0.0 {
            return x;
        }
        if error < 0.0 {
            low = x;
        } else {
            high = x;
        }
        let newton = error / slope;
        let curved = 0.5 * newton * bend / slope;
        let mut next = x - newton / (1.0 - curved);
        let sound = next >= low && next <= high && error.abs() <= 0.5 * last;
        if !sound {
            next = 0.5 * (low + high);
        }
        last = error.abs();
        let step = (next - x).abs();
        // Thrice as many digits with each step: what is left is of the order of step · curved².
        if step <= 2.0 * f64::EPSILON * end || (sound && curved.abs() < 1e-5 && step < 1e-5 * end) {
            return next;
        }
        x = next;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bracketed_root_is_found_to_the_last_bits() {
        let root = bracketed(0.0, 2.0, |x| x * x - 2.0);
        assert!((root - 2.0_f64.sqrt()).abs() <= 4e-16);
        assert!((bracketed(3.0, 0.1, libm::log) - 1.0).abs() <= 4e-16);
        assert!((bracketed(0.0, 1.0, |x| (x - 0.3).powi(3)) - 0.3).abs() < 1e-5);
        assert!((bracketed(0.0, 1.0, |x| if x < 0.7 { -1.0 } else { f64::NAN }) - 0.7).abs() < 1e-15);
    }

    type Function = fn(f64) -> f64;

    /// Halving alone takes more than fifty evaluations.
    #[test]
    fn a_smooth_function_takes_a_dozen_evaluations() {
        let functions: [(f64, f64, Function); 6] = [
            (0.0, 1.0, |x| libm::cos(x) - x),
            (0.0, 5.0, |x| libm::exp(x) - 5.0),
            (1.0, 2.0, |x| x * x * x - x - 2.0),
            (0.1, 9.0, |x| libm::log(x) - 1.0),
            (-1.0, 3.0, |x| libm::atan(x) - 0.3),
            (0.0, 1.0, |x| x.powi(5) - 0.1),
        ];
        for (low, high, f) in functions {
            let count = std::cell::Cell::new(0);
            let root = bracketed(low, high, |x| {
                count.set(count.get() + 1);
                f(x)
            });
            assert!(f(root).abs() < 4e-15, "{root}");
            assert!(count.get() <= 15, "{root} after {}", count.get());
        }
    }

    #[test]
    fn halvings_close_in_from_either_side() {
        assert_eq!(bisected([0.0, 1.0], 3, |x| x <= 0.3), [0.25, 0.375]);
        assert_eq!(bisected([1.0, 0.0], 3, |x| x > 0.3), [0.375, 0.25]);
        assert_eq!(bisected([0.0, 1.0], 0, |_| true), [0.0, 1.0]);
        let [first, second] = bisected_while([0.0, 8.0], |_, [a, b]| b - a > 0.5, |x| x < 5.2);
        assert_eq!([first, second], [5.0, 5.5]);
    }

    #[test]
    fn growing_functions_are_inverted() {
        let cube = |x: f64| (x * x * x, 3.0 * x * x);
        assert!((inverse(8.0, 3.0, 0.0, cube) - 2.0).abs() < 1e-15);
        assert!((inverse(0.0, 3.0, 1.0, cube)).abs() < 1e-4);
        assert!((inverse(27.0, 3.0, 1.0, cube) - 3.0).abs() < 1e-15);
        let bent = |x: f64| [x * x * x, 3.0 * x * x, 6.0 * x];
        for start in [0.0, 0.1, 1.9, 3.0] {
            assert!((smooth_inverse(8.0, 3.0, start, bent) - 2.0).abs() < 1e-15);
            assert!((smooth_inverse(0.0, 3.0, start, bent)).abs() < 1e-4);
            assert!((smooth_inverse(27.0, 3.0, start, bent) - 3.0).abs() < 1e-15);
        }
    }
}

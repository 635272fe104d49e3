//! Bracketed roots and least values of functions of one variable, and quadrature.

/// The root of a function that changes its sign between `low` and `high`, to the last bits (Brent).
///
/// Of a jump through 0 it returns the place of the jump. A value that is no number counts as positive, so that a
/// search keeps to where the function is one.
pub(crate) fn bracketed(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
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

/// The least value of a function between two arguments by golden section, and its argument.
pub(crate) fn golden(low: f64, high: f64, steps: u32, f: impl Fn(f64) -> f64) -> (f64, f64) {
    const PART: f64 = 0.381_966_011_250_105;
    let (mut low, mut high) = (low, high);
    let (mut a, mut b) = (low + PART * (high - low), high - PART * (high - low));
    let (mut f_a, mut f_b) = (f(a), f(b));
    for _ in 0..steps {
        if f_a < f_b {
            (high, b, f_b) = (b, a, f_a);
            a = low + PART * (high - low);
            f_a = f(a);
        } else {
            (low, a, f_a) = (a, b, f_b);
            b = high - PART * (high - low);
            f_b = f(b);
        }
    }
    if f_a < f_b { (a, f_a) } else { (b, f_b) }
}

/// Nodes and weights of the Gauss–Legendre rule of eight points on −1…1, the positive half.
const GAUSS: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_29),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_47),
    (0.960_289_856_497_536_2, 0.101_228_536_290_376_26),
];

/// `∫ f dx` from `from` to `to` by eight-point Gauss–Legendre rules on equal panels.
pub(crate) fn quadrature(from: f64, to: f64, panels: u32, f: impl Fn(f64) -> f64) -> f64 {
    let half = (to - from) / (2.0 * f64::from(panels));
    let panel = |i: u32| {
        let middle = from + half * f64::from(2 * i + 1);
        GAUSS.iter().map(|&(x, w)| w * (f(middle - half * x) + f(middle + half * x))).sum::<f64>()
    };
    half * (0..panels).map(panel).sum::<f64>()
}

/// The same of four points.
const FEW: [(f64, f64); 2] = [
    (0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
    (0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
];

/// The integrals of several functions at once by the eight-point rule on one panel.
pub(crate) fn quadratures<const N: usize>(from: f64, to: f64, f: impl Fn(f64) -> [f64; N]) -> [f64; N] {
    by_rule(&GAUSS, from, to, f)
}

/// The same by the four-point rule.
pub(crate) fn few_quadratures<const N: usize>(from: f64, to: f64, f: impl Fn(f64) -> [f64; N]) -> [f64; N] {
    by_rule(&FEW, from, to, f)
}

fn by_rule<const N: usize>(rule: &[(f64, f64)], from: f64, to: f64, f: impl Fn(f64) -> [f64; N]) -> [f64; N] {
    let (half, middle) = (0.5 * (to - from), 0.5 * (to + from));
    let mut sums = [0.0; N];
    for &(x, w) in rule {
        let (before, after) = (f(middle - half * x), f(middle + half * x));
        for ((sum, before), after) in sums.iter_mut().zip(before).zip(after) {
            *sum += w * half * (before + after);
        }
    }
    sums
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
    fn eight_points_integrate_degree_fifteen() {
        let exact = (2.0_f64.powi(16) - 1.0) / 16.0;
        assert!((quadrature(1.0, 2.0, 1, |x| x.powi(15)) / exact - 1.0).abs() < 1e-14);
        assert!((quadrature(0.0, 1.0, 4, libm::exp) - (libm::exp(1.0_f64) - 1.0)).abs() < 1e-15);
        let [exponential, power] = quadratures(1.0, 2.0, |x: f64| [libm::exp(x), x.powi(15)]);
        assert!((exponential - (libm::exp(2.0_f64) - libm::exp(1.0_f64))).abs() < 1e-14);
        assert!((power / exact - 1.0).abs() < 1e-14);
        let [seventh] = few_quadratures(1.0, 2.0, |x: f64| [x.powi(7)]);
        assert!((seventh / (255.0 / 8.0) - 1.0).abs() < 1e-14);
    }
}

//! Quadrature: integrals by Gauss–Legendre rules.
//!
//! ```
//! use epicyclic_numerics::quadrature::quadrature;
//! assert!((quadrature(0.0, 1.0, 1, |x| x * x) - 1.0 / 3.0).abs() < 1e-15);
//! ```

/// Nodes and weights of the Gauss–Legendre rule of eight points on −1…1, the positive half.
const GAUSS: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_29),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_47),
    (0.960_289_856_497_536_2, 0.101_228_536_290_376_26),
];

/// `∫ f dx` from `from` to `to` by eight-point Gauss–Legendre rules on equal panels.
#[must_use]
pub fn quadrature(from: f64, to: f64, panels: u32, f: impl Fn(f64) -> f64) -> f64 {
    let half = (to - from) / (2.0 * f64::from(panels));
    let panel = |i: u32| {
        let middle = from + half * f64::from(2 * i + 1);
        GAUSS.iter().map(|&(x, w)| w * (f(middle - half * x) + f(middle + half * x))).sum::<f64>()
    };
    half * (0..panels).map(panel).sum::<f64>()
}

/// Nodes and weights of the Gauss–Legendre rule of four points on −1…1, the positive half.
const FEW: [(f64, f64); 2] = [
    (0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
    (0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
];

/// The integrals of several functions at once by the eight-point rule on one panel.
#[must_use]
pub fn quadratures<const N: usize>(from: f64, to: f64, f: impl Fn(f64) -> [f64; N]) -> [f64; N] {
    by_rule(&GAUSS, from, to, f)
}

/// The integrals of several functions at once by the four-point rule on one panel.
#[must_use]
pub fn few_quadratures<const N: usize>(from: f64, to: f64, f: impl Fn(f64) -> [f64; N]) -> [f64; N] {
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

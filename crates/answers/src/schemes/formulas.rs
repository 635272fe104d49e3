//! Ratios and efficiencies of the schemes as formulas to read; the tests evaluate them against the library.

use super::AnyScheme;
use epicyclic_schemes::catalogue::{ThreeSpeed, TwoSpeed};

/// Ratio of the last braked gear.
pub(super) fn ratio(scheme: AnyScheme) -> &'static str {
    use ThreeSpeed as S;
    match scheme {
        AnyScheme::Two(TwoSpeed::I) => "1+k₁",
        AnyScheme::Two(TwoSpeed::II) => "(1+k₁)/k₁",
        AnyScheme::Two(TwoSpeed::III) => "-k₁",
        AnyScheme::Three(three) => match three {
            S::I1 => "(k₁+1)(k₂+1)/(k₁+k₂+1)",
            S::I2 => "(k₁+1)(k₂+1)/(k₂(k₁+1)+1)",
            S::I3 => "(k₂(k₁+1)+k₁)/k₂",
            S::I4 => "k₁(k₂+1)+1",
            S::II1 => "(k₁+1)(k₂+1)/(k₁(k₂+1)+1)",
            S::II2 => "(k₁+1)(k₂+1)/((k₁+1)(k₂+1)-1)",
            S::II3 => "(k₁+k₂+1)/k₁",
            S::II4 => "(k₂(k₁+1)+1)/(k₁k₂)",
            S::III1 => "-k₁k₂/(k₁+k₂+1)",
            S::III2 => "-(k₁(k₂+1)+k₂)",
            S::III3 => "-(k₁(k₂+1)+1)/k₂",
        },
    }
}

/// Efficiency of the last braked gear.
pub(super) fn efficiency(scheme: AnyScheme) -> &'static str {
    use ThreeSpeed as S;
    match scheme {
        AnyScheme::Two(TwoSpeed::I) => "(1+k₁η₀)/(1+k₁)",
        AnyScheme::Two(TwoSpeed::II) => "(k₁+η₀)/(1+k₁)",
        AnyScheme::Two(TwoSpeed::III) => "η₀",
        AnyScheme::Three(three) => match three {
            S::I1 => "(k₁η₀+1)(k₂η₀+1)(k₁+k₂+1)/((k₁+1)(k₂+1)(k₁η₀+k₂η₀+1))",
            S::I2 => "(k₁η₀+1)(k₂+η₀)(k₂(k₁+1)+1)/((k₁+1)(k₂+1)(k₂(k₁η₀+1)+η₀))",
            S::I3 => "(k₂(k₁η₀+1)+k₁η₀²)/(k₂(k₁+1)+k₁)",
            S::I4 => "(k₁(k₂η₀+1)η₀+1)/(k₁(k₂+1)+1)",
            S::II1 => "(k₁+η₀)(k₂η₀+1)(k₁(k₂+1)+1)/((k₁+1)(k₂+1)(k₁(k₂η₀+1)+η₀))",
            S::II2 => "(k₁+η₀)(k₂+η₀)(k₁(k₂+1)+k₂)/((k₁+1)(k₂+1)(k₁(k₂+η₀)+k₂η₀))",
            S::II3 => "(k₁+(k₂η₀+1)η₀)/(k₁+k₂+1)",
            S::II4 => "(k₂(k₁+η₀)+η₀²)/(k₂(k₁+1)+1)",
            S::III1 => "η₀²(k₁+k₂+1)/((k₁+k₂)η₀+1)",
            S::III2 => "(k₁(k₂η₀+1)+k₂)η₀/(k₁(k₂+1)+k₂)",
            S::III3 => "(k₁(k₂+η₀)+1)η₀/(k₁(k₂+1)+1)",
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use epicyclic_gears::efficiency::MeshEfficiency;
    use epicyclic_gears::simple_set::RingToSunRatio;

    /// The value of a formula, by a library that knows nothing of gears.
    fn value(formula: &str, [k1, k2, eta]: [f64; 3]) -> f64 {
        let plain = formula.replace("k₁", "a").replace("k₂", "b").replace("η₀²", "(e*e)").replace("η₀", "e");
        let mut explicit = String::new();
        for c in plain.chars() {
            let follows =
                explicit.chars().next_back().is_some_and(|last| last.is_alphabetic() || last == ')');
            if follows && (c.is_alphabetic() || c == '(') {
                explicit.push('*');
            }
            explicit.push(c);
        }
        let explicit = explicit.replace('a', &k1.to_string()).replace('b', &k2.to_string());
        exmex::eval_str::<f64>(&explicit.replace('e', &eta.to_string())).unwrap()
    }

    #[test]
    fn formulas_say_what_the_library_computes() {
        for (k1, k2, eta) in [(1.75, 2.5, 0.9375), (2.15, 2.354, 0.97), (6.5, 1.375, 0.9)] {
            let [k, l] = [k1, k2].map(|k| RingToSunRatio::new(k).unwrap());
            let eta0 = MeshEfficiency::new(eta).unwrap();
            for scheme in AnyScheme::all() {
                let [i, efficient] = match scheme {
                    AnyScheme::Two(two) => [two.ratio(k), two.efficiency(k, eta0)],
                    AnyScheme::Three(three) => [three.ratio(k, l), three.efficiency(k, l, eta0)],
                };
                let written = [ratio(scheme), efficiency(scheme)].map(|text| value(text, [k1, k2, eta]));
                assert!((written[0] / i - 1.0).abs() < 1e-12, "{}: {written:?}", scheme.name());
                assert!((written[1] / efficient - 1.0).abs() < 1e-12, "{}: {written:?}", scheme.name());
            }
        }
    }
}

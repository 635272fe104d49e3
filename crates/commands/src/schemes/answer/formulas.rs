//! Ratios and efficiencies of the schemes as readable formulas; the tests evaluate them against the library.

use epicyclic_schemes::catalogue::Scheme;
use epicyclic_schemes::catalogue::table::ClosedForm;

/// Formula of the ratio of the last braked gear.
pub(super) fn ratio(scheme: Scheme) -> String {
    to_read(scheme.ratio_formula())
}

/// Formula of the efficiency of the last braked gear.
pub(super) fn efficiency(scheme: Scheme) -> String {
    to_read(scheme.efficiency_formula())
}

/// Makes a formula readable: `(k1+1)*(k2+1)` → `(k₁+1)(k₂+1)`.
fn to_read(form: ClosedForm) -> String {
    let text = form.text().replace("k1", "k₁").replace("k2", "k₂").replace("eta0", "η₀");
    text.replace('*', "").replace("η₀η₀", "η₀²")
}

#[cfg(test)]
mod tests {
    use super::*;
    use epicyclic_gears::efficiency::MeshEfficiency;
    use epicyclic_gears::simple_set::RingToSunRatio;

    /// Value of a formula, by a library that does not know gears.
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
            for scheme in Scheme::all() {
                let [i, efficient] = match scheme {
                    Scheme::Two(two) => [two.ratio(k), two.efficiency(k, eta0)],
                    Scheme::Three(three) => [three.ratio(k, l), three.efficiency(k, l, eta0)],
                };
                let written = [ratio(scheme), efficiency(scheme)].map(|text| value(&text, [k1, k2, eta]));
                assert!((written[0] / i - 1.0).abs() < 1e-12, "{}: {written:?}", scheme.name());
                assert!((written[1] / efficient - 1.0).abs() < 1e-12, "{}: {written:?}", scheme.name());
            }
        }
    }
}

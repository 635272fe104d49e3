//! Comparison of printed formulas with the solver: at numbers, and as quotients of polynomials in `k1`, `k2`,
//! `eta0`, which decides whether they are equal for all numbers.

use super::{Refusal, Results};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::simple_set::RingToSunRatio;
use epicyclic_schemes::catalogue::Scheme;
use epicyclic_train::formula::Formula;
use epicyclic_train::formula::polynomial::Polynomial as Factor;
use epicyclic_train::{Analysis, Gearbox};
use epicyclic_units::Number;
use exmex::{BinOp, Express, FlatEx, MakeOperators, Operator};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::str::FromStr;

/// A printed formula of a scheme, in `k1`, `k2` and `eta0`.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct PrintedFormulaGiven {
    /// `I`, `II`, `III`, `I-1` … `III-3`.
    scheme: String,
    /// Quantity that the formula gives, for the scheme's last braked gear.
    gives: PrintedQuantity,
    /// The formula: `(k1+1)*(k2+1)/(k1+k2+1)`.
    formula: String,
}

/// Two figures that a source prints side by side, and what it says of their quotient.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct PrintedQuotientGiven {
    /// The greater.
    numerator: Number,
    /// The smaller.
    denominator: Number,
    /// Ends of the range that the source prints.
    range: [Number; 2],
}

pub(super) fn printed_quotient(given: &PrintedQuotientGiven) -> Result<Results, Refusal> {
    let quotient = given.numerator.get() / given.denominator.get();
    if !quotient.is_finite() {
        let message = "the denominator is 0".into();
        return Err(Refusal { name: "no-quotient".into(), message });
    }
    let [from, to] = given.range.map(Number::get);
    let mut results = Results::default();
    results.number("quotient", quotient).answer("within", (from..=to).contains(&quotient));
    Ok(results)
}

/// A formula of named variables.
pub(super) fn evaluate(formula: &str, names: &[(&str, f64)]) -> Result<f64, Refusal> {
    let unreadable = |message: String| Refusal {
        name: "unreadable-formula".into(),
        message: format!("{formula}: {message}"),
    };
    let parsed = exmex::parse::<f64>(formula).map_err(|error| unreadable(error.to_string()))?;
    let value = |name: &String| {
        let known = names.iter().find(|(known, _)| known == name);
        known.map(|(_, value)| *value).ok_or_else(|| unreadable(format!("no variable `{name}`")))
    };
    let values = parsed.var_names().iter().map(value).collect::<Result<Vec<_>, _>>()?;
    parsed.eval(&values).map_err(|error| unreadable(error.to_string()))
}

/// Parameters at which a printed formula is compared with the solver.
pub(super) const GRID: [f64; 6] = [1.3, 1.7, 2.5, 4.0, 7.0, 10.0];

pub(super) fn printed_formula(given: &PrintedFormulaGiven) -> Result<Results, Refusal> {
    let scheme: Scheme = given.scheme.parse()?;
    let (mut largest, mut from_catalogue): (f64, f64) = (0.0, 0.0);
    let mut is_formula = vec![];
    let closed = match given.gives {
        PrintedQuantity::Ratio => scheme.ratio_formula(),
        PrintedQuantity::Efficiency => scheme.efficiency_formula(),
    };
    for k1 in GRID {
        for k2 in GRID {
            for eta0 in [0.9, 0.97, 1.0] {
                let (first, second) = (RingToSunRatio::new(k1)?, RingToSunRatio::new(k2)?);
                let eta = MeshEfficiency::new(eta0)?;
                let (gearbox, gear): (Gearbox, &str) = match scheme {
                    Scheme::Two(scheme) => (scheme.gearbox(first, eta)?, "1"),
                    Scheme::Three(scheme) => (scheme.gearbox(first, second, eta)?, "2"),
                };
                let found = gearbox.analyze(gear)?;
                is_formula.push(is_formula_of(&given.formula, given.gives, &found)?);
                let solved = match given.gives {
                    PrintedQuantity::Ratio => found.ratio(),
                    PrintedQuantity::Efficiency => found.efficiency(),
                };
                let printed = evaluate(&given.formula, &[("k1", k1), ("k2", k2), ("eta0", eta0)])?;
                let off = solved.map_or(f64::INFINITY, |solved| (printed / solved - 1.0).abs());
                largest = largest.max(off);
                from_catalogue = from_catalogue.max((printed / closed.value(k1, k2, eta0) - 1.0).abs());
            }
        }
    }
    // The comparison at numbers and that of the formulas must have the same result.
    let equals_solver = largest < 1e-12;
    if is_formula.iter().any(|is_equal| *is_equal != equals_solver) {
        let message = format!("{}: equal as numbers: {equals_solver}; as formulas not so", given.formula);
        return Err(Refusal { name: "numbers-and-formula-disagree".into(), message });
    }
    let mut results = Results::default();
    results.answer("equals_solver", equals_solver).answer("equals_catalogue", from_catalogue < 1e-12);
    // A difference by rounding would only make the snapshot vary.
    results.number("largest_relative_difference", if largest < 1e-12 { 0.0 } else { largest });
    Ok(results)
}

/// The variables, by their places.
const NAMES: [&str; 3] = ["k1", "k2", "eta0"];

/// Index of `eta0`.
const ETA: usize = 2;

/// Coefficients, none of them 0, by powers of the variables.
type Polynomial = BTreeMap<[u32; 3], i128>;

/// A quotient of polynomials; `None` of what is no such quotient, or has too large numbers.
#[derive(Debug, Clone, Default)]
struct Quotient(Option<[Polynomial; 2]>);

fn constant(number: i128) -> Polynomial {
    if number == 0 { Polynomial::new() } else { Polynomial::from([([0; 3], number)]) }
}

fn variable(place: usize) -> Quotient {
    let mut powers = [0; 3];
    powers[place] = 1;
    Quotient(Some([Polynomial::from([(powers, 1)]), constant(1)]))
}

fn product(one: &Polynomial, other: &Polynomial) -> Option<Polynomial> {
    let mut product = Polynomial::new();
    for (first, a) in one {
        for (second, b) in other {
            let mut powers = *first;
            powers.iter_mut().zip(second).for_each(|(power, more)| *power += more);
            let sum = product.entry(powers).or_insert(0_i128);
            *sum = sum.checked_add(a.checked_mul(*b)?)?;
        }
    }
    product.retain(|_, coefficient| *coefficient != 0);
    Some(product)
}

fn sum(one: &Polynomial, other: &Polynomial) -> Option<Polynomial> {
    let mut sum = one.clone();
    for (powers, coefficient) in other {
        let entry = sum.entry(*powers).or_insert(0_i128);
        *entry = entry.checked_add(*coefficient)?;
    }
    sum.retain(|_, coefficient| *coefficient != 0);
    Some(sum)
}

impl Quotient {
    fn number(number: i64) -> Self {
        Self(Some([constant(number.into()), constant(1)]))
    }

    fn with(self, other: Self, of: fn([Polynomial; 2], [Polynomial; 2]) -> Option<[Polynomial; 2]>) -> Self {
        Self(self.0.zip(other.0).and_then(|(one, other)| of(one, other)))
    }

    fn plus(self, other: Self) -> Self {
        self.with(other, |[a, b], [c, d]| {
            Some([sum(&product(&a, &d)?, &product(&c, &b)?)?, product(&b, &d)?])
        })
    }

    fn times(self, other: Self) -> Self {
        self.with(other, |[a, b], [c, d]| Some([product(&a, &c)?, product(&b, &d)?]))
    }

    fn over(self, other: Self) -> Self {
        self.with(other, |[a, b], [c, d]| (!c.is_empty()).then_some([product(&a, &d)?, product(&b, &c)?]))
    }

    fn negative(self) -> Self {
        self.times(Self::number(-1))
    }

    /// Power with a whole exponent above 0.
    fn power(self, power: Self) -> Self {
        let whole = |[a, b]: [Polynomial; 2]| {
            let number = (b == constant(1)).then(|| a.get(&[0; 3]).copied()).flatten()?;
            (a.len() == 1 && number > 0).then_some(number)
        };
        match power.0.and_then(whole) {
            Some(power) => (1..power).fold(self.clone(), |all, _| all.times(self.clone())),
            None => Self(None),
        }
    }

    /// Whether both formulas are equal: a/b = c/d if a·d = c·b.
    fn equals(&self, other: &Self) -> Option<bool> {
        let ([a, b], [c, d]) = (self.0.as_ref()?, other.0.as_ref()?);
        Some(product(a, d)? == product(c, b)?)
    }
}

impl FromStr for Quotient {
    type Err = std::num::ParseIntError;

    fn from_str(written: &str) -> Result<Self, Self::Err> {
        written.parse().map(Self::number)
    }
}

/// The operators of the printed formulas.
#[derive(Debug, Clone)]
struct Operators;

impl MakeOperators<Quotient> for Operators {
    fn make<'a>() -> Vec<Operator<'a, Quotient>> {
        let binary = |apply, prio, is_commutative| BinOp { apply, prio, is_commutative };
        vec![
            Operator::make_bin("^", binary(Quotient::power, 4, false)),
            Operator::make_bin("*", binary(Quotient::times, 2, true)),
            Operator::make_bin("/", binary(Quotient::over, 3, false)),
            Operator::make_bin("+", binary(Quotient::plus, 0, true)),
            Operator::make_bin_unary(
                "-",
                binary(|one, other| one.plus(other.negative()), 1, false),
                Quotient::negative,
            ),
        ]
    }
}

/// Quantity that a formula gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum PrintedQuantity {
    Ratio,
    Efficiency,
}

/// Whether a printed formula is that of a gear whose sets 1 and 2 have `k1` and `k2`.
///
/// The efficiency is the ratio with each `k` times `eta0` to its exponent in Kreines' rule, over the ratio
/// itself.
fn is_formula_of(printed: &str, quantity: PrintedQuantity, gear: &Analysis<'_>) -> Result<bool, Refusal> {
    let refuse = |message: String| Refusal {
        name: "unreadable-formula".into(),
        message: format!("{printed}: {message}"),
    };
    let parsed = FlatEx::<Quotient, Operators>::parse(printed).map_err(|error| refuse(error.to_string()))?;
    let known = |name: &String| NAMES.iter().position(|known| known == name).map(variable);
    let values = parsed.var_names().iter().map(known).collect::<Option<Vec<_>>>();
    let values = values.ok_or_else(|| refuse("a variable that is not known".into()))?;
    let written = parsed.eval(&values).map_err(|error| refuse(error.to_string()))?;
    let formula = Formula::new(gear).map_err(|why| refuse(why.to_string()))?;
    let exponents = gear.kreines().map(|kreines| kreines.exponents.concat()).unwrap_or_default();
    let set = |symbol: usize| formula.symbols()[symbol].set();
    let plain = value(&formula, |symbol| variable(set(symbol)));
    let solved = match quantity {
        PrintedQuantity::Ratio => plain,
        PrintedQuantity::Efficiency => {
            let lossy = |symbol: usize| match exponents.get(set(symbol)) {
                Some(1) => variable(set(symbol)).times(variable(ETA)),
                Some(-1) => variable(set(symbol)).over(variable(ETA)),
                _ => variable(set(symbol)),
            };
            value(&formula, lossy).over(plain)
        }
    };
    written.equals(&solved).ok_or_else(|| refuse("its numbers are too large, or it is no quotient".into()))
}

/// A formula with quotients in place of its symbols.
fn value(formula: &Formula, symbol: impl Fn(usize) -> Quotient) -> Quotient {
    let of_factor = |factor: &Factor| {
        factor.terms().into_iter().fold(Quotient::number(0), |sum, (coefficient, symbols)| {
            let term =
                symbols.into_iter().fold(Quotient::number(coefficient), |term, one| term.times(symbol(one)));
            sum.plus(term)
        })
    };
    let side = |factors: &[Factor]| {
        factors.iter().fold(Quotient::number(1), |all, factor| all.times(of_factor(factor)))
    };
    side(&formula.ratio().numerator()).over(side(&formula.ratio().denominator()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is(printed: &str, quantity: PrintedQuantity) -> Result<bool, Refusal> {
        let k = RingToSunRatio::new(2.0).unwrap();
        let Ok(Scheme::Three(scheme)) = "II-3".parse() else { unreachable!() };
        let gearbox = scheme.gearbox(k, k, MeshEfficiency::new(0.97).unwrap()).unwrap();
        is_formula_of(printed, quantity, &gearbox.analyze("2").unwrap())
    }

    #[test]
    fn a_formula_is_the_same_however_it_is_written() {
        for same in ["(k1+k2+1)/k1", "1 + (1+k2)/k1", "(k1^2+k1*k2+k1)/k1^2", "-(-1-k1-k2)/k1"] {
            assert!(is(same, PrintedQuantity::Ratio).unwrap(), "{same}");
        }
        // Equal where k1 = k2 = 2 alone.
        assert!(!is("(k1+k2+1)/k2", PrintedQuantity::Ratio).unwrap());
        assert!(is("(k1+(k2*eta0+1)*eta0)/(k1+k2+1)", PrintedQuantity::Efficiency).unwrap());
        assert!(!is("(k1+(k2*eta0+1))/(k1+k2+1)", PrintedQuantity::Efficiency).unwrap());
    }

    #[test]
    fn what_is_no_quotient_of_polynomials_is_refused() {
        for wrong in ["k3", "k1^k2", "k1/(k1-k1)", "2.5*k1", "k1^"] {
            assert!(is(wrong, PrintedQuantity::Ratio).is_err(), "{wrong}");
        }
    }
}

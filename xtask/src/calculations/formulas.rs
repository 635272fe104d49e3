//! Formulas as quotients of polynomials in `k1`, `k2`, `eta0`: equal as formulas, whatever the numbers.

use super::Refusal;
use epicyclic_train::Analysis;
use epicyclic_train::formula::Formula;
use epicyclic_train::formula::polynomial::Polynomial as Factor;
use exmex::{BinOp, Express, FlatEx, MakeOperators, Operator};
use std::collections::BTreeMap;
use std::str::FromStr;

/// The variables, by their places.
const NAMES: [&str; 3] = ["k1", "k2", "eta0"];

/// The place of `eta0`.
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

    /// To a power that is a whole number above 0.
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

    /// Whether both are the same formula: a/b = c/d where a·d = c·b.
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

/// What a formula gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Quantity {
    Ratio,
    Efficiency,
}

/// Whether a printed formula is that of a gear whose sets 1 and 2 have `k1` and `k2`.
///
/// The efficiency is the ratio with each `k` times `eta0` to its exponent in Kreines' rule, over the ratio itself.
pub(super) fn is_formula_of(printed: &str, quantity: Quantity, gear: &Analysis<'_>) -> Result<bool, Refusal> {
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
        Quantity::Ratio => plain,
        Quantity::Efficiency => {
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
    use epicyclic_gears::efficiency::MeshEfficiency;
    use epicyclic_gears::simple_set::RingToSunRatio;
    use epicyclic_schemes::catalogue::Scheme;

    fn is(printed: &str, quantity: Quantity) -> Result<bool, Refusal> {
        let k = RingToSunRatio::new(2.0).unwrap();
        let Ok(Scheme::Three(scheme)) = "II-3".parse() else { unreachable!() };
        let gearbox = scheme.gearbox(k, k, MeshEfficiency::new(0.97).unwrap()).unwrap();
        is_formula_of(printed, quantity, &gearbox.analyze("2").unwrap())
    }

    #[test]
    fn a_formula_is_the_same_however_it_is_written() {
        for same in ["(k1+k2+1)/k1", "1 + (1+k2)/k1", "(k1^2+k1*k2+k1)/k1^2", "-(-1-k1-k2)/k1"] {
            assert!(is(same, Quantity::Ratio).unwrap(), "{same}");
        }
        // Equal where k1 = k2 = 2 alone.
        assert!(!is("(k1+k2+1)/k2", Quantity::Ratio).unwrap());
        assert!(is("(k1+(k2*eta0+1)*eta0)/(k1+k2+1)", Quantity::Efficiency).unwrap());
        assert!(!is("(k1+(k2*eta0+1))/(k1+k2+1)", Quantity::Efficiency).unwrap());
    }

    #[test]
    fn what_is_no_quotient_of_polynomials_is_refused() {
        for wrong in ["k3", "k1^k2", "k1/(k1-k1)", "2.5*k1", "k1^"] {
            assert!(is(wrong, Quantity::Ratio).is_err(), "{wrong}");
        }
    }
}

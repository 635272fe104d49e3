//! Polynomials with integer coefficients, at most of the first degree in each symbol.
//!
//! Such a polynomial has factors that share no symbol. It splits over some of its symbols if its
//! coefficients, as a table of the products of these symbols by the products of the others, have rank 1; a
//! row and a column of the table are then the factors, each times a number.

use crate::elimination::Scalar;
use epicyclic_gears::simple_set::Fraction;
use std::collections::BTreeMap;

/// A product of symbols: a bit for each.
pub(super) type Product = u32;

/// A polynomial: coefficients, none of them 0, by products of symbols.
#[derive(Debug, Clone, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Polynomial {
    terms: BTreeMap<Product, i64>,
}

impl Polynomial {
    /// A number.
    pub(super) fn constant(number: i64) -> Self {
        let mut constant = Self::default();
        constant.add(0, number);
        constant
    }

    /// Adds a coefficient to that of a product.
    pub(super) fn add(&mut self, product: Product, coefficient: i64) {
        let sum = self.terms.entry(product).or_default();
        *sum += coefficient;
        if *sum == 0 {
            self.terms.remove(&product);
        }
    }

    /// Coefficients and symbols of the terms in the order of writing: products of fewer symbols first, then
    /// by symbol. The first positive term, if any, goes to the head.
    #[must_use]
    pub fn terms(&self) -> Vec<(i64, Vec<usize>)> {
        let mut products: Vec<Product> = self.terms.keys().copied().collect();
        let lowest = |product: Product| (product.count_ones(), product.reverse_bits());
        products.sort_by(|one, other| {
            let ((fewer, first), (more, second)) = (lowest(*one), lowest(*other));
            fewer.cmp(&more).then(second.cmp(&first))
        });
        if let Some(head) = products.iter().position(|product| self.terms[product] > 0) {
            products[..=head].rotate_right(1);
        }
        products.into_iter().map(|product| (self.terms[&product], symbols(product).collect())).collect()
    }

    /// Products and their coefficients.
    pub(super) fn products(&self) -> impl Iterator<Item = (Product, i64)> {
        self.terms.iter().map(|(product, coefficient)| (*product, *coefficient))
    }

    /// The symbols that occur, as bits.
    pub(super) fn variables(&self) -> Product {
        self.terms.keys().fold(0, |all, product| all | product)
    }

    /// The greatest number that divides it, with the sign of its lowest term; 0 of the polynomial 0.
    fn content(&self) -> i64 {
        let size = self.terms.values().fold(0, |gcd, coefficient| greatest_divisor(gcd, *coefficient));
        let is_negative = self.terms.values().next().is_some_and(|lowest| *lowest < 0);
        if is_negative { -size } else { size }
    }

    pub(super) fn negated(&self) -> Self {
        self.clone().divided(-1)
    }

    fn divided(mut self, number: i64) -> Self {
        self.terms.values_mut().for_each(|coefficient| *coefficient /= number);
        self
    }

    /// Factors of the polynomial over the symbols `within` and over the others, up to numbers, if it is such
    /// a product.
    fn split(&self, within: Product) -> Option<[Self; 2]> {
        let (base, scale) = self.terms.first_key_value()?;
        let part = |mask: Product| {
            let terms = self.terms.iter().filter(|(product, _)| *product & !mask == base & !mask);
            Self { terms: terms.map(|(product, coefficient)| (product & mask, *coefficient)).collect() }
        };
        let (inner, outer) = (part(within), part(!within));
        if inner.terms.len() * outer.terms.len() != self.terms.len() {
            return None;
        }
        let coefficient = |product: Product| self.terms.get(&product).copied().unwrap_or(0);
        let is_product = inner.terms.iter().all(|(one, first)| {
            outer.terms.iter().all(|(other, second)| scale * coefficient(one | other) == first * second)
        });
        is_product.then_some([inner, outer])
    }

    /// Factors that split no further, without a common divisor of their coefficients and with a positive
    /// lowest term, and the number that they lack.
    pub(super) fn factors(&self) -> (i64, Vec<Self>) {
        let number = self.content();
        if number == 0 {
            return (0, vec![]);
        }
        let primitive = |polynomial: Self| {
            let content = polynomial.content();
            polynomial.divided(content)
        };
        let mut rest = primitive(self.clone());
        let mut factors = vec![];
        while rest.variables() != 0 {
            // The fewest symbols with the lowest one over which the rest splits give a factor that splits no
            // further.
            let all = rest.variables();
            let lowest = all & all.wrapping_neg();
            let others = all ^ lowest;
            let mut choices: Vec<Product> = subsets(others).map(|some| some | lowest).collect();
            choices.sort_by_key(|some| some.count_ones());
            let Some([factor, other]) = choices.into_iter().find_map(|within| rest.split(within)) else {
                break;
            };
            factors.push(primitive(factor));
            rest = primitive(other);
        }
        factors.sort_by_key(|factor| factor.variables().trailing_zeros());
        (number, factors)
    }

    /// Value of the polynomial for these values of the symbols.
    #[must_use]
    pub fn value(&self, symbol: &dyn Fn(usize) -> f64) -> f64 {
        let term = |(product, coefficient): (&Product, &i64)| {
            *coefficient as f64 * symbols(*product).map(symbol).product::<f64>()
        };
        self.terms.iter().map(term).sum()
    }

    /// Exact value of the polynomial for these values of the symbols; `None` if an integer overflows.
    pub(super) fn exact_value(&self, symbols_are: &[Fraction]) -> Option<Fraction> {
        let mut sum = <Fraction as Scalar>::zero();
        for (product, coefficient) in &self.terms {
            // Subtracted with the other sign, since `Scalar` has no addition.
            let mut term = Fraction::from_integer(-i128::from(*coefficient));
            for symbol in symbols(*product) {
                term = Scalar::times(&term, symbols_are.get(symbol)?)?;
            }
            sum = Scalar::minus(&sum, &term)?;
        }
        Some(sum)
    }

    /// Number of terms of the polynomial.
    pub(super) fn len(&self) -> usize {
        self.terms.len()
    }

    /// `1 + k₁ − k₁·k₂`, with these names of the symbols.
    #[must_use]
    pub fn text(&self, name: &dyn Fn(usize) -> String) -> String {
        let mut text = String::new();
        for (coefficient, symbols) in self.terms() {
            text += match (text.is_empty(), coefficient < 0) {
                (true, false) => "",
                (true, true) => "−",
                (false, false) => " + ",
                (false, true) => " − ",
            };
            let size = coefficient.unsigned_abs();
            let number = (size != 1 || symbols.is_empty()).then(|| size.to_string());
            let parts: Vec<String> = number.into_iter().chain(symbols.into_iter().map(name)).collect();
            text += &parts.join("·");
        }
        if text.is_empty() { "0".to_owned() } else { text }
    }
}

impl FromIterator<(u32, i64)> for Polynomial {
    /// The sum of terms: a bit for each symbol of a product, and its coefficient.
    fn from_iter<I: IntoIterator<Item = (u32, i64)>>(terms: I) -> Self {
        let mut sum = Self::default();
        terms.into_iter().for_each(|(product, coefficient)| sum.add(product, coefficient));
        sum
    }
}

/// The symbols of a product.
fn symbols(product: Product) -> impl Iterator<Item = usize> {
    (0..Product::BITS as usize).filter(move |symbol| product >> symbol & 1 == 1)
}

/// Subsets of a set of symbols.
fn subsets(of: Product) -> impl Iterator<Item = Product> {
    let mut next = Some(0);
    std::iter::from_fn(move || {
        let this: Product = next?;
        let following = this.wrapping_sub(of) & of;
        next = (following != 0).then_some(following);
        Some(this)
    })
}

pub(super) fn greatest_divisor(one: i64, other: i64) -> i64 {
    let (mut one, mut other) = (one.abs(), other.abs());
    while other != 0 {
        (one, other) = (other, one % other);
    }
    one
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polynomial(terms: &[(Product, i64)]) -> Polynomial {
        terms.iter().copied().collect()
    }

    fn text(polynomial: &Polynomial) -> String {
        polynomial.text(&|symbol| format!("k{}", symbol + 1))
    }

    #[test]
    fn factors_are_found_with_their_number() {
        // −2·(1 + k₁)·(3 − k₂·k₃)
        let product = polynomial(&[(0, -6), (1, -6), (0b110, 2), (0b111, 2)]);
        let (number, factors) = product.factors();
        assert_eq!(number, -2);
        assert_eq!(factors, [polynomial(&[(0, 1), (1, 1)]), polynomial(&[(0, 3), (0b110, -1)])]);
        let whole = polynomial(&[(0, 1), (1, 1), (0b11, 1)]);
        assert_eq!(whole.factors(), (1, vec![whole]));
        assert_eq!(
            polynomial(&[(0b101, -1)]).factors(),
            (-1, vec![polynomial(&[(1, 1)]), polynomial(&[(4, 1)])])
        );
        assert_eq!(Polynomial::default().factors(), (0, vec![]));
        assert_eq!(Polynomial::constant(-3).factors(), (-3, vec![]));
    }

    #[test]
    fn terms_stand_by_degree_and_symbol_with_a_positive_one_at_the_head() {
        assert_eq!(text(&polynomial(&[(0, 1), (0b11, 1), (0b1, 1)])), "1 + k1 + k1·k2");
        assert_eq!(text(&polynomial(&[(0b11, 1), (0b100, -1)])), "k1·k2 − k3");
        assert_eq!(text(&polynomial(&[(0b101, 1), (0b110, 2), (0b011, 1)])), "k1·k2 + k1·k3 + 2·k2·k3");
        assert_eq!(text(&polynomial(&[(0, -1), (1, -3)])), "−1 − 3·k1");
        assert_eq!(text(&Polynomial::default()), "0");
    }

    #[test]
    fn values_are_sums_of_products() {
        let value = polynomial(&[(0, 1), (0b11, -2)]).value(&|symbol| [3.0, 5.0][symbol]);
        assert!((value + 29.0).abs() < 1e-12);
    }
}

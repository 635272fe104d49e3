//! Solution of homogeneous systems: the unknowns that follow from others, by reduced echelon form with full
//! pivoting.
//!
//! Rank decides the state of a gear, so rank must not depend on rounding. One algorithm works with three
//! kinds of numbers, tried in this order:
//!
//! 1. [`Bounded`]: `f64` with a bound on its error, carried through every operation. A number larger than its
//!    bound is certainly not zero; a zero that no rounding touched is certainly zero. If every decision is
//!    certain, the result is proved. This is the fast and the usual way.
//! 2. [`Fraction`]: used if a number is as small as its bound, or a speed has lost digits, and all ratios are
//!    tooth counts or decimals. The elimination is repeated without rounding, in 128 bits.
//! 3. [`Traced`]: used if the numbers do not fit there, or a ratio has more digits than anybody writes. The
//!    elimination has no rounding at all, in as many bits as needed, and each number carries its exact
//!    derivatives by these ratios.
//!
//! # Ratios with many digits
//! A ratio of more than 12 digits, `k = 0.43333333333333335`, was computed and rounded. Its value is taken as
//! the rational number that the `f64` is. The elimination may leave a number `v` of these ratios that is not
//! zero. Such a number counts as zero only if a change of the ratios by a few roundings makes it zero:
//!
//! ```text
//! 0 < |v| ≤ 4·ε·Σ |k_j·∂v/∂k_j|      ε = 2⁻⁵²
//! ```
//!
//! A loop of computed ratios that is meant to close then does close. Equal ratios are one `k_j`: the
//! difference of equal numbers is exact, however large these are.
//!
//! Some unknowns can be kept back until no other can serve as a pivot. Whatever then still depends on them
//! depends on nothing else.

mod traced;

pub(crate) use traced::Traced;

use crate::tolerance::{ERROR_FACTOR, LATE, LEAST_WEIGHT, SHARP};
use epicyclic_gears::simple_set::Fraction;

/// A number to eliminate with; operations are `None` where it would overflow or its zero is in doubt.
pub(crate) trait Scalar: Clone {
    fn zero() -> Self;
    fn one() -> Self;
    /// Rank in the choice of a pivot; 0 for a number that is zero.
    fn weight(&self) -> f64;
    /// Measure for the weights of an equation: the largest size of its entries.
    fn size(&self) -> f64 {
        self.weight()
    }
    fn minus(&self, other: &Self) -> Option<Self>;
    fn times(&self, other: &Self) -> Option<Self>;
    fn over(&self, other: &Self) -> Option<Self>;
    fn number(&self) -> f64;

    fn is_zero(&self) -> bool {
        self.weight() == 0.0
    }

    /// Whether its digits are certain.
    fn is_sharp(&self) -> bool {
        true
    }

    fn negative(&self) -> Option<Self> {
        Self::zero().minus(self)
    }
}

/// A number with a bound on its error.
///
/// `STRICT`: a difference as small as its bound is refused, and the elimination ends; otherwise it is zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Bounded<const STRICT: bool> {
    value: f64,
    error: f64,
}

impl<const STRICT: bool> Bounded<STRICT> {
    /// A number rounded once.
    pub(crate) fn rounded(value: f64) -> Self {
        Self { value, error: value.abs() * f64::EPSILON }
    }
}

impl<const STRICT: bool> Scalar for Bounded<STRICT> {
    fn zero() -> Self {
        Self { value: 0.0, error: 0.0 }
    }

    fn one() -> Self {
        Self { value: 1.0, error: 0.0 }
    }

    /// Uncertain numbers last: as pivots they would spread their error.
    fn weight(&self) -> f64 {
        let size = self.value.abs();
        (size - self.error * LATE).max(size * LEAST_WEIGHT)
    }

    fn size(&self) -> f64 {
        self.value.abs()
    }

    fn minus(&self, other: &Self) -> Option<Self> {
        if other.value == 0.0 {
            return Some(*self);
        }
        if self.value == 0.0 {
            return Some(Self { value: -other.value, error: other.error });
        }
        let value = self.value - other.value;
        let error = self.error + other.error + value.abs() * f64::EPSILON;
        if value.abs() > ERROR_FACTOR * error {
            return Some(Self { value, error });
        }
        // The difference of equal numbers that no rounding touched is certain.
        (!STRICT || error == 0.0).then_some(Self::zero())
    }

    fn times(&self, other: &Self) -> Option<Self> {
        // A number times ±1 is as certain as the number.
        for (one, other) in [(self, other), (other, self)] {
            if one.error == 0.0 && one.value.abs() == 1.0 {
                return Some(Self { value: one.value * other.value, error: other.error });
            }
        }
        let value = self.value * other.value;
        let error = self.value.abs() * other.error + other.value.abs() * self.error;
        // Overflow, and digits lost below the least number, leave nothing certain.
        (value.is_finite() && (value.abs() > f64::MIN_POSITIVE || self.value == 0.0 || other.value == 0.0))
            .then_some(Self { value, error: error + self.error * other.error + value.abs() * f64::EPSILON })
    }

    fn over(&self, other: &Self) -> Option<Self> {
        if self.value == 0.0 {
            return Some(Self::zero());
        }
        if other.error == 0.0 && (other.value.abs() == 1.0 || self == other) {
            return Some(Self { value: self.value / other.value, error: self.error });
        }
        let value = self.value / other.value;
        let least = other.value.abs() - other.error;
        let error = (self.error + value.abs() * other.error) / least + value.abs() * f64::EPSILON;
        // A divisor that may be 0 leaves no bound.
        let is_bounded = !STRICT || least > 0.0;
        (is_bounded && value.is_finite() && value.abs() > f64::MIN_POSITIVE).then_some(Self { value, error })
    }

    fn number(&self) -> f64 {
        self.value
    }

    fn is_sharp(&self) -> bool {
        !STRICT || self.error <= SHARP * self.value.abs()
    }
}

impl Scalar for Fraction {
    fn zero() -> Self {
        Self::new_raw(0, 1)
    }

    fn one() -> Self {
        Self::new_raw(1, 1)
    }

    /// Short fractions first: they keep the numbers small.
    fn weight(&self) -> f64 {
        if *self.numer() == 0 {
            0.0
        } else {
            1.0 / (self.numer().unsigned_abs() as f64 + *self.denom() as f64)
        }
    }

    fn minus(&self, other: &Self) -> Option<Self> {
        let shared = gcd(*self.denom(), *other.denom());
        let (left, right) = (other.denom() / shared, self.denom() / shared);
        let numer = self.numer().checked_mul(left)?.checked_sub(other.numer().checked_mul(right)?)?;
        reduced(numer, self.denom().checked_mul(left)?)
    }

    fn times(&self, other: &Self) -> Option<Self> {
        let (s, t) = (gcd(*self.numer(), *other.denom()), gcd(*other.numer(), *self.denom()));
        if s == 0 || t == 0 {
            return Some(<Self as Scalar>::zero());
        }
        let numer = (self.numer() / s).checked_mul(other.numer() / t)?;
        reduced(numer, (self.denom() / t).checked_mul(other.denom() / s)?)
    }

    fn over(&self, other: &Self) -> Option<Self> {
        let (numer, denom) = (*other.numer(), *other.denom());
        if numer == 0 {
            return None;
        }
        let sign = numer.signum();
        Scalar::times(self, &Self::new_raw(denom * sign, numer.checked_abs()?))
    }

    fn number(&self) -> f64 {
        *self.numer() as f64 / *self.denom() as f64
    }
}

fn gcd(mut a: i128, mut b: i128) -> i128 {
    // Most numbers are short, and short division is many times faster.
    while b != 0 {
        if let (Ok(short_a), Ok(short_b)) = (i64::try_from(a), i64::try_from(b)) {
            let (mut a, mut b) = (short_a.unsigned_abs(), short_b.unsigned_abs());
            while b != 0 {
                (a, b) = (b, a % b);
            }
            return i128::from(a);
        }
        (a, b) = (b, a % b);
    }
    a.saturating_abs()
}

fn reduced(numer: i128, denom: i128) -> Option<Fraction> {
    let shared = gcd(numer, denom);
    (shared != 0).then(|| Fraction::new_raw(numer / shared, denom / shared))
}

/// Digits that a number written by a person may have; one with more was computed.
///
/// Of computed numbers one in ten is, by chance, the nearest to a decimal of 15 digits, such as 125/27; one
/// in ten thousand to one of 12.
const WRITTEN_DIGITS: usize = 12;

/// The decimal that a number was written as, `2.15` as 43/20; `None` of a number with more than 12 digits.
pub(crate) fn decimal(value: f64) -> Option<Fraction> {
    let text = format!("{value:e}");
    let (mantissa, exponent) = text.split_once('e')?;
    let exponent: i32 = exponent.parse().ok()?;
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{part}");
    if digits.trim_start_matches('-').len() > WRITTEN_DIGITS {
        return None;
    }
    let numer: i128 = digits.parse().ok()?;
    let shift = exponent - i32::try_from(part.len()).ok()?;
    let power = 10_i128.checked_pow(shift.unsigned_abs())?;
    if shift < 0 {
        Some(Fraction::new(numer, power))
    } else {
        Some(Fraction::from_integer(numer.checked_mul(power)?))
    }
}

/// Reduced echelon form of a homogeneous system.
#[derive(Debug, Clone)]
pub(crate) struct Echelon<S> {
    /// Place of the equation and of the unknown of each pivot.
    pub(crate) pivots: Vec<(usize, usize)>,
    /// Unknowns that can be chosen.
    pub(crate) free: Vec<usize>,
    /// The equations one after the other.
    reduced: Vec<S>,
    /// Place of the pivot of each unknown that has one.
    pivot_of: Vec<Option<usize>>,
}

impl<S: Scalar> Echelon<S> {
    /// Reduces equations given row by row in `entries`. The unknowns in `late` become pivots only if no other
    /// can, in their order. `None` if a number is in doubt or exceeds the range of its kind.
    pub(crate) fn new(mut entries: Vec<S>, columns: usize, late: &[usize]) -> Option<Self> {
        let count = entries.len().checked_div(columns).unwrap_or(0);
        let mut origin: Vec<usize> = (0..count).collect();
        let mut pivots = Vec::with_capacity(count.min(columns));
        let mut pivot_row: Vec<S> = Vec::with_capacity(columns);
        let mut pivot_of = vec![None; columns];
        for class in std::iter::once(None).chain(late.iter().map(Some)) {
            let is_meant = |column: usize| match class {
                Some(only) => *only == column,
                None => !late.contains(&column),
            };
            while let Some((row, column)) = largest(&entries, columns, pivots.len(), is_meant) {
                let place = pivots.len();
                origin.swap(place, row);
                pivot_row.clear();
                pivot_row.extend_from_slice(&entries[row * columns..(row + 1) * columns]);
                for at in 0..columns {
                    entries.swap(place * columns + at, row * columns + at);
                }
                let pivot = pivot_row[column].clone();
                for (at, entry) in pivot_row.iter_mut().enumerate() {
                    if at == column {
                        *entry = S::one();
                    } else if !entry.is_zero() {
                        *entry = entry.over(&pivot)?;
                    }
                }
                for (at, row) in entries.chunks_exact_mut(columns).enumerate() {
                    if at == place || row[column].is_zero() {
                        continue;
                    }
                    let factor = std::mem::replace(&mut row[column], S::zero());
                    for (at, (entry, pivot_entry)) in row.iter_mut().zip(&pivot_row).enumerate() {
                        if at != column && !pivot_entry.is_zero() {
                            *entry = entry.minus(&factor.times(pivot_entry)?)?;
                        }
                    }
                }
                entries[place * columns..(place + 1) * columns].clone_from_slice(&pivot_row);
                pivot_of[column] = Some(place);
                pivots.push((origin[place], column));
            }
        }
        let free = (0..columns).filter(|&c| pivot_of[c].is_none()).collect();
        Some(Self { pivots, free, reduced: entries, pivot_of })
    }

    /// Dependence of an unknown on the free ones: the factors that are not zero.
    pub(crate) fn dependence(&self, unknown: usize) -> impl Iterator<Item = (usize, S)> {
        let columns = self.pivot_of.len();
        let row = self.pivot_of[unknown].map(|place| &self.reduced[place * columns..(place + 1) * columns]);
        self.free.iter().filter_map(move |&free| match row {
            Some(row) => row[free].negative().map(|x| (free, x)).filter(|(_, x)| x.weight() > 0.0),
            None => (free == unknown).then(|| (free, S::one())),
        })
    }

    /// Whether an unknown is 0 whatever the free ones are.
    pub(crate) fn is_nothing(&self, unknown: usize) -> bool {
        self.dependence(unknown).next().is_none()
    }

    /// Labels of the unknowns: two unknowns have the same label if they occur together in a minimal relation.
    ///
    /// The labels mark the connected parts of the bipartite graph of pivots and free unknowns. The parts do
    /// not depend on the choice of pivots (they are those of the system's matroid).
    pub(crate) fn parts(&self) -> Vec<usize> {
        let columns = self.pivot_of.len();
        let mut groups = crate::groups::Groups::new(columns);
        for &(_, pivot) in &self.pivots {
            for (free, _) in self.dependence(pivot) {
                groups.join(pivot, free);
            }
        }
        (0..columns).map(|column| groups.root(column)).collect()
    }
}

/// The remaining entry that is largest within its equation, in a column that is meant.
fn largest<S: Scalar>(
    entries: &[S],
    columns: usize,
    from: usize,
    is_meant: impl Fn(usize) -> bool,
) -> Option<(usize, usize)> {
    let mut best = None;
    let mut best_weight = 0.0;
    for (place, row) in entries.chunks_exact(columns.max(1)).enumerate().skip(from) {
        let scale = row.iter().fold(0.0_f64, |most, entry| most.max(entry.size()));
        if scale == 0.0 {
            continue;
        }
        let share = scale.recip();
        for (column, entry) in row.iter().enumerate() {
            let weight = entry.weight() * share;
            if weight > best_weight && is_meant(column) {
                best_weight = weight;
                best = Some((place, column));
            }
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_rational::BigRational;
    use num_traits::{Signed, ToPrimitive};
    use proptest::prelude::*;

    type Strict = Bounded<true>;
    type Lenient = Bounded<false>;

    fn rows<S: Scalar>(rows: &[&[i32]], of: impl Fn(i32) -> S) -> Vec<S> {
        rows.iter().flat_map(|row| row.iter()).map(|&x| of(x)).collect()
    }

    fn rounded<const STRICT: bool>(x: i32) -> Bounded<STRICT> {
        Bounded::rounded(f64::from(x))
    }

    #[test]
    fn a_late_unknown_stays_free_as_long_as_it_can() {
        // x + y − 2z = 0, with z kept back.
        let echelon = Echelon::<Strict>::new(rows(&[&[1, 1, -2], &[1, -1, 0]], rounded), 3, &[2]).unwrap();
        assert_eq!(echelon.free, [2]);
        let factor = echelon.dependence(0).next().unwrap();
        assert!(factor.0 == 2 && (factor.1.number() - 1.0).abs() < 1e-15);
    }

    #[test]
    fn fractions_refuse_to_overflow() {
        let huge = Fraction::new_raw(i128::MAX, 1);
        let of = Fraction::new_raw;
        assert_eq!(Scalar::times(&huge, &of(2, 1)), None);
        assert_eq!(Scalar::minus(&huge, &of(-1, 1)), None);
        assert_eq!(Scalar::over(&huge, &of(0, 1)), None);
        assert_eq!(Scalar::minus(&Fraction::new(2, 3), &Fraction::new(1, 6)), Some(Fraction::new(1, 2)));
        assert_eq!(Scalar::over(&Fraction::new(2, 3), &Fraction::new(-4, 9)), Some(Fraction::new(-3, 2)));
    }

    #[test]
    fn unrelated_unknowns_are_parted() {
        let echelon =
            Echelon::<Strict>::new(rows(&[&[1, -1, 0, 0], &[0, 0, 1, 2]], rounded), 4, &[]).unwrap();
        let parts = echelon.parts();
        assert!(parts[0] == parts[1] && parts[2] == parts[3] && parts[0] != parts[2]);
    }

    #[test]
    fn a_doubtful_zero_ends_the_strict_elimination_only() {
        let third = 1.0 / 3.0;
        fn of<const S: bool>(entries: [f64; 4]) -> Vec<Bounded<S>> {
            entries.map(Bounded::rounded).into()
        }
        let equations = [1.0, third, 3.0, 1.0];
        assert!(Echelon::<Strict>::new(of(equations), 2, &[]).is_none());
        assert_eq!(Echelon::<Lenient>::new(of(equations), 2, &[]).unwrap().pivots.len(), 1);
    }

    #[test]
    fn decimals_are_what_was_written() {
        assert_eq!(decimal(2.15), Some(Fraction::new(43, 20)));
        assert_eq!(decimal(-0.1), Some(Fraction::new(-1, 10)));
        assert_eq!(decimal(1e9), Some(Fraction::from_integer(1_000_000_000)));
        assert_eq!(decimal(250.0), Some(Fraction::from_integer(250)));
        assert_eq!(decimal(1.0 / 3.0), None);
        assert_eq!(decimal(125.0 / 27.0), None);
        assert_eq!(decimal(f64::MIN_POSITIVE), None);
    }

    /// A number with its error, and a value within that error; `place` from `-1` to `1` of the error.
    fn doubtful<const STRICT: bool>(value: f64, error: f64, place: f64) -> (Bounded<STRICT>, BigRational) {
        let of = |number: f64| BigRational::from_float(number).unwrap();
        (Bounded { value, error }, of(value) + of(error) * of(place))
    }

    #[test]
    fn a_certain_one_and_a_number_by_itself_add_no_error() {
        let one = |value: f64, error: f64| Strict { value, error };
        let third = one(1.0 / 3.0, 1e-9);
        for sign in [1.0, -1.0] {
            let expected = Some(one(sign * third.value, third.error));
            assert_eq!(third.times(&one(sign, 0.0)), expected);
            assert_eq!(one(sign, 0.0).times(&third), expected);
            assert_eq!(third.over(&one(sign, 0.0)), expected);
            // A doubtful one adds its own.
            assert!(third.times(&one(sign, 1e-9)).unwrap().error > 1.3e-9);
            assert!(third.over(&one(sign, 1e-9)).unwrap().error > 1.3e-9);
        }
        assert_eq!(one(0.3, 0.0).over(&one(0.3, 0.0)), Some(one(1.0, 0.0)));
        assert!(third.over(&third).unwrap().error > 3e-9);
    }

    #[test]
    fn what_is_certain_is_sharp_and_the_first_pivot() {
        let certain = Strict { value: -2.0, error: 0.0 };
        let doubtful = Strict { value: 2.0, error: 1e-9 };
        assert_eq!(certain.weight(), 2.0);
        assert!(doubtful.weight() < certain.weight() && doubtful.weight() > 0.0);
        assert!(certain.is_sharp() && !Strict { value: 2.0, error: 1.0 }.is_sharp());
        assert!(Lenient { value: 2.0, error: 1.0 }.is_sharp());
        // Short fractions before long ones, and no fraction of zero.
        let rational = |numer: i128, denom: i128| Traced::certain(&Fraction::new(numer, denom));
        assert_eq!(rational(0, 1).weight(), 0.0);
        assert!(rational(1, 2).weight() > rational(355, 113).weight());
        assert!(Fraction::new(1, 2).weight() > Fraction::new(355, 113).weight());
    }

    proptest! {
        #[test]
        fn a_result_is_within_its_error(
            first in (0.01_f64..100.0, any::<bool>(), -1.0_f64..=1.0),
            second in (0.01_f64..100.0, any::<bool>(), -1.0_f64..=1.0),
            errors in prop::array::uniform2(prop_oneof![Just(0.0), 1e-15_f64..1e-6]),
            is_one in any::<bool>(),
        ) {
            let signed = |(value, is_negative, _): (f64, bool, f64)| if is_negative { -value } else { value };
            let (a, exact_a) = doubtful::<true>(signed(first), errors[0], first.2);
            let value = if is_one { signed(second).signum() } else { signed(second) };
            let (b, exact_b) = doubtful::<true>(value, errors[1], second.2);
            let results = [
                (a.minus(&b), &exact_a - &exact_b),
                (a.times(&b), &exact_a * &exact_b),
                (a.over(&b), &exact_a / &exact_b),
                (b.over(&a), &exact_b / &exact_a),
            ];
            for (found, exact) in results {
                let Some(found) = found else { continue };
                let off = (exact - BigRational::from_float(found.value).unwrap()).abs();
                // The error itself is rounded.
                prop_assert!(off.to_f64().unwrap() <= found.error * (1.0 + 1e-12), "{:?} {:?}: {:?}", a, b, found);
            }
        }

        #[test]
        fn the_kinds_of_numbers_agree(
            entries in prop::collection::vec(prop::collection::vec(-3_i32..4, 5), 1..5),
        ) {
            let rows: Vec<&[i32]> = entries.iter().map(Vec::as_slice).collect();
            let short = Echelon::new(self::rows(&rows, |x| Fraction::from_integer(i128::from(x))), 5, &[4]).unwrap();
            let of = |x: i32| Traced::certain(&Fraction::from_integer(i128::from(x)));
            let long = Echelon::new(self::rows(&rows, of), 5, &[4]).unwrap();
            let loose = Echelon::<Lenient>::new(self::rows(&rows, rounded), 5, &[4]).unwrap();
            prop_assert_eq!(short.pivots.len(), long.pivots.len());
            prop_assert_eq!(short.parts().len(), long.parts().len());
            prop_assert_eq!(short.pivots.len(), loose.pivots.len());
            if let Some(strict) = Echelon::<Strict>::new(self::rows(&rows, rounded), 5, &[4]) {
                prop_assert_eq!(short.pivots.len(), strict.pivots.len());
                prop_assert_eq!(short.free.contains(&4), strict.free.contains(&4));
            }
        }
    }
}

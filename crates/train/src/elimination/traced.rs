//! Rationals of any size with their derivatives by ratios that were computed and rounded.

use super::Scalar;
use crate::tolerance::ERROR_FACTOR;
use epicyclic_gears::simple_set::Fraction;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

/// A rational of any size, with its derivatives by the ratios that were computed.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Traced {
    value: BigRational,
    /// `k_j·∂value/∂k_j` by the number of the ratio, ascending; none that is 0.
    slopes: Vec<(usize, BigRational)>,
}

impl Traced {
    /// A ratio of tooth counts or a decimal.
    pub(crate) fn certain(fraction: &Fraction) -> Self {
        let [numer, denom] = [fraction.numer(), fraction.denom()].map(|one| BigInt::from(*one));
        Self { value: BigRational::new_raw(numer, denom), slopes: vec![] }
    }

    /// A computed ratio with its number; `None` unless it is finite.
    pub(crate) fn computed(ratio: f64, number: usize) -> Option<Self> {
        let value = BigRational::from_float(ratio)?;
        Some(Self { slopes: vec![(number, value.clone())], value })
    }

    /// `value` with the slopes `a·own + b·other`; zero where roundings of the ratios make it so.
    fn new(value: BigRational, own: (&Self, &BigRational), other: (&Self, &BigRational)) -> Self {
        let part = |(one, factor): (&Self, &BigRational), number: usize| {
            let place = one.slopes.binary_search_by_key(&number, |(number, _)| *number).ok()?;
            Some(&one.slopes[place].1 * factor)
        };
        let mut numbers: Vec<usize> =
            own.0.slopes.iter().chain(&other.0.slopes).map(|(number, _)| *number).collect();
        numbers.sort_unstable();
        numbers.dedup();
        let slopes: Vec<(usize, BigRational)> = numbers
            .into_iter()
            .filter_map(|number| match (part(own, number), part(other, number)) {
                (Some(one), Some(two)) => Some((number, one + two)),
                (one, two) => Some((number, one.or(two)?)),
            })
            .filter(|(_, slope)| !Zero::is_zero(slope))
            .collect();
        let made = Self { value, slopes };
        if made.is_rounding() { <Self as Scalar>::zero() } else { made }
    }

    /// Whether a few roundings of the computed ratios make it zero.
    fn is_rounding(&self) -> bool {
        if self.slopes.is_empty() || Zero::is_zero(&self.value) {
            return false;
        }
        let rounding = || BigRational::from_float(ERROR_FACTOR * f64::EPSILON);
        let change = self.slopes.iter().map(|(_, slope)| slope.abs()).sum::<BigRational>();
        rounding().is_some_and(|rounding| self.value.abs() <= change * rounding)
    }
}

impl Scalar for Traced {
    fn zero() -> Self {
        Self { value: BigRational::zero(), slopes: vec![] }
    }

    fn one() -> Self {
        Self { value: BigRational::one(), slopes: vec![] }
    }

    /// Short numbers first: they keep the others small.
    fn weight(&self) -> f64 {
        if Zero::is_zero(&self.value) {
            0.0
        } else {
            1.0 / (1 + self.value.numer().bits() + self.value.denom().bits()) as f64
        }
    }

    fn minus(&self, other: &Self) -> Option<Self> {
        let one = BigRational::one();
        Some(Self::new(&self.value - &other.value, (self, &one), (other, &-one.clone())))
    }

    fn times(&self, other: &Self) -> Option<Self> {
        Some(Self::new(&self.value * &other.value, (self, &other.value), (other, &self.value)))
    }

    fn over(&self, other: &Self) -> Option<Self> {
        if Zero::is_zero(&other.value) {
            return None;
        }
        let (value, inverse) = (&self.value / &other.value, other.value.recip());
        let factor = -(&value * &inverse);
        Some(Self::new(value, (self, &inverse), (other, &factor)))
    }

    fn number(&self) -> f64 {
        // Both may be beyond the largest number while their ratio is not.
        let (numer, denom) = (self.value.numer().abs(), self.value.denom());
        let shift = numer.bits().max(denom.bits()).saturating_sub(1000);
        let of = |big: &BigInt| (big >> shift).to_f64().unwrap_or(f64::INFINITY);
        let size = match shift {
            0 => of(&numer) / of(denom),
            _ => self.value.abs().to_f64().unwrap_or_else(|| of(&numer) / of(denom)),
        };
        if self.value.is_negative() { -size } else { size }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_rational_has_its_number() {
        let long = BigRational::new(BigInt::from(3) << 3000_u32, BigInt::from(1) << 3001_u32);
        let number = |value: BigRational| Traced { value, slopes: vec![] }.number();
        assert!((number(long.clone()) - 1.5).abs() < 1e-15);
        assert!((number(-long) + 1.5).abs() < 1e-15);
        assert_eq!(Traced::certain(&Fraction::new(-3, 4)).number(), -0.75);
    }

    #[test]
    fn what_a_rounding_of_its_ratios_makes_zero_is_zero() {
        let (third, product) = (1.0 / 3.0, 1.0 / 3.0 * 1.3);
        let of = |ratio: f64, number: usize| Traced::computed(ratio, number).unwrap();
        let closed = of(third, 0).times(&Traced::certain(&Fraction::new(13, 10))).unwrap();
        assert!(closed.minus(&of(product, 1)).unwrap().is_zero());
        assert!(!closed.minus(&of(product * (1.0 + 1e-13), 1)).unwrap().is_zero());
        // The least difference from 1 is a thousandfold its rounding.
        let near = of(1.0 + 1e-12, 0).minus(&Traced::one()).unwrap();
        assert!((near.number() / 1e-12 - 1.0).abs() < 1e-3);
        // Equal numbers cancel exactly and leave the other terms, however small.
        let large = of(1e9 / 3.0, 0);
        let beside =
            large.times(&large).unwrap().minus(&Traced::certain(&Fraction::new(1, 1_000_000_000))).unwrap();
        let left = large.times(&large).unwrap().minus(&beside).unwrap();
        assert_eq!(left, Traced::certain(&Fraction::new(1, 1_000_000_000)));
    }

    #[test]
    fn slopes_are_those_of_the_formula() {
        // (x·y − x)/(x + y) at 3, 5: by x·∂/∂x = x·(y − 1)·y/(x + y)², by y·∂/∂y = y·x·(x + 1)/(x + y)².
        let [x, y] = [(3.0, 0), (5.0, 1)].map(|(value, number)| Traced::computed(value, number).unwrap());
        let sum = x.minus(&Traced::zero().minus(&y).unwrap()).unwrap();
        let found = x.times(&y).unwrap().minus(&x).unwrap().over(&sum).unwrap();
        let rational = |numer: i64, denom: i64| BigRational::new(numer.into(), denom.into());
        assert_eq!(found.value, rational(12, 8));
        assert_eq!(found.slopes, [(0, rational(60, 64)), (1, rational(60, 64))]);
    }
}

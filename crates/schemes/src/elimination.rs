//! Which unknowns of a homogeneous system follow from which: reduced echelon form with full pivoting.
//!
//! Rank decides the state of a gear, so it must not hang on rounding. Two ways, one code:
//!
//! - over fractions of tooth counts every zero is exact, and nothing is a matter of tolerance;
//! - over `f64` each equation is first scaled to a largest coefficient of 1, the pivot is the largest
//!   remaining entry, and what is left below [`RANK_TOLERANCE`] is zero. Coefficients of a row lie
//!   between `1/(1 + |i₀|)` and 1, so a true pivot of a gearbox is many orders above the tolerance,
//!   while rounding leaves less than 1e-14.
//!
//! Some unknowns can be kept back until no other can serve as a pivot: what then still depends on
//! them depends on nothing else.

use epicyclic_gears::row::Fraction;

/// What is zero in an equation scaled to a largest coefficient of 1.
pub(crate) const RANK_TOLERANCE: f64 = 1e-10;

/// A number to eliminate with; `None` where it would overflow.
pub(crate) trait Scalar: Copy {
    const ZERO: Self;
    const ONE: Self;
    /// Rank in the choice of a pivot; 0 for what counts as zero.
    fn weight(self) -> f64;
    fn minus(self, other: Self) -> Option<Self>;
    fn times(self, other: Self) -> Option<Self>;
    fn over(self, other: Self) -> Option<Self>;
    fn scale(row: &mut [Self]);
    fn number(self) -> f64;
}

impl Scalar for f64 {
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;

    fn weight(self) -> f64 {
        if self.abs() <= RANK_TOLERANCE { 0.0 } else { self.abs() }
    }

    fn minus(self, other: Self) -> Option<Self> {
        Some(self - other)
    }

    fn times(self, other: Self) -> Option<Self> {
        Some(self * other)
    }

    fn over(self, other: Self) -> Option<Self> {
        Some(self / other)
    }

    fn scale(row: &mut [Self]) {
        let largest = row.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        if largest > 0.0 {
            row.iter_mut().for_each(|x| *x /= largest);
        }
    }

    fn number(self) -> f64 {
        self
    }
}

impl Scalar for Fraction {
    const ZERO: Self = Self::new_raw(0, 1);
    const ONE: Self = Self::new_raw(1, 1);

    /// Short fractions first: they keep the numbers small.
    fn weight(self) -> f64 {
        if *self.numer() == 0 {
            0.0
        } else {
            1.0 / (self.numer().unsigned_abs() as f64 + *self.denom() as f64)
        }
    }

    fn minus(self, other: Self) -> Option<Self> {
        let shared = gcd(*self.denom(), *other.denom());
        let (left, right) = (other.denom() / shared, self.denom() / shared);
        let numer = self.numer().checked_mul(left)?.checked_sub(other.numer().checked_mul(right)?)?;
        reduced(numer, self.denom().checked_mul(left)?)
    }

    fn times(self, other: Self) -> Option<Self> {
        let (s, t) = (gcd(*self.numer(), *other.denom()), gcd(*other.numer(), *self.denom()));
        if s == 0 || t == 0 {
            return Some(Self::ZERO);
        }
        let numer = (self.numer() / s).checked_mul(other.numer() / t)?;
        reduced(numer, (self.denom() / t).checked_mul(other.denom() / s)?)
    }

    fn over(self, other: Self) -> Option<Self> {
        let (numer, denom) = (*other.numer(), *other.denom());
        if numer == 0 {
            return None;
        }
        let sign = numer.signum();
        self.times(Self::new_raw(denom * sign, numer.checked_abs()?))
    }

    fn scale(_: &mut [Self]) {}

    fn number(self) -> f64 {
        *self.numer() as f64 / *self.denom() as f64
    }
}

fn gcd(mut a: i128, mut b: i128) -> i128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.saturating_abs()
}

fn reduced(numer: i128, denom: i128) -> Option<Fraction> {
    let shared = gcd(numer, denom);
    (shared != 0).then(|| Fraction::new_raw(numer / shared, denom / shared))
}

/// Reduced echelon form of a homogeneous system.
#[derive(Debug, Clone)]
pub(crate) struct Echelon<S> {
    /// Place of the equation and of the unknown of each pivot.
    pub(crate) pivots: Vec<(usize, usize)>,
    /// Unknowns that can be chosen.
    pub(crate) free: Vec<usize>,
    reduced: Vec<Vec<S>>,
    columns: usize,
}

impl<S: Scalar> Echelon<S> {
    /// Reduces; the unknowns in `late` become pivots only where no other can, in their order.
    /// `None` where a fraction outgrows its integers.
    pub(crate) fn new(mut rows: Vec<Vec<S>>, columns: usize, late: &[usize]) -> Option<Self> {
        rows.iter_mut().for_each(|row| S::scale(row));
        let early: Vec<usize> = (0..columns).filter(|c| !late.contains(c)).collect();
        let mut origin: Vec<usize> = (0..rows.len()).collect();
        let mut pivots = vec![];
        for class in std::iter::once(early.as_slice()).chain(late.chunks(1)) {
            while let Some((row, column)) = largest(&rows, pivots.len(), class) {
                let place = pivots.len();
                rows.swap(place, row);
                origin.swap(place, row);
                let pivot = rows[place][column];
                for entry in &mut rows[place] {
                    *entry = entry.over(pivot)?;
                }
                rows[place][column] = S::ONE;
                let pivot_row = rows[place].clone();
                for (other, row) in rows.iter_mut().enumerate() {
                    let factor = row[column];
                    if other == place || factor.weight() == 0.0 {
                        row[column] = if other == place { S::ONE } else { S::ZERO };
                        continue;
                    }
                    for (entry, pivot_entry) in row.iter_mut().zip(&pivot_row) {
                        let difference = entry.minus(factor.times(*pivot_entry)?)?;
                        *entry = if difference.weight() == 0.0 { S::ZERO } else { difference };
                    }
                    row[column] = S::ZERO;
                }
                pivots.push((origin[place], column));
            }
        }
        let free = (0..columns).filter(|c| pivots.iter().all(|(_, p)| p != c)).collect();
        Some(Self { pivots, free, reduced: rows, columns })
    }

    /// How an unknown follows from the free ones: the factors that are not zero.
    pub(crate) fn dependence(&self, unknown: usize) -> Vec<(usize, S)> {
        let Some(place) = self.pivots.iter().position(|(_, column)| *column == unknown) else {
            return vec![(unknown, S::ONE)];
        };
        let row = &self.reduced[place];
        let factor = |f: usize| S::ZERO.minus(row[f]).map(|x| (f, x));
        self.free.iter().filter_map(|&f| factor(f)).filter(|(_, x)| x.weight() > 0.0).collect()
    }

    /// Which unknowns stand together in some least relation: a label for each.
    ///
    /// These are the connected parts of the bipartite graph of pivots and free unknowns, and the
    /// parts do not depend on the choice of pivots (they are those of the system's matroid).
    pub(crate) fn parts(&self) -> Vec<usize> {
        let mut groups = crate::groups::Groups::new(self.columns);
        for &(_, pivot) in &self.pivots {
            for (free, _) in self.dependence(pivot) {
                groups.join(pivot, free);
            }
        }
        (0..self.columns).map(|column| groups.root(column)).collect()
    }
}

fn largest<S: Scalar>(rows: &[Vec<S>], from: usize, columns: &[usize]) -> Option<(usize, usize)> {
    let mut best = None;
    let mut best_weight = 0.0;
    for (place, row) in rows.iter().enumerate().skip(from) {
        for &column in columns {
            if row[column].weight() > best_weight {
                best_weight = row[column].weight();
                best = Some((place, column));
            }
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_late_unknown_stays_free_as_long_as_it_can() {
        // x + y − 2z = 0, with z kept back.
        let echelon = Echelon::new(vec![vec![1.0, 1.0, -2.0], vec![1.0, -1.0, 0.0]], 3, &[2]).unwrap();
        assert_eq!(echelon.free, [2]);
        let factor = echelon.dependence(0)[0];
        assert!(factor.0 == 2 && (factor.1 - 1.0).abs() < 1e-15);
    }

    #[test]
    fn fractions_refuse_to_overflow() {
        let huge = Fraction::new_raw(i128::MAX, 1);
        assert_eq!(huge.times(Fraction::new_raw(2, 1)), None);
        assert_eq!(huge.minus(Fraction::new_raw(-1, 1)), None);
        assert_eq!(huge.over(Fraction::ZERO), None);
        assert_eq!(Fraction::new(2, 3).minus(Fraction::new(1, 6)), Some(Fraction::new(1, 2)));
        assert_eq!(Fraction::new(2, 3).over(Fraction::new(-4, 9)), Some(Fraction::new(-3, 2)));
    }

    #[test]
    fn unrelated_unknowns_are_parted() {
        let echelon =
            Echelon::new(vec![vec![1.0, -1.0, 0.0, 0.0], vec![0.0, 0.0, 1.0, 2.0]], 4, &[]).unwrap();
        let parts = echelon.parts();
        assert!(parts[0] == parts[1] && parts[2] == parts[3] && parts[0] != parts[2]);
    }
}

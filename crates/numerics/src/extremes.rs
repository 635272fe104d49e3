//! Least and greatest values of functions of one variable.
//!
//! ```
//! use epicyclic_numerics::extremes::golden;
//! let (place, least) = golden(0.0, 3.0, 40, |x| (x - 1.0) * (x - 1.0) + 2.0);
//! assert!((place - 1.0).abs() < 1e-7 && (least - 2.0).abs() < 1e-14);
//! ```

use std::convert::Infallible;

/// The part of a bracket that a golden section leaves on either side: `(3 − √5)/2`.
const PART: f64 = 0.381_966_011_250_105;

/// Argument and least value of a function that falls and then rises, after a number of golden sections.
///
/// ```text
/// b − a ← (b − a)·(√5 − 1)/2      each section, with one evaluation
/// ```
///
/// Near a smooth least value rounding hides differences: the argument is known to the square root
/// of rounding. Of equal values the upper part of the bracket stays.
pub fn golden(low: f64, high: f64, steps: u32, f: impl Fn(f64) -> f64) -> (f64, f64) {
    golden_while([low, high], |made, _| made < steps, f).least()
}

/// A bracket of a least value with two places that part it by the golden section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sections {
    /// Ends of the bracket.
    pub ends: [f64; 2],
    /// The places within, ascending, and the values there.
    pub inner: [(f64, f64); 2],
}

impl Sections {
    /// The place within that has the lower value, and this.
    #[must_use]
    pub fn least(&self) -> (f64, f64) {
        let [a, b] = self.inner;
        if a.1 < b.1 { a } else { b }
    }
}

/// The bracket of [`golden`] after sections that go on while a condition on their number and the
/// bracket holds.
pub fn golden_while(
    ends: [f64; 2],
    goes_on: impl Fn(u32, &Sections) -> bool,
    f: impl Fn(f64) -> f64,
) -> Sections {
    let Ok(found) = try_golden_while(ends, goes_on, |x| Ok::<_, Infallible>(f(x)));
    found
}

/// [`golden_while`] of a function that may fail.
///
/// # Errors
/// The first of the function.
pub fn try_golden_while<E>(
    [low, high]: [f64; 2],
    goes_on: impl Fn(u32, &Sections) -> bool,
    mut f: impl FnMut(f64) -> Result<f64, E>,
) -> Result<Sections, E> {
    let mut valued = |x: f64| f(x).map(|y| (x, y));
    let inner = [valued(low + PART * (high - low))?, valued(high - PART * (high - low))?];
    let mut found = Sections { ends: [low, high], inner };
    let mut made = 0;
    while goes_on(made, &found) {
        let Sections { ends: [low, high], inner: [a, b] } = found;
        found = if a.1 < b.1 {
            Sections { ends: [low, b.0], inner: [valued(low + PART * (b.0 - low))?, a] }
        } else {
            Sections { ends: [a.0, high], inner: [b, valued(high - PART * (high - a.0))?] }
        };
        made += 1;
    }
    Ok(found)
}

/// The most steps of [`summit`]: as many golden sections reach [`BESIDE`], parabolas a few.
const STEPS: u32 = 40;

/// Three places, ascending, with their values: a greatest sample between its neighbours.
///
/// At the end of a range the sample is one of the neighbours.
pub type Bracket = [(f64, f64); 3];

/// Accuracy of the place of a summit, over its bracket; the error of a smooth value is of the order
/// of its square.
const BESIDE: f64 = 1e-5;

/// Place and greatest value of a function in a bracket, to a hundred-thousandth of the bracket (Brent).
///
/// Parabolas through the three best places, golden sections where these do not shrink the bracket.
#[must_use]
pub fn summit([low, top, high]: Bracket, f: impl Fn(f64) -> f64) -> (f64, f64) {
    let whole = high.0 - low.0;
    let (mut a, mut b) = (low.0, high.0);
    let (mut x, mut w, mut v) = (top, low, high);
    if low.0 == top.0 || high.0 == top.0 {
        // At the end itself, unless it rises from there.
        let (other, beside) =
            if low.0 == top.0 { (high, top.0 + BESIDE * whole) } else { (low, top.0 - BESIDE * whole) };
        let here = f(beside);
        if here.is_nan() || here <= top.1 {
            return top;
        }
        (x, w, v) = ((beside, here), top, other);
    }
    if w.1 < v.1 {
        (w, v) = (v, w);
    }
    let reach = BESIDE * whole;
    let (mut step, mut before) = (whole, whole);
    for _ in 0..STEPS {
        let middle = 0.5 * (a + b);
        if (x.0 - middle).abs() <= 2.0 * reach - 0.5 * (b - a) {
            break;
        }
        let (r, q) = ((x.0 - w.0) * (x.1 - v.1), (x.0 - v.0) * (x.1 - w.1));
        let (p, q) = ((x.0 - v.0) * q - (x.0 - w.0) * r, 2.0 * (q - r));
        let by = -p / q;
        let (last, to) = (before, x.0 + by);
        before = step;
        // No number where the three places make no parabola.
        if by.abs() < 0.5 * last.abs() && to > a && to < b {
            step = by;
        } else {
            before = if x.0 < middle { b - x.0 } else { a - x.0 };
            step = PART * before;
        }
        let next = x.0 + if step.abs() >= reach { step } else { reach.copysign(step) };
        let here = (next, f(next));
        if here.1 >= x.1 {
            if next >= x.0 {
                a = x.0;
            } else {
                b = x.0;
            }
            (v, w, x) = (w, x, here);
        } else {
            if next < x.0 {
                a = next;
            } else {
                b = next;
            }
            if here.1 >= w.1 || w.0 == x.0 {
                (v, w) = (w, here);
            } else if here.1 >= v.1 || v.0 == x.0 || v.0 == w.0 {
                v = here;
            }
        }
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn golden_sections_end_where_asked() {
        let parabola = |x: f64| (x - 3.2) * (x - 3.2) + 1.0;
        let (place, least) = golden(1.0, 7.0, 60, parabola);
        assert!((place - 3.2).abs() < 1e-7 && (least - 1.0).abs() < 1e-14);
        let found = golden_while([1.0, 7.0], |_, found| found.ends[1] - found.ends[0] > 0.01, parabola);
        assert!(found.ends[0] < 3.2 && found.ends[1] > 3.2 && found.ends[1] - found.ends[0] <= 0.01);
        // A function that falls is least at the end.
        assert!((golden(1.0, 7.0, 60, |x| -x).0 - 7.0).abs() < 1e-9);
    }

    #[test]
    fn a_function_that_fails_ends_the_sections() {
        let f = |x: f64| if x < 2.0 { Err("below 2") } else { Ok(x) };
        assert_eq!(try_golden_while([0.0, 9.0], |made, _| made < 60, f), Err("below 2"));
    }

    #[test]
    fn a_summit_takes_few_evaluations() {
        let count = std::cell::Cell::new(0);
        let f = |x: f64| {
            count.set(count.get() + 1);
            libm::sin(x)
        };
        let bracket = [1.0, 1.4, 2.0].map(|x| (x, libm::sin(x)));
        let (place, value) = summit(bracket, f);
        assert!((place - std::f64::consts::FRAC_PI_2).abs() < 1e-4 && (value - 1.0).abs() < 1e-9);
        assert!(count.get() <= 12, "{}", count.get());
        // At an end that falls away it stays.
        let end = [(0.0, 1.0), (0.0, 1.0), (1.0, 0.0)];
        assert_eq!(summit(end, |x| 1.0 - x), (0.0, 1.0));
    }
}

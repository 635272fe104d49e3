//! The output's speed of a gear of independent equations, with a bound on its error.
//!
//! ```text
//! C·ω = −c_in,  N equations, N speeds, the output's the last unknown
//! ```
//!
//! Every entry of the elimination is a value and a bound on its error. The bounds follow the operations:
//!
//! ```text
//! |Δ(x − y)| ≤ Δx + Δy + ε·|x − y|
//! |Δ(x·y)|   ≤ |x|·Δy + |y|·Δx + Δx·Δy + ε·|x·y|
//! |Δ(x/y)|   ≤ (Δx + |x/y|·Δy)/(|y| − Δy) + ε·|x/y|
//! ```
//!
//! A pivot above a multiple of its bound is certainly not 0, and then the equations are independent.

use crate::kernel::MOST_EQUATIONS;
use crate::tolerance::{ERROR_FACTOR, SHARP};
use crate::topology::Topology;

/// An entry of an equation as `number + factor·i₀`, both −1, 0 or 1.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Entry {
    column: u8,
    number: i8,
    factor: i8,
}

/// Equations with up to three entries each; the last column is the right side.
#[derive(Debug, Clone)]
pub(super) struct Proof {
    equations: Vec<([Entry; 3], u8)>,
    /// Whether input and output are one piece.
    is_direct: bool,
}

/// A number with a bound on its error.
#[derive(Debug, Clone, Copy)]
struct Known {
    value: f64,
    error: f64,
}

const NOTHING: Known = Known { value: 0.0, error: 0.0 };

impl Proof {
    /// Proof for a gear with one more node than equations, all nodes free to turn. `None` if there are too
    /// many equations, or if an equation has no effect.
    pub(super) fn new(topology: &Topology, input: usize) -> Option<Self> {
        let count = topology.equations.len();
        let output = topology.output?;
        if count > MOST_EQUATIONS || count == 0 {
            return None;
        }
        let column = |node: usize| {
            let others = (0..topology.count).filter(|&other| other != input && other != output);
            let place = if node == input {
                count
            } else if node == output {
                count - 1
            } else {
                others.take_while(|&other| other != node).count()
            };
            place as u8
        };
        let equations = topology.equations.iter().map(|&nodes| {
            let [r, c, h] = nodes;
            let entries = if r == c && c == h {
                return None;
            } else if r == c {
                // (1 − i)·(ω_r − ω_H): nothing if i = 1, which the general method detects.
                [(r, 1, -1), (h, -1, 1), (None, 0, 0)]
            } else if r == h || c == h {
                [(r, 1, 0), (c, -1, 0), (None, 0, 0)]
            } else {
                [(r, 1, 0), (c, 0, -1), (h, -1, 1)]
            };
            let mut kept = [Entry { column: 0, number: 0, factor: 0 }; 3];
            let mut length = 0;
            for (node, number, factor) in entries {
                if let Some(node) = node {
                    kept[usize::from(length)] = Entry { column: column(node), number, factor };
                    length += 1;
                }
            }
            Some((kept, length))
        });
        Some(Self { equations: equations.collect::<Option<_>>()?, is_direct: input == output })
    }

    /// The output's speed as a multiple of the input's; `None` where it is not certain that the equations
    /// settle it.
    pub(super) fn output_speed(&self, ratios: &[f64]) -> Option<f64> {
        macro_rules! sizes {
            ($($n:literal)*) => {
                match self.equations.len() {
                    $($n => self.eliminate::<$n>(ratios),)*
                    _ => None,
                }
            };
        }
        sizes!(1 2 3 4 5 6 7 8 9 10 11 12)
    }

    #[allow(clippy::needless_range_loop, reason = "indices are those of the formulas")]
    fn eliminate<const N: usize>(&self, ratios: &[f64]) -> Option<f64> {
        let mut a = [[NOTHING; N]; N];
        let mut b = [NOTHING; N];
        for (row, ((entries, length), &i)) in self.equations.iter().zip(ratios).enumerate() {
            for entry in &entries[..usize::from(*length)] {
                let value = f64::from(entry.number) + f64::from(entry.factor) * i;
                // A ratio is rounded once, and so is its sum with 1.
                let error = if entry.factor == 0 { 0.0 } else { (i.abs() + value.abs()) * f64::EPSILON };
                let column = usize::from(entry.column);
                // The input's speed is 1: it stands on the right side.
                if column < N {
                    a[row][column] = Known { value, error };
                } else {
                    b[row] = Known { value: -value, error };
                }
            }
        }
        for k in 0..N {
            let mut pivot = k;
            for r in k + 1..N {
                if a[r][k].value.abs() > a[pivot][k].value.abs() {
                    pivot = r;
                }
            }
            a.swap(k, pivot);
            b.swap(k, pivot);
            let top = a[k][k];
            if !is_certain(top) {
                return None;
            }
            for r in k + 1..N {
                if a[r][k].value == 0.0 && a[r][k].error == 0.0 {
                    continue;
                }
                let factor = over(a[r][k], top);
                for c in k + 1..N {
                    a[r][c] = less(a[r][c], factor, a[k][c]);
                }
                b[r] = less(b[r], factor, b[k]);
            }
        }
        if self.is_direct {
            return Some(1.0);
        }
        if !is_certain(b[N - 1]) {
            return None;
        }
        let speed = over(b[N - 1], a[N - 1][N - 1]);
        (speed.value.is_normal() && speed.error <= SHARP * speed.value.abs()).then_some(speed.value)
    }
}

#[inline]
fn is_certain(one: Known) -> bool {
    one.value.is_finite() && one.error.is_finite() && one.value.abs() > ERROR_FACTOR * one.error
}

#[inline]
fn over(x: Known, y: Known) -> Known {
    let value = x.value / y.value;
    let error = (x.error + value.abs() * y.error) / (y.value.abs() - y.error) + value.abs() * f64::EPSILON;
    Known { value, error }
}

/// `x − f·y`.
#[inline]
fn less(x: Known, f: Known, y: Known) -> Known {
    if y.value == 0.0 && y.error == 0.0 {
        return x;
    }
    let product = f.value * y.value;
    let of_product = f.value.abs() * y.error + y.value.abs() * f.error + f.error * y.error;
    let value = x.value - product;
    Known { value, error: x.error + of_product + (product.abs() + value.abs()) * f64::EPSILON }
}

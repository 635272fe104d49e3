//! Kreines' rule: efficiency of a gear from its ratio alone.
//!
//! ```text
//! η = î/i      î = i with every i₀_j replaced by i₀_j·η₀_j^x_j      x_j = sign(∂ln|i|/∂ln|i₀_j|)
//! ```
//!
//! | symbol | meaning |
//! |---|---|
//! | `i` | ratio `ω_in/ω_out` as a function of the stationary ratios |
//! | `η₀_j`, `x_j` | efficiency of row `j` under a resting carrier, its exponent |
//!
//! No torque is computed here, so the rule checks the torque balance. The derivative equals the
//! relative power of the row per unit of input power, hence `x_j` is the sign of the *ideal* relative
//! power; a mesh shared by rows counts with the sum of their derivatives.
//!
//! # Where the rule as printed ends
//! It takes its signs at the ideal ratio. No torques obey these signs, that is, some row would gain
//! power,
//!
//! - where a row is so nearly idle in a gear with loops that the losses of the others reverse it,
//! - where the gear locks itself, and what lies behind the locking row is driven from the far end.
//!
//! There the torque balance turns the sign of the row, continuously with the losses, and
//! [`Kreines::reversed`] names it. With its exponent turned the rule gives the efficiency of the
//! balance again. None of the two- and three-speed schemes is such a case for `k` in 1.3…10; of
//! random driven gears of up to five rows with `η₀` from 0.9 to 1, one in several hundred is.
//!
//! # Source
//! multispeed-gearboxes, section 2.4, general rule.

use crate::Gearbox;
use crate::elimination::{Echelon, RANK_TOLERANCE, Scalar};
use crate::state::row_equation;
use crate::topology::Topology;

/// What Kreines' rule says of a gear.
#[derive(Debug, Clone, PartialEq)]
pub struct Kreines {
    /// Exponent `x_j` of each row as printed, from the ideal ratio.
    pub exponents: Vec<i8>,
    /// Exponent of each shared mesh.
    pub shared_exponents: Vec<i8>,
    /// `η = î/i` with these exponents.
    pub efficiency: f64,
    /// `η = î/i` with the signs of the loaded torques; the same but for rows in `reversed`.
    pub efficiency_loaded: Option<f64>,
    /// Names of rows whose power the losses reverse.
    pub reversed: Vec<String>,
}

/// A derivative below this share of the largest is none. Wider than the zero of a power: the
/// elimination behind it amplifies rounding where rows are nearly alike.
const SLOPE_TOLERANCE: f64 = 1e-9;

/// A number with its derivative.
#[derive(Debug, Clone, Copy)]
struct Dual {
    value: f64,
    slope: f64,
}

impl Scalar for Dual {
    const ZERO: Self = Self { value: 0.0, slope: 0.0 };
    const ONE: Self = Self { value: 1.0, slope: 0.0 };

    fn weight(self) -> f64 {
        if self.value.abs() <= RANK_TOLERANCE { 0.0 } else { self.value.abs() }
    }

    fn minus(self, other: Self) -> Option<Self> {
        Some(Self { value: self.value - other.value, slope: self.slope - other.slope })
    }

    fn times(self, other: Self) -> Option<Self> {
        let slope = self.slope * other.value + self.value * other.slope;
        Some(Self { value: self.value * other.value, slope })
    }

    fn over(self, other: Self) -> Option<Self> {
        let value = self.value / other.value;
        Some(Self { value, slope: (self.slope - value * other.slope) / other.value })
    }

    fn scale(row: &mut [Self]) {
        let largest = row.iter().fold(0.0_f64, |m, x| m.max(x.value.abs()));
        if largest > 0.0 {
            row.iter_mut().for_each(|x| *x = Self { value: x.value / largest, slope: x.slope / largest });
        }
    }

    fn number(self) -> f64 {
        self.value
    }
}

/// `i = ω_in/ω_out` of a gear whose rows have these stationary ratios, over any numbers; rows
/// without one are left out.
///
/// `None` where the output does not follow; 0 where the input rests while the output turns.
pub(crate) fn ratio<S: Scalar>(topology: &Topology, ratios: &[Option<S>]) -> Option<S> {
    let (input, output) = (topology.input?, topology.output?);
    if input == output {
        return Some(S::ONE);
    }
    let equation = |(members, i0): (&[Option<usize>; 3], &Option<S>)| {
        Some(row_equation(members, (*i0)?, topology.count))
    };
    let equations = topology.rows.iter().zip(ratios).filter_map(equation).collect::<Option<Vec<_>>>()?;
    let echelon = Echelon::new(equations, topology.count, &[input, output])?;
    match echelon.dependence(input).as_slice() {
        [] => Some(S::ZERO),
        [(free, factor)] if *free == output => Some(*factor),
        _ => None,
    }
}

/// Kreines' rule for a driven gear; `loaded` holds the signs of the loaded torques.
pub(crate) fn kreines(
    gearbox: &Gearbox,
    topology: &Topology,
    ratios: &[f64],
    loaded: Option<(&[i8], &[i8])>,
) -> Option<Kreines> {
    let ideal = ratio(topology, &ratios.iter().copied().map(Some).collect::<Vec<_>>())?;
    let slope = |row: usize| {
        let dual = |(place, &value): (usize, &f64)| {
            Some(Dual { value, slope: if place == row { value } else { 0.0 } })
        };
        let duals: Vec<Option<Dual>> = ratios.iter().enumerate().map(dual).collect();
        Some(ratio(topology, &duals)?.slope / ideal)
    };
    let slopes = (0..ratios.len()).map(slope).collect::<Option<Vec<f64>>>()?;
    let shared: Vec<f64> =
        gearbox.shared.iter().map(|mesh| mesh.rows.iter().map(|&row| slopes[row]).sum()).collect();
    let zero = SLOPE_TOLERANCE * slopes.iter().fold(1.0_f64, |m, s| m.max(s.abs()));
    let sign = |s: &f64| i8::from(*s > zero) - i8::from(*s < -zero);
    let exponents: Vec<i8> = slopes.iter().map(sign).collect();
    let shared_exponents: Vec<i8> = shared.iter().map(sign).collect();
    let efficiency = |rows: &[i8], shared: &[i8]| {
        let replaced = |(row, &i0): (usize, &f64)| {
            let group = gearbox.shared_group(row);
            let common = group.map_or(1.0, |g| gearbox.shared[g].eta.powi(i32::from(shared[g])));
            Some(i0 * gearbox.own_efficiency(row).powi(i32::from(rows[row])) * common)
        };
        Some(ratio(topology, &ratios.iter().enumerate().map(replaced).collect::<Vec<_>>())? / ideal)
    };
    let reversed = |rows: &[i8]| -> Vec<String> {
        (0..ratios.len())
            .filter(|&row| {
                let lossy = gearbox.rows[row].spec.loss.row_efficiency().get() < 1.0;
                lossy && rows[row] != 0 && rows[row] != exponents[row]
            })
            .map(|row| gearbox.rows[row].id().to_owned())
            .collect()
    };
    Some(Kreines {
        efficiency: efficiency(&exponents, &shared_exponents)?,
        efficiency_loaded: loaded.and_then(|(rows, shared)| efficiency(rows, shared)),
        reversed: loaded.map_or_else(Vec::new, |(rows, _)| reversed(rows)),
        exponents,
        shared_exponents,
    })
}

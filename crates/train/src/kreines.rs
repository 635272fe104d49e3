//! Kreines' rule: efficiency of a gear from its ratio alone.
//!
//! ```text
//! η = î/i      î = i with every i₀_j replaced by i₀_j·η₀_j^x_j      x_j = sign(∂ln|i|/∂ln|i₀_j|)
//! ```
//!
//! | symbol | meaning |
//! |---|---|
//! | `i` | ratio `ω_in/ω_out` as a function of the basic ratios |
//! | `η₀_j`, `x_j` | efficiency of set `j` under a carrier at rest, its exponent |
//!
//! No torque is computed here, so the rule checks the torque balance. The derivative equals the rolling power
//! of the set per unit of input power, hence `x_j` is the sign of the *ideal* rolling power. In a compound
//! set each segment of meshes has its own exponent: the sign of the derivative by all basic ratios behind the
//! segment together.
//!
//! # Limits of the printed rule
//! The rule takes its signs at the ideal ratio. In two cases no torques have these signs, that is, some set
//! would gain power:
//!
//! - a set is so nearly idle in a gear with loops that the losses of the others reverse it;
//! - the gear is self-locking, and the part behind the self-locking set is driven from the far end.
//!
//! There the torque balance turns the sign of the set, continuously with the losses, and
//! [`Kreines::reversed`] names it. With its exponent turned the rule gives the efficiency of the balance
//! again. None of the two- and three-speed schemes is such a case for `k` in 1.3…10. Of random driven gears
//! of up to five sets with `η₀` from 0.9 to 1, one in several hundred is.
//!
//! # Source
//! multispeed-gearboxes, section 2.4, general rule.

use crate::Gearbox;
use crate::elimination::{Bounded, Echelon, Scalar};
use crate::tolerance::SLOPE;
use crate::topology::{Topology, node_equations, numbers};

/// Result of Kreines' rule for a gear.
#[derive(Debug, Clone, PartialEq)]
pub struct Kreines {
    /// Exponents `x_j` as printed, from the ideal ratio: of each set its segments', one of a set with two
    /// central gears.
    pub exponents: Vec<Vec<i8>>,
    /// `η = î/i` with these exponents.
    pub efficiency: f64,
    /// `η = î/i` with the signs of the loaded torques; the same but for sets in `reversed`.
    pub efficiency_loaded: Option<f64>,
    /// Names of sets in which the losses reverse the power through some mesh.
    pub reversed: Vec<String>,
}

/// A number with its derivative.
#[derive(Debug, Clone, Copy)]
struct Dual {
    value: Bounded<false>,
    slope: f64,
}

impl Scalar for Dual {
    fn zero() -> Self {
        Self { value: Bounded::zero(), slope: 0.0 }
    }

    fn one() -> Self {
        Self { value: Bounded::one(), slope: 0.0 }
    }

    fn weight(&self) -> f64 {
        self.value.weight()
    }

    fn minus(&self, other: &Self) -> Option<Self> {
        Some(Self { value: self.value.minus(&other.value)?, slope: self.slope - other.slope })
    }

    fn times(&self, other: &Self) -> Option<Self> {
        let slope = self.slope * other.value.number() + self.value.number() * other.slope;
        Some(Self { value: self.value.times(&other.value)?, slope })
    }

    fn over(&self, other: &Self) -> Option<Self> {
        let value = self.value.over(&other.value)?;
        Some(Self { value, slope: (self.slope - value.number() * other.slope) / other.value.number() })
    }

    fn number(&self) -> f64 {
        self.value.number()
    }

    fn is_zero(&self) -> bool {
        self.value.is_zero() && self.slope == 0.0
    }
}

/// `i = ω_in/ω_out` of a gear with these basic ratios, over any numbers; equations without one are left out.
///
/// `None` where the output does not follow; 0 where the input rests while the output turns.
pub(crate) fn ratio<S: Scalar>(topology: &Topology, ratios: &[Option<S>]) -> Option<S> {
    let (input, output) = (topology.input?, topology.output?);
    if input == output {
        return Some(S::one());
    }
    let equations = node_equations(topology, ratios.iter().map(Option::as_ref))?;
    let echelon = Echelon::new(equations, topology.count, &[input, output])?;
    let mut depends = echelon.dependence(input);
    match (depends.next(), depends.next()) {
        (None, _) => Some(S::zero()),
        (Some((free, factor)), None) if free == output => Some(factor),
        _ => None,
    }
}

/// Kreines' rule for a driven gear; `loaded` holds the sign of the loaded power in each segment.
pub(crate) fn kreines(gearbox: &Gearbox, topology: &Topology, loaded: Option<&[i8]>) -> Option<Kreines> {
    let numbers = numbers(gearbox);
    let of = |ratios: &[f64]| {
        let ratios: Vec<Option<Bounded<false>>> = ratios.iter().map(|i| Some(Bounded::rounded(*i))).collect();
        ratio(topology, &ratios).map(|ratio| ratio.number())
    };
    let ideal = of(&numbers)?;
    let slope = |segment: &crate::gearbox::Segment| {
        let dual = |(place, &value): (usize, &f64)| {
            let slope = if segment.behind.contains(&place) { value } else { 0.0 };
            Some(Dual { value: Bounded::rounded(value), slope })
        };
        let duals: Vec<Option<Dual>> = numbers.iter().enumerate().map(dual).collect();
        Some(ratio(topology, &duals)?.slope / ideal)
    };
    let slopes = gearbox.segments.iter().map(slope).collect::<Option<Vec<f64>>>()?;
    let zero = SLOPE * slopes.iter().fold(1.0_f64, |m, s| m.max(s.abs()));
    let exponents: Vec<i8> = slopes.iter().map(|s| i8::from(*s > zero) - i8::from(*s < -zero)).collect();
    let efficiency = |exponents: &[i8]| {
        let mut replaced = numbers.clone();
        for (segment, &exponent) in gearbox.segments.iter().zip(exponents) {
            for i0 in &mut replaced[segment.behind.clone()] {
                *i0 *= segment.efficiency.powi(i32::from(exponent));
            }
        }
        Some(of(&replaced)? / ideal)
    };
    let reversed = |loaded: &[i8]| -> Vec<String> {
        let turned = |place: &usize| {
            gearbox.segments[*place].efficiency < 1.0
                && loaded[*place] != 0
                && loaded[*place] != exponents[*place]
        };
        let mut sets: Vec<usize> =
            (0..loaded.len()).filter(turned).map(|place| gearbox.segments[place].set).collect();
        sets.dedup();
        sets.into_iter().map(|set| gearbox.sets[set].id().to_owned()).collect()
    };
    let mut by_set = vec![vec![]; gearbox.sets.len()];
    for (segment, &exponent) in gearbox.segments.iter().zip(&exponents) {
        by_set[segment.set].push(exponent);
    }
    Some(Kreines {
        efficiency: efficiency(&exponents)?,
        efficiency_loaded: loaded.and_then(&efficiency),
        reversed: loaded.map_or_else(Vec::new, reversed),
        exponents: by_set,
    })
}

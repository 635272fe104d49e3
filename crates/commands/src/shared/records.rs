//! Small records that several answers share.

use epicyclic_gears::simple_set::{self, Member};
use schemars::JsonSchema;
use serde::Serialize;

/// A fraction in lowest terms, its sign in the numerator.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Fraction {
    /// Above the line.
    pub numerator: i128,
    /// Below it, above 0.
    pub denominator: i128,
}

impl Fraction {
    /// The fraction as the solver has it.
    #[must_use]
    pub fn of(fraction: simple_set::Fraction) -> Self {
        Self { numerator: *fraction.numer(), denominator: *fraction.denom() }
    }
}

impl std::fmt::Display for Fraction {
    /// `22/7`, or `6`.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.denominator {
            1 => write!(f, "{}", self.numerator),
            denominator => write!(f, "{}/{denominator}", self.numerator),
        }
    }
}

/// How a simple set of two shafts works.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Motion {
    /// The member that drives.
    pub input: Member,
    /// The member that is driven.
    pub output: Member,
    /// The member at rest.
    pub fixed: Member,
}

impl Motion {
    /// The mode as a record.
    #[must_use]
    pub fn of(mode: simple_set::Mode) -> Self {
        Self { input: mode.input(), output: mode.output(), fixed: mode.fixed() }
    }
}

impl std::fmt::Display for Motion {
    /// `aH^b`: input, output, and above them the member at rest.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}{}^{}", self.input.symbol(), self.output.symbol(), self.fixed.symbol())
    }
}

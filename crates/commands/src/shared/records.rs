//! Small records that several answers share.

use epicyclic_gears::simple_set;
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

/// A member of a simple set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Member {
    /// The sun, a.
    Sun,
    /// The ring, b.
    Ring,
    /// The carrier, H.
    Carrier,
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
        let member = |member| match member {
            simple_set::Member::Sun => Member::Sun,
            simple_set::Member::Ring => Member::Ring,
            simple_set::Member::Carrier => Member::Carrier,
        };
        Self { input: member(mode.input()), output: member(mode.output()), fixed: member(mode.fixed()) }
    }
}

impl Member {
    /// Letter of the member in the sources.
    #[must_use]
    pub fn letter(self) -> char {
        match self {
            Self::Sun => 'a',
            Self::Ring => 'b',
            Self::Carrier => 'H',
        }
    }
}

impl std::fmt::Display for Member {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Sun => "sun",
            Self::Ring => "ring",
            Self::Carrier => "carrier",
        })
    }
}

impl std::fmt::Display for Motion {
    /// `aH^b`: input, output, and above them the member at rest.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}{}^{}", self.input.letter(), self.output.letter(), self.fixed.letter())
    }
}

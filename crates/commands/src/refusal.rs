//! Quantities and options that errors refer to, in a module below those that raise the errors.

use std::fmt;

/// Quantity of the load that is invalid in a gear.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LoadQuantity {
    /// The torque on the input.
    Torque,
    /// The power into the input.
    Power,
}

/// Kind of the given values that are invalid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Given {
    /// Speeds by link.
    Speeds,
    /// Torques by link.
    Torques,
    /// Ranges of two speeds.
    Map,
}

/// One of the [`Sizes`](crate::schemes::answer::Sizes).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SizeName {
    /// Ring-to-sun ratio of set 1.
    K1,
    /// Ring-to-sun ratio of set 2.
    K2,
    /// Ratio of gear 1.
    Ratio1,
    /// Ratio of gear 2.
    Ratio2,
}

impl fmt::Display for SizeName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::K1 => "k1",
            Self::K2 => "k2",
            Self::Ratio1 => "ratio1",
            Self::Ratio2 => "ratio2",
        })
    }
}

/// A fault of one of the [`Sizes`](crate::schemes::answer::Sizes).
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SizeProblem {
    /// No ring-to-sun ratio of a simple set.
    #[error(transparent)]
    RingToSunRatio(#[from] epicyclic_gears::Error),
    /// A ratio that the scheme does not give.
    #[error(transparent)]
    Ratio(#[from] epicyclic_schemes::Error),
    /// Set 1 has no size, and set 2 has one.
    #[error("k1 or ratio1 is due too")]
    FirstMissing,
    /// Set 1 has a size, and set 2 none.
    #[error("{scheme} has two sets: k2 or ratio2 is due too")]
    SecondMissing {
        /// The scheme.
        scheme: &'static str,
    },
    /// A size of set 2, which the scheme lacks.
    #[error("scheme {scheme} has one set")]
    OneSet {
        /// The scheme.
        scheme: &'static str,
    },
}

/// A quantity of the [`Duty`](crate::select::answer::duty::Duty).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DutyQuantity {
    /// Speed of the input.
    InputSpeed,
    /// Torque on the input.
    Torque,
    /// Power into the input.
    Power,
}

impl fmt::Display for DutyQuantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::InputSpeed => "speed of the input",
            Self::Torque => "torque on the input",
            Self::Power => "power into the input",
        })
    }
}

/// A duty that cannot be.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum DutyProblem {
    /// A quantity that is not above 0.
    #[error("{quantity}: a finite quantity above 0 is due")]
    NotPositive {
        /// Name of the quantity.
        quantity: DutyQuantity,
    },
    /// A power and a speed whose torque no double holds.
    #[error("{torque_n_m} N·m by power and speed of the input: a finite quantity above 0 is due")]
    TorqueOfPower {
        /// Power over speed.
        torque_n_m: f64,
    },
    /// A power without a speed.
    #[error("power into the input: its torque needs the speed of the input")]
    PowerWithoutSpeed,
}

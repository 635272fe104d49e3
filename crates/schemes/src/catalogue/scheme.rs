//! Any scheme of the catalogue, whether of two or of three speeds.

use super::table::ClosedForm;
use super::{RingToSunRange, Role, ThreeSpeed, TwoSpeed};
use crate::Error;
use std::fmt;
use std::str::FromStr;

/// A scheme of the catalogue.
///
/// ```
/// use epicyclic_schemes::catalogue::Scheme;
/// # fn main() -> Result<(), epicyclic_schemes::Error> {
/// let scheme: Scheme = "II-3".parse()?;
/// assert_eq!(scheme.ratio_formula().text(), "(k1+k2+1)/k1");
/// assert_eq!(Scheme::all().count(), 14);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Scheme {
    /// One set, one brake, direct drive.
    Two(TwoSpeed),
    /// Two sets, two brakes, direct drive.
    Three(ThreeSpeed),
}

impl Scheme {
    /// Schemes of the catalogue, fourteen in the source's order.
    pub fn all() -> impl Iterator<Item = Self> {
        TwoSpeed::ALL.into_iter().map(Self::Two).chain(ThreeSpeed::ALL.into_iter().map(Self::Three))
    }

    /// Name as in the source.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Two(scheme) => scheme.name(),
            Self::Three(scheme) => scheme.name(),
        }
    }

    /// The scheme of its gear 1, in which set 1 works alone.
    #[must_use]
    pub fn first_stage(self) -> TwoSpeed {
        match self {
            Self::Two(scheme) => scheme,
            Self::Three(scheme) => scheme.first_stage(),
        }
    }

    /// Links of `a b H` of each set.
    #[must_use]
    pub fn sets(self) -> Vec<[Role; 3]> {
        match self {
            Self::Two(scheme) => vec![scheme.set()],
            Self::Three(scheme) => scheme.sets().to_vec(),
        }
    }

    /// Ratio of the last braked gear as a formula.
    #[must_use]
    pub fn ratio_formula(self) -> ClosedForm {
        match self {
            Self::Two(scheme) => scheme.ratio_formula(),
            Self::Three(scheme) => scheme.ratio_formula(),
        }
    }

    /// Efficiency of the last braked gear as a formula.
    #[must_use]
    pub fn efficiency_formula(self) -> ClosedForm {
        match self {
            Self::Two(scheme) => scheme.efficiency_formula(),
            Self::Three(scheme) => scheme.efficiency_formula(),
        }
    }

    /// Least and greatest ratio of the last braked gear while every `k` runs over a range.
    #[must_use]
    pub fn ratio_range(self, range: RingToSunRange) -> [f64; 2] {
        let [one, other] = match self {
            Self::Two(scheme) => scheme.ratio_range(range),
            Self::Three(scheme) => scheme.ratio_range(range),
        };
        [one.min(other), one.max(other)]
    }
}

impl From<TwoSpeed> for Scheme {
    fn from(scheme: TwoSpeed) -> Self {
        Self::Two(scheme)
    }
}

impl From<ThreeSpeed> for Scheme {
    fn from(scheme: ThreeSpeed) -> Self {
        Self::Three(scheme)
    }
}

impl fmt::Display for Scheme {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Scheme {
    type Err = Error;

    /// Reads a name in capital or small letters.
    fn from_str(name: &str) -> Result<Self, Error> {
        Self::all().find(|scheme| super::is_name(scheme.name(), name)).ok_or_else(|| {
            let known = Self::all().map(Self::name).collect();
            Error::UnknownScheme { name: name.into(), known }
        })
    }
}

//! The objectives by name.

use std::fmt;

/// One objective.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
pub enum Objective {
    /// The least efficiency over the braked gears.
    Efficiency,
    /// The largest speed of links, and of planets relative to their carriers.
    Speed,
    /// Σ distance of ln k from the preferred range.
    #[strum(serialize = "k")]
    RingToSun,
    /// The largest relative error of a ratio.
    #[strum(serialize = "error")]
    RatioError,
    /// The largest ring.
    Size,
    /// The largest circulating power.
    Circulation,
}

impl Objective {
    /// Objectives in the order of [`Order::default`](crate::Order::default).
    pub const ALL: [Self; 6] =
        [Self::Efficiency, Self::Speed, Self::RingToSun, Self::RatioError, Self::Size, Self::Circulation];

    /// Name of the objective.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.into()
    }
}

impl fmt::Display for Objective {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

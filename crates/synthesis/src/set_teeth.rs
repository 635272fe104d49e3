//! Tooth numbers of a set.

use epicyclic_gears::ToothCount;
use epicyclic_gears::double_planet::DoublePlanetNumbers;
use epicyclic_gears::synthesis::ToothNumbers;
use epicyclic_train::set::{Gearing, SetSpec};

/// Tooth numbers of a set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum SetTeeth {
    /// Tooth numbers of a simple set.
    Simple(ToothNumbers),
    /// Tooth numbers of a double-planet set.
    DoublePlanet(DoublePlanetNumbers),
}

impl SetTeeth {
    /// Teeth of the sun.
    #[must_use]
    pub const fn sun(&self) -> ToothCount {
        match self {
            Self::Simple(of) => of.sun,
            Self::DoublePlanet(of) => of.sun,
        }
    }

    /// Teeth of the ring.
    #[must_use]
    pub const fn ring(&self) -> ToothCount {
        match self {
            Self::Simple(of) => of.ring,
            Self::DoublePlanet(of) => of.ring,
        }
    }

    /// Whether it is a double-planet set.
    #[must_use]
    pub const fn is_double_planet(&self) -> bool {
        matches!(self, Self::DoublePlanet(_))
    }

    /// The ratio of the structure's word times the teeth of the sun: `k·z_sun = z_ring`, of a double-planet
    /// set `k′·z_sun = z_ring − z_sun`.
    pub(crate) fn over_sun(&self) -> i64 {
        match self {
            Self::Simple(of) => i64::from(of.ring.get()),
            Self::DoublePlanet(of) => i64::from(of.ring.get()) - i64::from(of.sun.get()),
        }
    }

    /// The ratio of the structure's word: `k`, of a double-planet set `k′ = k − 1`.
    #[must_use]
    pub fn k_of_word(&self) -> f64 {
        self.over_sun() as f64 / self.sun().as_f64()
    }

    /// A set of the solver of this kind, with these teeth in place of its own ratio, and its planets.
    #[must_use]
    pub fn put_into(&self, set: SetSpec) -> SetSpec {
        let set = SetSpec { gearing: Gearing::Teeth(self.sun(), self.ring()), ..set };
        match self {
            Self::Simple(of) => set.planet_teeth(of.planet, None).planet_count(of.planets),
            Self::DoublePlanet(of) => set.planet_teeth(of.inner, Some(of.outer)).planet_count(of.pairs),
        }
    }
}

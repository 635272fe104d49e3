//! Spacing of the planets of a set on its carrier, as a description gives it.

use epicyclic_gears::synthesis::Placement;
use uom::si::f64::Angle;

/// Spacing of the planets of a set on its carrier.
#[derive(Debug, Clone, PartialEq)]
pub enum Spacing {
    /// Equal angles, or the assembly positions nearest to them.
    Placed(Placement),
    /// Given angles, in any order.
    At(Vec<Angle>),
}

impl Default for Spacing {
    fn default() -> Self {
        Self::Placed(Placement::Equal)
    }
}

impl Spacing {
    /// Number of planets, if the angles are given.
    pub(crate) fn count(&self) -> Option<u32> {
        match self {
            Self::At(angles) => u32::try_from(angles.len()).ok(),
            Self::Placed(_) => None,
        }
    }
}

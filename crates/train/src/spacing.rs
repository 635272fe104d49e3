//! Where the planets of a set stand on its carrier, as a description says it.

use epicyclic_gears::synthesis::Placement;
use uom::si::f64::Angle;

/// Where the planets of a set stand on its carrier.
#[derive(Debug, Clone, PartialEq)]
pub enum Spacing {
    /// At equal angles, or at the assembly positions nearest to them.
    Placed(Placement),
    /// At these angles, in any order.
    At(Vec<Angle>),
}

impl Default for Spacing {
    fn default() -> Self {
        Self::Placed(Placement::Equal)
    }
}

impl Spacing {
    /// How many planets the angles are of, where they are given.
    pub(crate) fn count(&self) -> Option<u32> {
        match self {
            Self::At(angles) => u32::try_from(angles.len()).ok(),
            Self::Placed(_) => None,
        }
    }
}

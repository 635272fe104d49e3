//! Errors of this crate.

use crate::drive::{BoredGear, Computed, Given};
use crate::link_name::{LinkName, Property};
use epicyclic_gears::with_unit;
use epicyclic_train::State;

/// A mechanism that cannot move as described.
#[derive(Debug, Clone, PartialEq, thiserror::Error, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Error {
    /// A mass, inertia or radius that no body has.
    #[error("{what} of {link} is {value} in SI units: it is finite and not negative")]
    Impossible {
        /// The link concerned.
        link: LinkName,
        /// The property.
        what: Property,
        /// Value in SI units.
        value: f64,
    },
    /// A speed ratio, torque or speed that is not a number.
    #[error("{what} of {link} is {value}: it is finite")]
    NotFinite {
        /// The link concerned.
        link: LinkName,
        /// The property.
        what: Property,
        /// Value of the property.
        value: f64,
    },
    /// A load that is not a number.
    #[error("load torque of the carrier is {value}: it is finite")]
    LoadNotFinite {
        /// The value given, N·m.
        value: f64,
    },
    /// A quantity of the drive that must be finite and above 0.
    #[error("{quantity} is {}; it must be finite and above 0", with_unit(*value, unit))]
    NotPositive {
        /// The quantity.
        quantity: Given,
        /// The value given, in `unit`.
        value: f64,
        /// Unit of `value`; empty for a plain number.
        unit: &'static str,
    },
    /// Nothing moves, so there is nothing to accelerate.
    #[error("the equivalent inertia is 0: give at least one moving link an inertia or a mass")]
    NoInertia,
    /// A drive that does not reach its speed.
    #[error(
        "the drive does not start: the driving torque exceeds the load referred to its shaft by {surplus_n_m:.6} N·m; \
         it must exceed it by more than 0"
    )]
    DoesNotStart {
        /// Driving torque less the load referred to the driving shaft, in N·m.
        surplus_n_m: f64,
    },
    /// The direction of the power through the meshes contradicts itself in every combination.
    #[error("no direction of the mesh powers is consistent with the torques: the drive is self-locking")]
    SelfLocking,
    /// Given tooth numbers with unequal centre distances.
    #[error(
        "{sun}, {planet} and {ring} teeth have unequal centre distances: without profile shift \
         z_b = z_a + 2·z_g = {}", u64::from(*sun) + 2 * u64::from(*planet)
    )]
    UnequalCentreDistances {
        /// Teeth of the sun.
        sun: u32,
        /// Teeth of a planet.
        planet: u32,
        /// Teeth of the ring.
        ring: u32,
    },
    /// A bore that leaves no rim under the teeth.
    #[error(
        "the {gear}'s bore of {bore_mm:.1} mm does not fit inside its root circle of {root_mm:.1} mm: give it \
         a smaller bore or bearing, a larger module or more teeth"
    )]
    BoreTooLarge {
        /// The gear concerned.
        gear: BoredGear,
        /// The bore, mm.
        bore_mm: f64,
        /// The root diameter, mm.
        root_mm: f64,
    },
    /// A result beyond what a number holds.
    #[error("{what} is {value}: the given quantities are too large or too small to calculate with")]
    Overflow {
        /// The result.
        what: Computed,
        /// Value in SI units.
        value: f64,
    },
    /// A link, set or planet that the gearbox has not.
    #[error("the gearbox {gearbox} has no {part}")]
    UnknownPart {
        /// The missing link, set or planet.
        part: String,
        /// The gearbox.
        gearbox: String,
    },
    /// A link whose speed does not follow from the input's.
    #[error("the speed of {part} does not follow from the input's: the gear is {state}")]
    NoSpeed {
        /// The link, or the set of the planet.
        part: String,
        /// State of the gear.
        state: State,
    },
    /// An invalid gearbox.
    #[error(transparent)]
    Gearbox(#[from] epicyclic_train::Error),
    /// An invalid gear set.
    #[error(transparent)]
    Gear(#[from] epicyclic_gears::Error),
}

impl Error {
    /// Name of the fault, which does not change with the message: `impossible`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Gearbox(error) => error.name(),
            Self::Gear(error) => error.name(),
            named => named.into(),
        }
    }
}

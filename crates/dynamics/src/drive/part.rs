//! Parts and results of a drive by name.

use epicyclic_gears::words;
use std::fmt;

/// A shaft of the drive.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Shaft {
    /// The sun's.
    Sun,
    /// A planet's pin.
    Planet,
    /// The carrier's.
    Carrier,
}

impl fmt::Display for Shaft {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Sun => "sun's shaft",
            Self::Planet => "planet's pin",
            Self::Carrier => "carrier's shaft",
        })
    }
}

/// A gear of the drive with a bore.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BoredGear {
    /// The sun.
    Sun,
    /// A planet.
    Planet,
}

impl fmt::Display for BoredGear {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Sun => "sun",
            Self::Planet => "planet",
        })
    }
}

words! {
    /// A result that must be finite; displays as in messages, `starting time`.
    Computed {
        CarrierMass "mass of the carrier"
        CarrierInertia "inertia of the carrier"
        GearMass "mass of a gear"
        GearInertia "inertia of a gear"
        BearingForce "force on a planet bearing"
        MeshForce "force at a mesh"
        PlanetSpeed "speed of the planet"
        CarrierTorque "torque of the carrier"
        EquivalentInertia "equivalent inertia"
        KineticEnergy "kinetic energy"
        Acceleration "acceleration"
        StartingTime "starting time"
        ShaftStress "stress of a shaft"
        RingRoot "root diameter of the ring"
        RatioError "error of the ratio"
    }
}

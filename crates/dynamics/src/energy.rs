//! Kinetic energy, link by link.
//!
//! ```text
//! T = Σ ½·(J·ω² + m·v²)
//! ```
//!
//! # Source
//! excavator-dynamics, kinetic energy of the moving parts.

use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Energy, Mass, MomentOfInertia, Velocity};

/// One body as it moves: all values absolute, seen from the housing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MovingBody {
    /// Inertia about the axis through the centre of mass, `J`.
    pub inertia: MomentOfInertia,
    /// Absolute speed of rotation, `ω`.
    pub speed: AngularVelocity,
    /// Mass, `m`; it counts only where the centre moves.
    pub mass: Mass,
    /// Speed of the centre of mass, `v`.
    pub centre_speed: Velocity,
}

impl MovingBody {
    /// A body that turns about its own resting centre.
    #[must_use]
    pub fn turning(inertia: MomentOfInertia, speed: AngularVelocity) -> Self {
        Self { inertia, speed, mass: Mass::default(), centre_speed: Velocity::default() }
    }

    /// Kinetic energy, `½·J·ω² + ½·m·v²` (König).
    #[must_use]
    pub fn kinetic_energy(&self) -> Energy {
        let v_m_s = self.centre_speed.si();
        let turning = self.inertia.si() * self.speed.si().powi(2);
        Energy::from_si(0.5 * (turning + self.mass.si() * v_m_s * v_m_s))
    }
}

/// Kinetic energy of all bodies.
#[must_use]
pub fn kinetic_energy<'a>(bodies: impl IntoIterator<Item = &'a MovingBody>) -> Energy {
    Energy::from_si(bodies.into_iter().map(|body| body.kinetic_energy().si()).sum())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rolling_disc_has_both_parts() {
        let disc = MovingBody {
            inertia: MomentOfInertia::from_si(1.0),
            speed: AngularVelocity::from_si(-2.0),
            mass: Mass::from_si(2.0),
            centre_speed: Velocity::from_si(3.0),
        };
        assert!((kinetic_energy(&[disc, disc]).si() - 2.0 * 11.0).abs() < 1e-14);
    }
}

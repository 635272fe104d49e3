//! Kinetic energy, link by link.
//!
//! ```text
//! T = Σ ½·(J·ω² + m·v²)
//! ```
//!
//! # Source
//! excavator-dynamics, kinetic energy of the moving parts.

use crate::units::{energy, joules, kg_m2, kilograms, m_per_s, rad_per_s};
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

    /// Its kinetic energy, `½·J·ω² + ½·m·v²` (König).
    #[must_use]
    pub fn kinetic_energy(&self) -> Energy {
        let v_m_s = m_per_s(self.centre_speed);
        let turning = kg_m2(self.inertia) * rad_per_s(self.speed).powi(2);
        energy(0.5 * (turning + kilograms(self.mass) * v_m_s * v_m_s))
    }
}

/// Kinetic energy of all bodies.
#[must_use]
pub fn kinetic_energy<'a>(bodies: impl IntoIterator<Item = &'a MovingBody>) -> Energy {
    energy(bodies.into_iter().map(|body| joules(body.kinetic_energy())).sum())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::{angular_velocity, inertia, mass};
    use uom::si::velocity::meter_per_second;

    #[test]
    fn a_rolling_disc_has_both_parts() {
        let disc = MovingBody {
            inertia: inertia(1.0),
            speed: angular_velocity(-2.0),
            mass: mass(2.0),
            centre_speed: Velocity::new::<meter_per_second>(3.0),
        };
        assert!((joules(kinetic_energy(&[disc, disc])) - 2.0 * 11.0).abs() < 1e-14);
    }
}

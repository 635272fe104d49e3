//! Lagrange's equation of the second kind with the driving shaft's angle as coordinate.
//!
//! ```text
//! d/dt(∂T/∂φ̇_1) − ∂T/∂φ_1 = Q,   T = ½·J_pr·φ̇_1²,   J_pr constant   ⇒   J_pr·ε_1 = Q
//! Q = Σ M_j·u_j
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `J_pr` | equivalent inertia ([`crate::equivalent_inertia`]) | kg·m² |
//! | `Q` | generalized force: virtual work of the torques for a unit turn of the driving shaft | N·m |
//! | `M_j`, `u_j` | torque on link `j`, and its speed over that of the driving shaft | N·m, 1 |
//!
//! # Source
//! excavator-dynamics (9), (10). The source gives `Q` in J; per radian of the coordinate it is N·m.

use crate::Error;
use crate::units::{angular_acceleration, kg_m2, n_m, rad_per_s, rad_per_s2, time, torque};
use uom::si::f64::{AngularAcceleration, AngularVelocity, MomentOfInertia, Time, Torque};

/// A torque on a link from outside.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AppliedTorque {
    /// The torque, positive along the axis.
    pub torque: Torque,
    /// Speed of its link over that of the driving shaft.
    pub speed_ratio: f64,
}

/// Generalized force of the torques, `Q = Σ M·u`. Losses are not in it.
#[must_use]
pub fn generalized_force(torques: &[AppliedTorque]) -> Torque {
    torque(torques.iter().map(|applied| n_m(applied.torque) * applied.speed_ratio).sum())
}

/// Acceleration of the driving shaft, `ε_1 = Q/J_pr`.
///
/// # Errors
/// [`Error::NoInertia`] unless `J_pr` is above zero.
pub fn acceleration(
    force: Torque,
    equivalent_inertia: MomentOfInertia,
) -> Result<AngularAcceleration, Error> {
    let j = kg_m2(equivalent_inertia);
    if j.is_nan() || j <= 0.0 {
        return Err(Error::NoInertia);
    }
    Ok(angular_acceleration(n_m(force) / j))
}

/// Acceleration of a link that turns at `speed_ratio` times the driving shaft, `ε = ε_1·u`.
#[must_use]
pub fn link_acceleration(driving: AngularAcceleration, speed_ratio: f64) -> AngularAcceleration {
    driving * speed_ratio
}

/// Time from rest to `speed` under a constant acceleration, `t = ω/ε`.
///
/// Both torques are taken as constant over the start, which a hydraulic motor at constant pressure
/// is near to; for a motor with a falling characteristic it is a lower bound.
///
/// # Errors
/// [`Error::DoesNotStart`] unless the drive accelerates towards `speed`.
pub fn starting_time(
    speed: AngularVelocity,
    force: Torque,
    equivalent_inertia: MomentOfInertia,
) -> Result<Time, Error> {
    let acceleration = rad_per_s2(acceleration(force, equivalent_inertia)?);
    let duration_s = rad_per_s(speed) / acceleration;
    if duration_s.is_finite() && duration_s >= 0.0 {
        Ok(time(duration_s))
    } else {
        Err(Error::DoesNotStart { surplus_n_m: n_m(force) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::{angular_velocity, inertia, seconds};

    #[test]
    fn a_shaft_starts_as_a_flywheel_does() {
        let force = generalized_force(&[
            AppliedTorque { torque: torque(12.0), speed_ratio: 1.0 },
            AppliedTorque { torque: torque(-60.0), speed_ratio: 1.0 / 6.0 },
        ]);
        assert!((n_m(force) - 2.0).abs() < 1e-14);
        assert!((rad_per_s2(acceleration(force, inertia(0.5)).unwrap()) - 4.0).abs() < 1e-13);
        let t = starting_time(angular_velocity(100.0), force, inertia(0.5)).unwrap();
        assert!((seconds(t) - 25.0).abs() < 1e-12);
    }

    #[test]
    fn an_overloaded_drive_does_not_start() {
        let overloaded = starting_time(angular_velocity(100.0), torque(-1.0), inertia(0.5));
        assert_eq!(overloaded, Err(Error::DoesNotStart { surplus_n_m: -1.0 }));
        let balanced = starting_time(angular_velocity(100.0), torque(0.0), inertia(0.5));
        assert_eq!(balanced, Err(Error::DoesNotStart { surplus_n_m: 0.0 }));
    }

    #[test]
    fn nothing_accelerates_without_inertia() {
        assert_eq!(acceleration(torque(1.0), inertia(0.0)), Err(Error::NoInertia));
    }
}

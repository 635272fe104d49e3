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
use epicyclic_units::Physical;
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
    Torque::from_si(torques.iter().map(|applied| applied.torque.si() * applied.speed_ratio).sum())
}

/// Acceleration of the driving shaft, `ε_1 = Q/J_pr`.
///
/// # Errors
/// [`Error::NoInertia`] unless `J_pr` is above zero.
pub fn acceleration(
    force: Torque,
    equivalent_inertia: MomentOfInertia,
) -> Result<AngularAcceleration, Error> {
    let j = equivalent_inertia.si();
    if j.is_nan() || j <= 0.0 {
        return Err(Error::NoInertia);
    }
    Ok(AngularAcceleration::from_si(force.si() / j))
}

/// Acceleration of a link that turns at `speed_ratio` times the driving shaft, `ε = ε_1·u`.
#[must_use]
pub fn link_acceleration(driving: AngularAcceleration, speed_ratio: f64) -> AngularAcceleration {
    driving * speed_ratio
}

/// Time from rest to `speed` under a constant acceleration, `t = ω/ε`.
///
/// Both torques are taken as constant over the start. A hydraulic motor at constant pressure is near to this;
/// for a motor with a falling characteristic the result is a lower bound.
///
/// # Errors
/// [`Error::DoesNotStart`] unless the drive accelerates towards `speed`.
pub fn starting_time(
    speed: AngularVelocity,
    force: Torque,
    equivalent_inertia: MomentOfInertia,
) -> Result<Time, Error> {
    let acceleration = acceleration(force, equivalent_inertia)?.si();
    let duration_s = speed.si() / acceleration;
    if duration_s.is_finite() && duration_s >= 0.0 {
        Ok(Time::from_si(duration_s))
    } else {
        Err(Error::DoesNotStart { surplus_n_m: force.si() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shaft_starts_as_a_flywheel_does() {
        let force = generalized_force(&[
            AppliedTorque { torque: Torque::from_si(12.0), speed_ratio: 1.0 },
            AppliedTorque { torque: Torque::from_si(-60.0), speed_ratio: 1.0 / 6.0 },
        ]);
        assert!((force.si() - 2.0).abs() < 1e-14);
        assert!((acceleration(force, MomentOfInertia::from_si(0.5)).unwrap().si() - 4.0).abs() < 1e-13);
        let t = starting_time(AngularVelocity::from_si(100.0), force, MomentOfInertia::from_si(0.5)).unwrap();
        assert!((t.si() - 25.0).abs() < 1e-12);
    }

    #[test]
    fn an_overloaded_drive_does_not_start() {
        let overloaded = starting_time(
            AngularVelocity::from_si(100.0),
            Torque::from_si(-1.0),
            MomentOfInertia::from_si(0.5),
        );
        assert_eq!(overloaded, Err(Error::DoesNotStart { surplus_n_m: -1.0 }));
        let balanced = starting_time(
            AngularVelocity::from_si(100.0),
            Torque::from_si(0.0),
            MomentOfInertia::from_si(0.5),
        );
        assert_eq!(balanced, Err(Error::DoesNotStart { surplus_n_m: 0.0 }));
    }

    #[test]
    fn nothing_accelerates_without_inertia() {
        assert_eq!(acceleration(Torque::from_si(1.0), MomentOfInertia::from_si(0.0)), Err(Error::NoInertia));
    }
}

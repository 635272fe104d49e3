//! Errors in a drag torque.

use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Torque};

/// Error in a drag torque.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DragFault {
    /// A curve without points.
    #[error("a curve has at least one point")]
    NoPoints,
    /// Speeds and torques that do not belong together.
    #[error("{speeds} speeds and {torques} torques: a curve has as many of both")]
    Lengths {
        /// Number of speeds.
        speeds: usize,
        /// Number of torques.
        torques: usize,
    },
    /// A speed below 0, or no number.
    #[error("a relative speed is finite and at least 0: point {} has {} rpm", place + 1, rpm(*speed))]
    Speed {
        /// The place of the point.
        place: usize,
        /// Speed of the point.
        speed: AngularVelocity,
    },
    /// A torque below 0, or no number.
    #[error("a torque is finite and at least 0, and opposes the motion: point {} has {} N·m", place + 1, torque.si())]
    Torque {
        /// The place of the point.
        place: usize,
        /// Torque of the point.
        torque: Torque,
    },
    /// A speed that is not above that of the previous point.
    #[error("speeds ascend from point to point: that of point {} is not above the one before it", place + 1)]
    NotAscending {
        /// The place of the point.
        place: usize,
    },
    /// A drag between a link and itself.
    #[error("it stands between two links: `{link}` is named twice")]
    OneLink {
        /// The link.
        link: String,
    },
    /// A relative speed outside the curve.
    #[error(
        "its links turn {} rpm against each other, and its curve is from {} to {} rpm: give points there, or beyond: constant",
        rpm(*slip), rpm(speeds[0]), rpm(speeds[1])
    )]
    Outside {
        /// The relative speed.
        slip: AngularVelocity,
        /// The first and the last speed of the curve.
        speeds: [AngularVelocity; 2],
    },
    /// A link whose speed does not follow from the input's.
    #[error("the speed of its link `{link}` does not follow from the input's in this gear")]
    Adrift {
        /// The link.
        link: String,
    },
}

/// A speed in rpm for messages, rounded to a millionth.
fn rpm(speed: AngularVelocity) -> f64 {
    const MILLIONTHS: f64 = 1e6;
    let rounded = (speed.rpm() * MILLIONTHS).round() / MILLIONTHS;
    if rounded.is_finite() { rounded } else { speed.rpm() }
}

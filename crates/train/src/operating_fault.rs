//! Reasons why a gear does not run at an operating point.

/// Reason why a gear does not run at an operating point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum OperatingFault {
    /// Power into an input without speed.
    #[error("an input at rest takes no power")]
    PowerAtRest,
    /// A speed or load that is not finite, or too large.
    #[error("speed and load are numbers up to 1e50 in size")]
    NoNumber,
    /// A speed or torque, among several, that is not finite or too large.
    #[error("speeds and torques are numbers up to 1e50 in size")]
    NoNumbers,
    /// Power out of the input of a gear that is self-locking in this direction.
    #[error("power cannot leave at the input: the gear is self-locking when driven from its output")]
    SelfLocking,
}

//! The flanks under load: loaded satellites, forces, sealing, a third contact, stresses.
//!
//! # Contents
//!
//! | module | answers |
//! |---|---|
//! | [`forces`] | the forces on the flanks of each satellite, the rotor's bearing |
//! | [`sealing`] | where the flanks seal: flow and ripple there |
//! | [`third`] | the third contact that holds a satellite |
//! | [`stress`] | pressures of Hertz |
//! | [`root`] | bending at the roots, the pressure that a shape allows |
//! | [`starting`] | the torque at the start, against friction with the contacts where they are |
//!
//! # Frame and signs
//! The frame of a satellite is that of its ray: x along the ray from the axis, y across it counter-clockwise,
//! the origin in the middle of the chord `PP₁` of its pitch points. There `P = (r·cos μ, 0)`,
//! `P₁ = (−r·cos μ, 0)`, and the centre is `(0, r·sin μ)`. `σ` is the sign of the pressure force: `+1`
//! forward, with the high pressure behind the satellite, `−1` back. A satellite pushed back is the mirror
//! image, in the ray, of one pushed forward with `−μ` for `μ`.
//!
//! The forces of the flanks on a satellite are in the lines of action. These pass through the pitch points at
//! `α` to the pitch curves and touch the base circle:
//!
//! ```text
//! stator  u₃ = (−sin(α + σ·μ), −σ·cos(α + σ·μ))        about the centre  −σ·r·cos α
//! rotor   u₁ = (+sin(α + σ·μ), −σ·cos(α + σ·μ))        about the centre  +σ·r·cos α
//! ```
//!
//! The back flanks have these directions with `−σ`.
//!
//! # Left out
//! Inertia, friction at the flanks, elastic teeth and the share of load between two pairs in mesh.

pub mod forces;
mod kernel;
pub mod root;
pub mod sealing;
#[cfg(test)]
mod slow;
pub mod starting;
pub mod stress;
pub mod third;

pub use forces::{BearingLoad, FlankForce, GreatestFlankForce, Push};
pub use root::{AllowedPressure, Governing, MaterialLimits, RootStress};
pub use sealing::{FlankRipple, SealingContact};
pub use starting::StartingTorque;
pub use stress::{ContactStress, LoadedPath, Mesh, PeakPressure, effective_modulus};
pub use third::{ForceBound, ThirdContact, ThirdContactBounds};

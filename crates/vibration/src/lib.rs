//! Modes of gear sets.
//!
//! # Contents
//!
//! | module | answers |
//! |---|---|
//! | [`gear_set`] | a set of any kind as bodies and springs, planar or torsional |
//! | [`planetary`] | a simple set in the form of the literature |
//! | [`train`] | several sets on common links, torsional |
//! | [`coupled`] | the same in the plane |
//! | [`model`] | any bodies and springs, supports, shafts |
//! | [`modes`] | natural frequencies and modes, in groups by frequency and kind |
//! | [`gyroscopic`] | modes while the carrier turns |
//! | [`phasing`] | which modes the teeth of equally spaced planets excite |
//! | [`kahraman`] | torsional frequencies in closed form |
//! | [`response`] | forced vibration by transmission errors |
//! | [`energy`] | modal energy of each body and spring, sensitivities |
//!
//! Bodies are rigid, springs linear, displacements small; the stiffness of a mesh is given. The axes turn
//! with the carrier. All quantities are those of [`uom`]; a stiffness is a [`Stiffness`], N/m.
//!
//! # Example
//!
//! ```
#![doc = include_str!("../examples/modes.rs")]
//! ```

mod checks;
mod classify;
pub mod coupled;
pub mod energy;
mod error;
pub mod gear_set;
pub mod gyroscopic;
pub mod kahraman;
mod kernel;
pub mod model;
pub mod modes;
pub mod phasing;
pub mod planetary;
pub mod response;
mod stiffness;
mod tolerance;
pub mod train;

pub use energy::{InertiaKind, KineticShare, ModalEnergy, StrainShare};
pub use error::Error;
pub use gear_set::{BodyOf, Central, Gear, GearMesh, GearSet, GearSetParts, Member, PlanetBody};
pub use gyroscopic::{Centripetal, WhirlMode};
pub use model::{Axis, Body, BodyId, Freedom, Model, Shape, SpringId, Support};
pub use modes::{Group, Kind, Mode, Modes};
pub use planetary::{Planet, PlanetarySet, SetParts};
pub use stiffness::{Stiffness, TorsionalStiffness, newtons_per_meter};

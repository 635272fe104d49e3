//! The catalogue of two- and three-speed planetary gearboxes, and the mining machines that they drive.
//!
//! # Contents
//!
//! | module | answers |
//! |---|---|
//! | [`catalogue`] | the source's schemes I…III, I-1…III-3: closed forms, ranges, k from a ratio |
//! | [`connection`] | the 36 ways to connect the second set, and which of them are the eleven |
//! | [`ratio_series`] | series of ratios for 2 to 4 speeds |
//! | [`machines`] | mining machines and the number of speeds recommended for them |
//! | [`structures`], [`standing`] | all 111 two-set structures, and why the source has or lacks each |
//! | [`direct_drive`] | every option for the direct-drive clutch, its torque and slip |
//! | [`cutting`], [`rotor`] | speeds that cutters and bucket wheels need |
//!
//! # Example
//!
//! ```
//! use epicyclic_schemes::catalogue::TwoSpeed;
//! # fn main() -> Result<(), epicyclic_schemes::Error> {
//! // The conveyor of section 3.3: scheme I with i = 3.94 has k = 2.94.
//! assert!((TwoSpeed::I.ring_to_sun_ratio(3.94)?.get() - 2.94).abs() < 1e-9);
//! # Ok(())
//! # }
//! ```

pub mod catalogue;
pub mod connection;
pub mod cutting;
pub mod direct_drive;
mod error;
pub mod machines;
pub mod pair;
pub mod quantity;
pub mod ratio_series;
pub mod rotor;
pub mod standing;
pub mod structures;
mod tolerance;

pub use error::Error;
pub use ratio_series::RatioSeries;

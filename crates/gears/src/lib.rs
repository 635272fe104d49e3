//! One gear set: the parts of a planetary gear, from their teeth to their masses.
//!
//! | module | computes |
//! |---|---|
//! | [`teeth`] | tooth counts |
//! | [`geometry`] | diameters of a wheel, centre distance of a pair |
//! | [`shaft`] | shaft diameter by reduced torsional stress, standard diameters |
//! | [`bearing`] | deep-groove ball bearings by designation, bore or shaft |
//! | [`error`] | everything that is refused |
//!
//! Quantities are `uom` quantities; nothing here prints, reads or writes.

pub mod bearing;
pub mod error;
pub mod geometry;
pub mod shaft;
pub mod teeth;
mod units;

pub use error::Error;
pub use teeth::ToothCount;

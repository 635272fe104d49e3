//! One planetary gear set: how it turns, which tooth numbers build it, what it loses.
//!
//! # Contents
//!
//! | module | answers |
//! |---|---|
//! | [`teeth`] | what a tooth count is |
//! | [`row`] | stationary ratio of a row of any kind, row parameter `k`, the six modes |
//! | [`willis`] | speeds of sun, ring, carrier and planet from any two |
//! | [`efficiency`] | torques and efficiency of a row from the losses of its meshes |
//! | [`synthesis`] | *every* tooth set of a simple planetary gear within bounds |
//! | [`spacing`] | where the planets sit when they cannot sit evenly |
//! | [`rack`] | the basic rack that all checks take, and undercut |
//! | [`geometry`] | diameters of a wheel, centre distance of a pair |
//! | [`mass`] | volume, mass and polar inertia of rings and wheels |
//! | [`carrier`] | the same of a planet carrier |
//! | [`pin`] | forces on the bearing and pin of a planet |
//! | [`shaft`] | shaft diameter by reduced torsional stress, standard diameters |
//! | [`life`] | how long a rolling bearing lasts |
//! | [`bearing`] | deep-groove ball bearings by designation, bore or shaft |
//!
//! Quantities are `uom` quantities; nothing here prints, reads or writes.
//!
//! # Sign convention
//!
//! One for the whole workspace. Speeds and torques are positive along the common axis. A torque is
//! the one that acts *on* the member from outside the row, so a driving member has positive power
//! `T·ω` and a driven one negative; the three torques of a row sum to zero.
//!
//! # Example
//!
//! ```
//! use epicyclic_gears::row::{Member, Mode, StationaryRatio};
//! use epicyclic_gears::teeth::ToothCount;
//!
//! # fn main() -> Result<(), epicyclic_gears::Error> {
//! let row = StationaryRatio::simple(ToothCount::new(20)?, ToothCount::new(100)?);
//! let sun_to_carrier = Mode::new(Member::Sun, Member::Carrier)?;
//! assert_eq!(row.ratio(sun_to_carrier)?, 6.0);
//! # Ok(())
//! # }
//! ```

pub mod bearing;
pub mod carrier;
pub mod efficiency;
pub mod error;
pub mod geometry;
pub mod life;
pub mod mass;
pub mod pin;
pub mod rack;
pub mod row;
pub mod shaft;
pub mod spacing;
pub mod synthesis;
pub mod teeth;
mod tolerance;
mod units;
pub mod willis;

pub use error::Error;
pub use teeth::ToothCount;

//! One planetary gear set: how it turns, which tooth numbers build it, what it loses.
//!
//! # Contents
//!
//! | module | answers |
//! |---|---|
//! | [`teeth`] | what a tooth count is |
//! | [`simple_set`] | basic ratio of a gear set of two central gears, ring-to-sun ratio `k`, the six modes |
//! | [`willis`] | speeds of sun, ring, carrier and planet from any two |
//! | [`efficiency`] | torques and efficiency of a gear set from the losses of its meshes |
//! | [`synthesis`] | *every* set of tooth numbers of a simple set within bounds |
//! | [`double_planet`] | *every* set of tooth numbers with two planets in mesh between sun and ring |
//! | [`arrangement`] | *every* set of tooth numbers with stepped planets, Wolfrom and Ravigneaux sets, and pairs |
//! | [`spacing`] | where the planets sit when they cannot sit evenly |
//! | [`rack`] | the basic rack that all checks take, and undercut |
//! | [`mesh`] | circles of gears and centre distance from teeth alone, clearance between planets |
//! | [`involute`] | gears with profile shift: circles, thickness, mesh of a pair, measures, interference |
//! | [`geometry`] | diameters of a gear, centre distance of a pair |
//! | [`mass`] | volume, mass and polar inertia of rings and gears |
//! | [`carrier`] | volume, mass and polar inertia of a planet carrier |
//! | [`planet_bearing`] | forces on the bearings and the pin of a planet |
//! | [`shaft`] | shaft diameter by a low allowable torsional stress, standard diameters |
//! | [`life`] | how long a rolling bearing lasts |
//! | [`bearing`] | deep-groove ball bearings by designation, bore or shaft |
//! | [`quantity`] | what the values are of that an error refuses |
//!
//! Quantities are `uom` quantities; nothing here prints, reads or writes.
//!
//! # Sign convention
//!
//! One convention holds for the whole workspace. Speeds and torques are positive along the common axis. A
//! torque is the one that acts *on* the member from outside the gear set. A driving member therefore has
//! positive power `T·ω`, a driven one negative power. The three torques of a simple set sum to zero.
//!
//! # Example
//!
//! ```
//! use epicyclic_gears::simple_set::{Member, Mode, BasicRatio};
//! use epicyclic_gears::teeth::ToothCount;
//!
//! # fn main() -> Result<(), epicyclic_gears::Error> {
//! let set = BasicRatio::simple(ToothCount::new(20)?, ToothCount::new(100)?);
//! let sun_to_carrier = Mode::new(Member::Sun, Member::Carrier)?;
//! assert_eq!(set.ratio(sun_to_carrier)?, 6.0);
//! # Ok(())
//! # }
//! ```

pub mod arrangement;
pub mod bearing;
pub mod carrier;
mod checks;
pub mod double_planet;
pub mod efficiency;
pub mod error;
mod gear_kind;
pub mod geometry;
pub mod involute;
pub mod life;
pub mod mass;
pub mod mesh;
mod message;
mod mode;
mod nearest;
pub mod planet_bearing;
pub mod quantity;
pub mod rack;
pub mod shaft;
pub mod simple_set;
pub mod spacing;
pub mod synthesis;
pub mod teeth;
mod tolerance;
pub mod willis;
mod words;

pub use error::Error;
pub use message::{shown, with_unit};
pub use quantity::Quantity;
pub use teeth::ToothCount;

//! One gear set: the parts of a planetary gear, from their teeth to their masses.
//!
//! | module | computes |
//! |---|---|
//! | [`teeth`] | tooth counts |
//! | [`geometry`] | diameters of a wheel, centre distance of a pair |
//! | [`mass`] | volume, mass, polar inertia of rings and wheels |
//! | [`carrier`] | the same of a planet carrier |
//! | [`shaft`] | shaft diameter by reduced torsional stress, standard diameters |
//! | [`bearing`] | deep-groove ball bearings by designation, bore or shaft |
//! | [`error`] | everything that is refused |
//!
//! Quantities are `uom` quantities; nothing here prints, reads or writes. Behind the feature `serde` results serialize,
//! their quantities as numbers in SI units.
//!
//! ```
//! use epicyclic_gears::bearing::{self, Series};
//! use epicyclic_gears::shaft;
//! use uom::si::f64::{Length, Pressure, Torque};
//! use uom::si::{length::millimeter, pressure::megapascal, torque::newton_meter};
//!
//! // A shaft that satisfies its formula, and the bearing that takes it.
//! let needed = shaft::diameter(Torque::new::<newton_meter>(521.8), Pressure::new::<megapascal>(20.0))?;
//! let chosen = shaft::standard_diameter(needed)?;
//! assert_eq!(chosen, Length::new::<millimeter>(53.0));
//! assert_eq!(bearing::smallest_for_shaft(Series::Medium300, chosen)?.designation, "311");
//! # Ok::<(), epicyclic_gears::Error>(())
//! ```

pub mod bearing;
pub mod carrier;
pub mod error;
pub mod geometry;
pub mod mass;
pub mod shaft;
pub mod teeth;
mod units;

pub use error::Error;
pub use teeth::ToothCount;

//! Pictures of hydromotors: centrodes with their construction, the motor at an angle, its teeth, its chambers
//! by pressure.
//!
//! | function | draws |
//! |---|---|
//! | [`centrodes`] | stator, rotor, satellites; centres, distances, radii, angles and junctions of the arcs |
//! | [`construction`] | half a lobe of stator and rotor: system (1), formulas (2)–(8), letters and angles |
//! | [`whole`] | the motor at an angle in its housing, with its ports |
//! | [`plate`] | ports as they are made, with the motor behind them and their timing |
//! | [`chambers`] | the motor at an angle, chambers coloured by pressure |
//! | [`forces`] | the forces on the satellites and on the rotor's bearing at an angle |
//! | [`dimensions`] | the motor with its dimensions and a table of wheel data, for a drawing office |
//! | [`teeth`] | outlines of all teeth in mesh at an angle |
//! | [`outline`] | a centrode as a closed polyline of arcs |
//!
//! One unit is a millimetre. The frame is that of [`epicyclic_hydromotor::motor`]: a stator crest on the x
//! axis, angles counter-clockwise. The stator of two arcs is drawn with its exact arcs. Curves that are not
//! arcs, above all the rotor, are drawn with biarcs within [`TOLERANCE_MM`]. Text and lines are scaled to the
//! size of the motor.
//!
//! # Example
//! ```
//! use epicyclic_hydromotor::{Motor, MotorNumbers};
//! use epicyclic_pictures::motor::chambers;
//! use uom::si::{angle::degree, f64::{Angle, Length}, length::millimeter};
//!
//! let mm = Length::new::<millimeter>;
//! let motor = Motor::of_two_arcs(MotorNumbers::new(5, 3, 55, 10)?, mm(2.0), mm(80.0))?;
//! let scene = chambers(&motor, Angle::new::<degree>(30.0))?;
//! assert!(epicyclic_drawing::svg::write(&scene)?.contains("high pressure"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod centrodes;
mod chambers;
mod construction;
mod curve;
mod dimensions;
mod forces;
mod plate;
mod sheet;
mod teeth;
mod whole;

pub use centrodes::centrodes;
pub use chambers::{STEPS, chambers};
pub use construction::construction;
pub use curve::{Outline, TOLERANCE_MM, outline};
pub use dimensions::dimensions;
pub use forces::forces;
pub use plate::plate;
pub use teeth::{SIDES, teeth};
pub use whole::whole;

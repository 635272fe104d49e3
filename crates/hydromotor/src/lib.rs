//! Hydromotors with non-circular wheels and floating satellites: geometry that closes, and working data.
//!
//! A ring with `N` arches (the stator), a sun with `n < N` lobes (the rotor), and between them `N + n` round
//! satellites that roll on both and float; neighbouring satellites bound the working chambers.
//!
//! # Contents
//!
//! | module | answers |
//! |---|---|
//! | [`numbers`] | which numbers of lobes and teeth are admissible, and why |
//! | [`arcs`] | the stator's two arcs from any two of their parameters |
//! | [`closure`] | which of them close: the whole family of motors of given numbers, sensitivity |
//! | [`junction`] | the point where the images of the arcs meet on the rotor, by the source's formulas |
//! | [`cosine`] | the other way: a cosine-law rotor and its conjugate stator |
//! | [`second_harmonic`] | the same with a second harmonic: one family, no jump of the curvature; its range |
//! | [`motor`] | a closed motor; frame and signs |
//! | [`place`] | which of the motors of given numbers is meant |
//! | [`centrode`] | stator, rotor and satellite as curves of their arc length |
//! | [`satellites`] | where each satellite is, how it has turned, how near its neighbours come |
//! | [`two_arc_fit`] | how nearly the rotor consists of arcs |
//! | [`chambers`] | areas and outlines of the chambers, displacement |
//! | [`flow`] | flow, torque, power, and their ripple |
//! | [`forces`] | forces of the pressure on the satellites, ports |
//! | [`ports`] | ports as made: openings, timing, trapped pressure, throttling |
//! | [`machine`] | bounds of a motor's size; whether the rotor turns within the stator |
//! | [`leakage`] | leakage through the gaps at the end faces |
//! | [`friction`] | friction of flanks and end gaps, starting torque |
//! | [`efficiency`] | volumetric, mechanical, total efficiency over speed and pressure |
//! | [`profile`] | teeth of all wheels, their limits, how near they come |
//! | [`flanks`] | the flanks under load: forces, bearing, sealing, third contact, stresses, pressure limit |
//! | [`checks`] | curvatures and distances against the satellite and its teeth, size |
//! | [`ranges`] | the values that a quantity of any motor can have |
//! | [`search`] | Pareto front for a displacement or torque, over all numbers and motors of two arcs |
//! | [`search::forms`] | the same over three families and with the tooth form free |
//!
//! Quantities are `uom` quantities; the kernels work in units of the module. Nothing here prints, reads or
//! writes.
//!
//! # Left out
//! Drawings; leaks at the flanks, the friction of bearings and seals, the pressure in a chamber while it
//! opens or closes, the change of viscosity; elastic teeth, strength beyond the stresses of [`flanks`].
//!
//! # Example
//!
//! ```
//! use epicyclic_hydromotor::closure::Family;
//! use epicyclic_hydromotor::{Motor, MotorNumbers};
//! use uom::si::area::square_millimeter;
//! use uom::si::f64::Length;
//! use uom::si::length::millimeter;
//!
//! # fn main() -> Result<(), epicyclic_hydromotor::Error> {
//! let mm = Length::new::<millimeter>;
//! let numbers = MotorNumbers::new(5, 3, 55, 10)?;
//! let family = Family::new(numbers, mm(2.0))?;
//! let arcs = family.at_part(0.5)?;
//! let motor = Motor::of_two_arcs(numbers, mm(2.0), arcs.trough_distance())?;
//! let displacement = motor.displacement_per_width().get::<square_millimeter>();
//! assert!(displacement > 5_600.0 && motor.ripple().delta < 0.08);
//! # Ok(())
//! # }
//! ```

pub mod arcs;
pub mod centrode;
pub mod chambers;
pub mod checks;
pub mod closure;
mod contact;
pub mod cosine;
pub mod efficiency;
pub mod error;
pub mod flanks;
pub mod flow;
pub mod forces;
pub mod friction;
pub mod junction;
pub mod leakage;
pub mod machine;
mod modules;
pub mod motor;
pub mod numbers;
pub mod place;
pub mod ports;
pub mod profile;
pub mod quantity;
pub mod ranges;
mod real;
mod reason;
pub mod satellites;
pub mod search;
pub mod second_harmonic;
mod tolerance;
pub mod two_arc_fit;
mod two_arcs;

pub use error::Error;
pub use motor::Motor;
pub use numbers::MotorNumbers;

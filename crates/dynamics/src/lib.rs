//! Motion of geared drives with one degree of freedom.
//!
//! # Contents
//!
//! | module | answers |
//! |---|---|
//! | [`equivalent_inertia`] | one inertia at the driving shaft in place of all moving links |
//! | [`gearbox`] | the moving links of any planetary gearbox in a gear |
//! | [`energy`] | kinetic energy, link by link |
//! | [`lagrange`] | generalized force and accelerations, Lagrange's equation of the second kind |
//! | [`loads`] | torques and powers on the shafts |
//! | [`planetary`] | a simple planetary drive: its links, its motion with and without mesh losses |
//! | [`drive`] | the whole design of such a drive, from power and ratio to the starting time |
//!
//! Signs follow [`epicyclic_gears`]: speeds and torques are positive along the common axis, a
//! torque acts on the link from outside.
//!
//! [`energy`] and [`equivalent_inertia`] share no code: the first sums over absolute speeds, the second over
//! ratios of tooth numbers, so that `T = ½·J_pr·ω_1²` tests both.

pub mod drive;
pub mod energy;
pub mod equivalent_inertia;
pub mod error;
pub mod gearbox;
pub mod lagrange;
pub mod link_name;
pub mod loads;
pub mod planetary;
mod tolerance;

pub use error::Error;

//! The crate against published figures, and against calculations that share no formula with it.
#![cfg(test)]

mod common;
mod coupled;
mod energy;
mod gear_set;
mod gyroscopic;
mod modal;
mod phasing;
mod published;
mod response;
mod torsional;
mod train;

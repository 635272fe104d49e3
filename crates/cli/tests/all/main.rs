//! The program from outside. One program: its tests run side by side.

mod book;
mod calls;
mod cli;
#[path = "../common/mod.rs"]
mod common;
mod design;
mod draw;
mod endings;
mod every_input;
mod every_set;
mod files;
mod gearboxes;
mod helical;
mod json;
mod kept_inputs;
mod motor;
mod motor_forms;
mod pictures;
mod planets;
mod readme;
mod refusals;
mod report;
mod serve;
mod sessions;
mod shards;
mod shells;
mod simulate;
mod start;
mod streams;
mod synthesize;
mod vibration;

//! Commands against second ways. One program: its tests run side by side.

mod arranged_stages;
mod arranged_teeth;
mod bearings;
mod clutches;
#[allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests, which clippy does not know for such")]
mod common;
mod design;
mod design_limits;
mod every_set;
mod idlers;
mod judgement;
mod motor_search;
mod output_play;
mod parallel;
mod plain;
mod size;
mod size_every_set;
mod synthesis;
mod vibrating_sets;

//! Motions against second ways. One program: its tests run side by side.

#[path = "../common/mod.rs"]
mod common;
mod cycle;
mod dogs;
mod drags;
mod drives;
mod exact;
mod properties;
mod redundant;
mod refusals;
mod shafts;

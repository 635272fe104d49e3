//! Pictures against pixels and second ways. One program: its tests run side by side.

#[path = "../common/mod.rs"]
mod common;
mod diagrams;
mod motor;
mod scheme;
mod teeth;
mod to_scale;

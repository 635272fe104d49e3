//! Strength against second ways. One program: its tests run side by side.

#[allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]
#[path = "../common/mod.rs"]
mod common;
mod laws;
mod lightest;
mod published;
mod series;
mod sizing;

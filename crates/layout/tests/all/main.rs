//! Drawability against second ways. One program: its tests run side by side.

mod drawability;
mod half_plane;

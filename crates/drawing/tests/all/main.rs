//! Drawings as others read them. One program: its tests run side by side.

mod raster;
mod read_back;

//! The harness from outside. One program: its tests run side by side.

mod book;
mod keys;
mod machines;
mod schema;
mod symbols;
mod verify;

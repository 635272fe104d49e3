//! Rules of practice from outside. One program: its tests run side by side.

mod book;
mod limits;

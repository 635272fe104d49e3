//! Choices against brute force. One program: its tests run side by side.

#[path = "../brute_common/mod.rs"]
mod brute_common;
mod every;
mod one_set;
mod search;
mod selection;

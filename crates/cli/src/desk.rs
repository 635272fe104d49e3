//! Desks of the program: files, answer and messages of a call, see [`Desk`].
//!
//! | desk | is |
//! |---|---|
//! | [`disk`] | files of the disk, written whole and of one call all or none |
//! | [`captured`] | these, with the answer and the messages kept in memory |
//! | [`memory`] | files, answer and messages kept in memory |

#[cfg(not(target_arch = "wasm32"))]
pub mod captured;
#[cfg(not(target_arch = "wasm32"))]
pub mod disk;

pub use epicyclic_commands::desk::{Content, Desk, NotWritten, Source, Text, memory};

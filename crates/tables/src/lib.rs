//! Tables of the synthesis of gearboxes as Parquet.
//!
//! | module | is |
//! |---|---|
//! | [`part`] | what a search found in a share of a class, complete or in work |
//! | [`merge`] | all parts of a search together |
//! | [`atlas`] | every structure of two and three sets, its gears and their ratios as functions |
//!
//! Nothing here reads or writes a file: a table is its bytes. They depend on the content alone.

pub mod atlas;
mod columns;
mod error;
pub mod merge;
pub mod part;
mod seal;

pub use error::Error;

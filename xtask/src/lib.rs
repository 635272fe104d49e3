//! Verification of the project against its source documents.
//!
//! | module | holds |
//! |---|---|
//! | [`cases`] | reading, running and judging of cases |
//! | [`calculations`] | calculations that a case can name |
//! | [`report`] | how an outcome is shown |
//! | [`verify`], [`schema`], [`new_case`], [`same`] | the commands, a file each |
//! | [`book`] | the book as web pages: formulas, links, symbols |
//! | [`tidy`] | what ARCHITECTURE.md promises of the code, a rule a file |
//!
//! One way through: YAML → case → calculation → domain types → result → judgement → report.

#[cfg(feature = "book")]
pub mod book;
pub mod calculations;
pub mod cases;
pub mod new_case;
pub mod report;
pub mod same;
pub mod schema;
pub mod tidy;
pub mod verify;

use std::path::PathBuf;

/// The project's root.
#[must_use]
pub fn project_root() -> PathBuf {
    let manifest = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    manifest.parent().map(PathBuf::from).unwrap_or(manifest)
}

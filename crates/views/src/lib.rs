//! Answers as tables for people, as CSV, and as parts of a page: views of the records of [`epicyclic_answers`].
//!
//! | module | is |
//! |---|---|
//! | [`report`] | an answer of several parts, shown as tables, CSV or HTML |
//! | [`figure`] | a value in it |
//! | [`text`] | tables of plain text, CSV |
//! | [`quantities`] | figures of the SI numbers in a record |
//! | [`page`] | pages of answers, pictures and words |
//! | [`drawability`] | why a gearbox cannot be drawn, in words |
//! | [`analyze`], [`compare`], [`design`], [`draw`], [`drive`], [`losses`], [`machine`], [`motor`], [`motor_forms`], [`motor_search`], [`schemes`], [`select`], [`sheet`], [`simulate`], [`size`], [`strength`], [`synthesize`], [`teeth`], [`transmissions`], [`vibration`] | the views of these answers |
//!
//! Nothing is calculated here: a figure that an answer lacks cannot be shown.

pub mod analyze;
pub mod compare;
pub mod design;
pub mod draw;
pub mod drawability;
pub mod drive;
pub mod figure;
pub mod losses;
pub mod machine;
pub mod motor;
mod motor_construction;
mod motor_designs;
pub mod motor_forms;
mod motor_satellites;
pub mod motor_search;
pub mod page;
pub mod quantities;
pub mod report;
pub mod schemes;
pub mod select;
pub mod sheet;
pub mod simulate;
pub mod size;
pub mod strength;
pub mod synthesize;
pub mod teeth;
pub mod text;
mod tolerance;
mod tooth_checks;
pub mod transmissions;
pub mod vibration;

pub use report::Report;
pub use text::Error;

/// An answer that people can read.
pub trait AsReport {
    /// Its parts: figures, lists, words, warnings.
    fn report(&self) -> Report;
}

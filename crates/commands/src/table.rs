//! Tables for people and CSV, made from answers.
//!
//! | module | is |
//! |---|---|
//! | `columns` | tables whose columns are declared once |
//! | [`report`] | an answer of several parts, shown as tables, CSV or HTML |
//! | [`figure`] | a value in it |
//! | [`text`] | tables of plain text, CSV |
//! | [`quantities`] | figures of the SI numbers in a record |
//!
//! Nothing is calculated here: a figure that an answer lacks cannot be shown.

pub(crate) mod columns;
pub mod figure;
pub mod quantities;
pub mod report;
pub mod text;

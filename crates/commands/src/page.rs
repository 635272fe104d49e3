//! Pages: the answer first, then chapters of answers, pictures and words, the input last.
//!
//! | module | is |
//! |---|---|
//! | [`sheet`] | a page |
//! | [`imprint`] | what a page says of itself |
//! | [`imprint`] | customer, author, date and paper of a page |

pub mod imprint;
pub(crate) mod paper;
pub mod sheet;

pub use imprint::{Imprint, Paper};
pub use sheet::{Block, Section, Sheet};

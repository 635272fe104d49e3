//! Quantities with units: `uom` types as numbers; with the feature `text` also as engineers write them.

mod conversion;
mod dimension;
#[cfg(feature = "text")]
mod error;
#[cfg(feature = "text")]
pub mod format;
#[cfg(feature = "text")]
mod measured;
#[cfg(feature = "text")]
mod number;
#[cfg(feature = "text")]
mod typed;
#[cfg(feature = "text")]
mod unit;
#[cfg(feature = "text")]
pub mod visible;

pub use conversion::{Module, Physical, TorsionalStiffness};
pub use dimension::Dimension;
#[cfg(feature = "text")]
pub use error::{QuantityError, with_article};
#[cfg(feature = "text")]
pub use measured::{Measured, parse, parse_as};
#[cfg(feature = "text")]
pub use number::{Number, parse_number};
#[cfg(feature = "text")]
pub use typed::{Quantity, token_dimension};
#[cfg(feature = "text")]
pub use unit::{Unit, find_unit};

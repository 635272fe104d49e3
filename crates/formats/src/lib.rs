//! placeholder
pub mod quantity;
pub mod yaml;
pub use quantity::{Dimension, Number, Quantity, QuantityError};

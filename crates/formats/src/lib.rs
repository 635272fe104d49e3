//! Input files: quantities with units, YAML with positions, schemas.
//!
//! | module | answers |
//! |---|---|
//! | [`document`] | what a YAML file says, and at which line and column |
//! | [`range`] | what `12..40` means |
//! | [`wanted_ratio`] | what `4.714±0.5%` and `(-3.295)` mean in a list of ratios |
//! | [`drive`] | what a drive file asks for |
//! | [`motor`] | what a motor file asks for |
//! | [`scenario`] | what is simulated: a gearbox with masses, torques, shifts |
//! | [`yaml`] | values without positions |
//! | [`gearbox`] | gearboxes as files: our format, and lists of real transmissions |
//!
//! Every [`Error`] names file, line, column, the path of the field, what is wrong and what is
//! allowed; its [`name`](Error::name) does not change. A [`Quantity`](epicyclic_units::Quantity)
//! derives its JSON Schema like any field of a [`schemars::JsonSchema`] type.
//!
//! ```
//! use epicyclic_formats::Document;
//! use epicyclic_units::{Number, Quantity};
//! use serde::Deserialize;
//! use uom::si::f64::Power;
//!
//! #[derive(Deserialize)]
//! #[serde(deny_unknown_fields)]
//! struct Drive {
//!     ratio: Number,
//!     power: Quantity<Power>,
//! }
//!
//! let drive: Drive = Document::parse_one("drive.yaml", b"ratio: 3.94\npower: 75kW\n")?.read()?;
//! assert_eq!((drive.ratio.get(), drive.power.to_string()), (3.94, "75 kW".to_owned()));
//!
//! let error = Document::parse_one("drive.yaml", b"ratio: 3,94\npower: 75kW\n")?.read::<Drive>().err().unwrap();
//! assert_eq!(error.to_string(), "drive.yaml:1:8: ratio: 3,94: decimal comma; write 3.94");
//! # Ok::<(), epicyclic_formats::Error>(())
//! ```
//!
//! Not understood by the reader: `flatten`, `untagged` and tagged enums. They read through a buffer of
//! `serde`'s in which positions, and the names of quantity errors, are lost.

pub mod document;
pub mod drive;
mod error;
mod faults;
mod file_kind;
pub mod gearbox;
mod module;
pub mod motor;
pub mod range;
pub mod scenario;
pub mod wanted_ratio;
pub mod yaml;

pub use document::{Document, Path, Position};
pub use error::{Error, Fault, Place, Problem, nearest};
pub use faults::Faults;
pub use file_kind::FileKind;
pub use range::{RangeError, Span};
pub use wanted_ratio::WantedRatio;

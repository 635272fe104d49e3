//! The commands of the program, one folder each: request, answer, tables, page.
//!
//! | file of a command | holds |
//! |---|---|
//! | `request.rs` | what is asked: the options, and their checks |
//! | `answer.rs` | the records, SI numbers with the unit in the key, and the calculation that fills them |
//! | `table.rs` | tables and CSV of the records |
//! | `page.rs` | a page, or chapters of one |
//!
//! | command | answers |
//! |---|---|
//! | [`analyze`] | every gear of any planetary gearbox |
//! | [`compare`] | gearboxes side by side |
//! | [`design`] | from speeds and power to a gearbox whose sizes hold |
//! | [`draw`] | schemes, speed diagrams, lever diagrams and ratio ladders as SVG and DXF |
//! | [`drive`] | a whole planetary drive from a file |
//! | [`losses`] | what heats a gearbox at work, and its efficiency over speed and torque |
//! | [`machine`] | speeds of mining machines |
//! | [`motor`] | a hydromotor and its drawings, and searches for one |
//! | [`report`] | a page about a file |
//! | [`schemes`] | the catalogue of two and three speeds |
//! | [`select`] | the gearbox for given speeds |
//! | [`sheet`] | data sheets of gears |
//! | [`simulate`] | a gearbox in motion, by a scenario |
//! | [`size`] | sizes of sets that hold over a duty |
//! | [`strength`] | safeties of teeth by ISO 6336 |
//! | [`synthesize`] | every gearbox that has a list of ratios |
//! | [`teeth`] | tooth numbers for a ratio |
//! | [`vibrate`] | natural frequencies, modes and resonances of sets |
//! | `atlas` | all gearboxes of two and three sets as Parquet tables, with the feature `tables` |
//!
//! | asked by the app and by other languages | answers |
//! |---|---|
//! | [`adjust`] | the numbers of a file that can be changed while one looks on |
//! | [`front`] | the sets of a gearbox seen from the front, as they turn in a gear |
//! | [`sweep`] | states, ratios and efficiencies of a gearbox for many basic ratios, as columns |
//!
//! | what all commands have in common | is |
//! |---|---|
//! | [`answer`] | version, JSON, JSON Schema; [`finite`]: every number of an answer is one |
//! | [`table`], [`page`] | tables, CSV; pages |
//! | [`error`], [`refusal`], [`refused`], [`failure`] | refusals, what they are about, exit codes |
//! | [`desk`] | surroundings of a call; [`input`]: files that are read |
//! | [`output`] | formats of an answer, and where it goes; [`drawing_file`]: SVG, DXF, PDF, PNG |
//! | [`progress`] | how far a long search is |
//! | [`words`] | requests of a library from the words of a command line |
//! | [`shared`] | what several commands share |
//!
//! Choices are enums, lists are lists, missing values are `null`: no text has to be parsed.
//!
//! # Stability
//! [`answer::SCHEMA_VERSION`] is raised when a key goes or changes meaning or unit; a new key does
//! not raise it.
//!
//! # Example
//! ```
//! use epicyclic_commands::{answer::to_json, shared::records::Fraction, teeth::Request, words::request};
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let request = Request { limit: Some(1), ..request(["--ratio", "6"])? };
//! let found = request.answer(|_| std::ops::ControlFlow::Continue(()))?;
//! assert_eq!(found.tooth_numbers[0].exact_ratio, Fraction { numerator: 6, denominator: 1 });
//! assert!(to_json(&found)?.starts_with("{\n  \"schema_version\": 1,\n  \"answer\": \"teeth\""));
//! # Ok(())
//! # }
//! ```

pub mod adjust;
pub mod analyze;
pub mod answer;
#[cfg(feature = "tables")]
pub mod atlas;
pub mod compare;
pub mod design;
pub mod desk;
pub mod draw;
pub mod drawing_file;
pub mod drive;
pub mod error;
pub mod failure;
pub mod finite;
pub mod front;
pub mod init;
pub mod input;
pub mod losses;
pub mod machine;
pub mod motor;
pub mod output;
pub mod page;
pub mod progress;
pub mod refusal;
pub mod refused;
pub mod report;
pub mod schemes;
pub mod select;
pub mod shared;
pub mod sheet;
pub mod simulate;
pub mod size;
pub mod strength;
pub mod sweep;
pub mod synthesize;
pub mod table;
pub mod teeth;
pub(crate) mod tolerance;
pub mod vibrate;
pub mod words;

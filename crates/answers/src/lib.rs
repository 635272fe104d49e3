//! What the program answers, as data: one record an answer, numbers in SI units that stand in the names.
//!
//! Tables, CSV and pages are views of these records; the program in Python or in a browser takes the records
//! themselves. Nothing is said here in words that a reader would have to take apart again: choices are enums, lists are
//! lists, and what there is not is `null`.
//!
//! | module | answers |
//! |---|---|
//! | [`adjust`] | the numbers of a file that can be changed while one looks on |
//! | [`gearbox`] | reads the gearbox of a file |
//! | [`analyze`] | what a gearbox does in its gears |
//! | [`front`] | the sets of a gearbox seen from the front, as they turn in a gear |
//! | [`losses`] | what a gearbox loses at work, mesh by mesh and drag by drag |
//! | [`compare`] | gearboxes side by side |
//! | [`sweep`] | states, ratios and efficiencies of a gearbox for many basic ratios, as columns |
//! | [`transmissions`] | the transmissions of a file to choose from |
//! | [`drive`] | a planetary drive from power, speed and ratio to its starting time |
//! | [`motor`] | a planetary hydromotor |
//! | [`motor_forms`] | hydromotors with their tooth forms for a displacement or torque |
//! | [`motor_search`] | hydromotors for a displacement or torque |
//! | [`teeth`] | tooth numbers of a simple set for a ratio |
//! | [`select`] | gearboxes for two or three speeds, of the catalogue or with all tooth numbers |
//! | [`design`] | a gearbox from speeds and power to sizes that hold |
//! | [`schemes`] | the catalogue of two- and three-speed schemes, or one scheme with its numbers |
//! | [`catalogue`] | links, gears and shift elements of the catalogue's gearboxes |
//! | [`machine`] | speeds of mining machines: in service, needed, and the ratios that give them |
//! | [`draw`] | a drawing: what it shows, its size, its files, and why there is none |
//! | [`drawability`] | parts of a gearbox that cannot be drawn together |
//! | [`report`] | the record behind a page about a gearbox, a drive or a hydromotor |
//! | [`strength`] | the strength of teeth: stresses, safeties, damage over a duty |
//! | [`sheet`] | data sheets of gears: circles, thickness, measures, meshes |
//! | [`simulate`] | a gearbox in motion: shifts, starts, heat of shift elements |
//! | [`vibration`] | natural frequencies and modes of sets, their excitation and resonances |
//! | [`size`] | modules, face widths, planets, centre distances and bearings of simple sets that hold over a duty |
//! | [`shared`] | records that several answers share |
//! | [`number`] | numbers of an answer |
//! | [`answer`] | what all answers have in common: version, JSON, JSON Schema |
//! | [`finite`] | that every number of an answer is one |
//! | [`error`], [`refusal`] | what is refused, and what a refusal speaks of |
//!
//! # Stability
//! [`SCHEMA_VERSION`] is raised whenever a key goes, or changes its meaning or unit. A new key does not raise it.
//!
//! # Example
//! ```
//! use epicyclic_answers::{answer::to_json, shared::Fraction, teeth};
//! use epicyclic_gears::{simple_set::{Member, Mode}, synthesis::Bounds};
//! # fn main() -> Result<(), epicyclic_answers::Error> {
//! let mode = Mode::new(Member::Sun, Member::Carrier)?;
//! let wanted = teeth::Wanted { ratio: 6.0, mode, tolerance: 0.01, bounds: Bounds::default(), most: 1, checked: 1 };
//! let found = teeth::answer(&wanted, |_| std::ops::ControlFlow::Continue(()))?;
//! assert_eq!(found.tooth_numbers[0].exact_ratio, Fraction { numerator: 6, denominator: 1 });
//! assert!(to_json(&found)?.starts_with("{\n  \"schema_version\": 1,\n  \"answer\": \"teeth\""));
//! # Ok(())
//! # }
//! ```

pub mod adjust;
pub mod analyze;
pub mod answer;
pub mod catalogue;
pub mod compare;
pub mod design;
pub mod draw;
pub mod drawability;
pub mod drive;
pub mod error;
mod fault;
pub mod finite;
pub mod front;
pub mod gearbox;
pub mod losses;
pub mod machine;
pub mod motor;
mod motor_designs;
pub mod motor_forms;
pub mod motor_search;
mod named;
pub mod number;
pub mod refusal;
pub mod refused;
pub mod report;
mod saved;
pub mod schemes;
pub mod select;
pub mod shared;
pub mod sheet;
pub mod simulate;
pub mod size;
pub mod strength;
pub mod sweep;
pub mod synthesize;
pub mod teeth;
mod tolerance;
pub mod tool;
pub mod tooth_checks;
mod toothed;
pub mod transmissions;
pub mod vibration;

pub use answer::{Answer, SCHEMA_VERSION, Warning};
pub use error::Error;

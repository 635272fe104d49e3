//! Pages about one gearbox, drive, motor or search, made from answers and pictures.
//!
//! | module | is the page of |
//! |---|---|
//! | [`gearbox`] | a gearbox: all gears, each gear in full, and what another `k` would change |
//! | [`drive`] | a planetary drive |
//! | [`scenario`] | a scenario: a gearbox in motion |
//! | [`motor`] | a hydromotor |
//! | [`selection`] | the choice of a gearbox |
//! | [`synthesis`] | a search for gearboxes |
//! | [`compare`] | gearboxes side by side |
//! | [`sheet`] | any of them: the answer, chapters of answers, pictures and words, the input |
//! | `strength` | the strength of teeth on the page of a gearbox |
//! | `vibration` | the vibration of planet sets on the page of a gearbox |
//! | `side_by_side` | the figures of all gears of a gearbox, a column for each |
//! | [`imprint`] | what a page says of itself |

pub mod compare;
pub mod design;
pub mod drive;
pub mod gearbox;
pub mod imprint;
pub mod motor;
pub(crate) mod paper;
pub mod scenario;
pub mod selection;
pub mod sheet;
mod side_by_side;
mod strength;
pub mod synthesis;
mod vibration;

pub use imprint::{Imprint, Paper};
pub use sheet::{Block, Section, Sheet};

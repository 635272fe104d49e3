//! Pages about one gearbox, drive, motor or search, made from answers and pictures.
//!
//! | module | is the page of |
//! |---|---|
//! | [`gearbox`] | a gearbox: all gears, each gear in full, and what another `k` would change |
//! | [`drive`] | a planetary drive |
//! | [`motor`] | a hydromotor |
//! | [`synthesis`] | a search for gearboxes |
//! | [`compare`] | gearboxes side by side |
//! | [`sheet`] | any of them: sections of answers, pictures and words |

pub mod compare;
pub mod drive;
pub mod gearbox;
pub mod motor;
pub mod sheet;
pub mod synthesis;

pub use sheet::{Block, Section, Sheet};

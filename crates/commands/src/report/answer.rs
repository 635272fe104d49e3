//! Record for a page about a gearbox, a drive or a hydromotor: its file, and the answers of its chapters.
//!
//! | module | is the chapters of |
//! |---|---|
//! | [`gearbox`] | a gearbox: all gears, each gear in full, and what another `k` would change |
//! | [`drive`] | a planetary drive |
//! | [`motor`] | a hydromotor |
//! | [`sizes`] | a gearbox: sizes and least safeties of its sets |

pub mod drive;
pub mod gearbox;
pub mod motor;
pub mod sizes;

use crate::answer::Answer;
use schemars::JsonSchema;
use serde::Serialize;

/// Contents of a page about a file.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Report {
    /// Text of the file as it was written.
    pub file: String,
    /// Subject of the file; its single key says whether it is a gearbox, a drive, a scenario or a hydromotor.
    pub about: About,
}

/// Subjects of a file.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum About {
    /// Gearbox with its chapters.
    Gearbox(Box<gearbox::GearboxReport>),
    /// Planetary drive with its chapters.
    Drive(Box<drive::DriveReport>),
    /// Gearbox in motion.
    Scenario(Box<crate::simulate::answer::Simulation>),
    /// Hydromotor with its chapters.
    Motor(Box<motor::MotorReport>),
}

impl Answer for Report {
    const NAME: &'static str = "report";
}

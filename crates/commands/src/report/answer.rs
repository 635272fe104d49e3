//! The record behind a page about a gearbox, a drive or a hydromotor: its file, and its chapters' answers.
//!
//! | module | is the chapters of |
//! |---|---|
//! | [`gearbox`] | a gearbox: all gears, each gear in full, and what another `k` would change |
//! | [`drive`] | a planetary drive |
//! | [`motor`] | a hydromotor |

pub mod drive;
pub mod gearbox;
pub mod motor;

use crate::answer::Answer;
use schemars::JsonSchema;
use serde::Serialize;

/// What a page about a file says.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Report {
    /// The file as it was written.
    pub file: String,
    /// What it describes: the one key here says whether a gearbox, a drive, a scenario or a hydromotor.
    pub about: About,
}

/// What a file describes.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum About {
    /// A gearbox.
    Gearbox(Box<gearbox::GearboxReport>),
    /// A planetary drive.
    Drive(Box<drive::DriveReport>),
    /// A gearbox in motion.
    Scenario(Box<crate::simulate::answer::Simulation>),
    /// A hydromotor.
    Motor(Box<motor::MotorReport>),
}

impl Answer for Report {
    const NAME: &'static str = "report";
}

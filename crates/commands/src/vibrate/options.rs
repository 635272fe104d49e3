//! Request for the vibration of a gearbox.

use crate::shared::exciting::Exciting;

/// Request for the vibration of a gearbox.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct Request {
    /// One gear; all without.
    #[arg(long, value_name = "NAME")]
    pub gear: Option<String>,

    /// One set; all without.
    #[arg(long, value_name = "NAME")]
    pub set: Option<String>,

    /// Excitation and its speeds; the file may state those that are not given.
    #[command(flatten)]
    pub exciting: Exciting,
}

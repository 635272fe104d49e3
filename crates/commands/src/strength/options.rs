//! Request for the strength of teeth.

use crate::shared::load::Load;

/// Request for the strength of teeth, at a load or over the duty of the file.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct Request {
    /// One gear at the load; all without.
    #[arg(long, value_name = "NAME")]
    pub gear: Option<String>,

    /// The factors of each mesh, with where each comes from; over a duty the least and greatest of its steps.
    #[arg(long)]
    pub factors: bool,

    /// Speed and load of the input; without a load the duty of the file is used.
    #[command(flatten)]
    pub load: Load,
}

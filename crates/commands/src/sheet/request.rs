//! The command `sheet`: data sheets of gears.

use crate::desk::Call;
use crate::error::Error;
use crate::failure::Failure;
use crate::input;
use crate::output::OutputArgs;
use crate::shared::gearbox_choice::refuse;
use crate::sheet::answer as answers;
use std::path::PathBuf;

/// Data sheets of the gears of simple sets: circles, tooth thickness, measures, meshes.
///
/// Names and signs are those of ISO 21771. A set needs its teeth and its module; profile shifts, allowances
/// and what else the file states are used. Sets that are not simple or lack data are named with what is
/// missing.
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    /// The file, in YAML, or - for standard input.
    #[arg(value_name = "FILE", value_hint = clap::ValueHint::FilePath)]
    file: PathBuf,

    /// One set; all without.
    #[arg(long, value_name = "NAME")]
    set: Option<String>,

    #[command(flatten)]
    output: OutputArgs,
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let document = input::document(call, &args.file)?;
    let subject = answers::subject(&document)?;
    let answer = answers::answer(&subject, args.set.as_deref()).map_err(|error| match error {
        Error::NoSet { .. } => Failure::of_option("--set", &error),
        error => refuse(error),
    })?;
    args.output.deliver(call, &answer)
}

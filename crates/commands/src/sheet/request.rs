//! The command `sheet`: data sheets of gears.

use crate::desk::Call;
use crate::error::Error;
use crate::failure::Failure;
use crate::input;
use crate::output::OutputArgs;
use crate::shared::gearbox::{Gearbox, alone};
use crate::shared::gearbox_choice::refuse;
use crate::sheet::answer::{self as answers, DataSheets};
use std::path::PathBuf;

/// Data sheets of the gears of a gearbox: circles, tooth thickness, measures, meshes.
///
/// Names and signs are those of ISO 21771. A set needs its teeth and its module; profile shifts, allowances
/// and what else the file states are used. Sets that lack data are named with what is missing.
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    /// The file, in YAML, or - for standard input.
    #[arg(value_name = "FILE", value_hint = clap::ValueHint::FilePath)]
    file: PathBuf,

    #[command(flatten)]
    request: Request,

    #[command(flatten)]
    output: OutputArgs,
}

/// Request for data sheets of gears.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct Request {
    /// One set; all without.
    #[arg(long, value_name = "NAME")]
    pub set: Option<String>,
}

impl Request {
    /// Computes the data sheets of all sets, or of one.
    ///
    /// # Errors
    /// - [`Failure::Option`] for a set that the gearbox does not have.
    /// - [`Failure::Answer`] if no set has enough data, or with the place of invalid data in the file.
    pub fn answer(&self, gearbox: &Gearbox) -> Result<DataSheets, Failure> {
        answers::answer(gearbox, self.set.as_deref()).map_err(|error| match error {
            Error::NoSet { .. } => Failure::of_option("--set", &error),
            error => refuse(error),
        })
    }
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let Args { file, request, output } = args;
    let gearbox = alone(&input::document(call, file)?, "sheet", "no modules")?;
    output.deliver(call, &request.answer(&gearbox)?)
}

//! The command `strength`: safeties of teeth by ISO 6336.

use crate::desk::Call;
use crate::error::Error;
use crate::failure::Failure;
use crate::input;
use crate::output::OutputArgs;
use crate::shared::{gearbox_choice::refuse, load::Load};
use crate::strength::answer::{self as answers, Wanted};
use std::path::PathBuf;

/// Strength of the teeth of simple sets by ISO 6336, method B: safeties of flanks and roots.
///
/// With --torque or --power and --speed the stresses, limits and safeties in each gear at this load for the
/// required life; without them damage, safety and life over the duty of the file, by Miner's rule. Torques
/// are those without losses; their direction does not matter. Sets that are not simple or lack data are named
/// with what is missing.
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    /// The file, in YAML, or - for standard input.
    #[arg(value_name = "FILE", value_hint = clap::ValueHint::FilePath)]
    file: PathBuf,

    /// One gear at the load; all without.
    #[arg(long, value_name = "NAME")]
    gear: Option<String>,

    /// The factors of each mesh, with where each comes from; over a duty the least and greatest of its steps.
    #[arg(long)]
    factors: bool,

    #[command(flatten)]
    load: Load,

    #[command(flatten)]
    output: OutputArgs,
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let document = input::document(call, &args.file)?;
    let subject = answers::subject(&document)?;
    let wanted = Wanted { gear: args.gear.clone(), input: args.load.input(), with_factors: args.factors };
    args.output.deliver(call, &answers::answer(&subject, &wanted).map_err(|error| refuse_of(error, args))?)
}

/// Converts an error to a failure with the option that caused it.
fn refuse_of(error: Error, args: &Args) -> Failure {
    let option = match &error {
        Error::NoLoad => "--torque",
        Error::LoadWithoutSpeed => "--speed",
        Error::OfOnePoint if args.gear.is_some() => "--gear",
        Error::OfOnePoint => "--speed",
        _ => return refuse(error),
    };
    Failure::of_option(option, &error)
}

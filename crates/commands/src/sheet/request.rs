//! The command `sheet`: data sheets of gears.

use crate::analyze::request::refuse;
use crate::desk::Call;
use crate::error::Error;
use crate::failure::Failure;
use crate::input;
use crate::output::OutputArgs;
use crate::sheet::answer as answers;
use std::path::PathBuf;

/// Data sheets of the gears of simple sets: circles, tooth thickness, measures, meshes.
///
/// Names and signs are those of ISO 21771. A set needs its teeth and its module; profile shifts, allowances and what else the file states are used. Sets
/// that are not simple or lack data are named with what is missing.
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Example:
  printf 'gearbox: hoist\\ninput: s\\noutput: h\\nsets:\\n' > hoist.yaml
  printf '  - id: P\\n    sun: s\\n    ring: r\\n    carrier: h\\n' >> hoist.yaml
  printf '    teeth: [24, 84]\\n    planet_teeth: [30]\\n' >> hoist.yaml
  printf '    module: 3 mm\\n' >> hoist.yaml
  printf 'brakes: [{ id: B, link: r }]\\ngears: [{ name: \"1\", ' >> hoist.yaml
  printf 'engaged: [B] }]\\n' >> hoist.yaml
  epicyclic sheet hoist.yaml
  epicyclic sheet hoist.yaml --set P -o sheet.csv

Keys of the file beyond those of `epicyclic analyze`:
  sets: data_sheet: ball_diameters, thickness_allowances (of sun, planets,
        ring), centre_distance_deviations; strength: materials, shaper")]
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
        Error::NoSet { .. } => Failure::Option { option: "--set", message: error.to_string() },
        error => refuse(error),
    })?;
    args.output.deliver(call, &answer)
}

//! The command `schema`: JSON Schemas of the files that the program reads and of the answers that it gives.

use crate::failure::Failure;
use crate::output::{self, Target};
use epicyclic_answers::answer::schema;
use epicyclic_answers::drive::Drive;
use epicyclic_answers::motor::Motor;
use epicyclic_answers::motor_search::MotorSearch;
use epicyclic_answers::teeth::Teeth;
use epicyclic_formats::drive::DriveFile;
use epicyclic_formats::gearbox::{GearboxFile, TransmissionsFile};
use epicyclic_formats::motor::MotorFile;
use schemars::schema_for;

/// The JSON Schema of a file that the program reads, or of an answer in JSON.
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Example:
  epicyclic schema gearbox -o gearbox.schema.json

With the YAML language server a first line `# yaml-language-server:
$schema=gearbox.schema.json` then completes and checks the file.")]
pub(crate) struct Args {
    /// Which file or answer.
    #[arg(value_enum)]
    of: Of,

    #[command(flatten)]
    target: Target,
}

/// The files, then the answers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Of {
    /// Of `epicyclic drive`.
    Drive,
    /// Of `epicyclic analyze`: a gearbox.
    Gearbox,
    /// Of `epicyclic analyze`: transmissions with published ratios.
    Transmissions,
    /// Of `epicyclic report`: a hydromotor.
    Motor,
    /// The answer of `epicyclic drive`.
    AnswerDrive,
    /// The answer of `epicyclic motor`.
    AnswerMotor,
    /// The answer of `epicyclic motor search`.
    AnswerMotorSearch,
    /// The answer of `epicyclic teeth`.
    AnswerTeeth,
}

/// Runs the command.
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let schema = match args.of {
        Of::Drive => schema_for!(DriveFile),
        Of::Gearbox => schema_for!(GearboxFile),
        Of::Transmissions => schema_for!(TransmissionsFile),
        Of::Motor => schema_for!(MotorFile),
        Of::AnswerDrive => schema::<Drive>(),
        Of::AnswerMotor => schema::<Motor>(),
        Of::AnswerMotorSearch => schema::<MotorSearch>(),
        Of::AnswerTeeth => schema::<Teeth>(),
    };
    args.target.write(output::json(&schema)?.as_bytes())
}

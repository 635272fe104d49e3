//! The command `drive`: a planetary drive from its file to its starting time.

use crate::desk::Call;
use crate::drive::answer::of_file;
use crate::failure::Failure;
use crate::input;
use crate::output::OutputArgs;
use crate::report::answer::drive::DriveReport;
use crate::shared::page_options::PageArgs;
use std::path::PathBuf;

/// A planetary drive from power, speed and ratio to its starting time.
///
/// Chooses the teeth (or takes those given), then calculates speeds, torques, diameters, shafts with their
/// bearings, masses, inertias, forces, the equivalent inertia referred to the sun's shaft, and how the drive
/// starts. The sun drives, the ring is fixed, the load is on the carrier. Warnings are part of the answer;
/// with --output they are shown here too. In a file whose name ends in .html the answer is a page, with
/// drawing and plots.
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    /// The file that describes the drive, in YAML; - for standard input.
    #[arg(value_name = "FILE")]
    file: PathBuf,

    #[command(flatten)]
    output: OutputArgs,

    #[command(flatten)]
    page: PageArgs,
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    args.page.only_of_a_page(args.output.is_page())?;
    let (document, bytes) = input::with_bytes(call, &args.file)?;
    let drive = of_file(&document)?;
    if !args.output.is_page() {
        return args.output.deliver(call, &drive);
    }
    let report = DriveReport::of(drive);
    let sheet = crate::drive::page::sheet(&report, String::from_utf8_lossy(&bytes).into_owned());
    args.output.deliver_page(call, vec![], &report.drive, sheet, &args.page.imprint())
}

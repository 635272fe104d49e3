//! The command `init`: a commented file to start from.

use crate::desk::Call;
use crate::failure::Failure;
use crate::output::Target;

/// A commented file to start from: a gearbox, a drive, a hydromotor, or a gearbox in motion.
///
/// The first lines name the commands that read it; each works at once. Put your values in place of those of
/// the file.
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    /// Subject of the file.
    #[arg(value_enum)]
    kind: Kind,

    /// Write over a file that exists. Default: such a file is kept, and the command refuses.
    #[arg(long)]
    replace: bool,

    #[command(flatten)]
    target: Target,
}

/// Kinds of files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Kind {
    /// A gearbox of two speeds with its teeth, materials and duty.
    Gearbox,
    /// A planetary drive from its power and ratio.
    Drive,
    /// A hydromotor of non-circular gears.
    Motor,
    /// A gearbox in motion: torques, inertias, a shift.
    Scenario,
}

impl Kind {
    const fn text(self) -> &'static str {
        match self {
            Self::Gearbox => include_str!("gearbox.yaml"),
            Self::Drive => include_str!("drive.yaml"),
            Self::Motor => include_str!("motor.yaml"),
            Self::Scenario => include_str!("scenario.yaml"),
        }
    }
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    if let Some(file) = args.target.file().filter(|file| !args.replace && call.desk.exists(file)) {
        let message =
            format!("{} exists; name another file, or write over it with --replace", file.display());
        return Err(Failure::named("file-exists", "--output", message));
    }
    args.target.write(call, args.kind.text().as_bytes())
}

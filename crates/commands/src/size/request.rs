//! The command `size`: modules, face widths, planets, centre distances and bearings of each set.

use crate::desk::Call;
use crate::error::Error;
use crate::failure::Failure;
use crate::input;
use crate::output::OutputArgs;
use crate::shared::gearbox::{Gearbox, alone};
use crate::shared::gearbox_choice as analyze;
use crate::shared::options;
use crate::size::answer::{Size, answer, saved};
use crate::size::options::Request;
use epicyclic_strength::Quantity as Of;
use epicyclic_strength::sizing::bearing::{Bearing, parse};
use std::ops::ControlFlow;
use std::path::PathBuf;

/// Sizes of the sets of a gearbox that hold over the duty of its file, with the least mass or ring.
///
/// Complete over the stated modules, face widths, numbers of planets, centre distances and bearings; gears in
/// mesh have one module and width, shifts follow from the centre distance and the aim. Each design must have
/// faultless gears, the required safeties of flanks and roots by ISO 6336 and bearings that live as long as
/// required. What the file gives of a set is held: module, face_width, planets, profile_shifts, planet_bore,
/// load_rating, ring_rim.
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    /// The file, in YAML, or - for standard input: what strength reads, but sizes may be missing in its sets.
    #[arg(value_name = "FILE", value_hint = clap::ValueHint::FilePath)]
    file: PathBuf,

    #[command(flatten)]
    request: Request,

    #[command(flatten)]
    bearings: BearingsFile,

    /// Write the file with the best design of each set, which strength, analyze, draw and report read.
    #[arg(long, value_name = "FILE")]
    save: Option<PathBuf>,

    #[command(flatten)]
    output: OutputArgs,
}

/// File of the bearings to choose from.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Sizes")]
pub struct BearingsFile {
    /// Bearings of the planets, as CSV with the columns designation, rolling (balls, rollers, needles,
    /// full_complement), d_mm, D_mm, B_mm, C_kN, C0_kN. Default: a table, by --bearing-type.
    #[arg(long, value_name = "FILE", value_hint = clap::ValueHint::FilePath)]
    bearings: Option<PathBuf>,
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let document = input::document(call, &args.file)?;
    let gearbox = alone(&document, "size", "no teeth, materials or loads")?;
    let request = Request { bearings: args.bearings.read(call)?, ..args.request.clone() };
    let size = request.answer(&gearbox, &|| call.goes_on())?;
    let without = size.sets.iter().find(|set| set.found.is_empty());
    let files = match (&args.save, without) {
        (Some(file), None) => {
            let completed = request.completed(&gearbox)?;
            let document = completed.as_ref().map_or(&document, |(completed, _)| &completed.document);
            vec![(file.clone(), saved(document, &size)?.into_bytes())]
        }
        _ => vec![],
    };
    args.output.deliver_with(call, files, &size)?;
    match without {
        None => Ok(()),
        Some(set) => Err(Failure::NothingFound(Error::NoSize { set: set.set.clone() }.to_string())),
    }
}

impl Request {
    /// Sizes the sets of a gearbox. The closure is called now and then, and may end the calculation.
    ///
    /// # Errors
    /// [`Failure::Option`] for an empty space and impossible limits, [`Failure::Answer`] if no set can be
    /// sized, or with the place of missing or invalid data in the file.
    pub fn answer(&self, gearbox: &Gearbox, goes_on: &dyn Fn() -> ControlFlow<()>) -> Result<Size, Failure> {
        let mut size = answer(gearbox, self, goes_on).map_err(refuse)?;
        let not_used = self.application.and_then(|of| of.not_used(gearbox.document.value(), "the file"));
        size.warnings.extend(not_used);
        Ok(size)
    }
}

impl BearingsFile {
    /// Bearings of the file; `None` without one.
    pub(crate) fn read(&self, call: &Call<'_>) -> Result<Option<Vec<Bearing>>, Failure> {
        let Some(file) = &self.bearings else { return Ok(None) };
        parse(&input::text(call, file)?).map(Some).map_err(|error| refuse(error.into()))
    }
}

/// Converts an error to a failure with the option that caused it.
pub(crate) fn refuse(error: Error) -> Failure {
    use epicyclic_strength::Error as E;
    let option = match &error {
        Error::Gear(gear) => options::of_teeth(gear, "--planets"),
        Error::Sizing(
            E::NotPositive { quantity, .. } | E::Negative { quantity, .. } | E::NothingToSearch { quantity },
        ) => match quantity {
            Of::Module => Some("--modules"),
            Of::FaceWidth => Some("--face-widths"),
            Of::Planets => Some("--planets"),
            Of::CentreDistanceStep | Of::CentreDistance => Some("--centre-distance-step"),
            Of::WidthRatio => Some("--width-ratio"),
            Of::LeastRim => Some("--planet-rim"),
            Of::RingRimInModules => Some("--ring-rim"),
            Of::LargestRing => Some("--max-ring"),
            _ => None,
        },
        Error::Sizing(E::OneBearingRow) => Some("--bearing-rows"),
        Error::Sizing(E::SpaceTooLarge { .. }) => Some("--centre-distance-step"),
        Error::Sizing(E::BearingColumn { .. } | E::BearingCell { .. } | E::NoBearings) => Some("--bearings"),
        _ => None,
    };
    match option {
        Some(option) => Failure::of_option(option, &error),
        None => analyze::refuse(error),
    }
}

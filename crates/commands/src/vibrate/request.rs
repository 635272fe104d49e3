//! The command `vibrate`: natural frequencies, modes and resonances of planet sets.

use crate::desk::{Call, Content};
use crate::drawing_file;
use crate::error::Error;
use crate::failure::Failure;
use crate::input;
use crate::output::OutputArgs;
use crate::shared::exciting::Exciting;
use crate::shared::gearbox::{Gearbox, alone};
use crate::vibrate::answer::{self as answers, Vibration};
use crate::vibrate::options::Request;
use crate::vibrate::table as views;
use epicyclic_drawing::Scene;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// Natural frequencies and modes of gear sets, and the speeds at which they resonate.
///
/// Each set is a planar model: central gears, carrier and planets on springs, as of Lin and Parker. With
/// --speeds also what excites it in each gear, which modes the phases of the planets let it excite, and the
/// speeds of the input at which it meets them; with --transmission-error the forces in the meshes. Torsional
/// modes are of the whole gearbox, and with --coupled also its modes in the plane.
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    /// The file, in YAML, or - for standard input.
    #[arg(value_name = "FILE", value_hint = clap::ValueHint::FilePath)]
    file: PathBuf,

    #[command(flatten)]
    request: Request,

    /// File for a picture of the forces by the transmission error of one set in one gear over the speed, as
    /// for --campbell.
    #[arg(long, value_name = "FILE")]
    response: Option<PathBuf>,

    /// File for a Campbell diagram of one set in one gear, by the end of its name: .dxf, .pdf, .png,
    /// otherwise SVG.
    #[arg(long, value_name = "FILE")]
    campbell: Option<PathBuf>,

    /// File for a Campbell diagram of the torsional modes of one gear, as for --campbell.
    #[arg(long, value_name = "FILE")]
    torsional_campbell: Option<PathBuf>,

    /// File for pictures of all modes of one set, seen along its axis, as for --campbell.
    #[arg(long, value_name = "FILE")]
    shapes: Option<PathBuf>,

    #[command(flatten)]
    output: OutputArgs,
}

impl Request {
    /// Computes the vibration. The closure is called now and then, and may end the calculation.
    ///
    /// # Errors
    /// - [`Failure::Option`] for an invalid option, alone or with the others and the file.
    /// - [`Failure::Answer`] if no set has enough data, or with the place of invalid data in the file.
    pub fn answer(
        &self,
        gearbox: &Gearbox,
        goes_on: &dyn Fn() -> ControlFlow<()>,
    ) -> Result<Vibration, Failure> {
        // Coupled modes are of the whole gearbox, so one set alone has none.
        if self.set.is_some() && self.exciting.coupled {
            return Err(Failure::conflict("--coupled", "it is of all sets; leave --set out"));
        }
        answers::answer(gearbox, self, goes_on).map_err(|error| match error {
            Error::NoSet { .. } => Failure::of_option("--set", &error),
            // Shared with `report`, which has these options but no `--set`.
            error => Exciting::refuse(error),
        })
    }
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let gearbox = alone(&input::document(call, &args.file)?, "vibrate", "no masses and no stiffness")?;
    let answer = args.request.answer(&gearbox, &|| call.goes_on())?;
    type Picture = fn(&Vibration, &'static str) -> Result<Scene, Failure>;
    let pictures: [(&Option<PathBuf>, &'static str, Picture); 4] = [
        (&args.campbell, "--campbell", campbell),
        (&args.torsional_campbell, "--torsional-campbell", torsional_campbell),
        (&args.response, "--response", response),
        (&args.shapes, "--shapes", shapes),
    ];
    let mut files = vec![];
    for (file, option, picture) in pictures {
        if let Some(file) = file {
            files.push(drawn(file, option, &picture(&answer, option)?)?);
        }
    }
    args.output.deliver_with(call, files, &answer)
}

/// A picture as a file.
fn drawn(file: &Path, option: &'static str, scene: &Scene) -> Result<Content, Failure> {
    let format = drawing_file::format_by_name(file, option)?;
    Ok((file.to_owned(), drawing_file::content(scene, format, None)?))
}

/// Refuses a picture of none.
fn none(option: &'static str, needs: &str) -> Failure {
    Failure::named("nothing-to-draw", option, format!("nothing to draw: it is of {needs}"))
}

/// Refuses a picture of several.
fn only(option: &'static str, by: &str, all: &[String]) -> Result<(), Failure> {
    if all.len() < 2 {
        return Ok(());
    }
    let message = format!("it is of one, by {by}; there are {}", all.join(", "));
    Err(Failure::invalid(option, message))
}

/// The Campbell diagram.
fn campbell(answer: &Vibration, option: &'static str) -> Result<Scene, Failure> {
    let all = answer.campbell.iter().map(|one| format!("set {} in gear {}", one.set, one.gear));
    only(option, "--set and --gear", &all.collect::<Vec<_>>())?;
    let picture = views::campbell(answer, 0)
        .ok_or_else(|| none(option, "a set with modes over speeds of the input"))?;
    Ok(picture.scene().map_err(epicyclic_pictures::Error::from)?)
}

/// The Campbell diagram of the torsional modes.
fn torsional_campbell(answer: &Vibration, option: &'static str) -> Result<Scene, Failure> {
    let all: Vec<String> = answer.torsional.iter().map(|one| format!("gear {}", one.gear)).collect();
    only(option, "--gear", &all)?;
    let picture = views::torsional_campbell(answer, 0)
        .ok_or_else(|| none(option, "a gearbox with torsional modes over speeds of the input"))?;
    Ok(picture.scene().map_err(epicyclic_pictures::Error::from)?)
}

/// The forces over the speed.
fn response(answer: &Vibration, option: &'static str) -> Result<Scene, Failure> {
    let all = answer.responses.iter().map(|one| format!("set {} in gear {}", one.set, one.gear));
    only(option, "--set and --gear", &all.collect::<Vec<_>>())?;
    let picture = views::response(answer, 0)
        .ok_or_else(|| none(option, "a set with modes, a transmission error and speeds of the input"))?;
    Ok(picture.scene().map_err(epicyclic_pictures::Error::from)?)
}

/// The modes along the axis.
fn shapes(answer: &Vibration, option: &'static str) -> Result<Scene, Failure> {
    let all = answer.sets.iter().map(|one| format!("set {} in gear {}", one.set, one.gears.join(" and ")));
    only(option, "--set and --gear", &all.collect::<Vec<_>>())?;
    let (title, modes) = views::shapes(answer, 0).ok_or_else(|| none(option, "a set with modes"))?;
    Ok(epicyclic_pictures::modes::scene(&title, &modes).map_err(epicyclic_pictures::Error::from)?)
}

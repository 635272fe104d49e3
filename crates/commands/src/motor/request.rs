//! The command `motor`: a planetary hydromotor from its numbers to its drawings, and two searches for one.

use crate::desk::Call;
use crate::failure::Failure;
use crate::input;
use crate::motor::answer::Designed;
use crate::motor::construction::answer::construction;
use crate::motor::forms::request as forms;
use crate::motor::options::{Files, Request, design, files};
use crate::motor::search::request as search;
use crate::motor::table::View;
use crate::output::OutputArgs;
use crate::report::answer as report;
use crate::shared::page_options::{self as imprint, PageArgs};
use epicyclic_formats::Path;
use std::path::PathBuf;

/// Options that describe a motor without a file.
const OF_A_MOTOR: [&str; 12] =
    ["stator", "rotor", "z3", "z1", "zs", "module", "place", "width", "pressure", "speed", "Teeth", "Made"];

/// A hydromotor with non-circular wheels and floating satellites: geometry that closes, working data, teeth,
/// drawings.
///
/// A ring with N arches (the stator) and a sun with n lobes (the rotor), N + n round satellites between them
/// that roll on both. Without --zs the satellites that the other numbers admit are listed. The numbers leave
/// one distance free: --l, --a or --part choose it. With both --l and --a the rotor need not close; the
/// answer is then the construction of the arcs. Torque and flow are theoretical; --oil, --gaps and
/// --friction add losses, --ports the ports as they are made. Module: 0.001 to 1000 mm; width: 0.001 to 10
/// 000 mm; l: at most 100 times the stator's nominal radius m·Z₃/2. A rotor that reaches into the stator is
/// refused.
#[derive(Debug, clap::Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
#[command(override_usage = "\
epicyclic motor [OPTIONS] <FILE>
       epicyclic motor [OPTIONS] --stator <N> --rotor <N> --z3 <TEETH>
           --module <MODULE> [--zs <TEETH>]
       epicyclic motor search [OPTIONS]
       epicyclic motor forms [OPTIONS]")]
#[command(group = clap::ArgGroup::new("numbers").args(["file", "stator"]).required(true))]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    #[command(subcommand)]
    command: Option<Command>,

    /// File of a motor in YAML, in place of the options that describe one; - for standard input.
    #[arg(value_name = "FILE", conflicts_with_all = OF_A_MOTOR)]
    file: Option<PathBuf>,

    #[command(flatten)]
    request: Request,

    #[command(flatten)]
    files: Files,

    #[command(flatten)]
    output: OutputArgs,

    #[command(flatten)]
    page: PageArgs,
}

#[derive(Debug, clap::Subcommand)]
enum Command {
    Search(Box<search::Args>),
    Forms(Box<forms::Args>),
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    match &args.command {
        Some(Command::Search(args)) => return search::run(call, args),
        Some(Command::Forms(args)) => return forms::run(call, args),
        None => {}
    }
    let Args { request, files, page, output, .. } = args;
    page.only_of_a_page(output.is_page())?;
    let drawings = files::wanted(files, output);
    drawings.check(files)?;
    let Some(file) = &args.file else {
        if request.zs.is_none() {
            return list_satellites(call, args);
        }
        if request.is_of_construction() {
            return construct(call, args, &drawings, None);
        }
        return deliver(call, args, &drawings, None, &request.designed()?, &design::refuse);
    };
    let document = input::document(call, file)?;
    let in_file = |failure: Failure| failure.in_file(&document, &Path::root());
    let (title, mut designed) =
        crate::motor::answer::of_file(&document).map_err(|error| in_file(error.into()))?;
    if request.is_of_construction() {
        return construct(call, args, &drawings, Some(&designed)).map_err(in_file);
    }
    if let Some(angle) = &request.angle {
        designed.angle = angle.0;
    }
    let refuse = |error| design::refuse_of_file(error, request.angle.is_some());
    deliver(call, args, &drawings, title, &designed, &refuse).map_err(in_file)
}

fn list_satellites(call: &Call<'_>, Args { request, files, output, .. }: &Args) -> Result<(), Failure> {
    let answer = request.satellites([
        ("--view", files.view.is_some()),
        ("--svg", files.svg.is_some()),
        ("--dxf", files.dxf.is_some()),
        ("--csv", files.csv.is_some()),
    ])?;
    output.deliver(call, &answer)?;
    match answer.motors.is_empty() {
        true => Err(Failure::NothingFound("no satellite gives a motor of these numbers".to_owned())),
        false => Ok(()),
    }
}

fn construct(
    call: &Call<'_>,
    Args { request, files, output, .. }: &Args,
    drawings: &files::Wanted,
    of_file: Option<&Designed>,
) -> Result<(), Failure> {
    let constructed = request.constructed(of_file, [("--csv", files.csv.is_some())])?;
    if files.view.is_some_and(|view| view != View::Construction) {
        let message = "the construction has the view construction alone; for another give one of --l and --a, and no \
                       --construction";
        return Err(Failure::invalid("--view", message));
    }
    let answer = construction(&constructed).map_err(design::refuse)?;
    let files = if drawings.is_empty() {
        vec![]
    } else {
        drawings.drawn(&crate::motor::table::construction(&constructed)?, files)?
    };
    output.but_for_drawings().deliver_with(call, files, &answer)
}

fn deliver(
    call: &Call<'_>,
    Args { files, page, output, .. }: &Args,
    drawings: &files::Wanted,
    title: Option<String>,
    designed: &Designed,
    refuse: &dyn Fn(crate::error::Error) -> Failure,
) -> Result<(), Failure> {
    let (files, output) = (files::content(files, drawings, designed, refuse)?, output.but_for_drawings());
    if output.is_page() {
        let report = report::motor::answer(title, designed).map_err(refuse)?;
        let sheet = crate::motor::page::sheet(&report, designed, imprint::command(call));
        return output.deliver_page(call, files, &report.motor, sheet, &page.imprint());
    }
    let answer = crate::motor::answer::answer(designed).map_err(refuse)?;
    output.deliver_with(call, files, &answer)
}

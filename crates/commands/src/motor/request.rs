//! The command `motor`: a planetary hydromotor from its numbers to its drawings, and two searches for one.

use crate::desk::Call;

use crate::failure::Failure;
use crate::input;
use crate::motor::answer::Designed;
use crate::motor::construction::request as construction;
use crate::motor::forms::request as forms;
use crate::motor::satellites::request as satellites;
use crate::motor::search::request as search;
use crate::report::answer as report;
use crate::shared::page_options::{self as imprint};
use epicyclic_formats::Path;

use crate::motor::options::{Design, design, files};
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
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    #[command(subcommand)]
    command: Option<Command>,

    #[command(flatten)]
    design: Design,
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
    let Design { files, page: options, output, .. } = &args.design;
    options.only_of_a_page(output.is_page())?;
    let wanted = files::wanted(files, output);
    wanted.check(files)?;
    let Some(file) = &args.design.file else {
        if args.design.zs.is_none() {
            return satellites::run(call, &args.design);
        }
        if construction::is_asked(&args.design) {
            return construction::run(call, &args.design, &wanted, None);
        }
        let designed = design::read(&args.design)?;
        return deliver(call, &args.design, &wanted, None, &designed, &design::refuse);
    };
    let document = input::document(call, file)?;
    let in_file = |failure: Failure| failure.in_file(&document, &Path::root());
    let (title, mut designed) =
        crate::motor::answer::of_file(&document).map_err(|error| in_file(error.into()))?;
    if construction::is_asked(&args.design) {
        return construction::run(call, &args.design, &wanted, Some(&designed)).map_err(in_file);
    }
    if let Some(angle) = &args.design.angle {
        designed.angle = angle.0;
    }
    let refuse = |error| design::refuse_of_file(error, args.design.angle.is_some());
    deliver(call, &args.design, &wanted, title, &designed, &refuse).map_err(in_file)
}

fn deliver(
    call: &Call<'_>,
    Design { files, page: options, output, .. }: &Design,
    wanted: &files::Wanted,
    title: Option<String>,
    designed: &Designed,
    refuse: &dyn Fn(crate::error::Error) -> Failure,
) -> Result<(), Failure> {
    let (files, output) = (files::content(files, wanted, designed, refuse)?, output.but_for_drawings());
    if output.is_page() {
        let report = report::motor::answer(title, designed).map_err(refuse)?;
        let sheet = crate::motor::page::sheet(&report, designed, imprint::command(call));
        return output.deliver_page(call, files, &report.motor, sheet, &options.imprint());
    }
    let answer = crate::motor::answer::answer(designed).map_err(refuse)?;
    output.deliver_with(call, files, &answer)
}

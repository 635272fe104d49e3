//! The command `report`: a page about a gearbox, a drive or a motor.

use crate::analyze::{Choice, Load, refuse, subject};
use crate::failure::Failure;
use crate::named::Read;
use crate::output::Target;
use epicyclic_answers as answers;
use epicyclic_answers::answer::to_json;
use epicyclic_answers::report::drive::DriveReport;
use epicyclic_answers::report::{About, Report, gearbox, motor};
use epicyclic_formats::{Document, Path, Problem, visible};
use epicyclic_views::page::{self, Sheet};

/// A page about a gearbox, a drive or a motor: input, drawings, tables, plots, checks, sources.
///
/// One HTML file that needs no network, to be read in a browser and printed. What the file describes shows in its keys: power and
/// ratio a drive; gearbox, or a list of transmissions, gearboxes; stator and rotor a motor.
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Example:
  printf 'power: 30 kW\\nspeed: 1450 rpm\\nratio: 5\\n' > drive.yaml
  printf 'gear_set: { module: 5 mm, face_width: 50 mm }\\n' >> drive.yaml
  epicyclic report drive.yaml -o drive.html")]
pub(crate) struct Args {
    #[command(flatten)]
    choice: Choice,

    #[command(flatten)]
    load: Load,

    /// How the page is written.
    #[arg(long, value_enum, default_value_t = Format::Html)]
    format: Format,

    #[command(flatten)]
    target: Target,
}

/// How a page is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    /// HTML to be read in a browser and printed.
    Html,
    /// JSON in SI units: the answers that the page is made from, without its pictures.
    Json,
}

/// Runs the command.
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let Read { document, bytes, .. } = args.choice.document(false)?;
    let text = String::from_utf8_lossy(&bytes).into_owned();
    let has = |key: &str| document.value().get(key).is_some();
    let for_gearboxes = |what: &str| match args.choice.given().or(args.load.given()) {
        Some(option) => {
            Err(Failure::Option { option, message: format!("it is for gearboxes; this is a {what}") })
        }
        None => Ok(()),
    };
    let text = if has("gearbox") || has("transmissions") {
        of_gearbox(args, &document, text)?
    } else if has("power") {
        for_gearboxes("drive")?;
        of_drive(args, &document, text)?
    } else if has("stator") || has("rotor") {
        for_gearboxes("motor")?;
        of_motor(args, &document, text).map_err(|failure| failure.in_file(&document, &Path::root()))?
    } else {
        let message = "this is no drive, which has the key power, no gearbox, which has gearbox or transmissions, and no motor, \
                       which has stator and rotor";
        let problem = Problem::Refused { message: message.to_owned() };
        return Err(document.error(&Path::root(), problem).into());
    };
    args.target.write(text.as_bytes())
}

fn of_gearbox(args: &Args, document: &Document, file: String) -> Result<String, Failure> {
    let subject = subject(&args.choice, document)?;
    let (report, shown) = gearbox::answer(&subject, args.load.input()).map_err(refuse)?;
    match args.format {
        Format::Json => json(file, About::Gearbox(Box::new(report))),
        Format::Html => html(page::gearbox::sheet(&report, &shown, file)),
    }
    .map_err(|failure| failure.in_file(document, &subject.base))
}

fn of_drive(args: &Args, document: &Document, file: String) -> Result<String, Failure> {
    let report = DriveReport::of(answers::drive::of_file(document)?);
    match args.format {
        Format::Json => json(file, About::Drive(Box::new(report))),
        Format::Html => html(page::drive::sheet(&report, file)),
    }
    .map_err(|failure| failure.in_file(document, &Path::root()))
}

fn of_motor(args: &Args, document: &Document, file: String) -> Result<String, Failure> {
    let (title, designed) = answers::motor::of_file(document)?;
    let report = motor::answer(title, &designed)?;
    match args.format {
        Format::Json => json(file, About::Motor(Box::new(report))),
        Format::Html => html(page::motor::sheet(&report, &designed, file)),
    }
}

fn json(file: String, about: About) -> Result<String, Failure> {
    Ok(to_json(&Report { file, about })?)
}

/// What HTML does not allow in a name, or turns its reading around, is written out.
fn html(sheet: Result<Sheet, epicyclic_views::Error>) -> Result<String, Failure> {
    Ok(visible::lines(&sheet?.html()?).into_owned())
}

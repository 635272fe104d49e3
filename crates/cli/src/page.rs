//! The command `report`: a page about a gearbox, a drive or a motor.

use crate::analyze::{Choice, Load, everything};
use crate::failure::Failure;
use crate::input;
use crate::output::Target;
use epicyclic_answers as answers;
use epicyclic_formats::{Document, Path, Problem, visible};
use epicyclic_views::page::gearbox::Pages;
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

    #[command(flatten)]
    target: Target,
}

/// Runs the command.
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let file = args.choice.file();
    let (document, bytes) = input::with_bytes(file)?;
    let text = String::from_utf8_lossy(&bytes).into_owned();
    let has = |key: &str| document.value().get(key).is_some();
    let for_gearboxes = |what: &str| match args.choice.given().or(args.load.given()) {
        Some(option) => {
            Err(Failure::Option { option, message: format!("it is for gearboxes; this is a {what}") })
        }
        None => Ok(()),
    };
    let placed = |failure: Failure| failure.in_file(&document, &Path::root());
    let sheet = if has("gearbox") || has("transmissions") {
        gearbox(args, &document, text)?
    } else if has("power") {
        for_gearboxes("drive")?;
        page::drive::sheet(&answers::drive::of_file(&document)?, text)
            .map_err(|error| placed(error.into()))?
    } else if has("stator") || has("rotor") {
        for_gearboxes("motor")?;
        motor(&document, text).map_err(placed)?
    } else {
        let message = "this is no drive, which has the key power, no gearbox, which has gearbox or transmissions, and no motor, \
                       which has stator and rotor";
        let problem = Problem::Refused { message: message.to_owned() };
        return Err(document.error(&Path::root(), problem).into());
    };
    // What HTML does not allow in a name, or turns its reading around, is written out.
    args.target.write(visible::lines(&sheet.html().map_err(|error| placed(error.into()))?).as_bytes())
}

fn gearbox(args: &Args, document: &Document, text: String) -> Result<Sheet, Failure> {
    let everything = everything(&args.choice, document, &args.load)?;
    let subject = everything.subject;
    let pages = Pages {
        gearbox: &subject.gearbox,
        source: subject.source.clone(),
        overview: everything.overview,
        gears: everything.gears,
    };
    page::gearbox::sheet(pages, text).map_err(|error| Failure::from(error).in_file(document, &subject.base))
}

fn motor(document: &Document, text: String) -> Result<Sheet, Failure> {
    let (title, designed) = answers::motor::of_file(document)?;
    let answer = answers::motor::answer(&designed)?;
    let over_angle = answers::motor::over_angle(&designed.motor)?;
    Ok(page::motor::sheet(title, &designed, &answer, &over_angle, text)?)
}

//! The command `report`: a page about a gearbox, a drive or a motor.

mod drive;
mod gearbox;
mod motor;
mod sheet;

use crate::analyze::{Choice, Load};
use crate::failure::Failure;
use crate::input;
use crate::output::Target;
use epicyclic_formats::{Path, Problem, visible};

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
        gearbox::sheet(&args.choice, &document, &args.load, text)?
    } else if has("power") {
        for_gearboxes("drive")?;
        drive::sheet(&document, text).map_err(placed)?
    } else if has("stator") || has("rotor") {
        for_gearboxes("motor")?;
        motor::sheet(&document, text).map_err(placed)?
    } else {
        let message = "this is no drive, which has the key power, no gearbox, which has gearbox or transmissions, and no motor, \
                       which has stator and rotor";
        let problem = Problem::Refused { message: message.to_owned() };
        return Err(document.error(&Path::root(), problem).into());
    };
    // What HTML does not allow in a name, or turns its reading around, is written out.
    args.target.write(visible::lines(&sheet.html().map_err(placed)?).as_bytes())
}

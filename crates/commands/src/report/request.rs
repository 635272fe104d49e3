//! The command `report`: a page about a gearbox, a drive, a motor or a scenario.

use crate::answer::{to_json, write_json};
use crate::desk::Call;
use crate::draw::request::to_scale;
use crate::failure::{Failure, NOTHING_TO_SHOW};
use crate::output::Target;
use crate::page::Sheet;
use crate::report::answer::drive::DriveReport;
use crate::report::answer::gearbox::{self, GearboxReport, Shown};
use crate::report::answer::{About, Report, motor};
use crate::shared::exciting::Exciting;
use crate::shared::gearbox::Gearbox;
use crate::shared::named_gearbox::Read;
use crate::shared::page_options::PageArgs;
use crate::shared::scenario::Scenario;
use crate::shared::{
    gearbox_choice::{Choice, subject},
    load::Load,
};
use crate::simulate;
use epicyclic_formats::document::Segment;
use epicyclic_formats::{Document, FileKind, Path, Problem};
use epicyclic_units::visible;
use std::ops::ControlFlow;

/// A page about a gearbox, a drive, a motor or a scenario: the answer, then tables, drawings, plots, checks,
/// sources, the input.
///
/// One HTML file that needs no network, to be read in a browser and printed. What the file describes shows in
/// its keys: power and ratio a drive; gearbox, or a list of transmissions, gearboxes; stator and rotor a
/// motor; scenario a gearbox in motion.
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    #[command(flatten)]
    choice: Choice,

    #[command(flatten)]
    request: Request,

    /// How the page is written.
    #[arg(long, value_enum, default_value_t = Format::Html)]
    format: Format,

    /// Schemes with gears at the heights of their pitch radii, as `draw --to-scale` draws them.
    #[arg(long)]
    to_scale: bool,

    #[command(flatten)]
    target: Target,

    #[command(flatten)]
    page: PageArgs,
}

/// How a page is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    /// HTML to be read in a browser and printed.
    Html,
    /// JSON in SI units: the answers that the page is made from, without its pictures.
    Json,
}

impl Args {
    fn is_page(&self) -> bool {
        self.format == Format::Html
    }
}

/// Request for the chapters of a gearbox; other files ask for nothing beside themselves.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct Request {
    /// Speed and load of the input.
    #[command(flatten)]
    pub load: Load,

    /// Excitation of the vibration and its speeds; the file may state those that are not given.
    #[command(flatten)]
    pub exciting: Exciting,
}

impl Request {
    /// Computes the chapters of a gearbox, and the results for their pictures. The closure is called now and
    /// then, and may end the calculation.
    ///
    /// # Errors
    /// - [`Failure::Option`] for an invalid load or excitation, and for an excitation of a gearbox whose file
    ///   has no `vibration`.
    /// - [`Failure::Answer`] with the place of invalid data in the file.
    pub fn answer<'g>(
        &self,
        gearbox: &'g Gearbox,
        goes_on: &dyn Fn() -> ControlFlow<()>,
    ) -> Result<(GearboxReport, Shown<'g>), Failure> {
        let (report, shown) =
            gearbox::answer(gearbox, self.load, &self.exciting, goes_on).map_err(Exciting::refuse)?;
        if let Some(option) = self.exciting.given().filter(|_| report.vibration.is_none()) {
            let message = "it is for a gearbox whose file has `vibration` of a set";
            return Err(Failure::invalid(option, message));
        }
        Ok((report, shown))
    }
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    args.page.only_of_a_page(args.is_page())?;
    args.target.is_for_a_page(args.is_page())?;
    if args.to_scale && !args.is_page() {
        let message = "it is for the pictures of a page; JSON has none".to_owned();
        return Err(Failure::invalid("--to-scale", message));
    }
    let read = args.choice.document(call, false)?;
    let document = &read.document;
    let text = String::from_utf8_lossy(&read.bytes).into_owned();
    let for_gearboxes = |what: &str| match args
        .choice
        .given()
        .or(args.request.load.given())
        .or(args.to_scale.then_some("--to-scale"))
        .or(args.request.exciting.given())
    {
        Some(option) => Err(Failure::conflict(option, format!("it is for gearboxes; this is a {what}"))),
        None => Ok(()),
    };
    let text = match document.kind() {
        Some(FileKind::Scenario) => {
            for_gearboxes("scenario")?;
            of_scenario(call, args, document.clone(), text)?
        }
        Some(FileKind::Gearbox | FileKind::Transmissions) => of_gearbox(call, args, &read, text)?,
        Some(FileKind::Drive) => {
            for_gearboxes("drive")?;
            of_drive(call, args, document, text)?
        }
        Some(FileKind::Motor) => {
            for_gearboxes("motor")?;
            of_motor(call, args, document, text)
                .map_err(|failure| failure.in_file(document, &Path::root()))?
        }
        None => {
            let message = "this is no drive, which has the key power, no gearbox, which has gearbox or transmissions, no motor, \
                           which has stator and rotor, and no scenario, which has scenario";
            let problem = Problem::refused("no-known-file", message);
            return Err(document.error(&Path::root(), problem).into());
        }
    };
    args.target.write(call, text.as_bytes())
}

fn of_gearbox(call: &Call<'_>, args: &Args, read: &Read, file: String) -> Result<String, Failure> {
    let subject = subject(&args.choice, read)?;
    let document = &subject.document;
    let (report, mut shown) = args.request.answer(&subject, &|| call.goes_on())?;
    let sheet = match args.format {
        Format::Json => None,
        Format::Html => {
            let own = own_lines(document, &subject.base, &file);
            let scale = match &shown.layout {
                Some(layout) if args.to_scale => {
                    let (layout, scale) = to_scale(shown.gearbox, layout, &subject.planet_bearings)?;
                    shown.layout = Some(Box::new(layout));
                    Some(scale)
                }
                None if args.to_scale => {
                    let message = "this gearbox has no scheme without crossing lines".to_owned();
                    return Err(Failure::invalid("--to-scale", message).in_file(document, &subject.base));
                }
                _ => None,
            };
            Some(crate::report::page::sheet(&report, &shown, scale.as_ref(), own))
        }
    };
    let report = Report { file, about: About::Gearbox(Box::new(report)) };
    written(call, args, sheet, &report).map_err(|failure| failure.in_file(document, &subject.base))
}

/// Returns the lines of one transmission in a list of transmissions. Any other file is returned whole, and so
/// is a list whose items share lines.
fn own_lines(document: &Document, base: &Path, file: &str) -> String {
    let Some(Segment::Index(place)) = base.segments().last() else { return file.to_owned() };
    let line = |place: usize| {
        let item = Path::root().key("transmissions").index(place);
        document.value_at(&item).map(|_| document.position(&item).line)
    };
    let (Some(first), next) = (line(*place), line(place + 1)) else { return file.to_owned() };
    let starts_alone = place.checked_sub(1).and_then(line).is_none_or(|before| before < first);
    if !starts_alone || next.is_some_and(|next| next <= first) {
        return file.to_owned();
    }
    let count = next.map_or(usize::MAX, |next| next - first);
    file.lines().skip(first.saturating_sub(1)).take(count).flat_map(|line| [line, "\n"]).collect()
}

fn of_scenario(call: &Call<'_>, args: &Args, document: Document, file: String) -> Result<String, Failure> {
    let scenario = Scenario::beside(call, document, args.choice.file())?;
    let goes_on = |_| call.goes_on();
    let simulation = simulate::Request::default().answer(&scenario, goes_on)?;
    if call.goes_on().is_break() {
        return Err(Failure::Interrupted(NOTHING_TO_SHOW.to_owned()));
    }
    let sheet = args.is_page().then(|| crate::simulate::page::sheet(&simulation, file.clone()));
    let report = Report { file, about: About::Scenario(Box::new(simulation)) };
    written(call, args, sheet, &report).map_err(|failure| failure.in_file(&scenario.document, &Path::root()))
}

fn of_drive(call: &Call<'_>, args: &Args, document: &Document, file: String) -> Result<String, Failure> {
    let report = DriveReport::of(crate::drive::answer::of_file(document)?);
    let sheet = args.is_page().then(|| crate::drive::page::sheet(&report, file.clone()));
    let report = Report { file, about: About::Drive(Box::new(report)) };
    written(call, args, sheet, &report).map_err(|failure| failure.in_file(document, &Path::root()))
}

fn of_motor(call: &Call<'_>, args: &Args, document: &Document, file: String) -> Result<String, Failure> {
    let (title, designed) = crate::motor::answer::of_file(document)?;
    let report = motor::answer(title, &designed)?;
    let sheet = args.is_page().then(|| crate::motor::page::sheet(&report, &designed, file.clone()));
    written(call, args, sheet, &Report { file, about: About::Motor(Box::new(report)) })
}

/// The page of a sheet, whose record is handed over; without a sheet the record.
fn written(
    call: &Call<'_>,
    args: &Args,
    sheet: Option<Result<Sheet, crate::table::text::Error>>,
    report: &Report,
) -> Result<String, Failure> {
    let Some(sheet) = sheet else { return Ok(to_json(report)?) };
    // What HTML does not allow in a name, or turns its reading around, is written out.
    let page = visible::lines(&sheet?.html(&args.page.imprint())?).into_owned();
    call.record(&mut |out| write_json(report, out))?;
    Ok(page)
}

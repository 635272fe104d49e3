//! The command `simulate`: a gearbox in motion, by a scenario.

use crate::desk::{Call, Content, Hearing};
use crate::drawing_file;
use crate::failure::Failure;
use crate::output::OutputArgs;
use crate::progress::Progress;
use crate::shared::scenario::Read;
use crate::simulate::answer::Simulation;
use crate::simulate::answer::sweep::Wanted;
use crate::simulate::answer::{self as answers, sweep};
use crate::simulate::table::{PlotView, picture, samples};
use epicyclic_units::visible::one_line;
use epicyclic_units::{self as quantity, Dimension, Measured, Number};
use std::path::PathBuf;
use std::str::FromStr;

/// A gearbox in motion by a scenario: how it shifts, how hot its clutches get, whether the drive starts.
///
/// A scenario names a gearbox, inertias, torques on links, capacities of shift elements and shifts. Shift
/// elements are dry friction without smoothing, so that slip, lock and release are exact events. With a file
/// that ends in .svg, .pdf, .png or .dxf --output draws a plot over time.
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    /// The file of the scenario, in YAML; - for standard input.
    #[arg(value_name = "FILE")]
    file: PathBuf,

    /// File for speeds and torques over time as comma-separated values.
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,

    /// Other values of one key, a run for each.
    #[arg(
        long,
        value_name = "KEY=FROM..TO",
        conflicts_with_all = ["csv", "view", "dpi"],
        help = "Other values of one key, a run for each: shifts[0].overlap=0ms..300ms, elements[C].holding='300 N·m..600 N·m'"
    )]
    sweep: Option<Range>,

    /// How many values, 2 to 1000. Default: 11.
    #[arg(long, value_name = "COUNT", requires = "sweep")]
    steps: Option<u32>,

    /// What a drawing shows, with --output. Default: speeds.
    #[arg(long, value_enum)]
    view: Option<PlotView>,

    /// Pixels to an inch of a PNG image, 20 to 2400. Default: 300.
    #[arg(long, value_name = "NUMBER", requires = "output")]
    dpi: Option<Number>,

    #[command(flatten)]
    output: OutputArgs,
}

/// Runs the command. The first Ctrl-C ends the motion and shows the part that is calculated.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let drawing = args.output.drawing();
    drawing_file::check_dpi(args.dpi, drawing.iter().map(|(_, format)| *format))?;
    if args.view.is_some() && drawing.is_none() {
        let message = "it is for a drawing: let --output end in .svg, .pdf, .png or .dxf".to_owned();
        return Err(Failure::invalid("--view", message));
    }
    let read = Read::of(call, &args.file)?;
    if let Some(range) = &args.sweep {
        return swept(call, args, &read, range);
    }
    let (hearing, shown) = (Hearing::new(call), Progress::of_runs(call));
    let mut is_whole = true;
    let simulation = answers::answer_watched(&read.document, &read.file, &read.beside, |share| {
        is_whole = shown.at(share).is_continue();
        is_whole
    });
    drop((shown, hearing));
    let simulation = simulation?;
    let mut files: Vec<Content> = vec![];
    if let Some(file) = &args.csv {
        let table = samples(&simulation);
        table.refuse_infinite()?;
        let mut bytes = vec![];
        table.csv(&mut bytes).map_err(|source| Failure::Write { file: file.clone(), source })?;
        files.push((file.clone(), bytes));
    }
    if let Some((file, format)) = drawing {
        let scene = plot(&simulation, args.view)?;
        files.push((file.to_owned(), drawing_file::content(&scene, format, args.dpi)?));
    }
    args.output.but_for_drawings().deliver_with(call, files, &simulation)?;
    if is_whole { Ok(()) } else { Err(interrupted()) }
}

/// Failure of a call that was asked to end after its answer was shown.
fn interrupted() -> Failure {
    Failure::Interrupted("interrupted".to_owned())
}

/// Runs with several values of a key. The first Ctrl-C keeps what is done.
fn swept(call: &Call<'_>, args: &Args, read: &Read, range: &Range) -> Result<(), Failure> {
    if let Some((file, _)) = args.output.drawing() {
        let message = format!("{}: a sweep has tables; leave --sweep out for a drawing", file.display());
        return Err(Failure::conflict("--output", message));
    }
    let (from, to) = (&range.from, &range.to);
    let wanted = Wanted {
        key: range.key.clone(),
        from: from.value,
        to: to.value,
        unit: (from.dimension() != Dimension::Dimensionless || from.unit.symbol != "1")
            .then(|| from.unit.symbol.to_owned()),
        steps: args.steps.unwrap_or(11),
    };
    let (hearing, shown) = (Hearing::new(call), Progress::of_runs(call));
    let goes_on = |share: f64| shown.at(share).is_continue();
    let found = sweep::sweep(&read.document, &read.beside, &wanted, goes_on);
    drop((shown, hearing));
    let found = found.map_err(|error| match error {
        crate::error::Error::Places { .. } => Failure::of_option("--steps", &error),
        crate::error::Error::Sweep { why } => Failure::named("sweep", "--sweep", why),
        error => error.into(),
    })?;
    let is_whole = found.runs.len() == wanted.steps as usize;
    args.output.deliver(call, &found)?;
    if is_whole { Ok(()) } else { Err(interrupted()) }
}

/// A key and its values.
#[derive(Debug, Clone)]
struct Range {
    key: String,
    from: Measured,
    to: Measured,
}

impl FromStr for Range {
    type Err = String;

    fn from_str(written: &str) -> Result<Self, String> {
        let form =
            || format!("{}: write a key and two values, as shifts[0].overlap=0ms..300ms", one_line(written));
        let (key, values) = written.split_once('=').ok_or_else(form)?;
        let (from, to) = values.split_once("..").ok_or_else(form)?;
        let value = |text: &str| quantity::parse(text.trim()).map_err(|error| error.to_string());
        let (from, to) = (value(from)?, value(to)?);
        if from.unit != to.unit {
            return Err(format!("{}: both values in one unit", one_line(written)));
        }
        Ok(Self { key: key.trim().to_owned(), from, to })
    }
}

fn plot(simulation: &Simulation, view: Option<PlotView>) -> Result<epicyclic_drawing::Scene, Failure> {
    let view = view.unwrap_or(PlotView::Speeds);
    let lacks = match view {
        PlotView::Speeds | PlotView::Torques => "",
        PlotView::Capacities => "no brake or clutch has a capacity",
        PlotView::Temperatures => "no element has a heat_capacity",
    };
    let plot = picture(simulation, view);
    let plot = plot.ok_or_else(|| Failure::invalid("--view", lacks))?;
    Ok(plot.scene()?)
}

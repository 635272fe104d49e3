//! The command `simulate`: a gearbox in motion, by a scenario.

use crate::desk::{Call, Content, Hearing};
use crate::drawing_file;
use crate::error::Error;
use crate::failure::Failure;
use crate::output::OutputArgs;
use crate::progress::Progress;
use crate::shared::scenario::Scenario;
use crate::simulate::answer::sweep::{Range, Sweep, sweep};
use crate::simulate::answer::{self as answers, Simulation};
use crate::simulate::table::{PlotView, picture, samples};
use epicyclic_units::Number;
use std::ops::ControlFlow;
use std::path::PathBuf;

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
    #[arg(long, value_name = "FILE", conflicts_with = "sweep")]
    csv: Option<PathBuf>,

    #[command(flatten)]
    request: Request,

    /// What a drawing shows, with --output. Default: speeds.
    #[arg(long, value_enum, conflicts_with = "sweep")]
    view: Option<PlotView>,

    /// Pixels to an inch of a PNG image, 20 to 2400. Default: 300, or fewer where it would be too large.
    #[arg(long, value_name = "NUMBER", requires = "output", conflicts_with = "sweep")]
    dpi: Option<Number>,

    #[command(flatten)]
    output: OutputArgs,
}

/// Request for a gearbox in motion: one run, or a run for each of several values of a key.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct Request {
    /// Other values of one key, a run for each.
    #[arg(
        long,
        value_name = "KEY=FROM..TO",
        help = "Other values of one key, a run for each: shifts[0].overlap=0ms..300ms, elements[C].holding='300 N·m..600 N·m'"
    )]
    pub sweep: Option<Range>,

    /// How many values, 2 to 1000. Default: 11.
    #[arg(long, value_name = "COUNT", requires = "sweep")]
    pub steps: Option<u32>,
}

/// Number of values of a sweep if it is not given.
const STEPS: u32 = 11;

impl Request {
    /// Simulates the scenario with its own values. The closure receives the finished part, from 0 to 1, and
    /// may end the simulation, which then has all results up to then.
    ///
    /// # Errors
    /// [`Failure::Answer`] with the place of the fault in the scenario or its gearbox.
    pub fn answer(
        &self,
        scenario: &Scenario,
        goes_on: impl FnMut(f64) -> ControlFlow<()>,
    ) -> Result<Simulation, Failure> {
        Ok(answers::answer_watched(&scenario.document, &scenario.file, &scenario.beside, goes_on)?)
    }

    /// Simulates the scenario once for each value of the sweep. The closure receives the finished part, from
    /// 0 to 1, and may end the sweep, which then has the runs that are done.
    ///
    /// # Errors
    /// - [`Failure::Option`] without a sweep, for a key that cannot be swept, for a value that it does not
    ///   accept, and for too few or too many steps.
    /// - [`Failure::Answer`] with the place of another fault in the scenario.
    pub fn answer_sweep(
        &self,
        scenario: &Scenario,
        goes_on: impl Fn(f64) -> ControlFlow<()> + Sync + Send,
    ) -> Result<Sweep, Failure> {
        let range = self.sweep.as_ref();
        let range = range.ok_or_else(|| Failure::missing("--sweep", "a key and its values are required"))?;
        sweep(&scenario.document, &scenario.beside, range, self.steps(), goes_on).map_err(|error| match error
        {
            Error::Places { .. } => Failure::of_option("--steps", &error),
            Error::Sweep { why } => Failure::named("sweep", "--sweep", why),
            error => error.into(),
        })
    }

    fn steps(&self) -> u32 {
        self.steps.unwrap_or(STEPS)
    }
}

/// Runs the command. The first Ctrl-C ends the motion and shows the part that is calculated.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let drawing = args.output.drawing();
    drawing_file::check_dpi(args.dpi, drawing.iter().map(|(_, format)| *format))?;
    if args.view.is_some() && drawing.is_none() {
        let message = "it is for a drawing: let --output end in .svg, .pdf, .png or .dxf".to_owned();
        return Err(Failure::invalid("--view", message));
    }
    let scenario = Scenario::of(call, &args.file)?;
    if args.request.sweep.is_some() {
        return swept(call, args, &scenario);
    }
    let (hearing, shown) = (Hearing::new(call), Progress::of_runs(call));
    let mut asked = ControlFlow::Continue(());
    let simulation = args.request.answer(&scenario, |share| {
        asked = shown.at(share);
        asked
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
    if asked.is_continue() { Ok(()) } else { Err(interrupted()) }
}

/// Failure of a call that was asked to end after its answer was shown.
fn interrupted() -> Failure {
    Failure::Interrupted("interrupted".to_owned())
}

/// Runs with several values of a key. The first Ctrl-C keeps what is done.
fn swept(call: &Call<'_>, args: &Args, scenario: &Scenario) -> Result<(), Failure> {
    if let Some((file, _)) = args.output.drawing() {
        let message = format!("{}: a sweep has tables; leave --sweep out for a drawing", file.display());
        return Err(Failure::conflict("--output", message));
    }
    let (hearing, shown) = (Hearing::new(call), Progress::of_runs(call));
    let found = args.request.answer_sweep(scenario, |share| shown.at(share));
    drop((shown, hearing));
    let found = found?;
    let is_whole = found.runs.len() == args.request.steps() as usize;
    args.output.deliver(call, &found)?;
    if is_whole { Ok(()) } else { Err(interrupted()) }
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

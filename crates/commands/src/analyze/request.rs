//! The command `analyze`: what a gearbox does in each of its gears.

pub mod several;

use crate::analyze::answer as answers;
use crate::analyze::answer::Input;
use crate::analyze::answer::combinations::Combinations;
use crate::analyze::answer::formulas::Formulas;
use crate::analyze::answer::gear::OneGear;
use crate::analyze::answer::inputs::map::{self, SpeedMap};
use crate::analyze::answer::inputs::{Inputs, Wanted};
use crate::analyze::answer::overview::Overview;
use crate::analyze::answer::shifts::Shifts;
use crate::analyze::table::inputs::map_csv;
use crate::answer::write_json;
use crate::desk::Call;
use crate::error::Error;
use crate::failure::Failure;
use crate::output::{Format, OutputArgs};
use crate::shared::gearbox::{self, Content, Gearbox};
use crate::shared::gearbox_choice::{Choice, below_each_other, refuse, subject};
use crate::shared::judgement::answer::Judgement;
use crate::shared::load::Load;
use crate::shared::transmissions::answer as transmissions;
use epicyclic_units::Number;
use several::Several;

/// A planetary gearbox from a file, or a scheme by its name: ratios, speeds, torques, powers and losses of
/// its gears.
///
/// Without --gear all gears: engagement table, ratios with their steps and progression, losses, torque and
/// slip of the shift elements, shifts, planets; with --gear everything about one. Speeds are multiples of the
/// input's speed, torques of the input's torque and powers of what enters, unless --speed, --torque or
/// --power say more. A negative torque or power brakes the machine: power then runs from the output to the
/// input. A gear that keeps freedoms, such as a power split, takes --speeds of several links and --torques at
/// some.
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    #[command(flatten)]
    choice: Choice,

    #[command(flatten)]
    request: Request,

    #[command(flatten)]
    output: OutputArgs,
}

/// Request for the analysis of a gearbox: all gears, one of them, its formulas, its shifts.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct Request {
    /// One gear, in full.
    #[arg(long, value_name = "NAME")]
    pub gear: Option<String>,

    /// Every combination of shift elements, with its state.
    #[arg(long, conflicts_with_all = ["gear", "torque", "power", "speed"])]
    pub all_combinations: bool,

    /// Ratios as formulas in the basic ratios of the sets: of all gears, or of one with --gear.
    #[arg(long, conflicts_with_all = ["all_combinations", "torque", "power", "speed", "speeds", "torques", "map"])]
    pub formula: bool,

    /// The formulas and the way to them: equations with their numbers, conditions, substitutions, torques.
    #[arg(long, conflicts_with_all = ["all_combinations", "torque", "power", "speed", "speeds", "torques", "map"])]
    pub steps: bool,

    /// All shifts between gears, also those that pass gears over: what is released and applied, and how the
    /// input and each shift element change their speeds.
    #[arg(long, conflicts_with_all = ["gear", "all_combinations", "formula", "steps", "torque", "power", "speeds", "torques", "map"])]
    pub shifts: bool,

    /// Progression factor of the ideal progression: each of its steps over the next. Default: the factor that
    /// fits the ratios best.
    #[arg(
        long,
        value_name = "NUMBER",
        allow_hyphen_values = true,
        conflicts_with_all = ["gear", "all_combinations", "formula", "steps", "shifts"],
    )]
    pub progression: Option<Number>,

    /// Speeds and torques of several links.
    #[command(flatten)]
    pub several: Several,

    /// Speed and load of the input.
    #[command(flatten)]
    pub load: Load,
}

/// Answer to a request for an analysis.
#[derive(Debug)]
pub enum Analysis<'g> {
    /// Overview of all gears.
    Overview(Box<Overview>),
    /// One gear with one input.
    Gear(Box<OneGear>),
    /// One gear at speeds of several links.
    Inputs(Box<Inputs>),
    /// One gear over ranges of two speeds.
    Map(SpeedMap<'g>),
    /// Every combination of shift elements.
    Combinations(Combinations),
    /// Ratios as formulas.
    Formulas(Formulas),
    /// Shifts between gears.
    Shifts(Shifts),
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let Args { choice, request, output } = args;
    let read = choice.document(call, request.formula && !request.steps)?;
    if !request.is_of_one_gearbox()
        && let Content::Several(all) = gearbox::read(&read.document, &choice.question()?).map_err(refuse)?
    {
        let answer = transmissions::answer(&all);
        let progression = request.progression.map(|_| "--progression");
        return match choice.given().or(request.load.given()).or(progression) {
            Some(option) => Err(for_one_gearbox(option, &answer)),
            None => output.deliver(call, &answer),
        };
    }
    match request.answer(&subject(choice, &read)?)? {
        Analysis::Overview(answer) => output.deliver(call, &*answer),
        Analysis::Gear(answer) => output.deliver(call, &*answer),
        Analysis::Inputs(answer) => output.deliver(call, &*answer),
        Analysis::Map(map) => deliver_map(call, output, &map),
        Analysis::Combinations(answer) => output.deliver(call, &answer),
        Analysis::Formulas(answer) => output.deliver(call, &answer),
        Analysis::Shifts(answer) => output.deliver(call, &answer),
    }
}

impl Request {
    /// Whether a list of transmissions, which otherwise gets an overview of its own, has to be narrowed.
    fn is_of_one_gearbox(&self) -> bool {
        self.gear.is_some() || self.all_combinations || self.formula || self.steps || self.shifts
    }

    /// Analyses a gearbox.
    ///
    /// # Errors
    /// [`Failure::Option`] for a gear, link or load that cannot be, [`Failure::Answer`] with the place of
    /// missing data in the file.
    pub fn answer<'g>(&self, gearbox: &'g Gearbox) -> Result<Analysis<'g>, Failure> {
        let input = self.load.input();
        let gear = self.gear.as_deref();
        let is_given = |gear: &&str| {
            // Inputs stated in the file apply only if the request gives no load.
            self.several.is_given() || (self.load.given().is_none() && gearbox.has_inputs(gear))
        };
        if let Some((gear, ranges)) = gear.zip(self.several.map()?) {
            let torques = self.several.torques();
            return map::map(gearbox, gear, ranges, torques.as_deref()).map(Analysis::Map).map_err(refuse);
        }
        let answer = if self.formula || self.steps {
            answers::formulas::answer(gearbox, gear, self.steps).map(|answer| {
                Analysis::Formulas(if gearbox.is_sized { answer } else { answer.without_numbers() })
            })
        } else if let Some(gear) = gear.filter(is_given) {
            inputs(gearbox, gear, &self.several.wanted()).map(|of| Analysis::Inputs(Box::new(of)))
        } else if let Some(gear) = gear {
            self::gear(gearbox, gear, input).map(|gear| Analysis::Gear(Box::new(gear)))
        } else if self.all_combinations {
            answers::combinations::answer(gearbox).map(Analysis::Combinations)
        } else if self.shifts {
            answers::shifts::answer(gearbox, input.speed).map(Analysis::Shifts)
        } else {
            let factor = self.progression.map(Number::get);
            overview(gearbox, input, factor).map(|all| Analysis::Overview(Box::new(all)))
        };
        let mut answer = answer.map_err(refuse)?;
        let mut of_formulas = vec![];
        let (judgement, warnings) = match &mut answer {
            Analysis::Combinations(of) => (&mut of.judgement, &mut of.warnings),
            Analysis::Shifts(of) => (&mut of.judgement, &mut of.warnings),
            Analysis::Formulas(of) if gearbox.is_sized => (&mut of.judgement, &mut of_formulas),
            // Judged where they are made; formulas without numbers show no gearbox.
            Analysis::Overview(_)
            | Analysis::Gear(_)
            | Analysis::Inputs(_)
            | Analysis::Map(_)
            | Analysis::Formulas(_) => return Ok(answer),
        };
        *judgement = Judgement::added_to(warnings, gearbox);
        Ok(answer)
    }
}

/// One gear with its judgement.
///
/// # Errors
/// Those of [`answers::gear::answer`].
pub fn gear(gearbox: &Gearbox, name: &str, input: Input) -> Result<OneGear, Error> {
    let mut gear = answers::gear::answer(gearbox, name, input)?;
    gear.judgement = Judgement::added_to(&mut gear.warnings, gearbox);
    Ok(gear)
}

/// One gear under several inputs, with its judgement.
///
/// # Errors
/// Those of [`answers::inputs::answer`].
pub fn inputs(gearbox: &Gearbox, name: &str, wanted: &Wanted) -> Result<Inputs, Error> {
    let mut inputs = answers::inputs::answer(gearbox, name, wanted)?;
    inputs.judgement = Judgement::added_to(&mut inputs.warnings, gearbox);
    Ok(inputs)
}

/// The overview of a gearbox, and what practice says of it.
///
/// # Errors
/// Those of [`answers::overview::answer`].
pub fn overview(gearbox: &Gearbox, input: Input, factor: Option<f64>) -> Result<Overview, Error> {
    let mut overview = answers::overview::answer(gearbox, input, factor)?;
    overview.judgement = Judgement::added_to(&mut overview.warnings, gearbox);
    Ok(overview)
}

/// A map as it is calculated; as a table, which is put together before it is shown, up to a size.
fn deliver_map(call: &Call<'_>, output: &OutputArgs, map: &SpeedMap<'_>) -> Result<(), Failure> {
    /// Lines of a table. Each takes about a kilobyte until all are written.
    const MOST_LINES: usize = 50_000;
    let count = map.count();
    match output.format() {
        Format::Table if count > MOST_LINES => {
            let message = format!(
                "{count} lines, one for each link at each place; a table has at most {MOST_LINES}: give fewer places, --format csv or \
                 --format json"
            );
            return Err(Failure::invalid("--map", message));
        }
        Format::Table => return output.deliver(call, &map.answer().map_err(refuse)?),
        Format::Json => output.stream(call, &[], &mut |out| write_json(&map.streamed(), out))?,
        Format::Csv => output.stream(call, &[], &mut |out| map_csv(map, out))?,
    }
    output.tell_warnings(call, &map.streamed().warnings);
    Ok(())
}

/// An option for one gearbox, of a file that holds several.
fn for_one_gearbox(option: &'static str, all: &transmissions::Transmissions) -> Failure {
    let names = all.transmissions.iter().map(|one| one.name.as_str());
    let message = format!(
        "it is for one gearbox, and the file has {}; add --transmission with one of{}",
        all.transmissions.len(),
        below_each_other(names)
    );
    Failure::conflict(option, message)
}

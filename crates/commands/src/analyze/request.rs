//! The command `analyze`: what a gearbox does in each of its gears.

mod several;

use crate::analyze::answer::inputs::map::{self, SpeedMap};
use crate::analyze::answer::{self as answers};
use crate::analyze::table::inputs::map_csv;
use crate::answer::write_json;
use crate::desk::Call;
use crate::failure::Failure;
use crate::output::{Format, OutputArgs};
use crate::shared::gearbox::{self, Content, Gearbox};
use crate::shared::gearbox_choice::{Choice, below_each_other, refuse};
use crate::shared::load::Load;
use crate::shared::named_gearbox as named;
use crate::shared::transmissions::answer as transmissions;
use epicyclic_units::Number;

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

    /// One gear, in full.
    #[arg(long, value_name = "NAME")]
    gear: Option<String>,

    /// Every combination of shift elements, with its state.
    #[arg(long, conflicts_with_all = ["gear", "torque", "power", "speed"])]
    all_combinations: bool,

    /// Ratios as formulas in the basic ratios of the sets: of all gears, or of one with --gear.
    #[arg(long, conflicts_with_all = ["all_combinations", "torque", "power", "speed", "speeds", "torques", "map"])]
    formula: bool,

    /// The formulas and the way to them: equations with their numbers, conditions, substitutions, torques.
    #[arg(long, conflicts_with_all = ["all_combinations", "torque", "power", "speed", "speeds", "torques", "map"])]
    steps: bool,

    /// All shifts between gears, also those that pass gears over: what is released and applied, and how the
    /// input and each shift element change their speeds.
    #[arg(long, conflicts_with_all = ["gear", "all_combinations", "formula", "steps", "torque", "power", "speeds", "torques", "map"])]
    shifts: bool,

    /// Progression factor of the ideal progression: each of its steps over the next. Default: the factor that
    /// fits the ratios best.
    #[arg(
        long,
        value_name = "NUMBER",
        allow_negative_numbers = true,
        conflicts_with_all = ["gear", "all_combinations", "formula", "steps", "shifts"],
    )]
    progression: Option<Number>,

    #[command(flatten)]
    several: several::Several,

    #[command(flatten)]
    load: Load,

    #[command(flatten)]
    output: OutputArgs,
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let named::Read { document, is_sized, .. } = args.choice.document(call, args.formula && !args.steps)?;
    let choice = args.choice.question()?;
    let wants_formulas = args.formula || args.steps;
    // These answers are about one gearbox; otherwise a list of transmissions gets an overview of its own.
    let subject = if args.gear.is_some() || args.all_combinations || wants_formulas || args.shifts {
        gearbox::one(&document, &choice).map_err(refuse)?
    } else {
        match gearbox::read(&document, &choice).map_err(refuse)? {
            Content::One(subject) => *subject,
            Content::Several(all) => {
                let answer = transmissions::answer(&all);
                let progression = args.progression.map(|_| "--progression");
                return match args.choice.given().or(args.load.given()).or(progression) {
                    Some(option) => Err(for_one_gearbox(option, &answer)),
                    None => args.output.deliver(call, &answer),
                };
            }
        }
    };
    if wants_formulas {
        let answer = answers::formulas::answer(&subject, args.gear.as_deref(), args.steps).map_err(refuse)?;
        return args.output.deliver(call, &if is_sized { answer } else { answer.without_numbers() });
    }
    let input = args.load.input();
    match &args.gear {
        Some(name) if args.several.is_given() => inputs(call, args, &subject, name),
        // Inputs stated in the file apply only if the command line gives no load.
        Some(name) if args.load.given().is_none() && subject.has_inputs(name) => {
            inputs(call, args, &subject, name)
        }
        Some(name) => {
            args.output.deliver(call, &answers::gear::answer(&subject, name, input).map_err(refuse)?)
        }
        None if args.all_combinations => {
            args.output.deliver(call, &answers::combinations::answer(&subject).map_err(refuse)?)
        }
        None if args.shifts => {
            args.output.deliver(call, &answers::shifts::answer(&subject, input.speed).map_err(refuse)?)
        }
        None => {
            let factor = args.progression.map(Number::get);
            args.output.deliver(call, &answers::overview::answer(&subject, input, factor).map_err(refuse)?)
        }
    }
}

fn inputs(call: &Call<'_>, args: &Args, subject: &Gearbox, gear: &str) -> Result<(), Failure> {
    match args.several.map()? {
        Some(ranges) => {
            let torques = args.several.torques();
            let map = map::map(subject, gear, ranges, torques.as_deref()).map_err(refuse)?;
            deliver_map(call, args, &map)
        }
        None => {
            let answer = answers::inputs::answer(subject, gear, &args.several.wanted()).map_err(refuse)?;
            args.output.deliver(call, &answer)
        }
    }
}

/// A map as it is calculated; as a table, which is put together before it is shown, up to a size.
fn deliver_map(call: &Call<'_>, args: &Args, map: &SpeedMap<'_>) -> Result<(), Failure> {
    /// Lines of a table. Each takes about a kilobyte until all are written.
    const MOST_LINES: usize = 50_000;
    let (output, count) = (&args.output, map.count());
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

//! The command `analyze`: what a gearbox does in each of its gears.

use crate::desk::Call;
mod several;

use crate::analyze::answer::inputs::Given;
use crate::analyze::answer::inputs::map::{self, SpeedMap};
use crate::analyze::answer::{self as answers, Input, LoadQuantity};
use crate::analyze::table::inputs::map_csv;
use crate::answer::write_json;
use crate::error::Error;
use crate::failure::Failure;
use crate::output::{Format, OutputArgs};
use crate::shared::gearbox::{self, Content, Subject};
use crate::shared::named_gearbox::{self as named, Sizes};
use crate::shared::options::efficiency;
use crate::shared::transmissions::answer as transmissions;
use epicyclic_formats::Document;
use epicyclic_train::{Analysis, Gearbox, InputLoad};
use epicyclic_units::{Number, Quantity};
use std::path::Path;
use uom::si::f64::{AngularVelocity, Power, Ratio, Torque};

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

/// Which gearbox.
#[derive(Debug, clap::Args)]
pub(crate) struct Choice {
    /// The file, in YAML, or - for standard input; or a scheme of the catalogue (I … III-3) or a structure
    /// (D.T1.B+T2.B.T1) by its name.
    #[arg(value_name = "FILE", value_hint = clap::ValueHint::FilePath)]
    gearbox: String,

    #[command(flatten)]
    sizes: Sizes,

    /// One transmission of a list: its name, or a part that no other name has.
    #[arg(long, value_name = "NAME")]
    transmission: Option<String>,

    /// Efficiency with the carrier fixed of each set for which the file states no losses: 0.97 or 97%. Of a
    /// compound set each mesh takes its square root.
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    efficiency: Option<Quantity<Ratio>>,
}

impl Choice {
    /// An option that is given.
    pub(crate) fn given(&self) -> Option<&'static str> {
        let transmission = self.transmission.as_ref().map(|_| "--transmission");
        transmission.or(self.efficiency.map(|_| "--efficiency")).or(self.sizes.given())
    }

    /// The file, as it was named.
    pub(crate) fn file(&self) -> &Path {
        Path::new(&self.gearbox)
    }

    /// One gearbox of a file, all of it as its options would say.
    pub(crate) fn new(
        gearbox: String,
        transmission: Option<String>,
        efficiency: Option<Quantity<Ratio>>,
    ) -> Self {
        Self { gearbox, transmission, efficiency, sizes: Sizes::default() }
    }

    /// The document of the gearbox, its text, and whether the sizes in it are known.
    pub(crate) fn document(&self, call: &Call<'_>, any_size_will_do: bool) -> Result<named::Read, Failure> {
        named::document(call, &self.gearbox, self.sizes, self.efficiency, any_size_will_do)
    }

    fn question(&self) -> Result<gearbox::Choice, Failure> {
        let efficiency = self.efficiency.map(efficiency).transpose()?;
        Ok(gearbox::Choice { transmission: self.transmission.clone(), efficiency })
    }
}

/// What its input does.
#[derive(Debug, clap::Args)]
pub(crate) struct Load {
    /// Torque on the input: 500 N·m.
    #[arg(long, conflicts_with = "power", allow_hyphen_values = true)]
    torque: Option<Quantity<Torque>>,

    /// Power into the input: 75 kW; needs --speed.
    #[arg(long, requires = "speed", allow_hyphen_values = true)]
    power: Option<Quantity<Power>>,

    /// Speed of the input: 1475 rpm.
    #[arg(long, visible_alias = "input", allow_hyphen_values = true)]
    speed: Option<Quantity<AngularVelocity>>,
}

impl Load {
    /// An option that is given.
    pub(crate) fn given(&self) -> Option<&'static str> {
        let torque = self.torque.map(|_| "--torque");
        torque.or(self.power.map(|_| "--power")).or(self.speed.map(|_| "--speed"))
    }

    pub(crate) fn input(&self) -> Input {
        let torque = self.torque.map(|torque| InputLoad::Torque(torque.0));
        let load = torque.or(self.power.map(|power| InputLoad::Power(power.0)));
        Input { speed: self.speed.map(|speed| speed.0), load }
    }
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

fn inputs(call: &Call<'_>, args: &Args, subject: &Subject<'_>, gear: &str) -> Result<(), Failure> {
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

/// Names to choose from, each on a line of its own.
fn below_each_other<'n>(names: impl IntoIterator<Item = &'n str>) -> String {
    names.into_iter().map(|name| format!("\n  {name}")).collect()
}

/// Converts an error to a failure with the option that caused it.
pub(crate) fn refuse(error: Error) -> Failure {
    let listed = |names: &[String]| below_each_other(names.iter().map(String::as_str));
    let (option, message) = match &error {
        Error::OneGearbox => {
            ("--transmission", "the file holds one gearbox; leave the option out".to_owned())
        }
        Error::SeveralTransmissions { names } => {
            ("--transmission", format!("the file has {}; name one of{}", names.len(), listed(names)))
        }
        Error::NoTransmission { name, names } => {
            ("--transmission", format!("no name in the file has `{name}` in it; there are{}", listed(names)))
        }
        Error::AmbiguousTransmission { name, names } => (
            "--transmission",
            format!("`{name}` is part of several names; write more of one of{}", listed(names)),
        ),
        Error::NoGear { .. } => ("--gear", error.to_string()),
        Error::ProgressionFactor { .. } => ("--progression", error.to_string()),
        Error::Load { quantity: LoadQuantity::Torque, .. } => ("--torque", error.to_string()),
        Error::Load { quantity: LoadQuantity::Power, .. } => ("--power", error.to_string()),
        Error::NoLink { given, .. } | Error::Inputs { given, .. } => {
            let option = match given {
                Given::Speeds => "--speeds",
                Given::Torques => "--torques",
                Given::Map => "--map",
            };
            (option, error.to_string())
        }
        _ => return error.into(),
    };
    Failure::named(error.name(), option, message)
}

/// Reads the gearbox of a file; refuses a list of several transmissions without a choice of one.
pub(crate) fn subject<'d>(choice: &Choice, document: &'d Document) -> Result<Subject<'d>, Failure> {
    gearbox::one(document, &choice.question()?).map_err(refuse)
}

/// The analysis of a gear that `--gear` names.
pub(crate) fn analysis<'g>(gearbox: &'g Gearbox, gear: &str) -> Result<Analysis<'g>, Failure> {
    answers::analysis(gearbox, gear).map_err(refuse)
}

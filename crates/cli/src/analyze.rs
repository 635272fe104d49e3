//! The command `analyze`: what a gearbox does in each of its gears.

mod combinations;
mod gear;
mod inputs;
mod overview;
mod planet_bearings;
mod shared;
mod subject;

use crate::failure::Failure;
use crate::input;
use crate::output::OutputArgs;
use crate::report::Report;
use epicyclic_formats::{Document, Quantity};
use epicyclic_train::{Analysis, Error, Gearbox, InputLoad};
pub(crate) use overview::fast_planets;
use std::path::{Path, PathBuf};
use subject::Content;
pub(crate) use subject::{Subject, efficiency};
use uom::si::f64::{AngularVelocity, Power, Ratio, Torque};

/// A planetary gearbox from a file: ratios, speeds, torques, powers and losses of its gears.
///
/// Without --gear a table of all gears and of what is engaged in each; with --gear everything about one. Speeds are
/// multiples of the input's speed, torques of the input's torque and powers of what enters, unless --speed, --torque
/// or --power say more. A negative torque or power brakes the machine: power then runs from the output to the input.
/// A gear that keeps freedoms, such as a power split, takes --speeds of several links and --torques at some.
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Example:
  printf 'gearbox: conveyor\\ninput: D\\noutput: B\\nsets:\\n' > box.yaml
  printf '  - id: P\\n    sun: D\\n    ring: T1\\n    carrier: B\\n' >> box.yaml
  printf '    k: 2.94\\n    efficiency: 0.97\\n' >> box.yaml
  printf 'brakes: [{ id: K1, link: T1 }]\\n' >> box.yaml
  printf 'clutches: [{ id: K2, links: [D, B] }]\\ngears:\\n' >> box.yaml
  printf '  - { name: slow, engaged: [K1] }\\n' >> box.yaml
  printf '  - { name: fast, engaged: [K2] }\\n' >> box.yaml
  epicyclic analyze box.yaml
  epicyclic analyze box.yaml --gear slow --torque '500 N·m'

Keys of the file:
  gearbox, input, output: its name, and the links where power enters and leaves
  sets: id, sun, ring, carrier (links), k or teeth: [sun, ring], and optionally
        kind, planet_teeth, planets, efficiency or meshes; for the forces on
        planets module or carrier_radius, and planet_mass, or face_width and
        planet_bore; for their bearings' life load_rating, bearing_rolling
  compound_sets: id, carrier, suns, rings (link: teeth), planet_gears (name:
        [teeth]), meshes (gears: [one, other], efficiency), and optionally
        planets, bevels_left, bevels_right, planet_shafts
  brakes: id, link            clutches: id, links: [one, other], or of a one-way
                              clutch one_way: [not slower, than this]
  gears: name, engaged, and optionally input, output, speeds, torques
  links, grounds, ties, density, pressure_angle, note: optional
or a list `transmissions` with published ratios, as in
examples/real-transmissions.yaml.")]
pub(crate) struct Args {
    #[command(flatten)]
    choice: Choice,

    /// One gear, in full.
    #[arg(long, value_name = "NAME")]
    gear: Option<String>,

    /// Every set of brakes and clutches, with its state.
    #[arg(long, conflicts_with_all = ["gear", "torque", "power", "speed"])]
    all_combinations: bool,

    #[command(flatten)]
    several: inputs::Several,

    #[command(flatten)]
    load: Load,

    #[command(flatten)]
    output: OutputArgs,
}

/// Which gearbox.
#[derive(Debug, clap::Args)]
pub(crate) struct Choice {
    /// The file, in YAML.
    #[arg(value_name = "FILE")]
    file: PathBuf,

    /// One transmission of a list: its name, or a part that no other name has.
    #[arg(long, value_name = "NAME")]
    transmission: Option<String>,

    /// Efficiency under a carrier at rest of each set for which the file states no losses: 0.97 or 97%. Of a compound
    /// set each mesh takes its square root.
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    efficiency: Option<Quantity<Ratio>>,
}

impl Choice {
    /// An option that is given.
    pub(crate) fn given(&self) -> Option<&'static str> {
        let transmission = self.transmission.as_ref().map(|_| "--transmission");
        transmission.or(self.efficiency.map(|_| "--efficiency"))
    }

    /// One gearbox of a file, all of it as its options would say.
    pub(crate) fn new(
        file: PathBuf,
        transmission: Option<String>,
        efficiency: Option<Quantity<Ratio>>,
    ) -> Self {
        Self { file, transmission, efficiency }
    }

    /// The file.
    pub(crate) fn file(&self) -> &Path {
        &self.file
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

    fn input(&self) -> Input {
        let torque = self.torque.map(|torque| InputLoad::Torque(torque.0));
        let load = torque.or(self.power.map(|power| InputLoad::Power(power.0)));
        Input { speed: self.speed.map(|speed| speed.0), load }
    }
}

/// What is known of the input's motion and load.
#[derive(Debug, Clone, Copy)]
struct Input {
    speed: Option<AngularVelocity>,
    load: Option<InputLoad>,
}

/// Runs the command.
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let document = input::document(&args.choice.file)?;
    let report = match subject::read(&args.choice, &document, args.gear.is_some() || args.all_combinations)? {
        Content::Several(transmissions) => {
            if let Some(option) = args.choice.given().or(args.load.given()) {
                let names = subject::names(&transmissions);
                let message = format!(
                    "it is for one gearbox, and the file has {}; add --transmission with one of{names}",
                    transmissions.len()
                );
                return Err(Failure::Option { option, message });
            }
            subject::list(&transmissions)
        }
        Content::One(subject) => report(args, &subject, &document)?,
    };
    report.deliver(&args.output)
}

/// Everything about one gearbox, gear by gear.
pub(crate) struct Everything {
    pub(crate) subject: Subject,
    pub(crate) overview: Report,
    /// One a gear, in their order.
    pub(crate) gears: Vec<Report>,
}

/// The gearbox of a file, of which only one may be meant, and its place there.
pub(crate) fn gearbox(
    choice: &Choice,
    document: &Document,
) -> Result<(Gearbox, epicyclic_formats::Path), Failure> {
    let subject = only(choice, document)?;
    Ok((subject.gearbox, subject.base))
}

fn only(choice: &Choice, document: &Document) -> Result<Subject, Failure> {
    match subject::read(choice, document, true)? {
        Content::One(subject) => Ok(*subject),
        Content::Several(_) => unreachable!("one of several is asked for"),
    }
}

/// Everything about the gearbox of a file, of which only one may be meant.
pub(crate) fn everything(choice: &Choice, document: &Document, load: &Load) -> Result<Everything, Failure> {
    let subject = only(choice, document)?;
    let overview = overview::report(&subject, load.input())?;
    let gears = subject.gearbox.gears().iter();
    let gears = gears.map(|gear| gear::report(&subject, gear.name(), load.input()));
    Ok(Everything { gears: gears.collect::<Result<_, _>>()?, overview, subject })
}

fn report(args: &Args, subject: &Subject, document: &Document) -> Result<Report, Failure> {
    let input = args.load.input();
    match &args.gear {
        Some(name) if args.several.is_given() => inputs::report(subject, document, name, &args.several),
        Some(name) if args.load.given().is_none() && inputs::in_file(subject, name) => {
            inputs::report(subject, document, name, &args.several)
        }
        Some(name) => gear::report(subject, name, input),
        None if args.all_combinations => combinations::report(subject),
        None => overview::report(subject, input),
    }
}

/// The analysis with what the input's speed and load make of it.
struct Worked<'g> {
    analysis: Analysis<'g>,
    /// `None` where no load is given, or where the gear cannot take it.
    operation: Option<epicyclic_train::Operation>,
}

/// The analysis of a gear that `--gear` names.
pub(crate) fn analysis<'g>(gearbox: &'g Gearbox, gear: &str) -> Result<Analysis<'g>, Failure> {
    match gearbox.analyze(gear) {
        // With few short names, the nearest says less than all.
        Err(Error::Unknown { .. }) => {
            let all: Vec<&str> = gearbox.gears().iter().map(epicyclic_train::Gear::name).collect();
            let message = format!("no gear is called `{gear}`: there are {}", all.join(", "));
            Err(Failure::Option { option: "--gear", message })
        }
        analysis => Ok(analysis?),
    }
}

fn work<'g>(gearbox: &'g Gearbox, gear: &str, input: Input) -> Result<Worked<'g>, Failure> {
    let analysis = analysis(gearbox, gear)?;
    // At a torque alone, powers depend on a speed that nobody gave: none is shown.
    let speed =
        input.speed.unwrap_or(AngularVelocity::new::<uom::si::angular_velocity::radian_per_second>(1.0));
    let operation = match input.load.map(|load| analysis.at(speed, load)) {
        None | Some(Err(Error::NotDriven { .. })) => None,
        Some(Err(Error::OperatingPoint { why })) => {
            let option = if matches!(input.load, Some(InputLoad::Power(_))) { "--power" } else { "--torque" };
            return Err(Failure::Option { option, message: format!("{why} (gear {gear})") });
        }
        Some(operation) => Some(operation?),
    };
    Ok(Worked { analysis, operation })
}

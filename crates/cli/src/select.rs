//! The command `select`: which gearbox gives these speeds.

mod candidates;
mod duty;
mod measures;
mod teeth;
mod why;
mod winner;

use crate::failure::Failure;
use crate::lists::{List, Numbers, Quantities};
use crate::output::OutputArgs;
use epicyclic_formats::{Number, Physical, Quantity, Span};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_schemes::structures::Structure;
use epicyclic_selection::drawing::drawable_direct_clutches;
use epicyclic_selection::quantity::{KRange, Limited, Rated};
use epicyclic_selection::{
    Limits, Objective, Order, Orders, Rating, RatioSeries, Requirements, SelectionError, Signs, Space,
    select_with,
};
use uom::si::f64::{Length, Pressure, Ratio, Velocity};

/// The planetary gearbox for two or three speeds: every scheme measured, judged and compared.
///
/// The fastest speed is direct drive; the others give the ratios wanted of one or two braked gears. Each mechanism is
/// tried with both orders of the ratios and both signs, its row parameters follow, and every criterion is stated with
/// what it found. Nothing is weighed: of what meets the criteria, the order of objectives picks the first, and the
/// front is what no other design beats in everything.
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Example:
  epicyclic select --speeds '0.8 m/s, 3.15 m/s'
  epicyclic select --speeds '0.76 m/s, 1.33 m/s, 1.95 m/s' --all-structures
  epicyclic select --ratios '1.465, 2.56' --teeth --ring ..90 --limit 5
  epicyclic select --speeds '0.8 m/s, 3.15 m/s' --power 75kW --input 1475rpm

Objectives of --order: efficiency (the least of a gear), speed (the largest of a
link, or of a planet on its carrier), parameter (distance of ln k from --prefer),
error (of a ratio), size (of the largest ring at one load of the teeth).")]
pub(crate) struct Args {
    /// Speeds of the machine, the slowest first.
    #[arg(long, required_unless_present = "ratios", conflicts_with = "ratios", allow_hyphen_values = true)]
    speeds: Option<Quantities<Velocity>>,

    /// Ratios of the braked gears, in place of speeds: one or two.
    #[arg(long, allow_hyphen_values = true)]
    ratios: Option<Numbers>,

    /// All 111 structures of two rows (or the 6 of one), and not only the source's.
    #[arg(long)]
    all_structures: bool,

    /// Tooth numbers of both rows: all tooth sets, none left out.
    #[arg(long)]
    teeth: bool,

    /// Show at most this many designs. Default: 10 in a table, otherwise all; of tooth numbers 10, up to 10000.
    #[arg(long, value_name = "N")]
    limit: Option<usize>,

    /// What decides first, and what next where that is equal: size, efficiency.
    #[arg(long, value_name = "OBJECTIVES", default_value = "efficiency, speed, parameter, error, size")]
    order: List<Objective>,

    #[command(flatten)]
    wanted: Wanted,

    #[command(flatten)]
    criteria: Criteria,

    #[command(flatten)]
    duty: duty::Duty,

    #[command(flatten)]
    size: Size,

    #[command(flatten)]
    teeth_bounds: teeth::Bounds,

    #[command(flatten)]
    output: OutputArgs,
}

/// How the ratios are taken.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Ratios")]
struct Wanted {
    /// How far a ratio may be off: 10%, or 0.1.
    #[arg(long, default_value = "10%", allow_hyphen_values = true)]
    tolerance: Quantity<Ratio>,

    /// Which brake gives which ratio.
    #[arg(long, value_enum, default_value_t = Brakes::Either)]
    brakes: Brakes,

    /// Which signs the ratios may have; direct drive is positive.
    #[arg(long, value_enum, default_value_t = SignChoice::Alike)]
    signs: SignChoice,
}

/// Which brake gives which ratio.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Brakes {
    /// Either brake gives either ratio.
    Either,
    /// The first brake gives the first ratio.
    AsGiven,
}

/// Which signs the ratios may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum SignChoice {
    /// All positive, or all negative.
    Alike,
    /// Each by itself.
    Any,
    /// Those of --ratios.
    AsGiven,
}

/// What a design has to meet.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Criteria")]
struct Criteria {
    /// Row parameters allowed, ring over sun.
    #[arg(long, value_name = "RANGE", default_value = "1.3..10")]
    k: Span<f64>,

    /// Row parameters preferred.
    #[arg(long, value_name = "RANGE", default_value = "2.5..3")]
    prefer: Span<f64>,

    /// Efficiency of each row under a resting carrier, 0.97 or 97%.
    #[arg(long, value_name = "NUMBER", default_value = "0.9702", allow_hyphen_values = true)]
    efficiency: Quantity<Ratio>,

    /// Least efficiency of a gear.
    #[arg(long, value_name = "NUMBER", default_value = "0.9", allow_hyphen_values = true)]
    least_efficiency: Quantity<Ratio>,

    /// Greatest speed of a link over the input's.
    #[arg(long, value_name = "NUMBER", default_value = "2", allow_negative_numbers = true)]
    link_speed: Number,

    /// Greatest speed of a planet on its carrier over the input's.
    #[arg(long, value_name = "NUMBER", default_value = "2", allow_negative_numbers = true)]
    planet_speed: Number,

    /// Greatest slip of the open locking clutch over the input's speed.
    #[arg(long, value_name = "NUMBER", default_value = "2", allow_negative_numbers = true)]
    clutch_slip: Number,

    /// Refuse what turns the output one way in a braked gear and the other way in direct drive.
    #[arg(long)]
    one_sense: bool,

    /// Accept schemes that cannot be drawn without links crossing.
    #[arg(long)]
    allow_crossing: bool,
}

/// What sizes are measured by.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Size")]
struct Size {
    /// Load factor K of the sun's teeth, 2 MPa: with --torque or --power sizes are lengths.
    #[arg(long, requires = "load", allow_hyphen_values = true)]
    load_factor: Option<Quantity<Pressure>>,

    /// Face width over the pitch diameter of the smaller of sun and planet; with --load-factor.
    #[arg(
        long,
        value_name = "NUMBER",
        requires = "load_factor",
        default_value = "1",
        allow_negative_numbers = true
    )]
    face_width_ratio: Number,

    /// Planets of each row, where no teeth say.
    #[arg(long, value_name = "N", default_value = "3")]
    planets: u32,

    /// How much more than its share the most loaded of 2, 3, … 8 planets carries: seven numbers.
    #[arg(long, value_name = "NUMBERS")]
    load_sharing: Option<Numbers>,

    /// Greatest pitch diameter of a ring; with --teeth.
    #[arg(long, requires = "load_factor", requires = "teeth", allow_hyphen_values = true)]
    ring_diameter: Option<Quantity<Length>>,

    /// Least module that a row may need; with --teeth.
    #[arg(long, requires = "load_factor", requires = "teeth", allow_hyphen_values = true)]
    least_module: Option<Quantity<Length>>,

    /// Greatest module that a row may need; with --teeth.
    #[arg(long, requires = "load_factor", requires = "teeth", allow_hyphen_values = true)]
    greatest_module: Option<Quantity<Length>>,
}

/// Runs the command.
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let requirements = requirements(args)?;
    let order = Order::new(&args.order.0).map_err(refuse)?;
    if args.teeth {
        return teeth::run(args, &requirements, order);
    }
    let space = if args.all_structures { Space::All } else { Space::Catalogue };
    let found = select_with(&requirements, &space, order, Some(&drawable_direct_clutches)).map_err(refuse)?;
    candidates::report(args, &requirements, order, &found)?.deliver(&args.output)?;
    if found.accepted.is_empty() { Err(nothing_found()) } else { Ok(()) }
}

/// The answer says why; this says it to whoever sees only the end.
fn nothing_found() -> Failure {
    Failure::NothingFound("no design meets every criterion".to_owned())
}

/// The structures that the search goes through.
fn structures(args: &Args) -> Vec<Structure> {
    if args.all_structures { Structure::all() } else { Structure::catalogue() }
}

fn requirements(args: &Args) -> Result<Requirements, Failure> {
    let series = match (&args.speeds, &args.ratios) {
        (Some(speeds), _) => RatioSeries::of_speeds(&speeds.values()),
        (None, ratios) => {
            let ratios: Vec<f64> =
                ratios.iter().flat_map(|ratios| &ratios.0).map(|ratio| ratio.get()).collect();
            RatioSeries::new(&ratios)
        }
    };
    let criteria = &args.criteria;
    let range =
        |option, span: Span<f64>, usual| span.within(usual).map_err(|error| Failure::Range { option, error });
    let usual = Limits::default();
    let eta0 = MeshEfficiency::new(criteria.efficiency.0.si())
        .map_err(|error| Failure::Option { option: "--efficiency", message: error.to_string() })?;
    Ok(Requirements {
        tolerance: args.wanted.tolerance.0.si(),
        orders: match args.wanted.brakes {
            Brakes::Either => Orders::Both,
            Brakes::AsGiven => Orders::AsGiven,
        },
        signs: match args.wanted.signs {
            SignChoice::Alike => Signs::Alike,
            SignChoice::Any => Signs::Any,
            SignChoice::AsGiven => Signs::AsGiven,
        },
        limits: Limits {
            ring_to_sun: range("--k", criteria.k, usual.ring_to_sun)?,
            preferred: range("--prefer", criteria.prefer, usual.preferred)?,
            efficiency: criteria.least_efficiency.0.si(),
            link_speed: criteria.link_speed.get(),
            planet_speed: criteria.planet_speed.get(),
            clutch_slip: criteria.clutch_slip.get(),
            same_direction: criteria.one_sense,
            drawable: !criteria.allow_crossing,
        },
        eta0,
        rating: rating(args)?,
        ..Requirements::new(series.map_err(refuse)?)
    })
}

fn rating(args: &Args) -> Result<Rating, Failure> {
    let size = &args.size;
    let usual = Rating::default();
    let mesh_load_factors = match &size.load_sharing {
        None => usual.mesh_load_factors,
        Some(numbers) => {
            let numbers: Vec<f64> = numbers.0.iter().map(|number| number.get()).collect();
            let count = numbers.len();
            numbers.try_into().map_err(|_| Failure::Option {
                option: "--load-sharing",
                message: format!("{count} numbers where seven are due, for 2 to 8 planets"),
            })?
        }
    };
    Ok(Rating {
        load: args.duty.torque()?.zip(size.load_factor.map(|factor| factor.0)),
        face_width_ratio: size.face_width_ratio.get(),
        mesh_load_factors,
        planets: size.planets,
    })
}

/// The option that a refusal speaks of.
fn refuse(error: SelectionError) -> Failure {
    use SelectionError as E;
    let option = match &error {
        E::SpeedCount { .. } | E::SpeedsOutOfOrder { .. } => "--speeds",
        E::RatioCount { .. } | E::Ratio { .. } | E::EqualRatios { .. } => "--ratios",
        E::Tolerance { .. } => "--tolerance",
        E::RingToSunRange { what: KRange::Preferred, .. } => "--prefer",
        E::RingToSunRange { .. } => "--k",
        E::Limit { what: Limited::Efficiency, .. } => "--least-efficiency",
        E::Limit { what: Limited::LinkSpeed, .. } => "--link-speed",
        E::Limit { what: Limited::PlanetSpeed, .. } => "--planet-speed",
        E::Limit { what: Limited::ClutchSlip, .. } => "--clutch-slip",
        E::Limit { what: Limited::Module, .. } => "--least-module, --greatest-module",
        E::Limit { what: Limited::RingDiameter, .. } | E::SizeWithoutTorque => "--ring-diameter",
        E::Rating { what: Rated::MeshLoadFactor, .. } => "--load-sharing",
        E::Rating { what: Rated::FaceWidthRatio, .. } => "--face-width-ratio",
        E::Rating { what: Rated::LoadFactor, .. } => "--load-factor",
        E::PlanetNumber { .. } => "--planets",
        E::TooManyToothSets { .. } => "--sun, --planet, --ring, --k",
        E::TooManyWindows { .. } => "--sun, --planet, --ring, --k, --all-structures",
        E::TooManyPairs { .. } | E::FrontTooLarge { .. } => "--sun, --planet, --ring, --k, --tolerance",
        E::GearSet(error) => match crate::options::of_teeth(error, "--planet-count") {
            Some(option) => option,
            None => return Failure::Selection(SelectionError::GearSet(error.clone())),
        },
        E::RepeatedObjective { .. } | E::UnknownObjective { .. } => "--order",
        _ => return Failure::Selection(error),
    };
    Failure::Option { option, message: error.to_string() }
}

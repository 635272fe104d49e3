//! The command `motor search`: the Pareto front of hydromotors for a displacement or torque.

use super::design::refuse;
use super::{Files, files};
use crate::failure::Failure;
use crate::lists::Quantities;
use crate::output::{Format, OutputArgs, complain};
use crate::progress::Progress;
use epicyclic_answers as answers;
use epicyclic_answers::motor_search::Wanted;
use epicyclic_formats::{Number, Physical, Quantity, Span};
use epicyclic_hydromotor::checks::ToothHeights;
use epicyclic_hydromotor::numbers::Bounds;
use epicyclic_hydromotor::profile::ToothForm;
use epicyclic_hydromotor::search::{Limits, LobeDivisor, MotorSearch, Requirements, Size, SizeLimits};
use std::str::FromStr;
use uom::si::f64::{Angle, AngularVelocity, Length, Pressure, Ratio, Torque, Volume};

/// Designs shown in a table unless said otherwise.
const SHOWN_IN_TABLE: usize = 12;

/// Places of families that are tried in a second, about.
const PLACES_IN_A_SECOND: f64 = 2e4;

/// Non-dominated motors for a displacement or torque.
///
/// Every set of lobes and teeth is tried at places along its whole family; of those that pass the checks and limits, the motors
/// remain that no other surpasses in displacement over volume, ripple and least curvature radius together. The module is
/// chosen from a list and the width follows, or the other way round. Between the places tried a motor may be better: by how much is
/// estimated and said. Checks take the default teeth of `motor`. Ranges include both ends and may be open: 3..6, ..90.
#[derive(Debug, clap::Args)]
#[command(group = clap::ArgGroup::new("wanted").required(true))]
#[command(override_usage = "\
epicyclic motor search [OPTIONS] --displacement <DISPLACEMENT>
       epicyclic motor search [OPTIONS] --torque <TORQUE> --pressure <PRESSURE>")]
#[command(after_help = "\
Example:
  epicyclic motor search --torque '600 N·m' --pressure '20 MPa' \\
      --module '2 mm' --stator 5..6 --z3 ..66 --ripple '10 %'")]
pub(crate) struct Args {
    /// Displacement wanted: '250 cm3/rev'.
    #[arg(long, group = "wanted", allow_hyphen_values = true)]
    displacement: Option<Displacement>,

    /// Mean torque wanted, without losses.
    #[arg(long, group = "wanted", requires = "pressure", allow_hyphen_values = true)]
    torque: Option<Quantity<Torque>>,

    /// Pressure drop, high less low.
    #[arg(long, allow_hyphen_values = true)]
    pressure: Option<Quantity<Pressure>>,

    /// Speed of the rotor, for flow and power.
    #[arg(long, allow_hyphen_values = true)]
    speed: Option<Quantity<AngularVelocity>>,

    /// Modules to choose from: '2 mm, 2.5 mm'. Default: the first series of ISO 54, unless the width is given.
    #[arg(long, value_name = "MODULES", allow_hyphen_values = true)]
    module: Option<Quantities<Length>>,

    /// Width; alone it gives the module, with --module the displacement.
    #[arg(long, allow_hyphen_values = true)]
    width: Option<Quantity<Length>>,

    /// How far the displacement may lie from the wanted one, where module and width are given: 2%, or 0.02.
    #[arg(long, default_value = "2%", requires = "module", requires = "width", allow_hyphen_values = true)]
    tolerance: Quantity<Ratio>,

    /// Width over the stator's diameter, which then gives both module and width.
    #[arg(long, value_name = "NUMBER", conflicts_with_all = ["module", "width"], allow_negative_numbers = true)]
    width_over_diameter: Option<Number>,

    /// Greatest diameter of the stator's centrode.
    #[arg(long, allow_hyphen_values = true)]
    outer_diameter: Option<Quantity<Length>>,

    /// Greatest ripple of flow and torque: 8%, or 0.08.
    #[arg(long, allow_hyphen_values = true)]
    ripple: Option<Quantity<Ratio>>,

    /// Lobes of the stator.
    #[arg(long, value_name = "LOBES", default_value = "2..10")]
    stator: Span<u32>,

    /// Lobes of the rotor.
    #[arg(long, value_name = "LOBES", default_value = "1..10")]
    rotor: Span<u32>,

    /// Teeth of the stator.
    #[arg(long, value_name = "TEETH", default_value = "1..120")]
    z3: Span<u32>,

    /// Teeth of a satellite.
    #[arg(long, value_name = "TEETH", default_value = "8..60")]
    zs: Span<u32>,

    /// Common divisor of N and n: above 1 the wheels' bearings are unloaded, 1 makes for little ripple.
    #[arg(long, value_enum, default_value_t = Divisor::Any)]
    divisor: Divisor,

    /// Only designs on which the default teeth of `motor` keep their limits. They are taken from the front: motors that it
    /// surpasses are not brought back for their teeth.
    #[arg(long)]
    with_teeth: bool,

    /// What the designs are ordered by; the first is the one that is drawn.
    #[arg(long, value_enum, default_value_t = Order::Volume)]
    by: Order,

    /// Places along each interval of a family, before refinement.
    #[arg(long, value_name = "NUMBER", default_value_t = 16)]
    places: u32,

    /// Difference in the objectives below which motors of one set count as one.
    #[arg(long, default_value = "2%", allow_hyphen_values = true)]
    resolution: Quantity<Ratio>,

    /// Show every design in the table, not only the first of each set of lobes and teeth.
    #[arg(long)]
    every: bool,

    /// Show at most this many designs. Default: 12 in a table, otherwise all.
    #[arg(long, value_name = "N")]
    limit: Option<usize>,

    /// Number of the design that is drawn, or whose centrodes are written. Default: 1.
    #[arg(long, value_name = "N")]
    design: Option<usize>,

    /// Angle of the rotor in the drawing. Default: 0.
    #[arg(long, allow_hyphen_values = true)]
    angle: Option<Quantity<Angle>>,

    #[command(flatten)]
    files: Files,

    #[command(flatten)]
    output: OutputArgs,
}

/// A volume a revolution, with or without `/rev`.
#[derive(Debug, Clone, Copy)]
struct Displacement(Volume);

impl FromStr for Displacement {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let volume = text.trim();
        let volume = ["/rev", "/r"].iter().find_map(|mark| volume.strip_suffix(mark)).unwrap_or(volume);
        let volume: Quantity<Volume> =
            volume.parse().map_err(|error| format!("{error}; as in 250 cm3/rev"))?;
        Ok(Self(volume.0))
    }
}

/// What is asked of the common divisor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Divisor {
    /// Nothing.
    Any,
    /// That it is 1.
    One,
    /// That it is above 1.
    Common,
}

/// What the designs are ordered by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Order {
    /// The most displacement over volume first.
    Volume,
    /// The least ripple first.
    Ripple,
    /// The greatest least curvature radius first.
    Radius,
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let (drawings, output) = (files::wanted(&args.files, &args.output), args.output.but_for_drawings());
    drawings.check(&args.files)?;
    if args.angle.is_some() {
        drawings.needed_by("--angle")?;
    }
    let has_files = !drawings.is_empty() || args.files.csv.is_some();
    if args.design.is_some() && !has_files {
        let message = "it is for drawings and centrodes; give --svg, --dxf or --csv, or an --output that ends in .svg, .dxf, .pdf \
                       or .png";
        return Err(Failure::Option { option: "--design", message: message.to_owned() });
    }
    let format = output.format();
    let wanted = Wanted {
        search: search(args)?,
        with_teeth: args.with_teeth,
        order: match args.by {
            Order::Volume => answers::motor_search::Order::Volume,
            Order::Ripple => answers::motor_search::Order::Ripple,
            Order::Radius => answers::motor_search::Order::Radius,
        },
        first_of_each_set: format == Format::Table && !args.every,
        most: args.limit.unwrap_or(if format == Format::Table { SHOWN_IN_TABLE } else { usize::MAX }),
    };
    let shown = Progress::new();
    let searched = answers::motor_search::search(&wanted, &|at| {
        let share = at.done as f64 / at.of.max(1) as f64;
        if at.pass == 0 {
            let places = at.of as f64 * f64::from(wanted.search.points);
            shown.size(places, PLACES_IN_A_SECOND, || {
                format!("{} sets of lobes and teeth, {places:.1e} places at least", at.of)
            });
            shown.at(share);
        } else {
            shown.at_pass(at.pass, share);
        }
    });
    drop(shown);
    let searched = searched.map_err(refuse)?;
    let files = if has_files {
        let angle = args.angle.map_or_else(Angle::default, |angle| angle.0);
        let designed = searched.motor(args.design.unwrap_or(1), angle).map_err(refuse)?;
        files::content(&args.files, &drawings, &designed)?
    } else {
        vec![]
    };
    let answer = searched.answer();
    output.deliver_with(files, &answer)?;
    if format != Format::Table && answer.hidden > 0 {
        complain(&format!("note: {}", epicyclic_views::motor_search::count(&answer)));
    }
    Ok(())
}

fn search(args: &Args) -> Result<MotorSearch, Failure> {
    let requirements = match (args.displacement, args.torque, args.pressure) {
        (Some(displacement), ..) => Requirements::of_displacement(displacement.0),
        (_, Some(torque), Some(pressure)) => {
            Requirements::of_torque(torque.0, pressure.0).map_err(|error| refuse(error.into()))?
        }
        _ => unreachable!("one of them is required, and the pressure with the torque"),
    };
    let size = match (&args.module, args.width, args.width_over_diameter) {
        (Some(modules), Some(width), _) => Size::ModulesAndWidth {
            modules: modules.values(),
            width: width.0,
            tolerance: args.tolerance.0.si(),
        },
        (Some(modules), ..) => Size::Modules(modules.values()),
        (_, Some(width), _) => Size::Width(width.0),
        (.., Some(part)) => Size::WidthOverDiameter(part.get()),
        _ => Size::default(),
    };
    let usual = Bounds::default();
    let range =
        |option, span: Span<u32>, usual| span.within(usual).map_err(|error| Failure::Range { option, error });
    // The teeth that `motor` makes by default.
    let form = ToothForm::default();
    let addendum = form.addendum + form.shift;
    Ok(MotorSearch {
        bounds: Bounds {
            stator_lobes: range("--stator", args.stator, usual.stator_lobes)?,
            stator_teeth: range("--z3", args.z3, usual.stator_teeth)?,
            satellite_teeth: range("--zs", args.zs, usual.satellite_teeth)?,
        },
        heights: ToothHeights { addendum, dedendum: addendum + form.clearance },
        limits: Limits {
            size: SizeLimits {
                outer_diameter: args.outer_diameter.map(|diameter| diameter.0),
                ..SizeLimits::default()
            },
            ripple: args.ripple.map(|ripple| ripple.0.si()),
            rotor_lobes: range("--rotor", args.rotor, 1..=10)?,
            divisor: match args.divisor {
                Divisor::Any => LobeDivisor::Any,
                Divisor::One => LobeDivisor::One,
                Divisor::Common => LobeDivisor::Common,
            },
            ..Limits::default()
        },
        points: args.places,
        resolution: Some(args.resolution.0.si()),
        ..MotorSearch::new(Requirements {
            pressure_drop: args.pressure.map(|pressure| pressure.0),
            speed: args.speed.map(|speed| speed.0),
            size,
            ..requirements
        })
    })
}

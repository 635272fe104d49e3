//! The command `motor search`: the Pareto front of hydromotors for a displacement or torque.

mod answer;
mod funnel;

use super::design::{Chosen, Drawn, refuse};
use super::{Files, files};
use crate::failure::Failure;
use crate::lists::Quantities;
use crate::output::{Format, OutputArgs, complain};
use epicyclic_formats::{Number, Physical, Quantity, Span};
use epicyclic_hydromotor::checks::ToothHeights;
use epicyclic_hydromotor::closure::Family;
use epicyclic_hydromotor::numbers::Bounds;
use epicyclic_hydromotor::profile::limits::Limit;
use epicyclic_hydromotor::profile::{Profile, ToothForm};
use epicyclic_hydromotor::search::{
    Demand, Design, Dimensions, Limits, LobeDivisor, MotorSearch, Size, SizeLimits,
};
use std::collections::HashSet;
use std::str::FromStr;
use uom::si::f64::{Angle, AngularVelocity, Length, Pressure, Ratio, Torque, Volume};

/// Designs shown in a table unless said otherwise.
const SHOWN_IN_TABLE: usize = 12;

/// Motors for a displacement or torque that no other surpasses.
///
/// Every set of lobes and teeth is tried at places along its whole family; of those that pass the checks and limits, the motors
/// remain that none surpasses in displacement over volume, ripple and least curvature radius together. The module is
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

    /// Number of the design that is drawn, or whose centrodes are written.
    #[arg(long, requires = "files", value_name = "N", default_value_t = 1)]
    design: usize,

    /// Angle of the rotor in the drawing.
    #[arg(long, default_value = "0 deg", requires = "drawing", allow_hyphen_values = true)]
    angle: Quantity<Angle>,

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
    let search = search(args)?;
    let mut found = search.front().map_err(refuse)?;
    if found.designs.is_empty() {
        return Err(Failure::NoMotor { funnel: funnel::in_short(&found) });
    }
    let all = found.designs.len();
    if args.with_teeth {
        found.designs.retain(|design| teeth(design) == Teeth::Hold);
        if found.designs.is_empty() {
            let funnel =
                format!("on none of the {all} designs that pass do the default teeth keep their limits");
            return Err(Failure::NoMotor { funnel });
        }
    }
    match args.by {
        Order::Volume => {}
        Order::Ripple => found.designs.sort_by(|one, other| one.ripple.total_cmp(&other.ripple)),
        Order::Radius => found.designs.sort_by(|one, other| other.least_radius.total_cmp(&one.least_radius)),
    }
    let Some(drawn) = args.design.checked_sub(1).and_then(|place| found.designs.get(place)) else {
        let message = format!("{}: there are designs 1 to {}", args.design, found.designs.len());
        return Err(Failure::Option { option: "--design", message });
    };
    let files = if args.files.are_wanted() {
        files::content(&args.files, &self::drawn(args, drawn)?)?
    } else {
        vec![]
    };
    let format = args.output.format;
    let limit = args.limit.unwrap_or(if format == Format::Table { SHOWN_IN_TABLE } else { usize::MAX });
    let mut seen = HashSet::new();
    let apart = format == Format::Table && !args.every;
    let numbered = found.designs.iter().enumerate();
    let listed: Shown = numbered.filter(|(_, design)| !apart || seen.insert(design.numbers)).collect();
    let shown = &listed[..limit.min(listed.len())];
    let hidden = listed.len() - shown.len();
    let report = answer::report(&search, &found, shown, hidden, all);
    args.output.deliver_report(files, &report)?;
    if format != Format::Table && hidden > 0 {
        complain(&format!("note: {} designs found, {} shown", found.designs.len(), shown.len()));
    }
    Ok(())
}

fn search(args: &Args) -> Result<MotorSearch, Failure> {
    let demand = match (args.displacement, args.torque, args.pressure) {
        (Some(displacement), ..) => Demand::of_displacement(displacement.0),
        (_, Some(torque), Some(pressure)) => Demand::of_torque(torque.0, pressure.0).map_err(refuse)?,
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
        ..MotorSearch::new(Demand {
            pressure_drop: args.pressure.map(|pressure| pressure.0),
            speed: args.speed.map(|speed| speed.0),
            size,
            ..demand
        })
    })
}

/// Designs with their places in the order.
type Shown<'a> = Vec<(usize, &'a Design)>;

/// The size that is shown of a design: the one whose width is nearest to half its diameter.
fn shown_size(design: &Design) -> Option<&Dimensions> {
    let off = |size: &&Dimensions| (size.width.si() / size.outer_diameter.si() - 0.5).abs();
    design.dimensions.iter().min_by(|one, other| off(one).total_cmp(&off(other)))
}

fn drawn(args: &Args, design: &Design) -> Result<Drawn, Failure> {
    let Some(size) = shown_size(design) else { unreachable!("a design has a size") };
    let motor = design.motor(size.module).map_err(refuse)?;
    let form = ToothForm::default();
    Ok(Drawn {
        profile: Profile::new(&motor, form),
        family: Some(Family::new(design.numbers, size.module).map_err(refuse)?),
        motor,
        chosen: Chosen::Given,
        form,
        width: Some(size.width),
        pressure: args.pressure.map(|pressure| pressure.0),
        speed: args.speed.map(|speed| speed.0),
        angle: args.angle.0,
    })
}

/// Whether the default teeth keep their limits on a design.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Teeth {
    Hold,
    Fail,
    /// There are none of that form.
    None,
}

fn teeth(design: &Design) -> Teeth {
    let Some(size) = shown_size(design) else { return Teeth::None };
    match design.motor(size.module).and_then(|motor| Profile::new(&motor, ToothForm::default())) {
        Ok(profile) if profile.limits().iter().all(Limit::holds) => Teeth::Hold,
        Ok(_) => Teeth::Fail,
        Err(_) => Teeth::None,
    }
}

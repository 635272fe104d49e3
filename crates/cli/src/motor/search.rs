//! The command `motor search`: the Pareto front of hydromotors for a displacement or torque.

use super::design::{Chosen, Drawn, refuse};
use super::lists::subject;
use super::{Files, files};
use crate::failure::Failure;
use crate::figure::{Figure, column, text};
use crate::lists::Quantities;
use crate::output::{Format, OutputArgs, complain, save};
use crate::report::{Column, Part, Records, Report, Row, Section, View};
use epicyclic_formats::quantity::format::{self, trimmed};
use epicyclic_formats::{Dimension, Number, Physical, Quantity, Span};
use epicyclic_hydromotor::checks::ToothHeights;
use epicyclic_hydromotor::closure::Family;
use epicyclic_hydromotor::numbers::Bounds;
use epicyclic_hydromotor::profile::limits::Limit;
use epicyclic_hydromotor::profile::{Profile, ToothForm};
use epicyclic_hydromotor::search::{
    Demand, Design, Dimensions, Found, Limits, LobeDivisor, MotorSearch, Reason, Size, SizeLimits,
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
    #[arg(long, default_value = "2%", allow_hyphen_values = true)]
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

    /// Number of the design that is drawn.
    #[arg(long, value_name = "N", default_value_t = 1)]
    design: usize,

    /// Angle of the rotor in the drawing.
    #[arg(long, default_value = "0 deg", allow_hyphen_values = true)]
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
        return Err(Failure::NoMotor { funnel: in_short(&found) });
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
    let report = report(&search, &found, shown, hidden, all);
    for (file, content) in &files {
        save(file, content)?;
    }
    report.deliver(&args.output)?;
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

fn report(
    search: &MotorSearch,
    found: &Found,
    shown: &[(usize, &Design)],
    hidden: usize,
    all: usize,
) -> Report {
    let wanted = format::quantity(search.demand.displacement, 5);
    let count = match found.designs.len() {
        1 => "1 design".to_owned(),
        more => format!("{more} designs"),
    };
    let mut parts = vec![Part::Records(designs(found, shown, hidden)), Part::Records(sizes(shown))];
    parts.push(Part::Facts(Section {
        name: "funnel",
        title: "Motors tried, and where the others fell: the first reason counts",
        columns: &[],
        rows: funnel(found, all),
        note: "",
    }));
    parts.push(Part::Facts(Section {
        name: "spacing_error",
        title: "Between the places tried a motor may be better than a listed one, by estimate",
        columns: SPACING,
        rows: vec![
            spacing("most", "at most, in every objective", found.spacing_error),
            spacing("refinement_gain", "refinement found better by", found.refinement_gain),
        ],
        note: "",
    }));
    Report {
        title: Some(format!("Hydromotors of {wanted} a revolution: {count} that no other surpasses")),
        parts,
        warnings: None,
    }
}

const SPACING: &[(&str, &str)] =
    &[("displacement_by_volume", "q/V"), ("ripple", "ripple"), ("least_radius", "radius")];

fn spacing(
    name: &'static str,
    label: &'static str,
    error: epicyclic_hydromotor::search::SpacingError,
) -> Row {
    let values = [error.displacement_by_volume, error.ripple, error.least_radius];
    Row::new(name, label, "", values.map(Figure::Share))
}

fn designs(found: &Found, shown: &[(usize, &Design)], hidden: usize) -> Records {
    let row = |&(place, design): &(usize, &Design)| {
        let numbers = design.numbers;
        let modules: Vec<String> =
            design.dimensions.iter().map(|size| trimmed(1e3 * size.module.si(), 4)).collect();
        let l_over_module =
            shown_size(design).map_or(f64::NAN, |size| size.trough_distance.si() / size.module.si());
        vec![
            count(place + 1),
            text(format!("{}×{}", numbers.stator_lobes(), numbers.rotor_lobes())),
            Figure::Count(numbers.stator_lobes()),
            Figure::Count(numbers.rotor_lobes()),
            text(format!(
                "{}/{}/{}",
                numbers.stator_teeth(),
                numbers.rotor_teeth(),
                numbers.satellite_teeth()
            )),
            Figure::Count(numbers.stator_teeth()),
            Figure::Count(numbers.rotor_teeth()),
            Figure::Count(numbers.satellite_teeth()),
            Figure::Multiple(l_over_module),
            Figure::Multiple(design.displacement_by_volume),
            Figure::Share(design.ripple),
            Figure::Multiple(design.least_radius),
            match teeth(design) {
                Teeth::Hold => Figure::Answer("hold", "hold"),
                Teeth::Fail => Figure::Answer("fail", "fail"),
                Teeth::None => Figure::Answer("none", "none"),
            },
            Figure::Answer(subject(design.nearest_check).0, short(design.nearest_check)),
            Figure::Share(design.nearest_margin),
            count(found.designs.iter().filter(|other| other.numbers == numbers).count()),
            Figure::Texts(modules),
            Figure::Share(design.spacing_error.displacement_by_volume),
            Figure::Share(design.spacing_error.ripple),
            Figure::Share(design.spacing_error.least_radius),
        ]
    };
    let hidden = match hidden {
        0 => String::new(),
        1 => " 1 more: --limit shows it.".to_owned(),
        hidden => format!(" {hidden} more: --limit shows them."),
    };
    Records {
        name: "designs",
        columns: vec![
            Column::number("design", "no"),
            Column::words("lobes", "N×n"),
            Column::number("stator_lobes", "N"),
            Column::number("rotor_lobes", "n"),
            Column::words("teeth", "Z₃/Z₁/Z_s"),
            Column::number("stator_teeth", "Z₃"),
            Column::number("rotor_teeth", "Z₁"),
            Column::number("satellite_teeth", "Z_s"),
            Column::number("l_over_module", "l/m"),
            Column::number("displacement_by_volume", "q/V"),
            Column::number("ripple", "ripple"),
            Column::number("least_radius_in_modules", "ϱ/m"),
            Column::words("teeth_limits", "teeth"),
            Column::words("nearest_check", "nearest limit"),
            Column::number("nearest_margin", "spare"),
            Column::number("designs_of_the_set", "of set"),
            Column::words("modules_mm", "modules, mm"),
            Column::number("spacing_error_displacement_by_volume", ""),
            Column::number("spacing_error_ripple", ""),
            Column::number("spacing_error_least_radius", ""),
        ],
        rows: shown.iter().map(row).collect(),
        views: vec![View {
            note: format!(
                "q/V: displacement over the cylinder about the stator's centrode. ϱ: least curvature radius of \
                 both centrodes. Teeth: whether the default form keeps its limits, which the search does not ask. \
                 Of set: designs of these numbers, of which the first is shown unless --every is given.{hidden}"
            ),
            ..View::new(
                "Designs",
                &[
                    "design",
                    "lobes",
                    "teeth",
                    "displacement_by_volume",
                    "ripple",
                    "least_radius_in_modules",
                    "nearest_check",
                    "teeth_limits",
                    "designs_of_the_set",
                ],
            )
        }],
        is_answer: true,
    }
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

fn count(count: usize) -> Figure {
    Figure::Count(u32::try_from(count).unwrap_or(u32::MAX))
}

const fn short(check: epicyclic_hydromotor::checks::Subject) -> &'static str {
    use epicyclic_hydromotor::checks::Subject;
    match check {
        Subject::StatorBulge => "stator bulge",
        Subject::StatorHollow => "stator hollow",
        Subject::RotorBulge => "rotor bulge",
        Subject::RotorHollow => "rotor hollow",
        Subject::RotorLeastRadius => "rotor body",
        Subject::Neighbours => "neighbours",
    }
}

fn sizes(shown: &[(usize, &Design)]) -> Records {
    let row = |&(place, design): &(usize, &Design)| {
        let size = shown_size(design);
        let modules: Vec<String> =
            design.dimensions.iter().map(|size| trimmed(1e3 * size.module.si(), 4)).collect();
        vec![
            count(place + 1),
            column(size.map(|size| size.module)),
            column(size.map(|size| size.width)),
            column(size.map(|size| size.outer_diameter)),
            column(size.map(|size| size.trough_distance)),
            column(size.map(|size| size.crest_distance)),
            column(size.map(|size| size.trough_radius)),
            column(size.map(|size| size.crest_radius)),
            column(size.map(|size| size.displacement)),
            column(size.and_then(|size| size.torque)),
            column(size.and_then(|size| size.least_torque)),
            column(size.and_then(|size| size.flow)),
            column(size.and_then(|size| size.power)),
            Figure::Texts(modules),
        ]
    };
    let length = |name, heading: &str| Column {
        heading: heading.to_owned(),
        ..Column::quantity(name, Dimension::Length)
    };
    let other = |name, heading: &str, dimension| Column {
        heading: heading.to_owned(),
        ..Column::quantity(name, dimension)
    };
    let mut columns = vec!["design", "module", "width", "outer_diameter", "l", "a"];
    let first = shown.first().and_then(|(_, design)| shown_size(design));
    let several = shown.iter().any(|(_, design)| design.dimensions.len() > 1);
    if first.is_some_and(|size| size.torque.is_some()) {
        columns.push("torque");
        columns.push("least_torque");
    }
    if first.is_some_and(|size| size.flow.is_some()) {
        columns.push("flow");
    }
    if first.is_some_and(|size| size.power.is_some()) {
        columns.push("power");
    }
    if several && columns.len() < 9 {
        columns.push("modules_mm");
    }
    Records {
        name: "sizes",
        columns: vec![
            Column::number("design", "no"),
            length("module", "m, mm"),
            length("width", "b, mm"),
            length("outer_diameter", "Ø, mm"),
            length("l", "l, mm"),
            length("a", "a, mm"),
            length("r1", "R₁, mm"),
            length("r2", "R₂, mm"),
            other("displacement", "q, cm³", Dimension::Volume),
            other("torque", "M, N·m", Dimension::Torque),
            other("least_torque", "least", Dimension::Torque),
            other("flow", "l/min", Dimension::VolumeRate),
            other("power", "kW", Dimension::Power),
            Column::words("modules_mm", "all m, mm"),
        ],
        rows: shown.iter().map(row).collect(),
        views: vec![View {
            note: "Of the modules that serve, the one whose width is nearest to half the diameter. Ø of the \
                   stator's centrode; teeth and housing come on top. Torque and power without losses."
                .to_owned(),
            ..View::new("Sizes", &columns)
        }],
        is_answer: false,
    }
}

const fn reason(reason: Reason) -> (&'static str, &'static str) {
    use epicyclic_hydromotor::checks::Subject;
    match reason {
        Reason::NotClosed => ("not_closed", "does not close, at an end"),
        Reason::Check(Subject::StatorBulge) => ("stator_bulge", "roots in the stator's bulges"),
        Reason::Check(Subject::StatorHollow) => ("stator_hollow", "satellite in the stator's hollows"),
        Reason::Check(Subject::RotorBulge) => ("rotor_bulge", "roots in the rotor's bulges"),
        Reason::Check(Subject::RotorHollow) => ("rotor_hollow", "satellite in the rotor's hollows"),
        Reason::Check(Subject::RotorLeastRadius) => ("rotor_least_radius", "rotor without a body"),
        Reason::Check(Subject::Neighbours) => ("neighbours", "satellites' tips meet"),
        Reason::LeastRadius => ("least_radius", "curvature radius wanted"),
        Reason::Size => ("size", "no size within the limits"),
        Reason::Ripple => ("ripple", "ripple wanted"),
    }
}

fn funnel(found: &Found, all: usize) -> Vec<Row> {
    let funnel = &found.funnel;
    let row = |name, label, value| Row::new(name, label, "", [count(value)]);
    let mut rows = vec![
        row("sets", "sets of lobes and teeth", funnel.sets),
        row("outside_limits", "… outside limits of the rotor", funnel.outside_limits),
        row("without_family", "… with which no motor closes", funnel.without_family),
        row("places", "motors at even places", funnel.points),
        row("refined", "motors added by refinement", funnel.refined),
    ];
    for each in Reason::ALL {
        let (name, label) = reason(each);
        let refused = funnel.refused(each);
        if refused > 0 {
            rows.push(Row { remark: "refused".to_owned(), ..row(name, label, refused) });
        }
    }
    rows.push(row("accepted", "motors that pass", funnel.accepted));
    rows.push(row("front", "… that no other surpasses", funnel.front));
    rows.push(row("apart", "designs, alike ones once", all));
    if found.designs.len() < all {
        rows.push(row("with_teeth", "… on which the default teeth hold", found.designs.len()));
    }
    rows
}

/// What refused every motor, the most frequent reason first.
fn in_short(found: &Found) -> String {
    let funnel = &found.funnel;
    let mut refused: Vec<(usize, &str)> = Reason::ALL
        .iter()
        .map(|&each| (funnel.refused(each), reason(each).1))
        .filter(|one| one.0 > 0)
        .collect();
    refused.sort_by(|one, other| other.0.cmp(&one.0));
    let reasons: Vec<String> = refused.iter().map(|(count, words)| format!("{words} {count}")).collect();
    let reasons =
        if reasons.is_empty() { String::new() } else { format!("; refused: {}", reasons.join(", ")) };
    format!(
        "{} sets of lobes and teeth, {} outside limits, {} close no motor, {} motors tried{reasons}",
        funnel.sets,
        funnel.outside_limits,
        funnel.without_family,
        funnel.points + funnel.refined
    )
}

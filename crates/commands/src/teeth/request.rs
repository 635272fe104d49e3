//! The command `teeth`: every set of tooth numbers for a ratio.

use crate::desk::{Call, Content};
use crate::failure::Failure;
use crate::output::{Format, OutputArgs};
use crate::progress::Progress;
use crate::shared::options;
use crate::shared::profile_shift::ShiftOptions;
use crate::teeth::answer::{IN_A_SECOND, Stages, Wanted, answer, double_planet, shifted, stages};
use epicyclic_formats::Span;
use epicyclic_formats::gearbox::written;
use epicyclic_gears::Error;
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::simple_set::Mode;
use epicyclic_gears::synthesis::{Bounds, Placement};
use epicyclic_train::Gearbox;
use epicyclic_units::format::trimmed;
use epicyclic_units::{Number, Physical, Quantity};
use std::ops::RangeInclusive;
use std::path::PathBuf;
use uom::si::f64::{Angle, Ratio};

/// Sets shown in a table unless said otherwise.
const SHOWN_IN_TABLE: usize = 20;

/// Every set of tooth numbers of a simple or double-planet gear set for a ratio.
///
/// The tooth numbers of a set fit together: sun, planets and ring share one centre distance, the planets
/// clear each other and assemble. Of a double-planet set the ratio leaves the planets open: each pair of sun
/// and ring stands once, with one choice of planets. With --ring-offset the ring may depart from the rule of
/// equal centre distances, and profile shifts make up for it. The most exact come first. Ranges include both
/// ends and may be open: 12..40, 17.., ..=200, 20.
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    /// Wanted ratio, input speed over output speed; negative for opposite directions of rotation.
    #[arg(long, allow_negative_numbers = true)]
    ratio: Number,

    /// Input, output and fixed member: ab^H, aH^b, bH^a, ba^H, Ha^b or Hb^a, with sun a, ring b and carrier
    /// H.
    #[arg(long, default_value = "aH^b", value_parser = mode)]
    mode: Mode,

    /// Greatest error of the ratio, below 100%: 1%, or 0.01.
    #[arg(long, default_value = "1%", allow_hyphen_values = true)]
    tolerance: Quantity<Ratio>,

    /// Double-planet sets: pairs of planets in mesh with each other, one with the sun, the other with the
    /// ring.
    #[arg(long, conflicts_with = "ring_offset")]
    double_planet: bool,

    #[command(flatten)]
    shifts: ShiftOptions,

    /// Number of planets, or of pairs of planets, from 2 to 8.
    #[arg(long, default_value = "3..8")]
    planets: Span<u32>,

    /// Teeth of the sun.
    #[arg(long, default_value = "12..200")]
    sun: Span<u32>,

    /// Teeth of a planet, of a double-planet set of each of the two.
    #[arg(long, default_value = "12..200")]
    planet: Span<u32>,

    /// Teeth of the ring.
    #[arg(long, default_value = "12..200")]
    ring: Span<u32>,

    /// Ring-to-sun ratio k.
    #[arg(long, default_value = "1.3..10")]
    k: Span<f64>,

    /// Spacing of the planets.
    #[arg(long, value_enum, default_value_t = Spacing::Equal)]
    spacing: Spacing,

    /// Least gap between the tips of neighbouring planets, in modules.
    #[arg(long, default_value = "0", allow_negative_numbers = true)]
    tip_gap: Number,

    /// Addendum coefficient of the basic rack: tips of planets, and undercut.
    #[arg(long, default_value = "1", allow_negative_numbers = true)]
    addendum: Number,

    /// Pressure angle of the basic rack: undercut.
    #[arg(long, value_name = "ANGLE", default_value = "20deg", allow_hyphen_values = true)]
    pressure_angle: Quantity<Angle>,

    /// Leave out sets in which the rack would undercut sun or planet.
    #[arg(long, conflicts_with = "ring_offset")]
    no_undercut: bool,

    /// Show at most this many sets. Default: 20 in a table, otherwise all, up to 100000.
    #[arg(long, value_name = "N")]
    limit: Option<usize>,

    /// Write the most exact set as a gearbox file without losses that analyze, draw and report read.
    #[arg(long, value_name = "FILE")]
    save: Option<PathBuf>,

    /// With --save: the set with this number in place of the most exact; the checks told are of its teeth.
    #[arg(long, value_name = "N", requires = "save", default_value = "1")]
    nth: usize,

    #[command(flatten)]
    output: OutputArgs,
}

/// Where the planets may stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Spacing {
    /// Equal angles only.
    Equal,
    /// The assembly positions nearest to equal angles, where equal angles do not assemble.
    LeastUnequal,
}

fn mode(text: &str) -> Result<Mode, String> {
    Mode::ALL.into_iter().find(|mode| mode.to_string() == text).ok_or_else(|| {
        let all: Vec<String> = Mode::ALL
            .iter()
            .map(|mode| format!("{mode} ({} to {}, {} at rest)", mode.input(), mode.output(), mode.fixed()))
            .collect();
        format!("write one of {}", all.join(", "))
    })
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let bounds = bounds(args)?;
    let format = args.output.format();
    let limit = args.limit.unwrap_or(if format == Format::Table { SHOWN_IN_TABLE } else { usize::MAX });
    let nth = args.save.as_ref().map_or(0, |_| args.nth);
    let wanted = Wanted {
        ratio: args.ratio.get(),
        mode: args.mode,
        tolerance: args.tolerance.0.si(),
        bounds,
        // The set to save may lie beyond the sets shown.
        most: limit.max(nth),
        checked: args.nth,
    };
    let shown = Progress::new(call);
    let parts = wanted.bounds.space(args.double_planet).map_err(refuse)? as f64;
    let gears = if args.double_planet {
        "sun, ring and pairs of planets"
    } else {
        "sun, planet and number of planets"
    };
    shown.size(parts, IN_A_SECOND, || format!("{parts:.1e} combinations of {gears}"));
    if let Some(shifts) = args.shifts.wanted() {
        let found = shifted::answer(&wanted, &shifts, |share| shown.at(share)).map_err(refuse_answer)?;
        // Removes the progress line before the answer is written to the same terminal.
        drop(shown);
        let chosen = nth.checked_sub(1).and_then(|place| found.tooth_numbers.get(place));
        let chosen = chosen.map(|set| set.gearbox(&wanted)).transpose()?;
        let files = save(args, &wanted, chosen, found.found)?;
        let mut told = found;
        told.tooth_numbers.truncate(limit);
        told.shown = told.tooth_numbers.len();
        args.output.deliver_with(call, files, &told)?;
        note(call, format, told.found, told.shown);
    } else if args.double_planet {
        let found = double_planet::answer(&wanted, |share| shown.at(share)).map_err(refuse_answer)?;
        drop(shown);
        let chosen = nth.checked_sub(1).and_then(|place| found.tooth_numbers.get(place));
        let chosen = chosen.map(|set| set.gearbox(&wanted)).transpose()?;
        let files = save(args, &wanted, chosen, found.found)?;
        let mut told = found;
        told.tooth_numbers.truncate(limit);
        told.shown = told.tooth_numbers.len();
        args.output.deliver_with(call, files, &told)?;
        note(call, format, told.found, told.shown);
    } else {
        let found = answer(&wanted, |share| shown.at(share)).map_err(|error| refuse_one(error, &wanted))?;
        drop(shown);
        let chosen = nth.checked_sub(1).and_then(|place| found.tooth_numbers.get(place));
        let chosen = chosen.map(|set| set.gearbox(&wanted)).transpose()?;
        let files = save(args, &wanted, chosen, found.found)?;
        let mut told = found;
        told.tooth_numbers.truncate(limit);
        told.shown = told.tooth_numbers.len();
        args.output.deliver_with(call, files, &told)?;
        note(call, format, told.found, told.shown);
    }
    Ok(())
}

/// Says beside a list for programs that it is not whole.
fn note(call: &Call<'_>, format: Format, found: u64, shown: usize) {
    if format != Format::Table && (shown as u64) < found {
        call.complain(&format!("note: {}", crate::teeth::table::count(found, shown)));
    }
}

/// The file of --save with its content.
fn save(args: &Args, wanted: &Wanted, chosen: Option<Gearbox>, found: u64) -> Result<Vec<Content>, Failure> {
    let Some(file) = &args.save else { return Ok(vec![]) };
    let Some(gearbox) = chosen else {
        let message = format!("{}: there are sets 1 to {found}", args.nth);
        return Err(Failure::no_such_design(message));
    };
    let comment = format!(
        "Set {} of {found} found by epicyclic teeth for the ratio {} ({}), without losses.",
        args.nth, wanted.ratio, wanted.mode
    );
    let text = written(&gearbox, &[comment]).map_err(|error| Failure::Format(error.to_string()))?;
    Ok(vec![(file.clone(), text.into_bytes())])
}

/// A ratio that one set has not may be that of several in series.
fn refuse_one(error: crate::error::Error, wanted: &Wanted) -> Failure {
    let crate::error::Error::Gear(error @ Error::NoToothNumbers { .. }) = error else {
        return refuse_answer(error);
    };
    let hint = match stages(wanted) {
        Ok(Some(Stages { sets, ratio, others })) => {
            let each = trimmed(ratio, 4);
            let others = match (others, sets) {
                (None, _) => String::new(),
                (Some(others), 2) => format!(", the other one in mode {others}"),
                (Some(others), _) => format!(", the others in mode {others}"),
            };
            format!("; {sets} sets in series have it, each with a ratio of about {each}{others}")
        }
        _ => String::new(),
    };
    Failure::NoToothNumbers { error, hint }
}

fn refuse_answer(error: crate::error::Error) -> Failure {
    match error {
        crate::error::Error::Gear(error) => refuse(error),
        error @ crate::error::Error::TooMany { found, most } => Failure::named(
            error.name(),
            "--limit",
            format!(
                "{found} sets of tooth numbers are within the tolerance and at most {most} are written: narrow --tolerance, --k \
                 or the ranges of teeth, or ask for the most exact with --limit {most}"
            ),
        ),
        error => error.into(),
    }
}

fn refuse(error: Error) -> Failure {
    match options::of_teeth(&error, "--planets") {
        Some(option) => Failure::of_option(option, &error),
        None => error.into(),
    }
}

fn bounds(args: &Args) -> Result<Bounds, Failure> {
    let usual = Bounds::default();
    let rack = BasicRack {
        addendum: args.addendum.get(),
        pressure_angle: args.pressure_angle.0,
        ..BasicRack::default()
    };
    rack.check().map_err(refuse)?;
    let least = if args.no_undercut { rack.least_teeth_without_undercut() } else { 1 };
    let external = |option, span: Span<u32>, usual: RangeInclusive<u32>| {
        let (from, most) = options::of_wheel(option, span, usual)?.into_inner();
        // Without undercut the range of teeth starts at the smallest gear that has none.
        let from = from.max(least);
        if from > most { Err(Failure::AllUndercut { option, most, least }) } else { Ok(from..=most) }
    };
    Ok(Bounds {
        sun: external("--sun", args.sun, usual.sun)?,
        planet: external("--planet", args.planet, usual.planet)?,
        ring: options::of_wheel("--ring", args.ring, usual.ring)?,
        planets: closed("--planets", args.planets, usual.planets)?,
        ring_to_sun_ratio: closed("--k", args.k, usual.ring_to_sun_ratio)?,
        rack,
        tip_gap: args.tip_gap.get(),
        placement: match args.spacing {
            Spacing::Equal => Placement::Equal,
            Spacing::LeastUnequal => Placement::LeastUnequal,
        },
    })
}

fn closed<T: epicyclic_formats::range::End>(
    option: &'static str,
    span: Span<T>,
    usual: RangeInclusive<T>,
) -> Result<RangeInclusive<T>, Failure> {
    span.closed(usual).map_err(|error| Failure::Range { option, error })
}

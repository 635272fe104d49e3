//! The command `teeth`: every set of tooth numbers for a ratio.

use crate::failure::Failure;
use crate::options;
use crate::output::{Format, OutputArgs, complain};
use crate::progress::Progress;
use epicyclic_answers as answers;
use epicyclic_answers::teeth::{Wanted, answer};
use epicyclic_formats::{Number, Physical, Quantity, Span};
use epicyclic_gears::Error;
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::simple_set::Mode;
use epicyclic_gears::synthesis::{Bounds, Placement};
use std::ops::RangeInclusive;
use uom::si::f64::{Angle, Ratio};

/// Sets shown in a table unless said otherwise.
const SHOWN_IN_TABLE: usize = 20;

/// Every set of tooth numbers of a simple planetary gear set for a ratio.
///
/// The tooth numbers of a set fit together: sun, planets and ring share one centre distance, the planets clear each other and
/// assemble. The most exact come first. Ranges include both ends and may be open: 12..40, 17.., ..=200, 20.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  epicyclic teeth --ratio 6 --planets 4 --no-undercut")]
pub(crate) struct Args {
    /// Wanted ratio, input speed over output speed; negative for opposite directions of rotation.
    #[arg(long, allow_negative_numbers = true)]
    ratio: Number,

    /// Input, output and fixed member: ab^H, aH^b, bH^a, ba^H, Ha^b or Hb^a, with sun a, ring b and carrier H.
    #[arg(long, default_value = "aH^b", value_parser = mode)]
    mode: Mode,

    /// Greatest error of the ratio, below 100%: 1%, or 0.01.
    #[arg(long, default_value = "1%", allow_hyphen_values = true)]
    tolerance: Quantity<Ratio>,

    /// Number of planets, from 2 to 8.
    #[arg(long, default_value = "3..8")]
    planets: Span<u32>,

    /// Teeth of the sun.
    #[arg(long, default_value = "12..200")]
    sun: Span<u32>,

    /// Teeth of a planet.
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
    #[arg(long)]
    no_undercut: bool,

    /// Show at most this many sets. Default: 20 in a table, otherwise all, up to 100000.
    #[arg(long, value_name = "N")]
    limit: Option<usize>,

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
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let bounds = bounds(args)?;
    let shown = Progress::new();
    let format = args.output.format;
    let limit = args.limit.unwrap_or(if format == Format::Table { SHOWN_IN_TABLE } else { usize::MAX });
    let wanted = Wanted {
        ratio: args.ratio.get(),
        mode: args.mode,
        tolerance: args.tolerance.0.si(),
        bounds,
        most: limit,
    };
    let answer = answer(&wanted, |share| shown.at(share)).map_err(|error| match error {
        answers::Error::Gear(error) => refuse(error),
        answers::Error::TooMany { found, most } => Failure::Option {
            option: "--limit",
            message: format!(
                "{found} sets of tooth numbers are within the tolerance and at most {most} are written: narrow --tolerance, --k \
                 or the ranges of teeth, or ask for the most exact with --limit {most}"
            ),
        },
        error => error.into(),
    })?;
    drop(shown);
    args.output.deliver(&answer)?;
    if format != Format::Table && (answer.shown as u64) < answer.found {
        complain(&format!("note: {}", epicyclic_views::teeth::count(&answer)));
    }
    Ok(())
}

fn refuse(error: Error) -> Failure {
    match options::of_teeth(&error, "--planets") {
        Some(option) => Failure::Option { option, message: error.to_string() },
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
    span.within(usual).map_err(|error| Failure::Range { option, error })
}

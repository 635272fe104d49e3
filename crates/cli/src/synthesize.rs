//! The command `synthesize`: every gearbox that has a list of ratios.

use crate::failure::Failure;
use crate::output::{Format, OutputArgs, complain};
use crate::progress::Progress;
use crate::ratios::Ratios;
use epicyclic_answers as answers;
use epicyclic_answers::synthesize::{MOST_SOLUTIONS, Wanted, answer};
use epicyclic_formats::{Number, Physical as _, Quantity, Span};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_synthesis::Kind;
use epicyclic_synthesis::limits::Limits;
use epicyclic_synthesis::rules::Rules;
use epicyclic_synthesis::shifts::Shifts;
use std::ops::{ControlFlow, RangeInclusive};
use uom::si::f64::Ratio;

/// The most shift elements that are searched.
const MOST_ELEMENTS: u32 = 7;

/// The most of them that a gear engages.
const MOST_ENGAGED: u32 = 4;

/// Solutions in a table unless said otherwise.
const SHOWN_IN_TABLE: usize = 20;

/// The k that may be asked for: below, planets have no teeth; above, no ring is that large.
const ANY_K: RangeInclusive<f64> = 1.05..=20.0;

/// Every gearbox of simple planet sets, brakes and clutches that has a list of ratios.
///
/// All structures of so many sets are searched, over all ring-to-sun ratios k in the range, not a grid of them. Numbers of sets
/// and shift elements that are a range are tried from the smallest up, until one has solutions.
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  epicyclic synthesize --ratios '2.56, 1.465' --sets 2 --elements 2 --engaged 1
  epicyclic synthesize --ratios '3.059, 1.625, 1, 0.696, -2.294' --sets 2 \\
      --elements 5 --engaged 2 --class all-sparse

A gear of n sets and L moving links engages L - n - 1 shift elements: of four
sets and eight links three. Class core takes a minute or two for four sets and
five shift elements, and much longer for six.")]
pub(crate) struct Args {
    /// Wanted ratios, input speed over output speed; negative for reverse. Commas, semicolons or spaces part them. Of a gear 4.714,
    /// 4.714±0.5%, 4.714±0.02, 4.5..4.9, ? (any between its neighbours), or in brackets where it may be missing: (-3.295).
    #[arg(long, allow_hyphen_values = true)]
    ratios: Ratios,

    /// How far a ratio may be off that has no tolerance of its own: 1%, or 0.01.
    #[arg(long, default_value = "1%", allow_hyphen_values = true)]
    tolerance: Quantity<Ratio>,

    /// Which structures are searched.
    #[arg(long, value_enum, default_value_t = Class::Core)]
    class: Class,

    /// Number of planet sets, at most 4.
    #[arg(long, default_value = "1..3")]
    sets: Span<u32>,

    /// Number of shift elements, at most 7.
    #[arg(long, default_value = "1..6")]
    elements: Span<u32>,

    /// Shift elements that a gear engages, at most 4. Default: 1..3; with --links or --open 1..4.
    #[arg(long)]
    engaged: Option<Span<u32>>,

    /// Number of moving links: sets, engaged elements and one more.
    #[arg(long)]
    links: Option<Span<u32>>,

    /// Shift elements that are open in a gear: those not engaged.
    #[arg(long)]
    open: Option<Span<u32>>,

    /// Ring-to-sun ratio k of every set.
    #[arg(long, default_value = "1.4..4.5")]
    k: Span<f64>,

    #[command(flatten)]
    kept: Kept,

    /// Efficiency of the meshes of a set: 0.97, or 97%.
    #[arg(long, default_value = "0.97", allow_hyphen_values = true)]
    efficiency: Quantity<Ratio>,

    /// Show at most this many gearboxes. Default: 20 in a table, otherwise all, up to 10000.
    #[arg(long, value_name = "N")]
    limit: Option<usize>,

    #[command(flatten)]
    output: OutputArgs,
}

/// What a gearbox has to keep besides its ratios.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "What else is wanted")]
struct Kept {
    /// Number of brakes among the shift elements.
    #[arg(long, value_name = "RANGE", default_value = "0..7")]
    brakes: Span<u32>,

    /// Number of clutches among the shift elements.
    #[arg(long, value_name = "RANGE", default_value = "0..7")]
    clutches: Span<u32>,

    /// Shifts between neighbouring forward gears: single ones open one element and engage one.
    #[arg(long, value_enum, default_value_t = ShiftChoice::Any)]
    shifts: ShiftChoice,

    /// Shifts that skip a gear: 1–3, 2–4 and so on.
    #[arg(long, value_enum, default_value_t = ShiftChoice::Any)]
    skip_shifts: ShiftChoice,

    /// A gear is direct: it turns the gearbox as one block.
    #[arg(long)]
    direct: bool,

    /// Ratio steps between neighbouring forward gears.
    #[arg(long, value_name = "RANGE")]
    step: Option<Span<f64>>,

    /// Ratio steps fall from the first gear on: none is larger than the one before it.
    #[arg(long)]
    falling_steps: bool,

    /// Greatest slip of an open shift element over the input's speed.
    #[arg(long, value_name = "NUMBER", allow_negative_numbers = true)]
    slip: Option<Number>,

    /// Greatest speed of a link over the input's.
    #[arg(long, value_name = "NUMBER", allow_negative_numbers = true)]
    link_speed: Option<Number>,

    /// Greatest speed of a planet relative to its carrier over the input's.
    #[arg(long, value_name = "NUMBER", allow_negative_numbers = true)]
    planet_speed: Option<Number>,

    /// Only gearboxes that can be drawn: no link across another, each brake reached from the housing.
    #[arg(long)]
    drawable: bool,
}

/// Which shifts are allowed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum ShiftChoice {
    /// All; those with fewer multiple shifts are told first.
    Any,
    /// Those that exchange one element for one.
    Single,
}

/// Which structures are searched.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Class {
    /// No member on the housing, input and output on members, all sets joined.
    Core,
    /// Members may be on the housing, and shift elements alone may reach input or output.
    AllSparse,
}

/// Runs the command.
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let tolerance = args.tolerance.0.si();
    if !(tolerance > 0.0 && tolerance < 1.0) {
        return Err(Failure::Option { option: "--tolerance", message: "above 0 and below 100 %".into() });
    }
    let efficiency = MeshEfficiency::new(args.efficiency.0.si())
        .map_err(|error| Failure::Option { option: "--efficiency", message: error.to_string() })?;
    let format = args.output.format;
    let most = args.limit.unwrap_or(if format == Format::Table { SHOWN_IN_TABLE } else { MOST_SOLUTIONS });
    let wanted = Wanted {
        gears: args.ratios.0.clone(),
        tolerance,
        kind: match args.class {
            Class::Core => Kind::Core,
            Class::AllSparse => Kind::AllSparse,
        },
        sets: counts("--sets", args.sets, 1..=4)?,
        elements: counts("--elements", args.elements, 1..=MOST_ELEMENTS)?,
        engaged: match args.engaged {
            Some(engaged) => counts("--engaged", engaged, 1..=MOST_ENGAGED)?,
            None if args.links.is_some() || args.open.is_some() => 1..=MOST_ENGAGED as usize,
            None => 1..=3,
        },
        links: args.links.map_or(Ok(0..=usize::MAX), |links| counts("--links", links, 3..=9))?,
        open: args.open.map_or(Ok(0..=usize::MAX), |open| counts("--open", open, 0..=MOST_ELEMENTS))?,
        k: args.k.within(ANY_K).map_err(|error| Failure::Range { option: "--k", error })?,
        rules: args.kept.rules()?,
        limits: args.kept.limits()?,
        drawable: args.kept.drawable,
        efficiency,
        most,
    };
    let shown = Progress::new();
    let found = answer(&wanted, &|_, at| {
        shown.at(at.done as f64 / at.of.max(1) as f64);
        ControlFlow::Continue(())
    })
    .map_err(|error| match error {
        answers::Error::Synthesis(error) => {
            Failure::Option { option: "--ratios", message: error.to_string() }
        }
        error => error.into(),
    })?;
    drop(shown);
    if found.found == 0 {
        let searched: Vec<String> = found
            .searched
            .iter()
            .map(|class| {
                format!(
                    "{} structures of {} sets with {} of {} shift elements engaged",
                    class.structures, class.sets, class.engaged, class.shift_elements
                )
            })
            .collect();
        return Err(Failure::NothingFound(format!(
            "no gearbox has these ratios: searched {}{}; try more --sets or --elements, --class all-sparse, a wider --tolerance or --k",
            searched.join(", "),
            epicyclic_views::synthesize::left_out_in_words(&found.left_out)
        )));
    }
    args.output.deliver(&found)?;
    if format != Format::Table && found.shown < found.found {
        complain(&format!("note: {}", epicyclic_views::synthesize::count(&found)));
    }
    Ok(())
}

impl Kept {
    fn rules(&self) -> Result<Rules, Failure> {
        let single = |choice| choice == ShiftChoice::Single;
        Ok(Rules {
            brakes: counts("--brakes", self.brakes, 0..=MOST_ELEMENTS)?,
            clutches: counts("--clutches", self.clutches, 0..=MOST_ELEMENTS)?,
            shifts: Shifts { neighbours: single(self.shifts), skips: single(self.skip_shifts) },
            direct: self.direct,
        })
    }

    fn limits(&self) -> Result<Limits, Failure> {
        let steps = self.step.map(|step| step.within(1.0..=f64::INFINITY)).transpose();
        let steps = steps.map_err(|error| Failure::Range { option: "--step", error })?;
        if steps.as_ref().is_some_and(|steps| *steps.start() < 1.0) {
            let message = "a step is the higher ratio over the next lower, at least 1".into();
            return Err(Failure::Option { option: "--step", message });
        }
        Ok(Limits {
            steps,
            falling_steps: self.falling_steps,
            slip: greatest("--slip", self.slip)?,
            link_speed: greatest("--link-speed", self.link_speed)?,
            planet_speed: greatest("--planet-speed", self.planet_speed)?,
        })
    }
}

fn greatest(option: &'static str, value: Option<Number>) -> Result<Option<f64>, Failure> {
    let value = value.map(Number::get);
    if value.is_some_and(|value| value <= 0.0) {
        return Err(Failure::Option { option, message: "must be above 0".into() });
    }
    Ok(value)
}

fn counts(
    option: &'static str,
    span: Span<u32>,
    within: RangeInclusive<u32>,
) -> Result<RangeInclusive<usize>, Failure> {
    let range = span.within(within).map_err(|error| Failure::Range { option, error })?;
    Ok(*range.start() as usize..=*range.end() as usize)
}

//! The command `synthesize`: every gearbox that has a list of ratios.

use crate::failure::Failure;
use crate::interrupt::Hearing;
use crate::output::{Format, OutputArgs, complain};
use crate::progress::Progress;
use crate::ratios::Ratios;
use crate::shards;
use epicyclic_answers as answers;
use epicyclic_answers::synthesize::{MOST_SOLUTIONS, Synthesis, Wanted, answer};
use epicyclic_formats::{Physical as _, Quantity, Span};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_synthesis::Kind;
use epicyclic_synthesis::work::Share;
use std::ops::{ControlFlow, RangeInclusive};
use std::path::PathBuf;
use uom::si::f64::Ratio;

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
    /// Wanted ratios, input speed over output speed; negative for reverse. Commas, semicolons or spaces part them.
    #[arg(long, allow_hyphen_values = true)]
    ratios: Ratios,

    /// How far each ratio may be off: 1%, or 0.01.
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

    /// Shift elements that a gear engages, at most 4.
    #[arg(long, default_value = "1..3")]
    engaged: Span<u32>,

    /// Ring-to-sun ratio k of every set.
    #[arg(long, default_value = "1.4..4.5")]
    k: Span<f64>,

    /// Efficiency of the meshes of a set: 0.97, or 97%.
    #[arg(long, default_value = "0.97", allow_hyphen_values = true)]
    efficiency: Quantity<Ratio>,

    /// Show at most this many gearboxes. Default: 20 in a table, otherwise all, up to 10000.
    #[arg(long, value_name = "N")]
    limit: Option<usize>,

    /// Search a share of the structures, the first of eight: 1/8. What it finds is a part, a Parquet table, in the file of --output. If
    /// it is ended, the same command goes on from --output with .progress at its end.
    #[arg(long, value_name = "I/N", requires = "output", conflicts_with_all = ["merge", "format", "limit"])]
    shard: Option<Share>,

    /// Take what was found from these parts of a search, all of its shares, instead of searching.
    #[arg(long, value_name = "PART", num_args = 1.., value_hint = clap::ValueHint::FilePath)]
    merge: Vec<PathBuf>,

    #[command(flatten)]
    output: OutputArgs,
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
        ratios: args.ratios.0.iter().map(|ratio| ratio.get()).collect(),
        tolerance,
        kind: match args.class {
            Class::Core => Kind::Core,
            Class::AllSparse => Kind::AllSparse,
        },
        sets: counts("--sets", args.sets, 1..=4)?,
        elements: counts("--elements", args.elements, 1..=7)?,
        engaged: counts("--engaged", args.engaged, 1..=4)?,
        k: args.k.within(ANY_K).map_err(|error| Failure::Range { option: "--k", error })?,
        efficiency,
        most,
    };
    if let (Some(share), Some(file)) = (args.shard, args.output.file()) {
        return shards::search(&wanted, share, file);
    }
    let (found, complete) = if args.merge.is_empty() {
        searched(&wanted)?
    } else {
        (shards::merged(&wanted, &args.merge)?, true)
    };
    let ended = || Failure::Interrupted("the search was ended before it was complete".into());
    if found.found == 0 && !complete {
        return Err(ended());
    }
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
            "no gearbox has these ratios: searched {}; try more --sets or --elements, --class all-sparse, a wider --tolerance or --k",
            searched.join(", ")
        )));
    }
    args.output.deliver(&found)?;
    if format != Format::Table && found.shown < found.found {
        complain(&format!("note: {}", epicyclic_views::synthesize::count(&found)));
    }
    if complete { Ok(()) } else { Err(ended()) }
}

/// The search, and whether it came to its end.
fn searched(wanted: &Wanted) -> Result<(Synthesis, bool), Failure> {
    let hearing = Hearing::new();
    let shown = Progress::new();
    let found = answer(wanted, &|_, at| {
        shown.at(at.done as f64 / at.of.max(1) as f64);
        if hearing.is_asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    })
    .map_err(of_ratios)?;
    drop(shown);
    let complete = found.complete;
    Ok((found, complete))
}

/// A refusal, at the option that it is about.
pub(crate) fn of_ratios(error: answers::Error) -> Failure {
    match error {
        answers::Error::Synthesis(error) => {
            Failure::Option { option: "--ratios", message: error.to_string() }
        }
        error => error.into(),
    }
}

fn counts(
    option: &'static str,
    span: Span<u32>,
    within: RangeInclusive<u32>,
) -> Result<RangeInclusive<usize>, Failure> {
    let range = span.within(within).map_err(|error| Failure::Range { option, error })?;
    Ok(*range.start() as usize..=*range.end() as usize)
}

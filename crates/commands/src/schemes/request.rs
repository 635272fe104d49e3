//! The command `schemes`: the catalogue of two- and three-speed schemes.

use crate::desk::Call;
use crate::failure::Failure;
use crate::output::OutputArgs;
use crate::schemes::answer::{self as schemes, Sizes};
use crate::shared::fault::Fault;
use crate::shared::named_gearbox::refuse_size;
use epicyclic_formats::Span;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_schemes::catalogue::RingToSunRange;
use epicyclic_units::{Number, Physical, Quantity};
use uom::si::f64::Ratio;

/// The catalogue of two- and three-speed schemes of planetary gearboxes.
///
/// Three of two speeds (I, II, III: one set, one brake, direct drive) and eleven of three (I-1 to III-3: two
/// sets, two brakes, direct drive). Without a name all of them; with one its links, formulas and ranges, and
/// for given k or ratios its numbers. D is the driving shaft, B the driven one, T1 and T2 are braked in gears
/// 1 and 2; k is the ring's teeth over the sun's.
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    /// I, II, III, I-1 … I-4, II-1 … II-4 or III-1 … III-3.
    #[arg(value_name = "SCHEME")]
    scheme: Option<String>,

    /// Ring-to-sun ratio of set 1.
    #[arg(long, group = "first", requires = "scheme", allow_negative_numbers = true)]
    k1: Option<Number>,

    /// Ring-to-sun ratio of set 2.
    #[arg(long, requires = "k1", conflicts_with = "ratio2", allow_negative_numbers = true)]
    k2: Option<Number>,

    /// Ratio of gear 1, in place of --k1.
    #[arg(long, group = "first", requires = "scheme", conflicts_with = "k1", allow_negative_numbers = true)]
    ratio1: Option<Number>,

    /// Ratio of gear 2, in place of --k2.
    #[arg(long, requires = "scheme", allow_negative_numbers = true)]
    ratio2: Option<Number>,

    /// Efficiency of each set with its carrier fixed, 0.97 or 97%; of a scheme with numbers.
    #[arg(
        long,
        value_name = "NUMBER",
        requires = "first",
        default_value = "0.9702",
        allow_hyphen_values = true
    )]
    efficiency: Quantity<Ratio>,

    /// Ring-to-sun ratios over which ranges of ratios are taken.
    #[arg(long, value_name = "RANGE", default_value = "1.7..7")]
    k: Span<f64>,

    #[command(flatten)]
    output: OutputArgs,
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let usual = RingToSunRange::USED;
    let span = args.k.closed(usual.low()..=usual.high());
    let span = span.map_err(|error| Failure::Range { option: "--k", error })?;
    let range = RingToSunRange::new(*span.start(), *span.end()).map_err(of_option("--k"))?;
    let eta0 = MeshEfficiency::new(args.efficiency.0.si()).map_err(of_option("--efficiency"))?;
    let Some(name) = &args.scheme else { return args.output.deliver(call, &schemes::list(range)) };
    let [k1, k2, ratio1, ratio2] =
        [args.k1, args.k2, args.ratio1, args.ratio2].map(|number| number.map(Number::get));
    let found = schemes::one(name.parse()?, range, Sizes { k1, k2, ratio1, ratio2 }, eta0);
    args.output.deliver(call, &found.map_err(refuse_size)?)
}

fn of_option<E: Fault>(option: &'static str) -> impl Fn(E) -> Failure {
    move |error| Failure::of_option(option, &error)
}

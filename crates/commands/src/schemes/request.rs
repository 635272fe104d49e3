//! The command `schemes`: the catalogue of two- and three-speed schemes.

use crate::desk::Call;
use crate::failure::Failure;
use crate::output::OutputArgs;
use crate::schemes::answer::{self as answers, Scheme, Schemes, Sizes};
use crate::shared::named_gearbox::refuse_size;
use crate::shared::options::efficiency;
use epicyclic_formats::Span;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_schemes::catalogue::RingToSunRange;
use epicyclic_units::{Number, Quantity};
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
    #[command(flatten)]
    request: Request,

    #[command(flatten)]
    output: OutputArgs,
}

/// Scheme of the catalogue, or all schemes, with the numbers that determine it.
#[derive(Debug, Clone, clap::Args)]
pub struct Request {
    /// I, II, III, I-1 … I-4, II-1 … II-4 or III-1 … III-3.
    #[arg(value_name = "SCHEME")]
    pub scheme: Option<String>,

    /// Ring-to-sun ratio of set 1.
    #[arg(long, group = "first", requires = "scheme", allow_hyphen_values = true)]
    pub k1: Option<Number>,

    /// Ring-to-sun ratio of set 2.
    #[arg(long, requires = "k1", conflicts_with = "ratio2", allow_hyphen_values = true)]
    pub k2: Option<Number>,

    /// Ratio of gear 1, in place of --k1.
    #[arg(long, group = "first", requires = "scheme", conflicts_with = "k1", allow_hyphen_values = true)]
    pub ratio1: Option<Number>,

    /// Ratio of gear 2, in place of --k2.
    #[arg(long, requires = "scheme", allow_hyphen_values = true)]
    pub ratio2: Option<Number>,

    /// Efficiency of each set with its carrier fixed, 0.97 or 97%; of a scheme with numbers.
    #[arg(
        long,
        value_name = "NUMBER",
        requires = "first",
        default_value = "0.9702",
        allow_hyphen_values = true
    )]
    pub efficiency: Quantity<Ratio>,

    /// Ring-to-sun ratios over which ranges of ratios are taken.
    #[arg(long, value_name = "RANGE", default_value = "1.7..7")]
    pub k: Span<f64>,
}

impl Request {
    /// Lists all schemes with their ratios over the range of k.
    ///
    /// # Errors
    /// [`Failure::Range`] or [`Failure::Option`] for an impossible k or efficiency.
    pub fn list(&self) -> Result<Schemes, Failure> {
        Ok(answers::list(self.range_and_efficiency()?.0))
    }

    /// Computes the scheme, and its numbers if ring-to-sun ratios or ratios are given.
    ///
    /// # Errors
    /// Those of [`Self::list`]; a name that is not in the catalogue or is missing; [`Failure::Option`] for
    /// ratios that the scheme does not have.
    pub fn answer(&self) -> Result<Scheme, Failure> {
        let (range, eta0) = self.range_and_efficiency()?;
        let name = self.scheme.as_ref().ok_or_else(|| Failure::missing("<SCHEME>", "name a scheme"))?;
        let [k1, k2, ratio1, ratio2] =
            [self.k1, self.k2, self.ratio1, self.ratio2].map(|number| number.map(Number::get));
        answers::one(name.parse()?, range, Sizes { k1, k2, ratio1, ratio2 }, eta0).map_err(refuse_size)
    }

    fn range_and_efficiency(&self) -> Result<(RingToSunRange, MeshEfficiency), Failure> {
        let usual = RingToSunRange::USED;
        let span = self.k.closed(usual.low()..=usual.high());
        let span = span.map_err(|error| Failure::Range { option: "--k", error })?;
        let range = RingToSunRange::new(*span.start(), *span.end())
            .map_err(|error| Failure::of_option("--k", &error))?;
        Ok((range, efficiency(self.efficiency)?))
    }
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let Args { request, output } = args;
    match request.scheme {
        None => output.deliver(call, &request.list()?),
        Some(_) => output.deliver(call, &request.answer()?),
    }
}

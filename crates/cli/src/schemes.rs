//! The command `schemes`: the catalogue of two- and three-speed schemes.

mod formulas;
mod list;
mod numbers;
mod one;

use crate::failure::Failure;
use crate::output::OutputArgs;
use epicyclic_formats::{Number, Physical, Quantity, Span};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::simple_set::RingToSunRatio;
use epicyclic_schemes::DesignError;
use epicyclic_schemes::catalogue::{RingToSunRange, Role, ThreeSpeed, TwoSpeed};
use epicyclic_train::Gearbox;
use uom::si::f64::Ratio;

/// The catalogue of two- and three-speed schemes of planetary gearboxes.
///
/// Three of two speeds (I, II, III: one row, one brake, direct drive) and eleven of three (I-1 to III-3: two rows, two
/// brakes, direct drive). Without a name all of them; with one its links, formulas and ranges, and for given k or
/// ratios its numbers. D is the driving shaft, B the driven one, T1 and T2 are braked in gears 1 and 2; k is the ring's
/// teeth over the sun's.
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Example:
  epicyclic schemes
  epicyclic schemes II-3 --k1 2.15 --k2 2.35
  epicyclic schemes II-3 --ratio1 1.465 --ratio2 2.56 --efficiency 0.97")]
pub(crate) struct Args {
    /// I, II, III, I-1 … I-4, II-1 … II-4 or III-1 … III-3.
    #[arg(value_name = "SCHEME")]
    scheme: Option<String>,

    /// Row parameter of row 1, ring over sun.
    #[arg(long, group = "first", requires = "scheme", allow_negative_numbers = true)]
    k1: Option<Number>,

    /// Row parameter of row 2.
    #[arg(long, requires = "k1", conflicts_with = "ratio2", allow_negative_numbers = true)]
    k2: Option<Number>,

    /// Ratio of gear 1, in place of --k1.
    #[arg(long, group = "first", requires = "scheme", conflicts_with = "k1", allow_negative_numbers = true)]
    ratio1: Option<Number>,

    /// Ratio of gear 2, in place of --k2.
    #[arg(long, requires = "scheme", allow_negative_numbers = true)]
    ratio2: Option<Number>,

    /// Efficiency of each row under a resting carrier, 0.97 or 97%; of a scheme with numbers.
    #[arg(
        long,
        value_name = "NUMBER",
        requires = "first",
        default_value = "0.97",
        allow_hyphen_values = true
    )]
    efficiency: Quantity<Ratio>,

    /// Row parameters over which ranges of ratios are taken.
    #[arg(long, value_name = "RANGE", default_value = "1.7..7")]
    k: Span<f64>,

    #[command(flatten)]
    output: OutputArgs,
}

/// Any scheme of the catalogue.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Scheme {
    Two(TwoSpeed),
    Three(ThreeSpeed),
}

impl Scheme {
    /// All fourteen.
    fn all() -> impl Iterator<Item = Self> {
        TwoSpeed::ALL.into_iter().map(Self::Two).chain(ThreeSpeed::ALL.into_iter().map(Self::Three))
    }

    pub(crate) fn named(name: &str) -> Result<Self, Failure> {
        Self::all().find(|scheme| scheme.name().eq_ignore_ascii_case(name)).ok_or_else(|| {
            let known = Self::all().map(Self::name).collect::<Vec<_>>().join(", ");
            DesignError::UnknownScheme { name: name.to_owned(), known }.into()
        })
    }

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Two(scheme) => scheme.name(),
            Self::Three(scheme) => scheme.name(),
        }
    }

    /// The scheme of row 1 alone.
    fn first(self) -> TwoSpeed {
        match self {
            Self::Two(scheme) => scheme,
            Self::Three(scheme) => scheme.first_stage(),
        }
    }

    /// Links of sun, ring and carrier of each set.
    fn sets(self) -> Vec<[Role; 3]> {
        match self {
            Self::Two(scheme) => vec![scheme.set()],
            Self::Three(scheme) => scheme.sets().to_vec(),
        }
    }

    /// Least and greatest ratio of its last braked gear over a range of k.
    fn ratio_range(self, range: RingToSunRange) -> [f64; 2] {
        let [one, other] = match self {
            Self::Two(scheme) => scheme.ratio_range(range),
            Self::Three(scheme) => scheme.ratio_range(range),
        };
        [one.min(other), one.max(other)]
    }
}

/// A scheme with its numbers.
pub(crate) struct Dimensioned {
    k: Vec<RingToSunRatio>,
    pub(crate) gearbox: Gearbox,
}

/// What says how large the rows of a scheme are: the options of these names.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Sizes {
    pub(crate) k1: Option<Number>,
    pub(crate) k2: Option<Number>,
    pub(crate) ratio1: Option<Number>,
    pub(crate) ratio2: Option<Number>,
}

/// Runs the command.
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let usual = RingToSunRange::USED;
    let span = args.k.within(usual.low()..=usual.high());
    let span = span.map_err(|error| Failure::Range { option: "--k", error })?;
    let range = RingToSunRange::new(*span.start(), *span.end()).map_err(refuse("--k"))?;
    let eta0 = MeshEfficiency::new(args.efficiency.0.si()).map_err(refuse("--efficiency"))?;
    let report = match &args.scheme {
        None => list::report(range),
        Some(name) => {
            let scheme = Scheme::named(name)?;
            let sizes = Sizes { k1: args.k1, k2: args.k2, ratio1: args.ratio1, ratio2: args.ratio2 };
            one::report(scheme, range, eta0, dimensioned(sizes, scheme, eta0)?.as_ref())?
        }
    };
    args.output.deliver_report(vec![], &report)
}

fn refuse<E: ToString>(option: &'static str) -> impl Fn(E) -> Failure {
    move |error| Failure::Option { option, message: error.to_string() }
}

/// The scheme with the parameters or ratios that were given, if any were.
pub(crate) fn dimensioned(
    sizes: Sizes,
    scheme: Scheme,
    eta0: MeshEfficiency,
) -> Result<Option<Dimensioned>, Failure> {
    let missing = |option, message: &str| Err(Failure::Option { option, message: message.to_owned() });
    let first = match (sizes.k1, sizes.ratio1) {
        (Some(k), _) => RingToSunRatio::new(k.get()).map_err(refuse("--k1"))?,
        (None, Some(ratio)) => scheme.first().ring_to_sun_ratio(ratio.get()).map_err(refuse("--ratio1"))?,
        (None, None) if sizes.ratio2.is_some() => return missing("--ratio2", "give --ratio1 or --k1 too"),
        (None, None) => return Ok(None),
    };
    let second = match (scheme, sizes.k2, sizes.ratio2) {
        (Scheme::Two(_), None, None) => None,
        (Scheme::Two(_), Some(_), _) => {
            return missing("--k2", &format!("scheme {} has one row", scheme.name()));
        }
        (Scheme::Two(_), ..) => return missing("--ratio2", &format!("scheme {} has one row", scheme.name())),
        (Scheme::Three(_), Some(k), _) => Some(RingToSunRatio::new(k.get()).map_err(refuse("--k2"))?),
        (Scheme::Three(three), None, Some(ratio)) => {
            Some(three.second_ring_to_sun_ratio(first, ratio.get()).map_err(refuse("--ratio2"))?)
        }
        (Scheme::Three(_), None, None) => {
            return missing("--k2", &format!("{} has two rows: give --k2 or --ratio2 too", scheme.name()));
        }
    };
    let gearbox = match (scheme, second) {
        (Scheme::Three(three), Some(second)) => three.gearbox(first, second, eta0)?,
        _ => scheme.first().gearbox(first, eta0)?,
    };
    Ok(Some(Dimensioned { k: [Some(first), second].into_iter().flatten().collect(), gearbox }))
}

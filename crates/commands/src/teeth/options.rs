//! Request for a search for tooth numbers.

use crate::error::Error;
use crate::shared::profile_shift::ShiftOptions;
use epicyclic_formats::Span;
use epicyclic_gears::arrangement::{Arrangement, ArrangementMode, ModuleRatio};
use epicyclic_gears::simple_set::Mode;
use epicyclic_gears::synthesis::Placement;
use epicyclic_units::{Number, Quantity};
use uom::si::f64::{Angle, Ratio};

/// Ratio of a set, and bounds of its teeth.
#[derive(Debug, Clone, clap::Args)]
pub struct Request {
    /// Wanted ratio, input speed over output speed; negative for opposite directions of rotation.
    #[arg(long, allow_hyphen_values = true)]
    pub ratio: Number,

    /// Kind of the sets.
    #[arg(long, value_enum, default_value_t = Kind::Simple)]
    pub kind: Kind,

    /// Input, output and fixed member: ab^H, aH^b, bH^a, ba^H, Ha^b or Hb^a, with sun a, ring b and carrier
    /// H. Default: aH^b. Other kinds: second sun c, second ring e, gears 1 and 2 of a pair; default: Ha^c of
    /// stepped-suns, He^b of stepped-rings, ae^b of wolfrom, ab^c of ravigneaux (small sun a), 12^H of a
    /// pair.
    #[arg(long, value_parser = letters)]
    pub mode: Option<String>,

    /// Greatest error of the ratio, below 100%: 1%, or 0.01.
    #[arg(long, default_value = "1%", allow_hyphen_values = true)]
    pub tolerance: Quantity<Ratio>,

    /// Older spelling of --kind double-planet.
    #[arg(long, hide = true, conflicts_with_all = ["ring_offset", "kind"])]
    pub double_planet: bool,

    /// Modules of the second step of the planet over that of the first, each tried: 1, 1.25, 4/5.
    #[arg(long, value_name = "RATIOS", value_delimiter = ',', default_value = "1", value_parser = module_ratio)]
    pub module_ratio: Vec<ModuleRatio>,

    /// Profile shifts of the sets.
    #[command(flatten)]
    pub shifts: ShiftOptions,

    /// Number of planets, or of pairs of planets, from 2 to 8.
    #[arg(long, default_value = "3..8")]
    pub planets: Span<u32>,

    /// Teeth of the sun, or of every sun; of a pair its external gears.
    #[arg(long, default_value = "12..200")]
    pub sun: Span<u32>,

    /// Teeth of a planet, of a double-planet set of each of the two; of every step.
    #[arg(long, default_value = "12..200")]
    pub planet: Span<u32>,

    /// Teeth of the ring, or of every ring; of a pair its internal gear.
    #[arg(long, default_value = "12..200")]
    pub ring: Span<u32>,

    /// Teeth of single gears by their letters, of other kinds than simple and double; planets are g and f:
    /// a=18..24,f=30.
    #[arg(long, value_name = "LETTER=RANGE", value_delimiter = ',', value_parser = gear)]
    pub gear: Vec<(char, Span<u32>)>,

    /// Ring-to-sun ratio k of simple and double-planet sets.
    #[arg(long, default_value = "1.3..10")]
    pub k: Span<f64>,

    /// Spacing of the planets.
    #[arg(long, value_enum, default_value_t = Placement::Equal)]
    pub spacing: Placement,

    /// Angles of the planets about the axis, of other kinds than simple and double; their number is that of
    /// the planets: 0deg,80deg,180deg,260deg.
    #[arg(
        long,
        value_name = "ANGLES",
        value_delimiter = ',',
        allow_hyphen_values = true,
        conflicts_with_all = ["planets", "spacing"]
    )]
    pub angles: Vec<Quantity<Angle>>,

    /// Least gap between the tips of neighbouring planets, in modules.
    #[arg(long, default_value = "0", allow_hyphen_values = true)]
    pub tip_gap: Number,

    /// Addendum coefficient of the basic rack: tips of planets, and undercut.
    #[arg(long, default_value = "1", allow_hyphen_values = true)]
    pub addendum: Number,

    /// Pressure angle of the basic rack: undercut.
    #[arg(long, value_name = "ANGLE", default_value = "20deg", allow_hyphen_values = true)]
    pub pressure_angle: Quantity<Angle>,

    /// Leave out sets in which the rack would undercut sun or planet.
    #[arg(long, conflicts_with = "ring_offset")]
    pub no_undercut: bool,

    /// Show at most this many sets. Default: 20 in a table, otherwise all, up to 100000.
    #[arg(long, value_name = "N")]
    pub limit: Option<usize>,

    /// Number of the set whose checks are listed, from 1; the first if there are fewer sets.
    #[arg(skip = 1_usize)]
    pub checked: usize,
}

/// Kind of the sets of a search.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Kind {
    /// Sun, planets, ring.
    Simple,
    /// Sun, ring and pairs of planets in mesh with each other.
    DoublePlanet,
    /// Stepped planets: one step with the sun, the other with the ring.
    Stepped,
    /// Stepped planets between two suns.
    SteppedSuns,
    /// Stepped planets between two rings.
    SteppedRings,
    /// Sun, first ring and second ring on planets of two steps or one.
    Wolfrom,
    /// Small and large sun and ring on short and long planets.
    Ravigneaux,
    /// Two gears on fixed axes: external for a negative ratio, internal for a positive one.
    Pair,
}

impl Kind {
    /// Arrangement of the gears; `None` for simple and double-planet sets.
    fn arrangement(self, ratio: f64) -> Option<Arrangement> {
        Some(match self {
            Self::Simple | Self::DoublePlanet => return None,
            Self::Stepped => Arrangement::Stepped,
            Self::SteppedSuns => Arrangement::SteppedSuns,
            Self::SteppedRings => Arrangement::SteppedRings,
            Self::Wolfrom => Arrangement::Wolfrom,
            Self::Ravigneaux => Arrangement::Ravigneaux,
            Self::Pair if ratio < 0.0 => Arrangement::ExternalPair,
            Self::Pair => Arrangement::InternalPair,
        })
    }
}

impl Request {
    /// Whether double-planet sets are wanted.
    #[must_use]
    pub fn is_double(&self) -> bool {
        self.double_planet || self.kind == Kind::DoublePlanet
    }

    /// Arrangement of the gears; `None` for simple and double-planet sets.
    #[must_use]
    pub fn arrangement(&self) -> Option<Arrangement> {
        self.kind.arrangement(self.ratio.get())
    }

    /// Mode of simple and double-planet sets.
    ///
    /// # Errors
    /// [`Error::Mode`] for the mode of another kind.
    pub fn simple_mode(&self) -> Result<Mode, Error> {
        let letters = self.mode.as_deref().unwrap_or("aH^b");
        let mode = Mode::ALL.into_iter().find(|mode| mode.to_string() == letters);
        mode.ok_or_else(|| {
            refuse_mode(
                letters,
                if self.is_double() { "double-planet set" } else { "simple set" },
                &Mode::ALL,
            )
        })
    }

    /// Mode of an arrangement.
    ///
    /// # Errors
    /// [`Error::Mode`] for the mode of another kind.
    pub fn arranged_mode(&self, arrangement: Arrangement) -> Result<ArrangementMode, Error> {
        let letters = self.mode.as_deref().unwrap_or(arrangement.usual_mode());
        let mode = arrangement.mode(letters);
        mode.ok_or_else(|| refuse_mode(letters, &arrangement.to_string(), &arrangement.modes()))
    }
}

fn refuse_mode(letters: &str, kind: &str, modes: &[impl ToString]) -> Error {
    let modes: Vec<String> = modes.iter().map(ToString::to_string).collect();
    Error::Mode { letters: letters.to_owned(), kind: kind.to_owned(), modes: modes.join(", ") }
}

/// Letters of a mode of any kind.
fn letters(text: &str) -> Result<String, String> {
    let is_arranged = Arrangement::ALL.iter().any(|arrangement| arrangement.mode(text).is_some());
    if is_arranged || Mode::ALL.iter().any(|mode| mode.to_string() == text) {
        return Ok(text.to_owned());
    }
    let all: Vec<String> = Mode::ALL
        .iter()
        .map(|mode| format!("{mode} ({} to {}, {} at rest)", mode.input(), mode.output(), mode.fixed()))
        .collect();
    Err(format!("write one of {}", all.join(", ")))
}

/// A ratio of modules, exactly: `1.25` or `5/4`.
fn module_ratio(text: &str) -> Result<ModuleRatio, String> {
    let text = text.trim();
    let ratio = match text.split_once('.') {
        None => text.parse().ok(),
        Some((whole, decimals)) => u32::try_from(decimals.len())
            .ok()
            .and_then(|places| 10_u32.checked_pow(places))
            .and_then(|under| Some(ModuleRatio::new(format!("{whole}{decimals}").parse().ok()?, under))),
    };
    ratio
        .filter(|ratio| *ratio.numer() > 0 && ratio.numer().max(ratio.denom()) <= &MOST_OF_RATIO)
        .ok_or_else(|| format!("write a ratio above 0 as 1.25 or 5/4, of numbers up to {MOST_OF_RATIO}"))
}

/// Greatest numerator and denominator of a ratio of modules.
const MOST_OF_RATIO: u32 = 10_000;

/// A gear's letter and its range: `a=18..24`.
fn gear(text: &str) -> Result<(char, Span<u32>), String> {
    let (letter, range) = text.split_once('=').ok_or("write a letter and a range: a=18..24")?;
    let mut letters = letter.trim().chars();
    match (letters.next(), letters.next()) {
        (Some(letter), None) => Ok((letter, range.parse().map_err(|error| format!("{error}"))?)),
        _ => Err("write one letter and a range: a=18..24".to_owned()),
    }
}

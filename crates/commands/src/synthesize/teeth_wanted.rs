//! Options of `synthesize` for tooth numbers.

use crate::failure::Failure;
use crate::shared::options;
use crate::shared::profile_shift::ShiftOptions;
use crate::synthesize::answer::teeth::TeethWanted;
use epicyclic_formats::Span;
use epicyclic_gears::synthesis::Bounds;
use epicyclic_synthesis::teeth::{Aim, Alike};
use std::ops::RangeInclusive;

/// The k that may be asked for: below, planets have no teeth; above, no ring is that large.
pub(crate) const ANY_K: RangeInclusive<f64> = 1.05..=20.0;

/// Tooth numbers of the gearboxes shown.
#[derive(Debug, Clone, clap::Args)]
#[command(next_help_heading = "Tooth numbers")]
pub struct TeethOptions {
    /// Find all tooth numbers of each gearbox shown that keep the tolerances.
    #[arg(long)]
    pub teeth: bool,

    /// Teeth of the suns.
    #[arg(long, value_name = "RANGE", requires = "teeth", default_value = "12..200")]
    pub sun: Span<u32>,

    /// Teeth of the planets; of a double-planet set of either planet.
    #[arg(long, value_name = "RANGE", requires = "teeth", default_value = "12..200")]
    pub planet: Span<u32>,

    /// Teeth of the rings.
    #[arg(long, value_name = "RANGE", requires = "teeth", default_value = "12..200")]
    pub ring: Span<u32>,

    /// Number of planets of a set, of a double-planet set of its pairs of planets, from 2 to 8.
    #[arg(long, value_name = "RANGE", requires = "teeth", default_value = "3..8")]
    pub planet_count: Span<u32>,

    /// At least so many sets have rings of equal teeth.
    #[arg(long, value_name = "N", requires = "teeth", default_value = "1")]
    pub equal_rings: usize,

    /// At least so many sets have suns of equal teeth.
    #[arg(long, value_name = "N", requires = "teeth", default_value = "1")]
    pub equal_suns: usize,

    /// At least so many sets are equal.
    #[arg(long, value_name = "N", requires = "teeth", default_value = "1")]
    pub equal_sets: usize,

    /// Which tooth numbers are the best.
    #[arg(long, value_enum, requires = "teeth", default_value_t = TeethAim::Deviation)]
    pub teeth_aim: TeethAim,

    /// Choices of tooth numbers shown of each gearbox.
    #[arg(long, value_name = "N", requires = "teeth", default_value = "5")]
    pub teeth_limit: usize,

    /// Profile shifts.
    #[command(flatten)]
    pub shifts: ShiftOptions,
}

/// Which tooth numbers are the best.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum TeethAim {
    /// The least greatest deviation of a ratio.
    Deviation,
    /// The fewest teeth of all suns and rings.
    Fewest,
}

impl TeethOptions {
    pub(crate) fn wanted(&self) -> Result<Option<TeethWanted>, Failure> {
        self.shifts.only_with_teeth(self.teeth)?;
        if !self.teeth {
            return Ok(None);
        }
        let usual = options::proposed([self.sun, self.planet, self.ring])?;
        let planets = self.planet_count.closed(usual.planets);
        let planets = planets.map_err(|error| Failure::Range { option: "--planet-count", error })?;
        let wanted = TeethWanted {
            bounds: Bounds { planets, ring_to_sun_ratio: ANY_K, ..usual },
            shifts: self.shifts.wanted(),
            alike: Alike { rings: self.equal_rings, suns: self.equal_suns, sets: self.equal_sets },
            aim: match self.teeth_aim {
                TeethAim::Deviation => Aim::Deviation,
                TeethAim::Fewest => Aim::Teeth,
            },
            most: self.teeth_limit,
        };
        self.shifts.check(&wanted.bounds)?;
        Ok(Some(wanted))
    }
}

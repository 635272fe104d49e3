//! Request for a search for tooth numbers.

use crate::shared::profile_shift::ShiftOptions;
use epicyclic_formats::Span;
use epicyclic_gears::simple_set::Mode;
use epicyclic_gears::synthesis::Placement;
use epicyclic_units::{Number, Quantity};
use uom::si::f64::{Angle, Ratio};

/// Ratio of a set, and bounds of its teeth.
#[derive(Debug, Clone, clap::Args)]
pub struct Request {
    /// Wanted ratio, input speed over output speed; negative for opposite directions of rotation.
    #[arg(long, allow_negative_numbers = true)]
    pub ratio: Number,

    /// Input, output and fixed member: ab^H, aH^b, bH^a, ba^H, Ha^b or Hb^a, with sun a, ring b and carrier
    /// H.
    #[arg(long, default_value = "aH^b", value_parser = mode)]
    pub mode: Mode,

    /// Greatest error of the ratio, below 100%: 1%, or 0.01.
    #[arg(long, default_value = "1%", allow_hyphen_values = true)]
    pub tolerance: Quantity<Ratio>,

    /// Double-planet sets: pairs of planets in mesh with each other, one with the sun, the other with the
    /// ring.
    #[arg(long, conflicts_with = "ring_offset")]
    pub double_planet: bool,

    /// Profile shifts of the sets.
    #[command(flatten)]
    pub shifts: ShiftOptions,

    /// Number of planets, or of pairs of planets, from 2 to 8.
    #[arg(long, default_value = "3..8")]
    pub planets: Span<u32>,

    /// Teeth of the sun.
    #[arg(long, default_value = "12..200")]
    pub sun: Span<u32>,

    /// Teeth of a planet, of a double-planet set of each of the two.
    #[arg(long, default_value = "12..200")]
    pub planet: Span<u32>,

    /// Teeth of the ring.
    #[arg(long, default_value = "12..200")]
    pub ring: Span<u32>,

    /// Ring-to-sun ratio k.
    #[arg(long, default_value = "1.3..10")]
    pub k: Span<f64>,

    /// Spacing of the planets.
    #[arg(long, value_enum, default_value_t = Placement::Equal)]
    pub spacing: Placement,

    /// Least gap between the tips of neighbouring planets, in modules.
    #[arg(long, default_value = "0", allow_negative_numbers = true)]
    pub tip_gap: Number,

    /// Addendum coefficient of the basic rack: tips of planets, and undercut.
    #[arg(long, default_value = "1", allow_negative_numbers = true)]
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

fn mode(text: &str) -> Result<Mode, String> {
    Mode::ALL.into_iter().find(|mode| mode.to_string() == text).ok_or_else(|| {
        let all: Vec<String> = Mode::ALL
            .iter()
            .map(|mode| format!("{mode} ({} to {}, {} at rest)", mode.input(), mode.output(), mode.fixed()))
            .collect();
        format!("write one of {}", all.join(", "))
    })
}

//! Requests about mining machines.

use crate::shared::lists::Quantities;
use epicyclic_units::{Number, Quantity};
use uom::si::f64::{Angle, AngularVelocity, Force, Length, Velocity};

/// Machines in service to list.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct List {
    /// One machine.
    #[arg(value_name = "NAME")]
    pub name: Option<String>,
}

/// Speeds for which ratios are listed.
#[derive(Debug, Clone, clap::Args)]
#[command(after_help = "Example:\n  epicyclic machine speeds '0.8 m/s, 3.15 m/s'")]
pub struct Speeds {
    /// The speeds, the slowest first: '0.76 m/s, 1.33 m/s, 1.95 m/s'.
    #[arg(value_name = "SPEEDS")]
    pub speeds: Quantities<Velocity>,
}

/// Chain cutter, its feed and its chip.
#[derive(Debug, Clone, clap::Args)]
pub struct ChainCutter {
    /// Mean spacing of the picks in a cutting line.
    #[arg(long, allow_hyphen_values = true)]
    pub pick_spacing: Quantity<Length>,

    /// Feed of the machine.
    #[arg(long, allow_hyphen_values = true)]
    pub feed: Quantity<Velocity>,

    /// Mean thickness of the chip.
    #[arg(long, allow_hyphen_values = true)]
    pub chip: Quantity<Length>,

    /// Forces in several rocks.
    #[command(flatten)]
    pub rock: Rock,
}

/// Drum or auger, its feed and its chip.
#[derive(Debug, Clone, clap::Args)]
pub struct Drum {
    /// Diameter over the picks.
    #[arg(long, allow_hyphen_values = true)]
    pub diameter: Quantity<Length>,

    /// Feed of the machine.
    #[arg(long, allow_hyphen_values = true)]
    pub feed: Quantity<Velocity>,

    /// Greatest thickness of the chip.
    #[arg(long, allow_hyphen_values = true)]
    pub chip: Quantity<Length>,

    /// Picks in a cutting line.
    #[arg(long, value_name = "NUMBER")]
    pub picks: u32,

    /// Forces in several rocks.
    #[command(flatten)]
    pub rock: Rock,
}

/// Forces in the rock for which the feed is given and in others, at the same power and chip.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct Rock {
    /// Mean cutting force in this rock.
    #[arg(long, requires = "other_forces", allow_hyphen_values = true)]
    pub force: Option<Quantity<Force>>,

    /// Mean cutting forces in other rock, for the speeds needed there: '5 kN, 6.5 kN'.
    #[arg(long, value_name = "FORCES", requires = "force", allow_hyphen_values = true)]
    pub other_forces: Option<Quantities<Force>>,
}

/// Bucket wheel on its boom, and its throw onto the chute.
#[derive(Debug, Clone, clap::Args)]
#[command(override_usage = "\
epicyclic machine rotor [OPTIONS] --boom-radius <BOOM_RADIUS>
       --slewing <SLEWING> --chip-width <CHIP_WIDTH> --buckets <NUMBER>
       --boom-angle <BOOM_ANGLE> --wheel-radius <WHEEL_RADIUS>")]
#[command(after_help = include_str!("rotor.txt"))]
pub struct Rotor {
    /// Cutting radius of the boom.
    #[arg(long, allow_hyphen_values = true)]
    pub boom_radius: Quantity<Length>,

    /// Slewing speed with the boom in the machine's axis, the least.
    #[arg(long, allow_hyphen_values = true)]
    pub slewing: Quantity<AngularVelocity>,

    /// Width of the chip.
    #[arg(long, allow_hyphen_values = true)]
    pub chip_width: Quantity<Length>,

    /// Number of buckets.
    #[arg(long, value_name = "NUMBER")]
    pub buckets: u32,

    /// Slewing angle of the boom from the machine's axis.
    #[arg(long, allow_hyphen_values = true)]
    pub boom_angle: Quantity<Angle>,

    /// Radius of the wheel.
    #[arg(long, allow_hyphen_values = true)]
    pub wheel_radius: Quantity<Length>,

    /// Discharge parameter Ω = ω²R/g, where it is known; otherwise --release, --chute and --radius-ratio.
    #[arg(long, value_name = "NUMBER", conflicts_with_all = ["release", "chute", "radius_ratio"], allow_hyphen_values = true)]
    pub discharge: Option<Number>,

    /// Angle at which a particle leaves its bucket.
    #[arg(long, requires = "chute", requires = "radius_ratio", allow_hyphen_values = true)]
    pub release: Option<Quantity<Angle>>,

    /// Angles of the chute's edge with the boom raised and lowered; the smaller Ω counts.
    #[arg(long, value_name = "ANGLES", requires = "release", allow_hyphen_values = true)]
    pub chute: Option<Quantities<Angle>>,

    /// Radius of the chute's edge over that of the wheel.
    #[arg(long, value_name = "NUMBER", requires = "release", allow_hyphen_values = true)]
    pub radius_ratio: Option<Number>,
}

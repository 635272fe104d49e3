//! The command `machine`: which speeds a mining machine needs, and how many.

use crate::desk::Call;
use crate::error::Error;
use crate::failure::Failure;
use crate::machine::answer::{self as machine, Forces, Throw, Wheel};
use crate::output::OutputArgs;
use crate::shared::lists::Quantities;
use epicyclic_schemes::Error as SchemeError;
use epicyclic_schemes::quantity::Quantity as Of;
use epicyclic_units::{Number, Quantity};
use uom::si::f64::{Angle, AngularVelocity, Force, Length, Velocity};

/// Speeds of mining machines: what is in service, what is needed, and the ratios that give it.
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, clap::Subcommand)]
enum Command {
    List(List),
    Speeds(Speeds),
    ChainCutter(ChainCutter),
    Drum(Drum),
    Rotor(Rotor),
}

/// Machines in service with their numbers of speeds, beside the number recommended for their ranges.
#[derive(Debug, clap::Args)]
struct List {
    /// One machine.
    #[arg(value_name = "NAME")]
    name: Option<String>,

    #[command(flatten)]
    output: OutputArgs,
}

/// Ratios of a gearbox for some speeds, and how many speeds are recommended for their range.
///
/// Direct drive may serve the fastest speed (the gearbox then only slows down), the slowest, or one between.
/// Ratios are listed the fastest speed first.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  epicyclic machine speeds '0.8 m/s, 3.15 m/s'")]
struct Speeds {
    /// The speeds, the slowest first: '0.76 m/s, 1.33 m/s, 1.95 m/s'.
    #[arg(value_name = "SPEEDS")]
    speeds: Quantities<Velocity>,

    #[command(flatten)]
    output: OutputArgs,
}

/// Cutting speed of a chain cutter, and of the same cutter in other rock.
#[derive(Debug, clap::Args)]
struct ChainCutter {
    /// Mean spacing of the picks in a cutting line.
    #[arg(long, allow_hyphen_values = true)]
    pick_spacing: Quantity<Length>,

    /// Feed of the machine.
    #[arg(long, allow_hyphen_values = true)]
    feed: Quantity<Velocity>,

    /// Mean thickness of the chip.
    #[arg(long, allow_hyphen_values = true)]
    chip: Quantity<Length>,

    #[command(flatten)]
    rock: Rock,

    #[command(flatten)]
    output: OutputArgs,
}

/// Cutting speed of a drum or auger, and of the same in other rock.
#[derive(Debug, clap::Args)]
struct Drum {
    /// Diameter over the picks.
    #[arg(long, allow_hyphen_values = true)]
    diameter: Quantity<Length>,

    /// Feed of the machine.
    #[arg(long, allow_hyphen_values = true)]
    feed: Quantity<Velocity>,

    /// Greatest thickness of the chip.
    #[arg(long, allow_hyphen_values = true)]
    chip: Quantity<Length>,

    /// Picks in a cutting line.
    #[arg(long, value_name = "NUMBER")]
    picks: u32,

    #[command(flatten)]
    rock: Rock,

    #[command(flatten)]
    output: OutputArgs,
}

/// Forces in the rock for which the feed is given and in others, at the same power and chip.
#[derive(Debug, clap::Args)]
struct Rock {
    /// Mean cutting force in this rock.
    #[arg(long, requires = "other_forces", allow_hyphen_values = true)]
    force: Option<Quantity<Force>>,

    /// Mean cutting forces in other rock, for the speeds needed there: '5 kN, 6.5 kN'.
    #[arg(long, value_name = "FORCES", requires = "force", allow_hyphen_values = true)]
    other_forces: Option<Quantities<Force>>,
}

/// Greatest and least speed of a bucket wheel, and how many speeds their range asks for.
///
/// The greatest still empties the buckets when the boom slews at its side, the least still throws onto the
/// chute. Angles are about the wheel's axis from the horizontal, in the sense of rotation.
#[derive(Debug, clap::Args)]
#[command(override_usage = "\
epicyclic machine rotor [OPTIONS] --boom-radius <BOOM_RADIUS>
       --slewing <SLEWING> --chip-width <CHIP_WIDTH> --buckets <NUMBER>
       --boom-angle <BOOM_ANGLE> --wheel-radius <WHEEL_RADIUS>")]
#[command(after_help = include_str!("rotor.txt"))]
struct Rotor {
    /// Cutting radius of the boom.
    #[arg(long, allow_hyphen_values = true)]
    boom_radius: Quantity<Length>,

    /// Slewing speed with the boom in the machine's axis, the least.
    #[arg(long, allow_hyphen_values = true)]
    slewing: Quantity<AngularVelocity>,

    /// Width of the chip.
    #[arg(long, allow_hyphen_values = true)]
    chip_width: Quantity<Length>,

    /// Number of buckets.
    #[arg(long, value_name = "NUMBER")]
    buckets: u32,

    /// Slewing angle of the boom from the machine's axis.
    #[arg(long, allow_hyphen_values = true)]
    boom_angle: Quantity<Angle>,

    /// Radius of the wheel.
    #[arg(long, allow_hyphen_values = true)]
    wheel_radius: Quantity<Length>,

    /// Discharge parameter Ω = ω²R/g, where it is known; otherwise --release, --chute and --radius-ratio.
    #[arg(long, value_name = "NUMBER", conflicts_with_all = ["release", "chute", "radius_ratio"], allow_negative_numbers = true)]
    discharge: Option<Number>,

    /// Angle at which a particle leaves its bucket.
    #[arg(long, requires = "chute", requires = "radius_ratio", allow_hyphen_values = true)]
    release: Option<Quantity<Angle>>,

    /// Angles of the chute's edge with the boom raised and lowered; the smaller Ω counts.
    #[arg(long, value_name = "ANGLES", requires = "release", allow_hyphen_values = true)]
    chute: Option<Quantities<Angle>>,

    /// Radius of the chute's edge over that of the wheel.
    #[arg(long, value_name = "NUMBER", requires = "release", allow_negative_numbers = true)]
    radius_ratio: Option<Number>,

    #[command(flatten)]
    output: OutputArgs,
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    match &args.command {
        Command::List(list) => {
            list.output.deliver(call, &machine::list(list.name.as_deref()).map_err(refuse)?)
        }
        Command::Speeds(speeds) => {
            speeds.output.deliver(call, &machine::speeds(&speeds.speeds.values()).map_err(refuse)?)
        }
        Command::ChainCutter(chain) => {
            let forces = chain.rock.forces();
            let found =
                machine::chain_cutter(chain.pick_spacing.0, chain.feed.0, chain.chip.0, forces.as_ref());
            chain.output.deliver(call, &found.map_err(refuse)?)
        }
        Command::Drum(drum) => {
            let forces = drum.rock.forces();
            let found = machine::drum(drum.diameter.0, drum.feed.0, drum.chip.0, drum.picks, forces.as_ref());
            drum.output.deliver(call, &found.map_err(refuse)?)
        }
        Command::Rotor(rotor) => {
            rotor.output.deliver(call, &machine::rotor(&rotor.wheel()?).map_err(refuse)?)
        }
    }
}

impl Rock {
    fn forces(&self) -> Option<Forces> {
        // Each of the two options requires the other one.
        let (here, elsewhere) = (self.force?.0, self.other_forces.as_ref()?.values());
        Some(Forces { here, elsewhere })
    }
}

impl Rotor {
    fn wheel(&self) -> Result<Wheel, Failure> {
        // The three options of the flight require each other, so the last arm has no discharge parameter at
        // all.
        let throw = match (self.discharge, self.release, &self.chute, self.radius_ratio) {
            (Some(discharge), ..) => Throw::Discharge(discharge.get()),
            (None, Some(release), Some(chute), Some(ratio)) => {
                Throw::Flight { release: release.0, chutes: chute.values(), radius_ratio: ratio.get() }
            }
            _ => {
                let message = "missing: the discharge parameter; give it where it is known, otherwise --release, --chute and --radius-ratio, from which it follows";
                return Err(Failure::invalid("--discharge", message));
            }
        };
        Ok(Wheel {
            boom_radius: self.boom_radius.0,
            slewing: self.slewing.0,
            chip_width: self.chip_width.0,
            buckets: self.buckets,
            boom_angle: self.boom_angle.0,
            radius: self.wheel_radius.0,
            throw,
        })
    }
}

/// Converts an error to a failure with the option that caused it.
fn refuse(error: Error) -> Failure {
    let Error::Design(error) = error else { return error.into() };
    let option = match &error {
        SchemeError::NotPositive { quantity, .. } => match quantity {
            Of::PickSpacing => "--pick-spacing",
            Of::Feed => "--feed",
            Of::MeanChip | Of::GreatestChip => "--chip",
            Of::DrumDiameter => "--diameter",
            Of::PicksPerLine => "--picks",
            Of::CuttingForce => "--force",
            Of::OtherCuttingForce => "--other-forces",
            Of::BoomRadius => "--boom-radius",
            Of::SlewingSpeed => "--slewing",
            Of::ChipWidth => "--chip-width",
            Of::Buckets => "--buckets",
            Of::WheelRadius => "--wheel-radius",
            Of::Discharge => "--discharge",
            _ => return error.into(),
        },
        SchemeError::SpeedCount { .. } | SchemeError::SpeedsOutOfOrder { .. } => "<SPEEDS>",
        SchemeError::BoomAngle { .. } => "--boom-angle",
        SchemeError::NoFlight { .. } => "--release, --chute",
        _ => return error.into(),
    };
    Failure::of_option(option, &error)
}

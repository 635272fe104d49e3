//! The command `machine`: which speeds a mining machine needs, and how many.

use crate::desk::Call;
use crate::error::Error;
use crate::failure::Failure;
use crate::machine::answer::{self as answers, Forces, MachineSpeeds, Machines, Throw};
use crate::output::WithOutput;
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
    /// Machines in service with their numbers of speeds, beside the number recommended for their ranges.
    List(WithOutput<List>),
    /// Ratios of a gearbox for some speeds, and how many speeds are recommended for their range.
    ///
    /// Direct drive may serve the fastest speed (the gearbox then only slows down), the slowest, or one between.
    /// Ratios are listed the fastest speed first.
    Speeds(WithOutput<Speeds>),
    /// Cutting speed of a chain cutter, and of the same cutter in other rock.
    ChainCutter(WithOutput<ChainCutter>),
    /// Cutting speed of a drum or auger, and of the same in other rock.
    Drum(WithOutput<Drum>),
    /// Greatest and least speed of a bucket wheel, and how many speeds their range asks for.
    ///
    /// The greatest still empties the buckets when the boom slews at its side, the least still throws onto the
    /// chute. Angles are about the wheel's axis from the horizontal, in the sense of rotation.
    Rotor(WithOutput<Rotor>),
}

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
    #[arg(long, value_name = "NUMBER", conflicts_with_all = ["release", "chute", "radius_ratio"], allow_negative_numbers = true)]
    pub discharge: Option<Number>,

    /// Angle at which a particle leaves its bucket.
    #[arg(long, requires = "chute", requires = "radius_ratio", allow_hyphen_values = true)]
    pub release: Option<Quantity<Angle>>,

    /// Angles of the chute's edge with the boom raised and lowered; the smaller Ω counts.
    #[arg(long, value_name = "ANGLES", requires = "release", allow_hyphen_values = true)]
    pub chute: Option<Quantities<Angle>>,

    /// Radius of the chute's edge over that of the wheel.
    #[arg(long, value_name = "NUMBER", requires = "release", allow_negative_numbers = true)]
    pub radius_ratio: Option<Number>,
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    match &args.command {
        Command::List(WithOutput { request, output }) => output.deliver(call, &request.answer()?),
        Command::Speeds(WithOutput { request, output }) => output.deliver(call, &request.answer()?),
        Command::ChainCutter(WithOutput { request, output }) => output.deliver(call, &request.answer()?),
        Command::Drum(WithOutput { request, output }) => output.deliver(call, &request.answer()?),
        Command::Rotor(WithOutput { request, output }) => output.deliver(call, &request.answer()?),
    }
}

impl Rock {
    fn forces(&self) -> Option<Forces> {
        // Each of the two options requires the other one.
        let (here, elsewhere) = (self.force?.0, self.other_forces.as_ref()?.values());
        Some(Forces { here, elsewhere })
    }
}

impl List {
    /// Lists all machines, or the one with this name.
    ///
    /// # Errors
    /// A name that is not in the tables.
    pub fn answer(&self) -> Result<Machines, Failure> {
        answers::list(self.name.as_deref()).map_err(refuse)
    }
}

impl Speeds {
    /// Computes the ratios for two to four speeds.
    ///
    /// # Errors
    /// [`Failure::Option`] for speeds that form no series.
    pub fn answer(&self) -> Result<MachineSpeeds, Failure> {
        answers::speeds(&self.speeds.values()).map_err(refuse)
    }
}

impl ChainCutter {
    /// Computes the cutting speed.
    ///
    /// # Errors
    /// [`Failure::Option`] for a quantity that is not above 0.
    pub fn answer(&self) -> Result<answers::ChainCutter, Failure> {
        answers::chain_cutter(self, self.rock.forces()).map_err(refuse)
    }
}

impl Drum {
    /// Computes the cutting speed.
    ///
    /// # Errors
    /// [`Failure::Option`] for a quantity that is not above 0.
    pub fn answer(&self) -> Result<answers::Drum, Failure> {
        answers::drum(self, self.rock.forces()).map_err(refuse)
    }
}

impl Rotor {
    /// Computes the greatest and least speed of the wheel.
    ///
    /// # Errors
    /// [`Failure::Option`] without a discharge parameter, for a quantity that is not above 0, and for a throw
    /// that does not reach the chute.
    pub fn answer(&self) -> Result<answers::Rotor, Failure> {
        answers::rotor(self, &self.throw()?).map_err(refuse)
    }

    fn throw(&self) -> Result<Throw, Failure> {
        // The three options of the flight require each other, so the last arm has no discharge parameter at
        // all.
        Ok(match (self.discharge, self.release, &self.chute, self.radius_ratio) {
            (Some(discharge), ..) => Throw::Discharge(discharge.get()),
            (None, Some(release), Some(chute), Some(ratio)) => {
                Throw::Flight { release: release.0, chutes: chute.values(), radius_ratio: ratio.get() }
            }
            _ => {
                let message = "missing: the discharge parameter; give it where it is known, otherwise --release, --chute and --radius-ratio, from which it follows";
                return Err(Failure::invalid("--discharge", message));
            }
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

//! The command `machine`: which speeds a mining machine needs, and how many.

use crate::desk::Call;
use crate::error::Error;
use crate::failure::Failure;
use crate::machine::answer::{self as answers, Forces, MachineSpeeds, Machines, Throw};
use crate::machine::options::{ChainCutter, Drum, List, Rock, Rotor, Speeds};
use crate::output::WithOutput;
use epicyclic_schemes::Error as SchemeError;
use epicyclic_schemes::quantity::Quantity as Of;

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
    /// Direct drive may serve the fastest speed (the gearbox then only slows down), the slowest, or one
    /// between. Ratios are listed the fastest speed first.
    Speeds(WithOutput<Speeds>),
    /// Cutting speed of a chain cutter, and of the same cutter in other rock.
    ChainCutter(WithOutput<ChainCutter>),
    /// Cutting speed of a drum or auger, and of the same in other rock.
    Drum(WithOutput<Drum>),
    /// Greatest and least speed of a bucket wheel, and how many speeds their range asks for.
    ///
    /// The greatest still empties the buckets when the boom slews at its side, the least still throws onto
    /// the chute. Angles are about the wheel's axis from the horizontal, in the sense of rotation.
    Rotor(WithOutput<Rotor>),
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

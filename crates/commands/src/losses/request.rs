//! The command `losses`: what heats a gearbox at work, and its efficiency over speed and torque.

use crate::desk::Call;
use crate::error::Error;
use crate::failure::Failure;
use crate::losses::answer::{self as answers, Cooling, GivenLoad, LossMap, Losses, Point};
use crate::output::OutputArgs;
use crate::shared::gearbox::Gearbox;
use crate::shared::gearbox_choice::{Choice, refuse};
use crate::shared::judgement::answer::Judgement;
use crate::shared::places::Grid;
use epicyclic_train::InputLoad;
use epicyclic_units::Quantity;
use uom::si::f64::{AngularVelocity, Power, TemperatureInterval, ThermalConductance, Torque};

/// Losses of a gearbox at work: of its meshes under load, and drags of seals, bearings, oil and open shift
/// elements.
///
/// At a --speed and a load each loss of each gear by its name, and the balance of powers; with --speeds and
/// --torques the efficiency of one gear over both. With --conductance how warm the oil becomes, and what
/// torque it bears. Meshes lose by their efficiencies or by friction, drags by the curves of the file.
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    #[command(flatten)]
    choice: Choice,

    #[command(flatten)]
    request: Request,

    #[command(flatten)]
    output: OutputArgs,
}

/// Request for the losses of a gearbox: a speed and one load, or a map of one gear.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct Request {
    /// One gear; all without.
    #[arg(long, value_name = "NAME")]
    pub gear: Option<String>,

    /// Speed of the input: 1475 rpm.
    #[arg(
        long,
        visible_alias = "input",
        allow_hyphen_values = true,
        required_unless_present = "speeds",
        conflicts_with = "speeds"
    )]
    pub speed: Option<Quantity<AngularVelocity>>,

    /// Torque on the input: 500 N·m; below 0 the machine brakes it.
    #[arg(long, conflicts_with_all = ["power", "load_torque", "speeds"], allow_hyphen_values = true)]
    pub torque: Option<Quantity<Torque>>,

    /// Power into the input: 75 kW.
    #[arg(long, conflicts_with_all = ["load_torque", "speeds"], allow_hyphen_values = true)]
    pub power: Option<Quantity<Power>>,

    /// Torque that the driven machine takes from the output; the input's follows.
    #[arg(long, conflicts_with = "speeds", allow_hyphen_values = true)]
    pub load_torque: Option<Quantity<Torque>>,

    /// Conductance of the housing to the air, area times coefficient: 25 W/K. Tells how warm the oil becomes.
    #[arg(long, value_name = "CONDUCTANCE", conflicts_with = "speeds", allow_hyphen_values = true)]
    pub conductance: Option<Quantity<ThermalConductance>>,

    /// What a cooler takes at most: 2 kW. Default: none.
    #[arg(long, value_name = "POWER", requires = "conductance", allow_hyphen_values = true)]
    pub cooler: Option<Quantity<Power>>,

    /// By how much the oil may be warmer than the air: 60 K. Tells the greatest torque on the input.
    #[arg(long, value_name = "DIFFERENCE", requires = "conductance", allow_hyphen_values = true)]
    pub allowed_rise: Option<Quantity<TemperatureInterval>>,

    /// Speeds and torques of a map.
    #[command(flatten)]
    pub map: Grid,
}

impl Request {
    /// The losses at the speed and load.
    ///
    /// # Errors
    /// [`Failure::Option`] for what is missing or cannot be, a gear that there is not or that cannot run so;
    /// a fault in the file with its place.
    pub fn answer(&self, gearbox: &Gearbox) -> Result<Losses, Failure> {
        let load = self.load()?;
        let speed = self.speed.ok_or_else(|| Failure::missing("--speed", "the speed of the input is due"))?.0;
        let point = Point { speed, load };
        self.judged(gearbox, point).map_err(|error| match error {
            Error::Cooling { quantity, .. } => {
                let option = match quantity {
                    "cooler" => "--cooler",
                    "allowed-rise" => "--allowed-rise",
                    _ => "--conductance",
                };
                Failure::of_option(option, &error)
            }
            error => refuse(error),
        })
    }

    /// The losses of the gear over the speeds and torques of the map.
    ///
    /// # Errors
    /// As of [`Self::answer`].
    pub fn answer_map(&self, gearbox: &Gearbox) -> Result<LossMap, Failure> {
        let due = |option| Failure::missing(option, "a map is of one gear over speeds and torques");
        let gear = self.gear.as_ref().ok_or_else(|| due("--gear"))?;
        let (speeds, torques) = self.map.places().ok_or_else(|| due("--speeds"))?;
        answers::map(gearbox, gear, &speeds, &torques).map_err(refuse)
    }

    fn judged(&self, gearbox: &Gearbox, point: Point) -> Result<Losses, Error> {
        let mut losses = answers::answer(gearbox, self.gear.as_deref(), point, self.cooling())?;
        losses.judgement = Judgement::of(gearbox, None, None, losses.heat.as_ref());
        losses.warnings.extend(losses.judgement.warnings(&[]));
        Ok(losses)
    }

    fn load(&self) -> Result<GivenLoad, Failure> {
        let input = |load| Some(GivenLoad::Input(load));
        let load = match (self.torque, self.power, self.load_torque) {
            (Some(torque), ..) => input(InputLoad::Torque(torque.0)),
            (_, Some(power), _) => input(InputLoad::Power(power.0)),
            (.., load) => load.map(|torque| GivenLoad::Output(torque.0)),
        };
        load.ok_or_else(|| Failure::missing("--torque", "a load is due: --torque, --power or --load-torque"))
    }

    fn cooling(&self) -> Option<Cooling> {
        self.conductance.map(|conductance| Cooling {
            conductance: conductance.0,
            cooler: self.cooler.map_or(Power::default(), |cooler| cooler.0),
            allowed_rise: self.allowed_rise.map(|rise| rise.0),
        })
    }
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let Args { choice, request, output } = args;
    let gearbox = choice.gearbox(call)?;
    if request.map.is_given() {
        output.deliver(call, &request.answer_map(&gearbox)?)
    } else {
        output.deliver(call, &request.answer(&gearbox)?)
    }
}

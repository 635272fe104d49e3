//! The command `losses`: what heats a gearbox at work, and its efficiency over speed and torque.

use crate::desk::Call;
use crate::error::Error;
use crate::failure::Failure;
use crate::losses::answer::{self as answers, Cooling, GivenLoad, Wanted};
use crate::output::OutputArgs;
use crate::shared::gearbox_choice::{Choice, refuse, subject};
use crate::shared::named_gearbox as named;
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

    /// One gear; all without.
    #[arg(long, value_name = "NAME")]
    gear: Option<String>,

    /// Speed of the input: 1475 rpm.
    #[arg(
        long,
        visible_alias = "input",
        allow_hyphen_values = true,
        required_unless_present = "speeds",
        conflicts_with = "speeds"
    )]
    speed: Option<Quantity<AngularVelocity>>,

    /// Torque on the input: 500 N·m; below 0 the machine brakes it.
    #[arg(long, conflicts_with_all = ["power", "load_torque", "speeds"], allow_hyphen_values = true)]
    torque: Option<Quantity<Torque>>,

    /// Power into the input: 75 kW.
    #[arg(long, conflicts_with_all = ["load_torque", "speeds"], allow_hyphen_values = true)]
    power: Option<Quantity<Power>>,

    /// Torque that the driven machine takes from the output; the input's follows.
    #[arg(long, conflicts_with = "speeds", allow_hyphen_values = true)]
    load_torque: Option<Quantity<Torque>>,

    /// Conductance of the housing to the air, area times coefficient: 25 W/K. Tells how warm the oil becomes.
    #[arg(long, value_name = "CONDUCTANCE", conflicts_with = "speeds", allow_hyphen_values = true)]
    conductance: Option<Quantity<ThermalConductance>>,

    /// What a cooler takes at most: 2 kW. Default: none.
    #[arg(long, value_name = "POWER", requires = "conductance", allow_hyphen_values = true)]
    cooler: Option<Quantity<Power>>,

    /// By how much the oil may be warmer than the air: 60 K. Tells the greatest torque on the input.
    #[arg(long, value_name = "DIFFERENCE", requires = "conductance", allow_hyphen_values = true)]
    allowed_rise: Option<Quantity<TemperatureInterval>>,

    #[command(flatten)]
    map: Grid,

    #[command(flatten)]
    output: OutputArgs,
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let named::Read { document, .. } = args.choice.document(call, false)?;
    let subject = subject(&args.choice, &document)?;
    if let (Some(gear), Some((speeds, torques))) = (&args.gear, args.map.places()) {
        return args.output.deliver(call, &answers::map(&subject, gear, &speeds, &torques).map_err(refuse)?);
    }
    let input = |load| Some(GivenLoad::Input(load));
    let load = match (args.torque, args.power, args.load_torque) {
        (Some(torque), ..) => input(InputLoad::Torque(torque.0)),
        (_, Some(power), _) => input(InputLoad::Power(power.0)),
        (.., load) => load.map(|torque| GivenLoad::Output(torque.0)),
    };

    let load = load
        .ok_or_else(|| Failure::missing("--torque", "a load is due: --torque, --power or --load-torque"))?;
    let speed = args.speed.ok_or_else(|| Failure::missing("--speed", "the speed of the input is due"))?.0;
    let cooling = args.conductance.map(|conductance| Cooling {
        conductance: conductance.0,
        cooler: args.cooler.map_or(Power::default(), |cooler| cooler.0),
        allowed_rise: args.allowed_rise.map(|rise| rise.0),
    });
    let wanted = Wanted { gear: args.gear.clone(), speed, load, cooling };
    let found = answers::answer(&subject, &wanted).map_err(|error| match error {
        Error::Cooling { quantity, .. } => {
            let option = match quantity {
                "cooler" => "--cooler",
                "allowed-rise" => "--allowed-rise",
                _ => "--conductance",
            };
            Failure::of_option(option, &error)
        }
        error => refuse(error),
    })?;
    args.output.deliver(call, &found)
}

//! What a gearbox does in its gears.
//!
//! | module | answers |
//! |---|---|
//! | [`overview`] | all gears side by side, with the engagement table |
//! | [`gear`] | everything about one gear |
//! | [`inputs`] | a gear with several inputs, at a point or over a map of two speeds |
//! | [`combinations`] | every combination of shift elements |
//! | [`records`] | records that these answers share |
//! | [`planet_bearings`] | forces on the planet bearings |
//! | [`warnings`] | what the reader should know of a gearbox and of its gears |
//!
//! Speeds are multiples of the input's speed, torques of the input's torque and powers of what enters, unless the key
//! ends in a unit: then they follow from the speed and load that were given.

pub mod combinations;
pub mod gear;
pub mod inputs;
pub mod overview;
pub mod planet_bearings;
pub mod records;
pub mod warnings;

use crate::Error;
use epicyclic_formats::Physical;
use epicyclic_train::{Analysis, Gear, Gearbox, InputLoad, Operation};
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::angular_velocity::radian_per_second;
use uom::si::f64::AngularVelocity;

/// What is known of the input's motion and load.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Input {
    /// Its speed.
    pub speed: Option<AngularVelocity>,
    /// Its load; at a torque without a speed no power follows.
    pub load: Option<InputLoad>,
}

/// The speed and load of the input that were asked for.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct OperatingPoint {
    /// Speed of the input.
    pub speed_rad_s: Option<f64>,
    /// Torque on the input.
    pub torque_n_m: Option<f64>,
    /// Power into the input; negative where the machine drives it.
    pub power_w: Option<f64>,
}

impl OperatingPoint {
    fn of(input: Input) -> Self {
        let (torque, power) = match input.load {
            Some(InputLoad::Torque(torque)) => (Some(torque), None),
            Some(InputLoad::Power(power)) => (None, Some(power)),
            None => (None, None),
        };
        Self {
            speed_rad_s: input.speed.map(Physical::si),
            torque_n_m: torque.map(Physical::si),
            power_w: power.map(Physical::si),
        }
    }
}

/// Which quantity of the load a gear refuses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LoadQuantity {
    /// The torque on the input.
    Torque,
    /// The power into the input.
    Power,
}

/// The analysis of a gear by its name.
///
/// # Errors
/// [`Error::NoGear`] with the names of those that there are.
pub fn analysis<'g>(gearbox: &'g Gearbox, gear: &str) -> Result<Analysis<'g>, Error> {
    match gearbox.analyze(gear) {
        // With few short names, the nearest says less than all.
        Err(epicyclic_train::Error::Unknown { .. }) => Err(Error::NoGear {
            name: gear.to_owned(),
            gears: gearbox.gears().iter().map(|gear| gear.name().to_owned()).collect(),
        }),
        analysis => Ok(analysis?),
    }
}

/// A gear with what the input's speed and load make of it.
struct Worked<'g> {
    analysis: Analysis<'g>,
    input: Input,
    /// `None` where no load is given, or where the gear cannot take it.
    operation: Option<Operation>,
}

impl<'g> Worked<'g> {
    fn new(gearbox: &'g Gearbox, gear: &str, input: Input) -> Result<Self, Error> {
        let analysis = analysis(gearbox, gear)?;
        // At a torque alone powers depend on a speed that nobody gave: none is told.
        let speed = input.speed.unwrap_or(AngularVelocity::new::<radian_per_second>(1.0));
        let operation = match input.load.map(|load| analysis.at(speed, load)) {
            None | Some(Err(epicyclic_train::Error::NotDriven { .. })) => None,
            Some(Err(epicyclic_train::Error::OperatingPoint { why })) => {
                let quantity = match input.load {
                    Some(InputLoad::Power(_)) => LoadQuantity::Power,
                    _ => LoadQuantity::Torque,
                };
                return Err(Error::Load { quantity, gear: gear.to_owned(), why });
            }
            Some(operation) => Some(operation?),
        };
        Ok(Self { analysis, input, operation })
    }

    /// A speed of the gear at the input's speed.
    fn speed_rad_s(&self, of_input: Option<f64>) -> Option<f64> {
        self.input.speed.zip(of_input).map(|(speed, of)| (speed * of).si())
    }
}

/// Names of the shift elements that a gear engages.
fn engaged(gearbox: &Gearbox, gear: &Gear) -> Vec<String> {
    gear.engaged().iter().map(|&place| gearbox.shift_elements()[place].id().to_owned()).collect()
}

/// An efficiency of a gear that moves; none of one that its losses hold.
fn moving(efficiency: Option<f64>) -> Option<f64> {
    efficiency.filter(|efficiency| *efficiency > 0.0)
}

//! Analysis of a gearbox in its gears.
//!
//! | module | answers |
//! |---|---|
//! | [`overview`] | overview of all gears, with the engagement table |
//! | [`gear`] | everything about one gear |
//! | [`formulas`] | the ratios as formulas, with the steps that lead to them |
//! | [`inputs`] | a gear with several inputs, at a point or over a map of two speeds |
//! | [`combinations`] | every combination of shift elements |
//! | [`shifts`] | the shifts between gears |
//! | [`progression`] | spread, steps and ideal progressions |
//! | [`elements`] | shift elements in a gear and over all gears |
//! | [`planets`] | largest planet speeds and forces over all gears |
//! | [`records`] | records shared by these answers |
//! | [`planet_bearings`] | forces on the planet bearings |
//! | [`sets`] | the planet sets: teeth, ratios, and whether their planets fit |
//! | [`step_losses`] | torques and powers with losses down to the efficiency, as steps of a calculation |
//! | [`step_torques`] | torques without losses and their balance, as steps of a calculation |
//! | [`warnings`] | warnings about a gearbox and its gears |
//!
//! Speeds are given relative to the input speed, torques relative to the input torque, powers relative to the
//! entering power. Keys that end in a unit are absolute values at the given speed and load.

pub mod combinations;
pub mod elements;
pub mod formulas;
pub mod gear;
pub mod inputs;
pub mod overview;
pub(crate) mod pins;
pub mod planet_bearings;
pub mod planets;
pub mod progression;
pub mod records;
pub mod sets;
pub mod shifts;
pub mod step_losses;
pub mod step_torques;
pub mod warnings;

use crate::error::Error;
pub use crate::refusal::LoadQuantity;
use epicyclic_train::{Analysis, Direction, Gear, Gearbox, InputLoad, LoadCase, Operation};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::{AngularVelocity, Torque};

/// Known motion and load of the input.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Input {
    /// Speed of the input.
    pub speed: Option<AngularVelocity>,
    /// Load of the input; with a torque but no speed, powers cannot be computed.
    pub load: Option<InputLoad>,
}

/// Speed and load of the input that were asked for.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct OperatingPoint {
    /// Input speed in rad/s; null if none was given.
    pub speed_rad_s: Option<f64>,
    /// Torque on the input in N·m; null if none was given.
    pub torque_n_m: Option<f64>,
    /// Power into the input in W, negative if the driven machine drives it; null if none was given.
    pub power_w: Option<f64>,
}

impl OperatingPoint {
    pub(crate) fn of(input: Input) -> Self {
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

/// Analyzes the gear with this name.
///
/// # Errors
/// [`Error::NoGear`] with the names of the existing gears.
pub fn analysis<'g>(gearbox: &'g Gearbox, gear: &str) -> Result<Analysis<'g>, Error> {
    match gearbox.analyze(gear) {
        // With a few short names, the full list helps more than the nearest name.
        Err(epicyclic_train::Error::Unknown { .. }) => Err(Error::NoGear {
            name: gear.to_owned(),
            gears: gearbox.gears().iter().map(|gear| gear.name().to_owned()).collect(),
        }),
        analysis => Ok(analysis?),
    }
}

/// Gear with the results at the speed and load of the input.
pub(crate) struct Worked<'g> {
    pub(crate) analysis: Analysis<'g>,
    input: Input,
    /// Speeds, torques and powers at the load; `None` without a load, or if the gear cannot carry it.
    pub(crate) operation: Option<Operation>,
    /// Places of the one-way clutches that overrun at the load, so that the gear cannot carry it.
    released: Vec<usize>,
}

impl<'g> Worked<'g> {
    /// Torques on the members of a set at the load, without losses; `None` where they do not follow.
    pub(crate) fn member_torques(&self, set: usize) -> Option<Vec<Torque>> {
        let (operation, case) = self.operation.as_ref().zip(self.analysis.ideal())?;
        let members = case.members[set].as_ref()?;
        Some(members.iter().map(|of| operation.input * (of / case.input)).collect())
    }

    pub(crate) fn new(gearbox: &'g Gearbox, gear: &str, input: Input) -> Result<Self, Error> {
        let analysis = analysis(gearbox, gear)?;
        // A torque alone gives no powers. The speed of 1 rad/s serves only to get the torques.
        let speed = input.speed.unwrap_or(AngularVelocity::from_si(1.0));
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
        let released = operation.as_ref().map_or_else(Vec::new, |operation| analysis.released(operation));
        let operation = operation.filter(|_| released.is_empty());
        Ok(Self { analysis, input, operation, released })
    }

    /// Whether the load brakes, so that the gear is driven from its output.
    fn is_back_driven(&self) -> bool {
        self.operation.as_ref().is_some_and(|operation| operation.direction == Direction::BackDrive)
    }

    /// Torques with losses in the actual direction of power.
    fn case(&self) -> Option<&LoadCase> {
        if self.is_back_driven() { self.analysis.back_driving() } else { self.analysis.driving() }
    }

    /// Torque of the load case relative to the input torque.
    fn of_input(&self, torque: impl Fn(&LoadCase) -> Option<f64>) -> Option<f64> {
        let case = self.case()?;
        torque(case).map(|torque| torque / case.input)
    }

    /// Speed in rad/s from a speed relative to the input; `None` if the input speed is not given.
    fn speed_rad_s(&self, of_input: Option<f64>) -> Option<f64> {
        self.input.speed.zip(of_input).map(|(speed, of)| (speed * of).si())
    }
}

/// Names of the shift elements that a gear engages.
fn engaged(gearbox: &Gearbox, gear: &Gear) -> Vec<String> {
    gear.engaged().iter().map(|&place| gearbox.shift_elements()[place].id().to_owned()).collect()
}

/// Efficiency if it is positive; `None` if the losses hold the gear.
pub(crate) fn moving(efficiency: Option<f64>) -> Option<f64> {
    efficiency.filter(|efficiency| *efficiency > 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::to_json;
    use crate::shared::gearbox::{Choice, one};
    use epicyclic_formats::Document;
    use epicyclic_train::error::Terminal;
    use std::path::Path;
    use uom::si::angular_velocity::revolution_per_minute;
    use uom::si::f64::Torque;
    use uom::si::torque::newton_meter;

    fn document(name: &str) -> Document {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
        Document::parse_one(name, &std::fs::read(file).unwrap()).unwrap()
    }

    #[test]
    fn the_engagement_table_stands_in_the_overview() {
        let document = document("scheme-ii-3.yaml");
        let subject = one(&document, &Choice::default()).unwrap();
        let overview = overview::answer(&subject, Input::default(), None).unwrap();
        let elements: Vec<&str> =
            overview.shift_elements.iter().map(|one| one.element.shift_element.as_str()).collect();
        assert_eq!(elements, ["K1", "K2", "L"]);
        let engaged: Vec<&[String]> =
            overview.gears.iter().map(|gear| gear.facts.engaged.as_slice()).collect();
        assert_eq!(engaged, [["K2"], ["K1"], ["L"]]);
    }

    #[test]
    fn a_gear_that_is_self_locking_from_its_input_has_power_leaving_when_back_driven() {
        let document = document("wolfrom-self-locking.yaml");
        let subject = one(&document, &Choice::default()).unwrap();
        let alone = gear::answer(&subject, "back", Input::default()).unwrap();
        let forward = alone.powers.unwrap();
        assert_eq!(forward.enters_at, Terminal::Input);
        assert!(forward.at_load.is_none());
        let forward = forward.of_entering.unwrap();
        assert!(forward.leaving.is_none() && forward.helping.unwrap() > 1.0);
        let braked = Input {
            speed: Some(AngularVelocity::new::<revolution_per_minute>(10.0)),
            load: Some(InputLoad::Torque(Torque::new::<newton_meter>(-100.0))),
        };
        let braked = gear::answer(&subject, "back", braked).unwrap();
        let backward = braked.powers.unwrap();
        assert_eq!(backward.enters_at, Terminal::Output);
        let of_entering = backward.of_entering.unwrap();
        assert!(of_entering.helping.is_none());
        assert_eq!(of_entering.leaving, braked.gear.back_driving_efficiency);
        let load = backward.at_load.unwrap();
        assert!((load.entering_w - load.leaving_w - load.loss_w).abs() < 1e-9 * load.entering_w);
    }

    /// A reversed torque releases the carrier, so that nothing carries the torque; the brake parallel to the
    /// one-way clutch does.
    #[test]
    fn a_one_way_clutch_takes_no_reversed_torque() {
        let document = document("ravigneaux.yaml");
        let subject = one(&document, &Choice::default()).unwrap();
        let braked = Input {
            speed: Some(AngularVelocity::new::<revolution_per_minute>(2000.0)),
            load: Some(InputLoad::Torque(Torque::new::<newton_meter>(-100.0))),
        };
        let first = gear::answer(&subject, "1", braked).unwrap();
        assert!(first.torques.unwrap().at_load.is_none() && first.powers.unwrap().at_load.is_none());
        assert!(first.shift_elements.iter().all(|element| element.does.torque_n_m.is_none()));
        assert_eq!(first.gear.back_driving_efficiency, None);
        let clutch = &first.one_way_clutches[0];
        assert_eq!((clutch.engine_braking, &clutch.beside[..]), (Some(false), &["LR".to_owned()][..]));
        let told = |warnings: &[crate::answer::Warning]| -> Vec<&'static str> {
            let names = warnings.iter().map(|warning| warning.name);
            names.filter(|name| *name != "teeth").collect()
        };
        assert_eq!(told(&first.warnings), ["one-way-clutch"]);
        let low = gear::answer(&subject, "1 low", braked).unwrap();
        assert!(told(&low.warnings).is_empty() && low.torques.unwrap().at_load.is_some());
        let all = overview::answer(&subject, braked, None).unwrap();
        let taken: Vec<bool> = all.gears.iter().map(|gear| gear.output_torque_n_m.is_some()).collect();
        assert_eq!(taken, [false, true, true, true, true, true]);
        assert_eq!(told(&all.warnings), ["one-way-clutch"]);
        let power = Input { load: Some(InputLoad::Torque(Torque::new::<newton_meter>(100.0))), ..braked };
        assert!(told(&gear::answer(&subject, "1", power).unwrap().warnings).is_empty());
    }

    #[test]
    fn keys_exist_without_a_load() {
        let document = document("scheme-ii-3.yaml");
        let subject = one(&document, &Choice::default()).unwrap();
        let json = to_json(&gear::answer(&subject, "slow", Input::default()).unwrap()).unwrap();
        for key in ["at_load", "torque_n_m", "speed_rad_s", "power_w", "slip_rad_s"] {
            assert!(json.contains(&format!("\"{key}\": null")), "{key}");
        }
        assert!(!json.contains("-0.0,"), "{json}");
    }

    #[test]
    fn what_is_refused_is_told_with_its_place_or_its_part_of_the_question() {
        let split = document("power-split.yaml");
        let subject = one(&split, &Choice::default()).unwrap();
        let speed = |link: &str| (link.to_owned(), AngularVelocity::new::<revolution_per_minute>(1000.0));
        let refused = |speeds: &[&str]| {
            let speeds = Some(speeds.iter().map(|link| speed(link)).collect());
            inputs::answer(&subject, "drive", &inputs::Wanted { speeds, torques: None }).unwrap_err()
        };
        assert!(matches!(refused(&["motor"]), Error::NoLink { given: inputs::Given::Speeds, .. }));
        assert!(matches!(refused(&["engine"]), Error::Inputs { given: inputs::Given::Speeds, .. }));
        let none = inputs::answer(&subject, "none", &inputs::Wanted::default()).unwrap_err();
        assert_eq!(none.to_string(), "no gear is called `none`: there are drive, generator held");
        let held = inputs::answer(&subject, "generator held", &inputs::Wanted::default()).unwrap_err();
        assert!(held.to_string().starts_with("power-split.yaml:"), "{held}");
        let many = document("real-transmissions.yaml");
        assert!(matches!(one(&many, &Choice::default()), Err(Error::SeveralTransmissions { .. })));
        let named = |name: &str| Choice { transmission: Some(name.to_owned()), ..Choice::default() };
        assert!(matches!(one(&many, &named("o")), Err(Error::AmbiguousTransmission { .. })));
        assert!(matches!(one(&many, &named("?")), Err(Error::NoTransmission { .. })));
        assert!(matches!(one(&split, &named("o")), Err(Error::OneGearbox)));
        assert_eq!(one(&many, &named("8hp45")).unwrap().train.gears().len(), 9);
    }
}

//! A gear at work: its speeds, torques and powers as quantities.

use crate::error::OperatingFault;
use crate::solution::Direction;
use crate::tolerance::LARGEST_LOAD;
use crate::{Analysis, Error, State};
use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Power, Torque};

/// Known torque or power of the load at the input.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum InputLoad {
    /// Torque on the input from outside.
    Torque(Torque),
    /// Power that enters at the input; negative where the machine drives the input and power leaves there.
    Power(Power),
}

/// Speeds, torques and powers of a gear at an operating point.
///
/// Torques follow the [sign convention](epicyclic_gears#sign-convention) of the workspace. A shift element's
/// torque acts on its first link.
#[derive(Debug, Clone, PartialEq)]
pub struct Operation {
    /// Direction of power, from the sign of the input's.
    pub direction: Direction,
    /// Speed of each link by [`LinkId::index`](crate::LinkId::index); `None` where it does not follow.
    pub speeds: Vec<Option<AngularVelocity>>,
    /// Slip of each shift element.
    pub slips: Vec<Option<AngularVelocity>>,
    /// Torques on the members of each set, in the order of [`PlanetSet::members`](crate::PlanetSet::members).
    pub members: Vec<Option<Vec<Torque>>>,
    /// Torque of each shift element.
    pub shift_elements: Vec<Option<Torque>>,
    /// Torque on the input.
    pub input: Torque,
    /// Torque on the output.
    pub output: Torque,
    /// Power through each link.
    pub links: Vec<Option<Power>>,
    /// Power that the meshes take.
    pub loss: Power,
    /// Power that enters and leaves again: at the input when driving, at the output when back-driven.
    pub entering: Power,
}

impl Analysis<'_> {
    /// Computes the gear at this input speed and load, with losses.
    ///
    /// Power that enters at the input takes [`driving`](Analysis::driving); power that leaves there
    /// takes [`back_driving`](Analysis::back_driving), scaled to the input's load.
    ///
    /// ```
    /// use epicyclic_train::{Gearbox, InputLoad, set::SetSpec};
    /// use uom::si::angular_velocity::revolution_per_minute;
    /// use uom::si::f64::{AngularVelocity, Torque};
    /// use uom::si::torque::newton_meter;
    /// # fn main() -> Result<(), epicyclic_train::Error> {
    /// let gearbox = Gearbox::builder("conveyor")
    ///     .links(["D", "B", "T1"])
    ///     .set(SetSpec::simple("1", ["D", "T1", "B"], 3.0))
    ///     .brake("K1", "T1")
    ///     .input("D")
    ///     .output("B")
    ///     .gear("slow", ["K1"])
    ///     .build()?;
    /// let rpm = AngularVelocity::new::<revolution_per_minute>;
    /// let load = InputLoad::Torque(Torque::new::<newton_meter>(500.0));
    /// let work = gearbox.analyze("slow")?.at(rpm(1480.0), load)?;
    /// // The brake holds what input and output leave: −T_in − T_out = 1500 N·m.
    /// assert!((work.shift_elements[0].unwrap().get::<newton_meter>() - 1500.0).abs() < 1e-9);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// - [`Error::NotDriven`] in any other state, or if no torque moves the gear;
    /// - [`Error::OperatingPoint`] for a speed or load that is not finite, and for power at rest;
    /// - [`Error::OperatingPoint`] also for power out of the input of a gear that is self-locking in that
    ///   direction.
    pub fn at(&self, input_speed: AngularVelocity, load: InputLoad) -> Result<Operation, Error> {
        let refuse = |why| Error::OperatingPoint { why };
        let not_driven = || Error::NotDriven { state: self.state().to_string() };
        let speed_rad_s = input_speed.si();
        let torque_n_m = match load {
            InputLoad::Torque(torque) => torque.si(),
            InputLoad::Power(_) if speed_rad_s == 0.0 => {
                return Err(refuse(OperatingFault::PowerAtRest));
            }
            InputLoad::Power(power) => power.si() / speed_rad_s,
        };
        if ![speed_rad_s, torque_n_m].iter().all(|value| value.abs() <= LARGEST_LOAD) {
            return Err(refuse(OperatingFault::NoNumber));
        }
        if self.ideal().is_none()
            || matches!(self.state(), State::SelfLocking { .. }) && torque_n_m * speed_rad_s >= 0.0
        {
            return Err(not_driven());
        }
        let direction = if torque_n_m * speed_rad_s >= 0.0 { Direction::Drive } else { Direction::BackDrive };
        let (case, scale) = match direction {
            Direction::Drive => (self.driving(), torque_n_m),
            Direction::BackDrive => {
                let case = self.back_driving().filter(|case| case.efficiency > 0.0);
                let locked = refuse(OperatingFault::SelfLocking);
                let case = case.ok_or(locked)?;
                (Some(case), torque_n_m / case.input)
            }
        };
        let case = case.ok_or_else(not_driven)?;
        let of_speed = |x: &Option<f64>| x.map(|x| AngularVelocity::from_si(x * speed_rad_s));
        let of_torque = |x: f64| Torque::from_si(x * scale);
        let of_power = |x: f64| Power::from_si(x * (scale * speed_rad_s).abs());
        Ok(Operation {
            direction,
            speeds: self.speeds().iter().map(of_speed).collect(),
            slips: self.slips().iter().map(of_speed).collect(),
            members: case
                .members
                .iter()
                .map(|m| m.as_ref().map(|m| m.iter().copied().map(of_torque).collect()))
                .collect(),
            shift_elements: case.shift_elements.iter().map(|c| c.map(of_torque)).collect(),
            input: of_torque(case.input),
            output: of_torque(case.output),
            links: case.power.links.iter().map(|p| p.map(of_power)).collect(),
            loss: of_power(1.0 - case.efficiency),
            entering: of_power(1.0),
        })
    }
}

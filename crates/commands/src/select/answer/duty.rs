//! Speed and load of the input of a gearbox to be chosen.

use crate::error::Error;
pub use crate::refusal::{DutyProblem, DutyQuantity};
use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Power, Torque};

/// Known speed and load of the input.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Duty {
    /// Speed of the input.
    pub input_speed: Option<AngularVelocity>,
    /// Load of the input.
    pub load: Option<Load>,
}

/// Load on an input.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Load {
    /// Torque on the input.
    Torque(Torque),
    /// Power into the input, which requires a speed.
    Power(Power),
}

impl Duty {
    /// Computes the torque on the input, as given or from power and speed.
    ///
    /// # Errors
    /// [`Error::Duty`].
    pub fn torque(&self) -> Result<Option<Torque>, Error> {
        let positive = |value: f64, quantity| {
            if is_positive(value) { Ok(value) } else { Err(DutyProblem::NotPositive { quantity }) }
        };
        let rad_s = |speed: AngularVelocity| positive(speed.si(), DutyQuantity::InputSpeed);
        let speed_rad_s = self.input_speed.map(rad_s).transpose()?;
        match self.load {
            None => Ok(None),
            Some(Load::Torque(torque)) => {
                positive(torque.si(), DutyQuantity::Torque)?;
                Ok(Some(torque))
            }
            Some(Load::Power(power)) => {
                let power_w = positive(power.si(), DutyQuantity::Power)?;
                let torque_n_m = power_w / speed_rad_s.ok_or(DutyProblem::PowerWithoutSpeed)?;
                if !is_positive(torque_n_m) {
                    return Err(DutyProblem::TorqueOfPower { torque_n_m }.into());
                }
                Ok(Some(Torque::from_si(torque_n_m)))
            }
        }
    }
}

fn is_positive(value: f64) -> bool {
    value > 0.0 && value.is_finite()
}

#[cfg(test)]
mod tests {
    use super::*;
    use uom::si::angular_velocity::radian_per_second;
    use uom::si::power::watt;

    #[test]
    fn a_power_gives_a_torque_at_a_speed() {
        let power = Load::Power(Power::new::<watt>(75e3));
        let speed = AngularVelocity::new::<radian_per_second>(150.0);
        let torque = |duty: Duty| duty.torque().map(|torque| torque.map(|torque| torque.value));
        let found = torque(Duty { input_speed: Some(speed), load: Some(power) });
        assert!((found.unwrap().unwrap() - 500.0).abs() < 1e-9);
        let refused = torque(Duty { input_speed: None, load: Some(power) });
        assert!(matches!(refused, Err(Error::Duty(DutyProblem::PowerWithoutSpeed))));
        let refused = torque(Duty { input_speed: Some(-speed), load: None });
        let quantity = DutyQuantity::InputSpeed;
        assert!(
            matches!(refused, Err(Error::Duty(DutyProblem::NotPositive { quantity: q })) if q == quantity)
        );
        let tiny = AngularVelocity::new::<radian_per_second>(1e-320);
        let refused = torque(Duty { input_speed: Some(tiny), load: Some(power) });
        assert!(matches!(refused, Err(Error::Duty(DutyProblem::TorqueOfPower { .. }))));
    }
}

//! A step of the load of the command line.

use epicyclic_units::{Physical, Quantity, QuantityError};
use std::str::FromStr;
use uom::si::f64::Ratio;

/// Share of the time, and torque and speed over those of the load: `20% 1 0.5`; without a speed that of the load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadStep(pub [f64; 3]);

impl FromStr for LoadStep {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        // A percent sign may stand apart from its number.
        let joined = text.replace(" %", "%");
        let number = |part: &str| -> Result<f64, String> {
            let value: Quantity<Ratio> = part.parse().map_err(|error: QuantityError| error.to_string())?;
            let value = value.0.si();
            let is_allowed = value.is_finite() && value >= 0.0;
            if is_allowed { Ok(value) } else { Err(format!("{part}: a step has no number below 0")) }
        };
        let parts: Vec<f64> = joined.split_whitespace().map(number).collect::<Result<_, _>>()?;
        match parts[..] {
            [share, torque, 0.0] if torque > 0.0 => Err(format!(
                "{text}: a step at rest has no torque here; write {share} 0 0, and --overload for a torque at rest"
            )),
            [share, torque, speed] => Ok(Self([share, torque, speed])),
            [share, torque] => Ok(Self([share, torque, 1.0])),
            _ => Err(format!(
                "{text}: a step is its share of the time, its torque and its speed over those of the load, as 20% 0.5 1; \
                 several steps are parted by commas"
            )),
        }
    }
}

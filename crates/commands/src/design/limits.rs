//! Options of an order for the whole gearbox.

use super::answer::limits::OrderLimits;
use super::answer::ways_out::rounded;
use super::request::Request;
use super::values::greatest;
use crate::failure::Failure;
use crate::shared::application::Application;
use epicyclic_units::format::trimmed;
use epicyclic_units::{Dimension, Physical};

impl Request {
    /// Limits of the whole gearbox.
    pub(super) fn limits(&self) -> Result<OrderLimits, Failure> {
        let is_robot = self.sizes.application == Some(Application::Robot);
        if self.max_length.is_some() && is_robot {
            let message = "the length of flanges is not known here, with which --application robot designs gearboxes; leave it out";
            return Err(Failure::invalid("--max-length", message));
        }
        let runaway_over_speed = self.runaway()?;
        Ok(OrderLimits {
            whole_kg: self.max_mass.map(|mass| mass.0.si()),
            length_m: self.max_length.map(|length| length.0.si()),
            runaway_over_speed,
            runaway_speed_rad_s: runaway_over_speed.map(|factor| factor * self.input.0.si().abs()),
            side_load_n: self.side_load.map(|force| force.0.si()),
            ..OrderLimits::default()
        })
    }

    /// Greatest speed of the input without load over that of the load.
    pub(super) fn runaway(&self) -> Result<Option<f64>, Failure> {
        let factor = greatest("--runaway", self.runaway, "speed", 1.2)?;
        let (input, largest) = (self.input.0.si().abs(), Dimension::AngularSpeed.largest());
        match factor.filter(|factor| factor * input > largest) {
            None => Ok(factor),
            Some(factor) => {
                let [factor, most] = [factor, rounded(largest / input, f64::floor)].map(|of| trimmed(of, 6));
                let message = format!("{factor}: with this speed of --input at most {most}");
                Err(Failure::invalid("--runaway", message))
            }
        }
    }

    /// Steps of the load with a speed without load, which has no share of the time.
    pub(super) fn spectrum(&self, usual: &[[f64; 3]]) -> Result<Vec<[f64; 3]>, Failure> {
        let mut steps = self.steps(usual)?;
        steps.extend(self.runaway()?.map(|speed| [0.0, 0.0, speed]));
        Ok(steps)
    }
}

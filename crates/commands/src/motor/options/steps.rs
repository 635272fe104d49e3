//! Values in steps: `20deg..30deg/5`, both ends and how many values, or one value alone.

use crate::failure::Failure;
use epicyclic_hydromotor::search::forms::Steps;
use epicyclic_units::visible::one_line;
use epicyclic_units::{Number, Physical as _, Quantity};
use std::fmt;
use std::str::FromStr;
use uom::si::f64::Angle;

/// From one value to another, with how many values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stepped<T> {
    from: T,
    to: T,
    values: u32,
}

/// A quantity that can be given in steps.
pub trait Step: FromStr<Err: fmt::Display> + Copy {
    /// Example for error messages.
    const EXAMPLE: &'static str;

    /// In its SI unit.
    fn size(self) -> f64;
}

impl Step for Number {
    const EXAMPLE: &'static str = "0.7..1/7";

    fn size(self) -> f64 {
        self.get()
    }
}

impl Step for Quantity<Angle> {
    const EXAMPLE: &'static str = "20deg..30deg/5";

    fn size(self) -> f64 {
        self.0.si()
    }
}

impl<T: Step> FromStr for Stepped<T> {
    type Err = String;

    fn from_str(written: &str) -> Result<Self, String> {
        let form = || {
            let example = T::EXAMPLE;
            format!("{}: write one value, or both ends and how many values, as {example}", one_line(written))
        };
        let value = |text: &str| text.trim().parse::<T>().map_err(|error| error.to_string());
        let Some((from, rest)) = written.split_once("..") else {
            let one = value(written).map_err(|error| format!("{}; {error}", form()))?;
            return Ok(Self { from: one, to: one, values: 1 });
        };
        let (to, values) = rest.rsplit_once('/').ok_or_else(form)?;
        let values = values.trim().parse().ok().filter(|values| *values >= 2).ok_or_else(form)?;
        let (from, to) = (value(from)?, value(to)?);
        if from.size() >= to.size() {
            return Err(format!("{}: write the smaller end first", one_line(written)));
        }
        Ok(Self { from, to, values })
    }
}

impl Stepped<Number> {
    pub(crate) fn steps(self) -> Steps<f64> {
        let (from, to) = (self.from.get(), self.to.get());
        if self.values == 1 {
            Steps::fixed(from)
        } else {
            Steps { from, to, step: (to - from) / self.intervals() }
        }
    }
}

impl Stepped<Quantity<Angle>> {
    pub(crate) fn steps(self) -> Steps<Angle> {
        let (from, to) = (self.from.0, self.to.0);
        if self.values == 1 {
            Steps::fixed(from)
        } else {
            Steps { from, to, step: (to - from) / self.intervals() }
        }
    }
}

impl<T> Stepped<T> {
    fn intervals(&self) -> f64 {
        f64::from(self.values - 1)
    }
}

/// Several choices, each named once.
pub(crate) fn each_once<T: PartialEq + Copy + fmt::Display>(
    option: &'static str,
    choices: &[T],
) -> Result<Vec<T>, Failure> {
    for (place, choice) in choices.iter().enumerate() {
        if choices[..place].contains(choice) {
            return Err(Failure::invalid(option, format!("{choice} is named twice")));
        }
    }
    Ok(choices.to_vec())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_range_names_its_ends_and_how_many_values() {
        let steps = "0.7..1/7".parse::<Stepped<Number>>().unwrap().steps();
        assert!((steps.from, steps.to) == (0.7, 1.0) && (steps.step - 0.05).abs() < 1e-15);
        let steps = "-0.1 .. 0.1 / 3".parse::<Stepped<Number>>().unwrap().steps();
        assert_eq!((steps.from, steps.to, steps.step), (-0.1, 0.1, 0.1));
        assert_eq!("0.85".parse::<Stepped<Number>>().unwrap().steps(), Steps::fixed(0.85));
        let steps = "20deg..30deg/5".parse::<Stepped<Quantity<Angle>>>().unwrap().steps();
        assert!((steps.step.value.to_degrees() - 2.5).abs() < 1e-12);
    }

    #[test]
    fn what_is_no_range_says_how_to_write_one() {
        for written in ["0.7..1", "0.7..1/1", "1..0.7/3", "1..1/3", "0.7..1/x", "a", "..1/3", "20..30deg/3"] {
            let told = match written {
                "20..30deg/3" => written.parse::<Stepped<Quantity<Angle>>>().map(|_| ()).unwrap_err(),
                _ => written.parse::<Stepped<Number>>().map(|_| ()).unwrap_err(),
            };
            assert!(!told.is_empty(), "{written}");
        }
        let told = "0.7..1".parse::<Stepped<Number>>().unwrap_err();
        assert_eq!(told, "0.7..1: write one value, or both ends and how many values, as 0.7..1/7");
    }
}

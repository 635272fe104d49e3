//! Tolerance of a printed figure, as implied by its digits.

use epicyclic_units::{self as quantity, Measured, QuantityError};
use schemars::JsonSchema;
use serde::Deserialize;

/// Rounding by which the source obtained the digits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Rounding {
    /// Rounded to nearest: within half a unit of the last digit, both ends included.
    #[default]
    Nearest,
    /// Truncated: digits cut off, toward zero.
    Truncated,
}

/// Printed figure with the range of values that it represents.
#[derive(Debug, Clone)]
pub struct Printed {
    /// Number, digits and unit.
    pub measured: Measured,
    /// Lower end of the range of values that the figure represents, in its own unit; the upper end follows.
    low: f64,
    high: f64,
    open_end: OpenEnd,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum OpenEnd {
    None,
    Low,
    High,
}

/// Width of a stated tolerance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Width {
    /// No wider than the digits.
    Idle,
    /// Wider than the digits.
    Wide,
    /// Beyond ten half-units of the last digit, or beyond 2 %.
    Loose,
}

/// Half-units of the last printed digit beyond which a tolerance is loose.
const LOOSE_HALF_UNITS: f64 = 10.0;
/// Relative tolerance above which a tolerance is loose.
const LOOSE_SHARE: f64 = 0.02;

/// Relative margin for the rounding of the comparison itself.
const SLACK: f64 = 4.0 * f64::EPSILON;

impl Printed {
    /// Reads a figure with the tolerance of its digits.
    ///
    /// # Errors
    /// As [`quantity::parse`].
    pub fn parse(text: &str, rounding: Rounding) -> Result<Self, QuantityError> {
        let measured = quantity::parse(text)?;
        let (value, unit) = (measured.value, last_digit(&measured.number));
        let (low, high, open_end) = match rounding {
            Rounding::Nearest => (value - unit / 2.0, value + unit / 2.0, OpenEnd::None),
            Rounding::Truncated if value < 0.0 || measured.number.starts_with(['-', '−']) => {
                (value - unit, value, OpenEnd::Low)
            }
            Rounding::Truncated => (value, value + unit, OpenEnd::High),
        };
        Ok(Self { measured, low, high, open_end })
    }

    /// Adds a stated tolerance: relative for `2 %`, otherwise absolute and in a unit of the figure's
    /// dimension.
    ///
    /// # Errors
    /// The error of a tolerance that cannot be read, or has another dimension.
    pub fn with_tolerance(self, tolerance: &str) -> Result<Self, QuantityError> {
        let stated = quantity::parse(tolerance)?;
        let half_width = if stated.unit.symbol == "%" {
            stated.si() * self.measured.value.abs()
        } else {
            quantity::parse_as(tolerance, self.measured.dimension())?.si() / self.measured.unit.factor
        };
        let value = self.measured.value;
        Ok(Self { low: value - half_width, high: value + half_width, open_end: OpenEnd::None, ..self })
    }

    /// Width of a stated tolerance of this figure.
    ///
    /// # Errors
    /// As [`Printed::with_tolerance`].
    pub fn width(&self, tolerance: &str) -> Result<Width, QuantityError> {
        let reach = self.clone().with_tolerance(tolerance)?.reach();
        let beyond = |limit: f64| reach > limit * (1.0 + 1e-9);
        let half_unit = last_digit(&self.measured.number) / 2.0;
        Ok(if beyond(LOOSE_HALF_UNITS * half_unit) || beyond(LOOSE_SHARE * self.measured.value.abs()) {
            Width::Loose
        } else if beyond(self.reach()) {
            Width::Wide
        } else {
            Width::Idle
        })
    }

    /// Converts a value from SI units to the unit of the figure.
    #[must_use]
    pub fn in_unit(&self, si: f64) -> f64 {
        si / self.measured.unit.factor
    }

    /// Whether the figure represents a value in SI units.
    #[must_use]
    pub fn stands_for(&self, si: f64) -> bool {
        let value = self.in_unit(si);
        let slack = SLACK * self.measured.value.abs().max(value.abs());
        let above =
            if self.open_end == OpenEnd::Low { value > self.low + slack } else { value >= self.low - slack };
        let below = if self.open_end == OpenEnd::High {
            value < self.high - slack
        } else {
            value <= self.high + slack
        };
        above && below
    }

    /// Distance of the ends of the represented range from the figure, in its unit.
    #[must_use]
    pub fn reach(&self) -> f64 {
        (self.high - self.measured.value).max(self.measured.value - self.low)
    }
}

/// One unit of the last printed digit.
fn last_digit(number: &str) -> f64 {
    let (mantissa, exponent) = match number.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.replace('−', "-").parse().unwrap_or(0)),
        None => (number, 0),
    };
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len() as i32);
    10.0_f64.powi(exponent - decimals)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nearest(text: &str) -> Printed {
        Printed::parse(text, Rounding::Nearest).unwrap()
    }

    fn truncated(text: &str) -> Printed {
        Printed::parse(text, Rounding::Truncated).unwrap()
    }

    #[test]
    fn half_a_unit_of_the_last_digit_is_within() {
        let figure = nearest("2.94");
        assert!(figure.stands_for(2.935) && figure.stands_for(2.945));
        assert!(!figure.stands_for(2.934_9) && !figure.stands_for(2.945_1));
        assert!(nearest("90").stands_for(89.5) && !nearest("90").stands_for(89.4));
        assert!(nearest("1.2e3").stands_for(1249.0) && !nearest("1.2e3").stands_for(1251.0));
    }

    #[test]
    fn truncation_goes_toward_zero() {
        let figure = truncated("0.977");
        assert!(figure.stands_for(0.977) && figure.stands_for(0.977_999));
        assert!(!figure.stands_for(0.978) && !figure.stands_for(0.976_9));
        let negative = truncated("−0.58");
        assert!(negative.stands_for(-0.588) && !negative.stands_for(-0.575) && !negative.stands_for(-0.59));
    }

    #[test]
    fn the_figures_unit_is_the_one_of_its_digits() {
        let figure = nearest("106.5 kW");
        assert!(figure.stands_for(106_540.0) && !figure.stands_for(106_560.0));
        assert!((figure.in_unit(106_540.0) - 106.54).abs() < 1e-12);
    }

    #[test]
    fn a_stated_tolerance_replaces_that_of_the_digits() {
        assert!(nearest("100 mm").with_tolerance("2 %").unwrap().stands_for(0.1019));
        assert!(!nearest("100 mm").with_tolerance("1 mm").unwrap().stands_for(0.1019));
        assert!(nearest("100 mm").with_tolerance("1 kg").is_err());
        assert!(nearest("0.97").with_tolerance("0.02").unwrap().stands_for(0.985));
    }

    #[test]
    fn a_tolerance_is_loose_beyond_ten_half_units_or_two_per_cent() {
        let width = |figure: &str, tolerance: &str| nearest(figure).width(tolerance).unwrap();
        assert_eq!(width("204.1 rad/s", "0.05 rad/s"), Width::Idle);
        assert_eq!(width("204.1 rad/s", "0.5 rad/s"), Width::Wide);
        assert_eq!(width("204.1 rad/s", "0.51 rad/s"), Width::Loose);
        assert_eq!(width("4.0", "2 %"), Width::Wide);
        assert_eq!(width("4.0", "2.1 %"), Width::Loose);
        assert!(nearest("4.0").width("1 kg").is_err());
    }
}

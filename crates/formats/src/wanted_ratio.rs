//! The ratio wanted of a gear: `4.714`, `4.714±0.5%`, `4.5..4.9`, `?`, `(-3.295)`.
//!
//! | written | means |
//! |---|---|
//! | `4.714` | this ratio, within the tolerance of the list |
//! | `4.714±0.5%`, `4.714+-0.5%` | within 0.5 % of it |
//! | `4.714±0.02` | from 4.694 to 4.734 |
//! | `4.5..4.9`, `-5..-3` | any ratio of this range |
//! | `?` | any ratio between those before and after it in the list |
//! | `(-3.295)`, `(4.5..4.9)` | the same, and the gear may be missing |
//!
//! A ratio is input speed over output speed, negative for reverse.

use epicyclic_units::visible::one_line;
use epicyclic_units::{Physical as _, Quantity, QuantityError, parse_number};
use std::fmt;
use std::str::FromStr;
use uom::si::f64::Ratio;

/// A gear of a list of ratios.
///
/// ```
/// use epicyclic_formats::wanted_ratio::{Within, Wanted, WantedRatio};
///
/// let first: WantedRatio = "4.714±0.5%".parse()?;
/// assert_eq!(first.wanted, Wanted::Around { ratio: 4.714, within: Some(Within::Share(0.005)) });
/// let reverse: WantedRatio = "(-5..-3)".parse()?;
/// assert!(reverse.optional);
/// assert_eq!(reverse.wanted, Wanted::Range { least: -5.0, most: -3.0 });
/// assert_eq!(
///     "4.9..4.5".parse::<WantedRatio>().unwrap_err().to_string(),
///     "4.9..4.5: write the smaller number first: 4.5..4.9"
/// );
/// # Ok::<(), epicyclic_formats::wanted_ratio::WantedRatioError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WantedRatio {
    /// Ratio of the gear.
    pub wanted: Wanted,
    /// Whether the gear may be missing.
    pub optional: bool,
}

/// Ratios that a gear may have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Wanted {
    /// Ratios near one.
    Around {
        /// The ratio, not 0.
        ratio: f64,
        /// How near; nothing where the tolerance of the list holds.
        within: Option<Within>,
    },
    /// Ratios from the lower to the upper bound, of one sign.
    Range {
        /// The lower.
        least: f64,
        /// The upper.
        most: f64,
    },
    /// Ratios between those of the gears before and after.
    Free,
}

/// How near a ratio has to be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Within {
    /// As a share of it, above 0 and below 1.
    Share(f64),
    /// As a difference, above 0 and below the ratio's size.
    Difference(f64),
}

/// A text that is no wanted ratio.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum WantedRatioError {
    /// A number that cannot be read.
    #[error("{reason}; a gear is written as 4.714, 4.714±0.5%, 4.5..4.9, ? or (-3.295)")]
    Number {
        /// The text of the gear.
        text: String,
        /// Fault of the text, with the text of the number.
        reason: QuantityError,
    },
    /// A range with one end.
    #[error("{}: write both ends of the range, such as 4.5..4.9", one_line(text))]
    Open {
        /// The text of the gear.
        text: String,
    },
    /// The greater number first.
    #[error("{}: write the smaller number first: {most}..{least}", one_line(text))]
    Reversed {
        /// The text of the gear.
        text: String,
        /// The end that was written first.
        least: f64,
        /// The other.
        most: f64,
    },
    /// Bounds that hold 0.
    #[error("{}: no gear has the ratio 0, and its bounds need one sign", one_line(text))]
    Zero {
        /// The text of the gear.
        text: String,
    },
    /// A tolerance that is not above 0.
    #[error("{}: the tolerance must be above 0", one_line(text))]
    Tolerance {
        /// The text of the gear.
        text: String,
    },
    /// A bracket without its fellow.
    #[error("{}: a gear that may be missing stands between brackets: (-3.295)", one_line(text))]
    Bracket {
        /// The text of the gear.
        text: String,
    },
}

impl FromStr for WantedRatio {
    type Err = WantedRatioError;

    fn from_str(text: &str) -> Result<Self, WantedRatioError> {
        let text = text.trim();
        let inner = match (text.strip_prefix('('), text.strip_suffix(')')) {
            (Some(_), Some(_)) if text.len() > 1 => &text[1..text.len() - 1],
            (None, None) => text,
            _ => return Err(WantedRatioError::Bracket { text: text.into() }),
        };
        Ok(Self { wanted: Wanted::read(inner, text)?, optional: inner.len() < text.len() })
    }
}

impl Wanted {
    fn read(inner: &str, text: &str) -> Result<Self, WantedRatioError> {
        let text = || text.to_owned();
        let number = |part: &str| {
            parse_number(part).map_err(|reason| WantedRatioError::Number { text: text(), reason })
        };
        if inner.trim() == "?" {
            return Ok(Self::Free);
        }
        if let Some((from, to)) = inner.split_once("..") {
            if from.trim().is_empty() || to.trim().is_empty() {
                return Err(WantedRatioError::Open { text: text() });
            }
            let (least, most) = (number(from)?, number(to)?);
            return if least > most {
                Err(WantedRatioError::Reversed { text: text(), least, most })
            } else if least * most <= 0.0 {
                Err(WantedRatioError::Zero { text: text() })
            } else {
                Ok(Self::Range { least, most })
            };
        }
        let sign = ["±", "+/-", "+-"].into_iter().find_map(|sign| inner.split_once(sign));
        let (ratio, within) = match sign {
            Some((ratio, within)) => (number(ratio)?, Some(within)),
            None => (number(inner)?, None),
        };
        if ratio == 0.0 {
            return Err(WantedRatioError::Zero { text: text() });
        }
        let within = match within {
            None => None,
            Some(share) if share.trim_end().ends_with('%') => {
                let share: Quantity<Ratio> =
                    share.parse().map_err(|reason| WantedRatioError::Number { text: text(), reason })?;
                Some(Within::Share(share.0.si()))
            }
            Some(difference) => Some(Within::Difference(number(difference)?)),
        };
        let difference = within.map(|within| within.difference(ratio));
        match difference {
            Some(difference) if difference <= 0.0 => Err(WantedRatioError::Tolerance { text: text() }),
            Some(difference) if difference >= ratio.abs() => Err(WantedRatioError::Zero { text: text() }),
            _ => Ok(Self::Around { ratio, within }),
        }
    }
}

impl Within {
    /// As a difference from this ratio.
    #[must_use]
    pub fn difference(self, ratio: f64) -> f64 {
        match self {
            Self::Share(share) => share * ratio.abs(),
            Self::Difference(difference) => difference,
        }
    }
}

impl fmt::Display for WantedRatio {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.optional { write!(f, "({})", self.wanted) } else { self.wanted.fmt(f) }
    }
}

impl fmt::Display for Wanted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Around { ratio, within: None } => write!(f, "{ratio}"),
            Self::Around { ratio, within: Some(within) } => write!(f, "{ratio}±{within}"),
            Self::Range { least, most } => write!(f, "{least}..{most}"),
            Self::Free => f.write_str("?"),
        }
    }
}

impl fmt::Display for Within {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Share(share) => write!(f, "{}%", epicyclic_units::format::trimmed(100.0 * share, 6)),
            Self::Difference(difference) => difference.fmt(f),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_people_write_is_read_and_written_alike() {
        for (text, written) in [
            ("4.714", "4.714"),
            (" -3.295 ", "-3.295"),
            ("4.714 ± 0.5 %", "4.714±0.5%"),
            ("4.714+-0.5%", "4.714±0.5%"),
            ("4.714+/-0.02", "4.714±0.02"),
            ("4.5..4.9", "4.5..4.9"),
            ("-5 .. -3", "-5..-3"),
            ("?", "?"),
            ("(-3.295)", "(-3.295)"),
            ("( 0.6±1% )", "(0.6±1%)"),
        ] {
            let read: WantedRatio = text.parse().unwrap();
            assert_eq!(read.to_string(), written);
            assert_eq!(written.parse(), Ok(read));
        }
    }

    #[test]
    fn what_is_no_ratio_is_refused_with_its_reason() {
        for (text, why) in [
            ("", "a gear is written as"),
            ("4,714", "decimal comma; write 4.714"),
            ("4.714±", "a gear is written as"),
            ("4.714±1,5%", "decimal comma"),
            ("0", "no gear has the ratio 0"),
            ("-1..1", "one sign"),
            ("2±2", "one sign"),
            ("2±100%", "one sign"),
            ("2±0%", "above 0"),
            ("2±-1", "above 0"),
            ("4.9..4.5", "write the smaller number first: 4.5..4.9"),
            ("4.5..", "both ends"),
            ("..", "both ends"),
            ("(4.5", "between brackets"),
            (")", "between brackets"),
            ("(", "between brackets"),
            ("nan", "a gear is written as"),
        ] {
            let refused = text.parse::<WantedRatio>().unwrap_err().to_string();
            assert!(refused.contains(why), "{text:?}: {refused}");
        }
    }
}

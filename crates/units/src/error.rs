//! Errors in the text of a number or a quantity.

use super::dimension::Dimension;
use crate::visible::one_line;

/// A text that is not the number or quantity it should be. Each message shows the text, what is wrong, and
/// what to write instead.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum QuantityError {
    /// A text of nothing but white space.
    #[error("empty text; write a number{}", example(*expected))]
    #[strum(serialize = "empty-text")]
    Empty {
        /// The required dimension, if it is known.
        expected: Option<Dimension>,
    },
    /// No number at the start.
    #[error("{text}: this does not start with a number; write a number{}", example(*expected), text = one_line(text))]
    NotANumber {
        /// The text.
        text: String,
        /// The required dimension, if it is known.
        expected: Option<Dimension>,
    },
    /// NaN, infinity, or too large for a double.
    #[error("{text}: not a finite number; write one such as 3.94", text = one_line(text))]
    NotFinite {
        /// The text.
        text: String,
    },
    /// A number or quantity larger than any machine has.
    #[error("{text}: too large; {} is at most {} in size", with_article(dimension.name()), most(*dimension), text = one_line(text))]
    TooLarge {
        /// The text.
        text: String,
        /// The dimension of the quantity.
        dimension: Dimension,
    },
    /// `1:50`, which is written of drives that reduce the speed fifty times, and means a fiftieth.
    #[error("{text}: this is read in two ways; write {above_1} for a drive that reduces the speed, or {below_1}", text = one_line(text))]
    EitherWay {
        /// The text.
        text: String,
        /// The value above 1.
        above_1: String,
        /// The value below 1, as a fraction.
        below_1: String,
    },
    /// `106,5 kW`.
    #[error("{text}: decimal comma; write {corrected}{}", or_thousands(thousands.as_deref()), text = one_line(text), corrected = one_line(corrected))]
    DecimalComma {
        /// The text.
        text: String,
        /// The text with a point for the comma.
        corrected: String,
        /// The text without the comma, where it may also separate thousands: `1,950 rpm`.
        thousands: Option<String>,
    },
    /// `1,950,000 mm`, `1 950 rpm`, `1'950 rpm`, `1_950 rpm`.
    #[error("{text}: separated thousands; write {corrected}", text = one_line(text), corrected = one_line(corrected))]
    ThousandsSeparator {
        /// The text.
        text: String,
        /// The text without the separators.
        corrected: String,
    },
    /// A bare number where a unit is required.
    #[error("{text}: no unit; write {corrected}, or another unit of {expected} ({})", expected.unit_list(), text = one_line(text), corrected = one_line(corrected))]
    MissingUnit {
        /// The text.
        text: String,
        /// The required dimension.
        expected: Dimension,
        /// The text with the usual unit.
        corrected: String,
    },
    /// A unit where a plain number is required.
    #[error("{text}: a plain number is due here, without a unit; write {corrected}", text = one_line(text), corrected = one_line(corrected))]
    UnexpectedUnit {
        /// The text.
        text: String,
        /// The number without the unit.
        corrected: String,
    },
    /// A unit we do not know.
    #[error("{text}: unknown unit {unit}{}{}", did_you_mean(corrected.as_deref()), of_dimension(*expected), text = one_line(text), unit = one_line(unit))]
    UnknownUnit {
        /// The text.
        text: String,
        /// The unit as written.
        unit: String,
        /// The required dimension, if it is known.
        expected: Option<Dimension>,
        /// The text with the most similar unit, if there is a similar one.
        corrected: Option<String>,
    },
    /// A unit that means different things to different engineers.
    #[error("{text}: {unit} may be several units; write {choices}", text = one_line(text), unit = one_line(unit))]
    AmbiguousUnit {
        /// The text.
        text: String,
        /// The unit as written.
        unit: String,
        /// The possible units, with a spelling for each.
        choices: String,
    },
    /// A unit of another dimension.
    #[error("{text}: {unit} is a unit of {found}, and {} is due; its units are {}", with_article(expected.name()), expected.unit_list(), text = one_line(text), unit = one_line(unit))]
    WrongDimension {
        /// The text.
        text: String,
        /// The unit as written.
        unit: String,
        /// The dimension of the unit.
        found: Dimension,
        /// The required dimension.
        expected: Dimension,
    },
}

impl QuantityError {
    /// The corrected text, if a correction is known.
    #[must_use]
    pub fn corrected(&self) -> Option<&str> {
        match self {
            Self::DecimalComma { corrected, .. }
            | Self::ThousandsSeparator { corrected, .. }
            | Self::MissingUnit { corrected, .. }
            | Self::UnexpectedUnit { corrected, .. } => Some(corrected),
            Self::UnknownUnit { corrected, .. } => corrected.as_deref(),
            _ => None,
        }
    }

    /// Proposes this unit for a number without one, in place of the usual unit of the dimension.
    #[must_use]
    pub fn in_unit(mut self, symbol: &str) -> Self {
        if let Self::MissingUnit { text, corrected, .. }
        | Self::ThousandsSeparator { text, corrected }
        | Self::DecimalComma { text, corrected, .. } = &mut self
            && text.ends_with(|end: char| end.is_ascii_digit())
            && let Some((number, _)) = corrected.split_once(' ')
        {
            *corrected = format!("{number} {symbol}");
        }
        self
    }

    /// Checks that the correction can be read, and corrects it once more if not: one fault may hide another,
    /// as a decimal comma hides the unit behind it.
    pub(super) fn settled(mut self, read: impl Fn(&str) -> Option<QuantityError>) -> Self {
        let settle = |text: &mut String| {
            // Comma, unit: no text has a third fault of these kinds.
            for _ in 0..3 {
                match read(text).as_ref().and_then(Self::corrected) {
                    Some(better) => *text = better.to_owned(),
                    None => return,
                }
            }
        };
        match &mut self {
            Self::DecimalComma { corrected, thousands, .. } => {
                settle(corrected);
                thousands.iter_mut().for_each(settle);
            }
            Self::ThousandsSeparator { corrected, .. }
            | Self::MissingUnit { corrected, .. }
            | Self::UnexpectedUnit { corrected, .. }
            | Self::UnknownUnit { corrected: Some(corrected), .. } => settle(corrected),
            _ => {}
        }
        self
    }

    /// The name of the variant, which does not change: `decimal-comma`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.into()
    }
}

/// `an angle`, `a torque`.
#[must_use]
pub fn with_article(noun: &str) -> String {
    let article = if noun.starts_with(['a', 'e', 'i', 'o', 'u']) { "an" } else { "a" };
    format!("{article} {noun}")
}

/// The largest size, in the SI unit.
fn most(dimension: Dimension) -> String {
    let largest = format!("{:e}", dimension.largest());
    match dimension {
        Dimension::Dimensionless => largest,
        dimension => format!("{largest} {}", dimension.si_unit().symbol),
    }
}

fn example(expected: Option<Dimension>) -> String {
    match expected {
        None | Some(Dimension::Dimensionless) => ", such as 3.94".to_owned(),
        Some(dimension) => {
            format!(" and a unit of {dimension}, such as 3.94 {}", dimension.usual_unit().symbol)
        }
    }
}

fn or_thousands(thousands: Option<&str>) -> String {
    thousands.map(|text| format!(", or {} if the comma parts thousands", one_line(text))).unwrap_or_default()
}

fn did_you_mean(corrected: Option<&str>) -> String {
    corrected.map(|text| format!("; write {}?", one_line(text))).unwrap_or_default()
}

fn of_dimension(expected: Option<Dimension>) -> String {
    expected
        .map(|dimension| format!(" (units of {dimension}: {})", dimension.unit_list()))
        .unwrap_or_default()
}

//! Value in an answer, formatted for tables, CSV and text.

use crate::tolerance::NOTHING;
use epicyclic_units::format::{in_unit, sensible_unit, significant, trimmed};
use epicyclic_units::{Dimension, Physical};
use serde::Serialize;
use std::borrow::Cow;
use std::fmt;
use uom::si::f64::{AngularVelocity, Time};

/// Significant digits of a number in a table.
const DIGITS: usize = 5;

/// Significant digits of a number in CSV.
const EXACT_DIGITS: usize = 12;

/// Decimals of a multiple in a table.
const DECIMALS: usize = 4;

/// Value with its kind, which determines its format.
#[derive(Debug, Clone)]
pub enum Figure {
    /// No value.
    None,
    /// Missing quantity, whose key keeps its unit.
    Without(Dimension),
    /// Count.
    Count(u32),
    /// Plain number.
    Number(f64),
    /// Multiple of the input's speed, torque or power, an efficiency, or a ratio. In a table it has as many
    /// decimals as its neighbours above and below.
    Multiple(f64),
    /// Figure of a source, with its number of decimals.
    Printed(f64, usize),
    /// Part of a whole, shown in per cent.
    Share(f64),
    /// Quantity in the unit that suits its size.
    Quantity {
        /// Value in SI units.
        si: f64,
        /// Dimension of the quantity.
        dimension: Dimension,
    },
    /// Quantity in a table whose heading names the unit.
    Column {
        /// Value in SI units.
        si: f64,
        /// Dimension of the quantity.
        dimension: Dimension,
    },
    /// Quantity with a given number of decimals in its usual unit, which its table names elsewhere.
    Measured {
        /// Value in SI units.
        si: f64,
        /// Dimension of the quantity.
        dimension: Dimension,
        /// Number of decimals.
        decimals: usize,
    },
    /// List of quantities of one kind.
    List {
        /// Values in SI units.
        si: Vec<f64>,
        /// Dimension of the quantities.
        dimension: Dimension,
    },
    /// List of numbers.
    Numbers(Vec<f64>),
    /// Name or word.
    Text(String),
    /// List of names, in CSV with a `+` between them.
    Texts(Vec<String>),
    /// Answer from a short list: its name, and its words.
    Answer(Cow<'static, str>, Cow<'static, str>),
    /// Answer to a yes-no question.
    YesNo(bool),
    /// Answer to a yes-no question in a table of marks.
    Mark(bool),
}

/// Figure of a multiple, or of none.
pub fn multiple(value: Option<f64>) -> Figure {
    value.map_or(Figure::None, Figure::Multiple)
}

/// Figure of a count with all its digits.
pub fn count(number: impl TryInto<u32> + fmt::Display + Copy) -> Figure {
    number.try_into().map_or_else(|_| Figure::Text(number.to_string()), Figure::Count)
}

/// Figure of a text.
pub fn text(text: impl Into<String>) -> Figure {
    Figure::Text(text.into())
}

/// Word for a choice, as in JSON.
fn word(choice: impl Serialize) -> String {
    struct Word<C>(C);
    impl<C: Serialize> fmt::Display for Word<C> {
        fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            self.0.serialize(f)
        }
    }
    Word(choice).to_string()
}

/// Values of a list in the usual unit, without it.
fn listed(si: &[f64], dimension: Dimension) -> String {
    si.iter().map(|si| trimmed(in_usual(*si, dimension), DIGITS)).collect::<Vec<_>>().join(" ")
}

impl Figure {
    /// Answer from a short list: its name, and its words.
    pub fn answer(name: impl Into<Cow<'static, str>>, words: impl Into<Cow<'static, str>>) -> Self {
        Self::Answer(name.into(), words.into())
    }

    /// Choice of a record; its name is the word in JSON.
    pub(crate) fn choice(choice: impl Serialize, words: impl Into<Cow<'static, str>>) -> Self {
        Self::answer(word(choice), words)
    }

    /// Text of the figure in a table.
    #[must_use]
    pub fn table(&self) -> String {
        match self {
            Self::None | Self::Without(_) => "-".to_owned(),
            Self::Count(count) => count.to_string(),
            Self::Number(value) => trimmed(*value, DIGITS),
            Self::Multiple(value) => shown_multiple(*value),
            Self::Printed(value, decimals) => format!("{value:.decimals$}"),
            Self::Share(value) => format!("{} %", trimmed(100.0 * value, 3)),
            Self::Quantity { si, dimension } => in_unit(*si, sensible_unit(*dimension, *si), DIGITS),
            Self::Column { si, dimension } => trimmed(in_usual(*si, *dimension), DIGITS),
            Self::Measured { si, dimension, decimals } => printed(in_usual(*si, *dimension), *decimals),
            Self::List { si, dimension } => {
                format!("{} {}", listed(si, *dimension), dimension.usual_unit().symbol)
            }
            Self::Numbers(values) => {
                values.iter().map(|value| shown_multiple(*value)).collect::<Vec<_>>().join(" ")
            }
            Self::Text(text) => text.clone(),
            Self::Texts(texts) if texts.is_empty() => "-".to_owned(),
            Self::Texts(texts) => texts.join(" "),
            Self::Answer(_, words) => words.clone().into_owned(),
            Self::YesNo(yes) => if *yes { "yes" } else { "no" }.to_owned(),
            Self::Mark(yes) => if *yes { "x" } else { "." }.to_owned(),
        }
    }

    /// Text of the figure in a column of quantities with this number of decimals.
    #[must_use]
    pub fn in_column(&self, decimals: usize) -> String {
        match self {
            Self::Column { si, dimension } => printed(in_usual(*si, *dimension), decimals),
            // The unit stands in the heading.
            Self::List { si, dimension } => listed(si, *dimension),
            other => other.table(),
        }
    }

    /// Value and unit of the figure in CSV.
    #[must_use]
    pub fn csv(&self) -> (String, String) {
        let exact = |value: f64| trimmed(value, EXACT_DIGITS);
        let joined = |values: &[f64]| values.iter().map(|value| exact(*value)).collect::<Vec<_>>().join(" ");
        let plain = |value: String| (value, String::new());
        match self {
            Self::None | Self::Without(_) => plain(String::new()),
            Self::Count(count) => plain(count.to_string()),
            Self::Number(value) | Self::Multiple(value) | Self::Printed(value, _) | Self::Share(value) => {
                plain(exact(*value))
            }
            Self::Quantity { si, dimension }
            | Self::Column { si, dimension }
            | Self::Measured { si, dimension, .. } => {
                (exact(in_usual(*si, *dimension)), dimension.usual_unit().symbol.to_owned())
            }
            Self::List { si, dimension } => {
                let values: Vec<f64> = si.iter().map(|si| in_usual(*si, *dimension)).collect();
                (joined(&values), dimension.usual_unit().symbol.to_owned())
            }
            Self::Numbers(values) => plain(joined(values)),
            Self::Text(text) => plain(text.clone()),
            Self::Texts(texts) => plain(texts.join("+")),
            Self::Answer(name, _) => plain(name.clone().into_owned()),
            Self::YesNo(yes) | Self::Mark(yes) => plain(yes.to_string()),
        }
    }

    /// Whether all numbers of the figure can be shown.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        match self {
            // Tables show a share multiplied by 100, which may overflow.
            Self::Share(value) => (100.0 * value).is_finite(),
            Self::Number(value) | Self::Multiple(value) | Self::Printed(value, _) => value.is_finite(),
            Self::Quantity { si, dimension }
            | Self::Column { si, dimension }
            | Self::Measured { si, dimension, .. } => si.is_finite() && in_usual(*si, *dimension).is_finite(),
            Self::List { si, dimension } => si.iter().all(|si| in_usual(*si, *dimension).is_finite()),
            Self::Numbers(values) => values.iter().all(|value| value.is_finite()),
            _ => true,
        }
    }
}

impl<F: Into<Figure>> From<Option<F>> for Figure {
    fn from(value: Option<F>) -> Self {
        value.map_or(Self::None, Into::into)
    }
}

impl From<bool> for Figure {
    fn from(yes: bool) -> Self {
        Self::YesNo(yes)
    }
}

impl From<u32> for Figure {
    fn from(count: u32) -> Self {
        Self::Count(count)
    }
}

impl From<usize> for Figure {
    fn from(number: usize) -> Self {
        count(number)
    }
}

impl From<u64> for Figure {
    fn from(number: u64) -> Self {
        count(number)
    }
}

impl From<f64> for Figure {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<&str> for Figure {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<String> for Figure {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<Vec<String>> for Figure {
    fn from(texts: Vec<String>) -> Self {
        Self::Texts(texts)
    }
}

/// Unit of drawings as part of a column's name in CSV.
#[must_use]
pub const fn suffix(dimension: Dimension) -> &'static str {
    match dimension {
        Dimension::Length => "_mm",
        Dimension::Area => "_mm2",
        Dimension::Volume => "_cm3",
        Dimension::VolumeRate => "_l_min",
        Dimension::Mass => "_kg",
        Dimension::Inertia => "_kg_m2",
        Dimension::Speed => "_m_s",
        Dimension::AngularSpeed => "_rpm",
        Dimension::AngularAcceleration => "_rad_s2",
        Dimension::Angle => "_deg",
        Dimension::Force => "_n",
        Dimension::Frequency => "_hz",
        Dimension::Stiffness => "_n_um",
        Dimension::TorsionalStiffness => "_n_m_rad",
        Dimension::Torque => "_n_m",
        Dimension::Power => "_kw",
        Dimension::Pressure => "_mpa",
        Dimension::Viscosity => "_mm2_s",
        Dimension::DynamicViscosity => "_mpa_s",
        Dimension::Energy => "_j",
        Dimension::Time => "_s",
        Dimension::TemperatureDifference => "_k",
        Dimension::ThermalExpansion => "_per_k",
        Dimension::PowerPerArea => "_w_mm2",
        Dimension::EnergyPerArea => "_j_mm2",
        _ => "",
    }
}

/// Number of decimals that gives the largest quantity of a column its significant digits.
pub fn decimals<'a>(column: impl Iterator<Item = &'a Figure>) -> usize {
    let sizes = column.filter_map(|figure| match figure {
        Figure::Column { si, dimension } => Some(in_usual(*si, *dimension).abs()),
        _ => None,
    });
    let largest = sizes.fold(0.0, f64::max);
    if largest == 0.0 {
        return 0;
    }
    let before_the_point = libm::log10(largest).floor() as i32;
    usize::try_from(DIGITS as i32 - 1 - before_the_point).unwrap_or(0).min(DECIMALS)
}

/// Formats with this number of decimals; a value that rounds to zero has no minus sign.
fn printed(value: f64, decimals: usize) -> String {
    let value = if value.abs() < 0.5 * 0.1_f64.powi(decimals as i32) { 0.0 } else { value };
    format!("{value:.decimals$}")
}

fn in_usual(si: f64, dimension: Dimension) -> f64 {
    si / dimension.usual_unit().factor
}

/// Formats with four decimals; a value smaller than 0.01 with four significant digits, unless it is a
/// rounding error of zero.
fn shown_multiple(value: f64) -> String {
    match value.abs() {
        size if size < NOTHING => format!("{:.DECIMALS$}", 0.0),
        size if size < 0.01 => significant(value, DECIMALS),
        size if size < 1000.0 => format!("{value:.DECIMALS$}"),
        _ => significant(value, DECIMALS + 3),
    }
}

/// Converts a speed from rad/s to rpm, the unit of drawings.
pub(crate) fn rpm(speed_rad_s: f64) -> f64 {
    AngularVelocity::from_si(speed_rad_s).rpm()
}

/// Converts a life from s to hours.
pub(crate) fn hours(life_s: f64) -> f64 {
    Time::from_si(life_s).hours()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn multiples_stand_below_each_other() {
        for (value, shown) in
            [(2.1063829, "2.1064"), (-1e-15, "0.0000"), (0.00122713, "0.001227"), (12345.678, "12345.68")]
        {
            assert_eq!(Figure::Multiple(value).table(), shown);
        }
    }

    #[test]
    fn a_unit_stands_in_the_key_or_in_the_heading() {
        let torque = Figure::Column { si: 1053.19, dimension: Dimension::Torque };
        assert_eq!(torque.table(), "1053.2");
        assert_eq!(suffix(Dimension::AngularSpeed), "_rpm");
        let speed = Figure::Quantity { si: std::f64::consts::PI, dimension: Dimension::AngularSpeed };
        assert_eq!(speed.table(), "30 rpm");
    }
}

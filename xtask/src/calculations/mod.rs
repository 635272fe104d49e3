//! Calculations that a case can name, and their results.
//!
//! A calculation is a function from a record of inputs to named results. It only translates: inputs into the
//! types of the domain crates, and their results into [`Value`]s. There is one file per crate.

mod bodies;
mod dynamics;
mod formulas;
mod gears;
mod hydromotor;
mod involute;
mod motion;
mod motor_teeth;
mod schemes;
mod selection;
mod strength;
mod synthesis;
mod vibration;

use epicyclic_formats::yaml::Value as Yaml;
use epicyclic_formats::{Document, Error as FormatError};
use epicyclic_units::{Dimension, Physical};
use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// One result of a calculation.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Value {
    /// A number in SI units.
    Quantity {
        /// In SI units.
        si: f64,
        /// Of what.
        #[serde(serialize_with = "dimension_name")]
        dimension: Dimension,
    },
    /// A number of things: exact.
    Count(i64),
    /// A word or a list of words: exact.
    Text(String),
}

fn dimension_name<S: serde::Serializer>(dimension: &Dimension, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(dimension)
}

/// Named results, in the order in which they were computed.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Results(Vec<(String, Value)>);

impl Results {
    /// Adds a physical quantity.
    pub fn quantity<T: Physical>(&mut self, name: impl Into<String>, quantity: T) -> &mut Self {
        self.push(name, Value::Quantity { si: quantity.si(), dimension: T::DIMENSION })
    }

    /// Adds a plain number.
    pub fn number(&mut self, name: impl Into<String>, value: f64) -> &mut Self {
        self.push(name, Value::Quantity { si: value, dimension: Dimension::Dimensionless })
    }

    /// Adds a number of things.
    pub fn count(&mut self, name: impl Into<String>, count: impl Into<i64>) -> &mut Self {
        self.push(name, Value::Count(count.into()))
    }

    /// Adds a word.
    pub fn text(&mut self, name: impl Into<String>, text: impl std::fmt::Display) -> &mut Self {
        self.push(name, Value::Text(text.to_string()))
    }

    /// Adds an answer, `yes` or `no`.
    pub fn answer(&mut self, name: impl Into<String>, answer: bool) -> &mut Self {
        self.text(name, if answer { "yes" } else { "no" })
    }

    fn push(&mut self, name: impl Into<String>, value: Value) -> &mut Self {
        let name = name.into();
        assert!(self.get(&name).is_none(), "a calculation returns {name} twice");
        self.0.push((name, value));
        self
    }

    /// The result of that name.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&Value> {
        self.0.iter().find(|(known, _)| known == name).map(|(_, value)| value)
    }

    /// Iterates over the results in their order.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &Value)> {
        self.0.iter().map(|(name, value)| (name.as_str(), value))
    }
}

/// Why a calculation refused its inputs.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{message}")]
pub struct Refusal {
    /// Name of the fault, as `expect_error` has it: `no-tooth-numbers`.
    pub name: String,
    /// Message about the fault, with the allowed values.
    pub message: String,
}

/// Errors with a name of their own.
macro_rules! refusals {
    ($($error:ty,)*) => {$(
        impl From<$error> for Refusal {
            fn from(error: $error) -> Self {
                Self { name: error.name().to_owned(), message: error.to_string() }
            }
        }
    )*};
}

refusals! {
    epicyclic_gears::Error,
    epicyclic_train::Error,
    epicyclic_schemes::Error,
    epicyclic_selection::Error,
    epicyclic_dynamics::Error,
    epicyclic_hydromotor::Error,
    epicyclic_strength::Error,
    epicyclic_motion::Error,
    epicyclic_vibration::Error,
    epicyclic_formats::Faults,
}

/// Why a calculation gave no results.
#[derive(Debug)]
pub enum Failure {
    /// The inputs do not read.
    Unreadable(FormatError),
    /// The calculation refused them.
    Refused(Refusal),
}

type Runner = Box<dyn Fn(&Document, &Yaml) -> Result<Results, Failure> + Sync + Send>;

/// A registered calculation.
pub struct Calculation {
    /// The name that cases use, `crate.what`.
    pub name: &'static str,
    /// One line on what it computes.
    pub about: &'static str,
    /// Schema of its inputs.
    pub schema: fn() -> Schema,
    run: Runner,
}

impl Calculation {
    fn new<Given: DeserializeOwned + JsonSchema + 'static>(
        name: &'static str,
        about: &'static str,
        run: fn(&Given) -> Result<Results, Refusal>,
    ) -> Self {
        Self {
            name,
            about,
            schema: || {
                let settings =
                    // References are inlined, because the schema becomes a part of that of a case.
                    SchemaSettings::draft2020_12().with(|settings| settings.inline_subschemas = true);
                settings.into_generator().into_root_schema_for::<Given>()
            },
            run: Box::new(move |document, given| {
                let given: Given = document
                    .read_value(given, &epicyclic_formats::Path::root().key("given"))
                    .map_err(Failure::Unreadable)?;
                run(&given).map_err(Failure::Refused)
            }),
        }
    }

    /// Runs the calculation on the `given` of a document; parts of it may have been replaced.
    ///
    /// # Errors
    /// [`Failure`], with the position in the document where its inputs do not read.
    pub fn run(&self, document: &Document, given: &Yaml) -> Result<Results, Failure> {
        (self.run)(document, given)
    }
}

/// Every calculation, by crate.
#[must_use]
pub fn all() -> Vec<Calculation> {
    let mut all = gears::calculations();
    all.extend(bodies::calculations());
    all.extend(involute::calculations());
    all.extend(strength::calculations());
    all.extend(schemes::calculations());
    all.extend(selection::calculations());
    all.extend(dynamics::calculations());
    all.extend(motion::calculations());
    all.extend(vibration::calculations());
    all.extend(synthesis::calculations());
    all.extend(hydromotor::calculations());
    all.extend(motor_teeth::calculations());
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unique_and_say_their_crate() {
        let all = all();
        for (i, calculation) in all.iter().enumerate() {
            assert!(calculation.name.contains('.'), "{}", calculation.name);
            assert!(all[..i].iter().all(|other| other.name != calculation.name), "{}", calculation.name);
        }
    }

    #[test]
    fn a_refusal_bears_the_name_of_the_innermost_error() {
        assert_eq!(Refusal::from(epicyclic_gears::Error::NoTeeth).name, "no-teeth");
        let wrapped = epicyclic_dynamics::Error::Gear(epicyclic_gears::Error::Efficiency { eta: 2.0 });
        assert_eq!(Refusal::from(wrapped).name, "efficiency");
    }
}

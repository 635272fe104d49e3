//! Fields that are written as a number or as text.

use std::{borrow::Cow, fmt};

use epicyclic_dynamics::drive::Bore;
use epicyclic_gears::bearing::Series;
use serde::{Deserialize, Deserializer, de};

use epicyclic_units::Quantity;

/// Designation of a bearing: `310` is a number to YAML, and a name to us.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Designation(pub String);

/// Series of bearings: 200, 300 or 400.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BearingSeries(pub Series);

/// `shaft`, `bearing` or a diameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoreText(pub Bore);

/// Reads a field from its text, whether YAML takes it for a number or not.
macro_rules! from_text {
    ($field:ty, $expecting:literal, $read:expr) => {
        impl<'de> Deserialize<'de> for $field {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                struct Visitor;

                impl de::Visitor<'_> for Visitor {
                    type Value = $field;

                    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                        f.write_str($expecting)
                    }

                    fn visit_str<E: de::Error>(self, text: &str) -> Result<$field, E> {
                        let read: fn(&str) -> Result<$field, String> = $read;
                        read(text.trim()).map_err(E::custom)
                    }

                    fn visit_u64<E: de::Error>(self, value: u64) -> Result<$field, E> {
                        self.visit_str(&value.to_string())
                    }

                    fn visit_i64<E: de::Error>(self, value: i64) -> Result<$field, E> {
                        self.visit_str(&value.to_string())
                    }

                    fn visit_f64<E: de::Error>(self, value: f64) -> Result<$field, E> {
                        self.visit_str(&value.to_string())
                    }
                }

                deserializer.deserialize_any(Visitor)
            }
        }
    };
}

from_text!(Designation, "a bearing such as 310", |text| Ok(Designation(text.to_owned())));

from_text!(BearingSeries, "a series of bearings: 200, 300 or 400", |text| match text {
    "200" => Ok(BearingSeries(Series::Light200)),
    "300" => Ok(BearingSeries(Series::Medium300)),
    "400" => Ok(BearingSeries(Series::Heavy400)),
    _ => Err(format!("no series {text}; write 200, 300 or 400")),
});

from_text!(BoreText, "a bore: shaft, bearing, or a diameter such as 50 mm", |text| match text {
    "shaft" => Ok(BoreText(Bore::Shaft)),
    "bearing" => Ok(BoreText(Bore::Bearing)),
    // A word, not a number.
    _ if text.starts_with(|c: char| c.is_alphabetic()) => {
        Err(format!("no bore {text}; write shaft, bearing, or a diameter such as 50 mm"))
    }
    _ => {
        let diameter: Result<Quantity<_>, _> = text.parse();
        diameter.map(|diameter| BoreText(Bore::Given(diameter.0))).map_err(|error| error.to_string())
    }
});

macro_rules! schema {
    ($field:ty, $($schema:tt)*) => {
        impl schemars::JsonSchema for $field {
            fn schema_name() -> Cow<'static, str> {
                stringify!($field).into()
            }

            fn inline_schema() -> bool {
                true
            }

            fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
                schemars::json_schema!($($schema)*)
            }
        }
    };
}

schema!(Designation, { "type": ["integer", "string"], "examples": [310] });
schema!(BearingSeries, { "enum": [200, 300, 400] });
schema!(BoreText, { "type": "string", "examples": ["shaft", "bearing", "50 mm"] });

//! A `uom` quantity in a document, on a command line, in a schema.
//!
//! An error raised inside a `serde` visitor survives only as its text. To keep the name and the parts of an
//! error, a [`Quantity`] asks its deserializer for a newtype struct with a private name. Our own reader knows
//! this name, parses the text itself and returns the typed error. Other formats pass the string through and
//! lose only the name of the error.

use std::{borrow::Cow, fmt, marker::PhantomData, str::FromStr};

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

use crate::{conversion::Physical, dimension::Dimension, error::QuantityError, format, parse_as};

/// A physical quantity, written as text with its unit: `106.5 kW`.
///
/// `T` is one of the quantities of `uom::si::f64`.
///
/// ```
/// use epicyclic_units::Quantity;
/// use uom::si::{f64::Power, power::watt};
///
/// let power: Quantity<Power> = "106.5 kW".parse()?;
/// assert_eq!(power.0.get::<watt>(), 106_500.0);
/// assert_eq!(power.to_string(), "106.5 kW");
/// # Ok::<(), epicyclic_units::QuantityError>(())
/// ```
///
/// `Display` writes 6 significant digits, or as many as the precision says: `{:.3}`. Serializing writes 15.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Quantity<T>(pub T);

impl<T: Physical> FromStr for Quantity<T> {
    type Err = QuantityError;

    fn from_str(text: &str) -> Result<Self, QuantityError> {
        parse_as(text, T::DIMENSION).map(|measured| Self(T::from_si(measured.si())))
    }
}

impl<T: Physical> fmt::Display for Quantity<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&format::quantity(self.0, f.precision().unwrap_or(6)))
    }
}

impl<T: Physical> Serialize for Quantity<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&format::quantity(self.0, 15))
    }
}

impl<'de, T: Physical> Deserialize<'de> for Quantity<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_newtype_struct(token(T::DIMENSION), Visitor(PhantomData))
    }
}

struct Visitor<T>(PhantomData<T>);

impl<'de, T: Physical> de::Visitor<'de> for Visitor<T> {
    type Value = Quantity<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", example(T::DIMENSION))
    }

    fn visit_newtype_struct<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_any(self)
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Self::Value, E> {
        text.parse().map_err(E::custom)
    }

    // A bare number: an error that proposes a unit, except for a ratio.

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Self::Value, E> {
        self.visit_str(&value.to_string())
    }

    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Self::Value, E> {
        self.visit_str(&value.to_string())
    }

    fn visit_u64<E: de::Error>(self, value: u64) -> Result<Self::Value, E> {
        self.visit_str(&value.to_string())
    }
}

const TOKEN: &str = "$epicyclic::quantity::";

/// Private name under which a quantity requests its text.
const fn token(dimension: Dimension) -> &'static str {
    macro_rules! tokens {
        ($($variant:ident)*) => {
            match dimension {
                $(Dimension::$variant => concat!("$epicyclic::quantity::", stringify!($variant)),)*
            }
        };
    }
    tokens!(
        Dimensionless Length Module Area Volume VolumeRate Mass Density Inertia Speed AngularSpeed AngularAcceleration Angle
        Frequency Force Stiffness Torque TorsionalStiffness Power Pressure Viscosity DynamicViscosity Energy Time
        TemperatureDifference ThermalExpansion HeatCapacity ThermalConductance PowerPerArea EnergyPerArea
    )
}

/// Dimension that a private name denotes.
#[must_use]
pub fn token_dimension(name: &str) -> Option<Dimension> {
    name.strip_prefix(TOKEN)?;
    Dimension::ALL.into_iter().find(|dimension| token(*dimension) == name)
}

fn example(dimension: Dimension) -> String {
    let usual = dimension.usual_unit().symbol;
    if dimension == Dimension::Dimensionless {
        "a plain number or a percentage, such as 0.977 or 97.7 %".to_owned()
    } else {
        format!("{} with its unit, such as 12.5 {usual}", crate::with_article(dimension.name()))
    }
}

impl<T: Physical> schemars::JsonSchema for Quantity<T> {
    fn schema_name() -> Cow<'static, str> {
        token(T::DIMENSION)[TOKEN.len()..].into()
    }

    fn schema_id() -> Cow<'static, str> {
        token(T::DIMENSION).into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        const NUMBER: &str = r"[-+−]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+−]?[0-9]+)?";
        let dimension = T::DIMENSION;
        let usual = dimension.usual_unit().symbol;
        let description = format!("{}; units: {}", example(dimension), dimension.unit_list());
        // The pattern leaves the unit open: it has more spellings than a pattern should list.
        if dimension == Dimension::Dimensionless {
            return schemars::json_schema!({
                "type": ["number", "string"],
                "description": description,
                "examples": [0.977, "97.7 %"],
                "pattern": format!(r"^\s*{NUMBER}\s*[1%‰]?\s*$"),
            });
        }
        schemars::json_schema!({
            "type": "string",
            "description": description,
            "examples": [format!("12.5 {usual}")],
            "pattern": format!(r"^\s*{NUMBER}\s*(1\s*/\s*)?[A-Za-zµμ°º˚][^,;]*$"),
        })
    }
}

#[cfg(test)]
mod tests {
    use schemars::schema_for;
    use uom::si::f64::{AngularVelocity, Length, Power, Ratio, Torque};

    use super::*;

    #[test]
    fn a_quantity_is_written_as_it_is_read() {
        for text in ["106.5 kW", "12.25 kW", "250 mW"] {
            assert_eq!(text.parse::<Quantity<Power>>().unwrap().to_string(), text);
        }
        assert_eq!("204 rad/s".parse::<Quantity<AngularVelocity>>().unwrap().to_string(), "1948.06 rpm");
        assert_eq!(format!("{:.3}", "521.8 Nm".parse::<Quantity<Torque>>().unwrap()), "522 N·m");
        assert_eq!("97.7 %".parse::<Quantity<Ratio>>().unwrap().to_string(), "0.977");
    }

    #[test]
    fn serializing_keeps_the_value() {
        let length: Quantity<Length> = "0.0081 m".parse().unwrap();
        assert_eq!(serde_yaml::to_string(&length).unwrap(), "8.1 mm\n");
    }

    #[test]
    fn other_formats_give_the_same_message() {
        let read = |value: &str| {
            use serde::de::{IntoDeserializer, value::Error};
            let text: de::value::StrDeserializer<'_, Error> = value.into_deserializer();
            Quantity::<Power>::deserialize(text).map_err(|error| error.to_string())
        };
        assert_eq!(read("75kW").unwrap().to_string(), "75 kW");
        assert_eq!(read("106,5 kW").unwrap_err(), "106,5 kW: decimal comma; write 106.5 kW");
    }

    #[test]
    fn tokens_name_their_dimension() {
        for dimension in Dimension::ALL {
            assert_eq!(token_dimension(token(dimension)), Some(dimension));
        }
        assert_eq!(token_dimension("Power"), None);
    }

    #[test]
    fn the_schema_names_dimension_and_units() {
        let schema = schema_for!(Quantity<Power>).to_value();
        let of = |key: &str| schema[key].to_string();
        assert_eq!(of("type"), "\"string\"");
        assert_eq!(
            of("description"),
            "\"a power with its unit, such as 12.5 kW; units: kW, mW, W, MW, PS, hp(I)\""
        );
        assert_eq!(of("examples"), "[\"12.5 kW\"]");
        assert!(of("pattern").contains("[0-9]+"));
    }
}

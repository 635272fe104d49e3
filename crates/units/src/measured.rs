//! A quantity of any dimension, read.

use super::dimension::Dimension;
use super::error::QuantityError;
use super::number;
use super::unit::{self, Unit, find_unit};

/// A quantity as it was written.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// The number exactly as printed: its digits say how far it may be trusted.
    pub number: String,
    /// The number, in [`Measured::unit`].
    pub value: f64,
    /// The unit; [`Dimension::Dimensionless`]'s `1` for a bare number.
    pub unit: &'static Unit,
}

impl Measured {
    /// Dimension of the quantity.
    #[must_use]
    pub const fn dimension(&self) -> Dimension {
        self.unit.dimension
    }

    /// Value in SI units.
    #[must_use]
    pub fn si(&self) -> f64 {
        self.unit.converted(self.value)
    }
}

/// Reads a quantity of any dimension: `106.5 kW`, `75kW`, `−5 mm`, `1950 1/min`. A bare number is
/// dimensionless.
///
/// ```
/// use epicyclic_units::{self as quantity, Dimension};
///
/// let torque = quantity::parse("1.20 kN·m")?;
/// assert_eq!(torque.dimension(), Dimension::Torque);
/// assert_eq!((torque.number.as_str(), torque.unit.symbol, torque.si()), ("1.20", "kN·m", 1200.0));
/// # Ok::<(), quantity::QuantityError>(())
/// ```
///
/// # Errors
/// One variant of [`QuantityError`] for each fault.
pub fn parse(text: &str) -> Result<Measured, QuantityError> {
    let read = |text: &str| parse_in(text, None);
    read(text).map_err(|error| error.settled(|text| read(text).err()))
}

/// Reads a quantity of the required dimension.
///
/// # Errors
/// Those of [`parse`], [`QuantityError::MissingUnit`] and [`QuantityError::WrongDimension`].
pub fn parse_as(text: &str, expected: Dimension) -> Result<Measured, QuantityError> {
    let read = |text: &str| parse_once_as(text, expected);
    read(text).map_err(|error| error.settled(|text| read(text).err()))
}

fn parse_once_as(text: &str, expected: Dimension) -> Result<Measured, QuantityError> {
    let measured = parse_in(text, Some(expected))?;
    let text = text.trim();
    if expected.is_read_in(measured.dimension()) {
        return Ok(measured);
    }
    // A bare number has the unit `1`. The usual unit of the dimension is the most likely one that was left
    // out.
    if measured.unit.symbol == "1" {
        let corrected = format!("{} {}", measured.number, expected.usual_unit().symbol);
        return Err(QuantityError::MissingUnit { text: text.to_owned(), expected, corrected });
    }
    let unit = text[measured.number.len()..].trim().to_owned();
    if expected == Dimension::Dimensionless {
        return Err(QuantityError::UnexpectedUnit { text: text.to_owned(), corrected: measured.number });
    }
    Err(QuantityError::WrongDimension { text: text.to_owned(), unit, found: measured.dimension(), expected })
}

fn parse_in(text: &str, expected: Option<Dimension>) -> Result<Measured, QuantityError> {
    let lexed = number::lex(text).map_err(|error| match error {
        QuantityError::Empty { .. } => QuantityError::Empty { expected },
        QuantityError::NotANumber { text, .. } => QuantityError::NotANumber { text, expected },
        error => error,
    })?;
    let text = || text.trim().to_owned();
    let unit = if lexed.unit.is_empty() { "1" } else { lexed.unit };
    // Refused before a unit is looked up: a wrong guess would change the value without a message.
    if let Some(choices) = unit::ambiguity(unit) {
        return Err(QuantityError::AmbiguousUnit {
            text: text(),
            unit: unit.to_owned(),
            choices: choices.to_owned(),
        });
    }
    let Some(unit) = find_unit(unit) else {
        let nearest = unit::nearest_unit(unit, expected);
        return Err(QuantityError::UnknownUnit {
            text: text(),
            unit: unit.to_owned(),
            expected,
            corrected: nearest.map(|nearest| format!("{} {}", lexed.number, nearest.symbol)),
        });
    };
    let measured = Measured { number: lexed.number.to_owned(), value: lexed.value, unit };
    let size = measured.si().abs();
    // A decimal exponent may be in range while the value in SI units is infinite.
    if !size.is_finite() {
        return Err(QuantityError::NotFinite { text: text() });
    }
    let dimension = measured.dimension();
    if size > dimension.largest() {
        return Err(QuantityError::TooLarge { text: text(), dimension });
    }
    Ok(measured)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::parse_number;

    #[test]
    fn units_in_cyrillic_letters_are_corrected() {
        for (text, corrected) in [
            ("0.8 м/с", "0.8 m/s"),
            ("0,8м/с", "0.8 m/s"),
            ("12 м/мин", "12 m/min"),
            ("5 км/год", "5 km/h"),
            ("1950 об/мин", "1950 rpm"),
            ("1950 об/хв", "1950 rpm"),
            ("1950 мин⁻¹", "1950 rpm"),
            ("521,8 Нм", "521.8 N·m"),
            ("2.97 кН·м", "2.97 kN·m"),
            ("0,171 кг·м²", "0.171 kg·m²"),
            ("7900 кг/м3", "7900 kg/m³"),
            ("20 мпа", "20 MPa"),
            ("75 квт", "75 kW"),
            ("100 л.с.", "100 PS"),
            ("8 мм", "8 mm"),
            ("20 град", "20 deg"),
            ("16 л/мин", "16 l/min"),
        ] {
            let error = parse(text).unwrap_err();
            assert_eq!(error.corrected(), Some(corrected), "{error}");
            assert!(parse(corrected).is_ok());
        }
        assert_eq!(parse("3 щи").unwrap_err().corrected(), None);
    }

    #[test]
    fn what_engineers_write_is_read() {
        for (text, number, unit, si) in [
            ("106.5 kW", "106.5", "kW", 106.5e3),
            ("8 DP", "8", "DP", 0.003_175),
            ("100 lbf·ft", "100", "lbf·ft", 135.581_794_833_140_04),
            ("12 lb-in", "12", "lbf·in", 12.0 * 0.112_984_829_027_616_7),
            ("10 hp", "10", "hp(I)", 7_456.998_715_822_702),
            ("3000 psi", "3000", "psi", 20_684_271.879_504_74),
            ("1475 RPM", "1475", "rpm", 154.461_638_801_498_17),
            ("1475 U/min", "1475", "rpm", 154.461_638_801_498_17),
            ("75kW", "75", "kW", 75e3),
            ("1.2e3 N·m", "1.2e3", "N·m", 1.2e3),
            ("520 N m", "520", "N·m", 520.0),
            ("521.80 Nm", "521.80", "N·m", 521.8),
            ("−5 mm", "−5", "mm", -5e-3),
            ("1950 1/min", "1950", "rpm", 1950.0 * std::f64::consts::PI / 30.0),
            ("100 PS", "100", "PS", 73_549.875),
            ("97.7 %", "97.7", "%", 0.977),
            ("3.94", "3.94", "1", 3.94),
            ("12\u{202f}mm²", "12", "mm²", 12e-6),
        ] {
            let measured = parse(text).unwrap();
            assert_eq!((measured.number.as_str(), measured.unit.symbol), (number, unit));
            assert!((measured.si() - si).abs() <= 1e-12 * si.abs(), "{text}: {} is not {si}", measured.si());
        }
    }

    #[test]
    fn each_fault_of_a_quantity_has_its_message() {
        use Dimension::{AngularSpeed, Dimensionless, Length, Power, Torque};
        for (text, expected, name, message) in [
            ("", Power, "empty-text", "empty text; write a number and a unit of power, such as 3.94 kW"),
            (
                "kW",
                Power,
                "not-a-number",
                "kW: this does not start with a number; write a number and a unit of power, such as 3.94 kW",
            ),
            ("106,5 kW", Power, "decimal-comma", "106,5 kW: decimal comma; write 106.5 kW"),
            ("106,5 кВт", Power, "decimal-comma", "106,5 кВт: decimal comma; write 106.5 kW"),
            ("106,5", Power, "decimal-comma", "106,5: decimal comma; write 106.5 kW"),
            (
                "1,950 об/мин",
                AngularSpeed,
                "decimal-comma",
                "1,950 об/мин: decimal comma; write 1.950 rpm, or 1950 rpm if the comma parts thousands",
            ),
            (
                "1,950 rpm",
                AngularSpeed,
                "decimal-comma",
                "1,950 rpm: decimal comma; write 1.950 rpm, or 1950 rpm if the comma parts thousands",
            ),
            (
                "1 950 rpm",
                AngularSpeed,
                "thousands-separator",
                "1 950 rpm: separated thousands; write 1950 rpm",
            ),
            (
                "12",
                Length,
                "missing-unit",
                "12: no unit; write 12 mm, or another unit of length (mm, µm, cm, dm, m, km, in, ft)",
            ),
            (
                "12 KW",
                Power,
                "unknown-unit",
                "12 KW: unknown unit KW; write 12 kW? (units of power: kW, mW, W, MW, PS, hp(I))",
            ),
            (
                "12 furlong",
                Power,
                "unknown-unit",
                "12 furlong: unknown unit furlong (units of power: kW, mW, W, MW, PS, hp(I))",
            ),
            (
                "12 1/s",
                AngularSpeed,
                "ambiguous-unit",
                "12 1/s: 1/s may be several units; write rad/s for an angular speed, rev/s for turns, Hz for a frequency",
            ),
            (
                "520 J",
                Torque,
                "wrong-dimension",
                "520 J: J is a unit of energy, and a torque is due; its units are N·m, mN·m, N·mm, N·cm, kN·m, MN·m, kgf·m, lbf·ft, lbf·in",
            ),
            ("nan kW", Power, "not-finite", "nan kW: not a finite number; write one such as 3.94"),
            ("1e308 MW", Power, "not-finite", "1e308 MW: not a finite number; write one such as 3.94"),
            ("1e200 N·m", Torque, "too-large", "1e200 N·m: too large; a torque is at most 1e12 N·m in size"),
            (
                "-1e8 rpm",
                AngularSpeed,
                "too-large",
                "-1e8 rpm: too large; an angular speed is at most 1e6 rad/s in size",
            ),
            (
                "1e308 %",
                Dimensionless,
                "too-large",
                "1e308 %: too large; a plain number is at most 1e12 in size",
            ),
            (
                "1.1 Gm\u{1b}\n",
                Length,
                "unknown-unit",
                "1.1 Gm\\u001b: unknown unit Gm\\u001b (units of length: mm, µm, cm, dm, m, km, in, ft)",
            ),
            (
                "5 mm",
                Dimensionless,
                "unexpected-unit",
                "5 mm: a plain number is due here, without a unit; write 5",
            ),
        ] {
            let error = parse_as(text, expected).unwrap_err();
            assert_eq!((error.name(), error.to_string().as_str()), (name, message));
        }
    }

    #[test]
    fn a_diametral_pitch_is_read_of_modules_alone() {
        for unit in Dimension::Length.units() {
            let text = format!("3 {}", unit.symbol);
            assert_eq!(parse_as(&text, Dimension::Module).unwrap().si(), parse(&text).unwrap().si());
        }
        assert!((parse_as("8 DP", Dimension::Module).unwrap().si() - 0.003_175).abs() < 1e-15);
        for dimension in Dimension::ALL.into_iter().filter(|one| *one != Dimension::Module) {
            assert!(parse_as("8 DP", dimension).is_err(), "{dimension}");
        }
        assert_eq!(
            parse_as("8 DP", Dimension::Length).unwrap_err().to_string(),
            "8 DP: DP is a unit of module, and a length is due; its units are mm, µm, cm, dm, m, km, in, ft"
        );
        let missing = parse_as("8", Dimension::Module).unwrap_err();
        assert_eq!(
            missing.to_string(),
            "8: no unit; write 8 mm, or another unit of module (mm, µm, cm, dm, m, km, in, ft, DP)"
        );
        assert_eq!(parse_as("8 dp", Dimension::Module).unwrap_err().corrected(), Some("8 DP"));
        assert_eq!(parse_as("0 DP", Dimension::Module).unwrap_err().name(), "not-finite");
    }

    proptest! {
        #[test]
        fn no_text_makes_it_panic(text in "\\PC*", like in "[-+−]?[0-9.,'_ e]{0,12}[ a-zA-Zµ·*^²/0-9%]{0,8}") {
            for text in [&text, &like] {
                let _ = parse(text);
                let _ = parse_number(text);
                for dimension in Dimension::ALL {
                    let _ = parse_as(text, dimension);
                }
            }
        }

        #[test]
        fn a_correction_is_right(whole in 0u32..1000, decimals in "[0-9]{1,2}") {
            let Err(QuantityError::DecimalComma { corrected, .. }) = parse_as(&format!("{whole},{decimals} kW"), Dimension::Power)
                else { panic!("not refused") };
            prop_assert_eq!(parse(&corrected).unwrap().number, format!("{whole}.{decimals}"));
        }
    }
}

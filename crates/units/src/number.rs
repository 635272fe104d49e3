//! A number as written: a point for the decimals, no separators, finite.

use crate::format::trimmed;
use std::{borrow::Cow, fmt, str::FromStr};

use serde::{Deserialize, Deserializer, Serialize, de};

use super::{dimension::Dimension, error::QuantityError};

/// A finite plain number.
///
/// Reads integers, floats, fractions and percents, and refuses NaN, infinity, and the text `3,94`, each with
/// its reason.
///
/// ```
/// use epicyclic_units::Number;
///
/// let ratio: Number = "3.94".parse()?;
/// assert_eq!(ratio.get(), 3.94);
/// assert_eq!("3,94".parse::<Number>().unwrap_err().to_string(), "3,94: decimal comma; write 3.94");
/// # Ok::<(), epicyclic_units::QuantityError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Serialize)]
#[serde(transparent)]
pub struct Number(f64);

impl Number {
    /// A number known to be finite, and not too large to reckon with.
    ///
    /// # Errors
    /// [`QuantityError::NotFinite`], [`QuantityError::TooLarge`].
    pub fn new(value: f64) -> Result<Self, QuantityError> {
        if value.is_finite() {
            within(value, || format!("{value:?}")).map(Self)
        } else {
            Err(QuantityError::NotFinite { text: value.to_string() })
        }
    }

    /// Value of the number.
    #[must_use]
    pub const fn get(self) -> f64 {
        self.0
    }
}

impl From<Number> for f64 {
    fn from(number: Number) -> Self {
        number.0
    }
}

impl FromStr for Number {
    type Err = QuantityError;

    fn from_str(text: &str) -> Result<Self, QuantityError> {
        parse_number(text).map(Self)
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Visitor;

        impl de::Visitor<'_> for Visitor {
            type Value = Number;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number")
            }

            fn visit_f64<E: de::Error>(self, value: f64) -> Result<Number, E> {
                Number::new(value).map_err(E::custom)
            }

            #[allow(clippy::cast_precision_loss)] // an integer above 2^53 is read like its decimal text
            fn visit_i64<E: de::Error>(self, value: i64) -> Result<Number, E> {
                Number::new(value as f64).map_err(E::custom)
            }

            #[allow(clippy::cast_precision_loss)] // as above
            fn visit_u64<E: de::Error>(self, value: u64) -> Result<Number, E> {
                Number::new(value as f64).map_err(E::custom)
            }

            // Only formats other than ours come here, our reader explains a text in a numeric field by
            // itself.
            fn visit_str<E: de::Error>(self, text: &str) -> Result<Number, E> {
                match parse_number(text) {
                    Ok(_) => Err(E::invalid_type(de::Unexpected::Str(text), &self)),
                    Err(error) => Err(E::custom(error)),
                }
            }
        }

        deserializer.deserialize_f64(Visitor)
    }
}

impl schemars::JsonSchema for Number {
    fn schema_name() -> Cow<'static, str> {
        "Number".into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let text = "^ *[-+−]?[0-9.]+ *([/:] *[0-9.]+ *[%‰]?|[%‰]) *$";
        schemars::json_schema!({ "anyOf": [{ "type": "number" }, { "type": "string", "pattern": text }] })
    }
}

/// The value of a text that is a plain number and nothing else, a fraction of two such as `17/3` and `6:1`,
/// or a share such as `5 %` and `5 ‰`.
///
/// ```
/// assert_eq!(epicyclic_units::parse_number("5 %"), Ok(0.05));
/// ```
///
/// # Errors
/// [`QuantityError::UnexpectedUnit`] for `520 N·m`, and those of a number.
pub fn parse_number(text: &str) -> Result<f64, QuantityError> {
    let lexed = lex(text)?;
    if lexed.unit.is_empty() && lexed.number.contains(':') && lexed.value.abs() < 1.0 && lexed.value != 0.0 {
        let [text, over] = [text.trim().to_owned(), lexed.number.replace(':', "/")];
        return Err(QuantityError::EitherWay { text, above_1: trimmed(1.0 / lexed.value, 9), below_1: over });
    }
    if lexed.unit.is_empty() || is_share(lexed.unit) {
        let one = super::unit::find_unit(lexed.unit).map_or(1.0, |unit| unit.factor);
        return within(lexed.value * one, || text.trim().to_owned());
    }
    let corrected = lexed.number.to_owned();
    // `3.94 kW` is a quantity; `3.94abc` is no number at all.
    match super::unit::find_unit(lexed.unit) {
        Some(_) => Err(QuantityError::UnexpectedUnit { text: text.to_owned(), corrected }),
        None => Err(QuantityError::NotANumber { text: text.to_owned(), expected: None }),
    }
}

/// Whether a unit is the sign of percent or per mille.
fn is_share(unit: &str) -> bool {
    matches!(unit, "%" | "‰")
}

/// The value, unless it is larger than any plain number may be.
fn within(value: f64, text: impl FnOnce() -> String) -> Result<f64, QuantityError> {
    let dimension = Dimension::Dimensionless;
    if value.abs() <= dimension.largest() {
        Ok(value)
    } else {
        Err(QuantityError::TooLarge { text: text(), dimension })
    }
}

/// A text parted into its number and what follows.
#[derive(Debug)]
pub(super) struct Lexed<'a> {
    /// The number as printed.
    pub(super) number: &'a str,
    pub(super) value: f64,
    /// Trimmed; may be empty.
    pub(super) unit: &'a str,
}

/// Parts a text into number, or a fraction of two numbers, and unit; knows no units.
pub(super) fn lex(text: &str) -> Result<Lexed<'_>, QuantityError> {
    let text = text.trim();
    let above = lex_number(text)?;
    // No unit begins with a mark and a digit: `1/min` has its own 1, and `/min` no digit.
    let Some(rest) = above.unit.strip_prefix(['/', ':']) else { return Ok(above) };
    match lex_number(rest) {
        Ok(below) if below.value != 0.0 && !below.unit.starts_with(['/', ':']) => Ok(Lexed {
            number: text[..text.len() - below.unit.len()].trim_end(),
            value: above.value / below.value,
            unit: below.unit,
        }),
        _ => Ok(above),
    }
}

fn lex_number(text: &str) -> Result<Lexed<'_>, QuantityError> {
    let text = text.trim();
    if text.is_empty() {
        return Err(QuantityError::Empty { expected: None });
    }
    let unsigned = text.strip_prefix(['+', '-', '−']).unwrap_or(text);
    if names_no_finite_number(unsigned) {
        return Err(QuantityError::NotFinite { text: text.to_owned() });
    }
    let body_start = text.len() - unsigned.len();
    let body = &unsigned[..body_length(unsigned)];
    if !body.contains(|c: char| c.is_ascii_digit()) {
        return Err(QuantityError::NotANumber { text: text.to_owned(), expected: None });
    }
    let after_body = &unsigned[body.len()..];
    let exponent = &after_body[..exponent_length(after_body)];
    let tail = &after_body[exponent.len()..];
    let with_body = |body: &str| format!("{}{body}{exponent}{tail}", &text[..body_start]);
    if let Some(refusal) = refuse_separators(text, body, with_body) {
        return Err(refusal);
    }

    let number = &text[..body_start + body.len() + exponent.len()];
    let value = number.replace('−', "-").parse::<f64>();
    match value {
        Ok(value) if value.is_finite() => Ok(Lexed { number, value, unit: tail.trim() }),
        Ok(_) => Err(QuantityError::NotFinite { text: text.to_owned() }),
        Err(_) => Err(QuantityError::NotANumber { text: text.to_owned(), expected: None }),
    }
}

fn names_no_finite_number(unsigned: &str) -> bool {
    let word: String =
        unsigned.trim_start_matches('.').chars().take_while(|c| c.is_alphabetic() || *c == '∞').collect();
    matches!(word.to_lowercase().as_str(), "nan" | "inf" | "infinity" | "∞")
}

/// Length in bytes of the leading digits, points and separators.
fn body_length(text: &str) -> usize {
    let mut end = 0;
    let mut after_digit = false;
    for (at, c) in text.char_indices() {
        let belongs = c.is_ascii_digit()
            || matches!(c, '.' | ',')
            || (after_digit && matches!(c, '\'' | '’' | '_') && digits_ahead(&text[at + c.len_utf8()..]) > 0)
            || (after_digit && c.is_whitespace() && starts_with_group(&text[at + c.len_utf8()..]));
        if !belongs {
            break;
        }
        after_digit = c.is_ascii_digit();
        end = at + c.len_utf8();
    }
    end
}

fn digits_ahead(text: &str) -> usize {
    text.bytes().take_while(u8::is_ascii_digit).count()
}

/// Three digits that do not begin a unit such as `100/min`.
fn starts_with_group(text: &str) -> bool {
    digits_ahead(text) == 3 && !text[3..].trim_start().starts_with('/')
}

fn exponent_length(text: &str) -> usize {
    let Some(after_e) = text.strip_prefix(['e', 'E']) else { return 0 };
    let digits = after_e.strip_prefix(['+', '-', '−']).unwrap_or(after_e);
    match digits_ahead(digits) {
        0 => 0,
        count => text.len() - digits.len() + count,
    }
}

/// The reason to refuse a body such as `106,5` or `1 950`, with the text corrected.
fn refuse_separators(text: &str, body: &str, with_body: impl Fn(&str) -> String) -> Option<QuantityError> {
    let is_separator = |c: char| !c.is_ascii_digit();
    let marks: Vec<char> = body.chars().filter(|c| is_separator(*c)).collect();
    if marks.is_empty() || marks == ['.'] {
        return None;
    }
    let digits_only = |part: &str| part.chars().filter(char::is_ascii_digit).collect::<String>();
    let in_thousands = |part: &str| {
        let groups: Vec<&str> = part.split(is_separator).collect();
        (1..=3).contains(&groups[0].len()) && groups[1..].iter().all(|group| group.len() == 3)
    };
    let text = text.to_owned();

    // One comma, after all other marks, with digits behind it: a decimal comma.
    if let Some((whole, decimals)) = body.split_once(',')
        && !decimals.is_empty()
        && !decimals.contains(is_separator)
        && (marks.len() == 1 || in_thousands(whole))
    {
        let corrected = with_body(&format!("{}.{decimals}", digits_only(whole)));
        let thousands = (marks.len() == 1 && in_thousands(body) && !whole.starts_with('0'))
            .then(|| with_body(&digits_only(body)));
        return Some(QuantityError::DecimalComma { text, corrected, thousands });
    }
    // A last point that is the only one parts the decimals from separated thousands.
    let (whole, decimals) = match body.rsplit_once('.') {
        Some((whole, decimals)) if !whole.contains('.') => (whole, Some(decimals)),
        _ => (body, None),
    };
    if in_thousands(whole) && decimals.is_none_or(|decimals| !decimals.contains(is_separator)) {
        let decimals = decimals.map(|decimals| format!(".{decimals}")).unwrap_or_default();
        let corrected = with_body(&format!("{}{decimals}", digits_only(whole)));
        return Some(QuantityError::ThousandsSeparator { text, corrected });
    }
    Some(QuantityError::NotANumber { text, expected: None })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_as_printed() {
        for (text, value) in [
            ("3.94", 3.94),
            ("  2 ", 2.0),
            ("-5", -5.0),
            ("−5.50", -5.5),
            ("+0.5", 0.5),
            (".5", 0.5),
            ("1.2e3", 1200.0),
            ("1E−3", 1e-3),
            ("007", 7.0),
        ] {
            let lexed = lex(text).unwrap();
            assert_eq!((lexed.number, lexed.value), (text.trim(), value));
        }
    }

    #[test]
    fn each_fault_of_a_number_has_its_message() {
        for (text, message) in [
            ("", "empty text; write a number, such as 3.94"),
            ("fast", "fast: this does not start with a number; write a number, such as 3.94"),
            ("1.2.3", "1.2.3: this does not start with a number; write a number, such as 3.94"),
            ("3.94abc", "3.94abc: this does not start with a number; write a number, such as 3.94"),
            ("3,94", "3,94: decimal comma; write 3.94"),
            ("-0,515", "-0,515: decimal comma; write -0.515"),
            ("1,2e3", "1,2e3: decimal comma; write 1.2e3"),
            ("1.950,5", "1.950,5: decimal comma; write 1950.5"),
            ("1,950", "1,950: decimal comma; write 1.950, or 1950 if the comma parts thousands"),
            ("1,950.5", "1,950.5: separated thousands; write 1950.5"),
            ("1,950,000", "1,950,000: separated thousands; write 1950000"),
            ("1 950", "1 950: separated thousands; write 1950"),
            ("1'950", "1'950: separated thousands; write 1950"),
            ("1_950", "1_950: separated thousands; write 1950"),
            ("1.950.000", "1.950.000: separated thousands; write 1950000"),
            ("NaN", "NaN: not a finite number; write one such as 3.94"),
            ("-.inf", "-.inf: not a finite number; write one such as 3.94"),
            ("∞", "∞: not a finite number; write one such as 3.94"),
            ("1e999", "1e999: not a finite number; write one such as 3.94"),
            ("520 N·m", "520 N·m: a plain number is due here, without a unit; write 520"),
        ] {
            assert_eq!(parse_number(text).unwrap_err().to_string(), message);
        }
    }

    #[test]
    fn shares_are_numbers_wherever_a_number_is_read() {
        for (text, value) in [
            ("5 %", 0.05),
            ("5%", 0.05),
            (" -0.5 % ", -0.005),
            ("5 ‰", 0.005),
            ("1/4 %", 0.0025),
            ("100 %", 1.0),
        ] {
            let read = parse_number(text).unwrap();
            assert!((read - value).abs() <= 1e-15, "{text}: {read}");
            assert_eq!(text.parse::<Number>().unwrap().get(), read);
            assert_eq!(crate::parse_as(text, Dimension::Dimensionless).unwrap().si(), read, "{text}");
        }
        for text in ["%", "5 % %", "5 1", "5 %/2", "5 1 %"] {
            assert!(parse_number(text).is_err(), "{text}");
        }
        assert_eq!(parse_number("0,5 %").unwrap_err().corrected(), Some("0.5 %"));
        assert_eq!(parse_number("1e15 %").unwrap_err().name(), "too-large");
    }

    #[test]
    fn fractions_are_numbers() {
        for (text, value) in
            [("17/3", 17.0 / 3.0), ("6:1", 6.0), (" -17 / 3 ", -17.0 / 3.0), ("1.5:0.5", 3.0)]
        {
            assert_eq!(parse_number(text), Ok(value), "{text}");
        }
        for (text, above_1, below_1) in [("1:50", "50", "1/50"), (" -1:4", "-4", "-1/4")] {
            let either = QuantityError::EitherWay {
                text: text.trim().to_owned(),
                above_1: above_1.to_owned(),
                below_1: below_1.to_owned(),
            };
            assert_eq!(parse_number(text), Err(either), "{text}");
            assert!(parse_number(above_1).is_ok() && parse_number(below_1).is_ok());
        }
        for text in ["17/", "/3", "1/0", "17/3/2", "6:1:2", "1/min", "3 mm/2"] {
            assert!(parse_number(text).is_err(), "{text}");
        }
        for (text, number, value) in
            [("3/4 in", "3/4", 0.75), ("100/3N·m", "100/3", 100.0 / 3.0), ("5/2 1/min", "5/2", 2.5)]
        {
            let lexed = lex(text).unwrap();
            assert_eq!((lexed.number, lexed.value), (number, value), "{text}");
        }
        // These are no fractions.
        for text in ["5 1/min", "5/min"] {
            assert_eq!(lex(text).unwrap().value, 5.0, "{text}");
        }
    }

    #[test]
    fn a_number_is_finite() {
        assert!(Number::new(f64::NAN).is_err());
        assert_eq!(Number::new(f64::INFINITY).unwrap_err().name(), "not-finite");
        assert_eq!(Number::new(1.1e12).unwrap_err().name(), "too-large");
        assert_eq!(
            parse_number("-1e308").unwrap_err().to_string(),
            "-1e308: too large; a plain number is at most 1e12 in size"
        );
        assert_eq!(parse_number("-1e12"), Ok(-1e12));
        assert_eq!(Number::new(-0.5).unwrap().to_string(), "-0.5");
    }
}

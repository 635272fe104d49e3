//! Options that take several values: `0.8 m/s, 3.15 m/s`.

use epicyclic_units::QuantityError;
use epicyclic_units::visible::one_line;
use epicyclic_units::{Number, Physical, Quantity};
use std::str::FromStr;

/// Values parted by commas or semicolons.
///
/// A comma between two digits parts nothing, so that `0,8 m/s` is refused with its correction and not read as
/// two numbers. So `1.465,2.56` wants a space after its comma.
#[derive(Debug, Clone, PartialEq)]
pub struct List<T>(pub Vec<T>);

/// Quantities of one kind.
pub type Quantities<T> = List<Quantity<T>>;

/// Plain numbers.
pub type Numbers = List<Number>;

impl<T> List<Quantity<T>>
where
    T: Physical,
{
    /// Without the text they were written as.
    pub(crate) fn values(&self) -> Vec<T> {
        self.0.iter().map(|quantity| quantity.0).collect()
    }
}

/// Why a value of a list is refused.
pub(crate) trait Refusal: ToString {
    /// The corrected text of the value, if a correction is known.
    fn corrected(&self) -> Option<&str> {
        None
    }
}

impl Refusal for QuantityError {
    fn corrected(&self) -> Option<&str> {
        self.corrected()
    }
}

impl Refusal for String {}

impl Refusal for epicyclic_selection::Error {}

impl Refusal for epicyclic_synthesis::rank::UnknownObjective {}

impl<T: FromStr<Err: Refusal>> FromStr for List<T> {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = parts(text);
        let values: Result<Vec<T>, T::Err> = parts.iter().map(|part| part.parse()).collect();
        values.map(Self).map_err(|error| {
            let error = one_line(&error.to_string()).into_owned();
            if parts.len() > 1 {
                let corrected: Option<Vec<String>> = parts.iter().map(|part| corrected::<T>(part)).collect();
                let all = corrected.map(|all| format!("; all of them: '{}'", one_line(&all.join(", "))));
                return format!("{error}{}", all.unwrap_or_default());
            }
            // Values apart by blanks alone: a value with a unit has two words.
            let words: Vec<&str> = text.split_whitespace().collect();
            let apart: Option<Vec<String>> = words.iter().map(|word| corrected::<T>(word)).collect();
            if let Some(apart) = apart.filter(|apart| apart.len() > 1) {
                return format!("{text}: several values are parted by commas; write '{}'", apart.join(", "));
            }
            let close = text.matches(',').count() > 0;
            format!("{error}{}", if close { "; several are parted by a comma and a space" } else { "" })
        })
    }
}

/// A value as it is to be written; nothing where that is not known.
fn corrected<T: FromStr<Err: Refusal>>(part: &str) -> Option<String> {
    part.parse::<T>().map_or_else(|error| error.corrected().map(str::to_owned), |_| Some(part.to_owned()))
}

fn parts(text: &str) -> Vec<&str> {
    let bytes = text.as_bytes();
    let is_digit =
        |place: Option<usize>| place.and_then(|place| bytes.get(place)).is_some_and(u8::is_ascii_digit);
    let mut parts = vec![];
    let mut from = 0;
    for (place, mark) in text.char_indices().filter(|(_, c)| matches!(c, ',' | ';')) {
        if mark == ',' && is_digit(place.checked_sub(1)) && is_digit(Some(place + 1)) {
            continue;
        }
        parts.push(text[from..place].trim());
        from = place + 1;
    }
    parts.push(text[from..].trim());
    parts
}

#[cfg(test)]
mod tests {
    use super::*;
    use uom::si::f64::{Length, Velocity};

    #[test]
    fn commas_part_values_but_not_digits() {
        let speeds: Quantities<Velocity> = "0.76 m/s, 1.33 m/s;117 m/min".parse().unwrap();
        let speeds: Vec<f64> = speeds.values().into_iter().map(Physical::si).collect();
        assert_eq!(speeds, [0.76, 1.33, 117.0 / 60.0]);
        let ratios: Numbers = "-2.56, -1.465".parse().unwrap();
        assert_eq!(ratios.0.iter().map(|ratio| ratio.get()).collect::<Vec<_>>(), [-2.56, -1.465]);
    }

    #[test]
    fn a_decimal_comma_is_still_corrected() {
        let refused = "0,8 m/s, 3,15 m/s".parse::<Quantities<Velocity>>().unwrap_err();
        assert_eq!(refused, "0,8 m/s: decimal comma; write 0.8 m/s; all of them: '0.8 m/s, 3.15 m/s'");
        let refused = "0,8 м/с; 3.15 m/s; 4".parse::<Quantities<Velocity>>().unwrap_err();
        assert_eq!(refused, "0,8 м/с: decimal comma; write 0.8 m/s; all of them: '0.8 m/s, 3.15 m/s, 4 m/s'");
        assert!("0.8 m/s, 3.15 m/s, 4 m/s".parse::<Quantities<Velocity>>().is_ok());
        let refused = "0,8 m/s, fast".parse::<Quantities<Velocity>>().unwrap_err();
        assert_eq!(refused, "0,8 m/s: decimal comma; write 0.8 m/s");
        let refused = "1 1.25 2mm".parse::<Quantities<Length>>().unwrap_err();
        assert_eq!(refused, "1 1.25 2mm: several values are parted by commas; write '1 mm, 1.25 mm, 2mm'");
        let refused = "2.5 3.1".parse::<Numbers>().unwrap_err();
        assert_eq!(refused, "2.5 3.1: several values are parted by commas; write '2.5, 3.1'");
        let refused = "1.465,2.56".parse::<Numbers>().unwrap_err();
        assert!(refused.ends_with("several are parted by a comma and a space"), "{refused}");
    }
}

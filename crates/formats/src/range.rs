//! Ranges as people write them: `12..40`, `17..`, `..=200`, or one number for a range of one.
//!
//! Both ends belong to the range, however many dots part them: `12..40`, `12..=40` and `12…40` are the same.

use std::{borrow::Cow, fmt, marker::PhantomData, ops::RangeInclusive, str::FromStr};

use serde::{Deserialize, Deserializer, de};

use epicyclic_units::{parse_number, visible::one_line};

/// A range whose ends may be left open.
///
/// ```
/// use epicyclic_formats::Span;
///
/// let teeth: Span<u32> = "17..".parse()?;
/// assert_eq!(teeth.closed(12..=200)?, 17..=200);
/// assert_eq!("17..40".parse::<Span<u32>>()?.within(1..=20).unwrap_err().to_string(), "17..40: allowed is 1 to 20");
/// assert_eq!("20".parse::<Span<u32>>()?.single(), Some(20));
/// assert_eq!("40..12".parse::<Span<u32>>().unwrap_err().to_string(), "40..12: write the smaller number first: 12..40");
/// # Ok::<(), epicyclic_formats::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Span<T> {
    from: Option<T>,
    to: Option<T>,
}

impl<T> From<RangeInclusive<T>> for Span<T> {
    fn from(range: RangeInclusive<T>) -> Self {
        let (from, to) = range.into_inner();
        Self { from: Some(from), to: Some(to) }
    }
}

/// Value at the ends of a [`Span`].
pub trait End: Copy + PartialOrd + fmt::Display + sealed::Sealed {
    /// Name of the value in messages: `a whole number`.
    const NAME: &'static str;
    /// Shown where one is due.
    const EXAMPLE: &'static str;

    /// Value of a text.
    ///
    /// # Errors
    /// A reason, with what to write instead where that can be told.
    fn read(text: &str) -> Result<Self, String>;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for u32 {}
    impl Sealed for f64 {}
}

impl End for u32 {
    const NAME: &'static str = "a whole number";
    const EXAMPLE: &'static str = "12..40, 17.., ..=200 or 20";

    fn read(text: &str) -> Result<Self, String> {
        text.parse().map_err(|_| format!("{text:?} is not a whole number from 0 to {}", Self::MAX))
    }
}

impl End for f64 {
    const NAME: &'static str = "a number";
    const EXAMPLE: &'static str = "1.5..4, 2.., ..=10 or 3.5";

    fn read(text: &str) -> Result<Self, String> {
        parse_number(text).map_err(|error| error.to_string())
    }
}

/// A text that is no range.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RangeError {
    /// Nothing at all, or dots alone.
    #[error("{text:?} is no range; write one such as {example}")]
    Empty {
        /// The text.
        text: String,
        /// Text to write instead.
        example: &'static str,
    },
    /// An end that is not a number.
    #[error("{text}: {reason}; write a range such as {example}", text = one_line(text))]
    End {
        /// The text.
        text: String,
        /// Fault of the end.
        reason: String,
        /// Text to write instead.
        example: &'static str,
    },
    /// Numbers with a unit.
    #[error("{text}: the numbers of this range have no unit; write {corrected}", text = one_line(text))]
    Unit {
        /// The text.
        text: String,
        /// The range without the unit.
        corrected: String,
    },
    /// Another mark between the ends.
    #[error("{text}: two dots are between the ends of a range; write {corrected}", text = one_line(text))]
    Mark {
        /// The text.
        text: String,
        /// The range with two dots.
        corrected: String,
    },
    /// A share at the second end alone.
    #[error("{text}: the first end has no unit; write {corrected}", text = one_line(text))]
    Share {
        /// The text.
        text: String,
        /// The unit at both ends.
        corrected: String,
    },
    /// The greater number first.
    #[error("{text}: write the smaller number first: {corrected}", text = one_line(text))]
    Reversed {
        /// The text.
        text: String,
        /// The ends exchanged.
        corrected: String,
    },
    /// An open end that the default does not close.
    #[error("{written}: the range is open and would usually end at {usual}; write both ends")]
    Open {
        /// The range.
        written: String,
        /// Where the default ends.
        usual: String,
    },
    /// An end beyond what is allowed.
    #[error("{written}: allowed is {least} to {most}")]
    Outside {
        /// The range.
        written: String,
        /// The least allowed.
        least: String,
        /// The most allowed.
        most: String,
    },
}

impl RangeError {
    /// The error with another example to write.
    pub(crate) fn with_example(mut self, other: &'static str) -> Self {
        if let Self::Empty { example, .. } | Self::End { example, .. } = &mut self {
            *example = other;
        }
        self
    }
}

impl<T: End> Span<T> {
    /// The range of one number.
    #[must_use]
    pub const fn one(value: T) -> Self {
        Self { from: Some(value), to: Some(value) }
    }

    /// Ends of the range, `None` where it is open.
    #[must_use]
    pub const fn ends(&self) -> [Option<T>; 2] {
        [self.from, self.to]
    }

    /// The number, if the range holds but one.
    #[must_use]
    pub fn single(&self) -> Option<T> {
        self.from.filter(|_| self.from == self.to)
    }

    /// The range within what is allowed, with open ends taken from there.
    ///
    /// # Errors
    /// [`RangeError::Outside`] where an end is not within `allowed`.
    pub fn within(&self, allowed: RangeInclusive<T>) -> Result<RangeInclusive<T>, RangeError> {
        let (from, to) = (self.from.unwrap_or(*allowed.start()), self.to.unwrap_or(*allowed.end()));
        if allowed.contains(&from) && allowed.contains(&to) {
            return Ok(from..=to);
        }
        let [least, most] = [allowed.start(), allowed.end()].map(ToString::to_string);
        Err(RangeError::Outside { written: self.to_string(), least, most })
    }

    /// The range, with open ends taken from `usual`, which given ends may exceed.
    ///
    /// # Errors
    /// [`RangeError::Open`] where that would turn it around.
    pub fn closed(&self, usual: RangeInclusive<T>) -> Result<RangeInclusive<T>, RangeError> {
        let (from, to) = (self.from.unwrap_or(*usual.start()), self.to.unwrap_or(*usual.end()));
        if from <= to {
            return Ok(from..=to);
        }
        let usual = if self.to.is_none() { usual.end() } else { usual.start() };
        Err(RangeError::Open { written: self.to_string(), usual: usual.to_string() })
    }
}

impl<T: End> FromStr for Span<T> {
    type Err = RangeError;

    fn from_str(text: &str) -> Result<Self, RangeError> {
        let text = text.trim();
        let ends = text.split_once("..=").or_else(|| text.split_once("..")).or_else(|| text.split_once('…'));
        let read = |end: &str| match end.trim() {
            "" => Ok(None),
            end => T::read(end).map(Some).map_err(|reason| RangeError::End {
                text: text.to_owned(),
                reason,
                example: T::EXAMPLE,
            }),
        };
        // Of `5..10 %` the first end could mean 5 or 5 %.
        if let Some((from, to)) = ends
            && let Some(sign) = to.trim().chars().last().filter(|sign| matches!(sign, '%' | '‰'))
            && !from.trim().is_empty()
            && !from.trim().ends_with(['%', '‰'])
            && T::read(to.trim()).is_ok()
        {
            let (from, to) = (from.trim(), to.trim());
            return Err(RangeError::Share {
                text: text.to_owned(),
                corrected: format!("{from} {sign}..{to}"),
            });
        }
        // Of `..100 g` only the numbers belong to the range.
        let number = |end: &str| {
            let end = end.trim();
            let number = end.trim_end_matches(|sign: char| !sign.is_ascii_digit());
            (number.is_empty() == end.is_empty() && (number.is_empty() || T::read(number).is_ok()))
                .then(|| number.to_owned())
        };
        let has_unit = |end: &str| !end.trim().is_empty() && T::read(end.trim()).is_err();
        let corrected = match ends {
            Some((from, to)) if has_unit(from) || has_unit(to) => {
                number(from).zip(number(to)).map(|(from, to)| format!("{from}..{to}"))
            }
            None if has_unit(text) => number(text),
            _ => None,
        };
        if let Some(corrected) = corrected.filter(|corrected| !corrected.is_empty()) {
            return Err(RangeError::Unit { text: text.to_owned(), corrected });
        }
        if ends.is_none() && T::read(text).is_err() {
            let marks = ["-", "–", "—", " to ", " bis "].into_iter();
            let mut apart =
                marks.filter_map(|mark| text.split_once(mark)).map(|(from, to)| [from.trim(), to.trim()]);
            if let Some([from, to]) = apart.find(|ends| ends.iter().all(|end| T::read(end).is_ok())) {
                let corrected = format!("{from}..{to}");
                return Err(RangeError::Mark { text: text.to_owned(), corrected });
            }
        }
        let span = match ends {
            Some((from, to)) => Self { from: read(from)?, to: read(to)? },
            None => {
                let value = read(text)?;
                Self { from: value, to: value }
            }
        };
        match (span.from, span.to) {
            (None, None) => Err(RangeError::Empty { text: text.to_owned(), example: T::EXAMPLE }),
            (Some(from), Some(to)) if from > to => {
                Err(RangeError::Reversed { text: text.to_owned(), corrected: format!("{to}..{from}") })
            }
            _ => Ok(span),
        }
    }
}

impl<T: End> fmt::Display for Span<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(value) = self.single() {
            return value.fmt(f);
        }
        let end = |end: Option<T>| end.map(|end| end.to_string()).unwrap_or_default();
        write!(f, "{}..{}", end(self.from), end(self.to))
    }
}

impl<'de, T: End> Deserialize<'de> for Span<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Visitor(PhantomData))
    }
}

struct Visitor<T>(PhantomData<T>);

impl<T: End> de::Visitor<'_> for Visitor<T> {
    type Value = Span<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} or a range such as {}", T::NAME, T::EXAMPLE)
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Span<T>, E> {
        text.parse().map_err(E::custom)
    }

    fn visit_u64<E: de::Error>(self, value: u64) -> Result<Span<T>, E> {
        self.visit_str(&value.to_string())
    }

    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Span<T>, E> {
        self.visit_str(&value.to_string())
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Span<T>, E> {
        self.visit_str(&value.to_string())
    }
}

impl<T: End> schemars::JsonSchema for Span<T> {
    fn schema_name() -> Cow<'static, str> {
        "Range".into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "type": ["number", "string"],
            "description": format!("{} or a range, both ends included: {}", T::NAME, T::EXAMPLE),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn teeth(text: &str) -> Result<String, String> {
        let span = text.parse::<Span<u32>>().map_err(|error| error.to_string())?;
        span.closed(12..=200).map(|range| format!("{range:?}")).map_err(|error| error.to_string())
    }

    #[test]
    fn both_ends_belong_to_it() {
        for (text, range) in [
            ("12..40", "12..=40"),
            ("12..=40", "12..=40"),
            ("12…40", "12..=40"),
            (" 14 .. 40 ", "14..=40"),
            ("4", "4..=4"),
            ("..=199", "12..=199"),
            ("..199", "12..=199"),
            ("17..", "17..=200"),
        ] {
            assert_eq!(teeth(text).as_deref(), Ok(range), "{text}");
        }
        assert_eq!("1.3..10".parse::<Span<f64>>().unwrap().closed(1.1..=9.0), Ok(1.3..=10.0));
    }

    #[test]
    fn another_mark_between_the_ends_is_named() {
        for text in ["2-3", "2 – 3", "2 to 3"] {
            let said = format!("{text}: two dots are between the ends of a range; write 2..3");
            assert_eq!(text.parse::<Span<u32>>().unwrap_err().to_string(), said);
        }
        assert_eq!("1e-3".parse::<Span<f64>>().unwrap().single(), Some(0.001));
    }

    #[test]
    fn ends_may_be_shares() {
        let read = |text: &str| text.parse::<Span<f64>>().map(|span| (span.from, span.to));
        assert_eq!(read("5 %"), Ok((Some(0.05), Some(0.05))));
        assert_eq!(read("5 %..10%"), Ok((Some(0.05), Some(0.1))));
        assert_eq!(
            read("0.05..10 ‰").unwrap_err().to_string(),
            "0.05..10 ‰: the first end has no unit; write 0.05 ‰..10 ‰"
        );
        assert_eq!(read("..10 %"), Ok((None, Some(0.1))));
        assert!(teeth("5..10 %").unwrap_err().contains("have no unit; write 5..10"));
    }

    #[test]
    fn no_end_is_beyond_what_is_allowed() {
        let within = |text: &str| {
            let span = text.parse::<Span<u32>>().unwrap();
            span.within(1..=6).map(|range| format!("{range:?}")).map_err(|error| error.to_string())
        };
        for (text, range) in [("1..6", "1..=6"), ("..4", "1..=4"), ("5..", "5..=6"), ("6", "6..=6")] {
            assert_eq!(within(text).as_deref(), Ok(range), "{text}");
        }
        for text in ["0..3", "0", "7", "5..7", "7..", "..0"] {
            assert_eq!(within(text), Err(format!("{text}: allowed is 1 to 6")), "{text}");
        }
        assert!("1.05..30".parse::<Span<f64>>().unwrap().within(1.05..=20.0).is_err());
    }

    #[test]
    fn what_is_no_range_says_what_to_write() {
        let example = "write a range such as 12..40, 17.., ..=200 or 20";
        for (text, message) in [
            ("", "\"\" is no range; write one such as 12..40, 17.., ..=200 or 20".to_owned()),
            ("..", "\"..\" is no range; write one such as 12..40, 17.., ..=200 or 20".to_owned()),
            ("-3..4", format!("-3..4: \"-3\" is not a whole number from 0 to 4294967295; {example}")),
            ("40..12", "40..12: write the smaller number first: 12..40".to_owned()),
            ("300..", "300..: the range is open and would usually end at 200; write both ends".to_owned()),
            ("..5", "..5: the range is open and would usually end at 12; write both ends".to_owned()),
        ] {
            assert_eq!(teeth(text), Err(message), "{text}");
        }
        assert_eq!(
            "1,3..10".parse::<Span<f64>>().unwrap_err().to_string(),
            "1,3..10: 1,3: decimal comma; write 1.3; write a range such as 1.5..4, 2.., ..=10 or 3.5"
        );
    }
}

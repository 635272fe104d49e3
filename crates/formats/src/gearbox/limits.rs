//! Limits of rules of practice that a gearbox file states.

use super::{DescriptionError, GearboxFile};
use crate::faults::Faults;
use crate::{Path, Problem, RangeError, Span};
use epicyclic_judge::{Limits, Range, Rule};
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, de};
use std::collections::BTreeMap;
use std::fmt;

/// A range of the key `limits`, or why its text is none: a name that cannot be stated is refused before its
/// range.
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(transparent)]
pub struct StatedLimit(#[schemars(with = "Span<f64>")] Result<Span<f64>, RangeError>);

/// Examples of ranges for messages; a single number is no range.
const EXAMPLE: &str = "1.5..4, 2.. or ..10";

impl GearboxFile {
    /// The limits to judge the gearbox by: the usual ones, and those that the file states in their place.
    #[must_use]
    pub fn limits(&self) -> Limits {
        let mut limits = Limits::default();
        for (name, span) in &self.limits {
            if let (Ok(rule), Ok(span)) = (statable(name), &span.0) {
                limits.state(rule, range(*span));
            }
        }
        limits
    }

    /// Finds limits that cannot be stated.
    pub(super) fn check_limits(&self, faults: &mut Faults) {
        check_limits(&self.limits, faults);
    }
}

/// Finds limits of the key `limits` that cannot be stated: names that are no rule with a limit to state, and
/// ranges that no value can meet or that allow one value alone.
pub fn check_limits(limits: &BTreeMap<String, StatedLimit>, faults: &mut Faults) {
    for (name, span) in limits {
        let read = || span.0.clone().map_err(|error| Problem::refused("invalid-value", error.to_string()));
        let of = statable(name).and_then(|rule| possible(rule, read()?));
        faults.keep(Path::root().key("limits").key(name), of);
    }
}

/// Refuses a range that values of a rule cannot meet, and a single number.
fn possible(rule: Rule, span: Span<f64>) -> Result<(), Problem> {
    let (range, stated) = (range(span), span.to_string());
    if let Some(value) = span.single() {
        return Err(DescriptionError::LimitOfOneValue { rule: rule.name(), value }.into());
    }
    let values = rule.values();
    let is_within = |end: f64| !end.is_finite() || (values.least <= end && end <= values.most);
    if is_within(range.least) && is_within(range.most) && rule.leaves_values(range) {
        return Ok(());
    }
    let within = match [values.least, values.most].map(f64::is_finite) {
        [true, true] => format!("from {} to {}", values.least, values.most),
        [_, false] => {
            format!("{} {}", if rule.is_above_least() { "above" } else { "at least" }, values.least)
        }
        [false, true] => format!("at most {}", values.most),
    };
    let unit = if rule.unit().is_empty() { String::new() } else { format!(" {}", rule.unit()) };
    Err(DescriptionError::ImpossibleLimit { stated, what: rule.what(), within: within + &unit }.into())
}

fn range(span: Span<f64>) -> Range {
    let [least, most] = span.ends();
    Range { least: least.unwrap_or(f64::NEG_INFINITY), most: most.unwrap_or(f64::INFINITY) }
}

impl<'de> Deserialize<'de> for StatedLimit {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Visitor)
    }
}

struct Visitor;

impl de::Visitor<'_> for Visitor {
    type Value = StatedLimit;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a range such as {EXAMPLE}")
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<StatedLimit, E> {
        Ok(StatedLimit(text.parse().map_err(|error: RangeError| error.with_example(EXAMPLE))))
    }

    fn visit_u64<E: de::Error>(self, value: u64) -> Result<StatedLimit, E> {
        self.visit_str(&value.to_string())
    }

    fn visit_i64<E: de::Error>(self, value: i64) -> Result<StatedLimit, E> {
        self.visit_str(&value.to_string())
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<StatedLimit, E> {
        self.visit_str(&value.to_string())
    }
}

/// The rule of a name.
fn statable(name: &str) -> Result<Rule, Problem> {
    match name.parse::<Rule>() {
        Ok(rule) if rule.is_statable() => Ok(rule),
        Ok(rule) if let Some((_, limit)) = rule.own_limit() => {
            Err(DescriptionError::OwnLimit { rule: rule.name(), limit }.into())
        }
        _ => {
            let rules = Rule::ALL.iter().filter(|rule| rule.is_statable());
            let allowed = rules.map(|rule| rule.name().to_owned()).collect();
            Err(Problem::UnknownKey { key: name.to_owned(), allowed })
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::Document;
    use crate::gearbox::GearboxFile;
    use epicyclic_judge::Rule;

    fn read(limits: &str) -> Result<GearboxFile, String> {
        let text = format!(
            "gearbox: P\ninput: x\noutput: y\nsets: [{{ id: P, kind: external_pair, sun: x, ring: y, teeth: [20, 60] }}]\ngears: [{{ name: only }}]\nlimits: {limits}\n"
        );
        let document = Document::parse_one("box.yaml", text.as_bytes()).unwrap();
        let file: GearboxFile = document.read().map_err(|error| error.to_string())?;
        match file.gearbox() {
            Ok(_) => Ok(file),
            Err(faults) => Err(faults.placed(&document, &crate::Path::root()).to_string()),
        }
    }

    #[test]
    fn stated_ranges_take_the_place_of_usual_ones() {
        let limits =
            read("{ face-width: 0.4..1.4, specific-sliding: ..3.5, shift-sum: -0.1.. }").unwrap().limits();
        assert!(limits.judge(Rule::FaceWidth, 1.39).holds() && !limits.judge(Rule::FaceWidth, 1.41).holds());
        assert!(limits.judge(Rule::SpecificSliding, 3.49).holds());
        assert!(limits.judge(Rule::ShiftSum, 5.0).holds() && !limits.judge(Rule::ShiftSum, -0.11).holds());
        assert!(!limits.judge(Rule::SpurContact, 1.1).holds());
    }

    #[test]
    fn limits_that_cannot_be_stated_are_refused_with_what_is_allowed() {
        for (limits, parts) in [
            ("{ face-wdth: 0.4..1.4 }", ["limits.face-wdth", "unknown key face-wdth; write face-width?"]),
            ("{ ripple: ..0.1 }", ["limits.ripple", "allowed: face-width, specific-sliding, "]),
            ("{ face-width: 1.4..0.4 }", ["limits.face-width", "write the smaller number first: 0.4..1.4"]),
            (
                "{ face-width: .. }",
                ["limits.face-width", "is no range; write one such as 1.5..4, 2.. or ..10"],
            ),
            ("{ face-width: wide }", ["limits.face-width", "wide"]),
            ("{ face-width: 0.4..1.2 mm }", ["limits.face-width", "have no unit; write 0.4..1.2"]),
            ("{ orbit-acceleration: ..100 g }", ["limits.orbit-acceleration", "have no unit; write ..100"]),
            ("{ oil-temperature: ..80 °C }", ["limits.oil-temperature", "have no unit; write ..80"]),
            ("{ face-width: 0.4 }", ["limits.face-width", "write `..0.4` for at most 0.4, or `0.4..`"]),
            (
                "{ face-width: -1..1.4 }",
                ["limits.face-width", "-1..1.4: face width over the diameter of the smaller gear is above 0"],
            ),
            ("{ face-width: ..0 }", ["limits.face-width", "is above 0"]),
            ("{ hunting-tooth: ..0.5 }", ["limits.hunting-tooth", "is at least 1"]),
            ("{ stage-efficiency: 0.9..1.2 }", ["limits.stage-efficiency", "is from 0 to 1"]),
            ("{ dynamic-factor: ..0.9 }", ["limits.dynamic-factor", "is at least 1"]),
            (
                "{ bearing-life: 3000.. }",
                [
                    "limits.bearing-life",
                    "`bearing-life` cannot be stated: it follows from the gearbox, at least the required `life`",
                ],
            ),
            ("{ bearing-life: 3000 h.. }", ["limits.bearing-life", "`bearing-life` cannot be stated"]),
            (
                "{ load-sharing: 1.. }",
                ["limits.load-sharing", "at least the usual factor of the number of planets"],
            ),
        ] {
            let error = read(limits).unwrap_err();
            assert!(parts.iter().all(|part| error.contains(part)), "{limits}: {error}");
        }
    }
}

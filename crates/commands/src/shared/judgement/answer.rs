//! Judgement of a gearbox: checks with their values and limits, and what could not be judged.

use crate::analyze::answer::pins::OF_PINS;
use crate::answer::Warning;
use epicyclic_judge::{Rule, Severity};
use epicyclic_units::format::trimmed;
use schemars::JsonSchema;
use serde::Serialize;

/// Source of the limits of tooth checks.
pub(crate) const GEOMETRY: &str = "geometry";

/// Name of warnings about teeth that cannot be cut or collide.
pub(crate) const TEETH: &str = "teeth";

/// Rules that are named one by one at most; more are counted.
const MOST_NAMED: usize = 2;

/// Judgement of a gearbox by rules of practice.
#[derive(Debug, Clone, PartialEq, Default, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Judgement {
    /// Number of checks that hold.
    pub held: usize,
    /// Check that holds with the ratio of value and limit nearest to 1, of figures whose ratio is a margin: no
    /// shifts, divisors, efficiencies, temperatures and stated factors; null if there is none.
    pub nearest: Option<Nearest>,
    /// Checks, those that do not hold first, the worst first of all.
    pub checks: Vec<Judged>,
    /// Checks that could not be made.
    pub not_judged: Vec<NotJudged>,
}

/// Value judged by a rule.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Judged {
    /// Name of the rule, which does not depend on the message.
    pub name: &'static str,
    /// What is judged: set, gears, gear of the gearbox.
    pub of: Vec<String>,
    /// Value; null if it is infinite.
    pub value: Option<f64>,
    /// Limit that the value passes, or that it is nearest to.
    pub limit: f64,
    /// Unit of value and limit; empty for a plain number.
    pub unit: &'static str,
    /// Severity of a miss.
    pub severity: Severity,
    /// Whether the check holds.
    pub holds: bool,
    /// Who states the limit.
    pub source: &'static str,
    /// Message about the miss, for people; null if the check holds.
    pub message: Option<String>,
    /// Remedy for the miss; null if the check holds.
    pub remedy: Option<&'static str>,
}

/// Check that holds, with the least margin up to its limit.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Nearest {
    /// Name of the rule.
    pub name: &'static str,
    /// What is judged: set, gears, gear of the gearbox.
    pub of: Vec<String>,
    /// Value.
    pub value: f64,
    /// Limit that it is nearest to.
    pub limit: f64,
    /// Unit of value and limit; empty for a plain number.
    pub unit: &'static str,
}

/// Checks that could not be made.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct NotJudged {
    /// What is not judged: a set, or the gearbox.
    pub of: String,
    /// Names of the rules.
    pub rules: Vec<&'static str>,
    /// Keys that are missing for them, or a reason in words.
    pub missing: Vec<String>,
}

impl Judged {
    /// Whether one of these rules is judged.
    pub(crate) fn is_of(&self, rules: &[Rule]) -> bool {
        rules.iter().any(|rule| rule.name() == self.name)
    }
}

impl Judgement {
    /// Misses by severity: errors, warnings, remarks.
    #[must_use]
    pub fn misses(&self) -> [usize; 3] {
        [Severity::Error, Severity::Warning, Severity::Remark].map(|severity| {
            self.checks.iter().filter(|check| !check.holds && check.severity == severity).count()
        })
    }

    /// Misses as warnings, without remarks, tooth checks, and rules of which the caller warns in words of its
    /// own.
    pub(crate) fn warnings(&self, besides: &[Rule]) -> impl Iterator<Item = Warning> {
        self.warnings_but(|check| check.source == GEOMETRY || check.is_of(besides))
    }

    /// Warnings of checks that do not hold, but for remarks and the checks of `is_own`.
    pub(crate) fn warnings_but(&self, is_own: impl Fn(&Judged) -> bool) -> impl Iterator<Item = Warning> {
        let is_due = |check: &&Judged| check.severity != Severity::Remark && !check.holds;
        self.checks.iter().filter(is_due).filter(move |check| !is_own(check)).filter_map(|check| {
            let message = format!("{}: {}: {}", check.of.join(", "), check.message.as_ref()?, check.remedy?);
            let name = if check.source == GEOMETRY { TEETH } else { check.name };
            Some(Warning { name, message })
        })
    }

    /// Adds the misses to warnings of a gearbox, but for teeth and speeds of planets that it warns of in its
    /// own words.
    pub(crate) fn add_to(&self, warnings: &mut Vec<Warning>) {
        let told = |name| warnings.iter().any(|warning| warning.name == name);
        let (teeth, pins) = (told(TEETH), told("planet-speed"));
        warnings.extend(
            self.warnings_but(|check| teeth && check.source == GEOMETRY || pins && check.is_of(&OF_PINS)),
        );
    }

    /// Warnings of a list of designs: the worst miss of each rule, with the number of others.
    pub(crate) fn warnings_of_rules(&self) -> Vec<Warning> {
        let mut all: Vec<(Warning, usize)> = vec![];
        for warning in self.warnings(&[]) {
            match all.iter_mut().find(|(known, _)| known.name == warning.name) {
                Some((_, others)) => *others += 1,
                None => all.push((warning, 0)),
            }
        }
        let with_others = |(warning, others): (Warning, usize)| match others {
            0 => warning,
            _ => {
                Warning { message: format!("{} ({others} more miss this rule)", warning.message), ..warning }
            }
        };
        all.into_iter().map(with_others).collect()
    }

    /// The judgement in a sentence or two: what holds, the nearest to its limit, what is not judged.
    #[must_use]
    pub fn summary(&self) -> String {
        let all = self.checks.len();
        let [errors, warnings, remarks] = self.misses();
        let counted = |count: usize, one: &str| match count {
            0 => None,
            1 => Some(format!("1 {one}")),
            _ => Some(format!("{count} {one}s")),
        };
        let missed: Vec<String> = [(errors, "error"), (warnings, "warning"), (remarks, "remark")]
            .into_iter()
            .filter_map(|(n, of)| counted(n, of))
            .collect();
        let missed = if missed.is_empty() { String::new() } else { format!(" ({})", missed.join(", ")) };
        let checks = if all == 1 { "check holds" } else { "checks hold" };
        let mut words = if missed.is_empty() {
            format!("{all} {checks}.")
        } else {
            format!("{} of {all} {checks}{missed}.", self.held)
        };
        if let Some(nearest) = &self.nearest {
            let with_unit = |value: f64| match nearest.unit {
                "" => trimmed(value, 3),
                unit => format!("{} {unit}", trimmed(value, 3)),
            };
            words += &format!(
                " Nearest to its limit: {} of {}, {} ({}).",
                nearest.name,
                nearest.of.join(", "),
                with_unit(nearest.value),
                with_unit(nearest.limit),
            );
        }
        let groups = self.groups();
        if !groups.is_empty() {
            words += &format!(" Not judged: {}.", groups.join("; "));
        }
        words
    }

    /// What is not judged, by what is missing: `8 rules of P and Q (profile_shifts missing)`.
    fn groups(&self) -> Vec<String> {
        let mut groups: Vec<(&[String], Vec<&str>, Vec<&str>)> = vec![];
        for NotJudged { of, rules, missing } in &self.not_judged {
            let place = groups.iter().position(|(known, ..)| *known == missing.as_slice());
            let place = place.unwrap_or_else(|| {
                groups.push((missing, vec![], vec![]));
                groups.len() - 1
            });
            let (_, known_rules, subjects) = &mut groups[place];
            known_rules.extend(rules.iter().filter(|rule| !known_rules.contains(rule)).collect::<Vec<_>>());
            if !subjects.contains(&of.as_str()) {
                subjects.push(of);
            }
        }
        let words = |(missing, rules, subjects): (&[String], Vec<&str>, Vec<&str>)| {
            let rules = if rules.len() <= MOST_NAMED {
                rules.join(" and ")
            } else {
                format!("{} rules", rules.len())
            };
            // A reason in words says what is missing by itself.
            let lack = if missing.iter().any(|one| one.contains(' ')) { "" } else { " missing" };
            format!("{rules} of {} ({}{lack})", subjects.join(" and "), missing.join(", "))
        };
        groups.into_iter().map(words).collect()
    }
}

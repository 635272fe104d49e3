//! The checks of the teeth of a gearbox: what was checked, what could not be for want of which key, what does
//! not hold.

use crate::answer::Warning;
use epicyclic_gears::involute::check::Severity as CheckSeverity;
use epicyclic_gears::involute::left_out::LeftOut;
use epicyclic_train::tooth_checks::{SetCheck, SetChecks, Subject as CheckSubject};
use schemars::JsonSchema;
use serde::Serialize;

/// The checks of the teeth of all sets.
#[derive(Debug, Clone, PartialEq, Default, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ToothChecks {
    /// Number of checks that hold.
    pub held: usize,
    /// Every check.
    pub checks: Vec<ToothCheck>,
    /// Sets of which some checks could not be made.
    pub not_checked: Vec<NotChecked>,
}

/// A check of the teeth of a set: `value` against `limit`.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ToothCheck {
    /// Its name: the same whatever the message says.
    pub name: &'static str,
    /// The set.
    pub set: String,
    /// The gears that it is about: of a mesh both, of tips theirs first; empty of the set as a whole and of
    /// planets beside each other.
    pub gears: Vec<String>,
    /// The value; `null` where it is without end.
    pub value: Option<f64>,
    /// The limit.
    pub limit: f64,
    /// Unit of both: `modules`, `rad`, `teeth`, `positions`; empty of a plain number.
    pub unit: &'static str,
    /// How grave a miss is.
    pub severity: Severity,
    /// Whether it holds.
    pub holds: bool,
    /// What is missed, for people; `null` where it holds.
    pub message: Option<String>,
    /// What helps; `null` where it holds.
    pub remedy: Option<&'static str>,
}

/// How grave it is that a check does not hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Severity {
    /// Worth knowing.
    Remark,
    /// An engineer would send it back, or give a reason for it.
    Warning,
    /// Gears that cannot be cut, put together or turned.
    Error,
}

/// A set of which some checks could not be made.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct NotChecked {
    /// The set.
    pub set: String,
    /// The keys without which they cannot be made.
    pub missing: Vec<&'static str>,
}

/// Sets of teeth that a search leaves out since a check of their teeth does not hold.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TeethLeftOut {
    /// How many.
    pub count: u64,
    /// Name of the check that the first of them does not pass.
    pub check: &'static str,
    /// How many they are, and what the first of them misses, for people.
    pub message: String,
}

impl TeethLeftOut {
    /// The record of sets that a search leaves out.
    #[must_use]
    pub fn of(left_out: &LeftOut) -> Self {
        Self { count: left_out.count, check: left_out.rule.name(), message: left_out.to_string() }
    }
}

impl From<CheckSeverity> for Severity {
    fn from(severity: CheckSeverity) -> Self {
        match severity {
            CheckSeverity::Remark => Self::Remark,
            CheckSeverity::Warning => Self::Warning,
            CheckSeverity::Error => Self::Error,
        }
    }
}

impl ToothCheck {
    fn of(check: SetCheck) -> Self {
        let gears = match check.subject {
            CheckSubject::Set | CheckSubject::Planets(_) => vec![],
            CheckSubject::Gear(gear) => vec![gear],
            CheckSubject::Mesh(one, other) | CheckSubject::Tips(one, other) => vec![one, other],
        };
        Self {
            name: check.rule,
            set: check.set,
            gears,
            value: Some(check.value).filter(|value| value.is_finite()),
            limit: check.limit,
            unit: check.unit,
            severity: check.severity.into(),
            holds: check.miss.is_none(),
            remedy: check.miss.is_some().then_some(check.remedy),
            message: check.miss,
        }
    }
}

impl ToothChecks {
    /// The checks of the sets for which `is_wanted` is true.
    #[must_use]
    pub fn of(SetChecks { checks, not_checked }: SetChecks, is_wanted: impl Fn(&str) -> bool) -> Self {
        let checks: Vec<ToothCheck> =
            checks.into_iter().filter(|check| is_wanted(&check.set)).map(ToothCheck::of).collect();
        let not_checked = not_checked.into_iter().filter(|of| is_wanted(&of.set));
        Self {
            held: checks.iter().filter(|check| check.holds).count(),
            checks,
            not_checked: not_checked.map(|of| NotChecked { set: of.set, missing: of.missing }).collect(),
        }
    }

    /// What is missed but for remarks.
    pub fn warnings(&self) -> impl Iterator<Item = Warning> {
        let missed = self.checks.iter().filter(|check| check.severity != Severity::Remark);
        missed.filter_map(|check| {
            let message = format!("set `{}`: {}", check.set, check.message.as_ref()?);
            Some(Warning { name: "teeth", message })
        })
    }
}

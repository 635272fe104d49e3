//! Tooth checks of a gearbox: the results, and the keys missing for checks that could not be made.

use crate::answer::Warning;
use crate::shared::judgement::answer::TEETH;
use epicyclic_gears::involute::check::Severity;
use epicyclic_gears::involute::left_out::LeftOut;
use epicyclic_train::tooth_checks::{SetCheck, SetChecks, Subject as CheckSubject};
use schemars::JsonSchema;
use serde::Serialize;

/// Tooth checks of all sets.
#[derive(Debug, Clone, PartialEq, Default, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ToothChecks {
    /// Number of checks that are passed.
    pub held: usize,
    /// Results of the checks.
    pub checks: Vec<ToothCheck>,
    /// Sets for which some checks could not be made.
    pub not_checked: Vec<NotChecked>,
}

/// Tooth check of a set: `value` against `limit`.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ToothCheck {
    /// Name of the check, which does not depend on the message.
    pub name: &'static str,
    /// Name of the set.
    pub set: String,
    /// Gears concerned: for a mesh both, for tips the gear with the tips first. Empty for a check of the
    /// whole set or of neighbouring planets.
    pub gears: Vec<String>,
    /// Value of the check; null if it is infinite.
    pub value: Option<f64>,
    /// Limit of the value.
    pub limit: f64,
    /// Unit of value and limit: `modules`, `rad`, `teeth`, `positions`; empty for a plain number.
    pub unit: &'static str,
    /// Severity of a failure.
    pub severity: Severity,
    /// Whether the check is passed.
    pub holds: bool,
    /// Message about the failure, for people; null if the check is passed.
    pub message: Option<String>,
    /// Remedy for the failure; null if the check is passed.
    pub remedy: Option<&'static str>,
}

/// Set for which some checks could not be made.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct NotChecked {
    /// Name of the set.
    pub set: String,
    /// Keys that are missing for these checks.
    pub missing: Vec<&'static str>,
}

/// Tooth numbers that a search leaves out because a tooth check fails.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TeethLeftOut {
    /// Number of combinations left out.
    pub count: u64,
    /// Name of the check that the first of them fails.
    pub check: &'static str,
    /// Message for people with the number left out, and the failure of the first.
    pub message: String,
}

impl TeethLeftOut {
    /// Converts the sets that a search leaves out into a record.
    #[must_use]
    pub fn of(left_out: &LeftOut) -> Self {
        Self { count: left_out.count, check: left_out.rule.name(), message: left_out.to_string() }
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
            severity: check.severity,
            holds: check.miss.is_none(),
            remedy: check.miss.is_some().then_some(check.remedy),
            message: check.miss,
        }
    }
}

impl ToothChecks {
    /// Collects the checks of the sets for which `is_wanted` is true.
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

    /// Failed checks as warnings, without mere remarks.
    pub fn warnings(&self) -> impl Iterator<Item = Warning> {
        let missed = self.checks.iter().filter(|check| check.severity != Severity::Remark);
        missed.filter_map(|check| {
            let message = format!("set `{}`: {}", check.set, check.message.as_ref()?);
            Some(Warning { name: TEETH, message })
        })
    }
}

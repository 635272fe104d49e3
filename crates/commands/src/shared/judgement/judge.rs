//! Collects verdicts.

use super::answer::{GEOMETRY, Judged, Judgement, Nearest, NotJudged};
use crate::shared::tooth_checks::answer::ToothChecks;
use crate::tolerance::APART;
use epicyclic_judge::{Limits, Rule, Verdict};

/// Collects verdicts.
#[derive(Debug, Default)]
pub(super) struct Judge {
    pub(super) limits: Limits,
    checks: Vec<(Judged, f64)>,
    not_judged: Vec<NotJudged>,
}

impl Judge {
    /// Judges a value by the usual bounds of a rule.
    pub(super) fn see(&mut self, rule: Rule, of: &[&str], value: f64) {
        self.take(of, self.limits.judge(rule, value));
    }

    /// Takes a verdict.
    pub(super) fn take(&mut self, of: &[&str], verdict: Verdict) {
        let rule = verdict.rule;
        let judged = Judged {
            name: rule.name(),
            of: of.iter().map(|part| (*part).to_owned()).collect(),
            value: Some(verdict.value).filter(|value| value.is_finite()),
            limit: verdict.limit,
            unit: rule.unit(),
            severity: verdict.severity.unwrap_or(verdict.worst),
            holds: verdict.holds(),
            source: rule.source(),
            message: verdict.miss(),
            remedy: (!verdict.holds()).then(|| verdict.remedy()),
        };
        // A rule without bounds has nothing to come near to.
        self.checks.push((judged, verdict.room));
    }

    /// Notes rules that cannot be judged for lack of data.
    pub(super) fn lacks(&mut self, of: &str, rules: &[Rule], missing: Vec<String>) {
        let rules = rules.iter().map(|rule| rule.name()).collect();
        self.not_judged.push(NotJudged { of: of.to_owned(), rules, missing });
    }

    /// Notes rules that cannot be judged for a reason, if there is one.
    pub(super) fn lacks_if(&mut self, of: &str, rules: &[Rule], why: Option<String>) {
        if let Some(why) = why {
            self.lacks(of, rules, vec![why]);
        }
    }

    pub(super) fn take_tooth_checks(&mut self, all: &ToothChecks) {
        for check in &all.checks {
            let of = std::iter::once(check.set.clone()).chain(check.gears.iter().cloned()).collect();
            let judged = Judged {
                name: check.name,
                of,
                value: check.value,
                limit: check.limit,
                unit: check.unit,
                severity: check.severity,
                holds: check.holds,
                source: GEOMETRY,
                message: check.message.clone(),
                remedy: check.remedy,
            };
            self.checks.push((judged, f64::INFINITY));
        }
        for of in &all.not_checked {
            let missing = of.missing.iter().map(|key| (*key).to_owned()).collect();
            self.not_judged.push(NotJudged { of: of.set.clone(), rules: vec!["teeth"], missing });
        }
    }

    /// The judgement, with the worst misses first.
    pub(super) fn judgement(mut self) -> Judgement {
        // Errors first; among equals the order of the checks, which is that of the sets.
        self.checks.sort_by_key(|(check, _)| (check.holds, std::cmp::Reverse(check.severity)));
        let nearest =
            self.checks.iter().filter(|(check, room)| check.holds && (APART..f64::INFINITY).contains(room));
        let nearest = nearest.min_by(|(_, one), (_, other)| one.total_cmp(other)).map(|(check, _)| Nearest {
            name: check.name,
            of: check.of.clone(),
            value: check.value.unwrap_or(check.limit),
            limit: check.limit,
            unit: check.unit,
        });
        let checks: Vec<Judged> = self.checks.into_iter().map(|(check, _)| check).collect();
        let held = checks.iter().filter(|check| check.holds).count();
        Judgement { held, nearest, checks, not_judged: self.not_judged }
    }
}

//! Collects verdicts.

use super::answer::{GEOMETRY, Judged, Judgement, Nearest, NotJudged};
use crate::shared::tooth_checks::answer::ToothChecks;
use crate::tolerance::APART;
use epicyclic_judge::{Limits, Rule, Verdict};

/// Collects verdicts.
#[derive(Debug, Default)]
pub(crate) struct Judge {
    pub(crate) limits: Limits,
    /// Checks, each with its [margin](Verdict::margin).
    checks: Vec<(Judged, Option<f64>)>,
    not_judged: Vec<NotJudged>,
}

impl Judge {
    /// Judges by these limits.
    pub(crate) fn by(limits: Limits) -> Self {
        Self { limits, ..Self::default() }
    }

    /// Judges a value by the bounds of a rule.
    pub(crate) fn see(&mut self, rule: Rule, of: &[&str], value: f64) {
        self.take(of, self.limits.judge(rule, value));
    }

    /// Judges a value by the least one that the gearbox allows.
    pub(crate) fn see_least(&mut self, rule: Rule, of: &[&str], least: f64, value: f64) {
        self.take(of, self.limits.judge_least(rule, least, value));
    }

    /// Judges a value by the greatest one that the motor allows.
    pub(crate) fn see_most(&mut self, rule: Rule, of: &[&str], most: f64, value: f64) {
        self.take(of, self.limits.judge_most(rule, most, value));
    }

    /// Takes a check of the geometry, which has no margin.
    pub(crate) fn take_geometry(&mut self, check: Judged) {
        self.checks.push((check, None));
    }

    /// Takes a verdict.
    pub(crate) fn take(&mut self, of: &[&str], verdict: Verdict) {
        let rule = verdict.rule;
        let judged = Judged {
            name: rule.name(),
            of: of.iter().map(|part| (*part).to_owned()).collect(),
            value: Some(verdict.value).filter(|value| value.is_finite()),
            limit: verdict.limit,
            unit: rule.unit(),
            severity: verdict.severity.unwrap_or(verdict.worst),
            holds: verdict.holds(),
            source: verdict.source,
            message: verdict.miss(),
            remedy: (!verdict.holds()).then(|| verdict.remedy()),
        };
        self.checks.push((judged, verdict.margin()));
    }

    /// Whether a rule is judged for a set.
    pub(crate) fn has(&self, rule: Rule, set: &str) -> bool {
        let is_own = |check: &Judged| check.name == rule.name() && check.of.iter().any(|of| of == set);
        self.checks.iter().any(|(check, _)| is_own(check))
    }

    /// Whether a part of a set has a check, or is named for a rule without one.
    pub(crate) fn has_any(&self, name: &str, of: &[&str]) -> bool {
        self.not_judged.iter().any(|one| one.of == name)
            || self.checks.iter().any(|(check, _)| check.of == of)
    }

    /// Notes rules that cannot be judged for lack of data.
    pub(crate) fn lacks(&mut self, of: &str, rules: &[Rule], missing: Vec<String>) {
        let alike = |one: &&mut NotJudged| one.of == of && one.missing == missing;
        let mut names: Vec<&str> = rules.iter().map(|rule| rule.name()).collect();
        match self.not_judged.iter_mut().find(alike) {
            Some(one) => {
                names.retain(|name| !one.rules.contains(name));
                one.rules.append(&mut names);
            }
            None => self.not_judged.push(NotJudged { of: of.to_owned(), rules: names, missing }),
        }
    }

    pub(crate) fn take_tooth_checks(&mut self, all: &ToothChecks) {
        for check in &all.checks {
            let of = std::iter::once(check.set.clone()).chain(check.gears.iter().cloned()).collect();
            self.take_geometry(Judged {
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
            });
        }
        for of in &all.not_checked {
            let missing = of.missing.iter().map(|key| (*key).to_owned()).collect();
            self.not_judged.push(NotJudged { of: of.set.clone(), rules: vec!["teeth"], missing });
        }
    }

    /// Notes rules with a stated limit that no value was judged by.
    fn note_unused_limits(&mut self) {
        let is_judged = |rule: &Rule| {
            self.checks.iter().any(|(check, _)| check.name == rule.name())
                || self.not_judged.iter().any(|one| one.rules.contains(&rule.name()))
        };
        let unused: Vec<Rule> = self.limits.stated_rules().filter(|rule| !is_judged(rule)).collect();
        for rule in unused {
            let why = match rule {
                Rule::OilTemperature => "losses --conductance judges it",
                Rule::Resonance => "vibrate judges it",
                _ => "has no value here",
            };
            self.lacks("the stated limits", &[rule], vec![why.to_owned()]);
        }
    }

    /// The judgement, with the worst misses first.
    pub(crate) fn judgement(mut self) -> Judgement {
        self.note_unused_limits();
        // Errors first; among equals the order of the checks, which is that of the sets.
        self.checks.sort_by_key(|(check, _)| (check.holds, std::cmp::Reverse(check.severity)));
        let margins = self.checks.iter().filter_map(|(check, margin)| Some((check, (*margin)?)));
        let margins = margins.filter(|(_, margin)| *margin >= 1.0 + APART);
        let nearest = margins.min_by(|(_, one), (_, other)| one.total_cmp(other)).map(|(check, _)| Nearest {
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

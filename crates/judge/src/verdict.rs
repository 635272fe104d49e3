//! Values judged by rules.

use crate::rule::STATED;
use crate::{Bounds, Range, Rule, Severity};
use epicyclic_units::format::trimmed;

/// A value judged by a rule.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Verdict {
    /// The rule.
    pub rule: Rule,
    /// The value, in the unit of the rule.
    pub value: f64,
    /// Limit that it passes, or that it is nearest to.
    pub limit: f64,
    /// Severity of a miss; `None` if the value holds.
    pub severity: Option<Severity>,
    /// Worst severity that the rule has.
    pub worst: Severity,
    /// Who states the limit.
    pub source: &'static str,
    /// Whether the value is outside a range that is stated in place of the usual one.
    pub is_against_stated: bool,
}

impl Verdict {
    fn of(rule: Rule, bounds: Bounds, value: f64) -> Self {
        let worst = Severity::ALL.into_iter().rev().find(|one| bounds.0[*one as usize] != Range::OPEN);
        let required = bounds.required();
        let (severity, limit) = match bounds.missed(value) {
            Some((severity, limit)) => (Some(severity), limit),
            None => (None, required.nearest_end(value)),
        };
        let worst = worst.unwrap_or(Severity::Remark);
        Self { rule, value, limit, severity, worst, source: rule.source(), is_against_stated: false }
    }

    /// Whether the value holds.
    #[must_use]
    pub const fn holds(&self) -> bool {
        self.severity.is_none()
    }

    /// How far a value that holds is from its limit: the larger of value and limit over the smaller, 1 at the
    /// limit; `None` of rules whose ratio says nothing, and of values and limits that are not above 0.
    #[must_use]
    pub fn margin(&self) -> Option<f64> {
        let ratio = self.value / self.limit;
        let is_known = self.holds() && self.rule.has_margin() && self.value > 0.0 && self.limit > 0.0;
        Some(ratio.max(1.0 / ratio)).filter(|ratio| is_known && ratio.is_finite())
    }

    /// The verdict of a value that is stated on purpose: errors become this severity, and limits that are
    /// stated, too, do not require another one.
    #[must_use]
    pub fn no_worse_than(self, severity: Severity) -> Self {
        Self {
            severity: self.severity.map(|own| own.min(severity)),
            worst: self.worst.min(severity),
            is_against_stated: false,
            ..self
        }
    }

    /// The value with its limit, in words: `specific sliding 3.4, at most 3 by usual practice`.
    #[must_use]
    pub fn words(&self) -> String {
        let Self { rule, value, limit, source, .. } = self;
        let unit = |number: f64| {
            let unit = rule.unit();
            format!("{}{}{unit}", trimmed(number, 4), if unit.is_empty() { "" } else { " " })
        };
        // A value inside lies on the good side of its nearest limit, one outside on the other.
        let is_above = value > limit;
        let side = if is_above == self.holds() { "at least" } else { "at most" };
        format!("{} {}, {side} {} by {source}", rule.what(), unit(*value), unit(*limit))
    }

    /// Remedy for the miss.
    #[must_use]
    pub const fn remedy(&self) -> &'static str {
        self.rule.remedy(self.value > self.limit)
    }

    /// The miss in words; `None` if the value holds.
    #[must_use]
    pub fn miss(&self) -> Option<String> {
        (!self.holds()).then(|| self.words())
    }
}

/// Limits to judge by: the usual ones, and those that are stated in their place.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Limits {
    stated: Vec<(Rule, Range)>,
}

impl Limits {
    /// States a range in place of the usual one of a rule.
    pub fn state(&mut self, rule: Rule, range: Range) {
        self.stated.retain(|(other, _)| *other != rule);
        self.stated.push((rule, range));
    }

    /// Rules with a stated range.
    pub fn stated_rules(&self) -> impl Iterator<Item = Rule> {
        self.stated.iter().map(|(rule, _)| *rule)
    }

    /// The bounds of a rule.
    #[must_use]
    pub fn bounds(&self, rule: Rule) -> Bounds {
        let usual = rule.bounds();
        self.stated(rule).map_or(usual, |range| usual.stated(range))
    }

    /// The range that is stated in place of the usual one of a rule.
    #[must_use]
    pub fn stated(&self, rule: Rule) -> Option<Range> {
        self.stated.iter().find(|(of, _)| *of == rule).map(|(_, range)| *range)
    }

    /// Judges a value by the bounds of a rule.
    #[must_use]
    pub fn judge(&self, rule: Rule, value: f64) -> Verdict {
        self.judge_by(rule, rule.bounds(), value)
    }

    /// Judges a value by the least one that the gearbox allows, for rules with an
    /// [own limit](Rule::own_limit); others have their usual bounds alone.
    #[must_use]
    pub fn judge_least(&self, rule: Rule, least: f64, value: f64) -> Verdict {
        self.judge_own(rule, Range::at_least(least), value)
    }

    /// Judges a value by the greatest one that the gearbox or motor allows, for rules with an
    /// [own limit](Rule::own_limit); others have their usual bounds alone.
    #[must_use]
    pub fn judge_most(&self, rule: Rule, most: f64, value: f64) -> Verdict {
        self.judge_own(rule, Range::at_most(most), value)
    }

    fn judge_own(&self, rule: Rule, own: Range, value: f64) -> Verdict {
        let usual = rule.bounds();
        let bounds = rule.own_limit().map_or(usual, |(severity, _)| usual.and(severity, own));
        self.judge_by(rule, bounds, value)
    }

    /// Judges a value by bounds that follow from other values of the gearbox.
    #[must_use]
    pub fn judge_by(&self, rule: Rule, bounds: Bounds, value: f64) -> Verdict {
        let Some(range) = self.stated(rule) else { return Verdict::of(rule, bounds, value) };
        let verdict = Verdict::of(rule, bounds.stated(range), value);
        // A value far outside may pass the usual limit of errors.
        let is_stated = [range.least, range.most].contains(&verdict.limit);
        let source = if is_stated { STATED } else { verdict.source };
        Verdict { source, is_against_stated: !range.contains(value), ..verdict }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_limit_of_the_gearbox_is_shown_with_the_value_itself() {
        let judged = |rule, least, value| Limits::default().judge_least(rule, least, value);
        let flank = judged(Rule::FlankSafety, 1.2, 1.16);
        assert_eq!((flank.value, flank.limit, flank.severity), (1.16, 1.2, Some(Severity::Error)));
        assert_eq!(flank.miss().unwrap(), "safety of the flank 1.16, at least 1.2 by what is required");
        assert_eq!(
            judged(Rule::BearingLife, 2e4, 18_500.0).miss().unwrap(),
            "bearing life 18500 h, at least 20000 h by what is required"
        );
        assert!(judged(Rule::FaceLoad, 1.144, 1.144).holds());
        assert_eq!(judged(Rule::FaceLoad, 1.144, 1.1).severity, Some(Severity::Warning));
    }

    #[test]
    fn margins_are_ratios_of_figures_that_have_one() {
        let margin = |rule, value| Limits::default().judge(rule, value).margin();
        assert_eq!(margin(Rule::SpecificSliding, 1.5), Some(2.0));
        assert_eq!(margin(Rule::SpurContact, 1.8), Some(1.5));
        assert_eq!(margin(Rule::SpurContact, 1.0), None);
        assert_eq!(margin(Rule::SunShift, 0.1), None);
        assert_eq!(margin(Rule::SpecificSliding, 0.0), None);
        assert_eq!(margin(Rule::SpecificSliding, -0.05), None);
        assert_eq!(margin(Rule::BearingLeastLoad, 0.03), Some(1.5));
    }

    #[test]
    fn wider_ranges_are_milder() {
        for &rule in Rule::ALL {
            let [remark, warning, error] = rule.bounds().0;
            for (inner, outer) in [(remark, warning), (warning, error), (remark, error)] {
                if inner != Range::OPEN {
                    assert!(outer.least <= inner.least && outer.most >= inner.most, "{rule:?}");
                }
            }
        }
    }

    #[test]
    fn a_stated_range_takes_the_place_of_the_usual_one() {
        let mut limits = Limits::default();
        limits.state(Rule::SpecificSliding, Range::at_most(4.0));
        assert!(limits.judge(Rule::SpecificSliding, 3.5).holds());
        let missed = limits.judge(Rule::SpecificSliding, 4.1);
        assert_eq!(missed.severity, Some(Severity::Warning));
        assert_eq!(missed.miss().unwrap(), "specific sliding 4.1, at most 4 by what is stated");
        limits.state(Rule::FaceWidth, Range::between(0.2, 2.5));
        assert!(limits.judge(Rule::FaceWidth, 2.2).holds());
        assert_eq!(limits.judge(Rule::FaceWidth, 2.6).severity, Some(Severity::Error));
        assert_eq!(limits.judge(Rule::FaceWidth, 0.1).severity, Some(Severity::Warning));
        assert!(limits.judge(Rule::SpecificSliding, 3.5).holds(), "that of another rule remains");
        limits.state(Rule::SpecificSliding, Range::at_most(3.2));
        assert!(!limits.judge(Rule::SpecificSliding, 3.5).holds(), "the last one counts");
    }

    #[test]
    fn words_name_the_limit_on_the_side_of_the_value() {
        let words = |rule, value| Limits::default().judge(rule, value).words();
        assert_eq!(
            words(Rule::FaceWidth, 0.3),
            "face width over the diameter of the smaller gear 0.3, at least 0.4 by usual practice"
        );
        assert_eq!(
            words(Rule::FaceWidth, 1.1),
            "face width over the diameter of the smaller gear 1.1, at most 1.2 by usual practice"
        );
        assert_eq!(
            words(Rule::HuntingTooth, 1.0),
            "common divisor of the teeth 1, at most 1 by usual practice"
        );
        assert_eq!(
            words(Rule::SpecificSliding, 3.123_45),
            "specific sliding 3.123, at most 3 by usual practice"
        );
        let remedy = |value| Limits::default().judge(Rule::FaceWidth, value).remedy();
        assert!(remedy(1.3).starts_with("narrower") && remedy(0.3).starts_with("wider"));
        assert!(!Limits::default().judge(Rule::FaceWidth, f64::NAN).holds());
        let asked = Limits::default().judge(Rule::RingShift, 1.3).no_worse_than(Severity::Warning);
        assert_eq!((asked.severity, asked.worst), (Some(Severity::Warning), Severity::Warning));
    }
}

//! Judgement of one published figure.

use crate::calculations::Value;
use crate::cases::case::{Cause, Evidence, Expectation, Verdict};
use crate::cases::tolerance::Printed;
use epicyclic_units::format::significant;
use epicyclic_units::{self as quantity, Dimension, Unit, find_unit};
use serde::Serialize;

/// How close the stated value of a contradicted figure must be to the computed one, relative.
const STATED: f64 = 1e-6;

/// Result of the comparison of a figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// Published and computed agree.
    Agrees,
    /// Computed and restored reading agree; the print is lost or garbled, or never existed.
    Reconstructed,
    /// The figure repeats a definition; the case says which.
    Definition,
    /// The source contradicts its own inputs, as the case says.
    Contradicted,
    /// Taken as input.
    Given,
    /// Lost in the copy.
    Unrecoverable,
    /// Inputs that must be refused, and are.
    Refused,
    /// The case does not hold.
    Failed,
}

/// Kind of a figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// A number, with a unit or without, or a fraction.
    Number,
    /// A statement that holds or does not.
    YesNo,
    /// A name or a state.
    Word,
}

impl Kind {
    /// Kind of a figure as printed.
    #[must_use]
    pub fn of(published: &str) -> Self {
        let is_number = |text: &str| quantity::parse(text).is_ok();
        match published.trim() {
            "yes" | "no" => Self::YesNo,
            text if is_number(text) => Self::Number,
            text if text.split_once('/').is_some_and(|(p, q)| is_number(p) && is_number(q)) => Self::Number,
            _ => Self::Word,
        }
    }
}

/// Figure with its verdict.
#[derive(Debug, Clone, Serialize)]
pub struct Figure {
    /// Case and result: `drive/kinetic_energy`.
    pub name: String,
    /// File of the case, from the project's root.
    pub file: String,
    /// Line of the published figure, from 1.
    pub line: usize,
    /// Column of the published figure, from 1.
    pub column: usize,
    /// Result of the comparison.
    pub status: Status,
    /// Kind of the figure; `None` without a print.
    pub kind: Option<Kind>,
    /// Places of the source from which the figure is cited.
    pub cite: String,
    /// Place where the figure was read, if not in the source itself.
    pub evidence: Option<Evidence>,
    /// Figure as printed.
    pub published: Option<String>,
    /// Figure as computed, in the unit of the printed figure.
    pub computed: Option<String>,
    /// Computed minus published value, in that unit.
    pub difference: Option<String>,
    /// Tolerance of the printed digits, in that unit.
    pub tolerance: Option<String>,
    /// Cause of a loose tolerance.
    pub cause: Option<Cause>,
    /// Name of the first figure that compares the same print; `None` without a print.
    pub print: Option<String>,
    /// Unit that the source prints, if it is wrong.
    pub printed_unit: Option<String>,
    /// Reason for the verdict, or the legible part of a lost figure.
    pub because: Option<String>,
    /// Independent calculation of the right value of a contradicted figure.
    pub arithmetic: Option<String>,
    /// Reason why the case does not hold.
    pub failure: Option<String>,
    /// The remedy for a failure.
    pub remedy: Option<String>,
}

impl Figure {
    /// Whether the figure compares a result; otherwise it is an input that must be refused.
    #[must_use]
    pub const fn is_comparison(&self) -> bool {
        self.kind.is_some() || matches!(self.status, Status::Unrecoverable)
    }

    /// Whether the case ran as far as this figure.
    #[must_use]
    pub const fn was_compared(&self) -> bool {
        !matches!(self.status, Status::Failed) || (self.is_comparison() && self.computed.is_some())
    }
}

/// Judgement of one expectation, without its place.
#[derive(Debug, Default)]
pub struct Judgement {
    /// Figure as computed, in the unit of the printed figure.
    pub computed: Option<String>,
    /// Computed minus published value.
    pub difference: Option<String>,
    /// Tolerance of the printed digits.
    pub tolerance: Option<String>,
    /// Reason why the expectation does not hold.
    pub failure: Option<String>,
    /// The remedy for a failure.
    pub remedy: Option<String>,
}

impl Judgement {
    pub(crate) fn failed(self, why: impl Into<String>, remedy: &str) -> Self {
        Self { failure: Some(why.into()), remedy: Some(remedy.to_owned()), ..self }
    }
}

/// Remedy for a figure that differs from the result.
const COMPARE: &str = "compare `published` and the inputs with the source; if they stand there, either a formula of ours \
    changed, or the source contradicts itself: then write `verdict: contradicted` with `computed` and `because`";
/// Remedy for a contradiction whose figure agrees.
const AGREES_NOW: &str = "a formula or a case was adapted to the print: undo that, or remove the verdict";
/// Remedy for a `computed` that differs from the result.
const DERIVE: &str = "if a formula of ours changed by mistake, undo that; else derive the right value again, apart from our code, \
    and state it as `computed`";
/// Remedy for an `arithmetic` that does not give `computed`.
const RECKON: &str = "correct `arithmetic`, or `computed` where that is wrong";

/// The unit of a dimension with factor 1.
#[must_use]
pub fn si_unit(dimension: Dimension) -> &'static Unit {
    let is_si = |unit: &&Unit| unit.factor == 1.0;
    dimension.units().iter().find(is_si).unwrap_or_else(|| dimension.usual_unit())
}

fn with_unit(number: String, unit: &Unit) -> String {
    if unit.symbol == "1" { number } else { format!("{number} {}", unit.symbol) }
}

/// Judges a result against what is published of it.
#[must_use]
pub fn judge(expectation: &Expectation, value: &Value) -> Judgement {
    let Some(published) = &expectation.published else {
        return Judgement::default().failed("`published` is missing", "write the figure as printed");
    };
    match value {
        Value::Quantity { si, dimension } => judge_quantity(expectation, published, *si, *dimension),
        Value::Count(count) => judge_exact(expectation, published, &count.to_string()),
        Value::Text(text) => judge_exact(expectation, published, text),
    }
}

fn judge_exact(expectation: &Expectation, published: &str, computed: &str) -> Judgement {
    let judgement = Judgement { computed: Some(computed.to_owned()), ..Judgement::default() };
    let agrees = published.trim() == computed;
    match expectation.verdict {
        Verdict::Contradicted if agrees => judgement.failed(STARTS_TO_AGREE, AGREES_NOW),
        Verdict::Contradicted if expectation.computed.as_deref() != Some(computed) => {
            judgement.failed(format!("`computed` differs from the result {computed}"), DERIVE)
        }
        Verdict::Contradicted => {
            match expectation.arithmetic.as_deref().map(|text| stated_exactly(text, computed)) {
                Some(Err(why)) => judgement.failed(why, RECKON),
                _ => judgement,
            }
        }
        _ if agrees => judgement,
        _ => judgement.failed(DIFFERS, COMPARE),
    }
}

/// Whether arithmetic gives a count, or for a yes or no a margin of the right sign.
fn stated_exactly(arithmetic: &str, computed: &str) -> Result<(), String> {
    let result = evaluated(arithmetic)?;
    let holds = match computed {
        "yes" => result > 0.0,
        "no" => result < 0.0,
        count => match count.parse::<f64>() {
            Ok(count) => close(result, count),
            Err(_) => {
                return Err("`arithmetic` gives a number, and `computed` is a word: remove it".to_owned());
            }
        },
    };
    if holds {
        Ok(())
    } else {
        Err(format!("`arithmetic` gives {}, not `computed` {computed}", significant(result, 10)))
    }
}

fn evaluated(arithmetic: &str) -> Result<f64, String> {
    exmex::eval_str::<f64>(arithmetic.replace(char::is_whitespace, " ").trim())
        .map_err(|error| format!("`arithmetic` does not read: {error}"))
}

const STARTS_TO_AGREE: &str = "marked contradicted, but the published figure agrees with the computed one";
const DIFFERS: &str = "the published figure does not agree with the computed one";

fn judge_quantity(expectation: &Expectation, published: &str, si: f64, dimension: Dimension) -> Judgement {
    let mut judgement = Judgement::default();
    let printed = Printed::parse(published, expectation.rounding).and_then(|printed| {
        let due = quantity::parse_as(published, dimension).map(|_| printed)?;
        expectation.tolerance.as_deref().map_or(Ok(due.clone()), |text| due.with_tolerance(text))
    });
    let printed = match printed {
        Ok(printed) => printed,
        Err(error) => return judgement.failed(error.to_string(), "write number and unit as printed"),
    };
    let unit = printed.measured.unit;
    let value = printed.in_unit(si);
    // Enough digits to show the difference, and some more than the print has.
    let digits = printed.measured.number.chars().filter(char::is_ascii_digit).count();
    judgement.computed = Some(with_unit(significant(value, (digits + 2).max(8)), unit));
    judgement.difference = Some(with_unit(significant(value - printed.measured.value, 3), unit));
    judgement.tolerance = Some(with_unit(significant(printed.reach(), 3), unit));
    let agrees = printed.stands_for(si);

    if let Some(wrong) = &expectation.printed_unit {
        // A printed unit is wrong when it is unknown, of another dimension, or of another size.
        let right = find_unit(wrong).is_some_and(|u| u.dimension == dimension && u.factor == unit.factor);
        if right {
            return judgement
                .failed(format!("`printed_unit` {wrong} is the right unit"), "remove `printed_unit`");
        }
    }
    if expectation.verdict != Verdict::Contradicted {
        if agrees {
            return judgement;
        }
        return judgement.failed(DIFFERS, COMPARE);
    }
    if agrees {
        return judgement.failed(STARTS_TO_AGREE, AGREES_NOW);
    }
    let Some(stated) = &expectation.computed else {
        return judgement.failed("`computed` is missing", DERIVE);
    };
    let stated = match quantity::parse_as(stated, dimension) {
        Ok(stated) => stated,
        Err(error) => return judgement.failed(format!("`computed`: {error}"), DERIVE),
    };
    if !close(stated.si(), si) {
        // The result misses the stated value, not the print.
        let right = printed.in_unit(stated.si());
        judgement.difference = Some(with_unit(significant(value - right, 3), unit));
        judgement.tolerance = Some(with_unit(significant(STATED * right.abs(), 3), unit));
        let found = with_unit(significant(si / stated.unit.factor, 10), stated.unit);
        return judgement.failed(format!("`computed` differs from the result {found}"), DERIVE);
    }
    if let Some(arithmetic) = &expectation.arithmetic {
        match evaluated(arithmetic) {
            Ok(result) if close(result, stated.value) => {}
            Ok(result) => {
                return judgement.failed(
                    format!("`arithmetic` gives {}, not `computed`", significant(result, 10)),
                    RECKON,
                );
            }
            Err(why) => return judgement.failed(why, RECKON),
        }
    }
    judgement
}

fn close(stated: f64, found: f64) -> bool {
    (stated - found).abs() <= STATED * found.abs().max(f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::tolerance::Rounding;

    fn expectation(published: &str) -> Expectation {
        Expectation {
            published: Some(published.into()),
            rounding: Rounding::Nearest,
            tolerance: None,
            cause: None,
            print_of: None,
            verdict: Verdict::Agrees,
            computed: None,
            arithmetic: None,
            because: None,
            printed_unit: None,
            legible: None,
            evidence: None,
            cite: None,
        }
    }

    fn contradicted(published: &str, computed: &str) -> Expectation {
        Expectation {
            verdict: Verdict::Contradicted,
            computed: Some(computed.into()),
            because: Some("by hand".into()),
            ..expectation(published)
        }
    }

    fn torque(si: f64) -> Value {
        Value::Quantity { si, dimension: Dimension::Torque }
    }

    fn failure(expectation: &Expectation, value: &Value) -> Option<String> {
        judge(expectation, value).failure
    }

    #[test]
    fn an_agreeing_figure_passes_and_another_says_by_how_much_it_misses() {
        assert_eq!(failure(&expectation("521.8 N·m"), &torque(521.803)), None);
        let missed = judge(&expectation("521.7 N·m"), &torque(521.803));
        assert!(missed.failure.is_some());
        assert_eq!(missed.difference.as_deref(), Some("0.103 N·m"));
        assert_eq!(missed.tolerance.as_deref(), Some("0.0500 N·m"));
    }

    #[test]
    fn a_contradicted_figure_must_not_agree() {
        assert_eq!(failure(&contradicted("600 N·m", "521.803 N·m"), &torque(521.803)), None);
        let agreeing = failure(&contradicted("521.8 N·m", "521.803 N·m"), &torque(521.803));
        assert!(agreeing.is_some_and(|why| why.contains("marked contradicted")));
    }

    #[test]
    fn the_stated_value_is_held_to_a_millionth() {
        let stale = failure(&contradicted("600 N·m", "521.804 N·m"), &torque(521.803));
        assert!(stale.is_some_and(|why| why.contains("differs from the result")));
    }

    #[test]
    fn stated_arithmetic_is_carried_out() {
        let with = |arithmetic: &str| Expectation {
            arithmetic: Some(arithmetic.into()),
            ..contradicted("600 N·m", "521.803 N·m")
        };
        assert_eq!(failure(&with("500 + 21.803"), &torque(521.803)), None);
        assert!(failure(&with("500 + 22"), &torque(521.803)).is_some_and(|why| why.contains("gives 522")));
        assert!(failure(&with("500 +"), &torque(521.803)).is_some_and(|why| why.contains("does not read")));
    }

    #[test]
    fn arithmetic_of_a_statement_is_a_margin_and_of_a_count_the_count() {
        let with = |published: &str, computed: &str, arithmetic: &str| Expectation {
            arithmetic: Some(arithmetic.into()),
            ..contradicted(published, computed)
        };
        let no = Value::Text("no".into());
        assert_eq!(failure(&with("yes", "no", "2 - 2.28"), &no), None);
        assert!(
            failure(&with("yes", "no", "2 - 1.9"), &no).is_some_and(|why| why.contains("not `computed` no"))
        );
        assert_eq!(failure(&with("no", "yes", "1.56 - 1.3"), &Value::Text("yes".into())), None);
        assert_eq!(failure(&with("2", "1", "6 - 4 - 1"), &Value::Count(1)), None);
        assert!(failure(&with("2", "1", "6 - 4"), &Value::Count(1)).is_some());
        assert!(failure(&with("none", "planets", "1"), &Value::Text("planets".into())).is_some());
    }

    #[test]
    fn a_figure_of_another_dimension_fails() {
        assert!(failure(&expectation("521.8 kW"), &torque(521.8)).is_some());
        assert!(failure(&expectation("521.8"), &torque(521.8)).is_some());
        assert!(failure(&expectation("521,8 N·m"), &torque(521.8)).is_some_and(|why| why.contains("comma")));
    }

    #[test]
    fn a_right_unit_cannot_be_called_wrong() {
        let wrong = Expectation { printed_unit: Some("J".into()), ..expectation("26.09 N·m") };
        assert_eq!(failure(&wrong, &torque(26.09)), None);
        let right = Expectation { printed_unit: Some("Nm".into()), ..expectation("26.09 N·m") };
        assert!(failure(&right, &torque(26.09)).is_some());
    }

    #[test]
    fn a_figure_is_a_number_a_statement_or_a_word() {
        for number in ["521.8 N·m", "4", "-0.5", "33/7", "0.3 rad"] {
            assert_eq!(Kind::of(number), Kind::Number, "{number}");
        }
        assert_eq!(Kind::of("yes"), Kind::YesNo);
        for word in ["driven", "II-3", "I"] {
            assert_eq!(Kind::of(word), Kind::Word, "{word}");
        }
    }

    #[test]
    fn a_reconstructed_figure_is_judged_like_one_that_agrees() {
        let restored = |published| Expectation { verdict: Verdict::Reconstructed, ..expectation(published) };
        assert_eq!(failure(&restored("521.8 N·m"), &torque(521.803)), None);
        assert!(failure(&restored("521.7 N·m"), &torque(521.803)).is_some());
        assert!(failure(&restored("no"), &Value::Text("yes".into())).is_some());
    }

    #[test]
    fn counts_and_words_are_exact() {
        assert_eq!(failure(&expectation("4"), &Value::Count(4)), None);
        assert!(failure(&expectation("4"), &Value::Count(5)).is_some());
        assert_eq!(failure(&contradicted("4", "5"), &Value::Count(5)), None);
        assert_eq!(failure(&expectation("yes"), &Value::Text("yes".into())), None);
    }
}

//! Outcomes for people: contradictions with their reasons, lost figures, and at the end everything that does
//! not hold.

use crate::cases::case::{Cause, Evidence};
use crate::cases::figure::{Figure, Kind, Status};
use crate::cases::load::Fault;
use crate::cases::run::Outcome;
use std::fmt::Write;

/// Width of a line.
const WIDTH: usize = 100;

/// Report of every source, then everything that does not hold, then a line of totals. `shows_values` lists
/// every comparison.
#[must_use]
pub fn render(outcomes: &[Outcome], shows_values: bool) -> String {
    let mut text = String::new();
    for outcome in outcomes {
        source(&mut text, outcome, shows_values);
    }
    failures(&mut text, outcomes);
    totals(&mut text, outcomes);
    text
}

fn source(text: &mut String, outcome: &Outcome, shows_values: bool) {
    line(text, 0, &format!("{}: {}", outcome.source, outcome.title));
    wrapped(text, 2, &counts(std::slice::from_ref(outcome)));
    if !outcome.coverage.is_empty() {
        let covered = outcome.coverage.iter().filter(|place| place.figures > 0).count();
        line(text, 2, &format!("{covered} of {} places of the source covered", outcome.coverage.len()));
        for place in &outcome.coverage {
            if let Some(why) = &place.excused {
                wrapped(text, 4, &format!("excused {} ({}): {why}", place.place, place.what));
            }
        }
    }
    let of = |status: Status| move |figure: &&Figure| figure.status == status;
    let mut section = |heading: &str, is_in: &dyn Fn(&&Figure) -> bool, show: fn(&mut String, &Figure)| {
        let mut figures = outcome.figures.iter().filter(|figure| is_in(figure)).peekable();
        if figures.peek().is_some() {
            text.push('\n');
            line(text, 2, heading);
            figures.for_each(|figure| show(text, figure));
        }
    };
    if shows_values {
        section("agrees", &of(Status::Agrees), value);
        section("agrees with the restored reading", &of(Status::Reconstructed), value);
        section("definition, tested by itself", &of(Status::Definition), value);
        section("given", &of(Status::Given), value);
    }
    section("within a loose tolerance", &|figure| is_loose(figure), loose);
    section("contradicted by the source's own inputs", &of(Status::Contradicted), compared);
    let misprinted = |figure: &&Figure| {
        figure.printed_unit.is_some() && matches!(figure.status, Status::Agrees | Status::Reconstructed)
    };
    section("right figure, wrong unit in print", &misprinted, compared);
    section("unrecoverable", &of(Status::Unrecoverable), |text, figure| {
        let legible = figure.because.as_deref().unwrap_or("nothing");
        wrapped(text, 4, &format!("{}; legible: {legible}", figure.name));
    });
    section("refused, as it must be", &of(Status::Refused), |text, figure| {
        let message = figure.because.as_deref().unwrap_or_default();
        wrapped(text, 4, &format!("{}: {message}", figure.name));
    });
    text.push('\n');
}

/// Published and computed, on one line.
fn value(text: &mut String, figure: &Figure) {
    let published = figure.published.as_deref().unwrap_or("nothing");
    let unit = figure.printed_unit.as_ref().map(|unit| format!(" (printed in {unit})")).unwrap_or_default();
    let computed =
        figure.computed.as_ref().map(|computed| format!(", computed {computed}")).unwrap_or_default();
    let evidence =
        figure.evidence.map(|evidence| format!(" ({})", evidence_word(evidence))).unwrap_or_default();
    line(text, 4, &format!("{}: published {published}{unit}{computed}{evidence}", figure.name));
}

fn compared(text: &mut String, figure: &Figure) {
    value(text, figure);
    if let Some(because) = &figure.because {
        wrapped(text, 6, because);
    }
}

fn is_loose(figure: &Figure) -> bool {
    figure.cause.is_some() && figure.status != Status::Failed
}

fn loose(text: &mut String, figure: &Figure) {
    value(text, figure);
    let allowed = figure.tolerance.as_deref().unwrap_or_default();
    let cause = figure.cause.map(Cause::words).unwrap_or_default();
    let because = figure.because.as_deref().unwrap_or_default();
    wrapped(text, 6, &format!("allowed ±{allowed}, for {cause}: {because}"));
}

/// Failures of every source, at the end of the report.
fn failures(text: &mut String, outcomes: &[Outcome]) {
    let mut section = |heading: &str, is_in: &dyn Fn(&Fault) -> bool, has_figures: bool| {
        let mut shown = String::new();
        for outcome in outcomes {
            let failed =
                outcome.figures.iter().filter(|figure| has_figures && figure.status == Status::Failed);
            failed.for_each(|figure| failure(&mut shown, &outcome.source, figure));
            for fault in outcome.faults.iter().filter(|fault| is_in(fault)) {
                let place = format!("{}:{}:{}", fault.file, fault.line, fault.column);
                wrapped(&mut shown, 2, &format!("{place}: {} [{}]", fault.message, fault.name));
            }
        }
        if !shown.is_empty() {
            line(text, 0, heading);
            text.push_str(&shown);
            text.push('\n');
        }
    };
    // New cases are not failures, so they have their own heading.
    section("NOT ACCEPTED YET", &Fault::is_new, false);
    section("DOES NOT HOLD", &|fault| !fault.is_new(), true);
}

fn failure(text: &mut String, source: &str, figure: &Figure) {
    wrapped(text, 2, &format!("{}: {}", figure.name, figure.failure.as_deref().unwrap_or_default()));
    let parts = [
        ("published ", &figure.published),
        ("computed ", &figure.computed),
        ("allowed ±", &figure.tolerance),
        ("difference ", &figure.difference),
    ];
    let parts: Vec<String> =
        parts.iter().filter_map(|(name, value)| Some(format!("{name}{}", value.as_ref()?))).collect();
    if !parts.is_empty() {
        line(text, 4, &parts.join(", "));
    }
    wrapped(text, 4, &format!("place: {source}, {}", figure.cite));
    line(text, 4, &format!("file: {}:{}:{}", figure.file, figure.line, figure.column));
    if let Some(remedy) = &figure.remedy {
        wrapped(text, 4, &format!("remedy: {remedy}"));
    }
}

/// Comparisons, the prints they compare, their verdicts, and the inputs that are refused.
pub(crate) fn counts(outcomes: &[Outcome]) -> String {
    let sum = |count: fn(&Outcome) -> usize| outcomes.iter().map(count).sum::<usize>();
    let of = |status: Status| outcomes.iter().map(|outcome| outcome.count(status)).sum::<usize>();
    let many = |count: usize, word: &str| format!("{count} {word}{}", if count == 1 { "" } else { "s" });
    let mut text = format!(
        "{} of {} in {}: {} agree{}",
        many(sum(Outcome::comparisons), "comparison"),
        many(sum(Outcome::prints), "print"),
        many(sum(|outcome| outcome.cases), "case"),
        of(Status::Agrees),
        kinds(outcomes, Status::Agrees)
    );
    for (status, word) in [
        (Status::Reconstructed, "reconstructed"),
        (Status::Definition, "definitions"),
        (Status::Contradicted, "contradicted"),
        (Status::Given, "given"),
        (Status::Unrecoverable, "unrecoverable"),
        (Status::Failed, "do not hold"),
    ] {
        match of(status) {
            0 => {}
            1 if status == Status::Definition => text.push_str(", 1 definition"),
            1 if status == Status::Failed => text.push_str(", 1 does not hold"),
            count => {
                let _ = write!(text, ", {count} {word}");
            }
        }
    }
    if of(Status::Refused) > 0 {
        let _ = write!(text, "; {} refused as must be", many(of(Status::Refused), "input"));
    }
    let loose = sum(|outcome| outcome.figures.iter().filter(|figure| is_loose(figure)).count());
    if loose > 0 {
        let _ = write!(text, "; {} within a loose tolerance", many(loose, "comparison"));
    }
    text
}

pub(crate) const fn evidence_word(evidence: Evidence) -> &'static str {
    match evidence {
        Evidence::Secondary => "secondary source",
        Evidence::Unverified => "unverified",
    }
}

/// Kinds of the figures with a status, if they are not all numbers read in their source:
/// ` (58 numbers, 4 yes or no)`.
fn kinds(outcomes: &[Outcome], status: Status) -> String {
    let figures =
        || outcomes.iter().flat_map(|outcome| &outcome.figures).filter(|figure| figure.status == status);
    let count = |is: &dyn Fn(&Figure) -> bool| figures().filter(|figure| is(figure)).count();
    let kind = |kind: Kind| count(&|figure| figure.kind == Some(kind));
    let evidence = |evidence: Evidence| count(&|figure| figure.evidence == Some(evidence));
    let parts = [
        (kind(Kind::Number), "numbers"),
        (kind(Kind::YesNo), "yes or no"),
        (kind(Kind::Word), "words"),
        (evidence(Evidence::Secondary), "by secondary sources"),
        (evidence(Evidence::Unverified), "unverified"),
    ];
    // Figures that are all numbers need no explanation.
    if parts[1..].iter().all(|(count, _)| *count == 0) {
        return String::new();
    }
    let parts: Vec<String> =
        parts.iter().filter(|(count, _)| *count > 0).map(|(count, what)| format!("{count} {what}")).collect();
    format!(" ({})", parts.join(", "))
}

fn totals(text: &mut String, outcomes: &[Outcome]) {
    let (new, faults): (Vec<&Fault>, Vec<&Fault>) =
        outcomes.iter().flat_map(|outcome| &outcome.faults).partition(|fault| fault.is_new());
    let figures_hold = outcomes.iter().all(|outcome| outcome.count(Status::Failed) == 0);
    let verdict = match (figures_hold && faults.is_empty(), new.is_empty()) {
        (true, true) => "verified",
        (true, false) => "NOT ACCEPTED YET",
        (false, _) => "NOT VERIFIED",
    };
    let many = |count: usize, one: &str, many: &str| match count {
        0 => String::new(),
        1 => format!("; 1 {one}"),
        _ => format!("; {count} {many}"),
    };
    let new = many(new.len(), "new case to accept", "new cases to accept");
    let faults = many(faults.len(), "fault in the cases", "faults in the cases");
    line(text, 0, &format!("{verdict}: {}{new}{faults}", counts(outcomes)));
}

fn line(text: &mut String, indent: usize, content: &str) {
    let _ = writeln!(text, "{:indent$}{content}", "");
}

/// A paragraph whose further lines are indented two more.
fn wrapped(text: &mut String, indent: usize, content: &str) {
    let mut current = String::new();
    let mut at = indent;
    for word in content.split_whitespace() {
        let length = at + current.chars().count() + 1 + word.chars().count();
        if !current.is_empty() && length > WIDTH {
            line(text, at, &current);
            current.clear();
            at = indent + 2;
        }
        if !current.is_empty() {
            current.push(' ');
        }
        current.push_str(word);
    }
    line(text, at, &current);
}

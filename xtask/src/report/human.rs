//! Outcomes for people: what agrees, what is contradicted and why, what is lost, what does not hold.

use crate::cases::case::Evidence;
use crate::cases::figure::{Figure, Kind, Status};
use crate::cases::run::Outcome;
use std::fmt::Write;

/// Width of a line.
const WIDTH: usize = 100;

/// The report of every source, with a line of totals.
#[must_use]
pub fn render(outcomes: &[Outcome]) -> String {
    let mut text = String::new();
    for outcome in outcomes {
        source(&mut text, outcome);
    }
    totals(&mut text, outcomes);
    text
}

fn source(text: &mut String, outcome: &Outcome) {
    line(text, 0, &format!("{}: {}", outcome.source, outcome.title));
    line(text, 2, &counts(std::slice::from_ref(outcome)));
    if !outcome.coverage.is_empty() {
        let covered = outcome.coverage.iter().filter(|place| place.figures > 0).count();
        line(text, 2, &format!("{covered} of {} places of the source covered", outcome.coverage.len()));
        for place in &outcome.coverage {
            if let Some(why) = &place.excused {
                wrapped(text, 4, &format!("excused {} ({}): {why}", place.place, place.what));
            }
        }
    }
    let of = |status: Status| outcome.figures.iter().filter(move |figure| figure.status == status);
    let listing = |text: &mut String, heading: &str, status: Status| {
        if of(status).next().is_some() {
            text.push('\n');
            line(text, 2, heading);
            let mut by_case: Vec<(&str, Vec<String>)> = Vec::new();
            for figure in of(status) {
                let (case, quantity) = figure.name.split_once('/').unwrap_or((&figure.name, ""));
                let quantity = match figure.evidence {
                    Some(evidence) => format!("{quantity} ({})", evidence_word(evidence)),
                    None => quantity.to_owned(),
                };
                match by_case.last_mut() {
                    Some((last, quantities)) if *last == case => quantities.push(quantity),
                    _ => by_case.push((case, vec![quantity])),
                }
            }
            for (case, quantities) in by_case {
                wrapped(text, 4, &format!("{case}: {}", quantities.join(", ")));
            }
        }
    };
    listing(text, "agrees", Status::Agrees);
    listing(text, "agrees with the restored reading; not in print", Status::Reconstructed);
    listing(text, "given", Status::Given);

    if of(Status::Contradicted).next().is_some() {
        text.push('\n');
        line(text, 2, "contradicted by the source's own inputs");
        of(Status::Contradicted).for_each(|figure| compared(text, figure));
    }
    let misprinted = |figure: &&Figure| figure.printed_unit.is_some() && figure.status == Status::Agrees;
    if outcome.figures.iter().any(|figure| misprinted(&figure)) {
        text.push('\n');
        line(text, 2, "right figure, wrong unit in print");
        outcome.figures.iter().filter(misprinted).for_each(|figure| compared(text, figure));
    }
    if of(Status::Unrecoverable).next().is_some() {
        text.push('\n');
        line(text, 2, "unrecoverable");
        for figure in of(Status::Unrecoverable) {
            let legible = figure.because.as_deref().unwrap_or("nothing");
            wrapped(text, 4, &format!("{}; legible: {legible}", figure.name));
        }
    }
    if of(Status::Refused).next().is_some() {
        text.push('\n');
        line(text, 2, "refused, as it must be");
        for figure in of(Status::Refused) {
            let message = figure.because.as_deref().unwrap_or_default();
            wrapped(text, 4, &format!("{}: {message}", figure.name));
        }
    }
    if !outcome.holds() {
        text.push('\n');
        line(text, 2, "DOES NOT HOLD");
        of(Status::Failed).for_each(|figure| failed(text, figure));
        for fault in &outcome.faults {
            let place = format!("{}:{}:{}", fault.file, fault.line, fault.column);
            wrapped(text, 4, &format!("{place}: {} [{}]", fault.message, fault.name));
        }
    }
    text.push('\n');
}

fn compared(text: &mut String, figure: &Figure) {
    let published = figure.published.as_deref().unwrap_or("nothing");
    let computed = figure.computed.as_deref().unwrap_or("nothing");
    let unit = figure.printed_unit.as_ref().map(|unit| format!(" (printed in {unit})")).unwrap_or_default();
    line(text, 4, &format!("{}: published {published}{unit}, computed {computed}", figure.name));
    if let Some(because) = &figure.because {
        wrapped(text, 6, because);
    }
}

fn failed(text: &mut String, figure: &Figure) {
    let place = format!("{}:{}:{}", figure.file, figure.line, figure.column);
    let failure = figure.failure.as_deref().unwrap_or_default();
    wrapped(text, 4, &format!("{place}: {}: {failure}", figure.name));
    let parts = [
        ("published", &figure.published),
        ("computed", &figure.computed),
        ("difference", &figure.difference),
        ("tolerance", &figure.tolerance),
    ];
    let parts: Vec<String> =
        parts.iter().filter_map(|(name, value)| Some(format!("{name} {}", value.as_ref()?))).collect();
    if !parts.is_empty() {
        line(text, 6, &parts.join(", "));
    }
}

fn counts(outcomes: &[Outcome]) -> String {
    let of = |status: Status| outcomes.iter().map(|outcome| outcome.count(status)).sum::<usize>();
    let cases: usize = outcomes.iter().map(|outcome| outcome.cases).sum();
    let figures: usize = outcomes.iter().map(|outcome| outcome.figures.len()).sum();
    let many = |count: usize, word: &str| format!("{count} {word}{}", if count == 1 { "" } else { "s" });
    let (figures, cases) = (many(figures, "figure"), many(cases, "case"));
    let kinds = |status| kinds(outcomes, status);
    let mut text = format!("{figures} of {cases}: {} agree{}", of(Status::Agrees), kinds(Status::Agrees));
    if of(Status::Reconstructed) > 0 {
        let _ = write!(text, ", {} reconstructed{}", of(Status::Reconstructed), kinds(Status::Reconstructed));
    }
    for (status, word) in [
        (Status::Contradicted, "contradicted"),
        (Status::Given, "given"),
        (Status::Unrecoverable, "unrecoverable"),
        (Status::Refused, "refused as they must be"),
        (Status::Failed, "do not hold"),
    ] {
        if of(status) > 0 {
            let _ = write!(text, ", {} {word}", of(status));
        }
    }
    text
}

pub(crate) const fn evidence_word(evidence: Evidence) -> &'static str {
    match evidence {
        Evidence::Secondary => "secondary source",
        Evidence::Unverified => "unverified",
    }
}

/// What the figures of a status are, where they are not all numbers read in their source: ` (58 numbers, 4 yes or no)`.
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
    if parts[1..].iter().all(|(count, _)| *count == 0) {
        return String::new();
    }
    let parts: Vec<String> =
        parts.iter().filter(|(count, _)| *count > 0).map(|(count, what)| format!("{count} {what}")).collect();
    format!(" ({})", parts.join(", "))
}

fn totals(text: &mut String, outcomes: &[Outcome]) {
    let faults: usize = outcomes.iter().map(|outcome| outcome.faults.len()).sum();
    let verdict = if outcomes.iter().all(Outcome::holds) { "verified" } else { "NOT VERIFIED" };
    let faults = match faults {
        0 => String::new(),
        1 => ", 1 fault in the cases".to_owned(),
        many => format!(", {many} faults in the cases"),
    };
    line(text, 0, &format!("{verdict}: {}{faults}", counts(outcomes)));
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

//! Checks that README and book state the counts and every finding.

use crate::cases::figure::{Figure, Kind, Status};
use crate::cases::load::Fault;
use crate::cases::run::Outcome;
use crate::report::human;
use epicyclic_formats::document::Position;
use std::fs;
use std::path::Path;

const README: &str = "README.md";
const VERIFICATION: &str = "docs/src/verification.md";
const FINDINGS: &str = "docs/src/findings.md";

/// Adds a fault for every finding and, where all cases ran and hold, for every count that a text of the
/// project in `root` lacks. A text that is not there is not checked.
pub fn check(root: &Path, is_whole: bool, outcomes: &mut [Outcome]) {
    let read = |file: &str| fs::read_to_string(root.join(file)).ok();
    if let Some(chapter) = read(FINDINGS) {
        for outcome in outcomes.iter_mut() {
            let untold =
                outcome.figures.iter().filter(|figure| is_finding(figure) && !lists(&chapter, figure));
            outcome.faults.extend(untold.map(without_text).collect::<Vec<_>>());
        }
    }
    // The counts of a run that fails are not those of the cases.
    let is_counted = is_whole && outcomes.iter().all(Outcome::holds);
    let sentences = if is_counted { sentences(outcomes) } else { Vec::new() };
    let faults = sentences.into_iter().filter_map(|(file, sentence)| {
        let is_said = read(file).is_none_or(|text| text.contains(&sentence));
        let message = format!("the counts changed, and the text does not say so: write \"{sentence}\"");
        (!is_said).then(|| Fault::at_position(file, Position::START, "changed-count", message))
    });
    let faults: Vec<Fault> = faults.collect();
    if let Some(last) = outcomes.last_mut() {
        last.faults.extend(faults);
    }
}

fn is_finding(figure: &Figure) -> bool {
    figure.printed_unit.is_some() || matches!(figure.status, Status::Contradicted | Status::Unrecoverable)
}

fn lists(chapter: &str, figure: &Figure) -> bool {
    chapter.contains(&format!("`{}`", figure.name))
}

fn without_text(figure: &Figure) -> Fault {
    let columns = "figure, printed, right, place, reason";
    let message = format!("{} is a finding without a text: add a row to {FINDINGS}: {columns}", figure.name);
    let at = Position { line: figure.line, column: figure.column };
    Fault::at_position(&figure.file, at, "finding-without-text", message)
}

/// The sentences that hold the counts, and their files.
fn sentences(outcomes: &[Outcome]) -> Vec<(&'static str, String)> {
    let of = |status: Status| outcomes.iter().map(|outcome| outcome.count(status)).sum::<usize>();
    let headline = human::counts(outcomes);
    let mut sentences = vec![
        (README, headline.clone()),
        (VERIFICATION, headline),
        (FINDINGS, format!("{} figures are contradicted", of(Status::Contradicted))),
        (FINDINGS, format!("{} figures are lost", of(Status::Unrecoverable))),
    ];
    sentences.extend(outcomes.iter().map(|outcome| (VERIFICATION, row(outcome))));
    sentences
}

/// The counts of a source as a row of the book's table.
fn row(outcome: &Outcome) -> String {
    let agree = |kind: Kind| {
        let is = |figure: &&Figure| figure.status == Status::Agrees && figure.kind == Some(kind);
        outcome.figures.iter().filter(is).count()
    };
    let statuses = [Status::Reconstructed, Status::Definition, Status::Contradicted, Status::Refused];
    let counts = [outcome.comparisons(), outcome.prints(), outcome.count(Status::Agrees)]
        .into_iter()
        .chain([Kind::Number, Kind::YesNo, Kind::Word].map(agree))
        .chain(statuses.map(|status| outcome.count(status)));
    let cells: Vec<String> = counts.map(|count| count.to_string()).collect();
    format!("| {} | {} |", outcome.source, cells.join(" | "))
}

//! The checks that do not hold, as a table.

use crate::shared::judgement::answer::{Judged, Judgement};
use crate::table::columns::Table;
use crate::table::figure::Figure;
use crate::table::report::{Part, Records, Text};
use epicyclic_judge::Severity;
use std::collections::HashSet;

/// Misses of a list of designs that are all shown.
const MOST_ROWS: usize = 12;

/// The checks that do not hold, the worst first, and the judgement in words.
pub(crate) fn parts(all: &Judgement) -> Vec<Part> {
    let rows: Vec<&Judged> = all.checks.iter().filter(|check| !check.holds).collect();
    with_rows(all, rows, String::new())
}

/// As [`parts`] of a list of designs: of many rows only the first of each rule and severity.
pub(crate) fn parts_of_designs(all: &Judgement) -> Vec<Part> {
    let mut rows: Vec<&Judged> = all.checks.iter().filter(|check| !check.holds).collect();
    let misses = rows.len();
    if misses > MOST_ROWS {
        let mut seen = HashSet::new();
        rows.retain(|check| seen.insert((check.name, check.severity)));
    }
    let note = match misses - rows.len() {
        0 => String::new(),
        more => format!("{more} more misses of the same rules are in JSON."),
    };
    with_rows(all, rows, note)
}

fn with_rows(all: &Judgement, rows: Vec<&Judged>, note: String) -> Vec<Part> {
    if all.checks.is_empty() {
        return vec![];
    }
    let missed = (!rows.is_empty()).then(|| Part::Records(missed(rows, note)));
    missed.into_iter().chain([Part::Text(Text::paragraph(all.summary()))]).collect()
}

fn missed(rows: Vec<&Judged>, note: String) -> Records {
    let shown = ["of", "check", "value", "limit", "unit", "severity"];
    let mut records = Table::new("checks", rows)
        .words("of", "of", |check| check.of.join(", "))
        .words("check", "check", |check| check.name)
        .number("value", "value", |check| check.value)
        .number("limit", "limit", |check| check.limit)
        .words("unit", "unit", |check| Some(check.unit).filter(|unit| !unit.is_empty()))
        .words("severity", "severity", |check| severity(check.severity))
        .words("source", "limit by", |check| check.source)
        .words("remedy", "what helps", |check| check.remedy)
        .view_of("Checks that do not hold", &shown)
        .records();
    records.views[0].note = note;
    records
}

fn severity(severity: Severity) -> Figure {
    Figure::choice(
        severity,
        match severity {
            Severity::Remark => "remark",
            Severity::Warning => "warning",
            Severity::Error => "error",
        },
    )
}

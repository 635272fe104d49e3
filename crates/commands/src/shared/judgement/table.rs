//! The checks that do not hold, as a table.

use crate::shared::judgement::answer::Judgement;
use crate::table::columns::Table;
use crate::table::figure::Figure;
use crate::table::report::{Part, Records, Text};
use epicyclic_judge::Severity;

/// The checks that do not hold, the worst first, and the judgement in words.
pub(crate) fn parts(all: &Judgement) -> Vec<Part> {
    if all.checks.is_empty() {
        return vec![];
    }
    let missed = (all.held < all.checks.len()).then(|| Part::Records(missed(all)));
    missed.into_iter().chain([Part::Text(Text::paragraph(all.summary()))]).collect()
}

fn missed(all: &Judgement) -> Records {
    let shown = ["of", "check", "value", "limit", "unit", "severity"];
    Table::new("checks", all.checks.iter().filter(|check| !check.holds))
        .words("of", "of", |check| check.of.join(", "))
        .words("check", "check", |check| check.name)
        .number("value", "value", |check| check.value)
        .number("limit", "limit", |check| check.limit)
        .words("unit", "unit", |check| Some(check.unit).filter(|unit| !unit.is_empty()))
        .words("severity", "severity", |check| severity(check.severity))
        .words("source", "limit by", |check| check.source)
        .words("remedy", "what helps", |check| check.remedy)
        .view_of("Checks that do not hold", &shown)
        .records()
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

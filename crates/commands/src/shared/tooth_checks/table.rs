//! The checks of the teeth that do not hold, as a table.

use crate::shared::tooth_checks::answer::{NotChecked, ToothChecks};
use crate::table::columns::Table;
use crate::table::figure::Figure;
use crate::table::report::Records;
use epicyclic_gears::involute::check::Severity;

/// Decimals of a value and its limit.
const DECIMALS: usize = 4;

/// The checks that do not hold, with remarks; below it how many hold, and what could not be checked.
pub(crate) fn table(all: &ToothChecks) -> Records {
    let missed = all.checks.iter().filter(|check| !check.holds);
    let lacks = |of: &NotChecked| format!("set {} ({} missing)", of.set, of.missing.join(", "));
    let lacking: Vec<String> = all.not_checked.iter().map(lacks).collect();
    let rest =
        if lacking.is_empty() { String::new() } else { format!(" Not all checked: {}.", lacking.join("; ")) };
    let note = format!("{} of {} checks hold.{rest}", all.held, all.checks.len());
    let shown = ["set", "check", "gears", "value", "limit", "unit", "severity"];
    Table::new("tooth_checks", missed)
        .text("set", "set", |check| &check.set)
        .words("check", "check", |check| check.name)
        .words("gears", "of", |check| (!check.gears.is_empty()).then(|| check.gears.join(", ")))
        .printed("value", "value", DECIMALS, |check| check.value)
        .printed("limit", "limit", DECIMALS, |check| check.limit)
        .words("unit", "unit", |check| Some(check.unit).filter(|unit| !unit.is_empty()))
        .words("severity", "severity", |check| severity(check.severity))
        .words("remedy", "remedy", |check| check.remedy)
        .view_of("Checks of the teeth that do not hold", &shown)
        .note(note)
        .records()
}

/// Whether there is anything to show.
pub(crate) fn has_any(all: &ToothChecks) -> bool {
    all.held < all.checks.len() || !all.not_checked.is_empty()
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

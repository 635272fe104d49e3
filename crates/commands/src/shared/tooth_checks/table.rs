//! The checks of the teeth that do not hold, as a table.

use crate::shared::tooth_checks::answer::{NotChecked, Severity, ToothCheck, ToothChecks};
use crate::table::figure::{Figure, text};
use crate::table::report::{Column, Records, View};

/// Decimals of a value and its limit.
const DECIMALS: usize = 4;

/// The checks that do not hold, with remarks; below it how many hold, and what could not be checked.
pub(crate) fn table(all: &ToothChecks) -> Records {
    let row = |check: &ToothCheck| {
        vec![
            text(&check.set),
            text(check.name),
            if check.gears.is_empty() { Figure::None } else { text(check.gears.join(", ")) },
            check.value.map_or(Figure::None, |value| Figure::Printed(value, DECIMALS)),
            Figure::Printed(check.limit, DECIMALS),
            if check.unit.is_empty() { Figure::None } else { text(check.unit) },
            severity(check.severity),
            check.remedy.map_or(Figure::None, text),
        ]
    };
    let missed = all.checks.iter().filter(|check| !check.holds);
    let lacks = |of: &NotChecked| format!("set {} ({} missing)", of.set, of.missing.join(", "));
    let lacking: Vec<String> = all.not_checked.iter().map(lacks).collect();
    let rest =
        if lacking.is_empty() { String::new() } else { format!(" Not all checked: {}.", lacking.join("; ")) };
    let note = format!("{} of {} checks hold.{rest}", all.held, all.checks.len());
    let shown = ["set", "check", "gears", "value", "limit", "unit", "severity"];
    Records {
        name: "tooth_checks",
        is_answer: false,
        columns: vec![
            Column::words("set", "set"),
            Column::words("check", "check"),
            Column::words("gears", "of"),
            Column::number("value", "value"),
            Column::number("limit", "limit"),
            Column::words("unit", "unit"),
            Column::words("severity", "severity"),
            Column::words("remedy", "remedy"),
        ],
        rows: missed.map(row).collect(),
        views: vec![View { note, ..View::new("Checks of the teeth that do not hold", &shown) }],
    }
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

//! Machines in service beside the number of speeds recommended for them.

use epicyclic_schemes::DesignError;
use epicyclic_schemes::machines::{Machine, Recommendation, machine, machines};
use epicyclic_views::figure::{Figure, text};
use epicyclic_views::report::{Column, Part, Records, Report, View};

/// All machines, or one.
pub(super) fn report(name: Option<&str>) -> Result<Report, DesignError> {
    let shown: Vec<&Machine> = match name {
        Some(name) => vec![machine(name)?],
        None => machines().iter().collect(),
    };
    let note = if name.is_none() { count(&shown) } else { String::new() };
    let records = Records {
        name: "machines",
        columns: vec![
            Column::words("machine", "machine"),
            Column::words("kind", "drive"),
            Column::words("table", "table"),
            Column::number("range", "d"),
            Column::number("speeds", "speeds"),
            Column::number("recommended", "recommended"),
            Column::words("as_recommended", "agree"),
            Column::words("recommendation_is_printed", "printed"),
        ],
        rows: shown.iter().map(|machine| row(machine)).collect(),
        views: vec![View {
            note,
            ..View::new(
                "Machines: range d of the fastest speed over the slowest, and numbers of speeds",
                &["machine", "kind", "range", "speeds", "recommended", "as_recommended"],
            )
        }],
        is_answer: true,
    };
    Ok(Report { title: None, parts: vec![Part::Records(records)], warnings: None })
}

fn row(machine: &Machine) -> Vec<Figure> {
    let recommended = machine.recommended();
    vec![
        text(machine.name),
        text(machine.kind),
        text(machine.table.number()),
        Figure::Printed(machine.speed_range, 2),
        machine.steps.map_or_else(|| Figure::Answer("stepless", "stepless"), Figure::Count),
        Figure::Count(recommended.speeds),
        machine.is_as_recommended().map_or(Figure::None, Figure::YesNo),
        Figure::YesNo(recommended.printed),
    ]
}

fn count(shown: &[&Machine]) -> String {
    let stepped: Vec<bool> = shown.iter().filter_map(|machine| machine.is_as_recommended()).collect();
    let alike = stepped.iter().filter(|alike| **alike).count();
    format!(
        "{alike} of {} stepped machines have the recommended number. The recommendation was drawn up for bucket \
         wheels; at the ends of its intervals, and for d above 4, the number is our choice.",
        stepped.len()
    )
}

/// A recommendation in words.
pub(super) fn in_words(recommended: Recommendation) -> &'static str {
    if recommended.printed { "" } else { "our choice: the source leaves this range open" }
}

//! Shifts between gears.

use super::shared::count;
use crate::analyze::answer::shifts::{ElementInShift, Shift, Shifts, Transition};
use crate::table::figure::{Figure, multiple, text};
use crate::table::quantities::column;
use crate::table::report::AsReport;
use crate::table::report::{Column, Part, Records, Report, Text, View, warned};
use epicyclic_units::Dimension;

impl AsReport for Shifts {
    fn report(&self) -> Report {
        let mut parts = vec![];
        if self.shifts.is_empty() {
            let none = "No two gears have different ratios between the same links in the same direction: there are no shifts to \
                        tell.";
            parts.push(Part::Text(Text::paragraph(none)));
        } else {
            parts.push(Part::Records(records(
                &self.shifts,
                "Shifts, neighbours first, then those that pass gears over",
            )));
            parts.push(Part::Records(changes(self)));
            parts.push(Part::Records(slips(self)));
        }
        Report { title: Some(self.gearbox.clone()), parts, warnings: warned(&self.warnings) }
    }
}

/// What is released and applied, and what the input does.
pub(super) fn records(shifts: &[Shift], title: &str) -> Records {
    let mut shown = vec!["from", "to"];
    if shifts.iter().any(|shift| shift.skipped_ratios > 0) {
        shown.push("skipped_ratios");
    }
    shown.extend(["releases", "applies", "transition", "input_speed_after_of_before"]);
    if shifts.iter().any(|shift| shift.input_speed_before_rad_s.is_some()) {
        shown.extend(["input_speed_before", "input_speed_after"]);
    }
    let has_one_way =
        shifts.iter().any(|shift| !shift.one_way_released.is_empty() || !shift.one_way_applied.is_empty());
    let one_way = if has_one_way { " In brackets: one-way clutches, which act by themselves." } else { "" };
    let note = format!(
        "Input: its speed after over that before, at the same speed of the output. The way back releases what is applied \
         here.{one_way}"
    );
    Records {
        name: "shifts",
        columns: columns(),
        rows: shifts.iter().map(row).collect(),
        views: vec![View { note, ..View::new(title, &shown) }],
        is_answer: false,
    }
}

fn columns() -> Vec<Column> {
    vec![
        Column::words("from", "from"),
        Column::words("to", "to"),
        Column::number("skipped_ratios", "skips"),
        Column::words("releases", "releases").for_people(),
        Column::words("applies", "applies").for_people(),
        Column::words("released", "releases"),
        Column::words("applied", "applies"),
        Column::words("one_way_released", "let go by themselves"),
        Column::words("one_way_applied", "take over by themselves"),
        Column::words("transition", "transition"),
        Column::number("input_speed_after_of_before", "input"),
        Column {
            heading: "rpm before".to_owned(),
            ..Column::quantity("input_speed_before", Dimension::AngularSpeed)
        },
        Column {
            heading: "rpm after".to_owned(),
            ..Column::quantity("input_speed_after", Dimension::AngularSpeed)
        },
    ]
}

fn row(shift: &Shift) -> Vec<Figure> {
    let with_one_way = |elements: &[String], one_way: &[String]| {
        let one_way = one_way.iter().map(|clutch| format!("({clutch})"));
        Figure::Texts(elements.iter().cloned().chain(one_way).collect())
    };
    vec![
        text(&shift.from),
        text(&shift.to),
        count(shift.skipped_ratios),
        with_one_way(&shift.released, &shift.one_way_released),
        with_one_way(&shift.applied, &shift.one_way_applied),
        Figure::Texts(shift.released.clone()),
        Figure::Texts(shift.applied.clone()),
        Figure::Texts(shift.one_way_released.clone()),
        Figure::Texts(shift.one_way_applied.clone()),
        transition(shift.transition),
        multiple(Some(shift.input_speed_after_of_before)),
        column(Dimension::AngularSpeed, shift.input_speed_before_rad_s),
        column(Dimension::AngularSpeed, shift.input_speed_after_rad_s),
    ]
}

fn transition(transition: Transition) -> Figure {
    let words = match transition {
        Transition::Single => "single",
        Transition::Double => "double",
        Transition::Multiple => "multiple",
    };
    Figure::choice(transition, words)
}

/// The change of slip: a line a shift, a column a shift element.
fn changes(shifts: &Shifts) -> Records {
    let elements = shifts.shifts.first().map_or(&[][..], |shift| &shift.shift_elements);
    let is_known = shifts.input_speed_rad_s.is_some();
    let of_element = |element: &ElementInShift| {
        let dimension = is_known.then_some(Dimension::AngularSpeed);
        Column { dimension, ..Column::number("slip_change", "").of(&element.shift_element) }
    };
    let columns = [Column::words("from", "from"), Column::words("to", "to")].into_iter();
    let change = |element: &ElementInShift| match element.slip_before_rad_s.zip(element.slip_after_rad_s) {
        Some((before, after)) => column(Dimension::AngularSpeed, Some(after - before)),
        None => multiple(element.slip_change_of_input),
    };
    let row = |shift: &Shift| {
        let changes = shift.shift_elements.iter().map(change);
        [text(&shift.from), text(&shift.to)].into_iter().chain(changes).collect()
    };
    let title = if is_known {
        "Change of slip of the shift elements, rpm"
    } else {
        "Change of slip of the shift elements over the input's speed before"
    };
    Records {
        name: "slip_changes",
        rows: shifts.shifts.iter().map(row).collect(),
        views: vec![View {
            note: "Slip: speed of the first link less that of the second; after the shift less before. What is applied comes to \
                   rest over this difference, what is released opens by it."
                .to_owned(),
            ..View::new(title, &["from", "to", "slip_change"])
        }],
        columns: columns.chain(elements.iter().map(of_element)).collect(),
        is_answer: false,
    }
}

/// For CSV: a line for each shift element in each shift.
fn slips(shifts: &Shifts) -> Records {
    let shift_columns = || columns().into_iter().filter(|column| !column.is_for_people);
    let of_element = [
        Column::words("shift_element", "element"),
        Column::number("slip_before_of_input", "slip before"),
        Column::number("slip_after_of_input", "slip after"),
        Column::number("slip_change_of_input", "change of slip"),
        Column::quantity("slip_before", Dimension::AngularSpeed),
        Column::quantity("slip_after", Dimension::AngularSpeed),
    ];
    let is_shown: Vec<bool> = columns().iter().map(|column| !column.is_for_people).collect();
    let rows = shifts.shifts.iter().flat_map(|shift| {
        let of_shift: Vec<Figure> = row(shift)
            .into_iter()
            .zip(&is_shown)
            .filter(|(_, is_shown)| **is_shown)
            .map(|(cell, _)| cell)
            .collect();
        shift.shift_elements.iter().map(move |element| {
            let cells = [
                text(&element.shift_element),
                multiple(element.slip_before_of_input),
                multiple(element.slip_after_of_input),
                multiple(element.slip_change_of_input),
                column(Dimension::AngularSpeed, element.slip_before_rad_s),
                column(Dimension::AngularSpeed, element.slip_after_rad_s),
            ];
            of_shift.iter().cloned().chain(cells).collect()
        })
    });
    Records {
        name: "slips",
        rows: rows.collect(),
        columns: shift_columns().chain(of_element).collect(),
        views: vec![],
        is_answer: true,
    }
}

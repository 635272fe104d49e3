//! Shifts between gears.

use crate::analyze::answer::shifts::{ElementInShift, Shift, Shifts, Transition};
use crate::shared::judgement::table as judgement;
use crate::table::columns::Table;
use crate::table::figure::{Figure, multiple};
use crate::table::quantities::column;
use crate::table::report::AsReport;
use crate::table::report::{Column, Part, Records, Report, Text, warned};
use epicyclic_units::Dimension::AngularSpeed;

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
        parts.extend(judgement::parts(&self.judgement));
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
    let with_one_way = |elements: &[String], one_way: &[String]| {
        let one_way = one_way.iter().map(|clutch| format!("({clutch})"));
        Figure::Texts(elements.iter().cloned().chain(one_way).collect())
    };
    of_shift(Table::new("shifts", shifts), |shift| shift)
        .words("releases", "releases", |shift| with_one_way(&shift.released, &shift.one_way_released))
        .for_people()
        .words("applies", "applies", |shift| with_one_way(&shift.applied, &shift.one_way_applied))
        .for_people()
        .view_of(title, &shown)
        .note(note)
        .records()
}

/// The columns that a list has of each shift.
fn of_shift<Row>(table: Table<Row>, shift: impl Fn(&Row) -> &Shift) -> Table<Row> {
    let texts = |elements: &[String]| Figure::Texts(elements.to_vec());
    table
        .text("from", "from", |row| &shift(row).from)
        .text("to", "to", |row| &shift(row).to)
        .number("skipped_ratios", "skips", |row| shift(row).skipped_ratios)
        .words("released", "releases", |row| texts(&shift(row).released))
        .words("applied", "applies", |row| texts(&shift(row).applied))
        .words("one_way_released", "let go by themselves", |row| texts(&shift(row).one_way_released))
        .words("one_way_applied", "take over by themselves", |row| texts(&shift(row).one_way_applied))
        .words("transition", "transition", |row| transition(shift(row).transition))
        .multiple("input_speed_after_of_before", "input", |row| shift(row).input_speed_after_of_before)
        .headed("input_speed_before", "rpm before", AngularSpeed, |row| shift(row).input_speed_before_rad_s)
        .headed("input_speed_after", "rpm after", AngularSpeed, |row| shift(row).input_speed_after_rad_s)
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
    let dimension = shifts.input_speed_rad_s.map(|_| AngularSpeed);
    let change = |element: &ElementInShift| match element.slip_before_rad_s.zip(element.slip_after_rad_s) {
        Some((before, after)) => column(AngularSpeed, Some(after - before)),
        None => multiple(element.slip_change_of_input),
    };
    let title = match dimension {
        Some(_) => "Change of slip of the shift elements, rpm",
        None => "Change of slip of the shift elements over the input's speed before",
    };
    Table::new("slip_changes", &shifts.shifts)
        .text("from", "from", |shift| &shift.from)
        .text("to", "to", |shift| &shift.to)
        .each(elements.iter().enumerate(), |table, (place, element)| {
            let own = Column { dimension, ..Column::number("slip_change", "").of(&element.shift_element) };
            table.column(own, |shift| shift.shift_elements.get(place).map_or(Figure::None, change))
        })
        .view(title, "from to slip_change")
        .note(
            "Slip: speed of the first link less that of the second; after the shift less before. What is applied comes to \
             rest over this difference, what is released opens by it.",
        )
        .records()
}

/// For CSV: a line for each shift element in each shift.
fn slips(shifts: &Shifts) -> Records {
    let rows =
        shifts.shifts.iter().flat_map(|shift| shift.shift_elements.iter().map(move |one| (shift, one)));
    of_shift(Table::new("slips", rows), |(shift, _)| shift)
        .text("shift_element", "element", |(_, one)| &one.shift_element)
        .multiple("slip_before_of_input", "slip before", |(_, one)| one.slip_before_of_input)
        .multiple("slip_after_of_input", "slip after", |(_, one)| one.slip_after_of_input)
        .multiple("slip_change_of_input", "change of slip", |(_, one)| one.slip_change_of_input)
        .quantity("slip_before", "", AngularSpeed, |(_, one)| one.slip_before_rad_s)
        .quantity("slip_after", "", AngularSpeed, |(_, one)| one.slip_after_rad_s)
        .the_answer()
        .records()
}

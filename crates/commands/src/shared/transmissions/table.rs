//! The transmissions of a file, as a table.

use crate::shared::transmissions::answer::{Transmission, Transmissions};
use crate::table::figure::{Figure, text};
use crate::table::report::AsReport;
use crate::table::report::{Column, Part, Records, Report, Text, View};

impl AsReport for Transmissions {
    fn report(&self) -> Report {
        let count = |count: usize| Figure::Count(u32::try_from(count).unwrap_or(u32::MAX));
        let row = |one: &Transmission| {
            vec![text(&one.name), count(one.sets), count(one.shift_elements), count(one.gears)]
        };
        let records = Records {
            name: "transmissions",
            columns: vec![
                Column::words("name", "name"),
                Column::number("sets", "sets"),
                Column::number("shift_elements", "shift elements"),
                Column::number("gears", "gears"),
            ],
            rows: self.transmissions.iter().map(row).collect(),
            views: vec![View::new("Transmissions", &["name", "sets", "shift_elements", "gears"])],
            is_answer: true,
        };
        let hint = Text::paragraph("--transmission chooses one, by its name or a part of it.");
        Report { title: None, parts: vec![Part::Records(records), Part::Text(hint)], warnings: None }
    }
}

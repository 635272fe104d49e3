//! The transmissions of a file, as a table.

use crate::shared::transmissions::answer::Transmissions;
use crate::table::columns::Table;
use crate::table::report::AsReport;
use crate::table::report::{Part, Report, Text};

impl AsReport for Transmissions {
    fn report(&self) -> Report {
        let records = Table::new("transmissions", self.transmissions.iter())
            .text("name", "name", |one| &one.name)
            .number("sets", "sets", |one| one.sets)
            .number("shift_elements", "shift elements", |one| one.shift_elements)
            .number("gears", "gears", |one| one.gears)
            .view("Transmissions", "name sets shift_elements gears")
            .the_answer()
            .records();
        let hint = Text::paragraph("--transmission chooses one, by its name or a part of it.");
        Report { title: None, parts: vec![Part::Records(records), Part::Text(hint)], warnings: None }
    }
}

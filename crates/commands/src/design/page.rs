//! The page of a design: the page of its gearbox with how it was chosen.

use crate::design::answer::Design;
use crate::design::table::{in_short, parts_of_choice, parts_of_sizes};
use crate::page::sheet::{Arrangement, Block, Section, Sheet};
use crate::table::report::{AsReport, Report};

/// Builds the page of the designed gearbox. The design steps precede its other chapters and the command
/// follows; without a gearbox the page shows the steps.
#[must_use]
pub fn sheet(design: &Design, gearbox: Option<Sheet>, command: &str) -> Sheet {
    let choice = || vec![Block::Answer(Report { parts: parts_of_choice(design), ..Report::default() })];
    let Some(mut sheet) = gearbox else {
        return Sheet {
            title: "Design of a gearbox".to_owned(),
            about: in_short(design),
            answer: vec![Block::Answer(design.report())],
            arrangement: Arrangement::Rows,
            objections: vec![],
            sections: vec![],
            input: command.to_owned(),
        };
    };
    sheet.sections.insert(0, Section::new("How it was chosen", choice()).arranged(Arrangement::Rows));
    if let Some(sizes) = &design.sizes {
        let sizes = Block::Answer(Report { parts: parts_of_sizes(sizes), ..Report::default() });
        sheet.sections.insert(1, Section::new("Sizes and safeties", vec![sizes]).arranged(Arrangement::Rows));
    }
    sheet.input = format!("# {}\n{}", command.trim_end(), sheet.input);
    sheet
}

//! The page of a design: the page of its gearbox with how it was chosen.

use crate::design::answer::Design;
use crate::design::answer::records::SizesStep;
use crate::design::answer::stages::Stages;
use crate::design::answer::transmission::Transmission;
use crate::design::table::stages::{self, parts_of_stages};
use crate::design::table::transmission::{self, parts_of_transmission};
use crate::design::table::{in_short, parts_of_choice, parts_of_sizes};
use crate::page::sheet::{Arrangement, Block, Section, Sheet};
use crate::table::report::{AsReport, Report};

/// Builds the page of stages in series, as [`sheet`] that of a gearbox of several speeds.
#[must_use]
pub fn sheet_of_stages(stages: &Stages, gearbox: Option<Sheet>, command: &str) -> Sheet {
    let all = Block::Answer(Report { parts: parts_of_stages(stages), ..Report::default() });
    let Some(mut sheet) = gearbox else { return empty(stages::in_short(stages), stages.report(), command) };
    sheet.sections.insert(0, Section::new("How it was chosen", vec![all]).arranged(Arrangement::Rows));
    finished(sheet, stages.sizes.as_ref(), command)
}

/// Builds the page of a gearbox for a list of gears, as [`sheet`] that of a gearbox of a scheme.
#[must_use]
pub fn sheet_of_transmission(of: &Transmission, gearbox: Option<Sheet>, command: &str) -> Sheet {
    let all = Block::Answer(Report { parts: parts_of_transmission(of), ..Report::default() });
    let Some(mut sheet) = gearbox else { return empty(transmission::in_short(of), of.report(), command) };
    sheet.sections.insert(0, Section::new("How it was chosen", vec![all]).arranged(Arrangement::Rows));
    finished(sheet, of.sizes.as_ref(), command)
}

/// Page without a gearbox.
fn empty(about: String, report: Report, command: &str) -> Sheet {
    Sheet {
        title: "Design of a gearbox".to_owned(),
        objections: vec!["No gearbox was found.".to_owned()],
        about,
        answer: vec![Block::Answer(report)],
        arrangement: Arrangement::Rows,
        sections: vec![],
        input: command.to_owned(),
    }
}

/// Adds the sizes and the command to the page of a gearbox.
fn finished(mut sheet: Sheet, sizes: Option<&SizesStep>, command: &str) -> Sheet {
    if let Some(sizes) = sizes {
        let sizes = Block::Answer(Report { parts: parts_of_sizes(sizes), ..Report::default() });
        sheet.sections.insert(1, Section::new("Sizes and safeties", vec![sizes]).arranged(Arrangement::Rows));
    }
    sheet.input = format!("# {}\n{}", command.trim_end(), sheet.input);
    sheet
}

/// Builds the page of the designed gearbox. The design steps precede its other chapters and the command
/// follows; without a gearbox the page shows the steps.
#[must_use]
pub fn sheet(design: &Design, gearbox: Option<Sheet>, command: &str) -> Sheet {
    let choice = || vec![Block::Answer(Report { parts: parts_of_choice(design), ..Report::default() })];
    let Some(mut sheet) = gearbox else { return empty(in_short(design), design.report(), command) };
    sheet.sections.insert(0, Section::new("How it was chosen", choice()).arranged(Arrangement::Rows));
    finished(sheet, design.sizes.as_ref(), command)
}

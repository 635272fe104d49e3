//! The page of a comparison: the figures of the gearboxes side by side, and the scheme of each.

use crate::compare::answer::Comparison;
use crate::compare::answer::page::Drawn;
use crate::page::paper::PICTURE_MM;
use crate::page::sheet::{Arrangement, Block, Section, Sheet};
use crate::table::report::{AsReport as _, Report};
use crate::table::text::Error;
use epicyclic_pictures::gearbox::scheme::{self, Show};

/// Builds the page of a comparison, with the schemes of the drawable gearboxes; `input` is the command line.
///
/// # Errors
/// [`Error::Picture`] for a scheme that cannot be made into a picture.
pub fn sheet(answer: &Comparison, drawn: &[Drawn<'_>], input: String) -> Result<Sheet, Error> {
    let report = answer.report();
    let objections = report.warnings.iter().flatten().map(|(_, warning)| warning.clone()).collect();
    let first = vec![Block::Answer(Report { title: None, warnings: None, ..report })];
    let mut sections = vec![];
    for Drawn { gearbox, layout } in drawn {
        let block = match layout {
            Some(layout) => {
                let scene = scheme::narrow(gearbox, layout, Show::Structure, None, PICTURE_MM[0])
                    .map_err(Error::Picture)?;
                Block::picture(scene, "Kinematic scheme, the half above the axis.")
            }
            None => Block::words("It cannot be drawn without links that cross."),
        };
        sections.push(Section::new(gearbox.name(), vec![block]));
    }
    let left_out = "Losses outside the meshes: bearings, seals, churning oil, drag torques of open clutches and brakes. Strength \
                    and sizes. What happens while it shifts.";
    sections.push(Section::new("What is left out", vec![Block::words(left_out)]));
    let names: Vec<&str> = answer.gearboxes.iter().map(|one| one.gearbox.as_str()).collect();
    Ok(Sheet {
        title: "Gearboxes side by side".to_owned(),
        about: names.join("; "),
        answer: first,
        arrangement: Arrangement::Columns,
        objections,
        sections,
        input,
    })
}

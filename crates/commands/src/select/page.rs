//! Page of the choice of a gearbox: the best design, the reasons for it, the others, those rejected.

use crate::page::paper::PICTURE_MM;
use crate::page::sheet::{Arrangement, Block, Section, Sheet};
use crate::select::answer::Select;
use crate::select::answer::candidate::Candidate;
use crate::select::answer::teeth::SelectTeeth;
use crate::select::table::{in_short, unmet};
use crate::synthesize::answer::page::Drawn;
use crate::table::report::Part;
use crate::table::report::{AsReport as _, Report};
use crate::table::text::Error;
use epicyclic_pictures::gearbox::scheme::{self, Show};

/// Builds the page of a choice among mechanisms; `drawn` is the best one, `input` the command line.
///
/// # Errors
/// [`Error::Picture`] for a scheme that cannot be made into a picture.
pub fn sheet(select: &Select, drawn: Option<&Drawn>, input: String) -> Result<Sheet, Error> {
    let best = select.in_full();
    page(select.report(), best, drawn, input)
}

/// Builds the page of a choice over tooth numbers; `drawn` is the best design, `input` the command line.
///
/// # Errors
/// [`Error::Picture`] for a scheme that cannot be made into a picture.
pub fn sheet_with_teeth(select: &SelectTeeth, drawn: Option<&Drawn>, input: String) -> Result<Sheet, Error> {
    page(select.report(), select.in_full().map(|design| &design.candidate), drawn, input)
}

fn page(
    report: Report,
    best: Option<&Candidate>,
    drawn: Option<&Drawn>,
    input: String,
) -> Result<Sheet, Error> {
    let title = match best {
        Some(best) => format!("Gearbox {}", best.scheme.unwrap_or(&best.structure)),
        None => "No gearbox meets every required criterion".to_owned(),
    };
    let mut answer: Vec<Block> = best.map(|best| Block::Answer(in_short(best))).into_iter().collect();
    if let Some((drawn, layout)) = drawn.and_then(|drawn| Some((drawn, drawn.layout.as_deref()?))) {
        let scene = scheme::narrow(&drawn.gearbox, layout, Show::Structure, None, PICTURE_MM[0]);
        let caption = "Kinematic scheme, the half above the axis.";
        answer.push(Block::picture(scene.map_err(Error::Picture)?, caption));
    }
    // Reasons belong to the short answer, tables to the chapters.
    let (reasons, tables): (Vec<Part>, Vec<Part>) =
        report.parts.into_iter().partition(|part| matches!(part, Part::Text(text) if text.table.is_empty()));
    answer.push(Block::Answer(Report { parts: reasons, ..Report::default() }));
    let left_out = [
        "Losses outside the meshes: bearings, seals, churning oil, drag of open clutches and brakes.",
        "Profile shift and strength of teeth; what happens while it shifts.",
    ];
    Ok(Sheet {
        title,
        about: report.title.unwrap_or_default(),
        answer,
        arrangement: Arrangement::Columns,
        objections: best.map(unmet).unwrap_or_default(),
        sections: vec![
            Section::new(
                "Designs, and one in full",
                vec![Block::Answer(Report { parts: tables, ..Report::default() })],
            ),
            Section::new("What is left out", vec![Block::List(left_out.map(str::to_owned).to_vec())]),
        ],
        input,
    })
}

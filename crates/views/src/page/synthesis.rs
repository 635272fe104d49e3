//! The page of a search for gearboxes: what was searched, the solutions, the best of them as schemes.

use super::sheet::{Block, Section, Sheet};
use crate::report::{Part, Report};
use crate::synthesize::families::table;
use crate::{AsReport as _, Error, drawability};
use epicyclic_answers::synthesize::page::Drawn;
use epicyclic_answers::synthesize::{Solution, Synthesis};
use epicyclic_formats::quantity::format::trimmed;
use epicyclic_pictures::gearbox::scheme::{self, Show};

/// What was searched and found, with the schemes of the best.
///
/// # Errors
/// [`Error::Picture`] for a scheme that cannot be made into a picture.
pub fn sheet(answer: &Synthesis, drawn: &[Drawn]) -> Result<Sheet, Error> {
    let mut sections = vec![Section::new("Search and solutions", vec![Block::Answer(answer.report())])];
    if !answer.families.is_empty() {
        sections.push(Section::new("Families", families(answer)));
    }
    for (solution, drawn) in answer.solutions.iter().zip(drawn) {
        sections.push(Section::new(format!("Gearbox {}", solution.number), of_one(solution, drawn)?));
    }
    let left_out = [
        "Losses outside the meshes: bearings, seals, churning oil, drag torques of open clutches and brakes.",
        "Strength and sizes; profile shift of the teeth.",
        "What happens while it shifts.",
    ];
    sections.push(Section::new("What is left out", vec![Block::List(left_out.map(str::to_owned).to_vec())]));
    let ratios: Vec<String> =
        answer.wanted.iter().map(|gear| crate::synthesize::wanted(gear, answer.tolerance)).collect();
    Ok(Sheet {
        title: "Gearboxes for a list of ratios".to_owned(),
        about: format!("Ratios {}: {}", ratios.join(", "), crate::synthesize::count(answer)),
        sections,
    })
}

/// What a family is, and the table of them.
fn families(answer: &Synthesis) -> Vec<Block> {
    let about = "Gearboxes of one family have equal formulas for all gears, up to an exchange of sets of one kind: the same ratios at the \
                 same k. Efficiency, torques, slips and speeds differ.";
    let table = Report { title: None, parts: vec![Part::Records(table(&answer.families))], warnings: None };
    vec![Block::words(about), Block::Answer(table)]
}

/// A solution in a few lines, and its scheme.
fn of_one(solution: &Solution, drawn: &Drawn) -> Result<Vec<Block>, Error> {
    let elements: Vec<&str> = solution.shift_elements.iter().map(|element| element.name.as_str()).collect();
    let k: Vec<String> = solution.sets.iter().map(|set| trimmed(set.k, 5)).collect();
    let scheme =
        solution.scheme.map_or_else(String::new, |scheme| format!("Scheme {scheme} of the catalogue. "));
    let words = format!(
        "{scheme}Sets {}; k {}; shift elements {}. Least efficiency {}, {} multiple shifts, drag {}.",
        solution.structure,
        k.join(", "),
        elements.join(", "),
        trimmed(solution.least_efficiency, 4),
        solution.multiple_shifts,
        trimmed(solution.rating.mean_drag_of_input, 4),
    );
    let mut blocks = vec![Block::words(words)];
    if let Some(layout) = drawn.layout.as_deref() {
        let options = scheme::Options::default();
        let scene =
            scheme::scene(&drawn.gearbox, layout, Show::Structure, &options).map_err(Error::Picture)?;
        blocks.push(Block::picture(scene, "Kinematic scheme, the half above the axis."));
    }
    if let Some(conflict) = &solution.rating.conflict {
        let why = drawability::together(conflict);
        blocks.push(Block::words(format!(
            "It cannot be drawn without links that cross, and so not be built: {why}"
        )));
    }
    Ok(blocks)
}

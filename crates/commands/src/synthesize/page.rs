//! Page of a search for gearboxes: the classes searched, the solutions, and the schemes of the best.

use crate::page::paper::PICTURE_MM;
use crate::page::sheet::{Arrangement, Block, Section, Sheet};
use crate::shared::drawability::table as drawability;
use crate::synthesize::answer::page::Drawn;
use crate::synthesize::answer::{Solution, Synthesis};
use crate::synthesize::table::families::table;
use crate::table::columns::Table;
use crate::table::report::Part;
use crate::table::report::{AsReport as _, Report};
use crate::table::text::Error;
use epicyclic_pictures::gearbox::scheme::{self, Show};
use epicyclic_units::format::trimmed;

/// Builds the page: the best solution, then classes and solutions, with the schemes of the first ones;
/// `input` is the command line.
///
/// # Errors
/// [`Error::Picture`] for a scheme that cannot be made into a picture.
pub fn sheet(answer: &Synthesis, drawn: &[Drawn], input: String) -> Result<Sheet, Error> {
    let report = answer.report();
    let objections = report.warnings.iter().flatten().map(|(_, warning)| warning.clone()).collect();
    let best = answer.solutions.first().zip(drawn.first());
    let first = best.map(|(solution, drawn)| in_short(solution, drawn)).transpose()?.unwrap_or_default();
    let all = Report { title: None, warnings: None, ..report };
    let mut sections = vec![Section::new("Search and solutions", vec![Block::Answer(all)])];
    if !answer.families.is_empty() {
        sections.push(Section::new("Families", families(answer)));
    }
    let schemes = answer.solutions.iter().zip(drawn);
    let schemes = schemes
        .map(|(solution, drawn)| of_one(&format!("Gearbox {}. ", solution.number), solution, drawn))
        .collect::<Result<Vec<_>, _>>()?;
    sections.push(Section::new("Schemes of the first", schemes.into_iter().flatten().collect()));
    let left_out = [
        "Losses outside the meshes: bearings, seals, churning oil, drag torques of open clutches and brakes.",
        "Strength and sizes; profile shift of the teeth.",
        "What happens while it shifts.",
    ];
    sections.push(Section::new("What is left out", vec![Block::List(left_out.map(str::to_owned).to_vec())]));
    let ratios: Vec<String> =
        answer.wanted.iter().map(|gear| crate::synthesize::table::wanted(gear, answer.tolerance)).collect();
    Ok(Sheet {
        title: "Gearboxes for a list of ratios".to_owned(),
        about: format!("Ratios {}: {}", ratios.join(", "), crate::synthesize::table::count(answer)),
        answer: first,
        arrangement: Arrangement::Columns,
        objections,
        sections,
        input,
    })
}

/// Explanation and table of the families.
fn families(answer: &Synthesis) -> Vec<Block> {
    let about = "Gearboxes of one family have equal formulas for all gears, up to an exchange of sets of one kind: the same ratios at the \
                 same k. Efficiency, torques, slips and speeds differ.";
    let table = Report { parts: vec![Part::Records(table(&answer.families))], ..Report::default() };
    vec![Block::words(about), Block::Answer(table)]
}

/// Best solution: its gears and its scheme.
fn in_short(solution: &Solution, drawn: &Drawn) -> Result<Vec<Block>, Error> {
    let records = Table::new("gears", solution.gears.iter())
        .words("engaged", "engaged", |gear| gear.engaged.clone())
        .multiple("ratio", "i", |gear| gear.ratio)
        .number("deviation", "off by, %", |gear| {
            gear.deviation.map(|deviation| format!("{:+.2}", 100.0 * deviation))
        })
        .multiple("efficiency", "η", |gear| gear.efficiency)
        .view("Gears of gearbox 1, the best", "engaged ratio deviation efficiency")
        .note("Off by: of the wanted ratio. η: with the losses of the meshes alone.")
        .records();
    let gears = Block::Answer(Report { parts: vec![Part::Records(records)], ..Report::default() });
    Ok([gears].into_iter().chain(of_one("", solution, drawn)?).collect())
}

/// Scheme of a solution with its most important figures.
fn of_one(name: &str, solution: &Solution, drawn: &Drawn) -> Result<Vec<Block>, Error> {
    let elements = solution.shift_elements.iter();
    let elements: Vec<String> =
        elements.map(|element| format!("{} {}", element.name, element.joins)).collect();
    let k: Vec<String> = solution.sets.iter().map(|set| trimmed(set.k, 5)).collect();
    let scheme =
        solution.scheme.map_or_else(String::new, |scheme| format!("Scheme {scheme} of the catalogue. "));
    let words = format!(
        "{name}{scheme}Sets {}; k {}; shift elements {}. Forward efficiency {}, {} multiple shifts, drag {}.",
        solution.structure,
        k.join(", "),
        elements.join(", "),
        trimmed(solution.mean_efficiency.unwrap_or(solution.forward_efficiency), 4),
        solution.multiple_shifts,
        trimmed(solution.rating.mean_drag_of_input, 4),
    );
    let mut blocks = vec![];
    match drawn.layout.as_deref() {
        Some(layout) => {
            let scene = scheme::narrow(&drawn.gearbox, layout, Show::Structure, None, PICTURE_MM[0]);
            blocks.push(Block::picture(scene.map_err(Error::Picture)?, words));
        }
        None => blocks.push(Block::words(words)),
    }
    if let Some(conflict) = &solution.rating.conflict {
        let why = drawability::together(conflict);
        blocks.push(Block::words(format!(
            "It cannot be drawn without links that cross, and so not be built: {why}"
        )));
    }
    Ok(blocks)
}

//! Tooth numbers of a solution.

use crate::report::Text;
use epicyclic_answers::synthesize::Solution;
use epicyclic_answers::synthesize::teeth::TeethOfSet;

/// Tooth numbers of a solution with their ratios; nothing where none were asked for.
pub(super) fn teeth(number: usize, found: &Solution) -> Option<Text> {
    let teeth = found.teeth.as_ref()?;
    let heading = format!("Gearbox {number}: tooth numbers, teeth of sun, planet, ring x planets");
    let count = match (teeth.found, teeth.complete) {
        (0, true) => "none within the limits keep the tolerances".to_owned(),
        (found, true) => format!("{found} choices keep the tolerances, {} shown", teeth.choices.len()),
        (found, false) => {
            format!("{found} choices found before the trial was ended: narrow the ranges of teeth or k")
        }
    };
    let mut table = vec![];
    let mut ratios = vec![];
    if !teeth.choices.is_empty() {
        let mut header: Vec<String> = (1..=found.sets.len()).map(|set| format!("set {set}")).collect();
        header.extend(["off by", "exact ratios"].map(String::from));
        table.push(header);
    }
    for choice in &teeth.choices {
        let mut row: Vec<String> = choice
            .sets
            .iter()
            .map(|TeethOfSet { sun, planet, ring, planets }| format!("{sun} {planet} {ring} x{planets}"))
            .collect();
        row.push(format!("{:.2} %", 100.0 * choice.greatest_deviation));
        row.push(choice.ratios.iter().map(ToString::to_string).collect::<Vec<_>>().join(" "));
        ratios.push(row);
    }
    table.extend(ratios);
    Some(Text { heading: Some(heading), points: vec![count], table, ..Text::default() })
}

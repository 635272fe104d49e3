//! Tooth numbers of a solution.

use crate::report::Text;
use epicyclic_answers::synthesize::Solution;
use epicyclic_answers::synthesize::teeth::TeethOfSet;

/// Tooth numbers of a solution with their ratios; nothing where none were asked for.
pub(super) fn teeth(number: usize, found: &Solution) -> Option<Text> {
    let teeth = found.teeth.as_ref()?;
    let is_double_planet = found.sets.iter().any(|set| set.is_double_planet);
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
        header.push("off by".into());
        if is_double_planet {
            header.push("planet".into());
        }
        header.push("exact ratios".into());
        table.push(header);
    }
    for choice in &teeth.choices {
        let mut row: Vec<String> = choice
            .sets
            .iter()
            .map(|TeethOfSet { sun, planet, outer_planet, ring, planets }| match outer_planet {
                None => format!("{sun} {planet} {ring} x{planets}"),
                Some(outer) => format!("{sun} {planet}+{outer} {ring} x{planets}"),
            })
            .collect();
        row.push(format!("{:.2} %", 100.0 * choice.greatest_deviation));
        if is_double_planet {
            row.push(format!("{:.2}", choice.greatest_planet_speed));
        }
        row.push(choice.ratios.iter().map(ToString::to_string).collect::<Vec<_>>().join(" "));
        ratios.push(row);
    }
    table.extend(ratios);
    let mut points = vec![count];
    if is_double_planet {
        points.push(
            "of a double-planet set teeth of sun, inner + outer planet, ring x pairs; planet: the greatest speed of a planet on its \
             carrier with these teeth, over the input's"
                .into(),
        );
    }
    Some(Text { heading: Some(heading), points, table, ..Text::default() })
}

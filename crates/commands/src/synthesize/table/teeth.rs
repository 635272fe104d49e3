//! Tooth numbers of a solution.

use crate::synthesize::answer::Solution;
use crate::synthesize::answer::teeth::TeethOfSet;
use crate::table::report::Text;
use crate::teeth::table::shifted::aim;

/// The offset of a set.
fn offset(set: &TeethOfSet) -> String {
    set.shifts.map_or_else(|| "-".to_owned(), |of| format!("{:+}", of.ring_offset))
}

/// Centre distance and shifts of a set of the first choice.
fn shifts(place: usize, set: &TeethOfSet) -> Option<String> {
    let of = set.shifts?;
    let three = |values: [f64; 3]| values.map(|value| format!("{value:.4}")).join(" ");
    let limited = if of.aim_met { "" } else { ", as far as the limits allow" };
    Some(format!(
        "set {place} of the first choice: a {:.3}, x {}, k {}{limited}",
        of.centre_distance_in_modules,
        three(of.profile_shifts),
        three(of.tip_alterations)
    ))
}

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
        if teeth.profile_shift.is_some() {
            header.push("offsets".into());
        }
        header.push("exact ratios".into());
        table.push(header);
    }
    for choice in &teeth.choices {
        let mut row: Vec<String> = choice
            .sets
            .iter()
            .map(|TeethOfSet { sun, planet, outer_planet, ring, planets, .. }| match outer_planet {
                None => format!("{sun} {planet} {ring} x{planets}"),
                Some(outer) => format!("{sun} {planet}+{outer} {ring} x{planets}"),
            })
            .collect();
        row.push(format!("{:.2} %", 100.0 * choice.greatest_deviation));
        if is_double_planet {
            row.push(format!("{:.2}", choice.greatest_planet_speed));
        }
        if teeth.profile_shift.is_some() {
            row.push(choice.sets.iter().map(offset).collect::<Vec<_>>().join(" "));
        }
        row.push(choice.ratios.iter().map(ToString::to_string).collect::<Vec<_>>().join(" "));
        ratios.push(row);
    }
    table.extend(ratios);
    let mut points = vec![count];
    if let (Some(shift), false) = (&teeth.profile_shift, teeth.choices.is_empty()) {
        let without = if is_double_planet { "; double-planet sets have no profile shift here" } else { "" };
        points.push(format!(
            "offset: teeth of the ring less those of the sun and twice those of a planet{without}"
        ));
        let first = teeth.choices.first().into_iter().flat_map(|choice| &choice.sets);
        points.extend(first.zip(1..).filter_map(|(set, place)| shifts(place, set)));
        points.push(format!(
            "a: centre distance; x: profile shifts of sun, planets, ring, of the ring above 0 inwards; k: tip alterations; in modules; aim: {}",
            aim(shift.aim)
        ));
    }
    if is_double_planet {
        points.push(
            "of a double-planet set teeth of sun, inner + outer planet, ring x pairs; planet: the greatest speed of a planet on its \
             carrier with these teeth, over the input's"
                .into(),
        );
    }
    Some(Text { heading: Some(heading), points, table, ..Text::default() })
}

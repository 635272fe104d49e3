//! What solutions are worth, and why the first is first.

use crate::shared::drawability::table::shut_in;
use crate::synthesize::answer::{Solution, Synthesis};
use crate::table::columns::Table;
use crate::table::report::{Records, Text};
use epicyclic_synthesis::rank::Objective;
use epicyclic_units::format::trimmed;

/// Solutions behind the first that are told one by one.
const MOST_TOLD: usize = 9;

/// The figures of all solutions told.
pub(super) fn ratings(found: &[Solution]) -> Records {
    Table::new("ratings", found)
        .number("number", "no.", |of| of.number)
        .number("efficiency", "η fwd", |of| super::forward_efficiency(of))
        .number("mean_drag_of_input", "drag", |of| of.rating.mean_drag_of_input)
        .number("greatest_torque_of_input", "torque", |of| of.rating.greatest_torque_of_input)
        .number("greatest_speed_of_input", "speed", |of| of.rating.greatest_speed_of_input)
        .number("greatest_circulating_of_entering", "circulating", |of| {
            of.rating.greatest_circulating_of_entering
        })
        .number("progression", "progression", |of| of.rating.progression)
        .words("drawable", "drawable", |of| of.rating.drawable)
        .words("non_dominated", "on front", |of| of.rating.non_dominated)
        .view(
            "Ratings, over the input's",
            "number mean_drag_of_input greatest_torque_of_input greatest_speed_of_input \
             greatest_circulating_of_entering progression drawable non_dominated",
        )
        .note(
            "Drag: slips of the open shift elements, summed, the mean over the forward gears. Torque: the greatest of a shift \
             element or member, with losses. Speed: the greatest of a link, or of a planet relative to its carrier. Progression: \
             the greatest step over the one before. On front: no other is nowhere worse and somewhere better.",
        )
        .records()
}

/// Slips, torques, speeds and circulating power of a solution's gears.
pub(super) fn gears(number: usize, found: &Solution) -> Text {
    let mut header: Vec<String> = vec!["ratio".into()];
    header.extend(found.shift_elements.iter().map(|element| element.name.clone()));
    header.extend(["drag", "T_e", "T_m", "link", "planet", "circ."].map(String::from));
    let mut table = vec![header];
    for (gear, rating) in found.gears.iter().zip(&found.rating.gears) {
        let mut row = vec![format!("{:.3}", gear.ratio)];
        let slips = rating.slips_of_input.iter().zip(&found.shift_elements);
        row.extend(slips.map(|(slip, element)| match slip {
            _ if gear.engaged.contains(&element.name) => String::new(),
            Some(slip) => format!("{slip:.2}"),
            None => "-".into(),
        }));
        let figures = [
            rating.drag_of_input,
            rating.greatest_shift_element_torque_of_input,
            rating.greatest_member_torque_of_input,
            rating.greatest_link_speed_of_input,
            rating.greatest_planet_speed_of_input,
            rating.circulating_of_entering,
        ];
        row.extend(figures.map(|figure| format!("{figure:.2}")));
        table.push(row);
    }
    let heading = format!("Gearbox {number}: slips, torques and speeds over the input's");
    Text { heading: Some(heading), table, ..Text::default() }
}

/// Why the first is first, and what puts the others behind it.
pub(super) fn why(answer: &Synthesis) -> Option<Text> {
    let (first, others) = answer.solutions.split_first()?;
    let mut points = vec![match answer.decided_by {
        _ if answer.found == 1 => "nothing else has these ratios".to_owned(),
        None => "all others are equal to it in every objective".to_owned(),
        Some(objective) => format!("{}; the order asks for that first", extreme(objective, first)),
    }];
    for other in others.iter().take(MOST_TOLD) {
        let number = other.number;
        points.push(match other.rating.behind_by {
            None => format!("{number}: equal in every objective"),
            Some(Objective::Drawable) => format!("{number}: not drawable, {}", crossing(other)),
            Some(objective) => {
                let is_more_better = matches!(objective, Objective::Efficiency | Objective::Reverse);
                let than = if is_more_better { "less than" } else { "above" };
                format!(
                    "{number}: {} {}, {than} {}",
                    name(objective),
                    shown(objective, other),
                    shown(objective, first)
                )
            }
        });
    }
    if !first.rating.drawable {
        points.push(format!("it is not drawable: {}", crossing(first)));
    }
    let names: Vec<&str> = answer.order.iter().map(|objective| name(*objective)).collect();
    points.push(format!("order: {}", names.join(", ")));
    let names: Vec<&str> = answer.objectives.iter().map(|objective| name(*objective)).collect();
    points.push(format!(
        "{} of {} on the front of: {}",
        answer.non_dominated,
        answer.found,
        names.join(", ")
    ));
    Some(Text::list("Why gearbox 1 is first", points))
}

fn crossing(of: &Solution) -> String {
    of.rating.conflict.as_ref().map_or_else(|| "links would cross".to_owned(), shut_in)
}

fn name(objective: Objective) -> &'static str {
    match objective {
        Objective::Drawable => "drawable",
        Objective::Shifts => "multiple shifts",
        Objective::Efficiency => "forward efficiency",
        Objective::Drag => "drag",
        Objective::Torque => "torque",
        Objective::Speed => "speed",
        Objective::Circulation => "circulating power",
        Objective::Progression => "progression",
        Objective::Deviation => "deviation",
        Objective::Reverse => "reverse efficiency",
    }
}

fn extreme(objective: Objective, first: &Solution) -> String {
    let value = shown(objective, first);
    match objective {
        Objective::Drawable => {
            "its scheme can be drawn without links that cross, which not all can".to_owned()
        }
        Objective::Shifts => format!("the fewest of its shifts exchange several shift elements, {value}"),
        Objective::Efficiency if first.mean_efficiency.is_some() => {
            format!(
                "the mean efficiency of its forward gears, by their shares of time, is the highest, {value}"
            )
        }
        Objective::Efficiency => format!("the efficiency of its worst forward gear is the highest, {value}"),
        Objective::Reverse => format!("the efficiency of its worst reverse gear is the highest, {value}"),
        Objective::Drag => {
            format!("its open shift elements slip least, {value} of the input's speed in the mean")
        }
        Objective::Torque => format!("its greatest torque is the least, {value} of the input's"),
        Objective::Speed => {
            format!("its fastest link or planet is the slowest, {value} of the input's speed")
        }
        Objective::Circulation => format!("the least power circulates in it, {value} of what enters"),
        Objective::Progression => format!("its steps rise least, {value}"),
        Objective::Deviation => {
            format!("its ratios are nearest to the wanted ones, {value} of the tolerance off")
        }
    }
}

fn shown(objective: Objective, of: &Solution) -> String {
    let rating = &of.rating;
    let number = |value: f64| trimmed(value, 4);
    match objective {
        Objective::Drawable => if rating.drawable { "yes" } else { "no" }.to_owned(),
        Objective::Shifts => of.multiple_shifts.to_string(),
        Objective::Efficiency => number(super::forward_efficiency(of)),
        Objective::Drag => number(rating.mean_drag_of_input),
        Objective::Torque => number(rating.greatest_torque_of_input),
        Objective::Speed => number(rating.greatest_speed_of_input),
        Objective::Circulation => number(rating.greatest_circulating_of_entering),
        Objective::Progression => rating.progression.map_or_else(|| "none".to_owned(), number),
        Objective::Deviation => number(rating.deviation_of_tolerance),
        Objective::Reverse => of.reverse_efficiency.map_or_else(|| "none".to_owned(), number),
    }
}

//! A given gearbox beside a search, in words.

use crate::synthesize::answer::WantedGear;
use crate::synthesize::answer::explain::{Explanation, Obstacle, Reason};
use crate::table::report::Text;

/// What the gearbox misses, and where it is found or why it is not.
pub(super) fn explained(one: &Explanation) -> Text {
    let mut points = Vec::new();
    if let Some(structure) = &one.structure {
        points.push(format!(
            "its structure is {structure}, its shift elements {}",
            one.shift_elements.join(" ")
        ));
    }
    let missed: Vec<_> = one.gears.iter().filter(|gear| !gear.within).collect();
    if missed.is_empty() {
        points.push("at its own k it has all ratios within the tolerance".to_owned());
    }
    for gear in missed {
        points.push(match (gear.ratio, gear.deviation) {
            (Some(ratio), Some(deviation)) => format!(
                "it misses {}: the nearest is {ratio:.4}, {:+.2} %, with {}",
                wanted(&gear.wanted),
                100.0 * deviation,
                if gear.engaged.is_empty() { "nothing engaged".to_owned() } else { gear.engaged.join(" ") }
            ),
            _ => format!("it misses {}: no choice of shift elements drives its output", wanted(&gear.wanted)),
        });
    }
    match one.number {
        Some(number) => {
            let with = if one.has_all_ratios { "it" } else { "with other k it" };
            let family = one.family.map_or_else(String::new, |family| format!(", of family {family}"));
            points.push(format!("{with} is gearbox {number} of the search{family}"));
        }
        None => points.extend(one.reasons.iter().map(|reason| format!("it is not found: {}", words(reason)))),
    }
    Text::list(format!("{} beside the search", one.gearbox), points)
}

/// The ratio wanted, or the bounds where any within them will do.
fn wanted(gear: &WantedGear) -> String {
    match gear.wanted_ratio {
        Some(ratio) => ratio.to_string(),
        None => format!("{} to {}", gear.least_ratio, gear.greatest_ratio),
    }
}

fn words(reason: &Reason) -> String {
    let (set, element) = (reason.set.as_deref().unwrap_or_default(), reason.shift_element.as_deref());
    let count = reason.count.unwrap_or_default();
    match reason.obstacle {
        Obstacle::SetKind => format!("set `{set}` is neither simple nor a double-planet set"),
        Obstacle::TerminalsJoined => "two of the housing, the input and the output are one link".to_owned(),
        Obstacle::NoStructure => "its sets make no structure: a set has a link twice, a link is on no member, or some sets lock or \
                                  repeat each other"
            .to_owned(),
        Obstacle::BrakeOnTerminal => format!(
            "`{}` brakes the input or the output, which no gearbox of the search does",
            element.unwrap_or_default()
        ),
        Obstacle::MemberOnHousing => {
            "a member is on the housing, which class core has not; --class all-sparse has".to_owned()
        }
        Obstacle::TerminalOnNoMember => {
            "input or output is on no member, which class core needs; --class all-sparse does not".to_owned()
        }
        Obstacle::SetsNotJoined => {
            "its sets are not all joined, which class core needs; --class all-sparse does not".to_owned()
        }
        Obstacle::Sets => format!("it has {count} planet sets, beyond --sets"),
        Obstacle::ShiftElements => format!("it has {count} shift elements, beyond --elements"),
        Obstacle::Engaged => format!("its gears engage {count} shift elements, beyond --engaged"),
        Obstacle::EqualK => format!("with equal k of {count} sets it has not the ratios"),
        Obstacle::EndedBefore => "the search ended before its number of sets and shift elements; give --sets and --elements as \
                                  they are"
            .to_owned(),
        Obstacle::DoublePlanets => {
            format!("it has {} double-planet sets, beyond --double-planets", if count == 0 { "no".to_owned() } else { count.to_string() })
        }
        Obstacle::KOutOfRange => {
            format!("k = {:.4} of set `{set}` is beyond --k", reason.k.unwrap_or(f64::NAN))
        }
        Obstacle::KOfDoublePlanetOutOfRange => format!(
            "k = {:.4} of the double-planet set `{set}` is beyond --k-double",
            reason.k.unwrap_or(f64::NAN)
        ),
        Obstacle::Reducible => {
            format!("the k of set `{set}` moves no wanted ratio: a simpler gearbox does the same")
        }
        Obstacle::UnusedElement => format!(
            "no wanted gear engages `{}`: a gearbox without it does the same",
            element.unwrap_or_default()
        ),
        Obstacle::MissesRatios => "no k in the range gives it all ratios".to_owned(),
        Obstacle::Other => "it breaks another rule of the search, or is among the undecided".to_owned(),
    }
}

//! Why the winner wins, and why the others do not.

use super::candidates::{Ranked, item, name, value};
use super::words;
use epicyclic_formats::quantity::format::trimmed;
use epicyclic_selection::{Candidate, Objective, Order, Selection, Unreachable};

/// Mechanisms out of reach that are told one by one.
const MOST_TOLD: usize = 6;

/// The reasons, as a list.
pub(super) fn reasons(order: Order, ranked: &Ranked, found: &Selection, shown: usize) -> String {
    let accepted = &ranked.all[..ranked.accepted];
    let mut text = match accepted.split_first() {
        None => "Nothing meets every criterion\n".to_owned(),
        Some((best, others)) => {
            let mut text = format!("Why {} wins\n", named(best));
            text += &item(&why_first(order, best, others));
            for objection in best.objections() {
                text += &item(&format!(
                    "to object, though not required: {}",
                    words::evidence(best.mechanism, &objection.evidence)
                ));
            }
            for other in others.iter().take(shown.saturating_sub(1)) {
                text += &item(&behind(order, best, other));
            }
            text
        }
    };
    let rejected = ranked.all.len() - ranked.accepted;
    if rejected > 0 {
        let hint = if ranked.all[0].gears.len() == 2 {
            "; --teeth also tries ratios off the wanted ones"
        } else {
            ""
        };
        let designs = of(rejected, "design");
        text += &item(&format!("{designs} rejected, for the reasons above{hint}"));
    }
    text += &out_of_reach(&found.unreachable);
    text
}

fn of(count: usize, what: &str) -> String {
    if count == 1 { format!("1 {what}") } else { format!("{count} {what}s") }
}

/// A candidate by its name and ratios: one mechanism may serve the ratios in several ways.
fn named(one: &Candidate) -> String {
    let ratios: Vec<String> = one.gears.iter().map(|gear| trimmed(gear.ratio, 5)).collect();
    format!("{} (i = {})", name(one.mechanism), ratios.join(", "))
}

/// Equal where twelve digits are: the library compares on such a grid.
fn differs(objective: Objective, one: &Candidate, other: &Candidate) -> bool {
    (value(objective, one) - value(objective, other)).abs() > 2e-12
}

fn why_first(order: Order, best: &Candidate, others: &[&Candidate]) -> String {
    if others.is_empty() {
        return "nothing else meets every criterion".to_owned();
    }
    let decides = |objective: &Objective| others.iter().any(|other| differs(*objective, best, other));
    let Some(first) = order.objectives().into_iter().find(decides) else {
        return "all others are equal to it in every objective".to_owned();
    };
    format!("{}; the order asks for that first", extreme(first, best))
}

fn extreme(objective: Objective, best: &Candidate) -> String {
    let shown = shown(objective, best);
    match objective {
        Objective::Efficiency if best.gears.len() == 1 => format!("its efficiency is the highest, {shown}"),
        Objective::Efficiency => format!("the efficiency of its worse gear is the highest, {shown}"),
        Objective::Speed => {
            format!("its fastest link or planet is the slowest, {shown} of the input's speed")
        }
        Objective::RingToSun => format!("its row parameters are nearest to the preferred ones, {shown} away"),
        Objective::RatioError => format!("its ratios are nearest to the wanted ones, {shown} off"),
        Objective::Size => format!("its largest ring is the smallest, {shown}"),
    }
}

fn shown(objective: Objective, one: &Candidate) -> String {
    match objective {
        Objective::RatioError => format!("{} %", trimmed(100.0 * value(objective, one), 3)),
        _ => trimmed(value(objective, one), 4),
    }
}

/// What puts one behind the best.
fn behind(order: Order, best: &Candidate, other: &Candidate) -> String {
    let decisive = order.objectives().into_iter().find(|objective| differs(*objective, best, other));
    let name = named(other);
    let Some(objective) = decisive else { return format!("{name}: equal in every objective") };
    let (what, than) = match objective {
        Objective::Efficiency => ("efficiency", "less than"),
        Objective::Speed => ("speed", "above"),
        Objective::RingToSun => ("distance of the row parameters", "above"),
        Objective::RatioError => ("error of the ratio", "above"),
        Objective::Size => ("size", "above"),
    };
    let reversed =
        if other.mixes_directions() { "; and its output reverses against direct drive" } else { "" };
    format!("{name}: {what} {}, {than} {}{reversed}", shown(objective, other), shown(objective, best))
}

fn out_of_reach(all: &[Unreachable]) -> String {
    if all.is_empty() {
        return String::new();
    }
    if all.len() > MOST_TOLD {
        let each =
            of(all.len(), "assignment of the ratios to a mechanism").replace("mechanisms", "mechanism");
        let each = each.replacen("assignment", "assignments", 1);
        return item(&format!(
            "{each} are out of reach: a row would need k at or below 1, or none; --format json lists them"
        ));
    }
    let told = |one: &Unreachable| {
        let wanted: Vec<String> = one.wanted.iter().map(|ratio| trimmed(*ratio, 5)).collect();
        item(&format!("{} (i = {}): {}", name(one.mechanism), wanted.join(", "), words::obstacle(one)))
    };
    all.iter().map(told).collect()
}

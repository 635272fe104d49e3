//! What the planet sets are, and whether their planets fit.

use super::shared::{exact, kind_in_words};
use crate::analyze::answer::sets::{Fit, SetFacts, TeethOf};
use crate::table::columns::Table;
use crate::table::figure::Figure;
use crate::table::report::Records;
use epicyclic_units::format::trimmed;

/// Digits of a number of teeth, which may have half a tooth.
const TEETH_DIGITS: usize = 8;

/// A line for each set.
pub(crate) fn records(sets: &[SetFacts]) -> Records {
    let mut shown = vec!["set", "kind", "gears"];
    if sets.iter().any(|set| set.basic_ratio.is_some()) {
        shown.push("basic_ratio");
    }
    if sets.iter().any(|set| set.efficiency.is_some_and(|efficiency| efficiency < 1.0)) {
        shown.push("efficiency");
    }
    shown.extend(["planets", "fit"]);
    Table::new("sets", sets.iter())
        .text("set", "set", |set| &set.set)
        .words("kind", "kind", |set| Figure::choice(set.kind, kind_in_words(set.kind)))
        .words("gears", "teeth", |set| gears(&set.gears))
        .multiple("basic_ratio", "i₀", |set| set.basic_ratio)
        .number("exact_ratio", "exact", |set| exact(set.exact_ratio))
        .multiple("efficiency", "η₀", |set| set.efficiency)
        .number("planets", "planets", |set| set.planets)
        .words("fit", "fit", |set| fit(set.assembly, set.clearance))
        .view_of("Planet sets", &shown)
        .note(note(sets))
        .records()
}

/// `sun 48, ring 96, planet 24`; what has no teeth is left out.
fn gears(gears: &[TeethOf]) -> String {
    let one = |gear: &TeethOf| Some(format!("{} {}", gear.gear, trimmed(gear.teeth?, TEETH_DIGITS)));
    let known: Vec<String> = gears.iter().filter_map(one).collect();
    if known.is_empty() { "-".to_owned() } else { known.join(", ") }
}

/// Whether the planets fit, as the verb of a sentence about them.
fn fit(assembly: Fit, clearance: Fit) -> &'static str {
    match (assembly, clearance) {
        (Fit::Yes, Fit::Yes) => "assemble, clear",
        (Fit::Yes, Fit::No) => "assemble, do not clear",
        (Fit::No, Fit::Yes) => "clear, do not assemble",
        (Fit::No, Fit::No) => "do not assemble, do not clear",
        (Fit::Yes, _) => "assemble; clearance not checked",
        (Fit::No, _) => "do not assemble; clearance not checked",
        (_, Fit::Yes) => "clear; assembly not checked",
        (_, Fit::No) => "do not clear; assembly not checked",
        (Fit::NoPlanets, _) => "-",
        _ => "not checked",
    }
}

/// What the figures are, and why something is not checked.
fn note(sets: &[SetFacts]) -> String {
    let mut notes = vec![];
    if sets.iter().any(|set| set.basic_ratio.is_some()) {
        notes.push(
            "i₀: speed of the first gear over that of the second, the carrier fixed; −k of a simple set."
                .to_owned(),
        );
    }
    if sets.iter().any(|set| set.efficiency.is_some_and(|efficiency| efficiency < 1.0)) {
        notes.push("η₀: efficiency with the carrier fixed.".to_owned());
    }
    let lacks = |why: Fit| -> Vec<&str> {
        let all = sets.iter().filter(|set| set.assembly == why || set.clearance == why);
        all.map(|set| set.set.as_str()).collect()
    };
    let reasons = [
        (Fit::PlanetsNotGiven, "the number of planets is not given"),
        (Fit::TeethNotGiven, "teeth are not given"),
        (Fit::NotChecked, "where the planets stand does not follow from their teeth"),
    ];
    for (why, reason) in reasons {
        let lacking = lacks(why);
        if !lacking.is_empty() {
            let of = if lacking.len() == sets.len() { "all sets".to_owned() } else { lacking.join(", ") };
            notes.push(format!("Assembly and clearance not checked ({of}): {reason}."));
        }
    }
    if sets.iter().any(|set| matches!(set.assembly, Fit::Yes | Fit::No)) {
        notes.push(
            "Assemble: at equal angles, or as spacing or planet_angles of the set say; clear: tip circles of neighbours, with the profile shifts that are stated.".to_owned(),
        );
    }
    notes.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analyze::answer::records::Kind;

    fn set(planets: Option<u32>, assembly: Fit, clearance: Fit) -> SetFacts {
        let gear = |gear: &str, teeth| TeethOf { gear: gear.to_owned(), teeth };
        SetFacts {
            set: "P".to_owned(),
            kind: Kind::Simple,
            gears: vec![gear("sun", Some(30.0)), gear("ring", Some(67.0)), gear("planet", Some(18.5))],
            basic_ratio: Some(-67.0 / 30.0),
            exact_ratio: None,
            efficiency: None,
            planets,
            assembly,
            clearance,
        }
    }

    #[test]
    fn what_is_not_checked_is_said_with_its_reason() {
        let known = set(Some(3), Fit::Yes, Fit::No);
        let unknown = set(None, Fit::PlanetsNotGiven, Fit::PlanetsNotGiven);
        assert_eq!(gears(&known.gears), "sun 30, ring 67, planet 18.5");
        assert_eq!(fit(known.assembly, known.clearance), "assemble, do not clear");
        assert_eq!(fit(unknown.assembly, unknown.clearance), "not checked");
        assert_eq!(fit(Fit::NoPlanets, Fit::NoPlanets), "-");
        let words = note(std::slice::from_ref(&known));
        assert!(words.contains("clear: tip circles") && !words.contains("not checked"), "{words}");
        let words = note(&[known, SetFacts { set: "Q".to_owned(), ..unknown }]);
        assert!(words.contains("not checked (Q): the number of planets is not given."), "{words}");
    }
}

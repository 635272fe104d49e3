//! Strength of teeth on the page of a gearbox.

use crate::page::sheet::{Arrangement, Block, Section};
use crate::strength::answer::Strength;
use crate::strength::answer::records::LOW_SAFETY;
use crate::strength::table::for_page;

/// Sections for each answer: at the operating point, over the duty.
pub(crate) fn sections(all: &[Strength]) -> Vec<Section> {
    let section = |one: &Strength| {
        let of = match (&one.operating_point, &one.duty[..]) {
            (Some(_), _) => "at the operating point",
            (None, []) => "against the overload",
            (None, _) => "over the duty",
        };
        let blocks = vec![Block::words(in_words(one)), Block::Answer(for_page(one))];
        Section::new(format!("Strength of teeth {of}"), blocks).arranged(Arrangement::Rows)
    };
    all.iter().map(section).collect()
}

/// Governing safety in words, or a note that nothing is rated.
fn in_words(strength: &Strength) -> String {
    strength.governing.as_ref().map_or_else(
        || "No set can be rated.".to_owned(),
        |governing| format!("{governing} governs; {} is required.", governing.required),
    )
}

/// Governing safety for the first page if it is sufficient; otherwise `None`.
pub(crate) fn enough(all: &[Strength]) -> Option<String> {
    let told = all.iter().filter(|one| !is_short(one) && one.governing.is_some()).map(in_words);
    let told: Vec<String> = told.collect();
    (!told.is_empty()).then(|| format!("Strength of teeth: {}", told.join(" ")))
}

/// Objections: governing safeties below the required ones, and parts that cannot be rated.
pub(crate) fn objections(all: &[Strength]) -> Vec<String> {
    let mut told = vec![];
    for one in all {
        if !one.is_rated() {
            told.push("the strength of no set can be rated: see its chapter".to_owned());
        }
        if let Some(governing) = one.governing.as_ref().filter(|_| is_short(one)) {
            let low = one.warnings.iter().filter(|warning| warning.name == LOW_SAFETY).count();
            let others = match low.saturating_sub(1) {
                0 => String::new(),
                1 => "; one more safety is too small".to_owned(),
                others => format!("; {others} more safeties are too small"),
            };
            told.push(format!("{governing} is below the {} required{others}", governing.required));
        }
    }
    told
}

fn is_short(strength: &Strength) -> bool {
    strength.governing.as_ref().is_some_and(|governing| governing.safety < governing.required)
}

/// Effects that the calculation leaves out.
pub(crate) const LEFT_OUT: &str = "Strength of teeth: scuffing, micropitting, flank fracture; strength of sets that are not rated; pins, carrier and \
                                   shafts. Uneven load of the planets but K_γ.";

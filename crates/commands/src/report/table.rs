//! Sizes of the sets on the first sheet of a report.

use crate::report::answer::sizes::SetSizes;
use crate::strength::answer::records::{Against, Governing};
use crate::table::columns::Table;
use crate::table::figure::hours;
use crate::table::quantities::words;
use crate::table::report::Records;
use epicyclic_units::Dimension;
use epicyclic_units::format::trimmed;

/// Digits of tooth numbers.
const DIGITS: usize = 4;

/// A line for each set with its sizes, then one with its bearings and safeties; without columns that no set
/// has.
pub(crate) fn sizes(sets: &[SetSizes]) -> Records {
    let shown = |columns: &[(&'static str, bool)]| -> Vec<&'static str> {
        columns.iter().filter(|column| column.1).map(|column| column.0).collect()
    };
    let any = |has: fn(&SetSizes) -> bool| sets.iter().any(has);
    let of_sizes = shown(&[
        ("set", true),
        ("teeth", true),
        ("module", true),
        ("face_width", any(|set| !set.face_widths_m.is_empty())),
        ("ring_diameter", any(|set| set.ring_diameter_m.is_some())),
        ("mass", any(|set| set.mass_kg.is_some())),
        ("whole", any(|set| set.whole_kg.is_some())),
    ]);
    let [has_bearings, is_rated] =
        [any(|set| !set.bearings.is_empty()), any(|set| set.flank.is_some() || set.root.is_some())];
    let of_strength = shown(&[
        ("set", true),
        ("load_rating", has_bearings),
        ("bearing_life", has_bearings && any(|set| life(set).is_some())),
        ("flank_safety", is_rated),
        ("flank", is_rated),
        ("root_safety", is_rated),
        ("root", is_rated),
    ]);
    let table = Table::new("sizes", sets.iter())
        .text("set", "set", |set| &set.set)
        .words("teeth", "z", |set| {
            set.teeth.iter().map(|z| trimmed(*z, DIGITS)).collect::<Vec<_>>().join(", ")
        })
        .list("module", "m", Dimension::Length, |set| set.modules_m.clone())
        .list("face_width", "b", Dimension::Length, |set| set.face_widths_m.clone())
        .measured("ring_diameter", "ring Ø", Dimension::Length, 1, |set| set.ring_diameter_m)
        .measured("mass", "gears", Dimension::Mass, 1, |set| set.mass_kg)
        .measured("whole", "whole", Dimension::Mass, 0, |set| set.whole_kg)
        .list("load_rating", "C", Dimension::Force, |set| {
            set.bearings.iter().map(|bearing| bearing.load_rating_n).collect()
        })
        .printed("bearing_life", "L_10, h", 0, |set| life(set).map(hours))
        .for_people()
        .printed("flank_safety", "S_H", 2, |set| set.flank.as_ref().map(|of| of.safety))
        .words("flank", "least of", |set| set.flank.as_ref().map(place))
        .printed("root_safety", "S_F", 2, |set| set.root.as_ref().map(|of| of.safety))
        .words("root", "least of", |set| set.root.as_ref().map(place))
        .view_of("Sizes", &of_sizes)
        .note(masses(sets));
    let table = if of_strength.len() > 1 {
        table.view_of("Bearings of the planets, least safeties", &of_strength)
    } else {
        table
    };
    table.records()
}

/// Least life of the bearings of a set, in s.
fn life(set: &SetSizes) -> Option<f64> {
    set.bearings.iter().filter_map(|bearing| bearing.life_s).reduce(f64::min)
}

/// Gear with the least safety, and the load if it is none of the duty: `planet`, `ring, overload`.
fn place(of: &Governing) -> String {
    match (of.against, &of.gear) {
        (Against::Overload, _) => format!("{}, overload", of.toothed_gear),
        (Against::OperatingPoint, Some(gear)) => format!("{}, gear {gear}", of.toothed_gear),
        _ => of.toothed_gear.clone(),
    }
}

/// Masses of all sets together, and what they contain.
fn masses(sets: &[SetSizes]) -> String {
    let all = |of: fn(&SetSizes) -> Option<f64>| sets.iter().map(of).sum::<Option<f64>>();
    let told = |of: Option<f64>, digits| of.map(|mass| words(Dimension::Mass, mass, digits));
    let together = match (told(all(|set| set.mass_kg), 3), told(all(|set| set.whole_kg), 2)) {
        (Some(gears), Some(whole)) => format!(" Together: gears {gears}, whole about {whole}."),
        (Some(gears), None) => format!(" Together: gears {gears}."),
        _ => String::new(),
    };
    let whole = if sets.iter().any(|set| set.whole_kg.is_some()) {
        " Whole: with carrier and housing by a rule, cheeks of 0.12 and a wall of 0.04 ring diameters; without shafts and seals."
    } else {
        ""
    };
    format!("z: teeth, of a simple set sun, planets, ring. m: module, b: face width.{together}{whole}")
}

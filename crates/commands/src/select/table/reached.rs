//! Speeds asked for and reached, as a table.

use crate::select::answer::reached::ReachedSpeed;
use crate::table::columns::Table;
use crate::table::report::Records;
use epicyclic_units::Dimension;

/// The table of asked and reached speeds; with ratios asked for these first.
pub(crate) fn speeds_reached(speeds: &[ReachedSpeed]) -> Records {
    let of_machine = speeds.iter().any(|one| one.asked_speed_m_s.is_some());
    let of_output = speeds.iter().any(|one| one.output_speed_rad_s.is_some());
    let mut shown = vec!["gear"];
    if of_machine {
        shown.extend(["asked_speed", "reached_speed", "speed_deviation"]);
    }
    shown.extend(["asked_ratio", "reached_ratio"]);
    if !of_machine {
        shown.push("ratio_deviation");
    }
    if of_output {
        shown.extend(["asked_output_speed", "reached_output_speed"]);
    }
    let reversed: Vec<&str> = speeds.iter().filter(|one| one.reversed).map(|one| one.gear.name()).collect();
    let mut note = String::new();
    if of_output {
        note += "n: of the output, rpm.";
    }
    if !reversed.is_empty() {
        let space = if note.is_empty() { "" } else { " " };
        note += &format!(
            "{space}The output turns against the direction asked for in gear {}.",
            reversed.join(" and ")
        );
    }
    Table::new("speeds_reached", speeds.iter())
        .words("gear", "gear", |one| one.gear.name())
        .quantity("asked_speed", "asked", Dimension::Speed, |one| one.asked_speed_m_s)
        .quantity("reached_speed", "reached", Dimension::Speed, |one| one.speed_m_s)
        .number("speed_deviation", "deviation", |one| percent(one.speed_deviation))
        .multiple("asked_ratio", "i asked", |one| one.asked_ratio)
        .multiple("reached_ratio", "i reached", |one| one.ratio)
        .number("ratio_deviation", "deviation", |one| percent(one.ratio_deviation))
        .headed("asked_output_speed", "n asked", Dimension::AngularSpeed, |one| one.asked_output_speed_rad_s)
        .headed("reached_output_speed", "n reached", Dimension::AngularSpeed, |one| one.output_speed_rad_s)
        .view_of(if of_machine { "Speeds asked and reached" } else { "Ratios asked and reached" }, &shown)
        .note(note)
        .records()
}

/// A deviation with its sign, to a hundredth of a per cent.
pub(crate) fn percent(share: f64) -> String {
    let rounded = libm::round(1e4 * share) / 100.0;
    if rounded == 0.0 { "0 %".to_owned() } else { format!("{rounded:+.2} %") }
}

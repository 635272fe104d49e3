//! Speeds asked for and reached, as a table.

use crate::select::answer::reached::ReachedSpeed;
use crate::table::figure::{Figure, text};
use crate::table::quantities::column;
use crate::table::report::{Column, Records, View};
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
    let row = |one: &ReachedSpeed| {
        vec![
            text(one.gear.name()),
            column(Dimension::Speed, one.asked_speed_m_s),
            column(Dimension::Speed, one.speed_m_s),
            text(percent(one.speed_deviation)),
            Figure::Multiple(one.asked_ratio),
            Figure::Multiple(one.ratio),
            text(percent(one.ratio_deviation)),
            column(Dimension::AngularSpeed, one.asked_output_speed_rad_s),
            column(Dimension::AngularSpeed, one.output_speed_rad_s),
        ]
    };
    Records {
        name: "speeds_reached",
        columns: vec![
            Column::words("gear", "gear"),
            Column::headed("asked_speed", "asked, m/s", Dimension::Speed),
            Column::headed("reached_speed", "reached, m/s", Dimension::Speed),
            Column::number("speed_deviation", "deviation"),
            Column::number("asked_ratio", "i asked"),
            Column::number("reached_ratio", "i reached"),
            Column::number("ratio_deviation", "deviation"),
            Column::headed("asked_output_speed", "n asked", Dimension::AngularSpeed),
            Column::headed("reached_output_speed", "n reached", Dimension::AngularSpeed),
        ],
        rows: speeds.iter().map(row).collect(),
        views: vec![View {
            note,
            ..View::new(
                if of_machine { "Speeds asked and reached" } else { "Ratios asked and reached" },
                &shown,
            )
        }],
        is_answer: false,
    }
}

/// A deviation with its sign, to a hundredth of a per cent.
pub(crate) fn percent(share: f64) -> String {
    let rounded = libm::round(1e4 * share) / 100.0;
    if rounded == 0.0 { "0 %".to_owned() } else { format!("{rounded:+.2} %") }
}

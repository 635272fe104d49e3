//! Tooth numbers for a ratio, as tables.

use crate::AsReport;
use crate::figure::Figure;
use crate::report::{Column, Part, Records, Report, Text, View};
use epicyclic_answers::teeth::{Teeth, ToothNumbers};
use epicyclic_formats::Dimension;
use epicyclic_formats::quantity::format::{significant, trimmed};

impl AsReport for Teeth {
    fn report(&self) -> Report {
        let words = format!(
            "Ratio {} ({}: {} to {}, {} at rest), within {} %",
            self.ratio,
            self.mode,
            self.mode.input,
            self.mode.output,
            self.mode.fixed,
            trimmed(100.0 * self.tolerance, 6),
        );
        Report {
            title: Some(words),
            parts: vec![Part::Records(sets(self)), Part::Text(Text::paragraph(count(self)))],
            warnings: None,
        }
    }
}

/// How many were found, how many shown.
#[must_use]
pub fn count(teeth: &Teeth) -> String {
    let sets = if teeth.found == 1 { "set of tooth numbers" } else { "sets of tooth numbers" };
    match teeth.shown {
        shown if shown as u64 == teeth.found => format!("{} {sets}.", teeth.found),
        shown => format!("{} {sets} found, {shown} shown; --limit shows more.", teeth.found),
    }
}

fn sets(teeth: &Teeth) -> Records {
    let mut views = vec![View::new(
        "Tooth numbers",
        &[
            "sun",
            "planet",
            "ring",
            "planets",
            "ratio",
            "exact_ratio",
            "error",
            "most_planets",
            "undercut",
            "spacing",
        ],
    )];
    if teeth.tooth_numbers.iter().any(|set| !set.equal_spacing) {
        views.push(View::new(
            "Angles of the planets in degrees, and imbalance",
            &["sun", "planet", "ring", "planets", "planet_angles", "imbalance"],
        ));
    }
    Records {
        name: "tooth_numbers",
        columns: vec![
            Column::number("sun", "sun"),
            Column::number("planet", "planet"),
            Column::number("ring", "ring"),
            Column::number("planets", "planets"),
            Column::number("ratio", "ratio"),
            Column::number("exact_ratio", "exact"),
            Column::number("ratio_error", "error"),
            Column::number("error", "error, %").for_people(),
            Column::number("most_planets", "most"),
            Column::words("undercut_sun", "undercut sun"),
            Column::words("undercut_planet", "undercut planet"),
            Column::words("undercut", "undercut").for_people(),
            Column::words("equal_spacing", "equal"),
            Column::words("spacing", "spacing").for_people(),
            Column::quantity("planet_angles", Dimension::Angle),
            Column::number("imbalance", "imbalance"),
        ],
        rows: teeth.tooth_numbers.iter().map(row).collect(),
        views,
        is_answer: true,
    }
}

fn row(set: &ToothNumbers) -> Vec<Figure> {
    vec![
        Figure::Count(set.sun),
        Figure::Count(set.planet),
        Figure::Count(set.ring),
        Figure::Count(set.planets),
        Figure::Number(set.ratio),
        Figure::Text(set.exact_ratio.to_string()),
        Figure::Number(set.ratio_error),
        Figure::Text(percent(set.ratio_error)),
        Figure::Count(set.most_planets),
        Figure::YesNo(set.undercut_sun),
        Figure::YesNo(set.undercut_planet),
        Figure::Text(undercut(set).to_owned()),
        Figure::YesNo(set.equal_spacing),
        Figure::Text(if set.equal_spacing { "equal" } else { "unequal" }.to_owned()),
        Figure::List { si: set.planet_angles_rad.clone(), dimension: Dimension::Angle },
        Figure::Number(set.imbalance),
    ]
}

/// `0` where the ratio is exact.
fn percent(error: f64) -> String {
    if error.abs() <= 4.0 * f64::EPSILON {
        return "0".to_owned();
    }
    let sign = if error > 0.0 { "+" } else { "" };
    format!("{sign}{}", significant(100.0 * error, 2))
}

fn undercut(set: &ToothNumbers) -> &'static str {
    match (set.undercut_sun, set.undercut_planet) {
        (true, true) => "sun, planet",
        (true, false) => "sun",
        (false, true) => "planet",
        (false, false) => "-",
    }
}

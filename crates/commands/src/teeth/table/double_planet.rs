//! Double-planet sets for a ratio, as tables.

use super::{count, left_out, parts, percent, title, undercut};
use crate::table::figure::Figure;
use crate::table::report::AsReport;
use crate::table::report::{Column, Records, Report, View};
use crate::teeth::answer::double_planet::{DoublePlanetNumbers, DoublePlanetTeeth};
use epicyclic_units::Dimension;

impl AsReport for DoublePlanetTeeth {
    fn report(&self) -> Report {
        Report {
            title: Some(format!("{}, double-planet sets", title(self.ratio, self.mode, self.tolerance))),
            parts: parts(
                sets(self),
                &self.tooth_checks,
                count(self.found, self.shown) + &left_out(self.left_out.as_ref()),
            ),
            warnings: None,
        }
    }
}

fn sets(teeth: &DoublePlanetTeeth) -> Records {
    let mut views = vec![View {
        note: "Inner planets mesh with the sun, outer ones with the ring. Choices: of planets and pairs that fit sun and ring; \
               shown is the first that passes the checks of the teeth, by the most pairs, then by the most teeth of the smaller planet."
            .to_owned(),
        ..View::new(
            "Tooth numbers",
            &["sun", "inner_planet", "outer_planet", "ring", "pairs", "ratio", "exact_ratio", "error", "choices", "undercut"],
        )
    }];
    if teeth.tooth_numbers.iter().any(|set| !set.equal_spacing) {
        views.push(View::new(
            "Angles of the pairs in degrees, and imbalance",
            &["sun", "inner_planet", "outer_planet", "ring", "pairs", "pair_angles", "imbalance"],
        ));
    }
    Records {
        name: "tooth_numbers",
        columns: vec![
            Column::number("sun", "sun"),
            Column::number("inner_planet", "inner"),
            Column::number("outer_planet", "outer"),
            Column::number("ring", "ring"),
            Column::number("pairs", "pairs"),
            Column::number("ratio", "ratio"),
            Column::number("exact_ratio", "exact"),
            Column::number("ratio_error", "error"),
            Column::number("error", "error, %").for_people(),
            Column::number("choices", "choices"),
            Column::words("undercut_sun", "undercut sun"),
            Column::words("undercut_inner_planet", "undercut inner planet"),
            Column::words("undercut_outer_planet", "undercut outer planet"),
            Column::words("undercut", "undercut").for_people(),
            Column::words("equal_spacing", "equal"),
            Column::quantity("pair_angles", Dimension::Angle),
            Column::number("imbalance", "imbalance"),
        ],
        rows: teeth.tooth_numbers.iter().map(row).collect(),
        views,
        is_answer: true,
    }
}

fn row(set: &DoublePlanetNumbers) -> Vec<Figure> {
    let gears = [
        (set.undercut_sun, "sun"),
        (set.undercut_inner_planet, "inner"),
        (set.undercut_outer_planet, "outer"),
    ];
    vec![
        Figure::Count(set.sun),
        Figure::Count(set.inner_planet),
        Figure::Count(set.outer_planet),
        Figure::Count(set.ring),
        Figure::Count(set.pairs),
        Figure::Number(set.ratio),
        Figure::Text(set.exact_ratio.to_string()),
        Figure::Number(set.ratio_error),
        Figure::Text(percent(set.ratio_error)),
        Figure::Count(u32::try_from(set.choices).unwrap_or(u32::MAX)),
        Figure::YesNo(set.undercut_sun),
        Figure::YesNo(set.undercut_inner_planet),
        Figure::YesNo(set.undercut_outer_planet),
        Figure::Text(undercut(&gears)),
        Figure::YesNo(set.equal_spacing),
        Figure::List { si: set.pair_angles_rad.clone(), dimension: Dimension::Angle },
        Figure::Number(set.imbalance),
    ]
}

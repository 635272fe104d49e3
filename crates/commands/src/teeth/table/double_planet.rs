//! Double-planet sets for a ratio, as tables.

use super::{count, left_out, parts, percent, title, undercut};
use crate::table::columns::Table;
use crate::table::figure::Figure;
use crate::table::report::AsReport;
use crate::table::report::{Records, Report, View};
use crate::teeth::answer::double_planet::DoublePlanetTeeth;
use epicyclic_units::Dimension;

impl AsReport for DoublePlanetTeeth {
    fn report(&self) -> Report {
        Report {
            title: Some(format!("{}, double-planet sets", title(self.ratio, self.mode, self.tolerance))),
            parts: parts(
                sets(self),
                &self.tooth_checks,
                &self.judgement,
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
    Table::new("tooth_numbers", teeth.tooth_numbers.iter())
        .number("sun", "sun", |set| set.sun)
        .number("inner_planet", "inner", |set| set.inner_planet)
        .number("outer_planet", "outer", |set| set.outer_planet)
        .number("ring", "ring", |set| set.ring)
        .number("pairs", "pairs", |set| set.pairs)
        .number("ratio", "ratio", |set| set.ratio)
        .number("exact_ratio", "exact", |set| set.exact_ratio.to_string())
        .number("ratio_error", "error", |set| set.ratio_error)
        .number("error", "error, %", |set| percent(set.ratio_error))
        .for_people()
        .number("choices", "choices", |set| set.choices)
        .words("undercut_sun", "undercut sun", |set| set.undercut_sun)
        .words("undercut_inner_planet", "undercut inner planet", |set| set.undercut_inner_planet)
        .words("undercut_outer_planet", "undercut outer planet", |set| set.undercut_outer_planet)
        .words("undercut", "undercut", |set| {
            let gears = [
                (set.undercut_sun, "sun"),
                (set.undercut_inner_planet, "inner"),
                (set.undercut_outer_planet, "outer"),
            ];
            Figure::Text(undercut(&gears))
        })
        .for_people()
        .words("equal_spacing", "equal", |set| set.equal_spacing)
        .list("pair_angles", "", Dimension::Angle, |set| set.pair_angles_rad.clone())
        .number("imbalance", "imbalance", |set| set.imbalance)
        .views(views)
        .the_answer()
        .records()
}

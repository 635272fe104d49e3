//! Tooth numbers for a ratio, as tables.

mod arranged;
mod double_planet;
pub(crate) mod shifted;

use crate::shared::judgement::answer::Judgement;
use crate::shared::judgement::table as judgement;
use crate::shared::records::Motion;
use crate::shared::tooth_checks::answer::{TeethLeftOut, ToothChecks};
use crate::shared::tooth_checks::table as tooth_checks;
use crate::table::columns::Table;
use crate::table::report::AsReport;
use crate::table::report::{Part, Records, Report, Text, View};
use crate::teeth::answer::{Teeth, USUAL_PLANET_GAP};
use epicyclic_units::Dimension;
use epicyclic_units::format::{significant, trimmed};

impl AsReport for Teeth {
    fn report(&self) -> Report {
        Report {
            title: Some(title(self.ratio, self.mode, self.tolerance)),
            parts: parts(
                sets(self),
                &self.tooth_checks,
                &self.judgement,
                count(self.found, self.shown)
                    + &left_out(self.left_out.as_ref())
                    + &near(self.tooth_numbers.iter().map(|set| set.planet_gap_in_modules)),
            ),
            warnings: None,
        }
    }
}

/// The sets, what does not hold of one of them, and how many there are.
fn parts(sets: Records, checks: &ToothChecks, judged: &Judgement, count: String) -> Vec<Part> {
    let checks = tooth_checks::has_any(checks).then(|| Part::Records(tooth_checks::table(checks)));
    let parts = [Some(Part::Records(sets)), checks, Some(Part::Text(Text::paragraph(count)))];
    parts.into_iter().flatten().chain(judgement::parts(judged)).collect()
}

/// What is wanted.
fn title(ratio: f64, mode: Motion, tolerance: f64) -> String {
    format!(
        "Ratio {ratio} ({mode}: {} to {}, {} at rest), within {} %",
        mode.input,
        mode.output,
        mode.fixed,
        trimmed(100.0 * tolerance, 6),
    )
}

/// How many were found, how many shown.
#[must_use]
pub fn count(found: u64, shown: usize) -> String {
    let sets = if found == 1 { "set of tooth numbers" } else { "sets of tooth numbers" };
    if shown as u64 == found {
        format!("{found} {sets}.")
    } else {
        format!("{found} {sets} found, {shown} shown; --limit shows more.")
    }
}

/// A sentence about sets that a check of their teeth leaves out; empty if there are none.
pub(crate) fn left_out(of: Option<&TeethLeftOut>) -> String {
    of.map(|of| format!(" Besides, {}.", of.message)).unwrap_or_default()
}

/// A sentence about sets whose planets are too near to each other; empty if there are none.
fn near(gaps: impl Iterator<Item = f64>) -> String {
    let sets = match gaps.filter(|gap| *gap < USUAL_PLANET_GAP).count() {
        0 => return String::new(),
        1 => "1 set".to_owned(),
        all => format!("{all} sets"),
    };
    format!(
        " Planets of {sets} shown have less than {USUAL_PLANET_GAP} modules between their tips, which practice leaves for pitch and runout; \
         --tip-gap {USUAL_PLANET_GAP} leaves such out."
    )
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
            "planet_gap_in_modules",
            "undercut",
        ],
    )];
    if teeth.tooth_numbers.iter().any(|set| !set.equal_spacing) {
        views.push(View::new(
            "Angles of the planets in degrees, and imbalance",
            &["sun", "planet", "ring", "planets", "spacing", "planet_angles", "imbalance"],
        ));
    }
    Table::new("tooth_numbers", teeth.tooth_numbers.iter())
        .number("sun", "sun", |set| set.sun)
        .number("planet", "planet", |set| set.planet)
        .number("ring", "ring", |set| set.ring)
        .number("planets", "planets", |set| set.planets)
        .number("ratio", "ratio", |set| set.ratio)
        .number("exact_ratio", "exact", |set| set.exact_ratio.to_string())
        .number("ratio_error", "error", |set| set.ratio_error)
        .number("error", "error, %", |set| percent(set.ratio_error))
        .for_people()
        .number("most_planets", "most", |set| set.most_planets)
        .words("undercut_sun", "undercut sun", |set| set.undercut_sun)
        .words("undercut_planet", "undercut planet", |set| set.undercut_planet)
        .words("undercut", "undercut", |set| {
            undercut(&[(set.undercut_sun, "sun"), (set.undercut_planet, "planet")])
        })
        .for_people()
        .words("equal_spacing", "equal", |set| set.equal_spacing)
        .words("spacing", "spacing", |set| spacing(set.equal_spacing).to_owned())
        .for_people()
        .printed("planet_gap_in_modules", "gap", 3, |set| set.planet_gap_in_modules)
        .list("planet_angles", "", Dimension::Angle, |set| set.planet_angles_rad.clone())
        .number("imbalance", "imbalance", |set| set.imbalance)
        .views(views)
        .the_answer()
        .records()
}

fn spacing(is_equal: bool) -> &'static str {
    if is_equal { "equal" } else { "unequal" }
}

/// `0` where the ratio is exact.
fn percent(error: f64) -> String {
    if error.abs() <= 4.0 * f64::EPSILON {
        return "0".to_owned();
    }
    let sign = if error > 0.0 { "+" } else { "" };
    format!("{sign}{}", significant(100.0 * error, 2))
}

/// The gears that are undercut.
fn undercut(gears: &[(bool, &str)]) -> String {
    let all: Vec<&str> =
        gears.iter().filter(|(is_undercut, _)| *is_undercut).map(|(_, name)| *name).collect();
    if all.is_empty() { "-".to_owned() } else { all.join(", ") }
}

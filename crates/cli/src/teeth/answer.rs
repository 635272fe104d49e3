//! Tooth sets as tables, JSON and CSV.

use crate::failure::Failure;
use crate::output::{self, Format};
use epicyclic_formats::quantity::format::{significant, trimmed};
use epicyclic_gears::simple_set::Mode;
use epicyclic_gears::synthesis::Candidate;
use serde::Serialize;
use uom::si::angle::{degree, radian};

/// The tooth sets found for a ratio.
pub(super) struct Answer<'a> {
    /// The ratio wanted.
    pub(super) ratio: f64,
    /// Its mode.
    pub(super) mode: Mode,
    /// Its relative tolerance.
    pub(super) tolerance: f64,
    /// How many sets there are.
    pub(super) found: u64,
    /// Those to be shown.
    pub(super) shown: &'a [Candidate],
}

/// A mode in words: `sun to carrier, ring at rest`.
pub(super) fn in_words(mode: Mode) -> String {
    format!("{} to {}, {} at rest", mode.input(), mode.output(), mode.fixed())
}

impl Answer<'_> {
    pub(super) fn text(&self, format: Format) -> Result<String, Failure> {
        let is_finite = |set: &Candidate| set.ratio.is_finite() && set.ratio_error.is_finite();
        if let Some(set) = self.shown.iter().find(|set| !is_finite(set)) {
            let figure = format!("ratio_error of the tooth set {}", counts(set).join(" "));
            return Err(Failure::NotFinite { figure });
        }
        match format {
            Format::Table => Ok(self.table()),
            Format::Json => output::json(&self.json()),
            Format::Csv => self.csv(),
        }
    }

    /// How many were found, how many shown.
    pub(super) fn count(&self) -> String {
        let sets = if self.found == 1 { "set" } else { "sets" };
        match self.shown.len() {
            shown if shown as u64 == self.found => format!("{} tooth {sets}.", self.found),
            shown => format!("{} tooth {sets} found, {shown} shown; --limit shows more.", self.found),
        }
    }

    fn table(&self) -> String {
        let header =
            ["sun", "planet", "ring", "planets", "ratio", "exact", "error, %", "most", "undercut", "spacing"];
        let rows = self.shown.iter().map(|set| {
            let mut row = counts(set);
            row.extend([
                trimmed(set.ratio, 6),
                set.exact_ratio.to_string(),
                percent(set.ratio_error),
                set.most_planets.to_string(),
                undercut(set).to_owned(),
                if set.spacing.is_equal() { "equal" } else { "unequal" }.to_owned(),
            ]);
            row
        });
        format!(
            "Ratio {} ({}: {}), within {} %\n\n{}\n{}{}\n",
            self.ratio,
            self.mode,
            in_words(self.mode),
            trimmed(100.0 * self.tolerance, 6),
            output::table(&header, rows, &[0, 1, 2, 3, 4, 5, 6, 7]),
            self.unequal_table(),
            self.count(),
        )
    }

    /// Where the planets stand that do not assemble at equal angles.
    fn unequal_table(&self) -> String {
        let unequal = self.shown.iter().filter(|set| !set.spacing.is_equal());
        let rows: Vec<Vec<String>> = unequal
            .map(|set| {
                let angles: Vec<String> =
                    angles(set).map(|angle| format!("{:.2}", angle.get::<degree>())).collect();
                let mut row = counts(set);
                row.extend([angles.join(" "), trimmed(imbalance(set), 3)]);
                row
            })
            .collect();
        if rows.is_empty() {
            return String::new();
        }
        let header = ["sun", "planet", "ring", "planets", "angles, degrees", "imbalance"];
        format!("Unequal spacing\n{}\n", output::table(&header, rows, &[0, 1, 2, 3, 5]))
    }

    fn json(&self) -> Json {
        Json {
            ratio: self.ratio,
            mode: self.mode.to_string(),
            tolerance: self.tolerance,
            found: self.found,
            shown: self.shown.len(),
            tooth_sets: self.shown.iter().map(JsonSet::new).collect(),
        }
    }

    fn csv(&self) -> Result<String, Failure> {
        let header = [
            "sun",
            "planet",
            "ring",
            "planets",
            "ratio",
            "exact_ratio",
            "ratio_error",
            "most_planets",
            "undercut_sun",
            "undercut_planet",
            "equal_spacing",
            "planet_angles_deg",
            "imbalance",
        ];
        let rows = self.shown.iter().map(|set| {
            let angles: Vec<String> = angles(set).map(|angle| trimmed(angle.get::<degree>(), 10)).collect();
            let mut row = counts(set);
            row.extend([
                set.ratio.to_string(),
                set.exact_ratio.to_string(),
                set.ratio_error.to_string(),
                set.most_planets.to_string(),
                set.undercut_sun.to_string(),
                set.undercut_planet.to_string(),
                set.spacing.is_equal().to_string(),
                angles.join(" "),
                imbalance(set).to_string(),
            ]);
            row
        });
        output::csv(&header, rows)
    }
}

#[derive(Serialize)]
struct Json {
    ratio: f64,
    mode: String,
    tolerance: f64,
    found: u64,
    shown: usize,
    tooth_sets: Vec<JsonSet>,
}

#[derive(Serialize)]
struct JsonSet {
    sun: u32,
    planet: u32,
    ring: u32,
    planets: u32,
    ratio: f64,
    exact_ratio: String,
    ratio_error: f64,
    most_planets: u32,
    undercut_sun: bool,
    undercut_planet: bool,
    equal_spacing: bool,
    planet_angles_rad: Vec<f64>,
    imbalance: f64,
}

impl JsonSet {
    fn new(set: &Candidate) -> Self {
        Self {
            sun: set.teeth.sun.get(),
            planet: set.teeth.planet.get(),
            ring: set.teeth.ring.get(),
            planets: set.teeth.planets,
            ratio: set.ratio,
            exact_ratio: set.exact_ratio.to_string(),
            ratio_error: set.ratio_error,
            most_planets: set.most_planets,
            undercut_sun: set.undercut_sun,
            undercut_planet: set.undercut_planet,
            equal_spacing: set.spacing.is_equal(),
            planet_angles_rad: angles(set).map(|angle| angle.get::<radian>()).collect(),
            imbalance: imbalance(set),
        }
    }
}

fn angles(set: &Candidate) -> impl Iterator<Item = uom::si::f64::Angle> {
    set.spacing.angles().into_iter()
}

/// Distance of the planets' common centre of mass from the axis over the radius of their centres; exactly 0 where
/// the rounding of the angles is all there is.
fn imbalance(set: &Candidate) -> f64 {
    let imbalance = set.spacing.imbalance();
    if imbalance < 1e-12 { 0.0 } else { imbalance }
}

fn counts(set: &Candidate) -> Vec<String> {
    let teeth = &set.teeth;
    [teeth.sun.get(), teeth.planet.get(), teeth.ring.get(), teeth.planets]
        .map(|count| count.to_string())
        .into()
}

/// `0` where the ratio is exact.
fn percent(error: f64) -> String {
    if error.abs() <= 4.0 * f64::EPSILON {
        return "0".to_owned();
    }
    let sign = if error > 0.0 { "+" } else { "" };
    format!("{sign}{}", significant(100.0 * error, 2))
}

fn undercut(set: &Candidate) -> &'static str {
    match (set.undercut_sun, set.undercut_planet) {
        (true, true) => "sun, planet",
        (true, false) => "sun",
        (false, true) => "planet",
        (false, false) => "-",
    }
}

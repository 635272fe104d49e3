//! Stages in series, asked and reached, with what came next.

use crate::design::answer::stages::{Stages, TrainOfStages, TrainsOf};
use crate::design::table::{ASSUMED, DIGITS, assumed, masses, of_sizes, parts_of_sizes};
use crate::select::table::percent;
use crate::size::table::basis;
use crate::table::columns::Table;
use crate::table::figure::{Figure, text};
use crate::table::quantities::quantity;
use crate::table::report::{AsReport, Part, Records, Report, Row, Section, warned};
use epicyclic_units::Dimension;
use epicyclic_units::format::trimmed;

impl AsReport for Stages {
    fn report(&self) -> Report {
        let mut parts = parts_of_stages(self);
        parts.extend(self.sizes.iter().flat_map(parts_of_sizes));
        Report { title: Some(in_short(self)), parts, warnings: warned(&self.warnings) }
    }
}

/// Ratio and speeds asked and reached, the trains, and assumed values.
pub(crate) fn parts_of_stages(stages: &Stages) -> Vec<Part> {
    let mut parts = vec![
        Part::Facts(asked(stages)),
        Part::Records(trains(&stages.trains)),
        Part::Records(searched(stages)),
    ];
    parts.extend(stages.masses.as_ref().map(|of| Part::Facts(masses(of))));
    parts.push(Part::Records(basis(&stages.basis, &format!("{ASSUMED}, --efficiency"))));
    parts.push(Part::Records(assumed(&stages.assumed)));
    parts
}

/// The train with its ratio, ring, mass, least safeties and life.
pub(crate) fn in_short(stages: &Stages) -> String {
    let asked = format!("{} ± {} %", of_ratio(stages.asked_ratio), trimmed(100.0 * stages.tolerance, DIGITS));
    let (Some(ratio), Some(sizes)) = (stages.ratio, &stages.sizes) else {
        return format!("No stages with i = {asked} that hold were found.");
    };
    let count = match sizes.sets.len() {
        1 => "1 stage".to_owned(),
        stages => format!("{stages} stages"),
    };
    let mut all = vec![format!("{count}, i = {} (asked {asked})", of_ratio(ratio))];
    all.extend(stages.efficiency.map(|of| format!("η = {}", trimmed(of, 3))));
    all.extend(of_sizes(sizes, stages.masses.as_ref()));
    format!("{}.", all.join(", "))
}

/// A ratio, of a train that steps up as 1/99.2.
fn of_ratio(ratio: f64) -> String {
    if ratio < 1.0 { format!("1/{}", trimmed(1.0 / ratio, DIGITS)) } else { trimmed(ratio, DIGITS) }
}

fn asked(stages: &Stages) -> Section {
    let of = |dimension, value: Option<f64>| value.map_or(Figure::None, |value| quantity(dimension, value));
    // The load is asked for at one of both shafts.
    let is_of_input = stages.asked_output_torque_n_m.is_none();
    let of_input = |name, label, symbol, dimension, value: Option<f64>| {
        let asked = of(dimension, value.filter(|_| is_of_input));
        Row::new(name, label, symbol, [asked, of(dimension, value), Figure::None])
    };
    let deviation = stages.ratio.map(|ratio| percent(ratio / stages.asked_ratio - 1.0));
    let rows = vec![
        Row::new(
            "ratio",
            "ratio",
            "i",
            [
                Figure::Number(stages.asked_ratio),
                stages.ratio.map_or(Figure::None, Figure::Number),
                deviation.map_or(Figure::None, text),
            ],
        ),
        Row::new(
            "output_speed",
            "speed of the output",
            "n",
            [
                quantity(Dimension::AngularSpeed, stages.asked_output_speed_rad_s),
                of(Dimension::AngularSpeed, stages.output_speed_rad_s),
                Figure::None,
            ],
        ),
        Row::new(
            "output_torque",
            "torque on the output, with losses",
            "T",
            [
                of(Dimension::Torque, stages.asked_output_torque_n_m),
                of(Dimension::Torque, stages.output_torque_n_m),
                Figure::None,
            ],
        ),
        Row::new(
            "efficiency",
            "efficiency of all meshes",
            "η",
            [Figure::None, stages.efficiency.map_or(Figure::None, Figure::Number), Figure::None],
        ),
        Row::new(
            "back_driving_efficiency",
            "efficiency, driven by the output",
            "η back",
            [Figure::None, stages.back_driving_efficiency.map_or(Figure::None, Figure::Number), Figure::None],
        ),
        of_input("input_torque", "torque on the input", "T_in", Dimension::Torque, stages.input_torque_n_m),
        of_input("input_power", "power into the input", "P", Dimension::Power, stages.input_power_w),
    ];
    const COLUMNS: &[(&str, &str)] =
        &[("asked", "asked"), ("reached", "reached"), ("deviation", "deviation")];
    Section { name: "asked_and_reached", title: "Asked and reached", columns: COLUMNS, rows, note: "" }
}

/// Teeth of sun, planet and ring of each stage.
fn teeth(train: &TrainOfStages) -> String {
    let all: Vec<String> =
        train.teeth.iter().map(|[sun, planet, ring]| format!("{sun} {planet} {ring}")).collect();
    all.join(" + ")
}

fn trains(all: &[TrainsOf]) -> Records {
    let rows = all.iter().flat_map(|of| [(of, of.best.as_ref(), true), (of, of.next.as_ref(), false)]);
    // A second line only where there is a second train.
    let rows: Vec<_> = rows.filter(|(_, train, is_best)| *is_best || train.is_some()).collect();
    Table::new("trains", rows)
        .number("stages", "stages", |(of, ..)| of.stages as f64)
        .words("taken", "", |(of, _, is_best)| (of.taken && *is_best).then_some("taken"))
        .words("teeth", "sun, planet, ring", |(of, train, _)| match train {
            Some(train) => teeth(train),
            None if of.compared == 0 => "no teeth give the ratio".to_owned(),
            None => "none holds".to_owned(),
        })
        .number("ratio", "i", |(_, train, _)| train.map(|train| train.ratio))
        .quantity("mass", "mass", Dimension::Mass, |(_, train, _)| train.map(|train| train.mass_kg))
        .number("rules_missed", "rules missed", |(_, train, _)| train.map(|train| f64::from(train.rules_missed)))
        .view("The best trains of each number of stages", "stages taken teeth ratio mass rules_missed")
        .note(
            "Trains that keep to usual practice come first, then less mass, of which each rule missed counts a quarter: \
             of gears, carriers and housing by a rule, or what --minimise says. Slow shaft and flanges are not in this \
             mass. --stages decides otherwise.",
        )
        .the_answer()
        .records()
}

fn searched(stages: &Stages) -> Records {
    Table::new("searched", stages.trains.iter())
        .number("stages", "stages", |of| of.stages as f64)
        .number("compared", "trains", |of| of.compared as f64)
        .number("sized", "stages sized", |of| of.sized as f64)
        .words("complete", "all compared", |of| if of.complete { "yes" } else { "no" })
        .view("How they were found", "stages compared sized complete")
        .note("trains: within the part of the tolerance that gave any. A stage is sized only where a bound below its mass leaves it a chance.")
        .records()
}

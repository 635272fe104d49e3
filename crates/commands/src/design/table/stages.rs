//! Stages in series, asked and reached, with what came next.

use crate::design::answer::stages::{Stages, TrainOfStages, TrainsOf};
use crate::design::table::{ASSUMED, DIGITS, parts_of_sizes};
use crate::select::table::percent;
use crate::size::answer::records::SizedDesign;
use crate::size::table::basis;
use crate::table::columns::Table;
use crate::table::figure::{Figure, hours, text};
use crate::table::quantities::{quantity, words};
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
    vec![
        Part::Facts(asked(stages)),
        Part::Records(trains(&stages.trains)),
        Part::Records(searched(stages)),
        Part::Records(basis(&stages.basis, &format!("{ASSUMED}, --efficiency"))),
    ]
}

/// The train with its ratio, ring, mass, least safeties and life.
pub(crate) fn in_short(stages: &Stages) -> String {
    let asked =
        format!("{} ± {} %", trimmed(stages.asked_ratio, DIGITS), trimmed(100.0 * stages.tolerance, DIGITS));
    let (Some(ratio), Some(sizes)) = (stages.ratio, &stages.sizes) else {
        return format!("No stages with i = {asked} that hold were found.");
    };
    let found: Vec<&SizedDesign> = sizes.sets.iter().filter_map(|set| set.found.first()).collect();
    let count = if found.len() == 1 { "1 stage".to_owned() } else { format!("{} stages", found.len()) };
    let mut all = vec![format!("{count}, i = {} (asked {asked})", trimmed(ratio, DIGITS))];
    let rings = found.iter().filter_map(|design| design.ring_diameter_m);
    all.extend(rings.reduce(f64::max).map(|ring| format!("ring {}", words(Dimension::Length, ring, DIGITS))));
    all.extend(sizes.mass_kg.map(|mass| format!("gears {}", words(Dimension::Mass, mass, 3))));
    all.extend(sizes.whole_kg.map(|mass| format!("whole about {}", words(Dimension::Mass, mass, 2))));
    let gears = || found.iter().flat_map(|design| &design.over_duty);
    let least = |values: &mut dyn Iterator<Item = f64>| values.reduce(f64::min);
    all.extend(
        least(&mut gears().map(|gear| gear.flank.safety)).map(|of| format!("least S_H {}", trimmed(of, 3))),
    );
    all.extend(least(&mut gears().map(|gear| gear.root.safety)).map(|of| format!("S_F {}", trimmed(of, 3))));
    let bearings =
        found.iter().flat_map(|design| &design.planet_sizes).filter_map(|planet| planet.bearing.as_ref());
    let life = least(&mut bearings.filter_map(|bearing| bearing.life_s));
    all.extend(life.map(|life| format!("L_10 {} h", trimmed(hours(life), 3))));
    format!("{}.", all.join(", "))
}

fn asked(stages: &Stages) -> Section {
    let of = |dimension, value: Option<f64>| value.map_or(Figure::None, |value| quantity(dimension, value));
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
            "torque on the output, without losses",
            "T",
            [Figure::None, of(Dimension::Torque, stages.output_torque_n_m), Figure::None],
        ),
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
             of gears, carriers and housing by a rule, or what --minimise says. --stages decides otherwise.",
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

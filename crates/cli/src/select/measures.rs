//! What every list of designs says of each: ratios, row parameters, efficiencies, objectives.

use epicyclic_formats::Dimension;
use epicyclic_selection::{GearReport, Objectives, Requirements};
use epicyclic_views::figure::{Figure, column, multiple};
use epicyclic_views::report::Column;

/// The columns.
pub(super) fn columns() -> Vec<Column> {
    vec![
        Column::number("ratio_1", "i₁"),
        Column::number("ratio_2", "i₂"),
        Column::number("k1", "k₁"),
        Column::number("k2", "k₂"),
        Column::number("efficiency_1", "η₁"),
        Column::number("efficiency_2", "η₂"),
        Column::number("efficiency", "efficiency"),
        Column::number("speed", "speed"),
        Column::number("parameter", "parameter"),
        Column::number("error", "error"),
        Column::number("size", "size"),
        Column { heading: "ring, mm".to_owned(), ..Column::quantity("ring_diameter", Dimension::Length) },
    ]
}

/// The same of one design; a single row has no second gear and no second `k`.
pub(super) fn figures(
    requirements: &Requirements,
    gears: &[GearReport],
    k: &[f64],
    objectives: &Objectives,
) -> Vec<Figure> {
    let of_gear = |gear: usize, of: fn(&GearReport) -> Option<f64>| multiple(gears.get(gear).and_then(of));
    vec![
        of_gear(0, |gear| Some(gear.ratio)),
        of_gear(1, |gear| Some(gear.ratio)),
        multiple(k.first().copied()),
        multiple(k.get(1).copied()),
        of_gear(0, |gear| gear.efficiency),
        of_gear(1, |gear| gear.efficiency),
        Figure::Multiple(objectives.efficiency),
        Figure::Multiple(objectives.speed),
        Figure::Multiple(objectives.ring_to_sun),
        Figure::Multiple(objectives.ratio_error),
        Figure::Multiple(objectives.size),
        column(requirements.rating.unit().map(|unit| unit * objectives.size)),
    ]
}

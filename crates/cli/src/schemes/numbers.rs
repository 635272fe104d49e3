//! A scheme with its row parameters: what each gear does.

use super::{Dimensioned, Scheme};
use crate::analyze::fast_planets;
use crate::failure::Failure;
use epicyclic_formats::quantity::format::trimmed;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_schemes::catalogue::RingToSunRange;
use epicyclic_train::Analysis;
use epicyclic_views::figure::{Figure, multiple, text};
use epicyclic_views::report::{Column, Part, Records, Row, Section, View};

/// Parts of an answer, and what to watch.
pub(super) struct Found {
    pub(super) parts: Vec<Part>,
    pub(super) warnings: Vec<(&'static str, String)>,
}

/// Ratios, efficiencies, torques and speeds.
pub(super) fn parts(
    scheme: Scheme,
    dimensioned: &Dimensioned,
    eta0: MeshEfficiency,
) -> Result<Found, Failure> {
    let gearbox = &dimensioned.gearbox;
    let gears: Vec<Analysis> =
        gearbox.gears().iter().map(|gear| gearbox.analyze(gear.name())).collect::<Result<_, _>>()?;
    let parts = vec![
        Part::Facts(parameters(dimensioned, eta0)),
        Part::Records(results(dimensioned, &gears)),
        Part::Records(speeds(scheme, &gears)),
    ];
    Ok(Found { parts, warnings: warnings(dimensioned, &gears) })
}

fn parameters(dimensioned: &Dimensioned, eta0: MeshEfficiency) -> Section {
    let names = [("k1", "row parameter of row 1", "k₁"), ("k2", "of row 2", "k₂")];
    let mut rows: Vec<Row> = names
        .into_iter()
        .zip(&dimensioned.k)
        .map(|((name, label, symbol), k)| Row::new(name, label, symbol, [Figure::Multiple(k.get())]))
        .collect();
    rows.push(Row::new(
        "row_efficiency",
        "efficiency of a row, carrier at rest",
        "η₀",
        [Figure::Multiple(eta0.get())],
    ));
    Section { name: "parameters", title: "Parameters", columns: &[], rows, note: "" }
}

fn results(dimensioned: &Dimensioned, gears: &[Analysis<'_>]) -> Records {
    let shift_elements = dimensioned.gearbox.shift_elements();
    let row = |gear: &Analysis<'_>| {
        let engaged = gear.gear().engaged().first().copied();
        let torque = gear.driving().zip(engaged).and_then(|(case, place)| case.shift_elements[place]);
        vec![
            text(gear.gear().name()),
            multiple(gear.ratio()),
            multiple(gear.efficiency()),
            multiple(gear.back_driving_efficiency()),
            multiple(gear.driving().map(|case| case.output)),
            text(engaged.map_or("-", |place| shift_elements[place].id())),
            multiple(torque),
            multiple(gear.driving().map(|case| case.power.circulating)),
        ]
    };
    Records {
        name: "gears",
        columns: vec![
            Column::words("gear", "gear"),
            Column::number("ratio", "i"),
            Column::number("efficiency", "η"),
            Column::number("overrun_efficiency", "η overrun"),
            Column::number("output_torque_of_input", "T_B"),
            Column::words("engaged", "engaged"),
            Column::number("control_torque_of_input", "its T"),
            Column::number("circulating", "circulating"),
        ],
        rows: gears.iter().map(row).collect(),
        views: vec![View {
            note: "Torques, with losses, over the input's; L locks D to B.".to_owned(),
            ..View::new(
                "Gears",
                &[
                    "gear",
                    "ratio",
                    "efficiency",
                    "overrun_efficiency",
                    "output_torque_of_input",
                    "engaged",
                    "control_torque_of_input",
                    "circulating",
                ],
            )
        }],
        is_answer: false,
    }
}

/// As the source's tables 3.1 and 3.2 have them.
fn speeds(scheme: Scheme, gears: &[Analysis<'_>]) -> Records {
    let mut rows = vec![];
    for (place, links) in scheme.sets().iter().enumerate() {
        for (member, (symbol, role)) in ["a", "b", "H"].into_iter().zip(links).enumerate() {
            let of = |gear: &Analysis<'_>| gear.sets()[place].members[member];
            rows.push(line(format!("{symbol}{}", place + 1), role.symbol(), gears, of));
        }
        let planet = |gear: &Analysis<'_>| gear.sets()[place].planets.first().copied().flatten();
        let absolute = |gear: &Analysis<'_>| planet(gear).and_then(|planet| planet.absolute);
        rows.push(line(format!("g{}", place + 1), "", gears, absolute));
        let relative = |gear: &Analysis<'_>| planet(gear).map(|planet| planet.relative);
        rows.push(line(format!("g{0} on H{0}", place + 1), "", gears, relative));
    }
    let mut columns = vec![Column::words("member", "member"), Column::words("link", "link")];
    let names: Vec<&'static str> =
        if gears.len() == 3 { vec!["gear_1", "gear_2", "direct"] } else { vec!["gear_1", "direct"] };
    columns.extend(names.iter().map(|name| Column::number(name, name.replace('_', " "))));
    let shown: Vec<&'static str> = ["member", "link"].into_iter().chain(names).collect();
    Records {
        name: "speeds",
        columns,
        rows,
        views: vec![View::new("Speeds over the input's; g planet", &shown)],
        is_answer: false,
    }
}

fn line(name: String, link: &str, gears: &[Analysis], of: impl Fn(&Analysis) -> Option<f64>) -> Vec<Figure> {
    [Figure::Text(name), text(link)].into_iter().chain(gears.iter().map(|gear| multiple(of(gear)))).collect()
}

/// What section 3.1 of the source would object to.
fn warnings(dimensioned: &Dimensioned, gears: &[Analysis<'_>]) -> Vec<(&'static str, String)> {
    let mut all = vec![];
    let recommended = RingToSunRange::RECOMMENDED;
    for (place, k) in dimensioned.k.iter().enumerate().filter(|(_, k)| !recommended.contains(**k)) {
        let (row, k) = (place + 1, trimmed(k.get(), 5));
        let (low, high) = (recommended.low(), recommended.high());
        all.push(("row-parameter", format!("k{row} = {k} is outside {low} to {high}")));
    }
    all.extend(gears.iter().flat_map(|gear| fast_planets(&dimensioned.gearbox, gear)));
    let negative: Vec<&str> = gears
        .iter()
        .filter(|gear| gear.ratio().is_some_and(|ratio| ratio < 0.0))
        .map(|gear| gear.gear().name())
        .collect();
    if !negative.is_empty() {
        let gears = format!("gear{} {}", if negative.len() > 1 { "s" } else { "" }, negative.join(" and "));
        all.push(("mixed-signs", format!("the output reverses between direct drive and {gears}")));
    }
    all
}

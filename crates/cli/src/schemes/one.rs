//! One scheme: links, formulas, ranges.

use super::{Dimensioned, Scheme, formulas, numbers};
use crate::failure::Failure;
use epicyclic_formats::quantity::format::trimmed;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_schemes::catalogue::{RingToSunRange, Role};
use epicyclic_views::figure::{Figure, text};
use epicyclic_views::report::{Column, Part, Records, Report, Row, Section, View};

/// The whole answer.
pub(super) fn report(
    scheme: Scheme,
    range: RingToSunRange,
    eta0: MeshEfficiency,
    dimensioned: Option<&Dimensioned>,
) -> Result<Report, Failure> {
    let mut parts = vec![Part::Facts(structure(scheme)), Part::Records(gears(scheme, range))];
    let mut warnings = None;
    if let Some(dimensioned) = dimensioned {
        let found = numbers::parts(scheme, dimensioned, eta0)?;
        parts.extend(found.parts);
        warnings = Some(found.warnings);
    }
    Ok(Report { title: Some(format!("Scheme {}", scheme.name())), parts, warnings })
}

fn structure(scheme: Scheme) -> Section {
    let links = |row: &[Role; 3]| {
        Figure::Texts(
            row.iter().zip(["a", "b", "H"]).map(|(role, member)| format!("{member}={role}")).collect(),
        )
    };
    let mut rows = vec![];
    let labels = [("row_1", "row 1: sun a, ring b, carrier H"), ("row_2", "row 2")];
    for ((name, label), row) in labels.into_iter().zip(&scheme.sets()) {
        rows.push(Row::new(name, label, "", [links(row)]));
    }
    if let Scheme::Three(three) = scheme {
        let connection = three.connection();
        let words = format!("row 2 ties T1 to {} by i_{}", connection.shaft().role(), connection.mode());
        rows.push(Row::new("closing", "in gear 2", "", [text(words)]));
    }
    Section { name: "structure", title: "Structure", columns: &[], rows, note: "" }
}

fn gears(scheme: Scheme, range: RingToSunRange) -> Records {
    let of = |gear: &str, brake: &str, scheme: Scheme| {
        let [least, greatest] = scheme.ratio_range(range);
        vec![
            text(gear),
            text(brake),
            text(formulas::ratio(scheme)),
            text(formulas::efficiency(scheme)),
            Figure::Multiple(least),
            Figure::Multiple(greatest),
        ]
    };
    let mut rows = vec![of("1", "T1", Scheme::Two(scheme.first()))];
    if matches!(scheme, Scheme::Three(_)) {
        rows.push(of("2", "T2", scheme));
    }
    rows.push(vec![
        text("direct"),
        text("-"),
        text("1"),
        text("1"),
        Figure::Multiple(1.0),
        Figure::Multiple(1.0),
    ]);
    let span = format!("for k from {} to {}", trimmed(range.low(), 5), trimmed(range.high(), 5));
    Records {
        name: "formulas",
        columns: vec![
            Column::words("gear", "gear"),
            Column::words("brake", "brake"),
            Column::words("ratio_formula", "i"),
            Column::words("efficiency_formula", "η"),
            Column::number("least_ratio", "from"),
            Column::number("greatest_ratio", "to"),
        ],
        rows,
        views: vec![
            View::new(
                format!("Ratios, {span}"),
                &["gear", "brake", "ratio_formula", "least_ratio", "greatest_ratio"],
            ),
            View::new("Efficiencies", &["gear", "efficiency_formula"]),
        ],
        is_answer: false,
    }
}

//! The whole catalogue.

use super::{Scheme, formulas};
use epicyclic_formats::quantity::format::trimmed;
use epicyclic_schemes::catalogue::{RingToSunRange, Role};
use epicyclic_views::figure::{Figure, text};
use epicyclic_views::report::{Column, Part, Records, Report, View};

/// All schemes over a range of row parameters.
pub(super) fn report(range: RingToSunRange) -> Report {
    let title = format!("Schemes; k from {} to {}", trimmed(range.low(), 5), trimmed(range.high(), 5));
    let note = "a sun, b ring, H carrier: the shafts D and B, or the brakes T1 and T2 that they belong to. i: ratio \
                of gear 1 of I, II, III, of gear 2 of the others, whose gear 1 is that of I, II or III. Gear 3 is \
                direct drive.";
    let records = Records {
        name: "schemes",
        columns: vec![
            Column::words("scheme", "scheme"),
            Column::words("row_1", "a₁ b₁ H₁"),
            Column::words("row_2", "a₂ b₂ H₂"),
            Column::words("ratio_formula", "i"),
            Column::words("efficiency_formula", "η"),
            Column::number("least_ratio", "from"),
            Column::number("greatest_ratio", "to"),
        ],
        rows: Scheme::all().map(|scheme| row(scheme, range)).collect(),
        views: vec![
            View {
                note: note.to_owned(),
                ..View::new(
                    "Links and ratios",
                    &["scheme", "row_1", "row_2", "ratio_formula", "least_ratio", "greatest_ratio"],
                )
            },
            View::new("Efficiency of the same gear", &["scheme", "efficiency_formula"]),
        ],
        is_answer: true,
    };
    Report { title: Some(title), parts: vec![Part::Records(records)], warnings: None }
}

fn row(scheme: Scheme, range: RingToSunRange) -> Vec<Figure> {
    let sets = scheme.sets();
    let links = |set: Option<&[Role; 3]>| {
        Figure::Texts(set.into_iter().flatten().map(|role| role.symbol().to_owned()).collect())
    };
    let [least, greatest] = scheme.ratio_range(range);
    vec![
        text(scheme.name()),
        links(sets.first()),
        links(sets.get(1)),
        text(formulas::ratio(scheme)),
        text(formulas::efficiency(scheme)),
        Figure::Multiple(least),
        Figure::Multiple(greatest),
    ]
}

//! Ratios for given speeds.

use super::list::in_words;
use epicyclic_schemes::DesignError;
use epicyclic_schemes::machines::recommended_speeds;
use epicyclic_schemes::ratio_series::{PrintedSeries, RatioSeries, Regime, step};
use epicyclic_views::figure::{Figure, text};
use epicyclic_views::report::{Column, Part, Records, Report, Row, Section, View};
use uom::si::f64::Velocity;

/// How far members of a printed series may be off and still count as the right ones.
const SAME: f64 = 1e-9;

/// The whole answer, for speeds the slowest first.
pub(super) fn report(speeds: &[Velocity]) -> Result<Report, DesignError> {
    let fastest_direct = RatioSeries::of_speeds(speeds, 1)?;
    let count = speeds.len();
    let range = fastest_direct.speed_range();
    let recommended = recommended_speeds(range)?;
    let mut rows = vec![
        Row::new("range", "fastest over slowest", "d", [Figure::Multiple(range)]),
        Row::new("first_step", "fastest over the next", "q", [Figure::Multiple(fastest_direct.ratios()[1])]),
        Row::new("geometric_step", "step of a geometric series", "", [Figure::Multiple(step(range, count)?)]),
        Row::new("speeds", "speeds wanted", "λ", [Figure::Count(count as u32)]),
    ];
    rows.push(Row {
        remark: in_words(recommended).to_owned(),
        ..Row::new("recommended", "speeds recommended for d", "", [Figure::Count(recommended.speeds)])
    });
    let facts = Section { name: "speeds", title: "Speeds", columns: &[], rows, note: "" };
    let series = (1..=count).map(|direct| line(speeds, direct)).collect::<Result<Vec<_>, DesignError>>()?;
    let records = Records {
        name: "series",
        columns: vec![
            Column::number("direct", "direct drive"),
            Column::words("regime", "regime"),
            Column::words("ratios", "ratios"),
            Column::words("printed", "as printed"),
        ],
        rows: series,
        views: vec![View {
            note: "Ratios list the fastest speed first; direct drive: its place among them. The source calls the combined \
                   regime undesirable. It takes speeds in geometric progression; where its series does not serve \
                   these, the last column has it."
                .to_owned(),
            ..View::new("Ratios", &["direct", "regime", "ratios", "printed"])
        }],
        is_answer: false,
    };
    Ok(Report { title: None, parts: vec![Part::Facts(facts), Part::Records(records)], warnings: None })
}

fn line(speeds: &[Velocity], direct: usize) -> Result<Vec<Figure>, DesignError> {
    let series = RatioSeries::of_speeds(speeds, direct)?;
    let regime = match series.regime() {
        Regime::Reduction => Figure::Answer("reduction", "reduction"),
        Regime::Overdrive => Figure::Answer("multiplication", "multiplication"),
        Regime::Combined => Figure::Answer("combined", "combined"),
    };
    let count = speeds.len();
    let (q, d) = ((speeds[count - 1] / speeds[count - 2]).value, series.speed_range());
    let printed =
        PrintedSeries::ALL.into_iter().find(|printed| printed.count() == count && printed.direct() == direct);
    let printed = match printed {
        None => text(""),
        Some(printed) if printed.serves(speeds, SAME)? => Figure::Answer("the same", "the same"),
        Some(printed) => Figure::Numbers(printed.members(q, d)),
    };
    Ok(vec![Figure::Count(direct as u32), regime, Figure::Numbers(series.ratios().to_vec()), printed])
}

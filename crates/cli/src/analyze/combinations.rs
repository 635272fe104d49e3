//! Every set of controls, with its state.

use super::overview::{engaged, warnings};
use super::subject::Subject;
use crate::failure::Failure;
use epicyclic_train::{Analysis, Gear, Gearbox};
use epicyclic_views::figure::{Figure, multiple, text};
use epicyclic_views::report::{Column, Part, Records, Report, View};

/// The whole answer.
pub(super) fn report(subject: &Subject) -> Result<Report, Failure> {
    let gearbox = &subject.gearbox;
    let all = gearbox.combinations(0..=gearbox.shift_elements().len())?;
    let records = Records {
        name: "combinations",
        columns: vec![
            Column::words("engaged", "engaged"),
            Column::words("state", "state"),
            Column::words("state_links", "links"),
            Column::number("ratio", "i"),
            Column::number("exact_ratio", "exact"),
            Column::number("efficiency", "η"),
            Column::words("gear", "gear"),
        ],
        rows: all.iter().map(|analysis| row(gearbox, analysis)).collect(),
        views: vec![View {
            note: count(&all),
            ..View::new(
                "Every set of controls",
                &["engaged", "state", "state_links", "ratio", "exact_ratio", "efficiency", "gear"],
            )
        }],
        is_answer: true,
    };
    Ok(Report {
        title: Some(gearbox.name().to_owned()),
        parts: vec![Part::Records(records)],
        warnings: Some(warnings(subject)),
    })
}

fn count(all: &[Analysis]) -> String {
    let with_ratio = all.iter().filter(|analysis| analysis.state().has_ratio()).count();
    format!("{} sets, {with_ratio} with a ratio.", all.len())
}

fn row(gearbox: &Gearbox, analysis: &Analysis) -> Vec<Figure> {
    let same = |gear: &&Gear| {
        let this = analysis.gear();
        gear.engaged() == this.engaged() && gear.input() == this.input() && gear.output() == this.output()
    };
    vec![
        Figure::Texts(engaged(gearbox, analysis.gear())),
        Figure::Answer(analysis.state().name(), analysis.state().name()),
        Figure::Texts(analysis.state().links().to_vec()),
        multiple(analysis.ratio()),
        analysis.exact_ratio().map_or(Figure::None, |ratio| Figure::Text(ratio.to_string())),
        multiple(analysis.efficiency()),
        gearbox.gears().iter().find(same).map_or_else(|| text(""), |gear| text(gear.name())),
    ]
}

//! Every combination of shift elements.

use super::shared::{exact, state};
use crate::analyze::answer::combinations::{Combination, Combinations};
use crate::table::figure::{Figure, multiple, text};
use crate::table::report::AsReport;
use crate::table::report::{Column, Part, Records, Report, View, warned};

impl AsReport for Combinations {
    fn report(&self) -> Report {
        let shown = ["engaged", "state", "state_links", "ratio", "exact_ratio", "efficiency", "gear"];
        let count = format!("{} combinations, {} with a ratio.", self.combinations.len(), self.with_ratio);
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
            rows: self.combinations.iter().map(row).collect(),
            views: vec![View { note: count, ..View::new("Combinations of shift elements", &shown) }],
            is_answer: true,
        };
        Report {
            title: Some(self.gearbox.clone()),
            parts: vec![Part::Records(records)],
            warnings: warned(&self.warnings),
        }
    }
}

fn row(one: &Combination) -> Vec<Figure> {
    vec![
        Figure::Texts(one.engaged.clone()),
        state(one.state),
        Figure::Texts(one.state_links.clone()),
        multiple(one.ratio),
        exact(one.exact_ratio),
        multiple(one.efficiency),
        text(one.gear.clone().unwrap_or_default()),
    ]
}

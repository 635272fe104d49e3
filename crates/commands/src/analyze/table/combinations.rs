//! Every combination of shift elements.

use super::shared::{exact, state};
use crate::analyze::answer::combinations::Combinations;
use crate::shared::judgement::table as judgement;
use crate::table::columns::Table;
use crate::table::report::AsReport;
use crate::table::report::{Part, Report, warned};

impl AsReport for Combinations {
    fn report(&self) -> Report {
        let shown = ["engaged", "state", "state_links", "ratio", "exact_ratio", "efficiency", "gear"];
        let count = format!("{} combinations, {} with a ratio.", self.combinations.len(), self.with_ratio);
        let records = Table::new("combinations", self.combinations.iter())
            .words("engaged", "engaged", |one| one.engaged.clone())
            .words("state", "state", |one| state(one.state))
            .words("state_links", "links", |one| one.state_links.clone())
            .multiple("ratio", "i", |one| one.ratio)
            .number("exact_ratio", "exact", |one| exact(one.exact_ratio))
            .multiple("efficiency", "η", |one| one.efficiency)
            .words("gear", "gear", |one| one.gear.clone().unwrap_or_default())
            .view_of("Combinations of shift elements", &shown)
            .note(count)
            .the_answer()
            .records();
        Report {
            title: Some(self.gearbox.clone()),
            parts: [Part::Records(records)].into_iter().chain(judgement::parts(&self.judgement)).collect(),
            warnings: warned(&self.warnings),
        }
    }
}

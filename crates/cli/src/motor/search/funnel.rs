//! What a search tried, why the others fell, and how much better a motor between the places tried may be.

use epicyclic_hydromotor::checks::Subject;
use epicyclic_hydromotor::search::{Found, Reason, SpacingError};
use epicyclic_views::figure::Figure;
use epicyclic_views::report::Row;

/// The objectives, of which the error is stated.
pub(super) const SPACING: &[(&str, &str)] =
    &[("displacement_by_volume", "q/V"), ("ripple", "ripple"), ("least_radius", "radius")];

pub(super) fn spacing(name: &'static str, label: &'static str, error: SpacingError) -> Row {
    let values = [error.displacement_by_volume, error.ripple, error.least_radius];
    Row::new(name, label, "", values.map(Figure::Share))
}

pub(super) fn count(count: usize) -> Figure {
    Figure::Count(u32::try_from(count).unwrap_or(u32::MAX))
}

const fn reason(reason: Reason) -> (&'static str, &'static str) {
    match reason {
        Reason::NotClosed => ("not_closed", "does not close, at an end"),
        Reason::Check(Subject::StatorBulge) => ("stator_bulge", "roots in the stator's bulges"),
        Reason::Check(Subject::StatorHollow) => ("stator_hollow", "satellite in the stator's hollows"),
        Reason::Check(Subject::RotorBulge) => ("rotor_bulge", "roots in the rotor's bulges"),
        Reason::Check(Subject::RotorHollow) => ("rotor_hollow", "satellite in the rotor's hollows"),
        Reason::Check(Subject::RotorLeastRadius) => ("rotor_least_radius", "rotor without a body"),
        Reason::Check(Subject::Neighbours) => ("neighbours", "satellites' tips meet"),
        Reason::LeastRadius => ("least_radius", "curvature radius wanted"),
        Reason::Size => ("size", "no size within the limits"),
        Reason::Ripple => ("ripple", "ripple wanted"),
    }
}

pub(super) fn rows(found: &Found, all: usize) -> Vec<Row> {
    let funnel = &found.funnel;
    let row = |name, label, value| Row::new(name, label, "", [count(value)]);
    let mut rows = vec![
        row("sets", "sets of lobes and teeth", funnel.sets),
        row("outside_limits", "… outside limits of the rotor", funnel.outside_limits),
        row("without_family", "… with which no motor closes", funnel.without_family),
        row("places", "motors at even places", funnel.points),
        row("refined", "motors added by refinement", funnel.refined),
    ];
    for each in Reason::ALL {
        let (name, label) = reason(each);
        let refused = funnel.refused(each);
        if refused > 0 {
            rows.push(Row { remark: "refused".to_owned(), ..row(name, label, refused) });
        }
    }
    rows.push(row("accepted", "motors that pass", funnel.accepted));
    rows.push(row("front", "… that no other surpasses", funnel.front));
    rows.push(row("apart", "designs, alike ones once", all));
    if found.designs.len() < all {
        rows.push(row("with_teeth", "… on which the default teeth hold", found.designs.len()));
    }
    rows
}

/// What refused every motor, the most frequent reason first.
pub(super) fn in_short(found: &Found) -> String {
    let funnel = &found.funnel;
    let mut refused: Vec<(usize, &str)> = Reason::ALL
        .iter()
        .map(|&each| (funnel.refused(each), reason(each).1))
        .filter(|one| one.0 > 0)
        .collect();
    refused.sort_by_key(|(count, _)| std::cmp::Reverse(*count));
    let reasons: Vec<String> = refused.iter().map(|(count, words)| format!("{words} {count}")).collect();
    let reasons =
        if reasons.is_empty() { String::new() } else { format!("; refused: {}", reasons.join(", ")) };
    format!(
        "{} sets of lobes and teeth, {} outside limits, {} close no motor, {} motors tried{reasons}",
        funnel.sets,
        funnel.outside_limits,
        funnel.without_family,
        funnel.points + funnel.refined
    )
}

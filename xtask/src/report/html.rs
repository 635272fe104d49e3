//! Outcomes as a page: a summary, then every figure source by source, with print, result and remarks.
//!
//! The page is complete: one stylesheet, no script. Switches that the stylesheet reads select the figures
//! shown.

use crate::cases::figure::{Figure, Status};
use crate::cases::run::Outcome;
use maud::{DOCTYPE, Markup, PreEscaped, html};

/// Stylesheet of the program's pages.
const PAGES: &str =
    include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../crates/commands/src/page/page.css"));
/// Additional stylesheet of this page.
const OWN: &str = include_str!("html.css");

/// Verdicts on a figure: the class in the page, the word, and its meaning.
const VERDICTS: [(Status, &str, &str, &str); 8] = [
    (Status::Failed, "failed", "does not hold", "The case does not hold: the program or the case is wrong."),
    (
        Status::Contradicted,
        "contradicted",
        "contradicted",
        "The figure does not follow from the source's own inputs; the reason and, where there is one, the arithmetic stand below it.",
    ),
    (
        Status::Agrees,
        "agrees",
        "agrees",
        "The printed figure follows from the inputs, within its digits or the tolerance.",
    ),
    (
        Status::Reconstructed,
        "reconstructed",
        "reconstructed",
        "It follows from a restored reading; the copy lost or garbled the formula, or the document has no figures.",
    ),
    (
        Status::Definition,
        "definition",
        "definition",
        "It repeats the definition of its own quantity, our copy of a table, or an input that was solved for.",
    ),
    (Status::Given, "given", "given", "The source sets it: an input."),
    (
        Status::Unrecoverable,
        "unrecoverable",
        "lost",
        "It is lost in the copy; what is legible stands below it.",
    ),
    (Status::Refused, "refused", "refused", "These inputs must be refused, and are."),
];

/// The page of every source.
#[must_use]
pub fn render(outcomes: &[Outcome]) -> String {
    let holds = outcomes.iter().all(Outcome::holds);
    let verdict = if holds { "Verified" } else { "Not verified" };
    let counts = super::human::counts(outcomes);
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { "Verification of epicyclic" }
                style { (PreEscaped(PAGES)) (PreEscaped(OWN)) }
            }
            body {
                header {
                    h1 { "Verification of epicyclic" }
                    p.about { (verdict) ": " (counts) "." }
                }
                (summary(outcomes))
                (switches(outcomes))
                @for outcome in outcomes { (source(outcome)) }
                footer { p { "Written by " code { "cargo xtask verify --html" } ". A figure stands as printed; its digits are its tolerance unless another is given." } }
            }
        }
    };
    page.into_string()
}

fn count(outcomes: &[Outcome], status: Status) -> usize {
    outcomes.iter().map(|outcome| outcome.count(status)).sum()
}

/// The verdicts that occur.
fn present(
    outcomes: &[Outcome],
) -> impl Iterator<Item = &'static (Status, &'static str, &'static str, &'static str)> {
    VERDICTS.iter().filter(move |(status, ..)| count(outcomes, *status) > 0)
}

/// Numbers of figures by source and verdict, and the meaning of the verdicts.
fn summary(outcomes: &[Outcome]) -> Markup {
    let present: Vec<_> = present(outcomes).collect();
    html! {
        section.answer {
            h2 { "Summary" }
            div.table { table {
                thead { tr {
                    th { "source" } th.number { "figures" }
                    @for (_, _, word, _) in &present { th.number { (word) } }
                    th { "places covered" }
                } }
                tbody {
                    @for outcome in outcomes { tr {
                        td { a href={ "#" (outcome.source) } { (outcome.source) } }
                        td.number { (outcome.figures.len()) }
                        @for (status, ..) in &present { td.number { (outcome.count(*status)) } }
                        td { (covered(outcome)) }
                    } }
                    @if outcomes.len() > 1 { tr.total {
                        td { "all" }
                        td.number { (outcomes.iter().map(|outcome| outcome.figures.len()).sum::<usize>()) }
                        @for (status, ..) in &present { td.number { (count(outcomes, *status)) } }
                        td {}
                    } }
                }
            } }
            dl.verdicts { @for (_, class, word, meaning) in &present { dt class=(class) { (word) } dd { (meaning) } } }
        }
    }
}

fn covered(outcome: &Outcome) -> String {
    if outcome.coverage.is_empty() {
        return "-".to_owned();
    }
    let covered = outcome.coverage.iter().filter(|place| place.figures > 0).count();
    let excused = outcome.coverage.iter().filter(|place| place.excused.is_some()).count();
    let excused = if excused > 0 { format!(", {excused} excused") } else { String::new() };
    format!("{covered} of {}{excused}", outcome.coverage.len())
}

/// Switches that select the figures shown.
fn switches(outcomes: &[Outcome]) -> Markup {
    html! {
        fieldset.switches {
            legend { "Figures shown" }
            label { input type="radio" name="shown" id="only-all" checked; " all" }
            @for (_, class, word, _) in present(outcomes) {
                label { input type="radio" name="shown" id={ "only-" (class) }; " " (word) }
            }
        }
    }
}

fn source(outcome: &Outcome) -> Markup {
    let mut cases: Vec<(&str, Vec<&Figure>)> = Vec::new();
    for figure in &outcome.figures {
        let case = figure.name.split_once('/').map_or(figure.name.as_str(), |(case, _)| case);
        match cases.last_mut() {
            Some((last, figures)) if *last == case => figures.push(figure),
            _ => cases.push((case, vec![figure])),
        }
    }
    let excused: Vec<_> =
        outcome.coverage.iter().filter_map(|place| Some((place, place.excused.as_ref()?))).collect();
    html! {
        section id=(outcome.source) {
            h2 { (outcome.source) }
            p.about { (outcome.title) }
            @if !outcome.faults.is_empty() { div.objections {
                h3 { "Faults" }
                ul { @for fault in &outcome.faults {
                    li { (fault.file) ":" (fault.line) ":" (fault.column) ": " (fault.message) " [" (fault.name) "]" }
                } }
            } }
            details open {
                summary { (outcome.figures.len()) " figures of " (outcome.cases) " cases" }
                div.table { table.figures {
                    thead { tr { th { "figure" } th { "printed" } th { "computed" } th { "tolerance" } th { "verdict" } } }
                    @for (name, figures) in &cases { (case(name, figures)) }
                } }
            }
            @if !excused.is_empty() { details open {
                summary { (excused.len()) " places without a figure" }
                div.table { table {
                    thead { tr { th { "place" } th { "what stands there" } th { "reason" } } }
                    tbody { @for (place, why) in &excused { tr { td { (place.place) } td { (place.what) } td { (why) } } } }
                } }
            } }
        }
    }
}

fn case(name: &str, figures: &[&Figure]) -> Markup {
    let places: Vec<&str> = figures.iter().map(|figure| figure.cite.as_str()).collect();
    // A place common to all figures is shown once, at the head of the case.
    let one_place = places.windows(2).all(|pair| pair[0] == pair[1]);
    html! {
        tbody {
            tr.case { th colspan="5" {
                (name)
                @if one_place { @if let Some(place) = places.first() { " " span.about { (place) } } }
            } }
            @for figure in figures { (row(figure, !one_place)) }
        }
    }
}

fn row(figure: &Figure, has_place: bool) -> Markup {
    let (class, word) = VERDICTS
        .iter()
        .find(|(status, ..)| *status == figure.status)
        .map_or(("", ""), |(_, class, word, _)| (class, word));
    let quantity = figure.name.split_once('/').map_or("", |(_, quantity)| quantity);
    let text = |value: &Option<String>| value.clone().unwrap_or_else(|| "-".to_owned());
    let evidence = figure.evidence.map(super::human::evidence_word);
    let notes: Vec<Markup> = [
        figure.failure.as_ref().map(|failure| html! { strong { (failure) } }),
        figure.remedy.as_ref().map(|remedy| html! { "Remedy: " (remedy) "." }),
        figure.because.as_ref().map(|because| html! { (because) }),
        figure.arithmetic.as_ref().map(|arithmetic| html! { "Arithmetic: " code { (arithmetic) } }),
        figure.printed_unit.as_ref().map(|unit| html! { "The document prints the unit " (unit) "." }),
        figure.cause.map(|cause| html! { "The tolerance is loose, for " (cause.words()) "." }),
        evidence.map(|evidence| html! { "Evidence: " (evidence) "." }),
        has_place.then(|| html! { "Place: " (figure.cite) }),
    ]
    .into_iter()
    .flatten()
    .collect();
    html! {
        tr class=(class) {
            td { (quantity) }
            td { (text(&figure.published)) }
            td { (text(&figure.computed)) }
            td { (text(&figure.tolerance)) }
            td.verdict { (word) }
        }
        @if !notes.is_empty() { tr class={ (class) " because" } { td colspan="5" {
            @for note in &notes { p { (note) } }
        } } }
    }
}

//! All gears of a gearbox side by side.

use super::planet_bearings;
use super::shared::{column, exact, one_way_clutches, self_locking, state, warnings, yes_no};
use crate::AsReport;
use crate::figure::{Figure, multiple, text};
use crate::report::{Column, Part, Records, Report, Text, View};
use epicyclic_answers::analyze::overview::{Gear, Overview};
use epicyclic_answers::analyze::records::{Published, State};
use epicyclic_answers::analyze::warnings::state_in_words;
use epicyclic_formats::Dimension;

impl AsReport for Overview {
    fn report(&self) -> Report {
        let mut parts = vec![];
        parts.extend(
            self.source.iter().map(|source| Part::Text(Text::paragraph(format!("Source: {source}")))),
        );
        parts.push(Part::Records(gears(self)));
        let states: Vec<String> =
            self.gears.iter().filter(|gear| gear.facts.state != State::Driven).map(state_of).collect();
        if !states.is_empty() {
            parts.push(Part::Text(Text::list("Gears that are not simply driven", states)));
        }
        let bearings = planet_bearings::records(&self.planet_bearings, &self.operating_point, false);
        parts.extend(bearings.map(Part::Records));
        if !self.shift_elements.is_empty() {
            parts.push(Part::Text(engagement_table(self)));
        }
        if !self.one_way_clutches.is_empty() {
            parts.push(Part::Records(one_way_clutches(&self.one_way_clutches, false)));
        }
        Report { title: Some(self.gearbox.clone()), parts, warnings: warnings(&self.warnings) }
    }
}

fn gears(overview: &Overview) -> Records {
    let mut views = vec![View::new("Gears", &["gear", "engaged", "state", "ratio", "exact_ratio", "step"])];
    if overview.gears.iter().any(|gear| gear.facts.published.is_some()) {
        views.push(View::new("Published ratios", &["gear", "published", "computed", "agrees", "remark"]));
    }
    views.push(View {
        note: note(overview),
        ..View::new(
            "Losses, and speeds over the input's",
            &[
                "gear",
                "efficiency",
                "back_driving_efficiency",
                "self_locking",
                "circulating_of_entering",
                "largest_speed_of_input",
                "largest_planet_speed_of_input",
            ],
        )
    });
    let at = &overview.operating_point;
    if at.speed_rad_s.is_some() || at.torque_n_m.is_some() || at.power_w.is_some() {
        views.push(View::new("Output", &["gear", "output_speed", "output_torque"]));
    }
    Records {
        name: "gears",
        columns: columns(),
        rows: overview.gears.iter().map(row).collect(),
        views,
        is_answer: true,
    }
}

fn columns() -> Vec<Column> {
    vec![
        Column::words("gear", "gear"),
        Column::words("engaged", "engaged"),
        Column::words("input", "input"),
        Column::words("output", "output"),
        Column::words("state", "state"),
        Column::words("state_links", "links"),
        Column::number("ratio", "i"),
        Column::number("exact_ratio", "exact"),
        Column::number("step", "step"),
        Column::number("published", "published"),
        Column::number("computed", "computed"),
        Column::words("agrees", "agrees"),
        Column::words("output_over_input", "output over input"),
        Column::words("unverified", "unverified"),
        Column::words("remark", "remark").for_people(),
        Column::number("efficiency", "η"),
        Column::number("back_driving_efficiency", "η back"),
        Column::words("self_locking", "self-locking"),
        Column::number("circulating_of_entering", "circulating"),
        Column::number("largest_speed_of_input", "largest |ω|"),
        Column::number("largest_planet_speed_of_input", "planet"),
        Column::quantity("output_speed", Dimension::AngularSpeed),
        Column::quantity("output_torque", Dimension::Torque),
    ]
}

fn row(gear: &Gear) -> Vec<Figure> {
    let facts = &gear.facts;
    let published = facts.published.as_ref();
    vec![
        text(&facts.gear),
        Figure::Texts(facts.engaged.clone()),
        text(&facts.input),
        text(&facts.output),
        state(facts.state),
        Figure::Texts(facts.state_links.clone()),
        multiple(facts.ratio),
        exact(facts.exact_ratio),
        multiple(gear.step),
        published.map_or(Figure::None, printed),
        multiple(published.and_then(|published| published.computed)),
        yes_no(published.and_then(|published| published.agrees)),
        yes_no(published.map(|published| published.output_over_input)),
        yes_no(published.map(|published| published.unverified)),
        text(published.map_or_else(String::new, remark)),
        multiple(facts.efficiency),
        multiple(facts.back_driving_efficiency),
        self_locking(facts.self_locking),
        multiple(gear.circulating_of_entering),
        multiple(gear.largest_speed_of_input),
        multiple(gear.largest_planet_speed_of_input),
        column(gear.output_speed_rad_s, Dimension::AngularSpeed),
        column(gear.output_torque_n_m, Dimension::Torque),
    ]
}

/// A published ratio with its decimals.
pub(super) fn printed(published: &Published) -> Figure {
    Figure::Printed(published.ratio, usize::try_from(published.decimals).unwrap_or_default())
}

/// What is to be known of a published ratio.
fn remark(published: &Published) -> String {
    let all = [
        published.output_over_input.then_some("output over input"),
        published.unverified.then_some("not read in its source"),
    ];
    all.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

fn note(overview: &Overview) -> String {
    let speeds = "η back: back-driving efficiency. Largest |ω|: of the links. Planet: the largest speed relative to \
                  its carrier.";
    if overview.has_losses {
        speeds.to_owned()
    } else {
        format!("{speeds} No losses are stated; --efficiency 0.97 gives each set some.")
    }
}

/// The state of a gear that is not simply driven.
fn state_of(gear: &Gear) -> String {
    let name = &gear.facts.gear;
    match &gear.facts.links_with_given_speeds[..] {
        [] => format!("{name}: {}", state_in_words(&gear.facts)),
        links => {
            format!("{name}: settled by the speeds of {}; --gear '{name}' shows its state", links.join(", "))
        }
    }
}

fn engagement_table(overview: &Overview) -> Text {
    let names = || overview.shift_elements.iter().map(|element| &element.shift_element);
    let header = ["gear".to_owned()].into_iter().chain(names().cloned()).collect();
    let row = |gear: &Gear| {
        let mark = |name: &String| if gear.facts.engaged.contains(name) { "x" } else { "." }.to_owned();
        [gear.facts.gear.clone()].into_iter().chain(names().map(mark)).collect()
    };
    Text {
        heading: Some("Engagement table".to_owned()),
        table: [header].into_iter().chain(overview.gears.iter().map(row)).collect(),
        ..Text::default()
    }
}

//! All gears of a gearbox side by side.

use super::shared::{exact, joins, kind, one_way_clutches, self_locking, state};
use super::{planet_bearings, sets, shifts};
use crate::analyze::answer::elements::SlipAndTorque;
use crate::analyze::answer::overview::{Gear, Overview};
use crate::analyze::answer::planets::{self, LargestForce};
use crate::analyze::answer::progression::Progression;
use crate::analyze::answer::records::{GearFacts, Published, State};
use crate::analyze::answer::warnings::state_in_words;
use crate::shared::judgement::table as judgement;
use crate::table::columns::Table;
use crate::table::figure::Figure;
use crate::table::report::AsReport;
use crate::table::report::{Part, Records, Report, Text, View, warned};
use epicyclic_units::Dimension;
use epicyclic_units::format::trimmed;

impl AsReport for Overview {
    fn report(&self) -> Report {
        let mut parts = vec![];
        parts.extend(
            self.source.iter().map(|source| Part::Text(Text::paragraph(format!("Source: {source}")))),
        );
        if !self.shift_elements.is_empty() && !has_marks(self) {
            parts.push(Part::Text(engagement_table(self)));
        }
        parts.push(Part::Records(records(self, views(self))));
        parts.extend(states(self).map(Part::Text));
        parts.push(Part::Records(sets::records(&self.sets)));
        if !self.shift_elements.is_empty() {
            parts.push(Part::Records(shift_elements(self)));
        }
        if !self.shifts.is_empty() {
            parts.push(Part::Records(shifts::records(&self.shifts, "Shifts between neighbouring gears")));
        }
        if !self.one_way_clutches.is_empty() {
            parts.push(Part::Records(one_way_clutches(&self.one_way_clutches, false)));
        }
        parts.extend(planets(self).map(Part::Records));
        let bearings = planet_bearings::records(&self.planet_bearings, &self.operating_point, false);
        parts.extend(bearings.map(Part::Records));
        parts.extend(judgement::parts(&self.judgement));
        Report { title: Some(self.gearbox.clone()), parts, warnings: warned(&self.warnings) }
    }
}

/// The widest engagement table, in letters, that stands beside the ratios.
const WIDEST_MARKS: usize = 30;

/// Whether the engagement table is part of the table of gears.
fn has_marks(overview: &Overview) -> bool {
    let names = overview.shift_elements.iter().map(|one| one.element.shift_element.chars().count() + 2);
    !overview.shift_elements.is_empty() && names.sum::<usize>() <= WIDEST_MARKS
}

/// The tables of the gears.
fn views(overview: &Overview) -> Vec<View> {
    let mut shown = vec!["gear"];
    shown.extend(has_marks(overview).then_some("mark"));
    // Where all are driven nothing needs saying.
    shown.extend((!is_driven(overview)).then_some("state"));
    shown.extend(["ratio", "exact_ratio", "step"]);
    if has_deviations(overview) {
        shown.extend(["geometric_deviation", "progressive_deviation"]);
    }
    let mut views =
        vec![View { note: progression_note(&overview.progressions), ..View::new("Gears", &shown) }];
    views.extend(published(overview));
    let losses = [&["gear", "efficiency"][..], LOSSES].concat();
    views.push(View { note: note(overview), ..View::new("Losses, and speeds over the input's", &losses) });
    let at = &overview.operating_point;
    if at.speed_rad_s.is_some() || is_loaded(overview) {
        views.push(View::new("Output", &["gear", "output_speed", "output_torque"]));
    }
    views.extend(of_elements(overview));
    views
}

/// What the gears lose, and the largest speeds in them.
const LOSSES: &[&str] = &[
    "back_driving_efficiency",
    "self_locking",
    "circulating_of_entering",
    "largest_speed_of_input",
    "largest_planet_speed_of_input",
];

fn is_driven(overview: &Overview) -> bool {
    overview.gears.iter().all(|gear| gear.facts.state == State::Driven)
}

fn is_loaded(overview: &Overview) -> bool {
    let at = &overview.operating_point;
    at.torque_n_m.is_some() || at.power_w.is_some()
}

fn has_deviations(overview: &Overview) -> bool {
    overview.gears.iter().any(|gear| gear.geometric_deviation.is_some())
}

fn published(overview: &Overview) -> Option<View> {
    let has_published = overview.gears.iter().any(|gear| gear.facts.published.is_some());
    has_published
        .then(|| View::new("Published ratios", &["gear", "published", "computed", "agrees", "remark"]))
}

/// Of one gear the table of shift elements says all.
fn of_elements(overview: &Overview) -> Vec<View> {
    if overview.gears.len() > 1 && !overview.shift_elements.is_empty() {
        over_gears(overview).into()
    } else {
        vec![]
    }
}

/// Table of the gears and of each shift element in them: the torque of an engaged one, the slip of an open
/// one.
fn records(overview: &Overview, views: Vec<View>) -> Records {
    Table::new("gears", &overview.gears)
        .text("gear", "gear", |gear| &gear.facts.gear)
        .words("engaged", "engaged", |gear| gear.facts.engaged.clone())
        .text("input", "input", |gear| &gear.facts.input)
        .text("output", "output", |gear| &gear.facts.output)
        .words("state", "state", |gear| state(gear.facts.state))
        .words("state_links", "links", |gear| gear.facts.state_links.clone())
        .multiple("ratio", "i", |gear| gear.facts.ratio)
        .number("exact_ratio", "exact", |gear| exact(gear.facts.exact_ratio))
        .multiple("step", "step", |gear| gear.step)
        .share("geometric_deviation", "geom.", |gear| gear.geometric_deviation)
        .share("progressive_deviation", "progr.", |gear| gear.progressive_deviation)
        .number("published", "published", |gear| gear.facts.published.as_ref().map(printed))
        .multiple("computed", "computed", |gear| gear.facts.published.as_ref()?.computed)
        .words("agrees", "agrees", |gear| gear.facts.published.as_ref()?.agrees)
        .words("output_over_input", "output over input", |gear| {
            Some(gear.facts.published.as_ref()?.output_over_input)
        })
        .words("unverified", "unverified", |gear| Some(gear.facts.published.as_ref()?.unverified))
        .words("remark", "remark", |gear| gear.facts.published.as_ref().map_or_else(String::new, remark))
        .for_people()
        .multiple("efficiency", "η", |gear| gear.facts.efficiency)
        .multiple("back_driving_efficiency", "η back", |gear| gear.facts.back_driving_efficiency)
        .words("self_locking", "self-locking", |gear| self_locking(gear.facts.self_locking))
        .multiple("circulating_of_entering", "circulating", |gear| gear.circulating_of_entering)
        .multiple("largest_speed_of_input", "largest |ω|", |gear| gear.largest_speed_of_input)
        .multiple("largest_planet_speed_of_input", "planet", |gear| gear.largest_planet_speed_of_input)
        .quantity("output_speed", "", Dimension::AngularSpeed, |gear| gear.output_speed_rad_s)
        .quantity("output_torque", "", Dimension::Torque, |gear| gear.output_torque_n_m)
        .each(overview.shift_elements.iter().enumerate(), |table, (place, one)| {
            let name = &one.element.shift_element;
            table
                .words("mark", "", |gear| Figure::Mark(gear.shift_elements[place].duty.engaged))
                .of(name)
                .for_people()
                .multiple("torque_of_input", "", |gear| duty(gear, place, true)?.torque_of_input)
                .of(name)
                .quantity("torque", "", Dimension::Torque, |gear| duty(gear, place, true)?.torque_n_m)
                .of(name)
                .multiple("slip_of_input", "", |gear| duty(gear, place, false)?.slip_of_input)
                .of(name)
                .quantity("slip", "", Dimension::AngularSpeed, |gear| duty(gear, place, false)?.slip_rad_s)
                .of(name)
        })
        .views(views)
        .the_answer()
        .records()
}

/// Duty of a shift element in a gear if its state there is that asked for, engaged or open.
fn duty(gear: &Gear, place: usize, engaged: bool) -> Option<&SlipAndTorque> {
    Some(&gear.shift_elements[place].duty).filter(|duty| duty.engaged == engaged)
}

/// Gears that are not simply driven, each with its state.
fn states(overview: &Overview) -> Option<Text> {
    let gears = overview.gears.iter().filter(|gear| gear.facts.state != State::Driven);
    let states: Vec<String> = gears.map(state_of).collect();
    (!states.is_empty()).then(|| Text::list("Gears that are not simply driven", states))
}

/// The first table of a page: what each gear engages, its ratio, step and efficiency, and what the output
/// does.
pub(crate) fn in_short(overview: &Overview) -> Records {
    let at = &overview.operating_point;
    let has_output = at.speed_rad_s.is_some() || is_loaded(overview);
    let gears = || overview.gears.iter().map(|gear| &gear.facts);
    let ends = |gear: &GearFacts| [gear.input.clone(), gear.output.clone()];
    let is_shared = gears().all(|gear| gears().next().map(ends) == Some(ends(gear)));
    let columns = [
        ("gear", true),
        ("mark", has_marks(overview)),
        ("engaged", !overview.shift_elements.is_empty() && !has_marks(overview)),
        ("input", !is_shared),
        ("output", !is_shared),
        ("state", !is_driven(overview)),
        ("ratio", true),
        ("exact_ratio", !has_output && is_shared),
        ("step", gears().len() > 1),
        ("efficiency", overview.has_losses),
        ("output_speed", at.speed_rad_s.is_some()),
        ("output_torque", is_loaded(overview)),
    ];
    let shown: Vec<&'static str> =
        columns.into_iter().filter_map(|(name, is_shown)| is_shown.then_some(name)).collect();
    let mut note = String::from("i: input speed over output speed.");
    if has_output {
        note += " rpm, N·m: of the output.";
    }
    records(overview, vec![View { note, ..View::new("Gears", &shown) }])
}

/// The chapter of all gears on a page: what the page says first is left out, and what the figures of each
/// gear say again; with `shifts` where no other chapter has them.
pub(crate) fn chapter(overview: &Overview, shifts: bool) -> Vec<Part> {
    let is_told = |name: &&str| in_short(overview).views.iter().any(|view| view.columns.contains(name));
    let mut shown = vec!["gear"];
    shown.extend(["exact_ratio"].iter().filter(|name| !is_told(name)));
    if has_deviations(overview) {
        shown.extend(["geometric_deviation", "progressive_deviation"]);
    }
    shown.extend(LOSSES);
    let notes = [progression_note(&overview.progressions), note(overview)];
    let notes: Vec<String> = notes.into_iter().filter(|note| !note.is_empty()).collect();
    let title = "Progression, losses, and speeds over the input's";
    let mut views = vec![View { note: notes.join(" "), ..View::new(title, &shown) }];
    views.extend(published(overview));
    views.extend(of_elements(overview));
    let mut parts = vec![Part::Records(records(overview, views))];
    parts.extend(states(overview).map(Part::Text));
    if !overview.shift_elements.is_empty() {
        parts.push(Part::Records(shift_elements(overview)));
    }
    if shifts && !overview.shifts.is_empty() {
        parts.push(Part::Records(shifts::records(&overview.shifts, "Shifts between neighbouring gears")));
    }
    if !overview.one_way_clutches.is_empty() {
        parts.push(Part::Records(one_way_clutches(&overview.one_way_clutches, false)));
    }
    if overview.planets.iter().any(|one| one.largest_force.is_some()) {
        parts.extend(planets(overview).map(Part::Records));
    }
    let bearings = planet_bearings::records(&overview.planet_bearings, &overview.operating_point, false);
    parts.extend(bearings.map(Part::Records));
    parts
}

/// Torque and slip of the shift elements gear by gear.
fn over_gears(overview: &Overview) -> [View; 2] {
    let at = &overview.operating_point;
    let has_torques = overview.gears.iter().flat_map(|gear| &gear.shift_elements);
    let has_torques = has_torques.clone().any(|one| one.duty.torque_n_m.is_some());
    let (torque, torques) = if has_torques {
        ("torque", "Torque of the shift elements, N·m")
    } else {
        ("torque_of_input", "Torque of the shift elements over the input's")
    };
    let (slip, slips) = if at.speed_rad_s.is_some() {
        ("slip", "Slip of the shift elements, rpm")
    } else {
        ("slip_of_input", "Slip of the shift elements over the input's speed")
    };
    let view = |title, what, note: &str| View { note: note.to_owned(), ..View::new(title, &["gear", what]) };
    [
        view(
            torques,
            torque,
            "With losses, on the first link of those that are engaged; of a brake the reaction of the housing on it.",
        ),
        view(slips, slip, "Of those that are open: speed of the first link less that of the second."),
    ]
}

/// Spread and ideal steps.
fn progression_note(progressions: &[Progression]) -> String {
    let of = |one: &Progression| {
        let ends = [one.gears.first(), one.gears.last()].map(|gear| gear.map_or("", String::as_str));
        let mut text = format!("Gears {} to {}: spread {}", ends[0], ends[1], trimmed(one.spread, 5));
        if let Some(factor) = one.progression_factor {
            let how = if one.progression_factor_is_given { "as given" } else { "best fit" };
            let step = trimmed(one.geometric_step, 5);
            text += &format!(", geometric step {step}, progression factor {} ({how})", trimmed(factor, 5));
        }
        text + "."
    };
    let mut notes: Vec<String> = progressions.iter().map(of).collect();
    if progressions.iter().any(|one| one.progression_factor.is_some()) {
        notes.push(
            "Geom., progr.: the ratio over that of equal steps, and of steps each larger by the factor than the next, less 1."
                .to_owned(),
        );
    }
    notes.join(" ")
}

/// The largest torque and slip of each shift element.
fn shift_elements(overview: &Overview) -> Records {
    let largest = || overview.shift_elements.iter().filter_map(|one| one.largest_torque.as_ref());
    let has_torque = largest().any(|torque| torque.torque_n_m.is_some());
    let mut shown = vec!["shift_element", "joins", "torque_of_input"];
    shown.extend(has_torque.then_some("torque"));
    shown.extend(["torque_gear", "slip_of_input"]);
    shown.extend(overview.operating_point.speed_rad_s.map(|_| "slip"));
    shown.push("slip_gear");
    Table::new("shift_elements", overview.shift_elements.iter())
        .text("shift_element", "element", |one| &one.element.shift_element)
        .words("kind", "kind", |one| kind(one.element.kind))
        .words("joins", "joins", |one| joins(&one.element.links))
        .multiple("torque_of_input", "T", |one| Some(one.largest_torque.as_ref()?.torque_of_input))
        .quantity("torque", "", Dimension::Torque, |one| one.largest_torque.as_ref()?.torque_n_m)
        .words("torque_gear", "in gear", |one| Some(&*one.largest_torque.as_ref()?.gear))
        .multiple("slip_of_input", "slip", |one| Some(one.largest_slip.as_ref()?.slip_of_input))
        .quantity("slip", "", Dimension::AngularSpeed, |one| one.largest_slip.as_ref()?.slip_rad_s)
        .words("slip_gear", "in gear", |one| Some(&*one.largest_slip.as_ref()?.gear))
        .view_of("Shift elements: largest torque and slip", &shown)
        .note("T, slip: over the input's torque, with losses, and its speed.")
        .records()
}

/// One of the forces that are told.
type OfForce = fn(&LargestForce) -> Option<f64>;

/// The largest speed of each planet and force on it; `None` where neither follows.
fn planets(overview: &Overview) -> Option<Records> {
    let all = &overview.planets;
    let has = |of: fn(&planets::OverGears) -> bool| all.iter().any(of);
    // Of one gear the table of losses has the speed.
    let is_told = has(|one| one.largest_speed.is_some()) && overview.gears.len() > 1;
    if !is_told && !has(|one| one.largest_force.is_some()) {
        return None;
    }
    let mut shown = vec!["set", "planet", "relative_speed_of_input"];
    shown.extend(overview.operating_point.speed_rad_s.map(|_| "relative_speed"));
    shown.push("speed_gear");
    let forces: [(&str, OfForce); 3] = [
        ("force", |force| force.force_n),
        ("tangential_force", |force| force.tangential_force_n),
        ("tangential_force_n_per_input_n_m", |force| force.tangential_force_n_per_input_n_m),
    ];
    let known = forces
        .into_iter()
        .find(|(_, force)| all.iter().any(|one| one.largest_force.as_ref().and_then(force).is_some()));
    if let Some((force, _)) = known {
        shown.extend([force, "force_gear"]);
    }
    Some(
        Table::new("planets", all.iter())
            .text("set", "set", |one| &one.set)
            .text("planet", "planet", |one| &one.planet)
            .multiple("relative_speed_of_input", "speed", |one| {
                Some(one.largest_speed.as_ref()?.relative_speed_of_input)
            })
            .quantity("relative_speed", "", Dimension::AngularSpeed, |one| {
                one.largest_speed.as_ref()?.relative_speed_rad_s
            })
            .words("speed_gear", "in gear", |one| Some(&*one.largest_speed.as_ref()?.gear))
            .quantity("force", "force", Dimension::Force, |one| one.largest_force.as_ref()?.force_n)
            .quantity("tangential_force", "tangential force", Dimension::Force, |one| {
                one.largest_force.as_ref()?.tangential_force_n
            })
            .multiple("tangential_force_n_per_input_n_m", "tangential force, N at 1 N·m", |one| {
                one.largest_force.as_ref()?.tangential_force_n_per_input_n_m
            })
            .words("force_gear", "in gear", |one| Some(&*one.largest_force.as_ref()?.gear))
            .view_of("Planets: largest speed, and force on the bearing where it follows", &shown)
            .note("Speed: relative to the carrier, over the input's.")
            .records(),
    )
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
        format!("{speeds} No set has losses; --efficiency 0.97 gives each set some.")
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
    let names = || overview.shift_elements.iter().map(|one| &one.element.shift_element);
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

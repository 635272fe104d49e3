//! All gears of a gearbox side by side.

use super::subject::Subject;
use super::{Input, Worked, planet_bearings, work};
use crate::failure::Failure;
use epicyclic_formats::Dimension;
use epicyclic_formats::gearbox::PublishedGear;
use epicyclic_formats::quantity::format::trimmed;
use epicyclic_train::one_way::Duty;
use epicyclic_train::{Analysis, Gear, Gearbox, PlanetSet, State};
use epicyclic_views::figure::{Figure, column, multiple, text};
use epicyclic_views::report::{Column, Part, Records, Report, View, wrapped};

/// The whole answer.
pub(super) fn report(subject: &Subject, input: Input) -> Result<Report, Failure> {
    let gearbox = &subject.gearbox;
    let worked = gearbox
        .gears()
        .iter()
        .map(|gear| work(gearbox, gear.name(), input))
        .collect::<Result<Vec<Worked<'_>>, Failure>>()?;
    let source = subject.source.as_ref().map(|source| Part::Words(wrapped("Source:", source)));
    let states = states(subject, &worked);
    let forces = planet_bearings::of_gears(subject, &worked, input)?;
    let parts = source
        .into_iter()
        .chain([Part::Records(gears(subject, &worked, input))])
        .chain((!states.is_empty()).then_some(Part::Words(states)))
        .chain(forces.map(Part::Records))
        .chain((!gearbox.shift_elements().is_empty()).then(|| Part::Words(shift_table(gearbox))))
        .chain(one_way_clutches(gearbox, &worked).map(Part::Records))
        .collect();
    let mut warnings = warnings(subject);
    warnings.extend(worked.iter().flat_map(|gear| fast_planets(gearbox, &gear.analysis)));
    warnings.extend(worked.iter().flat_map(|gear| contradictions(gearbox, &gear.analysis)));
    Ok(Report { title: Some(gearbox.name().to_owned()), parts, warnings: Some(warnings) })
}

fn gears(subject: &Subject, worked: &[Worked<'_>], input: Input) -> Records {
    let mut views = vec![View::new("Gears", &["gear", "engaged", "state", "ratio", "exact_ratio", "step"])];
    if !subject.published.is_empty() {
        views.push(View::new("Published ratios", &["gear", "published", "as_published", "agrees", "remark"]));
    }
    views.push(View {
        note: note(subject),
        ..View::new(
            "Losses, and speeds over the input's",
            &["gear", "efficiency", "overrun_efficiency", "self_locking", "circulating", "largest", "planet"],
        )
    });
    if input.speed.is_some() || input.load.is_some() {
        views.push(View::new("Output", &["gear", "output_speed", "output_torque"]));
    }
    Records {
        name: "gears",
        columns: columns(),
        rows: (0..worked.len()).map(|place| row(subject, worked, place, input)).collect(),
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
        Column::number("as_published", "computed"),
        Column::words("agrees", "agrees"),
        Column::words("remark", "remark"),
        Column::number("efficiency", "η"),
        Column::number("overrun_efficiency", "η back"),
        Column::words("self_locking", "self-locking"),
        Column::number("circulating", "circulating"),
        Column::number("largest", "largest |ω|"),
        Column::number("planet", "planet"),
        Column::quantity("output_speed", Dimension::AngularSpeed),
        Column::quantity("output_torque", Dimension::Torque),
    ]
}

fn row(subject: &Subject, worked: &[Worked<'_>], place: usize, input: Input) -> Vec<Figure> {
    let gearbox = &subject.gearbox;
    let Worked { analysis, operation } = &worked[place];
    let gear = analysis.gear();
    let published = subject.published(gear.name());
    let before = place.checked_sub(1).map(|before| &worked[before].analysis);
    let output_speed = analysis.speed(gear.output());
    vec![
        text(gear.name()),
        Figure::Texts(engaged(gearbox, gear)),
        text(gearbox.link_name(gear.input())),
        text(gearbox.link_name(gear.output())),
        Figure::Answer(analysis.state().name(), analysis.state().name()),
        Figure::Texts(analysis.state().links().to_vec()),
        multiple(analysis.ratio()),
        analysis.exact_ratio().map_or(Figure::None, |ratio| Figure::Text(ratio.to_string())),
        multiple(before.and_then(|before| step(before, analysis))),
        published.map_or(Figure::None, published_figure),
        multiple(published.zip(analysis.ratio()).map(|(gear, ratio)| as_published(gear, ratio))),
        published
            .zip(analysis.ratio())
            .map_or(Figure::None, |(gear, ratio)| Figure::YesNo(gear.stands_for(ratio))),
        published.and_then(remark).map_or_else(|| text(""), text),
        moving(analysis.efficiency()),
        moving(analysis.back_driving_efficiency()),
        self_locking(analysis),
        multiple(analysis.driving().map(|case| case.power.circulating)),
        multiple(largest_speed(gearbox, analysis)),
        multiple(largest_planet_speed(analysis)),
        column(input.speed.zip(output_speed).map(|(speed, of)| speed * of)),
        column(operation.as_ref().map(|operation| operation.output)),
    ]
}

/// An efficiency of a gear that moves; none of one that its losses hold.
pub(super) fn moving(efficiency: Option<f64>) -> Figure {
    multiple(efficiency.filter(|efficiency| *efficiency > 0.0))
}

/// From which end a gear is self-locking.
pub(super) fn self_locking(analysis: &Analysis<'_>) -> Figure {
    let from_output = match analysis.is_self_locking() {
        Some(from_output) => from_output,
        None => return Figure::None,
    };
    match (matches!(analysis.state(), State::SelfLocking { .. }), from_output) {
        (false, false) => Figure::Answer("no", "no"),
        (false, true) => Figure::Answer("from_output", "from output"),
        (true, false) => Figure::Answer("from_input", "from input"),
        (true, true) => Figure::Answer("both_ways", "both ways"),
    }
}

/// Names of what is engaged.
pub(super) fn engaged(gearbox: &Gearbox, gear: &Gear) -> Vec<String> {
    gear.engaged().iter().map(|&place| gearbox.shift_elements()[place].id().to_owned()).collect()
}

/// Ratio of the gear before over this one's, between the same links and in the same sense.
fn step(before: &Analysis<'_>, this: &Analysis<'_>) -> Option<f64> {
    let (one, other) = (before.ratio()?, this.ratio()?);
    let between = |analysis: &Analysis| [analysis.gear().input(), analysis.gear().output()];
    (one * other > 0.0 && between(before) == between(this)).then(|| one / other)
}

/// A published ratio with its decimals.
pub(super) fn published_figure(gear: &PublishedGear) -> Figure {
    Figure::Printed(gear.published_ratio.get(), gear.printed_decimals as usize)
}

/// A ratio the way round in which it is published.
pub(super) fn as_published(gear: &PublishedGear, ratio: f64) -> f64 {
    if gear.invert { 1.0 / ratio } else { ratio }
}

/// What is to be known of a published ratio.
fn remark(gear: &PublishedGear) -> Option<String> {
    let all =
        [gear.invert.then_some("output over input"), gear.unverified.then_some("not read in its source")];
    let all: Vec<&str> = all.into_iter().flatten().collect();
    (!all.is_empty()).then(|| all.join(", "))
}

fn largest_speed(gearbox: &Gearbox, analysis: &Analysis<'_>) -> Option<f64> {
    (1..gearbox.links().len()).filter_map(|link| analysis.speeds()[link]).map(f64::abs).reduce(f64::max)
}

fn largest_planet_speed(analysis: &Analysis<'_>) -> Option<f64> {
    let planets = analysis.sets().iter().flat_map(|set| set.planets.iter().flatten());
    planets.map(|planet| planet.relative.abs()).reduce(f64::max)
}

fn note(subject: &Subject) -> String {
    let speeds = "Largest |ω|: of the links. Planet: the largest relative to its carrier.";
    if subject.has_losses() {
        speeds.to_owned()
    } else {
        format!("{speeds} The file states no losses; --efficiency 0.97 gives each set some.")
    }
}

fn states(subject: &Subject, worked: &[Worked<'_>]) -> String {
    let gears = worked.iter().map(|worked| &worked.analysis);
    let not_driven = gears.filter(|analysis| *analysis.state() != State::Driven);
    let line = |analysis: &Analysis<'_>| {
        let name = analysis.gear().name();
        match subject.inputs(name).map(|inputs| inputs.speeds.keys().cloned().collect::<Vec<_>>()) {
            Some(links) if !links.is_empty() => {
                format!(
                    "{name}: settled by the speeds of {}; --gear '{name}' shows its state",
                    links.join(", ")
                )
            }
            _ => format!("{name}: {}", in_words(analysis.state())),
        }
    };
    let lines: String = not_driven.map(|analysis| wrapped(" -", &line(analysis))).collect();
    if lines.is_empty() { lines } else { format!("Not simply driven\n{lines}") }
}

/// A state as a sentence.
pub(super) fn in_words(state: &State) -> String {
    let list = |names: &[String]| names.join(", ");
    let words = match state {
        State::Driven => return "driven".to_owned(),
        State::InputBlocked { links } => format!("the input cannot turn; at rest: {}", list(links)),
        State::OutputAtRest { links } => {
            format!("the output cannot turn while the input can; at rest: {}", list(links))
        }
        State::OutputFree { links } => {
            format!("nothing joins the output to the input; free: {}", list(links))
        }
        State::Underdetermined { missing, links } => {
            let speeds = if *missing == 1 { "one more speed" } else { "more speeds" };
            format!("{speeds} must be given, of {}", list(links))
        }
        State::TorquesIndeterminate { shift_elements, sets, .. } => {
            let of =
                |what: &str, names: &[String]| (!names.is_empty()).then(|| format!("{what} {}", list(names)));
            let parts: Vec<String> =
                [of("shift elements", shift_elements), of("sets", sets)].into_iter().flatten().collect();
            format!("how the torque is shared depends on how tightly they hold: {}", parts.join("; "))
        }
        State::SelfLocking { links, both_ways } => {
            let back = if *both_ways { "; nor does any at the output" } else { "" };
            format!("no torque at the input, {}, moves a load against the mesh losses{back}", list(links))
        }
        // A state that this program does not know yet.
        state => return state.to_string(),
    };
    format!("{}: {words}", state.name())
}

fn shift_table(gearbox: &Gearbox) -> String {
    let mut header = vec!["gear"];
    header.extend(gearbox.shift_elements().iter().map(epicyclic_train::ShiftElement::id));
    let rows = gearbox.gears().iter().map(|gear| {
        let mark = |place| if gear.engaged().contains(&place) { "x" } else { "." }.to_owned();
        let marks = (0..gearbox.shift_elements().len()).map(mark);
        [gear.name().to_owned()].into_iter().chain(marks).collect()
    });
    format!("Shift table\n{}", epicyclic_views::text::table(&header, rows, &[]))
}

/// Planets of a gear that turn faster on their carriers than is usual: more than twice the input's speed.
pub(crate) fn fast_planets(gearbox: &Gearbox, gear: &Analysis<'_>) -> Vec<(&'static str, String)> {
    let fastest = gear.sets().iter().map(|row| {
        row.planets
            .iter()
            .flatten()
            .map(|planet| planet.relative.abs())
            .filter(|speed| *speed > 2.0)
            .reduce(f64::max)
    });
    let of_set = |(row, fastest): (&PlanetSet, Option<f64>)| {
        let (gear, row, speed) = (gear.gear().name(), row.id(), trimmed(fastest?, 4));
        let message = format!(
            "in gear {gear} planet {row} turns at {speed} times the input's speed on its carrier; 2 is the usual limit"
        );
        Some(("planet-speed", message))
    };
    gearbox.sets().iter().zip(fastest).filter_map(of_set).collect()
}

/// What the one-way clutches do in each gear; `None` without any.
fn one_way_clutches(gearbox: &Gearbox, worked: &[Worked<'_>]) -> Option<Records> {
    if !gearbox.shift_elements().iter().any(epicyclic_train::ShiftElement::is_one_way) {
        return None;
    }
    let mut rows = vec![];
    for Worked { analysis, .. } in worked {
        for one in analysis.one_way_clutches() {
            rows.push(vec![
                text(analysis.gear().name()),
                text(gearbox.shift_elements()[one.shift_element].id()),
                Figure::YesNo(one.is_relied_on),
                duty(one.drive),
                duty(one.coast),
                analysis.has_engine_braking().map_or(Figure::None, Figure::YesNo),
            ]);
        }
    }
    Some(Records {
        name: "one_way_clutches",
        columns: vec![
            Column::words("gear", "gear"),
            Column::words("clutch", "clutch"),
            Column::words("relied_on", "relied on"),
            Column::words("drive", "on drive"),
            Column::words("coast", "on coast"),
            Column::words("engine_braking", "engine braking"),
        ],
        rows,
        views: vec![View {
            note: "Engine braking: of gears that rely on one.".to_owned(),
            ..View::new(
                "One-way clutches",
                &["gear", "clutch", "relied_on", "drive", "coast", "engine_braking"],
            )
        }],
        is_answer: false,
    })
}

/// What a one-way clutch does, as an answer.
pub(super) fn duty(duty: Duty) -> Figure {
    match duty {
        Duty::Holds => Figure::Answer("holds", "holds"),
        Duty::Overruns => Figure::Answer("overruns", "overruns"),
        Duty::Idles => Figure::Answer("idles", "idles"),
        Duty::WouldOverrun => Figure::Answer("would_overrun", "would overrun"),
        Duty::WouldHold => Figure::Answer("would_hold", "would hold"),
        Duty::Unknown => Figure::None,
    }
}

/// One-way clutches that do not do what the gear's engaged elements say.
pub(super) fn contradictions(gearbox: &Gearbox, gear: &Analysis<'_>) -> Vec<(&'static str, String)> {
    let name = gear.gear().name();
    let all = gear.one_way_clutches().into_iter().filter_map(|one| {
        let clutch = gearbox.shift_elements()[one.shift_element].id();
        let message = match one.drive {
            Duty::WouldOverrun => format!(
                "gear {name} relies on the one-way clutch {clutch}, whose torque would turn it free: leave it out of \
                 the gear, or turn its links around"
            ),
            Duty::WouldHold => format!(
                "in gear {name} the one-way clutch {clutch} would hold, since its first link would turn slower than \
                 its second: name it in the gear, or turn its links around"
            ),
            _ => return None,
        };
        Some(("one-way-clutch", message))
    });
    all.collect()
}

/// Remarks on the gearbox itself.
pub(super) fn warnings(subject: &Subject) -> Vec<(&'static str, String)> {
    let gearbox = &subject.gearbox;
    use epicyclic_train::Warning;
    let name = |warning: &Warning| match warning {
        Warning::Unreachable { .. } => "unreachable",
        Warning::NoGears => "no-gears",
        Warning::SameTerminals { .. } => "same-terminals",
        Warning::SharedPlanets { .. } => "shared-planets",
        _ => "other",
    };
    let of_gearbox = gearbox.warnings().iter().map(|warning| (name(warning), warning.to_string()));
    // How gears must be arranged is no fault.
    let teeth = gearbox.tooth_checks(&subject.rack).into_iter().filter(|warning| !warning.is_note());
    of_gearbox.chain(teeth.map(|warning| ("teeth", warning.to_string()))).collect()
}

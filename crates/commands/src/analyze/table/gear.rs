//! Everything about one gear.

use super::overview::printed;
use super::planet_bearings;
use super::shared::{engaged, exact, joins, kind, kind_in_words, one_way_clutches, self_locking, state};
use crate::analyze::answer::gear::{
    Link, Mesh, OneGear, Pattern, Powers, PowersOfEntering, RollingPower, Set, Torques, TorquesAtLoad,
    TorquesOfInput,
};
use crate::shared::judgement::table as judgement;
use crate::table::columns::Table;
use crate::table::figure::{Figure, multiple, text};
use crate::table::quantities::quantity;
use crate::table::report::AsReport;
use crate::table::report::{Part, Records, Report, Row, Section, warned};
use epicyclic_train::error::Terminal;
use epicyclic_units::Dimension;

const CASES: &[(&str, &str)] =
    &[("without_losses", "without losses"), ("with_losses", "with losses"), ("at_load", "at the load")];

impl AsReport for OneGear {
    fn report(&self) -> Report {
        let mut parts = vec![Part::Facts(facts(self)), Part::Records(links(self))];
        if !self.planets.is_empty() {
            parts.push(Part::Records(planets(self)));
        }
        let bearings = planet_bearings::records(&self.planet_bearings, &self.operating_point, true);
        parts.extend(bearings.map(Part::Records));
        if !self.shift_elements.is_empty() {
            parts.push(Part::Records(shift_elements(self)));
        }
        if !self.one_way_clutches.is_empty() {
            parts.push(Part::Records(one_way_clutches(&self.one_way_clutches, true)));
        }
        if let Some(found) = &self.torques {
            parts.push(Part::Facts(torques(found, is_held(self))));
            parts.push(Part::Records(sets(&self.sets)));
            parts.push(Part::Records(members(self)));
            parts.push(Part::Records(meshes(&self.meshes)));
        }
        parts.extend(self.powers.as_ref().map(powers).map(Part::Facts));
        if self.patterns.len() > 1 {
            parts.push(Part::Records(patterns(&self.patterns)));
        }
        parts.extend(judgement::parts(&self.judgement));
        Report {
            title: Some(format!("{}, gear {}", self.gearbox, self.gear.gear)),
            parts,
            warnings: warned(&self.warnings),
        }
    }
}

/// Whether no torque where power enters moves the gear.
fn is_held(gear: &OneGear) -> bool {
    let of_entering = gear.powers.as_ref().and_then(|powers| powers.of_entering.as_ref());
    of_entering.is_some_and(|powers| powers.helping.is_some())
}

fn facts(one: &OneGear) -> Section {
    let gear = &one.gear;
    let mut rows = vec![
        Row::new("gear", "gear", "", [text(&gear.gear)]),
        Row::new("engaged", "engaged", "", [Figure::Texts(gear.engaged.clone())]),
        Row::new("input", "input", "", [text(&gear.input)]),
        Row::new("output", "output", "", [text(&gear.output)]),
        Row::new("state", "state", "", [state(gear.state)]),
        Row::new("state_links", "links concerned", "", [Figure::Texts(gear.state_links.clone())]),
        Row::new("ratio", "ratio", "i", [multiple(gear.ratio)]),
        Row::new("exact_ratio", "exactly", "", [exact(gear.exact_ratio)]),
    ];
    if let Some(published) = &gear.published {
        let form = if published.output_over_input { "published, output over input" } else { "published" };
        rows.push(Row::new("published", form, "", [printed(published)]));
        if let Some(agrees) = published.agrees {
            let agrees = if agrees { "agrees" } else { "differs" };
            let remark = if published.unverified { ", not read in its source" } else { "" };
            rows.push(Row {
                remark: format!("{agrees}{remark}"),
                ..Row::new("computed", "computed in the same form", "", [multiple(published.computed)])
            });
        }
    }
    rows.extend([
        Row::new("efficiency", "efficiency", "η", [multiple(gear.efficiency)]),
        Row::new("kreines_efficiency", "the same by Kreines' rule", "", [multiple(gear.kreines_efficiency)]),
        Row::new(
            "back_driving_efficiency",
            "back-driving efficiency",
            "",
            [multiple(gear.back_driving_efficiency)],
        ),
        Row::new("self_locking", "self-locking", "", [self_locking(gear.self_locking)]),
    ]);
    Section { name: "gear", title: "Gear", columns: &[], rows, note: "" }
}

fn links(one: &OneGear) -> Records {
    let mut shown = vec!["link", "members", "speed_of_input"];
    shown.extend(one.operating_point.speed_rad_s.map(|_| "speed"));
    shown.push("power_of_entering");
    if one.links.iter().any(|link| link.power_w.is_some()) {
        shown.push("power");
    }
    Table::new("links", one.links.iter())
        .text("link", "link", |link| &link.link)
        .words("members", "members", |link| made_of(link))
        .multiple("speed_of_input", "ω/ω_in", |link| link.speed_of_input)
        .quantity("speed", "", Dimension::AngularSpeed, |link| link.speed_rad_s)
        .multiple("power_of_entering", "power", |link| link.power_of_entering)
        .quantity("power", "", Dimension::Power, |link| link.power_w)
        .view_of("Links: speed, and power through each over what enters", &shown)
        .records()
}

/// What a link is made of: `input, sun P1, ring P2`.
fn made_of(link: &Link) -> String {
    let terminals = [link.is_input.then_some("input"), link.is_output.then_some("output")];
    let terminals = terminals.into_iter().flatten().map(str::to_owned);
    let members = link.members.iter().map(|member| format!("{} {}", member.member, member.set));
    terminals.chain(members).collect::<Vec<_>>().join(", ")
}

fn planets(one: &OneGear) -> Records {
    let shown: &[&'static str] = if one.operating_point.speed_rad_s.is_some() {
        &["set", "planet", "relative_speed_of_input", "relative_speed", "speed_of_input", "speed"]
    } else {
        &["set", "planet", "relative_speed_of_input", "speed_of_input"]
    };
    let mut without: Vec<&str> =
        one.planets.iter().filter(|planet| !planet.has_teeth).map(|planet| planet.set.as_str()).collect();
    without.dedup();
    let missing = match without.len() {
        0 => String::new(),
        1 => format!("Planet teeth are missing, and with them speeds: set {}.", without[0]),
        _ => format!("Planet teeth are missing, and with them speeds: sets {}.", without.join(", ")),
    };
    Table::new("planets", one.planets.iter())
        .text("set", "set", |planet| &planet.set)
        .text("planet", "planet", |planet| &planet.planet)
        .multiple("relative_speed_of_input", "relative to the carrier", |planet| {
            planet.relative_speed_of_input
        })
        .quantity("relative_speed", "", Dimension::AngularSpeed, |planet| planet.relative_speed_rad_s)
        .multiple("speed_of_input", "planet speed", |planet| planet.speed_of_input)
        .quantity("speed", "", Dimension::AngularSpeed, |planet| planet.speed_rad_s)
        .view_of("Speeds of planets over the input's", shown)
        .note(missing)
        .records()
}

fn shift_elements(one: &OneGear) -> Records {
    let mut shown = vec!["shift_element", "joins", "engaged", "slip_of_input"];
    shown.extend(one.operating_point.speed_rad_s.map(|_| "slip"));
    if one.torques.is_some() {
        shown.extend(["ideal_torque_of_input", "torque_of_input"]);
    }
    if at_load(one).is_some() {
        shown.push("torque");
    }
    let note = if one.torques.is_some() {
        "Slip: speed of the first link less that of the second. T: torque on the first link over the input's torque, \
         without losses and with."
    } else {
        "Slip: speed of the first link less that of the second."
    };
    Table::new("shift_elements", one.shift_elements.iter())
        .text("shift_element", "element", |element| &element.element.shift_element)
        .words("kind", "kind", |element| kind(element.element.kind))
        .words("joins", "joins", |element| joins(&element.element.links))
        .words("engaged", "is", |element| engaged(element.does.engaged))
        .multiple("slip_of_input", "slip", |element| element.does.slip_of_input)
        .quantity("slip", "", Dimension::AngularSpeed, |element| element.does.slip_rad_s)
        .multiple("ideal_torque_of_input", "ideal T", |element| element.does.ideal_torque_of_input)
        .multiple("torque_of_input", "T", |element| element.does.torque_of_input)
        .quantity("torque", "", Dimension::Torque, |element| element.does.torque_n_m)
        .view_of("Shift elements", &shown)
        .note(note.to_owned())
        .records()
}

fn at_load(one: &OneGear) -> Option<&TorquesAtLoad> {
    one.torques.as_ref()?.at_load.as_ref()
}

fn torques(torques: &Torques, is_held: bool) -> Section {
    let row = |name, label, of: fn(&TorquesOfInput) -> f64, at: fn(&TorquesAtLoad) -> f64| {
        let with_losses = torques.with_losses.as_ref().map(of);
        let mut cells = vec![multiple(Some(of(&torques.without_losses))), multiple(with_losses)];
        cells.extend(torques.at_load.as_ref().map(|load| quantity(Dimension::Torque, at(load))));
        Row::new(name, label, "", cells)
    };
    Section {
        name: "torques",
        title: "Torques on the gearbox, over the input's",
        columns: &CASES[..2 + usize::from(torques.at_load.is_some())],
        rows: vec![
            row("input", "at the input", |case| case.input, |load| load.input_n_m),
            row("output", "at the output", |case| case.output, |load| load.output_n_m),
            row("housing", "from the housing", |case| case.housing, |load| load.housing_n_m),
        ],
        note: if is_held {
            "With losses: the torques at which it just moves, the output helped along. With less there the meshes \
             hold it, whatever the input's torque."
        } else {
            ""
        },
    }
}

fn sets(sets: &[Set]) -> Records {
    let shown = [
        "set",
        "kind",
        "basic_ratio",
        "exact_ratio",
        "efficiency",
        "rolling_power_of_entering",
        "loss_of_entering",
    ];
    let note = "Rolling power: through the meshes, seen from the carrier, over what enters; from the first central \
                   gear to the second. i₀, η₀: basic ratio, and efficiency with the carrier fixed, of sets with two \
                   central gears.";
    Table::new("sets", sets.iter())
        .text("set", "set", |set| &set.set)
        .words("kind", "kind", |set| Figure::choice(set.kind, kind_in_words(set.kind)))
        .multiple("basic_ratio", "i₀", |set| set.basic_ratio)
        .number("exact_ratio", "exact", |set| exact(set.exact_ratio))
        .multiple("efficiency", "η₀", |set| set.efficiency)
        .words("rolling_power_runs", "rolling power runs", |set| set.rolling_power_runs.map(runs))
        .words("kreines_exponents", "x", |set| {
            set.kreines_exponents.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
        })
        .multiple("rolling_power_of_entering", "rolling", |set| set.rolling_power_of_entering)
        .multiple("loss_of_entering", "loss", |set| set.loss_of_entering)
        .view_of("Planet sets", &shown)
        .note(note)
        .records()
}

fn runs(direction: RollingPower) -> Figure {
    let words = match direction {
        RollingPower::None => "none",
        RollingPower::FirstToSecond => "first to second",
        RollingPower::SecondToFirst => "second to first",
    };
    Figure::choice(direction, words)
}

/// Torques and powers of every member of every set.
fn members(one: &OneGear) -> Records {
    let mut shown = vec!["set", "member", "link", "ideal_torque_of_input"];
    if one.has_losses {
        shown.push("torque_of_input");
    }
    if at_load(one).is_some() {
        shown.push("torque");
    }
    shown.push("power_of_entering");
    let circulating = one.powers.as_ref().and_then(|powers| powers.of_entering.as_ref());
    if circulating.is_some_and(|powers| powers.circulating > 0.0) {
        shown.push("circulating_of_entering");
    }
    let note = "T: over the input's torque, without losses and with. Power: over what enters the gear; positive \
                   where it enters the set.";
    Table::new("members", one.members.iter())
        .text("set", "set", |member| &member.set)
        .text("member", "member", |member| &member.member)
        .text("link", "link", |member| &member.link)
        .multiple("ideal_torque_of_input", "ideal T", |member| member.ideal_torque_of_input)
        .multiple("torque_of_input", "T", |member| member.torque_of_input)
        .quantity("torque", "", Dimension::Torque, |member| member.torque_n_m)
        .multiple("power_of_entering", "power", |member| member.power_of_entering)
        .multiple("circulating_of_entering", "circulating", |member| member.circulating_of_entering)
        .view_of("Members of the sets", &shown)
        .note(note)
        .records()
}

/// Power through every mesh.
fn meshes(meshes: &[Mesh]) -> Records {
    Table::new("meshes", meshes.iter())
        .text("set", "set", |mesh| &mesh.set)
        .text("from", "from", |mesh| &mesh.from)
        .text("to", "to", |mesh| &mesh.to)
        .multiple("efficiency", "η", |mesh| mesh.efficiency)
        .multiple("enters_of_entering", "enters", |mesh| mesh.enters_of_entering)
        .multiple("leaves_of_entering", "leaves", |mesh| mesh.leaves_of_entering)
        .view(
            "Power through the meshes over what enters the gear, seen from the carriers",
            "set from to efficiency enters_of_entering leaves_of_entering",
        )
        .note("In the direction of the power.")
        .records()
}

fn powers(powers: &Powers) -> Section {
    let of = |figure: fn(&PowersOfEntering) -> Option<f64>| {
        vec![multiple(powers.of_entering.as_ref().and_then(figure))]
    };
    let leaving = match &powers.of_entering {
        Some(PowersOfEntering { helping: Some(_), .. }) => {
            let label = match powers.enters_at {
                Terminal::Input => "enters at the output too",
                Terminal::Output => "enters at the input too",
            };
            Row::new("helping", label, "", of(|powers| powers.helping))
        }
        _ => Row::new("leaving", "leaves", "", of(|powers| powers.leaving)),
    };
    let mut rows = vec![
        leaving,
        Row::new("loss", "lost in the meshes", "", of(|powers| Some(powers.loss))),
        Row::new("circulating", "circulates", "", of(|powers| Some(powers.circulating))),
        Row::new("largest", "largest of any member", "", of(|powers| Some(powers.largest))),
    ];
    if let Some(load) = &powers.at_load {
        let watts = [load.leaving_w, load.loss_w, load.circulating_w, load.largest_w];
        for (row, watts) in rows.iter_mut().zip(watts) {
            row.cells.push(quantity(Dimension::Power, watts));
        }
        let entering = [Figure::Multiple(1.0), quantity(Dimension::Power, load.entering_w)];
        let remark = match powers.enters_at {
            Terminal::Input => String::new(),
            Terminal::Output => "at the output".to_owned(),
        };
        rows.insert(0, Row { remark, ..Row::new("entering", "enters", "", entering) });
    }
    const COLUMNS: &[(&str, &str)] = &[("of_entering", "over what enters"), ("at_load", "at the load")];
    Section {
        name: "powers",
        title: "Powers, with losses",
        columns: &COLUMNS[..1 + usize::from(powers.at_load.is_some())],
        rows,
        note: "",
    }
}

fn patterns(patterns: &[Pattern]) -> Records {
    let mark = |sign: &i8| match sign {
        0 => "0",
        1 => "+",
        _ => "-",
    };
    Table::new("patterns", patterns.iter())
        .words("signs", "sets", |pattern| {
            let sets = pattern.sets.iter();
            let sets =
                sets.map(|set| format!("{} {}", set.set, set.signs.iter().map(mark).collect::<String>()));
            text(sets.collect::<Vec<_>>().join(", "))
        })
        .multiple("efficiency", "η", |pattern| pattern.efficiency)
        .words("chosen", "chosen", |pattern| pattern.chosen)
        .view(
            "Self-consistent sign patterns of the losses (+: from the first gear to the others)",
            "signs efficiency chosen",
        )
        .records()
}

//! Gears with several inputs, at one point or over a map.

use super::shared::{column, count, engaged, joins, kind, quantity};
use crate::analyze::answer::inputs::map::{Map, MapEntry, SpeedMap};
use crate::analyze::answer::inputs::{Inputs, Link, Member, Mesh, Planet, Powers, ShiftElement, Terminal};
use crate::table::figure::{Figure, multiple, text};
use crate::table::report::AsReport;
use crate::table::report::{
    Column, Part, Records, Report, Row, Section, Text, View, checked_rows_as_csv, warned,
};
use epicyclic_units::Dimension;
use std::io;

impl AsReport for Inputs {
    fn report(&self) -> Report {
        let mut parts = vec![Part::Facts(facts(self)), Part::Records(links(self))];
        if !self.planets.is_empty() {
            parts.push(Part::Records(planets(&self.planets)));
        }
        if !self.shift_elements.is_empty() {
            parts.push(Part::Records(shift_elements(self)));
        }
        match &self.powers {
            Some(found) => {
                parts.push(Part::Records(terminals(self)));
                parts.push(Part::Records(members(&self.members)));
                parts.push(Part::Records(meshes(&self.meshes)));
                parts.push(Part::Facts(powers(found)));
            }
            None => parts.push(Part::Text(Text::paragraph(
                "--torques engine=100N·m, or torques of the gear in the file, adds torques and powers.",
            ))),
        }
        Report {
            title: Some(format!("{}, gear {}", self.gearbox, self.gear.gear)),
            parts,
            warnings: warned(&self.warnings),
        }
    }
}

fn facts(inputs: &Inputs) -> Section {
    let gear = &inputs.gear;
    Section {
        name: "gear",
        title: "Gear",
        columns: &[],
        rows: vec![
            Row::new("gear", "gear", "", [text(&gear.gear)]),
            Row::new("engaged", "engaged", "", [Figure::Texts(gear.engaged.clone())]),
            Row::new("input", "input", "", [text(&gear.input)]),
            Row::new("output", "output", "", [text(&gear.output)]),
            Row::new("freedoms", "freedoms", "", [count(gear.freedoms)]),
        ],
        note: "",
    }
}

fn links(inputs: &Inputs) -> Records {
    let row = |link: &Link| {
        vec![
            text(&link.link),
            column(link.speed_rad_s, Dimension::AngularSpeed),
            Figure::YesNo(link.given),
            column(link.power_w, Dimension::Power),
        ]
    };
    let mut shown = vec!["link", "speed", "given"];
    shown.extend(inputs.powers.as_ref().map(|_| "power"));
    Records {
        name: "links",
        columns: vec![
            Column::words("link", "link"),
            Column::quantity("speed", Dimension::AngularSpeed),
            Column::words("given", "given"),
            Column::quantity("power", Dimension::Power),
        ],
        rows: inputs.links.iter().map(row).collect(),
        views: vec![View::new("Links: speed, and power through each", &shown)],
        is_answer: true,
    }
}

fn planets(planets: &[Planet]) -> Records {
    let row = |planet: &Planet| {
        vec![
            text(&planet.set),
            text(&planet.planet),
            column(planet.relative_speed_rad_s, Dimension::AngularSpeed),
            column(planet.speed_rad_s, Dimension::AngularSpeed),
        ]
    };
    Records {
        name: "planets",
        columns: vec![
            Column::words("set", "set"),
            Column::words("planet", "planet"),
            Column::headed("relative_speed", "relative to the carrier, rpm", Dimension::AngularSpeed),
            Column::headed("speed", "planet speed, rpm", Dimension::AngularSpeed),
        ],
        rows: planets.iter().map(row).collect(),
        views: vec![View::new("Speeds of planets", &["set", "planet", "relative_speed", "speed"])],
        is_answer: false,
    }
}

fn shift_elements(inputs: &Inputs) -> Records {
    let row = |element: &ShiftElement| {
        vec![
            text(&element.shift_element),
            kind(element.kind),
            joins(&element.links),
            engaged(element.engaged),
            column(element.slip_rad_s, Dimension::AngularSpeed),
            column(element.torque_n_m, Dimension::Torque),
        ]
    };
    let mut shown = vec!["shift_element", "joins", "engaged", "slip"];
    shown.extend(inputs.powers.as_ref().map(|_| "torque"));
    let note = if inputs.powers.is_some() {
        "Slip: speed of the first link less that of the second. Torque: on the first link."
    } else {
        "Slip: speed of the first link less that of the second."
    };
    Records {
        name: "shift_elements",
        columns: vec![
            Column::words("shift_element", "element"),
            Column::words("kind", "kind"),
            Column::words("joins", "joins"),
            Column::words("engaged", "is"),
            Column::headed("slip", "slip, rpm", Dimension::AngularSpeed),
            Column::headed("torque", "torque, N·m", Dimension::Torque),
        ],
        rows: inputs.shift_elements.iter().map(row).collect(),
        views: vec![View { note: note.to_owned(), ..View::new("Shift elements", &shown) }],
        is_answer: false,
    }
}

fn terminals(inputs: &Inputs) -> Records {
    let row = |end: &Terminal| {
        let torque = column(Some(end.torque_n_m), Dimension::Torque);
        vec![text(&end.link), torque, column(Some(end.power_w), Dimension::Power)]
    };
    let housing = vec![text("ground"), column(inputs.housing_torque_n_m, Dimension::Torque), Figure::None];
    Records {
        name: "terminals",
        columns: vec![
            Column::words("link", "link"),
            Column::quantity("torque", Dimension::Torque),
            Column::quantity("power", Dimension::Power),
        ],
        rows: inputs.terminals.iter().map(row).chain([housing]).collect(),
        views: vec![View {
            note: "Torque on the gearbox from outside; power positive where it enters. ground: the housing."
                .to_owned(),
            ..View::new("Where power enters and leaves", &["link", "torque", "power"])
        }],
        is_answer: false,
    }
}

fn members(members: &[Member]) -> Records {
    let row = |member: &Member| {
        vec![
            text(&member.set),
            text(&member.member),
            text(&member.link),
            column(Some(member.torque_n_m), Dimension::Torque),
            column(member.power_w, Dimension::Power),
        ]
    };
    Records {
        name: "members",
        columns: vec![
            Column::words("set", "set"),
            Column::words("member", "member"),
            Column::words("link", "link"),
            Column::quantity("torque", Dimension::Torque),
            Column::quantity("power", Dimension::Power),
        ],
        rows: members.iter().map(row).collect(),
        views: vec![View {
            note: "Power positive where it enters the set.".to_owned(),
            ..View::new("Members of the sets", &["set", "member", "link", "torque", "power"])
        }],
        is_answer: false,
    }
}

fn meshes(meshes: &[Mesh]) -> Records {
    let row = |mesh: &Mesh| {
        vec![
            text(&mesh.set),
            text(&mesh.from),
            text(&mesh.to),
            Figure::Multiple(mesh.efficiency),
            column(mesh.enters_w, Dimension::Power),
            column(mesh.leaves_w, Dimension::Power),
        ]
    };
    Records {
        name: "meshes",
        columns: vec![
            Column::words("set", "set"),
            Column::words("from", "from"),
            Column::words("to", "to"),
            Column::number("efficiency", "η"),
            Column::headed("enters", "enters, kW", Dimension::Power),
            Column::headed("leaves", "leaves, kW", Dimension::Power),
        ],
        rows: meshes.iter().map(row).collect(),
        views: vec![View::new(
            "Power through the meshes, seen from the carriers",
            &["set", "from", "to", "efficiency", "enters", "leaves"],
        )],
        is_answer: false,
    }
}

fn powers(powers: &Powers) -> Section {
    let row = |name, label, watts| Row::new(name, label, "", [quantity(watts, Dimension::Power)]);
    Section {
        name: "powers",
        title: "Powers, with losses",
        columns: &[],
        rows: vec![
            row("entering", "enters", powers.entering_w),
            row("leaving", "leaves", powers.leaving_w),
            row("loss", "lost in the meshes", powers.loss_w),
            row("circulating", "circulates", powers.circulating_w),
            Row::new("efficiency", "efficiency", "η", [multiple(powers.efficiency)]),
        ],
        note: "",
    }
}

impl AsReport for Map {
    fn report(&self) -> Report {
        let mut shown = vec!["first_speed", "second_speed", "link", "speed"];
        let mut note = "";
        if !self.torques.is_empty() {
            shown.extend(["torque", "power"]);
            note = "Torque: from outside, of links where power enters or leaves. Power: through each link.";
        }
        let records = Records {
            name: "map",
            columns: map_columns(&self.first_link, &self.second_link),
            rows: self.map.iter().map(map_row).collect(),
            views: vec![View { note: note.to_owned(), ..View::new("Map over two speeds", &shown) }],
            is_answer: true,
        };
        Report {
            title: Some(format!("{}, gear {}", self.gearbox, self.gear)),
            parts: vec![Part::Records(records)],
            warnings: warned(&self.warnings),
        }
    }
}

fn map_columns(first: &str, second: &str) -> Vec<Column> {
    vec![
        Column::headed("first_speed", format!("{first}, rpm"), Dimension::AngularSpeed),
        Column::headed("second_speed", format!("{second}, rpm"), Dimension::AngularSpeed),
        Column::words("link", "link"),
        Column::quantity("speed", Dimension::AngularSpeed),
        Column::quantity("torque", Dimension::Torque),
        Column::quantity("power", Dimension::Power),
        Column::number("efficiency", "η"),
    ]
}

fn map_row(entry: &MapEntry) -> Vec<Figure> {
    vec![
        column(Some(entry.first_speed_rad_s), Dimension::AngularSpeed),
        column(Some(entry.second_speed_rad_s), Dimension::AngularSpeed),
        text(&entry.link),
        column(entry.speed_rad_s, Dimension::AngularSpeed),
        column(entry.torque_n_m, Dimension::Torque),
        column(entry.power_w, Dimension::Power),
        multiple(entry.efficiency),
    ]
}

/// A map as CSV, each line when it is calculated.
///
/// # Errors
/// Those of the writer and of the places; a number too large for its unit.
pub fn map_csv(map: &SpeedMap<'_>, out: impl io::Write) -> io::Result<()> {
    // Headings are of tables alone.
    let rows = map.entries().map(|entry| entry.map(|entry| map_row(&entry)));
    checked_rows_as_csv("map", &map_columns("", ""), rows, out)
}

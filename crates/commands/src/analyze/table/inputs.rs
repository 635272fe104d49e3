//! Gears with several inputs, at one point or over a map.

use super::shared::{engaged, joins, kind};
use crate::analyze::answer::inputs::map::{Map, MapEntry, SpeedMap};
use crate::analyze::answer::inputs::{Inputs, Member, Mesh, Planet, Powers};
use crate::shared::judgement::table as judgement;
use crate::table::columns::Table;
use crate::table::figure::{Figure, count, multiple, text};
use crate::table::quantities::quantity;
use crate::table::report::AsReport;
use crate::table::report::{Part, Records, Report, Row, Section, Text, checked_rows_as_csv, warned};
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
        parts.extend(judgement::parts(&self.judgement));
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
    let mut shown = vec!["link", "speed", "given"];
    shown.extend(inputs.powers.as_ref().map(|_| "power"));
    Table::new("links", inputs.links.iter())
        .text("link", "link", |link| &link.link)
        .quantity("speed", "", Dimension::AngularSpeed, |link| link.speed_rad_s)
        .words("given", "given", |link| link.given)
        .quantity("power", "", Dimension::Power, |link| link.power_w)
        .view_of("Links: speed, and power through each", &shown)
        .the_answer()
        .records()
}

fn planets(planets: &[Planet]) -> Records {
    Table::new("planets", planets.iter())
        .text("set", "set", |planet| &planet.set)
        .text("planet", "planet", |planet| &planet.planet)
        .quantity("relative_speed", "relative to the carrier", Dimension::AngularSpeed, |planet| {
            planet.relative_speed_rad_s
        })
        .quantity("speed", "planet speed", Dimension::AngularSpeed, |planet| planet.speed_rad_s)
        .view("Speeds of planets", "set planet relative_speed speed")
        .records()
}

fn shift_elements(inputs: &Inputs) -> Records {
    let mut shown = vec!["shift_element", "joins", "engaged", "slip"];
    shown.extend(inputs.powers.as_ref().map(|_| "torque"));
    let note = if inputs.powers.is_some() {
        "Slip: speed of the first link less that of the second. Torque: on the first link."
    } else {
        "Slip: speed of the first link less that of the second."
    };
    Table::new("shift_elements", inputs.shift_elements.iter())
        .text("shift_element", "element", |element| &element.shift_element)
        .words("kind", "kind", |element| kind(element.kind))
        .words("joins", "joins", |element| joins(&element.links))
        .words("engaged", "is", |element| engaged(element.engaged))
        .quantity("slip", "slip", Dimension::AngularSpeed, |element| element.slip_rad_s)
        .quantity("torque", "torque", Dimension::Torque, |element| element.torque_n_m)
        .view_of("Shift elements", &shown)
        .note(note.to_owned())
        .records()
}

fn terminals(inputs: &Inputs) -> Records {
    let ends = inputs.terminals.iter().map(|end| (&*end.link, Some(end.torque_n_m), Some(end.power_w)));
    let housing = ("ground", inputs.housing_torque_n_m, None);
    Table::new("terminals", ends.chain([housing]))
        .text("link", "link", |(link, ..)| link)
        .quantity("torque", "", Dimension::Torque, |(_, torque, _)| *torque)
        .quantity("power", "", Dimension::Power, |(_, _, power)| *power)
        .all("Where power enters and leaves")
        .note("Torque on the gearbox from outside; power positive where it enters. ground: the housing.")
        .records()
}

fn members(members: &[Member]) -> Records {
    Table::new("members", members.iter())
        .text("set", "set", |member| &member.set)
        .text("member", "member", |member| &member.member)
        .text("link", "link", |member| &member.link)
        .quantity("torque", "", Dimension::Torque, |member| member.torque_n_m)
        .quantity("power", "", Dimension::Power, |member| member.power_w)
        .view("Members of the sets", "set member link torque power")
        .note("Power positive where it enters the set.")
        .records()
}

fn meshes(meshes: &[Mesh]) -> Records {
    Table::new("meshes", meshes.iter())
        .text("set", "set", |mesh| &mesh.set)
        .text("from", "from", |mesh| &mesh.from)
        .text("to", "to", |mesh| &mesh.to)
        .multiple("efficiency", "η", |mesh| mesh.efficiency)
        .quantity("enters", "enters", Dimension::Power, |mesh| mesh.enters_w)
        .quantity("leaves", "leaves", Dimension::Power, |mesh| mesh.leaves_w)
        .view("Power through the meshes, seen from the carriers", "set from to efficiency enters leaves")
        .records()
}

fn powers(powers: &Powers) -> Section {
    let row = |name, label, watts| Row::new(name, label, "", [quantity(Dimension::Power, watts)]);
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
        let records = map(&self.first_link, &self.second_link, &self.map)
            .view_of("Map over two speeds", &shown)
            .note(note)
            .the_answer()
            .records();
        Report {
            title: Some(format!("{}, gear {}", self.gearbox, self.gear)),
            parts: [Part::Records(records)].into_iter().chain(judgement::parts(&self.judgement)).collect(),
            warnings: warned(&self.warnings),
        }
    }
}

fn map<'e>(first: &str, second: &str, entries: &'e [MapEntry]) -> Table<&'e MapEntry> {
    Table::new("map", entries)
        .quantity("first_speed", first, Dimension::AngularSpeed, |entry| entry.first_speed_rad_s)
        .quantity("second_speed", second, Dimension::AngularSpeed, |entry| entry.second_speed_rad_s)
        .text("link", "link", |entry| &entry.link)
        .quantity("speed", "", Dimension::AngularSpeed, |entry| entry.speed_rad_s)
        .quantity("torque", "", Dimension::Torque, |entry| entry.torque_n_m)
        .quantity("power", "", Dimension::Power, |entry| entry.power_w)
        .multiple("efficiency", "η", |entry| entry.efficiency)
}

/// A map as CSV, each line when it is calculated.
///
/// # Errors
/// Those of the writer and of the places; a number too large for its unit.
pub fn map_csv(of: &SpeedMap<'_>, out: impl io::Write) -> io::Result<()> {
    // Headings are of tables alone.
    checked_rows_as_csv(of.entries(), |entries| map("", "", entries).records(), out)
}

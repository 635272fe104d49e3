//! A gearbox in motion as tables, CSV and plots.

mod plots;
mod sweep;

use crate::shared::judgement::table as judgement;
use crate::simulate::answer::{
    ChangeKind, ChangeRecord, ConverterResult, DragKind, DragResult, ElementKind, ElementResult, ShaftResult,
    ShiftResult, Simulation, State,
};
use crate::table::columns::Table;
use crate::table::figure::Figure;
use crate::table::quantities::{column, quantity};
use crate::table::report::AsReport;
use crate::table::report::{Column, Part, Records, Report, Row, Section, View, warned};
use epicyclic_units::Dimension::{
    self, AngularSpeed, Energy, EnergyPerArea, Power, PowerPerArea, TemperatureDifference, Time, Torque,
};
pub use plots::{capacities, picture, speeds, temperatures, torques};

/// A quantity of a picture over time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum PlotView {
    /// Speeds of all links, with the events.
    Speeds,
    /// Torques of shift elements and of the output.
    Torques,
    /// Capacities of brakes and clutches.
    Capacities,
    /// Temperatures of brakes and clutches over the oil.
    Temperatures,
}

impl AsReport for Simulation {
    fn report(&self) -> Report {
        let mut parts = vec![];
        if !self.events.is_empty() {
            parts.push(Part::Records(events(self)));
        }
        if !self.shifts.is_empty() {
            parts.push(Part::Records(of_shifts(&self.shifts)));
        }
        if !self.elements.is_empty() {
            parts.push(Part::Records(elements(&self.elements)));
        }
        if !self.drags.is_empty() {
            parts.push(Part::Records(drags(&self.drags)));
        }
        if !self.shafts.is_empty() {
            parts.push(Part::Records(shafts(&self.shafts)));
        }
        if !self.converters.is_empty() {
            parts.push(Part::Records(converters(&self.converters)));
        }
        parts.push(Part::Records(end(self)));
        parts.push(Part::Facts(energies(self)));
        parts.extend(judgement::parts(&self.judgement));
        Report {
            title: Some(format!("{}: {} in motion", self.scenario, self.gearbox)),
            parts,
            warnings: warned(&self.warnings),
        }
    }
}

/// The state of an element or a set, in words.
#[must_use]
pub fn state(state: State) -> &'static str {
    match state {
        State::Open => "open",
        State::SlipsForward => "slips +",
        State::SlipsBackward => "slips −",
        State::Holds => "holds",
        State::DrivesForward => "drives +",
        State::DrivesBackward => "drives −",
    }
}

/// How a set with losses rolls, in words.
fn rolling(state: State) -> &'static str {
    match state {
        State::SlipsForward => "rolls +",
        State::SlipsBackward => "rolls −",
        _ => "turns as a block",
    }
}

/// A change in words: `clutch: open → slips +`.
#[must_use]
pub fn change(change: &ChangeRecord) -> String {
    match (change.from.zip(change.to), change.is_rising) {
        (Some((from, to)), _) if change.kind == ChangeKind::Set => {
            format!("{}: {} → {}", change.id, rolling(from), rolling(to))
        }
        (Some((from, to)), _) if change.kind == ChangeKind::Shaft => {
            let contact = |of| if of == State::Open { "free" } else { state(of) };
            format!("{}: {} → {}", change.id, contact(from), contact(to))
        }
        (Some((from, to)), _) if change.kind == ChangeKind::Drag => {
            format!("drag of {}: {} → {}", change.id, state(from), state(to))
        }
        (Some((from, to)), _) => format!("{}: {} → {}", change.id, state(from), state(to)),
        (None, Some(true)) => format!("{}: passed upwards", change.id),
        (None, _) => format!("{}: passed downwards", change.id),
    }
}

fn kind(kind: ChangeKind) -> &'static str {
    match kind {
        ChangeKind::Element => "element",
        ChangeKind::Set => "set",
        ChangeKind::Shaft => "shaft",
        ChangeKind::Drag => "drag",
        ChangeKind::Threshold => "threshold",
    }
}

fn events(simulation: &Simulation) -> Records {
    let speed = |speeds: &[f64], link: &str| {
        let place = simulation.end.iter().position(|one| one.link == link);
        column(AngularSpeed, place.and_then(|place| speeds.get(place).copied()))
    };
    Table::new(
        "events",
        simulation.events.iter().flat_map(|event| event.changes.iter().map(move |one| (event, one))),
    )
    .quantity("time", "t", Time, |(event, _)| event.time_s)
    .words("change", "what changes", |(_, one)| change(one))
    .for_people()
    .words("kind", "kind", |(_, one)| Figure::choice(one.kind, kind(one.kind)))
    .text("id", "of", |(_, one)| &one.id)
    .words("from", "from", |(_, one)| one.from.map(|from| Figure::choice(from, state(from))))
    .words("to", "to", |(_, one)| one.to.map(|to| Figure::choice(to, state(to))))
    .words("is_rising", "upwards", |(_, one)| one.is_rising)
    .column(
        Column::headed("input_speed", format!("{}, rpm", simulation.input), AngularSpeed),
        |(event, _)| speed(&event.speeds_rad_s, &simulation.input),
    )
    .column(
        Column::headed("output_speed", format!("{}, rpm", simulation.output), AngularSpeed),
        |(event, _)| speed(&event.speeds_rad_s, &simulation.output),
    )
    .view("Events", "time change input_speed output_speed")
    .records()
}

fn per_cent(share: Option<f64>) -> Figure {
    share.map_or(Figure::None, |share| Figure::Printed(100.0 * share, 1))
}

fn of_shifts(all: &[ShiftResult]) -> Records {
    let note =
        "T: what sets and shift elements exert on the output, from the beginning of the shift to its lock.";
    Table::new("shifts", all.iter())
        .words("shift", "shift", |shift| format!("{} → {}", shift.from, shift.to))
        .quantity("at", "at", Time, |shift| shift.at_s)
        .quantity("shift_time", "takes", Time, |shift| shift.shift_time_s)
        .headed("torque_phase", "torque phase", Time, |shift| shift.torque_phase_s)
        .headed("inertia_phase", "inertia phase", Time, |shift| shift.inertia_phase_s)
        .quantity("output_torque_before", "T before", Torque, |shift| shift.output_torque_before_n_m)
        .headed("output_torque_least", "least", Torque, |shift| shift.output_torque_least_n_m)
        .headed("output_torque_greatest", "greatest", Torque, |shift| shift.output_torque_greatest_n_m)
        .number("torque_hole_percent", "hole, %", |shift| per_cent(shift.torque_hole))
        .number("torque_surge_percent", "surge, %", |shift| per_cent(shift.torque_surge))
        .quantity("heat", "heat", Energy, |shift| shift.heat_j)
        .quantity("locked", "locked", Time, |shift| shift.locked_s)
        .words("released", "released", |shift| shift.released.clone())
        .words("applied", "applied", |shift| shift.applied.clone())
        .view("Shifts", "shift at shift_time torque_phase inertia_phase heat released applied")
        .view(
            "Torque of the output while it shifts",
            "shift output_torque_before output_torque_least output_torque_greatest \
                     torque_hole_percent torque_surge_percent",
        )
        .note(note)
        .records()
}

fn kind_of(kind: ElementKind) -> &'static str {
    match kind {
        ElementKind::Brake => "brake",
        ElementKind::Clutch => "clutch",
        ElementKind::OneWayClutch => "one-way",
        ElementKind::DogClutch => "dogs",
        ElementKind::Resistance => "resistance",
    }
}

fn elements(all: &[ElementResult]) -> Records {
    let has = |of: fn(&ElementResult) -> Option<f64>| all.iter().any(|one| of(one).is_some());
    let mut views = vec![View {
        note: "P, T: the greatest power of friction and torque. + and −: the first link is faster, slower."
            .to_owned(),
        ..View::new(
            "Shift elements and resistances",
            &["id", "kind", "at_end", "slip_time", "heat", "peak_power", "peak_torque"],
        )
    }];
    if has(|one| one.heat_per_area_j_m2) || has(|one| one.peak_temperature_rise_k) {
        views.push(View {
            note: "K: over the temperature of the oil, greatest and at the end.".to_owned(),
            ..View::new(
                "Load of the friction surfaces",
                &[
                    "id",
                    "heat_per_area",
                    "peak_power_per_area",
                    "peak_temperature_rise",
                    "end_temperature_rise",
                ],
            )
        });
    }
    Table::new("elements", all.iter())
        .text("id", "element", |one| &one.id)
        .words("kind", "kind", |one| Figure::choice(one.kind, kind_of(one.kind)))
        .words("links", "between", |one| format!("{}–{}", one.links[0], one.links[1]))
        .words("at_end", "at the end", |one| Figure::choice(one.at_end, state(one.at_end)))
        .quantity("slip_time", "slips", Time, |one| one.slip_time_s)
        .quantity("heat", "heat", Energy, |one| one.heat_j)
        .quantity("peak_power", "P", Power, |one| one.peak_power_w)
        .quantity("peak_torque", "T", Torque, |one| one.peak_torque_n_m)
        .quantity("heat_per_area", "", EnergyPerArea, |one| one.heat_per_area_j_m2)
        .quantity("peak_power_per_area", "", PowerPerArea, |one| one.peak_power_per_area_w_m2)
        .quantity("peak_temperature_rise", "greatest", TemperatureDifference, |one| {
            one.peak_temperature_rise_k
        })
        .quantity("end_temperature_rise", "end", TemperatureDifference, |one| one.end_temperature_rise_k)
        .views(views)
        .records()
}

fn drags(all: &[DragResult]) -> Records {
    let kind = |kind| match kind {
        DragKind::Drag => "drag",
        DragKind::OpenElement => "open",
    };
    let note = "open: a brake or clutch while it is open or slips. P, M: the greatest power and torque. At the end: speed of the first link relative \
               to the second, and torque on the first.";
    Table::new("drags", all.iter())
        .words("kind", "kind", |one| Figure::choice(one.kind, kind(one.kind)))
        .text("id", "of", |one| &one.id)
        .words("links", "between", |one| one.links.join("–"))
        .quantity("loss", "loss", Energy, |one| one.loss_j)
        .quantity("peak_power", "P", Power, |one| one.peak_power_w)
        .quantity("peak_torque", "M", Torque, |one| one.peak_torque_n_m)
        .headed("end_slip", "n at the end", AngularSpeed, |one| one.end_slip_rad_s)
        .headed("end_torque", "M at the end", Torque, |one| one.end_torque_n_m)
        .view("Drags", "kind id links loss peak_power peak_torque end_slip end_torque")
        .note(note)
        .records()
}

fn shafts(all: &[ShaftResult]) -> Records {
    Table::new("shafts", all.iter())
        .text("id", "shaft", |one| &one.id)
        .words("links", "between", |one| one.links.join("–"))
        .quantity("peak_torque", "T", Torque, |one| one.peak_torque_n_m)
        .quantity("peak_twist", "twist", Dimension::Angle, |one| one.peak_twist_rad)
        .headed("end_torque", "T at the end", Torque, |one| one.end_torque_n_m)
        .headed("end_twist", "twist at the end", Dimension::Angle, |one| one.end_twist_rad)
        .quantity("heat", "heat", Energy, |one| one.heat_j)
        .view("Elastic shafts", "id peak_torque peak_twist end_torque end_twist heat")
        .note("T, twist: the greatest; heat: of the damper.")
        .records()
}

fn converters(all: &[ConverterResult]) -> Records {
    let shown = ["id", "peak_torque", "peak_heat_flow", "end_torque", "end_speed_ratio", "heat"];
    Table::new("converters", all.iter())
        .text("id", "converter", |one| &one.id)
        .words("links", "between", |one| one.links.join("–"))
        .quantity("peak_torque", "T", Torque, |one| one.peak_torque_n_m)
        .quantity("peak_heat_flow", "heat flow", Power, |one| one.peak_heat_flow_w)
        .headed("end_torque", "T at the end", Torque, |one| one.end_torque_n_m)
        .printed("end_speed_ratio", "ν at the end", 4, |one| one.end_speed_ratio)
        .quantity("heat", "heat", Energy, |one| one.heat_j)
        .view_of("Torque converters", &shown)
        .note("T: on the turbine, the greatest; ν: its speed over that of the impeller.")
        .records()
}

fn end(simulation: &Simulation) -> Records {
    Table::new("end", simulation.end.iter())
        .text("link", "link", |one| &one.link)
        .quantity("speed", "n", AngularSpeed, |one| one.speed_rad_s)
        .quantity("acceleration", "", Dimension::AngularAcceleration, |one| one.acceleration_rad_s2)
        .view("At the end", "link speed acceleration")
        .records()
}

fn energies(simulation: &Simulation) -> Section {
    let energies = &simulation.energies;
    let one = |name, label, si| Row::new(name, label, "", [quantity(Energy, si)]);
    let mut rows = vec![
        one("kinetic_before", "kinetic, at the start", energies.kinetic_before_j),
        one("work", "work of the torques", energies.work_j),
        one("element_heat", "heat of elements", energies.element_heat_j),
        one("mesh_loss", "loss of meshes", energies.mesh_loss_j),
        one("kinetic_after", "kinetic, at the end", energies.kinetic_after_j),
    ];
    let parts = [
        (!simulation.drags.is_empty(), "drag_loss", "loss of drags", energies.drag_loss_j),
        (
            !simulation.shafts.is_empty(),
            "elastic_before",
            "in shafts, at the start",
            energies.elastic_before_j,
        ),
        (!simulation.shafts.is_empty(), "damping_heat", "heat of dampers of shafts", energies.damping_heat_j),
        (
            !simulation.converters.is_empty(),
            "converter_heat",
            "heat of converters' oil",
            energies.converter_heat_j,
        ),
        (has_dogs(simulation), "impact", "taken by impacts of dog clutches", energies.impact_j),
        (!simulation.shafts.is_empty(), "elastic_after", "in shafts, at the end", energies.elastic_after_j),
    ];
    let there = parts.into_iter().filter(|(is_there, ..)| *is_there);
    rows.extend(there.map(|(_, name, label, si)| one(name, label, si)));
    Section { name: "energies", title: "Energies", columns: &[], rows, note: "" }
}

fn has_dogs(simulation: &Simulation) -> bool {
    simulation.elements.iter().any(|one| one.kind == ElementKind::DogClutch)
}

/// Speeds and torques over time as a table: a line for each time.
#[must_use]
pub fn samples(simulation: &Simulation) -> Report {
    let all = &simulation.samples;
    let records = Table::new("samples", 0..all.times_s.len())
        .quantity("time", "t", Time, at(&all.times_s))
        .each(&all.links, |table, link| {
            table.quantity("speed", "", AngularSpeed, at(&link.speeds_rad_s)).of(&link.link)
        })
        .each(&all.torques, |table, one| {
            table.quantity("torque", "", Torque, at(&one.torques_n_m)).of(&one.id)
        })
        .each(&all.elements, |table, one| {
            let [capacities, rises] = [&one.capacities_n_m, &one.temperature_rises_k]
                .map(|list| list.as_deref().unwrap_or_default());
            table
                .quantity("torque", "", Torque, at(&one.torques_n_m))
                .of(&one.id)
                .quantity("capacity", "", Torque, at(capacities))
                .of(&one.id)
                .only_if(one.capacities_n_m.is_some())
                .quantity("slip", "", AngularSpeed, at(&one.slips_rad_s))
                .of(&one.id)
                .quantity("heat", "", Energy, at(&one.heats_j))
                .of(&one.id)
                .quantity("temperature_rise", "", TemperatureDifference, at(rises))
                .of(&one.id)
                .only_if(one.temperature_rises_k.is_some())
        })
        .each(&all.shafts, |table, one| {
            table
                .quantity("torque", "", Torque, at(&one.torques_n_m))
                .of(&one.id)
                .quantity("twist", "", Dimension::Angle, at(&one.twists_rad))
                .of(&one.id)
        })
        .each(&all.converters, |table, one| {
            table
                .quantity("impeller_torque", "", Torque, at(&one.impeller_torques_n_m))
                .of(&one.id)
                .quantity("turbine_torque", "", Torque, at(&one.turbine_torques_n_m))
                .of(&one.id)
        })
        .each(&all.drags, |table, one| {
            table
                .quantity("drag_slip", "", AngularSpeed, at(&one.slips_rad_s))
                .of(&one.id)
                .quantity("drag_torque", "", Torque, at(&one.torques_n_m))
                .of(&one.id)
                .quantity("drag_loss", "", Energy, at(&one.losses_j))
                .of(&one.id)
        })
        .quantity("output_torque", "", Torque, at(&all.output_torques_n_m))
        .the_answer()
        .records();
    Report { title: None, parts: vec![Part::Records(records)], warnings: None }
}

/// The figure that a list has at a place.
fn at(list: &[f64]) -> impl Fn(&usize) -> Option<f64> {
    |place| list.get(*place).copied()
}

//! Losses as tables.

use crate::losses::answer::{GearLosses, Heat, Loss, LossChapter, LossKind, LossMap, Losses, NotCalculated};
use crate::shared::judgement::table as judgement;
use crate::table::columns::Table;
use crate::table::figure::Figure;
use crate::table::figure::rpm;
use crate::table::quantities::{optional, quantity, words};
use crate::table::report::AsReport;
use crate::table::report::{Part, Records, Report, Row, Section, warned};
use epicyclic_pictures::contours::Contours;
use epicyclic_units::Dimension::{AngularSpeed, Power, TemperatureDifference, ThermalConductance, Torque};

impl AsReport for Losses {
    fn report(&self) -> Report {
        let tables = tables(&self.gears, &self.losses, &self.not_calculated);
        let heat = self.heat.as_ref().map(|heat| Part::Records(of_heat(heat)));
        let judged = judgement::parts(&self.judgement);
        let parts = [Part::Facts(facts(self))].into_iter().chain(tables).chain(heat).chain(judged).collect();
        Report { title: Some(format!("{}: losses", self.gearbox)), parts, warnings: warned(&self.warnings) }
    }
}

/// The tables of a page, which has the operating point and the warnings elsewhere.
pub(crate) fn for_page(chapter: &LossChapter) -> Report {
    let parts = tables(&chapter.gears, &chapter.losses, &chapter.not_calculated).collect();
    Report { parts, ..Report::default() }
}

fn tables(all: &[GearLosses], sources: &[Loss], others: &[NotCalculated]) -> impl Iterator<Item = Part> {
    let others = (!others.is_empty()).then(|| not_calculated(others));
    [gears(all), losses(sources)].into_iter().chain(others).map(Part::Records)
}

fn facts(losses: &Losses) -> Section {
    let at = &losses.operating_point;
    let mut rows =
        vec![Row::new("speed", "speed of the input", "n", [quantity(AngularSpeed, at.speed_rad_s)])];
    rows.push(Row::new("torque", "torque on the input", "T", [optional(Torque, at.torque_n_m)]));
    rows.push(Row::new("power", "power into the input", "P", [optional(Power, at.power_w)]));
    rows.push(Row::new("load_torque", "torque of the load", "T", [optional(Torque, at.load_torque_n_m)]));
    // Of the three one is given.
    rows.retain(|row| !matches!(row.cells[..], [Figure::Without(_)]));
    Section { name: "operating_point", title: "Operating point", columns: &[], rows, note: "" }
}

fn gears(all: &[GearLosses]) -> Records {
    Table::new("gears", all.iter())
        .text("gear", "gear", |gear| &gear.gear)
        .quantity("output_speed", "n out", AngularSpeed, |gear| gear.output_speed_rad_s)
        .quantity("input_torque", "T in", Torque, |gear| gear.input_torque_n_m)
        .quantity("output_torque", "T out", Torque, |gear| gear.output_torque_n_m)
        .quantity("input_power", "P in", Power, |gear| gear.input_power_w)
        .quantity("output_power", "P out", Power, |gear| gear.output_power_w)
        .quantity("mesh_loss", "meshes", Power, |gear| gear.mesh_loss_w)
        .quantity("drag_loss", "drags", Power, |gear| gear.drag_loss_w)
        .quantity("loss", "lost", Power, |gear| gear.loss_w)
        .multiple("efficiency", "η", |gear| gear.efficiency)
        .view("Balance of powers", "gear input_power output_power mesh_loss drag_loss loss efficiency")
        .view("Torques and speeds", "gear input_torque output_torque output_speed")
        .note("From outside: an output that gives power has a torque against its speed.")
        .the_answer()
        .records()
}

fn losses(all: &[Loss]) -> Records {
    let note = "mesh: of all planets together. open: a brake or clutch that is not engaged. n: relative speed of the links; M: torque \
                   between them.";
    let table = Table::new("losses", all.iter())
        .text("gear", "gear", |loss| &loss.gear)
        .words("kind", "kind", |loss| {
            let kind = match loss.kind {
                LossKind::Mesh => "mesh",
                LossKind::Drag => "drag",
                LossKind::OpenElement => "open",
            };
            Figure::choice(loss.kind, kind)
        })
        .text("of", "of", |loss| &loss.of)
        .words("between", "between", |loss| loss.between.join("–"))
        .quantity("slip", "n", AngularSpeed, |loss| loss.slip_rad_s)
        .quantity("torque", "M", Torque, |loss| loss.torque_n_m)
        .quantity("loss", "", Power, |loss| loss.loss_w)
        .number("of_loss_percent", "%", |loss| loss.of_loss.map(|share| Figure::Printed(100.0 * share, 1)));
    // At rest, and without losses, there is no heat to speak of.
    if all.is_empty() {
        return table.records();
    }
    table
        .view("Heat by its sources", "gear kind of between slip torque loss of_loss_percent")
        .note(note)
        .records()
}

fn of_heat(heat: &Heat) -> Records {
    let given = |name: &str, dimension, si: f64| format!("{name} {}", words(dimension, si, 6));
    let mut said = vec![given("conductance of the housing", ThermalConductance, heat.conductance_w_k)];
    if heat.cooler_w > 0.0 {
        said.push(given("cooler", Power, heat.cooler_w));
    }
    let mut shown = vec!["gear", "loss", "cooler", "housing", "rise"];
    if let Some(rise) = heat.allowed_rise_k {
        said.push(given("allowed", TemperatureDifference, rise));
        shown.push("thermal_torque");
    }
    let limit = if heat.allowed_rise_k.is_some() {
        " T lim: torque on the input with the allowed rise; - where no torque heats so much."
    } else {
        ""
    };
    Table::new("heat", heat.gears.iter())
        .text("gear", "gear", |gear| &gear.gear)
        .quantity("loss", "lost", Power, |gear| gear.loss_w)
        .quantity("cooler", "cooler", Power, |gear| gear.cooler_w)
        .quantity("housing", "housing", Power, |gear| gear.housing_w)
        .quantity("rise", "Δθ", TemperatureDifference, |gear| gear.rise_k)
        .quantity("thermal_torque", "T lim", Torque, |gear| gear.thermal_torque_n_m)
        .view_of("Balance of heat", &shown)
        .note(format!(
            "Δθ: by how much the oil is warmer than the air once nothing changes any more, with {}.{limit}",
            said.join(", ")
        ))
        .records()
}

fn not_calculated(all: &[NotCalculated]) -> Records {
    Table::new("not_calculated", all.iter())
        .text("gear", "gear", |one| &one.gear)
        .text("reason", "reason", |one| &one.reason)
        .text("message", "why", |one| &one.message)
        .view("Gears whose losses do not follow", "gear message")
        .records()
}

impl AsReport for LossMap {
    fn report(&self) -> Report {
        let records = Table::new("map", self.map.iter())
            .quantity("speed", "speed", AngularSpeed, |place| place.speed_rad_s)
            .quantity("torque", "torque", Torque, |place| place.torque_n_m)
            .quantity("output_torque", "output", Torque, |place| place.output_torque_n_m)
            .quantity("mesh_loss", "meshes", Power, |place| place.mesh_loss_w)
            .quantity("drag_loss", "drags", Power, |place| place.drag_loss_w)
            .quantity("loss", "lost", Power, |place| place.loss_w)
            .multiple("efficiency", "η", |place| place.efficiency)
            .view(
                "Losses over speed and torque of the input",
                "speed torque output_torque mesh_loss drag_loss loss efficiency",
            )
            .note("Without η: none enters, or all that enters is lost.")
            .the_answer()
            .records();
        Report {
            title: Some(format!("{}, gear {}", self.gearbox, self.gear)),
            parts: [Part::Records(records)].into_iter().chain(judgement::parts(&self.judgement)).collect(),
            warnings: warned(&self.warnings),
        }
    }
}

/// The efficiency over speed and torque as lines of equal value.
#[must_use]
pub fn efficiency_map(map: &LossMap, title: Option<&str>) -> Contours {
    let usual = || format!("{}, gear {}: efficiency", map.gearbox, map.gear);
    Contours {
        title: title.map_or_else(usual, str::to_owned),
        across: "speed of the input, rpm".to_owned(),
        up: "torque on the input, N·m".to_owned(),
        columns: map.speeds_rad_s.iter().map(|speed| rpm(*speed)).collect(),
        rows: map.torques_n_m.clone(),
        values: map.map.iter().map(|place| place.efficiency).collect(),
    }
}

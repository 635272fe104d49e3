//! Losses as tables.

use crate::AsReport;
use crate::figure::{Figure, multiple, rpm, text};
use crate::quantities::{optional, quantity, words};
use crate::report::{Column, Part, Records, Report, Row, Section, View, warned};
use epicyclic_answers::losses::{
    GearHeat, GearLosses, Heat, Loss, LossChapter, LossKind, LossMap, Losses, MapPlace, NotCalculated,
};
use epicyclic_pictures::contours::Contours;
use epicyclic_units::Dimension::{
    self, AngularSpeed, Power, TemperatureDifference, ThermalConductance, Torque,
};

fn column(si: f64, dimension: Dimension) -> Figure {
    Figure::Column { si, dimension }
}

fn if_any(si: Option<f64>, dimension: Dimension) -> Figure {
    si.map_or(Figure::None, |si| column(si, dimension))
}

impl AsReport for Losses {
    fn report(&self) -> Report {
        let tables = tables(&self.gears, &self.losses, &self.not_calculated);
        let heat = self.heat.as_ref().map(|heat| Part::Records(of_heat(heat)));
        let parts = [Part::Facts(facts(self))].into_iter().chain(tables).chain(heat).collect();
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
    let row = |gear: &GearLosses| {
        vec![
            text(&gear.gear),
            column(gear.output_speed_rad_s, AngularSpeed),
            column(gear.input_torque_n_m, Torque),
            column(gear.output_torque_n_m, Torque),
            column(gear.input_power_w, Power),
            column(gear.output_power_w, Power),
            column(gear.mesh_loss_w, Power),
            column(gear.drag_loss_w, Power),
            column(gear.loss_w, Power),
            multiple(gear.efficiency),
        ]
    };
    Records {
        name: "gears",
        columns: vec![
            Column::words("gear", "gear"),
            Column::headed("output_speed", "n out, rpm", AngularSpeed),
            Column::headed("input_torque", "T in, N·m", Torque),
            Column::headed("output_torque", "T out, N·m", Torque),
            Column::headed("input_power", "P in, kW", Power),
            Column::headed("output_power", "P out, kW", Power),
            Column::headed("mesh_loss", "meshes, kW", Power),
            Column::headed("drag_loss", "drags, kW", Power),
            Column::headed("loss", "lost, kW", Power),
            Column::number("efficiency", "η"),
        ],
        rows: all.iter().map(row).collect(),
        views: vec![
            View::new(
                "Balance of powers",
                &["gear", "input_power", "output_power", "mesh_loss", "drag_loss", "loss", "efficiency"],
            ),
            View {
                note: "From outside: an output that gives power has a torque against its speed.".to_owned(),
                ..View::new("Torques and speeds", &["gear", "input_torque", "output_torque", "output_speed"])
            },
        ],
        is_answer: true,
    }
}

fn losses(all: &[Loss]) -> Records {
    let row = |loss: &Loss| {
        let kind = match loss.kind {
            LossKind::Mesh => "mesh",
            LossKind::Drag => "drag",
            LossKind::OpenElement => "open",
        };
        let [first, second] = &loss.between;
        vec![
            text(&loss.gear),
            Figure::choice(loss.kind, kind),
            text(&loss.of),
            text(format!("{first}–{second}")),
            if_any(loss.slip_rad_s, AngularSpeed),
            if_any(loss.torque_n_m, Torque),
            column(loss.loss_w, Power),
            loss.of_loss.map_or(Figure::None, |share| Figure::Printed(100.0 * share, 1)),
        ]
    };
    Records {
        name: "losses",
        columns: vec![
            Column::words("gear", "gear"),
            Column::words("kind", "kind"),
            Column::words("of", "of"),
            Column::words("between", "between"),
            Column::headed("slip", "n, rpm", AngularSpeed),
            Column::headed("torque", "M, N·m", Torque),
            Column::headed("loss", "kW", Power),
            Column::number("of_loss_percent", "%"),
        ],
        rows: all.iter().map(row).collect(),
        views: vec![View {
            note: "mesh: of all planets together. open: a brake or clutch that is not engaged. n: relative speed of the links; M: torque \
                   between them.".to_owned(),
            ..View::new("Heat by its sources", &["gear", "kind", "of", "between", "slip", "torque", "loss", "of_loss_percent"])
        }],
        is_answer: false,
    }
}

fn of_heat(heat: &Heat) -> Records {
    let row = |gear: &GearHeat| {
        vec![
            text(&gear.gear),
            column(gear.loss_w, Power),
            column(gear.cooler_w, Power),
            column(gear.housing_w, Power),
            column(gear.rise_k, TemperatureDifference),
            if_any(gear.thermal_torque_n_m, Torque),
        ]
    };
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
    Records {
        name: "heat",
        columns: vec![
            Column::words("gear", "gear"),
            Column::headed("loss", "lost, kW", Power),
            Column::headed("cooler", "cooler, kW", Power),
            Column::headed("housing", "housing, kW", Power),
            Column::headed("rise", "Δθ, K", TemperatureDifference),
            Column::headed("thermal_torque", "T lim, N·m", Torque),
        ],
        rows: heat.gears.iter().map(row).collect(),
        views: vec![View {
            note: format!(
                "Δθ: by how much the oil is warmer than the air once nothing changes any more, with {}.{limit}",
                said.join(", ")
            ),
            ..View::new("Balance of heat", &shown)
        }],
        is_answer: false,
    }
}

fn not_calculated(all: &[NotCalculated]) -> Records {
    Records {
        name: "not_calculated",
        columns: vec![
            Column::words("gear", "gear"),
            Column::words("reason", "reason"),
            Column::words("message", "why"),
        ],
        rows: all.iter().map(|one| vec![text(&one.gear), text(&one.reason), text(&one.message)]).collect(),
        views: vec![View::new("Gears whose losses do not follow", &["gear", "message"])],
        is_answer: false,
    }
}

impl AsReport for LossMap {
    fn report(&self) -> Report {
        let row = |place: &MapPlace| {
            vec![
                column(place.speed_rad_s, AngularSpeed),
                column(place.torque_n_m, Torque),
                if_any(place.output_torque_n_m, Torque),
                if_any(place.mesh_loss_w, Power),
                if_any(place.drag_loss_w, Power),
                if_any(place.loss_w, Power),
                multiple(place.efficiency),
            ]
        };
        let records = Records {
            name: "map",
            columns: vec![
                Column::headed("speed", "speed, rpm", AngularSpeed),
                Column::headed("torque", "torque, N·m", Torque),
                Column::headed("output_torque", "output, N·m", Torque),
                Column::headed("mesh_loss", "meshes, kW", Power),
                Column::headed("drag_loss", "drags, kW", Power),
                Column::headed("loss", "lost, kW", Power),
                Column::number("efficiency", "η"),
            ],
            rows: self.map.iter().map(row).collect(),
            views: vec![View {
                note: "Without η: none enters, or all that enters is lost.".to_owned(),
                ..View::new(
                    "Losses over speed and torque of the input",
                    &["speed", "torque", "output_torque", "mesh_loss", "drag_loss", "loss", "efficiency"],
                )
            }],
            is_answer: true,
        };
        Report {
            title: Some(format!("{}, gear {}", self.gearbox, self.gear)),
            parts: vec![Part::Records(records)],
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

//! Several runs of a scenario as tables.

use super::per_cent;
use crate::simulate::answer::ElementKind;
use crate::simulate::answer::sweep::{Sweep, SweptRun};
use crate::table::figure::{Figure, text};
use crate::table::quantities::column;
use crate::table::report::AsReport;
use crate::table::report::{Column, Part, Records, Report, View, warned};
use epicyclic_units::Dimension::{self, AngularSpeed, Energy, Power, TemperatureDifference, Time};

impl AsReport for Sweep {
    fn report(&self) -> Report {
        Report {
            title: Some(format!("{}: {}", self.scenario, self.key)),
            parts: vec![Part::Records(records(self))],
            warnings: warned(&self.warnings),
        }
    }
}

/// A column and what it says of a run.
type Told<'a> = (Column, Box<dyn Fn(&SweptRun) -> Figure + 'a>);

fn records(sweep: &Sweep) -> Records {
    let Some(like) = sweep.runs.iter().find(|run| run.refused.is_none()).or(sweep.runs.first()) else {
        let columns = vec![Column::number("value", "value")];
        return Records { name: "runs", columns, rows: vec![], views: vec![], is_answer: true };
    };
    let heading = sweep.unit.clone().unwrap_or_else(|| "value".to_owned());
    let mut all: Vec<Told<'_>> =
        vec![(Column::number("value", heading), Box::new(|run| Figure::Number(run.value)))];
    for place in 0..like.shifts.len() {
        let shift = &like.shifts[place];
        let mut add = |name, heading: &str, dimension: Option<Dimension>, of: fn(&_) -> Figure| {
            let own = match dimension {
                Some(dimension) => Column::headed(name, heading, dimension),
                None => Column::number(name, heading),
            };
            // Of one shift the heading needs no name.
            let own =
                if like.shifts.len() == 1 { own } else { own.of(format!("{} → {}", shift.from, shift.to)) };
            all.push((own, Box::new(move |run| run.shifts.get(place).map_or(Figure::None, of))));
        };
        add("shift_time", "takes, s", Some(Time), |one: &crate::simulate::answer::ShiftResult| {
            column(Time, one.shift_time_s)
        });
        add("torque_hole_percent", "hole, %", None, |one| per_cent(one.torque_hole));
        add("torque_surge_percent", "surge, %", None, |one| per_cent(one.torque_surge));
        add("shift_heat", "heat, J", Some(Energy), |one| column(Energy, Some(one.heat_j)));
    }
    let heats = like.elements.iter().enumerate().filter(|(_, one)| one.kind != ElementKind::OneWayClutch);
    for (place, one) in heats {
        let mut add = |name, dimension, of: fn(&crate::simulate::answer::ElementResult) -> Option<f64>| {
            let own = Column::quantity(name, dimension).of(&one.id);
            let of = move |run: &SweptRun| column(dimension, run.elements.get(place).and_then(of));
            all.push((own, Box::new(of)));
        };
        add("heat", Energy, |one| Some(one.heat_j));
        add("peak_power", Power, |one| Some(one.peak_power_w));
        if one.peak_temperature_rise_k.is_some() {
            add("peak_temperature_rise", TemperatureDifference, |one| one.peak_temperature_rise_k);
        }
    }
    for (place, one) in like.thresholds.iter().enumerate() {
        let of = move |run: &SweptRun| column(Time, run.thresholds.get(place).and_then(|one| one.time_s));
        all.push((Column::quantity("passed", Time).of(&one.id), Box::new(of)));
    }
    for (place, one) in like.end.iter().enumerate() {
        let of = move |run: &SweptRun| column(AngularSpeed, run.end.get(place).map(|one| one.speed_rad_s));
        all.push((Column::quantity("end_speed", AngularSpeed).of(&one.link), Box::new(of)));
    }
    if sweep.runs.iter().any(|run| run.refused.is_some()) {
        let of = |run: &SweptRun| run.refused.as_ref().map_or(Figure::None, text);
        all.push((Column::words("refused", "refused"), Box::new(of)));
    }
    let rows = sweep.runs.iter().map(|run| all.iter().map(|(_, of)| of(run)).collect());
    let rows = rows.collect();
    let mut views = vec![];
    let mut view = |is_there: bool, title: &str, name: &[&'static str]| {
        if is_there {
            views.push(View::new(title, &[&["value"], name].concat()));
        }
    };
    view(
        !like.shifts.is_empty(),
        "Shifts",
        &["shift_time", "torque_hole_percent", "torque_surge_percent", "shift_heat"],
    );
    view(!like.elements.is_empty(), "Heat of the elements, J", &["heat"]);
    let is_thermal = like.elements.iter().any(|one| one.peak_temperature_rise_k.is_some());
    view(is_thermal, "Greatest temperature over the oil, K", &["peak_temperature_rise"]);
    view(!like.thresholds.is_empty(), "Thresholds passed, s", &["passed"]);
    view(like.shifts.is_empty(), "Speeds at the end, rpm", &["end_speed"]);
    view(sweep.runs.iter().any(|run| run.refused.is_some()), "Refused", &["refused"]);
    Records {
        name: "runs",
        columns: all.into_iter().map(|(column, _)| column).collect(),
        rows,
        views,
        is_answer: true,
    }
}

//! Several runs of a scenario as tables.

use super::per_cent;
use crate::shared::judgement::table as judgement;
use crate::simulate::answer::sweep::Sweep;
use crate::simulate::answer::{ElementKind, ElementResult};
use crate::table::columns::Table;
use crate::table::quantities::column;
use crate::table::report::AsReport;
use crate::table::report::{Column, Part, Records, Report, warned};
use epicyclic_units::Dimension::{AngularSpeed, Energy, Power, TemperatureDifference, Time};

impl AsReport for Sweep {
    fn report(&self) -> Report {
        Report {
            title: Some(format!("{}: {}", self.scenario, self.key)),
            parts: [Part::Records(records(self))]
                .into_iter()
                .chain(judgement::parts(&self.judgement))
                .collect(),
            warnings: warned(&self.warnings),
        }
    }
}

fn records(sweep: &Sweep) -> Records {
    let Some(like) = sweep.runs.iter().find(|run| run.refused.is_none()).or(sweep.runs.first()) else {
        return Table::new("runs", &sweep.runs)
            .number("value", "value", |run| run.value)
            .the_answer()
            .records();
    };
    let is_refused = sweep.runs.iter().any(|run| run.refused.is_some());
    let is_thermal = like.elements.iter().any(|one| one.peak_temperature_rise_k.is_some());
    let has_heat = |(_, one): &(usize, &ElementResult)| one.kind != ElementKind::OneWayClutch;
    // Of one shift the heading needs no name.
    let own = |place: usize, column: Column| match &like.shifts[..] {
        [_] => column,
        all => column.of(format!("{} → {}", all[place].from, all[place].to)),
    };
    let views = [
        (!like.shifts.is_empty(), "Shifts", "shift_time torque_hole_percent torque_surge_percent shift_heat"),
        (!like.elements.is_empty(), "Heat of the elements, J", "heat"),
        (is_thermal, "Greatest temperature over the oil, K", "peak_temperature_rise"),
        (!like.thresholds.is_empty(), "Thresholds passed, s", "passed"),
        (like.shifts.is_empty(), "Speeds at the end, rpm", "end_speed"),
        (is_refused, "Refused", "refused"),
    ];
    Table::new("runs", &sweep.runs)
        .number("value", sweep.unit.as_deref().unwrap_or("value"), |run| run.value)
        .each(0..like.shifts.len(), |table, place| {
            table
                .column(own(place, Column::headed("shift_time", "takes, s", Time)), |run| {
                    column(Time, run.shifts.get(place).and_then(|one| one.shift_time_s))
                })
                .column(own(place, Column::number("torque_hole_percent", "hole, %")), |run| {
                    Some(per_cent(run.shifts.get(place)?.torque_hole))
                })
                .column(own(place, Column::number("torque_surge_percent", "surge, %")), |run| {
                    Some(per_cent(run.shifts.get(place)?.torque_surge))
                })
                .column(own(place, Column::headed("shift_heat", "heat, J", Energy)), |run| {
                    column(Energy, run.shifts.get(place).map(|one| one.heat_j))
                })
        })
        .each(like.elements.iter().enumerate().filter(has_heat), |table, (place, one)| {
            table
                .quantity("heat", "", Energy, |run| Some(run.elements.get(place)?.heat_j))
                .of(&one.id)
                .quantity("peak_power", "", Power, |run| Some(run.elements.get(place)?.peak_power_w))
                .of(&one.id)
                .quantity("peak_temperature_rise", "", TemperatureDifference, |run| {
                    run.elements.get(place)?.peak_temperature_rise_k
                })
                .of(&one.id)
                .only_if(one.peak_temperature_rise_k.is_some())
        })
        .each(like.thresholds.iter().enumerate(), |table, (place, one)| {
            table.quantity("passed", "", Time, |run| run.thresholds.get(place)?.time_s).of(&one.id)
        })
        .each(like.end.iter().enumerate(), |table, (place, one)| {
            table
                .quantity("end_speed", "", AngularSpeed, |run| Some(run.end.get(place)?.speed_rad_s))
                .of(&one.link)
        })
        .words("refused", "refused", |run| run.refused.clone())
        .only_if(is_refused)
        .each(views.into_iter().filter(|(is_there, ..)| *is_there), |table, (_, title, keys)| {
            let keys: Vec<&'static str> = ["value"].into_iter().chain(keys.split(' ')).collect();
            table.view_of(title, &keys)
        })
        .the_answer()
        .records()
}

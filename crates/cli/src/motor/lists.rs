//! Lists of a motor: its checks, and its chambers and satellites at the angle.

use super::design::{Drawn, refuse};
use crate::failure::Failure;
use epicyclic_formats::Dimension;
use epicyclic_formats::quantity::format;
use epicyclic_hydromotor::checks::{Subject, ToothHeights};
use epicyclic_pictures::motor::Phase;
use epicyclic_views::figure::{Figure, column};
use epicyclic_views::report::{Column, Records, View};
use uom::si::f64::{Length, Pressure};

/// Warnings of an answer: name and text.
pub(super) type Warnings = Vec<(&'static str, String)>;

/// How a value stands to what it must keep: near where less than a tenth of the bound is left.
pub(super) fn verdict(holds: bool, margin: Length, bound: Length) -> Figure {
    if !holds {
        Figure::Answer("fails", "FAILS")
    } else if margin < 0.1 * bound.abs() {
        Figure::Answer("near", "near")
    } else {
        Figure::Answer("holds", "holds")
    }
}

pub(super) const fn subject(subject: Subject) -> (&'static str, &'static str) {
    match subject {
        Subject::StatorBulge => ("stator-bulge", "stator, radius of inward bulges"),
        Subject::StatorHollow => ("stator-hollow", "stator, radius of hollows"),
        Subject::RotorBulge => ("rotor-bulge", "rotor, radius of bulges"),
        Subject::RotorHollow => ("rotor-hollow", "rotor, radius of hollows"),
        Subject::RotorLeastRadius => ("rotor-least-radius", "rotor, least distance from the axis"),
        Subject::Neighbours => ("neighbours", "satellites' centres, distance"),
    }
}

pub(super) fn checks(drawn: &Drawn, warnings: &mut Warnings) -> Result<Records, Failure> {
    // The satellites' teeth stand out by h_a + x; the wheels' roots lie h_a + c + x beyond their centrodes.
    let addendum = drawn.form.addendum + drawn.form.shift;
    let heights = ToothHeights { addendum, dedendum: addendum + drawn.form.clearance };
    let checks = drawn.motor.checks(heights).map_err(refuse)?;
    let mut rows = vec![];
    for check in checks {
        let (name, words) = subject(check.subject);
        if !check.holds() {
            let [value, limit] = [check.value, check.limit].map(|length| format::quantity(length, 4));
            warnings.push((name, format!("{words}: {value}, and it must exceed {limit}")));
        }
        rows.push(vec![
            Figure::Answer(name, words),
            column(Some(check.value)),
            column(Some(check.limit)),
            verdict(check.holds(), check.value - check.limit, check.limit),
        ]);
    }
    Ok(Records {
        name: "checks",
        columns: vec![
            Column::words("check", "centrode"),
            Column { heading: "value, mm".to_owned(), ..Column::quantity("value", Dimension::Length) },
            Column { heading: "above, mm".to_owned(), ..Column::quantity("limit", Dimension::Length) },
            Column::words("verdict", "verdict"),
        ],
        rows,
        views: vec![View::new(
            "Curvatures and distances against satellites and tooth heights",
            &["check", "value", "limit", "verdict"],
        )],
        is_answer: false,
    })
}

pub(super) fn chambers(drawn: &Drawn) -> Result<Records, Failure> {
    let chambers = drawn.motor.chambers(drawn.angle).map_err(refuse)?;
    let state = |phase| match phase {
        Phase::Filling => Figure::Answer("filling", "fills, high pressure"),
        Phase::Emptying => Figure::Answer("emptying", "empties, low pressure"),
        Phase::AtExtreme => Figure::Answer("changing-over", "changes over"),
    };
    let rows = chambers.iter().map(|chamber| {
        let phase = Phase::of(chamber, &chambers);
        let none = uom::si::f64::Area::default();
        let growth = if phase == Phase::AtExtreme { none } else { chamber.growth };
        vec![Figure::Count(chamber.index), column(Some(chamber.area)), column(Some(growth)), state(phase)]
    });
    let angle = format::quantity(drawn.angle, 6);
    Ok(Records {
        name: "chambers",
        columns: vec![
            Column::number("chamber", "chamber"),
            Column { heading: "area, mm²".to_owned(), ..Column::quantity("area", Dimension::Area) },
            Column {
                heading: "growth, mm²/rad".to_owned(),
                ..Column::quantity("growth_per_radian", Dimension::Area)
            },
            Column::words("state", "state"),
        ],
        rows: rows.collect(),
        views: vec![View {
            note: "Counter-clockwise from the x axis, which runs through a crest of the stator; running \
                   counter-clockwise."
                .to_owned(),
            ..View::new(
                format!("Chambers, rotor turned by {angle}"),
                &["chamber", "area", "growth_per_radian", "state"],
            )
        }],
        is_answer: false,
    })
}

pub(super) fn satellites(drawn: &Drawn) -> Result<Records, Failure> {
    let satellites = drawn.motor.satellites(drawn.angle).map_err(refuse)?;
    let forces = match (drawn.width, drawn.pressure) {
        (Some(width), Some(pressure)) => {
            let low = Pressure::default();
            Some(drawn.motor.satellite_forces(drawn.angle, width, pressure, low).map_err(refuse)?)
        }
        _ => None,
    };
    let mut columns = vec![
        Column::number("satellite", "satellite"),
        Column { heading: "x, mm".to_owned(), ..Column::quantity("x", Dimension::Length) },
        Column { heading: "y, mm".to_owned(), ..Column::quantity("y", Dimension::Length) },
        Column { heading: "turned, deg".to_owned(), ..Column::quantity("rotation", Dimension::Angle) },
    ];
    if forces.is_some() {
        let behind = Column::quantity("pressure_behind", Dimension::Pressure);
        let front = Column::quantity("pressure_in_front", Dimension::Pressure);
        let force = Column::quantity("force", Dimension::Force);
        columns.push(Column { heading: "behind, MPa".to_owned(), ..behind });
        columns.push(Column { heading: "in front, MPa".to_owned(), ..front });
        columns.push(Column { heading: "force, N".to_owned(), ..force });
    }
    let row = |(i, satellite): (usize, &epicyclic_hydromotor::satellites::Satellite)| {
        let mut row = vec![
            Figure::Count(satellite.index),
            column(Some(satellite.centre.x)),
            column(Some(satellite.centre.y)),
            column(Some(satellite.rotation)),
        ];
        if let Some(force) = forces.as_ref().and_then(|forces| forces.get(i)) {
            row.push(column(Some(force.pressure_behind)));
            row.push(column(Some(force.pressure_in_front)));
            row.push(column(Some(force.force)));
        }
        row
    };
    let note = if forces.is_some() {
        "Force of the pressures, positive counter-clockwise across the ray from the axis. Low pressure counts \
         as 0."
    } else {
        ""
    };
    Ok(Records {
        name: "satellites",
        rows: satellites.iter().enumerate().map(row).collect(),
        views: vec![View {
            note: note.to_owned(),
            ..View::new(
                format!("Satellites, rotor turned by {}", format::quantity(drawn.angle, 6)),
                &["satellite", "x", "y", "rotation", "pressure_behind", "pressure_in_front", "force"],
            )
        }],
        columns,
        is_answer: false,
    })
}

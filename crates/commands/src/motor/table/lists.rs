//! Lists of a motor: its checks, limits and clearances of its teeth, its chambers and satellites.

use crate::motor::answer::{Between, LimitKind, Wheel};
use crate::motor::answer::{ChamberState, Clearance, Motor, Side, Subject, ToothLimit, ToothPart, Verdict};
use crate::table::figure::Figure;
use crate::table::quantities::{column, words};
use crate::table::report::{Column, Records, View};
use epicyclic_units::Dimension::{Angle, Area, Force, Length, Pressure};

fn verdict(verdict: Verdict) -> Figure {
    match verdict {
        Verdict::Holds => Figure::answer("holds", "holds"),
        Verdict::Near => Figure::answer("near", "near"),
        Verdict::Fails => Figure::answer("fails", "FAILS"),
    }
}

/// The name of a check.
pub(crate) const fn subject(subject: Subject) -> &'static str {
    match subject {
        Subject::StatorBulge => "stator_bulge",
        Subject::StatorHollow => "stator_hollow",
        Subject::RotorBulge => "rotor_bulge",
        Subject::RotorHollow => "rotor_hollow",
        Subject::RotorLeastRadius => "rotor_least_radius",
        Subject::Neighbours => "neighbours",
    }
}

pub(crate) fn checks(motor: &Motor) -> Records {
    let rows = motor.checks.iter().map(|check| {
        vec![
            Figure::answer(subject(check.check), check.check.words()),
            column(Length, Some(check.value_m)),
            column(Length, Some(check.limit_m)),
            verdict(check.verdict),
        ]
    });
    Records {
        name: "checks",
        columns: vec![
            Column::words("check", "centrode"),
            Column::headed("value", "value, mm", Length),
            Column::headed("limit", "above, mm", Length),
            Column::words("verdict", "verdict"),
        ],
        rows: rows.collect(),
        views: vec![View::new(
            "Curvatures and distances against satellites and tooth heights",
            &["check", "value", "limit", "verdict"],
        )],
        is_answer: false,
    }
}

pub(crate) fn limits(limits: &[ToothLimit]) -> Records {
    let kind = |kind| match kind {
        LimitKind::Undercut => "undercut",
        LimitKind::TipCusp => "tip_cusp",
        LimitKind::SatelliteRoot => "satellite_root",
        LimitKind::WheelRoot => "wheel_root",
        LimitKind::TipThickness => "tip_thickness",
        LimitKind::ContactPath => "contact_path",
        LimitKind::RootCurve => "root_curve",
        LimitKind::TipCurve => "tip_curve",
        LimitKind::Neighbours => "neighbours",
        LimitKind::Wheels => "wheels",
    };
    let wheel = |wheel| match wheel {
        Wheel::Stator => "stator",
        Wheel::Rotor => "rotor",
        Wheel::Satellite => "satellite",
    };
    let side = |side| match side {
        Side::AtLeast => "at_least",
        Side::AtMost => "at_most",
    };
    let rows = limits.iter().map(|limit| {
        vec![
            Figure::answer(wheel(limit.wheel), limit.wheel.words()),
            Figure::answer(kind(limit.limit), limit.limit.words()),
            column(Length, Some(limit.value_m)),
            Figure::answer(side(limit.side), limit.side.words()),
            column(Length, Some(limit.bound_m)),
            verdict(limit.verdict),
            column(Length, limit.at_arc_m),
        ]
    });
    Records {
        name: "tooth_limits",
        columns: vec![
            Column::words("wheel", "teeth of"),
            Column::words("limit", "limit"),
            Column::headed("value", "mm", Length),
            Column::words("side", ""),
            Column::headed("bound", "mm", Length),
            Column::words("verdict", "verdict"),
            Column::headed("at_arc", "at arc, mm", Length),
        ],
        rows: rows.collect(),
        views: vec![View::new(
            "Limits of the teeth",
            &["wheel", "limit", "value", "side", "bound", "verdict"],
        )],
        is_answer: false,
    }
}

pub(crate) fn clearances(clearances: &[Clearance]) -> Records {
    let between = |between| match between {
        Between::Stator => "stator",
        Between::Rotor => "rotor",
        Between::Neighbours => "neighbours",
        Between::Wheels => "wheels",
    };
    let part = |part| match part {
        None => Figure::None,
        Some(ToothPart::Tip) => Figure::answer("tip", "tip"),
        Some(ToothPart::Flank) => Figure::answer("flank", "flank"),
        Some(ToothPart::Fillet) => Figure::answer("fillet", "fillet"),
        Some(ToothPart::Root) => Figure::answer("root", "root"),
    };
    let rows = clearances.iter().map(|clearance| {
        vec![
            Figure::answer(between(clearance.between), clearance.between.words()),
            column(Length, Some(clearance.clearance_m)),
            Figure::Multiple(clearance.clearance_in_modules),
            part(clearance.part),
            column(Angle, clearance.rotation_rad),
            column(Length, clearance.x_m),
            column(Length, clearance.y_m),
        ]
    });
    Records {
        name: "clearances",
        columns: vec![
            Column::words("between", "between"),
            Column::headed("clearance", "least, mm", Length),
            Column::number("clearance_in_modules", "modules"),
            Column::words("part", "at the wheel's"),
            Column::headed("rotation", "rotor at, deg", Angle),
            Column::headed("x", "x, mm", Length),
            Column::headed("y", "y, mm", Length),
        ],
        rows: rows.collect(),
        views: vec![View {
            note: "Flanks in mesh keep their distance all along.".to_owned(),
            ..View::new(
                "Clearances of the teeth over a revolution, satellites amid their backlash",
                &["between", "clearance", "clearance_in_modules", "part", "rotation"],
            )
        }],
        is_answer: false,
    }
}

pub(crate) fn chambers(motor: &Motor) -> Records {
    let state = |state| match state {
        ChamberState::Filling => Figure::answer("filling", "fills, high pressure"),
        ChamberState::Emptying => Figure::answer("emptying", "empties, low pressure"),
        ChamberState::ChangingOver => Figure::answer("changing_over", "changes over"),
    };
    let rows = motor.chambers.iter().map(|chamber| {
        vec![
            Figure::Count(chamber.chamber),
            column(Area, Some(chamber.area_m2)),
            column(Area, Some(chamber.growth_per_radian_m2)),
            state(chamber.state),
        ]
    });
    Records {
        name: "chambers",
        columns: vec![
            Column::number("chamber", "chamber"),
            Column::headed("area", "area, mm²", Area),
            Column::headed("growth_per_radian", "growth, mm²/rad", Area),
            Column::words("state", "state"),
        ],
        rows: rows.collect(),
        views: vec![View {
            note: "Counter-clockwise from the x axis, which runs through a crest of the stator; running \
                   counter-clockwise."
                .to_owned(),
            ..View::new(
                format!("Chambers, rotor turned by {}", words(Angle, motor.angle_rad, 6)),
                &["chamber", "area", "growth_per_radian", "state"],
            )
        }],
        is_answer: false,
    }
}

pub(crate) fn satellites(motor: &Motor) -> Records {
    let has_forces = motor.satellites.iter().any(|satellite| satellite.force_n.is_some());
    let mut columns = vec![
        Column::number("satellite", "satellite"),
        Column::headed("x", "x, mm", Length),
        Column::headed("y", "y, mm", Length),
        Column::headed("rotation", "turned, deg", Angle),
    ];
    if has_forces {
        columns.push(Column::headed("pressure_behind", "behind, MPa", Pressure));
        columns.push(Column::headed("pressure_in_front", "in front, MPa", Pressure));
        columns.push(Column::headed("force", "force, N", Force));
    }
    let has_flanks = motor.satellites.iter().any(|satellite| satellite.flank_force_n.is_some());
    if has_flanks {
        columns.push(Column::headed("flank_force", "on a flank", Force));
    }
    let rows = motor.satellites.iter().map(|satellite| {
        let mut row = vec![
            Figure::Count(satellite.satellite),
            column(Length, Some(satellite.x_m)),
            column(Length, Some(satellite.y_m)),
            column(Angle, Some(satellite.rotation_rad)),
        ];
        if has_forces {
            row.push(column(Pressure, satellite.pressure_behind_pa));
            row.push(column(Pressure, satellite.pressure_in_front_pa));
            row.push(column(Force, satellite.force_n));
        }
        if has_flanks {
            row.push(column(Force, satellite.flank_force_n));
        }
        row
    });
    let note = if has_forces {
        "Force of the pressures, positive counter-clockwise across the ray from the axis. Low pressure counts as 0."
    } else {
        ""
    };
    Records {
        name: "satellites",
        rows: rows.collect(),
        views: vec![View {
            note: note.to_owned(),
            ..View::new(
                format!("Satellites, rotor turned by {}", words(Angle, motor.angle_rad, 6)),
                &[
                    "satellite",
                    "x",
                    "y",
                    "rotation",
                    "pressure_behind",
                    "pressure_in_front",
                    "force",
                    "flank_force",
                ],
            )
        }],
        columns,
        is_answer: false,
    }
}

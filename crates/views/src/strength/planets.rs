//! Planets: axial forces of helical teeth, bearings.

use crate::figure::{Figure, hours, text};
use crate::quantities::{column, optional};
use crate::report::{Column, Records, View};
use epicyclic_answers::strength::records::{AxialForce, BearingOverDuty};
use epicyclic_units::Dimension;

pub(super) fn axial_forces(all: &[AxialForce]) -> Records {
    let row = |one: &AxialForce| {
        vec![
            text(&one.set),
            text(&one.gear),
            one.step.map_or(Figure::None, Figure::Count),
            column(Dimension::Force, Some(one.axial_force_n)),
            column(Dimension::Torque, Some(one.tilting_moment_n_m)),
        ]
    };
    let of_steps = all.iter().any(|one| one.step.is_some());
    let shown: &[&'static str] = if of_steps {
        &["set", "step", "gear", "axial_force", "tilting_moment"]
    } else {
        &["set", "gear", "axial_force", "tilting_moment"]
    };
    Records {
        name: "axial_forces",
        columns: vec![
            Column::words("set", "set"),
            Column::words("gear", "gear"),
            Column::number("step", "step"),
            Column::headed("axial_force", "F_a, N", Dimension::Force),
            Column::headed("tilting_moment", "M, N·m", Dimension::Torque),
        ],
        rows: all.iter().map(row).collect(),
        views: vec![View {
            note: "F_a: of one mesh, those with sun and ring on a planet against each other; without losses and load factors. M: by which they tilt each planet; \
                   no rating of planet bearings has it."
                .to_owned(),
            ..View::new("Axial forces of helical teeth", shown)
        }],
        is_answer: false,
    }
}

pub(super) fn bearings(all: &[BearingOverDuty]) -> Records {
    let time = |si: Option<f64>| optional(Dimension::Time, si);
    let row = |one: &BearingOverDuty| {
        let modified = one.modified.and_then(|modified| modified.life_s);
        let in_hours = |si: Option<f64>| si.map_or(Figure::None, |si| Figure::Number(hours(si)));
        vec![
            text(&one.set),
            text(&one.planet),
            text(if one.rollers { "rollers" } else { "balls" }),
            column(Dimension::Force, Some(one.load_rating_n)),
            one.load_sharing.map_or(Figure::None, |factor| Figure::Printed(factor, 2)),
            column(Dimension::Force, one.greatest_force_n),
            one.static_safety.map_or(Figure::None, |safety| Figure::Printed(safety, 3)),
            time(one.basic_life_s),
            in_hours(one.basic_life_s),
            one.modified.map_or(Figure::None, |modified| Figure::Share(modified.reliability)),
            time(modified),
            in_hours(modified),
        ]
    };
    let views = vec![View {
        note: "K_γ: of the forces of the meshes. F: the greatest of duty and overloads. f_s: static load rating over it. L_10: basic life, L_nm: modified life over the duty, of the bearings stated."
            .to_owned(),
        ..View::new(
            "Planet bearings over the duty",
            &[
                "set",
                "planet",
                "rolling",
                "load_rating",
                "load_sharing",
                "greatest_force",
                "static_safety",
                "basic_hours",
                "reliability",
                "modified_hours",
            ],
        )
    }];
    Records {
        name: "bearings",
        columns: vec![
            Column::words("set", "set"),
            Column::words("planet", "planet"),
            Column::words("rolling", "of"),
            Column::headed("load_rating", "C, N", Dimension::Force),
            Column::number("load_sharing", "K_γ"),
            Column::headed("greatest_force", "F, N", Dimension::Force),
            Column::number("static_safety", "f_s"),
            Column::quantity("basic_life", Dimension::Time),
            Column::number("basic_hours", "L_10, h").for_people(),
            Column::number("reliability", "of"),
            Column::quantity("modified_life", Dimension::Time),
            Column::number("modified_hours", "L_nm, h").for_people(),
        ],
        rows: all.iter().map(row).collect(),
        views,
        is_answer: false,
    }
}

/// What is missing for a bearing, or why nothing follows; none where nothing is.
pub(super) fn bearings_missing(all: &[BearingOverDuty]) -> Option<Records> {
    let lacking = all.iter().filter(|one| !one.missing.is_empty());
    let row = |one: &BearingOverDuty| vec![text(&one.set), text(&one.planet), text(one.missing.join(", "))];
    let rows: Vec<_> = lacking.map(row).collect();
    (!rows.is_empty()).then(|| Records {
        name: "bearings_missing",
        columns: vec![
            Column::words("set", "set"),
            Column::words("planet", "planet"),
            Column::words("missing", "missing"),
        ],
        rows,
        views: vec![View::new("Planet bearings: what is missing", &["set", "planet", "missing"])],
        is_answer: false,
    })
}

pub(super) fn bearing_steps(all: &[BearingOverDuty]) -> Records {
    let number = |value: Option<f64>| value.map_or(Figure::None, Figure::Number);
    let rows = all.iter().filter(|one| one.modified.is_some()).flat_map(|one| {
        one.steps.iter().map(|step| {
            vec![
                text(&one.set),
                text(&one.planet),
                text(&step.gear),
                column(Dimension::Force, Some(step.force_n)),
                column(Dimension::AngularSpeed, Some(step.speed_rad_s)),
                number(step.viscosity_ratio),
                number(step.modification),
            ]
        })
    });
    Records {
        name: "bearing_steps",
        columns: vec![
            Column::words("set", "set"),
            Column::words("planet", "planet"),
            Column::words("gear", "gear"),
            Column::headed("force", "F, N", Dimension::Force),
            Column::headed("speed", "n, rpm", Dimension::AngularSpeed),
            Column::number("viscosity_ratio", "κ"),
            Column::number("modification", "a_ISO"),
        ],
        rows: rows.collect(),
        views: vec![View {
            note: "n: of the planet on its pin. κ: viscosity of the oil over the one needed.".to_owned(),
            ..View::new(
                "Planet bearings in the steps of the duty",
                &["set", "planet", "gear", "force", "speed", "viscosity_ratio", "modification"],
            )
        }],
        is_answer: false,
    }
}

//! Sizes of sets as tables.

use crate::shared::tooth_checks::table as tooth_checks;
use crate::size::answer::Size;
use crate::size::answer::records::{
    HeldKey, LeftOut, Minimise, NotSized, Requirement, SizedDesign, SizedGear, SizedSet, Sought,
};
use crate::table::columns::Table;
use crate::table::figure::{Figure, hours, text};
use crate::table::quantities::{column, optional, quantity, words};
use crate::table::report::AsReport;
use crate::table::report::{Column, Part, Records, Report, Row, Section, View, warned};
use epicyclic_units::Dimension;

impl AsReport for Size {
    fn report(&self) -> Report {
        let parts = [
            Some(Part::Facts(facts(self))),
            (!self.sets.iter().all(|set| set.found.is_empty()))
                .then(|| Part::Records(designs("designs", "Best designs", &self.sets, |set| &set.found))),
            self.sets.iter().any(|set| set.nearest_miss.is_some()).then(|| {
                Part::Records(designs("nearest_misses", "Nearest misses", &self.sets, |set| {
                    set.nearest_miss.as_slice()
                }))
            }),
            Some(Part::Records(left_out(&self.sets))),
            (!self.not_sized.is_empty()).then(|| Part::Records(not_sized(&self.not_sized))),
            tooth_checks::has_any(&self.tooth_checks)
                .then(|| Part::Records(tooth_checks::table(&self.tooth_checks))),
        ];
        let what = match (self.mass_kg, self.minimise) {
            (None, _) => "not every set has a size that meets the requirements.".to_owned(),
            (Some(mass), Minimise::Mass) => {
                format!(
                    "gears of {}, the lightest of {} designs.",
                    words(Dimension::Mass, mass, 4),
                    self.designs
                )
            }
            (Some(mass), Minimise::Ring) => format!(
                "the smallest rings of {} designs, gears of {}.",
                self.designs,
                words(Dimension::Mass, mass, 4)
            ),
        };
        Report {
            title: Some(format!("{}: {what}", self.gearbox)),
            parts: parts.into_iter().flatten().collect(),
            warnings: warned(&self.warnings),
        }
    }
}

fn facts(size: &Size) -> Section {
    let Sought {
        modules_m,
        face_widths_m,
        planets,
        centre_distance_step_m,
        reach_in_modules,
        width_ratio,
        least_tip_thickness_in_modules,
        planet_rim_in_modules,
        ring_rim_in_modules,
        bearings,
    } = &size.sought;
    let lengths = |si: &[f64]| Figure::List { si: si.to_vec(), dimension: Dimension::Length };
    let number = |value: f64| Figure::Number(value);
    let rows = vec![
        Row::new("designs", "designs of all sets", "", [number(size.designs as f64)]),
        Row::new("modules", "modules", "m", [lengths(modules_m)]),
        Row::new("face_widths", "face widths", "b", [lengths(face_widths_m)]),
        Row::new("planets", "planets", "p", [Figure::Texts(planets.iter().map(u32::to_string).collect())]),
        Row::new(
            "centre_distance_step",
            "step of the centre distances",
            "",
            [quantity(Dimension::Length, *centre_distance_step_m)],
        ),
        Row::new("reach", "their reach, in modules", "", [number(*reach_in_modules)]),
        Row::new(
            "width_ratio",
            "greatest face width over sun",
            "b/d_s",
            [width_ratio.map_or(Figure::None, Figure::Number)],
        ),
        Row::new("bearings", "bearings", "", [number(*bearings as f64)]),
        Row::new("tip_thickness", "least tips, in modules", "", [number(*least_tip_thickness_in_modules)]),
        Row::new("planet_rim", "least rim of planets, in modules", "", [number(*planet_rim_in_modules)]),
        Row::new("ring_rim", "rim of the ring, in modules", "", [number(*ring_rim_in_modules)]),
        Row::new("life", "required life", "L", [quantity(Dimension::Time, size.life_s)]),
        Row::new("required_flank", "required safety, flank", "", [number(size.required.flank)]),
        Row::new("required_root", "required safety, root", "", [number(size.required.root)]),
        Row::new(
            "oil_viscosity",
            "viscosity of the oil",
            "ν_40",
            [quantity(Dimension::Viscosity, size.oil_viscosity_m2_s)],
        ),
        Row::new("edition", "edition, method B", "", [text(&size.edition)]),
    ];
    Section { name: "space", title: "Space and requirements", columns: &[], rows, note: "" }
}

/// What governs a design: `S_F sun 1.45`.
pub(crate) fn governing(design: &SizedDesign) -> String {
    let of = design.governing;
    let what = match of.requirement {
        Requirement::BearingLife => return format!("bearing {:.3}", of.value),
        Requirement::Flank | Requirement::OverloadFlank => "S_H",
        Requirement::Root | Requirement::OverloadRoot => "S_F",
    };
    let against = if of.requirement.is_against_overload() { ", overload" } else { "" };
    format!("{what} {} {:.3}{against}", of.toothed_gear, of.value)
}

pub(crate) fn designs<'s>(
    name: &'static str,
    title: &str,
    sets: &'s [SizedSet],
    of: impl Fn(&'s SizedSet) -> &'s [SizedDesign],
) -> Records {
    let row = |set: &SizedSet, (place, design): (usize, &SizedDesign)| {
        let bearing = design.bearing.as_ref();
        let length = |si: f64| column(Dimension::Length, Some(si));
        let least = |safety: fn(&SizedGear) -> f64| {
            Figure::Printed(design.over_duty.iter().map(safety).fold(f64::INFINITY, f64::min), 3)
        };
        let designation = bearing.and_then(|bearing| bearing.designation.as_deref());
        vec![
            text(&set.set),
            Figure::Count(place as u32 + 1),
            length(design.module_m),
            length(design.face_width_m),
            Figure::Printed(design.face_width_over_sun, 2),
            Figure::Count(design.planets),
            length(design.centre_distance_m),
            designation.map_or(Figure::None, text),
            length(design.ring_diameter_m),
            column(Dimension::Mass, Some(design.mass_kg)),
            text(governing(design)),
            least(|one| one.flank.safety),
            least(|one| one.root.safety),
            optional(Dimension::Time, bearing.and_then(|bearing| bearing.life_s)),
            bearing
                .and_then(|bearing| bearing.life_s)
                .map_or(Figure::None, |life| Figure::Number(hours(life))),
            Figure::Printed(design.profile_shifts[0], 4),
            Figure::Printed(design.profile_shifts[1], 4),
            Figure::Printed(design.profile_shifts[2], 4),
        ]
    };
    let rows = sets.iter().flat_map(|set| of(set).iter().enumerate().map(move |one| row(set, one))).collect();
    Records {
        name,
        columns: vec![
            Column::words("set", "set"),
            Column::number("place", "no."),
            Column::headed("module", "m, mm", Dimension::Length),
            Column::headed("face_width", "b, mm", Dimension::Length),
            Column::number("face_width_over_sun", "b/d_s"),
            Column::number("planets", "p"),
            Column::headed("centre_distance", "a, mm", Dimension::Length),
            Column::words("bearing", "bearing"),
            Column::headed("ring_diameter", "ring, mm", Dimension::Length),
            Column::headed("mass", "kg", Dimension::Mass),
            Column::words("governing", "governs"),
            Column::number("flank_safety", "S_H"),
            Column::number("root_safety", "S_F"),
            Column::quantity("bearing_life", Dimension::Time),
            Column::number("bearing_hours", "L_10, h").for_people(),
            Column::number("sun_shift", "x_s"),
            Column::number("planet_shift", "x_p"),
            Column::number("ring_shift", "x_r"),
        ],
        rows,
        views: vec![
            View {
                note: "b/d_s: face width over the sun's reference diameter, which --width-ratio bounds."
                    .to_owned(),
                ..View::new(
                    title,
                    &[
                        "set",
                        "place",
                        "module",
                        "face_width",
                        "face_width_over_sun",
                        "planets",
                        "centre_distance",
                        "bearing",
                        "ring_diameter",
                        "mass",
                    ],
                )
            },
            View::new(
                format!("{title}: what governs, least safeties, bearing life, shifts"),
                &[
                    "set",
                    "place",
                    "governing",
                    "flank_safety",
                    "root_safety",
                    "bearing_hours",
                    "sun_shift",
                    "planet_shift",
                    "ring_shift",
                ],
            ),
        ],
        is_answer: name == "designs",
    }
}

pub(crate) fn left_out(sets: &[SizedSet]) -> Records {
    let row = |set: &SizedSet| {
        let LeftOut {
            spacing,
            planets_touch,
            geometry,
            width_ratio,
            rim,
            bearing_width,
            not_calculable,
            flank,
            root,
            overload,
            bearing_life,
        } = set.left_out;
        let counts = [
            set.designs,
            spacing,
            planets_touch,
            geometry,
            width_ratio,
            rim,
            bearing_width,
            not_calculable,
            flank,
            root,
            overload,
            bearing_life,
            set.not_reached,
        ];
        let held = set.held.iter().map(|key: &HeldKey| key.key().to_owned()).collect();
        [text(&set.set), Figure::Texts(held)]
            .into_iter()
            .chain(counts.map(|count| Figure::Number(count as f64)))
            .collect::<Vec<_>>()
    };
    let counts = [
        ("designs", "designs"),
        ("spacing", "spacing"),
        ("planets_touch", "touch"),
        ("geometry", "shifts"),
        ("width_ratio", "b/d_s"),
        ("rim", "rim"),
        ("bearing_width", "B > b"),
        ("not_calculable", "outside"),
        ("flank", "S_H"),
        ("root", "S_F"),
        ("overload", "overload"),
        ("bearing_life", "life"),
        ("not_reached", "not reached"),
    ];
    let named = [Column::words("set", "set"), Column::words("held", "held by the file")];
    Records {
        name: "left_out",
        columns: named
            .into_iter()
            .chain(counts.map(|(name, heading)| Column::number(name, heading)))
            .collect(),
        rows: sets.iter().map(row).collect(),
        views: vec![
            View::new(
                "Designs left out before their strength",
                &[
                    "set",
                    "designs",
                    "spacing",
                    "planets_touch",
                    "geometry",
                    "width_ratio",
                    "rim",
                    "bearing_width",
                ],
            ),
            View {
                note: "spacing: planets not at equal angles. shifts: none without fault. b/d_s: wider than allowed. outside: beyond the standard. A design that misses several of S_H, S_F, overload and life counts where it misses most. not reached: no better than the last one found.".to_owned(),
                ..View::new(
                    "Designs left out by strength and life",
                    &[
                        "set",
                        "held",
                        "not_calculable",
                        "flank",
                        "root",
                        "overload",
                        "bearing_life",
                        "not_reached",
                    ],
                )
            },
        ],
        is_answer: false,
    }
}

fn not_sized(all: &[NotSized]) -> Records {
    Table::new("not_sized", all.iter())
        .text("set", "set", |one| &one.set)
        .words("reason", "why", |one| text(one.why()))
        .view("Not sized", "set reason")
        .records()
}

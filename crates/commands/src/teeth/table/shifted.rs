//! Sets with profile shift for a ratio, as tables.

use super::{count, left_out, near, parts, percent, title};
use crate::table::figure::Figure;
use crate::table::report::AsReport;
use crate::table::report::{Column, Records, Report, View};
use crate::teeth::answer::shifted::{ShiftAim, ShiftedNumbers, ShiftedTeeth};
use epicyclic_units::Dimension;

impl AsReport for ShiftedTeeth {
    fn report(&self) -> Report {
        Report {
            title: Some(format!("{}, with profile shift", title(self.ratio, self.mode, self.tolerance))),
            parts: parts(
                sets(self),
                &self.tooth_checks,
                count(self.found, self.shown)
                    + &left_out(self.left_out.as_ref())
                    + &near(self.tooth_numbers.iter().map(|set| set.planet_gap_in_modules)),
            ),
            warnings: None,
        }
    }
}

/// An aim in words.
pub(crate) const fn aim(aim: ShiftAim) -> &'static str {
    match aim {
        ShiftAim::BalancedSliding => "balanced specific sliding at the roots of sun and planets",
        ShiftAim::LeastTipAlteration => "least tip alteration",
    }
}

fn sets(teeth: &ShiftedTeeth) -> Records {
    let aim = aim(teeth.aim);
    let limited = if teeth.tooth_numbers.iter().all(|set| set.aim_met) {
        ""
    } else {
        "; `no` where the limits keep the aim from being met in full"
    };
    let gears = ["sun", "planet", "ring", "planets"];
    let view = |title: &str, more: &[&'static str]| {
        View::new(title, &gears.iter().chain(more).copied().collect::<Vec<_>>())
    };
    let mut views = vec![
        View {
            note: "Offset: teeth of the ring less those of the sun and twice those of a planet. a: centre distance, \
                   ε: transverse contact ratios, gap: between planets; lengths in modules."
                .to_owned(),
            ..view(
                "Tooth numbers",
                &[
                    "ring_offset",
                    "ratio",
                    "exact_ratio",
                    "error",
                    "centre_distance_in_modules",
                    "contact_ratio_sun",
                    "contact_ratio_ring",
                    "planet_gap_in_modules",
                ],
            )
        },
        View {
            note: format!("x: profile shift, of the ring above 0 inwards; k: tip alteration, in modules. Aim: {aim}{limited}."),
            ..view(
                "Profile shifts",
                &[
                    "profile_shift_sun",
                    "profile_shift_planet",
                    "profile_shift_ring",
                    "tip_alteration_sun",
                    "tip_alteration_planet",
                    "tip_alteration_ring",
                    "aim_met",
                ],
            )
        },
    ];
    if teeth.tooth_numbers.iter().any(|set| !set.equal_spacing) {
        views.push(view("Angles of the planets in degrees, and imbalance", &["planet_angles", "imbalance"]));
    }
    Records {
        name: "tooth_numbers",
        columns: vec![
            Column::number("sun", "sun"),
            Column::number("planet", "planet"),
            Column::number("ring", "ring"),
            Column::number("ring_offset", "offset"),
            Column::number("planets", "planets"),
            Column::number("ratio", "ratio"),
            Column::number("exact_ratio", "exact"),
            Column::number("ratio_error", "error"),
            Column::number("error", "error, %").for_people(),
            Column::number("centre_distance_in_modules", "a"),
            Column::number("profile_shift_sun", "x sun"),
            Column::number("profile_shift_planet", "x planet"),
            Column::number("profile_shift_ring", "x ring"),
            Column::number("tip_alteration_sun", "k sun"),
            Column::number("tip_alteration_planet", "k planet"),
            Column::number("tip_alteration_ring", "k ring"),
            Column::quantity("working_angle_sun", Dimension::Angle),
            Column::quantity("working_angle_ring", Dimension::Angle),
            Column::number("contact_ratio_sun", "ε sun"),
            Column::number("contact_ratio_ring", "ε ring"),
            Column::number("tip_thickness_sun_in_modules", "tip sun"),
            Column::number("tip_thickness_planet_in_modules", "tip planet"),
            Column::number("tip_thickness_ring_in_modules", "tip ring"),
            Column::number("planet_gap_in_modules", "gap"),
            Column::words("aim_met", "aim met"),
            Column::words("equal_spacing", "equal"),
            Column::quantity("planet_angles", Dimension::Angle),
            Column::number("imbalance", "imbalance"),
        ],
        rows: teeth.tooth_numbers.iter().map(row).collect(),
        views,
        is_answer: true,
    }
}

fn row(set: &ShiftedNumbers) -> Vec<Figure> {
    let angle = |si| Figure::Column { si, dimension: Dimension::Angle };
    let mut row = vec![
        Figure::Count(set.sun),
        Figure::Count(set.planet),
        Figure::Count(set.ring),
        Figure::Number(f64::from(set.ring_offset)),
        Figure::Count(set.planets),
        Figure::Number(set.ratio),
        Figure::Text(set.exact_ratio.to_string()),
        Figure::Number(set.ratio_error),
        Figure::Text(percent(set.ratio_error)),
        Figure::Printed(set.centre_distance_in_modules, 3),
    ];
    row.extend(set.profile_shifts.map(|shift| Figure::Printed(shift, 4)));
    row.extend(set.tip_alterations.map(|alteration| Figure::Printed(alteration, 4)));
    row.extend(set.working_angles_rad.map(angle));
    row.extend(set.contact_ratios.map(|ratio| Figure::Printed(ratio, 3)));
    row.extend(set.tip_thicknesses_in_modules.map(|thickness| Figure::Printed(thickness, 3)));
    row.extend([
        Figure::Printed(set.planet_gap_in_modules, 3),
        Figure::YesNo(set.aim_met),
        Figure::YesNo(set.equal_spacing),
        Figure::List { si: set.planet_angles_rad.clone(), dimension: Dimension::Angle },
        Figure::Number(set.imbalance),
    ]);
    row
}

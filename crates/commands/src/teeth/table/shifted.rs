//! Sets with profile shift for a ratio, as tables.

use super::{count, left_out, near, parts, percent, title};
use crate::table::columns::Table;
use crate::table::report::AsReport;
use crate::table::report::{Records, Report};
use crate::teeth::answer::shifted::ShiftedTeeth;
use epicyclic_gears::involute::family::Aim;
use epicyclic_units::Dimension;

impl AsReport for ShiftedTeeth {
    fn report(&self) -> Report {
        Report {
            title: Some(format!("{}, with profile shift", title(self.ratio, self.mode, self.tolerance))),
            parts: parts(
                sets(self),
                &self.tooth_checks,
                &self.judgement,
                count(self.found, self.shown)
                    + &left_out(self.left_out.as_ref())
                    + &near(self.tooth_numbers.iter().map(|set| set.planet_gap_in_modules)),
            ),
            warnings: None,
        }
    }
}

/// An aim in words.
pub(crate) const fn aim(aim: Aim) -> &'static str {
    match aim {
        Aim::BalancedSliding => "balanced specific sliding at the roots of sun and planets",
        Aim::LeastTipAlteration => "least tip alteration",
    }
}

/// Explanation of sets that do not meet their aim.
pub(super) const fn limited(is_met: bool) -> &'static str {
    if is_met { "" } else { "; `no` where the limits keep the aim from being met in full" }
}

fn sets(teeth: &ShiftedTeeth) -> Records {
    let aim = aim(teeth.aim);
    let limited = limited(teeth.tooth_numbers.iter().all(|set| set.aim_met));
    let is_unequal = teeth.tooth_numbers.iter().any(|set| !set.equal_spacing);
    Table::new("tooth_numbers", &teeth.tooth_numbers)
        .number("sun", "sun", |set| set.sun)
        .number("planet", "planet", |set| set.planet)
        .number("ring", "ring", |set| set.ring)
        .number("ring_offset", "offset", |set| f64::from(set.ring_offset))
        .number("planets", "planets", |set| set.planets)
        .number("ratio", "ratio", |set| set.ratio)
        .number("exact_ratio", "exact", |set| set.exact_ratio.to_string())
        .number("ratio_error", "error", |set| set.ratio_error)
        .number("error", "error, %", |set| percent(set.ratio_error))
        .for_people()
        .printed("centre_distance_in_modules", "a", 3, |set| set.centre_distance_in_modules)
        .printed("profile_shift_sun", "x sun", 4, |set| set.profile_shifts[0])
        .printed("profile_shift_planet", "x planet", 4, |set| set.profile_shifts[1])
        .printed("profile_shift_ring", "x ring", 4, |set| set.profile_shifts[2])
        .printed("tip_alteration_sun", "k sun", 4, |set| set.tip_alterations[0])
        .printed("tip_alteration_planet", "k planet", 4, |set| set.tip_alterations[1])
        .printed("tip_alteration_ring", "k ring", 4, |set| set.tip_alterations[2])
        .quantity("working_angle_sun", "", Dimension::Angle, |set| set.working_angles_rad[0])
        .quantity("working_angle_ring", "", Dimension::Angle, |set| set.working_angles_rad[1])
        .printed("contact_ratio_sun", "ε sun", 3, |set| set.contact_ratios[0])
        .printed("contact_ratio_ring", "ε ring", 3, |set| set.contact_ratios[1])
        .printed("tip_thickness_sun_in_modules", "tip sun", 3, |set| set.tip_thicknesses_in_modules[0])
        .printed("tip_thickness_planet_in_modules", "tip planet", 3, |set| set.tip_thicknesses_in_modules[1])
        .printed("tip_thickness_ring_in_modules", "tip ring", 3, |set| set.tip_thicknesses_in_modules[2])
        .printed("planet_gap_in_modules", "gap", 3, |set| set.planet_gap_in_modules)
        .words("aim_met", "aim met", |set| set.aim_met)
        .words("equal_spacing", "equal", |set| set.equal_spacing)
        .list("planet_angles", "", Dimension::Angle, |set| set.planet_angles_rad.clone())
        .number("imbalance", "imbalance", |set| set.imbalance)
        .view(
            "Tooth numbers",
            "sun planet ring planets ring_offset ratio exact_ratio error centre_distance_in_modules \
             contact_ratio_sun contact_ratio_ring planet_gap_in_modules",
        )
        .note(
            "Offset: teeth of the ring less those of the sun and twice those of a planet. a: centre distance, \
             ε: transverse contact ratios, gap: between planets; lengths in modules.",
        )
        .view(
            "Profile shifts",
            "sun planet ring planets profile_shift_sun profile_shift_planet profile_shift_ring \
             tip_alteration_sun tip_alteration_planet tip_alteration_ring aim_met",
        )
        .note(format!("x: profile shift, of the ring above 0 inwards; k: tip alteration, in modules. Aim: {aim}{limited}."))
        .each(is_unequal.then_some("sun planet ring planets planet_angles imbalance"), |table, shown| {
            table.view("Angles of the planets in degrees, and imbalance", shown)
        })
        .the_answer()
        .records()
}

//! Sizes of the sets on the first sheet of a report.

use crate::report::answer::sizes::SetSizes;
use crate::strength::answer::on_shafts::{AskedDuty, OverloadOnInput};
use crate::strength::answer::records::{Against, Governing};
use crate::table::columns::Table;
use crate::table::figure::hours;
use crate::table::quantities::words;
use crate::table::report::Records;
use epicyclic_units::Dimension;
use epicyclic_units::format::trimmed;

/// Digits of tooth numbers.
const DIGITS: usize = 4;

/// A line for each set with its sizes, then one with its bearings and safeties; without columns that no set
/// has.
pub(crate) fn sizes(sets: &[SetSizes]) -> Records {
    let shown = |columns: &[(&'static str, bool)]| -> Vec<&'static str> {
        columns.iter().filter(|column| column.1).map(|column| column.0).collect()
    };
    let any = |has: fn(&SetSizes) -> bool| sets.iter().any(has);
    let of_sizes = shown(&[
        ("set", true),
        ("teeth", true),
        ("module", true),
        ("face_width", any(|set| !set.face_widths_m.is_empty())),
        ("ring_diameter", any(|set| set.ring_diameter_m.is_some())),
        ("mass", any(|set| set.mass_kg.is_some())),
        ("structure", any(|set| set.structure_kg.is_some())),
    ]);
    let [has_bearings, is_rated] =
        [any(|set| !set.bearings.is_empty()), any(|set| set.flank.is_some() || set.root.is_some())];
    let of_strength = shown(&[
        ("set", true),
        ("rolling", has_bearings),
        ("load_rating", has_bearings),
        ("bearing_life", has_bearings && any(|set| life(set).is_some())),
        ("flank_safety", is_rated),
        ("flank", is_rated),
        ("root_safety", is_rated),
        ("root", is_rated),
    ]);
    let table = Table::new("sizes", sets.iter())
        .text("set", "set", |set| &set.set)
        .words("teeth", "z", |set| {
            set.teeth.iter().map(|z| trimmed(*z, DIGITS)).collect::<Vec<_>>().join(", ")
        })
        .list("module", "m", Dimension::Length, |set| set.modules_m.clone())
        .list("face_width", "b", Dimension::Length, |set| set.face_widths_m.clone())
        .measured("ring_diameter", "ring Ø", Dimension::Length, 1, |set| set.ring_diameter_m)
        .measured("mass", "gears", Dimension::Mass, 1, |set| set.mass_kg)
        .measured("structure", "carrier, housing", Dimension::Mass, 1, |set| set.structure_kg)
        .words("rolling", "bearing", |set| {
            let mut kinds: Vec<String> =
                set.bearings.iter().map(|bearing| bearing.rolling.replace('_', " ")).collect();
            kinds.dedup();
            kinds
        })
        .list("load_rating", "C", Dimension::Force, |set| {
            set.bearings.iter().map(|bearing| bearing.load_rating_n).collect()
        })
        .printed("bearing_life", "L_10, h", 0, |set| life(set).map(hours))
        .for_people()
        .printed("flank_safety", "S_H", 2, |set| set.flank.as_ref().map(|of| of.safety))
        .words("flank", "least of", |set| set.flank.as_ref().map(place))
        .printed("root_safety", "S_F", 2, |set| set.root.as_ref().map(|of| of.safety))
        .words("root", "least of", |set| set.root.as_ref().map(place))
        .view_of("Sizes", &of_sizes)
        .note(masses(sets));
    let table = if of_strength.len() > 1 {
        table.view_of("Bearings of the planets, least safeties", &of_strength)
    } else {
        table
    };
    table.records()
}

/// Duty of the file on input and output, with its application factor, overloads and life.
pub(crate) fn asked_duty(duty: &AskedDuty) -> Records {
    Table::new("duty", duty.steps.iter())
        .text("gear", "gear", |step| &step.gear)
        .share("share", "of the time", |step| step.share)
        .quantity("input_power", "P in", Dimension::Power, |step| step.input_power_w)
        .quantity("input_speed", "n in", Dimension::AngularSpeed, |step| step.input_speed_rad_s)
        .quantity("output_speed", "n out", Dimension::AngularSpeed, |step| step.output_speed_rad_s)
        .quantity("input_torque", "T in", Dimension::Torque, |step| step.input_torque_n_m)
        .quantity("output_torque", "T out", Dimension::Torque, |step| step.output_torque_n_m)
        .number("efficiency", "η", |step| step.efficiency)
        .view(
            "Duty asked for",
            "gear share input_power input_speed output_speed input_torque output_torque efficiency",
        )
        .note(around(duty))
        .records()
}

/// Application factor, overloads and life of a duty in words.
fn around(duty: &AskedDuty) -> String {
    let mut all = vec!["T out: with the losses of the meshes.".to_owned()];
    if !duty.application_factors.is_empty() {
        let factors: Vec<String> = duty.application_factors.iter().map(|of| trimmed(*of, DIGITS)).collect();
        all.push(format!("Application factor K_A {}.", factors.join(", ")));
    }
    let overload = |of: &OverloadOnInput| {
        format!("gear {} {}", of.gear, words(Dimension::Torque, of.input_torque_n_m, DIGITS))
    };
    if !duty.overload.is_empty() {
        let overloads: Vec<String> = duty.overload.iter().map(overload).collect();
        all.push(format!("Greatest torque in: {}.", overloads.join(", ")));
    }
    all.extend(duty.life_s.map(|life| format!("Required life {} h.", trimmed(hours(life), DIGITS))));
    all.join(" ")
}

/// Least life of the bearings of a set, in s.
fn life(set: &SetSizes) -> Option<f64> {
    set.bearings.iter().filter_map(|bearing| bearing.life_s).reduce(f64::min)
}

/// Gear with the least safety, and the load if it is none of the duty: `planet`, `ring, overload`.
fn place(of: &Governing) -> String {
    match (of.against, &of.gear) {
        (Against::Overload, _) => format!("{}, overload", of.toothed_gear),
        (Against::OperatingPoint, Some(gear)) => format!("{}, gear {gear}", of.toothed_gear),
        _ => of.toothed_gear.clone(),
    }
}

/// Masses of all sets together, and what they contain.
fn masses(sets: &[SetSizes]) -> String {
    let all = |of: fn(&SetSizes) -> Option<f64>| sets.iter().map(of).sum::<Option<f64>>();
    let told = |of: Option<f64>, digits| of.map(|mass| words(Dimension::Mass, mass, digits));
    let of_sets = all(|set| Some(set.mass_kg? + set.structure_kg?));
    let together = match (told(all(|set| set.mass_kg), 3), told(of_sets, 3)) {
        (Some(gears), Some(of_sets)) => {
            format!(" Together: gears {gears}, with carriers and housing about {of_sets}.")
        }
        (Some(gears), None) => format!(" Together: gears {gears}."),
        _ => String::new(),
    };
    let whole = if sets.iter().any(|set| set.structure_kg.is_some()) {
        " Carrier and housing by a rule, cheeks of 0.12 and a wall of 0.04 diameters of the ring, of a pair of its larger gear. Shafts, flanges, brakes and clutches come on top; the answer of design has them in its whole."
    } else {
        ""
    };
    format!("z: teeth, of a simple set sun, planets, ring. m: module, b: face width.{together}{whole}")
}

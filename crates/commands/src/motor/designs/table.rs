//! Columns that the tables of both searches for hydromotors share: numbers of a design, and its performance
//! at its size.

use crate::table::columns::Table;
use crate::table::quantities::column;
use epicyclic_units::Dimension::{Length, Power, Torque, Volume, VolumeRate};

/// How many were found, how many shown.
pub(crate) fn found_and_shown(found: usize, shown: usize) -> String {
    format!("{found} designs found, {shown} shown")
}

/// How to see the rest.
pub(crate) fn hidden(designs: usize) -> String {
    match designs {
        0 => String::new(),
        1 => " 1 more: --limit shows it.".to_owned(),
        hidden => format!(" {hidden} more: --limit shows them."),
    }
}

/// What the count of designs of a set means.
pub(crate) const fn of_set(first_of_each_set: bool) -> &'static str {
    if first_of_each_set {
        " Of set: designs of these numbers, of which the first is shown unless --every is given."
    } else {
        " Of set: designs of these numbers."
    }
}

/// A design's number, its lobes of stator and rotor, its teeth of stator, rotor and satellites.
pub(crate) struct Numbers {
    pub(crate) design: usize,
    pub(crate) lobes: [u32; 2],
    pub(crate) teeth: [u32; 3],
}

/// A table of designs with their numbers.
pub(crate) fn numbered<D>(designs: impl IntoIterator<Item = D>, of: impl Fn(&D) -> Numbers) -> Table<D> {
    Table::new("designs", designs)
        .number("design", "no", |design| of(design).design)
        .words("lobes", "N×n", |design| of(design).lobes.map(|lobes| lobes.to_string()).join("×"))
        .for_people()
        .number("stator_lobes", "N", |design| of(design).lobes[0])
        .number("rotor_lobes", "n", |design| of(design).lobes[1])
        .words("teeth", "Z₃/Z₁/Z_s", |design| of(design).teeth.map(|teeth| teeth.to_string()).join("/"))
        .for_people()
        .number("stator_teeth", "Z₃", |design| of(design).teeth[0])
        .number("rotor_teeth", "Z₁", |design| of(design).teeth[1])
        .number("satellite_teeth", "Z_s", |design| of(design).teeth[2])
}

/// What a design does in its size, and the modules that serve.
pub(crate) struct Duty<'a> {
    pub(crate) displacement_m3: f64,
    pub(crate) torque_n_m: Option<f64>,
    pub(crate) least_torque_n_m: Option<f64>,
    pub(crate) flow_m3_s: Option<f64>,
    pub(crate) power_w: Option<f64>,
    pub(crate) modules_m: &'a [f64],
}

/// The table with what its designs do.
pub(crate) fn with_duty<D>(table: Table<D>, of: impl Fn(&D) -> Duty<'_>) -> Table<D> {
    let shown = |module: &f64| column(Length, Some(*module)).table();
    table
        .quantity("displacement", "q", Volume, |design| of(design).displacement_m3)
        .quantity("torque", "M", Torque, |design| of(design).torque_n_m)
        .headed("least_torque", "least", Torque, |design| of(design).least_torque_n_m)
        .quantity("flow", "", VolumeRate, |design| of(design).flow_m3_s)
        .quantity("power", "", Power, |design| of(design).power_w)
        .list("modules", "all m", Length, |design| of(design).modules_m.to_vec())
        .words("all_modules", "all m, mm", |design| {
            of(design).modules_m.iter().map(shown).collect::<Vec<_>>().join(" ")
        })
        .for_people()
}

/// Columns of the sizes: what is known of the first design's duty after the given ones, as many as fit a
/// table.
pub(crate) fn size_columns(
    given: &[&'static str],
    first: Option<&Duty<'_>>,
    several_modules: bool,
) -> Vec<&'static str> {
    let mut columns = given.to_vec();
    let known = |of: fn(&Duty<'_>) -> Option<f64>| first.and_then(of).is_some();
    if known(|duty| duty.torque_n_m) {
        columns.extend(["torque", "least_torque"]);
    }
    if known(|duty| duty.flow_m3_s) {
        columns.push("flow");
    }
    if known(|duty| duty.power_w) {
        columns.push("power");
    }
    if several_modules && columns.len() < 9 {
        columns.push("all_modules");
    }
    columns
}

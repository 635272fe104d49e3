//! What the tables of both searches for hydromotors share: the numbers of a design, and what it does in its
//! size.

use crate::table::figure::{Figure, count};
use crate::table::quantities::column;
use crate::table::report::Column;
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

/// Columns of a design's number, lobes and teeth.
pub(crate) fn number_columns() -> Vec<Column> {
    vec![
        Column::number("design", "no"),
        Column::words("lobes", "N×n").for_people(),
        Column::number("stator_lobes", "N"),
        Column::number("rotor_lobes", "n"),
        Column::words("teeth", "Z₃/Z₁/Z_s").for_people(),
        Column::number("stator_teeth", "Z₃"),
        Column::number("rotor_teeth", "Z₁"),
        Column::number("satellite_teeth", "Z_s"),
    ]
}

/// Their figures: the design, the lobes of stator and rotor, the teeth of stator, rotor and satellites.
pub(crate) fn numbers(design: usize, [stator, rotor]: [u32; 2], [z3, z1, zs]: [u32; 3]) -> Vec<Figure> {
    vec![
        count(design),
        Figure::Text(format!("{stator}×{rotor}")),
        Figure::Count(stator),
        Figure::Count(rotor),
        Figure::Text(format!("{z3}/{z1}/{zs}")),
        Figure::Count(z3),
        Figure::Count(z1),
        Figure::Count(zs),
    ]
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

/// Its columns.
pub(crate) fn duty_columns() -> Vec<Column> {
    vec![
        Column::headed("displacement", "q, cm³", Volume),
        Column::headed("torque", "M, N·m", Torque),
        Column::headed("least_torque", "least", Torque),
        Column::headed("flow", "l/min", VolumeRate),
        Column::headed("power", "kW", Power),
        Column::headed("modules", "all m, mm", Length),
        Column::words("all_modules", "all m, mm").for_people(),
    ]
}

impl Duty<'_> {
    /// Its figures.
    pub(crate) fn figures(&self) -> Vec<Figure> {
        let modules = self.modules_m.iter().map(|module| column(Length, Some(*module)).table());
        vec![
            column(Volume, Some(self.displacement_m3)),
            column(Torque, self.torque_n_m),
            column(Torque, self.least_torque_n_m),
            column(VolumeRate, self.flow_m3_s),
            column(Power, self.power_w),
            Figure::List { si: self.modules_m.to_vec(), dimension: Length },
            Figure::Text(modules.collect::<Vec<_>>().join(" ")),
        ]
    }
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

//! Families of gearboxes: a table of them.

use crate::synthesize::answer::families::Family;
use crate::table::columns::Table;
use crate::table::report::Records;
use epicyclic_units::format::trimmed;

/// How many families there are, in words.
pub(super) fn count(families: usize) -> String {
    if families == 1 { "1 family".to_owned() } else { format!("{families} families") }
}

/// The families, with what their gearboxes differ in.
pub(crate) fn table(families: &[Family]) -> Records {
    let range = |[least, most]: [f64; 2]| match [least, most].map(|end| trimmed(end, 4)) {
        [least, most] if least == most => least,
        [least, most] => format!("{least} to {most}"),
    };
    Table::new("families", families)
        .number("family", "family", |of| of.number)
        .number("gearboxes", "gearboxes", |of| of.gearboxes)
        .number("best", "best no.", |of| of.best)
        .number("drawable", "drawable", |of| of.drawable)
        .words("forward_efficiency", "η fwd", |of| range(of.forward_efficiency_range))
        .words("mean_drag_of_input", "drag", |of| range(of.mean_drag_of_input_range))
        .words("greatest_torque_of_input", "torque", |of| range(of.greatest_torque_of_input_range))
        .words("greatest_speed_of_input", "speed", |of| range(of.greatest_speed_of_input_range))
        .all("Families, the lowest and highest of their gearboxes")
        .note("Drag, torque and speed over the input's, as in the ratings.")
        .records()
}

//! Families of gearboxes: a table of them.

use crate::synthesize::answer::families::Family;
use crate::table::figure::{self, Figure};
use crate::table::report::{Column, Records, View};
use epicyclic_units::format::trimmed;

/// How many families there are, in words.
pub(super) fn count(families: usize) -> String {
    if families == 1 { "1 family".to_owned() } else { format!("{families} families") }
}

/// The families, with what their gearboxes differ in.
pub(crate) fn table(families: &[Family]) -> Records {
    let range = |[least, most]: [f64; 2]| match [least, most].map(|end| trimmed(end, 4)) {
        [least, most] if least == most => Figure::Text(least),
        [least, most] => Figure::Text(format!("{least} to {most}")),
    };
    let row = |of: &Family| {
        vec![
            figure::count(of.number),
            figure::count(of.gearboxes),
            figure::count(of.best),
            figure::count(of.drawable),
            range(of.forward_efficiency_range),
            range(of.mean_drag_of_input_range),
            range(of.greatest_torque_of_input_range),
            range(of.greatest_speed_of_input_range),
        ]
    };
    let columns = vec![
        Column::number("family", "family"),
        Column::number("gearboxes", "gearboxes"),
        Column::number("best", "best no."),
        Column::number("drawable", "drawable"),
        Column::words("forward_efficiency", "η fwd"),
        Column::words("mean_drag_of_input", "drag"),
        Column::words("greatest_torque_of_input", "torque"),
        Column::words("greatest_speed_of_input", "speed"),
    ];
    let names = columns.iter().map(|column| column.name).collect();
    Records {
        name: "families",
        columns,
        rows: families.iter().map(row).collect(),
        views: vec![View {
            title: "Families, the lowest and highest of their gearboxes".into(),
            columns: names,
            note: "Drag, torque and speed over the input's, as in the ratings.".into(),
        }],
        is_answer: false,
    }
}

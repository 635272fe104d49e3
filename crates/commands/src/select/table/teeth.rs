//! The choice over tooth numbers, as tables.

use super::{
    best, common_columns, common_figures, length, size_column, size_note, speeds_reached, title, with_speeds,
};
use crate::select::answer::candidate::Candidate;
use crate::select::answer::required::Required;
use crate::select::answer::teeth::{BestOfStructure, Design, SelectTeeth, SetTeeth};
use crate::table::figure::{Figure, multiple, text};
use crate::table::report::AsReport;
use crate::table::report::{Column, Part, Records, Report, Text, View, checked_rows_as_csv};
use crate::teeth::answer::shifted::{RequiredShifts, SetShifts};
use crate::teeth::table::left_out;
use crate::teeth::table::shifted::aim;
use epicyclic_units::Dimension;
use std::io;

impl AsReport for SelectTeeth {
    fn report(&self) -> Report {
        let mut parts = vec![];
        if !self.speeds.is_empty() {
            parts.push(Part::Records(speeds_reached(&self.speeds)));
        }
        match self.designs.first() {
            None => parts.push(Part::Text(Text::paragraph("No design meets every required criterion."))),
            Some(_) => parts.push(Part::Records(designs(self))),
        }
        if self.best_of_structures.len() > 1 {
            parts.push(Part::Records(of_structures(self)));
        }
        parts.push(Part::Text(Text::paragraph(searched(self))));
        if let Some(design) = self.in_full() {
            parts.extend(best::parts(&design.candidate));
        }
        Report { title: Some(title(&self.required)), parts, warnings: None }
    }
}

fn searched(select: &SelectTeeth) -> String {
    let counts = &select.searched;
    let (per_set, designs, pairs) = if is_of_one_set(&select.required) {
        ("", counts.designs.to_string(), "")
    } else {
        (" per set", format!("{:.2e}", counts.designs as f64), "pairs of ")
    };
    let searched = format!(
        "{} combinations of tooth numbers{per_set}, {} structures with their ratios: {designs} designs, all searched; {} \
         {pairs}ring-to-sun ratios were tried in full, {} meet every required criterion.",
        counts.tooth_numbers, counts.structures, counts.tried, counts.accepted
    );
    let shown = match select.shown {
        0 => String::new(),
        1 => " Shown is the first of the non-dominated designs.".to_owned(),
        shown => format!(" Shown are the first {shown} of the non-dominated designs."),
    };
    searched + &shown + &left_out(counts.left_out.as_ref())
}

/// Whether one set was searched and not two.
fn is_of_one_set(required: &Required) -> bool {
    required.ratios.len() == 1
}

/// The keys of the columns of a set.
struct SetColumns {
    shown: &'static str,
    heading: &'static str,
    numbers: [&'static str; 4],
    size: &'static str,
    ring_diameter: &'static str,
    module: &'static str,
    /// Offset and centre distance, then shifts and tip alterations of sun, planets and ring; of sets with
    /// profile shift.
    shifts: [&'static str; 8],
}

/// The headings of the columns of shifts.
const SHIFTS: [&str; 8] = ["offset", "a", "x sun", "x planet", "x ring", "k sun", "k planet", "k ring"];

const SETS: [SetColumns; 2] = [
    SetColumns {
        shown: "teeth_1",
        heading: "set 1",
        numbers: ["sun_1", "planet_1", "ring_1", "planets_1"],
        size: "size_1",
        ring_diameter: "ring_diameter_1",
        module: "module_1",
        shifts: [
            "ring_offset_1",
            "centre_distance_in_modules_1",
            "profile_shift_sun_1",
            "profile_shift_planet_1",
            "profile_shift_ring_1",
            "tip_alteration_sun_1",
            "tip_alteration_planet_1",
            "tip_alteration_ring_1",
        ],
    },
    SetColumns {
        shown: "teeth_2",
        heading: "set 2",
        numbers: ["sun_2", "planet_2", "ring_2", "planets_2"],
        size: "size_2",
        ring_diameter: "ring_diameter_2",
        module: "module_2",
        shifts: [
            "ring_offset_2",
            "centre_distance_in_modules_2",
            "profile_shift_sun_2",
            "profile_shift_planet_2",
            "profile_shift_ring_2",
            "tip_alteration_sun_2",
            "tip_alteration_planet_2",
            "tip_alteration_ring_2",
        ],
    },
];

fn designs(select: &SelectTeeth) -> Records {
    let candidates: Vec<Candidate> =
        select.designs.iter().take(1).map(|design| design.candidate.clone()).collect();
    let size = size_column(&candidates);
    let columns = columns(select.profile_shift.is_some());
    let one = is_of_one_set(&select.required);
    let (sets, ratios): (&[&str], &[&str]) = if one {
        (&["no", "scheme", "teeth_1", "others"], &["no", "ratio_1", "k1", "efficiency_1"])
    } else {
        (
            &["no", "scheme", "teeth_1", "teeth_2", "others"],
            &["no", "ratio_1", "ratio_2", "k1", "k2", "efficiency_1", "efficiency_2"],
        )
    };
    let note = if one { "Set 1" } else { "Sets" };
    let mut views = vec![
        View {
            note: format!(
                "{note}: teeth of sun, planet, ring x planets. Others: designs with the same objectives."
            ),
            ..View::new("Designs, the best first", sets)
        },
        View {
            note: if select.required.input_speed_rad_s.is_some() { "n: of the output, rpm." } else { "" }
                .to_owned(),
            ..View::new(
                if one { "Ratio and efficiency" } else { "Ratios and efficiencies" },
                &with_speeds(&select.required, ratios),
            )
        },
        View {
            note: format!(
                "Non-dominated: no other design is better in one and worse in none. {}",
                size_note(&select.required)
            ),
            ..View::new("Objectives", &["no", "efficiency", "speed", "k_distance", "ratio_error", size])
        },
    ];
    if size == "ring_diameter" && one {
        views.push(View::new(
            "Ring diameter and module needed at the load factor",
            &["no", "ring_diameter_1", "module_1"],
        ));
    } else if size == "ring_diameter" {
        views.push(View::new(
            "Ring diameters and modules needed at the load factor",
            &["no", "ring_diameter_1", "module_1", "ring_diameter_2", "module_2"],
        ));
    }
    if let Some(shift) = &select.profile_shift {
        views.extend(shifts(select, shift, one));
    }
    Records {
        name: "designs",
        columns,
        rows: select.designs.iter().map(|design| row(design, select.profile_shift.is_some())).collect(),
        views,
        is_answer: true,
    }
}

/// The profile shifts of each set.
fn shifts(select: &SelectTeeth, shift: &RequiredShifts, one: bool) -> Vec<View> {
    let sets = select.designs.iter().flat_map(|design| &design.tooth_numbers);
    let limited = match sets.flat_map(|set| &set.shifts).all(|set| set.aim_met) {
        true => "",
        false => ", as far as the limits allow",
    };
    let count = if one { 1 } else { SETS.len() };
    let mut views: Vec<View> = SETS[..count]
        .iter()
        .map(|set| {
            View::new(format!("Profile shifts of {}", set.heading), &[&["no"], &set.shifts[..]].concat())
        })
        .collect();
    if let Some(last) = views.last_mut() {
        last.note = format!(
            "Offset: teeth of the ring less those of the sun and twice those of a planet. a: centre distance; x: profile shift, of the ring \
             above 0 inwards; k: tip alteration; in modules. Aim: {}{limited}.",
            aim(shift.aim)
        );
    }
    views
}

/// The best design of each structure: designs of one differ little from each other at the head of the list.
fn of_structures(select: &SelectTeeth) -> Records {
    let one = is_of_one_set(&select.required);
    let shown: &[&str] = if one {
        &["scheme", "teeth_1", "ratio_1", "efficiency_1", "speed", "ratio_error", "size"]
    } else {
        &["scheme", "teeth_1", "teeth_2", "ratio_1", "ratio_2", "efficiency"]
    };
    let reversed = if select.best_of_structures.iter().any(|one| one.mixed_directions) {
        " A negative ratio: the output reverses against direct drive; such designs are ranked last."
    } else {
        ""
    };
    let note = format!("By the same order, whether or not another structure surpasses it.{reversed}");
    let row = |one: &BestOfStructure| {
        let gear = |place: usize| one.gears.get(place);
        let teeth =
            |place: usize| one.tooth_numbers.get(place).map_or(Figure::None, |set| text(teeth_of(set)));
        vec![
            text(one.scheme.unwrap_or(&one.structure)),
            teeth(0),
            teeth(1),
            multiple(gear(0).map(|gear| gear.ratio)),
            multiple(gear(1).map(|gear| gear.ratio)),
            multiple(gear(0).and_then(|gear| gear.efficiency)),
            Figure::Multiple(one.objectives.efficiency),
            Figure::Multiple(one.objectives.speed_of_input),
            Figure::Multiple(one.objectives.ratio_error),
            Figure::Multiple(one.objectives.size),
        ]
    };
    Records {
        name: "best_of_structures",
        columns: vec![
            Column::words("scheme", "scheme"),
            Column::words("teeth_1", "set 1"),
            Column::words("teeth_2", "set 2"),
            Column::number("ratio_1", "i₁"),
            Column::number("ratio_2", "i₂"),
            Column::number("efficiency_1", "η₁"),
            Column::number("efficiency", "least η"),
            Column::number("speed", "speed"),
            Column::number("ratio_error", "ratio error"),
            Column::number("size", "size"),
        ],
        rows: select.best_of_structures.iter().map(row).collect(),
        views: vec![View { note, ..View::new("The best design of each scheme", shown) }],
        is_answer: false,
    }
}

/// What the list says of each design, with profile shift or without.
fn columns(shifted: bool) -> Vec<Column> {
    let mut columns = common_columns();
    columns.push(Column::number("others", "others"));
    for set in SETS {
        columns.push(Column::words(set.shown, set.heading).for_people());
        columns.extend(set.numbers.map(|name| Column::number(name, name)));
        columns.push(Column::number(set.size, set.size));
        let number = set.heading.trim_start_matches("set ");
        for (name, what) in [(set.ring_diameter, "ring"), (set.module, "module")] {
            let heading = format!("{what} {number}, mm");
            columns.push(Column { heading, ..Column::quantity(name, Dimension::Length) });
        }
        if shifted {
            columns.extend(
                set.shifts.into_iter().zip(SHIFTS).map(|(name, heading)| Column::number(name, heading)),
            );
        }
    }
    columns
}

/// The list as CSV, each design when it comes; of sets with profile shift these, too.
///
/// # Errors
/// Those of the writer and of the designs; a number too large for its unit.
pub fn csv<E: Into<Box<dyn std::error::Error + Send + Sync>>>(
    designs: impl Iterator<Item = Result<Design, E>>,
    shifted: bool,
    out: impl io::Write,
) -> io::Result<()> {
    let rows = designs.map(|design| design.map(|design| row(&design, shifted)));
    checked_rows_as_csv("designs", &columns(shifted), rows, out)
}

fn row(design: &Design, shifted: bool) -> Vec<Figure> {
    let mut figures = common_figures(&design.candidate);
    figures.push(Figure::Count(u32::try_from(design.others).unwrap_or(u32::MAX)));
    for set in 0..SETS.len() {
        figures.extend(of_set(design.tooth_numbers.get(set)));
        if shifted {
            figures.extend(of_shifts(design.tooth_numbers.get(set).and_then(|set| set.shifts.as_ref())));
        }
    }
    figures
}

fn teeth_of(set: &SetTeeth) -> String {
    format!("{} {} {} x{}", set.sun, set.planet, set.ring, set.planets)
}

fn of_shifts(shifts: Option<&SetShifts>) -> Vec<Figure> {
    let Some(shifts) = shifts else { return vec![Figure::None; SHIFTS.len()] };
    let mut figures = vec![
        Figure::Number(f64::from(shifts.ring_offset)),
        Figure::Printed(shifts.centre_distance_in_modules, 3),
    ];
    figures.extend(shifts.profile_shifts.map(|shift| Figure::Printed(shift, 4)));
    figures.extend(shifts.tip_alterations.map(|alteration| Figure::Printed(alteration, 4)));
    figures
}

fn of_set(set: Option<&SetTeeth>) -> Vec<Figure> {
    let Some(set) = set else { return vec![Figure::None; 8] };
    vec![
        text(teeth_of(set)),
        Figure::Count(set.sun),
        Figure::Count(set.planet),
        Figure::Count(set.ring),
        Figure::Count(set.planets),
        Figure::Multiple(set.size),
        length(set.ring_diameter_m),
        length(set.module_m),
    ]
}

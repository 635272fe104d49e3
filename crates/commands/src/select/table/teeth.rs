//! The choice over tooth numbers, as tables.

use super::{best, of_candidate, size_column, size_note, speeds_reached, title, with_speeds};
use crate::select::answer::candidate::Candidate;
use crate::select::answer::required::Required;
use crate::select::answer::teeth::{BestOfStructure, Design, SelectTeeth, SetTeeth};
use crate::shared::judgement::table as judgement;
use crate::table::columns::Table;
use crate::table::figure::Figure;
use crate::table::report::AsReport;
use crate::table::report::{Part, Records, Report, Text, View, checked_rows_as_csv};
use crate::teeth::answer::shifted::{RequiredShifts, SetShifts};
use crate::teeth::table::left_out;
use crate::teeth::table::shifted::aim;
use epicyclic_units::Dimension::Length;
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
        parts.extend(judgement::parts(&self.judgement));
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

/// One of the figures of shifts.
type OfShifts = fn(&SetShifts) -> Figure;

/// The columns of shifts: heading and figure.
const SHIFTS: [(&str, OfShifts); 8] = [
    ("offset", |of| Figure::Number(f64::from(of.ring_offset))),
    ("a", |of| Figure::Printed(of.centre_distance_in_modules, 3)),
    ("x sun", |of| Figure::Printed(of.profile_shifts[0], 4)),
    ("x planet", |of| Figure::Printed(of.profile_shifts[1], 4)),
    ("x ring", |of| Figure::Printed(of.profile_shifts[2], 4)),
    ("k sun", |of| Figure::Printed(of.tip_alterations[0], 4)),
    ("k planet", |of| Figure::Printed(of.tip_alterations[1], 4)),
    ("k ring", |of| Figure::Printed(of.tip_alterations[2], 4)),
];

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
    table(&select.designs, select.profile_shift.is_some()).views(views).the_answer().records()
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
    let shown = if one {
        "scheme teeth_1 ratio_1 efficiency_1 speed ratio_error size"
    } else {
        "scheme teeth_1 teeth_2 ratio_1 ratio_2 efficiency"
    };
    let reversed = if select.best_of_structures.iter().any(|one| one.mixed_directions) {
        " A negative ratio: the output reverses against direct drive; such designs are ranked last."
    } else {
        ""
    };
    let note = format!("By the same order, whether or not another structure surpasses it.{reversed}");
    let teeth = |one: &BestOfStructure, set: usize| one.tooth_numbers.get(set).map(teeth_of);
    Table::new("best_of_structures", &select.best_of_structures)
        .words("scheme", "scheme", |one| one.scheme.unwrap_or(&one.structure))
        .words("teeth_1", "set 1", |one| teeth(one, 0))
        .words("teeth_2", "set 2", |one| teeth(one, 1))
        .multiple("ratio_1", "i₁", |one| Some(one.gears.first()?.ratio))
        .multiple("ratio_2", "i₂", |one| Some(one.gears.get(1)?.ratio))
        .multiple("efficiency_1", "η₁", |one| one.gears.first()?.efficiency)
        .multiple("efficiency", "least η", |one| one.objectives.efficiency)
        .multiple("speed", "speed", |one| one.objectives.speed_of_input)
        .multiple("ratio_error", "ratio error", |one| one.objectives.ratio_error)
        .multiple("size", "size", |one| one.objectives.size)
        .view("The best design of each scheme", shown)
        .note(note)
        .records()
}

/// The list with what it says of each design, with profile shift or without.
fn table(designs: &[Design], shifted: bool) -> Table<&Design> {
    of_candidate(Table::new("designs", designs), |design| &design.candidate)
        .number("others", "others", |design| design.others)
        .each((0..).zip(SETS), |table, (place, set)| {
            let [sun, planet, ring, planets] = set.numbers;
            let number = set.heading.trim_start_matches("set ");
            table
                .words(set.shown, set.heading, |design| design.tooth_numbers.get(place).map(teeth_of))
                .for_people()
                .number(sun, sun, |design| Some(design.tooth_numbers.get(place)?.sun))
                .number(planet, planet, |design| Some(design.tooth_numbers.get(place)?.planet))
                .number(ring, ring, |design| Some(design.tooth_numbers.get(place)?.ring))
                .number(planets, planets, |design| Some(design.tooth_numbers.get(place)?.planets))
                .multiple(set.size, set.size, |design| Some(design.tooth_numbers.get(place)?.size))
                .quantity(set.ring_diameter, &format!("ring {number}"), Length, |design| {
                    design.tooth_numbers.get(place)?.ring_diameter_m
                })
                .quantity(set.module, &format!("module {number}"), Length, |design| {
                    design.tooth_numbers.get(place)?.module_m
                })
                .each(
                    set.shifts.into_iter().zip(SHIFTS).filter(|_| shifted),
                    |table, (key, (heading, of))| {
                        table.number(key, heading, |design| {
                            design.tooth_numbers.get(place)?.shifts.as_ref().map(of)
                        })
                    },
                )
        })
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
    checked_rows_as_csv(designs, |designs| table(designs, shifted).records(), out)
}

fn teeth_of(set: &SetTeeth) -> String {
    format!("{} {} {} x{}", set.sun, set.planet, set.ring, set.planets)
}

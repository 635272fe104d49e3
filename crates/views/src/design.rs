//! A design from speeds and power, step by step.

use crate::AsReport;
use crate::figure::{Figure, text};
use crate::quantities::words;
use crate::report::{Column, Part, Records, Report, Text, View, warned};
use crate::size::{designs, left_out};
use crate::strength::{Worn, over_duty};
use epicyclic_answers::design::Design;
use epicyclic_answers::design::records::{BasisKey, SchemeStep, SizesStep, TeethStep, TeethTaken};
use epicyclic_answers::select::required::Objective;
use epicyclic_answers::size::records::{Requirement, SizedDesign, SizedSet};
use epicyclic_formats::Dimension;
use epicyclic_formats::quantity::format::trimmed;

/// Digits of ratios and of lengths in words.
const DIGITS: usize = 4;

impl AsReport for Design {
    fn report(&self) -> Report {
        let mut parts = parts_of_choice(self);
        parts.extend(self.sizes.iter().flat_map(parts_of_sizes));
        Report { title: Some(in_short(self)), parts, warnings: warned(&self.warnings) }
    }
}

/// The steps, and what no speed tells.
pub(crate) fn parts_of_choice(design: &Design) -> Vec<Part> {
    let mut parts = vec![Part::Records(steps(design))];
    parts.extend(stopped(design).map(|why| Part::Text(Text::paragraph(why))));
    parts.push(Part::Records(basis(&design.basis)));
    parts
}

/// The sizes with their safeties, and what was left out.
pub(crate) fn parts_of_sizes(sizes: &SizesStep) -> Vec<Part> {
    let sets = &sizes.sets;
    let mut parts = vec![];
    if sets.iter().any(|set| !set.found.is_empty()) {
        parts.push(Part::Records(Records {
            is_answer: false,
            ..designs("designs", "Best sizes", sets, |set| &set.found)
        }));
        parts.push(Part::Records(over_duty(sets.iter().flat_map(safeties))));
    }
    if sets.iter().any(|set| set.nearest_miss.is_some()) {
        let misses = designs("nearest_misses", "Nearest misses", sets, |set| set.nearest_miss.as_slice());
        parts.push(Part::Records(misses));
    }
    parts.push(Part::Records(left_out(sets)));
    parts
}

/// The gears of the best size of a set.
fn safeties(set: &SizedSet) -> impl Iterator<Item = Worn<'_>> {
    let best = set.found.first();
    best.into_iter().flat_map(|best| &best.over_duty).map(|of| Worn {
        set: &set.set,
        mesh: of.mesh,
        toothed_gear: of.toothed_gear,
        material: &of.material,
        flank: Some(&of.flank),
        root: Some(&of.root),
    })
}

/// The scheme with the mass of its gears.
pub(crate) fn in_short(design: &Design) -> String {
    let name = design.scheme.taken.as_deref().unwrap_or("no scheme");
    match design.sizes.as_ref().and_then(|sizes| sizes.mass_kg).filter(|_| design.file.is_some()) {
        Some(mass) => {
            format!("{name}: gears of {} hold over the duty.", words(Dimension::Mass, mass, DIGITS))
        }
        None => format!("{name}: no gearbox that holds was found."),
    }
}

/// Why a design has an end before its last step.
fn stopped(design: &Design) -> Option<String> {
    let why = match (&design.teeth, &design.sizes, &design.file) {
        (None, ..) => {
            "No scheme meets the criteria. `epicyclic select` with the same speeds tells which criterion each one fails."
        }
        (Some(_), None, _) => {
            "No tooth numbers within the bounds give the ratios, or not so many. A wider --sun, --planet, --ring or --tolerance would help."
        }
        (.., None) => "No size of a set holds over the duty; the nearest misses tell what they lack.",
        _ => return None,
    };
    Some(why.to_owned())
}

fn steps(design: &Design) -> Records {
    let mut rows = vec![scheme(&design.scheme)];
    rows.extend(design.teeth.as_ref().map(teeth));
    rows.extend(design.sizes.as_ref().map(sizes));
    rows.extend(design.sizes.as_ref().and_then(strength));
    Records {
        name: "steps",
        columns: vec![
            Column::words("step", "step"),
            Column::words("taken", "taken"),
            Column::words("among", "among"),
            Column::words("next", "next"),
            Column::words("chosen_otherwise_by", "otherwise by"),
        ],
        rows: rows
            .into_iter()
            .map(|row| row.map(|cell| if cell.is_empty() { Figure::None } else { text(cell) }).to_vec())
            .collect(),
        views: vec![View::new("Steps: what was taken", &["step", "taken"]), View {
            note: "Each step takes the best of the one before it; all together are not searched. Other tooth numbers, or another scheme, may be \
                   lighter."
                .to_owned(),
            ..View::new("Steps: among what, what came next, and how to choose otherwise", &["step", "among", "next", "chosen_otherwise_by"])
        }],
        is_answer: true,
    }
}

fn scheme(step: &SchemeStep) -> [String; 5] {
    let among = match step.decided_by {
        _ if step.asked_for => "asked for".to_owned(),
        None => format!("{} of {} that meet the criteria", step.accepted, step.compared),
        Some(by) => {
            format!("{} of {} that meet the criteria, by {}", step.accepted, step.compared, objective(by))
        }
    };
    let taken = step.taken.clone().unwrap_or_else(|| "none".to_owned());
    ["scheme".to_owned(), taken, among, step.next.clone().unwrap_or_default(), "--scheme, --order".to_owned()]
}

const fn objective(objective: Objective) -> &'static str {
    match objective {
        Objective::Efficiency => "efficiency",
        Objective::Speed => "speed",
        Objective::RingToSunRatio => "k",
        Objective::RatioError => "ratio error",
        Objective::Size => "size",
        Objective::Circulation => "circulating power",
    }
}

fn teeth(step: &TeethStep) -> [String; 5] {
    let sets = |of: &TeethTaken| {
        let all: Vec<String> =
            of.sets.iter().map(|[sun, planet, ring]| format!("{sun} {planet} {ring}")).collect();
        all.join(" + ")
    };
    let taken = step.taken.as_ref().map_or_else(
        || "none".to_owned(),
        |of| {
            let ratios: Vec<String> = of.ratios.iter().map(|ratio| trimmed(*ratio, DIGITS)).collect();
            format!("no. {}: {}, i = {}", of.number, sets(of), ratios.join(" and "))
        },
    );
    let among = format!("{} of {} with sizes", step.tried, step.accepted);
    let mass = |of: &TeethTaken| of.mass_kg.map(|mass| format!(", {}", words(Dimension::Mass, mass, DIGITS)));
    let next = step
        .next
        .as_ref()
        .map(|of| format!("no. {}: {}{}", of.number, sets(of), mass(of).unwrap_or_default()));
    ["teeth".to_owned(), taken, among, next.unwrap_or_default(), "--tooth-design, --tries".to_owned()]
}

fn sizes(step: &SizesStep) -> [String; 5] {
    let length = |si: f64| words(Dimension::Length, si, DIGITS);
    let of = |design: &SizedDesign| {
        format!(
            "m {}, b {}, {} planets",
            length(design.module_m),
            length(design.face_width_m),
            design.planets
        )
    };
    let all = |place: usize| {
        let each = step.sets.iter().map(|set| set.found.get(place).map_or("none".to_owned(), of));
        each.collect::<Vec<_>>().join(" + ")
    };
    let next = if step.sets.iter().all(|set| set.found.len() > 1) { all(1) } else { String::new() };
    ["sizes".to_owned(), all(0), format!("{} designs", step.designs), next, "--modules …, --save".to_owned()]
}

fn strength(step: &SizesStep) -> Option<[String; 5]> {
    let governing = step.governing.as_ref()?;
    let of = governing.requirement;
    let what = match of.requirement {
        Requirement::Flank => format!("S_H of the {}'s flank", of.toothed_gear),
        Requirement::Root => format!("S_F of the {}'s root", of.toothed_gear),
        Requirement::OverloadFlank => format!("S_H of the {}'s flank against the overload", of.toothed_gear),
        Requirement::OverloadRoot => format!("S_F of the {}'s root against the overload", of.toothed_gear),
        Requirement::BearingLife => {
            "of the planet bearing, the load that it carries for the required life over its own".to_owned()
        }
    };
    let taken = format!(
        "{} of {} required: {what} of set {}",
        trimmed(of.value, DIGITS),
        trimmed(of.required, DIGITS),
        governing.set
    );
    Some(["strength".to_owned(), taken, String::new(), String::new(), "--basis, --factors".to_owned()])
}

fn basis(keys: &[BasisKey]) -> Records {
    Records {
        name: "basis",
        columns: vec![Column::words("key", "key"), Column::words("value", "value")],
        rows: keys.iter().map(|key| vec![text(&key.key), text(&key.value)]).collect(),
        views: vec![View {
            note: "As keys of the gearbox file, which --save writes; lists of sun, planets and ring. Factors given are not calculated."
                .to_owned(),
            ..View::new("What no speed tells (--basis, --factors, --life)", &["key", "value"])
        }],
        is_answer: false,
    }
}

//! Sizes of sets as tables.

use crate::shared::basis::BasisKey;
use crate::shared::judgement::table as judgement;
use crate::size::answer::Size;
use crate::size::answer::records::{
    NotSized, SizedDesign, SizedFamily, SizedGear, SizedSet, SizedTeeth, Sought,
};
use crate::table::columns::Table;
use crate::table::figure::{Figure, hours, text};
use crate::table::quantities::{quantity, words};
use crate::table::report::AsReport;
use crate::table::report::{Part, Records, Report, Row, Section, warned};
use epicyclic_gears::life::Rolling;
use epicyclic_strength::sizing::{Objective, Requirement};
use epicyclic_units::Dimension;

impl AsReport for Size {
    fn report(&self) -> Report {
        let parts = [
            (!self.basis.is_empty())
                .then(|| Part::Records(basis(&self.basis, "Assumed values, usual of the application"))),
            Some(Part::Facts(facts(self))),
            (!self.sets.iter().all(|set| set.found.is_empty()))
                .then(|| Part::Records(designs("designs", "Best designs", &self.sets, |set| &set.found))),
            (!self.sets.iter().all(|set| set.found.is_empty())).then(|| Part::Records(gears(&self.sets))),
            self.sets.iter().any(|set| set.nearest_miss.is_some()).then(|| {
                Part::Records(designs("nearest_misses", "Nearest misses", &self.sets, |set| {
                    set.nearest_miss.as_slice()
                }))
            }),
            Some(Part::Records(left_out(&self.sets))),
            (!self.not_sized.is_empty()).then(|| Part::Records(not_sized(&self.not_sized))),
        ];
        let what = match (self.mass_kg, self.minimise) {
            (None, _) => "not every set has a size that meets the requirements.".to_owned(),
            (Some(mass), Objective::Mass) => {
                format!(
                    "gears of {}, the lightest of {} designs.",
                    words(Dimension::Mass, mass, 4),
                    self.designs
                )
            }
            (Some(mass), Objective::Whole) => format!(
                "about {} with carriers and housing, the lightest of {} designs, gears of {}.",
                words(Dimension::Mass, self.with_structure_kg.unwrap_or_default(), 3),
                self.designs,
                words(Dimension::Mass, mass, 4)
            ),
            (Some(mass), Objective::Ring) => format!(
                "the smallest rings of {} designs, gears of {}.",
                self.designs,
                words(Dimension::Mass, mass, 4)
            ),
        };
        Report {
            title: Some(format!("{}: {what}", self.gearbox)),
            parts: parts.into_iter().flatten().chain(judgement::parts(&self.judgement)).collect(),
            warnings: warned(&self.warnings),
        }
    }
}

/// Assumed values by key.
pub(crate) fn basis(keys: &[BasisKey], title: &str) -> Records {
    let note = "As keys of the gearbox file, which --save writes; lists of sun, planets and ring. Factors given are not calculated.";
    Table::new("basis", keys.iter())
        .text("key", "key", |key| &key.key)
        .text("value", "value", |key| &key.value)
        .view(title, "key value")
        .note(note)
        .records()
}

fn facts(size: &Size) -> Section {
    let Sought {
        modules_m,
        face_widths_m,
        planets,
        centre_distance_step_m,
        reach_in_modules,
        width_ratio,
        largest_ring_m,
        least_tip_thickness_in_modules,
        planet_rim_in_modules,
        ring_rim_in_modules,
        bearings,
    } = &size.sought;
    let lengths = |si: &[f64]| Figure::List { si: si.to_vec(), dimension: Dimension::Length };
    let number = |value: f64| Figure::Number(value);
    let rows = vec![
        Row::new("designs", "designs of all sets", "", [number(size.designs as f64)]),
        Row::new("modules", "modules", "m", [lengths(modules_m)]),
        Row::new("face_widths", "face widths", "b", [lengths(face_widths_m)]),
        Row::new("planets", "planets", "p", [Figure::Texts(planets.iter().map(u32::to_string).collect())]),
        Row::new(
            "centre_distance_step",
            "step of the centre distances",
            "",
            [quantity(Dimension::Length, *centre_distance_step_m)],
        ),
        Row::new("reach", "their reach, in modules", "", [number(*reach_in_modules)]),
        Row::new(
            "width_ratio",
            "greatest face width over diameter",
            "b/d",
            [width_ratio.map_or(Figure::None, Figure::Number)],
        ),
        Row::new(
            "largest_ring",
            "greatest outside diameter of a ring",
            "",
            [largest_ring_m.map_or(Figure::None, |ring| quantity(Dimension::Length, ring))],
        ),
        Row::new("bearings", "bearings", "", [number(*bearings as f64)]),
        Row::new("tip_thickness", "least tips, in modules", "", [number(*least_tip_thickness_in_modules)]),
        Row::new("planet_rim", "least rim of planets, in modules", "", [number(*planet_rim_in_modules)]),
        Row::new("ring_rim", "rim of the ring, in modules", "", [number(*ring_rim_in_modules)]),
        Row::new("life", "required life", "L", [quantity(Dimension::Time, size.life_s)]),
        Row::new("required_flank", "required safety, flank", "", [number(size.required.flank)]),
        Row::new("required_root", "required safety, root", "", [number(size.required.root)]),
        Row::new(
            "oil_viscosity",
            "viscosity of the oil",
            "ν_40",
            [quantity(Dimension::Viscosity, size.oil_viscosity_m2_s)],
        ),
        Row::new("edition", "edition, method B", "", [text(&size.edition)]),
    ];
    Section { name: "space", title: "Space and requirements", columns: &[], rows, note: "" }
}

/// What governs a design: `S_F sun 1.45`.
pub(crate) fn governing(design: &SizedDesign) -> String {
    let of = &design.governing;
    let what = match of.requirement {
        Requirement::BearingLife => return format!("bearing {:.3}", of.value),
        Requirement::Flank | Requirement::OverloadFlank => "S_H",
        Requirement::Root | Requirement::OverloadRoot => "S_F",
    };
    let against = if of.requirement.is_against_overload() { ", overload" } else { "" };
    format!("{what} {} {:.3}{against}", of.toothed_gear, of.value)
}

pub(crate) fn designs<'s>(
    name: &'static str,
    title: &str,
    sets: &'s [SizedSet],
    of: impl Fn(&'s SizedSet) -> &'s [SizedDesign],
) -> Records {
    let least = |design: &SizedDesign, safety: fn(&SizedGear) -> f64| {
        design.over_duty.iter().map(safety).fold(f64::INFINITY, f64::min)
    };
    let lives = |design: &SizedDesign| {
        let own = design.planet_sizes.iter().filter_map(|planet| planet.bearing.as_ref()?.life_s);
        own.reduce(f64::min)
    };
    let lengths = |design: &SizedDesign, of: fn(&SizedFamily) -> f64| -> Vec<f64> {
        design.families.iter().map(of).collect()
    };
    let bearings = |design: &SizedDesign| {
        let names =
            design.planet_sizes.iter().filter_map(|planet| planet.bearing.as_ref()?.designation.clone());
        let mut names: Vec<String> = names.collect();
        names.dedup();
        names
    };
    let width_ratio = |design: &SizedDesign| {
        design.families.iter().map(|family| family.face_width_over_diameter).fold(0.0, f64::max)
    };
    let is_plain = |design: &SizedDesign| {
        let mut own = design.planet_sizes.iter().filter_map(|planet| planet.bearing.as_ref());
        own.any(|bearing| bearing.rolling == Rolling::Plain.name())
    };
    let governs = "Governs: what has the least reserve of torque; flanks have that of S_H².";
    let note = match sets.iter().flat_map(&of).any(is_plain) {
        true => format!("{governs} Plain bearings have no L_10: their load and oil film are checked."),
        false => governs.to_owned(),
    };
    Table::new(
        name,
        sets.iter().flat_map(|set| (1_u32..).zip(of(set)).map(move |(place, one)| (set, place, one))),
    )
    .text("set", "set", |(set, ..)| &set.set)
    .number("place", "no.", |(_, place, _)| *place)
    .list("module", "m", Dimension::Length, |(.., one)| lengths(one, |family| family.module_m))
    .list("face_width", "b", Dimension::Length, |(.., one)| lengths(one, |family| family.face_width_m))
    .printed("face_width_over_diameter", "b/d", 2, |(.., one)| width_ratio(one))
    .number("planets", "planets", |(.., one)| one.planets)
    .quantity("centre_distance", "a", Dimension::Length, |(.., one)| one.centre_distance_m)
    .words("bearing", "bearing", |(.., one)| bearings(one))
    .quantity("ring_diameter", "ring", Dimension::Length, |(.., one)| one.ring_diameter_m)
    .quantity("mass", "", Dimension::Mass, |(.., one)| one.mass_kg)
    .words("usual", "usual", |(.., one)| one.rules_missed == 0)
    .words("governing", "governs", |(.., one)| governing(one))
    .printed("flank_safety", "S_H", 3, |(.., one)| least(one, |gear| gear.flank.safety))
    .printed("root_safety", "S_F", 3, |(.., one)| least(one, |gear| gear.root.safety))
    .quantity("bearing_life", "", Dimension::Time, |(.., one)| lives(one))
    .number("bearing_hours", "L_10, h", |(.., one)| lives(one).map(hours))
    .for_people()
    .view(
        title,
        "set place module face_width face_width_over_diameter planets centre_distance ring_diameter mass usual",
    )
    .note("ring: outside diameter of the largest, or of the circle that planets reach to. b/d: face width over the reference diameter of the smallest sun, of a pair of the smaller gear; --width-ratio bounds it. A list has a value for each family of gears in mesh. Usual: gears, widths, speeds and bearings miss no rule of practice; of others each miss counts as a quarter more.")
    .view(
        format!("{title}: bearings and their life, least safeties"),
        "set place bearing governing bearing_hours flank_safety root_safety",
    )
    .note(&note)
    .the_answer_if(name == "designs")
    .records()
}

/// Teeth of the best design of each set.
pub(crate) fn gears(sets: &[SizedSet]) -> Records {
    let rows = sets.iter().filter_map(|set| Some((set, set.found.first()?)));
    let rows = rows.flat_map(|(set, best)| best.gears.iter().map(move |gear| (set, best, gear)));
    let family = |design: &SizedDesign, gear: &SizedTeeth, of: fn(&SizedFamily) -> f64| {
        design.families.iter().find(|family| family.toothed_gears.contains(&gear.toothed_gear)).map(of)
    };
    Table::new("gears", rows)
        .text("set", "set", |(set, ..)| &set.set)
        .text("gear", "gear", |(.., gear)| &gear.toothed_gear)
        .number("teeth", "z", |(.., gear)| gear.teeth)
        .quantity("module", "m", Dimension::Length, |(_, best, gear)| family(best, gear, |of| of.module_m))
        .quantity("face_width", "b", Dimension::Length, |(.., gear)| gear.face_width_m)
        .printed("profile_shift", "x", 4, |(.., gear)| gear.profile_shift)
        .printed("tip_alteration", "k", 4, |(.., gear)| gear.tip_alteration)
        .quantity("rim", "rim", Dimension::Length, |(.., gear)| gear.rim_m)
        .view(
            "Gears of the best designs",
            "set gear teeth module face_width profile_shift tip_alteration rim",
        )
        .note("x, k: profile shift and tip alteration in modules.")
        .records()
}

pub(crate) fn left_out(sets: &[SizedSet]) -> Records {
    let held = |set: &SizedSet| set.held.iter().map(|key| key.key().to_owned()).collect::<Vec<_>>();
    Table::new("left_out", sets)
        .text("set", "set", |set| &set.set)
        .words("held", "held by the file", |set| held(set))
        .number("designs", "designs", |set| set.designs as f64)
        .number("spacing", "spacing", |set| set.left_out.spacing as f64)
        .number("planets_touch", "touch", |set| set.left_out.planets_touch as f64)
        .number("geometry", "shifts", |set| set.left_out.geometry as f64)
        .number("practice", "practice", |set| set.left_out.practice as f64)
        .number("width_ratio", "b/d", |set| set.left_out.width_ratio as f64)
        .number("ring", "ring", |set| set.left_out.ring as f64)
        .number("rim", "rim", |set| set.left_out.rim as f64)
        .number("bearing_width", "bearing", |set| set.left_out.bearing_width as f64)
        .number("not_calculable", "outside", |set| set.left_out.not_calculable as f64)
        .number("flank", "S_H", |set| set.left_out.flank as f64)
        .number("root", "S_F", |set| set.left_out.root as f64)
        .number("overload", "overload", |set| set.left_out.overload as f64)
        .number("bearing_life", "life", |set| set.left_out.bearing_life as f64)
        .number("not_reached", "not reached", |set| set.not_reached as f64)
        .view(
            "Designs left out before their strength",
            "set designs spacing planets_touch geometry practice width_ratio ring rim bearing_width",
        )
        .view(
            "Designs left out by strength and life",
            "set held not_calculable flank root overload bearing_life not_reached",
        )
        .note("spacing: planets not at equal angles. shifts: none without fault. practice: refused by usual practice or stated limits. b/d: wider than allowed. ring: larger than allowed. rim: thinner than allowed. bearing: wider than its planet. outside: beyond the standard. A design that misses several of S_H, S_F and overload counts where it misses most, and for life only where its teeth hold. not reached: not checked, no better than the last one found.")
        .records()
}

fn not_sized(all: &[NotSized]) -> Records {
    Table::new("not_sized", all.iter())
        .text("set", "set", |one| &one.set)
        .words("reason", "why", |one| one.why())
        .view("Not sized", "set reason")
        .records()
}

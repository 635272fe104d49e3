//! A gearbox for a list of gears, asked and reached, with what came next.

use crate::design::answer::transmission::{NEAREST, Transmission};
use crate::design::answer::transmission_records::{GearboxOfRing, GearboxWithTeeth};
use crate::design::table::{
    ASSUMED, OF_FRONT, SMALLER_RINGS, assumed, lightest, limits, masses, of_found, of_sizes, options_of,
    or_none, parts_of_sizes, ways_out,
};
use crate::select::table::percent;
use crate::size::table::basis;
use crate::synthesize::answer::teeth::TeethOfSet;
use crate::table::columns::Table;
use crate::table::report::{AsReport, Part, Records, Report, Text};
use epicyclic_units::Dimension;
use epicyclic_units::format::trimmed;

impl AsReport for Transmission {
    fn report(&self) -> Report {
        let mut parts = parts_of_transmission(self);
        parts.extend(self.sizes.iter().flat_map(parts_of_sizes));
        Report { title: Some(in_short(self)), parts, warnings: of_found(&self.warnings, self.file.is_some()) }
    }
}

/// Gears asked and reached, the gearboxes that were sized, and assumed values.
pub(crate) fn parts_of_transmission(transmission: &Transmission) -> Vec<Part> {
    let mut parts = vec![Part::Records(gears(transmission))];
    if !transmission.gearboxes.is_empty() {
        parts.push(Part::Records(gearboxes(&transmission.gearboxes)));
    }
    parts.extend(transmission.front.as_deref().map(|front| or_none(front, smaller_rings)));
    parts.extend(too_heavy(transmission).map(|why| Part::Text(Text::paragraph(why))));
    if !transmission.ways_out.is_empty() {
        parts.push(Part::Records(ways_out(&transmission.ways_out)));
    }
    parts.extend(limits(&transmission.limits, transmission.masses.as_ref(), transmission.sizes.as_ref()));
    parts.extend(transmission.masses.as_ref().map(|of| Part::Facts(masses(of))));
    parts.push(Part::Records(basis(&transmission.basis, &format!("{ASSUMED}, --efficiency"))));
    parts.push(Part::Records(assumed(&transmission.assumed)));
    parts
}

/// The best gearboxes with smaller and smaller rings.
fn smaller_rings(front: &[GearboxOfRing]) -> Records {
    let teeth = |of: &GearboxOfRing| {
        let all = of.teeth.iter().map(|set| set.iter().map(u32::to_string).collect::<Vec<_>>().join(" "));
        all.collect::<Vec<String>>().join(" + ")
    };
    Table::new("front", front.iter())
        .words("option", "option", |of| options_of(&of.limits))
        .words("structure", "structure", |of| of.structure.clone())
        .words("teeth", "sun, planet, ring", move |of| teeth(of))
        .words("deviation", "off by", |of| percent(of.greatest_deviation).trim_start_matches('+').to_owned())
        .quantity("ring_diameter", "ring", Dimension::Length, |of| Some(of.ring_diameter_m))
        .quantity("mass", "whole", Dimension::Mass, |of| of.whole_kg)
        .number("warnings", "warnings", |of| of.warnings as f64)
        .view(SMALLER_RINGS, "option structure teeth deviation ring_diameter mass warnings")
        .note(OF_FRONT)
        .records()
}

/// Number of structures compared where every gearbox is above the limit of the mass, and the lightest.
fn too_heavy(transmission: &Transmission) -> Option<String> {
    let mass = lightest(&transmission.limits)?;
    let of = &transmission.gearboxes;
    let is_new = |(place, one): &(usize, &GearboxWithTeeth)| {
        let structure = |of: &GearboxWithTeeth| (of.structure.clone(), of.shift_elements.clone());
        of[..*place].iter().all(|before| structure(before) != structure(one))
    };
    let structures = of.iter().enumerate().filter(is_new).count();
    Some(format!(
        "None of the gearboxes of {structures} structures, of {} with the ratios, keeps --max-mass with the best of their {NEAREST} tooth numbers nearest to the \
         ratios; the lightest found has {mass}.",
        transmission.structures
    ))
}

/// The gearbox with its gears, shift elements, deviation, ring, mass, least safeties and life.
pub(crate) fn in_short(transmission: &Transmission) -> String {
    let count = |count: usize, one: &str| format!("{count} {one}{}", if count == 1 { "" } else { "s" });
    let gears = count(transmission.gears.len(), "gear");
    let (Some(taken), Some(sizes)) = (transmission.gearboxes.first(), &transmission.sizes) else {
        return format!("No gearbox with these {gears} that holds was found.");
    };
    let mut all = vec![
        gears,
        count(taken.sets.len(), "set"),
        count(taken.shift_elements.len(), "shift element"),
        format!(
            "ratios within {} % (asked {} %)",
            trimmed(100.0 * taken.greatest_deviation, 3),
            trimmed(100.0 * transmission.tolerance, 3)
        ),
    ];
    if transmission.file.is_none() {
        let above = |mass| format!("whole about {mass}, above --max-mass");
        all.push(lightest(&transmission.limits).map_or("no sizes that hold".to_owned(), above));
    }
    all.extend(of_sizes(sizes, transmission.masses.as_ref(), (&transmission.limits, "ring")));
    format!("{}.", all.join(", "))
}

fn gears(transmission: &Transmission) -> Records {
    Table::new("gears", transmission.gears.iter())
        .words("gear", "gear", |of| of.gear.clone())
        .number("asked_ratio", "i asked", |of| of.asked_ratio)
        .number("ratio", "i reached", |of| of.ratio)
        .words("deviation", "deviation", |of| of.ratio.map(|ratio| percent(ratio / of.asked_ratio - 1.0)))
        .quantity("asked_output_speed", "n asked", Dimension::AngularSpeed, |of| of.asked_output_speed_rad_s)
        .quantity("output_speed", "n reached", Dimension::AngularSpeed, |of| of.output_speed_rad_s)
        .words("engaged", "engaged", |of| of.engaged.join(" "))
        .number("efficiency", "η", |of| of.efficiency)
        .view(
            "Gears asked and reached",
            "gear asked_ratio ratio deviation asked_output_speed output_speed engaged efficiency",
        )
        .note("n: of the output. η: with the efficiency of each set below.")
        .the_answer()
        .records()
}

/// Teeth of sun, planets and ring.
fn teeth(of: &TeethOfSet) -> String {
    let outer = of.outer_planet.map(|outer| format!("+{outer}")).unwrap_or_default();
    format!("{} {}{outer} {}", of.sun, of.planet, of.ring)
}

fn gearboxes(all: &[GearboxWithTeeth]) -> Records {
    let elements = |of: &GearboxWithTeeth| {
        let all: Vec<String> =
            of.shift_elements.iter().map(|element| format!("{} {}", element.name, element.joins)).collect();
        all.join(", ")
    };
    Table::new("gearboxes", all.iter().enumerate())
        .words("taken", "", |(place, of)| (*place == 0 && of.mass_kg.is_some()).then_some("taken"))
        .words("structure", "structure", |(_, of)| of.structure.clone())
        .words("shift_elements", "shift elements", move |(_, of)| elements(of))
        .words("teeth", "sun, planet, ring", |(_, of)| {
            of.sets.iter().map(teeth).collect::<Vec<String>>().join(" + ")
        })
        .words("deviation", "off by", |(_, of)| percent(of.greatest_deviation).trim_start_matches('+').to_owned())
        .number("multiple_shifts", "mult.", |(_, of)| of.multiple_shifts as f64)
        .number("warnings", "warnings", |(_, of)| of.warnings as f64)
        .quantity("ring_diameter", "ring", Dimension::Length, |(_, of)| of.ring_diameter_m)
        .quantity("mass", "gears", Dimension::Mass, |(_, of)| of.mass_kg)
        .view(
            "Gearboxes that were sized",
            "taken structure shift_elements teeth deviation multiple_shifts warnings ring_diameter mass",
        )
        .note(
            "Links: 0 the housing, 1 the input, 2 the output, letters the others; a set is sun-ring-carrier, with a star a \
             double-planet set. A brake B holds its link, a clutch C joins two. mult.: shifts between neighbouring forward \
             gears that exchange more than one shift element. Fewer warnings come first, then less mass of the gears.",
        )
        .records()
}

//! Gearboxes for a list of ratios, as tables.

mod explain;
pub(crate) mod families;
mod rating;
mod teeth;

use crate::answer::Warning;
use crate::shared::judgement::table as judgement;
use crate::synthesize::answer::near_miss::NearMiss;
use crate::synthesize::answer::shared_planets::SharedPlanets;
use crate::synthesize::answer::teeth::TeethOfSet;
use crate::synthesize::answer::{Edge, LeftOut, Listed, Reason, Searched, Solution, Synthesis, WantedGear};
use crate::table::columns::Table;
use crate::table::figure::Figure;
use crate::table::report::AsReport;
use crate::table::report::{Part, Records, Report, Text};
use epicyclic_synthesis::sharing::Obstacle;
use epicyclic_units::format::{significant, trimmed};

/// Solutions whose gears are shown one by one.
const SHOWN_IN_FULL: usize = 3;

impl AsReport for Synthesis {
    fn report(&self) -> Report {
        let ratios: Vec<String> = self.wanted.iter().map(|gear| wanted(gear, self.tolerance)).collect();
        let asked = format!(
            "Ratios {}, each within {} %{}; k from {} to {}{}{}.",
            ratios.join(", "),
            trimmed(100.0 * self.tolerance, 6),
            if ratios.iter().any(|ratio| ratio.contains("to")) { " or the bounds given" } else { "" },
            self.k_range[0],
            self.k_range[1],
            self.k_range_of_double_planets.map_or_else(String::new, |[least, most]| format!(
                ", of double-planet sets from {least} to {most}"
            )),
            self.equal_k.map_or_else(String::new, |count| format!(", equal for at least {count} sets")),
        );
        let mut parts = vec![
            Part::Text(Text::paragraph(asked)),
            Part::Records(searched(&self.searched)),
            Part::Text(Text::paragraph(count(self))),
        ];
        if let Some(near) = &self.near_miss {
            parts.push(Part::Text(Text::paragraph(near_miss(near))));
        }
        for of in &self.teeth_left_out {
            parts.push(Part::Text(Text::paragraph(format!("Of the tooth numbers {}.", of.message))));
        }
        if !self.left_out.is_empty() {
            parts.push(Part::Text(left_out("Left out, each counted once", &self.left_out)));
        }
        if !self.left_behind.is_empty() {
            let heading = "Left behind in smaller classes, where no gearbox is of use, each counted once";
            parts.push(Part::Text(left_out(heading, &self.left_behind)));
        }
        parts.extend(self.explanation.as_ref().map(explain::explained).map(Part::Text));
        if let Some(first) = self.solutions.first() {
            parts.push(Part::Text(Text::paragraph(format!("{NAMES}{}", efficiencies(self)))));
            parts.push(Part::Records(solutions(self)));
            parts.push(Part::Records(rating::ratings(&self.solutions)));
            parts.extend(rating::why(self).map(Part::Text));
            parts.extend(schemes(self).map(Part::Text));
            for found in self.solutions.iter().take(SHOWN_IN_FULL) {
                parts.push(Part::Text(gears(found)));
                parts.extend(teeth::teeth(found.number, found).map(Part::Text));
            }
            parts.push(Part::Text(rating::gears(first.number, first)));
            parts.push(Part::Text(Text::paragraph(TORQUES)));
        }
        parts.extend(judgement::parts(&self.judgement));
        Report { title: Some("Gearboxes for a list of ratios".into()), parts, warnings: Some(warnings(self)) }
    }
}

/// A wanted gear: its ratio, with its bounds where they are not those of the tolerance; in brackets where it
/// may be missing.
#[must_use]
pub fn wanted(gear: &WantedGear, tolerance: f64) -> String {
    let bounds = || format!("{} to {}", trimmed(gear.least_ratio, 4), trimmed(gear.greatest_ratio, 4));
    let text = match gear.wanted_ratio {
        Some(ratio) if gear.least_ratio == ratio - tolerance * ratio.abs() => ratio.to_string(),
        Some(ratio) => format!("{ratio} ({})", bounds()),
        None => bounds(),
    };
    if gear.may_be_missing { format!("({text})") } else { text }
}

/// What left out how many solutions.
fn left_out(heading: &str, all: &[LeftOut]) -> Text {
    let points = all.iter().map(|left_out| format!("{} {}", left_out.solutions, why(left_out.by))).collect();
    Text { heading: Some(heading.into()), points, ..Text::default() }
}

/// The same in words: `2 not drawable: a link would cross another, 1 …`.
#[must_use]
pub fn counts_in_words(all: &[LeftOut]) -> String {
    let words: Vec<String> =
        all.iter().map(|left_out| format!("{} {}", left_out.solutions, why(left_out.by))).collect();
    words.join(", ")
}

/// The same in a sentence that goes on; nothing where nothing was left out.
#[must_use]
pub fn left_out_in_words(all: &[LeftOut]) -> String {
    if all.is_empty() { String::new() } else { format!("; left out {}", counts_in_words(all)) }
}

const fn why(reason: Reason) -> &'static str {
    match reason {
        Reason::Direct => "without a direct gear",
        Reason::Shifts => "without the single shifts",
        Reason::Drawable => "not drawable: a link would cross another",
        Reason::Order => "with free gears side by side that do not fall at the best k",
        Reason::Steps => "with a ratio step out of its range",
        Reason::FallingSteps => "with a ratio step larger than the one before it",
        Reason::Slip => "with a faster slip of an open shift element",
        Reason::LinkSpeed => "with a faster link",
        Reason::PlanetSpeed => "with a planet that turns faster on its carrier",
        Reason::Unjudged => "not judged before the search was ended",
        Reason::Efficiency => "with a forward gear below --least-efficiency",
        Reason::ReverseEfficiency => "with a reverse gear below --least-reverse-efficiency",
        Reason::Circulation => "with more power circulating in a forward gear than --most-circulating",
    }
}

const NAMES: &str = "Links: 0 the housing, 1 the input, 2 the output, letters the others; a set is sun-ring-carrier, with a star a double-planet set, in \
    formulas with k′ = k − 1. A shift element of one letter is a brake of this link, of two a clutch between them; in each gearbox the \
    brakes are called B1, B2, … and the clutches C1, C2, …, in this order. Mult.: shifts between neighbouring forward gears that \
    exchange more than one shift element. ";

/// What the efficiencies are.
fn efficiencies(answer: &Synthesis) -> String {
    let forward = if answer.shares.is_some() {
        "η fwd: the mean efficiency of the forward gears by their shares of time."
    } else {
        "η fwd: the least efficiency of a forward gear."
    };
    let reverse = answer.solutions.iter().any(|one| one.reverse_efficiency.is_some());
    format!("{forward}{}", if reverse { " η rev: that of the reverse gears." } else { "" })
}

/// The efficiency of the forward gears by which gearboxes are ordered.
fn forward_efficiency(of: &Solution) -> f64 {
    of.mean_efficiency.unwrap_or(of.forward_efficiency)
}

/// What sets of a solution have in common.
fn shared_planets(of: &SharedPlanets) -> String {
    let sets: Vec<String> = of.sets.iter().map(usize::to_string).collect();
    let sets = format!("sets {}", sets.join(" and "));
    let links = |word: &str, links: &[char]| links.iter().map(|link| format!("{word} {link}")).collect();
    let common: [Vec<String>; 2] = [links("sun", &of.common_suns), links("ring", &of.common_rings)];
    let common = common.concat().join(" and ");
    let carrier = of.carrier;
    match of.apart {
        None => format!(
            "{sets} share planets, with carrier {carrier} and {common} in common, of equal teeth: they are rated as one compound set"
        ),
        Some(Obstacle::Steps) => format!(
            "{sets} have carrier {carrier} and {common} in common, but a common planet would need steps: they are rated with planets of \
             their own"
        ),
        Some(Obstacle::Room) => format!(
            "{sets} have carrier {carrier} and {common} in common, but with these k a common planet leaves no room for the other gears: \
             they are rated with planets of their own"
        ),
    }
}

const TORQUES: &str = "T_e, T_m: the greatest torque of a shift element, of a member of a set. Link, planet: the greatest speed of a link, of a \
    planet relative to its carrier. Circ.: circulating power over what enters.";

/// What fewer sets would do.
#[must_use]
pub fn near_miss(near: &NearMiss) -> String {
    let percent = 100.0 * near.greatest_deviation;
    let sets = if near.sets == 1 { "1 set".to_owned() } else { format!("{} sets", near.sets) };
    // A tolerance that has it, rounded up.
    let tolerance = (10.0 * percent).ceil() / 10.0;
    format!(
        "{sets} with {} shift elements would do within {percent:.2} %: --sets {} --tolerance {}%.",
        near.shift_elements,
        near.sets,
        trimmed(tolerance, 4)
    )
}

/// How many were found, how many shown.
#[must_use]
pub fn count(answer: &Synthesis) -> String {
    let gearboxes = if answer.found == 1 { "gearbox" } else { "gearboxes" };
    let ended = if answer.complete { "" } else { " before the search was ended" };
    let families = answer.families.len();
    let of =
        if families < answer.found { format!(" of {}", families::count(families)) } else { String::new() };
    let found = format!("{} {gearboxes}{of} found{ended}", answer.found);
    let is_best = |solution: &&Solution| answer.families[solution.family - 1].best == solution.number;
    let best = answer.solutions.iter().filter(is_best).count();
    match (answer.shown, answer.listed) {
        (shown, _) if shown == answer.found => format!("{found}."),
        (_, Listed::BestOfFamilies) if best == families => {
            format!("{found}, the best of each shown; --all-gearboxes shows the others.")
        }
        (_, Listed::BestOfFamilies) if families < answer.found => format!(
            "{found}, the best of {} shown; --limit shows more, --all-gearboxes the others of a family.",
            families::count(best)
        ),
        (shown, _) => format!("{found}, {shown} shown; --limit shows more."),
    }
}

/// Which of the solutions are schemes of the document.
fn schemes(answer: &Synthesis) -> Option<Text> {
    let named =
        |found: &Solution| found.scheme.map(|scheme| format!("gearbox {} is scheme {scheme}", found.number));
    let mut points: Vec<String> = answer.solutions.iter().filter_map(named).collect();
    if points.is_empty() {
        return None;
    }
    points.push(
        "select searches these schemes for two and three speeds and judges them by the document's criteria"
            .to_owned(),
    );
    Some(Text::list("Schemes of the catalogue", points))
}

fn warnings(answer: &Synthesis) -> Vec<(&'static str, String)> {
    let mut told = Vec::new();
    let sum = |of: fn(&Searched) -> u64| answer.searched.iter().map(of).sum::<u64>();
    let (reducible, undecided) = (sum(|class| class.reducible), sum(|class| class.undecided));
    if reducible > 0 {
        told.push(("reducible", format!("{reducible} further sets of shift elements have all ratios, but the k of a set moves none of them: a simpler gearbox does the same")));
    }
    if answer.found > 0 && answer.of_use == 0 && answer.limits_of_use.is_some() {
        let first = answer.solutions.iter().filter_map(|one| one.beyond_limit).map(why).next();
        told.push((
            "of no use",
            format!(
                "no gearbox found is within the limits of use: gearbox 1 is {}",
                first.unwrap_or_default()
            ),
        ));
    }
    if undecided > 0 {
        told.push((
            "undecided",
            format!(
                "for {undecided} sets of shift elements neither a solution was found nor its absence proved"
            ),
        ));
    }
    let misses = answer.judgement.warnings(&[]);
    told.extend(misses.map(|Warning { name, message }| (name, format!("gearbox 1: {message}"))));
    told
}

/// `580000`; from 10⁷ on `8.6e8`, which leaves room for the other columns.
fn space(of: f64) -> String {
    if of < 1e7 { significant(of, 2) } else { format!("{of:.1e}") }
}

fn searched(classes: &[Searched]) -> Records {
    let double = classes.iter().any(|class| class.double_planets > 0);
    // Searches differ in it where gears may be missing.
    let differ = classes.iter().any(|class| class.gears != classes[0].gears);
    let mut shown = vec!["class", "sets"];
    shown.extend(double.then_some("double_planets"));
    shown.extend(["links", "shift_elements", "engaged"]);
    shown.extend(differ.then_some("gears"));
    shown.extend(["structures", "space_rounded", "solutions"]);
    Table::new("searched", classes)
        .words("class", "class", |of| of.class.name())
        .number("sets", "sets", |of| of.sets)
        .number("double_planets", "double", |of| of.double_planets)
        .number("links", "links", |of| of.links)
        .number("shift_elements", "elements", |of| of.shift_elements)
        .number("engaged", "engaged", |of| of.engaged)
        .number("gears", "gears", |of| of.gears)
        .number("structures", "structures", |of| of.structures)
        .number("space", "space", |of| of.space)
        .number("space_rounded", "space", |of| space(of.space))
        .for_people()
        .number("structures_searched", "searched", |of| of.structures_searched)
        .number("structures_in_reach", "in reach", |of| of.structures_in_reach)
        .number("solutions", "solutions", |of| of.solutions)
        .number("reducible", "reducible", |of| of.reducible)
        .number("undecided", "undecided", |of| of.undecided)
        .view_of("Searched", &shown)
        .note("space: structures times sets of shift elements, each a pair of links")
        .records()
}

fn solutions(answer: &Synthesis) -> Records {
    let ks = |of: &Solution| of.sets.iter().map(|set| format!("{:.3}", set.k)).collect::<Vec<_>>().join(" ");
    // Of each set, as its k.
    let teeth = |of: &Solution, number: fn(&TeethOfSet) -> u32| {
        let best = of.teeth.as_ref()?.choices.first()?;
        Some(Figure::Numbers(best.sets.iter().map(|set| f64::from(number(set))).collect()))
    };
    let joins = |of: &Solution| of.shift_elements.iter().map(|one| one.joins.clone()).collect::<Vec<_>>();
    let engaged = |of: &Solution| of.gears.iter().map(|gear| gear.engaged.join("+")).collect::<Vec<_>>();
    // A column of families that says nothing is left out.
    let family = match answer.listed {
        _ if answer.families.len() == answer.found => "",
        Listed::BestOfFamilies => "others",
        Listed::AllGearboxes => "family",
    };
    // Without reverse gears there is no such column.
    let reverse =
        if answer.solutions.iter().any(|of| of.reverse_efficiency.is_some()) { "reverse" } else { "" };
    let mut shown =
        vec!["number", "structure", "shift_elements", "k_rounded", "deviation", "multiple", "efficiency"];
    shown.extend([reverse, family]);
    let note = match family {
        "others" => "Others: further gearboxes of the family, with equal formulas.",
        "family" => "Family: gearboxes with equal formulas have one.",
        _ => "",
    };
    Table::new("solutions", &answer.solutions)
        .number("number", "no.", |of| of.number)
        .text("structure", "structure", |of| &of.structure)
        .words("shift_elements", "shift elements", |of| joins(of))
        .words("k", "k", |of| Figure::Numbers(of.sets.iter().map(|set| set.k).collect()))
        .words("k_rounded", "k", |of| ks(of))
        .for_people()
        .number("greatest_deviation", "greatest deviation", |of| of.greatest_deviation)
        .number("deviation", "off by", |of| format!("{:.2} %", 100.0 * of.greatest_deviation))
        .for_people()
        .number("multiple_shifts", "multiple shifts", |of| of.multiple_shifts)
        .number("multiple", "mult.", |of| of.multiple_shifts)
        .for_people()
        .number("forward_efficiency", "forward efficiency", |of| of.forward_efficiency)
        .number("mean_efficiency", "mean efficiency", |of| of.mean_efficiency)
        .number("reverse_efficiency", "reverse efficiency", |of| of.reverse_efficiency)
        .printed("efficiency", "η fwd", 4, |of| forward_efficiency(of))
        .for_people()
        .printed("reverse", "η rev", 4, |of| of.reverse_efficiency)
        .for_people()
        .number("missing_gears", "missing gears", |of| of.missing_gears.len())
        .number("greatest_slip", "greatest slip", |of| of.greatest_slip)
        .number("greatest_link_speed", "greatest link speed", |of| of.greatest_link_speed)
        .number("greatest_planet_speed", "greatest planet speed", |of| of.greatest_planet_speed)
        .number("family", "family", |of| of.family)
        .number("gearboxes_of_family", "gearboxes of family", |of| of.gearboxes_of_family)
        .number("others", "others", |of| of.gearboxes_of_family - 1)
        .for_people()
        .words("ratios", "ratios", |of| Figure::Numbers(of.gears.iter().map(|gear| gear.ratio).collect()))
        .words("engaged", "engaged", |of| engaged(of).join(" "))
        .words("efficiencies", "efficiencies", |of| {
            of.gears.iter().map(|gear| gear.efficiency).collect::<Option<_>>().map(Figure::Numbers)
        })
        .number("mean_drag_of_input", "drag", |of| of.rating.mean_drag_of_input)
        .number("greatest_torque_of_input", "torque", |of| of.rating.greatest_torque_of_input)
        .number("greatest_circulating_of_entering", "circulating", |of| {
            of.rating.greatest_circulating_of_entering
        })
        .number("progression", "progression", |of| of.rating.progression)
        .words("drawable", "drawable", |of| of.rating.drawable)
        .words("non_dominated", "on front", |of| of.rating.non_dominated)
        .words("sun_teeth", "suns", |of| teeth(of, |set| set.sun))
        .words("planet_teeth", "planets", |of| teeth(of, |set| set.planet))
        .words("ring_teeth", "rings", |of| teeth(of, |set| set.ring))
        .words("planet_counts", "numbers of planets", |of| teeth(of, |set| set.planets))
        .view_of("Gearboxes", &shown)
        .note(note)
        .the_answer()
        .records()
}

/// Engaged elements and formulas of a solution's gears.
fn gears(found: &Solution) -> Text {
    let mut header: Vec<String> = vec!["ratio".into()];
    header.extend(found.shift_elements.iter().map(|element| element.name.clone()));
    header.extend(["off by, %", "efficiency", "formula"].map(String::from));
    let mut table = vec![header];
    for gear in &found.gears {
        let mut row = vec![format!("{:.4}", gear.ratio)];
        row.extend(
            found
                .shift_elements
                .iter()
                .map(|element| if gear.engaged.contains(&element.name) { "x".into() } else { String::new() }),
        );
        row.push(gear.deviation.map_or_else(String::new, |deviation| format!("{:+.2}", 100.0 * deviation)));
        row.push(gear.efficiency.map_or_else(|| "none".into(), |efficiency| format!("{efficiency:.4}")));
        row.push(gear.formula.clone());
        table.push(row);
    }
    let k = found.sets.iter().enumerate().map(|(place, set)| {
        let edge = match set.at_edge {
            None => "",
            Some(Edge::Lower) => ", the least searched",
            Some(Edge::Upper) => ", the greatest searched",
        };
        format!("k{} {:.4} ({:.4} to {:.4}{edge})", place + 1, set.k, set.k_range[0], set.k_range[1])
    });
    let elements = found.shift_elements.iter().map(|element| format!("{} {}", element.name, element.joins));
    let instead = found.shift_elements.iter().filter(|element| !element.instead.is_empty());
    let mut points: Vec<String> = vec![format!(
        "k with the least deviation, and the range that keeps the tolerances: {}",
        k.collect::<Vec<_>>().join(", ")
    )];
    points.push(format!("brakes and clutches: {}", elements.collect::<Vec<_>>().join(", ")));
    points.push(format!(
        "over the input's speed at most: slip of an open element {:.3}, a link {:.3}, a planet on its carrier {:.3}",
        found.greatest_slip, found.greatest_link_speed, found.greatest_planet_speed
    ));
    points.extend(found.shared_planets.iter().map(shared_planets));
    let equal: Vec<String> = (1..)
        .zip(&found.sets)
        .filter(|(_, set)| set.has_equal_k)
        .map(|(place, _)| format!("k{place}"))
        .collect();
    if !equal.is_empty() {
        points.push(format!("equal: {}", equal.join(" = ")));
    }
    if found.sets.iter().any(|set| set.is_double_planet) {
        let told = "planets of a double-planet set enter with the speed that they exceed with any teeth";
        points.push(match found.teeth {
            Some(_) => told.to_owned(),
            None => format!("{told}; --teeth tells exact speeds"),
        });
    }
    if !found.missing_gears.is_empty() {
        let gears: Vec<String> = found.missing_gears.iter().map(usize::to_string).collect();
        points.push(format!("without gear {} of the list", gears.join(" and ")));
    }
    points.extend(
        instead.map(|element| format!("instead of {} also {}", element.joins, element.instead.join(" or "))),
    );
    Text {
        heading: Some(format!("Gearbox {}: {}", found.number, found.structure)),
        points,
        table,
        ..Text::default()
    }
}

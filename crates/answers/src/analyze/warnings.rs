//! What the reader should know of a gearbox and of its gears.

use super::Worked;
use super::records::{GearFacts, SelfLocking, State, beside};
use crate::Warning;
use crate::gearbox::Subject;
use epicyclic_formats::quantity::format::trimmed;
use epicyclic_train::one_way::Duty;
use epicyclic_train::speeds::SetMotion;
use epicyclic_train::{self as train, Analysis, Gearbox, PlanetSet};

/// Speed of a planet relative to its carrier, over the input's, that is usually not exceeded.
const USUAL_PLANET_SPEED: f64 = 2.0;

/// A planet of a set that turns faster on its carrier than is usual: more than twice the input's speed.
#[must_use]
pub fn fast_planet(gear: &str, set: &str, relative_speed_of_input: f64) -> Option<Warning> {
    let speed = relative_speed_of_input.abs();
    (speed > USUAL_PLANET_SPEED).then(|| {
        let message = format!(
            "in gear {gear} a planet of set {set} turns at {} times the input's speed relative to its carrier; \
             {USUAL_PLANET_SPEED} is the usual limit",
            trimmed(speed, 4)
        );
        Warning { name: "planet-speed", message }
    })
}

/// The fastest planet of each set, where it is faster than usual.
pub(super) fn fast_planets(gearbox: &Gearbox, gear: &Analysis<'_>) -> Vec<Warning> {
    let of_set = |(set, motion): (&PlanetSet, &SetMotion)| {
        let planets = motion.planets.iter().flatten().map(|planet| planet.relative.abs());
        fast_planet(gear.gear().name(), set.id(), planets.reduce(f64::max)?)
    };
    gearbox.sets().iter().zip(gear.sets()).filter_map(of_set).collect()
}

/// One-way clutches that do not do what the gear's engaged elements say.
pub(super) fn contradictions(gearbox: &Gearbox, gear: &Analysis<'_>) -> Vec<Warning> {
    let name = gear.gear().name();
    let all = gear.one_way_clutches().into_iter().filter_map(|one| {
        let clutch = gearbox.shift_elements()[one.shift_element].id();
        let message = match one.drive {
            Duty::WouldOverrun => format!(
                "gear {name} relies on the one-way clutch {clutch}, whose torque would turn it free: leave it out of \
                 the gear, or exchange its links"
            ),
            Duty::WouldHold => format!(
                "in gear {name} the one-way clutch {clutch} would hold, since its first link would turn slower than \
                 its second: name it in the gear, or exchange its links"
            ),
            _ => return None,
        };
        Some(Warning { name: "one-way-clutch", message })
    });
    all.collect()
}

/// One-way clutches that let go at the load, and what would have to be engaged besides.
pub(super) fn released(gearbox: &Gearbox, worked: &Worked<'_>) -> Vec<Warning> {
    let gear = worked.analysis.gear().name();
    let one = |place: &usize| {
        let clutch = gearbox.shift_elements()[*place].id();
        let remedy = match &beside(gearbox, *place)[..] {
            [] => "no other shift element joins its links".to_owned(),
            elements => format!("engage {} besides", elements.join(" or ")),
        };
        let message = format!(
            "gear {gear} does not take this load: the torque on the one-way clutch {clutch} would be reversed, so it \
             overruns; {remedy}"
        );
        Warning { name: "one-way-clutch", message }
    };
    worked.released.iter().map(one).collect()
}

/// Remarks on the gearbox itself.
pub(super) fn of_gearbox(subject: &Subject<'_>) -> Vec<Warning> {
    let gearbox = &subject.gearbox;
    let name = |warning: &train::Warning| match warning {
        train::Warning::Unreachable { .. } => "unreachable",
        train::Warning::NoGears => "no-gears",
        train::Warning::SameTerminals { .. } => "same-terminals",
        train::Warning::SharedPlanets { .. } => "shared-planets",
        _ => "other",
    };
    let of_gearbox = gearbox.warnings().iter();
    let of_gearbox = of_gearbox.map(|warning| Warning { name: name(warning), message: warning.to_string() });
    // How gears must be arranged is no fault.
    let teeth = gearbox.tooth_checks(&subject.rack).into_iter().filter(|warning| !warning.is_note());
    let teeth = teeth.map(|warning| Warning { name: "teeth", message: warning.to_string() });
    of_gearbox.chain(teeth).collect()
}

/// The state of a gear as a sentence, without the gear's name.
#[must_use]
pub fn state_in_words(facts: &GearFacts) -> String {
    let links = facts.state_links.join(", ");
    match facts.state {
        State::Driven => "driven".to_owned(),
        State::InputBlocked => format!("input blocked: the input cannot turn; at rest: {links}"),
        State::OutputAtRest => {
            format!("output at rest: the output cannot turn while the input can; at rest: {links}")
        }
        State::OutputFree => format!("output free: nothing joins the output to the input; free: {links}"),
        State::Underdetermined => {
            let speeds = if facts.missing_speeds == Some(1) { "one more speed" } else { "more speeds" };
            format!("underdetermined: {speeds} must be given, of {links}")
        }
        State::TorquesIndeterminate => {
            let of = |what: &str, names: &[String]| {
                (!names.is_empty()).then(|| format!("{what} {}", names.join(", ")))
            };
            let parts = facts.indeterminate.iter().flat_map(|redundant| {
                [of("shift elements", &redundant.shift_elements), of("sets", &redundant.sets)]
            });
            let parts: Vec<String> = parts.flatten().collect();
            format!(
                "torques indeterminate: how the torque is shared depends on how tightly they hold: {}",
                parts.join("; ")
            )
        }
        State::SelfLocking => {
            let is_both = facts.self_locking == Some(SelfLocking::BothWays);
            let back = if is_both { "; nor does any at the output" } else { "" };
            format!(
                "self-locking: no torque at the input, {links}, moves a load against the mesh losses{back}"
            )
        }
    }
}

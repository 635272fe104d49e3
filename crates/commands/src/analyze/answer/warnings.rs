//! Warnings about a gearbox and its gears.

use super::Worked;
use super::records::{GearFacts, SelfLocking, State, beside};
use crate::answer::Warning;
use crate::shared::gearbox::Gearbox;
use crate::shared::judgement::answer::TEETH;
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_train::one_way::Duty;
use epicyclic_train::planet_bearings::PlanetBearing;
use epicyclic_train::{self as train, Analysis, PlanetSet};
use epicyclic_units::format::quantity;

/// Formats names of gears: `gear 1`, `gears 1, 2`.
fn named(gears: &[&str]) -> String {
    format!("gear{} {}", if gears.len() == 1 { "" } else { "s" }, gears.join(", "))
}

/// Groups gears by a common key, in the order in which each key first occurs.
fn grouped<'a, Key: PartialEq>(all: impl IntoIterator<Item = (Key, &'a str)>) -> Vec<(Key, Vec<&'a str>)> {
    let mut groups: Vec<(Key, Vec<&str>)> = vec![];
    for (key, gear) in all {
        match groups.iter_mut().find(|(known, _)| *known == key) {
            Some((_, gears)) => gears.push(gear),
            None => groups.push((key, vec![gear])),
        }
    }
    groups
}

/// Warnings about one-way clutches that do not behave as the engaged elements of the gears require.
pub(super) fn contradictions(gearbox: &train::Gearbox, gears: &[&Analysis<'_>]) -> Vec<Warning> {
    let of_gear = |gear: &&'_ Analysis<'_>| -> Vec<(usize, Duty)> {
        let all = gear.one_way_clutches().into_iter();
        all.filter(|one| one.drive.is_contradiction()).map(|one| (one.shift_element, one.drive)).collect()
    };
    let all =
        gears.iter().flat_map(|gear| of_gear(gear).into_iter().map(|found| (found, gear.gear().name())));
    let message = |((clutch, duty), gears): ((usize, Duty), Vec<&str>)| {
        let (verb, the_gear) =
            if gears.len() == 1 { ("relies", "the gear") } else { ("rely", "these gears") };
        let (clutch, gears) = (gearbox.shift_elements()[clutch].id(), named(&gears));
        let message = if duty == Duty::WouldOverrun {
            format!(
                "{gears} {verb} on the one-way clutch {clutch}, whose torque would turn it free: leave it out of \
                 {the_gear}, or exchange its links"
            )
        } else {
            format!(
                "in {gears} the one-way clutch {clutch} would hold, since its first link would turn slower than its \
                 second: name it in {the_gear}, or exchange its links"
            )
        };
        Warning { name: "one-way-clutch", message }
    };
    grouped(all).into_iter().map(message).collect()
}

/// Warnings about one-way clutches that overrun at the load, with the elements that would have to be engaged
/// too.
pub(super) fn released(gearbox: &train::Gearbox, gears: &[&Worked<'_>]) -> Vec<Warning> {
    let all = gears
        .iter()
        .flat_map(|worked| worked.released.iter().map(|place| (*place, worked.analysis.gear().name())));
    let message = |(place, gears): (usize, Vec<&str>)| {
        let clutch = gearbox.shift_elements()[place].id();
        let remedy = match &beside(gearbox, place)[..] {
            [] => "no other shift element joins its links".to_owned(),
            elements => format!("engage {} besides", elements.join(" or ")),
        };
        let verb = if gears.len() == 1 { "does" } else { "do" };
        let message = format!(
            "{} {verb} not take this load: the torque on the one-way clutch {clutch} would be reversed, so it overruns; \
             {remedy}",
            named(&gears)
        );
        Warning { name: "one-way-clutch", message }
    };
    grouped(all).into_iter().map(message).collect()
}

/// Warning about gears that cannot be driven from their outputs.
pub(super) fn self_locking(gears: &[&Analysis<'_>]) -> Option<Warning> {
    let held: Vec<&str> = gears
        .iter()
        .filter(|gear| gear.is_self_locking() == Some(true))
        .map(|gear| gear.gear().name())
        .collect();
    let message = match held[..] {
        [] => return None,
        // In the answer for a single gear its name would be redundant.
        [_] if gears.len() == 1 => "the gear is self-locking when driven from its output".to_owned(),
        [one] => format!("gear {one} is self-locking when driven from its output"),
        _ => format!("{} are self-locking when driven from their output", named(&held)),
    };
    Some(Warning { name: "self-locking", message })
}

/// Warnings about gears whose output is not driven, one for each state. Gears for which the file gives speeds
/// of several links are left out.
pub(super) fn not_driven(subject: &Gearbox, gears: &[&Analysis<'_>]) -> Vec<Warning> {
    // A gear with several given speeds is underdetermined on purpose.
    let is_told = |gear: &&&Analysis<'_>| {
        !matches!(gear.state(), train::State::Driven) && !subject.has_inputs(gear.gear().name())
    };
    let states = grouped(gears.iter().filter(is_told).map(|gear| (gear.state().name(), gear.gear().name())));
    let message = |(state, names): (&str, Vec<&str>)| match names[..] {
        [one] => format!("gear {one} does not drive the output: {state}"),
        _ => format!("{} do not drive the output: {state}", named(&names)),
    };
    states.into_iter().map(message).map(|message| Warning { name: "state", message }).collect()
}

/// Remarks on the gearbox itself.
pub(crate) fn of_gearbox(subject: &Gearbox) -> Vec<Warning> {
    let gearbox = &subject.train;
    let name = |warning: &train::Warning| match warning {
        train::Warning::Unreachable { .. } => "unreachable",
        train::Warning::NoGears => "no-gears",
        train::Warning::SameTerminals { .. } => "same-terminals",
        train::Warning::SharedPlanets { .. } => "shared-planets",
        _ => "other",
    };
    let of_gearbox = gearbox.warnings().iter();
    let of_gearbox = of_gearbox.map(|warning| Warning { name: name(warning), message: warning.to_string() });
    let teeth: Vec<String> = subject.tooth_checks().warnings().collect();
    let teeth = teeth.into_iter().map(|message| Warning { name: TEETH, message });
    let ideal = subject.without_friction.iter().map(|(set, why)| {
        let message = format!(
            "the friction of the gearbox is not applied to set {set}, which runs without losses: {why}; efficiencies can be stated \
             instead"
        );
        Warning { name: "friction", message }
    });
    let radii = subject.other_radii.iter().map(|(set, stated, own)| {
        let message = format!(
            "the carrier_radius {} of set {set} is not that of its teeth, {}; state centre_distance in its place, from which profile \
             shifts follow, or leave it out",
            quantity(*stated, 5),
            quantity(*own, 5)
        );
        Warning { name: "carrier-radius", message }
    });
    of_gearbox.chain(teeth).chain(ideal).chain(radii).collect()
}

/// Warning about helical sets whose planet bearings have forces, or at a load lives: both leave out the moment of
/// the axial forces. `strength` rates those with it whose file states the distance of their rows.
pub(crate) fn tilted(subject: &Gearbox, has_lives: bool) -> Option<Warning> {
    // Without radius and number of planets there are no forces that could leave out the moment.
    let is_borne = |place: usize| {
        let own = subject.planet_bearings.iter().filter(|bearing| bearing.set == place);
        own.into_iter().any(|bearing| bearing.radius.is_some() && bearing.planets.is_some())
    };
    let is_helical = |set: &PlanetSet| set.tooth_shape().is_helical();
    let sets = subject.train.sets().iter().enumerate();
    let sets = sets.filter(|(place, set)| is_helical(set) && is_borne(*place)).map(|(_, set)| set);
    let mut sets: Vec<&PlanetSet> = sets.collect();
    if sets.is_empty() {
        return None;
    }
    let file = subject.document.read::<GearboxFile>().ok();
    let has_spans = |set: &PlanetSet| {
        let data = file.as_ref().and_then(|file| file.set_data(set));
        data.is_some_and(|data| data.has_bearing_spans())
    };
    sets.retain(|set| has_lives || !has_spans(set));
    let names: Vec<&str> = sets.iter().map(|set| set.id()).collect();
    let mut warning = tilting(&names)?;
    if sets.iter().all(|set| has_spans(set)) {
        warning.message.push_str("; strength rates the bearings with it");
    }
    Some(warning)
}

/// Name of the warnings that steps tilt planets.
pub(crate) const STEP_COUPLE: &str = "step-couple";

/// Warning that planets with rated bearings are stepped, where there are lives: these leave out the moment of the
/// steps' forces.
pub(crate) fn stepped(subject: &Gearbox, has_lives: bool) -> Option<Warning> {
    let sets = subject.train.sets();
    let is_left_out = |bearing: &&PlanetBearing| {
        has_lives && bearing.load_rating.is_some() && sets[bearing.set].is_stepped(bearing.planet)
    };
    let mut names: Vec<&str> =
        subject.planet_bearings.iter().filter(is_left_out).map(|bearing| sets[bearing.set].id()).collect();
    names.dedup();
    let which = match &names[..] {
        [] => return None,
        [only] => format!("set {only} has"),
        several => format!("sets {} have", several.join(", ")),
    };
    Some(Warning {
        name: STEP_COUPLE,
        message: format!(
            "{which} stepped planets: forces of the steps, side by side, tilt each planet; lives of planet bearings leave this moment out, \
             which strength takes into account where `bearing_span` is stated"
        ),
    })
}

/// Warning that these sets are helical, and which loads the rating of their planet bearings leaves out.
pub(crate) fn tilting(sets: &[&str]) -> Option<Warning> {
    let which = match sets {
        [] => return None,
        [only] => format!("set {only} has helical teeth"),
        _ => format!("sets {} have helical teeth", sets.join(", ")),
    };
    let message = format!(
        "{which}: the axial forces of the meshes tilt each planet; forces and lives of planet bearings leave this moment out"
    );
    Some(Warning { name: "tilting-moment", message })
}

/// Warning that the drags in the file are not part of this answer.
pub(super) fn drags(subject: &Gearbox) -> Option<Warning> {
    let message = "efficiencies are of the meshes alone, without the drags of the file; `losses` takes both";
    (!subject.drags.is_empty()).then(|| Warning { name: "drags", message: message.to_owned() })
}

/// Describes the state of a gear as a sentence without the gear's name.
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
        State::SpeedsGiven => {
            format!("settled by the speeds that the file gives: {}", facts.links_with_given_speeds.join(", "))
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

//! A set of tooth numbers as a gearbox, to be written as a file that `analyze`, `draw` and `report` read.

use super::double_planet::DoublePlanetNumbers;
use super::shifted::ShiftedNumbers;
use super::{ToothNumbers, Wanted};
use crate::Error;
use epicyclic_gears::ToothCount;
use epicyclic_gears::involute::profile::Cutting;
use epicyclic_gears::simple_set::Member;
use epicyclic_train::set::{SetKind, SetSpec, Shifts};
use epicyclic_train::spacing::Spacing;
use epicyclic_train::{GROUND, Gearbox};

/// The one gear of the gearbox.
const GEAR: &str = "1";

/// A simple set as a gearbox without losses: its links are its members, and the one at rest is the housing.
///
/// # Errors
/// None of a set that [`answer`](super::answer) tells.
pub fn simple(wanted: &Wanted, of: &ToothNumbers) -> Result<Gearbox, Error> {
    let set = SetSpec::teeth(GEAR, SetKind::Simple, members(wanted), of.sun, of.ring)?;
    built(wanted, set.planet_teeth(ToothCount::new(of.planet)?, None).planet_count(of.planets))
}

/// A set with profile shift as a gearbox in the same way, with its shifts and tip alterations.
///
/// # Errors
/// None of a set that [`shifted::answer`](super::shifted::answer) tells.
pub fn shifted(wanted: &Wanted, of: &ShiftedNumbers) -> Result<Gearbox, Error> {
    let set = SetSpec::teeth(GEAR, SetKind::Simple, members(wanted), of.sun, of.ring)?;
    let set = set.planet_teeth(ToothCount::new(of.planet)?, None).planet_count(of.planets);
    let hob = Cutting::default();
    let shifts = Shifts { profile: of.profile_shifts, tips: Some(of.tip_alterations) };
    built(wanted, set.shifted(shifts).cut([hob, hob, of.ring_tool.cutting()]))
}

/// A double-planet set as a gearbox in the same way.
///
/// # Errors
/// None of a set that [`double_planet::answer`](super::double_planet::answer) tells.
pub fn double_planet(wanted: &Wanted, of: &DoublePlanetNumbers) -> Result<Gearbox, Error> {
    let set = SetSpec::teeth(GEAR, SetKind::DoublePlanet, members(wanted), of.sun, of.ring)?;
    let [inner, outer] = [of.inner_planet, of.outer_planet].map(ToothCount::new);
    built(wanted, set.planet_teeth(inner?, Some(outer?)).planet_count(of.pairs))
}

/// Links of sun, ring and carrier.
fn members(wanted: &Wanted) -> [&'static str; 3] {
    Member::ALL.map(|member| link(wanted, member))
}

fn link(wanted: &Wanted, member: Member) -> &'static str {
    match member {
        of if of == wanted.mode.fixed() => GROUND,
        Member::Sun => "sun",
        Member::Ring => "ring",
        Member::Carrier => "carrier",
    }
}

fn built(wanted: &Wanted, set: SetSpec) -> Result<Gearbox, Error> {
    let mode = wanted.mode;
    let [input, output] = [mode.input(), mode.output()].map(|member| link(wanted, member));
    let name = format!("Ratio {} ({mode})", wanted.ratio);
    // Where planets at equal angles assemble, they stand there under either bound.
    let set = set.spaced(Spacing::Placed(wanted.bounds.placement));
    let gearbox = Gearbox::builder(&name).links([input, output]).set(set).input(input).output(output);
    Ok(gearbox.gear(GEAR, [] as [&str; 0]).build()?)
}

//! Rules for loads, speeds and losses.

use super::judge::Judge;
use super::teeth::{in_mesh, judged_by_width};
use crate::analyze::answer::pins::WITHOUT_LOAD;
use crate::analyze::answer::records::planet_name;
use crate::analyze::answer::{Input, Worked};
use crate::shared::gearbox::Gearbox;
use crate::shared::toothed::lacking;
use crate::strength::answer::duty::{WorkedStep, steps};
use crate::strength::answer::load::SetLoad;
use crate::strength::answer::records::{Against, BearingOverDuty, MeshName, NotRated, Reason};
use crate::strength::answer::{Lacking, Strength, over_duty};
use epicyclic_formats::gearbox::{GearboxFile, PlanetData, SetData};
use epicyclic_gears::involute::practice::{
    of_face_load, of_speed, orbit_acceleration, orbit_rule, pin_speed, pin_speed_rule,
};
use epicyclic_gears::life::Rolling;
use epicyclic_judge::Rule;
use epicyclic_strength::rating::Place;
use epicyclic_train::PlanetSet;
use epicyclic_units::Physical;
use std::borrow::Cow;

/// Rules for the teeth of each set that need their strength.
const OF_TEETH: [Rule; 4] = [Rule::FlankSafety, Rule::RootSafety, Rule::DynamicFactor, Rule::FaceLoad];

/// Symbol of the dynamic factor.
const DYNAMIC: &str = "K_v";

/// Symbol of the face load factor of flanks.
const FACE_LOAD: &str = "K_Hβ";

/// A set to judge, with its index in the gearbox and its data of the file.
type Of<'a> = (usize, &'a PlanetSet, SetData<'a>);

/// Judges what the file says of loads: over its duty, or at an operating point.
pub(super) fn judge(
    judge: &mut Judge,
    subject: &Gearbox,
    file: &GearboxFile,
    set: Option<&str>,
    strength: Option<&Strength>,
) {
    of_gears(judge, subject);
    let sets =
        subject.train.sets().iter().enumerate().filter(|(_, one)| set.is_none_or(|set| set == one.id()));
    let sets: Vec<Of<'_>> = sets.filter_map(|(place, set)| Some((place, set, file.set_data(set)?))).collect();
    let rated = match strength {
        Some(strength) => Ok(Ok(Cow::Borrowed(strength))),
        None => over_duty(subject, file).map(|rated| rated.map(Cow::Owned)),
    };
    let worked = match steps(subject, &file.duty) {
        _ if file.duty.is_empty() => Err("duty".to_owned()),
        worked => worked.map_err(|error| error.to_string()),
    };
    match rated {
        Ok(Ok(strength)) => {
            of_strength(judge, subject, (&sets, worked.as_deref().unwrap_or_default()), &strength);
        }
        Ok(Err(Lacking { keys, not_rated })) => of_lacks(judge, &sets, &Missing::of(keys), &not_rated),
        Err(error) => of_lacks(judge, &sets, &Missing::of(vec![error.to_string()]), &[]),
    }
    for of in &sets {
        of_speeds(judge, subject, of, &worked);
    }
}

/// Circulating power and efficiency of each gear.
fn of_gears(judge: &mut Judge, subject: &Gearbox) {
    for gear in subject.train.gears() {
        let Ok(worked) = Worked::new(&subject.train, gear.name(), Input::default()) else { continue };
        let name = format!("gear {}", gear.name());
        if let Some(case) = worked.analysis.driving() {
            judge.see(Rule::CirculatingPower, &[&name], worked.analysis.circulating(case));
        }
        // Sets that turn as one have no loss: the number of those that roll is that of the stages.
        let stages = worked.analysis.rolling_sets();
        if let Some(efficiency) = worked.analysis.efficiency().filter(|efficiency| *efficiency > 0.0)
            && stages > 0
        {
            let each = libm::pow(efficiency, 1.0 / stages as f64);
            judge.see(Rule::StageEfficiency, &[&name], each);
        }
    }
}

/// Safeties, lives and load factors of sets, and what of them has no result.
fn of_strength(
    judge: &mut Judge,
    subject: &Gearbox,
    (sets, duty): (&[Of<'_>], &[WorkedStep<'_>]),
    strength: &Strength,
) {
    for safety in strength.safeties().filter(|one| sets.iter().any(|(_, set, _)| set.id() == one.set)) {
        let against = if safety.against == Against::Overload { ", overload" } else { "" };
        let name = format!("{} in the mesh {}{against}", safety.toothed_gear, safety.mesh.gears.join("–"));
        judge.see_least(rule_of(safety.place), &[&safety.set, &name], safety.required, safety.safety);
    }
    for (_, set, data) in sets {
        of_dynamics(judge, strength, set.id());
        of_face_loads(judge, subject, strength, set, data);
    }
    // Torques that come a few times have no dynamic and face load factors here; lives need a duty.
    let is_at_point = strength.operating_point.is_some();
    let of_factors = lacking(&[("duty", is_at_point || !strength.duty.is_empty())]);
    let of_lives = match is_at_point {
        true => vec!["at an operating point bearings have no life".to_owned()],
        false => lacking(&[("duty", !strength.duty.is_empty())]),
    };
    for (of_set, set, data) in sets {
        for (place, planet) in data.planets.iter().enumerate().filter(|_| !set.is_pair()) {
            let name = planet_name(set, place);
            let row = strength.bearings.iter().find(|one| one.set == set.id() && one.planet == name);
            if let Some(row) = row {
                let fastest = fastest(subject, duty, (*of_set, place));
                of_bearing(judge, (set, place), planet, (row, fastest), strength.life_s);
            }
        }
    }
    let missing = Missing { safeties: vec![], factors: of_factors, lives: of_lives };
    of_lacks(judge, sets, &missing, &strength.not_rated);
}

/// Rule for the safety of a flank or root.
const fn rule_of(place: Place) -> Rule {
    match place {
        Place::Flank => Rule::FlankSafety,
        Place::Root => Rule::RootSafety,
    }
}

/// Keys of the gearbox that are missing, or a reason in words: for safeties, for load factors, for lives.
struct Missing {
    safeties: Vec<String>,
    factors: Vec<String>,
    lives: Vec<String>,
}

impl Missing {
    fn of(all: Vec<String>) -> Self {
        Self { safeties: all.clone(), factors: all.clone(), lives: all }
    }
}

/// Notes the rules of sets that need their strength and have no check, with what is missing of the gearbox
/// and of the sets that are not rated.
fn of_lacks(judge: &mut Judge, sets: &[Of<'_>], missing: &Missing, not_rated: &[NotRated]) {
    for (_, set, data) in sets {
        let rows = || not_rated.iter().filter(|row| row.set == set.id());
        for rule in OF_TEETH {
            let is_judged = judge.has(rule, set.id());
            let of_gearbox = match rule {
                Rule::DynamicFactor | Rule::FaceLoad => &missing.factors,
                _ => &missing.safeties,
            };
            // A set that has no load in some gears is judged in the others.
            let is_idle = |row: &NotRated| matches!(row.reason, Reason::NoTorque | Reason::NoRolling);
            let counts = |row: &&NotRated| {
                row.place.is_none_or(|place| rule_of(place) == rule) && !(is_judged && is_idle(row))
            };
            let mut has_row = false;
            for row in rows().filter(counts) {
                has_row = true;
                judge.lacks(&part(row), &[rule], joined(of_gearbox, row.lacks()));
            }
            if !is_judged && !has_row {
                let none = || vec!["it has no result".to_owned()];
                let why = Some(of_gearbox.clone()).filter(|why| !why.is_empty());
                judge.lacks(set.id(), &[rule], why.unwrap_or_else(none));
            }
        }
        for (place, planet) in data.planets.iter().enumerate().filter(|_| !set.is_pair()) {
            let name = bearing_name(set, place);
            let of = format!("{}, {name}", set.id());
            if judge.has_any(&of, &[set.id(), &name]) {
                continue;
            }
            let keys = [
                ("load_rating", planet.bearing.is_some()),
                ("static_load_rating", planet.static_load_rating.is_some()),
                ("bearing_diameter", planet.bearing_diameter.is_some()),
            ];
            judge.lacks(&of, &of_rolling(planet.rolling.into()), joined(&missing.lives, lacking(&keys)));
        }
    }
}

/// Missing keys, each once.
fn joined(one: &[String], other: Vec<String>) -> Vec<String> {
    let mut all = one.to_vec();
    all.extend(other.into_iter().filter(|of| !one.contains(of)));
    all
}

/// Part of a set that is not rated.
fn part(row: &NotRated) -> String {
    let gear = row.toothed_gear.as_ref().map(|gear| match row.place {
        Some(place) => format!("{place} of the {gear} in the mesh "),
        None => format!("{gear} in the mesh "),
    });
    let mesh = row.mesh.as_ref().map(|mesh| format!("{}{}", gear.unwrap_or_default(), mesh.gears.join("–")));
    [Some(row.set.clone()), mesh].into_iter().flatten().collect::<Vec<_>>().join(", ")
}

/// A factor of a mesh.
struct Factored<'s> {
    set: &'s str,
    mesh: &'s MeshName,
    symbol: &'s str,
    greatest: f64,
    is_given: bool,
}

/// The factors of all meshes, as their first gears have them.
fn factored(strength: &Strength) -> impl Iterator<Item = Factored<'_>> {
    let over_duty = strength.over_duty.iter().filter(|one| one.toothed_gear == one.mesh.gears[0]);
    let over_duty = over_duty.flat_map(|one| {
        one.factors.iter().map(|factor| Factored {
            set: &one.set,
            mesh: &one.mesh,
            symbol: &factor.symbol,
            greatest: factor.greatest,
            is_given: factor.formula.is_none(),
        })
    });
    let at_point = strength.at_point.iter().filter(|one| one.toothed_gear == one.mesh.gears[0]);
    let at_point = at_point.flat_map(|one| {
        one.factors.iter().map(|factor| Factored {
            set: &one.set,
            mesh: &one.mesh,
            symbol: &factor.symbol,
            greatest: factor.value,
            is_given: factor.formula.is_none(),
        })
    });
    over_duty.chain(at_point)
}

/// The greatest dynamic factor of each mesh of a set.
fn of_dynamics(judge: &mut Judge, strength: &Strength, set: &str) {
    let mut greatest: Vec<Factored<'_>> = vec![];
    for one in factored(strength).filter(|one| one.symbol == DYNAMIC && one.set == set) {
        match greatest.iter_mut().find(|known| known.mesh == one.mesh) {
            Some(known) => known.greatest = known.greatest.max(one.greatest),
            None => greatest.push(one),
        }
    }
    for one in greatest {
        judge.see(Rule::DynamicFactor, &[one.set, &one.mesh.gears.join("–")], one.greatest);
    }
}

/// Face load factors that are given, against what the width of the gears asks.
fn of_face_loads(
    judge: &mut Judge,
    subject: &Gearbox,
    strength: &Strength,
    set: &PlanetSet,
    data: &SetData<'_>,
) {
    let has_module = data.modules.iter().any(Option::is_some);
    let Ok(toothed) = in_mesh(subject, data, set, has_module) else { return };
    for (mesh, diameter) in judged_by_width(&toothed) {
        let name = MeshName::of(set, mesh.gears);
        let Some(width) = data.common_width(mesh.gears) else { continue };
        let is_own = |one: &Factored<'_>| one.set == set.id() && *one.mesh == name && one.symbol == FACE_LOAD;
        if let Some(given) = factored(strength).find(|one| is_own(one) && one.is_given) {
            let verdict = of_face_load(&judge.limits, width.si() / diameter, given.greatest);
            judge.take(&[set.id(), &name.gears.join("–")], verdict);
        }
    }
}

/// Rules for a bearing on its pin, with loads and lives.
fn of_rolling(rolling: Rolling) -> Vec<Rule> {
    let Some(speed) = pin_speed_rule(rolling) else {
        return vec![Rule::PlainLoad, Rule::BearingStaticSafety, Rule::OilFilm];
    };
    let rules = [Rule::BearingLife, Rule::BearingStaticSafety, Rule::BearingLeastLoad, speed];
    rules.into_iter().chain((rolling == Rolling::Balls).then_some(Rule::BallLoad)).collect()
}

/// Name of the bearing of a planet; planets of short sets have no name.
fn bearing_name(set: &PlanetSet, place: usize) -> String {
    match set.planets()[place].name.as_str() {
        "" => "planet bearing".to_owned(),
        name => format!("bearing of the {name}"),
    }
}

/// Greatest speed of a planet relative to its carrier in the steps without a share of the time, rad/s.
fn fastest(subject: &Gearbox, duty: &[WorkedStep<'_>], (set, planet): (usize, usize)) -> f64 {
    let speed = |step: &WorkedStep<'_>| {
        let worked = step.turning(subject)?;
        let turning = worked.analysis.sets()[set].planets[planet]?;
        Some((step.0.speed.0.si() * turning.relative).abs())
    };
    duty.iter().filter_map(speed).fold(0.0, f64::max)
}

/// Life, static safety, speed and load of a planet bearing; with a force that does not follow none of them.
fn of_bearing(
    judge: &mut Judge,
    (set, place): (&PlanetSet, usize),
    planet: &PlanetData,
    (bearing, without_load): (&BearingOverDuty, f64),
    required_life_s: f64,
) {
    let name = bearing_name(set, place);
    let (of, name_of) = ([set.id(), name.as_str()], format!("{}, {name}", set.id()));
    let rolling = Rolling::from(planet.rolling);
    if bearing.greatest_force_n.is_none() {
        return judge.lacks(&name_of, &of_rolling(rolling), bearing.missing.clone());
    }
    let Some(speed_rule) = pin_speed_rule(rolling) else {
        return of_plain(judge, (&of, &name_of), planet, bearing);
    };
    match bearing.life_s() {
        Some(life) => judge.see_least(Rule::BearingLife, &of, required_life_s / HOUR_S, life / HOUR_S),
        None => judge.lacks(&name_of, &[Rule::BearingLife], idle()),
    }
    of_static(judge, (&of, &name_of), planet, bearing);
    let force = bearing.steps.iter().map(|step| step.force_n).fold(0.0, f64::max);
    if rolling == Rolling::Balls && force > 0.0 {
        judge.see(Rule::BallLoad, &of, force / 1e3);
    }
    // A bearing at rest needs no load to keep its elements rolling.
    let turning = bearing.steps.iter().filter(|step| step.speed_rad_s != 0.0);
    let loads = turning.map(|step| step.equivalent_load_n).filter(|load| *load > 0.0);
    if let Some(least) = loads.reduce(f64::min) {
        judge.see(Rule::BearingLeastLoad, &of, least / bearing.load_rating_n);
    }
    let loaded = bearing.steps.iter().map(|step| step.speed_rad_s).fold(0.0, f64::max);
    let (fastest, state) = greatest([loaded, without_load]);
    match bearing.mean_diameter_m {
        Some(diameter) => {
            judge.see(speed_rule, &[&of[..], state].concat(), pin_speed(fastest, diameter));
        }
        None => judge.lacks(&name_of, &[speed_rule], vec!["bearing_diameter".to_owned()]),
    }
}

/// The greater of a speed under load and one without, with words for the latter.
fn greatest([loaded, without_load]: [f64; 2]) -> (f64, &'static [&'static str]) {
    if without_load > loaded { (without_load, &[WITHOUT_LOAD]) } else { (loaded, &[]) }
}

/// Reason why a bearing that never turns under load has neither life nor film.
fn idle() -> Vec<String> {
    vec!["does not turn under load".to_owned()]
}

/// Load, oil film and static safety of a plain bearing.
fn of_plain(
    judge: &mut Judge,
    (of, name_of): (&[&str], &str),
    planet: &PlanetData,
    bearing: &BearingOverDuty,
) {
    let loads = bearing.steps.iter().map(|step| step.equivalent_load_n);
    judge.see(Rule::PlainLoad, of, loads.fold(0.0, f64::max) / bearing.load_rating_n);
    let turns = bearing.steps.iter().any(|step| step.equivalent_load_n > 0.0 && step.speed_rad_s != 0.0);
    let has_diameter = planet.bearing_diameter.is_some();
    let keys = || lacking(&[("bearing_diameter", has_diameter), ("face_width", !has_diameter)]);
    match bearing.film_ratio {
        Some(ratio) => judge.see(Rule::OilFilm, of, ratio),
        None => judge.lacks(name_of, &[Rule::OilFilm], if turns { keys() } else { idle() }),
    }
    of_static(judge, (of, name_of), planet, bearing);
}

/// Static safety of a planet bearing.
fn of_static(
    judge: &mut Judge,
    (of, name_of): (&[&str], &str),
    planet: &PlanetData,
    bearing: &BearingOverDuty,
) {
    match bearing.static_safety {
        Some(safety) => judge.see(Rule::BearingStaticSafety, of, safety),
        None => {
            let is_known = planet.static_load_rating.is_some();
            let why = if is_known { "carries no load" } else { "static_load_rating" };
            judge.lacks(name_of, &[Rule::BearingStaticSafety], vec![why.to_owned()]);
        }
    }
}

/// Seconds in an hour.
const HOUR_S: f64 = 3600.0;

/// Speeds of the meshes, and the acceleration of the planets about the axis, over the steps of the duty or
/// with the reason why there are none.
fn of_speeds(
    judge: &mut Judge,
    subject: &Gearbox,
    (place, set, data): &Of<'_>,
    steps: &Result<Vec<WorkedStep<'_>>, String>,
) {
    let toothed = in_mesh(subject, data, set, data.modules.iter().any(Option::is_some));
    let (Ok(toothed), Ok(steps)) = (&toothed, steps) else {
        let is_helical = set.tooth_shape().is_helical();
        let orbits = data.planets.iter().filter(|_| !set.is_pair());
        let orbits = orbits.filter_map(|of| orbit_rule(of.rolling.into()));
        let of_mesh = if is_helical { Rule::HelicalSpeed } else { Rule::SpurSpeed };
        let rules: Vec<Rule> = [of_mesh].into_iter().chain(orbits).collect();
        let why: Vec<String> = steps.as_ref().err().cloned().into_iter().collect();
        return judge.lacks(set.id(), &rules, joined(&why, toothed.err().unwrap_or_default()));
    };
    // Under load, and without.
    let mut fastest = vec![[0.0_f64; 2]; toothed.meshes.len()];
    let mut carrier = [0.0_f64; 2];
    for step in steps {
        let WorkedStep(entry, worked) = step;
        let turning = step.turning(subject);
        let state = usize::from(worked.is_none());
        let Some(worked) = worked.as_ref().or(turning.as_ref()) else { continue };
        let speed = entry.speed.0;
        let turning = worked.analysis.speed(set.carrier()).unwrap_or_default();
        carrier[state] = carrier[state].max((speed * turning).si().abs());
        let Ok(load) = SetLoad::of(*place, worked, Some(speed)) else { continue };
        for ((mesh, own), fastest) in toothed.meshes.iter().zip(load.of_meshes(set)).zip(&mut fastest) {
            let radius = mesh.pair.gears()[0].reference_diameter() * mesh.module / 2.0;
            fastest[state] = fastest[state].max((load.speed.si() * own.speeds[0]).abs() * radius);
        }
    }
    for (mesh, speeds) in toothed.meshes.iter().zip(fastest) {
        let (speed, state) = greatest(speeds);
        if speed > 0.0 {
            let name = mesh.gears.map(|gear| set.gear_name(gear)).join("–");
            let of = [&[set.id(), &name], state].concat();
            judge.take(&of, of_speed(&judge.limits, &mesh.pair, speed));
        }
    }
    let (carrier, state) = greatest(carrier);
    if !set.is_pair() && carrier > 0.0 {
        for ((planet, radius), of_file) in set.planets().iter().zip(&toothed.radii).zip(&data.planets) {
            let Some(radius) = radius else { continue };
            let of = [set.id(), planet.name.as_str()];
            // Planets of short sets have no name.
            let of = [&of[..1 + usize::from(!planet.name.is_empty())], state].concat();
            if let Some(rule) = orbit_rule(of_file.rolling.into()) {
                judge.see(rule, &of, orbit_acceleration(*radius, carrier));
            }
        }
    }
}

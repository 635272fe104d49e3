//! Rules for loads, speeds and losses.

use super::judge::Judge;
use super::teeth::width_ratio;
use crate::analyze::answer::pins::{GRAVITY, orbit_rule, speed_rule, stated};
use crate::analyze::answer::{Input, Worked};
use crate::shared::gearbox::Gearbox;
use crate::shared::toothed::toothed;
use crate::strength::answer::duty::{WorkedStep, steps};
use crate::strength::answer::load::SetLoad;
use crate::strength::answer::records::{BearingOverDuty, MeshName};
use crate::strength::answer::{Strength, over_duty};
use epicyclic_formats::gearbox::{GearboxFile, RollingEntry, SetData};
use epicyclic_judge::Rule;
use epicyclic_train::PlanetSet;
use epicyclic_units::Physical;
use std::f64::consts::TAU;

/// Rules that need the strength of the teeth.
const OF_STRENGTH: [Rule; 3] = [Rule::FlankSafety, Rule::RootSafety, Rule::DynamicFactor];

/// Rules that need a duty.
const OF_DUTY: [Rule; 5] = [
    Rule::BearingLife,
    Rule::BearingStaticSafety,
    Rule::OrbitAcceleration,
    Rule::SpurSpeed,
    Rule::HelicalSpeed,
];

/// Symbol of the dynamic factor.
const DYNAMIC: &str = "K_v";

/// Symbol of the face load factor of flanks.
const FACE_LOAD: &str = "K_Hβ";

/// Judges what the file says of loads: over its duty, or at an operating point.
pub(super) fn judge(
    judge: &mut Judge,
    subject: &Gearbox,
    file: &GearboxFile,
    set: Option<&str>,
    strength: Option<&Strength>,
) {
    of_gears(judge, subject);
    let name = subject.train.name();
    let is_wanted = |id: &str| set.is_none_or(|set| set == id);
    let (own, why) = match strength {
        Some(_) => (None, None),
        None => match over_duty(subject, file) {
            Ok(Some(strength)) => (Some(strength), None),
            Ok(None) => (None, Some("duty, oil, life and the strength of sets".to_owned())),
            Err(error) => (None, Some(error.to_string())),
        },
    };
    judge.lacks_if(name, &OF_STRENGTH, why);
    if let Some(strength) = strength.or(own.as_ref()) {
        of_strength(judge, file, strength, &is_wanted);
        for one in subject.train.sets().iter().filter(|set| is_wanted(set.id())) {
            if let Some(data) = file.set_data(one) {
                of_face_loads(judge, subject, strength, one, &data);
            }
        }
    }
    let why = match steps(subject, &file.duty) {
        _ if file.duty.is_empty() => Some("duty".to_owned()),
        Err(error) => Some(error.to_string()),
        Ok(steps) => {
            let sets = subject.train.sets().iter().enumerate();
            for one in sets.filter(|(_, set)| is_wanted(set.id())) {
                of_speeds(judge, subject, file, one, &steps);
            }
            None
        }
    };
    judge.lacks_if(name, &OF_DUTY, why);
}

/// Circulating power and efficiency of each gear.
fn of_gears(judge: &mut Judge, subject: &Gearbox) {
    for gear in subject.train.gears() {
        let Ok(worked) = Worked::new(&subject.train, gear.name(), Input::default()) else { continue };
        let name = format!("gear {}", gear.name());
        if let Some(case) = worked.analysis.driving() {
            judge.see(Rule::CirculatingPower, &[&name], case.power.circulating);
        }
        // Sets that turn as one have no loss: the number of those that roll is that of the stages.
        let rolling =
            worked.analysis.sets().iter().filter(|set| set.relative.is_some_and(|speed| speed != 0.0));
        let stages = rolling.count();
        if let Some(efficiency) = worked.analysis.efficiency().filter(|efficiency| *efficiency > 0.0)
            && stages > 0
        {
            let each = libm::pow(efficiency, 1.0 / stages as f64);
            judge.see(Rule::StageEfficiency, &[&name], each);
        }
    }
}

/// Safeties, lives and load factors.
fn of_strength(judge: &mut Judge, file: &GearboxFile, strength: &Strength, is_wanted: &dyn Fn(&str) -> bool) {
    for (set, mesh, gear, safeties) in safeties(strength) {
        if !is_wanted(set) {
            continue;
        }
        let name = format!("{gear} in the mesh {}", mesh.gears.join("–"));
        for (rule, safety, required) in [
            (Rule::FlankSafety, safeties[0], strength.required.flank),
            (Rule::RootSafety, safeties[1], strength.required.root),
        ] {
            if let Some(safety) = safety {
                judge.see(rule, &[set, &name], safety / required);
            }
        }
    }
    for one in strength.overload.iter().filter(|one| is_wanted(&one.set)) {
        let name = format!("{} in the mesh {}, overload", one.toothed_gear, one.mesh.gears.join("–"));
        for (rule, safety, required) in [
            (Rule::FlankSafety, one.flank_safety, one.required.flank),
            (Rule::RootSafety, one.root_safety, one.required.root),
        ] {
            if let Some(safety) = safety {
                judge.see(rule, &[&one.set, &name], safety / required);
            }
        }
    }
    of_dynamics(judge, strength, is_wanted);
    for bearing in strength.bearings.iter().filter(|bearing| is_wanted(&bearing.set)) {
        of_bearing(judge, file, strength, bearing);
    }
}

/// Set, mesh, gear and safeties of flank and root.
fn safeties(strength: &Strength) -> impl Iterator<Item = (&str, &MeshName, &str, [Option<f64>; 2])> {
    let points = strength.at_point.iter().map(|one| {
        (one.set.as_str(), &one.mesh, one.toothed_gear.as_str(), [one.flank_safety, one.root_safety])
    });
    let duties = strength.over_duty.iter().map(|one| {
        let safety = [&one.flank, &one.root].map(|wear| wear.as_ref().map(|wear| wear.safety));
        (one.set.as_str(), &one.mesh, one.toothed_gear.as_str(), safety)
    });
    points.chain(duties)
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

/// The greatest dynamic factor of each mesh.
fn of_dynamics(judge: &mut Judge, strength: &Strength, is_wanted: &dyn Fn(&str) -> bool) {
    let mut greatest: Vec<Factored<'_>> = vec![];
    for one in factored(strength).filter(|one| one.symbol == DYNAMIC && is_wanted(one.set)) {
        match greatest.iter_mut().find(|known| known.set == one.set && known.mesh == one.mesh) {
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
    let Ok(Ok(toothed)) = toothed(subject, data, set) else { return };
    for mesh in &toothed.meshes {
        let name = MeshName::of(set, mesh.gears);
        let Some(width) = data.common_width(mesh.gears) else { continue };
        let is_own = |one: &Factored<'_>| one.set == set.id() && *one.mesh == name && one.symbol == FACE_LOAD;
        if let Some(given) = factored(strength).find(|one| is_own(one) && one.is_given)
            && !mesh.pair.is_internal()
        {
            let ratio = width_ratio(mesh, width);
            let of = [set.id(), &name.gears.join("–")];
            judge.see(Rule::FaceLoad, &of, given.greatest / (1.0 + 0.4 * ratio * ratio));
        }
    }
}

/// Life, static safety, speed and load of a planet bearing.
fn of_bearing(judge: &mut Judge, file: &GearboxFile, strength: &Strength, bearing: &BearingOverDuty) {
    let rolling =
        stated(file, &bearing.set, &bearing.planet).map_or(RollingEntry::default(), |(rolling, _)| rolling);
    // Planets of short sets have no name.
    let name = match bearing.planet.parse::<u32>() {
        Ok(_) => "planet bearing".to_owned(),
        Err(_) => format!("bearing of the {}", bearing.planet),
    };
    let of = [bearing.set.as_str(), name.as_str()];
    if let Some(life) = bearing.life_s() {
        judge.see(Rule::BearingLife, &of, life / strength.life_s);
    }
    match bearing.static_safety {
        Some(safety) => judge.see(Rule::BearingStaticSafety, &of, safety),
        None => {
            judge.lacks(&name_of(&of), &[Rule::BearingStaticSafety], vec!["static_load_rating".to_owned()]);
        }
    }
    let force = bearing.steps.iter().map(|step| step.force_n).fold(0.0, f64::max);
    if !bearing.rollers && force > 0.0 {
        judge.see(Rule::BallLoad, &of, force / 1e3);
    }
    let loads = bearing.steps.iter().map(|step| step.equivalent_load_n).filter(|load| *load > 0.0);
    if let Some(least) = loads.reduce(f64::min) {
        judge.see(Rule::BearingLeastLoad, &of, least / bearing.load_rating_n);
    }
    let fastest = bearing.steps.iter().map(|step| step.speed_rad_s).fold(0.0, f64::max);
    match bearing.mean_diameter_m {
        // Revolutions a minute times mm.
        Some(diameter) => judge.see(speed_rule(rolling), &of, fastest * 60.0 / TAU * 1e3 * diameter),
        None => judge.lacks(&name_of(&of), &[Rule::PinSpeed], vec!["bearing_diameter".to_owned()]),
    }
}

fn name_of(of: &[&str]) -> String {
    of.join(", ")
}

/// Speeds of the meshes, and the acceleration of the planets about the axis.
fn of_speeds(
    judge: &mut Judge,
    subject: &Gearbox,
    file: &GearboxFile,
    (place, set): (usize, &PlanetSet),
    steps: &[WorkedStep<'_>],
) {
    let Some(data) = file.set_data(set) else { return };
    let toothed = match toothed(subject, &data, set) {
        Ok(Ok(toothed)) if data.modules.iter().any(Option::is_some) => toothed,
        _ => {
            let rules = [Rule::SpurSpeed, Rule::HelicalSpeed, Rule::OrbitAcceleration];
            return judge.lacks(set.id(), &rules, vec!["module".to_owned()]);
        }
    };
    let mut fastest = vec![0.0_f64; toothed.meshes.len()];
    let mut carrier = 0.0_f64;
    for WorkedStep(entry, worked) in steps {
        let Some(worked) = worked else { continue };
        let speed = entry.speed.0;
        let turning = worked.analysis.speed(set.carrier()).unwrap_or_default();
        carrier = carrier.max((speed * turning).si().abs());
        let Ok(load) = SetLoad::of(place, worked, Some(speed)) else { continue };
        for ((mesh, own), fastest) in toothed.meshes.iter().zip(load.of_meshes(set)).zip(&mut fastest) {
            let radius = mesh.pair.gears()[0].reference_diameter() * mesh.module / 2.0;
            *fastest = fastest.max((load.speed.si() * own.speeds[0]).abs() * radius);
        }
    }
    for (mesh, speed) in toothed.meshes.iter().zip(fastest).filter(|(_, speed)| *speed > 0.0) {
        let is_spur = mesh.pair.gears()[0].profile().helix_angle.si() == 0.0;
        let rule = if is_spur { Rule::SpurSpeed } else { Rule::HelicalSpeed };
        let name = mesh.gears.map(|gear| set.gear_name(gear)).join("–");
        judge.see(rule, &[set.id(), &name], speed);
    }
    if !set.is_pair() && carrier > 0.0 {
        for (planet, radius) in set.planets().iter().zip(&toothed.radii) {
            let Some(radius) = radius else { continue };
            let of = [set.id(), planet.name.as_str()];
            let rolling = stated(file, set.id(), &planet.name).map_or(RollingEntry::default(), |of| of.0);
            // Planets of short sets have no name.
            let of = &of[..1 + usize::from(!planet.name.is_empty())];
            judge.see(orbit_rule(rolling), of, radius * carrier * carrier / GRAVITY);
        }
    }
}

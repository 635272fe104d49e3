//! The search for a size against the trial of every design, with formulas written once more.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common::{conveyor, helical, helix_angles, mm, with_pairs};
use epicyclic_gears::ToothCount;
use epicyclic_gears::involute::family::{Family, natural_centre_distance};
use epicyclic_gears::involute::profile::{Cutting, Profiles};
use epicyclic_gears::involute::tool::{Shaper as GearShaper, Tool};
use epicyclic_gears::involute::{InvoluteGear, Pair, PlanetSet, Profile};
use epicyclic_gears::life::{Rolling, basic_rating_life};
use epicyclic_gears::spacing::PlanetSpacing;
use epicyclic_strength::factor::{Given, Symbol};
use epicyclic_strength::mesh::{Gear, Mesh, Method};
use epicyclic_strength::rating::overload;
use epicyclic_strength::root::section::Shaper;
use epicyclic_strength::sizing::bearing::{Bearing, listed, listed_rollers};
use epicyclic_strength::sizing::{
    Design, DesignedPlanet, Found, HeldShifts, Objective, Requirement, SetOverload, SetStep, SetTeeth,
    Sizing, Space, size,
};
use epicyclic_strength::spectrum::{Step, rate_duty};
use proptest::prelude::*;
use std::collections::BTreeSet;
use std::ops::ControlFlow;
use uom::si::angle::radian;
use uom::si::angular_velocity::{radian_per_second, revolution_per_minute};
use uom::si::f64::{AngularVelocity, Force, Length, Time, Torque};
use uom::si::force::newton;
use uom::si::length::{micrometer, millimeter};
use uom::si::mass::kilogram;
use uom::si::mass_density::kilogram_per_cubic_meter;
use uom::si::{time::hour, torque::newton_meter};

/// A shaper of 30 teeth with rounded tips of 0.3.
fn shaped() -> Cutting {
    let shaper = GearShaper::of_teeth(ToothCount::new(30).expect("teeth"));
    Cutting { fillet: Some(0.3), tool: Some(Tool::Shaper(shaper)), ..Cutting::default() }
}

fn in_mm(value: Length) -> f64 {
    value.get::<millimeter>()
}

fn rpm(value: f64) -> AngularVelocity {
    AngularVelocity::new::<revolution_per_minute>(value)
}

fn step(share: f64, sun_torque: f64, sun_rpm: f64, carrier_rpm: f64) -> SetStep {
    SetStep {
        share,
        sun_torque: Torque::new::<newton_meter>(sun_torque),
        sun_speed: rpm(sun_rpm),
        carrier_speed: rpm(carrier_rpm),
    }
}

/// Teeth of sun, planets and ring.
fn teeth_of(task: &Sizing) -> [ToothCount; 3] {
    task.teeth.gears().try_into().unwrap()
}

/// A set of 24, 30 and 84 teeth with a small space.
fn hoist() -> Sizing {
    let of_stage = conveyor().of_stage;
    let given = Given::load_factors([1.25, 1.1, 1.05, 1.2, 1.0]);
    let ring = given.with(Symbol::StaticNotchSensitivity, 1.0);
    let mut gears = of_stage.gears;
    gears[2].shaper = Some(Shaper { teeth: 30, shift: 0.0 });
    Sizing {
        profiles: Profiles::cut(Profile::default(), [Cutting::default(), Cutting::default(), shaped()]),
        gears,
        methods: [given, ring].map(|given| Method { given, ..Method::default() }),
        duty: vec![
            step(0.3, 400.0, 900.0, 100.0),
            step(0.6, -250.0, 900.0, 200.0),
            step(0.1, 0.0, 0.0, 300.0),
        ],
        life: Time::new::<hour>(2000.0),
        required_contact: 1.1,
        working_viscosity: None,
        required_root: 1.4,
        planet_rim: 2.0,
        widens_face_load: false,
        objective: Objective::Mass,
        practice: None,
        space: Space {
            modules: [2.0, 2.5, 3.0].map(mm).to_vec(),
            face_widths: [20.0, 30.0, 40.0, 50.0].map(mm).to_vec(),
            planets: vec![3, 4, 5],
            largest_ring: None,
            length_price: 0.0,
            bearings: listed().iter().filter(|bearing| in_mm(bearing.bore) >= 25.0).cloned().collect(),
            ..of_stage.space
        },
        ..of_stage
    }
}

/// A design with one of its bearings as the trial sees it: objectives, planets, module, centre distance and
/// face width, and whether it holds.
struct Tried {
    /// Number of rules of practice with a warning, where they count; otherwise 0.
    rank: u32,
    objectives: [f64; 2],
    place: (u32, usize, i64, usize),
    holds: bool,
    /// Share of the life of its bearing that the required life takes; 0 without a bearing.
    bearing_damage: f64,
}

/// Every design whose gears have no fault, with every bearing that fits.
fn every_design(task: &Sizing) -> (u64, Vec<Tried>) {
    let (mut count, mut all) = (0, vec![]);
    let none = [None];
    let bearings: Vec<Option<&Bearing>> = match task.space.bearings.len() {
        0 => none.to_vec(),
        _ => task.space.bearings.iter().map(Some).collect(),
    };
    let natural = natural_centre_distance(teeth_of(task), *task.profiles.shared()).unwrap();
    for &planets in &task.space.planets {
        for (module_place, &module) in task.space.modules.iter().enumerate() {
            let module = in_mm(module);
            let step = in_mm(task.space.centre_distance_step);
            for place in 0..10_000_i64 {
                let centre = place as f64 * step;
                if (centre / module - natural).abs() > task.space.reach + 1e-6 * step / module {
                    continue;
                }
                count += task.space.face_widths.len() as u64;
                let equal =
                    PlanetSpacing::least_unequal(teeth_of(task)[0], teeth_of(task)[2], planets).is_equal();
                let family = Family::new(teeth_of(task), planets, task.profiles, centre / module);
                let Ok(choice) = family.and_then(|family| family.choose(task.aim, &task.limits)) else {
                    continue;
                };
                if !equal {
                    continue;
                }
                for (width_place, &width) in task.space.face_widths.iter().enumerate() {
                    for bearing in &bearings {
                        let sizes = [module, in_mm(width)];
                        let rank = rank(task, &choice.set, planets, sizes, *bearing);
                        let made = tried(task, &choice.set, planets, sizes, *bearing);
                        if let (Some(rank), Some((objectives, holds, bearing_damage))) = (rank, made) {
                            let place = (planets, module_place, place, width_place);
                            all.push(Tried { rank, objectives, place, holds, bearing_damage });
                        }
                    }
                }
            }
        }
    }
    (count, all)
}

/// Number of rules of practice that a design misses, by the limits themselves; `None` where it is refused.
fn rank(
    task: &Sizing,
    set: &PlanetSet,
    planets: u32,
    [module, width]: [f64; 2],
    bearing: Option<&Bearing>,
) -> Option<u32> {
    if task.practice.is_none() {
        return Some(0);
    }
    let [sun, planet, ring] = set.gears();
    let [x_a, x_g, x_b] = [sun.shift(), planet.shift(), ring.shift()];
    let smaller = module * sun.reference_diameter().min(planet.reference_diameter());
    let clearances = [set.sun_mesh(), set.ring_mesh()].map(Pair::tip_clearances).concat();
    if [x_a, x_g, x_b].into_iter().any(|x| x.abs() > 1.0)
        || width > 2.0 * smaller
        || clearances.iter().any(|c| *c < 0.05)
    {
        return None;
    }
    // cos α_w = (a_d/a)·cos 20°
    let working = |[one, other]: [f64; 2], sign: f64| {
        let natural = (other + sign * one).abs() / 2.0;
        libm::acos(natural / set.centre_distance() * libm::cos(20.0_f64.to_radians())).to_degrees()
    };
    let [z_a, z_g, z_b] = teeth_of(task).map(ToothCount::as_f64);
    let slides = [set.sun_mesh(), set.ring_mesh()]
        .iter()
        .any(|pair| pair.specific_sliding().into_iter().flatten().any(|sliding| sliding.abs() > 3.0));
    let few = [set.sun_mesh(), set.ring_mesh()].iter().any(|pair| pair.transverse_contact_ratio() < 1.2);
    let [outer, inner] = [working([z_a, z_g], 1.0), working([z_g, z_b], -1.0)];
    let in_range = |value: f64, [least, most]: [f64; 2]| (least - 1e-9..=most + 1e-9).contains(&value);
    let ratio = width / smaller;
    // Two gaps, in modules and in mm, of the tips of planets at equal angles.
    let centre_mm = module * set.centre_distance();
    let side = 2.0 * centre_mm * libm::sin(std::f64::consts::PI / f64::from(planets));
    let gap_mm = side - module * planet.tip_diameter();
    let fastest = |of: &dyn Fn(&SetStep) -> AngularVelocity| {
        let speeds = task.duty.iter().map(|step| of(step).get::<radian_per_second>().abs());
        speeds.fold(0.0, f64::max)
    };
    let loaded = |step: &SetStep| if step.sun_torque.value == 0.0 { rpm(0.0) } else { step.sun_speed };
    let pitch_line = fastest(&loaded) * module * sun.reference_diameter() / 2e3;
    let orbit = centre_mm / 1e3 * fastest(&|step| step.carrier_speed).powi(2) / 9.806_65;
    let usual_sharing = [1.1, 1.25, 1.35][planets as usize - 3];
    let mut warned = vec![
        !in_range(x_a, [0.0, 0.85]),
        !in_range(x_g, [-0.4, 0.85]),
        !in_range(x_b, [-0.8, 0.7]),
        !in_range(x_a + x_g, [0.0, 1.45]),
        !in_range(outer, [20.0, 28.5]),
        !in_range(inner, [15.0, 22.0]),
        [sun, planet].iter().any(|gear| gear.tip_thickness() < 0.4),
        clearances.iter().any(|c| *c < 0.15),
        slides,
        few,
        !in_range(ratio, [0.4, 1.2]),
        1.2 < 1.0 + 0.4 * ratio * ratio,
        1.1 < usual_sharing,
        gap_mm < 0.5 * module,
        gap_mm < 1.0,
        pitch_line > 20.0,
        orbit > 150.0,
    ];
    if let Some(bearing) = bearing {
        let kg = planet_kg(task, set, module, width, in_mm(bearing.outside_diameter));
        let load = |step: &SetStep| {
            let [tangential, radial] =
                bearing_forces(set, step, planets, teeth_of(task), (centre_mm / 1e3, kg));
            libm::hypot(tangential, radial)
        };
        let loads = || task.duty.iter().map(load);
        let peaks = task.overloads.iter().map(|one| {
            load(&SetStep { sun_torque: one.sun_torque, carrier_speed: rpm(0.0), ..task.duty[0] })
        });
        let newtons = |of: Force| of.get::<newton>();
        let greatest = loads().fold(0.0, f64::max);
        let at_rest = newtons(bearing.static_load_rating.unwrap()) / peaks.fold(greatest, f64::max);
        let mean_mm = (in_mm(bearing.bore) + in_mm(bearing.outside_diameter)) / 2.0;
        let turning = fastest(&|step| step.sun_speed) * z_a / z_g * 30.0 / std::f64::consts::PI;
        warned.extend([
            bearing.rolling == Rolling::Balls && greatest > 10e3,
            at_rest < 1.5,
            loads().fold(f64::INFINITY, f64::min) / newtons(bearing.load_rating) < 0.02,
            turning * mean_mm > 5e5,
        ]);
    }
    Some(warned.into_iter().map(u32::from).sum())
}

/// Area of tip and root circles, halved, in square millimetres.
fn filled(gear: &InvoluteGear, module: f64) -> f64 {
    (disc(gear.tip_diameter() * module) + disc(gear.root_diameter() * module)) / 2.0
}

fn disc(diameter: f64) -> f64 {
    std::f64::consts::PI / 4.0 * diameter * diameter
}

fn planet_kg(task: &Sizing, set: &PlanetSet, module: f64, width: f64, bore: f64) -> f64 {
    let rho = task.gears[1].material.density.get::<kilogram_per_cubic_meter>() / 1e9;
    width * rho * (filled(set.gears()[1], module) - disc(bore))
}

/// Forces on a planet's bearing in N, along the orbit and outwards, from moments about the main axis and about
/// the planet's own.
fn bearing_forces(
    set: &PlanetSet,
    step: &SetStep,
    planets: u32,
    teeth: [ToothCount; 3],
    (centre, planet_kg): (f64, f64),
) -> [f64; 2] {
    let [zs, zp, zr] = teeth.map(ToothCount::as_f64);
    let p = f64::from(planets);
    let sun = step.sun_torque.get::<newton_meter>().abs() * 1.1;
    let carrier = sun * (1.0 + zr / zs);
    let tangential = carrier / (p * centre);
    let on_sun = sun / (p * centre * zs / (zs + zp));
    let [a1, a2] = [set.sun_mesh(), set.ring_mesh()].map(|pair| libm::tan(pair.working_angle_rad()));
    let radial = on_sun * a1 - (tangential - on_sun) * a2
        + planet_kg * centre * step.carrier_speed.get::<radian_per_second>().powi(2);
    [tangential, radial]
}

/// Load of a bearing for its life in N; with helical teeth that of both rows at the ends of the planet.
fn load_of_life(
    task: &Sizing,
    step: &SetStep,
    planets: u32,
    (centre, module, width): (f64, f64, f64),
    (bearing, [tangential, radial]): (&Bearing, [f64; 2]),
) -> f64 {
    let [zs, zp, zr] = teeth_of(task).map(ToothCount::as_f64);
    let sin = libm::sin(task.profiles.shared().helix_angle.get::<radian>());
    if sin == 0.0 {
        return libm::hypot(tangential, radial);
    }
    // Torque and axial force do the same work in a turn, in which the teeth move by their lead.
    let sun = step.sun_torque.get::<newton_meter>().abs() * 1.1 / f64::from(planets);
    let axial = 2.0 * sun * sin / (zs * module / 1e3);
    let moment = axial * centre * (zp / (zs + zp) + zp / (zr - zp));
    let lever = (width - in_mm(bearing.width) / 2.0) / 1e3;
    let rows = [1.0, -1.0].map(|end| libm::hypot(tangential / 2.0, radial / 2.0 + end * moment / lever));
    let exponent = if bearing.rolling == Rolling::Balls { 10.0 / 3.0 } else { 4.5 };
    let mean = rows.into_iter().map(|row| libm::pow(row, exponent)).sum::<f64>() / 2.0;
    2.0 * libm::pow(mean, 1.0 / exponent)
}

fn tried(
    task: &Sizing,
    set: &PlanetSet,
    planets: u32,
    [module, width]: [f64; 2],
    bearing: Option<&Bearing>,
) -> Option<([f64; 2], bool, f64)> {
    let [sun, planet, ring] = set.gears();
    let bore = bearing.map_or(0.0, |bearing| in_mm(bearing.outside_diameter));
    let rim = (planet.root_diameter() * module - bore) / 2.0;
    if task.space.width_ratio.is_some_and(|most| width > most * module * sun.reference_diameter()) {
        return None;
    }
    if let Some(bearing) = bearing
        && (rim < task.planet_rim * module
            || in_mm(bearing.width) > width
            || task.profiles.shared().helix_angle.value != 0.0 && !bearing.designation.starts_with("2 x"))
    {
        return None;
    }
    // Masses as half of tip and half of root cylinders.
    let rho = |place: usize| task.gears[place].material.density.get::<kilogram_per_cubic_meter>() / 1e9;
    let outside = (ring.root_diameter() + 2.0 * task.ring_rim) * module;
    let planet_kg = planet_kg(task, set, module, width, bore);
    let mass = width * rho(0) * filled(sun, module)
        + f64::from(planets) * planet_kg
        + width * rho(2) * (disc(outside) - filled(ring, module));
    let objectives = match task.objective {
        Objective::Mass => [mass, outside],
        Objective::Ring => [outside, mass],
        Objective::Whole => [mass + disc(outside) * 7.85e-6 * (0.12 * outside + 0.16 * width), mass],
    };
    let own = Gear { rim: bearing.map(|_| mm(rim)), ..task.gears[1] };
    let ring_gear = Gear { rim: Some(mm(task.ring_rim * module)), ..task.gears[2] };
    let inner = Pair::at_centre_distance(*planet, *ring, set.centre_distance()).unwrap();
    let [zs, zp, _] = teeth_of(task).map(ToothCount::as_f64);
    let p = f64::from(planets);
    let mesh = |pair, gears| Mesh {
        pair,
        module: mm(module),
        face_width: mm(width),
        gears,
        viscosity: task.viscosity,
    };
    let duty = |torque: f64, speed: f64| -> Vec<Step> {
        let of = |step: &SetStep| Step {
            share: step.share,
            torque: step.sun_torque.abs() * torque / p,
            speed: step.sun_speed * speed,
        };
        task.duty.iter().map(of).collect()
    };
    let method = |place: usize| Method { planets: Some(planets), ..task.methods[place] };
    let outer_duty = duty(1.0, 1.0);
    let inner_duty = duty(zp / zs, zs / zp);
    let outer = mesh(*set.sun_mesh(), [task.gears[0], own]);
    let inner = mesh(inner, [own, ring_gear]);
    let outer_rated = rate_duty(&outer, &outer_duty, task.life, [p, 1.0], &method(0)).ok()?.whole().ok()?;
    let inner_rated = rate_duty(&inner, &inner_duty, task.life, [1.0, p], &method(1)).ok()?.whole().ok()?;
    let lasts = [outer_rated, inner_rated]
        .iter()
        .flatten()
        .all(|gear| gear.contact.safety >= task.required_contact && gear.root.safety >= task.required_root);
    // On each flank of the planets the damages of both meshes add up, at stresses times the required safety:
    // flanks at torques times its square.
    let wears = |flank: f64, root: bool| {
        let factor = if root { task.required_root } else { task.required_contact.powi(2) };
        let damage = |mesh: &Mesh, place: usize, end: usize, steps: &[Step], side: f64| {
            let step = |(step, of): (&Step, &SetStep)| {
                let is_on = of.sun_torque.get::<newton_meter>() * side * flank > 0.0;
                Step { torque: if is_on { step.torque * factor } else { Torque::default() }, ..*step }
            };
            let steps: Vec<Step> = steps.iter().zip(&task.duty).map(step).collect();
            let contacts = if place == 0 { [p, 1.0] } else { [1.0, p] };
            let rated = rate_duty(mesh, &steps, task.life, contacts, &method(place)).ok()?;
            let gear = &rated.gears[end];
            Some(if root { gear.root.as_ref() } else { gear.contact.as_ref() }.unwrap().damage)
        };
        let both = [damage(&outer, 0, 1, &outer_duty, 1.0), damage(&inner, 1, 0, &inner_duty, -1.0)];
        matches!(both, [Some(one), Some(other)] if one + other > 1.0)
    };
    let wears_out = [1.0, -1.0].into_iter().any(|flank| wears(flank, false) || wears(flank, true));
    let teeth_hold = lasts
        && !wears_out
        && task.overloads.iter().filter(|one| one.sun_torque.value != 0.0).all(|one| {
            let torque = one.sun_torque.abs() / p;
            let outer = overload(&outer, torque, &method(0)).unwrap();
            let inner = overload(&inner, torque * zp / zs, &method(1)).unwrap();
            outer.gears.into_iter().chain(inner.gears).all(|gear| {
                gear.contact.unwrap() >= one.required_contact && gear.root.unwrap() >= one.required_root
            })
        });
    let bearing_damage = bearing.map_or(0.0, |bearing| {
        let centre = module * set.centre_distance() / 1e3;
        let wear: f64 = task
            .duty
            .iter()
            .map(|step| {
                let forces = bearing_forces(set, step, planets, teeth_of(task), (centre, planet_kg));
                let load = load_of_life(task, step, planets, (centre, module, width), (bearing, forces));
                let load = Force::new::<newton>(load);
                let speed = step.sun_speed * (zs / zp);
                let life = basic_rating_life(bearing.rolling, bearing.load_rating, load, speed).unwrap();
                life.map_or(0.0, |life| step.share / life.get::<hour>())
            })
            .sum();
        wear * task.life.get::<hour>()
    });
    Some((objectives, teeth_hold && bearing_damage <= 1.0, bearing_damage))
}

fn is_near(one: f64, other: f64) -> bool {
    (one - other).abs() <= 1e-12 * one.abs().max(1.0)
}

/// The trial writes centre distances in another way, and shifts that are searched for follow the last bit of
/// one by more than that.
fn is_as_tried(one: f64, other: f64) -> bool {
    (one - other).abs() <= 1e-8 * one.abs().max(1.0)
}

/// An overload in N·m with required safeties of flanks and roots.
fn peak(sun_torque: f64, required_contact: f64, required_root: f64) -> SetOverload {
    SetOverload { sun_torque: Torque::new::<newton_meter>(sun_torque), required_contact, required_root }
}

/// The search that nothing ends.
fn size_all(task: &Sizing, most: usize) -> Result<Found, epicyclic_strength::Error> {
    size(task, most, &|| ControlFlow::Continue(()))
}

/// The found designs are those of the trial that hold, each with its lightest bearing, in its order.
fn agrees(task: &Sizing) -> Result<usize, TestCaseError> {
    let (space, tried) = every_design(task);
    let mut held: Vec<&Tried> = tried.iter().filter(|one| one.holds).collect();
    // Of the bearings the one with the fewest rules missed.
    held.sort_by(|one, other| {
        let [a, b] = [one, other].map(|tried| tried.objectives);
        one.rank.cmp(&other.rank).then(a[0].total_cmp(&b[0])).then(a[1].total_cmp(&b[1]))
    });
    let mut seen = vec![];
    held.retain(|one| {
        !seen.contains(&one.place) && {
            seen.push(one.place);
            true
        }
    });
    // A rule missed counts as a quarter more of the objective, and the first of them decides.
    held.sort_by(|one, other| {
        let price = |tried: &Tried| tried.objectives[0] * 1.25_f64.powi(i32::try_from(tried.rank).unwrap());
        (one.rank > 0)
            .cmp(&(other.rank > 0))
            .then(price(one).total_cmp(&price(other)))
            .then(one.objectives[1].total_cmp(&other.objectives[1]))
            .then(one.place.cmp(&other.place))
    });
    let all = size_all(task, usize::MAX).unwrap();
    prop_assert_eq!(all.space, space);
    prop_assert_eq!(all.found.len(), held.len());
    prop_assert_eq!(all.not_reached, 0);
    prop_assert_eq!(all.left_out.total() + held.len() as u64, space);
    for (design, tried) in all.found.iter().zip(&held) {
        prop_assert_eq!(design.rules_missed, tried.rank);
        let damage = design.planets[0].life.map_or(0.0, |life| (task.life / life).value);
        prop_assert!(is_as_tried(damage, tried.bearing_damage), "{} for {}", damage, tried.bearing_damage);
        let (mass, ring) = (design.mass.get::<kilogram>(), in_mm(design.ring_diameter.unwrap()));
        let objectives = match task.objective {
            Objective::Mass => [mass, ring],
            Objective::Ring => [ring, mass],
            Objective::Whole => [mass + design.structure.get::<kilogram>(), mass],
        };
        prop_assert!(
            (0..2).all(|place| is_as_tried(objectives[place], tried.objectives[place])),
            "{:?} for {:?}",
            objectives,
            tried.objectives
        );
    }
    // The first alone is the first of all, and what is not reached completes the space.
    let first = size_all(task, 1).unwrap();
    prop_assert_eq!(first.found.first(), all.found.first());
    prop_assert_eq!(first.left_out.total() + first.not_reached + first.found.len() as u64, space);
    prop_assert_eq!(first.nearest_miss.is_some(), held.is_empty() && !tried.is_empty());
    Ok(held.len())
}

#[test]
fn the_best_is_that_of_every_trial() {
    let held = agrees(&hoist()).unwrap();
    assert!(held > 10, "{held}");
    for objective in [Objective::Ring, Objective::Whole] {
        assert!(agrees(&Sizing { objective, ..hoist() }).unwrap() > 10);
    }
    // Balls and rollers, wide and narrow faces, speeds about their limits: many ranks.
    let practice = Some(epicyclic_judge::Limits::default());
    let widths = [10.0, 20.0, 40.0, 60.0, 90.0].map(mm).to_vec();
    let both = [listed(), listed_rollers()].concat();
    let bearings = both.into_iter().filter(|bearing| in_mm(bearing.bore) >= 30.0).collect();
    let space = Space { face_widths: widths, bearings, ..hoist().space };
    let duty = vec![step(0.4, 400.0, 5500.0, 1250.0), step(0.6, -250.0, 900.0, 200.0)];
    let overloads = vec![peak(700.0, 0.5, 0.5)];
    let life = Time::new::<hour>(300.0);
    let by_practice = Sizing { practice, space, duty, overloads, life, required_contact: 0.8, ..hoist() };
    let all = size_all(&by_practice, usize::MAX).unwrap();
    let missed: BTreeSet<u32> = all.found.iter().map(|design| design.rules_missed).collect();
    assert!(missed.len() > 2 && all.left_out.practice > 0, "{missed:?} of {}", all.found.len());
    assert!(agrees(&by_practice).unwrap() > 10);
    assert!(agrees(&Sizing { objective: Objective::Ring, ..by_practice }).unwrap() > 10);
}

/// Where every design has a warning, a narrow face with one more does not come first for a tenth of the mass.
#[test]
fn a_warning_that_all_have_does_not_hide_another() {
    let mut task = Sizing { practice: Some(epicyclic_judge::Limits::default()), ..hoist() };
    // Beyond 150 g in every layout.
    task.duty = vec![step(1.0, 60.0, 4000.0, 2500.0)];
    task.life = Time::new::<hour>(50.0);
    task.space.face_widths = [18.0, 20.0, 40.0].map(mm).to_vec();
    (task.space.planets, task.space.bearings) = (vec![3], [].into());
    let found = size_all(&task, 1).unwrap();
    let best = &found.found[0];
    assert_eq!(best.rules_missed, 1);
    assert!(best.width_ratios[0] > 0.4, "{:?}", best.width_ratios);
    let narrow = size_all(&Sizing { practice: None, ..task }, 1).unwrap();
    assert!(narrow.found[0].width_ratios[0] < 0.4, "{:?}", narrow.found[0].width_ratios);
}

#[test]
fn an_overload_asks_for_more() {
    let mut task = hoist();
    task.overloads = vec![peak(0.0, 9.0, 9.0), peak(-1900.0, 1.0, 1.3), peak(1500.0, 1.1, 1.0)];
    let with = agrees(&task).unwrap();
    let without = agrees(&hoist()).unwrap();
    assert!(10 < with && with < without, "{with} of {without}");
    let all = size_all(&task, usize::MAX).unwrap();
    assert!(all.left_out.overload > 0);
    // An overload that loads no set sets no requirement.
    task.overloads.truncate(1);
    let idle = size_all(&task, 1).unwrap();
    assert_eq!(idle, size_all(&hoist(), 1).unwrap());
    assert_eq!(idle.found[0].overload, None);
}

#[test]
fn shifts_that_are_held_fix_the_centre_distance() {
    let mut task = hoist();
    let natural = natural_centre_distance(teeth_of(&task), *task.profiles.shared()).unwrap();
    let family = Family::new(teeth_of(&task), 3, task.profiles, natural + 0.1).unwrap();
    let set = family.choose(task.aim, &task.limits).unwrap().set;
    task.held_shifts = Some(HeldShifts {
        profile: set.gears().map(InvoluteGear::shift),
        tips: Some(set.gears().map(InvoluteGear::tip_alteration)),
    });
    let found = size_all(&task, 1).unwrap();
    let best = &found.found[0];
    let shifts: Vec<f64> = best.layout.gears.iter().map(InvoluteGear::shift).collect();
    assert_eq!(shifts, set.gears().map(InvoluteGear::shift));
    assert!(is_near(in_mm(best.layout.radii[0]), in_mm(best.layout.modules[0]) * (natural + 0.1)));
    // 108 places for the planets: 3 and 4 fit at equal angles, 5 do not.
    assert_eq!((found.space, found.geometries), (9 * 4, 6));
}

#[test]
fn what_is_out_of_reach_has_a_nearest_miss() {
    let mut task = hoist();
    task.required_root = 9.0;
    let found = size_all(&task, 1).unwrap();
    let miss = found.nearest_miss.unwrap();
    assert!(found.found.is_empty() && found.not_reached == 0);
    assert_eq!(miss.governing.requirement, Requirement::Root);
    assert!(miss.governing.ratio() < 1.0);
    assert!(found.left_out.root > 0);
}

#[test]
fn no_space_no_duty_and_no_numbers_are_refused() {
    let of = |change: &dyn Fn(&mut Sizing)| {
        let mut task = hoist();
        change(&mut task);
        size_all(&task, 1).unwrap_err().to_string()
    };
    assert_eq!(of(&|task| task.space.modules.clear()), "no module to search; at least one is needed");
    assert_eq!(
        of(&|task| task.space.planets.clear()),
        "no number of planets to search; at least one is needed"
    );
    assert_eq!(
        of(&|task| task.space.modules = vec![mm(-2.0)]),
        "module is -2 mm; it must be finite and above 0"
    );
    assert_eq!(
        of(&|task| task.space.face_widths[1] = mm(0.0)),
        "face width is 0 mm; it must be finite and above 0"
    );
    assert!(
        of(&|task| task.space.centre_distance_step = mm(0.0))
            .starts_with("step of the centre distances is 0 mm")
    );
    let of_none = |task: &mut Sizing| {
        (task.space.centre_distance_step, task.space.reach) = (mm(7.7), 0.0);
    };
    let too_fine = of(&|task| task.space.centre_distance_step = Length::new::<micrometer>(1e-3));
    assert!(too_fine.starts_with("the space has 180000000 centre distances"), "{too_fine}");
    assert!(of(&|task| task.space.centre_distance_step = mm(1e-308)).contains("at most 300000"));
    assert_eq!(of(&of_none), "no centre distance to search; at least one is needed");
    assert_eq!(of(&|task| task.duty.truncate(1)), "the shares of the duty sum to 0.3; they must sum to 1");
    assert!(of(&|task| task.duty = vec![step(1.0, 0.0, 0.0, 0.0)]).starts_with("the duty has no step"));
    assert!(of(&|task| task.required_root = f64::NAN).starts_with("required safety is NaN"));
    assert!(of(&|task| task.overloads = vec![peak(10.0, 1.0, -1.0)]).starts_with("required safety is -1"));
    assert!(of(&|task| task.space.planets = vec![0]).starts_with("number of planets is 0"));
    let one_row = of(&|task| *task = helical(task.clone(), 15.0));
    assert!(one_row.ends_with("pairs of bearings are needed"), "{one_row}");
}

/// The design of the first space in plain figures.
#[test]
fn a_design_names_its_figures() {
    let found = size_all(&hoist(), 3).unwrap();
    let Design { planets, governing, .. } = &found.found[0];
    let DesignedPlanet { bearing, bore, rim, .. } = &planets[0];
    let [outside, bore] = [bearing.as_ref().unwrap().outside_diameter, bore.unwrap()].map(in_mm);
    assert!(is_near(outside, bore));
    assert!(rim.is_some() && governing.ratio() >= 1.0);
    let mass = |place: usize| found.found[place].mass;
    assert!(mass(0) <= mass(1) && mass(1) <= mass(2));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]
    #[test]
    fn any_small_space_agrees_with_every_trial(
        sun in 17..30_u32, planet in 18..40_u32, offset in -1..=2_i32, torque in 30.0..400.0_f64,
        module in 0..3_usize, step_mm in 0.7..2.0_f64, ring in any::<bool>(), rolls in any::<bool>(),
        ratio in prop::option::of(0.4..1.2_f64), life in 100.0..10_000.0_f64, rim in 0.6..3.0_f64,
        overload in prop::option::of((1.0..8.0_f64, 0.8..1.5_f64, 0.8..1.5_f64)), helix in helix_angles(),
    ) {
        let ring_teeth = (sun + 2 * planet).checked_add_signed(offset).unwrap();
        let mut task = helical(hoist(), helix);
        task.teeth = SetTeeth::Simple([sun, planet, ring_teeth].map(|teeth| ToothCount::new(teeth).unwrap()));
        task.duty = vec![step(0.5, torque, 700.0, 150.0), step(0.5, torque * 0.6, 300.0, 50.0)];
        task.life = Time::new::<hour>(life);
        task.planet_rim = rim;
        task.overloads = overload.into_iter().map(|(factor, flank, root)| peak(torque * factor, flank, root)).collect();
        task.space.modules = [1.5, 2.0, 3.0, 4.0][module..module + 2].iter().map(|module| mm(*module)).collect();
        task.space.face_widths = [15.0, 25.0, 45.0].map(mm).to_vec();
        task.space.centre_distance_step = mm(step_mm);
        task.space.width_ratio = ratio;
        task.objective = if ring { Objective::Ring } else { Objective::Mass };
        task.space.bearings = if rolls {
            with_pairs(listed().iter().filter(|bearing| in_mm(bearing.bore) % 10.0 < 0.5)).into()
        } else {
            [].into()
        };
        agrees(&task)?;
    }
}

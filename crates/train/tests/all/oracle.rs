//! The solver against an oracle that shares no formula with it, over random gearboxes of all kinds of sets.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use crate::common;

use common::oracle::{self, BoxPlan, Dice, Loads, SetPlan, Speeds};
use epicyclic_train::{Analysis, Direction, Gearbox, LoadCase, State};

/// Counts of the cases met on the way.
#[derive(Debug, Default)]
struct Met {
    built: usize,
    driven: usize,
    compared: usize,
    with_compound: usize,
    several_sets: usize,
    with_elements: usize,
    reversed: usize,
    locked: usize,
    back_driving: usize,
    enumerated: usize,
    several_patterns: usize,
}

fn close(name: &str, one: f64, other: f64, scale: f64) {
    assert!((one - other).abs() <= 1e-10 * scale, "{name}: {one} {other}, scale {scale}");
}

/// Direction of power through each mesh according to the solver, in the plan's senses.
fn senses(plan: &BoxPlan, gearbox: &Gearbox, case: &LoadCase) -> Vec<i8> {
    let mut signs = vec![];
    for (place, (set, built)) in plan.sets.iter().zip(gearbox.sets()).enumerate() {
        let powers = case.meshes(gearbox, place).unwrap();
        for ((gears, _), (mesh, own)) in set.meshes.iter().zip(built.meshes().iter().zip(&powers)) {
            signs.push(if mesh.gears == *gears { own.sense } else { -own.sense });
        }
    }
    signs
}

fn compare_speeds(plan: &BoxPlan, found: &Analysis, speeds: &Speeds) {
    let scale = speeds.links.iter().fold(1.0_f64, |most, speed| most.max(speed.abs()));
    for (link, &speed) in speeds.links.iter().enumerate() {
        close("speed", found.speeds()[link].unwrap(), speed, scale);
    }
    let output = speeds.links[plan.output];
    close("ratio", 1.0 / found.ratio().unwrap(), output, scale);
    let exact = found.exact_ratio().unwrap();
    close("exact", *exact.denom() as f64 / *exact.numer() as f64, output, scale);
    for (set, (motion, bodies)) in plan.sets.iter().zip(found.sets().iter().zip(&speeds.bodies)) {
        let carrier = speeds.links[set.carrier];
        for (planet, own) in motion.planets.iter().enumerate() {
            let body = bodies[set.centrals.len() + planet];
            let own = own.as_ref().unwrap();
            close("planet", own.relative, body - carrier, 10.0 * scale);
            if let Some(speed) = own.speed {
                close("planet", speed, body, 10.0 * scale);
            }
        }
    }
}

fn compare_loads(plan: &BoxPlan, gearbox: &Gearbox, case: &LoadCase, loads: &Loads, speeds: &Speeds) {
    let least = speeds
        .links
        .iter()
        .skip(1)
        .fold(1.0_f64, |least, s| if *s == 0.0 { least } else { least.min(s.abs()) });
    let power = loads.largest;
    // Torques on links that rest have no power to be measured by; those that turn slowly are large.
    let torque =
        loads.members.iter().flatten().chain([&1.0]).fold(power / least.max(1e-3), |m, t| m.max(t.abs()));
    close("efficiency", case.efficiency, loads.efficiency, power);
    close("input", case.input, loads.input, torque);
    close("output", case.output, loads.output, torque);
    for ((set, own), torques) in plan.sets.iter().zip(&case.members).zip(&loads.members) {
        for (member, (own, expected)) in own.as_ref().unwrap().iter().zip(torques).enumerate() {
            close(&format!("member {member} of {:?}", set.kind), *own, *expected, torque);
        }
    }
    for (place, (pair, on)) in plan.elements.iter().enumerate() {
        let expected = if *on { loads.elements[place] } else { 0.0 };
        close(&format!("element {pair:?}"), case.shift_elements[place].unwrap(), expected, torque);
    }
    let mut lost = 0.0;
    for (at, ((set, built), (own, expected))) in
        plan.sets.iter().zip(gearbox.sets()).zip(case.power.sets.iter().zip(&loads.meshes)).enumerate()
    {
        let own = own.as_ref().unwrap();
        let meshes = case.meshes(gearbox, at).unwrap();
        let mut set_lost = 0.0;
        for (place, [first, second]) in expected.iter().enumerate() {
            let gives = if *first < 0.0 { [-first, *second] } else { [-second, *first] };
            close("enters", meshes[place].enters, gives[0], power);
            close("leaves", meshes[place].leaves, gives[1], power);
            let is_same = built.meshes()[place].gears == set.meshes[place].0;
            let sense = if is_same { meshes[place].sense } else { -meshes[place].sense };
            if gives[0] > 1e-9 * power {
                assert_eq!(f64::from(sense), -first.signum());
            }
            set_lost += gives[0] - gives[1];
        }
        close("loss", own.loss, set_lost, power);
        lost += set_lost;
    }
    close("balance", lost, 1.0 - case.efficiency, power);
}

fn examine(plan: &BoxPlan, met: &mut Met, dice: &mut Dice) {
    let Ok(gearbox) = plan.build(None) else { return };
    met.built += 1;
    let found = gearbox.analyze("g").unwrap();
    if *found.kinematic_state() != State::Driven {
        return;
    }
    met.driven += 1;
    let Some(speeds) = oracle::speeds(plan) else { return };
    let size = speeds.links.iter().fold(0.0_f64, |most, speed| most.max(speed.abs()));
    if size > 1e3 || speeds.links[plan.output].abs() < 1e-3 {
        return;
    }
    compare_speeds(plan, &found, &speeds);
    let ideal = oracle::loads(plan, &speeds, Direction::Drive, &vec![0; plan.mesh_count()], 1.0);
    let Some(ideal) = ideal else { return };
    if ideal.largest > 1e4 {
        return;
    }
    compare_loads(plan, &gearbox, found.ideal().unwrap(), &ideal, &speeds);
    for direction in [Direction::Drive, Direction::BackDrive] {
        let case = match direction {
            Direction::Drive => found.driving(),
            Direction::BackDrive => found.back_driving(),
        };
        let expected = oracle::lossy(plan, &speeds, direction);
        let Some(case) = case else {
            assert!(
                expected.is_none(),
                "no branch is found, but there is one: {:?}",
                expected.map(|e| e.1.efficiency)
            );
            met.locked += 1;
            continue;
        };
        let signs = senses(plan, &gearbox, case);
        let own = oracle::loads(plan, &speeds, direction, &signs, 1.0).unwrap();
        if own.largest > 1e4 {
            continue;
        }
        compare_loads(plan, &gearbox, case, &own, &speeds);
        let (chosen, _) = expected.unwrap_or_else(|| panic!("a branch is found, but there is none"));
        assert_eq!(signs, chosen);
        if plan.mesh_count() <= 7 && dice.chance(10) {
            let all = oracle::patterns(plan, &speeds, direction);
            met.enumerated += 1;
            met.several_patterns += usize::from(all.len() > 1);
            assert!(all.iter().any(|(pattern, _)| *pattern == signs), "{all:?} {signs:?}");
        }
        met.back_driving += usize::from(direction == Direction::BackDrive);
    }
    if let Some(kreines) = found.kreines() {
        met.reversed += usize::from(!kreines.reversed.is_empty());
    }
    met.compared += 1;
    met.with_compound += usize::from(plan.sets.iter().any(|set| set.kind.is_none()));
    met.several_sets += usize::from(plan.sets.len() > 1);
    met.with_elements += usize::from(plan.elements.iter().any(|(_, on)| *on));
    reordered(plan, &gearbox, &found, dice);
}

/// Checks that the gearbox described in another order gives equal results.
fn reordered(plan: &BoxPlan, gearbox: &Gearbox, found: &Analysis, dice: &mut Dice) {
    let other = plan.build(Some(dice)).unwrap();
    let again = other.analyze("g").unwrap();
    assert_eq!(found.exact_ratio(), again.exact_ratio());
    assert_eq!(found.state().name(), again.state().name());
    for (one, name) in gearbox.links().iter().enumerate() {
        let two = other.link(name).unwrap();
        close("speed", found.speeds()[one].unwrap(), again.speed(two).unwrap(), 1e3);
    }
    for (one, two) in [(found.driving(), again.driving()), (found.back_driving(), again.back_driving())] {
        assert_eq!(one.is_some(), two.is_some());
        let Some((one, two)) = one.zip(two) else { continue };
        let power = one.power.largest;
        if power > 1e4 {
            continue;
        }
        close("efficiency", one.efficiency, two.efficiency, power);
        close("circulating", one.power.circulating, two.power.circulating, power);
        let torque = one.members.iter().flatten().flatten().fold(power, |most, t| most.max(t.abs()));
        for (place, set) in gearbox.sets().iter().enumerate() {
            let there = other.sets().iter().position(|one| one.id() == set.id()).unwrap();
            for (member, link) in set.members().iter().enumerate() {
                let name = gearbox.link_name(*link);
                let same =
                    other.sets()[there].members().iter().position(|link| other.link_name(*link) == name);
                let (same, here) = (same.unwrap(), one.members[place].as_ref().unwrap()[member]);
                close("member", here, two.members[there].as_ref().unwrap()[same], torque);
                let round =
                    |case: &LoadCase, set: usize, member: usize| case.power.circulating_member(set, member);
                close("circulating", round(one, place, member), round(two, there, same), power);
            }
        }
        for (place, shift_element) in gearbox.shift_elements().iter().enumerate() {
            let there = other.shift_elements().iter().position(|one| one.id() == shift_element.id()).unwrap();
            close("element", one.shift_elements[place].unwrap(), two.shift_elements[there].unwrap(), torque);
        }
    }
}

#[test]
fn random_gearboxes_agree_with_the_oracle() {
    let (mut dice, mut met) = (Dice(0x9e37_79b9_7f4a_7c15), Met::default());
    for _ in 0..20_000 {
        let plan = BoxPlan::random(4, 50, &mut dice);
        examine(&plan, &mut met, &mut dice);
    }
    println!("{met:?}");
    assert!(met.driven > 5000 && met.compared * 100 > met.driven * 95, "{met:?}");
    assert!(met.with_compound > 3000 && met.several_sets > 3000 && met.with_elements > 2500, "{met:?}");
    assert!(met.reversed > 50 && met.locked > 5 && met.back_driving > 5000, "{met:?}");
    assert!(met.enumerated > 800 && met.several_patterns > 5, "{met:?}");
}

/// Every usual kind and every compound form is tested alone under every pair of terminals with every third
/// member held.
#[test]
fn every_kind_of_set_agrees_with_the_oracle() {
    let (mut dice, mut met) = (Dice(7), Met::default());
    let kinds = oracle::KINDS.iter().map(|&kind| Some(kind)).chain([None; 7]);
    for (form, kind) in kinds.enumerate() {
        for _ in 0..20 {
            let mut set = match kind {
                Some(kind) => SetPlan::short(kind, &mut dice),
                None => SetPlan::compound(form - oracle::KINDS.len(), &mut dice),
            };
            let members = set.centrals.len() + 1;
            for (place, one) in set.centrals.iter_mut().enumerate() {
                one.link = place + 1;
            }
            set.carrier = if set.planets.is_empty() { 0 } else { members };
            let links = if set.planets.is_empty() { members - 1 } else { members };
            for input in 1..=links {
                for output in (1..=links).filter(|output| *output != input) {
                    for held in 1..=links {
                        let mut plan = BoxPlan::of(vec![set.clone()], links, input, output);
                        if !set.planets.is_empty() {
                            plan.elements.push(([held, 0], true));
                        }
                        examine(&plan, &mut met, &mut dice);
                    }
                }
            }
        }
    }
    println!("{met:?}");
    assert!(met.driven > 4000 && met.compared * 100 > met.driven * 95 && met.with_compound > 3000, "{met:?}");
}

/// A set in short and the same gear by gear are one.
#[test]
fn a_set_in_short_equals_the_same_gear_by_gear() {
    let mut dice = Dice(11);
    let mut compared = 0;
    for _ in 0..2000 {
        let plan = BoxPlan::random(3, 0, &mut dice);
        let mut whole = plan.clone();
        whole.sets.iter_mut().filter(|set| !set.planets.is_empty()).for_each(|set| set.kind = None);
        let (Ok(one), Ok(two)) = (plan.build(None), whole.build(None)) else { continue };
        let (short, long) = (one.analyze("g").unwrap(), two.analyze("g").unwrap());
        assert_eq!(short.state(), long.state());
        assert_eq!(short.exact_ratio(), long.exact_ratio());
        let Some((a, b)) = short.driving().zip(long.driving()) else { continue };
        close("efficiency", a.efficiency, b.efficiency, a.power.largest);
        compared += 1;
    }
    assert!(compared > 300, "{compared}");
}

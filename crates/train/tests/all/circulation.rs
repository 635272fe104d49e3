//! Circulating power against the smallest cut: what circulates through an arc of the power graph is, by the
//! theorem of Ford and Fulkerson, the least that any set of vertices between its ends lets through.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use crate::common;

use common::oracle::{BoxPlan, Dice};
use epicyclic_train::{Gearbox, LinkId, LoadCase, State};

/// An arc: from, to, power, and what the solver says circulates through it.
type Arc = (usize, usize, f64, f64);

/// Members and shift elements as arcs between links and sets.
fn arcs(gearbox: &Gearbox, case: &LoadCase, speeds: &[Option<f64>]) -> Vec<Arc> {
    let links = gearbox.links().len();
    let mut found = vec![];
    let mut add = |from: usize, to: usize, power: f64, round: f64| {
        let arc = if power > 0.0 { (from, to, power, round) } else { (to, from, -power, -round) };
        found.push(arc);
    };
    for (place, (set, power)) in gearbox.sets().iter().zip(&case.power.sets).enumerate() {
        for (member, link) in set.members().iter().enumerate() {
            let power = power.as_ref().unwrap().members[member];
            add(link.index(), links + place, power, case.power.circulating_member(place, member));
        }
    }
    for (place, shift_element) in gearbox.shift_elements().iter().enumerate() {
        let [first, second] = shift_element.links().map(LinkId::index);
        let power = case.shift_elements[place].unwrap() * speeds[first].unwrap_or(0.0);
        // Its torque acts on the first link: the power comes from the second.
        add(second, first, power, case.power.circulating_shift_element(place));
    }
    found
}

/// The least cut between the ends of an arc, over all sets of vertices.
fn least_cut(arcs: &[Arc], through: usize, vertices: usize) -> f64 {
    let (end, start) = (arcs[through].0, arcs[through].1);
    let mut least = f64::INFINITY;
    for set in 0..1_u32 << vertices {
        let has = |vertex: usize| set >> vertex & 1 == 1;
        if !has(start) || has(end) {
            continue;
        }
        let cut = arcs
            .iter()
            .enumerate()
            .filter(|(place, arc)| *place != through && has(arc.0) && !has(arc.1))
            .map(|(_, arc)| arc.2)
            .sum();
        least = least.min(cut);
    }
    least.min(arcs[through].2)
}

/// Whether any directed loop is left when vertices that only give or only take are taken away.
fn has_loop(arcs: &[Arc], nothing: f64, vertices: usize) -> bool {
    let mut reach = vec![vec![false; vertices]; vertices];
    arcs.iter().filter(|arc| arc.2 > nothing).for_each(|arc| reach[arc.0][arc.1] = true);
    for middle in 0..vertices {
        for from in 0..vertices {
            for to in 0..vertices {
                reach[from][to] |= reach[from][middle] && reach[middle][to];
            }
        }
    }
    (0..vertices).any(|vertex| reach[vertex][vertex])
}

#[test]
fn what_circulates_is_the_least_cut() {
    let mut dice = Dice(0xf10);
    let (mut compared, mut round, mut without, mut entwined) = (0, 0, 0, 0);
    for _ in 0..6000 {
        let mut plan = BoxPlan::random(4, 30, &mut dice);
        plan.ties.clear();
        let Ok(gearbox) = plan.build(None) else { continue };
        let vertices = gearbox.links().len() + gearbox.sets().len();
        if vertices > 12 {
            continue;
        }
        let found = gearbox.analyze("g").unwrap();
        if *found.kinematic_state() != State::Driven {
            continue;
        }
        for case in [found.ideal(), found.driving(), found.back_driving()].into_iter().flatten() {
            if case.members.iter().chain([&None; 0]).any(Option::is_none)
                || case.shift_elements.iter().any(Option::is_none)
                || case.power.largest > 1e3
            {
                continue;
            }
            let arcs = arcs(&gearbox, case, found.speeds());
            let scale = case.power.largest;
            let mut most = 0.0_f64;
            for place in 0..arcs.len() {
                let expected = least_cut(&arcs, place, vertices);
                assert!((arcs[place].3 - expected).abs() < 1e-10 * scale, "{:?} {expected}", arcs[place]);
                most = most.max(expected);
            }
            assert!((case.power.circulating - most).abs() < 1e-10 * scale);
            if !has_loop(&arcs, 1e-12 * scale, vertices) {
                assert_eq!(case.power.circulating, 0.0);
                without += 1;
            }
            compared += 1;
            round += usize::from(most > 1e-6);
            let parts = arcs.iter().filter(|arc| arc.3 > 1e-6 && arc.3 < most - 1e-6).count();
            entwined += usize::from(parts > 0);
        }
    }
    println!(
        "{compared} cases, {round} circulate, {without} without a loop, {entwined} in loops that share arcs"
    );
    assert!(compared > 1000 && round > 200 && without > 500 && entwined > 50);
}

/// A set with more than two central gears is drawn as several. The power at a central gear or the carrier is
/// the sum over their drawn members of that name, and each drawn set obeys the balance of powers.
#[test]
fn drawn_sets_have_the_powers_of_their_set_together() {
    let mut dice = Dice(0xd7a);
    let (mut compared, mut several, mut circulating) = (0, 0, 0);
    for _ in 0..3000 {
        let Ok(gearbox) = BoxPlan::random(3, 60, &mut dice).build(None) else { continue };
        let found = gearbox.analyze("g").unwrap();
        let cases = [found.ideal(), found.driving(), found.back_driving()];
        for (case, is_ideal) in cases.into_iter().zip([true, false, false]) {
            let Some(case) = case else { continue };
            let mut together: Vec<Option<Vec<f64>>> =
                gearbox.sets().iter().map(|set| Some(vec![0.0; set.members().len()])).collect();
            let mut parts = vec![0; gearbox.sets().len()];
            for (place, drawn) in gearbox.drawn_sets().iter().enumerate() {
                parts[drawn.set] += 1;
                let set = &gearbox.sets()[drawn.set];
                assert_eq!(drawn.links, drawn.members.map(|member| set.members()[member]));
                let Some(power) = found.drawn_power(case, place) else {
                    together[drawn.set] = None;
                    continue;
                };
                let entering: f64 = power.members.iter().sum();
                assert!(!is_ideal || entering.abs() < 1e-10 * case.power.largest, "{power:?}");
                for (at, &member) in drawn.members.iter().enumerate() {
                    if let Some(together) = &mut together[drawn.set] {
                        together[member] += power.members[at];
                    }
                    let [whole, round] = [
                        case.power.sets[drawn.set].as_ref().unwrap().members[member],
                        case.power.circulating_member(drawn.set, member),
                    ];
                    // As large a part of it circulates as of the whole member.
                    let same = power.circulating[at] * whole - power.members[at] * round;
                    assert!(same.abs() <= 1e-10 * case.power.largest * case.power.largest);
                    circulating += usize::from(power.circulating[at].abs() > 1e-6);
                }
            }
            for ((set, together), parts) in case.power.sets.iter().zip(together).zip(parts) {
                let (Some(set), Some(together)) = (set, together) else { continue };
                for (one, whole) in together.iter().zip(&set.members) {
                    assert!((one - whole).abs() < 1e-10 * case.power.largest, "{together:?} {set:?}");
                }
                compared += 1;
                several += usize::from(parts > 1);
            }
        }
    }
    println!(
        "{compared} sets, {several} of them drawn as several; {circulating} members of circulating power"
    );
    assert!(compared > 1000 && several > 200 && circulating > 100);
}

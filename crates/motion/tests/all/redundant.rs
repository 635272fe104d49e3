//! Elements that hold the same links together: one motion, whichever of them carries how much.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests, with data made to fit")]

use crate::common;

use common::{
    angle, at, close, constant, end_speed, eta, kg_m2, level, links, n_m, omega, s, start, table, torque_of,
};
use epicyclic_dynamics::gearbox::Masses;
use epicyclic_motion::{Error, Mechanism, Model, Run, Shaft, Start, State, TorqueLaw};
use epicyclic_train::set::{MeshLoss, SetKind, SetSpec};
use epicyclic_train::{GROUND, Gearbox};
use proptest::prelude::*;

/// First gear of an automatic: the low brake beside the one-way clutch holds the ring, and a half-shaft ends
/// at the vehicle. The driver lifts after a second, and the engine brakes.
#[derive(Debug, Clone, Copy)]
struct FirstGear {
    capacity: f64,
    stiffness: f64,
    damping: f64,
    vehicle: f64,
}

impl FirstGear {
    fn run(&self) -> Result<Run, Error> {
        let set = SetSpec::simple("s0", ["sun", "ring", "car"], 2.5).with_loss(MeshLoss::Set(eta(0.97)));
        let gearbox = Gearbox::builder("first gear")
            .links(["sun", "ring", "car"])
            .set(set)
            .one_way_clutch("F", "ring", GROUND)
            .brake("LR", "ring")
            .input("sun")
            .output("car")
            .build()
            .unwrap();
        let masses =
            Masses { links: links(&[("sun", 0.2), ("ring", 0.02), ("car", 0.1)]), ..Masses::default() };
        let mechanism = Mechanism::of(&gearbox, &[], &masses).unwrap();
        let mut model = Model::new(mechanism.with_body("vehicle", kg_m2(self.vehicle)).unwrap());
        let engine = table(&[(0.0, 100.0), (1.0, 100.0), (1.2, -60.0), (3.0, -60.0)]);
        model.torque("engine", "sun", TorqueLaw::over_time(engine)).unwrap();
        model.torque("drag", "vehicle", constant(-50.0)).unwrap();
        model.shift_element("LR", level(self.capacity), 1.0).unwrap();
        let shaft = Shaft::new(n_m(self.stiffness), angle(1.0)).unwrap();
        let shaft = shaft.damping(n_m(self.damping), omega(1.0)).unwrap();
        model.shaft("half shaft", ["car", "vehicle"], shaft).unwrap();
        let begin = start(&[("sun", 35.0), ("car", 10.0), ("vehicle", 10.0)]);
        model.run(&begin, s(3.0), None)
    }
}

/// Three capacities, stiffnesses, two dampings and vehicles: 36 in all.
#[test]
fn a_brake_beside_a_one_way_clutch_behind_a_shaft_lets_go_when_the_driver_lifts() {
    for capacity in [20.0, 60.0, 150.0] {
        for stiffness in [2e3, 8e3, 2e4] {
            for damping in [5.0, 20.0] {
                for vehicle in [40.0, 120.0] {
                    let one = FirstGear { capacity, stiffness, damping, vehicle };
                    let run = one.run().unwrap_or_else(|error| panic!("{one:?}: {error}"));
                    assert!(run.audit.residual().abs() < 1e-9, "{one:?}: {:e}", run.audit.residual());
                    // As long as the engine drives, the ring is held; braking, it asks −2.5·60 N·m and more
                    // of the brake alone.
                    assert!(at(&run.events[0]) > 1.0, "{one:?}");
                    if capacity < 150.0 {
                        let [first, ..] = &run.events[..] else { panic!("{one:?}: no event") };
                        assert_eq!(first.after.states, [State::Forward, State::Forward], "{one:?}");
                        assert!(end_speed(&run, "ring") > 0.0, "{one:?}");
                        close(torque_of(&first.after, 1), -capacity, 1e-9);
                    }
                }
            }
        }
    }
}

/// Bodies `a`, `b` and a vehicle on an elastic shaft of `b`; between `a` and `b` and from each to the housing
/// any number of friction elements and one-way clutches.
#[derive(Debug, Clone)]
struct Bodies {
    inertias: [f64; 3],
    groups: [Group; 3],
    torques: [f64; 4],
    load: f64,
    stiffness: f64,
    damping: f64,
}

/// Elements between the same links: capacities before and after a time, and one-way clutches by whether they
/// are turned round.
#[derive(Debug, Clone)]
struct Group {
    capacities: Vec<[f64; 2]>,
    from: f64,
    one_ways: Vec<bool>,
}

/// Links of the groups; 3 is the housing.
const ENDS: [[usize; 2]; 3] = [[0, 1], [0, 3], [1, 3]];
const NAMES: [&str; 4] = ["a", "b", "vehicle", GROUND];
const END: f64 = 1.0;

fn group() -> impl Strategy<Value = Group> {
    let capacity = prop_oneof![Just(0.0), 5.0..120.0_f64];
    let capacities = prop::collection::vec([capacity.clone(), capacity], 0..3);
    let one_ways = prop::collection::vec(any::<bool>(), 0..2);
    (capacities, 0.0..0.9_f64, one_ways).prop_map(|(capacities, from, one_ways)| Group {
        capacities,
        from,
        one_ways,
    })
}

fn bodies() -> impl Strategy<Value = Bodies> {
    let torque = || -120.0..120.0_f64;
    (
        [0.05..0.5_f64, 0.05..0.5_f64, 1.0..10.0_f64],
        [group(), group(), group()],
        [torque(), torque(), torque(), torque()],
        -60.0..60.0_f64,
        200.0..5000.0_f64,
        1.0..20.0_f64,
    )
        .prop_map(|(inertias, groups, torques, load, stiffness, damping)| Bodies {
            inertias,
            groups,
            torques,
            load,
            stiffness,
            damping,
        })
}

impl Group {
    fn capacity(&self, one: [f64; 2], t: f64) -> f64 {
        one[0] + (one[1] - one[0]) * ((t - self.from) / 0.1).clamp(0.0, 1.0)
    }

    /// One friction element with all their capacity, and each one-way clutch once.
    fn merged(&self) -> Self {
        let sum = self.capacities.iter().fold([0.0; 2], |sum, one| [sum[0] + one[0], sum[1] + one[1]]);
        let mut one_ways = self.one_ways.clone();
        one_ways.sort_unstable();
        one_ways.dedup();
        Self { capacities: vec![sum], from: self.from, one_ways }
    }
}

impl Bodies {
    fn run(&self, is_reversed: bool) -> Run {
        let of: Vec<_> =
            NAMES.iter().zip(self.inertias).map(|(name, inertia)| (*name, kg_m2(inertia))).collect();
        let mut model = Model::new(Mechanism::shafts(&of).unwrap());
        let points: Vec<(f64, f64)> =
            self.torques.iter().enumerate().map(|(place, torque)| (0.3 * place as f64, *torque)).collect();
        model.torque("engine", "a", TorqueLaw::over_time(table(&points))).unwrap();
        model.torque("load", "vehicle", constant(self.load)).unwrap();
        let shaft = Shaft::new(n_m(self.stiffness), angle(1.0)).unwrap();
        model
            .shaft("shaft", ["b", "vehicle"], shaft.damping(n_m(self.damping), omega(1.0)).unwrap())
            .unwrap();
        let mut elements: Vec<(usize, usize)> = (0..3)
            .flat_map(|group| {
                let one = &self.groups[group];
                (0..one.capacities.len() + one.one_ways.len()).map(move |place| (group, place))
            })
            .collect();
        if is_reversed {
            elements.reverse();
        }
        for (group, place) in elements {
            let (one, ends) = (&self.groups[group], ENDS[group].map(|end| NAMES[end]));
            let name = format!("{group}.{place}");
            match place.checked_sub(one.capacities.len()) {
                None => {
                    let [from, to] = one.capacities[place];
                    let ramp = table(&[(one.from, from), (one.from + 0.1, to)]);
                    model.friction(&name, ends, ramp, 1.0).unwrap();
                }
                Some(place) if one.one_ways[place] => {
                    model.one_way_clutch(&name, [ends[1], ends[0]]).unwrap();
                }
                Some(_) => model.one_way_clutch(&name, ends).unwrap(),
            }
        }
        model.run(&Start::at_rest(), s(END), None).unwrap_or_else(|error| panic!("{error}"))
    }

    /// Speeds at the end by steps of a fixed length: in each the impulses of all elements by projected
    /// Gauss–Seidel, which asks of none whether others hold the same.
    fn stepped(&self, steps: usize) -> [f64; 3] {
        let h = END / steps as f64;
        let mut speeds = [0.0; 3];
        let mut twist = 0.0;
        // Links, bounds of the impulse now, and the impulse.
        let mut elements: Vec<([usize; 2], usize, usize, f64)> = vec![];
        for (group, one) in self.groups.iter().enumerate() {
            for place in 0..one.capacities.len() + one.one_ways.len() {
                elements.push((ENDS[group], group, place, 0.0));
            }
        }
        let mobility = |link: usize| self.inertias.get(link).map_or(0.0, |inertia| 1.0 / inertia);
        for step in 0..steps {
            let t = (step as f64 + 0.5) * h;
            let at = (t / 0.3).min(2.999_999);
            let (before, part) = (at as usize, at - (at as usize) as f64);
            let engine = self.torques[before] + (self.torques[before + 1] - self.torques[before]) * part;
            let shaft = self.stiffness * twist + self.damping * (speeds[1] - speeds[2]);
            for (speed, (torque, inertia)) in
                speeds.iter_mut().zip([engine, -shaft, shaft + self.load].iter().zip(self.inertias))
            {
                *speed += h * torque / inertia;
            }
            let give = |speeds: &mut [f64; 3], ends: [usize; 2], impulse: f64| {
                for (end, impulse) in ends.into_iter().zip([impulse, -impulse]) {
                    if let Some(speed) = speeds.get_mut(end) {
                        *speed += impulse * mobility(end);
                    }
                }
            };
            elements.iter().for_each(|&(ends, _, _, impulse)| give(&mut speeds, ends, impulse));
            for _ in 0..400 {
                let mut change = 0.0_f64;
                for (ends, group, place, impulse) in &mut elements {
                    let one = &self.groups[*group];
                    let bounds = match place.checked_sub(one.capacities.len()) {
                        None => {
                            let most = h * one.capacity(one.capacities[*place], t);
                            [-most, most]
                        }
                        Some(place) if one.one_ways[place] => [f64::NEG_INFINITY, 0.0],
                        Some(_) => [0.0, f64::INFINITY],
                    };
                    let speed = |end: usize| speeds.get(end).copied().unwrap_or(0.0);
                    let slip = speed(ends[0]) - speed(ends[1]);
                    let next = (*impulse - slip / (mobility(ends[0]) + mobility(ends[1])))
                        .clamp(bounds[0], bounds[1]);
                    let step = next - *impulse;
                    change = change.max(step.abs());
                    *impulse = next;
                    give(&mut speeds, *ends, step);
                }
                if change < 1e-11 {
                    break;
                }
            }
            twist += h * (speeds[1] - speeds[2]);
        }
        speeds
    }
}

fn speeds_at_end(run: &Run) -> [f64; 3] {
    [0, 1, 2].map(|place| end_speed(run, NAMES[place]))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    /// Parallel elements move as one with their whole capacity, in any order, and as small steps with
    /// impulses do.
    #[test]
    fn elements_that_hold_the_same_links_have_one_motion(bodies in bodies()) {
        let run = bodies.run(false);
        prop_assert!(run.audit.residual().abs() < 1e-9, "{:e}", run.audit.residual());
        let found = speeds_at_end(&run);
        let scale = found.iter().fold(10.0_f64, |most, speed| most.max(speed.abs()));
        let merged = Bodies { groups: bodies.groups.each_ref().map(Group::merged), ..bodies.clone() };
        for (name, other) in [("reversed", bodies.run(true)), ("merged", merged.run(false))] {
            let other = speeds_at_end(&other);
            prop_assert!(
                found.iter().zip(other).all(|(one, other)| (one - other).abs() < 1e-8 * scale),
                "{name}: {found:?} {other:?}"
            );
        }
        let other = bodies.stepped(4000);
        prop_assert!(
            found.iter().zip(other).all(|(one, other)| (one - other).abs() < 1e-2 * scale),
            "stepped: {found:?} {other:?}"
        );
    }
}

/// Two sets that lock each other leave nothing to the clutches between their links: they carry nothing, and
/// all turns as a block.
#[test]
fn clutches_between_links_that_the_sets_lock_carry_nothing() {
    let loss = MeshLoss::Set(eta(0.96));
    let gearbox = Gearbox::builder("locked")
        .links(["n2", "n3", "n4"])
        .set(SetSpec::new("s0", SetKind::Bevel, ["n2", "n3", "n4"], 2.6).with_loss(loss))
        .set(SetSpec::simple("s1", ["n3", "n2", "n4"], 4.2).with_loss(loss))
        .clutch("c0", "n2", "n4")
        .one_way_clutch("c1", "n2", "n3")
        .input("n4")
        .output("n3")
        .build()
        .unwrap();
    let masses = Masses { links: links(&[("n2", 0.13), ("n3", 2.2), ("n4", 0.36)]), ..Masses::default() };
    let mut model = Model::new(Mechanism::of(&gearbox, &[], &masses).unwrap());
    model.shift_element("c0", level(286.0), 1.0).unwrap();
    model.torque("t", "n4", constant(10.0)).unwrap();
    let run = model.run(&start(&[("n4", 18.0)]), s(1.0), None).unwrap();
    close(end_speed(&run, "n3"), 18.0 + 10.0 / 2.69, 1e-12);
    assert!(run.audit.residual().abs() < 1e-12);
    assert!((0..2).all(|element| torque_of(run.end(), element).abs() < 1e-9));
}

/// Links without inertia are named, and giving one of them an inertia helps.
#[test]
fn links_without_inertia_are_named() {
    let gearbox = Gearbox::builder("two sets")
        .links(["in", "middle", "free", "out"])
        .set(SetSpec::simple("s0", ["in", "free", "middle"], 2.5))
        .set(SetSpec::simple("s1", ["middle", "free", "out"], 1.8))
        .brake("B", "free")
        .input("in")
        .output("out")
        .build()
        .unwrap();
    let of = |given: &[(&str, f64)]| {
        Mechanism::of(&gearbox, &[], &Masses { links: links(given), ..Masses::default() })
    };
    let Err(error) = of(&[("in", 0.2)]) else { panic!("one freedom has no inertia") };
    assert_eq!(
        error,
        Error::NoInertia { links: ["middle", "free", "out"].map(str::to_owned).into(), missing: 1 }
    );
    assert!(error.to_string().contains("give one of them an inertia"), "{error}");
    for link in ["middle", "free", "out"] {
        assert!(of(&[("in", 0.2), (link, 0.01)]).is_ok(), "{link}");
    }
    let Err(Error::NoInertia { links, missing: 2 }) = of(&[]) else { panic!("nothing has an inertia") };
    assert_eq!(links, ["in", "middle", "free", "out"]);
}

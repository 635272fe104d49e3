//! Laws that hold for any train, capacities and loads.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests, with data made to fit")]

use crate::common;

use common::{at, close, constant, eta, joules, kg_m2, level, n_m, omega, s, start, table};
use epicyclic_dynamics::equivalent_inertia::equivalent_inertia;
use epicyclic_dynamics::gearbox::{Masses, PlanetMass, PlanetMasses, moving_links};
use epicyclic_motion::{Change, Mechanism, Model, Run, Shaft, State, TorqueLaw};
use epicyclic_train::drag::{Beyond, DragCurve};
use epicyclic_train::set::{MeshLoss, SetKind, SetSpec};
use epicyclic_train::{GROUND, Gearbox};
use proptest::prelude::*;
use uom::si::angle::radian;
use uom::si::f64::{Angle, Length, Mass, MomentOfInertia};
use uom::si::length::meter;
use uom::si::mass::kilogram;
use uom::si::moment_of_inertia::kilogram_square_meter;

/// Two simple sets with planets: the carrier of the first with the ring of the second, and the first ring
/// with the second carrier; two freedoms, two brakes and a clutch.
#[derive(Debug, Clone)]
struct Train {
    teeth: [[u32; 2]; 2],
    efficiency: Option<f64>,
    inertias: [f64; 4],
    planet: f64,
}

const LINKS: [&str; 4] = ["in", "sun", "middle", "out"];

fn train() -> impl Strategy<Value = Train> {
    let set = || (12_u32..30, 8_u32..22).prop_map(|(sun, planet)| [sun, planet]);
    let inertia = || 0.01..1.0_f64;
    let inertias = [inertia(), inertia(), inertia(), inertia()];
    (set(), set(), prop::option::of(0.95..0.995_f64), inertias, 0.0..2e-4_f64).prop_map(
        |(one, two, efficiency, inertias, planet)| Train { teeth: [one, two], efficiency, inertias, planet },
    )
}

impl Train {
    /// Gearbox with links and sets renamed, and sets in the other order, or as they are.
    fn gearbox(&self, is_other: bool) -> Gearbox {
        let name = |link: &str| named(link, is_other);
        let loss = self.efficiency.map_or(MeshLoss::IDEAL, |one| MeshLoss::Set(eta(one)));
        let set = |place: usize, id: &str, members: [&str; 3]| {
            let [sun, planet] = self.teeth[place];
            let members = members.map(|link| if link == GROUND { link.to_owned() } else { name(link) });
            SetSpec::teeth(id, SetKind::Simple, members.each_ref().map(String::as_str), sun, sun + 2 * planet)
                .unwrap()
                .planet_teeth(planet.try_into().unwrap(), None)
                .with_loss(loss)
        };
        let first = set(0, "1", ["sun", "middle", "out"]);
        let second = set(1, "2", ["in", "out", "middle"]);
        let all = if is_other { [second, first] } else { [first, second] };
        let mut names: Vec<String> = LINKS.iter().map(|link| name(link)).collect();
        if is_other {
            names.reverse();
        }
        let [a, b] = all;
        Gearbox::builder("train")
            .links(names.iter().map(String::as_str))
            .set(a)
            .set(b)
            .brake("B1", &name("sun"))
            .brake("B2", &name("middle"))
            .clutch("C", &name("in"), &name("sun"))
            .input(&name("in"))
            .output(&name("out"))
            .gear("one", ["B1"])
            .build()
            .unwrap()
    }

    fn masses(&self, is_other: bool) -> Masses {
        let each = |radius: f64| PlanetMass {
            mass: Mass::new::<kilogram>(0.2),
            inertia: kg_m2(self.planet),
            radius: Length::new::<meter>(radius),
        };
        let planets =
            |set: &str, radius| (set.to_owned(), PlanetMasses { count: 3, each: vec![each(radius)] });
        let of_links =
            LINKS.iter().zip(self.inertias).map(|(link, inertia)| (named(link, is_other), kg_m2(inertia)));
        Masses { links: of_links.collect(), planets: vec![planets("1", 0.04), planets("2", 0.05)] }
    }
}

/// Net changes of the elements: each one's first and last state, in the order of their names; all other
/// changes as they are.
fn net(changes: &[Change]) -> Vec<String> {
    let mut elements: std::collections::BTreeMap<&str, [State; 2]> = std::collections::BTreeMap::new();
    let mut told = vec![];
    for change in changes {
        match change {
            Change::Element { name, from, to } => elements.entry(name).or_insert([*from, *to])[1] = *to,
            other => told.push(format!("{other:?}")),
        }
    }
    told.extend(elements.iter().filter(|(_, [from, to])| from != to).map(|one| format!("{one:?}")));
    told.sort();
    told
}

fn named(link: &str, is_other: bool) -> String {
    if is_other { format!("{link} of the other") } else { link.to_owned() }
}

/// Torques and elements that drive a train.
#[derive(Debug, Clone)]
struct Drive {
    capacities: [[f64; 2]; 3],
    times: [f64; 3],
    engine: f64,
    load: f64,
    drag: f64,
    speeds: [f64; 2],
}

fn drive() -> impl Strategy<Value = Drive> {
    let capacity = || [prop_oneof![Just(0.0), 1.0..300.0_f64], prop_oneof![Just(0.0), 1.0..300.0_f64]];
    let time = || 0.05..0.9_f64;
    (
        [capacity(), capacity(), capacity()],
        [time(), time(), time()],
        20.0..150.0_f64,
        1.0..120.0_f64,
        0.001..0.01_f64,
        [-100.0..200.0_f64, -50.0..100.0_f64],
    )
        .prop_map(|(capacities, times, engine, load, drag, speeds)| Drive {
            capacities,
            times,
            engine,
            load,
            drag,
            speeds,
        })
}

/// Drags of a train: torques at rest and at 100 rad/s, of two links and of two shift elements.
type Drags = [[f64; 2]; 4];

fn drags() -> impl Strategy<Value = Drags> {
    let torque = || prop_oneof![1 => Just(0.0), 3 => 0.1..20.0_f64];
    let curve = move || [torque(), torque()];
    [curve(), curve(), curve(), curve()]
}

/// A run; nothing where its losses leave the motion open.
fn run(train: &Train, drive: &Drive, is_other: bool) -> Option<Run> {
    run_with(train, drive, is_other, None)
}

fn run_with(train: &Train, drive: &Drive, is_other: bool, drags: Option<&Drags>) -> Option<Run> {
    let name = |link: &str| named(link, is_other);
    let mechanism = Mechanism::of(&train.gearbox(is_other), &[], &train.masses(is_other)).unwrap();
    let mut model = Model::new(mechanism);
    model.torque("engine", &name("in"), TorqueLaw::linear(n_m(drive.engine), omega(300.0)).unwrap()).unwrap();
    let quadratic = TorqueLaw::quadratic(n_m(drive.drag * 1e4), omega(100.0)).unwrap();
    model.torque("drag", &name("out"), quadratic).unwrap();
    let mut elements: Vec<usize> = (0..4).collect();
    if is_other {
        elements.reverse();
    }
    for element in elements {
        if element == 3 {
            model.resistance("load", &name("out"), n_m(drive.load)).unwrap();
            continue;
        }
        let ([from, to], begin) = (drive.capacities[element], drive.times[element]);
        let ramp = table(&[(begin, from), (begin + 0.1, to)]);
        model
            .shift_element(["B1", "B2", "C"][element], ramp, 1.0 + 0.2 * f64::from(u8::from(element == 2)))
            .unwrap();
    }
    for (place, [at_rest, turning]) in drags.into_iter().flatten().enumerate() {
        let points = [(omega(0.0), n_m(*at_rest)), (omega(100.0), n_m(*turning))];
        let curve = DragCurve::new(&points, Beyond::Constant).unwrap();
        match place {
            0 => model.drag("seal", [&name("in"), GROUND], &curve).unwrap(),
            1 => model.drag("bearing", [&name("out"), &name("middle")], &curve).unwrap(),
            2 => model.shift_drag("B1", &curve).unwrap(),
            _ => model.shift_drag("C", &curve).unwrap(),
        }
    }
    let [first, second] = drive.speeds;
    let begin = [(name("in"), first), (name("middle"), second)];
    let begin: Vec<(&str, f64)> = begin.iter().map(|(link, speed)| (link.as_str(), *speed)).collect();
    match model.run(&start(&begin), s(1.0), None) {
        Ok(run) => Some(run),
        Err(epicyclic_motion::Error::NotUnique { .. }) => None,
        // Losses alone: what mesh friction at rest holds beside stuck elements is open, and it may hold and
        // let go without end.
        Err(epicyclic_motion::Error::Accumulating { .. }) if train.efficiency.is_some() => None,
        Err(error) => panic!("{error}"),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, ..ProptestConfig::default() })]

    #[test]
    fn energies_balance(train in train(), drive in drive()) {
        if let Some(run) = run(&train, &drive, false) {
            prop_assert!(run.audit.residual().abs() < 1e-9, "{}", run.audit.residual());
            for heat in run.audit.heat.iter().chain(&run.audit.mesh_losses) {
                prop_assert!(joules(*heat) >= -1e-9 * joules(run.audit.before).max(joules(run.audit.after)));
            }
        }
    }

    /// Losses of drags are integrated by themselves, and are never below 0.
    #[test]
    fn energies_balance_with_drags(train in train(), drive in drive(), drags in drags(), rests in any::<bool>()) {
        let drive = if rests { Drive { speeds: [0.0, 0.0], ..drive } } else { drive };
        if let Some(run) = run_with(&train, &drive, false, Some(&drags)) {
            let scale = joules(run.audit.before).max(joules(run.audit.after));
            // Of what is held at rest there is nothing but rounding.
            let is_held = run.audit.work.iter().all(|work| joules(*work).abs() < 1e-12) && scale < 1e-12;
            prop_assert!(is_held || run.audit.residual().abs() < 1e-9, "{}", run.audit.residual());
            prop_assert_eq!(run.audit.drags.len(), 4);
            let scale = scale.max(1e-3);
            for loss in run.audit.drags.iter().chain(&run.audit.heat).chain(&run.audit.mesh_losses) {
                prop_assert!(joules(*loss) >= -1e-9 * scale);
            }
            // As much is lost by a drag up to each event as its torque took.
            for pair in run.events.windows(2) {
                for place in 0..4 {
                    let [one, next] = [&pair[0].after, &pair[1].before].map(|sample| joules(sample.drag_losses[place]));
                    prop_assert!(next >= one - 1e-9 * scale);
                }
            }
        }
    }

    #[test]
    fn names_and_order_change_nothing(train in train(), drive in drive()) {
        let (Some(one), Some(other)) = (run(&train, &drive, false), run(&train, &drive, true)) else {
            return Ok(());
        };
        let scale = LINKS.iter().fold(1.0_f64, |most, link| most.max(common::end_speed(&one, link).abs()));
        // How mesh friction at rest shares with stuck elements is open, and what holds first may depend on
        // the order.
        let is_set = |change: &Change| matches!(change, Change::Set { to: State::Stuck, .. });
        let rests = |run: &Run| run.events.iter().any(|event| event.changes.iter().any(is_set));
        let is_at_rest = train.efficiency.is_some() && drive.speeds == [0.0, 0.0];
        if rests(&one) || rests(&other) || is_at_rest {
            return Ok(());
        }
        for link in LINKS {
            let [found, due] = [common::end_speed(&other, &named(link, true)), common::end_speed(&one, link)];
            prop_assert!((found - due).abs() < 1e-9 * scale, "{link}: {found} {due}");
        }
        // What comes within a moment counts as one: a capacity that goes to 0 is exceeded by rounding just
        // before it is there.
        let told = |run: &Run| -> Vec<(f64, Vec<String>)> {
            let mut moments: Vec<(f64, Vec<Change>)> = vec![];
            for event in &run.events {
                let changes = event.changes.iter().cloned();
                match moments.last_mut() {
                    Some((time, all)) if at(event) - *time < 1e-7 => all.extend(changes),
                    _ => moments.push((at(event), changes.collect())),
                }
            }
            let all = moments.into_iter().map(|(time, changes)| (time, net(&changes)));
            all.filter(|(_, changes)| !changes.is_empty()).collect()
        };
        let (one, other) = (told(&one), told(&other));
        prop_assert_eq!(one.len(), other.len(), "{:?}\n{:?}", &one, &other);
        for (one, other) in one.iter().zip(&other) {
            prop_assert!((one.0 - other.0).abs() < 1e-7, "{one:?} {other:?}");
            prop_assert_eq!(&one.1, &other.1);
        }
    }

    #[test]
    fn inertia_and_energy_are_those_of_the_bodies(train in train(), speed in 1.0..300.0_f64) {
        let ideal = Train { efficiency: None, ..train };
        let gearbox = ideal.gearbox(false);
        let masses = ideal.masses(false);
        let mechanism = Mechanism::of(&gearbox, &["B1"], &masses).unwrap();
        let due = equivalent_inertia(&moving_links(&gearbox, "one", &masses).unwrap()).unwrap();
        let found = mechanism.equivalent_inertia("in").unwrap();
        close(found.get::<kilogram_square_meter>(), due.get::<kilogram_square_meter>(), 1e-12);
        let run = Model::new(mechanism).run(&start(&[("in", speed)]), s(0.1), None).unwrap();
        close(joules(run.audit.before), 0.5 * due.get::<kilogram_square_meter>() * speed * speed, 1e-12);
    }

    #[test]
    fn impacts_keep_the_momentum_of_what_stays_free(train in train(), speeds in [-100.0..200.0_f64, -50.0..100.0_f64]) {
        let ideal = Train { efficiency: None, ..train };
        let mechanism = Mechanism::of(&ideal.gearbox(false), &[], &ideal.masses(false)).unwrap();
        let masses: Vec<Vec<f64>> = mechanism
            .mass_matrix()
            .iter()
            .map(|row| row.iter().map(MomentOfInertia::get::<kilogram_square_meter>).collect())
            .collect();
        let coordinates: Vec<String> = mechanism.coordinates().iter().map(|&one| one.to_owned()).collect();
        let held = mechanism.speed_factors("sun").unwrap();
        let mut model = Model::new(mechanism);
        model.shift_dog_clutch("B1", &[(s(0.1), true)], None).unwrap();
        let run = model.run(&start(&[("in", speeds[0]), ("middle", speeds[1])]), s(0.2), None).unwrap();
        // M·q̇ along the motion that the brake leaves free.
        let free = [-held[1], held[0]];
        let momentum = |sample: &epicyclic_motion::Sample| -> f64 {
            let q: Vec<f64> = coordinates.iter().map(|link| common::speed(&run, sample, link)).collect();
            (0..2).map(|row| free[row] * (masses[row][0] * q[0] + masses[row][1] * q[1])).sum()
        };
        let size = (masses[0][0] + masses[1][1]) * libm::hypot(free[0], free[1]) * libm::hypot(speeds[0], speeds[1]) * 10.0;
        prop_assert!((momentum(run.end()) - momentum(&run.samples[0])).abs() < 1e-12 * size);
        prop_assert!(common::end_speed(&run, "sun").abs() < 1e-10);
        prop_assert!(joules(run.audit.impacts) >= 0.0 && run.audit.residual().abs() < 1e-12);
    }
}

/// Three bodies in a row with friction between them, and to the housing: what each does in a step of fixed
/// length.
///
/// All 27 combinations of stuck, forwards and backwards are tried by the velocities at the end of the step:
/// those of the elements that slip have their friction's direction, those that stick have no slip and a
/// torque within their capacity. Semi-implicit Euler, so of first order; it shares nothing with the library.
struct Plain {
    inertias: [f64; 3],
    capacities: [f64; 3],
    torque: [f64; 3],
}

/// Changes of an element that begins as `first`, without what lasts less than `brief`.
///
/// To a fixed step a short stop is a passage through 0, and a short slip between two stops may be nothing.
fn lasting(first: i8, changes: &[(f64, i8)], brief: f64) -> Vec<(f64, i8)> {
    let mut kept: Vec<(f64, i8)> = vec![];
    for &(t, way) in changes {
        let begins = match kept.last() {
            Some(&(last, _)) if t - last < brief => kept.pop().map_or(t, |(last, _)| last),
            _ => t,
        };
        if kept.last().map_or(first, |&(_, way)| way) != way {
            kept.push((begins, way));
        }
    }
    kept
}

#[test]
fn what_is_short_is_left_out_and_what_remains_alternates() {
    let all = [(1.0, 0), (1.001, -1), (1.5, 0), (2.0, 1), (2.001, 0), (3.0, 1)];
    assert_eq!(lasting(1, &all, 0.01), [(1.0, -1), (1.5, 0), (3.0, 1)]);
    assert_eq!(lasting(-1, &all, 0.01), [(1.5, 0), (3.0, 1)]);
}

/// Slips: 0–1, 1–2, 2–housing.
const ENDS: [[usize; 2]; 3] = [[0, 1], [1, 2], [2, 3]];

impl Plain {
    fn drive(&self, t: f64) -> f64 {
        self.torque[0] + self.torque[1] * libm::sin(self.torque[2] * t)
    }

    /// Speeds after a step, with what each element does in it.
    fn step(&self, speeds: [f64; 3], t: f64, h: f64) -> ([f64; 3], [i8; 3]) {
        let mut best = (f64::INFINITY, speeds, [0; 3]);
        for choice in 0..27 {
            let ways = [choice % 3 - 1, choice / 3 % 3 - 1, choice / 9 - 1].map(|one: i32| one as i8);
            // Impulses of what slips, then of what sticks by the groups of bodies that go together.
            let mut impulse = [h * self.drive(t + 0.5 * h), 0.0, 0.0];
            for (element, ends) in ENDS.iter().enumerate() {
                let torque = -f64::from(ways[element]) * self.capacities[element] * h;
                impulse[ends[0]] += torque;
                if ends[1] < 3 {
                    impulse[ends[1]] -= torque;
                }
            }
            let mut next = [0.0; 3];
            let mut from = 0;
            while from < 3 {
                let mut to = from;
                while to < 2 && ways[to] == 0 {
                    to += 1;
                }
                let is_held = to == 2 && ways[2] == 0;
                let inertia: f64 = self.inertias[from..=to].iter().sum();
                let momentum: f64 =
                    (from..=to).map(|body| self.inertias[body] * speeds[body] + impulse[body]).sum();
                next[from..=to].fill(if is_held { 0.0 } else { momentum / inertia });
                from = to + 1;
            }
            // What sticks carries what its bodies lack, from the free end on.
            let mut wrong = 0.0_f64;
            let mut carried = 0.0;
            for element in 0..3 {
                carried += self.inertias[element] * (next[element] - speeds[element]);
                let given: f64 = if element == 0 { h * self.drive(t + 0.5 * h) } else { 0.0 };
                carried -= given;
                // `carried` is the impulse of this element on the bodies before it.
                let after = if element < 2 { next[element + 1] } else { 0.0 };
                let slip = next[element] - after;
                if ways[element] == 0 {
                    wrong = wrong.max(carried.abs() / h - self.capacities[element]);
                } else {
                    wrong = wrong.max(-slip * f64::from(ways[element]));
                }
            }
            if wrong < best.0 {
                best = (wrong, next, ways);
            }
        }
        (best.1, best.2)
    }

    /// The exact run has the events of steps of a fixed length, and its speeds at the end.
    fn compare(&self, speeds: [f64; 3]) -> Result<(), TestCaseError> {
        let names = ["a", "b", "c"];
        let bodies: Vec<_> =
            names.iter().zip(self.inertias).map(|(name, inertia)| (*name, kg_m2(inertia))).collect();
        let mut model = Model::new(Mechanism::shafts(&bodies).unwrap());
        for (element, ends) in ENDS.iter().enumerate() {
            let second = names.get(ends[1]).copied().unwrap_or(GROUND);
            let name = ["ab", "bc", "c"][element];
            model.friction(name, [names[ends[0]], second], level(self.capacities[element]), 1.0).unwrap();
        }
        let sine = epicyclic_motion::Course::harmonic(
            n_m(self.torque[0]),
            n_m(self.torque[1]),
            omega(self.torque[2]),
            Angle::new::<radian>(0.0),
        );
        model.torque("drive", "a", TorqueLaw::over_time(sine.unwrap())).unwrap();
        let begin: Vec<_> = names.iter().zip(speeds).map(|(name, speed)| (*name, speed)).collect();
        let end = 3.0;
        let run = model.run(&start(&begin), s(end), None).unwrap();
        prop_assert!(run.audit.residual().abs() < 1e-9);

        let h = 2e-5;
        let begins = self.step(speeds, 0.0, h).1;
        let mut ways = begins;
        let mut now = speeds;
        let mut changes: Vec<(f64, usize, i8)> = vec![];
        for step in 0..(end / h) as usize {
            let t = step as f64 * h;
            let (next, found) = self.step(now, t, h);
            for element in 0..3 {
                if found[element] != ways[element] {
                    changes.push((t, element, found[element]));
                }
            }
            (now, ways) = (next, found);
        }
        // What happens in its first steps and its last it need not tell.
        let inside = |t: f64| t > 3.0 * h && t < end - 3.0 * h;
        for (element, &begin) in begins.iter().enumerate() {
            let first =
                changes.iter().rfind(|one| one.1 == element && one.0 <= 3.0 * h).map_or(begin, |one| one.2);
            let plain: Vec<(f64, i8)> = changes
                .iter()
                .filter(|one| one.1 == element && inside(one.0))
                .map(|one| (one.0, one.2))
                .collect();
            let exact: Vec<(f64, i8)> = run
                .events
                .iter()
                .flat_map(|event| event.changes.iter().map(move |change| (at(event), change)))
                .filter_map(|(t, change)| match change {
                    Change::Element { name, to, .. } if run.element(name) == Some(element) => {
                        let way = match to {
                            State::Forward => 1,
                            State::Backward => -1,
                            State::Stuck | State::Open => 0,
                        };
                        Some((t, way))
                    }
                    _ => None,
                })
                .filter(|one| inside(one.0))
                .collect();
            let (plain, exact) = (lasting(first, &plain, 3.0 * h), lasting(first, &exact, 3.0 * h));
            prop_assert_eq!(plain.len(), exact.len(), "{:?}\n{:?}", plain, exact);
            for (plain, exact) in plain.iter().zip(&exact) {
                prop_assert_eq!(plain.1, exact.1);
                prop_assert!((plain.0 - exact.0).abs() < 1e-3, "{plain:?} {exact:?}");
            }
        }
        for (body, name) in names.iter().enumerate() {
            prop_assert!((common::end_speed(&run, name) - now[body]).abs() < 1e-2);
        }
        Ok(())
    }
}

/// `ab` slips for 8 µs between two stops.
#[test]
fn a_short_slip_is_no_fault() {
    let plain = Plain {
        inertias: [0.8564547106707396, 0.42244580127808756, 1.2220908790303864],
        capacities: [13.460181635118028, 7.243501164831747, 5.407074828438725],
        torque: [2.6328137508129568, 32.52793212957558, 7.487401305069891],
    };
    plain.compare([3.371830228147468, -6.0500691623740686, -0.6260557833906225]).unwrap();
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 8, ..ProptestConfig::default() })]

    #[test]
    fn stick_and_slip_have_as_many_events_as_a_fine_fixed_step(
        inertias in [0.3..2.0_f64, 0.3..2.0_f64, 0.3..2.0_f64],
        capacities in [2.0..20.0_f64, 2.0..20.0_f64, 0.5..10.0_f64],
        torque in [-6.0..6.0_f64, 5.0..40.0_f64, 2.0..9.0_f64],
        speeds in [-10.0..10.0_f64, -10.0..10.0_f64, -10.0..10.0_f64],
    ) {
        Plain { inertias, capacities, torque }.compare(speeds)?;
    }

    #[test]
    fn energies_balance_with_shafts_and_dog_clutches(
        train in train(),
        stiffness in 50.0..5000.0_f64,
        damping in prop_oneof![Just(0.0), 0.1..5.0_f64],
        backlash in prop_oneof![Just(0.0), 0.001..0.1_f64],
        torque in -60.0..60.0_f64,
        speeds in [-50.0..100.0_f64, -50.0..100.0_f64, -50.0..100.0_f64],
        engaged in 0.1..0.4_f64,
    ) {
        let mechanism = Mechanism::of(&train.gearbox(false), &[], &train.masses(false)).unwrap();
        let mut model = Model::new(mechanism.with_body("vehicle", kg_m2(3.0)).unwrap());
        let shaft = Shaft::new(n_m(stiffness), Angle::new::<radian>(1.0)).unwrap();
        let shaft = shaft.damping(n_m(damping), omega(1.0)).unwrap().backlash(Angle::new::<radian>(backlash)).unwrap();
        model.shaft("shaft", ["out", "vehicle"], shaft).unwrap();
        model.torque("motor", "in", constant(torque)).unwrap();
        model.resistance("load", "vehicle", n_m(20.0)).unwrap();
        model.shift_dog_clutch("B2", &[(s(engaged), true), (s(0.6), false)], None).unwrap();
        model.shift_element("C", table(&[(0.2, 0.0), (0.5, 80.0)]), 1.1).unwrap();
        let begin = start(&[("in", speeds[0]), ("middle", speeds[1]), ("vehicle", speeds[2])]);
        match model.run(&begin, s(0.8), None) {
            Ok(run) => {
                prop_assert!(run.audit.residual().abs() < 1e-9, "{}", run.audit.residual());
                prop_assert!(joules(run.audit.impacts) > 0.0);
                prop_assert!(joules(run.audit.damping[0]) >= 0.0);
            }
            Err(error) => prop_assert!(matches!(error, epicyclic_motion::Error::NotUnique { .. }), "{error}"),
        }
    }
}
/// Two splits of stuck torques at once, one of them without spare capacity: the other is not to grow, for
/// what is nothing is measured by the largest torque.
#[test]
fn a_drag_that_shares_at_rest_leaves_mesh_losses_as_they_are() {
    let train = Train {
        teeth: [[18, 12], [20, 8]],
        efficiency: Some(0.95),
        inertias: [0.893_384, 0.933_446, 0.01, 0.01],
        planet: 0.0,
    };
    let drive = Drive {
        capacities: [[118.777_544, 0.0], [1.0, 0.0], [120.713_364, 0.0]],
        times: [0.491_136, 0.05, 0.795_774],
        engine: 107.199_491,
        load: 5.493_180,
        drag: 0.001,
        speeds: [0.0, 0.0],
    };
    let drags = [[0.0, 0.0], [12.052_444, 0.0], [0.0, 0.0], [0.0, 0.0]];
    let run = run_with(&train, &drive, false, Some(&drags)).unwrap();
    assert!(run.audit.mesh_losses.iter().all(|loss| joules(*loss) > 0.0), "{:?}", run.audit.mesh_losses);
    assert!(run.audit.residual().abs() < 1e-9);
}

/// At one moment everything is at rest, in a block by a clutch that holds 1.2 times the torque that it
/// carries slipping. The load turns, and the clutch need not release. A sticking load and a slipping clutch
/// would agree with all torques, too, but nothing makes the clutch release.
#[test]
fn what_is_stuck_lets_go_only_where_it_must() {
    let train = Train {
        teeth: [[18, 16], [21, 8]],
        efficiency: None,
        inertias: [0.942_688_474_021_092_7, 0.01, 0.793_287_527_456_203_1, 0.953_923_444_526_418_3],
        planet: 0.0,
    };
    let drive = Drive {
        capacities: [[0.0, 0.0], [0.0, 0.0], [256.065_658_749_275_6, 54.768_889_228_143_21]],
        times: [0.05; 3],
        engine: 130.172_254_258_377_82,
        load: 116.758_807_513_595_8,
        drag: 0.001,
        speeds: [0.0, -46.587_712_478_578_67],
    };
    for is_other in [false, true] {
        let run = run(&train, &drive, is_other).unwrap();
        let [.., last] = &run.events[..] else { panic!("no event") };
        let is_load = |change: &Change| {
            let way = (State::Backward, State::Forward);
            matches!(change, Change::Element { name, from, to } if name == "load" && (*from, *to) == way)
        };
        assert!(last.changes.len() == 1 && is_load(&last.changes[0]), "{:?}", last.changes);
        for link in LINKS {
            close(common::end_speed(&run, &named(link, is_other)), 2.727_024_530_566_075, 1e-12);
        }
    }
}

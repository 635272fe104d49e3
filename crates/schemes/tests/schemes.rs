//! The two- and three-speed schemes: closed forms of ratio and efficiency equal the solver.
//!
//! Source: multispeed-gearboxes, sections 2.3 and 2.4, efficiencies as restored there.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_train::set::{MeshLoss, SetSpec};
use epicyclic_train::{Gearbox, State};
use proptest::prelude::*;

/// Closed form of `(k1, k2, η₀)`.
type Closed = fn(f64, f64, f64) -> f64;

struct Scheme {
    name: &'static str,
    /// Links of a₁ b₁ H₁ and of a₂ b₂ H₂.
    sets: [&'static str; 2],
    ratio: Closed,
    efficiency: Closed,
}

/// The first gear of I, II, III.
const SINGLE: [Scheme; 3] = [
    Scheme {
        name: "I",
        sets: ["D T1 B", ""],
        ratio: |k, _, _| 1.0 + k,
        efficiency: |k, _, e| (1.0 + k * e) / (1.0 + k),
    },
    Scheme {
        name: "II",
        sets: ["T1 D B", ""],
        ratio: |k, _, _| (1.0 + k) / k,
        efficiency: |k, _, e| (k + e) / (1.0 + k),
    },
    Scheme { name: "III", sets: ["D B T1", ""], ratio: |k, _, _| -k, efficiency: |_, _, e| e },
];

/// The second gear of I-1…III-3, brake T₂.
const DOUBLE: [Scheme; 11] = [
    Scheme {
        name: "I-1",
        sets: ["D T1 B", "D T2 T1"],
        ratio: |k, l, _| (k + 1.0) * (l + 1.0) / (k + l + 1.0),
        efficiency: |k, l, e| {
            (k * e + 1.0) * (l * e + 1.0) * (k + l + 1.0) / ((k + 1.0) * (l + 1.0) * (k * e + l * e + 1.0))
        },
    },
    Scheme {
        name: "I-2",
        sets: ["D T1 B", "T2 D T1"],
        ratio: |k, l, _| (k + 1.0) * (l + 1.0) / (l * (k + 1.0) + 1.0),
        efficiency: |k, l, e| {
            (k * e + 1.0) * (l + e) * (l * (k + 1.0) + 1.0)
                / ((k + 1.0) * (l + 1.0) * (l * (k * e + 1.0) + e))
        },
    },
    Scheme {
        name: "I-3",
        sets: ["D T1 B", "B T1 T2"],
        ratio: |k, l, _| (l * (k + 1.0) + k) / l,
        efficiency: |k, l, e| (l * (k * e + 1.0) + k * e * e) / (l * (k + 1.0) + k),
    },
    Scheme {
        name: "I-4",
        sets: ["D T1 B", "T1 B T2"],
        ratio: |k, l, _| k * (l + 1.0) + 1.0,
        efficiency: |k, l, e| (k * (l * e + 1.0) * e + 1.0) / (k * (l + 1.0) + 1.0),
    },
    Scheme {
        name: "II-1",
        sets: ["T1 D B", "D T2 T1"],
        ratio: |k, l, _| (k + 1.0) * (l + 1.0) / (k * (l + 1.0) + 1.0),
        efficiency: |k, l, e| {
            (k + e) * (l * e + 1.0) * (k * (l + 1.0) + 1.0)
                / ((k + 1.0) * (l + 1.0) * (k * (l * e + 1.0) + e))
        },
    },
    Scheme {
        name: "II-2",
        sets: ["T1 D B", "T2 D T1"],
        ratio: |k, l, _| (k + 1.0) * (l + 1.0) / ((k + 1.0) * (l + 1.0) - 1.0),
        efficiency: |k, l, e| {
            (k + e) * (l + e) * (k * (l + 1.0) + l) / ((k + 1.0) * (l + 1.0) * (k * (l + e) + l * e))
        },
    },
    Scheme {
        name: "II-3",
        sets: ["T1 D B", "T1 B T2"],
        ratio: |k, l, _| (k + l + 1.0) / k,
        efficiency: |k, l, e| (k + (l * e + 1.0) * e) / (k + l + 1.0),
    },
    Scheme {
        name: "II-4",
        sets: ["T1 D B", "B T1 T2"],
        ratio: |k, l, _| (l * (k + 1.0) + 1.0) / (k * l),
        efficiency: |k, l, e| (l * (k + e) + e * e) / (l * (k + 1.0) + 1.0),
    },
    Scheme {
        name: "III-1",
        sets: ["D B T1", "D T1 T2"],
        ratio: |k, l, _| -k * l / (k + l + 1.0),
        efficiency: |k, l, e| e * e * (k + l + 1.0) / ((k + l) * e + 1.0),
    },
    Scheme {
        name: "III-2",
        sets: ["D B T1", "T1 B T2"],
        ratio: |k, l, _| -(k * (l + 1.0) + l),
        efficiency: |k, l, e| (k * (l * e + 1.0) + l) * e / (k * (l + 1.0) + l),
    },
    Scheme {
        name: "III-3",
        sets: ["D B T1", "B T1 T2"],
        ratio: |k, l, _| -(k * (l + 1.0) + 1.0) / l,
        efficiency: |k, l, e| (k * (l + e) + 1.0) * e / (k * (l + 1.0) + 1.0),
    },
];

fn build(scheme: &Scheme, k: [f64; 2], eta: f64) -> Gearbox {
    let loss = MeshLoss::Set(MeshEfficiency::new(eta).unwrap());
    let mut builder = Gearbox::builder(scheme.name)
        .links(["D", "B", "T1", "T2"])
        .brake("K1", "T1")
        .clutch("direct", "D", "B")
        .input("D")
        .output("B")
        .gear("1", ["K1"])
        .gear("direct", ["direct"]);
    for (set, (members, k)) in scheme.sets.iter().zip(k).enumerate() {
        let members: Vec<&str> = members.split_whitespace().collect();
        if let [a, b, h] = members[..] {
            builder = builder.set(SetSpec::simple(&set.to_string(), [a, b, h], k).with_loss(loss));
        }
    }
    if !scheme.sets[1].is_empty() {
        builder = builder.brake("K2", "T2").gear("2", ["K2"]);
    }
    builder.build().unwrap()
}

fn holds(scheme: &Scheme, gear: &str, k: f64, l: f64, eta: f64) {
    let gearbox = build(scheme, [k, l], eta);
    let found = gearbox.analyze(gear).unwrap();
    assert_eq!(*found.state(), State::Driven, "{}", scheme.name);
    let close = |found: f64, closed: f64, what: &str| {
        let off = (found - closed).abs() / closed.abs().max(1.0);
        assert!(off < 1e-12, "{} {what} k1 = {k} k2 = {l}: {found}, closed form {closed}", scheme.name);
    };
    close(found.ratio().unwrap(), (scheme.ratio)(k, l, eta), "i");
    let closed = (scheme.efficiency)(k, l, eta);
    close(found.efficiency().unwrap(), closed, "η");
    let kreines = found.kreines().unwrap();
    close(kreines.efficiency, closed, "η by Kreines");
    assert!(kreines.reversed.is_empty());
    // The power balance once more, from members alone.
    let case = found.driving().unwrap();
    let lost: f64 = case.power.sets.iter().map(|set| set.as_ref().unwrap().members.iter().sum::<f64>()).sum();
    assert!((1.0 - lost - closed).abs() < 1e-12 * case.power.largest);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn single_set_schemes_follow_their_closed_forms(k in 1.3..10.0, eta in 0.9..1.0) {
        for scheme in &SINGLE {
            holds(scheme, "1", k, 2.0, eta);
        }
    }

    #[test]
    fn two_set_schemes_follow_their_closed_forms(k in 1.3..10.0, l in 1.3..10.0, eta in 0.9..1.0) {
        for scheme in &DOUBLE {
            holds(scheme, "2", k, l, eta);
        }
    }

    #[test]
    fn direct_drive_turns_as_a_block_without_loss(k in 1.3..10.0, l in 1.3..10.0, eta in 0.9..1.0) {
        for scheme in SINGLE.iter().chain(&DOUBLE) {
            let gearbox = build(scheme, [k, l], eta);
            let found = gearbox.analyze("direct").unwrap();
            prop_assert!(found.state().has_ratio());
            prop_assert_eq!(found.ratio(), Some(1.0));
            for (link, speed) in gearbox.links().iter().zip(found.speeds()).skip(1) {
                if link != "T2" || !scheme.sets[1].is_empty() {
                    prop_assert!((speed.unwrap() - 1.0).abs() < 1e-12, "{} {}", scheme.name, link);
                }
            }
            if let Some(eta) = found.efficiency() {
                prop_assert!((eta - 1.0).abs() < 1e-12);
            }
        }
    }
}

#[test]
fn the_scheme_of_the_excavator_wheel_turns_as_table_3_2_says() {
    let scheme = DOUBLE.iter().find(|scheme| scheme.name == "II-3").unwrap();
    let gearbox = build(scheme, [2.15, 2.35], 0.97);
    let found = gearbox.analyze("2").unwrap();
    let speed = |link: &str| found.speed(gearbox.link(link).unwrap()).unwrap();
    // a₁ −0.92, H₁ 0.39, g₁ 2.67, g₂ 1.36.
    assert!((speed("T1") - -0.92).abs() < 0.005 && (speed("B") - 0.39).abs() < 0.005);
    let planets = [0, 1].map(|set| found.sets()[set].planets[0].unwrap());
    assert!((planets[0].absolute.unwrap() - 2.67).abs() < 0.005);
    assert!((planets[1].absolute.unwrap() - 1.36).abs() < 0.005);
    // The objection of the reading: planet 1 exceeds 2·ω_D relative to its carrier.
    assert!((planets[0].relative - 2.28).abs() < 0.005);
}

/// Fig. 1.14 a: b₁ and H₁ of a differential tied by an ordinary train b₂-g₂-a₂ with H₂ at rest.
#[test]
fn a_differential_connected_by_an_ordinary_train_has_one_ratio() {
    let (k, l) = (3.0, 2.5);
    let gearbox = Gearbox::builder("Fig. 1.14 a")
        .links(["a1", "b1", "H1", "H2"])
        .set(SetSpec::simple("1", ["a1", "b1", "H1"], k))
        .set(SetSpec::simple("2", ["b1", "H1", "H2"], l))
        .ground("H2")
        .input("a1")
        .output("H1")
        .gear("connected", [""; 0])
        .build()
        .unwrap();
    // a₂ is b₁, b₂ is H₁: ω_b1 = −l·ω_H1, so i = 1 + k + k·l.
    let found = gearbox.analyze("connected").unwrap();
    assert!((found.ratio().unwrap() - (1.0 + k + k * l)).abs() < 1e-13);
    assert!(found.ideal().unwrap().power.circulating.abs() < 1e-12);
}

/// Fig. 1.14 b: b₁ and H₁ tied by a simple planetary gear with sun a₂ at rest.
#[test]
fn a_differential_connected_by_a_planetary_set_has_one_ratio() {
    let (k, l) = (3.0, 2.5);
    let connected_by = |ring: &str, carrier: &str| {
        Gearbox::builder("Fig. 1.14 b")
            .links(["a1", "b1", "H1", "a2"])
            .set(SetSpec::simple("1", ["a1", "b1", "H1"], k))
            .set(SetSpec::simple("2", ["a2", ring, carrier], l))
            .ground("a2")
            .input("a1")
            .output("H1")
            .gear("connected", [""; 0])
            .build()
            .unwrap()
    };
    // b₂ is H₁, H₂ is b₁: ω_b1 = ω_H1·l/(1 + l).
    let gearbox = connected_by("H1", "b1");
    let found = gearbox.analyze("connected").unwrap();
    assert!((found.ratio().unwrap() - (1.0 + k - k * l / (1.0 + l))).abs() < 1e-13);
    // b₂ is b₁, H₂ is H₁: ω_b1 = ω_H1·(1 + l)/l, and the ratio falls to 1 − k/l: power circulates.
    let gearbox = connected_by("b1", "H1");
    let found = gearbox.analyze("connected").unwrap();
    let i = 1.0 + k - k * (1.0 + l) / l;
    assert!((found.ratio().unwrap() - i).abs() < 1e-13);
    // The ring takes T_b·ω_b = k·(1 + l)/l/i of power out of set 1 or into it: |1.2·3.5/…| by hand.
    let through_ring = (k * (1.0 + l) / l / i).abs();
    let ideal = found.ideal().unwrap();
    assert!((ideal.power.sets[0].as_ref().unwrap().members[1].abs() - through_ring).abs() < 1e-11);
    assert!(ideal.power.circulating > 1.0);
    // One loop, from the ring of one set to that of the other and back by the carriers; nothing of it in the suns.
    let loop_power = ideal.power.circulating;
    for set in 0..2 {
        let [sun, ring, carrier] = [0, 1, 2].map(|member| ideal.power.circulating_member(set, member));
        assert!(
            sun.abs() < 1e-12 && (ring.abs() - loop_power).abs() < 1e-11 && (carrier + ring).abs() < 1e-11
        );
    }
}

//! The two- and three-speed schemes: closed forms of ratio and efficiency equal the solver, Kreines' rule and
//! the balance of powers. The document's own formulas are held against both in the cases of
//! multispeed-gearboxes (`schemes.printed_formula`), as text that another library evaluates.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::simple_set::RingToSunRatio;
use epicyclic_schemes::catalogue::{Scheme, ThreeSpeed, TwoSpeed};
use epicyclic_train::set::SetSpec;
use epicyclic_train::{Gearbox, State};
use proptest::prelude::*;

/// The gearbox of a scheme; of one set `l` does not count.
fn build(scheme: Scheme, k: f64, l: f64, eta: f64) -> Gearbox {
    let ([k, l], eta0) = ([k, l].map(|k| RingToSunRatio::new(k).unwrap()), MeshEfficiency::new(eta).unwrap());
    match scheme {
        Scheme::Two(scheme) => scheme.gearbox(k, eta0).unwrap(),
        Scheme::Three(scheme) => scheme.gearbox(k, l, eta0).unwrap(),
    }
}

fn holds(scheme: Scheme, gear: &str, k: f64, l: f64, eta: f64) {
    let gearbox = build(scheme, k, l, eta);
    let found = gearbox.analyze(gear).unwrap();
    assert_eq!(*found.state(), State::Driven, "{scheme}");
    let close = |found: f64, closed: f64, what: &str| {
        let off = (found - closed).abs() / closed.abs().max(1.0);
        assert!(off < 1e-12, "{scheme} {what} k1 = {k} k2 = {l}: {found}, closed form {closed}");
    };
    close(found.ratio().unwrap(), scheme.ratio_formula().value(k, l, eta), "i");
    let closed = scheme.efficiency_formula().value(k, l, eta);
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
        for scheme in TwoSpeed::ALL {
            holds(scheme.into(), "1", k, 2.0, eta);
        }
    }

    #[test]
    fn two_set_schemes_follow_their_closed_forms(k in 1.3..10.0, l in 1.3..10.0, eta in 0.9..1.0) {
        for scheme in ThreeSpeed::ALL {
            holds(scheme.into(), "2", k, l, eta);
        }
    }

    #[test]
    fn direct_drive_turns_as_a_block_without_loss(k in 1.3..10.0, l in 1.3..10.0, eta in 0.9..1.0) {
        for scheme in Scheme::all() {
            let gearbox = build(scheme, k, l, eta);
            let found = gearbox.analyze("direct").unwrap();
            prop_assert!(found.state().has_ratio());
            prop_assert_eq!(found.ratio(), Some(1.0));
            for (link, speed) in gearbox.links().iter().zip(found.speeds()).skip(1) {
                prop_assert!((speed.unwrap() - 1.0).abs() < 1e-12, "{} {}", scheme, link);
            }
            if let Some(eta) = found.efficiency() {
                prop_assert!((eta - 1.0).abs() < 1e-12);
            }
        }
    }
}

#[test]
fn the_scheme_of_the_excavator_wheel_turns_as_table_3_2_says() {
    let gearbox = build(ThreeSpeed::II3.into(), 2.15, 2.35, 0.97);
    let found = gearbox.analyze("2").unwrap();
    let speed = |link: &str| found.speed(gearbox.link(link).unwrap()).unwrap();
    // a₁ −0.92, H₁ 0.39, g₁ 2.67, g₂ 1.36.
    assert!((speed("T1") - -0.92).abs() < 0.005 && (speed("B") - 0.39).abs() < 0.005);
    let planets = [0, 1].map(|set| found.sets()[set].planets[0].unwrap());
    assert!((planets[0].speed.unwrap() - 2.67).abs() < 0.005);
    assert!((planets[1].speed.unwrap() - 1.36).abs() < 0.005);
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
    // One loop, from the ring of one set to that of the other and back by the carriers; nothing of it in the
    // suns.
    let loop_power = ideal.power.circulating;
    for set in 0..2 {
        let [sun, ring, carrier] = [0, 1, 2].map(|member| ideal.power.circulating_member(set, member));
        assert!(
            sun.abs() < 1e-12 && (ring.abs() - loop_power).abs() < 1e-11 && (carrier + ring).abs() < 1e-11
        );
    }
}

//! Sweeps over basic ratios against an analysis of the gearbox described with them.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use crate::common;

use common::machines::ravigneaux_set;
use common::oracle::Dice;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_train::set::{MeshLoss, SetKind, SetSpec};
use epicyclic_train::sweep::{StateName, Sweep, Swept};
use epicyclic_train::{Error, Gearbox};
use std::collections::BTreeMap;

const KINDS: [SetKind; 5] =
    [SetKind::Simple, SetKind::Simple, SetKind::DoublePlanet, SetKind::MeshingSuns, SetKind::ExternalPair];

/// A gearbox whose basic ratios come later.
struct Plan {
    links: usize,
    sets: Vec<(SetKind, [usize; 3], f64)>,
    elements: Vec<[usize; 2]>,
    gears: Vec<Vec<usize>>,
    terminals: [usize; 2],
}

fn name(link: usize) -> String {
    if link == 0 { "ground".into() } else { format!("n{link}") }
}

impl Plan {
    fn random(dice: &mut Dice) -> Self {
        let count = 1 + dice.below(4);
        let links = count + 1 + dice.below(3);
        let set = |dice: &mut Dice| {
            let kind = KINDS[dice.below(KINDS.len())];
            let mut members: Vec<usize> = (0..=links).collect();
            dice.shuffle(&mut members);
            let carrier = if kind == SetKind::ExternalPair { 0 } else { members[2] };
            let eta = if dice.chance(20) { 1.0 } else { dice.eta() };
            (kind, [members[0], members[1], carrier], eta)
        };
        let sets = (0..count).map(|_| set(dice)).collect();
        let element = |dice: &mut Dice| [dice.below(links + 1), dice.below(links + 1)];
        let elements: Vec<[usize; 2]> = (0..4).map(|_| element(dice)).collect();
        let gears = (0..3).map(|_| (0..4).filter(|_| dice.chance(40)).collect()).collect();
        Self { links, sets, elements, gears, terminals: [1 + dice.below(links), 1 + dice.below(links)] }
    }

    fn build(&self, k: &[f64]) -> Result<Gearbox, Error> {
        let mut builder = Gearbox::builder("random").links((1..=self.links).map(name));
        for (place, ((kind, members, eta), &k)) in self.sets.iter().zip(k).enumerate() {
            let members = members.map(name);
            let loss = MeshLoss::Set(MeshEfficiency::new(*eta).unwrap());
            let members = [members[0].as_str(), &members[1], &members[2]];
            builder = builder.set(SetSpec::new(&place.to_string(), *kind, members, k).with_loss(loss));
        }
        for (place, [first, second]) in self.elements.iter().enumerate() {
            builder = builder.clutch(&format!("K{place}"), &name(*first), &name(*second));
        }
        for (place, engaged) in self.gears.iter().enumerate() {
            builder = builder.gear(&place.to_string(), engaged.iter().map(|one| format!("K{one}")));
        }
        let [input, output] = self.terminals;
        builder.input(&name(input)).output(&name(output)).build()
    }

    /// Many of them numbers at which equations may depend on each other, or near ones at which a gear locks
    /// itself.
    fn k(&self, dice: &mut Dice) -> Vec<f64> {
        let one = |kind: SetKind, dice: &mut Dice| match (kind, dice.below(3)) {
            (SetKind::Simple, 0) => 2.0,
            (SetKind::Simple, 1) => f64::from(dice.between(2, 8)) / 1.5,
            (SetKind::Simple, _) => f64::from(dice.between(1_001, 5_000)) / 1000.0,
            (_, 0) => [0.5, 0.98, 1.0, 1.015, 2.0][dice.below(5)],
            (_, _) => f64::from(dice.between(200, 5_000)) / 1000.0,
        };
        self.sets.iter().map(|(kind, ..)| one(*kind, dice)).collect()
    }
}

fn analysed(gearbox: &Gearbox) -> Vec<Swept> {
    let of = |gear| {
        let found = gearbox.analyze_gear(gear).unwrap();
        Swept { state: StateName::from(found.state()), ratio: found.ratio(), efficiency: found.efficiency() }
    };
    gearbox.gears().iter().map(of).collect()
}

fn near(one: Option<f64>, other: Option<f64>) -> bool {
    match (one, other) {
        (Some(one), Some(other)) => (one - other).abs() <= 1e-10 * other.abs().max(1.0),
        (None, None) => true,
        _ => false,
    }
}

#[test]
fn every_variant_is_what_an_analysis_says_of_the_gearbox_described_with_it() {
    let mut dice = Dice(20);
    let mut seen: BTreeMap<StateName, usize> = BTreeMap::new();
    for _ in 0..4000 {
        let plan = Plan::random(&mut dice);
        let Ok(first) = plan.build(&plan.k(&mut dice)) else { continue };
        let ids: Vec<String> = (0..plan.sets.len()).map(|set| set.to_string()).collect();
        let ids: Vec<&str> = ids.iter().map(String::as_str).collect();
        let mut sweep = Sweep::new(&first, first.gears(), &ids).unwrap();
        let mut found = vec![];
        for _ in 0..6 {
            let k = plan.k(&mut dice);
            sweep.solve(&k, &mut found).unwrap();
            let due = analysed(&plan.build(&k).unwrap());
            for (one, due) in found.iter().zip(&due) {
                assert_eq!(one.state, due.state, "{k:?} of {:?}", plan.sets);
                assert!(near(one.ratio, due.ratio), "{one:?} {due:?}");
                assert!(near(one.efficiency, due.efficiency), "{one:?} {due:?}");
                *seen.entry(one.state).or_default() += 1;
            }
        }
    }
    // Every state has been met, and more than rarely.
    assert_eq!(seen.len(), 7, "{seen:?}");
    assert!(seen.values().all(|&count| count > 20), "{seen:?}");
}

fn scheme() -> Gearbox {
    Gearbox::builder("II-3")
        .links(["D", "B", "T1", "T2"])
        .set(SetSpec::simple("1", ["T1", "D", "B"], 2.15))
        .set(SetSpec::simple("2", ["T1", "B", "T2"], 2.354))
        .brake("K1", "T1")
        .brake("K2", "T2")
        .input("D")
        .output("B")
        .gear("1", ["K1"])
        .gear("2", ["K2"])
        .build()
        .unwrap()
}

#[test]
fn a_set_that_does_not_vary_keeps_its_ratio() {
    let gearbox = scheme();
    let mut sweep = Sweep::new(&gearbox, gearbox.gears(), &["2"]).unwrap();
    let mut found = vec![];
    sweep.solve(&[3.0], &mut found).unwrap();
    let due = [(1.0 + 2.15) / 2.15, (1.0 + 2.15 + 3.0) / 2.15];
    for (one, due) in found.iter().zip(due) {
        assert!((one.ratio.unwrap() - due).abs() < 1e-12, "{one:?}");
    }
}

#[test]
fn what_cannot_vary_is_refused() {
    let gearbox = scheme();
    let refused = |sets: &[&str]| Sweep::new(&gearbox, gearbox.gears(), sets).unwrap_err().name();
    assert_eq!(refused(&["3"]), "unknown");
    assert_eq!(refused(&["1", "1"]), "varied-twice");
    let mut sweep = Sweep::new(&gearbox, gearbox.gears(), &["1", "2"]).unwrap();
    let mut found = vec![];
    let mut refused = |k: &[f64]| sweep.solve(k, &mut found).unwrap_err().name();
    assert_eq!(refused(&[2.0]), "value-count");
    for k in [1.0, 0.0, -2.0, 1e10, f64::INFINITY, f64::NAN] {
        assert_eq!(refused(&[2.0, k]), "ring-to-sun-ratio", "{k}");
    }
}

#[test]
fn a_set_described_gear_by_gear_does_not_vary() {
    let gearbox = ravigneaux_set([1.0; 4]).build().unwrap();
    let refused = Sweep::new(&gearbox, gearbox.gears(), &["RAV"]).unwrap_err();
    assert_eq!(refused.name(), "not-varied");
}

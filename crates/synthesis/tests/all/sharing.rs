//! Sets that share planets, against compound sets written by hand, against the trial of tooth numbers, and by
//! what separate sets would lose.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests, which clippy does not know for such"
)]

use crate::common::Random;
use epicyclic_gears::ToothCount;
use epicyclic_gears::double_planet::DoublePlanetNumbers;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::synthesis::Bounds;
use epicyclic_synthesis::gearbox::{gearbox, own_names, solver_name};
use epicyclic_synthesis::motion::{Element, elements};
use epicyclic_synthesis::sharing::{Obstacle, Sharing};
use epicyclic_synthesis::structure::{HOUSING, INPUT, Link, OUTPUT};
use epicyclic_synthesis::{Class, Kind, Structure, enumerate};
use epicyclic_train::compound::CompoundSpec;
use epicyclic_train::set::SetSpec;
use epicyclic_train::{Analysis, Gearbox};

const ETA: f64 = 0.97;

fn eta() -> MeshEfficiency {
    MeshEfficiency::new(ETA).unwrap()
}

fn each() -> MeshEfficiency {
    MeshEfficiency::new(ETA.sqrt()).unwrap()
}

fn close(one: Option<f64>, other: Option<f64>) -> bool {
    match (one, other) {
        (Some(one), Some(other)) => (one - other).abs() < 1e-9 * (1.0 + one.abs()),
        (None, None) => true,
        _ => false,
    }
}

fn circulating(analysis: &Analysis<'_>) -> Option<f64> {
    analysis.driving().map(|load| load.power.circulating)
}

/// The 6HP of `0-1-a b-2-c d-2-c*` with a Ravigneaux set by hand: suns 38 and 31, ring 85; before it 37 and
/// 71.
fn six_hp() -> Gearbox {
    let rear = CompoundSpec::new("rear", "c")
        .sun("b", 38)
        .sun("d", 31)
        .ring("out", 85)
        .planet("short", &[])
        .planet("long", &[])
        .mesh("d", "short", each())
        .mesh("short", "long", each())
        .mesh("b", "long", each())
        .mesh("long", "out", each());
    let front = SetSpec::simple("front", [epicyclic_train::GROUND, "in", "a"], 71.0 / 37.0);
    let builder = Gearbox::builder("6HP").links(["in", "out", "a", "b", "c", "d"]).compound_set(rear);
    let builder = builder.set(front.with_loss(epicyclic_train::set::MeshLoss::Set(eta())));
    let builder = builder.brake("C", "b").brake("D", "c").clutch("A", "a", "d").clutch("B", "a", "b");
    let gears = [("1", ["A", "D"]), ("2", ["A", "C"]), ("3", ["A", "B"]), ("4", ["A", "E"])];
    let others = [("5", ["B", "E"]), ("6", ["C", "E"]), ("7", ["B", "D"])];
    let builder = builder.clutch("E", "in", "c").input("in").output("out");
    gears
        .into_iter()
        .chain(others)
        .fold(builder, |builder, (name, engaged)| builder.gear(name, engaged))
        .build()
        .unwrap()
}

#[test]
fn a_6hp_is_rated_as_its_ravigneaux_set() {
    let structure: Structure = "0-1-a b-2-c d-2-c*".parse().unwrap();
    let k = [71.0 / 37.0, 85.0 / 38.0, 85.0 / 31.0 - 1.0];
    let sharing = Sharing::of(&structure, &k);
    assert_eq!(sharing.compounds.iter().map(|one| one.sets.clone()).collect::<Vec<_>>(), [[1, 2]]);
    // 3 is a, 4 b, 5 c, 6 d.
    let all: [Element; 5] = [[0, 4], [0, 5], [3, 6], [3, 4], [1, 5]];
    let engaged = [[2, 1], [2, 0], [2, 3], [2, 4], [3, 4], [0, 4], [3, 1]].map(|of| of.to_vec());
    let found = gearbox(&structure, &k, eta(), &all, &engaged).unwrap();
    let by_hand = six_hp();
    for (one, other) in found.gears().iter().zip(by_hand.gears()) {
        let (one, other) = (found.analyze_gear(one).unwrap(), by_hand.analyze_gear(other).unwrap());
        assert!(close(one.ratio(), other.ratio()) && close(one.efficiency(), other.efficiency()));
        assert!(close(circulating(&one), circulating(&other)));
    }
    let second = found.analyze("2").unwrap();
    assert!((second.efficiency().unwrap() - 0.9654).abs() < 5e-5 && circulating(&second).unwrap() < 1e-9);
}

/// Whether two sets have a carrier in common, and a sun, and a ring.
fn common(structure: &Structure, [one, other]: [usize; 2]) -> [bool; 3] {
    let (one, other) = (structure.members(one), structure.members(other));
    [one[2] == other[2], one[0] == other[0], one[1] == other[1]]
}

/// The gearbox with the two last sets as one set by hand: a simple set and a double-planet set with this
/// ring, or this sun, in common.
fn by_hand(structure: &Structure, teeth: [u32; 3], used: &[Element]) -> Gearbox {
    let name = |link: Link| solver_name(link);
    let [sun, ring, carrier] = structure.members(1).map(name);
    let [other_sun, other_ring, _] = structure.members(2).map(name);
    let spec = CompoundSpec::new("both", &carrier).planet("p", &[]).planet("q", &[]);
    let [_, has_sun, _] = common(structure, [1, 2]);
    let spec = if has_sun {
        // sun – p – ring, p – q – other ring
        let [sun_teeth, ring_teeth, other_teeth] = teeth;
        let spec = spec.sun(&sun, sun_teeth).ring(&ring, ring_teeth).ring(&other_ring, other_teeth);
        let spec = spec.mesh(&sun, "p", each()).mesh("p", &ring, each());
        spec.mesh("p", "q", each()).mesh("q", &other_ring, each())
    } else {
        // sun – p – ring, other sun – q – p
        let [ring_teeth, sun_teeth, other_teeth] = teeth;
        let spec = spec.ring(&ring, ring_teeth).sun(&sun, sun_teeth).sun(&other_sun, other_teeth);
        let spec = spec.mesh(&sun, "p", each()).mesh("p", &ring, each());
        spec.mesh(&other_sun, "q", each()).mesh("q", "p", each())
    };
    let links = (1..=structure.links()).map(|link| name(Link::try_from(link).unwrap()));
    let first = structure.members(0).map(name);
    let front = SetSpec::simple("first", first.each_ref().map(String::as_str), 2.0);
    let mut builder = Gearbox::builder("by hand").links(links).compound_set(spec);
    builder = builder.set(front.with_loss(epicyclic_train::set::MeshLoss::Set(eta())));
    for (name, pair) in own_names(used).iter().zip(used) {
        builder = match *pair {
            [HOUSING, link] => builder.brake(name, &solver_name(link)),
            [one, other] => builder.clutch(name, &solver_name(one), &solver_name(other)),
        };
    }
    let builder = builder.input(&solver_name(INPUT)).output(&solver_name(OUTPUT));
    builder.gear("1", own_names(used)).build().unwrap()
}

/// Random structures of three sets, the last a double-planet set on one carrier with the second, with a sun
/// or a ring in common.
#[test]
fn planted_compound_sets_are_rated_as_sets_written_by_hand() {
    let class = Class::new(Kind::AllSparse, 3, 6).unwrap();
    let planted: Vec<Structure> = enumerate::all(class)
        .iter()
        .flat_map(|structure| structure.with_double_planets(1))
        .filter(|structure| {
            let [carrier, sun, ring] = common(structure, [1, 2]);
            carrier && (sun || ring)
        })
        .collect();
    assert!(planted.len() > 100, "{}", planted.len());
    let mut random = Random(0x1234_5678_9abc_def1);
    let all = elements(class.links());
    let (mut driven, mut differ) = (0, 0);
    for _ in 0..3000 {
        let structure = &planted[random.below(planted.len())];
        let [_, has_sun, _] = common(structure, [1, 2]);
        // The sun of the double-planet set is the smaller one, its ring the larger one.
        let (teeth, k) = if has_sun {
            let sun = 20 + 2 * random.below(10) as u32;
            let ring = 2 * sun + 2 * random.below(20) as u32;
            let other = ring + 8 + random.below(20) as u32;
            let over = f64::from(sun);
            ([sun, ring, other], [2.0, f64::from(ring) / over, f64::from(other) / over - 1.0])
        } else {
            let ring = 70 + 2 * random.below(20) as u32;
            let sun = 30 + 2 * random.below(8) as u32;
            let other = sun - 8 + random.below(3) as u32;
            let of = f64::from(ring);
            ([ring, sun, other], [2.0, of / f64::from(sun), of / f64::from(other) - 1.0])
        };
        let sharing = Sharing::of(structure, &k);
        if sharing.compounds.len() != 1 || sharing.compounds[0].sets != [1, 2] {
            // A third set may share planets with one of the two; or there is no room.
            continue;
        }
        let (one, other) = (random.below(all.len()), random.below(all.len()));
        if one == other {
            continue;
        }
        let used = [all[one.min(other)], all[one.max(other)]];
        let found = gearbox(structure, &k, eta(), &used, &[vec![0, 1]]).unwrap();
        assert_eq!(found.sets().len(), 2, "{structure}");
        let by_hand = by_hand(structure, teeth, &used);
        let (one, other) = (found.analyze("1").unwrap(), by_hand.analyze("1").unwrap());
        let same = close(one.ratio(), other.ratio()) && close(one.efficiency(), other.efficiency());
        assert!(
            same && close(circulating(&one), circulating(&other)),
            "{structure} {used:?} {teeth:?}: {:?} {:?}, {:?} {:?}",
            one.ratio(),
            one.efficiency(),
            other.ratio(),
            other.efficiency()
        );
        driven += usize::from(one.efficiency().is_some_and(|of| of < 1.0));
        differ += usize::from(circulating(&one).is_some_and(|of| of > 0.0));
    }
    assert!(driven > 300 && differ > 30, "{driven} {differ}");
}

#[test]
fn sets_that_leave_no_room_or_need_steps_are_apart() {
    let why = |structure: &str, k: &[f64]| {
        let sharing = Sharing::of(&structure.parse().unwrap(), k);
        assert!(sharing.compounds.len() + sharing.apart.len() <= 1, "{sharing:?}");
        sharing.apart.first().map(|apart| apart.why)
    };
    // A ring in common: the planet of the simple set would run into the larger sun of the double-planet set,
    // also into one as large.
    assert_eq!(why("1-2-a b-2-a*", &[2.2, 2.8 - 1.0]), None);
    assert_eq!(why("1-2-a b-2-a*", &[2.8, 2.2 - 1.0]), Some(Obstacle::Room));
    assert_eq!(why("1-2-a b-2-a*", &[2.2, 2.2 - 1.0]), Some(Obstacle::Room));
    // Two simple sets.
    assert_eq!(why("1-2-a b-2-a", &[2.2, 2.8]), Some(Obstacle::Steps));
    assert_eq!(why("1-2-a 1-b-a", &[2.2, 2.8]), Some(Obstacle::Steps));
    // A carrier alone, a link that is a sun here and a ring there: nothing in common.
    let none = Sharing::of(&"1-2-a b-1-a*".parse().unwrap(), &[2.2, 1.8]);
    assert_eq!(none, Sharing::default());
}

/// Sets that fit together by their tooth numbers are not reported as apart.
#[test]
fn every_ravigneaux_set_that_fits_by_trial_is_one_set() {
    let structure: Structure = "1-2-a b-2-a*".parse().unwrap();
    let bounds = Bounds { planets: 3..=3, sun: 20..=50, ring: 60..=100, ..Bounds::default() };
    let simple = bounds.tooth_numbers().unwrap();
    let count = |teeth: u32| ToothCount::new(teeth).unwrap();
    let mut tried = 0;
    for set in simple.iter().step_by(7) {
        for sun in (14..set.sun.get()).filter(|sun| (set.ring.get() - sun).is_multiple_of(3)) {
            let fits = |inner: u32| {
                let teeth = DoublePlanetNumbers {
                    sun: count(sun),
                    inner: count(inner),
                    outer: set.planet,
                    ring: set.ring,
                    pairs: 3,
                };
                teeth.fits(&BasicRack::default(), 0.0)
            };
            if (12..set.ring.get() / 2).any(fits) {
                let k = [set.ring_to_sun_ratio(), set.ring.as_f64() / f64::from(sun) - 1.0];
                assert_eq!(Sharing::of(&structure, &k).compounds.len(), 1, "{set:?} {sun}");
                tried += 1;
            }
        }
    }
    assert!(tried > 100, "{tried}");
}

//! Tooth checks of sets by hand, and against a trial of every placement.

use super::*;
use crate::compound::CompoundSpec;
use crate::set::{SetKind, SetSpec};
use crate::{Gearbox, GearboxBuilder};
use epicyclic_gears::ToothCount;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::involute::check::Severity;

fn start() -> GearboxBuilder {
    Gearbox::builder("one set").links(["a", "b", "c", "H"]).input("a").output("H")
}

fn short(kind: SetKind, sun: u32, ring: u32, planets: &[u32]) -> SetSpec {
    let set = SetSpec::teeth("P", kind, ["a", "b", "H"], sun, ring).unwrap();
    let teeth = |place: usize| planets.get(place).map(|&count| ToothCount::new(count).unwrap());
    match teeth(0) {
        Some(first) => set.planet_teeth(first, teeth(1)),
        None => set,
    }
}

fn found(set: SetSpec) -> Vec<String> {
    let gearbox = start().set(set).build().unwrap();
    gearbox.tooth_checks(&BasicRack::default())
}

fn of(kind: SetKind, sun: u32, ring: u32, planets: &[u32]) -> u64 {
    start().set(short(kind, sun, ring, planets)).build().unwrap().sets[0].assembly_positions().unwrap()
}

#[test]
fn the_slots_of_the_usual_sets_are_the_known_ones() {
    assert_eq!(of(SetKind::Simple, 20, 61, &[]), 81);
    assert_eq!(of(SetKind::DoublePlanet, 30, 72, &[]), 42);
    assert_eq!(of(SetKind::MeshingSuns, 30, 36, &[18, 20]), 66);
    assert_eq!(of(SetKind::Bevel, 20, 30, &[]), 50);
    // (20·24 + 80·36)/12, (20·24 − 30·36)/12 in size, and likewise of two rings.
    assert_eq!(of(SetKind::SteppedSunRing, 20, 80, &[36, 24]), 280);
    assert_eq!(of(SetKind::SteppedSuns, 20, 30, &[36, 24]), 50);
    assert_eq!(of(SetKind::SteppedRings, 100, 90, &[36, 24]), 70);
}

/// Two conditions at once: z_s + z_l of the suns through both planets, z_l + z_r of the long planet.
#[test]
fn a_ravigneaux_set_has_the_slots_of_all_its_central_gears() {
    let eta = MeshEfficiency::IDEAL;
    let set = |ring: u32| {
        CompoundSpec::new("R", "H")
            .sun("a", 30)
            .sun("b", 36)
            .ring("c", ring)
            .planet("short", &[18])
            .planet("long", &[18])
            .mesh("a", "short", eta)
            .mesh("short", "long", eta)
            .mesh("b", "long", eta)
            .mesh("long", "c", eta)
            .planet_count(5)
    };
    let gearbox = start().compound_set(set(72)).build().unwrap();
    // 66, 108, 42: gcd 6.
    assert_eq!(gearbox.sets[0].assembly_positions(), Some(6));
    assert_eq!(
        gearbox.tooth_checks(&BasicRack::default()),
        [
            "set `R`: the tips of the ring are taken 0.108 modules shorter than its basic rack has them, since full ones reach below the base \
             circle of the long: cut the blank so",
            "set `R`: 5 planets of each kind do not clear: tip circles of short and the next long \
             overlap by 5.986 modules; at most 4 clear",
            "set `R`: 5 planets cannot be assembled at equal angles: their number must divide 6; 3 would do",
        ]
    );
    let all = gearbox.set_checks(&BasicRack::default(), |_| vec![]).checks;
    let planes = all.iter().find(|check| check.rule == "planes").unwrap();
    assert_eq!(planes.severity, Severity::Remark);
    assert!(planes.value < -0.1 && planes.unit == "modules", "{planes:?}");
    assert_eq!(
        planes.miss.as_deref(),
        Some("short and sun b must lie in different planes: their tip circles overlap")
    );
    let gearbox = start().compound_set(set(73)).build().unwrap();
    assert_eq!(
        gearbox.tooth_checks(&BasicRack::default())[1],
        "set `R`: long (18 teeth) is 27 modules from the axis by the sun b (36 teeth) and 27.5 by the ring \
         (73 teeth): equal centre distances need shifted profiles"
    );
}

#[test]
fn every_fault_of_a_simple_set_is_told() {
    assert_eq!(
        found(short(SetKind::Simple, 30, 67, &[])),
        [
            "set `P`: 30 and 67 teeth of sun and ring leave the planets (z_b − z_a)/2 = 18.5 teeth: a whole number \
          needs shifted profiles"
        ]
    );
    assert_eq!(
        found(short(SetKind::Simple, 12, 72, &[]).planet_count(8)),
        [
            "set `P`: the sun is undercut: x = 0.0000, at least 0.2981 needed",
            "set `P`: the tip circles of neighbours among 8 planets are -16.656 modules apart, more than 0 needed; at most 3 clear",
            "set `P`: 8 planets cannot be assembled at equal angles: their number must divide 84; 3 would do",
        ]
    );
    assert_eq!(found(short(SetKind::Simple, 24, 72, &[24]).planet_count(4)), [""; 0]);
    assert_eq!(
        found(short(SetKind::SteppedSunRing, 20, 40, &[36, 41])),
        ["set `P`: ring (40 teeth) is not larger than the planet 2 (41 teeth) in it"]
    );
    // A double planet whose ring is too far out for planets so small.
    assert_eq!(
        found(short(SetKind::DoublePlanet, 20, 120, &[20, 20])),
        [
            "set `P`: planet 1 and planet 2 cannot mesh: their centres, 20.0000 and 50.0000 modules from the axis, \
          cannot stand 20.0000 modules apart"
        ]
    );
}

/// A planet of 40 teeth at 20° in a ring with few teeth more, whose tips are shortened to stay out of the
/// fillets: in a ring of 41 the planet encloses the tips of the ring. The condition is tested where it is
/// made.
#[test]
fn a_ring_with_few_teeth_more_meets_the_tips_of_its_planet() {
    let check = |ring: u32| {
        let gearbox = start().set(short(SetKind::SteppedRings, 100, ring, &[30, 40])).build().unwrap();
        let all = gearbox.set_checks(&BasicRack::default(), |_| vec![]).checks;
        let own = |check: &&SetCheck| {
            check.rule == "trochoidal-interference"
                && check.subject == Subject::Mesh("planet 2".into(), "ring 2".into())
        };
        all.iter().find(own).unwrap().clone()
    };
    assert_eq!(check(41).value, f64::NEG_INFINITY);
    assert!(check(41).miss.unwrap().ends_with("so that teeth always meet"));
    for ring in [42, 43, 44] {
        assert!(
            check(ring).miss.unwrap().contains("overlap after they have left the line of action"),
            "{ring}"
        );
    }
    assert_eq!(check(49).miss, None);
}

/// Modules that are stated of both meshes of a stepped planet, and of one.
#[test]
fn steps_of_a_planet_share_a_centre_distance() {
    let found = |ring: u32, step: u32, modules: [Option<f64>; 2]| {
        let gearbox = start().set(short(SetKind::SteppedSunRing, 20, ring, &[20, step])).build().unwrap();
        let all = gearbox.set_checks(&BasicRack::default(), |_| modules.to_vec()).checks;
        let steps = all
            .into_iter()
            .filter(|check| ["step-module", "step-centre-distance", "across-axis"].contains(&check.rule));
        steps.map(|check| (check.rule, check.severity, check.value)).collect::<Vec<_>>()
    };
    // 20 and 25 modules: not with one module, but with 1 and 0.8 mm.
    assert_eq!(found(80, 30, [Some(1.0), Some(1.0)]), [("step-centre-distance", Severity::Error, 5.0)]);
    assert_eq!(found(80, 30, [Some(1.0), Some(0.8)]), []);
    assert_eq!(found(80, 30, [Some(1.0), None]), [("step-module", Severity::Warning, 0.8)]);
    assert_eq!(found(80, 30, [None, None]), [("step-module", Severity::Remark, 0.8)]);
    // A step as large as the centre distance.
    assert_eq!(found(80, 40, [Some(1.0), None]), [("across-axis", Severity::Error, 1.0)]);
}

#[test]
fn whether_planets_fit_is_said_only_where_it_is_known() {
    let fit = |set: SetSpec| {
        let gearbox = start().set(set).build().unwrap();
        let fit = gearbox.sets()[0].planet_fit(&BasicRack::default());
        (fit.assembles, fit.clears)
    };
    let set = || short(SetKind::Simple, 24, 72, &[]);
    assert_eq!(fit(set()), (None, None));
    assert_eq!(fit(set().planet_count(4)), (Some(true), Some(true)));
    assert_eq!(fit(set().planet_count(7)), (Some(false), Some(false)));
    assert_eq!(fit(set().planet_count(1)), (Some(true), Some(true)));
    assert_eq!(fit(SetSpec::simple("P", ["a", "b", "H"], 3.0).planet_count(3)), (None, None));
    // Planets of which one has no teeth stand nowhere.
    assert_eq!(fit(short(SetKind::DoublePlanet, 30, 72, &[]).planet_count(3)), (Some(true), None));
    // Bevel planets have no tip circles round the axis.
    assert_eq!(fit(short(SetKind::Bevel, 20, 20, &[]).planet_count(2)), (Some(true), None));
}

#[test]
fn a_pair_has_the_checks_of_its_mesh() {
    let pair = |pinion, ring| {
        SetSpec::teeth("F", SetKind::InternalPair, ["a", "b", "ground"], pinion, ring).unwrap()
    };
    let found = |set: SetSpec| {
        let gearbox = start().set(set).set(short(SetKind::Simple, 24, 72, &[24])).build().unwrap();
        let words = gearbox.tooth_checks(&BasicRack::default());
        words.into_iter().filter(|word| word.starts_with("set `F`")).collect::<Vec<_>>()
    };
    let fouls = found(pair(40, 44));
    assert!(
        fouls.iter().any(|word| word.contains("overlap after they have left the line of action")),
        "{fouls:?}"
    );
    assert_eq!(found(pair(24, 72)), [""; 0]);
    let undercut = found(pair(14, 60));
    assert!(undercut.iter().any(|word| word.contains("is undercut: x = 0.0000")), "{undercut:?}");
}

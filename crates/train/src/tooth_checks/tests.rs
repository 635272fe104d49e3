//! Tooth checks of sets by hand, and against a trial of every placement.

use super::*;
use crate::compound::CompoundSpec;
use crate::set::{SetKind, SetSpec};
use crate::units::degrees;
use crate::{Gearbox, GearboxBuilder};
use epicyclic_gears::ToothCount;
use epicyclic_gears::efficiency::MeshEfficiency;

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
    gearbox.tooth_checks(&BasicRack::default()).iter().map(ToothWarning::to_string).collect()
}

fn of(kind: SetKind, sun: u32, ring: u32, planets: &[u32]) -> u128 {
    slots(&start().set(short(kind, sun, ring, planets)).build().unwrap().sets[0]).unwrap()
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
    assert_eq!(slots(&gearbox.sets[0]), Some(6));
    let all = gearbox.tooth_checks(&BasicRack::default());
    let words: Vec<String> = all.iter().map(ToothWarning::to_string).collect();
    assert_eq!(
        words,
        [
            "set `R`: 5 planets of each kind do not clear: tip circles of short and the next long \
             overlap by 5.986 modules; at most 4 clear",
            "set `R`: 5 planets cannot be assembled at equal angles: their number must divide 6; 3 would do",
            "set `R`: short and sun b must lie in different planes: their tip circles overlap",
        ]
    );
    assert_eq!(all.iter().map(ToothWarning::is_note).collect::<Vec<_>>(), [false, false, true]);
    let gearbox = start().compound_set(set(73)).build().unwrap();
    assert_eq!(
        gearbox.tooth_checks(&BasicRack::default())[0].to_string(),
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
            "set `P`: 8 planets do not clear each other: tip circles of neighbours (planet) overlap by 15.927 \
             modules; at most 3 clear",
            "set `P`: 8 planets cannot be assembled at equal angles: their number must divide 84; 3 would do",
            "set `P`: undercut without profile shift, below 17 teeth: sun (12 teeth)",
        ]
    );
    assert_eq!(
        found(short(SetKind::Simple, 1, 3, &[1]).planet_count(50)),
        [
            "set `P`: 50 planets do not clear each other: tip circles of neighbours (planet) overlap by 2.874 \
             modules; not even 2 clear",
            "set `P`: 50 planets cannot be assembled at equal angles: their number must divide 4",
            "set `P`: undercut without profile shift, below 17 teeth: sun (1 tooth), planet (1 tooth)",
        ]
    );
    // (2 + 36)·sin 90° = 36 + 2: two planets around a sun of two teeth touch.
    assert_eq!(
        found(short(SetKind::Simple, 2, 74, &[]).planet_count(2))[0],
        "set `P`: 2 planets do not clear each other: tip circles of neighbours (planet) touch; not even 2 clear"
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

/// A planet of 40 teeth at 20°: its tips are free in rings of 9 teeth more, not of 8. The condition is tested where it is made.
#[test]
fn a_ring_with_few_teeth_more_meets_the_tips_of_its_planet() {
    let set = |ring| short(SetKind::SteppedRings, 100, ring, &[30, 40]);
    let words =
        |set| found(set).into_iter().filter(|word| word.contains("tips of planet")).collect::<Vec<_>>();
    assert_eq!(
        words(set(46)),
        [
            "set `P`: tips of planet 2 (40 teeth) and ring 2 (46 teeth) meet outside the mesh without profile shift; from 49 teeth of \
             the ring on they are free"
        ]
    );
    assert_eq!([48, 49].map(|ring| words(set(ring)).len()), [1, 0]);
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
fn a_pair_is_only_held_against_undercut() {
    let pair = SetSpec::teeth("F", SetKind::InternalPair, ["a", "b", "ground"], 14, 15).unwrap();
    let gearbox = start().set(pair).set(short(SetKind::Simple, 24, 72, &[])).build().unwrap();
    let form = BasicRack::default();
    let words: Vec<String> = gearbox.tooth_checks(&form).iter().map(ToothWarning::to_string).collect();
    assert_eq!(words, ["set `F`: undercut without profile shift, below 17 teeth: sun (14 teeth)"]);
    // 2/sin²25° = 11.2.
    let steep = BasicRack { pressure_angle: degrees(25.0), ..BasicRack::default() };
    assert_eq!(gearbox.tooth_checks(&steep), []);
}

//! Selection for the examples of section 3.3: what the document found, what it missed, what it got wrong.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_schemes::RatioSeries;
use epicyclic_schemes::catalogue::{Scheme, SchemeElement, TwoSpeed};
use epicyclic_schemes::standing::Standing;
use epicyclic_schemes::structures::{Family, Role, Structure};
use epicyclic_selection::{
    Candidate, Criterion, Evidence, Mechanism, NotDrawable, Objective, Order, Requirements, Selection, Space,
    select, select_with,
};
use uom::si::f64::Velocity;
use uom::si::velocity::meter_per_second;

fn requirements(speeds: &[f64]) -> Requirements {
    let speeds: Vec<Velocity> = speeds.iter().map(|v| Velocity::new::<meter_per_second>(*v)).collect();
    Requirements::new(RatioSeries::of_speeds(&speeds, 1).unwrap())
}

fn excavator() -> Requirements {
    requirements(&[0.76, 1.33, 1.95])
}

fn all(found: &Selection) -> impl Iterator<Item = &Candidate> {
    found.accepted.iter().chain(&found.rejected)
}

fn scheme<'a>(found: &'a Selection, name: &str) -> Vec<&'a Candidate> {
    all(found)
        .filter(|candidate| candidate.mechanism.scheme().is_some_and(|scheme| scheme.name() == name))
        .collect()
}

fn objections(candidate: &Candidate) -> Vec<Criterion> {
    candidate.objections().map(|verdict| verdict.criterion).collect()
}

#[test]
fn the_conveyor_takes_scheme_i() {
    let found = select(&requirements(&[0.8, 3.15]), &Space::Catalogue).unwrap();
    let names: Vec<_> = found.best.iter().map(|&place| found.accepted[place].mechanism.scheme()).collect();
    assert_eq!(names, [TwoSpeed::I, TwoSpeed::III].map(|scheme| Some(Scheme::Two(scheme))));
    let best = &found.accepted[found.best[0]];
    assert!((best.objectives.efficiency - (1.0 + 2.9375 * 0.9702) / 3.9375).abs() < 1e-12);
    // Scheme II reaches 2 at most: unreachable, and it says which k it would need.
    let refused =
        found.unreachable.iter().find(|u| u.mechanism.scheme() == Some(Scheme::Two(TwoSpeed::II))).unwrap();
    assert!((refused.needed.as_ref().unwrap()[0] - 1.0 / 2.9375).abs() < 1e-12, "{refused:?}");
}

#[test]
fn the_excavator_wheel_has_the_documents_two_and_the_objections_to_both() {
    let found = select(&excavator(), &Space::Catalogue).unwrap();
    let [ii_3] = scheme(&found, "II-3")[..] else { unreachable!("one order of ratios fits II-3") };
    assert!((ii_3.k[0] - 2.145).abs() < 1e-3 && (ii_3.k[1] - 2.359).abs() < 2e-3, "{:?}", ii_3.k);
    assert_eq!(objections(ii_3), [Criterion::PlanetSpeed]);
    let planets = ii_3.objections().next().unwrap();
    assert!((planets.value - 2.28).abs() < 0.01, "{planets:?}");
    assert!(found.rejected.contains(ii_3));

    let iii_1 = scheme(&found, "III-1")[0];
    assert!((iii_1.k[0] - 2.566).abs() < 1e-3 && (iii_1.k[1] - 4.754).abs() < 1e-3, "{:?}", iii_1.k);
    assert_eq!(objections(iii_1), [Criterion::SameDirection]);
    assert!(iii_1.mixes_directions() && found.accepted.contains(iii_1));
    assert!(iii_1.objectives.speed < 1.56 && (iii_1.objectives.efficiency - 0.9666).abs() < 1e-4);

    let mut strict = excavator();
    strict.limits.same_direction = true;
    let found = select(&strict, &Space::Catalogue).unwrap();
    assert!(scheme(&found, "III-1")[0].objections().all(|verdict| verdict.required));
    assert!(found.accepted.is_empty());
}

#[test]
fn the_document_rounds_its_ratios_and_gets_k_of_2_15_2_35_and_4_76() {
    let mut rounded = Requirements::new(RatioSeries::of_braked_gears(&[1.465, 2.56]).unwrap());
    rounded.eta0 = MeshEfficiency::new(0.97).unwrap();
    let found = select(&rounded, &Space::Catalogue).unwrap();
    let [ii_3] = scheme(&found, "II-3")[..] else { unreachable!("one order of ratios fits II-3") };
    assert!((ii_3.k[0] - 2.15).abs() < 1e-3 && (ii_3.k[1] - 2.3548).abs() < 1e-3);
    assert!((ii_3.gears[1].efficiency.unwrap() - 0.969).abs() < 5e-4);
    let iii_1 = scheme(&found, "III-1")[0];
    assert!((iii_1.k[1] - 4.76).abs() < 5e-3);
    assert!((iii_1.gears[1].efficiency.unwrap() - 0.9664).abs() < 1e-4);
}

#[test]
fn the_document_missed_a_structure_of_both_sets_with_positive_ratios_and_more_than_98_per_cent() {
    use Role::{B, D, T1, T2};
    let found = select(&excavator(), &Space::All).unwrap();
    let missed: Vec<&Candidate> = all(&found)
        .filter(|candidate| {
            let Mechanism::TwoSets(structure) = candidate.mechanism else { return false };
            structure.scheme().is_none()
                && structure.family() != Family::Parallel
                && candidate.gears.iter().all(|gear| gear.ratio > 0.0 && gear.efficiency.unwrap() > 0.98)
                && candidate.k.iter().all(|k| (1.3..=10.0).contains(k))
        })
        .collect();
    let [best] = missed[..] else { unreachable!("one: {missed:?}") };
    let structure = Structure::new([[D, T1, B], [T2, B, T1]]).unwrap();
    assert_eq!(best.mechanism, Mechanism::TwoSets(structure));
    assert!(Standing::of(structure, &(1.3..=10.0)).is_missed());
    // Scheme I in gear 1, k₁ = d − 1; gear 2 by (2.37) with i_c = k₂/(1 + k₂).
    assert!((best.k[0] - (1.95 / 0.76 - 1.0)).abs() < 1e-12 && (best.k[1] - 2.359).abs() < 1e-3);
    let etas: Vec<f64> = best.gears.iter().map(|gear| gear.efficiency.unwrap()).collect();
    assert!((etas[0] - 0.98181).abs() < 1e-5 && etas[1] > 0.98, "{etas:?}");
    // Its planets turn at 2.16 times the input's speed at the exact ratios; within the tolerance there
    // are teeth that keep to 2: see the search. Of its input three quarters circulate in one of its gears.
    assert_eq!(objections(best), [Criterion::PlanetSpeed, Criterion::Circulation]);
    assert!((best.objectives.circulation.unwrap() - 0.7277).abs() < 1e-4, "{:?}", best.objectives);
    assert!((best.objectives.speed - 2.157).abs() < 1e-3);
}

#[test]
fn the_document_left_iii_3_unexamined() {
    let found = select(&excavator(), &Space::Catalogue).unwrap();
    let iii_3 = scheme(&found, "III-3")[0];
    assert!((iii_3.k[0] - 1.466).abs() < 1e-3 && (iii_3.k[1] - 2.243).abs() < 1e-3, "{:?}", iii_3.k);
    assert!(objections(iii_3).contains(&Criterion::PlanetSpeed));
}

#[test]
fn brake_torques_are_those_of_the_ratio_and_the_direct_clutch_of_least_torque_is_named() {
    let found = select(&excavator(), &Space::All).unwrap();
    for candidate in all(&found) {
        for gear in &candidate.gears {
            let eta = gear.efficiency.unwrap();
            let torque = gear.brake_torque.unwrap();
            assert!((torque - (gear.ratio * eta - 1.0)).abs() < 1e-9, "{}: {torque}", candidate.mechanism);
        }
        let gearbox = candidate.gearbox(&excavator()).unwrap();
        let direct = gearbox.analyze("direct").unwrap();
        assert!((direct.ratio().unwrap() - 1.0).abs() < 1e-12);
        let clutch = &candidate.direct_clutches[candidate.direct_clutch];
        let torque = direct.ideal().unwrap().shift_elements[2].unwrap();
        assert!((torque - clutch.torque).abs() < 1e-9, "{}: {torque} {clutch:?}", candidate.mechanism);
        assert!(candidate.direct_clutches[0].torque.abs() <= clutch.torque.abs() + 1e-12);
        let table = candidate.engagement_table();
        assert_eq!(table.last().unwrap().engaged, SchemeElement::DirectClutch);
        assert_eq!(table.iter().any(|line| line.reverses), candidate.mixes_directions());
    }
}

#[test]
fn ring_to_sun_ratios_are_the_catalogues() {
    let found = select(&excavator(), &Space::Catalogue).unwrap();
    for candidate in all(&found) {
        let exact = candidate.objectives.ratio_error < 1e-9;
        let Some(Scheme::Three(scheme)) = candidate.mechanism.scheme() else { unreachable!("two sets") };
        let [first, second] = [0, 1].map(|gear: usize| candidate.gears[gear].ratio);
        let k1 = scheme.first_stage().ring_to_sun_ratio(first).unwrap();
        let k2 = scheme.second_ring_to_sun_ratio(k1, second).unwrap();
        assert!((k1.get() - candidate.k[0]).abs() < 1e-9 && (k2.get() - candidate.k[1]).abs() < 1e-9);
        assert!(exact || candidate.k.iter().any(|k| *k == 1.3 || *k == 10.0), "{:?}", candidate.k);
    }
}

#[test]
fn the_order_decides_and_the_front_holds_what_nothing_dominates() {
    let first = |objective| {
        let order = Order::new(&[objective]).unwrap();
        let found = select_with(&excavator(), &Space::All, order, None).unwrap();
        for entry in &found.front {
            let dominated = found.accepted.iter().any(|candidate| {
                candidate.mixes_directions() == found.accepted[entry.members[0]].mixes_directions()
                    && candidate.objectives.dominates(&entry.objectives)
            });
            assert!(!dominated);
        }
        found.accepted[found.best[0]].mechanism.to_string()
    };
    assert_eq!(first(Objective::Efficiency), "D.B.T1+D.T1.T2");
    assert_eq!(first(Objective::Speed), "D.T1.T2+B.T2.T1");
    assert_eq!(first(Objective::Size), "D.B.T1+B.T2.T1");
}

/// Whatever the order of the objectives: a design that reverses follows all others and surpasses none of
/// them.
#[test]
fn designs_that_reverse_are_ranked_last() {
    for ratios in [&[1.466, 2.566][..], &[1.6, 2.54], &[3.9375], &[2.5, 1.5]] {
        for objective in Objective::ALL {
            let mut requirements = Requirements::new(RatioSeries::of_braked_gears(ratios).unwrap());
            requirements.limits.planet_speed = 5.0;
            let order = Order::new(&[objective]).unwrap();
            let found = select_with(&requirements, &Space::All, order, None).unwrap();
            let of =
                |mixed: bool| found.accepted.iter().filter(|one| one.mixes_directions() == mixed).count();
            assert!(of(true) > 0 && of(false) > 0, "{ratios:?}");
            let ranked: Vec<bool> =
                found.best.iter().map(|&place| found.accepted[place].mixes_directions()).collect();
            assert!(ranked.is_sorted(), "{objective}: {ranked:?}");
            let mut places = found.best.clone();
            places.sort_unstable();
            assert_eq!(places, (0..found.accepted.len()).collect::<Vec<_>>());
            // By trial: the front of each direction.
            for (place, one) in found.accepted.iter().enumerate() {
                let dominated = found.accepted.iter().any(|other| {
                    other.mixes_directions() == one.mixes_directions()
                        && other.objectives.dominates(&one.objectives)
                });
                let on_front = found.front.iter().any(|entry| entry.members.contains(&place));
                assert_eq!(on_front, !dominated, "{one:?}");
            }
        }
    }
}

#[test]
fn drawing_is_a_criterion_that_can_be_lifted() {
    let no = |_: Mechanism| Err(NotDrawable::NoDirectClutch);
    let mut requirements = excavator();
    let found = select_with(&requirements, &Space::All, Order::default(), Some(&no)).unwrap();
    assert!(found.accepted.is_empty());
    requirements.limits.drawable = false;
    let found = select_with(&requirements, &Space::All, Order::default(), Some(&no)).unwrap();
    let objection = found.accepted[0].objections().find(|v| v.criterion == Criterion::Drawable).unwrap();
    assert_eq!(objection.evidence, Evidence::NotDrawable(NotDrawable::NoDirectClutch));
}

//! Selection for the examples of section 3.3: what the document found, what it missed, what it got wrong.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_schemes::selection::{
    Candidate, Criterion, Demand, Objective, Order, RatioSeries, Selection, Space, select, select_with,
};
use epicyclic_schemes::structures::{Family, Role};
use uom::si::f64::Velocity;
use uom::si::velocity::meter_per_second;

fn demand(speeds: &[f64]) -> Demand {
    let speeds: Vec<Velocity> = speeds.iter().map(|v| Velocity::new::<meter_per_second>(*v)).collect();
    Demand::new(RatioSeries::of_speeds(&speeds).unwrap())
}

fn excavator() -> Demand {
    demand(&[0.76, 1.33, 1.95])
}

fn all(found: &Selection) -> impl Iterator<Item = &Candidate> {
    found.accepted.iter().chain(&found.rejected)
}

fn scheme<'a>(found: &'a Selection, name: &str) -> Vec<&'a Candidate> {
    all(found).filter(|candidate| candidate.mechanism.scheme() == Some(name)).collect()
}

fn objections(candidate: &Candidate) -> Vec<Criterion> {
    candidate.objections().map(|verdict| verdict.criterion).collect()
}

#[test]
#[ignore]
fn print() {
    let found = select(&excavator(), &Space::All).unwrap();
    for (kind, list) in [("acc", &found.accepted), ("rej", &found.rejected)] {
        for c in list {
            println!(
                "{kind} {:16} {:?} k {:.3?} i {:?} obj {:.4?} {:?} lock {:?}",
                c.mechanism.to_string(),
                c.mechanism.scheme(),
                c.k,
                c.gears.iter().map(|g| (g.wanted, g.ratio)).collect::<Vec<_>>(),
                c.objectives,
                objections(c),
                c.locks[c.lock]
            );
        }
    }
    println!("{} unreachable", found.unreachable.len());
    for e in &found.front {
        println!("{:?}", e);
    }
}

#[test]
fn the_conveyor_takes_scheme_i() {
    let found = select(&demand(&[0.8, 3.15]), &Space::Catalogue).unwrap();
    let names: Vec<_> = found.best.iter().map(|&place| found.accepted[place].mechanism.scheme()).collect();
    assert_eq!(names, [Some("I"), Some("III")]);
    let best = &found.accepted[found.best[0]];
    assert!((best.objectives.efficiency - (1.0 + 2.9375 * 0.9702) / 3.9375).abs() < 1e-12);
    // Scheme II reaches 2 at most: unreachable, and it says which k it would need.
    let refused = found.unreachable.iter().find(|u| u.mechanism.scheme() == Some("II")).unwrap();
    assert!((refused.needed.as_ref().unwrap()[0] - 1.0 / 2.9375).abs() < 1e-12, "{refused:?}");
}

#[test]
fn the_excavator_wheel_has_the_documents_two_and_the_objections_to_both() {
    let found = select(&excavator(), &Space::Catalogue).unwrap();
    let [ii_3] = scheme(&found, "II-3")[..] else { unreachable!("one order of ratios fits II-3") };
    assert!((ii_3.k[0] - 2.145).abs() < 1e-3 && (ii_3.k[1] - 2.359).abs() < 2e-3, "{:?}", ii_3.k);
    assert_eq!(objections(ii_3), [Criterion::PlanetSpeed]);
    let planets = ii_3.objections().next().unwrap();
    assert!((planets.value - 2.28).abs() < 0.01, "{planets}");
    assert!(found.rejected.contains(ii_3));

    let iii_1 = scheme(&found, "III-1")[0];
    assert!((iii_1.k[0] - 2.566).abs() < 1e-3 && (iii_1.k[1] - 4.754).abs() < 1e-3, "{:?}", iii_1.k);
    assert_eq!(objections(iii_1), [Criterion::OneSense]);
    assert!(iii_1.mixes_senses() && found.accepted.contains(iii_1));
    assert!(iii_1.objectives.speed < 1.56 && (iii_1.objectives.efficiency - 0.9666).abs() < 1e-4);

    let mut strict = excavator();
    strict.limits.one_sense = true;
    let found = select(&strict, &Space::Catalogue).unwrap();
    assert!(scheme(&found, "III-1")[0].objections().all(|verdict| verdict.required));
    assert!(found.accepted.is_empty());
}

#[test]
fn the_document_rounds_its_ratios_and_gets_k_of_2_15_2_35_and_4_76() {
    let mut rounded = Demand::new(RatioSeries::new(&[1.465, 2.56]).unwrap());
    rounded.eta0 = MeshEfficiency::new(0.97).unwrap();
    let found = select(&rounded, &Space::Catalogue).unwrap();
    let [ii_3] = scheme(&found, "II-3")[..] else { unreachable!("one order of ratios fits II-3") };
    assert!((ii_3.k[0] - 2.15).abs() < 1e-3 && (ii_3.k[1] - 2.3548).abs() < 1e-3);
    assert!((ii_3.gears[1].efficiency.unwrap() - 0.969).abs() < 5e-4);
    let iii_1 = scheme(&found, "III-1")[0];
    assert!((iii_1.k[1] - 4.76).abs() < 5e-3);
    assert!((iii_1.gears[1].efficiency.unwrap() - 0.9664).abs() < 1e-4);
}

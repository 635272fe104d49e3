//! Every tooth design by one enumeration, against the trial of all sets with the solver's ratios.

use epicyclic_gears::ToothCount;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::synthesis::Bounds;
use epicyclic_schemes::ratio_series::RatioSeries;
use epicyclic_schemes::structures::Role;
use epicyclic_selection::every::{designs, sets};
use epicyclic_selection::{Mechanism, Requirements, Space};
use std::error::Error;
use std::ops::ControlFlow;

/// Ratios of the braked gears by the solver.
fn solved(mechanism: Mechanism, k: &[f64]) -> Result<Vec<f64>, Box<dyn Error>> {
    let gearbox = mechanism.gearbox(k, MeshEfficiency::IDEAL, [Role::D, Role::B])?;
    let mut all = vec![];
    for gear in &gearbox.gears()[..k.len()] {
        all.extend(gearbox.analyze_gear(gear)?.ratio());
    }
    Ok(all)
}

#[test]
fn the_designs_are_those_of_every_trial() -> Result<(), Box<dyn Error>> {
    let bounds = Bounds { sun: 18..=27, planet: 17..=24, ring: 50..=80, planets: 3..=4, ..Bounds::default() };
    let all = sets(&bounds, 0..=0);
    let mut expected = vec![];
    for sun in 18..=27_u32 {
        for planet in 17..=24_u32 {
            let ring = sun + 2 * planet;
            let is_placed = (sun + ring).is_multiple_of(3) || (sun + ring).is_multiple_of(4);
            let k = f64::from(ring) / f64::from(sun);
            if (50..=80).contains(&ring) && is_placed && bounds.ring_to_sun_ratio.contains(&k) {
                expected.push([sun, planet, ring]);
            }
        }
    }
    let teeth: Vec<[u32; 3]> =
        all.iter().map(|set| [set.sun, set.planet, set.ring].map(ToothCount::get)).collect();
    assert_eq!(teeth, expected);
    let k: Vec<f64> = expected.iter().map(|[sun, _, ring]| f64::from(*ring) / f64::from(*sun)).collect();
    let mut seen = 0;
    for ratios in [vec![3.9], vec![-2.7], vec![3.6, 1.4], vec![-2.3, 1.45]] {
        let mut requirements = Requirements::new(RatioSeries::of_braked_gears(&ratios)?);
        requirements.tolerance = 0.06;
        requirements.limits.same_direction = false;
        let space = Space::Catalogue;
        let mechanisms: Vec<Mechanism> = match ratios.len() {
            1 => space.sets().into_iter().map(Mechanism::OneSet).collect(),
            _ => space.structures().into_iter().map(Mechanism::TwoSets).collect(),
        };
        for mechanism in mechanisms {
            let found = designs(mechanism, &all, &requirements, &|| ControlFlow::Continue(()));
            let pairs: Vec<Vec<f64>> = match ratios.len() {
                1 => k.iter().map(|k| vec![*k]).collect(),
                _ => k.iter().flat_map(|one| k.iter().map(|other| vec![*one, *other])).collect(),
            };
            let mut count = 0;
            for pair in pairs {
                let own = solved(mechanism, &pair)?;
                let is_near = |wanted: &Vec<f64>| {
                    own.len() == wanted.len()
                        && own.iter().zip(wanted).all(|(own, wanted)| (own / wanted - 1.0).abs() <= 0.06)
                };
                count += requirements.targets().iter().filter(|wanted| is_near(wanted)).count();
            }
            // Exchanged sets of a symmetric scheme are one design.
            let is_symmetric = matches!(mechanism, Mechanism::TwoSets(structure) if structure.is_symmetric());
            assert_eq!(found.len() * if is_symmetric { 2 } else { 1 }, count, "{mechanism} {ratios:?}");
            seen += count;
        }
    }
    assert!(seen > 100, "{seen}");
    Ok(())
}

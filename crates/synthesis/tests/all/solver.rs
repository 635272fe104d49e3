//! Ratios as formulas against the solver, on random structures, elements and ring-to-sun ratios.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests, which clippy does not know for such"
)]

use crate::common;

use common::Random;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_synthesis::motion::{Motion, elements};
use epicyclic_synthesis::ratio::Ratio;
use epicyclic_synthesis::ternary::Word;
use epicyclic_synthesis::{Class, Kind, Structure, enumerate, gearbox};

fn any_k(random: &mut Random) -> f64 {
    1.4 + 3.1 * random.below(1_000_003) as f64 / 1_000_003.0
}

/// Number of driven gears among `count` random gears of a class, each agreeing with the solver.
fn agreeing<W: Word>(class: Class, count: usize) -> usize {
    let structures = enumerate::all(class);
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let mut driven = 0;
    for _ in 0..count {
        let structure: &Structure = &structures[random.below(structures.len())];
        let all = elements(class.links());
        let mut engaged: Vec<usize> = Vec::new();
        while engaged.len() < class.engaged() {
            let element = random.below(all.len());
            if !engaged.contains(&element) {
                engaged.push(element);
            }
        }
        engaged.sort_unstable();
        let k: Vec<f64> = (0..class.sets()).map(|_| any_k(&mut random)).collect();
        let mut motion = Motion::<W>::new(structure.freedom());
        motion.take(structure, &all);
        let speeds = motion.gear(&engaged);
        let formula = Ratio::of(speeds);
        let used: Vec<_> = engaged.iter().map(|element| all[*element]).collect();
        let built =
            gearbox::gearbox(structure, &k, MeshEfficiency::IDEAL, &used, &[(0..used.len()).collect()])
                .unwrap();
        let analysis = built.analyze("1").unwrap();
        // Elements that repeat each other leave a link free: no gear of the class, whatever the output does.
        let all_turn = analysis.speeds().iter().all(Option::is_some);
        let solved = analysis.ratio().filter(|_| all_turn);
        match (formula, solved) {
            (Some(formula), Some(solved)) => {
                let value = formula.value(&k);
                assert!(
                    (value - solved).abs() < 1e-9 * (1.0 + solved.abs()),
                    "{structure} {used:?} {k:?}: {formula} = {value}, solver {solved}"
                );
                driven += 1;
            }
            (None, None) => {}
            _ => panic!("{structure} {used:?} {k:?}: formula {formula:?}, solver {solved:?}"),
        }
    }
    driven
}

#[test]
fn formulas_agree_with_the_solver_for_two_to_five_sets() {
    let class = |kind, sets, links| Class::new(kind, sets, links).unwrap();
    assert!(agreeing::<u8>(class(Kind::Core, 2, 4), 500) > 250);
    assert!(agreeing::<u8>(class(Kind::AllSparse, 2, 5), 500) > 100);
    assert!(agreeing::<u8>(class(Kind::AllSparse, 3, 6), 1000) > 200);
    assert!(agreeing::<u16>(class(Kind::Core, 4, 8), 1000) > 300);
    assert!(agreeing::<u16>(class(Kind::Core, 4, 9), 500) > 100);
}

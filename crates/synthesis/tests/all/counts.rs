//! Counts of classes: enumeration, mass formula and Burnside's lemma agree.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use epicyclic_synthesis::count::{self, Counts};
use epicyclic_synthesis::{Class, Kind, enumerate};

fn class(kind: Kind, sets: usize, links: usize) -> Class {
    Class::new(kind, sets, links).unwrap()
}

/// Counts of the three ways.
#[track_caller]
fn check(kind: Kind, sets: usize, links: usize) -> Counts {
    let class = class(kind, sets, links);
    let counts = count::enumerated(class);
    assert_eq!(counts.words, count::words(class), "{class}: mass formula");
    assert_eq!(counts.structures, count::by_burnside(class), "{class}: Burnside's lemma");
    counts
}

/// Structures of two sets, and of three with five and six links, are cases: `spec-cases/gearbox-structures`.
#[test]
fn structures_of_one_set_and_of_three_with_seven_links() {
    check(Kind::Core, 1, 3);
    check(Kind::Core, 3, 7);
}

/// Figures of a feasibility study.
#[test]
fn structures_of_four_sets() {
    assert_eq!(check(Kind::Core, 4, 8), Counts { structures: 121_050, words: 2_830_464 });
}

#[test]
fn each_structure_comes_once_in_rising_order() {
    let all = enumerate::all(class(Kind::Core, 3, 6));
    assert!(all.windows(2).all(|pair| pair[0] < pair[1]));
    for structure in &all {
        assert_eq!(structure.to_string().parse::<epicyclic_synthesis::Structure>().unwrap(), *structure);
    }
}

/// By two ways: Burnside's lemma agrees, too, but takes six times as long as both together.
#[test]
fn all_sparse_structures_of_four_sets() {
    let class = class(Kind::AllSparse, 4, 8);
    assert_eq!(count::enumerated(class), Counts { structures: 772_920, words: 18_003_384 });
    assert_eq!(count::words(class), 18_003_384);
}

/// Figures that the study had not. Burnside's lemma takes long for seven links, where more sets share their
/// links.
#[test]
fn structures_of_four_sets_with_seven_and_nine_links() {
    assert_eq!(check(Kind::Core, 4, 9).structures, 20_376);
    let seven = class(Kind::Core, 4, 7);
    let counts = count::enumerated(seven);
    assert_eq!((counts.structures, counts.words), (249_957, count::words(seven)));
}

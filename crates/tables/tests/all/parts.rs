//! Parts of a search are read as they were written, and together they are the search of the whole class.

use epicyclic_synthesis::asked::{Asked, asked};
use epicyclic_synthesis::parts::Bounds;
use epicyclic_synthesis::run::{go_on, search};
use epicyclic_synthesis::wish::Wish;
use epicyclic_synthesis::work::{Share, Work};
use epicyclic_synthesis::{Class, Kind};
use epicyclic_tables::Error;
use epicyclic_tables::merge::merge;
use epicyclic_tables::part::Part;
use proptest::strategy::{Strategy as _, ValueTree as _};
use proptest::test_runner::TestRunner;
use std::ops::ControlFlow;

const VERSION: &str = "0.0.1";

/// The four-speed of two sets, whose solutions have elements that lock the same and gears with several
/// choices.
fn question() -> (Class, Wish) {
    let gears = [3.059, 1.625, 1.0, 0.696, -2.294];
    let around = |ratio: f64| Bounds { least: ratio - 0.01 * ratio.abs(), most: ratio + 0.01 * ratio.abs() };
    let wish = Wish::new(gears.map(around).into(), 5, vec![1.4..=4.5; 2]);
    (Class::new(Kind::AllSparse, 2, 5).expect("a class"), wish)
}

fn the_question() -> Vec<Asked> {
    let (class, wish) = question();
    vec![asked(class, &wish)]
}

fn part(number: usize, of: usize, breaks: bool) -> Part {
    let (class, wish) = question();
    let share = Share { number, of };
    let go = if breaks { ControlFlow::Break(()) } else { ControlFlow::Continue(()) };
    let work = go_on(class, &wish, share, Work::default(), &|_| go).expect("a search");
    Part { version: VERSION.into(), share, searches: vec![(asked(class, &wish), work)] }
}

fn parts(of: usize) -> Vec<(String, Part)> {
    (0..of).map(|number| (format!("{}.parquet", number + 1), part(number, of, false))).collect()
}

#[test]
fn a_part_is_read_as_it_was_written() {
    for part in [part(0, 1, false), part(1, 3, true), part(0, 1, true), part(440, 447, false)] {
        let bytes = part.to_parquet().unwrap();
        let again = Part::from_parquet(bytes.clone()).unwrap();
        assert_eq!(again, part);
        assert_eq!(again.to_parquet().unwrap(), bytes);
    }
}

/// Reads structures with stars, whose words have ring and carrier exchanged.
#[test]
fn a_part_with_double_planet_sets_is_read_as_it_was_written() {
    let around = |ratio: f64| Bounds { least: 0.99 * ratio, most: 1.01 * ratio };
    let mut wish = Wish::new([2.56, 1.465].map(around).into(), 2, vec![1.4..=4.5, 0.6..=3.5]);
    wish.double_planets = 1;
    let class = Class::new(Kind::Core, 2, 4).expect("a class");
    let work = go_on(class, &wish, Share::WHOLE, Work::default(), &|_| ControlFlow::Continue(())).unwrap();
    let searches = vec![(asked(class, &wish), work)];
    let part = Part { version: VERSION.into(), share: Share::WHOLE, searches };
    assert_eq!(part.searches[0].1.found.len(), 14);
    assert_eq!(Part::from_parquet(part.to_parquet().unwrap()).unwrap(), part);
}

#[test]
fn which_k_are_equal_is_read_as_it_was_written() {
    let gears = [2.56, 1.465].map(|ratio: f64| Bounds { least: 0.95 * ratio, most: 1.05 * ratio });
    let wish = Wish { equal_k: 2, ..Wish::new(gears.into(), 2, vec![1.4..=4.5; 2]) };
    let class = Class::new(Kind::Core, 2, 4).unwrap();
    let work = go_on(class, &wish, Share::WHOLE, Work::default(), &|_| ControlFlow::Continue(())).unwrap();
    let equal = work.found.iter().map(|(_, found)| found.solution.equal.sets().count());
    assert!(!work.found.is_empty() && equal.into_iter().all(|count| count == 2));
    let searches = vec![(asked(class, &wish), work)];
    let part = Part { version: VERSION.into(), share: Share::WHOLE, searches };
    assert_eq!(Part::from_parquet(part.to_parquet().unwrap()).unwrap(), part);
}

/// Refuses a part with any one bit changed, with an error and no panic.
#[test]
fn no_part_with_a_changed_bit_is_read() {
    for part in [part(0, 1, false), part(1, 3, true)] {
        let bytes = part.to_parquet().unwrap();
        let bits = 8 * bytes.len();
        let mut runner = TestRunner::default();
        for _ in 0..1000 {
            let bit = (0..bits).new_tree(&mut runner).unwrap().current();
            let mut changed = bytes.clone();
            changed[bit / 8] ^= 1 << (bit % 8);
            let read = Part::from_parquet(changed);
            assert!(matches!(read, Err(Error::Damaged | Error::Unsealed)), "bit {bit}: {read:?}");
        }
        for length in (0..bytes.len()).step_by(97) {
            assert!(Part::from_parquet(bytes[..length].to_vec()).is_err(), "{length} bytes");
        }
        let longer = [&bytes[..], &[0]].concat();
        assert!(matches!(Part::from_parquet(longer), Err(Error::Damaged)));
    }
}

#[test]
fn parts_together_are_the_whole_search_in_any_order() {
    let (class, wish) = question();
    let whole = search(class, &wish, Share::WHOLE, &|_| ControlFlow::Continue(())).unwrap();
    assert!(!whole.found.is_empty());
    for of in [1, 2, 5] {
        let mut parts = parts(of);
        parts.reverse();
        assert_eq!(merge(&parts, VERSION, &the_question()).unwrap(), std::slice::from_ref(&whole));
    }
}

#[test]
fn what_is_missing_double_or_different_is_named() {
    let whole = parts(3);
    let fault = |parts: &[(String, Part)], question: &[Asked]| {
        merge(parts, VERSION, question).unwrap_err().to_string()
    };
    let asked = the_question();
    assert_eq!(fault(&whole[..1], &asked), "missing: shares 2, 3 of 3");
    assert_eq!(fault(&[whole[0].clone(), whole[2].clone()], &asked), "missing: share 2 of 3");
    let mut double = whole.clone();
    double.push(("again.parquet".into(), whole[1].1.clone()));
    assert_eq!(fault(&double, &asked), "2.parquet and again.parquet are both share 2/3; give one of them");
    let mut other = whole.clone();
    other[1].1.version = "0.0.2".into();
    assert_eq!(
        fault(&other, &asked),
        "2.parquet is of version 0.0.2, not 0.0.1: all parts have to be of one version"
    );
    let mut other = whole.clone();
    other[1] = ("b.parquet".into(), part(1, 4, false));
    assert_eq!(
        fault(&other, &asked),
        "1.parquet is of 3 shares, b.parquet of 4: all parts have to be of one division"
    );
    let mut other = whole.clone();
    other[2].1 = part(2, 3, true);
    assert!(fault(&other, &asked).starts_with("3.parquet is not complete: "), "{}", fault(&other, &asked));
    let (class, mut wish) = question();
    wish.gears[0].least = wish.gears[0].least.next_up();
    let wanted = vec![epicyclic_synthesis::asked::asked(class, &wish)];
    let message = fault(&whole, &wanted);
    assert!(message.starts_with("1.parquet is of another search: its gears: 3.02841..3.08959"), "{message}");
    assert!(merge(&[], VERSION, &asked).is_err());
}

#[test]
fn what_is_no_part_is_refused() {
    assert!(matches!(Part::from_parquet(b"PAR1".to_vec()), Err(Error::Unsealed)));
    assert!(Part::from_parquet(Vec::new()).is_err());
    let bytes = part(0, 1, false).to_parquet().unwrap();
    for length in [bytes.len() - 1, bytes.len() / 2, 4] {
        assert!(Part::from_parquet(bytes[..length].to_vec()).is_err());
    }
}

//! Work that is broken off and gone on with, in shares, is the work of one run.

use epicyclic_synthesis::parts::Bounds;
use epicyclic_synthesis::run::{Share, go_on, search};
use epicyclic_synthesis::wish::Wish;
use epicyclic_synthesis::work::Work;
use epicyclic_synthesis::{Class, Error, Kind};
use std::ops::ControlFlow;

/// A class with enough structures for several pieces, and a wish that some have.
fn question() -> (Class, Wish) {
    let gears = [3.059, 1.625, 1.0, 0.696, -2.294];
    let gears = gears
        .map(|ratio: f64| Bounds { least: ratio - 0.01 * ratio.abs(), most: ratio + 0.01 * ratio.abs() });
    let wish = Wish::new(gears.into(), 5, vec![1.4..=4.5; 2]);
    (Class::new(Kind::AllSparse, 2, 5).expect("a class"), wish)
}

#[test]
fn work_broken_off_after_every_piece_ends_as_work_of_one_run() {
    let (class, wish) = question();
    for share in [Share::WHOLE, Share { number: 1, of: 3 }] {
        let whole = go_on(class, &wish, share, Work::default(), &|_| ControlFlow::Continue(())).unwrap();
        assert!(whole.is_complete() && whole.structures > 100 && !whole.found.is_empty());
        let (mut work, mut runs) = (Work::default(), 0);
        while !work.is_complete() {
            // A piece at least is done; before that structures are listed, which is not kept.
            let before = work.progress().done;
            let goes_on = |at: &Work| {
                if at.progress().done > before { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            };
            work = go_on(class, &wish, share, work, &goes_on).unwrap();
            runs += 1;
        }
        assert!(runs > 3, "{runs}");
        assert_eq!(work, whole);
    }
}

#[test]
fn shares_together_are_the_class() {
    let (class, wish) = question();
    let whole = search(class, &wish, Share::WHOLE, &|_| ControlFlow::Continue(())).unwrap();
    for of in [2, 7] {
        let mut found = Vec::new();
        let mut searched = 0;
        for number in 0..of {
            let share = Share { number, of };
            let work = go_on(class, &wish, share, Work::default(), &|_| ControlFlow::Continue(())).unwrap();
            searched += work.structures;
            found.extend(work.found.into_iter().map(|(place, found)| (share.place_in_class(place), found)));
        }
        found.sort_by_key(|(place, _)| *place);
        let found: Vec<_> = found.into_iter().map(|(_, found)| found).collect();
        assert_eq!((searched, found), (whole.class_size, whole.found.clone()));
    }
}

#[test]
fn work_on_another_share_is_refused() {
    let (class, wish) = question();
    let goes_on = |_: &Work| ControlFlow::Continue(());
    let work = go_on(class, &wish, Share::WHOLE, Work::default(), &goes_on).unwrap();
    let refused = go_on(class, &wish, Share { number: 0, of: 2 }, work, &goes_on).unwrap_err();
    assert!(matches!(refused, Error::OtherWork { given: 447, .. }), "{refused}");
}

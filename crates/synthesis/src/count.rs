//! Numbers of structures and words of a class, by two methods independent of the enumeration.
//!
//! *Mass formula.* A structure has `n!/|Aut|` words, one for each order of its sets that no automorphism
//! makes equal to another. So `Σ n!/|Aut|` over the structures is the number of all words, and these are
//! counted without asking which are equal.
//!
//! *Burnside's lemma.* Orders of the sets and names of the other links, `n!·(L − 2)!` pairs `(σ, π)`, act on
//! labelled structures. The number of structures is the mean number of labelled structures that a pair leaves
//! unchanged. Pairs with equal cycle lengths leave an equal number unchanged.

use crate::class::Class;
use crate::enumerate;
use crate::kind::Kind;
use crate::structure::{Link, Members, mask};
use crate::watch::Watch;
use std::ops::ControlFlow;

/// Counts of a class that agree.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Counts {
    /// Number of structures.
    pub structures: u64,
    /// Number of words: structures times orders of their sets, automorphisms left out.
    pub words: u64,
}

/// Numbers of structures and words by enumeration: `words` is `Σ n!/|Aut|`.
#[must_use]
pub fn enumerated(class: Class) -> Counts {
    let orders: u64 = (1..=class.sets() as u64).product();
    let mut counts = Counts { structures: 0, words: 0 };
    enumerate::for_each(class, &mut |sets| {
        let structure = crate::Structure::of_canonical_word(sets.to_vec(), class.links());
        counts.structures += 1;
        counts.words += orders / structure.automorphisms().len() as u64;
    });
    counts
}

/// Number of structures, counted one by one; `None` if `ended`, which is called now and then, ends the
/// counting.
#[must_use]
pub fn structures(class: Class, ended: &dyn Fn() -> bool) -> Option<usize> {
    let (mut count, watch) = (0, Watch::new(ended));
    let whole = enumerate::walk(class, &mut |sets| {
        count += usize::from(sets.len() == class.sets());
        if watch.is_over() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    whole.is_continue().then_some(count)
}

/// Number of words, counted one by one.
#[must_use]
pub fn words(class: Class) -> u64 {
    let mut count = 0;
    enumerate::for_each_word(class, &mut |_| count += 1);
    count
}

/// Number of structures, by Burnside's lemma.
#[must_use]
pub fn by_burnside(class: Class) -> u64 {
    let others = class.links() - 2;
    let mut unchanged = 0;
    for sets in partitions(class.sets()) {
        for names in partitions(others) {
            let pairs = permutations(&sets) * permutations(&names);
            unchanged += pairs * fixed(class, &sets, &names);
        }
    }
    unchanged / (factorial(class.sets()) * factorial(others))
}

/// Labelled structures that an order of the sets with cycles of these lengths, and a renaming with cycles of
/// those, leave unchanged.
fn fixed(class: Class, set_cycles: &[usize], name_cycles: &[usize]) -> u64 {
    if set_cycles.iter().all(|length| *length == 1) {
        // Every member keeps its link, and every other link is on a member: no other may be renamed. The
        // words number the other links as they occur; labelled, each order of their names is another.
        let identity = name_cycles.iter().all(|length| *length == 1);
        return if identity { words(class) * factorial(name_cycles.len()) } else { 0 };
    }
    let mut renamed: Vec<Link> = (0..3).collect();
    for length in name_cycles {
        let first = renamed.len();
        renamed.extend((0..*length).map(|place| small(first + (place + 1) % length)));
    }
    let mut sets = Vec::new();
    grow(class, set_cycles, &renamed, &mut sets)
}

/// Number of ways to choose the first set of each cycle, the others following from the renaming.
fn grow(class: Class, cycles: &[usize], renamed: &[Link], sets: &mut Vec<Members>) -> u64 {
    let Some((length, rest)) = cycles.split_first() else {
        return u64::from(belongs(class, sets));
    };
    let links = class.links() + 1;
    let mut count = 0;
    for code in 0..links * links * links {
        let first = [code / (links * links), code / links % links, code % links].map(small);
        let mut next = first;
        let before = sets.len();
        let may_all = (0..*length).all(|_| {
            sets.push(next);
            next = next.map(|link| renamed[usize::from(link)]);
            may_belong(class, sets)
        });
        if may_all && next == first {
            count += grow(class, rest, renamed, sets);
        }
        sets.truncate(before);
    }
    count
}

/// Whether sets can be among those of a structure if all but the last can.
fn may_belong(class: Class, sets: &[Members]) -> bool {
    // The housing is link 0.
    let on_housing = |members: &Members| mask(members) & 1 == 1;
    let Some((last, before)) = sets.split_last() else { return true };
    // Any sets touch two links more than they are; that any without the last do is known.
    let enough = |chosen: usize| {
        let among = (0..before.len()).filter(|set| chosen >> set & 1 == 1);
        let touched = among.fold(mask(last), |touched, set| touched | mask(&before[set]));
        touched.count_ones() >= chosen.count_ones() + 3
    };
    !(class.kind() == Kind::Core && on_housing(last)) && (0..1 << before.len()).all(enough)
}

/// Whether sets are a labelled structure of the class.
fn belongs(class: Class, sets: &[Members]) -> bool {
    let on_a_member = |link: usize| sets.iter().flatten().any(|member| usize::from(*member) == link);
    let joined = || {
        let mut group: Vec<usize> = (0..=class.links()).collect();
        for [sun, ring, carrier] in sets {
            for link in [ring, carrier] {
                let (from, to) = (group[usize::from(*link)], group[usize::from(*sun)]);
                group.iter_mut().filter(|group| **group == from).for_each(|group| *group = to);
            }
        }
        group[1..].iter().all(|other| *other == group[1])
    };
    (3..=class.links()).all(on_a_member) && (class.kind() == Kind::AllSparse || joined())
}

/// Ways to write a number as a sum, the summands falling.
fn partitions(number: usize) -> Vec<Vec<usize>> {
    fn go(left: usize, most: usize, summands: &mut Vec<usize>, found: &mut Vec<Vec<usize>>) {
        if left == 0 {
            found.push(summands.clone());
        }
        for summand in 1..=most.min(left) {
            summands.push(summand);
            go(left - summand, summand, summands, found);
            summands.pop();
        }
    }
    let mut found = Vec::new();
    go(number, number, &mut Vec::new(), &mut found);
    found
}

/// Number of permutations with cycles of these lengths.
fn permutations(cycles: &[usize]) -> u64 {
    let mut among = 1;
    for length in 1..=cycles.len().max(cycles.iter().sum()) {
        let count = cycles.iter().filter(|cycle| **cycle == length).count();
        among *= (length as u64).pow(u32::try_from(count).unwrap_or(u32::MAX)) * factorial(count);
    }
    factorial(cycles.iter().sum()) / among
}

fn factorial(number: usize) -> u64 {
    (1..=number as u64).product()
}

/// A link as its number; links are few.
fn small(link: usize) -> Link {
    Link::try_from(link).unwrap_or(Link::MAX)
}

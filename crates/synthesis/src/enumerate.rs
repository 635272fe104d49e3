//! Enumeration of the structures of a class, each once, in the order of their canonical words.
//!
//! Words grow set by set. The first sets of a canonical word are canonical themselves: an order of them with
//! a smaller word would make the whole word smaller. So a prefix that is not canonical is left at once, and
//! the enumeration finds each structure once without storing those found.

use crate::class::Class;
use crate::kind::Kind;
use crate::structure::{FIRST_OTHER, INPUT, Link, Members, Names, OUTPUT, Structure, mask};
use std::ops::ControlFlow;

/// Structures of a class, in canonical order.
///
/// ```
/// use epicyclic_synthesis::{Class, Kind, enumerate};
/// # fn main() -> Result<(), epicyclic_synthesis::Error> {
/// assert_eq!(enumerate::all(Class::new(Kind::Core, 2, 4)?).len(), 111);
/// # Ok(())
/// # }
/// ```
#[must_use]
pub fn all(class: Class) -> Vec<Structure> {
    let mut found = Vec::new();
    for_each(class, &mut |sets| found.push(Structure::of_canonical_word(sets.to_vec(), class.links())));
    found
}

/// Calls `visit` with the sets of each structure of a class, in their order.
pub fn for_each(class: Class, visit: &mut impl FnMut(&[Members])) {
    let _ = walk(class, &mut |sets| {
        if sets.len() == class.sets() {
            visit(sets);
        }
        ControlFlow::Continue(())
    });
}

/// Calls `visit` with each canonical beginning of the words of a class, the whole words among them, in their
/// order; a break ends it. Long stretches of a class have beginnings alone, so that a search that is to end
/// is heard there, too.
pub fn walk(class: Class, visit: &mut impl FnMut(&[Members]) -> ControlFlow<()>) -> ControlFlow<()> {
    go(class, true, &mut Vec::new(), (0, FIRST_OTHER), visit)
}

/// Calls `visit` with every word: every structure in every order of its sets, the other links numbered as
/// they first occur. Orders that an automorphism makes equal are one word.
pub fn for_each_word(class: Class, visit: &mut impl FnMut(&[Members])) {
    let mut whole = |sets: &[Members]| {
        if sets.len() == class.sets() {
            visit(sets);
        }
        ControlFlow::Continue(())
    };
    let _ = go(class, false, &mut Vec::new(), (0, FIRST_OTHER), &mut whole);
}

/// Draws a random structure of a class, set by set from the sets that may follow, all equally probable.
/// `below(n)` is a random number below `n`.
///
/// The number returned with it is the product of the numbers of sets that could follow. Its mean over many
/// draws is the number of structures. A beginning that nothing can follow counts as 0 and has no structure.
///
/// # Source
/// D. E. Knuth, Estimating the efficiency of backtrack programs, Mathematics of Computation 29 (1975).
pub(crate) fn draw(class: Class, below: &mut impl FnMut(usize) -> usize) -> (f64, Option<Vec<Members>>) {
    let (mut sets, mut open, mut weight) = (Vec::new(), (0, FIRST_OTHER), 1.0);
    while sets.len() < class.sets() {
        let mut following = Vec::new();
        let _ = children(class, true, &mut sets, open, &mut |sets, open| {
            following.extend(sets.last().map(|members| (*members, open)));
            ControlFlow::Continue(())
        });
        if following.is_empty() {
            return (0.0, None);
        }
        weight *= following.len() as f64;
        let (members, after) = following[below(following.len())];
        sets.push(members);
        open = after;
    }
    if is_of(class, &sets) { (weight, Some(sets)) } else { (0.0, None) }
}

/// The links that some sets touch, as bits, and the next new link.
type Open = (u32, Link);

/// Calls `visit` with sets and all words that begin so.
fn go(
    class: Class,
    canonical: bool,
    sets: &mut Vec<Members>,
    open: Open,
    visit: &mut impl FnMut(&[Members]) -> ControlFlow<()>,
) -> ControlFlow<()> {
    if sets.len() == class.sets() {
        return if is_of(class, sets) { visit(sets) } else { ControlFlow::Continue(()) };
    }
    if !sets.is_empty() {
        visit(sets)?;
    }
    children(class, canonical, sets, open, &mut |sets, open| go(class, canonical, sets, open, visit))
}

/// Whether as many sets as a class has are a structure of it.
fn is_of(class: Class, sets: &[Members]) -> bool {
    class.kind() == Kind::AllSparse || is_joined(sets)
}

/// Calls `visit` with sets and each one that may follow them.
fn children(
    class: Class,
    canonical: bool,
    sets: &mut Vec<Members>,
    (touched, next): Open,
    visit: &mut impl FnMut(&mut Vec<Members>, Open) -> ControlFlow<()>,
) -> ControlFlow<()> {
    let left = class.sets() - sets.len();
    let core = class.kind() == Kind::Core;
    let first = u8::from(core);
    let last = u8::try_from(class.links()).unwrap_or(u8::MAX);
    for sun in first..=next.min(last) {
        let next = next + u8::from(sun == next);
        for ring in (first..=next.min(last)).filter(|ring| *ring != sun) {
            let next = next + u8::from(ring == next);
            for carrier in (first..=next.min(last)).filter(|carrier| *carrier != sun && *carrier != ring) {
                let next = next + u8::from(carrier == next);
                let members = [sun, ring, carrier];
                let touched = touched | mask(&members);
                if missing(core, touched, last, next) > 3 * (left - 1) || !stays_sparse(sets, &members) {
                    continue;
                }
                sets.push(members);
                if !canonical || is_canonical(sets) {
                    visit(sets, (touched, next))?;
                }
                sets.pop();
            }
        }
    }
    ControlFlow::Continue(())
}

/// Number of links that still need a member.
fn missing(core: bool, touched: u32, last: Link, next: Link) -> usize {
    let ends = [INPUT, OUTPUT].into_iter().filter(|link| core && touched >> link & 1 == 0).count();
    ends + usize::from(last + 1 - next)
}

/// Whether sets stay sparse with one more: any of them with it touch two links more than they are.
fn stays_sparse(sets: &[Members], more: &Members) -> bool {
    fn go(sets: &[Members], touched: u32, count: u32) -> bool {
        touched.count_ones() >= count + 2
            && sets
                .iter()
                .enumerate()
                .all(|(place, members)| go(&sets[place + 1..], touched | mask(members), count + 1))
    }
    go(sets, mask(more), 1)
}

/// Whether the sets are joined by links.
fn is_joined(sets: &[Members]) -> bool {
    let mut reached = mask(&sets[0]);
    for _ in sets {
        for members in sets {
            if mask(members) & reached != 0 {
                reached |= mask(members);
            }
        }
    }
    sets.iter().all(|members| mask(members) & reached != 0)
}

/// Whether no order of the sets gives a smaller word.
fn is_canonical(sets: &[Members]) -> bool {
    fn go(sets: &[Members], used: u32, names: Names) -> bool {
        let depth = used.count_ones() as usize;
        depth == sets.len()
            || (0..sets.len()).filter(|set| used >> set & 1 == 0).all(|set| {
                let mut names = names;
                let members = names.of(sets[set]);
                members > sets[depth] || members == sets[depth] && go(sets, used | 1 << set, names)
            })
    }
    go(sets, 0, Names::new())
}

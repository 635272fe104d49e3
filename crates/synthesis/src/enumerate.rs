//! All structures of a class, each once, in the order of their canonical words.
//!
//! Words grow set by set. The first sets of a canonical word are canonical themselves: an order of them with a
//! smaller word would make the whole word smaller. So a prefix that is not canonical is left at once, and
//! nothing has to be remembered to find each structure once.

use crate::class::Class;
use crate::kind::Kind;
use crate::structure::{FIRST_OTHER, INPUT, Link, Members, Names, OUTPUT, Structure, mask};

/// All structures of a class.
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
    Words { class, canonical: true, sets: Vec::new(), visit }.go(0, FIRST_OTHER);
}

/// Calls `visit` with every word: every structure in every order of its sets, the other links numbered as they first
/// occur. Orders that an automorphism makes equal are one word.
pub fn for_each_word(class: Class, visit: &mut impl FnMut(&[Members])) {
    Words { class, canonical: false, sets: Vec::new(), visit }.go(0, FIRST_OTHER);
}

struct Words<'v, V> {
    class: Class,
    canonical: bool,
    sets: Vec<Members>,
    visit: &'v mut V,
}

impl<V: FnMut(&[Members])> Words<'_, V> {
    /// Adds a set to words whose sets touch `touched`, whose next new link is `next`.
    fn go(&mut self, touched: u32, next: Link) {
        let left = self.class.sets() - self.sets.len();
        if left == 0 {
            if self.class.kind() == Kind::AllSparse || is_joined(&self.sets) {
                (self.visit)(&self.sets);
            }
            return;
        }
        let core = self.class.kind() == Kind::Core;
        let first = u8::from(core);
        let last = u8::try_from(self.class.links()).unwrap_or(u8::MAX);
        for sun in first..=next.min(last) {
            let next = next + u8::from(sun == next);
            for ring in (first..=next.min(last)).filter(|ring| *ring != sun) {
                let next = next + u8::from(ring == next);
                for carrier in (first..=next.min(last)).filter(|carrier| *carrier != sun && *carrier != ring)
                {
                    let next = next + u8::from(carrier == next);
                    let members = [sun, ring, carrier];
                    let touched = touched | mask(&members);
                    if missing(core, touched, last, next) > 3 * (left - 1) {
                        continue;
                    }
                    if !stays_sparse(&self.sets, &members) {
                        continue;
                    }
                    self.sets.push(members);
                    if !self.canonical || is_canonical(&self.sets) {
                        self.go(touched, next);
                    }
                    self.sets.pop();
                }
            }
        }
    }
}

/// How many links still need a member.
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

//! Structures: how the members of simple sets are tied.
//!
//! A structure is a list of sets, each the links of its sun, ring and carrier. Link 0 is the housing, 1 the
//! input, 2 the output; the others are named `a`, `b`, `c` …. Two structures are equal if they differ only in
//! the order of the sets and in the names of the other links. Of the equal ones the least word represents the
//! structure, with the other links numbered as they first occur: the *canonical word*.
//!
//! # Double-planet sets
//! Some sets may be double-planet sets. For speeds such a set is a simple one with ring and carrier
//! exchanged:
//!
//! ```text
//! (ω_s − ω_H) − k·(ω_r − ω_H) = 0   is   ω_s + k′·ω_H − (1 + k′)·ω_r = 0   with k′ = k − 1
//! ```
//!
//! So the word has its sun, *carrier* and *ring*, in this order, and its `k′`. Double-planet sets come after
//! the simple ones; the canonical word is the least of those that keep this. Written, a structure shows sun,
//! ring and carrier of the real set and a star: `0-1-c x-2-h y-2-h*`.

use crate::Error;
use std::fmt;
use std::str::FromStr;

/// A link: 0 the housing, 1 the input, 2 the output, from 3 on the others.
pub type Link = u8;

/// The housing.
pub const HOUSING: Link = 0;
/// The input.
pub const INPUT: Link = 1;
/// The output.
pub const OUTPUT: Link = 2;
/// The first of the other links.
pub(crate) const FIRST_OTHER: Link = 3;

/// Links of the sun, the ring and the carrier of a set.
pub type Members = [Link; 3];

/// A structure in its canonical word.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Structure {
    sets: Vec<Members>,
    links: usize,
    /// Number of double-planet sets, which are the last.
    double: usize,
}

/// The name of a link: `0`, `1`, `2`, `a`, `b` ….
#[must_use]
pub fn link_name(link: Link) -> char {
    match link {
        HOUSING..=OUTPUT => char::from(b'0' + link),
        _ => char::from(b'a' + (link - FIRST_OTHER)),
    }
}

/// The link with a name, as [`link_name`] gives it.
#[must_use]
pub fn link_of_name(name: char) -> Option<Link> {
    (0..=Link::try_from(crate::class::MOST_LINKS).ok()?).find(|link| link_name(*link) == name)
}

impl Structure {
    /// Structure of these sets with this number of moving links, in its canonical word.
    ///
    /// # Errors
    /// [`Error::NotAStructure`] where a link is beyond `links` or on no member, a set has a link twice, or
    /// some sets touch too few links.
    pub fn new(sets: &[Members], links: usize) -> Result<Self, Error> {
        Self::canonical(sets, links).map(|(structure, _)| structure)
    }

    /// Structure of these sets, and the order in which the canonical word takes them.
    ///
    /// # Errors
    /// Errors of [`Structure::new`].
    pub fn canonical(sets: &[Members], links: usize) -> Result<(Self, Vec<usize>), Error> {
        Self::check(sets, links)?;
        let (sets, order) = canonical_word(sets);
        Ok((Self { sets, links, double: 0 }, order))
    }

    /// Structure of simple and double-planet sets: links of sun, ring and carrier of each real set, and
    /// whether it is a double-planet set.
    ///
    /// # Errors
    /// Errors of [`Structure::new`].
    pub fn with_kinds(sets: &[(Members, bool)], links: usize) -> Result<(Self, Vec<usize>), Error> {
        let words: Vec<Members> = sets.iter().map(|(members, double)| exchanged(*members, *double)).collect();
        Self::check(&words, links)?;
        let double = sets.iter().filter(|(_, double)| *double).count();
        if double == 0 {
            return Self::canonical(&words, links);
        }
        let (sets, order) = least_word(&words, &|set| sets[set].1);
        Ok((Self { sets, links, double }, order))
    }

    /// Refuses sets that do not form a structure.
    fn check(sets: &[Members], links: usize) -> Result<(), Error> {
        let fault = if links > crate::class::MOST_LINKS || sets.len() > crate::class::MOST_SETS {
            Some("it has too many sets or links")
        } else if sets.iter().flatten().any(|&link| usize::from(link) > links) {
            Some("a set is on a link beyond the last")
        } else if !(3..=links).all(|link| sets.iter().any(|members| mask(members) >> link & 1 == 1)) {
            Some("a link is on no member")
        } else if sets.iter().any(|[s, r, c]| s == r || s == c || r == c) {
            Some("a set has a link twice, so that it turns as a block")
        } else if !is_sparse(sets) {
            Some("some sets share so many links that they lock each other or repeat each other")
        } else {
            None
        };
        match fault {
            Some(why) => Err(Error::NotAStructure { name: word(sets), why }),
            None => Ok(()),
        }
    }

    /// Structure of a word that is canonical already.
    pub(crate) const fn of_canonical_word(sets: Vec<Members>, links: usize) -> Self {
        Self { sets, links, double: 0 }
    }

    /// Structures with this number of double-planet sets among these, in which any may be double; each once.
    #[must_use]
    pub fn with_double_planets(&self, count: usize) -> Vec<Self> {
        let sets = self.sets.len();
        let masks = (0..1u32 << sets).filter(|mask| mask.count_ones() as usize == count);
        let tagged = masks.map(|mask| {
            let (sets, _) = least_word(&self.sets, &|set| mask >> set & 1 == 1);
            Self { sets, links: self.links, double: count }
        });
        let mut all: Vec<Self> = tagged.collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// Number of double-planet sets, which are the last.
    #[must_use]
    pub const fn double_planets(&self) -> usize {
        self.double
    }

    /// Whether the set at this place is a double-planet set.
    #[must_use]
    pub const fn is_double_planet(&self, place: usize) -> bool {
        place + self.double >= self.sets.len()
    }

    /// Links of sun, ring and carrier of the set at this place; for a double-planet set those of the real
    /// set.
    ///
    /// # Panics
    /// For a place beyond the last set.
    #[must_use]
    pub fn members(&self, place: usize) -> Members {
        exchanged(self.sets[place], self.is_double_planet(place))
    }

    /// Sun, ring and carrier of each set, of a double-planet set sun, carrier and ring.
    #[must_use]
    pub fn sets(&self) -> &[Members] {
        &self.sets
    }

    /// `L`, how many moving links.
    #[must_use]
    pub const fn links(&self) -> usize {
        self.links
    }

    /// `F = L − n`, degrees of freedom without shift elements.
    #[must_use]
    pub fn freedom(&self) -> usize {
        self.links - self.sets.len()
    }

    /// Orders of the sets that give the same word: the automorphisms, at least the order itself.
    #[must_use]
    pub fn automorphisms(&self) -> Vec<Vec<usize>> {
        let mut found = Vec::new();
        for_each_order(self.sets.len(), &mut |order| {
            let keeps_kinds = order
                .iter()
                .enumerate()
                .all(|(place, set)| self.is_double_planet(place) == self.is_double_planet(*set));
            if keeps_kinds && relabelled(&self.sets, order) == self.sets {
                found.push(order.to_vec());
            }
        });
        found
    }

    /// New names of the other links under an order of the sets that gives the same word:
    /// `new = renaming[old]`.
    #[must_use]
    pub fn renaming(&self, order: &[usize]) -> Vec<Link> {
        let mut names: Vec<Link> = (0..=u8::try_from(self.links).unwrap_or(u8::MAX)).collect();
        for (place, &set) in order.iter().enumerate() {
            for (from, to) in self.sets[set].iter().zip(self.sets[place]) {
                names[usize::from(*from)] = to;
            }
        }
        names
    }
}

/// Whether any `m` sets touch at least `m + 2` links.
#[must_use]
pub(crate) fn is_sparse(sets: &[Members]) -> bool {
    let touched: Vec<u32> = sets.iter().map(mask).collect();
    (1..1u32 << sets.len()).all(|chosen| {
        let links =
            (0..sets.len()).filter(|set| chosen >> set & 1 == 1).fold(0, |all, set| all | touched[set]);
        links.count_ones() >= chosen.count_ones() + 2
    })
}

/// The links of a set as bits.
pub(crate) fn mask(members: &Members) -> u32 {
    members.iter().fold(0, |all, link| all | 1 << link)
}

/// The members of a set; of a double-planet set with ring and carrier exchanged, as the word has them, or the
/// real one.
const fn exchanged([sun, ring, carrier]: Members, is_double_planet: bool) -> Members {
    if is_double_planet { [sun, carrier, ring] } else { [sun, ring, carrier] }
}

/// Least word over the orders with the double-planet sets after the others, and the first order that gives
/// it.
fn least_word(sets: &[Members], is_double_planet: &dyn Fn(usize) -> bool) -> (Vec<Members>, Vec<usize>) {
    let mut least: Option<(Vec<Members>, Vec<usize>)> = None;
    for_each_order(sets.len(), &mut |order| {
        if order.iter().map(|set| is_double_planet(*set)).is_sorted() {
            let word = relabelled(sets, order);
            if least.as_ref().is_none_or(|(least, _)| word < *least) {
                least = Some((word, order.to_vec()));
            }
        }
    });
    least.unwrap_or_default()
}

/// The sets in this order, the other links numbered as they first occur.
fn relabelled(sets: &[Members], order: &[usize]) -> Vec<Members> {
    let mut names = Names::new();
    order.iter().map(|&set| names.of(sets[set])).collect()
}

/// Names of the other links, given as they occur.
#[derive(Clone, Copy)]
pub(crate) struct Names {
    of: [Link; 16],
    next: Link,
}

impl Names {
    pub(crate) fn new() -> Self {
        let mut of = [0; 16];
        (of[1], of[2]) = (INPUT, OUTPUT);
        Self { of, next: FIRST_OTHER }
    }

    /// The members under their new names.
    pub(crate) fn of(&mut self, members: Members) -> Members {
        members.map(|link| {
            let name = &mut self.of[usize::from(link)];
            if link >= FIRST_OTHER && *name == 0 {
                *name = self.next;
                self.next += 1;
            }
            *name
        })
    }
}

/// The least word over all orders of the sets, and the order that gives it: set by set the least
/// continuation, where several are equal all of them.
pub(crate) fn canonical_word(sets: &[Members]) -> (Vec<Members>, Vec<usize>) {
    struct Search<'s> {
        sets: &'s [Members],
        order: Vec<usize>,
        word: Vec<Members>,
        best: Option<(Vec<Members>, Vec<usize>)>,
    }
    impl Search<'_> {
        fn go(&mut self, names: Names) {
            let depth = self.order.len();
            if depth == self.sets.len() {
                if self.best.as_ref().is_none_or(|(best, _)| self.word < *best) {
                    self.best = Some((self.word.clone(), self.order.clone()));
                }
                return;
            }
            let left: Vec<(Members, usize, Names)> = (0..self.sets.len())
                .filter(|set| !self.order.contains(set))
                .map(|set| {
                    let mut names = names;
                    (names.of(self.sets[set]), set, names)
                })
                .collect();
            let Some(least) = left.iter().map(|(members, ..)| *members).min() else { return };
            for (members, set, names) in left {
                if members == least {
                    self.order.push(set);
                    self.word.push(members);
                    let worse = self.best.as_ref().is_some_and(|(best, _)| self.word[..] > best[..=depth]);
                    if !worse {
                        self.go(names);
                    }
                    self.order.pop();
                    self.word.pop();
                }
            }
        }
    }
    let mut search = Search { sets, order: Vec::new(), word: Vec::new(), best: None };
    search.go(Names::new());
    search.best.unwrap_or_default()
}

/// Calls `visit` with every order of `count` things.
pub(crate) fn for_each_order(count: usize, visit: &mut impl FnMut(&[usize])) {
    fn go(order: &mut Vec<usize>, from: usize, visit: &mut impl FnMut(&[usize])) {
        if from == order.len() {
            return visit(order);
        }
        for other in from..order.len() {
            order.swap(from, other);
            go(order, from + 1, visit);
            order.swap(from, other);
        }
    }
    go(&mut (0..count).collect(), 0, visit);
}

/// `a-b-c a-d-1`: sun, ring and carrier of each set.
fn word(sets: &[Members]) -> String {
    let set = |members: &Members| members.map(|link| link_name(link).to_string()).join("-");
    sets.iter().map(set).collect::<Vec<_>>().join(" ")
}

impl fmt::Display for Structure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sets: Vec<String> = (0..self.sets.len())
            .map(|place| {
                let star = if self.is_double_planet(place) { "*" } else { "" };
                format!("{}{star}", word(&[self.members(place)]))
            })
            .collect();
        f.pad(&sets.join(" "))
    }
}

impl FromStr for Structure {
    type Err = Error;

    /// Reads `a-b-c a-d-1 d-f-g f-c-2*`: sun, ring and carrier of each set, a star behind a double-planet
    /// set; 0 the housing, 1 the input, 2 the output, any letters for the others. Its links are those named.
    fn from_str(text: &str) -> Result<Self, Error> {
        Self::read(text).map(|(structure, _)| structure)
    }
}

impl Structure {
    /// Reads a structure, and returns for each link of the canonical word its letter in the text. Input and
    /// output count as links even if no member is on them.
    ///
    /// # Errors
    /// [`Error::NotAStructure`].
    pub fn read(text: &str) -> Result<(Self, Vec<char>), Error> {
        let fault = |why| Error::NotAStructure { name: text.trim().into(), why };
        let mut letters: Vec<char> = vec!['0', '1', '2'];
        let mut link = |name: &str| -> Option<Link> {
            let mut characters = name.trim().chars();
            let (letter, None) = (characters.next()?, characters.next()) else { return None };
            if !(letter.is_ascii_lowercase() || ('0'..='2').contains(&letter)) {
                return None;
            }
            let place = letters.iter().position(|known| *known == letter).unwrap_or_else(|| {
                letters.push(letter);
                letters.len() - 1
            });
            u8::try_from(place).ok()
        };
        let mut read = Vec::new();
        for set in text.split_whitespace() {
            let (set, is_double_planet) =
                set.strip_suffix('*').map_or((set, false), |members| (members, true));
            let members: Option<Vec<Link>> = set.split('-').map(&mut link).collect();
            let members = members
                .ok_or_else(|| fault("a link is 0 (housing), 1 (input), 2 (output) or a small letter"))?;
            let members: Members = members
                .try_into()
                .map_err(|_| fault("a set has three links, its sun, ring and carrier: a-b-c"))?;
            read.push((members, is_double_planet));
        }
        if read.is_empty() {
            return Err(fault("it has no set"));
        }
        let (structure, order) = Self::with_kinds(&read, letters.len() - 1)?;
        let mut names = letters.clone();
        for (place, &set) in order.iter().enumerate() {
            for (canonical, given) in structure.members(place).iter().zip(read[set].0) {
                names[usize::from(*canonical)] = letters[usize::from(given)];
            }
        }
        Ok((structure, names))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_links_and_the_order_of_sets_do_not_matter() {
        let one: Structure = "a-b-c a-d-1 d-f-g f-c-2".parse().unwrap();
        let other: Structure = "f-c-2 z-d-1 d-f-g z-b-c".parse().unwrap();
        assert_eq!(one, other);
        assert_eq!((one.links(), one.freedom()), (8, 4));
    }

    #[test]
    fn double_planet_sets_are_read_as_they_are_written() {
        for text in ["0-1-c x-2-h y-h-2", "1-a-b c-2-a", "a-b-c a-d-1 d-f-g f-c-2"] {
            let simple: Structure = text.parse().unwrap();
            for count in 0..=2 {
                for tagged in simple.with_double_planets(count) {
                    let read: Structure = tagged.to_string().parse().unwrap();
                    assert_eq!((&read, read.double_planets()), (&tagged, count), "{tagged}");
                }
            }
        }
        // Its word has ring and carrier exchanged; the letters are those given.
        let (structure, letters) = Structure::read("y-2-h* 0-1-c x-2-h").unwrap();
        assert_eq!(structure.to_string(), "0-1-a b-2-c d-2-c*");
        assert_eq!(structure.sets()[2], [6, 5, 2]);
        assert_eq!(letters, ['0', '1', '2', 'c', 'x', 'h', 'y']);
    }

    #[test]
    fn the_canonical_word_is_the_least_of_all_orders() {
        let sets = [[5, 4, 3], [5, 6, 1], [6, 7, 8], [7, 3, 2]];
        let (word, order) = canonical_word(&sets);
        let mut least = None;
        for_each_order(4, &mut |order| {
            let word = relabelled(&sets, order);
            if least.as_ref().is_none_or(|least| word < *least) {
                least = Some(word);
            }
        });
        assert_eq!(Some(&word), least.as_ref());
        assert_eq!(relabelled(&sets, &order), word);
    }

    #[test]
    fn two_equal_sets_back_to_back_have_an_automorphism_that_renames_their_links() {
        // Set 1 a-b-1, set 2 c-d-1: exchanging them renames a and c, b and d.
        let structure: Structure = "a-b-1 c-d-1 e-f-2".parse().unwrap();
        let automorphisms = structure.automorphisms();
        assert_eq!(automorphisms.len(), 2);
        for order in automorphisms {
            let names = structure.renaming(&order);
            let renamed: Vec<Members> =
                order.iter().map(|&set| structure.sets()[set].map(|link| names[usize::from(link)])).collect();
            assert_eq!(renamed, structure.sets());
        }
    }

    #[test]
    fn what_is_no_structure_is_refused_with_its_fault() {
        for (text, why) in [
            ("a-a-1", "a link twice"),
            ("a-1-2 1-a-2", "share so many links"),
            ("0-1-a 0-a-1", "share so many links"),
            ("a-1", "three links"),
            ("A-1-2", "small letter"),
            ("", "no set"),
        ] {
            let message = text.parse::<Structure>().unwrap_err().to_string();
            assert!(message.contains(why), "{text}: {message}");
        }
    }
}

//! The motion of a structure under every set of engaged elements.
//!
//! # Formula
//! A set ties its links by `(ω_s − ω_H) + k·(ω_r − ω_H) = 0`, an engaged element two links by
//! `ω_u − ω_v = 0`. The `n` sets and `e = F − 1` elements are the rows of a matrix. The speed of link `v` is,
//! up to a factor common to all links, the determinant of these rows and one more with a 1 at `v`:
//!
//! ```text
//! ω_v ∝ det(sets, elements, v) = Σ_S (Π_{i∈S} k_i)·D_v(S)        i = ω_1/ω_2
//! ```
//!
//! In `D_v(S)` a set of `S` has the row of its edge ring–carrier, any other that of sun–carrier. This is the
//! incidence matrix of a graph, so `D_v(S)` is 1 or −1 if the edges form a tree with the housing, else 0.
//!
//! # How it is computed
//! The edges of the sets alone leave `F` groups of links apart from the housing's, or have a circle; then
//! `D_v(S) = 0` for all elements. Modulo the rows of the sets a link is the axis of its group, and an element
//! the difference of two axes. `D_v(S)` is a determinant of `F` rows, times a sign of `S`. All `S` are
//! calculated at once, as bits of [`Ternary`] words. Sets of elements that begin alike share the products of
//! the first elements.

use crate::exterior::Space;
use crate::structure::{HOUSING, INPUT, Link, Members, OUTPUT, Structure};
use crate::ternary::{Ternary, Word};

/// A shift element: the links that it joins, the lesser first. With the housing it is a brake.
pub type Element = [Link; 2];

/// Input and output speed of a gear up to a common factor: `i = input/output`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Speeds<W> {
    /// The polynomial of the input's speed.
    pub input: Ternary<W>,
    /// The polynomial of the output's speed.
    pub output: Ternary<W>,
}

/// Pairs of links that an element may join: none brakes the input or the output.
#[must_use]
pub fn elements(links: usize) -> Vec<Element> {
    let links = Link::try_from(links).unwrap_or(Link::MAX);
    let pairs = (0..=links).flat_map(|one| (one + 1..=links).map(move |other| [one, other]));
    pairs.filter(|pair| *pair != [HOUSING, INPUT] && *pair != [HOUSING, OUTPUT]).collect()
}

/// Room for the vectors of a structure, used again for the next.
pub struct Motion<W> {
    space: Space,
    freedom: usize,
    /// Axis of each link modulo the sets, signed by `S`.
    axes: Vec<Vec<Ternary<W>>>,
    /// Difference of the axes of each element's links, without the sign of `S`.
    differences: Vec<Vec<Ternary<W>>>,
    /// Products of each pair of axes and each element with input and output.
    with_ends: Vec<Vec<Speeds<W>>>,
    /// Products of the first elements, by degree.
    products: Vec<Vec<Ternary<W>>>,
    /// Speeds with each of the last elements.
    last: Vec<Speeds<W>>,
}

impl<W: Word> Motion<W> {
    /// Prepares for structures of this number of degrees of freedom, at least 2.
    #[must_use]
    pub fn new(freedom: usize) -> Self {
        let space = Space::new(freedom);
        let products =
            (0..freedom.max(1)).map(|degree| vec![Ternary::default(); space.coordinates(degree)]).collect();
        Self {
            space,
            freedom,
            axes: Vec::new(),
            differences: Vec::new(),
            with_ends: Vec::new(),
            products,
            last: Vec::new(),
        }
    }

    /// Takes up a structure and the elements that gears may engage.
    pub fn take(&mut self, structure: &Structure, elements: &[Element]) {
        debug_assert_eq!(
            structure.freedom(),
            self.freedom,
            "the structure has the freedom this was made for"
        );
        let links = structure.links() + 1;
        let none = vec![Ternary::default(); self.freedom];
        self.axes.clear();
        self.axes.resize(links, none.clone());
        let mut unsigned = self.axes.clone();
        for chosen in 0..1usize << structure.sets().len() {
            let Some((groups, negative)) = groups(structure.sets(), links, chosen) else { continue };
            let bit = W::bit(chosen);
            for (link, group) in groups.iter().enumerate() {
                if let Some(axis) = group {
                    let (signed, plain) = (&mut self.axes[link][*axis], &mut unsigned[link][*axis]);
                    plain.plus = plain.plus | bit;
                    if negative {
                        signed.minus = signed.minus | bit;
                    } else {
                        signed.plus = signed.plus | bit;
                    }
                }
            }
        }
        self.differences.clear();
        self.differences.extend(elements.iter().map(|[one, other]| {
            let (one, other) = (&unsigned[usize::from(*one)], &unsigned[usize::from(*other)]);
            one.iter().zip(other).map(|(one, other)| one.difference(*other)).collect::<Vec<_>>()
        }));
        self.join_ends();
    }

    /// Leaves only some of the elements, by their places.
    pub fn keep(&mut self, places: &[usize]) {
        self.differences = places.iter().map(|place| std::mem::take(&mut self.differences[*place])).collect();
        self.join_ends();
    }

    /// The products of each element with input and output.
    fn join_ends(&mut self) {
        let end = |element: &[Ternary<W>], link: Link, first, second| {
            Space::minor(element, &self.axes[usize::from(link)], first, second)
        };
        self.with_ends.clear();
        self.with_ends.extend(self.space.pairs().iter().map(|&(_, first, second, _)| {
            self.differences
                .iter()
                .map(|element| Speeds {
                    input: end(element, INPUT, first, second),
                    output: end(element, OUTPUT, first, second),
                })
                .collect::<Vec<_>>()
        }));
    }

    /// Whether two elements lock the same: where one is engaged, the other turns without slip, whatever the
    /// `k`.
    ///
    /// Then the rows of the sets, of these two and of any others have determinant 0: their product is 0.
    #[must_use]
    pub fn tie_the_same(&self, one: usize, other: usize) -> bool {
        let (one, other) = (&self.differences[one], &self.differences[other]);
        let mut pairs = self.space.pairs().iter();
        pairs.all(|&(_, first, second, _)| Space::minor(one, other, first, second).is_zero())
    }

    /// Calls `visit` with each choice of `F − 1` elements, as their places but the last in rising order, and
    /// the speeds that each last element after them gives.
    pub fn for_each_gear(&mut self, visit: &mut impl FnMut(&[usize], &[Speeds<W>])) {
        let one = Ternary { plus: !W::default(), minus: W::default() };
        self.products[0][0] = one;
        self.go(&mut Vec::with_capacity(self.freedom), visit);
    }

    fn go(&mut self, chosen: &mut Vec<usize>, visit: &mut impl FnMut(&[usize], &[Speeds<W>])) {
        let from = chosen.last().map_or(0, |last| last + 1);
        if chosen.len() + 2 == self.freedom {
            let mut last = std::mem::take(&mut self.last);
            self.complete(from, &mut last);
            visit(chosen, &last);
            self.last = last;
            return;
        }
        for element in from..self.differences.len() {
            let degree = chosen.len() + 1;
            let (below, above) = self.products.split_at_mut(degree);
            self.space.multiply(degree, &below[degree - 1], &self.differences[element], &mut above[0]);
            chosen.push(element);
            self.go(chosen, visit);
            chosen.pop();
        }
    }

    /// The speeds that each element from `from` on gives with the product of the others.
    fn complete(&self, from: usize, result: &mut Vec<Speeds<W>>) {
        let count = self.differences.len() - from;
        result.clear();
        result.resize(count, Speeds::default());
        let product = &self.products[self.freedom - 2];
        for (&(place, _, _, change), ends) in self.space.pairs().iter().zip(&self.with_ends) {
            let factor = if change { product[place].negated() } else { product[place] };
            if factor.is_zero() {
                continue;
            }
            for (speeds, end) in result.iter_mut().zip(&ends[from..]) {
                speeds.input = speeds.input.sum(factor.times(end.input));
                speeds.output = speeds.output.sum(factor.times(end.output));
            }
        }
    }

    /// Returns the speeds with these elements, `F − 1` of them.
    ///
    /// # Panics
    /// With more or fewer elements.
    #[must_use]
    pub fn gear(&mut self, elements: &[usize]) -> Speeds<W> {
        assert_eq!(
            elements.len() + 1,
            self.freedom,
            "a gear engages one element less than there are degrees of freedom"
        );
        self.products[0][0] = Ternary { plus: !W::default(), minus: W::default() };
        let (last, first) = elements.split_last().expect("a gear engages an element");
        for (degree, element) in (1..).zip(first) {
            let (below, above) = self.products.split_at_mut(degree);
            self.space.multiply(degree, &below[degree - 1], &self.differences[*element], &mut above[0]);
        }
        let mut speeds = Vec::new();
        self.complete(*last, &mut speeds);
        speeds[0]
    }
}

/// Group of each link by the edges of the sets, `None` for the housing's group, and whether the determinant
/// of these edges and one link of each group is −1. The result is `None` if the edges have a circle.
fn groups(sets: &[Members], links: usize, chosen: usize) -> Option<(Vec<Option<usize>>, bool)> {
    let edges: Vec<[usize; 2]> = sets
        .iter()
        .enumerate()
        .map(|(set, [sun, ring, carrier])| {
            [usize::from(if chosen >> set & 1 == 1 { *ring } else { *sun }), usize::from(*carrier)]
        })
        .collect();
    // The lowest link stands for its group.
    let mut lowest: Vec<usize> = (0..links).collect();
    for [one, other] in &edges {
        let (one, other) = (lowest[*one], lowest[*other]);
        if one == other {
            return None;
        }
        let (to, from) = (one.min(other), one.max(other));
        lowest.iter_mut().filter(|link| **link == from).for_each(|link| *link = to);
    }
    let stand: Vec<usize> = (1..links).filter(|link| lowest[*link] == *link).collect();
    let groups = lowest.iter().map(|lowest| stand.iter().position(|link| link == lowest)).collect();
    Some((groups, is_negative(&edges, &stand, links)))
}

/// Whether the determinant of the edges' rows and the standing links' unit rows is −1, the housing's column
/// left out.
fn is_negative(edges: &[[usize; 2]], stand: &[usize], links: usize) -> bool {
    let mut rows: Vec<Vec<i8>> = edges
        .iter()
        .map(|[from, to]| {
            let mut row = vec![0; links];
            (row[*from], row[*to]) = (1, -1);
            row[1..].to_vec()
        })
        .collect();
    rows.extend(stand.iter().map(|link| {
        let mut row = vec![0; links - 1];
        row[link - 1] = 1;
        row
    }));
    let mut negative = false;
    for column in 0..rows.len() {
        let Some(pivot) = (column..rows.len()).find(|row| rows[*row][column] != 0) else { return false };
        if pivot != column {
            rows.swap(pivot, column);
            negative = !negative;
        }
        negative ^= rows[column][column] < 0;
        let (above, below) = rows.split_at_mut(column + 1);
        let pivot = &above[column];
        for row in below {
            let factor = row[column] * pivot[column];
            if factor != 0 {
                row.iter_mut().zip(pivot).for_each(|(entry, pivot)| *entry -= factor * pivot);
            }
        }
    }
    negative
}

//! Families of solutions: those whose gears have equal formulas.
//!
//! Two solutions are of one family if they have the same of the wanted gears and, after an exchange of sets,
//! have equal formulas one by one. Sets are exchanged only with sets of their own kind with the same range of
//! `k`. So the members have the same ratios at every `k`, the same best `k` and the same ranges, each up to
//! the exchange. They differ inside: in efficiency, torques, slips, speeds, and whether they can be drawn.
//! The formulas compared are those with which a solution is listed.
//!
//! # How it is computed
//! The least of the formulas under all exchanges, by their words, represents the family: two families are
//! equal if their least formulas are.

use crate::permutation::Exchange;
use crate::structure::for_each_order;
use crate::wish::Wish;
use crate::work::Found;
use rustc_hash::FxHashMap;

/// Common properties of the members of a family.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Family {
    /// Places of the wanted gears that the members have.
    gears: Vec<usize>,
    /// Bits of the ends of the range of `k` of each set.
    ranges: Vec<[u64; 2]>,
    double_planets: usize,
    /// The words of the gears' formulas, under the exchange that makes them least.
    formulas: Vec<[u64; 4]>,
}

impl Family {
    /// The family of a solution of a wish, whose gears are these of those wanted, by their places.
    #[must_use]
    pub fn of(found: &Found, wish: &Wish, gears: &[usize]) -> Self {
        let ratios = &found.solution.gears;
        let is_double = |set: usize| found.structure.is_double_planet(set);
        let mut least: Option<Vec<[u64; 4]>> = None;
        for_each_order(wish.k.len(), &mut |order| {
            let alike = |(place, set): (usize, &usize)| {
                wish.k[place] == wish.k[*set] && is_double(place) == is_double(*set)
            };
            if order.iter().enumerate().all(alike) {
                let exchange = Exchange::new(order);
                let formulas: Vec<_> = ratios.iter().map(|gear| exchange.ratio(gear.ratio).words()).collect();
                if least.as_ref().is_none_or(|least| formulas < *least) {
                    least = Some(formulas);
                }
            }
        });
        Self {
            gears: gears.to_vec(),
            ranges: wish.k.iter().map(|range| [range.start().to_bits(), range.end().to_bits()]).collect(),
            double_planets: found.structure.double_planets(),
            formulas: least.unwrap_or_default(),
        }
    }
}

/// The numbers of the families of some solutions, from 0 in the order in which they first occur, and how many
/// members each has.
#[must_use]
pub fn number<'a>(families: impl IntoIterator<Item = &'a Family>) -> (Vec<usize>, Vec<usize>) {
    let mut known: FxHashMap<&Family, usize> = FxHashMap::default();
    let mut members = Vec::new();
    let numbers = families
        .into_iter()
        .map(|family| {
            let number = *known.entry(family).or_insert(members.len());
            if number == members.len() {
                members.push(0);
            }
            members[number] += 1;
            number
        })
        .collect();
    (numbers, members)
}

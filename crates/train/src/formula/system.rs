//! The equations that the ratio of a gear needs, and their determinants.

use super::polynomial::{Polynomial, Product};
use super::symbol::Symbol;
use crate::elimination::Scalar;
use crate::groups::Groups;
use crate::state::speed_relations;
use crate::topology::{Topology, bounded, fractions, traced};
use crate::{Gear, Gearbox, LinkId};
use epicyclic_gears::simple_set::Fraction;
use std::collections::{BTreeMap, BTreeSet};

/// Two links that a set makes one: two of its members turn as one and take the third along, or `i₀ = 1`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Tied {
    /// Place of the equation in the gearbox.
    pub(super) equation: usize,
    /// The links.
    pub(super) links: [LinkId; 2],
    /// Whether all three members turn as one.
    pub(super) is_block: bool,
}

/// The equations that the output's speed needs, over nodes.
#[derive(Debug, Clone)]
pub(crate) struct System {
    /// The gear, members that turn as a block joined.
    topology: Topology,
    /// Places in the gearbox.
    equations: Vec<usize>,
    /// Nodes whose speeds the equations settle: as many, the output's among them.
    unknowns: Vec<usize>,
    /// Links that sets tie.
    tied: Vec<Tied>,
    /// Equations that follow from others.
    spare: Vec<usize>,
}

impl System {
    /// Makes the system of a gear that has a ratio; `None` if speeds that nothing gives cancel at these
    /// ratios alone.
    pub(super) fn new(gearbox: &Gearbox, gear: &Gear) -> Option<Self> {
        let (topology, tied) = joined(gearbox, Topology::new(gearbox, gear));
        let (pivots, free) = relations(gearbox, &topology);
        let chosen = |node: usize| free.contains(&node) && Some(node) != topology.input;
        let is_unknown = |node: usize| !free.contains(&node) && Some(node) != topology.input;
        let nodes = |equation: usize| topology.equations[equation].into_iter().flatten();
        let settles = matching(&pivots, topology.count, &|equation| {
            nodes(equation).filter(|node| is_unknown(*node)).collect()
        });
        let (mut equations, mut unknowns) = (BTreeSet::new(), BTreeSet::new());
        let mut waiting: Vec<usize> = topology.output.into_iter().filter(|node| is_unknown(*node)).collect();
        while let Some(node) = waiting.pop() {
            if !unknowns.insert(node) {
                continue;
            }
            let equation = settles[node]?;
            equations.insert(equation);
            if nodes(equation).any(chosen) {
                return None;
            }
            waiting.extend(nodes(equation).filter(|node| is_unknown(*node)));
        }
        let is_block = |equation: &usize| is_joined(topology.equations[*equation]);
        let spare =
            (0..gearbox.equations.len()).filter(|one| !pivots.contains(one) && !is_block(one)).collect();
        Some(Self {
            equations: equations.into_iter().collect(),
            unknowns: unknowns.into_iter().collect(),
            topology,
            tied,
            spare,
        })
    }

    /// The equations, by their places in the gearbox.
    pub(super) fn equations(&self) -> &[usize] {
        &self.equations
    }

    pub(super) fn topology(&self) -> &Topology {
        &self.topology
    }

    /// Links that sets tie.
    pub(super) fn tied(&self) -> &[Tied] {
        &self.tied
    }

    /// Sets with an equation that follows from others.
    pub(super) fn spare(&self, gearbox: &Gearbox) -> Vec<usize> {
        let mut sets: Vec<usize> =
            self.spare.iter().map(|&equation| gearbox.equations[equation].set).collect();
        sets.dedup();
        sets
    }

    /// `det C` and `det C_out`: speeds of input and output up to a common factor. Symbol `n` belongs to
    /// equation `n`.
    pub(super) fn determinants(&self, symbols: &[Symbol]) -> [Polynomial; 2] {
        let node = |link: LinkId| self.topology.node[link.index()];
        let rows: Vec<Vec<(Option<usize>, [i64; 2])>> = symbols
            .iter()
            .map(|symbol| {
                let [first, second, carrier] = symbol.links().map(node);
                let sign = if symbol.is_negative() { -1 } else { 1 };
                // Number and factor of the symbol: 1, −i₀, i₀ − 1.
                vec![(first, [1, 0]), (second, [0, -sign]), (carrier, [-1, sign])]
            })
            .collect();
        let column = |node: Option<usize>, replaced: bool| {
            let is_input = node.is_some() && node == self.topology.input;
            let place = if is_input && replaced { self.topology.output } else { node };
            let is_left_out = replaced && node == self.topology.output;
            let column = self.unknowns.iter().position(|unknown| Some(*unknown) == place);
            column.filter(|_| !is_left_out).map(|column| (column, if is_input { -1 } else { 1 }))
        };
        if self.unknowns.is_empty() {
            return [Polynomial::constant(1), Polynomial::constant(1)];
        }
        [false, true].map(|replaced| {
            let of = |row: &Vec<(Option<usize>, [i64; 2])>| -> Vec<(usize, [i64; 2])> {
                let entry = |(node, [number, factor]): &(Option<usize>, [i64; 2])| {
                    column(*node, replaced).map(|(column, sign)| (column, [sign * number, sign * factor]))
                };
                row.iter().filter_map(entry).collect()
            };
            determinant(&rows.iter().map(of).collect::<Vec<_>>())
        })
    }
}

/// Whether the members of an equation are one node.
fn is_joined([first, second, carrier]: [Option<usize>; 3]) -> bool {
    first == second && second == carrier
}

/// The gear with links that sets tie as one node, and these ties.
fn joined(gearbox: &Gearbox, mut topology: Topology) -> (Topology, Vec<Tied>) {
    // The housing is 0.
    let place = |node: Option<usize>| node.map_or(0, |node| node + 1);
    let mut groups = Groups::new(topology.count + 1);
    let mut tied = vec![];
    loop {
        let before = tied.len();
        for (equation, nodes) in topology.equations.iter().enumerate() {
            let [r, c, h] = nodes.map(place);
            let alike = |one: usize, other: usize| groups.root(one) == groups.root(other);
            let (rc, ch, rh) = (alike(r, c), alike(c, h), alike(r, h));
            let one = &gearbox.equations[equation];
            let is_one = one.exact.map_or(one.ratio == 1.0, |ratio| ratio == Fraction::from_integer(1));
            let [root, central, carrier] = one.links;
            let links = match (rc, ch, rh) {
                (true, false, _) if !is_one => [carrier, root],
                (false, true, _) => [root, carrier],
                (_, false, true) => [central, carrier],
                (false, false, false) if is_one => [root, central],
                _ => continue,
            };
            let [first, second] = links.map(|link| place(topology.node[link.index()]));
            groups.join(first, second);
            tied.push(Tied { equation, links, is_block: rc || ch || rh });
        }
        if tied.len() == before {
            break;
        }
    }
    let mut numbers = vec![None; topology.count + 1];
    let mut count = 0;
    for (_, number) in numbers.iter_mut().enumerate().skip(1).filter(|(node, _)| groups.root(*node) == *node)
    {
        *number = Some(count);
        count += 1;
    }
    let of = |node: Option<usize>| numbers[groups.root(place(node))];
    topology.node.iter_mut().for_each(|node| *node = of(*node));
    topology.equations.iter_mut().for_each(|nodes| *nodes = nodes.map(of));
    (topology.input, topology.output) = (of(topology.input), of(topology.output));
    topology.count = count;
    (topology, tied)
}

/// Equations that suffice, and nodes whose speeds can be chosen, by the quickest way that proves them.
fn relations(gearbox: &Gearbox, topology: &Topology) -> (Vec<usize>, Vec<usize>) {
    fn of<S: Scalar>(topology: &Topology, ratios: Option<Vec<S>>) -> Option<(Vec<usize>, Vec<usize>)> {
        let found = speed_relations(topology, &ratios?)?;
        Some((found.pivots.iter().map(|(equation, _)| *equation).collect(), found.free))
    }
    of(topology, Some(bounded(gearbox)))
        .or_else(|| of(topology, fractions(gearbox)))
        .or_else(|| of(topology, traced(gearbox)))
        .unwrap_or_else(|| unreachable!("a number is a rational, and rationals of any size do not overflow"))
}

/// An equation of its own for each node that equations settle: by augmenting paths.
fn matching(equations: &[usize], nodes: usize, of: &dyn Fn(usize) -> Vec<usize>) -> Vec<Option<usize>> {
    fn place(
        equation: usize,
        of: &dyn Fn(usize) -> Vec<usize>,
        seen: &mut [bool],
        settles: &mut [Option<usize>],
    ) -> bool {
        of(equation).into_iter().any(|node| {
            if std::mem::replace(&mut seen[node], true) {
                return false;
            }
            let is_free = match settles[node] {
                None => true,
                Some(other) => place(other, of, seen, settles),
            };
            if is_free {
                settles[node] = Some(equation);
            }
            is_free
        })
    }
    let mut settles = vec![None; nodes];
    for &equation in equations {
        place(equation, of, &mut vec![false; nodes], &mut settles);
    }
    settles
}

/// The determinant of rows of columns with number and factor of the row's symbol, row by row over sets of
/// columns.
fn determinant(rows: &[Vec<(usize, [i64; 2])>]) -> Polynomial {
    let mut minors = BTreeMap::from([(0_u32, Polynomial::constant(1))]);
    for (symbol, row) in rows.iter().enumerate() {
        let mut next: BTreeMap<u32, Polynomial> = BTreeMap::new();
        for (taken, minor) in &minors {
            for &(column, [number, factor]) in row.iter().filter(|(column, _)| taken >> column & 1 == 0) {
                let sign = if (taken >> column).count_ones() % 2 == 0 { 1 } else { -1 };
                let sum = next.entry(taken | 1 << column).or_default();
                for (product, coefficient) in minor.products() {
                    sum.add(product, sign * number * coefficient);
                    sum.add(product | (1 as Product) << symbol, sign * factor * coefficient);
                }
            }
        }
        minors = next;
    }
    minors.pop_last().map(|(_, determinant)| determinant).unwrap_or_default()
}

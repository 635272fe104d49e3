//! A gear as nodes and equations: the links that its engaged shift elements make one piece are one node.

use crate::elimination::{Bounded, Scalar, Traced};
use crate::groups::Groups;
use crate::{Gear, Gearbox, LinkId};
use epicyclic_gears::simple_set::Fraction;

/// A connection that carries torque between two links: permanent, or an engaged shift element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Edge {
    pub(crate) links: [LinkId; 2],
    /// Place of the shift element; `None` for a permanent connection.
    pub(crate) shift_element: Option<usize>,
}

/// The nodes of a gear.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Topology {
    /// Node of each link; `None` where it is one piece with the housing.
    pub(crate) node: Vec<Option<usize>>,
    pub(crate) count: usize,
    pub(crate) edges: Vec<Edge>,
    /// Whether no connection closes a loop with others.
    pub(crate) is_forest: bool,
    /// Nodes of root, central gear and carrier of each equation.
    pub(crate) equations: Vec<[Option<usize>; 3]>,
    pub(crate) input: Option<usize>,
    pub(crate) output: Option<usize>,
    /// Links of input and output.
    pub(crate) terminals: [LinkId; 2],
}

impl Topology {
    pub(crate) fn new(gearbox: &Gearbox, gear: &Gear) -> Self {
        let permanent = gearbox.permanent.iter().map(|&links| Edge { links, shift_element: None });
        let engaged = gear.engaged.iter().map(|&shift_element| Edge {
            links: gearbox.shift_elements[shift_element].links,
            shift_element: Some(shift_element),
        });
        let edges: Vec<Edge> = permanent.chain(engaged).collect();
        let mut groups = Groups::new(gearbox.links.len());
        let mut is_forest = true;
        for edge in &edges {
            is_forest &= groups.join(edge.links[0].0, edge.links[1].0);
        }
        let mut count = 0;
        let mut node: Vec<Option<usize>> = vec![None; gearbox.links.len()];
        for link in 1..node.len() {
            // A part is known by its smallest link, which comes first.
            let root = groups.root(link);
            node[link] = node[root];
            if root == link {
                node[link] = Some(count);
                count += 1;
            }
        }
        let equations = gearbox.equations.iter().map(|one| one.links.map(|link| node[link.0])).collect();
        let (input, output) = (node[gear.input.0], node[gear.output.0]);
        let terminals = [gear.input, gear.output];
        Self { node, count, edges, is_forest, equations, input, output, terminals }
    }
}

/// The factors `1, −i, i − 1` of an equation over the nodes of its three links, sums of those that share a
/// node.
///
/// Sums are taken in closed form, so that a block leaves exactly nothing. Where two members are one node, the
/// equation says that the third turns with them, and its factors are 1 and −1.
pub(crate) fn factors<S: Scalar>(nodes: [Option<usize>; 3], i: &S) -> Option<[(Option<usize>, S); 3]> {
    let none = (None, S::zero());
    let [r, c, h] = nodes;
    Some(if r == c && c == h {
        [none.clone(), none.clone(), none]
    } else if r == c {
        // (1 − i)·(ω_r − ω_H)
        let mut factor = S::one().minus(i)?;
        if factor.weight() > 0.0 {
            factor = S::one();
        }
        [(r, factor.clone()), none, (h, factor.negative()?)]
    } else if r == h || c == h {
        [(r, S::one()), (c, S::one().negative()?), none]
    } else {
        [(r, S::one()), (c, i.negative()?), (h, i.minus(&S::one())?)]
    })
}

/// Basic ratios of all equations as numbers.
pub(crate) fn numbers(gearbox: &Gearbox) -> Vec<f64> {
    gearbox.equations.iter().map(|one| one.ratio).collect()
}

/// Basic ratios of all equations as numbers with bounds on their errors.
pub(crate) fn bounded(gearbox: &Gearbox) -> Vec<Bounded<true>> {
    gearbox.equations.iter().map(|one| Bounded::rounded(one.ratio)).collect()
}

/// Basic ratios of all equations as fractions, if all are known by teeth or as decimals.
pub(crate) fn fractions(gearbox: &Gearbox) -> Option<Vec<Fraction>> {
    gearbox.equations.iter().map(|one| one.rational).collect()
}

/// Basic ratios of all equations as rationals of any size. Computed ratios, neither of teeth nor decimals,
/// are numbered.
pub(crate) fn traced(gearbox: &Gearbox) -> Option<Vec<Traced>> {
    let mut computed: Vec<f64> = vec![];
    let of = |one: &crate::gearbox::Equation| match &one.rational {
        Some(rational) => Some(Traced::certain(rational)),
        None => {
            let size = one.ratio.abs();
            let known = computed.iter().position(|other| *other == size);
            let number = known.unwrap_or(computed.len());
            if known.is_none() {
                computed.push(size);
            }
            Traced::computed(one.ratio, number)
        }
    };
    gearbox.equations.iter().map(of).collect()
}

/// The equations over the nodes, one after the other. A block whose factors cancel leaves nothing.
pub(crate) fn node_equations<'r, S: Scalar + 'r>(
    topology: &Topology,
    ratios: impl Iterator<Item = Option<&'r S>>,
) -> Option<Vec<S>> {
    let mut entries = Vec::with_capacity(topology.equations.len() * topology.count);
    for (&nodes, ratio) in topology.equations.iter().zip(ratios) {
        // Equations without a ratio are left out.
        let Some(ratio) = ratio else { continue };
        let from = entries.len();
        entries.resize(from + topology.count, S::zero());
        for (node, factor) in factors(nodes, ratio)? {
            if let Some(node) = node {
                entries[from + node] = factor;
            }
        }
    }
    Some(entries)
}

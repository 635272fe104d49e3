//! A gear as nodes and rows: the links that its engaged controls make one piece are one node.

use crate::elimination::Scalar;
use crate::groups::Groups;
use crate::{Gear, Gearbox, LinkId};
use epicyclic_gears::row::Fraction;

/// A connection that carries torque between two links: permanent, or an engaged control.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Edge {
    pub(crate) links: [LinkId; 2],
    /// Place of the control; none of a permanent connection.
    pub(crate) control: Option<usize>,
}

/// The nodes of a gear.
#[derive(Debug, Clone)]
pub(crate) struct Topology {
    /// Node of each link; `None` where it is one piece with the housing.
    pub(crate) node: Vec<Option<usize>>,
    pub(crate) count: usize,
    pub(crate) edges: Vec<Edge>,
    /// Nodes of sun, ring and carrier of each row.
    pub(crate) rows: Vec<[Option<usize>; 3]>,
    pub(crate) input: Option<usize>,
    pub(crate) output: Option<usize>,
    /// Links of input and output.
    pub(crate) terminals: [LinkId; 2],
}

impl Topology {
    pub(crate) fn new(gearbox: &Gearbox, gear: &Gear) -> Self {
        let permanent = gearbox.permanent.iter().map(|&links| Edge { links, control: None });
        let engaged = gear
            .engaged
            .iter()
            .map(|&control| Edge { links: gearbox.controls[control].links, control: Some(control) });
        let edges: Vec<Edge> = permanent.chain(engaged).collect();
        let mut groups = Groups::new(gearbox.links.len());
        for edge in &edges {
            groups.join(edge.links[0].0, edge.links[1].0);
        }
        let mut of_root = vec![None; gearbox.links.len()];
        let mut count = 0;
        let mut node = vec![None; gearbox.links.len()];
        for (link, node) in node.iter_mut().enumerate() {
            let root = groups.root(link);
            if root == 0 {
                continue;
            }
            *node = Some(*of_root[root].get_or_insert_with(|| {
                count += 1;
                count - 1
            }));
        }
        let rows = gearbox.rows.iter().map(|row| row.members.map(|link| node[link.0])).collect();
        let (input, output) = (node[gear.input.0], node[gear.output.0]);
        Self { node, count, edges, rows, input, output, terminals: [gear.input, gear.output] }
    }
}

/// Factors of a row's equation `ω_a − i₀·ω_b − (1 − i₀)·ω_H = 0`.
pub(crate) fn factors<S: Scalar>(i0: S) -> Option<[S; 3]> {
    Some([S::ONE, S::ZERO.minus(i0)?, i0.minus(S::ONE)?])
}

/// Stationary ratios of all rows as numbers.
pub(crate) fn numbers(gearbox: &Gearbox) -> Vec<f64> {
    gearbox.rows.iter().map(|row| row.ratio.get()).collect()
}

/// Stationary ratios of all rows as fractions, where the teeth of all are known.
pub(crate) fn fractions(gearbox: &Gearbox) -> Option<Vec<Fraction>> {
    gearbox.rows.iter().map(|row| row.exact).collect()
}

//! What a gear does: its state, from the rank of its equations.
//!
//! Speeds obey one equation a row; torques obey one equation a link. Both systems are brought to
//! reduced echelon form with input and output kept back, so the state is read off, not counted:
//!
//! | state | in the speeds | in the torques |
//! |---|---|---|
//! | [`InputBlocked`](State::InputBlocked) | `ω_in = 0` follows | |
//! | [`OutputFree`](State::OutputFree) | no relation holds both `ω_in` and `ω_out` | |
//! | [`Underdetermined`](State::Underdetermined) | their relation holds a further free speed | or a loaded row turns at a free speed |
//! | [`OutputAtRest`](State::OutputAtRest) | `ω_out = 0` follows, `ω_in` is free | |
//! | [`TorquesIndeterminate`](State::TorquesIndeterminate) | `ω_out = ω_in/i` | a torque in relation with the input's is free |
//! | [`Driven`](State::Driven) | `ω_out = ω_in/i` | all such torques follow |
//!
//! The first line that fits is the state. "In relation" means: in one part of the system's matroid
//! (some least relation holds both). That is how parts beside the power path are told from it: an
//! idle row that spins freely, an idle link held by two brakes at once, a row locked on its own do
//! not spoil a driven gear; they only leave their own speed or torque unnamed.

use crate::elimination::{Echelon, RANK_TOLERANCE, Scalar};
use crate::topology::{Topology, factors};
use crate::{Gearbox, LinkId};
use std::fmt;

/// State of a gear, with the links it concerns.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum State {
    /// The input drives the output at a ratio that follows from the teeth, with torques that follow
    /// from one torque.
    Driven,
    /// The input cannot turn.
    InputBlocked {
        /// Every link held at rest, the input among them.
        links: Vec<String>,
    },
    /// The output cannot turn while the input can.
    OutputAtRest {
        /// Every link held at rest, the output among them.
        links: Vec<String>,
    },
    /// No relation joins output and input: neutral.
    OutputFree {
        /// The output and the links whose speeds stand in a relation with its own.
        links: Vec<String>,
    },
    /// Input and output are related, but only together with further speeds that nothing gives: a
    /// differential with too few controls engaged.
    Underdetermined {
        /// How many further speeds must be given.
        missing: usize,
        /// The links whose speeds are not known, any of which could be held.
        links: Vec<String>,
    },
    /// Speeds follow, but torques on the power path depend on how tightly redundant controls or rows
    /// were engaged. Losses still follow where the unknown torques belong to controls alone, or to
    /// rows that turn as a block.
    TorquesIndeterminate {
        /// Links of the redundant parts.
        links: Vec<String>,
        /// Redundant controls.
        controls: Vec<String>,
        /// Rows of unknown torque.
        rows: Vec<String>,
    },
}

impl State {
    /// Whether input and output turn at a known ratio: driven, or with torques indeterminate.
    #[must_use]
    pub fn has_ratio(&self) -> bool {
        matches!(self, Self::Driven | Self::TorquesIndeterminate { .. })
    }

    /// The state's name, as in reports.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Driven => "driven",
            Self::InputBlocked { .. } => "input blocked",
            Self::OutputAtRest { .. } => "output at rest",
            Self::OutputFree { .. } => "output free",
            Self::Underdetermined { .. } => "underdetermined",
            Self::TorquesIndeterminate { .. } => "torques indeterminate",
        }
    }

    /// The links concerned; none of a driven gear.
    #[must_use]
    pub fn links(&self) -> &[String] {
        match self {
            Self::Driven => &[],
            Self::InputBlocked { links }
            | Self::OutputAtRest { links }
            | Self::OutputFree { links }
            | Self::Underdetermined { links, .. }
            | Self::TorquesIndeterminate { links, .. } => links,
        }
    }
}

impl fmt::Display for State {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())?;
        if !self.links().is_empty() {
            write!(f, " ({})", self.links().join(", "))?;
        }
        Ok(())
    }
}

/// Which links are meant.
type Choice<'a> = &'a dyn Fn(LinkId) -> bool;

/// The state of a gear and what else the two reductions tell.
#[derive(Debug, Clone)]
pub(crate) struct Verdict {
    pub(crate) state: State,
    /// Speed of each node as a multiple of the input's; `None` where it does not follow.
    pub(crate) speeds: Vec<Option<f64>>,
    /// Rows whose equations suffice, in the order of their pivots.
    pub(crate) rows: Vec<usize>,
    /// Nodes at speeds that can be chosen, the input apart.
    pub(crate) chosen: Vec<usize>,
    /// Whether the torque of each row, and of each edge, follows from the input's.
    pub(crate) row_known: Vec<bool>,
    pub(crate) edge_known: Vec<bool>,
    /// Whether the losses follow: driven, or torques unknown only where nothing rolls.
    pub(crate) solvable: bool,
}

/// Reads the state off; `None` where a fraction outgrows its integers.
pub(crate) fn classify<S: Scalar>(gearbox: &Gearbox, topology: &Topology, ratios: &[S]) -> Option<Verdict> {
    let speeds = speed_relations(topology, ratios)?;
    let torques = Torques::new(gearbox, topology, ratios)?;
    let parts = speeds.parts();
    let depends = |node: usize| speeds.dependence(node);
    let at_rest = |node: Option<usize>| node.is_none_or(|node| depends(node).is_empty());
    let input_blocked = at_rest(topology.input);

    let speed_of = |node: usize| match depends(node).as_slice() {
        [] => Some(0.0),
        [(free, factor)] if !input_blocked && Some(*free) == topology.input => Some(factor.number()),
        _ => None,
    };
    let node_speeds: Vec<Option<f64>> = (0..topology.count).map(speed_of).collect();
    let names = |wanted: Choice| -> Vec<String> {
        (1..gearbox.links.len()).filter(|&l| wanted(LinkId(l))).map(|l| gearbox.links[l].clone()).collect()
    };
    let node = |link: LinkId| topology.node[link.0];
    let resting = || names(&|link| at_rest(node(link)));
    let part_of = |node: Option<usize>| node.map(|node| parts[node]);
    let unknown = |link: LinkId| node(link).is_some_and(|n| node_speeds[n].is_none());

    let state = if input_blocked {
        State::InputBlocked { links: resting() }
    } else if at_rest(topology.output) {
        State::OutputAtRest { links: resting() }
    } else if part_of(topology.output) != part_of(topology.input) {
        State::OutputFree { links: names(&|link| part_of(node(link)) == part_of(topology.output)) }
    } else if topology.output.is_some_and(|output| node_speeds[output].is_none()) {
        let together = |n: usize| Some(parts[n]) == part_of(topology.input);
        let missing = speeds.free.iter().filter(|&&n| together(n)).count().saturating_sub(1);
        let links = names(&|link| unknown(link) && node(link).is_some_and(together));
        State::Underdetermined { missing, links }
    } else {
        torques.state(gearbox, topology, &names, &unknown)
    };
    let chosen = speeds.free.iter().copied().filter(|n| Some(*n) != topology.input).collect();
    let rows = speeds.pivots.iter().map(|(row, _)| *row).filter(|row| *row < gearbox.rows.len()).collect();
    let (row_known, edge_known) =
        (torques.known(0, gearbox.rows.len()), torques.known(gearbox.rows.len(), topology.edges.len()));
    // Controls that share a torque, and rows that turn as a block, lose nothing however they share it.
    let rolls = |row: usize| {
        let [a, _, h] = topology.rows[row].map(|node| node.map_or(Some(0.0), |node| node_speeds[node]));
        a.zip(h).is_none_or(|(a, h)| (a - h).abs() > RANK_TOLERANCE)
    };
    let unknown_row = |row: usize| !row_known[row] && rolls(row) && torques.on_power_path(row);
    let solvable = match state {
        State::Driven => true,
        State::TorquesIndeterminate { .. } => !(0..gearbox.rows.len()).any(unknown_row),
        _ => false,
    };
    Some(Verdict { state, speeds: node_speeds, rows, chosen, row_known, edge_known, solvable })
}

/// Relations between the speeds of the nodes, input and output kept back.
pub(crate) fn speed_relations<S: Scalar>(topology: &Topology, ratios: &[S]) -> Option<Echelon<S>> {
    let mut equations = vec![];
    for (members, &i0) in topology.rows.iter().zip(ratios) {
        equations.push(row_equation(members, i0, topology.count)?);
    }
    let late: Vec<usize> = match (topology.output, topology.input) {
        (Some(output), Some(input)) if output != input => vec![output, input],
        (output, input) => input.or(output).into_iter().collect(),
    };
    Echelon::new(equations, topology.count, &late)
}

/// A row's equation over the nodes. A block whose factors cancel leaves nothing.
pub(crate) fn row_equation<S: Scalar>(members: &[Option<usize>; 3], i0: S, count: usize) -> Option<Vec<S>> {
    let mut equation = vec![S::ZERO; count];
    for (member, factor) in members.iter().zip(factors(i0)?) {
        if let Some(node) = *member {
            equation[node] = equation[node].minus(S::ZERO.minus(factor)?)?;
        }
    }
    Some(equation)
}

/// Relations between the torques: unknowns are the sun's of each row, those of the edges, the
/// output's and the input's; equations are those of the links, so that edges in a loop show.
struct Torques<S> {
    relations: Echelon<S>,
    input: usize,
}

impl<S: Scalar> Torques<S> {
    fn new(gearbox: &Gearbox, topology: &Topology, ratios: &[S]) -> Option<Self> {
        let (rows, edges) = (gearbox.rows.len(), topology.edges.len());
        let (output, input) = (rows + edges, rows + edges + 1);
        let mut equations = vec![vec![S::ZERO; input + 1]; gearbox.links.len()];
        let minus_one = S::ZERO.minus(S::ONE)?;
        for (place, (row, &i0)) in gearbox.rows.iter().zip(ratios).enumerate() {
            for (link, factor) in row.members.iter().zip(factors(i0)?) {
                let entry = &mut equations[link.0][place];
                *entry = entry.minus(factor)?;
            }
        }
        for (place, edge) in topology.edges.iter().enumerate() {
            equations[edge.links[0].0][rows + place] = S::ONE;
            equations[edge.links[1].0][rows + place] = minus_one;
        }
        for (terminal, column) in topology.terminals.into_iter().zip([input, output]) {
            equations[terminal.0][column] = S::ONE;
        }
        equations.remove(0);
        Some(Self { relations: Echelon::new(equations, input + 1, &[output, input])?, input })
    }

    fn on_power_path(&self, column: usize) -> bool {
        let parts = self.relations.parts();
        parts[column] == parts[self.input]
    }

    fn known(&self, from: usize, count: usize) -> Vec<bool> {
        (from..from + count)
            .map(|column| self.relations.dependence(column).iter().all(|(free, _)| *free == self.input))
            .collect()
    }

    /// The state of a gear whose speeds from input to output follow.
    fn state(
        &self,
        gearbox: &Gearbox,
        topology: &Topology,
        names: &dyn Fn(Choice) -> Vec<String>,
        unknown_speed: &dyn Fn(LinkId) -> bool,
    ) -> State {
        let parts = self.relations.parts();
        let rows = gearbox.rows.len();
        let open = |column: usize| {
            parts[column] == parts[self.input]
                && self.relations.dependence(column).iter().any(|(free, _)| *free != self.input)
        };
        let open_rows: Vec<usize> = (0..rows).filter(|&r| open(r)).collect();
        let open_edges: Vec<usize> = (0..topology.edges.len()).filter(|&e| open(rows + e)).collect();
        if !open_rows.is_empty() || !open_edges.is_empty() {
            let touched = |link: LinkId| {
                open_rows.iter().any(|&r| gearbox.rows[r].members.contains(&link))
                    || open_edges.iter().any(|&e| topology.edges[e].links.contains(&link))
            };
            let control = |&e: &usize| topology.edges[e].control.map(|c| gearbox.controls[c].id.clone());
            return State::TorquesIndeterminate {
                links: names(&touched),
                controls: open_edges.iter().filter_map(control).collect(),
                rows: open_rows.iter().map(|&r| gearbox.rows[r].id().to_owned()).collect(),
            };
        }
        // A loaded row at an unknown speed: only with special dimensions (i₀ = 1 and a carrier that
        // nothing holds, or torques that cancel), but then its losses do not follow.
        let loaded = |r: usize| !self.relations.dependence(r).is_empty();
        let adrift = |link: LinkId| {
            unknown_speed(link) && (0..rows).any(|r| loaded(r) && gearbox.rows[r].members.contains(&link))
        };
        let links = names(&adrift);
        if links.is_empty() { State::Driven } else { State::Underdetermined { missing: links.len(), links } }
    }
}

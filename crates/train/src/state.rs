//! State of a gear, from the rank of its equations.
//!
//! Speeds obey the equations of the sets; torques obey one equation per link. Both systems are brought to
//! reduced echelon form with input and output kept back, so the state is read off, not counted:
//!
//! - [`InputBlocked`](State::InputBlocked): `ω_in = 0` follows from the speeds.
//! - [`OutputFree`](State::OutputFree): no relation of the speeds holds both `ω_in` and `ω_out`.
//! - [`Underdetermined`](State::Underdetermined): the relation of `ω_in` and `ω_out` holds a further free
//!   speed, or, in the torques, a loaded set turns at a free speed.
//! - [`OutputAtRest`](State::OutputAtRest): `ω_out = 0` follows, `ω_in` is free.
//! - [`TorquesIndeterminate`](State::TorquesIndeterminate): `ω_out = ω_in/i`; a torque in relation with the
//!   input's is free.
//! - [`Driven`](State::Driven): `ω_out = ω_in/i`; all such torques follow.
//! - [`SelfLocking`](State::SelfLocking): speeds as in a driven gear, but with losses `η ≤ 0`: no torque at
//!   the input moves a load.
//!
//! The first entry that fits is the state. "In relation" means: in one part of the system's matroid (some
//! minimal relation holds both). This separates the power path from the parts outside it: an idle set that
//! spins freely, an idle link held by two brakes at once, or a set locked on its own. Such parts do not spoil
//! a driven gear; only their own speed or torque remains unknown.

use crate::elimination::{Echelon, Scalar};
use crate::tolerance::SPEED;
use crate::topology::{Topology, factors, node_equations};
use crate::{Gearbox, LinkId};
use std::fmt;
use std::ops::Range;

/// State of a gear, with the links it concerns.
#[derive(Debug, Clone, PartialEq, Eq)]
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
        /// The output and the links whose speeds are in a relation with its own.
        links: Vec<String>,
    },
    /// Input and output are related, but only together with further speeds that nothing gives: a
    /// differential with too few shift elements engaged.
    Underdetermined {
        /// Number of further speeds required.
        missing: usize,
        /// Links with unknown speed; each of them could be held.
        links: Vec<String>,
    },
    /// Speeds follow, but torques on the power path depend on how tightly redundant shift elements or sets
    /// were engaged. Losses still follow where the unknown torques belong to shift elements alone, or to
    /// sets that turn as a block.
    TorquesIndeterminate {
        /// Links of the redundant parts.
        links: Vec<String>,
        /// Redundant shift elements.
        shift_elements: Vec<String>,
        /// Sets of unknown torque.
        sets: Vec<String>,
    },
    /// The mesh losses hold the gear: no torque at the input moves a load at the output.
    SelfLocking {
        /// The input.
        links: Vec<String>,
        /// Whether no torque at the output moves it either.
        both_ways: bool,
    },
}

impl State {
    /// Whether input and output turn at a known ratio: driven, self-locking, or with torques indeterminate.
    #[must_use]
    pub fn has_ratio(&self) -> bool {
        matches!(self, Self::Driven | Self::TorquesIndeterminate { .. } | Self::SelfLocking { .. })
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
            Self::SelfLocking { .. } => "self-locking",
        }
    }

    /// Links concerned; empty for a driven gear.
    #[must_use]
    pub fn links(&self) -> &[String] {
        match self {
            Self::Driven => &[],
            Self::InputBlocked { links }
            | Self::OutputAtRest { links }
            | Self::OutputFree { links }
            | Self::Underdetermined { links, .. }
            | Self::TorquesIndeterminate { links, .. }
            | Self::SelfLocking { links, .. } => links,
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

/// Selection of links.
type Choice<'a> = &'a dyn Fn(LinkId) -> bool;

/// State of a gear and the other results of the two reductions.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Verdict {
    pub(crate) state: State,
    /// Speed of each node as a multiple of the input's; `None` where it does not follow.
    pub(crate) speeds: Vec<Option<f64>>,
    /// Equations that suffice, ascending.
    pub(crate) equations: Vec<usize>,
    /// Nodes at speeds that can be chosen, the input apart.
    pub(crate) chosen: Vec<usize>,
    /// Torques that follow from the input's.
    pub(crate) known: Known,
    /// Whether the losses follow: driven, or torques unknown only where nothing rolls.
    pub(crate) solvable: bool,
}

/// Whether the torque of each equation, and of each edge, follows from those at the terminals.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Known {
    All,
    Some { equations: Vec<bool>, edges: Vec<bool> },
}

impl Known {
    pub(crate) fn equation(&self, equation: usize) -> bool {
        match self {
            Self::All => true,
            Self::Some { equations, .. } => equations[equation],
        }
    }

    pub(crate) fn edge(&self, edge: usize) -> bool {
        match self {
            Self::All => true,
            Self::Some { edges, .. } => edges[edge],
        }
    }
}

/// Reads the state off; `None` where a number is in doubt or outgrows its kind.
pub(crate) fn classify<S: Scalar>(gearbox: &Gearbox, topology: &Topology, ratios: &[S]) -> Option<Verdict> {
    let speeds = speed_relations(topology, ratios)?;
    let at_rest = |node: Option<usize>| node.is_none_or(|node| speeds.is_nothing(node));
    let input_blocked = at_rest(topology.input);
    let mut node_speeds: Vec<Option<f64>> = Vec::with_capacity(topology.count);
    for node in 0..topology.count {
        let mut speed = Some(0.0);
        for (place, (free, factor)) in speeds.dependence(node).enumerate() {
            if !factor.is_sharp() {
                return None;
            }
            let is_of_input = place == 0 && !input_blocked && Some(free) == topology.input;
            speed = Some(factor.number()).filter(|speed| is_of_input && speed.is_normal());
        }
        node_speeds.push(speed);
    }
    let chosen: Vec<usize> =
        speeds.free.iter().copied().filter(|node| Some(*node) != topology.input).collect();
    let mut equations: Vec<usize> = speeds.pivots.iter().map(|(equation, _)| *equation).collect();
    equations.sort_unstable();
    let count = gearbox.equations.len();
    // Independent equations that leave but the input free, and connections without a loop: every torque
    // follows.
    let is_square = equations.len() == count && topology.is_forest && chosen.is_empty() && !input_blocked;
    if is_square && !at_rest(topology.output) {
        return Some(Verdict {
            state: State::Driven,
            speeds: node_speeds,
            equations,
            chosen,
            known: Known::All,
            solvable: true,
        });
    }

    let [input, output] = topology.terminals;
    let torques = Torques::new(gearbox, topology, ratios, &[output, input])?;
    let parts = speeds.parts();
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
    let known = torques.known(gearbox, topology);
    // Shift elements that share a torque, and sets that turn as a block, lose nothing however they share it.
    let rolls = |equation: usize| {
        let [a, _, h] =
            topology.equations[equation].map(|node| node.map_or(Some(0.0), |node| node_speeds[node]));
        a.zip(h).is_none_or(|(a, h)| (a - h).abs() > SPEED * a.abs().max(h.abs()))
    };
    let unknown_equation = |one: usize| !known.equation(one) && rolls(one) && torques.on_power_path(one);
    let solvable = match state {
        State::Driven => true,
        State::TorquesIndeterminate { .. } => !(0..count).any(unknown_equation),
        _ => false,
    };
    Some(Verdict { state, speeds: node_speeds, equations, chosen, known, solvable })
}

/// Relations between the speeds of the nodes, input and output kept back.
pub(crate) fn speed_relations<S: Scalar>(topology: &Topology, ratios: &[S]) -> Option<Echelon<S>> {
    let equations = node_equations(topology, ratios.iter().map(Some))?;
    match (topology.output, topology.input) {
        (Some(output), Some(input)) if output != input => {
            Echelon::new(equations, topology.count, &[output, input])
        }
        (output, input) => Echelon::new(equations, topology.count, input.or(output).as_slice()),
    }
}

/// Relations between the torques: unknowns are `t` of each equation, those of the edges and of the terminals;
/// equations are those of the links, so that edges in a loop show.
pub(crate) struct Torques<S> {
    relations: Echelon<S>,
    parts: Vec<usize>,
    terminals: Range<usize>,
}

impl<S: Scalar> Torques<S> {
    /// The last terminals stay free as long as they can.
    pub(crate) fn new(
        gearbox: &Gearbox,
        topology: &Topology,
        ratios: &[S],
        terminals: &[LinkId],
    ) -> Option<Self> {
        let (count, edges) = (gearbox.equations.len(), topology.edges.len());
        let columns = count + edges..count + edges + terminals.len();
        // Of all links but the housing.
        let mut equations = vec![S::zero(); columns.end * (gearbox.links.len() - 1)];
        let at = |link: usize, column: usize| link.checked_sub(1).map(|row| row * columns.end + column);
        let minus_one = S::one().negative()?;
        for (place, (one, ratio)) in gearbox.equations.iter().zip(ratios).enumerate() {
            let links = one.links.map(|link| Some(link.0));
            for (link, factor) in factors(links, ratio)? {
                if let Some(entry) = link.and_then(|link| at(link, place)) {
                    equations[entry] = factor;
                }
            }
        }
        for (place, edge) in topology.edges.iter().enumerate() {
            for (link, factor) in edge.links.iter().zip([S::one(), minus_one.clone()]) {
                if let Some(entry) = at(link.0, count + place) {
                    equations[entry] = factor;
                }
            }
        }
        for (terminal, column) in terminals.iter().zip(columns.clone()) {
            if let Some(entry) = at(terminal.0, column) {
                equations[entry] = S::one();
            }
        }
        let late: Vec<usize> = columns.clone().collect();
        let relations = Echelon::new(equations, columns.end, &late)?;
        // The equations of a set share planets: they are one part, whichever gear they refer to.
        let mut parts = relations.parts();
        for set in 0..gearbox.sets.len() {
            let own = gearbox.equations_of(set);
            for one in own.start + 1..own.end {
                let (kept, joined) = (parts[own.start], parts[one]);
                parts.iter_mut().filter(|part| **part == joined).for_each(|part| *part = kept);
            }
        }
        Some(Self { parts, relations, terminals: columns })
    }

    pub(crate) fn on_power_path(&self, column: usize) -> bool {
        self.terminals.clone().any(|terminal| self.parts[column] == self.parts[terminal])
    }

    /// Whether a torque follows from those at the terminals.
    fn follows(&self, column: usize) -> bool {
        self.relations.dependence(column).all(|(free, _)| self.terminals.contains(&free))
    }

    /// Whether an equation carries any torque.
    pub(crate) fn is_loaded(&self, equation: usize) -> bool {
        !self.relations.is_nothing(equation)
    }

    pub(crate) fn known(&self, gearbox: &Gearbox, topology: &Topology) -> Known {
        let follows = |columns: Range<usize>| columns.map(|column| self.follows(column)).collect();
        let (count, edges) = (gearbox.equations.len(), topology.edges.len());
        Known::Some { equations: follows(0..count), edges: follows(count..count + edges) }
    }

    /// The state of a gear whose speeds from input to output follow.
    fn state(
        &self,
        gearbox: &Gearbox,
        topology: &Topology,
        names: &dyn Fn(Choice) -> Vec<String>,
        unknown_speed: &dyn Fn(LinkId) -> bool,
    ) -> State {
        let count = gearbox.equations.len();
        let open = |column: usize| self.on_power_path(column) && !self.follows(column);
        let is_open = |set: &usize| gearbox.equations_of(*set).any(open);
        let open_sets: Vec<usize> = (0..gearbox.sets.len()).filter(is_open).collect();
        let open_edges: Vec<usize> = (0..topology.edges.len()).filter(|&e| open(count + e)).collect();
        if !open_sets.is_empty() || !open_edges.is_empty() {
            let touched = |link: LinkId| {
                open_sets.iter().any(|&set| gearbox.sets[set].members().contains(&link))
                    || open_edges.iter().any(|&e| topology.edges[e].links.contains(&link))
            };
            let shift_element =
                |&e: &usize| topology.edges[e].shift_element.map(|c| gearbox.shift_elements[c].id.clone());
            return State::TorquesIndeterminate {
                links: names(&touched),
                shift_elements: open_edges.iter().filter_map(shift_element).collect(),
                sets: open_sets.iter().map(|&set| gearbox.sets[set].id().to_owned()).collect(),
            };
        }
        // A loaded set at an unknown speed: only with special dimensions (i₀ = 1 and a carrier that
        // nothing holds, or torques that cancel), but then its losses do not follow.
        let is_loaded = |set: &usize| gearbox.equations_of(*set).any(|equation| self.is_loaded(equation));
        let loaded: Vec<usize> = (0..gearbox.sets.len()).filter(is_loaded).collect();
        let adrift = |link: LinkId| {
            unknown_speed(link) && loaded.iter().any(|&set| gearbox.sets[set].members().contains(&link))
        };
        let links = names(&adrift);
        if links.is_empty() { State::Driven } else { State::Underdetermined { missing: links.len(), links } }
    }
}

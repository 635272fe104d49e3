//! Powers in a gear: through sets, meshes and links, losses, and circulating power.
//!
//! # Source
//! Rolling and coupling power are the field's terms. Seen from the carrier a set passes the rolling power
//! `T_a·(ω_a − ω_H)` through its meshes. The coupling power, `T_a·ω_H` and `T_b·ω_H`, turns with the carrier
//! and loses nothing.
//!
//! # Circulating power
//! The power graph has an arc for every member of every set and for every connection, in the direction of its
//! power; the power is the arc's flow. A *circulation* takes from each arc no more than its flow, none
//! backwards, and is balanced at every link and set. The power that circulates through an arc is that of the
//! largest circulation through it. The circulating power of the gear is the largest of all arcs. It is 0
//! exactly if no directed loop exists, and depends on no order.

use crate::groups::Groups;
use crate::planet_set::PlanetSet;
use crate::tolerance::{LOOP, POWER};
use crate::topology::{Edge, Topology};
use crate::{Gearbox, LinkId};
use std::collections::VecDeque;

/// Powers of a set, as multiples of the power that enters the gear.
#[derive(Debug, Clone, PartialEq)]
pub struct SetPower {
    /// Power that enters the set at each member, `T·ω`, in the order of
    /// [`PlanetSet::members`](crate::PlanetSet::members).
    pub members: Vec<f64>,
    /// Rolling power at each central gear, `T_c·(ω_c − ω_H)`: positive where it enters.
    pub rolling: Vec<f64>,
    /// Power lost in the meshes, the sum over the members.
    pub loss: f64,
}

impl SetPower {
    /// Rolling power at the first central gear: of a set with two, positive from the first to the second.
    #[must_use]
    pub fn rolling_power(&self) -> f64 {
        self.rolling[0]
    }

    /// Coupling power of a central gear, `T_c·ω_H`: the power that it gives or takes without its meshes.
    #[must_use]
    pub fn coupling(&self, central: usize) -> f64 {
        self.members[central] - self.rolling[central]
    }
}

/// Power through a mesh, as multiples of the power that enters the gear.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MeshPower {
    /// 1 where it flows from the first gear of the mesh to the second, −1 back, 0 where none does.
    pub sense: i8,
    /// Power that enters the mesh, at least 0.
    pub enters: f64,
    /// Power that leaves the mesh.
    pub leaves: f64,
}

/// Powers of a gear, as multiples of the power that enters it.
#[derive(Debug, Clone, PartialEq)]
pub struct PowerFlow {
    /// Powers of each set; `None` if torque or speed do not follow.
    pub sets: Vec<Option<SetPower>>,
    /// Power through each link by [`LinkId::index`](crate::LinkId::index): half the sum of the powers that
    /// its members, connections and terminals give and take. `None` if a part does not follow.
    pub links: Vec<Option<f64>>,
    /// Circulating power, over the power that enters.
    pub circulating: f64,
    /// Circulating power of each arc, with the sign of the arc's power.
    circulations: Vec<(Way, f64)>,
    /// The largest power of any member, rolling or at a link, at least 1: the measure for balances.
    pub largest: f64,
}

impl PowerFlow {
    /// The part of the power at a member of a set, [`SetPower::members`], that can circulate, of its sign.
    #[must_use]
    pub fn circulating_member(&self, set: usize, member: usize) -> f64 {
        self.circulating_by(Way::Member { set, member })
    }

    /// The part of a shift element's power, torque on its first link times that link's speed, that can
    /// circulate.
    #[must_use]
    pub fn circulating_shift_element(&self, shift_element: usize) -> f64 {
        self.circulating_by(Way::ShiftElement(shift_element))
    }

    fn circulating_by(&self, way: Way) -> f64 {
        self.circulations.iter().find(|(other, _)| *other == way).map_or(0.0, |(_, part)| *part)
    }
}

/// Arc of the power graph.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Way {
    Member { set: usize, member: usize },
    ShiftElement(usize),
    Tie,
}

/// Power in the direction of the arrow from one vertex to another.
#[derive(Clone, Copy)]
struct Flow {
    from: usize,
    to: usize,
    power: f64,
    way: Way,
    /// Sign of the power as results count it.
    sign: f64,
}

/// A gear under torques, as the power flow sees it.
pub(crate) struct Flowing<'a> {
    pub(crate) gearbox: &'a Gearbox,
    pub(crate) topology: &'a Topology,
    pub(crate) speeds: &'a [Option<f64>],
    pub(crate) members: &'a [Option<Vec<f64>>],
    /// Torques of the connections on their first links.
    pub(crate) edges: &'a [Option<f64>],
    /// Torques from outside.
    pub(crate) terminals: &'a [(LinkId, f64)],
    /// The least measure for balances.
    pub(crate) least: f64,
}

/// Powers of the sets, links and shift elements.
pub(crate) fn power_flow(flowing: &Flowing) -> PowerFlow {
    let Flowing { gearbox, topology, speeds, members, edges, terminals, least } = *flowing;
    let count = gearbox.links.len();
    let mut largest = least;
    let mut sets = Vec::with_capacity(members.len());
    let member_count: usize = gearbox.sets.iter().map(|set| set.members().len()).sum();
    let mut flows = Vec::with_capacity(member_count + topology.edges.len());
    let mut through = vec![Some(0.0); count];
    let mut add = |link: usize, power: Option<f64>| {
        through[link] = through[link].zip(power).map(|(sum, power): (f64, f64)| sum + power.abs() / 2.0);
    };
    // Links that share a torque in an undetermined way are one piece to the flow. So are links that are tied:
    // one link under two names circulates as much as under one.
    let mut pieces: Option<Groups> = None;
    let is_one = |(edge, torque): &(&Edge, &Option<f64>)| torque.is_none() || edge.shift_element.is_none();
    for (edge, _) in topology.edges.iter().zip(edges).filter(is_one) {
        pieces.get_or_insert_with(|| Groups::new(count)).join(edge.links[0].0, edge.links[1].0);
    }
    let piece = |link: usize| pieces.as_ref().map_or(link, |pieces| pieces.root(link));
    let torque = |most: f64, torque: &f64| most.max(torque.abs());
    let no_torque = POWER * members.iter().flatten().flatten().fold(0.0, torque);
    for (place, (set, torques)) in gearbox.sets.iter().zip(members).enumerate() {
        let power = torques.as_ref().and_then(|torques| set_power(set, torques, speeds, no_torque));
        for (member, link) in set.members().iter().enumerate() {
            let own = power.as_ref().map(|power| power.members[member]);
            add(link.0, own);
            let Some(own) = own else { continue };
            let (link, vertex) = (piece(link.0), count + place);
            let (from, to) = if own > 0.0 { (link, vertex) } else { (vertex, link) };
            let way = Way::Member { set: place, member };
            flows.push(Flow { from, to, power: own.abs(), way, sign: own.signum() });
        }
        if let Some(power) = &power {
            largest = power.members.iter().chain(&power.rolling).fold(largest, |m, p| m.max(p.abs()));
        }
        sets.push(power);
    }
    for (edge, torque) in topology.edges.iter().zip(edges) {
        let [first, second] = edge.links.map(|link| link.0);
        let power = torque_times(*torque, speeds[first]);
        add(first, power);
        add(second, power);
        let Some(power) = power else { continue };
        let [first, second] = [piece(first), piece(second)];
        let (from, to) = if power > 0.0 { (second, first) } else { (first, second) };
        let way = edge.shift_element.map_or(Way::Tie, Way::ShiftElement);
        flows.push(Flow { from, to, power: power.abs(), way, sign: power.signum() });
    }
    for &(terminal, torque) in terminals {
        add(terminal.0, torque_times(Some(torque), speeds[terminal.0]));
    }
    let mut circulating = 0.0_f64;
    let mut parts = vec![];
    for (flow, part) in circulations(flows, count + gearbox.sets.len(), LOOP * largest) {
        circulating = circulating.max(part);
        if part > 0.0 {
            parts.push((flow.way, flow.sign * part));
        }
    }
    PowerFlow { sets, links: through, circulating, circulations: parts, largest }
}

/// A torque of nothing has no power at any speed.
fn torque_times(torque: Option<f64>, speed: Option<f64>) -> Option<f64> {
    if torque == Some(0.0) { Some(0.0) } else { Some(torque? * speed?) }
}

/// Powers of a set under these torques on its members; `None` where a speed is missing.
fn set_power(set: &PlanetSet, torques: &[f64], speeds: &[Option<f64>], no_torque: f64) -> Option<SetPower> {
    let centrals = set.centrals().len();
    // At an unknown speed, a member without torque has no power.
    let is_idle = torques.iter().all(|torque| torque.abs() <= no_torque);
    let speed = |member: usize| speeds[set.members()[member].0].or(is_idle.then_some(0.0));
    let carrier = speed(centrals)?;
    let mut members = Vec::with_capacity(centrals + 1);
    let mut rolling = Vec::with_capacity(centrals);
    for (member, torque) in torques.iter().enumerate() {
        let omega = speed(member)?;
        members.push(torque * omega);
        if member < centrals {
            rolling.push(torque * (omega - carrier));
        }
    }
    Some(SetPower {
        members,
        // From rolling powers: the coupling powers, which may be large, cancel exactly.
        loss: rolling.iter().sum(),
        rolling,
    })
}

/// Power through each mesh of a set from the rolling powers of the central gears: the powers of the gears
/// behind the mesh, through the meshes between. `signs` are those of its segments, empty without losses.
///
/// A mesh that passes no more than rounding leaves of the `largest` power is idle, and has no direction.
pub(crate) fn mesh_powers(
    set: &PlanetSet,
    power: &SetPower,
    signs: Option<&[i8]>,
    largest: f64,
) -> Vec<MeshPower> {
    let (tree, rolling) = (&set.tree, &power.rolling);
    let sign = |segment: usize| signs.map_or(0, |signs| signs[segment]);
    // Part of the power from the root's side that a mesh passes on, in the direction of its segment.
    let part = |mesh: usize| match tree.in_segment[mesh].map_or(0, |(segment, _)| sign(segment)) {
        0 => 1.0,
        1 => set.meshes()[mesh].efficiency.get(),
        _ => 1.0 / set.meshes()[mesh].efficiency.get(),
    };
    let of_mesh = |mesh: usize| {
        let behind = &tree.behind[mesh];
        // Power that leaves the mesh outwards: the powers of the central gears behind it.
        let outwards: f64 = behind
            .clone()
            .map(|place| {
                let central = tree.order[place];
                let beyond: f64 = (0..set.meshes().len())
                    .filter(|&other| tree.behind[other].contains(&place) && is_beyond(tree, other, mesh))
                    .map(part)
                    .product();
                -rolling[central] / beyond
            })
            .sum();
        let inside = outwards / part(mesh);
        let sense = i8::from(outwards > 0.0) - i8::from(outwards < 0.0);
        let mesh = match sense {
            1 => MeshPower { sense, enters: inside, leaves: outwards },
            _ => MeshPower { sense, enters: -outwards, leaves: -inside },
        };
        if mesh.enters > POWER * largest { mesh } else { MeshPower::default() }
    };
    (0..set.meshes().len()).map(of_mesh).collect()
}

/// Whether a mesh lies farther from the root than another, on a path through it.
fn is_beyond(tree: &crate::planet_set::Tree, mesh: usize, other: usize) -> bool {
    let (inner, outer) = (&tree.behind[mesh], &tree.behind[other]);
    if inner == outer {
        // In one segment: its meshes stand outwards.
        return tree.in_segment[mesh] > tree.in_segment[other];
    }
    outer.start <= inner.start && inner.end <= outer.end
}

/// The largest circulation through each flow in a directed loop.
fn circulations(mut flows: Vec<Flow>, vertices: usize, nothing: f64) -> Vec<(Flow, f64)> {
    flows.retain(|flow| flow.power > nothing && flow.from != flow.to);
    // No loop holds an arc at a vertex that only gives or only takes: remove these repeatedly.
    if flows.is_empty() {
        return vec![];
    }
    let mut ends = vec![(false, false); vertices];
    loop {
        ends.fill((false, false));
        for flow in &flows {
            ends[flow.from].0 = true;
            ends[flow.to].1 = true;
        }
        let before = flows.len();
        flows.retain(|flow| ends[flow.from].1 && ends[flow.to].0);
        if flows.len() == before {
            break;
        }
    }
    let through = |place: usize| {
        let part = largest_flow(&flows, place, vertices, nothing).min(flows[place].power);
        (flows[place], if part <= nothing { 0.0 } else { part })
    };
    (0..flows.len()).map(through).collect()
}

/// The largest flow from the end of a flow back to its start, through the others (Edmonds and Karp).
fn largest_flow(flows: &[Flow], through: usize, vertices: usize, nothing: f64) -> f64 {
    let (start, end) = (flows[through].to, flows[through].from);
    let mut forward: Vec<f64> = flows.iter().map(|flow| flow.power).collect();
    forward[through] = 0.0;
    let mut backward = vec![0.0; flows.len()];
    let mut total = 0.0;
    loop {
        // Of each vertex the flow by which it was reached, and whether forwards.
        let mut came_by: Vec<Option<(usize, bool)>> = vec![None; vertices];
        let mut waiting = VecDeque::from([start]);
        while let Some(vertex) = waiting.pop_front() {
            for (place, flow) in flows.iter().enumerate() {
                let (next, is_forward) = if flow.from == vertex && forward[place] > nothing {
                    (flow.to, true)
                } else if flow.to == vertex && backward[place] > nothing {
                    (flow.from, false)
                } else {
                    continue;
                };
                if next != start && came_by[next].is_none() {
                    came_by[next] = Some((place, is_forward));
                    waiting.push_back(next);
                }
            }
        }
        let mut path = vec![];
        let mut at = end;
        while at != start {
            let Some((place, is_forward)) = came_by[at] else { return total };
            path.push((place, is_forward));
            at = if is_forward { flows[place].from } else { flows[place].to };
        }
        let room = |&(place, is_forward): &(usize, bool)| {
            if is_forward { forward[place] } else { backward[place] }
        };
        let least = path.iter().map(room).fold(f64::INFINITY, f64::min);
        for (place, is_forward) in path {
            let change = if is_forward { least } else { -least };
            forward[place] -= change;
            backward[place] += change;
        }
        total += least;
    }
}

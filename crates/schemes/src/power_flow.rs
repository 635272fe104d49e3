//! Powers in a gear: through rows and links, what is lost, what only circulates.
//!
//! # Source
//! Relative and coupling power are the field's terms: seen from the carrier a row passes
//! `T_a·(ω_a − ω_H)` through its meshes; the rest, `T_a·ω_H` and `T_b·ω_H`, goes round with the
//! carrier and loses nothing.

use crate::torques::Scene;

/// Powers of a row, as multiples of the power that enters the gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RowPower {
    /// What enters the row at sun, ring and carrier, `T·ω`.
    pub members: [f64; 3],
    /// Relative power at the sun, `T_a·(ω_a − ω_H)`: positive from sun to ring.
    pub relative: f64,
    /// Coupling power of sun and ring, `T_a·ω_H` and `T_b·ω_H`.
    pub coupling: [f64; 2],
    /// What the meshes take, the sum over the members.
    pub loss: f64,
}

/// Powers of a gear, as multiples of the power that enters it.
#[derive(Debug, Clone, PartialEq)]
pub struct PowerFlow {
    /// Of each row; `None` where torque or speed do not follow.
    pub rows: Vec<Option<RowPower>>,
    /// Power through each link by [`LinkId::index`](crate::LinkId::index): half the sum of what its
    /// members, connections and terminals give and take. `None` where a part does not follow.
    pub links: Vec<Option<f64>>,
    /// Power that runs in closed loops of links and rows, over what enters.
    ///
    /// The flow is drawn from link to row to link in the sense of its power. Each directed loop is
    /// cancelled by its smallest flow until none is left; this is the sum of what was cancelled.
    /// With one loop the value is unique; with loops that share links it is that of the order of
    /// rows and links.
    pub circulating: f64,
    /// Where it runs: the part of each row's [`members`](RowPower::members) that belongs to loops, of their
    /// sign; 0 where nothing follows.
    pub circulating_members: Vec<[f64; 3]>,
    /// The part of each control's power, torque on its first link times that link's speed, that belongs to
    /// loops.
    pub circulating_controls: Vec<f64>,
    /// The largest power of any member, relative or absolute, at least 1: the measure for balances.
    pub largest: f64,
}

/// What power flows through.
#[derive(Clone, Copy)]
enum Way {
    Member { row: usize, member: usize },
    Control(usize),
    Tie,
}

/// Power in the sense of the arrow from one vertex to another, and what of it was found to go round.
struct Flow {
    from: usize,
    to: usize,
    power: f64,
    way: Way,
    /// Sign of the power as results count it.
    sign: f64,
    cancelled: f64,
}

pub(crate) fn power_flow(
    scene: &Scene,
    members: &[Option<[f64; 3]>],
    edges: &[Option<f64>],
    [input, output]: [f64; 2],
) -> PowerFlow {
    let gearbox = scene.gearbox;
    let count = gearbox.links.len();
    let mut largest = 1.0_f64;
    let mut rows = vec![];
    let mut flows = vec![];
    let mut through = vec![Some(0.0); count];
    let mut add = |link: usize, power: Option<f64>| {
        through[link] = through[link].zip(power).map(|(sum, power): (f64, f64)| sum + power.abs() / 2.0);
    };
    for (place, (row, torques)) in gearbox.rows.iter().zip(members).enumerate() {
        let power = row_power(*torques, row.members.map(|link| scene.speeds[link.0]));
        for (member, link) in row.members.iter().enumerate() {
            add(link.0, power.map(|power| power.members[member]));
            let Some(power) = power.map(|power| power.members[member]) else { continue };
            let (from, to) = if power > 0.0 { (link.0, count + place) } else { (count + place, link.0) };
            let way = Way::Member { row: place, member };
            flows.push(Flow { from, to, power: power.abs(), way, sign: power.signum(), cancelled: 0.0 });
        }
        if let Some(power) = power {
            largest = power.members.iter().fold(largest.max(power.relative.abs()), |m, p| m.max(p.abs()));
        }
        rows.push(power);
    }
    for (edge, torque) in scene.topology.edges.iter().zip(edges) {
        let [first, second] = edge.links.map(|link| link.0);
        let power = torque_times(*torque, scene.speeds[first]);
        add(first, power);
        add(second, power);
        let Some(power) = power else { continue };
        let (from, to) = if power > 0.0 { (second, first) } else { (first, second) };
        let way = edge.control.map_or(Way::Tie, Way::Control);
        flows.push(Flow { from, to, power: power.abs(), way, sign: power.signum(), cancelled: 0.0 });
    }
    for (terminal, torque) in scene.topology.terminals.iter().zip([input, output]) {
        add(terminal.0, torque_times(Some(torque), scene.speeds[terminal.0]));
    }
    let circulating = cancel_loops(&mut flows, count + gearbox.rows.len(), 1e-12 * largest);
    let mut circulating_members = vec![[0.0; 3]; gearbox.rows.len()];
    let mut circulating_controls = vec![0.0; gearbox.controls.len()];
    for flow in flows {
        match flow.way {
            Way::Member { row, member } => circulating_members[row][member] = flow.sign * flow.cancelled,
            Way::Control(control) => circulating_controls[control] = flow.sign * flow.cancelled,
            Way::Tie => {}
        }
    }
    PowerFlow { rows, links: through, circulating, circulating_members, circulating_controls, largest }
}

/// A torque of nothing has no power at any speed.
fn torque_times(torque: Option<f64>, speed: Option<f64>) -> Option<f64> {
    if torque == Some(0.0) { Some(0.0) } else { Some(torque? * speed?) }
}

fn row_power(torques: Option<[f64; 3]>, speeds: [Option<f64>; 3]) -> Option<RowPower> {
    let torques = torques?;
    let idle = torques.iter().all(|t| t.abs() < 1e-12);
    let [a, b, h] = match speeds {
        [Some(a), Some(b), Some(h)] => [a, b, h],
        _ if idle => [0.0; 3],
        _ => return None,
    };
    let [t_a, t_b, t_h] = torques;
    let members = [t_a * a, t_b * b, t_h * h];
    Some(RowPower {
        members,
        relative: t_a * (a - h),
        coupling: [t_a * h, t_b * h],
        // From relative powers: the coupling powers, which may be large, cancel exactly.
        loss: t_a * (a - h) + t_b * (b - h),
    })
}

fn cancel_loops(flows: &mut [Flow], vertices: usize, nothing: f64) -> f64 {
    let mut cancelled = 0.0;
    for flow in flows.iter_mut().filter(|flow| flow.power <= nothing) {
        flow.power = 0.0;
    }
    while let Some(cycle) = (0..vertices).find_map(|start| find_loop(flows, start, vertices)) {
        let least = cycle.iter().fold(f64::INFINITY, |m, &place| m.min(flows[place].power));
        cancelled += least;
        for place in cycle {
            let flow = &mut flows[place];
            flow.cancelled += least;
            flow.power -= least;
            if flow.power <= nothing {
                flow.power = 0.0;
            }
        }
    }
    cancelled
}

/// A directed loop through `start`, as places of its flows (breadth first: a shortest one).
fn find_loop(flows: &[Flow], start: usize, vertices: usize) -> Option<Vec<usize>> {
    let mut came_by: Vec<Option<usize>> = vec![None; vertices];
    let mut waiting = std::collections::VecDeque::from([start]);
    while let Some(vertex) = waiting.pop_front() {
        for (place, flow) in
            flows.iter().enumerate().filter(|(_, flow)| flow.from == vertex && flow.power > 0.0)
        {
            if flow.to == start {
                let mut path = vec![place];
                let mut at = vertex;
                while at != start {
                    let by = came_by[at]?;
                    path.push(by);
                    at = flows[by].from;
                }
                return Some(path);
            }
            if came_by[flow.to].is_none() {
                came_by[flow.to] = Some(place);
                waiting.push_back(flow.to);
            }
        }
    }
    None
}

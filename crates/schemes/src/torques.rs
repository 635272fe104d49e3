//! Torques in a gear, with and without losses: members, controls, input and output.

use crate::compiled::{CompiledGear, Direction, Solution};
use crate::power_flow::{PowerFlow, power_flow};
use crate::state::Verdict;
use crate::topology::Topology;
use crate::{Gearbox, LinkId};

/// Torques and powers of a gear while one unit of power enters it.
///
/// Torques are multiples of the input torque, that is for 1 at the input in
/// [`Direction::Drive`], and for `i` at the output in [`Direction::Overrun`] (there the input
/// carries `−η`, the load). The [sign convention](epicyclic_gears#sign-convention) is that of the
/// workspace: torques act on the member from outside.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadCase {
    /// Which way power runs.
    pub direction: Direction,
    /// Torques on sun, ring and carrier of each row; `None` in an idle row whose torque nothing
    /// settles.
    pub members: Vec<Option<[f64; 3]>>,
    /// Torque of each control on its first link (the second takes the opposite): 0 when open, `None`
    /// where controls in a loop share it in a way that nothing settles.
    pub controls: Vec<Option<f64>>,
    /// Torque on the input from outside.
    pub input: f64,
    /// Torque on the output from outside.
    pub output: f64,
    /// What the housing takes in all, `−T_in − T_out`, as a torque on the gearbox.
    pub housing: f64,
    /// Power that leaves over power that enters; 1 without losses. At or below 0 the gear locks
    /// itself in this direction.
    pub efficiency: f64,
    /// Sense of the relative power of each row: 1 from sun to ring, −1 from ring to sun, 0 none (and
    /// so no loss).
    pub signs: Vec<i8>,
    /// Sense of the power in each shared mesh: 1 from planet to ring.
    pub shared_signs: Vec<i8>,
    /// Powers.
    pub power: PowerFlow,
}

/// Torques on the members of the active rows and at the terminals, as the kernel found them.
pub(crate) struct Found<'a> {
    pub(crate) direction: Direction,
    pub(crate) sun: &'a [f64],
    pub(crate) effective: &'a [f64],
    pub(crate) entering: f64,
    pub(crate) leaving: f64,
    pub(crate) efficiency: f64,
    pub(crate) signs: &'a [i8],
    pub(crate) shared_signs: &'a [i8],
}

pub(crate) struct Scene<'a> {
    pub(crate) gearbox: &'a Gearbox,
    pub(crate) topology: &'a Topology,
    pub(crate) verdict: &'a Verdict,
    pub(crate) compiled: &'a CompiledGear,
    pub(crate) speeds: &'a [Option<f64>],
}

/// The load case without losses, from the solution in a direction.
pub(crate) fn ideal(scene: &Scene, ratios: &[f64], solution: &Solution) -> LoadCase {
    let active = scene.compiled.active_rows();
    let effective: Vec<f64> = active.iter().map(|&row| ratios[usize::from(row)]).collect();
    load_case(
        scene,
        &Found {
            direction: Direction::Drive,
            sun: &solution.ideal_sun[..active.len()],
            effective: &effective,
            entering: 1.0,
            leaving: -solution.ratio(),
            efficiency: 1.0,
            signs: &solution.ideal_signs[..active.len()],
            shared_signs: &[],
        },
    )
}

/// The load case with losses; `None` where no torque moves the gear against them.
pub(crate) fn loaded(scene: &Scene, direction: Direction, solution: &Solution) -> Option<LoadCase> {
    let loaded = solution.loaded()?;
    let count = scene.compiled.active_rows().len();
    let entering = match direction {
        Direction::Drive => 1.0,
        Direction::Overrun => solution.ratio(),
    };
    Some(load_case(
        scene,
        &Found {
            direction,
            sun: &loaded.sun[..count],
            effective: &loaded.effective[..count],
            entering,
            leaving: loaded.other,
            efficiency: loaded.efficiency,
            signs: &solution.signs[..count],
            shared_signs: &solution.shared_signs[..scene.gearbox.shared.len()],
        },
    ))
}

fn load_case(scene: &Scene, found: &Found) -> LoadCase {
    let Scene { gearbox, verdict, .. } = scene;
    let rows = gearbox.rows.len();
    let mut members = vec![[0.0; 3]; rows];
    let mut signs = vec![0; rows];
    for (active, &row) in scene.compiled.active_rows().iter().enumerate() {
        let (sun, i) = (found.sun[active], found.effective[active]);
        members[usize::from(row)] = [sun, -i * sun, (i - 1.0) * sun];
        signs[usize::from(row)] = found.signs[active];
    }
    let (input, output) = match found.direction {
        Direction::Drive => (found.entering, found.leaving),
        Direction::Overrun => (found.leaving, found.entering),
    };
    // What the connections must supply to each link.
    let mut demand = vec![0.0; gearbox.links.len()];
    for (row, torques) in gearbox.rows.iter().zip(&members) {
        for (link, torque) in row.members.iter().zip(torques) {
            demand[link.0] += torque;
        }
    }
    let [input_link, output_link] = scene.topology.terminals;
    demand[input_link.0] -= input;
    demand[output_link.0] -= output;
    let edges = edge_torques(scene, &demand);
    let mut controls = vec![Some(0.0); gearbox.controls.len()];
    for (edge, torque) in scene.topology.edges.iter().zip(&edges) {
        if let Some(control) = edge.control {
            controls[control] = *torque;
        }
    }
    let members: Vec<Option<[f64; 3]>> = members
        .into_iter()
        .zip(&verdict.row_known)
        .map(|(torques, known)| known.then_some(torques))
        .collect();
    let power = power_flow(scene, &members, &edges, [input, output]);
    LoadCase {
        direction: found.direction,
        members,
        controls,
        input,
        output,
        housing: -input - output,
        efficiency: found.efficiency,
        signs,
        shared_signs: found.shared_signs.to_vec(),
        power,
    }
}

/// Torque of every connection on its first link.
///
/// A connection that is the only way between two sides carries what the side away from the housing
/// demands. One in a loop carries an unknown share.
fn edge_torques(scene: &Scene, demand: &[f64]) -> Vec<Option<f64>> {
    let edges = &scene.topology.edges;
    let side = |without: usize, start: LinkId| {
        let mut inside = vec![false; demand.len()];
        let mut waiting = vec![start.0];
        while let Some(link) = waiting.pop() {
            if std::mem::replace(&mut inside[link], true) {
                continue;
            }
            for (place, edge) in edges.iter().enumerate().filter(|(place, _)| *place != without) {
                let [first, second] = edge.links.map(|link| link.0);
                if place != without && first == link {
                    waiting.push(second);
                } else if second == link {
                    waiting.push(first);
                }
            }
        }
        inside
    };
    let total =
        |inside: &[bool]| inside.iter().zip(demand).filter(|(is, _)| **is).map(|(_, d)| d).sum::<f64>();
    let torque = |(place, edge): (usize, &crate::topology::Edge)| {
        let first = side(place, edge.links[0]);
        if first[edge.links[1].0] || !scene.verdict.edge_known[place] {
            return None;
        }
        Some(if first[0] { -total(&side(place, edge.links[1])) } else { total(&first) })
    };
    edges.iter().enumerate().map(torque).collect()
}

//! Torques in a gear, with and without losses: members, shift elements, input and output.

use crate::compiled::CompiledGear;
use crate::power_flow::{Flowing, MeshPower, PowerFlow, mesh_powers, power_flow};
use crate::solution::{Direction, Solution};
use crate::state::{Known, Verdict};
use crate::topology::{Edge, Topology};
use crate::{Gearbox, LinkId};

/// Torques and powers of a gear for one unit of input power.
///
/// Torques are multiples of the input torque. In [`Direction::Drive`] the input torque is 1. In
/// [`Direction::BackDrive`] the output torque is `i` and the input carries `−η`, the load. The [sign
/// convention](epicyclic_gears#sign-convention) is that of the workspace: torques act on the member from
/// outside.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadCase {
    /// Direction of power.
    pub direction: Direction,
    /// Torques on the members of each set, in the order of [`PlanetSet::members`](crate::PlanetSet::members):
    /// the carrier last; `None` in an idle set whose torque nothing settles.
    pub members: Vec<Option<Vec<f64>>>,
    /// Torque of each shift element on its first link (the second takes the opposite): 0 when open, `None`
    /// where elements in a loop share it in a way that nothing settles.
    pub shift_elements: Vec<Option<f64>>,
    /// Torque on the input from outside.
    pub input: f64,
    /// Torque on the output from outside.
    pub output: f64,
    /// Torque of the housing on the gearbox in all, `−T_in − T_out`.
    pub housing: f64,
    /// Power that leaves over power that enters; 1 without losses. At or below 0 the gear is
    /// self-locking in this direction.
    pub efficiency: f64,
    /// Direction of the rolling power in each segment of meshes that carry power together, set by set: 1 away
    /// from the gear of reference, −1 towards it, 0 none (and so no loss). A set with two central gears has
    /// one segment, 1 from the first to the second.
    pub signs: Vec<i8>,
    /// Powers.
    pub power: PowerFlow,
    /// Torques of each equation on its root, central gear and carrier.
    pub(crate) equations: Vec<[f64; 3]>,
    is_lossy: bool,
}

/// Torques of the active equations and at the terminals, as the solver found them.
pub(crate) struct Found<'a> {
    pub(crate) direction: Direction,
    pub(crate) root: &'a [f64],
    pub(crate) effective: &'a [f64],
    pub(crate) entering: f64,
    pub(crate) leaving: f64,
    pub(crate) efficiency: f64,
    /// Signs of the active segments.
    pub(crate) signs: &'a [i8],
    pub(crate) is_lossy: bool,
}

pub(crate) struct Scene<'a> {
    pub(crate) gearbox: &'a Gearbox,
    pub(crate) topology: &'a Topology,
    pub(crate) verdict: &'a Verdict,
    pub(crate) compiled: &'a CompiledGear,
    pub(crate) speeds: &'a [Option<f64>],
}

/// Torques on the links and sets of a gear, from the solver's results.
pub(crate) struct Members {
    /// Torques on the members of each set.
    pub(crate) sets: Vec<Vec<f64>>,
    /// Direction of the power in each segment of the gearbox, 0 in one that is not active.
    pub(crate) signs: Vec<i8>,
}

/// Torques on the members of the sets, for `t` and `î` of these equations and the signs of these segments.
pub(crate) fn members(
    gearbox: &Gearbox,
    [equations, segments]: [&[usize]; 2],
    [root, effective]: [&[f64]; 2],
    active_signs: &[i8],
) -> Members {
    let mut sets: Vec<Vec<f64>> = gearbox.sets.iter().map(|set| vec![0.0; set.members().len()]).collect();
    for ((&place, &t), &i) in equations.iter().zip(root).zip(effective) {
        let one = &gearbox.equations[place];
        let of_set = &mut sets[one.set];
        of_set[gearbox.sets[one.set].tree.root] += t;
        of_set[one.central] -= i * t;
        let carrier = of_set.len() - 1;
        of_set[carrier] += (i - 1.0) * t;
    }
    let mut signs = vec![0; gearbox.segments.len()];
    for (&segment, &sign) in segments.iter().zip(active_signs) {
        signs[segment] = sign;
    }
    Members { sets, signs }
}

/// The load case without losses, from the solution in a direction.
pub(crate) fn ideal(scene: &Scene, ratios: &[f64], solution: &Solution) -> LoadCase {
    let effective: Vec<f64> = scene.compiled.equations.iter().map(|&equation| ratios[equation]).collect();
    load_case(
        scene,
        &Found {
            direction: Direction::Drive,
            root: solution.ideal_sun_torques(),
            effective: &effective,
            entering: 1.0,
            leaving: solution.ideal_other,
            efficiency: 1.0,
            signs: solution.ideal_signs(),
            is_lossy: false,
        },
    )
}

/// The load case with losses; `None` where no torque moves the gear against them.
pub(crate) fn loaded(scene: &Scene, direction: Direction, solution: &Solution) -> Option<LoadCase> {
    let efficiency = solution.efficiency()?;
    let entering = match direction {
        Direction::Drive => 1.0,
        Direction::BackDrive => solution.ratio(),
    };
    Some(load_case(
        scene,
        &Found {
            direction,
            root: solution.root(),
            effective: solution.effective(),
            entering,
            leaving: solution.other,
            efficiency,
            signs: solution.signs(),
            is_lossy: true,
        },
    ))
}

fn load_case(scene: &Scene, found: &Found) -> LoadCase {
    let Scene { gearbox, verdict, .. } = scene;
    let active = [scene.compiled.equations.as_slice(), &scene.compiled.segments];
    let Members { sets, signs } = members(gearbox, active, [found.root, found.effective], found.signs);
    let (input, output) = match found.direction {
        Direction::Drive => (found.entering, found.leaving),
        Direction::BackDrive => (found.leaving, found.entering),
    };
    let mut demand = demands(gearbox, &sets);
    let [input_link, output_link] = scene.topology.terminals;
    demand[input_link.0] -= input;
    demand[output_link.0] -= output;
    let edges = edge_torques(scene.topology, &verdict.known, demand);
    let mut shift_elements = vec![Some(0.0); gearbox.shift_elements.len()];
    for (edge, torque) in scene.topology.edges.iter().zip(&edges) {
        if let Some(shift_element) = edge.shift_element {
            shift_elements[shift_element] = *torque;
        }
    }
    let known = |set: usize| gearbox.equations_of(set).all(|equation| verdict.known.equation(equation));
    let members: Vec<Option<Vec<f64>>> =
        sets.into_iter().enumerate().map(|(set, torques)| known(set).then_some(torques)).collect();
    let power = power_flow(&Flowing {
        gearbox,
        topology: scene.topology,
        speeds: scene.speeds,
        members: &members,
        edges: &edges,
        terminals: &[(input_link, input), (output_link, output)],
        least: 1.0,
    });
    let mut equations = vec![[0.0; 3]; gearbox.equations.len()];
    for ((&place, &t), &i) in scene.compiled.equations.iter().zip(found.root).zip(found.effective) {
        equations[place] = [t, -i * t, (i - 1.0) * t];
    }
    LoadCase {
        direction: found.direction,
        members,
        shift_elements,
        input,
        output,
        housing: -input - output,
        efficiency: found.efficiency,
        signs,
        power,
        equations,
        is_lossy: found.is_lossy,
    }
}

impl LoadCase {
    /// Power through each mesh of a set of its gearbox, in the order of
    /// [`PlanetSet::meshes`](crate::PlanetSet::meshes); `None` where torque or speed do not follow.
    #[must_use]
    pub fn meshes(&self, gearbox: &Gearbox, set: usize) -> Option<Vec<MeshPower>> {
        let power = self.power.sets.get(set)?.as_ref()?;
        let signs = self.is_lossy.then(|| self.signs_of(gearbox, set));
        Some(mesh_powers(gearbox.sets.get(set)?, power, signs, self.power.largest))
    }

    /// The directions of the rolling power of one set.
    #[must_use]
    pub fn signs_of(&self, gearbox: &Gearbox, set: usize) -> &[i8] {
        let from = gearbox.segments.partition_point(|segment| segment.set < set);
        let to = gearbox.segments.partition_point(|segment| segment.set <= set);
        self.signs.get(from..to).unwrap_or_default()
    }
}

/// Torques that the connections must supply to each link, for these torques on the sets' members.
pub(crate) fn demands(gearbox: &Gearbox, sets: &[Vec<f64>]) -> Vec<f64> {
    let mut demand = vec![0.0; gearbox.links.len()];
    for (set, torques) in gearbox.sets.iter().zip(sets) {
        for (link, torque) in set.members().iter().zip(torques) {
            demand[link.0] += torque;
        }
    }
    demand
}

/// Torque of every connection on its first link.
///
/// Torques of the connections. A connection that is the only way between two sides carries the demand of the
/// side away from the housing. One in a loop carries an unknown share.
pub(crate) fn edge_torques(topology: &Topology, known: &Known, mut demand: Vec<f64>) -> Vec<Option<f64>> {
    let mut torques: Vec<Option<f64>> = vec![None; topology.edges.len()];
    if topology.edges.is_empty() {
        return torques;
    }
    let mut degree = vec![0_usize; demand.len()];
    for Edge { links, .. } in &topology.edges {
        degree[links[0].0] += 1;
        degree[links[1].0] += 1;
    }
    let mut open: Vec<bool> = vec![true; topology.edges.len()];
    // From the ends inwards: the last connection of a link carries what the link and all behind it demand.
    loop {
        let leaf = |link: LinkId| link != LinkId::GROUND && degree[link.0] == 1;
        let Some(place) = (0..open.len())
            .find(|&place| open[place] && topology.edges[place].links.iter().any(|&link| leaf(link)))
        else {
            break;
        };
        let [first, second] = topology.edges[place].links;
        let (end, other, sign) = if leaf(first) { (first, second, 1.0) } else { (second, first, -1.0) };
        torques[place] = known.edge(place).then_some(sign * demand[end.0]);
        demand[other.0] += demand[end.0];
        degree[end.0] -= 1;
        degree[other.0] -= 1;
        open[place] = false;
    }
    // The remaining connections are in loops, or between them.
    for place in 0..open.len() {
        if open[place] && known.edge(place) {
            torques[place] = bridge(topology, &open, place, &demand);
        }
    }
    torques
}

/// Torque of a connection between two loops; `None` of one in a loop.
fn bridge(topology: &Topology, open: &[bool], place: usize, demand: &[f64]) -> Option<f64> {
    let side = |start: LinkId| {
        let mut inside = vec![false; demand.len()];
        let mut waiting = vec![start.0];
        while let Some(link) = waiting.pop() {
            if std::mem::replace(&mut inside[link], true) {
                continue;
            }
            for (other, edge) in topology.edges.iter().enumerate().filter(|(other, _)| open[*other]) {
                let [first, second] = edge.links.map(|link| link.0);
                if other != place && first == link {
                    waiting.push(second);
                } else if other != place && second == link {
                    waiting.push(first);
                }
            }
        }
        inside
    };
    let total =
        |inside: &[bool]| inside.iter().zip(demand).filter(|(is, _)| **is).map(|(_, d)| d).sum::<f64>();
    let [one, other] = topology.edges[place].links;
    let first = side(one);
    if first[other.0] {
        return None;
    }
    Some(if first[0] { -total(&side(other)) } else { total(&first) })
}

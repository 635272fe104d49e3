//! The general solver: any number of equations, given speeds and terminals.
//!
//! ```text
//! speeds     C·ω = 0    with ω of F nodes given                        N equations, N + F nodes
//! torques    Ĉᵀ·t − Σ T = 0 at every node                              T at the terminals, all but F given
//! ```
//!
//! This is the method of the kernel, written for any size, and the one for gears with several inputs.

use crate::branch::{self, Lossy};
use crate::solution::{Direction, RESTING, Run, Solution};
use epicyclic_numerics::linear::{Matrix, scaled_solution};
use epicyclic_numerics::values::largest_absolute;

/// Equations on nodes, with their losses.
pub(crate) struct Network {
    pub(crate) nodes: Vec<[Option<usize>; 3]>,
    pub(crate) ratios: Vec<f64>,
    pub(crate) runs: Vec<Run>,
    pub(crate) etas: Vec<f64>,
    /// Number of nodes.
    pub(crate) count: usize,
    /// A pivot up to this has vanished; 0 where the rank is proved.
    pub(crate) least_pivot: f64,
}

/// Torques of a network.
pub(crate) struct Balance {
    /// `t_j` and `î_j` of each equation.
    pub(crate) root: Vec<f64>,
    pub(crate) effective: Vec<f64>,
    /// Torque at each terminal, in their order.
    pub(crate) terminals: Vec<f64>,
    /// Rolling power of each segment, and the largest power.
    power: Vec<f64>,
    pub(crate) largest: f64,
}

/// A network at known speeds, with torques given at some of its terminals.
pub(crate) struct Loads<'a> {
    pub(crate) network: &'a Network,
    pub(crate) speeds: &'a [f64],
    /// Nodes where torque acts from outside, with the torque where it is given.
    pub(crate) terminals: &'a [(usize, Option<f64>)],
}

impl Network {
    /// Factors of the equations: equation, node and factor.
    fn factors(&self, ratios: &[f64]) -> impl Iterator<Item = (usize, usize, f64)> {
        let of = |(equation, (&nodes, &i)): (usize, (&[Option<usize>; 3], &f64))| {
            let factors = nodes.into_iter().zip([1.0, -i, i - 1.0]);
            factors.filter_map(move |(node, factor)| node.map(|node| (equation, node, factor)))
        };
        self.nodes.iter().zip(ratios).enumerate().flat_map(of)
    }

    /// Speeds of all nodes for these given ones; `None` where they do not follow.
    pub(crate) fn speeds(&self, given: &[(usize, f64)]) -> Option<Vec<f64>> {
        let mut equations = Matrix::zeros(self.nodes.len() + given.len(), self.count + 1);
        for (equation, node, factor) in self.factors(&self.ratios) {
            equations.row_mut(equation)[node] += factor;
        }
        for (place, &(node, speed)) in given.iter().enumerate() {
            let row = equations.row_mut(self.nodes.len() + place);
            (row[node], row[self.count]) = (1.0, speed);
        }
        scaled_solution(equations, self.least_pivot)
    }

    /// Speeds of root, central gear and carrier of an equation.
    pub(crate) fn member_speeds(&self, equation: usize, speeds: &[f64]) -> [f64; 3] {
        self.nodes[equation].map(|node| node.map_or(0.0, |node| speeds[node]))
    }

    /// The gear of a compiled one: input at node 0.
    pub(crate) fn solve_gear(&self, output: usize, direction: Direction, solution: &mut Solution) -> bool {
        solution.resize(self.nodes.len(), self.runs.len());
        let Some(speeds) = self.speeds(&[(0, 1.0)]) else { return false };
        let output_speed = if output == usize::from(RESTING) { 0.0 } else { speeds[output] };
        let given = match direction {
            Direction::Drive => 1.0,
            Direction::BackDrive => 1.0 / output_speed,
        };
        if output_speed == 0.0 || !given.is_finite() {
            return false;
        }
        solution.output_speed = output_speed;
        let written = solution.written();
        written.speeds.copy_from_slice(&speeds);
        for (place, relative) in written.relative_speed.iter_mut().enumerate() {
            let [a, _, h] = self.member_speeds(place, &speeds);
            *relative = a - h;
        }
        let (known, other, other_speed) = match direction {
            Direction::Drive => (0, output, output_speed),
            Direction::BackDrive => (output, 0, 1.0),
        };
        let terminals = [(known, Some(given)), (other, None)];
        let terminals = if known == other { &terminals[..0] } else { &terminals[..] };
        let loads = Loads { network: self, speeds: &speeds, terminals };
        let Some(ideal) = loads.balance(&self.ratios) else { return false };
        let (found, ideal_signs, signs) = loads.branch(&ideal);
        let written = solution.written();
        written.ideal_root.copy_from_slice(&ideal.root);
        written.ideal_signs.copy_from_slice(&ideal_signs);
        written.signs.copy_from_slice(&signs);
        if let Some(found) = &found {
            written.root.copy_from_slice(&found.root);
            written.effective.copy_from_slice(&found.effective);
        }
        solution.ideal_other = ideal.terminals.get(1).copied().unwrap_or(-given);
        solution.has_branch = found.is_some();
        if let Some(found) = found {
            solution.other = found.terminals.get(1).copied().unwrap_or(-given);
            solution.efficiency = -solution.other * other_speed;
        }
        true
    }
}

impl Loads<'_> {
    /// Torques at these effective ratios; `None` where they do not follow.
    pub(crate) fn balance(&self, effective: &[f64]) -> Option<Balance> {
        let network = self.network;
        let unknown: Vec<usize> =
            (0..self.terminals.len()).filter(|&place| self.terminals[place].1.is_none()).collect();
        let equations = network.nodes.len();
        // Without terminals input and output are one: nothing passes through the sets, and the
        // balance of the first node is idle.
        let idle = usize::from(self.terminals.is_empty());
        let right = equations + unknown.len();
        let mut system = Matrix::zeros(network.count - idle, right + 1);
        for (j, node, factor) in network.factors(effective) {
            if let Some(balance) = node.checked_sub(idle) {
                system.row_mut(balance)[j] += factor;
            }
        }
        for (column, &place) in unknown.iter().enumerate() {
            system.row_mut(self.terminals[place].0)[equations + column] = -1.0;
        }
        for (node, torque) in self.terminals {
            system.row_mut(*node)[right] += torque.unwrap_or(0.0);
        }
        let solved = scaled_solution(system, network.least_pivot)?;
        let mut found = solved[equations..].iter();
        let terminals =
            self.terminals.iter().map(|(_, torque)| torque.or_else(|| found.next().copied()).unwrap_or(0.0));
        let terminals: Vec<f64> = terminals.collect();
        let root = solved[..equations].to_vec();
        let mut largest = 0.0_f64;
        for ((node, _), torque) in self.terminals.iter().zip(&terminals) {
            largest = largest.max((torque * self.speeds[*node]).abs());
        }
        for (j, (&t, &i)) in root.iter().zip(effective).enumerate() {
            let [a, b, h] = network.member_speeds(j, self.speeds);
            for power in [t * (a - h), t * a, i * t * b, (i - 1.0) * t * h] {
                largest = largest.max(power.abs());
            }
        }
        let of_run = |run: &Run| {
            let [a, _, h] = network.member_speeds(run.from, self.speeds);
            root[run.from..run.to].iter().sum::<f64>() * (a - h)
        };
        let power = network.runs.iter().map(of_run).collect();
        Some(Balance { root, effective: effective.to_vec(), terminals, power, largest })
    }

    /// The branch that starts at the balance without losses, with the signs there and on the branch.
    pub(crate) fn branch(&self, ideal: &Balance) -> (Option<Balance>, Vec<i8>, Vec<i8>) {
        let mut signs = branch::signs(&ideal.power, ideal.largest, vec![0; ideal.power.len()]);
        let first = signs.clone();
        let found = branch::find(self, &mut signs);
        (found, first, signs)
    }
}

impl Lossy<Vec<i8>> for Loads<'_> {
    type Found = Balance;

    fn at(&self, signs: &Vec<i8>, share: f64) -> Option<Balance> {
        let network = self.network;
        let mut effective = network.ratios.clone();
        for ((run, &eta), &sign) in network.runs.iter().zip(&network.etas).zip(signs) {
            let part = branch::part(eta, sign, share);
            effective[run.from..run.to].iter_mut().for_each(|i| *i *= part);
        }
        self.balance(&effective)
    }

    fn powers<'f>(&self, found: &'f Balance) -> (&'f [f64], f64) {
        (&found.power, found.largest)
    }

    fn largest_torque(&self, found: &Balance) -> f64 {
        largest_absolute(found.root.iter().chain(&found.terminals))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_power_is_that_of_a_member_or_of_rolling() {
        for i in [-3.0, -0.4, 0.3, 2.5] {
            let network = Network {
                nodes: vec![[Some(0), Some(1), Some(2)]],
                ratios: vec![i],
                etas: vec![1.0],
                runs: vec![Run { from: 0, to: 1 }],
                count: 3,
                least_pivot: 0.0,
            };
            for [a, b] in [[-1.0, 1.0], [1.0, 0.0], [0.1, 2.0], [0.5, -0.2], [0.01, 0.02]] {
                // Willis, and the torques of a set without losses: 1, −i and i − 1 of the first.
                let h = (i * b - a) / (i - 1.0);
                for torque in [2.0, -0.7] {
                    let torques = [torque, -i * torque, (i - 1.0) * torque];
                    let rolling = torque * (a - h);
                    let powers = [torques[0] * a, torques[1] * b, torques[2] * h, rolling];
                    assert!(powers[..3].iter().sum::<f64>().abs() < 1e-12);
                    let largest = powers.iter().fold(0.0_f64, |most, power| most.max(power.abs()));
                    let terminals = [(0, Some(torque)), (1, None), (2, None)];
                    let loads = Loads { network: &network, speeds: &[a, b, h], terminals: &terminals };
                    let found = loads.balance(&network.ratios).unwrap();
                    let off = found.terminals.iter().zip(torques).map(|(one, due)| (one - due).abs());
                    assert!(off.fold(0.0, f64::max) < 1e-12, "{:?} {torques:?}", found.terminals);
                    assert!(
                        (found.largest - largest).abs() < 1e-12 && (found.power[0] - rolling).abs() < 1e-12
                    );
                }
            }
        }
    }
}

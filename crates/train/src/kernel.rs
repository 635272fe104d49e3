//! The numbers of one gear: small dense systems of fixed size on the stack.
//!
//! The kernel has `N` equations for `N + 1` nodes that can turn, node 0 the input. One matrix serves all
//! systems: its row `j` holds the factors `1, −i, i − 1` of equation `j` at its nodes.
//!
//! ```text
//! speeds     C·ω = 0                  with ω_in = 1
//! torques    Ĉᵀ·t = T_in·e_in + T_out·e_out      î = i·Π η^w in Ĉ
//! signs      w = sign (ω_r − ω_H)·Σ t        over the equations behind a segment of meshes
//! ```
//!
//! `PLAIN` gears have one segment an equation: all sets have two central gears.
//!
//! # The branch
//! The valid signs are those continuous with `η → 1`; the ideal torques give them. If the loaded torques
//! confirm all signs, they are the result. If not, some set is so nearly idle that the losses of the others
//! reverse its power. The losses are then raised from nothing to their full size, and a sign turns where its
//! power passes through zero ([`crate::branch`]). The torques are continuous there. If they grow to infinity
//! on the way instead, no input torque keeps the gear moving at the full losses, and no branch exists.

use crate::branch::{self, Lossy};
use crate::solution::{Direction, RESTING, Run, Solution};

/// Columns of a matrix of factors; the last one collects the terms tied to the housing.
const COLUMNS: usize = 16;
/// Node of the housing and of all links that are one piece with it.
pub(crate) const HOUSING: usize = COLUMNS - 1;
/// Largest number of equations in the kernel.
pub(crate) const MOST_EQUATIONS: usize = 12;
/// Largest number of segments in the kernel for gears with compound sets: two per equation.
pub(crate) const MOST_SEGMENTS: usize = 2 * MOST_EQUATIONS;

/// A gear, in the order of its active equations.
pub(crate) struct Problem<'a, const N: usize, const M: usize, const PLAIN: bool> {
    pub(crate) nodes: [[u8; 3]; N],
    pub(crate) i0: [f64; N],
    pub(crate) eta: [f64; M],
    /// Equations behind each segment; not read of a plain gear.
    pub(crate) runs: &'a [Run],
    pub(crate) output: usize,
    pub(crate) direction: Direction,
    /// A pivot up to this has vanished; 0 where the rank is proved.
    pub(crate) least_pivot: f64,
}

type Matrix<const N: usize> = [[f64; COLUMNS]; N];

/// Torques under some signs.
pub(crate) struct Torques<const N: usize, const M: usize> {
    effective: [f64; N],
    root: [f64; N],
    /// Torque at the terminal that was not given.
    other: f64,
    /// Rolling power of each segment, and the largest internal power.
    power: [f64; M],
    largest: f64,
}

/// A kernel's node from a compiled one.
pub(crate) fn narrow(node: u16) -> u8 {
    if node == RESTING { HOUSING as u8 } else { node as u8 }
}

impl<const N: usize, const M: usize, const PLAIN: bool> Problem<'_, N, M, PLAIN> {
    pub(crate) fn solve(&self, solution: &mut Solution) -> bool {
        solution.resize(N, self.segments());
        let matrix = self.matrix(&self.i0);
        let Some(speeds) = speeds(&matrix, self.least_pivot) else { return false };
        let written = solution.written();
        written.speeds[0] = 1.0;
        written.speeds[1..=N].copy_from_slice(&speeds);
        let member = self.members(written.speeds);
        let output = written.speeds[self.output];
        solution.output_speed = output;

        // One unit of power enters: at the input with torque 1, or at the output with torque i.
        let given = match self.direction {
            Direction::Drive => 1.0,
            Direction::BackDrive => 1.0 / output,
        };
        if !given.is_finite() || output == 0.0 {
            return false;
        }
        let Some((root, other)) = self.torques(&matrix, given) else { return false };
        let ideal = self.powers(&member, self.i0, root, other);
        solution.ideal_other = other;
        let count = self.segments();
        let mut signs = branch::signs(&ideal.power[..count], ideal.largest, [0; M]);
        let written = solution.written();
        written.ideal_root.copy_from_slice(&root);
        for (relative, [a, _, h]) in written.relative_speed.iter_mut().zip(member) {
            *relative = a - h;
        }
        written.ideal_signs.copy_from_slice(&signs[..count]);
        let lossy = Loaded { problem: self, member: &member, given };
        let found = branch::find(&lossy, &mut signs);
        written.signs.copy_from_slice(&signs[..count]);
        if let Some(found) = &found {
            written.root.copy_from_slice(&found.root);
            written.effective.copy_from_slice(&found.effective);
        }
        solution.has_branch = found.is_some();
        if let Some(found) = found {
            solution.other = found.other;
            // Power that leaves at the other terminal, of 1 that enters.
            let other_speed = match self.direction {
                Direction::Drive => output,
                Direction::BackDrive => 1.0,
            };
            solution.efficiency = -found.other * other_speed;
        }
        true
    }

    #[inline]
    fn segments(&self) -> usize {
        if PLAIN { N } else { self.runs.len() }
    }

    /// Speeds of root, central gear and carrier of each equation.
    pub(crate) fn members(&self, speeds: &[f64]) -> [[f64; 3]; N] {
        let speed = |node: u8| if usize::from(node) == HOUSING { 0.0 } else { speeds[usize::from(node)] };
        self.nodes.map(|nodes| nodes.map(speed))
    }

    fn matrix(&self, i0: &[f64; N]) -> Matrix<N> {
        let mut matrix = [[0.0; COLUMNS]; N];
        for ((row, nodes), &i) in matrix.iter_mut().zip(&self.nodes).zip(i0) {
            row[usize::from(nodes[0]) & HOUSING] += 1.0;
            row[usize::from(nodes[1]) & HOUSING] -= i;
            row[usize::from(nodes[2]) & HOUSING] += i - 1.0;
        }
        matrix
    }

    /// Torques on the roots for `given` at the terminal where power enters, and the torque at the
    /// other terminal.
    fn torques(&self, matrix: &Matrix<N>, given: f64) -> Option<([f64; N], f64)> {
        let (known, other) = match self.direction {
            Direction::Drive => (0, self.output),
            Direction::BackDrive => (self.output, 0),
        };
        let mut equations = [[0.0; N]; N];
        let mut right = [0.0; N];
        for (equation, place) in (0..=N).filter(|&node| node != other).zip(0..N) {
            for (j, row) in matrix.iter().enumerate() {
                equations[place][j] = row[equation];
            }
            if equation == known {
                right[place] = given;
            }
        }
        let root = gauss(equations, right, self.least_pivot)?;
        if known == other {
            return Some((root, -given));
        }
        Some((root, (0..N).map(|j| matrix[j][other] * root[j]).sum()))
    }

    /// Rolling powers, and the largest power.
    fn powers(
        &self,
        member: &[[f64; 3]; N],
        effective: [f64; N],
        root: [f64; N],
        other: f64,
    ) -> Torques<N, M> {
        let mut found = Torques { effective, root, other, power: [0.0; M], largest: 1.0 };
        for j in 0..N {
            let [a, b, h] = member[j];
            let (central, carrier) = (-effective[j] * root[j], (effective[j] - 1.0) * root[j]);
            let power = root[j] * (a - h);
            if PLAIN {
                found.power[j] = power;
            }
            found.largest = found
                .largest
                .max(power.abs())
                .max((root[j] * a).abs())
                .max((central * b).abs())
                .max((carrier * h).abs());
        }
        if !PLAIN {
            for (power, run) in found.power.iter_mut().zip(self.runs) {
                let [a, _, h] = member[run.from];
                *power = root[run.from..run.to].iter().sum::<f64>() * (a - h);
            }
        }
        found
    }

    /// Torques with losses at `share` of their full size: `η^share`.
    fn loaded(
        &self,
        member: &[[f64; 3]; N],
        signs: &[i8; M],
        share: f64,
        given: f64,
    ) -> Option<Torques<N, M>> {
        let mut effective = self.i0;
        if PLAIN {
            for j in 0..N {
                effective[j] *= branch::part(self.eta[j], signs[j], share);
            }
        } else {
            for (segment, run) in self.runs.iter().enumerate() {
                let part = branch::part(self.eta[segment], signs[segment], share);
                effective[run.from..run.to].iter_mut().for_each(|i| *i *= part);
            }
        }
        let (root, other) = self.torques(&self.matrix(&effective), given)?;
        Some(self.powers(member, effective, root, other))
    }
}

/// A gear under its losses, one torque given.
pub(crate) struct Loaded<'p, 'a, const N: usize, const M: usize, const PLAIN: bool> {
    pub(crate) problem: &'p Problem<'a, N, M, PLAIN>,
    pub(crate) member: &'p [[f64; 3]; N],
    pub(crate) given: f64,
}

impl<const N: usize, const M: usize, const PLAIN: bool> Lossy<[i8; M]> for Loaded<'_, '_, N, M, PLAIN> {
    type Found = Torques<N, M>;

    fn at(&self, signs: &[i8; M], share: f64) -> Option<Torques<N, M>> {
        self.problem.loaded(self.member, signs, share, self.given)
    }

    fn powers<'f>(&self, found: &'f Torques<N, M>) -> (&'f [f64], f64) {
        (&found.power[..self.problem.segments()], found.largest)
    }

    fn largest_torque(&self, found: &Torques<N, M>) -> f64 {
        found.root.iter().fold(found.other.abs(), |most, torque| most.max(torque.abs()))
    }
}

/// Speeds of nodes 1…N for a speed of 1 of node 0.
fn speeds<const N: usize>(matrix: &Matrix<N>, least_pivot: f64) -> Option<[f64; N]> {
    let mut equations = [[0.0; N]; N];
    let mut right = [0.0; N];
    for (j, row) in matrix.iter().enumerate() {
        equations[j].copy_from_slice(&row[1..=N]);
        right[j] = -row[0];
    }
    gauss(equations, right, least_pivot)
}

/// Solves `a·x = b` by elimination with row pivoting; `None` where a pivot vanishes.
///
/// Equations are not scaled: at the gear's own ratios the rank is proved, and no pivot is too small.
#[inline]
#[allow(clippy::needless_range_loop, reason = "indices are those of the formulas")]
fn gauss<const N: usize>(mut a: [[f64; N]; N], mut b: [f64; N], least_pivot: f64) -> Option<[f64; N]> {
    for k in 0..N {
        let mut pivot = k;
        for r in k + 1..N {
            if a[r][k].abs() > a[pivot][k].abs() {
                pivot = r;
            }
        }
        if pivot != k {
            a.swap(k, pivot);
            b.swap(k, pivot);
        }
        if a[k][k].abs() <= least_pivot || a[k][k].is_nan() {
            return None;
        }
        let inverse = 1.0 / a[k][k];
        for r in k + 1..N {
            let factor = a[r][k] * inverse;
            for c in k + 1..N {
                a[r][c] -= factor * a[k][c];
            }
            b[r] -= factor * b[k];
        }
    }
    for k in (0..N).rev() {
        for c in k + 1..N {
            b[k] -= a[k][c] * b[c];
        }
        b[k] /= a[k][k];
    }
    Some(b)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A set alone: sun, ring and carrier on nodes of their own.
    fn set<const PLAIN: bool>(i: f64, runs: &[Run]) -> Problem<'_, 1, 1, PLAIN> {
        Problem {
            nodes: [[0, 1, 2]],
            i0: [i],
            eta: [1.0],
            runs,
            output: 1,
            direction: Direction::Drive,
            least_pivot: 0.0,
        }
    }

    #[test]
    fn the_largest_power_is_that_of_a_member_or_of_rolling() {
        let runs = [Run { from: 0, to: 1 }];
        for i in [-3.0, -0.4, 0.3, 2.5] {
            for [a, b] in [[-1.0, 1.0], [1.0, 0.0], [0.1, 2.0], [0.5, -0.2], [0.01, 0.02]] {
                // Willis, and the torques of a set without losses: 1, −i and i − 1 of the first.
                let h = (i * b - a) / (i - 1.0);
                for torque in [2.0, -0.7] {
                    let powers = [torque * a, -i * torque * b, (i - 1.0) * torque * h, torque * (a - h)];
                    assert!(powers[..3].iter().sum::<f64>().abs() < 1e-12);
                    // The power that enters is 1.
                    let largest = powers.iter().fold(1.0_f64, |most, power| most.max(power.abs()));
                    let plain = set::<true>(i, &[]).powers(&[[a, b, h]], [i], [torque], 0.0);
                    let other = set::<false>(i, &runs).powers(&[[a, b, h]], [i], [torque], 0.0);
                    for found in [plain, other] {
                        assert!((found.largest - largest).abs() < 1e-12, "{i} {a} {b}");
                        assert!((found.power[0] - powers[3]).abs() < 1e-12, "{i} {a} {b}");
                    }
                }
            }
        }
    }
}

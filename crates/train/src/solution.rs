//! Solution of a gear, and the parts that its solvers share: the direction of power, runs of equations.

/// Node of the housing and of all links that are one piece with it.
pub(crate) const RESTING: u16 = u16::MAX;

/// Direction of power through a gear.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// Power from input to output: a torque of 1 enters at the input, with speed 1.
    Drive,
    /// Power from output to input: a torque of `i` enters at the output, with speed `1/i`.
    BackDrive,
}

/// Active equations behind a segment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Run {
    pub(crate) from: usize,
    pub(crate) to: usize,
}

/// Everything [`CompiledGear::solve`](crate::CompiledGear::solve) finds, to be used again.
///
/// Speeds are multiples of the input's. Torques are those for one unit of power that enters: see
/// [`Direction`]. Equations and segments are the gear's active ones.
#[derive(Debug, Clone, Default)]
pub struct Solution {
    /// For each equation `ω_r − ω_H`, then `t` without losses, `t` with losses and `î`; last the speeds of
    /// the nodes.
    numbers: Vec<f64>,
    equations: usize,
    /// For each segment the direction of its power without losses, then with losses.
    senses: Vec<i8>,
    pub(crate) output_speed: f64,
    pub(crate) ideal_other: f64,
    /// Whether any torque keeps the gear moving against its losses.
    pub(crate) has_branch: bool,
    /// Torque at the terminal where power leaves.
    pub(crate) other: f64,
    pub(crate) efficiency: f64,
}

/// Mutable parts of a solution, for the solver to write.
pub(crate) struct Written<'s> {
    pub(crate) relative_speed: &'s mut [f64],
    pub(crate) ideal_root: &'s mut [f64],
    pub(crate) root: &'s mut [f64],
    pub(crate) effective: &'s mut [f64],
    pub(crate) speeds: &'s mut [f64],
    pub(crate) ideal_signs: &'s mut [i8],
    pub(crate) signs: &'s mut [i8],
}

impl Solution {
    pub(crate) fn resize(&mut self, equations: usize, segments: usize) {
        let numbers = 5 * equations + 1;
        if self.numbers.len() != numbers {
            self.numbers.resize(numbers, 0.0);
            self.equations = equations;
        }
        if self.senses.len() != 2 * segments {
            self.senses.resize(2 * segments, 0);
        }
    }

    pub(crate) fn written(&mut self) -> Written<'_> {
        let count = self.equations;
        let (relative_speed, rest) = self.numbers.split_at_mut(count);
        let (ideal_root, rest) = rest.split_at_mut(count);
        let (root, rest) = rest.split_at_mut(count);
        let (effective, speeds) = rest.split_at_mut(count);
        let segments = self.senses.len() / 2;
        let (ideal_signs, signs) = self.senses.split_at_mut(segments);
        Written { relative_speed, ideal_root, root, effective, speeds, ideal_signs, signs }
    }

    fn of_equations(&self, block: usize) -> &[f64] {
        &self.numbers[block * self.equations..(block + 1) * self.equations]
    }

    /// `t` of each equation, with losses.
    pub(crate) fn root(&self) -> &[f64] {
        self.of_equations(2)
    }

    /// `î` of each equation.
    pub(crate) fn effective(&self) -> &[f64] {
        self.of_equations(3)
    }

    /// Speeds of the nodes, the input first.
    pub(crate) fn speeds(&self) -> &[f64] {
        &self.numbers[4 * self.equations..]
    }

    pub(crate) fn ideal_signs(&self) -> &[i8] {
        &self.senses[..self.senses.len() / 2]
    }

    /// Ratio `i = ω_in/ω_out`.
    #[must_use]
    pub fn ratio(&self) -> f64 {
        1.0 / self.output_speed
    }

    /// Power that leaves over power that enters; `None` where no torque moves the gear against its losses.
    ///
    /// At or below zero the gear is self-locking in this direction: it moves only if power enters at both
    /// ends.
    #[must_use]
    pub fn efficiency(&self) -> Option<f64> {
        self.has_branch.then_some(self.efficiency)
    }

    /// Torque on the first central gear of each active set with two of them.
    #[must_use]
    pub fn sun_torques(&self) -> Option<&[f64]> {
        self.has_branch.then(|| self.root())
    }

    /// Torque on the first central gear of each active set with two of them, without losses.
    #[must_use]
    pub fn ideal_sun_torques(&self) -> &[f64] {
        self.of_equations(1)
    }

    /// Speed relative to the carrier of the gear of reference of each active equation, `ω_r − ω_H`.
    #[must_use]
    pub fn relative_speeds(&self) -> &[f64] {
        self.of_equations(0)
    }

    /// Direction of the rolling power of each segment: 1 away from the gear of reference, −1 towards it, 0
    /// none.
    #[must_use]
    pub fn signs(&self) -> &[i8] {
        &self.senses[self.senses.len() / 2..]
    }
}

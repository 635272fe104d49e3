//! One step of an explicit Runge–Kutta method of order 8 with dense output of order 7.
//!
//! # Why not a crate
//! An event needs the same step again, shortened, from stages that are known. It also needs a derivative that
//! sees every stage, so that an event inside a step shows; and no allocation at a restart, because a shift
//! has many restarts. Three crates of explicit methods were considered. `ode_solvers` integrates to the end
//! without stopping. `differential-equations` steps singly but cannot repeat a step and allocates some thirty
//! vectors at each start. `diffsol` brings its own linear algebra and its own stopping rule for one event at
//! a time. Hence this file: the method alone, two hundred lines, its order tested.
//!
//! ```text
//! k_i = f(t + c_i·h, y + h·Σ a_ij·k_j)        y_1 = y + h·Σ b_i·k_i
//! error = h·|e5|²/√(n·(|e5|² + 0.01·|e3|²))   e5 = Σ e5_i·k_i/scale, e3 so too
//! y(t + θ·h) = y + θ·(F_0 + (1 − θ)·(F_1 + θ·(F_2 + …)))
//! ```

mod coefficients;

use coefficients::{A, B, C, D, E3, E5};

/// Stages of the step.
const STAGES: usize = 12;

/// Places in the step at which a [try](Stepper::attempt) evaluates the derivative, in this order.
pub(crate) const PLACES: [f64; STAGES] =
    [C[1], C[2], C[3], C[4], C[5], C[6], C[7], C[8], C[9], C[10], C[11], 1.0];

/// A method at a point, with what it knows of the last step tried.
#[derive(Debug, Clone)]
pub(crate) struct Stepper {
    pub(crate) t: f64,
    pub(crate) y: Vec<f64>,
    /// The step tried last, and where it leads.
    pub(crate) h: f64,
    pub(crate) end: Vec<f64>,
    /// `k`: those of the step, at its end, and three of the dense output.
    stages: Vec<Vec<f64>>,
    terms: Vec<Vec<f64>>,
    work: Vec<f64>,
}

impl Stepper {
    pub(crate) fn new(size: usize) -> Self {
        let zeros = || vec![0.0; size];
        Self {
            t: 0.0,
            y: zeros(),
            h: 0.0,
            end: zeros(),
            stages: (0..16).map(|_| zeros()).collect(),
            terms: (0..7).map(|_| zeros()).collect(),
            work: zeros(),
        }
    }

    /// Evaluates the derivative at the start.
    pub(crate) fn begin(&mut self, mut f: impl FnMut(f64, &[f64], &mut [f64])) {
        f(self.t, &self.y, &mut self.stages[0]);
    }

    /// Tries a step; the derivative at its end is the last evaluated.
    pub(crate) fn attempt(&mut self, h: f64, mut f: impl FnMut(f64, &[f64], &mut [f64])) {
        self.h = h;
        for stage in 1..STAGES {
            self.stage(stage, &mut f);
        }
        let Self { y, end, stages, .. } = self;
        for (at, (end, y)) in end.iter_mut().zip(y.iter()).enumerate() {
            let sum: f64 = B.iter().zip(stages.iter()).map(|(b, k)| b * k[at]).sum();
            *end = y + h * sum;
        }
        f(self.t + h, &self.end, &mut self.stages[STAGES]);
    }

    fn stage(&mut self, stage: usize, f: &mut impl FnMut(f64, &[f64], &mut [f64])) {
        let (known, new) = self.stages.split_at_mut(stage);
        self.work.copy_from_slice(&self.y);
        for (factor, k) in A[stage - 1].iter().zip(known.iter()) {
            if *factor != 0.0 {
                self.work.iter_mut().zip(k).for_each(|(work, k)| *work += self.h * factor * k);
            }
        }
        f(self.t + C[stage] * self.h, &self.work, &mut new[0]);
    }

    /// Error of the step tried over these scales; up to 1 it is good.
    pub(crate) fn error(&self, scales: &[f64]) -> f64 {
        let (mut fifth, mut third) = (0.0, 0.0);
        for (at, scale) in scales.iter().enumerate() {
            let (mut five, mut three) = (0.0, 0.0);
            for ((e5, e3), k) in E5.iter().zip(&E3).zip(&self.stages) {
                five += e5 * k[at];
                three += e3 * k[at];
            }
            fifth += (five / scale) * (five / scale);
            third += (three / scale) * (three / scale);
        }
        // Squares of what hardly moves may be too small for a number.
        let both = fifth + 0.01 * third;
        if both == 0.0 {
            return 0.0;
        }
        self.h.abs() * fifth / (both * scales.len() as f64).sqrt()
    }

    /// Goes to the end of the step tried.
    pub(crate) fn accept(&mut self) {
        self.t += self.h;
        std::mem::swap(&mut self.y, &mut self.end);
        self.stages.swap(0, STAGES);
    }

    /// Prepares [`at`](Self::at) for the step tried, with three more derivatives.
    pub(crate) fn densify(&mut self, mut f: impl FnMut(f64, &[f64], &mut [f64])) {
        for stage in STAGES + 1..16 {
            self.stage(stage, &mut f);
        }
        let Self { y, h, end, stages, terms, .. } = self;
        for at in 0..y.len() {
            let (difference, first, last) = (end[at] - y[at], *h * stages[0][at], *h * stages[STAGES][at]);
            terms[0][at] = difference;
            terms[1][at] = first - difference;
            terms[2][at] = 2.0 * difference - (first + last);
            for (term, factors) in terms[3..].iter_mut().zip(&D) {
                term[at] = *h * factors.iter().zip(stages.iter()).map(|(d, k)| d * k[at]).sum::<f64>();
            }
        }
    }

    /// State at a part of the step tried, after [`densify`](Self::densify).
    pub(crate) fn at(&self, part: f64, out: &mut [f64]) {
        for (at, out) in out.iter_mut().enumerate() {
            let mut sum = 0.0;
            for (place, term) in self.terms.iter().rev().enumerate() {
                sum = (sum + term[at]) * if place % 2 == 0 { part } else { 1.0 - part };
            }
            *out = self.y[at] + sum;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A pendulum with growing gravity; a long enough way that errors are above rounding.
    fn field(t: f64, y: &[f64], dy: &mut [f64]) {
        dy[0] = y[1];
        dy[1] = -(1.0 + 0.2 * t) * libm::sin(y[0]);
    }

    fn integrated(steps: usize) -> [f64; 2] {
        let mut stepper = Stepper::new(2);
        stepper.y.copy_from_slice(&[1.0, 0.5]);
        stepper.begin(field);
        for _ in 0..steps {
            stepper.attempt(4.0 / steps as f64, field);
            stepper.accept();
        }
        [stepper.y[0], stepper.y[1]]
    }

    #[test]
    fn halving_the_step_divides_the_error_by_two_to_the_eighth_or_more() {
        let due = integrated(256);
        let error = |steps| (integrated(steps)[0] - due[0]).abs();
        let order = libm::log2(error(8) / error(16));
        assert!(order > 8.0, "{order}");
    }

    #[test]
    fn halving_the_step_divides_the_error_inside_it_by_two_to_the_eighth_or_more() {
        let error = |h: f64| {
            let mut stepper = Stepper::new(2);
            stepper.y.copy_from_slice(&[1.0, 0.5]);
            stepper.begin(field);
            let start = stepper.clone();
            stepper.attempt(h, field);
            stepper.densify(field);
            let mut inside = [0.0; 2];
            stepper.at(0.3, &mut inside);
            let mut fine = start;
            for _ in 0..8 {
                fine.attempt(0.3 * h / 8.0, field);
                fine.accept();
            }
            (inside[0] - fine.y[0]).abs()
        };
        // Local error of an output of order 7.
        let order = libm::log2(error(1.0) / error(0.5));
        assert!(order > 8.0, "{order}");
    }

    /// The estimate is a number down to speeds whose squares are no longer numbers, as rounding leaves them
    /// in bodies at rest.
    #[test]
    fn the_estimate_of_what_hardly_moves_is_a_number() {
        for exponent in -323..0 {
            let mut stepper = Stepper::new(2);
            let size = libm::pow(10.0, f64::from(exponent));
            let field = |t: f64, _: &[f64], dy: &mut [f64]| dy.fill(size * (1.0 + libm::sin(9.0 * t)));
            stepper.begin(field);
            stepper.attempt(1.0, field);
            let error = stepper.error(&[1.0, 1e-9]);
            assert!(error.is_finite() && error >= 0.0, "{size:e}: {error}");
        }
    }

    #[test]
    fn the_estimate_is_not_below_the_error() {
        let mut stepper = Stepper::new(2);
        stepper.y.copy_from_slice(&[1.0, 0.5]);
        stepper.begin(field);
        stepper.attempt(0.5, field);
        let estimate = stepper.error(&[1.0, 1.0]);
        let mut fine = Stepper::new(2);
        fine.y.copy_from_slice(&[1.0, 0.5]);
        fine.begin(field);
        for _ in 0..16 {
            fine.attempt(0.5 / 16.0, field);
            fine.accept();
        }
        let error = (stepper.end[0] - fine.y[0]).abs().max((stepper.end[1] - fine.y[1]).abs());
        assert!(estimate > error && estimate < 1e5 * error, "{estimate} {error}");
    }
}

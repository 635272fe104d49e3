//! The numbers of one gear: small dense systems of fixed size on the stack.
//!
//! `N` rows stand on `N + 1` nodes that can turn, node 0 the input. One matrix serves all: its
//! row `j` holds the factors `1, −i₀, i₀ − 1` of row `j` at its nodes.
//!
//! ```text
//! speeds     C·ω = 0                  with ω_in = 1
//! torques    Ĉᵀ·t = T_in·e_in + T_out·e_out      î₀ = i₀·η^w in Ĉ, t_j the torque on sun j
//! signs      w_j = sign t_j·(ω_a − ω_H)
//! ```
//!
//! # The branch
//! The signs that count are those continuous with `η → 1`: the ideal torques give them. Where the
//! loaded torques confirm all signs, that is the answer. Where they do not, a row so nearly idle that
//! the losses of the others reverse its power has been met: the losses are then raised from nothing
//! to their full size, and a sign turns where its power passes through zero. The torques are
//! continuous there. If they instead run to infinity on the way, no torque at the input keeps the
//! gear moving at the full losses and there is no branch.

use crate::compiled::{Direction, Loaded, MAX_ROWS, MAX_SHARED, RESTING, Solution};

/// Relative power below this share of the largest internal power is none: no loss and no sign.
pub(crate) const POWER_TOLERANCE: f64 = 1e-11;

/// Torque above this multiple of the input's: a pole.
const POLE: f64 = 1e8;

/// A gear, in the order of its active rows.
pub(crate) struct Problem<'a, const N: usize> {
    pub(crate) nodes: [[u8; 3]; N],
    pub(crate) i0: [f64; N],
    pub(crate) eta: [f64; N],
    /// Shared mesh of each row, or [`NO_GROUP`].
    pub(crate) group: [u8; N],
    pub(crate) group_eta: &'a [f64],
    pub(crate) output: usize,
    pub(crate) direction: Direction,
}

/// No shared mesh.
pub(crate) const NO_GROUP: u8 = u8::MAX;

/// Columns of a matrix of factors; the last one collects what is tied to the housing.
type Matrix<const N: usize> = [[f64; RESTING + 1]; N];

/// Signs of the relative powers: own meshes of each row, and shared meshes.
#[derive(Clone, Copy, PartialEq)]
struct Signs<const N: usize> {
    row: [i8; N],
    shared: [i8; MAX_SHARED],
}

/// Torques under some signs.
struct Torques<const N: usize> {
    effective: [f64; N],
    sun: [f64; N],
    /// Torque at the terminal that was not given.
    other: f64,
    /// Relative power of each row and shared mesh, and the largest internal power.
    power: [f64; N],
    shared: [f64; MAX_SHARED],
    largest: f64,
}

impl<const N: usize> Problem<'_, N> {
    pub(crate) fn solve(&self, solution: &mut Solution) -> bool {
        let matrix = self.matrix(&self.i0);
        let Some(speeds) = speeds(&matrix) else { return false };
        solution.speeds[0] = 1.0;
        solution.speeds[1..=N].copy_from_slice(&speeds);
        let speed =
            |node: u8| if usize::from(node) == RESTING { 0.0 } else { solution.speeds[usize::from(node)] };
        let member: [[f64; 3]; N] = self.nodes.map(|nodes| nodes.map(speed));
        let output = solution.speeds[self.output];
        solution.output_speed = output;

        // One unit of power enters: at the input with torque 1, or at the output with torque i.
        let given = match self.direction {
            Direction::Drive => 1.0,
            Direction::Overrun => 1.0 / output,
        };
        if !given.is_finite() || output == 0.0 {
            return false;
        }
        let Some((sun, other)) = self.torques(&matrix, given) else { return false };
        let ideal = self.powers(&member, self.i0, sun, other, [1.0; MAX_SHARED]);
        solution.ideal_sun[..N].copy_from_slice(&sun);
        for (relative, [a, _, h]) in solution.relative_speed.iter_mut().zip(member) {
            *relative = a - h;
        }
        let mut signs = self.signs(&ideal);
        solution.ideal_signs[..N].copy_from_slice(&signs.row);
        let loaded = match self.loaded(&member, &signs, 1.0, given) {
            Some(found) if self.agree(&signs, &found) => Some(found),
            _ => self.follow(&member, &mut signs, given),
        };
        solution.signs[..N].copy_from_slice(&signs.row);
        solution.shared_signs = signs.shared;
        solution.loaded = loaded.map(|found| {
            let mut loaded = Loaded {
                sun: [0.0; MAX_ROWS],
                effective: [0.0; MAX_ROWS],
                other: found.other,
                efficiency: 0.0,
            };
            loaded.sun[..N].copy_from_slice(&found.sun);
            loaded.effective[..N].copy_from_slice(&found.effective);
            // Power that leaves at the other terminal, of 1 that enters.
            let other_speed = match self.direction {
                Direction::Drive => output,
                Direction::Overrun => 1.0,
            };
            loaded.efficiency = -found.other * other_speed;
            loaded
        });
        true
    }

    fn matrix(&self, i0: &[f64; N]) -> Matrix<N> {
        let mut matrix = [[0.0; RESTING + 1]; N];
        for ((row, nodes), &i) in matrix.iter_mut().zip(&self.nodes).zip(i0) {
            row[usize::from(nodes[0]) & RESTING] += 1.0;
            row[usize::from(nodes[1]) & RESTING] -= i;
            row[usize::from(nodes[2]) & RESTING] += i - 1.0;
        }
        matrix
    }

    /// Torques on the suns for `given` at the terminal where power enters, and the torque at the
    /// other terminal.
    fn torques(&self, matrix: &Matrix<N>, given: f64) -> Option<([f64; N], f64)> {
        let (known, other) = match self.direction {
            Direction::Drive => (0, self.output),
            Direction::Overrun => (self.output, 0),
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
        let sun = gauss(equations, right)?;
        if known == other {
            return Some((sun, -given));
        }
        Some((sun, (0..N).map(|j| matrix[j][other] * sun[j]).sum()))
    }

    /// Relative powers. `shared` takes the loss of shared meshes back out of `effective`.
    fn powers(
        &self,
        member: &[[f64; 3]; N],
        effective: [f64; N],
        sun: [f64; N],
        other: f64,
        shared: [f64; MAX_SHARED],
    ) -> Torques<N> {
        let mut found =
            Torques { effective, sun, other, power: [0.0; N], shared: [0.0; MAX_SHARED], largest: 1.0 };
        for j in 0..N {
            let [a, b, h] = member[j];
            let (ring, carrier) = (-effective[j] * sun[j], (effective[j] - 1.0) * sun[j]);
            found.power[j] = sun[j] * (a - h);
            found.largest = found
                .largest
                .max(found.power[j].abs())
                .max((sun[j] * a).abs())
                .max((ring * b).abs())
                .max((carrier * h).abs());
            if self.group[j] != NO_GROUP {
                let group = usize::from(self.group[j]);
                found.shared[group] -= ring / shared[group] * (b - h);
            }
        }
        found
    }

    fn signs(&self, found: &Torques<N>) -> Signs<N> {
        let zero = POWER_TOLERANCE * found.largest;
        let mut signs = Signs { row: found.power.map(|p| sign(p, zero)), shared: [0; MAX_SHARED] };
        if !self.group_eta.is_empty() {
            signs.shared = found.shared.map(|p| sign(p, zero));
        }
        signs
    }

    fn agree(&self, signs: &Signs<N>, found: &Torques<N>) -> bool {
        let zero = POWER_TOLERANCE * found.largest;
        let fits = |sign: i8, power: f64| power.abs() <= zero || f64::from(sign) * power > 0.0;
        (0..N).all(|j| fits(signs.row[j], found.power[j]))
            && (self.group_eta.is_empty() || (0..MAX_SHARED).all(|g| fits(signs.shared[g], found.shared[g])))
    }

    /// Torques with losses at `share` of their full size: `η^share`.
    fn loaded(&self, member: &[[f64; 3]; N], signs: &Signs<N>, share: f64, given: f64) -> Option<Torques<N>> {
        let part = |eta: f64, sign: i8| {
            let eta = if share < 1.0 { eta.powf(share) } else { eta };
            match sign {
                1 => eta,
                -1 => 1.0 / eta,
                _ => 1.0,
            }
        };
        let mut shared = [1.0; MAX_SHARED];
        for (g, &eta) in self.group_eta.iter().enumerate() {
            shared[g] = part(eta, signs.shared[g]);
        }
        let mut effective = self.i0;
        for j in 0..N {
            effective[j] *= part(self.eta[j], signs.row[j]);
            if self.group[j] != NO_GROUP {
                effective[j] *= shared[usize::from(self.group[j])];
            }
        }
        let (sun, other) = self.torques(&self.matrix(&effective), given)?;
        Some(self.powers(member, effective, sun, other, shared))
    }

    /// Torque at the other terminal under given signs, and the signs that the torques have.
    pub(crate) fn pattern(
        &self,
        member: &[[f64; 3]; N],
        row: [i8; N],
        shared: [i8; MAX_SHARED],
    ) -> Option<(f64, [i8; N], [i8; MAX_SHARED])> {
        let found = self.loaded(member, &Signs { row, shared }, 1.0, 1.0)?;
        let signs = self.signs(&found);
        Some((found.other, signs.row, signs.shared))
    }

    /// Raises the losses from nothing and turns a sign where its power passes through zero.
    #[cold]
    fn follow(&self, member: &[[f64; 3]; N], signs: &mut Signs<N>, given: f64) -> Option<Torques<N>> {
        const STEPS: u32 = 64;
        let mut from = 0.0;
        for _ in 0..16 * (N + MAX_SHARED) {
            let first_step = (from * f64::from(STEPS)) as u32 + 1;
            let mut last = from;
            let mut crossing = None;
            for step in first_step..=STEPS {
                let share = f64::from(step) / f64::from(STEPS);
                match self.loaded(member, signs, share, given) {
                    Some(found) if self.agree(signs, &found) => last = share,
                    _ => {
                        crossing = Some(share);
                        break;
                    }
                }
            }
            let Some(mut high) = crossing else { return self.loaded(member, signs, 1.0, given) };
            let mut low = last;
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                match self.loaded(member, signs, middle, given) {
                    Some(found) if self.agree(signs, &found) => low = middle,
                    _ => high = middle,
                }
            }
            let found = self.loaded(member, signs, high, given)?;
            if found.sun.iter().any(|t| t.abs() > POLE) || !found.other.is_finite() {
                return None;
            }
            let turned = self.signs(&found);
            let zero = POWER_TOLERANCE * found.largest;
            let mut any = false;
            for j in 0..N {
                if found.power[j].abs() > zero && turned.row[j] != signs.row[j] {
                    signs.row[j] = turned.row[j];
                    any = true;
                }
            }
            for g in 0..MAX_SHARED {
                if found.shared[g].abs() > zero && turned.shared[g] != signs.shared[g] {
                    signs.shared[g] = turned.shared[g];
                    any = true;
                }
            }
            if !any {
                return None;
            }
            from = high;
        }
        None
    }
}

fn sign(power: f64, zero: f64) -> i8 {
    i8::from(power > zero) - i8::from(power < -zero)
}

/// Speeds of nodes 1…N for a speed of 1 of node 0.
pub(crate) fn speeds<const N: usize>(matrix: &Matrix<N>) -> Option<[f64; N]> {
    let mut equations = [[0.0; N]; N];
    let mut right = [0.0; N];
    for (j, row) in matrix.iter().enumerate() {
        equations[j].copy_from_slice(&row[1..=N]);
        right[j] = -row[0];
    }
    gauss(equations, right)
}

/// Solves `a·x = b` by elimination with row pivoting; `None` where a pivot vanishes.
///
/// Equations are not scaled: those of rows are within `1 + |i₀|` of each other, and the rank was
/// settled, with scaling, when the gear was compiled.
#[inline]
#[allow(clippy::needless_range_loop, reason = "indices are those of the formulas")]
pub(crate) fn gauss<const N: usize>(mut a: [[f64; N]; N], mut b: [f64; N]) -> Option<[f64; N]> {
    const VANISHING: f64 = 1e-13;
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
        if a[k][k].abs() <= VANISHING || a[k][k].is_nan() {
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

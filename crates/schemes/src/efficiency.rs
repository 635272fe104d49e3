//! Which sign patterns of the losses bear themselves out.
//!
//! A pattern says for each row, and each shared mesh, which way its relative power runs. Under given
//! signs the torques are linear; a pattern is self-consistent where they run the way it says. One of
//! them is continuous with vanishing losses, and that is the efficiency of the gear. Others can
//! exist beside it, mostly near self-locking; they are listed as what they are.

use crate::compiled::{CompiledGear, Direction, MAX_SHARED, Solution};
use crate::torques::Scene;

/// A self-consistent pattern of signs.
#[derive(Debug, Clone, PartialEq)]
pub struct Pattern {
    /// Sense of the relative power of each row: 1 from sun to ring, −1 from ring to sun, 0 none.
    pub signs: Vec<i8>,
    /// Sense of the power in each shared mesh.
    pub shared_signs: Vec<i8>,
    /// Efficiency it would have.
    pub efficiency: f64,
    /// Whether it is the one continuous with vanishing losses.
    pub chosen: bool,
}

/// Beyond this many lossy rows and meshes the patterns are not enumerated.
const MOST_ELEMENTS: usize = 12;

/// All self-consistent patterns of a driven gear, the chosen one first.
pub(crate) fn patterns(scene: &Scene, ratios: &[f64], solution: &Solution) -> Vec<Pattern> {
    macro_rules! sizes {
        ($($n:literal)*) => {
            match scene.compiled.active_rows().len() {
                $($n => of_size::<$n>(scene, ratios, solution),)*
                _ => vec![],
            }
        };
    }
    sizes!(0 1 2 3 4 5 6 7 8 9 10 11 12)
}

fn of_size<const N: usize>(scene: &Scene, ratios: &[f64], solution: &Solution) -> Vec<Pattern> {
    let Scene { gearbox, compiled, .. } = *scene;
    let shared_eta: Vec<f64> = gearbox.shared.iter().map(|mesh| mesh.eta).collect();
    let own = |row: usize| gearbox.own_efficiency(row);
    let problem = compiled.problem::<N>(|row| ratios[row], own, &shared_eta, Direction::Drive);
    let mut member = [[0.0; 3]; N];
    for (j, member) in member.iter_mut().enumerate() {
        *member = compiled.member_speeds(solution, j);
    }
    // Rows first, then shared meshes; only those that can lose anything.
    let rolls = |j: usize| (member[j][0] - member[j][2]).abs() > 1e-12;
    let rows = (0..N).filter(|&j| problem.eta[j] < 1.0 && rolls(j));
    let meshes = (0..shared_eta.len())
        .filter(|&g| shared_eta[g] < 1.0 && (0..N).any(|j| usize::from(problem.group[j]) == g && rolls(j)));
    let elements: Vec<usize> = rows.chain(meshes.map(|g| N + g)).collect();
    if elements.len() > MOST_ELEMENTS {
        return chosen(compiled, gearbox.rows.len(), shared_eta.len(), solution).into_iter().collect();
    }
    let mut found: Vec<Pattern> =
        chosen(compiled, gearbox.rows.len(), shared_eta.len(), solution).into_iter().collect();
    let all = 0..1_u32 << elements.len();
    for bits in all {
        let (mut row, mut shared) = ([0_i8; N], [0_i8; MAX_SHARED]);
        for (bit, &element) in elements.iter().enumerate() {
            let sign = if bits >> bit & 1 == 0 { 1 } else { -1 };
            if element < N { row[element] = sign } else { shared[element - N] = sign }
        }
        let Some((other, signs, shared_signs)) = problem.pattern(&member, row, shared) else { continue };
        let fits = |&element: &usize| {
            let (assumed, is) = if element < N {
                (row[element], signs[element])
            } else {
                (shared[element - N], shared_signs[element - N])
            };
            // Without power both signs say the same: take it once.
            is == assumed || is == 0 && assumed == 1
        };
        if !elements.iter().all(fits) {
            continue;
        }
        let efficiency = -other * solution.output_speed;
        let mut pattern = named(compiled, gearbox.rows.len(), &signs, &shared_signs[..shared_eta.len()]);
        pattern.efficiency = efficiency;
        let known = found.first().is_some_and(|first| {
            first.signs == pattern.signs && first.shared_signs == pattern.shared_signs
                || (first.efficiency - efficiency).abs() < 1e-12 * (1.0 + efficiency.abs())
        });
        if !known {
            found.push(pattern);
        }
    }
    found
}

fn chosen(compiled: &CompiledGear, rows: usize, shared: usize, solution: &Solution) -> Option<Pattern> {
    let efficiency = solution.loaded()?.efficiency;
    let pattern = named(compiled, rows, &solution.signs, &solution.shared_signs[..shared]);
    Some(Pattern { efficiency, chosen: true, ..pattern })
}

fn named(compiled: &CompiledGear, rows: usize, signs: &[i8], shared: &[i8]) -> Pattern {
    let mut all = vec![0; rows];
    for (&row, &sign) in compiled.active_rows().iter().zip(signs) {
        all[usize::from(row)] = sign;
    }
    Pattern { signs: all, shared_signs: shared.to_vec(), efficiency: 0.0, chosen: false }
}

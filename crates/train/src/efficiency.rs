//! Self-consistent sign patterns of the losses.
//!
//! A pattern gives the direction of the rolling power for each segment of meshes. With given signs the
//! torques are linear; a pattern is self-consistent if the powers of these torques have its directions. One
//! pattern is continuous with vanishing losses; its efficiency is the efficiency of the gear. Other
//! self-consistent patterns can exist, mostly near self-locking; they are listed as alternatives.

use crate::branch::{self, Lossy};
use crate::network::Loads;
use crate::solution::Solution;
use crate::tolerance::{ALIKE, SPEED};
use crate::torques::Scene;
use epicyclic_numerics::values::largest_absolute;

/// A self-consistent pattern of signs.
#[derive(Debug, Clone, PartialEq)]
pub struct Pattern {
    /// Direction of the rolling power of each segment of each set, away from its gear of reference: 1 from
    /// sun to ring of a set with two central gears, −1 from ring to sun, 0 none.
    pub signs: Vec<Vec<i8>>,
    /// Efficiency it would have.
    pub efficiency: f64,
    /// Whether it is the one continuous with vanishing losses.
    pub chosen: bool,
}

/// Largest number of lossy segments for which the patterns are enumerated.
const MOST_SEGMENTS: usize = 12;

/// Self-consistent patterns of a driven gear, the chosen one first.
pub(crate) fn patterns(scene: &Scene, ratios: &[f64], solution: &Solution) -> Vec<Pattern> {
    let Scene { gearbox, compiled, .. } = *scene;
    let named = |signs: &[i8], efficiency, chosen| {
        let mut by_set: Vec<Vec<i8>> = vec![vec![]; gearbox.sets.len()];
        for (place, segment) in gearbox.segments.iter().enumerate() {
            let sign = compiled.segments.iter().position(|&one| one == place).map_or(0, |one| signs[one]);
            by_set[segment.set].push(sign);
        }
        Pattern { signs: by_set, efficiency, chosen }
    };
    let mut found: Vec<Pattern> = solution
        .efficiency()
        .map(|efficiency| named(solution.signs(), efficiency, true))
        .into_iter()
        .collect();
    let eta = |segment: usize| gearbox.segments[segment].efficiency;
    // Only those that can lose anything.
    let rolls = |place: &usize| {
        let relative = solution.relative_speeds()[compiled.runs[*place].from];
        let largest = largest_absolute(solution.speeds());
        eta(compiled.segments[*place]) < 1.0 && relative.abs() > SPEED * largest
    };
    let lossy: Vec<usize> = (0..compiled.segments.len()).filter(rolls).collect();
    if lossy.len() > MOST_SEGMENTS {
        return found;
    }
    let network = compiled.network(|equation| ratios[equation], eta, 0.0);
    let output = usize::from(compiled.output);
    let terminals = [(0, Some(1.0)), (output, None)];
    let terminals = if output == 0 { &terminals[..0] } else { &terminals[..] };
    let loads = Loads { network: &network, speeds: solution.speeds(), terminals };
    for bits in 0..1_u32 << lossy.len() {
        let mut signs = vec![0_i8; compiled.segments.len()];
        for (bit, &place) in lossy.iter().enumerate() {
            signs[place] = if bits >> bit & 1 == 0 { 1 } else { -1 };
        }
        let Some(balance) = loads.at(&signs, 1.0) else { continue };
        let (powers, largest) = loads.powers(&balance);
        let is = branch::signs(powers, largest, vec![0; signs.len()]);
        // Without power both signs are equivalent: take it once.
        let fits = |&place: &usize| is[place] == signs[place] || is[place] == 0 && signs[place] == 1;
        if !lossy.iter().all(fits) {
            continue;
        }
        let efficiency = -balance.terminals.get(1).copied().unwrap_or(-1.0) * solution.output_speed;
        let pattern = named(&is, efficiency, false);
        let known = found.first().is_some_and(|first| {
            first.signs == pattern.signs
                || (first.efficiency - efficiency).abs() < ALIKE * (1.0 + efficiency.abs())
        });
        if !known {
            found.push(pattern);
        }
    }
    found
}

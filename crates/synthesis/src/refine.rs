//! The best ring-to-sun ratios of a solution, and the range that each may have.
//!
//! *Best* is where the greatest deviation of a gear, by the half of its bounds' width, is least: with bounds shrunk about
//! their middle by a factor, a point is there or proved not to be; the factor is halved down. The range of a `k` is found
//! alike, by moving one of its bounds until no point is left. Both hold for the gears' functions as found.

use crate::parts::{Bounds, Cuboid};
use crate::ratio::Ratio;
use crate::solve::{Function, Outcome, Solver};
use crate::tolerance::NO_WIDTH;

/// How close the greatest deviation comes to the least, as a part of the bounds' half width.
const CLOSE: f64 = 1e-4;

/// How close the bounds of a range come to the outermost points, relative.
const NEAR: f64 = 1e-4;

/// The best point of a solution, and its ranges.
#[derive(Debug, Clone, PartialEq)]
pub struct Refined {
    /// The ring-to-sun ratios with the least greatest deviation.
    pub k: Vec<f64>,
    /// The greatest deviation there, as a part of the bounds' half width: 0 in the middle of all bounds, 1 at one.
    pub deviation: f64,
    /// The range of each `k` in which points with all gears are found, the others moving along; outermost to 10⁻⁴.
    pub ranges: Vec<[f64; 2]>,
}

/// Refines a point that has all gears by these ratios.
#[must_use]
pub fn refine(ratios: &[Ratio], gears: &[Bounds], range_of_k: &Cuboid, point: &[f64]) -> Refined {
    let functions: Vec<Function> =
        ratios.iter().map(|ratio| Function::new(*ratio, range_of_k.len())).collect();
    let functions: Vec<&Function> = functions.iter().collect();
    let mut own = |assigned: &[usize]| assigned.iter().enumerate().all(|(gear, function)| gear == *function);
    let mut seek =
        |gears: &[Bounds], cuboid: Cuboid| match Solver::new(&functions, gears, &mut own).search(cuboid) {
            Outcome::Found { k, .. } => Some(k),
            Outcome::None | Outcome::Undecided => None,
        };
    let (mut known, mut best) = (deviation(ratios, gears, point), point.to_vec());
    let mut none = 0.0;
    while known - none > CLOSE {
        let factor = 0.5 * (known + none);
        let shrunk: Vec<Bounds> = gears.iter().map(|gear| gear.shrunk(factor)).collect();
        match seek(&shrunk, range_of_k.clone()) {
            Some(k) => {
                known = deviation(ratios, gears, &k).min(factor);
                best = k;
            }
            None => none = factor,
        }
    }
    let mut range = |set: usize, upper: bool| {
        let side = usize::from(upper);
        let (mut outer, mut inner) = (range_of_k[set][side], best[set]);
        while (outer - inner).abs() > NEAR * inner {
            let mut cuboid = range_of_k.clone();
            let middle = 0.5 * (outer + inner);
            cuboid[set] = if upper { [middle, outer] } else { [outer, middle] };
            match seek(gears, cuboid) {
                Some(k) => inner = if upper { k[set].max(middle) } else { k[set].min(middle) },
                None => outer = middle,
            }
        }
        inner
    };
    let ranges = (0..range_of_k.len()).map(|set| [range(set, false), range(set, true)]).collect();
    Refined { deviation: deviation(ratios, gears, &best), k: best, ranges }
}

/// The greatest deviation of a gear, by half the width of its bounds.
fn deviation(ratios: &[Ratio], gears: &[Bounds], k: &[f64]) -> f64 {
    let of = |(ratio, gear): (&Ratio, &Bounds)| {
        let [middle, half] = gear.middle_and_half();
        (ratio.value(k) - middle).abs() / half
    };
    ratios.iter().zip(gears).map(of).fold(0.0, f64::max)
}

impl Bounds {
    pub(crate) fn middle_and_half(self) -> [f64; 2] {
        // Bounds without width still measure deviations.
        let half = (0.5 * (self.most - self.least)).max(NO_WIDTH * self.most.abs());
        [0.5 * (self.most + self.least), half]
    }

    fn shrunk(self, factor: f64) -> Self {
        let [middle, half] = self.middle_and_half();
        Self { least: middle - factor * half, most: middle + factor * half }
    }
}

//! The best point of a solution and its ranges by bisection with the branch-and-bound of the search: the
//! plain way of `refine`.

use epicyclic_synthesis::parts::{Bounds, Cuboid};
use epicyclic_synthesis::ratio::Ratio;
use epicyclic_synthesis::refine::Refined;
use epicyclic_synthesis::solve::{Function, Outcome, Solver};

/// Tolerance of deviation and ranges to the outermost.
pub(crate) const CLOSE: f64 = 1e-4;

/// A point in a range of `k` at which each function has its gear, or `None` if no point was found.
fn seek(functions: &[&Function], gears: &[Bounds], cuboid: &Cuboid) -> Option<Vec<f64>> {
    let mut own = |assigned: &[usize]| assigned.iter().enumerate().all(|(gear, function)| gear == *function);
    match Solver::new(functions, gears, &mut own).search(cuboid) {
        Outcome::Found { k, .. } => Some(k),
        Outcome::None | Outcome::Undecided => None,
    }
}

/// The greatest deviation of a gear, by half the width of its bounds.
pub(crate) fn deviation(ratios: &[Ratio], gears: &[Bounds], k: &[f64]) -> f64 {
    let of = |(ratio, gear): (&Ratio, &Bounds)| {
        (ratio.value(k) - 0.5 * (gear.least + gear.most)).abs() / (0.5 * (gear.most - gear.least))
    };
    ratios.iter().zip(gears).map(of).fold(0.0, f64::max)
}

/// Bounds shrunk about their middle until no point is left, and each `k` bounded alike.
pub(crate) fn refine(ratios: &[Ratio], gears: &[Bounds], range_of_k: &Cuboid, point: &[f64]) -> Refined {
    let functions: Vec<Function> =
        ratios.iter().map(|ratio| Function::new(*ratio, range_of_k.len())).collect();
    let functions: Vec<&Function> = functions.iter().collect();
    let (mut known, mut best) = (deviation(ratios, gears, point), point.to_vec());
    let mut none = 0.0;
    while known - none > CLOSE {
        let factor = 0.5 * (known + none);
        let shrunk: Vec<Bounds> = gears
            .iter()
            .map(|Bounds { least, most }| {
                let (middle, half) = (0.5 * (least + most), 0.5 * factor * (most - least));
                Bounds { least: middle - half, most: middle + half }
            })
            .collect();
        match seek(&functions, &shrunk, range_of_k) {
            Some(k) => {
                known = deviation(ratios, gears, &k).min(factor);
                best = k;
            }
            None => none = factor,
        }
    }
    let range = |set: usize, upper: bool| {
        let (mut outer, mut inner) = (range_of_k[set][usize::from(upper)], best[set]);
        while (outer - inner).abs() > CLOSE * inner {
            let mut cuboid = range_of_k.clone();
            let middle = 0.5 * (outer + inner);
            cuboid[set] = if upper { [middle, outer] } else { [outer, middle] };
            match seek(&functions, gears, &cuboid) {
                Some(k) => inner = if upper { k[set].max(middle) } else { k[set].min(middle) },
                None => outer = middle,
            }
        }
        inner
    };
    let ranges = (0..range_of_k.len()).map(|set| [range(set, false), range(set, true)]).collect();
    Refined { deviation: deviation(ratios, gears, &best), k: best, ranges }
}

//! Gearboxes with smaller and smaller rings.

use super::records::SizesStep;
use crate::error::Error;

/// Part by which the limit of the rings is below the last ring, from one gearbox of a front to the next.
const SMALLER: f64 = 0.05;

/// Gearboxes of a front at most, beside the best.
const MOST_SMALLER: usize = 12;

/// The best gearboxes whose rings are smaller and smaller than this one, until none holds: `with` searches the one
/// under a limit of the rings in m, with its ring. A pair alone has no ring.
pub(super) fn front<T>(
    mut ring: f64,
    mut with: impl FnMut(f64) -> Result<Option<(T, f64)>, Error>,
) -> Result<Vec<T>, Error> {
    let mut points = vec![];
    while points.len() < MOST_SMALLER && ring > 0.0 {
        let Some((point, own)) = with(ring * (1.0 - SMALLER))? else { break };
        ring = own;
        points.push(point);
    }
    Ok(points)
}

/// Greatest outside diameter of a ring of the best sizes, in m; 0 without one.
pub(super) fn largest_ring(sizes: Option<&SizesStep>) -> f64 {
    let sets = sizes.into_iter().flat_map(|sizes| &sizes.sets);
    sets.filter_map(|set| set.found.first()?.ring_diameter_m).fold(0.0, f64::max)
}

//! Tables that are linear between their points and level beyond them, read segment by segment.
//!
//! A *segment* is how many points are below: 0 before the first, 1 between the first and the second, and so
//! on.

/// Value in a segment, continued beyond its ends.
pub(crate) fn value(points: &[[f64; 2]], segment: usize, at: f64) -> f64 {
    match (segment.checked_sub(1).map(|one| points[one]), points.get(segment)) {
        (Some([from, value]), Some(next)) => value + (next[1] - value) / (next[0] - from) * (at - from),
        (Some(last), None) => last[1],
        (None, first) => first.map_or(0.0, |first| first[1]),
    }
}

/// The segment of a place; one on a point is counted as `is_rising` says.
pub(crate) fn segment(points: &[[f64; 2]], at: f64, is_rising: bool) -> usize {
    points.partition_point(|point| if is_rising { point[0] <= at } else { point[0] < at })
}

/// Places at which a segment begins and ends.
pub(crate) fn ends(points: &[[f64; 2]], segment: usize) -> [Option<f64>; 2] {
    let of = |place: usize| points.get(place).map(|point| point[0]);
    [segment.checked_sub(1).and_then(of), of(segment)]
}

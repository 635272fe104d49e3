//! The least distance of two ports, exactly.
//!
//! Two pieces that do not cross are nearest at an end of one, or along a line that is normal to both: from
//! the centre of an arc upright onto a side, or through the centres of two arcs.

use crate::ports::outline::{Piece, Port};

/// The least distance of two ports; 0 where they overlap.
pub(super) fn between(one: &Port, other: &Port) -> f64 {
    let (of_one, of_other) = (one.pieces(), other.pieces());
    let overlap = of_one.iter().any(|piece| other.contains(piece.at(0.0)))
        || of_other.iter().any(|piece| one.contains(piece.at(0.0)));
    if overlap {
        return 0.0;
    }
    let pairs = of_one.iter().flat_map(|one| of_other.iter().map(move |other| of_pieces(one, other)));
    pairs.fold(f64::INFINITY, f64::min)
}

/// The least distance of two pieces.
fn of_pieces(one: &Piece, other: &Piece) -> f64 {
    if cross(one, other) {
        return 0.0;
    }
    let to = |piece: &Piece, point: [f64; 2]| apart(piece.nearest(point), point);
    let mut least = f64::INFINITY;
    for end in [0.0, 1.0] {
        least = least.min(to(other, one.at(end))).min(to(one, other.at(end)));
    }
    // Nearest to its centre, an arc's other pieces are nearest or farthest to it too.
    for (arc, piece) in [(one, other), (other, one)] {
        if let Piece::Arc(centre, ..) = *arc {
            for foot in piece.normal_to(centre) {
                least = arc.normal_to(foot).into_iter().fold(least, |least, at| least.min(apart(at, foot)));
            }
        }
    }
    least
}

fn cross(one: &Piece, other: &Piece) -> bool {
    match (one, other) {
        (piece, Piece::Arc(centre, radius, ..)) | (Piece::Arc(centre, radius, ..), piece) => {
            let arc = if matches!(other, Piece::Arc(..)) { other } else { one };
            piece.across_circle(*centre, *radius).into_iter().any(|part| arc.faces(piece.at(part)))
        }
        (Piece::Line(a, b), Piece::Line(c, d)) => {
            let side = |p: &[f64; 2], q: &[f64; 2], x: &[f64; 2]| {
                (q[0] - p[0]) * (x[1] - p[1]) - (q[1] - p[1]) * (x[0] - p[0])
            };
            side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
        }
    }
}

fn apart(a: [f64; 2], b: [f64; 2]) -> f64 {
    libm::hypot(a[0] - b[0], a[1] - b[1])
}

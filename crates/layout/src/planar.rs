//! Planar embedding with a fixed border: the algorithm of Demoucron, Malgrange and Pertuiset.
//!
//! The graph is grown from the border cycle inwards. What is not yet drawn falls into fragments; a
//! fragment fits a face when all its points of attachment lie on it. A fragment that fits none is the
//! proof of non-planarity; otherwise a path of the fragment with the fewest faces is drawn through one
//! of them. Quadratic, which for some forty vertices is a few microseconds.

/// The border: four vertices in this order counter-clockwise, joined by the first four edges.
pub(super) const AXIS: usize = 0;
pub(super) const OUTPUT: usize = 1;
pub(super) const HOUSING: usize = 2;
pub(super) const INPUT: usize = 3;
pub(super) const BORDER: [[usize; 2]; 4] =
    [[AXIS, OUTPUT], [OUTPUT, HOUSING], [HOUSING, INPUT], [INPUT, AXIS]];

/// One side of an edge: the edge walked from this end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Dart {
    edge: usize,
    from: usize,
}

/// Part of the graph that is not drawn yet: one edge, or vertices with all their edges.
struct Fragment {
    attachments: Vec<usize>,
    /// An edge of the fragment at its first attachment.
    start: usize,
}

/// Edges around each vertex, clockwise, of a planar embedding inside the border.
///
/// The first four edges must be [`BORDER`]; nothing is drawn outside it. `None` means that no such embedding
/// exists. The graph must be connected; parallel edges are allowed, loops are not.
///
/// If a fragment fits several faces, `variant` selects one. It changes the embedding, never the result
/// whether one exists.
pub(super) fn embed(vertices: usize, ends: &[[usize; 2]], variant: usize) -> Option<Vec<Vec<usize>>> {
    debug_assert_eq!(ends.get(..4), Some(&BORDER[..]));
    let mut incident = vec![vec![]; vertices];
    for (edge, &[a, b]) in ends.iter().enumerate() {
        debug_assert_ne!(a, b);
        incident[a].push(edge);
        incident[b].push(edge);
    }
    let mut drawing = Drawing {
        ends,
        incident: &incident,
        vertex: vec![false; vertices],
        edge: vec![false; ends.len()],
        faces: vec![(0..4).map(|edge| Dart { edge, from: BORDER[edge][0] }).collect()],
    };
    for (edge, [from, _]) in BORDER.into_iter().enumerate() {
        drawing.edge[edge] = true;
        drawing.vertex[from] = true;
    }
    drawing.grow(variant)?;
    Some(drawing.rotation())
}

/// The other end of an edge.
pub(super) fn far(ends: &[[usize; 2]], edge: usize, near: usize) -> usize {
    let [a, b] = ends[edge];
    if a == near { b } else { a }
}

struct Drawing<'a> {
    ends: &'a [[usize; 2]],
    incident: &'a [Vec<usize>],
    vertex: Vec<bool>,
    edge: Vec<bool>,
    /// Walks with the face on the left. What is outside the border is no face.
    faces: Vec<Vec<Dart>>,
}

impl Drawing<'_> {
    fn grow(&mut self, variant: usize) -> Option<()> {
        loop {
            let mut best: Option<(usize, usize, Fragment)> = None;
            for fragment in self.fragments() {
                let fitting: Vec<usize> =
                    (0..self.faces.len()).filter(|&face| self.fits(&fragment, face)).collect();
                let face = *fitting.get(variant % fitting.len().max(1))?;
                // A fragment with one attachment fits anywhere at that vertex. It waits for the others, so
                // that at any time only one block is half drawn.
                let choices = if fragment.attachments.len() < 2 { usize::MAX } else { fitting.len() };
                if best.as_ref().is_none_or(|(fewest, ..)| choices < *fewest) {
                    best = Some((choices, face, fragment));
                }
            }
            let Some((_, face, fragment)) = best else { return Some(()) };
            self.draw(&fragment, face);
        }
    }

    fn fragments(&self) -> Vec<Fragment> {
        let mut found = vec![];
        let mut seen = vec![false; self.vertex.len()];
        for (edge, &[a, b]) in self.ends.iter().enumerate() {
            if self.edge[edge] {
                continue;
            }
            let (inside, outside) = match (self.vertex[a], self.vertex[b]) {
                (true, true) => {
                    found.push(Fragment { attachments: vec![a, b], start: edge });
                    continue;
                }
                (true, false) => (b, a),
                (false, true) => (a, b),
                (false, false) => continue,
            };
            if seen[inside] {
                continue;
            }
            seen[inside] = true;
            let mut attachments = vec![outside];
            let mut stack = vec![inside];
            while let Some(vertex) = stack.pop() {
                for &next in &self.incident[vertex] {
                    let other = far(self.ends, next, vertex);
                    if self.vertex[other] {
                        if !attachments.contains(&other) {
                            attachments.push(other);
                        }
                    } else if !seen[other] {
                        seen[other] = true;
                        stack.push(other);
                    }
                }
            }
            found.push(Fragment { attachments, start: edge });
        }
        found
    }

    fn fits(&self, fragment: &Fragment, face: usize) -> bool {
        let walk = &self.faces[face];
        fragment.attachments.iter().all(|vertex| walk.iter().any(|dart| dart.from == *vertex))
    }

    /// Path of the fragment from its first attachment to another one; if it has only one attachment, its
    /// first edge.
    fn path(&self, fragment: &Fragment) -> Vec<Dart> {
        let from = fragment.attachments[0];
        let first = far(self.ends, fragment.start, from);
        let head = Dart { edge: fragment.start, from };
        if self.vertex[first] || fragment.attachments.len() < 2 {
            return vec![head];
        }
        let mut reached: Vec<Option<Dart>> = vec![None; self.vertex.len()];
        reached[first] = Some(head);
        let mut queue = std::collections::VecDeque::from([first]);
        while let Some(vertex) = queue.pop_front() {
            for &edge in &self.incident[vertex] {
                let other = far(self.ends, edge, vertex);
                if other == from || reached[other].is_some() {
                    continue;
                }
                reached[other] = Some(Dart { edge, from: vertex });
                if !self.vertex[other] {
                    queue.push_back(other);
                    continue;
                }
                let mut path = vec![];
                let mut end = other;
                while end != from {
                    let Some(dart) = reached[end] else { break };
                    path.push(dart);
                    end = dart.from;
                }
                path.reverse();
                return path;
            }
        }
        vec![head]
    }

    fn draw(&mut self, fragment: &Fragment, face: usize) {
        let path = self.path(fragment);
        let last = path[path.len() - 1];
        let end = far(self.ends, last.edge, last.from);
        for dart in &path {
            self.edge[dart.edge] = true;
            self.vertex[far(self.ends, dart.edge, dart.from)] = true;
        }
        let back = path
            .iter()
            .rev()
            .map(|dart| Dart { edge: dart.edge, from: far(self.ends, dart.edge, dart.from) });
        let walk = std::mem::take(&mut self.faces[face]);
        let place = |vertex| walk.iter().position(|dart| dart.from == vertex);
        let start = place(path[0].from).unwrap_or(0);
        let around = |from: usize, to: usize| {
            let length = (to + walk.len() - from) % walk.len();
            walk.iter().cycle().skip(from).take(length).copied()
        };
        if let Some(end) = place(end) {
            let left = path.iter().copied().chain(around(end, start)).collect();
            let right = back.chain(around(start, end)).collect();
            self.faces[face] = left;
            self.faces.push(right);
        } else {
            let mut walk = walk.clone();
            let there_and_back: Vec<Dart> = path.iter().copied().chain(back).collect();
            walk.splice(start..start, there_and_back);
            self.faces[face] = walk;
        }
    }

    /// Two edges that follow each other in a walk with the face on the left follow each other
    /// clockwise around the vertex between them.
    fn rotation(&self) -> Vec<Vec<usize>> {
        let mut next: Vec<[usize; 2]> = vec![[usize::MAX; 2]; self.ends.len()];
        let outside = (0..4).rev().map(|edge| Dart { edge, from: BORDER[edge][1] }).collect();
        for walk in self.faces.iter().chain([&outside]) {
            for (place, dart) in walk.iter().enumerate() {
                let after = walk[(place + 1) % walk.len()];
                let end = usize::from(self.ends[dart.edge][1] == after.from);
                next[dart.edge][end] = after.edge;
            }
        }
        (0..self.vertex.len())
            .map(|vertex| {
                let incident = &self.incident[vertex];
                let after = |edge: &usize| Some(next[*edge][usize::from(self.ends[*edge][1] == vertex)]);
                std::iter::successors(incident.first().copied(), after).take(incident.len()).collect()
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with_border(vertices: usize, more: &[[usize; 2]]) -> Option<Vec<Vec<usize>>> {
        let ends: Vec<[usize; 2]> = BORDER.iter().chain(more).copied().collect();
        embed(vertices, &ends, 0)
    }

    #[test]
    fn a_cross_in_the_border_is_not_planar() {
        assert!(with_border(4, &[[AXIS, HOUSING]]).is_some());
        assert!(with_border(4, &[[AXIS, HOUSING], [INPUT, OUTPUT]]).is_none());
    }

    #[test]
    fn three_by_three_and_five_by_five_are_not_planar() {
        let three: Vec<[usize; 2]> = (4..7).flat_map(|a| (7..10).map(move |b| [a, b])).collect();
        let five: Vec<[usize; 2]> = (4..9).flat_map(|a| (a + 1..9).map(move |b| [a, b])).collect();
        for (vertices, mut edges) in [(10, three), (9, five)] {
            edges.push([HOUSING, 4]);
            assert!(with_border(vertices, &edges).is_none());
            edges.remove(0);
            assert!(with_border(vertices, &edges).is_some());
        }
    }

    #[test]
    fn edges_around_a_vertex_are_listed_clockwise() {
        // The border as a square: axis and output below, housing above output, input above axis.
        let around = with_border(5, &[[AXIS, 4], [OUTPUT, 4], [HOUSING, 4], [INPUT, 4]]).unwrap();
        let turned = |list: &[usize]| {
            let start = list.iter().position(|edge| edge == list.iter().min().unwrap()).unwrap();
            [&list[start..], &list[..start]].concat()
        };
        assert_eq!(turned(&around[4]), [4, 7, 6, 5]);
        assert_eq!(turned(&around[AXIS]), [0, 3, 4]);
    }
}

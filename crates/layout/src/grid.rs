//! Coordinates on a grid: a visibility representation.
//!
//! Vertices become horizontal bars at the height of their longest path from the axis. Edges become vertical
//! lines at the longest path through the faces from the left (Tamassia and Tollis). The edges of one stack
//! share a place along the axis, so a stack is straight (Di Battista, Tamassia and Tollis, constrained
//! visibility representations).

use super::scheme::Kind;
use super::stacks::Upward;
use epicyclic_train::groups::Groups;

/// Height of each vertex and place along the axis of each edge.
#[derive(Debug, Clone)]
pub(super) struct Grid {
    pub(super) height: Vec<u32>,
    pub(super) place: Vec<u32>,
}

impl Grid {
    pub(super) fn new(map: &Upward, same_side: bool) -> Self {
        let used = used(map);
        let rises = used.iter().map(|&edge| {
            let [low, high] = map.ends[edge];
            (low, high, map.rise(edge, same_side))
        });
        let height = longest(map.parts.len(), rises.collect());

        // Faces: both sides of every edge, joined around the vertices.
        let side = |edge: usize, right: bool| 2 * edge + usize::from(right);
        let mut faces = Groups::new(2 * map.ends.len());
        for (below, above) in map.below.iter().zip(&map.above) {
            for edges in [below, above] {
                for pair in edges.windows(2) {
                    faces.join(side(pair[0], true), side(pair[1], false));
                }
            }
            if let (Some(&below_first), Some(&below_last)) = (below.first(), below.last())
                && let (Some(&above_first), Some(&above_last)) = (above.first(), above.last())
            {
                faces.join(side(below_first, false), side(above_first, false));
                faces.join(side(below_last, true), side(above_last, true));
            }
        }
        // Nodes: faces by their root, then one for each edge or stack.
        let mut first_of: Vec<Option<usize>> = vec![];
        let column = |edge: usize, first_of: &mut Vec<Option<usize>>| {
            let Some(set) = map.in_stack(edge) else { return edge };
            if first_of.len() <= set {
                first_of.resize(set + 1, None);
            }
            *first_of[set].get_or_insert(edge)
        };
        let base = 2 * map.ends.len();
        let mut steps = vec![];
        let mut columns = vec![0; map.ends.len()];
        for &edge in &used {
            columns[edge] = base + column(edge, &mut first_of);
            let wide = u32::from(map.seen(edge) || map.kinds[edge] == Kind::Border);
            steps.push((faces.root(side(edge, false)), columns[edge], wide));
            steps.push((columns[edge], faces.root(side(edge, true)), 0));
        }
        let along = longest(base + map.ends.len(), steps);
        Self { height, place: columns.iter().map(|&column| along[column]).collect() }
    }
}

fn used(map: &Upward) -> Vec<usize> {
    let mut used: Vec<usize> = map.above.iter().flatten().copied().collect();
    used.sort_unstable();
    used
}

/// Longest path to each node of an acyclic graph of arcs `(from, to, length)`.
fn longest(nodes: usize, arcs: Vec<(usize, usize, u32)>) -> Vec<u32> {
    let mut waits = vec![0_u32; nodes];
    let mut leaving: Vec<Vec<(usize, u32)>> = vec![vec![]; nodes];
    for (from, to, length) in arcs {
        waits[to] += 1;
        leaving[from].push((to, length));
    }
    let mut far = vec![0; nodes];
    let mut ready: Vec<usize> = (0..nodes).filter(|&node| waits[node] == 0).collect();
    let mut done = 0;
    while let Some(node) = ready.pop() {
        done += 1;
        for &(to, length) in &leaving[node] {
            far[to] = far[to].max(far[node] + length);
            waits[to] -= 1;
            if waits[to] == 0 {
                ready.push(to);
            }
        }
    }
    debug_assert_eq!(done, nodes, "the arcs close a loop");
    far
}

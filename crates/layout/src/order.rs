//! Heights: an order of the vertices from the axis to the housing in which every other vertex has a
//! neighbour below it and one above it.

use super::map::Map;
use super::planar::{AXIS, HOUSING, INPUT, OUTPUT, far};

/// A small generator, so that the same gearbox always gives the same layout.
#[derive(Debug, Clone)]
pub(super) struct Dice(u64);

impl Dice {
    pub(super) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(0x1234_5678_9ABC_DEF1))
    }

    /// A number below `n`.
    fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        usize::try_from(self.0 >> 33).unwrap_or(0) % n.max(1)
    }
}

/// Rank of each vertex. Vertices without edges come last.
///
/// The border comes first; then ears, paths through vertices without a rank between two that have
/// one, are put between their ends until none is left. Which ear and where is chance.
pub(super) fn ranks(map: &Map, dice: &mut Dice) -> Vec<usize> {
    let mut order = vec![AXIS, INPUT, OUTPUT, HOUSING];
    let mut placed = vec![false; map.around.len()];
    for &vertex in &order {
        placed[vertex] = true;
    }
    loop {
        let leaving: Vec<(usize, usize)> = (0..map.ends.len())
            .filter(|&edge| map.around[map.ends[edge][0]].contains(&edge))
            .filter_map(|edge| match map.ends[edge].map(|end| placed[end]) {
                [true, false] => Some((edge, map.ends[edge][0])),
                [false, true] => Some((edge, map.ends[edge][1])),
                _ => None,
            })
            .collect();
        if leaving.is_empty() {
            break;
        }
        let (edge, from) = leaving[dice.below(leaving.len())];
        let (mut ear, end) = ear(map, &placed, edge, from, dice);
        for &vertex in &ear {
            placed[vertex] = true;
        }
        let place = |vertex| order.iter().position(|&other| other == vertex).unwrap_or(0);
        let (mut low, mut high) = (place(from), place(end));
        if low > high {
            (low, high) = (high, low);
            ear.reverse();
        }
        let at = low + 1 + dice.below(high - low);
        order.splice(at..at, ear);
    }
    let mut ranks = vec![usize::MAX; map.around.len()];
    for (rank, &vertex) in order.iter().enumerate() {
        ranks[vertex] = rank;
    }
    ranks
}

/// Vertices of a path from `from` along `edge` to a placed vertex, and that vertex.
fn ear(map: &Map, placed: &[bool], edge: usize, from: usize, dice: &mut Dice) -> (Vec<usize>, usize) {
    let first = far(&map.ends, edge, from);
    let mut reached: Vec<Option<usize>> = vec![None; placed.len()];
    reached[first] = Some(from);
    let mut queue = std::collections::VecDeque::from([first]);
    while let Some(vertex) = queue.pop_front() {
        let around = &map.around[vertex];
        let turn = dice.below(around.len());
        for &edge in around[turn..].iter().chain(&around[..turn]) {
            let other = far(&map.ends, edge, vertex);
            if other == from || reached[other].is_some() {
                continue;
            }
            if placed[other] {
                let mut path = vec![vertex];
                let mut back = vertex;
                while back != first {
                    back = reached[back].unwrap_or(first);
                    path.push(back);
                }
                path.reverse();
                return (path, other);
            }
            reached[other] = Some(vertex);
            queue.push_back(other);
        }
    }
    debug_assert!(false, "the map is biconnected");
    (vec![first], HOUSING)
}

/// Edges below and above each vertex, from left to right.
pub(super) fn sides(map: &Map, ranks: &[usize]) -> [Vec<Vec<usize>>; 2] {
    let mut below = vec![vec![]; map.around.len()];
    let mut above = below.clone();
    for (vertex, around) in map.around.iter().enumerate() {
        let up = |edge: usize| ranks[far(&map.ends, edge, vertex)] > ranks[vertex];
        let len = around.len();
        // Clockwise: above from left to right, then below from right to left. At the axis and the
        // housing all edges are on one side; what is outside the border separates first and last.
        let start = (0..len)
            .find(|&place| {
                let edge = around[place];
                let before = around[(place + len - 1) % len];
                match vertex {
                    AXIS => map.ends[edge] == [INPUT, AXIS],
                    HOUSING => map.ends[edge] == [OUTPUT, HOUSING],
                    _ => up(edge) && !up(before),
                }
            })
            .unwrap_or(0);
        for &edge in around[start..].iter().chain(&around[..start]) {
            if up(edge) { above[vertex].push(edge) } else { below[vertex].insert(0, edge) }
        }
    }
    [below, above]
}

#[cfg(test)]
mod tests {
    use super::super::scheme::Scheme;
    use super::*;
    use epicyclic_train::Gearbox;
    use epicyclic_train::set::SetSpec;

    #[test]
    fn dice_fall_evenly() {
        for sides in 2..=7 {
            let mut dice = Dice::new(0);
            let mut fell = vec![0_u32; sides];
            let throws = 7000;
            for _ in 0..throws {
                fell[dice.below(sides)] += 1;
            }
            // Five standard deviations of a binomial number.
            let share = 1.0 / sides as f64;
            let spread = (f64::from(throws) * share * (1.0 - share)).sqrt();
            for count in fell {
                let off = (f64::from(count) - f64::from(throws) * share).abs();
                assert!(off < 5.0 * spread, "{sides} sides: {count} of {throws}");
            }
        }
    }

    #[test]
    fn seeds_give_different_throws() {
        let throws = |seed: u64| {
            let mut dice = Dice::new(seed);
            [(); 16].map(|()| dice.below(1000))
        };
        for seed in 0..20 {
            assert_eq!(throws(seed), throws(seed));
            assert!((0..seed).all(|other| throws(other) != throws(seed)), "{seed}");
        }
    }

    #[test]
    fn every_vertex_has_a_neighbour_below_and_one_above() {
        let gearbox = Gearbox::builder("II-3")
            .links(["D", "B", "T1", "T2"])
            .set(SetSpec::simple("1", ["T1", "D", "B"], 2.15))
            .set(SetSpec::simple("2", ["T1", "B", "T2"], 1.56))
            .brake("K1", "T1")
            .brake("K2", "T2")
            .clutch("L", "D", "B")
            .input("D")
            .output("B")
            .build()
            .unwrap();
        let map = Map::new(&Scheme::new(&gearbox, &[]).graph(&[]), 0).unwrap();
        for seed in 0..50 {
            let ranks = ranks(&map, &mut Dice::new(seed));
            let [below, above] = sides(&map, &ranks);
            for (vertex, around) in map.around.iter().enumerate().filter(|(_, around)| !around.is_empty()) {
                let (down, up) = (&below[vertex], &above[vertex]);
                assert_eq!(down.is_empty(), vertex == AXIS, "seed {seed}, vertex {vertex}");
                assert_eq!(up.is_empty(), vertex == HOUSING, "seed {seed}, vertex {vertex}");
                // Clockwise: above from left to right, below from right to left.
                let turned: Vec<usize> = up.iter().chain(down.iter().rev()).copied().collect();
                let start = around.iter().position(|edge| *edge == turned[0]).unwrap();
                assert_eq!(turned, [&around[start..], &around[..start]].concat());
                assert!(up.iter().all(|&edge| ranks[far(&map.ends, edge, vertex)] > ranks[vertex]));
                assert!(down.iter().all(|&edge| ranks[far(&map.ends, edge, vertex)] < ranks[vertex]));
            }
        }
    }
}

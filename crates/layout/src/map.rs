//! Embedding in which planets, webs of carriers and the two sides of every set are distinct.

use super::carriers;
use super::planar::{HOUSING, OUTPUT, far};
use super::scheme::{Graph, Kind};
use epicyclic_train::groups::Groups;

/// A plane map: vertices with their edges clockwise.
///
/// Vertices up to those of the graph are what they were; a further one is a planet or one more web
/// of a carrier, `owner` says whose.
#[derive(Debug, Clone)]
pub(super) struct Map {
    pub(super) ends: Vec<[usize; 2]>,
    pub(super) kinds: Vec<Kind>,
    pub(super) around: Vec<Vec<usize>>,
    /// The vertex of the graph that each vertex is part of.
    pub(super) owner: Vec<usize>,
    /// The set whose planet a vertex is.
    pub(super) planet: Vec<Option<usize>>,
}

impl Map {
    /// Embedding of the graph; `None` if the graph has none.
    pub(super) fn new(graph: &Graph, variant: usize) -> Option<Self> {
        let around = carriers::arrange(graph, variant)?;
        let mut map = Self {
            ends: graph.ends.clone(),
            kinds: graph.kinds.clone(),
            around,
            owner: (0..graph.vertices).collect(),
            planet: vec![None; graph.vertices],
        };
        for vertex in 0..graph.vertices {
            map.part(graph, vertex);
        }
        map.make_biconnected();
        Some(map)
    }

    fn vertex(&mut self, owner: usize, planet: Option<usize>) -> usize {
        self.owner.push(owner);
        self.planet.push(planet);
        self.around.push(vec![]);
        self.owner.len() - 1
    }

    /// Cuts a carrier along the chords of its planets. The parts are its webs; each chord becomes a
    /// planet with an arm to the web on either side, unless there is nothing on that side.
    fn part(&mut self, graph: &Graph, vertex: usize) {
        let planets: Vec<_> = graph.planets.iter().filter(|planet| planet.carrier == vertex).collect();
        if planets.is_empty() {
            return;
        }
        let mut around = std::mem::take(&mut self.around[vertex]);
        if vertex == HOUSING {
            // Clockwise from what is outside the border.
            let first = around.iter().position(|&edge| self.ends[edge] == [OUTPUT, HOUSING]);
            around.rotate_left(first.unwrap_or(0));
        }
        let mut webs = vec![(vertex, vec![])];
        let mut open: Vec<(usize, usize)> = vec![];
        let mut web = 0;
        for edge in around {
            let planet = planets.iter().find(|planet| planet.sun == edge || planet.ring == edge);
            let Some(planet) = planet else {
                self.attach(edge, vertex, webs[web].0);
                webs[web].1.push(edge);
                continue;
            };
            if let Some(&(hub, outer)) = open.last().filter(|(hub, _)| self.planet[*hub] == Some(planet.set))
            {
                open.pop();
                self.attach(edge, vertex, hub);
                let inner = self.arm(planet.set, hub, webs[web].0);
                webs[web].1.push(inner);
                let arm = self.around[hub][0];
                self.around[hub] = vec![arm, self.around[hub][1], inner, edge];
                web = outer;
            } else {
                let hub = self.vertex(vertex, Some(planet.set));
                let arm = self.arm(planet.set, hub, webs[web].0);
                self.attach(edge, vertex, hub);
                self.around[hub] = vec![arm, edge];
                webs[web].1.push(arm);
                open.push((hub, web));
                let beyond = self.vertex(vertex, None);
                webs.push((beyond, vec![]));
                web = webs.len() - 1;
            }
        }
        for (web, edges) in webs {
            match edges[..] {
                [only] if matches!(self.kinds[only], Kind::Arm(_)) => {
                    let hub = far(&self.ends, only, web);
                    self.around[hub].retain(|&edge| edge != only);
                    self.around[web].clear();
                }
                _ => self.around[web] = edges,
            }
        }
    }

    fn attach(&mut self, edge: usize, from: usize, to: usize) {
        for end in &mut self.ends[edge] {
            if *end == from {
                *end = to;
            }
        }
    }

    fn arm(&mut self, set: usize, hub: usize, web: usize) -> usize {
        self.ends.push([hub, web]);
        self.kinds.push(Kind::Arm(set));
        self.ends.len() - 1
    }

    /// Adds helpers so that no vertex separates the map: two edges that follow each other around a
    /// vertex but belong to different blocks get their far ends joined across the face between them.
    fn make_biconnected(&mut self) {
        let block = blocks(&self.ends, &self.around);
        let mut groups = Groups::new(block.iter().max().map_or(0, |last| last + 1));
        let mut block: Vec<usize> = block;
        for vertex in 0..self.around.len() {
            let around = self.around[vertex].clone();
            for (place, &edge) in around.iter().enumerate() {
                let next = around[(place + 1) % around.len()];
                if !groups.join(block[edge], block[next]) {
                    continue;
                }
                let (from, to) = (far(&self.ends, edge, vertex), far(&self.ends, next, vertex));
                let helper = self.ends.len();
                self.ends.push([from, to]);
                self.kinds.push(Kind::Helper);
                block.push(block[edge]);
                let place =
                    |around: &[usize], edge| around.iter().position(|&other| other == edge).unwrap_or(0);
                let before = place(&self.around[from], edge);
                self.around[from].insert(before, helper);
                let behind = place(&self.around[to], next) + 1;
                self.around[to].insert(behind, helper);
            }
        }
    }
}

/// Number of the block (biconnected part) of each edge.
fn blocks(ends: &[[usize; 2]], around: &[Vec<usize>]) -> Vec<usize> {
    let mut block = vec![0; ends.len()];
    let mut count = 0;
    let mut depth = vec![usize::MAX; around.len()];
    let mut low = vec![0; around.len()];
    let mut stack: Vec<usize> = vec![];
    let mut seen = vec![false; ends.len()];
    for root in 0..around.len() {
        if depth[root] != usize::MAX {
            continue;
        }
        depth[root] = 0;
        // Vertex, the edge it was reached by, next place around it.
        let mut walk: Vec<(usize, usize, usize)> = vec![(root, usize::MAX, 0)];
        while let Some(&mut (vertex, by, ref mut place)) = walk.last_mut() {
            if let Some(&edge) = around[vertex].get(*place) {
                *place += 1;
                if seen[edge] {
                    continue;
                }
                seen[edge] = true;
                stack.push(edge);
                let other = far(ends, edge, vertex);
                if depth[other] == usize::MAX {
                    depth[other] = depth[vertex] + 1;
                    low[other] = depth[other];
                    walk.push((other, edge, 0));
                } else {
                    low[vertex] = low[vertex].min(depth[other]);
                }
                continue;
            }
            walk.pop();
            let Some(&(parent, ..)) = walk.last() else { continue };
            low[parent] = low[parent].min(low[vertex]);
            if low[vertex] >= depth[parent] {
                while let Some(edge) = stack.pop() {
                    block[edge] = count;
                    if edge == by {
                        break;
                    }
                }
                count += 1;
            }
        }
    }
    block
}

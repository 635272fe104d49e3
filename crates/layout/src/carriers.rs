//! Carriers with several planets: which embeddings of the graph a carrier can be drawn for.
//!
//! The planet of a set is one vertex with its carrier, so around that vertex the two meshes of a set
//! are the ends of a chord through the carrier: sun below, ring above. A carrier reaches both sides
//! of its planet, so one chord may cut the vertex anywhere. Two chords must not cross: beyond its own
//! chord a planet sees the whole of every other set of its carrier on one side. Where the embedding
//! found has crossing chords, one of the sets is settled by trying on which side of it everything
//! else of the carrier lies; each trial is again a question of planarity, and a trial that is not
//! planar with all other chords free is cut off.
//!
//! The trials are exponential in the number of connections of a carrier with two or more planets, and
//! only there. Connections of equal ends are exchanged first, which settles nearly every case.

use super::planar::{self, HOUSING, far};
use super::scheme::{Graph, Kind, Planet};

/// Edges around each vertex, clockwise, of an embedding in which no two chords of a carrier cross.
pub(super) fn arrange(graph: &Graph, variant: usize) -> Option<Vec<Vec<usize>>> {
    let mut rotation = planar::embed(graph.vertices, &graph.ends, variant)?;
    exchange(graph, &mut rotation);
    let Some(planet) = most_crossed(graph, &rotation) else { return Some(rotation) };
    let units = units(graph, planet);
    let free = units.len().saturating_sub(usize::from(graph.planets[planet].carrier != HOUSING));
    (0..1_u64 << free.min(63)).find_map(|beyond| {
        let beyond: Vec<usize> =
            (0..units.len()).filter(|&unit| unit < free && beyond >> unit & 1 == 1).collect();
        let split = split(graph, planet, beyond.iter().flat_map(|&unit| &units[unit]));
        let mut rotation = arrange(&split, variant)?;
        for arm in (graph.ends.len()..split.ends.len()).rev() {
            contract(&mut rotation, split.ends[arm], arm);
        }
        rotation.truncate(graph.vertices);
        Some(rotation)
    })
}

/// How many other chords each planet's chord crosses.
fn crossings(graph: &Graph, rotation: &[Vec<usize>]) -> Vec<usize> {
    let chords: Vec<[usize; 2]> = graph
        .planets
        .iter()
        .map(|planet| {
            let around = &rotation[planet.carrier];
            let place = |edge| around.iter().position(|&other| other == edge).unwrap_or(0);
            let (sun, ring) = (place(planet.sun), place(planet.ring));
            [sun.min(ring), sun.max(ring)]
        })
        .collect();
    let crosses = |a: usize, b: usize| {
        let [low, high] = chords[a];
        let inside = chords[b].map(|place| low < place && place < high);
        a != b && graph.planets[a].carrier == graph.planets[b].carrier && inside[0] != inside[1]
    };
    let all = 0..chords.len();
    all.clone().map(|a| all.clone().filter(|&b| crosses(a, b)).count()).collect()
}

/// The planet whose chord crosses the most others.
fn most_crossed(graph: &Graph, rotation: &[Vec<usize>]) -> Option<usize> {
    let crossings = crossings(graph, rotation);
    let most = *crossings.iter().max()?;
    crossings.iter().position(|&count| count == most && count > 0)
}

/// Exchanges meshes of planets that join the same two vertices while that leaves fewer crossings.
fn exchange(graph: &Graph, rotation: &mut [Vec<usize>]) {
    let total = |rotation: &[Vec<usize>]| crossings(graph, rotation).iter().sum::<usize>();
    let mut left = total(rotation);
    let meshes: Vec<usize> = graph.planets.iter().flat_map(|planet| [planet.sun, planet.ring]).collect();
    let mut better = true;
    while left > 0 && std::mem::take(&mut better) {
        for (place, &a) in meshes.iter().enumerate() {
            for &b in meshes[place + 1..].iter().filter(|&&b| graph.ends[a] == graph.ends[b]) {
                let swap = |rotation: &mut [Vec<usize>]| {
                    for end in graph.ends[a] {
                        for edge in &mut rotation[end] {
                            *edge = if *edge == a {
                                b
                            } else if *edge == b {
                                a
                            } else {
                                *edge
                            };
                        }
                    }
                };
                swap(rotation);
                let now = total(rotation);
                if now < left {
                    (left, better) = (now, true);
                } else {
                    swap(rotation);
                }
            }
        }
    }
}

/// The rest of a planet's carrier as units that lie on one side of the planet: the two meshes of
/// another planet, and all connections to one neighbour. The border stays where it is.
fn units(graph: &Graph, planet: usize) -> Vec<Vec<usize>> {
    let Planet { carrier, sun, ring, .. } = graph.planets[planet];
    let mut units: Vec<Vec<usize>> = vec![];
    let mut of_planets = vec![sun, ring];
    for (place, other) in graph.planets.iter().enumerate() {
        if place != planet && other.carrier == carrier {
            units.push(vec![other.sun, other.ring]);
            of_planets.extend([other.sun, other.ring]);
        }
    }
    let mut neighbours: Vec<(usize, Vec<usize>)> = vec![];
    for (edge, ends) in graph.ends.iter().enumerate() {
        if !ends.contains(&carrier) || of_planets.contains(&edge) || graph.kinds[edge] == Kind::Border {
            continue;
        }
        let other = far(&graph.ends, edge, carrier);
        match neighbours.iter_mut().find(|(neighbour, _)| *neighbour == other) {
            Some((_, edges)) => edges.push(edge),
            None => neighbours.push((other, vec![edge])),
        }
    }
    units.extend(neighbours.into_iter().map(|(_, edges)| edges));
    units
}

/// The same graph with one planet a vertex of its own between two webs of its carrier.
fn split<'a>(graph: &Graph, planet: usize, beyond: impl Iterator<Item = &'a usize>) -> Graph {
    let mut split = graph.clone();
    let Planet { set, carrier, sun, ring } = split.planets.remove(planet);
    let (vertex, web) = (graph.vertices, graph.vertices + 1);
    split.vertices += 2;
    for (edges, to) in [(vec![sun, ring], vertex), (beyond.copied().collect(), web)] {
        for edge in edges {
            for end in &mut split.ends[edge] {
                if *end == carrier {
                    *end = to;
                }
            }
            for other in &mut split.planets {
                if to == web && (other.sun == edge || other.ring == edge) && other.carrier == carrier {
                    other.carrier = web;
                }
            }
        }
    }
    split.join([carrier, vertex], Kind::Arm(set));
    split.join([vertex, web], Kind::Arm(set));
    split
}

/// Shrinks an edge: what is around its second end takes its place around the first.
fn contract(rotation: &mut [Vec<usize>], [into, gone]: [usize; 2], edge: usize) {
    let moved = after(&rotation[gone], edge);
    let place = rotation[into].iter().position(|&other| other == edge).unwrap_or(0);
    rotation[into].splice(place..=place, moved);
    rotation[gone].clear();
}

/// The edges around a vertex that follow one of them, in order, without it.
fn after(around: &[usize], edge: usize) -> Vec<usize> {
    let place = around.iter().position(|&other| other == edge).unwrap_or(0);
    around.iter().cycle().skip(place + 1).take(around.len().saturating_sub(1)).copied().collect()
}

//! Carriers with several planets: which embeddings of the graph a carrier can be drawn for.
//!
//! The planet of a set is one vertex with its carrier. Around that vertex the two meshes of a set are
//! therefore the ends of a chord through the carrier: sun below, ring above. A carrier reaches both sides of
//! its planet, so one chord may cut the vertex anywhere. Two chords must not cross: beyond its own chord a
//! planet sees the whole of every other set of its carrier on one side.
//!
//! If the embedding found has crossing chords, one of the sets is decided by trying on which side of it
//! everything else of the carrier lies. Each trial is again a question of planarity. A trial that is not
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

/// Number of other chords that each planet's chord crosses.
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

/// Graph in which one planet is a separate vertex between two webs of its carrier.
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

#[cfg(test)]
mod tests {
    use super::super::planar::{BORDER, INPUT, OUTPUT};
    use super::*;
    use epicyclic_train::groups::Groups;

    /// The first vertex that is a link; input, output and carrier are the first three.
    const FIRST: usize = BORDER.len();
    const CARRIER: usize = FIRST + 2;

    /// Sets `[sun, ring, carrier]` and clutches between links, which are numbered from [`FIRST`]; 2 is the
    /// housing.
    fn graph(links: usize, sets: &[[usize; 3]], clutches: &[[usize; 2]]) -> Graph {
        let mut graph = Graph {
            vertices: FIRST + links,
            ends: BORDER.to_vec(),
            kinds: vec![Kind::Border; 4],
            planets: vec![],
        };
        graph.join([INPUT, FIRST], Kind::Input);
        graph.join([OUTPUT, FIRST + 1], Kind::Output);
        for (set, &[sun, ring, carrier]) in sets.iter().enumerate() {
            let sun = graph.join([carrier, sun], Kind::Sun(set));
            let ring = graph.join([carrier, ring], Kind::Ring(set));
            graph.planets.push(Planet { set, carrier, sun, ring });
        }
        for (clutch, &ends) in clutches.iter().enumerate() {
            graph.join(ends, Kind::ShiftElement(clutch));
        }
        let mut parts = Groups::new(graph.vertices);
        for &[a, b] in &graph.ends {
            parts.join(a, b);
        }
        for link in FIRST..FIRST + links {
            if parts.join(HOUSING, link) {
                graph.join([HOUSING, link], Kind::Helper);
            }
        }
        graph
    }

    /// Graphs of four links and the housing with three sets, two of them at least on one carrier, and
    /// four clutches, as a small generator deals them.
    fn many(count: usize) -> impl Iterator<Item = Graph> {
        let mut state = 1_u64;
        let mut below = move |n: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            usize::try_from(state >> 33).unwrap() % n
        };
        let links = [HOUSING, FIRST, FIRST + 1, CARRIER, FIRST + 3, FIRST + 4];
        (0..count).map(move |_| {
            let mut other = |not: &[usize]| loop {
                let link = links[below(links.len())];
                if !not.contains(&link) {
                    break link;
                }
            };
            let sets: Vec<[usize; 3]> = (0..3)
                .map(|place| {
                    let carrier = if place < 2 { CARRIER } else { other(&[]) };
                    let sun = other(&[carrier]);
                    [sun, other(&[carrier, sun]), carrier]
                })
                .collect();
            let clutches: Vec<[usize; 2]> = (0..4)
                .map(|_| {
                    let link = other(&[]);
                    [link, other(&[link])]
                })
                .collect();
            graph(5, &sets, &clutches)
        })
    }

    fn orders(rest: &[usize]) -> Vec<Vec<usize>> {
        if rest.is_empty() {
            return vec![vec![]];
        }
        let first = rest.iter().flat_map(|&first| {
            let others: Vec<usize> = rest.iter().copied().filter(|&edge| edge != first).collect();
            orders(&others).into_iter().map(move |order| [vec![first], order].concat())
        });
        first.collect()
    }

    #[test]
    fn chords_cross_where_their_ends_alternate() {
        let [sun, ring] = [FIRST, FIRST + 1];
        let common = graph(3, &[[sun, ring, CARRIER], [sun, ring, CARRIER]], &[]);
        let own = graph(4, &[[sun, ring, CARRIER], [sun, ring, CARRIER + 1]], &[]);
        let meshes = common.planets.iter().flat_map(|planet| [planet.sun, planet.ring]);
        for order in orders(&meshes.collect::<Vec<_>>()) {
            let of: Vec<usize> =
                order.iter().map(|edge| usize::from(common.planets[1].sun <= *edge)).collect();
            let crossed = usize::from(of[0] == of[2]);
            let mut rotation = vec![vec![]; own.vertices];
            rotation[CARRIER] = order.clone();
            assert_eq!(crossings(&common, &rotation), [crossed; 2], "{order:?}");
            rotation[CARRIER + 1] = order;
            assert_eq!(crossings(&own, &rotation), [0; 2]);
        }
    }

    #[test]
    fn units_are_all_that_is_at_the_carrier_but_the_planet_itself() {
        for graph in many(200) {
            for (place, planet) in graph.planets.iter().enumerate() {
                let units = units(&graph, place);
                let mut listed = units.concat();
                listed.sort_unstable();
                let at_carrier: Vec<usize> = (0..graph.ends.len())
                    .filter(|&edge| graph.ends[edge].contains(&planet.carrier))
                    .filter(|&edge| graph.kinds[edge] != Kind::Border)
                    .filter(|edge| ![planet.sun, planet.ring].contains(edge))
                    .collect();
                // An edge between two carriers may be the mesh of one of them.
                listed.dedup();
                assert_eq!(listed, at_carrier, "{graph:?}");
                for other in graph.planets.iter().filter(|other| other.carrier == planet.carrier) {
                    let of_both =
                        |unit: &&Vec<usize>| unit.contains(&other.sun) || unit.contains(&other.ring);
                    let of_both: Vec<&Vec<usize>> = units.iter().filter(of_both).collect();
                    let expected =
                        if other.set == planet.set { vec![] } else { vec![vec![other.sun, other.ring]] };
                    assert_eq!(of_both, expected.iter().collect::<Vec<_>>());
                }
            }
        }
    }

    #[test]
    fn a_split_planet_shrinks_back_to_the_same_graph() {
        for graph in many(200) {
            for (place, planet) in graph.planets.iter().enumerate() {
                let units = units(&graph, place);
                for taken in 0..=units.len() {
                    let beyond = units[..taken].concat();
                    let split = split(&graph, place, beyond.iter());
                    let (hub, web) = (graph.vertices, graph.vertices + 1);
                    let back =
                        |vertex: usize| if vertex == hub || vertex == web { planet.carrier } else { vertex };
                    let edges = graph.ends.len();
                    let shrunk: Vec<[usize; 2]> =
                        split.ends[..edges].iter().map(|ends| ends.map(back)).collect();
                    assert_eq!(shrunk, graph.ends);
                    assert_eq!(split.ends[edges..], [[planet.carrier, hub], [hub, web]]);
                    // The planet has its own two meshes and the arms, its second web the edges in `beyond`.
                    let at = |vertex: usize| -> Vec<usize> {
                        (0..edges).filter(|&edge| split.ends[edge].contains(&vertex)).collect()
                    };
                    assert_eq!(at(hub), [planet.sun, planet.ring]);
                    let mut asked = beyond;
                    asked.sort_unstable();
                    assert_eq!(at(web), asked);
                    for other in &split.planets {
                        let before = graph.planets.iter().find(|planet| planet.set == other.set).unwrap();
                        assert_eq!(back(other.carrier), before.carrier);
                        for mesh in [other.sun, other.ring] {
                            assert!(split.ends[mesh].contains(&other.carrier), "{graph:?}");
                        }
                    }
                }
            }
        }
    }

    /// Every edge once around each of its ends, and as many faces as Euler's formula asks of a connected
    /// graph: vertices − edges + faces = 2.
    fn is_embedding(graph: &Graph, rotation: &[Vec<usize>]) -> bool {
        let mut darts: Vec<[usize; 2]> = vec![];
        for (vertex, around) in rotation.iter().enumerate() {
            let mut listed = around.clone();
            listed.sort_unstable();
            let at = (0..graph.ends.len()).filter(|&edge| graph.ends[edge].contains(&vertex));
            if listed != at.collect::<Vec<_>>() {
                return false;
            }
            darts.extend(around.iter().map(|&edge| [edge, vertex]));
        }
        let mut faces = 0;
        while let Some(&start) = darts.first() {
            faces += 1;
            let mut dart = start;
            loop {
                darts.retain(|other| *other != dart);
                let [edge, from] = dart;
                let to = far(&graph.ends, edge, from);
                let after = after(&rotation[to], edge);
                dart = [after.first().copied().unwrap_or(edge), to];
                if dart == start {
                    break;
                }
            }
        }
        graph.vertices + faces == graph.ends.len() + 2
    }

    #[test]
    fn an_arrangement_is_an_embedding_without_crossing_chords() {
        let (mut arranged, mut tried) = (0, 0);
        for graph in many(1500) {
            let mut first = planar::embed(graph.vertices, &graph.ends, 0);
            if let Some(first) = &mut first {
                exchange(&graph, first);
            }
            let Some(rotation) = arrange(&graph, 0) else { continue };
            assert!(is_embedding(&graph, &rotation), "{graph:?}");
            assert_eq!(most_crossed(&graph, &rotation), None, "{graph:?}");
            arranged += 1;
            tried += usize::from(first.is_some_and(|first| most_crossed(&graph, &first).is_some()));
        }
        // Enough of them, and enough for which exchanging meshes does not do.
        assert!(arranged > 300 && tried > 20, "{arranged} {tried}");
    }
}

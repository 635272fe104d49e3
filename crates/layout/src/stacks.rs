//! Opens each planet into a vertical stack: first central gear, planet, second central gear.
//!
//! The planet's vertex has edges below and above it, from left to right. Between its first central gear and
//! its second lie the arms of its right side, counter-clockwise, and beyond those of its left. If the first
//! central gear is reached from below and the second from above, nothing has to be changed. The shaft of a
//! first central gear reached from above is led out sideways and up. A second central gear reached from below
//! is a drum led down. An arm on the wrong side of such a shaft or drum is led around under or over it. Every
//! order of edges can therefore be drawn.

use super::map::Map;
use super::planar::{AXIS, INPUT, OUTPUT};
use super::scheme::Kind;

/// Part of the drawing that a vertex becomes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    /// A shaft, drum or web of the piece at this vertex of the graph.
    Bar(usize),
    /// First central gear of a set.
    Sun(usize),
    /// Planet of a set, with its planet pin.
    Planet(usize),
    /// Second central gear of a set.
    Ring(usize),
}

/// A map all of whose edges run upwards.
#[derive(Debug, Clone)]
pub(super) struct Upward {
    /// Lower and upper end.
    pub(super) ends: Vec<[usize; 2]>,
    pub(super) kinds: Vec<Kind>,
    /// Whether an edge is the contact of two gears.
    pub(super) mesh: Vec<bool>,
    pub(super) parts: Vec<Part>,
    /// Edges below and above each vertex, from left to right.
    pub(super) below: Vec<Vec<usize>>,
    pub(super) above: Vec<Vec<usize>>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Side {
    Left,
    Right,
}
use Side::{Left, Right};

/// Plan of the edges of one planet. Lists run from left to right.
#[derive(Default)]
struct Plan {
    left_down: Vec<usize>,
    right_down: Vec<usize>,
    left_up: Vec<usize>,
    right_up: Vec<usize>,
    /// Side on which the shaft of the first central gear goes up, and the arms led under it, inner first.
    sun_up: Option<Side>,
    under: Vec<usize>,
    /// Side on which the drum of the second central gear goes down, and the arms led over it, inner first.
    ring_down: Option<Side>,
    over: Vec<usize>,
}

impl Upward {
    pub(super) fn new(map: &Map, ranks: &[usize], below: Vec<Vec<usize>>, above: Vec<Vec<usize>>) -> Self {
        let mut upward = Self {
            ends: map.ends.iter().map(|&[a, b]| if ranks[a] < ranks[b] { [a, b] } else { [b, a] }).collect(),
            kinds: map.kinds.clone(),
            mesh: vec![false; map.ends.len()],
            parts: map.owner.iter().map(|&owner| Part::Bar(owner)).collect(),
            below,
            above,
        };
        for (vertex, planet) in map.planet.iter().enumerate() {
            if let &Some(set) = planet {
                upward.open(vertex, set, map.owner[vertex]);
            }
        }
        upward
    }

    fn vertex(&mut self, part: Part) -> usize {
        self.parts.push(part);
        self.below.push(vec![]);
        self.above.push(vec![]);
        self.parts.len() - 1
    }

    fn edge(&mut self, low: usize, high: usize, kind: Kind, mesh: bool) -> usize {
        self.ends.push([low, high]);
        self.kinds.push(kind);
        self.mesh.push(mesh);
        self.ends.len() - 1
    }

    fn open(&mut self, planet: usize, set: usize, owner: usize) {
        let below = std::mem::take(&mut self.below[planet]);
        let above = std::mem::take(&mut self.above[planet]);
        let place = |kind: Kind| {
            let at = |edges: &[usize]| edges.iter().position(|&edge| self.kinds[edge] == kind);
            (at(&below), at(&above))
        };
        let plan = self.plan(&below, &above, place(Kind::Sun(set)), place(Kind::Ring(set)));
        self.parts[planet] = Part::Planet(set);
        let (sun, ring) = (self.vertex(Part::Sun(set)), self.vertex(Part::Ring(set)));
        let sun_mesh = self.edge(sun, planet, Kind::Sun(set), true);
        let ring_mesh = self.edge(planet, ring, Kind::Ring(set), true);
        let find = |edges: &[usize], kind: Kind| edges.iter().copied().find(|&edge| self.kinds[edge] == kind);
        let [sun_edge, ring_edge] = [Kind::Sun(set), Kind::Ring(set)]
            .map(|kind| find(&below, kind).or_else(|| find(&above, kind)).unwrap_or(0));

        let mut down = plan.left_down;
        let mut up = plan.left_up;
        self.above[sun] = vec![sun_mesh];
        self.below[ring] = vec![ring_mesh];
        match plan.sun_up {
            None => {
                self.ends[sun_edge][1] = sun;
                self.below[sun] = vec![sun_edge];
                down.push(sun_mesh);
            }
            Some(side) => {
                self.ends[sun_edge][0] = sun;
                self.above[sun].insert(usize::from(side == Right), sun_edge);
                // Each arm turns up below the previous one: the helper edge keeps its bend lower.
                let mut arms = vec![];
                let mut lowest = sun;
                for edge in plan.under {
                    let bend = self.vertex(Part::Bar(owner));
                    let arm = self.edge(bend, planet, self.kinds[edge], false);
                    let helper = self.edge(bend, lowest, Kind::Helper, false);
                    self.ends[edge][0] = bend;
                    self.below[lowest] = vec![helper];
                    self.above[bend] = vec![edge, helper, arm];
                    arms.push(arm);
                    if side == Right {
                        self.above[bend].reverse();
                    }
                    lowest = bend;
                }
                if side == Right {
                    arms.reverse();
                    down.extend(arms);
                    down.push(sun_mesh);
                } else {
                    down.push(sun_mesh);
                    down.extend(arms);
                }
                let beside = if side == Left { below.first() } else { below.last() };
                if let Some(&beside) = beside {
                    let under = self.ends[beside][0];
                    let helper = self.edge(under, lowest, Kind::Helper, false);
                    self.below[lowest] = vec![helper];
                    let at = self.above[under].iter().position(|&edge| edge == beside).unwrap_or(0);
                    self.above[under].insert(at + usize::from(side == Right), helper);
                }
            }
        }
        match plan.ring_down {
            None => {
                self.ends[ring_edge][0] = ring;
                self.above[ring] = vec![ring_edge];
                up.push(ring_mesh);
            }
            Some(side) => {
                self.ends[ring_edge][1] = ring;
                self.below[ring].insert(usize::from(side == Right), ring_edge);
                let mut arms = vec![];
                let mut highest = ring;
                for edge in plan.over {
                    let bend = self.vertex(Part::Bar(owner));
                    let arm = self.edge(planet, bend, self.kinds[edge], false);
                    let helper = self.edge(highest, bend, Kind::Helper, false);
                    self.ends[edge][1] = bend;
                    self.above[highest] = vec![helper];
                    self.below[bend] = vec![edge, helper, arm];
                    arms.push(arm);
                    if side == Right {
                        self.below[bend].reverse();
                    }
                    highest = bend;
                }
                if side == Right {
                    arms.reverse();
                    up.extend(arms);
                    up.push(ring_mesh);
                } else {
                    up.push(ring_mesh);
                    up.extend(arms);
                }
                let beside = if side == Left { above.first() } else { above.last() };
                if let Some(&beside) = beside {
                    let over = self.ends[beside][1];
                    let helper = self.edge(highest, over, Kind::Helper, false);
                    self.above[highest] = vec![helper];
                    let at = self.below[over].iter().position(|&edge| edge == beside).unwrap_or(0);
                    self.below[over].insert(at + usize::from(side == Right), helper);
                }
            }
        }
        down.extend(plan.right_down);
        up.extend(plan.right_up);
        self.below[planet] = down;
        self.above[planet] = up;
    }

    /// Sides for the edges of a planet; places of the two central gears' edges `(below, above)`.
    fn plan(
        &self,
        below: &[usize],
        above: &[usize],
        sun: (Option<usize>, Option<usize>),
        ring: (Option<usize>, Option<usize>),
    ) -> Plan {
        let backwards = |edges: &[usize]| edges.iter().rev().copied().collect::<Vec<_>>();
        match (sun, ring) {
            ((_, Some(s)), (_, Some(r))) if s < r => Plan {
                sun_up: Some(Left),
                under: backwards(&above[..s]),
                left_up: above[s + 1..r].into(),
                right_up: above[r + 1..].into(),
                right_down: below.into(),
                ..Plan::default()
            },
            ((_, Some(s)), (_, Some(r))) => Plan {
                sun_up: Some(Right),
                under: above[s + 1..].into(),
                right_up: above[r + 1..s].into(),
                left_up: above[..r].into(),
                left_down: below.into(),
                ..Plan::default()
            },
            ((Some(s), _), (Some(r), _)) if r < s => Plan {
                ring_down: Some(Left),
                over: backwards(&below[..r]),
                left_down: below[r + 1..s].into(),
                right_down: below[s + 1..].into(),
                right_up: above.into(),
                ..Plan::default()
            },
            ((Some(s), _), (Some(r), _)) => Plan {
                ring_down: Some(Right),
                over: below[r + 1..].into(),
                right_down: below[s + 1..r].into(),
                left_down: below[..s].into(),
                left_up: above.into(),
                ..Plan::default()
            },
            ((_, Some(s)), (Some(r), _)) => {
                let seen = |edges: &[usize]| edges.iter().filter(|&&e| self.kinds[e] != Kind::Helper).count();
                let to_the_left = seen(&below[r + 1..]) + seen(&above[..s]);
                let to_the_right = seen(&below[..r]) + seen(&above[s + 1..]);
                if to_the_left <= to_the_right {
                    Plan {
                        sun_up: Some(Left),
                        ring_down: Some(Right),
                        under: backwards(&above[..s]),
                        over: below[r + 1..].into(),
                        right_down: below[..r].into(),
                        left_up: above[s + 1..].into(),
                        ..Plan::default()
                    }
                } else {
                    Plan {
                        sun_up: Some(Right),
                        ring_down: Some(Left),
                        under: above[s + 1..].into(),
                        over: backwards(&below[..r]),
                        left_down: below[r + 1..].into(),
                        right_up: above[..s].into(),
                        ..Plan::default()
                    }
                }
            }
            ((s, _), (_, r)) => {
                let (s, r) = (s.unwrap_or(0), r.unwrap_or(0));
                Plan {
                    left_down: below[..s].into(),
                    right_down: below[s + 1..].into(),
                    left_up: above[..r].into(),
                    right_up: above[r + 1..].into(),
                    ..Plan::default()
                }
            }
        }
    }

    /// Whether an edge is drawn.
    pub(super) fn seen(&self, edge: usize) -> bool {
        !matches!(self.kinds[edge], Kind::Helper | Kind::Border)
    }

    /// Least height of an edge.
    ///
    /// A central gear may sit directly on its shaft or in its drum, and the input's and output's shafts may
    /// lie on the axis. If both leave on one side, the input's shaft lies around the output's.
    pub(super) fn rise(&self, edge: usize, same_side: bool) -> u32 {
        let [low, high] = self.ends[edge];
        let none = match self.kinds[edge] {
            Kind::Sun(_) | Kind::Ring(_) => self.in_stack(edge).is_some() && !self.mesh[edge],
            Kind::Input | Kind::Output => low == INPUT || low == OUTPUT,
            Kind::Border => low == AXIS && (high == OUTPUT || !same_side),
            _ => false,
        };
        u32::from(!none)
    }

    /// Set in whose stack an edge lies: the two contacts, and the connections of its central gears that go
    /// straight on.
    pub(super) fn in_stack(&self, edge: usize) -> Option<usize> {
        let [low, high] = self.ends[edge];
        match self.kinds[edge] {
            Kind::Sun(set) if self.mesh[edge] || self.parts[high] == Part::Sun(set) => Some(set),
            Kind::Ring(set) if self.mesh[edge] || self.parts[low] == Part::Ring(set) => Some(set),
            _ => None,
        }
    }
}

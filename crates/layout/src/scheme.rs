//! The graph of a scheme: border, links, sets, shift elements; and the same with some of it left out.

use super::Element;
use super::planar::{AXIS, BORDER, HOUSING, INPUT, OUTPUT};
use epicyclic_train::groups::Groups;
use epicyclic_train::{Gearbox, LinkId};

/// Part of a scheme that an edge represents.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Border,
    /// Drawn nowhere: it only keeps the graph connected.
    Helper,
    Input,
    Output,
    TakeOff(LinkId),
    ShiftElement(usize),
    /// Mesh of the planet of this set with its first central gear.
    Sun(usize),
    /// Mesh with the second central gear.
    Ring(usize),
    /// Edge from the planet of this set to a web of its carrier.
    Arm(usize),
}

/// A set whose planet is one vertex with the link that carries it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Planet {
    pub(super) set: usize,
    pub(super) carrier: usize,
    pub(super) sun: usize,
    pub(super) ring: usize,
}

/// The graph that is tested; see the [module](super).
#[derive(Debug, Clone)]
pub(super) struct Graph {
    pub(super) vertices: usize,
    pub(super) ends: Vec<[usize; 2]>,
    pub(super) kinds: Vec<Kind>,
    pub(super) planets: Vec<Planet>,
}

impl Graph {
    pub(super) fn join(&mut self, ends: [usize; 2], kind: Kind) -> usize {
        self.ends.push(ends);
        self.kinds.push(kind);
        self.ends.len() - 1
    }

    /// Hangs what touches nothing of the rest to the housing. A bridge changes no verdict.
    fn connect(&mut self) {
        let mut parts = Groups::new(self.vertices);
        for &[a, b] in &self.ends {
            parts.join(a, b);
        }
        for vertex in 0..self.vertices {
            if parts.join(AXIS, vertex) {
                self.join([HOUSING, vertex], Kind::Helper);
            }
        }
    }
}

/// A gearbox as the drawing sees it: pieces that are one for ever are one vertex.
pub(super) struct Scheme<'a> {
    gearbox: &'a Gearbox,
    /// The gearbox's links by their place.
    links: Vec<LinkId>,
    /// The first link of the piece each link belongs to.
    piece: Vec<usize>,
    /// Vertex of each piece, by its first link.
    vertex: Vec<usize>,
    count: usize,
    /// Further clutches, numbered after those of the gearbox.
    direct_clutches: &'a [[LinkId; 2]],
}

impl<'a> Scheme<'a> {
    pub(super) fn new(gearbox: &'a Gearbox, direct_clutches: &'a [[LinkId; 2]]) -> Self {
        let links = gearbox.links().len();
        let mut groups = Groups::new(links);
        for [a, b] in gearbox.permanent() {
            groups.join(a.index(), b.index());
        }
        let piece: Vec<usize> = (0..links).map(|link| groups.root(link)).collect();
        let mut count = BORDER.len();
        let mut vertex = vec![HOUSING; links];
        for link in 1..links {
            if piece[link] == link {
                vertex[link] = count;
                count += 1;
            }
        }
        Self { gearbox, links: gearbox.link_ids().collect(), piece, vertex, count, direct_clutches }
    }

    /// The first link of the piece that a link belongs to.
    pub(super) fn piece(&self, link: LinkId) -> LinkId {
        self.links[self.piece[link.index()]]
    }

    /// The piece drawn at a vertex of the graph; the vertices of the border other than the housing
    /// have none.
    pub(super) fn piece_at(&self, vertex: usize) -> Option<LinkId> {
        match vertex {
            HOUSING => Some(LinkId::GROUND),
            AXIS | INPUT | OUTPUT => None,
            _ => (1..self.piece.len())
                .find(|&link| self.piece[link] == link && self.vertex[link] == vertex)
                .map(|link| self.links[link]),
        }
    }

    /// Links where power enters or leaves in some gear only, each once.
    fn take_offs(&self) -> Vec<LinkId> {
        let main = [self.gearbox.input(), self.gearbox.output()].map(|link| self.piece(link));
        let mut found = vec![];
        for gear in self.gearbox.gears() {
            for link in [gear.input(), gear.output()].map(|link| self.piece(link)) {
                if link != LinkId::GROUND && !main.contains(&link) && !found.contains(&link) {
                    found.push(link);
                }
            }
        }
        found
    }

    /// Everything a witness may name, in the order in which it is tried to do without.
    pub(super) fn elements(&self) -> Vec<Element> {
        let sets = (0..self.gearbox.drawn_sets().len()).map(Element::Set);
        let shift_elements =
            (0..self.gearbox.shift_elements().len() + self.direct_clutches.len()).map(Element::ShiftElement);
        let take_offs = self.take_offs().into_iter().map(Element::TakeOff);
        let links = (1..self.piece.len())
            .filter(|&link| self.piece[link] == link)
            .map(|link| Element::Link(self.links[link]));
        sets.chain(shift_elements)
            .chain(take_offs)
            .chain([Element::Input, Element::Output])
            .chain(links)
            .collect()
    }

    /// Graph without some elements. A link that is left out is divided: each of its members and connections
    /// is separate.
    pub(super) fn graph(&self, without: &[Element]) -> Graph {
        let mut graph = Graph {
            vertices: self.count,
            ends: BORDER.to_vec(),
            kinds: vec![Kind::Border; 4],
            planets: Vec::with_capacity(self.gearbox.drawn_sets().len()),
        };
        let keeps = |element: Element| !without.contains(&element);
        let end = |graph: &mut Graph, link: LinkId| {
            let piece = self.piece(link);
            if piece == LinkId::GROUND || keeps(Element::Link(piece)) {
                return self.vertex[piece.index()];
            }
            graph.vertices += 1;
            graph.vertices - 1
        };
        if keeps(Element::Input) {
            let link = end(&mut graph, self.gearbox.input());
            graph.join([INPUT, link], Kind::Input);
        }
        if keeps(Element::Output) {
            let link = end(&mut graph, self.gearbox.output());
            graph.join([OUTPUT, link], Kind::Output);
        }
        for link in self.take_offs() {
            if keeps(Element::TakeOff(link)) {
                let vertex = end(&mut graph, link);
                graph.join([vertex, HOUSING], Kind::TakeOff(link));
            }
        }
        for (set, members) in self.gearbox.drawn_sets().iter().map(|drawn| drawn.links).enumerate() {
            if keeps(Element::Set(set)) {
                let [sun, ring, carrier] = members.map(|link| end(&mut graph, link));
                let sun = graph.join([carrier, sun], Kind::Sun(set));
                let ring = graph.join([carrier, ring], Kind::Ring(set));
                graph.planets.push(Planet { set, carrier, sun, ring });
            }
        }
        for (shift_element, links) in self.shift_elements() {
            if keeps(Element::ShiftElement(shift_element)) {
                let ends = links.map(|link| end(&mut graph, link));
                graph.join(ends, Kind::ShiftElement(shift_element));
            }
        }
        graph.connect();
        graph
    }

    /// Shift elements between different pieces: what joins a piece with itself needs no room.
    fn shift_elements(&self) -> impl Iterator<Item = (usize, [LinkId; 2])> {
        let own = self.gearbox.shift_elements().iter().map(epicyclic_train::ShiftElement::links);
        let all = own.chain(self.direct_clutches.iter().copied()).enumerate();
        all.filter(|(_, links)| self.piece(links[0]) != self.piece(links[1]))
    }

    /// Ties between two links: shift elements, and the ways out to the housing.
    pub(super) fn ties(&self) -> Vec<([LinkId; 2], Kind)> {
        let shift_elements = self.shift_elements().map(|(place, links)| (links, Kind::ShiftElement(place)));
        let take_offs =
            self.take_offs().into_iter().map(|link| ([link, LinkId::GROUND], Kind::TakeOff(link)));
        shift_elements.chain(take_offs).collect()
    }

    /// Position of each set of a gearbox between input and output: it rises with the steps from the input and
    /// falls with those from the output. Each set and shift element is a step from one of its links to
    /// another.
    pub(super) fn stages(&self) -> Vec<u32> {
        let gearbox = self.gearbox;
        let sets: Vec<Vec<LinkId>> = gearbox.sets().iter().map(|set| set.members().to_vec()).collect();
        let ties = self.ties().into_iter().map(|(links, _)| links.to_vec());
        let groups = sets.iter().cloned().chain(ties);
        let groups: Vec<Vec<LinkId>> =
            groups.map(|links| links.into_iter().map(|link| self.piece(link)).collect()).collect();
        let links = gearbox.links().len();
        let far = |from: LinkId| {
            let mut far = vec![None; links];
            far[self.piece(from).index()] = Some(0);
            for step in 0..u32::try_from(links).unwrap_or(0) {
                for group in &groups {
                    let moving = || group.iter().filter(|link| **link != LinkId::GROUND);
                    if moving().any(|link| far[link.index()] == Some(step)) {
                        for link in moving() {
                            far[link.index()] = far[link.index()].or(Some(step + 1));
                        }
                    }
                }
            }
            far
        };
        let (from_input, from_output) = (far(gearbox.input()), far(gearbox.output()));
        // Means, over the sets' members, in twelfths of a step.
        let mean = |group: &[LinkId], far: &[Option<u32>]| {
            let known: Vec<u32> = group.iter().filter_map(|link| far[link.index()]).collect();
            12 * known.iter().sum::<u32>() / u32::try_from(known.len().max(1)).unwrap_or(1)
        };
        let most = 12 * u32::try_from(links).unwrap_or(0);
        let stage =
            |group: &Vec<LinkId>| most + mean(group, &from_input) - mean(group, &from_output).min(most);
        groups[..sets.len()].iter().map(stage).collect()
    }
}

//! A layout with its gears at heights in proportion to their radii.
//!
//! The positions along the axis and the order of the lines above one another do not change. The heights of
//! the contacts and planet pins are given, in one scale for all sets; all others are as low as
//!
//! ```text
//! y_upper − y_lower ≥ gap        for every two lines that have a place along the axis in common
//! y = scale·radius               of contacts and planet pins
//! ```
//!
//! allow: a shaft lies close to the axis, a drum close over the largest ring that it passes. The scale is the
//! least for which there are such heights: they are longest paths in a graph without circles, and a larger
//! scale never takes room away. A carrier whose sets have pins at different heights has a web between them.

use super::layout::{GAP, Layout, PLANET, Point, Segment, SetStack, ShaftEnd, shapes};
use epicyclic_numerics::roots::bisected;
use epicyclic_train::LinkId;

/// Least distance of two lines.
const LINE: f64 = 0.6;
/// Distance from a contact, or the far side of a planet, to the line that carries a gear there.
const SEAT: f64 = 0.45;
/// Distance from a contact to the planet pin.
const REACH: f64 = 0.35;
/// Distance from a line to the middle of a clutch.
const PLATE: f64 = 0.45;
/// Distance from a line to a projection of the housing, with a brake between.
const BRAKE: f64 = 0.75;

/// Number of halvings or doublings of the scale until there is room; and of halvings of the step in its
/// search.
const HALVINGS: u32 = 60;

/// Given heights of a drawn set.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SetRadii {
    /// No heights: the set is placed wherever it fits.
    Free,
    /// The contact of two gears on fixed axes, as a radius of the first.
    Contact(f64),
    /// Contacts and planet pin as radii, and how far its planets reach towards the axis and away from it.
    Planets {
        /// Contact of central gear 1 and planet.
        sun_mesh: f64,
        /// The planet pin.
        planet: f64,
        /// Contact of planet and central gear 2.
        ring_mesh: f64,
        /// The least and the largest distance of a planet from the axis.
        reach: [f64; 2],
    },
}

/// A set whose gears would have to be above those of another set, with smaller radii.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NotToScale {
    /// The lower set and the upper one, by their places in
    /// [`Gearbox::drawn_sets`](epicyclic_train::Gearbox::drawn_sets).
    pub sets: [usize; 2],
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Height {
    Free,
    At(f64),
    /// A radius, and an addition in grid units.
    Radius(f64, f64),
    /// Offset over another node.
    Over(usize, f64),
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Line,
    /// The middle of a clutch.
    Plate,
    Pin,
    Contact,
    /// Farthest point of a planet.
    Reach,
}

/// Whatever has one height.
#[derive(Debug, Clone)]
struct Node {
    kind: Kind,
    link: Option<LinkId>,
    /// Set of the node.
    set: Option<usize>,
    /// Height in the layout as it is.
    y: f64,
    /// Range along the axis.
    x: [f64; 2],
    height: Height,
}

/// A layout taken apart.
struct Heights<'a> {
    layout: &'a Layout,
    nodes: Vec<Node>,
    /// Level lines: the node and its link.
    level: Vec<(LinkId, usize, [f64; 2])>,
    /// Webs of carriers between pins at different heights.
    webs: Vec<(LinkId, f64, [usize; 2])>,
    /// Nodes of planet pin and contacts of each stack, in the layout's order.
    stacks: Vec<[usize; 3]>,
    /// Node of each clutch.
    plates: Vec<usize>,
    /// `(lower, upper, gap)`.
    rises: Vec<(usize, usize, f64)>,
}

const WALL: usize = 0;

impl Layout {
    /// Drawing with contacts and planet pins at heights in proportion to their radii, and its scale.
    ///
    /// The scale is in grid units over the unit of the radii. `sets` are in the order of [`Layout::sets`].
    /// `chosen` receives the least scale that leaves room and returns the scale to use; the result is never
    /// below the least.
    ///
    /// # Errors
    /// [`NotToScale`] where a set is above another that is larger, as may happen if not all sets are in one
    /// band.
    pub fn to_scale(
        &self,
        sets: &[SetRadii],
        chosen: impl FnOnce(f64) -> f64,
    ) -> Result<(Self, f64), NotToScale> {
        let heights = Heights::new(self, sets);
        let mut scale = 1.0;
        for _ in 0..HALVINGS {
            match heights.solve(scale) {
                Ok(_) => scale *= 0.5,
                Err(_) => break,
            }
        }
        let mut found = heights.solve(scale);
        for _ in 0..2 * HALVINGS {
            if found.is_ok() {
                break;
            }
            scale *= 2.0;
            found = heights.solve(scale);
        }
        found?;
        let [least, _] = bisected([scale, 0.0], HALVINGS, |scale| heights.solve(scale).is_ok());
        let scale = least.max(chosen(least));
        let places = heights.solve(scale)?;
        Ok((heights.layout(&places), scale))
    }
}

impl<'a> Heights<'a> {
    fn new(layout: &'a Layout, sets: &[SetRadii]) -> Self {
        let wall = Node {
            kind: Kind::Line,
            link: Some(LinkId::GROUND),
            set: None,
            y: layout.housing.from.y,
            x: [layout.housing.from.x, layout.housing.to.x],
            height: Height::Free,
        };
        let (level, webs, stacks) = (vec![], vec![], vec![]);
        let mut heights =
            Self { layout, nodes: vec![wall], level, webs, stacks, plates: vec![], rises: vec![] };
        for (stack, radii) in layout.sets.iter().zip(sets) {
            heights.stack(stack, *radii);
        }
        for shape in &layout.links {
            for segment in shape.segments.iter().filter(|s| s.from.y == s.to.y) {
                heights.level_line(shape.link, segment);
            }
        }
        for mark in &layout.clutches {
            let (x, y) = (mark.lower.1.x, f64::midpoint(mark.lower.1.y, mark.upper.1.y));
            heights.plates.push(heights.nodes.len());
            heights.nodes.push(Node {
                kind: Kind::Plate,
                link: None,
                set: None,
                y,
                x: [x; 2],
                height: Height::Free,
            });
        }
        for shape in &layout.links {
            for segment in shape.segments.iter().filter(|s| s.from.x == s.to.x) {
                heights.end(shape.link, segment.from);
                heights.end(shape.link, segment.to);
            }
        }
        for stack in &layout.sets {
            heights.end(stack.members[0], Point { x: stack.x, y: stack.sun });
            heights.end(stack.members[1], Point { x: stack.x, y: stack.ring });
        }
        heights.rises();
        heights
    }

    fn stack(&mut self, stack: &SetStack, radii: SetRadii) {
        let pin = self.nodes.len();
        let (contacts, reach) = match radii {
            SetRadii::Free => ([Height::Over(pin, -PLANET), Height::Free, Height::Over(pin, PLANET)], None),
            SetRadii::Contact(radius) => {
                ([-PLANET, 0.0, PLANET].map(|aside| Height::Radius(radius, aside)), None)
            }
            SetRadii::Planets { sun_mesh, planet, ring_mesh, reach } => {
                ([sun_mesh, planet, ring_mesh].map(|radius| Height::Radius(radius, 0.0)), Some(reach))
            }
        };
        let node = |kind, y, height| Node {
            kind,
            link: (kind == Kind::Pin).then_some(stack.members[2]),
            set: Some(stack.set),
            y,
            x: [stack.x; 2],
            height,
        };
        self.nodes.push(node(Kind::Pin, stack.planet, contacts[1]));
        self.nodes.push(node(Kind::Contact, stack.sun_mesh, contacts[0]));
        self.nodes.push(node(Kind::Contact, stack.ring_mesh, contacts[2]));
        self.stacks.push([pin, pin + 1, pin + 2]);
        if let Some([low, high]) = reach {
            self.nodes.push(node(Kind::Reach, stack.sun_mesh, Height::Radius(low, 0.0)));
            self.nodes.push(node(Kind::Reach, stack.ring_mesh, Height::Radius(high, 0.0)));
        }
    }

    fn level_line(&mut self, link: LinkId, line: &Segment) {
        let (y, ends) = (line.from.y, [line.from.x, line.to.x]);
        let is_on = |stack: &SetStack| {
            stack.members[2] == link && stack.planet == y && (ends[0]..=ends[1]).contains(&stack.x)
        };
        let stacks = self.layout.sets.iter().zip(&self.stacks).filter(|(stack, _)| is_on(stack));
        let mut pins: Vec<(f64, usize)> = stacks.map(|(stack, nodes)| (stack.x, nodes[0])).collect();
        pins.sort_by(|a, b| a.0.total_cmp(&b.0));
        let Some(&(_, first)) = pins.first() else {
            let height = if y == self.layout.axis.from.y { Height::At(y) } else { Height::Free };
            self.level.push((link, self.nodes.len(), ends));
            self.nodes.push(Node { kind: Kind::Line, link: Some(link), set: None, y, x: ends, height });
            return;
        };
        // A web is placed at an arm of the carrier, or else in the middle between two sets.
        let arms: Vec<f64> = self
            .layout
            .links
            .iter()
            .filter(|shape| shape.link == link)
            .flat_map(|shape| &shape.segments)
            .filter(|s| s.from.x == s.to.x && (s.from.y..=s.to.y).contains(&y))
            .map(|s| s.from.x)
            .collect();
        let mut from = ends[0];
        let mut last = first;
        for pair in pins.windows(2) {
            let [(left, _), (right, next)] = [pair[0], pair[1]];
            let arm = arms.iter().copied().find(|x| left < *x && *x < right);
            let web = arm.unwrap_or(f64::midpoint(left, right));
            self.piece(link, last, [from, web]);
            self.webs.push((link, web, [last, next]));
            (from, last) = (web, next);
        }
        self.piece(link, last, [from, ends[1]]);
    }

    fn piece(&mut self, link: LinkId, pin: usize, ends: [f64; 2]) {
        self.nodes[pin].x = ends;
        self.level.push((link, pin, ends));
    }

    /// Adds a node for the end of an upright line if it has none yet.
    fn end(&mut self, link: LinkId, at: Point) {
        if self.plate(link, at).is_none()
            && self.beside_housing(link, at).is_none()
            && !self.is_known(link, at)
        {
            let height = if at.y == self.layout.axis.from.y { Height::At(at.y) } else { Height::Free };
            let (kind, link) = (Kind::Line, Some(link));
            self.nodes.push(Node { kind, link, set: None, y: at.y, x: [at.x; 2], height });
        }
    }

    fn at(&self, link: LinkId, at: Point) -> impl Iterator<Item = usize> {
        let is_here = move |node: &Node| {
            node.link == Some(link) && node.y == at.y && (node.x[0]..=node.x[1]).contains(&at.x)
        };
        self.nodes.iter().enumerate().filter(move |(_, node)| is_here(node)).map(|(place, _)| place)
    }

    fn is_known(&self, link: LinkId, at: Point) -> bool {
        self.at(link, at).next().is_some()
    }

    /// Clutch node at one of whose plates a point is, and the side of its middle.
    fn plate(&self, link: LinkId, at: Point) -> Option<(usize, f64)> {
        self.layout.clutches.iter().zip(&self.plates).find_map(|(mark, &node)| match () {
            () if mark.lower == (link, at) => Some((node, -GAP)),
            () if mark.upper == (link, at) => Some((node, GAP)),
            () => None,
        })
    }

    /// Projection of the housing across the gap of a brake or of a way out, and its side.
    fn beside_housing(&self, link: LinkId, at: Point) -> Option<(usize, f64)> {
        let brake = self.layout.brakes.iter().find(|mark| mark.link == link && mark.link_end == at);
        if let Some(mark) = brake {
            let side = (at.y - mark.housing.y).signum();
            return self.at(LinkId::GROUND, mark.housing).next().map(|node| (node, side * GAP));
        }
        self.layout.take_offs.iter().find(|end| end.link == link && end.at == at)?;
        // The nearest of the housing's lines on either side is the one, a gap away.
        let near = |node: &&usize| (self.nodes[**node].y - at.y).abs() < 2.0 * GAP;
        let ground: Vec<usize> = (0..self.nodes.len())
            .filter(|&node| self.nodes[node].link == Some(LinkId::GROUND))
            .filter(|&node| (self.nodes[node].x[0]..=self.nodes[node].x[1]).contains(&at.x))
            .collect();
        ground.iter().find(near).map(|&node| (node, (at.y - self.nodes[node].y).signum() * GAP))
    }

    /// Collects the pairs of nodes that lie above each other, and their least distance.
    fn rises(&mut self) {
        for lower in 0..self.nodes.len() {
            for upper in 0..self.nodes.len() {
                let (a, b) = (&self.nodes[lower], &self.nodes[upper]);
                let meet = a.x[0] <= b.x[1] && b.x[0] <= a.x[1];
                if meet
                    && a.y < b.y
                    && let Some(gap) = gap(a, b)
                {
                    self.rises.push((lower, upper, gap));
                }
            }
        }
        let brakes = self.layout.brakes.iter().map(|mark| (mark.link, mark.link_end));
        let ends = brakes.chain(self.layout.take_offs.iter().map(|end| (end.link, end.at)));
        for (link, at) in ends {
            let Some((housing, side)) = self.beside_housing(link, at) else { continue };
            for node in 0..self.nodes.len() {
                let Node { x: [low, high], y, .. } = self.nodes[node];
                if node == housing || !(low..=high).contains(&at.x) {
                    continue;
                }
                if side < 0.0 && y <= at.y {
                    self.rises.push((node, housing, BRAKE));
                } else if side > 0.0 && y >= at.y {
                    self.rises.push((housing, node, BRAKE));
                }
            }
        }
        self.rises.sort_by(|a, b| self.nodes[a.0].y.total_cmp(&self.nodes[b.0].y));
    }

    /// Least heights in a scale.
    ///
    /// # Errors
    /// The sets that obstruct each other, where the scale leaves no room.
    fn solve(&self, scale: f64) -> Result<Vec<f64>, NotToScale> {
        let root = |node: usize| match self.nodes[node].height {
            Height::Over(other, by) => (other, by),
            _ => (node, 0.0),
        };
        let given = |node: usize| match self.nodes[node].height {
            Height::At(y) => Some(y),
            Height::Radius(radius, aside) => Some(scale * radius + aside),
            Height::Free | Height::Over(..) => None,
        };
        let mut from: Vec<Option<usize>> = vec![None; self.nodes.len()];
        let mut y: Vec<f64> = (0..self.nodes.len()).map(|node| given(node).unwrap_or(LINE)).collect();
        for round in 0..=self.nodes.len() {
            let mut is_risen = false;
            for &(lower, upper, gap) in &self.rises {
                let ((low, below), (high, above)) = (root(lower), root(upper));
                let least = y[low] + below + gap - above;
                if low == high || least <= y[high] {
                    continue;
                }
                if given(high).is_some() || round == self.nodes.len() {
                    return Err(self.in_the_way(&from, low, high));
                }
                (y[high], from[high]) = (least, Some(low));
                is_risen = true;
            }
            if !is_risen {
                break;
            }
        }
        for node in 0..self.nodes.len() {
            let (root, by) = root(node);
            y[node] = y[root] + by;
        }
        Ok(y)
    }

    fn in_the_way(&self, from: &[Option<usize>], low: usize, high: usize) -> NotToScale {
        let mut node = low;
        for _ in 0..self.nodes.len() {
            match from[node] {
                Some(lower) => node = lower,
                None => break,
            }
        }
        let set = |node: usize| self.nodes[node].set;
        let upper = set(high).or(set(node)).unwrap_or_default();
        NotToScale { sets: [set(node).unwrap_or(upper), upper] }
    }

    /// Height of the end of something upright: of two pins at a web the nearer one.
    fn lifted(&self, y: &[f64], link: LinkId, at: Point, is_upper: bool) -> f64 {
        if let Some((node, side)) = self.plate(link, at).or_else(|| self.beside_housing(link, at)) {
            return y[node] + side;
        }
        let heights = self.at(link, at).map(|node| y[node]);
        let nearer = if is_upper { heights.reduce(f64::min) } else { heights.reduce(f64::max) };
        nearer.unwrap_or(at.y)
    }

    fn layout(&self, least: &[f64]) -> Layout {
        let mut y = least.to_vec();
        // A clutch is placed in the middle of the lines that it joins.
        for &plate in &self.plates {
            let x = self.nodes[plate].x[0];
            let here = |node: &usize| {
                *node != plate && (self.nodes[*node].x[0]..=self.nodes[*node].x[1]).contains(&x)
            };
            let is_lower = |node: &usize| self.nodes[*node].y < self.nodes[plate].y;
            let heights = |lower: bool| {
                (0..self.nodes.len())
                    .filter(here)
                    .filter(move |node| is_lower(node) == lower)
                    .map(|node| least[node])
            };
            let low = heights(true).reduce(f64::max);
            if let (Some(low), Some(high)) = (low, heights(false).reduce(f64::min)) {
                y[plate] = f64::midpoint(low, high);
            }
        }
        let lift = |link: LinkId, at: Point, is_upper: bool| Point {
            x: at.x,
            y: self.lifted(&y, link, at, is_upper),
        };
        let mut pieces: Vec<(LinkId, Segment)> = vec![];
        for &(link, node, [from, to]) in &self.level {
            let at = |x: f64| Point { x, y: y[node] };
            pieces.push((link, Segment { from: at(from), to: at(to) }));
        }
        for &(link, x, [a, b]) in &self.webs {
            let at = |y: f64| Point { x, y };
            pieces.push((link, Segment { from: at(y[a].min(y[b])), to: at(y[a].max(y[b])) }));
        }
        for shape in &self.layout.links {
            for s in shape.segments.iter().filter(|s| s.from.x == s.to.x) {
                let (from, to) = (lift(shape.link, s.from, false), lift(shape.link, s.to, true));
                pieces.push((shape.link, Segment { from, to }));
            }
        }
        let plain = self.layout;
        let sets = plain.sets.iter().zip(&self.stacks).map(|(stack, &[pin, sun_mesh, ring_mesh])| SetStack {
            sun: self.lifted(&y, stack.members[0], Point { x: stack.x, y: stack.sun }, false),
            sun_mesh: y[sun_mesh],
            planet: y[pin],
            ring_mesh: y[ring_mesh],
            ring: self.lifted(&y, stack.members[1], Point { x: stack.x, y: stack.ring }, true),
            ..*stack
        });
        let clutches = plain.clutches.iter().map(|mark| {
            let mut mark = *mark;
            mark.lower.1 = lift(mark.lower.0, mark.lower.1, true);
            mark.upper.1 = lift(mark.upper.0, mark.upper.1, false);
            mark
        });
        let brakes = plain.brakes.iter().map(|mark| {
            let mut mark = *mark;
            mark.link_end = lift(mark.link, mark.link_end, true);
            mark.housing = lift(LinkId::GROUND, mark.housing, true);
            mark
        });
        let end = |end: &ShaftEnd| ShaftEnd { at: lift(end.link, end.at, true), ..*end };
        let wall = |at: Point| Point { y: y[WALL], ..at };
        Layout {
            sets: sets.collect(),
            links: shapes(pieces.into_iter().filter(|(_, s)| s.from != s.to).collect()),
            clutches: clutches.collect(),
            brakes: brakes.collect(),
            take_offs: plain.take_offs.iter().map(end).collect(),
            input: end(&plain.input),
            output: end(&plain.output),
            axis: plain.axis,
            housing: Segment { from: wall(plain.housing.from), to: wall(plain.housing.to) },
        }
    }
}

/// The least distance of two nodes, the upper one last; `None` where they are parts of one set that say
/// nothing of each other.
fn gap(lower: &Node, upper: &Node) -> Option<f64> {
    use Kind::{Contact, Pin, Plate, Reach};
    let is_own = lower.set.is_some() && lower.set == upper.set;
    match (lower.kind, upper.kind) {
        (Contact, Pin) | (Pin, Contact) if is_own => Some(REACH),
        (Contact | Reach | Pin, Contact | Reach | Pin) if is_own => None,
        (Plate, _) | (_, Plate) => Some(PLATE),
        (Contact | Reach, Kind::Line) | (Kind::Line, Contact | Reach) => Some(SEAT),
        _ => Some(LINE),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Options, Verdict, draw};
    use epicyclic_train::Gearbox;
    use epicyclic_train::set::SetSpec;

    fn planets(sun_mesh: f64, ring_mesh: f64) -> SetRadii {
        let planet = f64::midpoint(sun_mesh, ring_mesh);
        SetRadii::Planets { sun_mesh, planet, ring_mesh, reach: [sun_mesh, ring_mesh] }
    }

    fn plain(gearbox: &Gearbox) -> Layout {
        match draw(gearbox, Options::default()) {
            Verdict::Drawable(layout) => *layout,
            Verdict::SelfCrossing(_) => unreachable!("it can be drawn"),
        }
    }

    /// Scheme I with radii 1, 2 and 3, by hand: the sun on the axis needs a scale of 0.45, the planet one of
    /// 0.35. The ring's web is 0.45 high and the brake in it 0.75.
    #[test]
    fn the_least_heights_of_one_set() {
        let gearbox = crate::samples::scheme_one();
        let (layout, scale) = plain(&gearbox).to_scale(&[planets(1.0, 3.0)], |least| least).unwrap();
        let set = layout.sets[0];
        assert!((scale - SEAT).abs() < 1e-9, "{scale}");
        assert_eq!(
            [set.sun, set.sun_mesh, set.planet, set.ring_mesh],
            [0.0, scale, 2.0 * scale, 3.0 * scale]
        );
        assert!((set.ring - (3.0 * scale + SEAT)).abs() < 1e-9, "{set:?}");
        assert!((layout.housing.from.y - (set.ring + BRAKE)).abs() < 1e-9, "{layout:?}");
        assert_eq!(layout.crossings(), []);
        // A larger scale is taken as it is, a smaller one is not.
        let chosen = |wanted| plain(&gearbox).to_scale(&[planets(1.0, 3.0)], |_| wanted).unwrap().1;
        assert_eq!([chosen(2.0), chosen(0.1)], [2.0, scale]);
    }

    /// Carriers on one level line with pins at different heights get a web between them, and nothing crosses.
    #[test]
    fn a_web_joins_pins_at_different_heights() {
        let gearbox = Gearbox::builder("one carrier")
            .links(["D", "B", "T1", "T2"])
            .set(SetSpec::simple("1", ["T1", "D", "T2"], 2.5))
            .set(SetSpec::simple("2", ["T1", "B", "T2"], 2.5))
            .brake("K1", "T1")
            .brake("K2", "T2")
            .input("D")
            .output("B")
            .build()
            .unwrap();
        let flat = plain(&gearbox);
        assert_eq!(flat.sets[0].planet, flat.sets[1].planet);
        let (layout, scale) = flat.to_scale(&[planets(1.0, 3.0), planets(2.0, 4.0)], |least| least).unwrap();
        assert_eq!(layout.crossings(), []);
        let pins = layout.sets.iter().map(|stack| stack.planet);
        assert_eq!(pins.collect::<Vec<_>>(), [2.0 * scale, 3.0 * scale]);
        let carrier = layout.links.iter().find(|shape| shape.link == layout.sets[0].members[2]).unwrap();
        let joins = |s: &Segment| s.from.x == s.to.x && s.from.y <= 2.0 * scale && 3.0 * scale <= s.to.y;
        assert!(carrier.segments.iter().any(joins), "{carrier:?}");
    }

    /// A set around another one, as drawings with sets at any heights may have it, and with smaller gears.
    #[test]
    fn a_smaller_set_around_a_larger_one_is_refused() {
        let mut layout = plain(&crate::samples::scheme_one());
        let first = layout.sets[0];
        let up = |y: f64| y + layout.housing.from.y;
        layout.sets.push(SetStack {
            set: 1,
            sun: up(first.sun),
            sun_mesh: up(first.sun_mesh),
            planet: up(first.planet),
            ring_mesh: up(first.ring_mesh),
            ring: up(first.ring),
            ..first
        });
        let refused = layout.to_scale(&[planets(1.0, 3.0), planets(2.0, 4.0)], |least| least);
        assert_eq!(refused.unwrap_err(), NotToScale { sets: [0, 1] });
    }
}

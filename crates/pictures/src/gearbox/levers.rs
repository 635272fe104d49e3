//! Sets as levers (lever analogy of Benford and Leising): the links of a set are points along a bar, and
//! their speeds lie on a straight line across it.
//!
//! By the set's equation `ω_1 − i₀·ω_2 − (1 − i₀)·ω_H = 0` the carrier is at 0, central gear 2 at −1 and
//! central gear 1 at `−i₀`. In a simple set the ring is one unit on one side of the carrier, the sun `k`
//! units on the other. Two sets with two links in common are one lever, the second set scaled to fit. A link
//! in several levers is one thin line through its points; a link of no set is a single point.
//!
//! | sign of a point | is |
//! |---|---|
//! | square, diamond | the link where power enters, where it leaves |
//! | triangle | a link that a brake or the housing holds |
//! | double circle | a link that an engaged clutch ties to another |
//! | circle | any other |
//!
//! The position of each lever, and which of its ends is up, follow from a [cost function](levers): ties cross
//! as little as possible and are as level as possible. In a gear the speeds, over the input's, are offsets
//! from the lever; the points of each lever lie on one line.
//!
//! # Source
//! H. L. Benford, M. B. Leising: The lever analogy: a new tool in transmission analysis. SAE paper 810102,
//! 1981.

mod arrange;
mod merge;
mod signs;

use super::place::Places;
use super::scheme::{known, piece_of, title};
use super::words::{self, decimal, width_of};
use super::{COLORS, ENGAGED, Error, LETTERS_MM, TITLE_MM};
use crate::tolerance::LEAST_SPEED;
use arrange::{Column, Tie};
use epicyclic_drawing::{Align, LayerId, Point, Scene, Shape, Style, Text};
use epicyclic_train::{Analysis, Gearbox, LinkId};
use signs::{Role, SIGN_MM};

pub use merge::{Lever, levers};

/// Room of the fastest link on its side.
const FASTEST_MM: f64 = 26.0;
/// Distance from the parts of one lever to the parts of the next.
const APART_MM: f64 = 9.0;
/// Distance between the parts of two levers on a page, whose width sets the size of the letters.
const APART_ON_PAGE_MM: f64 = 6.5;
/// Distance from a lever to the plate of its first brake, and from brake to brake of one link.
const BRAKE_MM: f64 = 5.0;
/// Distance from the middle of a clutch to the mark of a speed.
const CLUTCH_CLEAR_MM: f64 = 4.0;
/// Distance from a lever to a clutch next to it.
const BESIDE_MM: f64 = 8.0;
/// Least width of the legend.
const LEGEND_MM: f64 = 105.0;

/// A node on paper.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Node {
    link: LinkId,
    at: Point,
    /// Speed over the input's, and the point that represents it.
    speed: Option<(f64, Point)>,
}

/// The levers of a gearbox, and the speeds of a gear on them.
///
/// # Errors
/// [`Error::SpeedsUnknown`] for a gear in which the speed of a link does not follow.
pub fn scene(gearbox: &Gearbox, gear: Option<&Analysis>, heading: Option<&str>) -> Result<Scene, Error> {
    let mut sheet = drawn(gearbox, gear, heading, APART_MM)?;
    sheet.legend();
    sheet.scene.check()?;
    Ok(sheet.scene)
}

/// Levers without title and text on the sets, for a page that has its own; the signs stay explained.
///
/// # Errors
/// Those of [`scene`].
pub fn bare(gearbox: &Gearbox, gear: Option<&Analysis>) -> Result<Scene, Error> {
    let mut sheet = drawn(gearbox, gear, None, APART_ON_PAGE_MM)?;
    let bounds = sheet.scene.bounds();
    sheet.explain_signs(Point::new(bounds.left, bounds.bottom - 6.0), bounds.width().max(LEGEND_MM));
    sheet.scene.check()?;
    Ok(sheet.scene)
}

/// Diagram without the legend.
fn drawn<'a>(
    gearbox: &'a Gearbox,
    gear: Option<&'a Analysis<'a>>,
    heading: Option<&str>,
    apart_mm: f64,
) -> Result<Sheet<'a>, Error> {
    if let Some(gear) = gear {
        known(gearbox, gear)?;
    }
    let mut scene = Scene::new(heading.map_or_else(|| title(gearbox, gear), str::to_owned));
    let layers = Layers {
        joints: scene.layer("joints", Style::line(0.25))?,
        levers: scene.layer("levers", Style::line(0.9))?,
        speeds: scene.layer("speeds", Style::line(0.25).color(COLORS[0]))?,
        shift_elements: scene.layer("shift elements", Style::line(0.35))?,
        labels: scene.layer("labels", Style::line(0.1))?,
    };
    let mut levers = levers(gearbox);
    levers.extend(single(gearbox, &levers));
    let mut sheet = Sheet {
        gearbox,
        gear,
        levers,
        columns: vec![],
        ties: vec![],
        placed: vec![],
        roles: vec![],
        scene,
        layers,
    };
    sheet.place(apart_mm);
    sheet.joints();
    let names = sheet.shift_elements();
    sheet.levers();
    sheet.names(&names);
    Ok(sheet)
}

/// Links of no set where power enters or leaves, or that shift elements take hold of: points by themselves.
fn single(gearbox: &Gearbox, levers: &[Lever]) -> Vec<Lever> {
    let held = gearbox.shift_elements().iter().flat_map(epicyclic_train::ShiftElement::links);
    let ends = gearbox.gears().iter().flat_map(|gear| [gear.input(), gear.output()]);
    let mut found: Vec<LinkId> = vec![];
    for link in held.chain(ends).map(|link| piece_of(gearbox, link)).filter(|link| *link != LinkId::GROUND) {
        let is_there = levers.iter().flat_map(|lever| &lever.nodes).any(|node| node.0 == link);
        if !is_there && !found.contains(&link) {
            found.push(link);
        }
    }
    found.into_iter().map(|link| Lever { sets: vec![], nodes: vec![(link, 0.0)] }).collect()
}

struct Layers {
    joints: LayerId,
    levers: LayerId,
    speeds: LayerId,
    shift_elements: LayerId,
    labels: LayerId,
}

/// The diagram while it is drawn.
struct Sheet<'a> {
    gearbox: &'a Gearbox,
    gear: Option<&'a Analysis<'a>>,
    levers: Vec<Lever>,
    columns: Vec<Column>,
    ties: Vec<Tie>,
    /// The points of each column.
    placed: Vec<Vec<Node>>,
    /// Roles of the links, in the order of the gearbox.
    roles: Vec<Role>,
    scene: Scene,
    layers: Layers,
}

impl Sheet<'_> {
    fn engaged(&self, shift_element: usize) -> bool {
        self.gear.is_some_and(|gear| gear.gear().engaged().contains(&shift_element))
    }

    /// The clutches that are drawn, with the links that they join: all, of a gear the engaged ones.
    fn clutches(&self) -> Vec<(usize, [LinkId; 2])> {
        let all = self.gearbox.shift_elements().iter().enumerate();
        let shown =
            all.filter(|(place, one)| !one.is_brake() && (self.gear.is_none() || self.engaged(*place)));
        shown.map(|(place, one)| (place, one.links().map(|link| piece_of(self.gearbox, link)))).collect()
    }

    /// Brakes of a link.
    fn brakes(&self, link: LinkId) -> impl Iterator<Item = usize> {
        let all = self.gearbox.shift_elements().iter().enumerate();
        all.filter(move |(_, one)| one.is_brake() && piece_of(self.gearbox, one.links()[0]) == link)
            .map(|(place, _)| place)
    }

    /// Name of a point: its link and, on a lever, the members of sets that it represents.
    fn name(&self, lever: usize, link: LinkId) -> String {
        let members = self.levers[lever].members(self.gearbox, link);
        let name = self.gearbox.link_name(link);
        if members.is_empty() { name.to_owned() } else { format!("{name} ({members})") }
    }

    /// Places the levers side by side, each far enough from the previous one for the parts of both.
    fn place(&mut self, apart_mm: f64) {
        let clutches = self.clutches();
        self.columns = arrange::arrange(&self.levers, &clutches);
        self.ties = arrange::ties(&self.columns, &clutches);
        self.roles = Role::of_links(self.gearbox, self.gear);
        let speed = |link: LinkId| self.gear.and_then(|gear| gear.speed(link));
        let all = || self.columns.iter().flat_map(|column| &column.points).filter_map(|point| speed(point.0));
        let fastest = all().map(f64::abs).fold(LEAST_SPEED, f64::max);
        let (mut x, mut placed) = (0.0, vec![]);
        for (place, column) in self.columns.iter().enumerate() {
            let offsets =
                || column.points.iter().filter_map(|point| Some(FASTEST_MM * speed(point.0)? / fastest));
            let names = column.points.iter().map(|point| width_of(&self.name(column.lever, point.0)));
            let brakes = column.points.iter().map(|point| match self.is_braked_at(place, point.0) {
                true => BRAKE_MM * self.brakes(point.0).count() as f64 + 5.0,
                false => 0.0,
            });
            let beside = self.ties.iter().filter(|tie| tie.ends.iter().all(|end| end.0 == place)).count();
            let backward = offsets().map(|offset| 12.0 - offset).filter(|room| *room > 12.0);
            let left = names.chain(brakes).chain(backward).fold(BESIDE_MM * beside as f64, f64::max) + 2.0;
            let ahead = offsets().map(|offset| offset.max(0.0) + 10.0).fold(4.0, f64::max);
            if place > 0 {
                x += left + apart_mm;
            }
            let node = |&(link, y): &(LinkId, f64)| {
                let tip = |speed: f64| Point::new(x + FASTEST_MM * speed / fastest, y);
                Node { link, at: Point::new(x, y), speed: speed(link).map(|speed| (speed, tip(speed))) }
            };
            placed.push(column.points.iter().map(node).collect());
            x += ahead;
        }
        self.placed = placed;
    }

    /// Whether the brakes of a link are drawn at this column: at the first point of the link, which no tie
    /// reaches from the left.
    fn is_braked_at(&self, column: usize, link: LinkId) -> bool {
        let has = |column: &Column| column.points.iter().any(|point| point.0 == link);
        self.columns.iter().position(has) == Some(column)
    }

    fn node(&self, (column, link): (usize, LinkId)) -> Option<Node> {
        self.placed.get(column)?.iter().find(|node| node.link == link).copied()
    }

    /// Thin lines through the points of one link on several levers.
    fn joints(&mut self) {
        for tie in self.ties.iter().filter(|tie| tie.clutch.is_none()) {
            if let [Some(one), Some(other)] = tie.ends.map(|end| self.node(end)) {
                self.scene.add(self.layers.joints, Shape::line(one.at, other.at));
            }
        }
    }

    /// The levers, across each the line of its speeds, and the signs of its points.
    fn levers(&mut self) {
        for nodes in &self.placed {
            let (Some(first), Some(last)) = (nodes.first(), nodes.last()) else { continue };
            if nodes.len() > 1 {
                self.scene.add(self.layers.levers, Shape::line(first.at, last.at));
            }
            if let (Some((_, from)), Some((_, to))) = (first.speed, last.speed)
                && from != to
            {
                let style = Style::line(0.5).color(COLORS[0]);
                self.scene.add_styled(self.layers.speeds, style, Shape::line(from, to));
            }
            for node in nodes {
                if let Some((_, tip)) = node.speed
                    && (tip.x - node.at.x).abs() > SIGN_MM
                {
                    let edge = Point::new(node.at.x + SIGN_MM * (tip.x - node.at.x).signum(), tip.y);
                    self.scene.add(self.layers.speeds, Shape::line(edge, tip));
                    let dot = Shape::Circle { centre: tip, radius: 0.9 };
                    self.scene.add_styled(self.layers.speeds, Style::filled(COLORS[0]), dot);
                }
                signs::draw(&mut self.scene, self.layers.levers, node.at, self.roles[node.link.index()]);
            }
        }
    }

    /// Brakes as plates beside their link, clutches between their links; returns names of shift elements and
    /// where they belong.
    fn shift_elements(&mut self) -> Vec<(String, Point)> {
        let mut names = vec![];
        let style = |engaged: bool| {
            if engaged { Style::line(0.6).color(ENGAGED) } else { Style::line(0.35) }
        };
        let layer = self.layers.shift_elements;
        for (place, nodes) in self.placed.clone().iter().enumerate() {
            for node in nodes {
                if node.link == LinkId::GROUND || !self.is_braked_at(place, node.link) {
                    continue;
                }
                let brakes: Vec<usize> = self.brakes(node.link).collect();
                // Several brakes of one link, one behind the other: the furthest first, so that an engaged
                // one is seen.
                for (count, brake) in brakes.into_iter().enumerate().rev() {
                    let style = style(self.engaged(brake));
                    let Point { x, y } = node.at;
                    let plate = x - BRAKE_MM - 6.0 * count as f64;
                    self.scene.add_styled(layer, style, Shape::line([x - SIGN_MM, y], [plate, y]));
                    self.scene.add_styled(layer, style, Shape::line([plate, y - 2.0], [plate, y + 2.0]));
                    for i in 0..4 {
                        let y = y - 1.4 + 1.1 * f64::from(i);
                        let stroke = Shape::line([plate, y], [plate - 1.2, y - 0.9]);
                        self.scene.add_styled(layer, Style::line(0.18), stroke);
                    }
                    names.push((self.gearbox.shift_elements()[brake].id().to_owned(), Point::new(plate, y)));
                }
            }
        }
        for (place, tie) in self.ties.clone().into_iter().enumerate() {
            let (Some(clutch), [Some(one), Some(other)]) = (tie.clutch, tie.ends.map(|end| self.node(end)))
            else {
                continue;
            };
            let style = style(self.engaged(clutch));
            // Around the lever, or from lever to lever.
            let middle = if tie.ends[0].0 == tie.ends[1].0 {
                let before = self.ties[..place].iter().filter(|before| {
                    before.clutch.is_some() && before.ends.iter().all(|end| end.0 == tie.ends[0].0)
                });
                let x = one.at.x - BESIDE_MM * (1 + before.count()) as f64;
                let middle = Point::new(x, f64::midpoint(one.at.y, other.at.y));
                for end in [one, other] {
                    let gap = Point::new(x, middle.y + 0.6 * (end.at.y - middle.y).signum());
                    let corner = [x, end.at.y];
                    let way = Shape::polyline([[end.at.x - SIGN_MM, end.at.y], corner, [gap.x, gap.y]]);
                    self.scene.add_styled(layer, style, way);
                    self.scene.add_styled(layer, style, Shape::line([x - 1.6, gap.y], [x + 1.6, gap.y]));
                }
                middle
            } else {
                let (dx, dy) = (other.at.x - one.at.x, other.at.y - one.at.y);
                let length = libm::hypot(dx, dy);
                let (dx, dy) = (dx / length, dy / length);
                // In the middle, unless a speed is marked there.
                let at = |part: f64| Point::new(one.at.x + part * length * dx, one.at.y + part * length * dy);
                let speeds = || self.placed.iter().flatten().filter_map(|node| node.speed);
                let is_clear = |part: &f64| {
                    let at = at(*part);
                    speeds().all(|(_, speed)| libm::hypot(speed.x - at.x, speed.y - at.y) > CLUTCH_CLEAR_MM)
                };
                let middle = at([0.5, 0.35, 0.65, 0.25, 0.75].into_iter().find(is_clear).unwrap_or(0.5));
                for (end, side) in [(one, -0.6), (other, 0.6)] {
                    let gap = Point::new(middle.x + side * dx, middle.y + side * dy);
                    self.scene.add_styled(layer, style, Shape::line(end.at, gap));
                    let plate = Shape::line(
                        [gap.x - 1.6 * dy, gap.y + 1.6 * dx],
                        [gap.x + 1.6 * dy, gap.y - 1.6 * dx],
                    );
                    self.scene.add_styled(layer, style, plate);
                }
                middle
            };
            names.push((self.gearbox.shift_elements()[clutch].id().to_owned(), middle));
        }
        names
    }

    /// Names of shift elements and links, speeds, distances between nodes.
    fn names(&mut self, held: &[(String, Point)]) {
        let mut places = Places::around(&self.scene);
        let layer = self.layers.labels;
        for item in self.scene.items().iter().filter(|item| item.layer == self.layers.shift_elements) {
            places.keep_clear(item.shape.bounds().grown(0.3));
        }
        for nodes in &self.placed {
            if let [first, .., last] = &nodes[..] {
                places.keep_clear(Shape::line(first.at, last.at).bounds().grown(0.5));
            }
        }
        for node in self.placed.iter().flatten() {
            let sign = Shape::Circle { centre: node.at, radius: SIGN_MM };
            places.keep_clear(sign.bounds());
        }
        for (words, at) in held {
            let half = 0.5 * width_of(words);
            let mut wishes = vec![Point::new(at.x - 2.2 - half, at.y)];
            wishes.extend([4.2, -4.2, 5.4, -5.4].map(|dy| Point::new(at.x, at.y + dy)));
            wishes.extend([1.0, -1.0].map(|side| Point::new(at.x + side * (2.4 + half), at.y)));
            wishes.extend([1.0, -1.0].map(|side| Point::new(at.x + side * (1.2 + half), at.y + 2.6)));
            let points = [[0.0, 2.5], [0.0, -2.5], [-2.5, 0.0], [2.5, 0.0]]
                .map(|[dx, dy]| Point::new(at.x + dx, at.y + dy));
            places.put(&mut self.scene, layer, words, &points, &wishes);
        }
        for node in self.placed.iter().flatten() {
            let Some((speed, tip)) = node.speed else { continue };
            let words = decimal(speed);
            let half = 0.5 * width_of(&words) + 1.8;
            let outward = if tip.x < node.at.x { -1.0 } else { 1.0 };
            let mut wishes = vec![];
            for dy in [0.0, 2.4, -2.6, 3.8, -4.0] {
                wishes.extend([outward, -outward].map(|side| Point::new(tip.x + side * half, tip.y + dy)));
            }
            let points = [2.4, -2.4].map(|dx| Point::new(tip.x + dx, tip.y));
            places.put(&mut self.scene, layer, &words, &points, &wishes);
        }
        for (column, nodes) in self.columns.clone().into_iter().zip(self.placed.clone()) {
            for node in &nodes {
                let words = self.name(column.lever, node.link);
                let half = 0.5 * width_of(&words) + 1.0;
                let mut wishes = vec![];
                for dy in [2.8, -3.0, 4.0, -4.2, 0.0] {
                    wishes.extend([-half, half].map(|dx| Point::new(node.at.x + dx, node.at.y + dy)));
                }
                wishes.extend([-half - 5.5, half + 5.5].map(|dx| Point::new(node.at.x + dx, node.at.y)));
                let points = [[-1.0, 1.0], [-1.0, -1.0], [1.0, 1.0], [1.0, -1.0]].map(|[dx, dy]| {
                    Point::new(node.at.x + 1.3 * SIGN_MM * dx, node.at.y + 1.3 * SIGN_MM * dy)
                });
                places.put(&mut self.scene, layer, &words, &points, &wishes);
            }
            let lever = &self.levers[column.lever];
            for pair in nodes.windows(2) {
                let find =
                    |link: LinkId| lever.nodes.iter().find(|node| node.0 == link).map_or(0.0, |node| node.1);
                let words = decimal((find(pair[0].link) - find(pair[1].link)).abs());
                let at = Point::new(pair[0].at.x, f64::midpoint(pair[0].at.y, pair[1].at.y));
                let half = 0.5 * width_of(&words) + 1.0;
                let wishes: Vec<Point> = [0.0, 2.0, -2.0, 4.0, -4.0]
                    .into_iter()
                    .flat_map(|dy| [-half, half].map(|dx| Point::new(at.x + dx, at.y + dy)))
                    .collect();
                places.put(&mut self.scene, layer, &words, &[at], &wishes);
            }
        }
    }

    /// A sample of every sign that occurs, and of the lines, in rows of about a width; returns the foot of
    /// the last row.
    fn explain_signs(&mut self, at: Point, width_mm: f64) -> f64 {
        let used =
            |role: &Role| self.placed.iter().flatten().any(|node| self.roles[node.link.index()] == *role);
        let roles: Vec<Role> = Role::ALL.into_iter().filter(used).collect();
        let (mut x, mut y) = (at.x, at.y);
        let mut room = |words: &str, sample: f64| {
            let needed = sample + 2.0 + width_of(words);
            if x > at.x && x + needed > at.x + width_mm {
                (x, y) = (at.x, y - 5.2);
            }
            let here = Point::new(x, y);
            x += needed + 6.0;
            here
        };
        let labels = self.layers.labels;
        let write = |scene: &mut Scene, at: Point, sample: f64, words: &str| {
            scene.add(labels, Text::new([at.x + sample + 2.0, at.y], LETTERS_MM, words).align(Align::Left));
        };
        for role in roles {
            let here = room(role.words(), 2.0 * SIGN_MM);
            signs::draw(&mut self.scene, self.layers.levers, Point::new(here.x + SIGN_MM, here.y), role);
            write(&mut self.scene, here, 2.0 * SIGN_MM, role.words());
        }
        let lines = [
            (
                self.ties.iter().any(|tie| tie.clutch.is_none()),
                self.layers.joints,
                Style::line(0.25),
                "one link",
            ),
            (self.gear.is_some(), self.layers.speeds, Style::line(0.5).color(COLORS[0]), "speeds"),
            (
                self.gear.is_some_and(|gear| !gear.gear().engaged().is_empty()),
                self.layers.shift_elements,
                Style::line(0.6).color(ENGAGED),
                "engaged",
            ),
        ];
        for (_, layer, style, words) in lines.into_iter().filter(|line| line.0) {
            let here = room(words, 6.0);
            self.scene.add_styled(layer, style, Shape::line(here, [here.x + 6.0, here.y]));
            write(&mut self.scene, here, 6.0, words);
        }
        y - 5.2
    }

    fn legend(&mut self) {
        let bounds = self.scene.bounds();
        let layer = self.layers.labels;
        let left = bounds.left;
        let heading = Text::new([left, bounds.top + 6.0], TITLE_MM, self.scene.title()).align(Align::Left);
        let width_mm = bounds.width().max(LEGEND_MM).max(heading.width_mm());
        self.scene.add(layer, heading);
        let mut y = self.explain_signs(Point::new(left, bounds.bottom - 6.0), width_mm) - 1.0;
        let sets: Vec<String> =
            (0..self.gearbox.drawn_sets().len()).map(|place| words::set(self.gearbox, place, true)).collect();
        // Side by side, as many as there is room for.
        let column = sets.iter().map(|words| width_of(words)).fold(0.0, f64::max) + 8.0;
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a few
        let across = (width_mm / column).floor().clamp(1.0, 4.0) as usize;
        for row in sets.chunks(across) {
            for (place, words) in row.iter().enumerate() {
                let at = [left + column * place as f64, y];
                self.scene.add(layer, Text::new(at, LETTERS_MM, words.as_str()).align(Align::Left));
            }
            y -= 4.6;
        }
        y -= 1.0;
        let mut caption = String::from(
            "Each upright bar is a lever: a planet set, or sets that share two links. Its points are links; the number between \
             two of them is their distance, in units of that from the carrier to the ring (second gear) of the lever's first set.",
        );
        if self.gear.is_some() {
            caption += " How far the line of speeds is from the lever, forward to the right, is the speed of each link over the \
                        input's: on each lever a straight line.";
        }
        for line in words::wrapped(&caption, width_mm) {
            self.scene.add(layer, Text::new([left, y], LETTERS_MM, line).align(Align::Left));
            y -= 4.6;
        }
    }
}

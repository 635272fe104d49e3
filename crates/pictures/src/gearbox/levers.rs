//! Sets as levers (nomogram): the links of a set stand along a line so that their speeds lie on a straight line across it.
//!
//! From the set's equation `ω_1 − i₀·ω_2 − (1 − i₀)·ω_H = 0` the carrier stands at 0, central gear 2 at −1 and central gear 1 at `−i₀`: of a simple
//! set the ring one unit on one side of the carrier, the sun `k` units on the other. Two sets with two links in common are one lever,
//! its second set scaled to fit. A link in several levers is joined by a dashed line.
//!
//! In a gear the speeds, over the input's, are offsets from the lever; the points of each lever lie on one line.

mod merge;

use super::place::Places;
use super::scheme::{known, piece_of, title};
use super::words::{self, decimal};
use super::{COLORS, ENGAGED, Error, LETTERS_MM, RESTING, TITLE_MM};
use crate::tolerance::{LEAST_SPEED, RESTS};
use epicyclic_drawing::{Align, Color, Dash, LayerId, Point, Scene, Shape, Style, Text};
use epicyclic_train::{Analysis, Gearbox, LinkId};

pub use merge::{Lever, levers};

/// Length of a lever.
const LENGTH_MM: f64 = 75.0;
/// Room of the fastest link on its side.
const FASTEST_MM: f64 = 32.0;

/// A node on paper.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Node {
    link: LinkId,
    at: Point,
    /// Its speed over the input's, and the point that stands for it.
    speed: Option<(f64, Point)>,
}

/// The levers of a gearbox, and the speeds of a gear on them.
///
/// # Errors
/// [`Error::SpeedsUnknown`] for a gear in which the speed of a link does not follow.
pub fn scene(gearbox: &Gearbox, gear: Option<&Analysis>, heading: Option<&str>) -> Result<Scene, Error> {
    let mut sheet = drawn(gearbox, gear, heading)?;
    sheet.legend();
    sheet.scene.check()?;
    Ok(sheet.scene)
}

/// The same without title and explanations, for a page that says them itself.
///
/// # Errors
/// Those of [`scene`].
pub fn bare(gearbox: &Gearbox, gear: Option<&Analysis>) -> Result<Scene, Error> {
    let sheet = drawn(gearbox, gear, None)?;
    sheet.scene.check()?;
    Ok(sheet.scene)
}

/// All but the legend.
fn drawn<'a>(
    gearbox: &'a Gearbox,
    gear: Option<&'a Analysis<'a>>,
    heading: Option<&str>,
) -> Result<Sheet<'a>, Error> {
    if let Some(gear) = gear {
        known(gearbox, gear)?;
    }
    let mut scene = Scene::new(heading.map_or_else(|| title(gearbox, gear), str::to_owned));
    let layers = Layers {
        joints: scene.layer("joints", Style::line(0.25).color(Color::GREY).dash(Dash::Dashed))?,
        levers: scene.layer("levers", Style::line(0.7))?,
        speeds: scene.layer("speeds", Style::line(0.25).color(COLORS[0]))?,
        shift_elements: scene.layer("shift elements", Style::line(0.35))?,
        labels: scene.layer("labels", Style::line(0.1))?,
    };
    let levers = levers(gearbox);
    let placed = on_paper(&levers, gear);
    let mut sheet = Sheet { gearbox, gear, levers, placed, scene, layers };
    sheet.joints();
    sheet.levers();
    let held = sheet.shift_elements();
    sheet.names(&held);
    Ok(sheet)
}

/// Nodes on paper from the lower end up: levers side by side, each turned and shifted so that the first node in common with one before
/// stands at the same height.
fn on_paper(levers: &[Lever], gear: Option<&Analysis>) -> Vec<Vec<Node>> {
    let speed = |link: LinkId| gear.and_then(|gear| gear.speed(link));
    let all: Vec<f64> =
        levers.iter().flat_map(|lever| &lever.nodes).filter_map(|node| speed(node.0)).collect();
    let fastest = all.iter().copied().map(f64::abs).fold(LEAST_SPEED, f64::max);
    let backward = FASTEST_MM * all.iter().copied().map(|speed| -speed).fold(0.0, f64::max) / fastest;
    let pitch = if gear.is_some() { backward + FASTEST_MM + 46.0 } else { 64.0 };

    let mut placed: Vec<Vec<Node>> = vec![];
    for (place, lever) in levers.iter().enumerate() {
        let x = pitch * place as f64;
        let (low, high) = lever.ends();
        let up = |upside_down: bool| {
            let part = move |at: f64| LENGTH_MM * (at - low) / (high - low);
            let turn = move |y: f64| if upside_down { LENGTH_MM - y } else { y };
            lever.nodes.iter().map(move |&(link, at)| (link, turn(part(at))))
        };
        let before = |link: LinkId| {
            let mut nodes = placed.iter().rev().flatten();
            nodes.find(|node| node.link == link && link != LinkId::GROUND).map(|node| node.at.y)
        };
        let shift = |turned: bool| up(turned).find_map(|(link, y)| Some(before(link)? - y)).unwrap_or(0.0);
        // How far other nodes in common are from their heights, and the lever from the others.
        let miss = |turned: bool| {
            let shift = shift(turned);
            let others = up(turned).filter_map(|(link, y)| Some((before(link)? - y - shift).abs()));
            others.sum::<f64>() + 0.5 * shift.abs()
        };
        let turned = miss(true) < miss(false);
        let shift = shift(turned);
        let node = |(link, y): (LinkId, f64)| {
            let at = Point::new(x, y + shift);
            let tip = |speed: f64| Point::new(x + FASTEST_MM * speed / fastest, at.y);
            Node { link, at, speed: speed(link).map(|speed| (speed, tip(speed))) }
        };
        let mut nodes: Vec<Node> = up(turned).map(node).collect();
        nodes.sort_by(|a, b| a.at.y.total_cmp(&b.at.y));
        placed.push(nodes);
    }
    placed
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
    placed: Vec<Vec<Node>>,
    scene: Scene,
    layers: Layers,
}

impl Sheet<'_> {
    /// Lines between the nodes of one link on several levers.
    fn joints(&mut self) {
        let mut last: Vec<Node> = vec![];
        for node in self.placed.iter().flatten().filter(|node| node.link != LinkId::GROUND) {
            match last.iter_mut().find(|other| other.link == node.link) {
                Some(before) => {
                    self.scene.add(self.layers.joints, Shape::line(before.at, node.at));
                    *before = *node;
                }
                None => last.push(*node),
            }
        }
    }

    /// The levers, and across each the line of its speeds.
    fn levers(&mut self) {
        for nodes in &self.placed {
            let (Some(first), Some(last)) = (nodes.first(), nodes.last()) else { continue };
            self.scene.add(self.layers.levers, Shape::line(first.at, last.at));
            if let (Some((_, from)), Some((_, to))) = (first.speed, last.speed) {
                let style = Style::line(0.5).color(COLORS[0]);
                self.scene.add_styled(self.layers.speeds, style, Shape::line(from, to));
            }
            for node in nodes {
                let rests =
                    node.link == LinkId::GROUND || node.speed.is_some_and(|(speed, _)| speed.abs() < RESTS);
                let style = Style::line(0.5).fill(if rests { RESTING } else { Color::WHITE });
                self.scene.add_styled(
                    self.layers.levers,
                    style,
                    Shape::Circle { centre: node.at, radius: 1.4 },
                );
                let Some((_, tip)) = node.speed else { continue };
                if (tip.x - node.at.x).abs() > 1.4 {
                    let edge = Point::new(node.at.x + 1.4 * (tip.x - node.at.x).signum(), tip.y);
                    self.scene.add(self.layers.speeds, Shape::line(edge, tip));
                    let dot = Shape::Circle { centre: tip, radius: 0.9 };
                    self.scene.add_styled(self.layers.speeds, Style::filled(COLORS[0]), dot);
                }
            }
        }
    }

    /// Brakes as plates beside their link, engaged clutches as coloured lines; returns names of shift elements and where they belong.
    fn shift_elements(&mut self) -> Vec<(String, Point)> {
        let node = |link: LinkId| {
            let piece = piece_of(self.gearbox, link);
            self.placed.iter().flatten().find(|node| node.link == piece).map(|node| node.at)
        };
        let mut names = vec![];
        let mut braked: Vec<LinkId> = vec![];
        for (place, shift_element) in self.gearbox.shift_elements().iter().enumerate() {
            let engaged = self.gear.is_some_and(|gear| gear.gear().engaged().contains(&place));
            let style = if engaged { Style::line(0.7).color(ENGAGED) } else { Style::line(0.35) };
            let [one, other] = shift_element.links();
            let mut add =
                |style: Style, shape: Shape| self.scene.add_styled(self.layers.shift_elements, style, shape);
            if shift_element.is_brake() {
                let Some(at) = node(one) else { continue };
                // Several brakes of one link, one behind the other.
                let x = at.x - 5.0 - 6.0 * braked.iter().filter(|link| **link == one).count() as f64;
                braked.push(one);
                add(style, Shape::line([at.x - 1.4, at.y], [x, at.y]));
                add(style, Shape::line([x, at.y - 2.0], [x, at.y + 2.0]));
                for i in 0..4 {
                    let y = at.y - 1.4 + 1.1 * f64::from(i);
                    add(Style::line(0.18), Shape::line([x, y], [x - 1.2, y - 0.9]));
                }
                names.push((shift_element.id().to_owned(), Point::new(x, at.y)));
            } else if engaged && let (Some(from), Some(to)) = (node(one), node(other)) {
                let middle = f64::midpoint(from.y, to.y);
                let style = style.width(0.5).dash(Dash::Dashed);
                // Around the lever, or from lever to lever.
                let x = from.x.min(to.x) - 8.0;
                if from.x == to.x {
                    let corners = [[from.x - 1.4, from.y], [x, from.y], [x, to.y], [to.x - 1.4, to.y]];
                    add(style, Shape::polyline(corners));
                    names.push((shift_element.id().to_owned(), Point::new(x, middle)));
                } else {
                    add(style, Shape::line(from, to));
                    names.push((
                        shift_element.id().to_owned(),
                        Point::new(f64::midpoint(from.x, to.x), middle),
                    ));
                }
            }
        }
        names
    }

    /// Names of shift elements and links, speeds, distances between nodes.
    fn names(&mut self, held: &[(String, Point)]) {
        let mut places = Places::around(&self.scene);
        let half = |words: &str| 0.5 * Text::new([0.0, 0.0], LETTERS_MM, words).width_mm();
        let layer = self.layers.labels;
        for (words, at) in held {
            let half = half(words);
            let mut wishes = vec![Point::new(at.x - 2.2 - half, at.y)];
            wishes.extend([4.2, -4.2, 5.4, -5.4].map(|dy| Point::new(at.x, at.y + dy)));
            wishes.extend([1.0, -1.0].map(|side| Point::new(at.x + side * (1.2 + half), at.y + 2.6)));
            places.put(&mut self.scene, layer, words, *at, &wishes);
        }
        for node in self.placed.iter().flatten() {
            let Some((speed, tip)) = node.speed else { continue };
            let words = decimal(speed);
            let half = half(&words) + 1.8;
            let outward = if tip.x < node.at.x { -1.0 } else { 1.0 };
            let mut wishes = vec![];
            for dy in [0.0, 2.4, -2.6, 3.8, -4.0] {
                wishes.extend([outward, -outward].map(|side| Point::new(tip.x + side * half, tip.y + dy)));
            }
            places.put(&mut self.scene, layer, &words, tip, &wishes);
        }
        for (lever, nodes) in self.levers.iter().zip(&self.placed) {
            for node in nodes {
                let words = format!(
                    "{} ({})",
                    self.gearbox.link_name(node.link),
                    lever.members(self.gearbox, node.link)
                );
                let half = half(&words) + 1.0;
                let mut wishes = vec![];
                for dy in [2.8, -3.0, 4.0, -4.2, 0.0] {
                    wishes.extend([-half, half].map(|dx| Point::new(node.at.x + dx, node.at.y + dy)));
                }
                wishes.extend([-half - 5.5, half + 5.5].map(|dx| Point::new(node.at.x + dx, node.at.y)));
                places.put(&mut self.scene, layer, &words, node.at, &wishes);
            }
            for pair in nodes.windows(2) {
                let find =
                    |link: LinkId| lever.nodes.iter().find(|node| node.0 == link).map_or(0.0, |node| node.1);
                let words = decimal((find(pair[0].link) - find(pair[1].link)).abs());
                let at = Point::new(pair[0].at.x, f64::midpoint(pair[0].at.y, pair[1].at.y));
                let half = half(&words) + 1.0;
                let wishes: Vec<Point> = [0.0, 2.0, -2.0, 4.0, -4.0]
                    .into_iter()
                    .flat_map(|dy| [-half, half].map(|dx| Point::new(at.x + dx, at.y + dy)))
                    .collect();
                places.put(&mut self.scene, layer, &words, at, &wishes);
            }
        }
    }

    fn legend(&mut self) {
        let bounds = self.scene.bounds();
        let layer = self.layers.labels;
        let left = bounds.left;
        let heading = Text::new([left, bounds.top + 6.0], TITLE_MM, self.scene.title()).align(Align::Left);
        self.scene.add(layer, heading);
        let mut lines: Vec<String> =
            (0..self.gearbox.drawn_sets().len()).map(|place| words::set(self.gearbox, place, true)).collect();
        // In short lines, so that the legend is no wider than most diagrams in a wide font, too.
        let scale = [
            "along a lever: distances between",
            "links; 1 is from the carrier to the second",
            "central gear of its first set",
        ];
        lines.extend(scale.map(String::from));
        if let Some(gear) = self.gear {
            lines.push("across it: speeds over the input's".into());
            let shift_elements =
                gear.gear().engaged().iter().map(|&place| self.gearbox.shift_elements()[place].id());
            let engaged: Vec<&str> = shift_elements.collect();
            if !engaged.is_empty() {
                lines.push(format!("engaged: {}", engaged.join(", ")));
            }
        }
        for (place, words) in lines.into_iter().enumerate() {
            let y = bounds.bottom - 6.0 - 4.6 * place as f64;
            self.scene.add(layer, Text::new([left, y], LETTERS_MM, words).align(Align::Left));
        }
    }
}

//! The speed diagram of a gear (Kutzbach): peripheral velocity over radius for each set, and the rays of
//! angular speed.
//!
//! A point of a link at radius `r` moves at `v = ω·r`. Drawn over `r`, a link is a line through the axis with
//! the slope `ω`. A planet is a line through its three points: the contacts with central gears 1 and 2, and
//! the planet pin. Rays parallel to these lines from a pole cut a line at the speeds `ω`.
//!
//! Radii are in units of each set's central gear 1. In a simple set `r_b = k`, and the planet pins are at
//! `(1 + k)/2`. All sets have one slope for one speed. Each of two planets in mesh is drawn in the section
//! through its own pin, from its contact with a central gear to its far side.
//!
//! Sizes of planets follow from teeth. If these are not given, sizes that fit are assumed, and the planet's
//! name gets a star. The assumption changes the planet's own speed but none of the links'. Planets of bevel
//! sets turn about other axes and have no line.

mod lines;

use super::place::{Places, spread};
use super::scheme::{known, title};
use super::words::{self, decimal, width_of, wrapped};
use super::{COLORS, Error, LETTERS_MM, TITLE_MM};
use crate::tolerance::{LEAST_SPEED, ONE_RAY};
use epicyclic_drawing::text::overlaps;
use epicyclic_drawing::{Align, Bounds, Color, Dash, LayerId, Point, Scene, Shape, Style, Text};
use epicyclic_train::{Analysis, Gearbox};
use lines::{Line, SpeedDiagram};
use std::f64::consts::FRAC_PI_2;

/// Sizes of the diagrams.
#[derive(Debug, Clone, Copy)]
struct Size {
    /// Height of each set's diagram.
    height_mm: f64,
    /// Width of the fastest point on its side.
    fastest_mm: f64,
    /// Greatest width of the rays on one side, and their greatest height.
    rays_mm: [f64; 2],
    /// Length of a label of the speeds, beyond which it goes on in a further line.
    label_mm: f64,
    /// Distances from the names of the levels to the gears, from there to the axis of velocities at least,
    /// and beyond the fastest.
    gaps_mm: [f64; 3],
    /// Distance from one diagram of a row to the next.
    apart_mm: f64,
    /// Distance beside the rays.
    beside_rays_mm: f64,
    /// Width of a row of diagrams. The rays are in the last row if they have room there.
    row_mm: f64,
    /// Whether the page explains the diagrams.
    is_bare: bool,
}

/// A drawing of its own.
const USUAL: Size = Size {
    height_mm: 70.0,
    fastest_mm: 45.0,
    rays_mm: [75.0, 45.0],
    label_mm: 40.0,
    gaps_mm: [10.0, 9.0, 5.0],
    apart_mm: 10.0,
    beside_rays_mm: 6.0,
    row_mm: 310.0,
    is_bare: false,
};
/// Parts of a page, from the smallest.
const SMALL: [Size; 3] = [
    Size {
        height_mm: 26.0,
        fastest_mm: 12.0,
        rays_mm: [20.0, 12.0],
        label_mm: 34.0,
        gaps_mm: [7.0, 6.0, 3.0],
        apart_mm: 3.0,
        beside_rays_mm: 4.5,
        row_mm: f64::INFINITY,
        is_bare: true,
    },
    Size {
        height_mm: 32.0,
        fastest_mm: 15.0,
        rays_mm: [20.0, 16.0],
        label_mm: 34.0,
        gaps_mm: [8.0, 7.0, 4.0],
        apart_mm: 4.0,
        beside_rays_mm: 4.5,
        row_mm: f64::INFINITY,
        is_bare: true,
    },
    Size {
        height_mm: 38.0,
        fastest_mm: 18.0,
        rays_mm: [22.0, 20.0],
        label_mm: 34.0,
        gaps_mm: [10.0, 9.0, 5.0],
        apart_mm: 7.0,
        beside_rays_mm: 6.0,
        row_mm: f64::INFINITY,
        is_bare: true,
    },
];
/// Distance from the lowest part of a row to the highest part of the next.
const ROWS_APART_MM: f64 = 9.0;
/// The explanations have lines of at least this length.
const LEAST_WORDS_MM: f64 = 100.0;
/// Distance from a section with gears to the next.
const SECTIONS_MM: f64 = 5.5;
/// Distance from label to label of the speeds.
const PITCH_MM: f64 = 4.2;

/// The speed diagram of a gear.
///
/// # Errors
/// [`Error::SpeedsUnknown`] for a gear in which the speed of a link does not follow.
pub fn scene(gearbox: &Gearbox, gear: &Analysis, heading: Option<&str>) -> Result<Scene, Error> {
    let (mut scene, layers) = drawn(gearbox, gear, heading, USUAL)?;
    let bounds = scene.bounds();
    let at = [bounds.left, bounds.top + 7.0];
    let heading = Text::new(at, TITLE_MM, scene.title()).align(Align::Left);
    scene.add(layers.labels, heading);
    scene.check()?;
    Ok(scene)
}

/// Speed diagrams for a page: as small as the labels allow, without title and explanations, in rows of about
/// this width.
///
/// # Errors
/// Those of [`scene`].
pub fn narrow(gearbox: &Gearbox, gear: &Analysis, width_mm: f64) -> Result<Scene, Error> {
    let [small, larger, largest] = SMALL.map(|size| Size { row_mm: width_mm, ..size });
    for size in [small, larger] {
        let (scene, _) = drawn(gearbox, gear, None, size)?;
        if overlaps(&scene).is_empty() {
            scene.check()?;
            return Ok(scene);
        }
    }
    let (scene, _) = drawn(gearbox, gear, None, largest)?;
    scene.check()?;
    Ok(scene)
}

fn drawn(
    gearbox: &Gearbox,
    gear: &Analysis,
    heading: Option<&str>,
    size: Size,
) -> Result<(Scene, Layers), Error> {
    known(gearbox, gear)?;
    let mut scene = Scene::new(heading.map_or_else(|| title(gearbox, Some(gear)), str::to_owned));
    let layers = Layers {
        axes: scene.layer("axes", Style::line(0.25))?,
        help: scene.layer("levels", Style::line(0.1).color(Color::GREY).dash(Dash::Dashed))?,
        toothed_gears: scene.layer("gears", Style::line(0.7))?,
        lines: scene.layer("lines", Style::line(0.5))?,
        labels: scene.layer("labels", Style::line(0.1))?,
    };
    let diagrams: Vec<SpeedDiagram> =
        (0..gearbox.drawn_sets().len()).map(|set| SpeedDiagram::of(gearbox, gear, set)).collect();
    // Millimetres across to one up, for a speed of 1.
    let widest = diagrams.iter().map(SpeedDiagram::widest).fold(LEAST_SPEED, f64::max);
    let slope = size.fastest_mm / (size.height_mm * widest);
    let ends_at = size.row_mm;
    let mut corner = Point::new(0.0, 0.0);
    for (set, diagram) in diagrams.iter().enumerate() {
        let paper = Paper { layers: &layers, gearbox, size, slope };
        let mut trial = scene.clone();
        let next = paper.panel(&mut trial, diagram, set, corner);
        if next - size.apart_mm > ends_at && corner.x > 0.0 {
            corner = Point::new(0.0, scene.bounds().bottom - ROWS_APART_MM - size.height_mm);
            corner.x = paper.panel(&mut scene, diagram, set, corner);
        } else {
            scene = trial;
            corner.x = next;
        }
    }
    let rays = Rays::of(gearbox, gear, &diagrams, slope, size);
    let bounds = scene.bounds();
    let below = Point::new(bounds.left, bounds.bottom - ROWS_APART_MM);
    let is_beside = corner.x + rays.width() <= ends_at;
    let at = if is_beside { Point::new(corner.x, corner.y + size.height_mm + 5.0) } else { below };
    let ends = rays.draw(&mut scene, &layers, at);
    if !size.is_bare {
        // Beside the rays where there is room, else below all.
        let room = bounds.right - ends.right - size.apart_mm;
        let drawn = scene.bounds();
        let (at, width_mm) = if room < LEAST_WORDS_MM {
            (Point::new(drawn.left, drawn.bottom - 6.0), drawn.width().max(LEAST_WORDS_MM))
        } else {
            (Point::new(ends.right + size.apart_mm, ends.top - 6.0), room)
        };
        explain(&mut scene, &layers, at, width_mm, &diagrams);
    }
    Ok((scene, layers))
}

struct Layers {
    axes: LayerId,
    help: LayerId,
    toothed_gears: LayerId,
    lines: LayerId,
    labels: LayerId,
}

/// Style of a line: links by their number, planets dashed.
fn style(line: &Line) -> Style {
    match line.link {
        Some(link) => Style::line(0.5).color(COLORS[(link.index() + COLORS.len() - 1) % COLORS.len()]),
        None => Style::line(0.35).dash(Dash::Dashed),
    }
}

/// Data that all diagrams of a drawing share.
struct Paper<'a> {
    layers: &'a Layers,
    gearbox: &'a Gearbox,
    size: Size,
    slope: f64,
}

impl Paper<'_> {
    /// Draws one set: its gears on the left, velocities over radius on the right. Returns where the next may
    /// begin.
    fn panel(&self, scene: &mut Scene, diagram: &SpeedDiagram, set: usize, corner: Point) -> f64 {
        let Self { layers, gearbox, size, slope } = *self;
        let Point { x: left, y: base } = corner;
        let up = size.height_mm / diagram.height;
        let across = |speed_radius: f64| slope * up * speed_radius;
        let lines = || diagram.lines.iter().flat_map(|line| [line.from, line.to]);
        let back = lines().map(|[_, v]| across(-v)).fold(0.0, f64::max);
        let ahead = lines().map(|[_, v]| across(v)).fold(0.0, f64::max);
        // Levels with their names, gears, and then the axis of velocities.
        let names = diagram.levels.iter().map(|(name, r)| format!("{name} {}", decimal(*r)));
        let names: Vec<String> = names.collect();
        let width =
            names.iter().map(|name| Text::new([0.0, 0.0], LETTERS_MM, name).width_mm()).fold(0.0, f64::max);
        let [names_mm, axis_mm, beyond_mm] = size.gaps_mm;
        let gears_at = left + width + names_mm;
        let sections = diagram.toothed_gears.iter().map(|gear| gear.0).max().unwrap_or(0);
        let zero = gears_at + axis_mm + SECTIONS_MM * sections as f64 + back;
        let far = zero + ahead + beyond_mm;

        scene.add(layers.axes, Shape::line([gears_at - 5.0, base], [far, base]));
        scene.add(layers.axes, Shape::line([zero, base], [zero, base + size.height_mm + 5.0]));
        let mut levels: Vec<(f64, &String)> =
            diagram.levels.iter().map(|level| base + up * level.1).zip(&names).collect();
        levels.sort_by(|a, b| a.0.total_cmp(&b.0));
        let wanted: Vec<f64> = levels.iter().map(|level| level.0).collect();
        for ((y, name), place) in levels.iter().zip(spread(&wanted, 4.4)) {
            scene.add(layers.help, Shape::line([gears_at - 4.0, *y], [far, *y]));
            scene.add(layers.help, Shape::line([left + width + 1.0, place], [gears_at - 4.0, *y]));
            scene.add(layers.labels, Text::new([left + width, place], LETTERS_MM, *name).align(Align::Right));
        }
        for (section, [from, to]) in &diagram.toothed_gears {
            let gears_at = gears_at + SECTIONS_MM * *section as f64;
            let (from, to) = (base + up * from, base + up * to);
            scene.add(layers.toothed_gears, Shape::line([gears_at, from + 0.5], [gears_at, to - 0.5]));
            for y in [from + 0.5, to - 0.5] {
                scene.add(layers.toothed_gears, Shape::line([gears_at - 2.0, y], [gears_at + 2.0, y]));
            }
        }
        for (section, planet_pin) in &diagram.planet_pins {
            let gears_at = gears_at + SECTIONS_MM * *section as f64;
            let y = base + up * planet_pin;
            scene.add(layers.toothed_gears, Shape::line([gears_at - 2.0, y], [gears_at + 3.0, y]));
        }
        let on = |[r, v]: [f64; 2]| Point::new(zero + across(v), base + up * r);
        for line in &diagram.lines {
            scene.add_styled(layers.lines, style(line), Shape::line(on(line.from), on(line.to)));
            if line.link.is_none() {
                for end in [line.from, line.to] {
                    let dot = Shape::Circle { centre: on(end), radius: 0.7 };
                    scene.add_styled(layers.lines, Style::filled(Color::BLACK), dot);
                }
            }
        }
        let mut places = Places::around(scene);
        for line in &diagram.lines {
            let (from, to) = (on(line.from), on(line.to));
            let half = 0.5 * Text::new(to, LETTERS_MM, &*line.name).width_mm() + 1.2;
            let mut wishes = vec![];
            for part in [0.5, 0.6, 0.4, 0.75, 0.3, 0.9] {
                let at = Point::new(from.x + part * (to.x - from.x), from.y + part * (to.y - from.y));
                wishes.extend(
                    [[half, -1.5], [-half, 1.5], [half, 1.5], [-half, -1.5]]
                        .map(|[dx, dy]| Point::new(at.x + dx, at.y + dy)),
                );
            }
            let middle = Point::new(f64::midpoint(from.x, to.x), f64::midpoint(from.y, to.y));
            places.put(scene, layers.labels, &line.name, &[middle], &wishes);
        }
        let caption =
            if size.is_bare { words::set_name(gearbox, set) } else { words::set(gearbox, set, true) };
        let caption = Text::new([left, base - 6.0], LETTERS_MM, caption).align(Align::Left);
        let next = far.max(caption.bounds().right) + size.apart_mm;
        scene.add(layers.labels, caption);
        next
    }
}

/// Rays from a pole, parallel to the lines of the diagrams, to the scale of speeds.
struct Rays {
    /// Speeds in ascending order, each once.
    speeds: Vec<(f64, Style)>,
    /// Lines of their labels, each with the place of its speed.
    labels: Vec<(usize, String)>,
    /// Width of the longest line.
    longest_mm: f64,
    /// Positions of the labels, from the pole.
    places: Vec<f64>,
    height_mm: f64,
    /// Millimetres to a speed of 1.
    unit_mm: f64,
    beside_mm: f64,
}

impl Rays {
    fn of(gearbox: &Gearbox, gear: &Analysis, diagrams: &[SpeedDiagram], slope: f64, size: Size) -> Self {
        // Each speed once, with all that has it.
        let mut speeds: Vec<(f64, Vec<String>, Style)> = vec![];
        let mut enter = |speed: f64, name: String, style: Style| match speeds
            .iter_mut()
            .find(|(other, ..)| (other - speed).abs() < ONE_RAY)
        {
            Some((_, names, _)) => names.push(name),
            None => speeds.push((speed, vec![name], style)),
        };
        for (link, name) in gearbox.links().iter().enumerate() {
            let line = diagrams
                .iter()
                .flat_map(|diagram| &diagram.lines)
                .find(|line| line.link.is_some_and(|id| id.index() == link));
            // Links that belong to no set have no line, and the housing is the pole's own.
            let (Some(line), Some(speed)) = (line, gear.speeds()[link]) else { continue };
            enter(speed, name.clone(), style(line));
        }
        for line in diagrams.iter().flat_map(|diagram| &diagram.lines).filter(|line| line.link.is_none()) {
            let [[r, v], [further, faster]] = [line.from, line.to];
            enter((faster - v) / (further - r), line.name.clone(), style(line));
        }
        speeds.sort_by(|a, b| a.0.total_cmp(&b.0));
        let fastest = speeds.iter().map(|speed| speed.0.abs()).fold(LEAST_SPEED, f64::max);
        let [width, height] = size.rays_mm;
        let height_mm = height.min(width / (slope * fastest));
        let unit_mm = slope * height_mm;
        let label = |(place, (speed, names, _)): (usize, &(f64, Vec<String>, Style))| {
            lines_of(&format!("{}:", decimal(*speed)), names, size.label_mm).map(move |line| (place, line))
        };
        let labels: Vec<(usize, String)> = speeds.iter().enumerate().flat_map(label).collect();
        let longest_mm = labels.iter().map(|(_, label)| width_of(label)).fold(0.0, f64::max);
        let wanted: Vec<f64> = labels.iter().map(|(speed, _)| unit_mm * speeds[*speed].0).collect();
        let places = spread(&wanted, PITCH_MM);
        let speeds = speeds.into_iter().map(|(speed, _, style)| (speed, style)).collect();
        Self { speeds, labels, longest_mm, places, height_mm, unit_mm, beside_mm: size.beside_rays_mm }
    }

    /// Ends of the scale, and beyond them of the labels, from the pole.
    fn ends(&self) -> [f64; 4] {
        let least = self.speeds.first().map_or(0.0, |speed| speed.0).min(0.0);
        let most = self.speeds.last().map_or(0.0, |speed| speed.0).max(0.0);
        let (least, most) = (self.unit_mm * least, self.unit_mm * most);
        let first = self.places.first().copied().unwrap_or(0.0).min(least);
        let last = self.places.last().copied().unwrap_or(0.0).max(most);
        [least, most, first, last]
    }

    fn width(&self) -> f64 {
        let [_, _, first, last] = self.ends();
        last - first + 2.0 * self.beside_mm
    }

    /// Draws the rays below and to the right of a corner; returns the room that they take.
    fn draw(&self, scene: &mut Scene, layers: &Layers, corner: Point) -> Bounds {
        let scale_y = corner.y - self.longest_mm - 7.0;
        let [least, most, first, _] = self.ends();
        let pole = Point::new(corner.x + self.beside_mm - first, scale_y - self.height_mm);
        let ends = [pole.x + least - 4.0, pole.x + most + 4.0];
        scene.add(layers.axes, Shape::line([ends[0], scale_y], [ends[1], scale_y]));
        let mut last = None;
        for ((speed, label), place) in self.labels.iter().zip(&self.places) {
            let foot = Point::new(pole.x + place, scale_y + 6.0);
            // Further lines of a label have no ray of their own.
            if last.replace(speed) != Some(speed) {
                let (speed, style) = self.speeds[*speed];
                let tip = Point::new(pole.x + self.unit_mm * speed, scale_y);
                scene.add_styled(layers.lines, style, Shape::line(pole, tip));
                scene.add(layers.axes, Shape::polyline([tip, Point::new(tip.x, tip.y + 1.5), foot]));
            }
            let text = Text::new([foot.x, foot.y + 1.0], LETTERS_MM, label).align(Align::Left);
            scene.add(layers.labels, text.turned(FRAC_PI_2));
        }
        let dot = Shape::Circle { centre: pole, radius: 0.9 };
        scene.add_styled(layers.lines, Style::filled(Color::BLACK), dot);
        scene.add(layers.labels, Text::new([pole.x + 4.0, pole.y - 2.6], LETTERS_MM, "pole"));
        Bounds { left: corner.x, right: corner.x + self.width(), bottom: pole.y - 5.0, top: corner.y }
    }
}

/// Names after the text `first`, in lines of about this length.
fn lines_of(first: &str, names: &[String], length_mm: f64) -> impl Iterator<Item = String> + use<> {
    let mut lines = vec![first.to_owned()];
    for (place, name) in names.iter().enumerate() {
        let comma = if place + 1 < names.len() { "," } else { "" };
        match lines.last_mut() {
            Some(line) if place == 0 || width_of(line) + width_of(name) < length_mm => {
                *line += &format!(" {name}{comma}");
            }
            _ => lines.push(format!("{name}{comma}")),
        }
    }
    lines.into_iter()
}

/// Writes the explanation of the diagrams and rays, in lines of a width below a point.
fn explain(scene: &mut Scene, layers: &Layers, at: Point, width_mm: f64, diagrams: &[SpeedDiagram]) {
    let mut words = vec![
        "Each set: the velocity of its links and planets over their distance from the axis, which is 1 at the first central gear. A link is a \
         line from the axis; a planet (dashed) is a line through the velocities of its contacts and of its pin. The more it leans to the right, the faster.",
        "Rays from the pole are parallel to these lines. Where they end stands the speed over the input's, positive in the \
         input's direction, and what turns at it.",
    ];
    if diagrams.iter().flat_map(|diagram| &diagram.lines).any(|line| line.is_assumed) {
        words.push("* The teeth of this planet are not given. Its size is assumed, and its speed is that of a planet of this size.");
    }
    if diagrams.iter().any(|diagram| diagram.lines.len() == 3) {
        words.push("Bevel planets turn about other axes and have no line.");
    }
    let lines = words.into_iter().flat_map(|words| wrapped(words, width_mm));
    for (place, line) in lines.enumerate() {
        let text = Text::new([at.x, at.y - 4.6 * place as f64], LETTERS_MM, line).align(Align::Left);
        scene.add(layers.labels, text);
    }
}

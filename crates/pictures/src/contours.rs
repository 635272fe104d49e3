//! A quantity over two others as lines of equal value.

use crate::plot::{Axis, LETTERS_MM};
use epicyclic_drawing::{Align, Bounds, Color, Error, Point, Scene, Shape, Style, Text};

/// Room around the value of a line.
const ROOM_MM: f64 = 0.7;
/// Steps of the values that lines have, the coarse first.
const STEPS: [f64; 7] = [0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001];
/// Lines with which no finer step is taken.
const ENOUGH: usize = 9;
/// The most lines.
const MOST: usize = 12;
/// Places that are tried for the value of a line.
const TRIED: u32 = 40;

/// Values over a grid, such as an efficiency over speed and torque.
///
/// ```
/// use epicyclic_pictures::contours::Contours;
///
/// let ticks: Vec<f64> = (0..=20).map(f64::from).collect();
/// let values = ticks.iter().flat_map(|x| ticks.iter().map(move |y| Some(0.8 + 0.0004 * x * y))).collect();
/// let picture = Contours {
///     title: "A map".into(), across: "x".into(), up: "y".into(), columns: ticks.clone(), rows: ticks, values
/// };
/// let image = epicyclic_drawing::svg::write(&picture.scene()?)?;
/// assert!(image.contains("0.9"));
/// # Ok::<(), epicyclic_drawing::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Contours {
    /// Title of the picture.
    pub title: String,
    /// Quantity on the horizontal axis, with its unit.
    pub across: String,
    /// Quantity on the vertical axis, with its unit.
    pub up: String,
    /// Values to the right, ascending or descending.
    pub columns: Vec<f64>,
    /// Values upwards.
    pub rows: Vec<f64>,
    /// Values of the map, column by column; `None` at points without a value.
    pub values: Vec<Option<f64>>,
}

/// Width and height of the field.
const SIZE_MM: [f64; 2] = [130.0, 90.0];

/// A line of equal value: where it is on the sheet.
type Line = Vec<[f64; 2]>;

impl Contours {
    /// Scene of the map. Each contour line carries its value; values whose label has no room are left out
    /// with their lines.
    ///
    /// # Errors
    /// Errors of [`Scene::layer`] and [`Scene::check`]; finite values cause none.
    pub fn scene(&self) -> Result<Scene, Error> {
        let mut scene = Scene::new(self.title.clone());
        let frame = scene.layer("frame", Style::line(0.25))?;
        let lines = scene.layer("lines", Style::line(0.35).color(Color::new(0, 90, 160)))?;
        let labels = scene.layer("labels", Style::line(0.1))?;
        let [width, height] = SIZE_MM;
        let across = Axis::new(self.columns.iter().copied(), width, false);
        let up = Axis::new(self.rows.iter().copied(), height, false);
        scene.add(frame, Shape::rectangle([0.0, 0.0], SIZE_MM));
        for tick in across.ticks() {
            let x = across.place(tick);
            scene.add(frame, Shape::line([x, -1.2], [x, 0.0]));
            scene.add(labels, Text::new([x, -3.9], LETTERS_MM, across.label(tick)));
        }
        let mut widest = 0.0_f64;
        for tick in up.ticks() {
            let y = up.place(tick);
            let text = Text::new([-2.2, y], LETTERS_MM, up.label(tick)).align(Align::Right);
            widest = widest.max(text.width_mm());
            scene.add(frame, Shape::line([-1.2, y], [0.0, y]));
            scene.add(labels, text);
        }
        scene.add(labels, Text::new([0.5 * width, height + 4.5], 1.2 * LETTERS_MM, self.title.clone()));
        scene.add(labels, Text::new([0.5 * width, -8.9], LETTERS_MM, self.across.clone()));
        let caption = Text::new([-widest - 6.0, 0.5 * height], LETTERS_MM, self.up.clone());
        scene.add(labels, caption.turned(std::f64::consts::FRAC_PI_2));
        for drawn in self.placed(&across, &up) {
            for line in &drawn.lines {
                for piece in outside(line, &drawn.room) {
                    scene.add(lines, Shape::polyline(piece));
                }
            }
            scene.add(labels, drawn.label);
        }
        scene.check()?;
        Ok(scene)
    }

    /// Contour lines that are drawn, each value with a label on one of its lines.
    fn placed(&self, across: &Axis, up: &Axis) -> Vec<Drawn> {
        let known = || self.values.iter().flatten().copied().filter(|value| value.is_finite());
        let (low, high) = (known().fold(f64::INFINITY, f64::min), known().fold(f64::NEG_INFINITY, f64::max));
        let mut all: Vec<Drawn> = vec![];
        let mut tried: Vec<i64> = vec![];
        for step in STEPS {
            if all.len() >= ENOUGH || low >= high || (high - low) / step > 1e3 {
                break;
            }
            #[allow(clippy::cast_possible_truncation, reason = "at most a thousand steps between them")]
            let [first, last] = [(low / step).ceil() as i64, (high / step).floor() as i64];
            // Large values lie far apart where an efficiency rises to its best.
            for number in (first..=last).rev() {
                // In units of the finest step.
                let value = number as f64 * step;
                #[allow(clippy::cast_possible_truncation, reason = "few digits")]
                let key = (value * 1e3).round() as i64;
                if all.len() >= MOST || tried.contains(&key) {
                    continue;
                }
                tried.push(key);
                all.extend(self.drawn(value, [across, up], &all));
            }
        }
        all
    }

    /// Contour lines of a value with its label, if the label has room among the earlier ones.
    fn drawn(&self, value: f64, axes: [&Axis; 2], others: &[Drawn]) -> Option<Drawn> {
        let lines = self.lines(value, axes);
        let is_hit = |other: &Drawn| lines.iter().any(|line| meets(line, &other.room));
        if others.iter().any(is_hit) {
            return None;
        }
        let mut by_length: Vec<&Line> = lines.iter().collect();
        by_length.sort_by(|one, other| length(other).total_cmp(&length(one)));
        for line in by_length {
            let whole = length(line);
            for number in 0..TRIED {
                // Order from the middle outwards.
                let step = f64::from(number.div_ceil(2)) / f64::from(TRIED);
                let part = if number % 2 == 0 { 0.5 + step } else { 0.5 - step };
                let label = Text::new(along(line, part * whole), LETTERS_MM, shown(value));
                let room = label.bounds().grown(ROOM_MM);
                let [width, height] = SIZE_MM;
                let is_inside = room.left > ROOM_MM
                    && room.bottom > ROOM_MM
                    && room.right < width - ROOM_MM
                    && room.top < height - ROOM_MM;
                let is_clear = |other: &Drawn| {
                    !other.lines.iter().any(|line| meets(line, &room)) && !overlap(&other.room, &room)
                };
                if is_inside && whole > 2.0 * (room.right - room.left) && others.iter().all(is_clear) {
                    return Some(Drawn { lines: lines.clone(), label, room });
                }
            }
        }
        None
    }

    /// The lines of a value on the sheet: straight in the triangles into which each cell of the grid falls.
    fn lines(&self, value: f64, [across, up]: [&Axis; 2]) -> Vec<Line> {
        let (columns, rows) = (self.columns.len(), self.rows.len());
        let at = |[x, y]: [usize; 2]| self.values.get(x * rows + y).copied().flatten();
        // Crossings of the line with three edges of each corner: to the right, upwards and diagonal. The
        // second list holds the neighbouring crossings.
        let mut places = vec![[0.0; 2]; 3 * columns * rows];
        let mut beside: Vec<[Option<usize>; 2]> = vec![[None; 2]; places.len()];
        let mut order = vec![];
        let edge =
            |way: usize, [x, y]: [usize; 2], end: [usize; 2]| (3 * (x * rows + y) + way, [[x, y], end]);
        for x in 1..columns {
            for y in 1..rows {
                let [a, b, c, d] = [[x - 1, y - 1], [x, y - 1], [x, y], [x - 1, y]];
                let diagonal = edge(2, a, c);
                for (corners, edges) in [
                    ([a, b, c], [edge(0, a, b), edge(1, b, c), diagonal]),
                    ([a, c, d], [diagonal, edge(0, d, c), edge(1, a, d)]),
                ] {
                    let [Some(_), Some(_), Some(_)] = corners.map(at) else { continue };
                    let mut ends = vec![];
                    for (number, corners) in edges {
                        let [low, high] = corners.map(|corner| at(corner).unwrap_or(f64::NAN));
                        if (low < value) != (high < value) {
                            let part = (value - low) / (high - low);
                            let place = |axis: &Axis, ticks: &[f64], way: usize| {
                                let [from, to] = corners.map(|corner| axis.place(ticks[corner[way]]));
                                from + (to - from) * part
                            };
                            places[number] = [place(across, &self.columns, 0), place(up, &self.rows, 1)];
                            ends.push(number);
                        }
                    }
                    if let [one, other] = ends[..] {
                        for (from, to) in [(one, other), (other, one)] {
                            match &mut beside[from] {
                                [first @ None, _] => {
                                    order.push(from);
                                    *first = Some(to);
                                }
                                [_, second] => *second = Some(to),
                            }
                        }
                    }
                }
            }
        }
        // Open lines from their ends, then closed ones from anywhere.
        let is_end = |edge: &&usize| beside[**edge][1].is_none();
        let mut is_done = vec![false; places.len()];
        let mut all = vec![];
        for &start in order.iter().filter(is_end).chain(&order) {
            if is_done[start] {
                continue;
            }
            let mut line = vec![places[start]];
            let mut last = start;
            is_done[last] = true;
            while let Some(&edge) = beside[last].iter().flatten().find(|edge| !is_done[**edge]) {
                last = edge;
                is_done[last] = true;
                line.push(places[last]);
            }
            if beside[last].contains(&Some(start)) && line.len() > 2 {
                line.push(places[start]);
            }
            all.push(line);
        }
        all
    }
}

/// A value that is shown.
struct Drawn {
    lines: Vec<Line>,
    label: Text,
    /// The room of its label, in which no line is drawn.
    room: Bounds,
}

/// Writes a value with as many decimals as its steps have.
fn shown(value: f64) -> String {
    let text = format!("{value:.3}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short.contains('.') { short.to_owned() } else { format!("{value:.1}") }
}

fn length(line: &[[f64; 2]]) -> f64 {
    line.windows(2).map(|ends| libm::hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1])).sum()
}

/// The place on a line so far from its start.
fn along(line: &[[f64; 2]], distance: f64) -> Point {
    let mut left = distance;
    for ends in line.windows(2) {
        let whole = length(ends);
        if whole > 0.0 && left <= whole {
            let part = left / whole;
            let at = |way: usize| ends[0][way] + (ends[1][way] - ends[0][way]) * part;
            return Point::new(at(0), at(1));
        }
        left -= whole;
    }
    line.last().copied().unwrap_or_default().into()
}

/// The part of a straight piece within a box, from and to over its length.
fn within(ends: &[[f64; 2]], room: &Bounds) -> Option<[f64; 2]> {
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for (way, low, high) in [(0, room.left, room.right), (1, room.bottom, room.top)] {
        let (start, run) = (ends[0][way], ends[1][way] - ends[0][way]);
        if run == 0.0 {
            if start < low || start > high {
                return None;
            }
            continue;
        }
        let [one, other] = [(low - start) / run, (high - start) / run];
        (from, to) = (from.max(one.min(other)), to.min(one.max(other)));
    }
    (from < to).then_some([from, to])
}

fn meets(line: &[[f64; 2]], room: &Bounds) -> bool {
    line.windows(2).any(|ends| within(ends, room).is_some())
}

fn overlap(one: &Bounds, other: &Bounds) -> bool {
    one.left < other.right && other.left < one.right && one.bottom < other.top && other.bottom < one.top
}

/// The pieces of a line outside a box.
fn outside(line: &[[f64; 2]], room: &Bounds) -> Vec<Line> {
    let mut pieces: Vec<Line> = vec![vec![]];
    for ends in line.windows(2) {
        let at = |part: f64| [0, 1].map(|way| ends[0][way] + (ends[1][way] - ends[0][way]) * part);
        let mut add = |from: f64, to: f64| {
            let [start, end] = [at(from), at(to)];
            match pieces.last_mut() {
                Some(piece) if piece.last() == Some(&start) => piece.push(end),
                _ => pieces.push(vec![start, end]),
            }
        };
        match within(ends, room) {
            None => add(0.0, 1.0),
            Some([from, to]) => {
                if from > 0.0 {
                    add(0.0, from);
                }
                if to < 1.0 {
                    add(to, 1.0);
                }
            }
        }
    }
    pieces.retain(|piece| length(piece) > 0.0);
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;
    use epicyclic_drawing::text::overlaps;
    use proptest::prelude::*;

    fn map(values: impl Fn(f64, f64) -> Option<f64>, places: u32) -> Contours {
        let ticks: Vec<f64> = (0..places).map(f64::from).collect();
        let values =
            ticks.iter().flat_map(|x| ticks.iter().map(|y| values(*x, *y)).collect::<Vec<_>>()).collect();
        let text = |text: &str| text.to_owned();
        Contours {
            title: text("map"),
            across: text("x"),
            up: text("y"),
            columns: ticks.clone(),
            rows: ticks,
            values,
        }
    }

    #[test]
    fn the_lines_of_a_plane_are_straight_and_whole() {
        let plane = map(|x, y| Some(0.5 + 0.01 * x + 0.02 * y), 11);
        let [across, up] = [0, 1].map(|way| Axis::new([0.0, 10.0].into_iter(), SIZE_MM[way], false));
        let lines = plane.lines(0.65, [&across, &up]);
        assert_eq!(lines.len(), 1);
        for [x, y] in &lines[0] {
            let value = 0.5 + 0.1 * x / SIZE_MM[0] + 0.2 * y / SIZE_MM[1];
            assert!((value - 0.65).abs() < 1e-12);
        }
        // From the lower right end to the upper left.
        let ends = [lines[0][0], *lines[0].last().unwrap()].map(|[x, _]| x);
        assert!(ends.contains(&SIZE_MM[0]) && ends.iter().any(|x| x.abs() < 1e-9), "{ends:?}");
    }

    #[test]
    fn a_hill_has_closed_lines_and_each_line_its_value() {
        let hill = map(|x, y| Some(0.95 - 0.01 * ((x - 10.0).powi(2) + (y - 10.0).powi(2)) / 2.0), 21);
        let scene = hill.scene().unwrap();
        assert_eq!(overlaps(&scene), vec![]);
        let labels = scene.items().iter().filter(|item| scene.layer_of(item).name == "labels").count();
        assert!(labels > 15, "{labels}");
    }

    #[test]
    fn nothing_is_an_empty_field() {
        assert!(map(|_, _| None, 5).scene().is_ok());
        assert!(map(|_, _| Some(0.97), 5).scene().is_ok());
    }

    proptest! {
        #[test]
        fn no_value_meets_another_or_a_line(values in prop::collection::vec(prop::option::weighted(0.95, 0.2_f64..1.0), 81)) {
            let picture = map(|x, y| values[(9.0 * x + y) as usize], 9);
            let scene = picture.scene().unwrap();
            prop_assert_eq!(overlaps(&scene), vec![]);
        }
    }
}

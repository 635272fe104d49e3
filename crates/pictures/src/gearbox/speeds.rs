//! The speed diagram of a gear (Kutzbach): peripheral velocity over radius for each set, and the rays of angular speed.
//!
//! A point of a link at radius `r` moves at `v = ω·r`: drawn over `r`, a link is a line through the axis with the slope `ω`, and a
//! planet a line through its three points, where it meets central gear 1 and central gear 2 and where its planet pin is. Rays parallel to these lines from a
//! pole cut a line at the speeds `ω`.
//!
//! Radii are in units of each set's central gear 1; of a simple set `r_b = k` and the planet pins stand at `(1 + k)/2`. All sets have one slope
//! for one speed. Two planets in mesh are drawn as one beside the other with equal sizes, which changes their own speeds but none of
//! the links'; they get no ray. Of stepped sets the teeth give all radii. Planets of other kinds, and of stepped sets without teeth,
//! are left out.

mod radii;

use super::place::{Places, spread};
use super::scheme::{known, title};
use super::words::{self, decimal};
use super::{COLORS, Error, LETTERS_MM, TITLE_MM};
use crate::tolerance::{LEAST_SPEED, ONE_RAY};
use epicyclic_drawing::{Align, Color, Dash, LayerId, Point, Scene, Shape, Style, Text};
use epicyclic_train::{Analysis, Gearbox};
use radii::{Line, SpeedDiagram};
use std::f64::consts::FRAC_PI_2;

/// Height of each set's diagram.
const HEIGHT_MM: f64 = 70.0;
/// Width of the fastest point on its side.
const FASTEST_MM: f64 = 45.0;
/// Greatest width of the rays on one side, and their greatest height.
const RAYS_MM: [f64; 2] = [75.0, 45.0];
/// From label to label of the speeds.
const PITCH_MM: f64 = 4.2;

/// The speed diagram of a gear.
///
/// # Errors
/// [`Error::SpeedsUnknown`] for a gear in which the speed of a link does not follow.
pub fn scene(gearbox: &Gearbox, gear: &Analysis, heading: Option<&str>) -> Result<Scene, Error> {
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
    let slope = FASTEST_MM / (HEIGHT_MM * widest);
    let mut left = 0.0;
    for (set, diagram) in diagrams.iter().enumerate() {
        left = panel(&mut scene, &layers, gearbox, diagram, set, left, slope);
    }
    rays(&mut scene, &layers, gearbox, gear, &diagrams, slope);
    let bounds = scene.bounds();
    let at = [bounds.left, bounds.top + 7.0];
    let heading = Text::new(at, TITLE_MM, scene.title()).align(Align::Left);
    scene.add(layers.labels, heading);
    scene.check()?;
    Ok(scene)
}

struct Layers {
    axes: LayerId,
    help: LayerId,
    toothed_gears: LayerId,
    lines: LayerId,
    labels: LayerId,
}

/// How a line is drawn: links by their number, planets dashed.
fn style(line: &Line) -> Style {
    match line.link {
        Some(link) => Style::line(0.5).color(COLORS[(link.index() + COLORS.len() - 1) % COLORS.len()]),
        None => Style::line(0.35).dash(Dash::Dashed),
    }
}

/// One set: its gears on the left, velocities over radius on the right. Returns where the next may begin.
fn panel(
    scene: &mut Scene,
    layers: &Layers,
    gearbox: &Gearbox,
    diagram: &SpeedDiagram,
    set: usize,
    left: f64,
    slope: f64,
) -> f64 {
    let up = HEIGHT_MM / diagram.height;
    let across = |speed_radius: f64| slope * up * speed_radius;
    let lines = || diagram.lines.iter().flat_map(|line| [line.from, line.to]);
    let back = lines().map(|[_, v]| across(-v)).fold(0.0, f64::max);
    let ahead = lines().map(|[_, v]| across(v)).fold(0.0, f64::max);
    // Levels with their names, gears, and then the axis of velocities.
    let names = diagram.levels.iter().map(|(name, r)| format!("{name} {}", decimal(*r)));
    let names: Vec<String> = names.collect();
    let width =
        names.iter().map(|name| Text::new([0.0, 0.0], LETTERS_MM, name).width_mm()).fold(0.0, f64::max);
    let gears_at = left + width + 10.0;
    let zero = gears_at + 9.0 + back;
    let far = zero + ahead + 5.0;

    scene.add(layers.axes, Shape::line([gears_at - 5.0, 0.0], [far, 0.0]));
    scene.add(layers.axes, Shape::line([zero, 0.0], [zero, HEIGHT_MM + 5.0]));
    let mut levels: Vec<(f64, &String)> =
        diagram.levels.iter().map(|level| up * level.1).zip(&names).collect();
    levels.sort_by(|a, b| a.0.total_cmp(&b.0));
    let wanted: Vec<f64> = levels.iter().map(|level| level.0).collect();
    for ((y, name), place) in levels.iter().zip(spread(&wanted, 4.4)) {
        scene.add(layers.help, Shape::line([gears_at - 4.0, *y], [far, *y]));
        scene.add(layers.help, Shape::line([left + width + 1.0, place], [gears_at - 4.0, *y]));
        scene.add(layers.labels, Text::new([left + width, place], LETTERS_MM, *name).align(Align::Right));
    }
    for [from, to] in &diagram.toothed_gears {
        let (from, to) = (up * from, up * to);
        scene.add(layers.toothed_gears, Shape::line([gears_at, from + 0.5], [gears_at, to - 0.5]));
        for y in [from + 0.5, to - 0.5] {
            scene.add(layers.toothed_gears, Shape::line([gears_at - 2.0, y], [gears_at + 2.0, y]));
        }
    }
    for planet_pin in &diagram.planet_pins {
        scene.add(
            layers.toothed_gears,
            Shape::line([gears_at - 2.0, up * planet_pin], [gears_at + 3.0, up * planet_pin]),
        );
    }
    let on = |[r, v]: [f64; 2]| Point::new(zero + across(v), up * r);
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
        places.put(scene, layers.labels, &line.name, middle, &wishes);
    }
    let caption = Text::new([left, -6.0], LETTERS_MM, words::set(gearbox, set, true)).align(Align::Left);
    let next = far.max(caption.bounds().right) + 12.0;
    scene.add(layers.labels, caption);
    next
}

/// Rays from a pole, parallel to the lines of the diagrams, to the scale of speeds.
fn rays(
    scene: &mut Scene,
    layers: &Layers,
    gearbox: &Gearbox,
    gear: &Analysis,
    diagrams: &[SpeedDiagram],
    slope: f64,
) {
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
    for line in
        diagrams.iter().flat_map(|diagram| &diagram.lines).filter(|line| line.link.is_none() && line.has_ray)
    {
        let [[r, v], [further, faster]] = [line.from, line.to];
        enter((faster - v) / (further - r), line.name.clone(), style(line));
    }
    speeds.sort_by(|a, b| a.0.total_cmp(&b.0));
    let fastest = speeds.iter().map(|speed| speed.0.abs()).fold(LEAST_SPEED, f64::max);
    let [width, height] = RAYS_MM;
    let height = height.min(width / (slope * fastest));
    let unit = slope * height;
    let least = speeds.first().map_or(0.0, |speed| speed.0).min(0.0);
    let most = speeds.last().map_or(0.0, |speed| speed.0).max(0.0);

    let labels: Vec<String> =
        speeds.iter().map(|(speed, names, _)| format!("{}: {}", decimal(*speed), names.join(", "))).collect();
    let longest =
        labels.iter().map(|label| Text::new([0.0, 0.0], LETTERS_MM, label).width_mm()).fold(0.0, f64::max);
    let bounds = scene.bounds();
    let scale_y = bounds.bottom - longest - 16.0;
    let wanted: Vec<f64> = speeds.iter().map(|speed| unit * speed.0).collect();
    let places = spread(&wanted, PITCH_MM);
    let reach = places.first().copied().unwrap_or(0.0).min(unit * least);
    let pole = Point::new(bounds.left + 6.0 - reach, scale_y - height);

    let ends = [pole.x + unit * least - 4.0, pole.x + unit * most + 4.0];
    scene.add(layers.axes, Shape::line([ends[0], scale_y], [ends[1], scale_y]));
    for (((speed, _, style), label), place) in speeds.iter().zip(&labels).zip(&places) {
        let tip = Point::new(pole.x + unit * speed, scale_y);
        scene.add_styled(layers.lines, *style, Shape::line(pole, tip));
        let foot = Point::new(pole.x + place, scale_y + 6.0);
        scene.add(layers.axes, Shape::polyline([tip, Point::new(tip.x, tip.y + 1.5), foot]));
        let text = Text::new([foot.x, foot.y + 1.0], LETTERS_MM, label).align(Align::Left);
        scene.add(layers.labels, text.turned(FRAC_PI_2));
    }
    scene.add_styled(layers.lines, Style::filled(Color::BLACK), Shape::Circle { centre: pole, radius: 0.9 });
    scene.add(layers.labels, Text::new([pole.x + 4.0, pole.y - 2.6], LETTERS_MM, "pole"));
    let words = [
        "above: velocities over radius, radii over that of the first central gear of the set",
        "rays parallel to the lines above; at their ends the speeds over the input's",
    ];
    for (words, y) in words.into_iter().zip([pole.y - 8.0, pole.y - 12.6]) {
        scene.add(layers.labels, Text::new([bounds.left, y], LETTERS_MM, words).align(Align::Left));
    }
}

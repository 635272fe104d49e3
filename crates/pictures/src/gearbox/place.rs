//! Places for labels: the first free one of those wished for, or one nearby with a leader.

use super::LETTERS_MM;
use super::obstacles::{Obstacle, Obstacles};
use crate::tolerance::HAIR_MM;
use epicyclic_drawing::text::{distance, line_meets};
use epicyclic_drawing::{Align, Bounds, Color, LayerId, Point, Scene, Shape, Style, Text};
use std::f64::consts::TAU;

/// Least distance of a label from anything.
const CLEAR_MM: f64 = 0.5;

/// Least distance of a leader from lines and labels that are not its own.
const LEADER_CLEAR_MM: f64 = 0.25;
/// Distance from its point over which a leader may run close to the lines that meet there.
const OWN_MM: f64 = 0.8;
/// Distances of a label from its point, in half millimetres: first near, then anywhere.
const NEAR: u32 = 50;
const FAR: u32 = 400;

/// Lines, labels and signs that labels and leaders have to keep clear of.
pub(super) struct Places {
    /// Lines, and half their widths.
    lines: Vec<(Shape, f64, Bounds)>,
    /// Boxes of labels, which no leader may cross.
    labels: Vec<Bounds>,
    /// Obstacles for labels: labels, fills and lines.
    obstacles: Obstacles,
    /// Boxes that no leader may run through, as it would change what their sign means: gaps of clutches and
    /// brakes, teeth in mesh.
    signs: Vec<Bounds>,
}

/// The point where a leader begins.
struct Start {
    at: Point,
    /// Distance from which on the leader keeps clear of its own lines.
    off: f64,
    /// Whether each line meets at the point, in the order of [`Places::lines`].
    own: Vec<bool>,
}

/// Course of a leader.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    Clear,
    /// The leader crosses a line that is not its own.
    Crossing,
    /// Through a label or a sign, or along its own line.
    Blocked,
}

impl Places {
    /// Places around everything that a scene holds so far.
    pub(super) fn around(scene: &Scene) -> Self {
        let obstacles = Obstacles::over(scene.bounds());
        let mut places = Self { lines: vec![], labels: vec![], obstacles, signs: vec![] };
        for item in scene.items() {
            match &item.shape {
                Shape::Text(text) => places.keep_off_label(text.bounds()),
                shape => {
                    let half = 0.5 * scene.style(item).width_mm;
                    if half > 0.0 {
                        places.keep_off_line(shape.clone(), half);
                    } else {
                        // A fill covers its whole box.
                        places.obstacles.push(Obstacle { around: shape.bounds(), line: None });
                    }
                }
            }
        }
        places
    }

    fn keep_off_label(&mut self, around: Bounds) {
        self.labels.push(around);
        self.obstacles.push(Obstacle { around, line: None });
    }

    fn keep_off_line(&mut self, line: Shape, half_mm: f64) {
        let around = line.bounds();
        let wide = around.grown(half_mm + HAIR_MM);
        self.obstacles.push(Obstacle { around: wide, line: Some(self.lines.len()) });
        self.lines.push((line, half_mm, around));
    }

    fn free(&self, bounds: Bounds) -> bool {
        let clear = bounds.grown(CLEAR_MM);
        !self.obstacles.any(clear, |obstacle| {
            obstacle.around.overlaps(clear)
                && obstacle.line.is_none_or(|line| {
                    let (line, half, _) = &self.lines[line];
                    line_meets(line, clear.grown(*half))
                })
        })
    }

    /// Keeps leaders out of a sign's box.
    pub(super) fn keep_clear(&mut self, sign: Bounds) {
        self.signs.push(sign);
    }

    /// Adds a label: at the first free of the points wished for (its middle), else as near as can be to one
    /// of its points, at the end of a thin leader. A leader runs through no sign and no label, and crosses a
    /// line only where no other place is near.
    pub(super) fn put(
        &mut self,
        scene: &mut Scene,
        layer: LayerId,
        words: &str,
        points: &[Point],
        wishes: &[Point],
    ) {
        let label = |middle: Point| Text::new(middle, LETTERS_MM, words);
        if let Some(middle) = wishes.iter().find(|middle| self.free(label(**middle).bounds())) {
            return self.add(scene, layer, label(*middle));
        }
        let size = label(Point::new(0.0, 0.0)).bounds();
        let directions: [Point; 24] = std::array::from_fn(|turn| {
            Point::polar(Point::new(0.0, 0.0), 1.0, TAU * (turn as f64 + 0.5) / 24.0)
        });
        let starts: Vec<Start> = points.iter().map(|at| self.start(*at)).collect();
        for steps in [1..NEAR, NEAR..FAR] {
            // The first place whose leader crosses a line is taken where none without is as near.
            let mut crossing = None;
            let mut found = None;
            'near: for step in steps {
                let length = 2.0 + 0.5 * f64::from(step);
                let all = directions.iter().flat_map(|to| starts.iter().map(move |start| (to, start)));
                for (direction, start) in all {
                    let at = start.at;
                    let middle = Point::new(at.x + length * direction.x, at.y + length * direction.y);
                    let bounds = Bounds {
                        left: middle.x + size.left,
                        right: middle.x + size.right,
                        bottom: middle.y + size.bottom,
                        top: middle.y + size.top,
                    };
                    if !self.free(bounds) {
                        continue;
                    }
                    let end = nearest(bounds, at);
                    let place = (middle, at, end);
                    match self.way(start, end) {
                        Way::Clear => {
                            found = Some(place);
                            break 'near;
                        }
                        Way::Crossing => crossing = crossing.or(Some(place)),
                        Way::Blocked => {}
                    }
                }
            }
            if let Some((middle, at, end)) = found.or(crossing) {
                // A label around its point needs no leader.
                if at != end {
                    let leader = Shape::line(at, end);
                    scene.add_styled(layer, LEADER, leader.clone());
                    self.keep_off_line(leader, 0.5 * LEADER.width_mm);
                }
                return self.add(scene, layer, label(middle));
            }
        }
        // Two hundred millimetres of lines without a gap: beside the picture, then.
        let bounds = scene.bounds();
        let y = points.first().map_or(bounds.top, |at| at.y);
        let text = Text::new([bounds.right + 3.0, y], LETTERS_MM, words).align(Align::Left);
        self.add(scene, layer, text);
    }

    /// The point of a leader and what it shares with lines there.
    fn start(&self, at: Point) -> Start {
        let near = Bounds::of([at]).grown(OWN_MM);
        let is_own = |line: &Shape, around: &Bounds| {
            around.grown(HAIR_MM).overlaps(near) && distance(at, at, line) < OWN_MM
        };
        let own: Vec<bool> = self.lines.iter().map(|(line, _, around)| is_own(line, around)).collect();
        let widths = self.lines.iter().zip(&own).filter(|(_, own)| **own).map(|((_, half, _), _)| *half);
        let off = widths.map(|half| half + LEADER_CLEAR_MM).fold(OWN_MM, f64::max);
        Start { at, off, own }
    }

    /// Course of a leader from its point to the end.
    fn way(&self, start: &Start, end: Point) -> Way {
        let at = start.at;
        let length = libm::hypot(end.x - at.x, end.y - at.y);
        let after = |off: f64| {
            let part = (off / length.max(off)).min(1.0);
            Point::new(at.x + part * (end.x - at.x), at.y + part * (end.y - at.y))
        };
        // A wide line of power hides more of its leader, but no sign.
        let (off, bare) = (after(start.off), after(OWN_MM));
        let whole = Shape::line(at, end);
        let around_whole = whole.bounds().grown(HAIR_MM);
        let meets = |line: &Shape, bounds: Bounds| around_whole.overlaps(bounds) && line_meets(line, bounds);
        if self.labels.iter().any(|label| meets(&whole, label.grown(LEADER_CLEAR_MM)))
            || self.signs.iter().any(|sign| meets(&Shape::line(bare, end), *sign))
        {
            return Way::Blocked;
        }
        let mut way = Way::Clear;
        for ((line, half, around), &is_own) in self.lines.iter().zip(&start.own) {
            // A leader starts at the middle of its own line or at its edge.
            let clear = if is_own { *half } else { half + LEADER_CLEAR_MM };
            if (way == Way::Crossing && !is_own) || !around.grown(clear + HAIR_MM).overlaps(around_whole) {
                continue;
            }
            if distance(off, end, line) < clear {
                if is_own {
                    return Way::Blocked;
                }
                way = Way::Crossing;
            }
        }
        way
    }

    fn add(&mut self, scene: &mut Scene, layer: LayerId, text: Text) {
        self.keep_off_label(text.bounds());
        scene.add(layer, text);
    }
}

/// Style of leaders.
const LEADER: Style = Style::line(0.18).color(Color::GREY);

/// The point of a box, a little outside of it, that is nearest to a point.
fn nearest(bounds: Bounds, to: Point) -> Point {
    let bounds = bounds.grown(0.3);
    Point::new(to.x.clamp(bounds.left, bounds.right), to.y.clamp(bounds.bottom, bounds.top))
}

/// Wishes to the right and left of a point.
pub(super) fn beside(at: Point, words: &str, gap: f64) -> [Point; 2] {
    let half = 0.5 * Text::new(at, LETTERS_MM, words).width_mm() + CLEAR_MM + 0.1;
    [Point::new(at.x + gap + half, at.y), Point::new(at.x - gap - half, at.y)]
}

/// Places near the desired ones, in ascending order, at least `pitch` apart: each run that is too close is
/// spread about its middle.
///
/// ```text
/// wanted 0 1 9, pitch 3  →  −1 2 9
/// ```
pub(super) fn spread(wanted: &[f64], pitch: f64) -> Vec<f64> {
    // Runs: (sum of desired − place within the run, members).
    let mut runs: Vec<(f64, usize)> = vec![];
    let first = |&(sum, count): &(f64, usize)| sum / count as f64;
    for &place in wanted {
        runs.push((place, 1));
        while let [.., before, last] = runs[..] {
            if first(&before) + pitch * before.1 as f64 <= first(&last) {
                break;
            }
            let shift = pitch * (before.1 * last.1) as f64;
            runs.truncate(runs.len() - 2);
            runs.push((before.0 + last.0 - shift, before.1 + last.1));
        }
    }
    runs.iter().flat_map(|run| (0..run.1).map(move |i| first(run) + pitch * i as f64)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_close_run_is_spread_about_its_middle() {
        assert_eq!(spread(&[0.0, 1.0, 9.0], 3.0), [-1.0, 2.0, 9.0]);
        assert_eq!(spread(&[5.0], 3.0), [5.0]);
        assert_eq!(spread(&[], 3.0), [0.0; 0]);
    }

    #[test]
    fn a_label_shut_in_gets_a_leader() {
        let mut scene = Scene::new("grate");
        let layer = scene.layer("all", Style::line(0.3)).unwrap();
        for i in -20..=20 {
            scene.add(layer, Shape::line([f64::from(i), -10.0], [f64::from(i), 10.0]));
        }
        let mut places = Places::around(&scene);
        let at = Point::new(0.0, 0.0);
        places.put(&mut scene, layer, "K1", &[at], &[at, Point::new(3.0, 0.0)]);
        assert_eq!(epicyclic_drawing::text::overlaps(&scene), []);
        assert_eq!(scene.items().len(), 41 + 2);
    }

    /// A clutch between two plates, its name shut out by walls on both sides: the leader runs around it, not
    /// through its gap.
    #[test]
    fn no_leader_runs_through_a_sign() {
        let mut scene = Scene::new("clutch");
        let layer = scene.layer("all", Style::line(0.7)).unwrap();
        for y in [-1.5, 1.5] {
            scene.add(layer, Shape::line([-2.6, y], [2.6, y]));
            scene.add(layer, Shape::line([0.0, y], [0.0, 9.0 * y]));
        }
        for x in [-4.0, 4.0] {
            scene.add(layer, Shape::line([x, -9.0], [x, 9.0]));
        }
        let gap = Bounds { left: -2.6, right: 2.6, bottom: -1.5, top: 1.5 };
        let above = Point::new(0.0, 8.0);
        let mut places = Places::around(&scene);
        places.keep_clear(gap);
        places.put(&mut scene, layer, "a shaft's name", &[above], &[]);
        let leader = &scene.items()[scene.items().len() - 2].shape;
        assert!(matches!(leader, Shape::Line { .. }) && !line_meets(leader, gap), "{leader:?}");
        assert_eq!(epicyclic_drawing::text::overlaps(&scene), []);
    }

    proptest! {
        #[test]
        fn spread_keeps_order_and_distance(mut wanted in prop::collection::vec(-50.0..50.0_f64, 0..20), pitch in 0.1..9.0_f64) {
            wanted.sort_by(f64::total_cmp);
            let places = spread(&wanted, pitch);
            prop_assert_eq!(places.len(), wanted.len());
            prop_assert!(places.windows(2).all(|pair| pair[1] - pair[0] >= pitch - 1e-9));
            // Places move only as far as needed, and the middle stays.
            let middle = |all: &[f64]| all.iter().sum::<f64>();
            prop_assert!((middle(&places) - middle(&wanted)).abs() < 1e-6);
            if wanted.windows(2).all(|pair| pair[1] - pair[0] >= pitch) {
                prop_assert!(places.iter().zip(&wanted).all(|(a, b)| (a - b).abs() < 1e-9));
            }
        }
    }
}

//! Places for labels: the first free one of those wished for, or one nearby with a leader.

use super::LETTERS_MM;
use crate::tolerance::HAIR_MM;
use epicyclic_drawing::text::line_meets;
use epicyclic_drawing::{Align, Bounds, Color, LayerId, Point, Scene, Shape, Style, Text};
use std::f64::consts::TAU;

/// Least distance of a label from anything.
const CLEAR_MM: f64 = 0.5;

/// What labels have to keep clear of.
pub(super) struct Places {
    /// Lines, and half their widths.
    lines: Vec<(Shape, f64, Bounds)>,
    labels: Vec<Bounds>,
    /// Boxes of fills, which a leader may cross.
    fills: Vec<Bounds>,
}

impl Places {
    /// Around everything that a scene holds so far.
    pub(super) fn around(scene: &Scene) -> Self {
        let mut places = Self { lines: vec![], labels: vec![], fills: vec![] };
        for item in scene.items() {
            match &item.shape {
                Shape::Text(text) => places.labels.push(text.bounds()),
                shape => {
                    let half = 0.5 * scene.style(item).width_mm;
                    if half > 0.0 {
                        places.lines.push((shape.clone(), half, shape.bounds()));
                    } else {
                        // A fill covers its whole box.
                        places.fills.push(shape.bounds());
                    }
                }
            }
        }
        places
    }

    fn free(&self, bounds: Bounds) -> bool {
        let clear = bounds.grown(CLEAR_MM);
        !self.labels.iter().chain(&self.fills).any(|label| label.overlaps(clear))
            && !self.lines.iter().any(|(line, half, around)| {
                let clear = clear.grown(*half);
                around.grown(HAIR_MM).overlaps(clear) && line_meets(line, clear)
            })
    }

    /// Adds a label beside its point: at the first free of the points wished for (its middle), else as near as can be, at the end of a
    /// thin leader.
    pub(super) fn put(
        &mut self,
        scene: &mut Scene,
        layer: LayerId,
        words: &str,
        at: Point,
        wishes: &[Point],
    ) {
        let label = |middle: Point| Text::new(middle, LETTERS_MM, words);
        if let Some(middle) = wishes.iter().find(|middle| self.free(label(**middle).bounds())) {
            return self.add(scene, layer, label(*middle));
        }
        for step in 1..400 {
            let distance = 2.0 + 0.5 * f64::from(step);
            for turn in 0..24 {
                let angle = TAU * (f64::from(turn) + 0.5) / 24.0;
                let middle = Point::polar(at, distance, angle);
                let bounds = label(middle).bounds();
                let leader = Shape::line(at, nearest(bounds, at));
                if self.free(bounds) && !self.labels.iter().any(|other| line_meets(&leader, *other)) {
                    scene.add_styled(layer, Style::line(0.18).color(Color::GREY), leader.clone());
                    self.lines.push((leader.clone(), 0.09, leader.bounds()));
                    return self.add(scene, layer, label(middle));
                }
            }
        }
        // Two hundred millimetres of lines without a gap: beside the picture, then.
        let bounds = scene.bounds();
        let text = Text::new([bounds.right + 3.0, at.y], LETTERS_MM, words).align(Align::Left);
        self.add(scene, layer, text);
    }

    fn add(&mut self, scene: &mut Scene, layer: LayerId, text: Text) {
        self.labels.push(text.bounds());
        scene.add(layer, text);
    }
}

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

/// Places near those wanted, ascending as they are, at least `pitch` apart: each run that is too close is spread about its middle.
///
/// ```text
/// wanted 0 1 9, pitch 3  →  −1 2 9
/// ```
pub(super) fn spread(wanted: &[f64], pitch: f64) -> Vec<f64> {
    // Runs: (sum of wanted − place within the run, members).
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
        places.put(&mut scene, layer, "K1", at, &[at, Point::new(3.0, 0.0)]);
        assert_eq!(epicyclic_drawing::text::overlaps(&scene), []);
        assert_eq!(scene.items().len(), 41 + 2);
    }

    proptest! {
        #[test]
        fn spread_keeps_order_and_distance(mut wanted in prop::collection::vec(-50.0..50.0_f64, 0..20), pitch in 0.1..9.0_f64) {
            wanted.sort_by(f64::total_cmp);
            let places = spread(&wanted, pitch);
            prop_assert_eq!(places.len(), wanted.len());
            prop_assert!(places.windows(2).all(|pair| pair[1] - pair[0] >= pitch - 1e-9));
            // Nothing is moved without need, and the middle stays.
            let middle = |all: &[f64]| all.iter().sum::<f64>();
            prop_assert!((middle(&places) - middle(&wanted)).abs() < 1e-6);
            if wanted.windows(2).all(|pair| pair[1] - pair[0] >= pitch) {
                prop_assert!(places.iter().zip(&wanted).all(|(a, b)| (a - b).abs() < 1e-9));
            }
        }
    }
}

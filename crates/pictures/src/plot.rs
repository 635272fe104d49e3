//! Curves over an axis: a plot with ticks, a grid and a legend.

use crate::tolerance::{LEAST_SPAN, MARK};
use epicyclic_drawing::{Align, Color, Dash, Error, LayerId, Point, Scene, Shape, Style, Text};

/// Height of the letters.
pub(crate) const LETTERS_MM: f64 = 2.5;
/// Radius of a dot on a curve.
const DOT_MM: f64 = 0.9;
/// Colours of the curves, which also differ in lightness; after the last the first is used again, dashed.
const COLORS: [Color; 6] = [
    Color::new(0, 90, 160),
    Color::new(200, 60, 20),
    Color::new(20, 130, 60),
    Color::new(120, 60, 150),
    Color::new(170, 120, 0),
    Color::new(90, 90, 90),
];

/// A plot.
///
/// ```
/// use epicyclic_pictures::plot::{Curve, Plot};
///
/// let sine = (0..=100).map(|i| f64::from(i) * 0.1).map(|x| [x, x.sin()]).collect();
/// let plot = Plot::new("A sine", "x", "sin x").with(Curve::new("sine", sine));
/// let image = epicyclic_drawing::svg::write(&plot.scene()?)?;
/// assert!(image.contains("A sine"));
/// # Ok::<(), epicyclic_drawing::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Plot {
    /// Title of the plot.
    pub title: String,
    /// Quantity on the horizontal axis, with its unit.
    pub across: String,
    /// Quantity on the vertical axis, with its unit.
    pub up: String,
    /// The curves.
    pub curves: Vec<Curve>,
    /// Places marked by an upright line, and by a dot on each curve that has a point there.
    pub marks: Vec<Mark>,
    /// Width and height of the field of the curves in millimetres.
    pub size_mm: [f64; 2],
    /// Whether the title is left out because the surrounding page gives it.
    pub is_untitled: bool,
}

/// A curve through points in their order.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Name in the legend.
    pub name: String,
    /// Points of the curve; one with a coordinate that is no number is a gap.
    pub points: Vec<[f64; 2]>,
    /// Index of the colour; by default that of the curve in the plot.
    pub color: Option<usize>,
}

impl Curve {
    /// Curve in the colour of this index, so that a quantity has one colour in several plots.
    #[must_use]
    pub fn colored(self, place: usize) -> Self {
        Self { color: Some(place), ..self }
    }

    /// A curve.
    #[must_use]
    pub fn new(name: impl Into<String>, points: Vec<[f64; 2]>) -> Self {
        Self { name: name.into(), points, color: None }
    }
}

/// A marked place.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// Name of the mark.
    pub name: String,
    /// Position on the horizontal axis.
    pub at: f64,
}

impl Plot {
    /// A plot without curves, 130 × 70 mm.
    #[must_use]
    pub fn new(title: impl Into<String>, across: impl Into<String>, up: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            across: across.into(),
            up: up.into(),
            curves: vec![],
            marks: vec![],
            size_mm: [130.0, 70.0],
            is_untitled: false,
        }
    }

    /// Plot with one more curve.
    #[must_use]
    pub fn with(mut self, curve: Curve) -> Self {
        self.curves.push(curve);
        self
    }

    /// Plot with one more mark.
    #[must_use]
    pub fn mark(mut self, name: impl Into<String>, at: f64) -> Self {
        self.marks.push(Mark { name: name.into(), at });
        self
    }

    /// Plot whose field has another width and height.
    #[must_use]
    pub fn sized(self, size_mm: [f64; 2]) -> Self {
        Self { size_mm, ..self }
    }

    /// Plot without its title, for a page that gives it.
    #[must_use]
    pub fn untitled(self) -> Self {
        Self { is_untitled: true, ..self }
    }

    /// The scene. A plot without any point is its empty field.
    ///
    /// # Errors
    /// As [`Scene::layer`] and [`Scene::check`]; not for any finite points.
    pub fn scene(&self) -> Result<Scene, Error> {
        let mut scene = Scene::new(self.title.clone());
        let field = Field::new(self);
        let grid = scene.layer("grid", Style::line(0.1).color(Color::new(205, 205, 205)))?;
        let frame = scene.layer("frame", Style::line(0.25))?;
        let marks = scene.layer("marks", Style::line(0.18).color(Color::GREY).dash(Dash::Dashed))?;
        let curves = scene.layer("curves", Style::line(0.5))?;
        let labels = scene.layer("labels", Style::line(0.1))?;
        field.axes(&mut scene, grid, labels, self);
        for mark in self.marks.iter().filter(|mark| field.across.holds(mark.at)) {
            let x = field.across.place(mark.at);
            scene.add(marks, Shape::line([x, 0.0], [x, self.size_mm[1]]));
        }
        for (place, curve) in self.colored() {
            for piece in pieces(&curve.points) {
                let at = |point: &[f64; 2]| [field.across.place(point[0]), field.up.place(point[1])];
                match piece {
                    [only] => scene.add_styled(
                        curves,
                        style(place),
                        Shape::Circle { centre: at(only).into(), radius: 0.6 },
                    ),
                    more => scene.add_styled(curves, style(place), Shape::polyline(more.iter().map(at))),
                }
                let is_marked = |point: &&[f64; 2]| self.marks.iter().any(|mark| mark.at == point[0]);
                for point in piece.iter().filter(is_marked) {
                    let dot = Shape::Circle { centre: at(point).into(), radius: DOT_MM };
                    scene.add_styled(curves, Style::filled(style(place).color), dot);
                }
            }
        }
        scene.add(frame, Shape::rectangle([0.0, 0.0], self.size_mm));
        self.legend(&mut scene, curves, marks, labels);
        scene.check()?;
        Ok(scene)
    }

    /// The curves with the places of their colours.
    fn colored(&self) -> impl Iterator<Item = (usize, &Curve)> {
        self.curves.iter().enumerate().map(|(place, curve)| (curve.color.unwrap_or(place), curve))
    }

    /// Names of curves and marks, below the field.
    fn legend(&self, scene: &mut Scene, curves: LayerId, marks: LayerId, labels: LayerId) {
        let mut at = Point::new(0.0, -14.0);
        let names = self.colored().map(|(place, curve)| (Some(place), &curve.name));
        let marked = self.marks.iter().map(|mark| (None, &mark.name));
        for (place, name) in names.chain(marked) {
            let text = Text::new([0.0, 0.0], LETTERS_MM, name.clone()).align(Align::Left);
            let width = 9.0 + text.width_mm() + 5.0;
            if at.x > 0.0 && at.x + width > self.size_mm[0] {
                at = Point::new(0.0, at.y - 5.0);
            }
            let sample = Shape::line([at.x, at.y], [at.x + 7.0, at.y]);
            match place {
                Some(place) => scene.add_styled(curves, style(place), sample),
                None => scene.add(marks, sample),
            }
            scene.add(labels, Text { at: Point::new(at.x + 9.0, at.y), ..text });
            at.x += width;
        }
    }
}

fn style(place: usize) -> Style {
    let dash = [Dash::Solid, Dash::Dashed, Dash::DashDot][place / COLORS.len() % 3];
    Style::line(0.5).color(COLORS[place % COLORS.len()]).dash(dash)
}

/// The curve without its gaps.
fn pieces(points: &[[f64; 2]]) -> impl Iterator<Item = &[[f64; 2]]> {
    points.split(|[x, y]| !(x.is_finite() && y.is_finite())).filter(|piece| !piece.is_empty())
}

/// The field and its two axes.
struct Field {
    across: Axis,
    up: Axis,
}

impl Field {
    fn new(plot: &Plot) -> Self {
        let points = || plot.curves.iter().flat_map(|curve| pieces(&curve.points)).flatten();
        let [width, height] = plot.size_mm;
        // A mark is drawn in the field even if no curve reaches it.
        let marked = plot.marks.iter().map(|mark| mark.at).filter(|at| at.is_finite());
        Self {
            across: Axis::new(points().map(|[x, _]| *x).chain(marked), width, false),
            up: Axis::new(points().map(|[_, y]| *y), height, true),
        }
    }

    fn axes(&self, scene: &mut Scene, grid: LayerId, labels: LayerId, plot: &Plot) {
        let [width, height] = plot.size_mm;
        for tick in self.across.ticks() {
            let x = self.across.place(tick);
            scene.add(grid, Shape::line([x, 0.0], [x, height]));
            scene.add(labels, Text::new([x, -3.5], LETTERS_MM, self.across.label(tick)));
        }
        let mut widest = 0.0_f64;
        for tick in self.up.ticks() {
            let y = self.up.place(tick);
            let text = Text::new([-1.5, y], LETTERS_MM, self.up.label(tick)).align(Align::Right);
            widest = widest.max(text.width_mm());
            scene.add(grid, Shape::line([0.0, y], [width, y]));
            scene.add(labels, text);
        }
        if !plot.is_untitled {
            let title = Text::new([0.5 * width, height + 4.5], 1.2 * LETTERS_MM, plot.title.clone());
            scene.add(labels, title);
        }
        scene.add(labels, Text::new([0.5 * width, -8.5], LETTERS_MM, plot.across.clone()));
        let up = Text::new([-widest - 5.0, 0.5 * height], LETTERS_MM, plot.up.clone());
        scene.add(labels, up.turned(std::f64::consts::FRAC_PI_2));
    }
}

/// An axis from a round number to a round number, or between the ends of what it shows.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Axis {
    low: f64,
    high: f64,
    step: f64,
    length_mm: f64,
}

impl Axis {
    pub(crate) fn new(values: impl Iterator<Item = f64>, length_mm: f64, to_round_numbers: bool) -> Self {
        let (low, high) = values
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        let (low, high) = if low > high { (0.0, 1.0) } else { (low, high) };
        // A constant value is shown in the middle of a span of its own size.
        let slack = if high - low > MARK * low.abs().max(high.abs()) {
            0.0
        } else {
            (0.5 * low.abs()).max(LEAST_SPAN).max(if low == 0.0 { 1.0 } else { 0.0 })
        };
        let (low, high) = (low - slack, high + slack);
        let step = round_step((high - low) / (length_mm / 14.0));
        if to_round_numbers {
            let (low, high) = ((low / step + MARK).floor() * step, (high / step - MARK).ceil() * step);
            Self { low, high, step, length_mm }
        } else {
            Self { low, high, step, length_mm }
        }
    }

    pub(crate) fn place(&self, value: f64) -> f64 {
        (value - self.low) / (self.high - self.low) * self.length_mm
    }

    fn holds(&self, value: f64) -> bool {
        (self.low..=self.high).contains(&value)
    }

    pub(crate) fn ticks(&self) -> impl Iterator<Item = f64> + use<> {
        let (first, step) = ((self.low / self.step - MARK).ceil(), self.step);
        let last = (self.high / step + MARK).floor();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        // a step is at least a twelfth of the axis or so
        let count = (last - first).clamp(0.0, 100.0) as u32;
        (0..=count).map(move |i| (first + f64::from(i)) * step)
    }

    /// A tick with the decimals of its step.
    pub(crate) fn label(&self, tick: f64) -> String {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // 0 to 12
        let decimals = (-libm::log10(self.step).floor()).clamp(0.0, 12.0) as usize;
        let size = self.low.abs().max(self.high.abs());
        if size >= 1e6 || self.step < 1e-4 {
            let text = format!("{:.3e}", if tick.abs() < MARK * size { 0.0 } else { tick });
            return text;
        }
        let text = format!("{tick:.decimals$}").replace('-', "−");
        if text.trim_start_matches('−').chars().all(|c| c == '0' || c == '.') {
            text.trim_start_matches('−').to_owned()
        } else {
            text
        }
    }
}

/// The least of 1, 2, 5, 10… of a power of ten that is at least so large.
fn round_step(step: f64) -> f64 {
    let power = libm::pow(10_f64, libm::log10(step).floor());
    [1.0, 2.0, 5.0]
        .into_iter()
        .map(|part| part * power)
        .find(|round| *round >= step * (1.0 - MARK))
        .unwrap_or(10.0 * power)
}

#[cfg(test)]
mod tests {
    use super::*;
    use epicyclic_drawing::{svg, text::overlaps};
    use proptest::prelude::*;

    #[test]
    fn ticks_are_round_numbers() {
        assert_eq!([0.13, 0.2, 3.1, 70.0].map(round_step), [0.2, 0.2, 5.0, 100.0]);
        let axis = Axis::new([0.962, 0.994].into_iter(), 70.0, true);
        assert_eq!((axis.low, axis.high), (0.96, 1.0));
        assert_eq!(
            axis.ticks().map(|tick| axis.label(tick)).collect::<Vec<_>>(),
            ["0.96", "0.97", "0.98", "0.99", "1.00"]
        );
    }

    #[test]
    fn gaps_split_a_curve() {
        let points = [[0.0, 1.0], [1.0, 2.0], [2.0, f64::NAN], [3.0, 1.0]];
        assert_eq!(pieces(&points).map(<[_]>::len).collect::<Vec<_>>(), [2, 1]);
    }

    #[test]
    fn a_mark_stands_in_the_field_with_a_dot_on_each_curve_that_has_its_point() {
        let inside = Plot::new("p", "x", "y").with(Curve::new("a", vec![[0.0, 1.0], [1.0, 2.0], [2.0, 3.0]]));
        let dots = |plot: Plot| {
            let scene = plot.scene().unwrap();
            scene.items().iter().filter(|item| matches!(item.shape, Shape::Circle { .. })).count()
        };
        assert_eq!(dots(inside.clone().mark("here", 1.0)), 1);
        assert_eq!(dots(inside.clone().mark("between", 0.5)), 0);
        let outside = inside.mark("far", 5.0);
        assert!(Field::new(&outside).across.holds(5.0));
        let scene = outside.scene().unwrap();
        let marks = scene.items().iter().filter(|item| scene.layer_of(item).name == "marks");
        assert_eq!(marks.count(), 2, "the line, and its sample in the legend");
    }

    #[test]
    fn a_plot_without_points_is_an_empty_field() {
        assert!(Plot::new("nothing", "x", "y").scene().is_ok());
    }

    proptest! {
        #[test]
        fn no_label_meets_another_or_a_line(
            curves in prop::collection::vec((".{0,20}", prop::collection::vec((-1e4..1e4_f64, -1e5..1e5_f64), 1..30)), 1..9),
            scale in 1e-3..1e3_f64,
        ) {
            let mut plot = Plot::new("a plot", "across", "up").mark("here", 0.0);
            for (name, points) in curves {
                plot = plot.with(Curve::new(name, points.iter().map(|&(x, y)| [x * scale, y * scale]).collect()));
            }
            let scene = plot.scene().unwrap();
            prop_assert_eq!(overlaps(&scene), vec![]);
            prop_assert!(svg::write(&scene).is_ok());
        }

        #[test]
        fn no_points_break_it(points in prop::collection::vec((any::<f64>(), any::<f64>()), 0..20)) {
            let points = points.into_iter().map(|(x, y)| [x, y]).collect();
            let _ = Plot::new("any", "x", "y").with(Curve::new("any", points)).scene();
        }
    }
}

//! The scene: shapes on named layers.

use std::f64::consts::{FRAC_PI_2, TAU};

pub use crate::bounds::{Bounds, Point};
use crate::error::Error;
use crate::label::Text;
use crate::style::Style;
use crate::tolerance::STRAIGHT;

/// The largest coordinate, radius or height in millimetres: a hundred metres.
pub const LIMIT_MM: f64 = 1e5;

/// A vertex of a polyline and the way on from it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vertex {
    /// Position of the vertex.
    pub at: Point,
    /// The side to the next vertex: 0 a straight line, else an arc with `tan(sweep/4)`, positive
    /// counter-clockwise.
    pub bulge: f64,
}

/// Piece of a contour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Piece {
    /// An arc of a circle.
    Arc {
        /// Centre.
        centre: Point,
        /// Radius.
        radius: f64,
        /// Angle where it starts.
        start_rad: f64,
        /// Angle that it covers; negative clockwise; within a full turn.
        sweep_rad: f64,
    },
    /// A cubic Bézier curve by its control points.
    Cubic([Point; 4]),
}

impl Piece {
    /// First point.
    #[must_use]
    pub fn start(&self) -> Point {
        match self {
            Self::Arc { centre, radius, start_rad, .. } => Point::polar(*centre, *radius, *start_rad),
            Self::Cubic([start, ..]) => *start,
        }
    }

    fn bounds(&self) -> Bounds {
        match self {
            Self::Arc { centre, radius, start_rad, sweep_rad } => {
                arc_bounds(*centre, *radius, *start_rad, *sweep_rad)
            }
            // A curve lies within its control points.
            Self::Cubic(points) => Bounds::of(*points),
        }
    }
}

/// Shape that is drawn.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Shape {
    /// A straight line.
    Line {
        /// First end.
        from: Point,
        /// The other.
        to: Point,
    },
    /// A circle.
    Circle {
        /// Centre.
        centre: Point,
        /// Radius.
        radius: f64,
    },
    /// An arc of a circle.
    Arc {
        /// Centre.
        centre: Point,
        /// Radius.
        radius: f64,
        /// Angle where it starts.
        start_rad: f64,
        /// Angle that it covers; negative clockwise; within a full turn.
        sweep_rad: f64,
    },
    /// Lines and arcs from vertex to vertex.
    Polyline {
        /// The vertices. A last bulge counts only where the polyline is closed.
        vertices: Vec<Vertex>,
        /// Whether the last vertex is joined to the first.
        closed: bool,
    },
    /// A closed line of arcs and cubic curves, each from the end of the one before.
    Contour(Vec<Piece>),
    /// Text.
    Text(Text),
}

impl Shape {
    /// A straight line.
    #[must_use]
    pub fn line(from: impl Into<Point>, to: impl Into<Point>) -> Self {
        Self::Line { from: from.into(), to: to.into() }
    }

    /// An open polyline of straight sides.
    #[must_use]
    pub fn polyline<P: Into<Point>>(points: impl IntoIterator<Item = P>) -> Self {
        Self::Polyline { vertices: straight(points), closed: false }
    }

    /// A closed polyline of straight sides.
    #[must_use]
    pub fn polygon<P: Into<Point>>(points: impl IntoIterator<Item = P>) -> Self {
        Self::Polyline { vertices: straight(points), closed: true }
    }

    /// A rectangle by two opposite corners.
    #[must_use]
    pub fn rectangle(a: impl Into<Point>, b: impl Into<Point>) -> Self {
        let (a, b) = (a.into(), b.into());
        Self::polygon([[a.x, a.y], [b.x, a.y], [b.x, b.y], [a.x, b.y]])
    }

    /// The box around it.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        match self {
            Self::Line { from, to } => Bounds::of([*from, *to]),
            Self::Circle { centre, radius } => Bounds {
                left: centre.x - radius,
                right: centre.x + radius,
                bottom: centre.y - radius,
                top: centre.y + radius,
            },
            Self::Arc { centre, radius, start_rad, sweep_rad } => {
                arc_bounds(*centre, *radius, *start_rad, *sweep_rad)
            }
            Self::Polyline { vertices, closed } => {
                let corners = Bounds::of(vertices.iter().map(|vertex| vertex.at));
                sides(vertices, *closed).fold(corners, |all, (from, to, bulge)| {
                    match arc_of_side(from, to, bulge) {
                        Some((centre, radius, start, sweep)) => {
                            all.with(arc_bounds(centre, radius, start, sweep))
                        }
                        None => all,
                    }
                })
            }
            Self::Contour(pieces) => pieces.iter().fold(Bounds::EMPTY, |all, piece| all.with(piece.bounds())),
            Self::Text(text) => text.bounds(),
        }
    }
}

impl From<Text> for Shape {
    fn from(text: Text) -> Self {
        Self::Text(text)
    }
}

fn straight<P: Into<Point>>(points: impl IntoIterator<Item = P>) -> Vec<Vertex> {
    points.into_iter().map(|point| Vertex { at: point.into(), bulge: 0.0 }).collect()
}

/// Sides of a polyline: from, to, bulge.
pub(crate) fn sides(vertices: &[Vertex], closed: bool) -> impl Iterator<Item = (Point, Point, f64)> {
    let next = vertices.iter().cycle().skip(1);
    let count = if closed { vertices.len() } else { vertices.len().saturating_sub(1) };
    vertices.iter().zip(next).take(count).map(|(one, next)| (one.at, next.at, one.bulge))
}

/// Centre, radius, start and sweep of a bulged side; none of a straight one.
///
/// With the chord `c` and the bulge `b = tan(sweep/4)` the radius is `c·(1 + b²)/(4·|b|)`.
pub(crate) fn arc_of_side(from: Point, to: Point, bulge: f64) -> Option<(Point, f64, f64, f64)> {
    let (dx, dy) = (to.x - from.x, to.y - from.y);
    let chord = libm::hypot(dx, dy);
    if bulge.abs() < STRAIGHT || chord == 0.0 {
        return None;
    }
    let sweep = 4.0 * libm::atan(bulge);
    let radius = chord * (1.0 + bulge * bulge) / (4.0 * bulge.abs());
    // The centre lies left of the chord by (1 − b²)/(4·b) of it.
    let left = (1.0 - bulge * bulge) / (4.0 * bulge);
    let centre = Point::new(0.5 * (from.x + to.x) - left * dy, 0.5 * (from.y + to.y) + left * dx);
    let start = libm::atan2(from.y - centre.y, from.x - centre.x);
    Some((centre, radius, start, sweep))
}

fn arc_bounds(centre: Point, radius: f64, start: f64, sweep: f64) -> Bounds {
    let ends = [start, start + sweep].map(|angle| Point::polar(centre, radius, angle));
    let (low, high) = if sweep < 0.0 { (start + sweep, start) } else { (start, start + sweep) };
    let (low, high) = (low, high.min(low + TAU));
    let first = (low / FRAC_PI_2).ceil();
    let quarters = (0..5).map(|i| (first + f64::from(i)) * FRAC_PI_2).filter(|angle| *angle <= high);
    Bounds::of(ends.into_iter().chain(quarters.map(|angle| Point::polar(centre, radius, angle))))
}

/// A layer of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LayerId(pub(crate) usize);

/// A named layer and how its shapes are drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Layer {
    /// Name of the layer.
    pub name: String,
    /// Style of its shapes.
    pub style: Style,
}

/// A shape, its layer, and its style where it is not the layer's.
#[derive(Debug, Clone, PartialEq)]
pub struct Item {
    /// The layer.
    pub layer: LayerId,
    /// The shape.
    pub shape: Shape,
    /// Style of its own.
    pub style: Option<Style>,
}

/// Shapes on layers, drawn in the order in which they were added.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    title: String,
    layers: Vec<Layer>,
    items: Vec<Item>,
}

impl Scene {
    /// An empty scene.
    #[must_use]
    pub fn new(title: impl Into<String>) -> Self {
        Self { title: title.into(), layers: vec![], items: vec![] }
    }

    /// A new layer.
    ///
    /// # Errors
    /// [`Error::LayerName`], [`Error::LayerTwice`].
    pub fn layer(&mut self, name: impl Into<String>, style: Style) -> Result<LayerId, Error> {
        let name = name.into();
        let length = name.chars().count();
        let refused = |c: char| "<>/\\\":;?*|=,`".contains(c) || c.is_control();
        if length == 0 || length > 255 || name.contains(refused) || name.trim() != name {
            return Err(Error::LayerName { name });
        }
        if name == "0" || self.layers.iter().any(|layer| layer.name.to_lowercase() == name.to_lowercase()) {
            return Err(Error::LayerTwice { name });
        }
        self.layers.push(Layer { name, style });
        Ok(LayerId(self.layers.len() - 1))
    }

    /// Adds a shape to a layer of this scene.
    pub fn add(&mut self, layer: LayerId, shape: impl Into<Shape>) {
        self.items.push(Item { layer, shape: shape.into(), style: None });
    }

    /// Adds a shape with a style of its own.
    pub fn add_styled(&mut self, layer: LayerId, style: Style, shape: impl Into<Shape>) {
        self.items.push(Item { layer, shape: shape.into(), style: Some(style) });
    }

    /// The title.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.title
    }

    /// The layers.
    #[must_use]
    pub fn layers(&self) -> &[Layer] {
        &self.layers
    }

    /// The layer of one of its shapes.
    #[must_use]
    pub fn layer_of(&self, item: &Item) -> &Layer {
        &self.layers[item.layer.0]
    }

    /// Style of a layer.
    #[must_use]
    pub fn layer_style(&self, layer: LayerId) -> Style {
        self.layers[layer.0].style
    }

    /// The shapes.
    #[must_use]
    pub fn items(&self) -> &[Item] {
        &self.items
    }

    /// Style of a shape: its own, or that of its layer.
    #[must_use]
    pub fn style(&self, item: &Item) -> Style {
        item.style.unwrap_or(self.layers[item.layer.0].style)
    }

    /// The box around everything; [`Bounds::EMPTY`] of an empty scene.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        self.items.iter().fold(Bounds::EMPTY, |all, item| all.with(item.shape.bounds()))
    }

    /// Whether everything can be drawn.
    ///
    /// # Errors
    /// [`Error::Coordinate`], [`Error::Size`], [`Error::TooFewPoints`] for the first shape that cannot.
    pub fn check(&self) -> Result<(), Error> {
        self.items.iter().try_for_each(|item| self.check_item(item))
    }

    fn check_item(&self, item: &Item) -> Result<(), Error> {
        let layer = || self.layers[item.layer.0].name.clone();
        let within =
            |values: &[f64]| match values.iter().find(|value| value.is_nan() || value.abs() > LIMIT_MM) {
                Some(&value) => Err(Error::Coordinate { layer: layer(), value, limit: LIMIT_MM }),
                None => Ok(()),
            };
        let positive = |value: f64| {
            within(&[value])?;
            if value > 0.0 { Ok(()) } else { Err(Error::Size { layer: layer(), value }) }
        };
        match &item.shape {
            Shape::Line { from, to } => within(&[from.x, from.y, to.x, to.y]),
            Shape::Circle { centre, radius } => {
                within(&[centre.x, centre.y])?;
                positive(*radius)
            }
            Shape::Arc { centre, radius, start_rad, sweep_rad } => {
                within(&[centre.x, centre.y, *start_rad, *sweep_rad])?;
                positive(*radius)
            }
            Shape::Polyline { vertices, .. } if vertices.len() < 2 => {
                Err(Error::TooFewPoints { layer: layer(), points: vertices.len() })
            }
            Shape::Polyline { vertices, .. } => {
                vertices.iter().try_for_each(|vertex| within(&[vertex.at.x, vertex.at.y, vertex.bulge]))
            }
            Shape::Contour(pieces) if pieces.is_empty() => {
                Err(Error::TooFewPoints { layer: layer(), points: 0 })
            }
            Shape::Contour(pieces) => pieces.iter().try_for_each(|piece| match piece {
                Piece::Arc { centre, radius, start_rad, sweep_rad } => {
                    within(&[centre.x, centre.y, *start_rad, *sweep_rad])?;
                    positive(*radius)
                }
                Piece::Cubic(points) => points.iter().try_for_each(|point| within(&[point.x, point.y])),
            }),
            Shape::Text(text) => {
                within(&[text.at.x, text.at.y, text.rotation_rad])?;
                positive(text.height_mm)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bulged_side_is_the_arc_through_its_ends() {
        // A half circle counter-clockwise from (1, 0) to (−1, 0): bulge tan(180°/4) = 1.
        let (centre, radius, start, sweep) =
            arc_of_side(Point::new(1.0, 0.0), Point::new(-1.0, 0.0), 1.0).unwrap();
        assert!(centre.x.abs() + centre.y.abs() < 1e-12 && (radius - 1.0).abs() < 1e-12);
        assert!(start.abs() < 1e-12 && (sweep - std::f64::consts::PI).abs() < 1e-12);
        // A quarter clockwise about the origin from (0, 2) to (2, 0).
        let bulge = -libm::tan(std::f64::consts::FRAC_PI_8);
        let (centre, radius, ..) = arc_of_side(Point::new(0.0, 2.0), Point::new(2.0, 0.0), bulge).unwrap();
        assert!(libm::hypot(centre.x, centre.y) < 1e-12 && (radius - 2.0).abs() < 1e-12);
    }

    #[test]
    fn bounds_of_an_arc_reach_its_quarter_points() {
        let arc = Shape::Arc { centre: Point::new(0.0, 0.0), radius: 2.0, start_rad: 0.5, sweep_rad: 2.0 };
        let bounds = arc.bounds();
        assert!((bounds.top - 2.0).abs() < 1e-12 && bounds.bottom > 0.9);
        let back = Shape::Arc { centre: Point::new(0.0, 0.0), radius: 2.0, start_rad: 2.5, sweep_rad: -2.0 };
        let back = back.bounds();
        assert!((back.top - bounds.top).abs() + (back.left - bounds.left).abs() < 1e-12);
    }

    #[test]
    fn hardly_bulged_sides_are_straight() {
        for bulge in [0.0, f64::MIN_POSITIVE, 1e-300, -1e-11] {
            assert!(arc_of_side(Point::new(0.0, 0.0), Point::new(1e-111, 1.0), bulge).is_none(), "{bulge}");
        }
        assert!(arc_of_side(Point::new(0.0, 0.0), Point::new(1.0, 0.0), 1e-9).is_some());
    }

    #[test]
    fn bounds_of_a_bulged_polygon_hold_its_arcs() {
        let vertex = |x: f64, bulge| Vertex { at: Point::new(x, 0.0), bulge };
        let disc = Shape::Polyline { vertices: vec![vertex(-3.0, 1.0), vertex(3.0, 1.0)], closed: true };
        let bounds = disc.bounds();
        assert!((bounds.top - 3.0).abs() < 1e-12 && (bounds.bottom + 3.0).abs() < 1e-12);
    }

    #[test]
    fn a_layer_has_one_name_that_cad_programs_take() {
        let mut scene = Scene::new("layers");
        scene.layer("Stator", Style::line(0.5)).unwrap();
        assert!(matches!(scene.layer("stator", Style::line(0.5)), Err(Error::LayerTwice { .. })));
        assert!(matches!(scene.layer("0", Style::line(0.5)), Err(Error::LayerTwice { .. })));
        for name in ["", "a/b", "a:b", " a", "a\n"] {
            assert!(matches!(scene.layer(name, Style::line(0.5)), Err(Error::LayerName { .. })), "{name}");
        }
    }

    #[test]
    fn what_cannot_be_drawn_is_named() {
        let check = |shape: Shape| {
            let mut scene = Scene::new("one shape");
            let layer = scene.layer("all", Style::line(0.5)).unwrap();
            scene.add(layer, shape);
            scene.check()
        };
        let nan = check(Shape::line([0.0, f64::NAN], [1.0, 1.0]));
        assert!(matches!(nan, Err(Error::Coordinate { .. })));
        assert!(matches!(check(Shape::polyline([[0.0, 0.0]])), Err(Error::TooFewPoints { points: 1, .. })));
        let circle = Shape::Circle { centre: Point::default(), radius: 0.0 };
        assert!(matches!(check(circle), Err(Error::Size { .. })));
        assert!(matches!(
            check(Text::new([0.0, 0.0], f64::INFINITY, "x").into()),
            Err(Error::Coordinate { .. })
        ));
    }
}

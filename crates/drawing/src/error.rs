//! Errors of drawings.

use thiserror::Error;

/// A scene that cannot be drawn or written.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum Error {
    /// A layer's name that CAD programs refuse.
    #[error("layer name `{name}`: it must have 1 to 255 characters, none of < > / \\ \" : ; ? * | = , `")]
    LayerName {
        /// The name.
        name: String,
    },
    /// Two layers of one name; CAD programs do not distinguish capitals.
    #[error("layer `{name}` is there already")]
    LayerTwice {
        /// The name.
        name: String,
    },
    /// A coordinate, radius or angle that is no number, or too large to draw.
    #[error("a shape on layer `{layer}` has the coordinate or size {value}; it must lie within ±{limit} mm")]
    Coordinate {
        /// The layer.
        layer: String,
        /// The value.
        value: f64,
        /// The largest magnitude allowed.
        limit: f64,
    },
    /// A radius or text height that is not positive.
    #[error("a shape on layer `{layer}` has the radius or height {value}; it must be above zero")]
    Size {
        /// The layer.
        layer: String,
        /// The value.
        value: f64,
    },
    /// A scene that no PDF page holds.
    #[error(
        "the drawing is {width_mm:.0} × {height_mm:.0} mm; a PDF page has at most {most_mm:.0} mm each way"
    )]
    PageSize {
        /// Width of the drawing.
        width_mm: f64,
        /// Height of the drawing.
        height_mm: f64,
        /// Largest width and height of a page.
        most_mm: f64,
    },
    /// A resolution that no image has.
    #[error("{dpi} pixels an inch; {} are allowed", if *is_below { format!("at least {limit}") } else { format!("at most {limit}") })]
    Resolution {
        /// Pixels to an inch.
        dpi: f64,
        /// The limit that it exceeds.
        limit: f64,
        /// Whether it is below the least resolution.
        is_below: bool,
    },
    /// A scene that has too many pixels even at the least resolution.
    #[error(
        "the drawing makes an image of {width:.0} × {height:.0} pixels at {least_dpi} pixels an inch, the least resolution; at most {most:.0} pixels in all are allowed: write it as SVG or DXF"
    )]
    TooLarge {
        /// Pixels across at the least resolution.
        width: f64,
        /// Pixels down at the least resolution.
        height: f64,
        /// The least resolution.
        least_dpi: f64,
        /// The most pixels.
        most: f64,
    },
    /// Too many pixels.
    #[error(
        "{dpi} pixels an inch make an image of {width:.0} × {height:.0} pixels; at most {most:.0} in all are allowed, for this picture at most {most_dpi} an inch"
    )]
    Pixels {
        /// Pixels to an inch.
        dpi: f64,
        /// Pixels across.
        width: f64,
        /// Pixels down.
        height: f64,
        /// The greatest resolution of the picture.
        most_dpi: f64,
        /// The most pixels.
        most: f64,
    },
    /// A polyline of less than two points.
    #[error("a polyline on layer `{layer}` has {points} points; it needs at least two")]
    TooFewPoints {
        /// The layer.
        layer: String,
        /// Number of points of the polyline.
        points: usize,
    },
}

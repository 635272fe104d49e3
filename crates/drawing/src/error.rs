//! What cannot be drawn.

use thiserror::Error;

/// What cannot be drawn.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum Error {
    /// A layer's name that CAD programs refuse.
    #[error("layer name `{name}`: it must have 1 to 255 characters, none of < > / \\ \" : ; ? * | = , `")]
    LayerName {
        /// The name.
        name: String,
    },
    /// Two layers of one name; CAD programs tell no capitals apart.
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
    /// A polyline of less than two points.
    #[error("a polyline on layer `{layer}` has {points} points; it needs at least two")]
    TooFewPoints {
        /// The layer.
        layer: String,
        /// How many it has.
        points: usize,
    },
}

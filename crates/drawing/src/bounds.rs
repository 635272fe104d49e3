//! Points and boxes.

/// A point in millimetres.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Point {
    /// Coordinate to the right.
    pub x: f64,
    /// Coordinate upwards.
    pub y: f64,
}

impl Point {
    /// Point from its coordinates.
    #[must_use]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// Point at a distance and an angle from a centre.
    #[must_use]
    pub fn polar(centre: Self, radius: f64, angle_rad: f64) -> Self {
        Self::new(centre.x + radius * libm::cos(angle_rad), centre.y + radius * libm::sin(angle_rad))
    }
}

impl From<[f64; 2]> for Point {
    fn from([x, y]: [f64; 2]) -> Self {
        Self { x, y }
    }
}

/// A box along the axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Least `x`.
    pub left: f64,
    /// Greatest `x`.
    pub right: f64,
    /// Least `y`.
    pub bottom: f64,
    /// Greatest `y`.
    pub top: f64,
}

impl Bounds {
    /// A box of nothing, which any other swallows.
    pub const EMPTY: Self =
        Self { left: f64::INFINITY, right: f64::NEG_INFINITY, bottom: f64::INFINITY, top: f64::NEG_INFINITY };

    /// The box around points.
    #[must_use]
    pub fn of(points: impl IntoIterator<Item = Point>) -> Self {
        points
            .into_iter()
            .fold(Self::EMPTY, |all, p| all.with(Self { left: p.x, right: p.x, bottom: p.y, top: p.y }))
    }

    /// The box around both.
    #[must_use]
    pub fn with(self, other: Self) -> Self {
        Self {
            left: self.left.min(other.left),
            right: self.right.max(other.right),
            bottom: self.bottom.min(other.bottom),
            top: self.top.max(other.top),
        }
    }

    /// The box larger by a margin on every side.
    #[must_use]
    pub fn grown(self, margin: f64) -> Self {
        Self {
            left: self.left - margin,
            right: self.right + margin,
            bottom: self.bottom - margin,
            top: self.top + margin,
        }
    }

    /// Width.
    #[must_use]
    pub fn width(self) -> f64 {
        self.right - self.left
    }

    /// Height.
    #[must_use]
    pub fn height(self) -> f64 {
        self.top - self.bottom
    }

    /// Whether the box is empty.
    #[must_use]
    pub fn is_empty(self) -> bool {
        self.left > self.right || self.bottom > self.top
    }

    /// Whether the insides of both have anything in common.
    #[must_use]
    pub fn overlaps(self, other: Self) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.bottom < other.top
            && other.bottom < self.top
    }
}

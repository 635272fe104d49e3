//! Sizes in print; `page.css` has the same values.

/// Height of the smallest letters on paper: 8 pt.
pub(crate) const SMALLEST_MM: f64 = 8.0 * 25.4 / 72.0;

/// Width of one of two columns on A4, the narrower of the common papers: `(210 − 2·12 − 5)/2`.
pub(crate) const COLUMN_MM: f64 = 90.5;

/// Maximum widths of a picture with letters of 2.5 mm, which are larger than the smallest on paper: in a
/// column, and on a page.
pub(crate) const PICTURE_MM: [f64; 2] = [103.0, 220.0];

/// Width and height of the field of a plot, for two plots side by side.
pub(crate) const PLOT_MM: [f64; 2] = [80.0, 44.0];

/// Width and height of the field of a plot, for three plots side by side.
pub(crate) const SMALL_PLOT_MM: [f64; 2] = [50.0, 34.0];

//! Tolerances of this crate: differences that count as zero, and the grids of objectives.
//!
//! - `SLACK`: a measured value beyond its limit, over 1 and the value. A value chosen to lie at a limit
//!   misses it by the rounding of some dozen operations, 1e-13.
//! - `WIDER`: a limit by which a window is drawn, over 1 and the limit. It is twice `SLACK`: a window lets
//!   through all that the trial lets through.
//! - `HAIR`: the ends of a window, relative. The roots at which it ends are rounded.
//! - `GRID_SHIFT`: adding it to an objective and subtracting it leaves a multiple of 2⁻⁴⁰ ≈ 1e-12. Designs
//!   that differ by rounding are one.
//! - `GRID_END`: objectives from here on are their own grid, since doubles are coarser than the shift keeps.
//! - `GRID_STEP`: the distance of two points of the grid, by the shift.
//! - `RELATIVE_GRID`: multiplying the cube of the size and subtracting leaves 40 bits. The rounding of the
//!   cube grows with it, so its grid does.
//! - `RELATIVE_STEP`: for the cube, the distance of two points over the power of two below; 40 bits.
//! - `ROUNDING`: the relative error of one operation on doubles, half of their last bit.
//! - `LOOK`: a figure of a first look nearer than this to its limit, over 1 and the limit, is measured. It is
//!   a hundred times the rounding of a look, and still next to none.
//! - `BEHIND`: a first objective of a first look nearer than this to a bound, over 1 and the bound, is
//!   measured. It is above the grid of objectives and the remainder that `CANCELLED` leaves.
//! - `CANCELLED`: the terms of a difference over the difference, in a first look. It leaves 2e-10 of a
//!   double's digits.
//! - `TIE`: exact values half-way between points of the grid, far beyond the loss of a sum of two doubles,
//!   2⁻¹⁰⁰.

/// A value within its limit, or beyond it by this share of 1 and itself, keeps to it.
pub(crate) const SLACK: f64 = 1e-9;

/// Windows are drawn by limits wider than those of the trial.
pub(crate) const WIDER: f64 = 2.0 * SLACK;

/// The ends of a window move out by this share of themselves.
pub(crate) const HAIR: f64 = 1e-12;

/// `1.5·2¹²`: a sum with it has 40 bits behind the point.
pub(crate) const GRID_SHIFT: f64 = 6144.0;

/// Objectives from this size on are not rounded.
pub(crate) const GRID_END: f64 = 2048.0;

/// `2⁻⁴⁰`: the distance of two points of the grid of objectives.
pub(crate) const GRID_STEP: f64 = 1.0 / (1_u64 << 40) as f64;

/// `2¹³ + 1`: a product with it, and what is left after taking away the rest, has 40 bits.
pub(crate) const RELATIVE_GRID: f64 = 8193.0;

/// `2⁻³⁹`: the distance of two numbers of 40 bits over the power of two at or below them.
pub(crate) const RELATIVE_STEP: f64 = 2.0 * GRID_STEP;

/// `2⁻⁵³`: the most that one operation on doubles misses, over its result.
pub(crate) const ROUNDING: f64 = f64::EPSILON / 2.0;

/// Exact values so near half-way between two points of the grid, over their distance, belong to the upper.
pub(crate) const TIE: f64 = 1e-15;

/// A first look does not decide where a figure is within this of its limit, over 1 and the limit.
pub(crate) const LOOK: f64 = 1e-12;

/// A first look does not leave out what is within this of the bound, over 1 and the bound.
pub(crate) const BEHIND: f64 = 1e-9;

/// A first look does not decide where terms are this many times their difference.
pub(crate) const CANCELLED: f64 = 1e5;

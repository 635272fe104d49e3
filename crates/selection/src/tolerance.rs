//! What counts as nothing in this crate.
//!
//! | constant | of | why this size |
//! |---|---|---|
//! | `SLACK` | a measured value beyond its limit, over 1 and the value | what was chosen to lie at a limit misses it by the rounding of some dozen operations, 1e-13 |
//! | `WIDER` | a limit by which a window is drawn, over 1 and the limit | twice `SLACK`: a window lets through all that the trial lets through |
//! | `HAIR` | the ends of a window, relative | the roots at which it ends are rounded |
//! | `GRID_SHIFT` | objectives: adding and taking it away leaves a multiple of 2⁻⁴⁰ ≈ 1e-12 | designs that differ by rounding are one |
//! | `GRID_END` | objectives that are their own grid | beyond, doubles are coarser than the shift keeps |
//! | `GRID_STEP` | objectives: the distance of two points of the grid | of the shift |
//! | `RELATIVE_GRID` | the cube of the size: multiplied and taken away leaves 40 bits | its rounding grows with it, so its grid does |
//! | `RELATIVE_STEP` | the same: the distance of two points over the power of two below | 40 bits |
//! | `ROUNDING` | the relative error of one operation on doubles | half of their last bit |
//! | `LOOK` | a figure of a first look near its limit, over 1 and the limit: measured | a hundred times the rounding of a look, and still next to none |
//! | `BEHIND` | a first objective of a first look near a bound, over 1 and the bound: measured | above the grid of objectives and what `CANCELLED` leaves |
//! | `CANCELLED` | the terms of a difference over the difference, in a first look | leaves 2e-10 of a double's digits |
//! | `TIE` | exact values half-way between points of the grid | far beyond what a sum of two doubles loses, 2⁻¹⁰⁰ |

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

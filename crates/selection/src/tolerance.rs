//! What counts as nothing in this crate.
//!
//! | constant | of | why this size |
//! |---|---|---|
//! | `SLACK` | a measured value beyond its limit, over 1 and the value | what was chosen to lie at a limit misses it by the rounding of some dozen operations, 1e-13 |
//! | `WIDER` | a limit by which a window is drawn, over 1 and the limit | twice `SLACK`: a window lets through all that the trial lets through |
//! | `HAIR` | the ends of a window, relative | the roots at which it ends are rounded |
//! | `GRID_SHIFT` | objectives: adding and taking it away leaves a multiple of 2⁻⁴⁰ ≈ 1e-12 | designs that differ by rounding are one |
//! | `GRID_END` | objectives that are their own grid | beyond, doubles are coarser than the shift keeps |

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

//! Tolerances of this crate: differences that count as zero, and the smallest values accepted.
//!
//! - `SAME_M`: a difference of two bores, m. It is a millionth of a millimetre, because millimetres in binary
//!   are not exact.
//! - `SAME`: a difference of two modules or pressure angles, over the larger. Two spellings of one number in
//!   different units differ by a few units in the last place.
//! - `ROUNDING`: a shortfall of a diameter, over the diameter; the rounding of a cube root.
//! - `LEAST_EFFICIENCY`: an efficiency of a mesh, far below any gear.
//! - `GAP`: a gap between planets short of its limit, in modules; rounding of lengths in a file, since the
//!   rules of practice allow less than `TOUCH`.
//! - `TOUCH`: a gap between two circles, in modules; rounding of a sine or cosine times a centre distance.
//! - `PRESSED`: a backlash, in modules; shifts that leave none are sums of rounded involutes.
//! - `AT_POSITION`: a stated angle beside an assembly position, in positions; degrees with two decimals, of
//!   some hundred teeth.
//! - `AT_ANGLE`: the same, rad; degrees with one decimal, since few positions are far apart.
//! - `WITHIN`: what the ends of a tolerance are widened by; the exact ratio decides then.
//! - `BESIDE`: a zero of a linear function beside a whole number of teeth, and a value over its terms.
//! - `PLAIN`: a number in a message; as a plain decimal its zeros would hide a smaller one.

/// Bores that differ by less are the same.
pub(crate) const SAME_M: f64 = 1e-9;

/// Modules and pressure angles that differ by less than this share of the larger are the same.
pub(crate) const SAME: f64 = 1e-12;

/// A listed diameter counts as thick enough when it falls short by less than this fraction: a shaft needed to
/// be exactly 50 mm must not become 53 mm by the rounding of a cube root.
pub(crate) const ROUNDING: f64 = 1e-12;

/// The least efficiency accepted: products and reciprocals over all sets of a gearbox stay finite.
pub(crate) const LEAST_EFFICIENCY: f64 = 1e-6;

/// Circles with a gap below this many modules only touch.
pub(crate) const TOUCH: f64 = 1e-9;

/// A gap between planets is its limit within this, in modules.
pub(crate) const GAP: f64 = 1e-10;

/// Teeth thicker than their pitch by less than this many modules just fill it.
pub(crate) const PRESSED: f64 = 1e-9;

/// Smaller numbers are written with an exponent.
pub(crate) const PLAIN: f64 = 1e-6;

/// Ends of a tolerance are this much wider, relatively, before the exact ratio decides.
pub(crate) const WITHIN: f64 = 1e-12;

/// Zeros of a linear function of a tooth number are known to this many teeth, its values to this share of
/// their terms.
pub(crate) const BESIDE: f64 = 1e-6;

/// Planets at stated angles are at an assembly position within this part of the way to the next.
pub(crate) const AT_POSITION: f64 = 0.02;

/// And no farther from it than this angle, rad.
pub(crate) const AT_ANGLE: f64 = 1e-3;

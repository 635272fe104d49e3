//! Tolerances below which a value counts as zero, and limits of size, in one place.
//!
//! # Tolerances
//! Entries give the constant, the value it limits, and the reason for its size:
//! - `ERROR_FACTOR`: a number in an elimination; its own error bound, which is carried along with it.
//! - `POWER`: a power or torque, over the largest inside the gear; rounding leaves 1e-14 of it, and a set
//!   that carries less is idle.
//! - `SLOPE`: `∂ln i/∂ln i₀` of a set, over the largest; as `POWER`, but after a second elimination.
//! - `LOOP`: a flow in the graph of powers, over the largest; the differences of flows lose two more digits.
//! - `PIVOT`: a pivot of a gear solved at other ratios than its own; at its own the rank is proved.
//! - `SHARP`: the error bound of a speed, over the speed; a less certain speed is computed again without
//!   rounding.
//! - `POLE`: a torque with losses, over the largest without; beyond it no finite torque keeps the gear
//!   moving.
//! - `ALIKE`: a difference of two efficiencies, over 1 and their size; two sign patterns with less are one.
//! - `SPEED`: a difference of speeds, over the larger; speeds are known to 1e-13 of the largest.
//! - `LATE`, `LEAST_WEIGHT`: the weight of a number as a pivot, by the size of its error bound. A number
//!   known to six digits or fewer has the least weight, so that a better known one is taken first.
//! - `FLAT`: the cosine of a triangle beyond ±1; rounding of sides that lie on one line.
//! - `PRINTED_SHIFTS`: the overlap of flanks, in modules; two shifts of four decimals.
//! - `TOUCH`: the overlap of two circles, in modules; rounding of a sine times a centre distance.
//! - `AT_POSITION`: the distance of a planet from an assembly position, over that of two such positions;
//!   angles in degrees with two digits, of some hundred teeth.
//! - `AT_ANGLE`: the same distance, rad; angles in degrees with one digit; few positions are far apart.
//! - `APART`: the angle between two planets, in turns; angles in degrees with six digits.
//! - `NO_TORQUE`: the torque of a carrier, over the largest of its set; torques with losses are known to
//!   1e-11, and less is no evidence of the pins' load.
//!
//! # Limits of size
//! | constant | limits |
//! |---|---|
//! | [`MOST_SETS`] | planet sets and pairs of a gearbox |
//! | [`MOST_LINKS`] | links |
//! | [`MOST_ELEMENTS`] | shift elements |
//! | [`MOST_GEARS`] | gears |
//! | [`MOST_DRAGS`] | drags that are of no shift element |
//! | [`MOST_MEMBERS`] | central gears of one set |
//! | [`MOST_PLANETS`] | planets of one set that differ |
//! | [`MOST_ALIKE`] | how many of one planet stand around the axis |
//! | [`MOST_SYMBOLS`] | symbols of a formula |
//! | [`BASIC_RATIO`] | size of a basic ratio, and of its inverse |
//! | [`LARGEST_LOAD`] | a speed in rad/s or torque in N·m from outside |
//! | [`SPREAD`] | product of the basic ratios of a gearbox |

/// Least size of a number that is certainly not zero, in multiples of its error bound.
pub(crate) const ERROR_FACTOR: f64 = 4.0;

/// A power below this share of the largest internal power is none: no loss and no sign.
pub(crate) const POWER: f64 = 1e-11;

/// A derivative below this share of the largest is none.
pub(crate) const SLOPE: f64 = 1e-9;

/// A flow below this share of the largest power is none.
pub(crate) const LOOP: f64 = 1e-12;

/// A pivot below this has vanished.
pub(crate) const PIVOT: f64 = 1e-14;

/// A speed is certain where its error bound is below this share of it.
pub(crate) const SHARP: f64 = 1e-11;

/// A torque above this multiple of the largest without losses is on the way to infinity.
pub(crate) const POLE: f64 = 1e8;

/// Speeds that differ by less than this share of the larger are equal.
pub(crate) const SPEED: f64 = 1e-10;

/// Efficiencies that differ by less are alike.
pub(crate) const ALIKE: f64 = 1e-12;

/// Factor of the error bound in a pivot's weight: the weight is the size of the number less this multiple of
/// its error bound.
pub(crate) const LATE: f64 = 1e6;

/// The least weight of a pivot, over its size.
pub(crate) const LEAST_WEIGHT: f64 = 1e-6;

/// Rounding that the cosine of a flat triangle may have.
pub(crate) const FLAT: f64 = 1e-9;

/// Teeth of a described set may be thicker than their pitch by this many modules: shifts printed to four
/// digits leave as much.
pub(crate) const PRINTED_SHIFTS: f64 = 5e-4;

/// A length in modules below which two circles only touch.
pub(crate) const TOUCH: f64 = 1e-9;

/// A planet is at an assembly position within this part of the way to the next.
pub(crate) const AT_POSITION: f64 = 0.02;

/// And no farther from it than this angle.
pub(crate) const AT_ANGLE: f64 = 1e-3;

/// Planets nearer to each other, in turns, are at one angle.
pub(crate) const APART: f64 = 1e-9;

/// A carrier torque below this share of the largest torque of its set is none.
pub(crate) const NO_TORQUE: f64 = 1e-9;

/// Largest number of planet sets and pairs in a gearbox.
pub const MOST_SETS: usize = 64;

/// Largest number of links in a gearbox besides the housing.
pub const MOST_LINKS: usize = 256;

/// Largest number of brakes, clutches and one-way clutches in a gearbox.
pub const MOST_ELEMENTS: usize = 128;

/// Largest number of gears in a gearbox.
pub const MOST_GEARS: usize = 1000;

/// Number of faults after which a description is checked no further.
pub(crate) const MOST_FAULTS: usize = 50;

/// Largest number of drags in a gearbox besides those of its shift elements.
pub const MOST_DRAGS: usize = 256;

/// Largest number of central gears and planet shafts in a set.
pub const MOST_MEMBERS: usize = 12;

/// Largest number of different planets in a set.
pub const MOST_PLANETS: usize = 12;

/// Largest number of planets of one kind around the axis.
pub const MOST_ALIKE: u32 = 1000;

/// Largest number of symbols in the formula of a ratio: with 12 it may have 4096 terms.
pub const MOST_SYMBOLS: usize = 12;

/// Largest size of a basic ratio; its inverse is the smallest.
///
/// Within it every quantity of a gear keeps its digits; a ratio beyond it is a typing error.
pub const BASIC_RATIO: f64 = 1e9;

/// Largest size of a speed in rad/s or of a torque in N·m from outside: all results are then numbers too.
pub const LARGEST_LOAD: f64 = 1e50;

/// Largest product of `1 + |i|`, or `1 + 1/|i|` where that is larger, over the basic ratios of a gearbox.
///
/// No ratio of links in series is larger. Beyond this limit speeds and torques exceed the range of numbers.
pub const SPREAD: f64 = 1e200;

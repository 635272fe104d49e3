//! Masses of parts beside gears, carriers and housing, by rules.
//!
//! The rules are usual of the trade; none is measured. Each says what it was compared with.

use crate::sizing::STEEL;
use epicyclic_units::Physical;
use std::f64::consts::FRAC_PI_4;
use uom::si::f64::{Length, Mass, Torque};

/// Density of aluminium in kg/m³.
const ALUMINIUM: f64 = 2700.0;

/// Length and bore of the motor adapter of a servo gearbox, over the side of its flange.
const ADAPTER: [f64; 2] = [0.35, 0.6];

/// Length and bore of the body behind the output flange of a servo gearbox, over the side of the flange.
const BODY: [f64; 2] = [0.25, 0.5];

/// Diameter and length of the clamping hub for the motor's shaft, over the side of the flange.
const HUB: f64 = 0.35;

/// Volume of both output bearings with their seal, over the third power of the side of the flange.
const OUTPUT_BEARINGS: f64 = 0.04;

/// Reserve of the static torque of a shift element over the greatest torque that it carries.
const RESERVE: f64 = 1.5;

/// Static torque of an industrial multi-disc brake or clutch with its housing over its mass, in N·m/kg.
pub const INDUSTRIAL_DISCS: f64 = 90.0;

/// Static torque of a pack of discs in the gearbox of a car, which shares drums and pistons, over its mass,
/// in N·m/kg.
pub const CAR_DISCS: f64 = 300.0;

/// Mass of the flanges of a servo gearbox: motor adapter, clamping hub, body of the output with its two
/// bearings. The side of the square flange is the outside diameter of the largest ring.
///
/// ```text
/// M = s³·(ρ_Al·0.35·(1 − π/4·0.6²) + ρ·(0.25·(1 − π/4·0.5²) + π/4·0.35³ + 0.04))
/// ```
///
/// The proportions are usual of such gearboxes. Makers' catalogues give gearboxes of one stage, as a whole,
/// 4 to 5.5 kg over the third power of the side in dm.
///
/// ```
/// use epicyclic_strength::masses::servo_flanges;
/// use uom::si::{f64::Length, length::millimeter, mass::kilogram};
///
/// let mass = servo_flanges(Length::new::<millimeter>(90.0));
/// assert!((1.8..2.4).contains(&mass.get::<kilogram>()));
/// ```
#[must_use]
pub fn servo_flanges(side: Length) -> Mass {
    let square = |[length, bore]: [f64; 2]| length * (1.0 - FRAC_PI_4 * bore * bore);
    let steel = square(BODY) + FRAC_PI_4 * HUB.powi(3) + OUTPUT_BEARINGS;
    Mass::from_si(side.si().powi(3) * (ALUMINIUM * square(ADAPTER) + STEEL * steel))
}

/// Mass of a multi-disc brake or clutch by the greatest torque that it carries, in either direction, and its
/// static torque over its mass in N·m/kg: [`INDUSTRIAL_DISCS`] or [`CAR_DISCS`].
///
/// ```text
/// M = 1.5·T/t        t = 90 N·m/kg, of cars 300 N·m/kg
/// ```
///
/// Makers' catalogues of industrial brakes and clutches have 60 to 120 N·m/kg.
#[must_use]
pub fn shift_element(torque: Torque, torque_over_mass: f64) -> Mass {
    Mass::from_si(RESERVE * torque.si().abs() / torque_over_mass)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By a second sum of the same parts, one by one, for a side of 1 dm.
    #[test]
    fn flanges_are_the_sum_of_their_parts() {
        let side = 0.1;
        let adapter = 2700.0 * (side * side - FRAC_PI_4 * 0.06_f64.powi(2)) * 0.035;
        let body = 7850.0 * (side * side - FRAC_PI_4 * 0.05_f64.powi(2)) * 0.025;
        let hub = 7850.0 * FRAC_PI_4 * 0.035_f64.powi(2) * 0.035;
        let bearings = 7850.0 * 40e-6;
        let whole = servo_flanges(Length::from_si(side)).si();
        assert!((whole - adapter - body - hub - bearings).abs() < 1e-12, "{whole}");
        let twice = servo_flanges(Length::from_si(2.0 * side)).si();
        assert!((twice / whole - 8.0).abs() < 1e-12);
    }

    #[test]
    fn a_shift_element_weighs_the_same_in_both_directions() {
        let [one, other] =
            [60.0, -60.0].map(|torque| shift_element(Torque::from_si(torque), INDUSTRIAL_DISCS).si());
        assert!((one - 1.0).abs() < 1e-12 && one == other, "{one} {other}");
    }
}

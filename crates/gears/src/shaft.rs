//! Shaft diameters by a low allowable torsional stress, and the standard diameters they are rounded up to.
//!
//! A first sizing: bending is not calculated but allowed for by a low allowable stress. Left out: fatigue,
//! key seats, stiffness.

use std::f64::consts::PI;
use std::ops::RangeInclusive;

use epicyclic_units::Physical;
use uom::si::f64::{Length, Pressure, Torque};

use crate::checks::{length_from_to, positive_length, positive_stress, positive_torque};
use crate::tolerance::ROUNDING;
use crate::{Error, Quantity};

/// Usual range of the low allowable stress `[τ]`, MPa (excavator-dynamics (3), steels 40, 15 and St6).
pub const USUAL_ALLOWABLE_STRESS_MPA: RangeInclusive<f64> = 15.0..=20.0;

/// Normal linear dimensions Ra40 from 10 to 500 mm.
///
/// Source: GOST 6636 (rounded R40 of ISO 3).
pub const STANDARD_DIAMETERS_MM: [f64; 69] = [
    10.0, 10.5, 11.0, 11.5, 12.0, 13.0, 14.0, 15.0, 16.0, 17.0, 18.0, 19.0, 20.0, 21.0, 22.0, 24.0, 25.0,
    26.0, 28.0, 30.0, 32.0, 34.0, 36.0, 38.0, 40.0, 42.0, 45.0, 48.0, 50.0, 53.0, 56.0, 60.0, 63.0, 67.0,
    71.0, 75.0, 80.0, 85.0, 90.0, 95.0, 100.0, 105.0, 110.0, 120.0, 125.0, 130.0, 140.0, 150.0, 160.0, 170.0,
    180.0, 190.0, 200.0, 210.0, 220.0, 240.0, 250.0, 260.0, 280.0, 300.0, 320.0, 340.0, 360.0, 380.0, 400.0,
    420.0, 450.0, 480.0, 500.0,
];

/// Diameter `d` of a solid shaft that carries a torque at the allowable stress.
///
/// ```text
/// d = (16·T/(π·[τ]))^(1/3)
/// ```
///
/// | symbol | argument | meaning | unit |
/// |---|---|---|---|
/// | `T` | `torque` | magnitude of the torque | N·m |
/// | `[τ]` | `allowable_stress` | low allowable torsional stress | Pa |
///
/// # Errors
/// [`Error::NotPositive`] for either.
///
/// # Source
/// excavator-dynamics (3). Its own shafts, 50, 60 and 90 mm, fall short of it at every stress of its range.
///
/// # Example
/// ```
/// use epicyclic_gears::shaft;
/// use uom::si::{f64::{Pressure, Torque}, length::millimeter, pressure::megapascal, torque::newton_meter};
///
/// let needed = shaft::diameter(Torque::new::<newton_meter>(521.8), Pressure::new::<megapascal>(20.0))?;
/// assert!((needed.get::<millimeter>() - 51.0).abs() < 0.05);
/// # Ok::<(), epicyclic_gears::Error>(())
/// ```
pub fn diameter(torque: Torque, allowable_stress: Pressure) -> Result<Length, Error> {
    hollow_diameter(torque, allowable_stress, 0.0)
}

/// Outside diameter `d` of a hollow shaft with the bore `c·d`.
///
/// ```text
/// d = (16·T/(π·[τ]·(1 − c⁴)))^(1/3)
/// ```
///
/// `c` (`bore_ratio`) is inside over outside diameter; the other symbols are those of [`diameter`].
///
/// # Errors
/// [`Error::NotPositive`] for torque or stress, [`Error::OutOfRange`] for a ratio outside 0 ≤ c < 1.
///
/// # Example
/// ```
/// use epicyclic_gears::shaft;
/// use uom::si::{f64::{Pressure, Torque}, pressure::megapascal, torque::newton_meter};
///
/// let (torque, stress) = (Torque::new::<newton_meter>(521.8), Pressure::new::<megapascal>(20.0));
/// let growth = shaft::hollow_diameter(torque, stress, 0.5)? / shaft::diameter(torque, stress)?;
/// assert!((growth.value - (16.0_f64 / 15.0).cbrt()).abs() < 1e-12);
/// # Ok::<(), epicyclic_gears::Error>(())
/// ```
pub fn hollow_diameter(torque: Torque, allowable_stress: Pressure, bore_ratio: f64) -> Result<Length, Error> {
    let torque_nm = positive_torque(torque)?;
    let stress_pa = positive_stress(Quantity::AllowableStress, allowable_stress)?;
    if !(0.0..1.0).contains(&bore_ratio) {
        return Err(Error::OutOfRange {
            quantity: Quantity::BoreRatio,
            value: bore_ratio,
            low: 0.0,
            high: 1.0,
            unit: "",
        });
    }
    Ok(Length::from_si(libm::cbrt(16.0 * torque_nm / (PI * stress_pa * (1.0 - bore_ratio.powi(4))))))
}

/// Torsional stress `τ` in a solid shaft: what a given diameter makes of [`diameter`]'s formula.
///
/// ```text
/// τ = 16·T/(π·d³)
/// ```
///
/// A shaft satisfies the formula when this does not exceed `[τ]`.
///
/// # Errors
/// [`Error::NotPositive`] for torque or diameter.
///
/// # Example
/// ```
/// use epicyclic_gears::shaft;
/// use uom::si::{f64::{Length, Torque}, length::millimeter, pressure::megapascal, torque::newton_meter};
///
/// let stress =
///     shaft::torsional_stress(Torque::new::<newton_meter>(521.8), Length::new::<millimeter>(50.0))?;
/// assert!(stress.get::<megapascal>() > *shaft::USUAL_ALLOWABLE_STRESS_MPA.end());
/// # Ok::<(), epicyclic_gears::Error>(())
/// ```
pub fn torsional_stress(torque: Torque, diameter: Length) -> Result<Pressure, Error> {
    hollow_torsional_stress(torque, diameter, Length::from_si(0.0))
}

/// Torsional stress `τ` at the outside of a hollow shaft.
///
/// ```text
/// τ = 16·T·d/(π·(d⁴ − d_i⁴))
/// ```
///
/// `d`, `d_i`: outside and inside diameter.
///
/// # Errors
/// [`Error::NotPositive`] for torque or outside diameter, [`Error::OutOfRange`] unless 0 ≤ d_i < d.
///
/// # Example
/// ```
/// use epicyclic_gears::shaft;
/// use uom::si::{f64::{Length, Torque}, length::millimeter, torque::newton_meter};
///
/// let mm = Length::new::<millimeter>;
/// let torque = Torque::new::<newton_meter>(521.8);
/// let ratio = shaft::hollow_torsional_stress(torque, mm(60.0), mm(30.0))?
///     / shaft::torsional_stress(torque, mm(60.0))?;
/// assert!((ratio.value - 16.0 / 15.0).abs() < 1e-12);
/// # Ok::<(), epicyclic_gears::Error>(())
/// ```
pub fn hollow_torsional_stress(torque: Torque, outside: Length, inside: Length) -> Result<Pressure, Error> {
    let torque_nm = positive_torque(torque)?;
    let outside_m = positive_length(Quantity::ShaftDiameter, outside)?;
    let inside_m = length_from_to(Quantity::ShaftBore, inside, 0.0, outside_m)?;
    Ok(Pressure::from_si(16.0 * torque_nm * outside_m / (PI * (outside_m.powi(4) - inside_m.powi(4)))))
}

/// The smallest of [`STANDARD_DIAMETERS_MM`] that is not below `needed`.
///
/// # Errors
/// [`Error::NotPositive`] for the length, [`Error::NoStandardDiameter`] above 500 mm.
///
/// # Source
/// GOST 6636, series Ra40.
///
/// # Example
/// ```
/// use epicyclic_gears::shaft;
/// use uom::si::{
///     f64::{Length, Pressure, Torque}, length::millimeter, pressure::megapascal, torque::newton_meter,
/// };
///
/// let needed = shaft::diameter(Torque::new::<newton_meter>(521.8), Pressure::new::<megapascal>(20.0))?;
/// assert_eq!(shaft::standard_diameter(needed)?, Length::new::<millimeter>(53.0));
/// # Ok::<(), epicyclic_gears::Error>(())
/// ```
pub fn standard_diameter(needed: Length) -> Result<Length, Error> {
    let enough_m = positive_length(Quantity::NeededShaftDiameter, needed)? * (1.0 - ROUNDING);
    STANDARD_DIAMETERS_MM.into_iter().map(Length::from_mm).find(|listed| listed.si() >= enough_m).ok_or_else(
        || {
            let largest_mm = STANDARD_DIAMETERS_MM.into_iter().fold(0.0, f64::max);
            Error::NoStandardDiameter { needed_mm: needed.mm(), largest_mm }
        },
    )
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn torque(value_nm: f64) -> Torque {
        Torque::from_si(value_nm)
    }

    fn allowable(value_mpa: f64) -> Pressure {
        Pressure::from_mpa(value_mpa)
    }

    #[test]
    fn torque_of_a_round_diameter_by_hand() {
        // d = 100 mm, τ = 16 MPa: T = π·16e6·1e-3/16 = 1000·π N·m.
        let found = diameter(torque(1000.0 * PI), allowable(16.0)).unwrap();
        assert!((found.mm() - 100.0).abs() < 1e-9);
        let back = torsional_stress(torque(1000.0 * PI), Length::from_mm(100.0)).unwrap();
        assert!((back.mpa() - 16.0).abs() < 1e-9);
    }

    #[test]
    fn shafts_of_the_excavator_drive_do_not_satisfy_its_formula() {
        for (torque_nm, given_mm, at_20_mpa, at_15_mpa, standard_mm) in [
            (521.8, 50.0, 51.0, 56.2, 53.0),
            (1012.3, 60.0, 63.6, 70.0, 67.0),
            (2974.26, 90.0, 91.2, 100.3, 95.0),
        ] {
            let needed = diameter(torque(torque_nm), allowable(20.0)).unwrap();
            assert!((needed.mm() - at_20_mpa).abs() <= 0.05);
            let needed_at_15 = diameter(torque(torque_nm), allowable(15.0)).unwrap();
            assert!((needed_at_15.mm() - at_15_mpa).abs() <= 0.05);
            let stress = torsional_stress(torque(torque_nm), Length::from_mm(given_mm)).unwrap();
            assert!(stress.mpa() > *USUAL_ALLOWABLE_STRESS_MPA.end());
            assert!((standard_diameter(needed).unwrap().mm() - standard_mm).abs() < 1e-9);
        }
    }

    #[test]
    fn refused_shafts_say_why() {
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let refused = diameter(torque(bad), allowable(20.0));
            assert!(matches!(
                refused,
                Err(Error::NotPositive { quantity: Quantity::Torque, unit: "N·m", .. })
            ));
            let refused = diameter(torque(1.0), allowable(bad));
            assert!(matches!(
                refused,
                Err(Error::NotPositive { quantity: Quantity::AllowableStress, unit: "MPa", .. })
            ));
            let refused = torsional_stress(torque(1.0), Length::from_mm(bad));
            assert!(matches!(refused, Err(Error::NotPositive { quantity: Quantity::ShaftDiameter, .. })));
            assert!(matches!(standard_diameter(Length::from_mm(bad)), Err(Error::NotPositive { .. })));
        }
        for bad in [-0.1, 1.0, f64::NAN] {
            let refused = hollow_diameter(torque(1.0), allowable(20.0), bad);
            assert!(matches!(refused, Err(Error::OutOfRange { quantity: Quantity::BoreRatio, .. })));
            let refused = hollow_torsional_stress(torque(1.0), Length::from_mm(1.0), Length::from_mm(bad));
            assert!(matches!(refused, Err(Error::OutOfRange { quantity: Quantity::ShaftBore, .. })));
        }
        let refused = standard_diameter(Length::from_mm(500.1));
        assert!(matches!(refused, Err(Error::NoStandardDiameter { largest_mm, .. }) if largest_mm > 499.0));
    }

    #[test]
    fn standard_diameters_are_ra40() {
        assert!(STANDARD_DIAMETERS_MM.windows(2).all(|pair| pair[0] < pair[1]));
        // Forty steps a decade, 10^(1/40) each; Ra40 rounds by less than 5 % (12 for 12.59).
        for (index, listed) in STANDARD_DIAMETERS_MM.into_iter().enumerate() {
            let exact = 10.0 * libm::pow(10_f64, index as f64 / 40.0);
            assert!((listed / exact - 1.0).abs() < 0.05, "{listed} mm stands at {exact} mm");
        }
    }

    #[test]
    fn a_listed_diameter_is_its_own_standard() {
        for listed in STANDARD_DIAMETERS_MM {
            let exactly = torque(PI * 20e6 * (listed * 1e-3).powi(3) / 16.0);
            let chosen = standard_diameter(diameter(exactly, allowable(20.0)).unwrap()).unwrap();
            assert!((chosen.mm() - listed).abs() < 1e-9);
        }
    }

    proptest! {
        #[test]
        fn the_chosen_shaft_satisfies_the_formula_and_the_next_smaller_does_not(
            torque_nm in 1.0_f64..300_000.0, allowable_mpa in 12.0_f64..60.0,
        ) {
            let (torque, allowable) = (torque(torque_nm), allowable(allowable_mpa));
            let needed = diameter(torque, allowable).unwrap();
            prop_assume!(needed.mm() <= 500.0);
            let chosen_mm = standard_diameter(needed).unwrap().mm();
            let ratio = |mm| (torsional_stress(torque, Length::from_mm(mm)).unwrap() / allowable).value;
            // Three times the rounding of a diameter, since the stress goes with its cube.
            prop_assert!(ratio(chosen_mm) <= 1.0 + 4.0 * ROUNDING);
            if let Some(smaller) = STANDARD_DIAMETERS_MM.into_iter().rfind(|listed| *listed < chosen_mm - 1e-6) {
                prop_assert!(ratio(smaller) > 1.0);
            }
        }

        #[test]
        fn stress_undoes_the_hollow_diameter(torque_nm in 1.0_f64..1e5, allowable_mpa in 5.0_f64..60.0, c in 0.0_f64..0.95) {
            let (torque, allowable) = (torque(torque_nm), allowable(allowable_mpa));
            let outside = hollow_diameter(torque, allowable, c).unwrap();
            let back = hollow_torsional_stress(torque, outside, outside * c).unwrap();
            prop_assert!(((back / allowable).value - 1.0).abs() < 1e-12);
        }
    }
}

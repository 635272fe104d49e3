//! Factors of the root stress and of its limit: ISO 6336-3, method B.
//!
//! ```text
//! Y_F = 6·h_Fe·cos α_Fen/(s_Fn²·cos α_n)                         lengths in modules
//! Y_S = (1.2 + 0.13·L)·q_s^(1/(1.21 + 2.3/L))      L = s_Fn/h_Fe, q_s = s_Fn/(2·ρ_F), 1 ≤ q_s < 8
//! Y_β = 1 − ε_β·β/120°                            ε_β at most 1, β at most 30°
//! Y_B = 1.6·ln(2.242·h_t/s_R), from s_R = 1.2·h_t on 1               external gears, s_R above 0.5·h_t
//! Y_B = 1.15·ln(8.324·m_n/s_R), at least 1                           internal gears, s_R above 1.75·m_n
//! Y_DT = 2.366 − 0.666·ε_αn from ε_αn = 2.05 to 2.5 and accuracy grade 4 or better, else 1
//! Y_δrelT = (1 + √(ρ'·χ))/(1 + √(ρ'·1.2))         χ = (1 + 2·q_s)/5, ρ' in mm by class and strength
//! Y_RrelT = 1.674 − 0.529·(R_z + 1)^0.1           V, GGG (perl.), GTS, Eh, IF; below R_z = 1 µm 1.12
//!         = 5.306 − 4.203·(R_z + 1)^0.01          St; 1.07
//!         = 4.299 − 3.259·(R_z + 1)^0.0058        GG, GGG (ferr.), NT, NV; 1.025
//! Y_X = 1.03 − 0.006·m_n, at least 0.85           St, V, GGG (perl.), GTS; 1 up to m_n = 5 mm
//!     = 1.05 − 0.01·m_n, at least 0.80            Eh, IF, NT, NV
//!     = 1.075 − 0.015·m_n, at least 0.70          GG, GGG (ferr.)
//! Y_M = 1/(1 − R·(1 − M)/(1 + M))
//! ```
//!
//! `s_R` is the thickness of the rim, `h_t` the height of the teeth. `R_z` in `Y_RrelT` is in µm, up to 40.
//! `R` is the ratio of the least to the greatest root stress, `M` the sensitivity to mean stress.
//!
//! `ρ'` is the slip-layer thickness. Between its listed strengths it is interpolated, beyond them it is that
//! of the nearest. For static strength `Y_δrelT` of case-hardened steel is `0.44·Y_S + 0.12`. For the other
//! classes the formula was not available, and the factor is given.
//!
//! # Source
//! ISO 6336-3:2006, clauses 6 to 10 and 13 to 15, annex B.

use super::section::RootSection;
use crate::checks::within;
use crate::material::{Class, Material};
use crate::{Error, Quantity};
use epicyclic_units::Physical;

/// `Y_F`, with the normal pressure angle, rad.
#[must_use]
pub fn form_factor(section: &RootSection, pressure_angle_rad: f64) -> f64 {
    6.0 * section.arm * libm::cos(section.load_angle_rad)
        / (section.thickness.powi(2) * libm::cos(pressure_angle_rad))
}

/// `q_s`.
#[must_use]
pub fn notch_parameter(section: &RootSection) -> f64 {
    section.thickness / (2.0 * section.fillet)
}

/// `Y_S`.
///
/// # Errors
/// [`Error::OutOfRange`] unless `1 ≤ q_s < 8`.
pub fn stress_correction(section: &RootSection) -> Result<f64, Error> {
    let notch = within(Quantity::NotchParameter, notch_parameter(section), [1.0, 8.0], "")?;
    let l = section.thickness / section.arm;
    Ok((1.2 + 0.13 * l) * libm::pow(notch, 1.0 / (1.21 + 2.3 / l)))
}

/// `Y_β`, of the helix angle in rad.
#[must_use]
pub fn helix_factor(overlap: f64, helix_rad: f64) -> f64 {
    1.0 - overlap.min(1.0) * helix_rad.to_degrees().min(30.0) / 120.0
}

/// `Y_B` of an external gear: rim thickness over tooth height.
///
/// # Errors
/// [`Error::NotAbove`] at 0.5 and below: the standard advises against such rims.
pub fn rim_factor_external(over_tooth_height: f64) -> Result<f64, Error> {
    if over_tooth_height >= 1.2 {
        return Ok(1.0);
    }
    if over_tooth_height > 0.5 {
        return Ok(1.6 * libm::log(2.242 / over_tooth_height));
    }
    Err(Error::NotAbove { quantity: Quantity::RimOverHeight, value: over_tooth_height, low: 0.5, unit: "" })
}

/// `Y_B` of an internal gear: rim thickness over module.
///
/// # Errors
/// [`Error::NotAbove`] at 1.75 and below.
pub fn rim_factor_internal(over_module: f64) -> Result<f64, Error> {
    if over_module >= 3.5 {
        return Ok(1.0);
    }
    if over_module > 1.75 {
        // Just below its end the formula is 0.996; a thinner rim is not the stronger one.
        return Ok((1.15 * libm::log(8.324 / over_module)).max(1.0));
    }
    Err(Error::NotAbove { quantity: Quantity::RimOverModule, value: over_module, low: 1.75, unit: "" })
}

/// `Y_DT`; grade of accuracy by ISO 1328-1.
#[must_use]
pub fn deep_tooth_factor(virtual_contact_ratio: f64, accuracy_grade: u8) -> f64 {
    if virtual_contact_ratio <= 2.05 || accuracy_grade > 4 {
        1.0
    } else {
        2.366 - 0.666 * virtual_contact_ratio
    }
}

/// `Y_δrelT`.
///
/// # Errors
/// [`Error::MissingFactor`] where the class needs a strength that the material does not give.
pub fn notch_sensitivity(material: &Material, notch_parameter: f64) -> Result<f64, Error> {
    let slip = slip_layer(material)?;
    let root = |gradient: f64| 1.0 + (slip * gradient).sqrt();
    Ok(root((1.0 + 2.0 * notch_parameter) / 5.0) / root(1.2))
}

/// `Y_δrelT` for static strength.
///
/// # Errors
/// [`Error::MissingFactor`] of every class but case- and surface-hardened steel.
pub fn static_notch_sensitivity(class: Class, stress_correction: f64) -> Result<f64, Error> {
    match class {
        Class::CaseHardened | Class::SurfaceHardened => Ok(0.44 * stress_correction + 0.12),
        _ => Err(Error::MissingFactor {
            symbol: crate::symbol::Symbol::StaticNotchSensitivity,
            because: "its formula is known of case- and surface-hardened steel alone; give it",
        }),
    }
}

/// Strengths, N/mm², and slip-layer thicknesses, mm.
const THROUGH: [(f64, f64); 4] = [(500.0, 0.0281), (600.0, 0.0194), (800.0, 0.0064), (1000.0, 0.0014)];
const STRUCTURAL: [(f64, f64); 2] = [(300.0, 0.0833), (400.0, 0.0445)];
const GREY: [(f64, f64); 2] = [(150.0, 0.3124), (300.0, 0.3095)];

/// `ρ'`, mm.
fn slip_layer(material: &Material) -> Result<f64, Error> {
    let points: &[(f64, f64)] = match material.class {
        Class::CaseHardened | Class::SurfaceHardened => return Ok(0.0030),
        Class::Nitrided | Class::ThroughHardenedNitrided | Class::Nitrocarburized => return Ok(0.1005),
        Class::ThroughHardened | Class::NodularPearlitic | Class::Malleable => &THROUGH,
        Class::Structural => &STRUCTURAL,
        Class::GreyIron | Class::NodularFerritic => &GREY,
    };
    let strength = material.strength.map(Physical::mpa).ok_or(Error::MissingFactor {
        symbol: crate::symbol::Symbol::NotchSensitivity,
        because: "the material's class asks for its yield or tensile strength",
    })?;
    let (least, greatest) = (points[0], points[points.len() - 1]);
    let piece = points.windows(2).find(|piece| strength >= piece[0].0 && strength < piece[1].0);
    Ok(match piece {
        Some(piece) => {
            let [(s1, r1), (s2, r2)] = [piece[0], piece[1]];
            r1 + (strength - s1) / (s2 - s1) * (r2 - r1)
        }
        None if strength < least.0 => least.1,
        None => greatest.1,
    })
}

/// Greatest `R_z` that the formulas of `Y_RrelT` hold for, µm.
pub(crate) const MOST_ROOT_ROUGHNESS: f64 = 40.0;

/// `Y_RrelT`, of the root's `R_z` in µm.
///
/// # Errors
/// [`Error::OutOfRange`] above 40 µm.
pub fn surface_factor(class: Class, roughness_um: f64) -> Result<f64, Error> {
    let rz = within(Quantity::RootRoughness, roughness_um, [0.0, MOST_ROOT_ROUGHNESS], "µm")?;
    let (smooth, constant, slope, exponent) = match class {
        Class::Structural => (1.07, 5.306, 4.203, 0.01),
        Class::GreyIron
        | Class::NodularFerritic
        | Class::Nitrided
        | Class::ThroughHardenedNitrided
        | Class::Nitrocarburized => (1.025, 4.299, 3.259, 0.0058),
        Class::ThroughHardened
        | Class::NodularPearlitic
        | Class::Malleable
        | Class::CaseHardened
        | Class::SurfaceHardened => (1.12, 1.674, 0.529, 0.1),
    };
    Ok(if rz < 1.0 { smooth } else { constant - slope * libm::pow(rz + 1.0, exponent) })
}

/// `Y_X`, of the normal module in mm.
#[must_use]
pub fn size_factor(class: Class, module_mm: f64) -> f64 {
    if module_mm <= 5.0 {
        return 1.0;
    }
    match class {
        Class::Structural | Class::ThroughHardened | Class::NodularPearlitic | Class::Malleable => {
            (1.03 - 0.006 * module_mm).max(0.85)
        }
        Class::GreyIron | Class::NodularFerritic => (1.075 - 0.015 * module_mm).max(0.70),
        Class::CaseHardened
        | Class::SurfaceHardened
        | Class::Nitrided
        | Class::ThroughHardenedNitrided
        | Class::Nitrocarburized => (1.05 - 0.01 * module_mm).max(0.80),
    }
}

/// Bending of a tooth.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Bending {
    /// Bending to one side alone: `Y_M` = 1.
    #[default]
    OneWay,
    /// Bending to both sides alike in each revolution, as the teeth of a planet or an idler: `Y_M` = 0.7.
    Reversed,
    /// Bending with a ratio of the least to the greatest stress.
    Ratio {
        /// Stress ratio `R`, −1.2 to 0.5; below 0 the tooth is bent back.
        stress_ratio: f64,
        /// Sensitivity `M` to mean stress, 0 to 1.
        sensitivity: f64,
    },
}

/// `Y_M`.
///
/// # Errors
/// [`Error::OutOfRange`] for a ratio or sensitivity outside its range.
pub fn mean_stress_factor(bending: Bending) -> Result<f64, Error> {
    match bending {
        Bending::OneWay => Ok(1.0),
        Bending::Reversed => Ok(0.7),
        Bending::Ratio { stress_ratio, sensitivity } => {
            let r = within(Quantity::StressRatio, stress_ratio, [-1.2, 0.5], "")?;
            let m = within(Quantity::MeanStressSensitivity, sensitivity, [0.0, 1.0], "")?;
            Ok(1.0 / (1.0 - r * (1.0 - m) / (1.0 + m)))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rims_thinner_than_the_standard_allows_are_refused() {
        assert!((rim_factor_external(0.8).unwrap() - 1.6 * libm::log(2.242_f64 / 0.8)).abs() < 1e-12);
        // Both formulas end at 1.
        assert!((1.6 * libm::log(2.242_f64 / 1.2) - 1.0).abs() < 1e-3);
        assert!((1.15 * libm::log(8.324_f64 / 3.5) - 1.0).abs() < 4e-3);
        let error = rim_factor_external(0.4).unwrap_err();
        assert_eq!(error.to_string(), "rim thickness over tooth height is 0.4; it must be above 0.5");
        assert!(rim_factor_internal(1.75).is_err() && rim_factor_internal(f64::NAN).is_err());
        assert_eq!(rim_factor_internal(4.0), Ok(1.0));
    }

    #[test]
    fn factors_join_where_their_pieces_meet() {
        for class in [Class::ThroughHardened, Class::Structural, Class::Nitrided] {
            // At 1 µm the standard's pieces differ by 0.013 at most.
            let [below, above] = [0.999, 1.0].map(|rz| surface_factor(class, rz).unwrap());
            assert!((below - above).abs() < 0.0131, "{class}: {below} {above}");
        }
        for class in [Class::ThroughHardened, Class::GreyIron, Class::CaseHardened] {
            assert!((size_factor(class, 5.000_001) - 1.0).abs() < 1e-6);
        }
        assert!((deep_tooth_factor(2.051, 4) - 1.0).abs() < 1e-3 && deep_tooth_factor(2.4, 5) == 1.0);
        assert_eq!(helix_factor(3.0, 1.0), 0.75);
    }

    #[test]
    fn reversed_bending_is_the_formula_of_an_idler() {
        // M of a case-hardened tooth with Y_S = 2.18: 0.8 − 0.15·Y_S.
        let ratio = Bending::Ratio { stress_ratio: -1.2, sensitivity: 0.8 - 0.15 * 2.18 };
        assert!(
            (mean_stress_factor(ratio).unwrap() - mean_stress_factor(Bending::Reversed).unwrap()).abs()
                < 1e-3
        );
        let still = Bending::Ratio { stress_ratio: 0.0, sensitivity: 0.3 };
        assert_eq!(mean_stress_factor(still), Ok(1.0));
        assert!(mean_stress_factor(Bending::Ratio { stress_ratio: -2.0, sensitivity: 0.3 }).is_err());
        assert!(mean_stress_factor(Bending::Ratio { stress_ratio: -1.0, sensitivity: 1.3 }).is_err());
    }
}

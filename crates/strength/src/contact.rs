//! Factors of the contact stress and of its limit: ISO 6336-2, method B.
//!
//! ```text
//! σ_H0 = Z_H·Z_E·Z_ε·Z_β·√(F_t/(d_1·b)·(u + 1)/u)        u = z_2/z_1, below 0 with an internal gear
//! Z_H = √(2·cos β_b·cos α_wt/(cos²α_t·sin α_wt))
//! Z_E = √(1/(π·((1 − ν_1²)/E_1 + (1 − ν_2²)/E_2)))
//! Z_ε = √((4 − ε_α)/3·(1 − ε_β) + ε_β/ε_α), from ε_β = 1 on √(1/ε_α)
//! Z_β = 1/√cos β        (√cos β before the corrigendum of 2008)
//! M_1 = tan α_wt/√((√(d_a1²/d_b1² − 1) − 2π/z_1)·(√(d_a2²/d_b2² − 1) − (ε_α − 1)·2π/z_2))
//!     = √(ρ_1C·ρ_2C/(ρ_1B·ρ_2B))
//! Z_B = M_1 of spur gears, M_1 − ε_β·(M_1 − 1) below ε_β = 1, then 1; at least 1
//! Z_D as Z_B with the gears exchanged; 1 of an internal gear
//! Z_L = C + 4·(1 − C)/(1.2 + 134/ν_40)²                     C = 0.83, σ_Hlim/4375 + 0.6357, 0.91
//! Z_v = C' + 2·(1 − C')/√(0.8 + 32/v)                        C' = C + 0.02
//! Z_R = (3/R_z10)^C_R, R_z10 = (R_z1 + R_z2)/2·(10/ρ_red)^⅓   C_R = 0.15, 0.32 − 0.0002·σ_Hlim, 0.08
//! Z_W = (1.2 − (HB − 130)/1700)·(3/R_zH)^0.15
//! R_zH = R_z1·(10/ρ_red)^0.33·(R_z1/R_z2)^0.66/(ν_40·v/1500)^0.33, from 3 to 16 µm
//!        1 the hard gear, 2 the soft one
//! ```
//!
//! The constants change at `σ_Hlim` = 850 and 1200 N/mm²; of two limits the smaller counts. `HB` is taken
//! from 130 to 470. `M_1` and `M_2` are calculated from the radii of curvature, and so hold for the active
//! tips where a root ends contact before a tip does. `Z_W` is of a soft gear in mesh with a surface-hardened
//! one, else 1: the standard's formula for two through-hardened gears is not included. `Z_X` = 1.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `F_t` | tangential force at the reference circle, of one mesh | N |
//! | `d_1`, `b` | reference diameter of the first gear, face width | mm |
//! | `ε_α`, `ε_β` | transverse contact ratio, overlap ratio | 1 |
//! | `ν_40` | viscosity of the oil at 40 °C | mm²/s |
//! | `v` | speed at the reference circle | m/s |
//! | `R_z` | roughness of the flanks | µm |
//! | `ρ_red` | reduced radius of curvature at the pitch point | mm |
//!
//! # Source
//! ISO 6336-2:2006, clauses 6 to 9 and 12 to 14.

use crate::Error;
use crate::factor::{Edition, Symbol};
use crate::material::{Class, Material};
use epicyclic_gears::involute::Pair;
use epicyclic_units::Physical;
use std::f64::consts::PI;

/// `Z_H`, of the helix angle at the base cylinder, rad.
#[must_use]
pub fn zone_factor(pair: &Pair, base_helix: f64) -> f64 {
    let first = &pair.gears()[0];
    let (cos_alpha_t, tan_alpha_wt) =
        (first.base_diameter() / first.reference_diameter(), libm::tan(pair.working_angle_rad()));
    (2.0 * libm::cos(base_helix) / tan_alpha_wt).sqrt() / cos_alpha_t
}

/// `Z_E`, √(N/mm²).
#[must_use]
pub fn elasticity_factor(materials: [&Material; 2]) -> f64 {
    let yielding = |material: &Material| {
        (1.0 - material.poisson_ratio * material.poisson_ratio) / material.youngs_modulus.mpa()
    };
    (PI * (yielding(materials[0]) + yielding(materials[1]))).sqrt().recip()
}

/// `Z_ε`.
#[must_use]
pub fn contact_ratio_factor(transverse: f64, overlap: f64) -> f64 {
    let overlap = overlap.min(1.0);
    ((4.0 - transverse) / 3.0 * (1.0 - overlap) + overlap / transverse).sqrt()
}

/// `Z_β`.
#[must_use]
pub fn helix_factor(pair: &Pair, edition: Edition) -> f64 {
    let root = libm::cos(pair.gears()[0].profile().helix_angle.si()).sqrt();
    match edition {
        Edition::Iso2006 => root,
        Edition::Iso2006Corrected => root.recip(),
    }
}

/// `Z_B` and `Z_D`, from the radii of curvature at the inner points of single contact.
///
/// # Errors
/// [`Error::MissingFactor`] where such a point would lie at or below a base circle.
pub fn single_contact_factors(pair: &Pair, overlap: f64) -> Result<[f64; 2], Error> {
    if overlap >= 1.0 {
        return Ok([1.0, 1.0]);
    }
    let [from, to] = pair.contact();
    let line = pair.centre_distance() * libm::sin(pair.working_angle_rad());
    let product = |own: f64| own * if pair.is_internal() { own + line } else { line - own };
    let at_pitch_point = product(pair.working_diameters()[0] / 2.0 * libm::sin(pair.working_angle_rad()));
    let of = |own: f64| {
        let there = product(own);
        if own > 0.0 && there > 0.0 {
            let m = (at_pitch_point / there).sqrt();
            return Ok((m - overlap * (m - 1.0)).max(1.0));
        }
        Err(Error::MissingFactor {
            symbol: Symbol::SingleContact,
            because: "the inner point of single contact lies at or below the base circle",
        })
    };
    let z_b = of(to - pair.base_pitch())?;
    let z_d = if pair.is_internal() { 1.0 } else { of(from + pair.base_pitch())? };
    Ok([z_b, z_d])
}

/// Stress of each flank at an overlap over the least that more overlap leaves: `Z_ε` and `Z_B`, `Z_D` of helical
/// teeth fall until it reaches 1.
pub(crate) fn over_full_overlap(pair: &Pair, overlap: f64) -> [f64; 2] {
    let transverse = pair.transverse_contact_ratio();
    if !pair.gears()[0].profile().is_helical() || overlap >= 1.0 {
        return [1.0; 2];
    }
    let lines = contact_ratio_factor(transverse, overlap) / contact_ratio_factor(transverse, 1.0);
    // Without an inner point of single contact nothing is rated.
    single_contact_factors(pair, overlap).unwrap_or([1.0; 2]).map(|single| single * lines)
}

/// Reduced radius of curvature at the pitch point, modules: `ρ_1·ρ_2/(ρ_1 + ρ_2)`, `ρ_2` of an internal gear
/// below 0.
#[must_use]
pub fn reduced_radius(pair: &Pair) -> f64 {
    let [first, second] =
        pair.gears().map(|gear| gear.base_diameter() / 2.0 * libm::tan(pair.working_angle_rad()));
    let second = if pair.is_internal() { -second } else { second };
    first * second / (first + second)
}

fn between(limit: f64, low: f64, middle: f64, high: f64) -> f64 {
    if limit < 850.0 {
        low
    } else if limit > 1200.0 {
        high
    } else {
        middle
    }
}

fn film_constant(limit: f64) -> f64 {
    between(limit, 0.83, limit / 4375.0 + 0.6357, 0.91)
}

/// `Z_L` of the smaller `σ_Hlim`, N/mm², and `ν_40`, mm²/s.
#[must_use]
pub fn lubricant_factor(limit: f64, viscosity: f64) -> f64 {
    let c = film_constant(limit);
    c + 4.0 * (1.0 - c) / (1.2 + 134.0 / viscosity).powi(2)
}

/// `Z_v` of the smaller `σ_Hlim`, N/mm², and `v`, m/s.
#[must_use]
pub fn velocity_factor(limit: f64, speed: f64) -> f64 {
    let c = film_constant(limit) + 0.02;
    c + 2.0 * (1.0 - c) / (0.8 + 32.0 / speed).sqrt()
}

/// `Z_R` of the smaller `σ_Hlim`, N/mm², both roughnesses, µm, and `ρ_red`, mm.
#[must_use]
pub fn roughness_factor(limit: f64, roughness: [f64; 2], reduced_radius: f64) -> f64 {
    let exponent = between(limit, 0.15, 0.32 - 0.0002 * limit, 0.08);
    let relative = f64::midpoint(roughness[0], roughness[1]) * libm::cbrt(10.0 / reduced_radius);
    libm::pow(3.0 / relative, exponent)
}

/// `Z_W` of a gear: of a soft one in mesh with a surface-hardened one, else 1. Roughness of itself and of its
/// mate, µm; `ρ_red`, mm; `ν_40`, mm²/s; `v`, m/s.
///
/// # Errors
/// [`Error::MissingFactor`] of a soft gear without hardness.
pub fn work_hardening_factor(
    [own, mate]: [&Material; 2],
    [own_roughness, mate_roughness]: [f64; 2],
    reduced_radius: f64,
    viscosity: f64,
    speed: f64,
) -> Result<f64, Error> {
    let is_soft = matches!(own.class, Class::Structural | Class::ThroughHardened | Class::NodularPearlitic);
    if !(is_soft && mate.class.is_surface_hardened()) {
        return Ok(1.0);
    }
    let hardness = own.hardness.ok_or(Error::MissingFactor {
        symbol: Symbol::WorkHardening,
        because: "the soft gear's Brinell hardness is needed",
    })?;
    let equivalent = mate_roughness
        * libm::pow(10.0 / reduced_radius, 0.33)
        * libm::pow(mate_roughness / own_roughness, 0.66)
        / libm::pow(viscosity * speed / 1500.0, 0.33);
    let softness = 1.2 - (hardness.clamp(130.0, 470.0) - 130.0) / 1700.0;
    Ok(softness * libm::pow(3.0 / equivalent.clamp(3.0, 16.0), 0.15))
}

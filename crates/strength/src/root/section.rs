//! The critical section of a tooth root, method B: load at the outer point of single contact.
//!
//! Lengths in normal modules, of the virtual spur gear `z_n`; `z`, `d` and `z_n` of an internal gear are
//! negative.
//!
//! ```text
//! z_n = z/(cos²β_b·cos β)   ε_αn = ε_α/cos²β_b   d_n = z_n   d_bn = d_n·cos α_n   d_an = d_n + d_a − d
//! ρ_v = ρ_fP                                     external gears, cut by a rack
//! ρ_v = ρ_fP + (x_0 + h_fP − ρ_fP)^1.95/(3.156·1.036^z_0)     internal gears, cut by a shaper
//! E = π/4 − h_fP·tan α_n + s_pr/cos α_n − (1 − sin α_n)·ρ_v/cos α_n
//!                                                s_pr = p_r − q, not below 0, of external gears
//! G = ρ_v − h_fP + x
//! H = 2/z_n·(π/2 − E) − T                        T = π/3, internal π/6
//! θ = 2·G/z_n·tan θ − H
//! s_Fn = z_n·sin(T − θ) + w·(G/cos θ − ρ_v)      w = √3, internal 1
//! ρ_F = ρ_v + 2·G²/(cos θ·(z_n·cos²θ − 2·G))
//! d_en = 2·√((√(d_an² − d_bn²)/2 ∓ π·cos α_n·(ε_αn − 1))² + (d_bn/2)²)      + of an internal gear
//! α_en = arccos(d_bn/d_en)
//! γ_e = (π/2 + 2·x·tan α_n)/z_n + inv α_n − inv α_en
//! α_Fen = α_en − γ_e
//! h_Fe = ½·((cos γ_e − sin γ_e·tan α_Fen)·d_en − z_n·cos(T − θ) − w'·(G/cos θ − ρ_v))
//!                                                w' = 1, internal √3
//! ```
//!
//! With `z_n` below 0 the fillet radius of a ring is that of the fillet which the virtual rack makes. A
//! commercial program prints a larger one, which follows with `|z_n|`: 0.418 instead of 0.380 for the ring of
//! the NREL reference gearbox. A shaper's true fillet is sharper still (0.370). The radius enters `Y_S`
//! alone, and `s_Fn`, `h_Fe` and `α_Fen` agree to all printed digits.
//!
//! Left out: notches from grinding (`Y_Sg`), which stock without as much protuberance leaves.
//!
//! # Source
//! ISO 6336-3:2006 with its corrigendum of 2007, clause 6.2.

use crate::checks::{not_negative, positive, within};
use crate::{Error, Quantity, tolerance};
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::InvoluteGear;
use epicyclic_gears::involute::function::involute;
use epicyclic_units::Physical;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_4, FRAC_PI_6, PI};

/// A shaper: the pinion-type cutter that makes a ring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shaper {
    /// Teeth `z_0`.
    pub teeth: u32,
    /// Profile shift coefficient `x_0`.
    pub shift: f64,
}

/// The critical section; lengths in normal modules.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RootSection {
    /// Thickness `s_Fn`.
    pub thickness: f64,
    /// Lever arm `h_Fe`.
    pub arm: f64,
    /// Fillet radius `ρ_F`.
    pub fillet: f64,
    /// Angle of the load `α_Fen`, rad.
    pub load_angle_rad: f64,
}

/// Steps after which Newton's method has ended for every gear: it takes four or five.
const MOST_STEPS: u32 = 30;

/// The critical section of a gear in a mesh with the contact ratio `ε_α`; an internal gear needs its shaper.
///
/// # Errors
/// [`Error::OutOfRange`] unless `1 ≤ ε_αn < 2.5`; [`Error::NoRootSection`] for an internal gear without
/// shaper, or where the tool leaves no section; [`Error::NotPositive`] for a shaper without teeth.
///
/// # Example
/// ```
/// use epicyclic_gears::ToothCount;
/// use epicyclic_gears::geometry::GearKind;
/// use epicyclic_gears::involute::{InvoluteGear, Profile};
/// use epicyclic_strength::root::section::section;
///
/// # fn main() -> Result<(), epicyclic_strength::Error> {
/// let sun = InvoluteGear::new(GearKind::External, ToothCount::new(18)?, Profile::default(), 0.389)?;
/// let sun = sun.with_tip_alteration(-1.75 / 21.0)?;
/// let root = section(&sun, 1.370, None)?;
/// assert!((root.thickness - 2.132).abs() < 5e-4 && (root.arm - 1.159).abs() < 5e-4);
/// # Ok(())
/// # }
/// ```
pub fn section(
    gear: &InvoluteGear,
    contact_ratio: f64,
    shaper: Option<Shaper>,
) -> Result<RootSection, Error> {
    section_of(gear, contact_ratio, shaper, gear.profile().base_helix_rad())
}

/// Root section by `section` with a known helix angle at the base cylinder, rad.
pub(crate) fn section_of(
    gear: &InvoluteGear,
    contact_ratio: f64,
    shaper: Option<Shaper>,
    base_helix: f64,
) -> Result<RootSection, Error> {
    let none = |because| Error::NoRootSection { teeth: gear.teeth().get(), because };
    let profile = gear.profile();
    let rack = &profile.rack;
    let alpha = rack.pressure_angle.si();
    let narrowing = libm::cos(base_helix).powi(2);
    let is_internal = gear.kind() == GearKind::Internal;
    let sign = if is_internal { -1.0 } else { 1.0 };
    let z = sign * gear.teeth().as_f64() / (narrowing * libm::cos(profile.helix_angle.si()));
    let contact_ratio =
        within(Quantity::ContactRatio, contact_ratio / narrowing, [1.0, MOST_CONTACT_RATIO], "")?;

    let depth = rack.addendum + rack.clearance;
    let fillet = if is_internal {
        let shaper = shaper.ok_or_else(|| none("an internal gear needs the shaper that cuts it"))?;
        virtual_fillet(depth, profile.fillet, shaper)?
    } else {
        profile.fillet
    };
    let (sin, cos, tan) = (libm::sin(alpha), libm::cos(alpha), libm::tan(alpha));
    // Undercut that the protuberance leaves when the stock is taken off.
    let residual = if is_internal { 0.0 } else { (profile.protuberance - profile.stock).max(0.0) };
    let e = FRAC_PI_4 - depth * tan + residual / cos - (1.0 - sin) * fillet / cos;
    let g = fillet - depth + gear.shift();
    let (tangent, thickness_weight, arm_weight) =
        if is_internal { (FRAC_PI_6, 1.0, ROOT_3) } else { (FRAC_PI_3, ROOT_3, 1.0) };
    let theta = theta(2.0 * g / z, 2.0 / z * (FRAC_PI_2 - e) - tangent)
        .ok_or_else(|| none("the fillet has no tangent at the standard's angle"))?;

    let cos_theta = libm::cos(theta);
    let rest = g / cos_theta - fillet;
    let thickness = z * libm::sin(tangent - theta) + thickness_weight * rest;
    let radius = fillet + 2.0 * g * g / (cos_theta * (z * cos_theta * cos_theta - 2.0 * g));

    let base = (z * cos).abs();
    let tip = z.abs() + gear.tip_diameter() - gear.reference_diameter();
    let to_tip = (tip * tip - base * base).max(0.0).sqrt() / 2.0;
    let load_radius = to_tip - sign * PI * cos * (contact_ratio - 1.0);
    if load_radius <= 0.0 {
        return Err(none("the outer point of single contact lies within the base circle"));
    }
    let load_diameter = 2.0 * libm::hypot(load_radius, base / 2.0);
    let alpha_e = libm::acos(base / load_diameter);
    let gamma = (FRAC_PI_2 + 2.0 * gear.shift() * tan) / z + (tan - alpha) - involute(alpha_e);
    let load_angle_rad = alpha_e - gamma;
    let arm = 0.5
        * ((libm::cos(gamma) - libm::sin(gamma) * libm::tan(load_angle_rad)) * sign * load_diameter
            - z * libm::cos(tangent - theta)
            - arm_weight * rest);
    if !(thickness > 0.0 && radius > 0.0) {
        return Err(none("the fillets meet or have no radius"));
    }
    if !(arm > 0.0 && load_angle_rad.abs() < FRAC_PI_2) {
        return Err(none("the load passes below the section"));
    }
    Ok(RootSection { thickness, arm, fillet: radius, load_angle_rad })
}

const ROOT_3: f64 = 1.732_050_807_568_877_2;

/// The standard's formulas hold below.
const MOST_CONTACT_RATIO: f64 = 2.5;

/// Fillet radius of the virtual rack that replaces a shaper.
fn virtual_fillet(depth: f64, fillet: f64, shaper: Shaper) -> Result<f64, Error> {
    let teeth = positive(Quantity::ShaperTeeth, f64::from(shaper.teeth), "teeth")?;
    let reach =
        not_negative(Quantity::ShaperShift, shaper.shift + depth - fillet, "modules above ρ_fP − h_fP")?;
    Ok(fillet + libm::pow(reach, 1.95) / (3.156 * libm::pow(1.036_f64, teeth)))
}

/// The root of `θ − c·tan θ + H`, by Newton's method from 30°.
fn theta(c: f64, h: f64) -> Option<f64> {
    let mut theta = FRAC_PI_6;
    for _ in 0..MOST_STEPS {
        // 1/cos² = 1 + tan².
        let tan = libm::tan(theta);
        let step = (theta - c * tan + h) / (1.0 - c * (1.0 + tan * tan));
        theta -= step;
        if theta.is_nan() || theta.abs() >= FRAC_PI_2 {
            return None;
        }
        if step.abs() <= tolerance::SAME {
            return Some(theta);
        }
    }
    None
}

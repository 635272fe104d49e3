//! The involute flank of a gear before its tips and roots: what its teeth, its basic rack and its helix fix.

use super::function::involute;
use super::profile::Profile;
use crate::ToothCount;
use crate::gear_kind::GearKind;
use epicyclic_units::Physical;
use std::f64::consts::PI;

/// Teeth and angles of a gear as the numbers that its formulas take; lengths in modules.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Flank {
    /// Teeth, negative of an internal gear.
    pub(super) z: f64,
    /// Involute function, cosine and sine of the transverse pressure angle.
    pub(super) inv_alpha_t: f64,
    pub(super) cos_alpha_t: f64,
    pub(super) sin_alpha_t: f64,
    /// Tangent and sine of the normal pressure angle.
    pub(super) tan_alpha_n: f64,
    pub(super) sin_alpha_n: f64,
    /// Cosine and tangent of the helix angle.
    pub(super) cos_beta: f64,
    pub(super) tan_beta: f64,
}

impl Flank {
    pub(super) fn new(kind: GearKind, teeth: ToothCount, profile: &Profile) -> Self {
        let alpha_t = profile.transverse_angle_rad();
        let alpha_n = profile.rack.pressure_angle.si();
        let beta = profile.helix_angle.si();
        Self {
            z: match kind {
                GearKind::External => teeth.as_f64(),
                GearKind::Internal => -teeth.as_f64(),
            },
            inv_alpha_t: involute(alpha_t),
            cos_alpha_t: libm::cos(alpha_t),
            sin_alpha_t: libm::sin(alpha_t),
            tan_alpha_n: libm::tan(alpha_n),
            sin_alpha_n: libm::sin(alpha_n),
            cos_beta: libm::cos(beta),
            tan_beta: libm::tan(beta),
        }
    }

    /// 1, or −1 of an internal gear.
    pub(super) fn sign(&self) -> f64 {
        self.z.signum()
    }

    /// Reference radius, below 0 of an internal gear.
    pub(super) fn signed_reference(&self) -> f64 {
        self.z / self.cos_beta / 2.0
    }

    /// Reference radius.
    pub(super) fn reference(&self) -> f64 {
        self.signed_reference().abs()
    }

    /// Base radius.
    pub(super) fn base(&self) -> f64 {
        self.reference() * self.cos_alpha_t
    }

    /// Half the angle of a tooth of profile shift `x` at a radius, rad.
    ///
    /// ```text
    /// ψ(r) = ±((π + 4·x·tan α_n)/(2·z) + inv α_t − inv α_yt)        − of an internal gear, z < 0
    /// ```
    pub(super) fn half_angle(&self, shift: f64, radius: f64) -> f64 {
        let half = (PI + 4.0 * shift * self.tan_alpha_n) / (2.0 * self.z);
        let tan = self.curvature(radius) / self.base();
        self.sign() * (half + self.inv_alpha_t - (tan - libm::atan(tan)))
    }

    /// Radius of curvature of the flank at a radius; 0 within the base circle.
    pub(super) fn curvature(&self, radius: f64) -> f64 {
        (radius * radius - self.base().powi(2)).max(0.0).sqrt()
    }
}

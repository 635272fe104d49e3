//! One cylindrical gear with profile shift.

use super::fault::ShiftFault;
use super::function::{angle_of_involute, involute};
use crate::gear_kind::GearKind;
use crate::rack::BasicRack;
use crate::units::{not_negative, radians};
use crate::{Error, Quantity, ToothCount};
use std::f64::consts::{FRAC_PI_2, PI};
use uom::si::f64::Angle;

/// What the teeth of gears in mesh have in common.
///
/// | symbol | field | meaning | unit | default |
/// |---|---|---|---|---|
/// | `h_aP*`, `c_P*`, `α_n` | `rack` | [`BasicRack`] | modules, ° | 1, 0.25, 20° |
/// | `ρ_fP*` | `fillet` | radius at the root of the basic rack | modules | 0.38 |
/// | `β` | `helix_angle` | helix angle at the reference cylinder | ° | 0 |
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Profile {
    /// The basic rack.
    pub rack: BasicRack,
    /// Root fillet radius `ρ_fP*` of the basic rack.
    pub fillet: f64,
    /// Helix angle `β`, without its hand.
    pub helix_angle: Angle,
}

impl Default for Profile {
    fn default() -> Self {
        Self { rack: BasicRack::default(), fillet: 0.38, helix_angle: crate::units::angle(0.0) }
    }
}

impl Profile {
    /// Spur teeth by a basic rack, with a fillet of 0.38 modules or what it has room for.
    #[must_use]
    pub fn of_rack(rack: BasicRack) -> Self {
        let usual = Self { rack, ..Self::default() };
        Self { fillet: usual.fillet.min(usual.most_fillet()).max(0.0), ..usual }
    }

    /// Refuses proportions that no rack has.
    ///
    /// # Errors
    /// Those of [`BasicRack::check`]; [`Error::OutOfRange`] unless `0 ≤ β < 60°`, or for a fillet that the rack has no room for.
    pub fn check(&self) -> Result<(), Error> {
        self.rack.check()?;
        not_negative(Quantity::RootFillet, self.fillet, "modules")?;
        let helix_deg = crate::units::degrees(self.helix_angle);
        if !(0.0..MOST_HELIX_DEG).contains(&helix_deg) {
            return Err(Error::OutOfRange {
                quantity: Quantity::HelixAngle,
                value: helix_deg,
                low: 0.0,
                high: MOST_HELIX_DEG,
                unit: "°",
            });
        }
        let most = self.most_fillet();
        if self.fillet > most {
            return Err(Error::OutOfRange {
                quantity: Quantity::RootFillet,
                value: self.fillet,
                low: 0.0,
                high: most,
                unit: "modules",
            });
        }
        Ok(())
    }

    /// The largest fillet of the rack: one arc from flank to flank of a tooth space, or one that leaves the clearance alone.
    ///
    /// ```text
    /// ρ_fP* ≤ c*/(1 − sin α_n),    ρ_fP* ≤ (π/4 − (h_aP* + c*)·tan α_n)/tan(45° − α_n/2)
    /// ```
    #[must_use]
    pub fn most_fillet(&self) -> f64 {
        let alpha = radians(self.rack.pressure_angle);
        let by_clearance = self.rack.clearance / (1.0 - libm::sin(alpha));
        let depth = self.rack.addendum + self.rack.clearance;
        let by_space = (PI / 4.0 - depth * libm::tan(alpha)) / libm::tan(PI / 4.0 - alpha / 2.0);
        // ISO 53 rounds 0.3799 to 0.38: the first bound holds to a hundredth of a module.
        by_clearance.max(0.0).min(by_space) + ROUNDED_FILLET
    }

    /// Transverse pressure angle `α_t`, rad.
    #[must_use]
    pub fn transverse_angle_rad(&self) -> f64 {
        libm::atan(libm::tan(radians(self.rack.pressure_angle)) / libm::cos(radians(self.helix_angle)))
    }

    /// Whether its teeth are helical.
    #[must_use]
    pub fn is_helical(&self) -> bool {
        radians(self.helix_angle) != 0.0
    }

    /// Helix angle at the base cylinder `β_b`, rad: `tan β_b = tan β·cos α_t`.
    #[must_use]
    pub fn base_helix_rad(&self) -> f64 {
        libm::atan(libm::tan(radians(self.helix_angle)) * libm::cos(self.transverse_angle_rad()))
    }
}

/// Helix angles of cylindrical gears stay below.
const MOST_HELIX_DEG: f64 = 60.0;

/// What the printed fillets of racks are rounded by.
const ROUNDED_FILLET: f64 = 0.01;

/// A gear as its shift makes it; lengths in modules.
///
/// ```
/// use epicyclic_gears::involute::{InvoluteGear, Profile};
/// use epicyclic_gears::{ToothCount, geometry::GearKind};
/// # fn main() -> Result<(), epicyclic_gears::Error> {
/// // The sun of a wind gearbox's second stage: 18 teeth, x = 0.389, module 21 mm.
/// let sun = InvoluteGear::new(GearKind::External, ToothCount::new(18)?, Profile::default(), 0.389)?;
/// assert!((21.0 * sun.tip_diameter() - 436.338).abs() < 5e-4);
/// let shortened = sun.with_tip_alteration(-1.75 / 21.0)?;
/// assert!((21.0 * shortened.tip_diameter() - 432.838).abs() < 5e-4);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InvoluteGear {
    kind: GearKind,
    teeth: ToothCount,
    profile: Profile,
    shift: f64,
    tip_alteration: f64,
    /// Teeth with the sign of the kind.
    z: f64,
    /// Of the transverse pressure angle the involute function, cosine and sine.
    inv_alpha_t: f64,
    cos_alpha_t: f64,
    sin_alpha_t: f64,
    /// Of the normal pressure angle.
    tan_alpha_n: f64,
    sin_alpha_n: f64,
    /// Of the helix angle.
    cos_beta: f64,
    tan_beta: f64,
}

impl InvoluteGear {
    /// A gear with its profile shift `x`, tips as they come.
    ///
    /// # Errors
    /// Those of [`Profile::check`]; [`Error::ShiftOutOfRange`] where the shift leaves no root or tip circle or makes the teeth pointed.
    pub fn new(kind: GearKind, teeth: ToothCount, profile: Profile, shift: f64) -> Result<Self, Error> {
        profile.check()?;
        let alpha_t = profile.transverse_angle_rad();
        let z = match kind {
            GearKind::External => teeth.as_f64(),
            GearKind::Internal => -teeth.as_f64(),
        };
        let gear = Self {
            kind,
            teeth,
            profile,
            shift,
            tip_alteration: 0.0,
            z,
            inv_alpha_t: involute(alpha_t),
            cos_alpha_t: libm::cos(alpha_t),
            sin_alpha_t: libm::sin(alpha_t),
            tan_alpha_n: libm::tan(radians(profile.rack.pressure_angle)),
            sin_alpha_n: libm::sin(radians(profile.rack.pressure_angle)),
            cos_beta: libm::cos(radians(profile.helix_angle)),
            tan_beta: libm::tan(radians(profile.helix_angle)),
        };
        gear.checked()
    }

    /// The same with its tips moved by `k`, below 0 shorter.
    ///
    /// # Errors
    /// [`Error::ShiftOutOfRange`] where teeth become pointed or vanish.
    pub fn with_tip_alteration(self, tip_alteration: f64) -> Result<Self, Error> {
        self.altered(self.shift, tip_alteration).checked()
    }

    /// The same with another profile shift.
    ///
    /// # Errors
    /// [`Error::ShiftOutOfRange`].
    pub fn with_shift(self, shift: f64) -> Result<Self, Error> {
        self.altered(shift, self.tip_alteration).checked()
    }

    /// The same with another shift and other tips, whether or not that leaves teeth.
    pub(super) const fn altered(self, shift: f64, tip_alteration: f64) -> Self {
        Self { shift, tip_alteration, ..self }
    }

    pub(super) fn checked(self) -> Result<Self, Error> {
        let fault = |fault: ShiftFault| Error::ShiftOutOfRange {
            teeth: self.teeth.get(),
            kind: self.kind,
            shift: self.shift,
            tip_alteration: self.tip_alteration,
            fault,
        };
        if !(self.shift.is_finite() && self.tip_alteration.is_finite()) {
            return Err(fault(ShiftFault::NotFinite));
        }
        let sign = self.sign();
        if sign * self.signed_tip() <= 0.0 || sign * self.signed_root() <= 0.0 {
            return Err(fault(ShiftFault::NoCircle));
        }
        if self.signed_tip() <= self.signed_root() {
            return Err(fault(ShiftFault::NoTooth));
        }
        if self.tip_thickness() <= 0.0 {
            return Err(fault(ShiftFault::Pointed { tip_thickness: self.tip_thickness() }));
        }
        Ok(self)
    }

    /// External or internal.
    #[must_use]
    pub const fn kind(&self) -> GearKind {
        self.kind
    }

    /// Teeth.
    #[must_use]
    pub const fn teeth(&self) -> ToothCount {
        self.teeth
    }

    /// What its teeth have in common with those of its mates.
    #[must_use]
    pub const fn profile(&self) -> &Profile {
        &self.profile
    }

    /// Profile shift coefficient `x`.
    #[must_use]
    pub const fn shift(&self) -> f64 {
        self.shift
    }

    /// Tip alteration `k`.
    #[must_use]
    pub const fn tip_alteration(&self) -> f64 {
        self.tip_alteration
    }

    /// `z`, negative of an internal gear.
    pub(super) const fn signed_teeth(&self) -> f64 {
        self.z
    }

    /// `tan α_n`
    pub(super) const fn tan_normal_angle(&self) -> f64 {
        self.tan_alpha_n
    }

    /// 1, or −1 of an internal gear.
    pub(super) fn sign(&self) -> f64 {
        self.z.signum()
    }

    fn signed_reference(&self) -> f64 {
        self.z / self.cos_beta
    }

    fn signed_tip(&self) -> f64 {
        self.signed_reference() + 2.0 * (self.profile.rack.addendum + self.shift + self.tip_alteration)
    }

    fn signed_root(&self) -> f64 {
        let depth = self.profile.rack.addendum + self.profile.rack.clearance;
        self.signed_reference() - 2.0 * (depth - self.shift)
    }

    /// Reference diameter `d`.
    #[must_use]
    pub fn reference_diameter(&self) -> f64 {
        self.signed_reference().abs()
    }

    /// Base diameter `d_b`.
    #[must_use]
    pub fn base_diameter(&self) -> f64 {
        self.reference_diameter() * self.cos_alpha_t
    }

    /// Tip diameter `d_a`.
    #[must_use]
    pub fn tip_diameter(&self) -> f64 {
        self.signed_tip().abs()
    }

    /// Root diameter `d_f`, as a rack cuts it.
    #[must_use]
    pub fn root_diameter(&self) -> f64 {
        self.signed_root().abs()
    }

    /// Radius of curvature of the flank at a diameter, `√(d²/4 − d_b²/4)`; 0 within the base circle.
    #[must_use]
    pub fn curvature_radius(&self, diameter: f64) -> f64 {
        (diameter * diameter - self.base_diameter().powi(2)).max(0.0).sqrt() / 2.0
    }

    /// Transverse pressure angle at a diameter, rad; 0 within the base circle.
    #[must_use]
    pub fn angle_at_rad(&self, diameter: f64) -> f64 {
        libm::acos((self.base_diameter() / diameter).min(1.0))
    }

    /// Transverse tooth thickness, as an arc, at a diameter.
    ///
    /// ```text
    /// s_yt = d_y·((π + 4·x·tan α_n)/(2·z) + inv α_t − inv α_yt)
    /// ```
    #[must_use]
    pub fn thickness_at(&self, diameter: f64) -> f64 {
        let half = (PI + 4.0 * self.shift * self.tan_alpha_n) / (2.0 * self.z);
        let tan = 2.0 * self.curvature_radius(diameter) / self.base_diameter();
        self.sign() * diameter * (half + self.inv_alpha_t - (tan - libm::atan(tan)))
    }

    /// Normal tooth thickness at the reference circle: `s_n = π/2 + 2·x·tan α_n`.
    #[must_use]
    pub fn normal_thickness(&self) -> f64 {
        FRAC_PI_2 + 2.0 * self.shift * self.tan_alpha_n
    }

    /// Normal tooth thickness at the tip `s_an`: the transverse one times `cos β_a`.
    #[must_use]
    pub fn tip_thickness(&self) -> f64 {
        let diameter = self.tip_diameter();
        // cos β_a from tan β_a
        let tan_beta = self.tan_beta * diameter / self.reference_diameter();
        self.thickness_at(diameter) / libm::hypot(tan_beta, 1.0)
    }

    /// Least diameter, of an internal gear the greatest, where the flank that a rack cuts is an involute: `d_Ff`.
    ///
    /// ```text
    /// d_Ff² = d_b² + (d·sin α_t − 2·(h_FfP* − x)/sin α_t)²,    h_FfP* = h_aP* + c_P* − ρ_fP*·(1 − sin α_n)
    /// ```
    ///
    /// Of an undercut gear it is where the fillet meets the involute, a little above; then this is the base circle.
    #[must_use]
    pub fn form_diameter(&self) -> f64 {
        let reach = self.rack_reach();
        if self.kind == GearKind::External && reach <= 0.0 {
            return self.base_diameter();
        }
        (self.base_diameter().powi(2) + reach * reach).sqrt()
    }

    /// Twice the radius of curvature at which the straight flank of the rack ends; below 0 it undercuts.
    fn rack_reach(&self) -> f64 {
        let sin = self.sin_alpha_t;
        self.sign() * (self.signed_reference() * sin - 2.0 * (self.form_dedendum() - self.shift) / sin)
    }

    /// `h_FfP* = h_aP* + c_P* − ρ_fP*·(1 − sin α_n)`
    fn form_dedendum(&self) -> f64 {
        let rack = &self.profile.rack;
        rack.addendum + rack.clearance - self.profile.fillet * (1.0 - self.sin_alpha_n)
    }

    /// The least profile shift without undercut by a rack.
    ///
    /// ```text
    /// x_min = h_FfP* − z·sin²α_t/(2·cos β)
    /// ```
    ///
    /// `None` of an internal gear: no rack cuts it.
    #[must_use]
    pub fn least_shift_without_undercut(&self) -> Option<f64> {
        let least = self.form_dedendum() - self.z * self.sin_alpha_t.powi(2) / (2.0 * self.cos_beta);
        (self.kind == GearKind::External).then_some(least)
    }

    /// Span over so many teeth, of an internal gear spaces, `W_k`, along the normal.
    ///
    /// ```text
    /// W_k = cos α_n·(π·(k − ½) + |z|·inv α_t) ± 2·x·sin α_n         − of an internal gear
    /// ```
    #[must_use]
    pub fn span(&self, teeth: u32) -> f64 {
        let alpha_n = radians(self.profile.rack.pressure_angle);
        let pitches = PI * (f64::from(teeth) - 0.5) + self.z.abs() * self.inv_alpha_t;
        libm::cos(alpha_n) * pitches + self.sign() * 2.0 * self.shift * libm::sin(alpha_n)
    }

    /// Teeth, of an internal gear spaces, over which the span is measured nearest to half the height of the flanks: the plates touch at
    /// the circle `d + 2·x`.
    #[must_use]
    pub fn spanned_teeth(&self) -> u32 {
        let middle = (self.signed_reference() + 2.0 * self.shift).abs().max(self.base_diameter());
        let beta_b = self.profile.base_helix_rad();
        // Half the span stands on the tangent of the base circle: W_k = 2·√(r_y² − r_b²)/cos β_b.
        let span = 2.0 * self.curvature_radius(middle) / libm::cos(beta_b);
        let alpha_n = radians(self.profile.rack.pressure_angle);
        let pitches = (span - self.sign() * 2.0 * self.shift * libm::sin(alpha_n)) / libm::cos(alpha_n)
            - self.z.abs() * self.inv_alpha_t;
        let teeth = (pitches / PI + 0.5).round();
        teeth.clamp(1.0, self.z.abs() / 2.0 + 1.0) as u32
    }

    /// Diameter of the balls that touch the flanks at the circle `d + 2·x`, or at the base circle where that is larger.
    ///
    /// ```text
    /// α_Kt = tan α_yt − inv α_t − (2·x·tan α_n − π/2)/z        cos α_yt = d_b/(d + 2·x)
    /// D_M  = d_b·cos β_b·|tan α_Kt − tan α_yt|
    /// ```
    ///
    /// `d`, `z` negative of an internal gear, `d_b` not. The normal at the point of contact is tangent to the base circle and leads through the centre of the ball.
    #[must_use]
    pub fn ball_diameter(&self) -> f64 {
        let middle = (self.signed_reference() + 2.0 * self.shift).abs().max(self.base_diameter());
        let at = 2.0 * self.curvature_radius(middle) / self.base_diameter();
        let centre = at - self.inv_alpha_t - (2.0 * self.shift * self.tan_alpha_n - FRAC_PI_2) / self.z;
        self.base_diameter() * libm::cos(self.profile.base_helix_rad()) * (libm::tan(centre) - at).abs()
    }

    /// Measure over two balls, of an internal gear between them, of a diameter: `M_dK`.
    ///
    /// ```text
    /// inv α_Kt = inv α_t + D_M/(z·cos α_n) + 2·x·tan α_n/z − π/(2·z)      d_K = d·cos α_t/cos α_Kt
    /// M_dK = d_K + D_M,  odd z: d_K·cos(90°/z) + D_M      D_M is subtracted of an internal gear
    /// ```
    ///
    /// `None` where the ball would fall through the spaces.
    #[must_use]
    pub fn over_balls(&self, ball_diameter: f64) -> Option<f64> {
        let alpha_n = radians(self.profile.rack.pressure_angle);
        let inv = self.inv_alpha_t
            + ball_diameter / (self.z * libm::cos(alpha_n))
            + (2.0 * self.shift * libm::tan(alpha_n) - FRAC_PI_2) / self.z;
        let at = angle_of_involute(inv)?;
        let centres = self.base_diameter() / libm::cos(at);
        let across = if self.teeth.get().is_multiple_of(2) {
            centres
        } else {
            centres * libm::cos(FRAC_PI_2 / self.z)
        };
        Some(across + self.sign() * ball_diameter)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::angle_from_degrees;
    use proptest::prelude::*;

    proptest! {
        /// Along the normal from the base circle the centre of the ball is its radius beyond the flank at `d + 2·x`, and its measure says how far the
        /// centre is from the axis.
        #[test]
        fn balls_touch_the_flanks_at_the_middle_circle(
            teeth in 17..120_u32, shift in -0.3..0.6_f64, helix in 0.0..30.0_f64, is_ring: bool,
        ) {
            prop_assume!(!is_ring || teeth > 40);
            let kind = if is_ring { GearKind::Internal } else { GearKind::External };
            let profile = Profile { helix_angle: angle_from_degrees(helix), ..Profile::default() };
            let gear = InvoluteGear::new(kind, ToothCount::new(2 * teeth).unwrap(), profile, shift);
            prop_assume!(gear.is_ok());
            let gear = gear.unwrap();
            let middle = (gear.signed_reference() + 2.0 * shift).abs();
            prop_assume!(middle > gear.base_diameter());
            let ball = gear.ball_diameter();
            let centres = gear.over_balls(ball).unwrap() - gear.sign() * ball;
            let along = |diameter: f64| (diameter * diameter - gear.base_diameter().powi(2)).sqrt() / 2.0;
            let transverse = ball / 2.0 / libm::cos(profile.base_helix_rad());
            prop_assert!((along(centres) - along(middle) - gear.sign() * transverse).abs() < 1e-8);
        }

        /// The thickness at the reference circle in the transverse plane, times `cos β`.
        #[test]
        fn normal_thickness_is_that_of_the_reference_circle(
            teeth in 17..120_u32, shift in -0.3..0.6_f64, helix in 0.0..30.0_f64,
        ) {
            let profile = Profile { helix_angle: angle_from_degrees(helix), ..Profile::default() };
            let gear = InvoluteGear::new(GearKind::External, ToothCount::new(teeth).unwrap(), profile, shift);
            prop_assume!(gear.is_ok());
            let gear = gear.unwrap();
            let arc = gear.thickness_at(gear.reference_diameter()) * gear.cos_beta;
            prop_assert!((gear.normal_thickness() - arc).abs() < 1e-12);
        }
    }
}

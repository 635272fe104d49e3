//! One cylindrical gear with profile shift.

use super::cut::Cut;
use super::fault::ShiftFault;
use super::fault::ToolFault;
use super::flank::Flank;
use super::function::angle_of_involute;
use super::profile::Profile;
use super::tool::{Shaper, Tool};
use crate::gear_kind::GearKind;
use crate::{Error, ToothCount};
use epicyclic_numerics::roots::bisected;
use epicyclic_units::Physical;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// Largest absolute shift in the search for one without undercut.
const MOST_SHIFT: f64 = 2.0;

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
    tool: Tool,
    flank: Flank,
    cut: Cut,
}

impl InvoluteGear {
    /// A gear with its profile shift `x`, tips as they come.
    ///
    /// # Errors
    /// Those of [`Profile::check`]; [`Error::ShiftOutOfRange`] where the shift leaves no root or tip circle
    /// or makes the teeth pointed.
    pub fn new(kind: GearKind, teeth: ToothCount, profile: Profile, shift: f64) -> Result<Self, Error> {
        profile.check()?;
        let flank = Flank::new(kind, teeth, &profile);
        let tool = profile.tool.unwrap_or_else(|| usual_tool(kind, teeth, &flank, &profile));
        tool.check(kind)?;
        let cut = Cut::new(&flank, &profile, shift, &tool);
        Self { kind, teeth, profile, shift, tip_alteration: 0.0, tool, flank, cut }.checked()
    }

    /// A gear without shift, for a search. A shaper without an addendum of its own gets the dedendum of the
    /// rack: the candidates are cut by an existing cutter, and none is made for each of them.
    ///
    /// # Errors
    /// Errors of [`new`](Self::new).
    pub fn searched(kind: GearKind, teeth: ToothCount, profile: Profile) -> Result<Self, Error> {
        profile.check()?;
        let flank = Flank::new(kind, teeth, &profile);
        let tool = profile.tool.unwrap_or_else(|| usual_tool(kind, teeth, &flank, &profile));
        let tool = Some(tool.with_addendum(profile.dedendum()));
        Self::new(kind, teeth, Profile { tool, ..profile }, 0.0)
    }

    /// Gear with its tips moved by `k`; below 0 the teeth become shorter.
    ///
    /// # Errors
    /// [`Error::ShiftOutOfRange`] where teeth become pointed or vanish.
    pub fn with_tip_alteration(self, tip_alteration: f64) -> Result<Self, Error> {
        self.altered(self.shift, tip_alteration).checked()
    }

    /// Gear with another profile shift.
    ///
    /// # Errors
    /// [`Error::ShiftOutOfRange`].
    pub fn with_shift(self, shift: f64) -> Result<Self, Error> {
        self.altered(shift, self.tip_alteration).checked()
    }

    /// Gear cut by another tool.
    ///
    /// # Errors
    /// Those of [`Tool::check`]; [`Error::ShiftOutOfRange`] where it leaves no tooth. A tool that does not
    /// cut this gear is no error: see [`tool_fault`](Self::tool_fault).
    pub fn with_tool(self, tool: Tool) -> Result<Self, Error> {
        tool.check(self.kind)?;
        let cut = Cut::new(&self.flank, &self.profile, self.shift, &tool);
        let profile = Profile { tool: Some(tool), ..self.profile };
        Self { profile, tool, cut, ..self }.checked()
    }

    /// Gear with another shift and other tips, whether or not that leaves teeth.
    #[inline]
    pub(crate) fn altered(self, shift: f64, tip_alteration: f64) -> Self {
        let cut = if shift.to_bits() == self.shift.to_bits() {
            self.cut
        } else {
            Cut::new(&self.flank, &self.profile, shift, &self.tool)
        };
        Self { shift, tip_alteration, cut, ..self }
    }

    #[inline]
    pub(crate) fn checked(self) -> Result<Self, Error> {
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
        if sign * self.signed_tip() <= 0.0 || self.cut.root <= 0.0 {
            return Err(fault(ShiftFault::NoCircle));
        }
        if self.signed_tip() <= 2.0 * sign * self.cut.root {
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

    /// Profile, which the gear shares with its mates.
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

    /// Tool that cuts the gear.
    #[must_use]
    pub const fn tool(&self) -> &Tool {
        &self.tool
    }

    /// Reason why the tool does not cut the gear; `None` where it does.
    #[must_use]
    pub const fn tool_fault(&self) -> Option<ToolFault> {
        self.cut.fault
    }

    /// Addendum `h_aP0*` of the shaper that cuts it; `None` where no shaper does.
    #[must_use]
    pub fn shaper_addendum(&self) -> Option<f64> {
        self.cut.shaped.map(|shaped| shaped.addendum)
    }

    /// Tip alteration that shortens the tip to a radius of curvature of the flank, and to where the shaper
    /// leaves it.
    ///
    /// The tip of an internal gear moves outwards. A shorter tip stays as it is.
    pub(super) fn shortened_to(&self, curvature: f64) -> f64 {
        let sign = self.sign();
        let bound = match self.cut.tip_end() {
            Some(by_tool) if sign * by_tool < sign * curvature => by_tool,
            _ => curvature,
        };
        let tip = libm::hypot(self.base_diameter(), 2.0 * bound.max(0.0));
        let shorter = sign * (tip - self.tip_diameter()) / 2.0;
        self.tip_alteration + shorter.min(0.0)
    }

    pub(super) const fn flank(&self) -> &Flank {
        &self.flank
    }

    pub(super) const fn cut(&self) -> &Cut {
        &self.cut
    }

    /// `z`, negative of an internal gear.
    pub(super) const fn signed_teeth(&self) -> f64 {
        self.flank.z
    }

    /// `tan α_n`
    pub(super) const fn tan_normal_angle(&self) -> f64 {
        self.flank.tan_alpha_n
    }

    /// 1, or −1 of an internal gear.
    pub(super) fn sign(&self) -> f64 {
        self.flank.sign()
    }

    fn signed_reference(&self) -> f64 {
        2.0 * self.flank.signed_reference()
    }

    fn signed_tip(&self) -> f64 {
        self.signed_reference() + 2.0 * (self.profile.rack.addendum + self.shift + self.tip_alteration)
    }

    /// Area that the gear fills of its tip circle, an internal one leaves free of its root circle: half of
    /// the annulus between both is teeth, `π/4·(d_a² + d_f²)/2`, in square modules.
    #[must_use]
    pub fn filled_area(&self) -> f64 {
        let [tip, root] = [self.tip_diameter(), self.root_diameter()];
        FRAC_PI_4 * f64::midpoint(tip * tip, root * root)
    }

    /// Reference diameter `d`.
    #[must_use]
    pub fn reference_diameter(&self) -> f64 {
        self.signed_reference().abs()
    }

    /// Base diameter `d_b`.
    #[must_use]
    pub fn base_diameter(&self) -> f64 {
        self.reference_diameter() * self.flank.cos_alpha_t
    }

    /// Tip diameter `d_a`.
    #[must_use]
    pub fn tip_diameter(&self) -> f64 {
        self.signed_tip().abs()
    }

    /// Root diameter `d_f`, as its tool leaves it; as the basic rack has it where the tool does not cut the
    /// gear.
    #[must_use]
    pub const fn root_diameter(&self) -> f64 {
        2.0 * self.cut.root
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
        diameter * self.flank.half_angle(self.shift, diameter / 2.0)
    }

    /// Normal tooth thickness at the reference circle: `s_n = π/2 + 2·x·tan α_n`.
    #[must_use]
    pub fn normal_thickness(&self) -> f64 {
        FRAC_PI_2 + 2.0 * self.shift * self.flank.tan_alpha_n
    }

    /// Normal tooth thickness at the tip `s_an`: the transverse one times `cos β_a`.
    #[must_use]
    pub fn tip_thickness(&self) -> f64 {
        let diameter = self.tip_diameter();
        // cos β_a from tan β_a
        let tan_beta = self.flank.tan_beta * diameter / self.reference_diameter();
        self.thickness_at(diameter) / libm::hypot(tan_beta, 1.0)
    }

    /// Least diameter, of an internal gear the greatest, where the flank that the tool leaves is an involute:
    /// the root form diameter `d_Ff`.
    ///
    /// ```text
    /// hob, without undercut      d_Ff² = d_b² + (d·sin α_t − 2·(h_FfP* − x_E)/sin α_t)²
    ///                            h_FfP* = h_fP* − ρ_fP*·(1 − sin α_n)
    /// shaper of a ring           d_Ff² = d_b² + 4·(a_0·sin α_w0 + g_0)²
    ///                            g_0 = ρ_a0* + √((r_a0 − ρ_a0*)² − r_b0²)
    /// form tool of a ring        d_Ff² = d_b² + 4·(ρ + √((d_f/2 − ρ)² − r_b²))²
    /// ```
    ///
    /// The form diameter of an undercut gear is where the fillet meets the involute. Where the tool does not
    /// cut the gear it is that of the root circle.
    #[must_use]
    pub fn form_diameter(&self) -> f64 {
        libm::hypot(self.base_diameter(), 2.0 * self.cut.end)
    }

    /// `h_FfP* = h_fP* − ρ_fP*·(1 − sin α_n)`
    fn form_dedendum(&self) -> f64 {
        self.profile.dedendum() - self.profile.fillet * (1.0 - self.flank.sin_alpha_n)
    }

    /// The least profile shift without undercut.
    ///
    /// ```text
    /// x_min = h_FfP* − z·sin²α_t/(2·cos β) − q/sin α_n       by a hob
    /// ```
    ///
    /// By a shaper it is where the corner of the shaper begins at the tangent point of the base circle.
    /// `None` of an internal gear and of a form tool, and of a shaper that undercuts at any shift up to 2.
    #[must_use]
    pub fn least_shift_without_undercut(&self) -> Option<f64> {
        if self.kind == GearKind::Internal {
            return None;
        }
        match self.tool {
            Tool::Form { .. } => None,
            Tool::Rack => {
                let at_tangent = self.flank.z * self.flank.sin_alpha_t.powi(2) / (2.0 * self.flank.cos_beta);
                let stock = self.profile.generating_shift(0.0);
                Some(self.form_dedendum() - at_tangent - stock)
            }
            Tool::Shaper(_) => {
                let is_free = |shift: f64| {
                    let cut = Cut::new(&self.flank, &self.profile, shift, &self.tool);
                    cut.fault.is_none() && cut.reach >= 0.0
                };
                let halvings = super::fillet::HALVINGS;
                let least = || bisected([MOST_SHIFT, -MOST_SHIFT], halvings, is_free)[0];
                is_free(MOST_SHIFT).then(least)
            }
        }
    }

    /// Span `W_k` over `k` teeth along the normal, for an internal gear over `k` spaces.
    ///
    /// ```text
    /// W_k = cos α_n·(π·(k − ½) + |z|·inv α_t) ± 2·x·sin α_n         − of an internal gear
    /// ```
    #[must_use]
    pub fn span(&self, teeth: u32) -> f64 {
        let alpha_n = self.profile.rack.pressure_angle.si();
        let pitches = PI * (f64::from(teeth) - 0.5) + self.flank.z.abs() * self.flank.inv_alpha_t;
        libm::cos(alpha_n) * pitches + self.sign() * 2.0 * self.shift * libm::sin(alpha_n)
    }

    /// Teeth, of an internal gear spaces, over which the span is measured nearest to half the height of the
    /// flanks: the plates touch at the circle `d + 2·x`.
    #[must_use]
    pub fn spanned_teeth(&self) -> u32 {
        let middle = (self.signed_reference() + 2.0 * self.shift).abs().max(self.base_diameter());
        let beta_b = self.profile.base_helix_rad();
        // Half the span lies on the tangent of the base circle: W_k = 2·√(r_y² − r_b²)/cos β_b.
        let span = 2.0 * self.curvature_radius(middle) / libm::cos(beta_b);
        let alpha_n = self.profile.rack.pressure_angle.si();
        let pitches = (span - self.sign() * 2.0 * self.shift * libm::sin(alpha_n)) / libm::cos(alpha_n)
            - self.flank.z.abs() * self.flank.inv_alpha_t;
        let teeth = (pitches / PI + 0.5).round();
        teeth.clamp(1.0, self.flank.z.abs() / 2.0 + 1.0) as u32
    }

    /// Diameter of the balls that touch the flanks at the circle `d + 2·x`, or at the base circle where that
    /// is larger.
    ///
    /// ```text
    /// α_Kt = tan α_yt − inv α_t − (2·x·tan α_n − π/2)/z        cos α_yt = d_b/(d + 2·x)
    /// D_M  = d_b·cos β_b·|tan α_Kt − tan α_yt|
    /// ```
    ///
    /// `d`, `z` negative of an internal gear, `d_b` not. The normal at the point of contact is tangent to the
    /// base circle and leads through the centre of the ball.
    #[must_use]
    pub fn ball_diameter(&self) -> f64 {
        self.ball_touching((self.signed_reference() + 2.0 * self.shift).abs())
    }

    /// Least and greatest diameter of a ball that touches the flanks: at the form circle and at the tip
    /// circle.
    #[must_use]
    pub fn ball_diameters(&self) -> [f64; 2] {
        [self.form_diameter(), self.tip_diameter()].map(|diameter| self.ball_touching(diameter))
    }

    /// Diameter of the balls that touch the flanks at a diameter, or at the base circle where that is larger.
    fn ball_touching(&self, diameter: f64) -> f64 {
        let at = 2.0 * self.curvature_radius(diameter.max(self.base_diameter())) / self.base_diameter();
        let centre = at
            - self.flank.inv_alpha_t
            - (2.0 * self.shift * self.flank.tan_alpha_n - FRAC_PI_2) / self.flank.z;
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
        let alpha_n = self.profile.rack.pressure_angle.si();
        let inv = self.flank.inv_alpha_t
            + ball_diameter / (self.flank.z * libm::cos(alpha_n))
            + (2.0 * self.shift * libm::tan(alpha_n) - FRAC_PI_2) / self.flank.z;
        let at = angle_of_involute(inv)?;
        let centres = self.base_diameter() / libm::cos(at);
        let across = if self.teeth.get().is_multiple_of(2) {
            centres
        } else {
            centres * libm::cos(FRAC_PI_2 / self.flank.z)
        };
        Some(across + self.sign() * ball_diameter)
    }
}

/// The usual tool with corners that it has room for.
fn usual_tool(kind: GearKind, teeth: ToothCount, flank: &Flank, profile: &Profile) -> Tool {
    let tool = Tool::usual(kind, teeth);
    match (tool, Cut::new(flank, profile, 0.0, &tool).fault) {
        (Tool::Shaper(shaper), Some(ToolFault::Corners { most, .. })) if most > 0.0 => {
            Tool::Shaper(Shaper { tip_radius: most, ..shaper })
        }
        _ => tool,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use uom::si::f64::Angle;

    proptest! {
        /// Measured along the normal from the base circle, the centre of the ball lies its radius beyond the
        /// flank at `d + 2·x`. The measure over balls gives the distance of the centre from the axis.
        #[test]
        fn balls_touch_the_flanks_at_the_middle_circle(
            teeth in 17..120_u32, shift in -0.3..0.6_f64, helix in 0.0..30.0_f64, is_ring: bool,
        ) {
            prop_assume!(!is_ring || teeth > 40);
            let kind = if is_ring { GearKind::Internal } else { GearKind::External };
            let profile = Profile { helix_angle: Angle::from_degrees(helix), ..Profile::default() };
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
            let profile = Profile { helix_angle: Angle::from_degrees(helix), ..Profile::default() };
            let gear = InvoluteGear::new(GearKind::External, ToothCount::new(teeth).unwrap(), profile, shift);
            prop_assume!(gear.is_ok());
            let gear = gear.unwrap();
            let arc = gear.thickness_at(gear.reference_diameter()) * gear.flank.cos_beta;
            prop_assert!((gear.normal_thickness() - arc).abs() < 1e-12);
        }
    }
}

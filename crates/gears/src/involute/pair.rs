//! Two cylindrical gears in mesh.

use super::function::{angle_of_involute, involute};
use super::gear::InvoluteGear;
use crate::gear_kind::GearKind;
use crate::tolerance::SAME;
use crate::{Error, Quantity};
use epicyclic_units::Physical;
use std::f64::consts::PI;

/// Two gears in mesh; the second may be internal. Lengths in modules.
///
/// ```
/// use epicyclic_gears::involute::{InvoluteGear, Pair, Profile};
/// use epicyclic_gears::{ToothCount, geometry::GearKind};
/// # fn main() -> Result<(), epicyclic_gears::Error> {
/// let gear = |teeth, shift| {
///     InvoluteGear::new(GearKind::External, ToothCount::new(teeth)?, Profile::default(), shift)
/// };
/// // 12/24 teeth, module 3 mm, x = 0.6/0.36.
/// let pair = Pair::without_backlash(gear(12, 0.6)?, gear(24, 0.36)?)?;
/// assert!((3.0 * pair.centre_distance() - 56.4999).abs() < 1e-4);
/// assert!((pair.working_angle_rad().to_degrees() - 26.0886).abs() < 1e-4);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    gears: [InvoluteGear; 2],
    /// Working transverse pressure angle, rad, its sine and its cosine.
    alpha_wt: f64,
    sin_wt: f64,
    cos_wt: f64,
}

impl Pair {
    /// The mesh without backlash that the shifts of two gears give.
    ///
    /// # Errors
    /// [`Error::BothInternal`], [`Error::WrongGearKind`] for a first gear that is internal,
    /// [`Error::InternalNotLarger`]; [`Error::PressureAnglesDiffer`], [`Error::HelixAnglesDiffer`];
    /// [`Error::ShiftSumOutOfRange`] where no working angle has their sum.
    pub fn without_backlash(first: InvoluteGear, second: InvoluteGear) -> Result<Self, Error> {
        let teeth = check(&first, &second)?;
        let profile = first.profile();
        let sum = first.shift() + second.shift();
        let tan = libm::tan(profile.rack.pressure_angle.si());
        let inv = involute(profile.transverse_angle_rad()) + 2.0 * tan * sum / teeth;
        let alpha_wt =
            angle_of_involute(inv).filter(|angle| *angle > 0.0).ok_or(Error::ShiftSumOutOfRange {
                sum,
                limit: -involute(profile.transverse_angle_rad()) * teeth / (2.0 * tan),
            })?;
        Ok(Self::new([first, second], alpha_wt))
    }

    fn new(gears: [InvoluteGear; 2], alpha_wt: f64) -> Self {
        let (sin_wt, cos_wt) = libm::sincos(alpha_wt);
        Self { gears, alpha_wt, sin_wt, cos_wt }
    }

    /// Mesh of gears that differ from these in their tips alone.
    pub(super) const fn with_gears(self, gears: [InvoluteGear; 2]) -> Self {
        Self { gears, ..self }
    }

    /// The mesh at a centre distance, with the backlash that is left.
    ///
    /// # Errors
    /// Those of the gears as for [`without_backlash`](Self::without_backlash); [`Error::NotAbove`] for a
    /// centre distance at which the base circles leave no line of action.
    #[inline]
    pub fn at_centre_distance(
        first: InvoluteGear,
        second: InvoluteGear,
        centre_distance: f64,
    ) -> Result<Self, Error> {
        let teeth = check(&first, &second)?;
        let alpha_wt = working_angle(&first, teeth, centre_distance)?;
        Ok(Self::new([first, second], alpha_wt))
    }

    /// Sum of the profile shifts that leaves no backlash at a centre distance.
    ///
    /// ```text
    /// x_1 + x_2 = (z_1 + z_2)·(inv α_wt − inv α_t)/(2·tan α_n)
    /// ```
    ///
    /// Of the gears the shifts do not matter.
    ///
    /// # Errors
    /// Those of [`at_centre_distance`](Self::at_centre_distance).
    pub fn shift_sum(
        first: &InvoluteGear,
        second: &InvoluteGear,
        centre_distance: f64,
    ) -> Result<f64, Error> {
        let teeth = check(first, second)?;
        let alpha_wt = working_angle(first, teeth, centre_distance)?;
        let profile = first.profile();
        let tan = libm::tan(profile.rack.pressure_angle.si());
        Ok(teeth * (involute(alpha_wt) - involute(profile.transverse_angle_rad())) / (2.0 * tan))
    }

    /// The gears.
    #[must_use]
    pub const fn gears(&self) -> &[InvoluteGear; 2] {
        &self.gears
    }

    /// Whether the second gear is internal.
    #[must_use]
    pub fn is_internal(&self) -> bool {
        self.gears[1].kind() == GearKind::Internal
    }

    /// 1, or −1 with an internal gear.
    fn sign(&self) -> f64 {
        self.gears[1].sign()
    }

    /// Working transverse pressure angle `α_wt`, rad.
    #[must_use]
    pub fn working_angle_rad(&self) -> f64 {
        self.alpha_wt
    }

    /// Centre distance `a`.
    #[must_use]
    pub fn centre_distance(&self) -> f64 {
        let [first, second] = &self.gears;
        let bases = first.base_diameter() + self.sign() * second.base_diameter();
        bases.abs() / (2.0 * self.cos_wt)
    }

    /// Centre distance of the reference circles `a_d`.
    #[must_use]
    pub fn reference_centre_distance(&self) -> f64 {
        let [first, second] = &self.gears;
        (first.reference_diameter() + self.sign() * second.reference_diameter()).abs() / 2.0
    }

    /// Working diameters `d_w`: they roll on each other.
    #[must_use]
    pub fn working_diameters(&self) -> [f64; 2] {
        self.gears.map(|gear| gear.base_diameter() / self.cos_wt)
    }

    /// The part of the line of action between the tangent points of the base circles, `a·sin α_wt`.
    fn tangents(&self) -> f64 {
        self.centre_distance() * self.sin_wt
    }

    /// Radius of curvature of the mate's flank at the contact point where the first gear's flank has this
    /// radius of curvature.
    pub(super) fn mate(&self, radius: f64) -> f64 {
        if self.is_internal() { radius + self.tangents() } else { self.tangents() - radius }
    }

    /// Inverse of `mate`: radius of curvature of the first gear's flank.
    pub(super) fn of_mate(&self, radius: f64) -> f64 {
        if self.is_internal() { radius - self.tangents() } else { self.tangents() - radius }
    }

    /// Radii of curvature of the first gear's flank where contact begins and ends: `A`, and `E`.
    ///
    /// `A` is where the second gear's tip meets it, `E` its own tip; each not further than the involute of
    /// the mate's root, or of its own, goes.
    #[must_use]
    pub fn contact(&self) -> [f64; 2] {
        let [first, second] = &self.gears;
        let tip = first.curvature_radius(first.tip_diameter());
        let from_mates_tip = self.of_mate(second.curvature_radius(second.tip_diameter()));
        let root = first.curvature_radius(first.form_diameter());
        let mates_root = self.of_mate(second.curvature_radius(second.form_diameter()));
        [from_mates_tip.max(root), tip.min(mates_root)]
    }

    /// Transverse contact ratio `ε_α`: the length of contact over the base pitch `π·cos α_t/cos β`; 0 where
    /// the gears do not meet.
    #[must_use]
    pub fn transverse_contact_ratio(&self) -> f64 {
        let [from, to] = self.contact();
        ((to - from) / self.base_pitch()).max(0.0)
    }

    /// Transverse base pitch `p_et`.
    #[must_use]
    pub fn base_pitch(&self) -> f64 {
        let first = &self.gears[0];
        PI * first.base_diameter() / first.teeth().as_f64()
    }

    /// Overlap ratio `ε_β` of a face width in modules: `b·sin β/π`.
    #[must_use]
    pub fn overlap_ratio(&self, face_width: f64) -> f64 {
        face_width * libm::sin(self.gears[0].profile().helix_angle.si()) / PI
    }

    /// Least diameter, of an internal gear greatest, of each gear at which it meets its mate: `d_Nf`.
    #[must_use]
    pub fn active_root_diameters(&self) -> [f64; 2] {
        let [from, to] = self.contact();
        let diameter = |gear: &InvoluteGear, radius: f64| libm::hypot(gear.base_diameter(), 2.0 * radius);
        [diameter(&self.gears[0], from), diameter(&self.gears[1], self.mate(to))]
    }

    /// Specific sliding of each gear's flank at both ends of contact: at its tip and at its root.
    ///
    /// ```text
    /// ζ_1 = 1 − ρ_2·z_1/(ρ_1·|z_2|),    ζ_2 = 1 − ρ_1·|z_2|/(ρ_2·z_1)
    /// ```
    ///
    /// The first value of each gear is at the tip, where it is at most 1. The second is at the root, usually
    /// below 0, and tends to −∞ at the base circle.
    #[must_use]
    pub fn specific_sliding(&self) -> [[f64; 2]; 2] {
        let [from, to] = self.contact();
        let ratio = self.gears[1].teeth().as_f64() / self.gears[0].teeth().as_f64();
        let first = |radius: f64| 1.0 - self.mate(radius) / (radius * ratio);
        let second = |radius: f64| 1.0 - radius * ratio / self.mate(radius);
        [[first(to), first(from)], [second(from), second(to)]]
    }

    /// Tip clearance: from the tip of each gear to the root circle of its mate. Below 0 it bites into it.
    #[must_use]
    pub fn tip_clearances(&self) -> [f64; 2] {
        let [first, second] = &self.gears;
        let a = self.centre_distance();
        let half = |diameter: f64| diameter / 2.0;
        if self.is_internal() {
            [
                half(second.root_diameter()) - a - half(first.tip_diameter()),
                half(second.tip_diameter()) - a - half(first.root_diameter()),
            ]
        } else {
            [
                a - half(first.tip_diameter()) - half(second.root_diameter()),
                a - half(second.tip_diameter()) - half(first.root_diameter()),
            ]
        }
    }

    /// Transverse backlash at the working circles `j_wt`: the pitch less both thicknesses. Below 0 the flanks
    /// press into each other.
    #[must_use]
    pub fn backlash(&self) -> f64 {
        let working = self.working_diameters();
        let pitch = PI * working[0] / self.gears[0].teeth().as_f64();
        pitch - self.gears[0].thickness_at(working[0]) - self.gears[1].thickness_at(working[1])
    }

    /// Pair whose internal second gear has tips short enough to stay out of the fillets of the first gear,
    /// and within what its shaper leaves. The contact ratio does not change. External pairs stay as they are.
    ///
    /// # Errors
    /// [`Error::ShiftOutOfRange`] where teeth vanish.
    pub fn with_clear_ring_tips(self) -> Result<Self, Error> {
        if !self.is_internal() {
            return Ok(self);
        }
        let [first, second] = self.gears;
        let shortened = second.shortened_to(self.mate(first.cut().end));
        Ok(self.with_gears([first, second.with_tip_alteration(shortened)?]))
    }

    /// The tip alteration that keeps the tip clearance of the basic rack: `k = a − a_d − (x_1 + x_2)`, and 0
    /// of an internal pair.
    #[must_use]
    pub fn tip_alteration(&self) -> f64 {
        if self.is_internal() {
            return 0.0;
        }
        let sum = self.gears[0].shift() + self.gears[1].shift();
        self.centre_distance() - self.reference_centre_distance() - sum
    }

    /// Pair of the same gears with other tips, at the same centre distance.
    ///
    /// # Errors
    /// [`Error::ShiftOutOfRange`] where teeth become pointed or vanish.
    pub fn with_tip_alterations(self, alterations: [f64; 2]) -> Result<Self, Error> {
        let [first, second] = self.gears;
        let gears = [first.with_tip_alteration(alterations[0])?, second.with_tip_alteration(alterations[1])?];
        Ok(Self { gears, ..self })
    }
}

/// Whether two gears mesh at all; the sum of their teeth, an internal gear's below 0.
fn check(first: &InvoluteGear, second: &InvoluteGear) -> Result<f64, Error> {
    use GearKind::{External, Internal};
    match [first.kind(), second.kind()] {
        [Internal, Internal] => {
            return Err(Error::BothInternal { first: first.teeth().get(), second: second.teeth().get() });
        }
        [Internal, External] => return Err(Error::WrongGearKind { given: Internal, wanted: External }),
        [External, Internal] if second.teeth() <= first.teeth() => {
            return Err(Error::InternalNotLarger {
                internal: second.teeth().get(),
                external: first.teeth().get(),
            });
        }
        [External, _] => {}
    }
    let differ = |one: f64, other: f64| (one - other).abs() > SAME * one.abs().max(other.abs());
    let [one, other] = [first, second].map(InvoluteGear::profile);
    let [first_deg, second_deg] = [one, other].map(|profile| profile.rack.pressure_angle.degrees());
    if differ(first_deg, second_deg) {
        return Err(Error::PressureAnglesDiffer { first_deg, second_deg });
    }
    let [first_deg, second_deg] = [one, other].map(|profile| profile.helix_angle.degrees());
    if differ(first_deg, second_deg) {
        return Err(Error::HelixAnglesDiffer { first_deg, second_deg });
    }
    Ok(first.signed_teeth() + second.signed_teeth())
}

/// `cos α_wt = (z_1 + z_2)·cos α_t/(2·a·cos β)`
#[inline]
fn working_angle(first: &InvoluteGear, teeth: f64, centre_distance: f64) -> Result<f64, Error> {
    let least = (teeth / first.teeth().as_f64()).abs() * first.base_diameter() / 2.0;
    let cos = least / centre_distance;
    if cos > 0.0 && cos < 1.0 {
        return Ok(libm::acos(cos));
    }
    Err(Error::NotAbove {
        quantity: Quantity::CentreDistance,
        value: centre_distance,
        low: least,
        unit: "modules",
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ToothCount;
    use crate::involute::Profile;
    use proptest::prelude::*;
    use uom::si::f64::Angle;

    fn gear(kind: GearKind, teeth: u32, shift: f64, helix_deg: f64) -> Option<InvoluteGear> {
        let profile = Profile { helix_angle: Angle::from_degrees(helix_deg), ..Profile::default() };
        InvoluteGear::new(kind, ToothCount::new(teeth).unwrap(), profile, shift).ok()
    }

    #[test]
    fn gears_that_cannot_mesh_are_refused() {
        let external = |teeth, helix| gear(GearKind::External, teeth, 0.0, helix).unwrap();
        let internal = |teeth| gear(GearKind::Internal, teeth, 0.0, 0.0).unwrap();
        let name = |one, other| Pair::without_backlash(one, other).unwrap_err().name();
        assert_eq!(name(internal(60), internal(70)), "both-internal");
        assert_eq!(name(internal(60), external(20, 0.0)), "wrong-gear-kind");
        assert_eq!(name(external(60, 0.0), internal(60)), "internal-not-larger");
        assert_eq!(name(external(20, 10.0), external(30, 12.0)), "helix-angles-differ");
        let steep = Profile {
            rack: crate::rack::BasicRack { pressure_angle: Angle::from_degrees(25.0), ..Default::default() },
            fillet: 0.3,
            ..Profile::default()
        };
        let steep = InvoluteGear::new(GearKind::External, ToothCount::new(20).unwrap(), steep, 0.0).unwrap();
        assert_eq!(name(external(20, 0.0), steep), "pressure-angles-differ");
        let error = Pair::at_centre_distance(external(20, 0.0), external(30, 0.0), 23.0).unwrap_err();
        let message = error.to_string();
        assert!(
            message.starts_with("centre distance is 23 modules; it must be above 23.4923155196 modules"),
            "{message}"
        );
        let shifted = |teeth| gear(GearKind::External, teeth, -0.55, 0.0).unwrap();
        let error = Pair::without_backlash(shifted(20), shifted(20)).unwrap_err();
        assert!(error.to_string().ends_with("it must be above -0.8190"), "{error}");
    }

    /// The line of action crossed with both tip circles, in coordinates.
    fn contact_by_coordinates(pair: &Pair) -> f64 {
        let [first, second] = pair.gears();
        let a = pair.centre_distance();
        let [w1, w2] = pair.working_diameters();
        // The first centre at 0, the pitch point on the x axis, the second beyond it or, of a ring, behind
        // the first.
        let pitch = w1 / 2.0;
        let centre = if pair.is_internal() { pitch - w2 / 2.0 } else { pitch + w2 / 2.0 };
        assert!((centre.abs() - a).abs() < 1e-9 * w2);
        let angle = pair.working_angle_rad();
        let direction = [libm::sin(angle), libm::cos(angle)];
        // |P + t·u − C| = r
        let along = |centre: f64, radius: f64| {
            let from = pitch - centre;
            let half = from * direction[0];
            let root = (half * half - (from * from - radius * radius)).sqrt();
            [-half - root, -half + root]
        };
        let own = along(0.0, first.tip_diameter() / 2.0)[1];
        let mates = along(centre, second.tip_diameter() / 2.0);
        let from = if pair.is_internal() { mates[1] } else { mates[0] };
        (own - from) / pair.base_pitch()
    }

    proptest! {
        #[test]
        fn contact_is_what_the_tip_circles_cut_off_the_line_of_action(
            z1 in 17..60_u32, z2 in 17..90_u32, x1 in -0.2..0.8_f64, x2 in -0.2..0.8_f64, helix in 0.0..25.0_f64, ring in any::<bool>(),
        ) {
            let second = if ring { gear(GearKind::Internal, z1 + z2, -x2, helix) } else { gear(GearKind::External, z2, x2, helix) };
            let gears = gear(GearKind::External, z1, x1, helix).zip(second);
            prop_assume!(gears.is_some());
            let (first, second) = gears.unwrap();
            let pair = Pair::without_backlash(first, second);
            prop_assume!(pair.is_ok());
            let pair = pair.unwrap();
            // Both gears fill the pitch, at a centre distance that gives the same sum of shifts back.
            prop_assert!(pair.backlash().abs() < 1e-10 * f64::from(z1 + z2));
            let sum = Pair::shift_sum(&first, &second, pair.centre_distance()).unwrap();
            prop_assert!((sum - first.shift() - second.shift()).abs() < 1e-9 * f64::from(z1 + z2));
            let again = Pair::at_centre_distance(first, second, pair.centre_distance()).unwrap();
            prop_assert!((again.working_angle_rad() - pair.working_angle_rad()).abs() < 1e-7);
            let [from, to] = pair.contact();
            let tips = [pair.of_mate(second.curvature_radius(second.tip_diameter())), first.curvature_radius(first.tip_diameter())];
            // Tips of a ring within its base circle never meet the line of action.
            let second_has_involute_tip = !ring || second.tip_diameter() > second.base_diameter();
            let by_tips = contact_by_coordinates(&pair);
            // Fillets that cut contact short reduce the contact ratio.
            prop_assert!(!second_has_involute_tip || pair.transverse_contact_ratio() <= by_tips.max(0.0) + 1e-9);
            if from == tips[0] && to == tips[1] && second_has_involute_tip {
                prop_assert!((pair.transverse_contact_ratio() - by_tips.max(0.0)).abs() < 1e-9, "{by_tips}");
            }
        }

        #[test]
        fn sliding_is_that_of_the_speeds_at_the_flanks(
            z1 in 20..60_u32, z2 in 20..90_u32, x1 in 0.0..0.5_f64, ring in any::<bool>(),
        ) {
            let second = if ring { gear(GearKind::Internal, z1 + z2, -x1, 0.0) } else { gear(GearKind::External, z2, x1, 0.0) };
            let pair = Pair::without_backlash(gear(GearKind::External, z1, x1, 0.0).unwrap(), second.unwrap()).unwrap();
            let [from, to] = pair.contact();
            // Speeds along the flanks are ω·ρ; the ring turns the same way, the external mate back.
            let speeds = |radius: f64| [radius, pair.mate(radius) * f64::from(z1) / pair.gears()[1].teeth().as_f64()];
            let own = |[one, other]: [f64; 2]| (one - other) / one;
            let mates = |[one, other]: [f64; 2]| (other - one) / other;
            let [[tip1, root1], [tip2, root2]] = pair.specific_sliding();
            for (found, expected) in [(tip1, own(speeds(to))), (root1, own(speeds(from))), (tip2, mates(speeds(from))), (root2, mates(speeds(to)))] {
                prop_assert!((found - expected).abs() < 1e-9 * expected.abs().max(1.0));
            }
        }
    }
}

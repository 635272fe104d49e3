//! Backlash from tooth-thickness allowances and the centre-distance tolerance, and torsional stiffness.
//!
//! Both are calculated for a mesh and for the output of a set. A gear whose teeth are thinner by `E_sn`
//! equals one that was generated with the smaller shift `x_E` and kept its tips:
//!
//! ```text
//! x_E  = x + E_sn/(2·tan α_n)                                   E_sn below 0: thinner
//! j_wt = p_wt − s_w1 − s_w2                                     at the working circles
//! j_bn = j_wt·cos α_wt·cos β_b                                  grows by −(E_sn1 + E_sn2)·cos α_n
//! φ_1  = j_wt/r_w1                                              rotation of gear 1, its mate at rest
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `E_sns`, `E_sni` | upper, lower allowance of the normal tooth thickness, reference circle | modules |
//! | `A_as`, `A_ai` | upper and lower deviation of the centre distance | modules |
//! | `j_wt`, `j_bn` | circumferential backlash at the working circles, normal backlash | modules |
//! | `φ` | angle of rotation that the backlash allows | rad |
//!
//! # Output of a set
//! The flanks of both meshes bear along their lines of action with the same force, so that their plays and
//! their deflections add:
//!
//! ```text
//! r_bs·(φ_s − φ_H) + r_br·(φ_r − φ_H) = j_bt1 + j_bt2 + F·(1/k_1 + 1/k_2)/N
//! ```
//!
//! With the two other members held, the output turns by `φ = (j_bt1 + j_bt2)/r` and has the stiffness
//! `T/φ = r²·N/(1/k_1 + 1/k_2)`. The lever `r` is `r_bs` at the sun, `r_br` at the ring and `r_bs + r_br` at
//! the carrier; `j_bt = j_wt·cos α_wt`, `k = c_γ·b`. Which of the other members is the input does not matter.
//!
//! Left out: play and deflection of bearings, pins, shafts and carrier, unequal planets; `c_γ` is given.
//!
//! # Gears in a train
//! Let the torque on a member of a set be `τ` times that at the output of the whole train. By virtual work
//! the set then adds `|τ|·φ` to the play at the output and `τ²/k` to the compliance: [`at_output`].
//!
//! # Source
//! ISO 21771:2007 for names and signs; derived from the involute.

use super::gear::InvoluteGear;
use super::pair::Pair;
use super::set::PlanetSet;
use crate::checks::{positive_length, positive_stress, positive_torque};
use crate::mode::Member;
use crate::{Error, Quantity};
use epicyclic_units::Physical;
use uom::si::f64::{Length, Pressure, Torque};

/// Least and greatest value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extent {
    /// The least.
    pub least: f64,
    /// The greatest.
    pub greatest: f64,
}

/// A pair of limits of a deviation from the nominal value, in modules; both 0 by default.
///
/// Of a tooth thickness the allowances `E_sni` and `E_sns`, below 0 of thinner teeth; of a centre distance
/// `A_ai` and `A_as`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Deviation {
    /// Lower limit.
    pub lower: f64,
    /// Upper limit.
    pub upper: f64,
}

impl Deviation {
    /// Refuses limits that are no numbers or in the wrong order.
    ///
    /// # Errors
    /// [`Error::Deviation`].
    pub fn check(&self, quantity: Quantity) -> Result<(), Error> {
        let &Self { lower, upper } = self;
        if lower.is_finite() && upper.is_finite() && lower <= upper {
            return Ok(());
        }
        Err(Error::Deviation { quantity, lower, upper })
    }
}

/// The play of a mesh; lengths in modules.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Play {
    /// Circumferential backlash at the working circles, `j_wt`; below 0 the flanks press into each other.
    pub circumferential: f64,
    /// Normal backlash `j_bn`: the shortest distance of the flanks.
    pub normal: f64,
    /// Angles by which each gear turns while its mate rests, rad.
    pub rotation_rad: [f64; 2],
}

impl InvoluteGear {
    /// The gear with teeth thinner by an allowance `E_sn` below 0, its tips where they were.
    ///
    /// Its span, its measure over balls and its root circle are those of the thinner teeth.
    ///
    /// # Errors
    /// [`Error::ShiftOutOfRange`] where it has no teeth left.
    pub fn with_thickness_allowance(self, allowance: f64) -> Result<Self, Error> {
        let less = allowance / (2.0 * self.tan_normal_angle());
        self.altered(self.shift() + less, self.tip_alteration() - less).checked()
    }
}

impl Pair {
    /// The play of the gears as they are.
    #[must_use]
    pub fn play(&self) -> Play {
        let circumferential = self.backlash();
        let base_helix = self.gears()[0].profile().base_helix_rad();
        Play {
            circumferential,
            normal: circumferential * libm::cos(self.working_angle_rad()) * libm::cos(base_helix),
            rotation_rad: self.working_diameters().map(|diameter| 2.0 * circumferential / diameter),
        }
    }

    /// Least and greatest play with allowances of both gears and a tolerance of the centre distance.
    ///
    /// # Errors
    /// Those of [`Deviation::check`]; [`Error::ShiftOutOfRange`], [`Error::NotAbove`] for allowances and
    /// deviations that leave no mesh.
    pub fn plays(&self, thickness: [Deviation; 2], centre_distance: Deviation) -> Result<[Play; 2], Error> {
        centre_distance.check(Quantity::CentreDistanceDeviation)?;
        for deviation in &thickness {
            deviation.check(Quantity::ThicknessAllowance)?;
        }
        // A ring further out comes nearer to its pinion.
        let Deviation { lower, upper } = centre_distance;
        let [near, far] = if self.is_internal() { [upper, lower] } else { [lower, upper] };
        let [upper, lower] = [thickness.map(|it| it.upper), thickness.map(|it| it.lower)];
        Ok([self.deviating(upper, near)?.play(), self.deviating(lower, far)?.play()])
    }

    /// The mesh of gears with thickness allowances at a centre distance that is off by so much.
    fn deviating(&self, allowances: [f64; 2], centre_distance: f64) -> Result<Self, Error> {
        let [first, second] = self.gears();
        Self::at_centre_distance(
            first.with_thickness_allowance(allowances[0])?,
            second.with_thickness_allowance(allowances[1])?,
            self.centre_distance() + centre_distance,
        )
    }
}

impl PlanetSet {
    /// Lever of the tooth forces on the member that turns while the two others are held, in modules.
    fn lever(&self, output: Member) -> f64 {
        let [sun, _, ring] = self.gears().map(|gear| gear.base_diameter() / 2.0);
        match output {
            Member::Sun => sun,
            Member::Ring => ring,
            Member::Carrier => sun + ring,
        }
    }

    /// Angle, rad, by which a member turns while the two others are held: least and greatest with allowances
    /// of sun, planets and ring and a tolerance of the centre distance.
    ///
    /// ```
    /// use epicyclic_gears::involute::closing::Closing;
    /// use epicyclic_gears::involute::play::Deviation;
    /// use epicyclic_gears::{ToothCount, simple_set::Member};
    /// # fn main() -> Result<(), epicyclic_gears::Error> {
    /// let teeth = [ToothCount::new(18)?, ToothCount::new(36)?, ToothCount::new(93)?];
    /// let set = Closing::default().close(teeth)?.set;
    /// let thinner = Deviation { lower: -0.012, upper: -0.008 };
    /// let play = set.backlash_at(Member::Sun, [thinner; 3], Deviation::default())?;
    /// // Four allowances, since the planets have two meshes: 4·0.008·cos 20°/r_bs.
    /// assert!((play.least - 4.0 * 0.008 / 9.0).abs() < 1e-12);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// Those of [`Pair::plays`].
    pub fn backlash_at(
        &self,
        output: Member,
        thickness: [Deviation; 3],
        centre_distance: Deviation,
    ) -> Result<Extent, Error> {
        centre_distance.check(Quantity::CentreDistanceDeviation)?;
        for deviation in &thickness {
            deviation.check(Quantity::ThicknessAllowance)?;
        }
        // The sum of both plays rises with the centre distance where α_w1 > α_w2 and falls otherwise, and
        // which it is does not change with it.
        let at = |allowances: [f64; 3], deviation: f64| {
            let [sun, planet, ring] = allowances;
            let outer = self.sun_mesh().deviating([sun, planet], deviation)?;
            let inner = self.ring_mesh().deviating([planet, ring], deviation)?;
            // j_bt = φ_1·r_b1
            let along = |pair: &Pair| pair.play().rotation_rad[0] * pair.gears()[0].base_diameter() / 2.0;
            Ok::<_, Error>((along(&outer) + along(&inner)) / self.lever(output))
        };
        let Deviation { lower, upper } = centre_distance;
        let [thick, thin] = [thickness.map(|it| it.upper), thickness.map(|it| it.lower)];
        Ok(Extent {
            least: at(thick, lower)?.min(at(thick, upper)?),
            greatest: at(thin, lower)?.max(at(thin, upper)?),
        })
    }

    /// Torque per radian with which a member resists while the two others are held, from the mesh stiffness
    /// `c_γ` and face width `b` of the sun–planet and the planet–ring mesh.
    ///
    /// ```text
    /// T/φ = (m·r)²·N/(1/(c_γ1·b_1) + 1/(c_γ2·b_2))
    /// ```
    ///
    /// `c_γ` is along the line of action in the transverse plane, as in ISO 6336-1: 20 N/(mm·µm) is 20 GPa.
    ///
    /// # Errors
    /// [`Error::NotPositive`].
    pub fn torsional_stiffness(
        &self,
        output: Member,
        module: Length,
        mesh_stiffness: [Pressure; 2],
        face_widths: [Length; 2],
    ) -> Result<Torque, Error> {
        let module = positive_length(Quantity::Module, module)?;
        let mut compliance = 0.0;
        for (stiffness, width) in mesh_stiffness.into_iter().zip(face_widths) {
            let stiffness = positive_stress(Quantity::MeshStiffness, stiffness)?;
            compliance += 1.0 / (stiffness * positive_length(Quantity::FaceWidth, width)?);
        }
        let lever = module * self.lever(output);
        Ok(Torque::from_si(lever * lever * f64::from(self.planets()) / compliance))
    }
}

/// A set as the output of a train feels it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Part {
    /// Torque `τ` on one of its members over that at the output, either sign.
    pub torque_share: f64,
    /// Torsional stiffness by [`PlanetSet::torsional_stiffness`] for that member; `None` where it is not
    /// known.
    pub stiffness: Option<Torque>,
    /// Backlash by [`PlanetSet::backlash_at`] for that member.
    pub backlash: Extent,
}

/// Torsional stiffness per radian and backlash, rad, at the output of a train while its input is held, in one
/// gear.
///
/// ```text
/// 1/k = Σ τ_j²/k_j        φ = Σ |τ_j|·φ_j
/// ```
///
/// The shares follow from the torques of that gear; a set without torque adds nothing. The stiffness is
/// infinite if no set has torque, and `None` if a set with torque has no known stiffness.
///
/// # Errors
/// [`Error::NotPositive`] for a stiffness of 0 or less.
pub fn at_output(parts: &[Part]) -> Result<(Option<Torque>, Extent), Error> {
    let mut compliance = Some(0.0);
    let mut backlash = Extent { least: 0.0, greatest: 0.0 };
    for part in parts {
        let stiffness = part.stiffness.map(positive_torque).transpose()?;
        compliance =
            compliance.zip(stiffness).map(|(sum, k)| sum + part.torque_share * part.torque_share / k);
        backlash.least += part.torque_share.abs() * part.backlash.least;
        backlash.greatest += part.torque_share.abs() * part.backlash.greatest;
    }
    Ok((compliance.map(|compliance| Torque::from_si(1.0 / compliance)), backlash))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ToothCount;
    use crate::involute::Profile;
    use crate::involute::closing::Closing;
    use crate::involute::family::Family;
    use proptest::prelude::*;
    use uom::si::f64::Angle;

    fn set(counts: [u32; 3]) -> PlanetSet {
        Closing::default().close(counts.map(|count| ToothCount::new(count).unwrap())).unwrap().set
    }

    #[test]
    fn limits_in_the_wrong_order_are_refused() {
        let wrong = Deviation { lower: -0.01, upper: -0.02 };
        let error = set([18, 36, 93]).backlash_at(Member::Sun, [wrong; 3], Deviation::default()).unwrap_err();
        assert_eq!(
            error.to_string(),
            "tooth thickness allowance from -0.01 to -0.02 modules: two finite numbers are needed, the smaller first"
        );
        let far = Deviation { lower: f64::NAN, upper: 0.0 };
        let error = set([18, 36, 93]).backlash_at(Member::Sun, Default::default(), far).unwrap_err();
        assert_eq!(error.name(), "deviation");
        let stiffness = |mm: f64| {
            let (width, c) = (Length::from_mm(mm), Pressure::from_si(20e9));
            set([18, 36, 93]).torsional_stiffness(Member::Sun, Length::from_mm(2.0), [c; 2], [width; 2])
        };
        assert_eq!(stiffness(0.0).unwrap_err().name(), "not-positive");
        let part = Part {
            torque_share: 1.0,
            stiffness: Some(Torque::from_si(0.0)),
            backlash: Extent { least: 0.0, greatest: 0.0 },
        };
        assert_eq!(at_output(&[part]).unwrap_err().name(), "not-positive");
    }

    #[test]
    fn thinner_teeth_have_smaller_measures_and_the_same_tips() {
        let planet = *set([18, 36, 93]).gears()[1];
        let thinner = planet.with_thickness_allowance(-0.01).unwrap();
        let normal = thinner.span(5) - planet.span(5);
        assert!((normal + 0.01 * libm::cos(20_f64.to_radians())).abs() < 1e-12);
        assert!((thinner.tip_diameter() - planet.tip_diameter()).abs() < 1e-12);
        let thickness = thinner.thickness_at(36.0) - planet.thickness_at(36.0);
        assert!((thickness + 0.01).abs() < 1e-12);
    }

    /// A sun of 18 and a ring of 90 teeth, 20 N/(mm·µm), b = 40 mm, m = 2 mm, three planets: by hand.
    #[test]
    fn the_stiffness_is_that_of_springs_between_the_base_circles() {
        let set = set([18, 36, 90]);
        let at = |member| {
            let (width, c) = (Length::from_mm(40.0), Pressure::from_si(20e9));
            set.torsional_stiffness(member, Length::from_mm(2.0), [c; 2], [width; 2]).unwrap().si()
        };
        let spring = 3.0 * 20e9 * 0.04 / 2.0;
        let lever = |teeth: f64| 0.001 * teeth * libm::cos(20_f64.to_radians());
        for (member, teeth) in [(Member::Sun, 18.0), (Member::Ring, 90.0), (Member::Carrier, 108.0)] {
            let by_hand = spring * lever(teeth).powi(2);
            assert!((at(member) / by_hand - 1.0).abs() < 1e-12, "{member}: {}", at(member));
        }
        // The held sun of a set in reduction is i² as soft at the carrier: i = 6.
        assert!((at(Member::Carrier) / at(Member::Sun) - 36.0).abs() < 1e-9);
    }

    /// Two sets in series, sun in, carrier out, rings held: the second sun turns the first carrier.
    #[test]
    fn a_train_adds_its_sets_by_virtual_work() {
        let part = |torque_share, stiffness, least| Part {
            torque_share,
            stiffness: Some(Torque::from_si(stiffness)),
            backlash: Extent { least, greatest: 2.0 * least },
        };
        // The second set has the ratio 4: its sun carries a quarter of the output torque.
        let (stiffness, backlash) = at_output(&[part(-0.25, 8e4, 0.004), part(1.0, 3e5, 0.001)]).unwrap();
        let by_hand = 1.0 / (1.0 / 3e5 + 1.0 / (16.0 * 8e4));
        assert!((stiffness.unwrap().si() / by_hand - 1.0).abs() < 1e-12);
        assert!((backlash.least - 0.002).abs() < 1e-15 && (backlash.greatest - 0.004).abs() < 1e-15);
        let unknown = Part { stiffness: None, ..part(-0.25, 8e4, 0.004) };
        assert!(at_output(&[unknown, part(1.0, 3e5, 0.001)]).unwrap().0.is_none());
    }

    proptest! {
        #[test]
        fn normal_backlash_grows_by_the_allowances_along_the_normal(
            sun in 17..50_u32, planet in 17..50_u32, offset in -2..=3_i32, helix in 0.0..25.0_f64,
            allowances in [-0.05..0.0_f64, -0.05..0.0_f64],
        ) {
            let profile = Profile { helix_angle: Angle::from_degrees(helix), ..Profile::default() };
            let ring = (sun + 2 * planet).checked_add_signed(offset).unwrap();
            let teeth = [sun, planet, ring].map(|count| ToothCount::new(count).unwrap());
            let closed = Closing { profiles: profile.into(), ..Closing::default() }.close(teeth);
            prop_assume!(closed.is_ok());
            let set = closed.unwrap().set;
            for pair in [set.sun_mesh(), set.ring_mesh()] {
                let one = |value: f64| Deviation { lower: value - 0.01, upper: value };
                let [least, greatest] = pair.plays(allowances.map(one), Deviation::default()).unwrap();
                let normal = -(allowances[0] + allowances[1]) * libm::cos(20_f64.to_radians());
                prop_assert!((least.normal - normal).abs() < 1e-10);
                prop_assert!((greatest.normal - normal - 0.02 * libm::cos(20_f64.to_radians())).abs() < 1e-10);
            }
        }

        /// Against every centre distance within the tolerance, and each mesh on its own.
        #[test]
        fn the_output_turns_no_less_and_no_more_anywhere_in_the_tolerance(
            sun in 17..50_u32, planet in 17..50_u32, offset in -2..=3_i32, lower in -0.03..0.0_f64, upper in 0.0..0.03_f64, part in 0.0..1.0_f64,
        ) {
            let ring = (sun + 2 * planet).checked_add_signed(offset).unwrap();
            let teeth = [sun, planet, ring].map(|count| ToothCount::new(count).unwrap());
            let closed = Closing::default().close(teeth);
            prop_assume!(closed.is_ok());
            let set = closed.unwrap().set;
            let thickness = [Deviation { lower: -0.03, upper: -0.02 }; 3];
            let whole = set.backlash_at(Member::Carrier, thickness, Deviation { lower, upper }).unwrap();
            let at = lower + part * (upper - lower);
            let within = set.backlash_at(Member::Carrier, thickness, Deviation { lower: at, upper: at }).unwrap();
            prop_assert!(whole.least <= within.least + 1e-12 && within.greatest <= whole.greatest + 1e-12);
            // One sum of shifts less at this centre distance is what the thinner teeth are.
            let a = set.centre_distance() + at;
            let family = Family::new(teeth, 3, Profile::default(), a).unwrap();
            let gears = set.gears();
            let along = |sum: f64, have: f64| 2.0 * (sum - have) * libm::sin(20_f64.to_radians());
            let [outer, inner] = family.sums();
            let gap = along(outer, gears[0].shift() + gears[1].shift()) + along(inner, gears[1].shift() + gears[2].shift());
            let lever = gears[0].base_diameter() / 2.0 + gears[2].base_diameter() / 2.0;
            let least = (gap + 4.0 * 0.02 * libm::cos(20_f64.to_radians())) / lever;
            prop_assert!((within.least - least).abs() < 1e-9, "{} {least}", within.least);
        }
    }
}

//! Losses of a mesh by sliding of the teeth.
//!
//! ```text
//! η = 1 − H_V·μ_m
//! H_V = 2·π·|u + 1|/(z_1·|u|·cos β_b)·∫ |ξ|/n(ξ) dξ    from −ε_2 to ε_1
//! u = z_2/z_1, below 0 with an internal gear
//! ```
//!
//! | symbol | argument | meaning | unit |
//! |---|---|---|---|
//! | `μ_m` | `friction` | mean coefficient of friction, given | 1 |
//! | `ξ` | | place on the path of contact from the pitch point, in base pitches | 1 |
//! | `n` | | pairs of teeth in contact, which share the load alike | 1 |
//! | `ε_1`, `ε_2` | | parts of `ε_α` from the pitch point to the tips of the first, second gear | 1 |
//!
//! The sliding velocity is proportional to `ξ`. `ε_1` or `ε_2` is below 0 where the pitch point lies outside
//! the path of contact.
//!
//! The integral is `(1 − ε_α + ε_1² + ε_2²)/2` if one or two pairs are in contact and the pitch point lies
//! where only one is, `0 ≤ ε_1, ε_2 ≤ 1`. This is the loss factor after Ohlendorf. Elsewhere that formula
//! does not hold; the integral is exact for any contact ratio of 1 and more.
//!
//! Left out: rolling friction, and whatever does not grow with the load. `μ_m` is an input: it depends on
//! oil, roughness, speed and load.
//!
//! # Source
//! The model of Ohlendorf's loss factor: one coefficient of friction, the load shared alike. The NREL
//! reference wind gearbox (Nejad, Guo, Gao, Moan 2016) prints 0.149 for its sun's mesh, and takes the closed
//! form for its ring, too, where the integral is less.

use super::pair::Pair;
use crate::checks::positive;
use crate::efficiency::MeshEfficiency;
use crate::{Error, Quantity};
use std::f64::consts::PI;

/// `H_V`.
///
/// # Errors
/// [`Error::NotAbove`] for a contact ratio below 1, at which the teeth do not hand the load on.
pub fn loss_factor(pair: &Pair) -> Result<f64, Error> {
    let [first, second] = pair.gears();
    let (z1, z2) = (first.teeth().as_f64(), second.teeth().as_f64());
    let sign = if pair.is_internal() { -1.0 } else { 1.0 };
    let contact_ratio = pair.transverse_contact_ratio();
    if contact_ratio.is_nan() || contact_ratio < 1.0 {
        return Err(Error::NotAbove {
            quantity: Quantity::ContactRatio,
            value: contact_ratio,
            low: 1.0,
            unit: "",
        });
    }
    let [from, to] = pair.contact();
    let pitch_point = pair.working_diameters()[0] / 2.0 * libm::sin(pair.working_angle_rad());
    let [one, two] = [to - pitch_point, pitch_point - from].map(|part| part / pair.base_pitch());
    let form = (z2 + sign * z1) / (z1 * z2);
    Ok(2.0 * PI * form / libm::cos(first.profile().base_helix_rad()) * shared_sliding(one, two))
}

/// `η`.
///
/// # Errors
/// [`Error::NotPositive`] for a friction of 0 or less, [`Error::OutOfRange`] above 1, [`Error::Efficiency`]
/// where it takes all power; those of [`loss_factor`].
///
/// # Example
/// ```
/// use epicyclic_gears::involute::{InvoluteGear, Pair, Profile, sliding};
/// use epicyclic_gears::{ToothCount, geometry::GearKind};
/// # fn main() -> Result<(), epicyclic_gears::Error> {
/// // FZG test gear, type C.
/// let gear = |teeth, shift|
///     InvoluteGear::new(GearKind::External, ToothCount::new(teeth)?, Profile::default(), shift);
/// let pair = Pair::at_centre_distance(gear(16, 0.1817)?, gear(24, 0.1715)?, 91.5 / 4.5)?;
/// assert!((sliding::loss_factor(&pair)? - 0.1986).abs() < 1e-3);
/// assert!((sliding::mesh_efficiency(&pair, 0.05)?.get() - 0.9901).abs() < 1e-4);
/// # Ok(())
/// # }
/// ```
pub fn mesh_efficiency(pair: &Pair, friction: f64) -> Result<MeshEfficiency, Error> {
    let friction = positive(Quantity::Friction, friction, "")?;
    if friction > 1.0 {
        return Err(Error::OutOfRange {
            quantity: Quantity::Friction,
            value: friction,
            low: 0.0,
            high: 1.0,
            unit: "",
        });
    }
    MeshEfficiency::new(1.0 - friction * loss_factor(pair)?)
}

/// `∫ |ξ|/n(ξ) dξ` over the path of contact from `−two` to `one`, in pieces with the same number of pairs.
fn shared_sliding(one: f64, two: f64) -> f64 {
    let whole = (one + two).floor();
    let steps = (0..=whole as u32).map(f64::from);
    let mut ends: Vec<f64> = steps.flat_map(|step| [step - two, one - step]).collect();
    ends.sort_by(f64::total_cmp);
    let piece = |ends: &[f64]| {
        let [from, to] = [ends[0], ends[1]];
        let middle = (from + to) / 2.0;
        let pairs = 1.0 + (middle + two).floor() + (one - middle).floor();
        (to * to.abs() - from * from.abs()) / (2.0 * pairs)
    };
    ends.windows(2).map(piece).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ToothCount;
    use crate::gear_kind::GearKind;
    use crate::involute::{InvoluteGear, Profile};
    use proptest::prelude::*;

    fn gear(kind: GearKind, teeth: u32, shift: f64) -> Result<InvoluteGear, Error> {
        InvoluteGear::new(kind, ToothCount::new(teeth).unwrap(), Profile::default(), shift)
    }

    /// Part of the power that sliding takes at a friction of 1: normal forces times sliding speeds over a
    /// base pitch, from the radii of curvature alone.
    fn sampled(pair: &Pair) -> f64 {
        const SAMPLES: u32 = 20_000;
        let [first, second] = pair.gears();
        let (bases, pitch) = ([first, second].map(|gear| gear.base_diameter() / 2.0), pair.base_pitch());
        let [from, to] = pair.contact();
        let speeds = [1.0, first.teeth().as_f64() / second.teeth().as_f64()];
        // Along the tangent a flank moves with ω·ρ.
        let sliding = |radius: f64| (speeds[0] * radius - speeds[1] * pair.mate(radius)).abs();
        let mut lost = 0.0;
        for sample in 0..SAMPLES {
            let phase = (f64::from(sample) + 0.5) / f64::from(SAMPLES) * pitch;
            let places: Vec<f64> = std::iter::successors(Some(from + phase), |radius| Some(radius + pitch))
                .take_while(|radius| *radius <= to)
                .collect();
            let force = 1.0 / bases[0] / places.len() as f64;
            lost += places.iter().map(|radius| force * sliding(*radius)).sum::<f64>();
        }
        lost / f64::from(SAMPLES)
    }

    proptest! {
        #[test]
        fn the_loss_factor_is_the_mean_of_what_the_teeth_slide(
            z1 in 9_u32..60, z2 in 12_u32..120, x1 in -0.3_f64..0.7, x2 in -0.3_f64..0.7, is_internal: bool,
        ) {
            let (kind, teeth) = if is_internal { (GearKind::Internal, z1 + z2) } else { (GearKind::External, z2) };
            let pair = gear(GearKind::External, z1, x1).and_then(|one| Pair::without_backlash(one, gear(kind, teeth, x2)?));
            prop_assume!(pair.is_ok());
            let pair = pair.unwrap();
            prop_assume!(pair.transverse_contact_ratio() >= 1.0);
            let found = loss_factor(&pair).unwrap();
            prop_assert!((found - sampled(&pair)).abs() < 1e-4 * (1.0 + found), "{} {}", found, sampled(&pair));
        }

        #[test]
        fn around_the_pitch_point_it_is_ohlendorfs(one in 0.05_f64..1.0, two in 0.05_f64..1.0) {
            prop_assume!(one + two >= 1.0);
            let closed = (1.0 - (one + two) + one * one + two * two) / 2.0;
            prop_assert!((shared_sliding(one, two) - closed).abs() < 1e-14);
        }
    }

    #[test]
    fn what_gives_no_efficiency_is_refused() {
        let [pinion, wheel] = [(20, 0.0), (40, 0.0)].map(|(z, x)| gear(GearKind::External, z, x).unwrap());
        let pair = Pair::without_backlash(pinion, wheel).unwrap();
        for friction in [0.0, -0.05, f64::NAN] {
            assert!(matches!(
                mesh_efficiency(&pair, friction),
                Err(Error::NotPositive { quantity: Quantity::Friction, .. })
            ));
        }
        assert!(matches!(mesh_efficiency(&pair, 1.5), Err(Error::OutOfRange { .. })));
        let apart = Pair::at_centre_distance(pinion, wheel, 31.5).unwrap();
        assert!(matches!(loss_factor(&apart), Err(Error::NotAbove { quantity: Quantity::ContactRatio, .. })));
    }
}

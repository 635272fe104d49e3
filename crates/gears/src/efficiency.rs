//! Torques and efficiency of a gear set from the losses of its meshes.
//!
//! Relative to the carrier a gear set is an ordinary gear: the power that enters at one central gear
//! leaves at the other, less what the meshes take. The share that arrives is `η₀`.
//!
//! ```text
//! T_b = −i₀·η₀^w·T_a      w = +1 where T_a·(ω_a − ω_H) > 0 (power flows from a to b), else −1
//! T_H = −T_a − T_b
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `T_a`, `T_b`, `T_H` | torque on sun, ring, carrier from outside the set | N·m |
//! | `η₀` | efficiency of the set with the carrier fixed | 1 |
//!
//! Mesh losses alone: bearings, churning and seals are left out.
//!
//! # Source
//! excavator-dynamics, efficiency of the mechanism; multispeed-gearboxes, section 2.3.

use crate::Error;
use crate::simple_set::{BasicRatio, Member, Mode};
use crate::tolerance::LEAST_EFFICIENCY;
use epicyclic_units::Physical;
use std::fmt;
use uom::si::f64::Torque;

/// Efficiency `η₀` of a gear set (or of one mesh) with the carrier fixed, `0 < η₀ ≤ 1`.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct MeshEfficiency(f64);

impl fmt::Display for MeshEfficiency {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}

impl MeshEfficiency {
    /// A gear without losses.
    pub const IDEAL: Self = Self(1.0);

    /// An efficiency.
    ///
    /// # Errors
    /// [`Error::Efficiency`] unless `0 < η ≤ 1`, [`Error::EfficiencyTooSmall`] below [`LEAST`](Self::LEAST).
    pub fn new(eta: f64) -> Result<Self, Error> {
        match eta {
            _ if !(eta > 0.0 && eta <= 1.0) => Err(Error::Efficiency { eta }),
            _ if eta < Self::LEAST => Err(Error::EfficiencyTooSmall { eta, least: Self::LEAST }),
            _ => Ok(Self(eta)),
        }
    }

    /// The least that is taken: far below any gear, and large enough that products and reciprocals over all
    /// sets of a gearbox stay numbers.
    pub const LEAST: f64 = LEAST_EFFICIENCY;

    /// The efficiency as a number.
    #[must_use]
    pub fn get(self) -> f64 {
        self.0
    }

    /// Loss factor `ψ = 1 − η`.
    #[must_use]
    pub fn loss(self) -> f64 {
        1.0 - self.0
    }

    /// Part of the loss of two meshes in a row that the first has, `ln η_1/(ln η_1 + ln η_2)`: `(η_1·η_2)` to
    /// this power is `η_1`. A half where neither loses.
    #[must_use]
    pub fn share_of_loss(first: Self, second: Self) -> f64 {
        let [first, second] = [first, second].map(|eta| libm::log(eta.get()));
        if first + second == 0.0 { 0.5 } else { first / (first + second) }
    }

    /// Efficiency of a set from those of its meshes, which the power passes one after the other:
    /// `η₀ = Π η_j`.
    #[must_use]
    pub fn of_meshes(meshes: &[Self]) -> Self {
        Self(meshes.iter().map(|mesh| mesh.0).product::<f64>().max(f64::MIN_POSITIVE))
    }
}

/// Torques on the three members of a set, from outside; they sum to zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SetTorques {
    /// Torque on the sun, `T_a`.
    pub sun: Torque,
    /// Torque on the ring, `T_b`.
    pub ring: Torque,
    /// Torque on the carrier, `T_H`.
    pub carrier: Torque,
}

/// Torques on the members of a set driven in `mode` by `input_torque`, with mesh losses.
///
/// # Errors
/// [`Error::CarrierUndetermined`] with the carrier driving or driven at `i₀ = 1`.
pub fn torques(
    set: BasicRatio,
    eta0: MeshEfficiency,
    mode: Mode,
    input_torque: Torque,
) -> Result<SetTorques, Error> {
    let [sun, ring, carrier] = unit_torques(set, eta0, mode)?;
    let input = input_torque.si();
    Ok(SetTorques {
        sun: Torque::from_si(sun * input),
        ring: Torque::from_si(ring * input),
        carrier: Torque::from_si(carrier * input),
    })
}

/// Efficiency of a set in `mode`: power that leaves over power that enters.
///
/// Zero or less where the losses would take more than enters: the set is self-locking in this mode
/// and moves only if the output is driven too.
///
/// For a simple set (`i₀ = −k`):
///
/// | mode | η |
/// |---|---|
/// | `ab^H`, `ba^H` | `η₀` |
/// | `aH^b` | `(1 + k·η₀)/(1 + k)` |
/// | `bH^a` | `(k + η₀)/(1 + k)` |
/// | `Ha^b` | `(1 + k)·η₀/(k + η₀)` |
/// | `Hb^a` | `(1 + k)·η₀/(1 + k·η₀)` |
///
/// # Errors
/// [`Error::CarrierUndetermined`] with the carrier driving or driven at `i₀ = 1`.
pub fn efficiency(set: BasicRatio, eta0: MeshEfficiency, mode: Mode) -> Result<f64, Error> {
    let unit = unit_torques(set, eta0, mode)?;
    // The input has torque 1 and speed 1, the output speed 1/i.
    Ok(-unit[mode.output() as usize] / set.ratio(mode)?)
}

/// Torques on sun, ring and carrier for a torque of 1 on the input.
fn unit_torques(set: BasicRatio, eta0: MeshEfficiency, mode: Mode) -> Result<[f64; 3], Error> {
    let i0 = set.get();
    let ratio = set.ratio(mode)?;
    let speed = |member: Member| match member {
        m if m == mode.input() => 1.0,
        m if m == mode.output() => 1.0 / ratio,
        _ => 0.0,
    };
    let with = |i: f64| {
        let per_sun_torque = [1.0, -i, i - 1.0];
        per_sun_torque.map(|t| t / per_sun_torque[mode.input() as usize])
    };
    // The direction of the rolling power is that of the set without losses: losses never reverse it
    // on the branch that is continuous with η₀ → 1.
    let rolling_power = with(i0)[Member::Sun as usize] * (speed(Member::Sun) - speed(Member::Carrier));
    Ok(with(if rolling_power > 0.0 { i0 * eta0.get() } else { i0 / eta0.get() }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simple_set::RingToSunRatio;
    use proptest::prelude::*;

    fn mode(input: Member, output: Member) -> Mode {
        Mode::new(input, output).unwrap()
    }

    fn set(i0: f64) -> BasicRatio {
        BasicRatio::new(i0).unwrap()
    }

    fn eta(value: f64) -> MeshEfficiency {
        MeshEfficiency::new(value).unwrap()
    }

    #[test]
    fn excavator_loses_four_per_cent() {
        let eta0 = MeshEfficiency::of_meshes(&[eta(0.97), eta(0.98)]);
        let found = efficiency(set(-5.0), eta0, mode(Member::Sun, Member::Carrier)).unwrap();
        assert!((found - (1.0 + 5.0 * 0.9506) / 6.0).abs() < 1e-15);
    }

    #[test]
    fn what_is_lost_is_what_does_not_arrive() {
        assert_eq!(eta(0.75).loss(), 0.25);
        assert_eq!(MeshEfficiency::IDEAL.loss(), 0.0);
        // Two meshes one after the other lose ψ₁ + ψ₂ − ψ₁·ψ₂.
        let both = MeshEfficiency::of_meshes(&[eta(0.75), eta(0.5)]);
        assert_eq!(both.loss(), 0.25 + 0.5 - 0.125);
    }

    #[test]
    fn a_basic_ratio_near_one_is_self_locking_towards_the_carrier() {
        // Carrier driven through i₀ = 0.99 with 3 % loss: the output torque changes sign.
        let found = efficiency(set(0.99), eta(0.97), mode(Member::Sun, Member::Carrier)).unwrap();
        assert!(found < 0.0);
        let driving = efficiency(set(0.99), eta(0.97), mode(Member::Carrier, Member::Sun)).unwrap();
        assert!(driving > 0.0 && driving < 0.5);
    }

    #[test]
    fn impossible_efficiencies_are_refused() {
        for bad in [0.0, -0.1, 1.0001, f64::NAN] {
            assert!(MeshEfficiency::new(bad).is_err());
        }
        for tiny in [1e-7, 1e-310, f64::MIN_POSITIVE] {
            assert_eq!(
                MeshEfficiency::new(tiny),
                Err(Error::EfficiencyTooSmall { eta: tiny, least: MeshEfficiency::LEAST })
            );
        }
    }

    #[test]
    fn a_carrier_that_nothing_moves_carries_no_power() {
        let found = efficiency(set(1.0), eta(0.97), mode(Member::Sun, Member::Carrier));
        assert_eq!(found, Err(Error::CarrierUndetermined));
    }

    proptest! {
        #[test]
        fn simple_set_follows_its_closed_forms(k in 1.05..12.0, eta0 in 0.5..1.0) {
            let closed = [
                eta0,
                (1.0 + k * eta0) / (1.0 + k),
                (k + eta0) / (1.0 + k),
                eta0,
                (1.0 + k) * eta0 / (k + eta0),
                (1.0 + k) * eta0 / (1.0 + k * eta0),
            ];
            for (mode, closed) in Mode::ALL.into_iter().zip(closed) {
                let found = efficiency(RingToSunRatio::new(k).unwrap().into(), eta(eta0), mode).unwrap();
                prop_assert!((found - closed).abs() < 1e-13, "{} {} {}", mode, found, closed);
            }
        }

        #[test]
        fn torques_and_powers_balance(
            i0 in prop_oneof![-12.0..-0.05, 0.05..0.95, 1.05..12.0_f64],
            eta0 in 0.5..1.0,
            mode in proptest::sample::select(&Mode::ALL[..]),
            input in 1.0..1e4,
        ) {
            let found = torques(set(i0), eta(eta0), mode, Torque::from_si(input)).unwrap();
            let all = [found.sun, found.ring, found.carrier].map(Physical::si);
            let largest = all.iter().fold(0.0_f64, |m, t| m.max(t.abs()));
            prop_assert!(all.iter().sum::<f64>().abs() <= 1e-13 * largest);

            // Power in, power out and the loss of the meshes: what the central gears leave of the
            // rolling power, computed without the efficiency.
            let ratio = set(i0).ratio(mode).unwrap();
            let speed = Member::ALL.map(|m| {
                if m == mode.input() { 1.0 } else if m == mode.output() { 1.0 / ratio } else { 0.0 }
            });
            let power_in = input;
            let power_out = -all[mode.output() as usize] * speed[mode.output() as usize];
            let loss = all[0] * (speed[0] - speed[2]) + all[1] * (speed[1] - speed[2]);
            prop_assert!(loss >= -1e-12 * largest);
            prop_assert!((power_in - power_out - loss).abs() <= 1e-12 * largest.max(power_out.abs()));
            let eta = efficiency(set(i0), eta(eta0), mode).unwrap();
            prop_assert!((eta * power_in - power_out).abs() <= 1e-12 * largest.max(power_out.abs()));
            prop_assert!(eta <= 1.0 + 1e-12);
        }
    }
}

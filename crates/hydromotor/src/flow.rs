//! Flow and torque for ideal ports, without leaks, and their ripple.
//!
//! Ideal ports join every growing chamber with the high pressure and every shrinking one with the low one.
//! The flow per radian is `b·Σ dA/dφ` over the growing chambers; by the virtual work the torque is that times
//! `Δp`. Both have one ripple:
//!
//! ```text
//! Q(φ) = b·Σ max(0, f(Φⱼ + 2π/n) − f(Φⱼ))      M(φ) = Q·Δp
//! M = q·Δp/(2π)      δ = (Q_max − Q_min)/Q_mean
//! ```
//!
//! `Q` has the period `2π/lcm(N, n)` and is even about `φ = 0`. It is smooth except where a chamber changes
//! over (at 0 and at half a period) and where a satellite passes a junction of the arcs. Its extremes are
//! searched for on each smooth piece, at the ends and at the zeros of `dQ/dφ` between eight places.
//!
//! # Pulses
//!
//! A chamber grows by `g(Φ) = f(Φ + 2π/n) − f(Φ)` per radian, with the period `P = 2π·(N + n)/(N·n)`: the
//! phase by which a satellite comes from crest to crest. The `N + n` chambers are `2π/n` of the phase apart.
//! With `d = gcd(N, n)` this gives `p = (N + n)/d` different phases, evenly spread over `P`, each of `d`
//! chambers. All growths sum to 0, so that the growing chambers take as much as the shrinking ones leave:
//!
//! ```text
//! Q(φ) = ½·b·d·Σ |g(φ + k·P/p)|, k = 0 … p − 1
//! ```
//!
//! `g` vanishes where a chamber is greatest and, half a period on, where it is least. It vanishes nowhere
//! else, since `f` is even about crests and troughs and falls between them. There `|g|` has a kink, and `Q` a
//! dip; between two dips it has one crest. With an even `p` a chamber is greatest while another is least: `p`
//! dips in `P`. With an odd `p` the two kinds alternate: `2·p` dips. A growth like a sine would give, with
//! `M` pulses in `P`:
//!
//! ```text
//! δ = (π/M)·tan(π/(2·M)) ≈ π²/(2·M²)
//! ```
//!
//! This is 7.8 % with 8 pulses (5×3), 5.0 % with 10 (6×4) and 1.0 % with 22 (7×4). The growth of a motor
//! differs from a sine, and its ripple from this.
//!
//! The number of pulses depends on `N − n`:
//! - 1 or 3 lobes more: `M = 2·(N + n)`, but a third of it with 3 lobes more if 3 divides `n`;
//! - 2 lobes more: `M = N + n`.
//!
//! rotary-hydromotor remarks that the torque fluctuates less the nearer `N/n` is to 1. This holds among
//! motors with 1 lobe more and among those with 2; in general it does not.

use crate::quantity::Quantity;
use uom::si::f64::{Angle, AngularVelocity, Area, Length, Power, Pressure, Torque, VolumeRate};

use crate::Error;
use crate::contact::Conjugate;
use crate::modules::{area, volume};
use crate::motor::Motor;
use crate::ranges::{finite_angle, finite_pressure, finite_speed};
use crate::tolerance::{BESIDE_JUMP, WITHIN};
use std::f64::consts::TAU;

/// Pieces of a smooth stretch of the flow in the search for its extremes.
const PIECES: u32 = 4;

/// The flow over width, a radian of the rotor, and its ripple; times `Δp` and width it is the torque.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ripple {
    /// The least.
    pub least: Area,
    /// The greatest.
    pub greatest: Area,
    /// The mean over a revolution, `q/(2π·b)`.
    pub mean: Area,
    /// `δ = (greatest − least)/mean`.
    pub delta: f64,
}

impl Motor {
    /// Flow over width a radian of the rotor, after a rotation.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub fn flow_per_width(&self, rotation: Angle) -> Result<Area, Error> {
        Ok(area(self.flow_kernel(finite_angle(Quantity::Rotation, rotation)?).0, self.module()))
    }

    /// `Q/b` and its slope in units of the module.
    fn flow_kernel(&self, rotation: f64) -> (f64, f64) {
        // N and n with a common divisor d repeat everything d times; satellite j of 0…(N + n)/d suffices.
        let divisor = self.numbers().common_divisor();
        let satellites = self.numbers().satellites() / divisor;
        let at = |j: u32| self.shape.flow(self.phase(rotation, j));
        let first = at(0);
        let (mut back, mut sum, mut slope) = (first, 0.0, 0.0);
        for j in 1..=satellites {
            let front = if j == satellites { first } else { at(j) };
            if front.0 > back.0 {
                sum += front.0 - back.0;
                slope += front.1 - back.1;
            }
            back = front;
        }
        (sum * f64::from(divisor), slope * f64::from(divisor))
    }

    /// The ripple of flow and torque.
    ///
    /// ```
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::{f64::Length, length::millimeter};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(5, 3, 55, 10)?, mm(1.0), mm(40.0))?;
    /// assert!((motor.ripple().delta - 0.0764).abs() < 5e-5);
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    #[must_use]
    pub fn ripple(&self) -> Ripple {
        let (least, greatest) = self.flow_extremes();
        let mean = self.displacement_kernel() / TAU;
        let [least_area, greatest_area, mean_area] =
            [least, greatest, mean].map(|value| area(value, self.module()));
        Ripple {
            least: least_area,
            greatest: greatest_area,
            mean: mean_area,
            delta: (greatest - least) / mean,
        }
    }

    /// The least and the greatest `Q/b` in units of the module.
    pub(crate) fn flow_extremes(&self) -> (f64, f64) {
        let numbers = self.numbers();
        let product = f64::from(numbers.stator_lobes() * numbers.rotor_lobes());
        let half = TAU * f64::from(numbers.common_divisor()) / product / 2.0;
        // A junction at ±Φ, folded into half a period.
        let kink = self.shape.kink().map(|phase| {
            let rest = phase.rem_euclid(2.0 * half);
            rest.min(2.0 * half - rest)
        });
        let mut ends = vec![0.0];
        ends.extend(kink.filter(|&kink| kink > WITHIN * half && kink < (1.0 - WITHIN) * half));
        ends.push(half);
        let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
        let mut meet = |value: f64| {
            least = least.min(value);
            greatest = greatest.max(value);
        };
        meet(self.flow_kernel(0.0).0);
        for pair in ends.windows(2) {
            // Slopes jump at the ends: taken a hair within.
            let hair = BESIDE_JUMP * (pair[1] - pair[0]);
            let (from, to) = (pair[0] + hair, pair[1] - hair);
            let mut before = (from, self.flow_kernel(from));
            for i in 1..=PIECES {
                let place = from + (to - from) * f64::from(i) / f64::from(PIECES);
                let here = (place, self.flow_kernel(place));
                meet(here.1.0);
                if before.1.1 * here.1.1 < 0.0 {
                    meet(flat(before, here, |place| self.flow_kernel(place)));
                }
                before = here;
            }
            meet(self.flow_kernel(pair[1]).0);
        }
        (least, greatest)
    }

    /// Mean flow at a speed of the rotor: `q·ω/(2π)`.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for the width, [`Error::NotFinite`] for the speed.
    pub fn mean_flow(&self, width: Length, speed: AngularVelocity) -> Result<VolumeRate, Error> {
        let (width, speed) = (crate::machine::width(width)?, finite_speed(speed)?);
        Ok(volume(self.displacement_kernel() / TAU, self.module(), width) * speed)
    }

    /// Theoretical torque, the mean over a revolution without leaks and friction: `M = q·Δp/(2π)`.
    ///
    /// | symbol | argument | meaning | unit |
    /// |---|---|---|---|
    /// | `b` | `width` | width of the wheels | m |
    /// | `Δp` | `pressure_drop` | high less low pressure; negative, it drives the rotor back | Pa |
    ///
    /// # Errors
    /// [`Error::NotPositive`] for the width, [`Error::NotFinite`] for the pressure.
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::f64::{Length, Pressure};
    /// use uom::si::{length::millimeter, pressure::megapascal, torque::newton_meter};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(5, 3, 55, 10)?, mm(2.0), mm(80.0))?;
    /// let torque = motor.theoretical_torque(mm(50.0), Pressure::new::<megapascal>(20.0))?;
    /// // 1412.9151·2²·50 mm³ · 20 MPa/(2π)
    /// assert!((torque.get::<newton_meter>() - 899.49).abs() < 0.01);
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn theoretical_torque(&self, width: Length, pressure_drop: Pressure) -> Result<Torque, Error> {
        let width = crate::machine::width(width)?;
        let pressure_drop = finite_pressure(Quantity::PressureDrop, pressure_drop)?;
        Ok((volume(self.displacement_kernel() / TAU, self.module(), width) * pressure_drop).into())
    }

    /// Torque without leaks and friction after a rotation of the rotor.
    ///
    /// # Errors
    /// As [`theoretical_torque`](Self::theoretical_torque), and [`Error::NotFinite`] for the rotation.
    pub fn torque(&self, rotation: Angle, width: Length, pressure_drop: Pressure) -> Result<Torque, Error> {
        let width = crate::machine::width(width)?;
        let pressure_drop = finite_pressure(Quantity::PressureDrop, pressure_drop)?;
        let (flow, _) = self.flow_kernel(finite_angle(Quantity::Rotation, rotation)?);
        Ok((volume(flow, self.module(), width) * pressure_drop).into())
    }

    /// Theoretical power at a speed: `M·ω`.
    ///
    /// # Errors
    /// As [`theoretical_torque`](Self::theoretical_torque), and [`Error::NotFinite`] for the speed.
    pub fn theoretical_power(
        &self,
        width: Length,
        pressure_drop: Pressure,
        speed: AngularVelocity,
    ) -> Result<Power, Error> {
        Ok(self.theoretical_torque(width, pressure_drop)? * finite_speed(speed)?)
    }
}

/// The value of a function where its slope vanishes between two places.
fn flat(before: (f64, (f64, f64)), here: (f64, (f64, f64)), f: impl Fn(f64) -> (f64, f64)) -> f64 {
    // The value is flat there: a place to a hundred-thousandth of the piece gives it to its last digits. Each
    // place is where the cubic through values and slopes at the bracket's ends is flat.
    let ((mut low, mut at_low), (mut high, mut at_high)) = (before, here);
    let near = 1e-5 * (high - low);
    let mut best = f64::NAN;
    for step in 0..60 {
        let width = high - low;
        let mean = 3.0 * (at_high.0 - at_low.0) / width;
        let middle = at_low.1 + at_high.1 - mean;
        let root = (middle * middle - at_low.1 * at_high.1).max(0.0).sqrt().copysign(at_high.1 - at_low.1);
        let part = 1.0 - (at_high.1 + root - middle) / (at_high.1 - at_low.1 + 2.0 * root);
        // Halved now and then, should a bracket not close in.
        let part = if part > 0.0 && part < 1.0 && step % 8 != 7 { part } else { 0.5 };
        let place = low + part * width;
        let at_place = f(place);
        let moved = (place - low).min(high - place);
        best = at_place.0;
        if moved < near || at_place.1 == 0.0 {
            break;
        }
        if (at_place.1 < 0.0) == (at_low.1 < 0.0) {
            (low, at_low) = (place, at_place);
        } else {
            (high, at_high) = (place, at_place);
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::centrode::tests::any_motor;
    use epicyclic_numerics::quadrature::quadrature;
    use epicyclic_units::Physical;
    use proptest::prelude::*;

    fn m(value: f64) -> Length {
        Length::from_si(value)
    }

    fn get(area: Area) -> f64 {
        area.si()
    }

    #[test]
    fn the_ripples_of_the_restored_vectors_are_met() {
        for (numbers, l, delta) in
            [((5, 3, 55, 10), 40.0, 0.0764), ((5, 3, 55, 10), 30.0, 0.0853), ((6, 4, 66, 10), 40.0, 0.0537)]
        {
            let numbers = crate::MotorNumbers::new(numbers.0, numbers.1, numbers.2, numbers.3).unwrap();
            let motor = Motor::of_two_arcs(numbers, m(1.0), m(l)).unwrap();
            assert!((motor.ripple().delta - delta).abs() < 5e-5, "{}", motor.ripple().delta);
        }
    }

    /// A motor with 11 teeth a lobe and satellites of 10, at a part of its family.
    fn with_lobes(stator: u32, rotor: u32, part: f64) -> Motor {
        let numbers = crate::MotorNumbers::new(stator, rotor, 11 * stator, 10).unwrap();
        let arcs = crate::closure::Family::new(numbers, m(1.0)).unwrap().at_part(part).unwrap();
        Motor::of_two_arcs(numbers, m(1.0), arcs.trough_distance()).unwrap()
    }

    /// Crests of the flow over a revolution, by even samples: a second way to the number of pulses.
    fn counted_pulses(motor: &Motor) -> u32 {
        let numbers = motor.numbers();
        let count = 400 * numbers.stator_lobes() * numbers.rotor_lobes();
        // Beside the dips at 0 and its multiples, so that no two samples are the same by symmetry.
        let flow = |i: u32| motor.flow_kernel(TAU * (f64::from(i) + 0.3) / f64::from(count)).0;
        let flows: Vec<f64> = (0..count).map(flow).collect();
        let at = |i: usize| flows[i % flows.len()];
        (0..flows.len()).filter(|&i| at(i + 1) > at(i) && at(i + 1) >= at(i + 2)).count() as u32
    }

    #[test]
    fn the_flow_has_the_pulses_of_its_lobes() {
        for (stator, rotor, in_cycle, in_revolution) in
            [(5, 3, 8, 15), (6, 4, 10, 24), (7, 5, 12, 35), (7, 4, 22, 56), (8, 5, 26, 80), (9, 6, 10, 36)]
        {
            let motor = with_lobes(stator, rotor, 0.3);
            let numbers = motor.numbers();
            assert_eq!(numbers.pulses_per_cycle(), in_cycle, "{stator}×{rotor}");
            assert_eq!(numbers.pulses_per_revolution(), in_revolution, "{stator}×{rotor}");
            assert_eq!(counted_pulses(&motor), in_revolution, "{stator}×{rotor}");
        }
    }

    #[test]
    fn pulses_order_the_ripple_and_the_ratio_of_lobes_does_not() {
        let ripple = |stator, rotor| with_lobes(stator, rotor, 0.3).ripple().delta;
        let expected = [(6, 4, 0.074), (7, 4, 0.018), (8, 5, 0.011), (9, 6, 0.068), (5, 3, 0.0805)];
        for (stator, rotor, delta) in expected {
            assert!(
                (ripple(stator, rotor) - delta).abs() < 6e-4,
                "{stator}×{rotor}: {}",
                ripple(stator, rotor)
            );
        }
        // 7/4 is farther from 1 than 6/4 and 5/3, 8/5 than 9/6.
        assert!(ripple(7, 4) < ripple(6, 4) && ripple(7, 4) < ripple(5, 3) && ripple(8, 5) < ripple(9, 6));
    }

    /// Phases, but for periods, at which a satellite passes a crest, a trough or a junction, or a chamber
    /// changes over.
    fn breaks(motor: &Motor) -> Vec<f64> {
        let end = motor.shape.trough().phase;
        let mut breaks = vec![0.0, end, 0.5 * motor.chamber_phase(), end - 0.5 * motor.chamber_phase()];
        breaks.extend(motor.shape.kink());
        breaks.into_iter().flat_map(|place| [place, -place]).collect()
    }

    /// Least and greatest flow over a period from `start` on, by samples: 2000 even ones, and more around
    /// every break. A break is a place where a satellite passes a crest, a trough or a junction, or a chamber
    /// changes over. The samples come ever closer there, since the least may be a dip as sharp as a needle.
    /// The neighbourhood of the best is refined by golden section.
    fn sampled_extremes(motor: &Motor, start: f64) -> [f64; 2] {
        let period = motor.period();
        let flow = |rotation: f64| get(motor.flow_per_width(Angle::from_si(rotation)).unwrap());
        let even: Vec<f64> = (0..=2000).map(|i| period * f64::from(i) / 2000.0).collect();
        let near = breaks(motor).into_iter().flat_map(|place: f64| {
            let place = (place - start).rem_euclid(period);
            (4..46).flat_map(move |k| [-1.0, 1.0].map(|side| place + side * period * 0.5_f64.powi(k)))
        });
        let flows: Vec<f64> = even.iter().map(|place| flow(start + place)).collect();
        let at_breaks: Vec<f64> = near.map(|place| flow(start + place)).collect();
        [1.0, -1.0].map(|sign| {
            let value = |k: usize| sign * flows[k];
            let best = flows.iter().chain(&at_breaks).map(|flow| sign * flow).fold(f64::INFINITY, f64::min);
            // Every dip that may be the deepest: an even sample misses less than a hundredth of the flow.
            let dips = (1..flows.len() - 1)
                .filter(|&k| value(k) <= value(k - 1).min(value(k + 1)) && value(k) < best + 0.01 * flows[k]);
            let deepest = |k: usize| {
                let (mut low, mut high, mut least) = (even[k - 1], even[k + 1], value(k));
                for _ in 0..60 {
                    let [left, right] = [0.382, 0.618].map(|part| low + part * (high - low));
                    let [at_left, at_right] = [left, right].map(|place| sign * flow(start + place));
                    least = least.min(at_left).min(at_right);
                    if at_left < at_right {
                        high = right;
                    } else {
                        low = left;
                    }
                }
                least
            };
            sign * dips.map(deepest).fold(best, f64::min)
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]

        /// The flow by growing chambers is half of all growths without their signs.
        #[test]
        fn the_flow_is_half_of_what_all_chambers_change(motor in any_motor(), rotation in -9.0..9.0) {
            let chambers = motor.chambers(Angle::from_si(rotation)).unwrap();
            let half: f64 = chambers.iter().map(|chamber| get(chamber.growth).abs()).sum::<f64>() / 2.0;
            let flow = get(motor.flow_per_width(Angle::from_si(rotation)).unwrap());
            prop_assert!((half - flow).abs() < 1e-9 * get(motor.ripple().mean), "{half} {flow}");
        }

        #[test]
        fn displacement_is_the_integral_of_the_flow(motor in any_motor(), start in -9.0..9.0_f64) {
            let closed = get(motor.displacement_per_width());
            // Smooth from break to break; the panels close in on both ends, near which a nearly radial flank
            // makes it steep.
            let mut edges: Vec<f64> = breaks(&motor).iter().map(|&place| (place - start).rem_euclid(motor.period())).collect();
            edges.extend([0.0, motor.period()]);
            edges.sort_by(f64::total_cmp);
            let flow = |place: f64| motor.flow_kernel(start + place).0;
            let piece = |pair: &[f64]| {
                let middle = 0.5 * (pair[0] + pair[1]);
                let half = middle - pair[0];
                // x = end ∓ half·t⁴ from either end.
                let from = |end: f64, side: f64| quadrature(0.0, 1.0, 12, |t: f64| 4.0 * t * t * t * flow(end + side * half * t.powi(4)));
                half * (from(pair[0], 1.0) + from(pair[1], -1.0))
            };
            let integral: f64 = edges.windows(2).map(piece).sum::<f64>() * TAU / motor.period();
            prop_assert!((integral - closed).abs() < 1e-10 * closed, "{integral} {closed}");
        }

        #[test]
        fn the_ripple_is_that_of_samples_from_any_start(motor in any_motor(), start in -9.0..9.0) {
            let ripple = motor.ripple();
            let (least, greatest, mean) = (get(ripple.least), get(ripple.greatest), get(ripple.mean));
            let [low, high] = sampled_extremes(&motor, start);
            // Both ways end on a value that is flat, or on a kink to 1e-12 of the period.
            prop_assert!((low - least).abs() < 1e-9 * mean && (high - greatest).abs() < 1e-9 * mean, "{low} {least} {high} {greatest}");
            prop_assert!(((high - low) / mean - ripple.delta).abs() < 2e-9);
        }

        #[test]
        fn the_slope_of_the_flow_is_that_of_differences(motor in any_motor(), rotation in -3.0..3.0) {
            let h = 1e-6;
            let [back, here, front] = [rotation - h, rotation, rotation + h].map(|rotation| motor.flow_kernel(rotation));
            let kink = (front.1 - back.1).abs() > 1e-2 * here.1.abs().max(0.1);
            let difference = (front.0 - back.0) / (2.0 * h);
            prop_assert!(kink || (difference - here.1).abs() < 1e-3 * here.1.abs().max(1.0), "{difference} {}", here.1);
        }

        #[test]
        fn torque_and_power_agree_with_the_flow(motor in any_motor(), drop in -3e7..3e7, speed in -50.0..50.0) {
            let width = m(0.1);
            let pressure = Pressure::from_si(drop);
            let omega = AngularVelocity::from_si(speed);
            let power = motor.theoretical_power(width, pressure, omega).unwrap().value;
            let flow = motor.mean_flow(width, omega).unwrap().value;
            prop_assert!((power - flow * drop).abs() <= 1e-12 * power.abs());
            prop_assert!(motor.theoretical_torque(m(-1.0), pressure).is_err());
            let torque = motor.torque(Angle::from_si(0.3), width, pressure).unwrap().value;
            let flow = get(motor.flow_per_width(Angle::from_si(0.3)).unwrap());
            prop_assert!((torque - flow * 0.1 * drop).abs() <= 1e-12 * torque.abs());
        }
    }
}

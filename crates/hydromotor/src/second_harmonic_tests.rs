#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use super::*;
use crate::Motor;
use crate::contact::{By, Conjugate};
use crate::numbers::Bounds;
use epicyclic_units::Physical;
use proptest::prelude::*;
use std::f64::consts::PI;
use uom::si::f64::Length;

fn mm(value: f64) -> Length {
    Length::from_mm(value)
}

fn numbers(n: (u32, u32, u32, u32)) -> MotorNumbers {
    MotorNumbers::new(n.0, n.1, n.2, n.3).unwrap()
}

const SIX: (u32, u32, u32, u32) = (6, 4, 66, 10);

/// `c`, `ε₁`, `A_max − A_min` to the digits printed, and whether the stator has a cusp.
#[test]
fn the_figures_of_the_six_by_four_motor_are_met() {
    for (second, c, amplitude, swing, cusp) in
        [(0.0, 21.0321, 0.10893, 92.647, true), (0.015, 21.0176, 0.10702, 96.395, false)]
    {
        let law = closure(numbers(SIX), mm(1.0), second).unwrap();
        assert!((law.mean_radius.mm() - c).abs() < 5e-5, "{law:?}");
        assert!((law.amplitude - amplitude).abs() < 5e-6, "{law:?}");
        assert_eq!(law.least_stretch < 0.0, cusp, "{law:?}");
        // The areas of the law, with cusps or without.
        let kernel = Numbers::of(numbers(SIX)).at_second(second).unwrap();
        let motor = Motor::of_law(numbers(SIX), mm(1.0), kernel);
        let [least, greatest] = motor.chamber_extremes();
        assert!(((greatest - least).mm2() - swing).abs() < 5e-4);
        assert_eq!(Motor::of_second_harmonic(numbers(SIX), mm(1.0), second).is_err(), cusp);
    }
    // More than the best motor of two arcs, 96.19.
    let family = crate::closure::Family::new(numbers(SIX), mm(1.0)).unwrap();
    let swing = |part: f64| {
        let l = family.at_part(part).unwrap().trough_distance();
        let [least, greatest] = Motor::of_two_arcs(numbers(SIX), mm(1.0), l).unwrap().chamber_extremes();
        (greatest - least).mm2()
    };
    let best = -golden(0.01, 0.99, 60, |part| -swing(part)).1;
    let scanned = (1..200).map(|i| swing(f64::from(i) / 200.0)).fold(0.0, f64::max);
    assert!((best - 96.19).abs() < 5e-3 && scanned <= best + 1e-9, "{best} {scanned}");
}

/// The least stretch, the law's radii and the closure by other ways: differences of the curve, and the polar
/// sum of the stator.
#[test]
fn a_law_keeps_both_closures() {
    for (n, second) in [(SIX, 0.015), (SIX, 0.004), ((5, 3, 55, 10), 0.02), ((8, 6, 88, 10), -0.0002)] {
        let motor = Motor::of_second_harmonic(numbers(n), mm(1.0), second).unwrap();
        let law = motor.harmonic_law().unwrap();
        assert_eq!(law.second_amplitude, second);
        assert!(motor.cosine_law().is_none() && motor.arcs().is_none());
        let (c, lobes) = (law.mean_radius.mm(), f64::from(n.1));
        let rho = |theta: f64| {
            c * (1.0 + law.amplitude * libm::cos(lobes * theta) + second * libm::cos(2.0 * lobes * theta))
        };
        // The half-lobe's length by chords, halved twice and extrapolated.
        let length = |chords: u32| -> f64 {
            let at = |i: u32| {
                let theta = PI / lobes * f64::from(i) / f64::from(chords);
                [rho(theta) * libm::cos(theta), rho(theta) * libm::sin(theta)]
            };
            (0..chords).map(|i| libm::hypot(at(i)[0] - at(i + 1)[0], at(i)[1] - at(i + 1)[1])).sum()
        };
        let (coarse, fine) = (length(4000), length(8000));
        let half = PI * f64::from(n.2) / f64::from(n.0) / 2.0;
        assert!((fine + (fine - coarse) / 3.0 - half).abs() < 1e-9);
        // The stator's polar angle grows to π/N: dθ₃ = cos μ/ρ₃·ds₃ by the midpoint rule over the rotor's
        // angle.
        let steps = 4000;
        let trough = motor.shape.trough();
        let by_angle = |i: u32| {
            motor.shape.within(By::RotorAngle, trough.theta1 * (f64::from(i) + 0.5) / f64::from(steps))
        };
        let mut before = motor.shape.at(By::Phase, 0.0);
        let (mut polar, mut length, mut least) = (0.0, 0.0, f64::INFINITY);
        for i in 0..=steps {
            let here = if i < steps { by_angle(i) } else { *trough };
            let [x, y] =
                [before, here].map(|at| [at.rho3 * libm::cos(at.theta3), at.rho3 * libm::sin(at.theta3)]);
            polar += libm::atan2(x[0] * y[1] - x[1] * y[0], x[0] * y[0] + x[1] * y[1]);
            let chord = libm::hypot(x[0] - y[0], x[1] - y[1]);
            length += chord;
            if i > 0 && i < steps {
                least = f64::min(least, chord / (here.s1 - before.s1));
            }
            before = here;
        }
        assert!((polar - PI / f64::from(n.0)).abs() < 1e-12 && (trough.theta3 - polar).abs() < 1e-12);
        assert!((length - half).abs() < 1e-4 * half);
        assert!((least - law.least_stretch).abs() < 2e-3, "{least} {law:?}");
    }
}

#[test]
fn without_a_second_harmonic_it_is_the_motor_of_the_cosine_law() {
    let mut compared = 0;
    for numbers in Bounds::default().all().unwrap().into_iter().step_by(20) {
        let cosine = Motor::of_cosine_law(numbers, mm(2.0));
        let second = Motor::of_second_harmonic(numbers, mm(2.0), 0.0);
        assert_eq!(cosine.is_ok(), second.is_ok());
        if let (Ok(cosine), Ok(second)) = (cosine, second) {
            assert_eq!(cosine, second);
            // By the way of the second harmonic, too, to the last digits.
            let law = closure(numbers, mm(2.0), 0.0).unwrap();
            let known = cosine.cosine_law().unwrap();
            assert!((law.amplitude / known.amplitude - 1.0).abs() < 1e-11);
            assert!((law.mean_radius / known.mean_radius).value - 1.0 < 1e-12);
            compared += 1;
        }
    }
    assert!(compared > 10, "{compared}");
}

/// Every seventh set: between the ends every motor closes and is smooth, beyond them none, by another way
/// than that which found them.
#[test]
fn the_range_is_what_a_scan_finds() {
    let (mut with, mut without, mut limits) = (0, 0, Vec::new());
    for numbers in Bounds::default().all().unwrap().into_iter().step_by(7) {
        let kernel = Numbers::of(numbers);
        let smooth = |second: f64| kernel.at_second(second).is_some_and(|law| law.least_stretch() > 0.0);
        match range(numbers) {
            Ok(HarmonicRange { lower, upper }) => {
                let (low, high) = (lower.second_amplitude, upper.second_amplitude);
                assert!(low < high);
                let at = |part: f64| low + (high - low) * part;
                for part in [1e-4, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0 - 1e-4] {
                    assert!(smooth(at(part)), "{numbers:?} {part} {lower:?} {upper:?}");
                }
                for part in [-2.0, -0.5, -0.1, -1e-3, 1.0 + 1e-3, 1.1, 1.5, 3.0] {
                    assert!(!smooth(at(part)), "{numbers:?} {part} {lower:?} {upper:?}");
                }
                limits.extend([lower.limit, upper.limit]);
                with += 1;
            }
            Err(Error::NoSecondHarmonicRotor { excess_deg }) => {
                assert!(excess_deg >= 0.0);
                for i in -40..=120 {
                    assert!(!smooth(f64::from(i) / 1000.0), "{numbers:?} {i}");
                }
                without += 1;
            }
            Err(error) => panic!("{error}"),
        }
    }
    assert!(with > 50 && without > 50, "{with} {without}");
    for limit in [HarmonicLimit::StatorCusp, HarmonicLimit::FlatTrough] {
        assert!(limits.contains(&limit), "{limit:?}");
    }
}

/// Ranges given in the chapter of the theory, from the closure's own stretch on either side.
#[test]
fn the_ranges_of_the_two_motors_of_the_document() {
    for (n, low, high) in [(SIX, 0.0011, 0.0252), ((5, 3, 55, 10), 0.0034, 0.0333)] {
        let HarmonicRange { lower, upper } = range(numbers(n)).unwrap();
        assert_eq!((lower.limit, upper.limit), (HarmonicLimit::StatorCusp, HarmonicLimit::FlatTrough));
        let told = |value: f64| (value * 1e4).round() / 1e4;
        assert_eq!([told(lower.second_amplitude), told(upper.second_amplitude)], [low, high], "{n:?}");
        let stretch = |second: f64| closure(numbers(n), mm(1.0), second).unwrap().least_stretch;
        let cusp = bracketed(low - 1e-3, low + 1e-3, stretch);
        assert!((cusp - lower.second_amplitude).abs() < 1e-8, "{cusp}");
        assert!((upper.amplitude - 4.0 * upper.second_amplitude).abs() < 1e-12);
    }
}

#[test]
fn bad_amplitudes_are_refused() {
    let of = |second: f64| Motor::of_second_harmonic(numbers(SIX), mm(1.0), second).unwrap_err();
    let outside = of(0.05);
    assert!(matches!(outside, Error::OutsideHarmonic { .. }) && outside.name() == "outside-harmonic");
    insta::assert_snapshot!(outside.to_string(), @"ε₂ = 0.05: a second-harmonic rotor of these numbers closes without cusps for ε₂ between 0.001115 and 0.025171");
    assert!(
        matches!(of(-0.05), Error::OutsideHarmonic { .. })
            && matches!(of(0.0), Error::OutsideHarmonic { .. })
    );
    assert!(matches!(of(f64::NAN), Error::NotFinite { quantity: Quantity::SecondAmplitude, .. }));
    assert!(
        matches!(of(1e300), Error::OutsideHarmonic { .. })
            && matches!(of(-1e300), Error::OutsideHarmonic { .. })
    );
    let few = Motor::of_second_harmonic(numbers((3, 1, 48, 8)), mm(1.0), 0.01).unwrap_err();
    assert!(matches!(few, Error::NoSecondHarmonicRotor { .. }) && few.name() == "no-second-harmonic-rotor");
    assert!(few.to_string().contains("take more satellite teeth"));
    assert!(matches!(
        Motor::of_second_harmonic(numbers(SIX), mm(0.0), 0.01),
        Err(Error::NotPositive { quantity: Quantity::Module, .. })
    ));
    assert!(
        closure(numbers(SIX), mm(1.0), f64::INFINITY).is_err()
            && closure(numbers(SIX), mm(1.0), 0.2).is_err()
    );
}

/// Random numbers with a range, and a part of it.
pub(crate) fn any_law() -> impl Strategy<Value = (MotorNumbers, f64)> {
    let sets: Vec<_> = Bounds::default().all().unwrap().into_iter().step_by(3).collect();
    (proptest::sample::select(sets), 0.001..0.999)
}

/// A motor that closes, whether its rotor turns within the stator or not.
fn closed(numbers: MotorNumbers, second: f64) -> Motor {
    Motor::of_law(numbers, mm(1.0), *lobe(numbers, second).unwrap().law())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Arc lengths, chords on a ray, Euler and Savary against differences.
    #[test]
    fn satellites_roll_equal_arcs_on_both_wheels((numbers, part) in any_law(), place in 0.01..0.99_f64) {
        let Ok(HarmonicRange { lower, upper }) = range(numbers) else { return Ok(()) };
        let second = lower.second_amplitude + part * (upper.second_amplitude - lower.second_amplitude);
        let motor = closed(numbers, second);
        let (trough, r) = (*motor.shape.trough(), motor.shape.satellite_radius());
        prop_assert!((trough.s1 - trough.s3).abs() < 1e-11 && (trough.s3 - crate::arcs::half_length(numbers)).abs() < 1e-10);
        prop_assert!((trough.theta3 - PI / f64::from(numbers.stator_lobes())).abs() < 1e-11);
        let [back, here, front] = [-1e-5, 0.0, 1e-5].map(|by| motor.shape.within(By::RotorAngle, (place + by) * trough.theta1));
        prop_assert!((here.rho3 - here.rho1 - 2.0 * r * libm::cos(here.mu)).abs() < 1e-12 * here.rho3);
        // The satellite's turn: as ds₃ and ds₁ roll off, each by its curvature against the path.
        let rate = |get: &dyn Fn(&crate::contact::Contact) -> f64| (get(&front) - get(&back)) / (front.theta1 - back.theta1);
        let (s3, s1) = (rate(&|at| at.s3), rate(&|at| at.s1));
        prop_assert!((rate(&|at| at.theta3) - libm::cos(here.mu) / here.rho3 * s3).abs() < 1e-5);
        // Normals turn by κ·ds: dθ − dμ.
        let turn3 = rate(&|at| at.theta3 - at.mu);
        let turn1 = rate(&|at| at.theta1 - at.mu);
        prop_assert!((turn3 - here.kappa3 * s3).abs() < 1e-4 * (1.0 + turn3.abs()), "{turn3} {}", here.kappa3 * s3);
        prop_assert!((turn1 - here.kappa1 * s1).abs() < 1e-4 * (1.0 + turn1.abs()));
        prop_assert!(s3 > 0.0 && here.rho1 < motor.shape.within(By::RotorAngle, 0.0).rho1);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn the_extremes_of_the_curvature_are_those_of_finer_samples((numbers, part) in any_law()) {
        let Ok(HarmonicRange { lower, upper }) = range(numbers) else { return Ok(()) };
        let second = lower.second_amplitude + part * (upper.second_amplitude - lower.second_amplitude);
        let motor = closed(numbers, second);
        let end = motor.shape.trough().phase;
        let places = (0..=4000).map(|i| motor.shape.within(By::Phase, end * f64::from(i) / 4000.0));
        let sampled = crate::contact::greatest_curvatures(places);
        for (exact, sampled) in motor.shape.curvature_extremes().into_iter().zip(sampled) {
            prop_assert!(exact >= sampled * (1.0 - 1e-9) - 1e-12 && exact <= sampled * (1.0 + 1e-3) + 1e-6, "{exact} {sampled}");
        }
    }
}

//! A cosine-law rotor and the stator conjugate to it: the literature's other way, for comparison.
//!
//! ```text
//! ρ₁ = c·(1 + ε·cos nθ₁)
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `c` | mean radius of the rotor's centrode | m |
//! | `ε` | relative amplitude | 1 |
//!
//! Two conditions fix both: a half-lobe has the length `π·m·Z₁/(2n)`, and the stator closes, `∫ dΦ = π/N + π/n` with
//! `dΦ = 2·cos μ·(1 + r·κ₁)/ρ₃·ds₁` and `ρ₃ = ρ₁ + 2r·cos μ`, so that the numbers leave no choice: one motor, no family. The
//! stator's half-lobe spans too much with round wheels, by the condition on `Z_s`, and less the greater `ε`.
//!
//! The stator is smooth while `ds₃/ds₁ = 1 − 2r·(cos μ/ρ₁ − κ₁) > 0`. This is least at the rotor's trough, where it vanishes at
//! the *cusp limit*
//!
//! ```text
//! 2·r·ε·n² = c·(1 − ε)²
//! ```
//!
//! Integrals are by Gauss–Legendre rules on 48 panels, to 1e-13 and better.
//!
//! # Source
//! Not in rotary-hydromotor, which takes arcs; the conjugation is that of [`crate::closure`] with the wheels changed.

use std::f64::consts::PI;

use crate::Error;
use crate::arcs::half_length;
use crate::contact::{By, Conjugate, Contact, conjugate_curvature, inverse};
use crate::numbers::MotorNumbers;
use crate::roots::{bracketed, quadrature, quadratures};
use crate::tolerance::WITHIN;
use crate::units::degrees;

const PANELS: u32 = 48;

/// A half-lobe of a cosine-law rotor and its stator.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Cosine {
    law: Law,
    trough: Contact,
    /// `s₁`, `Φ`, `G` at the ends of the panels.
    edges: Vec<[f64; 3]>,
}

/// The rotor's law.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Law {
    n: f64,
    r: f64,
    c: f64,
    amplitude: f64,
}

impl Law {
    /// Of a relative amplitude, scaled to a half-lobe's length.
    fn of_length(n: f64, r: f64, amplitude: f64, half_length: f64) -> Self {
        let unit = Self { n, r, c: 1.0, amplitude };
        Self { c: half_length / quadrature(0.0, PI / n, PANELS, |theta| unit.rates(theta)[0]), ..unit }
    }

    /// `ρ₁`, `dρ₁/dθ₁`, `ds₁/dθ₁`, `κ₁`.
    fn curve(&self, theta: f64) -> (f64, f64, f64, f64) {
        let (sin, cos) = (self.n * theta).sin_cos();
        let swing = self.c * self.amplitude;
        let rho = self.c + swing * cos;
        let (slope, bend) = (-swing * self.n * sin, -swing * self.n * self.n * cos);
        let square = rho * rho + slope * slope;
        let speed = square.sqrt();
        (rho, slope, speed, (square + slope * slope - rho * bend) / (square * speed))
    }

    /// `ρ₁`, `μ`, `κ₁`.
    fn shape(&self, theta: f64) -> (f64, f64, f64) {
        let (rho, slope, _, kappa) = self.curve(theta);
        (rho, slope.atan2(rho), kappa)
    }

    /// `ds₁/dθ₁`, `dΦ/dθ₁`, `dG/dθ₁`.
    fn rates(&self, theta: f64) -> [f64; 3] {
        let (rho1, _, speed, kappa1) = self.curve(theta);
        // cos μ·ds₁ = ρ₁·dθ₁
        let rho3 = rho1 + 2.0 * self.r * rho1 / speed;
        let bend = 1.0 + self.r * kappa1;
        [speed, 2.0 * bend * rho1 / rho3, bend * rho1 * rho1]
    }

    fn span(&self) -> f64 {
        quadrature(0.0, PI / self.n, PANELS, |theta| self.rates(theta)[1])
    }

    /// `ds₃/ds₁` at the trough, where it is least.
    fn stretch(&self) -> f64 {
        let trough = self.c * (1.0 - self.amplitude);
        1.0 - 2.0 * self.r * self.c * self.amplitude * self.n * self.n / (trough * trough)
    }
}

impl Cosine {
    /// The motor of these numbers.
    pub(crate) fn new(numbers: MotorNumbers) -> Result<Self, Error> {
        let n = f64::from(numbers.rotor_lobes());
        let r = f64::from(numbers.satellite_teeth()) / 2.0;
        let wanted = PI / f64::from(numbers.stator_lobes()) + PI / n;
        let of = |amplitude| Law::of_length(n, r, amplitude, half_length(numbers));
        let cusp_amplitude = bracketed(0.0, 1.0 - WITHIN, |amplitude| of(amplitude).stretch());
        let excess = |amplitude: f64| of(amplitude).span() - wanted;
        let left = excess(cusp_amplitude);
        if left >= 0.0 {
            return Err(Error::NoCosineRotor { cusp_amplitude, excess_deg: degrees(left) });
        }
        Ok(Self::of_law(of(bracketed(0.0, cusp_amplitude, excess))))
    }

    fn of_law(law: Law) -> Self {
        let width = PI / law.n / f64::from(PANELS);
        let mut edges = vec![[0.0; 3]];
        let mut sum = [0.0; 3];
        for panel in 0..PANELS {
            let from = width * f64::from(panel);
            let more = quadratures(from, from + width, |theta| law.rates(theta));
            for (sum, more) in sum.iter_mut().zip(more) {
                *sum += more;
            }
            edges.push(sum);
        }
        let trough = contact(&law, PI / law.n, sum);
        Self { law, trough: Contact { mu: 0.0, s3: trough.s1, ..trough }, edges }
    }

    /// The rotor's mean radius.
    pub(crate) fn mean_radius(&self) -> f64 {
        self.law.c
    }

    /// The rotor's relative amplitude.
    pub(crate) fn amplitude(&self) -> f64 {
        self.law.amplitude
    }

    /// The relative amplitude at which the stator, of the same mean radius, gets cusps.
    pub(crate) fn cusp_amplitude(&self) -> f64 {
        // c·(1 − ε)² = 2·r·n²·ε: the smaller root, as a quotient of sums.
        let p = 1.0 + self.law.r * self.law.n * self.law.n / self.law.c;
        1.0 / (p + (p * p - 1.0).sqrt())
    }

    fn on_rotor(&self, theta1: f64) -> Contact {
        let width = PI / self.law.n / f64::from(PANELS);
        let panel = ((theta1 / width) as usize).min(PANELS as usize - 1);
        let from = width * panel as f64;
        let mut sums = self.edges[panel];
        let rest = quadratures(from, theta1, |theta| self.law.rates(theta));
        for (sum, rest) in sums.iter_mut().zip(rest) {
            *sum += rest;
        }
        contact(&self.law, theta1, sums)
    }
}

fn contact(law: &Law, theta1: f64, [s1, phase, swept]: [f64; 3]) -> Contact {
    let (rho1, mu, kappa1) = law.shape(theta1);
    let rho3 = rho1 + 2.0 * law.r * mu.cos();
    Contact {
        phase,
        theta3: phase - theta1,
        theta1,
        rho3,
        rho1,
        mu,
        s3: s1 - 2.0 * law.r * mu,
        s1,
        kappa3: conjugate_curvature(-law.r, mu.cos(), rho1, kappa1, rho3),
        kappa1,
        swept,
    }
}

impl Conjugate for Cosine {
    fn satellite_radius(&self) -> f64 {
        self.law.r
    }

    fn trough(&self) -> &Contact {
        &self.trough
    }

    fn kink(&self) -> Option<f64> {
        None
    }

    fn rotor_area(&self) -> f64 {
        let Law { n, c, amplitude, .. } = self.law;
        c * c * (1.0 + 0.5 * amplitude * amplitude) * PI / (2.0 * n)
    }

    fn within(&self, by: By, value: f64) -> Contact {
        let end = self.trough.theta1;
        if by == By::RotorAngle {
            return self.on_rotor(value);
        }
        let start = end * value / self.trough.get(by);
        let theta1 = inverse(value, end, start, |theta1| {
            let contact = self.on_rotor(theta1);
            let r = self.law.r;
            (contact.get(by), contact.slope(by, r) / contact.slope(By::RotorAngle, r))
        });
        self.on_rotor(theta1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::closure::tests::any_motor;
    use proptest::prelude::*;

    #[test]
    fn the_cusp_limit_is_where_the_stator_stops() {
        let lobe = Cosine::new(MotorNumbers::new(8, 6, 88, 10).unwrap()).unwrap();
        let at_limit = Law { amplitude: lobe.cusp_amplitude(), ..lobe.law };
        assert!(at_limit.stretch().abs() < 1e-13 && lobe.amplitude() < lobe.cusp_amplitude());
        // The source's own numbers leave it 0.18° short.
        let refused = Cosine::new(MotorNumbers::new(5, 3, 55, 10).unwrap());
        assert!(matches!(refused, Err(Error::NoCosineRotor { .. })));
    }

    /// `ρ₁ = c·(1 ± ε)` at crest and trough, and `2·r·ε·n² = c·(1 − ε)²` at the cusp limit.
    #[test]
    fn the_law_of_a_motor_is_that_of_its_rotor() {
        use crate::Motor;
        use uom::si::f64::Length;
        use uom::si::length::millimeter;
        let (mm, numbers) = (Length::new::<millimeter>, MotorNumbers::new(8, 6, 88, 10).unwrap());
        let motor = Motor::of_cosine_law(numbers, mm(1.5)).unwrap();
        let law = motor.cosine_law().unwrap();
        let c = law.mean_radius.get::<millimeter>();
        let [crest, trough] =
            [motor.shape.at(By::Phase, 0.0).rho1, motor.shape.trough().rho1].map(|modules| 1.5 * modules);
        assert!((crest - c * (1.0 + law.amplitude)).abs() < 1e-11 * c, "{crest} {law:?}");
        assert!((trough - c * (1.0 - law.amplitude)).abs() < 1e-11 * c, "{trough} {law:?}");
        let (r, n, cusp) = (motor.satellite_radius().get::<millimeter>(), 6.0, law.cusp_amplitude);
        assert!((2.0 * r * cusp * n * n - c * (1.0 - cusp).powi(2)).abs() < 1e-11 * c, "{law:?}");
        // A motor of two arcs has none.
        let arcs = Motor::of_two_arcs(MotorNumbers::new(5, 3, 55, 10).unwrap(), mm(1.0), mm(40.0)).unwrap();
        assert!(arcs.cosine_law().is_none() && arcs.arcs().is_some() && motor.arcs().is_none());
    }

    proptest! {
        #[test]
        fn the_motor_closes_and_its_stator_is_smooth(motor in any_motor()) {
            let (numbers, part) = motor;
            if let Ok(lobe) = Cosine::new(numbers) {
                prop_assert!((lobe.trough.theta3 - PI / f64::from(numbers.stator_lobes())).abs() < 1e-12);
                prop_assert!((lobe.trough.s3 - half_length(numbers)).abs() < 1e-11);
                let contact = lobe.on_rotor(part * PI / lobe.law.n);
                let r = lobe.law.r;
                let stretch = 1.0 / contact.slope(By::RotorArc, r);
                prop_assert!(stretch >= lobe.law.stretch() - 1e-12);
                // Half the panels give the same.
                let coarse = quadrature(0.0, PI / lobe.law.n, PANELS / 2, |theta| lobe.law.rates(theta)[1]);
                prop_assert!((coarse - lobe.trough.phase).abs() < 1e-12);
            }
        }

        #[test]
        fn the_span_falls_with_the_amplitude(motor in any_motor()) {
            let (numbers, part) = motor;
            let n = f64::from(numbers.rotor_lobes());
            let of = |amplitude| Law::of_length(n, f64::from(numbers.satellite_teeth()) / 2.0, amplitude, half_length(numbers));
            let (less, more) = (of(0.9 * part), of(0.9 * part + 0.01));
            if more.stretch() > 0.0 {
                prop_assert!(more.span() < less.span());
            }
        }
    }
}

//! A rotor by a cosine law, with or without a second harmonic, and the stator conjugate to it: the
//! literature's other way.
//!
//! ```text
//! ρ₁ = c·(1 + ε₁·cos nθ₁ + ε₂·cos 2nθ₁)
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `c` | mean radius of the rotor's centrode | m |
//! | `ε₁`, `ε` | relative amplitude | 1 |
//! | `ε₂` | relative amplitude of the second harmonic; 0 of the cosine law | 1 |
//!
//! Two conditions fix `c` and `ε₁`. A half-lobe has the length `π·m·Z₁/(2n)`. The stator closes,
//! `∫ dΦ = π/N + π/n`, with `dΦ = 2·cos μ·(1 + r·κ₁)/ρ₃·ds₁` and `ρ₃ = ρ₁ + 2r·cos μ`. The numbers leave the
//! cosine law no choice: one motor, no family; with the second harmonic `ε₂` is free
//! ([`crate::second_harmonic`]). With round wheels the stator's half-lobe spans too much, by the condition on
//! `Z_s`; the span falls with `ε₁`.
//!
//! The stator is smooth while `ds₃/ds₁ = 1 − 2r·(cos μ/ρ₁ − κ₁) > 0`. For the cosine law this is least at the
//! rotor's trough, where it vanishes at the *cusp limit*:
//!
//! ```text
//! 2·r·ε·n² = c·(1 − ε)²
//! ```
//!
//! With `u = ln ρ₁` and dashes for derivatives by `θ₁` it is `1 − 2r·u″/(ρ₁·(1 + u′²)^(3/2))`. With a second
//! harmonic above 0 the least is at the trough or between it and the crest, and is searched for along the
//! half-lobe. While it is above 0 everything else is smooth, too: `1 + r·κ₁ > ½ + r·cos μ/ρ₁ > 0`, and
//! `1 − r·κ₃ = (1 + r·κ₁)·ds₁/ds₃ > 0`. Radii fall from crest to trough while `ε₁ > 4·|ε₂|`.
//!
//! Integrals are by Gauss–Legendre rules on 48 panels, to 1e-13 and better.
//!
//! # Source
//! Not in rotary-hydromotor, which takes arcs; the conjugation is that of [`crate::closure`] with the wheels
//! changed.

use std::f64::consts::PI;

use crate::Error;
use crate::arcs::half_length;
use crate::contact::{By, Conjugate, Contact, conjugate_curvature};
use crate::numbers::MotorNumbers;
use crate::tolerance::{BESIDE_ROOT, LAST_STEP, WITHIN};
use epicyclic_numerics::extremes::golden;
use epicyclic_numerics::quadrature::{few_quadratures, quadrature, quadratures};
use epicyclic_numerics::roots::{bracketed, inverse};
use epicyclic_units::Physical;
use uom::si::f64::Angle;

const PANELS: u32 = 48;

/// Panels where a root is only bracketed.
const FEW_PANELS: u32 = 6;

/// Places of the half-lobe at which curvatures are evaluated before their extremes are refined.
const CURVATURE_PLACES: usize = 256;

/// Places of the half-lobe at which a quantity is evaluated before its extreme is refined.
const PLACES: u32 = 16;

/// A half-lobe of a cosine-law rotor and its stator.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Cosine {
    law: Law,
    trough: Contact,
    /// Contacts at the ends of the panels.
    edges: Vec<Contact>,
}

/// The rotor's law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Law {
    n: f64,
    r: f64,
    pub(crate) c: f64,
    pub(crate) amplitude: f64,
    /// `ε₂`.
    pub(crate) second: f64,
}

impl Law {
    /// Law of relative amplitudes, scaled to a half-lobe's length.
    fn of_length(n: f64, r: f64, [amplitude, second]: [f64; 2], half_length: f64, panels: u32) -> Self {
        let unit = Self { n, r, c: 1.0, amplitude, second };
        Self { c: half_length / quadrature(0.0, PI / n, panels, |theta| unit.curve(theta).2), ..unit }
    }

    /// `ρ₁`, `dρ₁/dθ₁`, `ds₁/dθ₁`, `κ₁`.
    fn curve(&self, theta: f64) -> (f64, f64, f64, f64) {
        let (sin, cos) = libm::sincos(self.n * theta);
        let (sin_twice, cos_twice) = (2.0 * sin * cos, 2.0 * cos * cos - 1.0);
        let (swing, second) = (self.c * self.amplitude, self.c * self.second);
        let rho = self.c + swing * cos + second * cos_twice;
        let slope = -swing * self.n * sin - 2.0 * second * self.n * sin_twice;
        let bend = -swing * self.n * self.n * cos - 4.0 * second * self.n * self.n * cos_twice;
        let square = rho * rho + slope * slope;
        let speed = square.sqrt();
        (rho, slope, speed, (square + slope * slope - rho * bend) / (square * speed))
    }

    /// `ρ₁`, `μ`, `κ₁`.
    fn shape(&self, theta: f64) -> (f64, f64, f64) {
        let (rho, slope, _, kappa) = self.curve(theta);
        (rho, libm::atan2(slope, rho), kappa)
    }

    /// `ρ₁²·d(tan μ)/dθ₁`, of the sign with which the slope `μ` grows.
    pub(crate) fn slope_rate(&self, theta: f64) -> f64 {
        let (rho, slope, speed, kappa) = self.curve(theta);
        // ρ·ρ″ − ρ′², with ρ·ρ″ = ρ² + 2·ρ′² − κ·(ds/dθ)³
        rho * rho + slope * slope - kappa * speed * speed * speed
    }

    /// `ds₁/dθ₁`, `dΦ/dθ₁`, `dG/dθ₁`.
    fn rates(&self, theta: f64) -> [f64; 3] {
        let (rho1, _, speed, kappa1) = self.curve(theta);
        // cos μ·ds₁ = ρ₁·dθ₁
        let rho3 = rho1 + 2.0 * self.r * rho1 / speed;
        let bend = 1.0 + self.r * kappa1;
        [speed, 2.0 * bend * rho1 / rho3, bend * rho1 * rho1]
    }

    /// Angle that the stator's and the rotor's half-lobes span together.
    fn span(&self, panels: u32) -> f64 {
        quadrature(0.0, PI / self.n, panels, |theta| self.rates(theta)[1])
    }

    /// `ds₃/ds₁` at the trough, where that of a cosine law is least.
    fn stretch(&self) -> f64 {
        let trough = self.c * (1.0 - self.amplitude + self.second);
        let bend = self.amplitude - 4.0 * self.second;
        1.0 - 2.0 * self.r * self.c * bend * self.n * self.n / (trough * trough)
    }

    /// `κ₃` and `κ₁`.
    fn curvatures(&self, theta: f64) -> [f64; 2] {
        let (rho1, mu, kappa1) = self.shape(theta);
        let cos_mu = libm::cos(mu);
        [conjugate_curvature(-self.r, cos_mu, rho1, kappa1, rho1 + 2.0 * self.r * cos_mu), kappa1]
    }

    /// `ds₃/ds₁`.
    pub(crate) fn stretch_at(&self, theta: f64) -> f64 {
        let (_, _, speed, kappa) = self.curve(theta);
        // cos μ/ρ₁ = 1/(ds₁/dθ₁)
        1.0 - 2.0 * self.r * (1.0 / speed - kappa)
    }

    /// The least `ds₃/ds₁` along the half-lobe.
    pub(crate) fn least_stretch(&self) -> f64 {
        let end = PI / self.n;
        let place = |i: u32| end * f64::from(i) / f64::from(PLACES);
        let (least, i) = (0..=PLACES)
            .map(|i| (self.stretch_at(place(i)), i))
            .fold((f64::INFINITY, 0), |best, here| if here.0 < best.0 { here } else { best });
        if i == 0 || i == PLACES {
            // Even about crest and trough.
            return least;
        }
        golden(place(i - 1), place(i + 1), 28, |theta| self.stretch_at(theta)).1.min(least)
    }
}

/// The numbers as the closure of a law needs them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Numbers {
    n: f64,
    r: f64,
    half_length: f64,
    wanted: f64,
}

impl Numbers {
    pub(crate) fn of(numbers: MotorNumbers) -> Self {
        let n = f64::from(numbers.rotor_lobes());
        Self {
            n,
            r: f64::from(numbers.satellite_teeth()) / 2.0,
            half_length: half_length(numbers),
            wanted: PI / f64::from(numbers.stator_lobes()) + PI / n,
        }
    }

    fn law(&self, amplitudes: [f64; 2], panels: u32) -> Law {
        Law::of_length(self.n, self.r, amplitudes, self.half_length, panels)
    }

    /// Angle that the half-lobes span too much.
    fn excess(&self, amplitudes: [f64; 2], panels: u32) -> f64 {
        self.law(amplitudes, panels).span(panels) - self.wanted
    }

    /// Amplitude `ε₁` at which the stator gets cusps, at a part `t = 4·ε₂/ε₁`, and the angle that the
    /// half-lobes span too little there. The angle is above 0 if a motor without cusps closes.
    pub(crate) fn cusp(&self, part: f64) -> (f64, f64) {
        // ρ₁ vanishes at the trough where ε₁ − ε₂ = 1; long before, the stator has cusps.
        let most = 0.999 / (1.0 - 0.25 * part);
        let amplitudes = |amplitude: f64| [amplitude, 0.25 * part * amplitude];
        let cusp =
            bracketed(0.0, most, |amplitude| self.law(amplitudes(amplitude), FEW_PANELS).least_stretch());
        (cusp, -self.excess(amplitudes(cusp), FEW_PANELS))
    }

    /// The law that closes at a part `t = 4·ε₂/ε₁`, free of cusps.
    pub(crate) fn at_part(&self, part: f64) -> Option<Law> {
        let (cusp, margin) = self.cusp(part);
        let amplitudes = |amplitude: f64| [amplitude, 0.25 * part * amplitude];
        (margin > 0.0).then(|| self.closed(0.0, cusp, amplitudes))
    }

    /// The law that closes with an amplitude `ε₂`, with cusps or without; `None` if radii would not fall from
    /// crest to trough.
    pub(crate) fn at_second(&self, second: f64) -> Option<Law> {
        let amplitudes = |amplitude: f64| [amplitude, second];
        // Below, a crest or a trough splits in two.
        let low = 4.0 * second.abs();
        let excess = |amplitude: f64| self.excess(amplitudes(amplitude), FEW_PANELS);
        let most = 0.999 * (1.0 + second);
        if low >= most || excess(low) < 0.0 {
            return None;
        }
        let step = |i: u32| low + (most - low) * f64::from(i) / f64::from(PLACES);
        let beyond = (1..=PLACES).find(|&i| excess(step(i)) < 0.0)?;
        Some(self.closed(step(beyond - 1), step(beyond), amplitudes))
    }

    /// The law that closes between two amplitudes.
    fn closed(&self, low: f64, high: f64, amplitudes: impl Fn(f64) -> [f64; 2]) -> Law {
        let near = bracketed(low, high, |amplitude| self.excess(amplitudes(amplitude), FEW_PANELS));
        // Two steps of the secant correct the error of few panels: the last bits are then as with many.
        let fine = |amplitude: f64| self.excess(amplitudes(amplitude), PANELS);
        let (mut before, mut at_before) = (near * (1.0 - BESIDE_ROOT), fine(near * (1.0 - BESIDE_ROOT)));
        let (mut here, mut at_here) = (near, fine(near));
        for _ in 0..3 {
            let next = here - at_here * (here - before) / (at_here - at_before);
            if !next.is_finite() || (next - here).abs() <= f64::EPSILON * here {
                break;
            }
            (before, at_before) = (here, at_here);
            (here, at_here) = (next, fine(next));
        }
        self.law(amplitudes(here), PANELS)
    }
}

impl Cosine {
    /// The motor of these numbers.
    pub(crate) fn new(numbers: MotorNumbers) -> Result<Self, Error> {
        let kernel = Numbers::of(numbers);
        let of = |amplitude| kernel.law([amplitude, 0.0], PANELS);
        let cusp_amplitude = bracketed(0.0, 1.0 - WITHIN, |amplitude| of(amplitude).stretch());
        let excess = |amplitude: f64| kernel.excess([amplitude, 0.0], PANELS);
        let left = excess(cusp_amplitude);
        if left >= 0.0 {
            return Err(Error::NoCosineRotor { cusp_amplitude, excess_deg: Angle::from_si(left).degrees() });
        }
        Ok(Self::of_law(of(bracketed(0.0, cusp_amplitude, excess))))
    }

    /// The half-lobe of a law that closes.
    pub(crate) fn of_law(law: Law) -> Self {
        let width = PI / law.n / f64::from(PANELS);
        let mut sum = [0.0; 3];
        let mut edges = vec![contact(&law, 0.0, sum)];
        for panel in 0..PANELS {
            let from = width * f64::from(panel);
            let more = quadratures(from, from + width, |theta| law.rates(theta));
            for (sum, more) in sum.iter_mut().zip(more) {
                *sum += more;
            }
            edges.push(contact(&law, from + width, sum));
        }
        let trough = contact(&law, PI / law.n, sum);
        Self { law, trough: Contact { mu: 0.0, s3: trough.s1, ..trough }, edges }
    }

    /// The rotor's law.
    pub(crate) fn law(&self) -> &Law {
        &self.law
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
        let Contact { s1, phase, swept, .. } = self.edges[panel];
        let mut sums = [s1, phase, swept];
        let rest = few_quadratures(from, theta1, |theta| self.law.rates(theta));
        for (sum, rest) in sums.iter_mut().zip(rest) {
            *sum += rest;
        }
        contact(&self.law, theta1, sums)
    }
}

fn contact(law: &Law, theta1: f64, [s1, phase, swept]: [f64; 3]) -> Contact {
    let (rho1, mu, kappa1) = law.shape(theta1);
    let rho3 = rho1 + 2.0 * law.r * libm::cos(mu);
    Contact {
        phase,
        theta3: phase - theta1,
        theta1,
        rho3,
        rho1,
        mu,
        s3: s1 - 2.0 * law.r * mu,
        s1,
        kappa3: conjugate_curvature(-law.r, libm::cos(mu), rho1, kappa1, rho3),
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
        let Law { n, c, amplitude, second, .. } = self.law;
        c * c * (1.0 + 0.5 * amplitude * amplitude + 0.5 * second * second) * PI / (2.0 * n)
    }

    fn curvature_extremes(&self) -> [f64; 4] {
        let end = self.trough.theta1;
        let place = |i: usize| end * i as f64 / CURVATURE_PLACES as f64;
        let all: Vec<[f64; 2]> = (0..=CURVATURE_PLACES).map(|i| self.law.curvatures(place(i))).collect();
        // −κ₃, κ₃, κ₁, −κ₁; even about crest and trough.
        [(0, -1.0), (0, 1.0), (1, 1.0), (1, -1.0)].map(|(wheel, sign)| {
            let (greatest, i) = (0..all.len())
                .map(|i| (sign * all[i][wheel], i))
                .fold((f64::NEG_INFINITY, 0), |best, here| if here.0 > best.0 { here } else { best });
            if i == 0 || i == CURVATURE_PLACES || greatest <= 0.0 {
                return greatest.max(0.0);
            }
            let refined = golden(place(i - 1), place(i + 1), 32, |at| -sign * self.law.curvatures(at)[wheel]);
            greatest.max(-refined.1)
        })
    }

    fn within(&self, by: By, value: f64) -> Contact {
        let end = self.trough.theta1;
        if by == By::RotorAngle {
            return self.on_rotor(value);
        }
        // Newton's method from the chord, between the ends of the panel that holds the value: each step
        // squares the remaining error.
        let panel = self.edges.partition_point(|edge| edge.get(by) <= value).clamp(1, self.edges.len() - 1);
        let (low, high) = (&self.edges[panel - 1], &self.edges[panel]);
        let share = (value - low.get(by)) / (high.get(by) - low.get(by));
        let start = low.theta1 + share * (high.theta1 - low.theta1);
        let r = self.law.r;
        let mut theta1 = start;
        for _ in 0..4 {
            let here = self.on_rotor(theta1);
            let step = (value - here.get(by)) * here.slope(By::RotorAngle, r) / here.slope(by, r);
            theta1 = (theta1 + step).clamp(low.theta1, high.theta1);
            if step.abs() <= LAST_STEP * end {
                return self.on_rotor(theta1);
            }
        }
        let theta1 = inverse(value, end, start, |theta1| {
            let contact = self.on_rotor(theta1);
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
        assert!(at_limit.stretch().abs() < 1e-13 && lobe.law.amplitude < lobe.cusp_amplitude());
        // The source's own numbers leave it 0.18° short.
        let refused = Cosine::new(MotorNumbers::new(5, 3, 55, 10).unwrap());
        assert!(matches!(refused, Err(Error::NoCosineRotor { .. })));
    }

    /// `ρ₁ = c·(1 ± ε)` at crest and trough, and `2·r·ε·n² = c·(1 − ε)²` at the cusp limit.
    #[test]
    fn the_law_of_a_motor_is_that_of_its_rotor() {
        use crate::Motor;
        use uom::si::f64::Length;
        let (mm, numbers) = (Length::from_mm, MotorNumbers::new(8, 6, 88, 10).unwrap());
        let motor = Motor::of_cosine_law(numbers, mm(1.5)).unwrap();
        let law = motor.cosine_law().unwrap();
        let c = law.mean_radius.mm();
        let [crest, trough] =
            [motor.shape.at(By::Phase, 0.0).rho1, motor.shape.trough().rho1].map(|modules| 1.5 * modules);
        assert!((crest - c * (1.0 + law.amplitude)).abs() < 1e-11 * c, "{crest} {law:?}");
        assert!((trough - c * (1.0 - law.amplitude)).abs() < 1e-11 * c, "{trough} {law:?}");
        let (r, n, cusp) = (motor.satellite_radius().mm(), 6.0, law.cusp_amplitude);
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
            let kernel = Numbers::of(numbers);
            let of = |amplitude| kernel.law([amplitude, 0.0], PANELS);
            let (less, more) = (of(0.9 * part), of(0.9 * part + 0.01));
            if more.stretch() > 0.0 {
                prop_assert!(more.span(PANELS) < less.span(PANELS));
            }
        }
    }
}

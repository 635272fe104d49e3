//! The half-lobe whose stator consists of the two arcs of system (1); the rotor in closed form.
//!
//! Let `x` be the angle at the arc's centre, from the crest on arc 2 and from the trough on arc 1, and
//! `t = tan(x/2)`:
//!
//! ```text
//! arc 2:  s₃ = R₂·x           μ = −atan2(a·sin x, R₂ + a·cos x)     G = (R₂ − r)·(R₂·x + a·sin x)
//! arc 1:  s₃ = S − R₁·x       μ = −atan2(l·sin x, l·cos x − R₁)     G = G(π/N) − (R₁ + r)·(l·sin x − R₁·x)
//! ```
//!
//! `Φ` follows from [`crate::closure`]. `G` is elementary because `ρ₁·ρ₃` cancels in `f·dΦ`.
//!
//! # The rotor's curvature is monotone on the image of either arc
//! On arc 2 let `c = cos x`, `P = ρ₁·ρ₃` and `Q = R₂·ρ₃²·ds₁/ds₃`, both linear in `c`. Euler and Savary give:
//!
//! ```text
//! κ₁ = (R₂ + a·c)/P + a·(a + R₂·c)/Q       dκ₁/dc = a·(R₂² − a²)·(R₂²/Q² − 1/P²)
//! Q/R₂ − P = 2·r·(R₂² − a²)/R₂
//! ```
//!
//! So the slope keeps its sign; on arc 1 likewise with `−R₁` for `R₂` and `l` for `a`. The extremes are at
//! the crest, on either side of the junction, and at the trough.

use crate::arcs::Arcs;
use crate::closure::{crest_term, trough_term};
use crate::contact::{By, Conjugate, Contact, conjugate_curvature, greatest_curvatures};
use epicyclic_numerics::roots::{inverse, smooth_inverse};

/// Rolling of two arcs on the rotor over a half-lobe, of a closed motor or of arcs that do not close.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TwoArcs {
    arcs: Arcs,
    r: f64,
    /// Phase of a half-lobe.
    end_phase: f64,
    /// Area that a satellite sweeps in a half-lobe.
    end_swept: f64,
    trough: Contact,
    junction: Contact,
    crest_start: Start,
    trough_start: Start,
}

impl TwoArcs {
    /// Half-lobe of arcs on which a satellite of the radius `r` rolls.
    pub(crate) fn new(arcs: &Arcs, r: f64) -> Self {
        let Arcs { l, a, r1, r2, gamma, beta, tan_gamma, tan_beta, .. } = *arcs;
        let crest_phase = beta + crest_term(arcs, r, tan_beta);
        let end_phase = crest_phase + trough_term(arcs, r, tan_gamma) - gamma;
        let crest_swept = (r2 - r) * (r2 * beta + a * libm::sin(beta));
        let end_swept = crest_swept + (r1 + r) * (arcs.least * gamma - l * less_sine(gamma));
        let nothing = Contact {
            phase: 0.0,
            theta3: 0.0,
            theta1: 0.0,
            rho3: 0.0,
            rho1: 0.0,
            mu: 0.0,
            s3: 0.0,
            s1: 0.0,
            kappa3: 0.0,
            kappa1: 0.0,
            swept: 0.0,
        };
        let start = Start { linear: 0.0, square: 0.0, cube: 0.0 };
        let mut lobe = Self {
            arcs: *arcs,
            r,
            end_phase,
            end_swept,
            trough: nothing,
            junction: nothing,
            crest_start: start,
            trough_start: start,
        };
        lobe.trough = lobe.on_trough(0.0, 0.0);
        lobe.junction = lobe.on_crest(beta, tan_beta);
        let crest_slopes = [0.0, tan_beta].map(|t| lobe.crest_rates(t)[0]);
        lobe.crest_start = Start::new(tan_beta, lobe.junction.phase, crest_slopes);
        let trough_slopes = [0.0, tan_gamma].map(|t| lobe.trough_rates(t)[0]);
        lobe.trough_start = Start::new(tan_gamma, end_phase - lobe.junction.phase, trough_slopes);
        lobe
    }

    /// The contact at the junction of the arcs.
    pub(crate) fn junction(&self) -> &Contact {
        &self.junction
    }

    /// The contact at the angle `x` of arc 2, `t = tan(x/2)`.
    fn on_crest(&self, x: f64, t: f64) -> Contact {
        let Arcs { a, r2, .. } = self.arcs;
        let (sin, cos) = libm::sincos(x);
        let along = a + r2 * cos;
        let rho3 = libm::hypot(along, r2 * sin);
        let theta3 = libm::atan2(r2 * sin, along);
        let mu = -libm::atan2(a * sin, r2 + a * cos);
        let product = a * a + r2 * r2 - 2.0 * r2 * self.r + 2.0 * a * (r2 - self.r) * cos;
        let phase = x + crest_term(&self.arcs, self.r, t);
        let swept = (r2 - self.r) * (r2 * x + a * sin);
        self.contact(phase, theta3, rho3, product / rho3, mu, r2 * x, r2.recip(), swept)
    }

    /// The contact at the angle `x` of arc 1, `t = tan(x/2)`.
    fn on_trough(&self, x: f64, t: f64) -> Contact {
        let Arcs { theta3: whole, half_length, l, r1, least, .. } = self.arcs;
        let sin = libm::sin(x);
        let half = libm::sin(x / 2.0);
        let versine = 2.0 * half * half;
        let along = least + r1 * versine;
        let rho3 = libm::hypot(along, r1 * sin);
        let theta3 = whole - libm::atan2(r1 * sin, along);
        let mu = -libm::atan2(l * sin, least - l * versine);
        let product = least * (least - 2.0 * self.r) + 2.0 * l * (r1 + self.r) * versine;
        let phase = self.end_phase + x - trough_term(&self.arcs, self.r, t);
        let swept = self.end_swept - (r1 + self.r) * (least * x - l * less_sine(x));
        let mu = if x == 0.0 { 0.0 } else { mu };
        self.contact(phase, theta3, rho3, product / rho3, mu, half_length - r1 * x, -r1.recip(), swept)
    }

    #[allow(clippy::too_many_arguments)] // what the two arcs have in common, each number once
    fn contact(
        &self,
        phase: f64,
        theta3: f64,
        rho3: f64,
        rho1: f64,
        mu: f64,
        s3: f64,
        kappa3: f64,
        swept: f64,
    ) -> Contact {
        let kappa1 = conjugate_curvature(self.r, libm::cos(mu), rho3, kappa3, rho1);
        let s1 = s3 + 2.0 * self.r * mu;
        Contact { phase, theta3, theta1: phase - theta3, rho3, rho1, mu, s3, s1, kappa3, kappa1, swept }
    }

    /// `t = tan(x/2)` on arc 2 at a phase.
    fn crest_tangent(&self, phase: f64) -> f64 {
        let start = self.crest_start.at(phase / self.junction.phase);
        smooth_inverse(phase, self.arcs.tan_beta, start, |t| {
            let [slope, bend] = self.crest_rates(t);
            [2.0 * libm::atan(t) + crest_term(&self.arcs, self.r, t), slope, bend]
        })
    }

    /// `dΦ/dt` and `d²Φ/dt²` on arc 2.
    fn crest_rates(&self, t: f64) -> [f64; 2] {
        let Arcs { a, r2, .. } = self.arcs;
        let scale = 1.0 / (1.0 + t * t);
        let cos = (1.0 - t * t) * scale;
        let (normal, reach) = (r2 + a * cos, r2 - self.r);
        let per_product = 1.0 / (a * a + r2 * r2 - 2.0 * r2 * self.r + 2.0 * a * reach * cos);
        let by_x = 2.0 * normal * reach * per_product;
        let by_x_and_cos = 2.0 * reach * a * per_product - 2.0 * a * reach * by_x * per_product;
        let bend = -8.0 * t * scale * scale * scale * by_x_and_cos - 4.0 * t * scale * scale * by_x;
        [2.0 * scale * by_x, bend]
    }

    /// `t = tan(x/2)` on arc 1 at a phase, counted back from the trough.
    fn trough_tangent(&self, back: f64) -> f64 {
        let start = self.trough_start.at(back / (self.end_phase - self.junction.phase));
        smooth_inverse(back, self.arcs.tan_gamma, start, |t| {
            let [slope, bend] = self.trough_rates(t);
            [trough_term(&self.arcs, self.r, t) - 2.0 * libm::atan(t), slope, bend]
        })
    }

    /// `dΦ/dt` and `d²Φ/dt²` on arc 1, counted back.
    fn trough_rates(&self, t: f64) -> [f64; 2] {
        let Arcs { l, r1, least, .. } = self.arcs;
        let scale = 1.0 / (1.0 + t * t);
        let versine = 2.0 * t * t * scale;
        let (normal, reach) = (least - l * versine, r1 + self.r);
        let per_product = 1.0 / (least * (least - 2.0 * self.r) + 2.0 * l * reach * versine);
        let by_x = 2.0 * normal * reach * per_product;
        let by_x_and_versine = -2.0 * reach * l * per_product - 2.0 * l * reach * by_x * per_product;
        let bend = 8.0 * t * scale * scale * scale * by_x_and_versine - 4.0 * t * scale * scale * by_x;
        [2.0 * scale * by_x, bend]
    }
}

/// A monotone cubic from 0 at 0 to `end` at 1: where to start the search for an argument.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Start {
    linear: f64,
    square: f64,
    cube: f64,
}

impl Start {
    /// Cubic from the slopes, over `value`, of the inverse at either end.
    fn new(end: f64, value: f64, slopes: [f64; 2]) -> Self {
        // At most three times the chord's, so that it stays monotone.
        let [first, last] = slopes.map(|slope| (value / slope).clamp(0.0, 3.0 * end));
        Self { linear: first, square: 3.0 * end - 2.0 * first - last, cube: first + last - 2.0 * end }
    }

    fn at(&self, part: f64) -> f64 {
        part * (self.linear + part * (self.square + part * self.cube))
    }
}

/// `x − sin x`, without its cancellation.
fn less_sine(x: f64) -> f64 {
    if x.abs() < 0.25 {
        let square = x * x;
        // x³/3! − x⁵/5! + …
        let series = [110.0, 72.0, 42.0, 20.0].iter().fold(1.0, |sum, k| 1.0 - square / k * sum);
        x * square / 6.0 * series
    } else {
        x - libm::sin(x)
    }
}

impl Conjugate for TwoArcs {
    fn satellite_radius(&self) -> f64 {
        self.r
    }

    fn trough(&self) -> &Contact {
        &self.trough
    }

    fn kink(&self) -> Option<f64> {
        Some(self.junction.phase)
    }

    fn flow_within(&self, phase: f64) -> (f64, f64) {
        // f = ½·(K + M·cos x), and dΦ/dx as in `crest_tangent`: without the contact's angles.
        let Arcs { l, a, r1, r2, least, .. } = self.arcs;
        if phase <= self.junction.phase {
            let t = self.crest_tangent(phase);
            let scale = 1.0 / (1.0 + t * t);
            let (sin, cos) = (2.0 * t * scale, (1.0 - t * t) * scale);
            let product = a * a + r2 * r2 - 2.0 * r2 * self.r + 2.0 * a * (r2 - self.r) * cos;
            (0.5 * product, -0.5 * a * sin * product / (r2 + a * cos))
        } else {
            let t = self.trough_tangent(self.end_phase - phase);
            let scale = 1.0 / (1.0 + t * t);
            let (sin, versine) = (2.0 * t * scale, 2.0 * t * t * scale);
            let product = least * (least - 2.0 * self.r) + 2.0 * l * (r1 + self.r) * versine;
            (0.5 * product, -0.5 * l * sin * product / (least - l * versine))
        }
    }

    fn curvature_extremes(&self) -> [f64; 4] {
        let Arcs { gamma, tan_gamma, .. } = self.arcs;
        let contacts =
            [self.on_crest(0.0, 0.0), self.junction, self.on_trough(gamma, tan_gamma), self.trough];
        greatest_curvatures(contacts.into_iter())
    }

    fn centre_within(&self, phase: f64) -> [f64; 2] {
        // On a circle about O₂ or O₁, whose radius the satellite's takes from or adds to that of the arc.
        let Arcs { theta3, a, r1, r2, least, .. } = self.arcs;
        if phase <= self.junction.phase {
            let t = self.crest_tangent(phase);
            let scale = 1.0 / (1.0 + t * t);
            [a + (r2 - self.r) * (1.0 - t * t) * scale, (r2 - self.r) * 2.0 * t * scale]
        } else {
            let t = self.trough_tangent(self.end_phase - phase);
            let scale = 1.0 / (1.0 + t * t);
            // Along the ray of the trough and across it, back towards the crest.
            let along = least - self.r + (r1 + self.r) * 2.0 * t * t * scale;
            let across = (r1 + self.r) * 2.0 * t * scale;
            let (sin, cos) = libm::sincos(theta3);
            [along * cos + across * sin, along * sin - across * cos]
        }
    }

    fn rotor_area(&self) -> f64 {
        // G − ½·∫ ρ₃² dθ₃: of the satellite's own share nothing is left where μ vanishes.
        let Arcs { l, a, r1, r2, gamma, beta, least, .. } = self.arcs;
        let crest = r2 * (r2 * beta + a * libm::sin(beta));
        let trough = r1 * (least * gamma - l * less_sine(gamma));
        self.end_swept - 0.5 * (crest + trough)
    }

    fn within(&self, by: By, value: f64) -> Contact {
        let Arcs { half_length, r1, r2, gamma, beta, .. } = self.arcs;
        let on_crest = value <= self.junction.get(by);
        match by {
            By::Phase if on_crest => {
                let t = self.crest_tangent(value);
                self.on_crest(2.0 * libm::atan(t), t)
            }
            By::Phase => {
                let t = self.trough_tangent(self.end_phase - value);
                self.on_trough(2.0 * libm::atan(t), t)
            }
            By::StatorArc if on_crest => self.on_crest(value / r2, libm::tan(value / r2 / 2.0)),
            By::StatorArc => {
                let x = (half_length - value) / r1;
                self.on_trough(x, libm::tan(x / 2.0))
            }
            _ if on_crest => {
                let start = beta * value / self.junction.get(by);
                let x = inverse(value, beta, start, |x| {
                    let contact = self.on_crest(x, libm::tan(x / 2.0));
                    (contact.get(by), contact.slope(by, self.r) * r2)
                });
                self.on_crest(x, libm::tan(x / 2.0))
            }
            _ => {
                let end = self.trough.get(by);
                let start = gamma * (end - value) / (end - self.junction.get(by));
                let x = inverse(end - value, gamma, start, |x| {
                    let contact = self.on_trough(x, libm::tan(x / 2.0));
                    (end - contact.get(by), contact.slope(by, self.r) * r1)
                });
                self.on_trough(x, libm::tan(x / 2.0))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::closure::Family;
    use crate::closure::tests::any_motor;
    use epicyclic_units::Physical;
    use proptest::prelude::*;
    use uom::si::f64::Length;

    proptest! {
        #[test]
        fn the_short_way_to_the_flow_is_that_of_the_contact(motor in any_motor(), part in 0.001..0.999) {
            let arcs = Family::new(motor.0, Length::from_si(1.0)).unwrap().at_part(motor.1).unwrap();
            let r = f64::from(motor.0.satellite_teeth()) / 2.0;
            let lobe = TwoArcs::new(&arcs.arcs, r);
            let phase = part * lobe.end_phase;
            let contact = lobe.within(By::Phase, phase);
            let (flow, slope) = lobe.flow_within(phase);
            prop_assert!((flow - contact.flow()).abs() < 1e-12 * flow);
            prop_assert!((slope - contact.flow_slope(r)).abs() < 1e-10 * flow);
        }
    }

    proptest! {
        #[test]
        fn the_ends_of_the_arcs_have_the_extremes_of_the_curvature(motor in any_motor()) {
            let arcs = Family::new(motor.0, Length::from_si(1.0)).unwrap().at_part(motor.1).unwrap();
            let lobe = TwoArcs::new(&arcs.arcs, f64::from(motor.0.satellite_teeth()) / 2.0);
            let kink = lobe.junction.phase;
            let places = (0..=4000).map(|i| lobe.end_phase * f64::from(i) / 4000.0);
            let places = places.chain([kink * (1.0 - 1e-14), kink * (1.0 + 1e-14)]);
            let sampled = greatest_curvatures(places.map(|phase| lobe.within(By::Phase, phase)));
            for (exact, sampled) in lobe.curvature_extremes().into_iter().zip(sampled) {
                // A millionth: the hair beside the junction, where with a nearly radial flank the curvature
                // changes fast.
                prop_assert!((sampled - exact).abs() <= 1e-6 * exact + 1e-12, "{exact} {sampled}");
            }
        }

        #[test]
        fn the_short_way_to_the_centre_is_that_of_the_contact(motor in any_motor(), phase in -20.0..20.0) {
            let arcs = Family::new(motor.0, Length::from_si(1.0)).unwrap().at_part(motor.1).unwrap();
            let r = f64::from(motor.0.satellite_teeth()) / 2.0;
            let lobe = TwoArcs::new(&arcs.arcs, r);
            let contact = lobe.at(By::Phase, phase);
            let [x, y] = lobe.centre(phase);
            let (sin, cos) = libm::sincos(contact.theta3);
            let (normal_sin, normal_cos) = libm::sincos(contact.theta3 - contact.mu);
            prop_assert!((x - contact.rho3 * cos + r * normal_cos).abs() < 1e-10);
            prop_assert!((y - contact.rho3 * sin + r * normal_sin).abs() < 1e-10);
        }
    }

    #[test]
    fn less_sine_keeps_its_digits() {
        for x in [1e-9, 1e-3, 0.2499, 0.2501, 1.0] {
            let series: f64 = (1..12).rev().fold(0.0, |sum, k| {
                let k = f64::from(2 * k);
                (1.0 - x * x * sum) / (k * (k + 1.0))
            });
            assert!((less_sine(x) / (x * x * x * series) - 1.0).abs() < 1e-13, "{x}");
        }
    }
}

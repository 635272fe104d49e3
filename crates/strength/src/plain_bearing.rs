//! Oil film of a plain bearing of a planet, whose load has one direction as seen from the pin.
//!
//! ```text
//! So = p·ψ²/(η·ω)       p = F/(B·D)       h_0 = D/2·ψ·(1 − ε)
//! So = (B/D)²·ε/(2·(1 − ε²)²)·√(π²·(1 − ε²) + 16·ε²)·a_1·(ε − 1)/(a_2 + ε)
//! a_1 = 1.1642 − 1.9456·B/D + 7.1161·(B/D)² − 10.1073·(B/D)³ + 5.0141·(B/D)⁴
//! a_2 = −1.000026 − 0.023634·B/D − 0.4215·(B/D)² − 0.038817·(B/D)³ − 0.090551·(B/D)⁴
//! ```
//!
//! | symbol | argument | meaning | unit |
//! |---|---|---|---|
//! | `D`, `B` | `diameter`, `width` | bore that runs on the pin, its width | m |
//! | `ψ` | `clearance` | difference of the diameters of bore and pin over `D` | 1 |
//! | `F` | `load` | radial force | N |
//! | `ω` | `speed` | speed of the planet relative to the pin | rad/s |
//! | `η` | `viscosity` | dynamic viscosity of the oil in the bearing | Pa·s |
//! | `ε`, `h_0` | | eccentricity over its greatest, least film thickness | 1, m |
//!
//! The formula is an approximation of Reynolds's equation, within a tenth in `So`. A bearing longer than its diameter
//! counts as one of `B = D`, with its own `p`.
//!
//! # Usual values
//! Clearance `ψ = 0.8 ‰·v^¼` of the greatest sliding speed `v` in m/s, at least 0.5 ‰. The oil in the bearing has
//! 70 °C unless its viscosity there is stated, and the slope of mineral oils of viscosity index 95. The least film
//! for mixed friction to be away is that of a table by diameter and sliding speed, 3 to 18 µm.
//!
//! # Left out
//! Steps without speed, in which there is no film; heat and the flow of oil, elastic deformation, starting under load, changes of the load faster than the film
//! follows.
//!
//! # Source
//! ISO 7902:2020, DIN 31652: full bearings of 360°; the clearance by Vogelpohl. The tests solve Reynolds's equation.

use crate::bearing::BearingStep;
use crate::tolerance::NO_FILM;
use epicyclic_numerics::roots::bracketed;
use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Force, KinematicViscosity, Length, Pressure};

/// Load over diameter and width that a planet's bush of bronze usually bears, N/m²: ISO 7902-3.
pub const USUAL_PRESSURE: f64 = 7e6;

/// Load over diameter and width that such a bush bears for a short time, N/m²; ISO 7902-3 has up to 25e6.
pub const GREATEST_PRESSURE: f64 = 20e6;

/// Density of oil, kg/m³.
const OIL: f64 = 870.0;

/// Slope of the viscosity of mineral oils over temperature, by Ubbelohde and Walther.
const SLOPE: f64 = 3.5;

/// Viscosity at 40 °C below which the slope holds no longer, mm²/s.
const THIN: f64 = 2.0;

/// Temperatures of the stated viscosity and in the bearing, K.
const TEMPERATURES: [f64; 2] = [313.15, 343.15];

/// Clearance at a sliding speed of 1 m/s, and the least one.
const CLEARANCES: [f64; 2] = [0.8e-3, 0.5e-3];

/// Ends of the diameters of [`FILMS`], m.
const DIAMETERS: [f64; 4] = [0.063, 0.16, 0.4, 1.0];
/// Ends of the sliding speeds of [`FILMS`], m/s.
const SPEEDS: [f64; 4] = [1.0, 3.0, 10.0, 30.0];
/// Least films, µm, by diameter and sliding speed.
const FILMS: [[f64; 5]; 5] = [
    [3.0, 4.0, 5.0, 7.0, 10.0],
    [4.0, 5.0, 7.0, 9.0, 12.0],
    [6.0, 7.0, 9.0, 11.0, 14.0],
    [8.0, 9.0, 11.0, 13.0, 16.0],
    [10.0, 12.0, 14.0, 16.0, 18.0],
];

/// A plain bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlainBearing {
    /// Diameter `D`.
    pub diameter: Length,
    /// Width `B`.
    pub width: Length,
    /// Relative clearance `ψ`.
    pub clearance: f64,
}

/// Sommerfeld number of an eccentricity `ε` and a width over diameter.
#[must_use]
pub fn sommerfeld_number(eccentricity: f64, width_ratio: f64) -> f64 {
    let polynomial = |factors: [f64; 5]| factors.iter().rev().fold(0.0, |sum, of| sum * width_ratio + of);
    let first = polynomial([1.1642, -1.9456, 7.1161, -10.1073, 5.0141]);
    let second = polynomial([-1.000026, -0.023634, -0.4215, -0.038817, -0.090551]);
    let rest = 1.0 - eccentricity * eccentricity;
    let root = libm::sqrt(std::f64::consts::PI.powi(2) * rest + 16.0 * eccentricity * eccentricity);
    width_ratio * width_ratio * eccentricity / (2.0 * rest * rest) * root * first * (eccentricity - 1.0)
        / (second + eccentricity)
}

/// Dynamic viscosity in Pa·s of a mineral oil in a bearing: by its kinematic one there where it is stated, or by that
/// at 40 °C.
///
/// ```
/// use epicyclic_strength::plain_bearing::viscosity;
/// use epicyclic_units::Physical;
/// use uom::si::f64::KinematicViscosity;
///
/// // ISO VG 220: 50 mm²/s at 70 °C.
/// let of = viscosity(KinematicViscosity::from_mm2_s(220.0), None);
/// assert!((of / 870.0 * 1e6 - 50.0).abs() < 1.0);
/// ```
#[must_use]
pub fn viscosity(at_40: KinematicViscosity, stated: Option<KinematicViscosity>) -> f64 {
    let warm = || {
        let [from, to] = TEMPERATURES.map(libm::log10);
        let known = at_40.mm2_s().max(THIN);
        let twice = libm::log10(libm::log10(known + 0.7)) - SLOPE * (to - from);
        at_40 * ((libm::exp10(libm::exp10(twice)) - 0.7) / known)
    };
    OIL * stated.unwrap_or_else(warm).si()
}

impl PlainBearing {
    /// A bearing with the usual clearance for its greatest speed.
    #[must_use]
    pub fn usual(diameter: Length, width: Length, fastest: AngularVelocity) -> Self {
        let [of_1, least] = CLEARANCES;
        let speed = fastest.si().abs() * diameter.si() / 2.0;
        Self { diameter, width, clearance: (of_1 * libm::pow(speed, 0.25)).max(least) }
    }

    /// Load over the projected area.
    #[must_use]
    pub fn pressure(&self, load: Force) -> Pressure {
        load / (self.diameter * self.width)
    }

    /// Least film thickness `h_0`; 0 at rest, the whole gap without load.
    #[must_use]
    pub fn film(&self, load: Force, speed: AngularVelocity, viscosity: f64) -> Length {
        let gap = self.diameter * (self.clearance / 2.0);
        if speed.si() == 0.0 {
            return Length::default();
        }
        let square = self.clearance * self.clearance;
        let number = self.pressure(load).si() * square / (viscosity * speed.si().abs());
        let ratio = (self.width / self.diameter).si().min(1.0);
        let miss = |free: f64| sommerfeld_number(1.0 - free, ratio) - number;
        if miss(NO_FILM) <= 0.0 {
            return Length::default();
        }
        gap * bracketed(NO_FILM, 1.0, miss)
    }

    /// Least film at a speed with which mixed friction is away.
    #[must_use]
    pub fn needed_film(&self, speed: AngularVelocity) -> Length {
        let sliding = speed.si().abs() * self.diameter.si() / 2.0;
        let row = DIAMETERS.partition_point(|end| *end < self.diameter.si());
        Length::from_um(FILMS[row][SPEEDS.partition_point(|end| *end < sliding)])
    }
}

/// Least of the film over the [needed](PlainBearing::needed_film) one in the steps of a duty, with the usual clearance
/// of its greatest speed; `None` where nothing turns under load.
#[must_use]
pub fn film_ratio([diameter, width]: [Length; 2], duty: &[BearingStep], viscosity: f64) -> Option<f64> {
    let steps = duty.iter().filter(|step| step.share > 0.0);
    let fastest = steps.clone().map(|step| step.speed.si().abs()).fold(0.0, f64::max);
    let turning = steps.filter(|step| step.load.si() > 0.0 && step.speed.si() != 0.0);
    let bearing = PlainBearing::usual(diameter, width, AngularVelocity::from_si(fastest));
    let ratio = |step: &BearingStep| {
        (bearing.film(step.load, step.speed, viscosity) / bearing.needed_film(step.speed)).si()
    };
    turning.map(ratio).reduce(f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// Sommerfeld number by Reynolds's equation without pressures below that around the bearing, on a mesh over
    /// the angle and half the width:
    ///
    /// ```text
    /// ∂(h³·∂p/∂φ)/∂φ + (D/B)²·∂(h³·∂p/∂z)/∂z = 6·∂h/∂φ        h = 1 + ε·cos φ        z from −1 to 1
    /// ```
    fn by_reynolds(eccentricity: f64, ratio: f64, angles: usize) -> f64 {
        const ROWS: usize = 16;
        let [step, row] = [TAU / angles as f64, 1.0 / ROWS as f64];
        let gap = |place: f64| 1.0 + eccentricity * libm::cos(place * step);
        let mut pressure = vec![[0.0_f64; ROWS + 1]; angles];
        for _ in 0..4000 {
            let mut most = 0.0_f64;
            for at in 0..angles {
                let [before, behind] = [gap(at as f64 - 0.5), gap(at as f64 + 0.5)];
                let [west, east] = [before, behind].map(|gap| gap.powi(3) / (step * step));
                let along = gap(at as f64).powi(3) / (ratio * ratio * row * row);
                let source = 6.0 * (behind - before) / step;
                for z in 0..ROWS {
                    let inner = pressure[at][if z == 0 { 1 } else { z - 1 }];
                    let around = east * pressure[(at + 1) % angles][z]
                        + west * pressure[(at + angles - 1) % angles][z]
                        + along * (inner + pressure[at][z + 1]);
                    let new = (around - source) / (east + west + 2.0 * along);
                    let own = (pressure[at][z] + 1.7 * (new - pressure[at][z])).max(0.0);
                    most = most.max((own - pressure[at][z]).abs());
                    pressure[at][z] = own;
                }
            }
            if most < 1e-6 {
                break;
            }
        }
        let mut force = [0.0; 2];
        for (at, column) in pressure.iter().enumerate() {
            let mean = (column[1..ROWS].iter().sum::<f64>() + column[0] / 2.0) * row * step;
            let angle = at as f64 * step;
            force[0] += mean * libm::cos(angle);
            force[1] += mean * libm::sin(angle);
        }
        libm::hypot(force[0], force[1]) / 2.0
    }

    #[test]
    fn the_approximation_is_within_a_tenth_of_reynoldss_equation() {
        for ratio in [0.25, 0.5, 0.75, 1.0] {
            for eccentricity in [0.4, 0.7, 0.9] {
                let [own, other] =
                    [sommerfeld_number(eccentricity, ratio), by_reynolds(eccentricity, ratio, 120)];
                assert!((own / other - 1.0).abs() < 0.1, "{ratio} {eccentricity}: {own} {other}");
            }
        }
    }

    #[test]
    fn the_film_grows_with_the_speed_and_shrinks_under_load() {
        let bearing =
            PlainBearing { diameter: Length::from_mm(200.0), width: Length::from_mm(180.0), clearance: 1e-3 };
        let film = |kilonewtons: f64, rpm: f64| {
            bearing.film(Force::from_si(1e3 * kilonewtons), AngularVelocity::from_rpm(rpm), 0.05).um()
        };
        assert!(film(100.0, 100.0) < film(100.0, 200.0) && film(200.0, 100.0) < film(100.0, 100.0));
        assert_eq!(film(100.0, 0.0), 0.0);
        assert!((film(0.0, 100.0) / 100.0 - 1.0).abs() < 1e-6, "the whole gap");
        // It is that of the eccentricity whose number is that of the load.
        let number = 100e3 / (0.2 * 0.18) * 1e-6 / (0.05 * AngularVelocity::from_rpm(100.0).si());
        let eccentricity = 1.0 - film(100.0, 100.0) / 100.0;
        assert!((sommerfeld_number(eccentricity, 0.9) / number - 1.0).abs() < 1e-6);
        // No oil film under any load that a bearing could bear.
        assert_eq!(film(1e30, 100.0), 0.0);
    }

    #[test]
    fn needed_films_are_those_of_the_table() {
        let of = |mm: f64, sliding: f64| {
            let bearing = PlainBearing::usual(
                Length::from_mm(mm),
                Length::from_mm(mm),
                AngularVelocity::from_si(sliding / (mm / 2e3)),
            );
            (
                bearing.needed_film(AngularVelocity::from_si(sliding / (mm / 2e3))).um(),
                1e3 * bearing.clearance,
            )
        };
        for (mm, sliding, film, clearance) in [
            (50.0, 0.5, 3.0, 0.6727),
            (100.0, 2.0, 5.0, 0.9514),
            (300.0, 16.0, 11.0, 1.6),
            (1200.0, 0.01, 10.0, 0.5),
        ] {
            let (own, gap) = of(mm, sliding);
            assert!(
                (own - film).abs() < 1e-9 && (gap - clearance).abs() < 1e-3,
                "{mm} {sliding}: {own} {gap}"
            );
        }
    }

    /// ISO 7902-3 and DIN 31652-3: least films in µm by diameter, one row for each, and sliding speed.
    #[test]
    fn films_change_at_the_ends_of_diameters_and_speeds() {
        let ends_mm = [1.0, 63.0, 160.0, 400.0, 1000.0, 2000.0];
        let ends_m_s = [0.01, 1.0, 3.0, 10.0, 30.0, 60.0];
        let due = [
            [3.0, 4.0, 5.0, 7.0, 10.0],
            [4.0, 5.0, 7.0, 9.0, 12.0],
            [6.0, 7.0, 9.0, 11.0, 14.0],
            [8.0, 9.0, 11.0, 13.0, 16.0],
            [10.0, 12.0, 14.0, 16.0, 18.0],
        ];
        let inside = |ends: &[f64; 6], place: usize| [1.001 * ends[place], 0.999 * ends[place + 1]];
        for (row, films) in due.iter().enumerate() {
            for (column, film) in films.iter().enumerate() {
                for mm in inside(&ends_mm, row) {
                    for sliding in inside(&ends_m_s, column) {
                        let speed = AngularVelocity::from_si(sliding / (mm / 2e3));
                        let [diameter, width] = [mm; 2].map(Length::from_mm);
                        let own = PlainBearing::usual(diameter, width, speed).needed_film(speed).um();
                        assert!((own - film).abs() < 1e-9, "{mm} mm, {sliding} m/s: {own}");
                    }
                }
            }
        }
    }

    /// 7 N/mm² is usual of bronze, 20 N/mm² for a short time; oils thinner than 2 mm²/s thin as one of 2 mm²/s.
    #[test]
    fn limits_of_bushes_and_oils() {
        assert_eq!([USUAL_PRESSURE, GREATEST_PRESSURE], [7e6, 20e6]);
        let thins = |at_40: f64| viscosity(KinematicViscosity::from_mm2_s(at_40), None) / at_40;
        let is_same = |one: f64, other: f64| (thins(one) / thins(other) - 1.0).abs() < 1e-9;
        assert!(is_same(1.0, 1.99) && !is_same(1.99, 2.02));
        // 870 kg/m³ and 50 mm²/s at 70 °C of ISO VG 220.
        assert!((viscosity(KinematicViscosity::from_mm2_s(220.0), None) / 0.0435 - 1.0).abs() < 0.02);
        let stated = Some(KinematicViscosity::from_mm2_s(10.0));
        assert!((viscosity(KinematicViscosity::from_mm2_s(220.0), stated) / 8.7e-3 - 1.0).abs() < 1e-9);
        // A bearing longer than its diameter counts as one of B = D, with its own pressure.
        let film = |width: f64, kilonewtons: f64| {
            let [diameter, width] = [100.0, width].map(Length::from_mm);
            let bearing = PlainBearing { diameter, width, clearance: 1e-3 };
            bearing.film(Force::from_si(1e3 * kilonewtons), AngularVelocity::from_rpm(100.0), 0.05).um()
        };
        assert!((film(150.0, 30.0) / film(100.0, 20.0) - 1.0).abs() < 1e-9);
        assert!((film(90.0, 18.0) / film(100.0, 20.0) - 1.0).abs() > 1e-3);
    }
}

//! Stress limits over the number of load cycles: life factors, S-N lines.
//!
//! A line is straight between its points in double logarithmic scales, level before the first; beyond the
//! last, at 10¹⁰ cycles, a smaller stress does no damage.
//!
//! | factor | class | points: cycles, factor |
//! |---|---|---|
//! | `Z_NT` | St, V, GGG (perl., bai.), GTS, Eh, IF | 10⁵ 1.6; 5·10⁷ 1; 10¹⁰ 0.85 |
//! | | the same with some pitting allowed | 6·10⁵ 1.6; 10⁷ 1.3; 10⁹ 1; 10¹⁰ 0.85 |
//! | | GG, GGG (ferr.), NT, NV (nitr.) | 10⁵ 1.3; 2·10⁶ 1; 10¹⁰ 0.85 |
//! | | NV (nitrocar.) | 10⁵ 1.1; 2·10⁶ 1; 10¹⁰ 0.85 |
//! | `Y_NT` | St, V, GGG (perl., bai.), GTS | 10⁴ 2.5; 3·10⁶ 1; 10¹⁰ 0.85 |
//! | | Eh, IF | 10³ 2.5; 3·10⁶ 1; 10¹⁰ 0.85 |
//! | | GG, GGG (ferr.), NT, NV (nitr.) | 10³ 1.6; 3·10⁶ 1; 10¹⁰ 0.85 |
//! | | NV (nitrocar.) | 10³ 1.1; 3·10⁶ 1; 10¹⁰ 0.85 |
//!
//! At 10¹⁰ cycles the standard allows up to 1 where material, lubrication and experience are the best: that
//! value is given.
//!
//! # Source
//! ISO 6336-2:2006, clause 11 (table 2); ISO 6336-3:2006, clause 12 (table 1). The factors of the NREL
//! reference wind gearbox (0.857, 0.905, 0.901; 0.854, 0.886, 0.883) follow from these points to all printed
//! digits, as those of ISO/TR 6336-30.

use crate::material::Class;

/// Cycles at the end of the lines.
const END: f64 = 1e10;

/// Limit over cycles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    points: [(f64, f64); 4],
    count: usize,
    /// Index of the point at the limit of endurance, factor 1.
    reference: usize,
}

/// `Z_NT`, as limited by pitting.
#[must_use]
pub fn contact_line(class: Class, pitting_allowed: bool, end: f64) -> Line {
    use Class::{GreyIron, Nitrided, Nitrocarburized, NodularFerritic, ThroughHardenedNitrided};
    match class {
        GreyIron | NodularFerritic | Nitrided | ThroughHardenedNitrided => {
            Line::three((1e5, 1.3), (2e6, 1.0), (END, end))
        }
        Nitrocarburized => Line::three((1e5, 1.1), (2e6, 1.0), (END, end)),
        _ if pitting_allowed => {
            Line { points: [(6e5, 1.6), (1e7, 1.3), (1e9, 1.0), (END, end)], count: 4, reference: 2 }
        }
        _ => Line::three((1e5, 1.6), (5e7, 1.0), (END, end)),
    }
}

/// `Y_NT`.
#[must_use]
pub fn root_line(class: Class, end: f64) -> Line {
    use Class::{
        CaseHardened, GreyIron, Nitrided, Nitrocarburized, NodularFerritic, SurfaceHardened,
        ThroughHardenedNitrided,
    };
    let statically = match class {
        CaseHardened | SurfaceHardened => (1e3, 2.5),
        GreyIron | NodularFerritic | Nitrided | ThroughHardenedNitrided => (1e3, 1.6),
        Nitrocarburized => (1e3, 1.1),
        _ => (1e4, 2.5),
    };
    Line::three(statically, (3e6, 1.0), (END, end))
}

impl Line {
    const fn three(statically: (f64, f64), reference: (f64, f64), end: (f64, f64)) -> Self {
        Self { points: [statically, reference, end, end], count: 3, reference: 1 }
    }

    fn points(&self) -> &[(f64, f64)] {
        &self.points[..self.count]
    }

    /// The static limit.
    #[must_use]
    pub fn first(&self) -> f64 {
        self.points[0].1
    }

    /// The limit at the end.
    #[must_use]
    pub fn last(&self) -> f64 {
        self.points()[self.count - 1].1
    }

    /// Cycles from which on the factors of endurance hold alone.
    #[must_use]
    pub const fn reference_cycles(&self) -> f64 {
        self.points[self.reference].0
    }

    /// Line of stresses: the static point times `statically`, all others times `endurance`. No point is above
    /// the previous one, since a stress that is endured for many cycles is endured for few.
    #[must_use]
    pub fn times(mut self, statically: f64, endurance: f64) -> Self {
        let mut most = f64::INFINITY;
        for (index, point) in self.points.iter_mut().enumerate() {
            most = most.min(point.1 * if index == 0 { statically } else { endurance });
            point.1 = most;
        }
        self
    }

    /// The limit at a number of cycles.
    #[must_use]
    pub fn at(&self, cycles: f64) -> f64 {
        let points = self.points();
        if cycles <= points[0].0 {
            return points[0].1;
        }
        let piece = points.windows(2).find(|piece| cycles <= piece[1].0);
        piece.map_or(points[points.len() - 1].1, |piece| {
            let [(n1, y1), (n2, y2)] = [piece[0], piece[1]];
            y1 * libm::exp(libm::log(cycles / n1) / libm::log(n2 / n1) * libm::log(y2 / y1))
        })
    }

    /// The cycles after which a stress does its whole damage: 0 above the static limit, ∞ below the limit at
    /// the end of the line.
    ///
    /// On a level piece it is the later end.
    #[must_use]
    pub fn cycles(&self, stress: f64) -> f64 {
        let points = self.points();
        if stress > points[0].1 {
            return 0.0;
        }
        if stress < points[points.len() - 1].1 {
            return f64::INFINITY;
        }
        let piece = points.windows(2).rev().find(|piece| stress <= piece[0].1);
        piece.map_or(points[0].0, |piece| {
            let [(n1, y1), (n2, y2)] = [piece[0], piece[1]];
            if y1 == y2 {
                return n2;
            }
            n1 * libm::exp(libm::log(stress / y1) / libm::log(y2 / y1) * libm::log(n2 / n1))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn pieces_of_the_line_with_pitting_have_the_printed_exponents() {
        let line = contact_line(Class::CaseHardened, true, 0.85);
        // Z_N = (3·10⁸/N)^0.0756 up to 10⁷, (10⁹/N)^0.057 up to 10⁹.
        // The standard's own pieces leave a step of 0.007 at 10⁷.
        assert!((line.at(2e6) - libm::pow(3e8_f64 / 2e6, 0.0756)).abs() < 4e-3);
        assert!((line.at(1e8) - libm::pow(1e9_f64 / 1e8, 0.057)).abs() < 1e-3);
    }

    proptest! {
        #[test]
        fn cycles_and_limit_are_inverse(exponent in 5.1..9.9_f64, statically in 0.9..1.5_f64) {
            let line = contact_line(Class::CaseHardened, false, 0.85).times(statically * 900.0, 1200.0);
            let cycles = libm::pow(10_f64, exponent);
            prop_assert!((line.cycles(line.at(cycles)) / cycles - 1.0).abs() < 1e-9);
        }

        #[test]
        fn the_limit_never_rises(first in 2.0..12.0_f64, second in 2.0..12.0_f64, statically in 0.1..2.0_f64) {
            let line = root_line(Class::ThroughHardened, 0.9).times(statically, 1.0);
            let (few, many) = (first.min(second), first.max(second));
            prop_assert!(line.at(libm::pow(10_f64, few)) >= line.at(libm::pow(10_f64, many)) - 1e-12);
        }
    }
}

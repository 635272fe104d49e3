//! Fit of the rotor by circular arcs, and its error.
//!
//! The source claims that the rotor, like the stator, is made of arcs, and draws circles through `K₁P₁` and
//! `K₂P₁`: through its crest or trough and the junction of formulas (2)–(8). The exact curve
//! ([`crate::centrode`]) does not consist of arcs. This module finds the best pair of tangent arcs and its
//! deviation, and the deviation of the source's circles, which meet at an angle.
//!
//! An arc has its centre on the ray of the crest or of the trough, so that the lobes join smoothly. Crest
//! radius `ρ_c`, trough radius `ρ_t` and curvature radius `q_c` of the crest's arc are free; that of the
//! trough's arc follows from tangency:
//!
//! ```text
//! q_t = (q_c² − c² − ρ_t² + 2·c·ρ_t·cos(π/n))/(2·(q_c + c·cos(π/n) − ρ_t))        c = ρ_c − q_c
//! ```
//!
//! The best pair makes the greatest distance from the exact curve, evaluated in 401 places, least
//! (Chebyshev). Linear in small steps, the problem is solved by exchange of the four places that decide it;
//! the deviation is the least to a thousandth of itself.
//!
//! # Source
//! rotary-hydromotor, algorithm of the profile. Our rotor departs from it: it is the exact curve.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use epicyclic_numerics::linear::fixed_solution;
use epicyclic_units::Physical;
use uom::si::f64::{Angle, Curvature, Length};

use crate::contact::{By, Conjugate};
use crate::modules::curvature;
use crate::motor::Motor;
use crate::tolerance::{BETTER, DIFFERENCE, FINER, LEVEL, NOISE, REACH, SINGULAR};

/// Places along the half-lobe at which the distance is evaluated.
const PLACES: u32 = 400;

/// The best pair of tangent arcs of a rotor's half-lobe.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwoArcFit {
    /// Distance of the arcs' crest from the axis.
    pub crest_radius: Length,
    /// Distance of the arcs' trough from the axis.
    pub trough_radius: Length,
    /// Curvature of the arc at the crest.
    pub crest_curvature: Curvature,
    /// Curvature of the arc at the trough; negative where it bulges inward.
    pub trough_curvature: Curvature,
    /// Greatest distance of the exact curve from the arcs.
    pub deviation: Length,
}

/// The circles that the source lays through crest and junction, and through junction and trough.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PublishedCircles {
    /// Curvature of the circle through the crest.
    pub crest_curvature: Curvature,
    /// Curvature of the circle through the trough.
    pub trough_curvature: Curvature,
    /// Greatest distance of the exact curve from the circles.
    pub deviation: Length,
    /// Angle at which they meet in the junction.
    pub kink: Angle,
}

/// An arc by its apex, the outward direction there, and its curvature.
#[derive(Debug, Clone, Copy)]
struct Arc {
    apex: [f64; 2],
    outward: [f64; 2],
    curvature: f64,
}

impl Arc {
    /// Distance of a point, positive outward; for a straight arc as well.
    fn distance(&self, point: [f64; 2]) -> f64 {
        let d = [point[0] - self.apex[0], point[1] - self.apex[1]];
        let normal = [self.outward[0] + self.curvature * d[0], self.outward[1] + self.curvature * d[1]];
        let outward = d[0] * self.outward[0] + d[1] * self.outward[1];
        let square = d[0] * d[0] + d[1] * d[1];
        (self.curvature * square + 2.0 * outward) / (libm::hypot(normal[0], normal[1]) + 1.0)
    }

    /// Direction of the outward normal at a point of it.
    fn normal_angle(&self, point: [f64; 2]) -> f64 {
        let d = [point[0] - self.apex[0], point[1] - self.apex[1]];
        polar(self.outward[0] + self.curvature * d[0], self.outward[1] + self.curvature * d[1])
    }

    /// Arc through another point as well.
    fn through(apex: [f64; 2], outward: [f64; 2], point: [f64; 2]) -> Self {
        let d = [point[0] - apex[0], point[1] - apex[1]];
        let curvature = -2.0 * (d[0] * outward[0] + d[1] * outward[1]) / (d[0] * d[0] + d[1] * d[1]);
        Self { apex, outward, curvature }
    }
}

/// Polar angle from −90° to 270°: a half-lobe spans half a turn where `n = 1`.
fn polar(x: f64, y: f64) -> f64 {
    let angle = libm::atan2(y, x);
    if angle < -FRAC_PI_2 { angle + TAU } else { angle }
}

/// The free parameters: crest radius, trough radius, curvature radius at the crest.
type Parameters = [f64; 3];

/// A tangent pair and the direction of the normal in which its arcs meet.
#[derive(Debug, Clone, Copy)]
struct Pair {
    crest: Arc,
    trough: Arc,
    /// Direction of the normal at the junction.
    junction: f64,
}

impl Pair {
    fn new([crest, trough, q]: Parameters, span: f64) -> Self {
        let (sin, cos) = libm::sincos(span);
        let centre = crest - q;
        let above = q * q - centre * centre - trough * trough + 2.0 * centre * trough * cos;
        let kappa = 2.0 * (q + centre * cos - trough) / above;
        let apex = [trough * cos, trough * sin];
        // w = (κ·(T − C) − u)/(κ·q − 1): from either centre to the junction.
        let scale = kappa * q - 1.0;
        let normal = [(kappa * (apex[0] - centre) - cos) / scale, (kappa * apex[1] - sin) / scale];
        Self {
            crest: Arc { apex: [crest, 0.0], outward: [1.0, 0.0], curvature: q.recip() },
            trough: Arc { apex, outward: [cos, sin], curvature: kappa },
            junction: polar(normal[0], normal[1]),
        }
    }

    fn distance(&self, point: [f64; 2]) -> f64 {
        let on_crest = self.crest.normal_angle(point) <= self.junction;
        if on_crest { self.crest.distance(point) } else { self.trough.distance(point) }
    }
}

impl Motor {
    /// The best pair of tangent arcs of the rotor's half-lobe, and its deviation.
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::{f64::Length, length::millimeter};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(5, 3, 55, 10)?, mm(1.0), mm(40.0))?;
    /// let missed = motor.two_arc_fit().deviation.get::<millimeter>();
    /// assert!(missed > 0.01 && missed < 0.03);
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    #[must_use]
    pub fn two_arc_fit(&self) -> TwoArcFit {
        let span = PI / f64::from(self.numbers().rotor_lobes());
        let points = self.rotor_points();
        let (crest, trough) = (self.shape.at(By::Phase, 0.0), self.shape.trough());
        let start = [crest.rho1, trough.rho1, crest.kappa1.recip()];
        let (parameters, deviation) = best(&points, start, span);
        let pair = Pair::new(parameters, span);
        TwoArcFit {
            crest_radius: self.length(parameters[0]),
            trough_radius: self.length(parameters[1]),
            crest_curvature: curvature(pair.crest.curvature, self.module()),
            trough_curvature: curvature(pair.trough.curvature, self.module()),
            deviation: self.length(deviation),
        }
    }

    /// The source's circles; `None` for a motor whose stator has no two arcs.
    #[must_use]
    pub fn published_circles(&self) -> Option<PublishedCircles> {
        let junction = self.shape.within(By::Phase, self.shape.kink()?);
        let (crest, trough) = (self.shape.at(By::Phase, 0.0), self.shape.trough());
        let point = [junction.rho1 * libm::cos(junction.theta1), junction.rho1 * libm::sin(junction.theta1)];
        let (sin, cos) = libm::sincos(trough.theta1);
        let crest = Arc::through([crest.rho1, 0.0], [1.0, 0.0], point);
        let trough = Arc::through([trough.rho1 * cos, trough.rho1 * sin], [cos, sin], point);
        let distance = |i: usize, at: [f64; 2]| {
            let s = trough_arc(self) * i as f64 / f64::from(PLACES);
            if s <= junction.s1 { crest.distance(at) } else { trough.distance(at) }
        };
        let points = self.rotor_points();
        let deviation = points.iter().enumerate().map(|(i, &at)| distance(i, at).abs()).fold(0.0, f64::max);
        Some(PublishedCircles {
            crest_curvature: curvature(crest.curvature, self.module()),
            trough_curvature: curvature(trough.curvature, self.module()),
            deviation: self.length(deviation),
            kink: Angle::from_si((crest.normal_angle(point) - trough.normal_angle(point)).abs()),
        })
    }

    fn rotor_points(&self) -> Vec<[f64; 2]> {
        let at = |i: u32| {
            let contact =
                self.shape.within(By::RotorArc, trough_arc(self) * f64::from(i) / f64::from(PLACES));
            [contact.rho1 * libm::cos(contact.theta1), contact.rho1 * libm::sin(contact.theta1)]
        };
        (0..=PLACES).map(at).collect()
    }
}

fn trough_arc(motor: &Motor) -> f64 {
    motor.shape.trough().s1
}

fn greatest(points: &[[f64; 2]], parameters: Parameters, span: f64) -> f64 {
    let pair = Pair::new(parameters, span);
    let most = points.iter().map(|&point| pair.distance(point).abs()).fold(0.0, f64::max);
    if most.is_nan() { f64::INFINITY } else { most }
}

/// The parameters whose greatest distance is least, and that distance: the linear problem solved exactly
/// within a reach that grows with success and shrinks without.
///
/// The reach enters as three more rows, `|stepᵢ|·deviation/reach`, which the solution levels with the
/// distances.
fn best(points: &[[f64; 2]], start: Parameters, span: f64) -> (Parameters, f64) {
    let mut found = (start, greatest(points, start, span));
    // A reach that shrinks to nothing short of the best is seen by looking about.
    for _ in 0..50 {
        found = within_reach(points, found, span);
        match compass(points, found, span) {
            Some(better) => found = better,
            None => break,
        }
    }
    found
}

fn within_reach(points: &[[f64; 2]], start: (Parameters, f64), span: f64) -> (Parameters, f64) {
    let (mut parameters, mut deviation) = start;
    let whole = parameters[0];
    let mut reach = 1e-2 * whole;
    let mut slopes = rows(points, parameters, span);
    while reach > REACH * whole {
        let mut bounded = slopes.clone();
        bounded.extend((0..3).map(|i| {
            let mut row = [0.0; 4];
            row[i] = deviation / reach;
            row
        }));
        let better = linear_best(&bounded).and_then(|step| {
            let moved = std::array::from_fn(|i| parameters[i] + step[i]);
            let now = greatest(points, moved, span);
            (now < deviation * (1.0 - BETTER)).then_some((moved, now))
        });
        match better {
            Some((moved, now)) => {
                (parameters, deviation) = (moved, now);
                slopes = rows(points, parameters, span);
                reach *= 2.0;
            }
            None => reach *= 0.25,
        }
    }
    (parameters, deviation)
}

/// A better place in one of the 26 directions about, nearer and nearer.
fn compass(points: &[[f64; 2]], start: (Parameters, f64), span: f64) -> Option<(Parameters, f64)> {
    let (parameters, deviation) = start;
    (4..24).map(|halvings| parameters[0] * 0.5_f64.powi(halvings)).find_map(|reach| {
        (0..27_u32).find_map(|direction| {
            let moved = std::array::from_fn(|i| {
                let digit = f64::from(direction / 3_u32.pow(i as u32) % 3) - 1.0;
                parameters[i] + reach * digit
            });
            let now = greatest(points, moved, span);
            (now < deviation * (1.0 - FINER)).then_some((moved, now))
        })
    })
}

/// Slopes of each point's distance by the parameters, and the distance.
fn rows(points: &[[f64; 2]], parameters: Parameters, span: f64) -> Vec<[f64; 4]> {
    let h = DIFFERENCE * parameters[0];
    let moved = |i: usize, by: f64| {
        let mut moved = parameters;
        moved[i] += by;
        Pair::new(moved, span)
    };
    let pairs: [(Pair, Pair); 3] = std::array::from_fn(|i| (moved(i, h), moved(i, -h)));
    let here = Pair::new(parameters, span);
    let slope = |pair: &(Pair, Pair), at| (pair.0.distance(at) - pair.1.distance(at)) / (2.0 * h);
    let row = |&at: &[f64; 2]| {
        [slope(&pairs[0], at), slope(&pairs[1], at), slope(&pairs[2], at), here.distance(at)]
    };
    points.iter().map(row).collect()
}

/// The step that makes the greatest of `|row·(step, 1)|` least, by exchange of one of four rows at a time
/// (Stiefel).
fn linear_best(rows: &[[f64; 4]]) -> Option<Parameters> {
    let count = rows.len();
    let mut basis = [0, count / 3, 2 * count / 3, count - 1];
    // Of any four rows there is one combination of the slopes that vanishes; its signs are those of the
    // distances.
    let mut equations = [[0.0; 5]; 4];
    for (column, &row) in basis.iter().enumerate() {
        for (i, equation) in equations.iter_mut().take(3).enumerate() {
            equation[column] = rows[row][i];
        }
    }
    equations[3] = [1.0, 1.0, 1.0, 1.0, 1.0];
    let mut signs = fixed_solution(equations, SINGULAR)?.map(f64::signum);
    for _ in 0..200 {
        // Level: sign·(row·step + distance) = E.
        let level = std::array::from_fn(|i| {
            let ([x, y, z, distance], sign) = (rows[basis[i]], signs[i]);
            [sign * x, sign * y, sign * z, -1.0, -sign * distance]
        });
        let [x, y, z, height] = fixed_solution(level, SINGULAR)?;
        if height < 0.0 {
            // The combination may as well have the opposite signs.
            signs = signs.map(|sign: f64| -sign);
            continue;
        }
        let distance = |row: &[f64; 4]| row[0] * x + row[1] * y + row[2] * z + row[3];
        let (worst, most) =
            rows.iter().map(distance).enumerate().fold((0, 0.0), |best: (usize, f64), (i, value)| {
                if value.abs() > best.1.abs() { (i, value) } else { best }
            });
        if most.abs() <= height * (1.0 + LEVEL) || basis.contains(&worst) {
            return Some([x, y, z]);
        }
        // The new row replaces the one whose weight vanishes first.
        let column = |row: usize, sign: f64, i: usize| if i < 3 { sign * rows[row][i] } else { 1.0 };
        let weighed = |right: [f64; 4]| {
            let row = |i: usize| {
                let of = |j: usize| column(basis[j], signs[j], i);
                [of(0), of(1), of(2), of(3), right[i]]
            };
            fixed_solution::<4, 5>(std::array::from_fn(row), SINGULAR)
        };
        let weights = weighed([0.0, 0.0, 0.0, 1.0])?;
        let sign = most.signum();
        let shares = weighed(std::array::from_fn(|i| column(worst, sign, i)))?;
        // Shares below the differences' own noise are none.
        let ratio = |i: usize| if shares[i] > NOISE { weights[i] / shares[i] } else { f64::INFINITY };
        let leaving = (0..4).min_by(|&a, &b| ratio(a).total_cmp(&ratio(b)))?;
        basis[leaving] = worst;
        signs[leaving] = sign;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::MotorNumbers;
    use crate::centrode::tests::any_motor;
    use epicyclic_numerics::values::largest_absolute;
    use proptest::prelude::*;

    #[test]
    fn the_arcs_miss_the_vectors_of_the_source_by_hundredths_of_a_module() {
        let m = Length::from_si;
        let mut deviations = Vec::new();
        for (numbers, l) in [((5, 3, 55, 10), 40.0), ((5, 3, 55, 10), 30.0), ((6, 4, 66, 10), 40.0)] {
            let numbers = MotorNumbers::new(numbers.0, numbers.1, numbers.2, numbers.3).unwrap();
            let motor = Motor::of_two_arcs(numbers, m(1.0), m(l)).unwrap();
            deviations.push(motor.two_arc_fit().deviation.si());
            let circles = motor.published_circles().unwrap();
            assert!(circles.deviation.si() > 1.8 * deviations[deviations.len() - 1]);
            assert!(circles.kink.value > 0.016 && circles.kink.value < 0.031);
        }
        assert!(deviations.iter().all(|&d| d > 0.0105 && d < 0.0225), "{deviations:?}");
    }

    /// Chebyshev: among all `a·x + b·x² + c·x³` on positive `x` the best one has its greatest deviation at
    /// four points with alternating signs.
    #[test]
    fn the_best_step_levels_four_distances_of_alternate_signs() {
        let functions: [fn(f64) -> f64; 3] = [libm::exp, |x| libm::sin(3.0 * x), |x| 1.0 / (1.2 + x)];
        for count in 4..40_u32 {
            for f in functions {
                let at = |i: u32| 0.2 + f64::from(i) / f64::from(count - 1);
                let rows: Vec<[f64; 4]> = (0..count).map(at).map(|x| [x, x * x, x * x * x, -f(x)]).collect();
                let [x, y, z] = linear_best(&rows).unwrap();
                let left: Vec<f64> =
                    rows.iter().map(|row| row[0] * x + row[1] * y + row[2] * z + row[3]).collect();
                let most = largest_absolute(&left);
                let mut turns: Vec<f64> = left
                    .iter()
                    .filter(|value| value.abs() > most * (1.0 - 1e-6))
                    .map(|value| value.signum())
                    .collect();
                turns.dedup();
                assert!(turns.len() >= 4, "{count} points: {left:?}");
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]

        #[test]
        fn no_pair_nearby_fits_better(motor in any_motor(), by in [-1.0..1.0, -1.0..1.0, -1.0..1.0_f64], size in -6.0..-1.0_f64) {
            let span = PI / f64::from(motor.numbers().rotor_lobes());
            let points = motor.rotor_points();
            let (crest, trough) = (motor.shape.at(By::Phase, 0.0), motor.shape.trough());
            let (parameters, deviation) = best(&points, [crest.rho1, trough.rho1, crest.kappa1.recip()], span);
            let moved = std::array::from_fn(|i| parameters[i] + by[i] * libm::pow(10.0_f64, size));
            prop_assert!(greatest(&points, moved, span) >= deviation * (1.0 - 1e-3));
        }
    }
}

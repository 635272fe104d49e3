//! The stator's centrode: system (1), solved for any two of its six parameters.
//!
//! ```text
//! R₁ + R₂ = (a² + l² − 2·a·l·cos θ₃)^½        R₁·Γ + R₂·B = L/(2N)
//! (R₁ + R₂)/sin θ₃ = a/sin Γ                    B = θ₃ + Γ
//! ```
//!
//! One of `2N` congruent pieces. `O` is the axis. *Arc 1* bulges inward, about `O₁` on the ray 0, at the
//! *trough* where the stator comes nearest to the axis; *arc 2* bulges outward, about `O₂` on the ray `θ₃`,
//! at the *crest*. They touch on the line `O₁O₂`.
//!
//! | symbol | here | meaning | unit |
//! |---|---|---|---|
//! | `l`, `a` | trough and crest distance | of `O₁` and `O₂` from the axis | m |
//! | `R₁`, `R₂` | trough and crest radius | of arc 1 and arc 2 | m |
//! | `Γ`, `B` | trough and crest angle | of arc 1 at `O₁`, of arc 2 at `O₂` | rad |
//! | `θ₃` | | `π/N` | rad |
//! | `L` | | length of the centrode, `π·m·Z₃` | m |
//!
//! # Which pairs determine the rest
//! With the distance `D = R₁ + R₂` of the centres everything follows from `D` and `Γ`, `S = L/(2N)`:
//!
//! ```text
//! l = D·sin B/sin θ₃    a = D·sin Γ/sin θ₃    R₁ = (D·B − S)/θ₃    R₂ = (S − D·Γ)/θ₃
//! ```
//!
//! A given pair leaves one equation for `Γ` in `0…π − θ₃`:
//!
//! | pair | equation | solutions |
//! |---|---|---|
//! | `l, a` | the triangle of `O`, `O₁`, `O₂` | 1 |
//! | an angle and a length | linear in `D` | 1 |
//! | `R₁, R₂` | `Γ = (S − θ₃·R₂)/D` | 1 |
//! | `l, R₁` | `sin B/B`, falling | 1 |
//! | `l, R₂` | `sin B/Γ`, falling | 1 |
//! | `a, R₂` | `sin Γ/Γ`, falling | 1 |
//! | `a, R₁` | `sin Γ/B`, rises up to `tan Γ = B`, then falls | 0, 1 or 2 |
//! | `Γ, B` | they differ by `θ₃` | undetermined |
//!
//! Solutions in which a length is not positive are not arcs and are left out.
//!
//! # Source
//! rotary-hydromotor (1). It prints `L/(2n)`, with `n₃ = N` in `θ₃ = π/n₃`.

use crate::quantity::{ArcsFault, OpenPair, Quantity};
use std::f64::consts::PI;

use epicyclic_units::Physical;
use uom::si::f64::{Angle, Length};

use crate::Error;
use crate::machine;
use crate::modules::length;
use crate::numbers::MotorNumbers;
use crate::ranges::{finite_angle, positive_modules};
use crate::real::Real;
use epicyclic_numerics::roots::bracketed;

/// System (1) in units of the module, solved for two distances; generic, so that its derivatives come with
/// it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Arcs<T = f64> {
    pub(crate) theta3: f64,
    /// Length of a half-lobe, `S = L/(2N)`.
    pub(crate) half_length: f64,
    pub(crate) l: T,
    pub(crate) a: T,
    pub(crate) r1: T,
    pub(crate) r2: T,
    pub(crate) gamma: T,
    pub(crate) beta: T,
    /// `tan(Γ/2)` and `tan(B/2)`.
    pub(crate) tan_gamma: T,
    pub(crate) tan_beta: T,
    /// The stator's least radius `l − R₁`, without the cancellation of a large `l`.
    pub(crate) least: T,
}

impl<T: Real> Arcs<T> {
    /// Arcs of the distances `l > 0` and `a > 0`.
    pub(crate) fn of_distances(theta3: f64, half_length: f64, l: T, a: T) -> Self {
        let (sin, cos) = libm::sincos(theta3);
        let (theta, s, sin, cos) = (T::of(theta3), T::of(half_length), T::of(sin), T::of(cos));
        let (along, across) = (l - a * cos, a * sin);
        let d = (along * along + across * across).sqrt();
        let tan_gamma = across / (d + along);
        let tan_beta = l * sin / (d + l * cos - a);
        let gamma = T::of(2.0) * tan_gamma.atan();
        let beta = theta + gamma;
        let r1 = (d * beta - s) / theta;
        let r2 = (s - d * gamma) / theta;
        // l − D = (l² − D²)/(l + D)
        let least = a * (T::of(2.0) * l * cos - a) / (l + d) + r2;
        Self { theta3, half_length, l, a, r1, r2, gamma, beta, tan_gamma, tan_beta, least }
    }
}

impl Arcs {
    /// Arcs of `D` and `Γ`.
    fn of_triangle(theta3: f64, half_length: f64, d: f64, gamma: f64) -> Self {
        let beta = theta3 + gamma;
        let sin = libm::sin(theta3);
        let (l, a) = (d * libm::sin(beta) / sin, d * libm::sin(gamma) / sin);
        let r1 = (d * beta - half_length) / theta3;
        let r2 = (half_length - d * gamma) / theta3;
        let (tan_gamma, tan_beta) = (libm::tan(gamma / 2.0), libm::tan(beta / 2.0));
        let least = a * (2.0 * l * libm::cos(theta3) - a) / (l + d) + r2;
        Self { theta3, half_length, l, a, r1, r2, gamma, beta, tan_gamma, tan_beta, least }
    }

    fn first_not_positive(&self) -> Option<ArcsFault> {
        let all = [
            (self.l, ArcsFault::TroughDistance),
            (self.a, ArcsFault::CrestDistance),
            (self.r1, ArcsFault::TroughRadius),
            (self.r2, ArcsFault::CrestRadius),
            (self.gamma, ArcsFault::TroughAngle),
            (PI - self.beta, ArcsFault::CrestAngle),
        ];
        all.iter().find(|(value, _)| !(value.is_finite() && *value > 0.0)).map(|(_, why)| *why)
    }
}

/// A known parameter of system (1).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Known {
    /// Distance `l` of the centre of arc 1 from the axis.
    TroughDistance(Length),
    /// Distance `a` of the centre of arc 2 from the axis.
    CrestDistance(Length),
    /// Radius `R₁` of arc 1.
    TroughRadius(Length),
    /// Radius `R₂` of arc 2.
    CrestRadius(Length),
    /// Angle `Γ` of arc 1.
    TroughAngle(Angle),
    /// Angle `B` of arc 2.
    CrestAngle(Angle),
}

impl Known {
    fn quantity(self) -> Quantity {
        match self {
            Self::TroughDistance(_) => Quantity::TroughDistance,
            Self::CrestDistance(_) => Quantity::CrestDistance,
            Self::TroughRadius(_) => Quantity::TroughRadius,
            Self::CrestRadius(_) => Quantity::CrestRadius,
            Self::TroughAngle(_) => Quantity::TroughAngle,
            Self::CrestAngle(_) => Quantity::CrestAngle,
        }
    }
}

/// A known parameter in units of the module; `B` has become `Γ`.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Scaled {
    L(f64),
    A(f64),
    R1(f64),
    R2(f64),
    Gamma(f64),
}

/// Two tangent arcs that fulfil system (1).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StatorArcs {
    pub(crate) arcs: Arcs,
    pub(crate) module: Length,
}

impl StatorArcs {
    /// Finds all pairs of arcs with two known parameters, by rising `Γ`: none of those of the table above is
    /// left out.
    ///
    /// System (1) depends only on the lobes and teeth of the stator. Whether the rotor closes is another
    /// matter: [`crate::closure`].
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::NotFinite`], [`Error::OutOfRange`] for a parameter or the module;
    /// [`Error::PairUndetermined`] for twice the same parameter or both angles; [`Error::NoArcs`] if no pair
    /// of arcs has both.
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::MotorNumbers;
    /// use epicyclic_hydromotor::arcs::{Known, StatorArcs};
    /// use uom::si::{f64::Length, length::millimeter};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let numbers = MotorNumbers::new(5, 3, 55, 10)?;
    /// let known = [Known::TroughDistance(mm(40.0)), Known::CrestDistance(mm(15.30631008))];
    /// let arcs = StatorArcs::with(numbers, mm(1.0), known)?;
    /// assert_eq!(arcs.len(), 1);
    /// assert!((arcs[0].trough_radius().get::<millimeter>() - 16.1037961).abs() < 5e-8);
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn with(numbers: MotorNumbers, module: Length, known: [Known; 2]) -> Result<Vec<Self>, Error> {
        let module = machine::module(module)?;
        let theta3 = PI / f64::from(numbers.stator_lobes());
        let half_length = half_length(numbers);
        let [first, second] = known.map(Known::quantity);
        let undetermined = |why| Error::PairUndetermined { first, second, why };
        let [one, other] = known.map(|known| scaled(known, theta3, module));
        let (one, other) = (one?, other?);
        if let (Scaled::Gamma(_), Scaled::Gamma(_)) = (one, other) {
            return Err(undetermined(OpenPair::BothAngles));
        }
        if first == second {
            return Err(undetermined(OpenPair::SameParameter));
        }
        let candidates = candidates(theta3, half_length, one, other);
        let mut refused = ArcsFault::NoSolution;
        let mut found = Vec::new();
        for arcs in candidates {
            match arcs.first_not_positive() {
                None => found.push(Self { arcs, module }),
                Some(why) => refused = why,
            }
        }
        if found.is_empty() { Err(Error::NoArcs { first, second, why: refused }) } else { Ok(found) }
    }

    /// `l`: distance of the centre of arc 1 from the axis.
    #[must_use]
    pub fn trough_distance(&self) -> Length {
        length(self.arcs.l, self.module)
    }

    /// `a`: distance of the centre of arc 2 from the axis.
    #[must_use]
    pub fn crest_distance(&self) -> Length {
        length(self.arcs.a, self.module)
    }

    /// `R₁`: radius of arc 1.
    #[must_use]
    pub fn trough_radius(&self) -> Length {
        length(self.arcs.r1, self.module)
    }

    /// `R₂`: radius of arc 2.
    #[must_use]
    pub fn crest_radius(&self) -> Length {
        length(self.arcs.r2, self.module)
    }

    /// `Γ`: angle of arc 1 at its centre.
    #[must_use]
    pub fn trough_angle(&self) -> Angle {
        Angle::from_si(self.arcs.gamma)
    }

    /// `B`: angle of arc 2 at its centre.
    #[must_use]
    pub fn crest_angle(&self) -> Angle {
        Angle::from_si(self.arcs.beta)
    }

    /// The module that their lengths are multiples of.
    #[must_use]
    pub fn module(&self) -> Length {
        self.module
    }

    /// `θ₃ = π/N`: angle of one of the `2N` pieces of the centrode.
    #[must_use]
    pub fn piece_angle(&self) -> Angle {
        Angle::from_si(self.arcs.theta3)
    }

    /// `L/(2N)`: length of one of the `2N` pieces of the centrode.
    #[must_use]
    pub fn piece_length(&self) -> Length {
        length(self.arcs.half_length, self.module)
    }

    /// Left side less right side of each of the four equations of system (1), over its right side: the
    /// rounding.
    #[must_use]
    pub fn system_misses(&self) -> [f64; 4] {
        let Arcs { theta3, half_length, l, a, r1, r2, gamma, beta, .. } = self.arcs;
        let distance = libm::sqrt(a * a + l * l - 2.0 * a * l * libm::cos(theta3));
        [
            [r1 + r2, distance],
            [r1 * gamma + r2 * beta, half_length],
            [(r1 + r2) / libm::sin(theta3), a / libm::sin(gamma)],
            [beta, theta3 + gamma],
        ]
        .map(|[left, right]| (left - right) / right)
    }

    /// The stator's least radius, `l − R₁`.
    #[must_use]
    pub fn least_radius(&self) -> Length {
        length(self.arcs.least, self.module)
    }
}

/// Half a lobe of the stator in modules, `S = L/(2N)` with `L = π·m·Z₃`.
pub(crate) fn half_length(numbers: MotorNumbers) -> f64 {
    PI * f64::from(numbers.teeth_per_lobe()) / 2.0
}

fn scaled(known: Known, theta3: f64, module: Length) -> Result<Scaled, Error> {
    let modules = |quantity, value| positive_modules(quantity, value, module);
    let gamma_of = |quantity, value, low: f64, high: f64| {
        let value = finite_angle(quantity, value)?;
        if value > low && value < high {
            return Ok(Scaled::Gamma(value - low));
        }
        let [value, low, high] = [value, low, high].map(|end| Angle::from_si(end).degrees());
        Err(Error::OutOfRange { quantity, value, low, high, unit: "°" })
    };
    Ok(match known {
        Known::TroughDistance(l) => Scaled::L(modules(Quantity::TroughDistance, l)?),
        Known::CrestDistance(a) => Scaled::A(modules(Quantity::CrestDistance, a)?),
        Known::TroughRadius(r1) => Scaled::R1(modules(Quantity::TroughRadius, r1)?),
        Known::CrestRadius(r2) => Scaled::R2(modules(Quantity::CrestRadius, r2)?),
        Known::TroughAngle(gamma) => gamma_of(Quantity::TroughAngle, gamma, 0.0, PI - theta3)?,
        Known::CrestAngle(beta) => gamma_of(Quantity::CrestAngle, beta, theta3, PI)?,
    })
}

/// Solutions before their signs are checked.
fn candidates(theta: f64, s: f64, one: Scaled, other: Scaled) -> Vec<Arcs> {
    use Scaled::{A, Gamma, L, R1, R2};
    let sin = libm::sin(theta);
    let widest = PI - theta;
    let of = |d: f64, gamma: f64| Arcs::of_triangle(theta, s, d, gamma);
    // The one root of a falling function that starts above the value and ends below it, if it does.
    let falling = |f: &dyn Fn(f64) -> f64| {
        let (low, high) = (f64::MIN_POSITIVE, widest);
        (f(low) > 0.0 && f(high) < 0.0).then(|| bracketed(low, high, f))
    };
    match (one, other) {
        (L(l), A(a)) | (A(a), L(l)) => vec![Arcs::of_distances(theta, s, l, a)],
        (L(l), Gamma(gamma)) | (Gamma(gamma), L(l)) => vec![of(l * sin / libm::sin(theta + gamma), gamma)],
        (A(a), Gamma(gamma)) | (Gamma(gamma), A(a)) => vec![of(a * sin / libm::sin(gamma), gamma)],
        (R1(r1), Gamma(gamma)) | (Gamma(gamma), R1(r1)) => {
            vec![of((theta * r1 + s) / (theta + gamma), gamma)]
        }
        (R2(r2), Gamma(gamma)) | (Gamma(gamma), R2(r2)) => vec![of((s - theta * r2) / gamma, gamma)],
        (R1(r1), R2(r2)) | (R2(r2), R1(r1)) => vec![of(r1 + r2, (s - theta * r2) / (r1 + r2))],
        (L(l), R1(r1)) | (R1(r1), L(l)) => {
            let d = |gamma: f64| (theta * r1 + s) / (theta + gamma);
            falling(&|gamma| d(gamma) * libm::sin(theta + gamma) - l * sin)
                .map(|gamma| of(d(gamma), gamma))
                .into_iter()
                .collect()
        }
        (L(l), R2(r2)) | (R2(r2), L(l)) => {
            let rest = s - theta * r2;
            falling(&|gamma| rest * libm::sin(theta + gamma) - l * sin * gamma)
                .map(|gamma| of(rest / gamma, gamma))
                .into_iter()
                .collect()
        }
        (A(a), R2(r2)) | (R2(r2), A(a)) => {
            let rest = s - theta * r2;
            falling(&|gamma| rest * libm::sin(gamma) / gamma - a * sin)
                .map(|gamma| of(rest / gamma, gamma))
                .into_iter()
                .collect()
        }
        (A(a), R1(r1)) | (R1(r1), A(a)) => {
            let d = |gamma: f64| (theta * r1 + s) / (theta + gamma);
            let over = |gamma: f64| d(gamma) * libm::sin(gamma) - a * sin;
            // The top, tan Γ = B, lies below a right angle; with θ₃ = π/2 the range ends there as well.
            let top = bracketed(0.0, widest.min(PI / 2.0), |gamma| {
                libm::sin(gamma) - (theta + gamma) * libm::cos(gamma)
            });
            let sides = [(0.0, top), (top, widest)];
            sides
                .into_iter()
                .filter(|&(low, high)| {
                    over(low) < 0.0 && over(high) >= 0.0 || over(low) >= 0.0 && over(high) < 0.0
                })
                .map(|(low, high)| bracketed(low, high, over))
                .map(|gamma| of(d(gamma), gamma))
                .collect()
        }
        (L(_), L(_)) | (A(_), A(_)) | (R1(_), R1(_)) | (R2(_), R2(_)) | (Gamma(_), Gamma(_)) => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn mm(value: f64) -> Length {
        Length::from_mm(value)
    }

    fn numbers() -> MotorNumbers {
        MotorNumbers::new(5, 3, 55, 10).unwrap()
    }

    fn all_known(arcs: &StatorArcs) -> [Known; 6] {
        [
            Known::TroughDistance(arcs.trough_distance()),
            Known::CrestDistance(arcs.crest_distance()),
            Known::TroughRadius(arcs.trough_radius()),
            Known::CrestRadius(arcs.crest_radius()),
            Known::TroughAngle(arcs.trough_angle()),
            Known::CrestAngle(arcs.crest_angle()),
        ]
    }

    fn values(arcs: &StatorArcs) -> [f64; 6] {
        let Arcs { l, a, r1, r2, gamma, beta, .. } = arcs.arcs;
        [l, a, r1, r2, gamma, beta]
    }

    #[test]
    fn the_four_equations_hold() {
        let known = [Known::TroughDistance(mm(40.0)), Known::CrestDistance(mm(15.30631008))];
        let arcs = StatorArcs::with(numbers(), mm(1.0), known).unwrap()[0];
        let [l, a, r1, r2, gamma, beta] = values(&arcs);
        let theta = PI / 5.0;
        let d = (a * a + l * l - 2.0 * a * l * libm::cos(theta)).sqrt();
        assert!((r1 + r2 - d).abs() < 1e-13);
        assert!((r1 * gamma + r2 * beta - PI * 55.0 / 10.0).abs() < 1e-13);
        assert!((d / libm::sin(theta) - a / libm::sin(gamma)).abs() < 1e-12);
        assert!((beta - theta - gamma).abs() < 1e-15);
        assert!((gamma - 0.314_929_961_159).abs() < 1e-9);
    }

    #[test]
    fn trough_radius_and_crest_distance_can_have_two_solutions() {
        let known = [Known::CrestDistance(mm(17.0)), Known::TroughRadius(mm(4.0))];
        let both = StatorArcs::with(numbers(), mm(1.0), known).unwrap();
        assert_eq!(both.len(), 2);
        assert!(both[0].arcs.gamma < both[1].arcs.gamma);
        for arcs in &both {
            assert!((arcs.crest_distance() - mm(17.0)).mm().abs() < 1e-12);
            assert!((arcs.trough_radius() - mm(4.0)).mm().abs() < 1e-12);
        }
    }

    #[test]
    fn what_determines_nothing_is_refused() {
        let with = |first, second| StatorArcs::with(numbers(), mm(1.0), [first, second]).unwrap_err();
        let both = with(Known::TroughAngle(Angle::from_si(0.3)), Known::CrestAngle(Angle::from_si(0.9)));
        assert!(matches!(both, Error::PairUndetermined { .. }));
        let twice = with(Known::TroughDistance(mm(40.0)), Known::TroughDistance(mm(40.0)));
        assert!(matches!(twice, Error::PairUndetermined { .. }));
        let none = with(Known::TroughRadius(mm(1.0)), Known::CrestDistance(mm(500.0)));
        assert!(matches!(none, Error::NoArcs { .. }));
        let negative = with(Known::TroughRadius(mm(-1.0)), Known::CrestDistance(mm(15.0)));
        assert!(matches!(negative, Error::NotPositive { quantity: Quantity::TroughRadius, .. }));
        let wide = with(Known::TroughRadius(mm(1.0)), Known::CrestAngle(Angle::from_si(3.2)));
        assert!(matches!(wide, Error::OutOfRange { quantity: Quantity::CrestAngle, .. }));
        let infinite = with(Known::TroughRadius(mm(1.0)), Known::CrestAngle(Angle::from_si(f64::NAN)));
        assert!(matches!(infinite, Error::NotFinite { .. }));
        let known = [Known::TroughRadius(mm(1.0)), Known::CrestRadius(mm(15.0))];
        assert!(matches!(StatorArcs::with(numbers(), mm(0.0), known), Err(Error::NotPositive { .. })));
    }

    proptest! {
        #[test]
        fn any_two_parameters_give_the_others(
            lobes in 2..9_u32, per_lobe in 4..20_u32, gamma in 0.02..0.98, part in 0.05..0.95, module in 0.5..9.0,
        ) {
            let numbers = MotorNumbers::new(lobes, lobes - 1, lobes * per_lobe, 1).unwrap();
            // D between S/B (R₁ = 0) and S/Γ (R₂ = 0).
            let theta = PI / f64::from(lobes);
            let gamma = gamma * (PI - theta);
            let s = half_length(numbers);
            let d = s / (theta + gamma) + part * (s / gamma - s / (theta + gamma));
            let arcs = StatorArcs { arcs: Arcs::of_triangle(theta, s, d, gamma), module: mm(module) };
            prop_assert_eq!(arcs.arcs.first_not_positive(), None);
            let known = all_known(&arcs);
            for i in 0..6 {
                for j in (0..6).filter(|&j| j != i && i.min(j) != 4) {
                    let solutions = StatorArcs::with(numbers, mm(module), [known[i], known[j]]).unwrap();
                    let miss = |other: &StatorArcs| {
                        let scale = [d, d, d, d, 1.0, 1.0];
                        values(&arcs).iter().zip(values(other)).zip(scale)
                            .map(|((x, y), scale)| ((x - y) / scale).abs()).fold(0.0, f64::max)
                    };
                    let nearest = solutions.iter().map(miss).fold(f64::INFINITY, f64::min);
                    // Near the double root of a and R₁, and near Γ = 0 or R₂ = 0, the rest is
                    // ill-conditioned.
                    prop_assert!(nearest < 1e-5, "{i} {j}: {nearest:e}");
                    let most = if (i.min(j), i.max(j)) == (1, 2) { 2 } else { 1 };
                    prop_assert!(solutions.len() <= most);
                }
            }
        }

        #[test]
        fn angles_and_distances_give_the_same_triangle(
            lobes in 2..9_u32, per_lobe in 4..20_u32, gamma in 0.02..0.98, part in 0.05..0.95,
        ) {
            let theta = PI / f64::from(lobes);
            let gamma = gamma * (PI - theta);
            let s = half_length(MotorNumbers::new(lobes, lobes - 1, lobes * per_lobe, 1).unwrap());
            let d = s / (theta + gamma) + part * (s / gamma - s / (theta + gamma));
            let one = Arcs::of_triangle(theta, s, d, gamma);
            let other = Arcs::of_distances(theta, s, one.l, one.a);
            let of = |arcs: &Arcs| {
                let Arcs { l, a, r1, r2, gamma, beta, tan_gamma, tan_beta, least, .. } = *arcs;
                [l / d, a / d, r1 / d, r2 / d, gamma, beta, libm::atan(tan_gamma), libm::atan(tan_beta), least / d]
            };
            for (x, y) in of(&one).into_iter().zip(of(&other)) {
                prop_assert!((x - y).abs() < 1e-10, "{:?} {:?}", of(&one), of(&other));
            }
            // The named angles belong to the tangents.
            prop_assert!((libm::atan(one.tan_beta) - one.beta / 2.0).abs() < 1e-12);
            prop_assert!((libm::atan(one.tan_gamma) - one.gamma / 2.0).abs() < 1e-12);
            prop_assert!((one.least - (one.l - one.r1)).abs() < 1e-9 * d);
        }

        #[test]
        fn any_finite_pair_is_solved_or_refused(
            first in 0..6_usize, second in 0..6_usize, x in any::<f64>(), y in any::<f64>(), m in any::<f64>(),
        ) {
            let known = |which: usize, value: f64| match which {
                0 => Known::TroughDistance(mm(value)),
                1 => Known::CrestDistance(mm(value)),
                2 => Known::TroughRadius(mm(value)),
                3 => Known::CrestRadius(mm(value)),
                4 => Known::TroughAngle(Angle::from_si(value)),
                _ => Known::CrestAngle(Angle::from_si(value)),
            };
            for (x, y, m) in [(x, y, m), (x.abs(), y.abs(), 1.0), (x.abs() % 60.0, y.abs() % 60.0, 1.0)] {
                let solved = StatorArcs::with(numbers(), mm(m), [known(first, x), known(second, y)]);
                for arcs in solved.into_iter().flatten() {
                    prop_assert!(values(&arcs).iter().all(|value| value.is_finite() && *value > 0.0));
                }
            }
        }
    }
}

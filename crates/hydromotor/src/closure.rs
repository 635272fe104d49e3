//! Closure: a half-lobe of the rotor must span exactly `π/n`. Only then does the rotor meet itself.
//!
//! Nothing in system (1) guarantees it. With this condition one of the "two independent parameters" `l` and
//! `a` is free: [`Family`].
//!
//! # Derivation
//! The satellite touches the stator in `P` and the rotor in `P₁`, its instant centres against the two wheels.
//! By Kennedy's theorem `P` and `P₁` are on one line with the axis `O`. Let `ρ₃ = OP`, `ρ₁ = OP₁`, and `μ` be
//! the angle between that line and the normal at `P`. The chord is `ρ₃ − ρ₁ = 2r·cos μ`, and the product
//! `ρ₁·ρ₃` is the power of `O` with respect to the satellite's circle. The satellite turns about `P`, and its
//! centre moves along `(1 − κ₃·r)·ds₃`, with `κ₃` the curvature of the stator. Meanwhile the rotor turns
//! against the stator by:
//!
//! ```text
//! dΦ = 2·cos μ·(1 − κ₃·r)/ρ₁ · ds₃ = dθ₃ + dθ₁
//! ```
//!
//! On arc 1 `x` is the angle at `O₁` from the trough, on arc 2 the angle at `O₂` from the crest:
//!
//! ```text
//! ρ₁·ρ₃ = l² + R₁² + 2·r·R₁ − 2·l·(R₁ + r)·cos x = K₁ + M₁·cos x       ρ₃·cos μ = l·cos x − R₁
//! ρ₁·ρ₃ = a² + R₂² − 2·r·R₂ + 2·a·(R₂ − r)·cos x = K₂ + M₂·cos x       ρ₃·cos μ = R₂ + a·cos x
//! Φ₁(x) = −x + (l² − R₁²)·J(K₁, M₁, x)      Φ₂(x) = x + (R₂² − a²)·J(K₂, M₂, x)
//! J(K, M, x) = ∫₀ˣ dt/(K + M·cos t)
//! ```
//!
//! A half-lobe has `Φ₂(B) + Φ₁(Γ) = π/N + π/n`, and `B − Γ = π/N`, so that:
//!
//! ```text
//! (l² − R₁²)·J(K₁, M₁, Γ) + (R₂² − a²)·J(K₂, M₂, B) = π/n
//! ```
//!
//! In closed form `J = 2t/(K + M)·A((K − M)/(K + M)·t²)`, `t = tan(x/2)`, `A(z) = ∫₀¹ dt/(1 + z·t²)`. `A` is
//! the arc tangent `atan √z/√z` for `K > |M|`, the area tangent `atanh √−z/√−z` for `K < |M|`, and 1 between
//! them. Arc 2 has `K < |M|` for `0 < R₂ − a < 2r`. `K ± M` have factors, `(l − R₁)(l − R₁ − 2r)` and the
//! like; one of these cancels against the factor before `J`.
//!
//! The arcs of stator and rotor are equally long without further conditions: `s₁ − s₃ = 2·r·μ`, and `μ`
//! vanishes at crest and trough.
//!
//! # No root missed
//! At fixed `l` both radii are monotone in `a`: `∂R₁/∂a = (sin B − B·cos B)/θ₃ > 0` and
//! `∂R₂/∂a = −(sin B − Γ·cos B)/θ₃ < 0`, since `tan x > x`. Three conditions bound `a`: `R₁ > 0`, `R₂ > r`,
//! and a rotor trough outside the axis, `l − R₁ > 2r` (this too is falling). So the allowed `a` are *one*
//! interval. At its lower end the half-lobe is too short: for a circle, `a = 0`, by the condition on `Z_s`;
//! and where `R₁ = 0`, it is at or below the family's lower end. In the interval the residual rises with `a`,
//! so that it holds at most one root, which bisection brackets and Brent's method finds.
//!
//! That the residual rises is not proved in closed form. The tests evaluate the exact derivative on a dense
//! grid over `(l, a)` for every ratio of lobes up to `N = 10` and every size of satellite. The residual but
//! for the constant `π/n` depends on `N`, `Z_s/Z_3` and the distances alone. The tests also scan for roots
//! without use of the derivative.
//!
//! Along the family `R₁` and `a` grow with `l`, and the rotor's crest sharpens. The family starts where
//! `R₁ = 0`. It ends where the rotor gets a cusp, or at the greatest `l` of a machine ([`crate::machine`]),
//! where arc 1 is nearly straight. With few lobes and small satellites, such as 3×1, it has a gap: the
//! stator's flank would be more than radial, `cos μ < 0`, and the satellite would have to turn back. The
//! tests compare the intervals with a scan over every seventh admissible set.
//!
//! # Source
//! The source has no such condition: it draws the rotor and does not check that it closes.

use crate::quantity::{FamilyFault, Quantity};
use std::f64::consts::PI;

use epicyclic_units::Physical;
use uom::si::f64::{Angle, Length};

use crate::Error;
use crate::arcs::{Arcs, StatorArcs, half_length};
use crate::machine;
use crate::modules::length;
use crate::numbers::MotorNumbers;
use crate::ranges::{self, positive_modules};
use crate::real::{Dual, Real};
use crate::tolerance::{CLOSES, EDGE_ANGLE, WITHIN};
use epicyclic_numerics::extremes::{Sections, golden_while};
use epicyclic_numerics::quadrature::quadrature;
use epicyclic_numerics::roots::bracketed;

/// `(l² − R₁²)·J(K₁, M₁, x)` on arc 1, `t = tan(x/2)`.
pub(crate) fn trough_term<T: Real>(arcs: &Arcs<T>, r: f64, t: T) -> T {
    let two_r = T::of(2.0 * r);
    let (least, sum) = (arcs.least, arcs.l + arcs.r1);
    let z = sum * (sum + two_r) * t * t / (least * (least - two_r));
    T::of(2.0) * sum * t / (least - two_r) * z.arc()
}

/// `(R₂² − a²)·J(K₂, M₂, x)` on arc 2, `t = tan(x/2)`.
pub(crate) fn crest_term<T: Real>(arcs: &Arcs<T>, r: f64, t: T) -> T {
    let two_r = T::of(2.0 * r);
    let (sum, difference) = (arcs.a + arcs.r2, arcs.r2 - arcs.a);
    let z = difference * (difference - two_r) * t * t / (sum * (sum - two_r));
    T::of(2.0) * difference * t / (sum - two_r) * z.arc()
}

/// Angle that a half-lobe of the rotor spans, in radians.
pub(crate) fn rotor_span<T: Real>(arcs: &Arcs<T>, r: f64) -> T {
    trough_term(arcs, r, arcs.tan_gamma) + crest_term(arcs, r, arcs.tan_beta)
}

/// Angle that a half-lobe of the rotor spans, by quadrature of `dΦ − dθ₃` over both arcs.
pub(crate) fn rotor_span_by_quadrature(arcs: &Arcs, r: f64) -> f64 {
    let Arcs { l, a, r1, r2, gamma, beta, theta3, least, .. } = *arcs;
    let trough = quadrature(0.0, gamma, 64, |x| {
        let half_sine = libm::sin(x / 2.0);
        // l·cos x − R₁ and ρ₁·ρ₃, without the cancellation of a large l.
        let normal = least - 2.0 * l * half_sine * half_sine;
        let product = least * (least - 2.0 * r) + 4.0 * l * (r1 + r) * half_sine * half_sine;
        2.0 * normal * (r1 + r) / product
    });
    let crest = quadrature(0.0, beta, 64, |x| {
        let product = a * a + r2 * r2 - 2.0 * r2 * r + 2.0 * a * (r2 - r) * libm::cos(x);
        2.0 * (r2 + a * libm::cos(x)) * (r2 - r) / product
    });
    trough + crest - theta3
}

/// Margin of the rotor's crest against a cusp: the least `ds₁/ds₃` on arc 2; at 0 the rotor has a cusp.
///
/// `ds₁/ds₃ = 1 + 2r·(cos μ/ρ₃ − κ₃)` is monotone along arc 2, and above 1 on arc 1.
pub(crate) fn least_stretch(arcs: &Arcs, r: f64) -> f64 {
    let Arcs { a, r2, beta, .. } = *arcs;
    let stretch = |cos: f64| {
        let rho_squared = a * a + r2 * r2 + 2.0 * a * r2 * cos;
        1.0 + 2.0 * r * ((r2 + a * cos) / rho_squared - 1.0 / r2)
    };
    stretch(1.0).min(stretch(libm::cos(beta)))
}

/// `cos μ` where the arcs meet, its least, times the radius there over that of the satellite: above 0 while
/// both curves turn one way about the axis.
fn flank(arcs: &Arcs, r: f64) -> f64 {
    (arcs.r2 + arcs.a * libm::cos(arcs.beta)) / r
}

/// Above 0 where stator and rotor are smooth curves that turn one way about the axis.
fn margin(arcs: &Arcs, r: f64) -> f64 {
    least_stretch(arcs, r).min(flank(arcs, r))
}

/// The closure of any pair of arcs, and how it answers to the two distances.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Closure {
    /// Angle that the rotor's half-lobe spans beyond `π/n`, in radians; 0 for a motor.
    pub residual_rad: f64,
    /// Residual by quadrature of the rolling, for a check.
    pub residual_by_quadrature_rad: f64,
    /// `∂/∂a` of the residual at fixed `l`, in radians per module: the opening by an error in `a`.
    pub by_crest_distance: f64,
    /// `∂/∂l` of the residual at fixed `a`, in radians a module.
    pub by_trough_distance: f64,
    /// `da/dl` along the family: how `a` must follow `l`.
    pub slope: f64,
}

impl Closure {
    /// Angle by which a half-lobe stays open: the required span less the actual; negative if it overlaps the
    /// next.
    #[must_use]
    pub fn open(&self) -> Angle {
        Angle::from_si(-self.residual_rad)
    }

    /// Whether the rotor closes: a half-lobe is open by no more than five digits of `l` and `a` leave, 10⁻⁵
    /// rad.
    #[must_use]
    pub fn closes(&self) -> bool {
        self.residual_rad.abs() <= CLOSES
    }
}

/// Residual and sensitivity of the closure.
///
/// # Errors
/// [`Error::OutOfRange`] where the arcs leave the rotor no least radius, `l − R₁ ≤ 2r`.
///
/// # Example
/// ```
/// use epicyclic_hydromotor::arcs::{Known, StatorArcs};
/// use epicyclic_hydromotor::{MotorNumbers, closure};
/// use uom::si::{f64::Length, length::millimeter};
///
/// let mm = Length::new::<millimeter>;
/// let numbers = MotorNumbers::new(5, 3, 55, 10)?;
/// // A quarter of a millimetre off, and the rotor overlaps itself by a degree:
/// // 0.19° a half-lobe, of which it has six.
/// let known = [Known::TroughDistance(mm(40.0)), Known::CrestDistance(mm(15.55))];
/// let arcs = StatorArcs::with(numbers, mm(1.0), known)?;
/// let closure = closure::closure(numbers, &arcs[0])?;
/// assert!((closure.residual_rad.to_degrees() - 0.186).abs() < 0.001);
/// # Ok::<(), epicyclic_hydromotor::Error>(())
/// ```
pub fn closure(numbers: MotorNumbers, arcs: &StatorArcs) -> Result<Closure, Error> {
    let r = rolling_radius(numbers, arcs)?;
    let Arcs { theta3, half_length, l, a, .. } = arcs.arcs;
    let by_l = Dual { value: l, by_l: 1.0, by_a: 0.0 };
    let by_a = Dual { value: a, by_l: 0.0, by_a: 1.0 };
    let span = rotor_span(&Arcs::of_distances(theta3, half_length, by_l, by_a), r);
    let wanted = PI / f64::from(numbers.rotor_lobes());
    Ok(Closure {
        residual_rad: rotor_span(&arcs.arcs, r) - wanted,
        residual_by_quadrature_rad: rotor_span_by_quadrature(&arcs.arcs, r) - wanted,
        by_crest_distance: span.by_a,
        by_trough_distance: span.by_l,
        slope: -span.by_l / span.by_a,
    })
}

/// The satellite's radius in modules, where it can roll on both arcs and leaves the rotor a least radius.
///
/// # Errors
/// [`Error::OutOfRange`] unless `l − R₁ > 2r` and `R₂ > r`.
pub(crate) fn rolling_radius(numbers: MotorNumbers, arcs: &StatorArcs) -> Result<f64, Error> {
    let r = f64::from(numbers.satellite_teeth()) / 2.0;
    let Arcs { r2, least, .. } = arcs.arcs;
    let (quantity, value, low) = if least <= 2.0 * r {
        (Quantity::TroughDistanceLessRadius, least, 2.0 * r)
    } else if r2 <= r {
        (Quantity::CrestRadius, r2, r)
    } else {
        return Ok(r);
    };
    let [value, low] = [value, low].map(|modules| length(modules, arcs.module).mm());
    Err(Error::OutOfRange { quantity, value, low, high: f64::INFINITY, unit: "mm" })
}

/// Whether two arcs, closed or not, give stator and rotor smooth curves that turn one way about the axis:
/// the rotor without a cusp, the flank less than radial.
#[must_use]
pub fn is_smooth(numbers: MotorNumbers, arcs: &StatorArcs) -> bool {
    Kernel::of(numbers).is_regular(&arcs.arcs)
}

/// Limit that ends an interval of a family.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "FamilyLimit"))]
pub enum Limit {
    /// Arc 1 shrinks to a corner, `R₁ = 0`.
    NoTroughArc,
    /// The rotor's crest gets a cusp.
    RotorCusp,
    /// The flank of stator and rotor becomes radial where the arcs meet, `cos μ = 0`.
    RadialFlank,
    /// `l` reaches [`GREATEST_RADIUS`](crate::machine::GREATEST_RADIUS) times the stator's nominal radius:
    /// arc 1 is nearly straight.
    GreatestRadius,
}

/// An end of an interval, not a motor itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct End {
    /// Limit that ends the interval.
    pub limit: Limit,
    arcs: Option<StatorArcs>,
}

impl End {
    /// The arcs there; `None` if rounding leaves no root at a cusp.
    #[must_use]
    pub fn arcs(&self) -> Option<&StatorArcs> {
        self.arcs.as_ref()
    }

    /// `1/l` in modules.
    fn inverse(&self) -> f64 {
        self.arcs.map_or(0.0, |arcs| arcs.arcs.l.recip())
    }
}

/// An interval of `l` in which every motor closes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// The end with the smaller `l`.
    pub lower: End,
    /// The end with the greater `l`.
    pub upper: End,
}

/// Family of all motors of two arcs with given numbers and module: one for each `l` of one interval or two.
#[derive(Debug, Clone, PartialEq)]
pub struct Family {
    numbers: MotorNumbers,
    module: Length,
    intervals: Vec<Interval>,
}

impl Family {
    /// The whole family.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for the module, [`Error::NoFamily`] for numbers with which no pair of arcs
    /// closes.
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::MotorNumbers;
    /// use epicyclic_hydromotor::closure::Family;
    /// use uom::si::{f64::Length, length::millimeter};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let family = Family::new(MotorNumbers::new(5, 3, 55, 10)?, mm(1.0))?;
    /// let arcs = family.at(mm(40.0))?;
    /// assert!((arcs.crest_distance().get::<millimeter>() - 15.30631008).abs() < 5e-9);
    /// assert!(family.at(mm(20.0)).unwrap_err().to_string().contains("closes for l from 23.4"));
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn new(numbers: MotorNumbers, module: Length) -> Result<Self, Error> {
        let module = machine::module(module)?;
        let intervals = Kernel::of(numbers).intervals(module).map_err(|why| Error::NoFamily { why })?;
        Ok(Self { numbers, module, intervals })
    }

    /// The numbers.
    #[must_use]
    pub fn numbers(&self) -> MotorNumbers {
        self.numbers
    }

    /// The module.
    #[must_use]
    pub fn module(&self) -> Length {
        self.module
    }

    /// The intervals of `l`, by rising `l`: one, or two with a gap where the flank would be more than radial.
    #[must_use]
    pub fn intervals(&self) -> &[Interval] {
        &self.intervals
    }

    /// The motor's arcs at a distance `l`.
    ///
    /// # Errors
    /// [`Error::NotPositive`]; [`Error::OutsideFamily`] with the family's intervals.
    pub fn at(&self, trough_distance: Length) -> Result<StatorArcs, Error> {
        let l = positive_modules(Quantity::TroughDistance, trough_distance, self.module)?;
        let inside = |interval: &Interval| {
            let inverse = l.recip();
            inverse < interval.lower.inverse() && inverse > interval.upper.inverse()
        };
        let inside = self.intervals.iter().any(inside);
        match Kernel::of(self.numbers).solve(l).filter(|_| inside) {
            Some(arcs) => Ok(StatorArcs { arcs, module: self.module }),
            None => Err(self.outside(trough_distance)),
        }
    }

    /// The motor's arcs at a distance `a`, the other name of a motor: it grows with `l` along the family.
    ///
    /// # Errors
    /// [`Error::NotPositive`]; [`Error::OutsideFamilyByCrest`] with the family's intervals of `a`.
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::MotorNumbers;
    /// use epicyclic_hydromotor::closure::Family;
    /// use uom::si::{f64::Length, length::millimeter};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let family = Family::new(MotorNumbers::new(5, 3, 55, 10)?, mm(1.0))?;
    /// let arcs = family.at_crest_distance(mm(15.30631008))?;
    /// assert!((arcs.trough_distance().get::<millimeter>() - 40.0).abs() < 1e-6);
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn at_crest_distance(&self, crest_distance: Length) -> Result<StatorArcs, Error> {
        let a = positive_modules(Quantity::CrestDistance, crest_distance, self.module)?;
        let kernel = Kernel::of(self.numbers);
        let mut intervals_mm = Vec::new();
        for interval in &self.intervals {
            let ends = [&interval.lower, &interval.upper]
                .map(|end| end.arcs.map(|arcs| (arcs.arcs.l.recip(), arcs.arcs.a)));
            let [Some(lower), Some(upper)] = ends else { continue };
            if a > lower.1 && a < upper.1 {
                let off = |inverse: f64| kernel.solve(inverse.recip()).map_or(f64::NAN, |arcs| arcs.a - a);
                let at = |inverse: f64| match inverse {
                    end if end >= lower.0 => lower.1 - a,
                    end if end <= upper.0 => upper.1 - a,
                    inside => off(inside),
                };
                return self.at(length(bracketed(upper.0, lower.0, at).recip(), self.module));
            }
            let [low, high] = [lower.1, upper.1].map(|a| length(a, self.module).mm());
            intervals_mm.push((low, high));
        }
        Err(Error::OutsideFamilyByCrest { a_mm: crest_distance.mm(), intervals_mm })
    }

    /// The motor's arcs at a part `0 < t < 1` of the family, even in `1/l` over its intervals, from the least
    /// `l` on.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a part outside.
    pub fn at_part(&self, part: f64) -> Result<StatorArcs, Error> {
        let part = ranges::family_part(part)?;
        let width = |interval: &Interval| interval.lower.inverse() - interval.upper.inverse();
        let mut rest = part * self.intervals.iter().map(width).sum::<f64>();
        let mut inverse = f64::NAN;
        for interval in &self.intervals {
            inverse = (interval.lower.inverse() - rest).max(interval.upper.inverse());
            rest -= width(interval);
            if rest < 0.0 {
                break;
            }
        }
        self.at(length(inverse.recip(), self.module))
    }

    /// The arcs at a part of one of the intervals, even in `1/l`; `None` if rounding at its very end leaves
    /// no root.
    pub(crate) fn within(&self, interval: &Interval, part: f64) -> Option<StatorArcs> {
        let (from, to) = (interval.lower.inverse(), interval.upper.inverse());
        let inverse = from + (to - from) * part;
        let kernel = Kernel::of(self.numbers);
        let arcs = kernel.solve(inverse.recip()).filter(|arcs| kernel.is_regular(arcs))?;
        Some(StatorArcs { arcs, module: self.module })
    }

    fn outside(&self, trough_distance: Length) -> Error {
        let mm = |end: &End| end.arcs.map_or(f64::INFINITY, |arcs| arcs.trough_distance().mm());
        let intervals = self.intervals.iter().map(|interval| (mm(&interval.lower), mm(&interval.upper)));
        Error::OutsideFamily { l_mm: trough_distance.mm(), intervals_mm: intervals.collect() }
    }
}

/// The arcs that close at a distance `l`, without knowledge of the whole family: one bracketed root.
///
/// # Errors
/// As [`Family::new`] and [`Family::at`].
pub fn arcs_at(numbers: MotorNumbers, module: Length, trough_distance: Length) -> Result<StatorArcs, Error> {
    let module = machine::module(module)?;
    let l = positive_modules(Quantity::TroughDistance, trough_distance, module)?;
    let kernel = Kernel::of(numbers);
    match kernel.solve(l).filter(|arcs| l < kernel.greatest && kernel.is_regular(arcs)) {
        Some(arcs) => Ok(StatorArcs { arcs, module }),
        None => Err(Family::new(numbers, module)?.outside(trough_distance)),
    }
}

/// The numbers as the closure needs them.
#[derive(Debug, Clone, Copy)]
struct Kernel {
    theta3: f64,
    half_length: f64,
    r: f64,
    wanted: f64,
    /// The greatest `l`.
    greatest: f64,
}

impl Kernel {
    fn of(numbers: MotorNumbers) -> Self {
        Self {
            theta3: PI / f64::from(numbers.stator_lobes()),
            half_length: half_length(numbers),
            r: f64::from(numbers.satellite_teeth()) / 2.0,
            wanted: PI / f64::from(numbers.rotor_lobes()),
            greatest: machine::greatest_distance(numbers.stator_teeth()),
        }
    }

    fn arcs(&self, l: f64, a: f64) -> Arcs {
        Arcs::of_distances(self.theta3, self.half_length, l, a)
    }

    /// The residual where the arcs are ones; −∞ below the interval of `a`, +∞ above it.
    fn walled_residual(&self, l: f64, a: f64) -> f64 {
        let arcs = self.arcs(l, a);
        if arcs.r1 <= 0.0 {
            f64::NEG_INFINITY
        } else if arcs.r2 <= self.r || arcs.least <= 2.0 * self.r {
            f64::INFINITY
        } else {
            rotor_span(&arcs, self.r) - self.wanted
        }
    }

    /// The one root at `l`, if there is one.
    fn solve(&self, l: f64) -> Option<Arcs> {
        // At a = S/sin θ₃ arc 2 has no radius left: D·Γ ≥ D·sin Γ = a·sin θ₃.
        let (mut low, mut high) = (0.0, self.half_length / libm::sin(self.theta3));
        let (mut f_low, mut f_high) = (f64::NEG_INFINITY, f64::INFINITY);
        for _ in 0..80 {
            if f_low.is_finite() && f_high.is_finite() {
                break;
            }
            let middle = 0.5 * (low + high);
            let f = self.walled_residual(l, middle);
            if f < 0.0 {
                (low, f_low) = (middle, f);
            } else {
                (high, f_high) = (middle, f);
            }
        }
        if !(f_low.is_finite() && f_high.is_finite()) {
            return None;
        }
        let a = bracketed(low, high, |a| rotor_span(&self.arcs(l, a), self.r) - self.wanted);
        Some(self.arcs(l, a))
    }

    /// Whether stator and rotor are smooth curves that turn one way about the axis.
    fn is_regular(&self, arcs: &Arcs) -> bool {
        arcs.r2 > self.r && arcs.least > 2.0 * self.r && margin(arcs, self.r) > 0.0
    }

    /// The arcs with `R₁ = 0` and the angle `B`: `D = R₂ = S/B`.
    fn cornered(&self, beta: f64) -> Arcs {
        let d = self.half_length / beta;
        let sin = libm::sin(self.theta3);
        let (l, a) = (d * libm::sin(beta) / sin, d * libm::sin(beta - self.theta3) / sin);
        Arcs { r1: 0.0, r2: d, least: l, ..self.arcs(l, a) }
    }

    /// The arcs with `R₁ = 0` with which the rotor closes. The root is between the circle, `B = θ₃`, which
    /// lacks angle, and `l = 2r`, where the residual is without bound; `l` falls with `B`.
    fn lower_end(&self) -> Arcs {
        let beta = bracketed(self.theta3 * (1.0 + EDGE_ANGLE), PI, |beta| {
            let arcs = self.cornered(beta);
            if arcs.l <= 2.0 * self.r { f64::INFINITY } else { rotor_span(&arcs, self.r) - self.wanted }
        });
        self.cornered(beta)
    }

    /// Intervals in which both curves are smooth and turn one way about the axis, by rising `l`.
    ///
    /// The search runs over `1/l`: from `R₁ = 0` down to a cusp of the rotor's crest, or to the greatest `l`
    /// of a machine. The crest only sharpens on the way, so that one such place exists. `cos μ` where the
    /// arcs meet falls to a least value and rises again: golden section finds it, and if it is below 0, a
    /// root on either side bounds the gap.
    fn intervals(&self, module: Length) -> Result<Vec<Interval>, FamilyFault> {
        let corner = self.lower_end();
        if corner.r2 <= self.r {
            return Err(FamilyFault::CrestRadius);
        }
        if least_stretch(&corner, self.r) <= 0.0 {
            return Err(FamilyFault::RotorCusp);
        }
        let end =
            |limit, arcs: Option<Arcs>| End { limit, arcs: arcs.map(|arcs| StatorArcs { arcs, module }) };
        let of_arcs = |inverse: f64, property: fn(&Arcs, f64) -> f64| {
            self.solve(inverse.recip()).map_or(-1.0, |arcs| property(&arcs, self.r))
        };
        let stretch = |inverse: f64| of_arcs(inverse, least_stretch);
        let flank = |inverse: f64| of_arcs(inverse, flank);
        let (straight, start) = (self.greatest.recip(), corner.l.recip() * (1.0 - WITHIN));
        let (last, upper) = if stretch(straight) > 0.0 {
            (straight, end(Limit::GreatestRadius, self.solve(self.greatest)))
        } else {
            let cusp = bracketed(straight, start, stretch);
            (cusp, end(Limit::RotorCusp, self.solve(cusp.recip())))
        };
        let lower = end(Limit::NoTroughArc, Some(corner));
        let lowest = lowest(last, start, flank);
        if flank(lowest) > 0.0 {
            return Ok(vec![Interval { lower, upper }]);
        }
        let radial = |from: f64| {
            let place = bracketed(from, lowest, flank);
            end(Limit::RadialFlank, self.solve(place.recip()))
        };
        let mut intervals = Vec::new();
        if flank(start) > 0.0 {
            intervals.push(Interval { lower, upper: radial(start) });
        }
        // At the cusp itself rounding may leave no root; a hair before it there is one.
        let last = last + (start - last) * WITHIN;
        if flank(last) > 0.0 {
            intervals.push(Interval { lower: radial(last), upper });
        }
        if intervals.is_empty() { Err(FamilyFault::RadialFlank) } else { Ok(intervals) }
    }
}

/// Place at which a function that falls and then rises is least, or below 0, by golden section.
fn lowest(low: f64, high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let is_below_0 = |found: &Sections| found.inner.iter().any(|(_, value)| *value < 0.0);
    let found = golden_while([low, high], |made, found| made < 40 && !is_below_0(found), &f);
    let ends = found.ends.map(|end| (end, f(end)));
    ends.into_iter().fold(found.least(), |best, end| if end.1 < best.1 { end } else { best }).0
}

#[cfg(test)]
#[path = "closure_tests.rs"]
pub(crate) mod tests;

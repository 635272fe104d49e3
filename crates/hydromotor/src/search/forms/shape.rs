//! The motors of a search before their teeth: families at their places, reduced by the limits.

use crate::arcs::StatorArcs;
use crate::closure::Family;
use crate::contact::Conjugate;
use crate::cosine::{Cosine, Law};
use crate::motor::Motor;
use crate::numbers::MotorNumbers;
use crate::reason::Reason;
use crate::second_harmonic;
use crate::tolerance::EDGE;
use epicyclic_units::Physical;
use uom::si::f64::Length;

use super::super::point::{Working, Yardstick, at_least};

/// A family of motors.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum FamilyKind {
    /// The stator of two arcs, over `l` ([`crate::closure::Family`]).
    TwoArcs,
    /// The rotor by the cosine law: one motor at most ([`crate::cosine`]).
    CosineLaw,
    /// The rotor with a second harmonic, over `ε₂` ([`crate::second_harmonic`]).
    SecondHarmonic,
}

impl FamilyKind {
    /// Families in their order.
    pub const ALL: [Self; 3] = [Self::TwoArcs, Self::CosineLaw, Self::SecondHarmonic];
}

/// The curves of a motor of module 1 m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Curves {
    Arcs(StatorArcs),
    Law(Law),
}

/// A motor of the search, in modules.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Shape {
    pub(super) numbers: MotorNumbers,
    pub(super) family: FamilyKind,
    pub(super) curves: Curves,
    pub(super) working: Working,
    /// Least curvature radius of the centrodes.
    pub(super) radius: f64,
    pub(super) curvatures: [f64; 4],
}

impl Shape {
    /// The motor of module 1 m.
    pub(super) fn motor(&self) -> Motor {
        motor(self.numbers, &self.curves, Length::from_si(1.0))
    }
}

/// The motor of curves at a module.
pub(super) fn motor(numbers: MotorNumbers, curves: &Curves, module: uom::si::f64::Length) -> Motor {
    match curves {
        Curves::Arcs(arcs) => Motor::of_closed_arcs(numbers, StatorArcs { module, ..*arcs }),
        Curves::Law(law) => Motor::of_law(numbers, module, *law),
    }
}

/// The motors of a set of numbers: each with its shape, or why it is refused.
pub(super) fn shapes(
    yardstick: &Yardstick,
    numbers: MotorNumbers,
    families: &[FamilyKind],
    places: u32,
) -> Vec<Result<Shape, Reason>> {
    let mut found = Vec::new();
    for &family in families {
        let judged = |curves: Option<Curves>| {
            curves.ok_or(Reason::NotClosed).and_then(|curves| judge(yardstick, numbers, family, curves))
        };
        match family {
            FamilyKind::TwoArcs => {
                let Ok(arcs) = Family::new(numbers, Length::from_si(1.0)) else { continue };
                for interval in arcs.intervals() {
                    found.extend((0..places).map(|i| {
                        let part = (f64::from(i) / f64::from(places - 1)).clamp(EDGE, 1.0 - EDGE);
                        judged(arcs.within(interval, part).map(Curves::Arcs))
                    }));
                }
            }
            FamilyKind::CosineLaw => {
                found.extend(Cosine::new(numbers).map(|lobe| judged(Some(Curves::Law(*lobe.law())))));
            }
            FamilyKind::SecondHarmonic => {
                let laws = second_harmonic::laws(numbers, places, EDGE);
                found.extend(laws.into_iter().map(|law| judged(Some(Curves::Law(law)))));
            }
        }
    }
    found
}

fn judge(
    yardstick: &Yardstick,
    numbers: MotorNumbers,
    family: FamilyKind,
    curves: Curves,
) -> Result<Shape, Reason> {
    let motor = motor(numbers, &curves, Length::from_si(1.0));
    let [rotor, stator] = motor.facing_radii();
    // Neither is a number where nothing closes.
    if rotor >= stator {
        return Err(Reason::RotorInStator);
    }
    if motor.extremes()[0] <= 0.0 {
        return Err(Reason::NoChamber);
    }
    let curvatures = motor.shape.curvature_extremes();
    let radius = curvatures.iter().fold(0.0_f64, |most, &curvature| most.max(curvature)).recip();
    if at_least(radius, yardstick.least_radius) < 0.0 {
        return Err(Reason::LeastRadius);
    }
    let working = Working::of(&motor);
    if yardstick.sizing.margin(working.displacement, working.diameter) < 0.0 {
        return Err(Reason::Size);
    }
    if at_least(yardstick.ripple, working.ripple()) < 0.0 {
        return Err(Reason::Ripple);
    }
    let sound = [libm::log(working.by_volume()), libm::log(working.ripple()), libm::log(radius)];
    if sound.iter().any(|value| !value.is_finite()) {
        return Err(Reason::NotClosed);
    }
    Ok(Shape { numbers, family, curves, working, radius, curvatures })
}

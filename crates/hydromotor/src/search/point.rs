//! One motor of the search: its objectives, and the check or limit that refuses it.

use crate::arcs::StatorArcs;
use crate::checks::{Subject, ToothHeights};
use crate::closure::{Family, Interval};
use crate::contact::Conjugate;
use crate::motor::Motor;
use crate::numbers::MotorNumbers;
use crate::ports::{IDEAL_PART, PortPlate};
use crate::profile::ToothForm;
use crate::profile::kept::{Room, SatelliteForm, contact_ratio};
use crate::reason::Reason;

use super::front::Value;
use super::objective::{AtFlanks, FlankTerms, Objective};
use super::requirements::{Sizing, mean_flow};

/// Measures by which a point is judged.
#[derive(Debug, Clone)]
pub(super) struct Yardstick {
    pub(super) heights: ToothHeights,
    pub(super) sizing: Sizing,
    pub(super) ripple: f64,
    pub(super) least_radius: f64,
    pub(super) objectives: Vec<Objective>,
    /// Inputs for the flanks, if an objective or a bound needs them of every motor.
    pub(super) flanks: Option<FlankTerms>,
    /// The teeth that every motor of the front must have, if required.
    pub(super) made: Option<ToothForm>,
}

/// A motor at a place of its family, in units of the module.
#[derive(Debug, Clone)]
pub(super) struct Point {
    /// Part of the interval, even in `1/l`.
    pub(super) part: f64,
    pub(super) arcs: Option<StatorArcs>,
    /// The least curvature radius, and the curve that has it.
    pub(super) radius: f64,
    pub(super) radius_of: Subject,
    /// The check nearest its limit, among those evaluated, and its relative margin.
    pub(super) nearest: (Subject, f64),
    /// Least relative margin of checks and limits; for a refused point an upper bound of it.
    pub(super) margin: f64,
    /// Reason of the refusal.
    pub(super) refused: Option<Reason>,
    /// Working data, for an accepted point and if they are needed.
    pub(super) working: Option<Working>,
    /// Working data at the flanks, if every motor is evaluated for them; `None` for one without teeth.
    pub(super) at_flanks: Option<AtFlanks>,
    /// Whether it was asked if it can be made.
    pub(super) judged: bool,
}

/// Working data of a motor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Working {
    /// `q̂`, displacement over width and `m²`.
    pub(super) displacement: f64,
    /// Outer diameter over the module.
    pub(super) diameter: f64,
    /// Least and greatest flow a radian over width.
    pub(super) flow: [f64; 2],
}

impl Working {
    pub(super) fn of(motor: &Motor) -> Self {
        let (least, greatest) = motor.flow_extremes();
        let diameter = 2.0 * motor.shape.centre_within(0.0)[0] + 2.0 * motor.shape.satellite_radius();
        Self { displacement: motor.displacement_kernel(), diameter, flow: [least, greatest] }
    }

    /// Displacement over the volume of the enclosing cylinder.
    pub(super) fn by_volume(&self) -> f64 {
        self.displacement / (std::f64::consts::FRAC_PI_4 * self.diameter * self.diameter)
    }

    pub(super) fn ripple(&self) -> f64 {
        (self.flow[1] - self.flow[0]) / mean_flow(self.displacement)
    }
}

impl Point {
    /// The motor at a part of an interval.
    pub(super) fn at(yardstick: &Yardstick, family: &Family, interval: &Interval, part: f64) -> Self {
        let mut point = Self {
            part,
            arcs: family.within(interval, part),
            radius: 0.0,
            radius_of: Subject::StatorBulge,
            nearest: (Subject::StatorBulge, f64::INFINITY),
            margin: f64::INFINITY,
            refused: None,
            working: None,
            at_flanks: None,
            judged: false,
        };
        match point.motor(family.numbers()) {
            Some(motor) => point.judge(yardstick, &motor),
            None => (point.margin, point.refused) = (-1.0, Some(Reason::NotClosed)),
        }
        point
    }

    /// The motor of module 1 m.
    fn motor(&self, numbers: MotorNumbers) -> Option<Motor> {
        self.arcs.map(|arcs| Motor::of_closed_arcs(numbers, arcs))
    }

    /// Judges the motor, the cheap checks first; the working data of a refused motor are left out.
    fn judge(&mut self, yardstick: &Yardstick, motor: &Motor) {
        let r = motor.shape.satellite_radius();
        let ToothHeights { addendum, dedendum } = yardstick.heights;
        let radii = motor.shape.curvature_extremes().map(f64::recip);
        let subjects =
            [Subject::StatorBulge, Subject::StatorHollow, Subject::RotorBulge, Subject::RotorHollow];
        self.radius = f64::INFINITY;
        for ((subject, radius), limit) in subjects.into_iter().zip(radii).zip([dedendum, r, dedendum, r]) {
            // A curve that is nowhere bent that way has no such radius.
            if radius.is_finite() {
                self.check(subject, radius, limit);
                if radius < self.radius {
                    (self.radius, self.radius_of) = (radius, subject);
                }
            }
        }
        self.check(Subject::RotorLeastRadius, motor.shape.trough().rho1, dedendum);
        if self.refused.is_some() {
            return;
        }
        // Most that are too near are so about a crest.
        let limit = 2.0 * (r + addendum);
        let about_crest = motor.neighbour_distance(-0.5 * motor.chamber_phase());
        let least = if about_crest > limit { motor.least_neighbour_kernel().0 } else { about_crest };
        self.check(Subject::Neighbours, least, limit);
        let [rotor, stator] = motor.facing_radii();
        self.exceed(Reason::RotorInStator, stator / rotor - 1.0);
        let [chamber, greatest] = motor.extremes();
        self.exceed(Reason::NoChamber, chamber / greatest);
        self.limit(Reason::LeastRadius, at_least(self.radius, yardstick.least_radius));
        if self.refused.is_some() {
            return;
        }
        let working = Working::of(motor);
        self.limit(Reason::Size, yardstick.sizing.margin(working.displacement, working.diameter));
        self.limit(Reason::Ripple, at_least(yardstick.ripple, working.ripple()));
        self.working = Some(working);
        if self.value(&Objective::USUAL).is_none() {
            (self.margin, self.refused) = (-1.0, Some(Reason::NotClosed));
        }
        if let Some(terms) = &yardstick.flanks
            && self.refused.is_none()
        {
            self.at_flanks = AtFlanks::of(motor, terms.form);
            self.judge_flanks(terms, yardstick.objectives.contains(&Objective::LeastTorque));
        }
    }

    /// Judges the flanks, the most expensive limits last. A torque that vanishes at some angle is refused if
    /// the least torque is evaluated.
    fn judge_flanks(&mut self, terms: &FlankTerms, is_by_torque: bool) {
        let Some(at) = self.at_flanks else {
            (self.margin, self.refused) = (-1.0, Some(Reason::NoTeeth));
            return;
        };
        self.limit(Reason::FlankRipple, at_least(terms.ripple.unwrap_or(f64::INFINITY), at.ripple));
        if is_by_torque || terms.least_torque.is_some() {
            let margin = at_least(at.least_over_mean, terms.least_torque.unwrap_or(0.0));
            self.limit(Reason::LeastTorque, if at.least_over_mean > 0.0 { margin } else { -1.0 });
        }
    }

    /// A quantity that must exceed its limit.
    fn check(&mut self, subject: Subject, value: f64, limit: f64) {
        let margin = value / limit - 1.0;
        if margin < self.nearest.1 {
            self.nearest = (subject, margin);
        }
        self.margin = self.margin.min(margin);
        let holds = value > limit;
        if !holds {
            self.refused = self.refused.or(Some(subject.into()));
        }
    }

    /// Whether the motor has teeth of a form that keep every limit, and ideal ports can be made for it; else
    /// the first failure.
    pub(super) fn made(&self, form: ToothForm, numbers: MotorNumbers) -> Result<(), Reason> {
        let motor = self.motor(numbers).ok_or(Reason::NoTeeth)?;
        let formed = SatelliteForm::new(form, numbers.satellite_teeth())?;
        let room = Room::of(&motor, motor.shape.curvature_extremes());
        contact_ratio(&motor, &room, &formed, |_| true)?;
        ported(&motor)
    }

    /// Takes the answer to [`made`](Self::made).
    pub(super) fn judge_made(&mut self, verdict: Result<(), Reason>) {
        self.judged = true;
        if let Err(reason) = verdict {
            (self.margin, self.refused) = (-1.0, Some(reason));
        }
    }

    /// A quantity that must be above 0.
    fn exceed(&mut self, reason: Reason, margin: f64) {
        self.margin = self.margin.min(margin);
        let holds = margin > 0.0;
        if !holds {
            self.refused = self.refused.or(Some(reason));
        }
    }

    /// A limit that may be reached.
    fn limit(&mut self, reason: Reason, margin: f64) {
        self.margin = self.margin.min(margin);
        let holds = margin >= 0.0;
        if !holds {
            self.refused = self.refused.or(Some(reason));
        }
    }

    /// Whether the motor is refused because it has no teeth of the form, or cannot be made with them. What is
    /// asked whether it can be made has kept all other limits.
    fn cannot_be_made(&self) -> bool {
        self.refused == Some(Reason::NoTeeth) || self.judged && self.refused.is_some()
    }

    /// Computes the working data of a motor, whether or not it is refused.
    pub(super) fn work(&mut self, yardstick: &Yardstick, numbers: MotorNumbers) {
        if self.working.is_some()
            && (self.at_flanks.is_some() || yardstick.flanks.is_none() || self.accepted())
        {
            return;
        }
        let Some(motor) = self.motor(numbers) else { return };
        self.working.get_or_insert_with(|| Working::of(&motor));
        if let Some(terms) = &yardstick.flanks
            && !self.cannot_be_made()
        {
            self.at_flanks = self.at_flanks.or_else(|| AtFlanks::of(&motor, terms.form));
        }
    }

    /// Logarithms of the objectives, each the greater the better; `None` for a point without working data.
    pub(super) fn value(&self, objectives: &[Objective]) -> Option<Value> {
        let working = self.working?;
        let mut value = Value::default();
        for &objective in objectives {
            value[objective as usize] = match objective {
                Objective::DisplacementByVolume => libm::log(working.by_volume()),
                Objective::Ripple => -libm::log(working.ripple()),
                Objective::LeastRadius => libm::log(self.radius),
                Objective::FlankRipple => -libm::log(self.at_flanks?.ripple),
                Objective::LeastTorque => libm::log(self.at_flanks?.least_over_mean),
            };
        }
        value.iter().all(|part| part.is_finite()).then_some(value)
    }

    pub(super) fn accepted(&self) -> bool {
        self.refused.is_none()
    }
}

/// Whether ideal ports can be made for a motor.
pub(super) fn ported(motor: &Motor) -> Result<(), Reason> {
    // A satellite covers an ideal hole where it changes over, so that it opens and closes; the tests check
    // every timing.
    PortPlate::of_ideal_holes(motor, IDEAL_PART).map(|_| ()).map_err(|_| Reason::Ports)
}

/// Margin of a value above a limit, relative to the limit.
pub(super) fn at_least(value: f64, limit: f64) -> f64 {
    if limit > 0.0 { value / limit - 1.0 } else { f64::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::at_least;

    #[test]
    fn a_limit_of_nothing_is_kept_by_anything() {
        assert_eq!([0.0, 1.0].map(|value| at_least(value, 0.0)), [f64::INFINITY; 2]);
        assert_eq!([1.0, 2.0, 3.0].map(|value| at_least(value, 2.0)), [-0.5, 0.0, 0.5]);
    }
}

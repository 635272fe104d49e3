//! Result of a search with free tooth forms.

use epicyclic_numerics::threads::map;
use uom::si::f64::Length;

use super::super::dimensions::Dimensions;
use super::super::point::Yardstick;
use super::FormSearch;
use super::counts::Counts;
use super::cover::Value;
use super::loaded::FlankFigures;
use super::shape::{Curves, FamilyKind, Shape, motor};
use super::trial::Point;
use crate::Error;
use crate::machine;
use crate::motor::Motor;
use crate::numbers::MotorNumbers;
use crate::profile::{Profile, ToothForm};
use crate::reason::{Reason, Refusals};

/// The answer of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct FormFound {
    /// The front, by falling displacement by volume.
    pub designs: Vec<FormDesign>,
    /// Counts of the points by their results.
    pub funnel: FormFunnel,
}

/// A design of the front: a shape and a tooth form, and the sizes in which they serve.
#[derive(Debug, Clone, PartialEq)]
pub struct FormDesign {
    /// Lobes and teeth.
    pub numbers: MotorNumbers,
    /// The family of the motor.
    pub family: FamilyKind,
    /// The tooth form.
    pub form: ToothForm,
    /// Displacement over the volume of the cylinder about the stator's centrode.
    pub displacement_by_volume: f64,
    /// Ripple `δ` of flow and torque, satellites sealing at the pitch points.
    pub ripple: f64,
    /// Least curvature radius of the centrodes over the module.
    pub least_radius: f64,
    /// Shortest path of contact of any flank over the base pitch.
    pub contact_ratio: f64,
    /// Figures of the flanks under load, if requested; `None` if the flanks cannot hold a satellite.
    pub flanks: Option<FlankFigures>,
    /// The sizes that keep the limits, at least one, in the order of the modules given.
    pub sizes: Vec<Dimensions>,
    curves: Curves,
}

impl FormDesign {
    /// `l` over the module, of a motor of two arcs.
    #[must_use]
    pub fn trough_distance_over_module(&self) -> Option<f64> {
        match &self.curves {
            Curves::Arcs(arcs) => Some(arcs.arcs.l),
            Curves::Law(_) => None,
        }
    }

    /// `ε₂`, of a motor by the cosine law, where it is 0, or with a second harmonic.
    #[must_use]
    pub fn second_amplitude(&self) -> Option<f64> {
        match &self.curves {
            Curves::Arcs(_) => None,
            Curves::Law(law) => Some(law.second),
        }
    }

    /// The motor at a module.
    ///
    /// # Errors
    /// [`Error::NotPositive`].
    pub fn motor(&self, module: Length) -> Result<Motor, Error> {
        let module = machine::module(module)?;
        Ok(motor(self.numbers, &self.curves, module))
    }

    /// The teeth at a module.
    ///
    /// # Errors
    /// [`Error::NotPositive`].
    pub fn profile(&self, module: Length) -> Result<Profile, Error> {
        Profile::new(&self.motor(module)?, self.form)
    }
}

/// Counts of motors and points by their results.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct FormFunnel {
    /// Sets of numbers within the bounds that fulfil the conditions on them.
    pub sets: usize,
    /// Sets outside the limits of rotor lobes, rotor teeth or the common divisor.
    pub outside_limits: usize,
    /// Sets within these limits with which no motor of the families closes.
    pub without_motors: usize,
    /// Motors at the places of their families.
    pub motors: usize,
    /// Tooth forms within the steps.
    pub forms: usize,
    /// Points left out because a design is as good as they can be, or their contact ratio is below the least.
    pub as_good: u64,
    /// Points tried to the end that are admissible.
    pub admissible: u64,
    shapes_refused: Refusals,
    refused: Refusals,
}

impl FormFunnel {
    /// The size of the space: motors times forms. Points of refused motors, refused points, those left out
    /// and the admissible ones add up to it.
    #[must_use]
    pub fn points(&self) -> u64 {
        self.motors as u64 * self.forms as u64
    }

    /// Motors refused for a reason, whatever their form, each counted once.
    #[must_use]
    pub fn motors_refused(&self, reason: Reason) -> u64 {
        self.shapes_refused.of(reason)
    }

    /// Points refused for a reason, each counted once, by the first failure found.
    #[must_use]
    pub fn refused(&self, reason: Reason) -> u64 {
        self.refused.of(reason)
    }

    pub(super) fn refuse_shape(&mut self, reason: Reason) {
        self.shapes_refused.count(reason);
    }

    pub(super) fn add(&mut self, counts: &Counts) {
        self.as_good += counts.as_good;
        self.admissible += counts.admissible;
        self.refused.add(&counts.refused);
    }
}

impl FormSearch {
    pub(super) fn found(
        &self,
        yardstick: &Yardstick,
        funnel: FormFunnel,
        shapes: &[Shape],
        forms: &[ToothForm],
        found: &[(usize, Point)],
    ) -> FormFound {
        // A design found later may be better than one found before.
        let costs: Vec<Value> = found.iter().map(|(_, point)| point.value.map(|part| -part)).collect();
        let mut places = epicyclic_numerics::front::non_dominated(&costs);
        let by_volume = |place: u32| shapes[found[place as usize].0].working.by_volume();
        places.sort_by(|&one, &other| by_volume(other).total_cmp(&by_volume(one)).then(one.cmp(&other)));
        let design = |place: &u32| {
            let (shape, point) = &found[*place as usize];
            self.design(yardstick, &shapes[*shape], forms[point.form], point)
        };
        FormFound { designs: map(&places, design), funnel }
    }

    fn design(&self, yardstick: &Yardstick, shape: &Shape, form: ToothForm, point: &Point) -> FormDesign {
        let working = &shape.working;
        let sizes = yardstick.sizing.sizes(working.displacement, working.diameter);
        FormDesign {
            numbers: shape.numbers,
            family: shape.family,
            form,
            displacement_by_volume: working.by_volume(),
            ripple: working.ripple(),
            least_radius: shape.radius,
            contact_ratio: point.contact_ratio,
            flanks: point.figures.or_else(|| self.figures(shape, form)?.ok()),
            sizes: sizes.into_iter().map(|size| Dimensions::of(&self.requirements, working, size)).collect(),
            curves: shape.curves,
        }
    }
}

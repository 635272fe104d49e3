//! Search for designs with the tooth form free, for a displacement, or a torque at a pressure. The search
//! covers every set of numbers, the families of motors of each set at their places, and on each motor every
//! tooth form within the steps.
//!
//! # The space
//! A *point* is a motor and a form:
//!
//! 1. every set `(N, n, Z_3, Z_s)` within the [`Bounds`] and the limits on numbers;
//! 2. of each the families wanted ([`FamilyKind`]). A family of two arcs has a number of places `l` in each
//!    interval, even in `1/l`. The family of the second harmonic has as many `ε₂`, even in `4·ε₂/ε₁` from end
//!    to end of their range. In both the first and the last place are a millionth within the ends, which are
//!    no motors. The cosine law has one motor;
//! 3. every [`ToothForm`](crate::profile::ToothForm) of the [`FormSpace`].
//!
//! A point is *admissible* if the motor keeps the [`Limits`], the form gives teeth
//! ([`crate::profile::Profile::new`]) that keep every limit ([`crate::profile::Profile::limits`]), and the
//! centrodes keep the [checks](crate::checks) with the form's heights: the satellite's addendum `h_a* + x`
//! and the cutter's `h_a* + c* + x`.
//!
//! # What is left out, and why nothing is lost
//! A point is not tried in three cases. Its motor is refused. A limit fails that the form fails on every
//! motor with such satellites. Or a design found before is *as good*: in no objective is the point's best
//! possible value better than the design's by more than the [`resolution`](FormSearch::resolution).
//!
//! The best possible value is the motor's own if an objective does not depend on the form, and a bound if it
//! does. The contact ratio cannot exceed that of the satellite's whole involute, nor that of the flanks
//! evaluated so far. The pressure of Hertz is no less than that at crests and troughs with contacts at the
//! pitch points. Other figures of the flanks have no bound: with them as objectives every admissible point is
//! tried. [`FormFunnel`] counts all, and its parts add up to the space. So:
//!
//! - *without a resolution* the designs are the Pareto front of all admissible points, with one of the points
//!   that are equal in every objective;
//! - *with a resolution* every admissible point, tried or not, is in no objective better than some design by
//!   more than the resolution. The designs themselves are a front.
//!
//! The tests compare both with a trial of every point. `l`, `ε₂` and the form are taken at their places and
//! steps. Motors between them are neither tried nor estimated: [`crate::search`] makes an estimate for motors
//! of two arcs.
//!
//! # Cost and threads
//! The default space takes some 15 s of one core (`hydromotor/forms/all`); objectives of flanks take several
//! milliseconds a point. The designs do not depend on the number of threads: motors are tried in batches in
//! an order of their own, and a batch sees the designs of those before.
//!
//! # Example
//! ```
//! use epicyclic_hydromotor::numbers::Bounds;
//! use epicyclic_hydromotor::search::Requirements;
//! use epicyclic_hydromotor::search::forms::FormSearch;
//! use uom::si::f64::{Pressure, Torque};
//! use uom::si::{length::millimeter, pressure::megapascal, torque::newton_meter};
//!
//! # fn main() -> Result<(), epicyclic_hydromotor::Error> {
//! let torque = Torque::new::<newton_meter>(900.0);
//! let requirements = Requirements::of_torque(torque, Pressure::new::<megapascal>(20.0))?;
//! let mut search = FormSearch::new(requirements);
//! search.bounds = Bounds { stator_lobes: 6..=6, stator_teeth: 66..=66, satellite_teeth: 10..=10 };
//! let found = search.front()?;
//! let best = &found.designs[0]; // the most displacement by volume
//! let profile = best.profile(best.sizes[0].module)?;
//! assert!(profile.limits().iter().all(|limit| limit.holds()));
//! # Ok(())
//! # }
//! ```

mod counts;
mod cover;
mod found;
mod loaded;
mod shape;
mod space;
mod trial;

use std::ops::ControlFlow;

use super::point::Yardstick;
use super::requirements::{Requirements, Sizing};
use super::{Limits, MOST_POINTS, MOST_SETS, Pass, Watch};
use crate::Error;
use crate::checks::ToothHeights;
use crate::numbers::{Bounds, MotorNumbers};
use crate::quantity::{Choice, Quantity};
use crate::ranges::positive;
use cover::{Cover, Value};
use shape::shapes;
use trial::{Forms, Tried, tried};

pub use found::{FormDesign, FormFound, FormFunnel};
pub use loaded::{FlankFigures, FlankOrder};
pub use shape::FamilyKind;
pub use space::{FormSpace, MOST_FORMS, Steps};

/// Objective of a design.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Objective {
    /// The most displacement over the volume of the cylinder about the stator's centrode.
    DisplacementByVolume,
    /// The least ripple of flow and torque, satellites sealing at the pitch points.
    Ripple,
    /// The greatest least curvature radius of the centrodes over the module.
    LeastRadius,
    /// The greatest contact ratio: the shortest path of contact of any flank over the base pitch.
    ContactRatio,
    /// The least ripple, satellites sealing at the flanks.
    FlankRipple,
    /// The greatest least torque over the mean, satellites sealing at the flanks.
    LeastTorque,
    /// The least pressure of Hertz, at one pressure drop.
    ContactStress,
    /// The least bending stress at the roots, at one pressure drop.
    RootStress,
    /// The greatest pressure drop that the materials allow.
    AllowedPressure,
}

impl Objective {
    /// Objectives in their order.
    pub const ALL: [Self; 9] = [
        Self::DisplacementByVolume,
        Self::Ripple,
        Self::LeastRadius,
        Self::ContactRatio,
        Self::FlankRipple,
        Self::LeastTorque,
        Self::ContactStress,
        Self::RootStress,
        Self::AllowedPressure,
    ];

    /// Whether it needs the figures of the flanks under load, [`FormSearch::flanks`].
    #[must_use]
    pub const fn is_of_flanks(self) -> bool {
        matches!(
            self,
            Self::FlankRipple
                | Self::LeastTorque
                | Self::ContactStress
                | Self::RootStress
                | Self::AllowedPressure
        )
    }
}

/// A search for designs with the tooth form free.
#[derive(Debug, Clone, PartialEq)]
pub struct FormSearch {
    /// Required displacement or torque, and size.
    pub requirements: Requirements,
    /// Numbers of lobes and teeth.
    pub bounds: Bounds,
    /// Limits of a design.
    pub limits: Limits,
    /// Families of motors, all three by default.
    pub families: Vec<FamilyKind>,
    /// Places in each interval of a family, 16 by default.
    pub places: u32,
    /// Tooth forms.
    pub forms: FormSpace,
    /// Least contact ratio; 1 and below ask no more than the limits do.
    pub least_contact_ratio: f64,
    /// Inputs for the flanks under load, and their limits; without these inputs designs have no figures of
    /// the flanks.
    pub flanks: Option<FlankOrder>,
    /// Objectives by which designs are compared: by default all but [`Objective::LeastRadius`].
    pub objectives: Vec<Objective>,
    /// Relative difference of the objectives up to which designs are as good, 2 % by default. With none the
    /// front is exact.
    pub resolution: Option<f64>,
}

/// Motors that are tried without knowledge of each other.
const BATCH: usize = 256;

impl FormSearch {
    /// Search with default bounds, limits, families and forms, 16 places and a resolution of 2 %.
    #[must_use]
    pub fn new(requirements: Requirements) -> Self {
        Self {
            requirements,
            bounds: Bounds::default(),
            limits: Limits::default(),
            families: FamilyKind::ALL.to_vec(),
            places: 16,
            forms: FormSpace::default(),
            least_contact_ratio: 1.0,
            flanks: None,
            objectives: vec![Objective::DisplacementByVolume, Objective::Ripple, Objective::ContactRatio],
            resolution: Some(0.02),
        }
    }

    /// Finds the front. The result may hold no design: the [`FormFunnel`] then shows what refused them.
    ///
    /// # Errors
    /// - [`Error::NotPositive`], [`Error::NotFinite`], [`Error::OutOfRange`] for a quantity of requirements,
    ///   limits, forms or search;
    /// - [`Error::NoModules`];
    /// - [`Error::EmptyLimits`], [`Error::EmptyRange`], [`Error::EmptySteps`] for ranges the wrong way round;
    /// - [`Error::NothingToChoose`] without families, crests or objectives;
    /// - [`Error::NoFlankOrder`] and [`Error::NoPressureDrop`] for objectives and limits of flanks without
    ///   their inputs;
    /// - [`Error::TooManyTeeth`], [`Error::TooManySets`] and [`Error::TooManyForms`].
    pub fn front(&self) -> Result<FormFound, Error> {
        self.front_watched(&|_| ControlFlow::Continue(()))
    }

    /// Finds the front under a watch: pass 0 finds the motors of each set, pass 1 tries forms on them.
    ///
    /// # Errors
    /// Errors of [`front`](Self::front), and [`Error::Cancelled`].
    pub fn front_watched(&self, watch: &Watch) -> Result<FormFound, Error> {
        let yardstick = self.yardstick()?;
        let all_forms = self.forms.forms()?;
        let sets = self.bounds.count()?;
        if sets > MOST_SETS {
            return Err(Error::TooManySets { sets, most: MOST_SETS });
        }
        let mut numbers = self.bounds.all()?;
        let mut funnel = FormFunnel::default();
        (funnel.sets, funnel.forms) = (numbers.len(), all_forms.len());
        numbers.retain(|&numbers| self.limits.allow(numbers));
        funnel.outside_limits = funnel.sets - numbers.len();

        let pass = Pass::new(0, numbers.len(), watch)?;
        let per_set =
            pass.each(&numbers, |&set: &MotorNumbers| shapes(&yardstick, set, &self.families, self.places))?;
        let mut found = Vec::new();
        for judged in per_set {
            funnel.without_motors += usize::from(judged.is_empty());
            funnel.motors += judged.len();
            for shape in judged {
                match shape {
                    Ok(shape) => found.push(shape),
                    Err(reason) => funnel.refuse_shape(reason),
                }
            }
        }
        let forms = Forms::new(&all_forms, found.iter().map(|shape| shape.numbers.satellite_teeth()));
        let values: Vec<Value> = found.iter().map(|shape| self.values_of_shape(shape)).collect();
        let order = promising(&values);

        let slack = self.resolution.map_or(0.0, libm::log1p);
        let pass = Pass::new(1, order.len(), watch)?;
        let (mut cover, mut designs) = (Cover::default(), Vec::new());
        for batch in order.chunks(BATCH) {
            let results = pass.each(batch, |&k: &usize| {
                tried(self, &found[k], values[k], (&all_forms, &forms), &cover, slack)
            })?;
            for (&k, Tried { counts, admissible }) in batch.iter().zip(results) {
                funnel.add(&counts);
                for point in admissible {
                    if !cover.is_as_good(&point.value, slack) {
                        cover.add(point.value);
                        designs.push((k, point));
                    }
                }
            }
        }
        Ok(self.found(&yardstick, funnel, &found, &all_forms, &designs))
    }

    fn yardstick(&self) -> Result<Yardstick, Error> {
        self.limits.checked()?;
        if self.families.is_empty() {
            return Err(Error::NothingToChoose { what: Choice::Families });
        }
        if self.objectives.is_empty() {
            return Err(Error::NothingToChoose { what: Choice::Objectives });
        }
        let out_of = |quantity, value, low, high| Error::OutOfRange { quantity, value, low, high, unit: "" };
        if !(3..=MOST_POINTS).contains(&self.places) {
            let places = f64::from(self.places);
            return Err(out_of(Quantity::FamilyPoints, places, 3.0, f64::from(MOST_POINTS)));
        }
        if let Some(resolution) = self.resolution
            && !(0.001..=1.0).contains(&resolution)
        {
            return Err(out_of(Quantity::Resolution, resolution, 0.001, 1.0));
        }
        if !(0.0..=10.0).contains(&self.least_contact_ratio) {
            return Err(out_of(Quantity::ContactRatio, self.least_contact_ratio, 0.0, 10.0));
        }
        let sizing = Sizing::new(&self.requirements, &self.limits.size)?;
        match &self.flanks {
            Some(order) => order.checked(self.requirements.pressure_drop)?,
            None if self.objectives.iter().any(|objective| objective.is_of_flanks()) => {
                return Err(Error::NoFlankOrder);
            }
            None => {}
        }
        let ripple =
            self.limits.ripple.map_or(Ok(f64::INFINITY), |ripple| positive(Quantity::Ripple, ripple, ""))?;
        let least_radius = self.limits.least_radius.unwrap_or(0.0);
        // The heights of the teeth are those of the forms.
        let heights = ToothHeights::default();
        Ok(Yardstick {
            heights,
            sizing,
            ripple,
            least_radius,
            objectives: Vec::new(),
            flanks: None,
            made: None,
        })
    }

    /// The objectives that depend on the motor alone; those that are not asked for, or depend on the form,
    /// are 0.
    fn values_of_shape(&self, shape: &shape::Shape) -> Value {
        let mut value = Value::default();
        for &objective in &self.objectives {
            value[objective as usize] = match objective {
                Objective::DisplacementByVolume => libm::log(shape.working.by_volume()),
                Objective::Ripple => -libm::log(shape.working.ripple()),
                Objective::LeastRadius => libm::log(shape.radius),
                _ => 0.0,
            };
        }
        value
    }

    /// The objectives of a motor in a form of a contact ratio.
    fn value(&self, of_shape: Value, contact_ratio: f64) -> Value {
        let mut value = of_shape;
        if self.objectives.contains(&Objective::ContactRatio) {
            value[Objective::ContactRatio as usize] = libm::log(contact_ratio);
        }
        value
    }
}

/// Places of values, those first that are good in all objectives together: the sum of their shares from least
/// to greatest.
fn promising(values: &[Value]) -> Vec<usize> {
    let ends = |pick: fn(f64, f64) -> f64, start: f64| -> Value {
        std::array::from_fn(|i| values.iter().map(|value| value[i]).fold(start, pick))
    };
    let (least, greatest) = (ends(f64::min, f64::INFINITY), ends(f64::max, f64::NEG_INFINITY));
    let share = |value: &Value| -> f64 {
        (0..value.len())
            .filter(|&i| greatest[i] > least[i])
            .map(|i| (value[i] - least[i]) / (greatest[i] - least[i]))
            .sum()
    };
    let shares: Vec<f64> = values.iter().map(share).collect();
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|&one, &other| shares[other].total_cmp(&shares[one]).then(one.cmp(&other)));
    order
}

#[cfg(test)]
mod tests;

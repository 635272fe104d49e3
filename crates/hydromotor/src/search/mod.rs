//! Search for designs for a displacement or torque. It tries every admissible set of numbers, along each set
//! its family, and returns the Pareto front of all these motors.
//!
//! # Objectives
//!
//! Objectives, with the better direction:
//! - Displacement by volume `q/V`, more: `V` is the cylinder about the stator's centrode,
//!   [`Envelope`](crate::checks::Envelope). With `V` = area · width it depends on neither module nor width,
//!   and `V = q/(q/V)` is the volume of the motor.
//! - Ripple `δ`, less: of flow and torque, satellites sealing at the pitch points,
//!   [`Ripple`](crate::flow::Ripple).
//! - Least curvature radius over the module, more: of both centrodes, hollow and convex. It is compared with
//!   roots and satellites, whose measure is the module, [`Check`](crate::checks::Check).
//!
//! These three are [usual](Objective::USUAL). Ripple and least torque over the mean with satellites that seal
//! at the flanks ([`AtFlanks`]) can be [objectives](MotorSearch::objectives) in addition or in their place;
//! they depend on a tooth form ([`FlankTerms`]). Every motor that passes the checks is then evaluated with
//! its teeth, which takes about twelve times as long.
//!
//! No objective depends on module or width, so that the shape is found first and every size that serves it is
//! listed with it ([`Dimensions`]). Limits of the size do distinguish shapes.
//!
//! # What is tried
//! 1. Every set `(N, n, Z_3, Z_s)` within the [`Bounds`], by default 3061.
//! 2. Of each the whole [`Family`]: 16 places `l` of each of its intervals (nearly always one), even in
//!    `1/l`, the first and the last a millionth within the ends, which are no motors.
//! 3. Each motor against all [checks](crate::checks) and the [`Limits`]. [`Funnel`] counts the motors refused
//!    by the first that fails.
//! 4. *Refinement.* The 15 *cells* between neighbouring places are halved if something better than the front
//!    may be in them: see below.
//!
//! # The error of the spacing
//! Sets are exhausted; `l` is continuous. For each cell the search estimates how good a motor in it can be.
//! In each objective the estimate is the better of its ends, and beyond that the amount by which the lines
//! through the neighbours on either side miss the ends. For a concave quantity, kinked or not, this is a
//! bound; for a smooth one it is eight times the rise above the chord, to second order. It is an *estimate*:
//! it misses a spike within a cell that shows at neither end nor neighbour. It also misses a window of
//! admissible motors so narrow that the margin at its neighbours does not point to it.
//!
//! A cell is left in two cases: its estimate exceeds some motor of the front by at most half the
//! [resolution](MotorSearch::resolution) in every objective, or by the same estimate no motor in it is
//! admissible. Others are halved, up to ten times. Then of motors of one set that differ by less than the
//! other half in every objective one stays; the best of the set in each objective do.
//!
//! # Which motors can be made
//! A motor whose rotor reaches into the stator, or whose least chamber has no area, is refused. Unless
//! [`MotorSearch::made`] is false, every motor of the front keeps every limit of the teeth of the form
//! ([`crate::profile::limits`]), and ideal ports can be made for it
//! ([`crate::ports::PortPlate::of_ideal_holes`]). Only motors on the front are tested for this, before and
//! after every refinement. One that fails is refused, and those that it surpassed come to the front and are
//! tested in turn, until all that are left pass. So the front is that of all motors that can be made, though
//! most others are never tested; [`Funnel::accepted`] counts these too.
//!
//! Bounds of figures at the flanks act as that of the ripple at the pitch points: a motor beyond them is
//! refused, last of all. Its distance beyond shows which cells may have motors within them. A motor to which
//! the form gives no teeth is refused if such a figure is bounded or an objective. The estimate of a cell
//! with such an end is that of the line through the other end and its neighbour.
//!
//! The remaining error is stated. The estimate of each cell is assigned to the motor that it exceeds least,
//! and [`Design::spacing_error`] is the largest assigned to a motor. *By estimate, every admissible motor
//! within the bounds, tried or not, is better than some listed one by at most the latter's spacing error in
//! each objective*, relative. [`Found::spacing_error`] is the greatest of all. The tests compare it with 256
//! places. [`Found::refinement_gain`] is no estimate: it is the amount by which the front has motors better
//! than any at the evenly spaced places.
//!
//! # Cost and threads
//! With the default bounds some 6·10⁴ motors take three to eight seconds of one core (`hydromotor/search`);
//! the judgement of teeth and ports is some three quarters of it. Results do not depend on the number of
//! threads: each set is evaluated independently, and rounds of refinement see the same front. With the
//! feature `parallel`, on by default, run it within a `rayon::ThreadPool` of your own to choose the number of
//! threads; without the feature it uses one.
//!
//! # Example
//! ```
//! use epicyclic_hydromotor::numbers::Bounds;
//! use epicyclic_hydromotor::search::{Requirements, MotorSearch};
//! use uom::si::f64::{Pressure, Torque};
//! use uom::si::{pressure::megapascal, torque::newton_meter};
//!
//! # fn main() -> Result<(), epicyclic_hydromotor::Error> {
//! let torque = Torque::new::<newton_meter>(900.0);
//! let requirements = Requirements::of_torque(torque, Pressure::new::<megapascal>(20.0))?;
//! let mut search = MotorSearch::new(requirements);
//! search.bounds = Bounds { stator_lobes: 5..=6, stator_teeth: 50..=66, satellite_teeth: 8..=60 };
//! search.limits.ripple = Some(0.1);
//! let found = search.front()?;
//! let most = &found.designs[0]; // the most displacement by volume
//! assert!(most.displacement_by_volume > 0.5 && most.ripple <= 0.1 && !most.dimensions.is_empty());
//! # Ok(())
//! # }
//! ```

mod branch;
mod dimensions;
pub mod forms;
mod found;
mod front;
mod objective;
mod point;
mod requirements;

use crate::quantity::{Choice, Quantity};
use epicyclic_numerics::threads::{map, map_mut};
use epicyclic_units::Physical;
use std::ops::{ControlFlow, RangeInclusive};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use uom::si::f64::Length;

use crate::Error;
use crate::checks::{ToothHeights, finite_heights};
use crate::closure::Family;
use crate::numbers::{Bounds, MotorNumbers};
use crate::ranges::positive;
use branch::Branch;
use front::{Cover, Value, apart, front};
use point::Yardstick;
use requirements::Sizing;

pub use crate::reason::Reason;
pub use dimensions::Dimensions;
pub use found::{Design, Found, Funnel, SpacingError};
pub use objective::{AtFlanks, FlankTerms, Objective};
pub use requirements::{PREFERRED_MODULES_MM, Requirements, Size, SizeLimits};

/// The greatest number of sets that a search takes.
pub const MOST_SETS: u64 = 100_000;

/// The greatest number of places in an interval.
pub const MOST_POINTS: u32 = 1024;

/// A search for designs.
#[derive(Debug, Clone, PartialEq)]
pub struct MotorSearch {
    /// Required displacement or torque, and size.
    pub requirements: Requirements,
    /// Numbers of lobes and teeth.
    pub bounds: Bounds,
    /// Heights of the teeth, for the checks.
    pub heights: ToothHeights,
    /// Limits of a design.
    pub limits: Limits,
    /// The teeth for figures at the flanks, and the limits of these.
    pub flanks: FlankTerms,
    /// Whether motors alone are listed that can be made: on which the teeth of the [form](FlankTerms::form)
    /// keep every limit, and for which ideal ports can be made. True by default.
    pub made: bool,
    /// Objectives by which motors are compared, [`Objective::USUAL`] by default.
    pub objectives: Vec<Objective>,
    /// Evenly spaced places in each interval of a family, 16 by default.
    pub points: u32,
    /// Relative difference of the objectives below which designs of one set count as one, and up to which the
    /// front is refined; by default 2 %. With none the evenly spaced places are all, and every motor of the
    /// front is listed.
    pub resolution: Option<f64>,
}

/// Limits of a design.
#[derive(Debug, Clone, PartialEq)]
pub struct Limits {
    /// Limits of the size.
    pub size: SizeLimits,
    /// Greatest ripple.
    pub ripple: Option<f64>,
    /// Least curvature radius over the module, in addition to the checks.
    pub least_radius: Option<f64>,
    /// Lobes of the rotor, `n`.
    pub rotor_lobes: RangeInclusive<u32>,
    /// Teeth of the rotor, `Z_1`.
    pub rotor_teeth: RangeInclusive<u32>,
    /// Common divisor of `N` and `n`.
    pub divisor: LobeDivisor,
}

impl Default for Limits {
    /// Limits of [`SizeLimits`] alone.
    fn default() -> Self {
        Self {
            size: SizeLimits::default(),
            ripple: None,
            least_radius: None,
            rotor_lobes: 1..=u32::MAX,
            rotor_teeth: 1..=u32::MAX,
            divisor: LobeDivisor::Any,
        }
    }
}

/// Condition on the greatest common divisor of `N` and `n`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LobeDivisor {
    /// Nothing.
    #[default]
    Any,
    /// The divisor is 1: every chamber is in another state, the ripple is small.
    One,
    /// The divisor is above 1: the pressures repeat around the axis and load no bearing of the central
    /// wheels.
    Common,
}

impl Limits {
    /// Checks that ranges are the right way round, and that a least radius is a number; sizes and ripple are
    /// checked with the requirements.
    fn checked(&self) -> Result<(), Error> {
        if let Some(least_radius) = self.least_radius
            && !(least_radius.is_finite() && least_radius >= 0.0)
        {
            return Err(Error::OutOfRange {
                quantity: Quantity::LeastRadius,
                value: least_radius,
                low: 0.0,
                high: f64::INFINITY,
                unit: "modules",
            });
        }
        for (what, range) in
            [(Quantity::RotorLobes, &self.rotor_lobes), (Quantity::RotorTeeth, &self.rotor_teeth)]
        {
            let (from, to) = (*range.start(), *range.end());
            if from > to {
                return Err(Error::EmptyRange { what, from, to });
            }
        }
        Ok(())
    }

    pub(super) fn allow(&self, numbers: MotorNumbers) -> bool {
        let divisor = match self.divisor {
            LobeDivisor::Any => true,
            LobeDivisor::One => numbers.common_divisor() == 1,
            LobeDivisor::Common => numbers.common_divisor() > 1,
        };
        divisor
            && self.rotor_lobes.contains(&numbers.rotor_lobes())
            && self.rotor_teeth.contains(&numbers.rotor_teeth())
    }
}

/// Place of a motor in the search.
#[derive(Debug, Clone, Copy)]
struct Place {
    branch: usize,
    point: usize,
}

/// Progress of a search.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// The pass: 0 tries the evenly spaced places, those after it refine the front until nothing is added; of
    /// forms 1 is the last.
    pub pass: u32,
    /// Sets of lobes and teeth, after pass 0 intervals of families or motors, that are done in this pass.
    pub done: usize,
    /// Number of all of these.
    pub of: usize,
}

/// Called from any thread, at the begin of a pass and whenever a part of it is done; [`ControlFlow::Break`]
/// cancels.
pub type Watch<'a> = dyn Fn(Progress) -> ControlFlow<()> + Sync + 'a;

impl MotorSearch {
    /// Search with default bounds, tooth heights and limits, 16 places and a resolution of 2 %.
    #[must_use]
    pub fn new(requirements: Requirements) -> Self {
        Self {
            requirements,
            bounds: Bounds::default(),
            heights: ToothHeights::default(),
            limits: Limits::default(),
            flanks: FlankTerms::default(),
            made: true,
            objectives: Objective::USUAL.to_vec(),
            points: 16,
            resolution: Some(0.02),
        }
    }

    /// Finds the Pareto front. The result may hold no design: the [`Funnel`] then shows what refused them.
    ///
    /// # Errors
    /// - [`Error::NotPositive`], [`Error::NotFinite`], [`Error::OutOfRange`] for a quantity of requirements,
    ///   limits, heights or search;
    /// - [`Error::NoModules`];
    /// - [`Error::EmptyLimits`], [`Error::EmptyRange`] for bounds the wrong way round;
    /// - [`Error::TooManyTeeth`], and [`Error::TooManySets`] above [`MOST_SETS`].
    pub fn front(&self) -> Result<Found, Error> {
        self.front_watched(&|_| ControlFlow::Continue(()))
    }

    /// Finds the Pareto front under a watch.
    ///
    /// # Errors
    /// Errors of [`front`](Self::front), and [`Error::Cancelled`].
    pub fn front_watched(&self, watch: &Watch) -> Result<Found, Error> {
        let yardstick = self.yardstick()?;
        let sets = self.bounds.count()?;
        if sets > MOST_SETS {
            return Err(Error::TooManySets { sets, most: MOST_SETS });
        }
        let mut funnel = Funnel::default();
        let mut numbers = self.bounds.all()?;
        funnel.sets = numbers.len();
        numbers.retain(|&numbers| self.limits.allow(numbers));
        funnel.outside_limits = funnel.sets - numbers.len();
        let pass = Pass::new(0, numbers.len(), watch)?;
        let per_set = pass.each(&numbers, |&numbers| branches(&yardstick, numbers, self.points))?;
        funnel.without_family = per_set.iter().filter(|branches| branches.is_empty()).count();
        let mut branches: Vec<Branch> = per_set.into_iter().flatten().collect();
        funnel.points = branches.iter().map(|branch| branch.points.len()).sum();

        let mut values = judged_front(&yardstick, &mut branches);
        let grid = Cover::new(values.clone());
        // Half of the resolution, as logarithms.
        let half = self.resolution.map(|resolution| 0.5 * libm::log1p(resolution));
        if let Some(slack) = half {
            for number in 1.. {
                let cover = Cover::new(values);
                let pass = Pass::new(number, branches.len(), watch)?;
                let refined =
                    map_mut(&mut branches, |branch| pass.part(|| branch.refine(&yardstick, &cover, slack)));
                let added: usize = pass.all(refined)?.into_iter().sum();
                values = judged_front(&yardstick, &mut branches);
                if added == 0 {
                    break;
                }
                funnel.refined += added;
            }
        }
        let gain = most(values.iter().filter_map(|&value| grid.nearest(value)).map(|(_, excess)| excess));
        Ok(self.found(&yardstick, funnel, branches, gain, half))
    }

    fn yardstick(&self) -> Result<Yardstick, Error> {
        let out_of =
            |quantity, value, low, high, unit| Error::OutOfRange { quantity, value, low, high, unit };
        finite_heights(self.heights)?;
        let sizing = Sizing::new(&self.requirements, &self.limits.size)?;
        let ripple =
            self.limits.ripple.map_or(Ok(f64::INFINITY), |ripple| positive(Quantity::Ripple, ripple, ""))?;
        let least_radius = self.limits.least_radius.unwrap_or(0.0);
        self.limits.checked()?;
        if !(3..=MOST_POINTS).contains(&self.points) {
            let points = f64::from(self.points);
            return Err(out_of(Quantity::FamilyPoints, points, 3.0, f64::from(MOST_POINTS), ""));
        }
        if let Some(resolution) = self.resolution
            && !(0.001..=1.0).contains(&resolution)
        {
            return Err(out_of(Quantity::Resolution, resolution, 0.001, 1.0, ""));
        }
        if self.objectives.is_empty() {
            return Err(Error::NothingToChoose { what: Choice::Objectives });
        }
        self.flanks.checked()?;
        let flanks = self.flanks.are_needed(&self.objectives).then_some(self.flanks);
        let objectives = self.objectives.clone();
        let made = self.made.then_some(self.flanks.form);
        Ok(Yardstick { heights: self.heights, sizing, ripple, least_radius, objectives, flanks, made })
    }

    fn found(
        &self,
        yardstick: &Yardstick,
        mut funnel: Funnel,
        mut branches: Vec<Branch>,
        refinement_gain: SpacingError,
        half: Option<f64>,
    ) -> Found {
        let (places, values) = accepted(&branches, &self.objectives);
        let on_front = front(&values);
        funnel.accepted = places.len();
        funnel.front = on_front.len();
        for point in branches.iter().flat_map(|branch| &branch.points) {
            funnel.refuse(point.refused);
        }
        let mut members = match half {
            None => on_front,
            Some(half) => {
                let numbers = |k: &usize| branches[places[*k].branch].family.numbers();
                let sets = on_front.chunk_by(|one, other| numbers(one) == numbers(other));
                let thinned = |set: &[usize]| -> Vec<usize> {
                    let values: Vec<Value> = set.iter().map(|&k| values[k]).collect();
                    apart(&values, half).into_iter().map(|i| set[i]).collect()
                };
                sets.flat_map(thinned).collect()
            }
        };
        let by_volume = |k: usize| {
            let Place { branch, point } = places[k];
            branches[branch].points[point].working.map_or(0.0, |working| working.by_volume())
        };
        members.sort_by(|&one, &other| by_volume(other).total_cmp(&by_volume(one)));
        let cover = Cover::new(members.iter().map(|&k| values[k]).collect());
        let (spacing_error, each) = spacing_errors(yardstick, &mut branches, &cover);
        let members: Vec<(usize, SpacingError)> = members.into_iter().zip(each).collect();
        let designs = map(&members, |&(k, error)| {
            let Place { branch, point } = places[k];
            let numbers = branches[branch].family.numbers();
            self.design(&yardstick.sizing, numbers, &branches[branch].points[point], error)
        });
        let designs = designs.into_iter().flatten().collect();
        Found { designs, funnel, spacing_error, refinement_gain }
    }
}

/// A pass that counts its parts, and ends where it is cancelled.
struct Pass<'a> {
    pass: u32,
    done: AtomicUsize,
    of: usize,
    cancelled: AtomicBool,
    watch: &'a Watch<'a>,
}

impl<'a> Pass<'a> {
    fn new(pass: u32, of: usize, watch: &'a Watch) -> Result<Self, Error> {
        if watch(Progress { pass, done: 0, of }).is_break() {
            return Err(Error::Cancelled);
        }
        Ok(Self { pass, done: AtomicUsize::new(0), of, cancelled: AtomicBool::new(false), watch })
    }

    /// The answer to each item, unless the watch breaks.
    fn each<T: Sync, R: Send>(
        &self,
        items: &[T],
        work: impl Fn(&T) -> R + Sync + Send,
    ) -> Result<Vec<R>, Error> {
        self.all(map(items, |item| self.part(|| work(item))))
    }

    /// A part; nothing once the watch breaks.
    fn part<T>(&self, work: impl FnOnce() -> T) -> Option<T> {
        if self.cancelled.load(Ordering::Relaxed) {
            return None;
        }
        let result = work();
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        if (self.watch)(Progress { pass: self.pass, done, of: self.of }).is_break() {
            self.cancelled.store(true, Ordering::Relaxed);
        }
        Some(result)
    }

    /// Returns all parts, unless the watch broke.
    fn all<T>(&self, parts: Vec<Option<T>>) -> Result<Vec<T>, Error> {
        if self.cancelled.load(Ordering::Relaxed) {
            return Err(Error::Cancelled);
        }
        Ok(parts.into_iter().flatten().collect())
    }
}

/// The intervals of a family; none without one.
fn branches(yardstick: &Yardstick, numbers: MotorNumbers, points: u32) -> Vec<Branch> {
    let Ok(family) = Family::new(numbers, Length::from_si(1.0)) else { return Vec::new() };
    let branch = |&interval| Branch::new(yardstick, family.clone(), interval, points);
    family.intervals().iter().map(branch).collect()
}

/// Accepted points by their sets and `l`, and their values.
fn accepted(branches: &[Branch], objectives: &[Objective]) -> (Vec<Place>, Vec<Value>) {
    let mut places = Vec::new();
    let mut values = Vec::new();
    for (branch, of) in branches.iter().enumerate() {
        for (point, of) in of.points.iter().enumerate() {
            if let Some(value) = of.value(objectives).filter(|_| of.accepted()) {
                places.push(Place { branch, point });
                values.push(value);
            }
        }
    }
    (places, values)
}

/// Values of the front of all accepted points. Its motors are tested whether they can be made, until all that
/// are left can: those that others surpass need not be tested.
fn judged_front(yardstick: &Yardstick, branches: &mut [Branch]) -> Vec<Value> {
    loop {
        let (places, values) = accepted(branches, &yardstick.objectives);
        let on_front = front(&values);
        let open: Vec<Place> = on_front
            .iter()
            .map(|&k| places[k])
            .filter(|place| !branches[place.branch].points[place.point].judged)
            .collect();
        let Some(form) = yardstick.made.filter(|_| !open.is_empty()) else {
            return on_front.into_iter().map(|k| values[k]).collect();
        };
        let verdicts = map(&open, |place: &Place| {
            let branch = &branches[place.branch];
            branch.points[place.point].made(form, branch.family.numbers())
        });
        for (place, verdict) in open.iter().zip(verdicts) {
            branches[place.branch].points[place.point].judge_made(verdict);
        }
    }
}

/// The greatest spacing error, and those of each member: the excess of the cells' estimates over the nearest
/// member.
fn spacing_errors(
    yardstick: &Yardstick,
    branches: &mut [Branch],
    cover: &Cover,
) -> (SpacingError, Vec<SpacingError>) {
    let laid: Vec<Vec<(usize, Value)>> = map_mut(branches, |branch| {
        branch.prospects(yardstick).into_iter().filter_map(|best| cover.nearest(best)).collect()
    });
    let mut each = vec![Value::default(); cover.len()];
    for &(member, excess) in laid.iter().flatten() {
        each[member] = greater(each[member], excess);
    }
    (most(each.iter().copied()), each.into_iter().map(SpacingError::of).collect())
}

/// The most in each objective.
fn most(excesses: impl Iterator<Item = Value>) -> SpacingError {
    SpacingError::of(excesses.fold(Value::default(), greater))
}

fn greater(one: Value, other: Value) -> Value {
    std::array::from_fn(|i| one[i].max(other[i]))
}

#[cfg(test)]
mod tests;

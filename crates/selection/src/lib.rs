//! Choice of a gearbox for given speeds, by the criteria of section 3.1 and the method of 3.2.
//!
//! | module | answers |
//! |---|---|
//! | [`requirements`] | what is wanted: ratios, tolerance, limits |
//! | [`mechanism`] | what is chosen among, and which `k` give the ratios wanted |
//! | [`candidate`] | a mechanism measured and judged, criterion by criterion |
//! | [`objectives`] | the five objectives, and the order that picks the best |
//! | [`drawing`] | whether it can be drawn without self-crossing, and with which direct-drive clutch |
//! | [`size`] | how large a set is for its load |
//! | [`front`] | which designs nothing dominates |
//! | [`search`] | the same over all tooth numbers of one set or of both: exact front, nothing missed |
//!
//! Ring-to-sun ratios follow from the ratios, one pair from one pair:
//! [`structures`](epicyclic_schemes::structures). If they lie outside the allowed range, the point of the
//! range nearest to the ratios is taken, and the tolerance decides whether it is near enough. [`search`] then
//! covers teeth.
//!
//! ```
//! use epicyclic_schemes::RatioSeries;
//! use epicyclic_selection::{Requirements, Space, select};
//! use uom::si::{f64::Velocity, velocity::meter_per_second};
//! # fn main() -> Result<(), epicyclic_selection::Error> {
//! // The conveyor of section 3.3: scheme I wins over III.
//! let speeds = [0.8, 3.15].map(Velocity::new::<meter_per_second>);
//! let found = select(&Requirements::new(RatioSeries::of_speeds(&speeds, 1)?), &Space::Catalogue)?;
//! let best = &found.accepted[found.best[0]];
//! assert_eq!(best.mechanism.scheme().map(|scheme| scheme.name()), Some("I"));
//! assert!((best.k[0] - 2.9375).abs() < 1e-12);
//! # Ok(())
//! # }
//! ```
//!
//! # Source
//! multispeed-gearboxes, sections 3.1 to 3.3.

pub mod candidate;
pub mod drawing;
mod error;
pub mod every;
pub mod front;
pub mod mechanism;
mod objective;
pub mod objectives;
pub mod quantity;
pub mod requirements;
pub mod search;
pub mod size;
mod tolerance;

pub use candidate::{Candidate, Criterion, Engagement, Evidence, GearReport, Verdict};
pub use drawing::NotDrawable;
pub use error::Error;
pub use mechanism::{Mechanism, Space};
pub use objectives::{Objective, Objectives, Order};
pub use requirements::{Limits, Orders, Requirements, Signs};
pub use size::Rating;

use epicyclic_schemes::structures::Role;
use front::Entry;

/// Drawable direct-drive clutches of a mechanism, as pairs of links. If there are none, or the mechanism
/// itself cannot be drawn without self-crossing, the reason. See [`drawing::drawable_direct_clutches`].
pub type Drawing<'a> = dyn Fn(Mechanism) -> Result<Vec<[Role; 2]>, NotDrawable> + Sync + 'a;

/// A mechanism that has no ring-to-sun ratios for the ratios, so that there is nothing to judge.
#[derive(Debug, Clone, PartialEq)]
pub struct Unreachable {
    /// The mechanism.
    pub mechanism: Mechanism,
    /// Target ratios of its gears.
    pub wanted: Vec<f64>,
    /// Ring-to-sun ratios that the ratios would need, where they need finite ones.
    pub needed: Option<Vec<f64>>,
    /// Reason why these are out of reach.
    pub obstacle: Obstacle,
}

/// Reason why ring-to-sun ratios are out of reach.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Obstacle {
    /// A set would need an infinite `k`.
    Infinite,
    /// Sets, by their places from 0, that would need `k ≤ 1`; `k` of a simple set is above 1.
    TooSmall(Vec<usize>),
}

/// Result of a selection.
#[derive(Debug, Clone, PartialEq)]
pub struct Selection {
    /// Candidates that meet every required criterion, in the order of the mechanisms.
    pub accepted: Vec<Candidate>,
    /// Candidates that do not; their verdicts say why.
    pub rejected: Vec<Candidate>,
    /// Mechanisms that cannot give the ratios.
    pub unreachable: Vec<Unreachable>,
    /// The Pareto front over the accepted, best first by the order; members are places in `accepted`.
    /// Candidates whose output reverses against direct drive follow the others and are compared among
    /// themselves.
    pub front: Vec<Entry>,
    /// Places in `accepted`, best first by the order; candidates whose output reverses against direct drive
    /// follow the others.
    pub best: Vec<usize>,
}

/// Selects with the default order of objectives, drawing examined.
///
/// # Errors
/// As [`select_with`].
pub fn select(requirements: &Requirements, space: &Space) -> Result<Selection, Error> {
    select_with(requirements, space, Order::default(), Some(&drawing::drawable_direct_clutches))
}

/// Every mechanism of a space for every assignment of the ratios: measured, judged, compared.
///
/// # Errors
/// Those [`Error`]s that speak of tolerance, limits and rating.
pub fn select_with(
    requirements: &Requirements,
    space: &Space,
    order: Order,
    drawing: Option<&Drawing>,
) -> Result<Selection, Error> {
    requirements.check()?;
    let targets = requirements.targets();
    let mut found =
        Selection { accepted: vec![], rejected: vec![], unreachable: vec![], front: vec![], best: vec![] };
    for mechanism in space.mechanisms(requirements.series.braked().len()) {
        for (place, wanted) in targets.iter().enumerate() {
            // For a symmetric structure the other order is the same design.
            let mirrored: Vec<f64> = wanted.iter().rev().copied().collect();
            if mechanism.is_symmetric() && targets[..place].contains(&mirrored) {
                continue;
            }
            let range = &requirements.limits.ring_to_sun;
            let ends = [*range.start(), *range.end()];
            let reaches = mechanism.reaches(wanted, requirements.tolerance, ends);
            let nearest = if reaches { mechanism.nearest(wanted, range) } else { None };
            let in_tolerance = |k: &Vec<f64>| {
                mechanism::largest_error(&mechanism.ratios(k), wanted) <= requirements.tolerance
            };
            let exact = mechanism.ring_to_sun_ratios(wanted);
            // Beyond the tolerance the exact ring-to-sun ratios say more, if a simple set can have them.
            let simple = exact.clone().filter(|k| k.iter().all(|k| *k > 1.0));
            let Some(k) = nearest.filter(in_tolerance).or(simple) else {
                let obstacle = obstacle(exact.as_deref());
                let wanted = wanted.clone();
                found.unreachable.push(Unreachable { mechanism, wanted, needed: exact, obstacle });
                continue;
            };
            let candidate = Candidate::new(mechanism, k, wanted, requirements, drawing)?;
            if candidate.is_accepted() { &mut found.accepted } else { &mut found.rejected }.push(candidate);
        }
    }
    for mixed in [false, true] {
        let of = |place: &usize| found.accepted[*place].mixes_directions() == mixed;
        let mut places: Vec<usize> = (0..found.accepted.len()).filter(of).collect();
        let objectives = |place: usize| found.accepted[places[place]].objectives;
        let costs: Vec<_> = (0..places.len()).map(|place| objectives(place).costs()).collect();
        for mut entry in front::front(&costs, order, objectives) {
            entry.members.iter_mut().for_each(|member| *member = places[*member]);
            found.front.push(entry);
        }
        let costs = |place: usize| found.accepted[place].objectives.costs();
        places.sort_by(|&a, &b| order.compare(&costs(a), &costs(b)).then(a.cmp(&b)));
        found.best.extend(places);
    }
    Ok(found)
}

fn obstacle(needed: Option<&[f64]>) -> Obstacle {
    let Some(needed) = needed else { return Obstacle::Infinite };
    let too_small = needed.iter().enumerate().filter(|(_, k)| **k <= 1.0);
    Obstacle::TooSmall(too_small.map(|(set, _)| set).collect())
}

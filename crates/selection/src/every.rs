//! Every tooth design of a mechanism whose ratios lie within the tolerance.

use crate::mechanism::{Mechanism, largest_error};
use crate::requirements::Requirements;
use crate::tolerance::SLACK;
use epicyclic_gears::ToothCount;
use epicyclic_gears::mesh::coaxial_ring;
use epicyclic_gears::spacing::PlanetSpacing;
use epicyclic_gears::synthesis::{Bounds, ToothNumbers};
use std::ops::{ControlFlow, RangeInclusive};

/// Tooth numbers of the sets of a mechanism, for the target ratios of its braked gears.
#[derive(Debug, Clone, PartialEq)]
pub struct ToothedMechanism {
    /// The mechanism.
    pub mechanism: Mechanism,
    /// Target ratios of the braked gears.
    pub wanted: Vec<f64>,
    /// Tooth numbers of each set.
    pub teeth: Vec<ToothNumbers>,
    /// Largest relative deviation of a ratio.
    pub deviation: f64,
}

/// Sets of tooth numbers within bounds, with the least number of planets at equal angles; planets may touch.
/// Offsets are those of the ring from equal centre distances without profile shift.
#[must_use]
pub fn sets(bounds: &Bounds, offsets: RangeInclusive<i32>) -> Vec<ToothNumbers> {
    let mut all = vec![];
    for sun in bounds.sun.clone() {
        for planet in bounds.planet.clone() {
            for offset in offsets.clone() {
                let ring = coaxial_ring(sun, planet).checked_add_signed(offset);
                let Some(ring) = ring.filter(|ring| bounds.ring.contains(ring)) else { continue };
                let teeth = [sun, planet, ring].map(ToothCount::new);
                let [Ok(sun), Ok(planet), Ok(ring)] = teeth else { continue };
                let is_placed = |planets: &u32| PlanetSpacing::least_unequal(sun, ring, *planets).is_equal();
                let Some(planets) = bounds.planets.clone().find(is_placed) else { continue };
                let set = ToothNumbers { sun, planet, ring, planets };
                if bounds.ring_to_sun_ratio.contains(&set.ring_to_sun_ratio()) {
                    all.push(set);
                }
            }
        }
    }
    all
}

/// Every choice of these sets for a mechanism whose ratios lie within the tolerance of targets with allowed
/// directions, unless `goes_on`, which is called now and then, breaks; then what was found before.
#[must_use]
pub fn designs(
    mechanism: Mechanism,
    sets: &[ToothNumbers],
    requirements: &Requirements,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Vec<ToothedMechanism> {
    let mut targets = requirements.targets();
    targets.retain(|target| requirements.allows_directions_of(target));
    if mechanism.is_symmetric() {
        // The other order is the same gearbox with its sets exchanged.
        let all = targets.clone();
        let is_other = |target: &Vec<f64>| target[0].abs() < target[1].abs();
        targets.retain(|target| !(is_other(target) && all.contains(&vec![target[1], target[0]])));
    }
    let limits = &requirements.limits.ring_to_sun;
    let mut by_k: Vec<(f64, Vec<&ToothNumbers>)> = vec![];
    let mut sorted: Vec<&ToothNumbers> = sets.iter().collect();
    sorted.sort_by(|one, other| one.ring_to_sun_ratio().total_cmp(&other.ring_to_sun_ratio()));
    for set in sorted.into_iter().filter(|set| limits.contains(&set.ring_to_sun_ratio())) {
        match by_k.last_mut().filter(|(k, _)| *k == set.ring_to_sun_ratio()) {
            Some((_, all)) => all.push(set),
            None => by_k.push((set.ring_to_sun_ratio(), vec![set])),
        }
    }
    let mut found = vec![];
    let mut consider = |k: &[f64], all: &[&[&ToothNumbers]]| {
        let ratios = mechanism.ratios(k);
        for wanted in &targets {
            let deviation = largest_error(&ratios, wanted);
            if deviation > requirements.tolerance + SLACK {
                continue;
            }
            let toothed = |teeth: Vec<ToothNumbers>| ToothedMechanism {
                mechanism,
                wanted: wanted.clone(),
                teeth,
                deviation,
            };
            match all {
                [first, second] => found.extend(
                    first.iter().flat_map(|one| second.iter().map(|other| toothed(vec![**one, **other]))),
                ),
                _ => found.extend(all.iter().flat_map(|of| of.iter().map(|one| toothed(vec![**one])))),
            }
        }
    };
    for (first, of_first) in &by_k {
        if goes_on().is_break() {
            break;
        }
        match mechanism {
            Mechanism::OneSet(_) => consider(&[*first], &[of_first]),
            Mechanism::TwoSets(_) => {
                for (second, of_second) in &by_k {
                    consider(&[*first, *second], &[of_first, of_second]);
                }
            }
        }
    }
    found
}

//! Stages in series; if none are found, limits to relax, each with the train that is then found; on request
//! trains with smaller rings.
//!
//! Every way out is the result of the same search with the limit relaxed. The same command with the option
//! finds the same train.

use super::axes::Axes;
use super::front::{front, largest_ring};
use super::stage_kind::StageKind;
use super::stages::{MOST_STAGES, Stages, attempted, attempted_with};
use super::stages_wanted::WantedStages;
use super::ways_out::{GREATEST_TOLERANCE, Limit, OFFSETS, RelaxedLimit, WayOutOfStages, rounded};
use crate::error::Error;
use crate::size::options::Request as SizeRequest;
use epicyclic_strength::load::MOST_SHARING;
use epicyclic_strength::series::KnownSets;
use epicyclic_units::Physical;
use std::cell::RefCell;
use std::ops::{ControlFlow, RangeInclusive};

/// Tooth numbers of suns that are tried for a ratio above 1.
pub(crate) const fn suns(ratio: f64) -> [u32; 2] {
    [12, if ratio < LARGE_SUNS[0].0 { LARGE_SUNS[0].1 } else { LARGE_SUNS[1].1 }]
}

/// Ratios of trains below which suns have more teeth than usual, and their most. Below 3.2 they are nearly
/// as large as their rings; small planets of low ratios have room for their bearings only with many teeth
/// and small modules. Larger trains would take long.
pub(crate) const LARGE_SUNS: [(f64, u32); 2] = [(3.2, 80), (40.0, 60)];

/// Tooth numbers of planets and rings, and ring-to-sun ratios, that are tried.
pub(crate) const PLANETS: [u32; 2] = [12, 120];
pub(crate) const RINGS: [u32; 2] = [30, 250];
const RING_TO_SUN_RATIOS: RangeInclusive<f64> = 1.1..=15.0;

/// Numbers of stages that are tried.
pub(crate) const STAGES: RangeInclusive<usize> = 1..=MOST_STAGES as usize;

/// Trains with the ratio above which a wider tolerance is not tried: where so many have no sizes, more do not
/// help.
const MANY: u64 = 1000;

/// Relative width of the interval in which the least sufficient ring is found.
const RING_STEP: f64 = 0.05;

/// Trains of each number of stages that are searched: the best and the next.
const MOST: usize = 2;

/// Designs stages in series. `goes_on` is called now and then, and may end the search. If no stages hold, the
/// search is repeated with each obstructing limit relaxed.
///
/// # Errors
/// As of [`size`](crate::size::options::Request::answer), which refer to the unfinished gearbox.
pub fn answer(wanted: &WantedStages, goes_on: &dyn Fn() -> ControlFlow<()>) -> Result<Stages, Error> {
    let mut known = Default::default();
    let (mut stages, larger) = attempted(wanted, MOST, &mut known, goes_on)?;
    let search = Search { wanted, known: RefCell::new(known), goes_on };
    if stages.file.is_none() {
        stages.ways_out = Some(search.ways_out(&stages)?);
    } else if wanted.is_front_asked {
        let has_pair = stages.taken().is_some_and(|trains| trains.has_pair);
        let axes = if has_pair { Axes::Parallel } else { Axes::Coaxial };
        let kind = stages.taken().map_or(StageKind::Simple, |trains| trains.kind);
        stages.front = Some(search.front((axes, kind, larger), largest_ring(stages.sizes.as_ref()))?);
    }
    Ok(stages)
}

/// The train taken, with the limits under which it was found; `None` without one.
fn way(limits: &[RelaxedLimit], stages: &Stages) -> Option<WayOutOfStages> {
    stages.file.as_ref()?;
    let train = stages.taken()?.best.clone()?;
    Some(WayOutOfStages {
        limits: limits.to_vec(),
        teeth: train.teeth,
        ratio: train.ratio,
        ring_diameter_m: largest_ring(stages.sizes.as_ref()),
        efficiency: stages.efficiency,
        whole_kg: stages.masses.map(|of| of.whole_kg),
        rules_missed: train.rules_missed,
    })
}

/// Limits that can be relaxed, as far as possible; the tolerance only without many trains.
fn candidates(wanted: &WantedStages, found: &Stages) -> Vec<RelaxedLimit> {
    let has_many_trains = found.trains.iter().any(|trains| trains.compared > MANY);
    let lifted = RelaxedLimit::lifted;
    let between = |limit, least: f64, greatest: f64| RelaxedLimit {
        limit,
        least: Some(least),
        greatest: Some(greatest),
    };
    let (teeth, size, over) = (&wanted.teeth, &wanted.size, &found.limits);
    let reached = |limit, value: Option<f64>| RelaxedLimit {
        greatest: value.map(|value| rounded(value, f64::ceil)),
        ..lifted(limit)
    };
    let of_teeth = |limit, own: &RangeInclusive<u32>, [least, most]: [u32; 2]| {
        let [least, most] = [least.min(*own.start()), most.max(*own.end())];
        let is_wider = (least..=most) != *own;
        (between(limit, f64::from(least), f64::from(most)), is_wider)
    };
    // Sets with planets of two gears are one stage, whose rings may have any ratio to the sun.
    let has_simple = wanted.kinds.contains(&StageKind::Simple);
    let k = &teeth.ring_to_sun_ratio;
    let [least_k, most_k] =
        [k.start().min(*RING_TO_SUN_RATIOS.start()), k.end().max(*RING_TO_SUN_RATIOS.end())];
    let [fewest, most] = [STAGES.start(), STAGES.end()].map(|stages| *stages as f64);
    let most_planets = f64::from(MOST_SHARING);
    let all = [
        (reached(Limit::WholeMass, over.lightest_kg), over.lightest_kg.is_some()),
        (reached(Limit::Length, over.shortest_m), over.shortest_m.is_some()),
        (lifted(Limit::LargestRing), size.max_ring.is_some()),
        (
            RelaxedLimit { greatest: Some(GREATEST_TOLERANCE), ..lifted(Limit::Tolerance) },
            wanted.tolerance < GREATEST_TOLERANCE && !has_many_trains,
        ),
        (lifted(Limit::StageKinds), !has_simple && !wanted.steps_up),
        (between(Limit::Stages, fewest, most), has_simple && wanted.stages != STAGES),
        of_teeth(Limit::SunTeeth, &teeth.suns, suns(wanted.ratio)),
        of_teeth(Limit::PlanetTeeth, &teeth.planets, PLANETS),
        of_teeth(Limit::RingTeeth, &teeth.rings, RINGS),
        (between(Limit::RingToSunRatio, least_k, most_k), has_simple && (least_k..=most_k) != *k),
        (
            between(Limit::RingOffset, f64::from(*OFFSETS.start()), f64::from(*OFFSETS.end())),
            teeth.ring_offsets == (0..=0),
        ),
        (lifted(Limit::HuntingTeeth), wanted.is_hunting_asked),
        (lifted(Limit::Axes), has_simple && wanted.axes == Axes::Coaxial && !wanted.turns_back),
        (lifted(Limit::Modules), size.modules.is_some()),
        (lifted(Limit::FaceWidths), size.face_widths.is_some()),
        (
            RelaxedLimit { greatest: Some(most_planets), ..lifted(Limit::Planets) },
            *size.planet_counts().end() < MOST_SHARING,
        ),
        (lifted(Limit::WidthRatio), size.width_ratio.is_some()),
        (lifted(Limit::PlainBearings), size.lacks_plain_bearings()),
        (lifted(Limit::Bearings), !size.no_bearings),
    ];
    all.into_iter().filter(|(_, is_narrow)| *is_narrow).map(|(limit, _)| limit).collect()
}

/// Whether a limit bounds the tooth numbers.
const fn is_of_teeth(limit: Limit) -> bool {
    matches!(
        limit,
        Limit::SunTeeth | Limit::PlanetTeeth | Limit::RingTeeth | Limit::RingToSunRatio | Limit::RingOffset
    )
}

/// Whether a limit bounds the sizes of every set, so that what is known of the sets holds no longer.
const fn is_of_sizes(limit: Limit) -> bool {
    !is_of_teeth(limit)
        && !matches!(
            limit,
            Limit::LargestRing
                | Limit::WholeMass
                | Limit::Length
                | Limit::Tolerance
                | Limit::Stages
                | Limit::HuntingTeeth
                | Limit::Axes
                | Limit::StageKinds
        )
}

/// Search for stages with other limits.
struct Search<'a> {
    wanted: &'a WantedStages,
    /// Sets of the order, as far as its searches know them.
    known: RefCell<[KnownSets; 2]>,
    goes_on: &'a dyn Fn() -> ControlFlow<()>,
}

impl Search<'_> {
    /// Finds the ways out for an order without stages that hold: each limit relaxed alone, those of tooth numbers
    /// and axes only if no other suffices; or else as few as possible of the others together.
    fn ways_out(&self, found: &Stages) -> Result<Vec<WayOutOfStages>, Error> {
        let all = candidates(self.wanted, found);
        // Trains that hold are there: only their mass or length is in the way.
        let exceeded: Vec<_> =
            all.iter().filter(|one| matches!(one.limit, Limit::WholeMass | Limit::Length)).copied().collect();
        if !exceeded.is_empty() {
            return self.of_each(&exceeded);
        }
        // Without simple sets every search sizes many sets anew: the first limit that suffices is enough.
        if !self.wanted.kinds.contains(&StageKind::Simple) {
            for limit in &all {
                let ways = self.of_each(std::slice::from_ref(limit))?;
                if !ways.is_empty() {
                    return Ok(ways);
                }
            }
            return Ok(vec![]);
        }
        // More tooth numbers make the search many times longer. Another kind of train is no gearbox of the order
        // while one of this kind holds.
        let is_last = |one: &RelaxedLimit| {
            is_of_teeth(one.limit) || matches!(one.limit, Limit::Axes | Limit::StageKinds)
        };
        let (of_teeth, others): (Vec<_>, Vec<_>) = all.into_iter().partition(is_last);
        let mut ways = vec![];
        for group in [&others, &of_teeth] {
            if ways.is_empty() {
                ways = self.of_each(group)?;
            }
        }
        if ways.is_empty() && others.len() > 1 {
            ways.extend(self.of_several(others)?);
        }
        Ok(ways)
    }

    /// The best trains with smaller rings than this one, of the kind of the best one, with its kinds of bearings and
    /// modules, which may be the larger ones.
    fn front(
        &self,
        (axes, kind, larger): (Axes, StageKind, Option<SizeRequest>),
        ring: f64,
    ) -> Result<Vec<WayOutOfStages>, Error> {
        let known = &mut self.known.borrow_mut()[usize::from(larger.is_some())];
        let mut wanted = self.wanted.clone();
        wanted.size = larger.unwrap_or(wanted.size);
        (wanted.axes, wanted.kinds) = (axes, vec![kind]);
        front(ring, |most| {
            let limit = RelaxedLimit::of_rings(most);
            relax(limit, &mut wanted);
            let stages = attempted_with(&wanted, 1, known, self.goes_on)?;
            Ok(way(&[limit], &stages).map(|way| (way.clone(), way.ring_diameter_m)))
        })
    }

    /// Stages with these limits; `None` if none hold.
    fn with(&self, limits: &[RelaxedLimit]) -> Result<Option<(WayOutOfStages, Stages)>, Error> {
        let mut wanted = self.wanted.clone();
        limits.iter().for_each(|limit| relax(*limit, &mut wanted));
        let (stages, _) = match limits.iter().any(|limit| is_of_sizes(limit.limit)) {
            true => attempted(&wanted, 1, &mut Default::default(), self.goes_on)?,
            false => attempted(&wanted, 1, &mut self.known.borrow_mut(), self.goes_on)?,
        };
        Ok(way(limits, &stages).map(|way| (way, stages)))
    }

    /// Ways out with each limit relaxed alone.
    fn of_each(&self, limits: &[RelaxedLimit]) -> Result<Vec<WayOutOfStages>, Error> {
        let mut ways = vec![];
        for limit in limits {
            let Some(found) = self.with(&[*limit])? else { continue };
            ways.push(self.tightened(found, *limit)?);
        }
        Ok(ways)
    }

    /// Way out with the least relaxed value of its limit that is found.
    fn tightened(
        &self,
        (way, stages): (WayOutOfStages, Stages),
        limit: RelaxedLimit,
    ) -> Result<WayOutOfStages, Error> {
        match limit.limit {
            Limit::LargestRing => self.of_ring(way),
            Limit::Tolerance => {
                // The tolerance is that of the ratio above 1, whichever shaft is the input.
                let quotient = (way.ratio / stages.asked_ratio).abs();
                let deviation = (quotient - 1.0).abs().max((1.0 / quotient - 1.0).abs());
                let needed = rounded(deviation, f64::ceil);
                self.or_wider(way, RelaxedLimit { greatest: Some(needed), ..limit })
            }
            Limit::WidthRatio => {
                let sets = stages.sizes.iter().flat_map(|sizes| &sizes.sets);
                let families = sets.filter_map(|set| set.found.first()).flat_map(|design| &design.families);
                let needed = families.map(|family| family.face_width_over_diameter).fold(0.0, f64::max);
                self.or_wider(way, RelaxedLimit { greatest: Some(rounded(needed, f64::ceil)), ..limit })
            }
            Limit::Stages => {
                let count = way.teeth.len() as f64;
                let [least, most] =
                    [self.wanted.stages.start(), self.wanted.stages.end()].map(|of| *of as f64);
                let needed =
                    RelaxedLimit { least: Some(count.min(least)), greatest: Some(count.max(most)), ..limit };
                self.or_wider(way, needed)
            }
            _ => Ok(way),
        }
    }

    /// Stages with a narrower limit if it suffices.
    fn or_wider(&self, wide: WayOutOfStages, limit: RelaxedLimit) -> Result<WayOutOfStages, Error> {
        Ok(self.with(&[limit])?.map_or(wide, |(way, _)| way))
    }

    /// Stages with the least ring that holds, by halving the interval between the bound asked for and a
    /// sufficient one.
    fn of_ring(&self, free: WayOutOfStages) -> Result<WayOutOfStages, Error> {
        let limit = |ring| RelaxedLimit { greatest: Some(ring), ..RelaxedLimit::lifted(Limit::LargestRing) };
        let mut most = rounded(free.ring_diameter_m, f64::ceil);
        let mut way = self.or_wider(free, limit(most))?;
        let mut least = self.wanted.size.max_ring.map_or(0.0, |ring| ring.0.si());
        while most - least > RING_STEP * most {
            let middle = rounded(f64::midpoint(least, most), f64::ceil);
            if middle >= most {
                break;
            }
            match self.with(&[limit(middle)])? {
                // The ring found may be smaller than the bound, and its own bound then suffices.
                Some((found, _)) => {
                    most = rounded(found.ring_diameter_m, f64::ceil).min(middle);
                    way = found;
                }
                None => least = middle,
            }
        }
        Ok(way)
    }

    /// Stages with all limits relaxed, less those that are not needed.
    fn of_several(&self, mut limits: Vec<RelaxedLimit>) -> Result<Option<WayOutOfStages>, Error> {
        let Some((mut way, _)) = self.with(&limits)? else { return Ok(None) };
        for place in (0..limits.len()).rev() {
            let mut fewer = limits.clone();
            fewer.remove(place);
            if let Some((found, _)) = self.with(&fewer)? {
                (limits, way) = (fewer, found);
            }
        }
        Ok(Some(way))
    }
}

/// Relaxes a limit of an order.
fn relax(one: RelaxedLimit, wanted: &mut WantedStages) {
    let ends = [one.least, one.greatest].map(Option::unwrap_or_default);
    let of_teeth = || ends[0] as u32..=ends[1] as u32;
    match one.limit {
        Limit::Tolerance => wanted.tolerance = ends[1],
        Limit::Stages => wanted.stages = ends[0] as usize..=ends[1] as usize,
        Limit::SunTeeth => (wanted.teeth.suns, wanted.arranged_suns) = (of_teeth(), of_teeth()),
        Limit::PlanetTeeth => wanted.teeth.planets = of_teeth(),
        Limit::RingTeeth => wanted.teeth.rings = of_teeth(),
        Limit::RingToSunRatio => wanted.teeth.ring_to_sun_ratio = ends[0]..=ends[1],
        Limit::RingOffset => wanted.teeth.ring_offsets = ends[0] as i32..=ends[1] as i32,
        Limit::HuntingTeeth => wanted.teeth.is_hunting = false,
        Limit::Axes => wanted.axes = Axes::Either,
        Limit::StageKinds => wanted.kinds = StageKind::ALL.to_vec(),
        Limit::WholeMass => wanted.limits.whole_kg = one.greatest,
        Limit::Length => wanted.limits.length_m = one.greatest,
        _ => one.relax_size(&mut wanted.size),
    }
}

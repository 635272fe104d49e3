//! Search over teeth by brute force: every pair of tooth numbers through the solver of any gearbox, every
//! pair of designs compared. The oracle of the search, and what its speed is measured against.

#![allow(dead_code, reason = "shared by tests and benches, neither of which uses all of it")]

use epicyclic_gears::ToothCount;
use epicyclic_gears::involute::search::ProfileShift;
use epicyclic_gears::simple_set::{BasicRatio, RingToSunRatio};
use epicyclic_gears::synthesis::{Bounds, ToothNumbers, tooth_numbers_by_trial};
use epicyclic_schemes::direct_drive::DIRECT_CLUTCH_PAIRS;
use epicyclic_schemes::structures::{Role, Structure};
use epicyclic_selection::drawing::drawable_direct_clutches;
use epicyclic_selection::size::relative_ring_diameter_of_teeth;
use epicyclic_selection::{Mechanism, Requirements};
use epicyclic_train::{CompiledGear, Direction, Gearbox, LinkId, Solution, Values};
use std::collections::BTreeMap;

/// A design that meets the criteria.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Design {
    pub(crate) structure: Structure,
    pub(crate) wanted: [f64; 2],
    pub(crate) teeth: [ToothNumbers; 2],
    /// Efficiency, speed, ring-to-sun ratio, ratio error, size, as costs.
    pub(crate) costs: [f64; 5],
}

/// Every design of these structures that meets the criteria, and how many were tried.
pub(crate) fn designs(
    requirements: &Requirements,
    structures: &[Structure],
    bounds: &Bounds,
) -> (Vec<Design>, u64) {
    designs_of(requirements, structures, &that_turn_by_trial(bounds), None)
}

/// Tooth numbers without profile shift whose gears can be cut and turned together.
pub(crate) fn that_turn_by_trial(bounds: &Bounds) -> Vec<ToothNumbers> {
    let mut all = tooth_numbers_by_trial(bounds).expect("the bounds are bounds");
    all.retain(|set| bounds.can_turn(set, &mut None).expect("the rack is one"));
    all
}

/// Every design of these structures and tooth numbers that meets the criteria, and how many were tried.
pub(crate) fn designs_of(
    requirements: &Requirements,
    structures: &[Structure],
    tooth_sets: &[ToothNumbers],
    shift: Option<&ProfileShift>,
) -> (Vec<Design>, u64) {
    let (mut found, mut tried) = (vec![], 0);
    let of_k = by_k(tooth_sets);
    for &structure in structures {
        let Some(model) = Model::new(structure, requirements) else { continue };
        let targets: Vec<[f64; 2]> = requirements.targets().into_iter().map(|t| [t[0], t[1]]).collect();
        for (place, wanted) in targets.iter().enumerate() {
            if structure.is_symmetric() && targets[..place].contains(&[wanted[1], wanted[0]]) {
                continue;
            }
            for firsts in of_k.values() {
                for seconds in of_k.values() {
                    tried += (firsts.len() * seconds.len()) as u64;
                    let k = [firsts, seconds].map(|all| all[0].ring_to_sun_ratio());
                    let Some(motion) = model.motion(requirements, *wanted, k) else { continue };
                    let of = |set: usize, all: &[ToothNumbers]| -> Vec<_> {
                        all.iter()
                            .map(|teeth| motion.speed_and_size(requirements, set, teeth, shift))
                            .collect()
                    };
                    let (of_first, of_second) = (of(0, firsts), of(1, seconds));
                    for (first, [speed, size]) in firsts.iter().zip(&of_first) {
                        for (second, [other_speed, other_size]) in seconds.iter().zip(&of_second) {
                            let planets = speed.max(*other_speed);
                            if within(planets, requirements.limits.planet_speed) {
                                let mut costs = motion.costs;
                                (costs[1], costs[4]) = (costs[1].max(planets), size.max(*other_size));
                                found.push(Design {
                                    structure,
                                    wanted: *wanted,
                                    teeth: [*first, *second],
                                    costs,
                                });
                            }
                        }
                    }
                }
            }
        }
    }
    (found, tried)
}

/// Tooth numbers of one `k` turn alike: the solver is asked once for all of them.
pub(crate) fn by_k(tooth_sets: &[ToothNumbers]) -> BTreeMap<u64, Vec<ToothNumbers>> {
    let mut of_k: BTreeMap<u64, Vec<ToothNumbers>> = BTreeMap::new();
    for teeth in tooth_sets {
        of_k.entry(teeth.ring_to_sun_ratio().to_bits()).or_default().push(*teeth);
    }
    of_k
}

fn within(value: f64, limit: f64) -> bool {
    value <= limit + 1e-9 * (1.0 + limit)
}

/// Tooth numbers with profile shift within bounds: every sun, planet, ring and number of planets is closed.
pub(crate) fn shifted_by_trial(bounds: &Bounds, shift: &ProfileShift) -> Vec<ToothNumbers> {
    let count = |teeth| ToothCount::new(teeth).expect("the bounds have teeth");
    let mut found = vec![];
    for (sun, planet) in
        bounds.sun.clone().flat_map(|sun| bounds.planet.clone().map(move |planet| (sun, planet)))
    {
        for ring in bounds.ring.clone() {
            let offset = i64::from(ring) - i64::from(sun + 2 * planet);
            let k = f64::from(ring) / f64::from(sun);
            let is_within = shift.offsets.contains(&(offset as i32)) && bounds.ring_to_sun_ratio.contains(&k);
            for planets in bounds.planets.clone() {
                let teeth =
                    ToothNumbers { sun: count(sun), planet: count(planet), ring: count(ring), planets };
                if is_within && (sun + ring) % planets == 0 && shift.close(&teeth).is_ok() {
                    found.push(teeth);
                }
            }
        }
    }
    found
}

/// Designs that no other dominates.
pub(crate) fn front(designs: &[Design]) -> Vec<Design> {
    let free = undominated(designs.iter().map(|design| design.costs));
    designs.iter().filter(|design| free(&design.costs)).copied().collect()
}

/// Whether none of all dominates some costs: each is compared with each, the cheapest first, as they dominate
/// the most.
pub(crate) fn undominated(all: impl Iterator<Item = [f64; 5]>) -> impl Fn(&[f64; 5]) -> bool {
    let dominates = |one: &[f64; 5], other: &[f64; 5]| {
        one.iter().zip(other).all(|(a, b)| *a <= b + 1e-12)
            && one.iter().zip(other).any(|(a, b)| *a < b - 1e-12)
    };
    let mut all: Vec<[f64; 5]> = all.collect();
    all.sort_by(|one, other| one.iter().sum::<f64>().total_cmp(&other.iter().sum()));
    all.dedup();
    move |costs| !all.iter().any(|other| dominates(other, costs))
}

struct Model {
    structure: Structure,
    gearbox: Gearbox,
    gears: [CompiledGear; 2],
    links: [LinkId; 4],
    direct_clutches: Vec<[Role; 2]>,
}

/// Figures that follow from two `k`, whatever the teeth.
struct MotionOfK {
    /// Costs with the speed of links alone, and without size.
    costs: [f64; 5],
    /// Largest speed of each set's sun relative to its carrier.
    suns: [f64; 2],
    /// Largest torque of each set's sun.
    torques: [f64; 2],
}

impl MotionOfK {
    fn speed_and_size(
        &self,
        requirements: &Requirements,
        set: usize,
        teeth: &ToothNumbers,
        shift: Option<&ProfileShift>,
    ) -> [f64; 2] {
        let speed = self.suns[set] * teeth.sun.as_f64() / teeth.planet.as_f64();
        let size = relative_ring_diameter_of_teeth(teeth, shift, self.torques[set], &requirements.rating);
        [speed, size.expect("a set")]
    }
}

impl Model {
    fn new(structure: Structure, requirements: &Requirements) -> Option<Self> {
        let gearbox = structure.gearbox([2.37, 3.19], requirements.eta0, [Role::D, Role::B]).ok()?;
        let compile = |name| CompiledGear::new(&gearbox, gearbox.gear(name).ok()?).ok();
        let gears = [compile("1")?, compile("2")?];
        let links = Role::ALL.map(|role| gearbox.link(role.symbol()).expect("a link of the structure"));
        let direct_clutches = if requirements.limits.drawable {
            drawable_direct_clutches(Mechanism::TwoSets(structure)).ok()?
        } else {
            DIRECT_CLUTCH_PAIRS.to_vec()
        };
        Some(Self { structure, gearbox, gears, links, direct_clutches })
    }

    /// Motion of these `k`, if it meets the criteria that teeth do not change.
    fn motion(&self, requirements: &Requirements, wanted: [f64; 2], k: [f64; 2]) -> Option<MotionOfK> {
        let limits = &requirements.limits;
        if !k.iter().all(|k| limits.ring_to_sun.contains(k)) {
            return None;
        }
        let values = values(k, requirements);
        let mut solution = Solution::default();
        let (mut error, mut efficiency) = (0.0_f64, f64::INFINITY);
        let (mut links, mut suns, mut torques) = (0.0_f64, [0.0_f64; 2], [0.0_f64; 2]);
        let mut slips = vec![0.0_f64; self.direct_clutches.len()];
        for (gear, wanted) in self.gears.iter().zip(wanted) {
            gear.solve(&values, Direction::Drive, &mut solution).ok()?;
            error = error.max((solution.ratio() / wanted - 1.0).abs());
            if !within(error, requirements.tolerance) {
                return None;
            }
            efficiency = efficiency.min(solution.efficiency()?);
            let mut speeds = [0.0; 4];
            for (speed, link) in speeds.iter_mut().zip(self.links) {
                *speed = gear.link_speed(&solution, link)?;
                links = links.max(speed.abs());
            }
            for (set, sun) in self.gearbox.sets().iter().zip(&mut suns) {
                let of = |member: usize| gear.link_speed(&solution, set.members()[member]);
                *sun = sun.max((of(0)? - of(2)?).abs());
            }
            for (&set, torque) in gear.active().iter().zip(solution.sun_torques()?) {
                let largest = &mut torques[set];
                *largest = largest.max(torque.abs());
            }
            for (slip, [x, y]) in slips.iter_mut().zip(self.direct_clutches.iter().copied()) {
                *slip = slip.max((speeds[x as usize] - speeds[y as usize]).abs());
            }
        }
        let slip = slips.into_iter().fold(f64::INFINITY, f64::min);
        let met = within(links, limits.link_speed)
            && within(slip, limits.clutch_slip)
            && efficiency >= limits.efficiency - 1e-9 * (1.0 + limits.efficiency);
        if !met {
            return None;
        }
        if limits.circulation.is_finite() {
            // By the power flow of the whole gearbox.
            let gearbox = self.structure.gearbox(k, requirements.eta0, [Role::D, Role::B]).ok()?;
            let circulates = ["1", "2"].map(|gear| {
                let analysis = gearbox.analyze(gear).expect("a gear");
                analysis.driving().map_or(0.0, |case| case.power.circulating)
            });
            if !circulates.into_iter().all(|value| within(value, limits.circulation)) {
                return None;
            }
        }
        let (low, high) = (*limits.preferred.start(), *limits.preferred.end());
        let distance: f64 = k.iter().map(|k| (libm::log(*k) - libm::log(k.clamp(low, high))).abs()).sum();
        Some(MotionOfK { costs: [-efficiency, links, distance, error, 0.0], suns, torques })
    }
}

fn values(k: [f64; 2], requirements: &Requirements) -> Values {
    let ratio = |k| BasicRatio::from(RingToSunRatio::new(k).expect("k above 1"));
    Values { ratios: k.map(ratio).into(), efficiencies: vec![requirements.eta0; 2] }
}

/// Points of a grid of ring-to-sun ratios, `side` on each side, whose ratios come nearest: one for each
/// structure and assignment of ratios.
pub(crate) fn nearest_on_a_grid(
    requirements: &Requirements,
    structures: &[Structure],
    side: u32,
) -> Vec<(Structure, [f64; 2], f64)> {
    let (low, high) = (*requirements.limits.ring_to_sun.start(), *requirements.limits.ring_to_sun.end());
    let rung = |step: u32| low * libm::pow(high / low, f64::from(step) / f64::from(side - 1));
    let mut found = vec![];
    for &structure in structures {
        let Some(model) = Model::new(structure, requirements) else { continue };
        for target in requirements.targets() {
            let mut best = (structure, [0.0; 2], f64::INFINITY);
            for step in 0..side * side {
                let k = [rung(step / side), rung(step % side)];
                let values = values(k, requirements);
                let mut error = 0.0_f64;
                let mut solution = Solution::default();
                for (gear, wanted) in model.gears.iter().zip(&target) {
                    if gear.solve(&values, Direction::Drive, &mut solution).is_ok() {
                        error = error.max((solution.ratio() / wanted - 1.0).abs());
                    }
                }
                if error < best.2 {
                    best = (structure, k, error);
                }
            }
            found.push(best);
        }
    }
    found
}

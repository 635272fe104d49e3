//! One structure with one assignment of the ratios: all its pairs of ring-to-sun ratios, measured.

use super::levels::Level;
use super::window::{Wanted, window};
use crate::Mechanism;
use crate::drawing::drawable_direct_clutches;
use crate::objectives::{Costs, on_grid};
use crate::requirements::{Limits, Requirements};
use crate::tolerance::SLACK;
use epicyclic_schemes::direct_drive::{DIRECT_CLUTCH_PAIRS, link_speeds};
use epicyclic_schemes::pair::{Coefficients, coefficients, effective, exponents, fraction, minor, ratios};
use epicyclic_schemes::structures::{Role, SetRoles, Structure};

/// A structure with an assignment of the ratios.
#[derive(Debug, Clone)]
pub(crate) struct Patch {
    pub(crate) structure: Structure,
    pub(crate) wanted: [f64; 2],
    sets: [SetRoles; 2],
    /// Options for the direct-drive clutch; only those that can be drawn, unless that does not matter.
    direct_clutches: Vec<[Role; 2]>,
    /// Directions of the rolling powers, by gear and set.
    exponents: [[i8; 2]; 2],
    eta0: f64,
    /// Windows of `k₂` as places of levels: place of `k₁`, first, end.
    pub(crate) strips: Vec<[u32; 3]>,
}

/// A set at one level: coefficients without losses, and with those of gears 1 and 2.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Side {
    ideal: Coefficients,
    loaded: [Coefficients; 2],
}

/// A pair of levels measured, before sizes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Measured {
    pub(crate) efficiency: f64,
    pub(crate) speed: f64,
    pub(crate) ratio_error: f64,
    /// Largest torque on the suns over the gears.
    pub(crate) sun_torques: [f64; 2],
}

/// A limit as a trial takes it: a value at it is within.
fn allowed(limit: f64) -> f64 {
    limit + SLACK * (1.0 + limit)
}

/// Limits as the trial takes them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Allowed {
    ratio_error: f64,
    link_speed: f64,
    planet_speed: f64,
    clutch_slip: f64,
    efficiency: f64,
}

impl Allowed {
    pub(crate) fn new(requirements: &Requirements) -> Self {
        let limits = &requirements.limits;
        Self {
            ratio_error: allowed(requirements.tolerance),
            link_speed: allowed(limits.link_speed),
            planet_speed: allowed(limits.planet_speed),
            clutch_slip: allowed(limits.clutch_slip),
            efficiency: limits.efficiency - SLACK * (1.0 + limits.efficiency),
        }
    }
}

impl Patch {
    /// The patch with its windows; `None` where no pair of levels comes into question.
    pub(crate) fn new(
        structure: Structure,
        ratio: [f64; 2],
        requirements: &Requirements,
        levels: &[Level],
    ) -> Option<Self> {
        let sets = structure.sets();
        let limits: &Limits = &requirements.limits;
        let (first, last) = (levels.first()?, levels.last()?);
        let wanted = Wanted { ratios: ratio, tolerance: requirements.tolerance };
        if !in_reach(structure, wanted, [first.k, last.k]) {
            return None;
        }
        let direct_clutches = if limits.drawable {
            drawable_direct_clutches(Mechanism::TwoSets(structure)).ok()?
        } else {
            DIRECT_CLUTCH_PAIRS.to_vec()
        };
        let mut strips = vec![];
        for (place, level) in levels.iter().enumerate() {
            let first_set = coefficients(sets[0], level.k);
            let range = [first.k, last.k];
            let Some([from, to]) = window(sets, &first_set, level.k, wanted, limits, range) else { continue };
            let from = levels.partition_point(|level| level.k < from);
            let to = levels.partition_point(|level| level.k <= to);
            if from < to {
                strips.push([place as u32, from as u32, to as u32]);
            }
        }
        // Signs of rolling powers are those of any pair whose ratios have the wanted signs.
        let witness = strips.iter().find_map(|&[one, from, to]| {
            let signs_fit = |&two: &u32| {
                let k = [levels[one as usize].k, levels[two as usize].k];
                let found = ratios(&coefficients(sets[0], k[0]), &coefficients(sets[1], k[1]));
                found[0] * ratio[0] > 0.0 && found[1] * ratio[1] > 0.0
            };
            (from..to).find(signs_fit).map(|two| [levels[one as usize].k, levels[two as usize].k])
        })?;
        let exponents = [0, 1].map(|gear| exponents(sets, witness, gear));
        let eta0 = requirements.eta0.get();
        Some(Self { structure, wanted: ratio, sets, direct_clutches, exponents, eta0, strips })
    }

    /// A set at a level.
    pub(crate) fn side(&self, set: usize, level: &Level) -> Side {
        let loaded = |gear: usize| {
            let k = effective(level.k, self.eta0, self.exponents[gear][set]);
            coefficients(self.sets[set], k)
        };
        Side { ideal: coefficients(self.sets[set], level.k), loaded: [0, 1].map(loaded) }
    }

    /// Set 1 at each level, and set 2. They take more memory than all else of a patch, so they are kept while it is
    /// tried and no longer.
    pub(crate) fn sides(&self, levels: &[Level]) -> [Vec<Side>; 2] {
        [0, 1].map(|set| levels.iter().map(|level| self.side(set, level)).collect())
    }

    /// Pairs of levels within the windows of some strips.
    pub(crate) fn pairs(strips: &[[u32; 3]]) -> u64 {
        strips.iter().map(|[_, from, to]| u64::from(to - from)).sum()
    }

    /// Measures a pair of levels; `None` where a criterion is not met.
    #[inline]
    pub(crate) fn measure(
        &self,
        levels: &[Level],
        pair: [usize; 2],
        [one, two]: [&Side; 2],
        allowed: &Allowed,
    ) -> Option<Measured> {
        const D: usize = Role::D.index();
        const B: usize = Role::B.index();
        let fractions = [0, 1].map(|gear| fraction(&one.ideal, &two.ideal, gear));
        let ratio = fractions.map(|[n, d]| n / d);
        let error = |gear: usize| (ratio[gear] / self.wanted[gear] - 1.0).abs();
        let ratio_error = error(0).max(error(1));
        if ratio_error.is_nan() || ratio_error > allowed.ratio_error {
            return None;
        }
        // Link speeds: D at 1, the braked link at rest, B and the free link.
        let d_b = minor(&one.ideal, &two.ideal, D, B);
        let mut speeds = [[1.0, 0.0, 0.0, 0.0]; 2];
        let free = [Role::T2.index(), Role::T1.index()];
        let mut links = 1.0_f64;
        for gear in 0..2 {
            let [n, d] = fractions[gear];
            let over = 1.0 / n;
            speeds[gear][B] = d * over;
            speeds[gear][free[gear]] = -d_b * over;
            links = links.max(speeds[gear][B].abs()).max(speeds[gear][free[gear]].abs());
        }
        let mut planets = 0.0_f64;
        for (set, [a, _, h]) in self.sets.iter().enumerate() {
            let relative = |gear: usize| (speeds[gear][a.index()] - speeds[gear][h.index()]).abs();
            planets = planets.max(relative(0).max(relative(1)) * levels[pair[set]].planet);
        }
        if links > allowed.link_speed || planets > allowed.planet_speed {
            return None;
        }
        let [x, y] = self.direct_clutches[0].map(Role::index);
        let slip =
            |x: usize, y: usize| (speeds[0][x] - speeds[0][y]).abs().max((speeds[1][x] - speeds[1][y]).abs());
        if slip(x, y) > allowed.clutch_slip && !self.another_direct_clutch_fits(ratio, allowed) {
            return None;
        }
        let mut efficiency = f64::INFINITY;
        let mut sun_torques = [0.0_f64; 2];
        for gear in 0..2 {
            let (one, two) = (&one.loaded[gear], &two.loaded[gear]);
            let [n, d] = fraction(one, two, gear);
            let over = 1.0 / d;
            efficiency = efficiency.min(n * over / ratio[gear]);
            let x = free[gear];
            sun_torques[0] = sun_torques[0].max((two[x] * over).abs());
            sun_torques[1] = sun_torques[1].max((one[x] * over).abs());
        }
        if efficiency < allowed.efficiency {
            return None;
        }
        Some(Measured { efficiency, speed: links.max(planets), ratio_error, sun_torques })
    }

    #[cold]
    fn another_direct_clutch_fits(&self, ratio: [f64; 2], allowed: &Allowed) -> bool {
        let speeds = link_speeds(ratio);
        let u = epicyclic_schemes::structures::motion(ratio);
        self.direct_clutches.iter().any(|pair| {
            let [x, y] = pair.map(Role::index);
            let slip = speeds.iter().fold(0.0_f64, |m, speed| m.max((speed[x] - speed[y]).abs()));
            ((u[0] - u[1]) / (u[x] - u[y])).is_finite() && slip <= allowed.clutch_slip
        })
    }
}

impl Measured {
    /// Costs of a pair of levels with the shares `K_γ/N` of its sets.
    #[inline]
    pub(crate) fn costs(&self, levels: [&Level; 2], shares: [f64; 2]) -> Costs {
        let cube = |set: usize| levels[set].cube * self.sun_torques[set] * shares[set];
        let distance = levels[0].distance + levels[1].distance;
        [-self.efficiency, self.speed, distance, self.ratio_error, cube(0).max(cube(1))].map(on_grid)
    }

    /// Cube of the relative ring diameter of a set.
    #[inline]
    pub(crate) fn cube(&self, set: usize, level: &Level, share: f64) -> f64 {
        level.cube * self.sun_torques[set] * share
    }
}

/// Whether the ratios can come within tolerance at all: both within what the corners say.
fn in_reach(structure: Structure, wanted: Wanted, [low, high]: [f64; 2]) -> bool {
    use epicyclic_schemes::standing::reach;
    reach(structure, &(low..=high)).into_iter().zip(wanted.ratios).all(|(reach, ratio)| {
        let parts = [1.0 - wanted.tolerance - SLACK, 1.0 + wanted.tolerance + SLACK];
        let ends = parts.map(|part| part * ratio);
        let (from, to) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        let hair = SLACK * to.abs().max(from.abs());
        reach.meets(from, to, hair)
    })
}

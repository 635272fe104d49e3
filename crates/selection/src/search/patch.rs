//! One structure with one assignment of the ratios: all its pairs of ring-to-sun ratios, measured.

use super::double::Double;
use super::exact::{self, relative_step};
use super::levels::Level;
use super::window::{Planets, Wanted, window};
use crate::Mechanism;
use crate::drawing::drawable_direct_clutches;
use crate::objectives::{Costs, on_grid, on_relative_grid};
use crate::requirements::{Limits, Requirements};
use crate::tolerance::{GRID_STEP, ROUNDING, SLACK};
use epicyclic_numerics::values::largest_absolute;
use epicyclic_schemes::direct_drive::{DIRECT_CLUTCH_PAIRS, link_speeds};
use epicyclic_schemes::pair::{Coefficients, coefficients, effective, exponents, fraction, minor, ratios};
use epicyclic_schemes::structures::{Role, SetRoles, Structure};

/// A structure with an assignment of the ratios.
#[derive(Debug, Clone)]
pub(crate) struct Patch {
    pub(crate) structure: Structure,
    pub(crate) wanted: [f64; 2],
    pub(super) sets: [SetRoles; 2],
    /// Options for the direct-drive clutch; only those that can be drawn, unless that does not matter.
    pub(super) direct_clutches: Vec<[Role; 2]>,
    /// Directions of the rolling powers, by gear and set.
    exponents: [[i8; 2]; 2],
    eta0: f64,
    /// Windows of `k₂` as places of levels: place of `k₁`, first, end.
    pub(crate) strips: Vec<[u32; 3]>,
}

/// A set at one level: coefficients without losses, times the teeth of its sun, and with those of gears 1 and
/// 2.
///
/// The former are whole numbers, and so are their minors and all that speeds have above and below the line:
/// nothing is rounded but the one quotient, and ratios and speeds that are equal are equal to the bit.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Side {
    pub(super) ideal: Coefficients,
    pub(super) loaded: [Coefficients; 2],
}

/// A pair of levels measured, before sizes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Measured {
    pub(crate) efficiency: f64,
    pub(crate) speed: f64,
    pub(crate) ratio_error: f64,
    /// Largest torque on the suns over the gears.
    pub(crate) sun_torques: [f64; 2],
    /// Relative error that rounding may have added to efficiency and torques.
    doubt: f64,
}

/// A limit as a trial takes it: a value at it is within.
fn allowed(limit: f64) -> f64 {
    limit + SLACK * (1.0 + limit)
}

/// Limits as the trial takes them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Allowed {
    pub(super) ratio_error: f64,
    pub(super) link_speed: f64,
    pub(super) planet_speed: f64,
    pub(super) clutch_slip: f64,
    pub(super) circulation: f64,
    pub(super) efficiency: f64,
}

impl Allowed {
    /// Whatever there is.
    pub(super) const ANY: Self = Self {
        ratio_error: f64::INFINITY,
        link_speed: f64::INFINITY,
        planet_speed: f64::INFINITY,
        clutch_slip: f64::INFINITY,
        circulation: f64::INFINITY,
        efficiency: 0.0,
    };

    pub(crate) fn new(requirements: &Requirements) -> Self {
        let limits = &requirements.limits;
        Self {
            ratio_error: allowed(requirements.tolerance),
            link_speed: allowed(limits.link_speed),
            planet_speed: allowed(limits.planet_speed),
            clutch_slip: allowed(limits.clutch_slip),
            circulation: allowed(limits.circulation),
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
        if !Mechanism::TwoSets(structure).reaches(&ratio, requirements.tolerance, [first.k, last.k]) {
            return None;
        }
        let direct_clutches = if limits.drawable {
            drawable_direct_clutches(Mechanism::TwoSets(structure)).ok()?
        } else {
            DIRECT_CLUTCH_PAIRS.to_vec()
        };
        // Excess of r over (k − 1)/2: 0 without offsets of the ring.
        let above = |level: &Level| {
            let [sun, ring] = level.teeth;
            (2.0 * level.planet - (ring - sun)) / (2.0 * sun)
        };
        let above = levels.iter().map(above).fold(0.0, f64::max);
        let mut strips = vec![];
        for (place, level) in levels.iter().enumerate() {
            let first_set = coefficients(sets[0], level.k);
            let range = [first.k, last.k];
            let planets = Planets { first: level.planet_to_sun, above };
            let Some([from, to]) = window(sets, &first_set, planets, wanted, limits, range) else { continue };
            let from = levels.partition_point(|level| level.k < from);
            let to = levels.partition_point(|level| level.k <= to);
            if from < to {
                strips.push([place as u32, from as u32, to as u32]);
            }
        }
        // Signs of rolling powers are those of any pair whose ratios have the required signs.
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
        Side { ideal: self.ideal(set, level), loaded: [0, 1].map(loaded) }
    }

    /// Coefficients of a set without losses, times the teeth of its sun.
    fn ideal(&self, set: usize, level: &Level) -> Coefficients {
        let [sun, ring] = level.teeth;
        let mut found = [0.0; 4];
        for (role, value) in self.sets[set].into_iter().zip([sun, ring, -(sun + ring)]) {
            found[role.index()] = value;
        }
        found
    }

    /// Set 1 at each level, and set 2. They take more memory than all else of a patch, so they are kept while
    /// it is tried and no longer.
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
        // Link speeds times the numerator of the ratio: D, the braked link at rest, B and the free link.
        let d_b = minor(&one.ideal, &two.ideal, D, B);
        let free = [Role::T2.index(), Role::T1.index()];
        let (mut above, mut speeds) = ([[0.0; 4]; 2], [[1.0, 0.0, 0.0, 0.0]; 2]);
        let mut links = 1.0_f64;
        for gear in 0..2 {
            let ([n, d], x) = (fractions[gear], free[gear]);
            (above[gear][D], above[gear][B], above[gear][x]) = (n, d, -d_b);
            (speeds[gear][B], speeds[gear][x]) = (d / n, -d_b / n);
            links = links.max(speeds[gear][B].abs()).max(speeds[gear][x].abs());
        }
        let mut planets = 0.0_f64;
        for (set, [a, _, h]) in self.sets.iter().enumerate() {
            // The planet's speed over that of the sun, both relative to the carrier: `1/r`.
            let level = &levels[pair[set]];
            let sun = level.teeth[0];
            let relative = |gear: usize| {
                let over = 2.0 * level.planet * fractions[gear][0];
                ((above[gear][a.index()] - above[gear][h.index()]) * (2.0 * sun) / over).abs()
            };
            planets = planets.max(relative(0)).max(relative(1));
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
        let mut cancelled = 0.0_f64;
        for gear in 0..2 {
            let (one, two) = (&one.loaded[gear], &two.loaded[gear]);
            let x = free[gear];
            let [n, d] = fraction(one, two, gear);
            let over = 1.0 / d;
            efficiency = efficiency.min(n * over / ratio[gear]);
            sun_torques[0] = sun_torques[0].max((two[x] * over).abs());
            sun_torques[1] = sun_torques[1].max((one[x] * over).abs());
            let terms = |y: usize| (one[y] * two[x]).abs() + (one[x] * two[y]).abs();
            cancelled = cancelled.max(terms(B) / n.abs() + terms(D) * over.abs());
        }
        if efficiency < allowed.efficiency {
            return None;
        }
        if allowed.circulation.is_finite()
            && [0, 1]
                .into_iter()
                .any(|gear| circulation([one, two], gear, &speeds[gear]) > allowed.circulation)
        {
            return None;
        }
        // A loaded k is rounded twice, 1 + k once more. A product of two such and a difference of products
        // make eight times the rounding of the terms. Five more operations follow.
        let doubt = ROUNDING * (9.0 * cancelled + 6.0);
        Some(Measured { efficiency, speed: links.max(planets), ratio_error, sun_torques, doubt })
    }

    /// Costs of a measured pair of levels with the shares `K_γ/N` of its sets.
    ///
    /// Each cost is on the point of its grid where the exact value belongs. For ratios and speeds this holds
    /// by construction. For efficiency and size the double decides, unless rounding may have carried it over
    /// half the way to the next point; then twice the digits decide.
    #[inline]
    pub(crate) fn costs(&self, measured: &Measured, levels: [&Level; 2], shares: [f64; 2]) -> Costs {
        let cube = measured.cube(0, levels[0], shares[0]).max(measured.cube(1, levels[1], shares[1]));
        let efficiency = on_grid(-measured.efficiency);
        let size = on_relative_grid(cube);
        let distance = on_grid(levels[0].distance.times(levels[1].distance));
        let mut costs = [efficiency, on_grid(measured.speed), distance, on_grid(measured.ratio_error), size];
        // Of `k³·(1 + 1/r)/(w²·min(1, r))`: of `r = (k − 1)/2` twice what `k − 1` loses of `k`, and the
        // operations; `r = z_g/z_a` loses less.
        let of_k = |level: &Level| level.k / (level.k - 1.0);
        let doubt = measured.doubt + ROUNDING * (16.0 + 3.0 * of_k(levels[0]).max(of_k(levels[1])));
        let half = relative_step(cube) / 2.0;
        if (efficiency + measured.efficiency).abs() + measured.doubt >= GRID_STEP / 2.0 {
            costs[0] = exact::efficiency_cost(self.exact_efficiency(levels));
        }
        if (size - cube).abs() + doubt * cube >= half {
            costs[4] = exact::size_cost(self.exact_cube(levels, shares));
        }
        costs
    }

    /// Numerator and denominator of the ratio with losses in a gear, and the coefficients of both sets at its
    /// free link. A set's coefficients are times the teeth of its sun, and times `η₀` where it divides.
    fn exact_parts(&self, levels: [&Level; 2], gear: usize) -> ([Double; 2], [Double; 2]) {
        let eta0 = self.eta0;
        let x = [Role::T2.index(), Role::T1.index()][gear];
        let loaded = [0, 1].map(|set| {
            exact::coefficients(self.sets[set], levels[set].teeth, self.exponents[gear][set], eta0)
        });
        let [one, two] = &loaded;
        let minor = |y: usize| one[y] * two[x] - one[x] * two[y];
        ([-minor(Role::B.index()), minor(Role::D.index())], [one[x], two[x]])
    }

    /// The least efficiency, to twice the digits.
    #[cold]
    fn exact_efficiency(&self, levels: [&Level; 2]) -> Double {
        let [one, two] = [0, 1].map(|set| self.ideal(set, levels[set]));
        let of = |gear: usize| {
            let ([n, d], _) = self.exact_parts(levels, gear);
            let [ideal_n, ideal_d] = fraction(&one, &two, gear).map(Double::from);
            n * ideal_d / (d * ideal_n)
        };
        of(0).min(of(1))
    }

    /// The cube of the relative ring diameter, to twice the digits.
    #[cold]
    fn exact_cube(&self, levels: [&Level; 2], shares: [f64; 2]) -> Double {
        let parts = [0, 1].map(|gear| self.exact_parts(levels, gear));
        let cube = |set: usize| {
            let sun = Double::from(levels[set].teeth[0]);
            // On the sun: its coefficient, times the other set's at the free link.
            let torque = |gear: usize| {
                let ([_, d], free) = parts[gear];
                let of_sun =
                    if self.exponents[gear][set] == -1 { sun * Double::from(self.eta0) } else { sun };
                (of_sun * free[1 - set] / d).abs()
            };
            exact::cube(levels[set].teeth, levels[set].planet, levels[set].working, torque(0).max(torque(1)))
                * Double::from(shares[set])
        };
        cube(0).max(cube(1))
    }

    #[cold]
    fn another_direct_clutch_fits(&self, ratio: [f64; 2], allowed: &Allowed) -> bool {
        let speeds = link_speeds(ratio);
        let u = epicyclic_schemes::structures::motion(ratio);
        self.direct_clutches.iter().any(|pair| {
            let [x, y] = pair.map(Role::index);
            let slip = largest_absolute(speeds.iter().map(|speed| speed[x] - speed[y]));
            ((u[0] - u[1]) / (u[x] - u[y])).is_finite() && slip <= allowed.clutch_slip
        })
    }
}

impl Measured {
    /// Cube of the relative ring diameter of a set.
    #[inline]
    pub(crate) fn cube(&self, set: usize, level: &Level, share: f64) -> f64 {
        level.cube * self.sun_torques[set] * share
    }
}

/// Circulating power of a gear between two sets, with losses, over the power that enters.
///
/// Each set gives or takes power at each link. The power that one gives and the other takes at a link can
/// circulate if as much returns at other links; two sets have no other loop. By the definition
/// ([`epicyclic_train::power_flow`]), the circulating power is the largest that passes the link with the
/// most.
fn circulation([one, two]: [&Side; 2], gear: usize, speeds: &Coefficients) -> f64 {
    let x = [Role::T2.index(), Role::T1.index()][gear];
    let (one, two) = (&one.loaded[gear], &two.loaded[gear]);
    let [_, d] = fraction(one, two, gear);
    // Power that enters set 1 and set 2 at each link, where 1 enters the gear at D.
    let enters =
        |role: usize| [one[role] * two[x], -two[role] * one[x]].map(|torque| torque / d * speeds[role]);
    let passes = |role: usize, from: usize| {
        let at = enters(role);
        f64::min(-at[from], at[1 - from]).max(0.0)
    };
    let forth = [0, 1, 2, 3].map(|role| passes(role, 0));
    let back = [0, 1, 2, 3].map(|role| passes(role, 1));
    let most = |of: &[f64; 4], other: &[f64; 4]| {
        let sum: f64 = other.iter().sum();
        of.iter().fold(0.0_f64, |most, one| most.max(one.min(sum)))
    };
    most(&forth, &back).max(most(&back, &forth))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::search::ToothSearch;
    use epicyclic_gears::synthesis::Bounds;
    use epicyclic_schemes::RatioSeries;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(8))]

        #[test]
        fn circulating_power_is_that_of_the_solver(
            q in 1.05..2.5_f64,
            step in 1.05..3.0_f64,
            pair in any::<prop::sample::Index>(),
        ) {
            let mut requirements = Requirements::new(RatioSeries::of_braked_gears(&[q, q * step]).unwrap());
            requirements.limits.drawable = false;
            let mut search = ToothSearch::new(requirements.clone());
            search.bounds = Bounds { ring: 12..=70, ..Bounds::default() };
            let found = search.prepared(&|_| std::ops::ControlFlow::Continue(())).unwrap();
            for patch in &found.patches {
                let strip = patch.strips[pair.index(patch.strips.len())];
                let places = [strip[0], strip[1] + (strip[2] - strip[1]) / 2].map(|place| place as usize);
                let levels = places.map(|place| &found.levels[place]);
                let sides = [0, 1].map(|set| patch.side(set, levels[set]));
                let k = levels.map(|level| level.k);
                let gearbox = patch.structure.gearbox(k, requirements.eta0, [Role::D, Role::B]).unwrap();
                for (gear, name) in ["1", "2"].into_iter().enumerate() {
                    let analysis = gearbox.analyze(name).unwrap();
                    let Some(case) = analysis.driving() else { continue };
                    let mut speeds = [0.0; 4];
                    for role in Role::ALL {
                        let link = gearbox.link(role.symbol()).unwrap();
                        speeds[role.index()] = analysis.speed(link).unwrap();
                    }
                    let found = circulation([&sides[0], &sides[1]], gear, &speeds);
                    let largest = case.power.largest;
                    prop_assert!(
                        (found - case.power.circulating).abs() < 1e-9 * largest * largest,
                        "{} k {k:?} gear {name}: {found}, by the solver {}", patch.structure, case.power.circulating
                    );
                }
            }
        }
    }
}
